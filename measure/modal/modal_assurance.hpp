#pragma once

#include <Eigen/Core>

namespace secular {

/// Modal assurance criterion |a^H b|^2 / (a^H a b^H b) of two shapes (size p): one for shapes that differ by a
/// complex factor, zero for orthogonal ones. Zero where a shape is zero.
double modal_assurance(const Eigen::Ref<const Eigen::VectorXcd>& a, const Eigen::Ref<const Eigen::VectorXcd>& b);

/// MAC of every column of `a` (p x m) with every column of `b` (p x n): m x n.
Eigen::MatrixXd modal_assurance_matrix(const Eigen::Ref<const Eigen::MatrixXcd>& a,
                                       const Eigen::Ref<const Eigen::MatrixXcd>& b);

/// Modal phase collinearity of a shape: one for a normal mode (all channels in or out of phase), zero for a
/// travelling wave. From the eigenvalues of the 2 x 2 covariance of real and imaginary parts.
double phase_collinearity(const Eigen::Ref<const Eigen::VectorXcd>& shape);

}  // namespace secular
