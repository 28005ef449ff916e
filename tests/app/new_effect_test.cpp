// A row in the catalogue is all that a new effect takes: derivation, experiment and diagnosis know it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"
#include "codegen/document/print_text.hpp"
#include "effects/catalogue.hpp"
#include "input/input_error.hpp"
#include "jobs/diagnose/diagnosis_report.hpp"
#include "jobs/diagnose/diagnosis_run.hpp"
#include "jobs/simulate/experiment_loading.hpp"
#include "measure/data/campaign_writer.hpp"
#include "perturb/with_effects.hpp"
#include "tests/campaign/temporary_folder.hpp"
#include "tests/places.hpp"
#include "tests/simulate/simulated_campaign.hpp"

namespace secular::app {
namespace {

constexpr const char* swing_model = R"toml(schema = 1
name = "swing"
[[mode]]
coordinate = "x"
frequency = "w"
equation = "D2(x) + w^2*x = -2*c1*D(x) - k3*x^3"
[[case]]
name = "decay"
order = { c1 = 1, k3 = 1 }
expand_to = 1
excitation = false
[nominal]
w = 40
)toml";

std::string swings(const std::string& effect) {
  return R"toml(schema = 1
name = "swings"
model = "swing.toml"
sample_rate_hz = 128.0
[parameters]
w = 40.0
c1 = 0.25
k3 = 4000.0
[[response]]
name = "x"
quantity = "displacement"
unit = "m"
noise_sd = 1e-4
[[free_decay]]
initial_displacement = [0.04]
duration_s = 5.0
[[free_decay]]
initial_displacement = [0.05]
duration_s = 5.0
[[effect]]
)toml" + effect;
}

// Made up: a loss that grows as the fourth power of the displacement, as text.
Effect quartic_loss() {
  return {.name = "quartic_loss",
          .component = EffectComponent::dissipative,
          .forms = {{.parameters = "mu6", .term = "-{0}*{v}^4*D({v})", .degree = 5}},
          .sign_known = true,
          .mistaken_for = {"amplitude_dependent_damping"}};
}

// Made up: a spring that gives no more than strength times level, as a law with a shape.
Effect yielding_spring() {
  constexpr ForceLaw::Value law = [](double x, double, double level, double) {
    return level * std::tanh(x / level);
  };
  return {.name = "yielding_spring",
          .component = EffectComponent::conservative,
          .forms = {{.parameters = "ky level",
                     .term = "-{0}*{s}",
                     .order = EffectForm::Order::outside,
                     .law = {ForceLaw::Kind::state, law}}}};
}

class NewEffect : public TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    model_ = write("swing.toml", swing_model).string();
  }

  static EffectCatalogue with(const Effect& row) {
    EffectCatalogue catalogue = effect_catalogue();
    catalogue.effects.push_back(row);
    return catalogue;
  }

  LoadedExperiment loaded(const std::string& effect, const EffectCatalogue& catalogue) const {
    return load_experiment(write("swings.toml", swings(effect)), true, {}, catalogue);
  }

  Diagnosis diagnosed(const std::string& effect, const EffectCatalogue& catalogue,
                      const std::vector<std::string>& without = {}) const {
    const auto [model, experiment] = loaded(effect, catalogue);
    CampaignWriter writer(folder_ / "campaign");
    const RecordSink keep = [&writer](const Campaign& made, const RecordEntry& entry, Record&& record) {
      writer.write(made, entry, record);
    };
    writer.finish(run_virtual_test(experiment, *model, 5, 1, keep, {}));
    DiagnosisRequest request;
    request.model = model_;
    request.catalogue = catalogue;
    request.without = without;
    return run_diagnosis(request, read_campaign(folder_ / "campaign")).diagnosis;
  }

  std::string model_;
};

TEST_F(NewEffect, IsDerived) {
  const EffectCatalogue catalogue = with(quartic_loss());
  const Model model = read_model(model_);
  const EffectTerm term = parse_effect_term("quartic_loss", model, catalogue);
  const CanonicalModel derived = canonical_model(with_effects(model, {&term, 1}, catalogue).model);
  EXPECT_TRUE(derived.cases.front().certificate.holds);
  EXPECT_NE(derivation_text(derived).find("mu6_x"), std::string::npos);
  EXPECT_THROW(parse_effect_term("quartic_loss", model), InputError);
}

TEST_F(NewEffect, IsRefusedWithoutItsRowAndWithoutItsKey) {
  EXPECT_THROW(loaded("name = \"quartic_loss\"\nstrength = 4e5\n", effect_catalogue()), InputError);
  EXPECT_THROW(loaded("name = \"yielding_spring\"\nstrength = 60.0\n", with(yielding_spring())), InputError);
}

// A law that jumps with the velocity sticks where the same text does.
TEST_F(NewEffect, ThatJumpsIsIntegratedAsItsTextIs) {
  constexpr ForceLaw::Value sign = [](double, double v, double, double) {
    return v > 0 ? 1.0 : v < 0 ? -1.0 : 0.0;
  };
  const Effect dry = {.name = "dry_law",
                      .component = EffectComponent::dissipative,
                      .forms = {{.parameters = "fl",
                                 .term = "-{0}*{s}",
                                 .order = EffectForm::Order::outside,
                                 .law = {ForceLaw::Kind::state, sign}}}};
  const auto simulated = [&](const std::string& name) {
    const auto [model, experiment] = loaded("name = \"" + name + "\"\nstrength = 2.0\n", with(dry));
    return run_virtual_test(experiment, *model, 5, 1).samples.front().channels.front();
  };
  const std::vector<double> law = simulated("dry_law"), text = simulated("coulomb_friction");
  ASSERT_EQ(law.size(), text.size());
  for (std::size_t i = 0; i < law.size(); ++i) EXPECT_NEAR(law[i], text[i], 1e-9) << i;
}

class SlowNewEffect : public NewEffect {};

TEST_F(SlowNewEffect, OfTextIsSimulatedAndNamed) {
  const Diagnosis d = diagnosed("name = \"quartic_loss\"\nstrength = 4e5\n", with(quartic_loss()));
  EXPECT_EQ(d.cause, "quartic_loss") << d.verdict;
  ASSERT_FALSE(d.causes.empty());
  EXPECT_NEAR(d.causes.front().coefficient, 4e5, 4 * d.causes.front().sd);
  ASSERT_FALSE(d.where.empty());
  EXPECT_EQ(d.where.front().component, EffectComponent::dissipative);
}

// Beside a stiffness that is fitted it is the catalogue's own spring that levels off.
TEST_F(SlowNewEffect, WithALawIsSimulatedAndNamed) {
  const Diagnosis d = diagnosed("name = \"yielding_spring\"\nstrength = 60.0\nlevel = 0.015\n",
                                with(yielding_spring()), {"saturating_stiffness"});
  EXPECT_EQ(d.cause, "yielding_spring") << d.verdict;
  ASSERT_FALSE(d.causes.empty());
  EXPECT_NEAR(d.causes.front().coefficient, 60, 4 * d.causes.front().sd);
  EXPECT_EQ(d.where.front().component, EffectComponent::conservative);
}

// What rows say of each other.
TEST(Catalogue, HoldsOnlyRowsThatTheProgramCanFollow) {
  const EffectCatalogue& catalogue = effect_catalogue();
  for (const Effect& effect : catalogue.effects) {
    EXPECT_EQ(catalogue.find(effect.name), &effect) << effect.name << " is there twice";
    const bool of_text = effect.kind == Effect::Kind::term || effect.kind == Effect::Kind::open_law;
    EXPECT_EQ(of_text, !effect.forms.empty()) << effect.name;
    EXPECT_EQ(effect.kind == Effect::Kind::channel_fault, effect.fault != ChannelFault::none) << effect.name;
    for (const EffectForm& form : effect.forms) {
      const std::size_t parameters = form.parameter_names().size();
      EXPECT_GE(parameters, 1u) << effect.name;
      EXPECT_LE(parameters, 3u) << effect.name;
      EXPECT_LE(form.shapes.size(), parameters - 1) << effect.name;
      EXPECT_EQ(form.couples(), effect.forms.front().couples()) << effect.name;
      EXPECT_EQ(form.term.find("{s}") != std::string::npos, form.law.kind != ForceLaw::Kind::none) << effect.name;
      EXPECT_EQ(form.law.kind == ForceLaw::Kind::state, form.law.value != nullptr) << effect.name;
    }
    // Said once, by the one row or by the other.
    std::vector<std::string> named = effect.mistaken_for;
    named.insert(named.end(), effect.contains.begin(), effect.contains.end());
    std::sort(named.begin(), named.end());
    EXPECT_EQ(std::adjacent_find(named.begin(), named.end()), named.end()) << effect.name;
    for (const std::string& other : named) {
      const Effect* like = catalogue.find(other);
      ASSERT_NE(like, nullptr) << effect.name << " and " << other;
      EXPECT_EQ(std::count(like->mistaken_for.begin(), like->mistaken_for.end(), effect.name), 0)
          << other << " says so of " << effect.name << ", too";
    }
  }
}

TEST(Catalogue, OpenLawsAloneAreSaidInWords) {
  for (const Effect& effect : effect_catalogue().effects) {
    if (effect.kind != Effect::Kind::open_law) {
      EXPECT_TRUE(effect.in_words.empty()) << effect.name;
      continue;
    }
    const std::string said = open_law_sentence({"tip", effect.name, effect.in_words, 2, 0.1});
    for (const char* part : {"acts like a ", " of tip that grows as |", "|^2"})
      EXPECT_NE(said.find(part), std::string::npos) << said;
  }
}

TEST(Catalogue, LookAlikesAreSoBothWays) {
  EffectCatalogue catalogue = effect_catalogue();
  catalogue.effects.push_back(quartic_loss());
  using Names = std::vector<std::string>;
  EXPECT_EQ(catalogue.look_alikes("quartic_loss"), Names{"amplitude_dependent_damping"});
  EXPECT_EQ(catalogue.look_alikes("amplitude_dependent_damping"), (Names{"cubic_damping", "quartic_loss"}));
  EXPECT_EQ(catalogue.look_alikes("quadratic_damping"), Names{"power_damping"});  // which holds it as a limit
  EXPECT_TRUE(catalogue.look_alikes("quintic_stiffness").empty());
  EXPECT_TRUE(catalogue.look_alikes("phlogiston").empty());
}

TEST(Catalogue, IsThatOfTheManual) {
  std::ifstream file(testing_support::source_folder() / "docs/simulating.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  ASSERT_FALSE(page.empty());
  for (const Effect& effect : effect_catalogue().effects) {
    if (effect.kind == Effect::Kind::open_law) continue;  // no user can ask for one
    EXPECT_NE(page.find("`" + effect.name + "`"), std::string::npos) << effect.name << ": not in simulating.md";
  }
}

}  // namespace
}  // namespace secular::app
