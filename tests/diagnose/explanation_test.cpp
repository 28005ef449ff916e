#include "diagnose/inference/explanation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

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
  weigh(null, found, three_candidates(), {1, 2, 1e-3, 1e-3}, {});
  EXPECT_EQ(found[0].members, (Members{1}));
  EXPECT_EQ(found[1].members, (Members{0}));
  EXPECT_EQ(found[2].members, (Members{2}));
  EXPECT_EQ(found[3].members, (Members{0, 2}));
  EXPECT_EQ(null.log_evidence, -100);
}

// Rows of folds that each hold the same number, of `folds` with 25 rows: noise of variance 1 and, shared by all
// rows of a fold, a part of variance `shared`.
struct DrawnRows {
  VectorXd rows;
  std::vector<int> folds;
};
DrawnRows drawn_rows(int folds, double shared, std::mt19937& random) {
  std::normal_distribution<double> normal;
  DrawnRows drawn{VectorXd(25 * folds), {}};
  for (int f = 0; f < folds; ++f) {
    const double of_fold = std::sqrt(shared) * normal(random);
    for (int r = 0; r < 25; ++r) {
      drawn.rows(25 * f + r) = of_fold + normal(random);
      drawn.folds.push_back(f);
    }
  }
  return drawn;
}

// A difference between explanations that is the same in all rows has the variance m^2 shared + m in each fold of m
// rows, m (1 + shared) if these were independent.
TEST(Weighing, KnowsHowRowsOfAFoldGoTogether) {
  std::mt19937 random(11);
  for (const double shared : {0.0, 0.5, 4.0}) {
    double mean = 0;
    constexpr int draws = 400, folds = 40;
    for (int draw = 0; draw < draws; ++draw) {
      const DrawnRows drawn = drawn_rows(folds, shared, random);
      const VectorXd rival = drawn.rows.array() + 0.1;
      EXPECT_EQ(dependence_of_rows(drawn.rows, rival, drawn.folds, 1), 1);
      mean += dependence_of_rows(drawn.rows, rival, drawn.folds, 1 + shared) / draws;
    }
    const double expected = 1 + shared / (1 + shared) * ((25 * shared + 1) / (1 + shared) - 1);
    // The square of one sum has the relative variance 2, the mean of 40 in 400 draws that of 1/8000; n/(n - 1) is
    // there for the unknowns of the best explanation, which has none here.
    EXPECT_NEAR(mean, expected, 0.06 * expected) << shared;
  }
}

// Two explanations that are equally wrong: one in twenty is named against the other with odds of 100 at most, and
// by rows that count as independent most are.
TEST(Weighing, TellsNoneOfTwoThatAreEquallyWrong) {
  std::mt19937 random(12);
  const std::vector<Candidate> candidates = three_candidates();
  int told = 0, told_by_rows = 0;
  constexpr int draws = 400;
  for (int draw = 0; draw < draws; ++draw) {
    const DrawnRows drawn = drawn_rows(20, 8, random);
    VectorXd unknowns = VectorXd::Ones(7);
    std::vector<Explanation> found{fitted({0}, 0, unknowns), fitted({2}, 0, unknowns)};
    for (std::size_t e = 0; e < 2; ++e) {
      found[e].unknowns = 1;
      found[e].fit.rows = drawn.rows.array() + (e == 0 ? 0.5 : -0.5);
      found[e].fit.chi_squared = found[e].fit.rows.squaredNorm();
    }
    Explanation null = fitted({}, 1e6);
    null.fit.rows = drawn.rows.array() + 100;
    const Weights weights{9, 3, 1e-3, 1e-3};
    told_by_rows += std::abs(log_evidence(found[0], candidates, weights) -
                             log_evidence(found[1], candidates, weights)) > std::log(100);
    weigh(null, found, candidates, weights, drawn.folds);
    EXPECT_GE(found[0].log_evidence, found[1].log_evidence);
    told += found[0].log_evidence - found[1].log_evidence > std::log(100);
  }
  EXPECT_LE(told, draws / 20);
  EXPECT_GE(told_by_rows, draws / 2);
}

}  // namespace
}  // namespace secular
