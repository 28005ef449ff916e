#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "effects/catalogue.hpp"

namespace secular {

struct Model;

/// An effect of the catalogue at one mode. `mode` and `other` are indices into Model::modes.
struct EffectTerm {
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::string effect = {};
  std::size_t mode = 0;      ///< of no meaning for extra_mode
  std::size_t other = none;  ///< second mode of couplings
  std::size_t form = 0;      ///< which of the effect's terms, where the catalogue has several (cubic_coupling)
  bool operator==(const EffectTerm&) const = default;
};

/// What an effect brought into a model.
struct AddedEffect {
  EffectTerm term;
  /// Symbols added to the model. The first is the strength, which multiplies the whole term (0: no effect); further
  /// ones are shape parameters. freeplay: gap; hysteresis: slip displacement, which enters no equation and is there
  /// for whoever integrates z(t); extra_mode: natural frequency (rad/s) and viscous damping mu1 (1/s).
  std::vector<std::string> parameters;
  /// Of a term with a law: index of the excitation whose signal the caller supplies by that law, as a value (not an
  /// amplitude). EffectTerm::none for all others.
  std::size_t signal = EffectTerm::none;
  /// extra_mode: index of the mode that was added.
  std::size_t added_mode = EffectTerm::none;
  ForceLaw law = {};  ///< of the signal
};

/// Every effect of the catalogue for every mode, and pair of modes, that it fits: those that need an excitation
/// only for a model that has one. Effects whose term the model already holds are listed too; open laws are not.
std::vector<EffectTerm> applicable_effects(const Model& model,
                                           const EffectCatalogue& catalogue = effect_catalogue());

/// Every open law for every mode.
std::vector<EffectTerm> open_law_terms(const Model& model, const EffectCatalogue& catalogue = effect_catalogue());

/// NAME[:MODE[:OTHER[:FORM]]] with coordinates for MODE and OTHER; MODE may be left out where there is one mode,
/// OTHER where there are two. Throws InputError.
EffectTerm parse_effect_term(const std::string& text, const Model& model,
                             const EffectCatalogue& catalogue = effect_catalogue());

}  // namespace secular
