#include "perturb/small_divisors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace secular {
namespace {

/// Nearer than this share of the natural frequency a term is nearly resonant.
constexpr double nearly_resonant = 0.05;

/// Nominal value of a frequency, of an excitation that has none the one that the relations give it; else NaN.
double nominal_frequency(const Derivation& d, std::size_t index) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  const Model& model = *d.model;
  const auto given = [&](std::size_t i) {
    const auto entry = model.nominal.find(model.frequency_name(i));
    return entry == model.nominal.end() ? unknown : entry->second;
  };
  const double value = given(index);
  if (index < model.modes.size() || !std::isnan(value)) return value;
  GiNaC::exmap numbers;
  for (std::size_t k = 0; k < model.modes.size(); ++k)
    if (!std::isnan(given(k))) numbers[model.frequency(k)] = given(k);
  const GiNaC::ex resonant = d.lattice.resonant_frequency(index - model.modes.size()).subs(numbers).evalf();
  return GiNaC::is_a<GiNaC::numeric>(resonant) ? GiNaC::ex_to<GiNaC::numeric>(resonant).to_double() : unknown;
}

std::string listed_relations(const ResonanceCase& resonance) {
  std::string list;
  for (const ResonanceRelation& relation : resonance.relations) list += "\"" + relation.text + "\", ";
  return list;
}

// The relation that a near resonance phase.f = omega_k (or -omega_k) lacks, solved for its last frequency.
std::string missing_relation(const Derivation& d, Phase relation, std::size_t k, bool opposite) {
  if (opposite)
    for (int& multiple : relation) multiple = -multiple;
  --relation[k];
  std::size_t last = relation.size() - 1;
  while (last > 0 && relation[last] == 0) --last;
  if (relation[last] > 0)
    for (int& multiple : relation) multiple = -multiple;
  std::string right;
  for (std::size_t i = 0; i < last; ++i) {
    if (relation[i] == 0) continue;
    right += (relation[i] < 0 ? (right.empty() ? "-" : " - ") : (right.empty() ? "" : " + "));
    right += (std::abs(relation[i]) == 1 ? "" : std::to_string(std::abs(relation[i])) + "*") +
             d.model->frequency_name(i);
  }
  std::string detuning = "sigma";
  for (int n = 2; d.model->symbols.contains(detuning); ++n) detuning = "sigma" + std::to_string(n);
  return fmt::format("{}{} = {} + eps^{}*{}", relation[last] == -1 ? "" : std::to_string(-relation[last]) + "*",
                     d.model->frequency_name(last), right, d.resonance->expand_to, detuning);
}

}  // namespace

std::vector<std::string> small_divisor_warnings(const Derivation& d) {
  std::vector<double> nominal;
  for (std::size_t i = 0; i < d.layout.frequencies(); ++i) nominal.push_back(nominal_frequency(d, i));
  std::vector<std::string> warnings;
  for (std::size_t n = 1; n <= static_cast<std::size_t>(d.resonance->expand_to); ++n)
    for (std::size_t k = 0; k < d.layout.modes; ++k)
      for (const auto& [key, coefficient] : d.response[k][n].terms()) {
        const Phase phase = d.full_phase(key);
        double frequency = 0;
        for (std::size_t i = 0; i < phase.size(); ++i)
          if (phase[i] != 0) frequency += phase[i] * nominal[i];
        const double ratio = 1 - std::abs(frequency) / nominal[k];
        if (!(std::abs(ratio) < nearly_resonant)) continue;
        std::string text;
        for (std::size_t i = 0; i < phase.size(); ++i)
          if (phase[i] != 0)
            text += fmt::format("{}{}*{}", phase[i] < 0 ? " - " : (text.empty() ? "" : " + "), std::abs(phase[i]),
                                d.model->frequency_name(i));
        const std::string warning = fmt::format(
            "at order eps^{} the phase {} excites mode {} within {:.1f} % of its natural frequency: its small "
            "divisor makes the expansion unreliable. If it is a resonance, list it: relations = [{}\"{}\"]",
            n, text, d.model->modes[k].coordinate, 100 * std::abs(ratio), listed_relations(*d.resonance),
            missing_relation(d, phase, k, frequency < 0));
        if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end()) warnings.push_back(warning);
      }
  return warnings;
}

}  // namespace secular
