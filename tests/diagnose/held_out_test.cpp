// What an explanation has to show on conditions that were held out.
#include "diagnose/inference/held_out.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "diagnose/inference/refit.hpp"
#include "diagnose/verdict/held_out_gap.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

std::vector<RowLabel> labels_of(Index folds, Index each) {
  std::vector<RowLabel> labels(static_cast<std::size_t>(folds * each));
  for (std::size_t i = 0; i < labels.size(); ++i)
    labels[i].fold = static_cast<int>(i / static_cast<std::size_t>(each));
  return labels;
}

/// Rows of exp(u_0 t) in five folds, the last with ten times the weight of the others and a slower rate: from the
/// fit to all of them, steps along its slopes overshoot the fit to the others.
class Growth : public Evidence {
 public:
  Growth() : labels_(labels_of(5, 4)) {}
  Index size() const override { return static_cast<Index>(labels_.size()); }
  const std::vector<RowLabel>& labels() const override { return labels_; }
  void freeze(const VectorXd& /*unknowns*/, double /*coarse*/) override {}
  void evaluate(const VectorXd& unknowns, Eigen::Ref<VectorXd> rows) const override {
    for (Index r = 0; r < rows.size(); ++r) {
      const double t = 2 + static_cast<double>(r % 4), rate = r < 16 ? 1.4 : 1;
      rows(r) = (r < 16 ? 1 : 10) * (std::exp(rate * t) - std::exp(unknowns(0) * t));
    }
  }

 private:
  std::vector<RowLabel> labels_;
};

// The truth is a search on a grid. The slopes' first step, from 1.1 on, goes to 1.8 and is refused.
TEST(HeldOut, IsPredictedByTheBestFitToTheOthers) {
  Discrepancy discrepancy;
  discrepancy.add(std::make_unique<Growth>());
  const VectorXd start = VectorXd::Constant(1, 1.2);
  const Refit fit = refit(discrepancy, start, {0});
  ASSERT_LT(fit.unknowns(0), 1.2);
  const std::vector<RowLabel> labels = discrepancy.labels();
  const HeldOut found = predict_held_out(discrepancy, fit, labels);
  ASSERT_TRUE(found.possible);
  double least = INFINITY;
  VectorXd best;
  for (double rate = 0.9; rate < 2; rate += 1e-4) {
    const VectorXd rows = discrepancy(VectorXd::Constant(1, rate));
    const double left = rows.head(16).squaredNorm();
    if (left < least) best = rows;
    least = std::min(least, left);
  }
  EXPECT_LT((found.rows.tail(4) - best.tail(4)).norm(), 1e-2 * best.tail(4).norm());
}

// Of given numbers the rows are as they are, nothing was fitted to them; those of explanations are predicted once.
TEST(HeldOutGap, IsThatOfTheNumbersThatAreJudged) {
  Discrepancy discrepancy;
  discrepancy.add(std::make_unique<Growth>());
  const std::vector<RowLabel> labels = discrepancy.labels();
  Explanation null, fitted;
  null.fit.unknowns = VectorXd::Constant(1, 1);
  null.fit.rows = discrepancy(null.fit.unknowns);
  fitted.fit = refit(discrepancy, VectorXd::Constant(1, 1.2), {0});
  const double held_out = std::sqrt(predict_held_out(discrepancy, fitted.fit, labels).rows.squaredNorm() / 20);
  HeldOutGap own(discrepancy, labels, {}, null, 1);
  EXPECT_DOUBLE_EQ(own.closed_by(fitted).after, held_out);
  EXPECT_DOUBLE_EQ(own.closed_by(fitted).before, std::sqrt(null.fit.rows.squaredNorm() / 20));
  EXPECT_EQ(own.closed_by(null).closed, 0);
  EXPECT_EQ(own.unclosed().closed, 0);
  EXPECT_FALSE(own.repeats_step(null, null));
  HeldOutGap given(discrepancy, labels, VectorXd::Constant(20, 3), null, 1);
  EXPECT_DOUBLE_EQ(given.closed_by(fitted).before, 3);
  EXPECT_DOUBLE_EQ(given.closed_by(fitted).after, held_out);
}

TEST(ClosedShare, OfOneConditionIsAnything) {
  const ClosedShare share = closed_share(VectorXd::Constant(8, 5), VectorXd::Constant(8, 1), labels_of(1, 8), 1);
  EXPECT_EQ(share.closed, 1);
  EXPECT_EQ(share.low, -1);
  EXPECT_EQ(share.high, 1);
}

TEST(ClosedShare, OfThreeConditionsIsAnywhereBetweenThem) {
  VectorXd before = VectorXd::Constant(12, 5), after(12);
  after << 1, 1, 1, 1, 2, 2, 2, 2, 4, 4, 4, 4;
  const ClosedShare share = closed_share(before, after, labels_of(3, 4), 1);
  EXPECT_DOUBLE_EQ(share.low, 0.25);
  EXPECT_DOUBLE_EQ(share.high, 1);
}

// Conditions in which nothing was to be closed have closed all of it.
TEST(ClosedShare, DoesNotFallByConditionsWithoutAGap) {
  VectorXd before = VectorXd::Constant(40, 0.9), after = VectorXd::Constant(40, 0.85);
  before.head(12).setConstant(3);
  const ClosedShare share = closed_share(before, after, labels_of(10, 4), 1);
  EXPECT_EQ(share.closed, 1);
  EXPECT_EQ(share.low, 1);
}

// Five conditions of a population whose shares are known: percentiles of 2.5 % of such draws hold them in 80 % of
// cases, Student's in 95 %.
TEST(ClosedShare, IntervalHoldsTheShareOfAllConditions) {
  constexpr Index folds = 5, each = 20, campaigns = 400;
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  const auto sizes = [&](VectorXd& before, VectorXd& after, Index count) {
    before.resize(count * each);
    after.resize(count * each);
    for (Index f = 0; f < count; ++f) {
      before.segment(f * each, each).setConstant(6);
      after.segment(f * each, each).setConstant(std::clamp(3 + 0.7 * normal(random), 1.0, 6.0));
    }
  };
  VectorXd before, after;
  sizes(before, after, 100000);
  const double truth = (6 - std::sqrt(after.squaredNorm() / static_cast<double>(after.size()))) / 5;
  int held = 0;
  for (int c = 0; c < campaigns; ++c) {
    sizes(before, after, folds);
    const ClosedShare share = closed_share(before, after, labels_of(folds, each), 1);
    if (share.low <= truth && truth <= share.high) ++held;
  }
  EXPECT_GT(held, 0.9 * campaigns);
}

TEST(Repeats, WhatFewConditionsSayDoesNot) {
  const std::vector<RowLabel> labels = labels_of(10, 4);
  const VectorXd before = VectorXd::Constant(40, 2);
  VectorXd everywhere = VectorXd::Constant(40, 1.5), once = before;
  everywhere.head(4).setConstant(1);
  once.head(4).setZero();
  EXPECT_TRUE(repeats(before, everywhere, labels));
  EXPECT_FALSE(repeats(before, once, labels));
  EXPECT_FALSE(repeats(before, before, labels));
  EXPECT_FALSE(repeats(everywhere, before, labels));
  EXPECT_FALSE(repeats(before, everywhere, labels_of(1, 40)));
}

// By chance alone: once in forty.
TEST(Repeats, IsSaidByChanceAsOftenAsItShouldBe) {
  constexpr Index folds = 6, each = 10, campaigns = 2000;
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  int said = 0;
  for (int c = 0; c < campaigns; ++c) {
    VectorXd before(folds * each), after(folds * each);
    for (double& x : before) x = normal(random);
    for (double& x : after) x = normal(random);
    if (repeats(before, after, labels_of(folds, each))) ++said;
  }
  EXPECT_NEAR(said, 0.025 * campaigns, 4 * std::sqrt(0.025 * campaigns));
}

}  // namespace
}  // namespace secular
