#include "measure/modal/amplitude_dependence.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "measure/modal/mode_scaling.hpp"
#include "measure/modal/pole.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;
using Eigen::VectorXd;

using Used = std::vector<const ModeWindow*>;

// Covariances of windows in a row, `alone` of each with itself and `with` of two that overlap, times `factor`.
Banded covariances(const Used& used, double (*alone)(const ModeWindow&), double SharedSamples::*with,
                   double factor) {
  Banded result;
  for (std::size_t i = 0; i < used.size(); ++i) {
    std::vector<double> row = {factor * alone(*used[i])};
    for (std::size_t back = 1; back <= i && used[i - back]->record == used[i]->record; ++back) {
      const auto found = std::find_if(used[i]->shared.begin(), used[i]->shared.end(),
                                      [&](const SharedSamples& s) { return s.place == used[i - back]->place; });
      if (found == used[i]->shared.end()) break;
      row.push_back(factor * (*found).*with);
    }
    result.push_back(std::move(row));
  }
  return result;
}

// Of what double precision makes of a pole, the square.
double rounding(const ModeWindow& window) {
  return 1e-28 * std::norm(window.pole);
}

double growth_variance(const ModeWindow& window) {
  return window.growth_sd * window.growth_sd + rounding(window);
}

double omega_variance(const ModeWindow& window) {
  return window.omega_sd * window.omega_sd + rounding(window);
}

double unit_variance(const ModeWindow&) {
  return 1;
}

}  // namespace

AmplitudeDependence amplitude_dependence(const std::vector<ModeWindow>& windows, Index mode,
                                         double largest_amplitude) {
  Used used;
  for (const ModeWindow& w : windows)
    if (w.mode == mode && (largest_amplitude <= 0 || w.amplitude <= largest_amplitude)) used.push_back(&w);
  AmplitudeDependence result;
  result.windows = used.size();
  if (used.size() < 3) return result;
  const auto n = static_cast<Index>(used.size());
  VectorXd amplitude(n), frequency(n), damping(n);
  std::vector<int> cluster;
  for (Index i = 0; i < n; ++i) {
    const ModeWindow& w = *used[static_cast<std::size_t>(i)];
    amplitude(i) = w.amplitude;
    frequency(i) = w.pole.imag() * to_hz;
    damping(i) = w.pole.real() * to_hz;
    cluster.push_back(static_cast<int>(w.record));
  }
  result.smallest_amplitude = amplitude.minCoeff();
  result.largest_amplitude = amplitude.maxCoeff();
  const Banded excess = covariances(used, unit_variance, &SharedSamples::share, 1);
  const Banded of_omega = covariances(used, omega_variance, &SharedSamples::omega, to_hz * to_hz),
               of_growth = covariances(used, growth_variance, &SharedSamples::growth, to_hz * to_hz);
  result.frequency_hz = straight_line(amplitude, frequency, of_omega, excess, cluster);
  result.damping_factor_hz = straight_line(amplitude, damping, of_growth, excess, cluster);
  // A resonance moves with amplitude by about its half bandwidth, both ways.
  const double half_bandwidth_hz = damping.cwiseAbs().mean();
  result.frequency_law = amplitude_law(amplitude, frequency, of_omega, excess, cluster, half_bandwidth_hz);
  result.damping_law = amplitude_law(amplitude, damping, of_growth, excess, cluster, half_bandwidth_hz);
  const std::complex<double> pole(result.damping_law.at(0), result.frequency_law.at(0));
  const double modulus = std::abs(pole), real_sd = result.damping_law.intercept_sd,
               imaginary_sd = result.frequency_law.intercept_sd;
  result.natural_frequency_hz = natural_frequency(pole);
  result.damping_ratio = damping_ratio(pole);
  result.natural_frequency_sd_hz = std::hypot(pole.real() * real_sd, pole.imag() * imaginary_sd) / modulus;
  result.damping_ratio_sd = std::abs(pole.imag()) / (modulus * modulus * modulus) *
                            std::hypot(pole.imag() * real_sd, pole.real() * imaginary_sd);
  result.degrees_of_freedom =
      std::min(result.frequency_law.degrees_of_freedom, result.damping_law.degrees_of_freedom);
  return result;
}

MeanShape mean_shape(const std::vector<VectorXcd>& shapes) {
  MeanShape result;
  result.windows = shapes.size();
  if (shapes.empty()) return result;
  std::vector<VectorXcd> turned;
  for (const VectorXcd& shape : shapes) {
    // Eq. (2.2) leaves the sign alone: the nearer of the two.
    const double same = shape.dot(shapes.front()).real();
    turned.push_back(same < 0 ? VectorXcd(-shape) : shape);
  }
  const auto n = static_cast<double>(turned.size());
  result.mean = VectorXcd::Zero(shapes.front().size());
  for (const VectorXcd& shape : turned) result.mean += shape / n;
  result.real_sd = result.imaginary_sd = VectorXd::Zero(result.mean.size());
  if (turned.size() < 2) return result;
  for (const VectorXcd& shape : turned) {
    result.real_sd += (shape - result.mean).real().cwiseAbs2() / (n - 1);
    result.imaginary_sd += (shape - result.mean).imag().cwiseAbs2() / (n - 1);
  }
  result.real_sd = result.real_sd.cwiseSqrt().eval();
  result.imaginary_sd = result.imaginary_sd.cwiseSqrt().eval();
  return result;
}

MeanShape mean_shape(const std::vector<ModeWindow>& windows, Index mode) {
  std::vector<VectorXcd> shapes;
  for (const ModeWindow& w : windows)
    if (w.mode == mode) shapes.push_back(w.shape);
  return mean_shape(shapes);
}

}  // namespace secular
