// The list of measured sets: what it may say, and that the project's own says what the program knows.
#include "blind/measured_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "effects/catalogue.hpp"
#include "input/input_error.hpp"
#include "measure/disturbances/catalogue.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"

namespace secular::blind {
namespace {

namespace fs = std::filesystem;

const fs::path list_file = testing_support::source_folder() / "models/measured/sets.toml";

constexpr const char* good = R"(schema = 1
[[set]]
name = "one"
title = "One"
known = "Nothing."
files = ["a.csv", "b/c.csv"]
import = "--kind free_decay  --channel x:response:displacement:m"
model = "own.toml"
diagnose = "--to 3"
mode_hz = 100
[[set.aim]]
named = ["hysteresis", "cubic_damping or power_damping or viscous_damping"]
[[set.aim]]
verdicts = ["unknown"]
)";

MeasuredList read(const std::string& text) {
  const fs::path file = testing_support::process_folder() / "list.toml";
  std::ofstream(file) << text;
  return read_measured_list(file);
}

std::string with(const std::string& old, const std::string& replacement) {
  std::string text = good;
  text.replace(text.find(old), old.size(), replacement);
  return text;
}

std::string refusal(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(MeasuredSets, AreReadWithTheirAims) {
  const MeasuredList list = read(good);
  EXPECT_EQ(list.folder, testing_support::process_folder());
  ASSERT_EQ(list.sets.size(), 1U);
  const MeasuredSet& set = list.sets.front();
  EXPECT_EQ(set.files, (std::vector<std::string>{"a.csv", "b/c.csv"}));
  EXPECT_EQ(set.import,
            (std::vector<std::string>{"--kind", "free_decay", "--channel", "x:response:displacement:m"}));
  EXPECT_FALSE(set.model_is_data);
  EXPECT_EQ(set.diagnose, (std::vector<std::string>{"--to", "3", "--band", "75:125"}));
  ASSERT_EQ(set.aims.size(), 2U);
  EXPECT_EQ(set.aims[0].named, (std::vector<std::vector<std::string>>{
                                   {"hysteresis"}, {"cubic_damping", "power_damping", "viscous_damping"}}));
  EXPECT_EQ(set.aims[1].verdicts, std::vector<std::string>{"unknown"});
  EXPECT_TRUE(read(with("own.toml", "b/own.toml")).sets.front().model_is_data);
}

TEST(MeasuredSets, AreRefusedWithWhatIsWrong) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {with("mode_hz", "mode_hertz"), "mode_hertz"},
      {with("verdicts = [\"unknown\"]", "verdicts = [\"perhaps\"]"), "perhaps"},
      {with("verdicts = [\"unknown\"]", "same_verdict_as = \"two\""), "two"},
      {with("verdicts = [\"unknown\"]", ""), "without a condition"},
      {with("name = \"one\"", "name = \"../one\""), "lower case"},
      {with("files = [\"a.csv\", \"b/c.csv\"]", "files = []"), "no file"},
      {with("mode_hz = 100", "mode_hz = -1"), "more than 0"},
      {with("\"--to 3\"", "\"--to '3 4'\""), "quotes"},
      {std::string(good) + std::string(good).substr(std::string(good).find("[[set]]")), "another set"}};
  for (const auto& [text, word] : cases) EXPECT_NE(refusal(text).find(word), std::string::npos) << refusal(text);
}

TEST(MeasuredSets, AreChosenByName) {
  const MeasuredList all = read_measured_list(list_file);
  EXPECT_EQ(only_sets(all, {}).sets.size(), all.sets.size());
  const MeasuredList two = only_sets(all, {"wheel_torsion", "pendulum"});
  ASSERT_EQ(two.sets.size(), 2U);
  EXPECT_EQ(two.sets.front().name, "pendulum");
  EXPECT_THROW(only_sets(all, {"pendulums"}), InputError);
}

TEST(MeasuredSets, AllMissingFilesAreNamedInOneMessage) {
  const MeasuredList list = read(good);
  try {
    require_data(list, "nowhere");
    FAIL();
  } catch (const InputError& error) {
    for (const char* file : {"nowhere/a.csv", "nowhere/b/c.csv", "own.toml"})
      EXPECT_NE(std::string(error.what()).find(file), std::string::npos) << error.what();
  }
}

// A misspelt name would be missed for ever, or never.
TEST(MeasuredSets, OfTheProjectNameWhatTheProgramKnows) {
  const MeasuredList list = read_measured_list(list_file);
  EXPECT_GE(list.sets.size(), 15U);
  for (const MeasuredSet& set : list.sets) {
    EXPECT_TRUE(set.model_is_data || fs::exists(list.folder / set.model)) << set.name;
    for (const Aim& aim : set.aims) {
      std::vector<std::string> effects = aim.never_named;
      for (const std::vector<std::string>& any : aim.named) effects.insert(effects.end(), any.begin(), any.end());
      for (const std::string& effect : effects)
        EXPECT_NE(effect_catalogue().find(effect), nullptr) << set.name << ": " << effect;
      for (const std::string& kind : aim.disturbances) {
        const auto kinds = disturbance_catalogue();
        EXPECT_TRUE(std::any_of(kinds.begin(), kinds.end(),
                                [&](const DisturbanceKind& known) { return known.name == kind; }))
            << set.name << ": " << kind;
      }
    }
  }
}

TEST(MeasuredSets, OfTheProjectFindTheirData) {
  const fs::path data = testing_support::source_folder() / "../shared/data";
  if (!fs::exists(data)) GTEST_SKIP() << "../shared/data is not there";
  EXPECT_NO_THROW(require_data(read_measured_list(list_file), data));
}

}  // namespace
}  // namespace secular::blind
