#pragma once

#include <string>

#include "codegen/canonical/canonical_model.hpp"

namespace secular {

/// Modulation equations in Cartesian form, B = (x + i*y)/2 in the observed frame: regular at zero amplitude.
std::string cartesian_text(const CanonicalModel& model, const CanonicalCase& resonance);

/// Appends "*base^power".
void append_power(std::string& product, const std::string& base, int power);

}  // namespace secular
