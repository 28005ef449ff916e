#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

namespace secular {

enum class CovarianceKind {
  clustered,  ///< jackknife over clusters (CR3)
  plain,      ///< residual variance times the inverse normal matrix: too few clusters for the other
};

/// Expected products of the errors in a regression's own columns: Gram matrix, and product with the errors of the
/// response that come with them. Empty: not known.
struct ColumnErrors {
  Eigen::MatrixXd gram;
  Eigen::VectorXd with_response;
};

/// Least squares with honest error bars. Rows are whitened by the caller (divided by their noise level).
struct LinearFit {
  Eigen::VectorXd coefficients;      ///< minimum-norm in scaled columns where not identifiable
  Eigen::MatrixXd covariance;        ///< of the identifiable part
  Eigen::MatrixXd plain_covariance;  ///< the same from the residual variance alone, whatever `covariance_kind`
  CovarianceKind covariance_kind = CovarianceKind::plain;
  double degrees_of_freedom = 0;  ///< for Student's t: clusters - 1 if clustered, rows - rank otherwise
  Eigen::Index rank = 0;
  Eigen::Index noisy = 0;          ///< of these directions, those in which columns differ by their own errors
  std::vector<bool> identifiable;  ///< by column
  std::vector<std::vector<int>> entangled_with;  ///< by column: the others of its null directions
  Eigen::VectorXd condition_indices;             ///< largest over each singular value of the scaled columns
  Eigen::VectorXd variance_inflation;            ///< by column, uncentred
  Eigen::MatrixXd variance_proportions;  ///< [singular value][column]: share of a variance (Belsley, Kuh, Welsch)
  Eigen::VectorXd scale;                 ///< by column: scaled column = scale * column has unit norm
  /// columns x lost directions, orthonormal, of scaled coefficients: columns - rank that the rows do not see, then
  /// those of columns that are not identifiable because they differ by their own errors.
  Eigen::MatrixXd lost;
  /// columns x rank: design*basis has orthonormal columns, coefficients + bias = basis*((design*basis)' response).
  Eigen::MatrixXd basis;
  Eigen::MatrixXd orthonormal;  ///< design*basis
  Eigen::VectorXd bias;         ///< what errors of the columns did to least squares, taken out of `coefficients`
  Eigen::VectorXd residual;
  Eigen::VectorXd leverage;  ///< by row
  double residual_sd = 0;
  /// rank x rank: of coordinates in `basis`, what is left of the rows' Gram matrix (the identity) without what
  /// errors of the columns alone give.
  Eigen::MatrixXd kept;
  std::vector<Eigen::MatrixXd> cluster_gram;   ///< by cluster, rank x rank: of its rows of `orthonormal`
  std::vector<Eigen::VectorXd> cluster_score;  ///< by cluster: these rows times residuals; they add up to nothing
  Eigen::MatrixXd influence;                   ///< [cluster][column]: change of a coefficient when it is left out
  std::vector<int> cluster_labels;             ///< rows of `influence`
};

struct LinearFitOptions {
  double tolerance = 1e-9;  ///< singular values below this share of the largest count as zero (rounding)
  /// How many directions an earlier fit of nearly the same rows lost to the errors of the columns.
  std::optional<Eigen::Index> noisy_before;
  unsigned threads = 1;  ///< the result does not depend on them
};

/// docs/inference.md (5), (6). Columns are scaled to unit norm. `cluster` labels rows that share one condition (ten
/// ensembles of one dwell are not ten independent conditions). The covariance is the delete-one-cluster jackknife,
/// exact by solving without each cluster; its bias is upward for few clusters, which keeps intervals honest where
/// the usual sandwich is too narrow. With fewer than five clusters, or where one cluster alone determines a
/// direction, the plain covariance is used and said. `errors`: where a squared singular value is not above
/// `noise_ratio` times what the errors of the columns alone give, the columns whose variance rests mainly on that
/// direction are not identifiable (their least-squares coefficients would be made of noise). In all other
/// directions the attenuation that these errors make is taken out: there (G - E[dX'dX]) b = X'y - E[dX'dy] replaces
/// the normal equations (W. A. Fuller, Measurement Error Models, 1987, section 2.2). Within a factor of two of
/// `noise_ratio` a direction stays on the side where `noisy_before` says that it was, so that fits that follow one
/// another do not change what they estimate. Throws std::invalid_argument for sizes that differ.
LinearFit linear_fit(const Eigen::Ref<const Eigen::MatrixXd>& design,
                     const Eigen::Ref<const Eigen::VectorXd>& response, std::span<const int> cluster,
                     const ColumnErrors& errors = ColumnErrors(),
                     const LinearFitOptions& options = LinearFitOptions());

}  // namespace secular
