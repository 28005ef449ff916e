#pragma once

#include <Eigen/Core>

namespace secular {

/// Whether the columns of Phi (channels x modes) are independent.
bool tells_modes_apart(const Eigen::Ref<const Eigen::MatrixXd>& shapes);

/// What makes modal responses of physical ones, thesis Eq. (3.19): v^T = pinv(Phi) y^T for mass-normalised shapes
/// Phi (channels x modes). Returns pinv(Phi). Throws std::invalid_argument for more modes than channels and for
/// shapes that the channels cannot tell apart.
Eigen::MatrixXd modal_filter(const Eigen::Ref<const Eigen::MatrixXd>& shapes);

}  // namespace secular
