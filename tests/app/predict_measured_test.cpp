// Measured dwells on the predicted response.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/app/program_run.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

constexpr const char* measured_model_text = R"toml(schema = 1
name = "forced_duffing"
[[mode]]
coordinate = "x"
frequency = "w"
equation = "D2(x) + w^2*x = -2*c*D(x) - k3*x^3 + e*F*cos(Omega*t)"
[[case]]
name = "primary"
relations = ["Omega = w + eps*sigma"]
order = { c = 1, k3 = 1, e = 1 }
expand_to = 1
)toml";

// Four dwells at the prediction's excitation and one at twice of it.
constexpr const char* measured_experiment_text = R"toml(schema = 1
name = "forced"
model = "FOLDER/model.toml"
sample_rate_hz = 64.0
[parameters]
w = 40.0
c = 1.0
k3 = 1000.0
e = 1.0
[excitation]
name = "base"
quantity = "acceleration"
unit = "m/s^2"
[[response]]
name = "x"
quantity = "displacement"
unit = "m"
[[dwell]]
frequencies_hz = [6.2, 6.3, 6.36, 6.5]
amplitudes = [1.0]
ensembles = 3
ensemble_s = 2.0
settle_s = 12.0
[[dwell]]
frequencies_hz = [6.3]
amplitudes = [2.0]
ensembles = 3
ensemble_s = 2.0
settle_s = 12.0
)toml";

class SlowMeasuredDwells : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_);
    std::ofstream(folder_ / "model.toml") << measured_model_text;
    std::string text = measured_experiment_text;
    text.replace(text.find("FOLDER"), 6, folder_.string());
    std::ofstream(folder_ / "experiment.toml") << text;
    std::ofstream(folder_ / "numbers.json") << R"({"w": 40, "c": 1, "k3": 1000, "e": 1})";
  }
  void TearDown() override { fs::remove_all(folder_); }
  int run(const std::string& arguments) const {
    return testing_support::run_with_shared_cache(folder_, arguments).status;
  }
  std::string errors() const { return testing_support::text_of(folder_ / "stderr.txt"); }

  fs::path folder_ = testing_support::process_folder() / "measured";
};

TEST_F(SlowMeasuredDwells, LieOnTheResponseOfTheirExcitation) {
  ASSERT_EQ(run("simulate experiment.toml -o campaign"), 0) << errors();
  const std::string predict = "predict model.toml --parameters numbers.json --hz ";
  ASSERT_EQ(run(predict + "--vary Omega 6 6.7 --at F=1 --measured campaign -o over"), 0) << errors();
  EXPECT_NE(errors().find("1 of 5 dwells"), std::string::npos) << errors();
  std::ifstream stream(folder_ / "over" / "prediction.json");
  const auto measured = nlohmann::json::parse(stream).at("measured");
  ASSERT_EQ(measured.size(), 4u);
  double previous = 0;
  for (const auto& point : measured) {
    const double omega = point.at("Omega").get<double>(), a = point.at("amplitude")[0].get<double>();
    EXPECT_GT(omega, previous);
    previous = omega;
    // |response| of the oscillator linearised at its own amplitude: F = a |w^2 + 3/4 k3 a^2 - W^2 + 2 i c W|.
    const double stiff = 1600 + 750 * a * a - omega * omega;
    EXPECT_NEAR(a * std::hypot(stiff, 2 * omega), 1, 0.01) << omega;
    EXPECT_LT(point.at("sd_between_ensembles")[0].get<double>(), 0.01 * a);
  }
  std::ifstream page(folder_ / "over" / "report.html");
  const std::string html{std::istreambuf_iterator<char>(page), {}};
  EXPECT_NE(html.find("measured dwells"), std::string::npos);
  // Over the amplitude: the dwells at that frequency.
  ASSERT_EQ(run(predict + "--vary F 0.5 3 --at Omega=6.3 --measured campaign -o levels"), 0) << errors();
  std::ifstream levels(folder_ / "levels" / "prediction.json");
  EXPECT_EQ(nlohmann::json::parse(levels).at("measured").size(), 2u);
  // What cannot be drawn is said.
  EXPECT_EQ(run(predict + "--vary Omega 6 6.7 --at F=7 --measured campaign -o none"), 2);
  EXPECT_NE(errors().find("none of its 5 dwells"), std::string::npos) << errors();
  EXPECT_FALSE(fs::exists(folder_ / "none"));
}

// Beside and inside a principal parametric resonance: growth e F/(4 w) = 0.25 1/s against damping c = 0.1 1/s moves
// within 2 sqrt(0.25^2 - 0.1^2) rad/s = 0.073 Hz of 2 w.
TEST_F(SlowMeasuredDwells, AtRestLieOnTheAxis) {
  std::string model = measured_model_text, text = measured_experiment_text;
  model.replace(model.find("e*F*cos"), 7, "e*F*x*cos");
  model.replace(model.find("Omega = w"), 9, "Omega = 2*w");
  std::ofstream(folder_ / "model.toml") << model;
  text = text.substr(0, text.find("[[dwell]]"));
  text.replace(text.find("FOLDER"), 6, folder_.string());
  text.replace(text.find("c = 1.0"), 7, "c = 0.1");
  text.replace(text.find("e = 1.0"), 7, "e = 40.0");
  text +=
      "noise_sd = 1e-5\n[[dwell]]\nfrequencies_hz = [12.4, 12.73]\namplitudes = [1.0]\nensembles = 4\n"
      "ensemble_s = 4.0\nsettle_s = 150.0\ninitial_displacement = [0.01]\n";
  std::ofstream(folder_ / "experiment.toml") << text;
  std::ofstream(folder_ / "numbers.json") << R"({"w": 40, "c": 0.1, "k3": 1000, "e": 40})";
  ASSERT_EQ(run("simulate experiment.toml -o campaign"), 0) << errors();
  ASSERT_EQ(
      run("predict model.toml --parameters numbers.json --hz --vary Omega 12.3 12.9 --at F=1 --measured campaign "
          "-o over"),
      0)
      << errors();
  EXPECT_EQ(errors().find("left out"), std::string::npos) << errors();
  std::ifstream stream(folder_ / "over" / "prediction.json");
  const auto json = nlohmann::json::parse(stream);
  EXPECT_EQ(json.at("coordinate_unit"), "m");
  EXPECT_EQ(json.at("units").at("k3"), "1/(m^2 s^2)");
  EXPECT_EQ(json.at("units").at("w"), "rad/s");
  const auto measured = json.at("measured");
  ASSERT_EQ(measured.size(), 2u);
  EXPECT_LT(measured[0].at("amplitude")[0].get<double>(), 1e-5);
  EXPECT_GT(measured[1].at("amplitude")[0].get<double>(), 0.1);
}

// Stepped sweeps over a stiffening resonance with two saddle-nodes: dwells of a simulated campaign, each going on
// from the one before, leave the branches where the prediction says that they end.
TEST_F(SlowMeasuredDwells, OfSteppedSweepsJumpWithinAStepOfTheSaddleNodes) {
  constexpr double step_hz = 0.01;
  std::string up, down;
  for (int i = 0; i <= 14; ++i) {
    up += (i ? ", " : "") + std::to_string(6.36 + step_hz * i);
    down += (i ? ", " : "") + std::to_string(6.50 - step_hz * i);
  }
  std::string text = measured_experiment_text;
  text = text.substr(0, text.find("[[dwell]]"));
  text.replace(text.find("FOLDER"), 6, folder_.string());
  text.replace(text.find("c = 1.0"), 7, "c = 0.15");
  for (const auto& [group, frequencies] : {std::pair("up", up), std::pair("down", down)})
    text += "[[dwell]]\nfrequencies_hz = [" + frequencies +
            "]\namplitudes = [3.0]\nensembles = 2\nensemble_s = 2.0\nsettle_s = 60.0\ncarry_state = true\n"
            "group = \"" +
            std::string(group) + "\"\n";
  std::ofstream(folder_ / "sweeps.toml") << text;
  std::ofstream(folder_ / "light.json") << R"({"w": 40, "c": 0.15, "k3": 1000, "e": 1})";
  ASSERT_EQ(run("simulate sweeps.toml -o sweeps"), 0) << errors();
  ASSERT_EQ(run("predict model.toml --parameters light.json --hz --vary Omega 6.3 6.6 --at F=3 "
                "--measured sweeps -o out"),
            0)
      << errors();
  std::ifstream stream(folder_ / "out" / "prediction.json");
  const auto json = nlohmann::json::parse(stream);
  std::vector<double> folds;
  for (const auto& branch : json.at("branches"))
    for (const auto& special : branch.at("special_points"))
      if (special.at("kind") == "saddle_node" && special.at("old_kind") == "saddle-node")
        folds.push_back(special.at("Omega_hz").get<double>());
  ASSERT_EQ(folds.size(), 2u);
  std::sort(folds.begin(), folds.end());
  ASSERT_GT(folds[1] - folds[0], 2 * step_hz);
  // Between which two dwells of a group the amplitude changes most; points come sorted by frequency.
  const auto jump = [&](const std::string& group) {
    double before = 0, amplitude_before = 0, largest = 0;
    std::pair<double, double> place;
    for (const auto& point : json.at("measured")) {
      if (point.at("group") != group) continue;
      const double f = point.at("Omega_hz").get<double>(), a = point.at("amplitude")[0].get<double>();
      if (before > 0 && std::abs(a - amplitude_before) > largest) {
        largest = std::abs(a - amplitude_before);
        place = {before, f};
      }
      before = f;
      amplitude_before = a;
    }
    return place;
  };
  const auto [up_from, up_to] = jump("up");
  EXPECT_NEAR(up_to - up_from, step_hz, 1e-4);
  EXPECT_NEAR(0.5 * (up_from + up_to), folds[1], step_hz);
  const auto [down_from, down_to] = jump("down");
  EXPECT_NEAR(down_to - down_from, step_hz, 1e-4);
  EXPECT_NEAR(0.5 * (down_from + down_to), folds[0], step_hz);
  // Both groups have a name in the figure.
  std::ifstream figure(folder_ / "out" / "response.svg");
  const std::string svg{std::istreambuf_iterator<char>(figure), {}};
  EXPECT_NE(svg.find("measured dwells: up"), std::string::npos);
  EXPECT_NE(svg.find("measured dwells: down"), std::string::npos);
}

}  // namespace
}  // namespace secular
