#include "numerics/orthonormal_span.hpp"

#include <Eigen/Dense>

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;

MatrixXd orthonormal_span(MatrixXd columns) {
  for (Index c = 0; c < columns.cols(); ++c) {
    const double norm = columns.col(c).norm();
    if (norm > 0) columns.col(c) /= norm;
  }
  Eigen::ColPivHouseholderQR<MatrixXd> qr(columns);
  qr.setThreshold(1e-9);
  return qr.householderQ() * MatrixXd::Identity(columns.rows(), qr.rank());
}

MatrixXd without_span(const MatrixXd& basis, const MatrixXd& columns) {
  if (basis.cols() == 0) return columns;
  return columns - basis * (basis.transpose() * columns);
}

}  // namespace secular
