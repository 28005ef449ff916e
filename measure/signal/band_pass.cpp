#include "measure/signal/band_pass.hpp"

#include <cmath>
#include <numbers>

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Widths of the band's inverse that the response reaches to each side: its edges are then a quarter of the band.
constexpr double reach = 4;

}  // namespace

Index band_pass_reach(const Band& band, double sample_rate_hz) {
  return static_cast<Index>(std::ceil(reach * sample_rate_hz / (band.high_hz - band.low_hz)));
}

MatrixXd band_pass(const MatrixXd& samples, double sample_rate_hz, const Band& band) {
  const Index half = band_pass_reach(band, sample_rate_hz), length = samples.rows() - 2 * half;
  if (length <= 0) return MatrixXd(0, samples.cols());
  VectorXd response(2 * half + 1);
  for (Index n = -half; n <= half; ++n) {
    const double angle = std::numbers::pi * static_cast<double>(n);
    const double window = 0.5 * (1 + std::cos(angle / static_cast<double>(half + 1)));
    const double high = 2 * band.high_hz / sample_rate_hz, low = 2 * band.low_hz / sample_rate_hz;
    response(n + half) = window * (n == 0 ? high - low : (std::sin(high * angle) - std::sin(low * angle)) / angle);
  }
  MatrixXd passed(length, samples.cols());
  for (Index c = 0; c < samples.cols(); ++c)
    for (Index i = 0; i < length; ++i) passed(i, c) = response.dot(samples.col(c).segment(i, 2 * half + 1));
  return passed;
}

}  // namespace secular
