// Model parametric_pair: generated code, never edited by hand.
// Source: Two linear modes with parametric coupling and cubic stiffness
// Equation of motion: 0 = omega1^2*x + b3*x*y^2 + b1*x^3 + 2*mu1*D(x) + D2(x) - p*y*F*cos(Omega*t)
// Equation of motion: 0 = -q*x*F*cos(Omega*t) + b3*x^2*y + omega2^2*y + b5*y^3 + 2*mu2*D(y) + D2(y)
// Case additive: Omega = omega1 + omega2 + eps*sigma, multiple scales to eps^1. Valid near that resonance for
// small amplitudes; what is left out is of order eps^2.
// Case additive_second_order: Omega = omega1 + omega2 + eps*sigma, multiple scales to eps^2. Valid near that
// resonance for small amplitudes; what is left out is of order eps^3.
// Case difference: Omega = omega2 - omega1 + eps*sigma, multiple scales to eps^1. Valid near that resonance for
// small amplitudes; what is left out is of order eps^2.
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// Made by: secular generate parametric_pair
#pragma once

#include <cstddef>
#include <numbers>

#include "estimator/model/batch_arrays.hpp"
#include "estimator/model/complex_number.hpp"
#include "estimator/model/dense_solve.hpp"
#include "estimator/model/dual_number.hpp"
#include "estimator/model/excitation_sample.hpp"
#include "estimator/model/integer_power.hpp"
#include "estimator/model/lane_functions.hpp"
#include "estimator/model/scalar_functions.hpp"

namespace secular::generated::parametric_pair {

/// Mass matrix M of the equations of motion M*acceleration + force = 0 below, state-dependent: mass[k * 2 + j]
/// multiplies the acceleration of mode j in equation k. 0 operations.
template <class Scalar, class Parameter, class Sample>
void mass_matrix([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* mass) {
  mass[0] = Scalar(1.0);
  mass[1] = Scalar(0.0);
  mass[2] = Scalar(0.0);
  mass[3] = Scalar(1.0);
}

/// Accelerations of the full equations of motion, solved from the state-dependent mass matrix.
/// 0 = omega1^2*x + b3*x*y^2 + b1*x^3 + 2*mu1*D(x) + D2(x) - p*y*F*cos(Omega*t)
/// 0 = -q*x*F*cos(Omega*t) + b3*x^2*y + omega2^2*y + b5*y^3 + 2*mu2*D(y) + D2(y)
/// parameters: [0] omega1, [1] omega2, [2] mu1, [3] b1, [4] b3, [5] p, [6] mu2, [7] b5, [8] q. displacement,
/// velocity, acceleration: 2 values. 32 operations.
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
      + b1 * displacement[0] * displacement[0] * displacement[0] + Scalar(2.0) * mu1 * velocity[0]
      - p * displacement[1] * Scalar(excitation[0].value));
  acceleration[1] = -(-q * displacement[0] * Scalar(excitation[0].value)
      + b3 * displacement[0] * displacement[0] * displacement[1] + omega2_2 * displacement[1]
      + b5 * displacement[1] * displacement[1] * displacement[1] + Scalar(2.0) * mu2 * velocity[1]);
}

/// slope[k * 4 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = x, y, D(x), D(y).
/// Of nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x) = 0. 28
/// operations before the solution of 4 right sides.
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
  for (std::size_t i = 0; i < 8; ++i) slope[i] = Scalar(0.0);
  // equation 1 by x
  slope[0] = -(omega1_2 + b3 * displacement[1] * displacement[1]
      + b1 * displacement[0] * displacement[0] * Scalar(3.0));
  // equation 1 by y
  slope[1] = -(b3 * displacement[0] * displacement[1] * Scalar(2.0) - p * Scalar(excitation[0].value));
  slope[2] = -(Scalar(2.0) * mu1);  // equation 1 by D(x)
  // equation 2 by x
  slope[4] = -(-q * Scalar(excitation[0].value) + b3 * displacement[0] * displacement[1] * Scalar(2.0));
  // equation 2 by y
  slope[5] = -(b3 * displacement[0] * displacement[0] + omega2_2
      + b5 * displacement[1] * displacement[1] * Scalar(3.0));
  slope[7] = -(Scalar(2.0) * mu2);  // equation 2 by D(y)
}

/// slope[k * 9 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = omega1, omega2,
/// mu1, b1, b3, p, mu2, b5, q. Of nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the
/// corner, and d sgn(x) = 0. 18 operations before the solution of 9 right sides.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_parameters([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  for (std::size_t i = 0; i < 18; ++i) slope[i] = Scalar(0.0);
  slope[0] = -(Scalar(2.0) * omega1 * displacement[0]);  // equation 1 by omega1
  slope[2] = -(Scalar(2.0) * velocity[0]);  // equation 1 by mu1
  slope[3] = -(displacement[0] * displacement[0] * displacement[0]);  // equation 1 by b1
  slope[4] = -(displacement[0] * displacement[1] * displacement[1]);  // equation 1 by b3
  slope[5] = -(-Scalar(1.0) * displacement[1] * Scalar(excitation[0].value));  // equation 1 by p
  slope[10] = -(Scalar(2.0) * omega2 * displacement[1]);  // equation 2 by omega2
  slope[13] = -(displacement[0] * displacement[0] * displacement[1]);  // equation 2 by b3
  slope[15] = -(Scalar(2.0) * velocity[1]);  // equation 2 by mu2
  slope[16] = -(displacement[1] * displacement[1] * displacement[1]);  // equation 2 by b5
  slope[17] = -(-Scalar(1.0) * displacement[0] * Scalar(excitation[0].value));  // equation 2 by q
}

/// conservative_x_A_x2_A_y_F = (-2*omega1*b3*q - 3*omega2*b1*p)/(16*omega1^3*omega2) - b3*p/(16*omega1^2*(omega1
/// + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 22 operations.
template <class Scalar>
Scalar lump_0(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b1 = parameters[3];
  const Scalar b3 = parameters[4];
  const Scalar p = parameters[5];
  const Scalar q = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar f_0 = -b3 * q / (Scalar(8.0) * omega1_2 * omega2);
  const Scalar f_1 = -Scalar(3.0) * b1 * p / (Scalar(16.0) * omega1_3);
  const Scalar f_2 = -b3 * p * per_0 / (Scalar(16.0) * omega1_2);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_2 * per_0;
  gradient[0] = (-Scalar(2.0) * f_0 - Scalar(3.0) * f_1 - Scalar(2.0) * f_2) / omega1 - q_0;  // by omega1
  gradient[1] = -f_0 / omega2 - q_0;  // by omega2
  const Scalar c_0 = -Scalar(3.0) / (Scalar(16.0) * omega1_3);  // multiplies b1*p
  const Scalar c_1 = -per_0 / (Scalar(16.0) * omega1_2);  // multiplies b3*p
  const Scalar c_2 = -Scalar(1.0) / (Scalar(8.0) * omega1_2 * omega2);  // multiplies b3*q
  gradient[3] = p * c_0;  // by b1
  gradient[4] = p * c_1 + q * c_2;  // by b3
  gradient[5] = b1 * c_0 + b3 * c_1;  // by p
  gradient[8] = b3 * c_2;  // by q
  return value;
}

/// conservative_x_A_x_F2 = (omega1*p*q + 2*omega2*p*q)/(32*omega1^2*omega2*(omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 17 operations.
template <class Scalar>
Scalar lump_1(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar p = parameters[5];
  const Scalar q = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar f_0 = p * q * per_0 / (Scalar(32.0) * omega1 * omega2);
  const Scalar f_1 = p * q * per_0 / (Scalar(16.0) * omega1_2);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1) * per_0;
  gradient[0] = (-f_0 - Scalar(2.0) * f_1) / omega1 - q_0;  // by omega1
  gradient[1] = -f_0 / omega2 - q_0;  // by omega2
  // multiplies p*q
  const Scalar c_0 = (omega1 + Scalar(2.0) * omega2) * per_0 / (Scalar(32.0) * omega1_2 * omega2);
  gradient[5] = q * c_0;  // by p
  gradient[8] = p * c_0;  // by q
  return value;
}

/// conservative_x_A_x_A_y2_conjA_y2 = (-3*omega1^2*b3^2 + 2*omega2^2*b3^2)/(4*omega1^3*(omega1 + omega2)*(omega1
/// - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 22 operations.
template <class Scalar>
Scalar lump_2(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b3 = parameters[4];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar b3_2 = b3 * b3;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -Scalar(3.0) * b3_2 * per_0 * per_1 / (Scalar(4.0) * omega1);
  const Scalar f_1 = omega2_2 * b3_2 * per_0 * per_1 / (Scalar(2.0) * omega1_3);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1) * per_0;
  const Scalar q_1 = (f_0 + f_1) * per_1;
  gradient[0] = (-f_0 - Scalar(3.0) * f_1) / omega1 - q_0 - q_1;  // by omega1
  gradient[1] = Scalar(2.0) * f_1 / omega2 - q_0 + q_1;  // by omega2
  // multiplies b3^2
  const Scalar c_0 = (-Scalar(3.0) * omega1_2 + Scalar(2.0) * omega2_2) * per_0 * per_1 / (Scalar(4.0) * omega1_3);
  gradient[4] = Scalar(2.0) * b3 * c_0;  // by b3
  return value;
}

/// conservative_x_A_x2_A_y_conjA_x_conjA_y = -3*b1*b3/(2*omega1^3) + b3^2/(2*omega1*(omega1 + omega2)*(omega1 -
/// omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 19 operations.
template <class Scalar>
Scalar lump_3(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b1 = parameters[3];
  const Scalar b3 = parameters[4];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar b3_2 = b3 * b3;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -Scalar(3.0) * b1 * b3 / (Scalar(2.0) * omega1_3);
  const Scalar f_1 = b3_2 * per_0 * per_1 / (Scalar(2.0) * omega1);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_1 * per_0;
  const Scalar q_1 = f_1 * per_1;
  gradient[0] = (-Scalar(3.0) * f_0 - f_1) / omega1 - q_0 - q_1;  // by omega1
  gradient[1] = -q_0 + q_1;  // by omega2
  const Scalar c_0 = -Scalar(3.0) / (Scalar(2.0) * omega1_3);  // multiplies b1*b3
  const Scalar c_1 = per_0 * per_1 / (Scalar(2.0) * omega1);  // multiplies b3^2
  gradient[3] = b3 * c_0;  // by b1
  gradient[4] = b1 * c_0 + Scalar(2.0) * b3 * c_1;  // by b3
  return value;
}

/// conservative_x_A_y_conjA_y2_F = (-3*omega1*p*b5 + 2*omega2*b3*p)/(16*omega1^3*omega2) -
/// b3*p/(16*omega1*omega2*(omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 25 operations.
template <class Scalar>
Scalar lump_4(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b3 = parameters[4];
  const Scalar p = parameters[5];
  const Scalar b5 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar f_0 = -Scalar(3.0) * p * b5 / (Scalar(16.0) * omega1_2 * omega2);
  const Scalar f_1 = b3 * p / (Scalar(8.0) * omega1_3);
  const Scalar f_2 = -b3 * p * per_0 / (Scalar(16.0) * omega1 * omega2);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_2 * per_0;
  gradient[0] = (-Scalar(2.0) * f_0 - Scalar(3.0) * f_1 - f_2) / omega1 - q_0;  // by omega1
  gradient[1] = (-f_0 - f_2) / omega2 - q_0;  // by omega2
  // multiplies b3*p
  const Scalar c_0 = Scalar(1.0) / (Scalar(8.0) * omega1_3) - per_0 / (Scalar(16.0) * omega1 * omega2);
  const Scalar c_1 = -Scalar(3.0) / (Scalar(16.0) * omega1_2 * omega2);  // multiplies p*b5
  gradient[4] = p * c_0;  // by b3
  gradient[5] = b3 * c_0 + b5 * c_1;  // by p
  gradient[7] = p * c_1;  // by b5
  return value;
}

/// conservative_x_A_x_conjA_x_conjA_y_F = (-omega1*b3*p + 3*omega2*b1*p)/(8*omega1^3*omega2) +
/// b3*q/(8*omega1*omega2*(omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 24 operations.
template <class Scalar>
Scalar lump_5(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b1 = parameters[3];
  const Scalar b3 = parameters[4];
  const Scalar p = parameters[5];
  const Scalar q = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar f_0 = -b3 * p / (Scalar(8.0) * omega1_2 * omega2);
  const Scalar f_1 = Scalar(3.0) * b1 * p / (Scalar(8.0) * omega1_3);
  const Scalar f_2 = b3 * q * per_0 / (Scalar(8.0) * omega1 * omega2);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_2 * per_0;
  gradient[0] = (-Scalar(2.0) * f_0 - Scalar(3.0) * f_1 - f_2) / omega1 - q_0;  // by omega1
  gradient[1] = (-f_0 - f_2) / omega2 - q_0;  // by omega2
  const Scalar c_0 = Scalar(3.0) / (Scalar(8.0) * omega1_3);  // multiplies b1*p
  const Scalar c_1 = -Scalar(1.0) / (Scalar(8.0) * omega1_2 * omega2);  // multiplies b3*p
  const Scalar c_2 = per_0 / (Scalar(8.0) * omega1 * omega2);  // multiplies b3*q
  gradient[3] = p * c_0;  // by b1
  gradient[4] = p * c_1 + q * c_2;  // by b3
  gradient[5] = b1 * c_0 + b3 * c_1;  // by p
  gradient[8] = b3 * c_2;  // by q
  return value;
}

/// conservative_y_A_x_A_y2_F = (-3*omega1*b5*q - 2*omega2*b3*p)/(16*omega1*omega2^3) - b3*q/(16*omega2^2*(omega1
/// + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 22 operations.
template <class Scalar>
Scalar lump_6(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b3 = parameters[4];
  const Scalar p = parameters[5];
  const Scalar b5 = parameters[7];
  const Scalar q = parameters[8];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar f_0 = -Scalar(3.0) * b5 * q / (Scalar(16.0) * omega2_3);
  const Scalar f_1 = -b3 * p / (Scalar(8.0) * omega1 * omega2_2);
  const Scalar f_2 = -b3 * q * per_0 / (Scalar(16.0) * omega2_2);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_2 * per_0;
  gradient[0] = -f_1 / omega1 - q_0;  // by omega1
  gradient[1] = (-Scalar(3.0) * f_0 - Scalar(2.0) * f_1 - Scalar(2.0) * f_2) / omega2 - q_0;  // by omega2
  const Scalar c_0 = -Scalar(1.0) / (Scalar(8.0) * omega1 * omega2_2);  // multiplies b3*p
  const Scalar c_1 = -per_0 / (Scalar(16.0) * omega2_2);  // multiplies b3*q
  const Scalar c_2 = -Scalar(3.0) / (Scalar(16.0) * omega2_3);  // multiplies b5*q
  gradient[4] = p * c_0 + q * c_1;  // by b3
  gradient[5] = b3 * c_0;  // by p
  gradient[7] = q * c_2;  // by b5
  gradient[8] = b3 * c_1 + b5 * c_2;  // by q
  return value;
}

/// conservative_y_A_x_A_y2_conjA_x_conjA_y = -3*b3*b5/(2*omega2^3) - b3^2/(2*omega2*(omega1 + omega2)*(omega1 -
/// omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 19 operations.
template <class Scalar>
Scalar lump_7(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b3 = parameters[4];
  const Scalar b5 = parameters[7];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar b3_2 = b3 * b3;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -Scalar(3.0) * b3 * b5 / (Scalar(2.0) * omega2_3);
  const Scalar f_1 = -b3_2 * per_0 * per_1 / (Scalar(2.0) * omega2);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_1 * per_0;
  const Scalar q_1 = f_1 * per_1;
  gradient[0] = -q_0 - q_1;  // by omega1
  gradient[1] = (-Scalar(3.0) * f_0 - f_1) / omega2 - q_0 + q_1;  // by omega2
  const Scalar c_0 = -per_0 * per_1 / (Scalar(2.0) * omega2);  // multiplies b3^2
  const Scalar c_1 = -Scalar(3.0) / (Scalar(2.0) * omega2_3);  // multiplies b3*b5
  gradient[4] = Scalar(2.0) * b3 * c_0 + b5 * c_1;  // by b3
  gradient[7] = b3 * c_1;  // by b5
  return value;
}

/// conservative_y_A_y_conjA_x_conjA_y_F = (3*omega1*b5*q - omega2*b3*q)/(8*omega1*omega2^3) +
/// b3*p/(8*omega1*omega2*(omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 24 operations.
template <class Scalar>
Scalar lump_8(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b3 = parameters[4];
  const Scalar p = parameters[5];
  const Scalar b5 = parameters[7];
  const Scalar q = parameters[8];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar f_0 = Scalar(3.0) * b5 * q / (Scalar(8.0) * omega2_3);
  const Scalar f_1 = -b3 * q / (Scalar(8.0) * omega1 * omega2_2);
  const Scalar f_2 = b3 * p * per_0 / (Scalar(8.0) * omega1 * omega2);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_2 * per_0;
  gradient[0] = (-f_1 - f_2) / omega1 - q_0;  // by omega1
  gradient[1] = (-Scalar(3.0) * f_0 - Scalar(2.0) * f_1 - f_2) / omega2 - q_0;  // by omega2
  const Scalar c_0 = per_0 / (Scalar(8.0) * omega1 * omega2);  // multiplies b3*p
  const Scalar c_1 = -Scalar(1.0) / (Scalar(8.0) * omega1 * omega2_2);  // multiplies b3*q
  const Scalar c_2 = Scalar(3.0) / (Scalar(8.0) * omega2_3);  // multiplies b5*q
  gradient[4] = p * c_0 + q * c_1;  // by b3
  gradient[5] = b3 * c_0;  // by p
  gradient[7] = q * c_2;  // by b5
  gradient[8] = b3 * c_1 + b5 * c_2;  // by q
  return value;
}

/// conservative_y_A_x_conjA_x2_F = (2*omega1*b3*q - 3*omega2*b1*q)/(16*omega1*omega2^3) -
/// b3*q/(16*omega1*omega2*(omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 25 operations.
template <class Scalar>
Scalar lump_9(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b1 = parameters[3];
  const Scalar b3 = parameters[4];
  const Scalar q = parameters[8];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar f_0 = b3 * q / (Scalar(8.0) * omega2_3);
  const Scalar f_1 = -Scalar(3.0) * b1 * q / (Scalar(16.0) * omega1 * omega2_2);
  const Scalar f_2 = -b3 * q * per_0 / (Scalar(16.0) * omega1 * omega2);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_2 * per_0;
  gradient[0] = (-f_1 - f_2) / omega1 - q_0;  // by omega1
  gradient[1] = (-Scalar(3.0) * f_0 - Scalar(2.0) * f_1 - f_2) / omega2 - q_0;  // by omega2
  const Scalar c_0 = -Scalar(3.0) / (Scalar(16.0) * omega1 * omega2_2);  // multiplies b1*q
  // multiplies b3*q
  const Scalar c_1 = Scalar(1.0) / (Scalar(8.0) * omega2_3) - per_0 / (Scalar(16.0) * omega1 * omega2);
  gradient[3] = q * c_0;  // by b1
  gradient[4] = q * c_1;  // by b3
  gradient[8] = b1 * c_0 + b3 * c_1;  // by q
  return value;
}

/// harmonic_re_x_A_y_conjA_x2_F = b3*p/(32*omega1*omega2*(omega1 - omega2)^2) + 3*b1*p/(32*omega2^2*(omega1 +
/// omega2)*(omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 23 operations.
template <class Scalar>
Scalar lump_10(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b1 = parameters[3];
  const Scalar b3 = parameters[4];
  const Scalar p = parameters[5];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2);
  const Scalar f_0 = b3 * p * per_0_2 / (Scalar(32.0) * omega1 * omega2);
  const Scalar f_1 = Scalar(3.0) * b1 * p * per_1 * per_0 / (Scalar(32.0) * omega2_2);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (Scalar(2.0) * f_0 + f_1) * per_0;
  const Scalar q_1 = f_1 * per_1;
  gradient[0] = -f_0 / omega1 - q_0 - q_1;  // by omega1
  gradient[1] = (-f_0 - Scalar(2.0) * f_1) / omega2 + q_0 - q_1;  // by omega2
  const Scalar c_0 = Scalar(3.0) * per_1 * per_0 / (Scalar(32.0) * omega2_2);  // multiplies b1*p
  const Scalar c_1 = per_0_2 / (Scalar(32.0) * omega1 * omega2);  // multiplies b3*p
  gradient[3] = p * c_0;  // by b1
  gradient[4] = p * c_1;  // by b3
  gradient[5] = b1 * c_0 + b3 * c_1;  // by p
  return value;
}

/// harmonic_re_x_A_y3_F = (omega1*b3*p - 2*omega2*b3*p)/(32*omega1*omega2^2*(omega1 - omega2)^2)
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 17 operations.
template <class Scalar>
Scalar lump_11(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b3 = parameters[4];
  const Scalar p = parameters[5];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar f_0 = b3 * p * per_0_2 / (Scalar(32.0) * omega2_2);
  const Scalar f_1 = -b3 * p * per_0_2 / (Scalar(16.0) * omega1 * omega2);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (Scalar(2.0) * f_0 + Scalar(2.0) * f_1) * per_0;
  gradient[0] = -f_1 / omega1 - q_0;  // by omega1
  gradient[1] = (-Scalar(2.0) * f_0 - f_1) / omega2 + q_0;  // by omega2
  // multiplies b3*p
  const Scalar c_0 = (omega1 - Scalar(2.0) * omega2) * per_0_2 / (Scalar(32.0) * omega1 * omega2_2);
  gradient[4] = p * c_0;  // by b3
  gradient[5] = b3 * c_0;  // by p
  return value;
}

/// harmonic_re_x_A_y3_conjA_x_conjA_y = (5*omega1^2*b3*b5 - 11*omega1*omega2*b3*b5 +
/// 4*omega2^2*b3^2)/(16*omega1*omega2^3*(omega1 - omega2)^2)
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 28 operations.
template <class Scalar>
Scalar lump_12(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b3 = parameters[4];
  const Scalar b5 = parameters[7];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar b3_2 = b3 * b3;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar f_0 = Scalar(5.0) * omega1 * b3 * b5 * per_0_2 / (Scalar(16.0) * omega2_3);
  const Scalar f_1 = -Scalar(11.0) * b3 * b5 * per_0_2 / (Scalar(16.0) * omega2_2);
  const Scalar f_2 = b3_2 * per_0_2 / (Scalar(4.0) * omega1 * omega2);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (Scalar(2.0) * f_0 + Scalar(2.0) * f_1 + Scalar(2.0) * f_2) * per_0;
  gradient[0] = (f_0 - f_2) / omega1 - q_0;  // by omega1
  gradient[1] = (-Scalar(3.0) * f_0 - Scalar(2.0) * f_1 - f_2) / omega2 + q_0;  // by omega2
  const Scalar c_0 = per_0_2 / (Scalar(4.0) * omega1 * omega2);  // multiplies b3^2
  // multiplies b3*b5
  const Scalar c_1 = (Scalar(5.0) * omega1 - Scalar(11.0) * omega2) * per_0_2 / (Scalar(16.0) * omega2_3);
  gradient[4] = Scalar(2.0) * b3 * c_0 + b5 * c_1;  // by b3
  gradient[7] = b3 * c_1;  // by b5
  return value;
}

/// harmonic_re_x_A_x_A_y2_conjA_x2 = (2*omega1^2*b3^2 - 4*omega1*omega2*b3^2 -
/// omega2^2*b3^2)/(8*omega1*omega2^3*(omega1 - omega2)^2) + (6*omega1*b1*b3 +
/// 3*omega2*b1*b3)/(8*omega1*omega2*(omega1 + omega2)*(omega1 - omega2)^2)
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 45 operations.
template <class Scalar>
Scalar lump_13(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b1 = parameters[3];
  const Scalar b3 = parameters[4];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar b3_2 = b3 * b3;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2);
  const Scalar f_0 = omega1 * b3_2 * per_0_2 / (Scalar(4.0) * omega2_3);
  const Scalar f_1 = -b3_2 * per_0_2 / (Scalar(2.0) * omega2_2);
  const Scalar f_2 = -b3_2 * per_0_2 / (Scalar(8.0) * omega1 * omega2);
  const Scalar f_3 = Scalar(3.0) * b1 * b3 * per_1 * per_0_2 / (Scalar(4.0) * omega2);
  const Scalar f_4 = Scalar(3.0) * b1 * b3 * per_1 * per_0_2 / (Scalar(8.0) * omega1);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (Scalar(2.0) * f_0 + Scalar(2.0) * f_1 + Scalar(2.0) * f_2 + Scalar(2.0) * f_3
      + Scalar(2.0) * f_4) * per_0;
  const Scalar q_1 = (f_3 + f_4) * per_1;
  gradient[0] = (f_0 - f_2 - f_4) / omega1 - q_0 - q_1;  // by omega1
  gradient[1] = (-Scalar(3.0) * f_0 - Scalar(2.0) * f_1 - f_2 - f_3) / omega2 + q_0 - q_1;  // by omega2
  // multiplies b1*b3
  const Scalar c_0 = (Scalar(6.0) * omega1
      + Scalar(3.0) * omega2) * per_1 * per_0_2 / (Scalar(8.0) * omega1 * omega2);
  // multiplies b3^2
  const Scalar c_1 = (Scalar(2.0) * omega1_2 - Scalar(4.0) * omega1 * omega2
      - omega2_2) * per_0_2 / (Scalar(8.0) * omega1 * omega2_3);
  gradient[3] = b3 * c_0;  // by b1
  gradient[4] = b1 * c_0 + Scalar(2.0) * b3 * c_1;  // by b3
  return value;
}

/// harmonic_re_x_A_y2_conjA_y_F = (3*omega1*p*b5 - 2*omega2*b3*p + 6*omega2*p*b5)/(32*omega2^3*(omega1 +
/// omega2)^2)
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 24 operations.
template <class Scalar>
Scalar lump_14(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b3 = parameters[4];
  const Scalar p = parameters[5];
  const Scalar b5 = parameters[7];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar f_0 = Scalar(3.0) * omega1 * p * b5 * per_0_2 / (Scalar(32.0) * omega2_3);
  const Scalar f_1 = (-b3 * p + Scalar(3.0) * p * b5) * per_0_2 / (Scalar(16.0) * omega2_2);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (Scalar(2.0) * f_0 + Scalar(2.0) * f_1) * per_0;
  gradient[0] = f_0 / omega1 - q_0;  // by omega1
  gradient[1] = (-Scalar(3.0) * f_0 - Scalar(2.0) * f_1) / omega2 - q_0;  // by omega2
  const Scalar c_0 = -per_0_2 / (Scalar(16.0) * omega2_2);  // multiplies b3*p
  // multiplies p*b5
  const Scalar c_1 = (Scalar(3.0) * omega1 + Scalar(6.0) * omega2) * per_0_2 / (Scalar(32.0) * omega2_3);
  gradient[4] = p * c_0;  // by b3
  gradient[5] = b3 * c_0 + b5 * c_1;  // by p
  gradient[7] = p * c_1;  // by b5
  return value;
}

/// harmonic_re_x_A_x_A_y_conjA_x_F = (omega1^2*b3*p - 3*omega1*omega2*b1*p + 2*omega1*omega2*b3*p -
/// omega2^2*b3*q)/(16*omega1*omega2^3*(omega1 + omega2)^2)
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 32 operations.
template <class Scalar>
Scalar lump_15(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b1 = parameters[3];
  const Scalar b3 = parameters[4];
  const Scalar p = parameters[5];
  const Scalar q = parameters[8];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar f_0 = omega1 * b3 * p * per_0_2 / (Scalar(16.0) * omega2_3);
  const Scalar f_1 = (-Scalar(3.0) * b1 * p + Scalar(2.0) * b3 * p) * per_0_2 / (Scalar(16.0) * omega2_2);
  const Scalar f_2 = -b3 * q * per_0_2 / (Scalar(16.0) * omega1 * omega2);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (Scalar(2.0) * f_0 + Scalar(2.0) * f_1 + Scalar(2.0) * f_2) * per_0;
  gradient[0] = (f_0 - f_2) / omega1 - q_0;  // by omega1
  gradient[1] = (-Scalar(3.0) * f_0 - Scalar(2.0) * f_1 - f_2) / omega2 - q_0;  // by omega2
  const Scalar c_0 = -Scalar(3.0) * per_0_2 / (Scalar(16.0) * omega2_2);  // multiplies b1*p
  const Scalar c_1 = (omega1 + Scalar(2.0) * omega2) * per_0_2 / (Scalar(16.0) * omega2_3);  // multiplies b3*p
  const Scalar c_2 = -per_0_2 / (Scalar(16.0) * omega1 * omega2);  // multiplies b3*q
  gradient[3] = p * c_0;  // by b1
  gradient[4] = p * c_1 + q * c_2;  // by b3
  gradient[5] = b1 * c_0 + b3 * c_1;  // by p
  gradient[8] = b3 * c_2;  // by q
  return value;
}

/// harmonic_re_x_A_x_A_y3_conjA_y = (-5*omega1^2*b3*b5 - 11*omega1*omega2*b3*b5 -
/// 4*omega2^2*b3^2)/(16*omega1*omega2^3*(omega1 + omega2)^2)
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 28 operations.
template <class Scalar>
Scalar lump_16(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b3 = parameters[4];
  const Scalar b5 = parameters[7];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar b3_2 = b3 * b3;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar f_0 = -Scalar(5.0) * omega1 * b3 * b5 * per_0_2 / (Scalar(16.0) * omega2_3);
  const Scalar f_1 = -Scalar(11.0) * b3 * b5 * per_0_2 / (Scalar(16.0) * omega2_2);
  const Scalar f_2 = -b3_2 * per_0_2 / (Scalar(4.0) * omega1 * omega2);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (Scalar(2.0) * f_0 + Scalar(2.0) * f_1 + Scalar(2.0) * f_2) * per_0;
  gradient[0] = (f_0 - f_2) / omega1 - q_0;  // by omega1
  gradient[1] = (-Scalar(3.0) * f_0 - Scalar(2.0) * f_1 - f_2) / omega2 - q_0;  // by omega2
  const Scalar c_0 = -per_0_2 / (Scalar(4.0) * omega1 * omega2);  // multiplies b3^2
  // multiplies b3*b5
  const Scalar c_1 = (-Scalar(5.0) * omega1 - Scalar(11.0) * omega2) * per_0_2 / (Scalar(16.0) * omega2_3);
  gradient[4] = Scalar(2.0) * b3 * c_0 + b5 * c_1;  // by b3
  gradient[7] = b3 * c_1;  // by b5
  return value;
}

/// harmonic_re_x_A_x2_A_y2_conjA_x = (-2*omega1^2*b3^2 - 4*omega1*omega2*b3^2 +
/// omega2^2*b3^2)/(8*omega1*omega2^3*(omega1 + omega2)^2) + (-6*omega1*b1*b3 +
/// 3*omega2*b1*b3)/(8*omega1*omega2*(omega1 + omega2)^2*(omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 45 operations.
template <class Scalar>
Scalar lump_17(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b1 = parameters[3];
  const Scalar b3 = parameters[4];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar b3_2 = b3 * b3;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -omega1 * b3_2 * per_0_2 / (Scalar(4.0) * omega2_3);
  const Scalar f_1 = -b3_2 * per_0_2 / (Scalar(2.0) * omega2_2);
  const Scalar f_2 = b3_2 * per_0_2 / (Scalar(8.0) * omega1 * omega2);
  const Scalar f_3 = -Scalar(3.0) * b1 * b3 * per_0_2 * per_1 / (Scalar(4.0) * omega2);
  const Scalar f_4 = Scalar(3.0) * b1 * b3 * per_0_2 * per_1 / (Scalar(8.0) * omega1);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (Scalar(2.0) * f_0 + Scalar(2.0) * f_1 + Scalar(2.0) * f_2 + Scalar(2.0) * f_3
      + Scalar(2.0) * f_4) * per_0;
  const Scalar q_1 = (f_3 + f_4) * per_1;
  gradient[0] = (f_0 - f_2 - f_4) / omega1 - q_0 - q_1;  // by omega1
  gradient[1] = (-Scalar(3.0) * f_0 - Scalar(2.0) * f_1 - f_2 - f_3) / omega2 - q_0 + q_1;  // by omega2
  // multiplies b1*b3
  const Scalar c_0 = (-Scalar(6.0) * omega1
      + Scalar(3.0) * omega2) * per_0_2 * per_1 / (Scalar(8.0) * omega1 * omega2);
  // multiplies b3^2
  const Scalar c_1 = (-Scalar(2.0) * omega1_2 - Scalar(4.0) * omega1 * omega2
      + omega2_2) * per_0_2 / (Scalar(8.0) * omega1 * omega2_3);
  gradient[3] = b3 * c_0;  // by b1
  gradient[4] = b1 * c_0 + Scalar(2.0) * b3 * c_1;  // by b3
  return value;
}

/// harmonic_re_x_A_x2_conjA_y_F = -b3*q/(32*omega1^3*(omega1 + omega2)) - b3*p/(64*omega1^3*(omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 18 operations.
template <class Scalar>
Scalar lump_18(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b3 = parameters[4];
  const Scalar p = parameters[5];
  const Scalar q = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -b3 * q * per_0 / (Scalar(32.0) * omega1_3);
  const Scalar f_1 = -b3 * p * per_1 / (Scalar(64.0) * omega1_3);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_0 * per_0;
  const Scalar q_1 = f_1 * per_1;
  gradient[0] = (-Scalar(3.0) * f_0 - Scalar(3.0) * f_1) / omega1 - q_0 - q_1;  // by omega1
  gradient[1] = -q_0 + q_1;  // by omega2
  const Scalar c_0 = -per_1 / (Scalar(64.0) * omega1_3);  // multiplies b3*p
  const Scalar c_1 = -per_0 / (Scalar(32.0) * omega1_3);  // multiplies b3*q
  gradient[4] = p * c_0 + q * c_1;  // by b3
  gradient[5] = b3 * c_0;  // by p
  gradient[8] = b3 * c_1;  // by q
  return value;
}

/// harmonic_re_x_A_x3_A_y_conjA_y = -b1*b3/(4*omega1^4) + b3^2/(8*omega1^2*(omega1 + omega2)*(omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 18 operations.
template <class Scalar>
Scalar lump_19(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b1 = parameters[3];
  const Scalar b3 = parameters[4];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar b3_2 = b3 * b3;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -b1 * b3 / (Scalar(4.0) * omega1_4);
  const Scalar f_1 = b3_2 * per_0 * per_1 / (Scalar(8.0) * omega1_2);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_1 * per_0;
  const Scalar q_1 = f_1 * per_1;
  gradient[0] = (-Scalar(4.0) * f_0 - Scalar(2.0) * f_1) / omega1 - q_0 - q_1;  // by omega1
  gradient[1] = -q_0 + q_1;  // by omega2
  const Scalar c_0 = -Scalar(1.0) / (Scalar(4.0) * omega1_4);  // multiplies b1*b3
  const Scalar c_1 = per_0 * per_1 / (Scalar(8.0) * omega1_2);  // multiplies b3^2
  gradient[3] = b3 * c_0;  // by b1
  gradient[4] = b1 * c_0 + Scalar(2.0) * b3 * c_1;  // by b3
  return value;
}

/// harmonic_re_x_A_y2_conjA_x3 = (-6*omega1^2*b1*b3 + omega1*omega2*b1*b3 + 4*omega1*omega2*b3^2 -
/// omega2^2*b1*b3)/(32*omega1^2*omega2*(omega1 - omega2)^2*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 38 operations.
template <class Scalar>
Scalar lump_20(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b1 = parameters[3];
  const Scalar b3 = parameters[4];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar b3_2 = b3 * b3;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = -Scalar(3.0) * b1 * b3 * per_0_2 * per_1 / (Scalar(16.0) * omega2);
  const Scalar f_1 = (b1 * b3 + Scalar(4.0) * b3_2) * per_0_2 * per_1 / (Scalar(32.0) * omega1);
  const Scalar f_2 = -omega2 * b1 * b3 * per_0_2 * per_1 / (Scalar(32.0) * omega1_2);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (Scalar(2.0) * f_0 + Scalar(2.0) * f_1 + Scalar(2.0) * f_2) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2) * per_1;
  gradient[0] = (-f_1 - Scalar(2.0) * f_2) / omega1 - q_0 - Scalar(2.0) * q_1;  // by omega1
  gradient[1] = (-f_0 + f_2) / omega2 + q_0 + q_1;  // by omega2
  // multiplies b1*b3
  const Scalar c_0 = (-Scalar(6.0) * omega1_2 + omega1 * omega2
      - omega2_2) * per_0_2 * per_1 / (Scalar(32.0) * omega1_2 * omega2);
  const Scalar c_1 = per_0_2 * per_1 / (Scalar(8.0) * omega1);  // multiplies b3^2
  gradient[3] = b3 * c_0;  // by b1
  gradient[4] = b1 * c_0 + Scalar(2.0) * b3 * c_1;  // by b3
  return value;
}

/// harmonic_re_x_A_y4_conjA_x = -b3*b5/(32*omega2^3*(omega1 - 2*omega2)) + b3^2/(32*omega2^2*(omega1 -
/// omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 21 operations.
template <class Scalar>
Scalar lump_21(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b3 = parameters[4];
  const Scalar b5 = parameters[7];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar b3_2 = b3 * b3;
  const Scalar per_0 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -b3 * b5 * per_0 / (Scalar(32.0) * omega2_3);
  const Scalar f_1 = b3_2 * per_1 * per_0 / (Scalar(32.0) * omega2_2);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1) * per_0;
  const Scalar q_1 = f_1 * per_1;
  gradient[0] = -q_0 - q_1;  // by omega1
  gradient[1] = (-Scalar(3.0) * f_0 - Scalar(2.0) * f_1) / omega2 + Scalar(2.0) * q_0 + q_1;  // by omega2
  const Scalar c_0 = per_1 * per_0 / (Scalar(32.0) * omega2_2);  // multiplies b3^2
  const Scalar c_1 = -per_0 / (Scalar(32.0) * omega2_3);  // multiplies b3*b5
  gradient[4] = Scalar(2.0) * b3 * c_0 + b5 * c_1;  // by b3
  gradient[7] = b3 * c_1;  // by b5
  return value;
}

/// harmonic_re_x_A_x_A_y4 = b3*b5/(32*omega2^3*(omega1 + 2*omega2)) + b3^2/(32*omega2^2*(omega1 +
/// omega2)*(omega1 + 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 21 operations.
template <class Scalar>
Scalar lump_22(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b3 = parameters[4];
  const Scalar b5 = parameters[7];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar b3_2 = b3 * b3;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2);
  const Scalar f_0 = b3 * b5 * per_0 / (Scalar(32.0) * omega2_3);
  const Scalar f_1 = b3_2 * per_1 * per_0 / (Scalar(32.0) * omega2_2);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1) * per_0;
  const Scalar q_1 = f_1 * per_1;
  gradient[0] = -q_0 - q_1;  // by omega1
  gradient[1] = (-Scalar(3.0) * f_0 - Scalar(2.0) * f_1) / omega2 - Scalar(2.0) * q_0 - q_1;  // by omega2
  const Scalar c_0 = per_1 * per_0 / (Scalar(32.0) * omega2_2);  // multiplies b3^2
  const Scalar c_1 = per_0 / (Scalar(32.0) * omega2_3);  // multiplies b3*b5
  gradient[4] = Scalar(2.0) * b3 * c_0 + b5 * c_1;  // by b3
  gradient[7] = b3 * c_1;  // by b5
  return value;
}

/// harmonic_re_x_A_x2_A_y_F = (-3*omega1*b1*p - omega2*b3*p - 2*omega2*b3*q)/(32*omega1*omega2*(omega1 +
/// omega2)^2*(2*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 31 operations.
template <class Scalar>
Scalar lump_23(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b1 = parameters[3];
  const Scalar b3 = parameters[4];
  const Scalar p = parameters[5];
  const Scalar q = parameters[8];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar f_0 = -Scalar(3.0) * b1 * p * per_0_2 * per_1 / (Scalar(32.0) * omega2);
  const Scalar f_1 = (-b3 * p - Scalar(2.0) * b3 * q) * per_0_2 * per_1 / (Scalar(32.0) * omega1);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (Scalar(2.0) * f_0 + Scalar(2.0) * f_1) * per_0;
  const Scalar q_1 = (f_0 + f_1) * per_1;
  gradient[0] = -f_1 / omega1 - q_0 - Scalar(2.0) * q_1;  // by omega1
  gradient[1] = -f_0 / omega2 - q_0 - q_1;  // by omega2
  const Scalar c_0 = -Scalar(3.0) * per_0_2 * per_1 / (Scalar(32.0) * omega2);  // multiplies b1*p
  const Scalar c_1 = -per_0_2 * per_1 / (Scalar(32.0) * omega1);  // multiplies b3*p
  const Scalar c_2 = -per_0_2 * per_1 / (Scalar(16.0) * omega1);  // multiplies b3*q
  gradient[3] = p * c_0;  // by b1
  gradient[4] = p * c_1 + q * c_2;  // by b3
  gradient[5] = b1 * c_0 + b3 * c_1;  // by p
  gradient[8] = b3 * c_2;  // by q
  return value;
}

/// harmonic_re_x_A_x3_A_y2 = (6*omega1^2*b1*b3 + omega1*omega2*b1*b3 + 4*omega1*omega2*b3^2 +
/// omega2^2*b1*b3)/(32*omega1^2*omega2*(omega1 + omega2)^2*(2*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 38 operations.
template <class Scalar>
Scalar lump_24(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b1 = parameters[3];
  const Scalar b3 = parameters[4];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar b3_2 = b3 * b3;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar f_0 = Scalar(3.0) * b1 * b3 * per_0_2 * per_1 / (Scalar(16.0) * omega2);
  const Scalar f_1 = (b1 * b3 + Scalar(4.0) * b3_2) * per_0_2 * per_1 / (Scalar(32.0) * omega1);
  const Scalar f_2 = omega2 * b1 * b3 * per_0_2 * per_1 / (Scalar(32.0) * omega1_2);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (Scalar(2.0) * f_0 + Scalar(2.0) * f_1 + Scalar(2.0) * f_2) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2) * per_1;
  gradient[0] = (-f_1 - Scalar(2.0) * f_2) / omega1 - q_0 - Scalar(2.0) * q_1;  // by omega1
  gradient[1] = (-f_0 + f_2) / omega2 - q_0 - q_1;  // by omega2
  // multiplies b1*b3
  const Scalar c_0 = (Scalar(6.0) * omega1_2 + omega1 * omega2
      + omega2_2) * per_0_2 * per_1 / (Scalar(32.0) * omega1_2 * omega2);
  const Scalar c_1 = per_0_2 * per_1 / (Scalar(8.0) * omega1);  // multiplies b3^2
  gradient[3] = b3 * c_0;  // by b1
  gradient[4] = b1 * c_0 + Scalar(2.0) * b3 * c_1;  // by b3
  return value;
}

/// harmonic_re_y_conjA_x3_F = -b1*q/(64*omega1^3*(omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 9 operations.
template <class Scalar>
Scalar lump_25(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b1 = parameters[3];
  const Scalar q = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -b1 * q * per_0 / (Scalar(64.0) * omega1_3);
  const Scalar value = f_0;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_0 * per_0;
  gradient[0] = -Scalar(3.0) * f_0 / omega1 - q_0;  // by omega1
  gradient[1] = q_0;  // by omega2
  const Scalar c_0 = -per_0 / (Scalar(64.0) * omega1_3);  // multiplies b1*q
  gradient[3] = q * c_0;  // by b1
  gradient[8] = b1 * c_0;  // by q
  return value;
}

/// harmonic_re_y_A_y2_conjA_x2_conjA_y = (-omega1^2*b3^2 - 4*omega1*omega2*b3^2 +
/// 2*omega2^2*b3^2)/(8*omega1^3*omega2*(omega1 - omega2)^2) + (3*omega1*b3*b5 +
/// 6*omega2*b3*b5)/(8*omega1*omega2*(omega1 + omega2)*(omega1 - omega2)^2)
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 45 operations.
template <class Scalar>
Scalar lump_26(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b3 = parameters[4];
  const Scalar b5 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar b3_2 = b3 * b3;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2);
  const Scalar f_0 = -b3_2 * per_0_2 / (Scalar(8.0) * omega1 * omega2);
  const Scalar f_1 = -b3_2 * per_0_2 / (Scalar(2.0) * omega1_2);
  const Scalar f_2 = omega2 * b3_2 * per_0_2 / (Scalar(4.0) * omega1_3);
  const Scalar f_3 = Scalar(3.0) * b3 * b5 * per_1 * per_0_2 / (Scalar(8.0) * omega2);
  const Scalar f_4 = Scalar(3.0) * b3 * b5 * per_1 * per_0_2 / (Scalar(4.0) * omega1);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (Scalar(2.0) * f_0 + Scalar(2.0) * f_1 + Scalar(2.0) * f_2 + Scalar(2.0) * f_3
      + Scalar(2.0) * f_4) * per_0;
  const Scalar q_1 = (f_3 + f_4) * per_1;
  gradient[0] = (-f_0 - Scalar(2.0) * f_1 - Scalar(3.0) * f_2 - f_4) / omega1 - q_0 - q_1;  // by omega1
  gradient[1] = (-f_0 + f_2 - f_3) / omega2 + q_0 - q_1;  // by omega2
  // multiplies b3^2
  const Scalar c_0 = (-omega1_2 - Scalar(4.0) * omega1 * omega2
      + Scalar(2.0) * omega2_2) * per_0_2 / (Scalar(8.0) * omega1_3 * omega2);
  // multiplies b3*b5
  const Scalar c_1 = (Scalar(3.0) * omega1
      + Scalar(6.0) * omega2) * per_1 * per_0_2 / (Scalar(8.0) * omega1 * omega2);
  gradient[4] = Scalar(2.0) * b3 * c_0 + b5 * c_1;  // by b3
  gradient[7] = b3 * c_1;  // by b5
  return value;
}

/// harmonic_re_y_A_x_A_y_conjA_x3 = (4*omega1^2*b3^2 - 11*omega1*omega2*b1*b3 +
/// 5*omega2^2*b1*b3)/(16*omega1^3*omega2*(omega1 - omega2)^2)
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 28 operations.
template <class Scalar>
Scalar lump_27(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b1 = parameters[3];
  const Scalar b3 = parameters[4];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar b3_2 = b3 * b3;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar f_0 = b3_2 * per_0_2 / (Scalar(4.0) * omega1 * omega2);
  const Scalar f_1 = -Scalar(11.0) * b1 * b3 * per_0_2 / (Scalar(16.0) * omega1_2);
  const Scalar f_2 = Scalar(5.0) * omega2 * b1 * b3 * per_0_2 / (Scalar(16.0) * omega1_3);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (Scalar(2.0) * f_0 + Scalar(2.0) * f_1 + Scalar(2.0) * f_2) * per_0;
  gradient[0] = (-f_0 - Scalar(2.0) * f_1 - Scalar(3.0) * f_2) / omega1 - q_0;  // by omega1
  gradient[1] = (-f_0 + f_2) / omega2 + q_0;  // by omega2
  // multiplies b1*b3
  const Scalar c_0 = (-Scalar(11.0) * omega1 + Scalar(5.0) * omega2) * per_0_2 / (Scalar(16.0) * omega1_3);
  const Scalar c_1 = per_0_2 / (Scalar(4.0) * omega1 * omega2);  // multiplies b3^2
  gradient[3] = b3 * c_0;  // by b1
  gradient[4] = b1 * c_0 + Scalar(2.0) * b3 * c_1;  // by b3
  return value;
}

/// harmonic_re_y_A_y2_conjA_x_F = b3*q/(32*omega1*omega2*(omega1 - omega2)^2) - 3*b5*q/(32*omega1^2*(omega1 +
/// omega2)*(omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 23 operations.
template <class Scalar>
Scalar lump_28(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b3 = parameters[4];
  const Scalar b5 = parameters[7];
  const Scalar q = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2);
  const Scalar f_0 = b3 * q * per_0_2 / (Scalar(32.0) * omega1 * omega2);
  const Scalar f_1 = -Scalar(3.0) * b5 * q * per_1 * per_0 / (Scalar(32.0) * omega1_2);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (Scalar(2.0) * f_0 + f_1) * per_0;
  const Scalar q_1 = f_1 * per_1;
  gradient[0] = (-f_0 - Scalar(2.0) * f_1) / omega1 - q_0 - q_1;  // by omega1
  gradient[1] = -f_0 / omega2 + q_0 - q_1;  // by omega2
  const Scalar c_0 = per_0_2 / (Scalar(32.0) * omega1 * omega2);  // multiplies b3*q
  const Scalar c_1 = -Scalar(3.0) * per_1 * per_0 / (Scalar(32.0) * omega1_2);  // multiplies b5*q
  gradient[4] = q * c_0;  // by b3
  gradient[7] = q * c_1;  // by b5
  gradient[8] = b3 * c_0 + b5 * c_1;  // by q
  return value;
}

/// harmonic_re_y_A_x_A_y3_conjA_x = -b3*b5/(4*omega2^4) - b3^2/(8*omega2^2*(omega1 + omega2)*(omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 18 operations.
template <class Scalar>
Scalar lump_29(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b3 = parameters[4];
  const Scalar b5 = parameters[7];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar b3_2 = b3 * b3;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -b3 * b5 / (Scalar(4.0) * omega2_4);
  const Scalar f_1 = -b3_2 * per_0 * per_1 / (Scalar(8.0) * omega2_2);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_1 * per_0;
  const Scalar q_1 = f_1 * per_1;
  gradient[0] = -q_0 - q_1;  // by omega1
  gradient[1] = (-Scalar(4.0) * f_0 - Scalar(2.0) * f_1) / omega2 - q_0 + q_1;  // by omega2
  const Scalar c_0 = -per_0 * per_1 / (Scalar(8.0) * omega2_2);  // multiplies b3^2
  const Scalar c_1 = -Scalar(1.0) / (Scalar(4.0) * omega2_4);  // multiplies b3*b5
  gradient[4] = Scalar(2.0) * b3 * c_0 + b5 * c_1;  // by b3
  gradient[7] = b3 * c_1;  // by b5
  return value;
}

/// harmonic_re_y_A_x_A_y_conjA_y_F = (-omega1^2*b3*p + 2*omega1*omega2*b3*q - 3*omega1*omega2*b5*q +
/// omega2^2*b3*q)/(16*omega1^3*omega2*(omega1 + omega2)^2)
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 32 operations.
template <class Scalar>
Scalar lump_30(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b3 = parameters[4];
  const Scalar p = parameters[5];
  const Scalar b5 = parameters[7];
  const Scalar q = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar f_0 = -b3 * p * per_0_2 / (Scalar(16.0) * omega1 * omega2);
  const Scalar f_1 = (Scalar(2.0) * b3 * q - Scalar(3.0) * b5 * q) * per_0_2 / (Scalar(16.0) * omega1_2);
  const Scalar f_2 = omega2 * b3 * q * per_0_2 / (Scalar(16.0) * omega1_3);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (Scalar(2.0) * f_0 + Scalar(2.0) * f_1 + Scalar(2.0) * f_2) * per_0;
  gradient[0] = (-f_0 - Scalar(2.0) * f_1 - Scalar(3.0) * f_2) / omega1 - q_0;  // by omega1
  gradient[1] = (-f_0 + f_2) / omega2 - q_0;  // by omega2
  const Scalar c_0 = -per_0_2 / (Scalar(16.0) * omega1 * omega2);  // multiplies b3*p
  const Scalar c_1 = (Scalar(2.0) * omega1 + omega2) * per_0_2 / (Scalar(16.0) * omega1_3);  // multiplies b3*q
  const Scalar c_2 = -Scalar(3.0) * per_0_2 / (Scalar(16.0) * omega1_2);  // multiplies b5*q
  gradient[4] = p * c_0 + q * c_1;  // by b3
  gradient[5] = b3 * c_0;  // by p
  gradient[7] = q * c_2;  // by b5
  gradient[8] = b3 * c_1 + b5 * c_2;  // by q
  return value;
}

/// harmonic_re_y_A_x2_conjA_x_F = (6*omega1*b1*q - 2*omega1*b3*q + 3*omega2*b1*q)/(32*omega1^3*(omega1 +
/// omega2)^2)
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 24 operations.
template <class Scalar>
Scalar lump_31(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b1 = parameters[3];
  const Scalar b3 = parameters[4];
  const Scalar q = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar f_0 = (Scalar(3.0) * b1 * q - b3 * q) * per_0_2 / (Scalar(16.0) * omega1_2);
  const Scalar f_1 = Scalar(3.0) * omega2 * b1 * q * per_0_2 / (Scalar(32.0) * omega1_3);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (Scalar(2.0) * f_0 + Scalar(2.0) * f_1) * per_0;
  gradient[0] = (-Scalar(2.0) * f_0 - Scalar(3.0) * f_1) / omega1 - q_0;  // by omega1
  gradient[1] = f_1 / omega2 - q_0;  // by omega2
  // multiplies b1*q
  const Scalar c_0 = (Scalar(6.0) * omega1 + Scalar(3.0) * omega2) * per_0_2 / (Scalar(32.0) * omega1_3);
  const Scalar c_1 = -per_0_2 / (Scalar(16.0) * omega1_2);  // multiplies b3*q
  gradient[3] = q * c_0;  // by b1
  gradient[4] = q * c_1;  // by b3
  gradient[8] = b1 * c_0 + b3 * c_1;  // by q
  return value;
}

/// harmonic_re_y_A_x2_A_y2_conjA_y = (omega1^2*b3^2 - 4*omega1*omega2*b3^2 -
/// 2*omega2^2*b3^2)/(8*omega1^3*omega2*(omega1 + omega2)^2) + (-3*omega1*b3*b5 +
/// 6*omega2*b3*b5)/(8*omega1*omega2*(omega1 + omega2)^2*(omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 45 operations.
template <class Scalar>
Scalar lump_32(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b3 = parameters[4];
  const Scalar b5 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar b3_2 = b3 * b3;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = b3_2 * per_0_2 / (Scalar(8.0) * omega1 * omega2);
  const Scalar f_1 = -b3_2 * per_0_2 / (Scalar(2.0) * omega1_2);
  const Scalar f_2 = -omega2 * b3_2 * per_0_2 / (Scalar(4.0) * omega1_3);
  const Scalar f_3 = -Scalar(3.0) * b3 * b5 * per_0_2 * per_1 / (Scalar(8.0) * omega2);
  const Scalar f_4 = Scalar(3.0) * b3 * b5 * per_0_2 * per_1 / (Scalar(4.0) * omega1);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (Scalar(2.0) * f_0 + Scalar(2.0) * f_1 + Scalar(2.0) * f_2 + Scalar(2.0) * f_3
      + Scalar(2.0) * f_4) * per_0;
  const Scalar q_1 = (f_3 + f_4) * per_1;
  gradient[0] = (-f_0 - Scalar(2.0) * f_1 - Scalar(3.0) * f_2 - f_4) / omega1 - q_0 - q_1;  // by omega1
  gradient[1] = (-f_0 + f_2 - f_3) / omega2 - q_0 + q_1;  // by omega2
  // multiplies b3^2
  const Scalar c_0 = (omega1_2 - Scalar(4.0) * omega1 * omega2
      - Scalar(2.0) * omega2_2) * per_0_2 / (Scalar(8.0) * omega1_3 * omega2);
  // multiplies b3*b5
  const Scalar c_1 = (-Scalar(3.0) * omega1
      + Scalar(6.0) * omega2) * per_0_2 * per_1 / (Scalar(8.0) * omega1 * omega2);
  gradient[4] = Scalar(2.0) * b3 * c_0 + b5 * c_1;  // by b3
  gradient[7] = b3 * c_1;  // by b5
  return value;
}

/// harmonic_re_y_A_x3_A_y_conjA_x = (-4*omega1^2*b3^2 - 11*omega1*omega2*b1*b3 -
/// 5*omega2^2*b1*b3)/(16*omega1^3*omega2*(omega1 + omega2)^2)
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 28 operations.
template <class Scalar>
Scalar lump_33(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b1 = parameters[3];
  const Scalar b3 = parameters[4];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar b3_2 = b3 * b3;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar f_0 = -b3_2 * per_0_2 / (Scalar(4.0) * omega1 * omega2);
  const Scalar f_1 = -Scalar(11.0) * b1 * b3 * per_0_2 / (Scalar(16.0) * omega1_2);
  const Scalar f_2 = -Scalar(5.0) * omega2 * b1 * b3 * per_0_2 / (Scalar(16.0) * omega1_3);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (Scalar(2.0) * f_0 + Scalar(2.0) * f_1 + Scalar(2.0) * f_2) * per_0;
  gradient[0] = (-f_0 - Scalar(2.0) * f_1 - Scalar(3.0) * f_2) / omega1 - q_0;  // by omega1
  gradient[1] = (-f_0 + f_2) / omega2 - q_0;  // by omega2
  // multiplies b1*b3
  const Scalar c_0 = (-Scalar(11.0) * omega1 - Scalar(5.0) * omega2) * per_0_2 / (Scalar(16.0) * omega1_3);
  const Scalar c_1 = -per_0_2 / (Scalar(4.0) * omega1 * omega2);  // multiplies b3^2
  gradient[3] = b3 * c_0;  // by b1
  gradient[4] = b1 * c_0 + Scalar(2.0) * b3 * c_1;  // by b3
  return value;
}

/// harmonic_re_y_A_y3_conjA_x2 = (omega1^2*b3*b5 - 4*omega1*omega2*b3^2 - omega1*omega2*b3*b5 +
/// 6*omega2^2*b3*b5)/(32*omega1*omega2^2*(omega1 - omega2)^2*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 38 operations.
template <class Scalar>
Scalar lump_34(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b3 = parameters[4];
  const Scalar b5 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar b3_2 = b3 * b3;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = omega1 * b3 * b5 * per_0_2 * per_1 / (Scalar(32.0) * omega2_2);
  const Scalar f_1 = (-Scalar(4.0) * b3_2 - b3 * b5) * per_0_2 * per_1 / (Scalar(32.0) * omega2);
  const Scalar f_2 = Scalar(3.0) * b3 * b5 * per_0_2 * per_1 / (Scalar(16.0) * omega1);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (Scalar(2.0) * f_0 + Scalar(2.0) * f_1 + Scalar(2.0) * f_2) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2) * per_1;
  gradient[0] = (f_0 - f_2) / omega1 - q_0 - q_1;  // by omega1
  gradient[1] = (-Scalar(2.0) * f_0 - f_1) / omega2 + q_0 + Scalar(2.0) * q_1;  // by omega2
  const Scalar c_0 = -per_0_2 * per_1 / (Scalar(8.0) * omega2);  // multiplies b3^2
  // multiplies b3*b5
  const Scalar c_1 = (omega1_2 - omega1 * omega2
      + Scalar(6.0) * omega2_2) * per_0_2 * per_1 / (Scalar(32.0) * omega1 * omega2_2);
  gradient[4] = Scalar(2.0) * b3 * c_0 + b5 * c_1;  // by b3
  gradient[7] = b3 * c_1;  // by b5
  return value;
}

/// harmonic_re_y_A_x_A_y2_F = (-2*omega1*b3*p - omega1*b3*q - 3*omega2*b5*q)/(32*omega1*omega2*(omega1 +
/// omega2)^2*(omega1 + 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 31 operations.
template <class Scalar>
Scalar lump_35(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b3 = parameters[4];
  const Scalar p = parameters[5];
  const Scalar b5 = parameters[7];
  const Scalar q = parameters[8];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar f_0 = (-Scalar(2.0) * b3 * p - b3 * q) * per_0_2 * per_1 / (Scalar(32.0) * omega2);
  const Scalar f_1 = -Scalar(3.0) * b5 * q * per_0_2 * per_1 / (Scalar(32.0) * omega1);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (Scalar(2.0) * f_0 + Scalar(2.0) * f_1) * per_0;
  const Scalar q_1 = (f_0 + f_1) * per_1;
  gradient[0] = -f_1 / omega1 - q_0 - q_1;  // by omega1
  gradient[1] = -f_0 / omega2 - q_0 - Scalar(2.0) * q_1;  // by omega2
  const Scalar c_0 = -per_0_2 * per_1 / (Scalar(16.0) * omega2);  // multiplies b3*p
  const Scalar c_1 = -per_0_2 * per_1 / (Scalar(32.0) * omega2);  // multiplies b3*q
  const Scalar c_2 = -Scalar(3.0) * per_0_2 * per_1 / (Scalar(32.0) * omega1);  // multiplies b5*q
  gradient[4] = p * c_0 + q * c_1;  // by b3
  gradient[5] = b3 * c_0;  // by p
  gradient[7] = q * c_2;  // by b5
  gradient[8] = b3 * c_1 + b5 * c_2;  // by q
  return value;
}

/// harmonic_re_y_A_x2_A_y3 = (omega1^2*b3*b5 + 4*omega1*omega2*b3^2 + omega1*omega2*b3*b5 +
/// 6*omega2^2*b3*b5)/(32*omega1*omega2^2*(omega1 + omega2)^2*(omega1 + 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 38 operations.
template <class Scalar>
Scalar lump_36(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b3 = parameters[4];
  const Scalar b5 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar b3_2 = b3 * b3;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar f_0 = omega1 * b3 * b5 * per_0_2 * per_1 / (Scalar(32.0) * omega2_2);
  const Scalar f_1 = (Scalar(4.0) * b3_2 + b3 * b5) * per_0_2 * per_1 / (Scalar(32.0) * omega2);
  const Scalar f_2 = Scalar(3.0) * b3 * b5 * per_0_2 * per_1 / (Scalar(16.0) * omega1);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (Scalar(2.0) * f_0 + Scalar(2.0) * f_1 + Scalar(2.0) * f_2) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2) * per_1;
  gradient[0] = (f_0 - f_2) / omega1 - q_0 - q_1;  // by omega1
  gradient[1] = (-Scalar(2.0) * f_0 - f_1) / omega2 - q_0 - Scalar(2.0) * q_1;  // by omega2
  const Scalar c_0 = per_0_2 * per_1 / (Scalar(8.0) * omega2);  // multiplies b3^2
  // multiplies b3*b5
  const Scalar c_1 = (omega1_2 + omega1 * omega2
      + Scalar(6.0) * omega2_2) * per_0_2 * per_1 / (Scalar(32.0) * omega1 * omega2_2);
  gradient[4] = Scalar(2.0) * b3 * c_0 + b5 * c_1;  // by b3
  gradient[7] = b3 * c_1;  // by b5
  return value;
}

/// harmonic_re_y_A_x3_F = -b1*q/(128*omega1^3*(2*omega1 + omega2)) - b3*q/(64*omega1^2*(omega1 +
/// omega2)*(2*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 21 operations.
template <class Scalar>
Scalar lump_37(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b1 = parameters[3];
  const Scalar b3 = parameters[4];
  const Scalar q = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2);
  const Scalar f_0 = -b1 * q * per_0 / (Scalar(128.0) * omega1_3);
  const Scalar f_1 = -b3 * q * per_1 * per_0 / (Scalar(64.0) * omega1_2);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1) * per_0;
  const Scalar q_1 = f_1 * per_1;
  gradient[0] = (-Scalar(3.0) * f_0 - Scalar(2.0) * f_1) / omega1 - Scalar(2.0) * q_0 - q_1;  // by omega1
  gradient[1] = -q_0 - q_1;  // by omega2
  const Scalar c_0 = -per_0 / (Scalar(128.0) * omega1_3);  // multiplies b1*q
  const Scalar c_1 = -per_1 * per_0 / (Scalar(64.0) * omega1_2);  // multiplies b3*q
  gradient[3] = q * c_0;  // by b1
  gradient[4] = q * c_1;  // by b3
  gradient[8] = b1 * c_0 + b3 * c_1;  // by q
  return value;
}

/// harmonic_re_y_A_x4_A_y = b1*b3/(32*omega1^3*(2*omega1 + omega2)) + b3^2/(32*omega1^2*(omega1 +
/// omega2)*(2*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 21 operations.
template <class Scalar>
Scalar lump_38(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b1 = parameters[3];
  const Scalar b3 = parameters[4];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar b3_2 = b3 * b3;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2);
  const Scalar f_0 = b1 * b3 * per_0 / (Scalar(32.0) * omega1_3);
  const Scalar f_1 = b3_2 * per_1 * per_0 / (Scalar(32.0) * omega1_2);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1) * per_0;
  const Scalar q_1 = f_1 * per_1;
  gradient[0] = (-Scalar(3.0) * f_0 - Scalar(2.0) * f_1) / omega1 - Scalar(2.0) * q_0 - q_1;  // by omega1
  gradient[1] = -q_0 - q_1;  // by omega2
  const Scalar c_0 = per_0 / (Scalar(32.0) * omega1_3);  // multiplies b1*b3
  const Scalar c_1 = per_1 * per_0 / (Scalar(32.0) * omega1_2);  // multiplies b3^2
  gradient[3] = b3 * c_0;  // by b1
  gradient[4] = b1 * c_0 + Scalar(2.0) * b3 * c_1;  // by b3
  return value;
}

/// harmonic_re_y_A_x4_conjA_y = b1*b3/(32*omega1^3*(2*omega1 - omega2)) + b3^2/(32*omega1^2*(omega1 -
/// omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 21 operations.
template <class Scalar>
Scalar lump_39(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar b1 = parameters[3];
  const Scalar b3 = parameters[4];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar b3_2 = b3 * b3;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = b1 * b3 * per_0 / (Scalar(32.0) * omega1_3);
  const Scalar f_1 = b3_2 * per_1 * per_0 / (Scalar(32.0) * omega1_2);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1) * per_0;
  const Scalar q_1 = f_1 * per_1;
  gradient[0] = (-Scalar(3.0) * f_0 - Scalar(2.0) * f_1) / omega1 - Scalar(2.0) * q_0 - q_1;  // by omega1
  gradient[1] = q_0 + q_1;  // by omega2
  const Scalar c_0 = per_0 / (Scalar(32.0) * omega1_3);  // multiplies b1*b3
  const Scalar c_1 = per_1 * per_0 / (Scalar(32.0) * omega1_2);  // multiplies b3^2
  gradient[3] = b3 * c_0;  // by b1
  gradient[4] = b1 * c_0 + Scalar(2.0) * b3 * c_1;  // by b3
  return value;
}

namespace additive {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: mu1 = mu1
/// lumps[1]: b3 = b3
/// lumps[2]: b1 = b1
/// lumps[3]: p = p
/// lumps[4]: mu2 = mu2
/// lumps[5]: b5 = b5
/// lumps[6]: q = q
/// 0 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
  const Scalar mu1 = parameters[2];
  const Scalar b1 = parameters[3];
  const Scalar b3 = parameters[4];
  const Scalar p = parameters[5];
  const Scalar mu2 = parameters[6];
  const Scalar b5 = parameters[7];
  const Scalar q = parameters[8];
  lumps[0] = mu1;  // mu1
  lumps[1] = b3;  // b3
  lumps[2] = b1;  // b1
  lumps[3] = p;  // p
  lumps[4] = mu2;  // mu2
  lumps[5] = b5;  // b5
  lumps[6] = q;  // q
}

/// jacobian[l * 9 + p] = d lumps[l] / d parameters[p]. 0 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  for (std::size_t i = 0; i < 63; ++i) jacobian[i] = Scalar(0.0);
  jacobian[2] = Scalar(1.0);  // d mu1 / d mu1
  jacobian[13] = Scalar(1.0);  // d b3 / d b3
  jacobian[21] = Scalar(1.0);  // d b1 / d b1
  jacobian[32] = Scalar(1.0);  // d p / d p
  jacobian[42] = Scalar(1.0);  // d mu2 / d mu2
  jacobian[52] = Scalar(1.0);  // d b5 / d b5
  jacobian[62] = Scalar(1.0);  // d q / d q
}

/// What multiplies the 4 terms of the modulation of x: functions of the frequencies alone. 5 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  factor[0] = -Scalar(1.0);
  factor[1] = Scalar(1.0) / omega1;
  factor[2] = Scalar(3.0) / (Scalar(2.0) * omega1);
  factor[3] = -Scalar(1.0) / (Scalar(4.0) * omega1);
}

/// Rows of the modulation of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega1)*A_x = -mu1*A_x + 1/omega1*i*b3*A_x*A_y*conj(A_y) + 3/(2*omega1)*i*b1*A_x^2*conj(A_x) -
/// 1/(4*omega1)*i*p*conj(A_y)*F
/// 4 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_0(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Complex conj_A_y = conjugate(A_y);
    const Scalar norm_A_y = norm_of(A_y);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_x));  // mu1
    store_complex(column_1, i, times_i(factor[1] * (A_x * norm_A_y)));  // b3
    store_complex(column_2, i, times_i(factor[2] * (norm_A_x * A_x)));  // b1
    store_complex(column_3, i, times_i(factor[3] * (conj_A_y * F)));  // p
  }
}

/// columns[j][i] of the rows.
inline void columns_0(const BatchArrays& data, double* const* columns) {
  rows_0(data, FactorValues<factors_0<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_0(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_0(data, FactorSlopes<factors_0<DualNumber>, 2, 1, 4>{mode}, columns);
}

/// What multiplies the 4 terms of the modulation of y: functions of the frequencies alone. 5 operations.
template <class Scalar>
void factors_1([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega2 = natural_frequency[1];
  factor[0] = Scalar(1.0) / omega2;
  factor[1] = -Scalar(1.0);
  factor[2] = Scalar(3.0) / (Scalar(2.0) * omega2);
  factor[3] = -Scalar(1.0) / (Scalar(4.0) * omega2);
}

/// Rows of the modulation of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega2)*A_y = 1/omega2*i*b3*A_x*conj(A_x)*A_y - mu2*A_y + 3/(2*omega2)*i*b5*A_y^2*conj(A_y) -
/// 1/(4*omega2)*i*q*conj(A_x)*F
/// 4 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_1(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Scalar norm_A_y = norm_of(A_y);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, times_i(factor[0] * (norm_A_x * A_y)));  // b3
    store_complex(column_1, i, factor[1] * (A_y));  // mu2
    store_complex(column_2, i, times_i(factor[2] * (norm_A_y * A_y)));  // b5
    store_complex(column_3, i, times_i(factor[3] * (conj_A_x * F)));  // q
  }
}

/// columns[j][i] of the rows.
inline void columns_1(const BatchArrays& data, double* const* columns) {
  rows_1(data, FactorValues<factors_1<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_1(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_1(data, FactorSlopes<factors_1<DualNumber>, 2, 1, 4>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic -omega1+2*omega2 of x: functions of the frequencies alone. 4
/// operations.
template <class Scalar>
void factors_2([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  factor[0] = -per_0 / (Scalar(4.0) * omega2);
}

/// Rows of the harmonic -omega1+2*omega2 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + 2*omega2)*t) in x = -1/(4*omega2*(omega1 - omega2))*b3*conj(A_x)*A_y^2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_2(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (conj_A_x * A_y * A_y));  // b3
  }
}

/// columns[j][i] of the rows.
inline void columns_2(const BatchArrays& data, double* const* columns) {
  rows_2(data, FactorValues<factors_2<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_2(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_2(data, FactorSlopes<factors_2<DualNumber>, 2, 1, 1>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic omega2+Omega of x: functions of the frequencies alone. 12
/// operations.
template <class Scalar>
void factors_3([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2 + Omega);
  const Scalar per_2 = Scalar(1.0) / (omega1 - omega2 - Omega);
  factor[0] = per_0 / (Scalar(4.0) * omega2);
  factor[1] = per_1 * per_2 / Scalar(2.0);
}

/// Rows of the harmonic omega2+Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + Omega)*t) in x = 1/(4*omega2*(omega1 + omega2))*b3*A_x*A_y^2 + 1/(2*(omega1 +
/// omega2 + Omega)*(omega1 - omega2 - Omega))*p*A_y*F
/// 2 columns; per observation at most 8 products and sums of complex numbers.
template <class Factors>
void rows_3(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex A_y = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_x * A_y * A_y));  // b3
    store_complex(column_1, i, factor[1] * (A_y * F));  // p
  }
}

/// columns[j][i] of the rows.
inline void columns_3(const BatchArrays& data, double* const* columns) {
  rows_3(data, FactorValues<factors_3<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_3(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_3(data, FactorSlopes<factors_3<DualNumber>, 2, 1, 2>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 3*omega1 of x: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_4([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  factor[0] = Scalar(1.0) / (Scalar(8.0) * omega1_2);
}

/// Rows of the harmonic 3*omega1 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega1)*t) in x = 1/(8*omega1^2)*b1*A_x^3
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_4(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    store_complex(column_0, i, factor[0] * (A_x * A_x * A_x));  // b1
  }
}

/// columns[j][i] of the rows.
inline void columns_4(const BatchArrays& data, double* const* columns) {
  rows_4(data, FactorValues<factors_4<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_4(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_4(data, FactorSlopes<factors_4<DualNumber>, 2, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic -2*omega1+omega2 of y: functions of the frequencies alone. 4
/// operations.
template <class Scalar>
void factors_5([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  factor[0] = per_0 / (Scalar(4.0) * omega1);
}

/// Rows of the harmonic -2*omega1+omega2 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-2*omega1 + omega2)*t) in y = 1/(4*omega1*(omega1 - omega2))*b3*conj(A_x)^2*A_y
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_5(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (conj_A_x * conj_A_x * A_y));  // b3
  }
}

/// columns[j][i] of the rows.
inline void columns_5(const BatchArrays& data, double* const* columns) {
  rows_5(data, FactorValues<factors_5<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_5(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_5(data, FactorSlopes<factors_5<DualNumber>, 2, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 3*omega2 of y: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_6([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega2_2 = omega2 * omega2;
  factor[0] = Scalar(1.0) / (Scalar(8.0) * omega2_2);
}

/// Rows of the harmonic 3*omega2 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega2)*t) in y = 1/(8*omega2^2)*b5*A_y^3
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_6(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_y = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_y * A_y * A_y));  // b5
  }
}

/// columns[j][i] of the rows.
inline void columns_6(const BatchArrays& data, double* const* columns) {
  rows_6(data, FactorValues<factors_6<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_6(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_6(data, FactorSlopes<factors_6<DualNumber>, 2, 1, 1>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic omega1+Omega of y: functions of the frequencies alone. 12
/// operations.
template <class Scalar>
void factors_7([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2 + Omega);
  const Scalar per_2 = Scalar(1.0) / (omega1 - omega2 + Omega);
  factor[0] = per_0 / (Scalar(4.0) * omega1);
  factor[1] = -per_1 * per_2 / Scalar(2.0);
}

/// Rows of the harmonic omega1+Omega of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + Omega)*t) in y = 1/(4*omega1*(omega1 + omega2))*b3*A_x^2*A_y - 1/(2*(omega1 +
/// omega2 + Omega)*(omega1 - omega2 + Omega))*q*A_x*F
/// 2 columns; per observation at most 8 products and sums of complex numbers.
template <class Factors>
void rows_7(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex A_y = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_x * A_x * A_y));  // b3
    store_complex(column_1, i, factor[1] * (A_x * F));  // q
  }
}

/// columns[j][i] of the rows.
inline void columns_7(const BatchArrays& data, double* const* columns) {
  rows_7(data, FactorValues<factors_7<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_7(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_7(data, FactorSlopes<factors_7<DualNumber>, 2, 1, 2>{mode}, columns);
}

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_x/dt + i*(w_x - omega1)*B_x = -mu1*A_x + 1/omega1*i*b3*A_x*A_y*conj(A_y) +
/// 3/(2*omega1)*i*b1*A_x^2*conj(A_x) - 1/(4*omega1)*i*p*conj(A_y)*F with A = B in that frame
/// dB_y/dt + i*(w_y - omega2)*B_y = 1/omega2*i*b3*A_x*conj(A_x)*A_y - mu2*A_y +
/// 3/(2*omega2)*i*b5*A_y^2*conj(A_y) - 1/(4*omega2)*i*q*conj(A_x)*F with A = B in that frame
/// 42 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  Scalar lumps[7];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Complex conj_A_x = conjugate(A_x);
  const Scalar norm_A_x = norm_of(A_x);
  const Complex A_y = load_complex(amplitude, 1);
  const Complex conj_A_y = conjugate(A_y);
  const Scalar norm_A_y = norm_of(A_y);
  const Complex F = load_complex(forcing, 0);
  store_complex(derivative, 0, lumps[0] * (-Scalar(1.0)) * (A_x)
       + times_i(lumps[1] * Scalar(1.0) / omega1 * (A_x * norm_A_y))
       + times_i(lumps[2] * Scalar(3.0) / (Scalar(2.0) * omega1) * (norm_A_x * A_x))
       + times_i(lumps[3] * (-Scalar(1.0) / (Scalar(4.0) * omega1)) * (conj_A_y * F))
       - times_i((-omega1 - omega2 + excitation_frequency[0]) * A_x));
  store_complex(derivative, 1, times_i(lumps[1] * Scalar(1.0) / omega2 * (norm_A_x * A_y))
       + lumps[4] * (-Scalar(1.0)) * (A_y)
       + times_i(lumps[5] * Scalar(3.0) / (Scalar(2.0) * omega2) * (norm_A_y * A_y))
       + times_i(lumps[6] * (-Scalar(1.0) / (Scalar(4.0) * omega2)) * (conj_A_x * F)));
}

/// jacobian[i * 4 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 77 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  Scalar lumps[7];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Complex conj_A_x = conjugate(A_x);
  const Scalar norm_A_x = norm_of(A_x);
  const Complex A_y = load_complex(amplitude, 1);
  const Complex conj_A_y = conjugate(A_y);
  const Scalar norm_A_y = norm_of(A_y);
  const Complex F = load_complex(forcing, 0);
  for (std::size_t i = 0; i < 16; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = Complex(lumps[0] * (-Scalar(1.0)))
       + times_i(Complex(lumps[1] * Scalar(1.0) / omega1 * (norm_A_y)))
       + times_i(Complex(lumps[2] * Scalar(3.0) / (Scalar(2.0) * omega1) * Scalar(2) * (norm_A_x)))
       - Complex(Scalar(0.0), -omega1 - omega2 + excitation_frequency[0]);
  const Complex conj_by_0_0 = times_i(lumps[2] * Scalar(3.0) / (Scalar(2.0) * omega1) * (A_x * A_x));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[4] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[5] = by_0_0.real - conj_by_0_0.real;
  const Complex by_0_1 = times_i(lumps[1] * Scalar(1.0) / omega1 * (A_x * conj_A_y));
  const Complex conj_by_0_1 = times_i(lumps[1] * Scalar(1.0) / omega1 * (A_x * A_y))
       + times_i(lumps[3] * (-Scalar(1.0) / (Scalar(4.0) * omega1)) * (F));
  jacobian[2] = by_0_1.real + conj_by_0_1.real;
  jacobian[3] = conj_by_0_1.imag - by_0_1.imag;
  jacobian[6] = by_0_1.imag + conj_by_0_1.imag;
  jacobian[7] = by_0_1.real - conj_by_0_1.real;
  const Complex by_1_0 = times_i(lumps[1] * Scalar(1.0) / omega2 * (conj_A_x * A_y));
  const Complex conj_by_1_0 = times_i(lumps[1] * Scalar(1.0) / omega2 * (A_x * A_y))
       + times_i(lumps[6] * (-Scalar(1.0) / (Scalar(4.0) * omega2)) * (F));
  jacobian[8] = by_1_0.real + conj_by_1_0.real;
  jacobian[9] = conj_by_1_0.imag - by_1_0.imag;
  jacobian[12] = by_1_0.imag + conj_by_1_0.imag;
  jacobian[13] = by_1_0.real - conj_by_1_0.real;
  const Complex by_1_1 = times_i(Complex(lumps[1] * Scalar(1.0) / omega2 * (norm_A_x)))
       + Complex(lumps[4] * (-Scalar(1.0)))
       + times_i(Complex(lumps[5] * Scalar(3.0) / (Scalar(2.0) * omega2) * Scalar(2) * (norm_A_y)));
  const Complex conj_by_1_1 = times_i(lumps[5] * Scalar(3.0) / (Scalar(2.0) * omega2) * (A_y * A_y));
  jacobian[10] = by_1_1.real + conj_by_1_1.real;
  jacobian[11] = conj_by_1_1.imag - by_1_1.imag;
  jacobian[14] = by_1_1.imag + conj_by_1_1.imag;
  jacobian[15] = by_1_1.real - conj_by_1_1.real;
}

}  // namespace additive

namespace additive_second_order {

/// Lumps: the parameter combinations that multiply data.
/// lumps[1]: mu1 = mu1
/// lumps[2]: conservative_x_A_x = -mu1^2/(2*omega1)
/// lumps[4]: dissipative_x_A_x_A_y_conjA_y = b3*mu2/omega1^2
/// lumps[5]: b3 = b3
/// lumps[7]: dissipative_x_A_x2_conjA_x = 3*mu1*b1/(2*omega1^2)
/// lumps[8]: b1 = b1
/// lumps[10]: conservative_x_A_x3_conjA_x2 = -15*b1^2/(16*omega1^3)
/// lumps[11]: dissipative_x_conjA_y_F = (mu1*p - p*mu2)/(8*omega1^2)
/// lumps[12]: p = p
/// lumps[16]: mu2 = mu2
/// lumps[17]: conservative_y_A_y = -mu2^2/(2*omega2)
/// lumps[18]: dissipative_y_A_y2_conjA_y = 3*mu2*b5/(2*omega2^2)
/// lumps[19]: b5 = b5
/// lumps[20]: conservative_y_A_y3_conjA_y2 = -15*b5^2/(16*omega2^3)
/// lumps[21]: dissipative_y_A_x_A_y_conjA_x = mu1*b3/omega2^2
/// lumps[23]: dissipative_y_conjA_x_F = (-mu1*q + mu2*q)/(8*omega2^2)
/// lumps[24]: q = q
/// 32 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
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
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar mu1_2 = mu1 * mu1;
  const Scalar b1_2 = b1 * b1;
  const Scalar mu2_2 = mu2 * mu2;
  const Scalar b5_2 = b5 * b5;
  lumps[0] = lump_0(parameters, static_cast<Scalar*>(nullptr));  // conservative_x_A_x2_A_y_F
  lumps[1] = mu1;  // mu1
  lumps[2] = -mu1_2 / (Scalar(2.0) * omega1);  // conservative_x_A_x
  lumps[3] = lump_1(parameters, static_cast<Scalar*>(nullptr));  // conservative_x_A_x_F2
  lumps[4] = b3 * mu2 / omega1_2;  // dissipative_x_A_x_A_y_conjA_y
  lumps[5] = b3;  // b3
  lumps[6] = lump_2(parameters, static_cast<Scalar*>(nullptr));  // conservative_x_A_x_A_y2_conjA_y2
  lumps[7] = Scalar(3.0) * mu1 * b1 / (Scalar(2.0) * omega1_2);  // dissipative_x_A_x2_conjA_x
  lumps[8] = b1;  // b1
  lumps[9] = lump_3(parameters, static_cast<Scalar*>(nullptr));  // conservative_x_A_x2_A_y_conjA_x_conjA_y
  lumps[10] = -Scalar(15.0) * b1_2 / (Scalar(16.0) * omega1_3);  // conservative_x_A_x3_conjA_x2
  lumps[11] = (mu1 * p - p * mu2) / (Scalar(8.0) * omega1_2);  // dissipative_x_conjA_y_F
  lumps[12] = p;  // p
  lumps[13] = lump_4(parameters, static_cast<Scalar*>(nullptr));  // conservative_x_A_y_conjA_y2_F
  lumps[14] = lump_5(parameters, static_cast<Scalar*>(nullptr));  // conservative_x_A_x_conjA_x_conjA_y_F
  lumps[15] = lump_6(parameters, static_cast<Scalar*>(nullptr));  // conservative_y_A_x_A_y2_F
  lumps[16] = mu2;  // mu2
  lumps[17] = -mu2_2 / (Scalar(2.0) * omega2);  // conservative_y_A_y
  lumps[18] = Scalar(3.0) * mu2 * b5 / (Scalar(2.0) * omega2_2);  // dissipative_y_A_y2_conjA_y
  lumps[19] = b5;  // b5
  lumps[20] = -Scalar(15.0) * b5_2 / (Scalar(16.0) * omega2_3);  // conservative_y_A_y3_conjA_y2
  lumps[21] = mu1 * b3 / omega2_2;  // dissipative_y_A_x_A_y_conjA_x
  lumps[22] = lump_7(parameters, static_cast<Scalar*>(nullptr));  // conservative_y_A_x_A_y2_conjA_x_conjA_y
  lumps[23] = (-mu1 * q + mu2 * q) / (Scalar(8.0) * omega2_2);  // dissipative_y_conjA_x_F
  lumps[24] = q;  // q
  lumps[25] = lump_8(parameters, static_cast<Scalar*>(nullptr));  // conservative_y_A_y_conjA_x_conjA_y_F
  lumps[26] = lump_9(parameters, static_cast<Scalar*>(nullptr));  // conservative_y_A_x_conjA_x2_F
  lumps[27] = lump_10(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_y_conjA_x2_F
  lumps[28] = lump_11(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_y3_F
  lumps[29] = lump_12(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_y3_conjA_x_conjA_y
  lumps[30] = lump_13(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_x_A_y2_conjA_x2
  lumps[31] = lump_14(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_y2_conjA_y_F
  lumps[32] = lump_15(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_x_A_y_conjA_x_F
  lumps[33] = lump_16(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_x_A_y3_conjA_y
  lumps[34] = lump_17(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_x2_A_y2_conjA_x
  lumps[35] = lump_18(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_x2_conjA_y_F
  lumps[36] = lump_19(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_x3_A_y_conjA_y
  lumps[37] = lump_20(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_y2_conjA_x3
  lumps[38] = lump_21(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_y4_conjA_x
  lumps[39] = lump_22(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_x_A_y4
  lumps[40] = lump_23(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_x2_A_y_F
  lumps[41] = lump_24(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_x3_A_y2
  lumps[42] = lump_25(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_conjA_x3_F
  lumps[43] = lump_26(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_y2_conjA_x2_conjA_y
  lumps[44] = lump_27(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_x_A_y_conjA_x3
  lumps[45] = lump_28(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_y2_conjA_x_F
  lumps[46] = lump_29(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_x_A_y3_conjA_x
  lumps[47] = lump_30(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_x_A_y_conjA_y_F
  lumps[48] = lump_31(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_x2_conjA_x_F
  lumps[49] = lump_32(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_x2_A_y2_conjA_y
  lumps[50] = lump_33(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_x3_A_y_conjA_x
  lumps[51] = lump_34(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_y3_conjA_x2
  lumps[52] = lump_35(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_x_A_y2_F
  lumps[53] = lump_36(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_x2_A_y3
  lumps[54] = lump_37(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_x3_F
  lumps[55] = lump_38(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_x4_A_y
  lumps[56] = lump_39(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_x4_conjA_y
}

/// jacobian[l * 9 + p] = d lumps[l] / d parameters[p]. 70 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
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
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar mu1_2 = mu1 * mu1;
  const Scalar b1_2 = b1 * b1;
  const Scalar mu2_2 = mu2 * mu2;
  const Scalar b5_2 = b5 * b5;
  for (std::size_t i = 0; i < 513; ++i) jacobian[i] = Scalar(0.0);
  lump_0(parameters, jacobian + 0);  // d conservative_x_A_x2_A_y_F
  jacobian[11] = Scalar(1.0);  // d mu1 / d mu1
  jacobian[18] = mu1_2 / (Scalar(2.0) * omega1_2);  // d conservative_x_A_x / d omega1
  jacobian[20] = -mu1 / omega1;  // d conservative_x_A_x / d mu1
  lump_1(parameters, jacobian + 27);  // d conservative_x_A_x_F2
  jacobian[36] = -Scalar(2.0) * b3 * mu2 / omega1_3;  // d dissipative_x_A_x_A_y_conjA_y / d omega1
  jacobian[40] = mu2 / omega1_2;  // d dissipative_x_A_x_A_y_conjA_y / d b3
  jacobian[42] = b3 / omega1_2;  // d dissipative_x_A_x_A_y_conjA_y / d mu2
  jacobian[49] = Scalar(1.0);  // d b3 / d b3
  lump_2(parameters, jacobian + 54);  // d conservative_x_A_x_A_y2_conjA_y2
  jacobian[63] = -Scalar(3.0) * mu1 * b1 / omega1_3;  // d dissipative_x_A_x2_conjA_x / d omega1
  jacobian[65] = Scalar(3.0) * b1 / (Scalar(2.0) * omega1_2);  // d dissipative_x_A_x2_conjA_x / d mu1
  jacobian[66] = Scalar(3.0) * mu1 / (Scalar(2.0) * omega1_2);  // d dissipative_x_A_x2_conjA_x / d b1
  jacobian[75] = Scalar(1.0);  // d b1 / d b1
  lump_3(parameters, jacobian + 81);  // d conservative_x_A_x2_A_y_conjA_x_conjA_y
  jacobian[90] = Scalar(45.0) * b1_2 / (Scalar(16.0) * omega1_4);  // d conservative_x_A_x3_conjA_x2 / d omega1
  jacobian[93] = -Scalar(15.0) * b1 / (Scalar(8.0) * omega1_3);  // d conservative_x_A_x3_conjA_x2 / d b1
  jacobian[99] = (-mu1 * p + p * mu2) / (Scalar(4.0) * omega1_3);  // d dissipative_x_conjA_y_F / d omega1
  jacobian[101] = p / (Scalar(8.0) * omega1_2);  // d dissipative_x_conjA_y_F / d mu1
  jacobian[104] = (mu1 - mu2) / (Scalar(8.0) * omega1_2);  // d dissipative_x_conjA_y_F / d p
  jacobian[105] = -p / (Scalar(8.0) * omega1_2);  // d dissipative_x_conjA_y_F / d mu2
  jacobian[113] = Scalar(1.0);  // d p / d p
  lump_4(parameters, jacobian + 117);  // d conservative_x_A_y_conjA_y2_F
  lump_5(parameters, jacobian + 126);  // d conservative_x_A_x_conjA_x_conjA_y_F
  lump_6(parameters, jacobian + 135);  // d conservative_y_A_x_A_y2_F
  jacobian[150] = Scalar(1.0);  // d mu2 / d mu2
  jacobian[154] = mu2_2 / (Scalar(2.0) * omega2_2);  // d conservative_y_A_y / d omega2
  jacobian[159] = -mu2 / omega2;  // d conservative_y_A_y / d mu2
  jacobian[163] = -Scalar(3.0) * mu2 * b5 / omega2_3;  // d dissipative_y_A_y2_conjA_y / d omega2
  jacobian[168] = Scalar(3.0) * b5 / (Scalar(2.0) * omega2_2);  // d dissipative_y_A_y2_conjA_y / d mu2
  jacobian[169] = Scalar(3.0) * mu2 / (Scalar(2.0) * omega2_2);  // d dissipative_y_A_y2_conjA_y / d b5
  jacobian[178] = Scalar(1.0);  // d b5 / d b5
  jacobian[181] = Scalar(45.0) * b5_2 / (Scalar(16.0) * omega2_4);  // d conservative_y_A_y3_conjA_y2 / d omega2
  jacobian[187] = -Scalar(15.0) * b5 / (Scalar(8.0) * omega2_3);  // d conservative_y_A_y3_conjA_y2 / d b5
  jacobian[190] = -Scalar(2.0) * mu1 * b3 / omega2_3;  // d dissipative_y_A_x_A_y_conjA_x / d omega2
  jacobian[191] = b3 / omega2_2;  // d dissipative_y_A_x_A_y_conjA_x / d mu1
  jacobian[193] = mu1 / omega2_2;  // d dissipative_y_A_x_A_y_conjA_x / d b3
  lump_7(parameters, jacobian + 198);  // d conservative_y_A_x_A_y2_conjA_x_conjA_y
  jacobian[208] = (mu1 * q - mu2 * q) / (Scalar(4.0) * omega2_3);  // d dissipative_y_conjA_x_F / d omega2
  jacobian[209] = -q / (Scalar(8.0) * omega2_2);  // d dissipative_y_conjA_x_F / d mu1
  jacobian[213] = q / (Scalar(8.0) * omega2_2);  // d dissipative_y_conjA_x_F / d mu2
  jacobian[215] = (-mu1 + mu2) / (Scalar(8.0) * omega2_2);  // d dissipative_y_conjA_x_F / d q
  jacobian[224] = Scalar(1.0);  // d q / d q
  lump_8(parameters, jacobian + 225);  // d conservative_y_A_y_conjA_x_conjA_y_F
  lump_9(parameters, jacobian + 234);  // d conservative_y_A_x_conjA_x2_F
  lump_10(parameters, jacobian + 243);  // d harmonic_re_x_A_y_conjA_x2_F
  lump_11(parameters, jacobian + 252);  // d harmonic_re_x_A_y3_F
  lump_12(parameters, jacobian + 261);  // d harmonic_re_x_A_y3_conjA_x_conjA_y
  lump_13(parameters, jacobian + 270);  // d harmonic_re_x_A_x_A_y2_conjA_x2
  lump_14(parameters, jacobian + 279);  // d harmonic_re_x_A_y2_conjA_y_F
  lump_15(parameters, jacobian + 288);  // d harmonic_re_x_A_x_A_y_conjA_x_F
  lump_16(parameters, jacobian + 297);  // d harmonic_re_x_A_x_A_y3_conjA_y
  lump_17(parameters, jacobian + 306);  // d harmonic_re_x_A_x2_A_y2_conjA_x
  lump_18(parameters, jacobian + 315);  // d harmonic_re_x_A_x2_conjA_y_F
  lump_19(parameters, jacobian + 324);  // d harmonic_re_x_A_x3_A_y_conjA_y
  lump_20(parameters, jacobian + 333);  // d harmonic_re_x_A_y2_conjA_x3
  lump_21(parameters, jacobian + 342);  // d harmonic_re_x_A_y4_conjA_x
  lump_22(parameters, jacobian + 351);  // d harmonic_re_x_A_x_A_y4
  lump_23(parameters, jacobian + 360);  // d harmonic_re_x_A_x2_A_y_F
  lump_24(parameters, jacobian + 369);  // d harmonic_re_x_A_x3_A_y2
  lump_25(parameters, jacobian + 378);  // d harmonic_re_y_conjA_x3_F
  lump_26(parameters, jacobian + 387);  // d harmonic_re_y_A_y2_conjA_x2_conjA_y
  lump_27(parameters, jacobian + 396);  // d harmonic_re_y_A_x_A_y_conjA_x3
  lump_28(parameters, jacobian + 405);  // d harmonic_re_y_A_y2_conjA_x_F
  lump_29(parameters, jacobian + 414);  // d harmonic_re_y_A_x_A_y3_conjA_x
  lump_30(parameters, jacobian + 423);  // d harmonic_re_y_A_x_A_y_conjA_y_F
  lump_31(parameters, jacobian + 432);  // d harmonic_re_y_A_x2_conjA_x_F
  lump_32(parameters, jacobian + 441);  // d harmonic_re_y_A_x2_A_y2_conjA_y
  lump_33(parameters, jacobian + 450);  // d harmonic_re_y_A_x3_A_y_conjA_x
  lump_34(parameters, jacobian + 459);  // d harmonic_re_y_A_y3_conjA_x2
  lump_35(parameters, jacobian + 468);  // d harmonic_re_y_A_x_A_y2_F
  lump_36(parameters, jacobian + 477);  // d harmonic_re_y_A_x2_A_y3
  lump_37(parameters, jacobian + 486);  // d harmonic_re_y_A_x3_F
  lump_38(parameters, jacobian + 495);  // d harmonic_re_y_A_x4_A_y
  lump_39(parameters, jacobian + 504);  // d harmonic_re_y_A_x4_conjA_y
}

/// What multiplies the 16 terms of the modulation of x: functions of the frequencies alone. 10 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  factor[0] = Scalar(1.0);
  factor[1] = -Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0) / omega1;
  factor[6] = Scalar(1.0);
  factor[7] = Scalar(1.0);
  factor[8] = Scalar(3.0) / (Scalar(2.0) * omega1);
  factor[9] = Scalar(1.0);
  factor[10] = Scalar(1.0);
  factor[11] = Scalar(1.0);
  factor[12] = -Scalar(1.0) / (Scalar(4.0) * omega1);
  factor[13] = (-omega1 - omega2 + Omega) / (Scalar(8.0) * omega1_2);
  factor[14] = Scalar(1.0);
  factor[15] = Scalar(1.0);
}

/// Rows of the modulation of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega1)*A_x = i*conservative_x_A_x2_A_y_F*A_x^2*A_y*F - mu1*A_x + i*conservative_x_A_x*A_x +
/// i*conservative_x_A_x_F2*A_x*F^2 + dissipative_x_A_x_A_y_conjA_y*A_x*A_y*conj(A_y) +
/// 1/omega1*i*b3*A_x*A_y*conj(A_y) + i*conservative_x_A_x_A_y2_conjA_y2*A_x*A_y^2*conj(A_y)^2 +
/// dissipative_x_A_x2_conjA_x*A_x^2*conj(A_x) + 3/(2*omega1)*i*b1*A_x^2*conj(A_x) +
/// i*conservative_x_A_x2_A_y_conjA_x_conjA_y*A_x^2*conj(A_x)*A_y*conj(A_y) +
/// i*conservative_x_A_x3_conjA_x2*A_x^3*conj(A_x)^2 + dissipative_x_conjA_y_F*conj(A_y)*F -
/// 1/(4*omega1)*i*p*conj(A_y)*F + (-omega1 - omega2 + Omega)/(8*omega1^2)*i*p*conj(A_y)*F +
/// i*conservative_x_A_y_conjA_y2_F*A_y*conj(A_y)^2*F +
/// i*conservative_x_A_x_conjA_x_conjA_y_F*A_x*conj(A_x)*conj(A_y)*F
/// 15 columns; per observation at most 59 products and sums of complex numbers.
template <class Factors>
void rows_0(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar* __restrict column_4 = columns[4];
  Scalar* __restrict column_5 = columns[5];
  Scalar* __restrict column_6 = columns[6];
  Scalar* __restrict column_7 = columns[7];
  Scalar* __restrict column_8 = columns[8];
  Scalar* __restrict column_9 = columns[9];
  Scalar* __restrict column_10 = columns[10];
  Scalar* __restrict column_11 = columns[11];
  Scalar* __restrict column_12 = columns[12];
  Scalar* __restrict column_13 = columns[13];
  Scalar* __restrict column_14 = columns[14];
  Scalar factor[16];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Complex conj_A_y = conjugate(A_y);
    const Scalar norm_A_y = norm_of(A_y);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    const Scalar norm_F = norm_of(F);
    store_complex(column_0, i, times_i(factor[0] * (A_x * A_x * A_y * conj_F)));  // conservative_x_A_x2_A_y_F
    store_complex(column_1, i, factor[1] * (A_x));  // mu1
    store_complex(column_2, i, times_i(factor[2] * (A_x)));  // conservative_x_A_x
    store_complex(column_3, i, times_i(factor[3] * (A_x * norm_F)));  // conservative_x_A_x_F2
    store_complex(column_4, i, factor[4] * (A_x * norm_A_y));  // dissipative_x_A_x_A_y_conjA_y
    store_complex(column_5, i, times_i(factor[5] * (A_x * norm_A_y)));  // b3
    // conservative_x_A_x_A_y2_conjA_y2
    store_complex(column_6, i, times_i(factor[6] * (A_x * norm_A_y * norm_A_y)));
    store_complex(column_7, i, factor[7] * (norm_A_x * A_x));  // dissipative_x_A_x2_conjA_x
    store_complex(column_8, i, times_i(factor[8] * (norm_A_x * A_x)));  // b1
    // conservative_x_A_x2_A_y_conjA_x_conjA_y
    store_complex(column_9, i, times_i(factor[9] * (norm_A_x * A_x * norm_A_y)));
    // conservative_x_A_x3_conjA_x2
    store_complex(column_10, i, times_i(factor[10] * (norm_A_x * norm_A_x * A_x)));
    store_complex(column_11, i, factor[11] * (conj_A_y * F));  // dissipative_x_conjA_y_F
    // p
    store_complex(column_12, i, times_i(factor[12] * (conj_A_y * F)) + times_i(factor[13] * (conj_A_y * F)));
    // conservative_x_A_y_conjA_y2_F
    store_complex(column_13, i, times_i(factor[14] * (norm_A_y * conj_A_y * F)));
    // conservative_x_A_x_conjA_x_conjA_y_F
    store_complex(column_14, i, times_i(factor[15] * (norm_A_x * conj_A_y * F)));
  }
}

/// columns[j][i] of the rows.
inline void columns_0(const BatchArrays& data, double* const* columns) {
  rows_0(data, FactorValues<factors_0<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_0(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_0(data, FactorSlopes<factors_0<DualNumber>, 2, 1, 16>{mode}, columns);
}

/// What multiplies the 16 terms of the modulation of y: functions of the frequencies alone. 33 operations.
template <class Scalar>
void factors_1([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(3.0) * omega1_2 - Scalar(2.0) * omega2_2);
  factor[0] = (Scalar(2.0) * omega1_2 + omega1 * omega2) * per_0 / omega2;
  factor[1] = Scalar(1.0) / omega2;
  factor[2] = (Scalar(2.0) * omega1_5 - Scalar(3.0) * omega1_3 * omega2_2) * per_1 / omega2_3;
  factor[3] = Scalar(1.0);
  factor[4] = -Scalar(1.0);
  factor[5] = Scalar(1.0);
  factor[6] = Scalar(1.0);
  factor[7] = Scalar(3.0) / (Scalar(2.0) * omega2);
  factor[8] = Scalar(1.0);
  factor[9] = Scalar(1.0);
  factor[10] = Scalar(1.0);
  factor[11] = Scalar(1.0);
  factor[12] = -Scalar(1.0) / (Scalar(4.0) * omega2);
  factor[13] = (-omega1 - omega2 + Omega) / (Scalar(8.0) * omega2_2);
  factor[14] = Scalar(1.0);
  factor[15] = Scalar(1.0);
}

/// Rows of the modulation of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega2)*A_y = (2*omega1^2 + omega1*omega2)/(omega2*(omega1 +
/// 2*omega2))*i*conservative_x_A_x_F2*A_y*F^2 + 1/omega2*i*b3*A_x*conj(A_x)*A_y + (2*omega1^5 -
/// 3*omega1^3*omega2^2)/(omega2^3*(3*omega1^2 -
/// 2*omega2^2))*i*conservative_x_A_x_A_y2_conjA_y2*A_x^2*conj(A_x)^2*A_y +
/// i*conservative_y_A_x_A_y2_F*A_x*A_y^2*F - mu2*A_y + i*conservative_y_A_y*A_y +
/// dissipative_y_A_y2_conjA_y*A_y^2*conj(A_y) + 3/(2*omega2)*i*b5*A_y^2*conj(A_y) +
/// i*conservative_y_A_y3_conjA_y2*A_y^3*conj(A_y)^2 + dissipative_y_A_x_A_y_conjA_x*A_x*conj(A_x)*A_y +
/// i*conservative_y_A_x_A_y2_conjA_x_conjA_y*A_x*conj(A_x)*A_y^2*conj(A_y) + dissipative_y_conjA_x_F*conj(A_x)*F
/// - 1/(4*omega2)*i*q*conj(A_x)*F + (-omega1 - omega2 + Omega)/(8*omega2^2)*i*q*conj(A_x)*F +
/// i*conservative_y_A_y_conjA_x_conjA_y_F*conj(A_x)*A_y*conj(A_y)*F +
/// i*conservative_y_A_x_conjA_x2_F*A_x*conj(A_x)^2*F
/// 15 columns; per observation at most 59 products and sums of complex numbers.
template <class Factors>
void rows_1(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar* __restrict column_4 = columns[4];
  Scalar* __restrict column_5 = columns[5];
  Scalar* __restrict column_6 = columns[6];
  Scalar* __restrict column_7 = columns[7];
  Scalar* __restrict column_8 = columns[8];
  Scalar* __restrict column_9 = columns[9];
  Scalar* __restrict column_10 = columns[10];
  Scalar* __restrict column_11 = columns[11];
  Scalar* __restrict column_12 = columns[12];
  Scalar* __restrict column_13 = columns[13];
  Scalar* __restrict column_14 = columns[14];
  Scalar factor[16];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Scalar norm_A_y = norm_of(A_y);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    const Scalar norm_F = norm_of(F);
    store_complex(column_0, i, times_i(factor[0] * (A_y * norm_F)));  // conservative_x_A_x_F2
    store_complex(column_1, i, times_i(factor[1] * (norm_A_x * A_y)));  // b3
    // conservative_x_A_x_A_y2_conjA_y2
    store_complex(column_2, i, times_i(factor[2] * (norm_A_x * norm_A_x * A_y)));
    store_complex(column_3, i, times_i(factor[3] * (A_x * A_y * A_y * conj_F)));  // conservative_y_A_x_A_y2_F
    store_complex(column_4, i, factor[4] * (A_y));  // mu2
    store_complex(column_5, i, times_i(factor[5] * (A_y)));  // conservative_y_A_y
    store_complex(column_6, i, factor[6] * (norm_A_y * A_y));  // dissipative_y_A_y2_conjA_y
    store_complex(column_7, i, times_i(factor[7] * (norm_A_y * A_y)));  // b5
    store_complex(column_8, i, times_i(factor[8] * (norm_A_y * norm_A_y * A_y)));  // conservative_y_A_y3_conjA_y2
    store_complex(column_9, i, factor[9] * (norm_A_x * A_y));  // dissipative_y_A_x_A_y_conjA_x
    // conservative_y_A_x_A_y2_conjA_x_conjA_y
    store_complex(column_10, i, times_i(factor[10] * (norm_A_x * norm_A_y * A_y)));
    store_complex(column_11, i, factor[11] * (conj_A_x * F));  // dissipative_y_conjA_x_F
    // q
    store_complex(column_12, i, times_i(factor[12] * (conj_A_x * F)) + times_i(factor[13] * (conj_A_x * F)));
    // conservative_y_A_y_conjA_x_conjA_y_F
    store_complex(column_13, i, times_i(factor[14] * (conj_A_x * norm_A_y * F)));
    // conservative_y_A_x_conjA_x2_F
    store_complex(column_14, i, times_i(factor[15] * (norm_A_x * conj_A_x * F)));
  }
}

/// columns[j][i] of the rows.
inline void columns_1(const BatchArrays& data, double* const* columns) {
  rows_1(data, FactorValues<factors_1<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_1(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_1(data, FactorSlopes<factors_1<DualNumber>, 2, 1, 16>{mode}, columns);
}

/// What multiplies the 8 terms of the harmonic -omega1+2*omega2 of x: functions of the frequencies alone. 14
/// operations.
template <class Scalar>
void factors_2([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_0_2 = per_0 * per_0;
  factor[0] = (omega1_3 - Scalar(2.0) * omega1_2 * omega2) * per_0_2 / (Scalar(4.0) * omega2_2);
  factor[1] = -per_0 / (Scalar(4.0) * omega2);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
  factor[6] = Scalar(1.0);
  factor[7] = Scalar(1.0);
}

/// Rows of the harmonic -omega1+2*omega2 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + 2*omega2)*t) in x = (omega1^3 - 2*omega1^2*omega2)/(4*omega2^2*(omega1 -
/// omega2)^2)*i*dissipative_x_A_x_A_y_conjA_y*conj(A_x)*A_y^2 - 1/(4*omega2*(omega1 -
/// omega2))*b3*conj(A_x)*A_y^2 + harmonic_re_x_A_y_conjA_x2_F*conj(A_x)^2*A_y*F +
/// harmonic_re_x_A_y_conjA_x2_F*conj(A_x)^2*A_y*F + harmonic_re_x_A_y3_F*A_y^3*F + harmonic_re_x_A_y3_F*A_y^3*F
/// + harmonic_re_x_A_y3_conjA_x_conjA_y*conj(A_x)*A_y^3*conj(A_y) +
/// harmonic_re_x_A_x_A_y2_conjA_x2*A_x*conj(A_x)^2*A_y^2
/// 6 columns; per observation at most 54 products and sums of complex numbers.
template <class Factors>
void rows_2(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar* __restrict column_4 = columns[4];
  Scalar* __restrict column_5 = columns[5];
  Scalar factor[8];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Scalar norm_A_y = norm_of(A_y);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    store_complex(column_0, i, times_i(factor[0] * (conj_A_x * A_y * A_y)));  // dissipative_x_A_x_A_y_conjA_y
    store_complex(column_1, i, factor[1] * (conj_A_x * A_y * A_y));  // b3
    // harmonic_re_x_A_y_conjA_x2_F
    store_complex(column_2, i, factor[2] * (conj_A_x * conj_A_x * A_y * F)
        + factor[3] * (conj_A_x * conj_A_x * A_y * F));
    // harmonic_re_x_A_y3_F
    store_complex(column_3, i, factor[4] * (A_y * A_y * A_y * conj_F) + factor[5] * (A_y * A_y * A_y * conj_F));
    // harmonic_re_x_A_y3_conjA_x_conjA_y
    store_complex(column_4, i, factor[6] * (conj_A_x * norm_A_y * A_y * A_y));
    store_complex(column_5, i, factor[7] * (norm_A_x * conj_A_x * A_y * A_y));  // harmonic_re_x_A_x_A_y2_conjA_x2
  }
}

/// columns[j][i] of the rows.
inline void columns_2(const BatchArrays& data, double* const* columns) {
  rows_2(data, FactorValues<factors_2<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_2(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_2(data, FactorSlopes<factors_2<DualNumber>, 2, 1, 8>{mode}, columns);
}

/// What multiplies the 12 terms of the harmonic omega2+Omega of x: functions of the frequencies alone. 49
/// operations.
template <class Scalar>
void factors_3([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  factor[0] = -omega1_2 * per_0 / (Scalar(2.0) * omega2_2);
  factor[1] = (-omega1_3 - Scalar(2.0) * omega1_2 * omega2) * per_0_2 / (Scalar(4.0) * omega2_2);
  factor[2] = per_0 / (Scalar(4.0) * omega2);
  factor[3] = (-omega1_3 - Scalar(2.0) * omega1_2 * omega2) * per_0_2 / (Scalar(2.0) * omega2_2);
  factor[4] = -per_0 / (Scalar(8.0) * omega2);
  factor[5] = (-omega1_2 - Scalar(3.0) * omega1 * omega2 + omega1 * Omega - Scalar(2.0) * omega2_2
      + Scalar(2.0) * omega2 * Omega) * per_0_2 / (Scalar(16.0) * omega2_2);
  factor[6] = (omega1_3 - Scalar(3.0) * omega1 * omega2_2 + Scalar(2.0) * omega2_3) * per_0_2 * per_1;
  factor[7] = Scalar(1.0);
  factor[8] = Scalar(1.0);
  factor[9] = Scalar(1.0);
  factor[10] = Scalar(1.0);
  factor[11] = Scalar(1.0);
}

/// Rows of the harmonic omega2+Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + Omega)*t) in x = -omega1^2/(2*omega2^2*(omega1 +
/// omega2))*conservative_x_A_x_F2*conj(A_x)*F^2 + (-omega1^3 - 2*omega1^2*omega2)/(4*omega2^2*(omega1 +
/// omega2)^2)*i*dissipative_x_A_x_A_y_conjA_y*A_x*A_y^2 + 1/(4*omega2*(omega1 + omega2))*b3*A_x*A_y^2 +
/// (-omega1^3 - 2*omega1^2*omega2)/(2*omega2^2*(omega1 + omega2)^2)*i*dissipative_x_conjA_y_F*A_y*F -
/// 1/(8*omega2*(omega1 + omega2))*p*A_y*F + (-omega1^2 - 3*omega1*omega2 + omega1*Omega - 2*omega2^2 +
/// 2*omega2*Omega)/(16*omega2^2*(omega1 + omega2)^2)*p*A_y*F + (omega1^3 - 3*omega1*omega2^2 +
/// 2*omega2^3)/((omega1 + omega2)^2*(omega1 - 2*omega2))*harmonic_re_x_A_y3_F*A_y^2*conj(A_y)*F +
/// harmonic_re_x_A_y2_conjA_y_F*A_y^2*conj(A_y)*F + harmonic_re_x_A_x_A_y_conjA_x_F*A_x*conj(A_x)*A_y*F +
/// harmonic_re_x_A_x_A_y_conjA_x_F*A_x*conj(A_x)*A_y*F + harmonic_re_x_A_x_A_y3_conjA_y*A_x*A_y^3*conj(A_y) +
/// harmonic_re_x_A_x2_A_y2_conjA_x*A_x^2*conj(A_x)*A_y^2
/// 10 columns; per observation at most 60 products and sums of complex numbers.
template <class Factors>
void rows_3(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar* __restrict column_4 = columns[4];
  Scalar* __restrict column_5 = columns[5];
  Scalar* __restrict column_6 = columns[6];
  Scalar* __restrict column_7 = columns[7];
  Scalar* __restrict column_8 = columns[8];
  Scalar* __restrict column_9 = columns[9];
  Scalar factor[12];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Scalar norm_A_y = norm_of(A_y);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (conj_A_x * F * F));  // conservative_x_A_x_F2
    store_complex(column_1, i, times_i(factor[1] * (A_x * A_y * A_y)));  // dissipative_x_A_x_A_y_conjA_y
    store_complex(column_2, i, factor[2] * (A_x * A_y * A_y));  // b3
    store_complex(column_3, i, times_i(factor[3] * (A_y * F)));  // dissipative_x_conjA_y_F
    store_complex(column_4, i, factor[4] * (A_y * F) + factor[5] * (A_y * F));  // p
    store_complex(column_5, i, factor[6] * (norm_A_y * A_y * F));  // harmonic_re_x_A_y3_F
    store_complex(column_6, i, factor[7] * (norm_A_y * A_y * F));  // harmonic_re_x_A_y2_conjA_y_F
    // harmonic_re_x_A_x_A_y_conjA_x_F
    store_complex(column_7, i, factor[8] * (norm_A_x * A_y * F) + factor[9] * (norm_A_x * A_y * F));
    store_complex(column_8, i, factor[10] * (A_x * norm_A_y * A_y * A_y));  // harmonic_re_x_A_x_A_y3_conjA_y
    store_complex(column_9, i, factor[11] * (norm_A_x * A_x * A_y * A_y));  // harmonic_re_x_A_x2_A_y2_conjA_x
  }
}

/// columns[j][i] of the rows.
inline void columns_3(const BatchArrays& data, double* const* columns) {
  rows_3(data, FactorValues<factors_3<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_3(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_3(data, FactorSlopes<factors_3<DualNumber>, 2, 1, 12>{mode}, columns);
}

/// What multiplies the 6 terms of the harmonic 3*omega1 of x: functions of the frequencies alone. 7 operations.
template <class Scalar>
void factors_4([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  factor[0] = -Scalar(1.0) / (Scalar(8.0) * omega1);
  factor[1] = Scalar(1.0) / (Scalar(8.0) * omega1_2);
  factor[2] = Scalar(7.0) / (Scalar(20.0) * omega1);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
}

/// Rows of the harmonic 3*omega1 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega1)*t) in x = -1/(8*omega1)*i*dissipative_x_A_x2_conjA_x*A_x^3 +
/// 1/(8*omega1^2)*b1*A_x^3 + 7/(20*omega1)*conservative_x_A_x3_conjA_x2*A_x^4*conj(A_x) +
/// harmonic_re_x_A_x2_conjA_y_F*A_x^2*conj(A_y)*F + harmonic_re_x_A_x2_conjA_y_F*A_x^2*conj(A_y)*F +
/// harmonic_re_x_A_x3_A_y_conjA_y*A_x^3*A_y*conj(A_y)
/// 5 columns; per observation at most 39 products and sums of complex numbers.
template <class Factors>
void rows_4(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar* __restrict column_4 = columns[4];
  Scalar factor[6];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Complex conj_A_y = conjugate(A_y);
    const Scalar norm_A_y = norm_of(A_y);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, times_i(factor[0] * (A_x * A_x * A_x)));  // dissipative_x_A_x2_conjA_x
    store_complex(column_1, i, factor[1] * (A_x * A_x * A_x));  // b1
    store_complex(column_2, i, factor[2] * (norm_A_x * A_x * A_x * A_x));  // conservative_x_A_x3_conjA_x2
    // harmonic_re_x_A_x2_conjA_y_F
    store_complex(column_3, i, factor[3] * (A_x * A_x * conj_A_y * F) + factor[4] * (A_x * A_x * conj_A_y * F));
    store_complex(column_4, i, factor[5] * (A_x * A_x * A_x * norm_A_y));  // harmonic_re_x_A_x3_A_y_conjA_y
  }
}

/// columns[j][i] of the rows.
inline void columns_4(const BatchArrays& data, double* const* columns) {
  rows_4(data, FactorValues<factors_4<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_4(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_4(data, FactorSlopes<factors_4<DualNumber>, 2, 1, 6>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic -3*omega1+2*omega2 of x: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_5([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic -3*omega1+2*omega2 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-3*omega1 + 2*omega2)*t) in x = harmonic_re_x_A_y2_conjA_x3*conj(A_x)^3*A_y^2
/// 1 columns; per observation at most 9 products and sums of complex numbers.
template <class Factors>
void rows_5(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    // harmonic_re_x_A_y2_conjA_x3
    store_complex(column_0, i, factor[0] * (conj_A_x * conj_A_x * conj_A_x * A_y * A_y));
  }
}

/// columns[j][i] of the rows.
inline void columns_5(const BatchArrays& data, double* const* columns) {
  rows_5(data, FactorValues<factors_5<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_5(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic -omega1+4*omega2 of x: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_6([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic -omega1+4*omega2 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + 4*omega2)*t) in x = harmonic_re_x_A_y4_conjA_x*conj(A_x)*A_y^4
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_6(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (conj_A_x * fixed_power<4>(A_y)));  // harmonic_re_x_A_y4_conjA_x
  }
}

/// columns[j][i] of the rows.
inline void columns_6(const BatchArrays& data, double* const* columns) {
  rows_6(data, FactorValues<factors_6<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_6(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 2 terms of the harmonic 3*omega2+Omega of x: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_7([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic 3*omega2+Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega2 + Omega)*t) in x = harmonic_re_x_A_y3_F*A_y^3*F +
/// harmonic_re_x_A_x_A_y4*A_x*A_y^4
/// 2 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_7(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex A_y = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_y * A_y * A_y * F));  // harmonic_re_x_A_y3_F
    store_complex(column_1, i, factor[1] * (A_x * fixed_power<4>(A_y)));  // harmonic_re_x_A_x_A_y4
  }
}

/// columns[j][i] of the rows.
inline void columns_7(const BatchArrays& data, double* const* columns) {
  rows_7(data, FactorValues<factors_7<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_7(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 3 terms of the harmonic omega1+2*Omega of x: functions of the frequencies alone. 13
/// operations.
template <class Scalar>
void factors_8([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  factor[0] = omega1 * omega2 * per_0 * per_1 * per_2 / Scalar(2.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega1+2*Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + 2*Omega)*t) in x = omega1*omega2/(2*(omega1 + omega2)*(omega1 +
/// 2*omega2)*(2*omega1 + omega2))*conservative_x_A_x_F2*A_x*F^2 + harmonic_re_x_A_x2_A_y_F*A_x^2*A_y*F +
/// harmonic_re_x_A_x3_A_y2*A_x^3*A_y^2
/// 3 columns; per observation at most 21 products and sums of complex numbers.
template <class Factors>
void rows_8(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[3];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex A_y = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_x * F * F));  // conservative_x_A_x_F2
    store_complex(column_1, i, factor[1] * (A_x * A_x * A_y * F));  // harmonic_re_x_A_x2_A_y_F
    store_complex(column_2, i, factor[2] * (A_x * A_x * A_x * A_y * A_y));  // harmonic_re_x_A_x3_A_y2
  }
}

/// columns[j][i] of the rows.
inline void columns_8(const BatchArrays& data, double* const* columns) {
  rows_8(data, FactorValues<factors_8<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_8(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_8(data, FactorSlopes<factors_8<DualNumber>, 2, 1, 3>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 5*omega1 of x: functions of the frequencies alone. 2 operations.
template <class Scalar>
void factors_9([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  factor[0] = -Scalar(1.0) / (Scalar(60.0) * omega1);
}

/// Rows of the harmonic 5*omega1 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(5*omega1)*t) in x = -1/(60*omega1)*conservative_x_A_x3_conjA_x2*A_x^5
/// 1 columns; per observation at most 1 products and sums of complex numbers.
template <class Factors>
void rows_9(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    store_complex(column_0, i, factor[0] * (fixed_power<5>(A_x)));  // conservative_x_A_x3_conjA_x2
  }
}

/// columns[j][i] of the rows.
inline void columns_9(const BatchArrays& data, double* const* columns) {
  rows_9(data, FactorValues<factors_9<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_9(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_9(data, FactorSlopes<factors_9<DualNumber>, 2, 1, 1>{mode}, columns);
}

/// What multiplies the 8 terms of the harmonic -2*omega1+omega2 of y: functions of the frequencies alone. 23
/// operations.
template <class Scalar>
void factors_10([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  factor[0] = per_0 / (Scalar(4.0) * omega1);
  factor[1] = (Scalar(2.0) * omega1 * omega2_2 - omega2_3) * per_0_2 / (Scalar(4.0) * omega1_2);
  factor[2] = (Scalar(4.0) * omega1 * omega2_2 - Scalar(2.0) * omega2_3) * per_1 / omega1_2;
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
  factor[6] = Scalar(1.0);
  factor[7] = Scalar(1.0);
}

/// Rows of the harmonic -2*omega1+omega2 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-2*omega1 + omega2)*t) in y = 1/(4*omega1*(omega1 - omega2))*b3*conj(A_x)^2*A_y +
/// (2*omega1*omega2^2 - omega2^3)/(4*omega1^2*(omega1 -
/// omega2)^2)*i*dissipative_y_A_x_A_y_conjA_x*conj(A_x)^2*A_y + (4*omega1*omega2^2 -
/// 2*omega2^3)/(omega1^2*(omega1 - 2*omega2))*harmonic_re_x_A_y3_F*conj(A_x)*A_y^2*F +
/// harmonic_re_y_conjA_x3_F*conj(A_x)^3*F + harmonic_re_y_conjA_x3_F*conj(A_x)^3*F +
/// harmonic_re_y_A_y2_conjA_x2_conjA_y*conj(A_x)^2*A_y^2*conj(A_y) +
/// harmonic_re_y_A_x_A_y_conjA_x3*A_x*conj(A_x)^3*A_y + harmonic_re_y_A_y2_conjA_x_F*conj(A_x)*A_y^2*F
/// 7 columns; per observation at most 53 products and sums of complex numbers.
template <class Factors>
void rows_10(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar* __restrict column_4 = columns[4];
  Scalar* __restrict column_5 = columns[5];
  Scalar* __restrict column_6 = columns[6];
  Scalar factor[8];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Scalar norm_A_y = norm_of(A_y);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    store_complex(column_0, i, factor[0] * (conj_A_x * conj_A_x * A_y));  // b3
    // dissipative_y_A_x_A_y_conjA_x
    store_complex(column_1, i, times_i(factor[1] * (conj_A_x * conj_A_x * A_y)));
    store_complex(column_2, i, factor[2] * (conj_A_x * A_y * A_y * conj_F));  // harmonic_re_x_A_y3_F
    // harmonic_re_y_conjA_x3_F
    store_complex(column_3, i, factor[3] * (conj_A_x * conj_A_x * conj_A_x * F)
        + factor[4] * (conj_A_x * conj_A_x * conj_A_x * F));
    // harmonic_re_y_A_y2_conjA_x2_conjA_y
    store_complex(column_4, i, factor[5] * (conj_A_x * conj_A_x * norm_A_y * A_y));
    // harmonic_re_y_A_x_A_y_conjA_x3
    store_complex(column_5, i, factor[6] * (norm_A_x * conj_A_x * conj_A_x * A_y));
    store_complex(column_6, i, factor[7] * (conj_A_x * A_y * A_y * conj_F));  // harmonic_re_y_A_y2_conjA_x_F
  }
}

/// columns[j][i] of the rows.
inline void columns_10(const BatchArrays& data, double* const* columns) {
  rows_10(data, FactorValues<factors_10<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_10(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_10(data, FactorSlopes<factors_10<DualNumber>, 2, 1, 8>{mode}, columns);
}

/// What multiplies the 6 terms of the harmonic 3*omega2 of y: functions of the frequencies alone. 7 operations.
template <class Scalar>
void factors_11([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega2_2 = omega2 * omega2;
  factor[0] = -Scalar(1.0) / (Scalar(8.0) * omega2);
  factor[1] = Scalar(1.0) / (Scalar(8.0) * omega2_2);
  factor[2] = Scalar(7.0) / (Scalar(20.0) * omega2);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
}

/// Rows of the harmonic 3*omega2 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega2)*t) in y = -1/(8*omega2)*i*dissipative_y_A_y2_conjA_y*A_y^3 +
/// 1/(8*omega2^2)*b5*A_y^3 + 7/(20*omega2)*conservative_y_A_y3_conjA_y2*A_y^4*conj(A_y) +
/// harmonic_re_y_A_y2_conjA_x_F*conj(A_x)*A_y^2*F + harmonic_re_y_A_y2_conjA_x_F*conj(A_x)*A_y^2*F +
/// harmonic_re_y_A_x_A_y3_conjA_x*A_x*conj(A_x)*A_y^3
/// 5 columns; per observation at most 39 products and sums of complex numbers.
template <class Factors>
void rows_11(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar* __restrict column_4 = columns[4];
  Scalar factor[6];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Scalar norm_A_y = norm_of(A_y);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, times_i(factor[0] * (A_y * A_y * A_y)));  // dissipative_y_A_y2_conjA_y
    store_complex(column_1, i, factor[1] * (A_y * A_y * A_y));  // b5
    store_complex(column_2, i, factor[2] * (norm_A_y * A_y * A_y * A_y));  // conservative_y_A_y3_conjA_y2
    // harmonic_re_y_A_y2_conjA_x_F
    store_complex(column_3, i, factor[3] * (conj_A_x * A_y * A_y * F) + factor[4] * (conj_A_x * A_y * A_y * F));
    store_complex(column_4, i, factor[5] * (norm_A_x * A_y * A_y * A_y));  // harmonic_re_y_A_x_A_y3_conjA_x
  }
}

/// columns[j][i] of the rows.
inline void columns_11(const BatchArrays& data, double* const* columns) {
  rows_11(data, FactorValues<factors_11<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_11(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_11(data, FactorSlopes<factors_11<DualNumber>, 2, 1, 6>{mode}, columns);
}

/// What multiplies the 12 terms of the harmonic omega1+Omega of y: functions of the frequencies alone. 61
/// operations.
template <class Scalar>
void factors_12([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  factor[0] = (-Scalar(2.0) * omega1 * omega2 - omega2_2) * per_0 * per_1 / (Scalar(2.0) * omega1);
  factor[1] = per_0 / (Scalar(4.0) * omega1);
  factor[2] = (-Scalar(2.0) * omega1 * omega2_2 - omega2_3) * per_0_2 / (Scalar(4.0) * omega1_2);
  factor[3] = (-Scalar(2.0) * omega1 * omega2_2 - omega2_3) * per_0_2 / (Scalar(2.0) * omega1_2);
  factor[4] = -per_0 / (Scalar(8.0) * omega1);
  factor[5] = (-Scalar(2.0) * omega1_2 - Scalar(3.0) * omega1 * omega2 + Scalar(2.0) * omega1 * Omega - omega2_2
      + omega2 * Omega) * per_0_2 / (Scalar(16.0) * omega1_2);
  factor[6] = (Scalar(4.0) * omega1_3 * omega2_2 - Scalar(6.0) * omega1_2 * omega2_3
      + Scalar(2.0) * omega2_5) * per_0_2 * per_2 / omega1_2;
  factor[7] = Scalar(1.0);
  factor[8] = Scalar(1.0);
  factor[9] = Scalar(1.0);
  factor[10] = Scalar(1.0);
  factor[11] = Scalar(1.0);
}

/// Rows of the harmonic omega1+Omega of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + Omega)*t) in y = (-2*omega1*omega2 - omega2^2)/(2*omega1*(omega1 +
/// omega2)*(omega1 + 2*omega2))*conservative_x_A_x_F2*conj(A_y)*F^2 + 1/(4*omega1*(omega1 +
/// omega2))*b3*A_x^2*A_y + (-2*omega1*omega2^2 - omega2^3)/(4*omega1^2*(omega1 +
/// omega2)^2)*i*dissipative_y_A_x_A_y_conjA_x*A_x^2*A_y + (-2*omega1*omega2^2 - omega2^3)/(2*omega1^2*(omega1 +
/// omega2)^2)*i*dissipative_y_conjA_x_F*A_x*F - 1/(8*omega1*(omega1 + omega2))*q*A_x*F + (-2*omega1^2 -
/// 3*omega1*omega2 + 2*omega1*Omega - omega2^2 + omega2*Omega)/(16*omega1^2*(omega1 + omega2)^2)*q*A_x*F +
/// (4*omega1^3*omega2^2 - 6*omega1^2*omega2^3 + 2*omega2^5)/(omega1^2*(omega1 + omega2)^2*(omega1 -
/// 2*omega2))*harmonic_re_x_A_y3_F*A_x*A_y*conj(A_y)*F + harmonic_re_y_A_x_A_y_conjA_y_F*A_x*A_y*conj(A_y)*F +
/// harmonic_re_y_A_x2_conjA_x_F*A_x^2*conj(A_x)*F + harmonic_re_y_A_x2_conjA_x_F*A_x^2*conj(A_x)*F +
/// harmonic_re_y_A_x2_A_y2_conjA_y*A_x^2*A_y^2*conj(A_y) + harmonic_re_y_A_x3_A_y_conjA_x*A_x^3*conj(A_x)*A_y
/// 10 columns; per observation at most 60 products and sums of complex numbers.
template <class Factors>
void rows_12(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar* __restrict column_4 = columns[4];
  Scalar* __restrict column_5 = columns[5];
  Scalar* __restrict column_6 = columns[6];
  Scalar* __restrict column_7 = columns[7];
  Scalar* __restrict column_8 = columns[8];
  Scalar* __restrict column_9 = columns[9];
  Scalar factor[12];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Complex conj_A_y = conjugate(A_y);
    const Scalar norm_A_y = norm_of(A_y);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (conj_A_y * F * F));  // conservative_x_A_x_F2
    store_complex(column_1, i, factor[1] * (A_x * A_x * A_y));  // b3
    store_complex(column_2, i, times_i(factor[2] * (A_x * A_x * A_y)));  // dissipative_y_A_x_A_y_conjA_x
    store_complex(column_3, i, times_i(factor[3] * (A_x * F)));  // dissipative_y_conjA_x_F
    store_complex(column_4, i, factor[4] * (A_x * F) + factor[5] * (A_x * F));  // q
    store_complex(column_5, i, factor[6] * (A_x * norm_A_y * F));  // harmonic_re_x_A_y3_F
    store_complex(column_6, i, factor[7] * (A_x * norm_A_y * F));  // harmonic_re_y_A_x_A_y_conjA_y_F
    // harmonic_re_y_A_x2_conjA_x_F
    store_complex(column_7, i, factor[8] * (norm_A_x * A_x * F) + factor[9] * (norm_A_x * A_x * F));
    store_complex(column_8, i, factor[10] * (A_x * A_x * norm_A_y * A_y));  // harmonic_re_y_A_x2_A_y2_conjA_y
    store_complex(column_9, i, factor[11] * (norm_A_x * A_x * A_x * A_y));  // harmonic_re_y_A_x3_A_y_conjA_x
  }
}

/// columns[j][i] of the rows.
inline void columns_12(const BatchArrays& data, double* const* columns) {
  rows_12(data, FactorValues<factors_12<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_12(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_12(data, FactorSlopes<factors_12<DualNumber>, 2, 1, 12>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic -2*omega1+3*omega2 of y: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_13([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic -2*omega1+3*omega2 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-2*omega1 + 3*omega2)*t) in y = harmonic_re_y_A_y3_conjA_x2*conj(A_x)^2*A_y^3
/// 1 columns; per observation at most 9 products and sums of complex numbers.
template <class Factors>
void rows_13(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    // harmonic_re_y_A_y3_conjA_x2
    store_complex(column_0, i, factor[0] * (conj_A_x * conj_A_x * A_y * A_y * A_y));
  }
}

/// columns[j][i] of the rows.
inline void columns_13(const BatchArrays& data, double* const* columns) {
  rows_13(data, FactorValues<factors_13<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_13(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 3 terms of the harmonic omega2+2*Omega of y: functions of the frequencies alone. 10
/// operations.
template <class Scalar>
void factors_14([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1_2 = per_1 * per_1;
  factor[0] = omega1_2 * per_0 * per_1_2 / Scalar(2.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega2+2*Omega of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + 2*Omega)*t) in y = omega1^2/(2*(omega1 + omega2)*(omega1 +
/// 2*omega2)^2)*conservative_x_A_x_F2*A_y*F^2 + harmonic_re_y_A_x_A_y2_F*A_x*A_y^2*F +
/// harmonic_re_y_A_x2_A_y3*A_x^2*A_y^3
/// 3 columns; per observation at most 21 products and sums of complex numbers.
template <class Factors>
void rows_14(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[3];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex A_y = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_y * F * F));  // conservative_x_A_x_F2
    store_complex(column_1, i, factor[1] * (A_x * A_y * A_y * F));  // harmonic_re_y_A_x_A_y2_F
    store_complex(column_2, i, factor[2] * (A_x * A_x * A_y * A_y * A_y));  // harmonic_re_y_A_x2_A_y3
  }
}

/// columns[j][i] of the rows.
inline void columns_14(const BatchArrays& data, double* const* columns) {
  rows_14(data, FactorValues<factors_14<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_14(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_14(data, FactorSlopes<factors_14<DualNumber>, 2, 1, 3>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 5*omega2 of y: functions of the frequencies alone. 2 operations.
template <class Scalar>
void factors_15([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega2 = natural_frequency[1];
  factor[0] = -Scalar(1.0) / (Scalar(60.0) * omega2);
}

/// Rows of the harmonic 5*omega2 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(5*omega2)*t) in y = -1/(60*omega2)*conservative_y_A_y3_conjA_y2*A_y^5
/// 1 columns; per observation at most 1 products and sums of complex numbers.
template <class Factors>
void rows_15(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_y = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (fixed_power<5>(A_y)));  // conservative_y_A_y3_conjA_y2
  }
}

/// columns[j][i] of the rows.
inline void columns_15(const BatchArrays& data, double* const* columns) {
  rows_15(data, FactorValues<factors_15<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_15(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_15(data, FactorSlopes<factors_15<DualNumber>, 2, 1, 1>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic 3*omega1+Omega of y: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_16([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic 3*omega1+Omega of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega1 + Omega)*t) in y = harmonic_re_y_A_x3_F*A_x^3*F +
/// harmonic_re_y_A_x4_A_y*A_x^4*A_y
/// 2 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_16(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex A_y = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_x * A_x * A_x * F));  // harmonic_re_y_A_x3_F
    store_complex(column_1, i, factor[1] * (fixed_power<4>(A_x) * A_y));  // harmonic_re_y_A_x4_A_y
  }
}

/// columns[j][i] of the rows.
inline void columns_16(const BatchArrays& data, double* const* columns) {
  rows_16(data, FactorValues<factors_16<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_16(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic 4*omega1-omega2 of y: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_17([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic 4*omega1-omega2 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(4*omega1 - omega2)*t) in y = harmonic_re_y_A_x4_conjA_y*A_x^4*conj(A_y)
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_17(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex A_y = load_complex(amplitude_1, i);
    const Complex conj_A_y = conjugate(A_y);
    store_complex(column_0, i, factor[0] * (fixed_power<4>(A_x) * conj_A_y));  // harmonic_re_y_A_x4_conjA_y
  }
}

/// columns[j][i] of the rows.
inline void columns_17(const BatchArrays& data, double* const* columns) {
  rows_17(data, FactorValues<factors_17<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_17(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_x/dt + i*(w_x - omega1)*B_x = i*conservative_x_A_x2_A_y_F*A_x^2*A_y*F - mu1*A_x + i*conservative_x_A_x*A_x
/// + i*conservative_x_A_x_F2*A_x*F^2 + dissipative_x_A_x_A_y_conjA_y*A_x*A_y*conj(A_y) +
/// 1/omega1*i*b3*A_x*A_y*conj(A_y) + i*conservative_x_A_x_A_y2_conjA_y2*A_x*A_y^2*conj(A_y)^2 +
/// dissipative_x_A_x2_conjA_x*A_x^2*conj(A_x) + 3/(2*omega1)*i*b1*A_x^2*conj(A_x) +
/// i*conservative_x_A_x2_A_y_conjA_x_conjA_y*A_x^2*conj(A_x)*A_y*conj(A_y) +
/// i*conservative_x_A_x3_conjA_x2*A_x^3*conj(A_x)^2 + dissipative_x_conjA_y_F*conj(A_y)*F -
/// 1/(4*omega1)*i*p*conj(A_y)*F + (-omega1 - omega2 + Omega)/(8*omega1^2)*i*p*conj(A_y)*F +
/// i*conservative_x_A_y_conjA_y2_F*A_y*conj(A_y)^2*F +
/// i*conservative_x_A_x_conjA_x_conjA_y_F*A_x*conj(A_x)*conj(A_y)*F with A = B in that frame
/// dB_y/dt + i*(w_y - omega2)*B_y = (2*omega1^2 + omega1*omega2)/(omega2*(omega1 +
/// 2*omega2))*i*conservative_x_A_x_F2*A_y*F^2 + 1/omega2*i*b3*A_x*conj(A_x)*A_y + (2*omega1^5 -
/// 3*omega1^3*omega2^2)/(omega2^3*(3*omega1^2 -
/// 2*omega2^2))*i*conservative_x_A_x_A_y2_conjA_y2*A_x^2*conj(A_x)^2*A_y +
/// i*conservative_y_A_x_A_y2_F*A_x*A_y^2*F - mu2*A_y + i*conservative_y_A_y*A_y +
/// dissipative_y_A_y2_conjA_y*A_y^2*conj(A_y) + 3/(2*omega2)*i*b5*A_y^2*conj(A_y) +
/// i*conservative_y_A_y3_conjA_y2*A_y^3*conj(A_y)^2 + dissipative_y_A_x_A_y_conjA_x*A_x*conj(A_x)*A_y +
/// i*conservative_y_A_x_A_y2_conjA_x_conjA_y*A_x*conj(A_x)*A_y^2*conj(A_y) + dissipative_y_conjA_x_F*conj(A_x)*F
/// - 1/(4*omega2)*i*q*conj(A_x)*F + (-omega1 - omega2 + Omega)/(8*omega2^2)*i*q*conj(A_x)*F +
/// i*conservative_y_A_y_conjA_x_conjA_y_F*conj(A_x)*A_y*conj(A_y)*F +
/// i*conservative_y_A_x_conjA_x2_F*A_x*conj(A_x)^2*F with A = B in that frame
/// 162 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(3.0) * omega1_2 - Scalar(2.0) * omega2_2);
  Scalar lumps[57];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Complex conj_A_x = conjugate(A_x);
  const Scalar norm_A_x = norm_of(A_x);
  const Complex A_y = load_complex(amplitude, 1);
  const Complex conj_A_y = conjugate(A_y);
  const Scalar norm_A_y = norm_of(A_y);
  const Complex F = load_complex(forcing, 0);
  const Complex conj_F = conjugate(F);
  const Scalar norm_F = norm_of(F);
  store_complex(derivative, 0, times_i(lumps[0] * (A_x * A_x * A_y * conj_F))
       + lumps[1] * (-Scalar(1.0)) * (A_x)
       + times_i(lumps[2] * (A_x))
       + times_i(lumps[3] * (A_x * norm_F))
       + lumps[4] * (A_x * norm_A_y)
       + times_i(lumps[5] * Scalar(1.0) / omega1 * (A_x * norm_A_y))
       + times_i(lumps[6] * (A_x * norm_A_y * norm_A_y))
       + lumps[7] * (norm_A_x * A_x)
       + times_i(lumps[8] * Scalar(3.0) / (Scalar(2.0) * omega1) * (norm_A_x * A_x))
       + times_i(lumps[9] * (norm_A_x * A_x * norm_A_y))
       + times_i(lumps[10] * (norm_A_x * norm_A_x * A_x))
       + lumps[11] * (conj_A_y * F)
       + times_i(lumps[12] * (-Scalar(1.0) / (Scalar(4.0) * omega1)) * (conj_A_y * F))
       + times_i(lumps[12] * (-omega1 - omega2 + Omega) / (Scalar(8.0) * omega1_2) * (conj_A_y * F))
       + times_i(lumps[13] * (norm_A_y * conj_A_y * F))
       + times_i(lumps[14] * (norm_A_x * conj_A_y * F))
       - times_i((-omega1 - omega2 + excitation_frequency[0]) * A_x));
  store_complex(derivative, 1, times_i(lumps[3] * (Scalar(2.0) * omega1_2
      + omega1 * omega2) * per_0 / omega2 * (A_y * norm_F))
       + times_i(lumps[5] * Scalar(1.0) / omega2 * (norm_A_x * A_y))
       + times_i(lumps[6] * (Scalar(2.0) * omega1_5
      - Scalar(3.0) * omega1_3 * omega2_2) * per_1 / omega2_3 * (norm_A_x * norm_A_x * A_y))
       + times_i(lumps[15] * (A_x * A_y * A_y * conj_F))
       + lumps[16] * (-Scalar(1.0)) * (A_y)
       + times_i(lumps[17] * (A_y))
       + lumps[18] * (norm_A_y * A_y)
       + times_i(lumps[19] * Scalar(3.0) / (Scalar(2.0) * omega2) * (norm_A_y * A_y))
       + times_i(lumps[20] * (norm_A_y * norm_A_y * A_y))
       + lumps[21] * (norm_A_x * A_y)
       + times_i(lumps[22] * (norm_A_x * norm_A_y * A_y))
       + lumps[23] * (conj_A_x * F)
       + times_i(lumps[24] * (-Scalar(1.0) / (Scalar(4.0) * omega2)) * (conj_A_x * F))
       + times_i(lumps[24] * (-omega1 - omega2 + Omega) / (Scalar(8.0) * omega2_2) * (conj_A_x * F))
       + times_i(lumps[25] * (conj_A_x * norm_A_y * F))
       + times_i(lumps[26] * (norm_A_x * conj_A_x * F)));
}

/// jacobian[i * 4 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 301 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (Scalar(3.0) * omega1_2 - Scalar(2.0) * omega2_2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  Scalar lumps[57];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Complex conj_A_x = conjugate(A_x);
  const Scalar norm_A_x = norm_of(A_x);
  const Complex A_y = load_complex(amplitude, 1);
  const Complex conj_A_y = conjugate(A_y);
  const Scalar norm_A_y = norm_of(A_y);
  const Complex F = load_complex(forcing, 0);
  const Complex conj_F = conjugate(F);
  const Scalar norm_F = norm_of(F);
  for (std::size_t i = 0; i < 16; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = times_i(lumps[0] * Scalar(2) * (A_x * A_y * conj_F))
       + Complex(lumps[1] * (-Scalar(1.0)))
       + times_i(Complex(lumps[2]))
       + times_i(Complex(lumps[3] * (norm_F)))
       + Complex(lumps[4] * (norm_A_y))
       + times_i(Complex(lumps[5] * Scalar(1.0) / omega1 * (norm_A_y)))
       + times_i(Complex(lumps[6] * (norm_A_y * norm_A_y)))
       + Complex(lumps[7] * Scalar(2) * (norm_A_x))
       + times_i(Complex(lumps[8] * Scalar(3.0) / (Scalar(2.0) * omega1) * Scalar(2) * (norm_A_x)))
       + times_i(Complex(lumps[9] * Scalar(2) * (norm_A_x * norm_A_y)))
       + times_i(Complex(lumps[10] * Scalar(3) * (norm_A_x * norm_A_x)))
       + times_i(lumps[14] * (conj_A_x * conj_A_y * F))
       - Complex(Scalar(0.0), -omega1 - omega2 + excitation_frequency[0]);
  const Complex conj_by_0_0 = lumps[7] * (A_x * A_x)
       + times_i(lumps[8] * Scalar(3.0) / (Scalar(2.0) * omega1) * (A_x * A_x))
       + times_i(lumps[9] * (A_x * A_x * norm_A_y))
       + times_i(lumps[10] * Scalar(2) * (norm_A_x * A_x * A_x))
       + times_i(lumps[14] * (A_x * conj_A_y * F));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[4] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[5] = by_0_0.real - conj_by_0_0.real;
  const Complex by_0_1 = times_i(lumps[0] * (A_x * A_x * conj_F))
       + lumps[4] * (A_x * conj_A_y)
       + times_i(lumps[5] * Scalar(1.0) / omega1 * (A_x * conj_A_y))
       + times_i(lumps[6] * Scalar(2) * (A_x * norm_A_y * conj_A_y))
       + times_i(lumps[9] * (norm_A_x * A_x * conj_A_y))
       + times_i(lumps[13] * (conj_A_y * conj_A_y * F));
  const Complex conj_by_0_1 = lumps[4] * (A_x * A_y)
       + times_i(lumps[5] * Scalar(1.0) / omega1 * (A_x * A_y))
       + times_i(lumps[6] * Scalar(2) * (A_x * norm_A_y * A_y))
       + times_i(lumps[9] * (norm_A_x * A_x * A_y))
       + lumps[11] * (F)
       + times_i(lumps[12] * (-Scalar(1.0) / (Scalar(4.0) * omega1)) * (F))
       + times_i(lumps[12] * (-omega1 - omega2 + Omega) / (Scalar(8.0) * omega1_2) * (F))
       + times_i(lumps[13] * Scalar(2) * (norm_A_y * F))
       + times_i(lumps[14] * (norm_A_x * F));
  jacobian[2] = by_0_1.real + conj_by_0_1.real;
  jacobian[3] = conj_by_0_1.imag - by_0_1.imag;
  jacobian[6] = by_0_1.imag + conj_by_0_1.imag;
  jacobian[7] = by_0_1.real - conj_by_0_1.real;
  const Complex by_1_0 = times_i(lumps[5] * Scalar(1.0) / omega2 * (conj_A_x * A_y))
       + times_i(lumps[6] * (Scalar(2.0) * omega1_5
      - Scalar(3.0) * omega1_3 * omega2_2) * per_0 / omega2_3 * Scalar(2) * (norm_A_x * conj_A_x * A_y))
       + times_i(lumps[15] * (A_y * A_y * conj_F))
       + lumps[21] * (conj_A_x * A_y)
       + times_i(lumps[22] * (conj_A_x * norm_A_y * A_y))
       + times_i(lumps[26] * (conj_A_x * conj_A_x * F));
  const Complex conj_by_1_0 = times_i(lumps[5] * Scalar(1.0) / omega2 * (A_x * A_y))
       + times_i(lumps[6] * (Scalar(2.0) * omega1_5
      - Scalar(3.0) * omega1_3 * omega2_2) * per_0 / omega2_3 * Scalar(2) * (norm_A_x * A_x * A_y))
       + lumps[21] * (A_x * A_y)
       + times_i(lumps[22] * (A_x * norm_A_y * A_y))
       + lumps[23] * (F)
       + times_i(lumps[24] * (-Scalar(1.0) / (Scalar(4.0) * omega2)) * (F))
       + times_i(lumps[24] * (-omega1 - omega2 + Omega) / (Scalar(8.0) * omega2_2) * (F))
       + times_i(lumps[25] * (norm_A_y * F))
       + times_i(lumps[26] * Scalar(2) * (norm_A_x * F));
  jacobian[8] = by_1_0.real + conj_by_1_0.real;
  jacobian[9] = conj_by_1_0.imag - by_1_0.imag;
  jacobian[12] = by_1_0.imag + conj_by_1_0.imag;
  jacobian[13] = by_1_0.real - conj_by_1_0.real;
  const Complex by_1_1 = times_i(Complex(lumps[3] * (Scalar(2.0) * omega1_2
      + omega1 * omega2) * per_1 / omega2 * (norm_F)))
       + times_i(Complex(lumps[5] * Scalar(1.0) / omega2 * (norm_A_x)))
       + times_i(Complex(lumps[6] * (Scalar(2.0) * omega1_5
      - Scalar(3.0) * omega1_3 * omega2_2) * per_0 / omega2_3 * (norm_A_x * norm_A_x)))
       + times_i(lumps[15] * Scalar(2) * (A_x * A_y * conj_F))
       + Complex(lumps[16] * (-Scalar(1.0)))
       + times_i(Complex(lumps[17]))
       + Complex(lumps[18] * Scalar(2) * (norm_A_y))
       + times_i(Complex(lumps[19] * Scalar(3.0) / (Scalar(2.0) * omega2) * Scalar(2) * (norm_A_y)))
       + times_i(Complex(lumps[20] * Scalar(3) * (norm_A_y * norm_A_y)))
       + Complex(lumps[21] * (norm_A_x))
       + times_i(Complex(lumps[22] * Scalar(2) * (norm_A_x * norm_A_y)))
       + times_i(lumps[25] * (conj_A_x * conj_A_y * F));
  const Complex conj_by_1_1 = lumps[18] * (A_y * A_y)
       + times_i(lumps[19] * Scalar(3.0) / (Scalar(2.0) * omega2) * (A_y * A_y))
       + times_i(lumps[20] * Scalar(2) * (norm_A_y * A_y * A_y))
       + times_i(lumps[22] * (norm_A_x * A_y * A_y))
       + times_i(lumps[25] * (conj_A_x * A_y * F));
  jacobian[10] = by_1_1.real + conj_by_1_1.real;
  jacobian[11] = conj_by_1_1.imag - by_1_1.imag;
  jacobian[14] = by_1_1.imag + conj_by_1_1.imag;
  jacobian[15] = by_1_1.real - conj_by_1_1.real;
}

}  // namespace additive_second_order

namespace difference {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: p = p
/// lumps[1]: mu1 = mu1
/// lumps[2]: b3 = b3
/// lumps[3]: b1 = b1
/// lumps[4]: mu2 = mu2
/// lumps[5]: b5 = b5
/// lumps[6]: q = q
/// 0 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
  const Scalar mu1 = parameters[2];
  const Scalar b1 = parameters[3];
  const Scalar b3 = parameters[4];
  const Scalar p = parameters[5];
  const Scalar mu2 = parameters[6];
  const Scalar b5 = parameters[7];
  const Scalar q = parameters[8];
  lumps[0] = p;  // p
  lumps[1] = mu1;  // mu1
  lumps[2] = b3;  // b3
  lumps[3] = b1;  // b1
  lumps[4] = mu2;  // mu2
  lumps[5] = b5;  // b5
  lumps[6] = q;  // q
}

/// jacobian[l * 9 + p] = d lumps[l] / d parameters[p]. 0 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  for (std::size_t i = 0; i < 63; ++i) jacobian[i] = Scalar(0.0);
  jacobian[5] = Scalar(1.0);  // d p / d p
  jacobian[11] = Scalar(1.0);  // d mu1 / d mu1
  jacobian[22] = Scalar(1.0);  // d b3 / d b3
  jacobian[30] = Scalar(1.0);  // d b1 / d b1
  jacobian[42] = Scalar(1.0);  // d mu2 / d mu2
  jacobian[52] = Scalar(1.0);  // d b5 / d b5
  jacobian[62] = Scalar(1.0);  // d q / d q
}

/// What multiplies the 4 terms of the modulation of x: functions of the frequencies alone. 5 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  factor[0] = -Scalar(1.0) / (Scalar(4.0) * omega1);
  factor[1] = -Scalar(1.0);
  factor[2] = Scalar(1.0) / omega1;
  factor[3] = Scalar(3.0) / (Scalar(2.0) * omega1);
}

/// Rows of the modulation of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega1)*A_x = -1/(4*omega1)*i*p*A_y*F - mu1*A_x + 1/omega1*i*b3*A_x*A_y*conj(A_y) +
/// 3/(2*omega1)*i*b1*A_x^2*conj(A_x)
/// 4 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_0(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Scalar norm_A_y = norm_of(A_y);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    store_complex(column_0, i, times_i(factor[0] * (A_y * conj_F)));  // p
    store_complex(column_1, i, factor[1] * (A_x));  // mu1
    store_complex(column_2, i, times_i(factor[2] * (A_x * norm_A_y)));  // b3
    store_complex(column_3, i, times_i(factor[3] * (norm_A_x * A_x)));  // b1
  }
}

/// columns[j][i] of the rows.
inline void columns_0(const BatchArrays& data, double* const* columns) {
  rows_0(data, FactorValues<factors_0<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_0(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_0(data, FactorSlopes<factors_0<DualNumber>, 2, 1, 4>{mode}, columns);
}

/// What multiplies the 4 terms of the modulation of y: functions of the frequencies alone. 5 operations.
template <class Scalar>
void factors_1([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega2 = natural_frequency[1];
  factor[0] = Scalar(1.0) / omega2;
  factor[1] = -Scalar(1.0);
  factor[2] = Scalar(3.0) / (Scalar(2.0) * omega2);
  factor[3] = -Scalar(1.0) / (Scalar(4.0) * omega2);
}

/// Rows of the modulation of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega2)*A_y = 1/omega2*i*b3*A_x*conj(A_x)*A_y - mu2*A_y + 3/(2*omega2)*i*b5*A_y^2*conj(A_y) -
/// 1/(4*omega2)*i*q*A_x*F
/// 4 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_1(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Scalar norm_A_y = norm_of(A_y);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, times_i(factor[0] * (norm_A_x * A_y)));  // b3
    store_complex(column_1, i, factor[1] * (A_y));  // mu2
    store_complex(column_2, i, times_i(factor[2] * (norm_A_y * A_y)));  // b5
    store_complex(column_3, i, times_i(factor[3] * (A_x * F)));  // q
  }
}

/// columns[j][i] of the rows.
inline void columns_1(const BatchArrays& data, double* const* columns) {
  rows_1(data, FactorValues<factors_1<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_1(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_1(data, FactorSlopes<factors_1<DualNumber>, 2, 1, 4>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic omega2+Omega of x: functions of the frequencies alone. 12
/// operations.
template <class Scalar>
void factors_2([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2 + Omega);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2 - Omega);
  const Scalar per_2 = Scalar(1.0) / (omega1 - omega2);
  factor[0] = per_0 * per_1 / Scalar(2.0);
  factor[1] = -per_2 / (Scalar(4.0) * omega2);
}

/// Rows of the harmonic omega2+Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + Omega)*t) in x = 1/(2*(omega1 + omega2 + Omega)*(omega1 - omega2 -
/// Omega))*p*A_y*F - 1/(4*omega2*(omega1 - omega2))*b3*conj(A_x)*A_y^2
/// 2 columns; per observation at most 8 products and sums of complex numbers.
template <class Factors>
void rows_2(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_y * F));  // p
    store_complex(column_1, i, factor[1] * (conj_A_x * A_y * A_y));  // b3
  }
}

/// columns[j][i] of the rows.
inline void columns_2(const BatchArrays& data, double* const* columns) {
  rows_2(data, FactorValues<factors_2<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_2(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_2(data, FactorSlopes<factors_2<DualNumber>, 2, 1, 2>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic omega1+2*omega2 of x: functions of the frequencies alone. 4
/// operations.
template <class Scalar>
void factors_3([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  factor[0] = per_0 / (Scalar(4.0) * omega2);
}

/// Rows of the harmonic omega1+2*omega2 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + 2*omega2)*t) in x = 1/(4*omega2*(omega1 + omega2))*b3*A_x*A_y^2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_3(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex A_y = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_x * A_y * A_y));  // b3
  }
}

/// columns[j][i] of the rows.
inline void columns_3(const BatchArrays& data, double* const* columns) {
  rows_3(data, FactorValues<factors_3<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_3(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_3(data, FactorSlopes<factors_3<DualNumber>, 2, 1, 1>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic -omega1+Omega of y: functions of the frequencies alone. 12
/// operations.
template <class Scalar>
void factors_5([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2 - Omega);
  const Scalar per_2 = Scalar(1.0) / (omega1 - omega2 - Omega);
  factor[0] = per_0 / (Scalar(4.0) * omega1);
  factor[1] = -per_1 * per_2 / Scalar(2.0);
}

/// Rows of the harmonic -omega1+Omega of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + Omega)*t) in y = 1/(4*omega1*(omega1 - omega2))*b3*conj(A_x)^2*A_y -
/// 1/(2*(omega1 + omega2 - Omega)*(omega1 - omega2 - Omega))*q*conj(A_x)*F
/// 2 columns; per observation at most 8 products and sums of complex numbers.
template <class Factors>
void rows_5(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (conj_A_x * conj_A_x * A_y));  // b3
    store_complex(column_1, i, factor[1] * (conj_A_x * F));  // q
  }
}

/// columns[j][i] of the rows.
inline void columns_5(const BatchArrays& data, double* const* columns) {
  rows_5(data, FactorValues<factors_5<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_5(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_5(data, FactorSlopes<factors_5<DualNumber>, 2, 1, 2>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 2*omega1+omega2 of y: functions of the frequencies alone. 4
/// operations.
template <class Scalar>
void factors_7([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  factor[0] = per_0 / (Scalar(4.0) * omega1);
}

/// Rows of the harmonic 2*omega1+omega2 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega1 + omega2)*t) in y = 1/(4*omega1*(omega1 + omega2))*b3*A_x^2*A_y
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_7(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex A_y = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_x * A_x * A_y));  // b3
  }
}

/// columns[j][i] of the rows.
inline void columns_7(const BatchArrays& data, double* const* columns) {
  rows_7(data, FactorValues<factors_7<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_7(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_7(data, FactorSlopes<factors_7<DualNumber>, 2, 1, 1>{mode}, columns);
}

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_x/dt + i*(w_x - omega1)*B_x = -1/(4*omega1)*i*p*A_y*F - mu1*A_x + 1/omega1*i*b3*A_x*A_y*conj(A_y) +
/// 3/(2*omega1)*i*b1*A_x^2*conj(A_x) with A = B in that frame
/// dB_y/dt + i*(w_y - omega2)*B_y = 1/omega2*i*b3*A_x*conj(A_x)*A_y - mu2*A_y +
/// 3/(2*omega2)*i*b5*A_y^2*conj(A_y) - 1/(4*omega2)*i*q*A_x*F with A = B in that frame
/// 42 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  Scalar lumps[7];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Scalar norm_A_x = norm_of(A_x);
  const Complex A_y = load_complex(amplitude, 1);
  const Scalar norm_A_y = norm_of(A_y);
  const Complex F = load_complex(forcing, 0);
  const Complex conj_F = conjugate(F);
  store_complex(derivative, 0, times_i(lumps[0] * (-Scalar(1.0) / (Scalar(4.0) * omega1)) * (A_y * conj_F))
       + lumps[1] * (-Scalar(1.0)) * (A_x)
       + times_i(lumps[2] * Scalar(1.0) / omega1 * (A_x * norm_A_y))
       + times_i(lumps[3] * Scalar(3.0) / (Scalar(2.0) * omega1) * (norm_A_x * A_x))
       - times_i((-omega1 + omega2 - excitation_frequency[0]) * A_x));
  store_complex(derivative, 1, times_i(lumps[2] * Scalar(1.0) / omega2 * (norm_A_x * A_y))
       + lumps[4] * (-Scalar(1.0)) * (A_y)
       + times_i(lumps[5] * Scalar(3.0) / (Scalar(2.0) * omega2) * (norm_A_y * A_y))
       + times_i(lumps[6] * (-Scalar(1.0) / (Scalar(4.0) * omega2)) * (A_x * F)));
}

/// jacobian[i * 4 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 77 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  Scalar lumps[7];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Complex conj_A_x = conjugate(A_x);
  const Scalar norm_A_x = norm_of(A_x);
  const Complex A_y = load_complex(amplitude, 1);
  const Complex conj_A_y = conjugate(A_y);
  const Scalar norm_A_y = norm_of(A_y);
  const Complex F = load_complex(forcing, 0);
  const Complex conj_F = conjugate(F);
  for (std::size_t i = 0; i < 16; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = Complex(lumps[1] * (-Scalar(1.0)))
       + times_i(Complex(lumps[2] * Scalar(1.0) / omega1 * (norm_A_y)))
       + times_i(Complex(lumps[3] * Scalar(3.0) / (Scalar(2.0) * omega1) * Scalar(2) * (norm_A_x)))
       - Complex(Scalar(0.0), -omega1 + omega2 - excitation_frequency[0]);
  const Complex conj_by_0_0 = times_i(lumps[3] * Scalar(3.0) / (Scalar(2.0) * omega1) * (A_x * A_x));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[4] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[5] = by_0_0.real - conj_by_0_0.real;
  const Complex by_0_1 = times_i(lumps[0] * (-Scalar(1.0) / (Scalar(4.0) * omega1)) * (conj_F))
       + times_i(lumps[2] * Scalar(1.0) / omega1 * (A_x * conj_A_y));
  const Complex conj_by_0_1 = times_i(lumps[2] * Scalar(1.0) / omega1 * (A_x * A_y));
  jacobian[2] = by_0_1.real + conj_by_0_1.real;
  jacobian[3] = conj_by_0_1.imag - by_0_1.imag;
  jacobian[6] = by_0_1.imag + conj_by_0_1.imag;
  jacobian[7] = by_0_1.real - conj_by_0_1.real;
  const Complex by_1_0 = times_i(lumps[2] * Scalar(1.0) / omega2 * (conj_A_x * A_y))
       + times_i(lumps[6] * (-Scalar(1.0) / (Scalar(4.0) * omega2)) * (F));
  const Complex conj_by_1_0 = times_i(lumps[2] * Scalar(1.0) / omega2 * (A_x * A_y));
  jacobian[8] = by_1_0.real + conj_by_1_0.real;
  jacobian[9] = conj_by_1_0.imag - by_1_0.imag;
  jacobian[12] = by_1_0.imag + conj_by_1_0.imag;
  jacobian[13] = by_1_0.real - conj_by_1_0.real;
  const Complex by_1_1 = times_i(Complex(lumps[2] * Scalar(1.0) / omega2 * (norm_A_x)))
       + Complex(lumps[4] * (-Scalar(1.0)))
       + times_i(Complex(lumps[5] * Scalar(3.0) / (Scalar(2.0) * omega2) * Scalar(2) * (norm_A_y)));
  const Complex conj_by_1_1 = times_i(lumps[5] * Scalar(3.0) / (Scalar(2.0) * omega2) * (A_y * A_y));
  jacobian[10] = by_1_1.real + conj_by_1_1.real;
  jacobian[11] = conj_by_1_1.imag - by_1_1.imag;
  jacobian[14] = by_1_1.imag + conj_by_1_1.imag;
  jacobian[15] = by_1_1.real - conj_by_1_1.real;
}

}  // namespace difference

}  // namespace secular::generated::parametric_pair
