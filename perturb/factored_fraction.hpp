#pragma once

#include <ginac/ginac.h>

#include <map>
#include <optional>

namespace secular {

/// Irreducible factors that are pairwise coprime, and their powers.
using FactorPowers = std::map<GiNaC::ex, int, GiNaC::ex_is_less>;

/// A polynomial over a product of factors, in lowest terms.
struct FactoredFraction {
  GiNaC::ex numerator;  ///< expanded
  FactorPowers denominator;
};

/// The product of factors, expanded.
GiNaC::ex expanded_product(GiNaC::ex begin, const FactorPowers& factors);

/// Brings sums of products over one denominator. Sums of many small divisors, as (omega1 + 2 omega2) of a model of
/// several modes, have numerators of moderate size, but greatest common divisors of polynomials in so many
/// variables take hours: here the factors of denominators are known as they come, and nothing but they can cancel.
class FractionSums {
 public:
  /// Of at least one expanded product. None where a part is no product of polynomials and of powers of them.
  std::optional<FactoredFraction> sum(const GiNaC::exvector& parts);

 private:
  struct Part {
    GiNaC::ex above = 1;
    FactorPowers below;
  };

  bool add_divisor(const GiNaC::ex& base, int power, Part& part);
  bool add_irreducible(const GiNaC::ex& factor, int power, Part& part);
  std::optional<Part> taken_apart(const GiNaC::ex& product);
  static Part merged(const Part& a, const Part& b);

  std::map<GiNaC::ex, GiNaC::ex, GiNaC::ex_is_less> factored_;  // of bases that are not linear
  FactorPowers known_;                                          // every factor so far, with one of its two signs
};

}  // namespace secular
