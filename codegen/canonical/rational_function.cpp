#include "codegen/canonical/rational_function.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <functional>
#include <iterator>
#include <map>

namespace secular {
namespace {

using Integer = boost::multiprecision::cpp_int;
using Polynomial = std::map<std::vector<int>, Integer, std::greater<>>;  // in the order of PolynomialTerm lists

bool is_number(const std::vector<PolynomialTerm>& polynomial) {
  return polynomial.empty() ||
         (polynomial.size() == 1 && std::all_of(polynomial.front().exponents.begin(),
                                                polynomial.front().exponents.end(), [](int e) { return e == 0; }));
}

Polynomial polynomial(const std::vector<PolynomialTerm>& terms) {
  Polynomial result;
  for (const PolynomialTerm& term : terms) result[term.exponents] += Integer(term.coefficient);
  return result;
}

void add_product(Polynomial& sum, const Polynomial& a, const Polynomial& b, int sign) {
  for (const auto& [left, x] : a)
    for (const auto& [right, y] : b) {
      std::vector<int> exponents = left;
      for (std::size_t i = 0; i < exponents.size(); ++i) exponents[i] += right[i];
      sum[exponents] += sign * x * y;
    }
}

Polynomial derivative(const Polynomial& p, std::size_t symbol) {
  Polynomial result;
  for (const auto& [exponents, coefficient] : p) {
    if (exponents[symbol] == 0) continue;
    std::vector<int> lowered = exponents;
    --lowered[symbol];
    result[lowered] += coefficient * exponents[symbol];
  }
  return result;
}

// numerator/denominator without common integers and common powers of symbols.
RationalFunction fraction(Polynomial numerator, const Polynomial& denominator) {
  std::erase_if(numerator, [](const auto& term) { return term.second == 0; });
  const std::size_t symbols = denominator.begin()->first.size();
  if (numerator.empty()) return {{}, {{"1", std::vector<int>(symbols, 0)}}};
  std::vector<int> common = numerator.begin()->first;
  Integer divisor = 0;
  for (const Polynomial* p : {static_cast<const Polynomial*>(&numerator), &denominator})
    for (const auto& [exponents, coefficient] : *p) {
      for (std::size_t i = 0; i < symbols; ++i) common[i] = std::min(common[i], exponents[i]);
      divisor = boost::multiprecision::gcd(divisor, coefficient);
    }
  if (denominator.begin()->second < 0) divisor = -divisor;
  const auto terms = [&](const Polynomial& p) {
    std::vector<PolynomialTerm> result;
    for (const auto& [exponents, coefficient] : p) {
      std::vector<int> lowered = exponents;
      for (std::size_t i = 0; i < symbols; ++i) lowered[i] -= common[i];
      result.push_back({Integer(coefficient / divisor).str(), std::move(lowered)});
    }
    return result;
  };
  return {terms(numerator), terms(denominator)};
}

// number * powers of symbols * rest, with nothing in common among the rest's terms.
struct Factored {
  Integer number = 0;
  std::vector<int> powers;
  Polynomial rest;
};

Factored factored(const std::vector<PolynomialTerm>& terms) {
  Factored result;
  result.powers = terms.front().exponents;
  for (const PolynomialTerm& term : terms) {
    result.number = boost::multiprecision::gcd(result.number, Integer(term.coefficient));
    for (std::size_t i = 0; i < result.powers.size(); ++i)
      result.powers[i] = std::min(result.powers[i], term.exponents[i]);
  }
  for (const PolynomialTerm& term : terms) {
    std::vector<int> lowered = term.exponents;
    for (std::size_t i = 0; i < lowered.size(); ++i) lowered[i] -= result.powers[i];
    result.rest[lowered] = Integer(term.coefficient) / result.number;
  }
  return result;
}

Polynomial times(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  add_product(result, a, b, 1);
  std::erase_if(result, [](const auto& term) { return term.second == 0; });
  return result;
}

}  // namespace

bool RationalFunction::denominator_is_number() const {
  return is_number(denominator);
}

bool RationalFunction::is_constant() const {
  return is_number(numerator) && is_number(denominator);
}

bool RationalFunction::is_one() const {
  return is_constant() && !numerator.empty() && numerator.front().coefficient == denominator.front().coefficient;
}

RationalFunction derivative(const RationalFunction& value, std::size_t symbol) {
  const Polynomial above = polynomial(value.numerator), below = polynomial(value.denominator);
  const Polynomial below_rate = derivative(below, symbol);
  if (below_rate.empty()) return fraction(derivative(above, symbol), below);
  Polynomial numerator, denominator;
  add_product(numerator, derivative(above, symbol), below, 1);
  add_product(numerator, above, below_rate, -1);
  add_product(denominator, below, below, 1);
  return fraction(std::move(numerator), denominator);
}

std::vector<PolynomialGroup> grouped(const std::vector<PolynomialTerm>& terms, const std::vector<bool>& by) {
  std::map<std::vector<int>, std::vector<PolynomialTerm>, std::greater<>> groups;
  for (const PolynomialTerm& term : terms) {
    std::vector<int> common = term.exponents;
    PolynomialTerm rest = term;
    for (std::size_t i = 0; i < common.size(); ++i) (by[i] ? rest.exponents : common)[i] = 0;
    groups[common].push_back(std::move(rest));
  }
  std::vector<PolynomialGroup> result;
  for (auto& [common, rest] : groups) result.push_back({common, std::move(rest)});
  return result;
}

RationalFunction sum(const RationalFunction& a, const RationalFunction& b) {
  if (a.is_zero()) return b;
  if (b.is_zero()) return a;
  const Factored left = factored(a.denominator), right = factored(b.denominator);
  // The least common multiple over each denominator: what its numerator is multiplied by.
  std::vector<int> by_left(left.powers.size()), by_right = by_left;
  for (std::size_t i = 0; i < by_left.size(); ++i) {
    by_left[i] = std::max(0, right.powers[i] - left.powers[i]);
    by_right[i] = std::max(0, left.powers[i] - right.powers[i]);
  }
  const Integer common = boost::multiprecision::gcd(left.number, right.number);
  const bool alike = left.rest == right.rest;
  Polynomial extend_left{{by_left, right.number / common}}, extend_right{{by_right, left.number / common}};
  if (!alike) {
    extend_left = times(extend_left, right.rest);
    extend_right = times(extend_right, left.rest);
  }
  Polynomial numerator = times(polynomial(a.numerator), extend_left);
  for (const auto& [exponents, value] : times(polynomial(b.numerator), extend_right)) numerator[exponents] += value;
  return fraction(std::move(numerator), times(polynomial(a.denominator), extend_left));
}

RationalFunction product(const RationalFunction& a, const RationalFunction& b) {
  if (a.is_zero()) return a;
  if (b.is_zero()) return b;
  return fraction(times(polynomial(a.numerator), polynomial(b.numerator)),
                  times(polynomial(a.denominator), polynomial(b.denominator)));
}

bool have_like_denominators(const RationalFunction& a, const RationalFunction& b) {
  return factored(a.denominator).rest == factored(b.denominator).rest;
}

RationalFunction terms_of(const RationalFunction& value, const std::function<bool(const PolynomialTerm&)>& wanted) {
  if (std::all_of(value.numerator.begin(), value.numerator.end(), wanted)) return value;
  std::vector<PolynomialTerm> terms;
  std::copy_if(value.numerator.begin(), value.numerator.end(), std::back_inserter(terms), wanted);
  return fraction(polynomial(terms), polynomial(value.denominator));
}

bool depends_on(const RationalFunction& value, std::size_t symbol) {
  const auto occurs = [&](const std::vector<PolynomialTerm>& terms) {
    return std::any_of(terms.begin(), terms.end(),
                       [&](const PolynomialTerm& term) { return term.exponents[symbol] != 0; });
  };
  return occurs(value.numerator) || occurs(value.denominator);
}

}  // namespace secular
