// Rows condensed to a few with the same sum of squares for every vector of coefficients.
#include "estimator/regression/condensed_rows.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "estimator/regression/linear_fit.hpp"
#include "motion/simulate/noise.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd random_matrix(Index rows, Index columns, std::uint64_t seed) {
  NoiseStream noise(seed, 0, 0);
  MatrixXd result(rows, columns);
  for (Index i = 0; i < result.size(); ++i) result.data()[i] = noise.gaussian();
  return result;
}

void expect_same_sums(const MatrixXd& design, const VectorXd& response, double tolerance) {
  const CondensedRows condensed = condensed_rows(design, response);
  ASSERT_EQ(condensed.design.rows(), design.cols() + 1);
  EXPECT_EQ(condensed.design.bottomRows(1).cwiseAbs().maxCoeff(), 0);
  for (std::uint64_t trial = 0; trial < 5; ++trial) {
    const VectorXd b = random_matrix(design.cols(), 1, 100 + trial);
    const double whole = (design * b - response).squaredNorm();
    EXPECT_NEAR((condensed.design * b - condensed.response).squaredNorm(), whole, tolerance * whole);
  }
}

TEST(CondensedRows, SumsOfSquaresAreTheSame) {
  MatrixXd design = random_matrix(200, 6, 1);
  design.col(2) *= 1e9;  // columns of very different size
  design.col(4) *= 1e-9;
  expect_same_sums(design, random_matrix(200, 1, 2), 1e-12);
}

TEST(CondensedRows, ExactlyDependentColumns) {
  MatrixXd design = random_matrix(200, 6, 1);
  design.col(5) = 2 * design.col(0) - 3 * design.col(1);
  expect_same_sums(design, random_matrix(200, 1, 2), 1e-12);
  const Eigen::JacobiSVD<MatrixXd> svd(condensed_rows(design, random_matrix(200, 1, 2)).design);
  EXPECT_LT(svd.singularValues()(5), 1e-12 * svd.singularValues()(0));
}

// Too near one another for a Gram matrix: its small singular value is of the size of rounding, the rows' is not.
TEST(CondensedRows, NearlyDependentColumnsKeepTheirDifference) {
  MatrixXd design = random_matrix(200, 4, 1);
  const VectorXd apart = random_matrix(200, 1, 3);
  design.col(3) = design.col(0) + 1e-9 * apart;
  expect_same_sums(design, random_matrix(200, 1, 2), 1e-12);
  const Eigen::JacobiSVD<MatrixXd> whole(design), small(condensed_rows(design, random_matrix(200, 1, 2)).design);
  EXPECT_NEAR(small.singularValues()(3) / whole.singularValues()(3), 1, 1e-5);
}

// y = 1 + 2 x with x measured with errors of a fifth of its spread, of which a third is also in y: least squares
// gives (2 s^2 + c)/(s^2 + e^2) for the slope, the correction 2.
TEST(StatisticalColumnErrors, AttenuationIsTakenOut) {
  constexpr Index rows = 4000;
  constexpr double error = 0.2, shared = 0.3;
  constexpr int draws = 40;
  double plain = 0, corrected = 0, square = 0, expected = 0;
  for (std::uint64_t draw = 0; draw < draws; ++draw) {
    NoiseStream noise(5, draw, 0);
    MatrixXd design(rows, 2);
    VectorXd response(rows);
    std::vector<int> cluster;
    for (Index i = 0; i < rows; ++i) {
      const double x = noise.gaussian(), e = error * noise.gaussian();
      design.row(i) << 1, x + e;
      response(i) = 1 + 2 * x + shared * e + 0.1 * noise.gaussian();
      cluster.push_back(static_cast<int>(i / 100));
    }
    ColumnErrors errors{MatrixXd::Zero(2, 2), VectorXd::Zero(2)};
    errors.gram(1, 1) = rows * error * error;
    errors.with_response(1) = rows * shared * error * error;
    plain += linear_fit(design, response, cluster).coefficients(1) / draws;
    const LinearFit fit = linear_fit(design, response, cluster, errors);
    corrected += fit.coefficients(1) / draws;
    square += std::pow(fit.coefficients(1) - 2, 2) / draws;
    expected += fit.covariance(1, 1) / draws;
  }
  const double sd_of_mean = std::sqrt(square / draws);
  EXPECT_NEAR(plain, (2 + shared * error * error) / (1 + error * error), 5 * sd_of_mean);
  EXPECT_NEAR(corrected, 2, 5 * sd_of_mean);
  EXPECT_LT(plain, 2 - 20 * sd_of_mean);
  // A mean of 40 squares of normals has a relative standard deviation of sqrt(2/40).
  EXPECT_NEAR(square / expected, 1, 4 * std::sqrt(2.0 / draws));
}

}  // namespace
}  // namespace secular
