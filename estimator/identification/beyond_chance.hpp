#pragma once

#include <Eigen/Core>

namespace secular {

/// The unknown `at` of least squares whose rows have unit variance, or scatter by more, shrunk to zero where chance
/// makes as much (level `contradiction_alarm`), docs/inference.md (56), (73): k sqrt(max(0, 1 - F var k/k^2)), with
/// that root times sqrt(`trusted`). matrix: rows x unknowns, of full column rank; `freedom`: degrees of freedom.
double beyond_chance(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& target, Eigen::Index at, double freedom,
                     double trusted = 1);

}  // namespace secular
