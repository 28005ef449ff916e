// The program as a user meets it: exit status, one clear message, nothing half-written.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/program_run.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"
#include "tests/report/page_structure.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;
using testing_support::Outcome;
using testing_support::text_of;
const fs::path root = testing_support::source_folder();

class CommandLine : public testing::Test {
 protected:
  void SetUp() override {
    folder = testing_support::process_folder() /
             ("secular_cli_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  Outcome run(const std::string& arguments) const { return testing_support::run_program(folder, arguments); }
  std::string written(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name) << text;
    return (folder / name).string();
  }

  fs::path folder;
};

void expect_bad_input(const Outcome& outcome, const std::string& part) {
  EXPECT_EQ(outcome.status, 2) << outcome.errors;
  EXPECT_NE(outcome.errors.find(part), std::string::npos) << outcome.errors;
  EXPECT_TRUE(outcome.output.empty()) << outcome.output;
}

TEST_F(CommandLine, EveryCommandHelpsWithAnExample) {
  for (const char* command :
       {"derive", "evaluate", "verify", "generate", "simulate", "identify", "predict", "import", "inspect", "modal",
        "diagnose", "spectrum", "procedure", "plan", "blind", "to-matlab"}) {
    const Outcome outcome = run(std::string(command) + " --help");
    EXPECT_EQ(outcome.status, 0) << command;
    EXPECT_NE(outcome.output.find("xample"), std::string::npos) << command;
  }
  EXPECT_EQ(run("").status, 2);
  EXPECT_EQ(run("frobnicate").status, 2);
}

TEST_F(CommandLine, TheBlindCheckPrintsItsFileAsJson) {
  const Outcome made = run("blind generate --campaigns 1 --records one_decay --json -o set");
  ASSERT_EQ(made.status, 0) << made.errors;
  EXPECT_EQ(nlohmann::json::parse(made.output)["campaigns"], 1);
  const Outcome scored = run("blind score set -o page --json");
  EXPECT_EQ(scored.status, 0) << scored.errors;
  EXPECT_EQ(scored.output, testing_support::text_of(folder / "page/score.json"));
  EXPECT_EQ(nlohmann::json::parse(scored.output)["failed"], 1);  // it was not diagnosed
}

TEST_F(CommandLine, DerivePrintsCertifiedEquations) {
  const Outcome outcome = run("derive two_mass_mode1 --case principal_parametric");
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  for (const char* part : {"frequency response", "vanish exactly", "da_v/dt", "dx_v/dt", "alpha_e = "})
    EXPECT_NE(outcome.output.find(part), std::string::npos) << part;
  const Outcome json = run("derive pendulum --json");
  EXPECT_TRUE(nlohmann::json::parse(json.output)["cases"][0]["certificate"]["holds"].get<bool>());
  EXPECT_NE(run("derive pendulum --format latex").output.find("\\end{document}"), std::string::npos);
  EXPECT_NE(run("derive pendulum --format html").output.find("</math>"), std::string::npos);
  expect_bad_input(run("derive pendulum --format pdf"), "latex");
  expect_bad_input(run("derive two_mass_mode1 --case resonance"), "principal_parametric");
  expect_bad_input(run("derive no_such_model"), "two_mass_mode1");
}

TEST_F(CommandLine, EvaluateIsTheContractsJsonAndByteStable) {
  const std::string values = written(
      "values.json",
      R"({"omega0": 2, "mu1": 0.1, "mu2": 0.2, "mu3": 0.3, "alpha2": 0.4, "alpha3": 0.5, "delta2": 0.6, "delta3": 0.7,
          "eta1": 0.8, "eta2": 0.9, "F": 1, "Omega": 4.1, "sigma": 0.1})");
  const Outcome first = run("evaluate two_mass_mode1 --case principal_parametric --at " + values);
  EXPECT_EQ(first.status, 0) << first.errors;
  EXPECT_EQ(first.output, run("evaluate two_mass_mode1 --case principal_parametric --at " + values).output);
  const auto json = nlohmann::json::parse(first.output);
  EXPECT_EQ(json["omega_policy"], "nominal");
  bool found = false;
  for (const auto& term : json["modulation"]["v"])
    if (term["powers"] == nlohmann::json{{"conj_A_v", 1}, {"F", 1}}) {
      found = true;
      EXPECT_EQ(term["slow_phase"], (nlohmann::json{{"sigma", 1}}));
      // -i eta_e/omega0, thesis Eqs. (5.14) and (5.16)
      EXPECT_NEAR(term["value"][1].get<double>(), -(0.9 / 4 + (0.4 - 3 * 0.6 * 4) * 0.8 / 24) / 2, 1e-15);
    }
  EXPECT_TRUE(found);
  const auto kept = nlohmann::json::parse(
      run("evaluate two_mass_mode1 --case principal_parametric --omega-policy kept --at " + values).output);
  bool direct = false;
  for (const auto& term : kept["harmonics"]["v"]) {
    if (term["phase"] != nlohmann::json{{"Omega", 1}}) continue;
    direct = true;
    EXPECT_NEAR(term["value"][0].get<double>(), 0.4 / (4 - 4.1 * 4.1), 1e-15);
  }
  EXPECT_TRUE(direct);
  expect_bad_input(run("evaluate pendulum --case free --at " + written("few.json", R"({"omega0": 1})")),
                   "has no value for symbol");
  expect_bad_input(run("evaluate pendulum --case free --at " + written("bad.json", "{")), "is not JSON");
}

TEST_F(CommandLine, NumbersBeyondDoublePrecisionAreBadInput) {
  const std::string predict = "predict duffing --case primary --vary Omega 0.8 1.2 -o " + (folder / "out").string();
  for (const char* const number : {"1e999", "-1e400"}) {
    const std::string file = written("big.json", std::string(R"({"omega0": 1, "mu": )") + number + "}");
    expect_bad_input(run("evaluate pendulum --case free --at " + file), number);
    expect_bad_input(run(predict + " --parameters " + file), number);
    const std::string estimate =
        written("estimate.json", std::string(R"({"estimates": [{"name": "mu", "value": )") + number + "}]}");
    expect_bad_input(run(predict + " --parameters " + estimate), number);
  }
}

// A misspelled name changes nothing, and that is said.
TEST_F(CommandLine, NumbersThatStandForNothingAreNamed) {
  const std::string file = written(
      "typo.json", R"({"omega0": 1, "mu": 0.01, "a2": 0, "a3": 0.1, "e": 1, "F": 0.01, "muu": 3, "A3": 2})");
  const Outcome predicted =
      run("predict duffing --case free --parameters " + file + " --largest 0.5 -o " + (folder / "out").string());
  EXPECT_EQ(predicted.status, 0) << predicted.errors;
  EXPECT_NE(predicted.errors.find("A3, muu are not used"), std::string::npos) << predicted.errors;
  const Outcome evaluated = run("evaluate duffing --case free --at " +
                                written("free.json", R"({"omega0": 1, "mu": 0.01, "a2": 0, "a3": 0.1, "mu2": 3})"));
  EXPECT_EQ(evaluated.status, 0) << evaluated.errors;
  EXPECT_NE(evaluated.errors.find("mu2 is not used"), std::string::npos) << evaluated.errors;
}

TEST_F(CommandLine, GenerateWritesWhatIsCommitted) {
  const Outcome outcome = run("generate two_mass_mode1 two_mass_lumps pendulum -o " + (folder / "g").string());
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  for (const char* name : {"two_mass_mode1.hpp", "two_mass_mode1.cpp", "two_mass_lumps.hpp", "two_mass_lumps.cpp",
                           "pendulum.hpp", "pendulum.cpp"})
    EXPECT_EQ(text_of(folder / "g" / name), text_of(root / "generated" / name)) << name;
}

// Limit cycles are found where a case leaves excitation = false out; where it says so, the message leads there.
TEST_F(CommandLine, PredictFindsLimitCycles) {
  std::string text =
      "schema = 1\nname = \"rayleigh\"\n[[mode]]\ncoordinate = \"x\"\nfrequency = \"w\"\nequation = \"D2(x) + "
      "w^2*x = "
      "m*(1 - p*x^2 - r*D(x)^2)*D(x)\"\n[[case]]\nname = \"free\"\nrelations = []\norder = { m = 1, p = 0, r = 0 "
      "}\n"
      "expand_to = 2\n";
  const std::string rest = " --case free --parameters " +
                           written("values.json", R"({"w": 1, "m": 0.1, "p": 1, "r": 0.5})") +
                           " --vary m 0.05 0.1 -o " + (folder / "out").string();
  expect_bad_input(run("predict " + written("backbone.toml", text + "excitation = false\n") + rest),
                   "in a case that does not say excitation = false");
  const Outcome found = run("predict " + written("cycle.toml", text) + rest);
  EXPECT_EQ(found.status, 0) << found.errors;
  EXPECT_NE(found.output.find("branch 2: "), std::string::npos) << found.output;
}

// The files that list all models are not overwritten by a model's own.
TEST_F(CommandLine, GenerateRefusesTheNameOfTheRegistry) {
  const std::string text = text_of(root / "models" / "pendulum.toml");
  std::string renamed = text;
  renamed.replace(renamed.find("\"pendulum\""), 10, "\"registry\"");
  const std::string file = written("mine.toml", renamed);
  expect_bad_input(run("generate duffing " + file + " -o " + (folder / "g").string()), "registry.hpp");
  EXPECT_FALSE(fs::exists(folder / "g"));
}

// Options that make sense, and a motion that leaves every bound: neither bad input nor a fault of the program.
TEST_F(CommandLine, AComputationWithoutResultIsNoBadInput) {
  const std::string values = written("values.json", R"({"omega0": 1, "mu": 0.01, "a2": 0, "a3": -1, "e": 1})");
  const Outcome outcome = run("predict duffing --case primary --parameters " + values +
                              " --at F=5 --vary Omega 0.8 1.2 --sweep up -o " + (folder / "out").string());
  EXPECT_EQ(outcome.status, 1) << outcome.errors;
  EXPECT_NE(outcome.errors.find("grows beyond bounds"), std::string::npos) << outcome.errors;
  EXPECT_EQ(outcome.errors.find("internal error"), std::string::npos) << outcome.errors;
  EXPECT_TRUE(outcome.output.empty()) << outcome.output;
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST_F(CommandLine, SimulateRefusesToOverwriteAndIdentifyRefusesNonsense) {
  const std::string campaign = (folder / "campaign").string();
  ASSERT_EQ(run("simulate experiments/pendulum_decay -o " + campaign).status, 0);
  expect_bad_input(run("simulate experiments/pendulum_decay -o " + campaign), "add --force to replace it");
  const std::string out = " -o " + (folder / "out").string();
  expect_bad_input(run("identify " + campaign + " --model two_mass_mode1 --case principal_parametric" + out),
                   "excitation");
  expect_bad_input(run("identify " + campaign + " --model pendulum --fix nu=1" + out), "is no symbol of model");
  for (const char* const number : {"nan", "inf", "-inf"})
    expect_bad_input(run("identify " + campaign + " --model pendulum --fix mu1=" + number + out),
                     "is not a finite number");
  expect_bad_input(run("identify " + campaign + " --model pendulum --fix mu1=1 --fix mu1=2" + out),
                   "contradicts --fix mu1=1");
  for (const char* const text : {"mu1", "=1", "mu1=", "mu1=x", "mu1=1x"})
    expect_bad_input(run("identify " + campaign + " --model pendulum --fix " + text + out), "is not NAME=VALUE");
  expect_bad_input(run("identify " + campaign + " --model pendulum --fix beta5=1" + out),
                   "is no symbol of model pendulum, but a lump: free:beta5 = ");
  expect_bad_input(run("identify " + campaign + " --model pendulum --from 5 --to 3" + out), "window is empty");
  expect_bad_input(run("identify " + (folder / "nowhere").string() + " --model pendulum" + out), "does not exist");
  EXPECT_FALSE(fs::exists(folder / "out"));
  const Outcome good = run("identify " + campaign + " --model pendulum --by modulation-equations --to 20" + out);
  EXPECT_EQ(good.status, 0) << good.errors;
  const auto estimate = nlohmann::json::parse(text_of(folder / "out/estimate.json"));
  EXPECT_EQ(estimate["schema"], 1);
  EXPECT_EQ(estimate["estimates"][0]["name"], "omega0");
  EXPECT_LT(estimate["quality"]["held_out"][0]["rms"].get<double>(), 0.01);
  const std::string html = text_of(folder / "out/report.html");
  EXPECT_NE(html.find("<svg"), std::string::npos);
  EXPECT_EQ(html.find("http://"), html.find("http://www.w3.org"));  // nothing is fetched
  EXPECT_EQ(report::test::structure_faults(html), std::vector<std::string>());
  for (const char* part : {"two sd by noise and what is left open", "Fit: ", "Autocorrelation",
                           "Parameters in pairs", "--by modulation-equations"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
}

TEST_F(CommandLine, PredictWritesResponsesOrNothing) {
  const std::string out = (folder / "out").string(), start = "predict two_mass_mode1 --case principal_parametric ";
  const std::string shipped = start + "--parameters predictions/table_5_4 -o " + out + " ";
  expect_bad_input(run(shipped + "--vary Omega 150 160"), "no value for F");
  expect_bad_input(run(shipped + "--at F=20 --vary Omega 160 150"), "empty range");
  expect_bad_input(run(shipped + "--at F=20 --vary Phi 150 160"), "is no parameter");
  expect_bad_input(run(shipped + "--at F=20"), "--vary");
  expect_bad_input(run(shipped + "--at F=20 --vary Omega 150 160 --curve hopf"), "--against");
  expect_bad_input(run(start + "--parameters " + written("p.json", R"({"mu1": "x"})") + " -o " + out), "--vary");
  const std::string estimate = written("estimate.json", R"({"estimates": [{"name": "omega0", "value": 77.85},
      {"name": "mu1", "value": 0.2}, {"name": "mu3", "value": 40}, {"name": "alpha3", "value": null},
      {"name": "eta2", "value": 7.7}]})");
  const std::string estimated = start + "--parameters " + estimate + " -o " + out +
                                " --at F=20 --at mu2=0 --at alpha2=0 --at delta2=0 --at delta3=0 --at eta1=0 "
                                "--vary Omega 155 156.5 ";
  expect_bad_input(run(estimated), "no value for alpha3");
  EXPECT_FALSE(fs::exists(out));
  EXPECT_EQ(run(estimated + "--at alpha3=-3e7").status, 0);
  const Outcome good = run(shipped + "--at F=22.55 --vary Omega 24.3 25.1 --hz --force");
  EXPECT_EQ(good.status, 0) << good.errors;
  const auto json = nlohmann::json::parse(text_of(fs::path(out) / "prediction.json"));
  std::size_t thresholds = 0, folds = 0;  // of a closed branch with two solutions that differ in phase alone
  for (const auto& branch : json["branches"])
    for (const auto& special : branch["special_points"]) {
      folds += special["kind"] == "saddle_node";
      if (special["kind"] == "threshold") {
        ++thresholds;
        EXPECT_NEAR(std::abs(special["Omega_hz"].get<double>() - 24.78), 0.16252, 1e-5);  // Eq. (5.27)
      }
    }
  EXPECT_EQ(folds, 1u);
  EXPECT_GE(thresholds, 2u);
  const std::string html = text_of(fs::path(out) / "report.html");
  EXPECT_NE(html.find("<svg"), std::string::npos);
  EXPECT_EQ(report::test::structure_faults(html), std::vector<std::string>());
  EXPECT_NE(text_of(fs::path(out) / "response.svg").find("<svg"), std::string::npos);
  EXPECT_NE(text_of(fs::path(out) / "prediction.csv").find("branch,kind,Omega,stable,amplitude_v"),
            std::string::npos);
  const Outcome curve = run(
      shipped + "--vary Omega 24.3 25.1 --against F 15 30 --curve saddle_node --largest 2e-3 --hz --json --force");
  EXPECT_EQ(curve.status, 0) << curve.errors;
  EXPECT_GT(nlohmann::json::parse(curve.output)["curves"][0]["points"].size(), 10u);
  const Outcome combination =
      run("predict two_mass_lumps --parameters predictions/table_6_2 --at F=23.3 --hz "
          "--vary Omega 45.3 45.75 --force -o " +
          out);
  EXPECT_EQ(combination.status, 0) << combination.errors;
  for (const char* part : {"45.4876 Hz", "45.5607 Hz", "common phase of v1 and v2"})
    EXPECT_NE(combination.output.find(part), std::string::npos) << combination.output;
  const Outcome free =
      run("predict two_mass_mode1 --case free --parameters predictions/table_5_4 --largest 1e-3 --force -o " + out);
  EXPECT_EQ(free.status, 0) << free.errors;
  EXPECT_EQ(nlohmann::json::parse(text_of(fs::path(out) / "prediction.json"))["backbones"][0]["mode"], "v");
}

TEST_F(CommandLine, UniversalFilesAreInspectedAndImported) {
  const std::string axis = "         0    0    0    0 NONE                 NONE                \n";
  const std::string file =
      written("run.unv",
              "    -1\n    58\ntip\nNONE\nNONE\nNONE\nNONE\n"
              "    1         0    0         0 NONE               1   1 NONE               0   0\n"
              "         2         3         1  0.00000E+00  2.44141E-04  0.00000E+00\n"
              "        17    0    0    0 Time                 s                   \n"
              "        12    0    0    0 Acceleration         g                   \n" +
                  axis + axis + "  1.00000E+00 -2.50000E+00  3.00000E-03\n    -1\n");
  const Outcome inspected = run("inspect " + file);
  EXPECT_EQ(inspected.status, 0) << inspected.errors;
  EXPECT_NE(inspected.output.find("UFF 58 with 2 numeric variables"), std::string::npos) << inspected.output;
  EXPECT_NE(inspected.output.find("at 4096 Hz"), std::string::npos) << inspected.output;
  EXPECT_NE(inspected.output.find("m/s^2 (from g)"), std::string::npos) << inspected.output;
  const std::string campaign = (folder / "campaign").string();
  expect_bad_input(run("import " + file + " -o " + campaign + " --kind impact"),
                   "--channel NAME:ROLE, for example tip");
  const Outcome imported = run("import " + file + " -o " + campaign + " --kind impact --channel tip:response");
  EXPECT_EQ(imported.status, 0) << imported.errors;
  EXPECT_NE(imported.output.find("tip: 'g' in the file, m/s^2 in the campaign"), std::string::npos);
  EXPECT_NE(text_of(folder / "campaign/records/run.csv").find("0,9.80665\n"), std::string::npos);
  expect_bad_input(run("inspect " + written("cut.unv", text_of(file).substr(0, 500))), "cut.unv, line");
}

TEST_F(CommandLine, MeasuredPendulumFollowsTheGeometryOfTheSine) {
  const fs::path data = root.parent_path() / "shared/data/pendulum/cdip_pend_data.mat";
  if (!fs::exists(data)) GTEST_SKIP() << data << " is not here: the measured pendulum is not checked";
  const std::string campaign = (folder / "campaign").string(), out = (folder / "out").string();
  ASSERT_EQ(run("import " + data.string() + " -o " + campaign +
                " --kind free_decay --time t --channel theta:response:angle:rad")
                .status,
            0);
  ASSERT_EQ(run("identify " + campaign + " --model pendulum --to 43 -o " + out).status, 0);
  const auto estimate = nlohmann::json::parse(text_of(fs::path(out) / "estimate.json"));
  const auto value = [&](const std::string& name) {
    for (const auto& entry : estimate["estimates"])
      if (entry["name"] == name) return entry["value"].get<double>();
    return std::nan("");
  };
  const double square = value("omega0") * value("omega0");
  EXPECT_NEAR(value("alpha3") / square, -1.0 / 6, 0.03 / 6);
  EXPECT_NEAR(square, 33.3, 0.333);
  EXPECT_LT(estimate["quality"]["held_out"][0]["rms"].get<double>() * 180 / 3.14159265358979, 0.6);
}

}  // namespace
}  // namespace secular
