#pragma once

#include <Eigen/Core>
#include <span>

#include "measure/signal/pole.hpp"
#include "measure/signal/pole_equations.hpp"

namespace secular {

/// Covariance of pole parameters and of the amplitudes of every channel, in factors: an error of the poles drags
/// the amplitudes along, amplitude error = -drag * pole error + own error.
struct PoleCovariance {
  bool determined = false;   ///< otherwise the samples do not tell, and all is infinite
  Eigen::MatrixXd poles;     ///< of the unknowns of the poles
  Eigen::MatrixXd drag;      ///< (amplitudes of channel 0, of channel 1, ...) x unknowns
  Eigen::MatrixXd own;       ///< (G^T G)^-1: of one channel's amplitudes, per variance of its noise
  Eigen::VectorXd variance;  ///< [channel]
  Eigen::Index unknowns = 0, functions = 0;

  /// Of poles and amplitudes [function][channel] at the centre of a window of this half length (s).
  PoleCovariance(std::span<const Pole> of, const PoleMoments& m, const Eigen::MatrixXd& amplitudes,
                 const Eigen::VectorXd& noise_variance, double half);
  PoleCovariance() = default;

  /// Moves the origin of time by `shift` seconds; `amplitudes` are those at the new origin.
  void move_origin(std::span<const Pole> of, const Eigen::MatrixXd& amplitudes, double shift);

  /// Of (pole parameters, amplitudes of channel 0, of channel 1, ...).
  Eigen::MatrixXd matrix() const;
};

}  // namespace secular
