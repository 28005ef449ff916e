#pragma once

#include <string>

#include "codegen/canonical/canonical_model.hpp"

namespace secular {

/// What `secular derive --format json` prints: the same content as derivation_text, formulas as model text.
std::string derivation_json(const CanonicalModel& model);

}  // namespace secular
