#pragma once

#include <ginac/ginac.h>

#include <map>
#include <string>
#include <vector>

#include "codegen/canonical/rational_function.hpp"
#include "perturb/factored_fraction.hpp"
#include "perturb/symbol_table.hpp"

namespace secular {

std::string decimal_digits(const cln::cl_I& integer);

/// The canonical form of rational expressions in `order`'s symbols, which are real ("pi" stands for GiNaC's Pi).
/// This and canonical_model.cpp are the only places where an expression leaves GiNaC. Remembers divisors: one form
/// serves a whole model. Throws std::logic_error for anything that is not rational in these symbols.
///
/// Denominators stay factored. Terms with the same powers of all symbols that are in no divisor - the products of
/// coefficients - are brought together, each such group by itself: over one denominator in lowest terms where that
/// takes no more to write than the group's fractions of like divisors do, else as these (FractionSums::parts). So a
/// formula is never longer than what the expansion made it of, and where sums cancel they do.
class CanonicalForm {
 public:
  CanonicalForm(const SymbolTable& symbols, const SymbolOrder& order);

  /// Throws std::logic_error for an expression that is not real.
  RationalFunction of(const GiNaC::ex& expression) const;
  /// The summands of an expression; sums of real ones, and a fraction, all of `sums`.
  FractionTerms terms(const GiNaC::ex& expression) const;
  RationalFunction of(const FractionTerms& terms) const;
  RationalFunction of(const FactoredFraction& fraction) const;
  RationalFunction of(const std::vector<FactoredFraction>& sum) const;
  struct Parts {
    RationalFunction real, imaginary;
  };
  Parts parts(const GiNaC::ex& expression) const;
  /// With the same symbols in the same order.
  FractionSums& sums() const { return sums_; }
  /// Guards what a whole model may have, all formulas together: more than that, of some 300 bytes each, fills the
  /// memory, and nobody reads it. Beyond it PolynomialTooLarge is thrown.
  static constexpr std::size_t most_terms = 3'000'000;
  /// Terms of polynomials that were made so far: a measure of the work that does not depend on the machine.
  std::size_t work() const { return sums_.work(); }

 private:
  const DivisorPower& divisor(std::size_t number) const;

  std::size_t size_;
  mutable FractionSums sums_;
  mutable std::size_t terms_ = 0;                         // of all results together
  mutable std::map<std::size_t, DivisorPower> divisors_;  // as plain data
};

}  // namespace secular
