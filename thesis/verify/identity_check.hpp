#pragma once

#include <string>

#include "thesis/verify/printed_source.hpp"

namespace secular::verify {

/// How far the two sides of an identity are apart at values drawn for its symbols.
struct IdentityCheck {
  bool holds = false;
  double largest = 0;  ///< |left - right| over 1 + |left| + |right|, the largest entry of all draws
  std::string why;     ///< what cannot be evaluated where sizes do not fit; empty otherwise
};

/// Compares left and right of `text` (the identity as printed, or corrected) at three draws of its symbols, fixed
/// by their names: real numbers of (-1, 1), complex ones and matrices where the identity says so. An identity of
/// analytic functions that fails at all, fails at almost every draw; equal to 1e-9 is equal. Throws InputError.
IdentityCheck check_identity(const PrintedIdentity& identity, const FormulaSource& text);

}  // namespace secular::verify
