#pragma once

#include <Eigen/Core>

namespace secular {

/// The singular directions of a regression's columns, scaled to unit norm: docs/inference.md (5).
struct ScaledDecomposition {
  Eigen::VectorXd scale;        ///< by column: scaled column = scale * column has unit norm
  Eigen::MatrixXd seen;         ///< columns x rank, orthonormal: directions of singular values above the tolerance
  Eigen::MatrixXd null;         ///< columns x (columns - rank), orthonormal: the others
  Eigen::VectorXd inverse;      ///< by seen direction: one over its singular value
  double largest = 0;           ///< singular value
  Eigen::VectorXd coordinates;  ///< of the response along the left singular vectors of the seen directions
  Eigen::MatrixXd left;         ///< rows x rank: these vectors; empty where rows were condensed first

  Eigen::Index rank() const { return seen.cols(); }
};

/// Singular values below `tolerance` times the largest count as zero. More than two rows for a column are condensed
/// first, in chunks that `threads` share; the result does not depend on them.
ScaledDecomposition scaled_decomposition(const Eigen::Ref<const Eigen::MatrixXd>& design,
                                         const Eigen::Ref<const Eigen::VectorXd>& response, double tolerance,
                                         unsigned threads);

}  // namespace secular
