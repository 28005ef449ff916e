// Do parts of the rows of a fit tell the same numbers?
#include "diagnose/inference/parts_of_rows.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <vector>

#include "numerics/distribution.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index parts_of_parabola = 6, rows_of_part = 50;

std::vector<int> parts_in_turn() {
  std::vector<int> part(static_cast<std::size_t>(parts_of_parabola * rows_of_part));
  for (std::size_t r = 0; r < part.size(); ++r) part[r] = static_cast<int>(r) / static_cast<int>(rows_of_part);
  return part;
}

// A parabola through rows of unit variance; in its last part the slope is another one by `other`.
Refit parabola(double other, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const Index count = parts_of_parabola * rows_of_part;
  MatrixXd columns(count, 3);
  VectorXd rows(count);
  for (Index i = 0; i < count; ++i) {
    const double x = static_cast<double>(i) / static_cast<double>(count) - 0.5;
    columns.row(i) << 1, x, 1e4 * x * x;
    rows(i) = normal(random) + (i >= count - rows_of_part ? other * x : 0);
  }
  Refit fit;
  const Eigen::HouseholderQR<MatrixXd> solver(columns);
  fit.rows = columns * VectorXd(solver.solve(rows)) - rows;
  fit.chi_squared = fit.rows.squaredNorm();
  fit.free = {0, 1, 2};
  fit.scale = VectorXd::Ones(3);
  fit.jacobian = columns;
  fit.rank = 3;
  return fit;
}

// Of 400 draws: the mean of chi-squared, and how many are above its 5 % point.
TEST(PartsOfRows, ThatShareTheirNumbersDifferAsNoiseDoes) {
  std::mt19937_64 random(3);
  constexpr int draws = 400;
  double sum = 0;
  int above = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const PartsAgreement found = agreement_of_parts(parabola(0, random), parts_in_turn());
    ASSERT_EQ(found.freedom, 3 * parts_of_parabola - 3);
    sum += found.chi_squared / found.freedom;
    above += found.p_value < 0.05;
  }
  const double freedom = 3 * parts_of_parabola - 3;
  EXPECT_NEAR(sum / draws, 1, 4 * std::sqrt(2 / freedom / draws));
  EXPECT_NEAR(above, 0.05 * draws, 4 * std::sqrt(0.05 * 0.95 * draws));
}

// What numbers of each part's own take off is what separate fits to the parts take off beyond the common one.
TEST(PartsOfRows, TakeOffWhatFitsOfTheirOwnTakeOff) {
  std::mt19937_64 random(5);
  const Refit fit = parabola(3, random);
  double apart = 0;
  for (Index part = 0; part < parts_of_parabola; ++part) {
    const MatrixXd own = fit.jacobian.middleRows(part * rows_of_part, rows_of_part);
    const VectorXd rows = fit.rows.segment(part * rows_of_part, rows_of_part);
    apart += (rows - own * VectorXd(own.colPivHouseholderQr().solve(rows))).squaredNorm();
  }
  const PartsAgreement found = agreement_of_parts(fit, parts_in_turn());
  EXPECT_NEAR(found.chi_squared, fit.chi_squared - apart, 1e-6 * fit.chi_squared);
}

TEST(PartsOfRows, ThatTellOtherNumbersAreSeenWhereAllRowsTogetherAreNot) {
  std::mt19937_64 random(7);
  const Refit fit = parabola(4, random);
  const PartsAgreement found = agreement_of_parts(fit, parts_in_turn());
  EXPECT_LT(found.p_value, 1e-3);
  EXPECT_GT(found.dispersion(), 1.5);
  EXPECT_GT(chi_squared_upper_tail(fit.chi_squared, static_cast<double>(fit.rows.size()) - 3), 1e-3);
}

TEST(PartsOfRows, OfOneRecordAreItsHalvesByWhatTheyTell) {
  std::mt19937_64 random(9);
  const Refit fit = parabola(0, random);
  std::vector<RowLabel> labels(static_cast<std::size_t>(fit.rows.size()));
  const std::vector<int> parts = parts_in_turn();
  for (std::size_t r = 0; r < labels.size(); ++r) labels[r].fold = parts[r];
  const std::vector<int> halves = large_parts(fit, labels);
  EXPECT_EQ(halves.front(), 0);
  EXPECT_EQ(halves.back(), 1);
  EXPECT_EQ(agreement_of_parts(fit, halves).freedom, 3);
  for (std::size_t r = labels.size() / 2; r < labels.size(); ++r) labels[r].record = 1;
  const std::vector<int> records = large_parts(fit, labels);
  EXPECT_EQ(records.front(), 0);
  EXPECT_EQ(records.back(), 1);
  EXPECT_EQ(records[labels.size() / 2 - 1], 0);
}

}  // namespace
}  // namespace secular
