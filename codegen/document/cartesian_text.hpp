#pragma once

#include <string>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"

namespace secular {

/// Modulation equations in Cartesian form, B = (x + i*y)/2 in the observed frame: regular at zero amplitude.
std::string cartesian_text(const CanonicalModel& model, const CanonicalCase& resonance);

/// A sum of natural and excitation frequencies with these factors; empty where all are zero.
std::string frequency_text(const CanonicalModel& model, const std::vector<CanonicalRatio>& factors);

/// Appends "*base^power".
void append_power(std::string& product, const std::string& base, int power);

}  // namespace secular
