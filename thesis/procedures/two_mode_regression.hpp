#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "estimator/regression/linear_fit.hpp"

namespace secular {

/// Ensembles of an additive combination resonance, Omega near w1 + w2.
struct TwoModeData {
  Eigen::VectorXd first, second;         ///< peak amplitudes a1, a2 of the modal displacements
  Eigen::VectorXd forcing;               ///< peak F
  Eigen::VectorXd gamma;                 ///< rad, arg(F conj(A1) conj(A2))
  Eigen::VectorXd excitation_frequency;  ///< rad/s
  std::vector<int> condition;
  double omega1 = 0, omega2 = 0;  ///< rad/s; their sum is where sigma is zero
};

/// The lumped parameters of Table 6.2, in this order.
enum class TwoModeLump {
  mu11,
  mu22,
  mu13,
  mu23,
  gamma5,
  gamma6,
  gamma12,
  linear_sum,   ///< w2 Gamma_1 + w1 Gamma_7
  first_sum,    ///< w2 Gamma_2 + w1 Gamma_9
  second_sum,   ///< w2 Gamma_3 + w1 Gamma_8
  forcing_sum,  ///< w2 Gamma_4 + w1 Gamma_10
  count
};
std::string_view name_of(TwoModeLump lump);

/// One real regression and its fit.
struct RealRegression {
  Eigen::MatrixXd design;
  Eigen::VectorXd response;
  LinearFit fit;
};

struct TwoModeFit {
  RealRegression first, second;  ///< (6.49), (6.50)
  RealRegression combined;       ///< (6.51)
  Eigen::VectorXd lumps, sd;     ///< by TwoModeLump; sd: jackknife over conditions of the whole procedure
};

/// Thesis Eqs. (6.49)-(6.52). Damping rows, from the real parts of the modulation equations at rest in amplitude:
///   a1 = -c1 a1^3 - c2 F a2 sin(gamma) - c3 F a2 cos(gamma), c = (3 w1^2 mu13/8, Gamma_5/w1, Gamma_6/w1)/mu11,
/// its sibling for mode 2 (where (6.50) prints labels of mode 1: all denominators are w2 mu22), then
///   w1 w2 a1 a2 sigma = a1 a2 S1 + a1^3 a2 S2 + a1 a2^3 S3 + a1 a2 F^2 S4 + Ft Gamma_5
/// with Ft of (6.52) and Gamma_11 = Gamma_5. `printed`: the right-hand side of the last one with a minus sign, as
/// (6.40) and (6.51) print it, which turns the sign of every lump and makes both dampings negative. Throws
/// std::invalid_argument for sizes that differ, NumericalFailure for fewer than eight rows or three conditions.
TwoModeFit two_mode_regression(const TwoModeData& data, bool printed);

}  // namespace secular
