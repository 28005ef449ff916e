// Acceleration of a fixed-point iteration.
#include "numerics/anderson_acceleration.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

namespace secular {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// x = g(x) = A x + c with eigenvalues 0.95, 0.3 and -1.4: one direction creeps, one runs away. An affine map of n
// components is solved after n + 1 values.
TEST(AndersonAcceleration, SolvesAnAffineMapThatDoesNotContract) {
  Eigen::Matrix3d turn;
  turn << 1, 2, 0, 0, 1, 1, 1, 0, 1;
  const Eigen::Matrix3d a = turn * Vector3d(0.95, 0.3, -1.4).asDiagonal() * turn.inverse();
  const Vector3d solution(1, -2, 3), c = solution - a * solution;
  AndersonAcceleration acceleration(5, 1e-3);
  VectorXd x = Vector3d::Zero();
  for (int step = 0; step < 4; ++step) x = acceleration.next(x, a * x + c, Vector3d::Ones());
  EXPECT_LT((x - solution).norm(), 1e-8);
  VectorXd plain = Vector3d::Zero();
  for (int step = 0; step < 4; ++step) plain = a * plain + c;
  EXPECT_GT((plain - solution).norm(), 1);
}

TEST(AndersonAcceleration, TakesTheFirstValueAsItIsAndStaysAtAFixedPoint) {
  AndersonAcceleration acceleration(3, 1e-3);
  const VectorXd x = Vector3d(1, 2, 3), value = Vector3d(2, 2, 2), weight = Vector3d::Ones();
  EXPECT_EQ(acceleration.next(x, value, weight), value);
  EXPECT_EQ(acceleration.next(value, value, weight), value);
}

// A map that expands in two directions of five: repeating it runs away, and after as many steps as there are
// directions the accelerated steps know all of it.
TEST(AndersonAcceleration, FindsTheFixedPointOfALinearMapThatExpands) {
  VectorXd rates(5);
  rates << -2.5, 1.4, 0.9, 0.3, -0.1;
  const MatrixXd turn = Eigen::HouseholderQR<MatrixXd>(MatrixXd::Random(5, 5)).householderQ();
  const MatrixXd map = turn * rates.asDiagonal() * turn.transpose();
  const VectorXd goal = VectorXd::LinSpaced(5, -1, 2);
  const auto value = [&](const VectorXd& x) -> VectorXd { return goal + map * (x - goal); };
  AndersonAcceleration acceleration(8, 1e-8);
  VectorXd x = VectorXd::Zero(5);
  for (int i = 0; i < 12; ++i) x = acceleration.next(x, value(x));
  EXPECT_LT((x - goal).norm(), 1e-8);
}

}  // namespace
}  // namespace secular
