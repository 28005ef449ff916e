#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace secular {

/// A straight line through points and how well it is known.
struct StraightLine {
  double intercept = 0, slope = 0;
  double intercept_sd = 0, slope_sd = 0;
  double scatter = 0;             ///< standard deviation about the line
  double excess_sd = 0;           ///< of the scatter, what is beyond the points' own errors
  double degrees_of_freedom = 0;  ///< of the standard deviations, for Student's t; infinite: the points' own errors
  bool clustered = false;         ///< standard deviations from the scatter between records
  double curvature_p = 1;         ///< probability of so large a quadratic term were the line true; 1: not tested
};

/// Covariances of points in a row, of point i with itself and those before it: [i][k] with point i - k.
using Banded = std::vector<std::vector<double>>;

/// Generalised least squares of points whose errors have the covariances `own` + t^2 `excess`. `own` is what noise
/// does to each point; `excess`, of unit variance, is what else may move them. t^2 is nothing where noise explains
/// the residuals r, and otherwise solves r' V^-1 r = points - 2 (R. C. Paule, J. Mandel, Consensus values and
/// weighting factors, J. Res. NBS 87, 1982, eq. 8). `cluster` labels the points of one record, which stand
/// together; with five clusters or more the standard deviations are jackknifed over them. Throws
/// std::invalid_argument for fewer than three points or sizes that differ.
StraightLine straight_line(const Eigen::Ref<const Eigen::VectorXd>& x, const Eigen::Ref<const Eigen::VectorXd>& y,
                           const Banded& own, const Banded& excess, std::span<const int> cluster);

/// A value against amplitude: constant, straight line or parabola, whichever the points give the most evidence.
struct AmplitudeLaw {
  int degree = 0;                      ///< 0, 1, 2
  double coefficients[3] = {0, 0, 0};  ///< of the powers of x
  /// Of the value at zero: its own, and that the other laws may be true, which put it elsewhere.
  double intercept_sd = 0;
  double probability[3] = {1, 0, 0};  ///< of each degree
  double degrees_of_freedom = 0;      ///< of the standard deviation; infinite: the points' own errors
  bool excess = false;                ///< whether the points scatter by more than their own errors
  double at(double x) const { return coefficients[0] + x * (coefficients[1] + x * coefficients[2]); }
  /// Mean square of how far the other laws put the value at zero from `value`, weighted by their probability.
  double others_variance(double value) const;

  double at_zero[3] = {0, 0, 0}, variance[3] = {0, 0, 0};  ///< by degree: value at zero and its own variance
};

/// By Eqs. (M1) to (M4) of docs/inference.md. Points as for straight_line(), five or fewer by a line at most.
/// `change_sd`: standard deviation, before the points are seen, of what each power adds up to the largest x.
AmplitudeLaw amplitude_law(const Eigen::Ref<const Eigen::VectorXd>& x, const Eigen::Ref<const Eigen::VectorXd>& y,
                           const Banded& own, const Banded& excess, std::span<const int> cluster, double change_sd);

}  // namespace secular
