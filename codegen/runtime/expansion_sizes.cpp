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
      tells_rates_(resonance.quadratures.empty()),
      formulas_(model.order.size()),
      rest_values_(model) {
  for (const std::string& name : model.parameters)
    symbol_of_parameter_.push_back(
        static_cast<std::size_t>(std::find(model.order.begin(), model.order.end(), name) - model.order.begin()));
  const auto add = [&](std::vector<Term>& to, std::size_t mode, const std::vector<CanonicalTerm>& terms) {
    for (const CanonicalTerm& term : terms)
      to.push_back({mode, static_cast<std::size_t>(term.order), formulas_.add(term.real),
                    formulas_.add(term.imaginary), degree(term.powers), Monomial(term.powers)});
  };
  for (std::size_t k = 0; k < modes_; ++k) {
    add(displacement_, k, resonance.harmonics[k]);
    add(rate_, k, resonance.slow_derivative[k]);
  }
  linear_when_small_ = std::none_of(rate_.begin(), rate_.end(), [](const Term& term) { return term.degree < 1; });
}

template <class Counts>
std::vector<std::vector<double>> ExpansionSizes::sizes(const std::vector<Term>& terms, const State& state,
                                                       const Counts& counts) const {
  std::vector<double> symbols(symbols_, 0.0);
  symbols.back() = std::numbers::pi;
  for (std::size_t p = 0; p < symbol_of_parameter_.size(); ++p)
    symbols[symbol_of_parameter_[p]] = state.parameters[p];
  rest_values_.fill(symbols.data());
  if (state.excitation_frequency)
    std::copy_n(state.excitation_frequency, excitations_, symbols.begin() + static_cast<std::ptrdiff_t>(modes_));
  const FormulaSet::Values value(formulas_, symbols.data());
  std::vector<std::vector<double>> result(modes_, std::vector<double>(last_ + 1, 0.0));
  for (const Term& term : terms)
    if (term.order <= last_ && counts(term))
      result[term.mode][term.order] += std::hypot(value[term.real], value[term.imaginary]) *
                                       std::abs(term.monomial(state.amplitude, state.forcing));
  return result;
}

bool ExpansionSizes::outside(const State& state) const {
  std::vector<std::vector<double>> all =
      sizes(displacement_, state, [&](const Term& term) { return term.order < last_ || term.degree > 1; });
  for (std::size_t k = 0; k < modes_; ++k) all[k][0] += std::abs(state.amplitude[k]);
  return std::any_of(all.begin(), all.end(), [](const std::vector<double>& of_mode) {
    return of_mode.back() > *std::max_element(of_mode.begin(), of_mode.end() - 1);
  });
}

template <class Counts>
std::vector<double> ExpansionSizes::largest_order(const State& state, const Counts& counts) const {
  std::vector<double> largest;
  for (const std::vector<double>& orders : sizes(rate_, state, counts))
    largest.push_back(*std::max_element(orders.begin(), orders.end()));
  return largest;
}

double ExpansionSizes::rest_size(const State& state) const {
  double sum = 0;
  for (const std::vector<double>& orders : sizes(displacement_, state, [](const Term& t) { return t.degree == 0; }))
    for (const double size : orders) sum += size;
  return sum;
}

std::vector<double> ExpansionSizes::all_rates(const State& state) const {
  return largest_order(state, [](const Term&) { return true; });
}

std::vector<double> ExpansionSizes::largest_rates(const State& state) const {
  std::vector<double> result = largest_order(state, [](const Term& term) { return term.degree != 1; });
  if (std::find(result.begin(), result.end(), 0.0) == result.end()) return result;
  const std::vector<double> all = all_rates(state);
  for (std::size_t k = 0; k < modes_; ++k)
    if (result[k] == 0) result[k] = all[k];
  return result;
}

}  // namespace secular
