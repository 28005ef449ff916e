#pragma once

#include <Eigen/Core>

#include "measure/observe/observation_set.hpp"

namespace secular {

/// Moves the amplitudes of slowly drifting dwells to the steady state they drift to: one Newton step
/// z* = z - J^+ dz/dt with the observed rates and the Jacobian of the case's modulation equations at `parameters`.
/// Both in the frame of the observed frequencies: with J of the equations' own frame, minus i times how much faster
/// it turns. The phases that a resonance leaves free (of a combination resonance) stay, and the
/// frequency that it settles to is sought as well. Rates become steady.
void to_steady_amplitudes(ObservationSet& drifting, const Eigen::VectorXd& parameters);

}  // namespace secular
