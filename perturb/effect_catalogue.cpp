#include "perturb/effect_catalogue.hpp"

#include <algorithm>

#include "input/input_error.hpp"
#include "perturb/model.hpp"

namespace secular {
namespace {

std::string known_effects(const EffectCatalogue& catalogue) {
  std::string names;
  for (const Effect& effect : catalogue.effects)
    if (effect.kind == Effect::Kind::term || effect.kind == Effect::Kind::extra_mode)
      names += (names.empty() ? "" : ", ") + effect.name;
  return names;
}

[[noreturn]] void refuse(const std::string& text, const std::string& wrong, const std::string& right) {
  throw InputError("effect " + text, "", wrong, right);
}

std::size_t mode_index(const std::string& coordinate, const std::string& text, const Model& model) {
  std::string coordinates;
  for (std::size_t k = 0; k < model.modes.size(); ++k) {
    if (model.modes[k].coordinate == coordinate) return k;
    coordinates += (k == 0 ? "" : ", ") + model.modes[k].coordinate;
  }
  refuse(text, "'" + coordinate + "' is no coordinate of " + model.name, "its coordinates are " + coordinates);
}

}  // namespace

std::vector<EffectTerm> applicable_effects(const Model& model, const EffectCatalogue& catalogue) {
  std::vector<EffectTerm> terms;
  for (const Effect& effect : catalogue.effects) {
    if (effect.kind != Effect::Kind::term) continue;
    for (std::size_t f = 0; f < effect.forms.size(); ++f) {
      const EffectForm& form = effect.forms[f];
      if (form.needs_excitation() && model.excitations.empty()) continue;
      for (std::size_t k = 0; k < model.modes.size(); ++k) {
        if (!form.couples()) {
          terms.push_back({effect.name, k, EffectTerm::none, f});
          continue;
        }
        for (std::size_t j = form.symmetric ? k + 1 : 0; j < model.modes.size(); ++j)
          if (j != k) terms.push_back({effect.name, k, j, f});
      }
    }
  }
  // Behind the terms of the model's own modes: it adds a mode.
  const Effect* extra_mode = catalogue.find(Effect::Kind::extra_mode);
  if (extra_mode && !model.excitations.empty()) terms.push_back({extra_mode->name, 0, EffectTerm::none, 0});
  return terms;
}

std::vector<EffectTerm> open_law_terms(const Model& model, const EffectCatalogue& catalogue) {
  std::vector<EffectTerm> terms;
  for (const Effect& effect : catalogue.effects)
    if (effect.kind == Effect::Kind::open_law)
      for (std::size_t k = 0; k < model.modes.size(); ++k) terms.push_back({effect.name, k, EffectTerm::none, 0});
  return terms;
}

EffectTerm parse_effect_term(const std::string& text, const Model& model, const EffectCatalogue& catalogue) {
  std::vector<std::string> pieces;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(':', begin), text.size());
    pieces.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  EffectTerm term{pieces[0], 0, EffectTerm::none, 0};
  const auto spare = [&](std::size_t most) {
    if (pieces.size() > most) refuse(text, "has more parts than this effect takes", "NAME[:MODE[:OTHER[:FORM]]]");
  };
  const Effect* effect = catalogue.find(term.effect);
  if (effect && effect->kind == Effect::Kind::extra_mode) {
    spare(1);
    return term;
  }
  if (!effect || effect->kind != Effect::Kind::term)
    refuse(text, "is not known", "known are " + known_effects(catalogue));
  const bool couples = effect->forms.front().couples();
  spare(couples ? 4 : 2);
  if (pieces.size() > 1)
    term.mode = mode_index(pieces[1], text, model);
  else if (model.modes.size() > 1)
    refuse(text, "does not say at which mode", "write " + text + ":" + model.modes[0].coordinate);
  if (pieces.size() > 2)
    term.other = mode_index(pieces[2], text, model);
  else if (couples && model.modes.size() == 2)
    term.other = 1 - term.mode;
  else if (couples)
    refuse(text, "does not say which mode it joins", "write NAME:MODE:OTHER");
  if (pieces.size() > 3) {
    const bool digit = pieces[3].size() == 1 && pieces[3][0] >= '0' && pieces[3][0] <= '9';
    term.form = digit ? static_cast<std::size_t>(pieces[3][0] - '0') : EffectTerm::none;
    if (term.form >= effect->forms.size())
      refuse(text, "has no form '" + pieces[3] + "'", "the catalogue counts an effect's forms from 0");
  }
  return term;
}

}  // namespace secular
