// Branches that only the truncated expansion has are marked; those that the full equations have are not.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <tuple>

#include "tests/app/program_run.hpp"
#include "tests/campaign/temporary_folder.hpp"
#include "tests/places.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

struct Oscillator {
  double w, d, b1, b2, k, F = 1;
};

// Amplitude of the motion at `multiple` times the excitation's frequency after 300 periods from a state, by
// classical Runge-Kutta steps; infinite where it runs away.
double settled_amplitude(const Oscillator& o, double omega, double multiple, double x, double v) {
  constexpr int steps = 200, periods = 300, seen = 20;
  const double period = 2 * std::numbers::pi / omega, h = period / steps;
  const auto rate = [&](double t, double y, double u) {
    return o.k * o.F * std::cos(omega * t) - o.d * u - o.w * o.w * y - o.b1 * y * y - o.b2 * y * y * y;
  };
  std::complex<double> sum = 0;
  for (int i = 0; i < steps * periods; ++i) {
    const double t = i * h;
    if (i >= steps * (periods - seen)) sum += x * std::polar(1.0, -multiple * omega * t);
    const double a1 = rate(t, x, v), v2 = v + h / 2 * a1;
    const double a2 = rate(t + h / 2, x + h / 2 * v, v2), v3 = v + h / 2 * a2;
    const double a3 = rate(t + h / 2, x + h / 2 * v2, v3), v4 = v + h * a3;
    const double a4 = rate(t + h, x + h * v3, v4);
    x += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    if (!(std::abs(x) < 1e6)) return std::numeric_limits<double>::infinity();
  }
  return 2 * std::abs(sum) / (steps * seen);
}

class PredictRange : public TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    write("oscillator.toml", R"toml(schema = 1
name = "quadratic_cubic"
[[mode]]
coordinate = "x"
frequency = "w"
equation = "D2(x) + d*D(x) + w^2*x + b1*x^2 + b2*x^3 = k*F*cos(Omega*t)"
[[case]]
name = "half"
relations = ["Omega = 2*w + eps*sigma"]
order = { d = 1, b1 = 1, b2 = 1, k = 0 }
expand_to = 2
[[case]]
name = "super2"
relations = ["2*Omega = w + eps*sigma"]
order = { d = 1, b1 = 1, b2 = 1, k = 0 }
expand_to = 2
[[case]]
name = "primary"
relations = ["Omega = w + eps^2*sigma"]
order = { d = 2, b1 = 1, b2 = 2, k = 2 }
expand_to = 2
)toml");
  }

  nlohmann::json predict(const std::string& arguments) {
    fs::remove_all(folder_ / "out");
    outcome = testing_support::run_program(folder_, "predict " + arguments + " -o " + (folder_ / "out").string());
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    return nlohmann::json::parse(read("out/prediction.json"));
  }
  nlohmann::json predict(const Oscillator& o, const std::string& arguments) {
    const nlohmann::json numbers{{"w", o.w}, {"d", o.d}, {"b1", o.b1}, {"b2", o.b2}, {"k", o.k}, {"F", o.F}};
    write("numbers.json", numbers.dump());
    return predict((folder_ / "oscillator.toml").string() + " --parameters " + (folder_ / "numbers.json").string() +
                   " " + arguments);
  }

  // Whether the full equations, started on the predicted motion (with its forced part, which a primary resonance
  // has in it), stay near its amplitude.
  static bool exists(const Oscillator& o, const nlohmann::json& point, double multiple) {
    const double omega = point["Omega"].get<double>(), a = point["modes"][0]["amplitude"].get<double>();
    const double phase = point["modes"][0]["phase"].get<double>();
    const double forced = multiple == 1 ? 0 : o.k * o.F / (o.w * o.w - omega * omega);
    const double x = a * std::cos(phase) + forced, v = -multiple * omega * a * std::sin(phase);
    return std::abs(settled_amplitude(o, omega, multiple, x, v) / a - 1) < 0.15;
  }

  testing_support::Outcome outcome;
};

TEST_F(PredictRange, WhatTheFullEquationsDoNotHaveIsMarked) {
  const Oscillator o{2, 0.02, 0.62, 0.21, 3.5};
  const nlohmann::json half = predict(o, "--case half --vary Omega 3.4 4.4");
  int inside = 0, outside = 0;
  for (const auto& branch : half["branches"])
    for (const auto& point : branch["points"]) {
      const double amplitude = point["modes"][0]["amplitude"].get<double>();
      outside += point["outside_expansion"].get<bool>();
      EXPECT_TRUE(amplitude < 6 || point["outside_expansion"].get<bool>()) << amplitude;
      // Far from its ends the branch that exists is unmarked.
      if (amplitude > 1 && amplitude < 2.2 && point["stable"].get<bool>() && inside++ % 8 == 0) {
        EXPECT_FALSE(point["outside_expansion"].get<bool>()) << amplitude;
        EXPECT_TRUE(exists(o, point, 0.5)) << point.dump();
      }
    }
  EXPECT_GT(inside, 8);
  EXPECT_GT(outside, 50);
  EXPECT_NE(outcome.output.find("outside of the expansion's range"), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.errors.find("outside of the expansion's range"), std::string::npos) << outcome.errors;
  EXPECT_NE(read("out/response.svg").find("outside of the expansion"), std::string::npos);
}

TEST_F(PredictRange, StableMotionsThatAreMarkedDoNotExist) {
  const Oscillator o{2, 0.02, 0.6, 0.2, 3.6};
  int marked = 0;
  const nlohmann::json found = predict(o, "--case super2 --vary Omega 0.8 1.2");
  for (const auto& branch : found["branches"])
    for (const auto& point : branch["points"]) {
      if (!point["outside_expansion"].get<bool>() || !point["stable"].get<bool>()) continue;
      ++marked;
      EXPECT_FALSE(exists(o, point, 2)) << point.dump();
    }
  EXPECT_GT(marked, 0);
}

// A spring that softens, up to an amplitude where it pushes no longer back: the expansion's orders fall there
// still.
TEST_F(PredictRange, ABranchBeyondTheHilltopIsMarked) {
  for (const Oscillator& o : {Oscillator{1, 0.02, 0.3, -0.05, 1, 0.1}, Oscillator{1, 0.02, 0.36, 0, 1, 0.09}}) {
    int marked = 0, unmarked = 0;
    const nlohmann::json found = predict(o, "--case primary --vary Omega 0.7 1.1");
    for (const auto& branch : found["branches"])
      for (const auto& point : branch["points"]) {
        const bool outside = point["outside_expansion"].get<bool>();
        const double amplitude = point["modes"][0]["amplitude"].get<double>();
        if (!point["stable"].get<bool>() || amplitude < 0.8 || std::abs(amplitude / 1.7 - 1) < 0.1) continue;
        if ((outside ? marked : unmarked)++ % 4 != 0) continue;
        EXPECT_NE(outside, exists(o, point, 1)) << point.dump();
      }
    EXPECT_GT(marked, 8);
    EXPECT_GT(unmarked, 8);
  }
}

// x'' + 0.1 x' + x + x^3 = p + 0.04 cos(Omega t) with p = 1/2 swings about x = 0.42, where its frequency is 1.24,
// not 1: the expansion about zero, which has nothing of that, is marked everywhere. A thousandth of that load is as
// good as none.
TEST_F(PredictRange, ALoadThatStiffensIsMarkedAndSaid) {
  write("load.toml", R"toml(schema = 1
name = "load"
[[mode]]
coordinate = "x"
frequency = "w"
equation = "D2(x) + w^2*x + 2*mu*D(x) + b*x^3 = p + k*F*cos(Omega*t)"
[[case]]
name = "primary"
relations = ["Omega = w + eps^2*sigma"]
order = { mu = 2, b = 2, p = 1, k = 2 }
expand_to = 2
)toml");
  // A linear spring does not stiffen, whatever the load.
  for (const auto& [p, b, far] :
       {std::tuple{"0.5", "1", true}, {"1e-9", "1", false}, {"0", "1", false}, {"0.5", "0", false}}) {
    write("numbers.json", std::string(R"({"w":1,"mu":0.05,"k":1,"b":)") + b + R"(,"p":)" + p + "}");
    const nlohmann::json found =
        predict((folder_ / "load.toml").string() + " --parameters " + (folder_ / "numbers.json").string() +
                " --at F=0.04 --vary Omega 0.95 1.06");
    for (const auto& branch : found["branches"])
      for (const auto& point : branch["points"]) EXPECT_EQ(point["outside_expansion"].get<bool>(), far) << p;
    const std::string warnings = found["warnings"].dump();
    EXPECT_EQ(warnings.find("a constant force") != std::string::npos, far) << warnings;
    const std::string page = read("out/report.html");
    EXPECT_EQ(page.find("every stable response of x but rest lies outside") != std::string::npos, far) << p;
    EXPECT_EQ(page.find("no stable response"), std::string::npos) << p;
  }
}

// With friction the linear part of what the expansion leaves has no limit at small motions.
TEST_F(PredictRange, FrictionAndLinearModelsAreInside) {
  write("friction.toml", R"toml(schema = 1
name = "friction_and_drag"
[[mode]]
coordinate = "x"
frequency = "w"
equation = "D2(x) + d*D(x) + c*sgn(D(x)) + q*D(x)*abs(D(x)) + w^2*x = k*F*cos(Omega*t)"
[[case]]
name = "primary"
relations = ["Omega = w + eps*sigma"]
order = { d = 1, c = 1, q = 1, k = 1 }
expand_to = 1
)toml");
  for (const std::string numbers :
       {R"({"w":1,"d":0.02,"c":0.01,"q":0.05,"k":1})", R"({"w":1,"d":0.05,"c":0,"q":0,"k":1})"}) {
    write("numbers.json", numbers);
    const nlohmann::json found = predict((folder_ / "friction.toml").string() + " --parameters " +
                                         (folder_ / "numbers.json").string() + " --at F=0.1 --vary Omega 0.9 1.1");
    EXPECT_EQ(found.dump().find("\"outside_expansion\":true"), std::string::npos) << numbers;
  }
}

TEST_F(PredictRange, SpuriousBranchesOfTheFault) {
  const fs::path place = testing_support::source_folder().parent_path() / "shared/faults/spurious_branches";
  if (!fs::exists(place / "p3b.json")) GTEST_SKIP() << place << " is not there";
  for (const std::string numbers : {"p3b.json", "p3c.json"})
    for (const std::string resonance : {"half --vary Omega 1.6 2.4", "super2 --vary Omega 0.4 0.6"}) {
      int outside = 0;
      const nlohmann::json found = predict((place / "s03_helmholtz_duffing.toml").string() + " --parameters " +
                                           (place / numbers).string() + " --case " + resonance);
      for (const auto& branch : found["branches"])
        for (const auto& point : branch["points"]) {
          const double amplitude = point["modes"][0]["amplitude"].get<double>();
          outside += point["outside_expansion"].get<bool>();
          EXPECT_TRUE(amplitude > 1.7 || !point["outside_expansion"].get<bool>()) << amplitude;
          EXPECT_TRUE(amplitude < 6 || point["outside_expansion"].get<bool>()) << amplitude;
        }
      EXPECT_GT(outside, 50) << numbers << " " << resonance;
    }
}

TEST_F(PredictRange, ShippedPredictionsAreInside) {
  const std::string five = "two_mass_mode1 --case principal_parametric --parameters predictions/table_5_4 --hz ";
  const std::string six = "two_mass_lumps --parameters predictions/table_6_2 --hz ";
  for (const std::string& arguments : {five + "--at F=22.55 --vary Omega 24.3 25.1",
                                       five + "--vary Omega 23 26 --against F 8 40 --curve saddle_node",
                                       six + "--at F=23.3 --vary Omega 45.3 45.75"}) {
    const nlohmann::json found = predict(arguments);
    EXPECT_EQ(found.dump().find("\"outside_expansion\":true"), std::string::npos) << arguments;
    EXPECT_NE(found.dump().find("\"outside_expansion\":false"), std::string::npos) << arguments;
  }
}

}  // namespace
}  // namespace secular
