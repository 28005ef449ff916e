// Lack of fit and damping laws on observations whose truth is known exactly.
#include "estimator/identification/lack_of_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "modulation_observations.hpp"
#include "virtual_campaign.hpp"

namespace secular {
namespace {

using namespace testing_support;

std::vector<LackOfFit> tests_of(const Estimate& estimate) {
  return estimate.lack_of_fit.empty() ? std::vector<LackOfFit>{} : estimate.lack_of_fit.front().equations;
}

EstimateOptions options_with(std::map<std::string, double> fixed) {
  EstimateOptions options;
  options.fixed = std::move(fixed);
  options.damping_laws = false;
  return options;
}

TEST(LackOfFit, FollowsItsLawWhereTheModelHolds) {
  const OneMode truth;
  constexpr int draws = 25;
  double f[2] = {0, 0};
  int below_a_tenth = 0, count = 0;
  double numerator = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const Estimate result =
        estimate(truth.set(static_cast<std::uint64_t>(draw) + 1), "kg^(1/2) m", {"m/s^2"}, options_with({}));
    const auto tests = tests_of(result);
    ASSERT_EQ(tests.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      f[i] += tests[i].f / draws;
      numerator = tests[i].numerator_df;
      below_a_tenth += tests[i].p_value < 0.1;
      ++count;
      EXPECT_FALSE(tests[i].significant);
      EXPECT_NEAR(tests[i].scatter_ratio, 1, 5 / std::sqrt(2.0 * tests[i].denominator_df));
    }
    EXPECT_FALSE(value_of(result, "mu3").doubtful);
    EXPECT_EQ(value_of(result, "mu3").misfit, 0);
  }
  // Mean of draws of F: 1 with sd sqrt(2/(numerator draws)), a little more for the denominator's.
  for (const double mean : f) EXPECT_NEAR(mean, 1, 4.5 * std::sqrt(2 / (numerator * draws)));
  EXPECT_NEAR(below_a_tenth, 0.1 * count, 4 * std::sqrt(0.09 * count));
}

// Drag that the model is told not to have: the balance of energy misfits, and what rests on it is doubtful and
// wide. Most of the drag is absorbed (three to one in amplitude parts it badly from linear and cubic damping): that
// no error bar made from the data can be wide enough is why the number is called doubtful.
TEST(LackOfFit, ADampingLawThatIsMissingIsToldAndCounts) {
  OneMode truth;
  truth.mu2 = 6;
  const Estimate result = estimate(truth.set(3), "kg^(1/2) m", {"m/s^2"}, options_with({{"mu2", 0}}));
  const Estimate whole = estimate(truth.set(3), "kg^(1/2) m", {"m/s^2"}, options_with({}));
  bool told = false;
  for (const LackOfFit& test : tests_of(result))
    told = told || (test.significant && test.part == EquationPart::in_phase &&
                    test.name.find("balance of energy") != std::string::npos);
  EXPECT_TRUE(told);
  EXPECT_TRUE(warns(result.warnings, "balance of energy"));
  EXPECT_TRUE(warns(result.warnings, "doubtful because the model does not fit"));
  const EstimatedValue &mu3 = value_of(result, "mu3"), &right = value_of(whole, "mu3");
  // The jackknife alone calls the wrong number sure.
  const double own_sd = std::sqrt(mu3.sd * mu3.sd - 0.25 * mu3.misfit * mu3.misfit);
  EXPECT_GT(std::abs(*mu3.value - 36.87), 5 * own_sd);
  EXPECT_TRUE(mu3.doubtful);
  ASSERT_EQ(mu3.doubtful_because.size(), 1U);
  EXPECT_NE(mu3.doubtful_because.front().find("the model does not fit"), std::string::npos);
  EXPECT_GT(mu3.sd, 2 * own_sd);
  for (const LackOfFit& test : tests_of(whole)) EXPECT_FALSE(test.significant) << test.name;
  EXPECT_FALSE(right.doubtful);
  EXPECT_TRUE(right.doubtful_because.empty());
  EXPECT_NEAR(*right.value, 36.87, 5 * right.sd);
}

// What is not known of the truncation makes a misfit less likely to be one. What is beyond that, and may hide along
// the columns, is the same sum of squares less a larger one that is usual.
TEST(LackOfFit, WhatMayHideIsWhatIsBeyondNoiseAndUnknownTruncation) {
  OneMode truth;
  truth.mu2 = 6;
  ObservationSet set = truth.set(3);
  const auto rows = static_cast<Eigen::Index>(set.observations.size());
  const auto count = static_cast<Eigen::Index>(truth.resonance.blocks.size());
  std::vector<std::size_t> blocks;
  for (std::size_t b = 0; b < truth.resonance.blocks.size(); ++b)
    if (truth.resonance.blocks[b].kind == BlockKind::modulation) blocks.push_back(b);
  set.truncation = Eigen::MatrixXcd::Zero(rows, count);
  set.truncation_of_moves = {Eigen::MatrixXcd::Zero(rows, count)};
  for (Eigen::Index i = 0; i < rows; ++i)
    set.truncation_of_moves[0](i, static_cast<Eigen::Index>(blocks.front())) = {5e-6, 5e-6};
  CaseKnowledge known;
  known.natural_frequency = {w0};
  known.fixed[{std::string(truth.resonance.name), "mu2"}] = 0;
  const CaseFit fit = fit_case(set, blocks, known);
  const auto at = [&](double unknown) { return lack_of_fit(fit, Eigen::MatrixXd::Constant(1, 1, unknown)); };
  const std::vector<LackOfFit> sure = at(0), open = at(0.3);
  ASSERT_EQ(sure.size(), open.size());
  bool any = false;
  for (std::size_t i = 0; i < sure.size(); ++i) {
    if (!sure[i].significant || !open[i].significant) continue;
    any = true;
    EXPECT_LT(open[i].f, 0.8 * sure[i].f);
    const auto means = [](const LackOfFit& test) { return test.beyond * test.f / (test.f - 1); };
    EXPECT_NEAR(means(open[i]) / means(sure[i]), 1, 1e-12);
    EXPECT_NEAR(sure[i].beyond,
                (sure[i].f - 1) * sure[i].numerator_df * sure[i].scatter_ratio * sure[i].scatter_ratio,
                1e-9 * sure[i].beyond);
  }
  ASSERT_TRUE(any);
  const Eigen::MatrixXd surely = hidden_misfit(fit, sure), openly = hidden_misfit(fit, open);
  const double squares = openly.squaredNorm() / surely.squaredNorm();
  EXPECT_LT(squares, 1);
  EXPECT_GT(squares, 0.5);  // not by the factor that F fell by
}

// Repeats of one condition are taken at different instants: estimates, weights and tests must not notice, even
// where the model does not fit.
TEST(LackOfFit, InstantsOfTheEnsemblesDoNotMatter) {
  OneMode truth;
  truth.mu2 = 6;
  const auto fixed = options_with({{"mu2", 0}});
  const Estimate turned = estimate(truth.set(3, true), "kg^(1/2) m", {"m/s^2"}, fixed);
  const Estimate still = estimate(truth.set(3, false), "kg^(1/2) m", {"m/s^2"}, fixed);
  EXPECT_EQ(turned.outliers.size(), still.outliers.size());
  for (const char* name : {"mu1", "mu3", "alpha_e", "eta_e"}) {
    EXPECT_NEAR(*value_of(turned, name).value / *value_of(still, name).value, 1, 1e-7) << name;
    EXPECT_NEAR(value_of(turned, name).sd / value_of(still, name).sd, 1, 1e-5) << name;
  }
  ASSERT_EQ(tests_of(turned).size(), tests_of(still).size());
  for (std::size_t i = 0; i < tests_of(turned).size(); ++i)
    EXPECT_NEAR(tests_of(turned)[i].f / tests_of(still)[i].f, 1, 1e-5);
  // A misfit is no outlier: ensembles agree with the others of their condition.
  EXPECT_LE(turned.outliers.size(), 1U);
}

// Columns that are the same but for a factor leave a direction that the rows do not see: what rounding makes of it
// is no unknown of theirs.
TEST(LackOfFit, RoundingReachesNoErrorBar) {
  OneMode one_level;
  one_level.peak_spread = one_level.amplitude_sd = 0;
  const auto fixed = options_with({{"mu2", 0}, {"mu3", one_level.mu3}});
  const Estimate turned = estimate(one_level.set(3, true), "kg^(1/2) m", {"m/s^2"}, fixed);
  const Estimate still = estimate(one_level.set(3, false), "kg^(1/2) m", {"m/s^2"}, fixed);
  EXPECT_FALSE(value_of(still, "alpha_e").identifiable);  // is not told from the natural frequency
  ASSERT_TRUE(value_of(still, "mu1").value);
  EXPECT_NEAR(value_of(turned, "mu1").sd / value_of(still, "mu1").sd, 1, 1e-5);
}

// The signed-rank decision: laws by what they predict of left-out conditions.
TEST(LackOfFit, TheSimplestDampingLawThatPredictsIsChosen) {
  OneMode cubic, drag, both;
  drag.mu2 = 9 * std::numbers::pi / 32 * w0 * 36.87 * 1.6e-3;
  drag.mu3 = 0;
  both.mu2 = 4;
  const auto chosen = [](const OneMode& truth) {
    const Estimate result = estimate(truth.set(11), "kg^(1/2) m", {"m/s^2"}, {});
    EXPECT_EQ(result.damping.size(), 1U);
    const DampingComparison& comparison = result.damping.front();
    EXPECT_TRUE(comparison.decided);
    return comparison.laws[comparison.chosen].terms;
  };
  EXPECT_EQ(chosen(cubic), (std::vector<std::string>{"mu1", "mu3"}));
  EXPECT_EQ(chosen(drag), (std::vector<std::string>{"mu1", "mu2"}));
  EXPECT_EQ(chosen(both), (std::vector<std::string>{"mu1", "mu2", "mu3"}));
}

TEST(FailedCorrection, LeavesNoValueWithoutDoubt) {
  const OneMode truth;
  const Estimate raw = estimate(truth.set(1), "kg^(1/2) m", {"m/s^2"}, options_with({{"mu2", 0.0}}));
  const Estimate failed = with_failed_correction(raw, "the simulated motion grows beyond bounds");
  std::size_t doubtful = 0;
  for (const EstimatedValue& v : failed.parameters) {
    EXPECT_EQ(v.doubtful, v.value.has_value() && !v.fixed) << v.name;
    EXPECT_EQ(v.doubtful, !v.doubtful_because.empty()) << v.name;
    doubtful += v.doubtful;
  }
  EXPECT_GT(doubtful, 0U);
  ASSERT_EQ(failed.warnings.size(), raw.warnings.size() + 1);
  EXPECT_NE(failed.warnings.back().find("grows beyond bounds"), std::string::npos);
}

// Fewer conditions than error bars by their scatter need: repeats know nothing of what the equations lack.
TEST(FailedCorrection, LeavesNoNumberOfTooFewConditions) {
  OneMode truth;
  truth.conditions = 4;
  const Estimate raw = estimate(truth.set(1), "kg^(1/2) m", {"m/s^2"}, options_with({{"mu2", 0.0}}));
  ASSERT_TRUE(value_of(raw, "mu1").value);
  const Estimate failed = with_failed_correction(raw, "the simulated motion grows beyond bounds");
  for (const auto* values : {&failed.parameters, &failed.lumps})
    for (const EstimatedValue& v : *values) EXPECT_EQ(v.value.has_value(), v.fixed) << v.name;
  EXPECT_NE(failed.warnings.back().find("mu1"), std::string::npos);
}

}  // namespace
}  // namespace secular
