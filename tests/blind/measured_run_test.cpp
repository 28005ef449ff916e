// How measured sets are run, with a stand-in for the program.
#include "blind/measured_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "blind/sealed_files.hpp"
#include "input/input_error.hpp"
#include "tests/process_folder.hpp"

namespace secular::blind {
namespace {

namespace fs = std::filesystem;
using Outcome = MeasuredResult::Outcome;

MeasuredSet set_of(const std::string& name) {
  MeasuredSet set;
  set.name = name;
  set.files = {name + ".csv"};
  set.model = "own.toml";
  set.aims = {{.verdicts = {"no_gap"}}};
  return set;
}

// A program that imports all but what is called unreadable, refuses what is called refused, and sleeps over what is
// called slow. PROGRAM import DATA/NAME.csv -o WORK/NAME/campaign; PROGRAM diagnose WORK/NAME/campaign --model M -o
// OUT
class MeasuredRuns : public testing::Test {
 protected:
  void SetUp() override {
    folder = testing_support::process_folder() / testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(folder);
    fs::create_directories(folder / "data");
    write_text(folder / "own.toml", "");
    write_text(folder / "program", R"x(#!/bin/sh
[ "$2" = --help ] && echo "--model M" && exit 0
for last; do :; done
echo "$@" >> "$(dirname "$0")/calls"
case "$1 $2" in
  import*unreadable*) echo "secular: no columns"; exit 2 ;;
  import*) mkdir "$last"; printf '[[channel]]\nname = "x"\nunit = "mm"\n' > "$last/campaign.toml" ;;
  *refused/campaign) echo "warning"; echo "secular: no decay"; exit 2 ;;
  *slow/campaign) sleep 5 ;;
  *crashed/campaign) echo "secular: internal error"; exit 3 ;;
  *) mkdir "$last"; echo '{"verdict": "no_gap"}' > "$last/diagnosis.json" ;;
esac
)x");
    fs::permissions(folder / "program", fs::perms::owner_all);
    list.folder = folder;
    for (const char* name : {"good", "unreadable", "refused", "crashed"}) add(name);
  }
  void TearDown() override { fs::remove_all(folder); }

  void add(const std::string& name) {
    list.sets.push_back(set_of(name));
    write_text(folder / "data" / (name + ".csv"), "");
  }
  MeasuredRun run(bool again = false, double limit_s = 20) const {
    return run_measured(list, {folder / "data", folder / "work"},
                        {.program = folder / "program", .threads = 1, .limit_s = limit_s}, again, {});
  }
  long calls() const {
    const std::string text = read_text(folder / "calls");
    return std::count(text.begin(), text.end(), '\n');
  }

  fs::path folder;
  MeasuredList list;
};

TEST_F(MeasuredRuns, EndWithWhatTheProgramSaid) {
  const MeasuredRun first = run();
  EXPECT_EQ(first.kept, 0U);
  ASSERT_EQ(first.results.size(), 4U);
  EXPECT_EQ(first.results[0].outcome, Outcome::diagnosed);
  EXPECT_EQ(first.results[0].diagnosis["verdict"], "no_gap");
  EXPECT_EQ(first.results[0].units.at("x"), "mm");
  EXPECT_EQ(first.results[1].outcome, Outcome::refused);
  EXPECT_EQ(first.results[1].reason, "exit status 2: secular: no columns");
  EXPECT_EQ(first.results[2].outcome, Outcome::refused);
  EXPECT_EQ(first.results[2].reason, "exit status 2: secular: no decay");
  EXPECT_EQ(first.results[3].outcome, Outcome::failed);
  EXPECT_EQ(first.results[3].reason, "exit status 3: secular: internal error");
}

TEST_F(MeasuredRuns, KeepResultsOfTheSameCommands) {
  run();
  EXPECT_EQ(calls(), 7);
  const MeasuredRun second = run();
  EXPECT_EQ(second.kept, 4U);
  EXPECT_EQ(calls(), 7);
  EXPECT_EQ(second.results[0].diagnosis["verdict"], "no_gap");
  EXPECT_EQ(second.results[2].outcome, Outcome::refused);
  list.sets[0].diagnose = {"--to", "3"};
  const MeasuredRun third = run();
  EXPECT_EQ(third.kept, 3U);
  EXPECT_EQ(third.results[0].outcome, Outcome::diagnosed);
  EXPECT_EQ(run(true).kept, 0U);
  fs::remove_all(folder / "work/good/diagnosis");
  EXPECT_EQ(run().kept, 3U);
}

TEST_F(MeasuredRuns, GoOnWhereTimeRanOutWithALongerLimit) {
  list.sets.clear();
  add("slow");
  const MeasuredRun first = run(false, 0.5);
  EXPECT_EQ(first.results[0].outcome, Outcome::failed);
  EXPECT_NE(first.results[0].reason.find("more than"), std::string::npos);
  EXPECT_EQ(run(false, 0.5).kept, 1U);
  EXPECT_EQ(run(false, 0.6).kept, 0U);
}

TEST_F(MeasuredRuns, BeginOnlyWithAllFiles) {
  fs::remove(folder / "data/refused.csv");
  EXPECT_THROW(run(), InputError);
  EXPECT_FALSE(fs::exists(folder / "calls"));
}

}  // namespace
}  // namespace secular::blind
