#include "numerics/unit_scale.hpp"

namespace secular {

Eigen::VectorXd unit_scale(const Eigen::Ref<const Eigen::MatrixXd>& columns) {
  Eigen::VectorXd scale = columns.colwise().norm().transpose();
  for (Eigen::Index c = 0; c < scale.size(); ++c) scale(c) = scale(c) > 0 ? 1 / scale(c) : 1;
  return scale;
}

}  // namespace secular
