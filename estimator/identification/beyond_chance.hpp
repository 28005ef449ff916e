#pragma once

#include <Eigen/Core>

namespace secular {

/// docs/inference.md (79): how much of a finding counts, 0 where chance makes its `ratio` F (of 1 and `freedom`
/// degrees of freedom, or `numerator` of them) with the probability `alarm`, and nearly 1 where it hardly ever
/// does: of chance findings beyond the alarm, the share that is weaker.
double beyond_chance(double ratio, double freedom, double alarm, double numerator = 1);

/// The unknown `at` of least squares whose rows have unit variance, or scatter by more, shrunk to zero where chance
/// makes as much (level `contradiction_alarm`), docs/inference.md (56), (73), (79), and times sqrt(`trusted`).
/// matrix: rows x unknowns, of full column rank; `freedom`: degrees of freedom.
double beyond_chance(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& target, Eigen::Index at, double freedom,
                     double trusted = 1);

}  // namespace secular
