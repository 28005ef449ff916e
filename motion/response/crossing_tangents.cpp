#include "motion/response/crossing_tangents.hpp"

#include <Eigen/SVD>
#include <cmath>
#include <utility>

#include "motion/response/differences.hpp"

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using ConstVector = Eigen::Ref<const VectorXd>;

CrossingTangents crossing_tangents(const ScaledField& field, const ConstVector& unknowns,
                                   const ConstVector& reference) {
  const Index n = field.dimension();
  CrossingTangents crossing;
  const Eigen::JacobiSVD<MatrixXd> svd(field.jacobian(unknowns), Eigen::ComputeFullU | Eigen::ComputeFullV);
  if (n > 1 && svd.singularValues()(n - 2) < 1e-7 * svd.singularValues()(0)) return crossing;
  const MatrixXd plane = svd.matrixV().rightCols(2);
  const VectorXd left = svd.matrixU().col(n - 1);
  const auto curvature = [&](const VectorXd& direction) {
    return left.dot(second_difference([&](const VectorXd& y) { return field.rate(y); }, unknowns, direction));
  };
  const double a = curvature(plane.col(0)), c = curvature(plane.col(1));
  const double b = 0.25 * (curvature(plane.col(0) + plane.col(1)) - curvature(plane.col(0) - plane.col(1)));
  // a cos^2 + 2 b cos sin + c sin^2 = 0  <=>  (a + c)/2 + (a - c)/2 cos 2t + b sin 2t = 0
  const double mean = 0.5 * (a + c), radius = std::hypot(0.5 * (a - c), b);
  const double noise = 1e-7 * svd.singularValues()(0);
  if (!(radius > noise) || std::abs(mean) > (1 - 1e-9) * radius) return crossing;
  const double phase = std::atan2(b, 0.5 * (a - c)), opening = std::acos(-mean / radius);
  const auto direction = [&](double angle) -> VectorXd {
    return plane * Vector2d(std::cos(angle), std::sin(angle));
  };
  VectorXd along = direction(0.5 * (phase + opening)), across = direction(0.5 * (phase - opening));
  if (std::abs(along.dot(reference)) < std::abs(across.dot(reference))) std::swap(along, across);
  if (along.dot(reference) < 0) along = -along;
  crossing.tangents.resize(n + 1, 2);
  crossing.tangents << along, across;
  const bool vertical = std::abs(along(n)) < 1e-6 || std::abs(across(n)) < 1e-6;
  crossing.kind = vertical ? SpecialKind::pitchfork : SpecialKind::transcritical;
  return crossing;
}

}  // namespace secular
