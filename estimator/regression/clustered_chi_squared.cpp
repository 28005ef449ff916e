#include "estimator/regression/clustered_chi_squared.hpp"

#include <Eigen/Dense>
#include <cmath>

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;

double clustered_chi_squared(const Eigen::VectorXd& residual, Index dimension, const ResidualScatter& scatter) {
  double freedom = 0;
  MatrixXd all = MatrixXd::Zero(residual.size(), residual.size());
  if (scatter.known.cols() > 0) all += scatter.known * scatter.known.transpose();
  for (const MatrixXd& influence : scatter.influence) {
    const auto n = static_cast<double>(influence.rows());
    all += (n - 1) / n * influence.transpose() * influence;
    freedom += n - 1;
  }
  double sum = residual.squaredNorm();
  if (!(freedom > 0) || dimension < 1) return sum;
  const double edge = std::pow(1 + std::sqrt(static_cast<double>(dimension) / freedom), 2);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> own(all);
  for (Index i = 0; i < residual.size(); ++i)
    if (const double variance = own.eigenvalues()(i); variance > edge)
      sum -= (1 - 1 / variance) * std::pow(own.eigenvectors().col(i).dot(residual), 2);
  return sum;
}

}  // namespace secular
