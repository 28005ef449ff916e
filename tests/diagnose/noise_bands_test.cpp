#include "diagnose/evidence/noise_bands.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// x_i = kept x_(i-1) + e_i, e_i of unit variance.
MatrixXd coloured_stretches(Index samples, Index count, double kept) {
  std::mt19937_64 engine(5);
  std::normal_distribution<double> gaussian;
  MatrixXd all(samples, count);
  for (Index s = 0; s < count; ++s) {
    double x = gaussian(engine) / std::sqrt(1 - kept * kept);
    for (Index i = 0; i < samples; ++i) all(i, s) = x = kept * x + gaussian(engine);
  }
  return all;
}

// Mean square of a cosine of that noise, as a matrix product.
VectorXd variances_of_cosines(const MatrixXd& rows, double kept) {
  MatrixXd covariance(rows.cols(), rows.cols());
  for (Index i = 0; i < rows.cols(); ++i)
    for (Index j = 0; j < rows.cols(); ++j)
      covariance(i, j) = std::pow(kept, static_cast<double>(std::abs(i - j))) / (1 - kept * kept);
  return (rows * covariance * rows.transpose()).diagonal();
}

TEST(NoiseBands, CosinesAreOrthonormal) {
  const MatrixXd rows = cosines(37);
  EXPECT_LT((rows * rows.transpose() - MatrixXd::Identity(37, 37)).norm(), 1e-12);
}

TEST(NoiseBands, ColouredNoiseHasUnitVarianceInThem) {
  constexpr Index samples = 150, count = 4000;
  constexpr double kept = 0.9;
  const MatrixXd rows = cosines(samples), values = rows * coloured_stretches(samples, count, kept);
  const VectorXd sd = noise_by_band({values, MatrixXd::Ones(samples, count)}, {}, 1e-3);
  const VectorXd truth = variances_of_cosines(rows, kept);
  for (Index begin = 0, end = 0; begin < samples; begin = end) {
    while (end < samples && sd(end) == sd(begin)) ++end;
    EXPECT_NEAR(truth.segment(begin, end - begin).mean(), sd(begin) * sd(begin), 0.05 * sd(begin) * sd(begin));
  }
}

TEST(NoiseBands, IsThatOfTheQuietStretches) {
  constexpr Index samples = 64, count = 200;
  MatrixXd values = coloured_stretches(samples, count, 0);
  values.rightCols(count / 4) *= 20;  // what a model misses
  const VectorXd sd = noise_by_band({values, MatrixXd::Ones(samples, count)}, {}, 1e-3);
  EXPECT_NEAR(std::sqrt(sd.cwiseAbs2().mean()), 1, 0.2);
  EXPECT_EQ(noise_by_band({values, MatrixXd::Ones(samples, count)}, {}, 7).minCoeff(), 7);
}

// A tone that nobody took out: third differences take it for white, 3 here, and bands without it hold less.
TEST(NoiseBands, OtherBandsDoNotHoldATone) {
  constexpr Index samples = 64, count = 200;
  MatrixXd values = coloured_stretches(samples, count, 0);
  values.row(60) *= 40;
  const VectorXd sd = noise_by_band({values, MatrixXd::Ones(samples, count)}, {}, 3);
  EXPECT_NEAR(sd.head(40).maxCoeff(), 1, 0.1);
  EXPECT_GT(sd(60), 3);
}

// Spikes in a tenth of the stretches are in all bands, and no band holds less than all stretches do.
TEST(NoiseBands, HoldWhatStandsInAllBandsOfFewStretches) {
  constexpr Index samples = 64, count = 200;
  MatrixXd values = coloured_stretches(samples, count, 0);
  values.rightCols(count / 10) *= 5;
  const double mean = std::sqrt(0.9 + 0.1 * 25);
  EXPECT_NEAR(noise_by_band({values, MatrixXd::Ones(samples, count)}, {}, 3).minCoeff(), mean, 0.15 * mean);
}

TEST(NoiseBands, WhatTheMotionLeavesIsNoNoise) {
  constexpr Index samples = 64, count = 200;
  MatrixXd values = coloured_stretches(samples, count, 0);
  values.middleRows(11, 3) *= 50;
  const VectorXd sd = noise_by_band({values, MatrixXd::Ones(samples, count)}, {12}, 1e-3);
  EXPECT_NEAR(sd(12), 1, 0.2);
}

TEST(NoiseBands, KnowsWhatWasTakenOut) {
  constexpr Index samples = 64, count = 400;
  MatrixXd values = coloured_stretches(samples, count, 0), freedom = MatrixXd::Ones(samples, count);
  values.topRows(2).setZero();
  freedom.topRows(2).setZero();
  const VectorXd sd = noise_by_band({values, freedom}, {}, 1e-3);
  EXPECT_NEAR(sd(3), 1, 0.15);
}

}  // namespace
}  // namespace secular
