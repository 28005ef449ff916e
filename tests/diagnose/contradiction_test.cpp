// Given numbers against linear data, where everything can be said in closed form.
#include "diagnose/inference/contradiction.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double nothing_said = std::numeric_limits<double>::infinity();

// Rows = design * unknowns - data.
struct Linear {
  MatrixXd design = MatrixXd(30, 3);
  VectorXd data = VectorXd(30);

  explicit Linear(unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    for (Index i = 0; i < design.rows(); ++i) {
      for (Index j = 0; j < 3; ++j) design(i, j) = normal(random);
      design(i, 1) += 0.8 * design(i, 0);
      data(i) = design.row(i).dot(truth()) + normal(random);
    }
  }
  static VectorXd truth() { return Eigen::Vector3d(2, -1, 0.5); }

  double chi_squared(const VectorXd& unknowns) const { return (design * unknowns - data).squaredNorm(); }

  Refit fit() const {
    Refit f;
    f.unknowns = design.colPivHouseholderQr().solve(data);
    f.free = {0, 1, 2};
    f.scale = Eigen::Vector3d(1e-3, 1, 40);  // of no consequence
    f.jacobian = design * f.scale.asDiagonal();
    return f;
  }
};

TEST(Contradiction, OfExactNumbersIsTheFallOfChiSquared) {
  const Linear linear(1);
  const VectorXd given = Eigen::Vector3d(2.3, -1.4, 0.2);
  const Contradiction found = contradiction(linear.fit(), given, VectorXd::Zero(3));
  EXPECT_EQ(found.rank, 3);
  EXPECT_NEAR(found.chi_squared, linear.chi_squared(given) - linear.chi_squared(linear.fit().unknowns), 1e-9);
}

TEST(Contradiction, LeavesOpenWhatNothingWasSaidOf) {
  const Linear linear(2);
  const VectorXd given = Eigen::Vector3d(2.3, 1e6, 0.2);
  const Contradiction found = contradiction(linear.fit(), given, Eigen::Vector3d(0, nothing_said, 0));
  EXPECT_EQ(found.rank, 2);
  VectorXd best = given;
  const VectorXd rest = linear.data - linear.design.col(0) * given(0) - linear.design.col(2) * given(2);
  best(1) = linear.design.col(1).dot(rest) / linear.design.col(1).squaredNorm();
  EXPECT_NEAR(found.chi_squared, linear.chi_squared(best) - linear.chi_squared(linear.fit().unknowns), 1e-6);
  EXPECT_EQ(contradiction(linear.fit(), given, VectorXd::Constant(3, nothing_said)).rank, 0);
}

// Numbers that are off by their error bars, and data by their noise: chi-squared on three degrees of freedom. Mean
// and variance of 400 draws within 4 standard deviations.
TEST(Contradiction, FollowsItsLaw) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  const Eigen::Vector3d sd(0.3, 0.02, 5);
  constexpr int draws = 400;
  double sum = 0, squares = 0;
  for (unsigned i = 0; i < draws; ++i) {
    const Linear linear(100 + i);
    VectorXd given = Linear::truth();
    for (Index p = 0; p < 3; ++p) given(p) += sd(p) * normal(random);
    const double x = contradiction(linear.fit(), given, sd).chi_squared;
    sum += x;
    squares += x * x;
  }
  const double mean = sum / draws, variance = squares / draws - mean * mean;
  EXPECT_NEAR(mean, 3, 4 * std::sqrt(6.0 / draws));
  EXPECT_NEAR(variance, 6, 4 * std::sqrt((12.0 * 3 * (3 + 4) - 36) / draws));  // fourth central moment 12 k (k + 4)
}

TEST(Contradiction, NeedsANumberForEachUnknown) {
  EXPECT_THROW(contradiction(Linear(1).fit(), VectorXd::Zero(2), VectorXd::Zero(3)), std::invalid_argument);
}

}  // namespace
}  // namespace secular
