// A term that acts in no record of a campaign changes no number that the campaign tells, nor its error bar.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "tests/app/program_run.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

class SlowUnseenParameters : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }

  // Free decays of a softening structure, large enough for the expansion to need its correction.
  void measure() const {
    write("whole.toml", model(" + g*x*F*cos(Omega*t) + e*F*cos(Omega*t)", ", g = 2, e = 1"));
    write("experiment.toml", R"toml(schema = 1
name = "decays"
model = "whole.toml"
sample_rate_hz = 256.0
[parameters]
omega0 = 73.7
a3 = -3.5e7
mu = 0.67
m3 = 29.0
e = 0.04
g = -2.6
[excitation]
name = "base"
quantity = "acceleration"
unit = "m/s^2"
noise_sd = 1.0
[[response]]
name = "x"
quantity = "acceleration"
unit = "m/s^2"
noise_sd = 0.09
[[free_decay]]
initial_displacement = [3.3e-3]
duration_s = 12.0
[[free_decay]]
initial_displacement = [2.4e-3]
duration_s = 12.0
[[free_decay]]
initial_displacement = [1.5e-3]
duration_s = 12.0
)toml");
    EXPECT_EQ(run("simulate experiment.toml --seed 3 --force -o campaign").status, 0);
  }

  void write(const std::string& file, const std::string& text) const { std::ofstream(folder / file) << text; }

  testing_support::Outcome run(const std::string& arguments) const {
    return testing_support::run_with_shared_cache(folder, arguments);
  }

  static std::string model(const std::string& excitations, const std::string& orders) {
    return "schema = 1\nname = \"one\"\n[[mode]]\ncoordinate = \"x\"\nfrequency = \"omega0\"\nequation = \"D2(x) + "
           "omega0^2*x = -2*mu*D(x) - m3*D(x)^3 - a3*x^3" +
           excitations + "\"\n[[case]]\nname = \"free\"\nrelations = []\norder = { mu = 2, m3 = 2, a3 = 2" +
           orders + " }\nexpand_to = 2\nexcitation = false\n";
  }

  // By name.
  std::map<std::string, nlohmann::json> told_with(const std::string& excitations, const std::string& orders) const {
    write("model.toml", model(excitations, orders));
    const testing_support::Outcome outcome = run("identify campaign --model model.toml --force -o out");
    EXPECT_LE(outcome.status, 1) << outcome.errors;
    std::map<std::string, nlohmann::json> told;
    const nlohmann::json document = nlohmann::json::parse(std::ifstream(folder / "out" / "estimate.json"));
    for (const auto& item : document.at("estimates"))
      if (item.at("value").is_number()) told[item.at("name")] = item;
    return told;
  }

  fs::path folder = testing_support::process_folder() / "unseen_parameters";
};

TEST_F(SlowUnseenParameters, ChangeNoErrorBar) {
  measure();
  const auto alone = told_with("", "");
  ASSERT_EQ(alone.size(), 4u);
  const std::pair<const char*, const char*> terms[] = {
      {" + e*F*cos(Omega*t)", ", e = 1"},
      {" + g*x*F*cos(Omega*t)", ", g = 2"},
      {" + g*x*F*cos(Omega*t) + e*F*cos(Omega*t)", ", g = 2, e = 1"}};
  for (const auto& [excitations, orders] : terms) {
    const auto beside = told_with(excitations, orders);
    EXPECT_EQ(beside.size(), alone.size()) << excitations;
    for (const auto& [name, number] : alone) {
      ASSERT_TRUE(beside.contains(name)) << excitations;
      const double sd = number.at("sd").get<double>();
      EXPECT_NEAR(beside.at(name).at("value").get<double>(), number.at("value").get<double>(), 1e-3 * sd) << name;
      EXPECT_NEAR(beside.at(name).at("sd").get<double>(), sd, 1e-3 * sd) << name << excitations;
      for (const std::size_t end : {0U, 1U})
        EXPECT_NEAR(beside.at(name).at("ci95").at(end).get<double>(), number.at("ci95").at(end).get<double>(),
                    0.01 * sd)
            << name << excitations;
    }
  }
}

}  // namespace
}  // namespace secular
