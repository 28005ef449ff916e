#include "estimator/regression/linear_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include "../signal/gaussian.hpp"
#include "estimator/thresholds.hpp"
#include "numerics/confidence.hpp"
#include "numerics/nonlinear_fit.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::vector<int> own_clusters(Eigen::Index rows) {
  std::vector<int> labels(static_cast<std::size_t>(rows));
  std::iota(labels.begin(), labels.end(), 0);
  return labels;
}

TEST(LinearFit, StraightLineByHand) {
  // y = 1, 3, 4, 4 at x = 0, 1, 2, 3: slope 1, intercept 3/2, residuals -1/2, 1/2, 1/2, -1/2.
  MatrixXd design(4, 2);
  design << 1, 0, 1, 1, 1, 2, 1, 3;
  const VectorXd y = (VectorXd(4) << 1, 3, 4, 4).finished();
  const LinearFit fit = linear_fit(design, y, std::vector<int>{0, 0, 1, 1});
  EXPECT_NEAR(fit.coefficients(0), 1.5, 1e-13);
  EXPECT_NEAR(fit.coefficients(1), 1, 1e-13);
  EXPECT_EQ(fit.covariance_kind, CovarianceKind::plain);  // two clusters for two columns
  EXPECT_NEAR(fit.residual_sd, std::sqrt(0.5), 1e-13);
  EXPECT_NEAR(fit.covariance(1, 1), 0.5 / 5, 1e-13);
  EXPECT_NEAR(fit.leverage.sum(), 2, 1e-13);
}

TEST(LinearFit, LeavingAClusterOutIsExact) {
  testing_support::Gaussian noise(5);
  MatrixXd design(30, 3);
  for (int c = 0; c < 3; ++c) design.col(c) = noise.vector(30);
  const VectorXd y = noise.vector(30);
  std::vector<int> cluster;
  for (int r = 0; r < 30; ++r) cluster.push_back(r / 5);
  const LinearFit fit = linear_fit(design, y, cluster);
  EXPECT_EQ(fit.covariance_kind, CovarianceKind::clustered);
  const VectorXd without = design.bottomRows(25).colPivHouseholderQr().solve(y.tail(25));
  EXPECT_LT((fit.influence.row(0).transpose() - (without - fit.coefficients)).norm(), 1e-12);
}

TEST(LinearFit, ScalingOfColumnsChangesNothingElse) {
  testing_support::Gaussian noise(6);
  MatrixXd design(40, 2);
  design.col(0) = noise.vector(40);
  design.col(1) = noise.vector(40) + design.col(0);
  const VectorXd y = design.col(0) - 2 * design.col(1) + noise.vector(40);
  const LinearFit fit = linear_fit(design, y, own_clusters(40));
  MatrixXd scaled = design;
  scaled.col(1) *= 1e-9;
  const LinearFit again = linear_fit(scaled, y, own_clusters(40));
  EXPECT_NEAR(again.coefficients(1) * 1e-9, fit.coefficients(1), 1e-10);
  EXPECT_NEAR(std::sqrt(again.covariance(1, 1)) * 1e-9, std::sqrt(fit.covariance(1, 1)), 1e-10);
  EXPECT_EQ(again.rank, 2);
}

TEST(LinearFit, SaysWhichColumnsCannotBeToldApart) {
  testing_support::Gaussian noise(7);
  MatrixXd design(20, 4);
  for (int c = 0; c < 3; ++c) design.col(c) = noise.vector(20);
  design.col(3) = design.col(0) - 5 * design.col(2);
  const LinearFit fit = linear_fit(design, noise.vector(20), own_clusters(20));
  EXPECT_EQ(fit.rank, 3);
  EXPECT_EQ(fit.identifiable, (std::vector<bool>{false, true, false, false}));
  EXPECT_EQ(fit.entangled_with[0], (std::vector<int>{2, 3}));
  design.col(3).setZero();
  EXPECT_FALSE(linear_fit(design, noise.vector(20), own_clusters(20)).identifiable[3]);
}

TEST(LinearFitStatistical, IntervalsCoverWithErrorsSharedInClusters) {
  // 19 conditions of 10 ensembles; errors of one condition are correlated. Plain least squares would cover about
  // half.
  testing_support::Gaussian noise(8);
  constexpr int conditions = 19, repeats = 10, draws = 1500;
  MatrixXd design(conditions * repeats, 2);
  std::vector<int> cluster;
  for (int c = 0; c < conditions; ++c)
    for (int r = 0; r < repeats; ++r) {
      design.row(c * repeats + r) << 1, 0.1 * c + 0.01 * r;
      cluster.push_back(c);
    }
  int covered = 0;
  for (int d = 0; d < draws; ++d) {
    VectorXd y = design * Eigen::Vector2d(1, 2);
    for (int c = 0; c < conditions; ++c) {
      const double shared = noise();
      for (int r = 0; r < repeats; ++r) y(c * repeats + r) += shared + 0.3 * noise();
    }
    const LinearFit fit = linear_fit(design, y, cluster);
    const Interval interval =
        confidence_interval(fit.coefficients(1), std::sqrt(fit.covariance(1, 1)), fit.degrees_of_freedom);
    covered += interval.low < 2 && 2 < interval.high;
  }
  const double spread = std::sqrt(0.95 * 0.05 / draws);
  EXPECT_GT(covered / static_cast<double>(draws), 0.95 - 3.5 * spread);
  EXPECT_LT(covered / static_cast<double>(draws), 0.97 + 3.5 * spread);  // the jackknife errs on the wide side
}

TEST(Confidence, KnownQuantiles) {
  EXPECT_NEAR(confidence_interval(0, 1, 10).high, 2.228138852, 1e-8);
  EXPECT_NEAR(confidence_interval(0, 1, INFINITY).high, 1.959963985, 1e-8);
  EXPECT_NEAR(two_sided_p_value(2.228138852, 10), 0.05, 1e-9);
}

TEST(NonlinearFit, RosenbrocksValley) {
  const ResidualFunction function = [](const VectorXd& x, VectorXd& r, MatrixXd& j) {
    r << 10 * (x(1) - x(0) * x(0)), 1 - x(0);
    j << -20 * x(0), 10, -1, 0;
  };
  const FitReport report = nonlinear_fit(function, 2, Eigen::Vector2d(-1.2, 1));
  EXPECT_EQ(report.ending, SolverEnding::converged) << report.reason;
  EXPECT_LT((report.parameters - Eigen::Vector2d(1, 1)).norm(), 1e-8);
}

TEST(NonlinearFit, UnseenDirectionsStayAndAreNamed) {
  const ResidualFunction function = [](const VectorXd& x, VectorXd& r, MatrixXd& j) {
    r << x(0) + x(1) - 3, 2 * (x(2) - 1);
    j << 1, 1, 0, 0, 0, 2;
  };
  const FitReport report = nonlinear_fit(function, 2, Eigen::Vector3d(5, 0, 0));
  EXPECT_EQ(report.identifiable, (std::vector<bool>{false, false, true}));
  EXPECT_EQ(report.entangled_with[0], (std::vector<int>{1}));
  EXPECT_NEAR(report.parameters(0) + report.parameters(1), 3, 1e-9);
  EXPECT_NEAR(report.parameters(0) - report.parameters(1), 5, 1e-9);  // untouched
  EXPECT_NEAR(report.covariance(2, 2), 0.25, 1e-12);
}

// One of two parameters is seen through a difference of one part in 1e8 only.
TEST(NonlinearFit, WhatSaysLessThanIsPlausibleIsNotFollowed) {
  const ResidualFunction function = [](const VectorXd& x, VectorXd& r, MatrixXd& j) {
    const double part = 1e-8;
    r << x(0) + x(1) - 3, part * (x(0) - x(1)) - 0.5;
    j << 1, 1, part, -part;
  };
  const Eigen::Vector2d start(1, 1);
  const FitReport followed = nonlinear_fit(function, 2, start);
  EXPECT_GT(followed.parameters(0) - followed.parameters(1), 1e7);
  const FitReport held = nonlinear_fit(function, 2, start, 100, Eigen::Vector2d(10, 10));
  EXPECT_NEAR(held.parameters(0) + held.parameters(1), 3, 1e-9);
  EXPECT_NEAR(held.parameters(0) - held.parameters(1), 0, 1e-6);
  EXPECT_GT(held.covariance(0, 0), 1e15);  // and yet its error bar says how little is known
}

// A direction near the border between signal and noise stays where it was.
TEST(LinearFit, DirectionsNearTheBorderStayOnTheirSide) {
  MatrixXd design(12, 2);
  std::vector<int> cluster;
  for (Index i = 0; i < 12; ++i) {
    design.row(i) << 1, (i % 2 == 0 ? 1 : -1);
    cluster.push_back(static_cast<int>(i));
  }
  const VectorXd response = design * Eigen::Vector2d(1, 2);
  const auto noisy = [&](double ratio, std::optional<Index> before) {
    ColumnErrors errors;
    errors.gram = MatrixXd::Zero(2, 2);
    errors.gram(1, 1) = 12 / ratio;
    return linear_fit(design, response, cluster, errors, {.noisy_before = before}).noisy;
  };
  EXPECT_EQ(noisy(estimator_thresholds().noise_ratio * 1.1, std::nullopt), 0);
  EXPECT_EQ(noisy(estimator_thresholds().noise_ratio / 1.1, std::nullopt), 1);
  EXPECT_EQ(noisy(estimator_thresholds().noise_ratio / 1.1, 0), 0);
  EXPECT_EQ(noisy(estimator_thresholds().noise_ratio * 1.1, 1), 1);
  EXPECT_EQ(noisy(estimator_thresholds().noise_ratio / 2.2, 0), 1);
  EXPECT_EQ(noisy(estimator_thresholds().noise_ratio * 2.2, 1), 0);
}

}  // namespace
}  // namespace secular
