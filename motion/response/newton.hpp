#pragma once

#include <Eigen/Core>
#include <functional>

#include "numerics/solver_ending.hpp"

namespace secular {

/// A system of equations in unknowns of the order of one.
struct EquationSystem {
  std::function<Eigen::VectorXd(const Eigen::VectorXd& unknowns)> value;     ///< [equation]
  std::function<Eigen::MatrixXd(const Eigen::VectorXd& unknowns)> jacobian;  ///< [equation][unknown]
};

/// The system with its Jacobian by differences.
EquationSystem with_differences(std::function<Eigen::VectorXd(const Eigen::VectorXd&)> value,
                                Eigen::Index equations);

/// Where Newton's method ended. Converged: the last step was below 1e-11 (1 + |unknowns|), or below 1e-8 of it and
/// no longer shrinking (rounding). Ran away: a step was not finite, or four times
/// as long as the last.
struct NewtonResult {
  SolverEnding ending = SolverEnding::stalled;
  int iterations = 0;
  double last_step = 0;
  Eigen::VectorXd unknowns;

  bool converged() const { return ending == SolverEnding::converged; }
};

/// Newton's method, undamped, for as many equations as unknowns; equations are scaled to rows of unit norm.
NewtonResult newton(const EquationSystem& system, const Eigen::Ref<const Eigen::VectorXd>& start,
                    int iteration_limit = 12);

/// Newton's step -J^-1 f in rows of unit norm; the least one in norm where J is singular (to 1e-11).
Eigen::VectorXd newton_step(const Eigen::Ref<const Eigen::MatrixXd>& jacobian,
                            const Eigen::Ref<const Eigen::VectorXd>& value);

}  // namespace secular
