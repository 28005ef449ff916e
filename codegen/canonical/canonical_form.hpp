#pragma once

#include <ginac/ginac.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "codegen/canonical/rational_function.hpp"
#include "perturb/factored_fraction.hpp"
#include "perturb/symbol_table.hpp"

namespace secular {

std::string decimal_digits(const cln::cl_I& integer);

/// The canonical form of rational expressions in `order`'s symbols, which are real ("pi" stands for GiNaC's Pi).
/// This and canonical_model.cpp are the only places where an expression leaves GiNaC. Remembers divisors and
/// denominators: one form serves a whole model. Throws std::logic_error for anything that is not rational in these
/// symbols.
class CanonicalForm {
 public:
  CanonicalForm(const SymbolTable& symbols, const SymbolOrder& order);

  /// Throws std::logic_error for an expression that is not real.
  RationalFunction of(const GiNaC::ex& expression) const;
  /// The summands of an expression, and a fraction, both of `sums`.
  FractionTerms terms(const GiNaC::ex& expression) const;
  RationalFunction of(const FactoredFraction& fraction) const;
  struct Parts {
    RationalFunction real, imaginary;
  };
  Parts parts(const GiNaC::ex& expression) const;
  /// With the same symbols in the same order.
  FractionSums& sums() const { return sums_; }
  /// Guards what a whole model may have when it is multiplied out, all formulas together: more than that, of some
  /// 300 bytes each, fills the memory, and nobody reads it. Beyond it PolynomialTooLarge is thrown.
  static constexpr std::size_t most_terms = 3'000'000;
  /// Terms of polynomials that were made so far: a measure of the work that does not depend on the machine.
  std::size_t work() const { return sums_.work(); }

 private:
  const std::vector<PolynomialTerm>& denominator(const std::vector<int>& powers,
                                                 const DivisorPowers& divisors) const;

  std::size_t size_;
  mutable FractionSums sums_;
  mutable std::size_t terms_ = 0;  // of all results together
  mutable std::map<std::pair<std::vector<int>, DivisorPowers>, std::vector<PolynomialTerm>> denominators_;
};

}  // namespace secular
