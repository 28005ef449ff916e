#include "motion/response/amplitude_slope.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "motion/response/differences.hpp"

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Of singular values over the largest one: no rank, after differences of rounded rates.
constexpr double no_rank = 1e-7;

}  // namespace

VectorXd turned_tangent(const Eigen::Ref<const MatrixXd>& jacobian) {
  const Index n = jacobian.rows();
  const VectorXd none = VectorXd::Constant(n + 1, std::numeric_limits<double>::quiet_NaN());
  if (!jacobian.allFinite()) return none;
  const Eigen::JacobiSVD<MatrixXd> svd(jacobian, Eigen::ComputeFullV);
  if (!(svd.singularValues()(n - 1) > no_rank * svd.singularValues()(0))) return none;
  VectorXd tangent = svd.matrixV().col(n);
  MatrixXd bordered(n + 1, n + 1);
  bordered << jacobian / svd.singularValues()(0), tangent.transpose();
  if (bordered.determinant() < 0) tangent = -tangent;
  return tangent;
}

double AmplitudeSquare::at(const Eigen::Ref<const VectorXd>& unknowns) const {
  return std::norm(field_.amplitudes(scaled_.parameters(unknowns), scaled_.state(unknowns)).amplitude[mode_] /
                   scale_);
}

double AmplitudeSquare::slope(const Eigen::Ref<const VectorXd>& unknowns,
                              const Eigen::Ref<const VectorXd>& direction) const {
  const auto moved = [&](double steps) { return at(unknowns + steps * difference_step * direction); };
  return (8 * (moved(1) - moved(-1)) - (moved(2) - moved(-2))) / (12 * difference_step);
}

}  // namespace secular
