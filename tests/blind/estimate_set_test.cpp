// The check of identify's numbers on drawn campaigns.
#include "blind/estimate_set.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "blind/score_set.hpp"
#include "blind/sealed_files.hpp"
#include "blind/sealed_set.hpp"
#include "blind/sha256.hpp"
#include "input/input_error.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"

namespace secular::blind {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

TEST(EstimateSet, ANumberIsJudgedByItsValueItsIntervalAndItsMark) {
  const json estimate = {{"estimates",
                          {{{"name", "mu"}, {"value", 1.5}, {"sd", 0.25}, {"ci95", {1.0, 2.0}}},
                           {{"name", "eta"}, {"value", 3.0}, {"sd", 0.1}, {"ci95", {2.8, 3.2}}, {"doubtful", true}},
                           {{"name", "alpha"}, {"value", nullptr}}}}};
  const auto numbers = judged_numbers(4, {{"alpha", 1}, {"beta", 1}, {"eta", 2}, {"mu", 1}}, estimate);
  ASSERT_EQ(numbers.size(), 4U);
  EXPECT_FALSE(numbers[0].given);
  EXPECT_FALSE(numbers[1].given);
  EXPECT_TRUE(numbers[2].given && numbers[2].doubtful);
  EXPECT_FALSE(numbers[2].held);
  EXPECT_NEAR(numbers[2].off, 10, 1e-9);
  EXPECT_TRUE(numbers[3].held);
  EXPECT_NEAR(numbers[3].off, 2, 1e-12);
  EXPECT_EQ(numbers[3].number, 4U);
}

TEST(EstimateSet, IdentifiesEveryCampaignOnceAndScoresIt) {
  const fs::path folder = testing_support::process_folder() / "numbers", page = folder / "page";
  generate_set(folder / "set", {.campaigns = 2, .seed = 12, .disturbed = true, .nothing_withheld = true}, {});
  const json labels = read_labels(folder / "set");
  for (const json& label : labels.at("labels")) EXPECT_EQ(label.at("kind"), "none");
  RunOptions options;
  options.program = testing_support::program();
  EXPECT_TRUE(identify_set(folder / "set", options, {}).failed.empty());
  EXPECT_EQ(identify_set(folder / "set", options, {}).kept, 2U);
  const EstimateScore score = score_estimates(folder / "set");
  EXPECT_EQ(score.campaigns, 2U);
  EXPECT_TRUE(score.failed.empty());
  std::size_t asked = 0;
  for (const auto& [family, share] : score.by_family) {
    asked += share.asked;
    EXPECT_GT(share.given, 0U) << family;
  }
  EXPECT_EQ(asked, labels.at("labels")[0].at("numbers").size() + labels.at("labels")[1].at("numbers").size());
  write_estimate_score(score, name_of_set(folder / "set"), page);
  EXPECT_EQ(json::parse(read_text(page / "estimates.json")).at("cases"), 2);
  EXPECT_NE(read_text(page / "estimates.md").find("nothing withheld"), std::string::npos);
  fs::remove_all(folder);
}

TEST(EstimateSet, RefusesASetThatWithholdsSomething) {
  const fs::path folder = testing_support::process_folder() / "withheld";
  fs::create_directories(folder);
  const std::string labels = json{{"schema", 1}, {"cases", 0}, {"labels", json::array()}}.dump();
  write_text(folder / "labels.json", labels);
  write_text(folder / "labels.sha256", sha256(labels) + "  labels.json\n");
  EXPECT_THROW(score_estimates(folder), InputError);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace secular::blind
