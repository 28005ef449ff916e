#pragma once

#include <Eigen/Core>

namespace secular {

/// A small regression with the same sum of squares as a long one for every vector of coefficients.
struct CondensedRows {
  Eigen::MatrixXd design;    ///< (columns + 1) x columns, the last row zero
  Eigen::VectorXd response;  ///< the last one is the norm of what no coefficients explain
};

/// Condenses at least columns + 1 rows. Where the scaled columns are well apart, or exactly dependent, from their
/// Gram matrix, which reads the rows once; by Householder's triangle otherwise. Singular values of the scaled
/// columns are right to 1e-8 of each, zero ones to 1e-10 of the largest. The result does not depend on `threads`.
CondensedRows condensed_rows(const Eigen::Ref<const Eigen::MatrixXd>& design,
                             const Eigen::Ref<const Eigen::VectorXd>& response, unsigned threads = 1);

}  // namespace secular
