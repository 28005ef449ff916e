#include "motion/response/newton.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "input/stop_request.hpp"
#include "motion/response/differences.hpp"

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

EquationSystem with_differences(std::function<VectorXd(const VectorXd&)> value, Index equations) {
  EquationSystem system;
  system.jacobian = [value, equations](const VectorXd& unknowns) {
    return difference_jacobian(value, unknowns, VectorXd::Ones(unknowns.size()), equations);
  };
  system.value = std::move(value);
  return system;
}

VectorXd newton_step(const Eigen::Ref<const MatrixXd>& jacobian, const Eigen::Ref<const VectorXd>& value) {
  MatrixXd scaled = jacobian;
  VectorXd right = -value;
  for (Index r = 0; r < scaled.rows(); ++r) {
    const double norm = scaled.row(r).norm();
    if (!(norm > 0)) continue;
    scaled.row(r) /= norm;
    right(r) /= norm;
  }
  if (!scaled.allFinite() || !right.allFinite())
    return VectorXd::Constant(jacobian.cols(), std::numeric_limits<double>::quiet_NaN());
  // Kept, so that it need not ask for its memory each of a million times. Differences leave the zeros of a singular
  // matrix at about 1e-13: without the threshold they would be divided by.
  thread_local Eigen::CompleteOrthogonalDecomposition<MatrixXd> decomposition;
  decomposition.setThreshold(1e-11);
  decomposition.compute(scaled);
  return decomposition.solve(right);
}

NewtonResult newton(const EquationSystem& system, const Eigen::Ref<const VectorXd>& start, int iteration_limit) {
  NewtonResult result;
  result.unknowns = start;
  double previous = std::numeric_limits<double>::infinity();
  while (result.iterations < iteration_limit) {
    end_if_stopped();
    const VectorXd step = newton_step(system.jacobian(result.unknowns), system.value(result.unknowns));
    if (!step.allFinite()) {
      result.ending = SolverEnding::ran_away;
      return result;
    }
    ++result.iterations;
    result.unknowns += step;
    result.last_step = step.norm();
    const double size = 1 + result.unknowns.norm();
    const bool rounding = result.last_step <= 1e-8 * size && result.last_step > 0.5 * previous;
    if (result.last_step <= 1e-11 * size || rounding) {
      result.ending = system.value(result.unknowns).allFinite() ? SolverEnding::converged : SolverEnding::ran_away;
      return result;
    }
    if (result.iterations > 1 && result.last_step > 4 * previous) {
      result.ending = SolverEnding::ran_away;
      return result;
    }
    previous = result.last_step;
  }
  return result;
}

}  // namespace secular
