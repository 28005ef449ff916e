#pragma once

#include <string>

#include "perturb/expression.hpp"

namespace secular {

/// A parsed formula as model text, with no more parentheses than it needs: the same text for formulas that differ
/// in blanks and needless parentheses alone.
std::string expression_text(const Expression& expression);

}  // namespace secular
