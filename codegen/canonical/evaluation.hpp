#pragma once

#include <map>
#include <string>

#include "codegen/canonical/canonical_model.hpp"

namespace secular {

/// The canonical numbers of a derivation as one JSON text: modulation terms (all orders summed, eps = 1) and
/// harmonics, in a fixed order. Computed with 50 digits and rounded once, so that the bytes do not depend on how
/// expressions were arranged. Throws InputError (naming `values_file`) for a symbol without a value.
std::string evaluation_json(const Derivation& derivation, const std::map<std::string, double>& values,
                            const std::string& values_file);

}  // namespace secular
