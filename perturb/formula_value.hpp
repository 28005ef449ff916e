#pragma once

#include <ginac/ginac.h>

#include <functional>

#include "perturb/expression.hpp"

namespace secular {

/// Of what a formula may raise to a power.
inline constexpr int largest_exponent = 64;

/// Value of a formula without D, D2, abs, sgn, cos, sin: numbers exact, symbols by `value_of` (handed the symbol's
/// node, so that it can complain at its place). Throws InputError for a function, for a division by zero, for zero
/// to the power of zero and for a power that is not an integer between -64 and 64.
GiNaC::ex formula_value(const Expression& expression, const FormulaSource& source,
                        const std::function<GiNaC::ex(const Expression& symbol)>& value_of);

/// Throws InputError where zero is raised to that power, zero or below.
void refuse_power_of_zero(const GiNaC::ex& base, int exponent, const Expression& power,
                          const FormulaSource& source);

/// The integer exponent of a power node, checked as above.
int integer_exponent(const Expression& power, const FormulaSource& source);

}  // namespace secular
