#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimator/compiled_model.hpp"
#include "estimator/identification/observation_set.hpp"

namespace secular {

/// Displacements and velocities of the modes at one time.
struct OscillationState {
  std::vector<double> displacement, velocity;
};

/// State, `time` seconds after the observation's centre, of a motion whose modes have the observed amplitudes. Of
/// an excited case with every harmonic that hangs on them, by the full equations of motion and not by the
/// expansion: a motion that starts so goes on without the free oscillation that a missing harmonic leaves in its
/// place. Where it has more than two independent frequencies, or is too strong for its harmonics to be found, with
/// those that the expansion has.
OscillationState oscillation_state(const CompiledModel& model, const CompiledCase& resonance,
                                   const Eigen::VectorXd& parameters, const Observation& observation, double time);

}  // namespace secular
