#pragma once

#include <Eigen/Core>

#include "estimator/model/compiled_model.hpp"

namespace secular {

/// Excitation frequency, rad/s, at which the state of rest of a parametric resonance is most unstable under an
/// excitation of this peak amplitude, by the case's modulation equations: the middle between the two jump
/// frequencies. It differs from exact resonance (2 w0, w1 + w2) by the terms with F^2 and with the damping squared,
/// which the rule that the interval is symmetric about exact resonance (thesis Eq. (5.27), section 6.4) leaves out.
/// Throws std::invalid_argument for a case with another number of relations or excitations than one.
double most_unstable_excitation(const CompiledModel& model, const CompiledCase& resonance,
                                const Eigen::Ref<const Eigen::VectorXd>& parameters, double forcing);

}  // namespace secular
