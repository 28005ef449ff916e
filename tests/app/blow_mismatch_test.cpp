// Blows that do more or less than their excitation says (a hammer that strikes beside its place, too few samples of
// a blow): what drives them does not count, what follows them does.
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "tests/app/plain_oscillator.hpp"

namespace secular {
namespace {

constexpr double struck_rad_s = 66.7, struck_damping = 0.75, blow_strength = 1.2;

class BlowMismatch : public testing_support::PlainOscillator {
 protected:
  // Five blows on one mode; the effect is not in the model.
  void measure(double rate_hz, const std::string& effect = "") const {
    std::ostringstream parameters, records;
    parameters << "omega0 = " << struck_rad_s << "\nmu1 = " << struck_damping << "\neta1 = " << blow_strength
               << '\n';
    for (const double peak : {4, 6, 8, 10, 12})
      records << "[[impact]]\npeak = " << peak << "\nat_s = 0.2\nwidth_s = 0.02\nduration_s = 4.0\n";
    simulate({rate_hz, "acceleration", "m/s^2", 0.02, 8}, parameters.str(), records.str() + effect);
  }

  // The readings of a record's excitation.
  void scale_excitation(std::size_t record, double factor) const {
    const std::filesystem::path file = folder_ / ("campaign/records/000" + std::to_string(record + 1) + ".csv");
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    std::ostringstream all;
    all.precision(12);
    all << line << '\n';
    while (std::getline(in, line)) {
      const std::size_t first = line.find(','), last = line.rfind(',');
      all << line.substr(0, first) << ',' << factor * std::stod(line.substr(first + 1)) << line.substr(last)
          << '\n';
    }
    in.close();
    std::ofstream(file) << all.str();
  }

  void let_them_differ() const {
    for (std::size_t r = 0; r < factors.size(); ++r) scale_excitation(r, factors[r]);
  }

  static std::vector<nlohmann::json> listed(const nlohmann::json& d) {
    std::vector<nlohmann::json> strengths;
    for (const nlohmann::json& one : d["disturbances"])
      if (one["kind"] == "blow_mismatch") strengths.push_back(one);
    return strengths;
  }

  static void expect_right(const nlohmann::json& d, const std::string& name, double value) {
    for (const nlohmann::json& p : d["parameters"])
      if (p["name"] == name) {
        EXPECT_NEAR(p["value"].get<double>(), value, 4 * p["sd"].get<double>()) << name;
        return;
      }
    ADD_FAILURE() << name << " has no number";
  }

  static bool has(const nlohmann::json& d, const std::string& name) {
    for (const nlohmann::json& p : d["parameters"])
      if (p["name"] == name) return true;
    return false;
  }

  const std::vector<double> factors = {1.02, 0.985, 1.01, 0.97, 1.005};
};

// Five times the samples of the next one, which goes the same way through the code.
class BlowStrength : public BlowMismatch {};

TEST_F(BlowStrength, IsToldByBlowsThatDoWhatTheySay) {
  measure(2000);
  const nlohmann::json d = diagnosis();
  ASSERT_TRUE(d.is_object()) << printed();
  EXPECT_EQ(d["verdict"], "no_gap") << printed();
  EXPECT_TRUE(listed(d).empty()) << printed();
  expect_right(d, "eta1", blow_strength);
  expect_right(d, "mu1", struck_damping);
}

// Eight samples of a blow with sharp edges: what is between them was not recorded, and is in the error bar.
TEST_F(BlowMismatch, BlowsOfFewSamplesTellLittleOfTheirStrength) {
  measure(400);
  const nlohmann::json d = diagnosis();
  ASSERT_TRUE(d.is_object()) << printed();
  EXPECT_EQ(d["verdict"], "no_gap") << printed();
  if (has(d, "eta1")) expect_right(d, "eta1", blow_strength);
  expect_right(d, "omega0", struck_rad_s);
  expect_right(d, "mu1", struck_damping);
}

class SlowBlowMismatch : public BlowMismatch {};

TEST_F(SlowBlowMismatch, BlowsThatDoNotAreNoGapAndTellWhatFollowsThem) {
  measure(600);
  let_them_differ();
  const nlohmann::json d = diagnosis();
  ASSERT_TRUE(d.is_object()) << printed();
  EXPECT_EQ(d["verdict"], "no_gap") << printed();
  EXPECT_FALSE(has(d, "eta1")) << printed();
  expect_right(d, "omega0", struck_rad_s);
  expect_right(d, "mu1", struck_damping);
  const std::vector<nlohmann::json> strengths = listed(d);
  ASSERT_EQ(strengths.size(), factors.size()) << printed();
  for (std::size_t r = 1; r < factors.size(); ++r)
    EXPECT_NEAR((1 + strengths[r]["size"].get<double>()) / (1 + strengths[0]["size"].get<double>()),
                factors[0] / factors[r], 0.005)
        << r;
}

TEST_F(SlowBlowMismatch, WhatTheModelLacksIsNamedBesideThem) {
  constexpr double stiffness = 0.1 * struck_rad_s * struck_rad_s / (0.002 * 0.002);
  measure(600, "[[effect]]\nname = \"cubic_stiffness\"\nstrength = " + std::to_string(stiffness) + "\n");
  let_them_differ();
  const nlohmann::json d = diagnosis();
  ASSERT_TRUE(d.is_object()) << printed();
  EXPECT_EQ(d["cause"], "cubic_stiffness") << printed();
  EXPECT_EQ(listed(d).size(), factors.size()) << printed();
  expect_right(d, "alpha3_v", stiffness);
  expect_right(d, "mu1", struck_damping);
}

}  // namespace
}  // namespace secular
