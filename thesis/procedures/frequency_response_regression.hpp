#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimator/regression/linear_fit.hpp"

namespace secular {

/// Ensembles of a frequency response near a principal parametric resonance, and the damping found before.
struct FrequencyResponseData {
  Eigen::VectorXd amplitude, forcing;    ///< peak
  Eigen::VectorXd excitation_frequency;  ///< rad/s
  /// cos(gamma), gamma = arg F - 2 arg B: its sign tells on which side of the peak a point lies. Empty: every point
  /// is taken as Eq. (5.39) prints it.
  Eigen::VectorXd cos_gamma;
  std::vector<int> condition;
  double omega0 = 0;
  double linear = 0, quadratic = 0, cubic = 0;  ///< mu1, mu2, mu3 over |eta_e|
};

struct FrequencyResponseFit {
  double stiffness = 0;      ///< alpha_e
  double excitation = 0;     ///< eta_e; its sign means something only with cos_gamma
  LinearFit fit;             ///< of (alpha_e, eta_e), clustered by condition
  std::size_t left_out = 0;  ///< points where the damping found before needs more force than there was
};

/// Thesis Eqs. (5.39), (5.40): with Ft^2 = F^2 - (w0 mu1/|eta_e| + ...)^2,
///   a^2 alpha_e - s Ft eta_e = w0 sigma/2,   sigma = Omega - 2 w0.
/// As printed s = 1 for every point; by (5.24) s = sign(cos gamma), which is -1 on the upper branch of a softening
/// mode down to its peak and +1 from there to the saddle-node. ((5.39) also prints mu3 without its /|eta_e|.)
/// Throws std::invalid_argument for sizes that differ, NumericalFailure for fewer than three usable points.
FrequencyResponseFit frequency_response_regression(const FrequencyResponseData& data);

}  // namespace secular
