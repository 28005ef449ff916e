// Model parametric_pair: generated code, never edited by hand.
// Holds equations of motion, lumps, what rows are made of. Made by: secular generate parametric_pair.
// Source: Two linear modes with parametric coupling and cubic stiffness
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// parametric_pair.additive.hpp: Omega = omega1 + omega2 + eps*sigma
// parametric_pair.additive_second_order.hpp: Omega = omega1 + omega2 + eps*sigma
// parametric_pair.difference.hpp: Omega = omega2 - omega1 + eps*sigma
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

namespace secular::generated::parametric_pair {

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
/// 0 = omega1^2*x + b3*x*y^2 + b1*x^3 + 2*mu1*D(x) + D2(x) - p*y*F*cos(Omega*t)
/// 0 = -q*x*F*cos(Omega*t) + b3*x^2*y + omega2^2*y + b5*y^3 + 2*mu2*D(y) + D2(y)
/// parameters: [0] omega1, [1] omega2, [2] mu1, [3] b1, [4] b3, [5] p, [6] mu2, [7] b5, [8] q. displacement,
/// velocity, acceleration: 2 values.
template <class Scalar, class Parameter, class Sample>
void accelerations([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* acceleration) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu1 = parameters[2];
  const Scalar b1 = parameters[3];
  const Scalar b3 = parameters[4];
  const Scalar p = parameters[5];
  const Scalar mu2 = parameters[6];
  const Scalar b5 = parameters[7];
  const Scalar q = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  acceleration[0] = -(omega1_2 * displacement[0] + b3 * displacement[0] * displacement[1] * displacement[1]
      + b1 * displacement[0] * displacement[0] * displacement[0] + 2.0 * mu1 * velocity[0]
      - p * displacement[1] * excitation[0].value);
  acceleration[1] = -(-q * displacement[0] * excitation[0].value
      + b3 * displacement[0] * displacement[0] * displacement[1] + omega2_2 * displacement[1]
      + b5 * displacement[1] * displacement[1] * displacement[1] + 2.0 * mu2 * velocity[1]);
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
  const Scalar mu1 = parameters[2];
  const Scalar b1 = parameters[3];
  const Scalar b3 = parameters[4];
  const Scalar p = parameters[5];
  const Scalar mu2 = parameters[6];
  const Scalar b5 = parameters[7];
  const Scalar q = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  for (std::size_t i = 0; i < 8; ++i) slope[i] = 0.0;
  // equation 1 by x
  slope[0] = -(omega1_2 + b3 * displacement[1] * displacement[1] + b1 * displacement[0] * displacement[0] * 3.0);
  slope[1] = -(b3 * displacement[0] * displacement[1] * 2.0 - p * excitation[0].value);  // equation 1 by y
  slope[2] = -(2.0 * mu1);  // equation 1 by D(x)
  slope[4] = -(-q * excitation[0].value + b3 * displacement[0] * displacement[1] * 2.0);  // equation 2 by x
  // equation 2 by y
  slope[5] = -(b3 * displacement[0] * displacement[0] + omega2_2 + b5 * displacement[1] * displacement[1] * 3.0);
  slope[7] = -(2.0 * mu2);  // equation 2 by D(y)
}

/// slope[k * 9 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = omega1, omega2,
/// mu1, b1, b3, p, mu2, b5, q. Of nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the
/// corner, and d sgn(x) = 0.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_parameters([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  for (std::size_t i = 0; i < 18; ++i) slope[i] = 0.0;
  slope[0] = -(2.0 * omega1 * displacement[0]);  // equation 1 by omega1
  slope[2] = -(2.0 * velocity[0]);  // equation 1 by mu1
  slope[3] = -(displacement[0] * displacement[0] * displacement[0]);  // equation 1 by b1
  slope[4] = -(displacement[0] * displacement[1] * displacement[1]);  // equation 1 by b3
  slope[5] = -(-displacement[1] * excitation[0].value);  // equation 1 by p
  slope[10] = -(2.0 * omega2 * displacement[1]);  // equation 2 by omega2
  slope[13] = -(displacement[0] * displacement[0] * displacement[1]);  // equation 2 by b3
  slope[15] = -(2.0 * velocity[1]);  // equation 2 by mu2
  slope[16] = -(displacement[1] * displacement[1] * displacement[1]);  // equation 2 by b5
  slope[17] = -(-displacement[0] * excitation[0].value);  // equation 2 by q
}

/// Lumps: the parameter combinations that multiply data. Symbols, their powers and the inverses of sums that
/// divide (small divisors) first, each once.
struct Lumps {
  const double omega1, omega2, mu1, b1, b3, p, mu2, b5, q;
  const double omega1_2 = omega1 * omega1;
  const double omega1_3 = omega1_2 * omega1;
  const double omega1_4 = omega1_3 * omega1;
  const double omega2_2 = omega2 * omega2;
  const double omega2_3 = omega2_2 * omega2;
  const double omega2_4 = omega2_3 * omega2;
  const double mu1_2 = mu1 * mu1;
  const double b1_2 = b1 * b1;
  const double b3_2 = b3 * b3;
  const double mu2_2 = mu2 * mu2;
  const double b5_2 = b5 * b5;
  const double per_0 = 1.0 / (omega1 + omega2);
  const double per_0_2 = per_0 * per_0;
  const double per_1 = 1.0 / (omega1 - omega2);
  const double per_1_2 = per_1 * per_1;
  const double per_2 = 1.0 / (2.0 * omega1 - omega2);
  const double per_3 = 1.0 / (omega1 - 2.0 * omega2);
  const double per_4 = 1.0 / (omega1 + 2.0 * omega2);
  const double per_5 = 1.0 / (2.0 * omega1 + omega2);
  const double over_0 = per_0 * per_1;
  const double over_1 = per_0 * per_1_2;
  const double over_2 = per_0_2 * per_1;
  const double over_3 = per_1_2 * per_2;
  const double over_4 = per_1 * per_3;
  const double over_5 = per_0 * per_4;
  const double over_6 = per_0_2 * per_5;
  const double over_7 = per_1_2 * per_3;
  const double over_8 = per_0_2 * per_4;
  const double over_9 = per_0 * per_5;
  const double over_10 = per_1 * per_2;

  explicit Lumps(const double* parameters) : omega1(parameters[0]), omega2(parameters[1]), mu1(parameters[2]),
      b1(parameters[3]), b3(parameters[4]), p(parameters[5]), mu2(parameters[6]), b5(parameters[7]),
      q(parameters[8]) {}

  double lump_mu1() const { return mu1; }
  double lump_b3() const { return b3; }
  double lump_b1() const { return b1; }
  double lump_p() const { return p; }
  double lump_mu2() const { return mu2; }
  double lump_b5() const { return b5; }
  double lump_q() const { return q; }
  /// conservative_x_A_x2_A_y_F = (-2*omega1*b3*q - 3*omega2*b1*p)/(16*omega1^3*omega2) - b3*p/(16*omega1^2*(omega1
  /// + omega2))
  double lump_conservative_x_A_x2_A_y_F() const {
    return (-2.0 * omega1 * b3 * q - 3.0 * omega2 * b1 * p) / (16.0 * omega1_3 * omega2)
        - b3 * p * per_0 / (16.0 * omega1_2);
  }
  double lump_conservative_x_A_x() const { return -mu1_2 / (2.0 * omega1); }
  /// conservative_x_A_x_F2 = (omega1*p*q + 2*omega2*p*q)/(32*omega1^2*omega2*(omega1 + omega2))
  double lump_conservative_x_A_x_F2() const {
    return (omega1 * p * q + 2.0 * omega2 * p * q) * per_0 / (32.0 * omega1_2 * omega2);
  }
  double lump_dissipative_x_A_x_A_y_conjA_y() const { return b3 * mu2 / omega1_2; }
  /// conservative_x_A_x_A_y2_conjA_y2 = (-3*omega1^2*b3^2 + 2*omega2^2*b3^2)/(4*omega1^3*(omega1 + omega2)*(omega1
  /// - omega2))
  double lump_conservative_x_A_x_A_y2_conjA_y2() const {
    return (-3.0 * omega1_2 * b3_2 + 2.0 * omega2_2 * b3_2) * over_0 / (4.0 * omega1_3);
  }
  double lump_dissipative_x_A_x2_conjA_x() const { return 3.0 * mu1 * b1 / (2.0 * omega1_2); }
  /// conservative_x_A_x2_A_y_conjA_x_conjA_y = -3*b1*b3/(2*omega1^3) + b3^2/(2*omega1*(omega1 + omega2)*(omega1 -
  /// omega2))
  double lump_conservative_x_A_x2_A_y_conjA_x_conjA_y() const {
    return -3.0 * b1 * b3 / (2.0 * omega1_3) + b3_2 * over_0 / (2.0 * omega1);
  }
  double lump_conservative_x_A_x3_conjA_x2() const { return -15.0 * b1_2 / (16.0 * omega1_3); }
  double lump_dissipative_x_conjA_y_F() const { return (mu1 * p - p * mu2) / (8.0 * omega1_2); }
  /// conservative_x_A_y_conjA_y2_F = (-3*omega1*p*b5 + 2*omega2*b3*p)/(16*omega1^3*omega2) -
  /// b3*p/(16*omega1*omega2*(omega1 + omega2))
  double lump_conservative_x_A_y_conjA_y2_F() const {
    return (-3.0 * omega1 * p * b5 + 2.0 * omega2 * b3 * p) / (16.0 * omega1_3 * omega2)
        - b3 * p * per_0 / (16.0 * omega1 * omega2);
  }
  /// conservative_x_A_x_conjA_x_conjA_y_F = (-omega1*b3*p + 3*omega2*b1*p)/(8*omega1^3*omega2) +
  /// b3*q/(8*omega1*omega2*(omega1 + omega2))
  double lump_conservative_x_A_x_conjA_x_conjA_y_F() const {
    return (-omega1 * b3 * p + 3.0 * omega2 * b1 * p) / (8.0 * omega1_3 * omega2)
        + b3 * q * per_0 / (8.0 * omega1 * omega2);
  }
  /// conservative_y_A_x_A_y2_F = (-3*omega1*b5*q - 2*omega2*b3*p)/(16*omega1*omega2^3) - b3*q/(16*omega2^2*(omega1
  /// + omega2))
  double lump_conservative_y_A_x_A_y2_F() const {
    return (-3.0 * omega1 * b5 * q - 2.0 * omega2 * b3 * p) / (16.0 * omega1 * omega2_3)
        - b3 * q * per_0 / (16.0 * omega2_2);
  }
  double lump_conservative_y_A_y() const { return -mu2_2 / (2.0 * omega2); }
  double lump_dissipative_y_A_y2_conjA_y() const { return 3.0 * mu2 * b5 / (2.0 * omega2_2); }
  double lump_conservative_y_A_y3_conjA_y2() const { return -15.0 * b5_2 / (16.0 * omega2_3); }
  double lump_dissipative_y_A_x_A_y_conjA_x() const { return mu1 * b3 / omega2_2; }
  /// conservative_y_A_x_A_y2_conjA_x_conjA_y = -3*b3*b5/(2*omega2^3) - b3^2/(2*omega2*(omega1 + omega2)*(omega1 -
  /// omega2))
  double lump_conservative_y_A_x_A_y2_conjA_x_conjA_y() const {
    return -3.0 * b3 * b5 / (2.0 * omega2_3) - b3_2 * over_0 / (2.0 * omega2);
  }
  double lump_dissipative_y_conjA_x_F() const { return (-mu1 * q + mu2 * q) / (8.0 * omega2_2); }
  /// conservative_y_A_y_conjA_x_conjA_y_F = (3*omega1*b5*q - omega2*b3*q)/(8*omega1*omega2^3) +
  /// b3*p/(8*omega1*omega2*(omega1 + omega2))
  double lump_conservative_y_A_y_conjA_x_conjA_y_F() const {
    return (3.0 * omega1 * b5 * q - omega2 * b3 * q) / (8.0 * omega1 * omega2_3)
        + b3 * p * per_0 / (8.0 * omega1 * omega2);
  }
  /// conservative_y_A_x_conjA_x2_F = (2*omega1*b3*q - 3*omega2*b1*q)/(16*omega1*omega2^3) -
  /// b3*q/(16*omega1*omega2*(omega1 + omega2))
  double lump_conservative_y_A_x_conjA_x2_F() const {
    return (2.0 * omega1 * b3 * q - 3.0 * omega2 * b1 * q) / (16.0 * omega1 * omega2_3)
        - b3 * q * per_0 / (16.0 * omega1 * omega2);
  }
  /// harmonic_re_x_A_y_conjA_x2_F = b3*p/(32*omega1*omega2*(omega1 - omega2)^2) + 3*b1*p/(32*omega2^2*(omega1 +
  /// omega2)*(omega1 - omega2))
  double lump_harmonic_re_x_A_y_conjA_x2_F() const {
    return b3 * p * per_1_2 / (32.0 * omega1 * omega2) + 3.0 * b1 * p * over_0 / (32.0 * omega2_2);
  }
  /// harmonic_re_x_A_y3_F = (omega1*b3*p - 2*omega2*b3*p)/(32*omega1*omega2^2*(omega1 - omega2)^2)
  double lump_harmonic_re_x_A_y3_F() const {
    return (omega1 * b3 * p - 2.0 * omega2 * b3 * p) * per_1_2 / (32.0 * omega1 * omega2_2);
  }
  /// harmonic_re_x_A_y3_conjA_x_conjA_y = (5*omega1^2*b3*b5 - 11*omega1*omega2*b3*b5 +
  /// 4*omega2^2*b3^2)/(16*omega1*omega2^3*(omega1 - omega2)^2)
  double lump_harmonic_re_x_A_y3_conjA_x_conjA_y() const {
    return (5.0 * omega1_2 * b3 * b5 - 11.0 * omega1 * omega2 * b3 * b5
        + 4.0 * omega2_2 * b3_2) * per_1_2 / (16.0 * omega1 * omega2_3);
  }
  /// harmonic_re_x_A_x_A_y2_conjA_x2 = (2*omega1^2*b3^2 - 4*omega1*omega2*b3^2 -
  /// omega2^2*b3^2)/(8*omega1*omega2^3*(omega1 - omega2)^2) + (6*omega1*b1*b3 +
  /// 3*omega2*b1*b3)/(8*omega1*omega2*(omega1 + omega2)*(omega1 - omega2)^2)
  double lump_harmonic_re_x_A_x_A_y2_conjA_x2() const {
    return (2.0 * omega1_2 * b3_2 - 4.0 * omega1 * omega2 * b3_2
        - omega2_2 * b3_2) * per_1_2 / (8.0 * omega1 * omega2_3) + (6.0 * omega1 * b1 * b3
        + 3.0 * omega2 * b1 * b3) * over_1 / (8.0 * omega1 * omega2);
  }
  /// harmonic_re_x_A_y2_conjA_y_F = (3*omega1*p*b5 - 2*omega2*b3*p + 6*omega2*p*b5)/(32*omega2^3*(omega1 +
  /// omega2)^2)
  double lump_harmonic_re_x_A_y2_conjA_y_F() const {
    return (3.0 * omega1 * p * b5 - 2.0 * omega2 * b3 * p + 6.0 * omega2 * p * b5) * per_0_2 / (32.0 * omega2_3);
  }
  /// harmonic_re_x_A_x_A_y_conjA_x_F = (omega1^2*b3*p - 3*omega1*omega2*b1*p + 2*omega1*omega2*b3*p -
  /// omega2^2*b3*q)/(16*omega1*omega2^3*(omega1 + omega2)^2)
  double lump_harmonic_re_x_A_x_A_y_conjA_x_F() const {
    return (omega1_2 * b3 * p - 3.0 * omega1 * omega2 * b1 * p + 2.0 * omega1 * omega2 * b3 * p
        - omega2_2 * b3 * q) * per_0_2 / (16.0 * omega1 * omega2_3);
  }
  /// harmonic_re_x_A_x_A_y3_conjA_y = (-5*omega1^2*b3*b5 - 11*omega1*omega2*b3*b5 -
  /// 4*omega2^2*b3^2)/(16*omega1*omega2^3*(omega1 + omega2)^2)
  double lump_harmonic_re_x_A_x_A_y3_conjA_y() const {
    return (-5.0 * omega1_2 * b3 * b5 - 11.0 * omega1 * omega2 * b3 * b5
        - 4.0 * omega2_2 * b3_2) * per_0_2 / (16.0 * omega1 * omega2_3);
  }
  /// harmonic_re_x_A_x2_A_y2_conjA_x = (-2*omega1^2*b3^2 - 4*omega1*omega2*b3^2 +
  /// omega2^2*b3^2)/(8*omega1*omega2^3*(omega1 + omega2)^2) + (-6*omega1*b1*b3 +
  /// 3*omega2*b1*b3)/(8*omega1*omega2*(omega1 + omega2)^2*(omega1 - omega2))
  double lump_harmonic_re_x_A_x2_A_y2_conjA_x() const {
    return (-2.0 * omega1_2 * b3_2 - 4.0 * omega1 * omega2 * b3_2
        + omega2_2 * b3_2) * per_0_2 / (8.0 * omega1 * omega2_3) + (-6.0 * omega1 * b1 * b3
        + 3.0 * omega2 * b1 * b3) * over_2 / (8.0 * omega1 * omega2);
  }
  /// harmonic_re_x_A_x2_conjA_y_F = -b3*q/(32*omega1^3*(omega1 + omega2)) - b3*p/(64*omega1^3*(omega1 - omega2))
  double lump_harmonic_re_x_A_x2_conjA_y_F() const {
    return -b3 * q * per_0 / (32.0 * omega1_3) - b3 * p * per_1 / (64.0 * omega1_3);
  }
  /// harmonic_re_x_A_x3_A_y_conjA_y = -b1*b3/(4*omega1^4) + b3^2/(8*omega1^2*(omega1 + omega2)*(omega1 - omega2))
  double lump_harmonic_re_x_A_x3_A_y_conjA_y() const {
    return -b1 * b3 / (4.0 * omega1_4) + b3_2 * over_0 / (8.0 * omega1_2);
  }
  /// harmonic_re_x_A_y2_conjA_x3 = (-6*omega1^2*b1*b3 + omega1*omega2*b1*b3 + 4*omega1*omega2*b3^2 -
  /// omega2^2*b1*b3)/(32*omega1^2*omega2*(omega1 - omega2)^2*(2*omega1 - omega2))
  double lump_harmonic_re_x_A_y2_conjA_x3() const {
    return (-6.0 * omega1_2 * b1 * b3 + omega1 * omega2 * b1 * b3 + 4.0 * omega1 * omega2 * b3_2
        - omega2_2 * b1 * b3) * over_3 / (32.0 * omega1_2 * omega2);
  }
  /// harmonic_re_x_A_y4_conjA_x = -b3*b5/(32*omega2^3*(omega1 - 2*omega2)) + b3^2/(32*omega2^2*(omega1 -
  /// omega2)*(omega1 - 2*omega2))
  double lump_harmonic_re_x_A_y4_conjA_x() const {
    return -b3 * b5 * per_3 / (32.0 * omega2_3) + b3_2 * over_4 / (32.0 * omega2_2);
  }
  /// harmonic_re_x_A_x_A_y4 = b3*b5/(32*omega2^3*(omega1 + 2*omega2)) + b3^2/(32*omega2^2*(omega1 +
  /// omega2)*(omega1 + 2*omega2))
  double lump_harmonic_re_x_A_x_A_y4() const {
    return b3 * b5 * per_4 / (32.0 * omega2_3) + b3_2 * over_5 / (32.0 * omega2_2);
  }
  /// harmonic_re_x_A_x2_A_y_F = (-3*omega1*b1*p - omega2*b3*p - 2*omega2*b3*q)/(32*omega1*omega2*(omega1 +
  /// omega2)^2*(2*omega1 + omega2))
  double lump_harmonic_re_x_A_x2_A_y_F() const {
    return (-3.0 * omega1 * b1 * p - omega2 * b3 * p - 2.0 * omega2 * b3 * q) * over_6 / (32.0 * omega1 * omega2);
  }
  /// harmonic_re_x_A_x3_A_y2 = (6*omega1^2*b1*b3 + omega1*omega2*b1*b3 + 4*omega1*omega2*b3^2 +
  /// omega2^2*b1*b3)/(32*omega1^2*omega2*(omega1 + omega2)^2*(2*omega1 + omega2))
  double lump_harmonic_re_x_A_x3_A_y2() const {
    return (6.0 * omega1_2 * b1 * b3 + omega1 * omega2 * b1 * b3 + 4.0 * omega1 * omega2 * b3_2
        + omega2_2 * b1 * b3) * over_6 / (32.0 * omega1_2 * omega2);
  }
  double lump_harmonic_re_y_conjA_x3_F() const { return -b1 * q * per_1 / (64.0 * omega1_3); }
  /// harmonic_re_y_A_y2_conjA_x2_conjA_y = (-omega1^2*b3^2 - 4*omega1*omega2*b3^2 +
  /// 2*omega2^2*b3^2)/(8*omega1^3*omega2*(omega1 - omega2)^2) + (3*omega1*b3*b5 +
  /// 6*omega2*b3*b5)/(8*omega1*omega2*(omega1 + omega2)*(omega1 - omega2)^2)
  double lump_harmonic_re_y_A_y2_conjA_x2_conjA_y() const {
    return (-omega1_2 * b3_2 - 4.0 * omega1 * omega2 * b3_2
        + 2.0 * omega2_2 * b3_2) * per_1_2 / (8.0 * omega1_3 * omega2) + (3.0 * omega1 * b3 * b5
        + 6.0 * omega2 * b3 * b5) * over_1 / (8.0 * omega1 * omega2);
  }
  /// harmonic_re_y_A_x_A_y_conjA_x3 = (4*omega1^2*b3^2 - 11*omega1*omega2*b1*b3 +
  /// 5*omega2^2*b1*b3)/(16*omega1^3*omega2*(omega1 - omega2)^2)
  double lump_harmonic_re_y_A_x_A_y_conjA_x3() const {
    return (4.0 * omega1_2 * b3_2 - 11.0 * omega1 * omega2 * b1 * b3
        + 5.0 * omega2_2 * b1 * b3) * per_1_2 / (16.0 * omega1_3 * omega2);
  }
  /// harmonic_re_y_A_y2_conjA_x_F = b3*q/(32*omega1*omega2*(omega1 - omega2)^2) - 3*b5*q/(32*omega1^2*(omega1 +
  /// omega2)*(omega1 - omega2))
  double lump_harmonic_re_y_A_y2_conjA_x_F() const {
    return b3 * q * per_1_2 / (32.0 * omega1 * omega2) - 3.0 * b5 * q * over_0 / (32.0 * omega1_2);
  }
  /// harmonic_re_y_A_x_A_y3_conjA_x = -b3*b5/(4*omega2^4) - b3^2/(8*omega2^2*(omega1 + omega2)*(omega1 - omega2))
  double lump_harmonic_re_y_A_x_A_y3_conjA_x() const {
    return -b3 * b5 / (4.0 * omega2_4) - b3_2 * over_0 / (8.0 * omega2_2);
  }
  /// harmonic_re_y_A_x_A_y_conjA_y_F = (-omega1^2*b3*p + 2*omega1*omega2*b3*q - 3*omega1*omega2*b5*q +
  /// omega2^2*b3*q)/(16*omega1^3*omega2*(omega1 + omega2)^2)
  double lump_harmonic_re_y_A_x_A_y_conjA_y_F() const {
    return (-omega1_2 * b3 * p + 2.0 * omega1 * omega2 * b3 * q - 3.0 * omega1 * omega2 * b5 * q
        + omega2_2 * b3 * q) * per_0_2 / (16.0 * omega1_3 * omega2);
  }
  /// harmonic_re_y_A_x2_conjA_x_F = (6*omega1*b1*q - 2*omega1*b3*q + 3*omega2*b1*q)/(32*omega1^3*(omega1 +
  /// omega2)^2)
  double lump_harmonic_re_y_A_x2_conjA_x_F() const {
    return (6.0 * omega1 * b1 * q - 2.0 * omega1 * b3 * q + 3.0 * omega2 * b1 * q) * per_0_2 / (32.0 * omega1_3);
  }
  /// harmonic_re_y_A_x2_A_y2_conjA_y = (omega1^2*b3^2 - 4*omega1*omega2*b3^2 -
  /// 2*omega2^2*b3^2)/(8*omega1^3*omega2*(omega1 + omega2)^2) + (-3*omega1*b3*b5 +
  /// 6*omega2*b3*b5)/(8*omega1*omega2*(omega1 + omega2)^2*(omega1 - omega2))
  double lump_harmonic_re_y_A_x2_A_y2_conjA_y() const {
    return (omega1_2 * b3_2 - 4.0 * omega1 * omega2 * b3_2
        - 2.0 * omega2_2 * b3_2) * per_0_2 / (8.0 * omega1_3 * omega2) + (-3.0 * omega1 * b3 * b5
        + 6.0 * omega2 * b3 * b5) * over_2 / (8.0 * omega1 * omega2);
  }
  /// harmonic_re_y_A_x3_A_y_conjA_x = (-4*omega1^2*b3^2 - 11*omega1*omega2*b1*b3 -
  /// 5*omega2^2*b1*b3)/(16*omega1^3*omega2*(omega1 + omega2)^2)
  double lump_harmonic_re_y_A_x3_A_y_conjA_x() const {
    return (-4.0 * omega1_2 * b3_2 - 11.0 * omega1 * omega2 * b1 * b3
        - 5.0 * omega2_2 * b1 * b3) * per_0_2 / (16.0 * omega1_3 * omega2);
  }
  /// harmonic_re_y_A_y3_conjA_x2 = (omega1^2*b3*b5 - 4*omega1*omega2*b3^2 - omega1*omega2*b3*b5 +
  /// 6*omega2^2*b3*b5)/(32*omega1*omega2^2*(omega1 - omega2)^2*(omega1 - 2*omega2))
  double lump_harmonic_re_y_A_y3_conjA_x2() const {
    return (omega1_2 * b3 * b5 - 4.0 * omega1 * omega2 * b3_2 - omega1 * omega2 * b3 * b5
        + 6.0 * omega2_2 * b3 * b5) * over_7 / (32.0 * omega1 * omega2_2);
  }
  /// harmonic_re_y_A_x_A_y2_F = (-2*omega1*b3*p - omega1*b3*q - 3*omega2*b5*q)/(32*omega1*omega2*(omega1 +
  /// omega2)^2*(omega1 + 2*omega2))
  double lump_harmonic_re_y_A_x_A_y2_F() const {
    return (-2.0 * omega1 * b3 * p - omega1 * b3 * q - 3.0 * omega2 * b5 * q) * over_8 / (32.0 * omega1 * omega2);
  }
  /// harmonic_re_y_A_x2_A_y3 = (omega1^2*b3*b5 + 4*omega1*omega2*b3^2 + omega1*omega2*b3*b5 +
  /// 6*omega2^2*b3*b5)/(32*omega1*omega2^2*(omega1 + omega2)^2*(omega1 + 2*omega2))
  double lump_harmonic_re_y_A_x2_A_y3() const {
    return (omega1_2 * b3 * b5 + 4.0 * omega1 * omega2 * b3_2 + omega1 * omega2 * b3 * b5
        + 6.0 * omega2_2 * b3 * b5) * over_8 / (32.0 * omega1 * omega2_2);
  }
  /// harmonic_re_y_A_x3_F = -b1*q/(128*omega1^3*(2*omega1 + omega2)) - b3*q/(64*omega1^2*(omega1 +
  /// omega2)*(2*omega1 + omega2))
  double lump_harmonic_re_y_A_x3_F() const {
    return -b1 * q * per_5 / (128.0 * omega1_3) - b3 * q * over_9 / (64.0 * omega1_2);
  }
  /// harmonic_re_y_A_x4_A_y = b1*b3/(32*omega1^3*(2*omega1 + omega2)) + b3^2/(32*omega1^2*(omega1 +
  /// omega2)*(2*omega1 + omega2))
  double lump_harmonic_re_y_A_x4_A_y() const {
    return b1 * b3 * per_5 / (32.0 * omega1_3) + b3_2 * over_9 / (32.0 * omega1_2);
  }
  /// harmonic_re_y_A_x4_conjA_y = b1*b3/(32*omega1^3*(2*omega1 - omega2)) + b3^2/(32*omega1^2*(omega1 -
  /// omega2)*(2*omega1 - omega2))
  double lump_harmonic_re_y_A_x4_conjA_y() const {
    return b1 * b3 * per_2 / (32.0 * omega1_3) + b3_2 * over_10 / (32.0 * omega1_2);
  }

  /// By their numbers in the tables.
  static constexpr double (Lumps::*list[])() const = {&Lumps::lump_mu1, &Lumps::lump_b3, &Lumps::lump_b1,
      &Lumps::lump_p, &Lumps::lump_mu2, &Lumps::lump_b5, &Lumps::lump_q, &Lumps::lump_conservative_x_A_x2_A_y_F,
      &Lumps::lump_conservative_x_A_x, &Lumps::lump_conservative_x_A_x_F2,
      &Lumps::lump_dissipative_x_A_x_A_y_conjA_y, &Lumps::lump_conservative_x_A_x_A_y2_conjA_y2,
      &Lumps::lump_dissipative_x_A_x2_conjA_x, &Lumps::lump_conservative_x_A_x2_A_y_conjA_x_conjA_y,
      &Lumps::lump_conservative_x_A_x3_conjA_x2, &Lumps::lump_dissipative_x_conjA_y_F,
      &Lumps::lump_conservative_x_A_y_conjA_y2_F, &Lumps::lump_conservative_x_A_x_conjA_x_conjA_y_F,
      &Lumps::lump_conservative_y_A_x_A_y2_F, &Lumps::lump_conservative_y_A_y,
      &Lumps::lump_dissipative_y_A_y2_conjA_y, &Lumps::lump_conservative_y_A_y3_conjA_y2,
      &Lumps::lump_dissipative_y_A_x_A_y_conjA_x, &Lumps::lump_conservative_y_A_x_A_y2_conjA_x_conjA_y,
      &Lumps::lump_dissipative_y_conjA_x_F, &Lumps::lump_conservative_y_A_y_conjA_x_conjA_y_F,
      &Lumps::lump_conservative_y_A_x_conjA_x2_F, &Lumps::lump_harmonic_re_x_A_y_conjA_x2_F,
      &Lumps::lump_harmonic_re_x_A_y3_F, &Lumps::lump_harmonic_re_x_A_y3_conjA_x_conjA_y,
      &Lumps::lump_harmonic_re_x_A_x_A_y2_conjA_x2, &Lumps::lump_harmonic_re_x_A_y2_conjA_y_F,
      &Lumps::lump_harmonic_re_x_A_x_A_y_conjA_x_F, &Lumps::lump_harmonic_re_x_A_x_A_y3_conjA_y,
      &Lumps::lump_harmonic_re_x_A_x2_A_y2_conjA_x, &Lumps::lump_harmonic_re_x_A_x2_conjA_y_F,
      &Lumps::lump_harmonic_re_x_A_x3_A_y_conjA_y, &Lumps::lump_harmonic_re_x_A_y2_conjA_x3,
      &Lumps::lump_harmonic_re_x_A_y4_conjA_x, &Lumps::lump_harmonic_re_x_A_x_A_y4,
      &Lumps::lump_harmonic_re_x_A_x2_A_y_F, &Lumps::lump_harmonic_re_x_A_x3_A_y2,
      &Lumps::lump_harmonic_re_y_conjA_x3_F, &Lumps::lump_harmonic_re_y_A_y2_conjA_x2_conjA_y,
      &Lumps::lump_harmonic_re_y_A_x_A_y_conjA_x3, &Lumps::lump_harmonic_re_y_A_y2_conjA_x_F,
      &Lumps::lump_harmonic_re_y_A_x_A_y3_conjA_x, &Lumps::lump_harmonic_re_y_A_x_A_y_conjA_y_F,
      &Lumps::lump_harmonic_re_y_A_x2_conjA_x_F, &Lumps::lump_harmonic_re_y_A_x2_A_y2_conjA_y,
      &Lumps::lump_harmonic_re_y_A_x3_A_y_conjA_x, &Lumps::lump_harmonic_re_y_A_y3_conjA_x2,
      &Lumps::lump_harmonic_re_y_A_x_A_y2_F, &Lumps::lump_harmonic_re_y_A_x2_A_y3,
      &Lumps::lump_harmonic_re_y_A_x3_F, &Lumps::lump_harmonic_re_y_A_x4_A_y,
      &Lumps::lump_harmonic_re_y_A_x4_conjA_y};
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
    const Number norm_F = norm_of(F);
    Signals(const Complex* amplitude, [[maybe_unused]] const Complex* forcing) : A_x(amplitude[0]),
        A_y(amplitude[1]), F(forcing[0]) {}
  };
};

}  // namespace secular::generated::parametric_pair
