#include "estimator/regression/cluster_jackknife.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <vector>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Without one cluster, coefficients are those of a fit of the rows that are left.
TEST(ClusterJackknife, InfluenceIsThatOfAFitWithoutTheCluster) {
  MatrixXd design(6, 2);
  design << 1, 0, 1, 1, 1, 2, 1, 3, 1, 5, 1, 8;
  VectorXd y(6);
  y << 1, 3, 4, 4, 7, 7;
  const std::vector<int> cluster = {7, 3, 3, 5, 7, 5};
  const Eigen::HouseholderQR<MatrixXd> qr(design);
  const MatrixXd orthonormal = MatrixXd(qr.householderQ()).leftCols(2);
  const MatrixXd triangle = orthonormal.transpose() * design;
  const MatrixXd spread = triangle.inverse();
  const VectorXd whole = qr.solve(y), residual = y - design * whole, none = VectorXd::Zero(2);
  const ClusterJackknife jackknife = cluster_jackknife({orthonormal, residual, spread, none}, cluster, 1);
  EXPECT_EQ(jackknife.labels, (std::vector<int>{3, 5, 7}));
  EXPECT_FALSE(jackknife.one_determines_a_direction);
  for (std::size_t g = 0; g < jackknife.labels.size(); ++g) {
    std::vector<Index> kept;
    for (Index r = 0; r < 6; ++r)
      if (cluster[static_cast<std::size_t>(r)] != jackknife.labels[g]) kept.push_back(r);
    const MatrixXd rest = design(kept, Eigen::all);
    const VectorXd without = rest.householderQr().solve(VectorXd(y(kept)));
    EXPECT_LT((jackknife.influence.row(static_cast<Index>(g)).transpose() - (without - whole)).norm(), 1e-12);
  }
  EXPECT_LT((jackknife.score[0] + jackknife.score[1] + jackknife.score[2]).norm(), 1e-12);
  EXPECT_LT((jackknife.gram[0] + jackknife.gram[1] + jackknife.gram[2] - MatrixXd::Identity(2, 2)).norm(), 1e-12);
  EXPECT_LT((jackknife.covariance() - 2.0 / 3 * jackknife.influence.transpose() * jackknife.influence).norm(),
            1e-15);
}

TEST(ClusterJackknife, OneClusterThatAloneDeterminesADirectionIsSaid) {
  const MatrixXd orthonormal = MatrixXd::Identity(4, 2), spread = MatrixXd::Identity(2, 2);
  const VectorXd residual = VectorXd::Zero(4), none = VectorXd::Zero(2);
  const std::vector<int> apart = {0, 1, 2, 3};
  EXPECT_TRUE(cluster_jackknife({orthonormal, residual, spread, none}, apart, 1).one_determines_a_direction);
}

}  // namespace
}  // namespace secular
