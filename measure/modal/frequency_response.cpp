#include "measure/modal/frequency_response.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "numerics/fourier_transform.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

VectorXd force_window(Index samples, double rate, const ImpactWindows& windows) {
  VectorXd weight(samples);
  const double taper = 0.1 * windows.force_s;
  for (Index i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) / rate;
    double w = std::exp(-windows.decay * t);
    if (windows.force_s > 0 && t > windows.force_s)
      w *= t < windows.force_s + taper ? 0.5 + 0.5 * std::cos(std::numbers::pi * (t - windows.force_s) / taper) : 0;
    weight(i) = w;
  }
  return weight;
}

}  // namespace

void ImpactSpectra::add(const ImpactSpectra& other) {
  if (impacts == 0) {
    *this = other;
    return;
  }
  if (other.cross.rows() != cross.rows() || other.cross.cols() != cross.cols())
    throw std::invalid_argument("frequency_response: impacts of unequal size");
  force_power += other.force_power;
  power += other.power;
  cross += other.cross;
  impacts += other.impacts;
}

void ImpactSpectra::remove(const ImpactSpectra& other) {
  force_power -= other.force_power;
  power -= other.power;
  cross -= other.cross;
  impacts -= other.impacts;
}

ImpactSpectra impact_spectra(const ImpactBlock& impact, double sample_rate_hz, const ImpactWindows& windows) {
  const Index samples = impact.force.size(), p = impact.responses.cols(), lines = samples / 2 + 1;
  if (samples < 4 || samples % 2 != 0 || p == 0)
    throw std::invalid_argument("frequency_response: an even number of samples and a response are needed");
  if (impact.responses.rows() != samples)
    throw std::invalid_argument("frequency_response: impacts of unequal size");
  const VectorXd response_weight = force_window(samples, sample_rate_hz, {0, windows.decay});
  const VectorXcd force = half_spectrum(impact.force.cwiseProduct(force_window(samples, sample_rate_hz, windows)));
  ImpactSpectra sums{force.cwiseAbs2(), MatrixXd(lines, p), MatrixXcd(lines, p), 1};
  for (Index c = 0; c < p; ++c) {
    const VectorXcd x = half_spectrum(impact.responses.col(c).cwiseProduct(response_weight));
    sums.power.col(c) = x.cwiseAbs2();
    sums.cross.col(c) = x.cwiseProduct(force.conjugate());
  }
  return sums;
}

FrequencyResponse frequency_response(const ImpactSpectra& sums, double sample_rate_hz,
                                     const ImpactWindows& windows) {
  if (sums.impacts < 1) throw std::invalid_argument("frequency_response: no impacts");
  const VectorXd& force_power = sums.force_power;
  const MatrixXd& power = sums.power;
  const MatrixXcd& cross = sums.cross;
  const Index lines = cross.rows(), p = cross.cols(), samples = 2 * (lines - 1);
  if (!(force_power.maxCoeff() > 0)) throw std::invalid_argument("frequency_response: there is no force");
  FrequencyResponse result;
  result.impacts = sums.impacts;
  result.windows = windows;
  result.frequency_hz = VectorXd::LinSpaced(lines, 0, static_cast<double>(lines - 1)) *
                        (sample_rate_hz / static_cast<double>(samples));
  result.h1 = MatrixXcd::Zero(lines, p);
  result.h2 = MatrixXcd::Zero(lines, p);
  result.coherence = MatrixXd::Zero(lines, p);
  result.h1_sd = MatrixXd::Zero(lines, p);
  for (Index c = 0; c < p; ++c)
    for (Index i = 0; i < lines; ++i) {
      if (force_power(i) <= 0) continue;
      result.h1(i, c) = cross(i, c) / force_power(i);
      if (std::norm(cross(i, c)) <= 0 || power(i, c) <= 0) continue;
      result.h2(i, c) = power(i, c) / std::conj(cross(i, c));
      result.coherence(i, c) = std::min(1.0, std::norm(cross(i, c)) / (force_power(i) * power(i, c)));
      if (result.impacts > 1)
        result.h1_sd(i, c) = std::abs(result.h1(i, c)) * std::sqrt((1 - result.coherence(i, c)) /
                                                                   (2 * result.coherence(i, c) * result.impacts));
    }
  return result;
}

ImpactTimes find_impacts(const Eigen::Ref<const VectorXd>& force, double sample_rate_hz, double apart_s,
                         double share) {
  ImpactTimes found;
  const double threshold = force.size() > 0 ? share * force.cwiseAbs().maxCoeff() : 0;
  if (!(threshold > 0)) return found;
  const auto apart = static_cast<Index>(apart_s * sample_rate_hz);
  // A contact ends after a millisecond or five samples below the threshold.
  const Index gap = std::max<Index>(5, static_cast<Index>(1e-3 * sample_rate_hz));
  Index last = -apart - gap - 1;
  for (Index i = 0; i < force.size(); ++i) {
    if (std::abs(force(i)) < threshold) continue;
    if (found.samples.empty() || i - found.samples.back() > apart)
      found.samples.push_back(i);
    else if (i - last > gap)
      ++found.bounces;
    last = i;
  }
  return found;
}

PulseResponse pulse_response(const Eigen::Ref<const VectorXd>& frequency_hz,
                             const std::vector<MatrixXcd>& references, double highest_hz) {
  if (references.empty() || frequency_hz.size() < 4) throw std::invalid_argument("pulse_response: no lines");
  const double spacing = frequency_hz(1) - frequency_hz(0);
  Index last = std::min<Index>(frequency_hz.size() - 1, static_cast<Index>(std::lround(highest_hz / spacing)));
  last = std::max<Index>(last, 3);
  const Index samples = 2 * last, kept = last;
  PulseResponse result;
  result.sample_rate_hz = static_cast<double>(samples) * spacing;
  const Index p = references.front().cols(), q = static_cast<Index>(references.size());
  result.samples.assign(static_cast<std::size_t>(kept), MatrixXd(p, q));
  for (Index j = 0; j < q; ++j)
    for (Index c = 0; c < p; ++c) {
      VectorXcd spectrum = references[static_cast<std::size_t>(j)].col(c).head(last + 1);
      spectrum(0) = spectrum(0).real();
      spectrum(last) = spectrum(last).real();
      const VectorXd pulse = samples_of(spectrum);
      for (Index k = 0; k < kept; ++k) result.samples[static_cast<std::size_t>(k)](c, j) = pulse(k);
    }
  return result;
}

}  // namespace secular
