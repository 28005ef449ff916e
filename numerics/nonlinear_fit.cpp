#include "numerics/nonlinear_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "input/stop_request.hpp"
#include "numerics/unit_scale.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double rank_tolerance = 1e-9;
constexpr double uninformed = 3;

struct Linearisation {
  VectorXd scale;  // of the columns
  Eigen::BDCSVD<MatrixXd> svd;
  Index rank = 0;
};

Linearisation linearise(const MatrixXd& jacobian) {
  Linearisation l;
  l.scale = unit_scale(jacobian);
  l.svd.compute(jacobian * l.scale.asDiagonal(), Eigen::ComputeThinU | Eigen::ComputeFullV);
  const VectorXd& singular = l.svd.singularValues();
  while (l.rank < singular.size() && singular(l.rank) > rank_tolerance * singular(0) && singular(l.rank) > 0)
    ++l.rank;
  return l;
}

// The part of a step (by singular direction) along what the residuals are informed of.
VectorXd informed_part(const Linearisation& l, VectorXd along, const VectorXd& plausible) {
  for (Index k = 0; k < along.size(); ++k)
    if (!is_informed(l.svd.matrixV().col(k), l.svd.singularValues()(k), l.scale, plausible)) along(k) = 0;
  return along;
}

}  // namespace

bool is_informed(const VectorXd& direction, double singular, const VectorXd& scale, const VectorXd& plausible) {
  double size = 0, share = 0;
  for (Index p = 0; p < direction.size(); ++p) {
    if (!std::isfinite(plausible(p))) continue;
    size += std::pow(direction(p) * plausible(p) / scale(p), 2);
    share += direction(p) * direction(p);
  }
  // A direction of others in the main is theirs to judge.
  return share < 0.5 || std::sqrt(share) <= uninformed * singular * std::sqrt(size);
}

FitReport nonlinear_fit(const ResidualFunction& function, Index residuals, const VectorXd& start,
                        int iteration_limit, const VectorXd& plausible) {
  FitReport report;
  report.parameters = start;
  VectorXd residual(residuals), trial_residual(residuals);
  MatrixXd jacobian(residuals, start.size()), trial_jacobian(residuals, start.size());
  function(report.parameters, residual, jacobian);
  report.cost = 0.5 * residual.squaredNorm();
  report.reason = "iteration limit";
  double damping = 1e-4;
  for (; report.iterations < iteration_limit; ++report.iterations) {
    const Linearisation l = linearise(jacobian);
    VectorXd along = l.svd.matrixU().leftCols(l.rank).transpose() * residual;
    if (plausible.size() > 0) along = informed_part(l, std::move(along), plausible);
    const auto singular = l.svd.singularValues().head(l.rank).array();
    bool moved = false;
    while (damping < 1e10) {
      end_if_stopped();
      const VectorXd inner = -(singular / (singular.square() + damping)).matrix().cwiseProduct(along);
      const VectorXd step = l.scale.asDiagonal() * (l.svd.matrixV().leftCols(l.rank) * inner);
      const VectorXd candidate = report.parameters + step;
      function(candidate, trial_residual, trial_jacobian);
      const double cost = 0.5 * trial_residual.squaredNorm();
      if (std::isfinite(cost) && cost <= report.cost) {
        const double gain = report.cost - cost;
        report.parameters = candidate;
        residual = trial_residual;
        jacobian = trial_jacobian;
        const bool done = gain <= 1e-14 * report.cost || inner.norm() <= 1e-12 * (1 + residual.norm());
        report.cost = cost;
        damping = std::max(damping / 10, 1e-14);
        moved = true;
        if (done) {
          report.ending = SolverEnding::converged;
          report.reason = "the cost no longer changes";
        }
        break;
      }
      damping *= 10;
    }
    if (!moved) {
      const double slope = along.norm();
      report.ending = slope <= 1e-6 * (1e-300 + residual.norm()) ? SolverEnding::converged : SolverEnding::stalled;
      report.reason =
          report.ending == SolverEnding::converged ? "the gradient vanishes" : "no step lowers the cost";
    }
    if (report.ending == SolverEnding::converged || !moved) break;
  }
  const Linearisation l = linearise(jacobian);
  const Index count = start.size();
  const MatrixXd v = l.svd.matrixV().leftCols(l.rank);
  const VectorXd inverse = l.svd.singularValues().head(l.rank).cwiseInverse();
  report.covariance =
      l.scale.asDiagonal() * (v * inverse.cwiseAbs2().asDiagonal() * v.transpose()) * l.scale.asDiagonal();
  report.condition = l.rank > 0 ? l.svd.singularValues()(0) * inverse(l.rank - 1) : 0;
  const MatrixXd null = l.svd.matrixV().rightCols(count - l.rank);
  const MatrixXd projection = null * null.transpose();
  report.identifiable.assign(static_cast<std::size_t>(count), true);
  report.entangled_with.resize(static_cast<std::size_t>(count));
  for (Index c = 0; c < count; ++c) {
    if (projection(c, c) < 1e-10) continue;
    report.identifiable[static_cast<std::size_t>(c)] = false;
    for (Index other = 0; other < count; ++other)
      if (other != c && std::abs(projection(c, other)) > 1e-8)
        report.entangled_with[static_cast<std::size_t>(c)].push_back(static_cast<int>(other));
  }
  return report;
}

}  // namespace secular
