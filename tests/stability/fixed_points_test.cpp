#include "motion/response/fixed_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "fields.hpp"

namespace secular {
namespace {

using namespace testing_support;
using Eigen::Index;
using Eigen::VectorXd;

FixedPointOptions box(Index dimension, double half) {
  FixedPointOptions options;
  options.lower = VectorXd::Constant(dimension, -half);
  options.upper = VectorXd::Constant(dimension, half);
  return options;
}

TEST(FixedPoints, ThreeOfADuffingOscillator) {
  // s (mu^2 + (sigma - c s)^2) = f^2 with s = 1, 2, 3: c = 1, sigma = 3, mu^2 = 11 - 9 = 2, f^2 = 6.
  const VectorField field = duffing();
  const VectorXd p = vector({std::sqrt(2.0), 3, 1, std::sqrt(6.0)});
  const FixedPoints found = find_fixed_points(field, p, box(2, 10));
  EXPECT_EQ(found.status, FixedPointStatus::nothing_new);
  ASSERT_EQ(found.points.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(found.points[i].state.squaredNorm(), static_cast<double>(i + 1), 1e-11);
    EXPECT_EQ(found.points[i].unstable, i == 1 ? 1 : 0);
    EXPECT_LT(found.points[i].residual, 1e-12);
  }
}

TEST(FixedPoints, SmallOnesInALargeBox) {
  // x' = x (x^2 - 1e-6) (x^2 - 1): +-1e-3 beside +-1 in a box of +-100.
  const VectorField field(1, {}, [](const ConstVector& x, const ConstVector&, OutVector rate) {
    const double s = x(0) * x(0);
    rate(0) = x(0) * (s - 1e-6) * (s - 1);
  });
  FixedPointOptions options = box(1, 100);
  options.distinct = 1e-7;
  const FixedPoints found = find_fixed_points(field, VectorXd(0), options);
  ASSERT_EQ(found.points.size(), 5u);
  EXPECT_NEAR(std::abs(found.points[1].state(0)), 1e-3, 1e-12);
  EXPECT_NEAR(std::abs(found.points[3].state(0)), 1, 1e-12);
}

TEST(FixedPoints, EightyOneOfFourUncoupledCubics) {
  const VectorField field(4, {}, [](const ConstVector& x, const ConstVector&, OutVector rate) {
    for (Index i = 0; i < 4; ++i) rate(i) = x(i) - x(i) * x(i) * x(i);
  });
  FixedPointOptions options = box(4, 2);
  EXPECT_EQ(find_fixed_points(field, VectorXd(0), options).points.size(), 81u);
  options.root_limit = 10;
  const FixedPoints limited = find_fixed_points(field, VectorXd(0), options);
  EXPECT_EQ(limited.status, FixedPointStatus::root_limit);
  EXPECT_EQ(limited.points.size(), 10u);
}

TEST(FixedPoints, OfAParametricResonance) {
  const Parametric model;
  const double sigma = 1, f = 0.9 * model.threshold(sigma);
  // Between the saddle-node and the threshold: 0 and two pairs.
  ASSERT_GT(f, model.forcing(model.fold_square(sigma), sigma));
  const FixedPoints found = find_fixed_points(model.field(), vector({sigma, f}), box(2, 5));
  ASSERT_EQ(found.points.size(), 5u);
  EXPECT_EQ(found.points[0].state.norm(), 0);
  for (std::size_t i = 1; i < 5; ++i) {
    EXPECT_NEAR(model.forcing(found.points[i].state.squaredNorm(), sigma), f, 1e-12);
    EXPECT_EQ(found.points[i].unstable, i < 3 ? 1 : 0);
  }
}

TEST(FixedPoints, SameInputSameOutput) {
  const Parametric model;
  const FixedPoints a = find_fixed_points(model.field(), vector({1, 0.6}), box(2, 5));
  const FixedPoints b = find_fixed_points(model.field(), vector({1, 0.6}), box(2, 5));
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i) EXPECT_EQ(a.points[i].state, b.points[i].state);
}

TEST(FixedPoints, MisuseIsRefused) {
  EXPECT_THROW(find_fixed_points(duffing(), vector({1, 1, 1, 1}), box(1, 1)), std::invalid_argument);
  EXPECT_THROW(find_fixed_points(duffing(), vector({1, 1, 1, 1}), box(2, -1)), std::invalid_argument);
}

}  // namespace
}  // namespace secular
