#include "codegen/canonical/canonical_form.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "perturb/factored_fraction.hpp"

namespace secular {
namespace {

std::string digits(const GiNaC::numeric& integer) {
  std::ostringstream stream;
  stream << integer;
  return stream.str();
}

}  // namespace

CanonicalForm::CanonicalForm(const SymbolTable& symbols, const SymbolOrder& order) {
  for (std::size_t i = 0; i < order.size(); ++i)
    place_[order[i] == "pi" ? GiNaC::ex(pi_) : symbols.at(order[i])] = i;
}

// Exponents of the symbols in a product that `taken` accepts; the product of the rest is returned.
template <class Taken>
GiNaC::ex CanonicalForm::split(const GiNaC::ex& product, std::vector<int>& exponents, const Taken& taken) const {
  GiNaC::exvector rest;
  const bool several = GiNaC::is_a<GiNaC::mul>(product);
  for (std::size_t i = 0; i < (several ? product.nops() : 1); ++i) {
    const GiNaC::ex factor = several ? product.op(i) : product;
    const bool power = GiNaC::is_a<GiNaC::power>(factor);
    const auto place = place_.find(power ? factor.op(0) : factor);
    if (place == place_.end() || !taken(place->second) || (power && !factor.op(1).info(GiNaC::info_flags::posint)))
      rest.push_back(factor);
    else
      exponents[place->second] += power ? GiNaC::ex_to<GiNaC::numeric>(factor.op(1)).to_int() : 1;
  }
  return GiNaC::mul(rest);
}

// Adds an expanded polynomial times the monomial `common`.
void CanonicalForm::add_terms(const GiNaC::ex& expanded, const std::vector<int>& common, Terms& terms) const {
  const bool is_sum = GiNaC::is_a<GiNaC::add>(expanded);
  for (std::size_t i = 0; i < (is_sum ? expanded.nops() : 1); ++i) {
    std::vector<int> exponents = common;
    const GiNaC::ex rest = split(is_sum ? expanded.op(i) : expanded, exponents, [](std::size_t) { return true; });
    if (!GiNaC::is_a<GiNaC::numeric>(rest) || !GiNaC::ex_to<GiNaC::numeric>(rest).is_rational())
      throw std::logic_error("expression is not rational in its declared symbols");
    const auto [position, added] = terms.try_emplace(std::move(exponents), GiNaC::ex_to<GiNaC::numeric>(rest));
    if (!added) position->second = position->second + GiNaC::ex_to<GiNaC::numeric>(rest);
  }
}

// Symbols in what has a negative exponent.
void CanonicalForm::mark_denominators(const GiNaC::ex& expression, std::vector<bool>& marked) const {
  if (GiNaC::is_a<GiNaC::power>(expression) && expression.op(1).info(GiNaC::info_flags::negative)) {
    for (GiNaC::const_preorder_iterator part = expression.preorder_begin(); part != expression.preorder_end();
         ++part)
      if (const auto place = place_.find(*part); place != place_.end()) marked[place->second] = true;
    return;
  }
  if (GiNaC::is_a<GiNaC::add>(expression) || GiNaC::is_a<GiNaC::mul>(expression))
    for (std::size_t i = 0; i < expression.nops(); ++i) mark_denominators(expression.op(i), marked);
}

// By the factors of denominators as they stand; false, and nothing is added, where they are not all seen.
bool CanonicalForm::add_factored(const Groups& groups, Terms& above, Terms& below) const {
  FractionSums sums;
  std::vector<std::pair<const std::vector<int>*, FactoredFraction>> fractions;
  FactorPowers denominator;
  for (const auto& [common, parts] : groups) {
    std::optional<FactoredFraction> fraction = sums.sum(parts);
    if (!fraction) return false;
    for (const auto& [factor, power] : fraction->denominator)
      denominator[factor] = std::max(denominator[factor], power);
    fractions.emplace_back(&common, std::move(*fraction));
  }
  for (const auto& [common, fraction] : fractions) {
    FactorPowers missing = denominator;
    for (const auto& [factor, power] : fraction.denominator) missing[factor] -= power;
    if (!fraction.numerator.is_zero()) add_terms(expanded_product(fraction.numerator, missing), *common, above);
  }
  add_terms(expanded_product(1, denominator), std::vector<int>(place_.size(), 0), below);
  return true;
}

// N/D without common factors. Symbols that are in no denominator take no part in the search for common factors:
// with x = sum of m_g N_g/D_g over their monomials m_g, each N_g/D_g in lowest terms, D = lcm(D_g) and N = sum of
// m_g N_g D/D_g, a prime factor of D is in full power in some D_g: neither in its D/D_g nor in its N_g, so that it
// does not divide N.
void CanonicalForm::lowest_terms(const GiNaC::ex& expanded, Terms& above, Terms& below) const {
  std::vector<bool> in_denominator(place_.size(), false);
  mark_denominators(expanded, in_denominator);
  const std::vector<int> unity(place_.size(), 0);
  Groups groups;
  const bool is_sum = GiNaC::is_a<GiNaC::add>(expanded);
  for (std::size_t i = 0; i < (is_sum ? expanded.nops() : 1); ++i) {
    std::vector<int> exponents = unity;
    const GiNaC::ex rest = split(is_sum ? expanded.op(i) : expanded, exponents,
                                 [&](std::size_t symbol) { return !in_denominator[symbol]; });
    groups[std::move(exponents)].push_back(rest);
  }
  if (add_factored(groups, above, below)) return;
  struct Fraction {
    const std::vector<int>* common;
    GiNaC::ex above, below;
  };
  std::vector<Fraction> fractions;
  GiNaC::ex denominator = 1;
  std::set<GiNaC::ex, GiNaC::ex_is_less> contained;
  for (const auto& [common, parts] : groups) {
    const GiNaC::ex fraction = GiNaC::ex(GiNaC::add(parts)).numer_denom();
    fractions.push_back({&common, fraction.op(0), fraction.op(1).expand()});
    if (contained.insert(fractions.back().below).second)
      denominator = GiNaC::lcm(denominator, fractions.back().below);
  }
  denominator = denominator.expand();
  for (const Fraction& fraction : fractions) {
    GiNaC::ex factor;
    if (!GiNaC::divide(denominator, fraction.below, factor))
      throw std::logic_error("a common denominator is no multiple of one of its own");
    add_terms((fraction.above * factor).expand(), *fraction.common, above);
  }
  add_terms(denominator, unity, below);
}

namespace {

// Terms divided by their content (positive).
std::vector<PolynomialTerm> primitive(const std::map<std::vector<int>, GiNaC::numeric, std::greater<>>& terms,
                                      GiNaC::numeric& content) {
  GiNaC::numeric common_divisor = 0, common_multiple = 1;
  for (const auto& [exponents, coefficient] : terms) {
    common_divisor = GiNaC::gcd(common_divisor, coefficient.numer());
    common_multiple = GiNaC::lcm(common_multiple, coefficient.denom());
  }
  content = common_divisor.is_zero() ? GiNaC::numeric(1) : common_divisor / common_multiple;
  std::vector<PolynomialTerm> result;
  for (const auto& [exponents, coefficient] : terms)
    if (!coefficient.is_zero()) result.push_back({digits(coefficient / content), exponents});
  return result;
}

}  // namespace

RationalFunction CanonicalForm::of(const GiNaC::ex& expression) const {
  const RationalFunction zero{{}, {{"1", std::vector<int>(place_.size(), 0)}}};
  const GiNaC::ex expanded = expression.subs(GiNaC::Pi == pi_).expand();
  if (expanded.is_zero()) return zero;
  Terms numerator, denominator;
  lowest_terms(expanded, numerator, denominator);
  GiNaC::numeric above, below;
  RationalFunction result;
  result.numerator = primitive(numerator, above);
  result.denominator = primitive(denominator, below);
  if (result.numerator.empty()) return zero;
  GiNaC::numeric scale = above / below;
  if (result.denominator.front().coefficient.front() == '-') {
    scale = -scale;
    for (PolynomialTerm& term : result.denominator)
      term.coefficient = term.coefficient.front() == '-' ? term.coefficient.substr(1) : "-" + term.coefficient;
  }
  const auto multiply = [](std::vector<PolynomialTerm>& terms, const GiNaC::numeric& factor) {
    for (PolynomialTerm& term : terms) term.coefficient = digits(GiNaC::numeric(term.coefficient.c_str()) * factor);
  };
  multiply(result.numerator, scale.numer());
  multiply(result.denominator, scale.denom());
  return result;
}

}  // namespace secular
