#pragma once

#include <Eigen/Core>
#include <vector>

#include "measure/modal/mode_windows.hpp"
#include "measure/modal/straight_line.hpp"

namespace secular {

/// Table 2.4 for one mode, with error bars: damped natural frequency and damping factor (both in Hz: parts of the
/// pole over 2 pi) against mean modal amplitude, and what they are at zero amplitude.
struct AmplitudeDependence {
  std::size_t windows = 0;
  double smallest_amplitude = 0, largest_amplitude = 0;
  StraightLine frequency_hz, damping_factor_hz;
  AmplitudeLaw frequency_law, damping_law;  ///< of the same two, Hz; values at zero amplitude are theirs
  double natural_frequency_hz = 0, natural_frequency_sd_hz = 0;  ///< at zero amplitude, Eq. (2.8)
  double damping_ratio = 0, damping_ratio_sd = 0;                ///< at zero amplitude, Eq. (2.8)
  double degrees_of_freedom = 0;                                 ///< of these two, for Student's t
};

/// Regression over the windows of `mode`, each as far as its noise lets it speak, and windows that overlap only
/// once for what they share. What scatters beyond noise counts as the motion's own, which windows share as they
/// share time. Windows above `largest_amplitude` are left out (zero: none). Fewer than three windows give an empty
/// result (windows below three).
AmplitudeDependence amplitude_dependence(const std::vector<ModeWindow>& windows, Eigen::Index mode,
                                         double largest_amplitude = 0);

/// Table 2.5 for one mode: mean and standard deviation of the shapes of its windows, real and imaginary parts
/// apart.
struct MeanShape {
  Eigen::VectorXcd mean;
  Eigen::VectorXd real_sd, imaginary_sd;  ///< scatter of one window, not of the mean; zero for a single one
  std::size_t windows = 0;
};
MeanShape mean_shape(const std::vector<ModeWindow>& windows, Eigen::Index mode);
/// The same over given shapes scaled by Eq. (2.2); of the two signs each takes the one nearer to the first shape.
MeanShape mean_shape(const std::vector<Eigen::VectorXcd>& shapes);

}  // namespace secular
