#include "measure/signal/tone_search.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "measure/signal/transform_length.hpp"
#include "numerics/distribution.hpp"
#include "numerics/fourier_transform.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Of the highest ordinate over frequency, see the header.
double peak_probability(double ordinate, Index channels, Index samples) {
  const auto c = static_cast<double>(channels);
  const double width = 0.5 * static_cast<double>(samples) * std::sqrt(std::numbers::pi / 3);
  const double crossings =
      width * std::exp((c - 0.5) * std::log(std::max(ordinate, 1e-300)) - ordinate - std::lgamma(c));
  return -std::expm1(-(crossings + gamma_upper_tail(ordinate, c, 1)));
}

}  // namespace

SpectralPeak spectral_peak(const Eigen::Ref<const MatrixXd>& residual, double sample_rate_hz, int padding,
                           double unknowns) {
  const Index samples = residual.rows(), length = padded_transform_length(samples * padding);
  const Index bin_lines = (length + samples - 1) / samples;
  const Index low = bin_lines, high = (length + 1) / 2 - bin_lines;  // one bin from zero and from Nyquist
  SpectralPeak peak;
  if (high <= low) return peak;
  Eigen::VectorXcd padded = Eigen::VectorXcd::Zero(length);
  const double freedom = std::max(4.0, static_cast<double>(samples) - unknowns);
  // Share of the energy in one frequency: a beta law, hence the logarithm of the rest is exponential. The logarithm
  // of the product over channels is their sum. Two channels, each in units of its noise, share a transform as real
  // and imaginary part: X and Y are (Z_k + conj Z_-k)/2 and (Z_k - conj Z_-k)/2i.
  Eigen::ArrayXd rest = Eigen::ArrayXd::Ones(high - low);
  const auto scaled = [&](Index c) -> VectorXd {
    const double energy = c < residual.cols() ? residual.col(c).squaredNorm() : 0;
    if (!(energy > 0)) return VectorXd::Zero(samples);
    return std::sqrt(0.5 / (static_cast<double>(samples) * energy)) * residual.col(c);
  };
  for (Index c = 0; c < residual.cols(); c += 2) {
    padded.head(samples).real() = scaled(c);
    padded.head(samples).imag() = scaled(c + 1);
    const Eigen::VectorXcd spectrum = whole_spectrum(padded);
    for (Index k = low; k < high; ++k) {
      const std::complex<double> z = spectrum(k), mirrored = std::conj(spectrum(length - k));
      rest(k - low) *= std::max(1 - std::norm(z + mirrored), 1e-15) * std::max(1 - std::norm(z - mirrored), 1e-15);
    }
  }
  const auto ordinate = [&](Index k) { return -(0.5 * freedom - 1) * std::log(rest(k)); };
  Index at = 0;
  rest.minCoeff(&at);
  peak.ordinate = ordinate(at);
  double offset = 0;
  if (at > 0 && at + 1 < rest.size()) {
    const double before = ordinate(at - 1), here = peak.ordinate, after = ordinate(at + 1);
    const double bend = before - 2 * here + after;
    if (bend < 0) offset = std::clamp(0.5 * (before - after) / bend, -0.5, 0.5);
    peak.ordinate -= 0.25 * (before - after) * offset;
  }
  const double bin = two_pi * sample_rate_hz / static_cast<double>(length);
  peak.frequency = bin * (static_cast<double>(at + low) + offset);
  peak.probability = peak_probability(peak.ordinate, residual.cols(), samples);
  return peak;
}

ToneSearch search_tones(const Eigen::Ref<const MatrixXd>& channels, double sample_rate_hz,
                        const ToneSearchOptions& options) {
  ToneSearch search;
  std::vector<Pole> poles = options.beside;
  search.fit = refine_poles(channels, sample_rate_hz, poles);
  for (;;) {
    const double unknowns = static_cast<double>(function_count(poles)) +
                            static_cast<double>(parameter_count(poles)) / static_cast<double>(channels.cols());
    const SpectralPeak peak = spectral_peak(search.fit.residual, sample_rate_hz, 4, unknowns);
    search.probability.push_back(peak.probability);
    if (search.tones >= options.max_tones || peak.probability > options.false_alarm) break;
    if (static_cast<Index>(unknowns) + 4 + channels.cols() >= channels.rows()) break;
    Pole pole;
    pole.frequency = peak.frequency;
    poles.push_back(pole);
    RefinedPoles next = refine_poles(channels, sample_rate_hz, poles);
    if (!(next.cost < search.fit.cost)) break;
    search.fit = std::move(next);
    poles = search.fit.poles;
    ++search.tones;
  }
  return search;
}

}  // namespace secular
