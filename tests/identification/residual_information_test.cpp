// What rows say, beside the coefficients, of a known change of the response.
#include "estimator/identification/residual_information.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <vector>

#include "motion/simulate/noise.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index conditions = 20, repeats = 6, rows = conditions * repeats;

// Conditions at levels between 0 and 1; coefficients of 1, x, x^2, and changes as x^3 and x^4.
struct Regression {
  MatrixXd design{rows, 3}, change{rows, 2};
  std::vector<int> condition;

  Regression() {
    for (Index r = 0; r < rows; ++r) {
      const Index c = r / repeats;
      const double x = static_cast<double>(c) / (conditions - 1);
      design.row(r) << 1, x, x * x;
      change.row(r) << x * x * x, x * x * x * x;
      condition.push_back(static_cast<int>(c));
    }
  }

  // The response of a step along the null space, as a change that was not taken out; noise of the rows and of whole
  // conditions.
  LinearFit fitted(const VectorXd& null_coordinate, double noise_sd, double condition_sd,
                   std::uint64_t seed) const {
    VectorXd response = design * VectorXd::LinSpaced(3, 1, 3) - change * null_coordinate;
    NoiseStream noise(seed, 0, 0);
    for (Index c = 0; c < conditions; ++c) {
      const double common = condition_sd * noise.gaussian();
      for (Index i = 0; i < repeats; ++i) response(c * repeats + i) += common + noise_sd * noise.gaussian();
    }
    return linear_fit(design, response, condition);
  }
};

// Mean square of what is left of the evidence at the true null-space coordinate, by its rows: one if its errors are
// what it says.
double mean_square_at_truth(double noise_sd, double condition_sd) {
  const Regression regression;
  const VectorXd null_coordinate = (VectorXd(2) << 0.7, -0.4).finished();
  double sum = 0, count = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    const ResidualInformation evidence = residual_information(
        regression.change, regression.fitted(null_coordinate, noise_sd, condition_sd, seed), regression.condition);
    sum += (evidence.design * null_coordinate - evidence.target).squaredNorm();
    count += static_cast<double>(evidence.target.size());
  }
  EXPECT_GT(count, 300);
  return sum / count;
}

TEST(ResidualInformation, FindsTheShiftOfRowsWithoutNoise) {
  const Regression regression;
  const VectorXd null_coordinate = (VectorXd(2) << 0.7, -0.4).finished();
  const ResidualInformation evidence =
      residual_information(regression.change, regression.fitted(null_coordinate, 1e-9, 0, 1), regression.condition);
  ASSERT_EQ(evidence.design.rows(), 2);
  const VectorXd found = evidence.design.fullPivLu().solve(evidence.target);
  EXPECT_NEAR(found(0), null_coordinate(0), 1e-5);
  EXPECT_NEAR(found(1), null_coordinate(1), 1e-5);
}

// Errors are never said to be smaller than they are, nor twice as large: the larger one of two estimates of them,
// one of which leaves out a condition at a time, is above one.
TEST(ResidualInformation, ErrorsAreThoseOfTheNoiseOrOfTheConditions) {
  for (const auto& [noise, condition] : {std::pair(1e-4, 0.0), std::pair(1e-4, 5e-4)}) {
    const double square = mean_square_at_truth(noise, condition);
    EXPECT_LT(square, 1.15) << condition;
    EXPECT_GT(square, 0.25) << condition;
  }
}

TEST(ResidualInformation, SaysNothingWhereItKnowsNothing) {
  const Regression regression;
  const LinearFit fit = regression.fitted(VectorXd::Zero(2), 1e-4, 0, 1);
  // What coefficients can do as well.
  EXPECT_EQ(residual_information(regression.design.leftCols(2), fit, regression.condition).target.size(), 0);
  // Noise far above what the change does.
  EXPECT_EQ(residual_information(1e-6 * regression.change, fit, regression.condition).target.size(), 0);
  // Too few conditions to see how they differ.
  std::vector<int> few = regression.condition;
  for (int& c : few) c /= 4;
  EXPECT_EQ(residual_information(regression.change, fit, few).target.size(), 0);
}

}  // namespace
}  // namespace secular
