#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

namespace secular {

/// Samples (rows x signals, `channels` signals a record) in white noise of one level, with one motion among
/// constant ones whose frequency and damping may depend on its amplitude.
struct MotionBeside {
  Eigen::MatrixXd samples;
  Eigen::Index channels = 0;
  double sample_rate_hz = 0;
  Eigen::VectorXcd others;         ///< poles of the constant motions, rad/s
  std::complex<double> pole;       ///< of the one, as if it were constant, rad/s
  std::vector<double> amplitudes;  ///< of the one, by record at its first row, of a unit that records share
};

/// Eq. (M9): the sum of squares that is left where the motion has a law of amplitude of this degree; amplitudes of
/// all motions are free in each signal, and so is a constant. `constant`: what a constant one leaves.
double squares_left_by_law(const MotionBeside& motion, int degree, double constant);

}  // namespace secular
