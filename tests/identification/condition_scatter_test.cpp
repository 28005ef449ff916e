// Error bars from the scatter between conditions.
#include "estimator/identification/condition_scatter.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <vector>

#include "numerics/confidence.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Rows of a regression by condition, in orthonormal coordinates, as a case's own estimate leaves them.
RowsByCondition rows_of(const std::vector<MatrixXd>& design, const std::vector<VectorXd>& response) {
  Index count = 0;
  for (const VectorXd& y : response) count += y.size();
  MatrixXd x(count, design.front().cols());
  VectorXd y(count);
  Index at = 0;
  for (std::size_t g = 0; g < design.size(); ++g) {
    x.middleRows(at, response[g].size()) = design[g];
    y.segment(at, response[g].size()) = response[g];
    at += response[g].size();
  }
  const Eigen::HouseholderQR<MatrixXd> qr(x);
  const MatrixXd q = qr.householderQ() * MatrixXd::Identity(count, x.cols());
  RowsByCondition rows;
  rows.entries = q.transpose() * x;
  rows.others.resize(x.cols(), 0);
  rows.reference = VectorXd::Zero(x.cols());
  rows.estimate = q.transpose() * y;
  rows.kept = MatrixXd::Identity(x.cols(), x.cols());
  const VectorXd residual = y - q * rows.estimate;
  rows.residual_sd = std::sqrt(residual.squaredNorm() / static_cast<double>(count - x.cols()));
  double squares = 0;
  at = 0;
  for (const VectorXd& part : response) {
    const MatrixXd here = q.middleRows(at, part.size());
    rows.gram.push_back(here.transpose() * here);
    const auto left = residual.segment(at, part.size());
    rows.score.push_back(here.transpose() * left);
    squares += (left.array() - left.mean()).square().sum();
    rows.repeat_freedom += static_cast<double>(part.size()) - 1;
    at += part.size();
  }
  rows.repeat_variance = squares / rows.repeat_freedom;
  return rows;
}

CommonFit fit_of(const RowsByCondition& rows, const MatrixXd& slope) {
  const MatrixXd design = rows.entries * slope;
  const VectorXd unknowns = design.colPivHouseholderQr().solve(rows.estimate);
  return {&rows, slope, slope * unknowns};
}

// As many rows in every condition: the scatter of the conditions' means, with one degree of freedom less than there
// are conditions, but for the part that repeats tell.
TEST(ConditionScatter, OfAMeanIsThatOfTheMeansOfConditions) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  const int conditions = 7, each = 4;
  std::vector<MatrixXd> design;
  std::vector<VectorXd> response;
  VectorXd means(conditions);
  for (int g = 0; g < conditions; ++g) {
    VectorXd y = VectorXd::Constant(each, normal(random));
    for (double& value : y) value += 0.3 * normal(random);
    means(g) = y.mean();
    design.emplace_back(MatrixXd::Ones(each, 1));
    response.push_back(y);
  }
  const RowsByCondition rows = rows_of(design, response);
  const std::vector<CommonFit> cases{fit_of(rows, MatrixXd::Identity(1, 1))};
  const auto scatter = condition_scatter(cases, MatrixXd(0, 1), MatrixXd::Identity(1, 1));
  ASSERT_TRUE(scatter);
  const double expected = (means.array() - means.mean()).square().sum() / (conditions - 1) / conditions;
  EXPECT_NEAR(scatter->covariance(0, 0), expected, 1e-12 * expected);
  const double repeats = rows.repeat_variance / (conditions * each);
  ASSERT_LT(repeats, expected);
  const double part = std::pow(repeats / expected, 2);
  EXPECT_NEAR(scatter->degrees_of_freedom(0),
              1 / (part / (conditions * (each - 1)) + (1 - part) / (conditions - 1)), 1e-9);
}

// Two unknowns of a case with six coefficients, conditions of very different weight, with and without an error that
// a condition's rows share: the 95 % intervals hold. Of 2000 draws the share is within three standard deviations of
// 0.95 where that error is large. Where repeats tell most of the variance, which is then never taken for less, that
// is not the law of one chi-squared: 0.945 to 0.968 for eight degrees of freedom.
TEST(ConditionScatter, IntervalsHoldWithUnequalConditions) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  const int conditions = 12, each = 5, columns = 6, draws = 2000;
  std::vector<MatrixXd> design;
  for (int g = 0; g < conditions; ++g) {
    MatrixXd x(1, columns);
    for (Index c = 0; c < columns; ++c) x(0, c) = normal(random) * (g < 3 ? 3 : 1);
    design.emplace_back(x.replicate(each, 1));
  }
  MatrixXd slope(columns, 2);
  for (Index r = 0; r < columns; ++r)
    for (Index c = 0; c < 2; ++c) slope(r, c) = normal(random);
  const VectorXd truth{{0.7, -1.3}};
  for (const double shared : {0.0, 0.3, 1.0, 4.0}) {
    int inside = 0;
    for (int draw = 0; draw < draws; ++draw) {
      std::vector<VectorXd> response;
      for (const MatrixXd& x : design) {
        VectorXd y = x * (slope * truth) + VectorXd::Constant(each, shared * normal(random));
        for (double& value : y) value += normal(random);
        response.push_back(y);
      }
      const RowsByCondition rows = rows_of(design, response);
      const std::vector<CommonFit> cases{fit_of(rows, slope)};
      const auto scatter = condition_scatter(cases, MatrixXd(0, 2), MatrixXd::Identity(2, 2));
      ASSERT_TRUE(scatter);
      const VectorXd found = slope.colPivHouseholderQr().solve(cases.front().values);
      const Interval interval =
          confidence_interval(found(0), std::sqrt(scatter->covariance(0, 0)), scatter->degrees_of_freedom(0));
      inside += interval.low <= truth(0) && truth(0) <= interval.high;
    }
    const double share = static_cast<double>(inside) / draws;
    EXPECT_GE(share, 0.945 - 0.015) << "shared " << shared;
    EXPECT_LE(share, 0.968 + 0.012) << "shared " << shared;
  }
}

}  // namespace
}  // namespace secular
