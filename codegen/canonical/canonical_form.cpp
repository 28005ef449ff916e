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
  if (!sums_.sum(imaginary_part(all)).is_zero()) throw std::logic_error("expression is not real");
  return of(sums_.sum(real_part(all)));
}

CanonicalForm::Parts CanonicalForm::parts(const GiNaC::ex& expression) const {
  const FractionTerms all = terms(expression);
  return {of(sums_.sum(real_part(all))), of(sums_.sum(imaginary_part(all)))};
}

const std::vector<PolynomialTerm>& CanonicalForm::denominator(const std::vector<int>& powers,
                                                              const DivisorPowers& divisors) const {
  const auto [known, added] = denominators_.try_emplace({powers, divisors});
  if (added) {
    std::vector<std::size_t> variables;
    for (const auto& [divisor, power] : divisors) variables = united(variables, sums_.variables(divisor));
    known->second = listed(sums_.expanded(divisors, variables), variables, powers, 1);
  }
  return known->second;
}

// Multiplied out, with coprime integer coefficients: divisors are primitive and begin with a positive number, and
// so do their products.
RationalFunction CanonicalForm::of(const FactoredFraction& fraction) const {
  RationalFunction result{{}, {{"1", std::vector<int>(size_, 0)}}};
  if (fraction.is_zero()) return result;
  std::vector<int> above(size_, 0), below(size_, 0);
  for (std::size_t s = 0; s < size_; ++s)
    (fraction.powers[s] > 0 ? above : below)[s] = std::abs(fraction.powers[s]);
  DivisorPowers dividing, multiplying;
  std::vector<std::size_t> variables = fraction.variables;
  for (const auto& [divisor, power] : fraction.divisors) {
    if (power > 0) {
      dividing.emplace_back(divisor, power);
      continue;
    }
    multiplying.emplace_back(divisor, -power);
    variables = united(variables, sums_.variables(divisor));
  }
  const Polynomial numerator = multiplying.empty()
                                   ? fraction.numerator
                                   : in_variables(fraction.numerator, fraction.variables, variables) *
                                         sums_.expanded(multiplying, variables);
  const std::vector<PolynomialTerm>& divisor = denominator(below, dividing);
  terms_ += numerator.size() + divisor.size();
  if (terms_ > most_terms)
    throw PolynomialTooLarge(fmt::format("more than {} terms in all its formulas together", most_terms));
  result.numerator = listed(numerator, variables, above, cln::numerator(fraction.scale));
  result.denominator = divisor;
  const cln::cl_I scale = cln::denominator(fraction.scale);
  if (scale != 1)
    for (PolynomialTerm& term : result.denominator)
      term.coefficient = decimal_digits(cln::cl_I(term.coefficient.c_str()) * scale);
  return result;
}

}  // namespace secular
