// Campaigns in which one effect of the catalogue acts, and no second one is to be found beside it.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/beam_texts.hpp"
#include "tests/app/diagnosed_folder.hpp"
#include "tests/places.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

class SlowOneCause : public testing_support::DiagnosedFolder {
 protected:
  void write_model(const std::string& nominal) const {
    std::ofstream(folder_ / "model.toml") << testing_support::beam_model(nominal);
  }

  nlohmann::json diagnosed(const fs::path& experiment, const std::string& seed) const {
    fs::remove_all(folder_ / "campaign");
    if (run("simulate " + experiment.string() + " -o " + path("campaign") + " --seed " + seed) != 0) return {};
    return diagnosis();
  }

  nlohmann::json diagnosed_text(const std::string& text, const std::string& seed) const {
    std::ofstream(folder_ / "experiment.toml") << "schema = 1\nname = \"one_cause\"\nmodel = \"model.toml\"\n"
                                               << text;
    return diagnosed(folder_ / "experiment.toml", seed);
  }

  void expect_friction_alone(const nlohmann::json& d, double strength) const {
    ASSERT_TRUE(d.is_object()) << printed();
    EXPECT_EQ(d["verdict"], "cause") << printed();
    EXPECT_EQ(d["cause"], "coulomb_friction") << printed();
    EXPECT_LT(d["together"].size(), 2U) << printed();
    const nlohmann::json& cause = d["causes"][0];
    EXPECT_NEAR(cause["coefficient"].get<double>(), strength, 4 * cause["sd"].get<double>());
    EXPECT_LT(d["gap"]["after"].get<double>(), 1.1);
  }
};

// Friction that is three quarters of the force in some dwells.
TEST_F(SlowOneCause, FrictionOfTheSharedCampaignActsAlone) {
  const fs::path faults = testing_support::source_folder().parent_path() / "shared/faults/second_cause";
  if (!fs::exists(faults)) GTEST_SKIP() << faults << " is not here";
  fs::copy_file(faults / "cantilever.toml", folder_ / "model.toml");
  expect_friction_alone(diagnosed(faults / "settle_20.toml", "1"), 0.3);
}

TEST_F(SlowOneCause, FrictionSeenByAVelocityOfASlowBeam) {
  write_model("40");
  expect_friction_alone(diagnosed_text(std::string(testing_support::slow_beam) + R"toml([[response]]
name = "tip"
quantity = "velocity"
unit = "m/s"
noise_sd = 0.002
[[dwell]]
frequencies_hz = [6.3, 6.4, 6.45, 6.55]
amplitudes = [0.5, 1.0]
ensembles = 6
ensemble_s = 6.0
settle_s = 40.0
initial_displacement = [1e-2]
[[free_decay]]
initial_displacement = [0.04]
initial_velocity = [0.0]
duration_s = 8.0
[[effect]]
name = "coulomb_friction"
strength = 0.15
)toml",
                                       "3"),
                        0.15);
}

TEST_F(SlowOneCause, FrictionSeenByADisplacementOfAStiffBeam) {
  write_model("200");
  expect_friction_alone(diagnosed_text(R"toml(sample_rate_hz = 800.0
[parameters]
omega0 = 199.0
mu1 = 1.5
alpha3 = 1.0e7
eta1 = 1.0
[excitation]
name = "base"
quantity = "acceleration"
unit = "m/s^2"
noise_sd = 0.02
[[response]]
name = "tip"
quantity = "displacement"
unit = "m"
noise_sd = 1e-5
[[dwell]]
frequencies_hz = [31.2, 31.7, 31.9, 32.3]
amplitudes = [4.0, 7.0]
ensembles = 6
ensemble_s = 2.0
settle_s = 10.0
initial_displacement = [3e-3]
[[effect]]
name = "coulomb_friction"
strength = 1.8
)toml",
                                       "4"),
                        1.8);
}

}  // namespace
}  // namespace secular
