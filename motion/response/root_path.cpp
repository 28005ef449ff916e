#include "motion/response/root_path.hpp"

#include <Eigen/SVD>
#include <cmath>
#include <optional>

#include "motion/response/curve_tracer.hpp"

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using ConstVector = Eigen::Ref<const VectorXd>;

std::vector<VectorXd> roots_on_path(const EquationSystem& system, const ConstVector& root,
                                    const ConstVector& direction, double bound) {
  const Index n = root.size();
  const MatrixXd at_root = system.jacobian(root);
  if (!at_root.allFinite()) return {};
  const double rate = at_root.norm() > 0 ? at_root.norm() : 1;
  const VectorXd unit = rate * direction.normalized();
  EquationSystem path;
  path.value = [&](const VectorXd& y) -> VectorXd { return system.value(y.head(n)) - y(n) * unit; };
  path.jacobian = [&](const VectorXd& y) {
    MatrixXd jacobian(n, n + 1);
    jacobian << system.jacobian(y.head(n)), -unit;
    return jacobian;
  };
  CurvePoint start;
  start.unknowns = VectorXd::Zero(n + 1);
  start.unknowns.head(n) = root;
  const Eigen::JacobiSVD<MatrixXd> svd(path.jacobian(start.unknowns), Eigen::ComputeFullV);
  start.tangent = svd.matrixV().col(n);

  std::vector<CurveBound> bounds;
  for (Index i = 0; i < n; ++i) bounds.push_back({i, -bound, bound, TraceStatus::state_bound, ""});
  StepOptions steps;
  steps.largest = 0.1;
  steps.turn = 0.2;
  steps.point_limit = 2000;
  std::vector<VectorXd> roots;
  const auto lambda = [n](const CurvePoint& point) { return point.unknowns(n); };
  const StepVisitor visit = [&](const CurvePoint& from, const CurvePoint& to, bool, TraceEnd&) {
    if (from.unknowns(n) != 0 && std::signbit(from.unknowns(n)) != std::signbit(to.unknowns(n)))
      if (const std::optional<CurvePoint> crossing = zero_between(path, from, to, lambda, 1e-6))
        roots.push_back(crossing->unknowns.head(n));
    return Visit::accept;
  };
  const TraceEnd ahead = trace_curve(path, start, bounds, steps, visit);
  if (ahead.status == TraceStatus::closed_loop) return roots;
  start.tangent = -start.tangent;
  trace_curve(path, start, bounds, steps, visit);
  return roots;
}

}  // namespace secular
