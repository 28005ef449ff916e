// Model internal_resonance: generated code, never edited by hand.
// Source: Two coupled modes with a potential of fourth degree
// Equation of motion: 0 = omega1^2*x + 2*a2*x*y + b3*x*y^2 + a1*x^2 + 3*b2*x^2*y + b1*x^3 + 2*mu1*D(x) + D2(x)
// + a3*y^2 + b4*y^3 - e1*F*cos(Omega*t)
// Equation of motion: 0 = 2*a3*x*y + 3*b4*x*y^2 + a2*x^2 + b3*x^2*y + b2*x^3 + omega2^2*y + a4*y^2 + b5*y^3 +
// 2*mu2*D(y) + D2(y) - e2*F*cos(Omega*t)
// Case one_to_one: omega2 = omega1 + eps^2*sigma1; Omega = omega1 + eps^2*sigma2, multiple scales to eps^2.
// Valid near that resonance for small amplitudes; what is left out is of order eps^3.
// Case one_to_two: omega2 = 2*omega1 + eps*sigma1; Omega = omega2 + eps*sigma2, multiple scales to eps^2. Valid
// near that resonance for small amplitudes; what is left out is of order eps^3.
// Case one_to_three: omega2 = 3*omega1 + eps^2*sigma1; Omega = omega1 + eps^2*sigma2, multiple scales to eps^2.
// Valid near that resonance for small amplitudes; what is left out is of order eps^3.
// Case free_one_to_two: omega2 = 2*omega1 + eps*sigma1, multiple scales to eps^2. Valid near that resonance for
// small amplitudes; what is left out is of order eps^3.
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// Made by: secular generate internal_resonance
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

namespace secular::generated::internal_resonance {

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
/// 0 = omega1^2*x + 2*a2*x*y + b3*x*y^2 + a1*x^2 + 3*b2*x^2*y + b1*x^3 + 2*mu1*D(x) + D2(x) + a3*y^2 + b4*y^3 -
/// e1*F*cos(Omega*t)
/// 0 = 2*a3*x*y + 3*b4*x*y^2 + a2*x^2 + b3*x^2*y + b2*x^3 + omega2^2*y + a4*y^2 + b5*y^3 + 2*mu2*D(y) + D2(y) -
/// e2*F*cos(Omega*t)
/// parameters: [0] omega1, [1] omega2, [2] a1, [3] a2, [4] a3, [5] a4, [6] b1, [7] b2, [8] b3, [9] b4, [10] b5,
/// [11] mu1, [12] e1, [13] mu2, [14] e2. displacement, velocity, acceleration: 2 values. 68 operations.
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
  acceleration[0] = -(omega1_2 * displacement[0] + Scalar(2.0) * a2 * displacement[0] * displacement[1]
      + b3 * displacement[0] * displacement[1] * displacement[1] + a1 * displacement[0] * displacement[0]
      + Scalar(3.0) * b2 * displacement[0] * displacement[0] * displacement[1]
      + b1 * displacement[0] * displacement[0] * displacement[0] + Scalar(2.0) * mu1 * velocity[0]
      + a3 * displacement[1] * displacement[1] + b4 * displacement[1] * displacement[1] * displacement[1]
      - e1 * Scalar(excitation[0].value));
  acceleration[1] = -(Scalar(2.0) * a3 * displacement[0] * displacement[1]
      + Scalar(3.0) * b4 * displacement[0] * displacement[1] * displacement[1]
      + a2 * displacement[0] * displacement[0] + b3 * displacement[0] * displacement[0] * displacement[1]
      + b2 * displacement[0] * displacement[0] * displacement[0] + omega2_2 * displacement[1]
      + a4 * displacement[1] * displacement[1] + b5 * displacement[1] * displacement[1] * displacement[1]
      + Scalar(2.0) * mu2 * velocity[1] - e2 * Scalar(excitation[0].value));
}

/// slope[k * 4 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = x, y, D(x), D(y).
/// Of nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x) = 0. 74
/// operations before the solution of 4 right sides.
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
  for (std::size_t i = 0; i < 8; ++i) slope[i] = Scalar(0.0);
  // equation 1 by x
  slope[0] = -(omega1_2 + Scalar(2.0) * a2 * displacement[1] + b3 * displacement[1] * displacement[1]
      + a1 * displacement[0] * Scalar(2.0) + Scalar(3.0) * b2 * displacement[0] * displacement[1] * Scalar(2.0)
      + b1 * displacement[0] * displacement[0] * Scalar(3.0));
  // equation 1 by y
  slope[1] = -(Scalar(2.0) * a2 * displacement[0] + b3 * displacement[0] * displacement[1] * Scalar(2.0)
      + Scalar(3.0) * b2 * displacement[0] * displacement[0] + a3 * displacement[1] * Scalar(2.0)
      + b4 * displacement[1] * displacement[1] * Scalar(3.0));
  slope[2] = -(Scalar(2.0) * mu1);  // equation 1 by D(x)
  // equation 2 by x
  slope[4] = -(Scalar(2.0) * a3 * displacement[1] + Scalar(3.0) * b4 * displacement[1] * displacement[1]
      + a2 * displacement[0] * Scalar(2.0) + b3 * displacement[0] * displacement[1] * Scalar(2.0)
      + b2 * displacement[0] * displacement[0] * Scalar(3.0));
  // equation 2 by y
  slope[5] = -(Scalar(2.0) * a3 * displacement[0]
      + Scalar(3.0) * b4 * displacement[0] * displacement[1] * Scalar(2.0) + b3 * displacement[0] * displacement[0]
      + omega2_2 + a4 * displacement[1] * Scalar(2.0) + b5 * displacement[1] * displacement[1] * Scalar(3.0));
  slope[7] = -(Scalar(2.0) * mu2);  // equation 2 by D(y)
}

/// slope[k * 15 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = omega1, omega2,
/// a1, a2, a3, a4, b1, b2, b3, b4, b5, mu1, e1, mu2, e2. Of nonsmooth terms the classical derivative: d|x| =
/// sgn(x) dx, zero at the corner, and d sgn(x) = 0. 34 operations before the solution of 15 right sides.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_parameters([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  for (std::size_t i = 0; i < 30; ++i) slope[i] = Scalar(0.0);
  slope[0] = -(Scalar(2.0) * omega1 * displacement[0]);  // equation 1 by omega1
  slope[2] = -(displacement[0] * displacement[0]);  // equation 1 by a1
  slope[3] = -(Scalar(2.0) * displacement[0] * displacement[1]);  // equation 1 by a2
  slope[4] = -(displacement[1] * displacement[1]);  // equation 1 by a3
  slope[6] = -(displacement[0] * displacement[0] * displacement[0]);  // equation 1 by b1
  slope[7] = -(Scalar(3.0) * displacement[0] * displacement[0] * displacement[1]);  // equation 1 by b2
  slope[8] = -(displacement[0] * displacement[1] * displacement[1]);  // equation 1 by b3
  slope[9] = -(displacement[1] * displacement[1] * displacement[1]);  // equation 1 by b4
  slope[11] = -(Scalar(2.0) * velocity[0]);  // equation 1 by mu1
  slope[12] = -(-Scalar(1.0) * Scalar(excitation[0].value));  // equation 1 by e1
  slope[16] = -(Scalar(2.0) * omega2 * displacement[1]);  // equation 2 by omega2
  slope[18] = -(displacement[0] * displacement[0]);  // equation 2 by a2
  slope[19] = -(Scalar(2.0) * displacement[0] * displacement[1]);  // equation 2 by a3
  slope[20] = -(displacement[1] * displacement[1]);  // equation 2 by a4
  slope[22] = -(displacement[0] * displacement[0] * displacement[0]);  // equation 2 by b2
  slope[23] = -(displacement[0] * displacement[0] * displacement[1]);  // equation 2 by b3
  slope[24] = -(Scalar(3.0) * displacement[0] * displacement[1] * displacement[1]);  // equation 2 by b4
  slope[25] = -(displacement[1] * displacement[1] * displacement[1]);  // equation 2 by b5
  slope[28] = -(Scalar(2.0) * velocity[1]);  // equation 2 by mu2
  slope[29] = -(-Scalar(1.0) * Scalar(excitation[0].value));  // equation 2 by e2
}

/// conservative_x_A_x2_conjA_y = (9*omega1^2*b2 + 2*a1*a2)/(6*omega1^3) + 2*a2*a3/(omega1^2*(omega1 - 2*omega2))
/// - 2*a1*a2/(omega1*omega2*(2*omega1 - omega2)) + a2*a3/(omega1*(2*omega1 + omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 42 operations.
template <class Scalar>
Scalar lump_0(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar b2 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar per_0 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar f_0 = Scalar(3.0) * b2 / (Scalar(2.0) * omega1);
  const Scalar f_1 = a1 * a2 / (Scalar(3.0) * omega1_3);
  const Scalar f_2 = Scalar(2.0) * a2 * a3 * per_0 / omega1_2;
  const Scalar f_3 = -Scalar(2.0) * a1 * a2 * per_1 / (omega1 * omega2);
  const Scalar f_4 = a2 * a3 * per_2 * per_1 / omega1;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_2 * per_0;
  const Scalar q_1 = (f_3 + f_4) * per_1;
  const Scalar q_2 = f_4 * per_2;
  // by omega1
  gradient[0] = (-f_0 - Scalar(3.0) * f_1 - Scalar(2.0) * f_2 - f_3 - f_4) / omega1 - q_0 - Scalar(2.0) * q_1
      - Scalar(2.0) * q_2;
  gradient[1] = -f_3 / omega2 + Scalar(2.0) * q_0 + q_1 - q_2;  // by omega2
  // multiplies a1*a2
  const Scalar c_0 = Scalar(1.0) / (Scalar(3.0) * omega1_3) - Scalar(2.0) * per_1 / (omega1 * omega2);
  const Scalar c_1 = Scalar(2.0) * per_0 / omega1_2 + per_2 * per_1 / omega1;  // multiplies a2*a3
  const Scalar c_2 = Scalar(3.0) / (Scalar(2.0) * omega1);  // multiplies b2
  gradient[2] = a2 * c_0;  // by a1
  gradient[3] = a1 * c_0 + a3 * c_1;  // by a2
  gradient[4] = a2 * c_1;  // by a3
  gradient[7] = c_2;  // by b2
  return value;
}

/// conservative_x_A_x_A_y_conjA_y = (omega1^2*omega2^2*b3 - 2*omega1^2*a2*a4 -
/// 2*omega2^2*a1*a3)/(omega1^3*omega2^2) + 4*a3^2/(omega1*(omega1 + 2*omega2)*(omega1 - 2*omega2)) -
/// 4*a2^2/(omega1*(2*omega1 + omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 40 operations.
template <class Scalar>
Scalar lump_1(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = b3 / omega1;
  const Scalar f_1 = -Scalar(2.0) * a2 * a4 / (omega1 * omega2_2);
  const Scalar f_2 = -Scalar(2.0) * a1 * a3 / omega1_3;
  const Scalar f_3 = Scalar(4.0) * a3_2 * per_0 * per_1 / omega1;
  const Scalar f_4 = -Scalar(4.0) * a2_2 * per_2 * per_3 / omega1;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_3 * per_0;
  const Scalar q_1 = f_3 * per_1;
  const Scalar q_2 = f_4 * per_2;
  const Scalar q_3 = f_4 * per_3;
  // by omega1
  gradient[0] = (-f_0 - f_1 - Scalar(3.0) * f_2 - f_3 - f_4) / omega1 - q_0 - q_1 - Scalar(2.0) * q_2
      - Scalar(2.0) * q_3;
  gradient[1] = -Scalar(2.0) * f_1 / omega2 - Scalar(2.0) * q_0 + Scalar(2.0) * q_1 - q_2 + q_3;  // by omega2
  const Scalar c_0 = -Scalar(2.0) / omega1_3;  // multiplies a1*a3
  const Scalar c_1 = -Scalar(4.0) * per_2 * per_3 / omega1;  // multiplies a2^2
  const Scalar c_2 = -Scalar(2.0) / (omega1 * omega2_2);  // multiplies a2*a4
  const Scalar c_3 = Scalar(4.0) * per_0 * per_1 / omega1;  // multiplies a3^2
  const Scalar c_4 = Scalar(1.0) / omega1;  // multiplies b3
  gradient[2] = a3 * c_0;  // by a1
  gradient[3] = Scalar(2.0) * a2 * c_1 + a4 * c_2;  // by a2
  gradient[4] = a1 * c_0 + Scalar(2.0) * a3 * c_3;  // by a3
  gradient[5] = a2 * c_2;  // by a4
  gradient[8] = c_4;  // by b3
  return value;
}

/// conservative_x_A_x2_conjA_x = (9*omega1^2*b1 - 10*a1^2)/(6*omega1^3) + (-8*omega1^2*a2^2 +
/// 3*omega2^2*a2^2)/(omega1*omega2^2*(2*omega1 + omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 34 operations.
template <class Scalar>
Scalar lump_2(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar b1 = parameters[6];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar a1_2 = a1 * a1;
  const Scalar a2_2 = a2 * a2;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = Scalar(3.0) * b1 / (Scalar(2.0) * omega1);
  const Scalar f_1 = -Scalar(5.0) * a1_2 / (Scalar(3.0) * omega1_3);
  const Scalar f_2 = -Scalar(8.0) * omega1 * a2_2 * per_0 * per_1 / omega2_2;
  const Scalar f_3 = Scalar(3.0) * a2_2 * per_0 * per_1 / omega1;
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_2 + f_3) * per_0;
  const Scalar q_1 = (f_2 + f_3) * per_1;
  // by omega1
  gradient[0] = (-f_0 - Scalar(3.0) * f_1 + f_2 - f_3) / omega1 - Scalar(2.0) * q_0 - Scalar(2.0) * q_1;
  gradient[1] = -Scalar(2.0) * f_2 / omega2 - q_0 + q_1;  // by omega2
  const Scalar c_0 = -Scalar(5.0) / (Scalar(3.0) * omega1_3);  // multiplies a1^2
  // multiplies a2^2
  const Scalar c_1 = (-Scalar(8.0) * omega1_2 + Scalar(3.0) * omega2_2) * per_0 * per_1 / (omega1 * omega2_2);
  const Scalar c_2 = Scalar(3.0) / (Scalar(2.0) * omega1);  // multiplies b1
  gradient[2] = Scalar(2.0) * a1 * c_0;  // by a1
  gradient[3] = Scalar(2.0) * a2 * c_1;  // by a2
  gradient[6] = c_2;  // by b1
  return value;
}

/// conservative_x_A_y2_conjA_y = (9*omega2^2*b4 - 10*a3*a4)/(6*omega1*omega2^2) + (-3*omega1^2*a2*a3 +
/// 8*omega2^2*a2*a3)/(omega1^3*(omega1 + 2*omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 36 operations.
template <class Scalar>
Scalar lump_3(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = Scalar(3.0) * b4 / (Scalar(2.0) * omega1);
  const Scalar f_1 = -Scalar(5.0) * a3 * a4 / (Scalar(3.0) * omega1 * omega2_2);
  const Scalar f_2 = -Scalar(3.0) * a2 * a3 * per_0 * per_1 / omega1;
  const Scalar f_3 = Scalar(8.0) * omega2_2 * a2 * a3 * per_0 * per_1 / omega1_3;
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_2 + f_3) * per_0;
  const Scalar q_1 = (f_2 + f_3) * per_1;
  gradient[0] = (-f_0 - f_1 - f_2 - Scalar(3.0) * f_3) / omega1 - q_0 - q_1;  // by omega1
  // by omega2
  gradient[1] = (-Scalar(2.0) * f_1 + Scalar(2.0) * f_3) / omega2 - Scalar(2.0) * q_0 + Scalar(2.0) * q_1;
  // multiplies a2*a3
  const Scalar c_0 = (-Scalar(3.0) * omega1_2 + Scalar(8.0) * omega2_2) * per_0 * per_1 / omega1_3;
  const Scalar c_1 = -Scalar(5.0) / (Scalar(3.0) * omega1 * omega2_2);  // multiplies a3*a4
  const Scalar c_2 = Scalar(3.0) / (Scalar(2.0) * omega1);  // multiplies b4
  gradient[3] = a3 * c_0;  // by a2
  gradient[4] = a2 * c_0 + a4 * c_1;  // by a3
  gradient[5] = a3 * c_1;  // by a4
  gradient[9] = c_2;  // by b4
  return value;
}

/// conservative_x_A_x_A_y_conjA_x = 3*b2/omega1 + (-2*omega1^2*a2*a3 +
/// 12*omega2^2*a2*a3)/(omega1*omega2^2*(omega1 + 2*omega2)*(omega1 - 2*omega2)) + (-12*omega1^2*a1*a2 +
/// 2*omega2^2*a1*a2)/(omega1^3*(2*omega1 + omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 50 operations.
template <class Scalar>
Scalar lump_4(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar b2 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = Scalar(3.0) * b2 / omega1;
  const Scalar f_1 = -Scalar(2.0) * omega1 * a2 * a3 * per_0 * per_1 / omega2_2;
  const Scalar f_2 = Scalar(12.0) * a2 * a3 * per_0 * per_1 / omega1;
  const Scalar f_3 = -Scalar(12.0) * a1 * a2 * per_2 * per_3 / omega1;
  const Scalar f_4 = Scalar(2.0) * omega2_2 * a1 * a2 * per_2 * per_3 / omega1_3;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_1 + f_2) * per_0;
  const Scalar q_1 = (f_1 + f_2) * per_1;
  const Scalar q_2 = (f_3 + f_4) * per_2;
  const Scalar q_3 = (f_3 + f_4) * per_3;
  // by omega1
  gradient[0] = (-f_0 + f_1 - f_2 - f_3 - Scalar(3.0) * f_4) / omega1 - q_0 - q_1 - Scalar(2.0) * q_2
      - Scalar(2.0) * q_3;
  // by omega2
  gradient[1] = (-Scalar(2.0) * f_1 + Scalar(2.0) * f_4) / omega2 - Scalar(2.0) * q_0 + Scalar(2.0) * q_1 - q_2
      + q_3;
  // multiplies a1*a2
  const Scalar c_0 = (-Scalar(12.0) * omega1_2 + Scalar(2.0) * omega2_2) * per_2 * per_3 / omega1_3;
  // multiplies a2*a3
  const Scalar c_1 = (-Scalar(2.0) * omega1_2 + Scalar(12.0) * omega2_2) * per_0 * per_1 / (omega1 * omega2_2);
  const Scalar c_2 = Scalar(3.0) / omega1;  // multiplies b2
  gradient[2] = a2 * c_0;  // by a1
  gradient[3] = a1 * c_0 + a3 * c_1;  // by a2
  gradient[4] = a2 * c_1;  // by a3
  gradient[7] = c_2;  // by b2
  return value;
}

/// conservative_x_A_y2_conjA_x = (3*omega2^2*b3 + 2*a2*a4)/(6*omega1*omega2^2) + 2*a3^2/(omega1^2*(omega1 -
/// 2*omega2)) - 2*a2^2/(omega1*omega2*(2*omega1 - omega2)) - a1*a3/(omega1*(omega1 + 2*omega2)*(omega1 -
/// 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 41 operations.
template <class Scalar>
Scalar lump_5(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar per_0 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar f_0 = b3 / (Scalar(2.0) * omega1);
  const Scalar f_1 = a2 * a4 / (Scalar(3.0) * omega1 * omega2_2);
  const Scalar f_2 = Scalar(2.0) * a3_2 * per_0 / omega1_2;
  const Scalar f_3 = -Scalar(2.0) * a2_2 * per_1 / (omega1 * omega2);
  const Scalar f_4 = -a1 * a3 * per_2 * per_0 / omega1;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_2 + f_4) * per_0;
  const Scalar q_1 = f_3 * per_1;
  const Scalar q_2 = f_4 * per_2;
  gradient[0] = (-f_0 - f_1 - Scalar(2.0) * f_2 - f_3 - f_4) / omega1 - q_0 - Scalar(2.0) * q_1 - q_2;  // by omega1
  gradient[1] = (-Scalar(2.0) * f_1 - f_3) / omega2 + Scalar(2.0) * q_0 + q_1 - Scalar(2.0) * q_2;  // by omega2
  const Scalar c_0 = -per_2 * per_0 / omega1;  // multiplies a1*a3
  const Scalar c_1 = -Scalar(2.0) * per_1 / (omega1 * omega2);  // multiplies a2^2
  const Scalar c_2 = Scalar(1.0) / (Scalar(3.0) * omega1 * omega2_2);  // multiplies a2*a4
  const Scalar c_3 = Scalar(2.0) * per_0 / omega1_2;  // multiplies a3^2
  const Scalar c_4 = Scalar(1.0) / (Scalar(2.0) * omega1);  // multiplies b3
  gradient[2] = a3 * c_0;  // by a1
  gradient[3] = Scalar(2.0) * a2 * c_1 + a4 * c_2;  // by a2
  gradient[4] = a1 * c_0 + Scalar(2.0) * a3 * c_3;  // by a3
  gradient[5] = a2 * c_2;  // by a4
  gradient[8] = c_4;  // by b3
  return value;
}

/// conservative_y_A_x2_conjA_y = (3*omega1^2*b3 + 2*a1*a3)/(6*omega1^2*omega2) + 2*a3^2/(omega1*omega2*(omega1 -
/// 2*omega2)) - 2*a2^2/(omega2^2*(2*omega1 - omega2)) + a2*a4/(omega2*(2*omega1 + omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 41 operations.
template <class Scalar>
Scalar lump_6(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar per_0 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar f_0 = b3 / (Scalar(2.0) * omega2);
  const Scalar f_1 = a1 * a3 / (Scalar(3.0) * omega1_2 * omega2);
  const Scalar f_2 = Scalar(2.0) * a3_2 * per_0 / (omega1 * omega2);
  const Scalar f_3 = -Scalar(2.0) * a2_2 * per_1 / omega2_2;
  const Scalar f_4 = a2 * a4 * per_2 * per_1 / omega2;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_2 * per_0;
  const Scalar q_1 = (f_3 + f_4) * per_1;
  const Scalar q_2 = f_4 * per_2;
  gradient[0] = (-Scalar(2.0) * f_1 - f_2) / omega1 - q_0 - Scalar(2.0) * q_1 - Scalar(2.0) * q_2;  // by omega1
  gradient[1] = (-f_0 - f_1 - f_2 - Scalar(2.0) * f_3 - f_4) / omega2 + Scalar(2.0) * q_0 + q_1 - q_2;  // by omega2
  const Scalar c_0 = Scalar(1.0) / (Scalar(3.0) * omega1_2 * omega2);  // multiplies a1*a3
  const Scalar c_1 = -Scalar(2.0) * per_1 / omega2_2;  // multiplies a2^2
  const Scalar c_2 = per_2 * per_1 / omega2;  // multiplies a2*a4
  const Scalar c_3 = Scalar(2.0) * per_0 / (omega1 * omega2);  // multiplies a3^2
  const Scalar c_4 = Scalar(1.0) / (Scalar(2.0) * omega2);  // multiplies b3
  gradient[2] = a3 * c_0;  // by a1
  gradient[3] = Scalar(2.0) * a2 * c_1 + a4 * c_2;  // by a2
  gradient[4] = a1 * c_0 + Scalar(2.0) * a3 * c_3;  // by a3
  gradient[5] = a2 * c_2;  // by a4
  gradient[8] = c_4;  // by b3
  return value;
}

/// conservative_y_A_x_A_y_conjA_y = 3*b4/omega2 + (-2*omega1^2*a3*a4 + 12*omega2^2*a3*a4)/(omega2^3*(omega1 +
/// 2*omega2)*(omega1 - 2*omega2)) + (-12*omega1^2*a2*a3 + 2*omega2^2*a2*a3)/(omega1^2*omega2*(2*omega1 +
/// omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 50 operations.
template <class Scalar>
Scalar lump_7(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = Scalar(3.0) * b4 / omega2;
  const Scalar f_1 = -Scalar(2.0) * omega1_2 * a3 * a4 * per_0 * per_1 / omega2_3;
  const Scalar f_2 = Scalar(12.0) * a3 * a4 * per_0 * per_1 / omega2;
  const Scalar f_3 = -Scalar(12.0) * a2 * a3 * per_2 * per_3 / omega2;
  const Scalar f_4 = Scalar(2.0) * omega2 * a2 * a3 * per_2 * per_3 / omega1_2;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_1 + f_2) * per_0;
  const Scalar q_1 = (f_1 + f_2) * per_1;
  const Scalar q_2 = (f_3 + f_4) * per_2;
  const Scalar q_3 = (f_3 + f_4) * per_3;
  // by omega1
  gradient[0] = (Scalar(2.0) * f_1 - Scalar(2.0) * f_4) / omega1 - q_0 - q_1 - Scalar(2.0) * q_2
      - Scalar(2.0) * q_3;
  // by omega2
  gradient[1] = (-f_0 - Scalar(3.0) * f_1 - f_2 - f_3 + f_4) / omega2 - Scalar(2.0) * q_0 + Scalar(2.0) * q_1 - q_2
      + q_3;
  // multiplies a2*a3
  const Scalar c_0 = (-Scalar(12.0) * omega1_2 + Scalar(2.0) * omega2_2) * per_2 * per_3 / (omega1_2 * omega2);
  // multiplies a3*a4
  const Scalar c_1 = (-Scalar(2.0) * omega1_2 + Scalar(12.0) * omega2_2) * per_0 * per_1 / omega2_3;
  const Scalar c_2 = Scalar(3.0) / omega2;  // multiplies b4
  gradient[3] = a3 * c_0;  // by a2
  gradient[4] = a2 * c_0 + a4 * c_1;  // by a3
  gradient[5] = a3 * c_1;  // by a4
  gradient[9] = c_2;  // by b4
  return value;
}

/// conservative_y_A_x2_conjA_x = (9*omega1^2*b2 - 10*a1*a2)/(6*omega1^2*omega2) + (-8*omega1^2*a2*a3 +
/// 3*omega2^2*a2*a3)/(omega2^3*(2*omega1 + omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 36 operations.
template <class Scalar>
Scalar lump_8(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar b2 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = Scalar(3.0) * b2 / (Scalar(2.0) * omega2);
  const Scalar f_1 = -Scalar(5.0) * a1 * a2 / (Scalar(3.0) * omega1_2 * omega2);
  const Scalar f_2 = -Scalar(8.0) * omega1_2 * a2 * a3 * per_0 * per_1 / omega2_3;
  const Scalar f_3 = Scalar(3.0) * a2 * a3 * per_0 * per_1 / omega2;
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_2 + f_3) * per_0;
  const Scalar q_1 = (f_2 + f_3) * per_1;
  // by omega1
  gradient[0] = (-Scalar(2.0) * f_1 + Scalar(2.0) * f_2) / omega1 - Scalar(2.0) * q_0 - Scalar(2.0) * q_1;
  gradient[1] = (-f_0 - f_1 - Scalar(3.0) * f_2 - f_3) / omega2 - q_0 + q_1;  // by omega2
  const Scalar c_0 = -Scalar(5.0) / (Scalar(3.0) * omega1_2 * omega2);  // multiplies a1*a2
  // multiplies a2*a3
  const Scalar c_1 = (-Scalar(8.0) * omega1_2 + Scalar(3.0) * omega2_2) * per_0 * per_1 / omega2_3;
  const Scalar c_2 = Scalar(3.0) / (Scalar(2.0) * omega2);  // multiplies b2
  gradient[2] = a2 * c_0;  // by a1
  gradient[3] = a1 * c_0 + a3 * c_1;  // by a2
  gradient[4] = a2 * c_1;  // by a3
  gradient[7] = c_2;  // by b2
  return value;
}

/// conservative_y_A_y2_conjA_y = (9*omega2^2*b5 - 10*a4^2)/(6*omega2^3) + (-3*omega1^2*a3^2 +
/// 8*omega2^2*a3^2)/(omega1^2*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 34 operations.
template <class Scalar>
Scalar lump_9(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b5 = parameters[10];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar a3_2 = a3 * a3;
  const Scalar a4_2 = a4 * a4;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = Scalar(3.0) * b5 / (Scalar(2.0) * omega2);
  const Scalar f_1 = -Scalar(5.0) * a4_2 / (Scalar(3.0) * omega2_3);
  const Scalar f_2 = -Scalar(3.0) * a3_2 * per_0 * per_1 / omega2;
  const Scalar f_3 = Scalar(8.0) * omega2 * a3_2 * per_0 * per_1 / omega1_2;
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_2 + f_3) * per_0;
  const Scalar q_1 = (f_2 + f_3) * per_1;
  gradient[0] = -Scalar(2.0) * f_3 / omega1 - q_0 - q_1;  // by omega1
  // by omega2
  gradient[1] = (-f_0 - Scalar(3.0) * f_1 - f_2 + f_3) / omega2 - Scalar(2.0) * q_0 + Scalar(2.0) * q_1;
  // multiplies a3^2
  const Scalar c_0 = (-Scalar(3.0) * omega1_2 + Scalar(8.0) * omega2_2) * per_0 * per_1 / (omega1_2 * omega2);
  const Scalar c_1 = -Scalar(5.0) / (Scalar(3.0) * omega2_3);  // multiplies a4^2
  const Scalar c_2 = Scalar(3.0) / (Scalar(2.0) * omega2);  // multiplies b5
  gradient[4] = Scalar(2.0) * a3 * c_0;  // by a3
  gradient[5] = Scalar(2.0) * a4 * c_1;  // by a4
  gradient[10] = c_2;  // by b5
  return value;
}

/// conservative_y_A_y2_conjA_x = (9*omega2^2*b4 + 2*a3*a4)/(6*omega2^3) + 2*a3*a4/(omega1*omega2*(omega1 -
/// 2*omega2)) - 2*a2*a3/(omega2^2*(2*omega1 - omega2)) - a2*a3/(omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 42 operations.
template <class Scalar>
Scalar lump_10(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar f_0 = Scalar(3.0) * b4 / (Scalar(2.0) * omega2);
  const Scalar f_1 = a3 * a4 / (Scalar(3.0) * omega2_3);
  const Scalar f_2 = Scalar(2.0) * a3 * a4 * per_0 / (omega1 * omega2);
  const Scalar f_3 = -Scalar(2.0) * a2 * a3 * per_1 / omega2_2;
  const Scalar f_4 = -a2 * a3 * per_2 * per_0 / omega2;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_2 + f_4) * per_0;
  const Scalar q_1 = f_3 * per_1;
  const Scalar q_2 = f_4 * per_2;
  gradient[0] = -f_2 / omega1 - q_0 - Scalar(2.0) * q_1 - q_2;  // by omega1
  // by omega2
  gradient[1] = (-f_0 - Scalar(3.0) * f_1 - f_2 - Scalar(2.0) * f_3 - f_4) / omega2 + Scalar(2.0) * q_0 + q_1
      - Scalar(2.0) * q_2;
  const Scalar c_0 = -Scalar(2.0) * per_1 / omega2_2 - per_2 * per_0 / omega2;  // multiplies a2*a3
  // multiplies a3*a4
  const Scalar c_1 = Scalar(1.0) / (Scalar(3.0) * omega2_3) + Scalar(2.0) * per_0 / (omega1 * omega2);
  const Scalar c_2 = Scalar(3.0) / (Scalar(2.0) * omega2);  // multiplies b4
  gradient[3] = a3 * c_0;  // by a2
  gradient[4] = a2 * c_0 + a4 * c_1;  // by a3
  gradient[5] = a3 * c_1;  // by a4
  gradient[9] = c_2;  // by b4
  return value;
}

/// harmonic_re_x_A_y3 = (-3*omega2^2*b4 - 2*a3*a4)/(3*omega2^2*(omega1 + 3*omega2)*(omega1 - 3*omega2)) +
/// 2*a2*a3/((omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 36 operations.
template <class Scalar>
Scalar lump_11(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(3.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(3.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = -b4 * per_0 * per_1;
  const Scalar f_1 = -Scalar(2.0) * a3 * a4 * per_0 * per_1 / (Scalar(3.0) * omega2_2);
  const Scalar f_2 = Scalar(2.0) * a2 * a3 * per_2 * per_0 * per_3 * per_1;
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2) * per_1;
  const Scalar q_2 = f_2 * per_2;
  const Scalar q_3 = f_2 * per_3;
  gradient[0] = -q_0 - q_1 - q_2 - q_3;  // by omega1
  // by omega2
  gradient[1] = -Scalar(2.0) * f_1 / omega2 - Scalar(3.0) * q_0 + Scalar(3.0) * q_1 - Scalar(2.0) * q_2
      + Scalar(2.0) * q_3;
  const Scalar c_0 = Scalar(2.0) * per_2 * per_0 * per_3 * per_1;  // multiplies a2*a3
  const Scalar c_1 = -Scalar(2.0) * per_0 * per_1 / (Scalar(3.0) * omega2_2);  // multiplies a3*a4
  const Scalar c_2 = -per_0 * per_1;  // multiplies b4
  gradient[3] = a3 * c_0;  // by a2
  gradient[4] = a2 * c_0 + a4 * c_1;  // by a3
  gradient[5] = a3 * c_1;  // by a4
  gradient[9] = c_2;  // by b4
  return value;
}

/// harmonic_re_x_A_x_A_y2 = (3*omega2^2*b3 + 2*a2*a4)/(12*omega2^3*(omega1 + omega2)) +
/// a3^2/(omega1*omega2*(omega1 + omega2)*(omega1 + 2*omega2)) + a2^2/(omega2^2*(omega1 + omega2)*(2*omega1 +
/// omega2)) - a1*a3/(2*omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 51 operations.
template <class Scalar>
Scalar lump_12(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = b3 * per_0 / (Scalar(4.0) * omega2);
  const Scalar f_1 = a2 * a4 * per_0 / (Scalar(6.0) * omega2_3);
  const Scalar f_2 = a3_2 * per_0 * per_1 / (omega1 * omega2);
  const Scalar f_3 = a2_2 * per_0 * per_2 / omega2_2;
  const Scalar f_4 = -a1 * a3 * per_0 * per_1 * per_3 / (Scalar(2.0) * omega2);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_0;
  const Scalar q_1 = (f_2 + f_4) * per_1;
  const Scalar q_2 = f_3 * per_2;
  const Scalar q_3 = f_4 * per_3;
  gradient[0] = -f_2 / omega1 - q_0 - q_1 - Scalar(2.0) * q_2 - q_3;  // by omega1
  // by omega2
  gradient[1] = (-f_0 - Scalar(3.0) * f_1 - f_2 - Scalar(2.0) * f_3 - f_4) / omega2 - q_0 - Scalar(2.0) * q_1 - q_2
      + Scalar(2.0) * q_3;
  const Scalar c_0 = -per_0 * per_1 * per_3 / (Scalar(2.0) * omega2);  // multiplies a1*a3
  const Scalar c_1 = per_0 * per_2 / omega2_2;  // multiplies a2^2
  const Scalar c_2 = per_0 / (Scalar(6.0) * omega2_3);  // multiplies a2*a4
  const Scalar c_3 = per_0 * per_1 / (omega1 * omega2);  // multiplies a3^2
  const Scalar c_4 = per_0 / (Scalar(4.0) * omega2);  // multiplies b3
  gradient[2] = a3 * c_0;  // by a1
  gradient[3] = Scalar(2.0) * a2 * c_1 + a4 * c_2;  // by a2
  gradient[4] = a1 * c_0 + Scalar(2.0) * a3 * c_3;  // by a3
  gradient[5] = a2 * c_2;  // by a4
  gradient[8] = c_4;  // by b3
  return value;
}

/// harmonic_re_x_A_x2_A_y = 3*b2/((omega1 + omega2)*(3*omega1 + omega2)) + (12*omega1^2*a1*a2 +
/// 4*omega1*omega2*a1*a2 + 2*omega2^2*a1*a2)/(3*omega1^2*omega2*(omega1 + omega2)*(2*omega1 + omega2)*(3*omega1
/// + omega2)) + (18*omega1^2*a2*a3 + 4*omega1*omega2*a2*a3 - 4*omega2^2*a2*a3)/(omega1*(omega1 + omega2)*(omega1
/// + 2*omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 89 operations.
template <class Scalar>
Scalar lump_13(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar b2 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(3.0) * omega1 + omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_4 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = Scalar(3.0) * b2 * per_0 * per_1;
  const Scalar f_1 = Scalar(4.0) * a1 * a2 * per_0 * per_2 * per_1 / omega2;
  const Scalar f_2 = Scalar(4.0) * a1 * a2 * per_0 * per_2 * per_1 / (Scalar(3.0) * omega1);
  const Scalar f_3 = Scalar(2.0) * omega2 * a1 * a2 * per_0 * per_2 * per_1 / (Scalar(3.0) * omega1_2);
  const Scalar f_4 = Scalar(18.0) * omega1 * a2 * a3 * per_0 * per_3 * per_2 * per_4 * per_1;
  const Scalar f_5 = Scalar(4.0) * omega2 * a2 * a3 * per_0 * per_3 * per_2 * per_4 * per_1;
  const Scalar f_6 = -Scalar(4.0) * omega2_2 * a2 * a3 * per_0 * per_3 * per_2 * per_4 * per_1 / omega1;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_1;
  const Scalar q_2 = (f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_2;
  const Scalar q_3 = (f_4 + f_5 + f_6) * per_3;
  const Scalar q_4 = (f_4 + f_5 + f_6) * per_4;
  // by omega1
  gradient[0] = (-f_2 - Scalar(2.0) * f_3 + f_4 - f_6) / omega1 - q_0 - Scalar(3.0) * q_1 - Scalar(2.0) * q_2 - q_3
      - Scalar(2.0) * q_4;
  // by omega2
  gradient[1] = (-f_1 + f_3 + f_5 + Scalar(2.0) * f_6) / omega2 - q_0 - q_1 - q_2 - Scalar(2.0) * q_3 + q_4;
  // multiplies a1*a2
  const Scalar c_0 = (Scalar(12.0) * omega1_2 + Scalar(4.0) * omega1 * omega2
      + Scalar(2.0) * omega2_2) * per_0 * per_2 * per_1 / (Scalar(3.0) * omega1_2 * omega2);
  // multiplies a2*a3
  const Scalar c_1 = (Scalar(18.0) * omega1_2 + Scalar(4.0) * omega1 * omega2
      - Scalar(4.0) * omega2_2) * per_0 * per_3 * per_2 * per_4 * per_1 / omega1;
  const Scalar c_2 = Scalar(3.0) * per_0 * per_1;  // multiplies b2
  gradient[2] = a2 * c_0;  // by a1
  gradient[3] = a1 * c_0 + a3 * c_1;  // by a2
  gradient[4] = a2 * c_1;  // by a3
  gradient[7] = c_2;  // by b2
  return value;
}

/// harmonic_re_x_A_x3 = (3*omega1^2*b1 + 2*a1^2)/(24*omega1^4) + a2^2/(4*omega1^2*(2*omega1 + omega2)*(2*omega1
/// - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 24 operations.
template <class Scalar>
Scalar lump_14(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar b1 = parameters[6];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar a1_2 = a1 * a1;
  const Scalar a2_2 = a2 * a2;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = b1 / (Scalar(8.0) * omega1_2);
  const Scalar f_1 = a1_2 / (Scalar(12.0) * omega1_4);
  const Scalar f_2 = a2_2 * per_0 * per_1 / (Scalar(4.0) * omega1_2);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_2 * per_0;
  const Scalar q_1 = f_2 * per_1;
  // by omega1
  gradient[0] = (-Scalar(2.0) * f_0 - Scalar(4.0) * f_1 - Scalar(2.0) * f_2) / omega1 - Scalar(2.0) * q_0
      - Scalar(2.0) * q_1;
  gradient[1] = -q_0 + q_1;  // by omega2
  const Scalar c_0 = Scalar(1.0) / (Scalar(12.0) * omega1_4);  // multiplies a1^2
  const Scalar c_1 = per_0 * per_1 / (Scalar(4.0) * omega1_2);  // multiplies a2^2
  const Scalar c_2 = Scalar(1.0) / (Scalar(8.0) * omega1_2);  // multiplies b1
  gradient[2] = Scalar(2.0) * a1 * c_0;  // by a1
  gradient[3] = Scalar(2.0) * a2 * c_1;  // by a2
  gradient[6] = c_2;  // by b1
  return value;
}

/// harmonic_re_y_A_y3 = (3*omega2^2*b5 + 2*a4^2)/(24*omega2^4) - a3^2/(4*omega2^2*(omega1 + 2*omega2)*(omega1 -
/// 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 24 operations.
template <class Scalar>
Scalar lump_15(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b5 = parameters[10];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar a3_2 = a3 * a3;
  const Scalar a4_2 = a4 * a4;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = b5 / (Scalar(8.0) * omega2_2);
  const Scalar f_1 = a4_2 / (Scalar(12.0) * omega2_4);
  const Scalar f_2 = -a3_2 * per_0 * per_1 / (Scalar(4.0) * omega2_2);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_2 * per_0;
  const Scalar q_1 = f_2 * per_1;
  gradient[0] = -q_0 - q_1;  // by omega1
  // by omega2
  gradient[1] = (-Scalar(2.0) * f_0 - Scalar(4.0) * f_1 - Scalar(2.0) * f_2) / omega2 - Scalar(2.0) * q_0
      + Scalar(2.0) * q_1;
  const Scalar c_0 = -per_0 * per_1 / (Scalar(4.0) * omega2_2);  // multiplies a3^2
  const Scalar c_1 = Scalar(1.0) / (Scalar(12.0) * omega2_4);  // multiplies a4^2
  const Scalar c_2 = Scalar(1.0) / (Scalar(8.0) * omega2_2);  // multiplies b5
  gradient[4] = Scalar(2.0) * a3 * c_0;  // by a3
  gradient[5] = Scalar(2.0) * a4 * c_1;  // by a4
  gradient[10] = c_2;  // by b5
  return value;
}

/// harmonic_re_y_A_x_A_y2 = 3*b4/((omega1 + omega2)*(omega1 + 3*omega2)) + (2*omega1^2*a3*a4 +
/// 4*omega1*omega2*a3*a4 + 12*omega2^2*a3*a4)/(3*omega1*omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 +
/// 3*omega2)) + (4*omega1^2*a2*a3 - 4*omega1*omega2*a2*a3 - 18*omega2^2*a2*a3)/(omega2*(omega1 + omega2)*(omega1
/// + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(2*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 89 operations.
template <class Scalar>
Scalar lump_16(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(3.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_4 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar f_0 = Scalar(3.0) * b4 * per_0 * per_1;
  const Scalar f_1 = Scalar(2.0) * omega1 * a3 * a4 * per_0 * per_2 * per_1 / (Scalar(3.0) * omega2_2);
  const Scalar f_2 = Scalar(4.0) * a3 * a4 * per_0 * per_2 * per_1 / (Scalar(3.0) * omega2);
  const Scalar f_3 = Scalar(4.0) * a3 * a4 * per_0 * per_2 * per_1 / omega1;
  const Scalar f_4 = Scalar(4.0) * omega1_2 * a2 * a3 * per_0 * per_2 * per_1 * per_3 * per_4 / omega2;
  const Scalar f_5 = -Scalar(4.0) * omega1 * a2 * a3 * per_0 * per_2 * per_1 * per_3 * per_4;
  const Scalar f_6 = -Scalar(18.0) * omega2 * a2 * a3 * per_0 * per_2 * per_1 * per_3 * per_4;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_1;
  const Scalar q_2 = (f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_2;
  const Scalar q_3 = (f_4 + f_5 + f_6) * per_3;
  const Scalar q_4 = (f_4 + f_5 + f_6) * per_4;
  // by omega1
  gradient[0] = (f_1 - f_3 + Scalar(2.0) * f_4 + f_5) / omega1 - q_0 - q_1 - q_2 - q_3 - Scalar(2.0) * q_4;
  // by omega2
  gradient[1] = (-Scalar(2.0) * f_1 - f_2 - f_4 + f_6) / omega2 - q_0 - Scalar(3.0) * q_1 - Scalar(2.0) * q_2
      + Scalar(2.0) * q_3 - q_4;
  // multiplies a2*a3
  const Scalar c_0 = (Scalar(4.0) * omega1_2 - Scalar(4.0) * omega1 * omega2
      - Scalar(18.0) * omega2_2) * per_0 * per_2 * per_1 * per_3 * per_4 / omega2;
  // multiplies a3*a4
  const Scalar c_1 = (Scalar(2.0) * omega1_2 + Scalar(4.0) * omega1 * omega2
      + Scalar(12.0) * omega2_2) * per_0 * per_2 * per_1 / (Scalar(3.0) * omega1 * omega2_2);
  const Scalar c_2 = Scalar(3.0) * per_0 * per_1;  // multiplies b4
  gradient[3] = a3 * c_0;  // by a2
  gradient[4] = a2 * c_0 + a4 * c_1;  // by a3
  gradient[5] = a3 * c_1;  // by a4
  gradient[9] = c_2;  // by b4
  return value;
}

/// harmonic_re_y_A_x2_A_y = (3*omega1^2*b3 + 2*a1*a3)/(12*omega1^3*(omega1 + omega2)) + a3^2/(omega1^2*(omega1 +
/// omega2)*(omega1 + 2*omega2)) + a2^2/(omega1*omega2*(omega1 + omega2)*(2*omega1 + omega2)) +
/// a2*a4/(2*omega1*(omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 51 operations.
template <class Scalar>
Scalar lump_17(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = b3 * per_0 / (Scalar(4.0) * omega1);
  const Scalar f_1 = a1 * a3 * per_0 / (Scalar(6.0) * omega1_3);
  const Scalar f_2 = a3_2 * per_0 * per_1 / omega1_2;
  const Scalar f_3 = a2_2 * per_0 * per_2 / (omega1 * omega2);
  const Scalar f_4 = a2 * a4 * per_0 * per_2 * per_3 / (Scalar(2.0) * omega1);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_0;
  const Scalar q_1 = f_2 * per_1;
  const Scalar q_2 = (f_3 + f_4) * per_2;
  const Scalar q_3 = f_4 * per_3;
  // by omega1
  gradient[0] = (-f_0 - Scalar(3.0) * f_1 - Scalar(2.0) * f_2 - f_3 - f_4) / omega1 - q_0 - q_1 - Scalar(2.0) * q_2
      - Scalar(2.0) * q_3;
  gradient[1] = -f_3 / omega2 - q_0 - Scalar(2.0) * q_1 - q_2 + q_3;  // by omega2
  const Scalar c_0 = per_0 / (Scalar(6.0) * omega1_3);  // multiplies a1*a3
  const Scalar c_1 = per_0 * per_2 / (omega1 * omega2);  // multiplies a2^2
  const Scalar c_2 = per_0 * per_2 * per_3 / (Scalar(2.0) * omega1);  // multiplies a2*a4
  const Scalar c_3 = per_0 * per_1 / omega1_2;  // multiplies a3^2
  const Scalar c_4 = per_0 / (Scalar(4.0) * omega1);  // multiplies b3
  gradient[2] = a3 * c_0;  // by a1
  gradient[3] = Scalar(2.0) * a2 * c_1 + a4 * c_2;  // by a2
  gradient[4] = a1 * c_0 + Scalar(2.0) * a3 * c_3;  // by a3
  gradient[5] = a2 * c_2;  // by a4
  gradient[8] = c_4;  // by b3
  return value;
}

/// harmonic_re_y_A_x3 = (3*omega1^2*b2 + 2*a1*a2)/(3*omega1^2*(3*omega1 + omega2)*(3*omega1 - omega2)) +
/// 2*a2*a3/((2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2)*(3*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 36 operations.
template <class Scalar>
Scalar lump_18(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar b2 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar per_0 = Scalar(1.0) / (Scalar(3.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(3.0) * omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = b2 * per_0 * per_1;
  const Scalar f_1 = Scalar(2.0) * a1 * a2 * per_0 * per_1 / (Scalar(3.0) * omega1_2);
  const Scalar f_2 = Scalar(2.0) * a2 * a3 * per_2 * per_3 * per_0 * per_1;
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2) * per_1;
  const Scalar q_2 = f_2 * per_2;
  const Scalar q_3 = f_2 * per_3;
  // by omega1
  gradient[0] = -Scalar(2.0) * f_1 / omega1 - Scalar(3.0) * q_0 - Scalar(3.0) * q_1 - Scalar(2.0) * q_2
      - Scalar(2.0) * q_3;
  gradient[1] = -q_0 + q_1 - q_2 + q_3;  // by omega2
  const Scalar c_0 = Scalar(2.0) * per_0 * per_1 / (Scalar(3.0) * omega1_2);  // multiplies a1*a2
  const Scalar c_1 = Scalar(2.0) * per_2 * per_3 * per_0 * per_1;  // multiplies a2*a3
  const Scalar c_2 = per_0 * per_1;  // multiplies b2
  gradient[2] = a2 * c_0;  // by a1
  gradient[3] = a1 * c_0 + a3 * c_1;  // by a2
  gradient[4] = a2 * c_1;  // by a3
  gradient[7] = c_2;  // by b2
  return value;
}

/// conservative_x_A_x_A_y_conjA_y = (2*omega1^2*omega2^2*b3 - 4*omega1^2*a2*a4 - 4*omega2^2*a1*a3 +
/// omega2^2*a2^2)/(2*omega1^3*omega2^2) + 2*a2^2/(omega1*omega2*(2*omega1 + omega2)) + 4*a3^2/(omega1*(omega1 +
/// 2*omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 42 operations.
template <class Scalar>
Scalar lump_19(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = b3 / omega1;
  const Scalar f_1 = -Scalar(2.0) * a2 * a4 / (omega1 * omega2_2);
  const Scalar f_2 = (-Scalar(4.0) * a1 * a3 + a2_2) / (Scalar(2.0) * omega1_3);
  const Scalar f_3 = Scalar(2.0) * a2_2 * per_0 / (omega1 * omega2);
  const Scalar f_4 = Scalar(4.0) * a3_2 * per_1 * per_2 / omega1;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_3 * per_0;
  const Scalar q_1 = f_4 * per_1;
  const Scalar q_2 = f_4 * per_2;
  gradient[0] = (-f_0 - f_1 - Scalar(3.0) * f_2 - f_3 - f_4) / omega1 - Scalar(2.0) * q_0 - q_1 - q_2;  // by omega1
  gradient[1] = (-Scalar(2.0) * f_1 - f_3) / omega2 - q_0 - Scalar(2.0) * q_1 + Scalar(2.0) * q_2;  // by omega2
  const Scalar c_0 = -Scalar(2.0) / omega1_3;  // multiplies a1*a3
  // multiplies a2^2
  const Scalar c_1 = Scalar(1.0) / (Scalar(2.0) * omega1_3) + Scalar(2.0) * per_0 / (omega1 * omega2);
  const Scalar c_2 = -Scalar(2.0) / (omega1 * omega2_2);  // multiplies a2*a4
  const Scalar c_3 = Scalar(4.0) * per_1 * per_2 / omega1;  // multiplies a3^2
  const Scalar c_4 = Scalar(1.0) / omega1;  // multiplies b3
  gradient[2] = a3 * c_0;  // by a1
  gradient[3] = Scalar(2.0) * a2 * c_1 + a4 * c_2;  // by a2
  gradient[4] = a1 * c_0 + Scalar(2.0) * a3 * c_3;  // by a3
  gradient[5] = a2 * c_2;  // by a4
  gradient[8] = c_4;  // by b3
  return value;
}

/// conservative_x_conjA_x_F = a2*e2/(8*omega1^2*omega2) + a1*e1/(2*omega1*(omega1 + omega2)*(omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 20 operations.
template <class Scalar>
Scalar lump_20(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar e1 = parameters[12];
  const Scalar e2 = parameters[14];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = a2 * e2 / (Scalar(8.0) * omega1_2 * omega2);
  const Scalar f_1 = a1 * e1 * per_0 * per_1 / (Scalar(2.0) * omega1);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_1 * per_0;
  const Scalar q_1 = f_1 * per_1;
  gradient[0] = (-Scalar(2.0) * f_0 - f_1) / omega1 - q_0 - q_1;  // by omega1
  gradient[1] = -f_0 / omega2 - q_0 + q_1;  // by omega2
  const Scalar c_0 = per_0 * per_1 / (Scalar(2.0) * omega1);  // multiplies a1*e1
  const Scalar c_1 = Scalar(1.0) / (Scalar(8.0) * omega1_2 * omega2);  // multiplies a2*e2
  gradient[2] = e1 * c_0;  // by a1
  gradient[3] = e2 * c_1;  // by a2
  gradient[12] = a1 * c_0;  // by e1
  gradient[14] = a2 * c_1;  // by e2
  return value;
}

/// conservative_y_A_x_A_y_conjA_x = (omega1^2*omega2^2*b3 - 2*omega1^2*a2*a4 -
/// 2*omega2^2*a1*a3)/(omega1^2*omega2^3) + (2*omega1*a2^2 - omega2*a2^2)/(2*omega1*omega2^2*(2*omega1 + omega2))
/// + 4*a3^2/(omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 42 operations.
template <class Scalar>
Scalar lump_21(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = b3 / omega2;
  const Scalar f_1 = -Scalar(2.0) * a2 * a4 / omega2_3;
  const Scalar f_2 = -Scalar(2.0) * a1 * a3 / (omega1_2 * omega2);
  const Scalar f_3 = a2_2 * per_0 / omega2_2;
  const Scalar f_4 = -a2_2 * per_0 / (Scalar(2.0) * omega1 * omega2);
  const Scalar f_5 = Scalar(4.0) * a3_2 * per_1 * per_2 / omega2;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_3 + f_4) * per_0;
  const Scalar q_1 = f_5 * per_1;
  const Scalar q_2 = f_5 * per_2;
  gradient[0] = (-Scalar(2.0) * f_2 - f_4) / omega1 - Scalar(2.0) * q_0 - q_1 - q_2;  // by omega1
  // by omega2
  gradient[1] = (-f_0 - Scalar(3.0) * f_1 - f_2 - Scalar(2.0) * f_3 - f_4 - f_5) / omega2 - q_0 - Scalar(2.0) * q_1
      + Scalar(2.0) * q_2;
  const Scalar c_0 = -Scalar(2.0) / (omega1_2 * omega2);  // multiplies a1*a3
  // multiplies a2^2
  const Scalar c_1 = (Scalar(2.0) * omega1 - omega2) * per_0 / (Scalar(2.0) * omega1 * omega2_2);
  const Scalar c_2 = -Scalar(2.0) / omega2_3;  // multiplies a2*a4
  const Scalar c_3 = Scalar(4.0) * per_1 * per_2 / omega2;  // multiplies a3^2
  const Scalar c_4 = Scalar(1.0) / omega2;  // multiplies b3
  gradient[2] = a3 * c_0;  // by a1
  gradient[3] = Scalar(2.0) * a2 * c_1 + a4 * c_2;  // by a2
  gradient[4] = a1 * c_0 + Scalar(2.0) * a3 * c_3;  // by a3
  gradient[5] = a2 * c_2;  // by a4
  gradient[8] = c_4;  // by b3
  return value;
}

/// harmonic_re_x_A_y_conjA_x2 = (9*omega1^2*b2 + 2*a1*a2)/(3*omega1^2*(omega1 - omega2)*(3*omega1 - omega2)) +
/// 4*a2*a3/(omega1*(omega1 - omega2)*(omega1 - 2*omega2)*(3*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 33 operations.
template <class Scalar>
Scalar lump_22(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar b2 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(3.0) * omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = Scalar(3.0) * b2 * per_0 * per_1;
  const Scalar f_1 = Scalar(2.0) * a1 * a2 * per_0 * per_1 / (Scalar(3.0) * omega1_2);
  const Scalar f_2 = Scalar(4.0) * a2 * a3 * per_0 * per_2 * per_1 / omega1;
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2) * per_1;
  const Scalar q_2 = f_2 * per_2;
  gradient[0] = (-Scalar(2.0) * f_1 - f_2) / omega1 - q_0 - Scalar(3.0) * q_1 - q_2;  // by omega1
  gradient[1] = q_0 + q_1 + Scalar(2.0) * q_2;  // by omega2
  const Scalar c_0 = Scalar(2.0) * per_0 * per_1 / (Scalar(3.0) * omega1_2);  // multiplies a1*a2
  const Scalar c_1 = Scalar(4.0) * per_0 * per_2 * per_1 / omega1;  // multiplies a2*a3
  const Scalar c_2 = Scalar(3.0) * per_0 * per_1;  // multiplies b2
  gradient[2] = a2 * c_0;  // by a1
  gradient[3] = a1 * c_0 + a3 * c_1;  // by a2
  gradient[4] = a2 * c_1;  // by a3
  gradient[7] = c_2;  // by b2
  return value;
}

/// harmonic_re_x_conjA_y_F = -a2*e1/(omega1^2*(omega1 + omega2)*(omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 11 operations.
template <class Scalar>
Scalar lump_23(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar e1 = parameters[12];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -a2 * e1 * per_0 * per_1 / omega1_2;
  const Scalar value = f_0;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_0 * per_0;
  const Scalar q_1 = f_0 * per_1;
  gradient[0] = -Scalar(2.0) * f_0 / omega1 - q_0 - q_1;  // by omega1
  gradient[1] = -q_0 + q_1;  // by omega2
  const Scalar c_0 = -per_0 * per_1 / omega1_2;  // multiplies a2*e1
  gradient[3] = e1 * c_0;  // by a2
  gradient[12] = a2 * c_0;  // by e1
  return value;
}

/// harmonic_im_x_F = -omega2*mu1*e1/((omega1 + omega2)^2*(omega1 - omega2)^2)
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 10 operations.
template <class Scalar>
Scalar lump_24(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu1 = parameters[11];
  const Scalar e1 = parameters[12];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1_2 = per_1 * per_1;
  const Scalar f_0 = -omega2 * mu1 * e1 * per_0_2 * per_1_2;
  const Scalar value = f_0;
  if (gradient == nullptr) return value;
  const Scalar q_0 = Scalar(2.0) * f_0 * per_0;
  const Scalar q_1 = Scalar(2.0) * f_0 * per_1;
  gradient[0] = -q_0 - q_1;  // by omega1
  gradient[1] = f_0 / omega2 - q_0 + q_1;  // by omega2
  const Scalar c_0 = -omega2 * per_0_2 * per_1_2;  // multiplies mu1*e1
  gradient[11] = e1 * c_0;  // by mu1
  gradient[12] = mu1 * c_0;  // by e1
  return value;
}

/// harmonic_re_x_A_y2_conjA_y = (-9*omega2^2*b4 + 10*a3*a4)/(3*omega2^2*(omega1 + omega2)*(omega1 - omega2)) +
/// (6*omega1^2*a2*a3 - 16*omega2^2*a2*a3)/(omega1^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 -
/// omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 47 operations.
template <class Scalar>
Scalar lump_25(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = -Scalar(3.0) * b4 * per_0 * per_1;
  const Scalar f_1 = Scalar(10.0) * a3 * a4 * per_0 * per_1 / (Scalar(3.0) * omega2_2);
  const Scalar f_2 = Scalar(6.0) * a2 * a3 * per_0 * per_2 * per_1 * per_3;
  const Scalar f_3 = -Scalar(16.0) * omega2_2 * a2 * a3 * per_0 * per_2 * per_1 * per_3 / omega1_2;
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3) * per_1;
  const Scalar q_2 = (f_2 + f_3) * per_2;
  const Scalar q_3 = (f_2 + f_3) * per_3;
  gradient[0] = -Scalar(2.0) * f_3 / omega1 - q_0 - q_1 - q_2 - q_3;  // by omega1
  // by omega2
  gradient[1] = (-Scalar(2.0) * f_1 + Scalar(2.0) * f_3) / omega2 - q_0 + q_1 - Scalar(2.0) * q_2
      + Scalar(2.0) * q_3;
  // multiplies a2*a3
  const Scalar c_0 = (Scalar(6.0) * omega1_2 - Scalar(16.0) * omega2_2) * per_0 * per_2 * per_1 * per_3 / omega1_2;
  const Scalar c_1 = Scalar(10.0) * per_0 * per_1 / (Scalar(3.0) * omega2_2);  // multiplies a3*a4
  const Scalar c_2 = -Scalar(3.0) * per_0 * per_1;  // multiplies b4
  gradient[3] = a3 * c_0;  // by a2
  gradient[4] = a2 * c_0 + a4 * c_1;  // by a3
  gradient[5] = a3 * c_1;  // by a4
  gradient[9] = c_2;  // by b4
  return value;
}

/// harmonic_re_x_A_x_A_y_conjA_x = -6*b2/((omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^2*a1*a2 +
/// 8*omega1*omega2*a1*a2 + 4*omega2^2*a1*a2)/(omega1^2*omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 +
/// omega2)) + (4*omega1^2*a2*a3 - 24*omega2^2*a2*a3)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 -
/// omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 70 operations.
template <class Scalar>
Scalar lump_26(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar b2 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_4 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = -Scalar(6.0) * b2 * per_0 * per_1;
  const Scalar f_1 = -Scalar(4.0) * a1 * a2 * per_0 * per_1 * per_2 / omega2;
  const Scalar f_2 = Scalar(8.0) * a1 * a2 * per_0 * per_1 * per_2 / omega1;
  const Scalar f_3 = Scalar(4.0) * omega2 * a1 * a2 * per_0 * per_1 * per_2 / omega1_2;
  const Scalar f_4 = Scalar(4.0) * omega1_2 * a2 * a3 * per_0 * per_3 * per_1 * per_4 / omega2_2;
  const Scalar f_5 = -Scalar(24.0) * a2 * a3 * per_0 * per_3 * per_1 * per_4;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_1;
  const Scalar q_2 = (f_1 + f_2 + f_3) * per_2;
  const Scalar q_3 = (f_4 + f_5) * per_3;
  const Scalar q_4 = (f_4 + f_5) * per_4;
  // by omega1
  gradient[0] = (-f_2 - Scalar(2.0) * f_3 + Scalar(2.0) * f_4) / omega1 - q_0 - q_1 - Scalar(2.0) * q_2 - q_3 - q_4;
  // by omega2
  gradient[1] = (-f_1 + f_3 - Scalar(2.0) * f_4) / omega2 - q_0 + q_1 - q_2 - Scalar(2.0) * q_3 + Scalar(2.0) * q_4;
  // multiplies a1*a2
  const Scalar c_0 = (-Scalar(4.0) * omega1_2 + Scalar(8.0) * omega1 * omega2
      + Scalar(4.0) * omega2_2) * per_0 * per_1 * per_2 / (omega1_2 * omega2);
  // multiplies a2*a3
  const Scalar c_1 = (Scalar(4.0) * omega1_2 - Scalar(24.0) * omega2_2) * per_0 * per_3 * per_1 * per_4 / omega2_2;
  const Scalar c_2 = -Scalar(6.0) * per_0 * per_1;  // multiplies b2
  gradient[2] = a2 * c_0;  // by a1
  gradient[3] = a1 * c_0 + a3 * c_1;  // by a2
  gradient[4] = a2 * c_1;  // by a3
  gradient[7] = c_2;  // by b2
  return value;
}

/// harmonic_re_x_A_x2_A_y = -4*a2*a3/((omega1 + 2*omega2)^2*(omega1 - 2*omega2)^2)
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 12 operations.
template <class Scalar>
Scalar lump_27(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_1_2 = per_1 * per_1;
  const Scalar f_0 = -Scalar(4.0) * a2 * a3 * per_0_2 * per_1_2;
  const Scalar value = f_0;
  if (gradient == nullptr) return value;
  const Scalar q_0 = Scalar(2.0) * f_0 * per_0;
  const Scalar q_1 = Scalar(2.0) * f_0 * per_1;
  gradient[0] = -q_0 - q_1;  // by omega1
  gradient[1] = -Scalar(2.0) * q_0 + Scalar(2.0) * q_1;  // by omega2
  const Scalar c_0 = -Scalar(4.0) * per_0_2 * per_1_2;  // multiplies a2*a3
  gradient[3] = a3 * c_0;  // by a2
  gradient[4] = a2 * c_0;  // by a3
  return value;
}

/// harmonic_im_x_A_y2 = (4*omega2*a3*mu1 - 8*omega2*a3*mu2)/((omega1 + 2*omega2)^2*(omega1 - 2*omega2)^2)
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 21 operations.
template <class Scalar>
Scalar lump_28(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a3 = parameters[4];
  const Scalar mu1 = parameters[11];
  const Scalar mu2 = parameters[13];
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_1_2 = per_1 * per_1;
  const Scalar f_0 = (Scalar(4.0) * omega2 * a3 * mu1 - Scalar(8.0) * omega2 * a3 * mu2) * per_0_2 * per_1_2;
  const Scalar value = f_0;
  if (gradient == nullptr) return value;
  const Scalar q_0 = Scalar(2.0) * f_0 * per_0;
  const Scalar q_1 = Scalar(2.0) * f_0 * per_1;
  gradient[0] = -q_0 - q_1;  // by omega1
  gradient[1] = f_0 / omega2 - Scalar(2.0) * q_0 + Scalar(2.0) * q_1;  // by omega2
  const Scalar c_0 = Scalar(4.0) * omega2 * per_0_2 * per_1_2;  // multiplies a3*mu1
  const Scalar c_1 = -Scalar(8.0) * omega2 * per_0_2 * per_1_2;  // multiplies a3*mu2
  gradient[4] = mu1 * c_0 + mu2 * c_1;  // by a3
  gradient[11] = a3 * c_0;  // by mu1
  gradient[13] = a3 * c_1;  // by mu2
  return value;
}

/// harmonic_re_x_A_y_F = 2*a3*e2/((omega1 + 2*omega2)^2*(omega1 - 2*omega2)^2)
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 12 operations.
template <class Scalar>
Scalar lump_29(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a3 = parameters[4];
  const Scalar e2 = parameters[14];
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_1_2 = per_1 * per_1;
  const Scalar f_0 = Scalar(2.0) * a3 * e2 * per_0_2 * per_1_2;
  const Scalar value = f_0;
  if (gradient == nullptr) return value;
  const Scalar q_0 = Scalar(2.0) * f_0 * per_0;
  const Scalar q_1 = Scalar(2.0) * f_0 * per_1;
  gradient[0] = -q_0 - q_1;  // by omega1
  gradient[1] = -Scalar(2.0) * q_0 + Scalar(2.0) * q_1;  // by omega2
  const Scalar c_0 = Scalar(2.0) * per_0_2 * per_1_2;  // multiplies a3*e2
  gradient[4] = e2 * c_0;  // by a3
  gradient[14] = a3 * c_0;  // by e2
  return value;
}

/// harmonic_re_x_A_y2_conjA_x = (-3*omega2^2*b3 - 2*a2*a4)/(12*omega2^3*(omega1 - omega2)) -
/// a3^2/(omega1*omega2*(omega1 - omega2)*(omega1 - 2*omega2)) + a1*a3/(2*omega2*(omega1 + 2*omega2)*(omega1 -
/// omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 41 operations.
template <class Scalar>
Scalar lump_30(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar a3_2 = a3 * a3;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar f_0 = -b3 * per_0 / (Scalar(4.0) * omega2);
  const Scalar f_1 = -a2 * a4 * per_0 / (Scalar(6.0) * omega2_3);
  const Scalar f_2 = -a3_2 * per_0 * per_1 / (omega1 * omega2);
  const Scalar f_3 = a1 * a3 * per_2 * per_0 * per_1 / (Scalar(2.0) * omega2);
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = (f_2 + f_3) * per_1;
  const Scalar q_2 = f_3 * per_2;
  gradient[0] = -f_2 / omega1 - q_0 - q_1 - q_2;  // by omega1
  // by omega2
  gradient[1] = (-f_0 - Scalar(3.0) * f_1 - f_2 - f_3) / omega2 + q_0 + Scalar(2.0) * q_1 - Scalar(2.0) * q_2;
  const Scalar c_0 = per_2 * per_0 * per_1 / (Scalar(2.0) * omega2);  // multiplies a1*a3
  const Scalar c_1 = -per_0 / (Scalar(6.0) * omega2_3);  // multiplies a2*a4
  const Scalar c_2 = -per_0 * per_1 / (omega1 * omega2);  // multiplies a3^2
  const Scalar c_3 = -per_0 / (Scalar(4.0) * omega2);  // multiplies b3
  gradient[2] = a3 * c_0;  // by a1
  gradient[3] = a4 * c_1;  // by a2
  gradient[4] = a1 * c_0 + Scalar(2.0) * a3 * c_2;  // by a3
  gradient[5] = a2 * c_1;  // by a4
  gradient[8] = c_3;  // by b3
  return value;
}

/// harmonic_re_x_A_x_F = a1*e1/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 16 operations.
template <class Scalar>
Scalar lump_31(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar e1 = parameters[12];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar f_0 = a1 * e1 * per_0 * per_1 * per_2 / omega2;
  const Scalar value = f_0;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_0 * per_0;
  const Scalar q_1 = f_0 * per_1;
  const Scalar q_2 = f_0 * per_2;
  gradient[0] = -q_0 - q_1 - Scalar(2.0) * q_2;  // by omega1
  gradient[1] = -f_0 / omega2 - q_0 + q_1 - q_2;  // by omega2
  const Scalar c_0 = per_0 * per_1 * per_2 / omega2;  // multiplies a1*e1
  gradient[2] = e1 * c_0;  // by a1
  gradient[12] = a1 * c_0;  // by e1
  return value;
}

/// harmonic_re_x_A_x3 = (-2*omega1*a2^2 - 2*omega2*a2^2)/(omega2^3*(2*omega1 + omega2)^2)
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 16 operations.
template <class Scalar>
Scalar lump_32(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar a2_2 = a2 * a2;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar f_0 = -Scalar(2.0) * omega1 * a2_2 * per_0_2 / omega2_3;
  const Scalar f_1 = -Scalar(2.0) * a2_2 * per_0_2 / omega2_2;
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (Scalar(2.0) * f_0 + Scalar(2.0) * f_1) * per_0;
  gradient[0] = f_0 / omega1 - Scalar(2.0) * q_0;  // by omega1
  gradient[1] = (-Scalar(3.0) * f_0 - Scalar(2.0) * f_1) / omega2 - q_0;  // by omega2
  const Scalar c_0 = (-Scalar(2.0) * omega1 - Scalar(2.0) * omega2) * per_0_2 / omega2_3;  // multiplies a2^2
  gradient[3] = Scalar(2.0) * a2 * c_0;  // by a2
  return value;
}

/// harmonic_im_y_A_y_conjA_x = (4*omega1*a3*mu1 - 4*omega2*a3*mu1)/(omega1^2*(omega1 - 2*omega2)^2)
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 17 operations.
template <class Scalar>
Scalar lump_33(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a3 = parameters[4];
  const Scalar mu1 = parameters[11];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar per_0 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar f_0 = Scalar(4.0) * a3 * mu1 * per_0_2 / omega1;
  const Scalar f_1 = -Scalar(4.0) * omega2 * a3 * mu1 * per_0_2 / omega1_2;
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (Scalar(2.0) * f_0 + Scalar(2.0) * f_1) * per_0;
  gradient[0] = (-f_0 - Scalar(2.0) * f_1) / omega1 - q_0;  // by omega1
  gradient[1] = f_1 / omega2 + Scalar(2.0) * q_0;  // by omega2
  const Scalar c_0 = (Scalar(4.0) * omega1 - Scalar(4.0) * omega2) * per_0_2 / omega1_2;  // multiplies a3*mu1
  gradient[4] = mu1 * c_0;  // by a3
  gradient[11] = a3 * c_0;  // by mu1
  return value;
}

/// harmonic_re_y_A_x_A_y_conjA_y = 6*b4/((omega1 + omega2)*(omega1 - omega2)) + (4*omega1^2*a2*a3 -
/// 8*omega1*omega2*a2*a3 - 4*omega2^2*a2*a3)/(omega1^2*omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 +
/// omega2)) + (-4*omega1^2*a3*a4 + 24*omega2^2*a3*a4)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 -
/// omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 70 operations.
template <class Scalar>
Scalar lump_34(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_4 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = Scalar(6.0) * b4 * per_0 * per_1;
  const Scalar f_1 = Scalar(4.0) * a2 * a3 * per_0 * per_1 * per_2 / omega2;
  const Scalar f_2 = -Scalar(8.0) * a2 * a3 * per_0 * per_1 * per_2 / omega1;
  const Scalar f_3 = -Scalar(4.0) * omega2 * a2 * a3 * per_0 * per_1 * per_2 / omega1_2;
  const Scalar f_4 = -Scalar(4.0) * omega1_2 * a3 * a4 * per_0 * per_3 * per_1 * per_4 / omega2_2;
  const Scalar f_5 = Scalar(24.0) * a3 * a4 * per_0 * per_3 * per_1 * per_4;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_1;
  const Scalar q_2 = (f_1 + f_2 + f_3) * per_2;
  const Scalar q_3 = (f_4 + f_5) * per_3;
  const Scalar q_4 = (f_4 + f_5) * per_4;
  // by omega1
  gradient[0] = (-f_2 - Scalar(2.0) * f_3 + Scalar(2.0) * f_4) / omega1 - q_0 - q_1 - Scalar(2.0) * q_2 - q_3 - q_4;
  // by omega2
  gradient[1] = (-f_1 + f_3 - Scalar(2.0) * f_4) / omega2 - q_0 + q_1 - q_2 - Scalar(2.0) * q_3 + Scalar(2.0) * q_4;
  // multiplies a2*a3
  const Scalar c_0 = (Scalar(4.0) * omega1_2 - Scalar(8.0) * omega1 * omega2
      - Scalar(4.0) * omega2_2) * per_0 * per_1 * per_2 / (omega1_2 * omega2);
  // multiplies a3*a4
  const Scalar c_1 = (-Scalar(4.0) * omega1_2 + Scalar(24.0) * omega2_2) * per_0 * per_3 * per_1 * per_4 / omega2_2;
  const Scalar c_2 = Scalar(6.0) * per_0 * per_1;  // multiplies b4
  gradient[3] = a3 * c_0;  // by a2
  gradient[4] = a2 * c_0 + a4 * c_1;  // by a3
  gradient[5] = a3 * c_1;  // by a4
  gradient[9] = c_2;  // by b4
  return value;
}

/// harmonic_re_y_A_x2_conjA_x = (9*omega1^2*omega2^2*b2 - 12*omega1^2*a2*a3 -
/// 10*omega2^2*a1*a2)/(3*omega1^2*omega2^2*(omega1 + omega2)*(omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 27 operations.
template <class Scalar>
Scalar lump_35(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar b2 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = Scalar(3.0) * b2 * per_0 * per_1;
  const Scalar f_1 = -Scalar(4.0) * a2 * a3 * per_0 * per_1 / omega2_2;
  const Scalar f_2 = -Scalar(10.0) * a1 * a2 * per_0 * per_1 / (Scalar(3.0) * omega1_2);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2) * per_1;
  gradient[0] = -Scalar(2.0) * f_2 / omega1 - q_0 - q_1;  // by omega1
  gradient[1] = -Scalar(2.0) * f_1 / omega2 - q_0 + q_1;  // by omega2
  const Scalar c_0 = -Scalar(10.0) * per_0 * per_1 / (Scalar(3.0) * omega1_2);  // multiplies a1*a2
  const Scalar c_1 = -Scalar(4.0) * per_0 * per_1 / omega2_2;  // multiplies a2*a3
  const Scalar c_2 = Scalar(3.0) * per_0 * per_1;  // multiplies b2
  gradient[2] = a2 * c_0;  // by a1
  gradient[3] = a1 * c_0 + a3 * c_1;  // by a2
  gradient[4] = a2 * c_1;  // by a3
  gradient[7] = c_2;  // by b2
  return value;
}

/// harmonic_re_y_A_y_conjA_x2 = (3*omega1^2*b3 + 2*a1*a3)/(12*omega1^3*(omega1 - omega2)) +
/// a3^2/(omega1^2*(omega1 - omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 25 operations.
template <class Scalar>
Scalar lump_36(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a3 = parameters[4];
  const Scalar b3 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar a3_2 = a3 * a3;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = b3 * per_0 / (Scalar(4.0) * omega1);
  const Scalar f_1 = a1 * a3 * per_0 / (Scalar(6.0) * omega1_3);
  const Scalar f_2 = a3_2 * per_0 * per_1 / omega1_2;
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2) * per_0;
  const Scalar q_1 = f_2 * per_1;
  gradient[0] = (-f_0 - Scalar(3.0) * f_1 - Scalar(2.0) * f_2) / omega1 - q_0 - q_1;  // by omega1
  gradient[1] = q_0 + Scalar(2.0) * q_1;  // by omega2
  const Scalar c_0 = per_0 / (Scalar(6.0) * omega1_3);  // multiplies a1*a3
  const Scalar c_1 = per_0 * per_1 / omega1_2;  // multiplies a3^2
  const Scalar c_2 = per_0 / (Scalar(4.0) * omega1);  // multiplies b3
  gradient[2] = a3 * c_0;  // by a1
  gradient[4] = a1 * c_0 + Scalar(2.0) * a3 * c_1;  // by a3
  gradient[8] = c_2;  // by b3
  return value;
}

/// harmonic_re_y_conjA_y_F = -a3*e1/(omega2^2*(omega1 + omega2)*(omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 11 operations.
template <class Scalar>
Scalar lump_37(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a3 = parameters[4];
  const Scalar e1 = parameters[12];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -a3 * e1 * per_0 * per_1 / omega2_2;
  const Scalar value = f_0;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_0 * per_0;
  const Scalar q_1 = f_0 * per_1;
  gradient[0] = -q_0 - q_1;  // by omega1
  gradient[1] = -Scalar(2.0) * f_0 / omega2 - q_0 + q_1;  // by omega2
  const Scalar c_0 = -per_0 * per_1 / omega2_2;  // multiplies a3*e1
  gradient[4] = e1 * c_0;  // by a3
  gradient[12] = a3 * c_0;  // by e1
  return value;
}

/// harmonic_re_y_A_y2_conjA_x = 3*b4/((omega1 - omega2)*(omega1 - 3*omega2)) + (2*omega1^2*a3*a4 -
/// 4*omega1*omega2*a3*a4 + 12*omega2^2*a3*a4)/(3*omega1*omega2^2*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 -
/// 3*omega2)) - 2*a2*a3/((omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 59 operations.
template <class Scalar>
Scalar lump_38(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(3.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar f_0 = Scalar(3.0) * b4 * per_0 * per_1;
  const Scalar f_1 = Scalar(2.0) * omega1 * a3 * a4 * per_0 * per_2 * per_1 / (Scalar(3.0) * omega2_2);
  const Scalar f_2 = -Scalar(4.0) * a3 * a4 * per_0 * per_2 * per_1 / (Scalar(3.0) * omega2);
  const Scalar f_3 = Scalar(4.0) * a3 * a4 * per_0 * per_2 * per_1 / omega1;
  const Scalar f_4 = -Scalar(2.0) * a2 * a3 * per_3 * per_0 * per_2 * per_1;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_1;
  const Scalar q_2 = (f_1 + f_2 + f_3 + f_4) * per_2;
  const Scalar q_3 = f_4 * per_3;
  gradient[0] = (f_1 - f_3) / omega1 - q_0 - q_1 - q_2 - q_3;  // by omega1
  // by omega2
  gradient[1] = (-Scalar(2.0) * f_1 - f_2) / omega2 + q_0 + Scalar(3.0) * q_1 + Scalar(2.0) * q_2
      - Scalar(2.0) * q_3;
  const Scalar c_0 = -Scalar(2.0) * per_3 * per_0 * per_2 * per_1;  // multiplies a2*a3
  // multiplies a3*a4
  const Scalar c_1 = (Scalar(2.0) * omega1_2 - Scalar(4.0) * omega1 * omega2
      + Scalar(12.0) * omega2_2) * per_0 * per_2 * per_1 / (Scalar(3.0) * omega1 * omega2_2);
  const Scalar c_2 = Scalar(3.0) * per_0 * per_1;  // multiplies b4
  gradient[3] = a3 * c_0;  // by a2
  gradient[4] = a2 * c_0 + a4 * c_1;  // by a3
  gradient[5] = a3 * c_1;  // by a4
  gradient[9] = c_2;  // by b4
  return value;
}

/// harmonic_re_y_A_x3 = (3*omega1^2*b2 + 2*a1*a2)/(3*omega1^2*(3*omega1 + omega2)*(3*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 20 operations.
template <class Scalar>
Scalar lump_39(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar b2 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar per_0 = Scalar(1.0) / (Scalar(3.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(3.0) * omega1 - omega2);
  const Scalar f_0 = b2 * per_0 * per_1;
  const Scalar f_1 = Scalar(2.0) * a1 * a2 * per_0 * per_1 / (Scalar(3.0) * omega1_2);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1) * per_0;
  const Scalar q_1 = (f_0 + f_1) * per_1;
  gradient[0] = -Scalar(2.0) * f_1 / omega1 - Scalar(3.0) * q_0 - Scalar(3.0) * q_1;  // by omega1
  gradient[1] = -q_0 + q_1;  // by omega2
  const Scalar c_0 = Scalar(2.0) * per_0 * per_1 / (Scalar(3.0) * omega1_2);  // multiplies a1*a2
  const Scalar c_1 = per_0 * per_1;  // multiplies b2
  gradient[2] = a2 * c_0;  // by a1
  gradient[3] = a1 * c_0;  // by a2
  gradient[7] = c_1;  // by b2
  return value;
}

/// conservative_y_A_x3 = (3*omega1^2*b2 + 2*a1*a2)/(6*omega1^2*omega2) + a2*a3/(omega2*(2*omega1 +
/// omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 24 operations.
template <class Scalar>
Scalar lump_40(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar b2 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = b2 / (Scalar(2.0) * omega2);
  const Scalar f_1 = a1 * a2 / (Scalar(3.0) * omega1_2 * omega2);
  const Scalar f_2 = a2 * a3 * per_0 * per_1 / omega2;
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_2 * per_0;
  const Scalar q_1 = f_2 * per_1;
  gradient[0] = -Scalar(2.0) * f_1 / omega1 - Scalar(2.0) * q_0 - Scalar(2.0) * q_1;  // by omega1
  gradient[1] = (-f_0 - f_1 - f_2) / omega2 - q_0 + q_1;  // by omega2
  const Scalar c_0 = Scalar(1.0) / (Scalar(3.0) * omega1_2 * omega2);  // multiplies a1*a2
  const Scalar c_1 = per_0 * per_1 / omega2;  // multiplies a2*a3
  const Scalar c_2 = Scalar(1.0) / (Scalar(2.0) * omega2);  // multiplies b2
  gradient[2] = a2 * c_0;  // by a1
  gradient[3] = a1 * c_0 + a3 * c_1;  // by a2
  gradient[4] = a2 * c_1;  // by a3
  gradient[7] = c_2;  // by b2
  return value;
}

/// harmonic_re_x_A_y2_conjA_x = (-3*omega2^2*b3 - 2*a2*a4)/(12*omega2^3*(omega1 - omega2)) -
/// a3^2/(omega1*omega2*(omega1 - omega2)*(omega1 - 2*omega2)) + a2^2/(omega2^2*(omega1 - omega2)*(2*omega1 -
/// omega2)) + a1*a3/(2*omega2*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 51 operations.
template <class Scalar>
Scalar lump_41(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar f_0 = -b3 * per_0 / (Scalar(4.0) * omega2);
  const Scalar f_1 = -a2 * a4 * per_0 / (Scalar(6.0) * omega2_3);
  const Scalar f_2 = -a3_2 * per_0 * per_1 / (omega1 * omega2);
  const Scalar f_3 = a2_2 * per_0 * per_2 / omega2_2;
  const Scalar f_4 = a1 * a3 * per_3 * per_0 * per_1 / (Scalar(2.0) * omega2);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_0;
  const Scalar q_1 = (f_2 + f_4) * per_1;
  const Scalar q_2 = f_3 * per_2;
  const Scalar q_3 = f_4 * per_3;
  gradient[0] = -f_2 / omega1 - q_0 - q_1 - Scalar(2.0) * q_2 - q_3;  // by omega1
  // by omega2
  gradient[1] = (-f_0 - Scalar(3.0) * f_1 - f_2 - Scalar(2.0) * f_3 - f_4) / omega2 + q_0 + Scalar(2.0) * q_1 + q_2
      - Scalar(2.0) * q_3;
  const Scalar c_0 = per_3 * per_0 * per_1 / (Scalar(2.0) * omega2);  // multiplies a1*a3
  const Scalar c_1 = per_0 * per_2 / omega2_2;  // multiplies a2^2
  const Scalar c_2 = -per_0 / (Scalar(6.0) * omega2_3);  // multiplies a2*a4
  const Scalar c_3 = -per_0 * per_1 / (omega1 * omega2);  // multiplies a3^2
  const Scalar c_4 = -per_0 / (Scalar(4.0) * omega2);  // multiplies b3
  gradient[2] = a3 * c_0;  // by a1
  gradient[3] = Scalar(2.0) * a2 * c_1 + a4 * c_2;  // by a2
  gradient[4] = a1 * c_0 + Scalar(2.0) * a3 * c_3;  // by a3
  gradient[5] = a2 * c_2;  // by a4
  gradient[8] = c_4;  // by b3
  return value;
}

/// harmonic_re_x_A_x_A_y_conjA_x = -6*b2/((omega1 + omega2)*(omega1 - omega2)) + (4*omega1^2*a2*a3 -
/// 24*omega2^2*a2*a3)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) +
/// (24*omega1^2*a1*a2 - 4*omega2^2*a1*a2)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 +
/// omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 65 operations.
template <class Scalar>
Scalar lump_42(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar b2 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_4 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_5 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = -Scalar(6.0) * b2 * per_0 * per_1;
  const Scalar f_1 = Scalar(4.0) * omega1_2 * a2 * a3 * per_0 * per_2 * per_1 * per_3 / omega2_2;
  const Scalar f_2 = -Scalar(24.0) * a2 * a3 * per_0 * per_2 * per_1 * per_3;
  const Scalar f_3 = Scalar(24.0) * a1 * a2 * per_0 * per_1 * per_4 * per_5;
  const Scalar f_4 = -Scalar(4.0) * omega2_2 * a1 * a2 * per_0 * per_1 * per_4 * per_5 / omega1_2;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_1;
  const Scalar q_2 = (f_1 + f_2) * per_2;
  const Scalar q_3 = (f_1 + f_2) * per_3;
  const Scalar q_4 = (f_3 + f_4) * per_4;
  const Scalar q_5 = (f_3 + f_4) * per_5;
  // by omega1
  gradient[0] = (Scalar(2.0) * f_1 - Scalar(2.0) * f_4) / omega1 - q_0 - q_1 - q_2 - q_3 - Scalar(2.0) * q_4
      - Scalar(2.0) * q_5;
  // by omega2
  gradient[1] = (-Scalar(2.0) * f_1 + Scalar(2.0) * f_4) / omega2 - q_0 + q_1 - Scalar(2.0) * q_2
      + Scalar(2.0) * q_3 - q_4 + q_5;
  // multiplies a1*a2
  const Scalar c_0 = (Scalar(24.0) * omega1_2 - Scalar(4.0) * omega2_2) * per_0 * per_1 * per_4 * per_5 / omega1_2;
  // multiplies a2*a3
  const Scalar c_1 = (Scalar(4.0) * omega1_2 - Scalar(24.0) * omega2_2) * per_0 * per_2 * per_1 * per_3 / omega2_2;
  const Scalar c_2 = -Scalar(6.0) * per_0 * per_1;  // multiplies b2
  gradient[2] = a2 * c_0;  // by a1
  gradient[3] = a1 * c_0 + a3 * c_1;  // by a2
  gradient[4] = a2 * c_1;  // by a3
  gradient[7] = c_2;  // by b2
  return value;
}

/// harmonic_re_y_A_y_conjA_x2 = (3*omega1^2*b3 + 2*a1*a3)/(12*omega1^3*(omega1 - omega2)) +
/// a3^2/(omega1^2*(omega1 - omega2)*(omega1 - 2*omega2)) - a2^2/(omega1*omega2*(omega1 - omega2)*(2*omega1 -
/// omega2)) + a2*a4/(2*omega1*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 51 operations.
template <class Scalar>
Scalar lump_43(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar f_0 = b3 * per_0 / (Scalar(4.0) * omega1);
  const Scalar f_1 = a1 * a3 * per_0 / (Scalar(6.0) * omega1_3);
  const Scalar f_2 = a3_2 * per_0 * per_1 / omega1_2;
  const Scalar f_3 = -a2_2 * per_0 * per_2 / (omega1 * omega2);
  const Scalar f_4 = a2 * a4 * per_0 * per_3 * per_2 / (Scalar(2.0) * omega1);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_0;
  const Scalar q_1 = f_2 * per_1;
  const Scalar q_2 = (f_3 + f_4) * per_2;
  const Scalar q_3 = f_4 * per_3;
  // by omega1
  gradient[0] = (-f_0 - Scalar(3.0) * f_1 - Scalar(2.0) * f_2 - f_3 - f_4) / omega1 - q_0 - q_1 - Scalar(2.0) * q_2
      - Scalar(2.0) * q_3;
  gradient[1] = -f_3 / omega2 + q_0 + Scalar(2.0) * q_1 + q_2 - q_3;  // by omega2
  const Scalar c_0 = per_0 / (Scalar(6.0) * omega1_3);  // multiplies a1*a3
  const Scalar c_1 = -per_0 * per_2 / (omega1 * omega2);  // multiplies a2^2
  const Scalar c_2 = per_0 * per_3 * per_2 / (Scalar(2.0) * omega1);  // multiplies a2*a4
  const Scalar c_3 = per_0 * per_1 / omega1_2;  // multiplies a3^2
  const Scalar c_4 = per_0 / (Scalar(4.0) * omega1);  // multiplies b3
  gradient[2] = a3 * c_0;  // by a1
  gradient[3] = Scalar(2.0) * a2 * c_1 + a4 * c_2;  // by a2
  gradient[4] = a1 * c_0 + Scalar(2.0) * a3 * c_3;  // by a3
  gradient[5] = a2 * c_2;  // by a4
  gradient[8] = c_4;  // by b3
  return value;
}

/// harmonic_re_y_A_x_A_y_conjA_y = 6*b4/((omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^2*a3*a4 +
/// 24*omega2^2*a3*a4)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) +
/// (-24*omega1^2*a2*a3 + 4*omega2^2*a2*a3)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 +
/// omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 65 operations.
template <class Scalar>
Scalar lump_44(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_4 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_5 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = Scalar(6.0) * b4 * per_0 * per_1;
  const Scalar f_1 = -Scalar(4.0) * omega1_2 * a3 * a4 * per_0 * per_2 * per_1 * per_3 / omega2_2;
  const Scalar f_2 = Scalar(24.0) * a3 * a4 * per_0 * per_2 * per_1 * per_3;
  const Scalar f_3 = -Scalar(24.0) * a2 * a3 * per_0 * per_1 * per_4 * per_5;
  const Scalar f_4 = Scalar(4.0) * omega2_2 * a2 * a3 * per_0 * per_1 * per_4 * per_5 / omega1_2;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_1;
  const Scalar q_2 = (f_1 + f_2) * per_2;
  const Scalar q_3 = (f_1 + f_2) * per_3;
  const Scalar q_4 = (f_3 + f_4) * per_4;
  const Scalar q_5 = (f_3 + f_4) * per_5;
  // by omega1
  gradient[0] = (Scalar(2.0) * f_1 - Scalar(2.0) * f_4) / omega1 - q_0 - q_1 - q_2 - q_3 - Scalar(2.0) * q_4
      - Scalar(2.0) * q_5;
  // by omega2
  gradient[1] = (-Scalar(2.0) * f_1 + Scalar(2.0) * f_4) / omega2 - q_0 + q_1 - Scalar(2.0) * q_2
      + Scalar(2.0) * q_3 - q_4 + q_5;
  // multiplies a2*a3
  const Scalar c_0 = (-Scalar(24.0) * omega1_2 + Scalar(4.0) * omega2_2) * per_0 * per_1 * per_4 * per_5 / omega1_2;
  // multiplies a3*a4
  const Scalar c_1 = (-Scalar(4.0) * omega1_2 + Scalar(24.0) * omega2_2) * per_0 * per_2 * per_1 * per_3 / omega2_2;
  const Scalar c_2 = Scalar(6.0) * per_0 * per_1;  // multiplies b4
  gradient[3] = a3 * c_0;  // by a2
  gradient[4] = a2 * c_0 + a4 * c_1;  // by a3
  gradient[5] = a3 * c_1;  // by a4
  gradient[9] = c_2;  // by b4
  return value;
}

/// harmonic_re_y_A_x2_conjA_x = (9*omega1^2*b2 - 10*a1*a2)/(3*omega1^2*(omega1 + omega2)*(omega1 - omega2)) +
/// (-16*omega1^2*a2*a3 + 6*omega2^2*a2*a3)/(omega2^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 +
/// omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 47 operations.
template <class Scalar>
Scalar lump_45(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar b2 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = Scalar(3.0) * b2 * per_0 * per_1;
  const Scalar f_1 = -Scalar(10.0) * a1 * a2 * per_0 * per_1 / (Scalar(3.0) * omega1_2);
  const Scalar f_2 = -Scalar(16.0) * omega1_2 * a2 * a3 * per_0 * per_1 * per_2 * per_3 / omega2_2;
  const Scalar f_3 = Scalar(6.0) * a2 * a3 * per_0 * per_1 * per_2 * per_3;
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3) * per_1;
  const Scalar q_2 = (f_2 + f_3) * per_2;
  const Scalar q_3 = (f_2 + f_3) * per_3;
  // by omega1
  gradient[0] = (-Scalar(2.0) * f_1 + Scalar(2.0) * f_2) / omega1 - q_0 - q_1 - Scalar(2.0) * q_2
      - Scalar(2.0) * q_3;
  gradient[1] = -Scalar(2.0) * f_2 / omega2 - q_0 + q_1 - q_2 + q_3;  // by omega2
  const Scalar c_0 = -Scalar(10.0) * per_0 * per_1 / (Scalar(3.0) * omega1_2);  // multiplies a1*a2
  // multiplies a2*a3
  const Scalar c_1 = (-Scalar(16.0) * omega1_2 + Scalar(6.0) * omega2_2) * per_0 * per_1 * per_2 * per_3 / omega2_2;
  const Scalar c_2 = Scalar(3.0) * per_0 * per_1;  // multiplies b2
  gradient[2] = a2 * c_0;  // by a1
  gradient[3] = a1 * c_0 + a3 * c_1;  // by a2
  gradient[4] = a2 * c_1;  // by a3
  gradient[7] = c_2;  // by b2
  return value;
}

/// harmonic_re_y_A_y2_conjA_x = 3*b4/((omega1 - omega2)*(omega1 - 3*omega2)) + (2*omega1^2*a3*a4 -
/// 4*omega1*omega2*a3*a4 + 12*omega2^2*a3*a4)/(3*omega1*omega2^2*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 -
/// 3*omega2)) + (-4*omega1^2*a2*a3 - 4*omega1*omega2*a2*a3 + 18*omega2^2*a2*a3)/(omega2*(omega1 +
/// 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 89 operations.
template <class Scalar>
Scalar lump_46(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(3.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_4 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = Scalar(3.0) * b4 * per_0 * per_1;
  const Scalar f_1 = Scalar(2.0) * omega1 * a3 * a4 * per_0 * per_2 * per_1 / (Scalar(3.0) * omega2_2);
  const Scalar f_2 = -Scalar(4.0) * a3 * a4 * per_0 * per_2 * per_1 / (Scalar(3.0) * omega2);
  const Scalar f_3 = Scalar(4.0) * a3 * a4 * per_0 * per_2 * per_1 / omega1;
  const Scalar f_4 = -Scalar(4.0) * omega1_2 * a2 * a3 * per_3 * per_0 * per_2 * per_1 * per_4 / omega2;
  const Scalar f_5 = -Scalar(4.0) * omega1 * a2 * a3 * per_3 * per_0 * per_2 * per_1 * per_4;
  const Scalar f_6 = Scalar(18.0) * omega2 * a2 * a3 * per_3 * per_0 * per_2 * per_1 * per_4;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_1;
  const Scalar q_2 = (f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_2;
  const Scalar q_3 = (f_4 + f_5 + f_6) * per_3;
  const Scalar q_4 = (f_4 + f_5 + f_6) * per_4;
  // by omega1
  gradient[0] = (f_1 - f_3 + Scalar(2.0) * f_4 + f_5) / omega1 - q_0 - q_1 - q_2 - q_3 - Scalar(2.0) * q_4;
  // by omega2
  gradient[1] = (-Scalar(2.0) * f_1 - f_2 - f_4 + f_6) / omega2 + q_0 + Scalar(3.0) * q_1 + Scalar(2.0) * q_2
      - Scalar(2.0) * q_3 + q_4;
  // multiplies a2*a3
  const Scalar c_0 = (-Scalar(4.0) * omega1_2 - Scalar(4.0) * omega1 * omega2
      + Scalar(18.0) * omega2_2) * per_3 * per_0 * per_2 * per_1 * per_4 / omega2;
  // multiplies a3*a4
  const Scalar c_1 = (Scalar(2.0) * omega1_2 - Scalar(4.0) * omega1 * omega2
      + Scalar(12.0) * omega2_2) * per_0 * per_2 * per_1 / (Scalar(3.0) * omega1 * omega2_2);
  const Scalar c_2 = Scalar(3.0) * per_0 * per_1;  // multiplies b4
  gradient[3] = a3 * c_0;  // by a2
  gradient[4] = a2 * c_0 + a4 * c_1;  // by a3
  gradient[5] = a3 * c_1;  // by a4
  gradient[9] = c_2;  // by b4
  return value;
}

namespace one_to_one {

/// Lumps: the parameter combinations that multiply data.
/// lumps[1]: mu1 = mu1
/// lumps[4]: e1 = e1
/// lumps[11]: e2 = e2
/// lumps[12]: mu2 = mu2
/// lumps[15]: a2 = a2
/// lumps[16]: a3 = a3
/// lumps[17]: a1 = a1
/// lumps[22]: a4 = a4
/// 0 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar mu1 = parameters[11];
  const Scalar e1 = parameters[12];
  const Scalar mu2 = parameters[13];
  const Scalar e2 = parameters[14];
  lumps[0] = lump_0(parameters, static_cast<Scalar*>(nullptr));  // conservative_x_A_x2_conjA_y
  lumps[1] = mu1;  // mu1
  lumps[2] = lump_1(parameters, static_cast<Scalar*>(nullptr));  // conservative_x_A_x_A_y_conjA_y
  lumps[3] = lump_2(parameters, static_cast<Scalar*>(nullptr));  // conservative_x_A_x2_conjA_x
  lumps[4] = e1;  // e1
  lumps[5] = lump_3(parameters, static_cast<Scalar*>(nullptr));  // conservative_x_A_y2_conjA_y
  lumps[6] = lump_4(parameters, static_cast<Scalar*>(nullptr));  // conservative_x_A_x_A_y_conjA_x
  lumps[7] = lump_5(parameters, static_cast<Scalar*>(nullptr));  // conservative_x_A_y2_conjA_x
  lumps[8] = lump_6(parameters, static_cast<Scalar*>(nullptr));  // conservative_y_A_x2_conjA_y
  lumps[9] = lump_7(parameters, static_cast<Scalar*>(nullptr));  // conservative_y_A_x_A_y_conjA_y
  lumps[10] = lump_8(parameters, static_cast<Scalar*>(nullptr));  // conservative_y_A_x2_conjA_x
  lumps[11] = e2;  // e2
  lumps[12] = mu2;  // mu2
  lumps[13] = lump_9(parameters, static_cast<Scalar*>(nullptr));  // conservative_y_A_y2_conjA_y
  lumps[14] = lump_10(parameters, static_cast<Scalar*>(nullptr));  // conservative_y_A_y2_conjA_x
  lumps[15] = a2;  // a2
  lumps[16] = a3;  // a3
  lumps[17] = a1;  // a1
  lumps[18] = lump_11(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_y3
  lumps[19] = lump_12(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_x_A_y2
  lumps[20] = lump_13(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_x2_A_y
  lumps[21] = lump_14(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_x3
  lumps[22] = a4;  // a4
  lumps[23] = lump_15(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_y3
  lumps[24] = lump_16(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_x_A_y2
  lumps[25] = lump_17(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_x2_A_y
  lumps[26] = lump_18(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_x3
}

/// jacobian[l * 15 + p] = d lumps[l] / d parameters[p]. 0 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  for (std::size_t i = 0; i < 405; ++i) jacobian[i] = Scalar(0.0);
  lump_0(parameters, jacobian + 0);  // d conservative_x_A_x2_conjA_y
  jacobian[26] = Scalar(1.0);  // d mu1 / d mu1
  lump_1(parameters, jacobian + 30);  // d conservative_x_A_x_A_y_conjA_y
  lump_2(parameters, jacobian + 45);  // d conservative_x_A_x2_conjA_x
  jacobian[72] = Scalar(1.0);  // d e1 / d e1
  lump_3(parameters, jacobian + 75);  // d conservative_x_A_y2_conjA_y
  lump_4(parameters, jacobian + 90);  // d conservative_x_A_x_A_y_conjA_x
  lump_5(parameters, jacobian + 105);  // d conservative_x_A_y2_conjA_x
  lump_6(parameters, jacobian + 120);  // d conservative_y_A_x2_conjA_y
  lump_7(parameters, jacobian + 135);  // d conservative_y_A_x_A_y_conjA_y
  lump_8(parameters, jacobian + 150);  // d conservative_y_A_x2_conjA_x
  jacobian[179] = Scalar(1.0);  // d e2 / d e2
  jacobian[193] = Scalar(1.0);  // d mu2 / d mu2
  lump_9(parameters, jacobian + 195);  // d conservative_y_A_y2_conjA_y
  lump_10(parameters, jacobian + 210);  // d conservative_y_A_y2_conjA_x
  jacobian[228] = Scalar(1.0);  // d a2 / d a2
  jacobian[244] = Scalar(1.0);  // d a3 / d a3
  jacobian[257] = Scalar(1.0);  // d a1 / d a1
  lump_11(parameters, jacobian + 270);  // d harmonic_re_x_A_y3
  lump_12(parameters, jacobian + 285);  // d harmonic_re_x_A_x_A_y2
  lump_13(parameters, jacobian + 300);  // d harmonic_re_x_A_x2_A_y
  lump_14(parameters, jacobian + 315);  // d harmonic_re_x_A_x3
  jacobian[335] = Scalar(1.0);  // d a4 / d a4
  lump_15(parameters, jacobian + 345);  // d harmonic_re_y_A_y3
  lump_16(parameters, jacobian + 360);  // d harmonic_re_y_A_x_A_y2
  lump_17(parameters, jacobian + 375);  // d harmonic_re_y_A_x2_A_y
  lump_18(parameters, jacobian + 390);  // d harmonic_re_y_A_x3
}

/// What multiplies the 8 terms of the modulation of x: functions of the frequencies alone. 2 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  factor[0] = Scalar(1.0);
  factor[1] = -Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = -Scalar(1.0) / (Scalar(4.0) * omega1);
  factor[5] = Scalar(1.0);
  factor[6] = Scalar(1.0);
  factor[7] = Scalar(1.0);
}

/// Rows of the modulation of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega1)*A_x = i*conservative_x_A_x2_conjA_y*A_x^2*conj(A_y) - mu1*A_x +
/// i*conservative_x_A_x_A_y_conjA_y*A_x*A_y*conj(A_y) + i*conservative_x_A_x2_conjA_x*A_x^2*conj(A_x) -
/// 1/(4*omega1)*i*e1*F + i*conservative_x_A_y2_conjA_y*A_y^2*conj(A_y) +
/// i*conservative_x_A_x_A_y_conjA_x*A_x*conj(A_x)*A_y + i*conservative_x_A_y2_conjA_x*conj(A_x)*A_y^2
/// 8 columns; per observation at most 24 products and sums of complex numbers.
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
  Scalar factor[8];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Complex conj_A_y = conjugate(A_y);
    const Scalar norm_A_y = norm_of(A_y);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, times_i(factor[0] * (A_x * A_x * conj_A_y)));  // conservative_x_A_x2_conjA_y
    store_complex(column_1, i, factor[1] * (A_x));  // mu1
    store_complex(column_2, i, times_i(factor[2] * (A_x * norm_A_y)));  // conservative_x_A_x_A_y_conjA_y
    store_complex(column_3, i, times_i(factor[3] * (norm_A_x * A_x)));  // conservative_x_A_x2_conjA_x
    store_complex(column_4, i, times_i(factor[4] * (F)));  // e1
    store_complex(column_5, i, times_i(factor[5] * (norm_A_y * A_y)));  // conservative_x_A_y2_conjA_y
    store_complex(column_6, i, times_i(factor[6] * (norm_A_x * A_y)));  // conservative_x_A_x_A_y_conjA_x
    store_complex(column_7, i, times_i(factor[7] * (conj_A_x * A_y * A_y)));  // conservative_x_A_y2_conjA_x
  }
}

/// columns[j][i] of the rows.
inline void columns_0(const BatchArrays& data, double* const* columns) {
  rows_0(data, FactorValues<factors_0<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_0(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_0(data, FactorSlopes<factors_0<DualNumber>, 2, 1, 8>{mode}, columns);
}

/// What multiplies the 8 terms of the modulation of y: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_1([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  factor[0] = omega1 / omega2;
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = -Scalar(1.0) / (Scalar(4.0) * omega2);
  factor[5] = -Scalar(1.0);
  factor[6] = Scalar(1.0);
  factor[7] = Scalar(1.0);
}

/// Rows of the modulation of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega2)*A_y = omega1/omega2*i*conservative_x_A_x_A_y_conjA_y*A_x*conj(A_x)*A_y +
/// i*conservative_y_A_x2_conjA_y*A_x^2*conj(A_y) + i*conservative_y_A_x_A_y_conjA_y*A_x*A_y*conj(A_y) +
/// i*conservative_y_A_x2_conjA_x*A_x^2*conj(A_x) - 1/(4*omega2)*i*e2*F - mu2*A_y +
/// i*conservative_y_A_y2_conjA_y*A_y^2*conj(A_y) + i*conservative_y_A_y2_conjA_x*conj(A_x)*A_y^2
/// 8 columns; per observation at most 24 products and sums of complex numbers.
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
  Scalar factor[8];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Complex conj_A_y = conjugate(A_y);
    const Scalar norm_A_y = norm_of(A_y);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, times_i(factor[0] * (norm_A_x * A_y)));  // conservative_x_A_x_A_y_conjA_y
    store_complex(column_1, i, times_i(factor[1] * (A_x * A_x * conj_A_y)));  // conservative_y_A_x2_conjA_y
    store_complex(column_2, i, times_i(factor[2] * (A_x * norm_A_y)));  // conservative_y_A_x_A_y_conjA_y
    store_complex(column_3, i, times_i(factor[3] * (norm_A_x * A_x)));  // conservative_y_A_x2_conjA_x
    store_complex(column_4, i, times_i(factor[4] * (F)));  // e2
    store_complex(column_5, i, factor[5] * (A_y));  // mu2
    store_complex(column_6, i, times_i(factor[6] * (norm_A_y * A_y)));  // conservative_y_A_y2_conjA_y
    store_complex(column_7, i, times_i(factor[7] * (conj_A_x * A_y * A_y)));  // conservative_y_A_y2_conjA_x
  }
}

/// columns[j][i] of the rows.
inline void columns_1(const BatchArrays& data, double* const* columns) {
  rows_1(data, FactorValues<factors_1<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_1(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_1(data, FactorSlopes<factors_1<DualNumber>, 2, 1, 8>{mode}, columns);
}

/// What multiplies the 4 terms of the harmonic 0 of x: functions of the frequencies alone. 10 operations.
template <class Scalar>
void factors_2([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  factor[0] = -Scalar(2.0) * per_0 / omega2;
  factor[1] = -Scalar(2.0) * per_0 / omega2;
  factor[2] = -Scalar(2.0) / omega1_2;
  factor[3] = -Scalar(2.0) / omega1_2;
}

/// Rows of the harmonic 0 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in x = -2/(omega2*(2*omega1 - omega2))*a2*conj(A_x)*A_y - 2/(omega2*(2*omega1 -
/// omega2))*a2*A_x*conj(A_y) - 2/omega1^2*a3*A_y*conj(A_y) - 2/omega1^2*a1*A_x*conj(A_x)
/// 3 columns; per observation at most 9 products and sums of complex numbers.
template <class Factors>
void rows_2(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Complex conj_A_y = conjugate(A_y);
    const Scalar norm_A_y = norm_of(A_y);
    store_complex(column_0, i, factor[0] * (conj_A_x * A_y) + factor[1] * (A_x * conj_A_y));  // a2
    store_complex(column_1, i, Complex(factor[2] * (norm_A_y)));  // a3
    store_complex(column_2, i, Complex(factor[3] * (norm_A_x)));  // a1
  }
}

/// columns[j][i] of the rows.
inline void columns_2(const BatchArrays& data, double* const* columns) {
  rows_2(data, FactorValues<factors_2<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_2(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_2(data, FactorSlopes<factors_2<DualNumber>, 2, 1, 4>{mode}, columns);
}

/// What multiplies the 3 terms of the harmonic 2*omega2 of x: functions of the frequencies alone. 15 operations.
template <class Scalar>
void factors_3([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  factor[0] = Scalar(2.0) * per_0 / omega2;
  factor[1] = -per_1 * per_2;
  factor[2] = Scalar(1.0) / (Scalar(3.0) * omega1_2);
}

/// Rows of the harmonic 2*omega2 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega2)*t) in x = 2/(omega2*(2*omega1 + omega2))*a2*A_x*A_y - 1/((omega1 +
/// 2*omega2)*(omega1 - 2*omega2))*a3*A_y^2 + 1/(3*omega1^2)*a1*A_x^2
/// 3 columns; per observation at most 9 products and sums of complex numbers.
template <class Factors>
void rows_3(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[3];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex A_y = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_x * A_y));  // a2
    store_complex(column_1, i, factor[1] * (A_y * A_y));  // a3
    store_complex(column_2, i, factor[2] * (A_x * A_x));  // a1
  }
}

/// columns[j][i] of the rows.
inline void columns_3(const BatchArrays& data, double* const* columns) {
  rows_3(data, FactorValues<factors_3<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_3(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_3(data, FactorSlopes<factors_3<DualNumber>, 2, 1, 3>{mode}, columns);
}

/// What multiplies the 4 terms of the harmonic 3*omega2 of x: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_4([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the harmonic 3*omega2 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega2)*t) in x = harmonic_re_x_A_y3*A_y^3 + harmonic_re_x_A_x_A_y2*A_x*A_y^2 +
/// harmonic_re_x_A_x2_A_y*A_x^2*A_y + harmonic_re_x_A_x3*A_x^3
/// 4 columns; per observation at most 20 products and sums of complex numbers.
template <class Factors>
void rows_4(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex A_y = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_y * A_y * A_y));  // harmonic_re_x_A_y3
    store_complex(column_1, i, factor[1] * (A_x * A_y * A_y));  // harmonic_re_x_A_x_A_y2
    store_complex(column_2, i, factor[2] * (A_x * A_x * A_y));  // harmonic_re_x_A_x2_A_y
    store_complex(column_3, i, factor[3] * (A_x * A_x * A_x));  // harmonic_re_x_A_x3
  }
}

/// columns[j][i] of the rows.
inline void columns_4(const BatchArrays& data, double* const* columns) {
  rows_4(data, FactorValues<factors_4<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_4(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 4 terms of the harmonic 0 of y: functions of the frequencies alone. 10 operations.
template <class Scalar>
void factors_5([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  factor[0] = -Scalar(2.0) / omega2_2;
  factor[1] = Scalar(2.0) * per_0 / omega1;
  factor[2] = Scalar(2.0) * per_0 / omega1;
  factor[3] = -Scalar(2.0) / omega2_2;
}

/// Rows of the harmonic 0 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in y = -2/omega2^2*a2*A_x*conj(A_x) + 2/(omega1*(omega1 -
/// 2*omega2))*a3*conj(A_x)*A_y + 2/(omega1*(omega1 - 2*omega2))*a3*A_x*conj(A_y) - 2/omega2^2*a4*A_y*conj(A_y)
/// 3 columns; per observation at most 9 products and sums of complex numbers.
template <class Factors>
void rows_5(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Complex conj_A_y = conjugate(A_y);
    const Scalar norm_A_y = norm_of(A_y);
    store_complex(column_0, i, Complex(factor[0] * (norm_A_x)));  // a2
    store_complex(column_1, i, factor[1] * (conj_A_x * A_y) + factor[2] * (A_x * conj_A_y));  // a3
    store_complex(column_2, i, Complex(factor[3] * (norm_A_y)));  // a4
  }
}

/// columns[j][i] of the rows.
inline void columns_5(const BatchArrays& data, double* const* columns) {
  rows_5(data, FactorValues<factors_5<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_5(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_5(data, FactorSlopes<factors_5<DualNumber>, 2, 1, 4>{mode}, columns);
}

/// What multiplies the 3 terms of the harmonic 2*omega2 of y: functions of the frequencies alone. 15 operations.
template <class Scalar>
void factors_6([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  factor[0] = per_0 * per_1;
  factor[1] = Scalar(2.0) * per_2 / omega1;
  factor[2] = Scalar(1.0) / (Scalar(3.0) * omega2_2);
}

/// Rows of the harmonic 2*omega2 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega2)*t) in y = 1/((2*omega1 + omega2)*(2*omega1 - omega2))*a2*A_x^2 +
/// 2/(omega1*(omega1 + 2*omega2))*a3*A_x*A_y + 1/(3*omega2^2)*a4*A_y^2
/// 3 columns; per observation at most 9 products and sums of complex numbers.
template <class Factors>
void rows_6(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[3];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex A_y = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_x * A_x));  // a2
    store_complex(column_1, i, factor[1] * (A_x * A_y));  // a3
    store_complex(column_2, i, factor[2] * (A_y * A_y));  // a4
  }
}

/// columns[j][i] of the rows.
inline void columns_6(const BatchArrays& data, double* const* columns) {
  rows_6(data, FactorValues<factors_6<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_6(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_6(data, FactorSlopes<factors_6<DualNumber>, 2, 1, 3>{mode}, columns);
}

/// What multiplies the 4 terms of the harmonic 3*omega2 of y: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_7([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the harmonic 3*omega2 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega2)*t) in y = harmonic_re_y_A_y3*A_y^3 + harmonic_re_y_A_x_A_y2*A_x*A_y^2 +
/// harmonic_re_y_A_x2_A_y*A_x^2*A_y + harmonic_re_y_A_x3*A_x^3
/// 4 columns; per observation at most 20 products and sums of complex numbers.
template <class Factors>
void rows_7(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex A_y = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_y * A_y * A_y));  // harmonic_re_y_A_y3
    store_complex(column_1, i, factor[1] * (A_x * A_y * A_y));  // harmonic_re_y_A_x_A_y2
    store_complex(column_2, i, factor[2] * (A_x * A_x * A_y));  // harmonic_re_y_A_x2_A_y
    store_complex(column_3, i, factor[3] * (A_x * A_x * A_x));  // harmonic_re_y_A_x3
  }
}

/// columns[j][i] of the rows.
inline void columns_7(const BatchArrays& data, double* const* columns) {
  rows_7(data, FactorValues<factors_7<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_7(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_x/dt + i*(w_x - omega1)*B_x = i*conservative_x_A_x2_conjA_y*A_x^2*conj(A_y) - mu1*A_x +
/// i*conservative_x_A_x_A_y_conjA_y*A_x*A_y*conj(A_y) + i*conservative_x_A_x2_conjA_x*A_x^2*conj(A_x) -
/// 1/(4*omega1)*i*e1*F + i*conservative_x_A_y2_conjA_y*A_y^2*conj(A_y) +
/// i*conservative_x_A_x_A_y_conjA_x*A_x*conj(A_x)*A_y + i*conservative_x_A_y2_conjA_x*conj(A_x)*A_y^2 with A = B
/// in that frame
/// dB_y/dt + i*(w_y - omega2)*B_y = omega1/omega2*i*conservative_x_A_x_A_y_conjA_y*A_x*conj(A_x)*A_y +
/// i*conservative_y_A_x2_conjA_y*A_x^2*conj(A_y) + i*conservative_y_A_x_A_y_conjA_y*A_x*A_y*conj(A_y) +
/// i*conservative_y_A_x2_conjA_x*A_x^2*conj(A_x) - 1/(4*omega2)*i*e2*F - mu2*A_y +
/// i*conservative_y_A_y2_conjA_y*A_y^2*conj(A_y) + i*conservative_y_A_y2_conjA_x*conj(A_x)*A_y^2 with A = B in
/// that frame
/// 62 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  Scalar lumps[27];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Complex conj_A_x = conjugate(A_x);
  const Scalar norm_A_x = norm_of(A_x);
  const Complex A_y = load_complex(amplitude, 1);
  const Complex conj_A_y = conjugate(A_y);
  const Scalar norm_A_y = norm_of(A_y);
  const Complex F = load_complex(forcing, 0);
  store_complex(derivative, 0, times_i(lumps[0] * (A_x * A_x * conj_A_y))
       + lumps[1] * (-Scalar(1.0)) * (A_x)
       + times_i(lumps[2] * (A_x * norm_A_y))
       + times_i(lumps[3] * (norm_A_x * A_x))
       + times_i(lumps[4] * (-Scalar(1.0) / (Scalar(4.0) * omega1)) * (F))
       + times_i(lumps[5] * (norm_A_y * A_y))
       + times_i(lumps[6] * (norm_A_x * A_y))
       + times_i(lumps[7] * (conj_A_x * A_y * A_y))
       - times_i((-omega1 + excitation_frequency[0]) * A_x));
  store_complex(derivative, 1, times_i(lumps[2] * omega1 / omega2 * (norm_A_x * A_y))
       + times_i(lumps[8] * (A_x * A_x * conj_A_y))
       + times_i(lumps[9] * (A_x * norm_A_y))
       + times_i(lumps[10] * (norm_A_x * A_x))
       + times_i(lumps[11] * (-Scalar(1.0) / (Scalar(4.0) * omega2)) * (F))
       + lumps[12] * (-Scalar(1.0)) * (A_y)
       + times_i(lumps[13] * (norm_A_y * A_y))
       + times_i(lumps[14] * (conj_A_x * A_y * A_y))
       - times_i((-omega2 + excitation_frequency[0]) * A_y));
}

/// jacobian[i * 4 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 106 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  Scalar lumps[27];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Complex conj_A_x = conjugate(A_x);
  const Scalar norm_A_x = norm_of(A_x);
  const Complex A_y = load_complex(amplitude, 1);
  const Complex conj_A_y = conjugate(A_y);
  const Scalar norm_A_y = norm_of(A_y);
  for (std::size_t i = 0; i < 16; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = times_i(lumps[0] * Scalar(2) * (A_x * conj_A_y))
       + Complex(lumps[1] * (-Scalar(1.0)))
       + times_i(Complex(lumps[2] * (norm_A_y)))
       + times_i(Complex(lumps[3] * Scalar(2) * (norm_A_x)))
       + times_i(lumps[6] * (conj_A_x * A_y))
       - Complex(Scalar(0.0), -omega1 + excitation_frequency[0]);
  const Complex conj_by_0_0 = times_i(lumps[3] * (A_x * A_x))
       + times_i(lumps[6] * (A_x * A_y))
       + times_i(lumps[7] * (A_y * A_y));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[4] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[5] = by_0_0.real - conj_by_0_0.real;
  const Complex by_0_1 = times_i(lumps[2] * (A_x * conj_A_y))
       + times_i(Complex(lumps[5] * Scalar(2) * (norm_A_y)))
       + times_i(Complex(lumps[6] * (norm_A_x)))
       + times_i(lumps[7] * Scalar(2) * (conj_A_x * A_y));
  const Complex conj_by_0_1 = times_i(lumps[0] * (A_x * A_x))
       + times_i(lumps[2] * (A_x * A_y))
       + times_i(lumps[5] * (A_y * A_y));
  jacobian[2] = by_0_1.real + conj_by_0_1.real;
  jacobian[3] = conj_by_0_1.imag - by_0_1.imag;
  jacobian[6] = by_0_1.imag + conj_by_0_1.imag;
  jacobian[7] = by_0_1.real - conj_by_0_1.real;
  const Complex by_1_0 = times_i(lumps[2] * omega1 / omega2 * (conj_A_x * A_y))
       + times_i(lumps[8] * Scalar(2) * (A_x * conj_A_y))
       + times_i(Complex(lumps[9] * (norm_A_y)))
       + times_i(Complex(lumps[10] * Scalar(2) * (norm_A_x)));
  const Complex conj_by_1_0 = times_i(lumps[2] * omega1 / omega2 * (A_x * A_y))
       + times_i(lumps[10] * (A_x * A_x))
       + times_i(lumps[14] * (A_y * A_y));
  jacobian[8] = by_1_0.real + conj_by_1_0.real;
  jacobian[9] = conj_by_1_0.imag - by_1_0.imag;
  jacobian[12] = by_1_0.imag + conj_by_1_0.imag;
  jacobian[13] = by_1_0.real - conj_by_1_0.real;
  const Complex by_1_1 = times_i(Complex(lumps[2] * omega1 / omega2 * (norm_A_x)))
       + times_i(lumps[9] * (A_x * conj_A_y))
       + Complex(lumps[12] * (-Scalar(1.0)))
       + times_i(Complex(lumps[13] * Scalar(2) * (norm_A_y)))
       + times_i(lumps[14] * Scalar(2) * (conj_A_x * A_y))
       - Complex(Scalar(0.0), -omega2 + excitation_frequency[0]);
  const Complex conj_by_1_1 = times_i(lumps[8] * (A_x * A_x))
       + times_i(lumps[9] * (A_x * A_y))
       + times_i(lumps[13] * (A_y * A_y));
  jacobian[10] = by_1_1.real + conj_by_1_1.real;
  jacobian[11] = conj_by_1_1.imag - by_1_1.imag;
  jacobian[14] = by_1_1.imag + conj_by_1_1.imag;
  jacobian[15] = by_1_1.real - conj_by_1_1.real;
}

}  // namespace one_to_one

namespace one_to_two {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: mu1 = mu1
/// lumps[1]: conservative_x_A_x = -mu1^2/(2*omega1)
/// lumps[3]: conservative_x_A_x2_conjA_x = (18*omega1^2*omega2^2*b1 - 24*omega1^2*a2^2 - 3*omega1*omega2*a2^2 -
/// 20*omega2^2*a1^2)/(12*omega1^3*omega2^2)
/// lumps[4]: dissipative_x_A_y_conjA_x = a2*mu2/(2*omega1^2)
/// lumps[5]: a2 = a2
/// lumps[7]: dissipative_y_A_x2 = (2*a2*mu1 - a2*mu2)/(4*omega2^2)
/// lumps[8]: mu2 = mu2
/// lumps[9]: conservative_y_A_y = -mu2^2/(2*omega2)
/// lumps[12]: dissipative_y_F = mu2*e2/(8*omega2^2)
/// lumps[13]: e2 = e2
/// lumps[14]: a3 = a3
/// lumps[15]: a1 = a1
/// lumps[18]: e1 = e1
/// lumps[22]: harmonic_im_x_A_x2 = -4*a1*mu1/(9*omega1^3)
/// lumps[34]: a4 = a4
/// lumps[37]: harmonic_re_y_A_x2_A_y = -4*a2*a4/(9*omega2^4)
/// lumps[38]: harmonic_im_y_A_y2 = -4*a4*mu2/(9*omega2^3)
/// lumps[39]: harmonic_re_y_A_y_F = 2*a4*e2/(9*omega2^4)
/// 48 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b1 = parameters[6];
  const Scalar mu1 = parameters[11];
  const Scalar e1 = parameters[12];
  const Scalar mu2 = parameters[13];
  const Scalar e2 = parameters[14];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar a1_2 = a1 * a1;
  const Scalar a2_2 = a2 * a2;
  const Scalar mu1_2 = mu1 * mu1;
  const Scalar mu2_2 = mu2 * mu2;
  lumps[0] = mu1;  // mu1
  lumps[1] = -mu1_2 / (Scalar(2.0) * omega1);  // conservative_x_A_x
  lumps[2] = lump_19(parameters, static_cast<Scalar*>(nullptr));  // conservative_x_A_x_A_y_conjA_y
  // conservative_x_A_x2_conjA_x
  lumps[3] = (Scalar(18.0) * omega1_2 * omega2_2 * b1 - Scalar(24.0) * omega1_2 * a2_2
      - Scalar(3.0) * omega1 * omega2 * a2_2
      - Scalar(20.0) * omega2_2 * a1_2) / (Scalar(12.0) * omega1_3 * omega2_2);
  lumps[4] = a2 * mu2 / (Scalar(2.0) * omega1_2);  // dissipative_x_A_y_conjA_x
  lumps[5] = a2;  // a2
  lumps[6] = lump_20(parameters, static_cast<Scalar*>(nullptr));  // conservative_x_conjA_x_F
  lumps[7] = (Scalar(2.0) * a2 * mu1 - a2 * mu2) / (Scalar(4.0) * omega2_2);  // dissipative_y_A_x2
  lumps[8] = mu2;  // mu2
  lumps[9] = -mu2_2 / (Scalar(2.0) * omega2);  // conservative_y_A_y
  lumps[10] = lump_9(parameters, static_cast<Scalar*>(nullptr));  // conservative_y_A_y2_conjA_y
  lumps[11] = lump_21(parameters, static_cast<Scalar*>(nullptr));  // conservative_y_A_x_A_y_conjA_x
  lumps[12] = mu2 * e2 / (Scalar(8.0) * omega2_2);  // dissipative_y_F
  lumps[13] = e2;  // e2
  lumps[14] = a3;  // a3
  lumps[15] = a1;  // a1
  lumps[16] = lump_22(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_y_conjA_x2
  lumps[17] = lump_23(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_conjA_y_F
  lumps[18] = e1;  // e1
  lumps[19] = lump_24(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_x_F
  lumps[20] = lump_25(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_y2_conjA_y
  lumps[21] = lump_26(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_x_A_y_conjA_x
  lumps[22] = -Scalar(4.0) * a1 * mu1 / (Scalar(9.0) * omega1_3);  // harmonic_im_x_A_x2
  lumps[23] = lump_27(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_x2_A_y
  lumps[24] = lump_28(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_x_A_y2
  lumps[25] = lump_29(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_y_F
  lumps[26] = lump_30(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_y2_conjA_x
  lumps[27] = lump_31(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_x_F
  lumps[28] = lump_32(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_x3
  lumps[29] = lump_11(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_y3
  lumps[30] = lump_12(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_x_A_y2
  lumps[31] = lump_33(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_y_A_y_conjA_x
  lumps[32] = lump_34(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_x_A_y_conjA_y
  lumps[33] = lump_35(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_x2_conjA_x
  lumps[34] = a4;  // a4
  lumps[35] = lump_36(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_y_conjA_x2
  lumps[36] = lump_37(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_conjA_y_F
  lumps[37] = -Scalar(4.0) * a2 * a4 / (Scalar(9.0) * omega2_4);  // harmonic_re_y_A_x2_A_y
  lumps[38] = -Scalar(4.0) * a4 * mu2 / (Scalar(9.0) * omega2_3);  // harmonic_im_y_A_y2
  lumps[39] = Scalar(2.0) * a4 * e2 / (Scalar(9.0) * omega2_4);  // harmonic_re_y_A_y_F
  lumps[40] = lump_38(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_y2_conjA_x
  lumps[41] = lump_39(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_x3
  lumps[42] = lump_15(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_y3
  lumps[43] = lump_16(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_x_A_y2
}

/// jacobian[l * 15 + p] = d lumps[l] / d parameters[p]. 107 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a4 = parameters[5];
  const Scalar b1 = parameters[6];
  const Scalar mu1 = parameters[11];
  const Scalar mu2 = parameters[13];
  const Scalar e2 = parameters[14];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar a1_2 = a1 * a1;
  const Scalar a2_2 = a2 * a2;
  const Scalar mu1_2 = mu1 * mu1;
  const Scalar mu2_2 = mu2 * mu2;
  for (std::size_t i = 0; i < 660; ++i) jacobian[i] = Scalar(0.0);
  jacobian[11] = Scalar(1.0);  // d mu1 / d mu1
  jacobian[15] = mu1_2 / (Scalar(2.0) * omega1_2);  // d conservative_x_A_x / d omega1
  jacobian[26] = -mu1 / omega1;  // d conservative_x_A_x / d mu1
  lump_19(parameters, jacobian + 30);  // d conservative_x_A_x_A_y_conjA_y
  // d conservative_x_A_x2_conjA_x / d omega1
  jacobian[45] = (-Scalar(3.0) * omega1_2 * omega2_2 * b1 + Scalar(4.0) * omega1_2 * a2_2 + omega1 * omega2 * a2_2
      + Scalar(10.0) * omega2_2 * a1_2) / (Scalar(2.0) * omega1_4 * omega2_2);
  // d conservative_x_A_x2_conjA_x / d omega2
  jacobian[46] = (Scalar(16.0) * omega1 * a2_2 + omega2 * a2_2) / (Scalar(4.0) * omega1_2 * omega2_3);
  jacobian[47] = -Scalar(10.0) * a1 / (Scalar(3.0) * omega1_3);  // d conservative_x_A_x2_conjA_x / d a1
  // d conservative_x_A_x2_conjA_x / d a2
  jacobian[48] = (-Scalar(8.0) * omega1 * a2 - omega2 * a2) / (Scalar(2.0) * omega1_2 * omega2_2);
  jacobian[51] = Scalar(3.0) / (Scalar(2.0) * omega1);  // d conservative_x_A_x2_conjA_x / d b1
  jacobian[60] = -a2 * mu2 / omega1_3;  // d dissipative_x_A_y_conjA_x / d omega1
  jacobian[63] = mu2 / (Scalar(2.0) * omega1_2);  // d dissipative_x_A_y_conjA_x / d a2
  jacobian[73] = a2 / (Scalar(2.0) * omega1_2);  // d dissipative_x_A_y_conjA_x / d mu2
  jacobian[78] = Scalar(1.0);  // d a2 / d a2
  lump_20(parameters, jacobian + 90);  // d conservative_x_conjA_x_F
  // d dissipative_y_A_x2 / d omega2
  jacobian[106] = (-Scalar(2.0) * a2 * mu1 + a2 * mu2) / (Scalar(2.0) * omega2_3);
  jacobian[108] = (Scalar(2.0) * mu1 - mu2) / (Scalar(4.0) * omega2_2);  // d dissipative_y_A_x2 / d a2
  jacobian[116] = a2 / (Scalar(2.0) * omega2_2);  // d dissipative_y_A_x2 / d mu1
  jacobian[118] = -a2 / (Scalar(4.0) * omega2_2);  // d dissipative_y_A_x2 / d mu2
  jacobian[133] = Scalar(1.0);  // d mu2 / d mu2
  jacobian[136] = mu2_2 / (Scalar(2.0) * omega2_2);  // d conservative_y_A_y / d omega2
  jacobian[148] = -mu2 / omega2;  // d conservative_y_A_y / d mu2
  lump_9(parameters, jacobian + 150);  // d conservative_y_A_y2_conjA_y
  lump_21(parameters, jacobian + 165);  // d conservative_y_A_x_A_y_conjA_x
  jacobian[181] = -mu2 * e2 / (Scalar(4.0) * omega2_3);  // d dissipative_y_F / d omega2
  jacobian[193] = e2 / (Scalar(8.0) * omega2_2);  // d dissipative_y_F / d mu2
  jacobian[194] = mu2 / (Scalar(8.0) * omega2_2);  // d dissipative_y_F / d e2
  jacobian[209] = Scalar(1.0);  // d e2 / d e2
  jacobian[214] = Scalar(1.0);  // d a3 / d a3
  jacobian[227] = Scalar(1.0);  // d a1 / d a1
  lump_22(parameters, jacobian + 240);  // d harmonic_re_x_A_y_conjA_x2
  lump_23(parameters, jacobian + 255);  // d harmonic_re_x_conjA_y_F
  jacobian[282] = Scalar(1.0);  // d e1 / d e1
  lump_24(parameters, jacobian + 285);  // d harmonic_im_x_F
  lump_25(parameters, jacobian + 300);  // d harmonic_re_x_A_y2_conjA_y
  lump_26(parameters, jacobian + 315);  // d harmonic_re_x_A_x_A_y_conjA_x
  jacobian[330] = Scalar(4.0) * a1 * mu1 / (Scalar(3.0) * omega1_4);  // d harmonic_im_x_A_x2 / d omega1
  jacobian[332] = -Scalar(4.0) * mu1 / (Scalar(9.0) * omega1_3);  // d harmonic_im_x_A_x2 / d a1
  jacobian[341] = -Scalar(4.0) * a1 / (Scalar(9.0) * omega1_3);  // d harmonic_im_x_A_x2 / d mu1
  lump_27(parameters, jacobian + 345);  // d harmonic_re_x_A_x2_A_y
  lump_28(parameters, jacobian + 360);  // d harmonic_im_x_A_y2
  lump_29(parameters, jacobian + 375);  // d harmonic_re_x_A_y_F
  lump_30(parameters, jacobian + 390);  // d harmonic_re_x_A_y2_conjA_x
  lump_31(parameters, jacobian + 405);  // d harmonic_re_x_A_x_F
  lump_32(parameters, jacobian + 420);  // d harmonic_re_x_A_x3
  lump_11(parameters, jacobian + 435);  // d harmonic_re_x_A_y3
  lump_12(parameters, jacobian + 450);  // d harmonic_re_x_A_x_A_y2
  lump_33(parameters, jacobian + 465);  // d harmonic_im_y_A_y_conjA_x
  lump_34(parameters, jacobian + 480);  // d harmonic_re_y_A_x_A_y_conjA_y
  lump_35(parameters, jacobian + 495);  // d harmonic_re_y_A_x2_conjA_x
  jacobian[515] = Scalar(1.0);  // d a4 / d a4
  lump_36(parameters, jacobian + 525);  // d harmonic_re_y_A_y_conjA_x2
  lump_37(parameters, jacobian + 540);  // d harmonic_re_y_conjA_y_F
  jacobian[556] = Scalar(16.0) * a2 * a4 / (Scalar(9.0) * omega2_5);  // d harmonic_re_y_A_x2_A_y / d omega2
  jacobian[558] = -Scalar(4.0) * a4 / (Scalar(9.0) * omega2_4);  // d harmonic_re_y_A_x2_A_y / d a2
  jacobian[560] = -Scalar(4.0) * a2 / (Scalar(9.0) * omega2_4);  // d harmonic_re_y_A_x2_A_y / d a4
  jacobian[571] = Scalar(4.0) * a4 * mu2 / (Scalar(3.0) * omega2_4);  // d harmonic_im_y_A_y2 / d omega2
  jacobian[575] = -Scalar(4.0) * mu2 / (Scalar(9.0) * omega2_3);  // d harmonic_im_y_A_y2 / d a4
  jacobian[583] = -Scalar(4.0) * a4 / (Scalar(9.0) * omega2_3);  // d harmonic_im_y_A_y2 / d mu2
  jacobian[586] = -Scalar(8.0) * a4 * e2 / (Scalar(9.0) * omega2_5);  // d harmonic_re_y_A_y_F / d omega2
  jacobian[590] = Scalar(2.0) * e2 / (Scalar(9.0) * omega2_4);  // d harmonic_re_y_A_y_F / d a4
  jacobian[599] = Scalar(2.0) * a4 / (Scalar(9.0) * omega2_4);  // d harmonic_re_y_A_y_F / d e2
  lump_38(parameters, jacobian + 600);  // d harmonic_re_y_A_y2_conjA_x
  lump_39(parameters, jacobian + 615);  // d harmonic_re_y_A_x3
  lump_15(parameters, jacobian + 630);  // d harmonic_re_y_A_y3
  lump_16(parameters, jacobian + 645);  // d harmonic_re_y_A_x_A_y2
}

/// What multiplies the 8 terms of the modulation of x: functions of the frequencies alone. 6 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  factor[0] = -Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0) / omega1;
  factor[6] = (Scalar(2.0) * omega1 - omega2) / (Scalar(2.0) * omega1_2);
  factor[7] = Scalar(1.0);
}

/// Rows of the modulation of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega1)*A_x = -mu1*A_x + i*conservative_x_A_x*A_x +
/// i*conservative_x_A_x_A_y_conjA_y*A_x*A_y*conj(A_y) + i*conservative_x_A_x2_conjA_x*A_x^2*conj(A_x) +
/// dissipative_x_A_y_conjA_x*conj(A_x)*A_y + 1/omega1*i*a2*conj(A_x)*A_y + (2*omega1 -
/// omega2)/(2*omega1^2)*i*a2*conj(A_x)*A_y + i*conservative_x_conjA_x_F*conj(A_x)*F
/// 7 columns; per observation at most 21 products and sums of complex numbers.
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
    store_complex(column_0, i, factor[0] * (A_x));  // mu1
    store_complex(column_1, i, times_i(factor[1] * (A_x)));  // conservative_x_A_x
    store_complex(column_2, i, times_i(factor[2] * (A_x * norm_A_y)));  // conservative_x_A_x_A_y_conjA_y
    store_complex(column_3, i, times_i(factor[3] * (norm_A_x * A_x)));  // conservative_x_A_x2_conjA_x
    store_complex(column_4, i, factor[4] * (conj_A_x * A_y));  // dissipative_x_A_y_conjA_x
    // a2
    store_complex(column_5, i, times_i(factor[5] * (conj_A_x * A_y)) + times_i(factor[6] * (conj_A_x * A_y)));
    store_complex(column_6, i, times_i(factor[7] * (conj_A_x * F)));  // conservative_x_conjA_x_F
  }
}

/// columns[j][i] of the rows.
inline void columns_0(const BatchArrays& data, double* const* columns) {
  rows_0(data, FactorValues<factors_0<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_0(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_0(data, FactorSlopes<factors_0<DualNumber>, 2, 1, 8>{mode}, columns);
}

/// What multiplies the 10 terms of the modulation of y: functions of the frequencies alone. 12 operations.
template <class Scalar>
void factors_1([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega2_2 = omega2 * omega2;
  factor[0] = Scalar(1.0) / (Scalar(2.0) * omega2);
  factor[1] = (-Scalar(2.0) * omega1 + omega2) / (Scalar(4.0) * omega2_2);
  factor[2] = Scalar(1.0);
  factor[3] = -Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
  factor[6] = Scalar(1.0);
  factor[7] = Scalar(1.0);
  factor[8] = -Scalar(1.0) / (Scalar(4.0) * omega2);
  factor[9] = (-omega2 + Omega) / (Scalar(8.0) * omega2_2);
}

/// Rows of the modulation of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega2)*A_y = 1/(2*omega2)*i*a2*A_x^2 + (-2*omega1 + omega2)/(4*omega2^2)*i*a2*A_x^2 +
/// dissipative_y_A_x2*A_x^2 - mu2*A_y + i*conservative_y_A_y*A_y + i*conservative_y_A_y2_conjA_y*A_y^2*conj(A_y)
/// + i*conservative_y_A_x_A_y_conjA_x*A_x*conj(A_x)*A_y + dissipative_y_F*F - 1/(4*omega2)*i*e2*F + (-omega2 +
/// Omega)/(8*omega2^2)*i*e2*F
/// 8 columns; per observation at most 22 products and sums of complex numbers.
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
  Scalar factor[10];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Scalar norm_A_y = norm_of(A_y);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, times_i(factor[0] * (A_x * A_x)) + times_i(factor[1] * (A_x * A_x)));  // a2
    store_complex(column_1, i, factor[2] * (A_x * A_x));  // dissipative_y_A_x2
    store_complex(column_2, i, factor[3] * (A_y));  // mu2
    store_complex(column_3, i, times_i(factor[4] * (A_y)));  // conservative_y_A_y
    store_complex(column_4, i, times_i(factor[5] * (norm_A_y * A_y)));  // conservative_y_A_y2_conjA_y
    store_complex(column_5, i, times_i(factor[6] * (norm_A_x * A_y)));  // conservative_y_A_x_A_y_conjA_x
    store_complex(column_6, i, factor[7] * (F));  // dissipative_y_F
    store_complex(column_7, i, times_i(factor[8] * (F)) + times_i(factor[9] * (F)));  // e2
  }
}

/// columns[j][i] of the rows.
inline void columns_1(const BatchArrays& data, double* const* columns) {
  rows_1(data, FactorValues<factors_1<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_1(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_1(data, FactorSlopes<factors_1<DualNumber>, 2, 1, 10>{mode}, columns);
}

/// What multiplies the 6 terms of the harmonic 0 of x: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_2([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  factor[0] = -Scalar(2.0) / omega1_2;
  factor[1] = -Scalar(2.0) / omega1_2;
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
}

/// Rows of the harmonic 0 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in x = -2/omega1^2*a3*A_y*conj(A_y) - 2/omega1^2*a1*A_x*conj(A_x) +
/// harmonic_re_x_A_y_conjA_x2*conj(A_x)^2*A_y + harmonic_re_x_A_y_conjA_x2*A_x^2*conj(A_y) +
/// harmonic_re_x_conjA_y_F*conj(A_y)*F + harmonic_re_x_conjA_y_F*A_y*F
/// 4 columns; per observation at most 20 products and sums of complex numbers.
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
  Scalar factor[6];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Complex conj_A_y = conjugate(A_y);
    const Scalar norm_A_y = norm_of(A_y);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    store_complex(column_0, i, Complex(factor[0] * (norm_A_y)));  // a3
    store_complex(column_1, i, Complex(factor[1] * (norm_A_x)));  // a1
    // harmonic_re_x_A_y_conjA_x2
    store_complex(column_2, i, factor[2] * (conj_A_x * conj_A_x * A_y) + factor[3] * (A_x * A_x * conj_A_y));
    // harmonic_re_x_conjA_y_F
    store_complex(column_3, i, factor[4] * (conj_A_y * F) + factor[5] * (A_y * conj_F));
  }
}

/// columns[j][i] of the rows.
inline void columns_2(const BatchArrays& data, double* const* columns) {
  rows_2(data, FactorValues<factors_2<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_2(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_2(data, FactorSlopes<factors_2<DualNumber>, 2, 1, 6>{mode}, columns);
}

/// What multiplies the 8 terms of the harmonic Omega of x: functions of the frequencies alone. 16 operations.
template <class Scalar>
void factors_3([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1_2 = per_1 * per_1;
  factor[0] = Scalar(1.0) / (Scalar(3.0) * omega1_2);
  factor[1] = per_0 * per_1 / Scalar(2.0);
  factor[2] = (-omega2_2 + omega2 * Omega) * per_0_2 * per_1_2;
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
  factor[6] = Scalar(1.0);
  factor[7] = Scalar(1.0);
}

/// Rows of the harmonic Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(Omega)*t) in x = 1/(3*omega1^2)*a1*A_x^2 + 1/(2*(omega1 + omega2)*(omega1 - omega2))*e1*F
/// + (-omega2^2 + omega2*Omega)/((omega1 + omega2)^2*(omega1 - omega2)^2)*e1*F + i*harmonic_im_x_F*F +
/// harmonic_re_x_A_y2_conjA_y*A_y^2*conj(A_y) + harmonic_re_x_A_x_A_y_conjA_x*A_x*conj(A_x)*A_y +
/// harmonic_re_x_A_x_A_y_conjA_x*A_x*conj(A_x)*A_y + i*harmonic_im_x_A_x2*A_x^2
/// 6 columns; per observation at most 20 products and sums of complex numbers.
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
  Scalar factor[8];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Scalar norm_A_y = norm_of(A_y);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_x * A_x));  // a1
    store_complex(column_1, i, factor[1] * (F) + factor[2] * (F));  // e1
    store_complex(column_2, i, times_i(factor[3] * (F)));  // harmonic_im_x_F
    store_complex(column_3, i, factor[4] * (norm_A_y * A_y));  // harmonic_re_x_A_y2_conjA_y
    // harmonic_re_x_A_x_A_y_conjA_x
    store_complex(column_4, i, factor[5] * (norm_A_x * A_y) + factor[6] * (norm_A_x * A_y));
    store_complex(column_5, i, times_i(factor[7] * (A_x * A_x)));  // harmonic_im_x_A_x2
  }
}

/// columns[j][i] of the rows.
inline void columns_3(const BatchArrays& data, double* const* columns) {
  rows_3(data, FactorValues<factors_3<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_3(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_3(data, FactorSlopes<factors_3<DualNumber>, 2, 1, 8>{mode}, columns);
}

/// What multiplies the 6 terms of the harmonic omega2+Omega of x: functions of the frequencies alone. 27
/// operations.
template <class Scalar>
void factors_4([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2 + Omega);
  const Scalar per_3 = Scalar(1.0) / (omega1 - omega2 - Omega);
  const Scalar per_4 = Scalar(1.0) / (omega1 + Omega);
  const Scalar per_5 = Scalar(1.0) / (omega1 - Omega);
  factor[0] = -per_0 * per_1;
  factor[1] = (omega1_4 - omega1_2 * omega2_2) * per_2 * per_3 * per_4 * per_5;
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
}

/// Rows of the harmonic omega2+Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + Omega)*t) in x = -1/((omega1 + 2*omega2)*(omega1 - 2*omega2))*a3*A_y^2 +
/// (omega1^4 - omega1^2*omega2^2)/((omega1 + omega2 + Omega)*(omega1 - omega2 - Omega)*(omega1 + Omega)*(omega1
/// - Omega))*harmonic_re_x_conjA_y_F*A_y*F + harmonic_re_x_A_x2_A_y*A_x^2*A_y + harmonic_re_x_A_x2_A_y*A_x^2*A_y
/// + i*harmonic_im_x_A_y2*A_y^2 + harmonic_re_x_A_y_F*A_y*F
/// 5 columns; per observation at most 23 products and sums of complex numbers.
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
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex A_y = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_y * A_y));  // a3
    store_complex(column_1, i, factor[1] * (A_y * F));  // harmonic_re_x_conjA_y_F
    // harmonic_re_x_A_x2_A_y
    store_complex(column_2, i, factor[2] * (A_x * A_x * A_y) + factor[3] * (A_x * A_x * A_y));
    store_complex(column_3, i, times_i(factor[4] * (A_y * A_y)));  // harmonic_im_x_A_y2
    store_complex(column_4, i, factor[5] * (A_y * F));  // harmonic_re_x_A_y_F
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

/// What multiplies the 8 terms of the harmonic omega1+Omega of x: functions of the frequencies alone. 17
/// operations.
template <class Scalar>
void factors_5([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_0_2 = per_0 * per_0;
  factor[0] = (-Scalar(8.0) * omega1_3 - Scalar(8.0) * omega1_2 * omega2) * per_0_2 / omega2_2;
  factor[1] = Scalar(2.0) * per_0 / omega2;
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
  factor[6] = Scalar(2.0) * omega2 / omega1;
  factor[7] = Scalar(1.0);
}

/// Rows of the harmonic omega1+Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + Omega)*t) in x = (-8*omega1^3 - 8*omega1^2*omega2)/(omega2^2*(2*omega1 +
/// omega2)^2)*i*dissipative_x_A_y_conjA_x*A_x*A_y + 2/(omega2*(2*omega1 + omega2))*a2*A_x*A_y +
/// harmonic_re_x_A_y2_conjA_x*conj(A_x)*A_y^2 + harmonic_re_x_A_x_F*A_x*F + harmonic_re_x_A_x_F*A_x*F +
/// harmonic_re_x_A_x3*A_x^3 + 2*omega2/omega1*harmonic_re_x_A_x3*conj(A_x)*A_y^2 + harmonic_re_x_A_x3*A_x^3
/// 5 columns; per observation at most 35 products and sums of complex numbers.
template <class Factors>
void rows_5(const BatchArrays& data, Factors factors, double* const* columns) {
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
  Scalar factor[8];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, times_i(factor[0] * (A_x * A_y)));  // dissipative_x_A_y_conjA_x
    store_complex(column_1, i, factor[1] * (A_x * A_y));  // a2
    store_complex(column_2, i, factor[2] * (conj_A_x * A_y * A_y));  // harmonic_re_x_A_y2_conjA_x
    store_complex(column_3, i, factor[3] * (A_x * F) + factor[4] * (A_x * F));  // harmonic_re_x_A_x_F
    // harmonic_re_x_A_x3
    store_complex(column_4, i, factor[5] * (A_x * A_x * A_x) + factor[6] * (conj_A_x * A_y * A_y)
        + factor[7] * (A_x * A_x * A_x));
  }
}

/// columns[j][i] of the rows.
inline void columns_5(const BatchArrays& data, double* const* columns) {
  rows_5(data, FactorValues<factors_5<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_5(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_5(data, FactorSlopes<factors_5<DualNumber>, 2, 1, 8>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 3*omega2 of x: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_6([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic 3*omega2 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega2)*t) in x = harmonic_re_x_A_y3*A_y^3
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
    store_complex(column_0, i, factor[0] * (A_y * A_y * A_y));  // harmonic_re_x_A_y3
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

/// What multiplies the 1 terms of the harmonic omega1+2*omega2 of x: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_7([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic omega1+2*omega2 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + 2*omega2)*t) in x = harmonic_re_x_A_x_A_y2*A_x*A_y^2
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
    store_complex(column_0, i, factor[0] * (A_x * A_y * A_y));  // harmonic_re_x_A_x_A_y2
  }
}

/// columns[j][i] of the rows.
inline void columns_7(const BatchArrays& data, double* const* columns) {
  rows_7(data, FactorValues<factors_7<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_7(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 8 terms of the harmonic omega1 of y: functions of the frequencies alone. 48 operations.
template <class Scalar>
void factors_8([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2 - Omega);
  const Scalar per_2 = Scalar(1.0) / (omega1 - omega2 - Omega);
  const Scalar per_3 = Scalar(1.0) / (omega1 + Omega);
  const Scalar per_4 = Scalar(1.0) / (omega1 - Omega);
  factor[0] = Scalar(2.0) * per_0 / omega1;
  factor[1] = (-omega1_4 + omega1_2 * omega2_2) * per_1 * per_2 * per_3 * per_4;
  factor[2] = (omega1_3 + Scalar(3.0) * omega1_2 * omega2 - Scalar(4.0) * omega2_3) / omega1_3;
  factor[3] = (-omega1_3 - Scalar(3.0) * omega1_2 * omega2
      + Scalar(4.0) * omega2_3) / (Scalar(2.0) * omega1_2 * omega2);
  factor[4] = (-omega1_3 - Scalar(3.0) * omega1_2 * omega2
      + Scalar(4.0) * omega2_3) / (Scalar(2.0) * omega1_2 * omega2);
  factor[5] = Scalar(1.0);
  factor[6] = Scalar(1.0);
  factor[7] = Scalar(1.0);
}

/// Rows of the harmonic omega1 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1)*t) in y = 2/(omega1*(omega1 - 2*omega2))*a3*conj(A_x)*A_y + (-omega1^4 +
/// omega1^2*omega2^2)/((omega1 + omega2 - Omega)*(omega1 - omega2 - Omega)*(omega1 + Omega)*(omega1 -
/// Omega))*harmonic_re_x_conjA_y_F*conj(A_x)*F + (omega1^3 + 3*omega1^2*omega2 -
/// 4*omega2^3)/omega1^3*harmonic_re_x_A_x2_A_y*A_x*A_y*conj(A_y) + (-omega1^3 - 3*omega1^2*omega2 +
/// 4*omega2^3)/(2*omega1^2*omega2)*harmonic_re_x_A_x2_A_y*A_x^2*conj(A_x) + (-omega1^3 - 3*omega1^2*omega2 +
/// 4*omega2^3)/(2*omega1^2*omega2)*harmonic_re_x_A_y_F*conj(A_x)*F + i*harmonic_im_y_A_y_conjA_x*conj(A_x)*A_y +
/// harmonic_re_y_A_x_A_y_conjA_y*A_x*A_y*conj(A_y) + harmonic_re_y_A_x2_conjA_x*A_x^2*conj(A_x)
/// 7 columns; per observation at most 25 products and sums of complex numbers.
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
  Scalar* __restrict column_3 = columns[3];
  Scalar* __restrict column_4 = columns[4];
  Scalar* __restrict column_5 = columns[5];
  Scalar* __restrict column_6 = columns[6];
  Scalar factor[8];
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
    store_complex(column_0, i, factor[0] * (conj_A_x * A_y));  // a3
    store_complex(column_1, i, factor[1] * (conj_A_x * F));  // harmonic_re_x_conjA_y_F
    // harmonic_re_x_A_x2_A_y
    store_complex(column_2, i, factor[2] * (A_x * norm_A_y) + factor[3] * (norm_A_x * A_x));
    store_complex(column_3, i, factor[4] * (conj_A_x * F));  // harmonic_re_x_A_y_F
    store_complex(column_4, i, times_i(factor[5] * (conj_A_x * A_y)));  // harmonic_im_y_A_y_conjA_x
    store_complex(column_5, i, factor[6] * (A_x * norm_A_y));  // harmonic_re_y_A_x_A_y_conjA_y
    store_complex(column_6, i, factor[7] * (norm_A_x * A_x));  // harmonic_re_y_A_x2_conjA_x
  }
}

/// columns[j][i] of the rows.
inline void columns_8(const BatchArrays& data, double* const* columns) {
  rows_8(data, FactorValues<factors_8<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_8(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_8(data, FactorSlopes<factors_8<DualNumber>, 2, 1, 8>{mode}, columns);
}

/// What multiplies the 6 terms of the harmonic 0 of y: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_9([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega2_2 = omega2 * omega2;
  factor[0] = -Scalar(2.0) / omega2_2;
  factor[1] = -Scalar(2.0) / omega2_2;
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
}

/// Rows of the harmonic 0 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in y = -2/omega2^2*a2*A_x*conj(A_x) - 2/omega2^2*a4*A_y*conj(A_y) +
/// harmonic_re_y_A_y_conjA_x2*conj(A_x)^2*A_y + harmonic_re_y_A_y_conjA_x2*A_x^2*conj(A_y) +
/// harmonic_re_y_conjA_y_F*conj(A_y)*F + harmonic_re_y_conjA_y_F*A_y*F
/// 4 columns; per observation at most 20 products and sums of complex numbers.
template <class Factors>
void rows_9(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar factor[6];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Complex conj_A_y = conjugate(A_y);
    const Scalar norm_A_y = norm_of(A_y);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    store_complex(column_0, i, Complex(factor[0] * (norm_A_x)));  // a2
    store_complex(column_1, i, Complex(factor[1] * (norm_A_y)));  // a4
    // harmonic_re_y_A_y_conjA_x2
    store_complex(column_2, i, factor[2] * (conj_A_x * conj_A_x * A_y) + factor[3] * (A_x * A_x * conj_A_y));
    // harmonic_re_y_conjA_y_F
    store_complex(column_3, i, factor[4] * (conj_A_y * F) + factor[5] * (A_y * conj_F));
  }
}

/// columns[j][i] of the rows.
inline void columns_9(const BatchArrays& data, double* const* columns) {
  rows_9(data, FactorValues<factors_9<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_9(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_9(data, FactorSlopes<factors_9<DualNumber>, 2, 1, 6>{mode}, columns);
}

/// What multiplies the 6 terms of the harmonic omega2+Omega of y: functions of the frequencies alone. 19
/// operations.
template <class Scalar>
void factors_10([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Omega);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Omega);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega2 + Omega);
  factor[0] = Scalar(1.0) / (Scalar(3.0) * omega2_2);
  factor[1] = (-omega1_2 * omega2_2 + omega2_4) * per_0 * per_1 * per_2 / Omega;
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
}

/// Rows of the harmonic omega2+Omega of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + Omega)*t) in y = 1/(3*omega2^2)*a4*A_y^2 + (-omega1^2*omega2^2 +
/// omega2^4)/(Omega*(omega1 + Omega)*(omega1 - Omega)*(2*omega2 + Omega))*harmonic_re_y_conjA_y_F*A_y*F +
/// harmonic_re_y_A_x2_A_y*A_x^2*A_y + harmonic_re_y_A_x2_A_y*A_x^2*A_y + i*harmonic_im_y_A_y2*A_y^2 +
/// harmonic_re_y_A_y_F*A_y*F
/// 5 columns; per observation at most 23 products and sums of complex numbers.
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
  Scalar factor[6];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex A_y = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_y * A_y));  // a4
    store_complex(column_1, i, factor[1] * (A_y * F));  // harmonic_re_y_conjA_y_F
    // harmonic_re_y_A_x2_A_y
    store_complex(column_2, i, factor[2] * (A_x * A_x * A_y) + factor[3] * (A_x * A_x * A_y));
    store_complex(column_3, i, times_i(factor[4] * (A_y * A_y)));  // harmonic_im_y_A_y2
    store_complex(column_4, i, factor[5] * (A_y * F));  // harmonic_re_y_A_y_F
  }
}

/// columns[j][i] of the rows.
inline void columns_10(const BatchArrays& data, double* const* columns) {
  rows_10(data, FactorValues<factors_10<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_10(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_10(data, FactorSlopes<factors_10<DualNumber>, 2, 1, 6>{mode}, columns);
}

/// What multiplies the 8 terms of the harmonic omega1+Omega of y: functions of the frequencies alone. 58
/// operations.
template <class Scalar>
void factors_11([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2 + Omega);
  const Scalar per_2 = Scalar(1.0) / (omega1 - omega2 + Omega);
  const Scalar per_3 = Scalar(1.0) / (omega1 + Omega);
  const Scalar per_4 = Scalar(1.0) / (omega1 - Omega);
  const Scalar per_5 = Scalar(1.0) / (omega1 - omega2);
  factor[0] = Scalar(2.0) * per_0 / omega1;
  factor[1] = (-omega1_4 + omega1_2 * omega2_2) * per_1 * per_2 * per_3 * per_4;
  factor[2] = (omega1_3 - Scalar(3.0) * omega1_2 * omega2
      + Scalar(4.0) * omega2_3) / (Scalar(2.0) * omega1_2 * omega2);
  factor[3] = (omega1_3 - Scalar(3.0) * omega1_2 * omega2 + Scalar(4.0) * omega2_3) / omega1_3;
  factor[4] = (omega1_3 - Scalar(3.0) * omega1_2 * omega2
      + Scalar(4.0) * omega2_3) / (Scalar(2.0) * omega1_2 * omega2);
  factor[5] = (-omega1_3 + Scalar(3.0) * omega1_2 * omega2 - Scalar(4.0) * omega2_3) * per_0_2 * per_5;
  factor[6] = Scalar(1.0);
  factor[7] = Scalar(1.0);
}

/// Rows of the harmonic omega1+Omega of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + Omega)*t) in y = 2/(omega1*(omega1 + 2*omega2))*a3*A_x*A_y + (-omega1^4 +
/// omega1^2*omega2^2)/((omega1 + omega2 + Omega)*(omega1 - omega2 + Omega)*(omega1 + Omega)*(omega1 -
/// Omega))*harmonic_re_x_conjA_y_F*A_x*F + (omega1^3 - 3*omega1^2*omega2 +
/// 4*omega2^3)/(2*omega1^2*omega2)*harmonic_re_x_A_x2_A_y*A_x^3 + (omega1^3 - 3*omega1^2*omega2 +
/// 4*omega2^3)/omega1^3*harmonic_re_x_A_x2_A_y*conj(A_x)*A_y^2 + (omega1^3 - 3*omega1^2*omega2 +
/// 4*omega2^3)/(2*omega1^2*omega2)*harmonic_re_x_A_y_F*A_x*F + (-omega1^3 + 3*omega1^2*omega2 -
/// 4*omega2^3)/((omega1 + 2*omega2)^2*(omega1 - omega2))*i*harmonic_im_y_A_y_conjA_x*A_x*A_y +
/// harmonic_re_y_A_y2_conjA_x*conj(A_x)*A_y^2 + harmonic_re_y_A_x3*A_x^3
/// 7 columns; per observation at most 33 products and sums of complex numbers.
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
  Scalar* __restrict column_5 = columns[5];
  Scalar* __restrict column_6 = columns[6];
  Scalar factor[8];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_x * A_y));  // a3
    store_complex(column_1, i, factor[1] * (A_x * F));  // harmonic_re_x_conjA_y_F
    // harmonic_re_x_A_x2_A_y
    store_complex(column_2, i, factor[2] * (A_x * A_x * A_x) + factor[3] * (conj_A_x * A_y * A_y));
    store_complex(column_3, i, factor[4] * (A_x * F));  // harmonic_re_x_A_y_F
    store_complex(column_4, i, times_i(factor[5] * (A_x * A_y)));  // harmonic_im_y_A_y_conjA_x
    store_complex(column_5, i, factor[6] * (conj_A_x * A_y * A_y));  // harmonic_re_y_A_y2_conjA_x
    store_complex(column_6, i, factor[7] * (A_x * A_x * A_x));  // harmonic_re_y_A_x3
  }
}

/// columns[j][i] of the rows.
inline void columns_11(const BatchArrays& data, double* const* columns) {
  rows_11(data, FactorValues<factors_11<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_11(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_11(data, FactorSlopes<factors_11<DualNumber>, 2, 1, 8>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 3*omega2 of y: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_12([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic 3*omega2 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega2)*t) in y = harmonic_re_y_A_y3*A_y^3
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_12(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_y = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_y * A_y * A_y));  // harmonic_re_y_A_y3
  }
}

/// columns[j][i] of the rows.
inline void columns_12(const BatchArrays& data, double* const* columns) {
  rows_12(data, FactorValues<factors_12<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_12(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic omega1+2*omega2 of y: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_13([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic omega1+2*omega2 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + 2*omega2)*t) in y = harmonic_re_y_A_x_A_y2*A_x*A_y^2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
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
    const Complex A_y = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_x * A_y * A_y));  // harmonic_re_y_A_x_A_y2
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

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_x/dt + i*(w_x - omega1)*B_x = -mu1*A_x + i*conservative_x_A_x*A_x +
/// i*conservative_x_A_x_A_y_conjA_y*A_x*A_y*conj(A_y) + i*conservative_x_A_x2_conjA_x*A_x^2*conj(A_x) +
/// dissipative_x_A_y_conjA_x*conj(A_x)*A_y + 1/omega1*i*a2*conj(A_x)*A_y + (2*omega1 -
/// omega2)/(2*omega1^2)*i*a2*conj(A_x)*A_y + i*conservative_x_conjA_x_F*conj(A_x)*F with A = B in that frame
/// dB_y/dt + i*(w_y - omega2)*B_y = 1/(2*omega2)*i*a2*A_x^2 + (-2*omega1 + omega2)/(4*omega2^2)*i*a2*A_x^2 +
/// dissipative_y_A_x2*A_x^2 - mu2*A_y + i*conservative_y_A_y*A_y + i*conservative_y_A_y2_conjA_y*A_y^2*conj(A_y)
/// + i*conservative_y_A_x_A_y_conjA_x*A_x*conj(A_x)*A_y + dissipative_y_F*F - 1/(4*omega2)*i*e2*F + (-omega2 +
/// Omega)/(8*omega2^2)*i*e2*F with A = B in that frame
/// 78 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  Scalar lumps[44];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Complex conj_A_x = conjugate(A_x);
  const Scalar norm_A_x = norm_of(A_x);
  const Complex A_y = load_complex(amplitude, 1);
  const Scalar norm_A_y = norm_of(A_y);
  const Complex F = load_complex(forcing, 0);
  store_complex(derivative, 0, lumps[0] * (-Scalar(1.0)) * (A_x)
       + times_i(lumps[1] * (A_x))
       + times_i(lumps[2] * (A_x * norm_A_y))
       + times_i(lumps[3] * (norm_A_x * A_x))
       + lumps[4] * (conj_A_x * A_y)
       + times_i(lumps[5] * Scalar(1.0) / omega1 * (conj_A_x * A_y))
       + times_i(lumps[5] * (Scalar(2.0) * omega1 - omega2) / (Scalar(2.0) * omega1_2) * (conj_A_x * A_y))
       + times_i(lumps[6] * (conj_A_x * F))
       - times_i((-omega1 + excitation_frequency[0] / Scalar(2.0)) * A_x));
  store_complex(derivative, 1, times_i(lumps[5] * Scalar(1.0) / (Scalar(2.0) * omega2) * (A_x * A_x))
       + times_i(lumps[5] * (-Scalar(2.0) * omega1 + omega2) / (Scalar(4.0) * omega2_2) * (A_x * A_x))
       + lumps[7] * (A_x * A_x)
       + lumps[8] * (-Scalar(1.0)) * (A_y)
       + times_i(lumps[9] * (A_y))
       + times_i(lumps[10] * (norm_A_y * A_y))
       + times_i(lumps[11] * (norm_A_x * A_y))
       + lumps[12] * (F)
       + times_i(lumps[13] * (-Scalar(1.0) / (Scalar(4.0) * omega2)) * (F))
       + times_i(lumps[13] * (-omega2 + Omega) / (Scalar(8.0) * omega2_2) * (F))
       - times_i((-omega2 + excitation_frequency[0]) * A_y));
}

/// jacobian[i * 4 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 94 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  Scalar lumps[44];
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
       + times_i(Complex(lumps[1]))
       + times_i(Complex(lumps[2] * (norm_A_y)))
       + times_i(Complex(lumps[3] * Scalar(2) * (norm_A_x)))
       - Complex(Scalar(0.0), -omega1 + excitation_frequency[0] / Scalar(2.0));
  const Complex conj_by_0_0 = times_i(lumps[3] * (A_x * A_x))
       + lumps[4] * (A_y)
       + times_i(lumps[5] * Scalar(1.0) / omega1 * (A_y))
       + times_i(lumps[5] * (Scalar(2.0) * omega1 - omega2) / (Scalar(2.0) * omega1_2) * (A_y))
       + times_i(lumps[6] * (F));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[4] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[5] = by_0_0.real - conj_by_0_0.real;
  const Complex by_0_1 = times_i(lumps[2] * (A_x * conj_A_y))
       + lumps[4] * (conj_A_x)
       + times_i(lumps[5] * Scalar(1.0) / omega1 * (conj_A_x))
       + times_i(lumps[5] * (Scalar(2.0) * omega1 - omega2) / (Scalar(2.0) * omega1_2) * (conj_A_x));
  const Complex conj_by_0_1 = times_i(lumps[2] * (A_x * A_y));
  jacobian[2] = by_0_1.real + conj_by_0_1.real;
  jacobian[3] = conj_by_0_1.imag - by_0_1.imag;
  jacobian[6] = by_0_1.imag + conj_by_0_1.imag;
  jacobian[7] = by_0_1.real - conj_by_0_1.real;
  const Complex by_1_0 = times_i(lumps[5] * Scalar(1.0) / (Scalar(2.0) * omega2) * Scalar(2) * (A_x))
       + times_i(lumps[5] * (-Scalar(2.0) * omega1 + omega2) / (Scalar(4.0) * omega2_2) * Scalar(2) * (A_x))
       + lumps[7] * Scalar(2) * (A_x)
       + times_i(lumps[11] * (conj_A_x * A_y));
  const Complex conj_by_1_0 = times_i(lumps[11] * (A_x * A_y));
  jacobian[8] = by_1_0.real + conj_by_1_0.real;
  jacobian[9] = conj_by_1_0.imag - by_1_0.imag;
  jacobian[12] = by_1_0.imag + conj_by_1_0.imag;
  jacobian[13] = by_1_0.real - conj_by_1_0.real;
  const Complex by_1_1 = Complex(lumps[8] * (-Scalar(1.0)))
       + times_i(Complex(lumps[9]))
       + times_i(Complex(lumps[10] * Scalar(2) * (norm_A_y)))
       + times_i(Complex(lumps[11] * (norm_A_x)))
       - Complex(Scalar(0.0), -omega2 + excitation_frequency[0]);
  const Complex conj_by_1_1 = times_i(lumps[10] * (A_y * A_y));
  jacobian[10] = by_1_1.real + conj_by_1_1.real;
  jacobian[11] = conj_by_1_1.imag - by_1_1.imag;
  jacobian[14] = by_1_1.imag + conj_by_1_1.imag;
  jacobian[15] = by_1_1.real - conj_by_1_1.real;
}

}  // namespace one_to_two

namespace one_to_three {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: mu1 = mu1
/// lumps[3]: e1 = e1
/// lumps[6]: mu2 = mu2
/// lumps[8]: a2 = a2
/// lumps[9]: a1 = a1
/// lumps[10]: a3 = a3
/// lumps[18]: a4 = a4
/// lumps[20]: e2 = e2
/// 0 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar mu1 = parameters[11];
  const Scalar e1 = parameters[12];
  const Scalar mu2 = parameters[13];
  const Scalar e2 = parameters[14];
  lumps[0] = mu1;  // mu1
  lumps[1] = lump_1(parameters, static_cast<Scalar*>(nullptr));  // conservative_x_A_x_A_y_conjA_y
  lumps[2] = lump_2(parameters, static_cast<Scalar*>(nullptr));  // conservative_x_A_x2_conjA_x
  lumps[3] = e1;  // e1
  lumps[4] = lump_0(parameters, static_cast<Scalar*>(nullptr));  // conservative_x_A_y_conjA_x2
  lumps[5] = lump_40(parameters, static_cast<Scalar*>(nullptr));  // conservative_y_A_x3
  lumps[6] = mu2;  // mu2
  lumps[7] = lump_9(parameters, static_cast<Scalar*>(nullptr));  // conservative_y_A_y2_conjA_y
  lumps[8] = a2;  // a2
  lumps[9] = a1;  // a1
  lumps[10] = a3;  // a3
  lumps[11] = lump_41(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_y2_conjA_x
  lumps[12] = lump_13(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_x2_A_y
  lumps[13] = lump_25(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_y2_conjA_y
  lumps[14] = lump_42(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_x_A_y_conjA_x
  lumps[15] = lump_14(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_x3
  lumps[16] = lump_11(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_y3
  lumps[17] = lump_12(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_x_A_y2
  lumps[18] = a4;  // a4
  lumps[19] = lump_43(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_y_conjA_x2
  lumps[20] = e2;  // e2
  lumps[21] = lump_44(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_x_A_y_conjA_y
  lumps[22] = lump_45(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_x2_conjA_x
  lumps[23] = lump_46(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_y2_conjA_x
  lumps[24] = lump_17(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_x2_A_y
  lumps[25] = lump_15(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_y3
  lumps[26] = lump_16(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_x_A_y2
}

/// jacobian[l * 15 + p] = d lumps[l] / d parameters[p]. 0 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  for (std::size_t i = 0; i < 405; ++i) jacobian[i] = Scalar(0.0);
  jacobian[11] = Scalar(1.0);  // d mu1 / d mu1
  lump_1(parameters, jacobian + 15);  // d conservative_x_A_x_A_y_conjA_y
  lump_2(parameters, jacobian + 30);  // d conservative_x_A_x2_conjA_x
  jacobian[57] = Scalar(1.0);  // d e1 / d e1
  lump_0(parameters, jacobian + 60);  // d conservative_x_A_y_conjA_x2
  lump_40(parameters, jacobian + 75);  // d conservative_y_A_x3
  jacobian[103] = Scalar(1.0);  // d mu2 / d mu2
  lump_9(parameters, jacobian + 105);  // d conservative_y_A_y2_conjA_y
  jacobian[123] = Scalar(1.0);  // d a2 / d a2
  jacobian[137] = Scalar(1.0);  // d a1 / d a1
  jacobian[154] = Scalar(1.0);  // d a3 / d a3
  lump_41(parameters, jacobian + 165);  // d harmonic_re_x_A_y2_conjA_x
  lump_13(parameters, jacobian + 180);  // d harmonic_re_x_A_x2_A_y
  lump_25(parameters, jacobian + 195);  // d harmonic_re_x_A_y2_conjA_y
  lump_42(parameters, jacobian + 210);  // d harmonic_re_x_A_x_A_y_conjA_x
  lump_14(parameters, jacobian + 225);  // d harmonic_re_x_A_x3
  lump_11(parameters, jacobian + 240);  // d harmonic_re_x_A_y3
  lump_12(parameters, jacobian + 255);  // d harmonic_re_x_A_x_A_y2
  jacobian[275] = Scalar(1.0);  // d a4 / d a4
  lump_43(parameters, jacobian + 285);  // d harmonic_re_y_A_y_conjA_x2
  jacobian[314] = Scalar(1.0);  // d e2 / d e2
  lump_44(parameters, jacobian + 315);  // d harmonic_re_y_A_x_A_y_conjA_y
  lump_45(parameters, jacobian + 330);  // d harmonic_re_y_A_x2_conjA_x
  lump_46(parameters, jacobian + 345);  // d harmonic_re_y_A_y2_conjA_x
  lump_17(parameters, jacobian + 360);  // d harmonic_re_y_A_x2_A_y
  lump_15(parameters, jacobian + 375);  // d harmonic_re_y_A_y3
  lump_16(parameters, jacobian + 390);  // d harmonic_re_y_A_x_A_y2
}

/// What multiplies the 5 terms of the modulation of x: functions of the frequencies alone. 2 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  factor[0] = -Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = -Scalar(1.0) / (Scalar(4.0) * omega1);
  factor[4] = Scalar(1.0);
}

/// Rows of the modulation of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega1)*A_x = -mu1*A_x + i*conservative_x_A_x_A_y_conjA_y*A_x*A_y*conj(A_y) +
/// i*conservative_x_A_x2_conjA_x*A_x^2*conj(A_x) - 1/(4*omega1)*i*e1*F +
/// i*conservative_x_A_y_conjA_x2*conj(A_x)^2*A_y
/// 5 columns; per observation at most 13 products and sums of complex numbers.
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
  Scalar factor[5];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Scalar norm_A_y = norm_of(A_y);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_x));  // mu1
    store_complex(column_1, i, times_i(factor[1] * (A_x * norm_A_y)));  // conservative_x_A_x_A_y_conjA_y
    store_complex(column_2, i, times_i(factor[2] * (norm_A_x * A_x)));  // conservative_x_A_x2_conjA_x
    store_complex(column_3, i, times_i(factor[3] * (F)));  // e1
    store_complex(column_4, i, times_i(factor[4] * (conj_A_x * conj_A_x * A_y)));  // conservative_x_A_y_conjA_x2
  }
}

/// columns[j][i] of the rows.
inline void columns_0(const BatchArrays& data, double* const* columns) {
  rows_0(data, FactorValues<factors_0<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_0(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_0(data, FactorSlopes<factors_0<DualNumber>, 2, 1, 5>{mode}, columns);
}

/// What multiplies the 4 terms of the modulation of y: functions of the frequencies alone. 1 operations.
template <class Scalar>
void factors_1([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  factor[0] = omega1 / omega2;
  factor[1] = Scalar(1.0);
  factor[2] = -Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the modulation of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega2)*A_y = omega1/omega2*i*conservative_x_A_x_A_y_conjA_y*A_x*conj(A_x)*A_y +
/// i*conservative_y_A_x3*A_x^3 - mu2*A_y + i*conservative_y_A_y2_conjA_y*A_y^2*conj(A_y)
/// 4 columns; per observation at most 12 products and sums of complex numbers.
template <class Factors>
void rows_1(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
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
    store_complex(column_0, i, times_i(factor[0] * (norm_A_x * A_y)));  // conservative_x_A_x_A_y_conjA_y
    store_complex(column_1, i, times_i(factor[1] * (A_x * A_x * A_x)));  // conservative_y_A_x3
    store_complex(column_2, i, factor[2] * (A_y));  // mu2
    store_complex(column_3, i, times_i(factor[3] * (norm_A_y * A_y)));  // conservative_y_A_y2_conjA_y
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

/// What multiplies the 2 terms of the harmonic -omega1+omega2 of x: functions of the frequencies alone. 8
/// operations.
template <class Scalar>
void factors_2([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  factor[0] = -Scalar(2.0) * per_0 / omega2;
  factor[1] = Scalar(1.0) / (Scalar(3.0) * omega1_2);
}

/// Rows of the harmonic -omega1+omega2 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + omega2)*t) in x = -2/(omega2*(2*omega1 - omega2))*a2*conj(A_x)*A_y +
/// 1/(3*omega1^2)*a1*A_x^2
/// 2 columns; per observation at most 6 products and sums of complex numbers.
template <class Factors>
void rows_2(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (conj_A_x * A_y));  // a2
    store_complex(column_1, i, factor[1] * (A_x * A_x));  // a1
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

/// What multiplies the 2 terms of the harmonic 0 of x: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_3([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  factor[0] = -Scalar(2.0) / omega1_2;
  factor[1] = -Scalar(2.0) / omega1_2;
}

/// Rows of the harmonic 0 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in x = -2/omega1^2*a1*A_x*conj(A_x) - 2/omega1^2*a3*A_y*conj(A_y)
/// 2 columns; per observation at most 2 products and sums of complex numbers.
template <class Factors>
void rows_3(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Scalar norm_A_y = norm_of(A_y);
    store_complex(column_0, i, Complex(factor[0] * (norm_A_x)));  // a1
    store_complex(column_1, i, Complex(factor[1] * (norm_A_y)));  // a3
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

/// What multiplies the 1 terms of the harmonic 2*omega2 of x: functions of the frequencies alone. 7 operations.
template <class Scalar>
void factors_4([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  factor[0] = -per_0 * per_1;
}

/// Rows of the harmonic 2*omega2 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega2)*t) in x = -1/((omega1 + 2*omega2)*(omega1 - 2*omega2))*a3*A_y^2
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_4(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_y = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_y * A_y));  // a3
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

/// What multiplies the 1 terms of the harmonic omega1+omega2 of x: functions of the frequencies alone. 5
/// operations.
template <class Scalar>
void factors_5([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  factor[0] = Scalar(2.0) * per_0 / omega2;
}

/// Rows of the harmonic omega1+omega2 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + omega2)*t) in x = 2/(omega2*(2*omega1 + omega2))*a2*A_x*A_y
/// 1 columns; per observation at most 3 products and sums of complex numbers.
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
    const Complex A_y = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_x * A_y));  // a2
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

/// What multiplies the 2 terms of the harmonic -omega1+2*omega2 of x: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_6([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic -omega1+2*omega2 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + 2*omega2)*t) in x = harmonic_re_x_A_y2_conjA_x*conj(A_x)*A_y^2 +
/// harmonic_re_x_A_x2_A_y*A_x^2*A_y
/// 2 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_6(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (conj_A_x * A_y * A_y));  // harmonic_re_x_A_y2_conjA_x
    store_complex(column_1, i, factor[1] * (A_x * A_x * A_y));  // harmonic_re_x_A_x2_A_y
  }
}

/// columns[j][i] of the rows.
inline void columns_6(const BatchArrays& data, double* const* columns) {
  rows_6(data, FactorValues<factors_6<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_6(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 3 terms of the harmonic omega2 of x: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_7([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega2 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2)*t) in x = harmonic_re_x_A_y2_conjA_y*A_y^2*conj(A_y) +
/// harmonic_re_x_A_x_A_y_conjA_x*A_x*conj(A_x)*A_y + harmonic_re_x_A_x3*A_x^3
/// 3 columns; per observation at most 11 products and sums of complex numbers.
template <class Factors>
void rows_7(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[3];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Scalar norm_A_y = norm_of(A_y);
    store_complex(column_0, i, factor[0] * (norm_A_y * A_y));  // harmonic_re_x_A_y2_conjA_y
    store_complex(column_1, i, factor[1] * (norm_A_x * A_y));  // harmonic_re_x_A_x_A_y_conjA_x
    store_complex(column_2, i, factor[2] * (A_x * A_x * A_x));  // harmonic_re_x_A_x3
  }
}

/// columns[j][i] of the rows.
inline void columns_7(const BatchArrays& data, double* const* columns) {
  rows_7(data, FactorValues<factors_7<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_7(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 2 terms of the harmonic -omega1+omega2 of y: functions of the frequencies alone. 12
/// operations.
template <class Scalar>
void factors_10([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  factor[0] = per_0 * per_1;
  factor[1] = Scalar(2.0) * per_2 / omega1;
}

/// Rows of the harmonic -omega1+omega2 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + omega2)*t) in y = 1/((2*omega1 + omega2)*(2*omega1 - omega2))*a2*A_x^2 +
/// 2/(omega1*(omega1 - 2*omega2))*a3*conj(A_x)*A_y
/// 2 columns; per observation at most 6 products and sums of complex numbers.
template <class Factors>
void rows_10(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_x * A_x));  // a2
    store_complex(column_1, i, factor[1] * (conj_A_x * A_y));  // a3
  }
}

/// columns[j][i] of the rows.
inline void columns_10(const BatchArrays& data, double* const* columns) {
  rows_10(data, FactorValues<factors_10<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_10(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_10(data, FactorSlopes<factors_10<DualNumber>, 2, 1, 2>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic 0 of y: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_11([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega2_2 = omega2 * omega2;
  factor[0] = -Scalar(2.0) / omega2_2;
  factor[1] = -Scalar(2.0) / omega2_2;
}

/// Rows of the harmonic 0 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in y = -2/omega2^2*a2*A_x*conj(A_x) - 2/omega2^2*a4*A_y*conj(A_y)
/// 2 columns; per observation at most 2 products and sums of complex numbers.
template <class Factors>
void rows_11(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Scalar norm_A_y = norm_of(A_y);
    store_complex(column_0, i, Complex(factor[0] * (norm_A_x)));  // a2
    store_complex(column_1, i, Complex(factor[1] * (norm_A_y)));  // a4
  }
}

/// columns[j][i] of the rows.
inline void columns_11(const BatchArrays& data, double* const* columns) {
  rows_11(data, FactorValues<factors_11<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_11(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_11(data, FactorSlopes<factors_11<DualNumber>, 2, 1, 2>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 2*omega2 of y: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_12([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega2_2 = omega2 * omega2;
  factor[0] = Scalar(1.0) / (Scalar(3.0) * omega2_2);
}

/// Rows of the harmonic 2*omega2 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega2)*t) in y = 1/(3*omega2^2)*a4*A_y^2
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_12(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_y = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_y * A_y));  // a4
  }
}

/// columns[j][i] of the rows.
inline void columns_12(const BatchArrays& data, double* const* columns) {
  rows_12(data, FactorValues<factors_12<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_12(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_12(data, FactorSlopes<factors_12<DualNumber>, 2, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic omega1+omega2 of y: functions of the frequencies alone. 5
/// operations.
template <class Scalar>
void factors_13([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  factor[0] = Scalar(2.0) * per_0 / omega1;
}

/// Rows of the harmonic omega1+omega2 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + omega2)*t) in y = 2/(omega1*(omega1 + 2*omega2))*a3*A_x*A_y
/// 1 columns; per observation at most 3 products and sums of complex numbers.
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
    const Complex A_y = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_x * A_y));  // a3
  }
}

/// columns[j][i] of the rows.
inline void columns_13(const BatchArrays& data, double* const* columns) {
  rows_13(data, FactorValues<factors_13<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_13(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_13(data, FactorSlopes<factors_13<DualNumber>, 2, 1, 1>{mode}, columns);
}

/// What multiplies the 4 terms of the harmonic Omega of y: functions of the frequencies alone. 6 operations.
template <class Scalar>
void factors_14([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega2 = natural_frequency[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar per_0 = Scalar(1.0) / (omega2 + Omega);
  const Scalar per_1 = Scalar(1.0) / (omega2 - Omega);
  factor[0] = Scalar(1.0);
  factor[1] = per_0 * per_1 / Scalar(2.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the harmonic Omega of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(Omega)*t) in y = harmonic_re_y_A_y_conjA_x2*conj(A_x)^2*A_y + 1/(2*(omega2 +
/// Omega)*(omega2 - Omega))*e2*F + harmonic_re_y_A_x_A_y_conjA_y*A_x*A_y*conj(A_y) +
/// harmonic_re_y_A_x2_conjA_x*A_x^2*conj(A_x)
/// 4 columns; per observation at most 12 products and sums of complex numbers.
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
  Scalar* __restrict column_3 = columns[3];
  Scalar factor[4];
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
    store_complex(column_0, i, factor[0] * (conj_A_x * conj_A_x * A_y));  // harmonic_re_y_A_y_conjA_x2
    store_complex(column_1, i, factor[1] * (F));  // e2
    store_complex(column_2, i, factor[2] * (A_x * norm_A_y));  // harmonic_re_y_A_x_A_y_conjA_y
    store_complex(column_3, i, factor[3] * (norm_A_x * A_x));  // harmonic_re_y_A_x2_conjA_x
  }
}

/// columns[j][i] of the rows.
inline void columns_14(const BatchArrays& data, double* const* columns) {
  rows_14(data, FactorValues<factors_14<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_14(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_14(data, FactorSlopes<factors_14<DualNumber>, 2, 1, 4>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic -omega1+2*omega2 of y: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_15([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic -omega1+2*omega2 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + 2*omega2)*t) in y = harmonic_re_y_A_y2_conjA_x*conj(A_x)*A_y^2 +
/// harmonic_re_y_A_x2_A_y*A_x^2*A_y
/// 2 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_15(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (conj_A_x * A_y * A_y));  // harmonic_re_y_A_y2_conjA_x
    store_complex(column_1, i, factor[1] * (A_x * A_x * A_y));  // harmonic_re_y_A_x2_A_y
  }
}

/// columns[j][i] of the rows.
inline void columns_15(const BatchArrays& data, double* const* columns) {
  rows_15(data, FactorValues<factors_15<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_15(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_x/dt + i*(w_x - omega1)*B_x = -mu1*A_x + i*conservative_x_A_x_A_y_conjA_y*A_x*A_y*conj(A_y) +
/// i*conservative_x_A_x2_conjA_x*A_x^2*conj(A_x) - 1/(4*omega1)*i*e1*F +
/// i*conservative_x_A_y_conjA_x2*conj(A_x)^2*A_y with A = B in that frame
/// dB_y/dt + i*(w_y - omega2)*B_y = omega1/omega2*i*conservative_x_A_x_A_y_conjA_y*A_x*conj(A_x)*A_y +
/// i*conservative_y_A_x3*A_x^3 - mu2*A_y + i*conservative_y_A_y2_conjA_y*A_y^2*conj(A_y) with A = B in that
/// frame
/// 38 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  Scalar lumps[27];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Complex conj_A_x = conjugate(A_x);
  const Scalar norm_A_x = norm_of(A_x);
  const Complex A_y = load_complex(amplitude, 1);
  const Scalar norm_A_y = norm_of(A_y);
  const Complex F = load_complex(forcing, 0);
  store_complex(derivative, 0, lumps[0] * (-Scalar(1.0)) * (A_x)
       + times_i(lumps[1] * (A_x * norm_A_y))
       + times_i(lumps[2] * (norm_A_x * A_x))
       + times_i(lumps[3] * (-Scalar(1.0) / (Scalar(4.0) * omega1)) * (F))
       + times_i(lumps[4] * (conj_A_x * conj_A_x * A_y))
       - times_i((-omega1 + excitation_frequency[0]) * A_x));
  store_complex(derivative, 1, times_i(lumps[1] * omega1 / omega2 * (norm_A_x * A_y))
       + times_i(lumps[5] * (A_x * A_x * A_x))
       + lumps[6] * (-Scalar(1.0)) * (A_y)
       + times_i(lumps[7] * (norm_A_y * A_y))
       - times_i((-omega2 + Scalar(3.0) * excitation_frequency[0]) * A_y));
}

/// jacobian[i * 4 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 62 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  Scalar lumps[27];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Complex conj_A_x = conjugate(A_x);
  const Scalar norm_A_x = norm_of(A_x);
  const Complex A_y = load_complex(amplitude, 1);
  const Complex conj_A_y = conjugate(A_y);
  const Scalar norm_A_y = norm_of(A_y);
  for (std::size_t i = 0; i < 16; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = Complex(lumps[0] * (-Scalar(1.0)))
       + times_i(Complex(lumps[1] * (norm_A_y)))
       + times_i(Complex(lumps[2] * Scalar(2) * (norm_A_x)))
       - Complex(Scalar(0.0), -omega1 + excitation_frequency[0]);
  const Complex conj_by_0_0 = times_i(lumps[2] * (A_x * A_x))
       + times_i(lumps[4] * Scalar(2) * (conj_A_x * A_y));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[4] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[5] = by_0_0.real - conj_by_0_0.real;
  const Complex by_0_1 = times_i(lumps[1] * (A_x * conj_A_y))
       + times_i(lumps[4] * (conj_A_x * conj_A_x));
  const Complex conj_by_0_1 = times_i(lumps[1] * (A_x * A_y));
  jacobian[2] = by_0_1.real + conj_by_0_1.real;
  jacobian[3] = conj_by_0_1.imag - by_0_1.imag;
  jacobian[6] = by_0_1.imag + conj_by_0_1.imag;
  jacobian[7] = by_0_1.real - conj_by_0_1.real;
  const Complex by_1_0 = times_i(lumps[1] * omega1 / omega2 * (conj_A_x * A_y))
       + times_i(lumps[5] * Scalar(3) * (A_x * A_x));
  const Complex conj_by_1_0 = times_i(lumps[1] * omega1 / omega2 * (A_x * A_y));
  jacobian[8] = by_1_0.real + conj_by_1_0.real;
  jacobian[9] = conj_by_1_0.imag - by_1_0.imag;
  jacobian[12] = by_1_0.imag + conj_by_1_0.imag;
  jacobian[13] = by_1_0.real - conj_by_1_0.real;
  const Complex by_1_1 = times_i(Complex(lumps[1] * omega1 / omega2 * (norm_A_x)))
       + Complex(lumps[6] * (-Scalar(1.0)))
       + times_i(Complex(lumps[7] * Scalar(2) * (norm_A_y)))
       - Complex(Scalar(0.0), -omega2 + Scalar(3.0) * excitation_frequency[0]);
  const Complex conj_by_1_1 = times_i(lumps[7] * (A_y * A_y));
  jacobian[10] = by_1_1.real + conj_by_1_1.real;
  jacobian[11] = conj_by_1_1.imag - by_1_1.imag;
  jacobian[14] = by_1_1.imag + conj_by_1_1.imag;
  jacobian[15] = by_1_1.real - conj_by_1_1.real;
}

}  // namespace one_to_three

namespace free_one_to_two {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: mu1 = mu1
/// lumps[1]: conservative_x_A_x = -mu1^2/(2*omega1)
/// lumps[3]: conservative_x_A_x2_conjA_x = (18*omega1^2*omega2^2*b1 - 24*omega1^2*a2^2 - 3*omega1*omega2*a2^2 -
/// 20*omega2^2*a1^2)/(12*omega1^3*omega2^2)
/// lumps[4]: dissipative_x_A_y_conjA_x = a2*mu2/(2*omega1^2)
/// lumps[5]: a2 = a2
/// lumps[6]: dissipative_y_A_x2 = (2*a2*mu1 - a2*mu2)/(4*omega2^2)
/// lumps[7]: mu2 = mu2
/// lumps[8]: conservative_y_A_y = -mu2^2/(2*omega2)
/// lumps[11]: a3 = a3
/// lumps[12]: a1 = a1
/// lumps[20]: harmonic_im_x_A_x2 = -4*a1*mu1/(9*omega1^3)
/// lumps[26]: a4 = a4
/// lumps[28]: harmonic_re_y_A_x2_A_y = -4*a2*a4/(9*omega2^4)
/// lumps[29]: harmonic_im_y_A_y2 = -4*a4*mu2/(9*omega2^3)
/// 41 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b1 = parameters[6];
  const Scalar mu1 = parameters[11];
  const Scalar mu2 = parameters[13];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar a1_2 = a1 * a1;
  const Scalar a2_2 = a2 * a2;
  const Scalar mu1_2 = mu1 * mu1;
  const Scalar mu2_2 = mu2 * mu2;
  lumps[0] = mu1;  // mu1
  lumps[1] = -mu1_2 / (Scalar(2.0) * omega1);  // conservative_x_A_x
  lumps[2] = lump_19(parameters, static_cast<Scalar*>(nullptr));  // conservative_x_A_x_A_y_conjA_y
  // conservative_x_A_x2_conjA_x
  lumps[3] = (Scalar(18.0) * omega1_2 * omega2_2 * b1 - Scalar(24.0) * omega1_2 * a2_2
      - Scalar(3.0) * omega1 * omega2 * a2_2
      - Scalar(20.0) * omega2_2 * a1_2) / (Scalar(12.0) * omega1_3 * omega2_2);
  lumps[4] = a2 * mu2 / (Scalar(2.0) * omega1_2);  // dissipative_x_A_y_conjA_x
  lumps[5] = a2;  // a2
  lumps[6] = (Scalar(2.0) * a2 * mu1 - a2 * mu2) / (Scalar(4.0) * omega2_2);  // dissipative_y_A_x2
  lumps[7] = mu2;  // mu2
  lumps[8] = -mu2_2 / (Scalar(2.0) * omega2);  // conservative_y_A_y
  lumps[9] = lump_9(parameters, static_cast<Scalar*>(nullptr));  // conservative_y_A_y2_conjA_y
  lumps[10] = lump_21(parameters, static_cast<Scalar*>(nullptr));  // conservative_y_A_x_A_y_conjA_x
  lumps[11] = a3;  // a3
  lumps[12] = a1;  // a1
  lumps[13] = lump_22(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_y_conjA_x2
  lumps[14] = lump_27(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_x2_A_y
  lumps[15] = lump_28(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_x_A_y2
  lumps[16] = lump_30(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_y2_conjA_x
  lumps[17] = lump_32(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_x3
  lumps[18] = lump_25(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_y2_conjA_y
  lumps[19] = lump_26(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_x_A_y_conjA_x
  lumps[20] = -Scalar(4.0) * a1 * mu1 / (Scalar(9.0) * omega1_3);  // harmonic_im_x_A_x2
  lumps[21] = lump_11(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_y3
  lumps[22] = lump_12(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_x_A_x_A_y2
  lumps[23] = lump_33(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_y_A_y_conjA_x
  lumps[24] = lump_34(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_x_A_y_conjA_y
  lumps[25] = lump_35(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_x2_conjA_x
  lumps[26] = a4;  // a4
  lumps[27] = lump_36(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_y_conjA_x2
  lumps[28] = -Scalar(4.0) * a2 * a4 / (Scalar(9.0) * omega2_4);  // harmonic_re_y_A_x2_A_y
  lumps[29] = -Scalar(4.0) * a4 * mu2 / (Scalar(9.0) * omega2_3);  // harmonic_im_y_A_y2
  lumps[30] = lump_38(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_y2_conjA_x
  lumps[31] = lump_39(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_x3
  lumps[32] = lump_15(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_y3
  lumps[33] = lump_16(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_y_A_x_A_y2
}

/// jacobian[l * 15 + p] = d lumps[l] / d parameters[p]. 90 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a4 = parameters[5];
  const Scalar b1 = parameters[6];
  const Scalar mu1 = parameters[11];
  const Scalar mu2 = parameters[13];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar a1_2 = a1 * a1;
  const Scalar a2_2 = a2 * a2;
  const Scalar mu1_2 = mu1 * mu1;
  const Scalar mu2_2 = mu2 * mu2;
  for (std::size_t i = 0; i < 510; ++i) jacobian[i] = Scalar(0.0);
  jacobian[11] = Scalar(1.0);  // d mu1 / d mu1
  jacobian[15] = mu1_2 / (Scalar(2.0) * omega1_2);  // d conservative_x_A_x / d omega1
  jacobian[26] = -mu1 / omega1;  // d conservative_x_A_x / d mu1
  lump_19(parameters, jacobian + 30);  // d conservative_x_A_x_A_y_conjA_y
  // d conservative_x_A_x2_conjA_x / d omega1
  jacobian[45] = (-Scalar(3.0) * omega1_2 * omega2_2 * b1 + Scalar(4.0) * omega1_2 * a2_2 + omega1 * omega2 * a2_2
      + Scalar(10.0) * omega2_2 * a1_2) / (Scalar(2.0) * omega1_4 * omega2_2);
  // d conservative_x_A_x2_conjA_x / d omega2
  jacobian[46] = (Scalar(16.0) * omega1 * a2_2 + omega2 * a2_2) / (Scalar(4.0) * omega1_2 * omega2_3);
  jacobian[47] = -Scalar(10.0) * a1 / (Scalar(3.0) * omega1_3);  // d conservative_x_A_x2_conjA_x / d a1
  // d conservative_x_A_x2_conjA_x / d a2
  jacobian[48] = (-Scalar(8.0) * omega1 * a2 - omega2 * a2) / (Scalar(2.0) * omega1_2 * omega2_2);
  jacobian[51] = Scalar(3.0) / (Scalar(2.0) * omega1);  // d conservative_x_A_x2_conjA_x / d b1
  jacobian[60] = -a2 * mu2 / omega1_3;  // d dissipative_x_A_y_conjA_x / d omega1
  jacobian[63] = mu2 / (Scalar(2.0) * omega1_2);  // d dissipative_x_A_y_conjA_x / d a2
  jacobian[73] = a2 / (Scalar(2.0) * omega1_2);  // d dissipative_x_A_y_conjA_x / d mu2
  jacobian[78] = Scalar(1.0);  // d a2 / d a2
  // d dissipative_y_A_x2 / d omega2
  jacobian[91] = (-Scalar(2.0) * a2 * mu1 + a2 * mu2) / (Scalar(2.0) * omega2_3);
  jacobian[93] = (Scalar(2.0) * mu1 - mu2) / (Scalar(4.0) * omega2_2);  // d dissipative_y_A_x2 / d a2
  jacobian[101] = a2 / (Scalar(2.0) * omega2_2);  // d dissipative_y_A_x2 / d mu1
  jacobian[103] = -a2 / (Scalar(4.0) * omega2_2);  // d dissipative_y_A_x2 / d mu2
  jacobian[118] = Scalar(1.0);  // d mu2 / d mu2
  jacobian[121] = mu2_2 / (Scalar(2.0) * omega2_2);  // d conservative_y_A_y / d omega2
  jacobian[133] = -mu2 / omega2;  // d conservative_y_A_y / d mu2
  lump_9(parameters, jacobian + 135);  // d conservative_y_A_y2_conjA_y
  lump_21(parameters, jacobian + 150);  // d conservative_y_A_x_A_y_conjA_x
  jacobian[169] = Scalar(1.0);  // d a3 / d a3
  jacobian[182] = Scalar(1.0);  // d a1 / d a1
  lump_22(parameters, jacobian + 195);  // d harmonic_re_x_A_y_conjA_x2
  lump_27(parameters, jacobian + 210);  // d harmonic_re_x_A_x2_A_y
  lump_28(parameters, jacobian + 225);  // d harmonic_im_x_A_y2
  lump_30(parameters, jacobian + 240);  // d harmonic_re_x_A_y2_conjA_x
  lump_32(parameters, jacobian + 255);  // d harmonic_re_x_A_x3
  lump_25(parameters, jacobian + 270);  // d harmonic_re_x_A_y2_conjA_y
  lump_26(parameters, jacobian + 285);  // d harmonic_re_x_A_x_A_y_conjA_x
  jacobian[300] = Scalar(4.0) * a1 * mu1 / (Scalar(3.0) * omega1_4);  // d harmonic_im_x_A_x2 / d omega1
  jacobian[302] = -Scalar(4.0) * mu1 / (Scalar(9.0) * omega1_3);  // d harmonic_im_x_A_x2 / d a1
  jacobian[311] = -Scalar(4.0) * a1 / (Scalar(9.0) * omega1_3);  // d harmonic_im_x_A_x2 / d mu1
  lump_11(parameters, jacobian + 315);  // d harmonic_re_x_A_y3
  lump_12(parameters, jacobian + 330);  // d harmonic_re_x_A_x_A_y2
  lump_33(parameters, jacobian + 345);  // d harmonic_im_y_A_y_conjA_x
  lump_34(parameters, jacobian + 360);  // d harmonic_re_y_A_x_A_y_conjA_y
  lump_35(parameters, jacobian + 375);  // d harmonic_re_y_A_x2_conjA_x
  jacobian[395] = Scalar(1.0);  // d a4 / d a4
  lump_36(parameters, jacobian + 405);  // d harmonic_re_y_A_y_conjA_x2
  jacobian[421] = Scalar(16.0) * a2 * a4 / (Scalar(9.0) * omega2_5);  // d harmonic_re_y_A_x2_A_y / d omega2
  jacobian[423] = -Scalar(4.0) * a4 / (Scalar(9.0) * omega2_4);  // d harmonic_re_y_A_x2_A_y / d a2
  jacobian[425] = -Scalar(4.0) * a2 / (Scalar(9.0) * omega2_4);  // d harmonic_re_y_A_x2_A_y / d a4
  jacobian[436] = Scalar(4.0) * a4 * mu2 / (Scalar(3.0) * omega2_4);  // d harmonic_im_y_A_y2 / d omega2
  jacobian[440] = -Scalar(4.0) * mu2 / (Scalar(9.0) * omega2_3);  // d harmonic_im_y_A_y2 / d a4
  jacobian[448] = -Scalar(4.0) * a4 / (Scalar(9.0) * omega2_3);  // d harmonic_im_y_A_y2 / d mu2
  lump_38(parameters, jacobian + 450);  // d harmonic_re_y_A_y2_conjA_x
  lump_39(parameters, jacobian + 465);  // d harmonic_re_y_A_x3
  lump_15(parameters, jacobian + 480);  // d harmonic_re_y_A_y3
  lump_16(parameters, jacobian + 495);  // d harmonic_re_y_A_x_A_y2
}

/// What multiplies the 7 terms of the modulation of x: functions of the frequencies alone. 6 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  factor[0] = -Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0) / omega1;
  factor[6] = (Scalar(2.0) * omega1 - omega2) / (Scalar(2.0) * omega1_2);
}

/// Rows of the modulation of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega1)*A_x = -mu1*A_x + i*conservative_x_A_x*A_x +
/// i*conservative_x_A_x_A_y_conjA_y*A_x*A_y*conj(A_y) + i*conservative_x_A_x2_conjA_x*A_x^2*conj(A_x) +
/// dissipative_x_A_y_conjA_x*conj(A_x)*A_y + 1/omega1*i*a2*conj(A_x)*A_y + (2*omega1 -
/// omega2)/(2*omega1^2)*i*a2*conj(A_x)*A_y
/// 6 columns; per observation at most 18 products and sums of complex numbers.
template <class Factors>
void rows_0(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar* __restrict column_4 = columns[4];
  Scalar* __restrict column_5 = columns[5];
  Scalar factor[7];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Scalar norm_A_y = norm_of(A_y);
    store_complex(column_0, i, factor[0] * (A_x));  // mu1
    store_complex(column_1, i, times_i(factor[1] * (A_x)));  // conservative_x_A_x
    store_complex(column_2, i, times_i(factor[2] * (A_x * norm_A_y)));  // conservative_x_A_x_A_y_conjA_y
    store_complex(column_3, i, times_i(factor[3] * (norm_A_x * A_x)));  // conservative_x_A_x2_conjA_x
    store_complex(column_4, i, factor[4] * (conj_A_x * A_y));  // dissipative_x_A_y_conjA_x
    // a2
    store_complex(column_5, i, times_i(factor[5] * (conj_A_x * A_y)) + times_i(factor[6] * (conj_A_x * A_y)));
  }
}

/// columns[j][i] of the rows.
inline void columns_0(const BatchArrays& data, double* const* columns) {
  rows_0(data, FactorValues<factors_0<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_0(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_0(data, FactorSlopes<factors_0<DualNumber>, 2, 1, 7>{mode}, columns);
}

/// What multiplies the 7 terms of the modulation of y: functions of the frequencies alone. 7 operations.
template <class Scalar>
void factors_1([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega2_2 = omega2 * omega2;
  factor[0] = Scalar(1.0) / (Scalar(2.0) * omega2);
  factor[1] = (-Scalar(2.0) * omega1 + omega2) / (Scalar(4.0) * omega2_2);
  factor[2] = Scalar(1.0);
  factor[3] = -Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
  factor[6] = Scalar(1.0);
}

/// Rows of the modulation of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega2)*A_y = 1/(2*omega2)*i*a2*A_x^2 + (-2*omega1 + omega2)/(4*omega2^2)*i*a2*A_x^2 +
/// dissipative_y_A_x2*A_x^2 - mu2*A_y + i*conservative_y_A_y*A_y + i*conservative_y_A_y2_conjA_y*A_y^2*conj(A_y)
/// + i*conservative_y_A_x_A_y_conjA_x*A_x*conj(A_x)*A_y
/// 6 columns; per observation at most 18 products and sums of complex numbers.
template <class Factors>
void rows_1(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar* __restrict column_4 = columns[4];
  Scalar* __restrict column_5 = columns[5];
  Scalar factor[7];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Scalar norm_A_y = norm_of(A_y);
    store_complex(column_0, i, times_i(factor[0] * (A_x * A_x)) + times_i(factor[1] * (A_x * A_x)));  // a2
    store_complex(column_1, i, factor[2] * (A_x * A_x));  // dissipative_y_A_x2
    store_complex(column_2, i, factor[3] * (A_y));  // mu2
    store_complex(column_3, i, times_i(factor[4] * (A_y)));  // conservative_y_A_y
    store_complex(column_4, i, times_i(factor[5] * (norm_A_y * A_y)));  // conservative_y_A_y2_conjA_y
    store_complex(column_5, i, times_i(factor[6] * (norm_A_x * A_y)));  // conservative_y_A_x_A_y_conjA_x
  }
}

/// columns[j][i] of the rows.
inline void columns_1(const BatchArrays& data, double* const* columns) {
  rows_1(data, FactorValues<factors_1<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_1(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_1(data, FactorSlopes<factors_1<DualNumber>, 2, 1, 7>{mode}, columns);
}

/// What multiplies the 4 terms of the harmonic 0 of x: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_2([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  factor[0] = -Scalar(2.0) / omega1_2;
  factor[1] = -Scalar(2.0) / omega1_2;
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the harmonic 0 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in x = -2/omega1^2*a3*A_y*conj(A_y) - 2/omega1^2*a1*A_x*conj(A_x) +
/// harmonic_re_x_A_y_conjA_x2*conj(A_x)^2*A_y + harmonic_re_x_A_y_conjA_x2*A_x^2*conj(A_y)
/// 3 columns; per observation at most 13 products and sums of complex numbers.
template <class Factors>
void rows_2(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Complex conj_A_y = conjugate(A_y);
    const Scalar norm_A_y = norm_of(A_y);
    store_complex(column_0, i, Complex(factor[0] * (norm_A_y)));  // a3
    store_complex(column_1, i, Complex(factor[1] * (norm_A_x)));  // a1
    // harmonic_re_x_A_y_conjA_x2
    store_complex(column_2, i, factor[2] * (conj_A_x * conj_A_x * A_y) + factor[3] * (A_x * A_x * conj_A_y));
  }
}

/// columns[j][i] of the rows.
inline void columns_2(const BatchArrays& data, double* const* columns) {
  rows_2(data, FactorValues<factors_2<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_2(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_2(data, FactorSlopes<factors_2<DualNumber>, 2, 1, 4>{mode}, columns);
}

/// What multiplies the 4 terms of the harmonic 2*omega2 of x: functions of the frequencies alone. 7 operations.
template <class Scalar>
void factors_3([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  factor[0] = -per_0 * per_1;
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega2 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega2)*t) in x = -1/((omega1 + 2*omega2)*(omega1 - 2*omega2))*a3*A_y^2 +
/// harmonic_re_x_A_x2_A_y*A_x^2*A_y + harmonic_re_x_A_x2_A_y*A_x^2*A_y + i*harmonic_im_x_A_y2*A_y^2
/// 3 columns; per observation at most 17 products and sums of complex numbers.
template <class Factors>
void rows_3(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex A_y = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_y * A_y));  // a3
    // harmonic_re_x_A_x2_A_y
    store_complex(column_1, i, factor[1] * (A_x * A_x * A_y) + factor[2] * (A_x * A_x * A_y));
    store_complex(column_2, i, times_i(factor[3] * (A_y * A_y)));  // harmonic_im_x_A_y2
  }
}

/// columns[j][i] of the rows.
inline void columns_3(const BatchArrays& data, double* const* columns) {
  rows_3(data, FactorValues<factors_3<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_3(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_3(data, FactorSlopes<factors_3<DualNumber>, 2, 1, 4>{mode}, columns);
}

/// What multiplies the 6 terms of the harmonic omega1+omega2 of x: functions of the frequencies alone. 17
/// operations.
template <class Scalar>
void factors_4([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_0_2 = per_0 * per_0;
  factor[0] = (-Scalar(8.0) * omega1_3 - Scalar(8.0) * omega1_2 * omega2) * per_0_2 / omega2_2;
  factor[1] = Scalar(2.0) * per_0 / omega2;
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(2.0) * omega2 / omega1;
  factor[5] = Scalar(1.0);
}

/// Rows of the harmonic omega1+omega2 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + omega2)*t) in x = (-8*omega1^3 - 8*omega1^2*omega2)/(omega2^2*(2*omega1 +
/// omega2)^2)*i*dissipative_x_A_y_conjA_x*A_x*A_y + 2/(omega2*(2*omega1 + omega2))*a2*A_x*A_y +
/// harmonic_re_x_A_y2_conjA_x*conj(A_x)*A_y^2 + harmonic_re_x_A_x3*A_x^3 +
/// 2*omega2/omega1*harmonic_re_x_A_x3*conj(A_x)*A_y^2 + harmonic_re_x_A_x3*A_x^3
/// 4 columns; per observation at most 28 products and sums of complex numbers.
template <class Factors>
void rows_4(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar factor[6];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    store_complex(column_0, i, times_i(factor[0] * (A_x * A_y)));  // dissipative_x_A_y_conjA_x
    store_complex(column_1, i, factor[1] * (A_x * A_y));  // a2
    store_complex(column_2, i, factor[2] * (conj_A_x * A_y * A_y));  // harmonic_re_x_A_y2_conjA_x
    // harmonic_re_x_A_x3
    store_complex(column_3, i, factor[3] * (A_x * A_x * A_x) + factor[4] * (conj_A_x * A_y * A_y)
        + factor[5] * (A_x * A_x * A_x));
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

/// What multiplies the 5 terms of the harmonic omega2 of x: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_5([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  factor[0] = Scalar(1.0) / (Scalar(3.0) * omega1_2);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
}

/// Rows of the harmonic omega2 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2)*t) in x = 1/(3*omega1^2)*a1*A_x^2 + harmonic_re_x_A_y2_conjA_y*A_y^2*conj(A_y) +
/// harmonic_re_x_A_x_A_y_conjA_x*A_x*conj(A_x)*A_y + harmonic_re_x_A_x_A_y_conjA_x*A_x*conj(A_x)*A_y +
/// i*harmonic_im_x_A_x2*A_x^2
/// 4 columns; per observation at most 16 products and sums of complex numbers.
template <class Factors>
void rows_5(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar factor[5];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Scalar norm_A_y = norm_of(A_y);
    store_complex(column_0, i, factor[0] * (A_x * A_x));  // a1
    store_complex(column_1, i, factor[1] * (norm_A_y * A_y));  // harmonic_re_x_A_y2_conjA_y
    // harmonic_re_x_A_x_A_y_conjA_x
    store_complex(column_2, i, factor[2] * (norm_A_x * A_y) + factor[3] * (norm_A_x * A_y));
    store_complex(column_3, i, times_i(factor[4] * (A_x * A_x)));  // harmonic_im_x_A_x2
  }
}

/// columns[j][i] of the rows.
inline void columns_5(const BatchArrays& data, double* const* columns) {
  rows_5(data, FactorValues<factors_5<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_5(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_5(data, FactorSlopes<factors_5<DualNumber>, 2, 1, 5>{mode}, columns);
}

/// What multiplies the 6 terms of the harmonic omega1 of y: functions of the frequencies alone. 23 operations.
template <class Scalar>
void factors_8([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  factor[0] = Scalar(2.0) * per_0 / omega1;
  factor[1] = (omega1_3 + Scalar(3.0) * omega1_2 * omega2 - Scalar(4.0) * omega2_3) / omega1_3;
  factor[2] = (-omega1_3 - Scalar(3.0) * omega1_2 * omega2
      + Scalar(4.0) * omega2_3) / (Scalar(2.0) * omega1_2 * omega2);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
}

/// Rows of the harmonic omega1 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1)*t) in y = 2/(omega1*(omega1 - 2*omega2))*a3*conj(A_x)*A_y + (omega1^3 +
/// 3*omega1^2*omega2 - 4*omega2^3)/omega1^3*harmonic_re_x_A_x2_A_y*A_x*A_y*conj(A_y) + (-omega1^3 -
/// 3*omega1^2*omega2 + 4*omega2^3)/(2*omega1^2*omega2)*harmonic_re_x_A_x2_A_y*A_x^2*conj(A_x) +
/// i*harmonic_im_y_A_y_conjA_x*conj(A_x)*A_y + harmonic_re_y_A_x_A_y_conjA_y*A_x*A_y*conj(A_y) +
/// harmonic_re_y_A_x2_conjA_x*A_x^2*conj(A_x)
/// 5 columns; per observation at most 19 products and sums of complex numbers.
template <class Factors>
void rows_8(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
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
    store_complex(column_0, i, factor[0] * (conj_A_x * A_y));  // a3
    // harmonic_re_x_A_x2_A_y
    store_complex(column_1, i, factor[1] * (A_x * norm_A_y) + factor[2] * (norm_A_x * A_x));
    store_complex(column_2, i, times_i(factor[3] * (conj_A_x * A_y)));  // harmonic_im_y_A_y_conjA_x
    store_complex(column_3, i, factor[4] * (A_x * norm_A_y));  // harmonic_re_y_A_x_A_y_conjA_y
    store_complex(column_4, i, factor[5] * (norm_A_x * A_x));  // harmonic_re_y_A_x2_conjA_x
  }
}

/// columns[j][i] of the rows.
inline void columns_8(const BatchArrays& data, double* const* columns) {
  rows_8(data, FactorValues<factors_8<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_8(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_8(data, FactorSlopes<factors_8<DualNumber>, 2, 1, 6>{mode}, columns);
}

/// What multiplies the 4 terms of the harmonic 0 of y: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_9([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega2_2 = omega2 * omega2;
  factor[0] = -Scalar(2.0) / omega2_2;
  factor[1] = -Scalar(2.0) / omega2_2;
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the harmonic 0 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in y = -2/omega2^2*a2*A_x*conj(A_x) - 2/omega2^2*a4*A_y*conj(A_y) +
/// harmonic_re_y_A_y_conjA_x2*conj(A_x)^2*A_y + harmonic_re_y_A_y_conjA_x2*A_x^2*conj(A_y)
/// 3 columns; per observation at most 13 products and sums of complex numbers.
template <class Factors>
void rows_9(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex A_y = load_complex(amplitude_1, i);
    const Complex conj_A_y = conjugate(A_y);
    const Scalar norm_A_y = norm_of(A_y);
    store_complex(column_0, i, Complex(factor[0] * (norm_A_x)));  // a2
    store_complex(column_1, i, Complex(factor[1] * (norm_A_y)));  // a4
    // harmonic_re_y_A_y_conjA_x2
    store_complex(column_2, i, factor[2] * (conj_A_x * conj_A_x * A_y) + factor[3] * (A_x * A_x * conj_A_y));
  }
}

/// columns[j][i] of the rows.
inline void columns_9(const BatchArrays& data, double* const* columns) {
  rows_9(data, FactorValues<factors_9<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_9(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_9(data, FactorSlopes<factors_9<DualNumber>, 2, 1, 4>{mode}, columns);
}

/// What multiplies the 4 terms of the harmonic 2*omega2 of y: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_10([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega2_2 = omega2 * omega2;
  factor[0] = Scalar(1.0) / (Scalar(3.0) * omega2_2);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega2 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega2)*t) in y = 1/(3*omega2^2)*a4*A_y^2 + harmonic_re_y_A_x2_A_y*A_x^2*A_y +
/// harmonic_re_y_A_x2_A_y*A_x^2*A_y + i*harmonic_im_y_A_y2*A_y^2
/// 3 columns; per observation at most 17 products and sums of complex numbers.
template <class Factors>
void rows_10(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex A_y = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_y * A_y));  // a4
    // harmonic_re_y_A_x2_A_y
    store_complex(column_1, i, factor[1] * (A_x * A_x * A_y) + factor[2] * (A_x * A_x * A_y));
    store_complex(column_2, i, times_i(factor[3] * (A_y * A_y)));  // harmonic_im_y_A_y2
  }
}

/// columns[j][i] of the rows.
inline void columns_10(const BatchArrays& data, double* const* columns) {
  rows_10(data, FactorValues<factors_10<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_10(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_10(data, FactorSlopes<factors_10<DualNumber>, 2, 1, 4>{mode}, columns);
}

/// What multiplies the 6 terms of the harmonic omega1+omega2 of y: functions of the frequencies alone. 33
/// operations.
template <class Scalar>
void factors_11([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  factor[0] = Scalar(2.0) * per_0 / omega1;
  factor[1] = (omega1_3 - Scalar(3.0) * omega1_2 * omega2
      + Scalar(4.0) * omega2_3) / (Scalar(2.0) * omega1_2 * omega2);
  factor[2] = (omega1_3 - Scalar(3.0) * omega1_2 * omega2 + Scalar(4.0) * omega2_3) / omega1_3;
  factor[3] = (-omega1_3 + Scalar(3.0) * omega1_2 * omega2 - Scalar(4.0) * omega2_3) * per_0_2 * per_1;
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
}

/// Rows of the harmonic omega1+omega2 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + omega2)*t) in y = 2/(omega1*(omega1 + 2*omega2))*a3*A_x*A_y + (omega1^3 -
/// 3*omega1^2*omega2 + 4*omega2^3)/(2*omega1^2*omega2)*harmonic_re_x_A_x2_A_y*A_x^3 + (omega1^3 -
/// 3*omega1^2*omega2 + 4*omega2^3)/omega1^3*harmonic_re_x_A_x2_A_y*conj(A_x)*A_y^2 + (-omega1^3 +
/// 3*omega1^2*omega2 - 4*omega2^3)/((omega1 + 2*omega2)^2*(omega1 - omega2))*i*harmonic_im_y_A_y_conjA_x*A_x*A_y
/// + harmonic_re_y_A_y2_conjA_x*conj(A_x)*A_y^2 + harmonic_re_y_A_x3*A_x^3
/// 5 columns; per observation at most 27 products and sums of complex numbers.
template <class Factors>
void rows_11(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
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
    const Complex A_y = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_x * A_y));  // a3
    // harmonic_re_x_A_x2_A_y
    store_complex(column_1, i, factor[1] * (A_x * A_x * A_x) + factor[2] * (conj_A_x * A_y * A_y));
    store_complex(column_2, i, times_i(factor[3] * (A_x * A_y)));  // harmonic_im_y_A_y_conjA_x
    store_complex(column_3, i, factor[4] * (conj_A_x * A_y * A_y));  // harmonic_re_y_A_y2_conjA_x
    store_complex(column_4, i, factor[5] * (A_x * A_x * A_x));  // harmonic_re_y_A_x3
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

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_x/dt + i*(w_x - omega1)*B_x = -mu1*A_x + i*conservative_x_A_x*A_x +
/// i*conservative_x_A_x_A_y_conjA_y*A_x*A_y*conj(A_y) + i*conservative_x_A_x2_conjA_x*A_x^2*conj(A_x) +
/// dissipative_x_A_y_conjA_x*conj(A_x)*A_y + 1/omega1*i*a2*conj(A_x)*A_y + (2*omega1 -
/// omega2)/(2*omega1^2)*i*a2*conj(A_x)*A_y with A = B in that frame
/// dB_y/dt + i*(w_y - omega2)*B_y = 1/(2*omega2)*i*a2*A_x^2 + (-2*omega1 + omega2)/(4*omega2^2)*i*a2*A_x^2 +
/// dissipative_y_A_x2*A_x^2 - mu2*A_y + i*conservative_y_A_y*A_y + i*conservative_y_A_y2_conjA_y*A_y^2*conj(A_y)
/// + i*conservative_y_A_x_A_y_conjA_x*A_x*conj(A_x)*A_y with A = B in that frame
/// 59 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  Scalar lumps[34];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Complex conj_A_x = conjugate(A_x);
  const Scalar norm_A_x = norm_of(A_x);
  const Complex A_y = load_complex(amplitude, 1);
  const Scalar norm_A_y = norm_of(A_y);
  store_complex(derivative, 0, lumps[0] * (-Scalar(1.0)) * (A_x)
       + times_i(lumps[1] * (A_x))
       + times_i(lumps[2] * (A_x * norm_A_y))
       + times_i(lumps[3] * (norm_A_x * A_x))
       + lumps[4] * (conj_A_x * A_y)
       + times_i(lumps[5] * Scalar(1.0) / omega1 * (conj_A_x * A_y))
       + times_i(lumps[5] * (Scalar(2.0) * omega1 - omega2) / (Scalar(2.0) * omega1_2) * (conj_A_x * A_y))
       - times_i((-omega1 + omega2 / Scalar(2.0)) * A_x));
  store_complex(derivative, 1, times_i(lumps[5] * Scalar(1.0) / (Scalar(2.0) * omega2) * (A_x * A_x))
       + times_i(lumps[5] * (-Scalar(2.0) * omega1 + omega2) / (Scalar(4.0) * omega2_2) * (A_x * A_x))
       + lumps[6] * (A_x * A_x)
       + lumps[7] * (-Scalar(1.0)) * (A_y)
       + times_i(lumps[8] * (A_y))
       + times_i(lumps[9] * (norm_A_y * A_y))
       + times_i(lumps[10] * (norm_A_x * A_y)));
}

/// jacobian[i * 4 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 90 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  Scalar lumps[34];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Complex conj_A_x = conjugate(A_x);
  const Scalar norm_A_x = norm_of(A_x);
  const Complex A_y = load_complex(amplitude, 1);
  const Complex conj_A_y = conjugate(A_y);
  const Scalar norm_A_y = norm_of(A_y);
  for (std::size_t i = 0; i < 16; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = Complex(lumps[0] * (-Scalar(1.0)))
       + times_i(Complex(lumps[1]))
       + times_i(Complex(lumps[2] * (norm_A_y)))
       + times_i(Complex(lumps[3] * Scalar(2) * (norm_A_x)))
       - Complex(Scalar(0.0), -omega1 + omega2 / Scalar(2.0));
  const Complex conj_by_0_0 = times_i(lumps[3] * (A_x * A_x))
       + lumps[4] * (A_y)
       + times_i(lumps[5] * Scalar(1.0) / omega1 * (A_y))
       + times_i(lumps[5] * (Scalar(2.0) * omega1 - omega2) / (Scalar(2.0) * omega1_2) * (A_y));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[4] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[5] = by_0_0.real - conj_by_0_0.real;
  const Complex by_0_1 = times_i(lumps[2] * (A_x * conj_A_y))
       + lumps[4] * (conj_A_x)
       + times_i(lumps[5] * Scalar(1.0) / omega1 * (conj_A_x))
       + times_i(lumps[5] * (Scalar(2.0) * omega1 - omega2) / (Scalar(2.0) * omega1_2) * (conj_A_x));
  const Complex conj_by_0_1 = times_i(lumps[2] * (A_x * A_y));
  jacobian[2] = by_0_1.real + conj_by_0_1.real;
  jacobian[3] = conj_by_0_1.imag - by_0_1.imag;
  jacobian[6] = by_0_1.imag + conj_by_0_1.imag;
  jacobian[7] = by_0_1.real - conj_by_0_1.real;
  const Complex by_1_0 = times_i(lumps[5] * Scalar(1.0) / (Scalar(2.0) * omega2) * Scalar(2) * (A_x))
       + times_i(lumps[5] * (-Scalar(2.0) * omega1 + omega2) / (Scalar(4.0) * omega2_2) * Scalar(2) * (A_x))
       + lumps[6] * Scalar(2) * (A_x)
       + times_i(lumps[10] * (conj_A_x * A_y));
  const Complex conj_by_1_0 = times_i(lumps[10] * (A_x * A_y));
  jacobian[8] = by_1_0.real + conj_by_1_0.real;
  jacobian[9] = conj_by_1_0.imag - by_1_0.imag;
  jacobian[12] = by_1_0.imag + conj_by_1_0.imag;
  jacobian[13] = by_1_0.real - conj_by_1_0.real;
  const Complex by_1_1 = Complex(lumps[7] * (-Scalar(1.0)))
       + times_i(Complex(lumps[8]))
       + times_i(Complex(lumps[9] * Scalar(2) * (norm_A_y)))
       + times_i(Complex(lumps[10] * (norm_A_x)));
  const Complex conj_by_1_1 = times_i(lumps[9] * (A_y * A_y));
  jacobian[10] = by_1_1.real + conj_by_1_1.real;
  jacobian[11] = conj_by_1_1.imag - by_1_1.imag;
  jacobian[14] = by_1_1.imag + conj_by_1_1.imag;
  jacobian[15] = by_1_1.real - conj_by_1_1.real;
}

}  // namespace free_one_to_two

}  // namespace secular::generated::internal_resonance
