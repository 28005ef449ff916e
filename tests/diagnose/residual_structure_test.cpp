// What an explanation leaves as a smooth function of the settings, on rows that are made up.
#include "diagnose/inference/residual_structure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int dwells = 40;

std::vector<RowLabel> labels() {
  std::vector<RowLabel> all;
  for (int d = 0; d < dwells; ++d) {
    RowLabel label;
    label.place = "v";
    label.harmonic = "Omega";
    label.amplitude = 1e-4 * std::exp(0.07 * d);
    label.time_s = 60 * ((d * 7) % dwells);
    label.level = 1 + d / 10;
    label.frequency = 60 + 0.1 * ((d * 3) % 10);
    label.balance = true;
    for (const EffectComponent part : {EffectComponent::conservative, EffectComponent::dissipative}) {
      label.component = part;
      all.push_back(label);
    }
    label.balance = false;
    label.component = EffectComponent::measurement;
    all.insert(all.end(), 6, label);
  }
  return all;
}

// The square of the amplitude, in the conservative rows.
VectorXd bend(const std::vector<RowLabel>& rows) {
  VectorXd bend = VectorXd::Zero(static_cast<Index>(rows.size()));
  for (std::size_t r = 0; r < rows.size(); ++r)
    if (rows[r].balance && rows[r].component == EffectComponent::conservative)
      bend(static_cast<Index>(r)) = std::pow(rows[r].amplitude, 2);
  return bend.normalized();
}

Refit noise(std::size_t rows, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Refit fit;
  fit.rows.resize(static_cast<Index>(rows));
  for (double& x : fit.rows) x = normal(random);
  fit.jacobian.resize(fit.rows.size(), 0);
  return fit;
}

// The mean of 200 chi-squared values of k degrees of freedom has standard deviation sqrt(2 k/200).
TEST(SmoothStructure, IsChiSquaredOfNoise) {
  const std::vector<RowLabel> rows = labels();
  double sum = 0, freedom = 0;
  constexpr int draws = 200;
  for (unsigned seed = 1; seed <= draws; ++seed) {
    const SmoothStructure left = smooth_structure(noise(rows.size(), seed), rows);
    sum += left.squares;
    freedom = left.freedom;
  }
  EXPECT_EQ(freedom, 18);
  EXPECT_NEAR(sum / draws, freedom, 4 * std::sqrt(2 * freedom / draws));
}

// Seven standard deviations in all, spread over forty of 320 rows: their sum of squares varies by 25, and 49 more
// are next to nothing there.
TEST(SmoothStructure, SeesWhatIsSpreadOut) {
  const std::vector<RowLabel> rows = labels();
  Refit fit = noise(rows.size(), 5);
  fit.rows += 7 * bend(rows);
  EXPECT_LT(smooth_structure(fit, rows).p_value, 1e-4);
  // A fitted unknown of that signature has taken its own part.
  fit.jacobian = bend(rows);
  fit.rows -= fit.jacobian * (fit.jacobian.transpose() * fit.rows);
  const SmoothStructure fitted = smooth_structure(fit, rows);
  EXPECT_GT(fitted.p_value, 1e-3);
  EXPECT_EQ(fitted.freedom, 18);
  // One of the functions themselves is no function to look for any more.
  fit.jacobian = MatrixXd::Zero(fit.rows.size(), 1);
  for (std::size_t r = 0; r < rows.size(); ++r)
    if (rows[r].balance && rows[r].component == EffectComponent::dissipative)
      fit.jacobian(static_cast<Index>(r), 0) = 1;
  EXPECT_EQ(smooth_structure(fit, rows).freedom, 17);
}

TEST(SmoothStructure, SaysNothingOfAFewRows) {
  std::vector<RowLabel> rows = labels();
  rows.resize(16);
  const SmoothStructure left = smooth_structure(noise(rows.size(), 3), rows);
  EXPECT_EQ(left.freedom, 0);
  EXPECT_EQ(left.p_value, 1);
}

ClosedShare closing(double closed, double low) {
  ClosedShare share;
  share.closed = closed;
  share.low = low;
  return share;
}

constexpr ResidualStructure nothing{.p_value = 0.01, .smooth_p_value = 0.5},
    rows_left{.p_value = 1e-9, .smooth_p_value = 1}, smooth_left{.p_value = 1, .smooth_p_value = 1e-9};

TEST(Reach, WhereNothingIsLeftItGoesAllTheWay) {
  EXPECT_EQ(reach_of(nothing, closing(0.99, 0.9)), Reach::all);
  EXPECT_EQ(reach_of(nothing, closing(0.7, 0.5)), Reach::all);
}

TEST(Reach, BesideStructureItIsApproximateFromNineTenthsOn) {
  for (const ResidualStructure& left : {rows_left, smooth_left}) {
    EXPECT_EQ(reach_of(left, closing(0.999, 0.99)), Reach::approximate);
    EXPECT_EQ(reach_of(left, closing(0.9, 0.6)), Reach::approximate);
    EXPECT_EQ(reach_of(left, closing(0.89, 0.6)), Reach::little);
  }
}

TEST(Reach, IsNotShownWhereTheIntervalReachesBelowOneHalf) {
  for (const ResidualStructure& left : {nothing, rows_left}) {
    EXPECT_EQ(reach_of(left, closing(0.95, -1)), Reach::little);
    EXPECT_EQ(reach_of(left, closing(1, 0)), Reach::little);
    EXPECT_EQ(reach_of(left, closing(0.95, std::nan(""))), Reach::little);
  }
  EXPECT_EQ(reach_of(rows_left, closing(0.95, 0.6)), Reach::approximate);
}

TEST(Reach, WhatIsMissedOfHeldOutConditionsIsNoMoreThanTheirRepeatability) {
  const auto reach = [](double before, double after) {
    ClosedShare share = closing((before - after) / (before - 1), 0.6);
    share.before = before;
    share.after = after;
    return reach_of(nothing, share);
  };
  EXPECT_EQ(reach(200, 1.41), Reach::all);
  EXPECT_EQ(reach(200, 1.42), Reach::little);
  EXPECT_EQ(reach(200, 5), Reach::little);
  EXPECT_NE(what_is_missing(nothing, closing(0.8, 0.6)).find("held out"), std::string::npos);
}

TEST(Reach, OfTwoConditionsNoneIsHeldOut) {
  for (const int conditions : {1, 2, 3}) {
    std::vector<RowLabel> labels(12);
    for (std::size_t i = 0; i < labels.size(); ++i) labels[i].fold = static_cast<int>(i) % conditions;
    const ClosedShare share =
        closed_share(Eigen::VectorXd::Constant(12, 20), Eigen::VectorXd::Constant(12, 0.5), labels, 1);
    EXPECT_EQ(reach_of(nothing, share) == Reach::all, conditions == 3) << conditions;
  }
}

// Whatever the evidence: neither where nothing was closed, nor where there was nothing to close.
TEST(Reach, NoCauseClosesNothing) {
  const auto closes = [](double before, double after) {
    std::vector<RowLabel> labels(4);
    for (std::size_t i = 0; i < labels.size(); ++i) labels[i].fold = static_cast<int>(i);
    return reach_of(nothing, closed_share(Eigen::VectorXd::Constant(4, before), Eigen::VectorXd::Constant(4, after),
                                          labels, 1)) == Reach::all;
  };
  EXPECT_FALSE(closes(2.5, 2.5));
  EXPECT_FALSE(closes(2.5, 2.8));
  EXPECT_FALSE(closes(0.94, 0.5));
  EXPECT_FALSE(closes(0.144, 0.1));
  EXPECT_FALSE(closes(11, 7));
  EXPECT_TRUE(closes(11, 1.4));
}

}  // namespace
}  // namespace secular
