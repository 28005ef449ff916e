#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "numerics/solver_ending.hpp"

namespace secular {

/// How a nonlinear least-squares fit ended.
struct FitReport {
  SolverEnding ending = SolverEnding::stalled;
  std::string reason;
  int iterations = 0;
  double cost = 0;  ///< half the sum of squared residuals
  Eigen::VectorXd parameters;
  Eigen::MatrixXd covariance;  ///< of the identifiable directions, for residuals of unit variance
  double condition = 0;        ///< of the scaled Jacobian, identifiable part
  std::vector<bool> identifiable;
  std::vector<std::vector<int>> entangled_with;
};

/// Residuals (whitened by the caller) and their Jacobian at `parameters`; both have their size already.
using ResidualFunction =
    std::function<void(const Eigen::VectorXd& parameters, Eigen::VectorXd& residual, Eigen::MatrixXd& jacobian)>;

/// Whether residuals say anything of a direction of the parameters, a unit vector in units of `scale`: not if one
/// standard deviation along it, 1/`singular`, is three times as long as the `plausible` sizes of the parameters
/// that it consists of. Parameters of infinite plausible size have no say.
bool is_informed(const Eigen::VectorXd& direction, double singular, const Eigen::VectorXd& scale,
                 const Eigen::VectorXd& plausible);

/// Levenberg-Marquardt in columns scaled to unit norm. Directions that the residuals do not see (singular values
/// below 1e-9 of the largest) stay at their start and are reported, never regularised away. With sizes of the
/// parameters that are `plausible`, a direction of which the residuals are not informed stays at its start, too;
/// covariance and report know it as one that is seen, however badly.
FitReport nonlinear_fit(const ResidualFunction& function, Eigen::Index residuals, const Eigen::VectorXd& start,
                        int iteration_limit = 100, const Eigen::VectorXd& plausible = Eigen::VectorXd());

}  // namespace secular
