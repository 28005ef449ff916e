// A model that lacks what makes the resonance is far from every dwell: its natural frequencies stay where they are
// believed until one explanation is near, and that one is found.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/diagnosed_folder.hpp"

namespace secular {
namespace {

class SlowMissingCoupling : public testing_support::DiagnosedFolder {
 protected:
  void write_model(const std::string& file, const std::string& in_first, const std::string& in_second,
                   const std::string& order) const {
    std::ofstream(folder_ / file) << R"toml(schema = 1
name = "pair"
[[mode]]
coordinate = "x"
frequency = "w1"
equation = "D2(x) + w1^2*x = -2*c1*D(x) - k1*x^3 - b1*x*y^2 - d1*D(x)^3 + e1*F*cos(Omega*t) )toml"
                                  << in_first << R"toml("
[[mode]]
coordinate = "y"
frequency = "w2"
equation = "D2(y) + w2^2*y = -2*c2*D(y) - k2*y^3 - b2*x^2*y - d2*D(y)^3 + e2*F*cos(Omega*t) )toml"
                                  << in_second << R"toml("
[[case]]
name = "sum"
relations = ["Omega = w1 + w2 + eps*sigma"]
order = { c1 = 1, c2 = 1, k1 = 1, k2 = 1, b1 = 1, b2 = 1, d1 = 1, d2 = 1, )toml"
                                  << order << R"toml(e1 = 1, e2 = 1 }
expand_to = 1
[nominal]
w1 = 50.2
w2 = 119.5
)toml";
  }
};

TEST_F(SlowMissingCoupling, OfASumResonanceIsNamed) {
  write_model("full.toml", "+ q*y*F*cos(Omega*t)", "+ q*x*F*cos(Omega*t)", "q = 1, ");
  write_model("model.toml", "", "", "");
  std::ofstream(folder_ / "experiment.toml")
      << "schema = 1\nname = \"sum\"\nmodel = \"" << path("full.toml") << R"toml("
sample_rate_hz = 128.0
[parameters]
w1 = 50.0
w2 = 120.0
c1 = 0.15
c2 = 0.25
k1 = 20000.0
k2 = 60000.0
b1 = 30000.0
b2 = 30000.0
d1 = 0.01
d2 = 0.01
e1 = 0.01
e2 = 0.01
q = 6.0
[excitation]
name = "base"
quantity = "acceleration"
unit = "m/s^2"
noise_sd = 0.05
[[response]]
name = "x"
quantity = "acceleration"
unit = "m/s^2"
noise_sd = 0.05
[[response]]
name = "y"
quantity = "acceleration"
unit = "m/s^2"
noise_sd = 0.05
[[dwell]]
frequencies_hz = [27.04, 27.07, 27.1]
amplitudes = [16.0, 21.0]
ensembles = 6
ensemble_s = 4.0
settle_s = 120.0
carry_state = false
initial_displacement = [1e-2, 4e-3]
group = "sum"
)toml";
  ASSERT_EQ(run("simulate " + path("experiment.toml") + " --seed 3 -o " + path("campaign")), 0) << printed();
  const nlohmann::json d = diagnosis();
  ASSERT_TRUE(d.is_object()) << printed();
  EXPECT_EQ(d["cause"], "parametric_coupling") << d;
  EXPECT_GT(d["gap"]["closed"], 0.95);
  const nlohmann::json& first = d["causes"][0];
  EXPECT_EQ(first["effect"], "parametric_coupling");
  EXPECT_NEAR(first["coefficient"], 6, 4 * first["sd"].get<double>()) << d;
}

}  // namespace
}  // namespace secular
