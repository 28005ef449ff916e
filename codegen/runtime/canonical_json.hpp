#pragma once

#include <optional>
#include <string>

#include "codegen/canonical/canonical_model.hpp"

namespace secular {

/// What code is made from, as JSON for the cache: equations of motion, and of every case relations, observed
/// frequencies, lumps and blocks. The rest of a derivation (solvability conditions, harmonics, certificate,
/// warnings) is left out.
std::string canonical_json(const CanonicalModel& model);

/// The model back; nothing if the text is not of that form.
std::optional<CanonicalModel> canonical_from_json(const std::string& text);

}  // namespace secular
