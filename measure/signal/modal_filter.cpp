#include "measure/signal/modal_filter.hpp"

#include <Eigen/Dense>
#include <limits>
#include <stdexcept>

namespace secular {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd ModalFilter::responses(const Eigen::Ref<const MatrixXd>& channels) const {
  return channels * inverse.transpose();
}

MatrixXcd ModalFilter::responses(const Eigen::Ref<const MatrixXcd>& coefficients) const {
  return coefficients * inverse.transpose().cast<std::complex<double>>();
}

MatrixXd ModalFilter::covariance(const Eigen::Ref<const VectorXd>& noise_sd) const {
  const VectorXd variance = noise_sd.array().square();
  return inverse * variance.asDiagonal() * inverse.transpose();
}

ModalFilter modal_filter(const Eigen::Ref<const MatrixXd>& shapes, const Eigen::Ref<const VectorXd>& noise_sd) {
  if (shapes.cols() < 1 || shapes.cols() > shapes.rows())
    throw std::invalid_argument("a modal filter needs a channel for every mode");
  if (noise_sd.size() != 0 && (noise_sd.size() != shapes.rows() || !(noise_sd.minCoeff() > 0)))
    throw std::invalid_argument("a modal filter needs a positive noise level for every channel, or none");
  const VectorXd weight =
      noise_sd.size() == 0 ? VectorXd(VectorXd::Ones(shapes.rows())) : VectorXd(noise_sd.cwiseInverse());
  const MatrixXd weighted = weight.asDiagonal() * shapes;
  const Eigen::JacobiSVD<MatrixXd> svd(weighted, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const double smallest = svd.singularValues().tail(1)(0);
  if (!(smallest > 1e-12 * svd.singularValues()(0)))
    throw std::invalid_argument("the channels of a modal filter cannot tell the modes apart");
  ModalFilter filter;
  filter.condition = svd.singularValues()(0) / smallest;
  filter.inverse = svd.solve(MatrixXd::Identity(shapes.rows(), shapes.rows())) * weight.asDiagonal();
  return filter;
}

}  // namespace secular
