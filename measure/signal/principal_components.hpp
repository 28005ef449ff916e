#pragma once

#include <Eigen/Core>
#include <vector>

namespace secular {

/// Spatial principal components of samples x channels, thesis Eq. (3.17): Y^T Y = P D^2 P^T.
struct SpatialComponents {
  Eigen::VectorXd singular_values;  ///< D, descending, unit of the channels times sqrt(samples)
  Eigen::MatrixXd shapes;           ///< P, channels x channels, orthonormal columns
};
SpatialComponents spatial_components(const Eigen::Ref<const Eigen::MatrixXd>& channels);

/// Temporal principal components, Eq. (3.18): singular values of the block Hankel matrix of Eqs. (A.3)-(A.6) with
/// `delays` block rows, descending.
Eigen::VectorXd temporal_singular_values(const Eigen::Ref<const Eigen::MatrixXd>& channels, int delays);

/// Number of spatial functions by a test, one after the other: "no more than m", m = 0, 1, ...
struct SpatialCount {
  int functions = 0;                ///< first m that is not rejected
  std::vector<double> probability;  ///< of an eigenvalue m+1 as large if there are no more than m
  bool limited = false;             ///< as many as the test can see: more channels may show more
};

/// With the noise of each channel known (noise_sd, for instance from the residual of a decomposition): channels are
/// divided by it and the largest remaining eigenvalue is compared with the largest of pure noise (Tracy-Widom law
/// of order one, Johnstone's centring for samples - m by channels - m). All counts up to the number of channels can
/// be told.
SpatialCount count_spatial_functions(const Eigen::Ref<const Eigen::MatrixXd>& channels,
                                     const Eigen::Ref<const Eigen::VectorXd>& noise_sd, double false_alarm = 0.01);

/// Noise of one unknown level in all channels: equality of the remaining eigenvalues by Lawley's corrected
/// likelihood ratio, chi-square. It needs two remaining eigenvalues, so that at most channels - 1 functions show.
SpatialCount count_spatial_functions(const Eigen::Ref<const Eigen::MatrixXd>& channels, double false_alarm = 0.01);

}  // namespace secular
