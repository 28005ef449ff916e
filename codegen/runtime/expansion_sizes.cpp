#include "codegen/runtime/expansion_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace secular {
namespace {

int degree(const CanonicalPowers& powers) {
  int sum = 0;
  for (const auto* list : {&powers.amplitude, &powers.conjugate, &powers.modulus, &powers.forcing})
    sum = std::accumulate(list->begin(), list->end(), sum);
  return sum;
}

}  // namespace

ExpansionSizes::ExpansionSizes(const CanonicalModel& model, const CanonicalCase& resonance)
    : modes_(model.coordinates.size()),
      excitations_(model.excitations.size()),
      symbols_(model.order.size()),
      last_(static_cast<std::size_t>(resonance.expand_to)),
      formulas_(model.order.size()) {
  for (const std::string& name : model.parameters)
    symbol_of_parameter_.push_back(
        static_cast<std::size_t>(std::find(model.order.begin(), model.order.end(), name) - model.order.begin()));
  for (std::size_t k = 0; k < modes_; ++k)
    for (const CanonicalTerm& term : resonance.harmonics[k])
      terms_.push_back({k, static_cast<std::size_t>(term.order), formulas_.add(term.real),
                        formulas_.add(term.imaginary), degree(term.powers) > 1, Monomial(term.powers)});
}

bool ExpansionSizes::outside(const State& state) const {
  std::vector<double> symbols(symbols_, 0.0);
  symbols.back() = std::numbers::pi;
  for (std::size_t p = 0; p < symbol_of_parameter_.size(); ++p)
    symbols[symbol_of_parameter_[p]] = state.parameters[p];
  if (state.excitation_frequency)
    std::copy_n(state.excitation_frequency, excitations_, symbols.begin() + static_cast<std::ptrdiff_t>(modes_));
  const FormulaSet::Values value(formulas_, symbols.data());
  std::vector<std::vector<double>> sizes(modes_, std::vector<double>(last_ + 1, 0.0));
  for (std::size_t k = 0; k < modes_; ++k) sizes[k][0] = std::abs(state.amplitude[k]);
  for (const Term& term : terms_)
    if (term.order < last_ || (term.order == last_ && term.nonlinear))
      sizes[term.mode][term.order] += std::hypot(value[term.real], value[term.imaginary]) *
                                      std::abs(term.monomial(state.amplitude, state.forcing));
  return std::any_of(sizes.begin(), sizes.end(), [](const std::vector<double>& of_mode) {
    return of_mode.back() > *std::max_element(of_mode.begin(), of_mode.end() - 1);
  });
}

}  // namespace secular
