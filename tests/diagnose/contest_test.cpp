// Which explanations of a gap compete, on explanations that are made up.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "diagnose/verdict/rivals.hpp"

namespace secular {
namespace {

using Names = std::vector<std::string>;

std::vector<Candidate> some_laws() {
  std::vector<Candidate> laws(3);
  laws[0].effect = "drag";
  laws[1].effect = "friction";
  laws[1].contains = {"play"};
  laws[2].effect = "any power";
  laws[2].open_law = true;
  return laws;
}

Explanation made_up(std::vector<std::size_t> members, double odds, SolverEnding ending = SolverEnding::converged) {
  Explanation e;
  e.unknowns = members.size();
  e.members = std::move(members);
  e.log_evidence = std::log(odds);
  e.fit.ending = ending;
  return e;
}

TEST(Contest, RivalsHaveWhatTheirMembersHave) {
  Inference inference;
  inference.explanations = {made_up({0, 1}, 1), made_up({2}, 3)};
  const Contest contest = contest_of(inference, some_laws(), false);
  ASSERT_EQ(contest.all.size(), 2U);
  EXPECT_EQ(contest.all[0].effects, Names{"any power"});
  EXPECT_EQ(contest.all[1].effects, (Names{"drag", "friction"}));
  EXPECT_EQ(contest.all[1].contains, Names{"play"});
  EXPECT_DOUBLE_EQ(contest.all[1].probability, 0.25);
  ASSERT_EQ(contest.named.size(), 1U);
  EXPECT_EQ(contest.named[0].effects, contest.all[1].effects);
}

TEST(Contest, MovedNumbersTakePartWhereSomeWereGiven) {
  Inference inference;
  inference.null = made_up({}, 1);
  inference.explanations = {made_up({0}, 2)};
  EXPECT_EQ(contest_of(inference, some_laws(), false).all.size(), 1U);
  const Contest contest = contest_of(inference, some_laws(), true);
  ASSERT_EQ(contest.all.size(), 2U);
  EXPECT_EQ(contest.all[1].effects, Names{"parameters"});
}

// What a stalled fit would have come to nobody knows: it names nothing, and what is no match for it as it is
// neither.
TEST(Contest, AStalledFitLetsOthersWinWhereTheyComeNear) {
  for (const auto& [odds, stalled] : {std::pair{0.5, false}, {1e-6, true}}) {
    Inference inference;
    inference.explanations = {made_up({0}, 1, SolverEnding::stalled), made_up({1}, odds)};
    const Contest contest = contest_of(inference, some_laws(), false);
    EXPECT_EQ(contest.stalled, stalled);
    EXPECT_EQ(contest.all.size(), stalled ? 2U : 1U);
    EXPECT_EQ(contest.best().effects, stalled ? Names{"drag"} : Names{"friction"});
    EXPECT_DOUBLE_EQ(contest.best().probability, stalled ? 1 / (1 + odds) : 1);
  }
}

TEST(Contest, ALawOfTheCatalogueWillDoWhereAnExponentIsCrediblyNoBetter) {
  for (const auto& [odds, best] : {std::pair{0.5, "drag"}, {1e-6, "any power"}}) {
    Inference inference;
    inference.explanations = {made_up({2}, 1), made_up({0}, odds)};
    EXPECT_EQ(contest_of(inference, some_laws(), false).best().effects, Names{best});
  }
}

// Two laws that do together what one does that nobody listed are a way to write it down, and no causes.
TEST(Contest, TwoLawsOfTheCatalogueWillNotDoForOneOutsideOfIt) {
  Inference inference;
  inference.explanations = {made_up({2}, 1), made_up({0, 1}, 0.5)};
  EXPECT_EQ(contest_of(inference, some_laws(), false).best().effects, Names{"any power"});
  inference.explanations = {made_up({0, 2}, 1), made_up({0, 1}, 0.5)};
  EXPECT_EQ(contest_of(inference, some_laws(), false).best().effects, (Names{"drag", "friction"}));
  inference.explanations = {made_up({2}, 0.5), made_up({0, 1}, 1)};
  EXPECT_EQ(contest_of(inference, some_laws(), false).best().effects, (Names{"drag", "friction"}));
}

TEST(Contest, OfNothingIsEmpty) {
  const Contest contest = contest_of({}, some_laws(), false);
  EXPECT_TRUE(contest.all.empty() && contest.named.empty());
}

}  // namespace
}  // namespace secular
