// Campaigns in which one of the catalogue's laws with a shape acts, some of them beside a limit in which another,
// simpler effect is all that it is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>

#include "tests/app/beam_texts.hpp"
#include "tests/app/diagnosed_folder.hpp"

namespace secular {
namespace {

const std::string beam = testing_support::beam_model("40");

// Three levels, 35 dB at the largest.
const std::string dwells = "schema = 1\nname = \"dwells\"\nmodel = \"model.toml\"\n" +
                           std::string(testing_support::slow_beam) +
                           R"toml([[response]]
name = "tip"
quantity = "displacement"
unit = "m"
noise_sd = 2e-4
[[dwell]]
frequencies_hz = [6.3, 6.4, 6.45, 6.55]
amplitudes = [0.3, 0.6, 1.0]
ensembles = 6
ensemble_s = 6.0
settle_s = 40.0
initial_displacement = [1e-2]
)toml";

constexpr const char* frame = R"toml(schema = 1
name = "frame"
[[mode]]
coordinate = "v1"
frequency = "omega1"
equation = "D2(v1) + omega1^2*v1 = -2*mu1a*D(v1) - alpha3a*v1^3 + eta1a*F*cos(Omega*t)"
[[mode]]
coordinate = "v2"
frequency = "omega2"
equation = "D2(v2) + omega2^2*v2 = -2*mu1b*D(v2) - alpha3b*v2^3 + eta1b*F*cos(Omega*t)"
[nominal]
omega1 = 40
omega2 = 95
[[case]]
name = "first"
relations = ["Omega = omega1 + eps^2*sigma"]
order = { mu1a = 2, alpha3a = 2, eta1a = 2, mu1b = 2, alpha3b = 2, eta1b = 2 }
expand_to = 2
)toml";

constexpr const char* frame_dwells = R"toml(schema = 1
name = "dwells"
model = "model.toml"
sample_rate_hz = 256.0
[parameters]
omega1 = 40.3
omega2 = 95.4
mu1a = 0.3
mu1b = 0.7
alpha3a = 1.5e4
alpha3b = 4.0e5
eta1a = 0.8
eta1b = 0.6
[excitation]
name = "base"
quantity = "acceleration"
unit = "m/s^2"
noise_sd = 0.005
[modal_basis]
mass_normalised_shapes = [[1.0, -0.7], [0.7, 1.1]]
[[response]]
name = "a"
quantity = "acceleration"
unit = "m/s^2"
noise_sd = 0.2
[[response]]
name = "b"
quantity = "acceleration"
unit = "m/s^2"
noise_sd = 0.2
[[dwell]]
frequencies_hz = [6.3, 6.4, 6.45, 6.55]
amplitudes = [0.4, 0.7, 1.0]
ensembles = 6
ensemble_s = 4.0
settle_s = 30.0
initial_displacement = [1e-2, 0.0]
[[dwell]]
frequencies_hz = [15.0, 15.15, 15.25, 15.4]
amplitudes = [1.0, 2.0, 3.0]
ensembles = 6
ensemble_s = 4.0
settle_s = 30.0
initial_displacement = [0.0, 1e-3]
)toml";

std::string replaced(std::string text, const std::string& old, const std::string& fresh) {
  const std::size_t at = text.find(old);
  if (at == std::string::npos) throw std::logic_error(old + " is not in the text");
  return text.replace(at, old.size(), fresh);
}

struct Acting {
  std::string name;
  double strength = 0;
  std::map<std::string, double> shapes;  // keys of the experiment, which symbols of the diagnosis begin with
  std::string more = {};
};

void PrintTo(const Acting& acting, std::ostream* out) {
  *out << acting.name;
}

std::string text_of(const Acting& acting) {
  std::string text = "[[effect]]\nname = \"" + acting.name + "\"\nstrength = " + std::to_string(acting.strength) +
                     "\n" + acting.more;
  for (const auto& [key, value] : acting.shapes) text += key + " = " + std::to_string(value) + "\n";
  return text;
}

class SlowCatalogueDiagnosis : public testing_support::DiagnosedFolder {
 protected:
  nlohmann::json diagnosed(const std::string& model, const std::string& experiment) const {
    std::ofstream(folder_ / "model.toml") << model;
    std::ofstream(folder_ / "experiment.toml") << experiment;
    if (run("simulate " + path("experiment.toml") + " -o " + path("campaign") + " --seed 3") != 0) return {};
    return diagnosis();
  }

  // It, or a set that holds it, with its strength and its shapes.
  void expect_found(const Acting& acting, const nlohmann::json& d) const {
    ASSERT_TRUE(d.is_object()) << printed();
    EXPECT_TRUE(d["verdict"] == "cause" || d["verdict"] == "set") << printed();
    EXPECT_NE(std::find(d["set"].begin(), d["set"].end(), acting.name), d["set"].end()) << printed();
    const auto cause = std::find_if(d["causes"].begin(), d["causes"].end(),
                                    [&](const nlohmann::json& c) { return c["effect"] == acting.name; });
    ASSERT_NE(cause, d["causes"].end()) << printed();
    EXPECT_GT((*cause)["probability"].get<double>(), 0.4) << printed();
    EXPECT_NEAR((*cause)["coefficient"].get<double>(), acting.strength, 4 * (*cause)["sd"].get<double>());
    // What the best explanation fitted is listed once more, in the same words.
    for (const nlohmann::json& parameter : d["parameters"])
      if (parameter["name"] == (*cause)["symbol"] && d["causes"][0] == *cause) {
        EXPECT_NEAR(parameter["value"].get<double>() / (*cause)["coefficient"].get<double>(), 1, 1e-9);
      }
    for (const auto& [key, value] : acting.shapes)
      EXPECT_TRUE(std::any_of((*cause)["shapes"].begin(), (*cause)["shapes"].end(),
                              [&](const nlohmann::json& s) {
                                return s["symbol"].get<std::string>().starts_with(key + "_") &&
                                       std::abs(s["value"].get<double>() - value) < 4 * s["sd"].get<double>();
                              }))
          << key << "\n"
          << (*cause)["shapes"];
    EXPECT_LT(d["gap"]["after"].get<double>(), 1.1);
  }

  void expect_cause(const std::string& name, const nlohmann::json& d) const {
    ASSERT_TRUE(d.is_object()) << printed();
    EXPECT_EQ(d["verdict"], "cause") << printed();
    EXPECT_EQ(d["cause"], name) << printed();
  }
};

class SlowCatalogueRow : public SlowCatalogueDiagnosis, public testing::WithParamInterface<Acting> {};

TEST_P(SlowCatalogueRow, OfOneModeIsFound) {
  expect_found(GetParam(), diagnosed(beam, dwells + text_of(GetParam())));
}

INSTANTIATE_TEST_SUITE_P(SlowEffects, SlowCatalogueRow,
                         testing::Values(Acting{"one_sided_stop", 200, {{"gap", 0.01}}},
                                         Acting{"two_sided_stop", 200, {{"gap", 0.01}}},
                                         Acting{"saturating_stiffness", 200, {{"v0", 0.01}}},
                                         Acting{"stribeck_friction", 0.05, {{"s", 1}, {"v0", 0.1}}},
                                         Acting{"power_damping", 0.3, {{"p", 1.5}}},
                                         Acting{"level_stiffness", 10, {}},
                                         Acting{"cubic_base_excitation", 2e4, {}}));

// Near one resonance it is viscous damping and a stiffness: dwells far below and above part them.
TEST_F(SlowCatalogueDiagnosis, RelaxationIsFoundByDwellsFarFromResonanceToo) {
  const Acting relaxation{"relaxation", 200, {{"tau", 0.02}}};
  const std::string wide = replaced(replaced(dwells, "[6.3, 6.4", "[3.5, 6.3, 6.4"), "6.55]", "6.55, 8.0, 11.0]");
  expect_found(relaxation,
               diagnosed(beam, replaced(wide, "noise_sd = 2e-4", "noise_sd = 5e-5") + text_of(relaxation)));
}

TEST_F(SlowCatalogueDiagnosis, InertiaThatJoinsTwoModesIsFoundInEitherForm) {
  for (const auto& [strength, form] : {std::pair{20.0, "0"}, {3.0, "1"}}) {
    const Acting coupling{
        "inertia_coupling", strength, {}, std::string("mode = \"v1\"\nother = \"v2\"\nform = ") + form + "\n"};
    expect_found(coupling, diagnosed(frame, frame_dwells + text_of(coupling)));
    std::filesystem::remove_all(folder_ / "campaign");
  }
}

TEST_F(SlowCatalogueDiagnosis, AGapThatNoMotionReachesIsNoGap) {
  const nlohmann::json d = diagnosed(beam, dwells + text_of({"one_sided_stop", 200, {{"gap", 0.05}}}));
  ASSERT_TRUE(d.is_object()) << printed();
  EXPECT_EQ(d["verdict"], "no_gap") << printed();
}

TEST_F(SlowCatalogueDiagnosis, FrictionThatHasFallenAtAllSpeedsIsDryFriction) {
  expect_cause("coulomb_friction",
               diagnosed(beam, dwells + text_of({"stribeck_friction", 0.05, {{"s", 1}, {"v0", 0.002}}})));
}

TEST_F(SlowCatalogueDiagnosis, APowerOfTwoIsQuadraticDamping) {
  expect_cause("quadratic_damping", diagnosed(beam, dwells + text_of({"power_damping", 0.3, {{"p", 2}}})));
}

TEST_F(SlowCatalogueDiagnosis, ALevelFarBeyondTheMotionIsACubicSpring) {
  const std::string linear = replaced(replaced(beam, " - alpha3*q^3", ""), "alpha3 = 2, ", "");
  const nlohmann::json d = diagnosed(
      linear, replaced(dwells, "alpha3 = 1.5e4\n", "") + text_of({"saturating_stiffness", 400, {{"v0", 0.2}}}));
  ASSERT_TRUE(d.is_object()) << printed();
  EXPECT_EQ(d["set"][0], "cubic_stiffness") << printed();
  EXPECT_EQ(std::count(d["set"].begin(), d["set"].end(), "saturating_stiffness"), 0) << printed();
}

}  // namespace
}  // namespace secular
