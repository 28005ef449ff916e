#pragma once

#include <cln/rational.h>
#include <ginac/ginac.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "perturb/polynomial.hpp"
#include "perturb/prime_field.hpp"

namespace secular {

/// Divisors of a FractionSums by their numbers, ascending, and their powers; negative: they multiply.
using DivisorPowers = std::vector<std::pair<std::size_t, int>>;

/// (real + i imaginary) * product of symbols^powers / product of divisors^powers.
struct FractionTerm {
  cln::cl_RA real = 0, imaginary = 0;
  std::vector<int> powers;  ///< of every symbol, of either sign
  DivisorPowers divisors;
};
using FractionTerms = std::vector<FractionTerm>;

/// The real or the imaginary part, as real terms; all symbols are real.
FractionTerms real_part(const FractionTerms& terms);
FractionTerms imaginary_part(const FractionTerms& terms);

/// scale * product of symbols^powers * numerator / product of divisors^powers in lowest terms: no divisor and no
/// symbol divides the numerator, whose coefficients have nothing in common and the first of which is positive.
struct FactoredFraction {
  cln::cl_RA scale = 0;  ///< 0: the fraction is zero
  std::vector<int> powers;
  std::vector<std::size_t> variables;  ///< the symbols that the numerator is a polynomial in, ascending
  Polynomial numerator;
  DivisorPowers divisors;
  bool is_zero() const { return cln::zerop(scale); }
};

/// Brings sums of products over one denominator. Sums of many small divisors, as (omega1 + 2 omega2) of a model of
/// several modes, have numerators of moderate size, but greatest common divisors of polynomials in so many
/// variables take hours: here denominators are products of factors without common factors from the beginning,
/// nothing but these can cancel, and each is tried by division; where one cancels in part, it is taken apart.
/// Results are exact: random points of a prime field only tell beforehand that a division fails, which they never
/// tell wrongly.
class FractionSums {
 public:
  /// `symbols`: those that expressions are rational in, Pi perhaps among them.
  explicit FractionSums(const GiNaC::exvector& symbols);

  /// The product of the numbers of terms of two polynomials up to which their greatest common divisor is asked for:
  /// a second or two (sums of five symbols to powers, 1821 by 496 terms: 1.7 s). Beyond it PolynomialTooLarge is
  /// thrown.
  static constexpr std::size_t most_common_work = 1'000'000;

  /// A sum of products of symbols, of complex rationals, and of powers of sums of them (negative powers of any sum,
  /// positive ones of sums without products, as a detuning). None for anything else.
  std::optional<FractionTerms> terms(const GiNaC::ex& expression);
  /// The sum of real terms.
  FactoredFraction sum(const FractionTerms& terms);
  /// The sum as one fraction in lowest terms where that takes no more terms and divisors to write than the sums of
  /// terms with like divisors do, else as these; none if it is zero. One denominator is only tried up to
  /// `most_joined`.
  std::vector<FactoredFraction> parts(const FractionTerms& terms);
  /// Products of numbers of terms up to which one denominator is tried: some milliseconds.
  static constexpr std::size_t most_joined = 10'000;
  FactoredFraction product(const FactoredFraction& a, const FactoredFraction& b);
  /// above/below; throws std::domain_error for a division by zero.
  FactoredFraction quotient(const FactoredFraction& above, const FactoredFraction& below);

  /// The product of divisors, those with negative powers left out, in these variables.
  Polynomial expanded(const DivisorPowers& divisors, const std::vector<std::size_t>& variables) const;
  const std::vector<std::size_t>& variables(std::size_t divisor) const { return divisors_[divisor].variables; }
  const Polynomial& divisor(std::size_t number) const { return divisors_[number].polynomial; }
  std::size_t divisors() const { return divisors_.size(); }  ///< how many were met so far
  /// As expressions; one of few factors.
  GiNaC::ex expression(const FractionTerms& terms) const;
  GiNaC::ex expression(const FactoredFraction& fraction) const;
  /// Whether a symbol, by its index, occurs.
  bool has(const FractionTerms& terms, std::size_t symbol) const;
  std::size_t place(const GiNaC::ex& symbol) const { return place_.at(symbol); }

  /// Terms of polynomials that were made so far: a measure of the work that does not depend on the machine.
  std::size_t work() const { return work_; }

 private:
  // What a sum is as a product.
  struct Product {
    cln::cl_RA scale = 1;
    std::vector<int> powers;
    DivisorPowers divisors;
  };
  struct Divisor {  // coefficients without a common factor, the first one positive; no symbol divides it
    std::vector<std::size_t> variables;
    Polynomial polynomial;
    GiNaC::ex expression;
    bool irreducible = false;            // known to be
    std::optional<DivisorPowers> apart;  // factors that take its place; powers as of multiplying
  };
  struct Common {
    Polynomial polynomial;
    std::vector<std::size_t> variables;
  };
  struct Part;
  class Combination;

  bool read_product(const GiNaC::ex& product, FractionTerm& term);
  bool read_power(const GiNaC::ex& base, int exponent, FractionTerm& term);
  const std::optional<Product>& factors_of(const GiNaC::ex& sum);
  std::optional<Product> factored(const FactoredFraction& fraction);
  bool is_linear(const GiNaC::ex& sum) const;
  std::size_t divisor(const Polynomial& primitive, const std::vector<std::size_t>& variables);
  GiNaC::ex expression(const Polynomial& polynomial, const std::vector<std::size_t>& variables) const;
  bool reduced(FactoredFraction& fraction, const DivisorPowers& by);
  bool separated(const DivisorPowers& divisors);
  std::size_t joining_work(const std::vector<FactoredFraction>& parts) const;
  bool vanishes(const FractionTerms& terms) const;
  std::optional<FactoredFraction> sum_if_apart(const FractionTerms& terms);
  FactoredFraction in_lowest_terms(FactoredFraction fraction);
  Common common_factor(std::size_t divisor, const Polynomial& other, const std::vector<std::size_t>& variables);
  bool take_apart(std::size_t divisor, const Common& factor);
  FractionTerms up_to_date(FractionTerms terms) const;
  void bring_up_to_date(DivisorPowers& divisors) const;
  bool share_no_factor(std::size_t a, std::size_t b);

  GiNaC::exvector symbols_;
  std::unordered_map<GiNaC::ex, std::size_t> place_;                // of a symbol
  std::unordered_map<GiNaC::ex, std::optional<Product>> products_;  // of sums, as they were met
  std::map<std::vector<std::string>, std::size_t> number_of_;       // of a divisor by its terms
  std::vector<Divisor> divisors_;
  std::map<std::pair<std::size_t, std::size_t>, bool> coprime_;  // of pairs of divisors
  std::size_t work_ = 0;
};

/// Values of real terms at a point of the prime field, with every symbol's value in the order of the symbols.
class FractionPoint {
 public:
  FractionPoint(const FractionSums& sums, std::vector<PrimeFieldComplex> values);
  PrimeFieldComplex value(const FractionTerms& terms);

 private:
  const FractionSums& sums_;
  std::vector<PrimeFieldComplex> values_, inverses_;
  std::vector<PrimeFieldComplex> divisors_, inverse_divisors_;  // as far as they were met
};

/// Both together; variables ascend.
std::vector<std::size_t> united(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b);

/// A polynomial in other variables, which contain its own.
Polynomial in_variables(const Polynomial& polynomial, const std::vector<std::size_t>& own,
                        const std::vector<std::size_t>& variables);

}  // namespace secular
