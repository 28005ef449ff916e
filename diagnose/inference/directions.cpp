#include "diagnose/inference/directions.hpp"

#include <algorithm>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Singular values of the scaled columns below this share of the largest count as zero: differences are not better.
constexpr double rank_tolerance = 1e-6;

}  // namespace

Directions::Directions(const MatrixXd& jacobian)
    : per_length_(jacobian.colwise().norm().transpose().unaryExpr([](double x) { return x > 0 ? 1 / x : 0.0; })),
      turned_(jacobian * per_length_.asDiagonal()) {
  const Index size = std::min(jacobian.rows(), jacobian.cols());
  const MatrixXd small = turned_.matrixQR().topRows(size).triangularView<Eigen::Upper>();
  svd_.compute(small, Eigen::ComputeThinU | Eigen::ComputeThinV);
  while (rank_ < size && value(rank_) > rank_tolerance * value(0)) ++rank_;
}

MatrixXd Directions::to_orthonormal() const {
  return per_length_.asDiagonal() * svd_.matrixV().leftCols(rank_) *
         svd_.singularValues().head(rank_).cwiseInverse().asDiagonal();
}

VectorXd Directions::along(const VectorXd& rows) const {
  const VectorXd turned = turned_.householderQ().adjoint() * rows;
  return svd_.matrixU().transpose() * turned.head(svd_.matrixU().rows());
}

VectorXd Directions::step(const VectorXd& rows, double damping) const {
  VectorXd weighted = along(rows);
  for (Index i = 0; i < weighted.size(); ++i)
    weighted(i) *= i < rank_ ? value(i) / (value(i) * value(i) + damping) : 0;
  return -per_length_.cwiseProduct(svd_.matrixV() * weighted);
}

void correct_slopes(MatrixXd& jacobian, const VectorXd& step, const VectorXd& change) {
  const double squares = step.squaredNorm();
  if (squares > 0) jacobian += (change - jacobian * step) * (step / squares).transpose();
}

}  // namespace secular
