// A motion that excites itself: its growth out of rest and its decay onto the limit cycle tell the same numbers.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/program_run.hpp"
#include "tests/campaign/temporary_folder.hpp"

namespace secular {
namespace {

const std::map<std::string, double> truth{{"w", 6.0}, {"m", 0.2}, {"p", 1.0}};

const char* const model =
    "schema = 1\nname = \"van_der_pol_measured\"\n[[mode]]\ncoordinate = \"x\"\nfrequency = \"w\"\nequation = "
    "\"D2(x) + w^2*x = m*(1 - p*x^2)*D(x)\"\n[[case]]\nname = \"free\"\nrelations = []\norder = { m = 1, p = 0 }\n"
    "expand_to = 2\nexcitation = false\n";

std::string experiment(double released) {
  return "schema = 1\nname = \"limit_cycle\"\nmodel = \"model.toml\"\nsample_rate_hz = 20.0\n[parameters]\nw = "
         "6.0\nm = 0.2\np = 1.0\n[[response]]\nname = \"x\"\nquantity = \"displacement\"\nunit = \"m\"\nnoise_sd = "
         "0.002\n[[free_decay]]\ninitial_displacement = [" +
         nlohmann::json(released).dump() + "]\ninitial_velocity = [0.0]\nduration_s = 60.0\n";
}

// The limit cycle has an amplitude of 2/sqrt(p).
class SelfExcited : public TemporaryFolder, public testing::WithParamInterface<double> {};

TEST_P(SelfExcited, GrowthAndDecayOntoTheLimitCycleIdentify) {
  write("model.toml", model);
  write("experiment.toml", experiment(GetParam()));
  for (const std::string& arguments :
       {std::string("simulate experiment.toml -o campaign --seed 1"),
        std::string("identify campaign --model model.toml --interpret -o results")}) {
    const testing_support::Outcome outcome = testing_support::run_program(folder_, arguments);
    ASSERT_EQ(outcome.status, 0) << arguments << ": " << outcome.errors;
  }
  const nlohmann::json document = nlohmann::json::parse(read("results/estimate.json"));
  ASSERT_EQ(document.at("estimates").size(), truth.size());
  for (const auto& item : document.at("estimates")) {
    const std::string name = item.at("name").get<std::string>();
    ASSERT_TRUE(item.at("value").is_number()) << name;
    const double value = item.at("value").get<double>(), sd = item.at("sd").get<double>();
    EXPECT_NEAR(value, truth.at(name), 5 * sd) << name;
    EXPECT_LT(sd, 0.01 * truth.at(name)) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(FromRest, SelfExcited, testing::Values(0.05, 0.3));
INSTANTIATE_TEST_SUITE_P(FromAbove, SelfExcited, testing::Values(3.0, 4.0));

}  // namespace
}  // namespace secular
