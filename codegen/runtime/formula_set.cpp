#include "codegen/runtime/formula_set.hpp"

#include <algorithm>
#include <cstdlib>

namespace secular {

// The number of its inverse among symbols. Its terms stand before those of the formula that asks first.
std::size_t FormulaSet::divisor(const std::shared_ptr<const std::vector<PolynomialTerm>>& sum) {
  std::vector<std::pair<std::string, std::vector<int>>> key;
  for (const PolynomialTerm& term : *sum) key.emplace_back(term.coefficient, term.exponents);
  const auto [known, added] = number_of_.try_emplace(std::move(key), symbols_ + divisors_.size());
  if (added) {
    const std::size_t begin = terms_.size();
    add_terms(*sum);
    divisors_.push_back({begin, terms_.size()});
    highest_power_.push_back(0);
  }
  return known->second;
}

void FormulaSet::add_terms(const std::vector<PolynomialTerm>& terms) {
  for (const PolynomialTerm& term : terms) {
    Term flat{std::strtod(term.coefficient.c_str(), nullptr), factors_.size(), 0};
    const auto add = [&](std::size_t symbol, int power) {
      const auto exponent = static_cast<std::size_t>(power);
      factors_.push_back({symbol, exponent});
      highest_power_[symbol] = std::max(highest_power_[symbol], exponent);
    };
    for (std::size_t s = 0; s < term.exponents.size(); ++s)
      if (term.exponents[s] != 0) add(s, term.exponents[s]);
    for (const auto& [sum, power] : term.divisors) add(divisor(sum), power);
    flat.end = factors_.size();
    terms_.push_back(flat);
  }
}

std::size_t FormulaSet::add(const RationalFunction& formula) {
  for (const PolynomialTerm& term : formula.numerator)  // their terms stand first
    for (const auto& [sum, power] : term.divisors) divisor(sum);
  Formula flat;
  flat.numerator = terms_.size();
  add_terms(formula.numerator);
  flat.denominator = terms_.size();
  flat.divides =
      !formula.is_zero() && !(formula.denominator_is_number() && formula.denominator.front().coefficient == "1");
  if (flat.divides) add_terms(formula.denominator);
  flat.end = terms_.size();
  formulas_.push_back(flat);
  return formulas_.size() - 1;
}

FormulaSet::Values::Values(const FormulaSet& set, const double* symbol_values) : set_(set) {
  stride_ =
      set.highest_power_.empty() ? 0 : *std::max_element(set.highest_power_.begin(), set.highest_power_.end());
  powers_.resize(stride_ * set.highest_power_.size());
  for (std::size_t s = 0; s < set.symbols_; ++s) raise(s, symbol_values[s]);
  for (std::size_t d = 0; d < set.divisors_.size(); ++d)
    raise(set.symbols_ + d, 1 / polynomial(set.divisors_[d].begin, set.divisors_[d].end));
}

void FormulaSet::Values::raise(std::size_t symbol, double value) {
  for (std::size_t n = 0; n < set_.highest_power_[symbol]; ++n)
    powers_[symbol * stride_ + n] = n == 0 ? value : powers_[symbol * stride_ + n - 1] * value;
}

double FormulaSet::Values::polynomial(std::size_t begin, std::size_t end) const {
  double sum = 0;
  for (std::size_t t = begin; t < end; ++t) {
    const Term& term = set_.terms_[t];
    double product = term.coefficient;
    for (std::size_t f = term.begin; f < term.end; ++f)
      product *= powers_[set_.factors_[f].symbol * stride_ + set_.factors_[f].exponent - 1];
    sum += product;
  }
  return sum;
}

double FormulaSet::Values::operator[](std::size_t formula) const {
  const Formula& f = set_.formulas_[formula];
  const double above = polynomial(f.numerator, f.denominator);
  return f.divides ? above / polynomial(f.denominator, f.end) : above;
}

}  // namespace secular
