#pragma once

#include <Eigen/Core>

namespace secular {

/// By column: what makes its norm one; 1 for a column of zeros.
Eigen::VectorXd unit_scale(const Eigen::Ref<const Eigen::MatrixXd>& columns);

}  // namespace secular
