#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "measure/observe/observation_set.hpp"

namespace secular {

/// What the expansion says of every harmonic of a motion with the observation's amplitudes, forces and frequencies,
/// as RegressorBlock counts them: [block], 0 for modulation equations.
std::vector<std::complex<double>> predicted_harmonics(const CompiledModel& model, const CompiledCase& resonance,
                                                      const Eigen::VectorXd& parameters, const Observation& o);

}  // namespace secular
