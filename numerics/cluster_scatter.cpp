#include "numerics/cluster_scatter.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

void ClusterScatter::keep_above(const VectorXd& least, const VectorXd& error) {
  VectorXd larger = VectorXd::Ones(least.size());
  for (Index p = 0; p < least.size(); ++p) {
    const double found = covariance(p, p), kept = std::max(found, least(p));
    double& freedom = degrees_of_freedom(p);
    if (!(found > 0) || !(freedom > 0)) continue;
    larger(p) = std::sqrt(kept / found);
    freedom = kept * kept / (error(p) + (kept * kept - least(p) * least(p)) / freedom);
  }
  covariance = larger.asDiagonal() * covariance * larger.asDiagonal();
}

std::optional<ClusterScatter> cluster_scatter(const std::vector<ClusterOfRows>& clusters, const MatrixXd& spread) {
  const Index unknowns = spread.rows(), rank = spread.cols();
  std::vector<MatrixXd> roots;
  ClusterScatter result{MatrixXd::Zero(unknowns, unknowns), VectorXd::Zero(unknowns)};
  for (const ClusterOfRows& cluster : clusters) {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> stays(MatrixXd(MatrixXd::Identity(rank, rank) - cluster.gram));
    if (stays.eigenvalues().minCoeff() < 1 - largest_leverage) return std::nullopt;
    const MatrixXd root = stays.operatorInverseSqrt();
    const VectorXd move = spread * (root * cluster.score);
    result.covariance += move * move.transpose();
    roots.emplace_back(root * spread.transpose());
  }
  // The estimated variance is a sum of squares of linear forms in what is left; where that is noise of unit
  // variance, the forms have the covariance `forms`.
  const auto count = static_cast<Index>(clusters.size());
  for (Index p = 0; p < unknowns; ++p) {
    MatrixXd products(rank, count);
    VectorXd own(count);
    for (Index g = 0; g < count; ++g) {
      const auto at = static_cast<std::size_t>(g);
      products.col(g) = clusters[at].gram * roots[at].col(p);
      own(g) = roots[at].col(p).dot(products.col(g));
    }
    MatrixXd forms = -products.transpose() * products;
    forms.diagonal() += own;
    const double trace = forms.trace(), square = forms.squaredNorm();
    if (trace > 0 && square > 0) result.degrees_of_freedom(p) = trace * trace / square;
  }
  return result;
}

}  // namespace secular
