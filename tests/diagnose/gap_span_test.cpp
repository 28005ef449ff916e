// Shares of a gap along the directions in which explanations move the rows.
#include "diagnose/inference/gap_span.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "diagnose/inference/held_out.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd white(Index rows, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return VectorXd::NullaryExpr(rows, [&] { return normal(random); });
}

MatrixXd columns_of(Index rows, Index count, std::mt19937_64& random) {
  MatrixXd columns(rows, count);
  for (Index c = 0; c < count; ++c) columns.col(c) = white(rows, random);
  return columns;
}

std::vector<RowLabel> in_conditions(Index rows, Index conditions) {
  std::vector<RowLabel> labels(static_cast<std::size_t>(rows));
  for (std::size_t r = 0; r < labels.size(); ++r)
    labels[r].fold = static_cast<int>(static_cast<Index>(r) * conditions / rows);
  return labels;
}

// Squares along the directions, and one for each that is beside them.
double squares_of(const GapSpan& span, const VectorXd& rows) {
  return span.squares(rows, 1).sum();
}

TEST(GapSpan, SquaresOfRowsAddUpToThoseAlongItsDirections) {
  std::mt19937_64 random(3);
  MatrixXd columns = columns_of(60, 4, random);
  columns.col(3) = 2 * columns.col(0) - columns.col(1);
  const VectorXd rows = white(60, random);
  const GapSpan span(columns);
  const VectorXd along = columns.leftCols(3) * columns.leftCols(3).colPivHouseholderQr().solve(rows);
  EXPECT_NEAR(squares_of(span, rows), along.squaredNorm() + 57, 1e-10);
  EXPECT_NEAR(squares_of(span, along), along.squaredNorm() + 57, 1e-10);
  EXPECT_NEAR(span.squares(rows, 2).sum(), along.squaredNorm() + 4 * 57, 1e-10);
}

TEST(GapSpan, WithAColumnHoldsThatToo) {
  std::mt19937_64 random(7);
  const MatrixXd columns = columns_of(60, 4, random);
  const GapSpan three(columns.leftCols(3)), four = three.with(columns.col(3));
  const VectorXd zero = VectorXd::Zero(60);
  EXPECT_NEAR(squares_of(four, columns.col(3)), columns.col(3).squaredNorm() + 56, 1e-10);
  EXPECT_NEAR(squares_of(three.with(columns.col(1)), zero), 57, 1e-10);
  EXPECT_NEAR(squares_of(three.with(zero), zero), 57, 1e-10);
  EXPECT_EQ(squares_of(GapSpan().with(columns.col(0)), zero), 0);
}

TEST(GapSpan, OfNoColumnsIsAllRowsAsTheyAre) {
  std::mt19937_64 random(4);
  const VectorXd rows = white(10, random);
  EXPECT_EQ(GapSpan().squares(rows, 1), VectorXd(rows.cwiseAbs2()));
}

TEST(GapSpan, HoldsNotWhatLiesBesideIt) {
  std::mt19937_64 random(5);
  const MatrixXd columns = columns_of(400, 6, random);
  const GapSpan span(columns.leftCols(5));
  const VectorXd noise = white(400, random);
  EXPECT_TRUE(span.holds_all_but_noise(noise));
  EXPECT_TRUE(span.holds_all_but_noise(noise + 20 * columns.col(2)));
  EXPECT_FALSE(span.holds_all_but_noise(noise + columns.col(5)));
}

// A gap of 15 standard deviations in all, seen in ten conditions of 20,000 samples: an explanation that takes all
// of it has closed it, and one that takes 15 % of its size has not, whatever the noise. By all rows the noise
// decides.
TEST(GapSpan, AWeakGapInManySamplesHasAShare) {
  constexpr Index samples = 20000, directions = 20, draws = 25;
  std::mt19937_64 random(6);
  const std::vector<RowLabel> labels = in_conditions(samples, 10);
  const MatrixXd columns = columns_of(samples, directions, random);
  const VectorXd gap = 15 * columns.col(0).normalized();
  const GapSpan span(columns);
  Index all_closed = 0, part_closed = 0;
  double least = 1, most = -1;
  for (Index d = 0; d < draws; ++d) {
    const VectorXd noise = white(samples, random);
    const ClosedShare all = closed_share(noise + gap, noise, labels, 1, span),
                      part = closed_share(noise + gap, noise + 0.85 * gap, labels, 1, span),
                      of_rows = closed_share(noise + gap, noise, labels, 1);
    if (all.closed > 0.8 && all.low > 0.5) ++all_closed;
    if (part.closed > 0.5) ++part_closed;
    const double unbounded = (of_rows.before - of_rows.after) / (of_rows.before - 1);
    least = std::min(least, unbounded);
    most = std::max(most, unbounded);
  }
  EXPECT_GE(all_closed, draws - 1);
  EXPECT_EQ(part_closed, 0);
  EXPECT_TRUE(least < 0.5 || most > 1.5) << least << " to " << most;
}

}  // namespace
}  // namespace secular
