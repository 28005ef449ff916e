#include "diagnose/evidence/error_directions.hpp"

#include <gtest/gtest.h>

#include "tests/signal/gaussian.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr Index error_samples = 40;

MatrixXd random_columns(Index count, std::uint64_t seed) {
  testing_support::Gaussian gaussian(seed);
  MatrixXd columns(error_samples, count);
  for (Index c = 0; c < count; ++c) columns.col(c) = gaussian.vector(error_samples);
  return columns;
}

double off_identity(const MatrixXd& columns) {
  return (columns.transpose() * columns - MatrixXd::Identity(columns.cols(), columns.cols())).norm();
}

TEST(ErrorDirections, SpanWhatColumnsAddInTheirOrder) {
  const MatrixXd foreign = random_columns(3, 1), state = random_columns(2, 2), change = random_columns(2, 3);
  const ErrorDirections directions(foreign, state, change);
  MatrixXd all(error_samples, 7);
  all << directions.of_state, directions.of_change;
  EXPECT_LT(off_identity(all), 1e-13);
  EXPECT_EQ(directions.count(), 7);
  EXPECT_EQ(directions.of_motion(), all.rightCols(4));
  // Foreign content alone in the first ones, and nothing of all columns beyond all directions.
  const MatrixXd first = directions.of_state.leftCols(directions.foreign);
  EXPECT_LT((foreign - first * (first.transpose() * foreign)).norm(), 1e-13 * foreign.norm());
  for (const MatrixXd& columns : {foreign, state, change})
    EXPECT_LT((columns - all * (all.transpose() * columns)).norm(), 1e-13 * columns.norm());
}

// A channel that sees nothing of a change, or a state that does what foreign content does: no direction of
// rounding.
TEST(ErrorDirections, AreZeroWhereAColumnAddsNothing) {
  const MatrixXd basis = orthonormal_beyond(MatrixXd(), random_columns(3, 1));
  MatrixXd columns(error_samples, 3);
  columns << MatrixXd::Zero(error_samples, 1), basis * Eigen::Vector3d(1, -2, 0.5), random_columns(1, 2);
  const MatrixXd added = orthonormal_beyond(basis, columns);
  EXPECT_TRUE(added.leftCols(2).isZero(0));
  EXPECT_NEAR(added.col(2).norm(), 1, 1e-14);
}

// Nearly the same columns, as those of two close modes: orthonormal all the same.
TEST(ErrorDirections, StayOrthonormalWhereColumnsAreNearlyAlike) {
  MatrixXd columns = random_columns(3, 4);
  columns.col(1) = columns.col(0) + 1e-7 * columns.col(1);
  columns.col(2) = columns.col(0) - 1e-7 * columns.col(2);
  EXPECT_LT(off_identity(orthonormal_beyond(MatrixXd(), columns)), 1e-12);
}

}  // namespace
}  // namespace secular
