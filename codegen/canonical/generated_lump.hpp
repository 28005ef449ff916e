#pragma once

#include <optional>

#include "codegen/canonical/canonical_model.hpp"

namespace secular {

/// What a lump without a name of its own in the model stands for: the coefficient of one monomial in one field.
struct GeneratedLump {
  enum class Kind { conservative, dissipative, harmonic_real, harmonic_imaginary };
  Kind kind = Kind::conservative;
  std::size_t mode = 0;
  CanonicalPowers powers;
};

/// Nothing where the lump is a parameter or a shorthand of the model.
std::optional<GeneratedLump> generated_lump(const CanonicalModel& model, const CanonicalCase& resonance,
                                            std::size_t lump);

}  // namespace secular
