#include "perturb/true_time_variables.hpp"

#include <cmath>

namespace secular {

bool has_odd_modulus(const TrueTimePowers& powers, const TrueTimeVariables& variables) {
  for (std::size_t k = 0; k < variables.modes; ++k)
    if (powers[variables.modulus(k)] % 2 != 0) return true;
  return false;
}

TrueTimePowers normal_form(TrueTimePowers powers, const TrueTimeVariables& variables) {
  for (std::size_t k = 0; k < variables.modes; ++k) {
    auto& modulus = powers[variables.modulus(k)];
    const int odd = std::abs(modulus % 2), pairs = (modulus - odd) / 2;
    for (const std::size_t at : {variables.amplitude(k), variables.conjugate(k)}) powers[at] += pairs;
    modulus = odd;
  }
  powers[variables.degree()] = 0;
  powers[variables.functions()] = 0;
  return powers;
}

std::string to_string(const TrueTimePowers& powers, const Model& model) {
  const TrueTimeVariables variables{model.frequency_count(), model.modes.size()};
  std::string product, phase;
  const auto factor = [&](const std::string& name, int power) {
    if (power == 0) return;
    product += (product.empty() ? "" : "*") + name + (power == 1 ? "" : "^" + std::to_string(power));
  };
  for (std::size_t k = 0; k < model.modes.size(); ++k) {
    factor("A_" + model.modes[k].coordinate, powers[variables.amplitude(k)]);
    factor("conj(A_" + model.modes[k].coordinate + ")", powers[variables.conjugate(k)]);
    factor("abs(A_" + model.modes[k].coordinate + ")", powers[variables.modulus(k)]);
  }
  for (std::size_t i = 0; i < model.frequency_count(); ++i) {
    if (powers[i] == 0) continue;
    phase += (powers[i] < 0 ? "-" : (phase.empty() ? "" : "+")) +
             (std::abs(powers[i]) == 1 ? "" : std::to_string(std::abs(powers[i])) + "*") + model.frequency_name(i);
  }
  return (product.empty() ? "" : product + "*") + "exp(i*(" + (phase.empty() ? "0" : phase) + ")*t)";
}

std::map<TrueTimePowers, std::complex<double>> at_amplitudes(
    const std::map<TrueTimePowers, std::complex<double>>& terms, const TrueTimeVariables& variables,
    const std::vector<std::complex<double>>& amplitudes) {
  std::map<TrueTimePowers, std::complex<double>> harmonics;
  for (const auto& [powers, value] : terms) {
    std::complex<double> whole = value;
    for (std::size_t k = 0; k < variables.modes; ++k) {
      const std::complex<double> a = amplitudes[k];
      whole *= std::pow(a, powers[variables.amplitude(k)]) *
               std::pow(std::conj(a), powers[variables.conjugate(k)]) *
               std::pow(std::abs(a), powers[variables.modulus(k)]);
    }
    harmonics[TrueTimePowers(powers.begin(),
                             powers.begin() + static_cast<std::ptrdiff_t>(variables.frequencies))] += whole;
  }
  return harmonics;
}

}  // namespace secular
