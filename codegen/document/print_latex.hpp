#pragma once

#include <string>

#include "codegen/canonical/canonical_model.hpp"

namespace secular {

/// What `secular derive --format latex` prints: the content of derivation_text() as a LaTeX document that needs
/// amsmath and amssymb only. Long sums are broken over lines, equations over pages.
std::string derivation_latex(const CanonicalModel& model);

}  // namespace secular
