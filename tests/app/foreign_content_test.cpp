// What the laboratory adds to single decays and sweeps is listed and explains nothing: a model that is right shows
// no gap beside it, and what a model lacks is still named.
#include <cmath>
#include <functional>
#include <numbers>
#include <sstream>
#include <vector>

#include "tests/app/plain_oscillator.hpp"
#include "tests/signal/gaussian.hpp"

namespace secular {
namespace {

constexpr double turn = 2 * std::numbers::pi, rate_hz = 320, natural_rad_s = 66.7;

class ForeignContent : public testing_support::PlainOscillator {
 protected:
  // By time and random numbers, in units of the readings' rms about their mean.
  using Added = std::function<double(double, testing_support::Gaussian&)>;

  // A campaign of such records, the response a velocity with noise of 0.6 % of its rms.
  void measure(const std::string& records, const std::string& effect = "") const {
    simulate({.rate_hz = rate_hz}, "omega0 = 66.7\nmu1 = 0.75\neta1 = 1.0\n", records + effect);
  }

  void measure_decay(const std::string& effect = "") const {
    measure("[[free_decay]]\ninitial_displacement = [0.002]\nduration_s = 4.0\n", effect);
  }

  void measure_sweep() const {
    measure("[[sweep]]\nfrom_hz = 9.6\nto_hz = 11.6\nrate_hz_per_s = 0.1\namplitude = 0.1\nsettle_s = 10.0\n");
  }

  void add(const Added& added, std::uint64_t seed = 1) const {
    testing_support::Gaussian random(seed);
    const std::filesystem::path file = folder_ / "campaign/records/0001.csv";
    std::ifstream in(file);
    std::string header, line;
    std::getline(in, header);
    std::vector<std::string> before;
    std::vector<double> times, readings;
    while (std::getline(in, line)) {
      const std::size_t last = line.rfind(',');
      before.push_back(line.substr(0, last));
      readings.push_back(std::stod(line.substr(last + 1)));
      times.push_back(std::stod(line));
    }
    in.close();
    double square = 0;
    for (const double x : readings) square += x * x / static_cast<double>(readings.size());
    std::ofstream out(file);
    out.precision(12);
    out << header << '\n';
    for (std::size_t i = 0; i < times.size(); ++i)
      out << before[i] << ',' << readings[i] + std::sqrt(square) * added(times[i] - times.front(), random) << '\n';
  }

  void expect_no_gap_beside(const std::string& kind) const {
    const nlohmann::json d = diagnosis();
    ASSERT_TRUE(d.is_object()) << printed();
    EXPECT_EQ(d["verdict"], "no_gap") << kind << '\n' << printed();
    EXPECT_TRUE(is_fitted(d, kind)) << kind << '\n' << printed();
  }

  static bool is_fitted(const nlohmann::json& d, const std::string& kind) {
    bool found = false;
    for (const nlohmann::json& one : d["disturbances"])
      found = found || (one["kind"] == kind && one["treated"] == "fitted");
    return found;
  }
};

double hum(double t, testing_support::Gaussian&) {
  return 0.07 * std::sin(turn * 50 * t + 1);
}

// 6 % beside the resonance.
double neighbour(double t, testing_support::Gaussian&) {
  return 0.03 * std::sin(1.06 * natural_rad_s * t + 1);
}

double wander(double t, testing_support::Gaussian&) {
  return 0.25 * (1 - std::exp(-t / 8));
}

double ring(double t, testing_support::Gaussian&) {
  return 0.2 * std::exp(-1.5 * t) * std::cos(turn * 26.1 * t);
}

// Correlated over 0.05 s, 3 % (sd).
struct Coloured {
  double now = 0;
  double operator()(double, testing_support::Gaussian& random) {
    const double keeps = std::exp(-1 / (rate_hz * 0.05));
    now = keeps * now + std::sqrt(1 - keeps * keeps) * random();
    return 0.03 * now;
  }
};

TEST_F(ForeignContent, HumInADecayIsNoGap) {
  measure_decay();
  add(hum);
  expect_no_gap_beside("foreign_tone");
}

TEST_F(ForeignContent, AWanderingZeroInADecayIsNoGap) {
  measure_decay();
  add(wander);
  expect_no_gap_beside("offset_wander");
}

TEST_F(ForeignContent, AnotherModeThatRingsInADecayIsNoGap) {
  measure_decay();
  add(ring);
  expect_no_gap_beside("neighbour_mode");
}

TEST_F(ForeignContent, ColouredNoiseInADecayIsNoGap) {
  measure_decay();
  add(Coloured());
  expect_no_gap_beside("coloured_noise");
}

// It would move numbers by many standard deviations. (What is left of it falls where the sweep nears the
// resonance.)
TEST_F(ForeignContent, AToneBesideTheResonanceOfASweepMovesNoNumber) {
  measure_sweep();
  add(neighbour);
  const nlohmann::json d = diagnosis();
  ASSERT_TRUE(d.is_object()) << printed();
  EXPECT_EQ(d["verdict"], "no_gap") << printed();
  EXPECT_TRUE(is_fitted(d, "foreign_tone") || is_fitted(d, "neighbour_mode")) << printed();
  for (const nlohmann::json& p : d["parameters"])
    for (const auto& [name, truth] : {std::pair{"omega0", 66.7}, {"mu1", 0.75}, {"eta1", 1.0}})
      if (p["name"] == name) {
        EXPECT_NEAR(p["value"].get<double>(), truth, 4 * p["sd"].get<double>()) << name;
      }
}

TEST_F(ForeignContent, HumInASweepIsNoGap) {
  measure_sweep();
  add(hum);
  expect_no_gap_beside("foreign_tone");
}

TEST_F(ForeignContent, AWanderingZeroInASweepIsNoGap) {
  measure_sweep();
  add(wander);
  expect_no_gap_beside("offset_wander");
}

TEST_F(ForeignContent, BesideHumWhatAModelLacksIsNamed) {
  constexpr double stiffness = 0.05 * natural_rad_s * natural_rad_s / (0.002 * 0.002);
  measure_decay("[[effect]]\nname = \"cubic_stiffness\"\nstrength = " + std::to_string(stiffness) + "\n");
  add(hum);
  const nlohmann::json d = diagnosis();
  ASSERT_TRUE(d.is_object()) << printed();
  EXPECT_TRUE(is_fitted(d, "foreign_tone"));
  EXPECT_FALSE(is_fitted(d, "coloured_noise"));
  ASSERT_FALSE(d["set"].empty()) << printed();
  EXPECT_EQ(d["set"][0], "cubic_stiffness") << printed();
  for (const nlohmann::json& p : d["parameters"]) {
    if (p["name"] != "alpha3_v") continue;
    EXPECT_NEAR(p["value"].get<double>(), stiffness, 4 * p["sd"].get<double>());
  }
}

}  // namespace
}  // namespace secular
