#include "measure/signal/principal_components.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <stdexcept>

#include "numerics/distribution.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Upper tail of the Tracy-Widom law of order one through its shifted gamma approximation (Chiani 2014).
double tracy_widom_tail(double x) {
  return gamma_upper_tail(x + 9.84801, 46.446, 0.186054);
}

// Probability that white noise of unit variance, rows x columns, has a squared singular value as large.
double largest_noise_tail(double squared, double rows, double columns) {
  const double a = std::sqrt(rows - 0.5), b = std::sqrt(columns - 0.5);
  const double centre = (a + b) * (a + b), width = (a + b) * std::cbrt(1 / a + 1 / b);
  return tracy_widom_tail((squared - centre) / width);
}

}  // namespace

SpatialComponents spatial_components(const Eigen::Ref<const MatrixXd>& channels) {
  if (channels.rows() < channels.cols() || !channels.allFinite())
    throw std::invalid_argument("principal components need finite samples, at least one for every channel");
  const Eigen::BDCSVD<MatrixXd> svd(channels, Eigen::ComputeThinV);
  return {svd.singularValues(), svd.matrixV()};
}

VectorXd temporal_singular_values(const Eigen::Ref<const MatrixXd>& channels, int delays) {
  const Index rows = channels.rows() - delays + 1, count = channels.cols();
  if (delays < 1 || rows < delays * count)
    throw std::invalid_argument("too few samples for the delays of a block Hankel matrix");
  MatrixXd hankel(rows, delays * count);
  for (Index k = 0; k < delays; ++k) hankel.middleCols(k * count, count) = channels.middleRows(k, rows);
  return hankel.bdcSvd().singularValues();
}

SpatialCount count_spatial_functions(const Eigen::Ref<const MatrixXd>& channels,
                                     const Eigen::Ref<const VectorXd>& noise_sd, double false_alarm) {
  if (noise_sd.size() != channels.cols() || !(noise_sd.minCoeff() > 0))
    throw std::invalid_argument("a positive noise level for every channel is needed");
  const VectorXd values =
      spatial_components(channels * noise_sd.cwiseInverse().asDiagonal()).singular_values.array().square();
  SpatialCount count;
  for (Index m = 0; m < values.size(); ++m) {
    count.functions = static_cast<int>(m);
    count.probability.push_back(largest_noise_tail(values(m), static_cast<double>(channels.rows() - m),
                                                   static_cast<double>(values.size() - m)));
    if (count.probability.back() > false_alarm) return count;
  }
  count.functions = static_cast<int>(values.size());
  count.limited = true;
  return count;
}

SpatialCount count_spatial_functions(const Eigen::Ref<const MatrixXd>& channels, double false_alarm) {
  const auto n = static_cast<double>(channels.rows());
  const VectorXd values = spatial_components(channels).singular_values.array().square() / n;
  SpatialCount count;
  for (Index m = 0; m + 1 < values.size(); ++m) {
    count.functions = static_cast<int>(m);
    const auto q = static_cast<double>(values.size() - m);
    const Eigen::ArrayXd rest = values.tail(values.size() - m).array().max(1e-300);
    const double mean = rest.mean();
    // Lawley's correction brings the mean of the statistic to that of the chi-square law.
    double factor = n - static_cast<double>(m) - (2 * q * q + q + 2) / (6 * q);
    for (Index i = 0; i < m; ++i) factor += mean * mean / std::pow(values(i) - mean, 2);
    const double statistic = factor * (q * std::log(mean) - rest.log().sum());
    const double freedom = 0.5 * (q + 2) * (q - 1);
    count.probability.push_back(chi_squared_upper_tail(statistic, freedom));
    if (count.probability.back() > false_alarm) return count;
  }
  count.functions = static_cast<int>(values.size()) - 1;
  count.limited = true;
  return count;
}

}  // namespace secular
