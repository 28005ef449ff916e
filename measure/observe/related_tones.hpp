#pragma once

#include <Eigen/Core>

#include "numerics/solver_ending.hpp"

namespace secular {

/// Tones whose frequencies are related: frequency of tone j = fixed(j) + (coupling*u)(j), rad/s.
struct RelatedTones {
  Eigen::VectorXd fixed;
  Eigen::MatrixXd coupling;  ///< tones x free frequencies; no columns: all frequencies are known
  int varying = 0;           ///< the first so many tones may grow and turn slowly
  int degree = 2;            ///< of their amplitudes as polynomials of time, at least 2
};

struct RelatedToneFit {
  SolverEnding ending = SolverEnding::converged;  ///< converged where all frequencies are known
  Eigen::VectorXd free, free_sd;                  ///< u
  Eigen::MatrixXcd amplitude;                   ///< [tone][channel], half of the peak, phase at the window's centre
  Eigen::MatrixXcd slope, curvature;            ///< [varying tone][channel]: d/dt and d2/dt2 of it at the centre
  Eigen::MatrixXd amplitude_sd;                 ///< of real and imaginary part alike
  Eigen::VectorXd offset, offset_sd, noise_sd;  ///< [channel]
};

/// Maximum likelihood in white Gaussian noise of a level per channel (samples x channels): variable projection,
/// Gauss-Newton in u from `start`, which should be within a bin of the window. Sample i is at (i - (N-1)/2)/rate.
/// Throws std::invalid_argument for fewer samples than unknowns.
RelatedToneFit fit_related_tones(const Eigen::Ref<const Eigen::MatrixXd>& channels, double sample_rate_hz,
                                 const RelatedTones& tones, const Eigen::VectorXd& start);

/// Power that tones at the given frequencies (rad/s), one a channel, have over that channel's variance, summed.
double tone_power(const Eigen::Ref<const Eigen::MatrixXd>& channels, double sample_rate_hz,
                  const Eigen::VectorXd& frequencies);

}  // namespace secular
