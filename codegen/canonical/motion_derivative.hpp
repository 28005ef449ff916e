#pragma once

#include <vector>

#include "codegen/canonical/canonical_model.hpp"

namespace secular {

/// What an equation of motion is derived by.
struct MotionVariable {
  enum class Kind { displacement, velocity, parameter };
  Kind kind = Kind::displacement;
  std::size_t index = 0;  ///< mode, or index into CanonicalModel::parameters
};

/// weight * term
struct WeightedMotionTerm {
  CanonicalRatio weight;
  CanonicalMotionTerm term;
};

/// Derivative of one term of an equation of motion, accelerations held. Of nonsmooth factors it is the classical
/// one on either side of the corner: d|x| = sgn(x) dx, zero at the corner itself, and d sgn(x) = 0.
std::vector<WeightedMotionTerm> motion_derivative(const CanonicalModel& model, const CanonicalMotionTerm& term,
                                                  const MotionVariable& variable);

}  // namespace secular
