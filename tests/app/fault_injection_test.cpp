// Every command that writes, killed at random moments, on a full disk, where nothing may be written and without a
// compiler: what it leaves is a whole result or none, and it says why in one line.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
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

// A command without its -o, and the files that its result always has.
struct WritingCommand {
  std::string name, arguments;
  std::vector<std::string> files;
};

const std::vector<WritingCommand> writing_commands = {
    {"simulate", "simulate experiment.toml", {"campaign.toml", "records/0001.csv"}},
    {"import",
     "import campaign/records/0001.csv --kind free_decay --channel x:response:displacement:m",
     {"campaign.toml", "records/0001.csv"}},
    {"identify", "identify campaign --model duffing", {"estimate.json", "report.html"}},
    {"diagnose", "diagnose campaign --model duffing", {"diagnosis.json", "report.html"}},
    {"spectrum", "spectrum campaign", {"spectrum.json", "report.html"}},
    {"modal", "modal campaign --modes 1", {"modal.json", "report.html"}},
    {"predict",
     "predict duffing --parameters p.json --case primary --vary Omega 0.8 1.2",
     {"prediction.json", "prediction.csv"}},
    {"plan",
     "plan duffing --case primary --parameters p.json --for mu --range-frequency 0.14:0.18 --range-amplitude "
     "0.005:0.01 --frequencies 7 --levels 1 --sample-rate 4 --ensemble-s 60 --budget-s 100000 --settle-limit 10000",
     {"plan.json"}},
    {"generate", "generate duffing", {"registry.hpp", "duffing.cpp"}},
    {"derive", "derive duffing", {}}};

class FaultInjection : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = testing_support::process_folder() /
              ("faults_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    write("experiment.toml", testing_support::duffing_decay());
    write("p.json", R"({"omega0": 1, "mu": 0.01, "a2": 0, "a3": 0.1, "e": 1, "F": 0.01})");
    ASSERT_EQ(run("simulate experiment.toml -o campaign").status, 0);
  }
  void TearDown() override { fs::remove_all(folder_); }

  Outcome run(const std::string& arguments, const std::string& environment = "") const {
    return testing_support::run_program(folder_, arguments, {.environment = environment});
  }
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }

  // With job control, as a user's shell has it: interrupts are not ignored. `script` knows the program as $S and
  // has function ms: milliseconds since an origin.
  std::string shell(const std::string& script) const {
    write("script.sh", "set -m\nms() { echo $(($(date +%s%N) / 1000000)); }\n" + script);
    const std::string line = "cd " + folder_.string() + " && S=" + testing_support::program() +
                             " bash script.sh > shell.txt 2>&1 < /dev/null";
    EXPECT_EQ(std::system(line.c_str()), 0) << text_of(folder_ / "shell.txt");
    return text_of(folder_ / "shell.txt");
  }

  std::vector<std::string> left_overs() const {
    std::vector<std::string> found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_)) {
      const std::string name = entry.path().filename().string();
      if (name.find("unfinished") != std::string::npos || name.find(".partial") != std::string::npos)
        found.push_back(entry.path().string());
    }
    return found;
  }

  static void expect_whole(const fs::path& out, const WritingCommand& command) {
    for (const std::string& file : command.files) {
      const std::string text = text_of(out / file);
      EXPECT_FALSE(text.empty()) << out / file;
      if (file.ends_with(".json")) {
        EXPECT_TRUE(nlohmann::json::accept(text)) << out / file;
      }
    }
  }

  // A sealed set of two campaigns, and in place of the program that is checked one that starts another, which works
  // for so many seconds.
  void write_set_and_program(const std::string& seconds) const {
    for (const std::string place : {"set/case_0001", "set/case_0002"}) fs::create_directories(folder_ / place);
    write("set/set.json", R"({"schema": 1, "seed": 1, "set": "short", "cases": 2})");
    write("set/labels.sha256", "of labels that nobody opens");
    write("slow.sh",
          "#!/bin/sh\ncase \"$*\" in *--help*) echo '--model --threads'; exit 0;; esac\nsleep " + seconds + "\n");
    fs::permissions(folder_ / "slow.sh", fs::perms::owner_all);
  }

  // Of two that write into one folder at least one comes to its end, and the other one says why it does not.
  void expect_one_at_a_time(const std::string& command) const {
    fs::remove_all(folder_ / "both");
    shell("$S " + command + " -o both 2> a.txt & p=$!\n$S " + command +
          " -o both 2> b.txt & q=$!\nwait $p; a=$?\nwait $q; b=$?\necho $a $b > both.txt\n");
    int a = -1, b = -1;
    std::ifstream(folder_ / "both.txt") >> a >> b;
    EXPECT_TRUE(a == 0 || b == 0) << text_of(folder_ / "a.txt") << text_of(folder_ / "b.txt");
    for (const auto& [status, file] : {std::pair(a, "a.txt"), std::pair(b, "b.txt")}) {
      EXPECT_TRUE(status == 0 || status == 2) << status << text_of(folder_ / file);
      if (status == 2) {
        EXPECT_NE(text_of(folder_ / file).find("both"), std::string::npos) << text_of(folder_ / file);
      }
    }
    EXPECT_EQ(left_overs(), std::vector<std::string>{});
  }

  fs::path folder_;
};
using SlowFaultInjection = FaultInjection;

TEST_F(SlowFaultInjection, KilledAtAnyMomentLeavesAWholeResultOrNone) {
  std::mt19937 random(5);
  for (const WritingCommand& command : writing_commands) {
    SCOPED_TRACE(command.name);
    const auto begun = std::chrono::steady_clock::now();
    ASSERT_EQ(run(command.arguments + " -o whole_" + command.name).status, 0);
    const double takes = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    for (const std::string signal : {"TERM", "INT", "KILL"}) {
      for (int trial = 0; trial < 2; ++trial) {
        const fs::path out = folder_ / ("out_" + command.name);
        fs::remove_all(out);
        const double moment = std::uniform_real_distribution<>(0, 1.1 * takes)(random);
        const std::string text =
            shell("$S " + command.arguments + " -o " + out.string() + " > said.txt 2> errors.txt & p=$!\nsleep " +
                  std::to_string(moment) + "\na=$(ms); kill -" + signal +
                  " $p 2>/dev/null; wait $p 2>/dev/null; echo $? $(($(ms) - a)) > ended.txt\n");
        int status = 0, milliseconds = 0;
        std::ifstream(folder_ / "ended.txt") >> status >> milliseconds;
        EXPECT_LT(milliseconds, 1000) << signal << " at " << moment << " s\n" << text;
        if (fs::exists(out)) expect_whole(out, command);
        if (status == 0) {
          EXPECT_TRUE(fs::exists(out));
        }
        if (signal != "KILL") {
          EXPECT_EQ(left_overs(), std::vector<std::string>{}) << signal << " at " << moment << " s";
        }
        for (const std::string& left : left_overs()) fs::remove_all(left);
      }
    }
  }
}

TEST_F(FaultInjection, WhatAKilledCommandLeftIsRemovedByTheNext) {
  std::string text = testing_support::duffing_decay();
  text.replace(text.find("duration_s = 60.0"), 17, "duration_s = 200000.0");
  for (int i = 0; i < 100; ++i) text += "[[free_decay]]\ninitial_displacement = [0.5]\nduration_s = 200000.0\n";
  write("long.toml", text);
  // While it is at work, a second one is refused; when it has been killed, what it left does not last.
  shell(
      "$S simulate long.toml -o out & p=$!\nfor i in $(seq 400); do ls -A | grep -q unfinished && break; sleep "
      "0.02; "
      "done\n$S simulate experiment.toml -o out 2> second.txt; echo $? > second_status.txt\nkill -KILL $p; wait "
      "$p\n"
      "true\n");
  EXPECT_EQ(text_of(folder_ / "second_status.txt"), "2\n");
  EXPECT_NE(text_of(folder_ / "second.txt").find("another command is writing it"), std::string::npos)
      << text_of(folder_ / "second.txt");
  EXPECT_EQ(left_overs().size(), 1U);
  ASSERT_EQ(run("simulate experiment.toml -o out").status, 0);
  EXPECT_EQ(left_overs(), std::vector<std::string>{});
}

TEST_F(FaultInjection, TwoAtOnceAreOneAfterTheOtherOrRefused) {
  for (int trial = 0; trial < 3; ++trial) expect_one_at_a_time("generate duffing");
}

TEST_F(SlowFaultInjection, TwoSetsAtOnceAreOneAfterTheOtherOrRefused) {
  expect_one_at_a_time("blind generate --campaigns 2");
}

TEST_F(FaultInjection, ProgramsOfABlindRunEndWithIt) {
  write_set_and_program("77.3125");
  for (const std::string signal : {"TERM", "INT"}) {
    shell(
        "$S blind run set --program ./slow.sh --threads 2 2> errors.txt & p=$!\nfor i in $(seq 400); do test "
        "$(pgrep "
        "-cf '^sleep 77.3125') = 2 && break; sleep 0.02; done\npgrep -cf '^sleep 77.3125' > before.txt\na=$(ms); "
        "kill "
        "-" +
        signal +
        " $p; wait $p; echo $? $(($(ms) - a)) > ended.txt\npgrep -cf '^sleep 77.3125' > after.txt\ntrue\n");
    EXPECT_EQ(text_of(folder_ / "before.txt"), "2\n");
    EXPECT_EQ(text_of(folder_ / "after.txt"), "0\n");
    int status = 0, milliseconds = 0;
    std::ifstream(folder_ / "ended.txt") >> status >> milliseconds;
    EXPECT_EQ(status, signal == "TERM" ? 143 : 130);
    EXPECT_LT(milliseconds, 1000);
    EXPECT_NE(text_of(folder_ / "errors.txt").find("the same command goes on with the rest"), std::string::npos);
    EXPECT_FALSE(fs::exists(folder_ / "set/case_0001/run.json"));  // it is no campaign that has been diagnosed
  }
}

// Ctrl-Z and fg. The time between counts as none.
TEST_F(FaultInjection, ProgramsOfABlindRunStopAndGoOnWithIt) {
  write_set_and_program("0.6875");
  shell(
      "$S blind run set --program ./slow.sh --threads 2 --limit 2 > said.txt & p=$!\nfor i in $(seq 400); do test "
      "$(pgrep -cf '^sleep 0.6875') = 2 && break; sleep 0.01; done\nall=\"$p $(pgrep -f '^sleep 0.6875')\"\nkill "
      "-TSTP $p\nfor i in $(seq 100); do ps -o stat= -p $p | grep -q T && break; sleep 0.01; done\n"
      "ps -o stat= -p $all | cut -c 1 > stopped.txt\nsleep 2.2\nkill -CONT $p\na=147; while test $a = 147; do wait "
      "$p; a=$?; done; echo $a > ended.txt\n");
  EXPECT_EQ(text_of(folder_ / "stopped.txt"), "T\nT\nT\n");
  EXPECT_EQ(text_of(folder_ / "ended.txt"), "0\n");
  for (const std::string place : {"set/case_0001", "set/case_0002"}) {
    const nlohmann::json run = nlohmann::json::parse(text_of(folder_ / place / "run.json"));
    EXPECT_EQ(run["out_of_time"], false);
    EXPECT_EQ(run["status"], 0);
    EXPECT_LT(run["seconds"], 2);
  }
}

TEST_F(FaultInjection, AFullDiskIsSaid) {
  for (const WritingCommand& command : writing_commands) {
    if (command.name == "diagnose" || command.name == "plan") continue;  // seconds, and the same writing
    SCOPED_TRACE(command.name);
    // Files may not grow beyond 1 kB; what is printed goes to memory.
    shell("(ulimit -f 1; $S " + command.arguments + " -o full > /dev/null 2> errors.txt)\necho $? > status.txt\n");
    EXPECT_EQ(text_of(folder_ / "status.txt"), "2\n");
    EXPECT_NE(text_of(folder_ / "errors.txt").find("cannot be written"), std::string::npos)
        << text_of(folder_ / "errors.txt");
    EXPECT_FALSE(fs::exists(folder_ / "full"));
    EXPECT_EQ(left_overs(), std::vector<std::string>{});
  }
  shell("$S derive duffing > /dev/full 2> errors.txt; echo $? > status.txt\n");
  EXPECT_EQ(text_of(folder_ / "status.txt"), "2\n");
  EXPECT_NE(text_of(folder_ / "errors.txt").find("standard output cannot be written"), std::string::npos);
}

TEST_F(FaultInjection, APlaceWithoutPermissionIsSaid) {
  // Nobody, root included, may make anything in /proc.
  for (const WritingCommand& command : writing_commands) {
    if (command.name == "diagnose" || command.name == "plan") continue;
    const Outcome outcome = run(command.arguments + " -o /proc/secular/out");
    EXPECT_EQ(outcome.status, 2) << command.name << outcome.errors;
    EXPECT_NE(outcome.errors.find("/proc/secular"), std::string::npos) << outcome.errors;
  }
  EXPECT_EQ(run("blind generate --campaigns 1 -o /proc/secular/out").status, 2);
}

TEST_F(FaultInjection, WithoutACompilerModelsAreInterpreted) {
  std::string model = text_of(testing_support::source_folder() / "models/duffing.toml");
  model.replace(model.find("\"duffing\""), 9, "\"other\"");
  write("model.toml", model);
  const std::string nowhere = "PATH=/nowhere CXX= XDG_CACHE_HOME=" + (folder_ / "cache").string();
  // `env` itself is looked up before.
  const Outcome outcome = run("identify campaign --model model.toml -o without", nowhere);
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  ASSERT_EQ(run("identify campaign --model model.toml -o interpreted --interpret").status, 0);
  const auto estimates = [&](const std::string& out) {
    return nlohmann::json::parse(text_of(folder_ / out / "estimate.json"))["estimates"];
  };
  EXPECT_EQ(estimates("without"), estimates("interpreted"));
}

TEST_F(FaultInjection, PagesOfTheBlindCheckAreReplacedWithForceAlone) {
  fs::create_directories(folder_ / "page");
  for (const std::string file : {"score.md", "estimates.json"}) write("page/" + file, "mine");
  for (const std::string command :
       {"blind score set -o page", "blind estimates set -o page", "blind all --campaigns 1 -o set --page page"}) {
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.status, 2) << command;
    EXPECT_NE(outcome.errors.find("add --force"), std::string::npos) << outcome.errors;
  }
  EXPECT_EQ(text_of(folder_ / "page/score.md"), "mine");
  EXPECT_FALSE(fs::exists(folder_ / "set"));  // refused before any work
  EXPECT_NE(run("blind score set -o page --force").errors.find("set/labels.json"), std::string::npos);
}

}  // namespace
}  // namespace secular
