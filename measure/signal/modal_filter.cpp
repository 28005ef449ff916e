#include "measure/signal/modal_filter.hpp"

#include <Eigen/Dense>
#include <stdexcept>

namespace secular {

using Eigen::MatrixXd;

MatrixXd modal_filter(const Eigen::Ref<const MatrixXd>& shapes) {
  if (shapes.cols() < 1 || shapes.cols() > shapes.rows())
    throw std::invalid_argument("a modal filter needs a channel for every mode");
  const Eigen::JacobiSVD<MatrixXd> svd(shapes, Eigen::ComputeThinU | Eigen::ComputeThinV);
  if (!(svd.singularValues().tail(1)(0) > 1e-12 * svd.singularValues()(0)))
    throw std::invalid_argument("the channels of a modal filter cannot tell the modes apart");
  return svd.solve(MatrixXd::Identity(shapes.rows(), shapes.rows()));
}

}  // namespace secular
