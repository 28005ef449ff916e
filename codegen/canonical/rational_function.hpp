#pragma once

#include <functional>
#include <string>
#include <vector>

namespace secular {

/// One term of a polynomial: an integer (decimal digits, with '-') times powers of the symbols of a SymbolOrder.
struct PolynomialTerm {
  std::string coefficient;
  std::vector<int> exponents;
  bool operator==(const PolynomialTerm&) const = default;
};

/// numerator/denominator with coprime integer coefficients and a positive leading denominator coefficient; terms in
/// descending lexicographic order of exponents. One value has one representation: everything that is printed or
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

/// Derivative by one symbol (its index in the order), by the quotient rule. Common powers of symbols and common
/// numbers are cancelled, other common factors are not: the value is exact, its representation not always shortest.
RationalFunction derivative(const RationalFunction& value, std::size_t symbol);

/// One group of a polynomial's terms: they share `common` powers of some of the symbols; in `rest` these are zero.
struct PolynomialGroup {
  std::vector<int> common;
  std::vector<PolynomialTerm> rest;
};

/// sum of terms = sum over groups of common * rest, grouped by the powers of the symbols for which `by` is true.
std::vector<PolynomialGroup> grouped(const std::vector<PolynomialTerm>& terms, const std::vector<bool>& by);

/// a + b. Common powers of symbols, common numbers and equal denominators are cancelled, other common factors are
/// not.
RationalFunction sum(const RationalFunction& a, const RationalFunction& b);

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
