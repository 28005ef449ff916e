// Nominal frequencies are a start, never a filter: what the records show
// outranks them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/app/program_run.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

using Values = std::map<std::string, double>;

std::string lines_of(const Values& values) {
  std::string text;
  for (const auto& [name, value] : values) text += name + " = " + std::to_string(value) + "\n";
  return text;
}

std::string case_text(const std::string& name, const std::string& relation, const std::string& more) {
  return "[[case]]\nname = \"" + name + "\"\nrelations = [" + relation +
         "]\norder = { m1 = 1, m2 = 1, k1 = 1, k2 = 1, e1 = 1, e2 = 1, p1 = 1 "
         "}\nexpand_to = 1\n" +
         more + "\n";
}

const std::string first_case = case_text("first", "\"Omega = w1 + eps*s\"", "modes_at_rest = [\"y\"]");
const std::string second_case = case_text("second", "\"Omega = w2 + eps*s\"", "modes_at_rest = [\"x\"]");
const std::string parametric_case = case_text("parametric", "\"Omega = 2*w1 + eps*s\"", "modes_at_rest = [\"y\"]");
const std::string free_case = case_text("free", "", "excitation = false");

std::string two_modes(const std::string& cases, const Values& nominal) {
  return "schema = 1\nname = \"pair\"\n[[mode]]\ncoordinate = \"x\"\nfrequency "
         "= \"w1\"\nequation = \"D2(x) + "
         "w1^2*x "
         "= -2*m1*D(x) - k1*x^3 + e1*F*cos(Omega*t) + "
         "p1*F*x*cos(Omega*t)\"\n[[mode]]\ncoordinate = "
         "\"y\"\nfrequency = \"w2\"\nequation = \"D2(y) + w2^2*y = -2*m2*D(y) "
         "- k2*y^3 + e2*F*cos(Omega*t)\"\n" +
         cases + "[nominal]\n" + lines_of(nominal);
}

std::string dwells_text(const std::string& frequencies, const std::string& levels, const std::string& start) {
  return "[[dwell]]\nfrequencies_hz = " + frequencies + "\namplitudes = " + levels +
         "\nensembles = 6\nensemble_s = 4.0\nsettle_s = "
         "30.0\ninitial_displacement = " +
         start + "\n";
}

std::string decay_text(const std::string& start) {
  return "[[free_decay]]\ninitial_displacement = " + start + "\nduration_s = 16.0\n";
}

class SlowNominalStart : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& file, const std::string& text) const { std::ofstream(folder_ / file) << text; }

  testing_support::Outcome run(const std::string& arguments, int status) const {
    testing_support::Outcome outcome = testing_support::run_with_shared_cache(folder_, arguments);
    EXPECT_EQ(outcome.status, status) << arguments << ": " << outcome.errors;
    return outcome;
  }

  // Into folder "campaign", noise small.
  void simulate(const std::string& model, const std::vector<std::string>& channels, const Values& truth,
                const std::string& programme) const {
    write("truth.toml", model);
    std::string text =
        "schema = 1\nname = \"test\"\nmodel = \"truth.toml\"\nsample_rate_hz = "
        "256.0\n[parameters]\n" +
        lines_of(truth) +
        "[excitation]\nname = \"base\"\nquantity = \"acceleration\"\nunit = "
        "\"m/s^2\"\nnoise_sd = 1e-3\n";
    for (const std::string& channel : channels)
      text +=
          "[[response]]\nname = \"" + channel + "\"\nquantity = \"displacement\"\nunit = \"m\"\nnoise_sd = 1e-6\n";
    write("experiment.toml", text + programme);
    run("simulate experiment.toml -o campaign --seed 1", 0);
  }

  // What a model of other nominal frequencies estimates: `names` within five
  // standard deviations or a thousandth. The warnings are returned.
  std::string expect_recovered(const std::string& model, const Values& truth,
                               const std::vector<std::string>& names) const {
    write("model.toml", model);
    fs::remove_all(folder_ / "out");
    const testing_support::Outcome outcome = run("identify campaign --model model.toml -o out", 0);
    std::ifstream stream(folder_ / "out" / "estimate.json");
    const nlohmann::json document = nlohmann::json::parse(stream);
    for (const auto& item : document.at("estimates")) {
      const auto name = item.at("name").get<std::string>();
      if (std::find(names.begin(), names.end(), name) == names.end()) continue;
      EXPECT_TRUE(item.at("identifiable").get<bool>()) << name;
      if (!item.at("value").is_number()) continue;
      const double right = truth.at(name), value = item.at("value").get<double>();
      EXPECT_NEAR(value, right, std::max(5 * item.at("sd").get<double>(), 1e-3 * std::abs(right))) << name;
    }
    return outcome.errors;
  }

  fs::path folder_ = testing_support::process_folder() / "nominal_start";
};

std::string one_mode(const std::string& nominal) {
  return "schema = 1\nname = \"beam\"\n[[mode]]\ncoordinate = \"q\"\nfrequency "
         "= \"w\"\nequation = \"D2(q) + w^2*q "
         "= "
         "-2*m*D(q) - k*q^3 + e*F*cos(Omega*t)\"\n" +
         nominal +
         "[[case]]\nname = \"primary\"\nrelations = [\"Omega = w + "
         "eps^2*s\"]\norder = { m = 2, k = 2, e = 2 "
         "}\nexpand_to = 2\n[[case]]\nname = \"free\"\nrelations = []\norder = "
         "{ m = 2, k = 2, e = 2 }\nexpand_to "
         "= "
         "2\nexcitation = false\n";
}

const Values beam_values = {{"w", 94.25}, {"m", 0.6}, {"k", 2e7}, {"e", 0.8}};

TEST_F(SlowNominalStart, OfOneModeIsOutrankedByDwellsAndDecays) {
  simulate(
      one_mode(""), {"q"}, beam_values,
      dwells_text("[14.8, 14.9, 15.0, 15.05, 15.1, 15.2, 15.3]", "[0.5, 1.0]", "[1e-4]") + decay_text("[3e-3]"));
  for (const char* nominal : {"110", "70", "190"}) {
    const std::string errors = expect_recovered(one_mode(std::string("[nominal]\nw = ") + nominal + "\n"),
                                                beam_values, {"w", "m", "k", "e"});
    EXPECT_NE(errors.find("w is near 94"), std::string::npos) << errors;
    EXPECT_EQ(errors.find("left out"), std::string::npos) << errors;
  }
  EXPECT_EQ(expect_recovered(one_mode("[nominal]\nw = 97\n"), beam_values, {"w", "m", "k", "e"}).find("is near"),
            std::string::npos);
  write("rough.json", "{\"w\": 125.66}");
  for (const char* nominal : {"", "[nominal]\nw = 110\n"}) {
    write("model.toml", one_mode(nominal));
    fs::remove_all(folder_ / "gap");
    EXPECT_NE(run("diagnose campaign --model model.toml -o gap", 0).output.find("none detected"),
              std::string::npos);
  }
  write("model.toml", one_mode(""));
  fs::remove_all(folder_ / "gap");
  const testing_support::Outcome rough =
      run("diagnose campaign --model model.toml --parameters rough.json -o gap", 0);
  EXPECT_NE(rough.output.find("none detected"), std::string::npos) << rough.output;
  EXPECT_NE(rough.errors.find("taken as a start"), std::string::npos) << rough.errors;
}

TEST_F(SlowNominalStart, OfTwoModesGivesWayWhereItIsWrong) {
  const Values truth = {{"w1", 40},  {"w2", 97}, {"m1", 0.25}, {"m2", 0.35}, {"k1", 6e4},
                        {"k2", 3e5}, {"e1", 1},  {"e2", 1},    {"p1", 0}};
  const std::string cases = first_case + second_case + free_case;
  simulate(two_modes(cases, {}), {"x", "y"}, truth,
           dwells_text("[6.2, 6.3, 6.366, 6.4, 6.5]", "[0.02, 0.05]", "[1e-3, 0.0]") +
               dwells_text("[15.2, 15.4, 15.44, 15.5, 15.7]", "[0.05, 0.1]", "[0.0, 1e-3]") +
               decay_text("[0.01, 0.005]"));
  for (const Values& nominal : {Values{{"w1", 40}, {"w2", 130}}, Values{{"w1", 60}, {"w2", 130}}})
    expect_recovered(two_modes(cases, nominal), truth, {"w1", "w2", "m1", "m2", "e1", "e2"});
}

TEST_F(SlowNominalStart, OfDecaysGivesWayToTheirLines) {
  const Values truth = {{"w1", 40},  {"w2", 97}, {"m1", 0.25}, {"m2", 0.35}, {"k1", 6e4},
                        {"k2", 3e5}, {"e1", 1},  {"e2", 1},    {"p1", 0}};
  simulate(two_modes(free_case, {}), {"x", "y"}, truth, decay_text("[0.02, 0.01]") + decay_text("[0.01, 0.015]"));
  for (const Values& nominal :
       {Values{{"w1", 30}, {"w2", 73}}, Values{{"w1", 56}, {"w2", 135}}, Values{{"w1", 40}, {"w2", 73}}}) {
    const std::string errors =
        expect_recovered(two_modes(free_case, nominal), truth, {"w1", "w2", "m1", "m2", "k1", "k2"});
    EXPECT_NE(errors.find("w2 is near 96.9"), std::string::npos) << errors;
    EXPECT_NE(errors.find("in order of frequency"), std::string::npos) << errors;
  }
}

// Twice the first frequency is 100: by a nominal w2 of 101 the parametric
// dwells would go to the second mode, and the lowest of the second mode's own
// dwells to none.
TEST_F(SlowNominalStart, DoesNotSortDwellsWithASubharmonic) {
  const Values truth = {{"w1", 50},  {"w2", 92}, {"m1", 0.4}, {"m2", 0.35}, {"k1", 6e4},
                        {"k2", 3e5}, {"e1", 1},  {"e2", 1},   {"p1", 40}};
  const std::string cases = parametric_case + second_case + free_case;
  simulate(two_modes(cases, {}), {"x", "y"}, truth,
           dwells_text("[15.85, 15.92, 16.0, 16.1]", "[3.0, 4.0]", "[3e-2, 0.0]") +
               dwells_text("[14.3, 14.5, 14.65, 14.8]", "[0.05, 0.1]", "[0.0, 1e-3]") + decay_text("[0.02, 0.01]"));
  for (const Values& nominal : {Values{{"w1", 50}, {"w2", 101}}, Values{{"w1", 46}, {"w2", 100}}}) {
    const std::string errors =
        expect_recovered(two_modes(cases, nominal), truth, {"w1", "w2", "m1", "m2", "p1", "e2"});
    EXPECT_EQ(errors.find("trivial branch"), std::string::npos) << errors;
    EXPECT_EQ(errors.find("no resonance"), std::string::npos) << errors;
  }
}

// Omega = w1 + w2 with both nominal values wrong and their sum not so wrong:
// the pair of lines is looked for everywhere.
TEST_F(SlowNominalStart, OfACombinationIsNotWhereItsLinesMustBe) {
  const Values truth = {{"w1", 40},  {"w2", 97}, {"m1", 0.25}, {"m2", 0.35}, {"k1", 6e4},
                        {"k2", 3e5}, {"e1", 1},  {"e2", 1},    {"p1", 40}};
  const auto model = [](const Values& nominal) {
    return "schema = 1\nname = \"sum\"\n[[mode]]\ncoordinate = "
           "\"x\"\nfrequency = \"w1\"\nequation = \"D2(x) + "
           "w1^2*x = -2*m1*D(x) - k1*x^3 + e1*F*cos(Omega*t) + "
           "p1*F*y*cos(Omega*t)\"\n[[mode]]\ncoordinate = "
           "\"y\"\nfrequency = \"w2\"\nequation = \"D2(y) + w2^2*y = "
           "-2*m2*D(y) - k2*y^3 + e2*F*cos(Omega*t) + "
           "p1*F*x*cos(Omega*t)\"\n" +
           case_text("sum", "\"Omega = w1 + w2 + eps*s\"", "") + "[nominal]\n" + lines_of(nominal);
  };
  simulate(model({}), {"x", "y"}, truth,
           dwells_text("[21.77, 21.79, 21.8, 21.81, 21.83, 21.85]", "[2.0, 3.0]", "[2e-2, 1e-2]"));
  for (const Values& nominal : {Values{{"w1", 40}, {"w2", 120}}, Values{{"w1", 48}, {"w2", 80}}})
    expect_recovered(model(nominal), truth, {"w1", "w2"});
}

// A model of the first mode alone, and a campaign that is mostly about the second.
TEST_F(SlowNominalStart, IsNotLeftForMoreDwellsOfAModeThatTheModelHasNot) {
  const Values truth = {{"w1", 40},  {"w2", 97}, {"m1", 0.25}, {"m2", 0.35}, {"k1", 6e4},
                        {"k2", 3e5}, {"e1", 1},  {"e2", 1},    {"p1", 0}};
  const std::string cases = first_case + second_case;
  simulate(two_modes(cases, {}), {"x", "y"}, truth,
           dwells_text("[6.2, 6.3, 6.366, 6.4, 6.5]", "[0.02, 0.05]", "[1e-3, 0.0]") +
               dwells_text("[15.2, 15.3, 15.4, 15.44, 15.5, 15.7]", "[0.05, 0.1]", "[0.0, 1e-3]"));
  write("model.toml", two_modes(first_case, {{"w1", 41}, {"w2", 300}}));
  const testing_support::Outcome outcome = run("identify campaign --model model.toml -o out", 1);
  EXPECT_NE(outcome.output.find("case first: 60 observations"), std::string::npos) << outcome.output;
}

// Dwells far from the resonance that the others show, more than half of all:
// said in one line, and the status is 1.
TEST_F(SlowNominalStart, MostRecordsLeftOutIsAFailure) {
  simulate(one_mode(""), {"q"}, beam_values,
           dwells_text("[14.8, 14.9, 15.0, 15.1, 15.2, 15.3]", "[0.5, 1.0]", "[1e-4]") +
               dwells_text("[20.0, 25.0, 30.0, 35.0, 40.0, 45.0, 50.0]", "[0.5, 1.0]", "[1e-4]"));
  write("model.toml", one_mode("[nominal]\nw = 94\n"));
  const testing_support::Outcome outcome = run("identify campaign --model model.toml -o out", 1);
  EXPECT_TRUE(fs::exists(folder_ / "out" / "estimate.json"));
  EXPECT_NE(outcome.errors.find("14 of 26 records are left out; 14 of them as"), std::string::npos)
      << outcome.errors;
  EXPECT_NE(outcome.errors.find("warning: 14 times ("), std::string::npos) << outcome.errors;
}

}  // namespace
}  // namespace secular
