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

namespace additive_combination {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: mu1 = mu1
/// lumps[1]: conservative_v1_A_v1_A_v2_conjA_v2 = (omega1^4*omega3^2*b1122 - 2*omega1^4*a113*a223 -
/// 2*omega1^2*omega2^2*omega3^2*b1122 + 4*omega1^2*omega2^2*a113*a223 - 2*omega1^2*omega3^4*b1122 +
/// 4*omega1^2*omega3^2*a113*a223 + omega1^2*omega3^2*a123^2 + omega2^4*omega3^2*b1122 - 2*omega2^4*a113*a223 -
/// 2*omega2^2*omega3^4*b1122 + 4*omega2^2*omega3^2*a113*a223 + omega2^2*omega3^2*a123^2 + omega3^6*b1122 -
/// 2*omega3^4*a113*a223 - omega3^4*a123^2)/(omega1^5*omega3^2 - 2*omega1^3*omega2^2*omega3^2 -
/// 2*omega1^3*omega3^4 + omega1*omega2^4*omega3^2 - 2*omega1*omega2^2*omega3^4 + omega1*omega3^6)
/// lumps[2]: conservative_v1_A_v12_conjA_v1 = (12*omega1^2*omega3^2*b1111 - 16*omega1^2*a113^2 -
/// 3*omega3^4*b1111 + 6*omega3^2*a113^2)/(8*omega1^3*omega3^2 - 2*omega1*omega3^4)
/// lumps[3]: conservative_v1_conjA_v2_F = (-omega1^2*e12 - 2*omega1*omega2*e12 - omega2^2*e12 + omega3^2*e12 -
/// a123*e3)/(4*omega1^3 + 8*omega1^2*omega2 + 4*omega1*omega2^2 - 4*omega1*omega3^2)
/// lumps[4]: mu2 = mu2
/// lumps[5]: conservative_v2_A_v22_conjA_v2 = (12*omega2^2*omega3^2*b2222 - 16*omega2^2*a223^2 -
/// 3*omega3^4*b2222 + 6*omega3^2*a223^2)/(8*omega2^3*omega3^2 - 2*omega2*omega3^4)
/// lumps[6]: e1 = e1
/// lumps[7]: harmonic_re_v1_A_v2_conjA_v12 = (9*omega1^2*a113*a123 - 2*omega1*omega2*a113*a123 +
/// omega2^2*a113*a123 - 3*omega3^2*a113*a123)/(12*omega1^6 - 40*omega1^5*omega2 + 48*omega1^4*omega2^2 -
/// 15*omega1^4*omega3^2 - 24*omega1^3*omega2^3 + 26*omega1^3*omega2*omega3^2 + 4*omega1^2*omega2^4 -
/// 16*omega1^2*omega2^2*omega3^2 + 3*omega1^2*omega3^4 + 6*omega1*omega2^3*omega3^2 - 4*omega1*omega2*omega3^4 -
/// omega2^4*omega3^2 + omega2^2*omega3^4)
/// lumps[8]: harmonic_re_v1_conjA_v1_F = a113*e3/(omega1^4 + 2*omega1^3*omega2 - omega1^2*omega3^2 -
/// 2*omega1*omega2^3 - omega2^4 + omega2^2*omega3^2)
/// lumps[9]: harmonic_re_v1_A_v22_conjA_v2 = (8*omega2^2*a123*a223 -
/// 3*omega3^2*a123*a223)/(4*omega1^2*omega2^2*omega3^2 - omega1^2*omega3^4 - 4*omega2^4*omega3^2 +
/// omega2^2*omega3^4)
/// lumps[10]: harmonic_re_v1_A_v22_conjA_v1 = (-4*omega1^2*omega2^2*b1122 + omega1^2*omega3^2*b1122 -
/// 2*omega1^2*a113*a223 + 8*omega1*omega2^3*b1122 - 2*omega1*omega2*omega3^2*b1122 + 4*omega1*omega2*a113*a223 -
/// 4*omega2^4*b1122 + 5*omega2^2*omega3^2*b1122 - 2*omega2^2*a113*a223 - 4*omega2^2*a123^2 - omega3^4*b1122 +
/// 2*omega3^2*a113*a223 + omega3^2*a123^2)/(16*omega1^3*omega2^3 - 4*omega1^3*omega2*omega3^2 -
/// 48*omega1^2*omega2^4 + 12*omega1^2*omega2^2*omega3^2 + 48*omega1*omega2^5 - 28*omega1*omega2^3*omega3^2 +
/// 4*omega1*omega2*omega3^4 - 16*omega2^6 + 20*omega2^4*omega3^2 - 4*omega2^2*omega3^4)
/// lumps[11]: harmonic_re_v1_A_v1_A_v22 = (4*omega1^2*omega2^2*b1122 - omega1^2*omega3^2*b1122 +
/// 2*omega1^2*a113*a223 + 8*omega1*omega2^3*b1122 - 2*omega1*omega2*omega3^2*b1122 + 4*omega1*omega2*a113*a223 +
/// 4*omega2^4*b1122 - 5*omega2^2*omega3^2*b1122 + 2*omega2^2*a113*a223 + 4*omega2^2*a123^2 + omega3^4*b1122 -
/// 2*omega3^2*a113*a223 - omega3^2*a123^2)/(16*omega1^3*omega2^3 - 4*omega1^3*omega2*omega3^2 +
/// 48*omega1^2*omega2^4 - 12*omega1^2*omega2^2*omega3^2 + 48*omega1*omega2^5 - 28*omega1*omega2^3*omega3^2 +
/// 4*omega1*omega2*omega3^4 + 16*omega2^6 - 20*omega2^4*omega3^2 + 4*omega2^2*omega3^4)
/// lumps[12]: harmonic_re_v1_A_v13 = (4*omega1^2*b1111 - omega3^2*b1111 + 2*a113^2)/(32*omega1^4 -
/// 8*omega1^2*omega3^2)
/// lumps[13]: e2 = e2
/// lumps[14]: harmonic_re_v2_A_v2_conjA_v12 = (4*omega1^4*b1122 - 8*omega1^3*omega2*b1122 +
/// 4*omega1^2*omega2^2*b1122 - 5*omega1^2*omega3^2*b1122 + 2*omega1^2*a113*a223 + 4*omega1^2*a123^2 +
/// 2*omega1*omega2*omega3^2*b1122 - 4*omega1*omega2*a113*a223 - omega2^2*omega3^2*b1122 + 2*omega2^2*a113*a223 +
/// omega3^4*b1122 - 2*omega3^2*a113*a223 - omega3^2*a123^2)/(16*omega1^6 - 48*omega1^5*omega2 +
/// 48*omega1^4*omega2^2 - 20*omega1^4*omega3^2 - 16*omega1^3*omega2^3 + 28*omega1^3*omega2*omega3^2 -
/// 12*omega1^2*omega2^2*omega3^2 + 4*omega1^2*omega3^4 + 4*omega1*omega2^3*omega3^2 - 4*omega1*omega2*omega3^4)
/// lumps[15]: harmonic_re_v2_conjA_v2_F = -a223*e3/(omega1^4 + 2*omega1^3*omega2 - omega1^2*omega3^2 -
/// 2*omega1*omega2^3 - omega2^4 + omega2^2*omega3^2)
/// lumps[16]: harmonic_re_v2_A_v23 = (4*omega2^2*b2222 - omega3^2*b2222 + 2*a223^2)/(32*omega2^4 -
/// 8*omega2^2*omega3^2)
/// lumps[17]: harmonic_re_v2_A_v12_A_v2 = (4*omega1^4*b1122 + 8*omega1^3*omega2*b1122 +
/// 4*omega1^2*omega2^2*b1122 - 5*omega1^2*omega3^2*b1122 + 2*omega1^2*a113*a223 + 4*omega1^2*a123^2 -
/// 2*omega1*omega2*omega3^2*b1122 + 4*omega1*omega2*a113*a223 - omega2^2*omega3^2*b1122 + 2*omega2^2*a113*a223 +
/// omega3^4*b1122 - 2*omega3^2*a113*a223 - omega3^2*a123^2)/(16*omega1^6 + 48*omega1^5*omega2 +
/// 48*omega1^4*omega2^2 - 20*omega1^4*omega3^2 + 16*omega1^3*omega2^3 - 28*omega1^3*omega2*omega3^2 -
/// 12*omega1^2*omega2^2*omega3^2 + 4*omega1^2*omega3^4 - 4*omega1*omega2^3*omega3^2 + 4*omega1*omega2*omega3^4)
/// lumps[18]: a123 = a123
/// lumps[19]: a223 = a223
/// lumps[20]: a113 = a113
/// lumps[21]: e3 = e3
/// lumps[22]: harmonic_re_v3_conjA_v1_F = (-2*omega1^2*a113*e1 - 4*omega1*omega2*a113*e1 -
/// 2*omega1*omega2*a123*e2 - omega2^2*a123*e2)/(4*omega1^3*omega2^3 - 4*omega1^3*omega2*omega3^2 +
/// 10*omega1^2*omega2^4 - 10*omega1^2*omega2^2*omega3^2 + 4*omega1*omega2^5 - 4*omega1*omega2^3*omega3^2)
/// lumps[23]: harmonic_re_v3_conjA_v2_F = (-omega1^2*a123*e1 - 2*omega1*omega2*a123*e1 - 4*omega1*omega2*a223*e2
/// - 2*omega2^2*a223*e2)/(4*omega1^5*omega2 + 10*omega1^4*omega2^2 + 4*omega1^3*omega2^3 -
/// 4*omega1^3*omega2*omega3^2 - 10*omega1^2*omega2^2*omega3^2 - 4*omega1*omega2^3*omega3^2)
/// 642 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar b1111 = parameters[7];
  const Scalar b1122 = parameters[8];
  const Scalar b2222 = parameters[9];
  const Scalar e12 = parameters[12];
  const Scalar mu1 = parameters[13];
  const Scalar e1 = parameters[14];
  const Scalar mu2 = parameters[15];
  const Scalar e2 = parameters[16];
  const Scalar e3 = parameters[18];
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
  const Scalar omega3_5 = omega3_4 * omega3;
  const Scalar omega3_6 = omega3_5 * omega3;
  const Scalar a113_2 = a113 * a113;
  const Scalar a123_2 = a123 * a123;
  const Scalar a223_2 = a223 * a223;
  lumps[0] = mu1;  // mu1
  // conservative_v1_A_v1_A_v2_conjA_v2
  lumps[1] = (omega1_4 * omega3_2 * b1122 - Scalar(2.0) * omega1_4 * a113 * a223
      - Scalar(2.0) * omega1_2 * omega2_2 * omega3_2 * b1122 + Scalar(4.0) * omega1_2 * omega2_2 * a113 * a223
      - Scalar(2.0) * omega1_2 * omega3_4 * b1122 + Scalar(4.0) * omega1_2 * omega3_2 * a113 * a223
      + omega1_2 * omega3_2 * a123_2 + omega2_4 * omega3_2 * b1122 - Scalar(2.0) * omega2_4 * a113 * a223
      - Scalar(2.0) * omega2_2 * omega3_4 * b1122 + Scalar(4.0) * omega2_2 * omega3_2 * a113 * a223
      + omega2_2 * omega3_2 * a123_2 + omega3_6 * b1122 - Scalar(2.0) * omega3_4 * a113 * a223
      - omega3_4 * a123_2) / (omega1_5 * omega3_2 - Scalar(2.0) * omega1_3 * omega2_2 * omega3_2
      - Scalar(2.0) * omega1_3 * omega3_4 + omega1 * omega2_4 * omega3_2
      - Scalar(2.0) * omega1 * omega2_2 * omega3_4 + omega1 * omega3_6);
  // conservative_v1_A_v12_conjA_v1
  lumps[2] = (Scalar(12.0) * omega1_2 * omega3_2 * b1111 - Scalar(16.0) * omega1_2 * a113_2
      - Scalar(3.0) * omega3_4 * b1111 + Scalar(6.0) * omega3_2 * a113_2) / (Scalar(8.0) * omega1_3 * omega3_2
      - Scalar(2.0) * omega1 * omega3_4);
  // conservative_v1_conjA_v2_F
  lumps[3] = (-omega1_2 * e12 - Scalar(2.0) * omega1 * omega2 * e12 - omega2_2 * e12 + omega3_2 * e12
      - a123 * e3) / (Scalar(4.0) * omega1_3 + Scalar(8.0) * omega1_2 * omega2 + Scalar(4.0) * omega1 * omega2_2
      - Scalar(4.0) * omega1 * omega3_2);
  lumps[4] = mu2;  // mu2
  // conservative_v2_A_v22_conjA_v2
  lumps[5] = (Scalar(12.0) * omega2_2 * omega3_2 * b2222 - Scalar(16.0) * omega2_2 * a223_2
      - Scalar(3.0) * omega3_4 * b2222 + Scalar(6.0) * omega3_2 * a223_2) / (Scalar(8.0) * omega2_3 * omega3_2
      - Scalar(2.0) * omega2 * omega3_4);
  lumps[6] = e1;  // e1
  // harmonic_re_v1_A_v2_conjA_v12
  lumps[7] = (Scalar(9.0) * omega1_2 * a113 * a123 - Scalar(2.0) * omega1 * omega2 * a113 * a123
      + omega2_2 * a113 * a123 - Scalar(3.0) * omega3_2 * a113 * a123) / (Scalar(12.0) * omega1_6
      - Scalar(40.0) * omega1_5 * omega2 + Scalar(48.0) * omega1_4 * omega2_2 - Scalar(15.0) * omega1_4 * omega3_2
      - Scalar(24.0) * omega1_3 * omega2_3 + Scalar(26.0) * omega1_3 * omega2 * omega3_2
      + Scalar(4.0) * omega1_2 * omega2_4 - Scalar(16.0) * omega1_2 * omega2_2 * omega3_2
      + Scalar(3.0) * omega1_2 * omega3_4 + Scalar(6.0) * omega1 * omega2_3 * omega3_2
      - Scalar(4.0) * omega1 * omega2 * omega3_4 - omega2_4 * omega3_2 + omega2_2 * omega3_4);
  // harmonic_re_v1_conjA_v1_F
  lumps[8] = a113 * e3 / (omega1_4 + Scalar(2.0) * omega1_3 * omega2 - omega1_2 * omega3_2
      - Scalar(2.0) * omega1 * omega2_3 - omega2_4 + omega2_2 * omega3_2);
  // harmonic_re_v1_A_v22_conjA_v2
  lumps[9] = (Scalar(8.0) * omega2_2 * a123 * a223
      - Scalar(3.0) * omega3_2 * a123 * a223) / (Scalar(4.0) * omega1_2 * omega2_2 * omega3_2
      - omega1_2 * omega3_4 - Scalar(4.0) * omega2_4 * omega3_2 + omega2_2 * omega3_4);
  // harmonic_re_v1_A_v22_conjA_v1
  lumps[10] = (-Scalar(4.0) * omega1_2 * omega2_2 * b1122 + omega1_2 * omega3_2 * b1122
      - Scalar(2.0) * omega1_2 * a113 * a223 + Scalar(8.0) * omega1 * omega2_3 * b1122
      - Scalar(2.0) * omega1 * omega2 * omega3_2 * b1122 + Scalar(4.0) * omega1 * omega2 * a113 * a223
      - Scalar(4.0) * omega2_4 * b1122 + Scalar(5.0) * omega2_2 * omega3_2 * b1122
      - Scalar(2.0) * omega2_2 * a113 * a223 - Scalar(4.0) * omega2_2 * a123_2 - omega3_4 * b1122
      + Scalar(2.0) * omega3_2 * a113 * a223 + omega3_2 * a123_2) / (Scalar(16.0) * omega1_3 * omega2_3
      - Scalar(4.0) * omega1_3 * omega2 * omega3_2 - Scalar(48.0) * omega1_2 * omega2_4
      + Scalar(12.0) * omega1_2 * omega2_2 * omega3_2 + Scalar(48.0) * omega1 * omega2_5
      - Scalar(28.0) * omega1 * omega2_3 * omega3_2 + Scalar(4.0) * omega1 * omega2 * omega3_4
      - Scalar(16.0) * omega2_6 + Scalar(20.0) * omega2_4 * omega3_2 - Scalar(4.0) * omega2_2 * omega3_4);
  // harmonic_re_v1_A_v1_A_v22
  lumps[11] = (Scalar(4.0) * omega1_2 * omega2_2 * b1122 - omega1_2 * omega3_2 * b1122
      + Scalar(2.0) * omega1_2 * a113 * a223 + Scalar(8.0) * omega1 * omega2_3 * b1122
      - Scalar(2.0) * omega1 * omega2 * omega3_2 * b1122 + Scalar(4.0) * omega1 * omega2 * a113 * a223
      + Scalar(4.0) * omega2_4 * b1122 - Scalar(5.0) * omega2_2 * omega3_2 * b1122
      + Scalar(2.0) * omega2_2 * a113 * a223 + Scalar(4.0) * omega2_2 * a123_2 + omega3_4 * b1122
      - Scalar(2.0) * omega3_2 * a113 * a223 - omega3_2 * a123_2) / (Scalar(16.0) * omega1_3 * omega2_3
      - Scalar(4.0) * omega1_3 * omega2 * omega3_2 + Scalar(48.0) * omega1_2 * omega2_4
      - Scalar(12.0) * omega1_2 * omega2_2 * omega3_2 + Scalar(48.0) * omega1 * omega2_5
      - Scalar(28.0) * omega1 * omega2_3 * omega3_2 + Scalar(4.0) * omega1 * omega2 * omega3_4
      + Scalar(16.0) * omega2_6 - Scalar(20.0) * omega2_4 * omega3_2 + Scalar(4.0) * omega2_2 * omega3_4);
  // harmonic_re_v1_A_v13
  lumps[12] = (Scalar(4.0) * omega1_2 * b1111 - omega3_2 * b1111
      + Scalar(2.0) * a113_2) / (Scalar(32.0) * omega1_4 - Scalar(8.0) * omega1_2 * omega3_2);
  lumps[13] = e2;  // e2
  // harmonic_re_v2_A_v2_conjA_v12
  lumps[14] = (Scalar(4.0) * omega1_4 * b1122 - Scalar(8.0) * omega1_3 * omega2 * b1122
      + Scalar(4.0) * omega1_2 * omega2_2 * b1122 - Scalar(5.0) * omega1_2 * omega3_2 * b1122
      + Scalar(2.0) * omega1_2 * a113 * a223 + Scalar(4.0) * omega1_2 * a123_2
      + Scalar(2.0) * omega1 * omega2 * omega3_2 * b1122 - Scalar(4.0) * omega1 * omega2 * a113 * a223
      - omega2_2 * omega3_2 * b1122 + Scalar(2.0) * omega2_2 * a113 * a223 + omega3_4 * b1122
      - Scalar(2.0) * omega3_2 * a113 * a223 - omega3_2 * a123_2) / (Scalar(16.0) * omega1_6
      - Scalar(48.0) * omega1_5 * omega2 + Scalar(48.0) * omega1_4 * omega2_2 - Scalar(20.0) * omega1_4 * omega3_2
      - Scalar(16.0) * omega1_3 * omega2_3 + Scalar(28.0) * omega1_3 * omega2 * omega3_2
      - Scalar(12.0) * omega1_2 * omega2_2 * omega3_2 + Scalar(4.0) * omega1_2 * omega3_4
      + Scalar(4.0) * omega1 * omega2_3 * omega3_2 - Scalar(4.0) * omega1 * omega2 * omega3_4);
  // harmonic_re_v2_conjA_v2_F
  lumps[15] = -a223 * e3 / (omega1_4 + Scalar(2.0) * omega1_3 * omega2 - omega1_2 * omega3_2
      - Scalar(2.0) * omega1 * omega2_3 - omega2_4 + omega2_2 * omega3_2);
  // harmonic_re_v2_A_v23
  lumps[16] = (Scalar(4.0) * omega2_2 * b2222 - omega3_2 * b2222
      + Scalar(2.0) * a223_2) / (Scalar(32.0) * omega2_4 - Scalar(8.0) * omega2_2 * omega3_2);
  // harmonic_re_v2_A_v12_A_v2
  lumps[17] = (Scalar(4.0) * omega1_4 * b1122 + Scalar(8.0) * omega1_3 * omega2 * b1122
      + Scalar(4.0) * omega1_2 * omega2_2 * b1122 - Scalar(5.0) * omega1_2 * omega3_2 * b1122
      + Scalar(2.0) * omega1_2 * a113 * a223 + Scalar(4.0) * omega1_2 * a123_2
      - Scalar(2.0) * omega1 * omega2 * omega3_2 * b1122 + Scalar(4.0) * omega1 * omega2 * a113 * a223
      - omega2_2 * omega3_2 * b1122 + Scalar(2.0) * omega2_2 * a113 * a223 + omega3_4 * b1122
      - Scalar(2.0) * omega3_2 * a113 * a223 - omega3_2 * a123_2) / (Scalar(16.0) * omega1_6
      + Scalar(48.0) * omega1_5 * omega2 + Scalar(48.0) * omega1_4 * omega2_2 - Scalar(20.0) * omega1_4 * omega3_2
      + Scalar(16.0) * omega1_3 * omega2_3 - Scalar(28.0) * omega1_3 * omega2 * omega3_2
      - Scalar(12.0) * omega1_2 * omega2_2 * omega3_2 + Scalar(4.0) * omega1_2 * omega3_4
      - Scalar(4.0) * omega1 * omega2_3 * omega3_2 + Scalar(4.0) * omega1 * omega2 * omega3_4);
  lumps[18] = a123;  // a123
  lumps[19] = a223;  // a223
  lumps[20] = a113;  // a113
  lumps[21] = e3;  // e3
  // harmonic_re_v3_conjA_v1_F
  lumps[22] = (-Scalar(2.0) * omega1_2 * a113 * e1 - Scalar(4.0) * omega1 * omega2 * a113 * e1
      - Scalar(2.0) * omega1 * omega2 * a123 * e2 - omega2_2 * a123 * e2) / (Scalar(4.0) * omega1_3 * omega2_3
      - Scalar(4.0) * omega1_3 * omega2 * omega3_2 + Scalar(10.0) * omega1_2 * omega2_4
      - Scalar(10.0) * omega1_2 * omega2_2 * omega3_2 + Scalar(4.0) * omega1 * omega2_5
      - Scalar(4.0) * omega1 * omega2_3 * omega3_2);
  // harmonic_re_v3_conjA_v2_F
  lumps[23] = (-omega1_2 * a123 * e1 - Scalar(2.0) * omega1 * omega2 * a123 * e1
      - Scalar(4.0) * omega1 * omega2 * a223 * e2
      - Scalar(2.0) * omega2_2 * a223 * e2) / (Scalar(4.0) * omega1_5 * omega2
      + Scalar(10.0) * omega1_4 * omega2_2 + Scalar(4.0) * omega1_3 * omega2_3
      - Scalar(4.0) * omega1_3 * omega2 * omega3_2 - Scalar(10.0) * omega1_2 * omega2_2 * omega3_2
      - Scalar(4.0) * omega1 * omega2_3 * omega3_2);
}

/// gradient[p] = d conservative_v1_A_v1_A_v2_conjA_v2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump
/// N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 155 operations.
template <class Scalar>
void lump_gradient_1(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar b1122 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar omega3_5 = omega3_4 * omega3;
  const Scalar omega3_6 = omega3_5 * omega3;
  const Scalar a123_2 = a123 * a123;
  const Scalar denominator = omega1_5 * omega3_2 - Scalar(2.0) * omega1_3 * omega2_2 * omega3_2
      - Scalar(2.0) * omega1_3 * omega3_4 + omega1 * omega2_4 * omega3_2
      - Scalar(2.0) * omega1 * omega2_2 * omega3_4 + omega1 * omega3_6;
  // multiplies a113*a223
  const Scalar c_0 = -Scalar(2.0) * omega1_4 + Scalar(4.0) * omega1_2 * omega2_2
      + Scalar(4.0) * omega1_2 * omega3_2 - Scalar(2.0) * omega2_4 + Scalar(4.0) * omega2_2 * omega3_2
      - Scalar(2.0) * omega3_4;
  const Scalar c_1 = omega1_2 * omega3_2 + omega2_2 * omega3_2 - omega3_4;  // multiplies a123^2
  // multiplies b1122
  const Scalar c_2 = omega1_4 * omega3_2 - Scalar(2.0) * omega1_2 * omega2_2 * omega3_2
      - Scalar(2.0) * omega1_2 * omega3_4 + omega2_4 * omega3_2 - Scalar(2.0) * omega2_2 * omega3_4 + omega3_6;
  const Scalar w_0 = b1122;  // multiplies omega1^4*omega3^2
  const Scalar w_1 = -Scalar(2.0) * a113 * a223;  // multiplies omega1^4
  const Scalar w_2 = -Scalar(2.0) * b1122;  // multiplies omega1^2*omega2^2*omega3^2
  const Scalar w_3 = Scalar(4.0) * a113 * a223;  // multiplies omega1^2*omega2^2
  const Scalar w_4 = -Scalar(2.0) * b1122;  // multiplies omega1^2*omega3^4
  const Scalar w_5 = Scalar(4.0) * a113 * a223 + a123_2;  // multiplies omega1^2*omega3^2
  const Scalar w_6 = b1122;  // multiplies omega2^4*omega3^2
  const Scalar w_7 = -Scalar(2.0) * a113 * a223;  // multiplies omega2^4
  const Scalar w_8 = -Scalar(2.0) * b1122;  // multiplies omega2^2*omega3^4
  const Scalar w_9 = Scalar(4.0) * a113 * a223 + a123_2;  // multiplies omega2^2*omega3^2
  const Scalar w_10 = b1122;  // multiplies omega3^6
  const Scalar w_11 = -Scalar(2.0) * a113 * a223 - a123_2;  // multiplies omega3^4
  // by omega1
  gradient[0] = (Scalar(4.0) * omega1_3 * omega3_2 * w_0 + Scalar(4.0) * omega1_3 * w_1
      + Scalar(2.0) * omega1 * omega2_2 * omega3_2 * w_2 + Scalar(2.0) * omega1 * omega2_2 * w_3
      + Scalar(2.0) * omega1 * omega3_4 * w_4 + Scalar(2.0) * omega1 * omega3_2 * w_5
      - lump * (Scalar(5.0) * omega1_4 * omega3_2 - Scalar(6.0) * omega1_2 * omega2_2 * omega3_2
      - Scalar(6.0) * omega1_2 * omega3_4 + omega2_4 * omega3_2 - Scalar(2.0) * omega2_2 * omega3_4
      + omega3_6)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_2 * omega2 * omega3_2 * w_2 + Scalar(2.0) * omega1_2 * omega2 * w_3
      + Scalar(4.0) * omega2_3 * omega3_2 * w_6 + Scalar(4.0) * omega2_3 * w_7
      + Scalar(2.0) * omega2 * omega3_4 * w_8 + Scalar(2.0) * omega2 * omega3_2 * w_9
      - lump * (-Scalar(4.0) * omega1_3 * omega2 * omega3_2 + Scalar(4.0) * omega1 * omega2_3 * omega3_2
      - Scalar(4.0) * omega1 * omega2 * omega3_4)) / denominator;
  // by omega3
  gradient[2] = (Scalar(2.0) * omega1_4 * omega3 * w_0 + Scalar(2.0) * omega1_2 * omega2_2 * omega3 * w_2
      + Scalar(4.0) * omega1_2 * omega3_3 * w_4 + Scalar(2.0) * omega1_2 * omega3 * w_5
      + Scalar(2.0) * omega2_4 * omega3 * w_6 + Scalar(4.0) * omega2_2 * omega3_3 * w_8
      + Scalar(2.0) * omega2_2 * omega3 * w_9 + Scalar(6.0) * omega3_5 * w_10 + Scalar(4.0) * omega3_3 * w_11
      - lump * (Scalar(2.0) * omega1_5 * omega3 - Scalar(4.0) * omega1_3 * omega2_2 * omega3
      - Scalar(8.0) * omega1_3 * omega3_3 + Scalar(2.0) * omega1 * omega2_4 * omega3
      - Scalar(8.0) * omega1 * omega2_2 * omega3_3 + Scalar(6.0) * omega1 * omega3_5)) / denominator;
  gradient[3] = (a223 * c_0) / denominator;  // by a113
  gradient[4] = (Scalar(2.0) * a123 * c_1) / denominator;  // by a123
  gradient[5] = (a113 * c_0) / denominator;  // by a223
  gradient[8] = (c_2) / denominator;  // by b1122
}

/// gradient[p] = d conservative_v1_A_v12_conjA_v1 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 38 operations.
template <class Scalar>
void lump_gradient_2(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar b1111 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar a113_2 = a113 * a113;
  const Scalar denominator = Scalar(8.0) * omega1_3 * omega3_2 - Scalar(2.0) * omega1 * omega3_4;
  // by omega1
  gradient[0] = (Scalar(24.0) * omega1 * omega3_2 * b1111 - Scalar(32.0) * omega1 * a113_2
      - lump * (Scalar(24.0) * omega1_2 * omega3_2 - Scalar(2.0) * omega3_4)) / denominator;
  // by omega3
  gradient[2] = (Scalar(24.0) * omega1_2 * omega3 * b1111 - Scalar(12.0) * omega3_3 * b1111
      + Scalar(12.0) * omega3 * a113_2 - lump * (Scalar(16.0) * omega1_3 * omega3
      - Scalar(8.0) * omega1 * omega3_3)) / denominator;
  gradient[3] = (-Scalar(32.0) * omega1_2 * a113 + Scalar(12.0) * omega3_2 * a113) / denominator;  // by a113
  gradient[7] = (Scalar(12.0) * omega1_2 * omega3_2 - Scalar(3.0) * omega3_4) / denominator;  // by b1111
}

/// gradient[p] = d conservative_v1_conjA_v2_F / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 41 operations.
template <class Scalar>
void lump_gradient_3(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a123 = parameters[4];
  const Scalar e12 = parameters[12];
  const Scalar e3 = parameters[18];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar denominator = Scalar(4.0) * omega1_3 + Scalar(8.0) * omega1_2 * omega2
      + Scalar(4.0) * omega1 * omega2_2 - Scalar(4.0) * omega1 * omega3_2;
  // by omega1
  gradient[0] = (-Scalar(2.0) * omega1 * e12 - Scalar(2.0) * omega2 * e12 - lump * (Scalar(12.0) * omega1_2
      + Scalar(16.0) * omega1 * omega2 + Scalar(4.0) * omega2_2 - Scalar(4.0) * omega3_2)) / denominator;
  // by omega2
  gradient[1] = (-Scalar(2.0) * omega1 * e12 - Scalar(2.0) * omega2 * e12 - lump * (Scalar(8.0) * omega1_2
      + Scalar(8.0) * omega1 * omega2)) / denominator;
  // by omega3
  gradient[2] = (Scalar(2.0) * omega3 * e12 - lump * (-Scalar(8.0) * omega1 * omega3)) / denominator;
  gradient[4] = (-e3) / denominator;  // by a123
  gradient[12] = (-omega1_2 - Scalar(2.0) * omega1 * omega2 - omega2_2 + omega3_2) / denominator;  // by e12
  gradient[18] = (-a123) / denominator;  // by e3
}

/// gradient[p] = d conservative_v2_A_v22_conjA_v2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 38 operations.
template <class Scalar>
void lump_gradient_5(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a223 = parameters[5];
  const Scalar b2222 = parameters[9];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar a223_2 = a223 * a223;
  const Scalar denominator = Scalar(8.0) * omega2_3 * omega3_2 - Scalar(2.0) * omega2 * omega3_4;
  // by omega2
  gradient[1] = (Scalar(24.0) * omega2 * omega3_2 * b2222 - Scalar(32.0) * omega2 * a223_2
      - lump * (Scalar(24.0) * omega2_2 * omega3_2 - Scalar(2.0) * omega3_4)) / denominator;
  // by omega3
  gradient[2] = (Scalar(24.0) * omega2_2 * omega3 * b2222 - Scalar(12.0) * omega3_3 * b2222
      + Scalar(12.0) * omega3 * a223_2 - lump * (Scalar(16.0) * omega2_3 * omega3
      - Scalar(8.0) * omega2 * omega3_3)) / denominator;
  gradient[5] = (-Scalar(32.0) * omega2_2 * a223 + Scalar(12.0) * omega3_2 * a223) / denominator;  // by a223
  gradient[9] = (Scalar(12.0) * omega2_2 * omega3_2 - Scalar(3.0) * omega3_4) / denominator;  // by b2222
}

/// gradient[p] = d harmonic_re_v1_A_v2_conjA_v12 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 168 operations.
template <class Scalar>
void lump_gradient_7(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega1_6 = omega1_5 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar denominator = Scalar(12.0) * omega1_6 - Scalar(40.0) * omega1_5 * omega2
      + Scalar(48.0) * omega1_4 * omega2_2 - Scalar(15.0) * omega1_4 * omega3_2
      - Scalar(24.0) * omega1_3 * omega2_3 + Scalar(26.0) * omega1_3 * omega2 * omega3_2
      + Scalar(4.0) * omega1_2 * omega2_4 - Scalar(16.0) * omega1_2 * omega2_2 * omega3_2
      + Scalar(3.0) * omega1_2 * omega3_4 + Scalar(6.0) * omega1 * omega2_3 * omega3_2
      - Scalar(4.0) * omega1 * omega2 * omega3_4 - omega2_4 * omega3_2 + omega2_2 * omega3_4;
  // by omega1
  gradient[0] = (Scalar(18.0) * omega1 * a113 * a123 - Scalar(2.0) * omega2 * a113 * a123
      - lump * (Scalar(72.0) * omega1_5 - Scalar(200.0) * omega1_4 * omega2 + Scalar(192.0) * omega1_3 * omega2_2
      - Scalar(60.0) * omega1_3 * omega3_2 - Scalar(72.0) * omega1_2 * omega2_3
      + Scalar(78.0) * omega1_2 * omega2 * omega3_2 + Scalar(8.0) * omega1 * omega2_4
      - Scalar(32.0) * omega1 * omega2_2 * omega3_2 + Scalar(6.0) * omega1 * omega3_4
      + Scalar(6.0) * omega2_3 * omega3_2 - Scalar(4.0) * omega2 * omega3_4)) / denominator;
  // by omega2
  gradient[1] = (-Scalar(2.0) * omega1 * a113 * a123 + Scalar(2.0) * omega2 * a113 * a123
      - lump * (-Scalar(40.0) * omega1_5 + Scalar(96.0) * omega1_4 * omega2 - Scalar(72.0) * omega1_3 * omega2_2
      + Scalar(26.0) * omega1_3 * omega3_2 + Scalar(16.0) * omega1_2 * omega2_3
      - Scalar(32.0) * omega1_2 * omega2 * omega3_2 + Scalar(18.0) * omega1 * omega2_2 * omega3_2
      - Scalar(4.0) * omega1 * omega3_4 - Scalar(4.0) * omega2_3 * omega3_2
      + Scalar(2.0) * omega2 * omega3_4)) / denominator;
  // by omega3
  gradient[2] = (-Scalar(6.0) * omega3 * a113 * a123 - lump * (-Scalar(30.0) * omega1_4 * omega3
      + Scalar(52.0) * omega1_3 * omega2 * omega3 - Scalar(32.0) * omega1_2 * omega2_2 * omega3
      + Scalar(12.0) * omega1_2 * omega3_3 + Scalar(12.0) * omega1 * omega2_3 * omega3
      - Scalar(16.0) * omega1 * omega2 * omega3_3 - Scalar(2.0) * omega2_4 * omega3
      + Scalar(4.0) * omega2_2 * omega3_3)) / denominator;
  // by a113
  gradient[3] = (Scalar(9.0) * omega1_2 * a123 - Scalar(2.0) * omega1 * omega2 * a123 + omega2_2 * a123
      - Scalar(3.0) * omega3_2 * a123) / denominator;
  // by a123
  gradient[4] = (Scalar(9.0) * omega1_2 * a113 - Scalar(2.0) * omega1 * omega2 * a113 + omega2_2 * a113
      - Scalar(3.0) * omega3_2 * a113) / denominator;
}

/// gradient[p] = d harmonic_re_v1_conjA_v1_F / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 34 operations.
template <class Scalar>
void lump_gradient_8(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar e3 = parameters[18];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar denominator = omega1_4 + Scalar(2.0) * omega1_3 * omega2 - omega1_2 * omega3_2
      - Scalar(2.0) * omega1 * omega2_3 - omega2_4 + omega2_2 * omega3_2;
  // by omega1
  gradient[0] = (-lump * (Scalar(4.0) * omega1_3 + Scalar(6.0) * omega1_2 * omega2
      - Scalar(2.0) * omega1 * omega3_2 - Scalar(2.0) * omega2_3)) / denominator;
  // by omega2
  gradient[1] = (-lump * (Scalar(2.0) * omega1_3 - Scalar(6.0) * omega1 * omega2_2 - Scalar(4.0) * omega2_3
      + Scalar(2.0) * omega2 * omega3_2)) / denominator;
  // by omega3
  gradient[2] = (-lump * (-Scalar(2.0) * omega1_2 * omega3 + Scalar(2.0) * omega2_2 * omega3)) / denominator;
  gradient[3] = (e3) / denominator;  // by a113
  gradient[18] = (a113) / denominator;  // by e3
}

/// gradient[p] = d harmonic_re_v1_A_v22_conjA_v2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 53 operations.
template <class Scalar>
void lump_gradient_9(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar denominator = Scalar(4.0) * omega1_2 * omega2_2 * omega3_2 - omega1_2 * omega3_4
      - Scalar(4.0) * omega2_4 * omega3_2 + omega2_2 * omega3_4;
  // by omega1
  gradient[0] = (-lump * (Scalar(8.0) * omega1 * omega2_2 * omega3_2
      - Scalar(2.0) * omega1 * omega3_4)) / denominator;
  // by omega2
  gradient[1] = (Scalar(16.0) * omega2 * a123 * a223 - lump * (Scalar(8.0) * omega1_2 * omega2 * omega3_2
      - Scalar(16.0) * omega2_3 * omega3_2 + Scalar(2.0) * omega2 * omega3_4)) / denominator;
  // by omega3
  gradient[2] = (-Scalar(6.0) * omega3 * a123 * a223 - lump * (Scalar(8.0) * omega1_2 * omega2_2 * omega3
      - Scalar(4.0) * omega1_2 * omega3_3 - Scalar(8.0) * omega2_4 * omega3
      + Scalar(4.0) * omega2_2 * omega3_3)) / denominator;
  gradient[4] = (Scalar(8.0) * omega2_2 * a223 - Scalar(3.0) * omega3_2 * a223) / denominator;  // by a123
  gradient[5] = (Scalar(8.0) * omega2_2 * a123 - Scalar(3.0) * omega3_2 * a123) / denominator;  // by a223
}

/// gradient[p] = d harmonic_re_v1_A_v22_conjA_v1 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 172 operations.
template <class Scalar>
void lump_gradient_10(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar b1122 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar a123_2 = a123 * a123;
  const Scalar denominator = Scalar(16.0) * omega1_3 * omega2_3 - Scalar(4.0) * omega1_3 * omega2 * omega3_2
      - Scalar(48.0) * omega1_2 * omega2_4 + Scalar(12.0) * omega1_2 * omega2_2 * omega3_2
      + Scalar(48.0) * omega1 * omega2_5 - Scalar(28.0) * omega1 * omega2_3 * omega3_2
      + Scalar(4.0) * omega1 * omega2 * omega3_4 - Scalar(16.0) * omega2_6 + Scalar(20.0) * omega2_4 * omega3_2
      - Scalar(4.0) * omega2_2 * omega3_4;
  // multiplies a113*a223
  const Scalar c_0 = -Scalar(2.0) * omega1_2 + Scalar(4.0) * omega1 * omega2 - Scalar(2.0) * omega2_2
      + Scalar(2.0) * omega3_2;
  const Scalar c_1 = -Scalar(4.0) * omega2_2 + omega3_2;  // multiplies a123^2
  // multiplies b1122
  const Scalar c_2 = -Scalar(4.0) * omega1_2 * omega2_2 + omega1_2 * omega3_2 + Scalar(8.0) * omega1 * omega2_3
      - Scalar(2.0) * omega1 * omega2 * omega3_2 - Scalar(4.0) * omega2_4 + Scalar(5.0) * omega2_2 * omega3_2
      - omega3_4;
  const Scalar w_0 = -Scalar(4.0) * b1122;  // multiplies omega1^2*omega2^2
  const Scalar w_1 = b1122;  // multiplies omega1^2*omega3^2
  const Scalar w_2 = -Scalar(2.0) * a113 * a223;  // multiplies omega1^2
  const Scalar w_3 = Scalar(8.0) * b1122;  // multiplies omega1*omega2^3
  const Scalar w_4 = -Scalar(2.0) * b1122;  // multiplies omega1*omega2*omega3^2
  const Scalar w_5 = Scalar(4.0) * a113 * a223;  // multiplies omega1*omega2
  const Scalar w_6 = -Scalar(4.0) * b1122;  // multiplies omega2^4
  const Scalar w_7 = Scalar(5.0) * b1122;  // multiplies omega2^2*omega3^2
  const Scalar w_8 = -Scalar(2.0) * a113 * a223 - Scalar(4.0) * a123_2;  // multiplies omega2^2
  const Scalar w_9 = -b1122;  // multiplies omega3^4
  const Scalar w_10 = Scalar(2.0) * a113 * a223 + a123_2;  // multiplies omega3^2
  // by omega1
  gradient[0] = (Scalar(2.0) * omega1 * omega2_2 * w_0 + Scalar(2.0) * omega1 * omega3_2 * w_1
      + Scalar(2.0) * omega1 * w_2 + omega2_3 * w_3 + omega2 * omega3_2 * w_4 + omega2 * w_5
      - lump * (Scalar(48.0) * omega1_2 * omega2_3 - Scalar(12.0) * omega1_2 * omega2 * omega3_2
      - Scalar(96.0) * omega1 * omega2_4 + Scalar(24.0) * omega1 * omega2_2 * omega3_2 + Scalar(48.0) * omega2_5
      - Scalar(28.0) * omega2_3 * omega3_2 + Scalar(4.0) * omega2 * omega3_4)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_2 * omega2 * w_0 + Scalar(3.0) * omega1 * omega2_2 * w_3
      + omega1 * omega3_2 * w_4 + omega1 * w_5 + Scalar(4.0) * omega2_3 * w_6
      + Scalar(2.0) * omega2 * omega3_2 * w_7 + Scalar(2.0) * omega2 * w_8
      - lump * (Scalar(48.0) * omega1_3 * omega2_2 - Scalar(4.0) * omega1_3 * omega3_2
      - Scalar(192.0) * omega1_2 * omega2_3 + Scalar(24.0) * omega1_2 * omega2 * omega3_2
      + Scalar(240.0) * omega1 * omega2_4 - Scalar(84.0) * omega1 * omega2_2 * omega3_2
      + Scalar(4.0) * omega1 * omega3_4 - Scalar(96.0) * omega2_5 + Scalar(80.0) * omega2_3 * omega3_2
      - Scalar(8.0) * omega2 * omega3_4)) / denominator;
  // by omega3
  gradient[2] = (Scalar(2.0) * omega1_2 * omega3 * w_1 + Scalar(2.0) * omega1 * omega2 * omega3 * w_4
      + Scalar(2.0) * omega2_2 * omega3 * w_7 + Scalar(4.0) * omega3_3 * w_9 + Scalar(2.0) * omega3 * w_10
      - lump * (-Scalar(8.0) * omega1_3 * omega2 * omega3 + Scalar(24.0) * omega1_2 * omega2_2 * omega3
      - Scalar(56.0) * omega1 * omega2_3 * omega3 + Scalar(16.0) * omega1 * omega2 * omega3_3
      + Scalar(40.0) * omega2_4 * omega3 - Scalar(16.0) * omega2_2 * omega3_3)) / denominator;
  gradient[3] = (a223 * c_0) / denominator;  // by a113
  gradient[4] = (Scalar(2.0) * a123 * c_1) / denominator;  // by a123
  gradient[5] = (a113 * c_0) / denominator;  // by a223
  gradient[8] = (c_2) / denominator;  // by b1122
}

/// gradient[p] = d harmonic_re_v1_A_v1_A_v22 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 172 operations.
template <class Scalar>
void lump_gradient_11(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar b1122 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar a123_2 = a123 * a123;
  const Scalar denominator = Scalar(16.0) * omega1_3 * omega2_3 - Scalar(4.0) * omega1_3 * omega2 * omega3_2
      + Scalar(48.0) * omega1_2 * omega2_4 - Scalar(12.0) * omega1_2 * omega2_2 * omega3_2
      + Scalar(48.0) * omega1 * omega2_5 - Scalar(28.0) * omega1 * omega2_3 * omega3_2
      + Scalar(4.0) * omega1 * omega2 * omega3_4 + Scalar(16.0) * omega2_6 - Scalar(20.0) * omega2_4 * omega3_2
      + Scalar(4.0) * omega2_2 * omega3_4;
  // multiplies a113*a223
  const Scalar c_0 = Scalar(2.0) * omega1_2 + Scalar(4.0) * omega1 * omega2 + Scalar(2.0) * omega2_2
      - Scalar(2.0) * omega3_2;
  const Scalar c_1 = Scalar(4.0) * omega2_2 - omega3_2;  // multiplies a123^2
  // multiplies b1122
  const Scalar c_2 = Scalar(4.0) * omega1_2 * omega2_2 - omega1_2 * omega3_2 + Scalar(8.0) * omega1 * omega2_3
      - Scalar(2.0) * omega1 * omega2 * omega3_2 + Scalar(4.0) * omega2_4 - Scalar(5.0) * omega2_2 * omega3_2
      + omega3_4;
  const Scalar w_0 = Scalar(4.0) * b1122;  // multiplies omega1^2*omega2^2
  const Scalar w_1 = -b1122;  // multiplies omega1^2*omega3^2
  const Scalar w_2 = Scalar(2.0) * a113 * a223;  // multiplies omega1^2
  const Scalar w_3 = Scalar(8.0) * b1122;  // multiplies omega1*omega2^3
  const Scalar w_4 = -Scalar(2.0) * b1122;  // multiplies omega1*omega2*omega3^2
  const Scalar w_5 = Scalar(4.0) * a113 * a223;  // multiplies omega1*omega2
  const Scalar w_6 = Scalar(4.0) * b1122;  // multiplies omega2^4
  const Scalar w_7 = -Scalar(5.0) * b1122;  // multiplies omega2^2*omega3^2
  const Scalar w_8 = Scalar(2.0) * a113 * a223 + Scalar(4.0) * a123_2;  // multiplies omega2^2
  const Scalar w_9 = b1122;  // multiplies omega3^4
  const Scalar w_10 = -Scalar(2.0) * a113 * a223 - a123_2;  // multiplies omega3^2
  // by omega1
  gradient[0] = (Scalar(2.0) * omega1 * omega2_2 * w_0 + Scalar(2.0) * omega1 * omega3_2 * w_1
      + Scalar(2.0) * omega1 * w_2 + omega2_3 * w_3 + omega2 * omega3_2 * w_4 + omega2 * w_5
      - lump * (Scalar(48.0) * omega1_2 * omega2_3 - Scalar(12.0) * omega1_2 * omega2 * omega3_2
      + Scalar(96.0) * omega1 * omega2_4 - Scalar(24.0) * omega1 * omega2_2 * omega3_2 + Scalar(48.0) * omega2_5
      - Scalar(28.0) * omega2_3 * omega3_2 + Scalar(4.0) * omega2 * omega3_4)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_2 * omega2 * w_0 + Scalar(3.0) * omega1 * omega2_2 * w_3
      + omega1 * omega3_2 * w_4 + omega1 * w_5 + Scalar(4.0) * omega2_3 * w_6
      + Scalar(2.0) * omega2 * omega3_2 * w_7 + Scalar(2.0) * omega2 * w_8
      - lump * (Scalar(48.0) * omega1_3 * omega2_2 - Scalar(4.0) * omega1_3 * omega3_2
      + Scalar(192.0) * omega1_2 * omega2_3 - Scalar(24.0) * omega1_2 * omega2 * omega3_2
      + Scalar(240.0) * omega1 * omega2_4 - Scalar(84.0) * omega1 * omega2_2 * omega3_2
      + Scalar(4.0) * omega1 * omega3_4 + Scalar(96.0) * omega2_5 - Scalar(80.0) * omega2_3 * omega3_2
      + Scalar(8.0) * omega2 * omega3_4)) / denominator;
  // by omega3
  gradient[2] = (Scalar(2.0) * omega1_2 * omega3 * w_1 + Scalar(2.0) * omega1 * omega2 * omega3 * w_4
      + Scalar(2.0) * omega2_2 * omega3 * w_7 + Scalar(4.0) * omega3_3 * w_9 + Scalar(2.0) * omega3 * w_10
      - lump * (-Scalar(8.0) * omega1_3 * omega2 * omega3 - Scalar(24.0) * omega1_2 * omega2_2 * omega3
      - Scalar(56.0) * omega1 * omega2_3 * omega3 + Scalar(16.0) * omega1 * omega2 * omega3_3
      - Scalar(40.0) * omega2_4 * omega3 + Scalar(16.0) * omega2_2 * omega3_3)) / denominator;
  gradient[3] = (a223 * c_0) / denominator;  // by a113
  gradient[4] = (Scalar(2.0) * a123 * c_1) / denominator;  // by a123
  gradient[5] = (a113 * c_0) / denominator;  // by a223
  gradient[8] = (c_2) / denominator;  // by b1122
}

/// gradient[p] = d harmonic_re_v1_A_v13 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 17 operations.
template <class Scalar>
void lump_gradient_12(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar b1111 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar denominator = Scalar(32.0) * omega1_4 - Scalar(8.0) * omega1_2 * omega3_2;
  // by omega1
  gradient[0] = (Scalar(8.0) * omega1 * b1111 - lump * (Scalar(128.0) * omega1_3
      - Scalar(16.0) * omega1 * omega3_2)) / denominator;
  // by omega3
  gradient[2] = (-Scalar(2.0) * omega3 * b1111 - lump * (-Scalar(16.0) * omega1_2 * omega3)) / denominator;
  gradient[3] = (Scalar(4.0) * a113) / denominator;  // by a113
  gradient[7] = (Scalar(4.0) * omega1_2 - omega3_2) / denominator;  // by b1111
}

/// gradient[p] = d harmonic_re_v2_A_v2_conjA_v12 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 172 operations.
template <class Scalar>
void lump_gradient_14(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar b1122 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega1_6 = omega1_5 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar a123_2 = a123 * a123;
  const Scalar denominator = Scalar(16.0) * omega1_6 - Scalar(48.0) * omega1_5 * omega2
      + Scalar(48.0) * omega1_4 * omega2_2 - Scalar(20.0) * omega1_4 * omega3_2
      - Scalar(16.0) * omega1_3 * omega2_3 + Scalar(28.0) * omega1_3 * omega2 * omega3_2
      - Scalar(12.0) * omega1_2 * omega2_2 * omega3_2 + Scalar(4.0) * omega1_2 * omega3_4
      + Scalar(4.0) * omega1 * omega2_3 * omega3_2 - Scalar(4.0) * omega1 * omega2 * omega3_4;
  // multiplies a113*a223
  const Scalar c_0 = Scalar(2.0) * omega1_2 - Scalar(4.0) * omega1 * omega2 + Scalar(2.0) * omega2_2
      - Scalar(2.0) * omega3_2;
  const Scalar c_1 = Scalar(4.0) * omega1_2 - omega3_2;  // multiplies a123^2
  // multiplies b1122
  const Scalar c_2 = Scalar(4.0) * omega1_4 - Scalar(8.0) * omega1_3 * omega2 + Scalar(4.0) * omega1_2 * omega2_2
      - Scalar(5.0) * omega1_2 * omega3_2 + Scalar(2.0) * omega1 * omega2 * omega3_2 - omega2_2 * omega3_2
      + omega3_4;
  const Scalar w_0 = Scalar(4.0) * b1122;  // multiplies omega1^4
  const Scalar w_1 = -Scalar(8.0) * b1122;  // multiplies omega1^3*omega2
  const Scalar w_2 = Scalar(4.0) * b1122;  // multiplies omega1^2*omega2^2
  const Scalar w_3 = -Scalar(5.0) * b1122;  // multiplies omega1^2*omega3^2
  const Scalar w_4 = Scalar(2.0) * a113 * a223 + Scalar(4.0) * a123_2;  // multiplies omega1^2
  const Scalar w_5 = Scalar(2.0) * b1122;  // multiplies omega1*omega2*omega3^2
  const Scalar w_6 = -Scalar(4.0) * a113 * a223;  // multiplies omega1*omega2
  const Scalar w_7 = -b1122;  // multiplies omega2^2*omega3^2
  const Scalar w_8 = Scalar(2.0) * a113 * a223;  // multiplies omega2^2
  const Scalar w_9 = b1122;  // multiplies omega3^4
  const Scalar w_10 = -Scalar(2.0) * a113 * a223 - a123_2;  // multiplies omega3^2
  // by omega1
  gradient[0] = (Scalar(4.0) * omega1_3 * w_0 + Scalar(3.0) * omega1_2 * omega2 * w_1
      + Scalar(2.0) * omega1 * omega2_2 * w_2 + Scalar(2.0) * omega1 * omega3_2 * w_3 + Scalar(2.0) * omega1 * w_4
      + omega2 * omega3_2 * w_5 + omega2 * w_6 - lump * (Scalar(96.0) * omega1_5
      - Scalar(240.0) * omega1_4 * omega2 + Scalar(192.0) * omega1_3 * omega2_2
      - Scalar(80.0) * omega1_3 * omega3_2 - Scalar(48.0) * omega1_2 * omega2_3
      + Scalar(84.0) * omega1_2 * omega2 * omega3_2 - Scalar(24.0) * omega1 * omega2_2 * omega3_2
      + Scalar(8.0) * omega1 * omega3_4 + Scalar(4.0) * omega2_3 * omega3_2
      - Scalar(4.0) * omega2 * omega3_4)) / denominator;
  // by omega2
  gradient[1] = (omega1_3 * w_1 + Scalar(2.0) * omega1_2 * omega2 * w_2 + omega1 * omega3_2 * w_5 + omega1 * w_6
      + Scalar(2.0) * omega2 * omega3_2 * w_7 + Scalar(2.0) * omega2 * w_8 - lump * (-Scalar(48.0) * omega1_5
      + Scalar(96.0) * omega1_4 * omega2 - Scalar(48.0) * omega1_3 * omega2_2 + Scalar(28.0) * omega1_3 * omega3_2
      - Scalar(24.0) * omega1_2 * omega2 * omega3_2 + Scalar(12.0) * omega1 * omega2_2 * omega3_2
      - Scalar(4.0) * omega1 * omega3_4)) / denominator;
  // by omega3
  gradient[2] = (Scalar(2.0) * omega1_2 * omega3 * w_3 + Scalar(2.0) * omega1 * omega2 * omega3 * w_5
      + Scalar(2.0) * omega2_2 * omega3 * w_7 + Scalar(4.0) * omega3_3 * w_9 + Scalar(2.0) * omega3 * w_10
      - lump * (-Scalar(40.0) * omega1_4 * omega3 + Scalar(56.0) * omega1_3 * omega2 * omega3
      - Scalar(24.0) * omega1_2 * omega2_2 * omega3 + Scalar(16.0) * omega1_2 * omega3_3
      + Scalar(8.0) * omega1 * omega2_3 * omega3 - Scalar(16.0) * omega1 * omega2 * omega3_3)) / denominator;
  gradient[3] = (a223 * c_0) / denominator;  // by a113
  gradient[4] = (Scalar(2.0) * a123 * c_1) / denominator;  // by a123
  gradient[5] = (a113 * c_0) / denominator;  // by a223
  gradient[8] = (c_2) / denominator;  // by b1122
}

/// gradient[p] = d harmonic_re_v2_conjA_v2_F / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 34 operations.
template <class Scalar>
void lump_gradient_15(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a223 = parameters[5];
  const Scalar e3 = parameters[18];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar denominator = omega1_4 + Scalar(2.0) * omega1_3 * omega2 - omega1_2 * omega3_2
      - Scalar(2.0) * omega1 * omega2_3 - omega2_4 + omega2_2 * omega3_2;
  // by omega1
  gradient[0] = (-lump * (Scalar(4.0) * omega1_3 + Scalar(6.0) * omega1_2 * omega2
      - Scalar(2.0) * omega1 * omega3_2 - Scalar(2.0) * omega2_3)) / denominator;
  // by omega2
  gradient[1] = (-lump * (Scalar(2.0) * omega1_3 - Scalar(6.0) * omega1 * omega2_2 - Scalar(4.0) * omega2_3
      + Scalar(2.0) * omega2 * omega3_2)) / denominator;
  // by omega3
  gradient[2] = (-lump * (-Scalar(2.0) * omega1_2 * omega3 + Scalar(2.0) * omega2_2 * omega3)) / denominator;
  gradient[5] = (-e3) / denominator;  // by a223
  gradient[18] = (-a223) / denominator;  // by e3
}

/// gradient[p] = d harmonic_re_v2_A_v23 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 17 operations.
template <class Scalar>
void lump_gradient_16(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a223 = parameters[5];
  const Scalar b2222 = parameters[9];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar denominator = Scalar(32.0) * omega2_4 - Scalar(8.0) * omega2_2 * omega3_2;
  // by omega2
  gradient[1] = (Scalar(8.0) * omega2 * b2222 - lump * (Scalar(128.0) * omega2_3
      - Scalar(16.0) * omega2 * omega3_2)) / denominator;
  // by omega3
  gradient[2] = (-Scalar(2.0) * omega3 * b2222 - lump * (-Scalar(16.0) * omega2_2 * omega3)) / denominator;
  gradient[5] = (Scalar(4.0) * a223) / denominator;  // by a223
  gradient[9] = (Scalar(4.0) * omega2_2 - omega3_2) / denominator;  // by b2222
}

/// gradient[p] = d harmonic_re_v2_A_v12_A_v2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 172 operations.
template <class Scalar>
void lump_gradient_17(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar b1122 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega1_6 = omega1_5 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar a123_2 = a123 * a123;
  const Scalar denominator = Scalar(16.0) * omega1_6 + Scalar(48.0) * omega1_5 * omega2
      + Scalar(48.0) * omega1_4 * omega2_2 - Scalar(20.0) * omega1_4 * omega3_2
      + Scalar(16.0) * omega1_3 * omega2_3 - Scalar(28.0) * omega1_3 * omega2 * omega3_2
      - Scalar(12.0) * omega1_2 * omega2_2 * omega3_2 + Scalar(4.0) * omega1_2 * omega3_4
      - Scalar(4.0) * omega1 * omega2_3 * omega3_2 + Scalar(4.0) * omega1 * omega2 * omega3_4;
  // multiplies a113*a223
  const Scalar c_0 = Scalar(2.0) * omega1_2 + Scalar(4.0) * omega1 * omega2 + Scalar(2.0) * omega2_2
      - Scalar(2.0) * omega3_2;
  const Scalar c_1 = Scalar(4.0) * omega1_2 - omega3_2;  // multiplies a123^2
  // multiplies b1122
  const Scalar c_2 = Scalar(4.0) * omega1_4 + Scalar(8.0) * omega1_3 * omega2 + Scalar(4.0) * omega1_2 * omega2_2
      - Scalar(5.0) * omega1_2 * omega3_2 - Scalar(2.0) * omega1 * omega2 * omega3_2 - omega2_2 * omega3_2
      + omega3_4;
  const Scalar w_0 = Scalar(4.0) * b1122;  // multiplies omega1^4
  const Scalar w_1 = Scalar(8.0) * b1122;  // multiplies omega1^3*omega2
  const Scalar w_2 = Scalar(4.0) * b1122;  // multiplies omega1^2*omega2^2
  const Scalar w_3 = -Scalar(5.0) * b1122;  // multiplies omega1^2*omega3^2
  const Scalar w_4 = Scalar(2.0) * a113 * a223 + Scalar(4.0) * a123_2;  // multiplies omega1^2
  const Scalar w_5 = -Scalar(2.0) * b1122;  // multiplies omega1*omega2*omega3^2
  const Scalar w_6 = Scalar(4.0) * a113 * a223;  // multiplies omega1*omega2
  const Scalar w_7 = -b1122;  // multiplies omega2^2*omega3^2
  const Scalar w_8 = Scalar(2.0) * a113 * a223;  // multiplies omega2^2
  const Scalar w_9 = b1122;  // multiplies omega3^4
  const Scalar w_10 = -Scalar(2.0) * a113 * a223 - a123_2;  // multiplies omega3^2
  // by omega1
  gradient[0] = (Scalar(4.0) * omega1_3 * w_0 + Scalar(3.0) * omega1_2 * omega2 * w_1
      + Scalar(2.0) * omega1 * omega2_2 * w_2 + Scalar(2.0) * omega1 * omega3_2 * w_3 + Scalar(2.0) * omega1 * w_4
      + omega2 * omega3_2 * w_5 + omega2 * w_6 - lump * (Scalar(96.0) * omega1_5
      + Scalar(240.0) * omega1_4 * omega2 + Scalar(192.0) * omega1_3 * omega2_2
      - Scalar(80.0) * omega1_3 * omega3_2 + Scalar(48.0) * omega1_2 * omega2_3
      - Scalar(84.0) * omega1_2 * omega2 * omega3_2 - Scalar(24.0) * omega1 * omega2_2 * omega3_2
      + Scalar(8.0) * omega1 * omega3_4 - Scalar(4.0) * omega2_3 * omega3_2
      + Scalar(4.0) * omega2 * omega3_4)) / denominator;
  // by omega2
  gradient[1] = (omega1_3 * w_1 + Scalar(2.0) * omega1_2 * omega2 * w_2 + omega1 * omega3_2 * w_5 + omega1 * w_6
      + Scalar(2.0) * omega2 * omega3_2 * w_7 + Scalar(2.0) * omega2 * w_8 - lump * (Scalar(48.0) * omega1_5
      + Scalar(96.0) * omega1_4 * omega2 + Scalar(48.0) * omega1_3 * omega2_2 - Scalar(28.0) * omega1_3 * omega3_2
      - Scalar(24.0) * omega1_2 * omega2 * omega3_2 - Scalar(12.0) * omega1 * omega2_2 * omega3_2
      + Scalar(4.0) * omega1 * omega3_4)) / denominator;
  // by omega3
  gradient[2] = (Scalar(2.0) * omega1_2 * omega3 * w_3 + Scalar(2.0) * omega1 * omega2 * omega3 * w_5
      + Scalar(2.0) * omega2_2 * omega3 * w_7 + Scalar(4.0) * omega3_3 * w_9 + Scalar(2.0) * omega3 * w_10
      - lump * (-Scalar(40.0) * omega1_4 * omega3 - Scalar(56.0) * omega1_3 * omega2 * omega3
      - Scalar(24.0) * omega1_2 * omega2_2 * omega3 + Scalar(16.0) * omega1_2 * omega3_3
      - Scalar(8.0) * omega1 * omega2_3 * omega3 + Scalar(16.0) * omega1 * omega2 * omega3_3)) / denominator;
  gradient[3] = (a223 * c_0) / denominator;  // by a113
  gradient[4] = (Scalar(2.0) * a123 * c_1) / denominator;  // by a123
  gradient[5] = (a113 * c_0) / denominator;  // by a223
  gradient[8] = (c_2) / denominator;  // by b1122
}

/// gradient[p] = d harmonic_re_v3_conjA_v1_F / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 112 operations.
template <class Scalar>
void lump_gradient_22(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar e1 = parameters[14];
  const Scalar e2 = parameters[16];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar denominator = Scalar(4.0) * omega1_3 * omega2_3 - Scalar(4.0) * omega1_3 * omega2 * omega3_2
      + Scalar(10.0) * omega1_2 * omega2_4 - Scalar(10.0) * omega1_2 * omega2_2 * omega3_2
      + Scalar(4.0) * omega1 * omega2_5 - Scalar(4.0) * omega1 * omega2_3 * omega3_2;
  // by omega1
  gradient[0] = (-Scalar(4.0) * omega1 * a113 * e1 - Scalar(4.0) * omega2 * a113 * e1
      - Scalar(2.0) * omega2 * a123 * e2 - lump * (Scalar(12.0) * omega1_2 * omega2_3
      - Scalar(12.0) * omega1_2 * omega2 * omega3_2 + Scalar(20.0) * omega1 * omega2_4
      - Scalar(20.0) * omega1 * omega2_2 * omega3_2 + Scalar(4.0) * omega2_5
      - Scalar(4.0) * omega2_3 * omega3_2)) / denominator;
  // by omega2
  gradient[1] = (-Scalar(4.0) * omega1 * a113 * e1 - Scalar(2.0) * omega1 * a123 * e2
      - Scalar(2.0) * omega2 * a123 * e2 - lump * (Scalar(12.0) * omega1_3 * omega2_2
      - Scalar(4.0) * omega1_3 * omega3_2 + Scalar(40.0) * omega1_2 * omega2_3
      - Scalar(20.0) * omega1_2 * omega2 * omega3_2 + Scalar(20.0) * omega1 * omega2_4
      - Scalar(12.0) * omega1 * omega2_2 * omega3_2)) / denominator;
  // by omega3
  gradient[2] = (-lump * (-Scalar(8.0) * omega1_3 * omega2 * omega3 - Scalar(20.0) * omega1_2 * omega2_2 * omega3
      - Scalar(8.0) * omega1 * omega2_3 * omega3)) / denominator;
  gradient[3] = (-Scalar(2.0) * omega1_2 * e1 - Scalar(4.0) * omega1 * omega2 * e1) / denominator;  // by a113
  gradient[4] = (-Scalar(2.0) * omega1 * omega2 * e2 - omega2_2 * e2) / denominator;  // by a123
  gradient[14] = (-Scalar(2.0) * omega1_2 * a113 - Scalar(4.0) * omega1 * omega2 * a113) / denominator;  // by e1
  gradient[16] = (-Scalar(2.0) * omega1 * omega2 * a123 - omega2_2 * a123) / denominator;  // by e2
}

/// gradient[p] = d harmonic_re_v3_conjA_v2_F / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 112 operations.
template <class Scalar>
void lump_gradient_23(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar e1 = parameters[14];
  const Scalar e2 = parameters[16];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar denominator = Scalar(4.0) * omega1_5 * omega2 + Scalar(10.0) * omega1_4 * omega2_2
      + Scalar(4.0) * omega1_3 * omega2_3 - Scalar(4.0) * omega1_3 * omega2 * omega3_2
      - Scalar(10.0) * omega1_2 * omega2_2 * omega3_2 - Scalar(4.0) * omega1 * omega2_3 * omega3_2;
  // by omega1
  gradient[0] = (-Scalar(2.0) * omega1 * a123 * e1 - Scalar(2.0) * omega2 * a123 * e1
      - Scalar(4.0) * omega2 * a223 * e2 - lump * (Scalar(20.0) * omega1_4 * omega2
      + Scalar(40.0) * omega1_3 * omega2_2 + Scalar(12.0) * omega1_2 * omega2_3
      - Scalar(12.0) * omega1_2 * omega2 * omega3_2 - Scalar(20.0) * omega1 * omega2_2 * omega3_2
      - Scalar(4.0) * omega2_3 * omega3_2)) / denominator;
  // by omega2
  gradient[1] = (-Scalar(2.0) * omega1 * a123 * e1 - Scalar(4.0) * omega1 * a223 * e2
      - Scalar(4.0) * omega2 * a223 * e2 - lump * (Scalar(4.0) * omega1_5 + Scalar(20.0) * omega1_4 * omega2
      + Scalar(12.0) * omega1_3 * omega2_2 - Scalar(4.0) * omega1_3 * omega3_2
      - Scalar(20.0) * omega1_2 * omega2 * omega3_2 - Scalar(12.0) * omega1 * omega2_2 * omega3_2)) / denominator;
  // by omega3
  gradient[2] = (-lump * (-Scalar(8.0) * omega1_3 * omega2 * omega3 - Scalar(20.0) * omega1_2 * omega2_2 * omega3
      - Scalar(8.0) * omega1 * omega2_3 * omega3)) / denominator;
  gradient[4] = (-omega1_2 * e1 - Scalar(2.0) * omega1 * omega2 * e1) / denominator;  // by a123
  gradient[5] = (-Scalar(4.0) * omega1 * omega2 * e2 - Scalar(2.0) * omega2_2 * e2) / denominator;  // by a223
  gradient[14] = (-omega1_2 * a123 - Scalar(2.0) * omega1 * omega2 * a123) / denominator;  // by e1
  gradient[16] = (-Scalar(4.0) * omega1 * omega2 * a223 - Scalar(2.0) * omega2_2 * a223) / denominator;  // by e2
}

/// jacobian[l * 19 + p] = d lumps[l] / d parameters[p]. 0 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  Scalar lumps[24];
  evaluate_lumps(parameters, lumps);
  for (std::size_t i = 0; i < 456; ++i) jacobian[i] = Scalar(0.0);
  jacobian[13] = Scalar(1.0);  // d mu1 / d mu1
  lump_gradient_1(parameters, lumps[1], jacobian + 19);  // d conservative_v1_A_v1_A_v2_conjA_v2
  lump_gradient_2(parameters, lumps[2], jacobian + 38);  // d conservative_v1_A_v12_conjA_v1
  lump_gradient_3(parameters, lumps[3], jacobian + 57);  // d conservative_v1_conjA_v2_F
  jacobian[91] = Scalar(1.0);  // d mu2 / d mu2
  lump_gradient_5(parameters, lumps[5], jacobian + 95);  // d conservative_v2_A_v22_conjA_v2
  jacobian[128] = Scalar(1.0);  // d e1 / d e1
  lump_gradient_7(parameters, lumps[7], jacobian + 133);  // d harmonic_re_v1_A_v2_conjA_v12
  lump_gradient_8(parameters, lumps[8], jacobian + 152);  // d harmonic_re_v1_conjA_v1_F
  lump_gradient_9(parameters, lumps[9], jacobian + 171);  // d harmonic_re_v1_A_v22_conjA_v2
  lump_gradient_10(parameters, lumps[10], jacobian + 190);  // d harmonic_re_v1_A_v22_conjA_v1
  lump_gradient_11(parameters, lumps[11], jacobian + 209);  // d harmonic_re_v1_A_v1_A_v22
  lump_gradient_12(parameters, lumps[12], jacobian + 228);  // d harmonic_re_v1_A_v13
  jacobian[263] = Scalar(1.0);  // d e2 / d e2
  lump_gradient_14(parameters, lumps[14], jacobian + 266);  // d harmonic_re_v2_A_v2_conjA_v12
  lump_gradient_15(parameters, lumps[15], jacobian + 285);  // d harmonic_re_v2_conjA_v2_F
  lump_gradient_16(parameters, lumps[16], jacobian + 304);  // d harmonic_re_v2_A_v23
  lump_gradient_17(parameters, lumps[17], jacobian + 323);  // d harmonic_re_v2_A_v12_A_v2
  jacobian[346] = Scalar(1.0);  // d a123 / d a123
  jacobian[366] = Scalar(1.0);  // d a223 / d a223
  jacobian[383] = Scalar(1.0);  // d a113 / d a113
  jacobian[417] = Scalar(1.0);  // d e3 / d e3
  lump_gradient_22(parameters, lumps[22], jacobian + 418);  // d harmonic_re_v3_conjA_v1_F
  lump_gradient_23(parameters, lumps[23], jacobian + 437);  // d harmonic_re_v3_conjA_v2_F
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
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar Omega_2 = Omega * Omega;
  factor[0] = Scalar(1.0) / (Scalar(2.0) * omega1_2 - Scalar(2.0) * Omega_2);
}

/// Rows of the harmonic Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(Omega)*t) in v1 = 1/(2*omega1^2 - 2*Omega^2)*e1*F
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

/// What multiplies the 3 terms of the harmonic omega2 of v1: functions of the frequencies alone. 113 operations.
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
  factor[0] = (Scalar(24.0) * omega1_7 - Scalar(8.0) * omega1_6 * omega2 - Scalar(48.0) * omega1_5 * omega2_2
      - Scalar(102.0) * omega1_5 * omega3_2 + Scalar(16.0) * omega1_4 * omega2_3
      + Scalar(34.0) * omega1_4 * omega2 * omega3_2 + Scalar(24.0) * omega1_3 * omega2_4
      - Scalar(84.0) * omega1_3 * omega2_2 * omega3_2 + Scalar(96.0) * omega1_3 * omega3_4
      - Scalar(8.0) * omega1_2 * omega2_5 + Scalar(28.0) * omega1_2 * omega2_3 * omega3_2
      - Scalar(32.0) * omega1_2 * omega2 * omega3_4 - Scalar(6.0) * omega1 * omega2_4 * omega3_2
      + Scalar(24.0) * omega1 * omega2_2 * omega3_4 - Scalar(18.0) * omega1 * omega3_6
      + Scalar(2.0) * omega2_5 * omega3_2 - Scalar(8.0) * omega2_3 * omega3_4
      + Scalar(6.0) * omega2 * omega3_6) / (Scalar(9.0) * omega1_5 * omega3_2
      + Scalar(25.0) * omega1_4 * omega2 * omega3_2 + Scalar(22.0) * omega1_3 * omega2_2 * omega3_2
      - Scalar(12.0) * omega1_3 * omega3_4 + Scalar(6.0) * omega1_2 * omega2_3 * omega3_2
      - Scalar(16.0) * omega1_2 * omega2 * omega3_4 + omega1 * omega2_4 * omega3_2
      - Scalar(8.0) * omega1 * omega2_2 * omega3_4 + Scalar(3.0) * omega1 * omega3_6 + omega2_5 * omega3_2
      - Scalar(4.0) * omega2_3 * omega3_4 + Scalar(3.0) * omega2 * omega3_6);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega2 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2)*t) in v1 = (24*omega1^7 - 8*omega1^6*omega2 - 48*omega1^5*omega2^2 -
/// 102*omega1^5*omega3^2 + 16*omega1^4*omega2^3 + 34*omega1^4*omega2*omega3^2 + 24*omega1^3*omega2^4 -
/// 84*omega1^3*omega2^2*omega3^2 + 96*omega1^3*omega3^4 - 8*omega1^2*omega2^5 + 28*omega1^2*omega2^3*omega3^2 -
/// 32*omega1^2*omega2*omega3^4 - 6*omega1*omega2^4*omega3^2 + 24*omega1*omega2^2*omega3^4 - 18*omega1*omega3^6 +
/// 2*omega2^5*omega3^2 - 8*omega2^3*omega3^4 + 6*omega2*omega3^6)/(9*omega1^5*omega3^2 +
/// 25*omega1^4*omega2*omega3^2 + 22*omega1^3*omega2^2*omega3^2 - 12*omega1^3*omega3^4 +
/// 6*omega1^2*omega2^3*omega3^2 - 16*omega1^2*omega2*omega3^4 + omega1*omega2^4*omega3^2 -
/// 8*omega1*omega2^2*omega3^4 + 3*omega1*omega3^6 + omega2^5*omega3^2 - 4*omega2^3*omega3^4 +
/// 3*omega2*omega3^6)*harmonic_re_v1_A_v2_conjA_v12*A_v1*conj(A_v1)*A_v2 +
/// harmonic_re_v1_conjA_v1_F*conj(A_v1)*F + harmonic_re_v1_A_v22_conjA_v2*A_v2^2*conj(A_v2)
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

/// What multiplies the 2 terms of the harmonic omega2+Omega of v1: functions of the frequencies alone. 6
/// operations.
template <class Scalar>
void factors_6([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega2_2 = omega2 * omega2;
  factor[0] = omega1 / (Scalar(2.0) * omega1 * omega2 + Scalar(2.0) * omega2_2);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic omega2+Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + Omega)*t) in v1 = omega1/(2*omega1*omega2 +
/// 2*omega2^2)*conservative_v1_conjA_v2_F*A_v2*F + harmonic_re_v1_A_v1_A_v22*A_v1*A_v2^2
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
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  factor[0] = (-omega1_2 * omega3_2 + omega2_2 * omega3_2) / (Scalar(8.0) * omega1_2 * omega2_2
      - Scalar(3.0) * omega1_2 * omega3_2 - Scalar(72.0) * omega2_4 + Scalar(27.0) * omega2_2 * omega3_2);
}

/// Rows of the harmonic 3*omega2 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega2)*t) in v1 = (-omega1^2*omega3^2 + omega2^2*omega3^2)/(8*omega1^2*omega2^2 -
/// 3*omega1^2*omega3^2 - 72*omega2^4 + 27*omega2^2*omega3^2)*harmonic_re_v1_A_v22_conjA_v2*A_v2^3
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

/// What multiplies the 2 terms of the harmonic omega1+Omega of v1: functions of the frequencies alone. 128
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
  const Scalar Omega_2 = Omega * Omega;
  const Scalar Omega_3 = Omega_2 * Omega;
  const Scalar Omega_4 = Omega_3 * Omega;
  factor[0] = (Scalar(27.0) * omega1_6 - Scalar(84.0) * omega1_5 * omega2 + Scalar(91.0) * omega1_4 * omega2_2
      - Scalar(36.0) * omega1_4 * omega3_2 - Scalar(40.0) * omega1_3 * omega2_3
      + Scalar(60.0) * omega1_3 * omega2 * omega3_2 + Scalar(9.0) * omega1_2 * omega2_4
      - Scalar(40.0) * omega1_2 * omega2_2 * omega3_2 + Scalar(9.0) * omega1_2 * omega3_4
      - Scalar(4.0) * omega1 * omega2_5 + Scalar(20.0) * omega1 * omega2_3 * omega3_2
      - Scalar(12.0) * omega1 * omega2 * omega3_4 + omega2_6 - Scalar(4.0) * omega2_4 * omega3_2
      + Scalar(3.0) * omega2_2 * omega3_4) / (Scalar(27.0) * omega1_6 + Scalar(84.0) * omega1_5 * omega2
      + Scalar(91.0) * omega1_4 * omega2_2 - Scalar(36.0) * omega1_4 * omega3_2
      + Scalar(40.0) * omega1_3 * omega2_3 - Scalar(60.0) * omega1_3 * omega2 * omega3_2
      + Scalar(9.0) * omega1_2 * omega2_4 - Scalar(40.0) * omega1_2 * omega2_2 * omega3_2
      + Scalar(9.0) * omega1_2 * omega3_4 + Scalar(4.0) * omega1 * omega2_5
      - Scalar(20.0) * omega1 * omega2_3 * omega3_2 + Scalar(12.0) * omega1 * omega2 * omega3_4 + omega2_6
      - Scalar(4.0) * omega2_4 * omega3_2 + Scalar(3.0) * omega2_2 * omega3_4);
  factor[1] = (omega1_4 + Scalar(2.0) * omega1_3 * omega2 - omega1_2 * omega3_2 - Scalar(2.0) * omega1 * omega2_3
      - omega2_4 + omega2_2 * omega3_2) / (Scalar(2.0) * omega1 * omega3_2 * Omega
      - Scalar(2.0) * omega1 * Omega_3 + omega3_2 * Omega_2 - Omega_4);
}

/// Rows of the harmonic omega1+Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + Omega)*t) in v1 = (27*omega1^6 - 84*omega1^5*omega2 + 91*omega1^4*omega2^2 -
/// 36*omega1^4*omega3^2 - 40*omega1^3*omega2^3 + 60*omega1^3*omega2*omega3^2 + 9*omega1^2*omega2^4 -
/// 40*omega1^2*omega2^2*omega3^2 + 9*omega1^2*omega3^4 - 4*omega1*omega2^5 + 20*omega1*omega2^3*omega3^2 -
/// 12*omega1*omega2*omega3^4 + omega2^6 - 4*omega2^4*omega3^2 + 3*omega2^2*omega3^4)/(27*omega1^6 +
/// 84*omega1^5*omega2 + 91*omega1^4*omega2^2 - 36*omega1^4*omega3^2 + 40*omega1^3*omega2^3 -
/// 60*omega1^3*omega2*omega3^2 + 9*omega1^2*omega2^4 - 40*omega1^2*omega2^2*omega3^2 + 9*omega1^2*omega3^4 +
/// 4*omega1*omega2^5 - 20*omega1*omega2^3*omega3^2 + 12*omega1*omega2*omega3^4 + omega2^6 - 4*omega2^4*omega3^2
/// + 3*omega2^2*omega3^4)*harmonic_re_v1_A_v2_conjA_v12*A_v1^2*A_v2 + (omega1^4 + 2*omega1^3*omega2 -
/// omega1^2*omega3^2 - 2*omega1*omega2^3 - omega2^4 + omega2^2*omega3^2)/(2*omega1*omega3^2*Omega -
/// 2*omega1*Omega^3 + omega3^2*Omega^2 - Omega^4)*harmonic_re_v1_conjA_v1_F*A_v1*F
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
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar Omega_2 = Omega * Omega;
  factor[0] = Scalar(1.0) / (Scalar(2.0) * omega2_2 - Scalar(2.0) * Omega_2);
}

/// Rows of the harmonic Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(Omega)*t) in v2 = 1/(2*omega2^2 - 2*Omega^2)*e2*F
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

/// What multiplies the 1 terms of the harmonic -omega1+2*omega2 of v2: functions of the frequencies alone. 57
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
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  factor[0] = (omega1_3 * omega3_2 - omega1_2 * omega2 * omega3_2 + Scalar(7.0) * omega1 * omega2_2 * omega3_2
      - Scalar(3.0) * omega1 * omega3_4 + Scalar(9.0) * omega2_3 * omega3_2
      - Scalar(3.0) * omega2 * omega3_4) / (Scalar(8.0) * omega1_3 * omega2_2 - Scalar(3.0) * omega1_3 * omega3_2
      - Scalar(40.0) * omega1_2 * omega2_3 + Scalar(15.0) * omega1_2 * omega2 * omega3_2
      + Scalar(56.0) * omega1 * omega2_4 - Scalar(29.0) * omega1 * omega2_2 * omega3_2
      + Scalar(3.0) * omega1 * omega3_4 - Scalar(24.0) * omega2_5 + Scalar(33.0) * omega2_3 * omega3_2
      - Scalar(9.0) * omega2 * omega3_4);
}

/// Rows of the harmonic -omega1+2*omega2 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + 2*omega2)*t) in v2 = (omega1^3*omega3^2 - omega1^2*omega2*omega3^2 +
/// 7*omega1*omega2^2*omega3^2 - 3*omega1*omega3^4 + 9*omega2^3*omega3^2 -
/// 3*omega2*omega3^4)/(8*omega1^3*omega2^2 - 3*omega1^3*omega3^2 - 40*omega1^2*omega2^3 +
/// 15*omega1^2*omega2*omega3^2 + 56*omega1*omega2^4 - 29*omega1*omega2^2*omega3^2 + 3*omega1*omega3^4 -
/// 24*omega2^5 + 33*omega2^3*omega3^2 - 9*omega2*omega3^4)*harmonic_re_v1_A_v22_conjA_v2*conj(A_v1)*A_v2^2
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

/// What multiplies the 3 terms of the harmonic omega1 of v2: functions of the frequencies alone. 113 operations.
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
  factor[0] = (-Scalar(24.0) * omega1_5 + Scalar(56.0) * omega1_4 * omega2 - Scalar(40.0) * omega1_3 * omega2_2
      + Scalar(33.0) * omega1_3 * omega3_2 + Scalar(8.0) * omega1_2 * omega2_3
      - Scalar(29.0) * omega1_2 * omega2 * omega3_2 + Scalar(15.0) * omega1 * omega2_2 * omega3_2
      - Scalar(9.0) * omega1 * omega3_4 - Scalar(3.0) * omega2_3 * omega3_2
      + Scalar(3.0) * omega2 * omega3_4) / (Scalar(9.0) * omega1_3 * omega3_2
      + Scalar(7.0) * omega1_2 * omega2 * omega3_2 - omega1 * omega2_2 * omega3_2
      - Scalar(3.0) * omega1 * omega3_4 + omega2_3 * omega3_2 - Scalar(3.0) * omega2 * omega3_4);
  factor[1] = (-Scalar(8.0) * omega1_4 * omega2_2 + Scalar(2.0) * omega1_4 * omega3_2
      + Scalar(16.0) * omega1_2 * omega2_4 + Scalar(28.0) * omega1_2 * omega2_2 * omega3_2
      - Scalar(8.0) * omega1_2 * omega3_4 - Scalar(8.0) * omega2_6 + Scalar(34.0) * omega2_4 * omega3_2
      - Scalar(32.0) * omega2_2 * omega3_4 + Scalar(6.0) * omega3_6) / (Scalar(8.0) * omega1_4 * omega2_2
      - Scalar(3.0) * omega1_4 * omega3_2 - Scalar(16.0) * omega1_2 * omega2_4
      - Scalar(10.0) * omega1_2 * omega2_2 * omega3_2 + Scalar(6.0) * omega1_2 * omega3_4 + Scalar(8.0) * omega2_6
      - Scalar(19.0) * omega2_4 * omega3_2 + Scalar(14.0) * omega2_2 * omega3_4 - Scalar(3.0) * omega3_6);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega1 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1)*t) in v2 = (-24*omega1^5 + 56*omega1^4*omega2 - 40*omega1^3*omega2^2 +
/// 33*omega1^3*omega3^2 + 8*omega1^2*omega2^3 - 29*omega1^2*omega2*omega3^2 + 15*omega1*omega2^2*omega3^2 -
/// 9*omega1*omega3^4 - 3*omega2^3*omega3^2 + 3*omega2*omega3^4)/(9*omega1^3*omega3^2 +
/// 7*omega1^2*omega2*omega3^2 - omega1*omega2^2*omega3^2 - 3*omega1*omega3^4 + omega2^3*omega3^2 -
/// 3*omega2*omega3^4)*harmonic_re_v1_A_v2_conjA_v12*A_v1^2*conj(A_v1) + (-8*omega1^4*omega2^2 +
/// 2*omega1^4*omega3^2 + 16*omega1^2*omega2^4 + 28*omega1^2*omega2^2*omega3^2 - 8*omega1^2*omega3^4 - 8*omega2^6
/// + 34*omega2^4*omega3^2 - 32*omega2^2*omega3^4 + 6*omega3^6)/(8*omega1^4*omega2^2 - 3*omega1^4*omega3^2 -
/// 16*omega1^2*omega2^4 - 10*omega1^2*omega2^2*omega3^2 + 6*omega1^2*omega3^4 + 8*omega2^6 -
/// 19*omega2^4*omega3^2 + 14*omega2^2*omega3^4 - 3*omega3^6)*harmonic_re_v1_A_v22_conjA_v2*A_v1*A_v2*conj(A_v2)
/// + harmonic_re_v2_conjA_v2_F*conj(A_v2)*F
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

/// What multiplies the 2 terms of the harmonic omega2+Omega of v2: functions of the frequencies alone. 82
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
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar Omega_2 = Omega * Omega;
  const Scalar Omega_3 = Omega_2 * Omega;
  const Scalar Omega_4 = Omega_3 * Omega;
  factor[0] = (omega1_3 * omega3_2 + omega1_2 * omega2 * omega3_2 + Scalar(7.0) * omega1 * omega2_2 * omega3_2
      - Scalar(3.0) * omega1 * omega3_4 - Scalar(9.0) * omega2_3 * omega3_2
      + Scalar(3.0) * omega2 * omega3_4) / (Scalar(8.0) * omega1_3 * omega2_2 - Scalar(3.0) * omega1_3 * omega3_2
      + Scalar(40.0) * omega1_2 * omega2_3 - Scalar(15.0) * omega1_2 * omega2 * omega3_2
      + Scalar(56.0) * omega1 * omega2_4 - Scalar(29.0) * omega1 * omega2_2 * omega3_2
      + Scalar(3.0) * omega1 * omega3_4 + Scalar(24.0) * omega2_5 - Scalar(33.0) * omega2_3 * omega3_2
      + Scalar(9.0) * omega2 * omega3_4);
  factor[1] = (-omega1_4 - Scalar(2.0) * omega1_3 * omega2 + omega1_2 * omega3_2 + Scalar(2.0) * omega1 * omega2_3
      + omega2_4 - omega2_2 * omega3_2) / (Scalar(2.0) * omega2 * omega3_2 * Omega
      - Scalar(2.0) * omega2 * Omega_3 + omega3_2 * Omega_2 - Omega_4);
}

/// Rows of the harmonic omega2+Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + Omega)*t) in v2 = (omega1^3*omega3^2 + omega1^2*omega2*omega3^2 +
/// 7*omega1*omega2^2*omega3^2 - 3*omega1*omega3^4 - 9*omega2^3*omega3^2 +
/// 3*omega2*omega3^4)/(8*omega1^3*omega2^2 - 3*omega1^3*omega3^2 + 40*omega1^2*omega2^3 -
/// 15*omega1^2*omega2*omega3^2 + 56*omega1*omega2^4 - 29*omega1*omega2^2*omega3^2 + 3*omega1*omega3^4 +
/// 24*omega2^5 - 33*omega2^3*omega3^2 + 9*omega2*omega3^4)*harmonic_re_v1_A_v22_conjA_v2*A_v1*A_v2^2 +
/// (-omega1^4 - 2*omega1^3*omega2 + omega1^2*omega3^2 + 2*omega1*omega2^3 + omega2^4 -
/// omega2^2*omega3^2)/(2*omega2*omega3^2*Omega - 2*omega2*Omega^3 + omega3^2*Omega^2 -
/// Omega^4)*harmonic_re_v2_conjA_v2_F*A_v2*F
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

/// What multiplies the 2 terms of the harmonic omega1+Omega of v2: functions of the frequencies alone. 4
/// operations.
template <class Scalar>
void factors_16([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  factor[0] = Scalar(1.0) / (Scalar(2.0) * omega1 + Scalar(2.0) * omega2);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic omega1+Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + Omega)*t) in v2 = 1/(2*omega1 + 2*omega2)*conservative_v1_conjA_v2_F*A_v1*F +
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

/// What multiplies the 1 terms of the harmonic 3*omega1 of v2: functions of the frequencies alone. 30
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
  factor[0] = (omega1_3 - Scalar(3.0) * omega1_2 * omega2 + Scalar(3.0) * omega1 * omega2_2 - omega1 * omega3_2
      - omega2_3 + omega2 * omega3_2) / (Scalar(27.0) * omega1_3 + Scalar(3.0) * omega1_2 * omega2
      + omega1 * omega2_2 - Scalar(9.0) * omega1 * omega3_2 + omega2_3 - Scalar(3.0) * omega2 * omega3_2);
}

/// Rows of the harmonic 3*omega1 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega1)*t) in v2 = (omega1^3 - 3*omega1^2*omega2 + 3*omega1*omega2^2 - omega1*omega3^2
/// - omega2^3 + omega2*omega3^2)/(27*omega1^3 + 3*omega1^2*omega2 + omega1*omega2^2 - 9*omega1*omega3^2 +
/// omega2^3 - 3*omega2*omega3^2)*harmonic_re_v1_A_v2_conjA_v12*A_v1^3
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

/// What multiplies the 1 terms of the harmonic -omega1+omega2 of v3: functions of the frequencies alone. 9
/// operations.
template <class Scalar>
void factors_18([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  factor[0] = Scalar(1.0) / (omega1_2 - Scalar(2.0) * omega1 * omega2 + omega2_2 - omega3_2);
}

/// Rows of the harmonic -omega1+omega2 of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + omega2)*t) in v3 = 1/(omega1^2 - 2*omega1*omega2 + omega2^2 -
/// omega3^2)*a123*conj(A_v1)*A_v2
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

/// What multiplies the 2 terms of the harmonic Omega of v3: functions of the frequencies alone. 14 operations.
template <class Scalar>
void factors_20([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar Omega_2 = Omega * Omega;
  factor[0] = Scalar(1.0) / (omega1_2 + Scalar(2.0) * omega1 * omega2 + omega2_2 - omega3_2);
  factor[1] = Scalar(1.0) / (Scalar(2.0) * omega3_2 - Scalar(2.0) * Omega_2);
}

/// Rows of the harmonic Omega of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(Omega)*t) in v3 = 1/(omega1^2 + 2*omega1*omega2 + omega2^2 - omega3^2)*a123*A_v1*A_v2 +
/// 1/(2*omega3^2 - 2*Omega^2)*e3*F
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

/// What multiplies the 1 terms of the harmonic 2*omega2 of v3: functions of the frequencies alone. 5 operations.
template <class Scalar>
void factors_21([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  factor[0] = Scalar(1.0) / (Scalar(4.0) * omega2_2 - omega3_2);
}

/// Rows of the harmonic 2*omega2 of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega2)*t) in v3 = 1/(4*omega2^2 - omega3^2)*a223*A_v2^2
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

/// What multiplies the 1 terms of the harmonic 2*omega1 of v3: functions of the frequencies alone. 5 operations.
template <class Scalar>
void factors_22([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega3_2 = omega3 * omega3;
  factor[0] = Scalar(1.0) / (Scalar(4.0) * omega1_2 - omega3_2);
}

/// Rows of the harmonic 2*omega1 of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega1)*t) in v3 = 1/(4*omega1^2 - omega3^2)*a113*A_v1^2
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

/// What multiplies the 1 terms of the harmonic omega2+Omega of v3: functions of the frequencies alone. 11
/// operations.
template <class Scalar>
void factors_25([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  factor[0] = (omega1_2 - omega3_2) / (omega1_2 + Scalar(4.0) * omega1 * omega2 + Scalar(4.0) * omega2_2
      - omega3_2);
}

/// Rows of the harmonic omega2+Omega of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + Omega)*t) in v3 = (omega1^2 - omega3^2)/(omega1^2 + 4*omega1*omega2 + 4*omega2^2
/// - omega3^2)*harmonic_re_v3_conjA_v2_F*A_v2*F
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

/// What multiplies the 1 terms of the harmonic omega1+Omega of v3: functions of the frequencies alone. 11
/// operations.
template <class Scalar>
void factors_26([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  factor[0] = (omega2_2 - omega3_2) / (Scalar(4.0) * omega1_2 + Scalar(4.0) * omega1 * omega2 + omega2_2
      - omega3_2);
}

/// Rows of the harmonic omega1+Omega of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + Omega)*t) in v3 = (omega2^2 - omega3^2)/(4*omega1^2 + 4*omega1*omega2 + omega2^2
/// - omega3^2)*harmonic_re_v3_conjA_v1_F*A_v1*F
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
/// lumps[1]: conservative_v1_A_v1_A_v3_conjA_v3 = (4*omega1^6*omega3^2*b1133 - 8*omega1^6*a113*a333 -
/// 8*omega1^4*omega2^2*omega3^2*b1133 + 16*omega1^4*omega2^2*a113*a333 - 9*omega1^4*omega3^4*b1133 -
/// 4*omega1^4*omega3^2*a113^2 + 18*omega1^4*omega3^2*a113*a333 + 4*omega1^4*omega3^2*a123^2 +
/// 4*omega1^2*omega2^4*omega3^2*b1133 - 8*omega1^2*omega2^4*a113*a333 - 6*omega1^2*omega2^2*omega3^4*b1133 +
/// 8*omega1^2*omega2^2*omega3^2*a113^2 + 12*omega1^2*omega2^2*omega3^2*a113*a333 -
/// 4*omega1^2*omega2^2*omega3^2*a123^2 + 6*omega1^2*omega3^6*b1133 + 8*omega1^2*omega3^4*a113^2 -
/// 12*omega1^2*omega3^4*a113*a333 + 3*omega1^2*omega3^4*a123^2 - omega2^4*omega3^4*b1133 -
/// 4*omega2^4*omega3^2*a113^2 + 2*omega2^4*omega3^2*a113*a333 + 2*omega2^2*omega3^6*b1133 +
/// 8*omega2^2*omega3^4*a113^2 - 4*omega2^2*omega3^4*a113*a333 + omega2^2*omega3^4*a123^2 - omega3^8*b1133 -
/// 4*omega3^6*a113^2 + 2*omega3^6*a113*a333 - omega3^6*a123^2)/(4*omega1^7*omega3^2 -
/// 8*omega1^5*omega2^2*omega3^2 - 9*omega1^5*omega3^4 + 4*omega1^3*omega2^4*omega3^2 -
/// 6*omega1^3*omega2^2*omega3^4 + 6*omega1^3*omega3^6 - omega1*omega2^4*omega3^4 + 2*omega1*omega2^2*omega3^6 -
/// omega1*omega3^8)
/// lumps[2]: conservative_v1_A_v1_A_v2_conjA_v2 = (omega1^4*omega3^2*b1122 - 2*omega1^4*a113*a223 -
/// 2*omega1^2*omega2^2*omega3^2*b1122 + 4*omega1^2*omega2^2*a113*a223 - 2*omega1^2*omega3^4*b1122 +
/// 4*omega1^2*omega3^2*a113*a223 + omega1^2*omega3^2*a123^2 + omega2^4*omega3^2*b1122 - 2*omega2^4*a113*a223 -
/// 2*omega2^2*omega3^4*b1122 + 4*omega2^2*omega3^2*a113*a223 + omega2^2*omega3^2*a123^2 + omega3^6*b1122 -
/// 2*omega3^4*a113*a223 - omega3^4*a123^2)/(omega1^5*omega3^2 - 2*omega1^3*omega2^2*omega3^2 -
/// 2*omega1^3*omega3^4 + omega1*omega2^4*omega3^2 - 2*omega1*omega2^2*omega3^4 + omega1*omega3^6)
/// lumps[3]: conservative_v1_A_v12_conjA_v1 = (12*omega1^2*omega3^2*b1111 - 16*omega1^2*a113^2 -
/// 3*omega3^4*b1111 + 6*omega3^2*a113^2)/(8*omega1^3*omega3^2 - 2*omega1*omega3^4)
/// lumps[4]: mu2 = mu2
/// lumps[5]: conservative_v2_A_v2_A_v3_conjA_v3 = (4*omega1^4*omega2^2*omega3^2*b2233 -
/// 8*omega1^4*omega2^2*a223*a333 - omega1^4*omega3^4*b2233 - 4*omega1^4*omega3^2*a223^2 +
/// 2*omega1^4*omega3^2*a223*a333 - 8*omega1^2*omega2^4*omega3^2*b2233 + 16*omega1^2*omega2^4*a223*a333 -
/// 6*omega1^2*omega2^2*omega3^4*b2233 - 4*omega1^2*omega2^2*omega3^2*a123^2 +
/// 8*omega1^2*omega2^2*omega3^2*a223^2 + 12*omega1^2*omega2^2*omega3^2*a223*a333 + 2*omega1^2*omega3^6*b2233 +
/// omega1^2*omega3^4*a123^2 + 8*omega1^2*omega3^4*a223^2 - 4*omega1^2*omega3^4*a223*a333 +
/// 4*omega2^6*omega3^2*b2233 - 8*omega2^6*a223*a333 - 9*omega2^4*omega3^4*b2233 + 4*omega2^4*omega3^2*a123^2 -
/// 4*omega2^4*omega3^2*a223^2 + 18*omega2^4*omega3^2*a223*a333 + 6*omega2^2*omega3^6*b2233 +
/// 3*omega2^2*omega3^4*a123^2 + 8*omega2^2*omega3^4*a223^2 - 12*omega2^2*omega3^4*a223*a333 - omega3^8*b2233 -
/// omega3^6*a123^2 - 4*omega3^6*a223^2 + 2*omega3^6*a223*a333)/(4*omega1^4*omega2^3*omega3^2 -
/// omega1^4*omega2*omega3^4 - 8*omega1^2*omega2^5*omega3^2 - 6*omega1^2*omega2^3*omega3^4 +
/// 2*omega1^2*omega2*omega3^6 + 4*omega2^7*omega3^2 - 9*omega2^5*omega3^4 + 6*omega2^3*omega3^6 -
/// omega2*omega3^8)
/// lumps[6]: conservative_v2_A_v22_conjA_v2 = (12*omega2^2*omega3^2*b2222 - 16*omega2^2*a223^2 -
/// 3*omega3^4*b2222 + 6*omega3^2*a223^2)/(8*omega2^3*omega3^2 - 2*omega2*omega3^4)
/// lumps[7]: mu3 = mu3
/// lumps[8]: conservative_v3_A_v32_conjA_v3 = -5*a333^2/(3*omega3^3)
/// lumps[9]: a113 = a113
/// lumps[10]: a123 = a123
/// lumps[11]: harmonic_re_v1_A_v2_conjA_v12 = (9*omega1^2*a113*a123 - 2*omega1*omega2*a113*a123 +
/// omega2^2*a113*a123 - 3*omega3^2*a113*a123)/(12*omega1^6 - 40*omega1^5*omega2 + 48*omega1^4*omega2^2 -
/// 15*omega1^4*omega3^2 - 24*omega1^3*omega2^3 + 26*omega1^3*omega2*omega3^2 + 4*omega1^2*omega2^4 -
/// 16*omega1^2*omega2^2*omega3^2 + 3*omega1^2*omega3^4 + 6*omega1*omega2^3*omega3^2 - 4*omega1*omega2*omega3^4 -
/// omega2^4*omega3^2 + omega2^2*omega3^4)
/// lumps[12]: harmonic_re_v1_A_v32_conjA_v1 = (-6*omega1^3*omega3^2*b1133 - 4*omega1^3*a113*a333 +
/// 15*omega1^2*omega3^3*b1133 + 12*omega1^2*omega3*a113^2 + 10*omega1^2*omega3*a113*a333 +
/// 6*omega1*omega2^2*omega3^2*b1133 + 4*omega1*omega2^2*a113*a333 - 12*omega1*omega3^4*b1133 -
/// 24*omega1*omega3^2*a113^2 - 8*omega1*omega3^2*a113*a333 - 6*omega1*omega3^2*a123^2 -
/// 3*omega2^2*omega3^3*b1133 - 12*omega2^2*omega3*a113^2 - 2*omega2^2*omega3*a113*a333 + 3*omega3^5*b1133 +
/// 12*omega3^3*a113^2 + 2*omega3^3*a113*a333 + 3*omega3^3*a123^2)/(24*omega1^4*omega3^3 - 84*omega1^3*omega3^4 -
/// 24*omega1^2*omega2^2*omega3^3 + 108*omega1^2*omega3^5 + 36*omega1*omega2^2*omega3^4 - 60*omega1*omega3^6 -
/// 12*omega2^2*omega3^5 + 12*omega3^7)
/// lumps[13]: harmonic_re_v1_A_v22_conjA_v1 = (-4*omega1^2*omega2^2*b1122 + omega1^2*omega3^2*b1122 -
/// 2*omega1^2*a113*a223 + 8*omega1*omega2^3*b1122 - 2*omega1*omega2*omega3^2*b1122 + 4*omega1*omega2*a113*a223 -
/// 4*omega2^4*b1122 + 5*omega2^2*omega3^2*b1122 - 2*omega2^2*a113*a223 - 4*omega2^2*a123^2 - omega3^4*b1122 +
/// 2*omega3^2*a113*a223 + omega3^2*a123^2)/(16*omega1^3*omega2^3 - 4*omega1^3*omega2*omega3^2 -
/// 48*omega1^2*omega2^4 + 12*omega1^2*omega2^2*omega3^2 + 48*omega1*omega2^5 - 28*omega1*omega2^3*omega3^2 +
/// 4*omega1*omega2*omega3^4 - 16*omega2^6 + 20*omega2^4*omega3^2 - 4*omega2^2*omega3^4)
/// lumps[14]: harmonic_re_v1_A_v32_conjA_v2 = (-2*omega1^2*omega2*a123*a333 + 6*omega1^2*omega3*a123*a223 +
/// omega1^2*omega3*a123*a333 + 2*omega2^3*a123*a333 - 6*omega2^2*omega3*a123*a223 - 5*omega2^2*omega3*a123*a333
/// + 12*omega2*omega3^2*a113*a123 + 12*omega2*omega3^2*a123*a223 + 4*omega2*omega3^2*a123*a333 -
/// 6*omega3^3*a113*a123 - 6*omega3^3*a123*a223 - omega3^3*a123*a333)/(6*omega1^4*omega2*omega3^2 -
/// 3*omega1^4*omega3^3 - 12*omega1^2*omega2^3*omega3^2 + 42*omega1^2*omega2^2*omega3^3 -
/// 48*omega1^2*omega2*omega3^4 + 15*omega1^2*omega3^5 + 6*omega2^5*omega3^2 - 39*omega2^4*omega3^3 +
/// 96*omega2^3*omega3^4 - 111*omega2^2*omega3^5 + 60*omega2*omega3^6 - 12*omega3^7)
/// lumps[15]: harmonic_re_v1_A_v2_A_v3_conjA_v3 = (8*omega1^4*omega2^2*a123*a333 + 4*omega1^4*omega3^2*a123*a223
/// - 2*omega1^4*omega3^2*a123*a333 - 16*omega1^2*omega2^4*a123*a333 + 16*omega1^2*omega2^2*omega3^2*a113*a123 -
/// 8*omega1^2*omega2^2*omega3^2*a123*a223 - 12*omega1^2*omega2^2*omega3^2*a123*a333 -
/// 4*omega1^2*omega3^4*a113*a123 - 8*omega1^2*omega3^4*a123*a223 + 4*omega1^2*omega3^4*a123*a333 +
/// 8*omega2^6*a123*a333 - 16*omega2^4*omega3^2*a113*a123 + 4*omega2^4*omega3^2*a123*a223 -
/// 18*omega2^4*omega3^2*a123*a333 - 12*omega2^2*omega3^4*a113*a123 - 8*omega2^2*omega3^4*a123*a223 +
/// 12*omega2^2*omega3^4*a123*a333 + 4*omega3^6*a113*a123 + 4*omega3^6*a123*a223 -
/// 2*omega3^6*a123*a333)/(4*omega1^6*omega2^2*omega3^2 - omega1^6*omega3^4 - 12*omega1^4*omega2^4*omega3^2 -
/// 5*omega1^4*omega2^2*omega3^4 + 2*omega1^4*omega3^6 + 12*omega1^2*omega2^6*omega3^2 -
/// 3*omega1^2*omega2^4*omega3^4 + 4*omega1^2*omega2^2*omega3^6 - omega1^2*omega3^8 - 4*omega2^8*omega3^2 +
/// 9*omega2^6*omega3^4 - 6*omega2^4*omega3^6 + omega2^2*omega3^8)
/// lumps[16]: harmonic_re_v1_A_v22_conjA_v2 = (8*omega2^2*a123*a223 -
/// 3*omega3^2*a123*a223)/(4*omega1^2*omega2^2*omega3^2 - omega1^2*omega3^4 - 4*omega2^4*omega3^2 +
/// omega2^2*omega3^4)
/// lumps[17]: harmonic_re_v1_A_v2_A_v32 = (-2*omega1^2*omega2*a123*a333 - 6*omega1^2*omega3*a123*a223 -
/// omega1^2*omega3*a123*a333 + 2*omega2^3*a123*a333 + 6*omega2^2*omega3*a123*a223 + 5*omega2^2*omega3*a123*a333
/// + 12*omega2*omega3^2*a113*a123 + 12*omega2*omega3^2*a123*a223 + 4*omega2*omega3^2*a123*a333 +
/// 6*omega3^3*a113*a123 + 6*omega3^3*a123*a223 + omega3^3*a123*a333)/(6*omega1^4*omega2*omega3^2 +
/// 3*omega1^4*omega3^3 - 12*omega1^2*omega2^3*omega3^2 - 42*omega1^2*omega2^2*omega3^3 -
/// 48*omega1^2*omega2*omega3^4 - 15*omega1^2*omega3^5 + 6*omega2^5*omega3^2 + 39*omega2^4*omega3^3 +
/// 96*omega2^3*omega3^4 + 111*omega2^2*omega3^5 + 60*omega2*omega3^6 + 12*omega3^7)
/// lumps[18]: harmonic_re_v1_A_v1_A_v32 = (6*omega1^3*omega3^2*b1133 + 4*omega1^3*a113*a333 +
/// 15*omega1^2*omega3^3*b1133 + 12*omega1^2*omega3*a113^2 + 10*omega1^2*omega3*a113*a333 -
/// 6*omega1*omega2^2*omega3^2*b1133 - 4*omega1*omega2^2*a113*a333 + 12*omega1*omega3^4*b1133 +
/// 24*omega1*omega3^2*a113^2 + 8*omega1*omega3^2*a113*a333 + 6*omega1*omega3^2*a123^2 -
/// 3*omega2^2*omega3^3*b1133 - 12*omega2^2*omega3*a113^2 - 2*omega2^2*omega3*a113*a333 + 3*omega3^5*b1133 +
/// 12*omega3^3*a113^2 + 2*omega3^3*a113*a333 + 3*omega3^3*a123^2)/(24*omega1^4*omega3^3 + 84*omega1^3*omega3^4 -
/// 24*omega1^2*omega2^2*omega3^3 + 108*omega1^2*omega3^5 - 36*omega1*omega2^2*omega3^4 + 60*omega1*omega3^6 -
/// 12*omega2^2*omega3^5 + 12*omega3^7)
/// lumps[19]: harmonic_re_v1_A_v1_A_v22 = (4*omega1^2*omega2^2*b1122 - omega1^2*omega3^2*b1122 +
/// 2*omega1^2*a113*a223 + 8*omega1*omega2^3*b1122 - 2*omega1*omega2*omega3^2*b1122 + 4*omega1*omega2*a113*a223 +
/// 4*omega2^4*b1122 - 5*omega2^2*omega3^2*b1122 + 2*omega2^2*a113*a223 + 4*omega2^2*a123^2 + omega3^4*b1122 -
/// 2*omega3^2*a113*a223 - omega3^2*a123^2)/(16*omega1^3*omega2^3 - 4*omega1^3*omega2*omega3^2 +
/// 48*omega1^2*omega2^4 - 12*omega1^2*omega2^2*omega3^2 + 48*omega1*omega2^5 - 28*omega1*omega2^3*omega3^2 +
/// 4*omega1*omega2*omega3^4 + 16*omega2^6 - 20*omega2^4*omega3^2 + 4*omega2^2*omega3^4)
/// lumps[20]: harmonic_re_v1_A_v13 = (4*omega1^2*b1111 - omega3^2*b1111 + 2*a113^2)/(32*omega1^4 -
/// 8*omega1^2*omega3^2)
/// lumps[21]: a223 = a223
/// lumps[22]: harmonic_re_v2_A_v2_conjA_v12 = (4*omega1^4*b1122 - 8*omega1^3*omega2*b1122 +
/// 4*omega1^2*omega2^2*b1122 - 5*omega1^2*omega3^2*b1122 + 2*omega1^2*a113*a223 + 4*omega1^2*a123^2 +
/// 2*omega1*omega2*omega3^2*b1122 - 4*omega1*omega2*a113*a223 - omega2^2*omega3^2*b1122 + 2*omega2^2*a113*a223 +
/// omega3^4*b1122 - 2*omega3^2*a113*a223 - omega3^2*a123^2)/(16*omega1^6 - 48*omega1^5*omega2 +
/// 48*omega1^4*omega2^2 - 20*omega1^4*omega3^2 - 16*omega1^3*omega2^3 + 28*omega1^3*omega2*omega3^2 -
/// 12*omega1^2*omega2^2*omega3^2 + 4*omega1^2*omega3^4 + 4*omega1*omega2^3*omega3^2 - 4*omega1*omega2*omega3^4)
/// lumps[23]: harmonic_re_v2_A_v32_conjA_v1 = (2*omega1^3*a123*a333 - 6*omega1^2*omega3*a113*a123 -
/// 5*omega1^2*omega3*a123*a333 - 2*omega1*omega2^2*a123*a333 + 12*omega1*omega3^2*a113*a123 +
/// 12*omega1*omega3^2*a123*a223 + 4*omega1*omega3^2*a123*a333 + 6*omega2^2*omega3*a113*a123 +
/// omega2^2*omega3*a123*a333 - 6*omega3^3*a113*a123 - 6*omega3^3*a123*a223 -
/// omega3^3*a123*a333)/(6*omega1^5*omega3^2 - 39*omega1^4*omega3^3 - 12*omega1^3*omega2^2*omega3^2 +
/// 96*omega1^3*omega3^4 + 42*omega1^2*omega2^2*omega3^3 - 111*omega1^2*omega3^5 + 6*omega1*omega2^4*omega3^2 -
/// 48*omega1*omega2^2*omega3^4 + 60*omega1*omega3^6 - 3*omega2^4*omega3^3 + 15*omega2^2*omega3^5 - 12*omega3^7)
/// lumps[24]: harmonic_re_v2_A_v32_conjA_v2 = (-6*omega1^2*omega2*omega3^2*b2233 - 4*omega1^2*omega2*a223*a333 +
/// 3*omega1^2*omega3^3*b2233 + 12*omega1^2*omega3*a223^2 + 2*omega1^2*omega3*a223*a333 +
/// 6*omega2^3*omega3^2*b2233 + 4*omega2^3*a223*a333 - 15*omega2^2*omega3^3*b2233 - 12*omega2^2*omega3*a223^2 -
/// 10*omega2^2*omega3*a223*a333 + 12*omega2*omega3^4*b2233 + 6*omega2*omega3^2*a123^2 +
/// 24*omega2*omega3^2*a223^2 + 8*omega2*omega3^2*a223*a333 - 3*omega3^5*b2233 - 3*omega3^3*a123^2 -
/// 12*omega3^3*a223^2 - 2*omega3^3*a223*a333)/(24*omega1^2*omega2^2*omega3^3 - 36*omega1^2*omega2*omega3^4 +
/// 12*omega1^2*omega3^5 - 24*omega2^4*omega3^3 + 84*omega2^3*omega3^4 - 108*omega2^2*omega3^5 +
/// 60*omega2*omega3^6 - 12*omega3^7)
/// lumps[25]: harmonic_re_v2_A_v2_A_v32 = (6*omega1^2*omega2*omega3^2*b2233 + 4*omega1^2*omega2*a223*a333 +
/// 3*omega1^2*omega3^3*b2233 + 12*omega1^2*omega3*a223^2 + 2*omega1^2*omega3*a223*a333 -
/// 6*omega2^3*omega3^2*b2233 - 4*omega2^3*a223*a333 - 15*omega2^2*omega3^3*b2233 - 12*omega2^2*omega3*a223^2 -
/// 10*omega2^2*omega3*a223*a333 - 12*omega2*omega3^4*b2233 - 6*omega2*omega3^2*a123^2 -
/// 24*omega2*omega3^2*a223^2 - 8*omega2*omega3^2*a223*a333 - 3*omega3^5*b2233 - 3*omega3^3*a123^2 -
/// 12*omega3^3*a223^2 - 2*omega3^3*a223*a333)/(24*omega1^2*omega2^2*omega3^3 + 36*omega1^2*omega2*omega3^4 +
/// 12*omega1^2*omega3^5 - 24*omega2^4*omega3^3 - 84*omega2^3*omega3^4 - 108*omega2^2*omega3^5 -
/// 60*omega2*omega3^6 - 12*omega3^7)
/// lumps[26]: harmonic_re_v2_A_v23 = (4*omega2^2*b2222 - omega3^2*b2222 + 2*a223^2)/(32*omega2^4 -
/// 8*omega2^2*omega3^2)
/// lumps[27]: harmonic_re_v2_A_v1_A_v3_conjA_v3 = (-8*omega1^6*a123*a333 + 16*omega1^4*omega2^2*a123*a333 -
/// 4*omega1^4*omega3^2*a113*a123 + 16*omega1^4*omega3^2*a123*a223 + 18*omega1^4*omega3^2*a123*a333 -
/// 8*omega1^2*omega2^4*a123*a333 + 8*omega1^2*omega2^2*omega3^2*a113*a123 -
/// 16*omega1^2*omega2^2*omega3^2*a123*a223 + 12*omega1^2*omega2^2*omega3^2*a123*a333 +
/// 8*omega1^2*omega3^4*a113*a123 + 12*omega1^2*omega3^4*a123*a223 - 12*omega1^2*omega3^4*a123*a333 -
/// 4*omega2^4*omega3^2*a113*a123 + 2*omega2^4*omega3^2*a123*a333 + 8*omega2^2*omega3^4*a113*a123 +
/// 4*omega2^2*omega3^4*a123*a223 - 4*omega2^2*omega3^4*a123*a333 - 4*omega3^6*a113*a123 - 4*omega3^6*a123*a223 +
/// 2*omega3^6*a123*a333)/(4*omega1^8*omega3^2 - 12*omega1^6*omega2^2*omega3^2 - 9*omega1^6*omega3^4 +
/// 12*omega1^4*omega2^4*omega3^2 + 3*omega1^4*omega2^2*omega3^4 + 6*omega1^4*omega3^6 -
/// 4*omega1^2*omega2^6*omega3^2 + 5*omega1^2*omega2^4*omega3^4 - 4*omega1^2*omega2^2*omega3^6 -
/// omega1^2*omega3^8 + omega2^6*omega3^4 - 2*omega2^4*omega3^6 + omega2^2*omega3^8)
/// lumps[28]: harmonic_re_v2_A_v1_A_v32 = (2*omega1^3*a123*a333 + 6*omega1^2*omega3*a113*a123 +
/// 5*omega1^2*omega3*a123*a333 - 2*omega1*omega2^2*a123*a333 + 12*omega1*omega3^2*a113*a123 +
/// 12*omega1*omega3^2*a123*a223 + 4*omega1*omega3^2*a123*a333 - 6*omega2^2*omega3*a113*a123 -
/// omega2^2*omega3*a123*a333 + 6*omega3^3*a113*a123 + 6*omega3^3*a123*a223 +
/// omega3^3*a123*a333)/(6*omega1^5*omega3^2 + 39*omega1^4*omega3^3 - 12*omega1^3*omega2^2*omega3^2 +
/// 96*omega1^3*omega3^4 - 42*omega1^2*omega2^2*omega3^3 + 111*omega1^2*omega3^5 + 6*omega1*omega2^4*omega3^2 -
/// 48*omega1*omega2^2*omega3^4 + 60*omega1*omega3^6 + 3*omega2^4*omega3^3 - 15*omega2^2*omega3^5 + 12*omega3^7)
/// lumps[29]: harmonic_re_v2_A_v12_A_v2 = (4*omega1^4*b1122 + 8*omega1^3*omega2*b1122 +
/// 4*omega1^2*omega2^2*b1122 - 5*omega1^2*omega3^2*b1122 + 2*omega1^2*a113*a223 + 4*omega1^2*a123^2 -
/// 2*omega1*omega2*omega3^2*b1122 + 4*omega1*omega2*a113*a223 - omega2^2*omega3^2*b1122 + 2*omega2^2*a113*a223 +
/// omega3^4*b1122 - 2*omega3^2*a113*a223 - omega3^2*a123^2)/(16*omega1^6 + 48*omega1^5*omega2 +
/// 48*omega1^4*omega2^2 - 20*omega1^4*omega3^2 + 16*omega1^3*omega2^3 - 28*omega1^3*omega2*omega3^2 -
/// 12*omega1^2*omega2^2*omega3^2 + 4*omega1^2*omega3^4 - 4*omega1*omega2^3*omega3^2 + 4*omega1*omega2*omega3^4)
/// lumps[30]: a333 = a333
/// lumps[31]: harmonic_re_v3_A_v3_conjA_v12 = (4*omega1^4*omega3*b1133 - 8*omega1^3*omega3^2*b1133 -
/// 8*omega1^3*a113^2 - 4*omega1^2*omega2^2*omega3*b1133 + 3*omega1^2*omega3^3*b1133 + 12*omega1^2*omega3*a113^2
/// + 2*omega1^2*omega3*a113*a333 + 4*omega1^2*omega3*a123^2 + 8*omega1*omega2^2*a113^2 + 2*omega1*omega3^4*b1133
/// - 4*omega1*omega3^2*a113*a333 + omega2^2*omega3^3*b1133 + 4*omega2^2*omega3*a113^2 -
/// 2*omega2^2*omega3*a113*a333 - omega3^5*b1133 - 4*omega3^3*a113^2 + 2*omega3^3*a113*a333 -
/// omega3^3*a123^2)/(16*omega1^6*omega3 - 48*omega1^5*omega3^2 - 16*omega1^4*omega2^2*omega3 +
/// 44*omega1^4*omega3^3 + 16*omega1^3*omega2^2*omega3^2 - 4*omega1^3*omega3^4 + 4*omega1^2*omega2^2*omega3^3 -
/// 12*omega1^2*omega3^5 - 4*omega1*omega2^2*omega3^4 + 4*omega1*omega3^6)
/// lumps[32]: harmonic_re_v3_A_v3_conjA_v1_conjA_v2 = (-4*omega1^5*a123*a223 - 4*omega1^4*omega2*a113*a123 +
/// 2*omega1^4*omega3*a113*a123 + 2*omega1^4*omega3*a123*a223 + 8*omega1^3*omega2^2*a123*a223 -
/// 8*omega1^3*omega2*omega3*a113*a123 + 8*omega1^3*omega2*omega3*a123*a223 + 8*omega1^3*omega2*omega3*a123*a333
/// + 4*omega1^3*omega3^2*a113*a123 + 4*omega1^3*omega3^2*a123*a223 - 4*omega1^3*omega3^2*a123*a333 +
/// 8*omega1^2*omega2^3*a113*a123 - 4*omega1^2*omega2^2*omega3*a113*a123 - 4*omega1^2*omega2^2*omega3*a123*a223 -
/// 16*omega1^2*omega2^2*omega3*a123*a333 + 12*omega1^2*omega2*omega3^2*a113*a123 +
/// 12*omega1^2*omega2*omega3^2*a123*a223 + 4*omega1^2*omega2*omega3^2*a123*a333 - 6*omega1^2*omega3^3*a113*a123
/// - 10*omega1^2*omega3^3*a123*a223 + 2*omega1^2*omega3^3*a123*a333 - 4*omega1*omega2^4*a123*a223 +
/// 8*omega1*omega2^3*omega3*a113*a123 - 8*omega1*omega2^3*omega3*a123*a223 + 8*omega1*omega2^3*omega3*a123*a333
/// + 12*omega1*omega2^2*omega3^2*a113*a123 + 12*omega1*omega2^2*omega3^2*a123*a223 +
/// 4*omega1*omega2^2*omega3^2*a123*a333 - 12*omega1*omega2*omega3^3*a123*a333 - 4*omega1*omega3^4*a113*a123 -
/// 4*omega1*omega3^4*a123*a223 + 4*omega1*omega3^4*a123*a333 - 4*omega2^5*a113*a123 +
/// 2*omega2^4*omega3*a113*a123 + 2*omega2^4*omega3*a123*a223 + 4*omega2^3*omega3^2*a113*a123 +
/// 4*omega2^3*omega3^2*a123*a223 - 4*omega2^3*omega3^2*a123*a333 - 10*omega2^2*omega3^3*a113*a123 -
/// 6*omega2^2*omega3^3*a123*a223 + 2*omega2^2*omega3^3*a123*a333 - 4*omega2*omega3^4*a113*a123 -
/// 4*omega2*omega3^4*a123*a223 + 4*omega2*omega3^4*a123*a333 + 4*omega3^5*a113*a123 + 4*omega3^5*a123*a223 -
/// 2*omega3^5*a123*a333)/(4*omega1^7*omega2*omega3 - 2*omega1^7*omega3^2 + 8*omega1^6*omega2^2*omega3 -
/// 14*omega1^6*omega2*omega3^2 + 5*omega1^6*omega3^3 - 4*omega1^5*omega2^3*omega3 -
/// 10*omega1^5*omega2^2*omega3^2 + 2*omega1^5*omega2*omega3^3 + 2*omega1^5*omega3^4 -
/// 16*omega1^4*omega2^4*omega3 + 26*omega1^4*omega2^3*omega3^2 - 21*omega1^4*omega2^2*omega3^3 +
/// 26*omega1^4*omega2*omega3^4 - 10*omega1^4*omega3^5 - 4*omega1^3*omega2^5*omega3 +
/// 26*omega1^3*omega2^4*omega3^2 - 36*omega1^3*omega2^3*omega3^3 + 36*omega1^3*omega2^2*omega3^4 -
/// 16*omega1^3*omega2*omega3^5 + 2*omega1^3*omega3^6 + 8*omega1^2*omega2^6*omega3 -
/// 10*omega1^2*omega2^5*omega3^2 - 21*omega1^2*omega2^4*omega3^3 + 36*omega1^2*omega2^3*omega3^4 -
/// 12*omega1^2*omega2^2*omega3^5 - 10*omega1^2*omega2*omega3^6 + 5*omega1^2*omega3^7 + 4*omega1*omega2^7*omega3
/// - 14*omega1*omega2^6*omega3^2 + 2*omega1*omega2^5*omega3^3 + 26*omega1*omega2^4*omega3^4 -
/// 16*omega1*omega2^3*omega3^5 - 10*omega1*omega2^2*omega3^6 + 10*omega1*omega2*omega3^7 - 2*omega1*omega3^8 -
/// 2*omega2^7*omega3^2 + 5*omega2^6*omega3^3 + 2*omega2^5*omega3^4 - 10*omega2^4*omega3^5 + 2*omega2^3*omega3^6
/// + 5*omega2^2*omega3^7 - 2*omega2*omega3^8)
/// lumps[33]: harmonic_re_v3_A_v2_A_v3_conjA_v1 = (4*omega1^5*a123*a223 - 4*omega1^4*omega2*a113*a123 -
/// 2*omega1^4*omega3*a113*a123 - 2*omega1^4*omega3*a123*a223 - 8*omega1^3*omega2^2*a123*a223 -
/// 8*omega1^3*omega2*omega3*a113*a123 + 8*omega1^3*omega2*omega3*a123*a223 + 8*omega1^3*omega2*omega3*a123*a333
/// - 4*omega1^3*omega3^2*a113*a123 - 4*omega1^3*omega3^2*a123*a223 + 4*omega1^3*omega3^2*a123*a333 +
/// 8*omega1^2*omega2^3*a113*a123 + 4*omega1^2*omega2^2*omega3*a113*a123 + 4*omega1^2*omega2^2*omega3*a123*a223 +
/// 16*omega1^2*omega2^2*omega3*a123*a333 + 12*omega1^2*omega2*omega3^2*a113*a123 +
/// 12*omega1^2*omega2*omega3^2*a123*a223 + 4*omega1^2*omega2*omega3^2*a123*a333 + 6*omega1^2*omega3^3*a113*a123
/// + 10*omega1^2*omega3^3*a123*a223 - 2*omega1^2*omega3^3*a123*a333 + 4*omega1*omega2^4*a123*a223 +
/// 8*omega1*omega2^3*omega3*a113*a123 - 8*omega1*omega2^3*omega3*a123*a223 + 8*omega1*omega2^3*omega3*a123*a333
/// - 12*omega1*omega2^2*omega3^2*a113*a123 - 12*omega1*omega2^2*omega3^2*a123*a223 -
/// 4*omega1*omega2^2*omega3^2*a123*a333 - 12*omega1*omega2*omega3^3*a123*a333 + 4*omega1*omega3^4*a113*a123 +
/// 4*omega1*omega3^4*a123*a223 - 4*omega1*omega3^4*a123*a333 - 4*omega2^5*a113*a123 -
/// 2*omega2^4*omega3*a113*a123 - 2*omega2^4*omega3*a123*a223 + 4*omega2^3*omega3^2*a113*a123 +
/// 4*omega2^3*omega3^2*a123*a223 - 4*omega2^3*omega3^2*a123*a333 + 10*omega2^2*omega3^3*a113*a123 +
/// 6*omega2^2*omega3^3*a123*a223 - 2*omega2^2*omega3^3*a123*a333 - 4*omega2*omega3^4*a113*a123 -
/// 4*omega2*omega3^4*a123*a223 + 4*omega2*omega3^4*a123*a333 - 4*omega3^5*a113*a123 - 4*omega3^5*a123*a223 +
/// 2*omega3^5*a123*a333)/(4*omega1^7*omega2*omega3 + 2*omega1^7*omega3^2 - 8*omega1^6*omega2^2*omega3 -
/// 14*omega1^6*omega2*omega3^2 - 5*omega1^6*omega3^3 - 4*omega1^5*omega2^3*omega3 +
/// 10*omega1^5*omega2^2*omega3^2 + 2*omega1^5*omega2*omega3^3 - 2*omega1^5*omega3^4 +
/// 16*omega1^4*omega2^4*omega3 + 26*omega1^4*omega2^3*omega3^2 + 21*omega1^4*omega2^2*omega3^3 +
/// 26*omega1^4*omega2*omega3^4 + 10*omega1^4*omega3^5 - 4*omega1^3*omega2^5*omega3 -
/// 26*omega1^3*omega2^4*omega3^2 - 36*omega1^3*omega2^3*omega3^3 - 36*omega1^3*omega2^2*omega3^4 -
/// 16*omega1^3*omega2*omega3^5 - 2*omega1^3*omega3^6 - 8*omega1^2*omega2^6*omega3 -
/// 10*omega1^2*omega2^5*omega3^2 + 21*omega1^2*omega2^4*omega3^3 + 36*omega1^2*omega2^3*omega3^4 +
/// 12*omega1^2*omega2^2*omega3^5 - 10*omega1^2*omega2*omega3^6 - 5*omega1^2*omega3^7 + 4*omega1*omega2^7*omega3
/// + 14*omega1*omega2^6*omega3^2 + 2*omega1*omega2^5*omega3^3 - 26*omega1*omega2^4*omega3^4 -
/// 16*omega1*omega2^3*omega3^5 + 10*omega1*omega2^2*omega3^6 + 10*omega1*omega2*omega3^7 + 2*omega1*omega3^8 -
/// 2*omega2^7*omega3^2 - 5*omega2^6*omega3^3 + 2*omega2^5*omega3^4 + 10*omega2^4*omega3^5 + 2*omega2^3*omega3^6
/// - 5*omega2^2*omega3^7 - 2*omega2*omega3^8)
/// lumps[34]: harmonic_re_v3_A_v22_conjA_v3 = (4*omega1^2*omega2^2*omega3*b2233 - 8*omega1^2*omega2*a223^2 -
/// omega1^2*omega3^3*b2233 - 4*omega1^2*omega3*a223^2 + 2*omega1^2*omega3*a223*a333 - 4*omega2^4*omega3*b2233 +
/// 8*omega2^3*omega3^2*b2233 + 8*omega2^3*a223^2 - 3*omega2^2*omega3^3*b2233 - 4*omega2^2*omega3*a123^2 -
/// 12*omega2^2*omega3*a223^2 - 2*omega2^2*omega3*a223*a333 - 2*omega2*omega3^4*b2233 +
/// 4*omega2*omega3^2*a223*a333 + omega3^5*b2233 + omega3^3*a123^2 + 4*omega3^3*a223^2 -
/// 2*omega3^3*a223*a333)/(16*omega1^2*omega2^4*omega3 - 16*omega1^2*omega2^3*omega3^2 -
/// 4*omega1^2*omega2^2*omega3^3 + 4*omega1^2*omega2*omega3^4 - 16*omega2^6*omega3 + 48*omega2^5*omega3^2 -
/// 44*omega2^4*omega3^3 + 4*omega2^3*omega3^4 + 12*omega2^2*omega3^5 - 4*omega2*omega3^6)
/// lumps[35]: harmonic_re_v3_A_v22_A_v3 = (4*omega1^2*omega2^2*omega3*b2233 + 8*omega1^2*omega2*a223^2 -
/// omega1^2*omega3^3*b2233 - 4*omega1^2*omega3*a223^2 + 2*omega1^2*omega3*a223*a333 - 4*omega2^4*omega3*b2233 -
/// 8*omega2^3*omega3^2*b2233 - 8*omega2^3*a223^2 - 3*omega2^2*omega3^3*b2233 - 4*omega2^2*omega3*a123^2 -
/// 12*omega2^2*omega3*a223^2 - 2*omega2^2*omega3*a223*a333 + 2*omega2*omega3^4*b2233 -
/// 4*omega2*omega3^2*a223*a333 + omega3^5*b2233 + omega3^3*a123^2 + 4*omega3^3*a223^2 -
/// 2*omega3^3*a223*a333)/(16*omega1^2*omega2^4*omega3 + 16*omega1^2*omega2^3*omega3^2 -
/// 4*omega1^2*omega2^2*omega3^3 - 4*omega1^2*omega2*omega3^4 - 16*omega2^6*omega3 - 48*omega2^5*omega3^2 -
/// 44*omega2^4*omega3^3 - 4*omega2^3*omega3^4 + 12*omega2^2*omega3^5 + 4*omega2*omega3^6)
/// lumps[36]: harmonic_re_v3_A_v1_A_v3_conjA_v2 = (-4*omega1^5*a123*a223 + 4*omega1^4*omega2*a113*a123 -
/// 2*omega1^4*omega3*a113*a123 - 2*omega1^4*omega3*a123*a223 + 8*omega1^3*omega2^2*a123*a223 -
/// 8*omega1^3*omega2*omega3*a113*a123 + 8*omega1^3*omega2*omega3*a123*a223 + 8*omega1^3*omega2*omega3*a123*a333
/// + 4*omega1^3*omega3^2*a113*a123 + 4*omega1^3*omega3^2*a123*a223 - 4*omega1^3*omega3^2*a123*a333 -
/// 8*omega1^2*omega2^3*a113*a123 + 4*omega1^2*omega2^2*omega3*a113*a123 + 4*omega1^2*omega2^2*omega3*a123*a223 +
/// 16*omega1^2*omega2^2*omega3*a123*a333 - 12*omega1^2*omega2*omega3^2*a113*a123 -
/// 12*omega1^2*omega2*omega3^2*a123*a223 - 4*omega1^2*omega2*omega3^2*a123*a333 + 6*omega1^2*omega3^3*a113*a123
/// + 10*omega1^2*omega3^3*a123*a223 - 2*omega1^2*omega3^3*a123*a333 - 4*omega1*omega2^4*a123*a223 +
/// 8*omega1*omega2^3*omega3*a113*a123 - 8*omega1*omega2^3*omega3*a123*a223 + 8*omega1*omega2^3*omega3*a123*a333
/// + 12*omega1*omega2^2*omega3^2*a113*a123 + 12*omega1*omega2^2*omega3^2*a123*a223 +
/// 4*omega1*omega2^2*omega3^2*a123*a333 - 12*omega1*omega2*omega3^3*a123*a333 - 4*omega1*omega3^4*a113*a123 -
/// 4*omega1*omega3^4*a123*a223 + 4*omega1*omega3^4*a123*a333 + 4*omega2^5*a113*a123 -
/// 2*omega2^4*omega3*a113*a123 - 2*omega2^4*omega3*a123*a223 - 4*omega2^3*omega3^2*a113*a123 -
/// 4*omega2^3*omega3^2*a123*a223 + 4*omega2^3*omega3^2*a123*a333 + 10*omega2^2*omega3^3*a113*a123 +
/// 6*omega2^2*omega3^3*a123*a223 - 2*omega2^2*omega3^3*a123*a333 + 4*omega2*omega3^4*a113*a123 +
/// 4*omega2*omega3^4*a123*a223 - 4*omega2*omega3^4*a123*a333 - 4*omega3^5*a113*a123 - 4*omega3^5*a123*a223 +
/// 2*omega3^5*a123*a333)/(4*omega1^7*omega2*omega3 - 2*omega1^7*omega3^2 - 8*omega1^6*omega2^2*omega3 +
/// 14*omega1^6*omega2*omega3^2 - 5*omega1^6*omega3^3 - 4*omega1^5*omega2^3*omega3 -
/// 10*omega1^5*omega2^2*omega3^2 + 2*omega1^5*omega2*omega3^3 + 2*omega1^5*omega3^4 +
/// 16*omega1^4*omega2^4*omega3 - 26*omega1^4*omega2^3*omega3^2 + 21*omega1^4*omega2^2*omega3^3 -
/// 26*omega1^4*omega2*omega3^4 + 10*omega1^4*omega3^5 - 4*omega1^3*omega2^5*omega3 +
/// 26*omega1^3*omega2^4*omega3^2 - 36*omega1^3*omega2^3*omega3^3 + 36*omega1^3*omega2^2*omega3^4 -
/// 16*omega1^3*omega2*omega3^5 + 2*omega1^3*omega3^6 - 8*omega1^2*omega2^6*omega3 +
/// 10*omega1^2*omega2^5*omega3^2 + 21*omega1^2*omega2^4*omega3^3 - 36*omega1^2*omega2^3*omega3^4 +
/// 12*omega1^2*omega2^2*omega3^5 + 10*omega1^2*omega2*omega3^6 - 5*omega1^2*omega3^7 + 4*omega1*omega2^7*omega3
/// - 14*omega1*omega2^6*omega3^2 + 2*omega1*omega2^5*omega3^3 + 26*omega1*omega2^4*omega3^4 -
/// 16*omega1*omega2^3*omega3^5 - 10*omega1*omega2^2*omega3^6 + 10*omega1*omega2*omega3^7 - 2*omega1*omega3^8 +
/// 2*omega2^7*omega3^2 - 5*omega2^6*omega3^3 - 2*omega2^5*omega3^4 + 10*omega2^4*omega3^5 - 2*omega2^3*omega3^6
/// - 5*omega2^2*omega3^7 + 2*omega2*omega3^8)
/// lumps[37]: harmonic_re_v3_A_v1_A_v2_A_v3 = (4*omega1^5*a123*a223 + 4*omega1^4*omega2*a113*a123 +
/// 2*omega1^4*omega3*a113*a123 + 2*omega1^4*omega3*a123*a223 - 8*omega1^3*omega2^2*a123*a223 -
/// 8*omega1^3*omega2*omega3*a113*a123 + 8*omega1^3*omega2*omega3*a123*a223 + 8*omega1^3*omega2*omega3*a123*a333
/// - 4*omega1^3*omega3^2*a113*a123 - 4*omega1^3*omega3^2*a123*a223 + 4*omega1^3*omega3^2*a123*a333 -
/// 8*omega1^2*omega2^3*a113*a123 - 4*omega1^2*omega2^2*omega3*a113*a123 - 4*omega1^2*omega2^2*omega3*a123*a223 -
/// 16*omega1^2*omega2^2*omega3*a123*a333 - 12*omega1^2*omega2*omega3^2*a113*a123 -
/// 12*omega1^2*omega2*omega3^2*a123*a223 - 4*omega1^2*omega2*omega3^2*a123*a333 - 6*omega1^2*omega3^3*a113*a123
/// - 10*omega1^2*omega3^3*a123*a223 + 2*omega1^2*omega3^3*a123*a333 + 4*omega1*omega2^4*a123*a223 +
/// 8*omega1*omega2^3*omega3*a113*a123 - 8*omega1*omega2^3*omega3*a123*a223 + 8*omega1*omega2^3*omega3*a123*a333
/// - 12*omega1*omega2^2*omega3^2*a113*a123 - 12*omega1*omega2^2*omega3^2*a123*a223 -
/// 4*omega1*omega2^2*omega3^2*a123*a333 - 12*omega1*omega2*omega3^3*a123*a333 + 4*omega1*omega3^4*a113*a123 +
/// 4*omega1*omega3^4*a123*a223 - 4*omega1*omega3^4*a123*a333 + 4*omega2^5*a113*a123 +
/// 2*omega2^4*omega3*a113*a123 + 2*omega2^4*omega3*a123*a223 - 4*omega2^3*omega3^2*a113*a123 -
/// 4*omega2^3*omega3^2*a123*a223 + 4*omega2^3*omega3^2*a123*a333 - 10*omega2^2*omega3^3*a113*a123 -
/// 6*omega2^2*omega3^3*a123*a223 + 2*omega2^2*omega3^3*a123*a333 + 4*omega2*omega3^4*a113*a123 +
/// 4*omega2*omega3^4*a123*a223 - 4*omega2*omega3^4*a123*a333 + 4*omega3^5*a113*a123 + 4*omega3^5*a123*a223 -
/// 2*omega3^5*a123*a333)/(4*omega1^7*omega2*omega3 + 2*omega1^7*omega3^2 + 8*omega1^6*omega2^2*omega3 +
/// 14*omega1^6*omega2*omega3^2 + 5*omega1^6*omega3^3 - 4*omega1^5*omega2^3*omega3 +
/// 10*omega1^5*omega2^2*omega3^2 + 2*omega1^5*omega2*omega3^3 - 2*omega1^5*omega3^4 -
/// 16*omega1^4*omega2^4*omega3 - 26*omega1^4*omega2^3*omega3^2 - 21*omega1^4*omega2^2*omega3^3 -
/// 26*omega1^4*omega2*omega3^4 - 10*omega1^4*omega3^5 - 4*omega1^3*omega2^5*omega3 -
/// 26*omega1^3*omega2^4*omega3^2 - 36*omega1^3*omega2^3*omega3^3 - 36*omega1^3*omega2^2*omega3^4 -
/// 16*omega1^3*omega2*omega3^5 - 2*omega1^3*omega3^6 + 8*omega1^2*omega2^6*omega3 +
/// 10*omega1^2*omega2^5*omega3^2 - 21*omega1^2*omega2^4*omega3^3 - 36*omega1^2*omega2^3*omega3^4 -
/// 12*omega1^2*omega2^2*omega3^5 + 10*omega1^2*omega2*omega3^6 + 5*omega1^2*omega3^7 + 4*omega1*omega2^7*omega3
/// + 14*omega1*omega2^6*omega3^2 + 2*omega1*omega2^5*omega3^3 - 26*omega1*omega2^4*omega3^4 -
/// 16*omega1*omega2^3*omega3^5 + 10*omega1*omega2^2*omega3^6 + 10*omega1*omega2*omega3^7 + 2*omega1*omega3^8 +
/// 2*omega2^7*omega3^2 + 5*omega2^6*omega3^3 - 2*omega2^5*omega3^4 - 10*omega2^4*omega3^5 - 2*omega2^3*omega3^6
/// + 5*omega2^2*omega3^7 + 2*omega2*omega3^8)
/// lumps[38]: harmonic_re_v3_A_v12_A_v3 = (4*omega1^4*omega3*b1133 + 8*omega1^3*omega3^2*b1133 +
/// 8*omega1^3*a113^2 - 4*omega1^2*omega2^2*omega3*b1133 + 3*omega1^2*omega3^3*b1133 + 12*omega1^2*omega3*a113^2
/// + 2*omega1^2*omega3*a113*a333 + 4*omega1^2*omega3*a123^2 - 8*omega1*omega2^2*a113^2 - 2*omega1*omega3^4*b1133
/// + 4*omega1*omega3^2*a113*a333 + omega2^2*omega3^3*b1133 + 4*omega2^2*omega3*a113^2 -
/// 2*omega2^2*omega3*a113*a333 - omega3^5*b1133 - 4*omega3^3*a113^2 + 2*omega3^3*a113*a333 -
/// omega3^3*a123^2)/(16*omega1^6*omega3 + 48*omega1^5*omega3^2 - 16*omega1^4*omega2^2*omega3 +
/// 44*omega1^4*omega3^3 - 16*omega1^3*omega2^2*omega3^2 + 4*omega1^3*omega3^4 + 4*omega1^2*omega2^2*omega3^3 -
/// 12*omega1^2*omega3^5 + 4*omega1*omega2^2*omega3^4 - 4*omega1*omega3^6)
/// 3869 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
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
  const Scalar mu1 = parameters[13];
  const Scalar mu2 = parameters[15];
  const Scalar mu3 = parameters[17];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega1_6 = omega1_5 * omega1;
  const Scalar omega1_7 = omega1_6 * omega1;
  const Scalar omega1_8 = omega1_7 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar omega2_7 = omega2_6 * omega2;
  const Scalar omega2_8 = omega2_7 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar omega3_5 = omega3_4 * omega3;
  const Scalar omega3_6 = omega3_5 * omega3;
  const Scalar omega3_7 = omega3_6 * omega3;
  const Scalar omega3_8 = omega3_7 * omega3;
  const Scalar a113_2 = a113 * a113;
  const Scalar a123_2 = a123 * a123;
  const Scalar a223_2 = a223 * a223;
  const Scalar a333_2 = a333 * a333;
  lumps[0] = mu1;  // mu1
  // conservative_v1_A_v1_A_v3_conjA_v3
  lumps[1] = (Scalar(4.0) * omega1_6 * omega3_2 * b1133 - Scalar(8.0) * omega1_6 * a113 * a333
      - Scalar(8.0) * omega1_4 * omega2_2 * omega3_2 * b1133 + Scalar(16.0) * omega1_4 * omega2_2 * a113 * a333
      - Scalar(9.0) * omega1_4 * omega3_4 * b1133 - Scalar(4.0) * omega1_4 * omega3_2 * a113_2
      + Scalar(18.0) * omega1_4 * omega3_2 * a113 * a333 + Scalar(4.0) * omega1_4 * omega3_2 * a123_2
      + Scalar(4.0) * omega1_2 * omega2_4 * omega3_2 * b1133 - Scalar(8.0) * omega1_2 * omega2_4 * a113 * a333
      - Scalar(6.0) * omega1_2 * omega2_2 * omega3_4 * b1133
      + Scalar(8.0) * omega1_2 * omega2_2 * omega3_2 * a113_2
      + Scalar(12.0) * omega1_2 * omega2_2 * omega3_2 * a113 * a333
      - Scalar(4.0) * omega1_2 * omega2_2 * omega3_2 * a123_2 + Scalar(6.0) * omega1_2 * omega3_6 * b1133
      + Scalar(8.0) * omega1_2 * omega3_4 * a113_2 - Scalar(12.0) * omega1_2 * omega3_4 * a113 * a333
      + Scalar(3.0) * omega1_2 * omega3_4 * a123_2 - omega2_4 * omega3_4 * b1133
      - Scalar(4.0) * omega2_4 * omega3_2 * a113_2 + Scalar(2.0) * omega2_4 * omega3_2 * a113 * a333
      + Scalar(2.0) * omega2_2 * omega3_6 * b1133 + Scalar(8.0) * omega2_2 * omega3_4 * a113_2
      - Scalar(4.0) * omega2_2 * omega3_4 * a113 * a333 + omega2_2 * omega3_4 * a123_2 - omega3_8 * b1133
      - Scalar(4.0) * omega3_6 * a113_2 + Scalar(2.0) * omega3_6 * a113 * a333
      - omega3_6 * a123_2) / (Scalar(4.0) * omega1_7 * omega3_2 - Scalar(8.0) * omega1_5 * omega2_2 * omega3_2
      - Scalar(9.0) * omega1_5 * omega3_4 + Scalar(4.0) * omega1_3 * omega2_4 * omega3_2
      - Scalar(6.0) * omega1_3 * omega2_2 * omega3_4 + Scalar(6.0) * omega1_3 * omega3_6
      - omega1 * omega2_4 * omega3_4 + Scalar(2.0) * omega1 * omega2_2 * omega3_6 - omega1 * omega3_8);
  // conservative_v1_A_v1_A_v2_conjA_v2
  lumps[2] = (omega1_4 * omega3_2 * b1122 - Scalar(2.0) * omega1_4 * a113 * a223
      - Scalar(2.0) * omega1_2 * omega2_2 * omega3_2 * b1122 + Scalar(4.0) * omega1_2 * omega2_2 * a113 * a223
      - Scalar(2.0) * omega1_2 * omega3_4 * b1122 + Scalar(4.0) * omega1_2 * omega3_2 * a113 * a223
      + omega1_2 * omega3_2 * a123_2 + omega2_4 * omega3_2 * b1122 - Scalar(2.0) * omega2_4 * a113 * a223
      - Scalar(2.0) * omega2_2 * omega3_4 * b1122 + Scalar(4.0) * omega2_2 * omega3_2 * a113 * a223
      + omega2_2 * omega3_2 * a123_2 + omega3_6 * b1122 - Scalar(2.0) * omega3_4 * a113 * a223
      - omega3_4 * a123_2) / (omega1_5 * omega3_2 - Scalar(2.0) * omega1_3 * omega2_2 * omega3_2
      - Scalar(2.0) * omega1_3 * omega3_4 + omega1 * omega2_4 * omega3_2
      - Scalar(2.0) * omega1 * omega2_2 * omega3_4 + omega1 * omega3_6);
  // conservative_v1_A_v12_conjA_v1
  lumps[3] = (Scalar(12.0) * omega1_2 * omega3_2 * b1111 - Scalar(16.0) * omega1_2 * a113_2
      - Scalar(3.0) * omega3_4 * b1111 + Scalar(6.0) * omega3_2 * a113_2) / (Scalar(8.0) * omega1_3 * omega3_2
      - Scalar(2.0) * omega1 * omega3_4);
  lumps[4] = mu2;  // mu2
  // conservative_v2_A_v2_A_v3_conjA_v3
  lumps[5] = (Scalar(4.0) * omega1_4 * omega2_2 * omega3_2 * b2233
      - Scalar(8.0) * omega1_4 * omega2_2 * a223 * a333 - omega1_4 * omega3_4 * b2233
      - Scalar(4.0) * omega1_4 * omega3_2 * a223_2 + Scalar(2.0) * omega1_4 * omega3_2 * a223 * a333
      - Scalar(8.0) * omega1_2 * omega2_4 * omega3_2 * b2233 + Scalar(16.0) * omega1_2 * omega2_4 * a223 * a333
      - Scalar(6.0) * omega1_2 * omega2_2 * omega3_4 * b2233
      - Scalar(4.0) * omega1_2 * omega2_2 * omega3_2 * a123_2
      + Scalar(8.0) * omega1_2 * omega2_2 * omega3_2 * a223_2
      + Scalar(12.0) * omega1_2 * omega2_2 * omega3_2 * a223 * a333 + Scalar(2.0) * omega1_2 * omega3_6 * b2233
      + omega1_2 * omega3_4 * a123_2 + Scalar(8.0) * omega1_2 * omega3_4 * a223_2
      - Scalar(4.0) * omega1_2 * omega3_4 * a223 * a333 + Scalar(4.0) * omega2_6 * omega3_2 * b2233
      - Scalar(8.0) * omega2_6 * a223 * a333 - Scalar(9.0) * omega2_4 * omega3_4 * b2233
      + Scalar(4.0) * omega2_4 * omega3_2 * a123_2 - Scalar(4.0) * omega2_4 * omega3_2 * a223_2
      + Scalar(18.0) * omega2_4 * omega3_2 * a223 * a333 + Scalar(6.0) * omega2_2 * omega3_6 * b2233
      + Scalar(3.0) * omega2_2 * omega3_4 * a123_2 + Scalar(8.0) * omega2_2 * omega3_4 * a223_2
      - Scalar(12.0) * omega2_2 * omega3_4 * a223 * a333 - omega3_8 * b2233 - omega3_6 * a123_2
      - Scalar(4.0) * omega3_6 * a223_2
      + Scalar(2.0) * omega3_6 * a223 * a333) / (Scalar(4.0) * omega1_4 * omega2_3 * omega3_2
      - omega1_4 * omega2 * omega3_4 - Scalar(8.0) * omega1_2 * omega2_5 * omega3_2
      - Scalar(6.0) * omega1_2 * omega2_3 * omega3_4 + Scalar(2.0) * omega1_2 * omega2 * omega3_6
      + Scalar(4.0) * omega2_7 * omega3_2 - Scalar(9.0) * omega2_5 * omega3_4 + Scalar(6.0) * omega2_3 * omega3_6
      - omega2 * omega3_8);
  // conservative_v2_A_v22_conjA_v2
  lumps[6] = (Scalar(12.0) * omega2_2 * omega3_2 * b2222 - Scalar(16.0) * omega2_2 * a223_2
      - Scalar(3.0) * omega3_4 * b2222 + Scalar(6.0) * omega3_2 * a223_2) / (Scalar(8.0) * omega2_3 * omega3_2
      - Scalar(2.0) * omega2 * omega3_4);
  lumps[7] = mu3;  // mu3
  lumps[8] = -Scalar(5.0) * a333_2 / (Scalar(3.0) * omega3_3);  // conservative_v3_A_v32_conjA_v3
  lumps[9] = a113;  // a113
  lumps[10] = a123;  // a123
  // harmonic_re_v1_A_v2_conjA_v12
  lumps[11] = (Scalar(9.0) * omega1_2 * a113 * a123 - Scalar(2.0) * omega1 * omega2 * a113 * a123
      + omega2_2 * a113 * a123 - Scalar(3.0) * omega3_2 * a113 * a123) / (Scalar(12.0) * omega1_6
      - Scalar(40.0) * omega1_5 * omega2 + Scalar(48.0) * omega1_4 * omega2_2 - Scalar(15.0) * omega1_4 * omega3_2
      - Scalar(24.0) * omega1_3 * omega2_3 + Scalar(26.0) * omega1_3 * omega2 * omega3_2
      + Scalar(4.0) * omega1_2 * omega2_4 - Scalar(16.0) * omega1_2 * omega2_2 * omega3_2
      + Scalar(3.0) * omega1_2 * omega3_4 + Scalar(6.0) * omega1 * omega2_3 * omega3_2
      - Scalar(4.0) * omega1 * omega2 * omega3_4 - omega2_4 * omega3_2 + omega2_2 * omega3_4);
  // harmonic_re_v1_A_v32_conjA_v1
  lumps[12] = (-Scalar(6.0) * omega1_3 * omega3_2 * b1133 - Scalar(4.0) * omega1_3 * a113 * a333
      + Scalar(15.0) * omega1_2 * omega3_3 * b1133 + Scalar(12.0) * omega1_2 * omega3 * a113_2
      + Scalar(10.0) * omega1_2 * omega3 * a113 * a333 + Scalar(6.0) * omega1 * omega2_2 * omega3_2 * b1133
      + Scalar(4.0) * omega1 * omega2_2 * a113 * a333 - Scalar(12.0) * omega1 * omega3_4 * b1133
      - Scalar(24.0) * omega1 * omega3_2 * a113_2 - Scalar(8.0) * omega1 * omega3_2 * a113 * a333
      - Scalar(6.0) * omega1 * omega3_2 * a123_2 - Scalar(3.0) * omega2_2 * omega3_3 * b1133
      - Scalar(12.0) * omega2_2 * omega3 * a113_2 - Scalar(2.0) * omega2_2 * omega3 * a113 * a333
      + Scalar(3.0) * omega3_5 * b1133 + Scalar(12.0) * omega3_3 * a113_2 + Scalar(2.0) * omega3_3 * a113 * a333
      + Scalar(3.0) * omega3_3 * a123_2) / (Scalar(24.0) * omega1_4 * omega3_3
      - Scalar(84.0) * omega1_3 * omega3_4 - Scalar(24.0) * omega1_2 * omega2_2 * omega3_3
      + Scalar(108.0) * omega1_2 * omega3_5 + Scalar(36.0) * omega1 * omega2_2 * omega3_4
      - Scalar(60.0) * omega1 * omega3_6 - Scalar(12.0) * omega2_2 * omega3_5 + Scalar(12.0) * omega3_7);
  // harmonic_re_v1_A_v22_conjA_v1
  lumps[13] = (-Scalar(4.0) * omega1_2 * omega2_2 * b1122 + omega1_2 * omega3_2 * b1122
      - Scalar(2.0) * omega1_2 * a113 * a223 + Scalar(8.0) * omega1 * omega2_3 * b1122
      - Scalar(2.0) * omega1 * omega2 * omega3_2 * b1122 + Scalar(4.0) * omega1 * omega2 * a113 * a223
      - Scalar(4.0) * omega2_4 * b1122 + Scalar(5.0) * omega2_2 * omega3_2 * b1122
      - Scalar(2.0) * omega2_2 * a113 * a223 - Scalar(4.0) * omega2_2 * a123_2 - omega3_4 * b1122
      + Scalar(2.0) * omega3_2 * a113 * a223 + omega3_2 * a123_2) / (Scalar(16.0) * omega1_3 * omega2_3
      - Scalar(4.0) * omega1_3 * omega2 * omega3_2 - Scalar(48.0) * omega1_2 * omega2_4
      + Scalar(12.0) * omega1_2 * omega2_2 * omega3_2 + Scalar(48.0) * omega1 * omega2_5
      - Scalar(28.0) * omega1 * omega2_3 * omega3_2 + Scalar(4.0) * omega1 * omega2 * omega3_4
      - Scalar(16.0) * omega2_6 + Scalar(20.0) * omega2_4 * omega3_2 - Scalar(4.0) * omega2_2 * omega3_4);
  // harmonic_re_v1_A_v32_conjA_v2
  lumps[14] = (-Scalar(2.0) * omega1_2 * omega2 * a123 * a333 + Scalar(6.0) * omega1_2 * omega3 * a123 * a223
      + omega1_2 * omega3 * a123 * a333 + Scalar(2.0) * omega2_3 * a123 * a333
      - Scalar(6.0) * omega2_2 * omega3 * a123 * a223 - Scalar(5.0) * omega2_2 * omega3 * a123 * a333
      + Scalar(12.0) * omega2 * omega3_2 * a113 * a123 + Scalar(12.0) * omega2 * omega3_2 * a123 * a223
      + Scalar(4.0) * omega2 * omega3_2 * a123 * a333 - Scalar(6.0) * omega3_3 * a113 * a123
      - Scalar(6.0) * omega3_3 * a123 * a223
      - omega3_3 * a123 * a333) / (Scalar(6.0) * omega1_4 * omega2 * omega3_2 - Scalar(3.0) * omega1_4 * omega3_3
      - Scalar(12.0) * omega1_2 * omega2_3 * omega3_2 + Scalar(42.0) * omega1_2 * omega2_2 * omega3_3
      - Scalar(48.0) * omega1_2 * omega2 * omega3_4 + Scalar(15.0) * omega1_2 * omega3_5
      + Scalar(6.0) * omega2_5 * omega3_2 - Scalar(39.0) * omega2_4 * omega3_3
      + Scalar(96.0) * omega2_3 * omega3_4 - Scalar(111.0) * omega2_2 * omega3_5
      + Scalar(60.0) * omega2 * omega3_6 - Scalar(12.0) * omega3_7);
  // harmonic_re_v1_A_v2_A_v3_conjA_v3
  lumps[15] = (Scalar(8.0) * omega1_4 * omega2_2 * a123 * a333 + Scalar(4.0) * omega1_4 * omega3_2 * a123 * a223
      - Scalar(2.0) * omega1_4 * omega3_2 * a123 * a333 - Scalar(16.0) * omega1_2 * omega2_4 * a123 * a333
      + Scalar(16.0) * omega1_2 * omega2_2 * omega3_2 * a113 * a123
      - Scalar(8.0) * omega1_2 * omega2_2 * omega3_2 * a123 * a223
      - Scalar(12.0) * omega1_2 * omega2_2 * omega3_2 * a123 * a333
      - Scalar(4.0) * omega1_2 * omega3_4 * a113 * a123 - Scalar(8.0) * omega1_2 * omega3_4 * a123 * a223
      + Scalar(4.0) * omega1_2 * omega3_4 * a123 * a333 + Scalar(8.0) * omega2_6 * a123 * a333
      - Scalar(16.0) * omega2_4 * omega3_2 * a113 * a123 + Scalar(4.0) * omega2_4 * omega3_2 * a123 * a223
      - Scalar(18.0) * omega2_4 * omega3_2 * a123 * a333 - Scalar(12.0) * omega2_2 * omega3_4 * a113 * a123
      - Scalar(8.0) * omega2_2 * omega3_4 * a123 * a223 + Scalar(12.0) * omega2_2 * omega3_4 * a123 * a333
      + Scalar(4.0) * omega3_6 * a113 * a123 + Scalar(4.0) * omega3_6 * a123 * a223
      - Scalar(2.0) * omega3_6 * a123 * a333) / (Scalar(4.0) * omega1_6 * omega2_2 * omega3_2
      - omega1_6 * omega3_4 - Scalar(12.0) * omega1_4 * omega2_4 * omega3_2
      - Scalar(5.0) * omega1_4 * omega2_2 * omega3_4 + Scalar(2.0) * omega1_4 * omega3_6
      + Scalar(12.0) * omega1_2 * omega2_6 * omega3_2 - Scalar(3.0) * omega1_2 * omega2_4 * omega3_4
      + Scalar(4.0) * omega1_2 * omega2_2 * omega3_6 - omega1_2 * omega3_8 - Scalar(4.0) * omega2_8 * omega3_2
      + Scalar(9.0) * omega2_6 * omega3_4 - Scalar(6.0) * omega2_4 * omega3_6 + omega2_2 * omega3_8);
  // harmonic_re_v1_A_v22_conjA_v2
  lumps[16] = (Scalar(8.0) * omega2_2 * a123 * a223
      - Scalar(3.0) * omega3_2 * a123 * a223) / (Scalar(4.0) * omega1_2 * omega2_2 * omega3_2
      - omega1_2 * omega3_4 - Scalar(4.0) * omega2_4 * omega3_2 + omega2_2 * omega3_4);
  // harmonic_re_v1_A_v2_A_v32
  lumps[17] = (-Scalar(2.0) * omega1_2 * omega2 * a123 * a333 - Scalar(6.0) * omega1_2 * omega3 * a123 * a223
      - omega1_2 * omega3 * a123 * a333 + Scalar(2.0) * omega2_3 * a123 * a333
      + Scalar(6.0) * omega2_2 * omega3 * a123 * a223 + Scalar(5.0) * omega2_2 * omega3 * a123 * a333
      + Scalar(12.0) * omega2 * omega3_2 * a113 * a123 + Scalar(12.0) * omega2 * omega3_2 * a123 * a223
      + Scalar(4.0) * omega2 * omega3_2 * a123 * a333 + Scalar(6.0) * omega3_3 * a113 * a123
      + Scalar(6.0) * omega3_3 * a123 * a223
      + omega3_3 * a123 * a333) / (Scalar(6.0) * omega1_4 * omega2 * omega3_2 + Scalar(3.0) * omega1_4 * omega3_3
      - Scalar(12.0) * omega1_2 * omega2_3 * omega3_2 - Scalar(42.0) * omega1_2 * omega2_2 * omega3_3
      - Scalar(48.0) * omega1_2 * omega2 * omega3_4 - Scalar(15.0) * omega1_2 * omega3_5
      + Scalar(6.0) * omega2_5 * omega3_2 + Scalar(39.0) * omega2_4 * omega3_3
      + Scalar(96.0) * omega2_3 * omega3_4 + Scalar(111.0) * omega2_2 * omega3_5
      + Scalar(60.0) * omega2 * omega3_6 + Scalar(12.0) * omega3_7);
  // harmonic_re_v1_A_v1_A_v32
  lumps[18] = (Scalar(6.0) * omega1_3 * omega3_2 * b1133 + Scalar(4.0) * omega1_3 * a113 * a333
      + Scalar(15.0) * omega1_2 * omega3_3 * b1133 + Scalar(12.0) * omega1_2 * omega3 * a113_2
      + Scalar(10.0) * omega1_2 * omega3 * a113 * a333 - Scalar(6.0) * omega1 * omega2_2 * omega3_2 * b1133
      - Scalar(4.0) * omega1 * omega2_2 * a113 * a333 + Scalar(12.0) * omega1 * omega3_4 * b1133
      + Scalar(24.0) * omega1 * omega3_2 * a113_2 + Scalar(8.0) * omega1 * omega3_2 * a113 * a333
      + Scalar(6.0) * omega1 * omega3_2 * a123_2 - Scalar(3.0) * omega2_2 * omega3_3 * b1133
      - Scalar(12.0) * omega2_2 * omega3 * a113_2 - Scalar(2.0) * omega2_2 * omega3 * a113 * a333
      + Scalar(3.0) * omega3_5 * b1133 + Scalar(12.0) * omega3_3 * a113_2 + Scalar(2.0) * omega3_3 * a113 * a333
      + Scalar(3.0) * omega3_3 * a123_2) / (Scalar(24.0) * omega1_4 * omega3_3
      + Scalar(84.0) * omega1_3 * omega3_4 - Scalar(24.0) * omega1_2 * omega2_2 * omega3_3
      + Scalar(108.0) * omega1_2 * omega3_5 - Scalar(36.0) * omega1 * omega2_2 * omega3_4
      + Scalar(60.0) * omega1 * omega3_6 - Scalar(12.0) * omega2_2 * omega3_5 + Scalar(12.0) * omega3_7);
  // harmonic_re_v1_A_v1_A_v22
  lumps[19] = (Scalar(4.0) * omega1_2 * omega2_2 * b1122 - omega1_2 * omega3_2 * b1122
      + Scalar(2.0) * omega1_2 * a113 * a223 + Scalar(8.0) * omega1 * omega2_3 * b1122
      - Scalar(2.0) * omega1 * omega2 * omega3_2 * b1122 + Scalar(4.0) * omega1 * omega2 * a113 * a223
      + Scalar(4.0) * omega2_4 * b1122 - Scalar(5.0) * omega2_2 * omega3_2 * b1122
      + Scalar(2.0) * omega2_2 * a113 * a223 + Scalar(4.0) * omega2_2 * a123_2 + omega3_4 * b1122
      - Scalar(2.0) * omega3_2 * a113 * a223 - omega3_2 * a123_2) / (Scalar(16.0) * omega1_3 * omega2_3
      - Scalar(4.0) * omega1_3 * omega2 * omega3_2 + Scalar(48.0) * omega1_2 * omega2_4
      - Scalar(12.0) * omega1_2 * omega2_2 * omega3_2 + Scalar(48.0) * omega1 * omega2_5
      - Scalar(28.0) * omega1 * omega2_3 * omega3_2 + Scalar(4.0) * omega1 * omega2 * omega3_4
      + Scalar(16.0) * omega2_6 - Scalar(20.0) * omega2_4 * omega3_2 + Scalar(4.0) * omega2_2 * omega3_4);
  // harmonic_re_v1_A_v13
  lumps[20] = (Scalar(4.0) * omega1_2 * b1111 - omega3_2 * b1111
      + Scalar(2.0) * a113_2) / (Scalar(32.0) * omega1_4 - Scalar(8.0) * omega1_2 * omega3_2);
  lumps[21] = a223;  // a223
  // harmonic_re_v2_A_v2_conjA_v12
  lumps[22] = (Scalar(4.0) * omega1_4 * b1122 - Scalar(8.0) * omega1_3 * omega2 * b1122
      + Scalar(4.0) * omega1_2 * omega2_2 * b1122 - Scalar(5.0) * omega1_2 * omega3_2 * b1122
      + Scalar(2.0) * omega1_2 * a113 * a223 + Scalar(4.0) * omega1_2 * a123_2
      + Scalar(2.0) * omega1 * omega2 * omega3_2 * b1122 - Scalar(4.0) * omega1 * omega2 * a113 * a223
      - omega2_2 * omega3_2 * b1122 + Scalar(2.0) * omega2_2 * a113 * a223 + omega3_4 * b1122
      - Scalar(2.0) * omega3_2 * a113 * a223 - omega3_2 * a123_2) / (Scalar(16.0) * omega1_6
      - Scalar(48.0) * omega1_5 * omega2 + Scalar(48.0) * omega1_4 * omega2_2 - Scalar(20.0) * omega1_4 * omega3_2
      - Scalar(16.0) * omega1_3 * omega2_3 + Scalar(28.0) * omega1_3 * omega2 * omega3_2
      - Scalar(12.0) * omega1_2 * omega2_2 * omega3_2 + Scalar(4.0) * omega1_2 * omega3_4
      + Scalar(4.0) * omega1 * omega2_3 * omega3_2 - Scalar(4.0) * omega1 * omega2 * omega3_4);
  // harmonic_re_v2_A_v32_conjA_v1
  lumps[23] = (Scalar(2.0) * omega1_3 * a123 * a333 - Scalar(6.0) * omega1_2 * omega3 * a113 * a123
      - Scalar(5.0) * omega1_2 * omega3 * a123 * a333 - Scalar(2.0) * omega1 * omega2_2 * a123 * a333
      + Scalar(12.0) * omega1 * omega3_2 * a113 * a123 + Scalar(12.0) * omega1 * omega3_2 * a123 * a223
      + Scalar(4.0) * omega1 * omega3_2 * a123 * a333 + Scalar(6.0) * omega2_2 * omega3 * a113 * a123
      + omega2_2 * omega3 * a123 * a333 - Scalar(6.0) * omega3_3 * a113 * a123
      - Scalar(6.0) * omega3_3 * a123 * a223 - omega3_3 * a123 * a333) / (Scalar(6.0) * omega1_5 * omega3_2
      - Scalar(39.0) * omega1_4 * omega3_3 - Scalar(12.0) * omega1_3 * omega2_2 * omega3_2
      + Scalar(96.0) * omega1_3 * omega3_4 + Scalar(42.0) * omega1_2 * omega2_2 * omega3_3
      - Scalar(111.0) * omega1_2 * omega3_5 + Scalar(6.0) * omega1 * omega2_4 * omega3_2
      - Scalar(48.0) * omega1 * omega2_2 * omega3_4 + Scalar(60.0) * omega1 * omega3_6
      - Scalar(3.0) * omega2_4 * omega3_3 + Scalar(15.0) * omega2_2 * omega3_5 - Scalar(12.0) * omega3_7);
  // harmonic_re_v2_A_v32_conjA_v2
  lumps[24] = (-Scalar(6.0) * omega1_2 * omega2 * omega3_2 * b2233 - Scalar(4.0) * omega1_2 * omega2 * a223 * a333
      + Scalar(3.0) * omega1_2 * omega3_3 * b2233 + Scalar(12.0) * omega1_2 * omega3 * a223_2
      + Scalar(2.0) * omega1_2 * omega3 * a223 * a333 + Scalar(6.0) * omega2_3 * omega3_2 * b2233
      + Scalar(4.0) * omega2_3 * a223 * a333 - Scalar(15.0) * omega2_2 * omega3_3 * b2233
      - Scalar(12.0) * omega2_2 * omega3 * a223_2 - Scalar(10.0) * omega2_2 * omega3 * a223 * a333
      + Scalar(12.0) * omega2 * omega3_4 * b2233 + Scalar(6.0) * omega2 * omega3_2 * a123_2
      + Scalar(24.0) * omega2 * omega3_2 * a223_2 + Scalar(8.0) * omega2 * omega3_2 * a223 * a333
      - Scalar(3.0) * omega3_5 * b2233 - Scalar(3.0) * omega3_3 * a123_2 - Scalar(12.0) * omega3_3 * a223_2
      - Scalar(2.0) * omega3_3 * a223 * a333) / (Scalar(24.0) * omega1_2 * omega2_2 * omega3_3
      - Scalar(36.0) * omega1_2 * omega2 * omega3_4 + Scalar(12.0) * omega1_2 * omega3_5
      - Scalar(24.0) * omega2_4 * omega3_3 + Scalar(84.0) * omega2_3 * omega3_4
      - Scalar(108.0) * omega2_2 * omega3_5 + Scalar(60.0) * omega2 * omega3_6 - Scalar(12.0) * omega3_7);
  // harmonic_re_v2_A_v2_A_v32
  lumps[25] = (Scalar(6.0) * omega1_2 * omega2 * omega3_2 * b2233 + Scalar(4.0) * omega1_2 * omega2 * a223 * a333
      + Scalar(3.0) * omega1_2 * omega3_3 * b2233 + Scalar(12.0) * omega1_2 * omega3 * a223_2
      + Scalar(2.0) * omega1_2 * omega3 * a223 * a333 - Scalar(6.0) * omega2_3 * omega3_2 * b2233
      - Scalar(4.0) * omega2_3 * a223 * a333 - Scalar(15.0) * omega2_2 * omega3_3 * b2233
      - Scalar(12.0) * omega2_2 * omega3 * a223_2 - Scalar(10.0) * omega2_2 * omega3 * a223 * a333
      - Scalar(12.0) * omega2 * omega3_4 * b2233 - Scalar(6.0) * omega2 * omega3_2 * a123_2
      - Scalar(24.0) * omega2 * omega3_2 * a223_2 - Scalar(8.0) * omega2 * omega3_2 * a223 * a333
      - Scalar(3.0) * omega3_5 * b2233 - Scalar(3.0) * omega3_3 * a123_2 - Scalar(12.0) * omega3_3 * a223_2
      - Scalar(2.0) * omega3_3 * a223 * a333) / (Scalar(24.0) * omega1_2 * omega2_2 * omega3_3
      + Scalar(36.0) * omega1_2 * omega2 * omega3_4 + Scalar(12.0) * omega1_2 * omega3_5
      - Scalar(24.0) * omega2_4 * omega3_3 - Scalar(84.0) * omega2_3 * omega3_4
      - Scalar(108.0) * omega2_2 * omega3_5 - Scalar(60.0) * omega2 * omega3_6 - Scalar(12.0) * omega3_7);
  // harmonic_re_v2_A_v23
  lumps[26] = (Scalar(4.0) * omega2_2 * b2222 - omega3_2 * b2222
      + Scalar(2.0) * a223_2) / (Scalar(32.0) * omega2_4 - Scalar(8.0) * omega2_2 * omega3_2);
  // harmonic_re_v2_A_v1_A_v3_conjA_v3
  lumps[27] = (-Scalar(8.0) * omega1_6 * a123 * a333 + Scalar(16.0) * omega1_4 * omega2_2 * a123 * a333
      - Scalar(4.0) * omega1_4 * omega3_2 * a113 * a123 + Scalar(16.0) * omega1_4 * omega3_2 * a123 * a223
      + Scalar(18.0) * omega1_4 * omega3_2 * a123 * a333 - Scalar(8.0) * omega1_2 * omega2_4 * a123 * a333
      + Scalar(8.0) * omega1_2 * omega2_2 * omega3_2 * a113 * a123
      - Scalar(16.0) * omega1_2 * omega2_2 * omega3_2 * a123 * a223
      + Scalar(12.0) * omega1_2 * omega2_2 * omega3_2 * a123 * a333
      + Scalar(8.0) * omega1_2 * omega3_4 * a113 * a123 + Scalar(12.0) * omega1_2 * omega3_4 * a123 * a223
      - Scalar(12.0) * omega1_2 * omega3_4 * a123 * a333 - Scalar(4.0) * omega2_4 * omega3_2 * a113 * a123
      + Scalar(2.0) * omega2_4 * omega3_2 * a123 * a333 + Scalar(8.0) * omega2_2 * omega3_4 * a113 * a123
      + Scalar(4.0) * omega2_2 * omega3_4 * a123 * a223 - Scalar(4.0) * omega2_2 * omega3_4 * a123 * a333
      - Scalar(4.0) * omega3_6 * a113 * a123 - Scalar(4.0) * omega3_6 * a123 * a223
      + Scalar(2.0) * omega3_6 * a123 * a333) / (Scalar(4.0) * omega1_8 * omega3_2
      - Scalar(12.0) * omega1_6 * omega2_2 * omega3_2 - Scalar(9.0) * omega1_6 * omega3_4
      + Scalar(12.0) * omega1_4 * omega2_4 * omega3_2 + Scalar(3.0) * omega1_4 * omega2_2 * omega3_4
      + Scalar(6.0) * omega1_4 * omega3_6 - Scalar(4.0) * omega1_2 * omega2_6 * omega3_2
      + Scalar(5.0) * omega1_2 * omega2_4 * omega3_4 - Scalar(4.0) * omega1_2 * omega2_2 * omega3_6
      - omega1_2 * omega3_8 + omega2_6 * omega3_4 - Scalar(2.0) * omega2_4 * omega3_6 + omega2_2 * omega3_8);
  // harmonic_re_v2_A_v1_A_v32
  lumps[28] = (Scalar(2.0) * omega1_3 * a123 * a333 + Scalar(6.0) * omega1_2 * omega3 * a113 * a123
      + Scalar(5.0) * omega1_2 * omega3 * a123 * a333 - Scalar(2.0) * omega1 * omega2_2 * a123 * a333
      + Scalar(12.0) * omega1 * omega3_2 * a113 * a123 + Scalar(12.0) * omega1 * omega3_2 * a123 * a223
      + Scalar(4.0) * omega1 * omega3_2 * a123 * a333 - Scalar(6.0) * omega2_2 * omega3 * a113 * a123
      - omega2_2 * omega3 * a123 * a333 + Scalar(6.0) * omega3_3 * a113 * a123
      + Scalar(6.0) * omega3_3 * a123 * a223 + omega3_3 * a123 * a333) / (Scalar(6.0) * omega1_5 * omega3_2
      + Scalar(39.0) * omega1_4 * omega3_3 - Scalar(12.0) * omega1_3 * omega2_2 * omega3_2
      + Scalar(96.0) * omega1_3 * omega3_4 - Scalar(42.0) * omega1_2 * omega2_2 * omega3_3
      + Scalar(111.0) * omega1_2 * omega3_5 + Scalar(6.0) * omega1 * omega2_4 * omega3_2
      - Scalar(48.0) * omega1 * omega2_2 * omega3_4 + Scalar(60.0) * omega1 * omega3_6
      + Scalar(3.0) * omega2_4 * omega3_3 - Scalar(15.0) * omega2_2 * omega3_5 + Scalar(12.0) * omega3_7);
  // harmonic_re_v2_A_v12_A_v2
  lumps[29] = (Scalar(4.0) * omega1_4 * b1122 + Scalar(8.0) * omega1_3 * omega2 * b1122
      + Scalar(4.0) * omega1_2 * omega2_2 * b1122 - Scalar(5.0) * omega1_2 * omega3_2 * b1122
      + Scalar(2.0) * omega1_2 * a113 * a223 + Scalar(4.0) * omega1_2 * a123_2
      - Scalar(2.0) * omega1 * omega2 * omega3_2 * b1122 + Scalar(4.0) * omega1 * omega2 * a113 * a223
      - omega2_2 * omega3_2 * b1122 + Scalar(2.0) * omega2_2 * a113 * a223 + omega3_4 * b1122
      - Scalar(2.0) * omega3_2 * a113 * a223 - omega3_2 * a123_2) / (Scalar(16.0) * omega1_6
      + Scalar(48.0) * omega1_5 * omega2 + Scalar(48.0) * omega1_4 * omega2_2 - Scalar(20.0) * omega1_4 * omega3_2
      + Scalar(16.0) * omega1_3 * omega2_3 - Scalar(28.0) * omega1_3 * omega2 * omega3_2
      - Scalar(12.0) * omega1_2 * omega2_2 * omega3_2 + Scalar(4.0) * omega1_2 * omega3_4
      - Scalar(4.0) * omega1 * omega2_3 * omega3_2 + Scalar(4.0) * omega1 * omega2 * omega3_4);
  lumps[30] = a333;  // a333
  // harmonic_re_v3_A_v3_conjA_v12
  lumps[31] = (Scalar(4.0) * omega1_4 * omega3 * b1133 - Scalar(8.0) * omega1_3 * omega3_2 * b1133
      - Scalar(8.0) * omega1_3 * a113_2 - Scalar(4.0) * omega1_2 * omega2_2 * omega3 * b1133
      + Scalar(3.0) * omega1_2 * omega3_3 * b1133 + Scalar(12.0) * omega1_2 * omega3 * a113_2
      + Scalar(2.0) * omega1_2 * omega3 * a113 * a333 + Scalar(4.0) * omega1_2 * omega3 * a123_2
      + Scalar(8.0) * omega1 * omega2_2 * a113_2 + Scalar(2.0) * omega1 * omega3_4 * b1133
      - Scalar(4.0) * omega1 * omega3_2 * a113 * a333 + omega2_2 * omega3_3 * b1133
      + Scalar(4.0) * omega2_2 * omega3 * a113_2 - Scalar(2.0) * omega2_2 * omega3 * a113 * a333
      - omega3_5 * b1133 - Scalar(4.0) * omega3_3 * a113_2 + Scalar(2.0) * omega3_3 * a113 * a333
      - omega3_3 * a123_2) / (Scalar(16.0) * omega1_6 * omega3 - Scalar(48.0) * omega1_5 * omega3_2
      - Scalar(16.0) * omega1_4 * omega2_2 * omega3 + Scalar(44.0) * omega1_4 * omega3_3
      + Scalar(16.0) * omega1_3 * omega2_2 * omega3_2 - Scalar(4.0) * omega1_3 * omega3_4
      + Scalar(4.0) * omega1_2 * omega2_2 * omega3_3 - Scalar(12.0) * omega1_2 * omega3_5
      - Scalar(4.0) * omega1 * omega2_2 * omega3_4 + Scalar(4.0) * omega1 * omega3_6);
  // harmonic_re_v3_A_v3_conjA_v1_conjA_v2
  lumps[32] = (-Scalar(4.0) * omega1_5 * a123 * a223 - Scalar(4.0) * omega1_4 * omega2 * a113 * a123
      + Scalar(2.0) * omega1_4 * omega3 * a113 * a123 + Scalar(2.0) * omega1_4 * omega3 * a123 * a223
      + Scalar(8.0) * omega1_3 * omega2_2 * a123 * a223 - Scalar(8.0) * omega1_3 * omega2 * omega3 * a113 * a123
      + Scalar(8.0) * omega1_3 * omega2 * omega3 * a123 * a223
      + Scalar(8.0) * omega1_3 * omega2 * omega3 * a123 * a333 + Scalar(4.0) * omega1_3 * omega3_2 * a113 * a123
      + Scalar(4.0) * omega1_3 * omega3_2 * a123 * a223 - Scalar(4.0) * omega1_3 * omega3_2 * a123 * a333
      + Scalar(8.0) * omega1_2 * omega2_3 * a113 * a123 - Scalar(4.0) * omega1_2 * omega2_2 * omega3 * a113 * a123
      - Scalar(4.0) * omega1_2 * omega2_2 * omega3 * a123 * a223
      - Scalar(16.0) * omega1_2 * omega2_2 * omega3 * a123 * a333
      + Scalar(12.0) * omega1_2 * omega2 * omega3_2 * a113 * a123
      + Scalar(12.0) * omega1_2 * omega2 * omega3_2 * a123 * a223
      + Scalar(4.0) * omega1_2 * omega2 * omega3_2 * a123 * a333 - Scalar(6.0) * omega1_2 * omega3_3 * a113 * a123
      - Scalar(10.0) * omega1_2 * omega3_3 * a123 * a223 + Scalar(2.0) * omega1_2 * omega3_3 * a123 * a333
      - Scalar(4.0) * omega1 * omega2_4 * a123 * a223 + Scalar(8.0) * omega1 * omega2_3 * omega3 * a113 * a123
      - Scalar(8.0) * omega1 * omega2_3 * omega3 * a123 * a223
      + Scalar(8.0) * omega1 * omega2_3 * omega3 * a123 * a333
      + Scalar(12.0) * omega1 * omega2_2 * omega3_2 * a113 * a123
      + Scalar(12.0) * omega1 * omega2_2 * omega3_2 * a123 * a223
      + Scalar(4.0) * omega1 * omega2_2 * omega3_2 * a123 * a333
      - Scalar(12.0) * omega1 * omega2 * omega3_3 * a123 * a333 - Scalar(4.0) * omega1 * omega3_4 * a113 * a123
      - Scalar(4.0) * omega1 * omega3_4 * a123 * a223 + Scalar(4.0) * omega1 * omega3_4 * a123 * a333
      - Scalar(4.0) * omega2_5 * a113 * a123 + Scalar(2.0) * omega2_4 * omega3 * a113 * a123
      + Scalar(2.0) * omega2_4 * omega3 * a123 * a223 + Scalar(4.0) * omega2_3 * omega3_2 * a113 * a123
      + Scalar(4.0) * omega2_3 * omega3_2 * a123 * a223 - Scalar(4.0) * omega2_3 * omega3_2 * a123 * a333
      - Scalar(10.0) * omega2_2 * omega3_3 * a113 * a123 - Scalar(6.0) * omega2_2 * omega3_3 * a123 * a223
      + Scalar(2.0) * omega2_2 * omega3_3 * a123 * a333 - Scalar(4.0) * omega2 * omega3_4 * a113 * a123
      - Scalar(4.0) * omega2 * omega3_4 * a123 * a223 + Scalar(4.0) * omega2 * omega3_4 * a123 * a333
      + Scalar(4.0) * omega3_5 * a113 * a123 + Scalar(4.0) * omega3_5 * a123 * a223
      - Scalar(2.0) * omega3_5 * a123 * a333) / (Scalar(4.0) * omega1_7 * omega2 * omega3
      - Scalar(2.0) * omega1_7 * omega3_2 + Scalar(8.0) * omega1_6 * omega2_2 * omega3
      - Scalar(14.0) * omega1_6 * omega2 * omega3_2 + Scalar(5.0) * omega1_6 * omega3_3
      - Scalar(4.0) * omega1_5 * omega2_3 * omega3 - Scalar(10.0) * omega1_5 * omega2_2 * omega3_2
      + Scalar(2.0) * omega1_5 * omega2 * omega3_3 + Scalar(2.0) * omega1_5 * omega3_4
      - Scalar(16.0) * omega1_4 * omega2_4 * omega3 + Scalar(26.0) * omega1_4 * omega2_3 * omega3_2
      - Scalar(21.0) * omega1_4 * omega2_2 * omega3_3 + Scalar(26.0) * omega1_4 * omega2 * omega3_4
      - Scalar(10.0) * omega1_4 * omega3_5 - Scalar(4.0) * omega1_3 * omega2_5 * omega3
      + Scalar(26.0) * omega1_3 * omega2_4 * omega3_2 - Scalar(36.0) * omega1_3 * omega2_3 * omega3_3
      + Scalar(36.0) * omega1_3 * omega2_2 * omega3_4 - Scalar(16.0) * omega1_3 * omega2 * omega3_5
      + Scalar(2.0) * omega1_3 * omega3_6 + Scalar(8.0) * omega1_2 * omega2_6 * omega3
      - Scalar(10.0) * omega1_2 * omega2_5 * omega3_2 - Scalar(21.0) * omega1_2 * omega2_4 * omega3_3
      + Scalar(36.0) * omega1_2 * omega2_3 * omega3_4 - Scalar(12.0) * omega1_2 * omega2_2 * omega3_5
      - Scalar(10.0) * omega1_2 * omega2 * omega3_6 + Scalar(5.0) * omega1_2 * omega3_7
      + Scalar(4.0) * omega1 * omega2_7 * omega3 - Scalar(14.0) * omega1 * omega2_6 * omega3_2
      + Scalar(2.0) * omega1 * omega2_5 * omega3_3 + Scalar(26.0) * omega1 * omega2_4 * omega3_4
      - Scalar(16.0) * omega1 * omega2_3 * omega3_5 - Scalar(10.0) * omega1 * omega2_2 * omega3_6
      + Scalar(10.0) * omega1 * omega2 * omega3_7 - Scalar(2.0) * omega1 * omega3_8
      - Scalar(2.0) * omega2_7 * omega3_2 + Scalar(5.0) * omega2_6 * omega3_3 + Scalar(2.0) * omega2_5 * omega3_4
      - Scalar(10.0) * omega2_4 * omega3_5 + Scalar(2.0) * omega2_3 * omega3_6 + Scalar(5.0) * omega2_2 * omega3_7
      - Scalar(2.0) * omega2 * omega3_8);
  // harmonic_re_v3_A_v2_A_v3_conjA_v1
  lumps[33] = (Scalar(4.0) * omega1_5 * a123 * a223 - Scalar(4.0) * omega1_4 * omega2 * a113 * a123
      - Scalar(2.0) * omega1_4 * omega3 * a113 * a123 - Scalar(2.0) * omega1_4 * omega3 * a123 * a223
      - Scalar(8.0) * omega1_3 * omega2_2 * a123 * a223 - Scalar(8.0) * omega1_3 * omega2 * omega3 * a113 * a123
      + Scalar(8.0) * omega1_3 * omega2 * omega3 * a123 * a223
      + Scalar(8.0) * omega1_3 * omega2 * omega3 * a123 * a333 - Scalar(4.0) * omega1_3 * omega3_2 * a113 * a123
      - Scalar(4.0) * omega1_3 * omega3_2 * a123 * a223 + Scalar(4.0) * omega1_3 * omega3_2 * a123 * a333
      + Scalar(8.0) * omega1_2 * omega2_3 * a113 * a123 + Scalar(4.0) * omega1_2 * omega2_2 * omega3 * a113 * a123
      + Scalar(4.0) * omega1_2 * omega2_2 * omega3 * a123 * a223
      + Scalar(16.0) * omega1_2 * omega2_2 * omega3 * a123 * a333
      + Scalar(12.0) * omega1_2 * omega2 * omega3_2 * a113 * a123
      + Scalar(12.0) * omega1_2 * omega2 * omega3_2 * a123 * a223
      + Scalar(4.0) * omega1_2 * omega2 * omega3_2 * a123 * a333 + Scalar(6.0) * omega1_2 * omega3_3 * a113 * a123
      + Scalar(10.0) * omega1_2 * omega3_3 * a123 * a223 - Scalar(2.0) * omega1_2 * omega3_3 * a123 * a333
      + Scalar(4.0) * omega1 * omega2_4 * a123 * a223 + Scalar(8.0) * omega1 * omega2_3 * omega3 * a113 * a123
      - Scalar(8.0) * omega1 * omega2_3 * omega3 * a123 * a223
      + Scalar(8.0) * omega1 * omega2_3 * omega3 * a123 * a333
      - Scalar(12.0) * omega1 * omega2_2 * omega3_2 * a113 * a123
      - Scalar(12.0) * omega1 * omega2_2 * omega3_2 * a123 * a223
      - Scalar(4.0) * omega1 * omega2_2 * omega3_2 * a123 * a333
      - Scalar(12.0) * omega1 * omega2 * omega3_3 * a123 * a333 + Scalar(4.0) * omega1 * omega3_4 * a113 * a123
      + Scalar(4.0) * omega1 * omega3_4 * a123 * a223 - Scalar(4.0) * omega1 * omega3_4 * a123 * a333
      - Scalar(4.0) * omega2_5 * a113 * a123 - Scalar(2.0) * omega2_4 * omega3 * a113 * a123
      - Scalar(2.0) * omega2_4 * omega3 * a123 * a223 + Scalar(4.0) * omega2_3 * omega3_2 * a113 * a123
      + Scalar(4.0) * omega2_3 * omega3_2 * a123 * a223 - Scalar(4.0) * omega2_3 * omega3_2 * a123 * a333
      + Scalar(10.0) * omega2_2 * omega3_3 * a113 * a123 + Scalar(6.0) * omega2_2 * omega3_3 * a123 * a223
      - Scalar(2.0) * omega2_2 * omega3_3 * a123 * a333 - Scalar(4.0) * omega2 * omega3_4 * a113 * a123
      - Scalar(4.0) * omega2 * omega3_4 * a123 * a223 + Scalar(4.0) * omega2 * omega3_4 * a123 * a333
      - Scalar(4.0) * omega3_5 * a113 * a123 - Scalar(4.0) * omega3_5 * a123 * a223
      + Scalar(2.0) * omega3_5 * a123 * a333) / (Scalar(4.0) * omega1_7 * omega2 * omega3
      + Scalar(2.0) * omega1_7 * omega3_2 - Scalar(8.0) * omega1_6 * omega2_2 * omega3
      - Scalar(14.0) * omega1_6 * omega2 * omega3_2 - Scalar(5.0) * omega1_6 * omega3_3
      - Scalar(4.0) * omega1_5 * omega2_3 * omega3 + Scalar(10.0) * omega1_5 * omega2_2 * omega3_2
      + Scalar(2.0) * omega1_5 * omega2 * omega3_3 - Scalar(2.0) * omega1_5 * omega3_4
      + Scalar(16.0) * omega1_4 * omega2_4 * omega3 + Scalar(26.0) * omega1_4 * omega2_3 * omega3_2
      + Scalar(21.0) * omega1_4 * omega2_2 * omega3_3 + Scalar(26.0) * omega1_4 * omega2 * omega3_4
      + Scalar(10.0) * omega1_4 * omega3_5 - Scalar(4.0) * omega1_3 * omega2_5 * omega3
      - Scalar(26.0) * omega1_3 * omega2_4 * omega3_2 - Scalar(36.0) * omega1_3 * omega2_3 * omega3_3
      - Scalar(36.0) * omega1_3 * omega2_2 * omega3_4 - Scalar(16.0) * omega1_3 * omega2 * omega3_5
      - Scalar(2.0) * omega1_3 * omega3_6 - Scalar(8.0) * omega1_2 * omega2_6 * omega3
      - Scalar(10.0) * omega1_2 * omega2_5 * omega3_2 + Scalar(21.0) * omega1_2 * omega2_4 * omega3_3
      + Scalar(36.0) * omega1_2 * omega2_3 * omega3_4 + Scalar(12.0) * omega1_2 * omega2_2 * omega3_5
      - Scalar(10.0) * omega1_2 * omega2 * omega3_6 - Scalar(5.0) * omega1_2 * omega3_7
      + Scalar(4.0) * omega1 * omega2_7 * omega3 + Scalar(14.0) * omega1 * omega2_6 * omega3_2
      + Scalar(2.0) * omega1 * omega2_5 * omega3_3 - Scalar(26.0) * omega1 * omega2_4 * omega3_4
      - Scalar(16.0) * omega1 * omega2_3 * omega3_5 + Scalar(10.0) * omega1 * omega2_2 * omega3_6
      + Scalar(10.0) * omega1 * omega2 * omega3_7 + Scalar(2.0) * omega1 * omega3_8
      - Scalar(2.0) * omega2_7 * omega3_2 - Scalar(5.0) * omega2_6 * omega3_3 + Scalar(2.0) * omega2_5 * omega3_4
      + Scalar(10.0) * omega2_4 * omega3_5 + Scalar(2.0) * omega2_3 * omega3_6 - Scalar(5.0) * omega2_2 * omega3_7
      - Scalar(2.0) * omega2 * omega3_8);
  // harmonic_re_v3_A_v22_conjA_v3
  lumps[34] = (Scalar(4.0) * omega1_2 * omega2_2 * omega3 * b2233 - Scalar(8.0) * omega1_2 * omega2 * a223_2
      - omega1_2 * omega3_3 * b2233 - Scalar(4.0) * omega1_2 * omega3 * a223_2
      + Scalar(2.0) * omega1_2 * omega3 * a223 * a333 - Scalar(4.0) * omega2_4 * omega3 * b2233
      + Scalar(8.0) * omega2_3 * omega3_2 * b2233 + Scalar(8.0) * omega2_3 * a223_2
      - Scalar(3.0) * omega2_2 * omega3_3 * b2233 - Scalar(4.0) * omega2_2 * omega3 * a123_2
      - Scalar(12.0) * omega2_2 * omega3 * a223_2 - Scalar(2.0) * omega2_2 * omega3 * a223 * a333
      - Scalar(2.0) * omega2 * omega3_4 * b2233 + Scalar(4.0) * omega2 * omega3_2 * a223 * a333 + omega3_5 * b2233
      + omega3_3 * a123_2 + Scalar(4.0) * omega3_3 * a223_2
      - Scalar(2.0) * omega3_3 * a223 * a333) / (Scalar(16.0) * omega1_2 * omega2_4 * omega3
      - Scalar(16.0) * omega1_2 * omega2_3 * omega3_2 - Scalar(4.0) * omega1_2 * omega2_2 * omega3_3
      + Scalar(4.0) * omega1_2 * omega2 * omega3_4 - Scalar(16.0) * omega2_6 * omega3
      + Scalar(48.0) * omega2_5 * omega3_2 - Scalar(44.0) * omega2_4 * omega3_3
      + Scalar(4.0) * omega2_3 * omega3_4 + Scalar(12.0) * omega2_2 * omega3_5 - Scalar(4.0) * omega2 * omega3_6);
  // harmonic_re_v3_A_v22_A_v3
  lumps[35] = (Scalar(4.0) * omega1_2 * omega2_2 * omega3 * b2233 + Scalar(8.0) * omega1_2 * omega2 * a223_2
      - omega1_2 * omega3_3 * b2233 - Scalar(4.0) * omega1_2 * omega3 * a223_2
      + Scalar(2.0) * omega1_2 * omega3 * a223 * a333 - Scalar(4.0) * omega2_4 * omega3 * b2233
      - Scalar(8.0) * omega2_3 * omega3_2 * b2233 - Scalar(8.0) * omega2_3 * a223_2
      - Scalar(3.0) * omega2_2 * omega3_3 * b2233 - Scalar(4.0) * omega2_2 * omega3 * a123_2
      - Scalar(12.0) * omega2_2 * omega3 * a223_2 - Scalar(2.0) * omega2_2 * omega3 * a223 * a333
      + Scalar(2.0) * omega2 * omega3_4 * b2233 - Scalar(4.0) * omega2 * omega3_2 * a223 * a333 + omega3_5 * b2233
      + omega3_3 * a123_2 + Scalar(4.0) * omega3_3 * a223_2
      - Scalar(2.0) * omega3_3 * a223 * a333) / (Scalar(16.0) * omega1_2 * omega2_4 * omega3
      + Scalar(16.0) * omega1_2 * omega2_3 * omega3_2 - Scalar(4.0) * omega1_2 * omega2_2 * omega3_3
      - Scalar(4.0) * omega1_2 * omega2 * omega3_4 - Scalar(16.0) * omega2_6 * omega3
      - Scalar(48.0) * omega2_5 * omega3_2 - Scalar(44.0) * omega2_4 * omega3_3
      - Scalar(4.0) * omega2_3 * omega3_4 + Scalar(12.0) * omega2_2 * omega3_5 + Scalar(4.0) * omega2 * omega3_6);
  // harmonic_re_v3_A_v1_A_v3_conjA_v2
  lumps[36] = (-Scalar(4.0) * omega1_5 * a123 * a223 + Scalar(4.0) * omega1_4 * omega2 * a113 * a123
      - Scalar(2.0) * omega1_4 * omega3 * a113 * a123 - Scalar(2.0) * omega1_4 * omega3 * a123 * a223
      + Scalar(8.0) * omega1_3 * omega2_2 * a123 * a223 - Scalar(8.0) * omega1_3 * omega2 * omega3 * a113 * a123
      + Scalar(8.0) * omega1_3 * omega2 * omega3 * a123 * a223
      + Scalar(8.0) * omega1_3 * omega2 * omega3 * a123 * a333 + Scalar(4.0) * omega1_3 * omega3_2 * a113 * a123
      + Scalar(4.0) * omega1_3 * omega3_2 * a123 * a223 - Scalar(4.0) * omega1_3 * omega3_2 * a123 * a333
      - Scalar(8.0) * omega1_2 * omega2_3 * a113 * a123 + Scalar(4.0) * omega1_2 * omega2_2 * omega3 * a113 * a123
      + Scalar(4.0) * omega1_2 * omega2_2 * omega3 * a123 * a223
      + Scalar(16.0) * omega1_2 * omega2_2 * omega3 * a123 * a333
      - Scalar(12.0) * omega1_2 * omega2 * omega3_2 * a113 * a123
      - Scalar(12.0) * omega1_2 * omega2 * omega3_2 * a123 * a223
      - Scalar(4.0) * omega1_2 * omega2 * omega3_2 * a123 * a333 + Scalar(6.0) * omega1_2 * omega3_3 * a113 * a123
      + Scalar(10.0) * omega1_2 * omega3_3 * a123 * a223 - Scalar(2.0) * omega1_2 * omega3_3 * a123 * a333
      - Scalar(4.0) * omega1 * omega2_4 * a123 * a223 + Scalar(8.0) * omega1 * omega2_3 * omega3 * a113 * a123
      - Scalar(8.0) * omega1 * omega2_3 * omega3 * a123 * a223
      + Scalar(8.0) * omega1 * omega2_3 * omega3 * a123 * a333
      + Scalar(12.0) * omega1 * omega2_2 * omega3_2 * a113 * a123
      + Scalar(12.0) * omega1 * omega2_2 * omega3_2 * a123 * a223
      + Scalar(4.0) * omega1 * omega2_2 * omega3_2 * a123 * a333
      - Scalar(12.0) * omega1 * omega2 * omega3_3 * a123 * a333 - Scalar(4.0) * omega1 * omega3_4 * a113 * a123
      - Scalar(4.0) * omega1 * omega3_4 * a123 * a223 + Scalar(4.0) * omega1 * omega3_4 * a123 * a333
      + Scalar(4.0) * omega2_5 * a113 * a123 - Scalar(2.0) * omega2_4 * omega3 * a113 * a123
      - Scalar(2.0) * omega2_4 * omega3 * a123 * a223 - Scalar(4.0) * omega2_3 * omega3_2 * a113 * a123
      - Scalar(4.0) * omega2_3 * omega3_2 * a123 * a223 + Scalar(4.0) * omega2_3 * omega3_2 * a123 * a333
      + Scalar(10.0) * omega2_2 * omega3_3 * a113 * a123 + Scalar(6.0) * omega2_2 * omega3_3 * a123 * a223
      - Scalar(2.0) * omega2_2 * omega3_3 * a123 * a333 + Scalar(4.0) * omega2 * omega3_4 * a113 * a123
      + Scalar(4.0) * omega2 * omega3_4 * a123 * a223 - Scalar(4.0) * omega2 * omega3_4 * a123 * a333
      - Scalar(4.0) * omega3_5 * a113 * a123 - Scalar(4.0) * omega3_5 * a123 * a223
      + Scalar(2.0) * omega3_5 * a123 * a333) / (Scalar(4.0) * omega1_7 * omega2 * omega3
      - Scalar(2.0) * omega1_7 * omega3_2 - Scalar(8.0) * omega1_6 * omega2_2 * omega3
      + Scalar(14.0) * omega1_6 * omega2 * omega3_2 - Scalar(5.0) * omega1_6 * omega3_3
      - Scalar(4.0) * omega1_5 * omega2_3 * omega3 - Scalar(10.0) * omega1_5 * omega2_2 * omega3_2
      + Scalar(2.0) * omega1_5 * omega2 * omega3_3 + Scalar(2.0) * omega1_5 * omega3_4
      + Scalar(16.0) * omega1_4 * omega2_4 * omega3 - Scalar(26.0) * omega1_4 * omega2_3 * omega3_2
      + Scalar(21.0) * omega1_4 * omega2_2 * omega3_3 - Scalar(26.0) * omega1_4 * omega2 * omega3_4
      + Scalar(10.0) * omega1_4 * omega3_5 - Scalar(4.0) * omega1_3 * omega2_5 * omega3
      + Scalar(26.0) * omega1_3 * omega2_4 * omega3_2 - Scalar(36.0) * omega1_3 * omega2_3 * omega3_3
      + Scalar(36.0) * omega1_3 * omega2_2 * omega3_4 - Scalar(16.0) * omega1_3 * omega2 * omega3_5
      + Scalar(2.0) * omega1_3 * omega3_6 - Scalar(8.0) * omega1_2 * omega2_6 * omega3
      + Scalar(10.0) * omega1_2 * omega2_5 * omega3_2 + Scalar(21.0) * omega1_2 * omega2_4 * omega3_3
      - Scalar(36.0) * omega1_2 * omega2_3 * omega3_4 + Scalar(12.0) * omega1_2 * omega2_2 * omega3_5
      + Scalar(10.0) * omega1_2 * omega2 * omega3_6 - Scalar(5.0) * omega1_2 * omega3_7
      + Scalar(4.0) * omega1 * omega2_7 * omega3 - Scalar(14.0) * omega1 * omega2_6 * omega3_2
      + Scalar(2.0) * omega1 * omega2_5 * omega3_3 + Scalar(26.0) * omega1 * omega2_4 * omega3_4
      - Scalar(16.0) * omega1 * omega2_3 * omega3_5 - Scalar(10.0) * omega1 * omega2_2 * omega3_6
      + Scalar(10.0) * omega1 * omega2 * omega3_7 - Scalar(2.0) * omega1 * omega3_8
      + Scalar(2.0) * omega2_7 * omega3_2 - Scalar(5.0) * omega2_6 * omega3_3 - Scalar(2.0) * omega2_5 * omega3_4
      + Scalar(10.0) * omega2_4 * omega3_5 - Scalar(2.0) * omega2_3 * omega3_6 - Scalar(5.0) * omega2_2 * omega3_7
      + Scalar(2.0) * omega2 * omega3_8);
  // harmonic_re_v3_A_v1_A_v2_A_v3
  lumps[37] = (Scalar(4.0) * omega1_5 * a123 * a223 + Scalar(4.0) * omega1_4 * omega2 * a113 * a123
      + Scalar(2.0) * omega1_4 * omega3 * a113 * a123 + Scalar(2.0) * omega1_4 * omega3 * a123 * a223
      - Scalar(8.0) * omega1_3 * omega2_2 * a123 * a223 - Scalar(8.0) * omega1_3 * omega2 * omega3 * a113 * a123
      + Scalar(8.0) * omega1_3 * omega2 * omega3 * a123 * a223
      + Scalar(8.0) * omega1_3 * omega2 * omega3 * a123 * a333 - Scalar(4.0) * omega1_3 * omega3_2 * a113 * a123
      - Scalar(4.0) * omega1_3 * omega3_2 * a123 * a223 + Scalar(4.0) * omega1_3 * omega3_2 * a123 * a333
      - Scalar(8.0) * omega1_2 * omega2_3 * a113 * a123 - Scalar(4.0) * omega1_2 * omega2_2 * omega3 * a113 * a123
      - Scalar(4.0) * omega1_2 * omega2_2 * omega3 * a123 * a223
      - Scalar(16.0) * omega1_2 * omega2_2 * omega3 * a123 * a333
      - Scalar(12.0) * omega1_2 * omega2 * omega3_2 * a113 * a123
      - Scalar(12.0) * omega1_2 * omega2 * omega3_2 * a123 * a223
      - Scalar(4.0) * omega1_2 * omega2 * omega3_2 * a123 * a333 - Scalar(6.0) * omega1_2 * omega3_3 * a113 * a123
      - Scalar(10.0) * omega1_2 * omega3_3 * a123 * a223 + Scalar(2.0) * omega1_2 * omega3_3 * a123 * a333
      + Scalar(4.0) * omega1 * omega2_4 * a123 * a223 + Scalar(8.0) * omega1 * omega2_3 * omega3 * a113 * a123
      - Scalar(8.0) * omega1 * omega2_3 * omega3 * a123 * a223
      + Scalar(8.0) * omega1 * omega2_3 * omega3 * a123 * a333
      - Scalar(12.0) * omega1 * omega2_2 * omega3_2 * a113 * a123
      - Scalar(12.0) * omega1 * omega2_2 * omega3_2 * a123 * a223
      - Scalar(4.0) * omega1 * omega2_2 * omega3_2 * a123 * a333
      - Scalar(12.0) * omega1 * omega2 * omega3_3 * a123 * a333 + Scalar(4.0) * omega1 * omega3_4 * a113 * a123
      + Scalar(4.0) * omega1 * omega3_4 * a123 * a223 - Scalar(4.0) * omega1 * omega3_4 * a123 * a333
      + Scalar(4.0) * omega2_5 * a113 * a123 + Scalar(2.0) * omega2_4 * omega3 * a113 * a123
      + Scalar(2.0) * omega2_4 * omega3 * a123 * a223 - Scalar(4.0) * omega2_3 * omega3_2 * a113 * a123
      - Scalar(4.0) * omega2_3 * omega3_2 * a123 * a223 + Scalar(4.0) * omega2_3 * omega3_2 * a123 * a333
      - Scalar(10.0) * omega2_2 * omega3_3 * a113 * a123 - Scalar(6.0) * omega2_2 * omega3_3 * a123 * a223
      + Scalar(2.0) * omega2_2 * omega3_3 * a123 * a333 + Scalar(4.0) * omega2 * omega3_4 * a113 * a123
      + Scalar(4.0) * omega2 * omega3_4 * a123 * a223 - Scalar(4.0) * omega2 * omega3_4 * a123 * a333
      + Scalar(4.0) * omega3_5 * a113 * a123 + Scalar(4.0) * omega3_5 * a123 * a223
      - Scalar(2.0) * omega3_5 * a123 * a333) / (Scalar(4.0) * omega1_7 * omega2 * omega3
      + Scalar(2.0) * omega1_7 * omega3_2 + Scalar(8.0) * omega1_6 * omega2_2 * omega3
      + Scalar(14.0) * omega1_6 * omega2 * omega3_2 + Scalar(5.0) * omega1_6 * omega3_3
      - Scalar(4.0) * omega1_5 * omega2_3 * omega3 + Scalar(10.0) * omega1_5 * omega2_2 * omega3_2
      + Scalar(2.0) * omega1_5 * omega2 * omega3_3 - Scalar(2.0) * omega1_5 * omega3_4
      - Scalar(16.0) * omega1_4 * omega2_4 * omega3 - Scalar(26.0) * omega1_4 * omega2_3 * omega3_2
      - Scalar(21.0) * omega1_4 * omega2_2 * omega3_3 - Scalar(26.0) * omega1_4 * omega2 * omega3_4
      - Scalar(10.0) * omega1_4 * omega3_5 - Scalar(4.0) * omega1_3 * omega2_5 * omega3
      - Scalar(26.0) * omega1_3 * omega2_4 * omega3_2 - Scalar(36.0) * omega1_3 * omega2_3 * omega3_3
      - Scalar(36.0) * omega1_3 * omega2_2 * omega3_4 - Scalar(16.0) * omega1_3 * omega2 * omega3_5
      - Scalar(2.0) * omega1_3 * omega3_6 + Scalar(8.0) * omega1_2 * omega2_6 * omega3
      + Scalar(10.0) * omega1_2 * omega2_5 * omega3_2 - Scalar(21.0) * omega1_2 * omega2_4 * omega3_3
      - Scalar(36.0) * omega1_2 * omega2_3 * omega3_4 - Scalar(12.0) * omega1_2 * omega2_2 * omega3_5
      + Scalar(10.0) * omega1_2 * omega2 * omega3_6 + Scalar(5.0) * omega1_2 * omega3_7
      + Scalar(4.0) * omega1 * omega2_7 * omega3 + Scalar(14.0) * omega1 * omega2_6 * omega3_2
      + Scalar(2.0) * omega1 * omega2_5 * omega3_3 - Scalar(26.0) * omega1 * omega2_4 * omega3_4
      - Scalar(16.0) * omega1 * omega2_3 * omega3_5 + Scalar(10.0) * omega1 * omega2_2 * omega3_6
      + Scalar(10.0) * omega1 * omega2 * omega3_7 + Scalar(2.0) * omega1 * omega3_8
      + Scalar(2.0) * omega2_7 * omega3_2 + Scalar(5.0) * omega2_6 * omega3_3 - Scalar(2.0) * omega2_5 * omega3_4
      - Scalar(10.0) * omega2_4 * omega3_5 - Scalar(2.0) * omega2_3 * omega3_6 + Scalar(5.0) * omega2_2 * omega3_7
      + Scalar(2.0) * omega2 * omega3_8);
  // harmonic_re_v3_A_v12_A_v3
  lumps[38] = (Scalar(4.0) * omega1_4 * omega3 * b1133 + Scalar(8.0) * omega1_3 * omega3_2 * b1133
      + Scalar(8.0) * omega1_3 * a113_2 - Scalar(4.0) * omega1_2 * omega2_2 * omega3 * b1133
      + Scalar(3.0) * omega1_2 * omega3_3 * b1133 + Scalar(12.0) * omega1_2 * omega3 * a113_2
      + Scalar(2.0) * omega1_2 * omega3 * a113 * a333 + Scalar(4.0) * omega1_2 * omega3 * a123_2
      - Scalar(8.0) * omega1 * omega2_2 * a113_2 - Scalar(2.0) * omega1 * omega3_4 * b1133
      + Scalar(4.0) * omega1 * omega3_2 * a113 * a333 + omega2_2 * omega3_3 * b1133
      + Scalar(4.0) * omega2_2 * omega3 * a113_2 - Scalar(2.0) * omega2_2 * omega3 * a113 * a333
      - omega3_5 * b1133 - Scalar(4.0) * omega3_3 * a113_2 + Scalar(2.0) * omega3_3 * a113 * a333
      - omega3_3 * a123_2) / (Scalar(16.0) * omega1_6 * omega3 + Scalar(48.0) * omega1_5 * omega3_2
      - Scalar(16.0) * omega1_4 * omega2_2 * omega3 + Scalar(44.0) * omega1_4 * omega3_3
      - Scalar(16.0) * omega1_3 * omega2_2 * omega3_2 + Scalar(4.0) * omega1_3 * omega3_4
      + Scalar(4.0) * omega1_2 * omega2_2 * omega3_3 - Scalar(12.0) * omega1_2 * omega3_5
      + Scalar(4.0) * omega1 * omega2_2 * omega3_4 - Scalar(4.0) * omega1 * omega3_6);
}

/// gradient[p] = d conservative_v1_A_v1_A_v3_conjA_v3 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump
/// N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 315 operations.
template <class Scalar>
void lump_gradient_1(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a333 = parameters[6];
  const Scalar b1133 = parameters[10];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega1_6 = omega1_5 * omega1;
  const Scalar omega1_7 = omega1_6 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar omega3_5 = omega3_4 * omega3;
  const Scalar omega3_6 = omega3_5 * omega3;
  const Scalar omega3_7 = omega3_6 * omega3;
  const Scalar omega3_8 = omega3_7 * omega3;
  const Scalar a113_2 = a113 * a113;
  const Scalar a123_2 = a123 * a123;
  const Scalar denominator = Scalar(4.0) * omega1_7 * omega3_2 - Scalar(8.0) * omega1_5 * omega2_2 * omega3_2
      - Scalar(9.0) * omega1_5 * omega3_4 + Scalar(4.0) * omega1_3 * omega2_4 * omega3_2
      - Scalar(6.0) * omega1_3 * omega2_2 * omega3_4 + Scalar(6.0) * omega1_3 * omega3_6
      - omega1 * omega2_4 * omega3_4 + Scalar(2.0) * omega1 * omega2_2 * omega3_6 - omega1 * omega3_8;
  // multiplies a113^2
  const Scalar c_0 = -Scalar(4.0) * omega1_4 * omega3_2 + Scalar(8.0) * omega1_2 * omega2_2 * omega3_2
      + Scalar(8.0) * omega1_2 * omega3_4 - Scalar(4.0) * omega2_4 * omega3_2 + Scalar(8.0) * omega2_2 * omega3_4
      - Scalar(4.0) * omega3_6;
  // multiplies a113*a333
  const Scalar c_1 = -Scalar(8.0) * omega1_6 + Scalar(16.0) * omega1_4 * omega2_2
      + Scalar(18.0) * omega1_4 * omega3_2 - Scalar(8.0) * omega1_2 * omega2_4
      + Scalar(12.0) * omega1_2 * omega2_2 * omega3_2 - Scalar(12.0) * omega1_2 * omega3_4
      + Scalar(2.0) * omega2_4 * omega3_2 - Scalar(4.0) * omega2_2 * omega3_4 + Scalar(2.0) * omega3_6;
  // multiplies a123^2
  const Scalar c_2 = Scalar(4.0) * omega1_4 * omega3_2 - Scalar(4.0) * omega1_2 * omega2_2 * omega3_2
      + Scalar(3.0) * omega1_2 * omega3_4 + omega2_2 * omega3_4 - omega3_6;
  // multiplies b1133
  const Scalar c_3 = Scalar(4.0) * omega1_6 * omega3_2 - Scalar(8.0) * omega1_4 * omega2_2 * omega3_2
      - Scalar(9.0) * omega1_4 * omega3_4 + Scalar(4.0) * omega1_2 * omega2_4 * omega3_2
      - Scalar(6.0) * omega1_2 * omega2_2 * omega3_4 + Scalar(6.0) * omega1_2 * omega3_6 - omega2_4 * omega3_4
      + Scalar(2.0) * omega2_2 * omega3_6 - omega3_8;
  const Scalar w_0 = Scalar(4.0) * b1133;  // multiplies omega1^6*omega3^2
  const Scalar w_1 = -Scalar(8.0) * a113 * a333;  // multiplies omega1^6
  const Scalar w_2 = -Scalar(8.0) * b1133;  // multiplies omega1^4*omega2^2*omega3^2
  const Scalar w_3 = Scalar(16.0) * a113 * a333;  // multiplies omega1^4*omega2^2
  const Scalar w_4 = -Scalar(9.0) * b1133;  // multiplies omega1^4*omega3^4
  // multiplies omega1^4*omega3^2
  const Scalar w_5 = -Scalar(4.0) * a113_2 + Scalar(18.0) * a113 * a333 + Scalar(4.0) * a123_2;
  const Scalar w_6 = Scalar(4.0) * b1133;  // multiplies omega1^2*omega2^4*omega3^2
  const Scalar w_7 = -Scalar(8.0) * a113 * a333;  // multiplies omega1^2*omega2^4
  const Scalar w_8 = -Scalar(6.0) * b1133;  // multiplies omega1^2*omega2^2*omega3^4
  // multiplies omega1^2*omega2^2*omega3^2
  const Scalar w_9 = Scalar(8.0) * a113_2 + Scalar(12.0) * a113 * a333 - Scalar(4.0) * a123_2;
  const Scalar w_10 = Scalar(6.0) * b1133;  // multiplies omega1^2*omega3^6
  // multiplies omega1^2*omega3^4
  const Scalar w_11 = Scalar(8.0) * a113_2 - Scalar(12.0) * a113 * a333 + Scalar(3.0) * a123_2;
  const Scalar w_12 = -b1133;  // multiplies omega2^4*omega3^4
  const Scalar w_13 = -Scalar(4.0) * a113_2 + Scalar(2.0) * a113 * a333;  // multiplies omega2^4*omega3^2
  const Scalar w_14 = Scalar(2.0) * b1133;  // multiplies omega2^2*omega3^6
  const Scalar w_15 = Scalar(8.0) * a113_2 - Scalar(4.0) * a113 * a333 + a123_2;  // multiplies omega2^2*omega3^4
  const Scalar w_16 = -b1133;  // multiplies omega3^8
  const Scalar w_17 = -Scalar(4.0) * a113_2 + Scalar(2.0) * a113 * a333 - a123_2;  // multiplies omega3^6
  // by omega1
  gradient[0] = (Scalar(6.0) * omega1_5 * omega3_2 * w_0 + Scalar(6.0) * omega1_5 * w_1
      + Scalar(4.0) * omega1_3 * omega2_2 * omega3_2 * w_2 + Scalar(4.0) * omega1_3 * omega2_2 * w_3
      + Scalar(4.0) * omega1_3 * omega3_4 * w_4 + Scalar(4.0) * omega1_3 * omega3_2 * w_5
      + Scalar(2.0) * omega1 * omega2_4 * omega3_2 * w_6 + Scalar(2.0) * omega1 * omega2_4 * w_7
      + Scalar(2.0) * omega1 * omega2_2 * omega3_4 * w_8 + Scalar(2.0) * omega1 * omega2_2 * omega3_2 * w_9
      + Scalar(2.0) * omega1 * omega3_6 * w_10 + Scalar(2.0) * omega1 * omega3_4 * w_11
      - lump * (Scalar(28.0) * omega1_6 * omega3_2 - Scalar(40.0) * omega1_4 * omega2_2 * omega3_2
      - Scalar(45.0) * omega1_4 * omega3_4 + Scalar(12.0) * omega1_2 * omega2_4 * omega3_2
      - Scalar(18.0) * omega1_2 * omega2_2 * omega3_4 + Scalar(18.0) * omega1_2 * omega3_6 - omega2_4 * omega3_4
      + Scalar(2.0) * omega2_2 * omega3_6 - omega3_8)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_4 * omega2 * omega3_2 * w_2 + Scalar(2.0) * omega1_4 * omega2 * w_3
      + Scalar(4.0) * omega1_2 * omega2_3 * omega3_2 * w_6 + Scalar(4.0) * omega1_2 * omega2_3 * w_7
      + Scalar(2.0) * omega1_2 * omega2 * omega3_4 * w_8 + Scalar(2.0) * omega1_2 * omega2 * omega3_2 * w_9
      + Scalar(4.0) * omega2_3 * omega3_4 * w_12 + Scalar(4.0) * omega2_3 * omega3_2 * w_13
      + Scalar(2.0) * omega2 * omega3_6 * w_14 + Scalar(2.0) * omega2 * omega3_4 * w_15
      - lump * (-Scalar(16.0) * omega1_5 * omega2 * omega3_2 + Scalar(16.0) * omega1_3 * omega2_3 * omega3_2
      - Scalar(12.0) * omega1_3 * omega2 * omega3_4 - Scalar(4.0) * omega1 * omega2_3 * omega3_4
      + Scalar(4.0) * omega1 * omega2 * omega3_6)) / denominator;
  // by omega3
  gradient[2] = (Scalar(2.0) * omega1_6 * omega3 * w_0 + Scalar(2.0) * omega1_4 * omega2_2 * omega3 * w_2
      + Scalar(4.0) * omega1_4 * omega3_3 * w_4 + Scalar(2.0) * omega1_4 * omega3 * w_5
      + Scalar(2.0) * omega1_2 * omega2_4 * omega3 * w_6 + Scalar(4.0) * omega1_2 * omega2_2 * omega3_3 * w_8
      + Scalar(2.0) * omega1_2 * omega2_2 * omega3 * w_9 + Scalar(6.0) * omega1_2 * omega3_5 * w_10
      + Scalar(4.0) * omega1_2 * omega3_3 * w_11 + Scalar(4.0) * omega2_4 * omega3_3 * w_12
      + Scalar(2.0) * omega2_4 * omega3 * w_13 + Scalar(6.0) * omega2_2 * omega3_5 * w_14
      + Scalar(4.0) * omega2_2 * omega3_3 * w_15 + Scalar(8.0) * omega3_7 * w_16 + Scalar(6.0) * omega3_5 * w_17
      - lump * (Scalar(8.0) * omega1_7 * omega3 - Scalar(16.0) * omega1_5 * omega2_2 * omega3
      - Scalar(36.0) * omega1_5 * omega3_3 + Scalar(8.0) * omega1_3 * omega2_4 * omega3
      - Scalar(24.0) * omega1_3 * omega2_2 * omega3_3 + Scalar(36.0) * omega1_3 * omega3_5
      - Scalar(4.0) * omega1 * omega2_4 * omega3_3 + Scalar(12.0) * omega1 * omega2_2 * omega3_5
      - Scalar(8.0) * omega1 * omega3_7)) / denominator;
  gradient[3] = (Scalar(2.0) * a113 * c_0 + a333 * c_1) / denominator;  // by a113
  gradient[4] = (Scalar(2.0) * a123 * c_2) / denominator;  // by a123
  gradient[6] = (a113 * c_1) / denominator;  // by a333
  gradient[10] = (c_3) / denominator;  // by b1133
}

/// gradient[p] = d conservative_v1_A_v1_A_v2_conjA_v2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump
/// N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 155 operations.
template <class Scalar>
void lump_gradient_2(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar b1122 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar omega3_5 = omega3_4 * omega3;
  const Scalar omega3_6 = omega3_5 * omega3;
  const Scalar a123_2 = a123 * a123;
  const Scalar denominator = omega1_5 * omega3_2 - Scalar(2.0) * omega1_3 * omega2_2 * omega3_2
      - Scalar(2.0) * omega1_3 * omega3_4 + omega1 * omega2_4 * omega3_2
      - Scalar(2.0) * omega1 * omega2_2 * omega3_4 + omega1 * omega3_6;
  // multiplies a113*a223
  const Scalar c_0 = -Scalar(2.0) * omega1_4 + Scalar(4.0) * omega1_2 * omega2_2
      + Scalar(4.0) * omega1_2 * omega3_2 - Scalar(2.0) * omega2_4 + Scalar(4.0) * omega2_2 * omega3_2
      - Scalar(2.0) * omega3_4;
  const Scalar c_1 = omega1_2 * omega3_2 + omega2_2 * omega3_2 - omega3_4;  // multiplies a123^2
  // multiplies b1122
  const Scalar c_2 = omega1_4 * omega3_2 - Scalar(2.0) * omega1_2 * omega2_2 * omega3_2
      - Scalar(2.0) * omega1_2 * omega3_4 + omega2_4 * omega3_2 - Scalar(2.0) * omega2_2 * omega3_4 + omega3_6;
  const Scalar w_0 = b1122;  // multiplies omega1^4*omega3^2
  const Scalar w_1 = -Scalar(2.0) * a113 * a223;  // multiplies omega1^4
  const Scalar w_2 = -Scalar(2.0) * b1122;  // multiplies omega1^2*omega2^2*omega3^2
  const Scalar w_3 = Scalar(4.0) * a113 * a223;  // multiplies omega1^2*omega2^2
  const Scalar w_4 = -Scalar(2.0) * b1122;  // multiplies omega1^2*omega3^4
  const Scalar w_5 = Scalar(4.0) * a113 * a223 + a123_2;  // multiplies omega1^2*omega3^2
  const Scalar w_6 = b1122;  // multiplies omega2^4*omega3^2
  const Scalar w_7 = -Scalar(2.0) * a113 * a223;  // multiplies omega2^4
  const Scalar w_8 = -Scalar(2.0) * b1122;  // multiplies omega2^2*omega3^4
  const Scalar w_9 = Scalar(4.0) * a113 * a223 + a123_2;  // multiplies omega2^2*omega3^2
  const Scalar w_10 = b1122;  // multiplies omega3^6
  const Scalar w_11 = -Scalar(2.0) * a113 * a223 - a123_2;  // multiplies omega3^4
  // by omega1
  gradient[0] = (Scalar(4.0) * omega1_3 * omega3_2 * w_0 + Scalar(4.0) * omega1_3 * w_1
      + Scalar(2.0) * omega1 * omega2_2 * omega3_2 * w_2 + Scalar(2.0) * omega1 * omega2_2 * w_3
      + Scalar(2.0) * omega1 * omega3_4 * w_4 + Scalar(2.0) * omega1 * omega3_2 * w_5
      - lump * (Scalar(5.0) * omega1_4 * omega3_2 - Scalar(6.0) * omega1_2 * omega2_2 * omega3_2
      - Scalar(6.0) * omega1_2 * omega3_4 + omega2_4 * omega3_2 - Scalar(2.0) * omega2_2 * omega3_4
      + omega3_6)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_2 * omega2 * omega3_2 * w_2 + Scalar(2.0) * omega1_2 * omega2 * w_3
      + Scalar(4.0) * omega2_3 * omega3_2 * w_6 + Scalar(4.0) * omega2_3 * w_7
      + Scalar(2.0) * omega2 * omega3_4 * w_8 + Scalar(2.0) * omega2 * omega3_2 * w_9
      - lump * (-Scalar(4.0) * omega1_3 * omega2 * omega3_2 + Scalar(4.0) * omega1 * omega2_3 * omega3_2
      - Scalar(4.0) * omega1 * omega2 * omega3_4)) / denominator;
  // by omega3
  gradient[2] = (Scalar(2.0) * omega1_4 * omega3 * w_0 + Scalar(2.0) * omega1_2 * omega2_2 * omega3 * w_2
      + Scalar(4.0) * omega1_2 * omega3_3 * w_4 + Scalar(2.0) * omega1_2 * omega3 * w_5
      + Scalar(2.0) * omega2_4 * omega3 * w_6 + Scalar(4.0) * omega2_2 * omega3_3 * w_8
      + Scalar(2.0) * omega2_2 * omega3 * w_9 + Scalar(6.0) * omega3_5 * w_10 + Scalar(4.0) * omega3_3 * w_11
      - lump * (Scalar(2.0) * omega1_5 * omega3 - Scalar(4.0) * omega1_3 * omega2_2 * omega3
      - Scalar(8.0) * omega1_3 * omega3_3 + Scalar(2.0) * omega1 * omega2_4 * omega3
      - Scalar(8.0) * omega1 * omega2_2 * omega3_3 + Scalar(6.0) * omega1 * omega3_5)) / denominator;
  gradient[3] = (a223 * c_0) / denominator;  // by a113
  gradient[4] = (Scalar(2.0) * a123 * c_1) / denominator;  // by a123
  gradient[5] = (a113 * c_0) / denominator;  // by a223
  gradient[8] = (c_2) / denominator;  // by b1122
}

/// gradient[p] = d conservative_v1_A_v12_conjA_v1 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 38 operations.
template <class Scalar>
void lump_gradient_3(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar b1111 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar a113_2 = a113 * a113;
  const Scalar denominator = Scalar(8.0) * omega1_3 * omega3_2 - Scalar(2.0) * omega1 * omega3_4;
  // by omega1
  gradient[0] = (Scalar(24.0) * omega1 * omega3_2 * b1111 - Scalar(32.0) * omega1 * a113_2
      - lump * (Scalar(24.0) * omega1_2 * omega3_2 - Scalar(2.0) * omega3_4)) / denominator;
  // by omega3
  gradient[2] = (Scalar(24.0) * omega1_2 * omega3 * b1111 - Scalar(12.0) * omega3_3 * b1111
      + Scalar(12.0) * omega3 * a113_2 - lump * (Scalar(16.0) * omega1_3 * omega3
      - Scalar(8.0) * omega1 * omega3_3)) / denominator;
  gradient[3] = (-Scalar(32.0) * omega1_2 * a113 + Scalar(12.0) * omega3_2 * a113) / denominator;  // by a113
  gradient[7] = (Scalar(12.0) * omega1_2 * omega3_2 - Scalar(3.0) * omega3_4) / denominator;  // by b1111
}

/// gradient[p] = d conservative_v2_A_v2_A_v3_conjA_v3 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump
/// N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 315 operations.
template <class Scalar>
void lump_gradient_5(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar b2233 = parameters[11];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar omega2_7 = omega2_6 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar omega3_5 = omega3_4 * omega3;
  const Scalar omega3_6 = omega3_5 * omega3;
  const Scalar omega3_7 = omega3_6 * omega3;
  const Scalar omega3_8 = omega3_7 * omega3;
  const Scalar a123_2 = a123 * a123;
  const Scalar a223_2 = a223 * a223;
  const Scalar denominator = Scalar(4.0) * omega1_4 * omega2_3 * omega3_2 - omega1_4 * omega2 * omega3_4
      - Scalar(8.0) * omega1_2 * omega2_5 * omega3_2 - Scalar(6.0) * omega1_2 * omega2_3 * omega3_4
      + Scalar(2.0) * omega1_2 * omega2 * omega3_6 + Scalar(4.0) * omega2_7 * omega3_2
      - Scalar(9.0) * omega2_5 * omega3_4 + Scalar(6.0) * omega2_3 * omega3_6 - omega2 * omega3_8;
  // multiplies a123^2
  const Scalar c_0 = -Scalar(4.0) * omega1_2 * omega2_2 * omega3_2 + omega1_2 * omega3_4
      + Scalar(4.0) * omega2_4 * omega3_2 + Scalar(3.0) * omega2_2 * omega3_4 - omega3_6;
  // multiplies a223^2
  const Scalar c_1 = -Scalar(4.0) * omega1_4 * omega3_2 + Scalar(8.0) * omega1_2 * omega2_2 * omega3_2
      + Scalar(8.0) * omega1_2 * omega3_4 - Scalar(4.0) * omega2_4 * omega3_2 + Scalar(8.0) * omega2_2 * omega3_4
      - Scalar(4.0) * omega3_6;
  // multiplies a223*a333
  const Scalar c_2 = -Scalar(8.0) * omega1_4 * omega2_2 + Scalar(2.0) * omega1_4 * omega3_2
      + Scalar(16.0) * omega1_2 * omega2_4 + Scalar(12.0) * omega1_2 * omega2_2 * omega3_2
      - Scalar(4.0) * omega1_2 * omega3_4 - Scalar(8.0) * omega2_6 + Scalar(18.0) * omega2_4 * omega3_2
      - Scalar(12.0) * omega2_2 * omega3_4 + Scalar(2.0) * omega3_6;
  // multiplies b2233
  const Scalar c_3 = Scalar(4.0) * omega1_4 * omega2_2 * omega3_2 - omega1_4 * omega3_4
      - Scalar(8.0) * omega1_2 * omega2_4 * omega3_2 - Scalar(6.0) * omega1_2 * omega2_2 * omega3_4
      + Scalar(2.0) * omega1_2 * omega3_6 + Scalar(4.0) * omega2_6 * omega3_2 - Scalar(9.0) * omega2_4 * omega3_4
      + Scalar(6.0) * omega2_2 * omega3_6 - omega3_8;
  const Scalar w_0 = Scalar(4.0) * b2233;  // multiplies omega1^4*omega2^2*omega3^2
  const Scalar w_1 = -Scalar(8.0) * a223 * a333;  // multiplies omega1^4*omega2^2
  const Scalar w_2 = -b2233;  // multiplies omega1^4*omega3^4
  const Scalar w_3 = -Scalar(4.0) * a223_2 + Scalar(2.0) * a223 * a333;  // multiplies omega1^4*omega3^2
  const Scalar w_4 = -Scalar(8.0) * b2233;  // multiplies omega1^2*omega2^4*omega3^2
  const Scalar w_5 = Scalar(16.0) * a223 * a333;  // multiplies omega1^2*omega2^4
  const Scalar w_6 = -Scalar(6.0) * b2233;  // multiplies omega1^2*omega2^2*omega3^4
  // multiplies omega1^2*omega2^2*omega3^2
  const Scalar w_7 = -Scalar(4.0) * a123_2 + Scalar(8.0) * a223_2 + Scalar(12.0) * a223 * a333;
  const Scalar w_8 = Scalar(2.0) * b2233;  // multiplies omega1^2*omega3^6
  const Scalar w_9 = a123_2 + Scalar(8.0) * a223_2 - Scalar(4.0) * a223 * a333;  // multiplies omega1^2*omega3^4
  const Scalar w_10 = Scalar(4.0) * b2233;  // multiplies omega2^6*omega3^2
  const Scalar w_11 = -Scalar(8.0) * a223 * a333;  // multiplies omega2^6
  const Scalar w_12 = -Scalar(9.0) * b2233;  // multiplies omega2^4*omega3^4
  // multiplies omega2^4*omega3^2
  const Scalar w_13 = Scalar(4.0) * a123_2 - Scalar(4.0) * a223_2 + Scalar(18.0) * a223 * a333;
  const Scalar w_14 = Scalar(6.0) * b2233;  // multiplies omega2^2*omega3^6
  // multiplies omega2^2*omega3^4
  const Scalar w_15 = Scalar(3.0) * a123_2 + Scalar(8.0) * a223_2 - Scalar(12.0) * a223 * a333;
  const Scalar w_16 = -b2233;  // multiplies omega3^8
  const Scalar w_17 = -a123_2 - Scalar(4.0) * a223_2 + Scalar(2.0) * a223 * a333;  // multiplies omega3^6
  // by omega1
  gradient[0] = (Scalar(4.0) * omega1_3 * omega2_2 * omega3_2 * w_0 + Scalar(4.0) * omega1_3 * omega2_2 * w_1
      + Scalar(4.0) * omega1_3 * omega3_4 * w_2 + Scalar(4.0) * omega1_3 * omega3_2 * w_3
      + Scalar(2.0) * omega1 * omega2_4 * omega3_2 * w_4 + Scalar(2.0) * omega1 * omega2_4 * w_5
      + Scalar(2.0) * omega1 * omega2_2 * omega3_4 * w_6 + Scalar(2.0) * omega1 * omega2_2 * omega3_2 * w_7
      + Scalar(2.0) * omega1 * omega3_6 * w_8 + Scalar(2.0) * omega1 * omega3_4 * w_9
      - lump * (Scalar(16.0) * omega1_3 * omega2_3 * omega3_2 - Scalar(4.0) * omega1_3 * omega2 * omega3_4
      - Scalar(16.0) * omega1 * omega2_5 * omega3_2 - Scalar(12.0) * omega1 * omega2_3 * omega3_4
      + Scalar(4.0) * omega1 * omega2 * omega3_6)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_4 * omega2 * omega3_2 * w_0 + Scalar(2.0) * omega1_4 * omega2 * w_1
      + Scalar(4.0) * omega1_2 * omega2_3 * omega3_2 * w_4 + Scalar(4.0) * omega1_2 * omega2_3 * w_5
      + Scalar(2.0) * omega1_2 * omega2 * omega3_4 * w_6 + Scalar(2.0) * omega1_2 * omega2 * omega3_2 * w_7
      + Scalar(6.0) * omega2_5 * omega3_2 * w_10 + Scalar(6.0) * omega2_5 * w_11
      + Scalar(4.0) * omega2_3 * omega3_4 * w_12 + Scalar(4.0) * omega2_3 * omega3_2 * w_13
      + Scalar(2.0) * omega2 * omega3_6 * w_14 + Scalar(2.0) * omega2 * omega3_4 * w_15
      - lump * (Scalar(12.0) * omega1_4 * omega2_2 * omega3_2 - omega1_4 * omega3_4
      - Scalar(40.0) * omega1_2 * omega2_4 * omega3_2 - Scalar(18.0) * omega1_2 * omega2_2 * omega3_4
      + Scalar(2.0) * omega1_2 * omega3_6 + Scalar(28.0) * omega2_6 * omega3_2
      - Scalar(45.0) * omega2_4 * omega3_4 + Scalar(18.0) * omega2_2 * omega3_6 - omega3_8)) / denominator;
  // by omega3
  gradient[2] = (Scalar(2.0) * omega1_4 * omega2_2 * omega3 * w_0 + Scalar(4.0) * omega1_4 * omega3_3 * w_2
      + Scalar(2.0) * omega1_4 * omega3 * w_3 + Scalar(2.0) * omega1_2 * omega2_4 * omega3 * w_4
      + Scalar(4.0) * omega1_2 * omega2_2 * omega3_3 * w_6 + Scalar(2.0) * omega1_2 * omega2_2 * omega3 * w_7
      + Scalar(6.0) * omega1_2 * omega3_5 * w_8 + Scalar(4.0) * omega1_2 * omega3_3 * w_9
      + Scalar(2.0) * omega2_6 * omega3 * w_10 + Scalar(4.0) * omega2_4 * omega3_3 * w_12
      + Scalar(2.0) * omega2_4 * omega3 * w_13 + Scalar(6.0) * omega2_2 * omega3_5 * w_14
      + Scalar(4.0) * omega2_2 * omega3_3 * w_15 + Scalar(8.0) * omega3_7 * w_16 + Scalar(6.0) * omega3_5 * w_17
      - lump * (Scalar(8.0) * omega1_4 * omega2_3 * omega3 - Scalar(4.0) * omega1_4 * omega2 * omega3_3
      - Scalar(16.0) * omega1_2 * omega2_5 * omega3 - Scalar(24.0) * omega1_2 * omega2_3 * omega3_3
      + Scalar(12.0) * omega1_2 * omega2 * omega3_5 + Scalar(8.0) * omega2_7 * omega3
      - Scalar(36.0) * omega2_5 * omega3_3 + Scalar(36.0) * omega2_3 * omega3_5
      - Scalar(8.0) * omega2 * omega3_7)) / denominator;
  gradient[4] = (Scalar(2.0) * a123 * c_0) / denominator;  // by a123
  gradient[5] = (Scalar(2.0) * a223 * c_1 + a333 * c_2) / denominator;  // by a223
  gradient[6] = (a223 * c_2) / denominator;  // by a333
  gradient[11] = (c_3) / denominator;  // by b2233
}

/// gradient[p] = d conservative_v2_A_v22_conjA_v2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 38 operations.
template <class Scalar>
void lump_gradient_6(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a223 = parameters[5];
  const Scalar b2222 = parameters[9];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar a223_2 = a223 * a223;
  const Scalar denominator = Scalar(8.0) * omega2_3 * omega3_2 - Scalar(2.0) * omega2 * omega3_4;
  // by omega2
  gradient[1] = (Scalar(24.0) * omega2 * omega3_2 * b2222 - Scalar(32.0) * omega2 * a223_2
      - lump * (Scalar(24.0) * omega2_2 * omega3_2 - Scalar(2.0) * omega3_4)) / denominator;
  // by omega3
  gradient[2] = (Scalar(24.0) * omega2_2 * omega3 * b2222 - Scalar(12.0) * omega3_3 * b2222
      + Scalar(12.0) * omega3 * a223_2 - lump * (Scalar(16.0) * omega2_3 * omega3
      - Scalar(8.0) * omega2 * omega3_3)) / denominator;
  gradient[5] = (-Scalar(32.0) * omega2_2 * a223 + Scalar(12.0) * omega3_2 * a223) / denominator;  // by a223
  gradient[9] = (Scalar(12.0) * omega2_2 * omega3_2 - Scalar(3.0) * omega3_4) / denominator;  // by b2222
}

/// gradient[p] = d harmonic_re_v1_A_v2_conjA_v12 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 168 operations.
template <class Scalar>
void lump_gradient_11(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega1_6 = omega1_5 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar denominator = Scalar(12.0) * omega1_6 - Scalar(40.0) * omega1_5 * omega2
      + Scalar(48.0) * omega1_4 * omega2_2 - Scalar(15.0) * omega1_4 * omega3_2
      - Scalar(24.0) * omega1_3 * omega2_3 + Scalar(26.0) * omega1_3 * omega2 * omega3_2
      + Scalar(4.0) * omega1_2 * omega2_4 - Scalar(16.0) * omega1_2 * omega2_2 * omega3_2
      + Scalar(3.0) * omega1_2 * omega3_4 + Scalar(6.0) * omega1 * omega2_3 * omega3_2
      - Scalar(4.0) * omega1 * omega2 * omega3_4 - omega2_4 * omega3_2 + omega2_2 * omega3_4;
  // by omega1
  gradient[0] = (Scalar(18.0) * omega1 * a113 * a123 - Scalar(2.0) * omega2 * a113 * a123
      - lump * (Scalar(72.0) * omega1_5 - Scalar(200.0) * omega1_4 * omega2 + Scalar(192.0) * omega1_3 * omega2_2
      - Scalar(60.0) * omega1_3 * omega3_2 - Scalar(72.0) * omega1_2 * omega2_3
      + Scalar(78.0) * omega1_2 * omega2 * omega3_2 + Scalar(8.0) * omega1 * omega2_4
      - Scalar(32.0) * omega1 * omega2_2 * omega3_2 + Scalar(6.0) * omega1 * omega3_4
      + Scalar(6.0) * omega2_3 * omega3_2 - Scalar(4.0) * omega2 * omega3_4)) / denominator;
  // by omega2
  gradient[1] = (-Scalar(2.0) * omega1 * a113 * a123 + Scalar(2.0) * omega2 * a113 * a123
      - lump * (-Scalar(40.0) * omega1_5 + Scalar(96.0) * omega1_4 * omega2 - Scalar(72.0) * omega1_3 * omega2_2
      + Scalar(26.0) * omega1_3 * omega3_2 + Scalar(16.0) * omega1_2 * omega2_3
      - Scalar(32.0) * omega1_2 * omega2 * omega3_2 + Scalar(18.0) * omega1 * omega2_2 * omega3_2
      - Scalar(4.0) * omega1 * omega3_4 - Scalar(4.0) * omega2_3 * omega3_2
      + Scalar(2.0) * omega2 * omega3_4)) / denominator;
  // by omega3
  gradient[2] = (-Scalar(6.0) * omega3 * a113 * a123 - lump * (-Scalar(30.0) * omega1_4 * omega3
      + Scalar(52.0) * omega1_3 * omega2 * omega3 - Scalar(32.0) * omega1_2 * omega2_2 * omega3
      + Scalar(12.0) * omega1_2 * omega3_3 + Scalar(12.0) * omega1 * omega2_3 * omega3
      - Scalar(16.0) * omega1 * omega2 * omega3_3 - Scalar(2.0) * omega2_4 * omega3
      + Scalar(4.0) * omega2_2 * omega3_3)) / denominator;
  // by a113
  gradient[3] = (Scalar(9.0) * omega1_2 * a123 - Scalar(2.0) * omega1 * omega2 * a123 + omega2_2 * a123
      - Scalar(3.0) * omega3_2 * a123) / denominator;
  // by a123
  gradient[4] = (Scalar(9.0) * omega1_2 * a113 - Scalar(2.0) * omega1 * omega2 * a113 + omega2_2 * a113
      - Scalar(3.0) * omega3_2 * a113) / denominator;
}

/// gradient[p] = d harmonic_re_v1_A_v32_conjA_v1 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 185 operations.
template <class Scalar>
void lump_gradient_12(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a333 = parameters[6];
  const Scalar b1133 = parameters[10];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar omega3_5 = omega3_4 * omega3;
  const Scalar omega3_6 = omega3_5 * omega3;
  const Scalar omega3_7 = omega3_6 * omega3;
  const Scalar a113_2 = a113 * a113;
  const Scalar a123_2 = a123 * a123;
  const Scalar denominator = Scalar(24.0) * omega1_4 * omega3_3 - Scalar(84.0) * omega1_3 * omega3_4
      - Scalar(24.0) * omega1_2 * omega2_2 * omega3_3 + Scalar(108.0) * omega1_2 * omega3_5
      + Scalar(36.0) * omega1 * omega2_2 * omega3_4 - Scalar(60.0) * omega1 * omega3_6
      - Scalar(12.0) * omega2_2 * omega3_5 + Scalar(12.0) * omega3_7;
  // multiplies a113^2
  const Scalar c_0 = Scalar(12.0) * omega1_2 * omega3 - Scalar(24.0) * omega1 * omega3_2
      - Scalar(12.0) * omega2_2 * omega3 + Scalar(12.0) * omega3_3;
  // multiplies a113*a333
  const Scalar c_1 = -Scalar(4.0) * omega1_3 + Scalar(10.0) * omega1_2 * omega3 + Scalar(4.0) * omega1 * omega2_2
      - Scalar(8.0) * omega1 * omega3_2 - Scalar(2.0) * omega2_2 * omega3 + Scalar(2.0) * omega3_3;
  const Scalar c_2 = -Scalar(6.0) * omega1 * omega3_2 + Scalar(3.0) * omega3_3;  // multiplies a123^2
  // multiplies b1133
  const Scalar c_3 = -Scalar(6.0) * omega1_3 * omega3_2 + Scalar(15.0) * omega1_2 * omega3_3
      + Scalar(6.0) * omega1 * omega2_2 * omega3_2 - Scalar(12.0) * omega1 * omega3_4
      - Scalar(3.0) * omega2_2 * omega3_3 + Scalar(3.0) * omega3_5;
  const Scalar w_0 = -Scalar(6.0) * b1133;  // multiplies omega1^3*omega3^2
  const Scalar w_1 = -Scalar(4.0) * a113 * a333;  // multiplies omega1^3
  const Scalar w_2 = Scalar(15.0) * b1133;  // multiplies omega1^2*omega3^3
  const Scalar w_3 = Scalar(12.0) * a113_2 + Scalar(10.0) * a113 * a333;  // multiplies omega1^2*omega3
  const Scalar w_4 = Scalar(6.0) * b1133;  // multiplies omega1*omega2^2*omega3^2
  const Scalar w_5 = Scalar(4.0) * a113 * a333;  // multiplies omega1*omega2^2
  const Scalar w_6 = -Scalar(12.0) * b1133;  // multiplies omega1*omega3^4
  // multiplies omega1*omega3^2
  const Scalar w_7 = -Scalar(24.0) * a113_2 - Scalar(8.0) * a113 * a333 - Scalar(6.0) * a123_2;
  const Scalar w_8 = -Scalar(3.0) * b1133;  // multiplies omega2^2*omega3^3
  const Scalar w_9 = -Scalar(12.0) * a113_2 - Scalar(2.0) * a113 * a333;  // multiplies omega2^2*omega3
  const Scalar w_10 = Scalar(3.0) * b1133;  // multiplies omega3^5
  // multiplies omega3^3
  const Scalar w_11 = Scalar(12.0) * a113_2 + Scalar(2.0) * a113 * a333 + Scalar(3.0) * a123_2;
  // by omega1
  gradient[0] = (Scalar(3.0) * omega1_2 * omega3_2 * w_0 + Scalar(3.0) * omega1_2 * w_1
      + Scalar(2.0) * omega1 * omega3_3 * w_2 + Scalar(2.0) * omega1 * omega3 * w_3 + omega2_2 * omega3_2 * w_4
      + omega2_2 * w_5 + omega3_4 * w_6 + omega3_2 * w_7 - lump * (Scalar(96.0) * omega1_3 * omega3_3
      - Scalar(252.0) * omega1_2 * omega3_4 - Scalar(48.0) * omega1 * omega2_2 * omega3_3
      + Scalar(216.0) * omega1 * omega3_5 + Scalar(36.0) * omega2_2 * omega3_4
      - Scalar(60.0) * omega3_6)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1 * omega2 * omega3_2 * w_4 + Scalar(2.0) * omega1 * omega2 * w_5
      + Scalar(2.0) * omega2 * omega3_3 * w_8 + Scalar(2.0) * omega2 * omega3 * w_9
      - lump * (-Scalar(48.0) * omega1_2 * omega2 * omega3_3 + Scalar(72.0) * omega1 * omega2 * omega3_4
      - Scalar(24.0) * omega2 * omega3_5)) / denominator;
  // by omega3
  gradient[2] = (Scalar(2.0) * omega1_3 * omega3 * w_0 + Scalar(3.0) * omega1_2 * omega3_2 * w_2 + omega1_2 * w_3
      + Scalar(2.0) * omega1 * omega2_2 * omega3 * w_4 + Scalar(4.0) * omega1 * omega3_3 * w_6
      + Scalar(2.0) * omega1 * omega3 * w_7 + Scalar(3.0) * omega2_2 * omega3_2 * w_8 + omega2_2 * w_9
      + Scalar(5.0) * omega3_4 * w_10 + Scalar(3.0) * omega3_2 * w_11 - lump * (Scalar(72.0) * omega1_4 * omega3_2
      - Scalar(336.0) * omega1_3 * omega3_3 - Scalar(72.0) * omega1_2 * omega2_2 * omega3_2
      + Scalar(540.0) * omega1_2 * omega3_4 + Scalar(144.0) * omega1 * omega2_2 * omega3_3
      - Scalar(360.0) * omega1 * omega3_5 - Scalar(60.0) * omega2_2 * omega3_4
      + Scalar(84.0) * omega3_6)) / denominator;
  gradient[3] = (Scalar(2.0) * a113 * c_0 + a333 * c_1) / denominator;  // by a113
  gradient[4] = (Scalar(2.0) * a123 * c_2) / denominator;  // by a123
  gradient[6] = (a113 * c_1) / denominator;  // by a333
  gradient[10] = (c_3) / denominator;  // by b1133
}

/// gradient[p] = d harmonic_re_v1_A_v22_conjA_v1 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 172 operations.
template <class Scalar>
void lump_gradient_13(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar b1122 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar a123_2 = a123 * a123;
  const Scalar denominator = Scalar(16.0) * omega1_3 * omega2_3 - Scalar(4.0) * omega1_3 * omega2 * omega3_2
      - Scalar(48.0) * omega1_2 * omega2_4 + Scalar(12.0) * omega1_2 * omega2_2 * omega3_2
      + Scalar(48.0) * omega1 * omega2_5 - Scalar(28.0) * omega1 * omega2_3 * omega3_2
      + Scalar(4.0) * omega1 * omega2 * omega3_4 - Scalar(16.0) * omega2_6 + Scalar(20.0) * omega2_4 * omega3_2
      - Scalar(4.0) * omega2_2 * omega3_4;
  // multiplies a113*a223
  const Scalar c_0 = -Scalar(2.0) * omega1_2 + Scalar(4.0) * omega1 * omega2 - Scalar(2.0) * omega2_2
      + Scalar(2.0) * omega3_2;
  const Scalar c_1 = -Scalar(4.0) * omega2_2 + omega3_2;  // multiplies a123^2
  // multiplies b1122
  const Scalar c_2 = -Scalar(4.0) * omega1_2 * omega2_2 + omega1_2 * omega3_2 + Scalar(8.0) * omega1 * omega2_3
      - Scalar(2.0) * omega1 * omega2 * omega3_2 - Scalar(4.0) * omega2_4 + Scalar(5.0) * omega2_2 * omega3_2
      - omega3_4;
  const Scalar w_0 = -Scalar(4.0) * b1122;  // multiplies omega1^2*omega2^2
  const Scalar w_1 = b1122;  // multiplies omega1^2*omega3^2
  const Scalar w_2 = -Scalar(2.0) * a113 * a223;  // multiplies omega1^2
  const Scalar w_3 = Scalar(8.0) * b1122;  // multiplies omega1*omega2^3
  const Scalar w_4 = -Scalar(2.0) * b1122;  // multiplies omega1*omega2*omega3^2
  const Scalar w_5 = Scalar(4.0) * a113 * a223;  // multiplies omega1*omega2
  const Scalar w_6 = -Scalar(4.0) * b1122;  // multiplies omega2^4
  const Scalar w_7 = Scalar(5.0) * b1122;  // multiplies omega2^2*omega3^2
  const Scalar w_8 = -Scalar(2.0) * a113 * a223 - Scalar(4.0) * a123_2;  // multiplies omega2^2
  const Scalar w_9 = -b1122;  // multiplies omega3^4
  const Scalar w_10 = Scalar(2.0) * a113 * a223 + a123_2;  // multiplies omega3^2
  // by omega1
  gradient[0] = (Scalar(2.0) * omega1 * omega2_2 * w_0 + Scalar(2.0) * omega1 * omega3_2 * w_1
      + Scalar(2.0) * omega1 * w_2 + omega2_3 * w_3 + omega2 * omega3_2 * w_4 + omega2 * w_5
      - lump * (Scalar(48.0) * omega1_2 * omega2_3 - Scalar(12.0) * omega1_2 * omega2 * omega3_2
      - Scalar(96.0) * omega1 * omega2_4 + Scalar(24.0) * omega1 * omega2_2 * omega3_2 + Scalar(48.0) * omega2_5
      - Scalar(28.0) * omega2_3 * omega3_2 + Scalar(4.0) * omega2 * omega3_4)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_2 * omega2 * w_0 + Scalar(3.0) * omega1 * omega2_2 * w_3
      + omega1 * omega3_2 * w_4 + omega1 * w_5 + Scalar(4.0) * omega2_3 * w_6
      + Scalar(2.0) * omega2 * omega3_2 * w_7 + Scalar(2.0) * omega2 * w_8
      - lump * (Scalar(48.0) * omega1_3 * omega2_2 - Scalar(4.0) * omega1_3 * omega3_2
      - Scalar(192.0) * omega1_2 * omega2_3 + Scalar(24.0) * omega1_2 * omega2 * omega3_2
      + Scalar(240.0) * omega1 * omega2_4 - Scalar(84.0) * omega1 * omega2_2 * omega3_2
      + Scalar(4.0) * omega1 * omega3_4 - Scalar(96.0) * omega2_5 + Scalar(80.0) * omega2_3 * omega3_2
      - Scalar(8.0) * omega2 * omega3_4)) / denominator;
  // by omega3
  gradient[2] = (Scalar(2.0) * omega1_2 * omega3 * w_1 + Scalar(2.0) * omega1 * omega2 * omega3 * w_4
      + Scalar(2.0) * omega2_2 * omega3 * w_7 + Scalar(4.0) * omega3_3 * w_9 + Scalar(2.0) * omega3 * w_10
      - lump * (-Scalar(8.0) * omega1_3 * omega2 * omega3 + Scalar(24.0) * omega1_2 * omega2_2 * omega3
      - Scalar(56.0) * omega1 * omega2_3 * omega3 + Scalar(16.0) * omega1 * omega2 * omega3_3
      + Scalar(40.0) * omega2_4 * omega3 - Scalar(16.0) * omega2_2 * omega3_3)) / denominator;
  gradient[3] = (a223 * c_0) / denominator;  // by a113
  gradient[4] = (Scalar(2.0) * a123 * c_1) / denominator;  // by a123
  gradient[5] = (a113 * c_0) / denominator;  // by a223
  gradient[8] = (c_2) / denominator;  // by b1122
}

/// gradient[p] = d harmonic_re_v1_A_v32_conjA_v2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 189 operations.
template <class Scalar>
void lump_gradient_14(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar omega3_5 = omega3_4 * omega3;
  const Scalar omega3_6 = omega3_5 * omega3;
  const Scalar omega3_7 = omega3_6 * omega3;
  const Scalar denominator = Scalar(6.0) * omega1_4 * omega2 * omega3_2 - Scalar(3.0) * omega1_4 * omega3_3
      - Scalar(12.0) * omega1_2 * omega2_3 * omega3_2 + Scalar(42.0) * omega1_2 * omega2_2 * omega3_3
      - Scalar(48.0) * omega1_2 * omega2 * omega3_4 + Scalar(15.0) * omega1_2 * omega3_5
      + Scalar(6.0) * omega2_5 * omega3_2 - Scalar(39.0) * omega2_4 * omega3_3
      + Scalar(96.0) * omega2_3 * omega3_4 - Scalar(111.0) * omega2_2 * omega3_5
      + Scalar(60.0) * omega2 * omega3_6 - Scalar(12.0) * omega3_7;
  const Scalar c_0 = Scalar(12.0) * omega2 * omega3_2 - Scalar(6.0) * omega3_3;  // multiplies a113*a123
  // multiplies a123*a223
  const Scalar c_1 = Scalar(6.0) * omega1_2 * omega3 - Scalar(6.0) * omega2_2 * omega3
      + Scalar(12.0) * omega2 * omega3_2 - Scalar(6.0) * omega3_3;
  // multiplies a123*a333
  const Scalar c_2 = -Scalar(2.0) * omega1_2 * omega2 + omega1_2 * omega3 + Scalar(2.0) * omega2_3
      - Scalar(5.0) * omega2_2 * omega3 + Scalar(4.0) * omega2 * omega3_2 - omega3_3;
  const Scalar w_0 = -Scalar(2.0) * a123 * a333;  // multiplies omega1^2*omega2
  const Scalar w_1 = Scalar(6.0) * a123 * a223 + a123 * a333;  // multiplies omega1^2*omega3
  const Scalar w_2 = Scalar(2.0) * a123 * a333;  // multiplies omega2^3
  const Scalar w_3 = -Scalar(6.0) * a123 * a223 - Scalar(5.0) * a123 * a333;  // multiplies omega2^2*omega3
  // multiplies omega2*omega3^2
  const Scalar w_4 = Scalar(12.0) * a113 * a123 + Scalar(12.0) * a123 * a223 + Scalar(4.0) * a123 * a333;
  const Scalar w_5 = -Scalar(6.0) * a113 * a123 - Scalar(6.0) * a123 * a223 - a123 * a333;  // multiplies omega3^3
  // by omega1
  gradient[0] = (Scalar(2.0) * omega1 * omega2 * w_0 + Scalar(2.0) * omega1 * omega3 * w_1
      - lump * (Scalar(24.0) * omega1_3 * omega2 * omega3_2 - Scalar(12.0) * omega1_3 * omega3_3
      - Scalar(24.0) * omega1 * omega2_3 * omega3_2 + Scalar(84.0) * omega1 * omega2_2 * omega3_3
      - Scalar(96.0) * omega1 * omega2 * omega3_4 + Scalar(30.0) * omega1 * omega3_5)) / denominator;
  // by omega2
  gradient[1] = (omega1_2 * w_0 + Scalar(3.0) * omega2_2 * w_2 + Scalar(2.0) * omega2 * omega3 * w_3
      + omega3_2 * w_4 - lump * (Scalar(6.0) * omega1_4 * omega3_2 - Scalar(36.0) * omega1_2 * omega2_2 * omega3_2
      + Scalar(84.0) * omega1_2 * omega2 * omega3_3 - Scalar(48.0) * omega1_2 * omega3_4
      + Scalar(30.0) * omega2_4 * omega3_2 - Scalar(156.0) * omega2_3 * omega3_3
      + Scalar(288.0) * omega2_2 * omega3_4 - Scalar(222.0) * omega2 * omega3_5
      + Scalar(60.0) * omega3_6)) / denominator;
  // by omega3
  gradient[2] = (omega1_2 * w_1 + omega2_2 * w_3 + Scalar(2.0) * omega2 * omega3 * w_4
      + Scalar(3.0) * omega3_2 * w_5 - lump * (Scalar(12.0) * omega1_4 * omega2 * omega3
      - Scalar(9.0) * omega1_4 * omega3_2 - Scalar(24.0) * omega1_2 * omega2_3 * omega3
      + Scalar(126.0) * omega1_2 * omega2_2 * omega3_2 - Scalar(192.0) * omega1_2 * omega2 * omega3_3
      + Scalar(75.0) * omega1_2 * omega3_4 + Scalar(12.0) * omega2_5 * omega3
      - Scalar(117.0) * omega2_4 * omega3_2 + Scalar(384.0) * omega2_3 * omega3_3
      - Scalar(555.0) * omega2_2 * omega3_4 + Scalar(360.0) * omega2 * omega3_5
      - Scalar(84.0) * omega3_6)) / denominator;
  gradient[3] = (a123 * c_0) / denominator;  // by a113
  gradient[4] = (a113 * c_0 + a223 * c_1 + a333 * c_2) / denominator;  // by a123
  gradient[5] = (a123 * c_1) / denominator;  // by a223
  gradient[6] = (a123 * c_2) / denominator;  // by a333
}

/// gradient[p] = d harmonic_re_v1_A_v2_A_v3_conjA_v3 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 294 operations.
template <class Scalar>
void lump_gradient_15(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
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
  const Scalar omega2_7 = omega2_6 * omega2;
  const Scalar omega2_8 = omega2_7 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar omega3_5 = omega3_4 * omega3;
  const Scalar omega3_6 = omega3_5 * omega3;
  const Scalar omega3_7 = omega3_6 * omega3;
  const Scalar omega3_8 = omega3_7 * omega3;
  const Scalar denominator = Scalar(4.0) * omega1_6 * omega2_2 * omega3_2 - omega1_6 * omega3_4
      - Scalar(12.0) * omega1_4 * omega2_4 * omega3_2 - Scalar(5.0) * omega1_4 * omega2_2 * omega3_4
      + Scalar(2.0) * omega1_4 * omega3_6 + Scalar(12.0) * omega1_2 * omega2_6 * omega3_2
      - Scalar(3.0) * omega1_2 * omega2_4 * omega3_4 + Scalar(4.0) * omega1_2 * omega2_2 * omega3_6
      - omega1_2 * omega3_8 - Scalar(4.0) * omega2_8 * omega3_2 + Scalar(9.0) * omega2_6 * omega3_4
      - Scalar(6.0) * omega2_4 * omega3_6 + omega2_2 * omega3_8;
  // multiplies a113*a123
  const Scalar c_0 = Scalar(16.0) * omega1_2 * omega2_2 * omega3_2 - Scalar(4.0) * omega1_2 * omega3_4
      - Scalar(16.0) * omega2_4 * omega3_2 - Scalar(12.0) * omega2_2 * omega3_4 + Scalar(4.0) * omega3_6;
  // multiplies a123*a223
  const Scalar c_1 = Scalar(4.0) * omega1_4 * omega3_2 - Scalar(8.0) * omega1_2 * omega2_2 * omega3_2
      - Scalar(8.0) * omega1_2 * omega3_4 + Scalar(4.0) * omega2_4 * omega3_2 - Scalar(8.0) * omega2_2 * omega3_4
      + Scalar(4.0) * omega3_6;
  // multiplies a123*a333
  const Scalar c_2 = Scalar(8.0) * omega1_4 * omega2_2 - Scalar(2.0) * omega1_4 * omega3_2
      - Scalar(16.0) * omega1_2 * omega2_4 - Scalar(12.0) * omega1_2 * omega2_2 * omega3_2
      + Scalar(4.0) * omega1_2 * omega3_4 + Scalar(8.0) * omega2_6 - Scalar(18.0) * omega2_4 * omega3_2
      + Scalar(12.0) * omega2_2 * omega3_4 - Scalar(2.0) * omega3_6;
  const Scalar w_0 = Scalar(8.0) * a123 * a333;  // multiplies omega1^4*omega2^2
  const Scalar w_1 = Scalar(4.0) * a123 * a223 - Scalar(2.0) * a123 * a333;  // multiplies omega1^4*omega3^2
  const Scalar w_2 = -Scalar(16.0) * a123 * a333;  // multiplies omega1^2*omega2^4
  // multiplies omega1^2*omega2^2*omega3^2
  const Scalar w_3 = Scalar(16.0) * a113 * a123 - Scalar(8.0) * a123 * a223 - Scalar(12.0) * a123 * a333;
  // multiplies omega1^2*omega3^4
  const Scalar w_4 = -Scalar(4.0) * a113 * a123 - Scalar(8.0) * a123 * a223 + Scalar(4.0) * a123 * a333;
  const Scalar w_5 = Scalar(8.0) * a123 * a333;  // multiplies omega2^6
  // multiplies omega2^4*omega3^2
  const Scalar w_6 = -Scalar(16.0) * a113 * a123 + Scalar(4.0) * a123 * a223 - Scalar(18.0) * a123 * a333;
  // multiplies omega2^2*omega3^4
  const Scalar w_7 = -Scalar(12.0) * a113 * a123 - Scalar(8.0) * a123 * a223 + Scalar(12.0) * a123 * a333;
  // multiplies omega3^6
  const Scalar w_8 = Scalar(4.0) * a113 * a123 + Scalar(4.0) * a123 * a223 - Scalar(2.0) * a123 * a333;
  // by omega1
  gradient[0] = (Scalar(4.0) * omega1_3 * omega2_2 * w_0 + Scalar(4.0) * omega1_3 * omega3_2 * w_1
      + Scalar(2.0) * omega1 * omega2_4 * w_2 + Scalar(2.0) * omega1 * omega2_2 * omega3_2 * w_3
      + Scalar(2.0) * omega1 * omega3_4 * w_4 - lump * (Scalar(24.0) * omega1_5 * omega2_2 * omega3_2
      - Scalar(6.0) * omega1_5 * omega3_4 - Scalar(48.0) * omega1_3 * omega2_4 * omega3_2
      - Scalar(20.0) * omega1_3 * omega2_2 * omega3_4 + Scalar(8.0) * omega1_3 * omega3_6
      + Scalar(24.0) * omega1 * omega2_6 * omega3_2 - Scalar(6.0) * omega1 * omega2_4 * omega3_4
      + Scalar(8.0) * omega1 * omega2_2 * omega3_6 - Scalar(2.0) * omega1 * omega3_8)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_4 * omega2 * w_0 + Scalar(4.0) * omega1_2 * omega2_3 * w_2
      + Scalar(2.0) * omega1_2 * omega2 * omega3_2 * w_3 + Scalar(6.0) * omega2_5 * w_5
      + Scalar(4.0) * omega2_3 * omega3_2 * w_6 + Scalar(2.0) * omega2 * omega3_4 * w_7
      - lump * (Scalar(8.0) * omega1_6 * omega2 * omega3_2 - Scalar(48.0) * omega1_4 * omega2_3 * omega3_2
      - Scalar(10.0) * omega1_4 * omega2 * omega3_4 + Scalar(72.0) * omega1_2 * omega2_5 * omega3_2
      - Scalar(12.0) * omega1_2 * omega2_3 * omega3_4 + Scalar(8.0) * omega1_2 * omega2 * omega3_6
      - Scalar(32.0) * omega2_7 * omega3_2 + Scalar(54.0) * omega2_5 * omega3_4
      - Scalar(24.0) * omega2_3 * omega3_6 + Scalar(2.0) * omega2 * omega3_8)) / denominator;
  // by omega3
  gradient[2] = (Scalar(2.0) * omega1_4 * omega3 * w_1 + Scalar(2.0) * omega1_2 * omega2_2 * omega3 * w_3
      + Scalar(4.0) * omega1_2 * omega3_3 * w_4 + Scalar(2.0) * omega2_4 * omega3 * w_6
      + Scalar(4.0) * omega2_2 * omega3_3 * w_7 + Scalar(6.0) * omega3_5 * w_8
      - lump * (Scalar(8.0) * omega1_6 * omega2_2 * omega3 - Scalar(4.0) * omega1_6 * omega3_3
      - Scalar(24.0) * omega1_4 * omega2_4 * omega3 - Scalar(20.0) * omega1_4 * omega2_2 * omega3_3
      + Scalar(12.0) * omega1_4 * omega3_5 + Scalar(24.0) * omega1_2 * omega2_6 * omega3
      - Scalar(12.0) * omega1_2 * omega2_4 * omega3_3 + Scalar(24.0) * omega1_2 * omega2_2 * omega3_5
      - Scalar(8.0) * omega1_2 * omega3_7 - Scalar(8.0) * omega2_8 * omega3 + Scalar(36.0) * omega2_6 * omega3_3
      - Scalar(36.0) * omega2_4 * omega3_5 + Scalar(8.0) * omega2_2 * omega3_7)) / denominator;
  gradient[3] = (a123 * c_0) / denominator;  // by a113
  gradient[4] = (a113 * c_0 + a223 * c_1 + a333 * c_2) / denominator;  // by a123
  gradient[5] = (a123 * c_1) / denominator;  // by a223
  gradient[6] = (a123 * c_2) / denominator;  // by a333
}

/// gradient[p] = d harmonic_re_v1_A_v22_conjA_v2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 53 operations.
template <class Scalar>
void lump_gradient_16(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar denominator = Scalar(4.0) * omega1_2 * omega2_2 * omega3_2 - omega1_2 * omega3_4
      - Scalar(4.0) * omega2_4 * omega3_2 + omega2_2 * omega3_4;
  // by omega1
  gradient[0] = (-lump * (Scalar(8.0) * omega1 * omega2_2 * omega3_2
      - Scalar(2.0) * omega1 * omega3_4)) / denominator;
  // by omega2
  gradient[1] = (Scalar(16.0) * omega2 * a123 * a223 - lump * (Scalar(8.0) * omega1_2 * omega2 * omega3_2
      - Scalar(16.0) * omega2_3 * omega3_2 + Scalar(2.0) * omega2 * omega3_4)) / denominator;
  // by omega3
  gradient[2] = (-Scalar(6.0) * omega3 * a123 * a223 - lump * (Scalar(8.0) * omega1_2 * omega2_2 * omega3
      - Scalar(4.0) * omega1_2 * omega3_3 - Scalar(8.0) * omega2_4 * omega3
      + Scalar(4.0) * omega2_2 * omega3_3)) / denominator;
  gradient[4] = (Scalar(8.0) * omega2_2 * a223 - Scalar(3.0) * omega3_2 * a223) / denominator;  // by a123
  gradient[5] = (Scalar(8.0) * omega2_2 * a123 - Scalar(3.0) * omega3_2 * a123) / denominator;  // by a223
}

/// gradient[p] = d harmonic_re_v1_A_v2_A_v32 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 189 operations.
template <class Scalar>
void lump_gradient_17(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar omega3_5 = omega3_4 * omega3;
  const Scalar omega3_6 = omega3_5 * omega3;
  const Scalar omega3_7 = omega3_6 * omega3;
  const Scalar denominator = Scalar(6.0) * omega1_4 * omega2 * omega3_2 + Scalar(3.0) * omega1_4 * omega3_3
      - Scalar(12.0) * omega1_2 * omega2_3 * omega3_2 - Scalar(42.0) * omega1_2 * omega2_2 * omega3_3
      - Scalar(48.0) * omega1_2 * omega2 * omega3_4 - Scalar(15.0) * omega1_2 * omega3_5
      + Scalar(6.0) * omega2_5 * omega3_2 + Scalar(39.0) * omega2_4 * omega3_3
      + Scalar(96.0) * omega2_3 * omega3_4 + Scalar(111.0) * omega2_2 * omega3_5
      + Scalar(60.0) * omega2 * omega3_6 + Scalar(12.0) * omega3_7;
  const Scalar c_0 = Scalar(12.0) * omega2 * omega3_2 + Scalar(6.0) * omega3_3;  // multiplies a113*a123
  // multiplies a123*a223
  const Scalar c_1 = -Scalar(6.0) * omega1_2 * omega3 + Scalar(6.0) * omega2_2 * omega3
      + Scalar(12.0) * omega2 * omega3_2 + Scalar(6.0) * omega3_3;
  // multiplies a123*a333
  const Scalar c_2 = -Scalar(2.0) * omega1_2 * omega2 - omega1_2 * omega3 + Scalar(2.0) * omega2_3
      + Scalar(5.0) * omega2_2 * omega3 + Scalar(4.0) * omega2 * omega3_2 + omega3_3;
  const Scalar w_0 = -Scalar(2.0) * a123 * a333;  // multiplies omega1^2*omega2
  const Scalar w_1 = -Scalar(6.0) * a123 * a223 - a123 * a333;  // multiplies omega1^2*omega3
  const Scalar w_2 = Scalar(2.0) * a123 * a333;  // multiplies omega2^3
  const Scalar w_3 = Scalar(6.0) * a123 * a223 + Scalar(5.0) * a123 * a333;  // multiplies omega2^2*omega3
  // multiplies omega2*omega3^2
  const Scalar w_4 = Scalar(12.0) * a113 * a123 + Scalar(12.0) * a123 * a223 + Scalar(4.0) * a123 * a333;
  const Scalar w_5 = Scalar(6.0) * a113 * a123 + Scalar(6.0) * a123 * a223 + a123 * a333;  // multiplies omega3^3
  // by omega1
  gradient[0] = (Scalar(2.0) * omega1 * omega2 * w_0 + Scalar(2.0) * omega1 * omega3 * w_1
      - lump * (Scalar(24.0) * omega1_3 * omega2 * omega3_2 + Scalar(12.0) * omega1_3 * omega3_3
      - Scalar(24.0) * omega1 * omega2_3 * omega3_2 - Scalar(84.0) * omega1 * omega2_2 * omega3_3
      - Scalar(96.0) * omega1 * omega2 * omega3_4 - Scalar(30.0) * omega1 * omega3_5)) / denominator;
  // by omega2
  gradient[1] = (omega1_2 * w_0 + Scalar(3.0) * omega2_2 * w_2 + Scalar(2.0) * omega2 * omega3 * w_3
      + omega3_2 * w_4 - lump * (Scalar(6.0) * omega1_4 * omega3_2 - Scalar(36.0) * omega1_2 * omega2_2 * omega3_2
      - Scalar(84.0) * omega1_2 * omega2 * omega3_3 - Scalar(48.0) * omega1_2 * omega3_4
      + Scalar(30.0) * omega2_4 * omega3_2 + Scalar(156.0) * omega2_3 * omega3_3
      + Scalar(288.0) * omega2_2 * omega3_4 + Scalar(222.0) * omega2 * omega3_5
      + Scalar(60.0) * omega3_6)) / denominator;
  // by omega3
  gradient[2] = (omega1_2 * w_1 + omega2_2 * w_3 + Scalar(2.0) * omega2 * omega3 * w_4
      + Scalar(3.0) * omega3_2 * w_5 - lump * (Scalar(12.0) * omega1_4 * omega2 * omega3
      + Scalar(9.0) * omega1_4 * omega3_2 - Scalar(24.0) * omega1_2 * omega2_3 * omega3
      - Scalar(126.0) * omega1_2 * omega2_2 * omega3_2 - Scalar(192.0) * omega1_2 * omega2 * omega3_3
      - Scalar(75.0) * omega1_2 * omega3_4 + Scalar(12.0) * omega2_5 * omega3
      + Scalar(117.0) * omega2_4 * omega3_2 + Scalar(384.0) * omega2_3 * omega3_3
      + Scalar(555.0) * omega2_2 * omega3_4 + Scalar(360.0) * omega2 * omega3_5
      + Scalar(84.0) * omega3_6)) / denominator;
  gradient[3] = (a123 * c_0) / denominator;  // by a113
  gradient[4] = (a113 * c_0 + a223 * c_1 + a333 * c_2) / denominator;  // by a123
  gradient[5] = (a123 * c_1) / denominator;  // by a223
  gradient[6] = (a123 * c_2) / denominator;  // by a333
}

/// gradient[p] = d harmonic_re_v1_A_v1_A_v32 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 185 operations.
template <class Scalar>
void lump_gradient_18(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a333 = parameters[6];
  const Scalar b1133 = parameters[10];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar omega3_5 = omega3_4 * omega3;
  const Scalar omega3_6 = omega3_5 * omega3;
  const Scalar omega3_7 = omega3_6 * omega3;
  const Scalar a113_2 = a113 * a113;
  const Scalar a123_2 = a123 * a123;
  const Scalar denominator = Scalar(24.0) * omega1_4 * omega3_3 + Scalar(84.0) * omega1_3 * omega3_4
      - Scalar(24.0) * omega1_2 * omega2_2 * omega3_3 + Scalar(108.0) * omega1_2 * omega3_5
      - Scalar(36.0) * omega1 * omega2_2 * omega3_4 + Scalar(60.0) * omega1 * omega3_6
      - Scalar(12.0) * omega2_2 * omega3_5 + Scalar(12.0) * omega3_7;
  // multiplies a113^2
  const Scalar c_0 = Scalar(12.0) * omega1_2 * omega3 + Scalar(24.0) * omega1 * omega3_2
      - Scalar(12.0) * omega2_2 * omega3 + Scalar(12.0) * omega3_3;
  // multiplies a113*a333
  const Scalar c_1 = Scalar(4.0) * omega1_3 + Scalar(10.0) * omega1_2 * omega3 - Scalar(4.0) * omega1 * omega2_2
      + Scalar(8.0) * omega1 * omega3_2 - Scalar(2.0) * omega2_2 * omega3 + Scalar(2.0) * omega3_3;
  const Scalar c_2 = Scalar(6.0) * omega1 * omega3_2 + Scalar(3.0) * omega3_3;  // multiplies a123^2
  // multiplies b1133
  const Scalar c_3 = Scalar(6.0) * omega1_3 * omega3_2 + Scalar(15.0) * omega1_2 * omega3_3
      - Scalar(6.0) * omega1 * omega2_2 * omega3_2 + Scalar(12.0) * omega1 * omega3_4
      - Scalar(3.0) * omega2_2 * omega3_3 + Scalar(3.0) * omega3_5;
  const Scalar w_0 = Scalar(6.0) * b1133;  // multiplies omega1^3*omega3^2
  const Scalar w_1 = Scalar(4.0) * a113 * a333;  // multiplies omega1^3
  const Scalar w_2 = Scalar(15.0) * b1133;  // multiplies omega1^2*omega3^3
  const Scalar w_3 = Scalar(12.0) * a113_2 + Scalar(10.0) * a113 * a333;  // multiplies omega1^2*omega3
  const Scalar w_4 = -Scalar(6.0) * b1133;  // multiplies omega1*omega2^2*omega3^2
  const Scalar w_5 = -Scalar(4.0) * a113 * a333;  // multiplies omega1*omega2^2
  const Scalar w_6 = Scalar(12.0) * b1133;  // multiplies omega1*omega3^4
  // multiplies omega1*omega3^2
  const Scalar w_7 = Scalar(24.0) * a113_2 + Scalar(8.0) * a113 * a333 + Scalar(6.0) * a123_2;
  const Scalar w_8 = -Scalar(3.0) * b1133;  // multiplies omega2^2*omega3^3
  const Scalar w_9 = -Scalar(12.0) * a113_2 - Scalar(2.0) * a113 * a333;  // multiplies omega2^2*omega3
  const Scalar w_10 = Scalar(3.0) * b1133;  // multiplies omega3^5
  // multiplies omega3^3
  const Scalar w_11 = Scalar(12.0) * a113_2 + Scalar(2.0) * a113 * a333 + Scalar(3.0) * a123_2;
  // by omega1
  gradient[0] = (Scalar(3.0) * omega1_2 * omega3_2 * w_0 + Scalar(3.0) * omega1_2 * w_1
      + Scalar(2.0) * omega1 * omega3_3 * w_2 + Scalar(2.0) * omega1 * omega3 * w_3 + omega2_2 * omega3_2 * w_4
      + omega2_2 * w_5 + omega3_4 * w_6 + omega3_2 * w_7 - lump * (Scalar(96.0) * omega1_3 * omega3_3
      + Scalar(252.0) * omega1_2 * omega3_4 - Scalar(48.0) * omega1 * omega2_2 * omega3_3
      + Scalar(216.0) * omega1 * omega3_5 - Scalar(36.0) * omega2_2 * omega3_4
      + Scalar(60.0) * omega3_6)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1 * omega2 * omega3_2 * w_4 + Scalar(2.0) * omega1 * omega2 * w_5
      + Scalar(2.0) * omega2 * omega3_3 * w_8 + Scalar(2.0) * omega2 * omega3 * w_9
      - lump * (-Scalar(48.0) * omega1_2 * omega2 * omega3_3 - Scalar(72.0) * omega1 * omega2 * omega3_4
      - Scalar(24.0) * omega2 * omega3_5)) / denominator;
  // by omega3
  gradient[2] = (Scalar(2.0) * omega1_3 * omega3 * w_0 + Scalar(3.0) * omega1_2 * omega3_2 * w_2 + omega1_2 * w_3
      + Scalar(2.0) * omega1 * omega2_2 * omega3 * w_4 + Scalar(4.0) * omega1 * omega3_3 * w_6
      + Scalar(2.0) * omega1 * omega3 * w_7 + Scalar(3.0) * omega2_2 * omega3_2 * w_8 + omega2_2 * w_9
      + Scalar(5.0) * omega3_4 * w_10 + Scalar(3.0) * omega3_2 * w_11 - lump * (Scalar(72.0) * omega1_4 * omega3_2
      + Scalar(336.0) * omega1_3 * omega3_3 - Scalar(72.0) * omega1_2 * omega2_2 * omega3_2
      + Scalar(540.0) * omega1_2 * omega3_4 - Scalar(144.0) * omega1 * omega2_2 * omega3_3
      + Scalar(360.0) * omega1 * omega3_5 - Scalar(60.0) * omega2_2 * omega3_4
      + Scalar(84.0) * omega3_6)) / denominator;
  gradient[3] = (Scalar(2.0) * a113 * c_0 + a333 * c_1) / denominator;  // by a113
  gradient[4] = (Scalar(2.0) * a123 * c_2) / denominator;  // by a123
  gradient[6] = (a113 * c_1) / denominator;  // by a333
  gradient[10] = (c_3) / denominator;  // by b1133
}

/// gradient[p] = d harmonic_re_v1_A_v1_A_v22 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 172 operations.
template <class Scalar>
void lump_gradient_19(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar b1122 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar a123_2 = a123 * a123;
  const Scalar denominator = Scalar(16.0) * omega1_3 * omega2_3 - Scalar(4.0) * omega1_3 * omega2 * omega3_2
      + Scalar(48.0) * omega1_2 * omega2_4 - Scalar(12.0) * omega1_2 * omega2_2 * omega3_2
      + Scalar(48.0) * omega1 * omega2_5 - Scalar(28.0) * omega1 * omega2_3 * omega3_2
      + Scalar(4.0) * omega1 * omega2 * omega3_4 + Scalar(16.0) * omega2_6 - Scalar(20.0) * omega2_4 * omega3_2
      + Scalar(4.0) * omega2_2 * omega3_4;
  // multiplies a113*a223
  const Scalar c_0 = Scalar(2.0) * omega1_2 + Scalar(4.0) * omega1 * omega2 + Scalar(2.0) * omega2_2
      - Scalar(2.0) * omega3_2;
  const Scalar c_1 = Scalar(4.0) * omega2_2 - omega3_2;  // multiplies a123^2
  // multiplies b1122
  const Scalar c_2 = Scalar(4.0) * omega1_2 * omega2_2 - omega1_2 * omega3_2 + Scalar(8.0) * omega1 * omega2_3
      - Scalar(2.0) * omega1 * omega2 * omega3_2 + Scalar(4.0) * omega2_4 - Scalar(5.0) * omega2_2 * omega3_2
      + omega3_4;
  const Scalar w_0 = Scalar(4.0) * b1122;  // multiplies omega1^2*omega2^2
  const Scalar w_1 = -b1122;  // multiplies omega1^2*omega3^2
  const Scalar w_2 = Scalar(2.0) * a113 * a223;  // multiplies omega1^2
  const Scalar w_3 = Scalar(8.0) * b1122;  // multiplies omega1*omega2^3
  const Scalar w_4 = -Scalar(2.0) * b1122;  // multiplies omega1*omega2*omega3^2
  const Scalar w_5 = Scalar(4.0) * a113 * a223;  // multiplies omega1*omega2
  const Scalar w_6 = Scalar(4.0) * b1122;  // multiplies omega2^4
  const Scalar w_7 = -Scalar(5.0) * b1122;  // multiplies omega2^2*omega3^2
  const Scalar w_8 = Scalar(2.0) * a113 * a223 + Scalar(4.0) * a123_2;  // multiplies omega2^2
  const Scalar w_9 = b1122;  // multiplies omega3^4
  const Scalar w_10 = -Scalar(2.0) * a113 * a223 - a123_2;  // multiplies omega3^2
  // by omega1
  gradient[0] = (Scalar(2.0) * omega1 * omega2_2 * w_0 + Scalar(2.0) * omega1 * omega3_2 * w_1
      + Scalar(2.0) * omega1 * w_2 + omega2_3 * w_3 + omega2 * omega3_2 * w_4 + omega2 * w_5
      - lump * (Scalar(48.0) * omega1_2 * omega2_3 - Scalar(12.0) * omega1_2 * omega2 * omega3_2
      + Scalar(96.0) * omega1 * omega2_4 - Scalar(24.0) * omega1 * omega2_2 * omega3_2 + Scalar(48.0) * omega2_5
      - Scalar(28.0) * omega2_3 * omega3_2 + Scalar(4.0) * omega2 * omega3_4)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_2 * omega2 * w_0 + Scalar(3.0) * omega1 * omega2_2 * w_3
      + omega1 * omega3_2 * w_4 + omega1 * w_5 + Scalar(4.0) * omega2_3 * w_6
      + Scalar(2.0) * omega2 * omega3_2 * w_7 + Scalar(2.0) * omega2 * w_8
      - lump * (Scalar(48.0) * omega1_3 * omega2_2 - Scalar(4.0) * omega1_3 * omega3_2
      + Scalar(192.0) * omega1_2 * omega2_3 - Scalar(24.0) * omega1_2 * omega2 * omega3_2
      + Scalar(240.0) * omega1 * omega2_4 - Scalar(84.0) * omega1 * omega2_2 * omega3_2
      + Scalar(4.0) * omega1 * omega3_4 + Scalar(96.0) * omega2_5 - Scalar(80.0) * omega2_3 * omega3_2
      + Scalar(8.0) * omega2 * omega3_4)) / denominator;
  // by omega3
  gradient[2] = (Scalar(2.0) * omega1_2 * omega3 * w_1 + Scalar(2.0) * omega1 * omega2 * omega3 * w_4
      + Scalar(2.0) * omega2_2 * omega3 * w_7 + Scalar(4.0) * omega3_3 * w_9 + Scalar(2.0) * omega3 * w_10
      - lump * (-Scalar(8.0) * omega1_3 * omega2 * omega3 - Scalar(24.0) * omega1_2 * omega2_2 * omega3
      - Scalar(56.0) * omega1 * omega2_3 * omega3 + Scalar(16.0) * omega1 * omega2 * omega3_3
      - Scalar(40.0) * omega2_4 * omega3 + Scalar(16.0) * omega2_2 * omega3_3)) / denominator;
  gradient[3] = (a223 * c_0) / denominator;  // by a113
  gradient[4] = (Scalar(2.0) * a123 * c_1) / denominator;  // by a123
  gradient[5] = (a113 * c_0) / denominator;  // by a223
  gradient[8] = (c_2) / denominator;  // by b1122
}

/// gradient[p] = d harmonic_re_v1_A_v13 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 17 operations.
template <class Scalar>
void lump_gradient_20(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar b1111 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar denominator = Scalar(32.0) * omega1_4 - Scalar(8.0) * omega1_2 * omega3_2;
  // by omega1
  gradient[0] = (Scalar(8.0) * omega1 * b1111 - lump * (Scalar(128.0) * omega1_3
      - Scalar(16.0) * omega1 * omega3_2)) / denominator;
  // by omega3
  gradient[2] = (-Scalar(2.0) * omega3 * b1111 - lump * (-Scalar(16.0) * omega1_2 * omega3)) / denominator;
  gradient[3] = (Scalar(4.0) * a113) / denominator;  // by a113
  gradient[7] = (Scalar(4.0) * omega1_2 - omega3_2) / denominator;  // by b1111
}

/// gradient[p] = d harmonic_re_v2_A_v2_conjA_v12 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 172 operations.
template <class Scalar>
void lump_gradient_22(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar b1122 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega1_6 = omega1_5 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar a123_2 = a123 * a123;
  const Scalar denominator = Scalar(16.0) * omega1_6 - Scalar(48.0) * omega1_5 * omega2
      + Scalar(48.0) * omega1_4 * omega2_2 - Scalar(20.0) * omega1_4 * omega3_2
      - Scalar(16.0) * omega1_3 * omega2_3 + Scalar(28.0) * omega1_3 * omega2 * omega3_2
      - Scalar(12.0) * omega1_2 * omega2_2 * omega3_2 + Scalar(4.0) * omega1_2 * omega3_4
      + Scalar(4.0) * omega1 * omega2_3 * omega3_2 - Scalar(4.0) * omega1 * omega2 * omega3_4;
  // multiplies a113*a223
  const Scalar c_0 = Scalar(2.0) * omega1_2 - Scalar(4.0) * omega1 * omega2 + Scalar(2.0) * omega2_2
      - Scalar(2.0) * omega3_2;
  const Scalar c_1 = Scalar(4.0) * omega1_2 - omega3_2;  // multiplies a123^2
  // multiplies b1122
  const Scalar c_2 = Scalar(4.0) * omega1_4 - Scalar(8.0) * omega1_3 * omega2 + Scalar(4.0) * omega1_2 * omega2_2
      - Scalar(5.0) * omega1_2 * omega3_2 + Scalar(2.0) * omega1 * omega2 * omega3_2 - omega2_2 * omega3_2
      + omega3_4;
  const Scalar w_0 = Scalar(4.0) * b1122;  // multiplies omega1^4
  const Scalar w_1 = -Scalar(8.0) * b1122;  // multiplies omega1^3*omega2
  const Scalar w_2 = Scalar(4.0) * b1122;  // multiplies omega1^2*omega2^2
  const Scalar w_3 = -Scalar(5.0) * b1122;  // multiplies omega1^2*omega3^2
  const Scalar w_4 = Scalar(2.0) * a113 * a223 + Scalar(4.0) * a123_2;  // multiplies omega1^2
  const Scalar w_5 = Scalar(2.0) * b1122;  // multiplies omega1*omega2*omega3^2
  const Scalar w_6 = -Scalar(4.0) * a113 * a223;  // multiplies omega1*omega2
  const Scalar w_7 = -b1122;  // multiplies omega2^2*omega3^2
  const Scalar w_8 = Scalar(2.0) * a113 * a223;  // multiplies omega2^2
  const Scalar w_9 = b1122;  // multiplies omega3^4
  const Scalar w_10 = -Scalar(2.0) * a113 * a223 - a123_2;  // multiplies omega3^2
  // by omega1
  gradient[0] = (Scalar(4.0) * omega1_3 * w_0 + Scalar(3.0) * omega1_2 * omega2 * w_1
      + Scalar(2.0) * omega1 * omega2_2 * w_2 + Scalar(2.0) * omega1 * omega3_2 * w_3 + Scalar(2.0) * omega1 * w_4
      + omega2 * omega3_2 * w_5 + omega2 * w_6 - lump * (Scalar(96.0) * omega1_5
      - Scalar(240.0) * omega1_4 * omega2 + Scalar(192.0) * omega1_3 * omega2_2
      - Scalar(80.0) * omega1_3 * omega3_2 - Scalar(48.0) * omega1_2 * omega2_3
      + Scalar(84.0) * omega1_2 * omega2 * omega3_2 - Scalar(24.0) * omega1 * omega2_2 * omega3_2
      + Scalar(8.0) * omega1 * omega3_4 + Scalar(4.0) * omega2_3 * omega3_2
      - Scalar(4.0) * omega2 * omega3_4)) / denominator;
  // by omega2
  gradient[1] = (omega1_3 * w_1 + Scalar(2.0) * omega1_2 * omega2 * w_2 + omega1 * omega3_2 * w_5 + omega1 * w_6
      + Scalar(2.0) * omega2 * omega3_2 * w_7 + Scalar(2.0) * omega2 * w_8 - lump * (-Scalar(48.0) * omega1_5
      + Scalar(96.0) * omega1_4 * omega2 - Scalar(48.0) * omega1_3 * omega2_2 + Scalar(28.0) * omega1_3 * omega3_2
      - Scalar(24.0) * omega1_2 * omega2 * omega3_2 + Scalar(12.0) * omega1 * omega2_2 * omega3_2
      - Scalar(4.0) * omega1 * omega3_4)) / denominator;
  // by omega3
  gradient[2] = (Scalar(2.0) * omega1_2 * omega3 * w_3 + Scalar(2.0) * omega1 * omega2 * omega3 * w_5
      + Scalar(2.0) * omega2_2 * omega3 * w_7 + Scalar(4.0) * omega3_3 * w_9 + Scalar(2.0) * omega3 * w_10
      - lump * (-Scalar(40.0) * omega1_4 * omega3 + Scalar(56.0) * omega1_3 * omega2 * omega3
      - Scalar(24.0) * omega1_2 * omega2_2 * omega3 + Scalar(16.0) * omega1_2 * omega3_3
      + Scalar(8.0) * omega1 * omega2_3 * omega3 - Scalar(16.0) * omega1 * omega2 * omega3_3)) / denominator;
  gradient[3] = (a223 * c_0) / denominator;  // by a113
  gradient[4] = (Scalar(2.0) * a123 * c_1) / denominator;  // by a123
  gradient[5] = (a113 * c_0) / denominator;  // by a223
  gradient[8] = (c_2) / denominator;  // by b1122
}

/// gradient[p] = d harmonic_re_v2_A_v32_conjA_v1 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 189 operations.
template <class Scalar>
void lump_gradient_23(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar omega3_5 = omega3_4 * omega3;
  const Scalar omega3_6 = omega3_5 * omega3;
  const Scalar omega3_7 = omega3_6 * omega3;
  const Scalar denominator = Scalar(6.0) * omega1_5 * omega3_2 - Scalar(39.0) * omega1_4 * omega3_3
      - Scalar(12.0) * omega1_3 * omega2_2 * omega3_2 + Scalar(96.0) * omega1_3 * omega3_4
      + Scalar(42.0) * omega1_2 * omega2_2 * omega3_3 - Scalar(111.0) * omega1_2 * omega3_5
      + Scalar(6.0) * omega1 * omega2_4 * omega3_2 - Scalar(48.0) * omega1 * omega2_2 * omega3_4
      + Scalar(60.0) * omega1 * omega3_6 - Scalar(3.0) * omega2_4 * omega3_3 + Scalar(15.0) * omega2_2 * omega3_5
      - Scalar(12.0) * omega3_7;
  // multiplies a113*a123
  const Scalar c_0 = -Scalar(6.0) * omega1_2 * omega3 + Scalar(12.0) * omega1 * omega3_2
      + Scalar(6.0) * omega2_2 * omega3 - Scalar(6.0) * omega3_3;
  const Scalar c_1 = Scalar(12.0) * omega1 * omega3_2 - Scalar(6.0) * omega3_3;  // multiplies a123*a223
  // multiplies a123*a333
  const Scalar c_2 = Scalar(2.0) * omega1_3 - Scalar(5.0) * omega1_2 * omega3 - Scalar(2.0) * omega1 * omega2_2
      + Scalar(4.0) * omega1 * omega3_2 + omega2_2 * omega3 - omega3_3;
  const Scalar w_0 = Scalar(2.0) * a123 * a333;  // multiplies omega1^3
  const Scalar w_1 = -Scalar(6.0) * a113 * a123 - Scalar(5.0) * a123 * a333;  // multiplies omega1^2*omega3
  const Scalar w_2 = -Scalar(2.0) * a123 * a333;  // multiplies omega1*omega2^2
  // multiplies omega1*omega3^2
  const Scalar w_3 = Scalar(12.0) * a113 * a123 + Scalar(12.0) * a123 * a223 + Scalar(4.0) * a123 * a333;
  const Scalar w_4 = Scalar(6.0) * a113 * a123 + a123 * a333;  // multiplies omega2^2*omega3
  const Scalar w_5 = -Scalar(6.0) * a113 * a123 - Scalar(6.0) * a123 * a223 - a123 * a333;  // multiplies omega3^3
  // by omega1
  gradient[0] = (Scalar(3.0) * omega1_2 * w_0 + Scalar(2.0) * omega1 * omega3 * w_1 + omega2_2 * w_2
      + omega3_2 * w_3 - lump * (Scalar(30.0) * omega1_4 * omega3_2 - Scalar(156.0) * omega1_3 * omega3_3
      - Scalar(36.0) * omega1_2 * omega2_2 * omega3_2 + Scalar(288.0) * omega1_2 * omega3_4
      + Scalar(84.0) * omega1 * omega2_2 * omega3_3 - Scalar(222.0) * omega1 * omega3_5
      + Scalar(6.0) * omega2_4 * omega3_2 - Scalar(48.0) * omega2_2 * omega3_4
      + Scalar(60.0) * omega3_6)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1 * omega2 * w_2 + Scalar(2.0) * omega2 * omega3 * w_4
      - lump * (-Scalar(24.0) * omega1_3 * omega2 * omega3_2 + Scalar(84.0) * omega1_2 * omega2 * omega3_3
      + Scalar(24.0) * omega1 * omega2_3 * omega3_2 - Scalar(96.0) * omega1 * omega2 * omega3_4
      - Scalar(12.0) * omega2_3 * omega3_3 + Scalar(30.0) * omega2 * omega3_5)) / denominator;
  // by omega3
  gradient[2] = (omega1_2 * w_1 + Scalar(2.0) * omega1 * omega3 * w_3 + omega2_2 * w_4
      + Scalar(3.0) * omega3_2 * w_5 - lump * (Scalar(12.0) * omega1_5 * omega3
      - Scalar(117.0) * omega1_4 * omega3_2 - Scalar(24.0) * omega1_3 * omega2_2 * omega3
      + Scalar(384.0) * omega1_3 * omega3_3 + Scalar(126.0) * omega1_2 * omega2_2 * omega3_2
      - Scalar(555.0) * omega1_2 * omega3_4 + Scalar(12.0) * omega1 * omega2_4 * omega3
      - Scalar(192.0) * omega1 * omega2_2 * omega3_3 + Scalar(360.0) * omega1 * omega3_5
      - Scalar(9.0) * omega2_4 * omega3_2 + Scalar(75.0) * omega2_2 * omega3_4
      - Scalar(84.0) * omega3_6)) / denominator;
  gradient[3] = (a123 * c_0) / denominator;  // by a113
  gradient[4] = (a113 * c_0 + a223 * c_1 + a333 * c_2) / denominator;  // by a123
  gradient[5] = (a123 * c_1) / denominator;  // by a223
  gradient[6] = (a123 * c_2) / denominator;  // by a333
}

/// gradient[p] = d harmonic_re_v2_A_v32_conjA_v2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 185 operations.
template <class Scalar>
void lump_gradient_24(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar b2233 = parameters[11];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar omega3_5 = omega3_4 * omega3;
  const Scalar omega3_6 = omega3_5 * omega3;
  const Scalar omega3_7 = omega3_6 * omega3;
  const Scalar a123_2 = a123 * a123;
  const Scalar a223_2 = a223 * a223;
  const Scalar denominator = Scalar(24.0) * omega1_2 * omega2_2 * omega3_3
      - Scalar(36.0) * omega1_2 * omega2 * omega3_4 + Scalar(12.0) * omega1_2 * omega3_5
      - Scalar(24.0) * omega2_4 * omega3_3 + Scalar(84.0) * omega2_3 * omega3_4
      - Scalar(108.0) * omega2_2 * omega3_5 + Scalar(60.0) * omega2 * omega3_6 - Scalar(12.0) * omega3_7;
  const Scalar c_0 = Scalar(6.0) * omega2 * omega3_2 - Scalar(3.0) * omega3_3;  // multiplies a123^2
  // multiplies a223^2
  const Scalar c_1 = Scalar(12.0) * omega1_2 * omega3 - Scalar(12.0) * omega2_2 * omega3
      + Scalar(24.0) * omega2 * omega3_2 - Scalar(12.0) * omega3_3;
  // multiplies a223*a333
  const Scalar c_2 = -Scalar(4.0) * omega1_2 * omega2 + Scalar(2.0) * omega1_2 * omega3 + Scalar(4.0) * omega2_3
      - Scalar(10.0) * omega2_2 * omega3 + Scalar(8.0) * omega2 * omega3_2 - Scalar(2.0) * omega3_3;
  // multiplies b2233
  const Scalar c_3 = -Scalar(6.0) * omega1_2 * omega2 * omega3_2 + Scalar(3.0) * omega1_2 * omega3_3
      + Scalar(6.0) * omega2_3 * omega3_2 - Scalar(15.0) * omega2_2 * omega3_3 + Scalar(12.0) * omega2 * omega3_4
      - Scalar(3.0) * omega3_5;
  const Scalar w_0 = -Scalar(6.0) * b2233;  // multiplies omega1^2*omega2*omega3^2
  const Scalar w_1 = -Scalar(4.0) * a223 * a333;  // multiplies omega1^2*omega2
  const Scalar w_2 = Scalar(3.0) * b2233;  // multiplies omega1^2*omega3^3
  const Scalar w_3 = Scalar(12.0) * a223_2 + Scalar(2.0) * a223 * a333;  // multiplies omega1^2*omega3
  const Scalar w_4 = Scalar(6.0) * b2233;  // multiplies omega2^3*omega3^2
  const Scalar w_5 = Scalar(4.0) * a223 * a333;  // multiplies omega2^3
  const Scalar w_6 = -Scalar(15.0) * b2233;  // multiplies omega2^2*omega3^3
  const Scalar w_7 = -Scalar(12.0) * a223_2 - Scalar(10.0) * a223 * a333;  // multiplies omega2^2*omega3
  const Scalar w_8 = Scalar(12.0) * b2233;  // multiplies omega2*omega3^4
  // multiplies omega2*omega3^2
  const Scalar w_9 = Scalar(6.0) * a123_2 + Scalar(24.0) * a223_2 + Scalar(8.0) * a223 * a333;
  const Scalar w_10 = -Scalar(3.0) * b2233;  // multiplies omega3^5
  // multiplies omega3^3
  const Scalar w_11 = -Scalar(3.0) * a123_2 - Scalar(12.0) * a223_2 - Scalar(2.0) * a223 * a333;
  // by omega1
  gradient[0] = (Scalar(2.0) * omega1 * omega2 * omega3_2 * w_0 + Scalar(2.0) * omega1 * omega2 * w_1
      + Scalar(2.0) * omega1 * omega3_3 * w_2 + Scalar(2.0) * omega1 * omega3 * w_3
      - lump * (Scalar(48.0) * omega1 * omega2_2 * omega3_3 - Scalar(72.0) * omega1 * omega2 * omega3_4
      + Scalar(24.0) * omega1 * omega3_5)) / denominator;
  // by omega2
  gradient[1] = (omega1_2 * omega3_2 * w_0 + omega1_2 * w_1 + Scalar(3.0) * omega2_2 * omega3_2 * w_4
      + Scalar(3.0) * omega2_2 * w_5 + Scalar(2.0) * omega2 * omega3_3 * w_6 + Scalar(2.0) * omega2 * omega3 * w_7
      + omega3_4 * w_8 + omega3_2 * w_9 - lump * (Scalar(48.0) * omega1_2 * omega2 * omega3_3
      - Scalar(36.0) * omega1_2 * omega3_4 - Scalar(96.0) * omega2_3 * omega3_3
      + Scalar(252.0) * omega2_2 * omega3_4 - Scalar(216.0) * omega2 * omega3_5
      + Scalar(60.0) * omega3_6)) / denominator;
  // by omega3
  gradient[2] = (Scalar(2.0) * omega1_2 * omega2 * omega3 * w_0 + Scalar(3.0) * omega1_2 * omega3_2 * w_2
      + omega1_2 * w_3 + Scalar(2.0) * omega2_3 * omega3 * w_4 + Scalar(3.0) * omega2_2 * omega3_2 * w_6
      + omega2_2 * w_7 + Scalar(4.0) * omega2 * omega3_3 * w_8 + Scalar(2.0) * omega2 * omega3 * w_9
      + Scalar(5.0) * omega3_4 * w_10 + Scalar(3.0) * omega3_2 * w_11
      - lump * (Scalar(72.0) * omega1_2 * omega2_2 * omega3_2 - Scalar(144.0) * omega1_2 * omega2 * omega3_3
      + Scalar(60.0) * omega1_2 * omega3_4 - Scalar(72.0) * omega2_4 * omega3_2
      + Scalar(336.0) * omega2_3 * omega3_3 - Scalar(540.0) * omega2_2 * omega3_4
      + Scalar(360.0) * omega2 * omega3_5 - Scalar(84.0) * omega3_6)) / denominator;
  gradient[4] = (Scalar(2.0) * a123 * c_0) / denominator;  // by a123
  gradient[5] = (Scalar(2.0) * a223 * c_1 + a333 * c_2) / denominator;  // by a223
  gradient[6] = (a223 * c_2) / denominator;  // by a333
  gradient[11] = (c_3) / denominator;  // by b2233
}

/// gradient[p] = d harmonic_re_v2_A_v2_A_v32 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 185 operations.
template <class Scalar>
void lump_gradient_25(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar b2233 = parameters[11];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar omega3_5 = omega3_4 * omega3;
  const Scalar omega3_6 = omega3_5 * omega3;
  const Scalar omega3_7 = omega3_6 * omega3;
  const Scalar a123_2 = a123 * a123;
  const Scalar a223_2 = a223 * a223;
  const Scalar denominator = Scalar(24.0) * omega1_2 * omega2_2 * omega3_3
      + Scalar(36.0) * omega1_2 * omega2 * omega3_4 + Scalar(12.0) * omega1_2 * omega3_5
      - Scalar(24.0) * omega2_4 * omega3_3 - Scalar(84.0) * omega2_3 * omega3_4
      - Scalar(108.0) * omega2_2 * omega3_5 - Scalar(60.0) * omega2 * omega3_6 - Scalar(12.0) * omega3_7;
  const Scalar c_0 = -Scalar(6.0) * omega2 * omega3_2 - Scalar(3.0) * omega3_3;  // multiplies a123^2
  // multiplies a223^2
  const Scalar c_1 = Scalar(12.0) * omega1_2 * omega3 - Scalar(12.0) * omega2_2 * omega3
      - Scalar(24.0) * omega2 * omega3_2 - Scalar(12.0) * omega3_3;
  // multiplies a223*a333
  const Scalar c_2 = Scalar(4.0) * omega1_2 * omega2 + Scalar(2.0) * omega1_2 * omega3 - Scalar(4.0) * omega2_3
      - Scalar(10.0) * omega2_2 * omega3 - Scalar(8.0) * omega2 * omega3_2 - Scalar(2.0) * omega3_3;
  // multiplies b2233
  const Scalar c_3 = Scalar(6.0) * omega1_2 * omega2 * omega3_2 + Scalar(3.0) * omega1_2 * omega3_3
      - Scalar(6.0) * omega2_3 * omega3_2 - Scalar(15.0) * omega2_2 * omega3_3 - Scalar(12.0) * omega2 * omega3_4
      - Scalar(3.0) * omega3_5;
  const Scalar w_0 = Scalar(6.0) * b2233;  // multiplies omega1^2*omega2*omega3^2
  const Scalar w_1 = Scalar(4.0) * a223 * a333;  // multiplies omega1^2*omega2
  const Scalar w_2 = Scalar(3.0) * b2233;  // multiplies omega1^2*omega3^3
  const Scalar w_3 = Scalar(12.0) * a223_2 + Scalar(2.0) * a223 * a333;  // multiplies omega1^2*omega3
  const Scalar w_4 = -Scalar(6.0) * b2233;  // multiplies omega2^3*omega3^2
  const Scalar w_5 = -Scalar(4.0) * a223 * a333;  // multiplies omega2^3
  const Scalar w_6 = -Scalar(15.0) * b2233;  // multiplies omega2^2*omega3^3
  const Scalar w_7 = -Scalar(12.0) * a223_2 - Scalar(10.0) * a223 * a333;  // multiplies omega2^2*omega3
  const Scalar w_8 = -Scalar(12.0) * b2233;  // multiplies omega2*omega3^4
  // multiplies omega2*omega3^2
  const Scalar w_9 = -Scalar(6.0) * a123_2 - Scalar(24.0) * a223_2 - Scalar(8.0) * a223 * a333;
  const Scalar w_10 = -Scalar(3.0) * b2233;  // multiplies omega3^5
  // multiplies omega3^3
  const Scalar w_11 = -Scalar(3.0) * a123_2 - Scalar(12.0) * a223_2 - Scalar(2.0) * a223 * a333;
  // by omega1
  gradient[0] = (Scalar(2.0) * omega1 * omega2 * omega3_2 * w_0 + Scalar(2.0) * omega1 * omega2 * w_1
      + Scalar(2.0) * omega1 * omega3_3 * w_2 + Scalar(2.0) * omega1 * omega3 * w_3
      - lump * (Scalar(48.0) * omega1 * omega2_2 * omega3_3 + Scalar(72.0) * omega1 * omega2 * omega3_4
      + Scalar(24.0) * omega1 * omega3_5)) / denominator;
  // by omega2
  gradient[1] = (omega1_2 * omega3_2 * w_0 + omega1_2 * w_1 + Scalar(3.0) * omega2_2 * omega3_2 * w_4
      + Scalar(3.0) * omega2_2 * w_5 + Scalar(2.0) * omega2 * omega3_3 * w_6 + Scalar(2.0) * omega2 * omega3 * w_7
      + omega3_4 * w_8 + omega3_2 * w_9 - lump * (Scalar(48.0) * omega1_2 * omega2 * omega3_3
      + Scalar(36.0) * omega1_2 * omega3_4 - Scalar(96.0) * omega2_3 * omega3_3
      - Scalar(252.0) * omega2_2 * omega3_4 - Scalar(216.0) * omega2 * omega3_5
      - Scalar(60.0) * omega3_6)) / denominator;
  // by omega3
  gradient[2] = (Scalar(2.0) * omega1_2 * omega2 * omega3 * w_0 + Scalar(3.0) * omega1_2 * omega3_2 * w_2
      + omega1_2 * w_3 + Scalar(2.0) * omega2_3 * omega3 * w_4 + Scalar(3.0) * omega2_2 * omega3_2 * w_6
      + omega2_2 * w_7 + Scalar(4.0) * omega2 * omega3_3 * w_8 + Scalar(2.0) * omega2 * omega3 * w_9
      + Scalar(5.0) * omega3_4 * w_10 + Scalar(3.0) * omega3_2 * w_11
      - lump * (Scalar(72.0) * omega1_2 * omega2_2 * omega3_2 + Scalar(144.0) * omega1_2 * omega2 * omega3_3
      + Scalar(60.0) * omega1_2 * omega3_4 - Scalar(72.0) * omega2_4 * omega3_2
      - Scalar(336.0) * omega2_3 * omega3_3 - Scalar(540.0) * omega2_2 * omega3_4
      - Scalar(360.0) * omega2 * omega3_5 - Scalar(84.0) * omega3_6)) / denominator;
  gradient[4] = (Scalar(2.0) * a123 * c_0) / denominator;  // by a123
  gradient[5] = (Scalar(2.0) * a223 * c_1 + a333 * c_2) / denominator;  // by a223
  gradient[6] = (a223 * c_2) / denominator;  // by a333
  gradient[11] = (c_3) / denominator;  // by b2233
}

/// gradient[p] = d harmonic_re_v2_A_v23 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 17 operations.
template <class Scalar>
void lump_gradient_26(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a223 = parameters[5];
  const Scalar b2222 = parameters[9];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar denominator = Scalar(32.0) * omega2_4 - Scalar(8.0) * omega2_2 * omega3_2;
  // by omega2
  gradient[1] = (Scalar(8.0) * omega2 * b2222 - lump * (Scalar(128.0) * omega2_3
      - Scalar(16.0) * omega2 * omega3_2)) / denominator;
  // by omega3
  gradient[2] = (-Scalar(2.0) * omega3 * b2222 - lump * (-Scalar(16.0) * omega2_2 * omega3)) / denominator;
  gradient[5] = (Scalar(4.0) * a223) / denominator;  // by a223
  gradient[9] = (Scalar(4.0) * omega2_2 - omega3_2) / denominator;  // by b2222
}

/// gradient[p] = d harmonic_re_v2_A_v1_A_v3_conjA_v3 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 294 operations.
template <class Scalar>
void lump_gradient_27(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega1_6 = omega1_5 * omega1;
  const Scalar omega1_7 = omega1_6 * omega1;
  const Scalar omega1_8 = omega1_7 * omega1;
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
  const Scalar omega3_7 = omega3_6 * omega3;
  const Scalar omega3_8 = omega3_7 * omega3;
  const Scalar denominator = Scalar(4.0) * omega1_8 * omega3_2 - Scalar(12.0) * omega1_6 * omega2_2 * omega3_2
      - Scalar(9.0) * omega1_6 * omega3_4 + Scalar(12.0) * omega1_4 * omega2_4 * omega3_2
      + Scalar(3.0) * omega1_4 * omega2_2 * omega3_4 + Scalar(6.0) * omega1_4 * omega3_6
      - Scalar(4.0) * omega1_2 * omega2_6 * omega3_2 + Scalar(5.0) * omega1_2 * omega2_4 * omega3_4
      - Scalar(4.0) * omega1_2 * omega2_2 * omega3_6 - omega1_2 * omega3_8 + omega2_6 * omega3_4
      - Scalar(2.0) * omega2_4 * omega3_6 + omega2_2 * omega3_8;
  // multiplies a113*a123
  const Scalar c_0 = -Scalar(4.0) * omega1_4 * omega3_2 + Scalar(8.0) * omega1_2 * omega2_2 * omega3_2
      + Scalar(8.0) * omega1_2 * omega3_4 - Scalar(4.0) * omega2_4 * omega3_2 + Scalar(8.0) * omega2_2 * omega3_4
      - Scalar(4.0) * omega3_6;
  // multiplies a123*a223
  const Scalar c_1 = Scalar(16.0) * omega1_4 * omega3_2 - Scalar(16.0) * omega1_2 * omega2_2 * omega3_2
      + Scalar(12.0) * omega1_2 * omega3_4 + Scalar(4.0) * omega2_2 * omega3_4 - Scalar(4.0) * omega3_6;
  // multiplies a123*a333
  const Scalar c_2 = -Scalar(8.0) * omega1_6 + Scalar(16.0) * omega1_4 * omega2_2
      + Scalar(18.0) * omega1_4 * omega3_2 - Scalar(8.0) * omega1_2 * omega2_4
      + Scalar(12.0) * omega1_2 * omega2_2 * omega3_2 - Scalar(12.0) * omega1_2 * omega3_4
      + Scalar(2.0) * omega2_4 * omega3_2 - Scalar(4.0) * omega2_2 * omega3_4 + Scalar(2.0) * omega3_6;
  const Scalar w_0 = -Scalar(8.0) * a123 * a333;  // multiplies omega1^6
  const Scalar w_1 = Scalar(16.0) * a123 * a333;  // multiplies omega1^4*omega2^2
  // multiplies omega1^4*omega3^2
  const Scalar w_2 = -Scalar(4.0) * a113 * a123 + Scalar(16.0) * a123 * a223 + Scalar(18.0) * a123 * a333;
  const Scalar w_3 = -Scalar(8.0) * a123 * a333;  // multiplies omega1^2*omega2^4
  // multiplies omega1^2*omega2^2*omega3^2
  const Scalar w_4 = Scalar(8.0) * a113 * a123 - Scalar(16.0) * a123 * a223 + Scalar(12.0) * a123 * a333;
  // multiplies omega1^2*omega3^4
  const Scalar w_5 = Scalar(8.0) * a113 * a123 + Scalar(12.0) * a123 * a223 - Scalar(12.0) * a123 * a333;
  const Scalar w_6 = -Scalar(4.0) * a113 * a123 + Scalar(2.0) * a123 * a333;  // multiplies omega2^4*omega3^2
  // multiplies omega2^2*omega3^4
  const Scalar w_7 = Scalar(8.0) * a113 * a123 + Scalar(4.0) * a123 * a223 - Scalar(4.0) * a123 * a333;
  // multiplies omega3^6
  const Scalar w_8 = -Scalar(4.0) * a113 * a123 - Scalar(4.0) * a123 * a223 + Scalar(2.0) * a123 * a333;
  // by omega1
  gradient[0] = (Scalar(6.0) * omega1_5 * w_0 + Scalar(4.0) * omega1_3 * omega2_2 * w_1
      + Scalar(4.0) * omega1_3 * omega3_2 * w_2 + Scalar(2.0) * omega1 * omega2_4 * w_3
      + Scalar(2.0) * omega1 * omega2_2 * omega3_2 * w_4 + Scalar(2.0) * omega1 * omega3_4 * w_5
      - lump * (Scalar(32.0) * omega1_7 * omega3_2 - Scalar(72.0) * omega1_5 * omega2_2 * omega3_2
      - Scalar(54.0) * omega1_5 * omega3_4 + Scalar(48.0) * omega1_3 * omega2_4 * omega3_2
      + Scalar(12.0) * omega1_3 * omega2_2 * omega3_4 + Scalar(24.0) * omega1_3 * omega3_6
      - Scalar(8.0) * omega1 * omega2_6 * omega3_2 + Scalar(10.0) * omega1 * omega2_4 * omega3_4
      - Scalar(8.0) * omega1 * omega2_2 * omega3_6 - Scalar(2.0) * omega1 * omega3_8)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_4 * omega2 * w_1 + Scalar(4.0) * omega1_2 * omega2_3 * w_3
      + Scalar(2.0) * omega1_2 * omega2 * omega3_2 * w_4 + Scalar(4.0) * omega2_3 * omega3_2 * w_6
      + Scalar(2.0) * omega2 * omega3_4 * w_7 - lump * (-Scalar(24.0) * omega1_6 * omega2 * omega3_2
      + Scalar(48.0) * omega1_4 * omega2_3 * omega3_2 + Scalar(6.0) * omega1_4 * omega2 * omega3_4
      - Scalar(24.0) * omega1_2 * omega2_5 * omega3_2 + Scalar(20.0) * omega1_2 * omega2_3 * omega3_4
      - Scalar(8.0) * omega1_2 * omega2 * omega3_6 + Scalar(6.0) * omega2_5 * omega3_4
      - Scalar(8.0) * omega2_3 * omega3_6 + Scalar(2.0) * omega2 * omega3_8)) / denominator;
  // by omega3
  gradient[2] = (Scalar(2.0) * omega1_4 * omega3 * w_2 + Scalar(2.0) * omega1_2 * omega2_2 * omega3 * w_4
      + Scalar(4.0) * omega1_2 * omega3_3 * w_5 + Scalar(2.0) * omega2_4 * omega3 * w_6
      + Scalar(4.0) * omega2_2 * omega3_3 * w_7 + Scalar(6.0) * omega3_5 * w_8
      - lump * (Scalar(8.0) * omega1_8 * omega3 - Scalar(24.0) * omega1_6 * omega2_2 * omega3
      - Scalar(36.0) * omega1_6 * omega3_3 + Scalar(24.0) * omega1_4 * omega2_4 * omega3
      + Scalar(12.0) * omega1_4 * omega2_2 * omega3_3 + Scalar(36.0) * omega1_4 * omega3_5
      - Scalar(8.0) * omega1_2 * omega2_6 * omega3 + Scalar(20.0) * omega1_2 * omega2_4 * omega3_3
      - Scalar(24.0) * omega1_2 * omega2_2 * omega3_5 - Scalar(8.0) * omega1_2 * omega3_7
      + Scalar(4.0) * omega2_6 * omega3_3 - Scalar(12.0) * omega2_4 * omega3_5
      + Scalar(8.0) * omega2_2 * omega3_7)) / denominator;
  gradient[3] = (a123 * c_0) / denominator;  // by a113
  gradient[4] = (a113 * c_0 + a223 * c_1 + a333 * c_2) / denominator;  // by a123
  gradient[5] = (a123 * c_1) / denominator;  // by a223
  gradient[6] = (a123 * c_2) / denominator;  // by a333
}

/// gradient[p] = d harmonic_re_v2_A_v1_A_v32 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 189 operations.
template <class Scalar>
void lump_gradient_28(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar omega3_5 = omega3_4 * omega3;
  const Scalar omega3_6 = omega3_5 * omega3;
  const Scalar omega3_7 = omega3_6 * omega3;
  const Scalar denominator = Scalar(6.0) * omega1_5 * omega3_2 + Scalar(39.0) * omega1_4 * omega3_3
      - Scalar(12.0) * omega1_3 * omega2_2 * omega3_2 + Scalar(96.0) * omega1_3 * omega3_4
      - Scalar(42.0) * omega1_2 * omega2_2 * omega3_3 + Scalar(111.0) * omega1_2 * omega3_5
      + Scalar(6.0) * omega1 * omega2_4 * omega3_2 - Scalar(48.0) * omega1 * omega2_2 * omega3_4
      + Scalar(60.0) * omega1 * omega3_6 + Scalar(3.0) * omega2_4 * omega3_3 - Scalar(15.0) * omega2_2 * omega3_5
      + Scalar(12.0) * omega3_7;
  // multiplies a113*a123
  const Scalar c_0 = Scalar(6.0) * omega1_2 * omega3 + Scalar(12.0) * omega1 * omega3_2
      - Scalar(6.0) * omega2_2 * omega3 + Scalar(6.0) * omega3_3;
  const Scalar c_1 = Scalar(12.0) * omega1 * omega3_2 + Scalar(6.0) * omega3_3;  // multiplies a123*a223
  // multiplies a123*a333
  const Scalar c_2 = Scalar(2.0) * omega1_3 + Scalar(5.0) * omega1_2 * omega3 - Scalar(2.0) * omega1 * omega2_2
      + Scalar(4.0) * omega1 * omega3_2 - omega2_2 * omega3 + omega3_3;
  const Scalar w_0 = Scalar(2.0) * a123 * a333;  // multiplies omega1^3
  const Scalar w_1 = Scalar(6.0) * a113 * a123 + Scalar(5.0) * a123 * a333;  // multiplies omega1^2*omega3
  const Scalar w_2 = -Scalar(2.0) * a123 * a333;  // multiplies omega1*omega2^2
  // multiplies omega1*omega3^2
  const Scalar w_3 = Scalar(12.0) * a113 * a123 + Scalar(12.0) * a123 * a223 + Scalar(4.0) * a123 * a333;
  const Scalar w_4 = -Scalar(6.0) * a113 * a123 - a123 * a333;  // multiplies omega2^2*omega3
  const Scalar w_5 = Scalar(6.0) * a113 * a123 + Scalar(6.0) * a123 * a223 + a123 * a333;  // multiplies omega3^3
  // by omega1
  gradient[0] = (Scalar(3.0) * omega1_2 * w_0 + Scalar(2.0) * omega1 * omega3 * w_1 + omega2_2 * w_2
      + omega3_2 * w_3 - lump * (Scalar(30.0) * omega1_4 * omega3_2 + Scalar(156.0) * omega1_3 * omega3_3
      - Scalar(36.0) * omega1_2 * omega2_2 * omega3_2 + Scalar(288.0) * omega1_2 * omega3_4
      - Scalar(84.0) * omega1 * omega2_2 * omega3_3 + Scalar(222.0) * omega1 * omega3_5
      + Scalar(6.0) * omega2_4 * omega3_2 - Scalar(48.0) * omega2_2 * omega3_4
      + Scalar(60.0) * omega3_6)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1 * omega2 * w_2 + Scalar(2.0) * omega2 * omega3 * w_4
      - lump * (-Scalar(24.0) * omega1_3 * omega2 * omega3_2 - Scalar(84.0) * omega1_2 * omega2 * omega3_3
      + Scalar(24.0) * omega1 * omega2_3 * omega3_2 - Scalar(96.0) * omega1 * omega2 * omega3_4
      + Scalar(12.0) * omega2_3 * omega3_3 - Scalar(30.0) * omega2 * omega3_5)) / denominator;
  // by omega3
  gradient[2] = (omega1_2 * w_1 + Scalar(2.0) * omega1 * omega3 * w_3 + omega2_2 * w_4
      + Scalar(3.0) * omega3_2 * w_5 - lump * (Scalar(12.0) * omega1_5 * omega3
      + Scalar(117.0) * omega1_4 * omega3_2 - Scalar(24.0) * omega1_3 * omega2_2 * omega3
      + Scalar(384.0) * omega1_3 * omega3_3 - Scalar(126.0) * omega1_2 * omega2_2 * omega3_2
      + Scalar(555.0) * omega1_2 * omega3_4 + Scalar(12.0) * omega1 * omega2_4 * omega3
      - Scalar(192.0) * omega1 * omega2_2 * omega3_3 + Scalar(360.0) * omega1 * omega3_5
      + Scalar(9.0) * omega2_4 * omega3_2 - Scalar(75.0) * omega2_2 * omega3_4
      + Scalar(84.0) * omega3_6)) / denominator;
  gradient[3] = (a123 * c_0) / denominator;  // by a113
  gradient[4] = (a113 * c_0 + a223 * c_1 + a333 * c_2) / denominator;  // by a123
  gradient[5] = (a123 * c_1) / denominator;  // by a223
  gradient[6] = (a123 * c_2) / denominator;  // by a333
}

/// gradient[p] = d harmonic_re_v2_A_v12_A_v2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 172 operations.
template <class Scalar>
void lump_gradient_29(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar b1122 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega1_6 = omega1_5 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar a123_2 = a123 * a123;
  const Scalar denominator = Scalar(16.0) * omega1_6 + Scalar(48.0) * omega1_5 * omega2
      + Scalar(48.0) * omega1_4 * omega2_2 - Scalar(20.0) * omega1_4 * omega3_2
      + Scalar(16.0) * omega1_3 * omega2_3 - Scalar(28.0) * omega1_3 * omega2 * omega3_2
      - Scalar(12.0) * omega1_2 * omega2_2 * omega3_2 + Scalar(4.0) * omega1_2 * omega3_4
      - Scalar(4.0) * omega1 * omega2_3 * omega3_2 + Scalar(4.0) * omega1 * omega2 * omega3_4;
  // multiplies a113*a223
  const Scalar c_0 = Scalar(2.0) * omega1_2 + Scalar(4.0) * omega1 * omega2 + Scalar(2.0) * omega2_2
      - Scalar(2.0) * omega3_2;
  const Scalar c_1 = Scalar(4.0) * omega1_2 - omega3_2;  // multiplies a123^2
  // multiplies b1122
  const Scalar c_2 = Scalar(4.0) * omega1_4 + Scalar(8.0) * omega1_3 * omega2 + Scalar(4.0) * omega1_2 * omega2_2
      - Scalar(5.0) * omega1_2 * omega3_2 - Scalar(2.0) * omega1 * omega2 * omega3_2 - omega2_2 * omega3_2
      + omega3_4;
  const Scalar w_0 = Scalar(4.0) * b1122;  // multiplies omega1^4
  const Scalar w_1 = Scalar(8.0) * b1122;  // multiplies omega1^3*omega2
  const Scalar w_2 = Scalar(4.0) * b1122;  // multiplies omega1^2*omega2^2
  const Scalar w_3 = -Scalar(5.0) * b1122;  // multiplies omega1^2*omega3^2
  const Scalar w_4 = Scalar(2.0) * a113 * a223 + Scalar(4.0) * a123_2;  // multiplies omega1^2
  const Scalar w_5 = -Scalar(2.0) * b1122;  // multiplies omega1*omega2*omega3^2
  const Scalar w_6 = Scalar(4.0) * a113 * a223;  // multiplies omega1*omega2
  const Scalar w_7 = -b1122;  // multiplies omega2^2*omega3^2
  const Scalar w_8 = Scalar(2.0) * a113 * a223;  // multiplies omega2^2
  const Scalar w_9 = b1122;  // multiplies omega3^4
  const Scalar w_10 = -Scalar(2.0) * a113 * a223 - a123_2;  // multiplies omega3^2
  // by omega1
  gradient[0] = (Scalar(4.0) * omega1_3 * w_0 + Scalar(3.0) * omega1_2 * omega2 * w_1
      + Scalar(2.0) * omega1 * omega2_2 * w_2 + Scalar(2.0) * omega1 * omega3_2 * w_3 + Scalar(2.0) * omega1 * w_4
      + omega2 * omega3_2 * w_5 + omega2 * w_6 - lump * (Scalar(96.0) * omega1_5
      + Scalar(240.0) * omega1_4 * omega2 + Scalar(192.0) * omega1_3 * omega2_2
      - Scalar(80.0) * omega1_3 * omega3_2 + Scalar(48.0) * omega1_2 * omega2_3
      - Scalar(84.0) * omega1_2 * omega2 * omega3_2 - Scalar(24.0) * omega1 * omega2_2 * omega3_2
      + Scalar(8.0) * omega1 * omega3_4 - Scalar(4.0) * omega2_3 * omega3_2
      + Scalar(4.0) * omega2 * omega3_4)) / denominator;
  // by omega2
  gradient[1] = (omega1_3 * w_1 + Scalar(2.0) * omega1_2 * omega2 * w_2 + omega1 * omega3_2 * w_5 + omega1 * w_6
      + Scalar(2.0) * omega2 * omega3_2 * w_7 + Scalar(2.0) * omega2 * w_8 - lump * (Scalar(48.0) * omega1_5
      + Scalar(96.0) * omega1_4 * omega2 + Scalar(48.0) * omega1_3 * omega2_2 - Scalar(28.0) * omega1_3 * omega3_2
      - Scalar(24.0) * omega1_2 * omega2 * omega3_2 - Scalar(12.0) * omega1 * omega2_2 * omega3_2
      + Scalar(4.0) * omega1 * omega3_4)) / denominator;
  // by omega3
  gradient[2] = (Scalar(2.0) * omega1_2 * omega3 * w_3 + Scalar(2.0) * omega1 * omega2 * omega3 * w_5
      + Scalar(2.0) * omega2_2 * omega3 * w_7 + Scalar(4.0) * omega3_3 * w_9 + Scalar(2.0) * omega3 * w_10
      - lump * (-Scalar(40.0) * omega1_4 * omega3 - Scalar(56.0) * omega1_3 * omega2 * omega3
      - Scalar(24.0) * omega1_2 * omega2_2 * omega3 + Scalar(16.0) * omega1_2 * omega3_3
      - Scalar(8.0) * omega1 * omega2_3 * omega3 + Scalar(16.0) * omega1 * omega2 * omega3_3)) / denominator;
  gradient[3] = (a223 * c_0) / denominator;  // by a113
  gradient[4] = (Scalar(2.0) * a123 * c_1) / denominator;  // by a123
  gradient[5] = (a113 * c_0) / denominator;  // by a223
  gradient[8] = (c_2) / denominator;  // by b1122
}

/// gradient[p] = d harmonic_re_v3_A_v3_conjA_v12 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 213 operations.
template <class Scalar>
void lump_gradient_31(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a333 = parameters[6];
  const Scalar b1133 = parameters[10];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega1_6 = omega1_5 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar omega3_5 = omega3_4 * omega3;
  const Scalar omega3_6 = omega3_5 * omega3;
  const Scalar a113_2 = a113 * a113;
  const Scalar a123_2 = a123 * a123;
  const Scalar denominator = Scalar(16.0) * omega1_6 * omega3 - Scalar(48.0) * omega1_5 * omega3_2
      - Scalar(16.0) * omega1_4 * omega2_2 * omega3 + Scalar(44.0) * omega1_4 * omega3_3
      + Scalar(16.0) * omega1_3 * omega2_2 * omega3_2 - Scalar(4.0) * omega1_3 * omega3_4
      + Scalar(4.0) * omega1_2 * omega2_2 * omega3_3 - Scalar(12.0) * omega1_2 * omega3_5
      - Scalar(4.0) * omega1 * omega2_2 * omega3_4 + Scalar(4.0) * omega1 * omega3_6;
  // multiplies a113^2
  const Scalar c_0 = -Scalar(8.0) * omega1_3 + Scalar(12.0) * omega1_2 * omega3 + Scalar(8.0) * omega1 * omega2_2
      + Scalar(4.0) * omega2_2 * omega3 - Scalar(4.0) * omega3_3;
  // multiplies a113*a333
  const Scalar c_1 = Scalar(2.0) * omega1_2 * omega3 - Scalar(4.0) * omega1 * omega3_2
      - Scalar(2.0) * omega2_2 * omega3 + Scalar(2.0) * omega3_3;
  const Scalar c_2 = Scalar(4.0) * omega1_2 * omega3 - omega3_3;  // multiplies a123^2
  // multiplies b1133
  const Scalar c_3 = Scalar(4.0) * omega1_4 * omega3 - Scalar(8.0) * omega1_3 * omega3_2
      - Scalar(4.0) * omega1_2 * omega2_2 * omega3 + Scalar(3.0) * omega1_2 * omega3_3
      + Scalar(2.0) * omega1 * omega3_4 + omega2_2 * omega3_3 - omega3_5;
  const Scalar w_0 = Scalar(4.0) * b1133;  // multiplies omega1^4*omega3
  const Scalar w_1 = -Scalar(8.0) * b1133;  // multiplies omega1^3*omega3^2
  const Scalar w_2 = -Scalar(8.0) * a113_2;  // multiplies omega1^3
  const Scalar w_3 = -Scalar(4.0) * b1133;  // multiplies omega1^2*omega2^2*omega3
  const Scalar w_4 = Scalar(3.0) * b1133;  // multiplies omega1^2*omega3^3
  // multiplies omega1^2*omega3
  const Scalar w_5 = Scalar(12.0) * a113_2 + Scalar(2.0) * a113 * a333 + Scalar(4.0) * a123_2;
  const Scalar w_6 = Scalar(8.0) * a113_2;  // multiplies omega1*omega2^2
  const Scalar w_7 = Scalar(2.0) * b1133;  // multiplies omega1*omega3^4
  const Scalar w_8 = -Scalar(4.0) * a113 * a333;  // multiplies omega1*omega3^2
  const Scalar w_9 = b1133;  // multiplies omega2^2*omega3^3
  const Scalar w_10 = Scalar(4.0) * a113_2 - Scalar(2.0) * a113 * a333;  // multiplies omega2^2*omega3
  const Scalar w_11 = -b1133;  // multiplies omega3^5
  const Scalar w_12 = -Scalar(4.0) * a113_2 + Scalar(2.0) * a113 * a333 - a123_2;  // multiplies omega3^3
  // by omega1
  gradient[0] = (Scalar(4.0) * omega1_3 * omega3 * w_0 + Scalar(3.0) * omega1_2 * omega3_2 * w_1
      + Scalar(3.0) * omega1_2 * w_2 + Scalar(2.0) * omega1 * omega2_2 * omega3 * w_3
      + Scalar(2.0) * omega1 * omega3_3 * w_4 + Scalar(2.0) * omega1 * omega3 * w_5 + omega2_2 * w_6
      + omega3_4 * w_7 + omega3_2 * w_8 - lump * (Scalar(96.0) * omega1_5 * omega3
      - Scalar(240.0) * omega1_4 * omega3_2 - Scalar(64.0) * omega1_3 * omega2_2 * omega3
      + Scalar(176.0) * omega1_3 * omega3_3 + Scalar(48.0) * omega1_2 * omega2_2 * omega3_2
      - Scalar(12.0) * omega1_2 * omega3_4 + Scalar(8.0) * omega1 * omega2_2 * omega3_3
      - Scalar(24.0) * omega1 * omega3_5 - Scalar(4.0) * omega2_2 * omega3_4
      + Scalar(4.0) * omega3_6)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_2 * omega2 * omega3 * w_3 + Scalar(2.0) * omega1 * omega2 * w_6
      + Scalar(2.0) * omega2 * omega3_3 * w_9 + Scalar(2.0) * omega2 * omega3 * w_10
      - lump * (-Scalar(32.0) * omega1_4 * omega2 * omega3 + Scalar(32.0) * omega1_3 * omega2 * omega3_2
      + Scalar(8.0) * omega1_2 * omega2 * omega3_3 - Scalar(8.0) * omega1 * omega2 * omega3_4)) / denominator;
  // by omega3
  gradient[2] = (omega1_4 * w_0 + Scalar(2.0) * omega1_3 * omega3 * w_1 + omega1_2 * omega2_2 * w_3
      + Scalar(3.0) * omega1_2 * omega3_2 * w_4 + omega1_2 * w_5 + Scalar(4.0) * omega1 * omega3_3 * w_7
      + Scalar(2.0) * omega1 * omega3 * w_8 + Scalar(3.0) * omega2_2 * omega3_2 * w_9 + omega2_2 * w_10
      + Scalar(5.0) * omega3_4 * w_11 + Scalar(3.0) * omega3_2 * w_12 - lump * (Scalar(16.0) * omega1_6
      - Scalar(96.0) * omega1_5 * omega3 - Scalar(16.0) * omega1_4 * omega2_2
      + Scalar(132.0) * omega1_4 * omega3_2 + Scalar(32.0) * omega1_3 * omega2_2 * omega3
      - Scalar(16.0) * omega1_3 * omega3_3 + Scalar(12.0) * omega1_2 * omega2_2 * omega3_2
      - Scalar(60.0) * omega1_2 * omega3_4 - Scalar(16.0) * omega1 * omega2_2 * omega3_3
      + Scalar(24.0) * omega1 * omega3_5)) / denominator;
  gradient[3] = (Scalar(2.0) * a113 * c_0 + a333 * c_1) / denominator;  // by a113
  gradient[4] = (Scalar(2.0) * a123 * c_2) / denominator;  // by a123
  gradient[6] = (a113 * c_1) / denominator;  // by a333
  gradient[10] = (c_3) / denominator;  // by b1133
}

/// gradient[p] = d harmonic_re_v3_A_v3_conjA_v1_conjA_v2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump
/// N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 891 operations.
template <class Scalar>
void lump_gradient_32(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
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
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar omega2_7 = omega2_6 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar omega3_5 = omega3_4 * omega3;
  const Scalar omega3_6 = omega3_5 * omega3;
  const Scalar omega3_7 = omega3_6 * omega3;
  const Scalar omega3_8 = omega3_7 * omega3;
  const Scalar denominator = Scalar(4.0) * omega1_7 * omega2 * omega3 - Scalar(2.0) * omega1_7 * omega3_2
      + Scalar(8.0) * omega1_6 * omega2_2 * omega3 - Scalar(14.0) * omega1_6 * omega2 * omega3_2
      + Scalar(5.0) * omega1_6 * omega3_3 - Scalar(4.0) * omega1_5 * omega2_3 * omega3
      - Scalar(10.0) * omega1_5 * omega2_2 * omega3_2 + Scalar(2.0) * omega1_5 * omega2 * omega3_3
      + Scalar(2.0) * omega1_5 * omega3_4 - Scalar(16.0) * omega1_4 * omega2_4 * omega3
      + Scalar(26.0) * omega1_4 * omega2_3 * omega3_2 - Scalar(21.0) * omega1_4 * omega2_2 * omega3_3
      + Scalar(26.0) * omega1_4 * omega2 * omega3_4 - Scalar(10.0) * omega1_4 * omega3_5
      - Scalar(4.0) * omega1_3 * omega2_5 * omega3 + Scalar(26.0) * omega1_3 * omega2_4 * omega3_2
      - Scalar(36.0) * omega1_3 * omega2_3 * omega3_3 + Scalar(36.0) * omega1_3 * omega2_2 * omega3_4
      - Scalar(16.0) * omega1_3 * omega2 * omega3_5 + Scalar(2.0) * omega1_3 * omega3_6
      + Scalar(8.0) * omega1_2 * omega2_6 * omega3 - Scalar(10.0) * omega1_2 * omega2_5 * omega3_2
      - Scalar(21.0) * omega1_2 * omega2_4 * omega3_3 + Scalar(36.0) * omega1_2 * omega2_3 * omega3_4
      - Scalar(12.0) * omega1_2 * omega2_2 * omega3_5 - Scalar(10.0) * omega1_2 * omega2 * omega3_6
      + Scalar(5.0) * omega1_2 * omega3_7 + Scalar(4.0) * omega1 * omega2_7 * omega3
      - Scalar(14.0) * omega1 * omega2_6 * omega3_2 + Scalar(2.0) * omega1 * omega2_5 * omega3_3
      + Scalar(26.0) * omega1 * omega2_4 * omega3_4 - Scalar(16.0) * omega1 * omega2_3 * omega3_5
      - Scalar(10.0) * omega1 * omega2_2 * omega3_6 + Scalar(10.0) * omega1 * omega2 * omega3_7
      - Scalar(2.0) * omega1 * omega3_8 - Scalar(2.0) * omega2_7 * omega3_2 + Scalar(5.0) * omega2_6 * omega3_3
      + Scalar(2.0) * omega2_5 * omega3_4 - Scalar(10.0) * omega2_4 * omega3_5 + Scalar(2.0) * omega2_3 * omega3_6
      + Scalar(5.0) * omega2_2 * omega3_7 - Scalar(2.0) * omega2 * omega3_8;
  // multiplies a113*a123
  const Scalar c_0 = -Scalar(4.0) * omega1_4 * omega2 + Scalar(2.0) * omega1_4 * omega3
      - Scalar(8.0) * omega1_3 * omega2 * omega3 + Scalar(4.0) * omega1_3 * omega3_2
      + Scalar(8.0) * omega1_2 * omega2_3 - Scalar(4.0) * omega1_2 * omega2_2 * omega3
      + Scalar(12.0) * omega1_2 * omega2 * omega3_2 - Scalar(6.0) * omega1_2 * omega3_3
      + Scalar(8.0) * omega1 * omega2_3 * omega3 + Scalar(12.0) * omega1 * omega2_2 * omega3_2
      - Scalar(4.0) * omega1 * omega3_4 - Scalar(4.0) * omega2_5 + Scalar(2.0) * omega2_4 * omega3
      + Scalar(4.0) * omega2_3 * omega3_2 - Scalar(10.0) * omega2_2 * omega3_3 - Scalar(4.0) * omega2 * omega3_4
      + Scalar(4.0) * omega3_5;
  // multiplies a123*a223
  const Scalar c_1 = -Scalar(4.0) * omega1_5 + Scalar(2.0) * omega1_4 * omega3 + Scalar(8.0) * omega1_3 * omega2_2
      + Scalar(8.0) * omega1_3 * omega2 * omega3 + Scalar(4.0) * omega1_3 * omega3_2
      - Scalar(4.0) * omega1_2 * omega2_2 * omega3 + Scalar(12.0) * omega1_2 * omega2 * omega3_2
      - Scalar(10.0) * omega1_2 * omega3_3 - Scalar(4.0) * omega1 * omega2_4
      - Scalar(8.0) * omega1 * omega2_3 * omega3 + Scalar(12.0) * omega1 * omega2_2 * omega3_2
      - Scalar(4.0) * omega1 * omega3_4 + Scalar(2.0) * omega2_4 * omega3 + Scalar(4.0) * omega2_3 * omega3_2
      - Scalar(6.0) * omega2_2 * omega3_3 - Scalar(4.0) * omega2 * omega3_4 + Scalar(4.0) * omega3_5;
  // multiplies a123*a333
  const Scalar c_2 = Scalar(8.0) * omega1_3 * omega2 * omega3 - Scalar(4.0) * omega1_3 * omega3_2
      - Scalar(16.0) * omega1_2 * omega2_2 * omega3 + Scalar(4.0) * omega1_2 * omega2 * omega3_2
      + Scalar(2.0) * omega1_2 * omega3_3 + Scalar(8.0) * omega1 * omega2_3 * omega3
      + Scalar(4.0) * omega1 * omega2_2 * omega3_2 - Scalar(12.0) * omega1 * omega2 * omega3_3
      + Scalar(4.0) * omega1 * omega3_4 - Scalar(4.0) * omega2_3 * omega3_2 + Scalar(2.0) * omega2_2 * omega3_3
      + Scalar(4.0) * omega2 * omega3_4 - Scalar(2.0) * omega3_5;
  const Scalar w_0 = -Scalar(4.0) * a123 * a223;  // multiplies omega1^5
  const Scalar w_1 = -Scalar(4.0) * a113 * a123;  // multiplies omega1^4*omega2
  const Scalar w_2 = Scalar(2.0) * a113 * a123 + Scalar(2.0) * a123 * a223;  // multiplies omega1^4*omega3
  const Scalar w_3 = Scalar(8.0) * a123 * a223;  // multiplies omega1^3*omega2^2
  // multiplies omega1^3*omega2*omega3
  const Scalar w_4 = -Scalar(8.0) * a113 * a123 + Scalar(8.0) * a123 * a223 + Scalar(8.0) * a123 * a333;
  // multiplies omega1^3*omega3^2
  const Scalar w_5 = Scalar(4.0) * a113 * a123 + Scalar(4.0) * a123 * a223 - Scalar(4.0) * a123 * a333;
  const Scalar w_6 = Scalar(8.0) * a113 * a123;  // multiplies omega1^2*omega2^3
  // multiplies omega1^2*omega2^2*omega3
  const Scalar w_7 = -Scalar(4.0) * a113 * a123 - Scalar(4.0) * a123 * a223 - Scalar(16.0) * a123 * a333;
  // multiplies omega1^2*omega2*omega3^2
  const Scalar w_8 = Scalar(12.0) * a113 * a123 + Scalar(12.0) * a123 * a223 + Scalar(4.0) * a123 * a333;
  // multiplies omega1^2*omega3^3
  const Scalar w_9 = -Scalar(6.0) * a113 * a123 - Scalar(10.0) * a123 * a223 + Scalar(2.0) * a123 * a333;
  const Scalar w_10 = -Scalar(4.0) * a123 * a223;  // multiplies omega1*omega2^4
  // multiplies omega1*omega2^3*omega3
  const Scalar w_11 = Scalar(8.0) * a113 * a123 - Scalar(8.0) * a123 * a223 + Scalar(8.0) * a123 * a333;
  // multiplies omega1*omega2^2*omega3^2
  const Scalar w_12 = Scalar(12.0) * a113 * a123 + Scalar(12.0) * a123 * a223 + Scalar(4.0) * a123 * a333;
  const Scalar w_13 = -Scalar(12.0) * a123 * a333;  // multiplies omega1*omega2*omega3^3
  // multiplies omega1*omega3^4
  const Scalar w_14 = -Scalar(4.0) * a113 * a123 - Scalar(4.0) * a123 * a223 + Scalar(4.0) * a123 * a333;
  const Scalar w_15 = -Scalar(4.0) * a113 * a123;  // multiplies omega2^5
  const Scalar w_16 = Scalar(2.0) * a113 * a123 + Scalar(2.0) * a123 * a223;  // multiplies omega2^4*omega3
  // multiplies omega2^3*omega3^2
  const Scalar w_17 = Scalar(4.0) * a113 * a123 + Scalar(4.0) * a123 * a223 - Scalar(4.0) * a123 * a333;
  // multiplies omega2^2*omega3^3
  const Scalar w_18 = -Scalar(10.0) * a113 * a123 - Scalar(6.0) * a123 * a223 + Scalar(2.0) * a123 * a333;
  // multiplies omega2*omega3^4
  const Scalar w_19 = -Scalar(4.0) * a113 * a123 - Scalar(4.0) * a123 * a223 + Scalar(4.0) * a123 * a333;
  // multiplies omega3^5
  const Scalar w_20 = Scalar(4.0) * a113 * a123 + Scalar(4.0) * a123 * a223 - Scalar(2.0) * a123 * a333;
  // by omega1
  gradient[0] = (Scalar(5.0) * omega1_4 * w_0 + Scalar(4.0) * omega1_3 * omega2 * w_1
      + Scalar(4.0) * omega1_3 * omega3 * w_2 + Scalar(3.0) * omega1_2 * omega2_2 * w_3
      + Scalar(3.0) * omega1_2 * omega2 * omega3 * w_4 + Scalar(3.0) * omega1_2 * omega3_2 * w_5
      + Scalar(2.0) * omega1 * omega2_3 * w_6 + Scalar(2.0) * omega1 * omega2_2 * omega3 * w_7
      + Scalar(2.0) * omega1 * omega2 * omega3_2 * w_8 + Scalar(2.0) * omega1 * omega3_3 * w_9 + omega2_4 * w_10
      + omega2_3 * omega3 * w_11 + omega2_2 * omega3_2 * w_12 + omega2 * omega3_3 * w_13 + omega3_4 * w_14
      - lump * (Scalar(28.0) * omega1_6 * omega2 * omega3 - Scalar(14.0) * omega1_6 * omega3_2
      + Scalar(48.0) * omega1_5 * omega2_2 * omega3 - Scalar(84.0) * omega1_5 * omega2 * omega3_2
      + Scalar(30.0) * omega1_5 * omega3_3 - Scalar(20.0) * omega1_4 * omega2_3 * omega3
      - Scalar(50.0) * omega1_4 * omega2_2 * omega3_2 + Scalar(10.0) * omega1_4 * omega2 * omega3_3
      + Scalar(10.0) * omega1_4 * omega3_4 - Scalar(64.0) * omega1_3 * omega2_4 * omega3
      + Scalar(104.0) * omega1_3 * omega2_3 * omega3_2 - Scalar(84.0) * omega1_3 * omega2_2 * omega3_3
      + Scalar(104.0) * omega1_3 * omega2 * omega3_4 - Scalar(40.0) * omega1_3 * omega3_5
      - Scalar(12.0) * omega1_2 * omega2_5 * omega3 + Scalar(78.0) * omega1_2 * omega2_4 * omega3_2
      - Scalar(108.0) * omega1_2 * omega2_3 * omega3_3 + Scalar(108.0) * omega1_2 * omega2_2 * omega3_4
      - Scalar(48.0) * omega1_2 * omega2 * omega3_5 + Scalar(6.0) * omega1_2 * omega3_6
      + Scalar(16.0) * omega1 * omega2_6 * omega3 - Scalar(20.0) * omega1 * omega2_5 * omega3_2
      - Scalar(42.0) * omega1 * omega2_4 * omega3_3 + Scalar(72.0) * omega1 * omega2_3 * omega3_4
      - Scalar(24.0) * omega1 * omega2_2 * omega3_5 - Scalar(20.0) * omega1 * omega2 * omega3_6
      + Scalar(10.0) * omega1 * omega3_7 + Scalar(4.0) * omega2_7 * omega3 - Scalar(14.0) * omega2_6 * omega3_2
      + Scalar(2.0) * omega2_5 * omega3_3 + Scalar(26.0) * omega2_4 * omega3_4
      - Scalar(16.0) * omega2_3 * omega3_5 - Scalar(10.0) * omega2_2 * omega3_6 + Scalar(10.0) * omega2 * omega3_7
      - Scalar(2.0) * omega3_8)) / denominator;
  // by omega2
  gradient[1] = (omega1_4 * w_1 + Scalar(2.0) * omega1_3 * omega2 * w_3 + omega1_3 * omega3 * w_4
      + Scalar(3.0) * omega1_2 * omega2_2 * w_6 + Scalar(2.0) * omega1_2 * omega2 * omega3 * w_7
      + omega1_2 * omega3_2 * w_8 + Scalar(4.0) * omega1 * omega2_3 * w_10
      + Scalar(3.0) * omega1 * omega2_2 * omega3 * w_11 + Scalar(2.0) * omega1 * omega2 * omega3_2 * w_12
      + omega1 * omega3_3 * w_13 + Scalar(5.0) * omega2_4 * w_15 + Scalar(4.0) * omega2_3 * omega3 * w_16
      + Scalar(3.0) * omega2_2 * omega3_2 * w_17 + Scalar(2.0) * omega2 * omega3_3 * w_18 + omega3_4 * w_19
      - lump * (Scalar(4.0) * omega1_7 * omega3 + Scalar(16.0) * omega1_6 * omega2 * omega3
      - Scalar(14.0) * omega1_6 * omega3_2 - Scalar(12.0) * omega1_5 * omega2_2 * omega3
      - Scalar(20.0) * omega1_5 * omega2 * omega3_2 + Scalar(2.0) * omega1_5 * omega3_3
      - Scalar(64.0) * omega1_4 * omega2_3 * omega3 + Scalar(78.0) * omega1_4 * omega2_2 * omega3_2
      - Scalar(42.0) * omega1_4 * omega2 * omega3_3 + Scalar(26.0) * omega1_4 * omega3_4
      - Scalar(20.0) * omega1_3 * omega2_4 * omega3 + Scalar(104.0) * omega1_3 * omega2_3 * omega3_2
      - Scalar(108.0) * omega1_3 * omega2_2 * omega3_3 + Scalar(72.0) * omega1_3 * omega2 * omega3_4
      - Scalar(16.0) * omega1_3 * omega3_5 + Scalar(48.0) * omega1_2 * omega2_5 * omega3
      - Scalar(50.0) * omega1_2 * omega2_4 * omega3_2 - Scalar(84.0) * omega1_2 * omega2_3 * omega3_3
      + Scalar(108.0) * omega1_2 * omega2_2 * omega3_4 - Scalar(24.0) * omega1_2 * omega2 * omega3_5
      - Scalar(10.0) * omega1_2 * omega3_6 + Scalar(28.0) * omega1 * omega2_6 * omega3
      - Scalar(84.0) * omega1 * omega2_5 * omega3_2 + Scalar(10.0) * omega1 * omega2_4 * omega3_3
      + Scalar(104.0) * omega1 * omega2_3 * omega3_4 - Scalar(48.0) * omega1 * omega2_2 * omega3_5
      - Scalar(20.0) * omega1 * omega2 * omega3_6 + Scalar(10.0) * omega1 * omega3_7
      - Scalar(14.0) * omega2_6 * omega3_2 + Scalar(30.0) * omega2_5 * omega3_3
      + Scalar(10.0) * omega2_4 * omega3_4 - Scalar(40.0) * omega2_3 * omega3_5
      + Scalar(6.0) * omega2_2 * omega3_6 + Scalar(10.0) * omega2 * omega3_7
      - Scalar(2.0) * omega3_8)) / denominator;
  // by omega3
  gradient[2] = (omega1_4 * w_2 + omega1_3 * omega2 * w_4 + Scalar(2.0) * omega1_3 * omega3 * w_5
      + omega1_2 * omega2_2 * w_7 + Scalar(2.0) * omega1_2 * omega2 * omega3 * w_8
      + Scalar(3.0) * omega1_2 * omega3_2 * w_9 + omega1 * omega2_3 * w_11
      + Scalar(2.0) * omega1 * omega2_2 * omega3 * w_12 + Scalar(3.0) * omega1 * omega2 * omega3_2 * w_13
      + Scalar(4.0) * omega1 * omega3_3 * w_14 + omega2_4 * w_16 + Scalar(2.0) * omega2_3 * omega3 * w_17
      + Scalar(3.0) * omega2_2 * omega3_2 * w_18 + Scalar(4.0) * omega2 * omega3_3 * w_19
      + Scalar(5.0) * omega3_4 * w_20 - lump * (Scalar(4.0) * omega1_7 * omega2 - Scalar(4.0) * omega1_7 * omega3
      + Scalar(8.0) * omega1_6 * omega2_2 - Scalar(28.0) * omega1_6 * omega2 * omega3
      + Scalar(15.0) * omega1_6 * omega3_2 - Scalar(4.0) * omega1_5 * omega2_3
      - Scalar(20.0) * omega1_5 * omega2_2 * omega3 + Scalar(6.0) * omega1_5 * omega2 * omega3_2
      + Scalar(8.0) * omega1_5 * omega3_3 - Scalar(16.0) * omega1_4 * omega2_4
      + Scalar(52.0) * omega1_4 * omega2_3 * omega3 - Scalar(63.0) * omega1_4 * omega2_2 * omega3_2
      + Scalar(104.0) * omega1_4 * omega2 * omega3_3 - Scalar(50.0) * omega1_4 * omega3_4
      - Scalar(4.0) * omega1_3 * omega2_5 + Scalar(52.0) * omega1_3 * omega2_4 * omega3
      - Scalar(108.0) * omega1_3 * omega2_3 * omega3_2 + Scalar(144.0) * omega1_3 * omega2_2 * omega3_3
      - Scalar(80.0) * omega1_3 * omega2 * omega3_4 + Scalar(12.0) * omega1_3 * omega3_5
      + Scalar(8.0) * omega1_2 * omega2_6 - Scalar(20.0) * omega1_2 * omega2_5 * omega3
      - Scalar(63.0) * omega1_2 * omega2_4 * omega3_2 + Scalar(144.0) * omega1_2 * omega2_3 * omega3_3
      - Scalar(60.0) * omega1_2 * omega2_2 * omega3_4 - Scalar(60.0) * omega1_2 * omega2 * omega3_5
      + Scalar(35.0) * omega1_2 * omega3_6 + Scalar(4.0) * omega1 * omega2_7
      - Scalar(28.0) * omega1 * omega2_6 * omega3 + Scalar(6.0) * omega1 * omega2_5 * omega3_2
      + Scalar(104.0) * omega1 * omega2_4 * omega3_3 - Scalar(80.0) * omega1 * omega2_3 * omega3_4
      - Scalar(60.0) * omega1 * omega2_2 * omega3_5 + Scalar(70.0) * omega1 * omega2 * omega3_6
      - Scalar(16.0) * omega1 * omega3_7 - Scalar(4.0) * omega2_7 * omega3 + Scalar(15.0) * omega2_6 * omega3_2
      + Scalar(8.0) * omega2_5 * omega3_3 - Scalar(50.0) * omega2_4 * omega3_4
      + Scalar(12.0) * omega2_3 * omega3_5 + Scalar(35.0) * omega2_2 * omega3_6
      - Scalar(16.0) * omega2 * omega3_7)) / denominator;
  gradient[3] = (a123 * c_0) / denominator;  // by a113
  gradient[4] = (a113 * c_0 + a223 * c_1 + a333 * c_2) / denominator;  // by a123
  gradient[5] = (a123 * c_1) / denominator;  // by a223
  gradient[6] = (a123 * c_2) / denominator;  // by a333
}

/// gradient[p] = d harmonic_re_v3_A_v2_A_v3_conjA_v1 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 891 operations.
template <class Scalar>
void lump_gradient_33(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
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
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar omega2_7 = omega2_6 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar omega3_5 = omega3_4 * omega3;
  const Scalar omega3_6 = omega3_5 * omega3;
  const Scalar omega3_7 = omega3_6 * omega3;
  const Scalar omega3_8 = omega3_7 * omega3;
  const Scalar denominator = Scalar(4.0) * omega1_7 * omega2 * omega3 + Scalar(2.0) * omega1_7 * omega3_2
      - Scalar(8.0) * omega1_6 * omega2_2 * omega3 - Scalar(14.0) * omega1_6 * omega2 * omega3_2
      - Scalar(5.0) * omega1_6 * omega3_3 - Scalar(4.0) * omega1_5 * omega2_3 * omega3
      + Scalar(10.0) * omega1_5 * omega2_2 * omega3_2 + Scalar(2.0) * omega1_5 * omega2 * omega3_3
      - Scalar(2.0) * omega1_5 * omega3_4 + Scalar(16.0) * omega1_4 * omega2_4 * omega3
      + Scalar(26.0) * omega1_4 * omega2_3 * omega3_2 + Scalar(21.0) * omega1_4 * omega2_2 * omega3_3
      + Scalar(26.0) * omega1_4 * omega2 * omega3_4 + Scalar(10.0) * omega1_4 * omega3_5
      - Scalar(4.0) * omega1_3 * omega2_5 * omega3 - Scalar(26.0) * omega1_3 * omega2_4 * omega3_2
      - Scalar(36.0) * omega1_3 * omega2_3 * omega3_3 - Scalar(36.0) * omega1_3 * omega2_2 * omega3_4
      - Scalar(16.0) * omega1_3 * omega2 * omega3_5 - Scalar(2.0) * omega1_3 * omega3_6
      - Scalar(8.0) * omega1_2 * omega2_6 * omega3 - Scalar(10.0) * omega1_2 * omega2_5 * omega3_2
      + Scalar(21.0) * omega1_2 * omega2_4 * omega3_3 + Scalar(36.0) * omega1_2 * omega2_3 * omega3_4
      + Scalar(12.0) * omega1_2 * omega2_2 * omega3_5 - Scalar(10.0) * omega1_2 * omega2 * omega3_6
      - Scalar(5.0) * omega1_2 * omega3_7 + Scalar(4.0) * omega1 * omega2_7 * omega3
      + Scalar(14.0) * omega1 * omega2_6 * omega3_2 + Scalar(2.0) * omega1 * omega2_5 * omega3_3
      - Scalar(26.0) * omega1 * omega2_4 * omega3_4 - Scalar(16.0) * omega1 * omega2_3 * omega3_5
      + Scalar(10.0) * omega1 * omega2_2 * omega3_6 + Scalar(10.0) * omega1 * omega2 * omega3_7
      + Scalar(2.0) * omega1 * omega3_8 - Scalar(2.0) * omega2_7 * omega3_2 - Scalar(5.0) * omega2_6 * omega3_3
      + Scalar(2.0) * omega2_5 * omega3_4 + Scalar(10.0) * omega2_4 * omega3_5 + Scalar(2.0) * omega2_3 * omega3_6
      - Scalar(5.0) * omega2_2 * omega3_7 - Scalar(2.0) * omega2 * omega3_8;
  // multiplies a113*a123
  const Scalar c_0 = -Scalar(4.0) * omega1_4 * omega2 - Scalar(2.0) * omega1_4 * omega3
      - Scalar(8.0) * omega1_3 * omega2 * omega3 - Scalar(4.0) * omega1_3 * omega3_2
      + Scalar(8.0) * omega1_2 * omega2_3 + Scalar(4.0) * omega1_2 * omega2_2 * omega3
      + Scalar(12.0) * omega1_2 * omega2 * omega3_2 + Scalar(6.0) * omega1_2 * omega3_3
      + Scalar(8.0) * omega1 * omega2_3 * omega3 - Scalar(12.0) * omega1 * omega2_2 * omega3_2
      + Scalar(4.0) * omega1 * omega3_4 - Scalar(4.0) * omega2_5 - Scalar(2.0) * omega2_4 * omega3
      + Scalar(4.0) * omega2_3 * omega3_2 + Scalar(10.0) * omega2_2 * omega3_3 - Scalar(4.0) * omega2 * omega3_4
      - Scalar(4.0) * omega3_5;
  // multiplies a123*a223
  const Scalar c_1 = Scalar(4.0) * omega1_5 - Scalar(2.0) * omega1_4 * omega3 - Scalar(8.0) * omega1_3 * omega2_2
      + Scalar(8.0) * omega1_3 * omega2 * omega3 - Scalar(4.0) * omega1_3 * omega3_2
      + Scalar(4.0) * omega1_2 * omega2_2 * omega3 + Scalar(12.0) * omega1_2 * omega2 * omega3_2
      + Scalar(10.0) * omega1_2 * omega3_3 + Scalar(4.0) * omega1 * omega2_4
      - Scalar(8.0) * omega1 * omega2_3 * omega3 - Scalar(12.0) * omega1 * omega2_2 * omega3_2
      + Scalar(4.0) * omega1 * omega3_4 - Scalar(2.0) * omega2_4 * omega3 + Scalar(4.0) * omega2_3 * omega3_2
      + Scalar(6.0) * omega2_2 * omega3_3 - Scalar(4.0) * omega2 * omega3_4 - Scalar(4.0) * omega3_5;
  // multiplies a123*a333
  const Scalar c_2 = Scalar(8.0) * omega1_3 * omega2 * omega3 + Scalar(4.0) * omega1_3 * omega3_2
      + Scalar(16.0) * omega1_2 * omega2_2 * omega3 + Scalar(4.0) * omega1_2 * omega2 * omega3_2
      - Scalar(2.0) * omega1_2 * omega3_3 + Scalar(8.0) * omega1 * omega2_3 * omega3
      - Scalar(4.0) * omega1 * omega2_2 * omega3_2 - Scalar(12.0) * omega1 * omega2 * omega3_3
      - Scalar(4.0) * omega1 * omega3_4 - Scalar(4.0) * omega2_3 * omega3_2 - Scalar(2.0) * omega2_2 * omega3_3
      + Scalar(4.0) * omega2 * omega3_4 + Scalar(2.0) * omega3_5;
  const Scalar w_0 = Scalar(4.0) * a123 * a223;  // multiplies omega1^5
  const Scalar w_1 = -Scalar(4.0) * a113 * a123;  // multiplies omega1^4*omega2
  const Scalar w_2 = -Scalar(2.0) * a113 * a123 - Scalar(2.0) * a123 * a223;  // multiplies omega1^4*omega3
  const Scalar w_3 = -Scalar(8.0) * a123 * a223;  // multiplies omega1^3*omega2^2
  // multiplies omega1^3*omega2*omega3
  const Scalar w_4 = -Scalar(8.0) * a113 * a123 + Scalar(8.0) * a123 * a223 + Scalar(8.0) * a123 * a333;
  // multiplies omega1^3*omega3^2
  const Scalar w_5 = -Scalar(4.0) * a113 * a123 - Scalar(4.0) * a123 * a223 + Scalar(4.0) * a123 * a333;
  const Scalar w_6 = Scalar(8.0) * a113 * a123;  // multiplies omega1^2*omega2^3
  // multiplies omega1^2*omega2^2*omega3
  const Scalar w_7 = Scalar(4.0) * a113 * a123 + Scalar(4.0) * a123 * a223 + Scalar(16.0) * a123 * a333;
  // multiplies omega1^2*omega2*omega3^2
  const Scalar w_8 = Scalar(12.0) * a113 * a123 + Scalar(12.0) * a123 * a223 + Scalar(4.0) * a123 * a333;
  // multiplies omega1^2*omega3^3
  const Scalar w_9 = Scalar(6.0) * a113 * a123 + Scalar(10.0) * a123 * a223 - Scalar(2.0) * a123 * a333;
  const Scalar w_10 = Scalar(4.0) * a123 * a223;  // multiplies omega1*omega2^4
  // multiplies omega1*omega2^3*omega3
  const Scalar w_11 = Scalar(8.0) * a113 * a123 - Scalar(8.0) * a123 * a223 + Scalar(8.0) * a123 * a333;
  // multiplies omega1*omega2^2*omega3^2
  const Scalar w_12 = -Scalar(12.0) * a113 * a123 - Scalar(12.0) * a123 * a223 - Scalar(4.0) * a123 * a333;
  const Scalar w_13 = -Scalar(12.0) * a123 * a333;  // multiplies omega1*omega2*omega3^3
  // multiplies omega1*omega3^4
  const Scalar w_14 = Scalar(4.0) * a113 * a123 + Scalar(4.0) * a123 * a223 - Scalar(4.0) * a123 * a333;
  const Scalar w_15 = -Scalar(4.0) * a113 * a123;  // multiplies omega2^5
  const Scalar w_16 = -Scalar(2.0) * a113 * a123 - Scalar(2.0) * a123 * a223;  // multiplies omega2^4*omega3
  // multiplies omega2^3*omega3^2
  const Scalar w_17 = Scalar(4.0) * a113 * a123 + Scalar(4.0) * a123 * a223 - Scalar(4.0) * a123 * a333;
  // multiplies omega2^2*omega3^3
  const Scalar w_18 = Scalar(10.0) * a113 * a123 + Scalar(6.0) * a123 * a223 - Scalar(2.0) * a123 * a333;
  // multiplies omega2*omega3^4
  const Scalar w_19 = -Scalar(4.0) * a113 * a123 - Scalar(4.0) * a123 * a223 + Scalar(4.0) * a123 * a333;
  // multiplies omega3^5
  const Scalar w_20 = -Scalar(4.0) * a113 * a123 - Scalar(4.0) * a123 * a223 + Scalar(2.0) * a123 * a333;
  // by omega1
  gradient[0] = (Scalar(5.0) * omega1_4 * w_0 + Scalar(4.0) * omega1_3 * omega2 * w_1
      + Scalar(4.0) * omega1_3 * omega3 * w_2 + Scalar(3.0) * omega1_2 * omega2_2 * w_3
      + Scalar(3.0) * omega1_2 * omega2 * omega3 * w_4 + Scalar(3.0) * omega1_2 * omega3_2 * w_5
      + Scalar(2.0) * omega1 * omega2_3 * w_6 + Scalar(2.0) * omega1 * omega2_2 * omega3 * w_7
      + Scalar(2.0) * omega1 * omega2 * omega3_2 * w_8 + Scalar(2.0) * omega1 * omega3_3 * w_9 + omega2_4 * w_10
      + omega2_3 * omega3 * w_11 + omega2_2 * omega3_2 * w_12 + omega2 * omega3_3 * w_13 + omega3_4 * w_14
      - lump * (Scalar(28.0) * omega1_6 * omega2 * omega3 + Scalar(14.0) * omega1_6 * omega3_2
      - Scalar(48.0) * omega1_5 * omega2_2 * omega3 - Scalar(84.0) * omega1_5 * omega2 * omega3_2
      - Scalar(30.0) * omega1_5 * omega3_3 - Scalar(20.0) * omega1_4 * omega2_3 * omega3
      + Scalar(50.0) * omega1_4 * omega2_2 * omega3_2 + Scalar(10.0) * omega1_4 * omega2 * omega3_3
      - Scalar(10.0) * omega1_4 * omega3_4 + Scalar(64.0) * omega1_3 * omega2_4 * omega3
      + Scalar(104.0) * omega1_3 * omega2_3 * omega3_2 + Scalar(84.0) * omega1_3 * omega2_2 * omega3_3
      + Scalar(104.0) * omega1_3 * omega2 * omega3_4 + Scalar(40.0) * omega1_3 * omega3_5
      - Scalar(12.0) * omega1_2 * omega2_5 * omega3 - Scalar(78.0) * omega1_2 * omega2_4 * omega3_2
      - Scalar(108.0) * omega1_2 * omega2_3 * omega3_3 - Scalar(108.0) * omega1_2 * omega2_2 * omega3_4
      - Scalar(48.0) * omega1_2 * omega2 * omega3_5 - Scalar(6.0) * omega1_2 * omega3_6
      - Scalar(16.0) * omega1 * omega2_6 * omega3 - Scalar(20.0) * omega1 * omega2_5 * omega3_2
      + Scalar(42.0) * omega1 * omega2_4 * omega3_3 + Scalar(72.0) * omega1 * omega2_3 * omega3_4
      + Scalar(24.0) * omega1 * omega2_2 * omega3_5 - Scalar(20.0) * omega1 * omega2 * omega3_6
      - Scalar(10.0) * omega1 * omega3_7 + Scalar(4.0) * omega2_7 * omega3 + Scalar(14.0) * omega2_6 * omega3_2
      + Scalar(2.0) * omega2_5 * omega3_3 - Scalar(26.0) * omega2_4 * omega3_4
      - Scalar(16.0) * omega2_3 * omega3_5 + Scalar(10.0) * omega2_2 * omega3_6 + Scalar(10.0) * omega2 * omega3_7
      + Scalar(2.0) * omega3_8)) / denominator;
  // by omega2
  gradient[1] = (omega1_4 * w_1 + Scalar(2.0) * omega1_3 * omega2 * w_3 + omega1_3 * omega3 * w_4
      + Scalar(3.0) * omega1_2 * omega2_2 * w_6 + Scalar(2.0) * omega1_2 * omega2 * omega3 * w_7
      + omega1_2 * omega3_2 * w_8 + Scalar(4.0) * omega1 * omega2_3 * w_10
      + Scalar(3.0) * omega1 * omega2_2 * omega3 * w_11 + Scalar(2.0) * omega1 * omega2 * omega3_2 * w_12
      + omega1 * omega3_3 * w_13 + Scalar(5.0) * omega2_4 * w_15 + Scalar(4.0) * omega2_3 * omega3 * w_16
      + Scalar(3.0) * omega2_2 * omega3_2 * w_17 + Scalar(2.0) * omega2 * omega3_3 * w_18 + omega3_4 * w_19
      - lump * (Scalar(4.0) * omega1_7 * omega3 - Scalar(16.0) * omega1_6 * omega2 * omega3
      - Scalar(14.0) * omega1_6 * omega3_2 - Scalar(12.0) * omega1_5 * omega2_2 * omega3
      + Scalar(20.0) * omega1_5 * omega2 * omega3_2 + Scalar(2.0) * omega1_5 * omega3_3
      + Scalar(64.0) * omega1_4 * omega2_3 * omega3 + Scalar(78.0) * omega1_4 * omega2_2 * omega3_2
      + Scalar(42.0) * omega1_4 * omega2 * omega3_3 + Scalar(26.0) * omega1_4 * omega3_4
      - Scalar(20.0) * omega1_3 * omega2_4 * omega3 - Scalar(104.0) * omega1_3 * omega2_3 * omega3_2
      - Scalar(108.0) * omega1_3 * omega2_2 * omega3_3 - Scalar(72.0) * omega1_3 * omega2 * omega3_4
      - Scalar(16.0) * omega1_3 * omega3_5 - Scalar(48.0) * omega1_2 * omega2_5 * omega3
      - Scalar(50.0) * omega1_2 * omega2_4 * omega3_2 + Scalar(84.0) * omega1_2 * omega2_3 * omega3_3
      + Scalar(108.0) * omega1_2 * omega2_2 * omega3_4 + Scalar(24.0) * omega1_2 * omega2 * omega3_5
      - Scalar(10.0) * omega1_2 * omega3_6 + Scalar(28.0) * omega1 * omega2_6 * omega3
      + Scalar(84.0) * omega1 * omega2_5 * omega3_2 + Scalar(10.0) * omega1 * omega2_4 * omega3_3
      - Scalar(104.0) * omega1 * omega2_3 * omega3_4 - Scalar(48.0) * omega1 * omega2_2 * omega3_5
      + Scalar(20.0) * omega1 * omega2 * omega3_6 + Scalar(10.0) * omega1 * omega3_7
      - Scalar(14.0) * omega2_6 * omega3_2 - Scalar(30.0) * omega2_5 * omega3_3
      + Scalar(10.0) * omega2_4 * omega3_4 + Scalar(40.0) * omega2_3 * omega3_5
      + Scalar(6.0) * omega2_2 * omega3_6 - Scalar(10.0) * omega2 * omega3_7
      - Scalar(2.0) * omega3_8)) / denominator;
  // by omega3
  gradient[2] = (omega1_4 * w_2 + omega1_3 * omega2 * w_4 + Scalar(2.0) * omega1_3 * omega3 * w_5
      + omega1_2 * omega2_2 * w_7 + Scalar(2.0) * omega1_2 * omega2 * omega3 * w_8
      + Scalar(3.0) * omega1_2 * omega3_2 * w_9 + omega1 * omega2_3 * w_11
      + Scalar(2.0) * omega1 * omega2_2 * omega3 * w_12 + Scalar(3.0) * omega1 * omega2 * omega3_2 * w_13
      + Scalar(4.0) * omega1 * omega3_3 * w_14 + omega2_4 * w_16 + Scalar(2.0) * omega2_3 * omega3 * w_17
      + Scalar(3.0) * omega2_2 * omega3_2 * w_18 + Scalar(4.0) * omega2 * omega3_3 * w_19
      + Scalar(5.0) * omega3_4 * w_20 - lump * (Scalar(4.0) * omega1_7 * omega2 + Scalar(4.0) * omega1_7 * omega3
      - Scalar(8.0) * omega1_6 * omega2_2 - Scalar(28.0) * omega1_6 * omega2 * omega3
      - Scalar(15.0) * omega1_6 * omega3_2 - Scalar(4.0) * omega1_5 * omega2_3
      + Scalar(20.0) * omega1_5 * omega2_2 * omega3 + Scalar(6.0) * omega1_5 * omega2 * omega3_2
      - Scalar(8.0) * omega1_5 * omega3_3 + Scalar(16.0) * omega1_4 * omega2_4
      + Scalar(52.0) * omega1_4 * omega2_3 * omega3 + Scalar(63.0) * omega1_4 * omega2_2 * omega3_2
      + Scalar(104.0) * omega1_4 * omega2 * omega3_3 + Scalar(50.0) * omega1_4 * omega3_4
      - Scalar(4.0) * omega1_3 * omega2_5 - Scalar(52.0) * omega1_3 * omega2_4 * omega3
      - Scalar(108.0) * omega1_3 * omega2_3 * omega3_2 - Scalar(144.0) * omega1_3 * omega2_2 * omega3_3
      - Scalar(80.0) * omega1_3 * omega2 * omega3_4 - Scalar(12.0) * omega1_3 * omega3_5
      - Scalar(8.0) * omega1_2 * omega2_6 - Scalar(20.0) * omega1_2 * omega2_5 * omega3
      + Scalar(63.0) * omega1_2 * omega2_4 * omega3_2 + Scalar(144.0) * omega1_2 * omega2_3 * omega3_3
      + Scalar(60.0) * omega1_2 * omega2_2 * omega3_4 - Scalar(60.0) * omega1_2 * omega2 * omega3_5
      - Scalar(35.0) * omega1_2 * omega3_6 + Scalar(4.0) * omega1 * omega2_7
      + Scalar(28.0) * omega1 * omega2_6 * omega3 + Scalar(6.0) * omega1 * omega2_5 * omega3_2
      - Scalar(104.0) * omega1 * omega2_4 * omega3_3 - Scalar(80.0) * omega1 * omega2_3 * omega3_4
      + Scalar(60.0) * omega1 * omega2_2 * omega3_5 + Scalar(70.0) * omega1 * omega2 * omega3_6
      + Scalar(16.0) * omega1 * omega3_7 - Scalar(4.0) * omega2_7 * omega3 - Scalar(15.0) * omega2_6 * omega3_2
      + Scalar(8.0) * omega2_5 * omega3_3 + Scalar(50.0) * omega2_4 * omega3_4
      + Scalar(12.0) * omega2_3 * omega3_5 - Scalar(35.0) * omega2_2 * omega3_6
      - Scalar(16.0) * omega2 * omega3_7)) / denominator;
  gradient[3] = (a123 * c_0) / denominator;  // by a113
  gradient[4] = (a113 * c_0 + a223 * c_1 + a333 * c_2) / denominator;  // by a123
  gradient[5] = (a123 * c_1) / denominator;  // by a223
  gradient[6] = (a123 * c_2) / denominator;  // by a333
}

/// gradient[p] = d harmonic_re_v3_A_v22_conjA_v3 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 213 operations.
template <class Scalar>
void lump_gradient_34(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar b2233 = parameters[11];
  const Scalar omega1_2 = omega1 * omega1;
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
  const Scalar a123_2 = a123 * a123;
  const Scalar a223_2 = a223 * a223;
  const Scalar denominator = Scalar(16.0) * omega1_2 * omega2_4 * omega3
      - Scalar(16.0) * omega1_2 * omega2_3 * omega3_2 - Scalar(4.0) * omega1_2 * omega2_2 * omega3_3
      + Scalar(4.0) * omega1_2 * omega2 * omega3_4 - Scalar(16.0) * omega2_6 * omega3
      + Scalar(48.0) * omega2_5 * omega3_2 - Scalar(44.0) * omega2_4 * omega3_3
      + Scalar(4.0) * omega2_3 * omega3_4 + Scalar(12.0) * omega2_2 * omega3_5 - Scalar(4.0) * omega2 * omega3_6;
  const Scalar c_0 = -Scalar(4.0) * omega2_2 * omega3 + omega3_3;  // multiplies a123^2
  // multiplies a223^2
  const Scalar c_1 = -Scalar(8.0) * omega1_2 * omega2 - Scalar(4.0) * omega1_2 * omega3 + Scalar(8.0) * omega2_3
      - Scalar(12.0) * omega2_2 * omega3 + Scalar(4.0) * omega3_3;
  // multiplies a223*a333
  const Scalar c_2 = Scalar(2.0) * omega1_2 * omega3 - Scalar(2.0) * omega2_2 * omega3
      + Scalar(4.0) * omega2 * omega3_2 - Scalar(2.0) * omega3_3;
  // multiplies b2233
  const Scalar c_3 = Scalar(4.0) * omega1_2 * omega2_2 * omega3 - omega1_2 * omega3_3
      - Scalar(4.0) * omega2_4 * omega3 + Scalar(8.0) * omega2_3 * omega3_2 - Scalar(3.0) * omega2_2 * omega3_3
      - Scalar(2.0) * omega2 * omega3_4 + omega3_5;
  const Scalar w_0 = Scalar(4.0) * b2233;  // multiplies omega1^2*omega2^2*omega3
  const Scalar w_1 = -Scalar(8.0) * a223_2;  // multiplies omega1^2*omega2
  const Scalar w_2 = -b2233;  // multiplies omega1^2*omega3^3
  const Scalar w_3 = -Scalar(4.0) * a223_2 + Scalar(2.0) * a223 * a333;  // multiplies omega1^2*omega3
  const Scalar w_4 = -Scalar(4.0) * b2233;  // multiplies omega2^4*omega3
  const Scalar w_5 = Scalar(8.0) * b2233;  // multiplies omega2^3*omega3^2
  const Scalar w_6 = Scalar(8.0) * a223_2;  // multiplies omega2^3
  const Scalar w_7 = -Scalar(3.0) * b2233;  // multiplies omega2^2*omega3^3
  // multiplies omega2^2*omega3
  const Scalar w_8 = -Scalar(4.0) * a123_2 - Scalar(12.0) * a223_2 - Scalar(2.0) * a223 * a333;
  const Scalar w_9 = -Scalar(2.0) * b2233;  // multiplies omega2*omega3^4
  const Scalar w_10 = Scalar(4.0) * a223 * a333;  // multiplies omega2*omega3^2
  const Scalar w_11 = b2233;  // multiplies omega3^5
  const Scalar w_12 = a123_2 + Scalar(4.0) * a223_2 - Scalar(2.0) * a223 * a333;  // multiplies omega3^3
  // by omega1
  gradient[0] = (Scalar(2.0) * omega1 * omega2_2 * omega3 * w_0 + Scalar(2.0) * omega1 * omega2 * w_1
      + Scalar(2.0) * omega1 * omega3_3 * w_2 + Scalar(2.0) * omega1 * omega3 * w_3
      - lump * (Scalar(32.0) * omega1 * omega2_4 * omega3 - Scalar(32.0) * omega1 * omega2_3 * omega3_2
      - Scalar(8.0) * omega1 * omega2_2 * omega3_3 + Scalar(8.0) * omega1 * omega2 * omega3_4)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_2 * omega2 * omega3 * w_0 + omega1_2 * w_1
      + Scalar(4.0) * omega2_3 * omega3 * w_4 + Scalar(3.0) * omega2_2 * omega3_2 * w_5
      + Scalar(3.0) * omega2_2 * w_6 + Scalar(2.0) * omega2 * omega3_3 * w_7 + Scalar(2.0) * omega2 * omega3 * w_8
      + omega3_4 * w_9 + omega3_2 * w_10 - lump * (Scalar(64.0) * omega1_2 * omega2_3 * omega3
      - Scalar(48.0) * omega1_2 * omega2_2 * omega3_2 - Scalar(8.0) * omega1_2 * omega2 * omega3_3
      + Scalar(4.0) * omega1_2 * omega3_4 - Scalar(96.0) * omega2_5 * omega3 + Scalar(240.0) * omega2_4 * omega3_2
      - Scalar(176.0) * omega2_3 * omega3_3 + Scalar(12.0) * omega2_2 * omega3_4
      + Scalar(24.0) * omega2 * omega3_5 - Scalar(4.0) * omega3_6)) / denominator;
  // by omega3
  gradient[2] = (omega1_2 * omega2_2 * w_0 + Scalar(3.0) * omega1_2 * omega3_2 * w_2 + omega1_2 * w_3
      + omega2_4 * w_4 + Scalar(2.0) * omega2_3 * omega3 * w_5 + Scalar(3.0) * omega2_2 * omega3_2 * w_7
      + omega2_2 * w_8 + Scalar(4.0) * omega2 * omega3_3 * w_9 + Scalar(2.0) * omega2 * omega3 * w_10
      + Scalar(5.0) * omega3_4 * w_11 + Scalar(3.0) * omega3_2 * w_12 - lump * (Scalar(16.0) * omega1_2 * omega2_4
      - Scalar(32.0) * omega1_2 * omega2_3 * omega3 - Scalar(12.0) * omega1_2 * omega2_2 * omega3_2
      + Scalar(16.0) * omega1_2 * omega2 * omega3_3 - Scalar(16.0) * omega2_6 + Scalar(96.0) * omega2_5 * omega3
      - Scalar(132.0) * omega2_4 * omega3_2 + Scalar(16.0) * omega2_3 * omega3_3
      + Scalar(60.0) * omega2_2 * omega3_4 - Scalar(24.0) * omega2 * omega3_5)) / denominator;
  gradient[4] = (Scalar(2.0) * a123 * c_0) / denominator;  // by a123
  gradient[5] = (Scalar(2.0) * a223 * c_1 + a333 * c_2) / denominator;  // by a223
  gradient[6] = (a223 * c_2) / denominator;  // by a333
  gradient[11] = (c_3) / denominator;  // by b2233
}

/// gradient[p] = d harmonic_re_v3_A_v22_A_v3 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 213 operations.
template <class Scalar>
void lump_gradient_35(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
  const Scalar b2233 = parameters[11];
  const Scalar omega1_2 = omega1 * omega1;
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
  const Scalar a123_2 = a123 * a123;
  const Scalar a223_2 = a223 * a223;
  const Scalar denominator = Scalar(16.0) * omega1_2 * omega2_4 * omega3
      + Scalar(16.0) * omega1_2 * omega2_3 * omega3_2 - Scalar(4.0) * omega1_2 * omega2_2 * omega3_3
      - Scalar(4.0) * omega1_2 * omega2 * omega3_4 - Scalar(16.0) * omega2_6 * omega3
      - Scalar(48.0) * omega2_5 * omega3_2 - Scalar(44.0) * omega2_4 * omega3_3
      - Scalar(4.0) * omega2_3 * omega3_4 + Scalar(12.0) * omega2_2 * omega3_5 + Scalar(4.0) * omega2 * omega3_6;
  const Scalar c_0 = -Scalar(4.0) * omega2_2 * omega3 + omega3_3;  // multiplies a123^2
  // multiplies a223^2
  const Scalar c_1 = Scalar(8.0) * omega1_2 * omega2 - Scalar(4.0) * omega1_2 * omega3 - Scalar(8.0) * omega2_3
      - Scalar(12.0) * omega2_2 * omega3 + Scalar(4.0) * omega3_3;
  // multiplies a223*a333
  const Scalar c_2 = Scalar(2.0) * omega1_2 * omega3 - Scalar(2.0) * omega2_2 * omega3
      - Scalar(4.0) * omega2 * omega3_2 - Scalar(2.0) * omega3_3;
  // multiplies b2233
  const Scalar c_3 = Scalar(4.0) * omega1_2 * omega2_2 * omega3 - omega1_2 * omega3_3
      - Scalar(4.0) * omega2_4 * omega3 - Scalar(8.0) * omega2_3 * omega3_2 - Scalar(3.0) * omega2_2 * omega3_3
      + Scalar(2.0) * omega2 * omega3_4 + omega3_5;
  const Scalar w_0 = Scalar(4.0) * b2233;  // multiplies omega1^2*omega2^2*omega3
  const Scalar w_1 = Scalar(8.0) * a223_2;  // multiplies omega1^2*omega2
  const Scalar w_2 = -b2233;  // multiplies omega1^2*omega3^3
  const Scalar w_3 = -Scalar(4.0) * a223_2 + Scalar(2.0) * a223 * a333;  // multiplies omega1^2*omega3
  const Scalar w_4 = -Scalar(4.0) * b2233;  // multiplies omega2^4*omega3
  const Scalar w_5 = -Scalar(8.0) * b2233;  // multiplies omega2^3*omega3^2
  const Scalar w_6 = -Scalar(8.0) * a223_2;  // multiplies omega2^3
  const Scalar w_7 = -Scalar(3.0) * b2233;  // multiplies omega2^2*omega3^3
  // multiplies omega2^2*omega3
  const Scalar w_8 = -Scalar(4.0) * a123_2 - Scalar(12.0) * a223_2 - Scalar(2.0) * a223 * a333;
  const Scalar w_9 = Scalar(2.0) * b2233;  // multiplies omega2*omega3^4
  const Scalar w_10 = -Scalar(4.0) * a223 * a333;  // multiplies omega2*omega3^2
  const Scalar w_11 = b2233;  // multiplies omega3^5
  const Scalar w_12 = a123_2 + Scalar(4.0) * a223_2 - Scalar(2.0) * a223 * a333;  // multiplies omega3^3
  // by omega1
  gradient[0] = (Scalar(2.0) * omega1 * omega2_2 * omega3 * w_0 + Scalar(2.0) * omega1 * omega2 * w_1
      + Scalar(2.0) * omega1 * omega3_3 * w_2 + Scalar(2.0) * omega1 * omega3 * w_3
      - lump * (Scalar(32.0) * omega1 * omega2_4 * omega3 + Scalar(32.0) * omega1 * omega2_3 * omega3_2
      - Scalar(8.0) * omega1 * omega2_2 * omega3_3 - Scalar(8.0) * omega1 * omega2 * omega3_4)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_2 * omega2 * omega3 * w_0 + omega1_2 * w_1
      + Scalar(4.0) * omega2_3 * omega3 * w_4 + Scalar(3.0) * omega2_2 * omega3_2 * w_5
      + Scalar(3.0) * omega2_2 * w_6 + Scalar(2.0) * omega2 * omega3_3 * w_7 + Scalar(2.0) * omega2 * omega3 * w_8
      + omega3_4 * w_9 + omega3_2 * w_10 - lump * (Scalar(64.0) * omega1_2 * omega2_3 * omega3
      + Scalar(48.0) * omega1_2 * omega2_2 * omega3_2 - Scalar(8.0) * omega1_2 * omega2 * omega3_3
      - Scalar(4.0) * omega1_2 * omega3_4 - Scalar(96.0) * omega2_5 * omega3 - Scalar(240.0) * omega2_4 * omega3_2
      - Scalar(176.0) * omega2_3 * omega3_3 - Scalar(12.0) * omega2_2 * omega3_4
      + Scalar(24.0) * omega2 * omega3_5 + Scalar(4.0) * omega3_6)) / denominator;
  // by omega3
  gradient[2] = (omega1_2 * omega2_2 * w_0 + Scalar(3.0) * omega1_2 * omega3_2 * w_2 + omega1_2 * w_3
      + omega2_4 * w_4 + Scalar(2.0) * omega2_3 * omega3 * w_5 + Scalar(3.0) * omega2_2 * omega3_2 * w_7
      + omega2_2 * w_8 + Scalar(4.0) * omega2 * omega3_3 * w_9 + Scalar(2.0) * omega2 * omega3 * w_10
      + Scalar(5.0) * omega3_4 * w_11 + Scalar(3.0) * omega3_2 * w_12 - lump * (Scalar(16.0) * omega1_2 * omega2_4
      + Scalar(32.0) * omega1_2 * omega2_3 * omega3 - Scalar(12.0) * omega1_2 * omega2_2 * omega3_2
      - Scalar(16.0) * omega1_2 * omega2 * omega3_3 - Scalar(16.0) * omega2_6 - Scalar(96.0) * omega2_5 * omega3
      - Scalar(132.0) * omega2_4 * omega3_2 - Scalar(16.0) * omega2_3 * omega3_3
      + Scalar(60.0) * omega2_2 * omega3_4 + Scalar(24.0) * omega2 * omega3_5)) / denominator;
  gradient[4] = (Scalar(2.0) * a123 * c_0) / denominator;  // by a123
  gradient[5] = (Scalar(2.0) * a223 * c_1 + a333 * c_2) / denominator;  // by a223
  gradient[6] = (a223 * c_2) / denominator;  // by a333
  gradient[11] = (c_3) / denominator;  // by b2233
}

/// gradient[p] = d harmonic_re_v3_A_v1_A_v3_conjA_v2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 891 operations.
template <class Scalar>
void lump_gradient_36(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
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
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar omega2_7 = omega2_6 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar omega3_5 = omega3_4 * omega3;
  const Scalar omega3_6 = omega3_5 * omega3;
  const Scalar omega3_7 = omega3_6 * omega3;
  const Scalar omega3_8 = omega3_7 * omega3;
  const Scalar denominator = Scalar(4.0) * omega1_7 * omega2 * omega3 - Scalar(2.0) * omega1_7 * omega3_2
      - Scalar(8.0) * omega1_6 * omega2_2 * omega3 + Scalar(14.0) * omega1_6 * omega2 * omega3_2
      - Scalar(5.0) * omega1_6 * omega3_3 - Scalar(4.0) * omega1_5 * omega2_3 * omega3
      - Scalar(10.0) * omega1_5 * omega2_2 * omega3_2 + Scalar(2.0) * omega1_5 * omega2 * omega3_3
      + Scalar(2.0) * omega1_5 * omega3_4 + Scalar(16.0) * omega1_4 * omega2_4 * omega3
      - Scalar(26.0) * omega1_4 * omega2_3 * omega3_2 + Scalar(21.0) * omega1_4 * omega2_2 * omega3_3
      - Scalar(26.0) * omega1_4 * omega2 * omega3_4 + Scalar(10.0) * omega1_4 * omega3_5
      - Scalar(4.0) * omega1_3 * omega2_5 * omega3 + Scalar(26.0) * omega1_3 * omega2_4 * omega3_2
      - Scalar(36.0) * omega1_3 * omega2_3 * omega3_3 + Scalar(36.0) * omega1_3 * omega2_2 * omega3_4
      - Scalar(16.0) * omega1_3 * omega2 * omega3_5 + Scalar(2.0) * omega1_3 * omega3_6
      - Scalar(8.0) * omega1_2 * omega2_6 * omega3 + Scalar(10.0) * omega1_2 * omega2_5 * omega3_2
      + Scalar(21.0) * omega1_2 * omega2_4 * omega3_3 - Scalar(36.0) * omega1_2 * omega2_3 * omega3_4
      + Scalar(12.0) * omega1_2 * omega2_2 * omega3_5 + Scalar(10.0) * omega1_2 * omega2 * omega3_6
      - Scalar(5.0) * omega1_2 * omega3_7 + Scalar(4.0) * omega1 * omega2_7 * omega3
      - Scalar(14.0) * omega1 * omega2_6 * omega3_2 + Scalar(2.0) * omega1 * omega2_5 * omega3_3
      + Scalar(26.0) * omega1 * omega2_4 * omega3_4 - Scalar(16.0) * omega1 * omega2_3 * omega3_5
      - Scalar(10.0) * omega1 * omega2_2 * omega3_6 + Scalar(10.0) * omega1 * omega2 * omega3_7
      - Scalar(2.0) * omega1 * omega3_8 + Scalar(2.0) * omega2_7 * omega3_2 - Scalar(5.0) * omega2_6 * omega3_3
      - Scalar(2.0) * omega2_5 * omega3_4 + Scalar(10.0) * omega2_4 * omega3_5 - Scalar(2.0) * omega2_3 * omega3_6
      - Scalar(5.0) * omega2_2 * omega3_7 + Scalar(2.0) * omega2 * omega3_8;
  // multiplies a113*a123
  const Scalar c_0 = Scalar(4.0) * omega1_4 * omega2 - Scalar(2.0) * omega1_4 * omega3
      - Scalar(8.0) * omega1_3 * omega2 * omega3 + Scalar(4.0) * omega1_3 * omega3_2
      - Scalar(8.0) * omega1_2 * omega2_3 + Scalar(4.0) * omega1_2 * omega2_2 * omega3
      - Scalar(12.0) * omega1_2 * omega2 * omega3_2 + Scalar(6.0) * omega1_2 * omega3_3
      + Scalar(8.0) * omega1 * omega2_3 * omega3 + Scalar(12.0) * omega1 * omega2_2 * omega3_2
      - Scalar(4.0) * omega1 * omega3_4 + Scalar(4.0) * omega2_5 - Scalar(2.0) * omega2_4 * omega3
      - Scalar(4.0) * omega2_3 * omega3_2 + Scalar(10.0) * omega2_2 * omega3_3 + Scalar(4.0) * omega2 * omega3_4
      - Scalar(4.0) * omega3_5;
  // multiplies a123*a223
  const Scalar c_1 = -Scalar(4.0) * omega1_5 - Scalar(2.0) * omega1_4 * omega3 + Scalar(8.0) * omega1_3 * omega2_2
      + Scalar(8.0) * omega1_3 * omega2 * omega3 + Scalar(4.0) * omega1_3 * omega3_2
      + Scalar(4.0) * omega1_2 * omega2_2 * omega3 - Scalar(12.0) * omega1_2 * omega2 * omega3_2
      + Scalar(10.0) * omega1_2 * omega3_3 - Scalar(4.0) * omega1 * omega2_4
      - Scalar(8.0) * omega1 * omega2_3 * omega3 + Scalar(12.0) * omega1 * omega2_2 * omega3_2
      - Scalar(4.0) * omega1 * omega3_4 - Scalar(2.0) * omega2_4 * omega3 - Scalar(4.0) * omega2_3 * omega3_2
      + Scalar(6.0) * omega2_2 * omega3_3 + Scalar(4.0) * omega2 * omega3_4 - Scalar(4.0) * omega3_5;
  // multiplies a123*a333
  const Scalar c_2 = Scalar(8.0) * omega1_3 * omega2 * omega3 - Scalar(4.0) * omega1_3 * omega3_2
      + Scalar(16.0) * omega1_2 * omega2_2 * omega3 - Scalar(4.0) * omega1_2 * omega2 * omega3_2
      - Scalar(2.0) * omega1_2 * omega3_3 + Scalar(8.0) * omega1 * omega2_3 * omega3
      + Scalar(4.0) * omega1 * omega2_2 * omega3_2 - Scalar(12.0) * omega1 * omega2 * omega3_3
      + Scalar(4.0) * omega1 * omega3_4 + Scalar(4.0) * omega2_3 * omega3_2 - Scalar(2.0) * omega2_2 * omega3_3
      - Scalar(4.0) * omega2 * omega3_4 + Scalar(2.0) * omega3_5;
  const Scalar w_0 = -Scalar(4.0) * a123 * a223;  // multiplies omega1^5
  const Scalar w_1 = Scalar(4.0) * a113 * a123;  // multiplies omega1^4*omega2
  const Scalar w_2 = -Scalar(2.0) * a113 * a123 - Scalar(2.0) * a123 * a223;  // multiplies omega1^4*omega3
  const Scalar w_3 = Scalar(8.0) * a123 * a223;  // multiplies omega1^3*omega2^2
  // multiplies omega1^3*omega2*omega3
  const Scalar w_4 = -Scalar(8.0) * a113 * a123 + Scalar(8.0) * a123 * a223 + Scalar(8.0) * a123 * a333;
  // multiplies omega1^3*omega3^2
  const Scalar w_5 = Scalar(4.0) * a113 * a123 + Scalar(4.0) * a123 * a223 - Scalar(4.0) * a123 * a333;
  const Scalar w_6 = -Scalar(8.0) * a113 * a123;  // multiplies omega1^2*omega2^3
  // multiplies omega1^2*omega2^2*omega3
  const Scalar w_7 = Scalar(4.0) * a113 * a123 + Scalar(4.0) * a123 * a223 + Scalar(16.0) * a123 * a333;
  // multiplies omega1^2*omega2*omega3^2
  const Scalar w_8 = -Scalar(12.0) * a113 * a123 - Scalar(12.0) * a123 * a223 - Scalar(4.0) * a123 * a333;
  // multiplies omega1^2*omega3^3
  const Scalar w_9 = Scalar(6.0) * a113 * a123 + Scalar(10.0) * a123 * a223 - Scalar(2.0) * a123 * a333;
  const Scalar w_10 = -Scalar(4.0) * a123 * a223;  // multiplies omega1*omega2^4
  // multiplies omega1*omega2^3*omega3
  const Scalar w_11 = Scalar(8.0) * a113 * a123 - Scalar(8.0) * a123 * a223 + Scalar(8.0) * a123 * a333;
  // multiplies omega1*omega2^2*omega3^2
  const Scalar w_12 = Scalar(12.0) * a113 * a123 + Scalar(12.0) * a123 * a223 + Scalar(4.0) * a123 * a333;
  const Scalar w_13 = -Scalar(12.0) * a123 * a333;  // multiplies omega1*omega2*omega3^3
  // multiplies omega1*omega3^4
  const Scalar w_14 = -Scalar(4.0) * a113 * a123 - Scalar(4.0) * a123 * a223 + Scalar(4.0) * a123 * a333;
  const Scalar w_15 = Scalar(4.0) * a113 * a123;  // multiplies omega2^5
  const Scalar w_16 = -Scalar(2.0) * a113 * a123 - Scalar(2.0) * a123 * a223;  // multiplies omega2^4*omega3
  // multiplies omega2^3*omega3^2
  const Scalar w_17 = -Scalar(4.0) * a113 * a123 - Scalar(4.0) * a123 * a223 + Scalar(4.0) * a123 * a333;
  // multiplies omega2^2*omega3^3
  const Scalar w_18 = Scalar(10.0) * a113 * a123 + Scalar(6.0) * a123 * a223 - Scalar(2.0) * a123 * a333;
  // multiplies omega2*omega3^4
  const Scalar w_19 = Scalar(4.0) * a113 * a123 + Scalar(4.0) * a123 * a223 - Scalar(4.0) * a123 * a333;
  // multiplies omega3^5
  const Scalar w_20 = -Scalar(4.0) * a113 * a123 - Scalar(4.0) * a123 * a223 + Scalar(2.0) * a123 * a333;
  // by omega1
  gradient[0] = (Scalar(5.0) * omega1_4 * w_0 + Scalar(4.0) * omega1_3 * omega2 * w_1
      + Scalar(4.0) * omega1_3 * omega3 * w_2 + Scalar(3.0) * omega1_2 * omega2_2 * w_3
      + Scalar(3.0) * omega1_2 * omega2 * omega3 * w_4 + Scalar(3.0) * omega1_2 * omega3_2 * w_5
      + Scalar(2.0) * omega1 * omega2_3 * w_6 + Scalar(2.0) * omega1 * omega2_2 * omega3 * w_7
      + Scalar(2.0) * omega1 * omega2 * omega3_2 * w_8 + Scalar(2.0) * omega1 * omega3_3 * w_9 + omega2_4 * w_10
      + omega2_3 * omega3 * w_11 + omega2_2 * omega3_2 * w_12 + omega2 * omega3_3 * w_13 + omega3_4 * w_14
      - lump * (Scalar(28.0) * omega1_6 * omega2 * omega3 - Scalar(14.0) * omega1_6 * omega3_2
      - Scalar(48.0) * omega1_5 * omega2_2 * omega3 + Scalar(84.0) * omega1_5 * omega2 * omega3_2
      - Scalar(30.0) * omega1_5 * omega3_3 - Scalar(20.0) * omega1_4 * omega2_3 * omega3
      - Scalar(50.0) * omega1_4 * omega2_2 * omega3_2 + Scalar(10.0) * omega1_4 * omega2 * omega3_3
      + Scalar(10.0) * omega1_4 * omega3_4 + Scalar(64.0) * omega1_3 * omega2_4 * omega3
      - Scalar(104.0) * omega1_3 * omega2_3 * omega3_2 + Scalar(84.0) * omega1_3 * omega2_2 * omega3_3
      - Scalar(104.0) * omega1_3 * omega2 * omega3_4 + Scalar(40.0) * omega1_3 * omega3_5
      - Scalar(12.0) * omega1_2 * omega2_5 * omega3 + Scalar(78.0) * omega1_2 * omega2_4 * omega3_2
      - Scalar(108.0) * omega1_2 * omega2_3 * omega3_3 + Scalar(108.0) * omega1_2 * omega2_2 * omega3_4
      - Scalar(48.0) * omega1_2 * omega2 * omega3_5 + Scalar(6.0) * omega1_2 * omega3_6
      - Scalar(16.0) * omega1 * omega2_6 * omega3 + Scalar(20.0) * omega1 * omega2_5 * omega3_2
      + Scalar(42.0) * omega1 * omega2_4 * omega3_3 - Scalar(72.0) * omega1 * omega2_3 * omega3_4
      + Scalar(24.0) * omega1 * omega2_2 * omega3_5 + Scalar(20.0) * omega1 * omega2 * omega3_6
      - Scalar(10.0) * omega1 * omega3_7 + Scalar(4.0) * omega2_7 * omega3 - Scalar(14.0) * omega2_6 * omega3_2
      + Scalar(2.0) * omega2_5 * omega3_3 + Scalar(26.0) * omega2_4 * omega3_4
      - Scalar(16.0) * omega2_3 * omega3_5 - Scalar(10.0) * omega2_2 * omega3_6 + Scalar(10.0) * omega2 * omega3_7
      - Scalar(2.0) * omega3_8)) / denominator;
  // by omega2
  gradient[1] = (omega1_4 * w_1 + Scalar(2.0) * omega1_3 * omega2 * w_3 + omega1_3 * omega3 * w_4
      + Scalar(3.0) * omega1_2 * omega2_2 * w_6 + Scalar(2.0) * omega1_2 * omega2 * omega3 * w_7
      + omega1_2 * omega3_2 * w_8 + Scalar(4.0) * omega1 * omega2_3 * w_10
      + Scalar(3.0) * omega1 * omega2_2 * omega3 * w_11 + Scalar(2.0) * omega1 * omega2 * omega3_2 * w_12
      + omega1 * omega3_3 * w_13 + Scalar(5.0) * omega2_4 * w_15 + Scalar(4.0) * omega2_3 * omega3 * w_16
      + Scalar(3.0) * omega2_2 * omega3_2 * w_17 + Scalar(2.0) * omega2 * omega3_3 * w_18 + omega3_4 * w_19
      - lump * (Scalar(4.0) * omega1_7 * omega3 - Scalar(16.0) * omega1_6 * omega2 * omega3
      + Scalar(14.0) * omega1_6 * omega3_2 - Scalar(12.0) * omega1_5 * omega2_2 * omega3
      - Scalar(20.0) * omega1_5 * omega2 * omega3_2 + Scalar(2.0) * omega1_5 * omega3_3
      + Scalar(64.0) * omega1_4 * omega2_3 * omega3 - Scalar(78.0) * omega1_4 * omega2_2 * omega3_2
      + Scalar(42.0) * omega1_4 * omega2 * omega3_3 - Scalar(26.0) * omega1_4 * omega3_4
      - Scalar(20.0) * omega1_3 * omega2_4 * omega3 + Scalar(104.0) * omega1_3 * omega2_3 * omega3_2
      - Scalar(108.0) * omega1_3 * omega2_2 * omega3_3 + Scalar(72.0) * omega1_3 * omega2 * omega3_4
      - Scalar(16.0) * omega1_3 * omega3_5 - Scalar(48.0) * omega1_2 * omega2_5 * omega3
      + Scalar(50.0) * omega1_2 * omega2_4 * omega3_2 + Scalar(84.0) * omega1_2 * omega2_3 * omega3_3
      - Scalar(108.0) * omega1_2 * omega2_2 * omega3_4 + Scalar(24.0) * omega1_2 * omega2 * omega3_5
      + Scalar(10.0) * omega1_2 * omega3_6 + Scalar(28.0) * omega1 * omega2_6 * omega3
      - Scalar(84.0) * omega1 * omega2_5 * omega3_2 + Scalar(10.0) * omega1 * omega2_4 * omega3_3
      + Scalar(104.0) * omega1 * omega2_3 * omega3_4 - Scalar(48.0) * omega1 * omega2_2 * omega3_5
      - Scalar(20.0) * omega1 * omega2 * omega3_6 + Scalar(10.0) * omega1 * omega3_7
      + Scalar(14.0) * omega2_6 * omega3_2 - Scalar(30.0) * omega2_5 * omega3_3
      - Scalar(10.0) * omega2_4 * omega3_4 + Scalar(40.0) * omega2_3 * omega3_5
      - Scalar(6.0) * omega2_2 * omega3_6 - Scalar(10.0) * omega2 * omega3_7
      + Scalar(2.0) * omega3_8)) / denominator;
  // by omega3
  gradient[2] = (omega1_4 * w_2 + omega1_3 * omega2 * w_4 + Scalar(2.0) * omega1_3 * omega3 * w_5
      + omega1_2 * omega2_2 * w_7 + Scalar(2.0) * omega1_2 * omega2 * omega3 * w_8
      + Scalar(3.0) * omega1_2 * omega3_2 * w_9 + omega1 * omega2_3 * w_11
      + Scalar(2.0) * omega1 * omega2_2 * omega3 * w_12 + Scalar(3.0) * omega1 * omega2 * omega3_2 * w_13
      + Scalar(4.0) * omega1 * omega3_3 * w_14 + omega2_4 * w_16 + Scalar(2.0) * omega2_3 * omega3 * w_17
      + Scalar(3.0) * omega2_2 * omega3_2 * w_18 + Scalar(4.0) * omega2 * omega3_3 * w_19
      + Scalar(5.0) * omega3_4 * w_20 - lump * (Scalar(4.0) * omega1_7 * omega2 - Scalar(4.0) * omega1_7 * omega3
      - Scalar(8.0) * omega1_6 * omega2_2 + Scalar(28.0) * omega1_6 * omega2 * omega3
      - Scalar(15.0) * omega1_6 * omega3_2 - Scalar(4.0) * omega1_5 * omega2_3
      - Scalar(20.0) * omega1_5 * omega2_2 * omega3 + Scalar(6.0) * omega1_5 * omega2 * omega3_2
      + Scalar(8.0) * omega1_5 * omega3_3 + Scalar(16.0) * omega1_4 * omega2_4
      - Scalar(52.0) * omega1_4 * omega2_3 * omega3 + Scalar(63.0) * omega1_4 * omega2_2 * omega3_2
      - Scalar(104.0) * omega1_4 * omega2 * omega3_3 + Scalar(50.0) * omega1_4 * omega3_4
      - Scalar(4.0) * omega1_3 * omega2_5 + Scalar(52.0) * omega1_3 * omega2_4 * omega3
      - Scalar(108.0) * omega1_3 * omega2_3 * omega3_2 + Scalar(144.0) * omega1_3 * omega2_2 * omega3_3
      - Scalar(80.0) * omega1_3 * omega2 * omega3_4 + Scalar(12.0) * omega1_3 * omega3_5
      - Scalar(8.0) * omega1_2 * omega2_6 + Scalar(20.0) * omega1_2 * omega2_5 * omega3
      + Scalar(63.0) * omega1_2 * omega2_4 * omega3_2 - Scalar(144.0) * omega1_2 * omega2_3 * omega3_3
      + Scalar(60.0) * omega1_2 * omega2_2 * omega3_4 + Scalar(60.0) * omega1_2 * omega2 * omega3_5
      - Scalar(35.0) * omega1_2 * omega3_6 + Scalar(4.0) * omega1 * omega2_7
      - Scalar(28.0) * omega1 * omega2_6 * omega3 + Scalar(6.0) * omega1 * omega2_5 * omega3_2
      + Scalar(104.0) * omega1 * omega2_4 * omega3_3 - Scalar(80.0) * omega1 * omega2_3 * omega3_4
      - Scalar(60.0) * omega1 * omega2_2 * omega3_5 + Scalar(70.0) * omega1 * omega2 * omega3_6
      - Scalar(16.0) * omega1 * omega3_7 + Scalar(4.0) * omega2_7 * omega3 - Scalar(15.0) * omega2_6 * omega3_2
      - Scalar(8.0) * omega2_5 * omega3_3 + Scalar(50.0) * omega2_4 * omega3_4
      - Scalar(12.0) * omega2_3 * omega3_5 - Scalar(35.0) * omega2_2 * omega3_6
      + Scalar(16.0) * omega2 * omega3_7)) / denominator;
  gradient[3] = (a123 * c_0) / denominator;  // by a113
  gradient[4] = (a113 * c_0 + a223 * c_1 + a333 * c_2) / denominator;  // by a123
  gradient[5] = (a123 * c_1) / denominator;  // by a223
  gradient[6] = (a123 * c_2) / denominator;  // by a333
}

/// gradient[p] = d harmonic_re_v3_A_v1_A_v2_A_v3 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 891 operations.
template <class Scalar>
void lump_gradient_37(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a223 = parameters[5];
  const Scalar a333 = parameters[6];
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
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar omega2_7 = omega2_6 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar omega3_5 = omega3_4 * omega3;
  const Scalar omega3_6 = omega3_5 * omega3;
  const Scalar omega3_7 = omega3_6 * omega3;
  const Scalar omega3_8 = omega3_7 * omega3;
  const Scalar denominator = Scalar(4.0) * omega1_7 * omega2 * omega3 + Scalar(2.0) * omega1_7 * omega3_2
      + Scalar(8.0) * omega1_6 * omega2_2 * omega3 + Scalar(14.0) * omega1_6 * omega2 * omega3_2
      + Scalar(5.0) * omega1_6 * omega3_3 - Scalar(4.0) * omega1_5 * omega2_3 * omega3
      + Scalar(10.0) * omega1_5 * omega2_2 * omega3_2 + Scalar(2.0) * omega1_5 * omega2 * omega3_3
      - Scalar(2.0) * omega1_5 * omega3_4 - Scalar(16.0) * omega1_4 * omega2_4 * omega3
      - Scalar(26.0) * omega1_4 * omega2_3 * omega3_2 - Scalar(21.0) * omega1_4 * omega2_2 * omega3_3
      - Scalar(26.0) * omega1_4 * omega2 * omega3_4 - Scalar(10.0) * omega1_4 * omega3_5
      - Scalar(4.0) * omega1_3 * omega2_5 * omega3 - Scalar(26.0) * omega1_3 * omega2_4 * omega3_2
      - Scalar(36.0) * omega1_3 * omega2_3 * omega3_3 - Scalar(36.0) * omega1_3 * omega2_2 * omega3_4
      - Scalar(16.0) * omega1_3 * omega2 * omega3_5 - Scalar(2.0) * omega1_3 * omega3_6
      + Scalar(8.0) * omega1_2 * omega2_6 * omega3 + Scalar(10.0) * omega1_2 * omega2_5 * omega3_2
      - Scalar(21.0) * omega1_2 * omega2_4 * omega3_3 - Scalar(36.0) * omega1_2 * omega2_3 * omega3_4
      - Scalar(12.0) * omega1_2 * omega2_2 * omega3_5 + Scalar(10.0) * omega1_2 * omega2 * omega3_6
      + Scalar(5.0) * omega1_2 * omega3_7 + Scalar(4.0) * omega1 * omega2_7 * omega3
      + Scalar(14.0) * omega1 * omega2_6 * omega3_2 + Scalar(2.0) * omega1 * omega2_5 * omega3_3
      - Scalar(26.0) * omega1 * omega2_4 * omega3_4 - Scalar(16.0) * omega1 * omega2_3 * omega3_5
      + Scalar(10.0) * omega1 * omega2_2 * omega3_6 + Scalar(10.0) * omega1 * omega2 * omega3_7
      + Scalar(2.0) * omega1 * omega3_8 + Scalar(2.0) * omega2_7 * omega3_2 + Scalar(5.0) * omega2_6 * omega3_3
      - Scalar(2.0) * omega2_5 * omega3_4 - Scalar(10.0) * omega2_4 * omega3_5 - Scalar(2.0) * omega2_3 * omega3_6
      + Scalar(5.0) * omega2_2 * omega3_7 + Scalar(2.0) * omega2 * omega3_8;
  // multiplies a113*a123
  const Scalar c_0 = Scalar(4.0) * omega1_4 * omega2 + Scalar(2.0) * omega1_4 * omega3
      - Scalar(8.0) * omega1_3 * omega2 * omega3 - Scalar(4.0) * omega1_3 * omega3_2
      - Scalar(8.0) * omega1_2 * omega2_3 - Scalar(4.0) * omega1_2 * omega2_2 * omega3
      - Scalar(12.0) * omega1_2 * omega2 * omega3_2 - Scalar(6.0) * omega1_2 * omega3_3
      + Scalar(8.0) * omega1 * omega2_3 * omega3 - Scalar(12.0) * omega1 * omega2_2 * omega3_2
      + Scalar(4.0) * omega1 * omega3_4 + Scalar(4.0) * omega2_5 + Scalar(2.0) * omega2_4 * omega3
      - Scalar(4.0) * omega2_3 * omega3_2 - Scalar(10.0) * omega2_2 * omega3_3 + Scalar(4.0) * omega2 * omega3_4
      + Scalar(4.0) * omega3_5;
  // multiplies a123*a223
  const Scalar c_1 = Scalar(4.0) * omega1_5 + Scalar(2.0) * omega1_4 * omega3 - Scalar(8.0) * omega1_3 * omega2_2
      + Scalar(8.0) * omega1_3 * omega2 * omega3 - Scalar(4.0) * omega1_3 * omega3_2
      - Scalar(4.0) * omega1_2 * omega2_2 * omega3 - Scalar(12.0) * omega1_2 * omega2 * omega3_2
      - Scalar(10.0) * omega1_2 * omega3_3 + Scalar(4.0) * omega1 * omega2_4
      - Scalar(8.0) * omega1 * omega2_3 * omega3 - Scalar(12.0) * omega1 * omega2_2 * omega3_2
      + Scalar(4.0) * omega1 * omega3_4 + Scalar(2.0) * omega2_4 * omega3 - Scalar(4.0) * omega2_3 * omega3_2
      - Scalar(6.0) * omega2_2 * omega3_3 + Scalar(4.0) * omega2 * omega3_4 + Scalar(4.0) * omega3_5;
  // multiplies a123*a333
  const Scalar c_2 = Scalar(8.0) * omega1_3 * omega2 * omega3 + Scalar(4.0) * omega1_3 * omega3_2
      - Scalar(16.0) * omega1_2 * omega2_2 * omega3 - Scalar(4.0) * omega1_2 * omega2 * omega3_2
      + Scalar(2.0) * omega1_2 * omega3_3 + Scalar(8.0) * omega1 * omega2_3 * omega3
      - Scalar(4.0) * omega1 * omega2_2 * omega3_2 - Scalar(12.0) * omega1 * omega2 * omega3_3
      - Scalar(4.0) * omega1 * omega3_4 + Scalar(4.0) * omega2_3 * omega3_2 + Scalar(2.0) * omega2_2 * omega3_3
      - Scalar(4.0) * omega2 * omega3_4 - Scalar(2.0) * omega3_5;
  const Scalar w_0 = Scalar(4.0) * a123 * a223;  // multiplies omega1^5
  const Scalar w_1 = Scalar(4.0) * a113 * a123;  // multiplies omega1^4*omega2
  const Scalar w_2 = Scalar(2.0) * a113 * a123 + Scalar(2.0) * a123 * a223;  // multiplies omega1^4*omega3
  const Scalar w_3 = -Scalar(8.0) * a123 * a223;  // multiplies omega1^3*omega2^2
  // multiplies omega1^3*omega2*omega3
  const Scalar w_4 = -Scalar(8.0) * a113 * a123 + Scalar(8.0) * a123 * a223 + Scalar(8.0) * a123 * a333;
  // multiplies omega1^3*omega3^2
  const Scalar w_5 = -Scalar(4.0) * a113 * a123 - Scalar(4.0) * a123 * a223 + Scalar(4.0) * a123 * a333;
  const Scalar w_6 = -Scalar(8.0) * a113 * a123;  // multiplies omega1^2*omega2^3
  // multiplies omega1^2*omega2^2*omega3
  const Scalar w_7 = -Scalar(4.0) * a113 * a123 - Scalar(4.0) * a123 * a223 - Scalar(16.0) * a123 * a333;
  // multiplies omega1^2*omega2*omega3^2
  const Scalar w_8 = -Scalar(12.0) * a113 * a123 - Scalar(12.0) * a123 * a223 - Scalar(4.0) * a123 * a333;
  // multiplies omega1^2*omega3^3
  const Scalar w_9 = -Scalar(6.0) * a113 * a123 - Scalar(10.0) * a123 * a223 + Scalar(2.0) * a123 * a333;
  const Scalar w_10 = Scalar(4.0) * a123 * a223;  // multiplies omega1*omega2^4
  // multiplies omega1*omega2^3*omega3
  const Scalar w_11 = Scalar(8.0) * a113 * a123 - Scalar(8.0) * a123 * a223 + Scalar(8.0) * a123 * a333;
  // multiplies omega1*omega2^2*omega3^2
  const Scalar w_12 = -Scalar(12.0) * a113 * a123 - Scalar(12.0) * a123 * a223 - Scalar(4.0) * a123 * a333;
  const Scalar w_13 = -Scalar(12.0) * a123 * a333;  // multiplies omega1*omega2*omega3^3
  // multiplies omega1*omega3^4
  const Scalar w_14 = Scalar(4.0) * a113 * a123 + Scalar(4.0) * a123 * a223 - Scalar(4.0) * a123 * a333;
  const Scalar w_15 = Scalar(4.0) * a113 * a123;  // multiplies omega2^5
  const Scalar w_16 = Scalar(2.0) * a113 * a123 + Scalar(2.0) * a123 * a223;  // multiplies omega2^4*omega3
  // multiplies omega2^3*omega3^2
  const Scalar w_17 = -Scalar(4.0) * a113 * a123 - Scalar(4.0) * a123 * a223 + Scalar(4.0) * a123 * a333;
  // multiplies omega2^2*omega3^3
  const Scalar w_18 = -Scalar(10.0) * a113 * a123 - Scalar(6.0) * a123 * a223 + Scalar(2.0) * a123 * a333;
  // multiplies omega2*omega3^4
  const Scalar w_19 = Scalar(4.0) * a113 * a123 + Scalar(4.0) * a123 * a223 - Scalar(4.0) * a123 * a333;
  // multiplies omega3^5
  const Scalar w_20 = Scalar(4.0) * a113 * a123 + Scalar(4.0) * a123 * a223 - Scalar(2.0) * a123 * a333;
  // by omega1
  gradient[0] = (Scalar(5.0) * omega1_4 * w_0 + Scalar(4.0) * omega1_3 * omega2 * w_1
      + Scalar(4.0) * omega1_3 * omega3 * w_2 + Scalar(3.0) * omega1_2 * omega2_2 * w_3
      + Scalar(3.0) * omega1_2 * omega2 * omega3 * w_4 + Scalar(3.0) * omega1_2 * omega3_2 * w_5
      + Scalar(2.0) * omega1 * omega2_3 * w_6 + Scalar(2.0) * omega1 * omega2_2 * omega3 * w_7
      + Scalar(2.0) * omega1 * omega2 * omega3_2 * w_8 + Scalar(2.0) * omega1 * omega3_3 * w_9 + omega2_4 * w_10
      + omega2_3 * omega3 * w_11 + omega2_2 * omega3_2 * w_12 + omega2 * omega3_3 * w_13 + omega3_4 * w_14
      - lump * (Scalar(28.0) * omega1_6 * omega2 * omega3 + Scalar(14.0) * omega1_6 * omega3_2
      + Scalar(48.0) * omega1_5 * omega2_2 * omega3 + Scalar(84.0) * omega1_5 * omega2 * omega3_2
      + Scalar(30.0) * omega1_5 * omega3_3 - Scalar(20.0) * omega1_4 * omega2_3 * omega3
      + Scalar(50.0) * omega1_4 * omega2_2 * omega3_2 + Scalar(10.0) * omega1_4 * omega2 * omega3_3
      - Scalar(10.0) * omega1_4 * omega3_4 - Scalar(64.0) * omega1_3 * omega2_4 * omega3
      - Scalar(104.0) * omega1_3 * omega2_3 * omega3_2 - Scalar(84.0) * omega1_3 * omega2_2 * omega3_3
      - Scalar(104.0) * omega1_3 * omega2 * omega3_4 - Scalar(40.0) * omega1_3 * omega3_5
      - Scalar(12.0) * omega1_2 * omega2_5 * omega3 - Scalar(78.0) * omega1_2 * omega2_4 * omega3_2
      - Scalar(108.0) * omega1_2 * omega2_3 * omega3_3 - Scalar(108.0) * omega1_2 * omega2_2 * omega3_4
      - Scalar(48.0) * omega1_2 * omega2 * omega3_5 - Scalar(6.0) * omega1_2 * omega3_6
      + Scalar(16.0) * omega1 * omega2_6 * omega3 + Scalar(20.0) * omega1 * omega2_5 * omega3_2
      - Scalar(42.0) * omega1 * omega2_4 * omega3_3 - Scalar(72.0) * omega1 * omega2_3 * omega3_4
      - Scalar(24.0) * omega1 * omega2_2 * omega3_5 + Scalar(20.0) * omega1 * omega2 * omega3_6
      + Scalar(10.0) * omega1 * omega3_7 + Scalar(4.0) * omega2_7 * omega3 + Scalar(14.0) * omega2_6 * omega3_2
      + Scalar(2.0) * omega2_5 * omega3_3 - Scalar(26.0) * omega2_4 * omega3_4
      - Scalar(16.0) * omega2_3 * omega3_5 + Scalar(10.0) * omega2_2 * omega3_6 + Scalar(10.0) * omega2 * omega3_7
      + Scalar(2.0) * omega3_8)) / denominator;
  // by omega2
  gradient[1] = (omega1_4 * w_1 + Scalar(2.0) * omega1_3 * omega2 * w_3 + omega1_3 * omega3 * w_4
      + Scalar(3.0) * omega1_2 * omega2_2 * w_6 + Scalar(2.0) * omega1_2 * omega2 * omega3 * w_7
      + omega1_2 * omega3_2 * w_8 + Scalar(4.0) * omega1 * omega2_3 * w_10
      + Scalar(3.0) * omega1 * omega2_2 * omega3 * w_11 + Scalar(2.0) * omega1 * omega2 * omega3_2 * w_12
      + omega1 * omega3_3 * w_13 + Scalar(5.0) * omega2_4 * w_15 + Scalar(4.0) * omega2_3 * omega3 * w_16
      + Scalar(3.0) * omega2_2 * omega3_2 * w_17 + Scalar(2.0) * omega2 * omega3_3 * w_18 + omega3_4 * w_19
      - lump * (Scalar(4.0) * omega1_7 * omega3 + Scalar(16.0) * omega1_6 * omega2 * omega3
      + Scalar(14.0) * omega1_6 * omega3_2 - Scalar(12.0) * omega1_5 * omega2_2 * omega3
      + Scalar(20.0) * omega1_5 * omega2 * omega3_2 + Scalar(2.0) * omega1_5 * omega3_3
      - Scalar(64.0) * omega1_4 * omega2_3 * omega3 - Scalar(78.0) * omega1_4 * omega2_2 * omega3_2
      - Scalar(42.0) * omega1_4 * omega2 * omega3_3 - Scalar(26.0) * omega1_4 * omega3_4
      - Scalar(20.0) * omega1_3 * omega2_4 * omega3 - Scalar(104.0) * omega1_3 * omega2_3 * omega3_2
      - Scalar(108.0) * omega1_3 * omega2_2 * omega3_3 - Scalar(72.0) * omega1_3 * omega2 * omega3_4
      - Scalar(16.0) * omega1_3 * omega3_5 + Scalar(48.0) * omega1_2 * omega2_5 * omega3
      + Scalar(50.0) * omega1_2 * omega2_4 * omega3_2 - Scalar(84.0) * omega1_2 * omega2_3 * omega3_3
      - Scalar(108.0) * omega1_2 * omega2_2 * omega3_4 - Scalar(24.0) * omega1_2 * omega2 * omega3_5
      + Scalar(10.0) * omega1_2 * omega3_6 + Scalar(28.0) * omega1 * omega2_6 * omega3
      + Scalar(84.0) * omega1 * omega2_5 * omega3_2 + Scalar(10.0) * omega1 * omega2_4 * omega3_3
      - Scalar(104.0) * omega1 * omega2_3 * omega3_4 - Scalar(48.0) * omega1 * omega2_2 * omega3_5
      + Scalar(20.0) * omega1 * omega2 * omega3_6 + Scalar(10.0) * omega1 * omega3_7
      + Scalar(14.0) * omega2_6 * omega3_2 + Scalar(30.0) * omega2_5 * omega3_3
      - Scalar(10.0) * omega2_4 * omega3_4 - Scalar(40.0) * omega2_3 * omega3_5
      - Scalar(6.0) * omega2_2 * omega3_6 + Scalar(10.0) * omega2 * omega3_7
      + Scalar(2.0) * omega3_8)) / denominator;
  // by omega3
  gradient[2] = (omega1_4 * w_2 + omega1_3 * omega2 * w_4 + Scalar(2.0) * omega1_3 * omega3 * w_5
      + omega1_2 * omega2_2 * w_7 + Scalar(2.0) * omega1_2 * omega2 * omega3 * w_8
      + Scalar(3.0) * omega1_2 * omega3_2 * w_9 + omega1 * omega2_3 * w_11
      + Scalar(2.0) * omega1 * omega2_2 * omega3 * w_12 + Scalar(3.0) * omega1 * omega2 * omega3_2 * w_13
      + Scalar(4.0) * omega1 * omega3_3 * w_14 + omega2_4 * w_16 + Scalar(2.0) * omega2_3 * omega3 * w_17
      + Scalar(3.0) * omega2_2 * omega3_2 * w_18 + Scalar(4.0) * omega2 * omega3_3 * w_19
      + Scalar(5.0) * omega3_4 * w_20 - lump * (Scalar(4.0) * omega1_7 * omega2 + Scalar(4.0) * omega1_7 * omega3
      + Scalar(8.0) * omega1_6 * omega2_2 + Scalar(28.0) * omega1_6 * omega2 * omega3
      + Scalar(15.0) * omega1_6 * omega3_2 - Scalar(4.0) * omega1_5 * omega2_3
      + Scalar(20.0) * omega1_5 * omega2_2 * omega3 + Scalar(6.0) * omega1_5 * omega2 * omega3_2
      - Scalar(8.0) * omega1_5 * omega3_3 - Scalar(16.0) * omega1_4 * omega2_4
      - Scalar(52.0) * omega1_4 * omega2_3 * omega3 - Scalar(63.0) * omega1_4 * omega2_2 * omega3_2
      - Scalar(104.0) * omega1_4 * omega2 * omega3_3 - Scalar(50.0) * omega1_4 * omega3_4
      - Scalar(4.0) * omega1_3 * omega2_5 - Scalar(52.0) * omega1_3 * omega2_4 * omega3
      - Scalar(108.0) * omega1_3 * omega2_3 * omega3_2 - Scalar(144.0) * omega1_3 * omega2_2 * omega3_3
      - Scalar(80.0) * omega1_3 * omega2 * omega3_4 - Scalar(12.0) * omega1_3 * omega3_5
      + Scalar(8.0) * omega1_2 * omega2_6 + Scalar(20.0) * omega1_2 * omega2_5 * omega3
      - Scalar(63.0) * omega1_2 * omega2_4 * omega3_2 - Scalar(144.0) * omega1_2 * omega2_3 * omega3_3
      - Scalar(60.0) * omega1_2 * omega2_2 * omega3_4 + Scalar(60.0) * omega1_2 * omega2 * omega3_5
      + Scalar(35.0) * omega1_2 * omega3_6 + Scalar(4.0) * omega1 * omega2_7
      + Scalar(28.0) * omega1 * omega2_6 * omega3 + Scalar(6.0) * omega1 * omega2_5 * omega3_2
      - Scalar(104.0) * omega1 * omega2_4 * omega3_3 - Scalar(80.0) * omega1 * omega2_3 * omega3_4
      + Scalar(60.0) * omega1 * omega2_2 * omega3_5 + Scalar(70.0) * omega1 * omega2 * omega3_6
      + Scalar(16.0) * omega1 * omega3_7 + Scalar(4.0) * omega2_7 * omega3 + Scalar(15.0) * omega2_6 * omega3_2
      - Scalar(8.0) * omega2_5 * omega3_3 - Scalar(50.0) * omega2_4 * omega3_4
      - Scalar(12.0) * omega2_3 * omega3_5 + Scalar(35.0) * omega2_2 * omega3_6
      + Scalar(16.0) * omega2 * omega3_7)) / denominator;
  gradient[3] = (a123 * c_0) / denominator;  // by a113
  gradient[4] = (a113 * c_0 + a223 * c_1 + a333 * c_2) / denominator;  // by a123
  gradient[5] = (a123 * c_1) / denominator;  // by a223
  gradient[6] = (a123 * c_2) / denominator;  // by a333
}

/// gradient[p] = d harmonic_re_v3_A_v12_A_v3 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 213 operations.
template <class Scalar>
void lump_gradient_38(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  const Scalar a113 = parameters[3];
  const Scalar a123 = parameters[4];
  const Scalar a333 = parameters[6];
  const Scalar b1133 = parameters[10];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega1_6 = omega1_5 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  const Scalar omega3_5 = omega3_4 * omega3;
  const Scalar omega3_6 = omega3_5 * omega3;
  const Scalar a113_2 = a113 * a113;
  const Scalar a123_2 = a123 * a123;
  const Scalar denominator = Scalar(16.0) * omega1_6 * omega3 + Scalar(48.0) * omega1_5 * omega3_2
      - Scalar(16.0) * omega1_4 * omega2_2 * omega3 + Scalar(44.0) * omega1_4 * omega3_3
      - Scalar(16.0) * omega1_3 * omega2_2 * omega3_2 + Scalar(4.0) * omega1_3 * omega3_4
      + Scalar(4.0) * omega1_2 * omega2_2 * omega3_3 - Scalar(12.0) * omega1_2 * omega3_5
      + Scalar(4.0) * omega1 * omega2_2 * omega3_4 - Scalar(4.0) * omega1 * omega3_6;
  // multiplies a113^2
  const Scalar c_0 = Scalar(8.0) * omega1_3 + Scalar(12.0) * omega1_2 * omega3 - Scalar(8.0) * omega1 * omega2_2
      + Scalar(4.0) * omega2_2 * omega3 - Scalar(4.0) * omega3_3;
  // multiplies a113*a333
  const Scalar c_1 = Scalar(2.0) * omega1_2 * omega3 + Scalar(4.0) * omega1 * omega3_2
      - Scalar(2.0) * omega2_2 * omega3 + Scalar(2.0) * omega3_3;
  const Scalar c_2 = Scalar(4.0) * omega1_2 * omega3 - omega3_3;  // multiplies a123^2
  // multiplies b1133
  const Scalar c_3 = Scalar(4.0) * omega1_4 * omega3 + Scalar(8.0) * omega1_3 * omega3_2
      - Scalar(4.0) * omega1_2 * omega2_2 * omega3 + Scalar(3.0) * omega1_2 * omega3_3
      - Scalar(2.0) * omega1 * omega3_4 + omega2_2 * omega3_3 - omega3_5;
  const Scalar w_0 = Scalar(4.0) * b1133;  // multiplies omega1^4*omega3
  const Scalar w_1 = Scalar(8.0) * b1133;  // multiplies omega1^3*omega3^2
  const Scalar w_2 = Scalar(8.0) * a113_2;  // multiplies omega1^3
  const Scalar w_3 = -Scalar(4.0) * b1133;  // multiplies omega1^2*omega2^2*omega3
  const Scalar w_4 = Scalar(3.0) * b1133;  // multiplies omega1^2*omega3^3
  // multiplies omega1^2*omega3
  const Scalar w_5 = Scalar(12.0) * a113_2 + Scalar(2.0) * a113 * a333 + Scalar(4.0) * a123_2;
  const Scalar w_6 = -Scalar(8.0) * a113_2;  // multiplies omega1*omega2^2
  const Scalar w_7 = -Scalar(2.0) * b1133;  // multiplies omega1*omega3^4
  const Scalar w_8 = Scalar(4.0) * a113 * a333;  // multiplies omega1*omega3^2
  const Scalar w_9 = b1133;  // multiplies omega2^2*omega3^3
  const Scalar w_10 = Scalar(4.0) * a113_2 - Scalar(2.0) * a113 * a333;  // multiplies omega2^2*omega3
  const Scalar w_11 = -b1133;  // multiplies omega3^5
  const Scalar w_12 = -Scalar(4.0) * a113_2 + Scalar(2.0) * a113 * a333 - a123_2;  // multiplies omega3^3
  // by omega1
  gradient[0] = (Scalar(4.0) * omega1_3 * omega3 * w_0 + Scalar(3.0) * omega1_2 * omega3_2 * w_1
      + Scalar(3.0) * omega1_2 * w_2 + Scalar(2.0) * omega1 * omega2_2 * omega3 * w_3
      + Scalar(2.0) * omega1 * omega3_3 * w_4 + Scalar(2.0) * omega1 * omega3 * w_5 + omega2_2 * w_6
      + omega3_4 * w_7 + omega3_2 * w_8 - lump * (Scalar(96.0) * omega1_5 * omega3
      + Scalar(240.0) * omega1_4 * omega3_2 - Scalar(64.0) * omega1_3 * omega2_2 * omega3
      + Scalar(176.0) * omega1_3 * omega3_3 - Scalar(48.0) * omega1_2 * omega2_2 * omega3_2
      + Scalar(12.0) * omega1_2 * omega3_4 + Scalar(8.0) * omega1 * omega2_2 * omega3_3
      - Scalar(24.0) * omega1 * omega3_5 + Scalar(4.0) * omega2_2 * omega3_4
      - Scalar(4.0) * omega3_6)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_2 * omega2 * omega3 * w_3 + Scalar(2.0) * omega1 * omega2 * w_6
      + Scalar(2.0) * omega2 * omega3_3 * w_9 + Scalar(2.0) * omega2 * omega3 * w_10
      - lump * (-Scalar(32.0) * omega1_4 * omega2 * omega3 - Scalar(32.0) * omega1_3 * omega2 * omega3_2
      + Scalar(8.0) * omega1_2 * omega2 * omega3_3 + Scalar(8.0) * omega1 * omega2 * omega3_4)) / denominator;
  // by omega3
  gradient[2] = (omega1_4 * w_0 + Scalar(2.0) * omega1_3 * omega3 * w_1 + omega1_2 * omega2_2 * w_3
      + Scalar(3.0) * omega1_2 * omega3_2 * w_4 + omega1_2 * w_5 + Scalar(4.0) * omega1 * omega3_3 * w_7
      + Scalar(2.0) * omega1 * omega3 * w_8 + Scalar(3.0) * omega2_2 * omega3_2 * w_9 + omega2_2 * w_10
      + Scalar(5.0) * omega3_4 * w_11 + Scalar(3.0) * omega3_2 * w_12 - lump * (Scalar(16.0) * omega1_6
      + Scalar(96.0) * omega1_5 * omega3 - Scalar(16.0) * omega1_4 * omega2_2
      + Scalar(132.0) * omega1_4 * omega3_2 - Scalar(32.0) * omega1_3 * omega2_2 * omega3
      + Scalar(16.0) * omega1_3 * omega3_3 + Scalar(12.0) * omega1_2 * omega2_2 * omega3_2
      - Scalar(60.0) * omega1_2 * omega3_4 + Scalar(16.0) * omega1 * omega2_2 * omega3_3
      - Scalar(24.0) * omega1 * omega3_5)) / denominator;
  gradient[3] = (Scalar(2.0) * a113 * c_0 + a333 * c_1) / denominator;  // by a113
  gradient[4] = (Scalar(2.0) * a123 * c_2) / denominator;  // by a123
  gradient[6] = (a113 * c_1) / denominator;  // by a333
  gradient[10] = (c_3) / denominator;  // by b1133
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
  Scalar lumps[39];
  evaluate_lumps(parameters, lumps);
  for (std::size_t i = 0; i < 741; ++i) jacobian[i] = Scalar(0.0);
  jacobian[13] = Scalar(1.0);  // d mu1 / d mu1
  lump_gradient_1(parameters, lumps[1], jacobian + 19);  // d conservative_v1_A_v1_A_v3_conjA_v3
  lump_gradient_2(parameters, lumps[2], jacobian + 38);  // d conservative_v1_A_v1_A_v2_conjA_v2
  lump_gradient_3(parameters, lumps[3], jacobian + 57);  // d conservative_v1_A_v12_conjA_v1
  jacobian[91] = Scalar(1.0);  // d mu2 / d mu2
  lump_gradient_5(parameters, lumps[5], jacobian + 95);  // d conservative_v2_A_v2_A_v3_conjA_v3
  lump_gradient_6(parameters, lumps[6], jacobian + 114);  // d conservative_v2_A_v22_conjA_v2
  jacobian[150] = Scalar(1.0);  // d mu3 / d mu3
  jacobian[154] = Scalar(5.0) * a333_2 / omega3_4;  // d conservative_v3_A_v32_conjA_v3 / d omega3
  jacobian[158] = -Scalar(10.0) * a333 / (Scalar(3.0) * omega3_3);  // d conservative_v3_A_v32_conjA_v3 / d a333
  jacobian[174] = Scalar(1.0);  // d a113 / d a113
  jacobian[194] = Scalar(1.0);  // d a123 / d a123
  lump_gradient_11(parameters, lumps[11], jacobian + 209);  // d harmonic_re_v1_A_v2_conjA_v12
  lump_gradient_12(parameters, lumps[12], jacobian + 228);  // d harmonic_re_v1_A_v32_conjA_v1
  lump_gradient_13(parameters, lumps[13], jacobian + 247);  // d harmonic_re_v1_A_v22_conjA_v1
  lump_gradient_14(parameters, lumps[14], jacobian + 266);  // d harmonic_re_v1_A_v32_conjA_v2
  lump_gradient_15(parameters, lumps[15], jacobian + 285);  // d harmonic_re_v1_A_v2_A_v3_conjA_v3
  lump_gradient_16(parameters, lumps[16], jacobian + 304);  // d harmonic_re_v1_A_v22_conjA_v2
  lump_gradient_17(parameters, lumps[17], jacobian + 323);  // d harmonic_re_v1_A_v2_A_v32
  lump_gradient_18(parameters, lumps[18], jacobian + 342);  // d harmonic_re_v1_A_v1_A_v32
  lump_gradient_19(parameters, lumps[19], jacobian + 361);  // d harmonic_re_v1_A_v1_A_v22
  lump_gradient_20(parameters, lumps[20], jacobian + 380);  // d harmonic_re_v1_A_v13
  jacobian[404] = Scalar(1.0);  // d a223 / d a223
  lump_gradient_22(parameters, lumps[22], jacobian + 418);  // d harmonic_re_v2_A_v2_conjA_v12
  lump_gradient_23(parameters, lumps[23], jacobian + 437);  // d harmonic_re_v2_A_v32_conjA_v1
  lump_gradient_24(parameters, lumps[24], jacobian + 456);  // d harmonic_re_v2_A_v32_conjA_v2
  lump_gradient_25(parameters, lumps[25], jacobian + 475);  // d harmonic_re_v2_A_v2_A_v32
  lump_gradient_26(parameters, lumps[26], jacobian + 494);  // d harmonic_re_v2_A_v23
  lump_gradient_27(parameters, lumps[27], jacobian + 513);  // d harmonic_re_v2_A_v1_A_v3_conjA_v3
  lump_gradient_28(parameters, lumps[28], jacobian + 532);  // d harmonic_re_v2_A_v1_A_v32
  lump_gradient_29(parameters, lumps[29], jacobian + 551);  // d harmonic_re_v2_A_v12_A_v2
  jacobian[576] = Scalar(1.0);  // d a333 / d a333
  lump_gradient_31(parameters, lumps[31], jacobian + 589);  // d harmonic_re_v3_A_v3_conjA_v12
  lump_gradient_32(parameters, lumps[32], jacobian + 608);  // d harmonic_re_v3_A_v3_conjA_v1_conjA_v2
  lump_gradient_33(parameters, lumps[33], jacobian + 627);  // d harmonic_re_v3_A_v2_A_v3_conjA_v1
  lump_gradient_34(parameters, lumps[34], jacobian + 646);  // d harmonic_re_v3_A_v22_conjA_v3
  lump_gradient_35(parameters, lumps[35], jacobian + 665);  // d harmonic_re_v3_A_v22_A_v3
  lump_gradient_36(parameters, lumps[36], jacobian + 684);  // d harmonic_re_v3_A_v1_A_v3_conjA_v2
  lump_gradient_37(parameters, lumps[37], jacobian + 703);  // d harmonic_re_v3_A_v1_A_v2_A_v3
  lump_gradient_38(parameters, lumps[38], jacobian + 722);  // d harmonic_re_v3_A_v12_A_v3
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
  const Scalar omega3_2 = omega3 * omega3;
  factor[0] = -Scalar(2.0) / (Scalar(2.0) * omega1 * omega3 - omega3_2);
}

/// Rows of the harmonic -omega1+omega3 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + omega3)*t) in v1 = -2/(2*omega1*omega3 - omega3^2)*a113*conj(A_v1)*A_v3
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

/// What multiplies the 1 terms of the harmonic -omega2+omega3 of v1: functions of the frequencies alone. 9
/// operations.
template <class Scalar>
void factors_4([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  factor[0] = -Scalar(1.0) / (omega1_2 - omega2_2 + Scalar(2.0) * omega2 * omega3 - omega3_2);
}

/// Rows of the harmonic -omega2+omega3 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega2 + omega3)*t) in v1 = -1/(omega1^2 - omega2^2 + 2*omega2*omega3 -
/// omega3^2)*a123*conj(A_v2)*A_v3
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

/// What multiplies the 1 terms of the harmonic omega2+omega3 of v1: functions of the frequencies alone. 9
/// operations.
template <class Scalar>
void factors_5([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  factor[0] = -Scalar(1.0) / (omega1_2 - omega2_2 - Scalar(2.0) * omega2 * omega3 - omega3_2);
}

/// Rows of the harmonic omega2+omega3 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + omega3)*t) in v1 = -1/(omega1^2 - omega2^2 - 2*omega2*omega3 -
/// omega3^2)*a123*A_v2*A_v3
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
  const Scalar omega3_2 = omega3 * omega3;
  factor[0] = Scalar(2.0) / (Scalar(2.0) * omega1 * omega3 + omega3_2);
}

/// Rows of the harmonic omega1+omega3 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + omega3)*t) in v1 = 2/(2*omega1*omega3 + omega3^2)*a113*A_v1*A_v3
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

/// What multiplies the 1 terms of the harmonic -2*omega1+omega2 of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_7([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic -2*omega1+omega2 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-2*omega1 + omega2)*t) in v1 = harmonic_re_v1_A_v2_conjA_v12*conj(A_v1)^2*A_v2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_7(const BatchArrays& data, Factors factors, double* const* columns) {
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
inline void columns_7(const BatchArrays& data, double* const* columns) {
  rows_7(data, FactorValues<factors_7<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_7(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
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

/// What multiplies the 1 terms of the harmonic -omega1+2*omega2 of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_9([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic -omega1+2*omega2 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + 2*omega2)*t) in v1 = harmonic_re_v1_A_v22_conjA_v1*conj(A_v1)*A_v2^2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_9(const BatchArrays& data, Factors factors, double* const* columns) {
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
inline void columns_9(const BatchArrays& data, double* const* columns) {
  rows_9(data, FactorValues<factors_9<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_9(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
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

/// What multiplies the 3 terms of the harmonic omega2 of v1: functions of the frequencies alone. 113 operations.
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
  factor[0] = (Scalar(24.0) * omega1_7 - Scalar(8.0) * omega1_6 * omega2 - Scalar(48.0) * omega1_5 * omega2_2
      - Scalar(102.0) * omega1_5 * omega3_2 + Scalar(16.0) * omega1_4 * omega2_3
      + Scalar(34.0) * omega1_4 * omega2 * omega3_2 + Scalar(24.0) * omega1_3 * omega2_4
      - Scalar(84.0) * omega1_3 * omega2_2 * omega3_2 + Scalar(96.0) * omega1_3 * omega3_4
      - Scalar(8.0) * omega1_2 * omega2_5 + Scalar(28.0) * omega1_2 * omega2_3 * omega3_2
      - Scalar(32.0) * omega1_2 * omega2 * omega3_4 - Scalar(6.0) * omega1 * omega2_4 * omega3_2
      + Scalar(24.0) * omega1 * omega2_2 * omega3_4 - Scalar(18.0) * omega1 * omega3_6
      + Scalar(2.0) * omega2_5 * omega3_2 - Scalar(8.0) * omega2_3 * omega3_4
      + Scalar(6.0) * omega2 * omega3_6) / (Scalar(9.0) * omega1_5 * omega3_2
      + Scalar(25.0) * omega1_4 * omega2 * omega3_2 + Scalar(22.0) * omega1_3 * omega2_2 * omega3_2
      - Scalar(12.0) * omega1_3 * omega3_4 + Scalar(6.0) * omega1_2 * omega2_3 * omega3_2
      - Scalar(16.0) * omega1_2 * omega2 * omega3_4 + omega1 * omega2_4 * omega3_2
      - Scalar(8.0) * omega1 * omega2_2 * omega3_4 + Scalar(3.0) * omega1 * omega3_6 + omega2_5 * omega3_2
      - Scalar(4.0) * omega2_3 * omega3_4 + Scalar(3.0) * omega2 * omega3_6);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega2 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2)*t) in v1 = (24*omega1^7 - 8*omega1^6*omega2 - 48*omega1^5*omega2^2 -
/// 102*omega1^5*omega3^2 + 16*omega1^4*omega2^3 + 34*omega1^4*omega2*omega3^2 + 24*omega1^3*omega2^4 -
/// 84*omega1^3*omega2^2*omega3^2 + 96*omega1^3*omega3^4 - 8*omega1^2*omega2^5 + 28*omega1^2*omega2^3*omega3^2 -
/// 32*omega1^2*omega2*omega3^4 - 6*omega1*omega2^4*omega3^2 + 24*omega1*omega2^2*omega3^4 - 18*omega1*omega3^6 +
/// 2*omega2^5*omega3^2 - 8*omega2^3*omega3^4 + 6*omega2*omega3^6)/(9*omega1^5*omega3^2 +
/// 25*omega1^4*omega2*omega3^2 + 22*omega1^3*omega2^2*omega3^2 - 12*omega1^3*omega3^4 +
/// 6*omega1^2*omega2^3*omega3^2 - 16*omega1^2*omega2*omega3^4 + omega1*omega2^4*omega3^2 -
/// 8*omega1*omega2^2*omega3^4 + 3*omega1*omega3^6 + omega2^5*omega3^2 - 4*omega2^3*omega3^4 +
/// 3*omega2*omega3^6)*harmonic_re_v1_A_v2_conjA_v12*A_v1*conj(A_v1)*A_v2 +
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

/// What multiplies the 1 terms of the harmonic 3*omega2 of v1: functions of the frequencies alone. 19
/// operations.
template <class Scalar>
void factors_13([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  factor[0] = (-omega1_2 * omega3_2 + omega2_2 * omega3_2) / (Scalar(8.0) * omega1_2 * omega2_2
      - Scalar(3.0) * omega1_2 * omega3_2 - Scalar(72.0) * omega2_4 + Scalar(27.0) * omega2_2 * omega3_2);
}

/// Rows of the harmonic 3*omega2 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega2)*t) in v1 = (-omega1^2*omega3^2 + omega2^2*omega3^2)/(8*omega1^2*omega2^2 -
/// 3*omega1^2*omega3^2 - 72*omega2^4 + 27*omega2^2*omega3^2)*harmonic_re_v1_A_v22_conjA_v2*A_v2^3
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_13(const BatchArrays& data, Factors factors, double* const* columns) {
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
inline void columns_13(const BatchArrays& data, double* const* columns) {
  rows_13(data, FactorValues<factors_13<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_13(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_13(data, FactorSlopes<factors_13<DualNumber>, 3, 1, 1>{mode}, columns);
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

/// What multiplies the 1 terms of the harmonic 2*omega1+omega2 of v1: functions of the frequencies alone. 104
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
  factor[0] = (Scalar(27.0) * omega1_6 - Scalar(84.0) * omega1_5 * omega2 + Scalar(91.0) * omega1_4 * omega2_2
      - Scalar(36.0) * omega1_4 * omega3_2 - Scalar(40.0) * omega1_3 * omega2_3
      + Scalar(60.0) * omega1_3 * omega2 * omega3_2 + Scalar(9.0) * omega1_2 * omega2_4
      - Scalar(40.0) * omega1_2 * omega2_2 * omega3_2 + Scalar(9.0) * omega1_2 * omega3_4
      - Scalar(4.0) * omega1 * omega2_5 + Scalar(20.0) * omega1 * omega2_3 * omega3_2
      - Scalar(12.0) * omega1 * omega2 * omega3_4 + omega2_6 - Scalar(4.0) * omega2_4 * omega3_2
      + Scalar(3.0) * omega2_2 * omega3_4) / (Scalar(27.0) * omega1_6 + Scalar(84.0) * omega1_5 * omega2
      + Scalar(91.0) * omega1_4 * omega2_2 - Scalar(36.0) * omega1_4 * omega3_2
      + Scalar(40.0) * omega1_3 * omega2_3 - Scalar(60.0) * omega1_3 * omega2 * omega3_2
      + Scalar(9.0) * omega1_2 * omega2_4 - Scalar(40.0) * omega1_2 * omega2_2 * omega3_2
      + Scalar(9.0) * omega1_2 * omega3_4 + Scalar(4.0) * omega1 * omega2_5
      - Scalar(20.0) * omega1 * omega2_3 * omega3_2 + Scalar(12.0) * omega1 * omega2 * omega3_4 + omega2_6
      - Scalar(4.0) * omega2_4 * omega3_2 + Scalar(3.0) * omega2_2 * omega3_4);
}

/// Rows of the harmonic 2*omega1+omega2 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega1 + omega2)*t) in v1 = (27*omega1^6 - 84*omega1^5*omega2 + 91*omega1^4*omega2^2 -
/// 36*omega1^4*omega3^2 - 40*omega1^3*omega2^3 + 60*omega1^3*omega2*omega3^2 + 9*omega1^2*omega2^4 -
/// 40*omega1^2*omega2^2*omega3^2 + 9*omega1^2*omega3^4 - 4*omega1*omega2^5 + 20*omega1*omega2^3*omega3^2 -
/// 12*omega1*omega2*omega3^4 + omega2^6 - 4*omega2^4*omega3^2 + 3*omega2^2*omega3^4)/(27*omega1^6 +
/// 84*omega1^5*omega2 + 91*omega1^4*omega2^2 - 36*omega1^4*omega3^2 + 40*omega1^3*omega2^3 -
/// 60*omega1^3*omega2*omega3^2 + 9*omega1^2*omega2^4 - 40*omega1^2*omega2^2*omega3^2 + 9*omega1^2*omega3^4 +
/// 4*omega1*omega2^5 - 20*omega1*omega2^3*omega3^2 + 12*omega1*omega2*omega3^4 + omega2^6 - 4*omega2^4*omega3^2
/// + 3*omega2^2*omega3^4)*harmonic_re_v1_A_v2_conjA_v12*A_v1^2*A_v2
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

/// What multiplies the 1 terms of the harmonic 3*omega1 of v1: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_17([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic 3*omega1 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega1)*t) in v1 = harmonic_re_v1_A_v13*A_v1^3
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
    store_complex(column_0, i, factor[0] * (A_v1 * A_v1 * A_v1));  // harmonic_re_v1_A_v13
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

/// What multiplies the 1 terms of the harmonic -omega1+omega3 of v2: functions of the frequencies alone. 9
/// operations.
template <class Scalar>
void factors_18([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  factor[0] = Scalar(1.0) / (omega1_2 - Scalar(2.0) * omega1 * omega3 - omega2_2 + omega3_2);
}

/// Rows of the harmonic -omega1+omega3 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + omega3)*t) in v2 = 1/(omega1^2 - 2*omega1*omega3 - omega2^2 +
/// omega3^2)*a123*conj(A_v1)*A_v3
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
  const Scalar omega3_2 = omega3 * omega3;
  factor[0] = -Scalar(2.0) / (Scalar(2.0) * omega2 * omega3 - omega3_2);
}

/// Rows of the harmonic -omega2+omega3 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega2 + omega3)*t) in v2 = -2/(2*omega2*omega3 - omega3^2)*a223*conj(A_v2)*A_v3
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
  const Scalar omega3_2 = omega3 * omega3;
  factor[0] = Scalar(2.0) / (Scalar(2.0) * omega2 * omega3 + omega3_2);
}

/// Rows of the harmonic omega2+omega3 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + omega3)*t) in v2 = 2/(2*omega2*omega3 + omega3^2)*a223*A_v2*A_v3
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

/// What multiplies the 1 terms of the harmonic omega1+omega3 of v2: functions of the frequencies alone. 9
/// operations.
template <class Scalar>
void factors_21([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  factor[0] = Scalar(1.0) / (omega1_2 + Scalar(2.0) * omega1 * omega3 - omega2_2 + omega3_2);
}

/// Rows of the harmonic omega1+omega3 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + omega3)*t) in v2 = 1/(omega1^2 + 2*omega1*omega3 - omega2^2 +
/// omega3^2)*a123*A_v1*A_v3
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

/// What multiplies the 1 terms of the harmonic -2*omega1+omega2 of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_22([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic -2*omega1+omega2 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-2*omega1 + omega2)*t) in v2 = harmonic_re_v2_A_v2_conjA_v12*conj(A_v1)^2*A_v2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_22(const BatchArrays& data, Factors factors, double* const* columns) {
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
inline void columns_22(const BatchArrays& data, double* const* columns) {
  rows_22(data, FactorValues<factors_22<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_22(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
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

/// What multiplies the 1 terms of the harmonic -omega1+2*omega2 of v2: functions of the frequencies alone. 57
/// operations.
template <class Scalar>
void factors_24([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  factor[0] = (omega1_3 * omega3_2 - omega1_2 * omega2 * omega3_2 + Scalar(7.0) * omega1 * omega2_2 * omega3_2
      - Scalar(3.0) * omega1 * omega3_4 + Scalar(9.0) * omega2_3 * omega3_2
      - Scalar(3.0) * omega2 * omega3_4) / (Scalar(8.0) * omega1_3 * omega2_2 - Scalar(3.0) * omega1_3 * omega3_2
      - Scalar(40.0) * omega1_2 * omega2_3 + Scalar(15.0) * omega1_2 * omega2 * omega3_2
      + Scalar(56.0) * omega1 * omega2_4 - Scalar(29.0) * omega1 * omega2_2 * omega3_2
      + Scalar(3.0) * omega1 * omega3_4 - Scalar(24.0) * omega2_5 + Scalar(33.0) * omega2_3 * omega3_2
      - Scalar(9.0) * omega2 * omega3_4);
}

/// Rows of the harmonic -omega1+2*omega2 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + 2*omega2)*t) in v2 = (omega1^3*omega3^2 - omega1^2*omega2*omega3^2 +
/// 7*omega1*omega2^2*omega3^2 - 3*omega1*omega3^4 + 9*omega2^3*omega3^2 -
/// 3*omega2*omega3^4)/(8*omega1^3*omega2^2 - 3*omega1^3*omega3^2 - 40*omega1^2*omega2^3 +
/// 15*omega1^2*omega2*omega3^2 + 56*omega1*omega2^4 - 29*omega1*omega2^2*omega3^2 + 3*omega1*omega3^4 -
/// 24*omega2^5 + 33*omega2^3*omega3^2 - 9*omega2*omega3^4)*harmonic_re_v1_A_v22_conjA_v2*conj(A_v1)*A_v2^2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_24(const BatchArrays& data, Factors factors, double* const* columns) {
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
inline void columns_24(const BatchArrays& data, double* const* columns) {
  rows_24(data, FactorValues<factors_24<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_24(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_24(data, FactorSlopes<factors_24<DualNumber>, 3, 1, 1>{mode}, columns);
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

/// What multiplies the 1 terms of the harmonic 3*omega2 of v2: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_27([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic 3*omega2 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega2)*t) in v2 = harmonic_re_v2_A_v23*A_v2^3
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_27(const BatchArrays& data, Factors factors, double* const* columns) {
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
inline void columns_27(const BatchArrays& data, double* const* columns) {
  rows_27(data, FactorValues<factors_27<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_27(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 3 terms of the harmonic omega1 of v2: functions of the frequencies alone. 113 operations.
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
  factor[0] = (-Scalar(24.0) * omega1_5 + Scalar(56.0) * omega1_4 * omega2 - Scalar(40.0) * omega1_3 * omega2_2
      + Scalar(33.0) * omega1_3 * omega3_2 + Scalar(8.0) * omega1_2 * omega2_3
      - Scalar(29.0) * omega1_2 * omega2 * omega3_2 + Scalar(15.0) * omega1 * omega2_2 * omega3_2
      - Scalar(9.0) * omega1 * omega3_4 - Scalar(3.0) * omega2_3 * omega3_2
      + Scalar(3.0) * omega2 * omega3_4) / (Scalar(9.0) * omega1_3 * omega3_2
      + Scalar(7.0) * omega1_2 * omega2 * omega3_2 - omega1 * omega2_2 * omega3_2
      - Scalar(3.0) * omega1 * omega3_4 + omega2_3 * omega3_2 - Scalar(3.0) * omega2 * omega3_4);
  factor[1] = (-Scalar(8.0) * omega1_4 * omega2_2 + Scalar(2.0) * omega1_4 * omega3_2
      + Scalar(16.0) * omega1_2 * omega2_4 + Scalar(28.0) * omega1_2 * omega2_2 * omega3_2
      - Scalar(8.0) * omega1_2 * omega3_4 - Scalar(8.0) * omega2_6 + Scalar(34.0) * omega2_4 * omega3_2
      - Scalar(32.0) * omega2_2 * omega3_4 + Scalar(6.0) * omega3_6) / (Scalar(8.0) * omega1_4 * omega2_2
      - Scalar(3.0) * omega1_4 * omega3_2 - Scalar(16.0) * omega1_2 * omega2_4
      - Scalar(10.0) * omega1_2 * omega2_2 * omega3_2 + Scalar(6.0) * omega1_2 * omega3_4 + Scalar(8.0) * omega2_6
      - Scalar(19.0) * omega2_4 * omega3_2 + Scalar(14.0) * omega2_2 * omega3_4 - Scalar(3.0) * omega3_6);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega1 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1)*t) in v2 = (-24*omega1^5 + 56*omega1^4*omega2 - 40*omega1^3*omega2^2 +
/// 33*omega1^3*omega3^2 + 8*omega1^2*omega2^3 - 29*omega1^2*omega2*omega3^2 + 15*omega1*omega2^2*omega3^2 -
/// 9*omega1*omega3^4 - 3*omega2^3*omega3^2 + 3*omega2*omega3^4)/(9*omega1^3*omega3^2 +
/// 7*omega1^2*omega2*omega3^2 - omega1*omega2^2*omega3^2 - 3*omega1*omega3^4 + omega2^3*omega3^2 -
/// 3*omega2*omega3^4)*harmonic_re_v1_A_v2_conjA_v12*A_v1^2*conj(A_v1) + (-8*omega1^4*omega2^2 +
/// 2*omega1^4*omega3^2 + 16*omega1^2*omega2^4 + 28*omega1^2*omega2^2*omega3^2 - 8*omega1^2*omega3^4 - 8*omega2^6
/// + 34*omega2^4*omega3^2 - 32*omega2^2*omega3^4 + 6*omega3^6)/(8*omega1^4*omega2^2 - 3*omega1^4*omega3^2 -
/// 16*omega1^2*omega2^4 - 10*omega1^2*omega2^2*omega3^2 + 6*omega1^2*omega3^4 + 8*omega2^6 -
/// 19*omega2^4*omega3^2 + 14*omega2^2*omega3^4 - 3*omega3^6)*harmonic_re_v1_A_v22_conjA_v2*A_v1*A_v2*conj(A_v2)
/// + harmonic_re_v2_A_v1_A_v3_conjA_v3*A_v1*A_v3*conj(A_v3)
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

/// What multiplies the 1 terms of the harmonic omega1+2*omega2 of v2: functions of the frequencies alone. 57
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
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  const Scalar omega3_3 = omega3_2 * omega3;
  const Scalar omega3_4 = omega3_3 * omega3;
  factor[0] = (omega1_3 * omega3_2 + omega1_2 * omega2 * omega3_2 + Scalar(7.0) * omega1 * omega2_2 * omega3_2
      - Scalar(3.0) * omega1 * omega3_4 - Scalar(9.0) * omega2_3 * omega3_2
      + Scalar(3.0) * omega2 * omega3_4) / (Scalar(8.0) * omega1_3 * omega2_2 - Scalar(3.0) * omega1_3 * omega3_2
      + Scalar(40.0) * omega1_2 * omega2_3 - Scalar(15.0) * omega1_2 * omega2 * omega3_2
      + Scalar(56.0) * omega1 * omega2_4 - Scalar(29.0) * omega1 * omega2_2 * omega3_2
      + Scalar(3.0) * omega1 * omega3_4 + Scalar(24.0) * omega2_5 - Scalar(33.0) * omega2_3 * omega3_2
      + Scalar(9.0) * omega2 * omega3_4);
}

/// Rows of the harmonic omega1+2*omega2 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + 2*omega2)*t) in v2 = (omega1^3*omega3^2 + omega1^2*omega2*omega3^2 +
/// 7*omega1*omega2^2*omega3^2 - 3*omega1*omega3^4 - 9*omega2^3*omega3^2 +
/// 3*omega2*omega3^4)/(8*omega1^3*omega2^2 - 3*omega1^3*omega3^2 + 40*omega1^2*omega2^3 -
/// 15*omega1^2*omega2*omega3^2 + 56*omega1*omega2^4 - 29*omega1*omega2^2*omega3^2 + 3*omega1*omega3^4 +
/// 24*omega2^5 - 33*omega2^3*omega3^2 + 9*omega2*omega3^4)*harmonic_re_v1_A_v22_conjA_v2*A_v1*A_v2^2
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

/// What multiplies the 1 terms of the harmonic 3*omega1 of v2: functions of the frequencies alone. 30
/// operations.
template <class Scalar>
void factors_32([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  factor[0] = (omega1_3 - Scalar(3.0) * omega1_2 * omega2 + Scalar(3.0) * omega1 * omega2_2 - omega1 * omega3_2
      - omega2_3 + omega2 * omega3_2) / (Scalar(27.0) * omega1_3 + Scalar(3.0) * omega1_2 * omega2
      + omega1 * omega2_2 - Scalar(9.0) * omega1 * omega3_2 + omega2_3 - Scalar(3.0) * omega2 * omega3_2);
}

/// Rows of the harmonic 3*omega1 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega1)*t) in v2 = (omega1^3 - 3*omega1^2*omega2 + 3*omega1*omega2^2 - omega1*omega3^2
/// - omega2^3 + omega2*omega3^2)/(27*omega1^3 + 3*omega1^2*omega2 + omega1*omega2^2 - 9*omega1*omega3^2 +
/// omega2^3 - 3*omega2*omega3^2)*harmonic_re_v1_A_v2_conjA_v12*A_v1^3
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_32(const BatchArrays& data, Factors factors, double* const* columns) {
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
inline void columns_32(const BatchArrays& data, double* const* columns) {
  rows_32(data, FactorValues<factors_32<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_32(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_32(data, FactorSlopes<factors_32<DualNumber>, 3, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic -omega1+omega2 of v3: functions of the frequencies alone. 9
/// operations.
template <class Scalar>
void factors_33([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  factor[0] = Scalar(1.0) / (omega1_2 - Scalar(2.0) * omega1 * omega2 + omega2_2 - omega3_2);
}

/// Rows of the harmonic -omega1+omega2 of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + omega2)*t) in v3 = 1/(omega1^2 - 2*omega1*omega2 + omega2^2 -
/// omega3^2)*a123*conj(A_v1)*A_v2
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_33(const BatchArrays& data, Factors factors, double* const* columns) {
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
inline void columns_33(const BatchArrays& data, double* const* columns) {
  rows_33(data, FactorValues<factors_33<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_33(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_33(data, FactorSlopes<factors_33<DualNumber>, 3, 1, 1>{mode}, columns);
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

/// What multiplies the 1 terms of the harmonic 2*omega2 of v3: functions of the frequencies alone. 5 operations.
template <class Scalar>
void factors_36([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  factor[0] = Scalar(1.0) / (Scalar(4.0) * omega2_2 - omega3_2);
}

/// Rows of the harmonic 2*omega2 of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega2)*t) in v3 = 1/(4*omega2^2 - omega3^2)*a223*A_v2^2
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_36(const BatchArrays& data, Factors factors, double* const* columns) {
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
inline void columns_36(const BatchArrays& data, double* const* columns) {
  rows_36(data, FactorValues<factors_36<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_36(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_36(data, FactorSlopes<factors_36<DualNumber>, 3, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic omega1+omega2 of v3: functions of the frequencies alone. 9
/// operations.
template <class Scalar>
void factors_37([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega3_2 = omega3 * omega3;
  factor[0] = Scalar(1.0) / (omega1_2 + Scalar(2.0) * omega1 * omega2 + omega2_2 - omega3_2);
}

/// Rows of the harmonic omega1+omega2 of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + omega2)*t) in v3 = 1/(omega1^2 + 2*omega1*omega2 + omega2^2 -
/// omega3^2)*a123*A_v1*A_v2
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

/// What multiplies the 1 terms of the harmonic 2*omega1 of v3: functions of the frequencies alone. 5 operations.
template <class Scalar>
void factors_38([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega3 = natural_frequency[2];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega3_2 = omega3 * omega3;
  factor[0] = Scalar(1.0) / (Scalar(4.0) * omega1_2 - omega3_2);
}

/// Rows of the harmonic 2*omega1 of v3: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega1)*t) in v3 = 1/(4*omega1^2 - omega3^2)*a113*A_v1^2
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_38(const BatchArrays& data, Factors factors, double* const* columns) {
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
inline void columns_38(const BatchArrays& data, double* const* columns) {
  rows_38(data, FactorValues<factors_38<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_38(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_38(data, FactorSlopes<factors_38<DualNumber>, 3, 1, 1>{mode}, columns);
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
