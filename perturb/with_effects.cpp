#include "perturb/with_effects.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>
#include <utility>

#include "input/input_error.hpp"
#include "perturb/term_sum.hpp"

namespace secular {
namespace {

using Placeholders = std::map<std::string, std::string>;

std::string filled(std::string_view pattern, const Placeholders& values) {
  std::string text;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] != '{') {
      text += pattern[i];
      continue;
    }
    const std::size_t end = pattern.find('}', i);
    text += values.at(std::string(pattern.substr(i + 1, end - i - 1)));
    i = end;
  }
  return text;
}

class Augmentation {
 public:
  explicit Augmentation(const Model& model) : model_(model) {
    for (const std::string& name : model_.symbols.names()) taken_.insert(name);
    for (const Mode& mode : model_.modes) taken_.insert(mode.coordinate);
    for (const Shorthand& shorthand : model_.shorthands) taken_.insert(shorthand.name);
  }

  AddedEffect add(const EffectTerm& term) {
    if (term.effect == "extra_mode") return extra_mode(term);
    const CatalogueEntry* entry = find_catalogue_entry(term.effect, term.form);
    if (entry == nullptr) refuse(term, "is not in the catalogue of equation-of-motion terms");
    if (term.mode >= model_.modes.size()) refuse(term, "names a mode that the model does not have");
    if (entry->couples && (term.other >= model_.modes.size() || term.other == term.mode))
      refuse(term, "needs another mode of the model");
    AddedEffect added{term, {}, EffectTerm::none, EffectTerm::none};
    const std::string& v = model_.modes[term.mode].coordinate;
    Placeholders values{{"v", v}, {"w", model_.modes[term.mode].frequency}};
    std::string suffix = "_" + v;
    if (entry->couples) {
      values["u"] = model_.modes[term.other].coordinate;
      suffix += "_" + values["u"];
    }
    if (entry->term.find("{F}") != std::string_view::npos) values["F"] = first_excitation(term);
    if (entry->memory != CatalogueEntry::Memory::none) {
      const bool time = entry->memory == CatalogueEntry::Memory::time;
      const bool slider = entry->memory == CatalogueEntry::Memory::elastic_displacement ||
                          entry->memory == CatalogueEntry::Memory::spread_displacement ||
                          entry->memory == CatalogueEntry::Memory::smooth_displacement;
      added.memory = add_excitation((time ? "time" : slider ? "z" : "law_" + std::string(entry->effect)) + suffix);
      values["s"] = excitation_text(added.memory);
    }
    std::istringstream stems{std::string(entry->parameters)};
    for (std::string stem; stems >> stem;) {
      const int order = added.parameters.empty() ? -1 : 0;
      added.parameters.push_back(add_parameter(stem + suffix));
      values[std::to_string(added.parameters.size() - 1)] = added.parameters.back();
      for (ResonanceCase& resonance : model_.cases) {
        resonance.order[added.parameters.back()] = order == 0 ? 0 : strength_order(*entry, term, resonance);
        resonance.may_act_nowhere.insert(added.parameters.back());
      }
    }
    append(model_.modes[term.mode], filled(entry->term, values));
    if (!entry->other_term.empty()) append(model_.modes[term.other], filled(entry->other_term, values));
    return added;
  }

  Model take() { return std::move(model_); }

 private:
  [[noreturn]] void refuse(const EffectTerm& term, const std::string& wrong) const {
    throw InputError(model_.file, "effect " + term.effect, wrong, "applicable effects are those of the catalogue");
  }

  std::string free(std::string name) {
    while (!taken_.insert(name).second) name += '_';
    return name;
  }

  std::string add_parameter(const std::string& wanted) {
    std::string name = free(wanted);
    model_.symbols.add_real(name);
    model_.parameters.push_back(name);
    return name;
  }

  std::size_t add_excitation(const std::string& wanted) {
    Excitation excitation{free(wanted), free("Omega_" + wanted)};
    model_.symbols.add_positive(excitation.frequency);
    model_.symbols.add_positive(excitation.amplitude);
    model_.excitations.push_back(std::move(excitation));
    for (ResonanceCase& resonance : model_.cases)
      for (ResonanceRelation& relation : resonance.relations)
        relation.multiples.resize(model_.frequency_count(), 0);
    return model_.excitations.size() - 1;
  }

  std::string excitation_text(std::size_t index) const {
    const Excitation& excitation = model_.excitations[index];
    return excitation.amplitude + "*cos(" + excitation.frequency + "*t)";
  }

  std::string first_excitation(const EffectTerm& term) const {
    if (model_.excitations.empty()) refuse(term, "needs an excitation, which the model does not have");
    return excitation_text(0);
  }

  // Text and formula stay the same thing.
  static void append(FormulaSource& source, const std::string& term) { source.text += "\n  " + term; }
  static void append(Mode& mode, const std::string& term) {
    append(mode.source, term);
    if (mode.equation)
      mode.equation = parse_equation(mode.source);
    else
      mode.force = parse_expression(mode.source);
  }

  // Excitation resonant through this term: Omega = omega_v (direct), 2 omega_v (parametric), omega_v +- omega_u.
  bool resonant(const EffectTerm& term, const CatalogueEntry& entry, const ResonanceCase& resonance) const {
    const bool parametric = entry.term.find("{v}") != std::string_view::npos;
    return std::any_of(resonance.relations.begin(), resonance.relations.end(), [&](const ResonanceRelation& r) {
      std::vector<int> wanted(model_.frequency_count(), 0), sizes;
      wanted[model_.modes.size()] = 1;
      wanted[term.mode] = parametric ? 2 : 1;
      if (entry.couples) wanted[term.other] = 1;
      for (const int multiple : r.multiples) sizes.push_back(std::abs(multiple));
      sizes.resize(wanted.size(), 0);
      return sizes == wanted;
    });
  }

  int strength_order(const CatalogueEntry& entry, const EffectTerm& term, const ResonanceCase& resonance) const {
    int order = 0;
    switch (entry.order) {
      case CatalogueEntry::Order::first:
        order = 1;
        break;
      case CatalogueEntry::Order::second:
        order = 2;
        break;
      case CatalogueEntry::Order::last:
        order = resonance.expand_to;
        break;
      case CatalogueEntry::Order::unless_resonant:
        order = resonant(term, entry, resonance) ? resonance.expand_to : 1;
        break;
      case CatalogueEntry::Order::outside:
        return resonance.expand_to + 1;
    }
    order = std::min(order, resonance.expand_to);
    return resonance.degree_ordering ? std::max(0, order - (entry.degree - 1)) : order;
  }

  AddedEffect extra_mode(const EffectTerm& term) {
    const std::string drive = first_excitation(term);
    const std::size_t index = model_.modes.size();
    Mode mode;
    mode.coordinate = free("extra");
    const std::string& x = mode.coordinate;
    mode.frequency = free("omega_" + x);
    model_.symbols.add_positive(mode.frequency);
    const std::string strength = add_parameter("eta1_" + x), damping = add_parameter("mu1_" + x);
    const std::string force = "-2*" + damping + "*D(" + x + ") + " + strength + "*" + drive;
    mode.source = {force, model_.file, 1};
    if (model_.lagrangian) {
      Lagrangian& lagrangian = *model_.lagrangian;
      append(lagrangian.kinetic_source, "+ D(" + x + ")^2/2");
      append(lagrangian.potential_source, "+ " + mode.frequency + "^2*" + x + "^2/2");
      lagrangian.kinetic = parse_expression(lagrangian.kinetic_source);
      lagrangian.potential = parse_expression(lagrangian.potential_source);
      mode.force = parse_expression(mode.source);
    } else {
      mode.source.text = "D2(" + x + ") + " + mode.frequency + "^2*" + x + " = " + force;
      mode.equation = parse_equation(mode.source);
    }
    const AddedEffect added{term, {strength, mode.frequency, damping}, EffectTerm::none, index};
    model_.modes.push_back(std::move(mode));
    for (ResonanceCase& resonance : model_.cases) {
      resonance.mode_at_rest.push_back(true);
      resonance.order[strength] = 1;
      resonance.order[damping] = std::min(2, resonance.expand_to);
      for (ResonanceRelation& relation : resonance.relations)
        relation.multiples.insert(relation.multiples.begin() + static_cast<std::ptrdiff_t>(index), 0);
    }
    return added;
  }

  Model model_;
  std::set<std::string> taken_;
};

}  // namespace

AugmentedModel with_effects(const Model& model, std::span<const EffectTerm> effects) {
  Augmentation augmentation(model);
  AugmentedModel result;
  for (const EffectTerm& effect : effects) result.effects.push_back(augmentation.add(effect));
  result.model = augmentation.take();
  return result;
}

}  // namespace secular
