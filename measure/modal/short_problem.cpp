#include "measure/modal/short_problem.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

void fill_short_problem(const MatrixXd& hessian, const VectorXd& gradient, double squares, VectorXd& residual,
                        MatrixXd& jacobian) {
  const Index n = gradient.size();
  const VectorXd length = hessian.diagonal().cwiseMax(1e-300).cwiseSqrt(), shorten = length.cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> spectrum(
      MatrixXd(shorten.asDiagonal() * hessian * shorten.asDiagonal()));
  const VectorXd singular = spectrum.eigenvalues().cwiseMax(0).cwiseSqrt();
  VectorXd along = spectrum.eigenvectors().transpose() * shorten.cwiseProduct(gradient);
  for (Index i = 0; i < n; ++i)
    along(i) = singular(i) > 1e-7 * singular(n - 1) ? along(i) / singular(i) : 0;  // below: rounding
  jacobian.topRows(n) = singular.asDiagonal() * spectrum.eigenvectors().transpose() * length.asDiagonal();
  jacobian.row(n).setZero();
  residual.head(n) = along;
  residual(n) = std::sqrt(std::max(0.0, squares - along.squaredNorm()));
}

}  // namespace secular
