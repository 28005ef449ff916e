#pragma once

#include <Eigen/Core>

#include "measure/observe/observation_set.hpp"

namespace secular {

/// Moves the amplitudes of slowly drifting dwells to the steady state they drift to: one Newton step
/// z* = z - J^+ dz/dt with the observed rates and the Jacobian of the case's modulation equations at `parameters`.
/// A direction in which J vanishes (the free phase of a combination resonance) stays. Rates become steady.
void to_steady_amplitudes(ObservationSet& drifting, const Eigen::VectorXd& parameters);

}  // namespace secular
