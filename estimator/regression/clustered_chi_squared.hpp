#pragma once

#include <Eigen/Core>
#include <vector>

namespace secular {

/// How residuals scatter, by independent sources, over the standard deviations that measured noise gives them.
struct ResidualScatter {
  /// By source with clusters: clusters x residuals, changes where a cluster is left out (jackknife).
  std::vector<Eigen::MatrixXd> influence;
  /// Residuals x any: a factor of the covariance of what has no clusters.
  Eigen::MatrixXd known;
};

/// Chi-squared of whitened residuals that lie in a space of `dimension` directions, with what clusters show allowed
/// for: a direction in which they scatter more than white noise can make them by chance (eigenvalue of the scatter
/// above (1 + sqrt(dimension/degrees of freedom))^2, the edge of the spectrum of a sample covariance: Marchenko and
/// Pastur, Math. USSR Sbornik 1 (1967) 457) counts by that scatter. All others count by the noise.
double clustered_chi_squared(const Eigen::VectorXd& residual, Eigen::Index dimension,
                             const ResidualScatter& scatter);

}  // namespace secular
