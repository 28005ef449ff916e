#include "estimator/regression/cluster_jackknife.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

#include "numerics/cluster_scatter.hpp"
#include "numerics/in_parallel.hpp"

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd ClusterJackknife::covariance() const {
  const auto n = static_cast<double>(labels.size());
  return (n - 1) / n * influence.transpose() * influence;
}

ClusterJackknife cluster_jackknife(const FittedCoordinates& fit, std::span<const int> cluster, unsigned threads) {
  std::map<int, std::vector<Index>> by_label;
  for (std::size_t r = 0; r < cluster.size(); ++r) by_label[cluster[r]].push_back(static_cast<Index>(r));
  ClusterJackknife result;
  std::vector<std::vector<Index>> members;
  for (auto& [label, group] : by_label) {
    result.labels.push_back(label);
    members.push_back(std::move(group));
  }
  const Index rank = fit.orthonormal.cols();
  result.influence = MatrixXd::Zero(static_cast<Index>(members.size()), fit.spread.rows());
  result.gram.resize(members.size());
  result.score.resize(members.size());
  std::vector<char> determines_alone(members.size(), 0);
  in_parallel(members.size(), threads, [&](std::size_t g) {
    if (rank == 0) return;  // nothing is seen that a cluster could change
    const MatrixXd basis = fit.orthonormal(members[g], Eigen::all);
    const MatrixXd gram = basis.transpose() * basis, kept = MatrixXd::Identity(rank, rank) - gram;
    const Eigen::LDLT<MatrixXd> solver(kept);
    determines_alone[g] = solver.vectorD().minCoeff() < 1 - largest_leverage;
    const VectorXd score = basis.transpose() * fit.residual(members[g]);
    result.influence.row(static_cast<Index>(g)) = -(fit.spread * VectorXd(solver.solve(score))).transpose();
    // With its part of what errors of the columns did, by the weight of its rows.
    result.score[g] = score + gram * fit.correction;
    result.gram[g] = gram;
  });
  result.one_determines_a_direction = std::count(determines_alone.begin(), determines_alone.end(), 1) > 0;
  return result;
}

}  // namespace secular
