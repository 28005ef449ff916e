// How a set is run, with a stand-in for the program.
#include "blind/run_set.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "blind/follow_up.hpp"
#include "blind/leave_out.hpp"
#include "blind/score_set.hpp"
#include "blind/sealed_files.hpp"
#include "blind/sha256.hpp"
#include "input/input_error.hpp"
#include "tests/process_folder.hpp"

namespace secular::blind {
namespace {

namespace fs = std::filesystem;

// A set of three campaigns without records (by its seed one of them has one effect, which is quick to compare with
// others), and a program that finds no gap in the first, refuses the second and says nothing of the third.
class BlindRun : public testing::Test {
 protected:
  void SetUp() override {
    folder = testing_support::process_folder() /
             (std::string("secular_blind_run_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder);
    nlohmann::json labels = {
        {"schema", 1}, {"seed", 86}, {"set", "short"}, {"cases", 3}, {"labels", nlohmann::json::array()}};
    for (int i = 1; i <= 3; ++i) {
      labels["labels"].push_back(
          {{"case", i}, {"kind", "none"}, {"snr_db", 40}, {"effects", nlohmann::json::array()}});
      fs::create_directories(sealed_folder(folder, static_cast<std::size_t>(i)));
    }
    write_text(folder / "set.json", R"({"schema": 1, "seed": 86, "set": "short", "cases": 3})");
    write_text(folder / "labels.json", labels.dump());
    write_text(folder / "labels.sha256", sha256(labels.dump()));
    // Called as PROGRAM diagnose case_NNNN/campaign --model case_NNNN/model.toml -o case_NNNN/diagnosis
    program = folder / "program";
    write_text(program, R"x(#!/bin/sh
[ "$2" = --help ] && echo "--model M" && exit 0
echo "$@" >> "$(dirname "$0")/calls"
case "$2" in
  *case_0001*) mkdir "$6"; echo '{"gap": {"detected": false}, "verdict": "no_gap"}' > "$6/diagnosis.json" ;;
  *case_0002*) echo "secular: bad campaign"; exit 2 ;;
esac
)x");
    fs::permissions(program, fs::perms::owner_all);
  }
  void TearDown() override { fs::remove_all(folder); }
  fs::path folder, program;
};

TEST_F(BlindRun, ListsFailuresAndKeepsDiagnoses) {
  const RunOptions options{.program = program, .threads = 2, .limit_s = 20};
  const RunSummary first = run_set(folder, options, {});
  EXPECT_EQ(first.kept, 0u);
  ASSERT_EQ(first.failed.size(), 2u);
  EXPECT_EQ(first.failed[0].reason, "exit status 2: secular: bad campaign");
  EXPECT_EQ(first.failed[1].reason, "no diagnosis.json");
  const RunSummary again = run_set(folder, options, {});
  EXPECT_EQ(again.kept, 1u);
  EXPECT_EQ(again.failed.size(), 2u);
  const Score score = score_set(folder);
  EXPECT_EQ(score.failed, 2u);
  EXPECT_EQ(score.confusion.at("no_gap").at("no_gap"), 1u);
  write_score(score, name_of_set(folder), folder / "page");
  EXPECT_NE(read_text(folder / "page" / "score.md").find("short set of 3 campaigns, seed 86"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(read_text(folder / "page" / "score.json"))["failed"], 2);
}

TEST_F(BlindRun, GivesParametersWhereACampaignHasThem) {
  write_text(sealed_folder(folder, 2) / "parameters.json", "{}");
  run_set(folder, {.program = program, .threads = 1, .limit_s = 20}, {});
  const std::string calls = read_text(folder / "calls");
  const std::string given = "--parameters " + (sealed_folder(folder, 2) / "parameters.json").string();
  EXPECT_NE(calls.find(given), std::string::npos) << calls;
  EXPECT_EQ(calls.find("--parameters", calls.find(given) + 1), std::string::npos);
}

using SlowBlindRun = BlindRun;

TEST_F(SlowBlindRun, LeavesOutTheOneEffectThatACampaignHas) {
  const std::vector<CampaignPlan> plans = draw_plans({.campaigns = 3, .seed = 86});
  const LeaveOutSummary summary = leave_out_of_set(folder, {.program = program, .threads = 2, .limit_s = 20}, {});
  const std::string calls = read_text(folder / "calls");
  std::size_t singles = 0;
  for (const CampaignPlan& plan : plans) {
    const fs::path place = sealed_folder(folder, plan.number);
    if (plan.kind != "single") {
      EXPECT_FALSE(fs::exists(left_out_folder(place))) << plan.number;
      continue;
    }
    ++singles;
    EXPECT_NE(calls.find((left_out_folder(place) / "diagnosis").string() + " --without " + plan.effects.front()),
              std::string::npos)
        << calls;
    const auto rest = nlohmann::json::parse(read_text(look_alikes_file(place))).get<std::vector<std::string>>();
    EXPECT_EQ(std::count(rest.begin(), rest.end(), plan.effects.front()), 0) << plan.effects.front();
  }
  ASSERT_GT(singles, 0U);
  EXPECT_EQ(summary.campaigns, singles);
}

TEST_F(BlindRun, AnUnsealedSetIsRefused) {
  fs::remove(folder / "labels.sha256");
  EXPECT_THROW(run_set(folder, {.program = program}, {}), InputError);
}

TEST_F(BlindRun, AProgramWithoutDiagnoseIsRefused) {
  write_text(program, "#!/bin/sh\necho usage\n");
  EXPECT_THROW(run_set(folder, {.program = program}, {}), InputError);
}

// A verdict that leaves a set of a campaign without dwells: no dwell is proposed, and none is drawn by lot.
TEST_F(BlindRun, NothingIsFollowedWhereThereAreNoDwells) {
  write_text(
      folder / "set.json",
      R"({"schema": 1, "seed": 86, "set": "short", "cases": 3, "nothing_withheld": true, "records": "decays"})");
  fs::create_directories(sealed_folder(folder, 1) / "diagnosis");
  write_text(sealed_folder(folder, 1) / "diagnosis" / "diagnosis.json",
             R"({"verdict": "set", "next_experiment": {"proposed": true, "like": "records/0001.csv"}})");
  const FollowUpSummary summary = follow_up_set(folder, {.program = program, .threads = 1, .limit_s = 20}, {});
  EXPECT_EQ(summary.sets, 1u);
  EXPECT_EQ(summary.proposed, 0u);
  EXPECT_FALSE(fs::exists(folder / "calls"));
}

}  // namespace
}  // namespace secular::blind
