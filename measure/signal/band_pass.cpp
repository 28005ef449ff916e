#include "measure/signal/band_pass.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// Hz in which the response falls from one to nothing beside the band. Narrower costs samples at the record's ends;
// wider lets neighbours in; at zero there must be nothing left of a band that begins above it.
double fall_of(const Band& band) {
  const double width = band.high_hz - band.low_hz;
  return band.low_hz > 0 ? std::min(width, band.low_hz) : width;
}

VectorXd impulse_response(const Band& band, double sample_rate_hz) {
  const Index half = band_pass_reach(band, sample_rate_hz);
  const double low = 2 * (band.low_hz > 0 ? band.low_hz - 0.5 * fall_of(band) : 0) / sample_rate_hz;
  const double high = std::min(1.0, 2 * (band.high_hz + 0.5 * fall_of(band)) / sample_rate_hz);
  VectorXd response(2 * half + 1);
  for (Index n = -half; n <= half; ++n) {
    const double angle = std::numbers::pi * static_cast<double>(n), turn = angle / static_cast<double>(half + 1);
    const double blackman = 0.42 + 0.5 * std::cos(turn) + 0.08 * std::cos(2 * turn);
    response(n + half) =
        blackman * (n == 0 ? high - low : (std::sin(high * angle) - std::sin(low * angle)) / angle);
  }
  return response;
}

}  // namespace

Index band_pass_reach(const Band& band, double sample_rate_hz) {
  // The main lobe of Blackman's window of N samples is 6/N of the sample rate wide; N is twice the reach.
  return static_cast<Index>(std::ceil(3 * sample_rate_hz / fall_of(band)));
}

MatrixXd band_pass(const MatrixXd& samples, double sample_rate_hz, const Band& band) {
  const Index half = band_pass_reach(band, sample_rate_hz), length = samples.rows() - 2 * half;
  if (length <= 0) return MatrixXd(0, samples.cols());
  const VectorXd response = impulse_response(band, sample_rate_hz);
  MatrixXd passed(length, samples.cols());
  for (Index c = 0; c < samples.cols(); ++c)
    for (Index i = 0; i < length; ++i) passed(i, c) = response.dot(samples.col(c).segment(i, 2 * half + 1));
  return passed;
}

double band_share_of_noise(const Band& band, double sample_rate_hz) {
  return impulse_response(band, sample_rate_hz).squaredNorm();
}

}  // namespace secular
