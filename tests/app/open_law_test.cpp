// Single laws that the catalogue of effects does not hold: said to be unknown, with the exponent that they show.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/diagnosed_folder.hpp"

namespace secular {
namespace {

class SlowOpenLaw : public testing_support::DiagnosedFolder {
 protected:
  // Free swings of x'' + w^2 x = -2 c1 x' - k3 x^3 and one term more, diagnosed without that term.
  nlohmann::json diagnosed_without(const std::string& term, const std::string& symbol, double value) {
    write_model("full.toml", term, symbol + " = 1, ");
    write_model("model.toml", "", "");
    std::ofstream(folder_ / "experiment.toml") << R"toml(schema = 1
name = "swings"
model = ")toml" << (folder_ / "full.toml").string()
                                               << "\"\nsample_rate_hz = 128.0\n[parameters]\nw = 40.0\nc1 = 0.25\n"
                                               << "k3 = 4000.0\n"
                                               << symbol << " = " << value << R"toml(
[[response]]
name = "x"
quantity = "displacement"
unit = "m"
noise_sd = 2e-5
[[free_decay]]
initial_displacement = [0.04]
duration_s = 12.0
[[free_decay]]
initial_displacement = [0.05]
duration_s = 12.0
)toml";
    EXPECT_EQ(run("simulate " + path("experiment.toml") + " --seed 5 -o " + path("campaign")), 0) << printed();
    const nlohmann::json found = diagnosis();
    EXPECT_TRUE(found.is_object()) << printed();
    return found;
  }

 private:
  void write_model(const std::string& file, const std::string& term, const std::string& order) const {
    std::ofstream(folder_ / file) << R"toml(schema = 1
name = "swing"
[[mode]]
coordinate = "x"
frequency = "w"
equation = "D2(x) + w^2*x = -2*c1*D(x) - k3*x^3 )toml"
                                  << term << R"toml("
[[case]]
name = "decay"
order = { c1 = 1, )toml" << order << R"toml(k3 = 1 }
expand_to = 1
excitation = false
[nominal]
w = 40
)toml";
  }
};

TEST_F(SlowOpenLaw, AForceAsTheSquareOfTheDisplacementEitherWayIsUnknownToTheCatalogue) {
  const nlohmann::json d = diagnosed_without("- k2*abs(x)*x", "k2", 1600);
  ASSERT_EQ(d["verdict"], "unknown") << d;
  EXPECT_EQ(d["open_law"]["law"], "open_stiffness");
  EXPECT_NEAR(d["open_law"]["exponent"], 2, 4 * d["open_law"]["sd"].get<double>());
  EXPECT_LT(d["open_law"]["sd"], 0.2);
  for (const nlohmann::json& cause : d["causes"])
    EXPECT_EQ(cause["effect"].get<std::string>().find("open"), std::string::npos);
}

TEST_F(SlowOpenLaw, ALossThatGrowsAsTheFifthPowerOfTheVelocityIsUnknownToTheCatalogue) {
  const nlohmann::json d = diagnosed_without("- c5*D(x)^5", "c5", 0.02);
  ASSERT_EQ(d["verdict"], "unknown") << d;
  EXPECT_EQ(d["open_law"]["law"], "open_damping");
  EXPECT_NEAR(d["open_law"]["exponent"], 5, 4 * d["open_law"]["sd"].get<double>());
}

TEST_F(SlowOpenLaw, ALawOfTheCatalogueIsNamedThoughAnExponentOfItsOwnFitsAsWell) {
  const nlohmann::json d = diagnosed_without("- k5*x^5", "k5", 1e7);
  EXPECT_EQ(d["cause"], "quintic_stiffness") << d;
  EXPECT_FALSE(d.contains("open_law"));
}

}  // namespace
}  // namespace secular
