#pragma once

#include <string>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"

namespace secular {

/// These symbols, and those that values at rest among them follow from.
std::vector<std::string> with_arguments(const CanonicalModel& model, std::vector<std::string> names);

/// Declarations of the values at rest among `names`, each after those it follows from. `scalar`: their type.
std::vector<std::string> rest_value_lines(const CanonicalModel& model, const std::vector<std::string>& names,
                                          const std::string& scalar);

}  // namespace secular
