#include "motion/response/augmented_systems.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <cmath>
#include <limits>

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using ConstVector = Eigen::Ref<const VectorXd>;
using ConstMatrix = Eigen::Ref<const MatrixXd>;

Borders null_vectors(const ConstMatrix& jacobian, const Borders* previous) {
  const Index n = jacobian.rows();
  if (!jacobian.allFinite()) return {VectorXd::Unit(n, 0), VectorXd::Unit(n, 0)};
  const Eigen::JacobiSVD<MatrixXd> svd(jacobian, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Borders borders{svd.matrixU().col(n - 1), svd.matrixV().col(n - 1), jacobian.norm()};
  // A single state's Jacobian vanishes at the very points looked for: it says nothing of the size of rates.
  if (n == 1 || !(borders.rate > 0)) borders.rate = 1;
  if (previous != nullptr) {
    if (borders.left.dot(previous->left) < 0) borders.left = -borders.left;
    if (borders.right.dot(previous->right) < 0) borders.right = -borders.right;
  }
  return borders;
}

BorderedSolution solve_bordered(const ConstMatrix& jacobian, const Borders& borders) {
  const Index n = jacobian.rows();
  MatrixXd bordered(n + 1, n + 1);
  bordered << jacobian, borders.rate * borders.left, borders.rate * borders.right.transpose(), 0.0;
  BorderedSolution solution;
  if (!bordered.allFinite()) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    solution = {nan, VectorXd::Constant(n, nan), VectorXd::Constant(n, nan)};
    return solution;
  }
  const VectorXd last = borders.rate * VectorXd::Unit(n + 1, n);
  const VectorXd right = bordered.colPivHouseholderQr().solve(last);
  const VectorXd left = bordered.transpose().colPivHouseholderQr().solve(last);
  solution.g = right(n);
  solution.right = right.head(n);
  solution.left = left.head(n);
  return solution;
}

VectorXd fold_equations(const ScaledField& field, const ConstVector& unknowns, const Borders& borders) {
  VectorXd value(field.dimension() + 1);
  value << field.rate(unknowns), solve_bordered(field.state_jacobian(unknowns), borders).g;
  return value;
}

VectorXd branch_point_equations(const ScaledField& field, const ConstVector& unknowns, const Borders& borders) {
  const ConstVector y = unknowns.head(field.unknowns());
  const double beta = unknowns(field.unknowns());
  const BorderedSolution bordered = solve_bordered(field.state_jacobian(y), borders);
  const VectorXd rate = field.rate(y) + beta * borders.left;
  VectorXd value(field.dimension() + 2);
  value << rate, bordered.g, bordered.left.dot(field.parameter_derivative(y, 0));
  return value;
}

VectorXd hopf_equations(const ScaledField& field, const ConstVector& unknowns, const EigenvaluePair& reference) {
  const EigenvaluePair pair = nearest_pair(spectrum_of(field.state_jacobian(unknowns)), {0, reference.product});
  VectorXd value(field.dimension() + 1);
  value << field.rate(unknowns), pair.sum;
  return value;
}

}  // namespace secular
