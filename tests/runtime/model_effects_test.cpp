// Accelerations of models with effects, interpreted and compiled, against the terms written by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"
#include "codegen/runtime/interpreted_model.hpp"
#include "codegen/runtime/runtime_model.hpp"
#include "estimator/model/by_name.hpp"
#include "perturb/with_effects.hpp"
#include "tests/campaign/temporary_folder.hpp"
#include "tests/places.hpp"
#include "tests/runtime/compare_lanes.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;
const fs::path source = testing_support::source_folder();

std::shared_ptr<const CompiledModel> interpreted(const Model& model) {
  Model bare = model;
  bare.cases.clear();
  return interpreted_model(canonical_model(bare));
}

Model model_text(const std::string& kind) {
  const std::string head = "schema = 1\nname = \"" + kind + "\"\n";
  const std::string free_case = "[[case]]\nname = \"c\"\nordering = \"degree\"\norder = { m = 2 }\n";
  if (kind == "one")
    return read_model_text(head +
                               "[[mode]]\ncoordinate = \"v\"\nfrequency = \"w\"\nequation = "
                               "\"D2(v) + w^2*v = -2*m*D(v) - a*v^2 + F*cos(Omega*t)\"\n" +
                               free_case,
                           kind);
  if (kind == "two")
    return read_model_text(head +
                               "[[mode]]\ncoordinate = \"v1\"\nfrequency = \"w1\"\nequation = "
                               "\"D2(v1) + w1^2*v1 + m*D(v1) + a*v1*v2 = F*cos(Omega*t)\"\n"
                               "[[mode]]\ncoordinate = \"v2\"\nfrequency = \"w2\"\nequation = "
                               "\"D2(v2) + w2^2*v2 = -a*v1^2/2\"\n" +
                               free_case,
                           kind);
  return read_model_text(
      head +
          "[lagrangian]\nkinetic = \"D(p)^2/2 + D(q)^2/2\"\n"
          "potential = \"w1^2*p^2/2 + w2^2*q^2/2 + a*p^3*q\"\n"
          "[[mode]]\ncoordinate = \"p\"\nfrequency = \"w1\"\nforce = \"-m*D(p) + F*cos(Omega*t)\"\n"
          "[[mode]]\ncoordinate = \"q\"\nfrequency = \"w2\"\n" +
          free_case,
      kind);
}

/// State of a mode and what else a term may need.
struct Moment {
  double v, dv, a, u, du, b, force, signal, w, strength, shape;
};
/// Terms on the right-hand sides of the mode and of the other mode, with the accelerations put in.
using Term = std::function<std::pair<double, double>(const Moment&)>;

double sign(double x) {
  return x > 0 ? 1 : (x < 0 ? -1 : 0);
}

std::map<std::pair<std::string, std::size_t>, Term> hand_written() {
  const auto own = [](double (*term)(const Moment&)) {
    return [term](const Moment& m) { return std::pair(m.strength * term(m), 0.0); };
  };
  std::map<std::pair<std::string, std::size_t>, Term> terms;
  terms[{"viscous_damping", 0}] = own([](const Moment& m) { return -2 * m.dv; });
  terms[{"quadratic_damping", 0}] = own([](const Moment& m) { return -std::abs(m.dv) * m.dv; });
  terms[{"cubic_damping", 0}] = own([](const Moment& m) { return -m.dv * m.dv * m.dv; });
  terms[{"coulomb_friction", 0}] = own([](const Moment& m) { return -sign(m.dv); });
  terms[{"amplitude_dependent_damping", 0}] = own([](const Moment& m) { return -m.v * m.v * m.dv; });
  terms[{"quadratic_stiffness", 0}] = own([](const Moment& m) { return -m.v * m.v; });
  terms[{"cubic_stiffness", 0}] = own([](const Moment& m) { return -m.v * m.v * m.v; });
  terms[{"quintic_stiffness", 0}] = own([](const Moment& m) { return -std::pow(m.v, 5); });
  terms[{"bilinear_stiffness", 0}] = own([](const Moment& m) { return -std::max(m.v, 0.0); });
  terms[{"freeplay", 0}] =
      own([](const Moment& m) { return m.v - std::max(m.v - m.shape, 0.0) - std::min(m.v + m.shape, 0.0); });
  terms[{"one_sided_stop", 0}] = own([](const Moment& m) { return -std::max(m.v - m.shape, 0.0); });
  terms[{"one_sided_stop", 1}] = own([](const Moment& m) { return std::max(-m.v - m.shape, 0.0); });
  terms[{"two_sided_stop", 0}] =
      own([](const Moment& m) { return -std::max(m.v - m.shape, 0.0) - std::min(m.v + m.shape, 0.0); });
  terms[{"stribeck_friction", 0}] = own([](const Moment& m) { return -(1 + m.shape * m.signal) * sign(m.dv); });
  terms[{"level_stiffness", 0}] = own([](const Moment& m) { return -m.signal * m.v; });
  terms[{"cubic_base_excitation", 0}] = own([](const Moment& m) { return m.v * m.v * m.v * m.force; });
  terms[{"inertia_coupling", 0}] = [](const Moment& m) {
    return std::pair(-m.strength * (m.u * m.a + m.du * m.dv), m.strength * m.dv * m.dv / 2);
  };
  terms[{"inertia_coupling", 1}] = [](const Moment& m) {
    return std::pair(-m.strength * m.v * m.b, -m.strength * (m.dv * m.dv + m.v * m.a));
  };
  terms[{"quadratic_inertia", 0}] = own([](const Moment& m) { return -2 * m.v * m.a - m.dv * m.dv; });
  terms[{"cubic_inertia", 0}] = own([](const Moment& m) { return -m.v * m.v * m.a - m.v * m.dv * m.dv; });
  terms[{"hysteresis", 0}] = own([](const Moment& m) { return -m.signal; });
  for (const auto& name : std::vector<std::pair<std::string, std::size_t>>{{"hysteresis", 1},
                                                                           {"hysteresis", 2},
                                                                           {"saturating_stiffness", 0},
                                                                           {"power_damping", 0},
                                                                           {"relaxation", 0},
                                                                           {"open_stiffness", 0},
                                                                           {"open_damping", 0},
                                                                           {"open_loss", 0},
                                                                           {"open_one_sided_damping", 0}})
    terms[name] = terms[{"hysteresis", 0}];
  terms[{"direct_excitation", 0}] = own([](const Moment& m) { return m.force; });
  terms[{"parametric_excitation", 0}] = own([](const Moment& m) { return m.v * m.force; });
  terms[{"damping_coupling", 0}] = own([](const Moment& m) { return -m.du; });
  terms[{"parametric_coupling", 0}] = own([](const Moment& m) { return m.u * m.force; });
  terms[{"parametric_coupling", 1}] = [](const Moment& m) {
    return std::pair(m.strength * m.u * m.force, m.strength * m.v * m.force);
  };
  terms[{"natural_frequency_drift", 0}] = own([](const Moment& m) { return -2 * m.w * m.w * m.v * m.signal; });
  terms[{"quadratic_coupling", 0}] = [](const Moment& m) {
    return std::pair(-2 * m.strength * m.v * m.u, -m.strength * m.v * m.v);
  };
  terms[{"cubic_coupling", 0}] = [](const Moment& m) {
    return std::pair(-m.strength * m.v * m.u * m.u, -m.strength * m.v * m.v * m.u);
  };
  terms[{"cubic_coupling", 1}] = [](const Moment& m) {
    return std::pair(-3 * m.strength * m.v * m.v * m.u, -m.strength * m.v * m.v * m.v);
  };
  return terms;
}

std::vector<double> accelerations(const CompiledModel& model, const test::Point& p) {
  std::vector<double> a(model.modes());
  model.acceleration(p.parameters.data(), p.excitation.data(), p.displacement.data(), p.velocity.data(), a.data());
  return a;
}

/// The point of an augmented model as one of the model without effects.
test::Point without(const CompiledModel& base, const CompiledModel& augmented, test::Point p) {
  std::vector<double> parameters;
  for (const CompiledSymbol& symbol : base.symbols)
    parameters.push_back(p.parameters[symbol_named(augmented, symbol.name)]);
  p.parameters = std::move(parameters);
  return p;
}

class ModelEffects : public TemporaryFolder {
 protected:
  RuntimeModel load(const fs::path& file, const std::vector<EffectTerm>& effects, bool interpret) const {
    RuntimeModelOptions options;
    options.cases = std::vector<std::string>{};
    options.effects = effects;
    options.interpret = interpret;
    options.header_folders = {source};
    options.cache_folder = folder_ / "cache";
    return load_runtime_model(file, options);
  }
};

TEST_F(ModelEffects, AccelerationsAreThoseOfTheTermsByHand) {
  const auto terms = hand_written();
  std::mt19937_64 random(11);
  for (const char* const kind : {"one", "two", "lagrangian"}) {
    const Model model = model_text(kind);
    const auto base = interpreted(model);
    std::vector<EffectTerm> terms_of_model = applicable_effects(model);
    for (const EffectTerm& law : open_law_terms(model)) terms_of_model.push_back(law);
    for (const EffectTerm& term : terms_of_model) {
      if (term.effect == "extra_mode") continue;
      const AugmentedModel augmented = with_effects(model, std::vector<EffectTerm>{term});
      const AddedEffect& added = augmented.effects[0];
      const auto code = interpreted(augmented.model);
      const Term& by_hand = terms.at({term.effect, term.form});
      for (int draw = 0; draw < 20; ++draw) {
        const test::Point p = test::random_point(*code, random);
        const std::vector<double> a = accelerations(*code, p);
        std::vector<double> expected = accelerations(*base, without(*base, *code, p));
        const std::size_t j = term.other == EffectTerm::none ? term.mode : term.other;
        const auto [own, other] = by_hand(
            {p.displacement[term.mode], p.velocity[term.mode], a[term.mode], p.displacement[j], p.velocity[j], a[j],
             p.excitation[0].value, added.signal == EffectTerm::none ? 0 : p.excitation[added.signal].value,
             p.parameters[term.mode], p.parameters[symbol_named(*code, added.parameters[0])],
             added.parameters.size() > 1 ? p.parameters[symbol_named(*code, added.parameters[1])] : 0});
        expected[term.mode] += own;
        expected[j] += other;
        for (std::size_t k = 0; k < expected.size(); ++k)
          EXPECT_NEAR(a[k], expected[k], 1e-12) << kind << " " << term.effect << " mode " << k;
      }
    }
  }
}

TEST_F(ModelEffects, FreeplayIsADeadBand) {
  const AugmentedModel augmented = with_effects(model_text("one"), std::vector<EffectTerm>{{"freeplay", 0}});
  const auto code = interpreted(augmented.model);
  std::mt19937_64 random(3);
  test::Point p = test::random_point(*code, random);
  p.parameters[symbol_named(*code, "kf_v")] = 5;
  p.parameters[symbol_named(*code, "gap_v")] = 0.1;
  test::Point none = p;
  none.parameters[symbol_named(*code, "kf_v")] = 0;
  for (const double v : {-0.3, -0.1, -0.07, 0.0, 0.02, 0.1, 0.25}) {
    p.displacement[0] = none.displacement[0] = v;
    const double lost = accelerations(*code, p)[0] - accelerations(*code, none)[0];
    EXPECT_NEAR(lost, 5 * std::clamp(v, -0.1, 0.1), 1e-13);
  }
}

TEST_F(ModelEffects, AnExtraModeIsDrivenAndTouchesNothing) {
  for (const char* const kind : {"one", "two", "lagrangian"}) {
    const Model model = model_text(kind);
    const AugmentedModel augmented = with_effects(model, std::vector<EffectTerm>{{"extra_mode"}});
    const auto base = interpreted(model), code = interpreted(augmented.model);
    const std::size_t x = augmented.effects[0].added_mode;
    std::mt19937_64 random(4);
    for (int draw = 0; draw < 5; ++draw) {
      const test::Point p = test::random_point(*code, random);
      const std::vector<double> a = accelerations(*code, p),
                                before = accelerations(*base, without(*base, *code, p));
      for (std::size_t k = 0; k < before.size(); ++k) EXPECT_EQ(a[k], before[k]);
      const double w = p.parameters[x], mu = p.parameters[symbol_named(*code, "mu1_extra")];
      EXPECT_NEAR(a[x],
                  -w * w * p.displacement[x] - 2 * mu * p.velocity[x] +
                      p.parameters[symbol_named(*code, "eta1_extra")] * p.excitation[0].value,
                  1e-13);
    }
  }
}

// With all strengths 0 the accelerations are those of the model as it is, to the last bit.
void expect_identity_at_zero(const CompiledModel& code, const CompiledModel& base,
                             const std::vector<AddedEffect>& effects) {
  std::mt19937_64 random(5);
  for (int draw = 0; draw < 10; ++draw) {
    test::Point p = test::random_point(code, random);
    for (const AddedEffect& added : effects) p.parameters[symbol_named(code, added.parameters[0])] = 0;
    const std::vector<double> a = accelerations(code, p), b = accelerations(base, without(base, code, p));
    for (std::size_t k = 0; k < b.size(); ++k) EXPECT_EQ(a[k], b[k]) << base.name << " mode " << k;
  }
}

constexpr const char* some_models[] = {"duffing", "two_mass", "two_mass_frame"};

TEST_F(ModelEffects, ZeroStrengthIsTheModelItself) {
  for (const char* const name : some_models) {
    const Model model = read_model(source / "models" / (std::string(name) + ".toml"));
    const AugmentedModel augmented = with_effects(model, applicable_effects(model));
    expect_identity_at_zero(*interpreted(augmented.model), *interpreted(model), augmented.effects);
  }
}

// Motions side by side, in which every effect acts in one motion and not in the others.
void expect_lanes_with_effects(const CompiledModel& code, const std::vector<AddedEffect>& effects) {
  std::vector<test::Point> points = test::points_of_lanes(code, 6);
  for (std::size_t e = 0; e < effects.size(); ++e)
    for (std::size_t lane = 0; lane < points.size(); ++lane)
      if (lane != e % points.size()) points[lane].parameters[symbol_named(code, effects[e].parameters[0])] = 0;
  test::expect_lanes_of_each(code, points);
}

// All effects at once, compiled.
class SlowModelEffects : public ModelEffects {};

TEST_F(SlowModelEffects, CompiledCodeIsThatModelToo) {
  for (const char* const name : some_models) {
    const fs::path file = source / "models" / (std::string(name) + ".toml");
    const Model model = read_model(file);
    const std::vector<EffectTerm> terms = applicable_effects(model);
    const AugmentedModel augmented = with_effects(model, terms);
    const RuntimeModel compiled = load(file, terms, false), base = load(file, {}, false);
    ASSERT_EQ(compiled.origin, RuntimeModel::Origin::compiled);
    EXPECT_TRUE(compiled.model->cases.empty());
    EXPECT_LT(test::largest_difference(*compiled.model, *interpreted(augmented.model), 10), 1e-12) << name;
    expect_identity_at_zero(*compiled.model, *base.model, augmented.effects);
    expect_lanes_with_effects(*compiled.model, augmented.effects);
  }
}

// The list of effects belongs to what a cached entry is found by.
TEST_F(SlowModelEffects, EffectsAreCachedApart) {
  const fs::path file = source / "models/duffing.toml";
  using Origin = RuntimeModel::Origin;
  const std::vector<EffectTerm> quintic = {{"quintic_stiffness", 0}}, drag = {{"quadratic_damping", 0}};
  EXPECT_EQ(load(file, quintic, false).origin, Origin::compiled);
  EXPECT_EQ(load(file, drag, false).origin, Origin::compiled);
  const RuntimeModel again = load(file, quintic, false);
  EXPECT_EQ(again.origin, Origin::cached);
  EXPECT_EQ(again.model->symbols.back().name, "alpha5_" + std::string(again.model->coordinates[0]));
}

}  // namespace
}  // namespace secular
