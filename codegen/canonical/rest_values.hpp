#pragma once

#include <string>

#include "codegen/canonical/canonical_model.hpp"

namespace secular {

/// Derivative by a parameter (its index among the model's symbols), through values at rest as well.
RationalFunction total_derivative(const CanonicalModel& model, const RationalFunction& value, std::size_t symbol);

/// Index of a name among the model's symbols.
std::size_t index_of_symbol(const CanonicalModel& model, const std::string& name);

}  // namespace secular
