#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimator/model/compiled_model.hpp"
#include "measure/observe/observation_set.hpp"
#include "motion/correction/balanced_motions.hpp"

namespace secular {

/// Displacements and velocities of the modes at one time.
struct OscillationState {
  std::vector<double> displacement, velocity;
};

/// Zeros, one a mode.
OscillationState at_rest(const CompiledModel& model);

/// States of motions of a case whose modes have observed amplitudes.
class OscillationStates {
 public:
  OscillationStates(const CompiledModel& model, const CompiledCase& resonance);

  /// `time` seconds after the observation's centre. With every harmonic that hangs on the modes, by the full
  /// equations of motion and not by the expansion: a motion that starts so goes on without the free oscillation
  /// that a missing harmonic leaves in its place. Where it has more than two independent frequencies, or is too
  /// strong for its harmonics to be found, with those that the expansion has.
  OscillationState at(const Eigen::VectorXd& parameters, const Observation& observation, double time) const;

 private:
  const CompiledModel& model_;
  const CompiledCase& resonance_;
  BalancedMotions motions_;
};

}  // namespace secular
