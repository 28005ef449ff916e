#pragma once

#include <string>

#include "codegen/canonical/canonical_model.hpp"

namespace secular {

/// What `secular derive --format html` prints: the content of derivation_text() as one page that needs nothing
/// else. Formulas are MathML; long sums break between their terms. No script.
std::string derivation_html(const CanonicalModel& model);

}  // namespace secular
