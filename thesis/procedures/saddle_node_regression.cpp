#include "thesis/procedures/saddle_node_regression.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace secular {

using Eigen::Index;
using Eigen::VectorXd;

SaddleNodeFit saddle_node_regression(NonlinearDamping law, const Eigen::Ref<const VectorXd>& amplitude,
                                     const Eigen::Ref<const VectorXd>& forcing, double omega0,
                                     std::optional<double> stiffness_ratio) {
  const Index count = amplitude.size();
  if (forcing.size() != count || count < 3)
    throw std::invalid_argument("a saddle-node regression needs three or more points of amplitude and force");
  const double quadratic = 4 * omega0 * omega0 / (3 * std::numbers::pi), cubic = 0.375 * std::pow(omega0, 3);
  Eigen::MatrixXd design(count, 2);
  design.col(0).setConstant(omega0);
  // D'(a)/(2 a) of the nonlinear column, per unit coefficient.
  VectorXd slope(count);
  for (Index i = 0; i < count; ++i) {
    const double a = amplitude(i);
    design(i, 1) = law == NonlinearDamping::quadratic ? quadratic * a : cubic * a * a;
    slope(i) = law == NonlinearDamping::quadratic ? quadratic / (2 * a) : cubic;
  }
  SaddleNodeFit fit;
  VectorXd factor = VectorXd::Ones(count);
  Eigen::Vector2d x = Eigen::Vector2d::Zero();
  const int passes = stiffness_ratio ? 200 : 1;
  fit.converged = !stiffness_ratio;
  Eigen::MatrixXd scaled = design;
  for (int pass = 0; pass < passes; ++pass) {
    scaled = factor.asDiagonal() * design;
    const Eigen::Vector2d next = scaled.colPivHouseholderQr().solve(forcing);
    const double change = (next - x).cwiseAbs().cwiseQuotient(next.cwiseAbs().cwiseMax(1e-300)).maxCoeff();
    x = next;
    if (!stiffness_ratio) break;
    if (change < 1e-13) {
      fit.converged = true;
      break;
    }
    for (Index i = 0; i < count; ++i) factor(i) = std::hypot(1.0, x(1) * slope(i) / *stiffness_ratio);
  }
  fit.linear = x(0);
  fit.nonlinear = x(1);
  fit.fitted = scaled * x;
  const VectorXd residual = forcing - fit.fitted;
  fit.residual_sd = std::sqrt(residual.squaredNorm() / static_cast<double>(count - 2));
  // Columns differ by many powers of ten: the normal matrix is inverted in scaled columns.
  const Eigen::Vector2d norm = scaled.colwise().norm().transpose();
  const Eigen::MatrixXd unit = scaled * norm.cwiseInverse().asDiagonal();
  const Eigen::Matrix2d inverse = (unit.transpose() * unit).inverse();
  fit.covariance = fit.residual_sd * fit.residual_sd * norm.cwiseInverse().asDiagonal() * inverse *
                   norm.cwiseInverse().asDiagonal();
  double by = 0;
  for (Index i = 0; i < count; ++i) by = std::max(by, -residual(i) / (factor(i) * omega0));
  fit.lowered_linear = fit.linear - by;
  return fit;
}

}  // namespace secular
