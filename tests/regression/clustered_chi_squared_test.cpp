#include "estimator/regression/clustered_chi_squared.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/simulate/noise.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index dimension = 12, clusters = 30;
constexpr int draws = 400;

struct Draws {
  double plain = 0, corrected = 0;  // means of the statistics
};

// Residuals that are means over clusters times their root: white noise, and `excess` in one direction that is not
// an axis. The jackknife's change of a mean where a cluster is left out is -(x - mean)/(n - 1).
Draws draw(double excess, std::uint64_t seed) {
  VectorXd direction = VectorXd::LinSpaced(dimension, -1, 2).normalized();
  Draws result;
  for (int d = 0; d < draws; ++d) {
    NoiseStream noise(seed, static_cast<std::uint64_t>(d), 0);
    MatrixXd x(clusters, dimension);
    for (Index i = 0; i < clusters; ++i) {
      for (Index j = 0; j < dimension; ++j) x(i, j) = noise.gaussian();
      x.row(i) += excess * noise.gaussian() * direction.transpose();
    }
    const Eigen::RowVectorXd mean = x.colwise().mean();
    const double root = std::sqrt(static_cast<double>(clusters));
    const ResidualScatter scatter{{-root / (clusters - 1) * (x.rowwise() - mean)}, MatrixXd(dimension, 0)};
    const VectorXd residual = root * mean.transpose();
    result.plain += residual.squaredNorm() / draws;
    result.corrected += clustered_chi_squared(residual, dimension, scatter) / draws;
  }
  return result;
}

// Mean of draws of chi-squared: its degrees of freedom, variance twice that.
const double band = 4.5 * std::sqrt(2.0 * dimension / draws);

TEST(ClusteredChiSquared, IsTheSumOfSquaresWhereClustersScatterByNoise) {
  const Draws d = draw(0, 1);
  EXPECT_NEAR(d.plain, dimension, band);
  EXPECT_NEAR(d.corrected, dimension, band);
  // The edge is passed by chance seldom, and little is taken out then.
  EXPECT_NEAR(d.corrected, d.plain, 0.02 * dimension);
}

TEST(ClusteredChiSquared, ADirectionInWhichClustersScatterMoreCountsByThat) {
  const Draws d = draw(6, 2);
  EXPECT_GT(d.plain, dimension + 36 - 4.5 * 37 * std::sqrt(2.0 / draws));
  // F of one direction with clusters - 1 degrees of freedom has the mean (n - 1)/(n - 3) instead of one.
  EXPECT_NEAR(d.corrected, dimension - 1 + (clusters - 1.0) / (clusters - 3.0), band);
}

TEST(ClusteredChiSquared, WithoutClustersNothingChanges) {
  const VectorXd residual = VectorXd::LinSpaced(5, 1, 3);
  EXPECT_EQ(clustered_chi_squared(residual, 3, {{}, MatrixXd::Identity(5, 5)}), residual.squaredNorm());
}

}  // namespace
}  // namespace secular
