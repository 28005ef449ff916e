// Error bars of fitted numbers: what all rows leave, and what folds differ by.
#include "diagnose/inference/fold_scatter.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <vector>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index folds = 30, each = 40;

std::vector<RowLabel> labels() {
  std::vector<RowLabel> all(static_cast<std::size_t>(folds * each));
  for (std::size_t r = 0; r < all.size(); ++r) all[r].fold = static_cast<int>(r) / static_cast<int>(each);
  return all;
}

// A line through rows of unit variance, which share an error of `shared` in each fold; unknowns as they are off.
Refit line(double shared, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  MatrixXd columns(folds * each, 2);
  VectorXd rows(folds * each);
  for (Index g = 0; g < folds; ++g) {
    const double common = shared * normal(random);
    for (Index i = 0; i < each; ++i) {
      columns.row(g * each + i) << 1, static_cast<double>(g) / folds - 0.5;
      rows(g * each + i) = common + normal(random);
    }
  }
  Refit fit;
  const MatrixXd square = columns.transpose() * columns;
  fit.unknowns = square.ldlt().solve(columns.transpose() * rows);
  fit.rows = columns * fit.unknowns - rows;
  fit.chi_squared = fit.rows.squaredNorm();
  fit.free = {0, 1};
  fit.scale = VectorXd{{0.1, 0.2}};
  fit.jacobian = columns * fit.scale.asDiagonal();
  fit.rank = 2;
  fit.covariance = square.inverse();
  fit.identifiable = {true, true};
  return fit;
}

// Of 500 draws those within two standard deviations, of the slope.
double held(double shared) {
  std::mt19937_64 random(17);
  constexpr int draws = 500;
  int inside = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const Refit fit = line(shared, random);
    const MatrixXd covariance = covariance_of(fit, labels(), static_cast<double>(folds * each));
    inside += std::abs(fit.unknowns(1)) < 2 * std::sqrt(covariance(1, 1));
  }
  return static_cast<double>(inside) / draws;
}

// Two standard deviations hold 95.4 % of a normal law, 94.5 % of Student's with the 28 degrees of freedom of 30
// folds; three standard deviations of 500 draws are 0.028 to 0.03. With nothing shared the larger of two estimates
// is taken, and some more hold.
TEST(FoldScatter, IntervalsHoldWhateverFoldsShare) {
  EXPECT_GT(held(0), 0.954 - 0.028);
  for (const double shared : {0.3, 1.0}) {
    EXPECT_GT(held(shared), 0.945 - 0.03) << shared;
    EXPECT_LT(held(shared), 0.985) << shared;
  }
}

TEST(FoldScatter, IsNeverBelowWhatAllRowsLeave) {
  std::mt19937_64 random(18);
  for (int draw = 0; draw < 20; ++draw) {
    const Refit fit = line(0, random);
    const double freedom = static_cast<double>(folds * each);
    const MatrixXd plain = dispersion_of(fit.chi_squared, freedom - 2) * fit.covariance,
                   found = covariance_of(fit, labels(), freedom);
    for (Index p = 0; p < 2; ++p) EXPECT_GE(found(p, p), plain(p, p) * (1 - 1e-12));
    EXPECT_NEAR(found(0, 1) / std::sqrt(found(0, 0) * found(1, 1)),
                plain(0, 1) / std::sqrt(plain(0, 0) * plain(1, 1)), 1e-12);
  }
}

// One fold alone tells the slope: nothing to compare it with.
TEST(FoldScatter, WhereOneFoldAloneTellsAnUnknownThePlainOneStays) {
  std::mt19937_64 random(19);
  Refit fit = line(1, random);
  fit.jacobian.col(1).tail((folds - 1) * each).setZero();
  const double freedom = static_cast<double>(folds * each);
  EXPECT_TRUE(
      covariance_of(fit, labels(), freedom).isApprox(dispersion_of(fit.chi_squared, freedom - 2) * fit.covariance));
}

}  // namespace
}  // namespace secular
