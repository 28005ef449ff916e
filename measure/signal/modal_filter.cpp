#include "measure/signal/modal_filter.hpp"

#include <Eigen/Dense>
#include <stdexcept>

namespace secular {

using Eigen::MatrixXd;

bool tells_modes_apart(const Eigen::Ref<const MatrixXd>& shapes) {
  if (shapes.cols() < 1 || shapes.cols() > shapes.rows()) return false;
  const Eigen::JacobiSVD<MatrixXd> svd(shapes);
  return svd.singularValues().tail(1)(0) > 1e-12 * svd.singularValues()(0);
}

MatrixXd modal_filter(const Eigen::Ref<const MatrixXd>& shapes) {
  if (!tells_modes_apart(shapes))
    throw std::invalid_argument("the channels of a modal filter cannot tell the modes apart");
  const Eigen::JacobiSVD<MatrixXd> svd(shapes, Eigen::ComputeThinU | Eigen::ComputeThinV);
  return svd.solve(MatrixXd(MatrixXd::Identity(shapes.rows(), shapes.rows())));
}

}  // namespace secular
