#pragma once

#include <Eigen/Core>
#include <vector>

#include "motion/balance/torus.hpp"

namespace secular {

/// A place on a closed turn where the velocity of a coordinate passes through zero, and with it whatever jumps with
/// its sign.
struct Turning {
  Eigen::Index mode = 0;
  double seen = 0;  ///< phase where the torus's lines have no velocity
  double phase =
      0;  ///< and where the motion has none, with the lines beyond the torus that jumps make (see settle)
  double slope = 0;  ///< of the velocity by the phase
};

/// All of one turn of a motion in ascending order of mode and phase. `velocity_lines`: modes x lines of a torus of
/// one dimension, `velocity` the same at its points. None on a torus of two.
std::vector<Turning> turnings(const Torus& torus, const Eigen::MatrixXcd& velocity_lines,
                              const Eigen::MatrixXd& velocity);

/// Velocity of a linear mode at `phase` after a unit jump of its acceleration, over one turn of frequency `base`,
/// in its harmonics above `highest` alone: base/pi * sum over n > highest of cos(n*phase)/(natural^2 - n^2*base^2).
double velocity_beyond(double phase, int highest, double base, double natural);

/// Lines of functions that are smooth but for jumps of `sizes` (functions x turnings, after minus before) at the
/// turnings, from their samples: jumps are taken out of these as sawteeth, and put back as the lines that sawteeth
/// have, exp(-i*n*phase)/(2*pi*i*n) a unit jump, at the phases where they are. Samples alone would alias them by
/// one over their number.
Eigen::MatrixXcd lines_with_jumps(const Torus& torus, Eigen::MatrixXd samples, const std::vector<Turning>& turnings,
                                  const Eigen::MatrixXd& sizes);

/// Change of these lines by that of the phase of a unit jump.
Eigen::RowVectorXcd slope_by_phase(const Torus& torus, double phase);

}  // namespace secular
