// Acceleration of a fixed-point iteration.
#include "estimator/identification/fixed_point.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

namespace secular {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

// x = g(x) = A x + c with eigenvalues 0.95, 0.3 and -1.4: one direction creeps, one runs away. An affine map of n
// components is solved after n + 1 values.
TEST(AndersonAcceleration, SolvesAnAffineMapThatDoesNotContract) {
  Eigen::Matrix3d turn;
  turn << 1, 2, 0, 0, 1, 1, 1, 0, 1;
  const Eigen::Matrix3d a = turn * Vector3d(0.95, 0.3, -1.4).asDiagonal() * turn.inverse();
  const Vector3d solution(1, -2, 3), c = solution - a * solution;
  AndersonAcceleration acceleration(5);
  VectorXd x = Vector3d::Zero();
  for (int step = 0; step < 4; ++step) x = acceleration.next(x, a * x + c, Vector3d::Ones());
  EXPECT_LT((x - solution).norm(), 1e-8);
  VectorXd plain = Vector3d::Zero();
  for (int step = 0; step < 4; ++step) plain = a * plain + c;
  EXPECT_GT((plain - solution).norm(), 1);
}

TEST(AndersonAcceleration, TakesTheFirstValueAsItIsAndStaysAtAFixedPoint) {
  AndersonAcceleration acceleration(3);
  const VectorXd x = Vector3d(1, 2, 3), value = Vector3d(2, 2, 2), weight = Vector3d::Ones();
  EXPECT_EQ(acceleration.next(x, value, weight), value);
  EXPECT_EQ(acceleration.next(value, value, weight), value);
}

}  // namespace
}  // namespace secular
