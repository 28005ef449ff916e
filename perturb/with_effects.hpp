#pragma once

#include <span>
#include <string>
#include <vector>

#include "perturb/effect_catalogue.hpp"
#include "perturb/model.hpp"

namespace secular {

struct AugmentedModel {
  Model model;
  std::vector<AddedEffect> effects;
};

/// The model with the effects' terms on the right-hand sides of its equations of motion (`force` in Lagrangian
/// models), in the order given. Symbols are named by the catalogue's stem and the coordinates, "alpha5_v",
/// "mu12_v1_v2", with underscores appended where the model has such a symbol; modes and excitations are added
/// behind those of the model, so that all its indices stay. Every case gets orders of eps for the new symbols;
/// effects with a law are beyond every expansion and act in the equations of motion only. extra_mode adds
///   D2(x) + omega_x^2*x = -2*mu1_x*D(x) + eta1_x*F*cos(Omega*t),
/// a mode at rest in every case but for what excitation drives; effects that come after it may name it as mode.
/// With a strength of 0 the equations of motion are those of the model. Throws InputError for an effect that is not
/// in the catalogue or does not fit the model.
AugmentedModel with_effects(const Model& model, std::span<const EffectTerm> effects,
                            const EffectCatalogue& catalogue = effect_catalogue());

}  // namespace secular
