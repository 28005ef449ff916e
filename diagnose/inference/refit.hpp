#pragma once

#include <Eigen/Core>
#include <vector>

#include "diagnose/evidence/discrepancy.hpp"
#include "numerics/solver_ending.hpp"

namespace secular {

/// Chi-squared to first order, in variances of the rows about the fit, that a free step from the end of a converged
/// one may still promise at most: explanations are compared in these variances, and none by so little.
inline constexpr double promise_kept = 0.1;

/// Share of an unknown in a direction of columns of unit length below which it has no part in it.
inline constexpr double least_part_of_direction = 1e-3;

/// Least squares over some of the unknowns.
struct Refit {
  Eigen::VectorXd unknowns;
  Eigen::VectorXd rows;  ///< at the end
  double chi_squared = 0;
  std::vector<std::size_t> free;  ///< unknowns that were fitted
  Eigen::VectorXd scale;          ///< by free unknown: a change of it that moves the rows by about one
  Eigen::MatrixXd jacobian;       ///< rows x free, per scaled unknown
  Eigen::Index rank = 0;
  Eigen::MatrixXd covariance;  ///< of the free unknowns, for rows of unit variance; identifiable directions only
  std::vector<bool> identifiable;  ///< by free unknown
  /// Converged: no step that the slopes promise is worth anything. Stalled: steps that promise something do not
  /// bring it, or there were too many.
  SolverEnding ending = SolverEnding::stalled;
};

/// Unknowns after a step of those that are free, in units of their scales.
Eigen::VectorXd unknowns_after(const Refit& fit, Eigen::VectorXd unknowns, const Eigen::VectorXd& step);

/// Variance of rows about a fit, with this many degrees of freedom: what it leaves, or that of repeatability where
/// it leaves less.
double dispersion_of(double chi_squared, double freedom);

struct RefitOptions {
  int iterations = 25;
  bool bends = false;  ///< steps follow the second derivative of the rows: one evaluation more each
  unsigned threads = 1;
  double damping = 0;           ///< at first: holds back what the rows hardly see, far from the goal
  Eigen::VectorXd scale_guess;  ///< of unit_slopes
};

/// Slopes of the rows, per change of each unknown that moves them by one standard deviation in all.
struct UnitSlopes {
  Eigen::VectorXd scale;    ///< that change; 0 where nothing moves the rows
  Eigen::MatrixXd columns;  ///< rows x unknowns, of unit length
};

/// `guess`: scales to begin with, by unknown of the discrepancy, 0 where none is known; or empty.
UnitSlopes unit_slopes(const Discrepancy& discrepancy, const Eigen::VectorXd& unknowns,
                       const std::vector<std::size_t>& which, const Eigen::VectorXd& guess, unsigned threads);

/// Levenberg-Marquardt with differences. Directions that the rows do not see stay where they start.
Refit refit(const Discrepancy& discrepancy, const Eigen::VectorXd& start, const std::vector<std::size_t>& free,
            const RefitOptions& options = {});

}  // namespace secular
