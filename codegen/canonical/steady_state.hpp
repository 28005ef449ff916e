#pragma once

#include <vector>

#include "codegen/canonical/canonical_model.hpp"

namespace secular {

/// coefficient * a^degree * powers of F.
struct SteadyTerm {
  RationalFunction coefficient;  ///< with the powers of two from A = a/2 already in it
  int degree = 0;
  std::vector<int> forcing;
};

/// The polar modulation equations of a model of one mode, split by whether a term turns with the phase.
struct SteadyState {
  enum class Kind {
    several_modes,   ///< no closed form; the sums are empty
    free,            ///< nothing turns: decay law still_real, backbone still_imaginary
    one_angle,       ///< squaring and adding eliminates the phase
    several_angles,  ///< no closed form
  };
  Kind kind = Kind::several_modes;
  std::vector<SteadyTerm> still_real, still_imaginary, turning_real, turning_imaginary;
};

/// Of one case, from its modulation equation.
SteadyState steady_state(const CanonicalModel& model, const CanonicalCase& resonance);

}  // namespace secular
