// Where commands write: never where they read, over nothing without --force, and all of it or none.
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/app/duffing_decay.hpp"
#include "tests/app/program_run.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;
using testing_support::Outcome;
using testing_support::text_of;

class OutputTarget : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    write("experiment.toml", testing_support::duffing_decay());
    fs::copy_file(testing_support::source_folder() / "models/duffing.toml", folder_ / "model.toml");
    write("p.json", R"({"omega0": 1, "mu": 0.01, "a2": 0, "a3": 0.1, "e": 1, "F": 0.01})");
  }
  void TearDown() override { fs::remove_all(folder_); }

  Outcome run(const std::string& arguments) const { return testing_support::run_program(folder_, arguments); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
  void done(const std::string& arguments) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << arguments << outcome.errors;
  }
  void refused(const std::string& arguments, const std::string& part) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments << outcome.output;
    EXPECT_NE(outcome.errors.find(part), std::string::npos) << arguments << "\n" << outcome.errors;
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
  }
  // Nothing hidden is left beside results.
  void expect_no_left_overs() const {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_))
      EXPECT_EQ(entry.path().string().find("unfinished"), std::string::npos) << entry.path();
  }

  fs::path folder_ = testing_support::process_folder() / "output_target";
};

TEST_F(OutputTarget, IsNeverWhatIsRead) {
  done("simulate experiment.toml -o campaign");
  const std::string before = text_of(folder_ / "campaign/campaign.toml");
  fs::create_directory_symlink(folder_ / "campaign", folder_ / "link");
  for (const std::string force : {"", " --force"}) {
    for (const std::string command :
         {"identify campaign --model duffing", "diagnose campaign --model duffing", "modal campaign",
          "spectrum campaign", "procedure campaign --model duffing"}) {
      refused(command + " -o campaign" + force, "is the ");
      refused(command + " -o ./campaign/../campaign/" + force, "is the ");
      refused(command + " -o campaign/results" + force, "lies inside the ");
      refused(command + " -o link/results" + force, "lies inside the ");
      refused(command + " -o ." + force, "contains the ");
    }
    refused("identify campaign --model model.toml -o model.toml" + force, "is the model");
    refused("derive model.toml -o model.toml" + force, "is the model");
    refused("derive model.toml -o ./campaign/../model.toml" + force, "is the model");
    refused("generate model.toml -o ." + force, "contains the model");
    refused("predict model.toml --parameters p.json --case primary --vary Omega 0.8 1.2 -o p.json" + force,
            "is the file of parameters");
    refused("simulate experiment.toml -o experiment.toml" + force, "is the experiment");
    refused("import campaign/records/0001.csv --kind free_decay --channel x:response:displacement:m -o campaign" +
                force,
            "contains the file");
    refused("modal campaign --basis campaign/campaign.toml -o out" + force, "lies inside the campaign");
  }
  EXPECT_EQ(text_of(folder_ / "campaign/campaign.toml"), before);
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

using SlowOutputTarget = OutputTarget;

TEST_F(SlowOutputTarget, IsReplacedWithForceAlone) {
  const std::vector<std::pair<std::string, std::string>> commands = {
      {"simulate experiment.toml -o campaign", "campaign/campaign.toml"},
      {"import campaign/records/0001.csv --kind free_decay --channel x:response:displacement:m -o imported",
       "imported/campaign.toml"},
      {"identify campaign --model duffing -o identified", "identified/estimate.json"},
      {"diagnose campaign --model duffing -o diagnosed", "diagnosed/diagnosis.json"},
      {"spectrum campaign -o spectrum", "spectrum/spectrum.json"},
      {"modal campaign --modes 1 --modal-mass 1 --basis basis.toml -o modal", "modal/modal.json"},
      {"predict duffing --parameters p.json --case primary --vary Omega 0.8 1.2 -o predicted",
       "predicted/prediction.json"},
      {"plan duffing --case primary --parameters p.json --for mu --range-frequency 0.14:0.18 --range-amplitude "
       "0.005:0.01 --frequencies 7 --levels 1 --sample-rate 4 --ensemble-s 60 --budget-s 100000 --settle-limit "
       "10000 "
       "-o planned",
       "planned/plan.json"},
      {"generate duffing -o generated", "generated/duffing.cpp"},
      {"derive duffing -o derived.txt", "derived.txt"}};
  for (const auto& [command, file] : commands) {
    SCOPED_TRACE(command);
    done(command);
    const std::string first = text_of(folder_ / file);
    EXPECT_FALSE(first.empty());
    refused(command, "exists; name another place, or add --force to replace it");
    EXPECT_EQ(text_of(folder_ / file), first);
    done(command + " --force");
    EXPECT_EQ(text_of(folder_ / file), first);  // --force is no part of a result
    if (file.ends_with("campaign.toml") || file == "derived.txt") continue;
    // Of an old result that the new one has not, nothing is left; an empty folder is none.
    const fs::path out = (folder_ / file).parent_path();
    fs::remove_all(out);
    fs::create_directory(out);
    if (command.starts_with("modal")) fs::remove(folder_ / "basis.toml");
    done(command);
  }
  expect_no_left_overs();
}

// A folder that bears the name of a shipped model is none.
TEST_F(OutputTarget, MayBearTheNameOfAModel) {
  done("generate duffing -o duffing");
  done("generate duffing -o duffing --force");
  refused("generate duffing -o duffing", "add --force");
  fs::create_directory(folder_ / "experiments");
  done("simulate experiments/pendulum_decay -o experiments/pendulum_decay");
  done("simulate experiments/pendulum_decay -o experiments/pendulum_decay --force");
}

TEST_F(OutputTarget, OnlyResultsAreReplaced) {
  done("simulate experiment.toml -o campaign");
  const std::string identify = "identify campaign --model duffing --force -o ";
  fs::create_directories(folder_ / "mine");
  write("mine/thesis.tex", "years of work");
  refused(identify + "mine", "holds thesis.tex, which this command does not write");
  refused("generate duffing --force -o mine", "holds thesis.tex");
  refused("simulate experiment.toml --force -o mine", "is no campaign");
  refused(identify + "p.json/out", "cannot be created");
  refused(identify + "p.json", "exists and is no folder");
  // A note beside results, results of another command, and code that is not generated.
  done(identify + "identified");
  refused("spectrum campaign --force -o identified", "does not write");
  write("identified/notes.txt", "mine");
  refused(identify + "identified", "holds notes.txt");
  done("generate duffing -o code");
  write("code/mine.cpp", "int mine;");
  refused("generate duffing --force -o code", "holds mine.cpp");
  // A campaign that somebody has changed, or keeps other things in.
  write("campaign/photograph.jpg", "x");
  refused("simulate experiment.toml --force -o campaign", "holds photograph.jpg");
  fs::remove(folder_ / "campaign/photograph.jpg");
  std::ofstream(folder_ / "campaign/campaign.toml", std::ios::app) << "# the mass was changed before this\n";
  refused("simulate experiment.toml --force -o campaign", "is not as a command writes it");
  EXPECT_EQ(text_of(folder_ / "mine/thesis.tex"), "years of work");
  EXPECT_EQ(text_of(folder_ / "code/mine.cpp"), "int mine;");
}

TEST_F(OutputTarget, WhatFailsLeavesTheOldResult) {
  done("simulate experiment.toml -o campaign");
  done("identify campaign --model duffing -o out");
  const std::string before = text_of(folder_ / "out/estimate.json");
  EXPECT_EQ(run("identify campaign --model duffing --records none --force -o out").status, 2);
  EXPECT_EQ(text_of(folder_ / "out/estimate.json"), before);
  expect_no_left_overs();
}

TEST_F(OutputTarget, AnInterruptedCommandLeavesNothing) {
  // Dwells that take far longer than this test waits.
  std::string text = text_of(folder_ / "experiment.toml");
  text.replace(text.find("duration_s = 60.0"), 17, "duration_s = 200000.0");
  for (int i = 0; i < 100; ++i) text += "[[free_decay]]\ninitial_displacement = [0.5]\nduration_s = 200000.0\n";
  write("long.toml", text);
  const std::string program = testing_support::program();
  for (const std::string signal : {"TERM", "INT"}) {
    // A shell without job control has its background jobs ignore SIGINT; with it, as a user's, they do not.
    const std::string script = "cd " + folder_.string() + "; set -m; " + program +
                               " simulate long.toml -o new/parent/never & p=$!; for i in $(seq 200); do ls -A "
                               "new/parent 2>&1 | grep -q unfinished && break; sleep 0.05; done; ls -A new/parent "
                               "> seen.txt; kill -" +
                               signal + " $p; wait $p; echo $? > status.txt";
    ASSERT_EQ(std::system(("bash -c '" + script + "' > " + (folder_ / "run.txt").string() + " 2>&1").c_str()), 0);
    EXPECT_NE(text_of(folder_ / "seen.txt").find(".never.unfinished-"), std::string::npos) << signal;
    EXPECT_EQ(text_of(folder_ / "status.txt"), signal == "TERM" ? "143\n" : "130\n");
    EXPECT_FALSE(fs::exists(folder_ / "new")) << signal;
  }
}

TEST_F(OutputTarget, QuietKeepsWarningsInTheResult) {
  done("simulate experiment.toml -o campaign");
  const std::string command = "predict duffing --parameters typo.json --case free --largest 0.5 -o ";
  write("typo.json", R"({"omega0": 1, "mu": 0.01, "a2": 0, "a3": 0.1, "e": 1, "F": 0.01, "muu": 3})");
  const Outcome loud = run(command + "loud"), quiet = run(command + "quiet --quiet");
  EXPECT_NE(loud.errors.find("warning: "), std::string::npos) << loud.errors;
  EXPECT_EQ(quiet.errors, "");
  EXPECT_EQ(run("--quiet " + command + "quiet --force").errors, "");
  EXPECT_EQ(text_of(folder_ / "quiet/prediction.csv"), text_of(folder_ / "loud/prediction.csv"));
  EXPECT_NE(text_of(folder_ / "quiet/prediction.json").find("muu"), std::string::npos);
  EXPECT_NE(run(command + "quiet --quiet").errors.find("add --force"), std::string::npos);  // errors stay
  EXPECT_EQ(run("--version").output, "secular 0.1.0\n");
}

}  // namespace
}  // namespace secular
