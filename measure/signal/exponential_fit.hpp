#pragma once

#include <Eigen/Core>

namespace secular {

/// Highest ordinate of the discrete Fourier transform of one channel (boxcar, no padding) within one bin around
/// `near` (rad/s), as p cos + q sin with t = 0 at the first sample.
struct SpectrumPeak {
  double frequency = 0;  ///< rad/s, centre of a bin
  double p = 0, q = 0;
};
SpectrumPeak spectrum_peak(const Eigen::Ref<const Eigen::VectorXd>& samples, double sample_rate_hz, double near);

}  // namespace secular
