#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "measure/signal/pole.hpp"
#include "measure/signal/pole_covariance.hpp"
#include "numerics/solver_ending.hpp"

namespace secular {

/// Maximum-likelihood poles and amplitudes. Origin of time: the centre of the window, where the estimates of
/// frequency and phase are least correlated.
struct RefinedPoles {
  /// Ran away: the poles cannot be told apart.
  SolverEnding ending = SolverEnding::ran_away;
  int iterations = 0;
  std::vector<Pole> poles;
  Eigen::MatrixXd amplitudes;  ///< [function][channel]
  Eigen::MatrixXd residual;    ///< samples x channels
  Eigen::VectorXd noise_sd;    ///< [channel], corrected for the unknowns
  double cost = 0;             ///< sum over channels of the log of the residual variance

  PoleCovariance covariance;  ///< of pole parameters and amplitudes
};

/// Maximum likelihood in white Gaussian noise of an unknown level per channel, the poles shared by all channels
/// (samples x channels): variable projection, Gauss-Newton with Levenberg steps from `start`; circular poles go the
/// first steps on a series (follow_series). All derivatives of
/// Eq. (4.3) are time times rotated functions, so the normal equations come from three moment matrices common to
/// all channels. Throws std::invalid_argument for fewer samples than unknowns.
RefinedPoles refine_poles(const Eigen::Ref<const Eigen::MatrixXd>& channels, double sample_rate_hz,
                          std::span<const Pole> start, int iteration_limit = 40);

}  // namespace secular
