#include "codegen/canonical/rational_function.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <functional>
#include <iterator>
#include <map>
#include <utility>

#include "perturb/prime_field.hpp"

namespace secular {
namespace {

using Integer = boost::multiprecision::cpp_int;

int compare(const std::vector<DivisorPower>& a, const std::vector<DivisorPower>& b) {
  if (a.size() != b.size()) return a.size() < b.size() ? -1 : 1;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].sum != b[i].sum)
      if (const int order = secular::compare(*a[i].sum, *b[i].sum); order != 0) return order;
    if (a[i].power != b[i].power) return a[i].power < b[i].power ? -1 : 1;
  }
  return 0;
}

struct Monomial {
  std::vector<int> exponents;
  std::vector<DivisorPower> divisors = {};
  bool operator==(const Monomial&) const = default;
};

struct ListedBefore {  // in the order of PolynomialTerm lists
  bool operator()(const Monomial& a, const Monomial& b) const {
    const int order = compare(a.divisors, b.divisors);
    return order != 0 ? order < 0 : a.exponents > b.exponents;
  }
};
using Polynomial = std::map<Monomial, Integer, ListedBefore>;

bool is_number(const std::vector<PolynomialTerm>& polynomial) {
  return polynomial.empty() || (polynomial.size() == 1 && polynomial.front().divisors.empty() &&
                                std::all_of(polynomial.front().exponents.begin(),
                                            polynomial.front().exponents.end(), [](int e) { return e == 0; }));
}

Polynomial polynomial(const std::vector<PolynomialTerm>& terms) {
  Polynomial result;
  for (const PolynomialTerm& term : terms) result[{term.exponents, term.divisors}] += Integer(term.coefficient);
  return result;
}

std::vector<DivisorPower> product(const std::vector<DivisorPower>& a, const std::vector<DivisorPower>& b) {
  if (a.empty() || b.empty()) return a.empty() ? b : a;
  std::vector<DivisorPower> result = a;
  for (const DivisorPower& factor : b) {
    const auto place = std::find_if(result.begin(), result.end(), [&](const DivisorPower& other) {
      return other.sum == factor.sum || secular::compare(*other.sum, *factor.sum) >= 0;
    });
    if (place != result.end() && (place->sum == factor.sum || secular::compare(*place->sum, *factor.sum) == 0))
      place->power += factor.power;
    else
      result.insert(place, factor);
  }
  return result;
}

Monomial product(const Monomial& a, const Monomial& b) {
  Monomial result{a.exponents, product(a.divisors, b.divisors)};
  for (std::size_t i = 0; i < result.exponents.size(); ++i) result.exponents[i] += b.exponents[i];
  return result;
}

void add_product(Polynomial& sum, const Polynomial& a, const Polynomial& b, int sign) {
  for (const auto& [left, x] : a)
    for (const auto& [right, y] : b) sum[product(left, right)] += sign * x * y;
}

Polynomial derivative(const Polynomial& p, std::size_t symbol) {
  Polynomial result;
  for (const auto& [monomial, coefficient] : p) {
    if (const int exponent = monomial.exponents[symbol]; exponent != 0) {
      Monomial lowered = monomial;
      --lowered.exponents[symbol];
      result[lowered] += coefficient * exponent;
    }
    for (const auto& [sum, power] : monomial.divisors)
      for (const PolynomialTerm& term : *sum) {  // d(1/D^n) = -n dD/D^(n + 1)
        if (term.exponents[symbol] == 0) continue;
        Monomial rate{term.exponents, {{sum, 1}}};
        --rate.exponents[symbol];
        result[product(monomial, rate)] -= coefficient * power * term.exponents[symbol] * Integer(term.coefficient);
      }
  }
  return result;
}

// numerator/denominator without common integers and common powers of symbols.
RationalFunction fraction(Polynomial numerator, const Polynomial& denominator) {
  std::erase_if(numerator, [](const auto& term) { return term.second == 0; });
  const std::size_t symbols = denominator.begin()->first.exponents.size();
  if (numerator.empty()) return {{}, {{"1", std::vector<int>(symbols, 0)}}};
  std::vector<int> common = numerator.begin()->first.exponents;
  Integer divisor = 0;
  for (const Polynomial* p : {static_cast<const Polynomial*>(&numerator), &denominator})
    for (const auto& [monomial, coefficient] : *p) {
      for (std::size_t i = 0; i < symbols; ++i) common[i] = std::min(common[i], monomial.exponents[i]);
      divisor = boost::multiprecision::gcd(divisor, coefficient);
    }
  if (denominator.begin()->second < 0) divisor = -divisor;
  const auto terms = [&](const Polynomial& p) {
    std::vector<PolynomialTerm> result;
    for (const auto& [monomial, coefficient] : p) {
      std::vector<int> lowered = monomial.exponents;
      for (std::size_t i = 0; i < symbols; ++i) lowered[i] -= common[i];
      result.push_back({Integer(coefficient / divisor).str(), std::move(lowered), monomial.divisors});
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
    result.rest[{std::move(lowered)}] = Integer(term.coefficient) / result.number;
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

bool DivisorPower::operator==(const DivisorPower& other) const {
  return power == other.power && (sum == other.sum || secular::compare(*sum, *other.sum) == 0);
}

int compare(const std::vector<PolynomialTerm>& a, const std::vector<PolynomialTerm>& b) {
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (a[i].exponents != b[i].exponents) return a[i].exponents > b[i].exponents ? -1 : 1;
    const std::string &x = a[i].coefficient, &y = b[i].coefficient;
    if (x.size() != y.size()) return x.size() < y.size() ? -1 : 1;
    if (x != y) return x < y ? -1 : 1;
  }
  return a.size() == b.size() ? 0 : a.size() < b.size() ? -1 : 1;
}

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
  if (!depends_on(value, symbol))
    return {{}, {{"1", std::vector<int>(value.denominator.front().exponents.size(), 0)}}};
  const Polynomial above = polynomial(value.numerator), below = polynomial(value.denominator);
  const Polynomial below_rate = derivative(below, symbol);
  if (below_rate.empty()) return fraction(derivative(above, symbol), below);
  Polynomial numerator, denominator;
  add_product(numerator, derivative(above, symbol), below, 1);
  add_product(numerator, above, below_rate, -1);
  add_product(denominator, below, below, 1);
  return fraction(std::move(numerator), denominator);
}

std::vector<PolynomialGroup> grouped(const std::vector<PolynomialTerm>& terms, const std::vector<bool>& by,
                                     bool by_divisors) {
  std::map<Monomial, std::vector<PolynomialTerm>, ListedBefore> groups;
  for (const PolynomialTerm& term : terms) {
    Monomial common{term.exponents};
    PolynomialTerm rest = term;
    for (std::size_t i = 0; i < by.size(); ++i) (by[i] ? rest.exponents : common.exponents)[i] = 0;
    if (by_divisors) common.divisors = std::exchange(rest.divisors, {});
    groups[std::move(common)].push_back(std::move(rest));
  }
  std::vector<PolynomialGroup> result;
  for (auto& [common, rest] : groups) result.push_back({common.exponents, std::move(rest), common.divisors});
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
  Polynomial extend_left{{{by_left}, right.number / common}}, extend_right{{{by_right}, left.number / common}};
  if (!alike) {
    extend_left = times(extend_left, right.rest);
    extend_right = times(extend_right, left.rest);
  }
  Polynomial numerator = times(polynomial(a.numerator), extend_left);
  for (const auto& [monomial, value] : times(polynomial(b.numerator), extend_right)) numerator[monomial] += value;
  return fraction(std::move(numerator), times(polynomial(a.denominator), extend_left));
}

RationalFunction sum(const std::vector<RationalFunction>& values) {
  if (values.size() == 1) return values.front();
  std::vector<int> highest = values.front().denominator.front().exponents;
  Integer number = 1;
  for (const RationalFunction& value : values) {
    const PolynomialTerm& below = value.denominator.front();
    number = boost::multiprecision::lcm(number, Integer(below.coefficient));
    for (std::size_t i = 0; i < highest.size(); ++i) highest[i] = std::max(highest[i], below.exponents[i]);
  }
  Polynomial numerator;
  for (const RationalFunction& value : values) {
    const PolynomialTerm& below = value.denominator.front();
    const Integer times = number / Integer(below.coefficient);
    for (const PolynomialTerm& term : value.numerator) {
      Monomial monomial{term.exponents, term.divisors};
      for (std::size_t i = 0; i < highest.size(); ++i) monomial.exponents[i] += highest[i] - below.exponents[i];
      numerator[std::move(monomial)] += Integer(term.coefficient) * times;
    }
  }
  return fraction(std::move(numerator), {{{highest}, number}});
}

bool Fraction::is_plain() const {
  return divisors.empty() && is_number(denominator) && denominator.front().coefficient == "1";
}

std::vector<Fraction> fractions(const RationalFunction& value) {
  std::vector<Fraction> result;
  if (value.numerator.empty()) return result;
  if (value.numerator.back().divisors.empty()) return {{value.numerator, value.denominator, {}}};
  const Polynomial below = polynomial(value.denominator);
  for (auto begin = value.numerator.begin(); begin != value.numerator.end();) {
    const auto end = std::find_if(begin, value.numerator.end(), [&](const PolynomialTerm& term) {
      return compare(term.divisors, begin->divisors) != 0;
    });
    Polynomial above;
    for (auto term = begin; term != end; ++term) above[{term->exponents}] += Integer(term->coefficient);
    RationalFunction part = fraction(std::move(above), below);
    result.push_back({std::move(part.numerator), std::move(part.denominator), begin->divisors});
    begin = end;
  }
  return result;
}

bool reads_as_sum(const RationalFunction& value) {
  if (value.numerator.size() < 2) return false;
  if (compare(value.numerator.front().divisors, value.numerator.back().divisors) != 0) return true;
  return value.numerator.front().divisors.empty() && is_number(value.denominator) &&
         value.denominator.front().coefficient == "1";
}

bool vanishes(const RationalFunction& value) {
  const auto residue = [](const std::string& digits) {
    return PrimeFieldComplex(static_cast<std::int64_t>(Integer(Integer(digits) % PrimeFieldComplex::prime)));
  };
  std::vector<PrimeFieldComplex> point;
  std::map<const void*, PrimeFieldComplex> inverses;
  const std::function<PrimeFieldComplex(const std::vector<PolynomialTerm>&)> value_of =
      [&](const std::vector<PolynomialTerm>& terms) {
        PrimeFieldComplex total;
        for (const PolynomialTerm& term : terms) {
          PrimeFieldComplex product = residue(term.coefficient);
          for (std::size_t i = 0; i < term.exponents.size(); ++i) {
            if (point.size() <= i) point.push_back(random_value("symbol", i));
            if (term.exponents[i] > 0) product *= point[i].power(static_cast<std::uint64_t>(term.exponents[i]));
          }
          for (const auto& [sum, power] : term.divisors) {
            const auto [known, added] = inverses.try_emplace(sum.get());
            if (added) known->second = value_of(*sum).inverse();
            product *= known->second.power(static_cast<std::uint64_t>(power));
          }
          total += product;
        }
        return total;
      };
  return value_of(value.numerator).is_zero();
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
    return std::any_of(terms.begin(), terms.end(), [&](const PolynomialTerm& term) {
      return term.exponents[symbol] != 0 ||
             std::any_of(term.divisors.begin(), term.divisors.end(), [&](const DivisorPower& d) {
               return std::any_of(d.sum->begin(), d.sum->end(),
                                  [&](const PolynomialTerm& one) { return one.exponents[symbol] != 0; });
             });
    });
  };
  return occurs(value.numerator) || occurs(value.denominator);
}

}  // namespace secular
