#pragma once

#include <string>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"

namespace secular {

/// Of a model about its rest position: the coefficients that follow from it, and the values of functions at rest
/// that formulas hold, as "name = formula". Empty for other models.
std::vector<std::string> rest_lines(const CanonicalModel& model);

}  // namespace secular
