// Motions that sustain themselves, below the backbone of a free case.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "tests/app/program_run.hpp"
#include "tests/campaign/temporary_folder.hpp"

namespace secular {
namespace {

const char* const self_excited = R"toml(schema = 1
name = "self_excited"
[[mode]]
coordinate = "x"
frequency = "w"
equation = "D2(x) + w^2*x = m*(1 - p*x^2 - r*D(x)^2 + q*x^4)*D(x)"
[[mode]]
coordinate = "y"
frequency = "u"
equation = "D2(y) + u^2*y = (k*x^2 - c)*D(y)"
[[case]]
name = "free"
order = { m = 1, p = 0, r = 0, q = 0, k = 1, c = 1 }
expand_to = 1
excitation = false
)toml";

class LimitCycles : public TemporaryFolder {
 protected:
  nlohmann::json cycles(const std::map<std::string, double>& numbers) const {
    nlohmann::json all = {{"w", 1.0}, {"u", 1.7}, {"m", 0.1}, {"p", 1.0},
                          {"r", 0.0}, {"q", 0.0}, {"k", 0.0}, {"c", 0.1}};
    for (const auto& [name, value] : numbers) all[name] = value;
    write("model.toml", self_excited);
    write("numbers.json", all.dump());
    const testing_support::Outcome outcome = testing_support::run_with_shared_cache(
        folder_, "predict model.toml --parameters numbers.json --force -o out");
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    const nlohmann::json backbones = nlohmann::json::parse(read("out/prediction.json")).at("backbones");
    EXPECT_TRUE(backbones.at(1).at("limit_cycles").empty());  // y decays
    return backbones.at(0).at("limit_cycles");
  }
};

// Peak at the motion's own frequency, of x" + x = m (1 - p x^2 - r x'^2) x' by Runge and Kutta.
double integrated_amplitude(double m, double p, double r) {
  using State = std::array<double, 2>;
  const auto rate = [&](const State& y) {
    return State{y[1], -y[0] + m * (1 - p * y[0] * y[0] - r * y[1] * y[1]) * y[1]};
  };
  constexpr int settling = 40000, samples = 40000;
  constexpr double h = 0.01;
  State y{1, 0};
  std::complex<double> sum = 0;
  const double w = 1 - m * m / 16;  // to second order; the window's main lobe is far wider than what is left
  for (int i = 0; i < settling + samples; ++i) {
    const auto moved = [&](const State& k, double step) { return State{y[0] + step * k[0], y[1] + step * k[1]}; };
    const State a = rate(y), b = rate(moved(a, h / 2)), c = rate(moved(b, h / 2)), d = rate(moved(c, h));
    for (std::size_t k = 0; k < 2; ++k) y[k] += h / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
    if (i < settling) continue;
    const double weight = 1 - std::cos(2 * std::numbers::pi * (i - settling) / samples);
    sum += weight * y[0] * std::polar(1.0, -w * i * h);
  }
  return 2 * std::abs(sum) / samples;
}

TEST_F(LimitCycles, AreThoseOfTheTextbooksWithTheirStability) {
  // Van der Pol: 2, whatever m is.
  nlohmann::json found = cycles({});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].at("amplitude").get<double>(), 2, 1e-12);
  EXPECT_NEAR(found[0].at("frequency").get<double>(), 1, 1e-12);
  EXPECT_TRUE(found[0].at("stable").get<bool>());
  // Rayleigh and van der Pol: a^2 = 4/(p + 3 r w^2), up to the square of m.
  found = cycles({{"r", 0.5}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].at("amplitude").get<double>(), std::sqrt(1.6), 1e-12);
  EXPECT_NEAR(found[0].at("amplitude").get<double>(), integrated_amplitude(0.1, 1, 0.5), 0.01);
  // The growth (m/2) (1 - p a^2/4 + q a^4/8) of a motion that needs a push: with p and q, an unstable cycle inside
  // of a stable one.
  found = cycles({{"m", -0.1}, {"p", 3}, {"q", 1}});
  ASSERT_EQ(found.size(), 2U);
  for (const int side : {-1, 1}) {
    const nlohmann::json& cycle = found[side < 0 ? 0 : 1];
    EXPECT_NEAR(cycle.at("amplitude").get<double>(), std::sqrt(3 + side), 1e-12);
    EXPECT_EQ(cycle.at("stable").get<bool>(), side > 0);
  }
}

// The mean of x^2 on van der Pol's cycle is 2: y grows by k - c/2 there.
TEST_F(LimitCycles, LoseTheirStabilityToAnotherMode) {
  EXPECT_TRUE(cycles({{"k", 0.049}}).at(0).at("stable").get<bool>());
  EXPECT_FALSE(cycles({{"k", 0.051}}).at(0).at("stable").get<bool>());
}

}  // namespace
}  // namespace secular
