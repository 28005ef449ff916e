#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace secular {

struct PolynomialTerm;

/// A sum of symbols that divides, as a small divisor omega1 - 2*omega2, and its power, which is positive. The sum
/// has coprime integer coefficients, the first of them positive, and no divisors of its own. Terms share sums.
struct DivisorPower {
  std::shared_ptr<const std::vector<PolynomialTerm>> sum;
  int power = 1;
  bool operator==(const DivisorPower& other) const;  ///< by content
};

/// One term of a polynomial: an integer (decimal digits, with '-') times powers of the symbols of a SymbolOrder;
/// with divisors, over the product of their powers. Divisors are in the order of compare().
struct PolynomialTerm {
  std::string coefficient;
  std::vector<int> exponents;
  std::vector<DivisorPower> divisors = {};
  bool operator==(const PolynomialTerm&) const = default;
};

/// Sums of divisors in a fixed order, by what they hold: negative, zero or positive.
int compare(const std::vector<PolynomialTerm>& a, const std::vector<PolynomialTerm>& b);

/// numerator/denominator with coprime integer coefficients and a positive leading denominator coefficient; terms of
/// like divisors together, those without divisors first, in descending lexicographic order of exponents. Terms of
/// the numerator alone have divisors: they are fractions over products of small divisors, and the number of terms
/// is that of the sum of these fractions, not of what they make over one denominator. Everything that is printed or
/// emitted goes through it, because GiNaC's own order and signs change from run to run. Plain data, no GiNaC.
struct RationalFunction {
  std::vector<PolynomialTerm> numerator;    ///< empty: zero
  std::vector<PolynomialTerm> denominator;  ///< never empty
  bool operator==(const RationalFunction&) const = default;

  bool is_zero() const { return numerator.empty(); }
  bool is_constant() const;            ///< a number
  bool is_one() const;                 ///< 1
  bool denominator_is_number() const;  ///< a polynomial, but for a factor
};

/// One of the fractions that a rational function is a sum of: its terms of like divisors, without these, over a
/// denominator of its own, in lowest terms as to numbers and powers of symbols.
struct Fraction {
  std::vector<PolynomialTerm> numerator, denominator;
  std::vector<DivisorPower> divisors;
  bool is_plain() const;  ///< a polynomial: neither denominator nor divisors
};
std::vector<Fraction> fractions(const RationalFunction& value);

/// Written as a sum at its outermost level: several fractions, or a polynomial of several terms.
bool reads_as_sum(const RationalFunction& value);

/// Whether it is zero as a function, whatever stands in it: decided at a random point of a prime field, never wrong
/// about a zero, about another one with a chance below its degree/2^61.
bool vanishes(const RationalFunction& value);

/// Derivative by one symbol (its index in the order), by the quotient rule. Common powers of symbols and common
/// numbers are cancelled, other common factors are not: the value is exact, its representation not always shortest.
RationalFunction derivative(const RationalFunction& value, std::size_t symbol);

/// One group of a polynomial's terms: they share `common` powers of some of the symbols, and `divisors`; in `rest`
/// these are not.
struct PolynomialGroup {
  std::vector<int> common;
  std::vector<PolynomialTerm> rest;
  std::vector<DivisorPower> divisors = {};
};

/// sum of terms = sum over groups of common * rest / divisors, grouped by the powers of the symbols for which `by`
/// is true, and by divisors or not.
std::vector<PolynomialGroup> grouped(const std::vector<PolynomialTerm>& terms, const std::vector<bool>& by,
                                     bool by_divisors);

/// a + b. Common powers of symbols, common numbers and equal denominators are cancelled, other common factors are
/// not.
RationalFunction sum(const RationalFunction& a, const RationalFunction& b);

/// The sum of many whose denominators are single terms.
RationalFunction sum(const std::vector<RationalFunction>& values);

/// a*b, with the same cancellation.
RationalFunction product(const RationalFunction& a, const RationalFunction& b);

/// Denominators that differ by a number and powers of symbols only: the sum is not longer than its parts.
bool have_like_denominators(const RationalFunction& a, const RationalFunction& b);

/// What of the numerator's terms is wanted, over the denominator.
RationalFunction terms_of(const RationalFunction& value, const std::function<bool(const PolynomialTerm&)>& wanted);

/// Whether the symbol (its index in the order) occurs.
bool depends_on(const RationalFunction& value, std::size_t symbol);

/// The symbols that exponents refer to, in declared order; "pi" is one of them.
using SymbolOrder = std::vector<std::string>;

}  // namespace secular
