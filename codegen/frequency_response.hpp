#pragma once

#include <string>

#include "codegen/canonical_model.hpp"

namespace secular {

/// Modulation equations in Cartesian form, B = (x + i*y)/2 in the observed frame: regular at zero amplitude.
std::string cartesian_text(const CanonicalModel& model, const CanonicalCase& resonance);

/// Steady states of one mode with the phase eliminated: frequency-response relation, or backbone and decay law
/// without excitation. Says so where elimination is not possible.
std::string frequency_response_text(const CanonicalModel& model, const CanonicalCase& resonance);

}  // namespace secular
