#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "measure/modal/mode_windows.hpp"

namespace secular {

/// A straight line through points and how well it is known.
struct StraightLine {
  double intercept = 0, slope = 0;
  double intercept_sd = 0, slope_sd = 0;
  double scatter = 0;             ///< standard deviation about the line
  double degrees_of_freedom = 0;  ///< of the standard deviations, for Student's t
  bool clustered = false;         ///< standard deviations from the scatter between records
  double curvature_p = 1;         ///< probability of so large a quadratic term were the line true; 1: not tested
};

/// Least squares. `cluster` labels the points of one record. With four clusters or more the standard deviations are
/// jackknifed over them; otherwise they come from the scatter, whose variance is divided by `independent`, the
/// share of a window that is no other window's too (1 - overlap). Throws std::invalid_argument for fewer than three
/// points.
StraightLine straight_line(const Eigen::Ref<const Eigen::VectorXd>& x, const Eigen::Ref<const Eigen::VectorXd>& y,
                           std::span<const int> cluster, double independent = 1);

/// Table 2.4 for one mode, with error bars: damped natural frequency and damping factor (both in Hz: parts of the
/// pole over 2 pi) against mean modal amplitude, and what they are at zero amplitude.
struct AmplitudeDependence {
  std::size_t windows = 0;
  double smallest_amplitude = 0, largest_amplitude = 0;
  StraightLine frequency_hz, damping_factor_hz;
  double natural_frequency_hz = 0, natural_frequency_sd_hz = 0;  ///< at zero amplitude, Eq. (2.8)
  double damping_ratio = 0, damping_ratio_sd = 0;                ///< at zero amplitude, Eq. (2.8)
};

/// Regression over the windows of `mode`, those above `largest_amplitude` left out (zero: none). Fewer than three
/// windows give an empty result (windows below three).
AmplitudeDependence amplitude_dependence(const std::vector<ModeWindow>& windows, Eigen::Index mode, double overlap,
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
