#pragma once

#include <string>

#include "perturb/expression.hpp"
#include "perturb/model.hpp"
#include "perturb/term_sum.hpp"

namespace secular {

/// A call or power of an equation that is no polynomial, with its argument as terms.
struct SmoothCall {
  const Expression* whole = nullptr;
  const Expression* argument = nullptr;
  SmoothKind kind = SmoothKind::power;
  std::pair<long, long> exponent = {1, 1};  ///< of a power, in lowest terms
  TermSum inside;
};

/// As one term. Throws InputError at the call for what is not smooth where coordinates and velocities are zero, has
/// an expansion there whose coefficients are no rational numbers and symbols, or is of something else than
/// coordinates and velocities.
TermSum smooth_term(const SmoothCall& call, const Model& model, const FormulaSource& source);

/// Values where coordinates and velocities are zero.
GiNaC::ex value_at_rest(const TermSum& sum);
GiNaC::ex value_at_rest(const SmoothFunction& function);

/// The exponent of a power in an equation of motion: a rational number between -64 and 64 in lowest terms. Throws
/// InputError for others.
std::pair<long, long> rational_exponent(const Expression& power, const FormulaSource& source);

}  // namespace secular
