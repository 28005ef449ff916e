#pragma once

#include <Eigen/Core>
#include <complex>
#include <optional>
#include <vector>

#include "estimator/identification/phase_problem.hpp"

namespace secular {

/// A minimum of docs/inference.md (17) at the measured noise.
struct PhaseFit {
  std::vector<double> ahead;            ///< by record: what the excitation has to be put ahead by
  std::vector<double> sd;               ///< of these; infinite where nothing tells a phase
  double f = 0, p_value = 1;            ///< (18)
  double sum_of_squares = 0, left = 0;  ///< of what phases leave, and its degrees of freedom
  /// By record: what a phase a radian ahead does to the modulation equation (balance of energy, of frequency).
  std::vector<std::complex<double>> effect;
  Eigen::VectorXd coefficient;   ///< by column of the regression
  Eigen::VectorXd contribution;  ///< by column: its size in all rows, in units of their noise
};

/// The minima that Gauss-Newton steps reach from the `starts` and the measured noise does not tell apart, the
/// lowest first.
std::vector<PhaseFit> equal_minima(const PhaseProblem& problem, const std::vector<std::vector<double>>& starts);

/// The minimum that Gauss-Newton steps reach from the phases that the set holds; nothing where they do not come to
/// rest.
std::optional<PhaseFit> nearest_minimum(const PhaseProblem& problem);

/// The observations with phases that are marked as unknown.
ObservationSet with_phases(const PhaseProblem& problem, const std::vector<double>& ahead);

}  // namespace secular
