// Effects of the catalogue as terms of a model: what is offered, how it is named, and that the expansion of the
// augmented model still certifies.
#include "perturb/with_effects.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "input/input_error.hpp"
#include "perturb/certificate.hpp"
#include "perturb/derivation.hpp"

namespace secular {
namespace {

using Names = std::vector<std::string>;

Model one_mode(const std::string& more = {}) {
  return read_model_text(R"toml(schema = 1
name = "one"
[[mode]]
coordinate = "v"
frequency = "w"
equation = "D2(v) + w^2*v = -2*mu*D(v) + eta*F*cos(Omega*t)"
[[case]]
name = "primary"
relations = ["Omega = w + eps^2*sigma"]
order = { mu = 2, eta = 2 }
[[case]]
name = "parametric"
relations = ["Omega = 2*w + eps^2*sigma"]
order = { mu = 2, eta = 1 }
)toml" + more,
                         "one.toml");
}

Model two_modes() {
  return read_model_text(R"toml(schema = 1
name = "two"
[lagrangian]
kinetic = "D(x)^2/2 + D(y)^2/2"
potential = "w1^2*x^2/2 + w2^2*y^2/2 + a*x^2*y"
[[mode]]
coordinate = "x"
frequency = "w1"
force = "-2*m1*D(x) + e1*F*cos(Omega*t)"
[[mode]]
coordinate = "y"
frequency = "w2"
[[case]]
name = "combination"
relations = ["Omega = w1 + w2 + eps^2*sigma"]
order = { m1 = 2, e1 = 1, a = 1 }
[[case]]
name = "by_degree"
relations = ["Omega = w1 + w2 + eps^2*sigma"]
ordering = "degree"
order = { m1 = 2, e1 = 1 }
[nominal]
w1 = 1
w2 = 2.7
)toml",
                         "two.toml");
}

Model no_excitation() {
  return read_model_text(R"toml(schema = 1
name = "free"
[[mode]]
coordinate = "v"
frequency = "w"
equation = "D2(v) + w^2*v = 0"
[[case]]
name = "free"
excitation = false
)toml",
                         "free.toml");
}

TEST(WithEffects, EveryEffectIsOfferedForEveryModeAndPair) {
  const std::vector<EffectTerm> terms = applicable_effects(two_modes());
  std::set<std::string> effects = {"extra_mode"}, offered;
  for (const Effect& effect : effect_catalogue().effects) {
    if (effect.kind != Effect::Kind::term) continue;
    for (std::size_t f = 0; f < effect.forms.size(); ++f) {
      const auto count = std::count_if(terms.begin(), terms.end(), [&](const EffectTerm& term) {
        return term.effect == effect.name && term.form == f;
      });
      EXPECT_EQ(count, effect.forms[f].symmetric ? 1 : 2) << effect.name;
    }
    effects.insert(effect.name);
  }
  for (const EffectTerm& term : terms) offered.insert(term.effect);
  EXPECT_EQ(offered, effects);
  EXPECT_EQ(terms.back().effect, "extra_mode");
  for (const EffectTerm& term : applicable_effects(no_excitation())) {
    EXPECT_EQ(term.effect.find("excitation"), std::string::npos);
    EXPECT_NE(term.effect, "extra_mode");
    EXPECT_EQ(term.other, EffectTerm::none);
  }
}

TEST(WithEffects, SymbolsAreNamedByStemAndCoordinate) {
  const std::vector<EffectTerm> terms = {
      {"quintic_stiffness", 0},       {"freeplay", 0},           {"hysteresis", 0}, {"extra_mode"},
      {"natural_frequency_drift", 1}, {"damping_coupling", 0, 1}};
  const AugmentedModel augmented = with_effects(one_mode(), terms);
  EXPECT_EQ(augmented.effects[0].parameters, Names{"alpha5_v"});
  EXPECT_EQ(augmented.effects[1].parameters, (Names{"kf_v", "gap_v"}));
  EXPECT_EQ(augmented.effects[2].parameters, (Names{"kh_v", "slip_v"}));
  EXPECT_EQ(augmented.effects[2].signal, 1u);
  EXPECT_EQ(augmented.effects[3].parameters, (Names{"eta1_extra", "omega_extra", "mu1_extra"}));
  EXPECT_EQ(augmented.effects[3].added_mode, 1u);
  EXPECT_EQ(augmented.effects[4].parameters, Names{"drift_extra"});
  EXPECT_EQ(augmented.effects[4].signal, 2u);
  EXPECT_EQ(augmented.effects[5].parameters, Names{"mu12_v_extra"});
  EXPECT_EQ(augmented.model.modes.size(), 2u);
  EXPECT_EQ(augmented.model.excitations.size(), 3u);
  EXPECT_EQ(augmented.model.excitations[0].amplitude, "F");
}

TEST(WithEffects, TakenNamesGetUnderscores) {
  Model model = one_mode();
  const std::vector<EffectTerm> twice = {{"cubic_stiffness", 0}, {"cubic_stiffness", 0}};
  const AugmentedModel augmented = with_effects(model, twice);
  EXPECT_EQ(augmented.effects[0].parameters, Names{"alpha3_v"});
  EXPECT_EQ(augmented.effects[1].parameters, Names{"alpha3_v_"});
  EXPECT_EQ(model.parameters, (Names{"mu", "eta"}));  // the model itself is untouched
}

TEST(WithEffects, WhatDoesNotFitIsRefused) {
  const auto refused = [](const Model& model, const EffectTerm& term) {
    EXPECT_THROW(with_effects(model, std::vector<EffectTerm>{term}), InputError) << term.effect;
  };
  refused(one_mode(), {"no_such_effect", 0});
  refused(one_mode(), {"sensor_gain", 0});
  refused(one_mode(), {"cubic_stiffness", 1});
  refused(one_mode(), {"cubic_stiffness", 0, EffectTerm::none, 1});
  refused(one_mode(), {"damping_coupling", 0});
  refused(two_modes(), {"damping_coupling", 0, 0});
  refused(no_excitation(), {"direct_excitation", 0});
  refused(no_excitation(), {"extra_mode"});
}

TEST(WithEffects, TermsAreReadFromText) {
  const Model one = one_mode(), two = two_modes();
  EXPECT_EQ(parse_effect_term("cubic_damping", one), (EffectTerm{"cubic_damping", 0}));
  EXPECT_EQ(parse_effect_term("cubic_damping:y", two), (EffectTerm{"cubic_damping", 1}));
  EXPECT_EQ(parse_effect_term("quadratic_coupling:y", two), (EffectTerm{"quadratic_coupling", 1, 0}));
  EXPECT_EQ(parse_effect_term("cubic_coupling:x:y:1", two), (EffectTerm{"cubic_coupling", 0, 1, 1}));
  EXPECT_EQ(parse_effect_term("extra_mode", two), EffectTerm{"extra_mode"});
  for (const char* const bad :
       {"", "cubic", "cubic_damping", "cubic_damping:z", "cubic_damping:x:y", "extra_mode:x",
        "cubic_coupling:x:y:9", "cubic_coupling:x:y:", "cubic_coupling:x:y:1:1"})
    EXPECT_THROW(parse_effect_term(bad, two), InputError) << bad;
  EXPECT_THROW(parse_effect_term("damping_coupling:v", one), InputError);
}

// In a resonance through the very term it is of the last order; elsewhere it is of the first.
TEST(WithEffects, ExcitationIsOrderedByResonance) {
  const std::vector<EffectTerm> terms = {{"direct_excitation", 0}, {"parametric_excitation", 0}};
  const AugmentedModel augmented = with_effects(one_mode(), terms);
  const auto& cases = augmented.model.cases;
  EXPECT_EQ(cases[0].order.at("eta1_v"), 2);
  EXPECT_EQ(cases[0].order.at("eta2_v"), 1);
  EXPECT_EQ(cases[1].order.at("eta1_v"), 1);
  EXPECT_EQ(cases[1].order.at("eta2_v"), 2);
}

TEST(WithEffects, EveryAugmentedModelCertifies) {
  for (const Model& model : {one_mode(), two_modes(), no_excitation()})
    for (const EffectTerm& term : applicable_effects(model)) {
      const AugmentedModel augmented = with_effects(model, std::vector<EffectTerm>{term});
      for (const ResonanceCase& resonance : augmented.model.cases) {
        const Derivation derivation = derive(augmented.model, resonance);
        EXPECT_TRUE(certify(derivation).holds) << model.name << " " << resonance.name << " " << term.effect;
      }
    }
}

// The term is in the expansion, not only in the text: dA/dt of a Duffing stiffness is 3 i alpha3 A^2 conj(A)/(2 w).
TEST(WithEffects, AddedStiffnessReachesTheModulation) {
  const AugmentedModel augmented = with_effects(one_mode(), std::vector<EffectTerm>{{"cubic_stiffness", 0}});
  const Model& m = augmented.model;
  const Derivation d = derive(m, m.cases[0]);
  GiNaC::ex found = 0;
  const Field modulation = d.modulation(0);
  for (const auto& [key, value] : modulation.terms())
    if (key[d.layout.amplitude(0)] == 2 && key[d.layout.conjugate(0)] == 1) found += value;
  const GiNaC::ex expected = 3 * GiNaC::I * m.symbols.at("alpha3_v") / (2 * m.symbols.at("w"));
  EXPECT_TRUE((found - expected).normal().is_zero());
}

}  // namespace
}  // namespace secular
