#include "perturb/time_scales.hpp"

namespace secular {

GiNaC::ex PhaseRates::on_fast_scale(const FieldKey& key) const {
  GiNaC::ex sum = 0;
  for (std::size_t i = 0; i < fast.size(); ++i)
    if (key[i] != 0) sum += key[i] * fast[i];
  return sum.expand();
}

GiNaC::ex PhaseRates::on_slow_scale(const FieldKey& key, int n) const {
  const std::vector<GiNaC::ex>& rates = slow[static_cast<std::size_t>(n)];
  GiNaC::ex sum = 0;
  for (std::size_t i = 0; i < rates.size(); ++i)
    if (key[i] != 0 && !rates[i].is_zero()) sum += key[i] * rates[i];
  return sum.expand();
}

PhaseRates phase_rates(const Model& model, const ResonanceCase& resonance, const ResonanceLattice& lattice,
                       bool resonant) {
  PhaseRates rates;
  rates.layout = {model.modes.size(), model.excitations.size(), resonance.relations.size()};
  const FieldLayout& layout = rates.layout;
  for (std::size_t k = 0; k < layout.modes; ++k) rates.fast.push_back(model.frequency(k));
  for (std::size_t j = 0; j < layout.excitations; ++j)
    rates.fast.push_back(resonant ? lattice.resonant_frequency(j) : model.frequency(layout.modes + j));
  rates.slow.assign(static_cast<std::size_t>(resonance.expand_to) + 1,
                    std::vector<GiNaC::ex>(layout.frequencies() + layout.relations, 0));
  for (std::size_t r = 0; r < layout.relations; ++r) {
    const ResonanceRelation& relation = resonance.relations[r];
    if (relation.detuning.empty() || relation.order > resonance.expand_to) continue;
    const GiNaC::ex& detuning = model.symbols.at(relation.detuning);
    std::vector<GiNaC::ex>& on_scale = rates.slow[static_cast<std::size_t>(relation.order)];
    on_scale[layout.slow(r)] += relation.coefficient * detuning;
    if (!resonant) continue;
    for (std::size_t j = 0; j < layout.excitations; ++j)
      on_scale[layout.modes + j] += lattice.resonant_offset(j)[r] * detuning;
  }
  return rates;
}

Field fast_derivative(const Field& field, const PhaseRates& rates) {
  Field result;
  for (const auto& [key, coefficient] : field.terms()) {
    const GiNaC::ex rate = rates.on_fast_scale(key);
    if (!rate.is_zero()) result.add(key, (coefficient * GiNaC::I * rate).expand());
  }
  return result;
}

Field slow_derivative(const Field& field, int n, const PhaseRates& rates, const AmplitudeRates& amplitude_rates) {
  const FieldLayout& layout = rates.layout;
  Field result;
  for (const auto& term : field.terms()) {
    const auto& key = term.first;  // no structured binding: clang captures none
    const auto& coefficient = term.second;
    const GiNaC::ex rate = rates.on_slow_scale(key, n);
    if (!rate.is_zero()) result.add(key, (coefficient * GiNaC::I * rate).expand());
    for (std::size_t k = 0; k < layout.modes; ++k) {
      const Field& forward = amplitude_rates[k][static_cast<std::size_t>(n)];
      if (forward.empty()) continue;
      const auto chain = [&](std::size_t lowered, int by, const GiNaC::ex& factor, const Field& derivative,
                             std::size_t raised) {
        Field one;
        FieldKey lower = key;
        lower[lowered] -= by;
        if (raised != lowered) ++lower[raised];
        one.add(lower, (coefficient * factor).expand());
        result += one * derivative;
      };
      if (const int power = key[layout.amplitude(k)])
        chain(layout.amplitude(k), 1, power, forward, layout.amplitude(k));
      const int conjugate_power = key[layout.conjugate(k)], modulus_power = key[layout.modulus(k)];
      if (conjugate_power == 0 && modulus_power == 0) continue;
      const Field backward = forward.conjugated(layout);
      if (conjugate_power) chain(layout.conjugate(k), 1, conjugate_power, backward, layout.conjugate(k));
      if (modulus_power) {
        // D|A| = (conj(A) DA + A D conj(A)) / (2|A|)
        const GiNaC::ex half = GiNaC::numeric(modulus_power, 2);
        chain(layout.modulus(k), 2, half, forward, layout.conjugate(k));
        chain(layout.modulus(k), 2, half, backward, layout.amplitude(k));
      }
    }
  }
  return result.with_moduli_joined(layout);
}

Field time_derivative(const FieldSeries& series, int order, const PhaseRates& rates,
                      const AmplitudeRates& amplitude_rates) {
  Field result = fast_derivative(series[static_cast<std::size_t>(order)], rates);
  for (int n = 1; n <= order; ++n) {
    const Field& lower = series[static_cast<std::size_t>(order - n)];
    if (!lower.empty()) result += slow_derivative(lower, n, rates, amplitude_rates);
  }
  return result;
}

}  // namespace secular
