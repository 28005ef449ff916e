#include "measure/modal/amplitude_dependence.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "estimator/regression/linear_fit.hpp"
#include "measure/modal/mode_scaling.hpp"
#include "measure/modal/pole.hpp"
#include "numerics/confidence.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

// Powers of x up to `degree`, x in units of its largest value.
MatrixXd powers(const VectorXd& x, double unit, Index degree) {
  MatrixXd design = MatrixXd::Ones(x.size(), degree + 1);
  for (Index k = 1; k <= degree; ++k) design.col(k) = design.col(k - 1).cwiseProduct(x) / unit;
  return design;
}

}  // namespace

StraightLine straight_line(const Eigen::Ref<const VectorXd>& x, const Eigen::Ref<const VectorXd>& y,
                           std::span<const int> cluster, double independent) {
  if (x.size() != y.size() || x.size() < 3) throw std::invalid_argument("straight_line: fewer than three points");
  const double unit = std::max(x.cwiseAbs().maxCoeff(), 1e-300);
  const LinearFit fit = linear_fit(powers(x, unit, 1), y, cluster);
  StraightLine line;
  line.clustered = fit.covariance_kind == CovarianceKind::clustered;
  const double inflation = line.clustered ? 1 : 1 / std::sqrt(independent);
  line.intercept = fit.coefficients(0);
  line.slope = fit.coefficients(1) / unit;
  line.intercept_sd = std::sqrt(fit.covariance(0, 0)) * inflation;
  line.slope_sd = std::sqrt(fit.covariance(1, 1)) / unit * inflation;
  line.scatter = std::sqrt(fit.residual.squaredNorm() / static_cast<double>(x.size() - 2));
  line.degrees_of_freedom = fit.degrees_of_freedom * (line.clustered ? 1 : independent);
  if (x.size() >= 6) {
    const LinearFit curved = linear_fit(powers(x, unit, 2), y, cluster);
    const bool by_cluster = curved.covariance_kind == CovarianceKind::clustered;
    const double sd = std::sqrt(curved.covariance(2, 2)) * (by_cluster ? 1 : 1 / std::sqrt(independent));
    if (sd > 0)
      line.curvature_p = two_sided_p_value(
          curved.coefficients(2) / sd, std::max(1.0, curved.degrees_of_freedom * (by_cluster ? 1 : independent)));
  }
  return line;
}

AmplitudeDependence amplitude_dependence(const std::vector<ModeWindow>& windows, Index mode, double overlap,
                                         double largest_amplitude) {
  std::vector<const ModeWindow*> used;
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
  result.frequency_hz = straight_line(amplitude, frequency, cluster, 1 - overlap);
  result.damping_factor_hz = straight_line(amplitude, damping, cluster, 1 - overlap);
  const std::complex<double> pole(result.damping_factor_hz.intercept, result.frequency_hz.intercept);
  const double modulus = std::abs(pole), real_sd = result.damping_factor_hz.intercept_sd,
               imaginary_sd = result.frequency_hz.intercept_sd;
  result.natural_frequency_hz = natural_frequency(pole);
  result.damping_ratio = damping_ratio(pole);
  result.natural_frequency_sd_hz = std::hypot(pole.real() * real_sd, pole.imag() * imaginary_sd) / modulus;
  result.damping_ratio_sd = std::abs(pole.imag()) / (modulus * modulus * modulus) *
                            std::hypot(pole.imag() * real_sd, pole.real() * imaginary_sd);
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
