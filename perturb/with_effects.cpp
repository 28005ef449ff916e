#include "perturb/with_effects.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>
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
  Augmentation(const Model& model, const EffectCatalogue& catalogue) : model_(model), catalogue_(catalogue) {
    for (const std::string& name : model_.symbols.names()) taken_.insert(name);
    for (const Mode& mode : model_.modes) taken_.insert(mode.coordinate);
    for (const Shorthand& shorthand : model_.shorthands) taken_.insert(shorthand.name);
  }

  AddedEffect add(const EffectTerm& term) {
    const Effect* effect = catalogue_.find(term.effect);
    if (effect && effect->kind == Effect::Kind::extra_mode) return extra_mode(term);
    const EffectForm* form = catalogue_.find_form(term.effect, term.form);
    if (form == nullptr) refuse(term, "is not in the catalogue of equation-of-motion terms");
    if (term.mode >= model_.modes.size()) refuse(term, "names a mode that the model does not have");
    if (form->couples() && (term.other >= model_.modes.size() || term.other == term.mode))
      refuse(term, "needs another mode of the model");
    AddedEffect added{term, {}, EffectTerm::none, EffectTerm::none};
    const std::string& v = model_.modes[term.mode].coordinate;
    Placeholders values{{"v", v}, {"w", model_.modes[term.mode].frequency}};
    std::string suffix = "_" + v;
    if (form->couples()) {
      values["u"] = model_.modes[term.other].coordinate;
      suffix += "_" + values["u"];
    }
    if (form->needs_excitation()) values["F"] = first_excitation(term);
    if (form->law.kind != ForceLaw::Kind::none) {
      added.signal = add_excitation(signal_name(form->law, term.effect) + suffix);
      added.law = form->law;
      values["s"] = excitation_text(added.signal);
    }
    for (const std::string& stem : form->parameter_names()) {
      const int order = added.parameters.empty() ? -1 : 0;
      added.parameters.push_back(order < 0 ? add_strength(stem + suffix) : add_parameter(stem + suffix));
      values[std::to_string(added.parameters.size() - 1)] = added.parameters.back();
      for (ResonanceCase& resonance : model_.cases) {
        resonance.order[added.parameters.back()] = order == 0 ? 0 : strength_order(*form, term, resonance);
        resonance.may_act_nowhere.insert(added.parameters.back());
      }
    }
    append(model_.modes[term.mode], filled(form->term, values));
    if (!form->other_term.empty()) append(model_.modes[term.other], filled(form->other_term, values));
    return added;
  }

  Model take() { return std::move(model_); }

 private:
  [[noreturn]] void refuse(const EffectTerm& term, const std::string& wrong) const {
    throw InputError(model_.file, "effect " + term.effect, wrong, "applicable effects are those of the catalogue");
  }

  static std::string signal_name(const ForceLaw& law, const std::string& effect) {
    if (law.kind == ForceLaw::Kind::time) return "time";
    if (law.kind == ForceLaw::Kind::level) return "level";
    return law.has_memory() ? "z" : "law_" + effect;
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

  std::string add_strength(const std::string& wanted) {
    return model_.strengths.emplace_back(add_parameter(wanted));
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
  bool resonant(const EffectTerm& term, const EffectForm& form, const ResonanceCase& resonance) const {
    const bool parametric = form.term.find("{v}") != std::string::npos;
    return std::any_of(resonance.relations.begin(), resonance.relations.end(), [&](const ResonanceRelation& r) {
      std::vector<int> wanted(model_.frequency_count(), 0), sizes;
      wanted[model_.modes.size()] = 1;
      wanted[term.mode] = parametric ? 2 : 1;
      if (form.couples()) wanted[term.other] = 1;
      for (const int multiple : r.multiples) sizes.push_back(std::abs(multiple));
      sizes.resize(wanted.size(), 0);
      return sizes == wanted;
    });
  }

  int strength_order(const EffectForm& form, const EffectTerm& term, const ResonanceCase& resonance) const {
    int order = 0;
    switch (form.order) {
      case EffectForm::Order::first:
        order = 1;
        break;
      case EffectForm::Order::second:
        order = 2;
        break;
      case EffectForm::Order::last:
        order = resonance.expand_to;
        break;
      case EffectForm::Order::unless_resonant:
        order = resonant(term, form, resonance) ? resonance.expand_to : 1;
        break;
      case EffectForm::Order::outside:
        return resonance.expand_to + 1;
    }
    order = std::min(order, resonance.expand_to);
    return resonance.degree_ordering ? std::max(0, order - (form.degree - 1)) : order;
  }

  AddedEffect extra_mode(const EffectTerm& term) {
    const std::string drive = first_excitation(term);
    const std::size_t index = model_.modes.size();
    Mode mode;
    mode.coordinate = free("extra");
    const std::string& x = mode.coordinate;
    mode.frequency = free("omega_" + x);
    model_.symbols.add_positive(mode.frequency);
    const std::string strength = add_strength("eta1_" + x), damping = add_parameter("mu1_" + x);
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
  const EffectCatalogue& catalogue_;
  std::set<std::string> taken_;
};

}  // namespace

AugmentedModel with_effects(const Model& model, std::span<const EffectTerm> effects,
                            const EffectCatalogue& catalogue) {
  Augmentation augmentation(model, catalogue);
  AugmentedModel result;
  for (const EffectTerm& effect : effects) result.effects.push_back(augmentation.add(effect));
  result.model = augmentation.take();
  return result;
}

}  // namespace secular
