// Model three_modes: generated code, never edited by hand.
// Source: Generic; the case of S. O'F. Fahey, dissertation, Virginia Tech, 2000, section 3.2.3, with the third
// mode kept
// Equation of motion: 0 = omega1^2*v1 + b1122*v1*v2^2 + 2*a113*v1*v3 + b1133*v1*v3^2 + b1111*v1^3 + 2*mu1*D(v1)
// + D2(v1) + a123*v2*v3 - e12*v2*F*cos(Omega*t) - e1*F*cos(Omega*t)
// Equation of motion: 0 = a123*v1*v3 - e12*v1*F*cos(Omega*t) + b1122*v1^2*v2 + omega2^2*v2 + 2*a223*v2*v3 +
// b2233*v2*v3^2 + b2222*v2^3 + 2*mu2*D(v2) + D2(v2) - e2*F*cos(Omega*t)
// Equation of motion: 0 = a123*v1*v2 + a113*v1^2 + b1133*v1^2*v3 + a223*v2^2 + b2233*v2^2*v3 + omega3^2*v3 +
// a333*v3^2 + 2*mu3*D(v3) + D2(v3) - e3*F*cos(Omega*t)
// Case additive_combination: Omega = omega1 + omega2 + eps^2*sigma, multiple scales to eps^2. Valid near that
// resonance for small amplitudes; what is left out is of order eps^3.
// Case free: free vibration, multiple scales to eps^2. Valid near that resonance for small amplitudes; what is
// left out is of order eps^3.
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// Made by: secular generate three_modes
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

namespace secular::generated::three_modes {

/// Mass matrix M of the equations of motion M*acceleration + force = 0 below, state-dependent: mass[k * 3 + j]
/// multiplies the acceleration of mode j in equation k. 0 operations.
template <class Scalar, class Parameter, class Sample>
void mass_matrix([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* mass) {
  mass[0] = Scalar(1.0);
  mass[1] = Scalar(0.0);
  mass[2] = Scalar(0.0);
  mass[3] = Scalar(0.0);
  mass[4] = Scalar(1.0);
  mass[5] = Scalar(0.0);
  mass[6] = Scalar(0.0);
  mass[7] = Scalar(0.0);
  mass[8] = Scalar(1.0);
}

/// Accelerations of the full equations of motion, solved from the state-dependent mass matrix.
/// 0 = omega1^2*v1 + b1122*v1*v2^2 + 2*a113*v1*v3 + b1133*v1*v3^2 + b1111*v1^3 + 2*mu1*D(v1) + D2(v1) +
/// a123*v2*v3 - e12*v2*F*cos(Omega*t) - e1*F*cos(Omega*t)
/// 0 = a123*v1*v3 - e12*v1*F*cos(Omega*t) + b1122*v1^2*v2 + omega2^2*v2 + 2*a223*v2*v3 + b2233*v2*v3^2 +
/// b2222*v2^3 + 2*mu2*D(v2) + D2(v2) - e2*F*cos(Omega*t)
/// 0 = a123*v1*v2 + a113*v1^2 + b1133*v1^2*v3 + a223*v2^2 + b2233*v2^2*v3 + omega3^2*v3 + a333*v3^2 +
/// 2*mu3*D(v3) + D2(v3) - e3*F*cos(Omega*t)
/// parameters: [0] omega1, [1] omega2, [2] omega3, [3] a113, [4] a123, [5] a223, [6] a333, [7] b1111, [8] b1122,
/// [9] b2222, [10] b1133, [11] b2233, [12] e12, [13] mu1, [14] e1, [15] mu2, [16] e2, [17] mu3, [18] e3.
/// displacement, velocity, acceleration: 3 values. 85 operations.
template <class Scalar, class Parameter, class Sample>
void accelerations([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* acceleration) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar b1111 = parameters[7];
  const Scalar b1122 = parameters[8];
  const Scalar b2222 = parameters[9];
  const Scalar b1133 = parameters[10];
  const Scalar b2233 = parameters[11];
  const Scalar e12 = parameters[12];
  const Scalar mu1 = parameters[13];
  const Scalar e1 = parameters[14];
  const Scalar mu2 = parameters[15];
  const Scalar e2 = parameters[16];
  const Scalar mu3 = parameters[17];
  const Scalar e3 = parameters[18];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  acceleration[0] = -(omega1_2 * displacement[0] + b1122 * displacement[0] * displacement[1] * displacement[1]
      + Scalar(2.0) * a113 * displacement[0] * displacement[2]
      + b1133 * displacement[0] * displacement[2] * displacement[2]
      + b1111 * displacement[0] * displacement[0] * displacement[0] + Scalar(2.0) * mu1 * velocity[0]
      + a123 * displacement[1] * displacement[2] - e12 * displacement[1] * Scalar(excitation[0].value)
      - e1 * Scalar(excitation[0].value));
  acceleration[1] = -(a123 * displacement[0] * displacement[2] - e12 * displacement[0] * Scalar(excitation[0].value)
      + b1122 * displacement[0] * displacement[0] * displacement[1] + omega2_2 * displacement[1]
      + Scalar(2.0) * a223 * displacement[1] * displacement[2]
      + b2233 * displacement[1] * displacement[2] * displacement[2]
      + b2222 * displacement[1] * displacement[1] * displacement[1] + Scalar(2.0) * mu2 * velocity[1]
      - e2 * Scalar(excitation[0].value));
  acceleration[2] = -(a123 * displacement[0] * displacement[1] + a113 * displacement[0] * displacement[0]
      + b1133 * displacement[0] * displacement[0] * displacement[2] + a223 * displacement[1] * displacement[1]
      + b2233 * displacement[1] * displacement[1] * displacement[2] + omega3_2 * displacement[2]
      + a333 * displacement[2] * displacement[2] + Scalar(2.0) * mu3 * velocity[2]
      - e3 * Scalar(excitation[0].value));
}

/// slope[k * 6 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = v1, v2, v3, D(v1),
/// D(v2), D(v3). Of nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x)
/// = 0. 87 operations before the solution of 6 right sides.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_state([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar b1111 = parameters[7];
  const Scalar b1122 = parameters[8];
  const Scalar b2222 = parameters[9];
  const Scalar b1133 = parameters[10];
  const Scalar b2233 = parameters[11];
  const Scalar e12 = parameters[12];
  const Scalar mu1 = parameters[13];
  const Scalar mu2 = parameters[15];
  const Scalar mu3 = parameters[17];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  for (std::size_t i = 0; i < 18; ++i) slope[i] = Scalar(0.0);
  // equation 1 by v1
  slope[0] = -(omega1_2 + b1122 * displacement[1] * displacement[1] + Scalar(2.0) * a113 * displacement[2]
      + b1133 * displacement[2] * displacement[2] + b1111 * displacement[0] * displacement[0] * Scalar(3.0));
  // equation 1 by v2
  slope[1] = -(b1122 * displacement[0] * displacement[1] * Scalar(2.0) + a123 * displacement[2]
      - e12 * Scalar(excitation[0].value));
  // equation 1 by v3
  slope[2] = -(Scalar(2.0) * a113 * displacement[0] + b1133 * displacement[0] * displacement[2] * Scalar(2.0)
      + a123 * displacement[1]);
  slope[3] = -(Scalar(2.0) * mu1);  // equation 1 by D(v1)
  // equation 2 by v1
  slope[6] = -(a123 * displacement[2] - e12 * Scalar(excitation[0].value)
      + b1122 * displacement[0] * displacement[1] * Scalar(2.0));
  // equation 2 by v2
  slope[7] = -(b1122 * displacement[0] * displacement[0] + omega2_2 + Scalar(2.0) * a223 * displacement[2]
      + b2233 * displacement[2] * displacement[2] + b2222 * displacement[1] * displacement[1] * Scalar(3.0));
  // equation 2 by v3
  slope[8] = -(a123 * displacement[0] + Scalar(2.0) * a223 * displacement[1]
      + b2233 * displacement[1] * displacement[2] * Scalar(2.0));
  slope[10] = -(Scalar(2.0) * mu2);  // equation 2 by D(v2)
  // equation 3 by v1
  slope[12] = -(a123 * displacement[1] + a113 * displacement[0] * Scalar(2.0)
      + b1133 * displacement[0] * displacement[2] * Scalar(2.0));
  // equation 3 by v2
  slope[13] = -(a123 * displacement[0] + a223 * displacement[1] * Scalar(2.0)
      + b2233 * displacement[1] * displacement[2] * Scalar(2.0));
  // equation 3 by v3
  slope[14] = -(b1133 * displacement[0] * displacement[0] + b2233 * displacement[1] * displacement[1] + omega3_2
      + a333 * displacement[2] * Scalar(2.0));
  slope[17] = -(Scalar(2.0) * mu3);  // equation 3 by D(v3)
}

/// slope[k * 19 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = omega1, omega2,
/// omega3, a113, a123, a223, a333, b1111, b1122, b2222, b1133, b2233, e12, mu1, e1, mu2, e2, mu3, e3. Of
/// nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x) = 0. 42
/// operations before the solution of 19 right sides.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_parameters([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  for (std::size_t i = 0; i < 57; ++i) slope[i] = Scalar(0.0);
  slope[0] = -(Scalar(2.0) * omega1 * displacement[0]);  // equation 1 by omega1
  slope[3] = -(Scalar(2.0) * displacement[0] * displacement[2]);  // equation 1 by a113
  slope[4] = -(displacement[1] * displacement[2]);  // equation 1 by a123
  slope[7] = -(displacement[0] * displacement[0] * displacement[0]);  // equation 1 by b1111
  slope[8] = -(displacement[0] * displacement[1] * displacement[1]);  // equation 1 by b1122
  slope[10] = -(displacement[0] * displacement[2] * displacement[2]);  // equation 1 by b1133
  slope[12] = -(-Scalar(1.0) * displacement[1] * Scalar(excitation[0].value));  // equation 1 by e12
  slope[13] = -(Scalar(2.0) * velocity[0]);  // equation 1 by mu1
  slope[14] = -(-Scalar(1.0) * Scalar(excitation[0].value));  // equation 1 by e1
  slope[20] = -(Scalar(2.0) * omega2 * displacement[1]);  // equation 2 by omega2
  slope[23] = -(displacement[0] * displacement[2]);  // equation 2 by a123
  slope[24] = -(Scalar(2.0) * displacement[1] * displacement[2]);  // equation 2 by a223
  slope[27] = -(displacement[0] * displacement[0] * displacement[1]);  // equation 2 by b1122
  slope[28] = -(displacement[1] * displacement[1] * displacement[1]);  // equation 2 by b2222
  slope[30] = -(displacement[1] * displacement[2] * displacement[2]);  // equation 2 by b2233
  slope[31] = -(-Scalar(1.0) * displacement[0] * Scalar(excitation[0].value));  // equation 2 by e12
  slope[34] = -(Scalar(2.0) * velocity[1]);  // equation 2 by mu2
  slope[35] = -(-Scalar(1.0) * Scalar(excitation[0].value));  // equation 2 by e2
  slope[40] = -(Scalar(2.0) * omega3 * displacement[2]);  // equation 3 by omega3
  slope[41] = -(displacement[0] * displacement[0]);  // equation 3 by a113
  slope[42] = -(displacement[0] * displacement[1]);  // equation 3 by a123
  slope[43] = -(displacement[1] * displacement[1]);  // equation 3 by a223
  slope[44] = -(displacement[2] * displacement[2]);  // equation 3 by a333
  slope[48] = -(displacement[0] * displacement[0] * displacement[2]);  // equation 3 by b1133
  slope[49] = -(displacement[1] * displacement[1] * displacement[2]);  // equation 3 by b2233
  slope[55] = -(Scalar(2.0) * velocity[2]);  // equation 3 by mu3
  slope[56] = -(-Scalar(1.0) * Scalar(excitation[0].value));  // equation 3 by e3
}

/// conservative_v1_A_v1_A_v2_conjA_v2 = (omega3^2*b1122 - 2*a113*a223)/(omega1*omega3^2) +
/// a123^2/(2*omega1*(omega1 + omega2 + omega3)*(omega1 + omega2 - omega3)) + a123^2/(2*omega1*(omega1 - omega2 +
/// omega3)*(omega1 - omega2 - omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 38 operations.
template <class Scalar>
Scalar lump_0(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar b1122 = parameters[8];
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar a123_2 = a123 * a123;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_2 = Scalar(1.0) / (omega1 - omega2 + omega3);
  const Scalar per_3 = Scalar(1.0) / (omega1 - omega2 - omega3);
  const Scalar f_0 = b1122 / omega1;
  const Scalar f_1 = -Scalar(2.0) * a113 * a223 / (omega1 * omega3_2);
  const Scalar f_2 = a123_2 * per_0 * per_1 / (Scalar(2.0) * omega1);
  const Scalar f_3 = a123_2 * per_2 * per_3 / (Scalar(2.0) * omega1);
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_2 * per_0;
  const Scalar q_1 = f_2 * per_1;
  const Scalar q_2 = f_3 * per_2;
  const Scalar q_3 = f_3 * per_3;
  gradient[0] = (-f_0 - f_1 - f_2 - f_3) / omega1 - q_0 - q_1 - q_2 - q_3;  // by omega1
  gradient[1] = -q_0 - q_1 + q_2 + q_3;  // by omega2
  gradient[2] = -Scalar(2.0) * f_1 / omega3 - q_0 + q_1 - q_2 + q_3;  // by omega3
  const Scalar c_0 = -Scalar(2.0) / (omega1 * omega3_2);  // multiplies a113*a223
  // multiplies a123^2
  const Scalar c_1 = per_0 * per_1 / (Scalar(2.0) * omega1) + per_2 * per_3 / (Scalar(2.0) * omega1);
  const Scalar c_2 = Scalar(1.0) / omega1;  // multiplies b1122
  gradient[3] = a223 * c_0;  // by a113
  gradient[4] = Scalar(2.0) * a123 * c_1;  // by a123
  gradient[5] = a113 * c_0;  // by a223
  gradient[8] = c_2;  // by b1122
  return value;
}

/// conservative_v1_A_v12_conjA_v1 = 3*b1111/(2*omega1) + (-8*omega1^2*a113^2 +
/// 3*omega3^2*a113^2)/(omega1*omega3^2*(2*omega1 + omega3)*(2*omega1 - omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 28 operations.
template <class Scalar>
Scalar lump_1(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar b1111 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar a113_2 = a113 * a113;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega3);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega3);
  const Scalar f_0 = Scalar(3.0) * b1111 / (Scalar(2.0) * omega1);
  const Scalar f_1 = -Scalar(8.0) * omega1 * a113_2 * per_0 * per_1 / omega3_2;
  const Scalar f_2 = Scalar(3.0) * a113_2 * per_0 * per_1 / omega1;
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_1 + f_2) * per_0;
  const Scalar q_1 = (f_1 + f_2) * per_1;
  gradient[0] = (-f_0 + f_1 - f_2) / omega1 - Scalar(2.0) * q_0 - Scalar(2.0) * q_1;  // by omega1
  gradient[2] = -Scalar(2.0) * f_1 / omega3 - q_0 + q_1;  // by omega3
  // multiplies a113^2
  const Scalar c_0 = (-Scalar(8.0) * omega1_2 + Scalar(3.0) * omega3_2) * per_0 * per_1 / (omega1 * omega3_2);
  const Scalar c_1 = Scalar(3.0) / (Scalar(2.0) * omega1);  // multiplies b1111
  gradient[3] = Scalar(2.0) * a113 * c_0;  // by a113
  gradient[7] = c_1;  // by b1111
  return value;
}

/// conservative_v1_conjA_v2_F = -e12/(4*omega1) - a123*e3/(4*omega1*(omega1 + omega2 + omega3)*(omega1 + omega2
/// - omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 19 operations.
template <class Scalar>
Scalar lump_2(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a123 = parameters[4];
  const Scalar e12 = parameters[12];
  const Scalar e3 = parameters[18];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar f_0 = -e12 / (Scalar(4.0) * omega1);
  const Scalar f_1 = -a123 * e3 * per_0 * per_1 / (Scalar(4.0) * omega1);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_1 * per_0;
  const Scalar q_1 = f_1 * per_1;
  gradient[0] = (-f_0 - f_1) / omega1 - q_0 - q_1;  // by omega1
  gradient[1] = -q_0 - q_1;  // by omega2
  gradient[2] = -q_0 + q_1;  // by omega3
  const Scalar c_0 = -per_0 * per_1 / (Scalar(4.0) * omega1);  // multiplies a123*e3
  const Scalar c_1 = -Scalar(1.0) / (Scalar(4.0) * omega1);  // multiplies e12
  gradient[4] = e3 * c_0;  // by a123
  gradient[12] = c_1;  // by e12
  gradient[18] = a123 * c_0;  // by e3
  return value;
}

/// conservative_v2_A_v22_conjA_v2 = 3*b2222/(2*omega2) + (-8*omega2^2*a223^2 +
/// 3*omega3^2*a223^2)/(omega2*omega3^2*(2*omega2 + omega3)*(2*omega2 - omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 28 operations.
template <class Scalar>
Scalar lump_3(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a223 = parameters[5];
  const Scalar b2222 = parameters[9];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar a223_2 = a223 * a223;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega2 + omega3);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega2 - omega3);
  const Scalar f_0 = Scalar(3.0) * b2222 / (Scalar(2.0) * omega2);
  const Scalar f_1 = -Scalar(8.0) * omega2 * a223_2 * per_0 * per_1 / omega3_2;
  const Scalar f_2 = Scalar(3.0) * a223_2 * per_0 * per_1 / omega2;
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_1 + f_2) * per_0;
  const Scalar q_1 = (f_1 + f_2) * per_1;
  gradient[1] = (-f_0 + f_1 - f_2) / omega2 - Scalar(2.0) * q_0 - Scalar(2.0) * q_1;  // by omega2
  gradient[2] = -Scalar(2.0) * f_1 / omega3 - q_0 + q_1;  // by omega3
  // multiplies a223^2
  const Scalar c_0 = (-Scalar(8.0) * omega2_2 + Scalar(3.0) * omega3_2) * per_0 * per_1 / (omega2 * omega3_2);
  const Scalar c_1 = Scalar(3.0) / (Scalar(2.0) * omega2);  // multiplies b2222
  gradient[5] = Scalar(2.0) * a223 * c_0;  // by a223
  gradient[9] = c_1;  // by b2222
  return value;
}

/// harmonic_re_v1_A_v2_conjA_v12 = (9*omega1^2*a113*a123 - 2*omega1*omega2*a113*a123 + omega2^2*a113*a123 -
/// 3*omega3^2*a113*a123)/((omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3)*(2*omega1 +
/// omega3)*(2*omega1 - omega3)*(3*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 66 operations.
template <class Scalar>
Scalar lump_4(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2 + omega3);
  const Scalar per_2 = Scalar(1.0) / (omega1 - omega2 - omega3);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega3);
  const Scalar per_4 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega3);
  const Scalar per_5 = Scalar(1.0) / (Scalar(3.0) * omega1 - omega2);
  const Scalar f_0 = Scalar(9.0) * omega1_2 * a113 * a123 * per_0 * per_1 * per_2 * per_3 * per_4 * per_5;
  const Scalar f_1 = -Scalar(2.0) * omega1 * omega2 * a113 * a123 * per_0 * per_1 * per_2 * per_3 * per_4 * per_5;
  const Scalar f_2 = omega2_2 * a113 * a123 * per_0 * per_1 * per_2 * per_3 * per_4 * per_5;
  const Scalar f_3 = -Scalar(3.0) * omega3_2 * a113 * a123 * per_0 * per_1 * per_2 * per_3 * per_4 * per_5;
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3) * per_1;
  const Scalar q_2 = (f_0 + f_1 + f_2 + f_3) * per_2;
  const Scalar q_3 = (f_0 + f_1 + f_2 + f_3) * per_3;
  const Scalar q_4 = (f_0 + f_1 + f_2 + f_3) * per_4;
  const Scalar q_5 = (f_0 + f_1 + f_2 + f_3) * per_5;
  // by omega1
  gradient[0] = (Scalar(2.0) * f_0 + f_1) / omega1 - q_0 - q_1 - q_2 - Scalar(2.0) * q_3 - Scalar(2.0) * q_4
      - Scalar(3.0) * q_5;
  gradient[1] = (f_1 + Scalar(2.0) * f_2) / omega2 + q_0 + q_1 + q_2 + q_5;  // by omega2
  gradient[2] = Scalar(2.0) * f_3 / omega3 - q_1 + q_2 - q_3 + q_4;  // by omega3
  // multiplies a113*a123
  const Scalar c_0 = (Scalar(9.0) * omega1_2 - Scalar(2.0) * omega1 * omega2 + omega2_2
      - Scalar(3.0) * omega3_2) * per_0 * per_1 * per_2 * per_3 * per_4 * per_5;
  gradient[3] = a123 * c_0;  // by a113
  gradient[4] = a113 * c_0;  // by a123
  return value;
}

/// harmonic_re_v1_conjA_v1_F = a113*e3/((omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 -
/// omega3)*(omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 19 operations.
template <class Scalar>
Scalar lump_5(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar e3 = parameters[18];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_3 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = a113 * e3 * per_0 * per_1 * per_2 * per_3;
  const Scalar value = f_0;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_0 * per_0;
  const Scalar q_1 = f_0 * per_1;
  const Scalar q_2 = f_0 * per_2;
  const Scalar q_3 = f_0 * per_3;
  gradient[0] = -q_0 - q_1 - q_2 - q_3;  // by omega1
  gradient[1] = -q_0 - q_1 - q_2 + q_3;  // by omega2
  gradient[2] = -q_1 + q_2;  // by omega3
  const Scalar c_0 = per_0 * per_1 * per_2 * per_3;  // multiplies a113*e3
  gradient[3] = e3 * c_0;  // by a113
  gradient[18] = a113 * c_0;  // by e3
  return value;
}

/// harmonic_re_v1_A_v22_conjA_v2 = (8*omega2^2*a123*a223 - 3*omega3^2*a123*a223)/(omega3^2*(omega1 +
/// omega2)*(omega1 - omega2)*(2*omega2 + omega3)*(2*omega2 - omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 32 operations.
template <class Scalar>
Scalar lump_6(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega2 + omega3);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega2 - omega3);
  const Scalar f_0 = Scalar(8.0) * omega2_2 * a123 * a223 * per_0 * per_1 * per_2 * per_3 / omega3_2;
  const Scalar f_1 = -Scalar(3.0) * a123 * a223 * per_0 * per_1 * per_2 * per_3;
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1) * per_0;
  const Scalar q_1 = (f_0 + f_1) * per_1;
  const Scalar q_2 = (f_0 + f_1) * per_2;
  const Scalar q_3 = (f_0 + f_1) * per_3;
  gradient[0] = -q_0 - q_1;  // by omega1
  gradient[1] = Scalar(2.0) * f_0 / omega2 - q_0 + q_1 - Scalar(2.0) * q_2 - Scalar(2.0) * q_3;  // by omega2
  gradient[2] = -Scalar(2.0) * f_0 / omega3 - q_2 + q_3;  // by omega3
  // multiplies a123*a223
  const Scalar c_0 = (Scalar(8.0) * omega2_2 - Scalar(3.0) * omega3_2) * per_0 * per_1 * per_2 * per_3 / omega3_2;
  gradient[4] = a223 * c_0;  // by a123
  gradient[5] = a123 * c_0;  // by a223
  return value;
}

/// harmonic_re_v1_A_v22_conjA_v1 = -b1122/(4*omega2*(omega1 - omega2)) - a123^2/(4*omega2*(omega1 -
/// omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3)) - a113*a223/(2*omega2*(omega1 -
/// omega2)*(2*omega2 + omega3)*(2*omega2 - omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 42 operations.
template <class Scalar>
Scalar lump_7(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar b1122 = parameters[8];
  const Scalar a123_2 = a123 * a123;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2 + omega3);
  const Scalar per_2 = Scalar(1.0) / (omega1 - omega2 - omega3);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega2 + omega3);
  const Scalar per_4 = Scalar(1.0) / (Scalar(2.0) * omega2 - omega3);
  const Scalar f_0 = -b1122 * per_0 / (Scalar(4.0) * omega2);
  const Scalar f_1 = -a123_2 * per_0 * per_1 * per_2 / (Scalar(4.0) * omega2);
  const Scalar f_2 = -a113 * a223 * per_0 * per_3 * per_4 / (Scalar(2.0) * omega2);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2) * per_0;
  const Scalar q_1 = f_1 * per_1;
  const Scalar q_2 = f_1 * per_2;
  const Scalar q_3 = f_2 * per_3;
  const Scalar q_4 = f_2 * per_4;
  gradient[0] = -q_0 - q_1 - q_2;  // by omega1
  gradient[1] = (-f_0 - f_1 - f_2) / omega2 + q_0 + q_1 + q_2 - Scalar(2.0) * q_3 - Scalar(2.0) * q_4;  // by omega2
  gradient[2] = -q_1 + q_2 - q_3 + q_4;  // by omega3
  const Scalar c_0 = -per_0 * per_3 * per_4 / (Scalar(2.0) * omega2);  // multiplies a113*a223
  const Scalar c_1 = -per_0 * per_1 * per_2 / (Scalar(4.0) * omega2);  // multiplies a123^2
  const Scalar c_2 = -per_0 / (Scalar(4.0) * omega2);  // multiplies b1122
  gradient[3] = a223 * c_0;  // by a113
  gradient[4] = Scalar(2.0) * a123 * c_1;  // by a123
  gradient[5] = a113 * c_0;  // by a223
  gradient[8] = c_2;  // by b1122
  return value;
}

/// harmonic_re_v1_A_v1_A_v22 = b1122/(4*omega2*(omega1 + omega2)) + a123^2/(4*omega2*(omega1 + omega2)*(omega1 +
/// omega2 + omega3)*(omega1 + omega2 - omega3)) + a113*a223/(2*omega2*(omega1 + omega2)*(2*omega2 +
/// omega3)*(2*omega2 - omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 42 operations.
template <class Scalar>
Scalar lump_8(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar b1122 = parameters[8];
  const Scalar a123_2 = a123 * a123;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega2 + omega3);
  const Scalar per_4 = Scalar(1.0) / (Scalar(2.0) * omega2 - omega3);
  const Scalar f_0 = b1122 * per_0 / (Scalar(4.0) * omega2);
  const Scalar f_1 = a123_2 * per_0 * per_1 * per_2 / (Scalar(4.0) * omega2);
  const Scalar f_2 = a113 * a223 * per_0 * per_3 * per_4 / (Scalar(2.0) * omega2);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2) * per_0;
  const Scalar q_1 = f_1 * per_1;
  const Scalar q_2 = f_1 * per_2;
  const Scalar q_3 = f_2 * per_3;
  const Scalar q_4 = f_2 * per_4;
  gradient[0] = -q_0 - q_1 - q_2;  // by omega1
  gradient[1] = (-f_0 - f_1 - f_2) / omega2 - q_0 - q_1 - q_2 - Scalar(2.0) * q_3 - Scalar(2.0) * q_4;  // by omega2
  gradient[2] = -q_1 + q_2 - q_3 + q_4;  // by omega3
  const Scalar c_0 = per_0 * per_3 * per_4 / (Scalar(2.0) * omega2);  // multiplies a113*a223
  const Scalar c_1 = per_0 * per_1 * per_2 / (Scalar(4.0) * omega2);  // multiplies a123^2
  const Scalar c_2 = per_0 / (Scalar(4.0) * omega2);  // multiplies b1122
  gradient[3] = a223 * c_0;  // by a113
  gradient[4] = Scalar(2.0) * a123 * c_1;  // by a123
  gradient[5] = a113 * c_0;  // by a223
  gradient[8] = c_2;  // by b1122
  return value;
}

/// harmonic_re_v1_A_v13 = b1111/(8*omega1^2) + a113^2/(4*omega1^2*(2*omega1 + omega3)*(2*omega1 - omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 19 operations.
template <class Scalar>
Scalar lump_9(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar b1111 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar a113_2 = a113 * a113;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega3);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega3);
  const Scalar f_0 = b1111 / (Scalar(8.0) * omega1_2);
  const Scalar f_1 = a113_2 * per_0 * per_1 / (Scalar(4.0) * omega1_2);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_1 * per_0;
  const Scalar q_1 = f_1 * per_1;
  // by omega1
  gradient[0] = (-Scalar(2.0) * f_0 - Scalar(2.0) * f_1) / omega1 - Scalar(2.0) * q_0 - Scalar(2.0) * q_1;
  gradient[2] = -q_0 + q_1;  // by omega3
  const Scalar c_0 = per_0 * per_1 / (Scalar(4.0) * omega1_2);  // multiplies a113^2
  const Scalar c_1 = Scalar(1.0) / (Scalar(8.0) * omega1_2);  // multiplies b1111
  gradient[3] = Scalar(2.0) * a113 * c_0;  // by a113
  gradient[7] = c_1;  // by b1111
  return value;
}

/// harmonic_re_v2_A_v2_conjA_v12 = b1122/(4*omega1*(omega1 - omega2)) + a123^2/(4*omega1*(omega1 -
/// omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3)) + a113*a223/(2*omega1*(omega1 -
/// omega2)*(2*omega1 + omega3)*(2*omega1 - omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 42 operations.
template <class Scalar>
Scalar lump_10(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar b1122 = parameters[8];
  const Scalar a123_2 = a123 * a123;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2 + omega3);
  const Scalar per_2 = Scalar(1.0) / (omega1 - omega2 - omega3);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega3);
  const Scalar per_4 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega3);
  const Scalar f_0 = b1122 * per_0 / (Scalar(4.0) * omega1);
  const Scalar f_1 = a123_2 * per_0 * per_1 * per_2 / (Scalar(4.0) * omega1);
  const Scalar f_2 = a113 * a223 * per_0 * per_3 * per_4 / (Scalar(2.0) * omega1);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2) * per_0;
  const Scalar q_1 = f_1 * per_1;
  const Scalar q_2 = f_1 * per_2;
  const Scalar q_3 = f_2 * per_3;
  const Scalar q_4 = f_2 * per_4;
  gradient[0] = (-f_0 - f_1 - f_2) / omega1 - q_0 - q_1 - q_2 - Scalar(2.0) * q_3 - Scalar(2.0) * q_4;  // by omega1
  gradient[1] = q_0 + q_1 + q_2;  // by omega2
  gradient[2] = -q_1 + q_2 - q_3 + q_4;  // by omega3
  const Scalar c_0 = per_0 * per_3 * per_4 / (Scalar(2.0) * omega1);  // multiplies a113*a223
  const Scalar c_1 = per_0 * per_1 * per_2 / (Scalar(4.0) * omega1);  // multiplies a123^2
  const Scalar c_2 = per_0 / (Scalar(4.0) * omega1);  // multiplies b1122
  gradient[3] = a223 * c_0;  // by a113
  gradient[4] = Scalar(2.0) * a123 * c_1;  // by a123
  gradient[5] = a113 * c_0;  // by a223
  gradient[8] = c_2;  // by b1122
  return value;
}

/// harmonic_re_v2_conjA_v2_F = -a223*e3/((omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 -
/// omega3)*(omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 19 operations.
template <class Scalar>
Scalar lump_11(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a223 = parameters[5];
  const Scalar e3 = parameters[18];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_3 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -a223 * e3 * per_0 * per_1 * per_2 * per_3;
  const Scalar value = f_0;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_0 * per_0;
  const Scalar q_1 = f_0 * per_1;
  const Scalar q_2 = f_0 * per_2;
  const Scalar q_3 = f_0 * per_3;
  gradient[0] = -q_0 - q_1 - q_2 - q_3;  // by omega1
  gradient[1] = -q_0 - q_1 - q_2 + q_3;  // by omega2
  gradient[2] = -q_1 + q_2;  // by omega3
  const Scalar c_0 = -per_0 * per_1 * per_2 * per_3;  // multiplies a223*e3
  gradient[5] = e3 * c_0;  // by a223
  gradient[18] = a223 * c_0;  // by e3
  return value;
}

/// harmonic_re_v2_A_v23 = b2222/(8*omega2^2) + a223^2/(4*omega2^2*(2*omega2 + omega3)*(2*omega2 - omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 19 operations.
template <class Scalar>
Scalar lump_12(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a223 = parameters[5];
  const Scalar b2222 = parameters[9];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar a223_2 = a223 * a223;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega2 + omega3);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega2 - omega3);
  const Scalar f_0 = b2222 / (Scalar(8.0) * omega2_2);
  const Scalar f_1 = a223_2 * per_0 * per_1 / (Scalar(4.0) * omega2_2);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_1 * per_0;
  const Scalar q_1 = f_1 * per_1;
  // by omega2
  gradient[1] = (-Scalar(2.0) * f_0 - Scalar(2.0) * f_1) / omega2 - Scalar(2.0) * q_0 - Scalar(2.0) * q_1;
  gradient[2] = -q_0 + q_1;  // by omega3
  const Scalar c_0 = per_0 * per_1 / (Scalar(4.0) * omega2_2);  // multiplies a223^2
  const Scalar c_1 = Scalar(1.0) / (Scalar(8.0) * omega2_2);  // multiplies b2222
  gradient[5] = Scalar(2.0) * a223 * c_0;  // by a223
  gradient[9] = c_1;  // by b2222
  return value;
}

/// harmonic_re_v2_A_v12_A_v2 = b1122/(4*omega1*(omega1 + omega2)) + a123^2/(4*omega1*(omega1 + omega2)*(omega1 +
/// omega2 + omega3)*(omega1 + omega2 - omega3)) + a113*a223/(2*omega1*(omega1 + omega2)*(2*omega1 +
/// omega3)*(2*omega1 - omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 42 operations.
template <class Scalar>
Scalar lump_13(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar b1122 = parameters[8];
  const Scalar a123_2 = a123 * a123;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega3);
  const Scalar per_4 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega3);
  const Scalar f_0 = b1122 * per_0 / (Scalar(4.0) * omega1);
  const Scalar f_1 = a123_2 * per_0 * per_1 * per_2 / (Scalar(4.0) * omega1);
  const Scalar f_2 = a113 * a223 * per_0 * per_3 * per_4 / (Scalar(2.0) * omega1);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2) * per_0;
  const Scalar q_1 = f_1 * per_1;
  const Scalar q_2 = f_1 * per_2;
  const Scalar q_3 = f_2 * per_3;
  const Scalar q_4 = f_2 * per_4;
  gradient[0] = (-f_0 - f_1 - f_2) / omega1 - q_0 - q_1 - q_2 - Scalar(2.0) * q_3 - Scalar(2.0) * q_4;  // by omega1
  gradient[1] = -q_0 - q_1 - q_2;  // by omega2
  gradient[2] = -q_1 + q_2 - q_3 + q_4;  // by omega3
  const Scalar c_0 = per_0 * per_3 * per_4 / (Scalar(2.0) * omega1);  // multiplies a113*a223
  const Scalar c_1 = per_0 * per_1 * per_2 / (Scalar(4.0) * omega1);  // multiplies a123^2
  const Scalar c_2 = per_0 / (Scalar(4.0) * omega1);  // multiplies b1122
  gradient[3] = a223 * c_0;  // by a113
  gradient[4] = Scalar(2.0) * a123 * c_1;  // by a123
  gradient[5] = a113 * c_0;  // by a223
  gradient[8] = c_2;  // by b1122
  return value;
}

/// harmonic_re_v3_conjA_v1_F = -a123*e2/(2*omega1*(omega1 + 2*omega2)*(omega2 + omega3)*(omega2 - omega3)) -
/// a113*e1/(omega2*(2*omega1 + omega2)*(omega2 + omega3)*(omega2 - omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 30 operations.
template <class Scalar>
Scalar lump_14(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar e1 = parameters[14];
  const Scalar e2 = parameters[16];
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega2 + omega3);
  const Scalar per_2 = Scalar(1.0) / (omega2 - omega3);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar f_0 = -a123 * e2 * per_0 * per_1 * per_2 / (Scalar(2.0) * omega1);
  const Scalar f_1 = -a113 * e1 * per_3 * per_1 * per_2 / omega2;
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_0 * per_0;
  const Scalar q_1 = (f_0 + f_1) * per_1;
  const Scalar q_2 = (f_0 + f_1) * per_2;
  const Scalar q_3 = f_1 * per_3;
  gradient[0] = -f_0 / omega1 - q_0 - Scalar(2.0) * q_3;  // by omega1
  gradient[1] = -f_1 / omega2 - Scalar(2.0) * q_0 - q_1 - q_2 - q_3;  // by omega2
  gradient[2] = -q_1 + q_2;  // by omega3
  const Scalar c_0 = -per_3 * per_1 * per_2 / omega2;  // multiplies a113*e1
  const Scalar c_1 = -per_0 * per_1 * per_2 / (Scalar(2.0) * omega1);  // multiplies a123*e2
  gradient[3] = e1 * c_0;  // by a113
  gradient[4] = e2 * c_1;  // by a123
  gradient[14] = a113 * c_0;  // by e1
  gradient[16] = a123 * c_1;  // by e2
  return value;
}

/// harmonic_re_v3_conjA_v2_F = -a223*e2/(omega1*(omega1 + 2*omega2)*(omega1 + omega3)*(omega1 - omega3)) -
/// a123*e1/(2*omega2*(omega1 + omega3)*(omega1 - omega3)*(2*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 30 operations.
template <class Scalar>
Scalar lump_15(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar e1 = parameters[14];
  const Scalar e2 = parameters[16];
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega3);
  const Scalar per_2 = Scalar(1.0) / (omega1 - omega3);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar f_0 = -a223 * e2 * per_0 * per_1 * per_2 / omega1;
  const Scalar f_1 = -a123 * e1 * per_1 * per_2 * per_3 / (Scalar(2.0) * omega2);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_0 * per_0;
  const Scalar q_1 = (f_0 + f_1) * per_1;
  const Scalar q_2 = (f_0 + f_1) * per_2;
  const Scalar q_3 = f_1 * per_3;
  gradient[0] = -f_0 / omega1 - q_0 - q_1 - q_2 - Scalar(2.0) * q_3;  // by omega1
  gradient[1] = -f_1 / omega2 - Scalar(2.0) * q_0 - q_3;  // by omega2
  gradient[2] = -q_1 + q_2;  // by omega3
  const Scalar c_0 = -per_1 * per_2 * per_3 / (Scalar(2.0) * omega2);  // multiplies a123*e1
  const Scalar c_1 = -per_0 * per_1 * per_2 / omega1;  // multiplies a223*e2
  gradient[4] = e1 * c_0;  // by a123
  gradient[5] = e2 * c_1;  // by a223
  gradient[14] = a123 * c_0;  // by e1
  gradient[16] = a223 * c_1;  // by e2
  return value;
}

/// conservative_v1_A_v1_A_v3_conjA_v3 = (omega3^2*b1133 - 2*a113*a333)/(omega1*omega3^2) +
/// a123^2/(2*omega1*(omega1 + omega2 + omega3)*(omega1 - omega2 + omega3)) + a123^2/(2*omega1*(omega1 + omega2 -
/// omega3)*(omega1 - omega2 - omega3)) - 4*a113^2/(omega1*(2*omega1 + omega3)*(2*omega1 - omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 52 operations.
template <class Scalar>
Scalar lump_16(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a333 = parameters[6];
  const Scalar b1133 = parameters[10];
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar a113_2 = a113 * a113;
  const Scalar a123_2 = a123 * a123;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2 + omega3);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_3 = Scalar(1.0) / (omega1 - omega2 - omega3);
  const Scalar per_4 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega3);
  const Scalar per_5 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega3);
  const Scalar f_0 = b1133 / omega1;
  const Scalar f_1 = -Scalar(2.0) * a113 * a333 / (omega1 * omega3_2);
  const Scalar f_2 = a123_2 * per_0 * per_1 / (Scalar(2.0) * omega1);
  const Scalar f_3 = a123_2 * per_2 * per_3 / (Scalar(2.0) * omega1);
  const Scalar f_4 = -Scalar(4.0) * a113_2 * per_4 * per_5 / omega1;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_2 * per_0;
  const Scalar q_1 = f_2 * per_1;
  const Scalar q_2 = f_3 * per_2;
  const Scalar q_3 = f_3 * per_3;
  const Scalar q_4 = f_4 * per_4;
  const Scalar q_5 = f_4 * per_5;
  // by omega1
  gradient[0] = (-f_0 - f_1 - f_2 - f_3 - f_4) / omega1 - q_0 - q_1 - q_2 - q_3 - Scalar(2.0) * q_4
      - Scalar(2.0) * q_5;
  gradient[1] = -q_0 + q_1 - q_2 + q_3;  // by omega2
  gradient[2] = -Scalar(2.0) * f_1 / omega3 - q_0 - q_1 + q_2 + q_3 - q_4 + q_5;  // by omega3
  const Scalar c_0 = -Scalar(4.0) * per_4 * per_5 / omega1;  // multiplies a113^2
  const Scalar c_1 = -Scalar(2.0) / (omega1 * omega3_2);  // multiplies a113*a333
  // multiplies a123^2
  const Scalar c_2 = per_0 * per_1 / (Scalar(2.0) * omega1) + per_2 * per_3 / (Scalar(2.0) * omega1);
  const Scalar c_3 = Scalar(1.0) / omega1;  // multiplies b1133
  gradient[3] = Scalar(2.0) * a113 * c_0 + a333 * c_1;  // by a113
  gradient[4] = Scalar(2.0) * a123 * c_2;  // by a123
  gradient[6] = a113 * c_1;  // by a333
  gradient[10] = c_3;  // by b1133
  return value;
}

/// conservative_v2_A_v2_A_v3_conjA_v3 = (omega3^2*b2233 - 2*a223*a333)/(omega2*omega3^2) -
/// a123^2/(2*omega2*(omega1 + omega2 + omega3)*(omega1 - omega2 - omega3)) - a123^2/(2*omega2*(omega1 + omega2 -
/// omega3)*(omega1 - omega2 + omega3)) - 4*a223^2/(omega2*(2*omega2 + omega3)*(2*omega2 - omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 52 operations.
template <class Scalar>
Scalar lump_17(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar b2233 = parameters[11];
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar a123_2 = a123 * a123;
  const Scalar a223_2 = a223 * a223;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2 - omega3);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_3 = Scalar(1.0) / (omega1 - omega2 + omega3);
  const Scalar per_4 = Scalar(1.0) / (Scalar(2.0) * omega2 + omega3);
  const Scalar per_5 = Scalar(1.0) / (Scalar(2.0) * omega2 - omega3);
  const Scalar f_0 = b2233 / omega2;
  const Scalar f_1 = -Scalar(2.0) * a223 * a333 / (omega2 * omega3_2);
  const Scalar f_2 = -a123_2 * per_0 * per_1 / (Scalar(2.0) * omega2);
  const Scalar f_3 = -a123_2 * per_2 * per_3 / (Scalar(2.0) * omega2);
  const Scalar f_4 = -Scalar(4.0) * a223_2 * per_4 * per_5 / omega2;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_2 * per_0;
  const Scalar q_1 = f_2 * per_1;
  const Scalar q_2 = f_3 * per_2;
  const Scalar q_3 = f_3 * per_3;
  const Scalar q_4 = f_4 * per_4;
  const Scalar q_5 = f_4 * per_5;
  gradient[0] = -q_0 - q_1 - q_2 - q_3;  // by omega1
  // by omega2
  gradient[1] = (-f_0 - f_1 - f_2 - f_3 - f_4) / omega2 - q_0 + q_1 - q_2 + q_3 - Scalar(2.0) * q_4
      - Scalar(2.0) * q_5;
  gradient[2] = -Scalar(2.0) * f_1 / omega3 - q_0 + q_1 + q_2 - q_3 - q_4 + q_5;  // by omega3
  // multiplies a123^2
  const Scalar c_0 = -per_0 * per_1 / (Scalar(2.0) * omega2) - per_2 * per_3 / (Scalar(2.0) * omega2);
  const Scalar c_1 = -Scalar(4.0) * per_4 * per_5 / omega2;  // multiplies a223^2
  const Scalar c_2 = -Scalar(2.0) / (omega2 * omega3_2);  // multiplies a223*a333
  const Scalar c_3 = Scalar(1.0) / omega2;  // multiplies b2233
  gradient[4] = Scalar(2.0) * a123 * c_0;  // by a123
  gradient[5] = Scalar(2.0) * a223 * c_1 + a333 * c_2;  // by a223
  gradient[6] = a223 * c_2;  // by a333
  gradient[11] = c_3;  // by b2233
  return value;
}

/// harmonic_re_v1_A_v32_conjA_v1 = (-3*omega3^2*b1133 - 2*a113*a333)/(12*omega3^3*(omega1 - omega3)) +
/// a113^2/(omega3^2*(omega1 - omega3)*(2*omega1 - omega3)) - a123^2/(4*omega3*(omega1 + omega2 - omega3)*(omega1
/// - omega2 - omega3)*(omega1 - omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 42 operations.
template <class Scalar>
Scalar lump_18(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a333 = parameters[6];
  const Scalar b1133 = parameters[10];
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar a113_2 = a113 * a113;
  const Scalar a123_2 = a123 * a123;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega3);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega3);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_3 = Scalar(1.0) / (omega1 - omega2 - omega3);
  const Scalar f_0 = -b1133 * per_0 / (Scalar(4.0) * omega3);
  const Scalar f_1 = -a113 * a333 * per_0 / (Scalar(6.0) * omega3_3);
  const Scalar f_2 = a113_2 * per_0 * per_1 / omega3_2;
  const Scalar f_3 = -a123_2 * per_2 * per_3 * per_0 / (Scalar(4.0) * omega3);
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = f_2 * per_1;
  const Scalar q_2 = f_3 * per_2;
  const Scalar q_3 = f_3 * per_3;
  gradient[0] = -q_0 - Scalar(2.0) * q_1 - q_2 - q_3;  // by omega1
  gradient[1] = -q_2 + q_3;  // by omega2
  gradient[2] = (-f_0 - Scalar(3.0) * f_1 - Scalar(2.0) * f_2 - f_3) / omega3 + q_0 + q_1 + q_2 + q_3;  // by omega3
  const Scalar c_0 = per_0 * per_1 / omega3_2;  // multiplies a113^2
  const Scalar c_1 = -per_0 / (Scalar(6.0) * omega3_3);  // multiplies a113*a333
  const Scalar c_2 = -per_2 * per_3 * per_0 / (Scalar(4.0) * omega3);  // multiplies a123^2
  const Scalar c_3 = -per_0 / (Scalar(4.0) * omega3);  // multiplies b1133
  gradient[3] = Scalar(2.0) * a113 * c_0 + a333 * c_1;  // by a113
  gradient[4] = Scalar(2.0) * a123 * c_2;  // by a123
  gradient[6] = a113 * c_1;  // by a333
  gradient[10] = c_3;  // by b1133
  return value;
}

/// harmonic_re_v1_A_v32_conjA_v2 = -a123*a333/(3*omega3^2*(omega1 + omega2 - 2*omega3)*(omega1 - omega2 +
/// 2*omega3)) + 2*a123*a223/(omega3*(omega1 + omega2 - 2*omega3)*(omega1 - omega2 + 2*omega3)*(2*omega2 -
/// omega3)) + 2*a113*a123/((omega1 + omega2 - omega3)*(omega1 + omega2 - 2*omega3)*(omega1 - omega2 +
/// omega3)*(omega1 - omega2 + 2*omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 46 operations.
template <class Scalar>
Scalar lump_19(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2 - Scalar(2.0) * omega3);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2 + Scalar(2.0) * omega3);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega2 - omega3);
  const Scalar per_3 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_4 = Scalar(1.0) / (omega1 - omega2 + omega3);
  const Scalar f_0 = -a123 * a333 * per_0 * per_1 / (Scalar(3.0) * omega3_2);
  const Scalar f_1 = Scalar(2.0) * a123 * a223 * per_0 * per_1 * per_2 / omega3;
  const Scalar f_2 = Scalar(2.0) * a113 * a123 * per_3 * per_0 * per_4 * per_1;
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2) * per_1;
  const Scalar q_2 = f_1 * per_2;
  const Scalar q_3 = f_2 * per_3;
  const Scalar q_4 = f_2 * per_4;
  gradient[0] = -q_0 - q_1 - q_3 - q_4;  // by omega1
  gradient[1] = -q_0 + q_1 - Scalar(2.0) * q_2 - q_3 + q_4;  // by omega2
  // by omega3
  gradient[2] = (-Scalar(2.0) * f_0 - f_1) / omega3 + Scalar(2.0) * q_0 - Scalar(2.0) * q_1 + q_2 + q_3 - q_4;
  const Scalar c_0 = Scalar(2.0) * per_3 * per_0 * per_4 * per_1;  // multiplies a113*a123
  const Scalar c_1 = Scalar(2.0) * per_0 * per_1 * per_2 / omega3;  // multiplies a123*a223
  const Scalar c_2 = -per_0 * per_1 / (Scalar(3.0) * omega3_2);  // multiplies a123*a333
  gradient[3] = a123 * c_0;  // by a113
  gradient[4] = a113 * c_0 + a223 * c_1 + a333 * c_2;  // by a123
  gradient[5] = a123 * c_1;  // by a223
  gradient[6] = a123 * c_2;  // by a333
  return value;
}

/// harmonic_re_v1_A_v2_A_v3_conjA_v3 = 2*a123*a333/(omega3^2*(omega1 + omega2)*(omega1 - omega2)) +
/// 4*a123*a223/((omega1 + omega2)*(omega1 - omega2)*(2*omega2 + omega3)*(2*omega2 - omega3)) +
/// (4*omega1^2*a113*a123 - 4*omega2^2*a113*a123 - 4*omega3^2*a113*a123)/((omega1 + omega2)*(omega1 + omega2 +
/// omega3)*(omega1 + omega2 - omega3)*(omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 78 operations.
template <class Scalar>
Scalar lump_20(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega2 + omega3);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega2 - omega3);
  const Scalar per_4 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_5 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_6 = Scalar(1.0) / (omega1 - omega2 + omega3);
  const Scalar per_7 = Scalar(1.0) / (omega1 - omega2 - omega3);
  const Scalar f_0 = Scalar(2.0) * a123 * a333 * per_0 * per_1 / omega3_2;
  const Scalar f_1 = Scalar(4.0) * a123 * a223 * per_0 * per_1 * per_2 * per_3;
  const Scalar f_2 = Scalar(4.0) * omega1_2 * a113 * a123 * per_0 * per_4 * per_5 * per_1 * per_6 * per_7;
  const Scalar f_3 = -Scalar(4.0) * omega2_2 * a113 * a123 * per_0 * per_4 * per_5 * per_1 * per_6 * per_7;
  const Scalar f_4 = -Scalar(4.0) * omega3_2 * a113 * a123 * per_0 * per_4 * per_5 * per_1 * per_6 * per_7;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_1;
  const Scalar q_2 = f_1 * per_2;
  const Scalar q_3 = f_1 * per_3;
  const Scalar q_4 = (f_2 + f_3 + f_4) * per_4;
  const Scalar q_5 = (f_2 + f_3 + f_4) * per_5;
  const Scalar q_6 = (f_2 + f_3 + f_4) * per_6;
  const Scalar q_7 = (f_2 + f_3 + f_4) * per_7;
  gradient[0] = Scalar(2.0) * f_2 / omega1 - q_0 - q_1 - q_4 - q_5 - q_6 - q_7;  // by omega1
  // by omega2
  gradient[1] = Scalar(2.0) * f_3 / omega2 - q_0 + q_1 - Scalar(2.0) * q_2 - Scalar(2.0) * q_3 - q_4 - q_5 + q_6
      + q_7;
  gradient[2] = (-Scalar(2.0) * f_0 + Scalar(2.0) * f_4) / omega3 - q_2 + q_3 - q_4 + q_5 - q_6 + q_7;  // by omega3
  // multiplies a113*a123
  const Scalar c_0 = (Scalar(4.0) * omega1_2 - Scalar(4.0) * omega2_2
      - Scalar(4.0) * omega3_2) * per_0 * per_4 * per_5 * per_1 * per_6 * per_7;
  const Scalar c_1 = Scalar(4.0) * per_0 * per_1 * per_2 * per_3;  // multiplies a123*a223
  const Scalar c_2 = Scalar(2.0) * per_0 * per_1 / omega3_2;  // multiplies a123*a333
  gradient[3] = a123 * c_0;  // by a113
  gradient[4] = a113 * c_0 + a223 * c_1 + a333 * c_2;  // by a123
  gradient[5] = a123 * c_1;  // by a223
  gradient[6] = a123 * c_2;  // by a333
  return value;
}

/// harmonic_re_v1_A_v2_A_v32 = -a123*a333/(3*omega3^2*(omega1 + omega2 + 2*omega3)*(omega1 - omega2 - 2*omega3))
/// - 2*a123*a223/(omega3*(omega1 + omega2 + 2*omega3)*(omega1 - omega2 - 2*omega3)*(2*omega2 + omega3)) +
/// 2*a113*a123/((omega1 + omega2 + omega3)*(omega1 + omega2 + 2*omega3)*(omega1 - omega2 - omega3)*(omega1 -
/// omega2 - 2*omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 46 operations.
template <class Scalar>
Scalar lump_21(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2 + Scalar(2.0) * omega3);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2 - Scalar(2.0) * omega3);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega2 + omega3);
  const Scalar per_3 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_4 = Scalar(1.0) / (omega1 - omega2 - omega3);
  const Scalar f_0 = -a123 * a333 * per_0 * per_1 / (Scalar(3.0) * omega3_2);
  const Scalar f_1 = -Scalar(2.0) * a123 * a223 * per_0 * per_1 * per_2 / omega3;
  const Scalar f_2 = Scalar(2.0) * a113 * a123 * per_3 * per_0 * per_4 * per_1;
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2) * per_1;
  const Scalar q_2 = f_1 * per_2;
  const Scalar q_3 = f_2 * per_3;
  const Scalar q_4 = f_2 * per_4;
  gradient[0] = -q_0 - q_1 - q_3 - q_4;  // by omega1
  gradient[1] = -q_0 + q_1 - Scalar(2.0) * q_2 - q_3 + q_4;  // by omega2
  // by omega3
  gradient[2] = (-Scalar(2.0) * f_0 - f_1) / omega3 - Scalar(2.0) * q_0 + Scalar(2.0) * q_1 - q_2 - q_3 + q_4;
  const Scalar c_0 = Scalar(2.0) * per_3 * per_0 * per_4 * per_1;  // multiplies a113*a123
  const Scalar c_1 = -Scalar(2.0) * per_0 * per_1 * per_2 / omega3;  // multiplies a123*a223
  const Scalar c_2 = -per_0 * per_1 / (Scalar(3.0) * omega3_2);  // multiplies a123*a333
  gradient[3] = a123 * c_0;  // by a113
  gradient[4] = a113 * c_0 + a223 * c_1 + a333 * c_2;  // by a123
  gradient[5] = a123 * c_1;  // by a223
  gradient[6] = a123 * c_2;  // by a333
  return value;
}

/// harmonic_re_v1_A_v1_A_v32 = (3*omega3^2*b1133 + 2*a113*a333)/(12*omega3^3*(omega1 + omega3)) +
/// a113^2/(omega3^2*(omega1 + omega3)*(2*omega1 + omega3)) + a123^2/(4*omega3*(omega1 + omega2 + omega3)*(omega1
/// - omega2 + omega3)*(omega1 + omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 42 operations.
template <class Scalar>
Scalar lump_22(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a333 = parameters[6];
  const Scalar b1133 = parameters[10];
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar a113_2 = a113 * a113;
  const Scalar a123_2 = a123 * a123;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega3);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega3);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_3 = Scalar(1.0) / (omega1 - omega2 + omega3);
  const Scalar f_0 = b1133 * per_0 / (Scalar(4.0) * omega3);
  const Scalar f_1 = a113 * a333 * per_0 / (Scalar(6.0) * omega3_3);
  const Scalar f_2 = a113_2 * per_0 * per_1 / omega3_2;
  const Scalar f_3 = a123_2 * per_2 * per_3 * per_0 / (Scalar(4.0) * omega3);
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = f_2 * per_1;
  const Scalar q_2 = f_3 * per_2;
  const Scalar q_3 = f_3 * per_3;
  gradient[0] = -q_0 - Scalar(2.0) * q_1 - q_2 - q_3;  // by omega1
  gradient[1] = -q_2 + q_3;  // by omega2
  gradient[2] = (-f_0 - Scalar(3.0) * f_1 - Scalar(2.0) * f_2 - f_3) / omega3 - q_0 - q_1 - q_2 - q_3;  // by omega3
  const Scalar c_0 = per_0 * per_1 / omega3_2;  // multiplies a113^2
  const Scalar c_1 = per_0 / (Scalar(6.0) * omega3_3);  // multiplies a113*a333
  const Scalar c_2 = per_2 * per_3 * per_0 / (Scalar(4.0) * omega3);  // multiplies a123^2
  const Scalar c_3 = per_0 / (Scalar(4.0) * omega3);  // multiplies b1133
  gradient[3] = Scalar(2.0) * a113 * c_0 + a333 * c_1;  // by a113
  gradient[4] = Scalar(2.0) * a123 * c_2;  // by a123
  gradient[6] = a113 * c_1;  // by a333
  gradient[10] = c_3;  // by b1133
  return value;
}

/// harmonic_re_v2_A_v32_conjA_v1 = a123*a333/(3*omega3^2*(omega1 + omega2 - 2*omega3)*(omega1 - omega2 -
/// 2*omega3)) - 2*a113*a123/(omega3*(omega1 + omega2 - 2*omega3)*(omega1 - omega2 - 2*omega3)*(2*omega1 -
/// omega3)) + 2*a123*a223/((omega1 + omega2 - omega3)*(omega1 + omega2 - 2*omega3)*(omega1 - omega2 -
/// omega3)*(omega1 - omega2 - 2*omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 46 operations.
template <class Scalar>
Scalar lump_23(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2 - Scalar(2.0) * omega3);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2 - Scalar(2.0) * omega3);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega3);
  const Scalar per_3 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_4 = Scalar(1.0) / (omega1 - omega2 - omega3);
  const Scalar f_0 = a123 * a333 * per_0 * per_1 / (Scalar(3.0) * omega3_2);
  const Scalar f_1 = -Scalar(2.0) * a113 * a123 * per_0 * per_1 * per_2 / omega3;
  const Scalar f_2 = Scalar(2.0) * a123 * a223 * per_3 * per_0 * per_4 * per_1;
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2) * per_1;
  const Scalar q_2 = f_1 * per_2;
  const Scalar q_3 = f_2 * per_3;
  const Scalar q_4 = f_2 * per_4;
  gradient[0] = -q_0 - q_1 - Scalar(2.0) * q_2 - q_3 - q_4;  // by omega1
  gradient[1] = -q_0 + q_1 - q_3 + q_4;  // by omega2
  // by omega3
  gradient[2] = (-Scalar(2.0) * f_0 - f_1) / omega3 + Scalar(2.0) * q_0 + Scalar(2.0) * q_1 + q_2 + q_3 + q_4;
  const Scalar c_0 = -Scalar(2.0) * per_0 * per_1 * per_2 / omega3;  // multiplies a113*a123
  const Scalar c_1 = Scalar(2.0) * per_3 * per_0 * per_4 * per_1;  // multiplies a123*a223
  const Scalar c_2 = per_0 * per_1 / (Scalar(3.0) * omega3_2);  // multiplies a123*a333
  gradient[3] = a123 * c_0;  // by a113
  gradient[4] = a113 * c_0 + a223 * c_1 + a333 * c_2;  // by a123
  gradient[5] = a123 * c_1;  // by a223
  gradient[6] = a123 * c_2;  // by a333
  return value;
}

/// harmonic_re_v2_A_v32_conjA_v2 = (-3*omega3^2*b2233 - 2*a223*a333)/(12*omega3^3*(omega2 - omega3)) +
/// a223^2/(omega3^2*(omega2 - omega3)*(2*omega2 - omega3)) + a123^2/(4*omega3*(omega1 + omega2 - omega3)*(omega1
/// - omega2 + omega3)*(omega2 - omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 42 operations.
template <class Scalar>
Scalar lump_24(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar b2233 = parameters[11];
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar a123_2 = a123 * a123;
  const Scalar a223_2 = a223 * a223;
  const Scalar per_0 = Scalar(1.0) / (omega2 - omega3);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega2 - omega3);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_3 = Scalar(1.0) / (omega1 - omega2 + omega3);
  const Scalar f_0 = -b2233 * per_0 / (Scalar(4.0) * omega3);
  const Scalar f_1 = -a223 * a333 * per_0 / (Scalar(6.0) * omega3_3);
  const Scalar f_2 = a223_2 * per_0 * per_1 / omega3_2;
  const Scalar f_3 = a123_2 * per_2 * per_3 * per_0 / (Scalar(4.0) * omega3);
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = f_2 * per_1;
  const Scalar q_2 = f_3 * per_2;
  const Scalar q_3 = f_3 * per_3;
  gradient[0] = -q_2 - q_3;  // by omega1
  gradient[1] = -q_0 - Scalar(2.0) * q_1 - q_2 + q_3;  // by omega2
  gradient[2] = (-f_0 - Scalar(3.0) * f_1 - Scalar(2.0) * f_2 - f_3) / omega3 + q_0 + q_1 + q_2 - q_3;  // by omega3
  const Scalar c_0 = per_2 * per_3 * per_0 / (Scalar(4.0) * omega3);  // multiplies a123^2
  const Scalar c_1 = per_0 * per_1 / omega3_2;  // multiplies a223^2
  const Scalar c_2 = -per_0 / (Scalar(6.0) * omega3_3);  // multiplies a223*a333
  const Scalar c_3 = -per_0 / (Scalar(4.0) * omega3);  // multiplies b2233
  gradient[4] = Scalar(2.0) * a123 * c_0;  // by a123
  gradient[5] = Scalar(2.0) * a223 * c_1 + a333 * c_2;  // by a223
  gradient[6] = a223 * c_2;  // by a333
  gradient[11] = c_3;  // by b2233
  return value;
}

/// harmonic_re_v2_A_v2_A_v32 = (3*omega3^2*b2233 + 2*a223*a333)/(12*omega3^3*(omega2 + omega3)) +
/// a223^2/(omega3^2*(omega2 + omega3)*(2*omega2 + omega3)) - a123^2/(4*omega3*(omega1 + omega2 + omega3)*(omega1
/// - omega2 - omega3)*(omega2 + omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 42 operations.
template <class Scalar>
Scalar lump_25(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar b2233 = parameters[11];
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar a123_2 = a123 * a123;
  const Scalar a223_2 = a223 * a223;
  const Scalar per_0 = Scalar(1.0) / (omega2 + omega3);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega2 + omega3);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_3 = Scalar(1.0) / (omega1 - omega2 - omega3);
  const Scalar f_0 = b2233 * per_0 / (Scalar(4.0) * omega3);
  const Scalar f_1 = a223 * a333 * per_0 / (Scalar(6.0) * omega3_3);
  const Scalar f_2 = a223_2 * per_0 * per_1 / omega3_2;
  const Scalar f_3 = -a123_2 * per_2 * per_3 * per_0 / (Scalar(4.0) * omega3);
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = f_2 * per_1;
  const Scalar q_2 = f_3 * per_2;
  const Scalar q_3 = f_3 * per_3;
  gradient[0] = -q_2 - q_3;  // by omega1
  gradient[1] = -q_0 - Scalar(2.0) * q_1 - q_2 + q_3;  // by omega2
  gradient[2] = (-f_0 - Scalar(3.0) * f_1 - Scalar(2.0) * f_2 - f_3) / omega3 - q_0 - q_1 - q_2 + q_3;  // by omega3
  const Scalar c_0 = -per_2 * per_3 * per_0 / (Scalar(4.0) * omega3);  // multiplies a123^2
  const Scalar c_1 = per_0 * per_1 / omega3_2;  // multiplies a223^2
  const Scalar c_2 = per_0 / (Scalar(6.0) * omega3_3);  // multiplies a223*a333
  const Scalar c_3 = per_0 / (Scalar(4.0) * omega3);  // multiplies b2233
  gradient[4] = Scalar(2.0) * a123 * c_0;  // by a123
  gradient[5] = Scalar(2.0) * a223 * c_1 + a333 * c_2;  // by a223
  gradient[6] = a223 * c_2;  // by a333
  gradient[11] = c_3;  // by b2233
  return value;
}

/// harmonic_re_v2_A_v1_A_v3_conjA_v3 = -2*a123*a333/(omega3^2*(omega1 + omega2)*(omega1 - omega2)) -
/// 4*a113*a123/((omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega3)*(2*omega1 - omega3)) +
/// (4*omega1^2*a123*a223 - 4*omega2^2*a123*a223 + 4*omega3^2*a123*a223)/((omega1 + omega2)*(omega1 + omega2 +
/// omega3)*(omega1 + omega2 - omega3)*(omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 78 operations.
template <class Scalar>
Scalar lump_26(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega3);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega3);
  const Scalar per_4 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_5 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_6 = Scalar(1.0) / (omega1 - omega2 + omega3);
  const Scalar per_7 = Scalar(1.0) / (omega1 - omega2 - omega3);
  const Scalar f_0 = -Scalar(2.0) * a123 * a333 * per_0 * per_1 / omega3_2;
  const Scalar f_1 = -Scalar(4.0) * a113 * a123 * per_0 * per_1 * per_2 * per_3;
  const Scalar f_2 = Scalar(4.0) * omega1_2 * a123 * a223 * per_0 * per_4 * per_5 * per_1 * per_6 * per_7;
  const Scalar f_3 = -Scalar(4.0) * omega2_2 * a123 * a223 * per_0 * per_4 * per_5 * per_1 * per_6 * per_7;
  const Scalar f_4 = Scalar(4.0) * omega3_2 * a123 * a223 * per_0 * per_4 * per_5 * per_1 * per_6 * per_7;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_1;
  const Scalar q_2 = f_1 * per_2;
  const Scalar q_3 = f_1 * per_3;
  const Scalar q_4 = (f_2 + f_3 + f_4) * per_4;
  const Scalar q_5 = (f_2 + f_3 + f_4) * per_5;
  const Scalar q_6 = (f_2 + f_3 + f_4) * per_6;
  const Scalar q_7 = (f_2 + f_3 + f_4) * per_7;
  // by omega1
  gradient[0] = Scalar(2.0) * f_2 / omega1 - q_0 - q_1 - Scalar(2.0) * q_2 - Scalar(2.0) * q_3 - q_4 - q_5 - q_6
      - q_7;
  gradient[1] = Scalar(2.0) * f_3 / omega2 - q_0 + q_1 - q_4 - q_5 + q_6 + q_7;  // by omega2
  gradient[2] = (-Scalar(2.0) * f_0 + Scalar(2.0) * f_4) / omega3 - q_2 + q_3 - q_4 + q_5 - q_6 + q_7;  // by omega3
  const Scalar c_0 = -Scalar(4.0) * per_0 * per_1 * per_2 * per_3;  // multiplies a113*a123
  // multiplies a123*a223
  const Scalar c_1 = (Scalar(4.0) * omega1_2 - Scalar(4.0) * omega2_2
      + Scalar(4.0) * omega3_2) * per_0 * per_4 * per_5 * per_1 * per_6 * per_7;
  const Scalar c_2 = -Scalar(2.0) * per_0 * per_1 / omega3_2;  // multiplies a123*a333
  gradient[3] = a123 * c_0;  // by a113
  gradient[4] = a113 * c_0 + a223 * c_1 + a333 * c_2;  // by a123
  gradient[5] = a123 * c_1;  // by a223
  gradient[6] = a123 * c_2;  // by a333
  return value;
}

/// harmonic_re_v2_A_v1_A_v32 = a123*a333/(3*omega3^2*(omega1 + omega2 + 2*omega3)*(omega1 - omega2 + 2*omega3))
/// + 2*a113*a123/(omega3*(omega1 + omega2 + 2*omega3)*(omega1 - omega2 + 2*omega3)*(2*omega1 + omega3)) +
/// 2*a123*a223/((omega1 + omega2 + omega3)*(omega1 + omega2 + 2*omega3)*(omega1 - omega2 + omega3)*(omega1 -
/// omega2 + 2*omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 46 operations.
template <class Scalar>
Scalar lump_27(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2 + Scalar(2.0) * omega3);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2 + Scalar(2.0) * omega3);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega3);
  const Scalar per_3 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_4 = Scalar(1.0) / (omega1 - omega2 + omega3);
  const Scalar f_0 = a123 * a333 * per_0 * per_1 / (Scalar(3.0) * omega3_2);
  const Scalar f_1 = Scalar(2.0) * a113 * a123 * per_0 * per_1 * per_2 / omega3;
  const Scalar f_2 = Scalar(2.0) * a123 * a223 * per_3 * per_0 * per_4 * per_1;
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2) * per_1;
  const Scalar q_2 = f_1 * per_2;
  const Scalar q_3 = f_2 * per_3;
  const Scalar q_4 = f_2 * per_4;
  gradient[0] = -q_0 - q_1 - Scalar(2.0) * q_2 - q_3 - q_4;  // by omega1
  gradient[1] = -q_0 + q_1 - q_3 + q_4;  // by omega2
  // by omega3
  gradient[2] = (-Scalar(2.0) * f_0 - f_1) / omega3 - Scalar(2.0) * q_0 - Scalar(2.0) * q_1 - q_2 - q_3 - q_4;
  const Scalar c_0 = Scalar(2.0) * per_0 * per_1 * per_2 / omega3;  // multiplies a113*a123
  const Scalar c_1 = Scalar(2.0) * per_3 * per_0 * per_4 * per_1;  // multiplies a123*a223
  const Scalar c_2 = per_0 * per_1 / (Scalar(3.0) * omega3_2);  // multiplies a123*a333
  gradient[3] = a123 * c_0;  // by a113
  gradient[4] = a113 * c_0 + a223 * c_1 + a333 * c_2;  // by a123
  gradient[5] = a123 * c_1;  // by a223
  gradient[6] = a123 * c_2;  // by a333
  return value;
}

/// harmonic_re_v3_A_v3_conjA_v12 = b1133/(4*omega1*(omega1 - omega3)) - a113^2/(omega1*omega3*(omega1 -
/// omega3)*(2*omega1 - omega3)) + a123^2/(4*omega1*(omega1 + omega2 - omega3)*(omega1 - omega2 - omega3)*(omega1
/// - omega3)) + a113*a333/(2*omega1*(omega1 - omega3)*(2*omega1 + omega3)*(2*omega1 - omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 51 operations.
template <class Scalar>
Scalar lump_28(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a333 = parameters[6];
  const Scalar b1133 = parameters[10];
  const Scalar a113_2 = a113 * a113;
  const Scalar a123_2 = a123 * a123;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega3);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega3);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_3 = Scalar(1.0) / (omega1 - omega2 - omega3);
  const Scalar per_4 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega3);
  const Scalar f_0 = b1133 * per_0 / (Scalar(4.0) * omega1);
  const Scalar f_1 = -a113_2 * per_0 * per_1 / (omega1 * omega3);
  const Scalar f_2 = a123_2 * per_2 * per_3 * per_0 / (Scalar(4.0) * omega1);
  const Scalar f_3 = a113 * a333 * per_0 * per_4 * per_1 / (Scalar(2.0) * omega1);
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = (f_1 + f_3) * per_1;
  const Scalar q_2 = f_2 * per_2;
  const Scalar q_3 = f_2 * per_3;
  const Scalar q_4 = f_3 * per_4;
  // by omega1
  gradient[0] = (-f_0 - f_1 - f_2 - f_3) / omega1 - q_0 - Scalar(2.0) * q_1 - q_2 - q_3 - Scalar(2.0) * q_4;
  gradient[1] = -q_2 + q_3;  // by omega2
  gradient[2] = -f_1 / omega3 + q_0 + q_1 + q_2 + q_3 - q_4;  // by omega3
  const Scalar c_0 = -per_0 * per_1 / (omega1 * omega3);  // multiplies a113^2
  const Scalar c_1 = per_0 * per_4 * per_1 / (Scalar(2.0) * omega1);  // multiplies a113*a333
  const Scalar c_2 = per_2 * per_3 * per_0 / (Scalar(4.0) * omega1);  // multiplies a123^2
  const Scalar c_3 = per_0 / (Scalar(4.0) * omega1);  // multiplies b1133
  gradient[3] = Scalar(2.0) * a113 * c_0 + a333 * c_1;  // by a113
  gradient[4] = Scalar(2.0) * a123 * c_2;  // by a123
  gradient[6] = a113 * c_1;  // by a333
  gradient[10] = c_3;  // by b1133
  return value;
}

/// harmonic_re_v3_A_v3_conjA_v1_conjA_v2 = -2*a113*a123/(omega3*(omega1 + omega2)*(omega1 + omega2 -
/// 2*omega3)*(2*omega1 - omega3)) - 2*a123*a223/(omega3*(omega1 + omega2)*(omega1 + omega2 - 2*omega3)*(2*omega2
/// - omega3)) + 2*a123*a333/((omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 - omega3)*(omega1 +
/// omega2 - 2*omega3)) - 2*a113*a123/((omega1 + omega2)*(omega1 + omega2 - omega3)*(omega1 + omega2 -
/// 2*omega3)*(omega1 - omega2 + omega3)) + 2*a123*a223/((omega1 + omega2)*(omega1 + omega2 - omega3)*(omega1 +
/// omega2 - 2*omega3)*(omega1 - omega2 - omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 76 operations.
template <class Scalar>
Scalar lump_29(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2 - Scalar(2.0) * omega3);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega3);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega2 - omega3);
  const Scalar per_4 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_5 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_6 = Scalar(1.0) / (omega1 - omega2 + omega3);
  const Scalar per_7 = Scalar(1.0) / (omega1 - omega2 - omega3);
  const Scalar f_0 = -Scalar(2.0) * a113 * a123 * per_0 * per_1 * per_2 / omega3;
  const Scalar f_1 = -Scalar(2.0) * a123 * a223 * per_0 * per_1 * per_3 / omega3;
  const Scalar f_2 = Scalar(2.0) * a123 * a333 * per_0 * per_4 * per_5 * per_1;
  const Scalar f_3 = -Scalar(2.0) * a113 * a123 * per_0 * per_5 * per_1 * per_6;
  const Scalar f_4 = Scalar(2.0) * a123 * a223 * per_0 * per_5 * per_1 * per_7;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_1;
  const Scalar q_2 = f_0 * per_2;
  const Scalar q_3 = f_1 * per_3;
  const Scalar q_4 = f_2 * per_4;
  const Scalar q_5 = (f_2 + f_3 + f_4) * per_5;
  const Scalar q_6 = f_3 * per_6;
  const Scalar q_7 = f_4 * per_7;
  gradient[0] = -q_0 - q_1 - Scalar(2.0) * q_2 - q_4 - q_5 - q_6 - q_7;  // by omega1
  gradient[1] = -q_0 - q_1 - Scalar(2.0) * q_3 - q_4 - q_5 + q_6 + q_7;  // by omega2
  gradient[2] = (-f_0 - f_1) / omega3 + Scalar(2.0) * q_1 + q_2 + q_3 - q_4 + q_5 - q_6 + q_7;  // by omega3
  // multiplies a113*a123
  const Scalar c_0 = -Scalar(2.0) * per_0 * per_1 * per_2 / omega3 - Scalar(2.0) * per_0 * per_5 * per_1 * per_6;
  // multiplies a123*a223
  const Scalar c_1 = -Scalar(2.0) * per_0 * per_1 * per_3 / omega3 + Scalar(2.0) * per_0 * per_5 * per_1 * per_7;
  const Scalar c_2 = Scalar(2.0) * per_0 * per_4 * per_5 * per_1;  // multiplies a123*a333
  gradient[3] = a123 * c_0;  // by a113
  gradient[4] = a113 * c_0 + a223 * c_1 + a333 * c_2;  // by a123
  gradient[5] = a123 * c_1;  // by a223
  gradient[6] = a123 * c_2;  // by a333
  return value;
}

/// harmonic_re_v3_A_v2_A_v3_conjA_v1 = -2*a113*a123/(omega3*(omega1 - omega2)*(omega1 - omega2 -
/// 2*omega3)*(2*omega1 - omega3)) + 2*a123*a223/(omega3*(omega1 - omega2)*(omega1 - omega2 - 2*omega3)*(2*omega2
/// + omega3)) - 2*a113*a123/((omega1 + omega2 + omega3)*(omega1 - omega2)*(omega1 - omega2 - omega3)*(omega1 -
/// omega2 - 2*omega3)) + 2*a123*a223/((omega1 + omega2 - omega3)*(omega1 - omega2)*(omega1 - omega2 -
/// omega3)*(omega1 - omega2 - 2*omega3)) + 2*a123*a333/((omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 -
/// omega2 - omega3)*(omega1 - omega2 - 2*omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 76 operations.
template <class Scalar>
Scalar lump_30(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2 - Scalar(2.0) * omega3);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega3);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega2 + omega3);
  const Scalar per_4 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_5 = Scalar(1.0) / (omega1 - omega2 - omega3);
  const Scalar per_6 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_7 = Scalar(1.0) / (omega1 - omega2 + omega3);
  const Scalar f_0 = -Scalar(2.0) * a113 * a123 * per_0 * per_1 * per_2 / omega3;
  const Scalar f_1 = Scalar(2.0) * a123 * a223 * per_0 * per_1 * per_3 / omega3;
  const Scalar f_2 = -Scalar(2.0) * a113 * a123 * per_4 * per_0 * per_5 * per_1;
  const Scalar f_3 = Scalar(2.0) * a123 * a223 * per_6 * per_0 * per_5 * per_1;
  const Scalar f_4 = Scalar(2.0) * a123 * a333 * per_0 * per_7 * per_5 * per_1;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_1;
  const Scalar q_2 = f_0 * per_2;
  const Scalar q_3 = f_1 * per_3;
  const Scalar q_4 = f_2 * per_4;
  const Scalar q_5 = (f_2 + f_3 + f_4) * per_5;
  const Scalar q_6 = f_3 * per_6;
  const Scalar q_7 = f_4 * per_7;
  gradient[0] = -q_0 - q_1 - Scalar(2.0) * q_2 - q_4 - q_5 - q_6 - q_7;  // by omega1
  gradient[1] = q_0 + q_1 - Scalar(2.0) * q_3 - q_4 + q_5 - q_6 + q_7;  // by omega2
  gradient[2] = (-f_0 - f_1) / omega3 + Scalar(2.0) * q_1 + q_2 - q_3 - q_4 + q_5 + q_6 - q_7;  // by omega3
  // multiplies a113*a123
  const Scalar c_0 = -Scalar(2.0) * per_0 * per_1 * per_2 / omega3 - Scalar(2.0) * per_4 * per_0 * per_5 * per_1;
  // multiplies a123*a223
  const Scalar c_1 = Scalar(2.0) * per_0 * per_1 * per_3 / omega3 + Scalar(2.0) * per_6 * per_0 * per_5 * per_1;
  const Scalar c_2 = Scalar(2.0) * per_0 * per_7 * per_5 * per_1;  // multiplies a123*a333
  gradient[3] = a123 * c_0;  // by a113
  gradient[4] = a113 * c_0 + a223 * c_1 + a333 * c_2;  // by a123
  gradient[5] = a123 * c_1;  // by a223
  gradient[6] = a123 * c_2;  // by a333
  return value;
}

/// harmonic_re_v3_A_v22_conjA_v3 = b2233/(4*omega2*(omega2 - omega3)) - a223^2/(omega2*omega3*(omega2 -
/// omega3)*(2*omega2 - omega3)) - a123^2/(4*omega2*(omega1 + omega2 - omega3)*(omega1 - omega2 + omega3)*(omega2
/// - omega3)) + a223*a333/(2*omega2*(omega2 - omega3)*(2*omega2 + omega3)*(2*omega2 - omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 51 operations.
template <class Scalar>
Scalar lump_31(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar b2233 = parameters[11];
  const Scalar a123_2 = a123 * a123;
  const Scalar a223_2 = a223 * a223;
  const Scalar per_0 = Scalar(1.0) / (omega2 - omega3);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega2 - omega3);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_3 = Scalar(1.0) / (omega1 - omega2 + omega3);
  const Scalar per_4 = Scalar(1.0) / (Scalar(2.0) * omega2 + omega3);
  const Scalar f_0 = b2233 * per_0 / (Scalar(4.0) * omega2);
  const Scalar f_1 = -a223_2 * per_0 * per_1 / (omega2 * omega3);
  const Scalar f_2 = -a123_2 * per_2 * per_3 * per_0 / (Scalar(4.0) * omega2);
  const Scalar f_3 = a223 * a333 * per_0 * per_4 * per_1 / (Scalar(2.0) * omega2);
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = (f_1 + f_3) * per_1;
  const Scalar q_2 = f_2 * per_2;
  const Scalar q_3 = f_2 * per_3;
  const Scalar q_4 = f_3 * per_4;
  gradient[0] = -q_2 - q_3;  // by omega1
  // by omega2
  gradient[1] = (-f_0 - f_1 - f_2 - f_3) / omega2 - q_0 - Scalar(2.0) * q_1 - q_2 + q_3 - Scalar(2.0) * q_4;
  gradient[2] = -f_1 / omega3 + q_0 + q_1 + q_2 - q_3 - q_4;  // by omega3
  const Scalar c_0 = -per_2 * per_3 * per_0 / (Scalar(4.0) * omega2);  // multiplies a123^2
  const Scalar c_1 = -per_0 * per_1 / (omega2 * omega3);  // multiplies a223^2
  const Scalar c_2 = per_0 * per_4 * per_1 / (Scalar(2.0) * omega2);  // multiplies a223*a333
  const Scalar c_3 = per_0 / (Scalar(4.0) * omega2);  // multiplies b2233
  gradient[4] = Scalar(2.0) * a123 * c_0;  // by a123
  gradient[5] = Scalar(2.0) * a223 * c_1 + a333 * c_2;  // by a223
  gradient[6] = a223 * c_2;  // by a333
  gradient[11] = c_3;  // by b2233
  return value;
}

/// harmonic_re_v3_A_v22_A_v3 = b2233/(4*omega2*(omega2 + omega3)) + a223^2/(omega2*omega3*(omega2 +
/// omega3)*(2*omega2 + omega3)) - a123^2/(4*omega2*(omega1 + omega2 + omega3)*(omega1 - omega2 - omega3)*(omega2
/// + omega3)) + a223*a333/(2*omega2*(omega2 + omega3)*(2*omega2 + omega3)*(2*omega2 - omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 51 operations.
template <class Scalar>
Scalar lump_32(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar b2233 = parameters[11];
  const Scalar a123_2 = a123 * a123;
  const Scalar a223_2 = a223 * a223;
  const Scalar per_0 = Scalar(1.0) / (omega2 + omega3);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega2 + omega3);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_3 = Scalar(1.0) / (omega1 - omega2 - omega3);
  const Scalar per_4 = Scalar(1.0) / (Scalar(2.0) * omega2 - omega3);
  const Scalar f_0 = b2233 * per_0 / (Scalar(4.0) * omega2);
  const Scalar f_1 = a223_2 * per_0 * per_1 / (omega2 * omega3);
  const Scalar f_2 = -a123_2 * per_2 * per_3 * per_0 / (Scalar(4.0) * omega2);
  const Scalar f_3 = a223 * a333 * per_0 * per_1 * per_4 / (Scalar(2.0) * omega2);
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = (f_1 + f_3) * per_1;
  const Scalar q_2 = f_2 * per_2;
  const Scalar q_3 = f_2 * per_3;
  const Scalar q_4 = f_3 * per_4;
  gradient[0] = -q_2 - q_3;  // by omega1
  // by omega2
  gradient[1] = (-f_0 - f_1 - f_2 - f_3) / omega2 - q_0 - Scalar(2.0) * q_1 - q_2 + q_3 - Scalar(2.0) * q_4;
  gradient[2] = -f_1 / omega3 - q_0 - q_1 - q_2 + q_3 + q_4;  // by omega3
  const Scalar c_0 = -per_2 * per_3 * per_0 / (Scalar(4.0) * omega2);  // multiplies a123^2
  const Scalar c_1 = per_0 * per_1 / (omega2 * omega3);  // multiplies a223^2
  const Scalar c_2 = per_0 * per_1 * per_4 / (Scalar(2.0) * omega2);  // multiplies a223*a333
  const Scalar c_3 = per_0 / (Scalar(4.0) * omega2);  // multiplies b2233
  gradient[4] = Scalar(2.0) * a123 * c_0;  // by a123
  gradient[5] = Scalar(2.0) * a223 * c_1 + a333 * c_2;  // by a223
  gradient[6] = a223 * c_2;  // by a333
  gradient[11] = c_3;  // by b2233
  return value;
}

/// harmonic_re_v3_A_v1_A_v3_conjA_v2 = 2*a113*a123/(omega3*(omega1 - omega2)*(omega1 - omega2 +
/// 2*omega3)*(2*omega1 + omega3)) - 2*a123*a223/(omega3*(omega1 - omega2)*(omega1 - omega2 + 2*omega3)*(2*omega2
/// - omega3)) + 2*a123*a223/((omega1 + omega2 + omega3)*(omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 -
/// omega2 + 2*omega3)) - 2*a113*a123/((omega1 + omega2 - omega3)*(omega1 - omega2)*(omega1 - omega2 +
/// omega3)*(omega1 - omega2 + 2*omega3)) + 2*a123*a333/((omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 -
/// omega2 + 2*omega3)*(omega1 - omega2 - omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 76 operations.
template <class Scalar>
Scalar lump_33(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2 + Scalar(2.0) * omega3);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega3);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega2 - omega3);
  const Scalar per_4 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_5 = Scalar(1.0) / (omega1 - omega2 + omega3);
  const Scalar per_6 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_7 = Scalar(1.0) / (omega1 - omega2 - omega3);
  const Scalar f_0 = Scalar(2.0) * a113 * a123 * per_0 * per_1 * per_2 / omega3;
  const Scalar f_1 = -Scalar(2.0) * a123 * a223 * per_0 * per_1 * per_3 / omega3;
  const Scalar f_2 = Scalar(2.0) * a123 * a223 * per_4 * per_0 * per_5 * per_1;
  const Scalar f_3 = -Scalar(2.0) * a113 * a123 * per_6 * per_0 * per_5 * per_1;
  const Scalar f_4 = Scalar(2.0) * a123 * a333 * per_0 * per_5 * per_1 * per_7;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_1;
  const Scalar q_2 = f_0 * per_2;
  const Scalar q_3 = f_1 * per_3;
  const Scalar q_4 = f_2 * per_4;
  const Scalar q_5 = (f_2 + f_3 + f_4) * per_5;
  const Scalar q_6 = f_3 * per_6;
  const Scalar q_7 = f_4 * per_7;
  gradient[0] = -q_0 - q_1 - Scalar(2.0) * q_2 - q_4 - q_5 - q_6 - q_7;  // by omega1
  gradient[1] = q_0 + q_1 - Scalar(2.0) * q_3 - q_4 + q_5 - q_6 + q_7;  // by omega2
  gradient[2] = (-f_0 - f_1) / omega3 - Scalar(2.0) * q_1 - q_2 + q_3 - q_4 - q_5 + q_6 + q_7;  // by omega3
  // multiplies a113*a123
  const Scalar c_0 = Scalar(2.0) * per_0 * per_1 * per_2 / omega3 - Scalar(2.0) * per_6 * per_0 * per_5 * per_1;
  // multiplies a123*a223
  const Scalar c_1 = -Scalar(2.0) * per_0 * per_1 * per_3 / omega3 + Scalar(2.0) * per_4 * per_0 * per_5 * per_1;
  const Scalar c_2 = Scalar(2.0) * per_0 * per_5 * per_1 * per_7;  // multiplies a123*a333
  gradient[3] = a123 * c_0;  // by a113
  gradient[4] = a113 * c_0 + a223 * c_1 + a333 * c_2;  // by a123
  gradient[5] = a123 * c_1;  // by a223
  gradient[6] = a123 * c_2;  // by a333
  return value;
}

/// harmonic_re_v3_A_v1_A_v2_A_v3 = 2*a113*a123/(omega3*(omega1 + omega2)*(omega1 + omega2 + 2*omega3)*(2*omega1
/// + omega3)) + 2*a123*a223/(omega3*(omega1 + omega2)*(omega1 + omega2 + 2*omega3)*(2*omega2 + omega3)) +
/// 2*a123*a333/((omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 + 2*omega3)*(omega1 + omega2 -
/// omega3)) + 2*a123*a223/((omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 + 2*omega3)*(omega1 -
/// omega2 + omega3)) - 2*a113*a123/((omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 +
/// 2*omega3)*(omega1 - omega2 - omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 76 operations.
template <class Scalar>
Scalar lump_34(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2 + Scalar(2.0) * omega3);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega3);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega2 + omega3);
  const Scalar per_4 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_5 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_6 = Scalar(1.0) / (omega1 - omega2 + omega3);
  const Scalar per_7 = Scalar(1.0) / (omega1 - omega2 - omega3);
  const Scalar f_0 = Scalar(2.0) * a113 * a123 * per_0 * per_1 * per_2 / omega3;
  const Scalar f_1 = Scalar(2.0) * a123 * a223 * per_0 * per_1 * per_3 / omega3;
  const Scalar f_2 = Scalar(2.0) * a123 * a333 * per_0 * per_4 * per_1 * per_5;
  const Scalar f_3 = Scalar(2.0) * a123 * a223 * per_0 * per_4 * per_1 * per_6;
  const Scalar f_4 = -Scalar(2.0) * a113 * a123 * per_0 * per_4 * per_1 * per_7;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_1;
  const Scalar q_2 = f_0 * per_2;
  const Scalar q_3 = f_1 * per_3;
  const Scalar q_4 = (f_2 + f_3 + f_4) * per_4;
  const Scalar q_5 = f_2 * per_5;
  const Scalar q_6 = f_3 * per_6;
  const Scalar q_7 = f_4 * per_7;
  gradient[0] = -q_0 - q_1 - Scalar(2.0) * q_2 - q_4 - q_5 - q_6 - q_7;  // by omega1
  gradient[1] = -q_0 - q_1 - Scalar(2.0) * q_3 - q_4 - q_5 + q_6 + q_7;  // by omega2
  gradient[2] = (-f_0 - f_1) / omega3 - Scalar(2.0) * q_1 - q_2 - q_3 - q_4 + q_5 - q_6 + q_7;  // by omega3
  // multiplies a113*a123
  const Scalar c_0 = Scalar(2.0) * per_0 * per_1 * per_2 / omega3 - Scalar(2.0) * per_0 * per_4 * per_1 * per_7;
  // multiplies a123*a223
  const Scalar c_1 = Scalar(2.0) * per_0 * per_1 * per_3 / omega3 + Scalar(2.0) * per_0 * per_4 * per_1 * per_6;
  const Scalar c_2 = Scalar(2.0) * per_0 * per_4 * per_1 * per_5;  // multiplies a123*a333
  gradient[3] = a123 * c_0;  // by a113
  gradient[4] = a113 * c_0 + a223 * c_1 + a333 * c_2;  // by a123
  gradient[5] = a123 * c_1;  // by a223
  gradient[6] = a123 * c_2;  // by a333
  return value;
}

/// harmonic_re_v3_A_v12_A_v3 = b1133/(4*omega1*(omega1 + omega3)) + a113^2/(omega1*omega3*(omega1 +
/// omega3)*(2*omega1 + omega3)) + a123^2/(4*omega1*(omega1 + omega2 + omega3)*(omega1 - omega2 + omega3)*(omega1
/// + omega3)) + a113*a333/(2*omega1*(omega1 + omega3)*(2*omega1 + omega3)*(2*omega1 - omega3))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 51 operations.
template <class Scalar>
Scalar lump_35(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a333 = parameters[6];
  const Scalar b1133 = parameters[10];
  const Scalar a113_2 = a113 * a113;
  const Scalar a123_2 = a123 * a123;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega3);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega3);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_3 = Scalar(1.0) / (omega1 - omega2 + omega3);
  const Scalar per_4 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega3);
  const Scalar f_0 = b1133 * per_0 / (Scalar(4.0) * omega1);
  const Scalar f_1 = a113_2 * per_0 * per_1 / (omega1 * omega3);
  const Scalar f_2 = a123_2 * per_2 * per_3 * per_0 / (Scalar(4.0) * omega1);
  const Scalar f_3 = a113 * a333 * per_0 * per_1 * per_4 / (Scalar(2.0) * omega1);
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = (f_1 + f_3) * per_1;
  const Scalar q_2 = f_2 * per_2;
  const Scalar q_3 = f_2 * per_3;
  const Scalar q_4 = f_3 * per_4;
  // by omega1
  gradient[0] = (-f_0 - f_1 - f_2 - f_3) / omega1 - q_0 - Scalar(2.0) * q_1 - q_2 - q_3 - Scalar(2.0) * q_4;
  gradient[1] = -q_2 + q_3;  // by omega2
  gradient[2] = -f_1 / omega3 - q_0 - q_1 - q_2 - q_3 + q_4;  // by omega3
  const Scalar c_0 = per_0 * per_1 / (omega1 * omega3);  // multiplies a113^2
  const Scalar c_1 = per_0 * per_1 * per_4 / (Scalar(2.0) * omega1);  // multiplies a113*a333
  const Scalar c_2 = per_2 * per_3 * per_0 / (Scalar(4.0) * omega1);  // multiplies a123^2
  const Scalar c_3 = per_0 / (Scalar(4.0) * omega1);  // multiplies b1133
  gradient[3] = Scalar(2.0) * a113 * c_0 + a333 * c_1;  // by a113
  gradient[4] = Scalar(2.0) * a123 * c_2;  // by a123
  gradient[6] = a113 * c_1;  // by a333
  gradient[10] = c_3;  // by b1133
  return value;
}

namespace additive_combination {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: mu1 = mu1
/// lumps[4]: mu2 = mu2
/// lumps[6]: e1 = e1
/// lumps[13]: e2 = e2
/// lumps[18]: a123 = a123
/// lumps[19]: a223 = a223
/// lumps[20]: a113 = a113
/// lumps[21]: e3 = e3
/// 0 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar mu1 = parameters[13];
  const Scalar e1 = parameters[14];
  const Scalar mu2 = parameters[15];
  const Scalar e2 = parameters[16];
  const Scalar e3 = parameters[18];
  lumps[0] = mu1;  // mu1
  lumps[1] = lump_0(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v1_A_v2_conjA_v2
  lumps[2] = lump_1(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v12_conjA_v1
  lumps[3] = lump_2(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_conjA_v2_F
  lumps[4] = mu2;  // mu2
  lumps[5] = lump_3(parameters, static_cast<Scalar*>(nullptr));  // conservative_v2_A_v22_conjA_v2
  lumps[6] = e1;  // e1
  lumps[7] = lump_4(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v2_conjA_v12
  lumps[8] = lump_5(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_conjA_v1_F
  lumps[9] = lump_6(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v22_conjA_v2
  lumps[10] = lump_7(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v22_conjA_v1
  lumps[11] = lump_8(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_A_v22
  lumps[12] = lump_9(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v13
  lumps[13] = e2;  // e2
  lumps[14] = lump_10(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v2_conjA_v12
  lumps[15] = lump_11(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_conjA_v2_F
  lumps[16] = lump_12(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v23
  lumps[17] = lump_13(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v12_A_v2
  lumps[18] = a123;  // a123
  lumps[19] = a223;  // a223
  lumps[20] = a113;  // a113
  lumps[21] = e3;  // e3
  lumps[22] = lump_14(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v3_conjA_v1_F
  lumps[23] = lump_15(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v3_conjA_v2_F
}

/// jacobian[l * 19 + p] = d lumps[l] / d parameters[p]. 0 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  for (std::size_t i = 0; i < 456; ++i) jacobian[i] = Scalar(0.0);
  jacobian[13] = Scalar(1.0);  // d mu1 / d mu1
  lump_0(parameters, jacobian + 19);  // d conservative_v1_A_v1_A_v2_conjA_v2
  lump_1(parameters, jacobian + 38);  // d conservative_v1_A_v12_conjA_v1
  lump_2(parameters, jacobian + 57);  // d conservative_v1_conjA_v2_F
  jacobian[91] = Scalar(1.0);  // d mu2 / d mu2
  lump_3(parameters, jacobian + 95);  // d conservative_v2_A_v22_conjA_v2
  jacobian[128] = Scalar(1.0);  // d e1 / d e1
  lump_4(parameters, jacobian + 133);  // d harmonic_re_v1_A_v2_conjA_v12
  lump_5(parameters, jacobian + 152);  // d harmonic_re_v1_conjA_v1_F
  lump_6(parameters, jacobian + 171);  // d harmonic_re_v1_A_v22_conjA_v2
  lump_7(parameters, jacobian + 190);  // d harmonic_re_v1_A_v22_conjA_v1
  lump_8(parameters, jacobian + 209);  // d harmonic_re_v1_A_v1_A_v22
  lump_9(parameters, jacobian + 228);  // d harmonic_re_v1_A_v13
  jacobian[263] = Scalar(1.0);  // d e2 / d e2
  lump_10(parameters, jacobian + 266);  // d harmonic_re_v2_A_v2_conjA_v12
  lump_11(parameters, jacobian + 285);  // d harmonic_re_v2_conjA_v2_F
  lump_12(parameters, jacobian + 304);  // d harmonic_re_v2_A_v23
  lump_13(parameters, jacobian + 323);  // d harmonic_re_v2_A_v12_A_v2
  jacobian[346] = Scalar(1.0);  // d a123 / d a123
  jacobian[366] = Scalar(1.0);  // d a223 / d a223
  jacobian[383] = Scalar(1.0);  // d a113 / d a113
  jacobian[417] = Scalar(1.0);  // d e3 / d e3
  lump_14(parameters, jacobian + 418);  // d harmonic_re_v3_conjA_v1_F
  lump_15(parameters, jacobian + 437);  // d harmonic_re_v3_conjA_v2_F
}

/// What multiplies the 4 terms of the modulation of v1: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = -Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the modulation of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega1)*A_v1 = -mu1*A_v1 + i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) +
/// i*conservative_v1_A_v12_conjA_v1*A_v1^2*conj(A_v1) + i*conservative_v1_conjA_v2_F*conj(A_v2)*F
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
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex conj_A_v2 = conjugate(A_v2);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1));  // mu1
    store_complex(column_1, i, times_i(factor[1] * (A_v1 * norm_A_v2)));  // conservative_v1_A_v1_A_v2_conjA_v2
    store_complex(column_2, i, times_i(factor[2] * (norm_A_v1 * A_v1)));  // conservative_v1_A_v12_conjA_v1
    store_complex(column_3, i, times_i(factor[3] * (conj_A_v2 * F)));  // conservative_v1_conjA_v2_F
  }
}

/// columns[j][i] of the rows.
inline void columns_0(const BatchArrays& data, double* const* columns) {
  rows_0(data, FactorValues<factors_0<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_0(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 4 terms of the modulation of v2: functions of the frequencies alone. 2 operations.
template <class Scalar>
void factors_1([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  factor[0] = omega1 / omega2;
  factor[1] = omega1 / omega2;
  factor[2] = -Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the modulation of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega2)*A_v2 = omega1/omega2*i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*conj(A_v1)*A_v2 +
/// omega1/omega2*i*conservative_v1_conjA_v2_F*conj(A_v1)*F - mu2*A_v2 +
/// i*conservative_v2_A_v22_conjA_v2*A_v2^2*conj(A_v2)
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
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, times_i(factor[0] * (norm_A_v1 * A_v2)));  // conservative_v1_A_v1_A_v2_conjA_v2
    store_complex(column_1, i, times_i(factor[1] * (conj_A_v1 * F)));  // conservative_v1_conjA_v2_F
    store_complex(column_2, i, factor[2] * (A_v2));  // mu2
    store_complex(column_3, i, times_i(factor[3] * (norm_A_v2 * A_v2)));  // conservative_v2_A_v22_conjA_v2
  }
}

/// columns[j][i] of the rows.
inline void columns_1(const BatchArrays& data, double* const* columns) {
  rows_1(data, FactorValues<factors_1<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_1(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_1(data, FactorSlopes<factors_1<DualNumber>, 3, 1, 4>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic Omega of v1: functions of the frequencies alone. 6 operations.
template <class Scalar>
void factors_2([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar per_0 = Scalar(1.0) / (omega1 + Omega);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Omega);
  factor[0] = per_0 * per_1 / Scalar(2.0);
}

/// Rows of the harmonic Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(Omega)*t) in v1 = 1/(2*(omega1 + Omega)*(omega1 - Omega))*e1*F
/// 1 columns; per observation at most 1 products and sums of complex numbers.
template <class Factors>
void rows_2(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (F));  // e1
  }
}

/// columns[j][i] of the rows.
inline void columns_2(const BatchArrays& data, double* const* columns) {
  rows_2(data, FactorValues<factors_2<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_2(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_2(data, FactorSlopes<factors_2<DualNumber>, 3, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic -2*omega1+omega2 of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_3([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic -2*omega1+omega2 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-2*omega1 + omega2)*t) in v1 = harmonic_re_v1_A_v2_conjA_v12*conj(A_v1)^2*A_v2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_3(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * conj_A_v1 * A_v2));  // harmonic_re_v1_A_v2_conjA_v12
  }
}

/// columns[j][i] of the rows.
inline void columns_3(const BatchArrays& data, double* const* columns) {
  rows_3(data, FactorValues<factors_3<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_3(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 3 terms of the harmonic omega2 of v1: functions of the frequencies alone. 94 operations.
template <class Scalar>
void factors_4([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega1_6 = omega1_5 * omega1;
  const Scalar omega1_7 = omega1_6 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar omega3_5 = omega3_4 * omega3;
  const Scalar omega3_6 = omega3_5 * omega3;
  const Scalar per_0 = Scalar(1.0) / (Scalar(9.0) * omega1_2 - Scalar(2.0) * omega1 * omega2 + omega2_2
      - Scalar(3.0) * omega3_2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_3 = Scalar(1.0) / (omega1 + omega2 - omega3);
  factor[0] = (Scalar(24.0) * omega1_7 - Scalar(8.0) * omega1_6 * omega2 - Scalar(48.0) * omega1_5 * omega2_2
      - Scalar(102.0) * omega1_5 * omega3_2 + Scalar(16.0) * omega1_4 * omega2_3
      + Scalar(34.0) * omega1_4 * omega2 * omega3_2 + Scalar(24.0) * omega1_3 * omega2_4
      - Scalar(84.0) * omega1_3 * omega2_2 * omega3_2 + Scalar(96.0) * omega1_3 * omega3_4
      - Scalar(8.0) * omega1_2 * omega2_5 + Scalar(28.0) * omega1_2 * omega2_3 * omega3_2
      - Scalar(32.0) * omega1_2 * omega2 * omega3_4 - Scalar(6.0) * omega1 * omega2_4 * omega3_2
      + Scalar(24.0) * omega1 * omega2_2 * omega3_4 - Scalar(18.0) * omega1 * omega3_6
      + Scalar(2.0) * omega2_5 * omega3_2 - Scalar(8.0) * omega2_3 * omega3_4
      + Scalar(6.0) * omega2 * omega3_6) * per_0 * per_1 * per_2 * per_3 / omega3_2;
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega2 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2)*t) in v1 = (24*omega1^7 - 8*omega1^6*omega2 - 48*omega1^5*omega2^2 -
/// 102*omega1^5*omega3^2 + 16*omega1^4*omega2^3 + 34*omega1^4*omega2*omega3^2 + 24*omega1^3*omega2^4 -
/// 84*omega1^3*omega2^2*omega3^2 + 96*omega1^3*omega3^4 - 8*omega1^2*omega2^5 + 28*omega1^2*omega2^3*omega3^2 -
/// 32*omega1^2*omega2*omega3^4 - 6*omega1*omega2^4*omega3^2 + 24*omega1*omega2^2*omega3^4 - 18*omega1*omega3^6 +
/// 2*omega2^5*omega3^2 - 8*omega2^3*omega3^4 + 6*omega2*omega3^6)/(omega3^2*(9*omega1^2 - 2*omega1*omega2 +
/// omega2^2 - 3*omega3^2)*(omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 -
/// omega3))*harmonic_re_v1_A_v2_conjA_v12*A_v1*conj(A_v1)*A_v2 + harmonic_re_v1_conjA_v1_F*conj(A_v1)*F +
/// harmonic_re_v1_A_v22_conjA_v2*A_v2^2*conj(A_v2)
/// 3 columns; per observation at most 9 products and sums of complex numbers.
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
  Scalar factor[3];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (norm_A_v1 * A_v2));  // harmonic_re_v1_A_v2_conjA_v12
    store_complex(column_1, i, factor[1] * (conj_A_v1 * F));  // harmonic_re_v1_conjA_v1_F
    store_complex(column_2, i, factor[2] * (norm_A_v2 * A_v2));  // harmonic_re_v1_A_v22_conjA_v2
  }
}

/// columns[j][i] of the rows.
inline void columns_4(const BatchArrays& data, double* const* columns) {
  rows_4(data, FactorValues<factors_4<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_4(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_4(data, FactorSlopes<factors_4<DualNumber>, 3, 1, 3>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic -omega1+2*omega2 of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_5([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic -omega1+2*omega2 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + 2*omega2)*t) in v1 = harmonic_re_v1_A_v22_conjA_v1*conj(A_v1)*A_v2^2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_5(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * A_v2 * A_v2));  // harmonic_re_v1_A_v22_conjA_v1
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

/// What multiplies the 2 terms of the harmonic omega2+Omega of v1: functions of the frequencies alone. 5
/// operations.
template <class Scalar>
void factors_6([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  factor[0] = omega1 * per_0 / (Scalar(2.0) * omega2);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic omega2+Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + Omega)*t) in v1 = omega1/(2*omega2*(omega1 +
/// omega2))*conservative_v1_conjA_v2_F*A_v2*F + harmonic_re_v1_A_v1_A_v22*A_v1*A_v2^2
/// 2 columns; per observation at most 8 products and sums of complex numbers.
template <class Factors>
void rows_6(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v2 * F));  // conservative_v1_conjA_v2_F
    store_complex(column_1, i, factor[1] * (A_v1 * A_v2 * A_v2));  // harmonic_re_v1_A_v1_A_v22
  }
}

/// columns[j][i] of the rows.
inline void columns_6(const BatchArrays& data, double* const* columns) {
  rows_6(data, FactorValues<factors_6<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_6(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_6(data, FactorSlopes<factors_6<DualNumber>, 3, 1, 2>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 3*omega2 of v1: functions of the frequencies alone. 19
/// operations.
template <class Scalar>
void factors_7([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(3.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(3.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(8.0) * omega2_2 - Scalar(3.0) * omega3_2);
  factor[0] = (-omega1_2 * omega3_2 + omega2_2 * omega3_2) * per_0 * per_1 * per_2;
}

/// Rows of the harmonic 3*omega2 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega2)*t) in v1 = (-omega1^2*omega3^2 + omega2^2*omega3^2)/((omega1 +
/// 3*omega2)*(omega1 - 3*omega2)*(8*omega2^2 - 3*omega3^2))*harmonic_re_v1_A_v22_conjA_v2*A_v2^3
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_7(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_v2 * A_v2 * A_v2));  // harmonic_re_v1_A_v22_conjA_v2
  }
}

/// columns[j][i] of the rows.
inline void columns_7(const BatchArrays& data, double* const* columns) {
  rows_7(data, FactorValues<factors_7<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_7(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_7(data, FactorSlopes<factors_7<DualNumber>, 3, 1, 1>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic omega1+Omega of v1: functions of the frequencies alone. 104
/// operations.
template <class Scalar>
void factors_8([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega1_6 = omega1_5 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar per_0 = Scalar(1.0) / (Scalar(9.0) * omega1_2 - Scalar(2.0) * omega1 * omega2 + omega2_2
      - Scalar(3.0) * omega3_2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_3 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_4 = Scalar(1.0) / (Scalar(3.0) * omega1 + omega2);
  const Scalar per_5 = Scalar(1.0) / (Scalar(2.0) * omega1 + Omega);
  const Scalar per_6 = Scalar(1.0) / (omega3 + Omega);
  const Scalar per_7 = Scalar(1.0) / (omega3 - Omega);
  factor[0] = (Scalar(27.0) * omega1_6 - Scalar(84.0) * omega1_5 * omega2 + Scalar(91.0) * omega1_4 * omega2_2
      - Scalar(36.0) * omega1_4 * omega3_2 - Scalar(40.0) * omega1_3 * omega2_3
      + Scalar(60.0) * omega1_3 * omega2 * omega3_2 + Scalar(9.0) * omega1_2 * omega2_4
      - Scalar(40.0) * omega1_2 * omega2_2 * omega3_2 + Scalar(9.0) * omega1_2 * omega3_4
      - Scalar(4.0) * omega1 * omega2_5 + Scalar(20.0) * omega1 * omega2_3 * omega3_2
      - Scalar(12.0) * omega1 * omega2 * omega3_4 + omega2_6 - Scalar(4.0) * omega2_4 * omega3_2
      + Scalar(3.0) * omega2_2 * omega3_4) * per_0 * per_1 * per_2 * per_3 * per_4;
  factor[1] = (omega1_4 + Scalar(2.0) * omega1_3 * omega2 - omega1_2 * omega3_2 - Scalar(2.0) * omega1 * omega2_3
      - omega2_4 + omega2_2 * omega3_2) * per_5 * per_6 * per_7 / Omega;
}

/// Rows of the harmonic omega1+Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + Omega)*t) in v1 = (27*omega1^6 - 84*omega1^5*omega2 + 91*omega1^4*omega2^2 -
/// 36*omega1^4*omega3^2 - 40*omega1^3*omega2^3 + 60*omega1^3*omega2*omega3^2 + 9*omega1^2*omega2^4 -
/// 40*omega1^2*omega2^2*omega3^2 + 9*omega1^2*omega3^4 - 4*omega1*omega2^5 + 20*omega1*omega2^3*omega3^2 -
/// 12*omega1*omega2*omega3^4 + omega2^6 - 4*omega2^4*omega3^2 + 3*omega2^2*omega3^4)/((9*omega1^2 -
/// 2*omega1*omega2 + omega2^2 - 3*omega3^2)*(omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 -
/// omega3)*(3*omega1 + omega2))*harmonic_re_v1_A_v2_conjA_v12*A_v1^2*A_v2 + (omega1^4 + 2*omega1^3*omega2 -
/// omega1^2*omega3^2 - 2*omega1*omega2^3 - omega2^4 + omega2^2*omega3^2)/(Omega*(2*omega1 + Omega)*(omega3 +
/// Omega)*(omega3 - Omega))*harmonic_re_v1_conjA_v1_F*A_v1*F
/// 2 columns; per observation at most 8 products and sums of complex numbers.
template <class Factors>
void rows_8(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v1 * A_v2));  // harmonic_re_v1_A_v2_conjA_v12
    store_complex(column_1, i, factor[1] * (A_v1 * F));  // harmonic_re_v1_conjA_v1_F
  }
}

/// columns[j][i] of the rows.
inline void columns_8(const BatchArrays& data, double* const* columns) {
  rows_8(data, FactorValues<factors_8<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_8(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_8(data, FactorSlopes<factors_8<DualNumber>, 3, 1, 2>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 3*omega1 of v1: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_9([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic 3*omega1 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega1)*t) in v1 = harmonic_re_v1_A_v13*A_v1^3
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_9(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v1 * A_v1));  // harmonic_re_v1_A_v13
  }
}

/// columns[j][i] of the rows.
inline void columns_9(const BatchArrays& data, double* const* columns) {
  rows_9(data, FactorValues<factors_9<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_9(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic Omega of v2: functions of the frequencies alone. 6 operations.
template <class Scalar>
void factors_10([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega2 = natural_frequency[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar per_0 = Scalar(1.0) / (omega2 + Omega);
  const Scalar per_1 = Scalar(1.0) / (omega2 - Omega);
  factor[0] = per_0 * per_1 / Scalar(2.0);
}

/// Rows of the harmonic Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(Omega)*t) in v2 = 1/(2*(omega2 + Omega)*(omega2 - Omega))*e2*F
/// 1 columns; per observation at most 1 products and sums of complex numbers.
template <class Factors>
void rows_10(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (F));  // e2
  }
}

/// columns[j][i] of the rows.
inline void columns_10(const BatchArrays& data, double* const* columns) {
  rows_10(data, FactorValues<factors_10<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_10(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_10(data, FactorSlopes<factors_10<DualNumber>, 3, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic -2*omega1+omega2 of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_11([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic -2*omega1+omega2 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-2*omega1 + omega2)*t) in v2 = harmonic_re_v2_A_v2_conjA_v12*conj(A_v1)^2*A_v2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_11(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * conj_A_v1 * A_v2));  // harmonic_re_v2_A_v2_conjA_v12
  }
}

/// columns[j][i] of the rows.
inline void columns_11(const BatchArrays& data, double* const* columns) {
  rows_11(data, FactorValues<factors_11<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_11(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic -omega1+2*omega2 of v2: functions of the frequencies alone. 41
/// operations.
template <class Scalar>
void factors_12([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2 + omega3);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2 - omega3);
  const Scalar per_2 = Scalar(1.0) / (omega1 - Scalar(3.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(8.0) * omega2_2 - Scalar(3.0) * omega3_2);
  factor[0] = (omega1_3 * omega3_2 - omega1_2 * omega2 * omega3_2 + Scalar(7.0) * omega1 * omega2_2 * omega3_2
      - Scalar(3.0) * omega1 * omega3_4 + Scalar(9.0) * omega2_3 * omega3_2
      - Scalar(3.0) * omega2 * omega3_4) * per_0 * per_1 * per_2 * per_3;
}

/// Rows of the harmonic -omega1+2*omega2 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + 2*omega2)*t) in v2 = (omega1^3*omega3^2 - omega1^2*omega2*omega3^2 +
/// 7*omega1*omega2^2*omega3^2 - 3*omega1*omega3^4 + 9*omega2^3*omega3^2 - 3*omega2*omega3^4)/((omega1 - omega2 +
/// omega3)*(omega1 - omega2 - omega3)*(omega1 - 3*omega2)*(8*omega2^2 -
/// 3*omega3^2))*harmonic_re_v1_A_v22_conjA_v2*conj(A_v1)*A_v2^2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_12(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * A_v2 * A_v2));  // harmonic_re_v1_A_v22_conjA_v2
  }
}

/// columns[j][i] of the rows.
inline void columns_12(const BatchArrays& data, double* const* columns) {
  rows_12(data, FactorValues<factors_12<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_12(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_12(data, FactorSlopes<factors_12<DualNumber>, 3, 1, 1>{mode}, columns);
}

/// What multiplies the 3 terms of the harmonic omega1 of v2: functions of the frequencies alone. 103 operations.
template <class Scalar>
void factors_13([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar omega3_5 = omega3_4 * omega3;
  const Scalar omega3_6 = omega3_5 * omega3;
  const Scalar per_0 = Scalar(1.0) / (Scalar(9.0) * omega1_2 - Scalar(2.0) * omega1 * omega2 + omega2_2
      - Scalar(3.0) * omega3_2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_3 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_4 = Scalar(1.0) / (omega1 - omega2 + omega3);
  const Scalar per_5 = Scalar(1.0) / (omega1 - omega2 - omega3);
  const Scalar per_6 = Scalar(1.0) / (Scalar(8.0) * omega2_2 - Scalar(3.0) * omega3_2);
  factor[0] = (-Scalar(24.0) * omega1_5 + Scalar(56.0) * omega1_4 * omega2 - Scalar(40.0) * omega1_3 * omega2_2
      + Scalar(33.0) * omega1_3 * omega3_2 + Scalar(8.0) * omega1_2 * omega2_3
      - Scalar(29.0) * omega1_2 * omega2 * omega3_2 + Scalar(15.0) * omega1 * omega2_2 * omega3_2
      - Scalar(9.0) * omega1 * omega3_4 - Scalar(3.0) * omega2_3 * omega3_2
      + Scalar(3.0) * omega2 * omega3_4) * per_0 * per_1 / omega3_2;
  factor[1] = (-Scalar(8.0) * omega1_4 * omega2_2 + Scalar(2.0) * omega1_4 * omega3_2
      + Scalar(16.0) * omega1_2 * omega2_4 + Scalar(28.0) * omega1_2 * omega2_2 * omega3_2
      - Scalar(8.0) * omega1_2 * omega3_4 - Scalar(8.0) * omega2_6 + Scalar(34.0) * omega2_4 * omega3_2
      - Scalar(32.0) * omega2_2 * omega3_4 + Scalar(6.0) * omega3_6) * per_2 * per_3 * per_4 * per_5 * per_6;
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega1 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1)*t) in v2 = (-24*omega1^5 + 56*omega1^4*omega2 - 40*omega1^3*omega2^2 +
/// 33*omega1^3*omega3^2 + 8*omega1^2*omega2^3 - 29*omega1^2*omega2*omega3^2 + 15*omega1*omega2^2*omega3^2 -
/// 9*omega1*omega3^4 - 3*omega2^3*omega3^2 + 3*omega2*omega3^4)/(omega3^2*(9*omega1^2 - 2*omega1*omega2 +
/// omega2^2 - 3*omega3^2)*(omega1 + omega2))*harmonic_re_v1_A_v2_conjA_v12*A_v1^2*conj(A_v1) +
/// (-8*omega1^4*omega2^2 + 2*omega1^4*omega3^2 + 16*omega1^2*omega2^4 + 28*omega1^2*omega2^2*omega3^2 -
/// 8*omega1^2*omega3^4 - 8*omega2^6 + 34*omega2^4*omega3^2 - 32*omega2^2*omega3^4 + 6*omega3^6)/((omega1 +
/// omega2 + omega3)*(omega1 + omega2 - omega3)*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3)*(8*omega2^2
/// - 3*omega3^2))*harmonic_re_v1_A_v22_conjA_v2*A_v1*A_v2*conj(A_v2) + harmonic_re_v2_conjA_v2_F*conj(A_v2)*F
/// 3 columns; per observation at most 9 products and sums of complex numbers.
template <class Factors>
void rows_13(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[3];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex conj_A_v2 = conjugate(A_v2);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (norm_A_v1 * A_v1));  // harmonic_re_v1_A_v2_conjA_v12
    store_complex(column_1, i, factor[1] * (A_v1 * norm_A_v2));  // harmonic_re_v1_A_v22_conjA_v2
    store_complex(column_2, i, factor[2] * (conj_A_v2 * F));  // harmonic_re_v2_conjA_v2_F
  }
}

/// columns[j][i] of the rows.
inline void columns_13(const BatchArrays& data, double* const* columns) {
  rows_13(data, FactorValues<factors_13<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_13(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_13(data, FactorSlopes<factors_13<DualNumber>, 3, 1, 3>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic omega2+Omega of v2: functions of the frequencies alone. 65
/// operations.
template <class Scalar>
void factors_14([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_2 = Scalar(1.0) / (omega1 + Scalar(3.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(8.0) * omega2_2 - Scalar(3.0) * omega3_2);
  const Scalar per_4 = Scalar(1.0) / (Scalar(2.0) * omega2 + Omega);
  const Scalar per_5 = Scalar(1.0) / (omega3 + Omega);
  const Scalar per_6 = Scalar(1.0) / (omega3 - Omega);
  factor[0] = (omega1_3 * omega3_2 + omega1_2 * omega2 * omega3_2 + Scalar(7.0) * omega1 * omega2_2 * omega3_2
      - Scalar(3.0) * omega1 * omega3_4 - Scalar(9.0) * omega2_3 * omega3_2
      + Scalar(3.0) * omega2 * omega3_4) * per_0 * per_1 * per_2 * per_3;
  factor[1] = (-omega1_4 - Scalar(2.0) * omega1_3 * omega2 + omega1_2 * omega3_2 + Scalar(2.0) * omega1 * omega2_3
      + omega2_4 - omega2_2 * omega3_2) * per_4 * per_5 * per_6 / Omega;
}

/// Rows of the harmonic omega2+Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + Omega)*t) in v2 = (omega1^3*omega3^2 + omega1^2*omega2*omega3^2 +
/// 7*omega1*omega2^2*omega3^2 - 3*omega1*omega3^4 - 9*omega2^3*omega3^2 + 3*omega2*omega3^4)/((omega1 + omega2 +
/// omega3)*(omega1 + omega2 - omega3)*(omega1 + 3*omega2)*(8*omega2^2 -
/// 3*omega3^2))*harmonic_re_v1_A_v22_conjA_v2*A_v1*A_v2^2 + (-omega1^4 - 2*omega1^3*omega2 + omega1^2*omega3^2 +
/// 2*omega1*omega2^3 + omega2^4 - omega2^2*omega3^2)/(Omega*(2*omega2 + Omega)*(omega3 + Omega)*(omega3 -
/// Omega))*harmonic_re_v2_conjA_v2_F*A_v2*F
/// 2 columns; per observation at most 8 products and sums of complex numbers.
template <class Factors>
void rows_14(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v2 * A_v2));  // harmonic_re_v1_A_v22_conjA_v2
    store_complex(column_1, i, factor[1] * (A_v2 * F));  // harmonic_re_v2_conjA_v2_F
  }
}

/// columns[j][i] of the rows.
inline void columns_14(const BatchArrays& data, double* const* columns) {
  rows_14(data, FactorValues<factors_14<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_14(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_14(data, FactorSlopes<factors_14<DualNumber>, 3, 1, 2>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 3*omega2 of v2: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_15([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic 3*omega2 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega2)*t) in v2 = harmonic_re_v2_A_v23*A_v2^3
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_15(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_v2 * A_v2 * A_v2));  // harmonic_re_v2_A_v23
  }
}

/// columns[j][i] of the rows.
inline void columns_15(const BatchArrays& data, double* const* columns) {
  rows_15(data, FactorValues<factors_15<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_15(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 2 terms of the harmonic omega1+Omega of v2: functions of the frequencies alone. 3
/// operations.
template <class Scalar>
void factors_16([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  factor[0] = per_0 / Scalar(2.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic omega1+Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + Omega)*t) in v2 = 1/(2*(omega1 + omega2))*conservative_v1_conjA_v2_F*A_v1*F +
/// harmonic_re_v2_A_v12_A_v2*A_v1^2*A_v2
/// 2 columns; per observation at most 8 products and sums of complex numbers.
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
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * F));  // conservative_v1_conjA_v2_F
    store_complex(column_1, i, factor[1] * (A_v1 * A_v1 * A_v2));  // harmonic_re_v2_A_v12_A_v2
  }
}

/// columns[j][i] of the rows.
inline void columns_16(const BatchArrays& data, double* const* columns) {
  rows_16(data, FactorValues<factors_16<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_16(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_16(data, FactorSlopes<factors_16<DualNumber>, 3, 1, 2>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 3*omega1 of v2: functions of the frequencies alone. 29
/// operations.
template <class Scalar>
void factors_17([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar per_0 = Scalar(1.0) / (Scalar(9.0) * omega1_2 - Scalar(2.0) * omega1 * omega2 + omega2_2
      - Scalar(3.0) * omega3_2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(3.0) * omega1 + omega2);
  factor[0] = (omega1_3 - Scalar(3.0) * omega1_2 * omega2 + Scalar(3.0) * omega1 * omega2_2 - omega1 * omega3_2
      - omega2_3 + omega2 * omega3_2) * per_0 * per_1;
}

/// Rows of the harmonic 3*omega1 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega1)*t) in v2 = (omega1^3 - 3*omega1^2*omega2 + 3*omega1*omega2^2 - omega1*omega3^2
/// - omega2^3 + omega2*omega3^2)/((9*omega1^2 - 2*omega1*omega2 + omega2^2 - 3*omega3^2)*(3*omega1 +
/// omega2))*harmonic_re_v1_A_v2_conjA_v12*A_v1^3
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_17(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v1 * A_v1));  // harmonic_re_v1_A_v2_conjA_v12
  }
}

/// columns[j][i] of the rows.
inline void columns_17(const BatchArrays& data, double* const* columns) {
  rows_17(data, FactorValues<factors_17<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_17(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_17(data, FactorSlopes<factors_17<DualNumber>, 3, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic -omega1+omega2 of v3: functions of the frequencies alone. 7
/// operations.
template <class Scalar>
void factors_18([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2 + omega3);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2 - omega3);
  factor[0] = per_0 * per_1;
}

/// Rows of the harmonic -omega1+omega2 of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + omega2)*t) in v3 = 1/((omega1 - omega2 + omega3)*(omega1 - omega2 -
/// omega3))*a123*conj(A_v1)*A_v2
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_18(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * A_v2));  // a123
  }
}

/// columns[j][i] of the rows.
inline void columns_18(const BatchArrays& data, double* const* columns) {
  rows_18(data, FactorValues<factors_18<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_18(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_18(data, FactorSlopes<factors_18<DualNumber>, 3, 1, 1>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic 0 of v3: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_19([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega3_2 = omega3 * omega3;
  factor[0] = -Scalar(2.0) / omega3_2;
  factor[1] = -Scalar(2.0) / omega3_2;
}

/// Rows of the harmonic 0 of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in v3 = -2/omega3^2*a223*A_v2*conj(A_v2) - 2/omega3^2*a113*A_v1*conj(A_v1)
/// 2 columns; per observation at most 2 products and sums of complex numbers.
template <class Factors>
void rows_19(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    store_complex(column_0, i, Complex(factor[0] * (norm_A_v2)));  // a223
    store_complex(column_1, i, Complex(factor[1] * (norm_A_v1)));  // a113
  }
}

/// columns[j][i] of the rows.
inline void columns_19(const BatchArrays& data, double* const* columns) {
  rows_19(data, FactorValues<factors_19<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_19(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_19(data, FactorSlopes<factors_19<DualNumber>, 3, 1, 2>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic Omega of v3: functions of the frequencies alone. 13 operations.
template <class Scalar>
void factors_20([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar Omega = excitation_frequency[0];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_2 = Scalar(1.0) / (omega3 + Omega);
  const Scalar per_3 = Scalar(1.0) / (omega3 - Omega);
  factor[0] = per_0 * per_1;
  factor[1] = per_2 * per_3 / Scalar(2.0);
}

/// Rows of the harmonic Omega of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(Omega)*t) in v3 = 1/((omega1 + omega2 + omega3)*(omega1 + omega2 -
/// omega3))*a123*A_v1*A_v2 + 1/(2*(omega3 + Omega)*(omega3 - Omega))*e3*F
/// 2 columns; per observation at most 4 products and sums of complex numbers.
template <class Factors>
void rows_20(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v2));  // a123
    store_complex(column_1, i, factor[1] * (F));  // e3
  }
}

/// columns[j][i] of the rows.
inline void columns_20(const BatchArrays& data, double* const* columns) {
  rows_20(data, FactorValues<factors_20<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_20(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_20(data, FactorSlopes<factors_20<DualNumber>, 3, 1, 2>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 2*omega2 of v3: functions of the frequencies alone. 7 operations.
template <class Scalar>
void factors_21([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega2 + omega3);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega2 - omega3);
  factor[0] = per_0 * per_1;
}

/// Rows of the harmonic 2*omega2 of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega2)*t) in v3 = 1/((2*omega2 + omega3)*(2*omega2 - omega3))*a223*A_v2^2
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_21(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_v2 * A_v2));  // a223
  }
}

/// columns[j][i] of the rows.
inline void columns_21(const BatchArrays& data, double* const* columns) {
  rows_21(data, FactorValues<factors_21<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_21(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_21(data, FactorSlopes<factors_21<DualNumber>, 3, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 2*omega1 of v3: functions of the frequencies alone. 7 operations.
template <class Scalar>
void factors_22([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega3 = natural_frequency[2];
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega3);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega3);
  factor[0] = per_0 * per_1;
}

/// Rows of the harmonic 2*omega1 of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega1)*t) in v3 = 1/((2*omega1 + omega3)*(2*omega1 - omega3))*a113*A_v1^2
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_22(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v1));  // a113
  }
}

/// columns[j][i] of the rows.
inline void columns_22(const BatchArrays& data, double* const* columns) {
  rows_22(data, FactorValues<factors_22<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_22(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_22(data, FactorSlopes<factors_22<DualNumber>, 3, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic -omega1+Omega of v3: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_23([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic -omega1+Omega of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + Omega)*t) in v3 = harmonic_re_v3_conjA_v1_F*conj(A_v1)*F
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_23(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * F));  // harmonic_re_v3_conjA_v1_F
  }
}

/// columns[j][i] of the rows.
inline void columns_23(const BatchArrays& data, double* const* columns) {
  rows_23(data, FactorValues<factors_23<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_23(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic -omega2+Omega of v3: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_24([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic -omega2+Omega of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega2 + Omega)*t) in v3 = harmonic_re_v3_conjA_v2_F*conj(A_v2)*F
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_24(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex conj_A_v2 = conjugate(A_v2);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (conj_A_v2 * F));  // harmonic_re_v3_conjA_v2_F
  }
}

/// columns[j][i] of the rows.
inline void columns_24(const BatchArrays& data, double* const* columns) {
  rows_24(data, FactorValues<factors_24<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_24(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic omega2+Omega of v3: functions of the frequencies alone. 13
/// operations.
template <class Scalar>
void factors_25([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2 + omega3);
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2 - omega3);
  factor[0] = (omega1_2 - omega3_2) * per_0 * per_1;
}

/// Rows of the harmonic omega2+Omega of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + Omega)*t) in v3 = (omega1^2 - omega3^2)/((omega1 + 2*omega2 + omega3)*(omega1 +
/// 2*omega2 - omega3))*harmonic_re_v3_conjA_v2_F*A_v2*F
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_25(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v2 * F));  // harmonic_re_v3_conjA_v2_F
  }
}

/// columns[j][i] of the rows.
inline void columns_25(const BatchArrays& data, double* const* columns) {
  rows_25(data, FactorValues<factors_25<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_25(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_25(data, FactorSlopes<factors_25<DualNumber>, 3, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic omega1+Omega of v3: functions of the frequencies alone. 13
/// operations.
template <class Scalar>
void factors_26([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2 + omega3);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2 - omega3);
  factor[0] = (omega2_2 - omega3_2) * per_0 * per_1;
}

/// Rows of the harmonic omega1+Omega of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + Omega)*t) in v3 = (omega2^2 - omega3^2)/((2*omega1 + omega2 + omega3)*(2*omega1
/// + omega2 - omega3))*harmonic_re_v3_conjA_v1_F*A_v1*F
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_26(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * F));  // harmonic_re_v3_conjA_v1_F
  }
}

/// columns[j][i] of the rows.
inline void columns_26(const BatchArrays& data, double* const* columns) {
  rows_26(data, FactorValues<factors_26<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_26(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_26(data, FactorSlopes<factors_26<DualNumber>, 3, 1, 1>{mode}, columns);
}

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_v1/dt + i*(w_v1 - omega1)*B_v1 = -mu1*A_v1 + i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) +
/// i*conservative_v1_A_v12_conjA_v1*A_v1^2*conj(A_v1) + i*conservative_v1_conjA_v2_F*conj(A_v2)*F with A = B in
/// that frame
/// dB_v2/dt + i*(w_v2 - omega2)*B_v2 = omega1/omega2*i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*conj(A_v1)*A_v2 +
/// omega1/omega2*i*conservative_v1_conjA_v2_F*conj(A_v1)*F - mu2*A_v2 +
/// i*conservative_v2_A_v22_conjA_v2*A_v2^2*conj(A_v2) with A = B in that frame
/// dB_v3/dt + i*(w_v3 - omega3)*B_v3 = 0 with A = B in that frame
/// 30 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  [[maybe_unused]] const Scalar omega3 = parameters[2];
  Scalar lumps[24];
  evaluate_lumps(parameters, lumps);
  const Complex A_v1 = load_complex(amplitude, 0);
  const Complex conj_A_v1 = conjugate(A_v1);
  const Scalar norm_A_v1 = norm_of(A_v1);
  const Complex A_v2 = load_complex(amplitude, 1);
  const Complex conj_A_v2 = conjugate(A_v2);
  const Scalar norm_A_v2 = norm_of(A_v2);
  const Complex F = load_complex(forcing, 0);
  store_complex(derivative, 0, lumps[0] * (-Scalar(1.0)) * (A_v1)
       + times_i(lumps[1] * (A_v1 * norm_A_v2))
       + times_i(lumps[2] * (norm_A_v1 * A_v1))
       + times_i(lumps[3] * (conj_A_v2 * F))
       - times_i((-omega1 - omega2 + excitation_frequency[0]) * A_v1));
  store_complex(derivative, 1, times_i(lumps[1] * omega1 / omega2 * (norm_A_v1 * A_v2))
       + times_i(lumps[3] * omega1 / omega2 * (conj_A_v1 * F))
       + lumps[4] * (-Scalar(1.0)) * (A_v2)
       + times_i(lumps[5] * (norm_A_v2 * A_v2)));
  store_complex(derivative, 2, Complex());
}

/// jacobian[i * 6 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 55 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  [[maybe_unused]] const Scalar omega3 = parameters[2];
  Scalar lumps[24];
  evaluate_lumps(parameters, lumps);
  const Complex A_v1 = load_complex(amplitude, 0);
  const Complex conj_A_v1 = conjugate(A_v1);
  const Scalar norm_A_v1 = norm_of(A_v1);
  const Complex A_v2 = load_complex(amplitude, 1);
  const Complex conj_A_v2 = conjugate(A_v2);
  const Scalar norm_A_v2 = norm_of(A_v2);
  const Complex F = load_complex(forcing, 0);
  for (std::size_t i = 0; i < 36; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = Complex(lumps[0] * (-Scalar(1.0)))
       + times_i(Complex(lumps[1] * (norm_A_v2)))
       + times_i(Complex(lumps[2] * Scalar(2) * (norm_A_v1)))
       - Complex(Scalar(0.0), -omega1 - omega2 + excitation_frequency[0]);
  const Complex conj_by_0_0 = times_i(lumps[2] * (A_v1 * A_v1));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[6] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[7] = by_0_0.real - conj_by_0_0.real;
  const Complex by_0_1 = times_i(lumps[1] * (A_v1 * conj_A_v2));
  const Complex conj_by_0_1 = times_i(lumps[1] * (A_v1 * A_v2))
       + times_i(lumps[3] * (F));
  jacobian[2] = by_0_1.real + conj_by_0_1.real;
  jacobian[3] = conj_by_0_1.imag - by_0_1.imag;
  jacobian[8] = by_0_1.imag + conj_by_0_1.imag;
  jacobian[9] = by_0_1.real - conj_by_0_1.real;
  const Complex by_1_0 = times_i(lumps[1] * omega1 / omega2 * (conj_A_v1 * A_v2));
  const Complex conj_by_1_0 = times_i(lumps[1] * omega1 / omega2 * (A_v1 * A_v2))
       + times_i(lumps[3] * omega1 / omega2 * (F));
  jacobian[12] = by_1_0.real + conj_by_1_0.real;
  jacobian[13] = conj_by_1_0.imag - by_1_0.imag;
  jacobian[18] = by_1_0.imag + conj_by_1_0.imag;
  jacobian[19] = by_1_0.real - conj_by_1_0.real;
  const Complex by_1_1 = times_i(Complex(lumps[1] * omega1 / omega2 * (norm_A_v1)))
       + Complex(lumps[4] * (-Scalar(1.0)))
       + times_i(Complex(lumps[5] * Scalar(2) * (norm_A_v2)));
  const Complex conj_by_1_1 = times_i(lumps[5] * (A_v2 * A_v2));
  jacobian[14] = by_1_1.real + conj_by_1_1.real;
  jacobian[15] = conj_by_1_1.imag - by_1_1.imag;
  jacobian[20] = by_1_1.imag + conj_by_1_1.imag;
  jacobian[21] = by_1_1.real - conj_by_1_1.real;
}

}  // namespace additive_combination

namespace free {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: mu1 = mu1
/// lumps[4]: mu2 = mu2
/// lumps[7]: mu3 = mu3
/// lumps[8]: conservative_v3_A_v32_conjA_v3 = -5*a333^2/(3*omega3^3)
/// lumps[9]: a113 = a113
/// lumps[10]: a123 = a123
/// lumps[21]: a223 = a223
/// lumps[30]: a333 = a333
/// 3 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar mu1 = parameters[13];
  const Scalar mu2 = parameters[15];
  const Scalar mu3 = parameters[17];
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar a333_2 = a333 * a333;
  lumps[0] = mu1;  // mu1
  lumps[1] = lump_16(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v1_A_v3_conjA_v3
  lumps[2] = lump_0(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v1_A_v2_conjA_v2
  lumps[3] = lump_1(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v12_conjA_v1
  lumps[4] = mu2;  // mu2
  lumps[5] = lump_17(parameters, static_cast<Scalar*>(nullptr));  // conservative_v2_A_v2_A_v3_conjA_v3
  lumps[6] = lump_3(parameters, static_cast<Scalar*>(nullptr));  // conservative_v2_A_v22_conjA_v2
  lumps[7] = mu3;  // mu3
  lumps[8] = -Scalar(5.0) * a333_2 / (Scalar(3.0) * omega3_3);  // conservative_v3_A_v32_conjA_v3
  lumps[9] = a113;  // a113
  lumps[10] = a123;  // a123
  lumps[11] = lump_4(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v2_conjA_v12
  lumps[12] = lump_18(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v32_conjA_v1
  lumps[13] = lump_7(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v22_conjA_v1
  lumps[14] = lump_19(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v32_conjA_v2
  lumps[15] = lump_20(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v2_A_v3_conjA_v3
  lumps[16] = lump_6(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v22_conjA_v2
  lumps[17] = lump_21(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v2_A_v32
  lumps[18] = lump_22(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_A_v32
  lumps[19] = lump_8(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_A_v22
  lumps[20] = lump_9(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v13
  lumps[21] = a223;  // a223
  lumps[22] = lump_10(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v2_conjA_v12
  lumps[23] = lump_23(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v32_conjA_v1
  lumps[24] = lump_24(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v32_conjA_v2
  lumps[25] = lump_25(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v2_A_v32
  lumps[26] = lump_12(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v23
  lumps[27] = lump_26(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_A_v3_conjA_v3
  lumps[28] = lump_27(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_A_v32
  lumps[29] = lump_13(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v12_A_v2
  lumps[30] = a333;  // a333
  lumps[31] = lump_28(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v3_A_v3_conjA_v12
  lumps[32] = lump_29(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v3_A_v3_conjA_v1_conjA_v2
  lumps[33] = lump_30(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v3_A_v2_A_v3_conjA_v1
  lumps[34] = lump_31(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v3_A_v22_conjA_v3
  lumps[35] = lump_32(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v3_A_v22_A_v3
  lumps[36] = lump_33(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v3_A_v1_A_v3_conjA_v2
  lumps[37] = lump_34(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v3_A_v1_A_v2_A_v3
  lumps[38] = lump_35(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v3_A_v12_A_v3
}

/// jacobian[l * 19 + p] = d lumps[l] / d parameters[p]. 5 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  const Scalar omega3 = parameters[2];
  const Scalar a333 = parameters[6];
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar a333_2 = a333 * a333;
  for (std::size_t i = 0; i < 741; ++i) jacobian[i] = Scalar(0.0);
  jacobian[13] = Scalar(1.0);  // d mu1 / d mu1
  lump_16(parameters, jacobian + 19);  // d conservative_v1_A_v1_A_v3_conjA_v3
  lump_0(parameters, jacobian + 38);  // d conservative_v1_A_v1_A_v2_conjA_v2
  lump_1(parameters, jacobian + 57);  // d conservative_v1_A_v12_conjA_v1
  jacobian[91] = Scalar(1.0);  // d mu2 / d mu2
  lump_17(parameters, jacobian + 95);  // d conservative_v2_A_v2_A_v3_conjA_v3
  lump_3(parameters, jacobian + 114);  // d conservative_v2_A_v22_conjA_v2
  jacobian[150] = Scalar(1.0);  // d mu3 / d mu3
  jacobian[154] = Scalar(5.0) * a333_2 / omega3_4;  // d conservative_v3_A_v32_conjA_v3 / d omega3
  jacobian[158] = -Scalar(10.0) * a333 / (Scalar(3.0) * omega3_3);  // d conservative_v3_A_v32_conjA_v3 / d a333
  jacobian[174] = Scalar(1.0);  // d a113 / d a113
  jacobian[194] = Scalar(1.0);  // d a123 / d a123
  lump_4(parameters, jacobian + 209);  // d harmonic_re_v1_A_v2_conjA_v12
  lump_18(parameters, jacobian + 228);  // d harmonic_re_v1_A_v32_conjA_v1
  lump_7(parameters, jacobian + 247);  // d harmonic_re_v1_A_v22_conjA_v1
  lump_19(parameters, jacobian + 266);  // d harmonic_re_v1_A_v32_conjA_v2
  lump_20(parameters, jacobian + 285);  // d harmonic_re_v1_A_v2_A_v3_conjA_v3
  lump_6(parameters, jacobian + 304);  // d harmonic_re_v1_A_v22_conjA_v2
  lump_21(parameters, jacobian + 323);  // d harmonic_re_v1_A_v2_A_v32
  lump_22(parameters, jacobian + 342);  // d harmonic_re_v1_A_v1_A_v32
  lump_8(parameters, jacobian + 361);  // d harmonic_re_v1_A_v1_A_v22
  lump_9(parameters, jacobian + 380);  // d harmonic_re_v1_A_v13
  jacobian[404] = Scalar(1.0);  // d a223 / d a223
  lump_10(parameters, jacobian + 418);  // d harmonic_re_v2_A_v2_conjA_v12
  lump_23(parameters, jacobian + 437);  // d harmonic_re_v2_A_v32_conjA_v1
  lump_24(parameters, jacobian + 456);  // d harmonic_re_v2_A_v32_conjA_v2
  lump_25(parameters, jacobian + 475);  // d harmonic_re_v2_A_v2_A_v32
  lump_12(parameters, jacobian + 494);  // d harmonic_re_v2_A_v23
  lump_26(parameters, jacobian + 513);  // d harmonic_re_v2_A_v1_A_v3_conjA_v3
  lump_27(parameters, jacobian + 532);  // d harmonic_re_v2_A_v1_A_v32
  lump_13(parameters, jacobian + 551);  // d harmonic_re_v2_A_v12_A_v2
  jacobian[576] = Scalar(1.0);  // d a333 / d a333
  lump_28(parameters, jacobian + 589);  // d harmonic_re_v3_A_v3_conjA_v12
  lump_29(parameters, jacobian + 608);  // d harmonic_re_v3_A_v3_conjA_v1_conjA_v2
  lump_30(parameters, jacobian + 627);  // d harmonic_re_v3_A_v2_A_v3_conjA_v1
  lump_31(parameters, jacobian + 646);  // d harmonic_re_v3_A_v22_conjA_v3
  lump_32(parameters, jacobian + 665);  // d harmonic_re_v3_A_v22_A_v3
  lump_33(parameters, jacobian + 684);  // d harmonic_re_v3_A_v1_A_v3_conjA_v2
  lump_34(parameters, jacobian + 703);  // d harmonic_re_v3_A_v1_A_v2_A_v3
  lump_35(parameters, jacobian + 722);  // d harmonic_re_v3_A_v12_A_v3
}

/// What multiplies the 4 terms of the modulation of v1: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = -Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the modulation of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega1)*A_v1 = -mu1*A_v1 + i*conservative_v1_A_v1_A_v3_conjA_v3*A_v1*A_v3*conj(A_v3) +
/// i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) +
/// i*conservative_v1_A_v12_conjA_v1*A_v1^2*conj(A_v1)
/// 4 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_0(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex A_v3 = load_complex(amplitude_2, i);
    const Scalar norm_A_v3 = norm_of(A_v3);
    store_complex(column_0, i, factor[0] * (A_v1));  // mu1
    store_complex(column_1, i, times_i(factor[1] * (A_v1 * norm_A_v3)));  // conservative_v1_A_v1_A_v3_conjA_v3
    store_complex(column_2, i, times_i(factor[2] * (A_v1 * norm_A_v2)));  // conservative_v1_A_v1_A_v2_conjA_v2
    store_complex(column_3, i, times_i(factor[3] * (norm_A_v1 * A_v1)));  // conservative_v1_A_v12_conjA_v1
  }
}

/// columns[j][i] of the rows.
inline void columns_0(const BatchArrays& data, double* const* columns) {
  rows_0(data, FactorValues<factors_0<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_0(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 4 terms of the modulation of v2: functions of the frequencies alone. 1 operations.
template <class Scalar>
void factors_1([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  factor[0] = omega1 / omega2;
  factor[1] = -Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the modulation of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega2)*A_v2 = omega1/omega2*i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*conj(A_v1)*A_v2 - mu2*A_v2 +
/// i*conservative_v2_A_v2_A_v3_conjA_v3*A_v2*A_v3*conj(A_v3) +
/// i*conservative_v2_A_v22_conjA_v2*A_v2^2*conj(A_v2)
/// 4 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_1(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex A_v3 = load_complex(amplitude_2, i);
    const Scalar norm_A_v3 = norm_of(A_v3);
    store_complex(column_0, i, times_i(factor[0] * (norm_A_v1 * A_v2)));  // conservative_v1_A_v1_A_v2_conjA_v2
    store_complex(column_1, i, factor[1] * (A_v2));  // mu2
    store_complex(column_2, i, times_i(factor[2] * (A_v2 * norm_A_v3)));  // conservative_v2_A_v2_A_v3_conjA_v3
    store_complex(column_3, i, times_i(factor[3] * (norm_A_v2 * A_v2)));  // conservative_v2_A_v22_conjA_v2
  }
}

/// columns[j][i] of the rows.
inline void columns_1(const BatchArrays& data, double* const* columns) {
  rows_1(data, FactorValues<factors_1<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_1(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_1(data, FactorSlopes<factors_1<DualNumber>, 3, 1, 4>{mode}, columns);
}

/// What multiplies the 4 terms of the modulation of v3: functions of the frequencies alone. 2 operations.
template <class Scalar>
void factors_2([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  factor[0] = omega1 / omega3;
  factor[1] = omega2 / omega3;
  factor[2] = -Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the modulation of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega3)*A_v3 = omega1/omega3*i*conservative_v1_A_v1_A_v3_conjA_v3*A_v1*conj(A_v1)*A_v3 +
/// omega2/omega3*i*conservative_v2_A_v2_A_v3_conjA_v3*A_v2*conj(A_v2)*A_v3 - mu3*A_v3 +
/// i*conservative_v3_A_v32_conjA_v3*A_v3^2*conj(A_v3)
/// 4 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_2(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex A_v3 = load_complex(amplitude_2, i);
    const Scalar norm_A_v3 = norm_of(A_v3);
    store_complex(column_0, i, times_i(factor[0] * (norm_A_v1 * A_v3)));  // conservative_v1_A_v1_A_v3_conjA_v3
    store_complex(column_1, i, times_i(factor[1] * (norm_A_v2 * A_v3)));  // conservative_v2_A_v2_A_v3_conjA_v3
    store_complex(column_2, i, factor[2] * (A_v3));  // mu3
    store_complex(column_3, i, times_i(factor[3] * (norm_A_v3 * A_v3)));  // conservative_v3_A_v32_conjA_v3
  }
}

/// columns[j][i] of the rows.
inline void columns_2(const BatchArrays& data, double* const* columns) {
  rows_2(data, FactorValues<factors_2<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_2(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_2(data, FactorSlopes<factors_2<DualNumber>, 3, 1, 4>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic -omega1+omega3 of v1: functions of the frequencies alone. 5
/// operations.
template <class Scalar>
void factors_3([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega3 = natural_frequency[2];
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega3);
  factor[0] = -Scalar(2.0) * per_0 / omega3;
}

/// Rows of the harmonic -omega1+omega3 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + omega3)*t) in v1 = -2/(omega3*(2*omega1 - omega3))*a113*conj(A_v1)*A_v3
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_3(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v3 = load_complex(amplitude_2, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * A_v3));  // a113
  }
}

/// columns[j][i] of the rows.
inline void columns_3(const BatchArrays& data, double* const* columns) {
  rows_3(data, FactorValues<factors_3<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_3(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_3(data, FactorSlopes<factors_3<DualNumber>, 3, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic -omega2+omega3 of v1: functions of the frequencies alone. 7
/// operations.
template <class Scalar>
void factors_4([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2 + omega3);
  factor[0] = -per_0 * per_1;
}

/// Rows of the harmonic -omega2+omega3 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega2 + omega3)*t) in v1 = -1/((omega1 + omega2 - omega3)*(omega1 - omega2 +
/// omega3))*a123*conj(A_v2)*A_v3
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_4(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex conj_A_v2 = conjugate(A_v2);
    const Complex A_v3 = load_complex(amplitude_2, i);
    store_complex(column_0, i, factor[0] * (conj_A_v2 * A_v3));  // a123
  }
}

/// columns[j][i] of the rows.
inline void columns_4(const BatchArrays& data, double* const* columns) {
  rows_4(data, FactorValues<factors_4<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_4(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_4(data, FactorSlopes<factors_4<DualNumber>, 3, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic omega2+omega3 of v1: functions of the frequencies alone. 7
/// operations.
template <class Scalar>
void factors_5([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2 - omega3);
  factor[0] = -per_0 * per_1;
}

/// Rows of the harmonic omega2+omega3 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + omega3)*t) in v1 = -1/((omega1 + omega2 + omega3)*(omega1 - omega2 -
/// omega3))*a123*A_v2*A_v3
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_5(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex A_v3 = load_complex(amplitude_2, i);
    store_complex(column_0, i, factor[0] * (A_v2 * A_v3));  // a123
  }
}

/// columns[j][i] of the rows.
inline void columns_5(const BatchArrays& data, double* const* columns) {
  rows_5(data, FactorValues<factors_5<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_5(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_5(data, FactorSlopes<factors_5<DualNumber>, 3, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic omega1+omega3 of v1: functions of the frequencies alone. 5
/// operations.
template <class Scalar>
void factors_6([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega3 = natural_frequency[2];
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega3);
  factor[0] = Scalar(2.0) * per_0 / omega3;
}

/// Rows of the harmonic omega1+omega3 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + omega3)*t) in v1 = 2/(omega3*(2*omega1 + omega3))*a113*A_v1*A_v3
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_6(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v3 = load_complex(amplitude_2, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v3));  // a113
  }
}

/// columns[j][i] of the rows.
inline void columns_6(const BatchArrays& data, double* const* columns) {
  rows_6(data, FactorValues<factors_6<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_6(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_6(data, FactorSlopes<factors_6<DualNumber>, 3, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic -omega1+2*omega3 of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_8([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic -omega1+2*omega3 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + 2*omega3)*t) in v1 = harmonic_re_v1_A_v32_conjA_v1*conj(A_v1)*A_v3^2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_8(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v3 = load_complex(amplitude_2, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * A_v3 * A_v3));  // harmonic_re_v1_A_v32_conjA_v1
  }
}

/// columns[j][i] of the rows.
inline void columns_8(const BatchArrays& data, double* const* columns) {
  rows_8(data, FactorValues<factors_8<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_8(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic -omega2+2*omega3 of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_10([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic -omega2+2*omega3 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega2 + 2*omega3)*t) in v1 = harmonic_re_v1_A_v32_conjA_v2*conj(A_v2)*A_v3^2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_10(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex conj_A_v2 = conjugate(A_v2);
    const Complex A_v3 = load_complex(amplitude_2, i);
    store_complex(column_0, i, factor[0] * (conj_A_v2 * A_v3 * A_v3));  // harmonic_re_v1_A_v32_conjA_v2
  }
}

/// columns[j][i] of the rows.
inline void columns_10(const BatchArrays& data, double* const* columns) {
  rows_10(data, FactorValues<factors_10<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_10(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 3 terms of the harmonic omega2 of v1: functions of the frequencies alone. 94 operations.
template <class Scalar>
void factors_11([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega1_6 = omega1_5 * omega1;
  const Scalar omega1_7 = omega1_6 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar omega3_5 = omega3_4 * omega3;
  const Scalar omega3_6 = omega3_5 * omega3;
  const Scalar per_0 = Scalar(1.0) / (Scalar(9.0) * omega1_2 - Scalar(2.0) * omega1 * omega2 + omega2_2
      - Scalar(3.0) * omega3_2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_3 = Scalar(1.0) / (omega1 + omega2 - omega3);
  factor[0] = (Scalar(24.0) * omega1_7 - Scalar(8.0) * omega1_6 * omega2 - Scalar(48.0) * omega1_5 * omega2_2
      - Scalar(102.0) * omega1_5 * omega3_2 + Scalar(16.0) * omega1_4 * omega2_3
      + Scalar(34.0) * omega1_4 * omega2 * omega3_2 + Scalar(24.0) * omega1_3 * omega2_4
      - Scalar(84.0) * omega1_3 * omega2_2 * omega3_2 + Scalar(96.0) * omega1_3 * omega3_4
      - Scalar(8.0) * omega1_2 * omega2_5 + Scalar(28.0) * omega1_2 * omega2_3 * omega3_2
      - Scalar(32.0) * omega1_2 * omega2 * omega3_4 - Scalar(6.0) * omega1 * omega2_4 * omega3_2
      + Scalar(24.0) * omega1 * omega2_2 * omega3_4 - Scalar(18.0) * omega1 * omega3_6
      + Scalar(2.0) * omega2_5 * omega3_2 - Scalar(8.0) * omega2_3 * omega3_4
      + Scalar(6.0) * omega2 * omega3_6) * per_0 * per_1 * per_2 * per_3 / omega3_2;
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega2 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2)*t) in v1 = (24*omega1^7 - 8*omega1^6*omega2 - 48*omega1^5*omega2^2 -
/// 102*omega1^5*omega3^2 + 16*omega1^4*omega2^3 + 34*omega1^4*omega2*omega3^2 + 24*omega1^3*omega2^4 -
/// 84*omega1^3*omega2^2*omega3^2 + 96*omega1^3*omega3^4 - 8*omega1^2*omega2^5 + 28*omega1^2*omega2^3*omega3^2 -
/// 32*omega1^2*omega2*omega3^4 - 6*omega1*omega2^4*omega3^2 + 24*omega1*omega2^2*omega3^4 - 18*omega1*omega3^6 +
/// 2*omega2^5*omega3^2 - 8*omega2^3*omega3^4 + 6*omega2*omega3^6)/(omega3^2*(9*omega1^2 - 2*omega1*omega2 +
/// omega2^2 - 3*omega3^2)*(omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 -
/// omega3))*harmonic_re_v1_A_v2_conjA_v12*A_v1*conj(A_v1)*A_v2 +
/// harmonic_re_v1_A_v2_A_v3_conjA_v3*A_v2*A_v3*conj(A_v3) + harmonic_re_v1_A_v22_conjA_v2*A_v2^2*conj(A_v2)
/// 3 columns; per observation at most 9 products and sums of complex numbers.
template <class Factors>
void rows_11(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[3];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex A_v3 = load_complex(amplitude_2, i);
    const Scalar norm_A_v3 = norm_of(A_v3);
    store_complex(column_0, i, factor[0] * (norm_A_v1 * A_v2));  // harmonic_re_v1_A_v2_conjA_v12
    store_complex(column_1, i, factor[1] * (A_v2 * norm_A_v3));  // harmonic_re_v1_A_v2_A_v3_conjA_v3
    store_complex(column_2, i, factor[2] * (norm_A_v2 * A_v2));  // harmonic_re_v1_A_v22_conjA_v2
  }
}

/// columns[j][i] of the rows.
inline void columns_11(const BatchArrays& data, double* const* columns) {
  rows_11(data, FactorValues<factors_11<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_11(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_11(data, FactorSlopes<factors_11<DualNumber>, 3, 1, 3>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic omega2+2*omega3 of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_12([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic omega2+2*omega3 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + 2*omega3)*t) in v1 = harmonic_re_v1_A_v2_A_v32*A_v2*A_v3^2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_12(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex A_v3 = load_complex(amplitude_2, i);
    store_complex(column_0, i, factor[0] * (A_v2 * A_v3 * A_v3));  // harmonic_re_v1_A_v2_A_v32
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

/// What multiplies the 1 terms of the harmonic omega1+2*omega3 of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_14([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic omega1+2*omega3 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + 2*omega3)*t) in v1 = harmonic_re_v1_A_v1_A_v32*A_v1*A_v3^2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_14(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v3 = load_complex(amplitude_2, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v3 * A_v3));  // harmonic_re_v1_A_v1_A_v32
  }
}

/// columns[j][i] of the rows.
inline void columns_14(const BatchArrays& data, double* const* columns) {
  rows_14(data, FactorValues<factors_14<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_14(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic omega1+2*omega2 of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_15([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic omega1+2*omega2 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + 2*omega2)*t) in v1 = harmonic_re_v1_A_v1_A_v22*A_v1*A_v2^2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_15(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v2 * A_v2));  // harmonic_re_v1_A_v1_A_v22
  }
}

/// columns[j][i] of the rows.
inline void columns_15(const BatchArrays& data, double* const* columns) {
  rows_15(data, FactorValues<factors_15<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_15(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic 2*omega1+omega2 of v1: functions of the frequencies alone. 82
/// operations.
template <class Scalar>
void factors_16([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega1_6 = omega1_5 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar per_0 = Scalar(1.0) / (Scalar(9.0) * omega1_2 - Scalar(2.0) * omega1 * omega2 + omega2_2
      - Scalar(3.0) * omega3_2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_3 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_4 = Scalar(1.0) / (Scalar(3.0) * omega1 + omega2);
  factor[0] = (Scalar(27.0) * omega1_6 - Scalar(84.0) * omega1_5 * omega2 + Scalar(91.0) * omega1_4 * omega2_2
      - Scalar(36.0) * omega1_4 * omega3_2 - Scalar(40.0) * omega1_3 * omega2_3
      + Scalar(60.0) * omega1_3 * omega2 * omega3_2 + Scalar(9.0) * omega1_2 * omega2_4
      - Scalar(40.0) * omega1_2 * omega2_2 * omega3_2 + Scalar(9.0) * omega1_2 * omega3_4
      - Scalar(4.0) * omega1 * omega2_5 + Scalar(20.0) * omega1 * omega2_3 * omega3_2
      - Scalar(12.0) * omega1 * omega2 * omega3_4 + omega2_6 - Scalar(4.0) * omega2_4 * omega3_2
      + Scalar(3.0) * omega2_2 * omega3_4) * per_0 * per_1 * per_2 * per_3 * per_4;
}

/// Rows of the harmonic 2*omega1+omega2 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega1 + omega2)*t) in v1 = (27*omega1^6 - 84*omega1^5*omega2 + 91*omega1^4*omega2^2 -
/// 36*omega1^4*omega3^2 - 40*omega1^3*omega2^3 + 60*omega1^3*omega2*omega3^2 + 9*omega1^2*omega2^4 -
/// 40*omega1^2*omega2^2*omega3^2 + 9*omega1^2*omega3^4 - 4*omega1*omega2^5 + 20*omega1*omega2^3*omega3^2 -
/// 12*omega1*omega2*omega3^4 + omega2^6 - 4*omega2^4*omega3^2 + 3*omega2^2*omega3^4)/((9*omega1^2 -
/// 2*omega1*omega2 + omega2^2 - 3*omega3^2)*(omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 -
/// omega3)*(3*omega1 + omega2))*harmonic_re_v1_A_v2_conjA_v12*A_v1^2*A_v2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_16(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v1 * A_v2));  // harmonic_re_v1_A_v2_conjA_v12
  }
}

/// columns[j][i] of the rows.
inline void columns_16(const BatchArrays& data, double* const* columns) {
  rows_16(data, FactorValues<factors_16<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_16(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_16(data, FactorSlopes<factors_16<DualNumber>, 3, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic -omega1+omega3 of v2: functions of the frequencies alone. 7
/// operations.
template <class Scalar>
void factors_18([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2 - omega3);
  factor[0] = per_0 * per_1;
}

/// Rows of the harmonic -omega1+omega3 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + omega3)*t) in v2 = 1/((omega1 + omega2 - omega3)*(omega1 - omega2 -
/// omega3))*a123*conj(A_v1)*A_v3
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_18(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v3 = load_complex(amplitude_2, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * A_v3));  // a123
  }
}

/// columns[j][i] of the rows.
inline void columns_18(const BatchArrays& data, double* const* columns) {
  rows_18(data, FactorValues<factors_18<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_18(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_18(data, FactorSlopes<factors_18<DualNumber>, 3, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic -omega2+omega3 of v2: functions of the frequencies alone. 5
/// operations.
template <class Scalar>
void factors_19([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega2 - omega3);
  factor[0] = -Scalar(2.0) * per_0 / omega3;
}

/// Rows of the harmonic -omega2+omega3 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega2 + omega3)*t) in v2 = -2/(omega3*(2*omega2 - omega3))*a223*conj(A_v2)*A_v3
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_19(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex conj_A_v2 = conjugate(A_v2);
    const Complex A_v3 = load_complex(amplitude_2, i);
    store_complex(column_0, i, factor[0] * (conj_A_v2 * A_v3));  // a223
  }
}

/// columns[j][i] of the rows.
inline void columns_19(const BatchArrays& data, double* const* columns) {
  rows_19(data, FactorValues<factors_19<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_19(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_19(data, FactorSlopes<factors_19<DualNumber>, 3, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic omega2+omega3 of v2: functions of the frequencies alone. 5
/// operations.
template <class Scalar>
void factors_20([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega2 + omega3);
  factor[0] = Scalar(2.0) * per_0 / omega3;
}

/// Rows of the harmonic omega2+omega3 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + omega3)*t) in v2 = 2/(omega3*(2*omega2 + omega3))*a223*A_v2*A_v3
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_20(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex A_v3 = load_complex(amplitude_2, i);
    store_complex(column_0, i, factor[0] * (A_v2 * A_v3));  // a223
  }
}

/// columns[j][i] of the rows.
inline void columns_20(const BatchArrays& data, double* const* columns) {
  rows_20(data, FactorValues<factors_20<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_20(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_20(data, FactorSlopes<factors_20<DualNumber>, 3, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic omega1+omega3 of v2: functions of the frequencies alone. 7
/// operations.
template <class Scalar>
void factors_21([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2 + omega3);
  factor[0] = per_0 * per_1;
}

/// Rows of the harmonic omega1+omega3 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + omega3)*t) in v2 = 1/((omega1 + omega2 + omega3)*(omega1 - omega2 +
/// omega3))*a123*A_v1*A_v3
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_21(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v3 = load_complex(amplitude_2, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v3));  // a123
  }
}

/// columns[j][i] of the rows.
inline void columns_21(const BatchArrays& data, double* const* columns) {
  rows_21(data, FactorValues<factors_21<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_21(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_21(data, FactorSlopes<factors_21<DualNumber>, 3, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic -omega1+2*omega3 of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_23([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic -omega1+2*omega3 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + 2*omega3)*t) in v2 = harmonic_re_v2_A_v32_conjA_v1*conj(A_v1)*A_v3^2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_23(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v3 = load_complex(amplitude_2, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * A_v3 * A_v3));  // harmonic_re_v2_A_v32_conjA_v1
  }
}

/// columns[j][i] of the rows.
inline void columns_23(const BatchArrays& data, double* const* columns) {
  rows_23(data, FactorValues<factors_23<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_23(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic -omega2+2*omega3 of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_25([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic -omega2+2*omega3 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega2 + 2*omega3)*t) in v2 = harmonic_re_v2_A_v32_conjA_v2*conj(A_v2)*A_v3^2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_25(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex conj_A_v2 = conjugate(A_v2);
    const Complex A_v3 = load_complex(amplitude_2, i);
    store_complex(column_0, i, factor[0] * (conj_A_v2 * A_v3 * A_v3));  // harmonic_re_v2_A_v32_conjA_v2
  }
}

/// columns[j][i] of the rows.
inline void columns_25(const BatchArrays& data, double* const* columns) {
  rows_25(data, FactorValues<factors_25<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_25(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic omega2+2*omega3 of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_26([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic omega2+2*omega3 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + 2*omega3)*t) in v2 = harmonic_re_v2_A_v2_A_v32*A_v2*A_v3^2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_26(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex A_v3 = load_complex(amplitude_2, i);
    store_complex(column_0, i, factor[0] * (A_v2 * A_v3 * A_v3));  // harmonic_re_v2_A_v2_A_v32
  }
}

/// columns[j][i] of the rows.
inline void columns_26(const BatchArrays& data, double* const* columns) {
  rows_26(data, FactorValues<factors_26<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_26(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 3 terms of the harmonic omega1 of v2: functions of the frequencies alone. 103 operations.
template <class Scalar>
void factors_28([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar omega3_5 = omega3_4 * omega3;
  const Scalar omega3_6 = omega3_5 * omega3;
  const Scalar per_0 = Scalar(1.0) / (Scalar(9.0) * omega1_2 - Scalar(2.0) * omega1 * omega2 + omega2_2
      - Scalar(3.0) * omega3_2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_3 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_4 = Scalar(1.0) / (omega1 - omega2 + omega3);
  const Scalar per_5 = Scalar(1.0) / (omega1 - omega2 - omega3);
  const Scalar per_6 = Scalar(1.0) / (Scalar(8.0) * omega2_2 - Scalar(3.0) * omega3_2);
  factor[0] = (-Scalar(24.0) * omega1_5 + Scalar(56.0) * omega1_4 * omega2 - Scalar(40.0) * omega1_3 * omega2_2
      + Scalar(33.0) * omega1_3 * omega3_2 + Scalar(8.0) * omega1_2 * omega2_3
      - Scalar(29.0) * omega1_2 * omega2 * omega3_2 + Scalar(15.0) * omega1 * omega2_2 * omega3_2
      - Scalar(9.0) * omega1 * omega3_4 - Scalar(3.0) * omega2_3 * omega3_2
      + Scalar(3.0) * omega2 * omega3_4) * per_0 * per_1 / omega3_2;
  factor[1] = (-Scalar(8.0) * omega1_4 * omega2_2 + Scalar(2.0) * omega1_4 * omega3_2
      + Scalar(16.0) * omega1_2 * omega2_4 + Scalar(28.0) * omega1_2 * omega2_2 * omega3_2
      - Scalar(8.0) * omega1_2 * omega3_4 - Scalar(8.0) * omega2_6 + Scalar(34.0) * omega2_4 * omega3_2
      - Scalar(32.0) * omega2_2 * omega3_4 + Scalar(6.0) * omega3_6) * per_2 * per_3 * per_4 * per_5 * per_6;
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega1 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1)*t) in v2 = (-24*omega1^5 + 56*omega1^4*omega2 - 40*omega1^3*omega2^2 +
/// 33*omega1^3*omega3^2 + 8*omega1^2*omega2^3 - 29*omega1^2*omega2*omega3^2 + 15*omega1*omega2^2*omega3^2 -
/// 9*omega1*omega3^4 - 3*omega2^3*omega3^2 + 3*omega2*omega3^4)/(omega3^2*(9*omega1^2 - 2*omega1*omega2 +
/// omega2^2 - 3*omega3^2)*(omega1 + omega2))*harmonic_re_v1_A_v2_conjA_v12*A_v1^2*conj(A_v1) +
/// (-8*omega1^4*omega2^2 + 2*omega1^4*omega3^2 + 16*omega1^2*omega2^4 + 28*omega1^2*omega2^2*omega3^2 -
/// 8*omega1^2*omega3^4 - 8*omega2^6 + 34*omega2^4*omega3^2 - 32*omega2^2*omega3^4 + 6*omega3^6)/((omega1 +
/// omega2 + omega3)*(omega1 + omega2 - omega3)*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3)*(8*omega2^2
/// - 3*omega3^2))*harmonic_re_v1_A_v22_conjA_v2*A_v1*A_v2*conj(A_v2) +
/// harmonic_re_v2_A_v1_A_v3_conjA_v3*A_v1*A_v3*conj(A_v3)
/// 3 columns; per observation at most 9 products and sums of complex numbers.
template <class Factors>
void rows_28(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[3];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex A_v3 = load_complex(amplitude_2, i);
    const Scalar norm_A_v3 = norm_of(A_v3);
    store_complex(column_0, i, factor[0] * (norm_A_v1 * A_v1));  // harmonic_re_v1_A_v2_conjA_v12
    store_complex(column_1, i, factor[1] * (A_v1 * norm_A_v2));  // harmonic_re_v1_A_v22_conjA_v2
    store_complex(column_2, i, factor[2] * (A_v1 * norm_A_v3));  // harmonic_re_v2_A_v1_A_v3_conjA_v3
  }
}

/// columns[j][i] of the rows.
inline void columns_28(const BatchArrays& data, double* const* columns) {
  rows_28(data, FactorValues<factors_28<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_28(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_28(data, FactorSlopes<factors_28<DualNumber>, 3, 1, 3>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic omega1+2*omega3 of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_29([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic omega1+2*omega3 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + 2*omega3)*t) in v2 = harmonic_re_v2_A_v1_A_v32*A_v1*A_v3^2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_29(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v3 = load_complex(amplitude_2, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v3 * A_v3));  // harmonic_re_v2_A_v1_A_v32
  }
}

/// columns[j][i] of the rows.
inline void columns_29(const BatchArrays& data, double* const* columns) {
  rows_29(data, FactorValues<factors_29<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_29(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic omega1+2*omega2 of v2: functions of the frequencies alone. 41
/// operations.
template <class Scalar>
void factors_30([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2 - omega3);
  const Scalar per_2 = Scalar(1.0) / (omega1 + Scalar(3.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(8.0) * omega2_2 - Scalar(3.0) * omega3_2);
  factor[0] = (omega1_3 * omega3_2 + omega1_2 * omega2 * omega3_2 + Scalar(7.0) * omega1 * omega2_2 * omega3_2
      - Scalar(3.0) * omega1 * omega3_4 - Scalar(9.0) * omega2_3 * omega3_2
      + Scalar(3.0) * omega2 * omega3_4) * per_0 * per_1 * per_2 * per_3;
}

/// Rows of the harmonic omega1+2*omega2 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + 2*omega2)*t) in v2 = (omega1^3*omega3^2 + omega1^2*omega2*omega3^2 +
/// 7*omega1*omega2^2*omega3^2 - 3*omega1*omega3^4 - 9*omega2^3*omega3^2 + 3*omega2*omega3^4)/((omega1 + omega2 +
/// omega3)*(omega1 + omega2 - omega3)*(omega1 + 3*omega2)*(8*omega2^2 -
/// 3*omega3^2))*harmonic_re_v1_A_v22_conjA_v2*A_v1*A_v2^2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_30(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v2 * A_v2));  // harmonic_re_v1_A_v22_conjA_v2
  }
}

/// columns[j][i] of the rows.
inline void columns_30(const BatchArrays& data, double* const* columns) {
  rows_30(data, FactorValues<factors_30<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_30(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_30(data, FactorSlopes<factors_30<DualNumber>, 3, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 2*omega1+omega2 of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_31([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega1+omega2 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega1 + omega2)*t) in v2 = harmonic_re_v2_A_v12_A_v2*A_v1^2*A_v2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_31(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v1 * A_v2));  // harmonic_re_v2_A_v12_A_v2
  }
}

/// columns[j][i] of the rows.
inline void columns_31(const BatchArrays& data, double* const* columns) {
  rows_31(data, FactorValues<factors_31<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_31(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 3 terms of the harmonic 0 of v3: functions of the frequencies alone. 4 operations.
template <class Scalar>
void factors_34([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega3_2 = omega3 * omega3;
  factor[0] = -Scalar(2.0) / omega3_2;
  factor[1] = -Scalar(2.0) / omega3_2;
  factor[2] = -Scalar(2.0) / omega3_2;
}

/// Rows of the harmonic 0 of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in v3 = -2/omega3^2*a113*A_v1*conj(A_v1) - 2/omega3^2*a223*A_v2*conj(A_v2) -
/// 2/omega3^2*a333*A_v3*conj(A_v3)
/// 3 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_34(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[3];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex A_v3 = load_complex(amplitude_2, i);
    const Scalar norm_A_v3 = norm_of(A_v3);
    store_complex(column_0, i, Complex(factor[0] * (norm_A_v1)));  // a113
    store_complex(column_1, i, Complex(factor[1] * (norm_A_v2)));  // a223
    store_complex(column_2, i, Complex(factor[2] * (norm_A_v3)));  // a333
  }
}

/// columns[j][i] of the rows.
inline void columns_34(const BatchArrays& data, double* const* columns) {
  rows_34(data, FactorValues<factors_34<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_34(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_34(data, FactorSlopes<factors_34<DualNumber>, 3, 1, 3>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 2*omega3 of v3: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_35([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega3_2 = omega3 * omega3;
  factor[0] = Scalar(1.0) / (Scalar(3.0) * omega3_2);
}

/// Rows of the harmonic 2*omega3 of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega3)*t) in v3 = 1/(3*omega3^2)*a333*A_v3^2
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_35(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v3 = load_complex(amplitude_2, i);
    store_complex(column_0, i, factor[0] * (A_v3 * A_v3));  // a333
  }
}

/// columns[j][i] of the rows.
inline void columns_35(const BatchArrays& data, double* const* columns) {
  rows_35(data, FactorValues<factors_35<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_35(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_35(data, FactorSlopes<factors_35<DualNumber>, 3, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic omega1+omega2 of v3: functions of the frequencies alone. 7
/// operations.
template <class Scalar>
void factors_37([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2 + omega3);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2 - omega3);
  factor[0] = per_0 * per_1;
}

/// Rows of the harmonic omega1+omega2 of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + omega2)*t) in v3 = 1/((omega1 + omega2 + omega3)*(omega1 + omega2 -
/// omega3))*a123*A_v1*A_v2
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_37(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v2));  // a123
  }
}

/// columns[j][i] of the rows.
inline void columns_37(const BatchArrays& data, double* const* columns) {
  rows_37(data, FactorValues<factors_37<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_37(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_37(data, FactorSlopes<factors_37<DualNumber>, 3, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic -2*omega1+omega3 of v3: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_39([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic -2*omega1+omega3 of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-2*omega1 + omega3)*t) in v3 = harmonic_re_v3_A_v3_conjA_v12*conj(A_v1)^2*A_v3
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_39(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v3 = load_complex(amplitude_2, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * conj_A_v1 * A_v3));  // harmonic_re_v3_A_v3_conjA_v12
  }
}

/// columns[j][i] of the rows.
inline void columns_39(const BatchArrays& data, double* const* columns) {
  rows_39(data, FactorValues<factors_39<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_39(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic -omega1-omega2+omega3 of v3: functions of the frequencies alone.
/// 0 operations.
template <class Scalar>
void factors_40([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic -omega1-omega2+omega3 of v3: target = sum of columns[j][i] * lump_j, with the factors
/// above.
/// amplitude of exp(i*(-omega1 - omega2 + omega3)*t) in v3 =
/// harmonic_re_v3_A_v3_conjA_v1_conjA_v2*conj(A_v1)*conj(A_v2)*A_v3
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_40(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex conj_A_v2 = conjugate(A_v2);
    const Complex A_v3 = load_complex(amplitude_2, i);
    // harmonic_re_v3_A_v3_conjA_v1_conjA_v2
    store_complex(column_0, i, factor[0] * (conj_A_v1 * conj_A_v2 * A_v3));
  }
}

/// columns[j][i] of the rows.
inline void columns_40(const BatchArrays& data, double* const* columns) {
  rows_40(data, FactorValues<factors_40<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_40(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic -omega1+omega2+omega3 of v3: functions of the frequencies alone.
/// 0 operations.
template <class Scalar>
void factors_41([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic -omega1+omega2+omega3 of v3: target = sum of columns[j][i] * lump_j, with the factors
/// above.
/// amplitude of exp(i*(-omega1 + omega2 + omega3)*t) in v3 =
/// harmonic_re_v3_A_v2_A_v3_conjA_v1*conj(A_v1)*A_v2*A_v3
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_41(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex A_v3 = load_complex(amplitude_2, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * A_v2 * A_v3));  // harmonic_re_v3_A_v2_A_v3_conjA_v1
  }
}

/// columns[j][i] of the rows.
inline void columns_41(const BatchArrays& data, double* const* columns) {
  rows_41(data, FactorValues<factors_41<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_41(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic 3*omega3 of v3: functions of the frequencies alone. 2 operations.
template <class Scalar>
void factors_42([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega3 = natural_frequency[2];
  factor[0] = -Scalar(1.0) / (Scalar(20.0) * omega3);
}

/// Rows of the harmonic 3*omega3 of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega3)*t) in v3 = -1/(20*omega3)*conservative_v3_A_v32_conjA_v3*A_v3^3
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_42(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v3 = load_complex(amplitude_2, i);
    store_complex(column_0, i, factor[0] * (A_v3 * A_v3 * A_v3));  // conservative_v3_A_v32_conjA_v3
  }
}

/// columns[j][i] of the rows.
inline void columns_42(const BatchArrays& data, double* const* columns) {
  rows_42(data, FactorValues<factors_42<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_42(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_42(data, FactorSlopes<factors_42<DualNumber>, 3, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 2*omega2-omega3 of v3: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_43([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega2-omega3 of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega2 - omega3)*t) in v3 = harmonic_re_v3_A_v22_conjA_v3*A_v2^2*conj(A_v3)
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_43(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex A_v3 = load_complex(amplitude_2, i);
    const Complex conj_A_v3 = conjugate(A_v3);
    store_complex(column_0, i, factor[0] * (A_v2 * A_v2 * conj_A_v3));  // harmonic_re_v3_A_v22_conjA_v3
  }
}

/// columns[j][i] of the rows.
inline void columns_43(const BatchArrays& data, double* const* columns) {
  rows_43(data, FactorValues<factors_43<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_43(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic 2*omega2+omega3 of v3: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_44([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega2+omega3 of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega2 + omega3)*t) in v3 = harmonic_re_v3_A_v22_A_v3*A_v2^2*A_v3
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_44(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex A_v3 = load_complex(amplitude_2, i);
    store_complex(column_0, i, factor[0] * (A_v2 * A_v2 * A_v3));  // harmonic_re_v3_A_v22_A_v3
  }
}

/// columns[j][i] of the rows.
inline void columns_44(const BatchArrays& data, double* const* columns) {
  rows_44(data, FactorValues<factors_44<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_44(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic omega1-omega2+omega3 of v3: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_45([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic omega1-omega2+omega3 of v3: target = sum of columns[j][i] * lump_j, with the factors
/// above.
/// amplitude of exp(i*(omega1 - omega2 + omega3)*t) in v3 =
/// harmonic_re_v3_A_v1_A_v3_conjA_v2*A_v1*conj(A_v2)*A_v3
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_45(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex conj_A_v2 = conjugate(A_v2);
    const Complex A_v3 = load_complex(amplitude_2, i);
    store_complex(column_0, i, factor[0] * (A_v1 * conj_A_v2 * A_v3));  // harmonic_re_v3_A_v1_A_v3_conjA_v2
  }
}

/// columns[j][i] of the rows.
inline void columns_45(const BatchArrays& data, double* const* columns) {
  rows_45(data, FactorValues<factors_45<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_45(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic omega1+omega2+omega3 of v3: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_46([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic omega1+omega2+omega3 of v3: target = sum of columns[j][i] * lump_j, with the factors
/// above.
/// amplitude of exp(i*(omega1 + omega2 + omega3)*t) in v3 = harmonic_re_v3_A_v1_A_v2_A_v3*A_v1*A_v2*A_v3
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_46(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex A_v3 = load_complex(amplitude_2, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v2 * A_v3));  // harmonic_re_v3_A_v1_A_v2_A_v3
  }
}

/// columns[j][i] of the rows.
inline void columns_46(const BatchArrays& data, double* const* columns) {
  rows_46(data, FactorValues<factors_46<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_46(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic 2*omega1+omega3 of v3: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_47([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega1+omega3 of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega1 + omega3)*t) in v3 = harmonic_re_v3_A_v12_A_v3*A_v1^2*A_v3
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_47(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_2 = data.amplitude[2];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1], data.natural_frequency[2]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v3 = load_complex(amplitude_2, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v1 * A_v3));  // harmonic_re_v3_A_v12_A_v3
  }
}

/// columns[j][i] of the rows.
inline void columns_47(const BatchArrays& data, double* const* columns) {
  rows_47(data, FactorValues<factors_47<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_47(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_v1/dt + i*(w_v1 - omega1)*B_v1 = -mu1*A_v1 + i*conservative_v1_A_v1_A_v3_conjA_v3*A_v1*A_v3*conj(A_v3) +
/// i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) +
/// i*conservative_v1_A_v12_conjA_v1*A_v1^2*conj(A_v1) with A = B in that frame
/// dB_v2/dt + i*(w_v2 - omega2)*B_v2 = omega1/omega2*i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*conj(A_v1)*A_v2 -
/// mu2*A_v2 + i*conservative_v2_A_v2_A_v3_conjA_v3*A_v2*A_v3*conj(A_v3) +
/// i*conservative_v2_A_v22_conjA_v2*A_v2^2*conj(A_v2) with A = B in that frame
/// dB_v3/dt + i*(w_v3 - omega3)*B_v3 = omega1/omega3*i*conservative_v1_A_v1_A_v3_conjA_v3*A_v1*conj(A_v1)*A_v3 +
/// omega2/omega3*i*conservative_v2_A_v2_A_v3_conjA_v3*A_v2*conj(A_v2)*A_v3 - mu3*A_v3 +
/// i*conservative_v3_A_v32_conjA_v3*A_v3^2*conj(A_v3) with A = B in that frame
/// 39 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  [[maybe_unused]] const Scalar omega3 = parameters[2];
  Scalar lumps[39];
  evaluate_lumps(parameters, lumps);
  const Complex A_v1 = load_complex(amplitude, 0);
  const Scalar norm_A_v1 = norm_of(A_v1);
  const Complex A_v2 = load_complex(amplitude, 1);
  const Scalar norm_A_v2 = norm_of(A_v2);
  const Complex A_v3 = load_complex(amplitude, 2);
  const Scalar norm_A_v3 = norm_of(A_v3);
  store_complex(derivative, 0, lumps[0] * (-Scalar(1.0)) * (A_v1)
       + times_i(lumps[1] * (A_v1 * norm_A_v3))
       + times_i(lumps[2] * (A_v1 * norm_A_v2))
       + times_i(lumps[3] * (norm_A_v1 * A_v1)));
  store_complex(derivative, 1, times_i(lumps[2] * omega1 / omega2 * (norm_A_v1 * A_v2))
       + lumps[4] * (-Scalar(1.0)) * (A_v2)
       + times_i(lumps[5] * (A_v2 * norm_A_v3))
       + times_i(lumps[6] * (norm_A_v2 * A_v2)));
  store_complex(derivative, 2, times_i(lumps[1] * omega1 / omega3 * (norm_A_v1 * A_v3))
       + times_i(lumps[5] * omega2 / omega3 * (norm_A_v2 * A_v3))
       + lumps[7] * (-Scalar(1.0)) * (A_v3)
       + times_i(lumps[8] * (norm_A_v3 * A_v3)));
}

/// jacobian[i * 6 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 108 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  [[maybe_unused]] const Scalar omega3 = parameters[2];
  Scalar lumps[39];
  evaluate_lumps(parameters, lumps);
  const Complex A_v1 = load_complex(amplitude, 0);
  const Complex conj_A_v1 = conjugate(A_v1);
  const Scalar norm_A_v1 = norm_of(A_v1);
  const Complex A_v2 = load_complex(amplitude, 1);
  const Complex conj_A_v2 = conjugate(A_v2);
  const Scalar norm_A_v2 = norm_of(A_v2);
  const Complex A_v3 = load_complex(amplitude, 2);
  const Complex conj_A_v3 = conjugate(A_v3);
  const Scalar norm_A_v3 = norm_of(A_v3);
  for (std::size_t i = 0; i < 36; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = Complex(lumps[0] * (-Scalar(1.0)))
       + times_i(Complex(lumps[1] * (norm_A_v3)))
       + times_i(Complex(lumps[2] * (norm_A_v2)))
       + times_i(Complex(lumps[3] * Scalar(2) * (norm_A_v1)));
  const Complex conj_by_0_0 = times_i(lumps[3] * (A_v1 * A_v1));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[6] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[7] = by_0_0.real - conj_by_0_0.real;
  const Complex by_0_1 = times_i(lumps[2] * (A_v1 * conj_A_v2));
  const Complex conj_by_0_1 = times_i(lumps[2] * (A_v1 * A_v2));
  jacobian[2] = by_0_1.real + conj_by_0_1.real;
  jacobian[3] = conj_by_0_1.imag - by_0_1.imag;
  jacobian[8] = by_0_1.imag + conj_by_0_1.imag;
  jacobian[9] = by_0_1.real - conj_by_0_1.real;
  const Complex by_0_2 = times_i(lumps[1] * (A_v1 * conj_A_v3));
  const Complex conj_by_0_2 = times_i(lumps[1] * (A_v1 * A_v3));
  jacobian[4] = by_0_2.real + conj_by_0_2.real;
  jacobian[5] = conj_by_0_2.imag - by_0_2.imag;
  jacobian[10] = by_0_2.imag + conj_by_0_2.imag;
  jacobian[11] = by_0_2.real - conj_by_0_2.real;
  const Complex by_1_0 = times_i(lumps[2] * omega1 / omega2 * (conj_A_v1 * A_v2));
  const Complex conj_by_1_0 = times_i(lumps[2] * omega1 / omega2 * (A_v1 * A_v2));
  jacobian[12] = by_1_0.real + conj_by_1_0.real;
  jacobian[13] = conj_by_1_0.imag - by_1_0.imag;
  jacobian[18] = by_1_0.imag + conj_by_1_0.imag;
  jacobian[19] = by_1_0.real - conj_by_1_0.real;
  const Complex by_1_1 = times_i(Complex(lumps[2] * omega1 / omega2 * (norm_A_v1)))
       + Complex(lumps[4] * (-Scalar(1.0)))
       + times_i(Complex(lumps[5] * (norm_A_v3)))
       + times_i(Complex(lumps[6] * Scalar(2) * (norm_A_v2)));
  const Complex conj_by_1_1 = times_i(lumps[6] * (A_v2 * A_v2));
  jacobian[14] = by_1_1.real + conj_by_1_1.real;
  jacobian[15] = conj_by_1_1.imag - by_1_1.imag;
  jacobian[20] = by_1_1.imag + conj_by_1_1.imag;
  jacobian[21] = by_1_1.real - conj_by_1_1.real;
  const Complex by_1_2 = times_i(lumps[5] * (A_v2 * conj_A_v3));
  const Complex conj_by_1_2 = times_i(lumps[5] * (A_v2 * A_v3));
  jacobian[16] = by_1_2.real + conj_by_1_2.real;
  jacobian[17] = conj_by_1_2.imag - by_1_2.imag;
  jacobian[22] = by_1_2.imag + conj_by_1_2.imag;
  jacobian[23] = by_1_2.real - conj_by_1_2.real;
  const Complex by_2_0 = times_i(lumps[1] * omega1 / omega3 * (conj_A_v1 * A_v3));
  const Complex conj_by_2_0 = times_i(lumps[1] * omega1 / omega3 * (A_v1 * A_v3));
  jacobian[24] = by_2_0.real + conj_by_2_0.real;
  jacobian[25] = conj_by_2_0.imag - by_2_0.imag;
  jacobian[30] = by_2_0.imag + conj_by_2_0.imag;
  jacobian[31] = by_2_0.real - conj_by_2_0.real;
  const Complex by_2_1 = times_i(lumps[5] * omega2 / omega3 * (conj_A_v2 * A_v3));
  const Complex conj_by_2_1 = times_i(lumps[5] * omega2 / omega3 * (A_v2 * A_v3));
  jacobian[26] = by_2_1.real + conj_by_2_1.real;
  jacobian[27] = conj_by_2_1.imag - by_2_1.imag;
  jacobian[32] = by_2_1.imag + conj_by_2_1.imag;
  jacobian[33] = by_2_1.real - conj_by_2_1.real;
  const Complex by_2_2 = times_i(Complex(lumps[1] * omega1 / omega3 * (norm_A_v1)))
       + times_i(Complex(lumps[5] * omega2 / omega3 * (norm_A_v2)))
       + Complex(lumps[7] * (-Scalar(1.0)))
       + times_i(Complex(lumps[8] * Scalar(2) * (norm_A_v3)));
  const Complex conj_by_2_2 = times_i(lumps[8] * (A_v3 * A_v3));
  jacobian[28] = by_2_2.real + conj_by_2_2.real;
  jacobian[29] = conj_by_2_2.imag - by_2_2.imag;
  jacobian[34] = by_2_2.imag + conj_by_2_2.imag;
  jacobian[35] = by_2_2.real - conj_by_2_2.real;
}

}  // namespace free

}  // namespace secular::generated::three_modes
