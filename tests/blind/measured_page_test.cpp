// Aims held against made-up diagnoses, and the page of them.
#include "blind/measured_page.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "blind/measured_score.hpp"

namespace secular::blind {
namespace {

using nlohmann::json;
using Outcome = MeasuredResult::Outcome;
using Names = std::vector<std::string>;

json said(const std::string& verdict, const Names& set, const Names& together, double closed = 0.95) {
  return {
      {"verdict", verdict},
      {"cause", verdict == "cause" ? json(set.front()) : json()},
      {"set", set},
      {"together", together},
      {"unknown_because", verdict == "unknown" ? "it leaves structure" : ""},
      {"gap",
       {{"detected", verdict != "no_gap"},
        {"before", 12.0},
        {"after", 1.5},
        {"closed", closed},
        {"closed_ci95", {closed - 0.1, closed + 0.02}}}},
      {"simulated",
       {{"segments", {{{"channel", "x"}, {"signal_rms", 1.0}, {"before_rms", 0.1234}, {"after_rms", 0.0456}}}}}},
      {"data_used", 0.25},
      {"warnings", {"records/b.csv: sunk into the noise, left out", "records/a.csv: coarse"}},
      {"disturbances", {{{"kind", "offset"}}, {{"kind", "offset"}}}}};
}

MeasuredResult diagnosed(json diagnosis) {
  return {Outcome::diagnosed, "", 7.4, std::move(diagnosis), {{"x", "m"}}};
}

MeasuredSet set_of(const std::string& name, const std::vector<Aim>& aims) {
  MeasuredSet set;
  set.name = name;
  set.title = "Title of " + name;
  set.known = "Something is known.";
  set.files = {"f/a.csv"};
  set.import = {"--time", "data(:,1)"};
  set.model = "own.toml";
  set.aims = aims;
  return set;
}

Names missed_of_one(const Aim& aim, const json& diagnosis) {
  return missed(0, {"models", {set_of("one", {aim})}}, {diagnosed(diagnosis)});
}

TEST(MeasuredScore, NamesCauseSetAndCompanyButNotTheNearest) {
  json d = said("cause", {"hysteresis"}, {"hysteresis", "cubic_damping"});
  d["second_or"] = {"power_damping"};
  EXPECT_EQ(named_effects(d), (Names{"hysteresis", "cubic_damping", "power_damping"}));
  EXPECT_EQ(named_effects(said("set", {"freeplay", "two_sided_stop"}, {})), (Names{"freeplay", "two_sided_stop"}));
  EXPECT_TRUE(named_effects(said("unknown", {"hysteresis"}, {"hysteresis", "cubic_damping"})).empty());
  EXPECT_TRUE(named_effects(said("no_gap", {}, {})).empty());
}

TEST(MeasuredScore, EveryConditionOfAnAimCounts) {
  const json d = said("approximate", {"hysteresis"}, {"hysteresis", "cubic_damping"});
  EXPECT_EQ(missed_of_one({.named = {{"hysteresis"}, {"power_damping", "cubic_damping"}}}, d), Names{});
  EXPECT_EQ(missed_of_one({.named = {{"hysteresis"}, {"coulomb_friction", "power_damping"}}}, d),
            Names{"coulomb_friction or power_damping not named"});
  EXPECT_EQ(missed_of_one({.never_named = {"cubic_damping", "freeplay"}}, d), Names{"cubic_damping named"});
  EXPECT_EQ(missed_of_one({.verdicts = {"cause", "approximate"}}, d), Names{});
  EXPECT_EQ(missed_of_one({.verdicts = {"unknown"}}, d), Names{"verdict approximate"});
  EXPECT_EQ(missed_of_one({.closed_at_least = 0.95}, d), Names{});
  EXPECT_EQ(missed_of_one({.closed_at_least = 0.96}, d), Names{"less than 96 % closed"});
  EXPECT_EQ(missed_of_one({.disturbances = {"offset"}}, d), Names{});
  EXPECT_EQ(missed_of_one({.disturbances = {"foreign_tone"}}, d),
            Names{"foreign_tone not listed as a disturbance"});
  EXPECT_EQ(missed_of_one({.every_record = true}, d), Names{"records/b.csv left out"});
  EXPECT_EQ(missed_of_one({.named = {{"freeplay"}}, .verdicts = {"unknown"}}, d),
            (Names{"freeplay not named", "verdict approximate"}));
}

TEST(MeasuredScore, OneOfSeveralAimsIsEnough) {
  const MeasuredList list{
      "models", {set_of("one", {{.named = {{"freeplay"}}, .verdicts = {"set"}}, {.verdicts = {"unknown"}}})}};
  EXPECT_EQ(missed(0, list, {diagnosed(said("unknown", {"relaxation"}, {}))}), Names{});
  EXPECT_EQ(missed(0, list, {diagnosed(said("set", {"freeplay", "two_sided_stop"}, {}))}), Names{});
  EXPECT_EQ(missed(0, list, {diagnosed(said("cause", {"relaxation"}, {}))}), Names{"verdict cause"});
}

TEST(MeasuredScore, TheVerdictOfAnotherSetMayBeAskedFor) {
  const MeasuredList list{"models",
                          {set_of("one", {{.verdicts = {"cause"}}}), set_of("two", {{.same_verdict_as = "one"}}),
                           set_of("three", {{.same_verdict_as = "none"}})}};
  const MeasuredResult cause = diagnosed(said("cause", {"freeplay"}, {})),
                       open = diagnosed(said("unknown", {}, {}));
  EXPECT_EQ(missed(1, list, {cause, cause, cause}), Names{});
  EXPECT_EQ(missed(1, list, {open, cause, cause}), Names{"not the verdict of one"});
  EXPECT_EQ(missed(1, list, {diagnosed(said("cause", {"relaxation"}, {})), cause, cause}),
            Names{"not the verdict of one"});
  EXPECT_EQ(missed(1, list, {MeasuredResult{}, cause, cause}), Names{"not the verdict of one"});
  EXPECT_EQ(missed(2, list, {cause, cause, cause}), Names{"none was not run"});
}

TEST(MeasuredScore, WithoutADiagnosisNothingIsMet) {
  const MeasuredList list{"models", {set_of("one", {{.verdicts = {"unknown"}}})}};
  EXPECT_EQ(missed(0, list, {MeasuredResult{}}), Names{"no diagnosis"});
}

class MeasuredPage : public testing::Test {
 protected:
  std::string page() const { return measured_markdown(json_of()); }
  nlohmann::ordered_json json_of() const {
    return measured_json({"secular blind measured D -o P", "models/sets.toml", "D", "out"}, list, results);
  }
  bool shows(const std::string& text) const { return page().find(text) != std::string::npos; }

  MeasuredList list{"models",
                    {set_of("right", {{.named = {{"hysteresis"}}}}),
                     set_of("wrong", {{.named = {{"coulomb_friction", "hysteresis"}}, .closed_at_least = 0.9}}),
                     set_of("short", {{.verdicts = {"unknown"}}}), set_of("slow", {{.every_record = true}})}};
  std::vector<MeasuredResult> results = {diagnosed(said("approximate", {"hysteresis"}, {})),
                                         diagnosed(said("unknown", {"freeplay"}, {"freeplay", "relaxation"}, 0.5)),
                                         {Outcome::refused, "exit status 2: a | b", 1, {}, {}},
                                         {Outcome::failed, "more than 300 s", 300, {}, {}}};
};

TEST_F(MeasuredPage, SaysWhatIsMetAndWhatIsNot) {
  EXPECT_TRUE(
      shows("**1 of 4 sets meet their aim**: 1 with the right name, 0 where nothing wrong is named, and "
            "nothing right. Missed: wrong, short, slow."))
      << page();
  EXPECT_TRUE(
      shows("| [right](#right) | approximate: hysteresis | 95.0 % [85, 97] | 0.123, 0.0456 m |  | 25.0 % | 7 "
            "| met |"))
      << page();
  EXPECT_TRUE(shows("unknown, nearest freeplay; together freeplay and relaxation | 50.0 % [40, 52]")) << page();
  EXPECT_TRUE(shows("- **missed**: coulomb_friction or hysteresis not named; less than 90 % closed")) << page();
  EXPECT_TRUE(shows("| refused: exit status 2: a \\| b |  |  |  |  | 1 | **missed** |")) << page();
  EXPECT_TRUE(shows("| failed: more than 300 s |  |  |  |  | 300 | **missed** |")) << page();
  EXPECT_TRUE(shows("- unknown because it leaves structure")) << page();
  EXPECT_TRUE(
      shows("secular import $DATA/f/a.csv -o out/right/campaign --time 'data(:,1)'\nsecular diagnose "
            "out/right/campaign --model models/own.toml -o out/right/diagnosis"))
      << page();
}

// An `unknown` that is asked for is no success of the same kind as a name.
TEST_F(MeasuredPage, TellsSilenceFromNames) {
  results[2] = diagnosed(said("unknown", {"freeplay"}, {}, 0.5));
  EXPECT_TRUE(shows("**2 of 4 sets meet their aim**: 1 with the right name, 1 where nothing wrong is named"))
      << page();
  EXPECT_TRUE(shows("| met, nothing named |")) << page();
}

TEST_F(MeasuredPage, HeldOutErrorsStandWhereAWindowIsChecked) {
  results[0].diagnosis["simulated"]["check"] = {
      {{"channel", "x"}, {"signal_rms", 1.0}, {"before_rms", 0.5}, {"after_rms", 0.25}}};
  EXPECT_TRUE(shows("| 0.123, 0.0456 m | 0.5, 0.25 m |")) << page();
}

TEST_F(MeasuredPage, HoldsNothingThatChangesBesidesTimes) {
  const nlohmann::ordered_json before = json_of();
  for (MeasuredResult& result : results) result.seconds += 20;
  nlohmann::ordered_json after = json_of();
  EXPECT_NE(before, after);
  for (nlohmann::ordered_json& set : after["sets"]) set["seconds"] = set["seconds"].get<double>() - 20;
  EXPECT_EQ(measured_markdown(before), measured_markdown(after));
}

}  // namespace
}  // namespace secular::blind
