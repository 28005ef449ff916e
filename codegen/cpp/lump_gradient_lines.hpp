#pragma once

#include <string>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"
#include "codegen/expression/cpp_expression.hpp"

namespace secular {

/// Statements that set gradient[p] to the derivative of a lump by parameter p, those that are not zero. Of a lump
/// with small divisors they go through its fractions, so that no quotient is differentiated as a whole.
std::vector<std::string> lump_gradient_lines(const CanonicalModel& model, const RationalFunction& definition,
                                             CppWriter& writer);

}  // namespace secular
