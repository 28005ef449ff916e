#pragma once

#include "perturb/expression.hpp"

namespace secular {

/// Refuses a formula that algebra would not come to an end with, before any algebra: a power of a power of a sum
/// has more terms, and a power of a number more digits, than fit anywhere, however short they are to write. Bounds
/// are those of the formula multiplied out, from its tree alone. Throws InputError at the part that exceeds one.
void refuse_out_of_proportion(const Expression& expression, const FormulaSource& source);

}  // namespace secular
