#pragma once

#include <Eigen/Core>

namespace secular {

/// Fills residual (n + 1) and Jacobian (n + 1 x n) of the shortest least-squares problem with J^T J = `hessian`,
/// J^T r = `gradient` and r^T r = `squares`: with H = V S^2 V^T the rows S V^T, the residual S^-1 V^T g, and one
/// entry more for the rest of r. A problem of many samples is never formed that way.
void fill_short_problem(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& gradient, double squares,
                        Eigen::VectorXd& residual, Eigen::MatrixXd& jacobian);

}  // namespace secular
