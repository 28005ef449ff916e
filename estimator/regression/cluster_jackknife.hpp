#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace secular {

/// A regression in coordinates of orthonormal columns, after its fit.
struct FittedCoordinates {
  const Eigen::MatrixXd& orthonormal;  ///< rows x rank
  const Eigen::VectorXd& residual;     ///< by row
  const Eigen::MatrixXd& spread;  ///< columns x rank: what one unit of a coordinate's error does to coefficients
  /// By coordinate: what was added to it against the attenuation that errors of the columns make.
  const Eigen::VectorXd& correction;
};

/// Every cluster of rows left out once.
struct ClusterJackknife {
  std::vector<int> labels;                  ///< of clusters, rising
  Eigen::MatrixXd influence;                ///< [cluster][column]: change of a coefficient when it is left out
  std::vector<Eigen::MatrixXd> gram;        ///< by cluster, rank x rank: of its rows of the orthonormal columns
  std::vector<Eigen::VectorXd> score;       ///< by cluster: these rows times residuals; they add up to nothing
  bool one_determines_a_direction = false;  ///< which leaves nothing to compare it with

  /// docs/inference.md (6), CR3: (n-1)/n times the sum of squared influences of n clusters.
  Eigen::MatrixXd covariance() const;
};

/// Exact, by solving without each cluster: leaving rows U_g out changes coordinates by -(I - U_g'U_g)^-1 U_g'e_g.
/// `cluster`: label by row. The result does not depend on `threads`.
ClusterJackknife cluster_jackknife(const FittedCoordinates& fit, std::span<const int> cluster, unsigned threads);

}  // namespace secular
