#include "codegen/canonical/canonical_form.hpp"

#include <cln/integer_io.h>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace secular {

std::string decimal_digits(const cln::cl_I& integer) {
  if (cln::integer_length(integer) < 62) return std::to_string(cln::cl_I_to_long(integer));
  std::ostringstream stream;
  stream << integer;
  return stream.str();
}

namespace {

GiNaC::exvector in_order(const SymbolTable& symbols, const SymbolOrder& order) {
  GiNaC::exvector list;
  for (const std::string& name : order) list.push_back(name == "pi" ? GiNaC::ex(GiNaC::Pi) : symbols.at(name));
  return list;
}

// scale * monomial * polynomial, as a list in the order of all symbols: multiplying by a monomial keeps the order.
std::vector<PolynomialTerm> listed(const Polynomial& polynomial, const std::vector<std::size_t>& variables,
                                   const std::vector<int>& monomial, const cln::cl_I& scale) {
  std::vector<PolynomialTerm> terms;
  terms.reserve(polynomial.size());
  for (std::size_t t = 0; t < polynomial.size(); ++t) {
    terms.push_back({decimal_digits(scale * polynomial.coefficient(t)), monomial});
    for (std::size_t v = 0; v < variables.size(); ++v)
      terms.back().exponents[variables[v]] += polynomial.power(t, v);
  }
  return terms;
}

}  // namespace

CanonicalForm::CanonicalForm(const SymbolTable& symbols, const SymbolOrder& order)
    : size_(order.size()), sums_(in_order(symbols, order)) {}

FractionTerms CanonicalForm::terms(const GiNaC::ex& expression) const {
  std::optional<FractionTerms> terms = sums_.terms(expression);
  if (!terms) terms = sums_.terms(expression.expand());
  if (!terms) throw std::logic_error("expression is not rational in its declared symbols");
  return std::move(*terms);
}

RationalFunction CanonicalForm::of(const GiNaC::ex& expression) const {
  const FractionTerms all = terms(expression);
  if (!of(imaginary_part(all)).is_zero()) throw std::logic_error("expression is not real");
  return of(real_part(all));
}

CanonicalForm::Parts CanonicalForm::parts(const GiNaC::ex& expression) const {
  const FractionTerms all = terms(expression);
  return {of(real_part(all)), of(imaginary_part(all))};
}

RationalFunction CanonicalForm::of(const FractionTerms& terms) const {
  std::vector<bool> divides(size_, false);
  for (const FractionTerm& term : terms)
    for (const auto& [divisor, power] : term.divisors)
      for (const std::size_t variable : sums_.variables(divisor)) divides[variable] = true;
  std::map<std::vector<int>, FractionTerms> groups;
  for (const FractionTerm& term : terms) {
    std::vector<int> others(size_, 0);  // without any divisor, all together
    if (std::find(divides.begin(), divides.end(), true) != divides.end())
      for (std::size_t s = 0; s < size_; ++s)
        if (!divides[s]) others[s] = term.powers[s];
    groups[std::move(others)].push_back(term);
  }
  std::vector<FactoredFraction> fractions;
  for (const auto& [others, group] : groups)
    for (FactoredFraction& part : sums_.parts(group)) fractions.push_back(std::move(part));
  return of(fractions);
}

RationalFunction CanonicalForm::of(const std::vector<FactoredFraction>& parts) const {
  std::vector<RationalFunction> fractions;
  for (const FactoredFraction& part : parts) fractions.push_back(of(part));
  if (fractions.empty()) return {{}, {{"1", std::vector<int>(size_, 0)}}};
  return sum(fractions);
}

const DivisorPower& CanonicalForm::divisor(std::size_t number) const {
  const auto [known, added] = divisors_.try_emplace(number);
  if (added)
    known->second = {std::make_shared<const std::vector<PolynomialTerm>>(
                         listed(sums_.divisor(number), sums_.variables(number), std::vector<int>(size_, 0), 1)),
                     1};
  return known->second;
}

// Over integers, powers of symbols and divisors; divisors that multiply are multiplied out.
RationalFunction CanonicalForm::of(const FactoredFraction& fraction) const {
  RationalFunction result{{}, {{"1", std::vector<int>(size_, 0)}}};
  if (fraction.is_zero()) return result;
  std::vector<int> above(size_, 0), below(size_, 0);
  for (std::size_t s = 0; s < size_; ++s)
    (fraction.powers[s] > 0 ? above : below)[s] = std::abs(fraction.powers[s]);
  std::vector<DivisorPower> dividing;
  DivisorPowers multiplying;
  std::vector<std::size_t> variables = fraction.variables;
  for (const auto& [number, power] : fraction.divisors) {
    if (power > 0) {
      dividing.push_back({divisor(number).sum, power});
      continue;
    }
    multiplying.emplace_back(number, -power);
    variables = united(variables, sums_.variables(number));
  }
  std::sort(dividing.begin(), dividing.end(),
            [](const DivisorPower& a, const DivisorPower& b) { return compare(*a.sum, *b.sum) < 0; });
  const Polynomial numerator = multiplying.empty()
                                   ? fraction.numerator
                                   : in_variables(fraction.numerator, fraction.variables, variables) *
                                         sums_.expanded(multiplying, variables);
  terms_ += numerator.size();
  if (terms_ > most_terms)
    throw PolynomialTooLarge(fmt::format("more than {} terms in all its formulas together", most_terms));
  result.numerator = listed(numerator, variables, above, cln::numerator(fraction.scale));
  for (PolynomialTerm& term : result.numerator) term.divisors = dividing;
  result.denominator.front() = {decimal_digits(cln::denominator(fraction.scale)), std::move(below)};
  return result;
}

}  // namespace secular
