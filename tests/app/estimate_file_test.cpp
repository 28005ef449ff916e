// An estimate goes where numbers are needed: what it could not tell is taken from what goes with its lumps.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/program_run.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

using nlohmann::json;
using testing_support::process_folder;

class SlowEstimateFile : public testing::Test {
 protected:
  static std::filesystem::path folder() { return process_folder() / "estimate_file"; }

  static void SetUpTestSuite() {
    std::filesystem::create_directories(folder());
    ASSERT_EQ(run("simulate experiments/principal_parametric -o test"), 0);
    ASSERT_EQ(run("identify test --model two_mass_mode1 -o result"), 0);
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(folder()); }

  static int run(const std::string& arguments) { return testing_support::run_program(folder(), arguments).status; }
  static std::string printed() {
    return testing_support::text_of(folder() / "stdout.txt") + testing_support::text_of(folder() / "stderr.txt");
  }
  static json read(const std::string& name) {
    std::ifstream in(folder() / name);
    return json::parse(in);
  }
  static void write(const std::string& name, const json& document) { std::ofstream(folder() / name) << document; }

  static json diagnosis(const std::string& parameters) {
    EXPECT_EQ(run("diagnose test --model two_mass_mode1 --parameters " + parameters + " --force -o diagnosis"), 0)
        << printed();
    return read("diagnosis/diagnosis.json");
  }
};

// Of the quadratic and cubic stiffnesses and inertias the modulation equation holds one combination, alpha_e.
TEST_F(SlowEstimateFile, RepresentativesHaveTheLumpsThatWereTold) {
  const json estimate = read("result/estimate.json");
  json values = estimate["representative"]["values"];
  for (const json& entry : estimate["estimates"]) {
    const std::string name = entry["name"];
    EXPECT_NE(entry["value"].is_null(), entry["identifiable"].get<bool>()) << name;
    EXPECT_EQ(values.contains(name), entry["value"].is_null()) << name;
    if (!entry["value"].is_null()) values[name] = entry["value"];
  }
  EXPECT_EQ(estimate["representative"]["steady_motions_of"], json({"principal_parametric"}));
  const auto v = [&](const char* name) { return values[name].get<double>(); };
  const double w = v("omega0"),
               alpha_e = (6 * std::pow(w, 4) * v("delta2") * v("delta2") - 6 * std::pow(w, 4) * v("delta3") +
                          12 * w * w * v("alpha2") * v("delta2") + 9 * w * w * v("alpha3") -
                          10 * v("alpha2") * v("alpha2")) /
                         (24 * w * w);
  for (const json& lump : estimate["lumps"])
    if (lump["name"] == "alpha_e") {
      EXPECT_NEAR(alpha_e, lump["value"].get<double>(), 0.5 * lump["sd"].get<double>());
      return;
    }
  FAIL() << "no alpha_e";
}

TEST_F(SlowEstimateFile, APredictionTakesThemAndSaysSo) {
  ASSERT_EQ(run("predict two_mass_mode1 --case principal_parametric --parameters result/estimate.json --at F=22.55 "
                "--vary Omega 24.3 25.1 --hz -o with"),
            0)
      << printed();
  EXPECT_NE(printed().find("does not identify alpha2, alpha3, delta2, delta3"), std::string::npos);
  // Another set with the same alpha_e and eta_e has the same saddle-node.
  json estimate = read("result/estimate.json");
  json& values = estimate["representative"]["values"];
  const double w = estimate["estimates"][0]["value"];
  values["delta3"] = values["delta3"].get<double>() + 1000;
  values["alpha3"] = values["alpha3"].get<double>() + 1000 * 2 * w * w / 3;
  write("other.json", estimate);
  ASSERT_EQ(run("predict two_mass_mode1 --case principal_parametric --parameters other.json --at F=22.55 "
                "--vary Omega 24.3 25.1 --hz -o other"),
            0);
  const json a = read("with/prediction.json"), b = read("other/prediction.json");
  ASSERT_EQ(a["branches"].size(), b["branches"].size());
  int compared = 0;
  for (std::size_t i = 0; i < a["branches"].size(); ++i)
    for (std::size_t j = 0; j < a["branches"][i]["special_points"].size(); ++j, ++compared)
      EXPECT_NEAR(a["branches"][i]["special_points"][j]["Omega"].get<double>(),
                  b["branches"][i]["special_points"][j]["Omega"].get<double>(), 1e-4);
  EXPECT_GT(compared, 2);
  // A case that the data do not speak of.
  estimate["representative"]["steady_motions_of"] = json::array();
  write("silent.json", estimate);
  EXPECT_EQ(run("predict two_mass_mode1 --case principal_parametric --parameters silent.json --at F=22.55 "
                "--vary Omega 24.3 25.1 --hz -o none"),
            2);
  EXPECT_NE(printed().find("gives no value for alpha2, alpha3, delta2, delta3"), std::string::npos);
}

TEST_F(SlowEstimateFile, ItsNumbersAreNoGapOfTheCampaignTheyAreFrom) {
  const json d = diagnosis("result/estimate.json");
  EXPECT_EQ(d["verdict"], "no_gap") << d["gap"].dump();
  EXPECT_EQ(d["gap"]["of"], "given numbers within their error bars");
}

// Ten error bars away are a gap, and it is one of these numbers; the same numbers with error bars that reach are
// none.
TEST_F(SlowEstimateFile, NumbersThatTheirErrorBarsDoNotCoverAreAGap) {
  json estimate = read("result/estimate.json");
  json& mu1 = estimate["estimates"][1];
  ASSERT_EQ(mu1["name"], "mu1");
  mu1["value"] = mu1["value"].get<double>() + 10 * mu1["sd"].get<double>();
  write("wrong.json", estimate);
  const json d = diagnosis("wrong.json");
  EXPECT_TRUE(d["gap"]["detected"].get<bool>());
  EXPECT_EQ(d["cause"], "parameters");
  mu1["sd"] = 20 * mu1["sd"].get<double>();
  write("vague.json", estimate);
  EXPECT_EQ(diagnosis("vague.json")["verdict"], "no_gap");
}

TEST_F(SlowEstimateFile, NumbersOfWhichSomeAreMissingAreRefused) {
  write("few.json", {{"omega0", 77.85}, {"mu1", 0.22}});
  EXPECT_EQ(run("diagnose test --model two_mass_mode1 --parameters few.json -o none"), 2);
  EXPECT_NE(printed().find("has no value"), std::string::npos) << printed();
}

}  // namespace
}  // namespace secular
