#include "measure/modal/modal_assurance.hpp"

#include <cmath>
#include <complex>

namespace secular {

double modal_assurance(const Eigen::Ref<const Eigen::VectorXcd>& a, const Eigen::Ref<const Eigen::VectorXcd>& b) {
  const double scale = a.squaredNorm() * b.squaredNorm();
  return scale > 0 ? std::norm(a.dot(b)) / scale : 0;
}

Eigen::MatrixXd modal_assurance_matrix(const Eigen::Ref<const Eigen::MatrixXcd>& a,
                                       const Eigen::Ref<const Eigen::MatrixXcd>& b) {
  Eigen::MatrixXd mac(a.cols(), b.cols());
  for (Eigen::Index i = 0; i < a.cols(); ++i)
    for (Eigen::Index j = 0; j < b.cols(); ++j) mac(i, j) = modal_assurance(a.col(i), b.col(j));
  return mac;
}

double phase_collinearity(const Eigen::Ref<const Eigen::VectorXcd>& shape) {
  // Eigenvalues of [Sxx Sxy; Sxy Syy] are (total +- spread)/2; the shape's mean is no part of it.
  const double total = shape.squaredNorm();
  const double spread = std::abs((shape.array() * shape.array()).sum());
  return total > 0 ? (spread / total) * (spread / total) : 0;
}

}  // namespace secular
