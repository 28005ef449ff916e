// Diagnoses of public measurements, with models that leave out what is known to act.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/app/diagnosed_folder.hpp"
#include "tests/places.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

class SlowMeasuredDiagnosis : public testing_support::DiagnosedFolder {
 protected:
  fs::path measured(const std::string& file) const {
    return testing_support::source_folder().parent_path() / "shared/data" / file;
  }

  static std::string own_model(const std::string& file) {
    return testing_support::text_of(testing_support::source_folder() / "models/measured" / file);
  }

  nlohmann::json diagnosed(const std::string& import, const std::string& model, const std::string& options) {
    std::ofstream(folder_ / "model.toml") << model;
    if (run("import " + import + " -o " + path("campaign")) != 0) return {};
    return diagnosis(options);
  }
};

double coefficient(const nlohmann::json& diagnosis, const std::string& effect, const std::string& place) {
  for (const nlohmann::json& cause : diagnosis["causes"])
    if (cause["effect"] == effect && cause["mode"] == place) return cause["coefficient"];
  return std::nan("");
}

TEST_F(SlowMeasuredDiagnosis, ThePendulumHasDryFrictionAndDrag) {
  const fs::path data = measured("pendulum/cdip_pend_data.mat");
  if (!fs::exists(data)) GTEST_SKIP() << data << " is not here: the measured pendulum is not diagnosed";
  const nlohmann::json d =
      diagnosed(data.string() + " --kind free_decay --time t --channel theta:response:angle:rad",
                own_model("pendulum_viscous.toml"), "--to 80 --check-from 0 --check-to 80 --fit-check");
  ASSERT_TRUE(d.is_object()) << printed();
  // A slider on a stiff spring is dry friction to all but the smallest swings.
  EXPECT_EQ(std::count(d["set"].begin(), d["set"].end(), "coulomb_friction"), 1) << d["set"];
  for (const nlohmann::json& effect : d["set"]) EXPECT_TRUE(effect == "coulomb_friction" || effect == "hysteresis");
  ASSERT_EQ(d["together"].size(), 2U) << printed();
  EXPECT_TRUE(d["together"][1] == "quadratic_damping" || d["together"][1] == "cubic_damping");
  // 0.125 degrees: what dry friction and drag leave in a fit of the whole swing.
  const auto degrees = [&](const char* part, const char* which) {
    return d["simulated"][part][0][which].get<double>() * 180 / 3.14159265358979;
  };
  EXPECT_LT(degrees("segments", "after_rms"), 0.125);
  EXPECT_LT(degrees("check", "after_fitted_rms"), 0.125);
  EXPECT_GT(degrees("check", "before_fitted_rms"), 0.3);
}

// The joint gives way little by little: friction with memory.
TEST_F(SlowMeasuredDiagnosis, TheBoltedBeamActsMostLikeFrictionWithMemory) {
  const fs::path data = measured("brake_reuss_beam/HammerImpact.mat");
  if (!fs::exists(data)) GTEST_SKIP() << data << " is not here: the measured beam is not diagnosed";
  const nlohmann::json d = diagnosed(
      data.string() + " --kind free_decay --time HIdata.time --channel a1=HIdata.acc1:response:acceleration:m/s^2",
      own_model("beam_linear.toml"), "--band 62:100 --to 1.2");
  ASSERT_TRUE(d.is_object()) << printed();
  EXPECT_TRUE(d["gap"]["detected"]);
  // Friction with memory is what acts most alike. Among the errors of the record itself it leaves structure (one
  // decay, other modes within the band), and no cause is named.
  EXPECT_EQ(d["verdict"], "unknown");
  EXPECT_EQ(d["set"], nlohmann::json{"hysteresis"});  // the nearest
  EXPECT_GT(d["gap"]["closed"].get<double>(), 0.5);
  double sum = 0;
  for (const nlohmann::json& cause : d["causes"]) {
    EXPECT_LE(cause["probability"].get<double>(), 1 + 1e-9) << cause;
    sum += cause["probability"].get<double>();
  }
  EXPECT_LE(sum, 2 + 1e-9);
}

TEST_F(SlowMeasuredDiagnosis, TheSilverboxHasACubicSpringAndAnOffsetAtItsInput) {
  const fs::path data = measured("silverbox/SNLS80mV.csv");
  if (!fs::exists(data)) GTEST_SKIP() << data << " is not here: the measured oscillator is not diagnosed";
  // The usual training part of the multisines, samples 40650 to 105712, and the usual test part up to 127400.
  const nlohmann::json d = diagnosed(data.string() +
                                         " --kind broadband --sample-rate 610.35 --channel V1:excitation:voltage:V "
                                         "--channel V2:response:voltage:V",
                                     own_model("oscillator_linear.toml"),
                                     "--from 66.6011 --to 173.1990 --check-from 173.1990 --check-to 208.7310");
  ASSERT_TRUE(d.is_object()) << printed();
  // Among the records' own errors something is left beside them.
  EXPECT_EQ(d["verdict"], "approximate");
  EXPECT_EQ(d["set"][0], "cubic_stiffness");
  EXPECT_EQ(d["together"], (nlohmann::json{"cubic_stiffness", "sensor_offset"}));
  EXPECT_NEAR(coefficient(d, "cubic_stiffness", "v"), 7.3e5, 0.02 * 7.3e5);
  // The means of the two channels over this part are 6.142 and 0.786 mV, and the spring's static gain is 1.013:
  // what the input's mean does not push the output's by is its offset. 0.1 mV: several times what cubic stiffness
  // adds to a mean.
  EXPECT_NEAR(coefficient(d, "sensor_offset", "V1"), 6.142e-3 - 0.786e-3 / 1.013, 1e-4);
  EXPECT_LT(d["simulated"]["segments"][0]["after_rms"].get<double>(), 0.45e-3);
  EXPECT_NEAR(d["simulated"]["check"][0]["before_rms"].get<double>(), 8.7e-3, 0.2e-3);
  EXPECT_LT(d["simulated"]["check"][0]["after_rms"].get<double>(), 0.45e-3);
}

bool has(const nlohmann::json& names, const std::vector<std::string>& any_of) {
  return std::any_of(any_of.begin(), any_of.end(), [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  });
}

// A beam between magnets hardens, is not symmetric, and its damping grows with the amplitude.
class SlowMeasuredMagnetBeam : public SlowMeasuredDiagnosis {
 protected:
  nlohmann::json diagnosed_with(const std::string& model) {
    return SlowMeasuredDiagnosis::diagnosed(
        measured("magnet_beam/frid.csv").string() + " --kind free_decay --channel strain:response:displacement:m",
        testing_support::text_of(measured("magnet_beam/" + model)), "");
  }
};

TEST_F(SlowMeasuredMagnetBeam, AsALinearOneActsLikeAHardeningSpringThatIsNotSymmetric) {
  if (!fs::exists(measured("magnet_beam/frid.csv"))) GTEST_SKIP() << "the measured magnet beam is not here";
  const nlohmann::json d = diagnosed_with("frid_lin.toml");
  ASSERT_TRUE(d.is_object()) << printed();
  EXPECT_EQ(d["verdict"], "approximate");
  EXPECT_TRUE(has(d["set"], {"cubic_stiffness"})) << d["set"];
  EXPECT_TRUE(has(d["together"], {"quadratic_stiffness", "quadratic_inertia"})) << d["together"];
  EXPECT_GT(d["gap"]["closed"].get<double>(), 0.9);
  EXPECT_NEAR(d["gap"]["left_share"].get<double>() + d["gap"]["closed"].get<double>(), 1, 1e-12);
}

TEST_F(SlowMeasuredMagnetBeam, WithACubicSpringActsLikeAnAsymmetryAndADampingThatGrows) {
  if (!fs::exists(measured("magnet_beam/frid.csv"))) GTEST_SKIP() << "the measured magnet beam is not here";
  const nlohmann::json d = diagnosed_with("frid_cubic.toml");
  ASSERT_TRUE(d.is_object()) << printed();
  EXPECT_EQ(d["verdict"], "approximate");
  EXPECT_TRUE(has(d["set"], {"quadratic_stiffness", "quadratic_inertia"})) << d["set"];
  nlohmann::json second = d.value("second_or", nlohmann::json::array());
  second.push_back(d["together"][1]);
  EXPECT_TRUE(has(second, {"quadratic_damping"})) << second;
  EXPECT_GT(d["gap"]["closed"].get<double>(), 0.9);
}

}  // namespace
}  // namespace secular
