#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace secular {

/// A cluster that takes more than this of a direction determines it alone: nothing is left to compare it with.
inline constexpr double largest_leverage = 0.999;

/// Rows of a least-squares fit that belong together, in coordinates in which the columns of all rows are
/// orthonormal.
struct ClusterOfRows {
  Eigen::MatrixXd gram;   ///< coordinates x coordinates: of these rows of the columns
  Eigen::VectorXd score;  ///< these rows of the columns times what the fit leaves of them
};

/// Error bars from the scatter between clusters.
struct ClusterScatter {
  Eigen::MatrixXd covariance;          ///< unknowns x unknowns
  Eigen::VectorXd degrees_of_freedom;  ///< by unknown, for Student's t

  /// docs/inference.md (27): no variance is below what rows that are independent make of it, `least`, by unknown;
  /// `error` is its square over its degrees of freedom. Correlations stay.
  void keep_above(const Eigen::VectorXd& least, const Eigen::VectorXd& error);
};

/// docs/inference.md (8), (9): what clusters leave, each divided by the square root of what the fit leaves of it,
/// so that products have the right mean where clusters differ by noise alone, and degrees of freedom by the law of
/// that estimate (CR2; R. M. Bell and D. F. McCaffrey, Survey Methodology 28, 2002, 169-181). `spread`: unknowns x
/// coordinates, how unknowns follow coordinates. Nothing where one cluster alone determines a direction.
std::optional<ClusterScatter> cluster_scatter(const std::vector<ClusterOfRows>& clusters,
                                              const Eigen::MatrixXd& spread);

}  // namespace secular
