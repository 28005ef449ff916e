#include "diagnose/inference/explanation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "diagnose/inference/weighing.hpp"

namespace secular {
namespace {

using Eigen::VectorXd;
using Members = std::vector<std::size_t>;

// Unknowns: one of the model's own, then strength and shape of each; 0 and 1 are one effect in two shapes.
std::vector<Candidate> three_candidates() {
  std::vector<Candidate> all(3);
  for (std::size_t c = 0; c < all.size(); ++c) {
    all[c].effect = c < 2 ? "friction" : "spring";
    all[c].subject = "x";
    all[c].strengths = {1 + 2 * c};
    all[c].shapes = {2 + 2 * c};
  }
  all[2].passive = true;
  return all;
}

Explanation fitted(Members members, double chi_squared, const VectorXd& unknowns = VectorXd::Ones(7)) {
  Refit fit;
  fit.chi_squared = chi_squared;
  fit.unknowns = unknowns;
  return explanation_by(std::move(members), fit, three_candidates());
}

TEST(Explanation, CountsAnUnknownOnceThatIsFreeTwice) {
  std::vector<Candidate> candidates = three_candidates();
  EXPECT_EQ(free_beside({0}, {2, 0}, candidates), (Members{0, 1, 2, 5, 6}));
  candidates[0].strengths = {0};  // the model's own
  EXPECT_EQ(free_beside({0}, {0}, candidates), (Members{0, 2}));
  EXPECT_EQ(fitted({0, 2}, 1).unknowns, 4U);
}

TEST(Explanation, SwitchedOffAndTakenOverIsAsItWas) {
  const std::vector<Candidate> candidates = three_candidates();
  const VectorXd all = VectorXd::LinSpaced(7, 1, 7);
  VectorXd off = switched_off(all, {1, 2}, candidates);
  EXPECT_EQ(off(3), 0);
  EXPECT_EQ(off(5), 0);
  EXPECT_EQ(off(4), all(4));  // shapes stay
  for (const std::size_t c : {1U, 2U}) take_over(off, all, candidates[c]);
  EXPECT_EQ(off, all);
}

TEST(Explanation, OfOneEffectAtOnePlaceTheBestStays) {
  VectorXd negative = VectorXd::Ones(7);
  negative(5) = -1;
  std::vector<Explanation> all{fitted({0}, 7),           fitted({2}, 9),    fitted({1}, 5),
                               fitted({2}, 1, negative), fitted({2, 0}, 4), fitted({1, 2}, 3)};
  keep_best_of_each(all, three_candidates());
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].members, (Members{1, 2}));  // in any order of its members
  EXPECT_EQ(all[1].members, (Members{1}));
  EXPECT_EQ(all[2].members, (Members{2}));  // not that of a negative passive strength
  EXPECT_EQ(all[2].fit.chi_squared, 9);
  const auto size = all.size();
  keep_best_of_each(all, three_candidates());
  EXPECT_EQ(all.size(), size);
}

TEST(Explanation, IsPossibleWhereAllOfItsMembersAre) {
  std::vector<Candidate> candidates = three_candidates();
  candidates[0].plausible = [](const VectorXd& unknowns) { return unknowns(2) < 3; };
  VectorXd unknowns = VectorXd::Ones(7);
  EXPECT_TRUE(is_possible(fitted({0, 2}, 1, unknowns), candidates));
  unknowns(2) = 4;
  EXPECT_FALSE(is_possible(fitted({0, 2}, 1, unknowns), candidates));
  EXPECT_TRUE(is_possible(fitted({2}, 1, unknowns), candidates));
}

// Evidence is chi-squared in units of dispersion less the price of each unknown; odds of a second effect and of an
// open law are what they were before.
TEST(Weighing, LessChiSquaredPaysForUnknownsAndPriorOdds) {
  std::vector<Candidate> candidates = three_candidates();
  candidates[1].open_law = true;
  const Weights weights{2, 3, 1e-3, 1e-2};
  const auto evidence = [&](const Explanation& e) { return log_evidence(e, candidates, weights); };
  const double single = evidence(fitted({0}, 100));
  EXPECT_NEAR(single, -25 - 3 * 2, 1e-12);
  EXPECT_NEAR(evidence(fitted({0}, 96)) - single, 1, 1e-12);
  EXPECT_NEAR(evidence(fitted({0, 2}, 100)) - single, -3 * 2 + std::log(1e-3), 1e-12);
  EXPECT_NEAR(evidence(fitted({1}, 100)) - single, std::log(1e-2), 1e-12);
}

TEST(Weighing, PutsTheLikeliestFirstAndKeepsTheOrderOfEqualOnes) {
  Explanation null = fitted({}, 200);
  std::vector<Explanation> found{fitted({0}, 120), fitted({2}, 120), fitted({0, 2}, 119), fitted({1}, 100)};
  weigh(null, found, three_candidates(), {1, 2, 1e-3, 1e-3});
  EXPECT_EQ(found[0].members, (Members{1}));
  EXPECT_EQ(found[1].members, (Members{0}));
  EXPECT_EQ(found[2].members, (Members{2}));
  EXPECT_EQ(found[3].members, (Members{0, 2}));
  EXPECT_EQ(null.log_evidence, -100);
}

}  // namespace
}  // namespace secular
