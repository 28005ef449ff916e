// Which of several diagnoses of a campaign is kept, and what is doubtful of it.
#include "diagnose/verdict/answer.hpp"

#include <gtest/gtest.h>

namespace secular {
namespace {

Diagnosis with_verdict(const std::string& verdict, double left = 1, bool gap = true) {
  Diagnosis d;
  d.verdict = verdict;
  d.gap.detected = gap;
  d.gap.after = left;
  return d;
}

TEST(Answer, AccountsForAllWhereNoGapIsLeftOrACauseIsNamed) {
  for (const char* verdict : {"no_gap", "cause", "set"})
    EXPECT_EQ(how_much(with_verdict(verdict)), Accounted::all) << verdict;
  EXPECT_EQ(how_much(with_verdict("approximate")), Accounted::most);
  EXPECT_EQ(how_much(with_verdict("unknown")), Accounted::nothing);
}

TEST(Answer, IsDoubtfulWhereTheGapIsGoneForNoReason) {
  EXPECT_EQ(how_much(with_verdict("unknown", 1, false)), Accounted::doubtful);
  Diagnosis beside_scatter = with_verdict("cause");
  beside_scatter.frequency_scatter.suffices = false;
  EXPECT_EQ(how_much(beside_scatter), Accounted::doubtful);
}

TEST(Answer, OfTwoThatDoAsMuchTheOneThatLeavesLessAccountsForMore) {
  EXPECT_TRUE(accounts_for_more(with_verdict("cause", 3), with_verdict("approximate", 1)));
  EXPECT_FALSE(accounts_for_more(with_verdict("unknown", 1), with_verdict("approximate", 3)));
  EXPECT_TRUE(accounts_for_more(with_verdict("cause", 1), with_verdict("set", 2)));
  EXPECT_FALSE(accounts_for_more(with_verdict("cause", 2), with_verdict("set", 2)));
}

TEST(Answer, WhatFollowsTheSettingsIsNoRecordsOwn) {
  Diagnosis d = with_verdict("cause");
  EXPECT_EQ(doubt_of_own(d), "");
  d.late.records = {{}, {}};
  d.late.differ = true;
  EXPECT_EQ(doubt_of_own(d), "");
  d.late.following = Following::settings;
  EXPECT_NE(doubt_of_own(d).find("follows their settings"), std::string::npos);
  d.late.following = Following::too_few;
  EXPECT_NE(doubt_of_own(d).find("too few records"), std::string::npos);
  d.late.following = Following::at_random;
  d.late.differ = false;
  EXPECT_NE(doubt_of_own(d).find("not late by different times"), std::string::npos);
  d.frequency_scatter.follows_settings = true;
  EXPECT_NE(doubt_of_own(d).find("natural frequencies"), std::string::npos);
}

}  // namespace
}  // namespace secular
