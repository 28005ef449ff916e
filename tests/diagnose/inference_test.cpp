// The search for explanations, on rows that are a few lines of algebra.
#include "diagnose/inference/inference.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "tests/diagnose/tone_signal.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using testing_support::readings;
using testing_support::sd;
using testing_support::Signal;
using testing_support::tone_candidates;
using testing_support::tones;

// The tone that the model lacks is stronger than its own: alone, the model's frequency goes there from 1.1 on.
TEST(Inference, FindsWhatIsMissingThoughTheModelsOwnNumbersRunAwayFromIt) {
  for (const double strength : {1.5, 2.0, 3.0}) {
    VectorXd truth = VectorXd::Zero(std::size(tones) + 1), start = truth;
    truth(0) = 1;
    truth(1) = strength;
    start(0) = 1.1;
    Discrepancy discrepancy;
    discrepancy.add(std::make_unique<Signal>(truth));
    const Inference found = infer(discrepancy, tone_candidates(), start, {0}, {});
    EXPECT_GT(found.null.fit.unknowns(0), 1.3);
    ASSERT_FALSE(found.explanations.empty());
    const Explanation& best = found.explanations.front();
    EXPECT_EQ(best.members, std::vector<std::size_t>{0}) << strength;
    EXPECT_NEAR(best.fit.unknowns(0), 1, 5e-3) << strength;
    EXPECT_NEAR(best.fit.unknowns(1), strength, 0.02) << strength;
    // Chi-squared on 118 degrees of freedom stays below this in 9999 of 10000 draws.
    EXPECT_LT(best.fit.chi_squared, 181) << strength;
  }
}

// The natural frequency is known: what is left is a tone of 40 to 90 standard deviations, a trifle among coarse
// errors.
TEST(Inference, NoGainIsTooSmallAmongErrorsThatAreCoarse) {
  for (const double strength : {0.1, 0.2}) {
    VectorXd truth = VectorXd::Zero(std::size(tones) + 1), start = truth;
    start(0) = truth(0) = 1;
    truth(3) = strength;
    Discrepancy discrepancy;
    discrepancy.add(std::make_unique<Signal>(truth));
    const Inference found = infer(discrepancy, tone_candidates(), start, {}, {});
    ASSERT_FALSE(found.explanations.empty());
    EXPECT_EQ(found.explanations.front().members, std::vector<std::size_t>{2});
    EXPECT_NEAR(found.explanations.front().fit.unknowns(3), strength, 0.02);
    EXPECT_GT(found.null.fit.chi_squared, 1000);
  }
}

// Nothing explains what is missing: the model is judged at the errors of the measurement all the same.
TEST(Inference, WithoutCandidatesTheModelIsJudgedAtTheTrueErrors) {
  for (const double strength : {0.3, 3.0}) {
    VectorXd truth = VectorXd::Zero(std::size(tones) + 1), start = truth;
    start(0) = truth(0) = 1;
    truth(3) = strength;
    Discrepancy discrepancy;
    discrepancy.add(std::make_unique<Signal>(truth));
    const Inference found = infer(discrepancy, {}, start, {}, {});
    EXPECT_NEAR(found.null.fit.rows.norm(), strength * std::sqrt(readings / 2.0) / sd,
                0.1 * strength * std::sqrt(readings / 2.0) / sd);
  }
}

// Stairs that end at a wall: slopes over their length promise what no step brings.
class Stairs : public Evidence {
 public:
  Index size() const override { return 1; }
  const std::vector<RowLabel>& labels() const override { return labels_; }
  void freeze(const VectorXd& /*unknowns*/, double /*coarse*/) override {}
  void evaluate(const VectorXd& unknowns, Eigen::Ref<VectorXd> rows) const override {
    const double x = unknowns(0);
    rows(0) = x < 20.3 ? 30 - std::floor(x) : 40;
  }

 private:
  std::vector<RowLabel> labels_ = std::vector<RowLabel>(1);
};

TEST(Refit, AStepThatDoesNotBringWhatItPromisesHasNotConverged) {
  Discrepancy discrepancy;
  discrepancy.add(std::make_unique<Stairs>());
  const Refit stairs = refit(discrepancy, VectorXd::Constant(1, 0.4), {0});
  EXPECT_GT(stairs.chi_squared, 1);
  EXPECT_EQ(stairs.ending, SolverEnding::stalled);
  VectorXd truth = VectorXd::Zero(std::size(tones) + 1);
  truth(0) = 1;
  Discrepancy smooth;
  smooth.add(std::make_unique<Signal>(truth));
  EXPECT_EQ(refit(smooth, truth, {0, 1}).ending, SolverEnding::converged);
}

TEST(Inference, WhatTheModelExplainsNeedsNoSecondEffect) {
  VectorXd truth = VectorXd::Zero(std::size(tones) + 1);
  truth(0) = 1;
  Discrepancy discrepancy;
  discrepancy.add(std::make_unique<Signal>(truth));
  const Inference found = infer(discrepancy, tone_candidates(), truth, {0}, {});
  EXPECT_LT(found.null.fit.chi_squared, 181);
  for (const Explanation& e : found.explanations) EXPECT_EQ(e.members.size(), 1u);
}

}  // namespace
}  // namespace secular
