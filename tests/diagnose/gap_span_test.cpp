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
  return span.squares(rows, in_conditions(rows.size(), 1), 1).sum();
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
  EXPECT_NEAR(span.squares(rows, in_conditions(60, 1), 2).sum(), along.squaredNorm() + 4 * 57, 1e-10);
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
  EXPECT_EQ(GapSpan().squares(rows, in_conditions(10, 1), 1), VectorXd(rows.cwiseAbs2()));
}

// Beside the directions rows have what they have, or what they are expected to have where that is more.
TEST(GapSpan, WhatLiesBesideItIsLeft) {
  std::mt19937_64 random(5);
  const MatrixXd columns = columns_of(400, 6, random);
  const GapSpan span(columns.leftCols(5));
  const VectorXd noise = white(400, random), more = noise + columns.col(5);
  EXPECT_EQ(squares_of(span, more), more.squaredNorm());
  const VectorXd less = 0.9 * noise;
  EXPECT_GT(squares_of(span, less), less.squaredNorm());
  EXPECT_GE(squares_of(span, less), 395);
}

// A gap of 30 standard deviations in all, seen in ten conditions of 20,000 samples, whose noise alone has 200: an
// explanation that takes all of it has closed most of it, and one that takes 15 % of its size has not. By all rows
// the noise decides.
TEST(GapSpan, AWeakGapInManySamplesHasAShare) {
  constexpr Index samples = 20000, directions = 20, draws = 25;
  std::mt19937_64 random(6);
  const std::vector<RowLabel> labels = in_conditions(samples, 10);
  const MatrixXd columns = columns_of(samples, directions, random);
  const VectorXd gap = 30 * columns.col(0).normalized();
  const GapSpan span(columns);
  Index all_closed = 0, part_closed = 0;
  double most = -1;
  for (Index d = 0; d < draws; ++d) {
    const VectorXd noise = white(samples, random);
    const ClosedShare all = closed_share(noise + gap, noise, labels, 1, span),
                      part = closed_share(noise + gap, noise + 0.85 * gap, labels, 1, span),
                      of_rows = closed_share(noise + gap, noise, labels, 1);
    if (all.closed > 0.65 && all.low > 0.5) ++all_closed;
    if (part.closed > 0.5) ++part_closed;
    most = std::max(most, (of_rows.before - of_rows.after) / (of_rows.before - 1));
  }
  EXPECT_GE(all_closed, draws - 1);
  EXPECT_EQ(part_closed, 0);
  EXPECT_GT(most, 1.25);
}

// Rows that nothing moves say nothing of a gap. Three quarters are closed, in ten conditions and in these with
// thirty more that are noise alone; 0.4 sqrt(2 1000) squares beside the directions are left by chance in the mean,
// of 225. As they are the quiet rows would bring 0.4 sqrt(2 31000) and close half.
TEST(GapSpan, QuietRowsNeitherCloseNorDilute) {
  constexpr Index loud = 1000, quiet = 30000, directions = 5, draws = 30;
  std::mt19937_64 random(9);
  MatrixXd columns = MatrixXd::Zero(loud + quiet, directions);
  columns.topRows(loud) = columns_of(loud, directions, random);
  const VectorXd gap = 15 * columns.col(0).normalized();
  std::vector<RowLabel> labels = in_conditions(loud, 10);
  for (RowLabel label : in_conditions(quiet, 30)) {
    label.fold += 10;
    labels.push_back(label);
  }
  const std::vector<RowLabel> labels_of_loud(labels.begin(), labels.begin() + loud);
  const GapSpan span(columns), span_of_loud(columns.topRows(loud));
  double mean = 0, squares = 0;
  for (Index d = 0; d < draws; ++d) {
    const VectorXd noise = white(loud + quiet, random), before = noise + gap, after = noise + 0.5 * gap;
    const double all = closed_share(before, after, labels, 1, span).closed,
                 alone = closed_share(before.head(loud), after.head(loud), labels_of_loud, 1, span_of_loud).closed;
    EXPECT_NEAR(all, alone, 0.06);
    mean += all / draws;
    squares += (all - 0.75) * (all - 0.75) / draws;
  }
  EXPECT_NEAR(mean, 0.72, 0.03);
  EXPECT_LT(std::sqrt(squares), 0.1);
}

// A law in rows that no explanation moves is left whole: 5000 squares of it in three quiet conditions, beside 225
// of which three quarters are closed. Noise that is judged too large there, by 3 % of its variance, hides no law
// that the loud rows show (300 squares beside the directions), and closes nothing.
TEST(GapSpan, ALawInQuietRowsIsLeftAndADeficitTakesNothingOff) {
  constexpr Index loud = 1000, quiet = 30000;
  std::mt19937_64 random(10);
  MatrixXd columns = MatrixXd::Zero(loud + quiet, 5);
  columns.topRows(loud) = columns_of(loud, 5, random);
  const GapSpan span(columns);
  const VectorXd gap = 15 * columns.col(0).normalized();
  std::vector<RowLabel> labels = in_conditions(loud, 10);
  for (RowLabel label : in_conditions(quiet, 30)) {
    label.fold += 10;
    labels.push_back(label);
  }
  VectorXd law = VectorXd::Zero(loud + quiet), shown = law;
  law.segment(loud, quiet / 10) = white(quiet / 10, random);
  law *= std::sqrt(5000.0) / law.norm();
  shown.head(loud) = white(loud, random);
  shown *= std::sqrt(300.0) / shown.norm();
  for (int draw = 0; draw < 20; ++draw) {
    const VectorXd noise = white(loud + quiet, random);
    EXPECT_LT(closed_share(noise + gap + law, noise + 0.5 * gap + law, labels, 1, span).closed, 0.06);
    VectorXd quieter = noise;
    quieter.tail(quiet) *= std::sqrt(0.97);
    // 169 of 525, give or take the noise of the loud rows.
    EXPECT_NEAR(closed_share(quieter + gap + shown, quieter + 0.5 * gap + shown, labels, 1, span).closed, 0.32,
                0.15);
  }
}

// Of a gap of a law that lies beside all directions, but for a fifth of its squares, that fifth closes little,
// though noise alone leaves as much as all of it once in a thousand times.
TEST(GapSpan, ALawBesideItIsNotClosedByOneThatIsInIt) {
  constexpr Index samples = 4000, directions = 20, draws = 40;
  std::mt19937_64 random(8);
  const std::vector<RowLabel> labels = in_conditions(samples, 16);
  const MatrixXd columns = columns_of(samples, directions + 1, random);
  const VectorXd inside = columns.col(0).normalized(), beside = columns.col(directions).normalized();
  const GapSpan span(columns.leftCols(directions));
  Index closed = 0;
  for (Index d = 0; d < draws; ++d) {
    const VectorXd left = white(samples, random) + std::sqrt(0.8 * 300) * beside;
    const ClosedShare share = closed_share(left + std::sqrt(0.2 * 300) * inside, left, labels, 1, span);
    if (share.closed > 0.5 && share.low > 0.5) ++closed;
  }
  EXPECT_LE(closed, 2);
}

}  // namespace
}  // namespace secular
