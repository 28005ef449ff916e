#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

namespace secular {

/// Samples that two windows of one mode share: what they make alike.
struct SharedSamples {
  std::size_t place = 0;         ///< of the earlier window
  double share = 0;              ///< of a window's length
  double growth = 0, omega = 0;  ///< covariances of the real parts, 1/s^2, and of the imaginary parts
};

/// What one window of a free decay says of one mode.
struct ModeWindow {
  std::size_t record = 0;
  std::size_t place = 0;      ///< which window of the record
  Eigen::Index mode = 0;      ///< index into the modes that were looked for
  double centre_s = 0;        ///< from the first sample handed over
  std::complex<double> pole;  ///< rad/s
  double growth_sd = 0;       ///< of the real part, 1/s: from the window's own noise
  double omega_sd = 0;        ///< of the imaginary part, rad/s
  double amplitude = 0;       ///< mean over the window of the mode's peak amplitude, unit of the channels: the
                              ///< shape that multiplies it has the sum of squares one, Eq. (2.2)
  Eigen::VectorXcd shape;     ///< p, scaled by Eq. (2.2)
  std::vector<SharedSamples> shared;  ///< with earlier windows, the latest first
};

struct ModeWindowOptions {
  double length_s = 0;      ///< of a window
  double overlap = 0.33;    ///< share of a window that the next one sees again, in [0, 1)
  double end_at_noise = 3;  ///< a mode is followed while some channel shows it this many times above its noise
  double search = 0.03;     ///< relative frequency within which a mode is looked for from window to window, or half
                            ///< its bandwidth where that is more
};

/// Whether a window is 8 + 4 modes samples long, or longer, and no longer than the record.
bool window_fits(Eigen::Index rows, double sample_rate_hz, Eigen::Index modes, double length_s);

/// Sliding-window analysis of a free decay (section 2.2), samples N x p: in every window an eigensystem realization
/// whose poles next to the modes looked for are refined to maximum likelihood together. A mode that sinks into the
/// noise is no longer followed, and none is that the sample rate does not show. Throws std::invalid_argument where
/// the window does not fit.
std::vector<ModeWindow> mode_windows(const Eigen::Ref<const Eigen::MatrixXd>& samples, double sample_rate_hz,
                                     const std::vector<std::complex<double>>& poles,
                                     const ModeWindowOptions& options);

}  // namespace secular
