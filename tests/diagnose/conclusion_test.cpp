// What a diagnosis ends with, on findings that are made up.
#include "diagnose/verdict/conclusion.hpp"

#include <gtest/gtest.h>

namespace secular {
namespace {

constexpr Unsteadiness at_rest{};

Unsteadiness varying(double ratio) {
  return {true, 1e-9, ratio, "dwell.csv"};
}

// Rows ten times their noise before, at their noise after.
constexpr ClosedShare all_closed{10, 1, 1, 0.98, 1};
constexpr ResidualStructure nothing_left{};

TEST(Conclusion, WithoutAGap) {
  EXPECT_EQ(conclude_without_gap(false, at_rest).verdict, "no_gap");
  for (const bool varies : {false, true})
    EXPECT_NE(conclude_without_gap(true, varies ? varying(3) : at_rest).unknown_because.find("noise"),
              std::string::npos);
  EXPECT_NE(conclude_without_gap(false, varying(3)).unknown_because.find("what varies"), std::string::npos);
}

TEST(Conclusion, OneEffectIsTheCauseAndSeveralAreASet) {
  const Conclusion one = conclude({{"drag"}, {}, {}}, nothing_left, all_closed, "");
  EXPECT_EQ(one.verdict, "cause");
  EXPECT_EQ(one.cause, "drag");
  const Conclusion both = conclude({{"drag", "friction"}, {}, {}}, nothing_left, all_closed, "");
  EXPECT_EQ(both.verdict, "set");
  EXPECT_EQ(both.cause, "");
}

TEST(Conclusion, WhatLeavesStructureIsApproximate) {
  ResidualStructure left;
  left.smooth_p_value = 1e-9;
  left.smooth_share = 0.05;
  EXPECT_EQ(conclude({{"drag"}, {}, {}}, left, {10, 1.5, 0.94, 0.9, 0.97}, "").verdict, "approximate");
}

TEST(Conclusion, WhatIsNotShownToCloseHalfIsNoCause) {
  const Conclusion little = conclude({{"drag"}, {}, {}}, nothing_left, {10, 6, 0.4, -1, 1}, "");
  EXPECT_EQ(little.verdict, "unknown");
  EXPECT_FALSE(little.unknown_because.empty());
}

TEST(Conclusion, WhatSpeaksAgainstAnExplanationComesFirst) {
  const Conclusion against = conclude({{"drag"}, {}, {}}, nothing_left, all_closed, "the noise is misjudged");
  EXPECT_EQ(against.verdict, "unknown");
  EXPECT_EQ(against.unknown_because, "the noise is misjudged");
}

// Motions whose variation within dwells is worth less than what the explanation of their means takes away.
TEST(Conclusion, VariationSpeaksAgainstAnExplanationThatIsWorthLess) {
  Contest contest;
  contest.all = contest.named = {Rival{}};
  EXPECT_EQ(what_speaks_against(contest, false, varying(9), all_closed), "");
  EXPECT_NE(what_speaks_against(contest, false, varying(11), all_closed), "");
  EXPECT_NE(what_speaks_against(contest, true, at_rest, all_closed), "");
  contest.stalled = true;
  EXPECT_NE(what_speaks_against(contest, false, at_rest, all_closed), "");
}

TEST(Conclusion, AnOpenLawThatIsBetterSpeaksAgainstAll) {
  Contest contest;
  contest.all = {Rival{}};
  contest.all.front().open_law = true;
  EXPECT_NE(what_speaks_against(contest, false, at_rest, all_closed), "");
}

}  // namespace
}  // namespace secular
