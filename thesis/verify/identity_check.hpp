#pragma once

#include <string>

#include "thesis/verify/printed_source.hpp"

namespace secular::verify {

/// How far the two sides of an identity are apart at values drawn for its symbols.
struct IdentityCheck {
  bool holds = false;
  /// |left - right| over the size of the terms that both sides are summed from, carried through what is made of the
  /// sums (Computed::rounding): the largest entry of all draws.
  double largest = 0;
  std::string why;  ///< what cannot be evaluated where sizes do not fit or rounding decides; empty otherwise
};

/// Compares left and right of `text` (the identity as printed, or corrected) at draws of its symbols, fixed by
/// their names: real numbers of magnitude 1/4 to 1, complex ones (both parts so) and matrices where the identity
/// says so; every number has either sign equally often. An identity of analytic functions that fails at all, fails
/// at almost every draw; equal to 64 units of the precision (1.4e-14 of the terms) is equal, so that what is
/// smaller beside them is not seen. Throws InputError, also where `sizes`, `complex` or `define` name what the
/// identity does not have.
IdentityCheck check_identity(const PrintedIdentity& identity, const FormulaSource& text);

}  // namespace secular::verify
