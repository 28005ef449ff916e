#pragma once

#include <Eigen/Core>

namespace secular {

/// Orthonormal columns that span the given ones (n x m), by Householder reflections with pivots of columns of unit
/// length; those that depend on others but for 1e-9 of their length, which is rounding, are left out.
Eigen::MatrixXd orthonormal_span(Eigen::MatrixXd columns);

/// Columns without what an orthonormal basis spans: columns - basis basis' columns, both with a row each.
Eigen::MatrixXd without_span(const Eigen::MatrixXd& basis, const Eigen::MatrixXd& columns);

}  // namespace secular
