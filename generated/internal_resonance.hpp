// Model internal_resonance: generated code, never edited by hand.
// Holds equations of motion, lumps, what rows are made of. Made by: secular generate internal_resonance.
// Source: Two coupled modes with a potential of fourth degree
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// internal_resonance.one_to_one.hpp: omega2 = omega1 + eps^2*sigma1; Omega = omega1 + eps^2*sigma2
// internal_resonance.one_to_two.hpp: omega2 = 2*omega1 + eps*sigma1; Omega = omega2 + eps*sigma2
// internal_resonance.one_to_three.hpp: omega2 = 3*omega1 + eps^2*sigma1; Omega = omega1 + eps^2*sigma2
// internal_resonance.free_one_to_two.hpp: omega2 = 2*omega1 + eps*sigma1
#pragma once

#include <cstddef>
#include <numbers>

#include "estimator/model/block_functions.hpp"
#include "estimator/model/dense_solve.hpp"
#include "estimator/model/excitation_sample.hpp"
#include "estimator/model/integer_power.hpp"
#include "estimator/model/lane_functions.hpp"
#include "estimator/model/lump_functions.hpp"
#include "estimator/model/scalar_functions.hpp"

namespace secular::generated::internal_resonance {

/// Mass matrix M of the equations of motion M*acceleration + force = 0 below, state-dependent: mass[k * 2 + j]
/// multiplies the acceleration of mode j in equation k.
template <class Scalar, class Parameter, class Sample>
void mass_matrix([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* mass) {
  mass[0] = 1.0;
  mass[1] = 0.0;
  mass[2] = 0.0;
  mass[3] = 1.0;
}

/// Accelerations of the full equations of motion, solved from the state-dependent mass matrix.
/// 0 = omega1^2*x + 2*a2*x*y + b3*x*y^2 + a1*x^2 + 3*b2*x^2*y + b1*x^3 + 2*mu1*D(x) + D2(x) + a3*y^2 + b4*y^3 -
/// e1*F*cos(Omega*t)
/// 0 = 2*a3*x*y + 3*b4*x*y^2 + a2*x^2 + b3*x^2*y + b2*x^3 + omega2^2*y + a4*y^2 + b5*y^3 + 2*mu2*D(y) + D2(y) -
/// e2*F*cos(Omega*t)
/// parameters: [0] omega1, [1] omega2, [2] a1, [3] a2, [4] a3, [5] a4, [6] b1, [7] b2, [8] b3, [9] b4, [10] b5,
/// [11] mu1, [12] e1, [13] mu2, [14] e2. displacement, velocity, acceleration: 2 values.
template <class Scalar, class Parameter, class Sample>
void accelerations([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* acceleration) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b1 = parameters[6];
  const Scalar b2 = parameters[7];
  const Scalar b3 = parameters[8];
  const Scalar b4 = parameters[9];
  const Scalar b5 = parameters[10];
  const Scalar mu1 = parameters[11];
  const Scalar e1 = parameters[12];
  const Scalar mu2 = parameters[13];
  const Scalar e2 = parameters[14];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  acceleration[0] = -(omega1_2 * displacement[0] + 2.0 * a2 * displacement[0] * displacement[1]
      + b3 * displacement[0] * displacement[1] * displacement[1] + a1 * displacement[0] * displacement[0]
      + 3.0 * b2 * displacement[0] * displacement[0] * displacement[1]
      + b1 * displacement[0] * displacement[0] * displacement[0] + 2.0 * mu1 * velocity[0]
      + a3 * displacement[1] * displacement[1] + b4 * displacement[1] * displacement[1] * displacement[1]
      - e1 * excitation[0].value);
  acceleration[1] = -(2.0 * a3 * displacement[0] * displacement[1]
      + 3.0 * b4 * displacement[0] * displacement[1] * displacement[1] + a2 * displacement[0] * displacement[0]
      + b3 * displacement[0] * displacement[0] * displacement[1]
      + b2 * displacement[0] * displacement[0] * displacement[0] + omega2_2 * displacement[1]
      + a4 * displacement[1] * displacement[1] + b5 * displacement[1] * displacement[1] * displacement[1]
      + 2.0 * mu2 * velocity[1] - e2 * excitation[0].value);
}

/// slope[k * 4 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = x, y, D(x), D(y).
/// Of nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x) = 0.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_state([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b1 = parameters[6];
  const Scalar b2 = parameters[7];
  const Scalar b3 = parameters[8];
  const Scalar b4 = parameters[9];
  const Scalar b5 = parameters[10];
  const Scalar mu1 = parameters[11];
  const Scalar mu2 = parameters[13];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  for (std::size_t i = 0; i < 8; ++i) slope[i] = 0.0;
  // equation 1 by x
  slope[0] = -(omega1_2 + 2.0 * a2 * displacement[1] + b3 * displacement[1] * displacement[1]
      + a1 * displacement[0] * 2.0 + 3.0 * b2 * displacement[0] * displacement[1] * 2.0
      + b1 * displacement[0] * displacement[0] * 3.0);
  // equation 1 by y
  slope[1] = -(2.0 * a2 * displacement[0] + b3 * displacement[0] * displacement[1] * 2.0
      + 3.0 * b2 * displacement[0] * displacement[0] + a3 * displacement[1] * 2.0
      + b4 * displacement[1] * displacement[1] * 3.0);
  slope[2] = -(2.0 * mu1);  // equation 1 by D(x)
  // equation 2 by x
  slope[4] = -(2.0 * a3 * displacement[1] + 3.0 * b4 * displacement[1] * displacement[1]
      + a2 * displacement[0] * 2.0 + b3 * displacement[0] * displacement[1] * 2.0
      + b2 * displacement[0] * displacement[0] * 3.0);
  // equation 2 by y
  slope[5] = -(2.0 * a3 * displacement[0] + 3.0 * b4 * displacement[0] * displacement[1] * 2.0
      + b3 * displacement[0] * displacement[0] + omega2_2 + a4 * displacement[1] * 2.0
      + b5 * displacement[1] * displacement[1] * 3.0);
  slope[7] = -(2.0 * mu2);  // equation 2 by D(y)
}

/// slope[k * 15 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = omega1, omega2,
/// a1, a2, a3, a4, b1, b2, b3, b4, b5, mu1, e1, mu2, e2. Of nonsmooth terms the classical derivative: d|x| =
/// sgn(x) dx, zero at the corner, and d sgn(x) = 0.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_parameters([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  for (std::size_t i = 0; i < 30; ++i) slope[i] = 0.0;
  slope[0] = -(2.0 * omega1 * displacement[0]);  // equation 1 by omega1
  slope[2] = -(displacement[0] * displacement[0]);  // equation 1 by a1
  slope[3] = -(2.0 * displacement[0] * displacement[1]);  // equation 1 by a2
  slope[4] = -(displacement[1] * displacement[1]);  // equation 1 by a3
  slope[6] = -(displacement[0] * displacement[0] * displacement[0]);  // equation 1 by b1
  slope[7] = -(3.0 * displacement[0] * displacement[0] * displacement[1]);  // equation 1 by b2
  slope[8] = -(displacement[0] * displacement[1] * displacement[1]);  // equation 1 by b3
  slope[9] = -(displacement[1] * displacement[1] * displacement[1]);  // equation 1 by b4
  slope[11] = -(2.0 * velocity[0]);  // equation 1 by mu1
  slope[12] = -(-excitation[0].value);  // equation 1 by e1
  slope[16] = -(2.0 * omega2 * displacement[1]);  // equation 2 by omega2
  slope[18] = -(displacement[0] * displacement[0]);  // equation 2 by a2
  slope[19] = -(2.0 * displacement[0] * displacement[1]);  // equation 2 by a3
  slope[20] = -(displacement[1] * displacement[1]);  // equation 2 by a4
  slope[22] = -(displacement[0] * displacement[0] * displacement[0]);  // equation 2 by b2
  slope[23] = -(displacement[0] * displacement[0] * displacement[1]);  // equation 2 by b3
  slope[24] = -(3.0 * displacement[0] * displacement[1] * displacement[1]);  // equation 2 by b4
  slope[25] = -(displacement[1] * displacement[1] * displacement[1]);  // equation 2 by b5
  slope[28] = -(2.0 * velocity[1]);  // equation 2 by mu2
  slope[29] = -(-excitation[0].value);  // equation 2 by e2
}

/// Lumps: the parameter combinations that multiply data. Symbols, their powers and the inverses of sums that
/// divide (small divisors) first, each once.
struct Lumps {
  const double omega1, omega2, a1, a2, a3, a4, b1, b2, b3, b4, b5, mu1, e1, mu2, e2;
  const double omega1_2 = omega1 * omega1;
  const double omega1_3 = omega1_2 * omega1;
  const double omega1_4 = omega1_3 * omega1;
  const double omega2_2 = omega2 * omega2;
  const double omega2_3 = omega2_2 * omega2;
  const double omega2_4 = omega2_3 * omega2;
  const double omega2_5 = omega2_4 * omega2;
  const double a1_2 = a1 * a1;
  const double a2_2 = a2 * a2;
  const double a3_2 = a3 * a3;
  const double a4_2 = a4 * a4;
  const double mu1_2 = mu1 * mu1;
  const double mu2_2 = mu2 * mu2;
  const double per_0 = 1.0 / (omega1 - 2.0 * omega2);
  const double per_0_2 = per_0 * per_0;
  const double per_1 = 1.0 / (2.0 * omega1 - omega2);
  const double per_2 = 1.0 / (2.0 * omega1 + omega2);
  const double per_2_2 = per_2 * per_2;
  const double per_3 = 1.0 / (omega1 + 2.0 * omega2);
  const double per_3_2 = per_3 * per_3;
  const double per_4 = 1.0 / (omega1 + 3.0 * omega2);
  const double per_5 = 1.0 / (omega1 - 3.0 * omega2);
  const double per_6 = 1.0 / (omega1 + omega2);
  const double per_6_2 = per_6 * per_6;
  const double per_7 = 1.0 / (3.0 * omega1 + omega2);
  const double per_8 = 1.0 / (3.0 * omega1 - omega2);
  const double per_9 = 1.0 / (omega1 - omega2);
  const double per_9_2 = per_9 * per_9;
  const double over_0 = per_2 * per_1;
  const double over_1 = per_3 * per_0;
  const double over_2 = per_4 * per_5;
  const double over_3 = per_3 * per_4 * per_0 * per_5;
  const double over_4 = per_6 * per_3;
  const double over_5 = per_6 * per_2;
  const double over_6 = per_6 * per_3 * per_0;
  const double over_7 = per_6 * per_7;
  const double over_8 = per_6 * per_2 * per_7;
  const double over_9 = per_6 * per_3 * per_2 * per_1 * per_7;
  const double over_10 = per_6 * per_4;
  const double over_11 = per_6 * per_3 * per_4;
  const double over_12 = per_6 * per_3 * per_4 * per_0 * per_2;
  const double over_13 = per_6 * per_2 * per_1;
  const double over_14 = per_7 * per_8;
  const double over_15 = per_2 * per_1 * per_7 * per_8;
  const double over_16 = per_6 * per_9;
  const double over_17 = per_9 * per_8;
  const double over_18 = per_9 * per_0 * per_8;
  const double over_19 = per_6_2 * per_9_2;
  const double over_20 = per_6 * per_3 * per_9 * per_0;
  const double over_21 = per_6 * per_9 * per_2;
  const double over_22 = per_3_2 * per_0_2;
  const double over_23 = per_9 * per_0;
  const double over_24 = per_3 * per_9 * per_0;
  const double over_25 = per_9 * per_5;
  const double over_26 = per_9 * per_0 * per_5;
  const double over_27 = per_3 * per_9 * per_0 * per_5;
  const double over_28 = per_9 * per_1;
  const double over_29 = per_6 * per_9 * per_2 * per_1;
  const double over_30 = per_9 * per_2 * per_1;
  const double over_31 = per_3 * per_9 * per_0 * per_5 * per_1;

  explicit Lumps(const double* parameters) : omega1(parameters[0]), omega2(parameters[1]), a1(parameters[2]),
      a2(parameters[3]), a3(parameters[4]), a4(parameters[5]), b1(parameters[6]), b2(parameters[7]),
      b3(parameters[8]), b4(parameters[9]), b5(parameters[10]), mu1(parameters[11]), e1(parameters[12]),
      mu2(parameters[13]), e2(parameters[14]) {}

  /// conservative_x_A_x2_conjA_y = (9*omega1^2*b2 + 2*a1*a2)/(6*omega1^3) + 2*a2*a3/(omega1^2*(omega1 - 2*omega2))
  /// - 2*a1*a2/(omega1*omega2*(2*omega1 - omega2)) + a2*a3/(omega1*(2*omega1 + omega2)*(2*omega1 - omega2))
  double lump_conservative_x_A_x2_conjA_y() const {
    return (9.0 * omega1_2 * b2 + 2.0 * a1 * a2) / (6.0 * omega1_3) + 2.0 * a2 * a3 * per_0 / omega1_2
        - 2.0 * a1 * a2 * per_1 / (omega1 * omega2) + a2 * a3 * over_0 / omega1;
  }
  double lump_mu1() const { return mu1; }
  /// conservative_x_A_x_A_y_conjA_y = (omega1^2*omega2^2*b3 - 2*omega1^2*a2*a4 -
  /// 2*omega2^2*a1*a3)/(omega1^3*omega2^2) + 4*a3^2/(omega1*(omega1 + 2*omega2)*(omega1 - 2*omega2)) -
  /// 4*a2^2/(omega1*(2*omega1 + omega2)*(2*omega1 - omega2))
  double lump_conservative_x_A_x_A_y_conjA_y() const {
    return (omega1_2 * omega2_2 * b3 - 2.0 * omega1_2 * a2 * a4 - 2.0 * omega2_2 * a1 * a3) / (omega1_3 * omega2_2)
        + 4.0 * a3_2 * over_1 / omega1 - 4.0 * a2_2 * over_0 / omega1;
  }
  /// conservative_x_A_x2_conjA_x = (9*omega1^2*b1 - 10*a1^2)/(6*omega1^3) + (-8*omega1^2*a2^2 +
  /// 3*omega2^2*a2^2)/(omega1*omega2^2*(2*omega1 + omega2)*(2*omega1 - omega2))
  double lump_conservative_x_A_x2_conjA_x() const {
    return (9.0 * omega1_2 * b1 - 10.0 * a1_2) / (6.0 * omega1_3) + (-8.0 * omega1_2 * a2_2
        + 3.0 * omega2_2 * a2_2) * over_0 / (omega1 * omega2_2);
  }
  double lump_e1() const { return e1; }
  /// conservative_x_A_y2_conjA_y = (9*omega2^2*b4 - 10*a3*a4)/(6*omega1*omega2^2) + (-3*omega1^2*a2*a3 +
  /// 8*omega2^2*a2*a3)/(omega1^3*(omega1 + 2*omega2)*(omega1 - 2*omega2))
  double lump_conservative_x_A_y2_conjA_y() const {
    return (9.0 * omega2_2 * b4 - 10.0 * a3 * a4) / (6.0 * omega1 * omega2_2) + (-3.0 * omega1_2 * a2 * a3
        + 8.0 * omega2_2 * a2 * a3) * over_1 / omega1_3;
  }
  /// conservative_x_A_x_A_y_conjA_x = 3*b2/omega1 + (-2*omega1^2*a2*a3 +
  /// 12*omega2^2*a2*a3)/(omega1*omega2^2*(omega1 + 2*omega2)*(omega1 - 2*omega2)) + (-12*omega1^2*a1*a2 +
  /// 2*omega2^2*a1*a2)/(omega1^3*(2*omega1 + omega2)*(2*omega1 - omega2))
  double lump_conservative_x_A_x_A_y_conjA_x() const {
    return 3.0 * b2 / omega1 + (-2.0 * omega1_2 * a2 * a3
        + 12.0 * omega2_2 * a2 * a3) * over_1 / (omega1 * omega2_2) + (-12.0 * omega1_2 * a1 * a2
        + 2.0 * omega2_2 * a1 * a2) * over_0 / omega1_3;
  }
  /// conservative_x_A_y2_conjA_x = (3*omega2^2*b3 + 2*a2*a4)/(6*omega1*omega2^2) + 2*a3^2/(omega1^2*(omega1 -
  /// 2*omega2)) - 2*a2^2/(omega1*omega2*(2*omega1 - omega2)) - a1*a3/(omega1*(omega1 + 2*omega2)*(omega1 -
  /// 2*omega2))
  double lump_conservative_x_A_y2_conjA_x() const {
    return (3.0 * omega2_2 * b3 + 2.0 * a2 * a4) / (6.0 * omega1 * omega2_2) + 2.0 * a3_2 * per_0 / omega1_2
        - 2.0 * a2_2 * per_1 / (omega1 * omega2) - a1 * a3 * over_1 / omega1;
  }
  /// conservative_y_A_x2_conjA_y = (3*omega1^2*b3 + 2*a1*a3)/(6*omega1^2*omega2) + 2*a3^2/(omega1*omega2*(omega1 -
  /// 2*omega2)) - 2*a2^2/(omega2^2*(2*omega1 - omega2)) + a2*a4/(omega2*(2*omega1 + omega2)*(2*omega1 - omega2))
  double lump_conservative_y_A_x2_conjA_y() const {
    return (3.0 * omega1_2 * b3 + 2.0 * a1 * a3) / (6.0 * omega1_2 * omega2)
        + 2.0 * a3_2 * per_0 / (omega1 * omega2) - 2.0 * a2_2 * per_1 / omega2_2 + a2 * a4 * over_0 / omega2;
  }
  /// conservative_y_A_x_A_y_conjA_y = 3*b4/omega2 + (-2*omega1^2*a3*a4 + 12*omega2^2*a3*a4)/(omega2^3*(omega1 +
  /// 2*omega2)*(omega1 - 2*omega2)) + (-12*omega1^2*a2*a3 + 2*omega2^2*a2*a3)/(omega1^2*omega2*(2*omega1 +
  /// omega2)*(2*omega1 - omega2))
  double lump_conservative_y_A_x_A_y_conjA_y() const {
    return 3.0 * b4 / omega2 + (-2.0 * omega1_2 * a3 * a4 + 12.0 * omega2_2 * a3 * a4) * over_1 / omega2_3
        + (-12.0 * omega1_2 * a2 * a3 + 2.0 * omega2_2 * a2 * a3) * over_0 / (omega1_2 * omega2);
  }
  /// conservative_y_A_x2_conjA_x = (9*omega1^2*b2 - 10*a1*a2)/(6*omega1^2*omega2) + (-8*omega1^2*a2*a3 +
  /// 3*omega2^2*a2*a3)/(omega2^3*(2*omega1 + omega2)*(2*omega1 - omega2))
  double lump_conservative_y_A_x2_conjA_x() const {
    return (9.0 * omega1_2 * b2 - 10.0 * a1 * a2) / (6.0 * omega1_2 * omega2) + (-8.0 * omega1_2 * a2 * a3
        + 3.0 * omega2_2 * a2 * a3) * over_0 / omega2_3;
  }
  double lump_e2() const { return e2; }
  double lump_mu2() const { return mu2; }
  /// conservative_y_A_y2_conjA_y = (9*omega2^2*b5 - 10*a4^2)/(6*omega2^3) + (-3*omega1^2*a3^2 +
  /// 8*omega2^2*a3^2)/(omega1^2*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))
  double lump_conservative_y_A_y2_conjA_y() const {
    return (9.0 * omega2_2 * b5 - 10.0 * a4_2) / (6.0 * omega2_3) + (-3.0 * omega1_2 * a3_2
        + 8.0 * omega2_2 * a3_2) * over_1 / (omega1_2 * omega2);
  }
  /// conservative_y_A_y2_conjA_x = (9*omega2^2*b4 + 2*a3*a4)/(6*omega2^3) + 2*a3*a4/(omega1*omega2*(omega1 -
  /// 2*omega2)) - 2*a2*a3/(omega2^2*(2*omega1 - omega2)) - a2*a3/(omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))
  double lump_conservative_y_A_y2_conjA_x() const {
    return (9.0 * omega2_2 * b4 + 2.0 * a3 * a4) / (6.0 * omega2_3) + 2.0 * a3 * a4 * per_0 / (omega1 * omega2)
        - 2.0 * a2 * a3 * per_1 / omega2_2 - a2 * a3 * over_1 / omega2;
  }
  double lump_a2() const { return a2; }
  double lump_a3() const { return a3; }
  double lump_a1() const { return a1; }
  /// harmonic_re_x_A_y3 = (-3*omega2^2*b4 - 2*a3*a4)/(3*omega2^2*(omega1 + 3*omega2)*(omega1 - 3*omega2)) +
  /// 2*a2*a3/((omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))
  double lump_harmonic_re_x_A_y3() const {
    return (-3.0 * omega2_2 * b4 - 2.0 * a3 * a4) * over_2 / (3.0 * omega2_2) + 2.0 * a2 * a3 * over_3;
  }
  /// harmonic_re_x_A_x_A_y2 = (3*omega2^2*b3 + 2*a2*a4)/(12*omega2^3*(omega1 + omega2)) +
  /// a3^2/(omega1*omega2*(omega1 + omega2)*(omega1 + 2*omega2)) + a2^2/(omega2^2*(omega1 + omega2)*(2*omega1 +
  /// omega2)) - a1*a3/(2*omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - 2*omega2))
  double lump_harmonic_re_x_A_x_A_y2() const {
    return (3.0 * omega2_2 * b3 + 2.0 * a2 * a4) * per_6 / (12.0 * omega2_3) + a3_2 * over_4 / (omega1 * omega2)
        + a2_2 * over_5 / omega2_2 - a1 * a3 * over_6 / (2.0 * omega2);
  }
  /// harmonic_re_x_A_x2_A_y = 3*b2/((omega1 + omega2)*(3*omega1 + omega2)) + (12*omega1^2*a1*a2 +
  /// 4*omega1*omega2*a1*a2 + 2*omega2^2*a1*a2)/(3*omega1^2*omega2*(omega1 + omega2)*(2*omega1 + omega2)*(3*omega1
  /// + omega2)) + (18*omega1^2*a2*a3 + 4*omega1*omega2*a2*a3 - 4*omega2^2*a2*a3)/(omega1*(omega1 + omega2)*(omega1
  /// + 2*omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2))
  double lump_harmonic_re_x_A_x2_A_y() const {
    return 3.0 * b2 * over_7 + (12.0 * omega1_2 * a1 * a2 + 4.0 * omega1 * omega2 * a1 * a2
        + 2.0 * omega2_2 * a1 * a2) * over_8 / (3.0 * omega1_2 * omega2) + (18.0 * omega1_2 * a2 * a3
        + 4.0 * omega1 * omega2 * a2 * a3 - 4.0 * omega2_2 * a2 * a3) * over_9 / omega1;
  }
  /// harmonic_re_x_A_x3 = (3*omega1^2*b1 + 2*a1^2)/(24*omega1^4) + a2^2/(4*omega1^2*(2*omega1 + omega2)*(2*omega1
  /// - omega2))
  double lump_harmonic_re_x_A_x3() const {
    return (3.0 * omega1_2 * b1 + 2.0 * a1_2) / (24.0 * omega1_4) + a2_2 * over_0 / (4.0 * omega1_2);
  }
  double lump_a4() const { return a4; }
  /// harmonic_re_y_A_y3 = (3*omega2^2*b5 + 2*a4^2)/(24*omega2^4) - a3^2/(4*omega2^2*(omega1 + 2*omega2)*(omega1 -
  /// 2*omega2))
  double lump_harmonic_re_y_A_y3() const {
    return (3.0 * omega2_2 * b5 + 2.0 * a4_2) / (24.0 * omega2_4) - a3_2 * over_1 / (4.0 * omega2_2);
  }
  /// harmonic_re_y_A_x_A_y2 = 3*b4/((omega1 + omega2)*(omega1 + 3*omega2)) + (2*omega1^2*a3*a4 +
  /// 4*omega1*omega2*a3*a4 + 12*omega2^2*a3*a4)/(3*omega1*omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 +
  /// 3*omega2)) + (4*omega1^2*a2*a3 - 4*omega1*omega2*a2*a3 - 18*omega2^2*a2*a3)/(omega2*(omega1 + omega2)*(omega1
  /// + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(2*omega1 + omega2))
  double lump_harmonic_re_y_A_x_A_y2() const {
    return 3.0 * b4 * over_10 + (2.0 * omega1_2 * a3 * a4 + 4.0 * omega1 * omega2 * a3 * a4
        + 12.0 * omega2_2 * a3 * a4) * over_11 / (3.0 * omega1 * omega2_2) + (4.0 * omega1_2 * a2 * a3
        - 4.0 * omega1 * omega2 * a2 * a3 - 18.0 * omega2_2 * a2 * a3) * over_12 / omega2;
  }
  /// harmonic_re_y_A_x2_A_y = (3*omega1^2*b3 + 2*a1*a3)/(12*omega1^3*(omega1 + omega2)) + a3^2/(omega1^2*(omega1 +
  /// omega2)*(omega1 + 2*omega2)) + a2^2/(omega1*omega2*(omega1 + omega2)*(2*omega1 + omega2)) +
  /// a2*a4/(2*omega1*(omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))
  double lump_harmonic_re_y_A_x2_A_y() const {
    return (3.0 * omega1_2 * b3 + 2.0 * a1 * a3) * per_6 / (12.0 * omega1_3) + a3_2 * over_4 / omega1_2
        + a2_2 * over_5 / (omega1 * omega2) + a2 * a4 * over_13 / (2.0 * omega1);
  }
  /// harmonic_re_y_A_x3 = (3*omega1^2*b2 + 2*a1*a2)/(3*omega1^2*(3*omega1 + omega2)*(3*omega1 - omega2)) +
  /// 2*a2*a3/((2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2)*(3*omega1 - omega2))
  double lump_harmonic_re_y_A_x3() const {
    return (3.0 * omega1_2 * b2 + 2.0 * a1 * a2) * over_14 / (3.0 * omega1_2) + 2.0 * a2 * a3 * over_15;
  }
  double lump_conservative_x_A_x() const { return -mu1_2 / (2.0 * omega1); }
  /// conservative_x_A_x_A_y_conjA_y = (2*omega1^2*omega2^2*b3 - 4*omega1^2*a2*a4 - 4*omega2^2*a1*a3 +
  /// omega2^2*a2^2)/(2*omega1^3*omega2^2) + 2*a2^2/(omega1*omega2*(2*omega1 + omega2)) + 4*a3^2/(omega1*(omega1 +
  /// 2*omega2)*(omega1 - 2*omega2))
  double lump_conservative_x_A_x_A_y_conjA_y_of_one_to_two() const {
    return (2.0 * omega1_2 * omega2_2 * b3 - 4.0 * omega1_2 * a2 * a4 - 4.0 * omega2_2 * a1 * a3
        + omega2_2 * a2_2) / (2.0 * omega1_3 * omega2_2) + 2.0 * a2_2 * per_2 / (omega1 * omega2)
        + 4.0 * a3_2 * over_1 / omega1;
  }
  /// conservative_x_A_x2_conjA_x = (18*omega1^2*omega2^2*b1 - 24*omega1^2*a2^2 - 3*omega1*omega2*a2^2 -
  /// 20*omega2^2*a1^2)/(12*omega1^3*omega2^2)
  double lump_conservative_x_A_x2_conjA_x_of_one_to_two() const {
    return (18.0 * omega1_2 * omega2_2 * b1 - 24.0 * omega1_2 * a2_2 - 3.0 * omega1 * omega2 * a2_2
        - 20.0 * omega2_2 * a1_2) / (12.0 * omega1_3 * omega2_2);
  }
  double lump_dissipative_x_A_y_conjA_x() const { return a2 * mu2 / (2.0 * omega1_2); }
  /// conservative_x_conjA_x_F = a2*e2/(8*omega1^2*omega2) + a1*e1/(2*omega1*(omega1 + omega2)*(omega1 - omega2))
  double lump_conservative_x_conjA_x_F() const {
    return a2 * e2 / (8.0 * omega1_2 * omega2) + a1 * e1 * over_16 / (2.0 * omega1);
  }
  double lump_dissipative_y_A_x2() const { return (2.0 * a2 * mu1 - a2 * mu2) / (4.0 * omega2_2); }
  double lump_conservative_y_A_y() const { return -mu2_2 / (2.0 * omega2); }
  /// conservative_y_A_x_A_y_conjA_x = (omega1^2*omega2^2*b3 - 2*omega1^2*a2*a4 -
  /// 2*omega2^2*a1*a3)/(omega1^2*omega2^3) + (2*omega1*a2^2 - omega2*a2^2)/(2*omega1*omega2^2*(2*omega1 + omega2))
  /// + 4*a3^2/(omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))
  double lump_conservative_y_A_x_A_y_conjA_x() const {
    return (omega1_2 * omega2_2 * b3 - 2.0 * omega1_2 * a2 * a4 - 2.0 * omega2_2 * a1 * a3) / (omega1_2 * omega2_3)
        + (2.0 * omega1 * a2_2 - omega2 * a2_2) * per_2 / (2.0 * omega1 * omega2_2) + 4.0 * a3_2 * over_1 / omega2;
  }
  double lump_dissipative_y_F() const { return mu2 * e2 / (8.0 * omega2_2); }
  /// harmonic_re_x_A_y_conjA_x2 = (9*omega1^2*b2 + 2*a1*a2)/(3*omega1^2*(omega1 - omega2)*(3*omega1 - omega2)) +
  /// 4*a2*a3/(omega1*(omega1 - omega2)*(omega1 - 2*omega2)*(3*omega1 - omega2))
  double lump_harmonic_re_x_A_y_conjA_x2() const {
    return (9.0 * omega1_2 * b2 + 2.0 * a1 * a2) * over_17 / (3.0 * omega1_2) + 4.0 * a2 * a3 * over_18 / omega1;
  }
  double lump_harmonic_re_x_conjA_y_F() const { return -a2 * e1 * over_16 / omega1_2; }
  double lump_harmonic_im_x_F() const { return -omega2 * mu1 * e1 * over_19; }
  /// harmonic_re_x_A_y2_conjA_y = (-9*omega2^2*b4 + 10*a3*a4)/(3*omega2^2*(omega1 + omega2)*(omega1 - omega2)) +
  /// (6*omega1^2*a2*a3 - 16*omega2^2*a2*a3)/(omega1^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 -
  /// omega2)*(omega1 - 2*omega2))
  double lump_harmonic_re_x_A_y2_conjA_y() const {
    return (-9.0 * omega2_2 * b4 + 10.0 * a3 * a4) * over_16 / (3.0 * omega2_2) + (6.0 * omega1_2 * a2 * a3
        - 16.0 * omega2_2 * a2 * a3) * over_20 / omega1_2;
  }
  /// harmonic_re_x_A_x_A_y_conjA_x = -6*b2/((omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^2*a1*a2 +
  /// 8*omega1*omega2*a1*a2 + 4*omega2^2*a1*a2)/(omega1^2*omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 +
  /// omega2)) + (4*omega1^2*a2*a3 - 24*omega2^2*a2*a3)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 -
  /// omega2)*(omega1 - 2*omega2))
  double lump_harmonic_re_x_A_x_A_y_conjA_x() const {
    return -6.0 * b2 * over_16 + (-4.0 * omega1_2 * a1 * a2 + 8.0 * omega1 * omega2 * a1 * a2
        + 4.0 * omega2_2 * a1 * a2) * over_21 / (omega1_2 * omega2) + (4.0 * omega1_2 * a2 * a3
        - 24.0 * omega2_2 * a2 * a3) * over_20 / omega2_2;
  }
  double lump_harmonic_im_x_A_x2() const { return -4.0 * a1 * mu1 / (9.0 * omega1_3); }
  double lump_harmonic_re_x_A_x2_A_y_of_one_to_two() const { return -4.0 * a2 * a3 * over_22; }
  double lump_harmonic_im_x_A_y2() const { return (4.0 * omega2 * a3 * mu1 - 8.0 * omega2 * a3 * mu2) * over_22; }
  double lump_harmonic_re_x_A_y_F() const { return 2.0 * a3 * e2 * over_22; }
  /// harmonic_re_x_A_y2_conjA_x = (-3*omega2^2*b3 - 2*a2*a4)/(12*omega2^3*(omega1 - omega2)) -
  /// a3^2/(omega1*omega2*(omega1 - omega2)*(omega1 - 2*omega2)) + a1*a3/(2*omega2*(omega1 + 2*omega2)*(omega1 -
  /// omega2)*(omega1 - 2*omega2))
  double lump_harmonic_re_x_A_y2_conjA_x() const {
    return (-3.0 * omega2_2 * b3 - 2.0 * a2 * a4) * per_9 / (12.0 * omega2_3) - a3_2 * over_23 / (omega1 * omega2)
        + a1 * a3 * over_24 / (2.0 * omega2);
  }
  double lump_harmonic_re_x_A_x_F() const { return a1 * e1 * over_21 / omega2; }
  /// harmonic_re_x_A_x3 = (-2*omega1*a2^2 - 2*omega2*a2^2)/(omega2^3*(2*omega1 + omega2)^2)
  double lump_harmonic_re_x_A_x3_of_one_to_two() const {
    return (-2.0 * omega1 * a2_2 - 2.0 * omega2 * a2_2) * per_2_2 / omega2_3;
  }
  /// harmonic_im_y_A_y_conjA_x = (4*omega1*a3*mu1 - 4*omega2*a3*mu1)/(omega1^2*(omega1 - 2*omega2)^2)
  double lump_harmonic_im_y_A_y_conjA_x() const {
    return (4.0 * omega1 * a3 * mu1 - 4.0 * omega2 * a3 * mu1) * per_0_2 / omega1_2;
  }
  /// harmonic_re_y_A_x_A_y_conjA_y = 6*b4/((omega1 + omega2)*(omega1 - omega2)) + (4*omega1^2*a2*a3 -
  /// 8*omega1*omega2*a2*a3 - 4*omega2^2*a2*a3)/(omega1^2*omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 +
  /// omega2)) + (-4*omega1^2*a3*a4 + 24*omega2^2*a3*a4)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 -
  /// omega2)*(omega1 - 2*omega2))
  double lump_harmonic_re_y_A_x_A_y_conjA_y() const {
    return 6.0 * b4 * over_16 + (4.0 * omega1_2 * a2 * a3 - 8.0 * omega1 * omega2 * a2 * a3
        - 4.0 * omega2_2 * a2 * a3) * over_21 / (omega1_2 * omega2) + (-4.0 * omega1_2 * a3 * a4
        + 24.0 * omega2_2 * a3 * a4) * over_20 / omega2_2;
  }
  /// harmonic_re_y_A_x2_conjA_x = (9*omega1^2*omega2^2*b2 - 12*omega1^2*a2*a3 -
  /// 10*omega2^2*a1*a2)/(3*omega1^2*omega2^2*(omega1 + omega2)*(omega1 - omega2))
  double lump_harmonic_re_y_A_x2_conjA_x() const {
    return (9.0 * omega1_2 * omega2_2 * b2 - 12.0 * omega1_2 * a2 * a3
        - 10.0 * omega2_2 * a1 * a2) * over_16 / (3.0 * omega1_2 * omega2_2);
  }
  /// harmonic_re_y_A_y_conjA_x2 = (3*omega1^2*b3 + 2*a1*a3)/(12*omega1^3*(omega1 - omega2)) +
  /// a3^2/(omega1^2*(omega1 - omega2)*(omega1 - 2*omega2))
  double lump_harmonic_re_y_A_y_conjA_x2() const {
    return (3.0 * omega1_2 * b3 + 2.0 * a1 * a3) * per_9 / (12.0 * omega1_3) + a3_2 * over_23 / omega1_2;
  }
  double lump_harmonic_re_y_conjA_y_F() const { return -a3 * e1 * over_16 / omega2_2; }
  double lump_harmonic_re_y_A_x2_A_y_of_one_to_two() const { return -4.0 * a2 * a4 / (9.0 * omega2_4); }
  double lump_harmonic_im_y_A_y2() const { return -4.0 * a4 * mu2 / (9.0 * omega2_3); }
  double lump_harmonic_re_y_A_y_F() const { return 2.0 * a4 * e2 / (9.0 * omega2_4); }
  /// harmonic_re_y_A_y2_conjA_x = 3*b4/((omega1 - omega2)*(omega1 - 3*omega2)) + (2*omega1^2*a3*a4 -
  /// 4*omega1*omega2*a3*a4 + 12*omega2^2*a3*a4)/(3*omega1*omega2^2*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 -
  /// 3*omega2)) - 2*a2*a3/((omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))
  double lump_harmonic_re_y_A_y2_conjA_x() const {
    return 3.0 * b4 * over_25 + (2.0 * omega1_2 * a3 * a4 - 4.0 * omega1 * omega2 * a3 * a4
        + 12.0 * omega2_2 * a3 * a4) * over_26 / (3.0 * omega1 * omega2_2) - 2.0 * a2 * a3 * over_27;
  }
  /// harmonic_re_y_A_x3 = (3*omega1^2*b2 + 2*a1*a2)/(3*omega1^2*(3*omega1 + omega2)*(3*omega1 - omega2))
  double lump_harmonic_re_y_A_x3_of_one_to_two() const {
    return (3.0 * omega1_2 * b2 + 2.0 * a1 * a2) * over_14 / (3.0 * omega1_2);
  }
  /// conservative_x_A_y_conjA_x2 = (9*omega1^2*b2 + 2*a1*a2)/(6*omega1^3) + 2*a2*a3/(omega1^2*(omega1 - 2*omega2))
  /// - 2*a1*a2/(omega1*omega2*(2*omega1 - omega2)) + a2*a3/(omega1*(2*omega1 + omega2)*(2*omega1 - omega2))
  double lump_conservative_x_A_y_conjA_x2() const {
    return (9.0 * omega1_2 * b2 + 2.0 * a1 * a2) / (6.0 * omega1_3) + 2.0 * a2 * a3 * per_0 / omega1_2
        - 2.0 * a1 * a2 * per_1 / (omega1 * omega2) + a2 * a3 * over_0 / omega1;
  }
  /// conservative_y_A_x3 = (3*omega1^2*b2 + 2*a1*a2)/(6*omega1^2*omega2) + a2*a3/(omega2*(2*omega1 +
  /// omega2)*(2*omega1 - omega2))
  double lump_conservative_y_A_x3() const {
    return (3.0 * omega1_2 * b2 + 2.0 * a1 * a2) / (6.0 * omega1_2 * omega2) + a2 * a3 * over_0 / omega2;
  }
  /// harmonic_re_x_A_y2_conjA_x = (-3*omega2^2*b3 - 2*a2*a4)/(12*omega2^3*(omega1 - omega2)) -
  /// a3^2/(omega1*omega2*(omega1 - omega2)*(omega1 - 2*omega2)) + a2^2/(omega2^2*(omega1 - omega2)*(2*omega1 -
  /// omega2)) + a1*a3/(2*omega2*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))
  double lump_harmonic_re_x_A_y2_conjA_x_of_one_to_three() const {
    return (-3.0 * omega2_2 * b3 - 2.0 * a2 * a4) * per_9 / (12.0 * omega2_3) - a3_2 * over_23 / (omega1 * omega2)
        + a2_2 * over_28 / omega2_2 + a1 * a3 * over_24 / (2.0 * omega2);
  }
  /// harmonic_re_x_A_x_A_y_conjA_x = -6*b2/((omega1 + omega2)*(omega1 - omega2)) + (4*omega1^2*a2*a3 -
  /// 24*omega2^2*a2*a3)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) +
  /// (24*omega1^2*a1*a2 - 4*omega2^2*a1*a2)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 +
  /// omega2)*(2*omega1 - omega2))
  double lump_harmonic_re_x_A_x_A_y_conjA_x_of_one_to_three() const {
    return -6.0 * b2 * over_16 + (4.0 * omega1_2 * a2 * a3 - 24.0 * omega2_2 * a2 * a3) * over_20 / omega2_2
        + (24.0 * omega1_2 * a1 * a2 - 4.0 * omega2_2 * a1 * a2) * over_29 / omega1_2;
  }
  /// harmonic_re_y_A_y_conjA_x2 = (3*omega1^2*b3 + 2*a1*a3)/(12*omega1^3*(omega1 - omega2)) +
  /// a3^2/(omega1^2*(omega1 - omega2)*(omega1 - 2*omega2)) - a2^2/(omega1*omega2*(omega1 - omega2)*(2*omega1 -
  /// omega2)) + a2*a4/(2*omega1*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))
  double lump_harmonic_re_y_A_y_conjA_x2_of_one_to_three() const {
    return (3.0 * omega1_2 * b3 + 2.0 * a1 * a3) * per_9 / (12.0 * omega1_3) + a3_2 * over_23 / omega1_2
        - a2_2 * over_28 / (omega1 * omega2) + a2 * a4 * over_30 / (2.0 * omega1);
  }
  /// harmonic_re_y_A_x_A_y_conjA_y = 6*b4/((omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^2*a3*a4 +
  /// 24*omega2^2*a3*a4)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) +
  /// (-24*omega1^2*a2*a3 + 4*omega2^2*a2*a3)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 +
  /// omega2)*(2*omega1 - omega2))
  double lump_harmonic_re_y_A_x_A_y_conjA_y_of_one_to_three() const {
    return 6.0 * b4 * over_16 + (-4.0 * omega1_2 * a3 * a4 + 24.0 * omega2_2 * a3 * a4) * over_20 / omega2_2
        + (-24.0 * omega1_2 * a2 * a3 + 4.0 * omega2_2 * a2 * a3) * over_29 / omega1_2;
  }
  /// harmonic_re_y_A_x2_conjA_x = (9*omega1^2*b2 - 10*a1*a2)/(3*omega1^2*(omega1 + omega2)*(omega1 - omega2)) +
  /// (-16*omega1^2*a2*a3 + 6*omega2^2*a2*a3)/(omega2^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 +
  /// omega2)*(2*omega1 - omega2))
  double lump_harmonic_re_y_A_x2_conjA_x_of_one_to_three() const {
    return (9.0 * omega1_2 * b2 - 10.0 * a1 * a2) * over_16 / (3.0 * omega1_2) + (-16.0 * omega1_2 * a2 * a3
        + 6.0 * omega2_2 * a2 * a3) * over_29 / omega2_2;
  }
  /// harmonic_re_y_A_y2_conjA_x = 3*b4/((omega1 - omega2)*(omega1 - 3*omega2)) + (2*omega1^2*a3*a4 -
  /// 4*omega1*omega2*a3*a4 + 12*omega2^2*a3*a4)/(3*omega1*omega2^2*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 -
  /// 3*omega2)) + (-4*omega1^2*a2*a3 - 4*omega1*omega2*a2*a3 + 18*omega2^2*a2*a3)/(omega2*(omega1 +
  /// 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)*(2*omega1 - omega2))
  double lump_harmonic_re_y_A_y2_conjA_x_of_one_to_three() const {
    return 3.0 * b4 * over_25 + (2.0 * omega1_2 * a3 * a4 - 4.0 * omega1 * omega2 * a3 * a4
        + 12.0 * omega2_2 * a3 * a4) * over_26 / (3.0 * omega1 * omega2_2) + (-4.0 * omega1_2 * a2 * a3
        - 4.0 * omega1 * omega2 * a2 * a3 + 18.0 * omega2_2 * a2 * a3) * over_31 / omega2;
  }

  /// By their numbers in the tables.
  static constexpr double (Lumps::*list[])() const = {&Lumps::lump_conservative_x_A_x2_conjA_y, &Lumps::lump_mu1,
      &Lumps::lump_conservative_x_A_x_A_y_conjA_y, &Lumps::lump_conservative_x_A_x2_conjA_x, &Lumps::lump_e1,
      &Lumps::lump_conservative_x_A_y2_conjA_y, &Lumps::lump_conservative_x_A_x_A_y_conjA_x,
      &Lumps::lump_conservative_x_A_y2_conjA_x, &Lumps::lump_conservative_y_A_x2_conjA_y,
      &Lumps::lump_conservative_y_A_x_A_y_conjA_y, &Lumps::lump_conservative_y_A_x2_conjA_x, &Lumps::lump_e2,
      &Lumps::lump_mu2, &Lumps::lump_conservative_y_A_y2_conjA_y, &Lumps::lump_conservative_y_A_y2_conjA_x,
      &Lumps::lump_a2, &Lumps::lump_a3, &Lumps::lump_a1, &Lumps::lump_harmonic_re_x_A_y3,
      &Lumps::lump_harmonic_re_x_A_x_A_y2, &Lumps::lump_harmonic_re_x_A_x2_A_y, &Lumps::lump_harmonic_re_x_A_x3,
      &Lumps::lump_a4, &Lumps::lump_harmonic_re_y_A_y3, &Lumps::lump_harmonic_re_y_A_x_A_y2,
      &Lumps::lump_harmonic_re_y_A_x2_A_y, &Lumps::lump_harmonic_re_y_A_x3, &Lumps::lump_conservative_x_A_x,
      &Lumps::lump_conservative_x_A_x_A_y_conjA_y_of_one_to_two,
      &Lumps::lump_conservative_x_A_x2_conjA_x_of_one_to_two, &Lumps::lump_dissipative_x_A_y_conjA_x,
      &Lumps::lump_conservative_x_conjA_x_F, &Lumps::lump_dissipative_y_A_x2, &Lumps::lump_conservative_y_A_y,
      &Lumps::lump_conservative_y_A_x_A_y_conjA_x, &Lumps::lump_dissipative_y_F,
      &Lumps::lump_harmonic_re_x_A_y_conjA_x2, &Lumps::lump_harmonic_re_x_conjA_y_F, &Lumps::lump_harmonic_im_x_F,
      &Lumps::lump_harmonic_re_x_A_y2_conjA_y, &Lumps::lump_harmonic_re_x_A_x_A_y_conjA_x,
      &Lumps::lump_harmonic_im_x_A_x2, &Lumps::lump_harmonic_re_x_A_x2_A_y_of_one_to_two,
      &Lumps::lump_harmonic_im_x_A_y2, &Lumps::lump_harmonic_re_x_A_y_F, &Lumps::lump_harmonic_re_x_A_y2_conjA_x,
      &Lumps::lump_harmonic_re_x_A_x_F, &Lumps::lump_harmonic_re_x_A_x3_of_one_to_two,
      &Lumps::lump_harmonic_im_y_A_y_conjA_x, &Lumps::lump_harmonic_re_y_A_x_A_y_conjA_y,
      &Lumps::lump_harmonic_re_y_A_x2_conjA_x, &Lumps::lump_harmonic_re_y_A_y_conjA_x2,
      &Lumps::lump_harmonic_re_y_conjA_y_F, &Lumps::lump_harmonic_re_y_A_x2_A_y_of_one_to_two,
      &Lumps::lump_harmonic_im_y_A_y2, &Lumps::lump_harmonic_re_y_A_y_F, &Lumps::lump_harmonic_re_y_A_y2_conjA_x,
      &Lumps::lump_harmonic_re_y_A_x3_of_one_to_two, &Lumps::lump_conservative_x_A_y_conjA_x2,
      &Lumps::lump_conservative_y_A_x3, &Lumps::lump_harmonic_re_x_A_y2_conjA_x_of_one_to_three,
      &Lumps::lump_harmonic_re_x_A_x_A_y_conjA_x_of_one_to_three,
      &Lumps::lump_harmonic_re_y_A_y_conjA_x2_of_one_to_three,
      &Lumps::lump_harmonic_re_y_A_x_A_y_conjA_y_of_one_to_three,
      &Lumps::lump_harmonic_re_y_A_x2_conjA_x_of_one_to_three,
      &Lumps::lump_harmonic_re_y_A_y2_conjA_x_of_one_to_three};
};

/// What rows are functions of: frequencies, and signals, which are amplitudes A, their conjugates, norms |A|^2
/// and moduli, and the excitation.
struct Model {
  static constexpr std::size_t modes = 2, excitations = 1;

  template <class Number>
  struct Frequencies {
    const Number omega1, omega2, Omega;
    Frequencies(const Number* natural, [[maybe_unused]] const Number* excitation) : omega1(natural[0]),
        omega2(natural[1]), Omega(excitation[0]) {}
  };

  template <class Number>
  struct Signals {
    using Complex = ComplexNumber<Number>;
    const Complex A_x;
    const Complex conj_A_x = conjugate(A_x);
    const Number norm_A_x = norm_of(A_x);
    const Complex A_y;
    const Complex conj_A_y = conjugate(A_y);
    const Number norm_A_y = norm_of(A_y);
    const Complex F;
    const Complex conj_F = conjugate(F);
    Signals(const Complex* amplitude, [[maybe_unused]] const Complex* forcing) : A_x(amplitude[0]),
        A_y(amplitude[1]), F(forcing[0]) {}
  };
};

}  // namespace secular::generated::internal_resonance
