#include "codegen/runtime/formula_set.hpp"

#include <algorithm>
#include <cstdlib>

namespace secular {

void FormulaSet::add_terms(const std::vector<PolynomialTerm>& terms) {
  for (const PolynomialTerm& term : terms) {
    Term flat{std::strtod(term.coefficient.c_str(), nullptr), factors_.size(), 0};
    for (std::size_t s = 0; s < term.exponents.size(); ++s) {
      if (term.exponents[s] == 0) continue;
      const auto exponent = static_cast<std::size_t>(term.exponents[s]);
      factors_.push_back({s, exponent});
      highest_power_[s] = std::max(highest_power_[s], exponent);
    }
    flat.end = factors_.size();
    terms_.push_back(flat);
  }
}

std::size_t FormulaSet::add(const RationalFunction& formula) {
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
  for (std::size_t s = 0; s < set.highest_power_.size(); ++s)
    for (std::size_t n = 0; n < set.highest_power_[s]; ++n)
      powers_[s * stride_ + n] = n == 0 ? symbol_values[s] : powers_[s * stride_ + n - 1] * symbol_values[s];
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
