#pragma once

#include <Eigen/Core>

namespace secular {

/// a^T b and from - a b for long matrices of few columns, where packing panels for Eigen's general product takes
/// longer than the product itself. Matrices without columns are allowed.
Eigen::MatrixXd transposed_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
void subtract_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, Eigen::MatrixXd& from);

}  // namespace secular
