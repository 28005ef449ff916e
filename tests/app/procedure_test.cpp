// `secular procedure` on the virtual chapter 5 campaign: recovered beside true beside printed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/procedure/thesis_procedures.hpp"
#include "generated/registry.hpp"
#include "input/input_error.hpp"
#include "measure/data/campaign.hpp"
#include "tests/app/other_dwells.hpp"
#include "tests/campaign/write_campaign.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"
#include "tests/simulate/simulated_campaign.hpp"

namespace secular::app {
namespace {

namespace fs = std::filesystem;

void simulate(const std::string& experiment, const std::string& name, const fs::path& folder) {
  fs::remove_all(folder);
  const fs::path file = testing_support::source_folder() / "models/experiments" / (experiment + ".toml");
  const CompiledModel& model = *generated::find_compiled_model(name);
  const SimulatedCampaign simulated = run_virtual_test(read_experiment(file, model), model, 1, 2);
  write_campaign(simulated.campaign, simulated.samples, folder);
}

const ProcedureRow& row(const ProcedureRun& run, const std::string& method, const std::string& name) {
  for (const ProcedureSection& section : run.sections)
    for (const ProcedureRow& r : section.rows)
      if (section.method == method && r.name == name) return r;
  throw std::out_of_range(method + ": " + name);
}

class SlowProcedure : public testing::Test {
 protected:
  static fs::path folder() { return testing_support::process_folder() / "secular_procedure_chapter5"; }
  static void SetUpTestSuite() { simulate("thesis_chapter5", "two_mass_mode1", folder()); }
  static void TearDownTestSuite() { fs::remove_all(folder()); }

  static ProcedureRequest request() {
    ProcedureRequest r;
    r.campaign = folder().string();
    r.model = "two_mass_mode1";
    r.truth = "experiments/thesis_chapter5";
    return r;
  }
};

TEST_F(SlowProcedure, SetsRecoveredBesideTrueBesidePrinted) {
  const ProcedureRun run = run_procedures(request());
  EXPECT_EQ(run.measured.observations.size(), 190u);  // 8 and 11 conditions of ten ensembles
  const ProcedureRow& frequency = row(run, "jump_frequencies", "omega0");
  EXPECT_LT(std::abs(frequency.recovered - *frequency.truth), 2 * *frequency.sd);
  const ProcedureRow& eta1 = row(run, "harmonic", "eta1");
  EXPECT_NEAR(eta1.recovered, *eta1.truth, 0.02 * std::abs(*eta1.truth));
  EXPECT_NEAR(*eta1.as_printed, -eta1.recovered, 0.02 * std::abs(*eta1.truth)) << "the sign misprint of (5.38)";
  EXPECT_EQ(eta1.source, -17.99e-3);
  const ProcedureRow& stiffness = row(run, "frequency_response", "alpha_e");
  EXPECT_NEAR(stiffness.recovered, *stiffness.truth, 0.03 * std::abs(*stiffness.truth));
  // Without their biases both are where they belong, and the error bars are less than what the biases were.
  for (const ProcedureRow* r : {&eta1, &stiffness}) {
    ASSERT_TRUE(r->bias) << r->name;
    EXPECT_LT(std::abs(r->best() - *r->truth), 4 * r->bias->sd()) << r->name;
    EXPECT_LT(r->bias->sd(), 0.1 * std::abs(r->bias->value)) << r->name;
  }
  // The cubic law is chosen: only it gets a frequency response.
  EXPECT_NO_THROW(row(run, "frequency_response", "mu3"));
  EXPECT_THROW(row(run, "frequency_response", "mu2"), std::out_of_range);
  const nlohmann::json document = nlohmann::json::parse(procedures_json(run));
  EXPECT_EQ(document["schema"], 1);
  EXPECT_EQ(document["ensembles"], 190);
  EXPECT_NE(procedures_report(run, "command").find("Saddle-node regression"), std::string::npos);
}

TEST_F(SlowProcedure, OneLevelIsNotEnoughForASaddleNodeDiagram) {
  ProcedureRequest one = request();
  one.bias = false;
  one.window.records = "*001[1-5]*";  // no such pattern: [ ] are plain characters
  EXPECT_THROW(run_procedures(one), InputError);
  one.window.records = "records/001*.csv";
  const ProcedureRun run = run_procedures(one);
  bool said = false;
  for (const std::string& warning : run.warnings) said = said || warning.find("level") != std::string::npos;
  EXPECT_TRUE(said);
  EXPECT_THROW(row(run, "saddle_node", "mu1/|eta_e|"), std::out_of_range);
}

TEST_F(SlowProcedure, TermsOfTheAnalysisOfVarianceAreNamed) {
  ProcedureRequest r = request();
  r.methods = {"anova"};
  r.left_out = {"mu2"};
  r.terms = {{"mu1", "mu3"}};
  const ProcedureRun run = run_procedures(r);
  ASSERT_EQ(run.sections.back().anova.size(), 2u);
  EXPECT_NE(run.sections.back().anova[0].first.find("weighted"), std::string::npos);
  EXPECT_NE(run.sections.back().anova[1].first.find("equal weights"), std::string::npos);
  for (const auto& [name, table] : run.sections.back().anova) {
    EXPECT_EQ(table.rows.back().name, "mu1, mu3") << name;
    EXPECT_EQ(table.rows.back().degrees_of_freedom, 2) << name;
    EXPECT_LT(table.rows.back().clustered_p, 1e-6) << name;
  }
  r.terms = {{"nothing"}};
  EXPECT_THROW(run_procedures(r), InputError);
}

// Chapter 6: what (6.49)-(6.52) make of 31 dwells of ten ensembles, and every table beside it.
TEST(Procedure, AnyCaseOfDwellsHasAnAnalysisOfVariance) {
  const fs::path folder = testing_support::process_folder() / "secular_procedure_primary";
  simulate("primary_resonance", "two_mass_mode1", folder);
  ProcedureRequest request;
  request.campaign = folder.string();
  request.model = "two_mass_mode1";
  request.resonance = "primary";
  EXPECT_THROW(run_procedures(request), InputError) << "no case of the source's procedures";
  request.methods = {"anova"};
  const ProcedureRun run = run_procedures(request);
  ASSERT_EQ(run.sections.size(), 1u);
  ASSERT_EQ(run.sections[0].anova.size(), 2u);
  std::vector<std::string> terms;
  for (const AnovaRow& row : run.sections[0].anova[0].second.rows) terms.push_back(row.name);
  for (const char* term : {"mu1", "mu3", "alpha_e", "eta1", "omega0"})
    EXPECT_NE(std::find(terms.begin(), terms.end(), term), terms.end()) << term;
  request.resonance = "nowhere";
  EXPECT_THROW(run_procedures(request), InputError);
  fs::remove_all(folder);
}

// Of six short dwells two ring down at their own frequency below the threshold of the resonance: they are no steady
// motion, which is said, and what five ensembles tell stands.
TEST(Procedure, GoesOnWithoutDwellsThatRingDown) {
  const struct {
    double frequency_hz, level, ensemble_s, settle_s, displacement;
    int ensembles;
  } dwells[] = {{24.64925565007103, 19.12604403664527, 1, 1, 0.003, 1},
                {24.74922956682069, 14.274335188380507, 1, 5, 0.0001, 1},
                {24.862679180998832, 6.53976064453172, 1, 1, 0.01, 1},
                {24.68196612895178, 5.564599531521013, 4, 1, 0.0001, 1},
                {24.88120001301066, 16.674244582896037, 4, 30, 0.01, 2},
                {24.793715821577358, 27.77416328598115, 1, 1, 0.0001, 1}};
  std::string text;
  for (const auto& d : dwells)
    text += fmt::format(
        "[[dwell]]\nfrequencies_hz = [{}]\namplitudes = [{}]\nensembles = {}\nensemble_s = {:.1f}\nsettle_s = "
        "{:.1f}\n"
        "initial_displacement = [{}]\ngroup = \"level\"\n",
        d.frequency_hz, d.level, d.ensembles, d.ensemble_s, d.settle_s, d.displacement);
  const fs::path folder = testing_support::process_folder() / "secular_procedure_few";
  ProcedureRequest request;
  request.campaign = testing_support::campaign_of_other_dwells(text, folder).string();
  request.model = "two_mass_mode1";
  request.bias = false;
  const ProcedureRun run = run_procedures(request);
  for (const char* record : {"0003", "0004"})
    EXPECT_TRUE(std::any_of(run.warnings.begin(), run.warnings.end(), [&](const std::string& warning) {
      return warning.find(record) != std::string::npos && warning.find("its response is at") != std::string::npos;
    })) << record;
  EXPECT_NO_THROW(row(run, "saddle_node", "mu3/|eta_e|"));
  EXPECT_NO_THROW(row(run, "harmonic", "eta1"));
  fs::remove_all(folder);
}

TEST(Procedure, RefusesCasesItDoesNotCover) {
  ProcedureRequest r;
  r.campaign = "nowhere";
  r.model = "pendulum";
  EXPECT_THROW(run_procedures(r), InputError);
}

}  // namespace
}  // namespace secular::app
