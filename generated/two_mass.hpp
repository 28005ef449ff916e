// Model two_mass: generated code, never edited by hand.
// Source: S. O'F. Fahey, dissertation, Virginia Tech, 2000, Eqs. (6.1)-(6.2)
// Equation of motion: 0 = omega1^2*v1 + 2*delta32*v1*D(v1)*D(v2) + delta31*v1*D(v1)^2 + 2*delta21*v1*D2(v1) +
// 2*delta32*v1*v2*D2(v1) + 2*alpha22*v1*v2 + alpha33*v1*v2^2 - delta34*v1*D(v2)^2 - eta12*v1*F*cos(Omega*t) +
// alpha21*v1^2 + delta31*v1^2*D2(v1) + 3*alpha32*v1^2*v2 + alpha31*v1^3 + 2*mu11*D(v1) +
// 2*delta33*D(v1)*v2*D(v2) + 2*delta22*D(v1)*D(v2) + delta21*D(v1)^2 + delta32*D(v1)^2*v2 + mu13*D(v1)^3 +
// D2(v1) + 2*delta22*v2*D2(v1) + delta33*v2^2*D2(v1) - delta35*v2*D(v2)^2 + alpha23*v2^2 + alpha34*v2^3 +
// mu12*D(v2) - delta23*D(v2)^2 - eta11*F*cos(Omega*t)
// Equation of motion: 0 = 2*delta34*v1*D(v1)*D(v2) - delta32*v1*D(v1)^2 + 2*alpha23*v1*v2 +
// 2*delta35*v1*v2*D2(v2) + 3*alpha34*v1*v2^2 + delta35*v1*D(v2)^2 + 2*delta23*v1*D2(v2) + alpha22*v1^2 +
// alpha33*v1^2*v2 + delta34*v1^2*D2(v2) + alpha32*v1^3 + mu21*D(v1) + 2*delta35*D(v1)*v2*D(v2) +
// 2*delta23*D(v1)*D(v2) - delta22*D(v1)^2 - delta33*D(v1)^2*v2 + omega2^2*v2 + delta36*v2*D(v2)^2 +
// 2*delta24*v2*D2(v2) - eta22*v2*F*cos(Omega*t) + alpha24*v2^2 + delta36*v2^2*D2(v2) + alpha35*v2^3 +
// 2*mu22*D(v2) + delta24*D(v2)^2 + mu23*D(v2)^3 + D2(v2) - eta21*F*cos(Omega*t)
// Case primary_1: Omega = omega1 + eps^2*sigma, multiple scales to eps^2. Valid near that resonance for small
// amplitudes; what is left out is of order eps^3.
// Case primary_2: Omega = omega2 + eps^2*sigma, multiple scales to eps^2. Valid near that resonance for small
// amplitudes; what is left out is of order eps^3.
// Case principal_parametric_1: Omega = 2*omega1 + eps^2*sigma, multiple scales to eps^2. Valid near that
// resonance for small amplitudes; what is left out is of order eps^3.
// Case principal_parametric_2: Omega = 2*omega2 + eps^2*sigma, multiple scales to eps^2. Valid near that
// resonance for small amplitudes; what is left out is of order eps^3.
// Case additive_combination: Omega = omega1 + omega2 + eps^2*sigma, multiple scales to eps^2. Valid near that
// resonance for small amplitudes; what is left out is of order eps^3.
// Case free: free vibration, multiple scales to eps^2. Valid near that resonance for small amplitudes; what is
// left out is of order eps^3.
// Case free_1: free vibration, multiple scales to eps^2. Valid near that resonance for small amplitudes; what
// is left out is of order eps^3.
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// Made by: secular generate two_mass
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

namespace secular::generated::two_mass {

/// Mass matrix M of the equations of motion M*acceleration + force = 0 below, state-dependent: mass[k * 2 + j]
/// multiplies the acceleration of mode j in equation k. 32 operations.
template <class Scalar, class Parameter, class Sample>
void mass_matrix([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* mass) {
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar delta31 = parameters[15];
  const Scalar delta32 = parameters[16];
  const Scalar delta33 = parameters[17];
  const Scalar delta34 = parameters[18];
  const Scalar delta35 = parameters[19];
  const Scalar delta24 = parameters[26];
  const Scalar delta36 = parameters[28];
  mass[0] = Scalar(2.0) * delta21 * displacement[0] + Scalar(2.0) * delta32 * displacement[0] * displacement[1]
      + delta31 * displacement[0] * displacement[0] + Scalar(1.0) + Scalar(2.0) * delta22 * displacement[1]
      + delta33 * displacement[1] * displacement[1];
  mass[1] = Scalar(0.0);
  mass[2] = Scalar(0.0);
  mass[3] = Scalar(2.0) * delta35 * displacement[0] * displacement[1] + Scalar(2.0) * delta23 * displacement[0]
      + delta34 * displacement[0] * displacement[0] + Scalar(2.0) * delta24 * displacement[1]
      + delta36 * displacement[1] * displacement[1] + Scalar(1.0);
}

/// Accelerations of the full equations of motion, solved from the state-dependent mass matrix.
/// 0 = omega1^2*v1 + 2*delta32*v1*D(v1)*D(v2) + delta31*v1*D(v1)^2 + 2*delta21*v1*D2(v1) +
/// 2*delta32*v1*v2*D2(v1) + 2*alpha22*v1*v2 + alpha33*v1*v2^2 - delta34*v1*D(v2)^2 - eta12*v1*F*cos(Omega*t) +
/// alpha21*v1^2 + delta31*v1^2*D2(v1) + 3*alpha32*v1^2*v2 + alpha31*v1^3 + 2*mu11*D(v1) +
/// 2*delta33*D(v1)*v2*D(v2) + 2*delta22*D(v1)*D(v2) + delta21*D(v1)^2 + delta32*D(v1)^2*v2 + mu13*D(v1)^3 +
/// D2(v1) + 2*delta22*v2*D2(v1) + delta33*v2^2*D2(v1) - delta35*v2*D(v2)^2 + alpha23*v2^2 + alpha34*v2^3 +
/// mu12*D(v2) - delta23*D(v2)^2 - eta11*F*cos(Omega*t)
/// 0 = 2*delta34*v1*D(v1)*D(v2) - delta32*v1*D(v1)^2 + 2*alpha23*v1*v2 + 2*delta35*v1*v2*D2(v2) +
/// 3*alpha34*v1*v2^2 + delta35*v1*D(v2)^2 + 2*delta23*v1*D2(v2) + alpha22*v1^2 + alpha33*v1^2*v2 +
/// delta34*v1^2*D2(v2) + alpha32*v1^3 + mu21*D(v1) + 2*delta35*D(v1)*v2*D(v2) + 2*delta23*D(v1)*D(v2) -
/// delta22*D(v1)^2 - delta33*D(v1)^2*v2 + omega2^2*v2 + delta36*v2*D(v2)^2 + 2*delta24*v2*D2(v2) -
/// eta22*v2*F*cos(Omega*t) + alpha24*v2^2 + delta36*v2^2*D2(v2) + alpha35*v2^3 + 2*mu22*D(v2) + delta24*D(v2)^2
/// + mu23*D(v2)^3 + D2(v2) - eta21*F*cos(Omega*t)
/// parameters: [0] omega1, [1] omega2, [2] mu11, [3] mu12, [4] mu13, [5] alpha21, [6] alpha22, [7] alpha23, [8]
/// delta21, [9] delta22, [10] delta23, [11] alpha31, [12] alpha32, [13] alpha33, [14] alpha34, [15] delta31,
/// [16] delta32, [17] delta33, [18] delta34, [19] delta35, [20] eta11, [21] eta12, [22] mu22, [23] mu21, [24]
/// mu23, [25] alpha24, [26] delta24, [27] alpha35, [28] delta36, [29] eta21, [30] eta22. displacement, velocity,
/// acceleration: 2 values. 158 operations.
template <class Scalar, class Parameter, class Sample>
void accelerations([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* acceleration) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu11 = parameters[2];
  const Scalar mu12 = parameters[3];
  const Scalar mu13 = parameters[4];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar alpha31 = parameters[11];
  const Scalar alpha32 = parameters[12];
  const Scalar alpha33 = parameters[13];
  const Scalar alpha34 = parameters[14];
  const Scalar delta31 = parameters[15];
  const Scalar delta32 = parameters[16];
  const Scalar delta33 = parameters[17];
  const Scalar delta34 = parameters[18];
  const Scalar delta35 = parameters[19];
  const Scalar eta11 = parameters[20];
  const Scalar eta12 = parameters[21];
  const Scalar mu22 = parameters[22];
  const Scalar mu21 = parameters[23];
  const Scalar mu23 = parameters[24];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar alpha35 = parameters[27];
  const Scalar delta36 = parameters[28];
  const Scalar eta21 = parameters[29];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  acceleration[0] = -(omega1_2 * displacement[0]
      + Scalar(2.0) * delta32 * displacement[0] * velocity[0] * velocity[1]
      + delta31 * displacement[0] * velocity[0] * velocity[0]
      + Scalar(2.0) * alpha22 * displacement[0] * displacement[1]
      + alpha33 * displacement[0] * displacement[1] * displacement[1]
      - delta34 * displacement[0] * velocity[1] * velocity[1]
      - eta12 * displacement[0] * Scalar(excitation[0].value) + alpha21 * displacement[0] * displacement[0]
      + Scalar(3.0) * alpha32 * displacement[0] * displacement[0] * displacement[1]
      + alpha31 * displacement[0] * displacement[0] * displacement[0] + Scalar(2.0) * mu11 * velocity[0]
      + Scalar(2.0) * delta33 * velocity[0] * displacement[1] * velocity[1]
      + Scalar(2.0) * delta22 * velocity[0] * velocity[1] + delta21 * velocity[0] * velocity[0]
      + delta32 * velocity[0] * velocity[0] * displacement[1] + mu13 * velocity[0] * velocity[0] * velocity[0]
      - delta35 * displacement[1] * velocity[1] * velocity[1] + alpha23 * displacement[1] * displacement[1]
      + alpha34 * displacement[1] * displacement[1] * displacement[1] + mu12 * velocity[1]
      - delta23 * velocity[1] * velocity[1] - eta11 * Scalar(excitation[0].value));
  acceleration[1] = -(Scalar(2.0) * delta34 * displacement[0] * velocity[0] * velocity[1]
      - delta32 * displacement[0] * velocity[0] * velocity[0]
      + Scalar(2.0) * alpha23 * displacement[0] * displacement[1]
      + Scalar(3.0) * alpha34 * displacement[0] * displacement[1] * displacement[1]
      + delta35 * displacement[0] * velocity[1] * velocity[1] + alpha22 * displacement[0] * displacement[0]
      + alpha33 * displacement[0] * displacement[0] * displacement[1]
      + alpha32 * displacement[0] * displacement[0] * displacement[0] + mu21 * velocity[0]
      + Scalar(2.0) * delta35 * velocity[0] * displacement[1] * velocity[1]
      + Scalar(2.0) * delta23 * velocity[0] * velocity[1] - delta22 * velocity[0] * velocity[0]
      - delta33 * velocity[0] * velocity[0] * displacement[1] + omega2_2 * displacement[1]
      + delta36 * displacement[1] * velocity[1] * velocity[1]
      - eta22 * displacement[1] * Scalar(excitation[0].value) + alpha24 * displacement[1] * displacement[1]
      + alpha35 * displacement[1] * displacement[1] * displacement[1] + Scalar(2.0) * mu22 * velocity[1]
      + delta24 * velocity[1] * velocity[1] + mu23 * velocity[1] * velocity[1] * velocity[1]
      - eta21 * Scalar(excitation[0].value));
  Scalar mass[4];
  mass_matrix(parameters, excitation, displacement, velocity, mass);
  acceleration[0] = acceleration[0] / mass[0];
  acceleration[1] = acceleration[1] / mass[3];
}

/// slope[k * 4 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = v1, v2, D(v1),
/// D(v2). Of nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x) = 0.
/// 258 operations before the solution of 4 right sides.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_state([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  Scalar acceleration[2];
  accelerations(parameters, excitation, displacement, velocity, acceleration);
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu11 = parameters[2];
  const Scalar mu12 = parameters[3];
  const Scalar mu13 = parameters[4];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar alpha31 = parameters[11];
  const Scalar alpha32 = parameters[12];
  const Scalar alpha33 = parameters[13];
  const Scalar alpha34 = parameters[14];
  const Scalar delta31 = parameters[15];
  const Scalar delta32 = parameters[16];
  const Scalar delta33 = parameters[17];
  const Scalar delta34 = parameters[18];
  const Scalar delta35 = parameters[19];
  const Scalar eta12 = parameters[21];
  const Scalar mu22 = parameters[22];
  const Scalar mu21 = parameters[23];
  const Scalar mu23 = parameters[24];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar alpha35 = parameters[27];
  const Scalar delta36 = parameters[28];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  for (std::size_t i = 0; i < 8; ++i) slope[i] = Scalar(0.0);
  // equation 1 by v1
  slope[0] = -(omega1_2 + Scalar(2.0) * delta32 * velocity[0] * velocity[1] + delta31 * velocity[0] * velocity[0]
      + Scalar(2.0) * delta21 * acceleration[0] + Scalar(2.0) * delta32 * displacement[1] * acceleration[0]
      + Scalar(2.0) * alpha22 * displacement[1] + alpha33 * displacement[1] * displacement[1]
      - delta34 * velocity[1] * velocity[1] - eta12 * Scalar(excitation[0].value)
      + alpha21 * displacement[0] * Scalar(2.0) + delta31 * displacement[0] * Scalar(2.0) * acceleration[0]
      + Scalar(3.0) * alpha32 * displacement[0] * displacement[1] * Scalar(2.0)
      + alpha31 * displacement[0] * displacement[0] * Scalar(3.0));
  // equation 1 by v2
  slope[1] = -(Scalar(2.0) * delta32 * displacement[0] * acceleration[0] + Scalar(2.0) * alpha22 * displacement[0]
      + alpha33 * displacement[0] * displacement[1] * Scalar(2.0)
      + Scalar(3.0) * alpha32 * displacement[0] * displacement[0]
      + Scalar(2.0) * delta33 * velocity[0] * velocity[1] + delta32 * velocity[0] * velocity[0]
      + Scalar(2.0) * delta22 * acceleration[0] + delta33 * displacement[1] * Scalar(2.0) * acceleration[0]
      - delta35 * velocity[1] * velocity[1] + alpha23 * displacement[1] * Scalar(2.0)
      + alpha34 * displacement[1] * displacement[1] * Scalar(3.0));
  // equation 1 by D(v1)
  slope[2] = -(Scalar(2.0) * delta32 * displacement[0] * velocity[1]
      + delta31 * displacement[0] * velocity[0] * Scalar(2.0) + Scalar(2.0) * mu11
      + Scalar(2.0) * delta33 * displacement[1] * velocity[1] + Scalar(2.0) * delta22 * velocity[1]
      + delta21 * velocity[0] * Scalar(2.0) + delta32 * velocity[0] * displacement[1] * Scalar(2.0)
      + mu13 * velocity[0] * velocity[0] * Scalar(3.0));
  // equation 1 by D(v2)
  slope[3] = -(Scalar(2.0) * delta32 * displacement[0] * velocity[0]
      - delta34 * displacement[0] * velocity[1] * Scalar(2.0)
      + Scalar(2.0) * delta33 * velocity[0] * displacement[1] + Scalar(2.0) * delta22 * velocity[0]
      - delta35 * displacement[1] * velocity[1] * Scalar(2.0) + mu12 - delta23 * velocity[1] * Scalar(2.0));
  // equation 2 by v1
  slope[4] = -(Scalar(2.0) * delta34 * velocity[0] * velocity[1] - delta32 * velocity[0] * velocity[0]
      + Scalar(2.0) * alpha23 * displacement[1] + Scalar(2.0) * delta35 * displacement[1] * acceleration[1]
      + Scalar(3.0) * alpha34 * displacement[1] * displacement[1] + delta35 * velocity[1] * velocity[1]
      + Scalar(2.0) * delta23 * acceleration[1] + alpha22 * displacement[0] * Scalar(2.0)
      + alpha33 * displacement[0] * displacement[1] * Scalar(2.0)
      + delta34 * displacement[0] * Scalar(2.0) * acceleration[1]
      + alpha32 * displacement[0] * displacement[0] * Scalar(3.0));
  // equation 2 by v2
  slope[5] = -(Scalar(2.0) * alpha23 * displacement[0] + Scalar(2.0) * delta35 * displacement[0] * acceleration[1]
      + Scalar(3.0) * alpha34 * displacement[0] * displacement[1] * Scalar(2.0)
      + alpha33 * displacement[0] * displacement[0] + Scalar(2.0) * delta35 * velocity[0] * velocity[1]
      - delta33 * velocity[0] * velocity[0] + omega2_2 + delta36 * velocity[1] * velocity[1]
      + Scalar(2.0) * delta24 * acceleration[1] - eta22 * Scalar(excitation[0].value)
      + alpha24 * displacement[1] * Scalar(2.0) + delta36 * displacement[1] * Scalar(2.0) * acceleration[1]
      + alpha35 * displacement[1] * displacement[1] * Scalar(3.0));
  // equation 2 by D(v1)
  slope[6] = -(Scalar(2.0) * delta34 * displacement[0] * velocity[1]
      - delta32 * displacement[0] * velocity[0] * Scalar(2.0) + mu21
      + Scalar(2.0) * delta35 * displacement[1] * velocity[1] + Scalar(2.0) * delta23 * velocity[1]
      - delta22 * velocity[0] * Scalar(2.0) - delta33 * velocity[0] * displacement[1] * Scalar(2.0));
  // equation 2 by D(v2)
  slope[7] = -(Scalar(2.0) * delta34 * displacement[0] * velocity[0]
      + delta35 * displacement[0] * velocity[1] * Scalar(2.0)
      + Scalar(2.0) * delta35 * velocity[0] * displacement[1] + Scalar(2.0) * delta23 * velocity[0]
      + delta36 * displacement[1] * velocity[1] * Scalar(2.0) + Scalar(2.0) * mu22
      + delta24 * velocity[1] * Scalar(2.0) + mu23 * velocity[1] * velocity[1] * Scalar(3.0));
  Scalar mass[4];
  mass_matrix(parameters, excitation, displacement, velocity, mass);
  for (std::size_t i = 0; i < 4; ++i) slope[i] = slope[i] / mass[0];
  for (std::size_t i = 4; i < 8; ++i) slope[i] = slope[i] / mass[3];
}

/// slope[k * 31 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = omega1, omega2,
/// mu11, mu12, mu13, alpha21, alpha22, alpha23, delta21, delta22, delta23, alpha31, alpha32, alpha33, alpha34,
/// delta31, delta32, delta33, delta34, delta35, eta11, eta12, mu22, mu21, mu23, alpha24, delta24, alpha35,
/// delta36, eta21, eta22. Of nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and
/// d sgn(x) = 0. 118 operations before the solution of 31 right sides.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_parameters([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  Scalar acceleration[2];
  accelerations(parameters, excitation, displacement, velocity, acceleration);
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  for (std::size_t i = 0; i < 62; ++i) slope[i] = Scalar(0.0);
  slope[0] = -(Scalar(2.0) * omega1 * displacement[0]);  // equation 1 by omega1
  slope[2] = -(Scalar(2.0) * velocity[0]);  // equation 1 by mu11
  slope[3] = -(velocity[1]);  // equation 1 by mu12
  slope[4] = -(velocity[0] * velocity[0] * velocity[0]);  // equation 1 by mu13
  slope[5] = -(displacement[0] * displacement[0]);  // equation 1 by alpha21
  slope[6] = -(Scalar(2.0) * displacement[0] * displacement[1]);  // equation 1 by alpha22
  slope[7] = -(displacement[1] * displacement[1]);  // equation 1 by alpha23
  // equation 1 by delta21
  slope[8] = -(Scalar(2.0) * displacement[0] * acceleration[0] + velocity[0] * velocity[0]);
  // equation 1 by delta22
  slope[9] = -(Scalar(2.0) * velocity[0] * velocity[1] + Scalar(2.0) * displacement[1] * acceleration[0]);
  slope[10] = -(-Scalar(1.0) * velocity[1] * velocity[1]);  // equation 1 by delta23
  slope[11] = -(displacement[0] * displacement[0] * displacement[0]);  // equation 1 by alpha31
  slope[12] = -(Scalar(3.0) * displacement[0] * displacement[0] * displacement[1]);  // equation 1 by alpha32
  slope[13] = -(displacement[0] * displacement[1] * displacement[1]);  // equation 1 by alpha33
  slope[14] = -(displacement[1] * displacement[1] * displacement[1]);  // equation 1 by alpha34
  // equation 1 by delta31
  slope[15] = -(displacement[0] * velocity[0] * velocity[0] + displacement[0] * displacement[0] * acceleration[0]);
  // equation 1 by delta32
  slope[16] = -(Scalar(2.0) * displacement[0] * velocity[0] * velocity[1]
      + Scalar(2.0) * displacement[0] * displacement[1] * acceleration[0]
      + velocity[0] * velocity[0] * displacement[1]);
  // equation 1 by delta33
  slope[17] = -(Scalar(2.0) * velocity[0] * displacement[1] * velocity[1]
      + displacement[1] * displacement[1] * acceleration[0]);
  slope[18] = -(-Scalar(1.0) * displacement[0] * velocity[1] * velocity[1]);  // equation 1 by delta34
  slope[19] = -(-Scalar(1.0) * displacement[1] * velocity[1] * velocity[1]);  // equation 1 by delta35
  slope[20] = -(-Scalar(1.0) * Scalar(excitation[0].value));  // equation 1 by eta11
  slope[21] = -(-Scalar(1.0) * displacement[0] * Scalar(excitation[0].value));  // equation 1 by eta12
  slope[32] = -(Scalar(2.0) * omega2 * displacement[1]);  // equation 2 by omega2
  slope[37] = -(displacement[0] * displacement[0]);  // equation 2 by alpha22
  slope[38] = -(Scalar(2.0) * displacement[0] * displacement[1]);  // equation 2 by alpha23
  slope[40] = -(-Scalar(1.0) * velocity[0] * velocity[0]);  // equation 2 by delta22
  // equation 2 by delta23
  slope[41] = -(Scalar(2.0) * displacement[0] * acceleration[1] + Scalar(2.0) * velocity[0] * velocity[1]);
  slope[43] = -(displacement[0] * displacement[0] * displacement[0]);  // equation 2 by alpha32
  slope[44] = -(displacement[0] * displacement[0] * displacement[1]);  // equation 2 by alpha33
  slope[45] = -(Scalar(3.0) * displacement[0] * displacement[1] * displacement[1]);  // equation 2 by alpha34
  slope[47] = -(-Scalar(1.0) * displacement[0] * velocity[0] * velocity[0]);  // equation 2 by delta32
  slope[48] = -(-Scalar(1.0) * velocity[0] * velocity[0] * displacement[1]);  // equation 2 by delta33
  // equation 2 by delta34
  slope[49] = -(Scalar(2.0) * displacement[0] * velocity[0] * velocity[1]
      + displacement[0] * displacement[0] * acceleration[1]);
  // equation 2 by delta35
  slope[50] = -(Scalar(2.0) * displacement[0] * displacement[1] * acceleration[1]
      + displacement[0] * velocity[1] * velocity[1] + Scalar(2.0) * velocity[0] * displacement[1] * velocity[1]);
  slope[53] = -(Scalar(2.0) * velocity[1]);  // equation 2 by mu22
  slope[54] = -(velocity[0]);  // equation 2 by mu21
  slope[55] = -(velocity[1] * velocity[1] * velocity[1]);  // equation 2 by mu23
  slope[56] = -(displacement[1] * displacement[1]);  // equation 2 by alpha24
  // equation 2 by delta24
  slope[57] = -(Scalar(2.0) * displacement[1] * acceleration[1] + velocity[1] * velocity[1]);
  slope[58] = -(displacement[1] * displacement[1] * displacement[1]);  // equation 2 by alpha35
  // equation 2 by delta36
  slope[59] = -(displacement[1] * velocity[1] * velocity[1] + displacement[1] * displacement[1] * acceleration[1]);
  slope[60] = -(-Scalar(1.0) * Scalar(excitation[0].value));  // equation 2 by eta21
  slope[61] = -(-Scalar(1.0) * displacement[1] * Scalar(excitation[0].value));  // equation 2 by eta22
  Scalar mass[4];
  mass_matrix(parameters, excitation, displacement, velocity, mass);
  for (std::size_t i = 0; i < 31; ++i) slope[i] = slope[i] / mass[0];
  for (std::size_t i = 31; i < 62; ++i) slope[i] = slope[i] / mass[3];
}

/// conservative_v1_A_v1 = -omega1*mu12*mu21/(2*(omega1 + omega2)*(omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 12 operations.
template <class Scalar>
Scalar lump_0(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu12 = parameters[3];
  const Scalar mu21 = parameters[23];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -omega1 * mu12 * mu21 * per_0 * per_1 / Scalar(2.0);
  const Scalar value = f_0;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_0 * per_0;
  const Scalar q_1 = f_0 * per_1;
  gradient[0] = f_0 / omega1 - q_0 - q_1;  // by omega1
  gradient[1] = -q_0 + q_1;  // by omega2
  const Scalar c_0 = -omega1 * per_0 * per_1 / Scalar(2.0);  // multiplies mu12*mu21
  gradient[3] = mu21 * c_0;  // by mu12
  gradient[23] = mu12 * c_0;  // by mu21
  return value;
}

/// conservative_v1_A_v1_A_v2_conjA_v2 = (-2*omega1^4*omega2^2*delta22*delta24 - omega1^4*omega2^2*delta33 +
/// 2*omega1^4*delta22*alpha24 - 2*omega1^2*omega2^4*delta21*delta23 - omega1^2*omega2^4*delta34 +
/// 2*omega1^2*omega2^2*alpha22*delta24 + 2*omega1^2*omega2^2*alpha23*delta21 + omega1^2*omega2^2*alpha33 -
/// 2*omega1^2*alpha22*alpha24 + 2*omega2^4*alpha21*delta23 - 2*omega2^2*alpha21*alpha23)/(omega1^3*omega2^2) +
/// (4*omega1^2*omega2^2*delta23^2 - 12*omega2^4*delta23^2 + 8*omega2^2*alpha23*delta23 +
/// 4*alpha23^2)/(omega1*(omega1 + 2*omega2)*(omega1 - 2*omega2)) + (12*omega1^4*delta22^2 -
/// 4*omega1^2*omega2^2*delta22^2 - 8*omega1^2*alpha22*delta22 - 4*alpha22^2)/(omega1*(2*omega1 +
/// omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 127 operations.
template <class Scalar>
Scalar lump_1(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar alpha33 = parameters[13];
  const Scalar delta33 = parameters[17];
  const Scalar delta34 = parameters[18];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar alpha22_2 = alpha22 * alpha22;
  const Scalar alpha23_2 = alpha23 * alpha23;
  const Scalar delta22_2 = delta22 * delta22;
  const Scalar delta23_2 = delta23 * delta23;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = -Scalar(2.0) * omega1 * delta22 * delta24 - omega1 * delta33;
  const Scalar f_1 = Scalar(2.0) * omega1 * delta22 * alpha24 / omega2_2;
  const Scalar f_2 = (-Scalar(2.0) * omega2_2 * delta21 * delta23 - omega2_2 * delta34) / omega1;
  const Scalar f_3 = (Scalar(2.0) * alpha22 * delta24 + Scalar(2.0) * alpha23 * delta21 + alpha33) / omega1;
  const Scalar f_4 = -Scalar(2.0) * alpha22 * alpha24 / (omega1 * omega2_2);
  const Scalar f_5 = Scalar(2.0) * omega2_2 * alpha21 * delta23 / omega1_3;
  const Scalar f_6 = -Scalar(2.0) * alpha21 * alpha23 / omega1_3;
  const Scalar f_7 = Scalar(4.0) * omega1 * omega2_2 * delta23_2 * per_0 * per_1;
  const Scalar f_8 = -Scalar(12.0) * omega2_4 * delta23_2 * per_0 * per_1 / omega1;
  const Scalar f_9 = Scalar(8.0) * omega2_2 * alpha23 * delta23 * per_0 * per_1 / omega1;
  const Scalar f_10 = Scalar(4.0) * alpha23_2 * per_0 * per_1 / omega1;
  const Scalar f_11 = Scalar(12.0) * omega1_3 * delta22_2 * per_2 * per_3;
  const Scalar f_12 = -Scalar(4.0) * omega1 * omega2_2 * delta22_2 * per_2 * per_3;
  const Scalar f_13 = -Scalar(8.0) * omega1 * alpha22 * delta22 * per_2 * per_3;
  const Scalar f_14 = -Scalar(4.0) * alpha22_2 * per_2 * per_3 / omega1;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_7 + f_8 + f_9 + f_10) * per_0;
  const Scalar q_1 = (f_7 + f_8 + f_9 + f_10) * per_1;
  const Scalar q_2 = (f_11 + f_12 + f_13 + f_14) * per_2;
  const Scalar q_3 = (f_11 + f_12 + f_13 + f_14) * per_3;
  // by omega1
  gradient[0] = (f_0 + f_1 - f_2 - f_3 - f_4 - Scalar(3.0) * f_5 - Scalar(3.0) * f_6 + f_7 - f_8 - f_9 - f_10
      + Scalar(3.0) * f_11 + f_12 + f_13 - f_14) / omega1 - q_0 - q_1 - Scalar(2.0) * q_2 - Scalar(2.0) * q_3;
  // by omega2
  gradient[1] = (-Scalar(2.0) * f_1 + Scalar(2.0) * f_2 - Scalar(2.0) * f_4 + Scalar(2.0) * f_5 + Scalar(2.0) * f_7
      + Scalar(4.0) * f_8 + Scalar(2.0) * f_9 + Scalar(2.0) * f_12) / omega2 - Scalar(2.0) * q_0 + Scalar(2.0) * q_1
      - q_2 + q_3;
  const Scalar c_0 = -Scalar(2.0) / omega1_3;  // multiplies alpha21*alpha23
  const Scalar c_1 = Scalar(2.0) * omega2_2 / omega1_3;  // multiplies alpha21*delta23
  const Scalar c_2 = -Scalar(4.0) * per_2 * per_3 / omega1;  // multiplies alpha22^2
  const Scalar c_3 = -Scalar(8.0) * omega1 * per_2 * per_3;  // multiplies alpha22*delta22
  const Scalar c_4 = -Scalar(2.0) / (omega1 * omega2_2);  // multiplies alpha22*alpha24
  const Scalar c_5 = Scalar(2.0) / omega1;  // multiplies alpha22*delta24
  const Scalar c_6 = Scalar(4.0) * per_0 * per_1 / omega1;  // multiplies alpha23^2
  const Scalar c_7 = Scalar(2.0) / omega1;  // multiplies alpha23*delta21
  const Scalar c_8 = Scalar(8.0) * omega2_2 * per_0 * per_1 / omega1;  // multiplies alpha23*delta23
  const Scalar c_9 = -Scalar(2.0) * omega2_2 / omega1;  // multiplies delta21*delta23
  // multiplies delta22^2
  const Scalar c_10 = (Scalar(12.0) * omega1_3 - Scalar(4.0) * omega1 * omega2_2) * per_2 * per_3;
  const Scalar c_11 = Scalar(2.0) * omega1 / omega2_2;  // multiplies delta22*alpha24
  const Scalar c_12 = -Scalar(2.0) * omega1;  // multiplies delta22*delta24
  // multiplies delta23^2
  const Scalar c_13 = (Scalar(4.0) * omega1_2 * omega2_2 - Scalar(12.0) * omega2_4) * per_0 * per_1 / omega1;
  const Scalar c_14 = Scalar(1.0) / omega1;  // multiplies alpha33
  const Scalar c_15 = -omega1;  // multiplies delta33
  const Scalar c_16 = -omega2_2 / omega1;  // multiplies delta34
  gradient[5] = alpha23 * c_0 + delta23 * c_1;  // by alpha21
  gradient[6] = Scalar(2.0) * alpha22 * c_2 + delta22 * c_3 + alpha24 * c_4 + delta24 * c_5;  // by alpha22
  gradient[7] = alpha21 * c_0 + Scalar(2.0) * alpha23 * c_6 + delta21 * c_7 + delta23 * c_8;  // by alpha23
  gradient[8] = alpha23 * c_7 + delta23 * c_9;  // by delta21
  gradient[9] = alpha22 * c_3 + Scalar(2.0) * delta22 * c_10 + alpha24 * c_11 + delta24 * c_12;  // by delta22
  gradient[10] = alpha21 * c_1 + alpha23 * c_8 + delta21 * c_9 + Scalar(2.0) * delta23 * c_13;  // by delta23
  gradient[13] = c_14;  // by alpha33
  gradient[17] = c_15;  // by delta33
  gradient[18] = c_16;  // by delta34
  gradient[25] = alpha22 * c_4 + delta22 * c_11;  // by alpha24
  gradient[26] = alpha22 * c_5 + delta22 * c_12;  // by delta24
  return value;
}

/// conservative_v1_A_v12_conjA_v1 = (6*omega1^4*delta21^2 - 6*omega1^4*delta31 + 12*omega1^2*alpha21*delta21 +
/// 9*omega1^2*alpha31 - 10*alpha21^2)/(6*omega1^3) + (-8*omega1^6*delta22^2 + 3*omega1^4*omega2^2*delta22^2 +
/// 16*omega1^4*alpha22*delta22 - 2*omega1^2*omega2^2*alpha22*delta22 - 8*omega1^2*alpha22^2 +
/// 3*omega2^2*alpha22^2)/(omega1*omega2^2*(2*omega1 + omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 77 operations.
template <class Scalar>
Scalar lump_2(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar alpha31 = parameters[11];
  const Scalar delta31 = parameters[15];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar alpha21_2 = alpha21 * alpha21;
  const Scalar alpha22_2 = alpha22 * alpha22;
  const Scalar delta21_2 = delta21 * delta21;
  const Scalar delta22_2 = delta22 * delta22;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = omega1 * delta21_2 - omega1 * delta31;
  const Scalar f_1 = (Scalar(4.0) * alpha21 * delta21 + Scalar(3.0) * alpha31) / (Scalar(2.0) * omega1);
  const Scalar f_2 = -Scalar(5.0) * alpha21_2 / (Scalar(3.0) * omega1_3);
  const Scalar f_3 = -Scalar(8.0) * omega1_5 * delta22_2 * per_0 * per_1 / omega2_2;
  const Scalar f_4 = Scalar(3.0) * omega1_3 * delta22_2 * per_0 * per_1;
  const Scalar f_5 = Scalar(16.0) * omega1_3 * alpha22 * delta22 * per_0 * per_1 / omega2_2;
  const Scalar f_6 = -Scalar(2.0) * omega1 * alpha22 * delta22 * per_0 * per_1;
  const Scalar f_7 = -Scalar(8.0) * omega1 * alpha22_2 * per_0 * per_1 / omega2_2;
  const Scalar f_8 = Scalar(3.0) * alpha22_2 * per_0 * per_1 / omega1;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_0;
  const Scalar q_1 = (f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_1;
  // by omega1
  gradient[0] = (f_0 - f_1 - Scalar(3.0) * f_2 + Scalar(5.0) * f_3 + Scalar(3.0) * f_4 + Scalar(3.0) * f_5 + f_6
      + f_7 - f_8) / omega1 - Scalar(2.0) * q_0 - Scalar(2.0) * q_1;
  gradient[1] = (-Scalar(2.0) * f_3 - Scalar(2.0) * f_5 - Scalar(2.0) * f_7) / omega2 - q_0 + q_1;  // by omega2
  const Scalar c_0 = -Scalar(5.0) / (Scalar(3.0) * omega1_3);  // multiplies alpha21^2
  const Scalar c_1 = Scalar(2.0) / omega1;  // multiplies alpha21*delta21
  // multiplies alpha22^2
  const Scalar c_2 = (-Scalar(8.0) * omega1_2 + Scalar(3.0) * omega2_2) * per_0 * per_1 / (omega1 * omega2_2);
  // multiplies alpha22*delta22
  const Scalar c_3 = (Scalar(16.0) * omega1_3 - Scalar(2.0) * omega1 * omega2_2) * per_0 * per_1 / omega2_2;
  const Scalar c_4 = omega1;  // multiplies delta21^2
  // multiplies delta22^2
  const Scalar c_5 = (-Scalar(8.0) * omega1_5 + Scalar(3.0) * omega1_3 * omega2_2) * per_0 * per_1 / omega2_2;
  const Scalar c_6 = Scalar(3.0) / (Scalar(2.0) * omega1);  // multiplies alpha31
  const Scalar c_7 = -omega1;  // multiplies delta31
  gradient[5] = Scalar(2.0) * alpha21 * c_0 + delta21 * c_1;  // by alpha21
  gradient[6] = Scalar(2.0) * alpha22 * c_2 + delta22 * c_3;  // by alpha22
  gradient[8] = alpha21 * c_1 + Scalar(2.0) * delta21 * c_4;  // by delta21
  gradient[9] = alpha22 * c_3 + Scalar(2.0) * delta22 * c_5;  // by delta22
  gradient[11] = c_6;  // by alpha31
  gradient[15] = c_7;  // by delta31
  return value;
}

/// conservative_v1_A_v2_conjA_v2_F = (-omega2^2*delta23*eta12 + alpha23*eta12)/(2*omega1^3) +
/// (-omega2^2*delta23*eta22 - alpha23*eta22)/(omega1*(omega1 + 2*omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 32 operations.
template <class Scalar>
Scalar lump_3(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha23 = parameters[7];
  const Scalar delta23 = parameters[10];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = -omega2_2 * delta23 * eta12 / (Scalar(2.0) * omega1_3);
  const Scalar f_1 = alpha23 * eta12 / (Scalar(2.0) * omega1_3);
  const Scalar f_2 = -omega2_2 * delta23 * eta22 * per_0 * per_1 / omega1;
  const Scalar f_3 = -alpha23 * eta22 * per_0 * per_1 / omega1;
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_2 + f_3) * per_0;
  const Scalar q_1 = (f_2 + f_3) * per_1;
  gradient[0] = (-Scalar(3.0) * f_0 - Scalar(3.0) * f_1 - f_2 - f_3) / omega1 - q_0 - q_1;  // by omega1
  // by omega2
  gradient[1] = (Scalar(2.0) * f_0 + Scalar(2.0) * f_2) / omega2 - Scalar(2.0) * q_0 + Scalar(2.0) * q_1;
  const Scalar c_0 = Scalar(1.0) / (Scalar(2.0) * omega1_3);  // multiplies alpha23*eta12
  const Scalar c_1 = -per_0 * per_1 / omega1;  // multiplies alpha23*eta22
  const Scalar c_2 = -omega2_2 / (Scalar(2.0) * omega1_3);  // multiplies delta23*eta12
  const Scalar c_3 = -omega2_2 * per_0 * per_1 / omega1;  // multiplies delta23*eta22
  gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
  gradient[10] = eta12 * c_2 + eta22 * c_3;  // by delta23
  gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
  gradient[30] = alpha23 * c_1 + delta23 * c_3;  // by eta22
  return value;
}

/// conservative_v2_A_v2_F2 = eta22^2/(4*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 15 operations.
template <class Scalar>
Scalar lump_4(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar eta22 = parameters[30];
  const Scalar eta22_2 = eta22 * eta22;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = eta22_2 * per_0 * per_1 / (Scalar(4.0) * omega2);
  const Scalar value = f_0;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_0 * per_0;
  const Scalar q_1 = f_0 * per_1;
  gradient[0] = -q_0 - q_1;  // by omega1
  gradient[1] = -f_0 / omega2 - Scalar(2.0) * q_0 + Scalar(2.0) * q_1;  // by omega2
  const Scalar c_0 = per_0 * per_1 / (Scalar(4.0) * omega2);  // multiplies eta22^2
  gradient[30] = Scalar(2.0) * eta22 * c_0;  // by eta22
  return value;
}

/// conservative_v2_A_v22_conjA_v2 = (6*omega2^4*delta24^2 - 6*omega2^4*delta36 + 12*omega2^2*alpha24*delta24 +
/// 9*omega2^2*alpha35 - 10*alpha24^2)/(6*omega2^3) + (-3*omega1^2*omega2^4*delta23^2 +
/// 2*omega1^2*omega2^2*alpha23*delta23 - 3*omega1^2*alpha23^2 + 8*omega2^6*delta23^2 -
/// 16*omega2^4*alpha23*delta23 + 8*omega2^2*alpha23^2)/(omega1^2*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 77 operations.
template <class Scalar>
Scalar lump_5(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha23 = parameters[7];
  const Scalar delta23 = parameters[10];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar alpha35 = parameters[27];
  const Scalar delta36 = parameters[28];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar alpha23_2 = alpha23 * alpha23;
  const Scalar delta23_2 = delta23 * delta23;
  const Scalar alpha24_2 = alpha24 * alpha24;
  const Scalar delta24_2 = delta24 * delta24;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = omega2 * delta24_2 - omega2 * delta36;
  const Scalar f_1 = (Scalar(4.0) * alpha24 * delta24 + Scalar(3.0) * alpha35) / (Scalar(2.0) * omega2);
  const Scalar f_2 = -Scalar(5.0) * alpha24_2 / (Scalar(3.0) * omega2_3);
  const Scalar f_3 = -Scalar(3.0) * omega2_3 * delta23_2 * per_0 * per_1;
  const Scalar f_4 = Scalar(2.0) * omega2 * alpha23 * delta23 * per_0 * per_1;
  const Scalar f_5 = -Scalar(3.0) * alpha23_2 * per_0 * per_1 / omega2;
  const Scalar f_6 = Scalar(8.0) * omega2_5 * delta23_2 * per_0 * per_1 / omega1_2;
  const Scalar f_7 = -Scalar(16.0) * omega2_3 * alpha23 * delta23 * per_0 * per_1 / omega1_2;
  const Scalar f_8 = Scalar(8.0) * omega2 * alpha23_2 * per_0 * per_1 / omega1_2;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_0;
  const Scalar q_1 = (f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_1;
  gradient[0] = (-Scalar(2.0) * f_6 - Scalar(2.0) * f_7 - Scalar(2.0) * f_8) / omega1 - q_0 - q_1;  // by omega1
  // by omega2
  gradient[1] = (f_0 - f_1 - Scalar(3.0) * f_2 + Scalar(3.0) * f_3 + f_4 - f_5 + Scalar(5.0) * f_6
      + Scalar(3.0) * f_7 + f_8) / omega2 - Scalar(2.0) * q_0 + Scalar(2.0) * q_1;
  // multiplies alpha23^2
  const Scalar c_0 = (-Scalar(3.0) * omega1_2 + Scalar(8.0) * omega2_2) * per_0 * per_1 / (omega1_2 * omega2);
  // multiplies alpha23*delta23
  const Scalar c_1 = (Scalar(2.0) * omega1_2 * omega2 - Scalar(16.0) * omega2_3) * per_0 * per_1 / omega1_2;
  // multiplies delta23^2
  const Scalar c_2 = (-Scalar(3.0) * omega1_2 * omega2_3 + Scalar(8.0) * omega2_5) * per_0 * per_1 / omega1_2;
  const Scalar c_3 = -Scalar(5.0) / (Scalar(3.0) * omega2_3);  // multiplies alpha24^2
  const Scalar c_4 = Scalar(2.0) / omega2;  // multiplies alpha24*delta24
  const Scalar c_5 = omega2;  // multiplies delta24^2
  const Scalar c_6 = Scalar(3.0) / (Scalar(2.0) * omega2);  // multiplies alpha35
  const Scalar c_7 = -omega2;  // multiplies delta36
  gradient[7] = Scalar(2.0) * alpha23 * c_0 + delta23 * c_1;  // by alpha23
  gradient[10] = alpha23 * c_1 + Scalar(2.0) * delta23 * c_2;  // by delta23
  gradient[25] = Scalar(2.0) * alpha24 * c_3 + delta24 * c_4;  // by alpha24
  gradient[26] = alpha24 * c_4 + Scalar(2.0) * delta24 * c_5;  // by delta24
  gradient[27] = c_6;  // by alpha35
  gradient[28] = c_7;  // by delta36
  return value;
}

/// harmonic_re_v1_A_v2_conjA_v1 = (2*omega1^2*delta22 - 2*omega1*omega2*delta22 - 2*alpha22)/(omega2*(2*omega1 -
/// omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 21 operations.
template <class Scalar>
Scalar lump_6(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar delta22 = parameters[9];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = Scalar(2.0) * omega1_2 * delta22 * per_0 / omega2;
  const Scalar f_1 = -Scalar(2.0) * omega1 * delta22 * per_0;
  const Scalar f_2 = -Scalar(2.0) * alpha22 * per_0 / omega2;
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2) * per_0;
  gradient[0] = (Scalar(2.0) * f_0 + f_1) / omega1 - Scalar(2.0) * q_0;  // by omega1
  gradient[1] = (-f_0 - f_2) / omega2 + q_0;  // by omega2
  const Scalar c_0 = -Scalar(2.0) * per_0 / omega2;  // multiplies alpha22
  // multiplies delta22
  const Scalar c_1 = (Scalar(2.0) * omega1_2 - Scalar(2.0) * omega1 * omega2) * per_0 / omega2;
  gradient[6] = c_0;  // by alpha22
  gradient[9] = c_1;  // by delta22
  return value;
}

/// harmonic_im_v1_A_v2_conjA_v1 = (2*omega1^2*omega2*mu12*delta23 - 4*omega1*omega2^2*mu12*delta23 +
/// 2*omega1*mu12*alpha23 + 2*omega2^3*mu12*delta23 - 2*omega2*mu12*alpha23)/(omega1*omega2*(omega1 -
/// 2*omega2)*(2*omega1 - omega2)) + (-2*omega1^2*omega2*mu12*delta21 - 2*omega1^2*omega2*delta23*mu21 +
/// 2*omega1*omega2^2*mu12*delta21 + 2*omega1*alpha23*mu21 - 2*omega2^3*mu12*delta21 +
/// 2*omega2*mu12*alpha21)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 108 operations.
template <class Scalar>
Scalar lump_7(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu12 = parameters[3];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha23 = parameters[7];
  const Scalar delta21 = parameters[8];
  const Scalar delta23 = parameters[10];
  const Scalar mu21 = parameters[23];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = Scalar(2.0) * omega1 * mu12 * delta23 * per_0 * per_1;
  const Scalar f_1 = -Scalar(4.0) * omega2 * mu12 * delta23 * per_0 * per_1;
  const Scalar f_2 = Scalar(2.0) * mu12 * alpha23 * per_0 * per_1 / omega2;
  const Scalar f_3 = Scalar(2.0) * omega2_2 * mu12 * delta23 * per_0 * per_1 / omega1;
  const Scalar f_4 = -Scalar(2.0) * mu12 * alpha23 * per_0 * per_1 / omega1;
  const Scalar f_5 = (-Scalar(2.0) * omega1_2 * mu12 * delta21
      - Scalar(2.0) * omega1_2 * delta23 * mu21) * per_2 * per_3 * per_1;
  const Scalar f_6 = Scalar(2.0) * omega1 * omega2 * mu12 * delta21 * per_2 * per_3 * per_1;
  const Scalar f_7 = Scalar(2.0) * omega1 * alpha23 * mu21 * per_2 * per_3 * per_1 / omega2;
  const Scalar f_8 = -Scalar(2.0) * omega2_2 * mu12 * delta21 * per_2 * per_3 * per_1;
  const Scalar f_9 = Scalar(2.0) * mu12 * alpha21 * per_2 * per_3 * per_1;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_1;
  const Scalar q_2 = (f_5 + f_6 + f_7 + f_8 + f_9) * per_2;
  const Scalar q_3 = (f_5 + f_6 + f_7 + f_8 + f_9) * per_3;
  // by omega1
  gradient[0] = (f_0 - f_3 - f_4 + Scalar(2.0) * f_5 + f_6 + f_7) / omega1 - q_0 - Scalar(2.0) * q_1 - q_2 - q_3;
  // by omega2
  gradient[1] = (f_1 - f_2 + Scalar(2.0) * f_3 + f_6 - f_7 + Scalar(2.0) * f_8) / omega2 + Scalar(2.0) * q_0 + q_1
      - q_2 + q_3;
  const Scalar c_0 = Scalar(2.0) * per_2 * per_3 * per_1;  // multiplies mu12*alpha21
  // multiplies mu12*alpha23
  const Scalar c_1 = (Scalar(2.0) * omega1 - Scalar(2.0) * omega2) * per_0 * per_1 / (omega1 * omega2);
  // multiplies mu12*delta21
  const Scalar c_2 = (-Scalar(2.0) * omega1_2 + Scalar(2.0) * omega1 * omega2
      - Scalar(2.0) * omega2_2) * per_2 * per_3 * per_1;
  // multiplies mu12*delta23
  const Scalar c_3 = (Scalar(2.0) * omega1_2 - Scalar(4.0) * omega1 * omega2
      + Scalar(2.0) * omega2_2) * per_0 * per_1 / omega1;
  const Scalar c_4 = Scalar(2.0) * omega1 * per_2 * per_3 * per_1 / omega2;  // multiplies alpha23*mu21
  const Scalar c_5 = -Scalar(2.0) * omega1_2 * per_2 * per_3 * per_1;  // multiplies delta23*mu21
  gradient[3] = alpha21 * c_0 + alpha23 * c_1 + delta21 * c_2 + delta23 * c_3;  // by mu12
  gradient[5] = mu12 * c_0;  // by alpha21
  gradient[7] = mu12 * c_1 + mu21 * c_4;  // by alpha23
  gradient[8] = mu12 * c_2;  // by delta21
  gradient[10] = mu12 * c_3 + mu21 * c_5;  // by delta23
  gradient[23] = alpha23 * c_4 + delta23 * c_5;  // by mu21
  return value;
}

/// harmonic_im_v1_A_v2_F = (-omega1*mu12*eta22 + omega2*mu12*eta22)/(2*omega1*omega2*(omega1 -
/// 2*omega2)*(2*omega1 - omega2)) - mu12*eta12/(2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 35 operations.
template <class Scalar>
Scalar lump_8(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu12 = parameters[3];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar per_0 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -mu12 * eta22 * per_0 * per_1 / (Scalar(2.0) * omega2);
  const Scalar f_1 = mu12 * eta22 * per_0 * per_1 / (Scalar(2.0) * omega1);
  const Scalar f_2 = -mu12 * eta12 * per_2 * per_3 * per_1 / Scalar(2.0);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2) * per_1;
  const Scalar q_2 = f_2 * per_2;
  const Scalar q_3 = f_2 * per_3;
  gradient[0] = -f_1 / omega1 - q_0 - Scalar(2.0) * q_1 - q_2 - q_3;  // by omega1
  gradient[1] = -f_0 / omega2 + Scalar(2.0) * q_0 + q_1 - q_2 + q_3;  // by omega2
  const Scalar c_0 = -per_2 * per_3 * per_1 / Scalar(2.0);  // multiplies mu12*eta12
  const Scalar c_1 = (-omega1 + omega2) * per_0 * per_1 / (Scalar(2.0) * omega1 * omega2);  // multiplies mu12*eta22
  gradient[3] = eta12 * c_0 + eta22 * c_1;  // by mu12
  gradient[21] = mu12 * c_0;  // by eta12
  gradient[30] = mu12 * c_1;  // by eta22
  return value;
}

/// harmonic_re_v1_A_v2_conjA_v1_F = omega1*delta22*eta12/(omega2*(omega1 + omega2)*(2*omega1 - omega2)) +
/// (omega1*omega2*delta22*eta22 + alpha22*eta22)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 -
/// omega2)) + (-omega1^2*alpha22*eta12 - 2*omega1*omega2*alpha22*eta12 +
/// omega2^2*alpha22*eta12)/(omega1^2*omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 61 operations.
template <class Scalar>
Scalar lump_9(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar delta22 = parameters[9];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = omega1 * delta22 * eta12 * per_0 * per_1 / omega2;
  const Scalar f_1 = omega2 * delta22 * eta22 * per_0 * per_2 * per_3;
  const Scalar f_2 = alpha22 * eta22 * per_0 * per_2 * per_3 / omega1;
  const Scalar f_3 = -alpha22 * eta12 * per_0 * per_3 * per_1 / omega2;
  const Scalar f_4 = -Scalar(2.0) * alpha22 * eta12 * per_0 * per_3 * per_1 / omega1;
  const Scalar f_5 = omega2 * alpha22 * eta12 * per_0 * per_3 * per_1 / omega1_2;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_0;
  const Scalar q_1 = (f_0 + f_3 + f_4 + f_5) * per_1;
  const Scalar q_2 = (f_1 + f_2) * per_2;
  const Scalar q_3 = (f_1 + f_2 + f_3 + f_4 + f_5) * per_3;
  gradient[0] = (f_0 - f_2 - f_4 - Scalar(2.0) * f_5) / omega1 - q_0 - Scalar(2.0) * q_1 - q_2 - q_3;  // by omega1
  gradient[1] = (-f_0 + f_1 - f_3 + f_5) / omega2 - q_0 + q_1 - Scalar(2.0) * q_2 + q_3;  // by omega2
  // multiplies alpha22*eta12
  const Scalar c_0 = (-omega1_2 - Scalar(2.0) * omega1 * omega2
      + omega2_2) * per_0 * per_3 * per_1 / (omega1_2 * omega2);
  const Scalar c_1 = per_0 * per_2 * per_3 / omega1;  // multiplies alpha22*eta22
  const Scalar c_2 = omega1 * per_0 * per_1 / omega2;  // multiplies delta22*eta12
  const Scalar c_3 = omega2 * per_0 * per_2 * per_3;  // multiplies delta22*eta22
  gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
  gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
  gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
  gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  return value;
}

/// harmonic_re_v1_A_v22_conjA_v2 = (-12*omega2^4*delta23*delta24 + 3*omega2^4*delta35 -
/// 6*omega2^2*alpha23*delta24 + 4*omega2^2*delta23*alpha24 - 9*omega2^2*alpha34 +
/// 10*alpha23*alpha24)/(3*omega2^2*(omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^2*omega2^4*delta22*delta23
/// - 2*omega1^2*omega2^2*alpha22*delta23 - 4*omega1^2*omega2^2*alpha23*delta22 + 6*omega1^2*alpha22*alpha23 +
/// 16*omega2^4*alpha22*delta23 - 16*omega2^2*alpha22*alpha23)/(omega1^2*(omega1 + omega2)*(omega1 +
/// 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 116 operations.
template <class Scalar>
Scalar lump_10(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar alpha34 = parameters[14];
  const Scalar delta35 = parameters[19];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = (-Scalar(4.0) * omega2_2 * delta23 * delta24 + omega2_2 * delta35) * per_0 * per_1;
  const Scalar f_1 = (-Scalar(6.0) * alpha23 * delta24 + Scalar(4.0) * delta23 * alpha24
      - Scalar(9.0) * alpha34) * per_0 * per_1 / Scalar(3.0);
  const Scalar f_2 = Scalar(10.0) * alpha23 * alpha24 * per_0 * per_1 / (Scalar(3.0) * omega2_2);
  const Scalar f_3 = -Scalar(4.0) * omega2_4 * delta22 * delta23 * per_0 * per_2 * per_1 * per_3;
  const Scalar f_4 = (-Scalar(2.0) * omega2_2 * alpha22 * delta23
      - Scalar(4.0) * omega2_2 * alpha23 * delta22) * per_0 * per_2 * per_1 * per_3;
  const Scalar f_5 = Scalar(6.0) * alpha22 * alpha23 * per_0 * per_2 * per_1 * per_3;
  const Scalar f_6 = Scalar(16.0) * omega2_4 * alpha22 * delta23 * per_0 * per_2 * per_1 * per_3 / omega1_2;
  const Scalar f_7 = -Scalar(16.0) * omega2_2 * alpha22 * alpha23 * per_0 * per_2 * per_1 * per_3 / omega1_2;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7) * per_1;
  const Scalar q_2 = (f_3 + f_4 + f_5 + f_6 + f_7) * per_2;
  const Scalar q_3 = (f_3 + f_4 + f_5 + f_6 + f_7) * per_3;
  gradient[0] = (-Scalar(2.0) * f_6 - Scalar(2.0) * f_7) / omega1 - q_0 - q_1 - q_2 - q_3;  // by omega1
  // by omega2
  gradient[1] = (Scalar(2.0) * f_0 - Scalar(2.0) * f_2 + Scalar(4.0) * f_3 + Scalar(2.0) * f_4 + Scalar(4.0) * f_6
      + Scalar(2.0) * f_7) / omega2 - q_0 + q_1 - Scalar(2.0) * q_2 + Scalar(2.0) * q_3;
  // multiplies alpha22*alpha23
  const Scalar c_0 = (Scalar(6.0) * omega1_2 - Scalar(16.0) * omega2_2) * per_0 * per_2 * per_1 * per_3 / omega1_2;
  // multiplies alpha22*delta23
  const Scalar c_1 = (-Scalar(2.0) * omega1_2 * omega2_2
      + Scalar(16.0) * omega2_4) * per_0 * per_2 * per_1 * per_3 / omega1_2;
  const Scalar c_2 = -Scalar(4.0) * omega2_2 * per_0 * per_2 * per_1 * per_3;  // multiplies alpha23*delta22
  const Scalar c_3 = Scalar(10.0) * per_0 * per_1 / (Scalar(3.0) * omega2_2);  // multiplies alpha23*alpha24
  const Scalar c_4 = -Scalar(2.0) * per_0 * per_1;  // multiplies alpha23*delta24
  const Scalar c_5 = -Scalar(4.0) * omega2_4 * per_0 * per_2 * per_1 * per_3;  // multiplies delta22*delta23
  const Scalar c_6 = Scalar(4.0) * per_0 * per_1 / Scalar(3.0);  // multiplies delta23*alpha24
  const Scalar c_7 = -Scalar(4.0) * omega2_2 * per_0 * per_1;  // multiplies delta23*delta24
  const Scalar c_8 = -Scalar(3.0) * per_0 * per_1;  // multiplies alpha34
  const Scalar c_9 = omega2_2 * per_0 * per_1;  // multiplies delta35
  gradient[6] = alpha23 * c_0 + delta23 * c_1;  // by alpha22
  gradient[7] = alpha22 * c_0 + delta22 * c_2 + alpha24 * c_3 + delta24 * c_4;  // by alpha23
  gradient[9] = alpha23 * c_2 + delta23 * c_5;  // by delta22
  gradient[10] = alpha22 * c_1 + delta22 * c_5 + alpha24 * c_6 + delta24 * c_7;  // by delta23
  gradient[14] = c_8;  // by alpha34
  gradient[19] = c_9;  // by delta35
  gradient[25] = alpha23 * c_3 + delta23 * c_6;  // by alpha24
  gradient[26] = alpha23 * c_4 + delta23 * c_7;  // by delta24
  return value;
}

/// harmonic_re_v1_A_v1_A_v2_conjA_v1 = (2*omega1^2*delta32 - 6*alpha32)/((omega1 + omega2)*(omega1 - omega2)) +
/// (-4*omega1^4*alpha23*delta22 + 8*omega1^2*omega2^4*delta22*delta23 + 16*omega1^2*omega2^2*alpha23*delta22 +
/// 4*omega1^2*alpha22*alpha23 - 16*omega2^6*delta22*delta23 - 8*omega2^4*alpha22*delta23 +
/// 16*omega2^4*alpha23*delta22 - 24*omega2^2*alpha22*alpha23)/(omega2^2*(omega1 + omega2)*(omega1 +
/// 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) + (-24*omega1^6*delta21*delta22 + 8*omega1^4*alpha21*delta22
/// - 8*omega1^4*alpha22*delta21 - 4*omega1^2*omega2^2*alpha22*delta21 + 24*omega1^2*alpha21*alpha22 -
/// 4*omega2^2*alpha21*alpha22)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 -
/// omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 179 operations.
template <class Scalar>
Scalar lump_11(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar alpha32 = parameters[12];
  const Scalar delta32 = parameters[16];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_4 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_5 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = Scalar(2.0) * omega1_2 * delta32 * per_0 * per_1;
  const Scalar f_1 = -Scalar(6.0) * alpha32 * per_0 * per_1;
  const Scalar f_2 = -Scalar(4.0) * omega1_4 * alpha23 * delta22 * per_0 * per_2 * per_1 * per_3 / omega2_2;
  const Scalar f_3 = Scalar(8.0) * omega1_2 * omega2_2 * delta22 * delta23 * per_0 * per_2 * per_1 * per_3;
  const Scalar f_4 = Scalar(16.0) * omega1_2 * alpha23 * delta22 * per_0 * per_2 * per_1 * per_3;
  const Scalar f_5 = Scalar(4.0) * omega1_2 * alpha22 * alpha23 * per_0 * per_2 * per_1 * per_3 / omega2_2;
  const Scalar f_6 = -Scalar(16.0) * omega2_4 * delta22 * delta23 * per_0 * per_2 * per_1 * per_3;
  const Scalar f_7 = (-Scalar(8.0) * omega2_2 * alpha22 * delta23
      + Scalar(16.0) * omega2_2 * alpha23 * delta22) * per_0 * per_2 * per_1 * per_3;
  const Scalar f_8 = -Scalar(24.0) * alpha22 * alpha23 * per_0 * per_2 * per_1 * per_3;
  const Scalar f_9 = -Scalar(24.0) * omega1_4 * delta21 * delta22 * per_0 * per_1 * per_4 * per_5;
  const Scalar f_10 = (Scalar(8.0) * omega1_2 * alpha21 * delta22
      - Scalar(8.0) * omega1_2 * alpha22 * delta21) * per_0 * per_1 * per_4 * per_5;
  const Scalar f_11 = -Scalar(4.0) * omega2_2 * alpha22 * delta21 * per_0 * per_1 * per_4 * per_5;
  const Scalar f_12 = Scalar(24.0) * alpha21 * alpha22 * per_0 * per_1 * per_4 * per_5;
  const Scalar f_13 = -Scalar(4.0) * omega2_2 * alpha21 * alpha22 * per_0 * per_1 * per_4 * per_5 / omega1_2;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12
      + f_13) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12
      + f_13) * per_1;
  const Scalar q_2 = (f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_2;
  const Scalar q_3 = (f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_3;
  const Scalar q_4 = (f_9 + f_10 + f_11 + f_12 + f_13) * per_4;
  const Scalar q_5 = (f_9 + f_10 + f_11 + f_12 + f_13) * per_5;
  // by omega1
  gradient[0] = (Scalar(2.0) * f_0 + Scalar(4.0) * f_2 + Scalar(2.0) * f_3 + Scalar(2.0) * f_4 + Scalar(2.0) * f_5
      + Scalar(4.0) * f_9 + Scalar(2.0) * f_10 - Scalar(2.0) * f_13) / omega1 - q_0 - q_1 - q_2 - q_3
      - Scalar(2.0) * q_4 - Scalar(2.0) * q_5;
  // by omega2
  gradient[1] = (-Scalar(2.0) * f_2 + Scalar(2.0) * f_3 - Scalar(2.0) * f_5 + Scalar(4.0) * f_6 + Scalar(2.0) * f_7
      + Scalar(2.0) * f_11 + Scalar(2.0) * f_13) / omega2 - q_0 + q_1 - Scalar(2.0) * q_2 + Scalar(2.0) * q_3 - q_4
      + q_5;
  // multiplies alpha21*alpha22
  const Scalar c_0 = (Scalar(24.0) * omega1_2 - Scalar(4.0) * omega2_2) * per_0 * per_1 * per_4 * per_5 / omega1_2;
  const Scalar c_1 = Scalar(8.0) * omega1_2 * per_0 * per_1 * per_4 * per_5;  // multiplies alpha21*delta22
  // multiplies alpha22*alpha23
  const Scalar c_2 = (Scalar(4.0) * omega1_2 - Scalar(24.0) * omega2_2) * per_0 * per_2 * per_1 * per_3 / omega2_2;
  // multiplies alpha22*delta21
  const Scalar c_3 = (-Scalar(8.0) * omega1_2 - Scalar(4.0) * omega2_2) * per_0 * per_1 * per_4 * per_5;
  const Scalar c_4 = -Scalar(8.0) * omega2_2 * per_0 * per_2 * per_1 * per_3;  // multiplies alpha22*delta23
  // multiplies alpha23*delta22
  const Scalar c_5 = (-Scalar(4.0) * omega1_4 + Scalar(16.0) * omega1_2 * omega2_2
      + Scalar(16.0) * omega2_4) * per_0 * per_2 * per_1 * per_3 / omega2_2;
  const Scalar c_6 = -Scalar(24.0) * omega1_4 * per_0 * per_1 * per_4 * per_5;  // multiplies delta21*delta22
  // multiplies delta22*delta23
  const Scalar c_7 = (Scalar(8.0) * omega1_2 * omega2_2 - Scalar(16.0) * omega2_4) * per_0 * per_2 * per_1 * per_3;
  const Scalar c_8 = -Scalar(6.0) * per_0 * per_1;  // multiplies alpha32
  const Scalar c_9 = Scalar(2.0) * omega1_2 * per_0 * per_1;  // multiplies delta32
  gradient[5] = alpha22 * c_0 + delta22 * c_1;  // by alpha21
  gradient[6] = alpha21 * c_0 + alpha23 * c_2 + delta21 * c_3 + delta23 * c_4;  // by alpha22
  gradient[7] = alpha22 * c_2 + delta22 * c_5;  // by alpha23
  gradient[8] = alpha22 * c_3 + delta22 * c_6;  // by delta21
  gradient[9] = alpha21 * c_1 + alpha23 * c_5 + delta21 * c_6 + delta23 * c_7;  // by delta22
  gradient[10] = alpha22 * c_4 + delta22 * c_7;  // by delta23
  gradient[12] = c_8;  // by alpha32
  gradient[16] = c_9;  // by delta32
  return value;
}

/// harmonic_re_v1_A_v1_A_v2_F = -omega1*delta22*eta12/(omega2*(omega1 - omega2)*(2*omega1 + omega2)) +
/// (-omega1*omega2*delta22*eta22 + alpha22*eta22)/(omega1*(omega1 + omega2)*(omega1 - omega2)*(omega1 -
/// 2*omega2)) + (omega1^2*alpha22*eta12 - 2*omega1*omega2*alpha22*eta12 -
/// omega2^2*alpha22*eta12)/(omega1^2*omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 61 operations.
template <class Scalar>
Scalar lump_12(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar delta22 = parameters[9];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = -omega1 * delta22 * eta12 * per_0 * per_1 / omega2;
  const Scalar f_1 = -omega2 * delta22 * eta22 * per_2 * per_0 * per_3;
  const Scalar f_2 = alpha22 * eta22 * per_2 * per_0 * per_3 / omega1;
  const Scalar f_3 = alpha22 * eta12 * per_2 * per_0 * per_1 / omega2;
  const Scalar f_4 = -Scalar(2.0) * alpha22 * eta12 * per_2 * per_0 * per_1 / omega1;
  const Scalar f_5 = -omega2 * alpha22 * eta12 * per_2 * per_0 * per_1 / omega1_2;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_0;
  const Scalar q_1 = (f_0 + f_3 + f_4 + f_5) * per_1;
  const Scalar q_2 = (f_1 + f_2 + f_3 + f_4 + f_5) * per_2;
  const Scalar q_3 = (f_1 + f_2) * per_3;
  gradient[0] = (f_0 - f_2 - f_4 - Scalar(2.0) * f_5) / omega1 - q_0 - Scalar(2.0) * q_1 - q_2 - q_3;  // by omega1
  gradient[1] = (-f_0 + f_1 - f_3 + f_5) / omega2 + q_0 - q_1 - q_2 + Scalar(2.0) * q_3;  // by omega2
  // multiplies alpha22*eta12
  const Scalar c_0 = (omega1_2 - Scalar(2.0) * omega1 * omega2
      - omega2_2) * per_2 * per_0 * per_1 / (omega1_2 * omega2);
  const Scalar c_1 = per_2 * per_0 * per_3 / omega1;  // multiplies alpha22*eta22
  const Scalar c_2 = -omega1 * per_0 * per_1 / omega2;  // multiplies delta22*eta12
  const Scalar c_3 = -omega2 * per_2 * per_0 * per_3;  // multiplies delta22*eta22
  gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
  gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
  gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
  gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  return value;
}

/// harmonic_re_v1_A_v22 = (-omega2^2*delta23 - alpha23)/((omega1 + 2*omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 15 operations.
template <class Scalar>
Scalar lump_13(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha23 = parameters[7];
  const Scalar delta23 = parameters[10];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = -omega2_2 * delta23 * per_0 * per_1;
  const Scalar f_1 = -alpha23 * per_0 * per_1;
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1) * per_0;
  const Scalar q_1 = (f_0 + f_1) * per_1;
  gradient[0] = -q_0 - q_1;  // by omega1
  gradient[1] = Scalar(2.0) * f_0 / omega2 - Scalar(2.0) * q_0 + Scalar(2.0) * q_1;  // by omega2
  const Scalar c_0 = -per_0 * per_1;  // multiplies alpha23
  const Scalar c_1 = -omega2_2 * per_0 * per_1;  // multiplies delta23
  gradient[7] = c_0;  // by alpha23
  gradient[10] = c_1;  // by delta23
  return value;
}

/// harmonic_im_v1_A_v22 = (6*omega2^2*mu12*delta24 - 2*mu12*alpha24)/(3*omega2*(omega1 + 2*omega2)*(omega1 -
/// 2*omega2)) + (-4*omega2^3*mu12*delta22 + 2*omega2*mu12*alpha22)/((omega1 + omega2)*(omega1 +
/// 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 52 operations.
template <class Scalar>
Scalar lump_14(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu12 = parameters[3];
  const Scalar alpha22 = parameters[6];
  const Scalar delta22 = parameters[9];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = Scalar(2.0) * omega2 * mu12 * delta24 * per_0 * per_1;
  const Scalar f_1 = -Scalar(2.0) * mu12 * alpha24 * per_0 * per_1 / (Scalar(3.0) * omega2);
  const Scalar f_2 = -Scalar(4.0) * omega2_3 * mu12 * delta22 * per_2 * per_0 * per_3 * per_1;
  const Scalar f_3 = Scalar(2.0) * omega2 * mu12 * alpha22 * per_2 * per_0 * per_3 * per_1;
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3) * per_1;
  const Scalar q_2 = (f_2 + f_3) * per_2;
  const Scalar q_3 = (f_2 + f_3) * per_3;
  gradient[0] = -q_0 - q_1 - q_2 - q_3;  // by omega1
  // by omega2
  gradient[1] = (f_0 - f_1 + Scalar(3.0) * f_2 + f_3) / omega2 - Scalar(2.0) * q_0 + Scalar(2.0) * q_1 - q_2 + q_3;
  const Scalar c_0 = Scalar(2.0) * omega2 * per_2 * per_0 * per_3 * per_1;  // multiplies mu12*alpha22
  const Scalar c_1 = -Scalar(4.0) * omega2_3 * per_2 * per_0 * per_3 * per_1;  // multiplies mu12*delta22
  const Scalar c_2 = -Scalar(2.0) * per_0 * per_1 / (Scalar(3.0) * omega2);  // multiplies mu12*alpha24
  const Scalar c_3 = Scalar(2.0) * omega2 * per_0 * per_1;  // multiplies mu12*delta24
  gradient[3] = alpha22 * c_0 + delta22 * c_1 + alpha24 * c_2 + delta24 * c_3;  // by mu12
  gradient[6] = mu12 * c_0;  // by alpha22
  gradient[9] = mu12 * c_1;  // by delta22
  gradient[25] = mu12 * c_2;  // by alpha24
  gradient[26] = mu12 * c_3;  // by delta24
  return value;
}

/// harmonic_im_v1_A_v12 = (-4*omega1^2*delta22*mu21 + 2*alpha22*mu21)/(3*omega1*(omega1 + omega2)*(omega1 -
/// omega2)) + (2*omega1^2*mu12*delta22 + 2*mu12*alpha22)/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 50 operations.
template <class Scalar>
Scalar lump_15(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu12 = parameters[3];
  const Scalar alpha22 = parameters[6];
  const Scalar delta22 = parameters[9];
  const Scalar mu21 = parameters[23];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = -Scalar(4.0) * omega1 * delta22 * mu21 * per_0 * per_1 / Scalar(3.0);
  const Scalar f_1 = Scalar(2.0) * alpha22 * mu21 * per_0 * per_1 / (Scalar(3.0) * omega1);
  const Scalar f_2 = Scalar(2.0) * omega1 * mu12 * delta22 * per_2 * per_3 / Scalar(3.0);
  const Scalar f_3 = Scalar(2.0) * mu12 * alpha22 * per_2 * per_3 / (Scalar(3.0) * omega1);
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1) * per_0;
  const Scalar q_1 = (f_0 + f_1) * per_1;
  const Scalar q_2 = (f_2 + f_3) * per_2;
  const Scalar q_3 = (f_2 + f_3) * per_3;
  gradient[0] = (f_0 - f_1 + f_2 - f_3) / omega1 - q_0 - q_1 - Scalar(2.0) * q_2 - Scalar(2.0) * q_3;  // by omega1
  gradient[1] = -q_0 + q_1 - q_2 + q_3;  // by omega2
  const Scalar c_0 = Scalar(2.0) * per_2 * per_3 / (Scalar(3.0) * omega1);  // multiplies mu12*alpha22
  const Scalar c_1 = Scalar(2.0) * omega1 * per_2 * per_3 / Scalar(3.0);  // multiplies mu12*delta22
  const Scalar c_2 = Scalar(2.0) * per_0 * per_1 / (Scalar(3.0) * omega1);  // multiplies alpha22*mu21
  const Scalar c_3 = -Scalar(4.0) * omega1 * per_0 * per_1 / Scalar(3.0);  // multiplies delta22*mu21
  gradient[3] = alpha22 * c_0 + delta22 * c_1;  // by mu12
  gradient[6] = mu12 * c_0 + mu21 * c_2;  // by alpha22
  gradient[9] = mu12 * c_1 + mu21 * c_3;  // by delta22
  gradient[23] = alpha22 * c_2 + delta22 * c_3;  // by mu21
  return value;
}

/// harmonic_re_v1_A_v1_A_v2 = (-2*omega1^2*delta22 - 2*omega1*omega2*delta22 + 2*alpha22)/(omega2*(2*omega1 +
/// omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 21 operations.
template <class Scalar>
Scalar lump_16(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar delta22 = parameters[9];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar f_0 = -Scalar(2.0) * omega1_2 * delta22 * per_0 / omega2;
  const Scalar f_1 = -Scalar(2.0) * omega1 * delta22 * per_0;
  const Scalar f_2 = Scalar(2.0) * alpha22 * per_0 / omega2;
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2) * per_0;
  gradient[0] = (Scalar(2.0) * f_0 + f_1) / omega1 - Scalar(2.0) * q_0;  // by omega1
  gradient[1] = (-f_0 - f_2) / omega2 - q_0;  // by omega2
  const Scalar c_0 = Scalar(2.0) * per_0 / omega2;  // multiplies alpha22
  // multiplies delta22
  const Scalar c_1 = (-Scalar(2.0) * omega1_2 - Scalar(2.0) * omega1 * omega2) * per_0 / omega2;
  gradient[6] = c_0;  // by alpha22
  gradient[9] = c_1;  // by delta22
  return value;
}

/// harmonic_im_v1_A_v1_A_v2 = (-2*omega1^2*omega2*mu12*delta23 - 4*omega1*omega2^2*mu12*delta23 +
/// 2*omega1*mu12*alpha23 - 2*omega2^3*mu12*delta23 + 2*omega2*mu12*alpha23)/(omega1*omega2*(omega1 +
/// 2*omega2)*(2*omega1 + omega2)) + (2*omega1^2*omega2*mu12*delta21 + 2*omega1^2*omega2*delta23*mu21 +
/// 2*omega1*omega2^2*mu12*delta21 + 2*omega1*alpha23*mu21 + 2*omega2^3*mu12*delta21 -
/// 2*omega2*mu12*alpha21)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 108 operations.
template <class Scalar>
Scalar lump_17(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu12 = parameters[3];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha23 = parameters[7];
  const Scalar delta21 = parameters[8];
  const Scalar delta23 = parameters[10];
  const Scalar mu21 = parameters[23];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -Scalar(2.0) * omega1 * mu12 * delta23 * per_0 * per_1;
  const Scalar f_1 = -Scalar(4.0) * omega2 * mu12 * delta23 * per_0 * per_1;
  const Scalar f_2 = Scalar(2.0) * mu12 * alpha23 * per_0 * per_1 / omega2;
  const Scalar f_3 = -Scalar(2.0) * omega2_2 * mu12 * delta23 * per_0 * per_1 / omega1;
  const Scalar f_4 = Scalar(2.0) * mu12 * alpha23 * per_0 * per_1 / omega1;
  const Scalar f_5 = (Scalar(2.0) * omega1_2 * mu12 * delta21
      + Scalar(2.0) * omega1_2 * delta23 * mu21) * per_2 * per_3 * per_1;
  const Scalar f_6 = Scalar(2.0) * omega1 * omega2 * mu12 * delta21 * per_2 * per_3 * per_1;
  const Scalar f_7 = Scalar(2.0) * omega1 * alpha23 * mu21 * per_2 * per_3 * per_1 / omega2;
  const Scalar f_8 = Scalar(2.0) * omega2_2 * mu12 * delta21 * per_2 * per_3 * per_1;
  const Scalar f_9 = -Scalar(2.0) * mu12 * alpha21 * per_2 * per_3 * per_1;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_1;
  const Scalar q_2 = (f_5 + f_6 + f_7 + f_8 + f_9) * per_2;
  const Scalar q_3 = (f_5 + f_6 + f_7 + f_8 + f_9) * per_3;
  // by omega1
  gradient[0] = (f_0 - f_3 - f_4 + Scalar(2.0) * f_5 + f_6 + f_7) / omega1 - q_0 - Scalar(2.0) * q_1 - q_2 - q_3;
  // by omega2
  gradient[1] = (f_1 - f_2 + Scalar(2.0) * f_3 + f_6 - f_7 + Scalar(2.0) * f_8) / omega2 - Scalar(2.0) * q_0 - q_1
      - q_2 + q_3;
  const Scalar c_0 = -Scalar(2.0) * per_2 * per_3 * per_1;  // multiplies mu12*alpha21
  // multiplies mu12*alpha23
  const Scalar c_1 = (Scalar(2.0) * omega1 + Scalar(2.0) * omega2) * per_0 * per_1 / (omega1 * omega2);
  // multiplies mu12*delta21
  const Scalar c_2 = (Scalar(2.0) * omega1_2 + Scalar(2.0) * omega1 * omega2
      + Scalar(2.0) * omega2_2) * per_2 * per_3 * per_1;
  // multiplies mu12*delta23
  const Scalar c_3 = (-Scalar(2.0) * omega1_2 - Scalar(4.0) * omega1 * omega2
      - Scalar(2.0) * omega2_2) * per_0 * per_1 / omega1;
  const Scalar c_4 = Scalar(2.0) * omega1 * per_2 * per_3 * per_1 / omega2;  // multiplies alpha23*mu21
  const Scalar c_5 = Scalar(2.0) * omega1_2 * per_2 * per_3 * per_1;  // multiplies delta23*mu21
  gradient[3] = alpha21 * c_0 + alpha23 * c_1 + delta21 * c_2 + delta23 * c_3;  // by mu12
  gradient[5] = mu12 * c_0;  // by alpha21
  gradient[7] = mu12 * c_1 + mu21 * c_4;  // by alpha23
  gradient[8] = mu12 * c_2;  // by delta21
  gradient[10] = mu12 * c_3 + mu21 * c_5;  // by delta23
  gradient[23] = alpha23 * c_4 + delta23 * c_5;  // by mu21
  return value;
}

/// harmonic_re_v1_A_v2_conjA_v12 = (-3*omega1^2*delta32 + 2*omega1*omega2*delta32 + 3*alpha32)/((omega1 -
/// omega2)*(3*omega1 - omega2)) + (-8*omega1^2*omega2*delta22*delta23 + 4*omega1*omega2^2*delta22*delta23 +
/// 4*omega2*alpha22*delta23)/(omega1*(omega1 - 2*omega2)*(3*omega1 - omega2)) + (-36*omega1^6*delta21*delta22 +
/// 120*omega1^5*omega2*delta21*delta22 - 96*omega1^4*omega2^2*delta21*delta22 + 12*omega1^4*alpha21*delta22 +
/// 36*omega1^4*alpha22*delta21 + 24*omega1^3*omega2^3*delta21*delta22 - 28*omega1^3*omega2*alpha21*delta22 -
/// 48*omega1^3*omega2*alpha22*delta21 + 16*omega1^2*omega2^2*alpha21*delta22 +
/// 18*omega1^2*omega2^2*alpha22*delta21 - 12*omega1^2*alpha21*alpha22 - 4*omega1*omega2^3*alpha21*delta22 +
/// 4*omega1*omega2*alpha21*alpha22 - 2*omega2^2*alpha21*alpha22)/(3*omega1^2*omega2*(omega1 - omega2)*(2*omega1
/// - omega2)*(3*omega1 - omega2)) + (-4*omega1^3*omega2*delta22*delta23 -
/// 4*omega1*omega2*alpha22*delta23)/((omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 -
/// omega2)) + (-30*omega1^4*alpha23*delta22 + 12*omega1^3*omega2*alpha23*delta22 +
/// 8*omega1^2*omega2^2*alpha23*delta22 + 18*omega1^2*alpha22*alpha23 - 4*omega1*omega2^3*alpha23*delta22 -
/// 4*omega1*omega2*alpha22*alpha23 - 4*omega2^2*alpha22*alpha23)/(omega1*(omega1 - omega2)*(omega1 -
/// 2*omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 316 operations.
template <class Scalar>
Scalar lump_18(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar alpha32 = parameters[12];
  const Scalar delta32 = parameters[16];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(3.0) * omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar per_4 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar f_0 = -Scalar(3.0) * omega1_2 * delta32 * per_0 * per_1;
  const Scalar f_1 = Scalar(2.0) * omega1 * omega2 * delta32 * per_0 * per_1;
  const Scalar f_2 = Scalar(3.0) * alpha32 * per_0 * per_1;
  const Scalar f_3 = -Scalar(8.0) * omega1 * omega2 * delta22 * delta23 * per_2 * per_1;
  const Scalar f_4 = Scalar(4.0) * omega2_2 * delta22 * delta23 * per_2 * per_1;
  const Scalar f_5 = Scalar(4.0) * omega2 * alpha22 * delta23 * per_2 * per_1 / omega1;
  const Scalar f_6 = -Scalar(12.0) * omega1_4 * delta21 * delta22 * per_0 * per_3 * per_1 / omega2;
  const Scalar f_7 = Scalar(40.0) * omega1_3 * delta21 * delta22 * per_0 * per_3 * per_1;
  const Scalar f_8 = -Scalar(32.0) * omega1_2 * omega2 * delta21 * delta22 * per_0 * per_3 * per_1;
  const Scalar f_9 = (Scalar(4.0) * omega1_2 * alpha21 * delta22
      + Scalar(12.0) * omega1_2 * alpha22 * delta21) * per_0 * per_3 * per_1 / omega2;
  const Scalar f_10 = Scalar(8.0) * omega1 * omega2_2 * delta21 * delta22 * per_0 * per_3 * per_1;
  const Scalar f_11 = (-Scalar(28.0) * omega1 * alpha21 * delta22
      - Scalar(48.0) * omega1 * alpha22 * delta21) * per_0 * per_3 * per_1 / Scalar(3.0);
  const Scalar f_12 = (Scalar(16.0) * omega2 * alpha21 * delta22
      + Scalar(18.0) * omega2 * alpha22 * delta21) * per_0 * per_3 * per_1 / Scalar(3.0);
  const Scalar f_13 = -Scalar(4.0) * alpha21 * alpha22 * per_0 * per_3 * per_1 / omega2;
  const Scalar f_14 = -Scalar(4.0) * omega2_2 * alpha21 * delta22 * per_0 * per_3 * per_1 / (Scalar(3.0) * omega1);
  const Scalar f_15 = Scalar(4.0) * alpha21 * alpha22 * per_0 * per_3 * per_1 / (Scalar(3.0) * omega1);
  const Scalar f_16 = -Scalar(2.0) * omega2 * alpha21 * alpha22 * per_0 * per_3 * per_1 / (Scalar(3.0) * omega1_2);
  const Scalar f_17 = -Scalar(4.0) * omega1_3 * omega2 * delta22 * delta23 * per_0 * per_4 * per_3 * per_1;
  const Scalar f_18 = -Scalar(4.0) * omega1 * omega2 * alpha22 * delta23 * per_0 * per_4 * per_3 * per_1;
  const Scalar f_19 = -Scalar(30.0) * omega1_3 * alpha23 * delta22 * per_0 * per_2 * per_4 * per_3 * per_1;
  const Scalar f_20 = Scalar(12.0) * omega1_2 * omega2 * alpha23 * delta22 * per_0 * per_2 * per_4 * per_3 * per_1;
  const Scalar f_21 = Scalar(8.0) * omega1 * omega2_2 * alpha23 * delta22 * per_0 * per_2 * per_4 * per_3 * per_1;
  const Scalar f_22 = Scalar(18.0) * omega1 * alpha22 * alpha23 * per_0 * per_2 * per_4 * per_3 * per_1;
  const Scalar f_23 = -Scalar(4.0) * omega2_3 * alpha23 * delta22 * per_0 * per_2 * per_4 * per_3 * per_1;
  const Scalar f_24 = -Scalar(4.0) * omega2 * alpha22 * alpha23 * per_0 * per_2 * per_4 * per_3 * per_1;
  const Scalar f_25 = -Scalar(4.0) * omega2_2 * alpha22 * alpha23 * per_0 * per_2 * per_4 * per_3 * per_1 / omega1;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14
      + f_15 + f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14 + f_15 + f_16
      + f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14
      + f_15 + f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_1;
  const Scalar q_2 = (f_3 + f_4 + f_5 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_2;
  const Scalar q_3 = (f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14 + f_15 + f_16 + f_17 + f_18 + f_19
      + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_3;
  const Scalar q_4 = (f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_4;
  // by omega1
  gradient[0] = (Scalar(2.0) * f_0 + f_1 + f_3 - f_5 + Scalar(4.0) * f_6 + Scalar(3.0) * f_7 + Scalar(2.0) * f_8
      + Scalar(2.0) * f_9 + f_10 + f_11 - f_14 - f_15 - Scalar(2.0) * f_16 + Scalar(3.0) * f_17 + f_18
      + Scalar(3.0) * f_19 + Scalar(2.0) * f_20 + f_21 + f_22 - f_25) / omega1 - q_0 - Scalar(3.0) * q_1 - q_2
      - Scalar(2.0) * q_3 - Scalar(2.0) * q_4;
  // by omega2
  gradient[1] = (f_1 + f_3 + Scalar(2.0) * f_4 + f_5 - f_6 + f_8 - f_9 + Scalar(2.0) * f_10 + f_12 - f_13
      + Scalar(2.0) * f_14 + f_16 + f_17 + f_18 + f_20 + Scalar(2.0) * f_21 + Scalar(3.0) * f_23 + f_24
      + Scalar(2.0) * f_25) / omega2 + q_0 + q_1 + Scalar(2.0) * q_2 + q_3 - q_4;
  // multiplies alpha21*alpha22
  const Scalar c_0 = (-Scalar(12.0) * omega1_2 + Scalar(4.0) * omega1 * omega2
      - Scalar(2.0) * omega2_2) * per_0 * per_3 * per_1 / (Scalar(3.0) * omega1_2 * omega2);
  // multiplies alpha21*delta22
  const Scalar c_1 = (Scalar(12.0) * omega1_3 - Scalar(28.0) * omega1_2 * omega2 + Scalar(16.0) * omega1 * omega2_2
      - Scalar(4.0) * omega2_3) * per_0 * per_3 * per_1 / (Scalar(3.0) * omega1 * omega2);
  // multiplies alpha22*alpha23
  const Scalar c_2 = (Scalar(18.0) * omega1_2 - Scalar(4.0) * omega1 * omega2
      - Scalar(4.0) * omega2_2) * per_0 * per_2 * per_4 * per_3 * per_1 / omega1;
  // multiplies alpha22*delta21
  const Scalar c_3 = (Scalar(12.0) * omega1_2 - Scalar(16.0) * omega1 * omega2
      + Scalar(6.0) * omega2_2) * per_0 * per_3 * per_1 / omega2;
  // multiplies alpha22*delta23
  const Scalar c_4 = Scalar(4.0) * omega2 * per_2 * per_1 / omega1
      - Scalar(4.0) * omega1 * omega2 * per_0 * per_4 * per_3 * per_1;
  // multiplies alpha23*delta22
  const Scalar c_5 = (-Scalar(30.0) * omega1_3 + Scalar(12.0) * omega1_2 * omega2 + Scalar(8.0) * omega1 * omega2_2
      - Scalar(4.0) * omega2_3) * per_0 * per_2 * per_4 * per_3 * per_1;
  // multiplies delta21*delta22
  const Scalar c_6 = (-Scalar(12.0) * omega1_4 + Scalar(40.0) * omega1_3 * omega2
      - Scalar(32.0) * omega1_2 * omega2_2 + Scalar(8.0) * omega1 * omega2_3) * per_0 * per_3 * per_1 / omega2;
  // multiplies delta22*delta23
  const Scalar c_7 = (-Scalar(8.0) * omega1 * omega2 + Scalar(4.0) * omega2_2) * per_2 * per_1
      - Scalar(4.0) * omega1_3 * omega2 * per_0 * per_4 * per_3 * per_1;
  const Scalar c_8 = Scalar(3.0) * per_0 * per_1;  // multiplies alpha32
  // multiplies delta32
  const Scalar c_9 = (-Scalar(3.0) * omega1_2 + Scalar(2.0) * omega1 * omega2) * per_0 * per_1;
  gradient[5] = alpha22 * c_0 + delta22 * c_1;  // by alpha21
  gradient[6] = alpha21 * c_0 + alpha23 * c_2 + delta21 * c_3 + delta23 * c_4;  // by alpha22
  gradient[7] = alpha22 * c_2 + delta22 * c_5;  // by alpha23
  gradient[8] = alpha22 * c_3 + delta22 * c_6;  // by delta21
  gradient[9] = alpha21 * c_1 + alpha23 * c_5 + delta21 * c_6 + delta23 * c_7;  // by delta22
  gradient[10] = alpha22 * c_4 + delta22 * c_7;  // by delta23
  gradient[12] = c_8;  // by alpha32
  gradient[16] = c_9;  // by delta32
  return value;
}

/// harmonic_re_v1_A_v22_conjA_v1 = (-6*omega1^2*omega2^2*delta22*delta24 + 3*omega1^2*omega2^2*delta33 +
/// 2*omega1^2*delta22*alpha24 + 12*omega1*omega2^3*delta22*delta24 - 6*omega1*omega2^3*delta33 -
/// 4*omega1*omega2*delta22*alpha24 - 3*omega2^4*delta34 + 6*omega2^2*alpha22*delta24 - 3*omega2^2*alpha33 -
/// 2*alpha22*alpha24)/(12*omega2^3*(omega1 - omega2)) + (omega1*omega2*delta23^2 -
/// omega2^2*delta23^2)/(omega1*(omega1 - 2*omega2)) + (omega1^3*delta22^2 - 3*omega1^2*omega2*delta22^2 +
/// 2*omega1*omega2^2*delta22^2 - 2*omega1*alpha22*delta22 + 2*omega2*alpha22*delta22)/(omega2^2*(2*omega1 -
/// omega2)) - alpha23^2/(omega1*omega2*(omega1 - omega2)*(omega1 - 2*omega2)) + alpha22^2/(omega2^2*(omega1 -
/// omega2)*(2*omega1 - omega2)) + (-omega1^2*omega2^2*delta21*delta23 - omega1^2*alpha23*delta21 +
/// 2*omega1*omega2^3*delta21*delta23 + 2*omega1*omega2*alpha23*delta21 - 4*omega2^4*delta21*delta23 +
/// omega2^2*alpha21*delta23 - 4*omega2^2*alpha23*delta21 + alpha21*alpha23)/(2*omega2*(omega1 +
/// 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 213 operations.
template <class Scalar>
Scalar lump_19(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar alpha33 = parameters[13];
  const Scalar delta33 = parameters[17];
  const Scalar delta34 = parameters[18];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar alpha22_2 = alpha22 * alpha22;
  const Scalar alpha23_2 = alpha23 * alpha23;
  const Scalar delta22_2 = delta22 * delta22;
  const Scalar delta23_2 = delta23 * delta23;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar f_0 = (-Scalar(2.0) * omega1_2 * delta22 * delta24
      + omega1_2 * delta33) * per_0 / (Scalar(4.0) * omega2);
  const Scalar f_1 = omega1_2 * delta22 * alpha24 * per_0 / (Scalar(6.0) * omega2_3);
  const Scalar f_2 = (Scalar(2.0) * omega1 * delta22 * delta24 - omega1 * delta33) * per_0 / Scalar(2.0);
  const Scalar f_3 = -omega1 * delta22 * alpha24 * per_0 / (Scalar(3.0) * omega2_2);
  const Scalar f_4 = -omega2 * delta34 * per_0 / Scalar(4.0);
  const Scalar f_5 = (Scalar(2.0) * alpha22 * delta24 - alpha33) * per_0 / (Scalar(4.0) * omega2);
  const Scalar f_6 = -alpha22 * alpha24 * per_0 / (Scalar(6.0) * omega2_3);
  const Scalar f_7 = omega2 * delta23_2 * per_1;
  const Scalar f_8 = -omega2_2 * delta23_2 * per_1 / omega1;
  const Scalar f_9 = omega1_3 * delta22_2 * per_2 / omega2_2;
  const Scalar f_10 = -Scalar(3.0) * omega1_2 * delta22_2 * per_2 / omega2;
  const Scalar f_11 = Scalar(2.0) * omega1 * delta22_2 * per_2;
  const Scalar f_12 = -Scalar(2.0) * omega1 * alpha22 * delta22 * per_2 / omega2_2;
  const Scalar f_13 = Scalar(2.0) * alpha22 * delta22 * per_2 / omega2;
  const Scalar f_14 = -alpha23_2 * per_0 * per_1 / (omega1 * omega2);
  const Scalar f_15 = alpha22_2 * per_0 * per_2 / omega2_2;
  const Scalar f_16 = -omega1_2 * omega2 * delta21 * delta23 * per_3 * per_0 * per_1 / Scalar(2.0);
  const Scalar f_17 = -omega1_2 * alpha23 * delta21 * per_3 * per_0 * per_1 / (Scalar(2.0) * omega2);
  const Scalar f_18 = omega1 * omega2_2 * delta21 * delta23 * per_3 * per_0 * per_1;
  const Scalar f_19 = omega1 * alpha23 * delta21 * per_3 * per_0 * per_1;
  const Scalar f_20 = -Scalar(2.0) * omega2_3 * delta21 * delta23 * per_3 * per_0 * per_1;
  const Scalar f_21 = (omega2 * alpha21 * delta23
      - Scalar(4.0) * omega2 * alpha23 * delta21) * per_3 * per_0 * per_1 / Scalar(2.0);
  const Scalar f_22 = alpha21 * alpha23 * per_3 * per_0 * per_1 / (Scalar(2.0) * omega2);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14
      + f_15 + f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_14 + f_15 + f_16 + f_17 + f_18 + f_19 + f_20
      + f_21 + f_22) * per_0;
  const Scalar q_1 = (f_7 + f_8 + f_14 + f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22) * per_1;
  const Scalar q_2 = (f_9 + f_10 + f_11 + f_12 + f_13 + f_15) * per_2;
  const Scalar q_3 = (f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22) * per_3;
  // by omega1
  gradient[0] = (Scalar(2.0) * f_0 + Scalar(2.0) * f_1 + f_2 + f_3 - f_8 + Scalar(3.0) * f_9 + Scalar(2.0) * f_10
      + f_11 + f_12 - f_14 + Scalar(2.0) * f_16 + Scalar(2.0) * f_17 + f_18 + f_19) / omega1 - q_0 - q_1
      - Scalar(2.0) * q_2 - q_3;
  // by omega2
  gradient[1] = (-f_0 - Scalar(3.0) * f_1 - Scalar(2.0) * f_3 + f_4 - f_5 - Scalar(3.0) * f_6 + f_7
      + Scalar(2.0) * f_8 - Scalar(2.0) * f_9 - f_10 - Scalar(2.0) * f_12 - f_13 - f_14 - Scalar(2.0) * f_15 + f_16
      - f_17 + Scalar(2.0) * f_18 + Scalar(3.0) * f_20 + f_21 - f_22) / omega2 + q_0 + Scalar(2.0) * q_1 + q_2
      - Scalar(2.0) * q_3;
  const Scalar c_0 = per_3 * per_0 * per_1 / (Scalar(2.0) * omega2);  // multiplies alpha21*alpha23
  const Scalar c_1 = omega2 * per_3 * per_0 * per_1 / Scalar(2.0);  // multiplies alpha21*delta23
  const Scalar c_2 = per_0 * per_2 / omega2_2;  // multiplies alpha22^2
  // multiplies alpha22*delta22
  const Scalar c_3 = (-Scalar(2.0) * omega1 + Scalar(2.0) * omega2) * per_2 / omega2_2;
  const Scalar c_4 = -per_0 / (Scalar(6.0) * omega2_3);  // multiplies alpha22*alpha24
  const Scalar c_5 = per_0 / (Scalar(2.0) * omega2);  // multiplies alpha22*delta24
  const Scalar c_6 = -per_0 * per_1 / (omega1 * omega2);  // multiplies alpha23^2
  // multiplies alpha23*delta21
  const Scalar c_7 = (-omega1_2 + Scalar(2.0) * omega1 * omega2
      - Scalar(4.0) * omega2_2) * per_3 * per_0 * per_1 / (Scalar(2.0) * omega2);
  // multiplies delta21*delta23
  const Scalar c_8 = (-omega1_2 * omega2 + Scalar(2.0) * omega1 * omega2_2
      - Scalar(4.0) * omega2_3) * per_3 * per_0 * per_1 / Scalar(2.0);
  // multiplies delta22^2
  const Scalar c_9 = (omega1_3 - Scalar(3.0) * omega1_2 * omega2
      + Scalar(2.0) * omega1 * omega2_2) * per_2 / omega2_2;
  // multiplies delta22*alpha24
  const Scalar c_10 = (omega1_2 - Scalar(2.0) * omega1 * omega2) * per_0 / (Scalar(6.0) * omega2_3);
  // multiplies delta22*delta24
  const Scalar c_11 = (-omega1_2 + Scalar(2.0) * omega1 * omega2) * per_0 / (Scalar(2.0) * omega2);
  const Scalar c_12 = (omega1 * omega2 - omega2_2) * per_1 / omega1;  // multiplies delta23^2
  const Scalar c_13 = -per_0 / (Scalar(4.0) * omega2);  // multiplies alpha33
  // multiplies delta33
  const Scalar c_14 = (omega1_2 - Scalar(2.0) * omega1 * omega2) * per_0 / (Scalar(4.0) * omega2);
  const Scalar c_15 = -omega2 * per_0 / Scalar(4.0);  // multiplies delta34
  gradient[5] = alpha23 * c_0 + delta23 * c_1;  // by alpha21
  gradient[6] = Scalar(2.0) * alpha22 * c_2 + delta22 * c_3 + alpha24 * c_4 + delta24 * c_5;  // by alpha22
  gradient[7] = alpha21 * c_0 + Scalar(2.0) * alpha23 * c_6 + delta21 * c_7;  // by alpha23
  gradient[8] = alpha23 * c_7 + delta23 * c_8;  // by delta21
  gradient[9] = alpha22 * c_3 + Scalar(2.0) * delta22 * c_9 + alpha24 * c_10 + delta24 * c_11;  // by delta22
  gradient[10] = alpha21 * c_1 + delta21 * c_8 + Scalar(2.0) * delta23 * c_12;  // by delta23
  gradient[13] = c_13;  // by alpha33
  gradient[17] = c_14;  // by delta33
  gradient[18] = c_15;  // by delta34
  gradient[25] = alpha22 * c_4 + delta22 * c_10;  // by alpha24
  gradient[26] = alpha22 * c_5 + delta22 * c_11;  // by delta24
  return value;
}

/// harmonic_re_v1_A_v22_F = -delta23*eta22/(4*omega1*(omega1 - 2*omega2)) +
/// alpha23*eta22/(4*omega1*omega2*(omega1 - omega2)*(omega1 - 2*omega2)) + (-omega2^2*delta23*eta12 -
/// alpha23*eta12)/(8*omega2*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 47 operations.
template <class Scalar>
Scalar lump_20(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha23 = parameters[7];
  const Scalar delta23 = parameters[10];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar per_0 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar f_0 = -delta23 * eta22 * per_0 / (Scalar(4.0) * omega1);
  const Scalar f_1 = alpha23 * eta22 * per_1 * per_0 / (Scalar(4.0) * omega1 * omega2);
  const Scalar f_2 = -omega2 * delta23 * eta12 * per_2 * per_1 * per_0 / Scalar(8.0);
  const Scalar f_3 = -alpha23 * eta12 * per_2 * per_1 * per_0 / (Scalar(8.0) * omega2);
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = (f_1 + f_2 + f_3) * per_1;
  const Scalar q_2 = (f_2 + f_3) * per_2;
  gradient[0] = (-f_0 - f_1) / omega1 - q_0 - q_1 - q_2;  // by omega1
  gradient[1] = (-f_1 + f_2 - f_3) / omega2 + Scalar(2.0) * q_0 + q_1 - Scalar(2.0) * q_2;  // by omega2
  const Scalar c_0 = -per_2 * per_1 * per_0 / (Scalar(8.0) * omega2);  // multiplies alpha23*eta12
  const Scalar c_1 = per_1 * per_0 / (Scalar(4.0) * omega1 * omega2);  // multiplies alpha23*eta22
  const Scalar c_2 = -omega2 * per_2 * per_1 * per_0 / Scalar(8.0);  // multiplies delta23*eta12
  const Scalar c_3 = -per_0 / (Scalar(4.0) * omega1);  // multiplies delta23*eta22
  gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
  gradient[10] = eta12 * c_2 + eta22 * c_3;  // by delta23
  gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
  gradient[30] = alpha23 * c_1 + delta23 * c_3;  // by eta22
  return value;
}

/// harmonic_re_v1_A_v1_A_v22 = (6*omega1^2*omega2^2*delta22*delta24 - 3*omega1^2*omega2^2*delta33 -
/// 2*omega1^2*delta22*alpha24 + 12*omega1*omega2^3*delta22*delta24 - 6*omega1*omega2^3*delta33 -
/// 4*omega1*omega2*delta22*alpha24 + 3*omega2^4*delta34 - 6*omega2^2*alpha22*delta24 + 3*omega2^2*alpha33 +
/// 2*alpha22*alpha24)/(12*omega2^3*(omega1 + omega2)) + (-omega1*omega2*delta23^2 -
/// omega2^2*delta23^2)/(omega1*(omega1 + 2*omega2)) + (omega1^3*delta22^2 + 3*omega1^2*omega2*delta22^2 +
/// 2*omega1*omega2^2*delta22^2 - 2*omega1*alpha22*delta22 - 2*omega2*alpha22*delta22)/(omega2^2*(2*omega1 +
/// omega2)) + alpha23^2/(omega1*omega2*(omega1 + omega2)*(omega1 + 2*omega2)) + alpha22^2/(omega2^2*(omega1 +
/// omega2)*(2*omega1 + omega2)) + (omega1^2*omega2^2*delta21*delta23 + omega1^2*alpha23*delta21 +
/// 2*omega1*omega2^3*delta21*delta23 + 2*omega1*omega2*alpha23*delta21 + 4*omega2^4*delta21*delta23 -
/// omega2^2*alpha21*delta23 + 4*omega2^2*alpha23*delta21 - alpha21*alpha23)/(2*omega2*(omega1 + omega2)*(omega1
/// + 2*omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 213 operations.
template <class Scalar>
Scalar lump_21(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar alpha33 = parameters[13];
  const Scalar delta33 = parameters[17];
  const Scalar delta34 = parameters[18];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar alpha22_2 = alpha22 * alpha22;
  const Scalar alpha23_2 = alpha23 * alpha23;
  const Scalar delta22_2 = delta22 * delta22;
  const Scalar delta23_2 = delta23 * delta23;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = (Scalar(2.0) * omega1_2 * delta22 * delta24
      - omega1_2 * delta33) * per_0 / (Scalar(4.0) * omega2);
  const Scalar f_1 = -omega1_2 * delta22 * alpha24 * per_0 / (Scalar(6.0) * omega2_3);
  const Scalar f_2 = (Scalar(2.0) * omega1 * delta22 * delta24 - omega1 * delta33) * per_0 / Scalar(2.0);
  const Scalar f_3 = -omega1 * delta22 * alpha24 * per_0 / (Scalar(3.0) * omega2_2);
  const Scalar f_4 = omega2 * delta34 * per_0 / Scalar(4.0);
  const Scalar f_5 = (-Scalar(2.0) * alpha22 * delta24 + alpha33) * per_0 / (Scalar(4.0) * omega2);
  const Scalar f_6 = alpha22 * alpha24 * per_0 / (Scalar(6.0) * omega2_3);
  const Scalar f_7 = -omega2 * delta23_2 * per_1;
  const Scalar f_8 = -omega2_2 * delta23_2 * per_1 / omega1;
  const Scalar f_9 = omega1_3 * delta22_2 * per_2 / omega2_2;
  const Scalar f_10 = Scalar(3.0) * omega1_2 * delta22_2 * per_2 / omega2;
  const Scalar f_11 = Scalar(2.0) * omega1 * delta22_2 * per_2;
  const Scalar f_12 = -Scalar(2.0) * omega1 * alpha22 * delta22 * per_2 / omega2_2;
  const Scalar f_13 = -Scalar(2.0) * alpha22 * delta22 * per_2 / omega2;
  const Scalar f_14 = alpha23_2 * per_0 * per_1 / (omega1 * omega2);
  const Scalar f_15 = alpha22_2 * per_0 * per_2 / omega2_2;
  const Scalar f_16 = omega1_2 * omega2 * delta21 * delta23 * per_0 * per_1 * per_3 / Scalar(2.0);
  const Scalar f_17 = omega1_2 * alpha23 * delta21 * per_0 * per_1 * per_3 / (Scalar(2.0) * omega2);
  const Scalar f_18 = omega1 * omega2_2 * delta21 * delta23 * per_0 * per_1 * per_3;
  const Scalar f_19 = omega1 * alpha23 * delta21 * per_0 * per_1 * per_3;
  const Scalar f_20 = Scalar(2.0) * omega2_3 * delta21 * delta23 * per_0 * per_1 * per_3;
  const Scalar f_21 = (-omega2 * alpha21 * delta23
      + Scalar(4.0) * omega2 * alpha23 * delta21) * per_0 * per_1 * per_3 / Scalar(2.0);
  const Scalar f_22 = -alpha21 * alpha23 * per_0 * per_1 * per_3 / (Scalar(2.0) * omega2);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14
      + f_15 + f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_14 + f_15 + f_16 + f_17 + f_18 + f_19 + f_20
      + f_21 + f_22) * per_0;
  const Scalar q_1 = (f_7 + f_8 + f_14 + f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22) * per_1;
  const Scalar q_2 = (f_9 + f_10 + f_11 + f_12 + f_13 + f_15) * per_2;
  const Scalar q_3 = (f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22) * per_3;
  // by omega1
  gradient[0] = (Scalar(2.0) * f_0 + Scalar(2.0) * f_1 + f_2 + f_3 - f_8 + Scalar(3.0) * f_9 + Scalar(2.0) * f_10
      + f_11 + f_12 - f_14 + Scalar(2.0) * f_16 + Scalar(2.0) * f_17 + f_18 + f_19) / omega1 - q_0 - q_1
      - Scalar(2.0) * q_2 - q_3;
  // by omega2
  gradient[1] = (-f_0 - Scalar(3.0) * f_1 - Scalar(2.0) * f_3 + f_4 - f_5 - Scalar(3.0) * f_6 + f_7
      + Scalar(2.0) * f_8 - Scalar(2.0) * f_9 - f_10 - Scalar(2.0) * f_12 - f_13 - f_14 - Scalar(2.0) * f_15 + f_16
      - f_17 + Scalar(2.0) * f_18 + Scalar(3.0) * f_20 + f_21 - f_22) / omega2 - q_0 - Scalar(2.0) * q_1 - q_2
      + Scalar(2.0) * q_3;
  const Scalar c_0 = -per_0 * per_1 * per_3 / (Scalar(2.0) * omega2);  // multiplies alpha21*alpha23
  const Scalar c_1 = -omega2 * per_0 * per_1 * per_3 / Scalar(2.0);  // multiplies alpha21*delta23
  const Scalar c_2 = per_0 * per_2 / omega2_2;  // multiplies alpha22^2
  // multiplies alpha22*delta22
  const Scalar c_3 = (-Scalar(2.0) * omega1 - Scalar(2.0) * omega2) * per_2 / omega2_2;
  const Scalar c_4 = per_0 / (Scalar(6.0) * omega2_3);  // multiplies alpha22*alpha24
  const Scalar c_5 = -per_0 / (Scalar(2.0) * omega2);  // multiplies alpha22*delta24
  const Scalar c_6 = per_0 * per_1 / (omega1 * omega2);  // multiplies alpha23^2
  // multiplies alpha23*delta21
  const Scalar c_7 = (omega1_2 + Scalar(2.0) * omega1 * omega2
      + Scalar(4.0) * omega2_2) * per_0 * per_1 * per_3 / (Scalar(2.0) * omega2);
  // multiplies delta21*delta23
  const Scalar c_8 = (omega1_2 * omega2 + Scalar(2.0) * omega1 * omega2_2
      + Scalar(4.0) * omega2_3) * per_0 * per_1 * per_3 / Scalar(2.0);
  // multiplies delta22^2
  const Scalar c_9 = (omega1_3 + Scalar(3.0) * omega1_2 * omega2
      + Scalar(2.0) * omega1 * omega2_2) * per_2 / omega2_2;
  // multiplies delta22*alpha24
  const Scalar c_10 = (-omega1_2 - Scalar(2.0) * omega1 * omega2) * per_0 / (Scalar(6.0) * omega2_3);
  // multiplies delta22*delta24
  const Scalar c_11 = (omega1_2 + Scalar(2.0) * omega1 * omega2) * per_0 / (Scalar(2.0) * omega2);
  const Scalar c_12 = (-omega1 * omega2 - omega2_2) * per_1 / omega1;  // multiplies delta23^2
  const Scalar c_13 = per_0 / (Scalar(4.0) * omega2);  // multiplies alpha33
  // multiplies delta33
  const Scalar c_14 = (-omega1_2 - Scalar(2.0) * omega1 * omega2) * per_0 / (Scalar(4.0) * omega2);
  const Scalar c_15 = omega2 * per_0 / Scalar(4.0);  // multiplies delta34
  gradient[5] = alpha23 * c_0 + delta23 * c_1;  // by alpha21
  gradient[6] = Scalar(2.0) * alpha22 * c_2 + delta22 * c_3 + alpha24 * c_4 + delta24 * c_5;  // by alpha22
  gradient[7] = alpha21 * c_0 + Scalar(2.0) * alpha23 * c_6 + delta21 * c_7;  // by alpha23
  gradient[8] = alpha23 * c_7 + delta23 * c_8;  // by delta21
  gradient[9] = alpha22 * c_3 + Scalar(2.0) * delta22 * c_9 + alpha24 * c_10 + delta24 * c_11;  // by delta22
  gradient[10] = alpha21 * c_1 + delta21 * c_8 + Scalar(2.0) * delta23 * c_12;  // by delta23
  gradient[13] = c_13;  // by alpha33
  gradient[17] = c_14;  // by delta33
  gradient[18] = c_15;  // by delta34
  gradient[25] = alpha22 * c_4 + delta22 * c_10;  // by alpha24
  gradient[26] = alpha22 * c_5 + delta22 * c_11;  // by delta24
  return value;
}

/// harmonic_re_v1_A_v23 = (12*omega2^4*delta23*delta24 - 3*omega2^4*delta35 + 6*omega2^2*alpha23*delta24 -
/// 4*omega2^2*delta23*alpha24 - 3*omega2^2*alpha34 - 2*alpha23*alpha24)/(3*omega2^2*(omega1 + 3*omega2)*(omega1
/// - 3*omega2)) + (-12*omega2^4*delta22*delta23 + 2*omega2^2*alpha22*delta23 - 12*omega2^2*alpha23*delta22 +
/// 2*alpha22*alpha23)/((omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 94 operations.
template <class Scalar>
Scalar lump_22(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar alpha34 = parameters[14];
  const Scalar delta35 = parameters[19];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(3.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(3.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = (Scalar(4.0) * omega2_2 * delta23 * delta24 - omega2_2 * delta35) * per_0 * per_1;
  const Scalar f_1 = (Scalar(6.0) * alpha23 * delta24 - Scalar(4.0) * delta23 * alpha24
      - Scalar(3.0) * alpha34) * per_0 * per_1 / Scalar(3.0);
  const Scalar f_2 = -Scalar(2.0) * alpha23 * alpha24 * per_0 * per_1 / (Scalar(3.0) * omega2_2);
  const Scalar f_3 = -Scalar(12.0) * omega2_4 * delta22 * delta23 * per_2 * per_0 * per_3 * per_1;
  const Scalar f_4 = (Scalar(2.0) * omega2_2 * alpha22 * delta23
      - Scalar(12.0) * omega2_2 * alpha23 * delta22) * per_2 * per_0 * per_3 * per_1;
  const Scalar f_5 = Scalar(2.0) * alpha22 * alpha23 * per_2 * per_0 * per_3 * per_1;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_1;
  const Scalar q_2 = (f_3 + f_4 + f_5) * per_2;
  const Scalar q_3 = (f_3 + f_4 + f_5) * per_3;
  gradient[0] = -q_0 - q_1 - q_2 - q_3;  // by omega1
  // by omega2
  gradient[1] = (Scalar(2.0) * f_0 - Scalar(2.0) * f_2 + Scalar(4.0) * f_3 + Scalar(2.0) * f_4) / omega2
      - Scalar(3.0) * q_0 + Scalar(3.0) * q_1 - Scalar(2.0) * q_2 + Scalar(2.0) * q_3;
  const Scalar c_0 = Scalar(2.0) * per_2 * per_0 * per_3 * per_1;  // multiplies alpha22*alpha23
  const Scalar c_1 = Scalar(2.0) * omega2_2 * per_2 * per_0 * per_3 * per_1;  // multiplies alpha22*delta23
  const Scalar c_2 = -Scalar(12.0) * omega2_2 * per_2 * per_0 * per_3 * per_1;  // multiplies alpha23*delta22
  const Scalar c_3 = -Scalar(2.0) * per_0 * per_1 / (Scalar(3.0) * omega2_2);  // multiplies alpha23*alpha24
  const Scalar c_4 = Scalar(2.0) * per_0 * per_1;  // multiplies alpha23*delta24
  const Scalar c_5 = -Scalar(12.0) * omega2_4 * per_2 * per_0 * per_3 * per_1;  // multiplies delta22*delta23
  const Scalar c_6 = -Scalar(4.0) * per_0 * per_1 / Scalar(3.0);  // multiplies delta23*alpha24
  const Scalar c_7 = Scalar(4.0) * omega2_2 * per_0 * per_1;  // multiplies delta23*delta24
  const Scalar c_8 = -per_0 * per_1;  // multiplies alpha34
  const Scalar c_9 = -omega2_2 * per_0 * per_1;  // multiplies delta35
  gradient[6] = alpha23 * c_0 + delta23 * c_1;  // by alpha22
  gradient[7] = alpha22 * c_0 + delta22 * c_2 + alpha24 * c_3 + delta24 * c_4;  // by alpha23
  gradient[9] = alpha23 * c_2 + delta23 * c_5;  // by delta22
  gradient[10] = alpha22 * c_1 + delta22 * c_5 + alpha24 * c_6 + delta24 * c_7;  // by delta23
  gradient[14] = c_8;  // by alpha34
  gradient[19] = c_9;  // by delta35
  gradient[25] = alpha23 * c_3 + delta23 * c_6;  // by alpha24
  gradient[26] = alpha23 * c_4 + delta23 * c_7;  // by delta24
  return value;
}

/// harmonic_re_v1_A_v13 = (42*omega1^4*delta21^2 - 6*omega1^4*delta31 - 20*omega1^2*alpha21*delta21 +
/// 3*omega1^2*alpha31 + 2*alpha21^2)/(24*omega1^4) + (-3*omega1^4*delta22^2 - 2*omega1^2*alpha22*delta22 +
/// alpha22^2)/(4*omega1^2*(2*omega1 + omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 53 operations.
template <class Scalar>
Scalar lump_23(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar alpha31 = parameters[11];
  const Scalar delta31 = parameters[15];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar alpha21_2 = alpha21 * alpha21;
  const Scalar alpha22_2 = alpha22 * alpha22;
  const Scalar delta21_2 = delta21 * delta21;
  const Scalar delta22_2 = delta22 * delta22;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = (Scalar(7.0) * delta21_2 - delta31) / Scalar(4.0);
  const Scalar f_1 = (-Scalar(20.0) * alpha21 * delta21 + Scalar(3.0) * alpha31) / (Scalar(24.0) * omega1_2);
  const Scalar f_2 = alpha21_2 / (Scalar(12.0) * omega1_4);
  const Scalar f_3 = -Scalar(3.0) * omega1_2 * delta22_2 * per_0 * per_1 / Scalar(4.0);
  const Scalar f_4 = -alpha22 * delta22 * per_0 * per_1 / Scalar(2.0);
  const Scalar f_5 = alpha22_2 * per_0 * per_1 / (Scalar(4.0) * omega1_2);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_3 + f_4 + f_5) * per_0;
  const Scalar q_1 = (f_3 + f_4 + f_5) * per_1;
  // by omega1
  gradient[0] = (-Scalar(2.0) * f_1 - Scalar(4.0) * f_2 + Scalar(2.0) * f_3 - Scalar(2.0) * f_5) / omega1
      - Scalar(2.0) * q_0 - Scalar(2.0) * q_1;
  gradient[1] = -q_0 + q_1;  // by omega2
  const Scalar c_0 = Scalar(1.0) / (Scalar(12.0) * omega1_4);  // multiplies alpha21^2
  const Scalar c_1 = -Scalar(5.0) / (Scalar(6.0) * omega1_2);  // multiplies alpha21*delta21
  const Scalar c_2 = per_0 * per_1 / (Scalar(4.0) * omega1_2);  // multiplies alpha22^2
  const Scalar c_3 = -per_0 * per_1 / Scalar(2.0);  // multiplies alpha22*delta22
  const Scalar c_4 = Scalar(7.0) / Scalar(4.0);  // multiplies delta21^2
  const Scalar c_5 = -Scalar(3.0) * omega1_2 * per_0 * per_1 / Scalar(4.0);  // multiplies delta22^2
  const Scalar c_6 = Scalar(1.0) / (Scalar(8.0) * omega1_2);  // multiplies alpha31
  const Scalar c_7 = -Scalar(1.0) / Scalar(4.0);  // multiplies delta31
  gradient[5] = Scalar(2.0) * alpha21 * c_0 + delta21 * c_1;  // by alpha21
  gradient[6] = Scalar(2.0) * alpha22 * c_2 + delta22 * c_3;  // by alpha22
  gradient[8] = alpha21 * c_1 + Scalar(2.0) * delta21 * c_4;  // by delta21
  gradient[9] = alpha22 * c_3 + Scalar(2.0) * delta22 * c_5;  // by delta22
  gradient[11] = c_6;  // by alpha31
  gradient[15] = c_7;  // by delta31
  return value;
}

/// harmonic_re_v1_A_v12_A_v2 = (-3*omega1^2*delta32 - 2*omega1*omega2*delta32 + 3*alpha32)/((omega1 +
/// omega2)*(3*omega1 + omega2)) + (8*omega1^2*omega2*delta22*delta23 + 4*omega1*omega2^2*delta22*delta23 -
/// 4*omega2*alpha22*delta23)/(omega1*(omega1 + 2*omega2)*(3*omega1 + omega2)) + (36*omega1^6*delta21*delta22 +
/// 120*omega1^5*omega2*delta21*delta22 + 96*omega1^4*omega2^2*delta21*delta22 - 12*omega1^4*alpha21*delta22 -
/// 36*omega1^4*alpha22*delta21 + 24*omega1^3*omega2^3*delta21*delta22 - 28*omega1^3*omega2*alpha21*delta22 -
/// 48*omega1^3*omega2*alpha22*delta21 - 16*omega1^2*omega2^2*alpha21*delta22 -
/// 18*omega1^2*omega2^2*alpha22*delta21 + 12*omega1^2*alpha21*alpha22 - 4*omega1*omega2^3*alpha21*delta22 +
/// 4*omega1*omega2*alpha21*alpha22 + 2*omega2^2*alpha21*alpha22)/(3*omega1^2*omega2*(omega1 + omega2)*(2*omega1
/// + omega2)*(3*omega1 + omega2)) + (4*omega1^3*omega2*delta22*delta23 +
/// 4*omega1*omega2*alpha22*delta23)/((omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 +
/// omega2)) + (-30*omega1^4*alpha23*delta22 - 12*omega1^3*omega2*alpha23*delta22 +
/// 8*omega1^2*omega2^2*alpha23*delta22 + 18*omega1^2*alpha22*alpha23 + 4*omega1*omega2^3*alpha23*delta22 +
/// 4*omega1*omega2*alpha22*alpha23 - 4*omega2^2*alpha22*alpha23)/(omega1*(omega1 + omega2)*(omega1 +
/// 2*omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 316 operations.
template <class Scalar>
Scalar lump_24(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar alpha32 = parameters[12];
  const Scalar delta32 = parameters[16];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(3.0) * omega1 + omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_4 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = -Scalar(3.0) * omega1_2 * delta32 * per_0 * per_1;
  const Scalar f_1 = -Scalar(2.0) * omega1 * omega2 * delta32 * per_0 * per_1;
  const Scalar f_2 = Scalar(3.0) * alpha32 * per_0 * per_1;
  const Scalar f_3 = Scalar(8.0) * omega1 * omega2 * delta22 * delta23 * per_2 * per_1;
  const Scalar f_4 = Scalar(4.0) * omega2_2 * delta22 * delta23 * per_2 * per_1;
  const Scalar f_5 = -Scalar(4.0) * omega2 * alpha22 * delta23 * per_2 * per_1 / omega1;
  const Scalar f_6 = Scalar(12.0) * omega1_4 * delta21 * delta22 * per_0 * per_3 * per_1 / omega2;
  const Scalar f_7 = Scalar(40.0) * omega1_3 * delta21 * delta22 * per_0 * per_3 * per_1;
  const Scalar f_8 = Scalar(32.0) * omega1_2 * omega2 * delta21 * delta22 * per_0 * per_3 * per_1;
  const Scalar f_9 = (-Scalar(4.0) * omega1_2 * alpha21 * delta22
      - Scalar(12.0) * omega1_2 * alpha22 * delta21) * per_0 * per_3 * per_1 / omega2;
  const Scalar f_10 = Scalar(8.0) * omega1 * omega2_2 * delta21 * delta22 * per_0 * per_3 * per_1;
  const Scalar f_11 = (-Scalar(28.0) * omega1 * alpha21 * delta22
      - Scalar(48.0) * omega1 * alpha22 * delta21) * per_0 * per_3 * per_1 / Scalar(3.0);
  const Scalar f_12 = (-Scalar(16.0) * omega2 * alpha21 * delta22
      - Scalar(18.0) * omega2 * alpha22 * delta21) * per_0 * per_3 * per_1 / Scalar(3.0);
  const Scalar f_13 = Scalar(4.0) * alpha21 * alpha22 * per_0 * per_3 * per_1 / omega2;
  const Scalar f_14 = -Scalar(4.0) * omega2_2 * alpha21 * delta22 * per_0 * per_3 * per_1 / (Scalar(3.0) * omega1);
  const Scalar f_15 = Scalar(4.0) * alpha21 * alpha22 * per_0 * per_3 * per_1 / (Scalar(3.0) * omega1);
  const Scalar f_16 = Scalar(2.0) * omega2 * alpha21 * alpha22 * per_0 * per_3 * per_1 / (Scalar(3.0) * omega1_2);
  const Scalar f_17 = Scalar(4.0) * omega1_3 * omega2 * delta22 * delta23 * per_0 * per_3 * per_4 * per_1;
  const Scalar f_18 = Scalar(4.0) * omega1 * omega2 * alpha22 * delta23 * per_0 * per_3 * per_4 * per_1;
  const Scalar f_19 = -Scalar(30.0) * omega1_3 * alpha23 * delta22 * per_0 * per_2 * per_3 * per_4 * per_1;
  const Scalar f_20 = -Scalar(12.0) * omega1_2 * omega2 * alpha23 * delta22 * per_0 * per_2 * per_3 * per_4 * per_1;
  const Scalar f_21 = Scalar(8.0) * omega1 * omega2_2 * alpha23 * delta22 * per_0 * per_2 * per_3 * per_4 * per_1;
  const Scalar f_22 = Scalar(18.0) * omega1 * alpha22 * alpha23 * per_0 * per_2 * per_3 * per_4 * per_1;
  const Scalar f_23 = Scalar(4.0) * omega2_3 * alpha23 * delta22 * per_0 * per_2 * per_3 * per_4 * per_1;
  const Scalar f_24 = Scalar(4.0) * omega2 * alpha22 * alpha23 * per_0 * per_2 * per_3 * per_4 * per_1;
  const Scalar f_25 = -Scalar(4.0) * omega2_2 * alpha22 * alpha23 * per_0 * per_2 * per_3 * per_4 * per_1 / omega1;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14
      + f_15 + f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14 + f_15 + f_16
      + f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14
      + f_15 + f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_1;
  const Scalar q_2 = (f_3 + f_4 + f_5 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_2;
  const Scalar q_3 = (f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14 + f_15 + f_16 + f_17 + f_18 + f_19
      + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_3;
  const Scalar q_4 = (f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_4;
  // by omega1
  gradient[0] = (Scalar(2.0) * f_0 + f_1 + f_3 - f_5 + Scalar(4.0) * f_6 + Scalar(3.0) * f_7 + Scalar(2.0) * f_8
      + Scalar(2.0) * f_9 + f_10 + f_11 - f_14 - f_15 - Scalar(2.0) * f_16 + Scalar(3.0) * f_17 + f_18
      + Scalar(3.0) * f_19 + Scalar(2.0) * f_20 + f_21 + f_22 - f_25) / omega1 - q_0 - Scalar(3.0) * q_1 - q_2
      - Scalar(2.0) * q_3 - Scalar(2.0) * q_4;
  // by omega2
  gradient[1] = (f_1 + f_3 + Scalar(2.0) * f_4 + f_5 - f_6 + f_8 - f_9 + Scalar(2.0) * f_10 + f_12 - f_13
      + Scalar(2.0) * f_14 + f_16 + f_17 + f_18 + f_20 + Scalar(2.0) * f_21 + Scalar(3.0) * f_23 + f_24
      + Scalar(2.0) * f_25) / omega2 - q_0 - q_1 - Scalar(2.0) * q_2 - q_3 + q_4;
  // multiplies alpha21*alpha22
  const Scalar c_0 = (Scalar(12.0) * omega1_2 + Scalar(4.0) * omega1 * omega2
      + Scalar(2.0) * omega2_2) * per_0 * per_3 * per_1 / (Scalar(3.0) * omega1_2 * omega2);
  // multiplies alpha21*delta22
  const Scalar c_1 = (-Scalar(12.0) * omega1_3 - Scalar(28.0) * omega1_2 * omega2 - Scalar(16.0) * omega1 * omega2_2
      - Scalar(4.0) * omega2_3) * per_0 * per_3 * per_1 / (Scalar(3.0) * omega1 * omega2);
  // multiplies alpha22*alpha23
  const Scalar c_2 = (Scalar(18.0) * omega1_2 + Scalar(4.0) * omega1 * omega2
      - Scalar(4.0) * omega2_2) * per_0 * per_2 * per_3 * per_4 * per_1 / omega1;
  // multiplies alpha22*delta21
  const Scalar c_3 = (-Scalar(12.0) * omega1_2 - Scalar(16.0) * omega1 * omega2
      - Scalar(6.0) * omega2_2) * per_0 * per_3 * per_1 / omega2;
  // multiplies alpha22*delta23
  const Scalar c_4 = -Scalar(4.0) * omega2 * per_2 * per_1 / omega1
      + Scalar(4.0) * omega1 * omega2 * per_0 * per_3 * per_4 * per_1;
  // multiplies alpha23*delta22
  const Scalar c_5 = (-Scalar(30.0) * omega1_3 - Scalar(12.0) * omega1_2 * omega2 + Scalar(8.0) * omega1 * omega2_2
      + Scalar(4.0) * omega2_3) * per_0 * per_2 * per_3 * per_4 * per_1;
  // multiplies delta21*delta22
  const Scalar c_6 = (Scalar(12.0) * omega1_4 + Scalar(40.0) * omega1_3 * omega2
      + Scalar(32.0) * omega1_2 * omega2_2 + Scalar(8.0) * omega1 * omega2_3) * per_0 * per_3 * per_1 / omega2;
  // multiplies delta22*delta23
  const Scalar c_7 = (Scalar(8.0) * omega1 * omega2 + Scalar(4.0) * omega2_2) * per_2 * per_1
      + Scalar(4.0) * omega1_3 * omega2 * per_0 * per_3 * per_4 * per_1;
  const Scalar c_8 = Scalar(3.0) * per_0 * per_1;  // multiplies alpha32
  // multiplies delta32
  const Scalar c_9 = (-Scalar(3.0) * omega1_2 - Scalar(2.0) * omega1 * omega2) * per_0 * per_1;
  gradient[5] = alpha22 * c_0 + delta22 * c_1;  // by alpha21
  gradient[6] = alpha21 * c_0 + alpha23 * c_2 + delta21 * c_3 + delta23 * c_4;  // by alpha22
  gradient[7] = alpha22 * c_2 + delta22 * c_5;  // by alpha23
  gradient[8] = alpha22 * c_3 + delta22 * c_6;  // by delta21
  gradient[9] = alpha21 * c_1 + alpha23 * c_5 + delta21 * c_6 + delta23 * c_7;  // by delta22
  gradient[10] = alpha22 * c_4 + delta22 * c_7;  // by delta23
  gradient[12] = c_8;  // by alpha32
  gradient[16] = c_9;  // by delta32
  return value;
}

/// harmonic_re_v2_A_v2_conjA_v1 = (2*omega1*omega2*delta23 - 2*omega2^2*delta23 + 2*alpha23)/(omega1*(omega1 -
/// 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 21 operations.
template <class Scalar>
Scalar lump_25(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha23 = parameters[7];
  const Scalar delta23 = parameters[10];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = Scalar(2.0) * omega2 * delta23 * per_0;
  const Scalar f_1 = -Scalar(2.0) * omega2_2 * delta23 * per_0 / omega1;
  const Scalar f_2 = Scalar(2.0) * alpha23 * per_0 / omega1;
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2) * per_0;
  gradient[0] = (-f_1 - f_2) / omega1 - q_0;  // by omega1
  gradient[1] = (f_0 + Scalar(2.0) * f_1) / omega2 + Scalar(2.0) * q_0;  // by omega2
  const Scalar c_0 = Scalar(2.0) * per_0 / omega1;  // multiplies alpha23
  // multiplies delta23
  const Scalar c_1 = (Scalar(2.0) * omega1 * omega2 - Scalar(2.0) * omega2_2) * per_0 / omega1;
  gradient[7] = c_0;  // by alpha23
  gradient[10] = c_1;  // by delta23
  return value;
}

/// harmonic_im_v2_A_v2_conjA_v1 = (-2*omega1^3*delta22*mu21 + 4*omega1^2*omega2*delta22*mu21 -
/// 2*omega1*omega2^2*delta22*mu21 + 2*omega1*alpha22*mu21 - 2*omega2*alpha22*mu21)/(omega1*omega2*(omega1 -
/// 2*omega2)*(2*omega1 - omega2)) + (2*omega1^3*mu21*delta24 - 2*omega1^2*omega2*mu21*delta24 +
/// 2*omega1*omega2^2*mu12*delta22 + 2*omega1*omega2^2*mu21*delta24 - 2*omega1*mu21*alpha24 -
/// 2*omega2*mu12*alpha22)/(omega1*(omega1 + omega2)*(omega1 - omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 108 operations.
template <class Scalar>
Scalar lump_26(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu12 = parameters[3];
  const Scalar alpha22 = parameters[6];
  const Scalar delta22 = parameters[9];
  const Scalar mu21 = parameters[23];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -Scalar(2.0) * omega1_2 * delta22 * mu21 * per_0 * per_1 / omega2;
  const Scalar f_1 = Scalar(4.0) * omega1 * delta22 * mu21 * per_0 * per_1;
  const Scalar f_2 = -Scalar(2.0) * omega2 * delta22 * mu21 * per_0 * per_1;
  const Scalar f_3 = Scalar(2.0) * alpha22 * mu21 * per_0 * per_1 / omega2;
  const Scalar f_4 = -Scalar(2.0) * alpha22 * mu21 * per_0 * per_1 / omega1;
  const Scalar f_5 = Scalar(2.0) * omega1_2 * mu21 * delta24 * per_2 * per_3 * per_0;
  const Scalar f_6 = -Scalar(2.0) * omega1 * omega2 * mu21 * delta24 * per_2 * per_3 * per_0;
  const Scalar f_7 = (Scalar(2.0) * omega2_2 * mu12 * delta22
      + Scalar(2.0) * omega2_2 * mu21 * delta24) * per_2 * per_3 * per_0;
  const Scalar f_8 = -Scalar(2.0) * mu21 * alpha24 * per_2 * per_3 * per_0;
  const Scalar f_9 = -Scalar(2.0) * omega2 * mu12 * alpha22 * per_2 * per_3 * per_0 / omega1;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_1;
  const Scalar q_2 = (f_5 + f_6 + f_7 + f_8 + f_9) * per_2;
  const Scalar q_3 = (f_5 + f_6 + f_7 + f_8 + f_9) * per_3;
  // by omega1
  gradient[0] = (Scalar(2.0) * f_0 + f_1 - f_4 + Scalar(2.0) * f_5 + f_6 - f_9) / omega1 - q_0 - Scalar(2.0) * q_1
      - q_2 - q_3;
  // by omega2
  gradient[1] = (-f_0 + f_2 - f_3 + f_6 + Scalar(2.0) * f_7 + f_9) / omega2 + Scalar(2.0) * q_0 + q_1 - q_2 + q_3;
  const Scalar c_0 = -Scalar(2.0) * omega2 * per_2 * per_3 * per_0 / omega1;  // multiplies mu12*alpha22
  const Scalar c_1 = Scalar(2.0) * omega2_2 * per_2 * per_3 * per_0;  // multiplies mu12*delta22
  // multiplies alpha22*mu21
  const Scalar c_2 = (Scalar(2.0) * omega1 - Scalar(2.0) * omega2) * per_0 * per_1 / (omega1 * omega2);
  // multiplies delta22*mu21
  const Scalar c_3 = (-Scalar(2.0) * omega1_2 + Scalar(4.0) * omega1 * omega2
      - Scalar(2.0) * omega2_2) * per_0 * per_1 / omega2;
  const Scalar c_4 = -Scalar(2.0) * per_2 * per_3 * per_0;  // multiplies mu21*alpha24
  // multiplies mu21*delta24
  const Scalar c_5 = (Scalar(2.0) * omega1_2 - Scalar(2.0) * omega1 * omega2
      + Scalar(2.0) * omega2_2) * per_2 * per_3 * per_0;
  gradient[3] = alpha22 * c_0 + delta22 * c_1;  // by mu12
  gradient[6] = mu12 * c_0 + mu21 * c_2;  // by alpha22
  gradient[9] = mu12 * c_1 + mu21 * c_3;  // by delta22
  gradient[23] = alpha22 * c_2 + delta22 * c_3 + alpha24 * c_4 + delta24 * c_5;  // by mu21
  gradient[25] = mu21 * c_4;  // by alpha24
  gradient[26] = mu21 * c_5;  // by delta24
  return value;
}

/// harmonic_im_v2_conjA_v1_F = -omega1*mu21*eta22/(2*omega2^2*(omega1 + omega2)*(omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 14 operations.
template <class Scalar>
Scalar lump_27(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu21 = parameters[23];
  const Scalar eta22 = parameters[30];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -omega1 * mu21 * eta22 * per_0 * per_1 / (Scalar(2.0) * omega2_2);
  const Scalar value = f_0;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_0 * per_0;
  const Scalar q_1 = f_0 * per_1;
  gradient[0] = f_0 / omega1 - q_0 - q_1;  // by omega1
  gradient[1] = -Scalar(2.0) * f_0 / omega2 - q_0 + q_1;  // by omega2
  const Scalar c_0 = -omega1 * per_0 * per_1 / (Scalar(2.0) * omega2_2);  // multiplies mu21*eta22
  gradient[23] = eta22 * c_0;  // by mu21
  gradient[30] = mu21 * c_0;  // by eta22
  return value;
}

/// harmonic_re_v2_A_v1_A_v2 = (-2*omega1*omega2*delta23 - 2*omega2^2*delta23 + 2*alpha23)/(omega1*(omega1 +
/// 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 21 operations.
template <class Scalar>
Scalar lump_28(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha23 = parameters[7];
  const Scalar delta23 = parameters[10];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar f_0 = -Scalar(2.0) * omega2 * delta23 * per_0;
  const Scalar f_1 = -Scalar(2.0) * omega2_2 * delta23 * per_0 / omega1;
  const Scalar f_2 = Scalar(2.0) * alpha23 * per_0 / omega1;
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2) * per_0;
  gradient[0] = (-f_1 - f_2) / omega1 - q_0;  // by omega1
  gradient[1] = (f_0 + Scalar(2.0) * f_1) / omega2 - Scalar(2.0) * q_0;  // by omega2
  const Scalar c_0 = Scalar(2.0) * per_0 / omega1;  // multiplies alpha23
  // multiplies delta23
  const Scalar c_1 = (-Scalar(2.0) * omega1 * omega2 - Scalar(2.0) * omega2_2) * per_0 / omega1;
  gradient[7] = c_0;  // by alpha23
  gradient[10] = c_1;  // by delta23
  return value;
}

/// harmonic_im_v2_A_v1_A_v2 = (-2*omega1^3*delta22*mu21 - 4*omega1^2*omega2*delta22*mu21 -
/// 2*omega1*omega2^2*delta22*mu21 + 2*omega1*alpha22*mu21 + 2*omega2*alpha22*mu21)/(omega1*omega2*(omega1 +
/// 2*omega2)*(2*omega1 + omega2)) + (-2*omega1^3*mu21*delta24 - 2*omega1^2*omega2*mu21*delta24 -
/// 2*omega1*omega2^2*mu12*delta22 - 2*omega1*omega2^2*mu21*delta24 + 2*omega1*mu21*alpha24 -
/// 2*omega2*mu12*alpha22)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 108 operations.
template <class Scalar>
Scalar lump_29(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu12 = parameters[3];
  const Scalar alpha22 = parameters[6];
  const Scalar delta22 = parameters[9];
  const Scalar mu21 = parameters[23];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -Scalar(2.0) * omega1_2 * delta22 * mu21 * per_0 * per_1 / omega2;
  const Scalar f_1 = -Scalar(4.0) * omega1 * delta22 * mu21 * per_0 * per_1;
  const Scalar f_2 = -Scalar(2.0) * omega2 * delta22 * mu21 * per_0 * per_1;
  const Scalar f_3 = Scalar(2.0) * alpha22 * mu21 * per_0 * per_1 / omega2;
  const Scalar f_4 = Scalar(2.0) * alpha22 * mu21 * per_0 * per_1 / omega1;
  const Scalar f_5 = -Scalar(2.0) * omega1_2 * mu21 * delta24 * per_2 * per_0 * per_3;
  const Scalar f_6 = -Scalar(2.0) * omega1 * omega2 * mu21 * delta24 * per_2 * per_0 * per_3;
  const Scalar f_7 = (-Scalar(2.0) * omega2_2 * mu12 * delta22
      - Scalar(2.0) * omega2_2 * mu21 * delta24) * per_2 * per_0 * per_3;
  const Scalar f_8 = Scalar(2.0) * mu21 * alpha24 * per_2 * per_0 * per_3;
  const Scalar f_9 = -Scalar(2.0) * omega2 * mu12 * alpha22 * per_2 * per_0 * per_3 / omega1;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_1;
  const Scalar q_2 = (f_5 + f_6 + f_7 + f_8 + f_9) * per_2;
  const Scalar q_3 = (f_5 + f_6 + f_7 + f_8 + f_9) * per_3;
  // by omega1
  gradient[0] = (Scalar(2.0) * f_0 + f_1 - f_4 + Scalar(2.0) * f_5 + f_6 - f_9) / omega1 - q_0 - Scalar(2.0) * q_1
      - q_2 - q_3;
  // by omega2
  gradient[1] = (-f_0 + f_2 - f_3 + f_6 + Scalar(2.0) * f_7 + f_9) / omega2 - Scalar(2.0) * q_0 - q_1 - q_2 + q_3;
  const Scalar c_0 = -Scalar(2.0) * omega2 * per_2 * per_0 * per_3 / omega1;  // multiplies mu12*alpha22
  const Scalar c_1 = -Scalar(2.0) * omega2_2 * per_2 * per_0 * per_3;  // multiplies mu12*delta22
  // multiplies alpha22*mu21
  const Scalar c_2 = (Scalar(2.0) * omega1 + Scalar(2.0) * omega2) * per_0 * per_1 / (omega1 * omega2);
  // multiplies delta22*mu21
  const Scalar c_3 = (-Scalar(2.0) * omega1_2 - Scalar(4.0) * omega1 * omega2
      - Scalar(2.0) * omega2_2) * per_0 * per_1 / omega2;
  const Scalar c_4 = Scalar(2.0) * per_2 * per_0 * per_3;  // multiplies mu21*alpha24
  // multiplies mu21*delta24
  const Scalar c_5 = (-Scalar(2.0) * omega1_2 - Scalar(2.0) * omega1 * omega2
      - Scalar(2.0) * omega2_2) * per_2 * per_0 * per_3;
  gradient[3] = alpha22 * c_0 + delta22 * c_1;  // by mu12
  gradient[6] = mu12 * c_0 + mu21 * c_2;  // by alpha22
  gradient[9] = mu12 * c_1 + mu21 * c_3;  // by delta22
  gradient[23] = alpha22 * c_2 + delta22 * c_3 + alpha24 * c_4 + delta24 * c_5;  // by mu21
  gradient[25] = mu21 * c_4;  // by alpha24
  gradient[26] = mu21 * c_5;  // by delta24
  return value;
}

/// harmonic_im_v2_A_v22 = (4*omega2^2*mu12*delta23 - 2*mu12*alpha23)/(3*omega2*(omega1 + omega2)*(omega1 -
/// omega2)) + (-2*omega2^2*delta23*mu21 - 2*alpha23*mu21)/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 50 operations.
template <class Scalar>
Scalar lump_30(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu12 = parameters[3];
  const Scalar alpha23 = parameters[7];
  const Scalar delta23 = parameters[10];
  const Scalar mu21 = parameters[23];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = Scalar(4.0) * omega2 * mu12 * delta23 * per_0 * per_1 / Scalar(3.0);
  const Scalar f_1 = -Scalar(2.0) * mu12 * alpha23 * per_0 * per_1 / (Scalar(3.0) * omega2);
  const Scalar f_2 = -Scalar(2.0) * omega2 * delta23 * mu21 * per_2 * per_3 / Scalar(3.0);
  const Scalar f_3 = -Scalar(2.0) * alpha23 * mu21 * per_2 * per_3 / (Scalar(3.0) * omega2);
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1) * per_0;
  const Scalar q_1 = (f_0 + f_1) * per_1;
  const Scalar q_2 = (f_2 + f_3) * per_2;
  const Scalar q_3 = (f_2 + f_3) * per_3;
  gradient[0] = -q_0 - q_1 - q_2 - q_3;  // by omega1
  gradient[1] = (f_0 - f_1 + f_2 - f_3) / omega2 - q_0 + q_1 - Scalar(2.0) * q_2 + Scalar(2.0) * q_3;  // by omega2
  const Scalar c_0 = -Scalar(2.0) * per_0 * per_1 / (Scalar(3.0) * omega2);  // multiplies mu12*alpha23
  const Scalar c_1 = Scalar(4.0) * omega2 * per_0 * per_1 / Scalar(3.0);  // multiplies mu12*delta23
  const Scalar c_2 = -Scalar(2.0) * per_2 * per_3 / (Scalar(3.0) * omega2);  // multiplies alpha23*mu21
  const Scalar c_3 = -Scalar(2.0) * omega2 * per_2 * per_3 / Scalar(3.0);  // multiplies delta23*mu21
  gradient[3] = alpha23 * c_0 + delta23 * c_1;  // by mu12
  gradient[7] = mu12 * c_0 + mu21 * c_2;  // by alpha23
  gradient[10] = mu12 * c_1 + mu21 * c_3;  // by delta23
  gradient[23] = alpha23 * c_2 + delta23 * c_3;  // by mu21
  return value;
}

/// harmonic_re_v2_A_v2_conjA_v2_F = (omega1^2*omega2^2*delta24*eta22 + omega1^2*alpha24*eta22 +
/// 2*omega2^4*delta24*eta22 - 6*omega2^2*alpha24*eta22)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1
/// - omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 49 operations.
template <class Scalar>
Scalar lump_31(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = omega1_2 * delta24 * eta22 * per_0 * per_1 * per_2 * per_3;
  const Scalar f_1 = omega1_2 * alpha24 * eta22 * per_0 * per_1 * per_2 * per_3 / omega2_2;
  const Scalar f_2 = Scalar(2.0) * omega2_2 * delta24 * eta22 * per_0 * per_1 * per_2 * per_3;
  const Scalar f_3 = -Scalar(6.0) * alpha24 * eta22 * per_0 * per_1 * per_2 * per_3;
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3) * per_1;
  const Scalar q_2 = (f_0 + f_1 + f_2 + f_3) * per_2;
  const Scalar q_3 = (f_0 + f_1 + f_2 + f_3) * per_3;
  gradient[0] = (Scalar(2.0) * f_0 + Scalar(2.0) * f_1) / omega1 - q_0 - q_1 - q_2 - q_3;  // by omega1
  // by omega2
  gradient[1] = (-Scalar(2.0) * f_1 + Scalar(2.0) * f_2) / omega2 - q_0 - Scalar(2.0) * q_1 + q_2
      + Scalar(2.0) * q_3;
  // multiplies alpha24*eta22
  const Scalar c_0 = (omega1_2 - Scalar(6.0) * omega2_2) * per_0 * per_1 * per_2 * per_3 / omega2_2;
  // multiplies delta24*eta22
  const Scalar c_1 = (omega1_2 + Scalar(2.0) * omega2_2) * per_0 * per_1 * per_2 * per_3;
  gradient[25] = eta22 * c_0;  // by alpha24
  gradient[26] = eta22 * c_1;  // by delta24
  gradient[30] = alpha24 * c_0 + delta24 * c_1;  // by eta22
  return value;
}

/// harmonic_re_v2_A_v1_conjA_v1_F = (-3*omega1^4*delta22*eta22 + 2*omega1^2*omega2^2*delta22*eta12 +
/// 3*omega1^2*alpha22*eta22 + 2*omega2^2*alpha22*eta12)/(3*omega1^2*omega2^2*(omega1 + omega2)*(omega1 -
/// omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 37 operations.
template <class Scalar>
Scalar lump_32(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar delta22 = parameters[9];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -omega1_2 * delta22 * eta22 * per_0 * per_1 / omega2_2;
  const Scalar f_1 = Scalar(2.0) * delta22 * eta12 * per_0 * per_1 / Scalar(3.0);
  const Scalar f_2 = alpha22 * eta22 * per_0 * per_1 / omega2_2;
  const Scalar f_3 = Scalar(2.0) * alpha22 * eta12 * per_0 * per_1 / (Scalar(3.0) * omega1_2);
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3) * per_1;
  gradient[0] = (Scalar(2.0) * f_0 - Scalar(2.0) * f_3) / omega1 - q_0 - q_1;  // by omega1
  gradient[1] = (-Scalar(2.0) * f_0 - Scalar(2.0) * f_2) / omega2 - q_0 + q_1;  // by omega2
  const Scalar c_0 = Scalar(2.0) * per_0 * per_1 / (Scalar(3.0) * omega1_2);  // multiplies alpha22*eta12
  const Scalar c_1 = per_0 * per_1 / omega2_2;  // multiplies alpha22*eta22
  const Scalar c_2 = Scalar(2.0) * per_0 * per_1 / Scalar(3.0);  // multiplies delta22*eta12
  const Scalar c_3 = -omega1_2 * per_0 * per_1 / omega2_2;  // multiplies delta22*eta22
  gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
  gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
  gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
  gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  return value;
}

/// harmonic_re_v2_A_v1_A_v2_conjA_v2 = (-2*omega2^2*delta35 + 6*alpha34)/((omega1 + omega2)*(omega1 - omega2)) +
/// (-4*omega1^2*omega2^2*alpha23*delta24 - 4*omega1^2*alpha23*alpha24 - 24*omega2^6*delta23*delta24 -
/// 8*omega2^4*alpha23*delta24 + 8*omega2^4*delta23*alpha24 + 24*omega2^2*alpha23*alpha24)/(omega2^2*(omega1 +
/// omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) + (-16*omega1^6*delta22*delta23 +
/// 8*omega1^4*omega2^2*delta22*delta23 + 16*omega1^4*alpha22*delta23 - 8*omega1^4*alpha23*delta22 +
/// 16*omega1^2*omega2^2*alpha22*delta23 - 24*omega1^2*alpha22*alpha23 - 4*omega2^4*alpha22*delta23 +
/// 4*omega2^2*alpha22*alpha23)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 -
/// omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 179 operations.
template <class Scalar>
Scalar lump_33(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar alpha34 = parameters[14];
  const Scalar delta35 = parameters[19];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_4 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_5 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = -Scalar(2.0) * omega2_2 * delta35 * per_0 * per_1;
  const Scalar f_1 = Scalar(6.0) * alpha34 * per_0 * per_1;
  const Scalar f_2 = -Scalar(4.0) * omega1_2 * alpha23 * delta24 * per_0 * per_2 * per_1 * per_3;
  const Scalar f_3 = -Scalar(4.0) * omega1_2 * alpha23 * alpha24 * per_0 * per_2 * per_1 * per_3 / omega2_2;
  const Scalar f_4 = -Scalar(24.0) * omega2_4 * delta23 * delta24 * per_0 * per_2 * per_1 * per_3;
  const Scalar f_5 = (-Scalar(8.0) * omega2_2 * alpha23 * delta24
      + Scalar(8.0) * omega2_2 * delta23 * alpha24) * per_0 * per_2 * per_1 * per_3;
  const Scalar f_6 = Scalar(24.0) * alpha23 * alpha24 * per_0 * per_2 * per_1 * per_3;
  const Scalar f_7 = -Scalar(16.0) * omega1_4 * delta22 * delta23 * per_0 * per_1 * per_4 * per_5;
  const Scalar f_8 = Scalar(8.0) * omega1_2 * omega2_2 * delta22 * delta23 * per_0 * per_1 * per_4 * per_5;
  const Scalar f_9 = (Scalar(16.0) * omega1_2 * alpha22 * delta23
      - Scalar(8.0) * omega1_2 * alpha23 * delta22) * per_0 * per_1 * per_4 * per_5;
  const Scalar f_10 = Scalar(16.0) * omega2_2 * alpha22 * delta23 * per_0 * per_1 * per_4 * per_5;
  const Scalar f_11 = -Scalar(24.0) * alpha22 * alpha23 * per_0 * per_1 * per_4 * per_5;
  const Scalar f_12 = -Scalar(4.0) * omega2_4 * alpha22 * delta23 * per_0 * per_1 * per_4 * per_5 / omega1_2;
  const Scalar f_13 = Scalar(4.0) * omega2_2 * alpha22 * alpha23 * per_0 * per_1 * per_4 * per_5 / omega1_2;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12
      + f_13) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12
      + f_13) * per_1;
  const Scalar q_2 = (f_2 + f_3 + f_4 + f_5 + f_6) * per_2;
  const Scalar q_3 = (f_2 + f_3 + f_4 + f_5 + f_6) * per_3;
  const Scalar q_4 = (f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13) * per_4;
  const Scalar q_5 = (f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13) * per_5;
  // by omega1
  gradient[0] = (Scalar(2.0) * f_2 + Scalar(2.0) * f_3 + Scalar(4.0) * f_7 + Scalar(2.0) * f_8 + Scalar(2.0) * f_9
      - Scalar(2.0) * f_12 - Scalar(2.0) * f_13) / omega1 - q_0 - q_1 - q_2 - q_3 - Scalar(2.0) * q_4
      - Scalar(2.0) * q_5;
  // by omega2
  gradient[1] = (Scalar(2.0) * f_0 - Scalar(2.0) * f_3 + Scalar(4.0) * f_4 + Scalar(2.0) * f_5 + Scalar(2.0) * f_8
      + Scalar(2.0) * f_10 + Scalar(4.0) * f_12 + Scalar(2.0) * f_13) / omega2 - q_0 + q_1 - Scalar(2.0) * q_2
      + Scalar(2.0) * q_3 - q_4 + q_5;
  // multiplies alpha22*alpha23
  const Scalar c_0 = (-Scalar(24.0) * omega1_2 + Scalar(4.0) * omega2_2) * per_0 * per_1 * per_4 * per_5 / omega1_2;
  // multiplies alpha22*delta23
  const Scalar c_1 = (Scalar(16.0) * omega1_4 + Scalar(16.0) * omega1_2 * omega2_2
      - Scalar(4.0) * omega2_4) * per_0 * per_1 * per_4 * per_5 / omega1_2;
  const Scalar c_2 = -Scalar(8.0) * omega1_2 * per_0 * per_1 * per_4 * per_5;  // multiplies alpha23*delta22
  // multiplies alpha23*alpha24
  const Scalar c_3 = (-Scalar(4.0) * omega1_2 + Scalar(24.0) * omega2_2) * per_0 * per_2 * per_1 * per_3 / omega2_2;
  // multiplies alpha23*delta24
  const Scalar c_4 = (-Scalar(4.0) * omega1_2 - Scalar(8.0) * omega2_2) * per_0 * per_2 * per_1 * per_3;
  // multiplies delta22*delta23
  const Scalar c_5 = (-Scalar(16.0) * omega1_4 + Scalar(8.0) * omega1_2 * omega2_2) * per_0 * per_1 * per_4 * per_5;
  const Scalar c_6 = Scalar(8.0) * omega2_2 * per_0 * per_2 * per_1 * per_3;  // multiplies delta23*alpha24
  const Scalar c_7 = -Scalar(24.0) * omega2_4 * per_0 * per_2 * per_1 * per_3;  // multiplies delta23*delta24
  const Scalar c_8 = Scalar(6.0) * per_0 * per_1;  // multiplies alpha34
  const Scalar c_9 = -Scalar(2.0) * omega2_2 * per_0 * per_1;  // multiplies delta35
  gradient[6] = alpha23 * c_0 + delta23 * c_1;  // by alpha22
  gradient[7] = alpha22 * c_0 + delta22 * c_2 + alpha24 * c_3 + delta24 * c_4;  // by alpha23
  gradient[9] = alpha23 * c_2 + delta23 * c_5;  // by delta22
  gradient[10] = alpha22 * c_1 + delta22 * c_5 + alpha24 * c_6 + delta24 * c_7;  // by delta23
  gradient[14] = c_8;  // by alpha34
  gradient[19] = c_9;  // by delta35
  gradient[25] = alpha23 * c_3 + delta23 * c_6;  // by alpha24
  gradient[26] = alpha23 * c_4 + delta23 * c_7;  // by delta24
  return value;
}

/// harmonic_re_v2_A_v12_conjA_v1 = (12*omega1^4*delta21*delta22 - 3*omega1^4*delta32 -
/// 4*omega1^2*alpha21*delta22 + 6*omega1^2*alpha22*delta21 + 9*omega1^2*alpha32 -
/// 10*alpha21*alpha22)/(3*omega1^2*(omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^4*omega2^2*delta22*delta23
/// + 16*omega1^4*alpha23*delta22 - 4*omega1^2*omega2^2*alpha22*delta23 - 2*omega1^2*omega2^2*alpha23*delta22 -
/// 16*omega1^2*alpha22*alpha23 + 6*omega2^2*alpha22*alpha23)/(omega2^2*(omega1 + omega2)*(omega1 -
/// omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 116 operations.
template <class Scalar>
Scalar lump_34(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar alpha32 = parameters[12];
  const Scalar delta32 = parameters[16];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = (Scalar(4.0) * omega1_2 * delta21 * delta22 - omega1_2 * delta32) * per_0 * per_1;
  const Scalar f_1 = (-Scalar(4.0) * alpha21 * delta22 + Scalar(6.0) * alpha22 * delta21
      + Scalar(9.0) * alpha32) * per_0 * per_1 / Scalar(3.0);
  const Scalar f_2 = -Scalar(10.0) * alpha21 * alpha22 * per_0 * per_1 / (Scalar(3.0) * omega1_2);
  const Scalar f_3 = -Scalar(4.0) * omega1_4 * delta22 * delta23 * per_0 * per_1 * per_2 * per_3;
  const Scalar f_4 = Scalar(16.0) * omega1_4 * alpha23 * delta22 * per_0 * per_1 * per_2 * per_3 / omega2_2;
  const Scalar f_5 = (-Scalar(4.0) * omega1_2 * alpha22 * delta23
      - Scalar(2.0) * omega1_2 * alpha23 * delta22) * per_0 * per_1 * per_2 * per_3;
  const Scalar f_6 = -Scalar(16.0) * omega1_2 * alpha22 * alpha23 * per_0 * per_1 * per_2 * per_3 / omega2_2;
  const Scalar f_7 = Scalar(6.0) * alpha22 * alpha23 * per_0 * per_1 * per_2 * per_3;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7) * per_1;
  const Scalar q_2 = (f_3 + f_4 + f_5 + f_6 + f_7) * per_2;
  const Scalar q_3 = (f_3 + f_4 + f_5 + f_6 + f_7) * per_3;
  // by omega1
  gradient[0] = (Scalar(2.0) * f_0 - Scalar(2.0) * f_2 + Scalar(4.0) * f_3 + Scalar(4.0) * f_4 + Scalar(2.0) * f_5
      + Scalar(2.0) * f_6) / omega1 - q_0 - q_1 - Scalar(2.0) * q_2 - Scalar(2.0) * q_3;
  gradient[1] = (-Scalar(2.0) * f_4 - Scalar(2.0) * f_6) / omega2 - q_0 + q_1 - q_2 + q_3;  // by omega2
  const Scalar c_0 = -Scalar(10.0) * per_0 * per_1 / (Scalar(3.0) * omega1_2);  // multiplies alpha21*alpha22
  const Scalar c_1 = -Scalar(4.0) * per_0 * per_1 / Scalar(3.0);  // multiplies alpha21*delta22
  // multiplies alpha22*alpha23
  const Scalar c_2 = (-Scalar(16.0) * omega1_2 + Scalar(6.0) * omega2_2) * per_0 * per_1 * per_2 * per_3 / omega2_2;
  const Scalar c_3 = Scalar(2.0) * per_0 * per_1;  // multiplies alpha22*delta21
  const Scalar c_4 = -Scalar(4.0) * omega1_2 * per_0 * per_1 * per_2 * per_3;  // multiplies alpha22*delta23
  // multiplies alpha23*delta22
  const Scalar c_5 = (Scalar(16.0) * omega1_4
      - Scalar(2.0) * omega1_2 * omega2_2) * per_0 * per_1 * per_2 * per_3 / omega2_2;
  const Scalar c_6 = Scalar(4.0) * omega1_2 * per_0 * per_1;  // multiplies delta21*delta22
  const Scalar c_7 = -Scalar(4.0) * omega1_4 * per_0 * per_1 * per_2 * per_3;  // multiplies delta22*delta23
  const Scalar c_8 = Scalar(3.0) * per_0 * per_1;  // multiplies alpha32
  const Scalar c_9 = -omega1_2 * per_0 * per_1;  // multiplies delta32
  gradient[5] = alpha22 * c_0 + delta22 * c_1;  // by alpha21
  gradient[6] = alpha21 * c_0 + alpha23 * c_2 + delta21 * c_3 + delta23 * c_4;  // by alpha22
  gradient[7] = alpha22 * c_2 + delta22 * c_5;  // by alpha23
  gradient[8] = alpha22 * c_3 + delta22 * c_6;  // by delta21
  gradient[9] = alpha21 * c_1 + alpha23 * c_5 + delta21 * c_6 + delta23 * c_7;  // by delta22
  gradient[10] = alpha22 * c_4 + delta22 * c_7;  // by delta23
  gradient[12] = c_8;  // by alpha32
  gradient[16] = c_9;  // by delta32
  return value;
}

/// harmonic_re_v2_A_v12_F = alpha22*eta12/(omega1^2*(omega1 + omega2)*(omega1 - omega2)) +
/// (-omega1^2*delta22*eta22 - alpha22*eta22)/(2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 +
/// omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 40 operations.
template <class Scalar>
Scalar lump_35(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar delta22 = parameters[9];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = alpha22 * eta12 * per_0 * per_1 / omega1_2;
  const Scalar f_1 = -omega1_2 * delta22 * eta22 * per_0 * per_1 * per_2 * per_3 / Scalar(2.0);
  const Scalar f_2 = -alpha22 * eta22 * per_0 * per_1 * per_2 * per_3 / Scalar(2.0);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2) * per_1;
  const Scalar q_2 = (f_1 + f_2) * per_2;
  const Scalar q_3 = (f_1 + f_2) * per_3;
  // by omega1
  gradient[0] = (-Scalar(2.0) * f_0 + Scalar(2.0) * f_1) / omega1 - q_0 - q_1 - Scalar(2.0) * q_2
      - Scalar(2.0) * q_3;
  gradient[1] = -q_0 + q_1 - q_2 + q_3;  // by omega2
  const Scalar c_0 = per_0 * per_1 / omega1_2;  // multiplies alpha22*eta12
  const Scalar c_1 = -per_0 * per_1 * per_2 * per_3 / Scalar(2.0);  // multiplies alpha22*eta22
  const Scalar c_2 = -omega1_2 * per_0 * per_1 * per_2 * per_3 / Scalar(2.0);  // multiplies delta22*eta22
  gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
  gradient[9] = eta22 * c_2;  // by delta22
  gradient[21] = alpha22 * c_0;  // by eta12
  gradient[30] = alpha22 * c_1 + delta22 * c_2;  // by eta22
  return value;
}

/// harmonic_re_v2_A_v12 = (omega1^2*delta22 + alpha22)/((2*omega1 + omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 15 operations.
template <class Scalar>
Scalar lump_36(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar delta22 = parameters[9];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = omega1_2 * delta22 * per_0 * per_1;
  const Scalar f_1 = alpha22 * per_0 * per_1;
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1) * per_0;
  const Scalar q_1 = (f_0 + f_1) * per_1;
  gradient[0] = Scalar(2.0) * f_0 / omega1 - Scalar(2.0) * q_0 - Scalar(2.0) * q_1;  // by omega1
  gradient[1] = -q_0 + q_1;  // by omega2
  const Scalar c_0 = per_0 * per_1;  // multiplies alpha22
  const Scalar c_1 = omega1_2 * per_0 * per_1;  // multiplies delta22
  gradient[6] = c_0;  // by alpha22
  gradient[9] = c_1;  // by delta22
  return value;
}

/// harmonic_im_v2_A_v1_F = -eta12*mu21/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2)) -
/// omega1*mu21*eta22/(2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 31 operations.
template <class Scalar>
Scalar lump_37(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar eta12 = parameters[21];
  const Scalar mu21 = parameters[23];
  const Scalar eta22 = parameters[30];
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -eta12 * mu21 * per_0 * per_1 / (Scalar(3.0) * omega1);
  const Scalar f_1 = -omega1 * mu21 * eta22 * per_2 * per_3 * per_0 * per_1 / Scalar(2.0);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1) * per_0;
  const Scalar q_1 = (f_0 + f_1) * per_1;
  const Scalar q_2 = f_1 * per_2;
  const Scalar q_3 = f_1 * per_3;
  gradient[0] = (-f_0 + f_1) / omega1 - Scalar(2.0) * q_0 - Scalar(2.0) * q_1 - q_2 - q_3;  // by omega1
  gradient[1] = -q_0 + q_1 - q_2 + q_3;  // by omega2
  const Scalar c_0 = -per_0 * per_1 / (Scalar(3.0) * omega1);  // multiplies eta12*mu21
  const Scalar c_1 = -omega1 * per_2 * per_3 * per_0 * per_1 / Scalar(2.0);  // multiplies mu21*eta22
  gradient[21] = mu21 * c_0;  // by eta12
  gradient[23] = eta12 * c_0 + eta22 * c_1;  // by mu21
  gradient[30] = mu21 * c_1;  // by eta22
  return value;
}

/// harmonic_im_v2_A_v12 = (-6*omega1^2*delta21*mu21 + 2*alpha21*mu21)/(3*omega1*(2*omega1 + omega2)*(2*omega1 -
/// omega2)) + (-4*omega1^3*delta23*mu21 + 2*omega1*alpha23*mu21)/((omega1 + omega2)*(omega1 - omega2)*(2*omega1
/// + omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 52 operations.
template <class Scalar>
Scalar lump_38(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha23 = parameters[7];
  const Scalar delta21 = parameters[8];
  const Scalar delta23 = parameters[10];
  const Scalar mu21 = parameters[23];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -Scalar(2.0) * omega1 * delta21 * mu21 * per_0 * per_1;
  const Scalar f_1 = Scalar(2.0) * alpha21 * mu21 * per_0 * per_1 / (Scalar(3.0) * omega1);
  const Scalar f_2 = -Scalar(4.0) * omega1_3 * delta23 * mu21 * per_2 * per_3 * per_0 * per_1;
  const Scalar f_3 = Scalar(2.0) * omega1 * alpha23 * mu21 * per_2 * per_3 * per_0 * per_1;
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3) * per_1;
  const Scalar q_2 = (f_2 + f_3) * per_2;
  const Scalar q_3 = (f_2 + f_3) * per_3;
  // by omega1
  gradient[0] = (f_0 - f_1 + Scalar(3.0) * f_2 + f_3) / omega1 - Scalar(2.0) * q_0 - Scalar(2.0) * q_1 - q_2 - q_3;
  gradient[1] = -q_0 + q_1 - q_2 + q_3;  // by omega2
  const Scalar c_0 = Scalar(2.0) * per_0 * per_1 / (Scalar(3.0) * omega1);  // multiplies alpha21*mu21
  const Scalar c_1 = Scalar(2.0) * omega1 * per_2 * per_3 * per_0 * per_1;  // multiplies alpha23*mu21
  const Scalar c_2 = -Scalar(2.0) * omega1 * per_0 * per_1;  // multiplies delta21*mu21
  const Scalar c_3 = -Scalar(4.0) * omega1_3 * per_2 * per_3 * per_0 * per_1;  // multiplies delta23*mu21
  gradient[5] = mu21 * c_0;  // by alpha21
  gradient[7] = mu21 * c_1;  // by alpha23
  gradient[8] = mu21 * c_2;  // by delta21
  gradient[10] = mu21 * c_3;  // by delta23
  gradient[23] = alpha21 * c_0 + alpha23 * c_1 + delta21 * c_2 + delta23 * c_3;  // by mu21
  return value;
}

/// harmonic_re_v2_A_v2_conjA_v12 = (3*omega1^4*delta33 - 12*omega1^3*omega2*delta21*delta23 +
/// 6*omega1^3*omega2*delta34 + 6*omega1^2*omega2^2*delta21*delta23 - 3*omega1^2*omega2^2*delta34 -
/// 6*omega1^2*alpha23*delta21 + 3*omega1^2*alpha33 + 4*omega1*omega2*alpha21*delta23 -
/// 2*omega2^2*alpha21*delta23 + 2*alpha21*alpha23)/(12*omega1^3*(omega1 - omega2)) +
/// (-2*omega1^2*omega2*delta23^2 + 3*omega1*omega2^2*delta23^2 - 2*omega1*alpha23*delta23 - omega2^3*delta23^2 +
/// 2*omega2*alpha23*delta23)/(omega1^2*(omega1 - 2*omega2)) + (omega1^2*delta22^2 -
/// omega1*omega2*delta22^2)/(omega2*(2*omega1 - omega2)) + alpha23^2/(omega1^2*(omega1 - omega2)*(omega1 -
/// 2*omega2)) - alpha22^2/(omega1*omega2*(omega1 - omega2)*(2*omega1 - omega2)) + (-4*omega1^4*delta22*delta24 +
/// 2*omega1^3*omega2*delta22*delta24 - omega1^2*omega2^2*delta22*delta24 - 4*omega1^2*alpha22*delta24 +
/// omega1^2*delta22*alpha24 + 2*omega1*omega2*alpha22*delta24 - omega2^2*alpha22*delta24 +
/// alpha22*alpha24)/(2*omega1*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 213 operations.
template <class Scalar>
Scalar lump_39(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar alpha33 = parameters[13];
  const Scalar delta33 = parameters[17];
  const Scalar delta34 = parameters[18];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar alpha22_2 = alpha22 * alpha22;
  const Scalar alpha23_2 = alpha23 * alpha23;
  const Scalar delta22_2 = delta22 * delta22;
  const Scalar delta23_2 = delta23 * delta23;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar f_0 = omega1 * delta33 * per_0 / Scalar(4.0);
  const Scalar f_1 = (-Scalar(2.0) * omega2 * delta21 * delta23 + omega2 * delta34) * per_0 / Scalar(2.0);
  const Scalar f_2 = (Scalar(2.0) * omega2_2 * delta21 * delta23
      - omega2_2 * delta34) * per_0 / (Scalar(4.0) * omega1);
  const Scalar f_3 = (-Scalar(2.0) * alpha23 * delta21 + alpha33) * per_0 / (Scalar(4.0) * omega1);
  const Scalar f_4 = omega2 * alpha21 * delta23 * per_0 / (Scalar(3.0) * omega1_2);
  const Scalar f_5 = -omega2_2 * alpha21 * delta23 * per_0 / (Scalar(6.0) * omega1_3);
  const Scalar f_6 = alpha21 * alpha23 * per_0 / (Scalar(6.0) * omega1_3);
  const Scalar f_7 = -Scalar(2.0) * omega2 * delta23_2 * per_1;
  const Scalar f_8 = Scalar(3.0) * omega2_2 * delta23_2 * per_1 / omega1;
  const Scalar f_9 = -Scalar(2.0) * alpha23 * delta23 * per_1 / omega1;
  const Scalar f_10 = -omega2_3 * delta23_2 * per_1 / omega1_2;
  const Scalar f_11 = Scalar(2.0) * omega2 * alpha23 * delta23 * per_1 / omega1_2;
  const Scalar f_12 = omega1_2 * delta22_2 * per_2 / omega2;
  const Scalar f_13 = -omega1 * delta22_2 * per_2;
  const Scalar f_14 = alpha23_2 * per_0 * per_1 / omega1_2;
  const Scalar f_15 = -alpha22_2 * per_0 * per_2 / (omega1 * omega2);
  const Scalar f_16 = -Scalar(2.0) * omega1_3 * delta22 * delta24 * per_0 * per_3 * per_2;
  const Scalar f_17 = omega1_2 * omega2 * delta22 * delta24 * per_0 * per_3 * per_2;
  const Scalar f_18 = -omega1 * omega2_2 * delta22 * delta24 * per_0 * per_3 * per_2 / Scalar(2.0);
  const Scalar f_19 = (-Scalar(4.0) * omega1 * alpha22 * delta24
      + omega1 * delta22 * alpha24) * per_0 * per_3 * per_2 / Scalar(2.0);
  const Scalar f_20 = omega2 * alpha22 * delta24 * per_0 * per_3 * per_2;
  const Scalar f_21 = -omega2_2 * alpha22 * delta24 * per_0 * per_3 * per_2 / (Scalar(2.0) * omega1);
  const Scalar f_22 = alpha22 * alpha24 * per_0 * per_3 * per_2 / (Scalar(2.0) * omega1);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14
      + f_15 + f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_14 + f_15 + f_16 + f_17 + f_18 + f_19 + f_20
      + f_21 + f_22) * per_0;
  const Scalar q_1 = (f_7 + f_8 + f_9 + f_10 + f_11 + f_14) * per_1;
  const Scalar q_2 = (f_12 + f_13 + f_15 + f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22) * per_2;
  const Scalar q_3 = (f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22) * per_3;
  // by omega1
  gradient[0] = (f_0 - f_2 - f_3 - Scalar(2.0) * f_4 - Scalar(3.0) * f_5 - Scalar(3.0) * f_6 - f_8 - f_9
      - Scalar(2.0) * f_10 - Scalar(2.0) * f_11 + Scalar(2.0) * f_12 + f_13 - Scalar(2.0) * f_14 - f_15
      + Scalar(3.0) * f_16 + Scalar(2.0) * f_17 + f_18 + f_19 - f_21 - f_22) / omega1 - q_0 - q_1
      - Scalar(2.0) * q_2 - Scalar(2.0) * q_3;
  // by omega2
  gradient[1] = (f_1 + Scalar(2.0) * f_2 + f_4 + Scalar(2.0) * f_5 + f_7 + Scalar(2.0) * f_8 + Scalar(3.0) * f_10
      + f_11 - f_12 - f_15 + f_17 + Scalar(2.0) * f_18 + f_20 + Scalar(2.0) * f_21) / omega2 + q_0
      + Scalar(2.0) * q_1 + q_2 - q_3;
  const Scalar c_0 = per_0 / (Scalar(6.0) * omega1_3);  // multiplies alpha21*alpha23
  // multiplies alpha21*delta23
  const Scalar c_1 = (Scalar(2.0) * omega1 * omega2 - omega2_2) * per_0 / (Scalar(6.0) * omega1_3);
  const Scalar c_2 = -per_0 * per_2 / (omega1 * omega2);  // multiplies alpha22^2
  const Scalar c_3 = per_0 * per_3 * per_2 / (Scalar(2.0) * omega1);  // multiplies alpha22*alpha24
  // multiplies alpha22*delta24
  const Scalar c_4 = (-Scalar(4.0) * omega1_2 + Scalar(2.0) * omega1 * omega2
      - omega2_2) * per_0 * per_3 * per_2 / (Scalar(2.0) * omega1);
  const Scalar c_5 = per_0 * per_1 / omega1_2;  // multiplies alpha23^2
  const Scalar c_6 = -per_0 / (Scalar(2.0) * omega1);  // multiplies alpha23*delta21
  // multiplies alpha23*delta23
  const Scalar c_7 = (-Scalar(2.0) * omega1 + Scalar(2.0) * omega2) * per_1 / omega1_2;
  // multiplies delta21*delta23
  const Scalar c_8 = (-Scalar(2.0) * omega1 * omega2 + omega2_2) * per_0 / (Scalar(2.0) * omega1);
  const Scalar c_9 = (omega1_2 - omega1 * omega2) * per_2 / omega2;  // multiplies delta22^2
  const Scalar c_10 = omega1 * per_0 * per_3 * per_2 / Scalar(2.0);  // multiplies delta22*alpha24
  // multiplies delta22*delta24
  const Scalar c_11 = (-Scalar(4.0) * omega1_3 + Scalar(2.0) * omega1_2 * omega2
      - omega1 * omega2_2) * per_0 * per_3 * per_2 / Scalar(2.0);
  // multiplies delta23^2
  const Scalar c_12 = (-Scalar(2.0) * omega1_2 * omega2 + Scalar(3.0) * omega1 * omega2_2
      - omega2_3) * per_1 / omega1_2;
  const Scalar c_13 = per_0 / (Scalar(4.0) * omega1);  // multiplies alpha33
  const Scalar c_14 = omega1 * per_0 / Scalar(4.0);  // multiplies delta33
  // multiplies delta34
  const Scalar c_15 = (Scalar(2.0) * omega1 * omega2 - omega2_2) * per_0 / (Scalar(4.0) * omega1);
  gradient[5] = alpha23 * c_0 + delta23 * c_1;  // by alpha21
  gradient[6] = Scalar(2.0) * alpha22 * c_2 + alpha24 * c_3 + delta24 * c_4;  // by alpha22
  gradient[7] = alpha21 * c_0 + Scalar(2.0) * alpha23 * c_5 + delta21 * c_6 + delta23 * c_7;  // by alpha23
  gradient[8] = alpha23 * c_6 + delta23 * c_8;  // by delta21
  gradient[9] = Scalar(2.0) * delta22 * c_9 + alpha24 * c_10 + delta24 * c_11;  // by delta22
  gradient[10] = alpha21 * c_1 + alpha23 * c_7 + delta21 * c_8 + Scalar(2.0) * delta23 * c_12;  // by delta23
  gradient[13] = c_13;  // by alpha33
  gradient[17] = c_14;  // by delta33
  gradient[18] = c_15;  // by delta34
  gradient[25] = alpha22 * c_3 + delta22 * c_10;  // by alpha24
  gradient[26] = alpha22 * c_4 + delta22 * c_11;  // by delta24
  return value;
}

/// harmonic_re_v2_A_v2_conjA_v1_F = (-2*omega1*omega2*delta23*eta12 + omega2^2*delta23*eta12 -
/// alpha23*eta12)/(12*omega1^3*(omega1 - omega2)) + (omega1*delta23*eta22 -
/// omega2*delta23*eta22)/(2*omega1^2*(omega1 - 2*omega2)) - alpha23*eta22/(2*omega1^2*(omega1 - omega2)*(omega1
/// - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 50 operations.
template <class Scalar>
Scalar lump_40(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha23 = parameters[7];
  const Scalar delta23 = parameters[10];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = -omega2 * delta23 * eta12 * per_0 / (Scalar(6.0) * omega1_2);
  const Scalar f_1 = omega2_2 * delta23 * eta12 * per_0 / (Scalar(12.0) * omega1_3);
  const Scalar f_2 = -alpha23 * eta12 * per_0 / (Scalar(12.0) * omega1_3);
  const Scalar f_3 = delta23 * eta22 * per_1 / (Scalar(2.0) * omega1);
  const Scalar f_4 = -omega2 * delta23 * eta22 * per_1 / (Scalar(2.0) * omega1_2);
  const Scalar f_5 = -alpha23 * eta22 * per_0 * per_1 / (Scalar(2.0) * omega1_2);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_5) * per_0;
  const Scalar q_1 = (f_3 + f_4 + f_5) * per_1;
  // by omega1
  gradient[0] = (-Scalar(2.0) * f_0 - Scalar(3.0) * f_1 - Scalar(3.0) * f_2 - f_3 - Scalar(2.0) * f_4
      - Scalar(2.0) * f_5) / omega1 - q_0 - q_1;
  gradient[1] = (f_0 + Scalar(2.0) * f_1 + f_4) / omega2 + q_0 + Scalar(2.0) * q_1;  // by omega2
  const Scalar c_0 = -per_0 / (Scalar(12.0) * omega1_3);  // multiplies alpha23*eta12
  const Scalar c_1 = -per_0 * per_1 / (Scalar(2.0) * omega1_2);  // multiplies alpha23*eta22
  // multiplies delta23*eta12
  const Scalar c_2 = (-Scalar(2.0) * omega1 * omega2 + omega2_2) * per_0 / (Scalar(12.0) * omega1_3);
  const Scalar c_3 = (omega1 - omega2) * per_1 / (Scalar(2.0) * omega1_2);  // multiplies delta23*eta22
  gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
  gradient[10] = eta12 * c_2 + eta22 * c_3;  // by delta23
  gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
  gradient[30] = alpha23 * c_1 + delta23 * c_3;  // by eta22
  return value;
}

/// harmonic_re_v2_A_v22_conjA_v1 = (2*omega1*omega2*delta35 - 3*omega2^2*delta35 + 3*alpha34)/((omega1 -
/// omega2)*(omega1 - 3*omega2)) + (4*omega1^2*omega2*delta22*delta23 - 8*omega1*omega2^2*delta22*delta23 +
/// 4*omega1*alpha23*delta22)/(omega2*(omega1 - 3*omega2)*(2*omega1 - omega2)) +
/// (-24*omega1^3*omega2^3*delta23*delta24 + 4*omega1^3*omega2*delta23*alpha24 +
/// 96*omega1^2*omega2^4*delta23*delta24 - 18*omega1^2*omega2^2*alpha23*delta24 -
/// 16*omega1^2*omega2^2*delta23*alpha24 + 2*omega1^2*alpha23*alpha24 - 120*omega1*omega2^5*delta23*delta24 +
/// 48*omega1*omega2^3*alpha23*delta24 + 28*omega1*omega2^3*delta23*alpha24 - 4*omega1*omega2*alpha23*alpha24 +
/// 36*omega2^6*delta23*delta24 - 36*omega2^4*alpha23*delta24 - 12*omega2^4*delta23*alpha24 +
/// 12*omega2^2*alpha23*alpha24)/(3*omega1*omega2^2*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)) +
/// (4*omega1*omega2^3*delta22*delta23 + 4*omega1*omega2*alpha23*delta22)/((omega1 + 2*omega2)*(omega1 -
/// omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)) + (-4*omega1^3*omega2*alpha22*delta23 +
/// 8*omega1^2*omega2^2*alpha22*delta23 - 4*omega1^2*alpha22*alpha23 + 12*omega1*omega2^3*alpha22*delta23 -
/// 4*omega1*omega2*alpha22*alpha23 - 30*omega2^4*alpha22*delta23 + 18*omega2^2*alpha22*alpha23)/(omega2*(omega1
/// + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 316 operations.
template <class Scalar>
Scalar lump_41(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar alpha34 = parameters[14];
  const Scalar delta35 = parameters[19];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(3.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_4 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar f_0 = Scalar(2.0) * omega1 * omega2 * delta35 * per_0 * per_1;
  const Scalar f_1 = -Scalar(3.0) * omega2_2 * delta35 * per_0 * per_1;
  const Scalar f_2 = Scalar(3.0) * alpha34 * per_0 * per_1;
  const Scalar f_3 = Scalar(4.0) * omega1_2 * delta22 * delta23 * per_1 * per_2;
  const Scalar f_4 = -Scalar(8.0) * omega1 * omega2 * delta22 * delta23 * per_1 * per_2;
  const Scalar f_5 = Scalar(4.0) * omega1 * alpha23 * delta22 * per_1 * per_2 / omega2;
  const Scalar f_6 = -Scalar(8.0) * omega1_2 * omega2 * delta23 * delta24 * per_0 * per_3 * per_1;
  const Scalar f_7 = Scalar(4.0) * omega1_2 * delta23 * alpha24 * per_0 * per_3 * per_1 / (Scalar(3.0) * omega2);
  const Scalar f_8 = Scalar(32.0) * omega1 * omega2_2 * delta23 * delta24 * per_0 * per_3 * per_1;
  const Scalar f_9 = (-Scalar(18.0) * omega1 * alpha23 * delta24
      - Scalar(16.0) * omega1 * delta23 * alpha24) * per_0 * per_3 * per_1 / Scalar(3.0);
  const Scalar f_10 = Scalar(2.0) * omega1 * alpha23 * alpha24 * per_0 * per_3 * per_1 / (Scalar(3.0) * omega2_2);
  const Scalar f_11 = -Scalar(40.0) * omega2_3 * delta23 * delta24 * per_0 * per_3 * per_1;
  const Scalar f_12 = (Scalar(48.0) * omega2 * alpha23 * delta24
      + Scalar(28.0) * omega2 * delta23 * alpha24) * per_0 * per_3 * per_1 / Scalar(3.0);
  const Scalar f_13 = -Scalar(4.0) * alpha23 * alpha24 * per_0 * per_3 * per_1 / (Scalar(3.0) * omega2);
  const Scalar f_14 = Scalar(12.0) * omega2_4 * delta23 * delta24 * per_0 * per_3 * per_1 / omega1;
  const Scalar f_15 = (-Scalar(12.0) * omega2_2 * alpha23 * delta24
      - Scalar(4.0) * omega2_2 * delta23 * alpha24) * per_0 * per_3 * per_1 / omega1;
  const Scalar f_16 = Scalar(4.0) * alpha23 * alpha24 * per_0 * per_3 * per_1 / omega1;
  const Scalar f_17 = Scalar(4.0) * omega1 * omega2_3 * delta22 * delta23 * per_4 * per_0 * per_3 * per_1;
  const Scalar f_18 = Scalar(4.0) * omega1 * omega2 * alpha23 * delta22 * per_4 * per_0 * per_3 * per_1;
  const Scalar f_19 = -Scalar(4.0) * omega1_3 * alpha22 * delta23 * per_4 * per_0 * per_3 * per_1 * per_2;
  const Scalar f_20 = Scalar(8.0) * omega1_2 * omega2 * alpha22 * delta23 * per_4 * per_0 * per_3 * per_1 * per_2;
  const Scalar f_21 = -Scalar(4.0) * omega1_2 * alpha22 * alpha23 * per_4 * per_0 * per_3 * per_1 * per_2 / omega2;
  const Scalar f_22 = Scalar(12.0) * omega1 * omega2_2 * alpha22 * delta23 * per_4 * per_0 * per_3 * per_1 * per_2;
  const Scalar f_23 = -Scalar(4.0) * omega1 * alpha22 * alpha23 * per_4 * per_0 * per_3 * per_1 * per_2;
  const Scalar f_24 = -Scalar(30.0) * omega2_3 * alpha22 * delta23 * per_4 * per_0 * per_3 * per_1 * per_2;
  const Scalar f_25 = Scalar(18.0) * omega2 * alpha22 * alpha23 * per_4 * per_0 * per_3 * per_1 * per_2;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14
      + f_15 + f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14 + f_15 + f_16
      + f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14
      + f_15 + f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_1;
  const Scalar q_2 = (f_3 + f_4 + f_5 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_2;
  const Scalar q_3 = (f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14 + f_15 + f_16 + f_17 + f_18 + f_19
      + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_3;
  const Scalar q_4 = (f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_4;
  // by omega1
  gradient[0] = (f_0 + Scalar(2.0) * f_3 + f_4 + f_5 + Scalar(2.0) * f_6 + Scalar(2.0) * f_7 + f_8 + f_9 + f_10
      - f_14 - f_15 - f_16 + f_17 + f_18 + Scalar(3.0) * f_19 + Scalar(2.0) * f_20 + Scalar(2.0) * f_21 + f_22
      + f_23) / omega1 - q_0 - q_1 - Scalar(2.0) * q_2 - q_3 - q_4;
  // by omega2
  gradient[1] = (f_0 + Scalar(2.0) * f_1 + f_4 - f_5 + f_6 - f_7 + Scalar(2.0) * f_8 - Scalar(2.0) * f_10
      + Scalar(3.0) * f_11 + f_12 - f_13 + Scalar(4.0) * f_14 + Scalar(2.0) * f_15 + Scalar(3.0) * f_17 + f_18
      + f_20 - f_21 + Scalar(2.0) * f_22 + Scalar(3.0) * f_24 + f_25) / omega2 + q_0 + Scalar(3.0) * q_1 + q_2
      + Scalar(2.0) * q_3 - Scalar(2.0) * q_4;
  // multiplies alpha22*alpha23
  const Scalar c_0 = (-Scalar(4.0) * omega1_2 - Scalar(4.0) * omega1 * omega2
      + Scalar(18.0) * omega2_2) * per_4 * per_0 * per_3 * per_1 * per_2 / omega2;
  // multiplies alpha22*delta23
  const Scalar c_1 = (-Scalar(4.0) * omega1_3 + Scalar(8.0) * omega1_2 * omega2 + Scalar(12.0) * omega1 * omega2_2
      - Scalar(30.0) * omega2_3) * per_4 * per_0 * per_3 * per_1 * per_2;
  // multiplies alpha23*delta22
  const Scalar c_2 = Scalar(4.0) * omega1 * per_1 * per_2 / omega2
      + Scalar(4.0) * omega1 * omega2 * per_4 * per_0 * per_3 * per_1;
  // multiplies alpha23*alpha24
  const Scalar c_3 = (Scalar(2.0) * omega1_2 - Scalar(4.0) * omega1 * omega2
      + Scalar(12.0) * omega2_2) * per_0 * per_3 * per_1 / (Scalar(3.0) * omega1 * omega2_2);
  // multiplies alpha23*delta24
  const Scalar c_4 = (-Scalar(6.0) * omega1_2 + Scalar(16.0) * omega1 * omega2
      - Scalar(12.0) * omega2_2) * per_0 * per_3 * per_1 / omega1;
  // multiplies delta22*delta23
  const Scalar c_5 = (Scalar(4.0) * omega1_2 - Scalar(8.0) * omega1 * omega2) * per_1 * per_2
      + Scalar(4.0) * omega1 * omega2_3 * per_4 * per_0 * per_3 * per_1;
  // multiplies delta23*alpha24
  const Scalar c_6 = (Scalar(4.0) * omega1_3 - Scalar(16.0) * omega1_2 * omega2 + Scalar(28.0) * omega1 * omega2_2
      - Scalar(12.0) * omega2_3) * per_0 * per_3 * per_1 / (Scalar(3.0) * omega1 * omega2);
  // multiplies delta23*delta24
  const Scalar c_7 = (-Scalar(8.0) * omega1_3 * omega2 + Scalar(32.0) * omega1_2 * omega2_2
      - Scalar(40.0) * omega1 * omega2_3 + Scalar(12.0) * omega2_4) * per_0 * per_3 * per_1 / omega1;
  const Scalar c_8 = Scalar(3.0) * per_0 * per_1;  // multiplies alpha34
  // multiplies delta35
  const Scalar c_9 = (Scalar(2.0) * omega1 * omega2 - Scalar(3.0) * omega2_2) * per_0 * per_1;
  gradient[6] = alpha23 * c_0 + delta23 * c_1;  // by alpha22
  gradient[7] = alpha22 * c_0 + delta22 * c_2 + alpha24 * c_3 + delta24 * c_4;  // by alpha23
  gradient[9] = alpha23 * c_2 + delta23 * c_5;  // by delta22
  gradient[10] = alpha22 * c_1 + delta22 * c_5 + alpha24 * c_6 + delta24 * c_7;  // by delta23
  gradient[14] = c_8;  // by alpha34
  gradient[19] = c_9;  // by delta35
  gradient[25] = alpha23 * c_3 + delta23 * c_6;  // by alpha24
  gradient[26] = alpha23 * c_4 + delta23 * c_7;  // by delta24
  return value;
}

/// harmonic_re_v2_A_v22_F = (9*omega1^2*omega2^2*delta24*eta22 - omega1^2*alpha24*eta22 -
/// 24*omega1*omega2^3*delta24*eta22 + 2*omega1*omega2*alpha24*eta22 + 18*omega2^4*delta24*eta22 -
/// 6*omega2^2*alpha24*eta22)/(6*omega1*omega2^2*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 68 operations.
template <class Scalar>
Scalar lump_42(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 - Scalar(3.0) * omega2);
  const Scalar f_0 = Scalar(3.0) * omega1 * delta24 * eta22 * per_0 * per_1 * per_2 / Scalar(2.0);
  const Scalar f_1 = -omega1 * alpha24 * eta22 * per_0 * per_1 * per_2 / (Scalar(6.0) * omega2_2);
  const Scalar f_2 = -Scalar(4.0) * omega2 * delta24 * eta22 * per_0 * per_1 * per_2;
  const Scalar f_3 = alpha24 * eta22 * per_0 * per_1 * per_2 / (Scalar(3.0) * omega2);
  const Scalar f_4 = Scalar(3.0) * omega2_2 * delta24 * eta22 * per_0 * per_1 * per_2 / omega1;
  const Scalar f_5 = -alpha24 * eta22 * per_0 * per_1 * per_2 / omega1;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_1;
  const Scalar q_2 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_2;
  gradient[0] = (f_0 + f_1 - f_4 - f_5) / omega1 - q_0 - q_1 - q_2;  // by omega1
  // by omega2
  gradient[1] = (-Scalar(2.0) * f_1 + f_2 - f_3 + Scalar(2.0) * f_4) / omega2 + q_0 + Scalar(2.0) * q_1
      + Scalar(3.0) * q_2;
  // multiplies alpha24*eta22
  const Scalar c_0 = (-omega1_2 + Scalar(2.0) * omega1 * omega2
      - Scalar(6.0) * omega2_2) * per_0 * per_1 * per_2 / (Scalar(6.0) * omega1 * omega2_2);
  // multiplies delta24*eta22
  const Scalar c_1 = (Scalar(3.0) * omega1_2 - Scalar(8.0) * omega1 * omega2
      + Scalar(6.0) * omega2_2) * per_0 * per_1 * per_2 / (Scalar(2.0) * omega1);
  gradient[25] = eta22 * c_0;  // by alpha24
  gradient[26] = eta22 * c_1;  // by delta24
  gradient[30] = alpha24 * c_0 + delta24 * c_1;  // by eta22
  return value;
}

/// harmonic_re_v2_A_v1_A_v2_F = (2*omega1*omega2*delta23*eta12 + omega2^2*delta23*eta12 -
/// alpha23*eta12)/(12*omega1^3*(omega1 + omega2)) + (omega1*delta23*eta22 +
/// omega2*delta23*eta22)/(2*omega1^2*(omega1 + 2*omega2)) - alpha23*eta22/(2*omega1^2*(omega1 + omega2)*(omega1
/// + 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 50 operations.
template <class Scalar>
Scalar lump_43(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha23 = parameters[7];
  const Scalar delta23 = parameters[10];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar f_0 = omega2 * delta23 * eta12 * per_0 / (Scalar(6.0) * omega1_2);
  const Scalar f_1 = omega2_2 * delta23 * eta12 * per_0 / (Scalar(12.0) * omega1_3);
  const Scalar f_2 = -alpha23 * eta12 * per_0 / (Scalar(12.0) * omega1_3);
  const Scalar f_3 = delta23 * eta22 * per_1 / (Scalar(2.0) * omega1);
  const Scalar f_4 = omega2 * delta23 * eta22 * per_1 / (Scalar(2.0) * omega1_2);
  const Scalar f_5 = -alpha23 * eta22 * per_0 * per_1 / (Scalar(2.0) * omega1_2);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_5) * per_0;
  const Scalar q_1 = (f_3 + f_4 + f_5) * per_1;
  // by omega1
  gradient[0] = (-Scalar(2.0) * f_0 - Scalar(3.0) * f_1 - Scalar(3.0) * f_2 - f_3 - Scalar(2.0) * f_4
      - Scalar(2.0) * f_5) / omega1 - q_0 - q_1;
  gradient[1] = (f_0 + Scalar(2.0) * f_1 + f_4) / omega2 - q_0 - Scalar(2.0) * q_1;  // by omega2
  const Scalar c_0 = -per_0 / (Scalar(12.0) * omega1_3);  // multiplies alpha23*eta12
  const Scalar c_1 = -per_0 * per_1 / (Scalar(2.0) * omega1_2);  // multiplies alpha23*eta22
  // multiplies delta23*eta12
  const Scalar c_2 = (Scalar(2.0) * omega1 * omega2 + omega2_2) * per_0 / (Scalar(12.0) * omega1_3);
  const Scalar c_3 = (omega1 + omega2) * per_1 / (Scalar(2.0) * omega1_2);  // multiplies delta23*eta22
  gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
  gradient[10] = eta12 * c_2 + eta22 * c_3;  // by delta23
  gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
  gradient[30] = alpha23 * c_1 + delta23 * c_3;  // by eta22
  return value;
}

/// harmonic_re_v2_A_v12_A_v2 = (3*omega1^4*delta33 + 12*omega1^3*omega2*delta21*delta23 -
/// 6*omega1^3*omega2*delta34 + 6*omega1^2*omega2^2*delta21*delta23 - 3*omega1^2*omega2^2*delta34 -
/// 6*omega1^2*alpha23*delta21 + 3*omega1^2*alpha33 - 4*omega1*omega2*alpha21*delta23 -
/// 2*omega2^2*alpha21*delta23 + 2*alpha21*alpha23)/(12*omega1^3*(omega1 + omega2)) +
/// (2*omega1^2*omega2*delta23^2 + 3*omega1*omega2^2*delta23^2 - 2*omega1*alpha23*delta23 + omega2^3*delta23^2 -
/// 2*omega2*alpha23*delta23)/(omega1^2*(omega1 + 2*omega2)) + (-omega1^2*delta22^2 -
/// omega1*omega2*delta22^2)/(omega2*(2*omega1 + omega2)) + alpha23^2/(omega1^2*(omega1 + omega2)*(omega1 +
/// 2*omega2)) + alpha22^2/(omega1*omega2*(omega1 + omega2)*(2*omega1 + omega2)) + (-4*omega1^4*delta22*delta24 -
/// 2*omega1^3*omega2*delta22*delta24 - omega1^2*omega2^2*delta22*delta24 - 4*omega1^2*alpha22*delta24 +
/// omega1^2*delta22*alpha24 - 2*omega1*omega2*alpha22*delta24 - omega2^2*alpha22*delta24 +
/// alpha22*alpha24)/(2*omega1*(omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 213 operations.
template <class Scalar>
Scalar lump_44(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar alpha33 = parameters[13];
  const Scalar delta33 = parameters[17];
  const Scalar delta34 = parameters[18];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar alpha22_2 = alpha22 * alpha22;
  const Scalar alpha23_2 = alpha23 * alpha23;
  const Scalar delta22_2 = delta22 * delta22;
  const Scalar delta23_2 = delta23 * delta23;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = omega1 * delta33 * per_0 / Scalar(4.0);
  const Scalar f_1 = (Scalar(2.0) * omega2 * delta21 * delta23 - omega2 * delta34) * per_0 / Scalar(2.0);
  const Scalar f_2 = (Scalar(2.0) * omega2_2 * delta21 * delta23
      - omega2_2 * delta34) * per_0 / (Scalar(4.0) * omega1);
  const Scalar f_3 = (-Scalar(2.0) * alpha23 * delta21 + alpha33) * per_0 / (Scalar(4.0) * omega1);
  const Scalar f_4 = -omega2 * alpha21 * delta23 * per_0 / (Scalar(3.0) * omega1_2);
  const Scalar f_5 = -omega2_2 * alpha21 * delta23 * per_0 / (Scalar(6.0) * omega1_3);
  const Scalar f_6 = alpha21 * alpha23 * per_0 / (Scalar(6.0) * omega1_3);
  const Scalar f_7 = Scalar(2.0) * omega2 * delta23_2 * per_1;
  const Scalar f_8 = Scalar(3.0) * omega2_2 * delta23_2 * per_1 / omega1;
  const Scalar f_9 = -Scalar(2.0) * alpha23 * delta23 * per_1 / omega1;
  const Scalar f_10 = omega2_3 * delta23_2 * per_1 / omega1_2;
  const Scalar f_11 = -Scalar(2.0) * omega2 * alpha23 * delta23 * per_1 / omega1_2;
  const Scalar f_12 = -omega1_2 * delta22_2 * per_2 / omega2;
  const Scalar f_13 = -omega1 * delta22_2 * per_2;
  const Scalar f_14 = alpha23_2 * per_0 * per_1 / omega1_2;
  const Scalar f_15 = alpha22_2 * per_0 * per_2 / (omega1 * omega2);
  const Scalar f_16 = -Scalar(2.0) * omega1_3 * delta22 * delta24 * per_0 * per_2 * per_3;
  const Scalar f_17 = -omega1_2 * omega2 * delta22 * delta24 * per_0 * per_2 * per_3;
  const Scalar f_18 = -omega1 * omega2_2 * delta22 * delta24 * per_0 * per_2 * per_3 / Scalar(2.0);
  const Scalar f_19 = (-Scalar(4.0) * omega1 * alpha22 * delta24
      + omega1 * delta22 * alpha24) * per_0 * per_2 * per_3 / Scalar(2.0);
  const Scalar f_20 = -omega2 * alpha22 * delta24 * per_0 * per_2 * per_3;
  const Scalar f_21 = -omega2_2 * alpha22 * delta24 * per_0 * per_2 * per_3 / (Scalar(2.0) * omega1);
  const Scalar f_22 = alpha22 * alpha24 * per_0 * per_2 * per_3 / (Scalar(2.0) * omega1);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14
      + f_15 + f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_14 + f_15 + f_16 + f_17 + f_18 + f_19 + f_20
      + f_21 + f_22) * per_0;
  const Scalar q_1 = (f_7 + f_8 + f_9 + f_10 + f_11 + f_14) * per_1;
  const Scalar q_2 = (f_12 + f_13 + f_15 + f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22) * per_2;
  const Scalar q_3 = (f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22) * per_3;
  // by omega1
  gradient[0] = (f_0 - f_2 - f_3 - Scalar(2.0) * f_4 - Scalar(3.0) * f_5 - Scalar(3.0) * f_6 - f_8 - f_9
      - Scalar(2.0) * f_10 - Scalar(2.0) * f_11 + Scalar(2.0) * f_12 + f_13 - Scalar(2.0) * f_14 - f_15
      + Scalar(3.0) * f_16 + Scalar(2.0) * f_17 + f_18 + f_19 - f_21 - f_22) / omega1 - q_0 - q_1
      - Scalar(2.0) * q_2 - Scalar(2.0) * q_3;
  // by omega2
  gradient[1] = (f_1 + Scalar(2.0) * f_2 + f_4 + Scalar(2.0) * f_5 + f_7 + Scalar(2.0) * f_8 + Scalar(3.0) * f_10
      + f_11 - f_12 - f_15 + f_17 + Scalar(2.0) * f_18 + f_20 + Scalar(2.0) * f_21) / omega2 - q_0
      - Scalar(2.0) * q_1 - q_2 + q_3;
  const Scalar c_0 = per_0 / (Scalar(6.0) * omega1_3);  // multiplies alpha21*alpha23
  // multiplies alpha21*delta23
  const Scalar c_1 = (-Scalar(2.0) * omega1 * omega2 - omega2_2) * per_0 / (Scalar(6.0) * omega1_3);
  const Scalar c_2 = per_0 * per_2 / (omega1 * omega2);  // multiplies alpha22^2
  const Scalar c_3 = per_0 * per_2 * per_3 / (Scalar(2.0) * omega1);  // multiplies alpha22*alpha24
  // multiplies alpha22*delta24
  const Scalar c_4 = (-Scalar(4.0) * omega1_2 - Scalar(2.0) * omega1 * omega2
      - omega2_2) * per_0 * per_2 * per_3 / (Scalar(2.0) * omega1);
  const Scalar c_5 = per_0 * per_1 / omega1_2;  // multiplies alpha23^2
  const Scalar c_6 = -per_0 / (Scalar(2.0) * omega1);  // multiplies alpha23*delta21
  // multiplies alpha23*delta23
  const Scalar c_7 = (-Scalar(2.0) * omega1 - Scalar(2.0) * omega2) * per_1 / omega1_2;
  // multiplies delta21*delta23
  const Scalar c_8 = (Scalar(2.0) * omega1 * omega2 + omega2_2) * per_0 / (Scalar(2.0) * omega1);
  const Scalar c_9 = (-omega1_2 - omega1 * omega2) * per_2 / omega2;  // multiplies delta22^2
  const Scalar c_10 = omega1 * per_0 * per_2 * per_3 / Scalar(2.0);  // multiplies delta22*alpha24
  // multiplies delta22*delta24
  const Scalar c_11 = (-Scalar(4.0) * omega1_3 - Scalar(2.0) * omega1_2 * omega2
      - omega1 * omega2_2) * per_0 * per_2 * per_3 / Scalar(2.0);
  // multiplies delta23^2
  const Scalar c_12 = (Scalar(2.0) * omega1_2 * omega2 + Scalar(3.0) * omega1 * omega2_2
      + omega2_3) * per_1 / omega1_2;
  const Scalar c_13 = per_0 / (Scalar(4.0) * omega1);  // multiplies alpha33
  const Scalar c_14 = omega1 * per_0 / Scalar(4.0);  // multiplies delta33
  // multiplies delta34
  const Scalar c_15 = (-Scalar(2.0) * omega1 * omega2 - omega2_2) * per_0 / (Scalar(4.0) * omega1);
  gradient[5] = alpha23 * c_0 + delta23 * c_1;  // by alpha21
  gradient[6] = Scalar(2.0) * alpha22 * c_2 + alpha24 * c_3 + delta24 * c_4;  // by alpha22
  gradient[7] = alpha21 * c_0 + Scalar(2.0) * alpha23 * c_5 + delta21 * c_6 + delta23 * c_7;  // by alpha23
  gradient[8] = alpha23 * c_6 + delta23 * c_8;  // by delta21
  gradient[9] = Scalar(2.0) * delta22 * c_9 + alpha24 * c_10 + delta24 * c_11;  // by delta22
  gradient[10] = alpha21 * c_1 + alpha23 * c_7 + delta21 * c_8 + Scalar(2.0) * delta23 * c_12;  // by delta23
  gradient[13] = c_13;  // by alpha33
  gradient[17] = c_14;  // by delta33
  gradient[18] = c_15;  // by delta34
  gradient[25] = alpha22 * c_3 + delta22 * c_10;  // by alpha24
  gradient[26] = alpha22 * c_4 + delta22 * c_11;  // by delta24
  return value;
}

/// harmonic_re_v2_A_v1_A_v22 = (-2*omega1*omega2*delta35 - 3*omega2^2*delta35 + 3*alpha34)/((omega1 +
/// omega2)*(omega1 + 3*omega2)) + (4*omega1^2*omega2*delta22*delta23 + 8*omega1*omega2^2*delta22*delta23 -
/// 4*omega1*alpha23*delta22)/(omega2*(omega1 + 3*omega2)*(2*omega1 + omega2)) +
/// (24*omega1^3*omega2^3*delta23*delta24 - 4*omega1^3*omega2*delta23*alpha24 +
/// 96*omega1^2*omega2^4*delta23*delta24 - 18*omega1^2*omega2^2*alpha23*delta24 -
/// 16*omega1^2*omega2^2*delta23*alpha24 + 2*omega1^2*alpha23*alpha24 + 120*omega1*omega2^5*delta23*delta24 -
/// 48*omega1*omega2^3*alpha23*delta24 - 28*omega1*omega2^3*delta23*alpha24 + 4*omega1*omega2*alpha23*alpha24 +
/// 36*omega2^6*delta23*delta24 - 36*omega2^4*alpha23*delta24 - 12*omega2^4*delta23*alpha24 +
/// 12*omega2^2*alpha23*alpha24)/(3*omega1*omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)) +
/// (-4*omega1*omega2^3*delta22*delta23 - 4*omega1*omega2*alpha23*delta22)/((omega1 + omega2)*(omega1 +
/// 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)) + (-4*omega1^3*omega2*alpha22*delta23 -
/// 8*omega1^2*omega2^2*alpha22*delta23 + 4*omega1^2*alpha22*alpha23 + 12*omega1*omega2^3*alpha22*delta23 -
/// 4*omega1*omega2*alpha22*alpha23 + 30*omega2^4*alpha22*delta23 - 18*omega2^2*alpha22*alpha23)/(omega2*(omega1
/// + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(2*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 316 operations.
template <class Scalar>
Scalar lump_45(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar alpha34 = parameters[14];
  const Scalar delta35 = parameters[19];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(3.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_4 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = -Scalar(2.0) * omega1 * omega2 * delta35 * per_0 * per_1;
  const Scalar f_1 = -Scalar(3.0) * omega2_2 * delta35 * per_0 * per_1;
  const Scalar f_2 = Scalar(3.0) * alpha34 * per_0 * per_1;
  const Scalar f_3 = Scalar(4.0) * omega1_2 * delta22 * delta23 * per_1 * per_2;
  const Scalar f_4 = Scalar(8.0) * omega1 * omega2 * delta22 * delta23 * per_1 * per_2;
  const Scalar f_5 = -Scalar(4.0) * omega1 * alpha23 * delta22 * per_1 * per_2 / omega2;
  const Scalar f_6 = Scalar(8.0) * omega1_2 * omega2 * delta23 * delta24 * per_0 * per_3 * per_1;
  const Scalar f_7 = -Scalar(4.0) * omega1_2 * delta23 * alpha24 * per_0 * per_3 * per_1 / (Scalar(3.0) * omega2);
  const Scalar f_8 = Scalar(32.0) * omega1 * omega2_2 * delta23 * delta24 * per_0 * per_3 * per_1;
  const Scalar f_9 = (-Scalar(18.0) * omega1 * alpha23 * delta24
      - Scalar(16.0) * omega1 * delta23 * alpha24) * per_0 * per_3 * per_1 / Scalar(3.0);
  const Scalar f_10 = Scalar(2.0) * omega1 * alpha23 * alpha24 * per_0 * per_3 * per_1 / (Scalar(3.0) * omega2_2);
  const Scalar f_11 = Scalar(40.0) * omega2_3 * delta23 * delta24 * per_0 * per_3 * per_1;
  const Scalar f_12 = (-Scalar(48.0) * omega2 * alpha23 * delta24
      - Scalar(28.0) * omega2 * delta23 * alpha24) * per_0 * per_3 * per_1 / Scalar(3.0);
  const Scalar f_13 = Scalar(4.0) * alpha23 * alpha24 * per_0 * per_3 * per_1 / (Scalar(3.0) * omega2);
  const Scalar f_14 = Scalar(12.0) * omega2_4 * delta23 * delta24 * per_0 * per_3 * per_1 / omega1;
  const Scalar f_15 = (-Scalar(12.0) * omega2_2 * alpha23 * delta24
      - Scalar(4.0) * omega2_2 * delta23 * alpha24) * per_0 * per_3 * per_1 / omega1;
  const Scalar f_16 = Scalar(4.0) * alpha23 * alpha24 * per_0 * per_3 * per_1 / omega1;
  const Scalar f_17 = -Scalar(4.0) * omega1 * omega2_3 * delta22 * delta23 * per_0 * per_3 * per_1 * per_4;
  const Scalar f_18 = -Scalar(4.0) * omega1 * omega2 * alpha23 * delta22 * per_0 * per_3 * per_1 * per_4;
  const Scalar f_19 = -Scalar(4.0) * omega1_3 * alpha22 * delta23 * per_0 * per_3 * per_1 * per_4 * per_2;
  const Scalar f_20 = -Scalar(8.0) * omega1_2 * omega2 * alpha22 * delta23 * per_0 * per_3 * per_1 * per_4 * per_2;
  const Scalar f_21 = Scalar(4.0) * omega1_2 * alpha22 * alpha23 * per_0 * per_3 * per_1 * per_4 * per_2 / omega2;
  const Scalar f_22 = Scalar(12.0) * omega1 * omega2_2 * alpha22 * delta23 * per_0 * per_3 * per_1 * per_4 * per_2;
  const Scalar f_23 = -Scalar(4.0) * omega1 * alpha22 * alpha23 * per_0 * per_3 * per_1 * per_4 * per_2;
  const Scalar f_24 = Scalar(30.0) * omega2_3 * alpha22 * delta23 * per_0 * per_3 * per_1 * per_4 * per_2;
  const Scalar f_25 = -Scalar(18.0) * omega2 * alpha22 * alpha23 * per_0 * per_3 * per_1 * per_4 * per_2;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14
      + f_15 + f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14 + f_15 + f_16
      + f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14
      + f_15 + f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_1;
  const Scalar q_2 = (f_3 + f_4 + f_5 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_2;
  const Scalar q_3 = (f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14 + f_15 + f_16 + f_17 + f_18 + f_19
      + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_3;
  const Scalar q_4 = (f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_4;
  // by omega1
  gradient[0] = (f_0 + Scalar(2.0) * f_3 + f_4 + f_5 + Scalar(2.0) * f_6 + Scalar(2.0) * f_7 + f_8 + f_9 + f_10
      - f_14 - f_15 - f_16 + f_17 + f_18 + Scalar(3.0) * f_19 + Scalar(2.0) * f_20 + Scalar(2.0) * f_21 + f_22
      + f_23) / omega1 - q_0 - q_1 - Scalar(2.0) * q_2 - q_3 - q_4;
  // by omega2
  gradient[1] = (f_0 + Scalar(2.0) * f_1 + f_4 - f_5 + f_6 - f_7 + Scalar(2.0) * f_8 - Scalar(2.0) * f_10
      + Scalar(3.0) * f_11 + f_12 - f_13 + Scalar(4.0) * f_14 + Scalar(2.0) * f_15 + Scalar(3.0) * f_17 + f_18
      + f_20 - f_21 + Scalar(2.0) * f_22 + Scalar(3.0) * f_24 + f_25) / omega2 - q_0 - Scalar(3.0) * q_1 - q_2
      - Scalar(2.0) * q_3 + Scalar(2.0) * q_4;
  // multiplies alpha22*alpha23
  const Scalar c_0 = (Scalar(4.0) * omega1_2 - Scalar(4.0) * omega1 * omega2
      - Scalar(18.0) * omega2_2) * per_0 * per_3 * per_1 * per_4 * per_2 / omega2;
  // multiplies alpha22*delta23
  const Scalar c_1 = (-Scalar(4.0) * omega1_3 - Scalar(8.0) * omega1_2 * omega2 + Scalar(12.0) * omega1 * omega2_2
      + Scalar(30.0) * omega2_3) * per_0 * per_3 * per_1 * per_4 * per_2;
  // multiplies alpha23*delta22
  const Scalar c_2 = -Scalar(4.0) * omega1 * per_1 * per_2 / omega2
      - Scalar(4.0) * omega1 * omega2 * per_0 * per_3 * per_1 * per_4;
  // multiplies alpha23*alpha24
  const Scalar c_3 = (Scalar(2.0) * omega1_2 + Scalar(4.0) * omega1 * omega2
      + Scalar(12.0) * omega2_2) * per_0 * per_3 * per_1 / (Scalar(3.0) * omega1 * omega2_2);
  // multiplies alpha23*delta24
  const Scalar c_4 = (-Scalar(6.0) * omega1_2 - Scalar(16.0) * omega1 * omega2
      - Scalar(12.0) * omega2_2) * per_0 * per_3 * per_1 / omega1;
  // multiplies delta22*delta23
  const Scalar c_5 = (Scalar(4.0) * omega1_2 + Scalar(8.0) * omega1 * omega2) * per_1 * per_2
      - Scalar(4.0) * omega1 * omega2_3 * per_0 * per_3 * per_1 * per_4;
  // multiplies delta23*alpha24
  const Scalar c_6 = (-Scalar(4.0) * omega1_3 - Scalar(16.0) * omega1_2 * omega2 - Scalar(28.0) * omega1 * omega2_2
      - Scalar(12.0) * omega2_3) * per_0 * per_3 * per_1 / (Scalar(3.0) * omega1 * omega2);
  // multiplies delta23*delta24
  const Scalar c_7 = (Scalar(8.0) * omega1_3 * omega2 + Scalar(32.0) * omega1_2 * omega2_2
      + Scalar(40.0) * omega1 * omega2_3 + Scalar(12.0) * omega2_4) * per_0 * per_3 * per_1 / omega1;
  const Scalar c_8 = Scalar(3.0) * per_0 * per_1;  // multiplies alpha34
  // multiplies delta35
  const Scalar c_9 = (-Scalar(2.0) * omega1 * omega2 - Scalar(3.0) * omega2_2) * per_0 * per_1;
  gradient[6] = alpha23 * c_0 + delta23 * c_1;  // by alpha22
  gradient[7] = alpha22 * c_0 + delta22 * c_2 + alpha24 * c_3 + delta24 * c_4;  // by alpha23
  gradient[9] = alpha23 * c_2 + delta23 * c_5;  // by delta22
  gradient[10] = alpha22 * c_1 + delta22 * c_5 + alpha24 * c_6 + delta24 * c_7;  // by delta23
  gradient[14] = c_8;  // by alpha34
  gradient[19] = c_9;  // by delta35
  gradient[25] = alpha23 * c_3 + delta23 * c_6;  // by alpha24
  gradient[26] = alpha23 * c_4 + delta23 * c_7;  // by delta24
  return value;
}

/// harmonic_re_v2_A_v23 = (42*omega2^4*delta24^2 - 6*omega2^4*delta36 - 20*omega2^2*alpha24*delta24 +
/// 3*omega2^2*alpha35 + 2*alpha24^2)/(24*omega2^4) + (3*omega2^4*delta23^2 + 2*omega2^2*alpha23*delta23 -
/// alpha23^2)/(4*omega2^2*(omega1 + 2*omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 53 operations.
template <class Scalar>
Scalar lump_46(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha23 = parameters[7];
  const Scalar delta23 = parameters[10];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar alpha35 = parameters[27];
  const Scalar delta36 = parameters[28];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar alpha23_2 = alpha23 * alpha23;
  const Scalar delta23_2 = delta23 * delta23;
  const Scalar alpha24_2 = alpha24 * alpha24;
  const Scalar delta24_2 = delta24 * delta24;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = (Scalar(7.0) * delta24_2 - delta36) / Scalar(4.0);
  const Scalar f_1 = (-Scalar(20.0) * alpha24 * delta24 + Scalar(3.0) * alpha35) / (Scalar(24.0) * omega2_2);
  const Scalar f_2 = alpha24_2 / (Scalar(12.0) * omega2_4);
  const Scalar f_3 = Scalar(3.0) * omega2_2 * delta23_2 * per_0 * per_1 / Scalar(4.0);
  const Scalar f_4 = alpha23 * delta23 * per_0 * per_1 / Scalar(2.0);
  const Scalar f_5 = -alpha23_2 * per_0 * per_1 / (Scalar(4.0) * omega2_2);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_3 + f_4 + f_5) * per_0;
  const Scalar q_1 = (f_3 + f_4 + f_5) * per_1;
  gradient[0] = -q_0 - q_1;  // by omega1
  // by omega2
  gradient[1] = (-Scalar(2.0) * f_1 - Scalar(4.0) * f_2 + Scalar(2.0) * f_3 - Scalar(2.0) * f_5) / omega2
      - Scalar(2.0) * q_0 + Scalar(2.0) * q_1;
  const Scalar c_0 = -per_0 * per_1 / (Scalar(4.0) * omega2_2);  // multiplies alpha23^2
  const Scalar c_1 = per_0 * per_1 / Scalar(2.0);  // multiplies alpha23*delta23
  const Scalar c_2 = Scalar(3.0) * omega2_2 * per_0 * per_1 / Scalar(4.0);  // multiplies delta23^2
  const Scalar c_3 = Scalar(1.0) / (Scalar(12.0) * omega2_4);  // multiplies alpha24^2
  const Scalar c_4 = -Scalar(5.0) / (Scalar(6.0) * omega2_2);  // multiplies alpha24*delta24
  const Scalar c_5 = Scalar(7.0) / Scalar(4.0);  // multiplies delta24^2
  const Scalar c_6 = Scalar(1.0) / (Scalar(8.0) * omega2_2);  // multiplies alpha35
  const Scalar c_7 = -Scalar(1.0) / Scalar(4.0);  // multiplies delta36
  gradient[7] = Scalar(2.0) * alpha23 * c_0 + delta23 * c_1;  // by alpha23
  gradient[10] = alpha23 * c_1 + Scalar(2.0) * delta23 * c_2;  // by delta23
  gradient[25] = Scalar(2.0) * alpha24 * c_3 + delta24 * c_4;  // by alpha24
  gradient[26] = alpha24 * c_4 + Scalar(2.0) * delta24 * c_5;  // by delta24
  gradient[27] = c_6;  // by alpha35
  gradient[28] = c_7;  // by delta36
  return value;
}

/// harmonic_re_v2_A_v13 = (-12*omega1^4*delta21*delta22 + 3*omega1^4*delta32 + 4*omega1^2*alpha21*delta22 -
/// 6*omega1^2*alpha22*delta21 + 3*omega1^2*alpha32 + 2*alpha21*alpha22)/(3*omega1^2*(3*omega1 +
/// omega2)*(3*omega1 - omega2)) + (-12*omega1^4*delta22*delta23 - 12*omega1^2*alpha22*delta23 +
/// 2*omega1^2*alpha23*delta22 + 2*alpha22*alpha23)/((2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 +
/// omega2)*(3*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 94 operations.
template <class Scalar>
Scalar lump_47(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar alpha32 = parameters[12];
  const Scalar delta32 = parameters[16];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar per_0 = Scalar(1.0) / (Scalar(3.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(3.0) * omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = (-Scalar(4.0) * omega1_2 * delta21 * delta22 + omega1_2 * delta32) * per_0 * per_1;
  const Scalar f_1 = (Scalar(4.0) * alpha21 * delta22 - Scalar(6.0) * alpha22 * delta21
      + Scalar(3.0) * alpha32) * per_0 * per_1 / Scalar(3.0);
  const Scalar f_2 = Scalar(2.0) * alpha21 * alpha22 * per_0 * per_1 / (Scalar(3.0) * omega1_2);
  const Scalar f_3 = -Scalar(12.0) * omega1_4 * delta22 * delta23 * per_2 * per_3 * per_0 * per_1;
  const Scalar f_4 = (-Scalar(12.0) * omega1_2 * alpha22 * delta23
      + Scalar(2.0) * omega1_2 * alpha23 * delta22) * per_2 * per_3 * per_0 * per_1;
  const Scalar f_5 = Scalar(2.0) * alpha22 * alpha23 * per_2 * per_3 * per_0 * per_1;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_1;
  const Scalar q_2 = (f_3 + f_4 + f_5) * per_2;
  const Scalar q_3 = (f_3 + f_4 + f_5) * per_3;
  // by omega1
  gradient[0] = (Scalar(2.0) * f_0 - Scalar(2.0) * f_2 + Scalar(4.0) * f_3 + Scalar(2.0) * f_4) / omega1
      - Scalar(3.0) * q_0 - Scalar(3.0) * q_1 - Scalar(2.0) * q_2 - Scalar(2.0) * q_3;
  gradient[1] = -q_0 + q_1 - q_2 + q_3;  // by omega2
  const Scalar c_0 = Scalar(2.0) * per_0 * per_1 / (Scalar(3.0) * omega1_2);  // multiplies alpha21*alpha22
  const Scalar c_1 = Scalar(4.0) * per_0 * per_1 / Scalar(3.0);  // multiplies alpha21*delta22
  const Scalar c_2 = Scalar(2.0) * per_2 * per_3 * per_0 * per_1;  // multiplies alpha22*alpha23
  const Scalar c_3 = -Scalar(2.0) * per_0 * per_1;  // multiplies alpha22*delta21
  const Scalar c_4 = -Scalar(12.0) * omega1_2 * per_2 * per_3 * per_0 * per_1;  // multiplies alpha22*delta23
  const Scalar c_5 = Scalar(2.0) * omega1_2 * per_2 * per_3 * per_0 * per_1;  // multiplies alpha23*delta22
  const Scalar c_6 = -Scalar(4.0) * omega1_2 * per_0 * per_1;  // multiplies delta21*delta22
  const Scalar c_7 = -Scalar(12.0) * omega1_4 * per_2 * per_3 * per_0 * per_1;  // multiplies delta22*delta23
  const Scalar c_8 = per_0 * per_1;  // multiplies alpha32
  const Scalar c_9 = omega1_2 * per_0 * per_1;  // multiplies delta32
  gradient[5] = alpha22 * c_0 + delta22 * c_1;  // by alpha21
  gradient[6] = alpha21 * c_0 + alpha23 * c_2 + delta21 * c_3 + delta23 * c_4;  // by alpha22
  gradient[7] = alpha22 * c_2 + delta22 * c_5;  // by alpha23
  gradient[8] = alpha22 * c_3 + delta22 * c_6;  // by delta21
  gradient[9] = alpha21 * c_1 + alpha23 * c_5 + delta21 * c_6 + delta23 * c_7;  // by delta22
  gradient[10] = alpha22 * c_4 + delta22 * c_7;  // by delta23
  gradient[12] = c_8;  // by alpha32
  gradient[16] = c_9;  // by delta32
  return value;
}

/// conservative_v1_A_v1_A_v2_F = (-omega1^2*delta22*eta22 + alpha22*eta22)/(2*omega1*omega2^2) +
/// (omega1^2*delta22*eta12 + alpha22*eta12)/(omega1*(2*omega1 + omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 32 operations.
template <class Scalar>
Scalar lump_48(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar delta22 = parameters[9];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = -omega1 * delta22 * eta22 / (Scalar(2.0) * omega2_2);
  const Scalar f_1 = alpha22 * eta22 / (Scalar(2.0) * omega1 * omega2_2);
  const Scalar f_2 = omega1 * delta22 * eta12 * per_0 * per_1;
  const Scalar f_3 = alpha22 * eta12 * per_0 * per_1 / omega1;
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_2 + f_3) * per_0;
  const Scalar q_1 = (f_2 + f_3) * per_1;
  gradient[0] = (f_0 - f_1 + f_2 - f_3) / omega1 - Scalar(2.0) * q_0 - Scalar(2.0) * q_1;  // by omega1
  gradient[1] = (-Scalar(2.0) * f_0 - Scalar(2.0) * f_1) / omega2 - q_0 + q_1;  // by omega2
  const Scalar c_0 = per_0 * per_1 / omega1;  // multiplies alpha22*eta12
  const Scalar c_1 = Scalar(1.0) / (Scalar(2.0) * omega1 * omega2_2);  // multiplies alpha22*eta22
  const Scalar c_2 = omega1 * per_0 * per_1;  // multiplies delta22*eta12
  const Scalar c_3 = -omega1 / (Scalar(2.0) * omega2_2);  // multiplies delta22*eta22
  gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
  gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
  gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
  gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  return value;
}

/// conservative_v1_A_v1_F2 = -eta12^2/(4*omega1*(2*omega1 + omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 15 operations.
template <class Scalar>
Scalar lump_49(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar eta12 = parameters[21];
  const Scalar eta12_2 = eta12 * eta12;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = -eta12_2 * per_0 * per_1 / (Scalar(4.0) * omega1);
  const Scalar value = f_0;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_0 * per_0;
  const Scalar q_1 = f_0 * per_1;
  gradient[0] = -f_0 / omega1 - Scalar(2.0) * q_0 - Scalar(2.0) * q_1;  // by omega1
  gradient[1] = -q_0 + q_1;  // by omega2
  const Scalar c_0 = -per_0 * per_1 / (Scalar(4.0) * omega1);  // multiplies eta12^2
  gradient[21] = Scalar(2.0) * eta12 * c_0;  // by eta12
  return value;
}

/// harmonic_im_v1_conjA_v2_F = omega2*mu12*eta12/(2*omega1^2*(omega1 + omega2)*(omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 14 operations.
template <class Scalar>
Scalar lump_50(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu12 = parameters[3];
  const Scalar eta12 = parameters[21];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = omega2 * mu12 * eta12 * per_0 * per_1 / (Scalar(2.0) * omega1_2);
  const Scalar value = f_0;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_0 * per_0;
  const Scalar q_1 = f_0 * per_1;
  gradient[0] = -Scalar(2.0) * f_0 / omega1 - q_0 - q_1;  // by omega1
  gradient[1] = f_0 / omega2 - q_0 + q_1;  // by omega2
  const Scalar c_0 = omega2 * per_0 * per_1 / (Scalar(2.0) * omega1_2);  // multiplies mu12*eta12
  gradient[3] = eta12 * c_0;  // by mu12
  gradient[21] = mu12 * c_0;  // by eta12
  return value;
}

/// harmonic_re_v1_A_v2_conjA_v2_F = (-2*omega1^2*omega2^2*delta23*eta22 - 2*omega1^2*alpha23*eta22 +
/// 3*omega2^4*delta23*eta12 - 3*omega2^2*alpha23*eta12)/(3*omega1^2*omega2^2*(omega1 + omega2)*(omega1 -
/// omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 37 operations.
template <class Scalar>
Scalar lump_51(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha23 = parameters[7];
  const Scalar delta23 = parameters[10];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -Scalar(2.0) * delta23 * eta22 * per_0 * per_1 / Scalar(3.0);
  const Scalar f_1 = -Scalar(2.0) * alpha23 * eta22 * per_0 * per_1 / (Scalar(3.0) * omega2_2);
  const Scalar f_2 = omega2_2 * delta23 * eta12 * per_0 * per_1 / omega1_2;
  const Scalar f_3 = -alpha23 * eta12 * per_0 * per_1 / omega1_2;
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3) * per_1;
  gradient[0] = (-Scalar(2.0) * f_2 - Scalar(2.0) * f_3) / omega1 - q_0 - q_1;  // by omega1
  gradient[1] = (-Scalar(2.0) * f_1 + Scalar(2.0) * f_2) / omega2 - q_0 + q_1;  // by omega2
  const Scalar c_0 = -per_0 * per_1 / omega1_2;  // multiplies alpha23*eta12
  const Scalar c_1 = -Scalar(2.0) * per_0 * per_1 / (Scalar(3.0) * omega2_2);  // multiplies alpha23*eta22
  const Scalar c_2 = omega2_2 * per_0 * per_1 / omega1_2;  // multiplies delta23*eta12
  const Scalar c_3 = -Scalar(2.0) * per_0 * per_1 / Scalar(3.0);  // multiplies delta23*eta22
  gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
  gradient[10] = eta12 * c_2 + eta22 * c_3;  // by delta23
  gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
  gradient[30] = alpha23 * c_1 + delta23 * c_3;  // by eta22
  return value;
}

/// harmonic_re_v1_A_v1_conjA_v1_F = (2*omega1^4*delta21*eta12 + omega1^2*omega2^2*delta21*eta12 -
/// 6*omega1^2*alpha21*eta12 + omega2^2*alpha21*eta12)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 +
/// omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 49 operations.
template <class Scalar>
Scalar lump_52(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar delta21 = parameters[8];
  const Scalar eta12 = parameters[21];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = Scalar(2.0) * omega1_2 * delta21 * eta12 * per_0 * per_1 * per_2 * per_3;
  const Scalar f_1 = omega2_2 * delta21 * eta12 * per_0 * per_1 * per_2 * per_3;
  const Scalar f_2 = -Scalar(6.0) * alpha21 * eta12 * per_0 * per_1 * per_2 * per_3;
  const Scalar f_3 = omega2_2 * alpha21 * eta12 * per_0 * per_1 * per_2 * per_3 / omega1_2;
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3) * per_1;
  const Scalar q_2 = (f_0 + f_1 + f_2 + f_3) * per_2;
  const Scalar q_3 = (f_0 + f_1 + f_2 + f_3) * per_3;
  // by omega1
  gradient[0] = (Scalar(2.0) * f_0 - Scalar(2.0) * f_3) / omega1 - q_0 - q_1 - Scalar(2.0) * q_2
      - Scalar(2.0) * q_3;
  gradient[1] = (Scalar(2.0) * f_1 + Scalar(2.0) * f_3) / omega2 - q_0 + q_1 - q_2 + q_3;  // by omega2
  // multiplies alpha21*eta12
  const Scalar c_0 = (-Scalar(6.0) * omega1_2 + omega2_2) * per_0 * per_1 * per_2 * per_3 / omega1_2;
  // multiplies delta21*eta12
  const Scalar c_1 = (Scalar(2.0) * omega1_2 + omega2_2) * per_0 * per_1 * per_2 * per_3;
  gradient[5] = eta12 * c_0;  // by alpha21
  gradient[8] = eta12 * c_1;  // by delta21
  gradient[21] = alpha21 * c_0 + delta21 * c_1;  // by eta12
  return value;
}

/// harmonic_re_v1_A_v22_F = -alpha23*eta22/(omega2^2*(omega1 + omega2)*(omega1 - omega2)) +
/// (-omega2^2*delta23*eta12 - alpha23*eta12)/(2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1
/// - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 40 operations.
template <class Scalar>
Scalar lump_53(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha23 = parameters[7];
  const Scalar delta23 = parameters[10];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = -alpha23 * eta22 * per_0 * per_1 / omega2_2;
  const Scalar f_1 = -omega2_2 * delta23 * eta12 * per_0 * per_2 * per_1 * per_3 / Scalar(2.0);
  const Scalar f_2 = -alpha23 * eta12 * per_0 * per_2 * per_1 * per_3 / Scalar(2.0);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2) * per_1;
  const Scalar q_2 = (f_1 + f_2) * per_2;
  const Scalar q_3 = (f_1 + f_2) * per_3;
  gradient[0] = -q_0 - q_1 - q_2 - q_3;  // by omega1
  // by omega2
  gradient[1] = (-Scalar(2.0) * f_0 + Scalar(2.0) * f_1) / omega2 - q_0 + q_1 - Scalar(2.0) * q_2
      + Scalar(2.0) * q_3;
  const Scalar c_0 = -per_0 * per_2 * per_1 * per_3 / Scalar(2.0);  // multiplies alpha23*eta12
  const Scalar c_1 = -per_0 * per_1 / omega2_2;  // multiplies alpha23*eta22
  const Scalar c_2 = -omega2_2 * per_0 * per_2 * per_1 * per_3 / Scalar(2.0);  // multiplies delta23*eta12
  gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
  gradient[10] = eta12 * c_2;  // by delta23
  gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
  gradient[30] = alpha23 * c_1;  // by eta22
  return value;
}

/// harmonic_im_v1_A_v2_F = mu12*eta22/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2)) -
/// omega2*mu12*eta12/(2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 31 operations.
template <class Scalar>
Scalar lump_54(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu12 = parameters[3];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = mu12 * eta22 * per_0 * per_1 / (Scalar(3.0) * omega2);
  const Scalar f_1 = -omega2 * mu12 * eta12 * per_2 * per_0 * per_3 * per_1 / Scalar(2.0);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1) * per_0;
  const Scalar q_1 = (f_0 + f_1) * per_1;
  const Scalar q_2 = f_1 * per_2;
  const Scalar q_3 = f_1 * per_3;
  gradient[0] = -q_0 - q_1 - q_2 - q_3;  // by omega1
  gradient[1] = (-f_0 + f_1) / omega2 - Scalar(2.0) * q_0 + Scalar(2.0) * q_1 - q_2 + q_3;  // by omega2
  const Scalar c_0 = -omega2 * per_2 * per_0 * per_3 * per_1 / Scalar(2.0);  // multiplies mu12*eta12
  const Scalar c_1 = per_0 * per_1 / (Scalar(3.0) * omega2);  // multiplies mu12*eta22
  gradient[3] = eta12 * c_0 + eta22 * c_1;  // by mu12
  gradient[21] = mu12 * c_0;  // by eta12
  gradient[30] = mu12 * c_1;  // by eta22
  return value;
}

/// harmonic_re_v1_conjA_v12_F = (-18*omega1^4*delta21*eta12 + 24*omega1^3*omega2*delta21*eta12 -
/// 9*omega1^2*omega2^2*delta21*eta12 + 6*omega1^2*alpha21*eta12 - 2*omega1*omega2*alpha21*eta12 +
/// omega2^2*alpha21*eta12)/(6*omega1^2*omega2*(omega1 - omega2)*(2*omega1 - omega2)*(3*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 68 operations.
template <class Scalar>
Scalar lump_55(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar delta21 = parameters[8];
  const Scalar eta12 = parameters[21];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(3.0) * omega1 - omega2);
  const Scalar f_0 = -Scalar(3.0) * omega1_2 * delta21 * eta12 * per_0 * per_1 * per_2 / omega2;
  const Scalar f_1 = Scalar(4.0) * omega1 * delta21 * eta12 * per_0 * per_1 * per_2;
  const Scalar f_2 = -Scalar(3.0) * omega2 * delta21 * eta12 * per_0 * per_1 * per_2 / Scalar(2.0);
  const Scalar f_3 = alpha21 * eta12 * per_0 * per_1 * per_2 / omega2;
  const Scalar f_4 = -alpha21 * eta12 * per_0 * per_1 * per_2 / (Scalar(3.0) * omega1);
  const Scalar f_5 = omega2 * alpha21 * eta12 * per_0 * per_1 * per_2 / (Scalar(6.0) * omega1_2);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_1;
  const Scalar q_2 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_2;
  // by omega1
  gradient[0] = (Scalar(2.0) * f_0 + f_1 - f_4 - Scalar(2.0) * f_5) / omega1 - q_0 - Scalar(2.0) * q_1
      - Scalar(3.0) * q_2;
  gradient[1] = (-f_0 + f_2 - f_3 + f_5) / omega2 + q_0 + q_1 + q_2;  // by omega2
  // multiplies alpha21*eta12
  const Scalar c_0 = (Scalar(6.0) * omega1_2 - Scalar(2.0) * omega1 * omega2
      + omega2_2) * per_0 * per_1 * per_2 / (Scalar(6.0) * omega1_2 * omega2);
  // multiplies delta21*eta12
  const Scalar c_1 = (-Scalar(6.0) * omega1_2 + Scalar(8.0) * omega1 * omega2
      - Scalar(3.0) * omega2_2) * per_0 * per_1 * per_2 / (Scalar(2.0) * omega2);
  gradient[5] = eta12 * c_0;  // by alpha21
  gradient[8] = eta12 * c_1;  // by delta21
  gradient[21] = alpha21 * c_0 + delta21 * c_1;  // by eta12
  return value;
}

/// harmonic_re_v1_A_v2_conjA_v1_F = (-omega1^2*delta22*eta22 + 2*omega1*omega2*delta22*eta22 +
/// alpha22*eta22)/(12*omega2^3*(omega1 - omega2)) + (omega1*delta22*eta12 -
/// omega2*delta22*eta12)/(2*omega2^2*(2*omega1 - omega2)) - alpha22*eta12/(2*omega2^2*(omega1 -
/// omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 50 operations.
template <class Scalar>
Scalar lump_56(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar delta22 = parameters[9];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = -omega1_2 * delta22 * eta22 * per_0 / (Scalar(12.0) * omega2_3);
  const Scalar f_1 = omega1 * delta22 * eta22 * per_0 / (Scalar(6.0) * omega2_2);
  const Scalar f_2 = alpha22 * eta22 * per_0 / (Scalar(12.0) * omega2_3);
  const Scalar f_3 = omega1 * delta22 * eta12 * per_1 / (Scalar(2.0) * omega2_2);
  const Scalar f_4 = -delta22 * eta12 * per_1 / (Scalar(2.0) * omega2);
  const Scalar f_5 = -alpha22 * eta12 * per_0 * per_1 / (Scalar(2.0) * omega2_2);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_5) * per_0;
  const Scalar q_1 = (f_3 + f_4 + f_5) * per_1;
  gradient[0] = (Scalar(2.0) * f_0 + f_1 + f_3) / omega1 - q_0 - Scalar(2.0) * q_1;  // by omega1
  // by omega2
  gradient[1] = (-Scalar(3.0) * f_0 - Scalar(2.0) * f_1 - Scalar(3.0) * f_2 - Scalar(2.0) * f_3 - f_4
      - Scalar(2.0) * f_5) / omega2 + q_0 + q_1;
  const Scalar c_0 = -per_0 * per_1 / (Scalar(2.0) * omega2_2);  // multiplies alpha22*eta12
  const Scalar c_1 = per_0 / (Scalar(12.0) * omega2_3);  // multiplies alpha22*eta22
  const Scalar c_2 = (omega1 - omega2) * per_1 / (Scalar(2.0) * omega2_2);  // multiplies delta22*eta12
  // multiplies delta22*eta22
  const Scalar c_3 = (-omega1_2 + Scalar(2.0) * omega1 * omega2) * per_0 / (Scalar(12.0) * omega2_3);
  gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
  gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
  gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
  gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  return value;
}

/// harmonic_re_v1_A_v1_A_v2_F = (omega1^2*delta22*eta22 + 2*omega1*omega2*delta22*eta22 -
/// alpha22*eta22)/(12*omega2^3*(omega1 + omega2)) + (omega1*delta22*eta12 +
/// omega2*delta22*eta12)/(2*omega2^2*(2*omega1 + omega2)) - alpha22*eta12/(2*omega2^2*(omega1 +
/// omega2)*(2*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 50 operations.
template <class Scalar>
Scalar lump_57(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar delta22 = parameters[9];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar f_0 = omega1_2 * delta22 * eta22 * per_0 / (Scalar(12.0) * omega2_3);
  const Scalar f_1 = omega1 * delta22 * eta22 * per_0 / (Scalar(6.0) * omega2_2);
  const Scalar f_2 = -alpha22 * eta22 * per_0 / (Scalar(12.0) * omega2_3);
  const Scalar f_3 = omega1 * delta22 * eta12 * per_1 / (Scalar(2.0) * omega2_2);
  const Scalar f_4 = delta22 * eta12 * per_1 / (Scalar(2.0) * omega2);
  const Scalar f_5 = -alpha22 * eta12 * per_0 * per_1 / (Scalar(2.0) * omega2_2);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_5) * per_0;
  const Scalar q_1 = (f_3 + f_4 + f_5) * per_1;
  gradient[0] = (Scalar(2.0) * f_0 + f_1 + f_3) / omega1 - q_0 - Scalar(2.0) * q_1;  // by omega1
  // by omega2
  gradient[1] = (-Scalar(3.0) * f_0 - Scalar(2.0) * f_1 - Scalar(3.0) * f_2 - Scalar(2.0) * f_3 - f_4
      - Scalar(2.0) * f_5) / omega2 - q_0 - q_1;
  const Scalar c_0 = -per_0 * per_1 / (Scalar(2.0) * omega2_2);  // multiplies alpha22*eta12
  const Scalar c_1 = -per_0 / (Scalar(12.0) * omega2_3);  // multiplies alpha22*eta22
  const Scalar c_2 = (omega1 + omega2) * per_1 / (Scalar(2.0) * omega2_2);  // multiplies delta22*eta12
  // multiplies delta22*eta22
  const Scalar c_3 = (omega1_2 + Scalar(2.0) * omega1 * omega2) * per_0 / (Scalar(12.0) * omega2_3);
  gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
  gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
  gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
  gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  return value;
}

/// harmonic_re_v1_A_v12_F = (18*omega1^4*delta21*eta12 + 24*omega1^3*omega2*delta21*eta12 +
/// 9*omega1^2*omega2^2*delta21*eta12 - 6*omega1^2*alpha21*eta12 - 2*omega1*omega2*alpha21*eta12 -
/// omega2^2*alpha21*eta12)/(6*omega1^2*omega2*(omega1 + omega2)*(2*omega1 + omega2)*(3*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 68 operations.
template <class Scalar>
Scalar lump_58(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar delta21 = parameters[8];
  const Scalar eta12 = parameters[21];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(3.0) * omega1 + omega2);
  const Scalar f_0 = Scalar(3.0) * omega1_2 * delta21 * eta12 * per_0 * per_1 * per_2 / omega2;
  const Scalar f_1 = Scalar(4.0) * omega1 * delta21 * eta12 * per_0 * per_1 * per_2;
  const Scalar f_2 = Scalar(3.0) * omega2 * delta21 * eta12 * per_0 * per_1 * per_2 / Scalar(2.0);
  const Scalar f_3 = -alpha21 * eta12 * per_0 * per_1 * per_2 / omega2;
  const Scalar f_4 = -alpha21 * eta12 * per_0 * per_1 * per_2 / (Scalar(3.0) * omega1);
  const Scalar f_5 = -omega2 * alpha21 * eta12 * per_0 * per_1 * per_2 / (Scalar(6.0) * omega1_2);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_1;
  const Scalar q_2 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_2;
  // by omega1
  gradient[0] = (Scalar(2.0) * f_0 + f_1 - f_4 - Scalar(2.0) * f_5) / omega1 - q_0 - Scalar(2.0) * q_1
      - Scalar(3.0) * q_2;
  gradient[1] = (-f_0 + f_2 - f_3 + f_5) / omega2 - q_0 - q_1 - q_2;  // by omega2
  // multiplies alpha21*eta12
  const Scalar c_0 = (-Scalar(6.0) * omega1_2 - Scalar(2.0) * omega1 * omega2
      - omega2_2) * per_0 * per_1 * per_2 / (Scalar(6.0) * omega1_2 * omega2);
  // multiplies delta21*eta12
  const Scalar c_1 = (Scalar(6.0) * omega1_2 + Scalar(8.0) * omega1 * omega2
      + Scalar(3.0) * omega2_2) * per_0 * per_1 * per_2 / (Scalar(2.0) * omega2);
  gradient[5] = eta12 * c_0;  // by alpha21
  gradient[8] = eta12 * c_1;  // by delta21
  gradient[21] = alpha21 * c_0 + delta21 * c_1;  // by eta12
  return value;
}

/// harmonic_im_v2_conjA_v1_F = (-omega1*eta12*mu21 + omega2*eta12*mu21)/(2*omega1*omega2*(omega1 -
/// 2*omega2)*(2*omega1 - omega2)) + mu21*eta22/(2*(omega1 + omega2)*(omega1 - omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 35 operations.
template <class Scalar>
Scalar lump_59(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar eta12 = parameters[21];
  const Scalar mu21 = parameters[23];
  const Scalar eta22 = parameters[30];
  const Scalar per_0 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -eta12 * mu21 * per_0 * per_1 / (Scalar(2.0) * omega2);
  const Scalar f_1 = eta12 * mu21 * per_0 * per_1 / (Scalar(2.0) * omega1);
  const Scalar f_2 = mu21 * eta22 * per_2 * per_3 * per_0 / Scalar(2.0);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2) * per_0;
  const Scalar q_1 = (f_0 + f_1) * per_1;
  const Scalar q_2 = f_2 * per_2;
  const Scalar q_3 = f_2 * per_3;
  gradient[0] = -f_1 / omega1 - q_0 - Scalar(2.0) * q_1 - q_2 - q_3;  // by omega1
  gradient[1] = -f_0 / omega2 + Scalar(2.0) * q_0 + q_1 - q_2 + q_3;  // by omega2
  const Scalar c_0 = (-omega1 + omega2) * per_0 * per_1 / (Scalar(2.0) * omega1 * omega2);  // multiplies eta12*mu21
  const Scalar c_1 = per_2 * per_3 * per_0 / Scalar(2.0);  // multiplies mu21*eta22
  gradient[21] = mu21 * c_0;  // by eta12
  gradient[23] = eta12 * c_0 + eta22 * c_1;  // by mu21
  gradient[30] = mu21 * c_1;  // by eta22
  return value;
}

/// harmonic_re_v2_A_v1_conjA_v2_F = -omega2*delta23*eta22/(omega1*(omega1 + omega2)*(omega1 - 2*omega2)) +
/// (omega1^2*alpha23*eta22 - 2*omega1*omega2*alpha23*eta22 - omega2^2*alpha23*eta22)/(omega1*omega2^2*(omega1 +
/// omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) + (-omega1*omega2*delta23*eta12 -
/// alpha23*eta12)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 61 operations.
template <class Scalar>
Scalar lump_60(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha23 = parameters[7];
  const Scalar delta23 = parameters[10];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar f_0 = -omega2 * delta23 * eta22 * per_0 * per_1 / omega1;
  const Scalar f_1 = omega1 * alpha23 * eta22 * per_0 * per_2 * per_1 / omega2_2;
  const Scalar f_2 = -Scalar(2.0) * alpha23 * eta22 * per_0 * per_2 * per_1 / omega2;
  const Scalar f_3 = -alpha23 * eta22 * per_0 * per_2 * per_1 / omega1;
  const Scalar f_4 = -omega1 * delta23 * eta12 * per_0 * per_2 * per_3;
  const Scalar f_5 = -alpha23 * eta12 * per_0 * per_2 * per_3 / omega2;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3) * per_1;
  const Scalar q_2 = (f_1 + f_2 + f_3 + f_4 + f_5) * per_2;
  const Scalar q_3 = (f_4 + f_5) * per_3;
  gradient[0] = (-f_0 + f_1 - f_3 + f_4) / omega1 - q_0 - q_1 - q_2 - Scalar(2.0) * q_3;  // by omega1
  gradient[1] = (f_0 - Scalar(2.0) * f_1 - f_2 - f_5) / omega2 - q_0 + Scalar(2.0) * q_1 + q_2 - q_3;  // by omega2
  const Scalar c_0 = -per_0 * per_2 * per_3 / omega2;  // multiplies alpha23*eta12
  // multiplies alpha23*eta22
  const Scalar c_1 = (omega1_2 - Scalar(2.0) * omega1 * omega2
      - omega2_2) * per_0 * per_2 * per_1 / (omega1 * omega2_2);
  const Scalar c_2 = -omega1 * per_0 * per_2 * per_3;  // multiplies delta23*eta12
  const Scalar c_3 = -omega2 * per_0 * per_1 / omega1;  // multiplies delta23*eta22
  gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
  gradient[10] = eta12 * c_2 + eta22 * c_3;  // by delta23
  gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
  gradient[30] = alpha23 * c_1 + delta23 * c_3;  // by eta22
  return value;
}

/// harmonic_re_v2_A_v1_A_v2_F = omega2*delta23*eta22/(omega1*(omega1 + 2*omega2)*(omega1 - omega2)) +
/// (omega1^2*alpha23*eta22 + 2*omega1*omega2*alpha23*eta22 - omega2^2*alpha23*eta22)/(omega1*omega2^2*(omega1 +
/// omega2)*(omega1 + 2*omega2)*(omega1 - omega2)) + (-omega1*omega2*delta23*eta12 +
/// alpha23*eta12)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 61 operations.
template <class Scalar>
Scalar lump_61(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha23 = parameters[7];
  const Scalar delta23 = parameters[10];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = omega2 * delta23 * eta22 * per_0 * per_1 / omega1;
  const Scalar f_1 = omega1 * alpha23 * eta22 * per_2 * per_0 * per_1 / omega2_2;
  const Scalar f_2 = Scalar(2.0) * alpha23 * eta22 * per_2 * per_0 * per_1 / omega2;
  const Scalar f_3 = -alpha23 * eta22 * per_2 * per_0 * per_1 / omega1;
  const Scalar f_4 = -omega1 * delta23 * eta12 * per_2 * per_1 * per_3;
  const Scalar f_5 = alpha23 * eta12 * per_2 * per_1 * per_3 / omega2;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_1;
  const Scalar q_2 = (f_1 + f_2 + f_3 + f_4 + f_5) * per_2;
  const Scalar q_3 = (f_4 + f_5) * per_3;
  gradient[0] = (-f_0 + f_1 - f_3 + f_4) / omega1 - q_0 - q_1 - q_2 - Scalar(2.0) * q_3;  // by omega1
  gradient[1] = (f_0 - Scalar(2.0) * f_1 - f_2 - f_5) / omega2 - Scalar(2.0) * q_0 + q_1 - q_2 + q_3;  // by omega2
  const Scalar c_0 = per_2 * per_1 * per_3 / omega2;  // multiplies alpha23*eta12
  // multiplies alpha23*eta22
  const Scalar c_1 = (omega1_2 + Scalar(2.0) * omega1 * omega2
      - omega2_2) * per_2 * per_0 * per_1 / (omega1 * omega2_2);
  const Scalar c_2 = -omega1 * per_2 * per_1 * per_3;  // multiplies delta23*eta12
  const Scalar c_3 = omega2 * per_0 * per_1 / omega1;  // multiplies delta23*eta22
  gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
  gradient[10] = eta12 * c_2 + eta22 * c_3;  // by delta23
  gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
  gradient[30] = alpha23 * c_1 + delta23 * c_3;  // by eta22
  return value;
}

/// harmonic_im_v2_A_v1_F = (-omega1*eta12*mu21 - omega2*eta12*mu21)/(2*omega1*omega2*(omega1 +
/// 2*omega2)*(2*omega1 + omega2)) - mu21*eta22/(2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 35 operations.
template <class Scalar>
Scalar lump_62(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar eta12 = parameters[21];
  const Scalar mu21 = parameters[23];
  const Scalar eta22 = parameters[30];
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -eta12 * mu21 * per_0 * per_1 / (Scalar(2.0) * omega2);
  const Scalar f_1 = -eta12 * mu21 * per_0 * per_1 / (Scalar(2.0) * omega1);
  const Scalar f_2 = -mu21 * eta22 * per_2 * per_0 * per_3 / Scalar(2.0);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2) * per_0;
  const Scalar q_1 = (f_0 + f_1) * per_1;
  const Scalar q_2 = f_2 * per_2;
  const Scalar q_3 = f_2 * per_3;
  gradient[0] = -f_1 / omega1 - q_0 - Scalar(2.0) * q_1 - q_2 - q_3;  // by omega1
  gradient[1] = -f_0 / omega2 - Scalar(2.0) * q_0 - q_1 - q_2 + q_3;  // by omega2
  const Scalar c_0 = (-omega1 - omega2) * per_0 * per_1 / (Scalar(2.0) * omega1 * omega2);  // multiplies eta12*mu21
  const Scalar c_1 = -per_2 * per_0 * per_3 / Scalar(2.0);  // multiplies mu21*eta22
  gradient[21] = mu21 * c_0;  // by eta12
  gradient[23] = eta12 * c_0 + eta22 * c_1;  // by mu21
  gradient[30] = mu21 * c_1;  // by eta22
  return value;
}

/// harmonic_re_v2_conjA_v12_F = delta22*eta12/(4*omega2*(2*omega1 - omega2)) +
/// alpha22*eta12/(4*omega1*omega2*(omega1 - omega2)*(2*omega1 - omega2)) + (-omega1^2*delta22*eta22 -
/// alpha22*eta22)/(8*omega1*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 47 operations.
template <class Scalar>
Scalar lump_63(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar delta22 = parameters[9];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar f_0 = delta22 * eta12 * per_0 / (Scalar(4.0) * omega2);
  const Scalar f_1 = alpha22 * eta12 * per_1 * per_0 / (Scalar(4.0) * omega1 * omega2);
  const Scalar f_2 = -omega1 * delta22 * eta22 * per_1 * per_2 * per_0 / Scalar(8.0);
  const Scalar f_3 = -alpha22 * eta22 * per_1 * per_2 * per_0 / (Scalar(8.0) * omega1);
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = (f_1 + f_2 + f_3) * per_1;
  const Scalar q_2 = (f_2 + f_3) * per_2;
  gradient[0] = (-f_1 + f_2 - f_3) / omega1 - Scalar(2.0) * q_0 - q_1 - Scalar(2.0) * q_2;  // by omega1
  gradient[1] = (-f_0 - f_1) / omega2 + q_0 + q_1 - q_2;  // by omega2
  const Scalar c_0 = per_1 * per_0 / (Scalar(4.0) * omega1 * omega2);  // multiplies alpha22*eta12
  const Scalar c_1 = -per_1 * per_2 * per_0 / (Scalar(8.0) * omega1);  // multiplies alpha22*eta22
  const Scalar c_2 = per_0 / (Scalar(4.0) * omega2);  // multiplies delta22*eta12
  const Scalar c_3 = -omega1 * per_1 * per_2 * per_0 / Scalar(8.0);  // multiplies delta22*eta22
  gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
  gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
  gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
  gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  return value;
}

/// harmonic_re_v2_A_v2_conjA_v1_F = (-2*omega1^3*omega2*delta23*eta22 + 8*omega1^2*omega2^2*delta23*eta22 -
/// omega1^2*alpha23*eta22 - 11*omega1*omega2^3*delta23*eta22 + 2*omega1*omega2*alpha23*eta22 +
/// 3*omega2^4*delta23*eta22 - 3*omega2^2*alpha23*eta22)/(3*omega1*omega2^2*(omega1 - omega2)*(omega1 -
/// 2*omega2)*(omega1 - 3*omega2)) + (omega1*omega2*delta23*eta12 - 2*omega2^2*delta23*eta12 +
/// alpha23*eta12)/(omega2*(omega1 - omega2)*(omega1 - 3*omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 109 operations.
template <class Scalar>
Scalar lump_64(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha23 = parameters[7];
  const Scalar delta23 = parameters[10];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 - Scalar(3.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = -Scalar(2.0) * omega1_2 * delta23 * eta22 * per_0 * per_1 * per_2 / (Scalar(3.0) * omega2);
  const Scalar f_1 = Scalar(8.0) * omega1 * delta23 * eta22 * per_0 * per_1 * per_2 / Scalar(3.0);
  const Scalar f_2 = -omega1 * alpha23 * eta22 * per_0 * per_1 * per_2 / (Scalar(3.0) * omega2_2);
  const Scalar f_3 = -Scalar(11.0) * omega2 * delta23 * eta22 * per_0 * per_1 * per_2 / Scalar(3.0);
  const Scalar f_4 = Scalar(2.0) * alpha23 * eta22 * per_0 * per_1 * per_2 / (Scalar(3.0) * omega2);
  const Scalar f_5 = omega2_2 * delta23 * eta22 * per_0 * per_1 * per_2 / omega1;
  const Scalar f_6 = -alpha23 * eta22 * per_0 * per_1 * per_2 / omega1;
  const Scalar f_7 = omega1 * delta23 * eta12 * per_0 * per_2 * per_3;
  const Scalar f_8 = -Scalar(2.0) * omega2 * delta23 * eta12 * per_0 * per_2 * per_3;
  const Scalar f_9 = alpha23 * eta12 * per_0 * per_2 * per_3 / omega2;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_1;
  const Scalar q_2 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_2;
  const Scalar q_3 = (f_7 + f_8 + f_9) * per_3;
  // by omega1
  gradient[0] = (Scalar(2.0) * f_0 + f_1 + f_2 - f_5 - f_6 + f_7) / omega1 - q_0 - q_1 - q_2 - Scalar(2.0) * q_3;
  // by omega2
  gradient[1] = (-f_0 - Scalar(2.0) * f_2 + f_3 - f_4 + Scalar(2.0) * f_5 + f_8 - f_9) / omega2 + q_0
      + Scalar(2.0) * q_1 + Scalar(3.0) * q_2 + q_3;
  const Scalar c_0 = per_0 * per_2 * per_3 / omega2;  // multiplies alpha23*eta12
  // multiplies alpha23*eta22
  const Scalar c_1 = (-omega1_2 + Scalar(2.0) * omega1 * omega2
      - Scalar(3.0) * omega2_2) * per_0 * per_1 * per_2 / (Scalar(3.0) * omega1 * omega2_2);
  const Scalar c_2 = (omega1 - Scalar(2.0) * omega2) * per_0 * per_2 * per_3;  // multiplies delta23*eta12
  // multiplies delta23*eta22
  const Scalar c_3 = (-Scalar(2.0) * omega1_3 + Scalar(8.0) * omega1_2 * omega2 - Scalar(11.0) * omega1 * omega2_2
      + Scalar(3.0) * omega2_3) * per_0 * per_1 * per_2 / (Scalar(3.0) * omega1 * omega2);
  gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
  gradient[10] = eta12 * c_2 + eta22 * c_3;  // by delta23
  gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
  gradient[30] = alpha23 * c_1 + delta23 * c_3;  // by eta22
  return value;
}

/// harmonic_re_v2_A_v12_F = -delta22*eta12/(4*omega2*(2*omega1 + omega2)) -
/// alpha22*eta12/(4*omega1*omega2*(omega1 + omega2)*(2*omega1 + omega2)) + (-omega1^2*delta22*eta22 -
/// alpha22*eta22)/(8*omega1*(omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 47 operations.
template <class Scalar>
Scalar lump_65(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar delta22 = parameters[9];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = -delta22 * eta12 * per_0 / (Scalar(4.0) * omega2);
  const Scalar f_1 = -alpha22 * eta12 * per_1 * per_0 / (Scalar(4.0) * omega1 * omega2);
  const Scalar f_2 = -omega1 * delta22 * eta22 * per_1 * per_0 * per_2 / Scalar(8.0);
  const Scalar f_3 = -alpha22 * eta22 * per_1 * per_0 * per_2 / (Scalar(8.0) * omega1);
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = (f_1 + f_2 + f_3) * per_1;
  const Scalar q_2 = (f_2 + f_3) * per_2;
  gradient[0] = (-f_1 + f_2 - f_3) / omega1 - Scalar(2.0) * q_0 - q_1 - Scalar(2.0) * q_2;  // by omega1
  gradient[1] = (-f_0 - f_1) / omega2 - q_0 - q_1 + q_2;  // by omega2
  const Scalar c_0 = -per_1 * per_0 / (Scalar(4.0) * omega1 * omega2);  // multiplies alpha22*eta12
  const Scalar c_1 = -per_1 * per_0 * per_2 / (Scalar(8.0) * omega1);  // multiplies alpha22*eta22
  const Scalar c_2 = -per_0 / (Scalar(4.0) * omega2);  // multiplies delta22*eta12
  const Scalar c_3 = -omega1 * per_1 * per_0 * per_2 / Scalar(8.0);  // multiplies delta22*eta22
  gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
  gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
  gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
  gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  return value;
}

/// conservative_v1_conjA_v1_F = (6*omega1^2*delta21*eta11 - 3*omega1^2*eta12 - 2*alpha21*eta11)/(12*omega1^3) +
/// (-omega1^2*delta22*eta21 - alpha22*eta21)/(2*omega1*(2*omega1 + omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 37 operations.
template <class Scalar>
Scalar lump_66(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar eta11 = parameters[20];
  const Scalar eta12 = parameters[21];
  const Scalar eta21 = parameters[29];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = (Scalar(2.0) * delta21 * eta11 - eta12) / (Scalar(4.0) * omega1);
  const Scalar f_1 = -alpha21 * eta11 / (Scalar(6.0) * omega1_3);
  const Scalar f_2 = -omega1 * delta22 * eta21 * per_0 * per_1 / Scalar(2.0);
  const Scalar f_3 = -alpha22 * eta21 * per_0 * per_1 / (Scalar(2.0) * omega1);
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_2 + f_3) * per_0;
  const Scalar q_1 = (f_2 + f_3) * per_1;
  // by omega1
  gradient[0] = (-f_0 - Scalar(3.0) * f_1 + f_2 - f_3) / omega1 - Scalar(2.0) * q_0 - Scalar(2.0) * q_1;
  gradient[1] = -q_0 + q_1;  // by omega2
  const Scalar c_0 = -Scalar(1.0) / (Scalar(6.0) * omega1_3);  // multiplies alpha21*eta11
  const Scalar c_1 = -per_0 * per_1 / (Scalar(2.0) * omega1);  // multiplies alpha22*eta21
  const Scalar c_2 = Scalar(1.0) / (Scalar(2.0) * omega1);  // multiplies delta21*eta11
  const Scalar c_3 = -omega1 * per_0 * per_1 / Scalar(2.0);  // multiplies delta22*eta21
  const Scalar c_4 = -Scalar(1.0) / (Scalar(4.0) * omega1);  // multiplies eta12
  gradient[5] = eta11 * c_0;  // by alpha21
  gradient[6] = eta21 * c_1;  // by alpha22
  gradient[8] = eta11 * c_2;  // by delta21
  gradient[9] = eta21 * c_3;  // by delta22
  gradient[20] = alpha21 * c_0 + delta21 * c_2;  // by eta11
  gradient[21] = c_4;  // by eta12
  gradient[29] = alpha22 * c_1 + delta22 * c_3;  // by eta21
  return value;
}

/// harmonic_im_v1_F = -mu12*eta21/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 15 operations.
template <class Scalar>
Scalar lump_67(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu12 = parameters[3];
  const Scalar eta21 = parameters[29];
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = -mu12 * eta21 * per_0 * per_1 / (Scalar(3.0) * omega1);
  const Scalar value = f_0;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_0 * per_0;
  const Scalar q_1 = f_0 * per_1;
  gradient[0] = -f_0 / omega1 - Scalar(2.0) * q_0 - Scalar(2.0) * q_1;  // by omega1
  gradient[1] = -q_0 + q_1;  // by omega2
  const Scalar c_0 = -per_0 * per_1 / (Scalar(3.0) * omega1);  // multiplies mu12*eta21
  gradient[3] = eta21 * c_0;  // by mu12
  gradient[29] = mu12 * c_0;  // by eta21
  return value;
}

/// harmonic_re_v1_A_v2_F = (4*omega1^2*delta22*eta11 - 2*omega1*omega2*delta22*eta11 -
/// alpha22*eta11)/(3*omega1^2*(omega1 - omega2)*(3*omega1 - omega2)) + (2*omega1*omega2*delta23*eta21 -
/// alpha23*eta21)/((omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 62 operations.
template <class Scalar>
Scalar lump_68(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar eta11 = parameters[20];
  const Scalar eta21 = parameters[29];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(3.0) * omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = Scalar(4.0) * delta22 * eta11 * per_0 * per_1 / Scalar(3.0);
  const Scalar f_1 = -Scalar(2.0) * omega2 * delta22 * eta11 * per_0 * per_1 / (Scalar(3.0) * omega1);
  const Scalar f_2 = -alpha22 * eta11 * per_0 * per_1 / (Scalar(3.0) * omega1_2);
  const Scalar f_3 = Scalar(2.0) * omega1 * omega2 * delta23 * eta21 * per_0 * per_2 * per_3 * per_1;
  const Scalar f_4 = -alpha23 * eta21 * per_0 * per_2 * per_3 * per_1;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_1;
  const Scalar q_2 = (f_3 + f_4) * per_2;
  const Scalar q_3 = (f_3 + f_4) * per_3;
  // by omega1
  gradient[0] = (-f_1 - Scalar(2.0) * f_2 + f_3) / omega1 - q_0 - Scalar(3.0) * q_1 - Scalar(2.0) * q_2
      - Scalar(2.0) * q_3;
  gradient[1] = (f_1 + f_3) / omega2 + q_0 + q_1 - q_2 + q_3;  // by omega2
  const Scalar c_0 = -per_0 * per_1 / (Scalar(3.0) * omega1_2);  // multiplies alpha22*eta11
  const Scalar c_1 = -per_0 * per_2 * per_3 * per_1;  // multiplies alpha23*eta21
  // multiplies delta22*eta11
  const Scalar c_2 = (Scalar(4.0) * omega1 - Scalar(2.0) * omega2) * per_0 * per_1 / (Scalar(3.0) * omega1);
  const Scalar c_3 = Scalar(2.0) * omega1 * omega2 * per_0 * per_2 * per_3 * per_1;  // multiplies delta23*eta21
  gradient[6] = eta11 * c_0;  // by alpha22
  gradient[7] = eta21 * c_1;  // by alpha23
  gradient[9] = eta11 * c_2;  // by delta22
  gradient[10] = eta21 * c_3;  // by delta23
  gradient[20] = alpha22 * c_0 + delta22 * c_2;  // by eta11
  gradient[29] = alpha23 * c_1 + delta23 * c_3;  // by eta21
  return value;
}

/// harmonic_re_v1_A_v1_F = (14*omega1^2*delta21*eta11 - 3*omega1^2*eta12 - 2*alpha21*eta11)/(48*omega1^4) +
/// (3*omega1^2*delta22*eta21 - alpha22*eta21)/(8*omega1^2*(2*omega1 + omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 38 operations.
template <class Scalar>
Scalar lump_69(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar eta11 = parameters[20];
  const Scalar eta12 = parameters[21];
  const Scalar eta21 = parameters[29];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = (Scalar(14.0) * delta21 * eta11 - Scalar(3.0) * eta12) / (Scalar(48.0) * omega1_2);
  const Scalar f_1 = -alpha21 * eta11 / (Scalar(24.0) * omega1_4);
  const Scalar f_2 = Scalar(3.0) * delta22 * eta21 * per_0 * per_1 / Scalar(8.0);
  const Scalar f_3 = -alpha22 * eta21 * per_0 * per_1 / (Scalar(8.0) * omega1_2);
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_2 + f_3) * per_0;
  const Scalar q_1 = (f_2 + f_3) * per_1;
  // by omega1
  gradient[0] = (-Scalar(2.0) * f_0 - Scalar(4.0) * f_1 - Scalar(2.0) * f_3) / omega1 - Scalar(2.0) * q_0
      - Scalar(2.0) * q_1;
  gradient[1] = -q_0 + q_1;  // by omega2
  const Scalar c_0 = -Scalar(1.0) / (Scalar(24.0) * omega1_4);  // multiplies alpha21*eta11
  const Scalar c_1 = -per_0 * per_1 / (Scalar(8.0) * omega1_2);  // multiplies alpha22*eta21
  const Scalar c_2 = Scalar(7.0) / (Scalar(24.0) * omega1_2);  // multiplies delta21*eta11
  const Scalar c_3 = Scalar(3.0) * per_0 * per_1 / Scalar(8.0);  // multiplies delta22*eta21
  const Scalar c_4 = -Scalar(1.0) / (Scalar(16.0) * omega1_2);  // multiplies eta12
  gradient[5] = eta11 * c_0;  // by alpha21
  gradient[6] = eta21 * c_1;  // by alpha22
  gradient[8] = eta11 * c_2;  // by delta21
  gradient[9] = eta21 * c_3;  // by delta22
  gradient[20] = alpha21 * c_0 + delta21 * c_2;  // by eta11
  gradient[21] = c_4;  // by eta12
  gradient[29] = alpha22 * c_1 + delta22 * c_3;  // by eta21
  return value;
}

/// harmonic_im_v2_F = -eta11*mu21/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 15 operations.
template <class Scalar>
Scalar lump_70(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar eta11 = parameters[20];
  const Scalar mu21 = parameters[23];
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = -eta11 * mu21 * per_0 * per_1 / (Scalar(3.0) * omega1);
  const Scalar value = f_0;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_0 * per_0;
  const Scalar q_1 = f_0 * per_1;
  gradient[0] = -f_0 / omega1 - Scalar(2.0) * q_0 - Scalar(2.0) * q_1;  // by omega1
  gradient[1] = -q_0 + q_1;  // by omega2
  const Scalar c_0 = -per_0 * per_1 / (Scalar(3.0) * omega1);  // multiplies eta11*mu21
  gradient[20] = mu21 * c_0;  // by eta11
  gradient[23] = eta11 * c_0;  // by mu21
  return value;
}

/// harmonic_re_v2_conjA_v1_F = (2*omega1^2*delta22*eta11 - alpha22*eta11)/(3*omega1^2*(omega1 + omega2)*(omega1
/// - omega2)) + (2*omega1^2*delta23*eta21 - alpha23*eta21)/((omega1 + omega2)*(omega1 - omega2)*(2*omega1 +
/// omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 48 operations.
template <class Scalar>
Scalar lump_71(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar eta11 = parameters[20];
  const Scalar eta21 = parameters[29];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = Scalar(2.0) * delta22 * eta11 * per_0 * per_1 / Scalar(3.0);
  const Scalar f_1 = -alpha22 * eta11 * per_0 * per_1 / (Scalar(3.0) * omega1_2);
  const Scalar f_2 = Scalar(2.0) * omega1_2 * delta23 * eta21 * per_0 * per_1 * per_2 * per_3;
  const Scalar f_3 = -alpha23 * eta21 * per_0 * per_1 * per_2 * per_3;
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3) * per_1;
  const Scalar q_2 = (f_2 + f_3) * per_2;
  const Scalar q_3 = (f_2 + f_3) * per_3;
  // by omega1
  gradient[0] = (-Scalar(2.0) * f_1 + Scalar(2.0) * f_2) / omega1 - q_0 - q_1 - Scalar(2.0) * q_2
      - Scalar(2.0) * q_3;
  gradient[1] = -q_0 + q_1 - q_2 + q_3;  // by omega2
  const Scalar c_0 = -per_0 * per_1 / (Scalar(3.0) * omega1_2);  // multiplies alpha22*eta11
  const Scalar c_1 = -per_0 * per_1 * per_2 * per_3;  // multiplies alpha23*eta21
  const Scalar c_2 = Scalar(2.0) * per_0 * per_1 / Scalar(3.0);  // multiplies delta22*eta11
  const Scalar c_3 = Scalar(2.0) * omega1_2 * per_0 * per_1 * per_2 * per_3;  // multiplies delta23*eta21
  gradient[6] = eta11 * c_0;  // by alpha22
  gradient[7] = eta21 * c_1;  // by alpha23
  gradient[9] = eta11 * c_2;  // by delta22
  gradient[10] = eta21 * c_3;  // by delta23
  gradient[20] = alpha22 * c_0 + delta22 * c_2;  // by eta11
  gradient[29] = alpha23 * c_1 + delta23 * c_3;  // by eta21
  return value;
}

/// harmonic_re_v2_A_v2_F = (-3*omega1^2*eta22 - 4*omega1*omega2*delta23*eta11 + 2*omega2^2*delta23*eta11 -
/// 2*alpha23*eta11)/(24*omega1^3*(omega1 - omega2)) + (4*omega1^2*delta24*eta21 - 2*omega1*omega2*delta24*eta21
/// + omega2^2*delta24*eta21 - alpha24*eta21)/(4*omega1*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 -
/// omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 76 operations.
template <class Scalar>
Scalar lump_72(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha23 = parameters[7];
  const Scalar delta23 = parameters[10];
  const Scalar eta11 = parameters[20];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar eta21 = parameters[29];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = -eta22 * per_0 / (Scalar(8.0) * omega1);
  const Scalar f_1 = -omega2 * delta23 * eta11 * per_0 / (Scalar(6.0) * omega1_2);
  const Scalar f_2 = omega2_2 * delta23 * eta11 * per_0 / (Scalar(12.0) * omega1_3);
  const Scalar f_3 = -alpha23 * eta11 * per_0 / (Scalar(12.0) * omega1_3);
  const Scalar f_4 = omega1 * delta24 * eta21 * per_0 * per_1 * per_2;
  const Scalar f_5 = -omega2 * delta24 * eta21 * per_0 * per_1 * per_2 / Scalar(2.0);
  const Scalar f_6 = omega2_2 * delta24 * eta21 * per_0 * per_1 * per_2 / (Scalar(4.0) * omega1);
  const Scalar f_7 = -alpha24 * eta21 * per_0 * per_1 * per_2 / (Scalar(4.0) * omega1);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7) * per_0;
  const Scalar q_1 = (f_4 + f_5 + f_6 + f_7) * per_1;
  const Scalar q_2 = (f_4 + f_5 + f_6 + f_7) * per_2;
  // by omega1
  gradient[0] = (-f_0 - Scalar(2.0) * f_1 - Scalar(3.0) * f_2 - Scalar(3.0) * f_3 + f_4 - f_6 - f_7) / omega1 - q_0
      - Scalar(2.0) * q_1 - Scalar(2.0) * q_2;
  gradient[1] = (f_1 + Scalar(2.0) * f_2 + f_5 + Scalar(2.0) * f_6) / omega2 + q_0 - q_1 + q_2;  // by omega2
  const Scalar c_0 = -per_0 / (Scalar(12.0) * omega1_3);  // multiplies alpha23*eta11
  // multiplies delta23*eta11
  const Scalar c_1 = (-Scalar(2.0) * omega1 * omega2 + omega2_2) * per_0 / (Scalar(12.0) * omega1_3);
  const Scalar c_2 = -per_0 * per_1 * per_2 / (Scalar(4.0) * omega1);  // multiplies alpha24*eta21
  // multiplies delta24*eta21
  const Scalar c_3 = (Scalar(4.0) * omega1_2 - Scalar(2.0) * omega1 * omega2
      + omega2_2) * per_0 * per_1 * per_2 / (Scalar(4.0) * omega1);
  const Scalar c_4 = -per_0 / (Scalar(8.0) * omega1);  // multiplies eta22
  gradient[7] = eta11 * c_0;  // by alpha23
  gradient[10] = eta11 * c_1;  // by delta23
  gradient[20] = alpha23 * c_0 + delta23 * c_1;  // by eta11
  gradient[25] = eta21 * c_2;  // by alpha24
  gradient[26] = eta21 * c_3;  // by delta24
  gradient[29] = alpha24 * c_2 + delta24 * c_3;  // by eta21
  gradient[30] = c_4;  // by eta22
  return value;
}

/// harmonic_re_v2_A_v1_F = (-2*omega1^2*delta22*eta11 - alpha22*eta11)/(3*omega1^2*(3*omega1 + omega2)*(3*omega1
/// - omega2)) + (6*omega1^2*delta23*eta21 - alpha23*eta21)/((2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 +
/// omega2)*(3*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 50 operations.
template <class Scalar>
Scalar lump_73(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar eta11 = parameters[20];
  const Scalar eta21 = parameters[29];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar per_0 = Scalar(1.0) / (Scalar(3.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(3.0) * omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = -Scalar(2.0) * delta22 * eta11 * per_0 * per_1 / Scalar(3.0);
  const Scalar f_1 = -alpha22 * eta11 * per_0 * per_1 / (Scalar(3.0) * omega1_2);
  const Scalar f_2 = Scalar(6.0) * omega1_2 * delta23 * eta21 * per_2 * per_3 * per_0 * per_1;
  const Scalar f_3 = -alpha23 * eta21 * per_2 * per_3 * per_0 * per_1;
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3) * per_1;
  const Scalar q_2 = (f_2 + f_3) * per_2;
  const Scalar q_3 = (f_2 + f_3) * per_3;
  // by omega1
  gradient[0] = (-Scalar(2.0) * f_1 + Scalar(2.0) * f_2) / omega1 - Scalar(3.0) * q_0 - Scalar(3.0) * q_1
      - Scalar(2.0) * q_2 - Scalar(2.0) * q_3;
  gradient[1] = -q_0 + q_1 - q_2 + q_3;  // by omega2
  const Scalar c_0 = -per_0 * per_1 / (Scalar(3.0) * omega1_2);  // multiplies alpha22*eta11
  const Scalar c_1 = -per_2 * per_3 * per_0 * per_1;  // multiplies alpha23*eta21
  const Scalar c_2 = -Scalar(2.0) * per_0 * per_1 / Scalar(3.0);  // multiplies delta22*eta11
  const Scalar c_3 = Scalar(6.0) * omega1_2 * per_2 * per_3 * per_0 * per_1;  // multiplies delta23*eta21
  gradient[6] = eta11 * c_0;  // by alpha22
  gradient[7] = eta21 * c_1;  // by alpha23
  gradient[9] = eta11 * c_2;  // by delta22
  gradient[10] = eta21 * c_3;  // by delta23
  gradient[20] = alpha22 * c_0 + delta22 * c_2;  // by eta11
  gradient[29] = alpha23 * c_1 + delta23 * c_3;  // by eta21
  return value;
}

/// conservative_v2_conjA_v2_F = (6*omega2^2*delta24*eta21 - 3*omega2^2*eta22 - 2*alpha24*eta21)/(12*omega2^3) +
/// (omega2^2*delta23*eta11 + alpha23*eta11)/(2*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 37 operations.
template <class Scalar>
Scalar lump_74(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha23 = parameters[7];
  const Scalar delta23 = parameters[10];
  const Scalar eta11 = parameters[20];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar eta21 = parameters[29];
  const Scalar eta22 = parameters[30];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = (Scalar(2.0) * delta24 * eta21 - eta22) / (Scalar(4.0) * omega2);
  const Scalar f_1 = -alpha24 * eta21 / (Scalar(6.0) * omega2_3);
  const Scalar f_2 = omega2 * delta23 * eta11 * per_0 * per_1 / Scalar(2.0);
  const Scalar f_3 = alpha23 * eta11 * per_0 * per_1 / (Scalar(2.0) * omega2);
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_2 + f_3) * per_0;
  const Scalar q_1 = (f_2 + f_3) * per_1;
  gradient[0] = -q_0 - q_1;  // by omega1
  // by omega2
  gradient[1] = (-f_0 - Scalar(3.0) * f_1 + f_2 - f_3) / omega2 - Scalar(2.0) * q_0 + Scalar(2.0) * q_1;
  const Scalar c_0 = per_0 * per_1 / (Scalar(2.0) * omega2);  // multiplies alpha23*eta11
  const Scalar c_1 = omega2 * per_0 * per_1 / Scalar(2.0);  // multiplies delta23*eta11
  const Scalar c_2 = -Scalar(1.0) / (Scalar(6.0) * omega2_3);  // multiplies alpha24*eta21
  const Scalar c_3 = Scalar(1.0) / (Scalar(2.0) * omega2);  // multiplies delta24*eta21
  const Scalar c_4 = -Scalar(1.0) / (Scalar(4.0) * omega2);  // multiplies eta22
  gradient[7] = eta11 * c_0;  // by alpha23
  gradient[10] = eta11 * c_1;  // by delta23
  gradient[20] = alpha23 * c_0 + delta23 * c_1;  // by eta11
  gradient[25] = eta21 * c_2;  // by alpha24
  gradient[26] = eta21 * c_3;  // by delta24
  gradient[29] = alpha24 * c_2 + delta24 * c_3;  // by eta21
  gradient[30] = c_4;  // by eta22
  return value;
}

/// harmonic_im_v1_F = mu12*eta21/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 15 operations.
template <class Scalar>
Scalar lump_75(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu12 = parameters[3];
  const Scalar eta21 = parameters[29];
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = mu12 * eta21 * per_0 * per_1 / (Scalar(3.0) * omega2);
  const Scalar value = f_0;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_0 * per_0;
  const Scalar q_1 = f_0 * per_1;
  gradient[0] = -q_0 - q_1;  // by omega1
  gradient[1] = -f_0 / omega2 - Scalar(2.0) * q_0 + Scalar(2.0) * q_1;  // by omega2
  const Scalar c_0 = per_0 * per_1 / (Scalar(3.0) * omega2);  // multiplies mu12*eta21
  gradient[3] = eta21 * c_0;  // by mu12
  gradient[29] = mu12 * c_0;  // by eta21
  return value;
}

/// harmonic_re_v1_conjA_v2_F = (-2*omega2^2*delta23*eta21 + alpha23*eta21)/(3*omega2^2*(omega1 + omega2)*(omega1
/// - omega2)) + (2*omega2^2*delta22*eta11 - alpha22*eta11)/((omega1 + omega2)*(omega1 + 2*omega2)*(omega1 -
/// omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 48 operations.
template <class Scalar>
Scalar lump_76(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar eta11 = parameters[20];
  const Scalar eta21 = parameters[29];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = -Scalar(2.0) * delta23 * eta21 * per_0 * per_1 / Scalar(3.0);
  const Scalar f_1 = alpha23 * eta21 * per_0 * per_1 / (Scalar(3.0) * omega2_2);
  const Scalar f_2 = Scalar(2.0) * omega2_2 * delta22 * eta11 * per_0 * per_2 * per_1 * per_3;
  const Scalar f_3 = -alpha22 * eta11 * per_0 * per_2 * per_1 * per_3;
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3) * per_1;
  const Scalar q_2 = (f_2 + f_3) * per_2;
  const Scalar q_3 = (f_2 + f_3) * per_3;
  gradient[0] = -q_0 - q_1 - q_2 - q_3;  // by omega1
  // by omega2
  gradient[1] = (-Scalar(2.0) * f_1 + Scalar(2.0) * f_2) / omega2 - q_0 + q_1 - Scalar(2.0) * q_2
      + Scalar(2.0) * q_3;
  const Scalar c_0 = -per_0 * per_2 * per_1 * per_3;  // multiplies alpha22*eta11
  const Scalar c_1 = per_0 * per_1 / (Scalar(3.0) * omega2_2);  // multiplies alpha23*eta21
  const Scalar c_2 = Scalar(2.0) * omega2_2 * per_0 * per_2 * per_1 * per_3;  // multiplies delta22*eta11
  const Scalar c_3 = -Scalar(2.0) * per_0 * per_1 / Scalar(3.0);  // multiplies delta23*eta21
  gradient[6] = eta11 * c_0;  // by alpha22
  gradient[7] = eta21 * c_1;  // by alpha23
  gradient[9] = eta11 * c_2;  // by delta22
  gradient[10] = eta21 * c_3;  // by delta23
  gradient[20] = alpha22 * c_0 + delta22 * c_2;  // by eta11
  gradient[29] = alpha23 * c_1 + delta23 * c_3;  // by eta21
  return value;
}

/// harmonic_re_v1_conjA_v1_F = (-2*omega1^2*delta22*eta21 + 4*omega1*omega2*delta22*eta21 + 3*omega2^2*eta12 +
/// 2*alpha22*eta21)/(24*omega2^3*(omega1 - omega2)) + (omega1^2*delta21*eta11 - 2*omega1*omega2*delta21*eta11 +
/// 4*omega2^2*delta21*eta11 - alpha21*eta11)/(4*omega2*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 -
/// 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 76 operations.
template <class Scalar>
Scalar lump_77(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar eta11 = parameters[20];
  const Scalar eta12 = parameters[21];
  const Scalar eta21 = parameters[29];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = -omega1_2 * delta22 * eta21 * per_0 / (Scalar(12.0) * omega2_3);
  const Scalar f_1 = omega1 * delta22 * eta21 * per_0 / (Scalar(6.0) * omega2_2);
  const Scalar f_2 = eta12 * per_0 / (Scalar(8.0) * omega2);
  const Scalar f_3 = alpha22 * eta21 * per_0 / (Scalar(12.0) * omega2_3);
  const Scalar f_4 = omega1_2 * delta21 * eta11 * per_1 * per_0 * per_2 / (Scalar(4.0) * omega2);
  const Scalar f_5 = -omega1 * delta21 * eta11 * per_1 * per_0 * per_2 / Scalar(2.0);
  const Scalar f_6 = omega2 * delta21 * eta11 * per_1 * per_0 * per_2;
  const Scalar f_7 = -alpha21 * eta11 * per_1 * per_0 * per_2 / (Scalar(4.0) * omega2);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7) * per_0;
  const Scalar q_1 = (f_4 + f_5 + f_6 + f_7) * per_1;
  const Scalar q_2 = (f_4 + f_5 + f_6 + f_7) * per_2;
  gradient[0] = (Scalar(2.0) * f_0 + f_1 + Scalar(2.0) * f_4 + f_5) / omega1 - q_0 - q_1 - q_2;  // by omega1
  // by omega2
  gradient[1] = (-Scalar(3.0) * f_0 - Scalar(2.0) * f_1 - f_2 - Scalar(3.0) * f_3 - f_4 + f_6 - f_7) / omega2 + q_0
      - Scalar(2.0) * q_1 + Scalar(2.0) * q_2;
  const Scalar c_0 = -per_1 * per_0 * per_2 / (Scalar(4.0) * omega2);  // multiplies alpha21*eta11
  const Scalar c_1 = per_0 / (Scalar(12.0) * omega2_3);  // multiplies alpha22*eta21
  // multiplies delta21*eta11
  const Scalar c_2 = (omega1_2 - Scalar(2.0) * omega1 * omega2
      + Scalar(4.0) * omega2_2) * per_1 * per_0 * per_2 / (Scalar(4.0) * omega2);
  // multiplies delta22*eta21
  const Scalar c_3 = (-omega1_2 + Scalar(2.0) * omega1 * omega2) * per_0 / (Scalar(12.0) * omega2_3);
  const Scalar c_4 = per_0 / (Scalar(8.0) * omega2);  // multiplies eta12
  gradient[5] = eta11 * c_0;  // by alpha21
  gradient[6] = eta21 * c_1;  // by alpha22
  gradient[8] = eta11 * c_2;  // by delta21
  gradient[9] = eta21 * c_3;  // by delta22
  gradient[20] = alpha21 * c_0 + delta21 * c_2;  // by eta11
  gradient[21] = c_4;  // by eta12
  gradient[29] = alpha22 * c_1 + delta22 * c_3;  // by eta21
  return value;
}

/// harmonic_re_v1_A_v2_F = (2*omega2^2*delta23*eta21 + alpha23*eta21)/(3*omega2^2*(omega1 + 3*omega2)*(omega1 -
/// 3*omega2)) + (6*omega2^2*delta22*eta11 - alpha22*eta11)/((omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 -
/// 2*omega2)*(omega1 - 3*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 50 operations.
template <class Scalar>
Scalar lump_78(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar eta11 = parameters[20];
  const Scalar eta21 = parameters[29];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(3.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(3.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = Scalar(2.0) * delta23 * eta21 * per_0 * per_1 / Scalar(3.0);
  const Scalar f_1 = alpha23 * eta21 * per_0 * per_1 / (Scalar(3.0) * omega2_2);
  const Scalar f_2 = Scalar(6.0) * omega2_2 * delta22 * eta11 * per_2 * per_0 * per_3 * per_1;
  const Scalar f_3 = -alpha22 * eta11 * per_2 * per_0 * per_3 * per_1;
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3) * per_1;
  const Scalar q_2 = (f_2 + f_3) * per_2;
  const Scalar q_3 = (f_2 + f_3) * per_3;
  gradient[0] = -q_0 - q_1 - q_2 - q_3;  // by omega1
  // by omega2
  gradient[1] = (-Scalar(2.0) * f_1 + Scalar(2.0) * f_2) / omega2 - Scalar(3.0) * q_0 + Scalar(3.0) * q_1
      - Scalar(2.0) * q_2 + Scalar(2.0) * q_3;
  const Scalar c_0 = -per_2 * per_0 * per_3 * per_1;  // multiplies alpha22*eta11
  const Scalar c_1 = per_0 * per_1 / (Scalar(3.0) * omega2_2);  // multiplies alpha23*eta21
  const Scalar c_2 = Scalar(6.0) * omega2_2 * per_2 * per_0 * per_3 * per_1;  // multiplies delta22*eta11
  const Scalar c_3 = Scalar(2.0) * per_0 * per_1 / Scalar(3.0);  // multiplies delta23*eta21
  gradient[6] = eta11 * c_0;  // by alpha22
  gradient[7] = eta21 * c_1;  // by alpha23
  gradient[9] = eta11 * c_2;  // by delta22
  gradient[10] = eta21 * c_3;  // by delta23
  gradient[20] = alpha22 * c_0 + delta22 * c_2;  // by eta11
  gradient[29] = alpha23 * c_1 + delta23 * c_3;  // by eta21
  return value;
}

/// harmonic_re_v1_A_v1_F = (2*omega1^2*delta22*eta21 + 4*omega1*omega2*delta22*eta21 - 3*omega2^2*eta12 -
/// 2*alpha22*eta21)/(24*omega2^3*(omega1 + omega2)) + (-omega1^2*delta21*eta11 - 2*omega1*omega2*delta21*eta11 -
/// 4*omega2^2*delta21*eta11 + alpha21*eta11)/(4*omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 -
/// 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 76 operations.
template <class Scalar>
Scalar lump_79(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar eta11 = parameters[20];
  const Scalar eta12 = parameters[21];
  const Scalar eta21 = parameters[29];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = omega1_2 * delta22 * eta21 * per_0 / (Scalar(12.0) * omega2_3);
  const Scalar f_1 = omega1 * delta22 * eta21 * per_0 / (Scalar(6.0) * omega2_2);
  const Scalar f_2 = -eta12 * per_0 / (Scalar(8.0) * omega2);
  const Scalar f_3 = -alpha22 * eta21 * per_0 / (Scalar(12.0) * omega2_3);
  const Scalar f_4 = -omega1_2 * delta21 * eta11 * per_0 * per_1 * per_2 / (Scalar(4.0) * omega2);
  const Scalar f_5 = -omega1 * delta21 * eta11 * per_0 * per_1 * per_2 / Scalar(2.0);
  const Scalar f_6 = -omega2 * delta21 * eta11 * per_0 * per_1 * per_2;
  const Scalar f_7 = alpha21 * eta11 * per_0 * per_1 * per_2 / (Scalar(4.0) * omega2);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7) * per_0;
  const Scalar q_1 = (f_4 + f_5 + f_6 + f_7) * per_1;
  const Scalar q_2 = (f_4 + f_5 + f_6 + f_7) * per_2;
  gradient[0] = (Scalar(2.0) * f_0 + f_1 + Scalar(2.0) * f_4 + f_5) / omega1 - q_0 - q_1 - q_2;  // by omega1
  // by omega2
  gradient[1] = (-Scalar(3.0) * f_0 - Scalar(2.0) * f_1 - f_2 - Scalar(3.0) * f_3 - f_4 + f_6 - f_7) / omega2 - q_0
      - Scalar(2.0) * q_1 + Scalar(2.0) * q_2;
  const Scalar c_0 = per_0 * per_1 * per_2 / (Scalar(4.0) * omega2);  // multiplies alpha21*eta11
  const Scalar c_1 = -per_0 / (Scalar(12.0) * omega2_3);  // multiplies alpha22*eta21
  // multiplies delta21*eta11
  const Scalar c_2 = (-omega1_2 - Scalar(2.0) * omega1 * omega2
      - Scalar(4.0) * omega2_2) * per_0 * per_1 * per_2 / (Scalar(4.0) * omega2);
  // multiplies delta22*eta21
  const Scalar c_3 = (omega1_2 + Scalar(2.0) * omega1 * omega2) * per_0 / (Scalar(12.0) * omega2_3);
  const Scalar c_4 = -per_0 / (Scalar(8.0) * omega2);  // multiplies eta12
  gradient[5] = eta11 * c_0;  // by alpha21
  gradient[6] = eta21 * c_1;  // by alpha22
  gradient[8] = eta11 * c_2;  // by delta21
  gradient[9] = eta21 * c_3;  // by delta22
  gradient[20] = alpha21 * c_0 + delta21 * c_2;  // by eta11
  gradient[21] = c_4;  // by eta12
  gradient[29] = alpha22 * c_1 + delta22 * c_3;  // by eta21
  return value;
}

/// harmonic_im_v2_F = eta11*mu21/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 15 operations.
template <class Scalar>
Scalar lump_80(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar eta11 = parameters[20];
  const Scalar mu21 = parameters[23];
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = eta11 * mu21 * per_0 * per_1 / (Scalar(3.0) * omega2);
  const Scalar value = f_0;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_0 * per_0;
  const Scalar q_1 = f_0 * per_1;
  gradient[0] = -q_0 - q_1;  // by omega1
  gradient[1] = -f_0 / omega2 - Scalar(2.0) * q_0 + Scalar(2.0) * q_1;  // by omega2
  const Scalar c_0 = per_0 * per_1 / (Scalar(3.0) * omega2);  // multiplies eta11*mu21
  gradient[20] = mu21 * c_0;  // by eta11
  gradient[23] = eta11 * c_0;  // by mu21
  return value;
}

/// harmonic_re_v2_conjA_v1_F = (-2*omega1*omega2*delta23*eta21 + 4*omega2^2*delta23*eta21 -
/// alpha23*eta21)/(3*omega2^2*(omega1 - omega2)*(omega1 - 3*omega2)) + (-2*omega1*omega2*delta22*eta11 +
/// alpha22*eta11)/((omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 62 operations.
template <class Scalar>
Scalar lump_81(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar eta11 = parameters[20];
  const Scalar eta21 = parameters[29];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(3.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = -Scalar(2.0) * omega1 * delta23 * eta21 * per_0 * per_1 / (Scalar(3.0) * omega2);
  const Scalar f_1 = Scalar(4.0) * delta23 * eta21 * per_0 * per_1 / Scalar(3.0);
  const Scalar f_2 = -alpha23 * eta21 * per_0 * per_1 / (Scalar(3.0) * omega2_2);
  const Scalar f_3 = -Scalar(2.0) * omega1 * omega2 * delta22 * eta11 * per_2 * per_0 * per_3 * per_1;
  const Scalar f_4 = alpha22 * eta11 * per_2 * per_0 * per_3 * per_1;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_1;
  const Scalar q_2 = (f_3 + f_4) * per_2;
  const Scalar q_3 = (f_3 + f_4) * per_3;
  gradient[0] = (f_0 + f_3) / omega1 - q_0 - q_1 - q_2 - q_3;  // by omega1
  // by omega2
  gradient[1] = (-f_0 - Scalar(2.0) * f_2 + f_3) / omega2 + q_0 + Scalar(3.0) * q_1 - Scalar(2.0) * q_2
      + Scalar(2.0) * q_3;
  const Scalar c_0 = per_2 * per_0 * per_3 * per_1;  // multiplies alpha22*eta11
  const Scalar c_1 = -per_0 * per_1 / (Scalar(3.0) * omega2_2);  // multiplies alpha23*eta21
  const Scalar c_2 = -Scalar(2.0) * omega1 * omega2 * per_2 * per_0 * per_3 * per_1;  // multiplies delta22*eta11
  // multiplies delta23*eta21
  const Scalar c_3 = (-Scalar(2.0) * omega1 + Scalar(4.0) * omega2) * per_0 * per_1 / (Scalar(3.0) * omega2);
  gradient[6] = eta11 * c_0;  // by alpha22
  gradient[7] = eta21 * c_1;  // by alpha23
  gradient[9] = eta11 * c_2;  // by delta22
  gradient[10] = eta21 * c_3;  // by delta23
  gradient[20] = alpha22 * c_0 + delta22 * c_2;  // by eta11
  gradient[29] = alpha23 * c_1 + delta23 * c_3;  // by eta21
  return value;
}

/// harmonic_re_v2_A_v2_F = (14*omega2^2*delta24*eta21 - 3*omega2^2*eta22 - 2*alpha24*eta21)/(48*omega2^4) +
/// (-3*omega2^2*delta23*eta11 + alpha23*eta11)/(8*omega2^2*(omega1 + 2*omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 38 operations.
template <class Scalar>
Scalar lump_82(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha23 = parameters[7];
  const Scalar delta23 = parameters[10];
  const Scalar eta11 = parameters[20];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar eta21 = parameters[29];
  const Scalar eta22 = parameters[30];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = (Scalar(14.0) * delta24 * eta21 - Scalar(3.0) * eta22) / (Scalar(48.0) * omega2_2);
  const Scalar f_1 = -alpha24 * eta21 / (Scalar(24.0) * omega2_4);
  const Scalar f_2 = -Scalar(3.0) * delta23 * eta11 * per_0 * per_1 / Scalar(8.0);
  const Scalar f_3 = alpha23 * eta11 * per_0 * per_1 / (Scalar(8.0) * omega2_2);
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_2 + f_3) * per_0;
  const Scalar q_1 = (f_2 + f_3) * per_1;
  gradient[0] = -q_0 - q_1;  // by omega1
  // by omega2
  gradient[1] = (-Scalar(2.0) * f_0 - Scalar(4.0) * f_1 - Scalar(2.0) * f_3) / omega2 - Scalar(2.0) * q_0
      + Scalar(2.0) * q_1;
  const Scalar c_0 = per_0 * per_1 / (Scalar(8.0) * omega2_2);  // multiplies alpha23*eta11
  const Scalar c_1 = -Scalar(3.0) * per_0 * per_1 / Scalar(8.0);  // multiplies delta23*eta11
  const Scalar c_2 = -Scalar(1.0) / (Scalar(24.0) * omega2_4);  // multiplies alpha24*eta21
  const Scalar c_3 = Scalar(7.0) / (Scalar(24.0) * omega2_2);  // multiplies delta24*eta21
  const Scalar c_4 = -Scalar(1.0) / (Scalar(16.0) * omega2_2);  // multiplies eta22
  gradient[7] = eta11 * c_0;  // by alpha23
  gradient[10] = eta11 * c_1;  // by delta23
  gradient[20] = alpha23 * c_0 + delta23 * c_1;  // by eta11
  gradient[25] = eta21 * c_2;  // by alpha24
  gradient[26] = eta21 * c_3;  // by delta24
  gradient[29] = alpha24 * c_2 + delta24 * c_3;  // by eta21
  gradient[30] = c_4;  // by eta22
  return value;
}

/// harmonic_re_v2_A_v1_F = (2*omega1*omega2*delta23*eta21 + 4*omega2^2*delta23*eta21 -
/// alpha23*eta21)/(3*omega2^2*(omega1 + omega2)*(omega1 + 3*omega2)) + (2*omega1*omega2*delta22*eta11 +
/// alpha22*eta11)/((omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 62 operations.
template <class Scalar>
Scalar lump_83(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar eta11 = parameters[20];
  const Scalar eta21 = parameters[29];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(3.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = Scalar(2.0) * omega1 * delta23 * eta21 * per_0 * per_1 / (Scalar(3.0) * omega2);
  const Scalar f_1 = Scalar(4.0) * delta23 * eta21 * per_0 * per_1 / Scalar(3.0);
  const Scalar f_2 = -alpha23 * eta21 * per_0 * per_1 / (Scalar(3.0) * omega2_2);
  const Scalar f_3 = Scalar(2.0) * omega1 * omega2 * delta22 * eta11 * per_0 * per_2 * per_1 * per_3;
  const Scalar f_4 = alpha22 * eta11 * per_0 * per_2 * per_1 * per_3;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_1;
  const Scalar q_2 = (f_3 + f_4) * per_2;
  const Scalar q_3 = (f_3 + f_4) * per_3;
  gradient[0] = (f_0 + f_3) / omega1 - q_0 - q_1 - q_2 - q_3;  // by omega1
  // by omega2
  gradient[1] = (-f_0 - Scalar(2.0) * f_2 + f_3) / omega2 - q_0 - Scalar(3.0) * q_1 - Scalar(2.0) * q_2
      + Scalar(2.0) * q_3;
  const Scalar c_0 = per_0 * per_2 * per_1 * per_3;  // multiplies alpha22*eta11
  const Scalar c_1 = -per_0 * per_1 / (Scalar(3.0) * omega2_2);  // multiplies alpha23*eta21
  const Scalar c_2 = Scalar(2.0) * omega1 * omega2 * per_0 * per_2 * per_1 * per_3;  // multiplies delta22*eta11
  // multiplies delta23*eta21
  const Scalar c_3 = (Scalar(2.0) * omega1 + Scalar(4.0) * omega2) * per_0 * per_1 / (Scalar(3.0) * omega2);
  gradient[6] = eta11 * c_0;  // by alpha22
  gradient[7] = eta21 * c_1;  // by alpha23
  gradient[9] = eta11 * c_2;  // by delta22
  gradient[10] = eta21 * c_3;  // by delta23
  gradient[20] = alpha22 * c_0 + delta22 * c_2;  // by eta11
  gradient[29] = alpha23 * c_1 + delta23 * c_3;  // by eta21
  return value;
}

/// conservative_v1_A_v1_F2 = -eta12^2/(4*omega1*(omega1 - omega2)*(3*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 14 operations.
template <class Scalar>
Scalar lump_84(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar eta12 = parameters[21];
  const Scalar eta12_2 = eta12 * eta12;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(3.0) * omega1 + omega2);
  const Scalar f_0 = -eta12_2 * per_0 * per_1 / (Scalar(4.0) * omega1);
  const Scalar value = f_0;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_0 * per_0;
  const Scalar q_1 = f_0 * per_1;
  gradient[0] = -f_0 / omega1 - q_0 - Scalar(3.0) * q_1;  // by omega1
  gradient[1] = q_0 - q_1;  // by omega2
  const Scalar c_0 = -per_0 * per_1 / (Scalar(4.0) * omega1);  // multiplies eta12^2
  gradient[21] = Scalar(2.0) * eta12 * c_0;  // by eta12
  return value;
}

/// dissipative_v1_conjA_v2_F = (omega1*mu12*eta22 + omega2*mu12*eta12)/(4*omega1*(omega1 + omega2)*(omega1 -
/// omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 21 operations.
template <class Scalar>
Scalar lump_85(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu12 = parameters[3];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = mu12 * eta22 * per_0 * per_1 / Scalar(4.0);
  const Scalar f_1 = omega2 * mu12 * eta12 * per_0 * per_1 / (Scalar(4.0) * omega1);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1) * per_0;
  const Scalar q_1 = (f_0 + f_1) * per_1;
  gradient[0] = -f_1 / omega1 - q_0 - q_1;  // by omega1
  gradient[1] = f_1 / omega2 - q_0 + q_1;  // by omega2
  const Scalar c_0 = omega2 * per_0 * per_1 / (Scalar(4.0) * omega1);  // multiplies mu12*eta12
  const Scalar c_1 = per_0 * per_1 / Scalar(4.0);  // multiplies mu12*eta22
  gradient[3] = eta12 * c_0 + eta22 * c_1;  // by mu12
  gradient[21] = mu12 * c_0;  // by eta12
  gradient[30] = mu12 * c_1;  // by eta22
  return value;
}

/// conservative_v1_conjA_v2_F = (omega1*omega2*delta23*eta21 + omega2^2*delta23*eta21 -
/// alpha23*eta21)/(2*omega1^2*(omega1 + 2*omega2)) + (omega1^2*delta22*eta11 + omega1*omega2*delta22*eta11 -
/// alpha22*eta11)/(2*omega1*omega2*(2*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 49 operations.
template <class Scalar>
Scalar lump_86(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar eta11 = parameters[20];
  const Scalar eta21 = parameters[29];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar f_0 = omega2 * delta23 * eta21 * per_0 / (Scalar(2.0) * omega1);
  const Scalar f_1 = omega2_2 * delta23 * eta21 * per_0 / (Scalar(2.0) * omega1_2);
  const Scalar f_2 = -alpha23 * eta21 * per_0 / (Scalar(2.0) * omega1_2);
  const Scalar f_3 = omega1 * delta22 * eta11 * per_1 / (Scalar(2.0) * omega2);
  const Scalar f_4 = delta22 * eta11 * per_1 / Scalar(2.0);
  const Scalar f_5 = -alpha22 * eta11 * per_1 / (Scalar(2.0) * omega1 * omega2);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2) * per_0;
  const Scalar q_1 = (f_3 + f_4 + f_5) * per_1;
  // by omega1
  gradient[0] = (-f_0 - Scalar(2.0) * f_1 - Scalar(2.0) * f_2 + f_3 - f_5) / omega1 - q_0 - Scalar(2.0) * q_1;
  gradient[1] = (f_0 + Scalar(2.0) * f_1 - f_3 - f_5) / omega2 - Scalar(2.0) * q_0 - q_1;  // by omega2
  const Scalar c_0 = -per_1 / (Scalar(2.0) * omega1 * omega2);  // multiplies alpha22*eta11
  const Scalar c_1 = -per_0 / (Scalar(2.0) * omega1_2);  // multiplies alpha23*eta21
  const Scalar c_2 = (omega1 + omega2) * per_1 / (Scalar(2.0) * omega2);  // multiplies delta22*eta11
  const Scalar c_3 = (omega1 * omega2 + omega2_2) * per_0 / (Scalar(2.0) * omega1_2);  // multiplies delta23*eta21
  gradient[6] = eta11 * c_0;  // by alpha22
  gradient[7] = eta21 * c_1;  // by alpha23
  gradient[9] = eta11 * c_2;  // by delta22
  gradient[10] = eta21 * c_3;  // by delta23
  gradient[20] = alpha22 * c_0 + delta22 * c_2;  // by eta11
  gradient[29] = alpha23 * c_1 + delta23 * c_3;  // by eta21
  return value;
}

/// conservative_v2_A_v2_F2 = eta22^2/(4*omega2*(omega1 + 3*omega2)*(omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 14 operations.
template <class Scalar>
Scalar lump_87(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar eta22 = parameters[30];
  const Scalar eta22_2 = eta22 * eta22;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(3.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = eta22_2 * per_0 * per_1 / (Scalar(4.0) * omega2);
  const Scalar value = f_0;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_0 * per_0;
  const Scalar q_1 = f_0 * per_1;
  gradient[0] = -q_0 - q_1;  // by omega1
  gradient[1] = -f_0 / omega2 - Scalar(3.0) * q_0 + q_1;  // by omega2
  const Scalar c_0 = per_0 * per_1 / (Scalar(4.0) * omega2);  // multiplies eta22^2
  gradient[30] = Scalar(2.0) * eta22 * c_0;  // by eta22
  return value;
}

/// dissipative_v2_conjA_v1_F = (-omega1*mu21*eta22 - omega2*eta12*mu21)/(4*omega2*(omega1 + omega2)*(omega1 -
/// omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 21 operations.
template <class Scalar>
Scalar lump_88(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar eta12 = parameters[21];
  const Scalar mu21 = parameters[23];
  const Scalar eta22 = parameters[30];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -omega1 * mu21 * eta22 * per_0 * per_1 / (Scalar(4.0) * omega2);
  const Scalar f_1 = -eta12 * mu21 * per_0 * per_1 / Scalar(4.0);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1) * per_0;
  const Scalar q_1 = (f_0 + f_1) * per_1;
  gradient[0] = f_0 / omega1 - q_0 - q_1;  // by omega1
  gradient[1] = -f_0 / omega2 - q_0 + q_1;  // by omega2
  const Scalar c_0 = -per_0 * per_1 / Scalar(4.0);  // multiplies eta12*mu21
  const Scalar c_1 = -omega1 * per_0 * per_1 / (Scalar(4.0) * omega2);  // multiplies mu21*eta22
  gradient[21] = mu21 * c_0;  // by eta12
  gradient[23] = eta12 * c_0 + eta22 * c_1;  // by mu21
  gradient[30] = mu21 * c_1;  // by eta22
  return value;
}

/// harmonic_re_v1_conjA_v1_F = (omega1*omega2*delta22*eta21 + alpha22*eta21)/(omega1*(omega1 + omega2)*(omega1 +
/// 2*omega2)*(omega1 - omega2)) + (-omega1^2*delta21*eta11 - omega1*omega2*delta21*eta11 -
/// omega2^2*delta21*eta11 + alpha21*eta11)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 59 operations.
template <class Scalar>
Scalar lump_89(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar eta11 = parameters[20];
  const Scalar eta21 = parameters[29];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar f_0 = omega2 * delta22 * eta21 * per_0 * per_1 * per_2;
  const Scalar f_1 = alpha22 * eta21 * per_0 * per_1 * per_2 / omega1;
  const Scalar f_2 = -omega1_2 * delta21 * eta11 * per_0 * per_2 * per_3 / omega2;
  const Scalar f_3 = -omega1 * delta21 * eta11 * per_0 * per_2 * per_3;
  const Scalar f_4 = -omega2 * delta21 * eta11 * per_0 * per_2 * per_3;
  const Scalar f_5 = alpha21 * eta11 * per_0 * per_2 * per_3 / omega2;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_0;
  const Scalar q_1 = (f_0 + f_1) * per_1;
  const Scalar q_2 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_2;
  const Scalar q_3 = (f_2 + f_3 + f_4 + f_5) * per_3;
  gradient[0] = (-f_1 + Scalar(2.0) * f_2 + f_3) / omega1 - q_0 - q_1 - q_2 - Scalar(2.0) * q_3;  // by omega1
  gradient[1] = (f_0 - f_2 + f_4 - f_5) / omega2 - q_0 - Scalar(2.0) * q_1 + q_2 - q_3;  // by omega2
  const Scalar c_0 = per_0 * per_2 * per_3 / omega2;  // multiplies alpha21*eta11
  const Scalar c_1 = per_0 * per_1 * per_2 / omega1;  // multiplies alpha22*eta21
  // multiplies delta21*eta11
  const Scalar c_2 = (-omega1_2 - omega1 * omega2 - omega2_2) * per_0 * per_2 * per_3 / omega2;
  const Scalar c_3 = omega2 * per_0 * per_1 * per_2;  // multiplies delta22*eta21
  gradient[5] = eta11 * c_0;  // by alpha21
  gradient[6] = eta21 * c_1;  // by alpha22
  gradient[8] = eta11 * c_2;  // by delta21
  gradient[9] = eta21 * c_3;  // by delta22
  gradient[20] = alpha21 * c_0 + delta21 * c_2;  // by eta11
  gradient[29] = alpha22 * c_1 + delta22 * c_3;  // by eta21
  return value;
}

/// harmonic_re_v1_conjA_v12_F = (3*omega1^4*delta21*eta12 - 6*omega1^3*omega2*delta21*eta12 +
/// 9*omega1^2*omega2^2*delta21*eta12 - 5*omega1^2*alpha21*eta12 -
/// omega2^2*alpha21*eta12)/(6*omega1^2*omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 58 operations.
template <class Scalar>
Scalar lump_90(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar delta21 = parameters[8];
  const Scalar eta12 = parameters[21];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = omega1_2 * delta21 * eta12 * per_0 * per_1 * per_2 / (Scalar(2.0) * omega2);
  const Scalar f_1 = -omega1 * delta21 * eta12 * per_0 * per_1 * per_2;
  const Scalar f_2 = Scalar(3.0) * omega2 * delta21 * eta12 * per_0 * per_1 * per_2 / Scalar(2.0);
  const Scalar f_3 = -Scalar(5.0) * alpha21 * eta12 * per_0 * per_1 * per_2 / (Scalar(6.0) * omega2);
  const Scalar f_4 = -omega2 * alpha21 * eta12 * per_0 * per_1 * per_2 / (Scalar(6.0) * omega1_2);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_1;
  const Scalar q_2 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_2;
  // by omega1
  gradient[0] = (Scalar(2.0) * f_0 + f_1 - Scalar(2.0) * f_4) / omega1 - q_0 - q_1 - Scalar(2.0) * q_2;
  gradient[1] = (-f_0 + f_2 - f_3 + f_4) / omega2 - q_0 + q_1 + q_2;  // by omega2
  // multiplies alpha21*eta12
  const Scalar c_0 = (-Scalar(5.0) * omega1_2
      - omega2_2) * per_0 * per_1 * per_2 / (Scalar(6.0) * omega1_2 * omega2);
  // multiplies delta21*eta12
  const Scalar c_1 = (omega1_2 - Scalar(2.0) * omega1 * omega2
      + Scalar(3.0) * omega2_2) * per_0 * per_1 * per_2 / (Scalar(2.0) * omega2);
  gradient[5] = eta12 * c_0;  // by alpha21
  gradient[8] = eta12 * c_1;  // by delta21
  gradient[21] = alpha21 * c_0 + delta21 * c_1;  // by eta12
  return value;
}

/// harmonic_re_v1_A_v22_F = (-omega1*omega2*delta23*eta22 + alpha23*eta22)/(omega2*(omega1 + omega2)*(omega1 -
/// omega2)*(2*omega1 - omega2)) + (-omega2^2*delta23*eta12 - alpha23*eta12)/(2*omega2*(omega1 +
/// 2*omega2)*(omega1 - 2*omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 51 operations.
template <class Scalar>
Scalar lump_91(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha23 = parameters[7];
  const Scalar delta23 = parameters[10];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_4 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = -omega1 * delta23 * eta22 * per_0 * per_1 * per_2;
  const Scalar f_1 = alpha23 * eta22 * per_0 * per_1 * per_2 / omega2;
  const Scalar f_2 = -omega2 * delta23 * eta12 * per_3 * per_4 * per_2 / Scalar(2.0);
  const Scalar f_3 = -alpha23 * eta12 * per_3 * per_4 * per_2 / (Scalar(2.0) * omega2);
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1) * per_0;
  const Scalar q_1 = (f_0 + f_1) * per_1;
  const Scalar q_2 = (f_0 + f_1 + f_2 + f_3) * per_2;
  const Scalar q_3 = (f_2 + f_3) * per_3;
  const Scalar q_4 = (f_2 + f_3) * per_4;
  gradient[0] = f_0 / omega1 - q_0 - q_1 - Scalar(2.0) * q_2 - q_3 - q_4;  // by omega1
  gradient[1] = (-f_1 + f_2 - f_3) / omega2 - q_0 + q_1 + q_2 - Scalar(2.0) * q_3 + Scalar(2.0) * q_4;  // by omega2
  const Scalar c_0 = -per_3 * per_4 * per_2 / (Scalar(2.0) * omega2);  // multiplies alpha23*eta12
  const Scalar c_1 = per_0 * per_1 * per_2 / omega2;  // multiplies alpha23*eta22
  const Scalar c_2 = -omega2 * per_3 * per_4 * per_2 / Scalar(2.0);  // multiplies delta23*eta12
  const Scalar c_3 = -omega1 * per_0 * per_1 * per_2;  // multiplies delta23*eta22
  gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
  gradient[10] = eta12 * c_2 + eta22 * c_3;  // by delta23
  gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
  gradient[30] = alpha23 * c_1 + delta23 * c_3;  // by eta22
  return value;
}

/// harmonic_re_v1_conjA_v1_conjA_v2_F = (-omega1^2*delta22*eta12 - omega1*omega2*delta22*eta12 +
/// alpha22*eta12)/(omega1^2*omega2*(2*omega1 + omega2)) + (-alpha22*eta12 + alpha22*eta22)/(omega1^2*(omega1 +
/// omega2)*(omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 37 operations.
template <class Scalar>
Scalar lump_92(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar delta22 = parameters[9];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -delta22 * eta12 * per_0 / omega2;
  const Scalar f_1 = -delta22 * eta12 * per_0 / omega1;
  const Scalar f_2 = alpha22 * eta12 * per_0 / (omega1_2 * omega2);
  const Scalar f_3 = (-alpha22 * eta12 + alpha22 * eta22) * per_1 * per_2 / omega1_2;
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2) * per_0;
  const Scalar q_1 = f_3 * per_1;
  const Scalar q_2 = f_3 * per_2;
  // by omega1
  gradient[0] = (-f_1 - Scalar(2.0) * f_2 - Scalar(2.0) * f_3) / omega1 - Scalar(2.0) * q_0 - q_1 - q_2;
  gradient[1] = (-f_0 - f_2) / omega2 - q_0 - q_1 + q_2;  // by omega2
  const Scalar c_0 = per_0 / (omega1_2 * omega2) - per_1 * per_2 / omega1_2;  // multiplies alpha22*eta12
  const Scalar c_1 = per_1 * per_2 / omega1_2;  // multiplies alpha22*eta22
  const Scalar c_2 = (-omega1 - omega2) * per_0 / (omega1 * omega2);  // multiplies delta22*eta12
  gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
  gradient[9] = eta12 * c_2;  // by delta22
  gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
  gradient[30] = alpha22 * c_1;  // by eta22
  return value;
}

/// harmonic_re_v1_F2 = -eta11*eta12/(2*omega1^2*omega2*(2*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 12 operations.
template <class Scalar>
Scalar lump_93(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar eta11 = parameters[20];
  const Scalar eta12 = parameters[21];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar f_0 = -eta11 * eta12 * per_0 / (Scalar(2.0) * omega1_2 * omega2);
  const Scalar value = f_0;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_0 * per_0;
  gradient[0] = -Scalar(2.0) * f_0 / omega1 - Scalar(2.0) * q_0;  // by omega1
  gradient[1] = -f_0 / omega2 - q_0;  // by omega2
  const Scalar c_0 = -per_0 / (Scalar(2.0) * omega1_2 * omega2);  // multiplies eta11*eta12
  gradient[20] = eta12 * c_0;  // by eta11
  gradient[21] = eta11 * c_0;  // by eta12
  return value;
}

/// harmonic_im_v1_F = (-omega1*mu12*eta21 - omega2*mu12*eta21)/(2*omega1*omega2*(omega1 + 2*omega2)*(2*omega1 +
/// omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 22 operations.
template <class Scalar>
Scalar lump_94(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu12 = parameters[3];
  const Scalar eta21 = parameters[29];
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar f_0 = -mu12 * eta21 * per_0 * per_1 / (Scalar(2.0) * omega2);
  const Scalar f_1 = -mu12 * eta21 * per_0 * per_1 / (Scalar(2.0) * omega1);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1) * per_0;
  const Scalar q_1 = (f_0 + f_1) * per_1;
  gradient[0] = -f_1 / omega1 - q_0 - Scalar(2.0) * q_1;  // by omega1
  gradient[1] = -f_0 / omega2 - Scalar(2.0) * q_0 - q_1;  // by omega2
  const Scalar c_0 = (-omega1 - omega2) * per_0 * per_1 / (Scalar(2.0) * omega1 * omega2);  // multiplies mu12*eta21
  gradient[3] = eta21 * c_0;  // by mu12
  gradient[29] = mu12 * c_0;  // by eta21
  return value;
}

/// harmonic_re_v1_A_v2_conjA_v2_F = (-omega2^2*delta23*eta12 + alpha23*eta12)/(omega1^2*omega2*(2*omega1 +
/// omega2)) + (-2*omega2^2*delta23*eta22 - 2*alpha23*eta22)/(omega2*(omega1 + 3*omega2)*(omega1 -
/// omega2)*(2*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 41 operations.
template <class Scalar>
Scalar lump_95(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha23 = parameters[7];
  const Scalar delta23 = parameters[10];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(3.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -omega2 * delta23 * eta12 * per_0 / omega1_2;
  const Scalar f_1 = alpha23 * eta12 * per_0 / (omega1_2 * omega2);
  const Scalar f_2 = -Scalar(2.0) * omega2 * delta23 * eta22 * per_1 * per_2 * per_0;
  const Scalar f_3 = -Scalar(2.0) * alpha23 * eta22 * per_1 * per_2 * per_0 / omega2;
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = (f_2 + f_3) * per_1;
  const Scalar q_2 = (f_2 + f_3) * per_2;
  gradient[0] = (-Scalar(2.0) * f_0 - Scalar(2.0) * f_1) / omega1 - Scalar(2.0) * q_0 - q_1 - q_2;  // by omega1
  gradient[1] = (f_0 - f_1 + f_2 - f_3) / omega2 - q_0 - Scalar(3.0) * q_1 + q_2;  // by omega2
  const Scalar c_0 = per_0 / (omega1_2 * omega2);  // multiplies alpha23*eta12
  const Scalar c_1 = -Scalar(2.0) * per_1 * per_2 * per_0 / omega2;  // multiplies alpha23*eta22
  const Scalar c_2 = -omega2 * per_0 / omega1_2;  // multiplies delta23*eta12
  const Scalar c_3 = -Scalar(2.0) * omega2 * per_1 * per_2 * per_0;  // multiplies delta23*eta22
  gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
  gradient[10] = eta12 * c_2 + eta22 * c_3;  // by delta23
  gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
  gradient[30] = alpha23 * c_1 + delta23 * c_3;  // by eta22
  return value;
}

/// harmonic_re_v1_A_v1_conjA_v1_F = (-3*omega1^4*delta21*eta12 - 2*omega1^3*omega2*delta21*eta12 -
/// omega1^2*omega2^2*delta21*eta12 + 5*omega1^2*alpha21*eta12 - 2*omega1*omega2*alpha21*eta12 -
/// omega2^2*alpha21*eta12)/(omega1^2*omega2*(omega1 - omega2)*(2*omega1 + omega2)*(3*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 63 operations.
template <class Scalar>
Scalar lump_96(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar delta21 = parameters[8];
  const Scalar eta12 = parameters[21];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(3.0) * omega1 + omega2);
  const Scalar f_0 = -Scalar(3.0) * omega1_2 * delta21 * eta12 * per_0 * per_1 * per_2 / omega2;
  const Scalar f_1 = -Scalar(2.0) * omega1 * delta21 * eta12 * per_0 * per_1 * per_2;
  const Scalar f_2 = -omega2 * delta21 * eta12 * per_0 * per_1 * per_2;
  const Scalar f_3 = Scalar(5.0) * alpha21 * eta12 * per_0 * per_1 * per_2 / omega2;
  const Scalar f_4 = -Scalar(2.0) * alpha21 * eta12 * per_0 * per_1 * per_2 / omega1;
  const Scalar f_5 = -omega2 * alpha21 * eta12 * per_0 * per_1 * per_2 / omega1_2;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_1;
  const Scalar q_2 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_2;
  // by omega1
  gradient[0] = (Scalar(2.0) * f_0 + f_1 - f_4 - Scalar(2.0) * f_5) / omega1 - q_0 - Scalar(2.0) * q_1
      - Scalar(3.0) * q_2;
  gradient[1] = (-f_0 + f_2 - f_3 + f_5) / omega2 + q_0 - q_1 - q_2;  // by omega2
  // multiplies alpha21*eta12
  const Scalar c_0 = (Scalar(5.0) * omega1_2 - Scalar(2.0) * omega1 * omega2
      - omega2_2) * per_0 * per_1 * per_2 / (omega1_2 * omega2);
  // multiplies delta21*eta12
  const Scalar c_1 = (-Scalar(3.0) * omega1_2 - Scalar(2.0) * omega1 * omega2
      - omega2_2) * per_0 * per_1 * per_2 / omega2;
  gradient[5] = eta12 * c_0;  // by alpha21
  gradient[8] = eta12 * c_1;  // by delta21
  gradient[21] = alpha21 * c_0 + delta21 * c_1;  // by eta12
  return value;
}

/// harmonic_re_v1_A_v2_conjA_v1_F = (2*omega1*omega2*delta22*eta22 + alpha22*eta22)/((omega1 + omega2)*(omega1 +
/// 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)) + (omega1^4*delta22*eta12 - omega1^3*omega2*delta22*eta12
/// - omega1^2*omega2^2*delta22*eta12 - omega1^2*alpha22*eta12 + 5*omega1*omega2^3*delta22*eta12 -
/// 2*omega1*omega2*alpha22*eta12 - 2*omega2^4*delta22*eta12 + 2*omega2^2*alpha22*eta12)/(omega2*(omega1 +
/// omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 129 operations.
template <class Scalar>
Scalar lump_97(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar delta22 = parameters[9];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + Scalar(3.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_4 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_5 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = Scalar(2.0) * omega1 * omega2 * delta22 * eta22 * per_0 * per_1 * per_2 * per_3;
  const Scalar f_1 = alpha22 * eta22 * per_0 * per_1 * per_2 * per_3;
  const Scalar f_2 = omega1_4 * delta22 * eta12 * per_0 * per_1 * per_4 * per_3 * per_5 / omega2;
  const Scalar f_3 = -omega1_3 * delta22 * eta12 * per_0 * per_1 * per_4 * per_3 * per_5;
  const Scalar f_4 = -omega1_2 * omega2 * delta22 * eta12 * per_0 * per_1 * per_4 * per_3 * per_5;
  const Scalar f_5 = -omega1_2 * alpha22 * eta12 * per_0 * per_1 * per_4 * per_3 * per_5 / omega2;
  const Scalar f_6 = Scalar(5.0) * omega1 * omega2_2 * delta22 * eta12 * per_0 * per_1 * per_4 * per_3 * per_5;
  const Scalar f_7 = -Scalar(2.0) * omega1 * alpha22 * eta12 * per_0 * per_1 * per_4 * per_3 * per_5;
  const Scalar f_8 = -Scalar(2.0) * omega2_3 * delta22 * eta12 * per_0 * per_1 * per_4 * per_3 * per_5;
  const Scalar f_9 = Scalar(2.0) * omega2 * alpha22 * eta12 * per_0 * per_1 * per_4 * per_3 * per_5;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_1;
  const Scalar q_2 = (f_0 + f_1) * per_2;
  const Scalar q_3 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_3;
  const Scalar q_4 = (f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_4;
  const Scalar q_5 = (f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_5;
  // by omega1
  gradient[0] = (f_0 + Scalar(4.0) * f_2 + Scalar(3.0) * f_3 + Scalar(2.0) * f_4 + Scalar(2.0) * f_5 + f_6
      + f_7) / omega1 - q_0 - q_1 - q_2 - q_3 - q_4 - Scalar(2.0) * q_5;
  // by omega2
  gradient[1] = (f_0 - f_2 + f_4 - f_5 + Scalar(2.0) * f_6 + Scalar(3.0) * f_8 + f_9) / omega2 - q_0
      - Scalar(2.0) * q_1 - Scalar(3.0) * q_2 + Scalar(2.0) * q_3 + q_4 + q_5;
  // multiplies alpha22*eta12
  const Scalar c_0 = (-omega1_2 - Scalar(2.0) * omega1 * omega2
      + Scalar(2.0) * omega2_2) * per_0 * per_1 * per_4 * per_3 * per_5 / omega2;
  const Scalar c_1 = per_0 * per_1 * per_2 * per_3;  // multiplies alpha22*eta22
  // multiplies delta22*eta12
  const Scalar c_2 = (omega1_4 - omega1_3 * omega2 - omega1_2 * omega2_2 + Scalar(5.0) * omega1 * omega2_3
      - Scalar(2.0) * omega2_4) * per_0 * per_1 * per_4 * per_3 * per_5 / omega2;
  const Scalar c_3 = Scalar(2.0) * omega1 * omega2 * per_0 * per_1 * per_2 * per_3;  // multiplies delta22*eta22
  gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
  gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
  gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
  gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  return value;
}

/// harmonic_re_v1_A_v1_F = (2*omega1^2*delta22*eta21 + omega1*omega2*delta22*eta21 -
/// alpha22*eta21)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(3*omega1 + omega2)) + (3*omega1^2*delta21*eta11
/// + 3*omega1*omega2*delta21*eta11 + omega2^2*delta21*eta11 - alpha21*eta11)/(omega2*(omega1 + omega2)*(2*omega1
/// + omega2)*(3*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 72 operations.
template <class Scalar>
Scalar lump_98(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar eta11 = parameters[20];
  const Scalar eta21 = parameters[29];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(3.0) * omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar f_0 = Scalar(2.0) * omega1 * delta22 * eta21 * per_0 * per_1 * per_2;
  const Scalar f_1 = omega2 * delta22 * eta21 * per_0 * per_1 * per_2;
  const Scalar f_2 = -alpha22 * eta21 * per_0 * per_1 * per_2 / omega1;
  const Scalar f_3 = Scalar(3.0) * omega1_2 * delta21 * eta11 * per_0 * per_3 * per_2 / omega2;
  const Scalar f_4 = Scalar(3.0) * omega1 * delta21 * eta11 * per_0 * per_3 * per_2;
  const Scalar f_5 = omega2 * delta21 * eta11 * per_0 * per_3 * per_2;
  const Scalar f_6 = -alpha21 * eta11 * per_0 * per_3 * per_2 / omega2;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2) * per_1;
  const Scalar q_2 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_2;
  const Scalar q_3 = (f_3 + f_4 + f_5 + f_6) * per_3;
  // by omega1
  gradient[0] = (f_0 - f_2 + Scalar(2.0) * f_3 + f_4) / omega1 - q_0 - q_1 - Scalar(3.0) * q_2 - Scalar(2.0) * q_3;
  gradient[1] = (f_1 - f_3 + f_5 - f_6) / omega2 - q_0 - Scalar(2.0) * q_1 - q_2 - q_3;  // by omega2
  const Scalar c_0 = -per_0 * per_3 * per_2 / omega2;  // multiplies alpha21*eta11
  const Scalar c_1 = -per_0 * per_1 * per_2 / omega1;  // multiplies alpha22*eta21
  // multiplies delta21*eta11
  const Scalar c_2 = (Scalar(3.0) * omega1_2 + Scalar(3.0) * omega1 * omega2
      + omega2_2) * per_0 * per_3 * per_2 / omega2;
  const Scalar c_3 = (Scalar(2.0) * omega1 + omega2) * per_0 * per_1 * per_2;  // multiplies delta22*eta21
  gradient[5] = eta11 * c_0;  // by alpha21
  gradient[6] = eta21 * c_1;  // by alpha22
  gradient[8] = eta11 * c_2;  // by delta21
  gradient[9] = eta21 * c_3;  // by delta22
  gradient[20] = alpha21 * c_0 + delta21 * c_2;  // by eta11
  gradient[29] = alpha22 * c_1 + delta22 * c_3;  // by eta21
  return value;
}

/// harmonic_re_v1_A_v1_conjA_v2_F = alpha22*eta12/(3*omega1^2*omega2*(2*omega1 - omega2)) +
/// (2*omega1^2*delta22*eta22 - alpha22*eta22)/(3*omega1^2*(omega1 + omega2)*(omega1 - omega2)) -
/// alpha22*eta12/(3*omega1^2*(omega1 + omega2)*(3*omega1 + omega2)) + (-3*omega1^3*delta22*eta12 +
/// 7*omega1^2*omega2*delta22*eta12 + 3*omega1*omega2^2*delta22*eta12 -
/// omega2^3*delta22*eta12)/(3*omega1*omega2*(omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 85 operations.
template <class Scalar>
Scalar lump_99(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar delta22 = parameters[9];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(3.0) * omega1 + omega2);
  const Scalar f_0 = alpha22 * eta12 * per_0 / (Scalar(3.0) * omega1_2 * omega2);
  const Scalar f_1 = Scalar(2.0) * delta22 * eta22 * per_1 * per_2 / Scalar(3.0);
  const Scalar f_2 = -alpha22 * eta22 * per_1 * per_2 / (Scalar(3.0) * omega1_2);
  const Scalar f_3 = -alpha22 * eta12 * per_1 * per_3 / (Scalar(3.0) * omega1_2);
  const Scalar f_4 = -omega1_2 * delta22 * eta12 * per_1 * per_0 * per_3 / omega2;
  const Scalar f_5 = Scalar(7.0) * omega1 * delta22 * eta12 * per_1 * per_0 * per_3 / Scalar(3.0);
  const Scalar f_6 = omega2 * delta22 * eta12 * per_1 * per_0 * per_3;
  const Scalar f_7 = -omega2_2 * delta22 * eta12 * per_1 * per_0 * per_3 / (Scalar(3.0) * omega1);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_4 + f_5 + f_6 + f_7) * per_0;
  const Scalar q_1 = (f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7) * per_1;
  const Scalar q_2 = (f_1 + f_2) * per_2;
  const Scalar q_3 = (f_3 + f_4 + f_5 + f_6 + f_7) * per_3;
  // by omega1
  gradient[0] = (-Scalar(2.0) * f_0 - Scalar(2.0) * f_2 - Scalar(2.0) * f_3 + Scalar(2.0) * f_4 + f_5
      - f_7) / omega1 - Scalar(2.0) * q_0 - q_1 - q_2 - Scalar(3.0) * q_3;
  gradient[1] = (-f_0 - f_4 + f_6 + Scalar(2.0) * f_7) / omega2 + q_0 - q_1 + q_2 - q_3;  // by omega2
  // multiplies alpha22*eta12
  const Scalar c_0 = per_0 / (Scalar(3.0) * omega1_2 * omega2) - per_1 * per_3 / (Scalar(3.0) * omega1_2);
  const Scalar c_1 = -per_1 * per_2 / (Scalar(3.0) * omega1_2);  // multiplies alpha22*eta22
  // multiplies delta22*eta12
  const Scalar c_2 = (-Scalar(3.0) * omega1_3 + Scalar(7.0) * omega1_2 * omega2 + Scalar(3.0) * omega1 * omega2_2
      - omega2_3) * per_1 * per_0 * per_3 / (Scalar(3.0) * omega1 * omega2);
  const Scalar c_3 = Scalar(2.0) * per_1 * per_2 / Scalar(3.0);  // multiplies delta22*eta22
  gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
  gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
  gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
  gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  return value;
}

/// harmonic_re_v1_A_v2_F = -delta23*eta21/(4*omega1*(omega1 + 2*omega2)) + (omega1*delta22*eta11 +
/// 2*omega2*delta22*eta11)/(4*omega2^2*(2*omega1 + omega2)) - alpha23*eta21/(4*omega1*omega2*(omega1 +
/// omega2)*(omega1 + 2*omega2)) - alpha22*eta11/(4*omega2^2*(omega1 + omega2)*(2*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 49 operations.
template <class Scalar>
Scalar lump_100(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar eta11 = parameters[20];
  const Scalar eta21 = parameters[29];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2);
  const Scalar f_0 = -delta23 * eta21 * per_0 / (Scalar(4.0) * omega1);
  const Scalar f_1 = omega1 * delta22 * eta11 * per_1 / (Scalar(4.0) * omega2_2);
  const Scalar f_2 = delta22 * eta11 * per_1 / (Scalar(2.0) * omega2);
  const Scalar f_3 = -alpha23 * eta21 * per_2 * per_0 / (Scalar(4.0) * omega1 * omega2);
  const Scalar f_4 = -alpha22 * eta11 * per_2 * per_1 / (Scalar(4.0) * omega2_2);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_3) * per_0;
  const Scalar q_1 = (f_1 + f_2 + f_4) * per_1;
  const Scalar q_2 = (f_3 + f_4) * per_2;
  gradient[0] = (-f_0 + f_1 - f_3) / omega1 - q_0 - Scalar(2.0) * q_1 - q_2;  // by omega1
  // by omega2
  gradient[1] = (-Scalar(2.0) * f_1 - f_2 - f_3 - Scalar(2.0) * f_4) / omega2 - Scalar(2.0) * q_0 - q_1 - q_2;
  const Scalar c_0 = -per_2 * per_1 / (Scalar(4.0) * omega2_2);  // multiplies alpha22*eta11
  const Scalar c_1 = -per_2 * per_0 / (Scalar(4.0) * omega1 * omega2);  // multiplies alpha23*eta21
  // multiplies delta22*eta11
  const Scalar c_2 = (omega1 + Scalar(2.0) * omega2) * per_1 / (Scalar(4.0) * omega2_2);
  const Scalar c_3 = -per_0 / (Scalar(4.0) * omega1);  // multiplies delta23*eta21
  gradient[6] = eta11 * c_0;  // by alpha22
  gradient[7] = eta21 * c_1;  // by alpha23
  gradient[9] = eta11 * c_2;  // by delta22
  gradient[10] = eta21 * c_3;  // by delta23
  gradient[20] = alpha22 * c_0 + delta22 * c_2;  // by eta11
  gradient[29] = alpha23 * c_1 + delta23 * c_3;  // by eta21
  return value;
}

/// harmonic_im_v1_A_v2_F = (-omega1*mu12*eta22 - 2*omega2*mu12*eta22)/(8*omega2*(omega1 + omega2)^2*(omega1 +
/// 3*omega2)) + mu12*eta12/(8*(omega1 + omega2)^2*(omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 30 operations.
template <class Scalar>
Scalar lump_101(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu12 = parameters[3];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(3.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -omega1 * mu12 * eta22 * per_0_2 * per_1 / (Scalar(8.0) * omega2);
  const Scalar f_1 = -mu12 * eta22 * per_0_2 * per_1 / Scalar(4.0);
  const Scalar f_2 = mu12 * eta12 * per_0_2 * per_2 / Scalar(8.0);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (Scalar(2.0) * f_0 + Scalar(2.0) * f_1 + Scalar(2.0) * f_2) * per_0;
  const Scalar q_1 = (f_0 + f_1) * per_1;
  const Scalar q_2 = f_2 * per_2;
  gradient[0] = f_0 / omega1 - q_0 - q_1 - q_2;  // by omega1
  gradient[1] = -f_0 / omega2 - q_0 - Scalar(3.0) * q_1 + q_2;  // by omega2
  const Scalar c_0 = per_0_2 * per_2 / Scalar(8.0);  // multiplies mu12*eta12
  // multiplies mu12*eta22
  const Scalar c_1 = (-omega1 - Scalar(2.0) * omega2) * per_0_2 * per_1 / (Scalar(8.0) * omega2);
  gradient[3] = eta12 * c_0 + eta22 * c_1;  // by mu12
  gradient[21] = mu12 * c_0;  // by eta12
  gradient[30] = mu12 * c_1;  // by eta22
  return value;
}

/// harmonic_re_v1_A_v1_A_v2_F = 2*omega1*delta22*eta22/((omega1 + 2*omega2)*(omega1 + 3*omega2)*(3*omega1 +
/// 2*omega2)) - alpha22*eta22/((omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(3*omega1 + 2*omega2))
/// + (3*omega1^3*delta22*eta12 + 12*omega1^2*omega2*delta22*eta12 + 9*omega1*omega2^2*delta22*eta12 +
/// 2*omega2^3*delta22*eta12)/(omega2*(omega1 + 2*omega2)*(2*omega1 + omega2)*(3*omega1 + omega2)*(3*omega1 +
/// 2*omega2)) + (-3*omega1^2*alpha22*eta12 - 6*omega1*omega2*alpha22*eta12 -
/// 2*omega2^2*alpha22*eta12)/(omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(2*omega1 + omega2)*(3*omega1 +
/// omega2)*(3*omega1 + 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 118 operations.
template <class Scalar>
Scalar lump_102(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar delta22 = parameters[9];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(3.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(3.0) * omega1 + Scalar(2.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_4 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_5 = Scalar(1.0) / (Scalar(3.0) * omega1 + omega2);
  const Scalar f_0 = Scalar(2.0) * omega1 * delta22 * eta22 * per_0 * per_1 * per_2;
  const Scalar f_1 = -alpha22 * eta22 * per_3 * per_0 * per_1 * per_2;
  const Scalar f_2 = Scalar(3.0) * omega1_3 * delta22 * eta12 * per_0 * per_4 * per_5 * per_2 / omega2;
  const Scalar f_3 = Scalar(12.0) * omega1_2 * delta22 * eta12 * per_0 * per_4 * per_5 * per_2;
  const Scalar f_4 = Scalar(9.0) * omega1 * omega2 * delta22 * eta12 * per_0 * per_4 * per_5 * per_2;
  const Scalar f_5 = Scalar(2.0) * omega2_2 * delta22 * eta12 * per_0 * per_4 * per_5 * per_2;
  const Scalar f_6 = -Scalar(3.0) * omega1_2 * alpha22 * eta12 * per_3 * per_0 * per_4 * per_5 * per_2 / omega2;
  const Scalar f_7 = -Scalar(6.0) * omega1 * alpha22 * eta12 * per_3 * per_0 * per_4 * per_5 * per_2;
  const Scalar f_8 = -Scalar(2.0) * omega2 * alpha22 * eta12 * per_3 * per_0 * per_4 * per_5 * per_2;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_0;
  const Scalar q_1 = (f_0 + f_1) * per_1;
  const Scalar q_2 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_2;
  const Scalar q_3 = (f_1 + f_6 + f_7 + f_8) * per_3;
  const Scalar q_4 = (f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_4;
  const Scalar q_5 = (f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_5;
  // by omega1
  gradient[0] = (f_0 + Scalar(3.0) * f_2 + Scalar(2.0) * f_3 + f_4 + Scalar(2.0) * f_6 + f_7) / omega1 - q_0 - q_1
      - Scalar(3.0) * q_2 - q_3 - Scalar(2.0) * q_4 - Scalar(3.0) * q_5;
  // by omega2
  gradient[1] = (-f_2 + f_4 + Scalar(2.0) * f_5 - f_6 + f_8) / omega2 - Scalar(2.0) * q_0 - Scalar(3.0) * q_1
      - Scalar(2.0) * q_2 - q_3 - q_4 - q_5;
  // multiplies alpha22*eta12
  const Scalar c_0 = (-Scalar(3.0) * omega1_2 - Scalar(6.0) * omega1 * omega2
      - Scalar(2.0) * omega2_2) * per_3 * per_0 * per_4 * per_5 * per_2 / omega2;
  const Scalar c_1 = -per_3 * per_0 * per_1 * per_2;  // multiplies alpha22*eta22
  // multiplies delta22*eta12
  const Scalar c_2 = (Scalar(3.0) * omega1_3 + Scalar(12.0) * omega1_2 * omega2 + Scalar(9.0) * omega1 * omega2_2
      + Scalar(2.0) * omega2_3) * per_0 * per_4 * per_5 * per_2 / omega2;
  const Scalar c_3 = Scalar(2.0) * omega1 * per_0 * per_1 * per_2;  // multiplies delta22*eta22
  gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
  gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
  gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
  gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  return value;
}

/// harmonic_re_v1_A_v12_F = (51*omega1^4*delta21*eta12 + 42*omega1^3*omega2*delta21*eta12 +
/// 9*omega1^2*omega2^2*delta21*eta12 - 9*omega1^2*alpha21*eta12 - 4*omega1*omega2*alpha21*eta12 -
/// omega2^2*alpha21*eta12)/(6*omega1^2*(omega1 + omega2)*(2*omega1 + omega2)*(3*omega1 + omega2)*(4*omega1 +
/// omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 81 operations.
template <class Scalar>
Scalar lump_103(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar delta21 = parameters[8];
  const Scalar eta12 = parameters[21];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(3.0) * omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(4.0) * omega1 + omega2);
  const Scalar f_0 = Scalar(17.0) * omega1_2 * delta21 * eta12 * per_0 * per_1 * per_2 * per_3 / Scalar(2.0);
  const Scalar f_1 = Scalar(7.0) * omega1 * omega2 * delta21 * eta12 * per_0 * per_1 * per_2 * per_3;
  const Scalar f_2 = Scalar(3.0) * omega2_2 * delta21 * eta12 * per_0 * per_1 * per_2 * per_3 / Scalar(2.0);
  const Scalar f_3 = -Scalar(3.0) * alpha21 * eta12 * per_0 * per_1 * per_2 * per_3 / Scalar(2.0);
  const Scalar f_4 = -Scalar(2.0) * omega2 * alpha21 * eta12 * per_0 * per_1 * per_2 * per_3 / (Scalar(3.0)
      * omega1);
  const Scalar f_5 = -omega2_2 * alpha21 * eta12 * per_0 * per_1 * per_2 * per_3 / (Scalar(6.0) * omega1_2);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_1;
  const Scalar q_2 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_2;
  const Scalar q_3 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_3;
  // by omega1
  gradient[0] = (Scalar(2.0) * f_0 + f_1 - f_4 - Scalar(2.0) * f_5) / omega1 - q_0 - Scalar(2.0) * q_1
      - Scalar(3.0) * q_2 - Scalar(4.0) * q_3;
  gradient[1] = (f_1 + Scalar(2.0) * f_2 + f_4 + Scalar(2.0) * f_5) / omega2 - q_0 - q_1 - q_2 - q_3;  // by omega2
  // multiplies alpha21*eta12
  const Scalar c_0 = (-Scalar(9.0) * omega1_2 - Scalar(4.0) * omega1 * omega2
      - omega2_2) * per_0 * per_1 * per_2 * per_3 / (Scalar(6.0) * omega1_2);
  // multiplies delta21*eta12
  const Scalar c_1 = (Scalar(17.0) * omega1_2 + Scalar(14.0) * omega1 * omega2
      + Scalar(3.0) * omega2_2) * per_0 * per_1 * per_2 * per_3 / Scalar(2.0);
  gradient[5] = eta12 * c_0;  // by alpha21
  gradient[8] = eta12 * c_1;  // by delta21
  gradient[21] = alpha21 * c_0 + delta21 * c_1;  // by eta12
  return value;
}

/// harmonic_re_v2_conjA_v12_F = (-omega1*omega2*delta22*eta12 + alpha22*eta12)/(omega1*(omega1 + omega2)*(omega1
/// - omega2)*(omega1 - 2*omega2)) + (-omega1^2*delta22*eta22 - alpha22*eta22)/(2*omega1*(omega1 -
/// 2*omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 51 operations.
template <class Scalar>
Scalar lump_104(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar delta22 = parameters[9];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_4 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = -omega2 * delta22 * eta12 * per_0 * per_1 * per_2;
  const Scalar f_1 = alpha22 * eta12 * per_0 * per_1 * per_2 / omega1;
  const Scalar f_2 = -omega1 * delta22 * eta22 * per_2 * per_3 * per_4 / Scalar(2.0);
  const Scalar f_3 = -alpha22 * eta22 * per_2 * per_3 * per_4 / (Scalar(2.0) * omega1);
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1) * per_0;
  const Scalar q_1 = (f_0 + f_1) * per_1;
  const Scalar q_2 = (f_0 + f_1 + f_2 + f_3) * per_2;
  const Scalar q_3 = (f_2 + f_3) * per_3;
  const Scalar q_4 = (f_2 + f_3) * per_4;
  gradient[0] = (-f_1 + f_2 - f_3) / omega1 - q_0 - q_1 - q_2 - Scalar(2.0) * q_3 - Scalar(2.0) * q_4;  // by omega1
  gradient[1] = f_0 / omega2 - q_0 + q_1 + Scalar(2.0) * q_2 - q_3 + q_4;  // by omega2
  const Scalar c_0 = per_0 * per_1 * per_2 / omega1;  // multiplies alpha22*eta12
  const Scalar c_1 = -per_2 * per_3 * per_4 / (Scalar(2.0) * omega1);  // multiplies alpha22*eta22
  const Scalar c_2 = -omega2 * per_0 * per_1 * per_2;  // multiplies delta22*eta12
  const Scalar c_3 = -omega1 * per_2 * per_3 * per_4 / Scalar(2.0);  // multiplies delta22*eta22
  gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
  gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
  gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
  gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  return value;
}

/// harmonic_re_v2_A_v22_F = (9*omega1^2*omega2^2*delta24*eta22 - omega1^2*alpha24*eta22 -
/// 6*omega1*omega2^3*delta24*eta22 + 3*omega2^4*delta24*eta22 -
/// 5*omega2^2*alpha24*eta22)/(6*omega1*omega2^2*(omega1 + omega2)*(omega1 - omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 58 operations.
template <class Scalar>
Scalar lump_105(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = Scalar(3.0) * omega1 * delta24 * eta22 * per_0 * per_1 * per_2 / Scalar(2.0);
  const Scalar f_1 = -omega1 * alpha24 * eta22 * per_0 * per_1 * per_2 / (Scalar(6.0) * omega2_2);
  const Scalar f_2 = -omega2 * delta24 * eta22 * per_0 * per_1 * per_2;
  const Scalar f_3 = omega2_2 * delta24 * eta22 * per_0 * per_1 * per_2 / (Scalar(2.0) * omega1);
  const Scalar f_4 = -Scalar(5.0) * alpha24 * eta22 * per_0 * per_1 * per_2 / (Scalar(6.0) * omega1);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_1;
  const Scalar q_2 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_2;
  gradient[0] = (f_0 + f_1 - f_3 - f_4) / omega1 - q_0 - q_1 - q_2;  // by omega1
  // by omega2
  gradient[1] = (-Scalar(2.0) * f_1 + f_2 + Scalar(2.0) * f_3) / omega2 - q_0 + q_1 + Scalar(2.0) * q_2;
  // multiplies alpha24*eta22
  const Scalar c_0 = (-omega1_2
      - Scalar(5.0) * omega2_2) * per_0 * per_1 * per_2 / (Scalar(6.0) * omega1 * omega2_2);
  // multiplies delta24*eta22
  const Scalar c_1 = (Scalar(3.0) * omega1_2 - Scalar(2.0) * omega1 * omega2
      + omega2_2) * per_0 * per_1 * per_2 / (Scalar(2.0) * omega1);
  gradient[25] = eta22 * c_0;  // by alpha24
  gradient[26] = eta22 * c_1;  // by delta24
  gradient[30] = alpha24 * c_0 + delta24 * c_1;  // by eta22
  return value;
}

/// harmonic_re_v2_conjA_v2_F = (omega1^2*delta24*eta21 + omega1*omega2*delta24*eta21 + omega2^2*delta24*eta21 -
/// alpha24*eta21)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)) +
/// (-omega1*omega2*delta23*eta11 - alpha23*eta11)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 +
/// omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 59 operations.
template <class Scalar>
Scalar lump_106(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha23 = parameters[7];
  const Scalar delta23 = parameters[10];
  const Scalar eta11 = parameters[20];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar eta21 = parameters[29];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar f_0 = omega1 * delta24 * eta21 * per_0 * per_1 * per_2;
  const Scalar f_1 = omega2 * delta24 * eta21 * per_0 * per_1 * per_2;
  const Scalar f_2 = omega2_2 * delta24 * eta21 * per_0 * per_1 * per_2 / omega1;
  const Scalar f_3 = -alpha24 * eta21 * per_0 * per_1 * per_2 / omega1;
  const Scalar f_4 = -omega1 * delta23 * eta11 * per_0 * per_2 * per_3;
  const Scalar f_5 = -alpha23 * eta11 * per_0 * per_2 * per_3 / omega2;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3) * per_1;
  const Scalar q_2 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_2;
  const Scalar q_3 = (f_4 + f_5) * per_3;
  gradient[0] = (f_0 - f_2 - f_3 + f_4) / omega1 - q_0 - q_1 - q_2 - Scalar(2.0) * q_3;  // by omega1
  gradient[1] = (f_1 + Scalar(2.0) * f_2 - f_5) / omega2 - q_0 - Scalar(2.0) * q_1 + q_2 - q_3;  // by omega2
  const Scalar c_0 = -per_0 * per_2 * per_3 / omega2;  // multiplies alpha23*eta11
  const Scalar c_1 = -omega1 * per_0 * per_2 * per_3;  // multiplies delta23*eta11
  const Scalar c_2 = -per_0 * per_1 * per_2 / omega1;  // multiplies alpha24*eta21
  // multiplies delta24*eta21
  const Scalar c_3 = (omega1_2 + omega1 * omega2 + omega2_2) * per_0 * per_1 * per_2 / omega1;
  gradient[7] = eta11 * c_0;  // by alpha23
  gradient[10] = eta11 * c_1;  // by delta23
  gradient[20] = alpha23 * c_0 + delta23 * c_1;  // by eta11
  gradient[25] = eta21 * c_2;  // by alpha24
  gradient[26] = eta21 * c_3;  // by delta24
  gradient[29] = alpha24 * c_2 + delta24 * c_3;  // by eta21
  return value;
}

/// harmonic_re_v2_conjA_v1_conjA_v2_F = (-omega1*omega2*delta23*eta22 - omega2^2*delta23*eta22 +
/// alpha23*eta22)/(omega1*omega2^2*(omega1 + 2*omega2)) + (-alpha23*eta12 + alpha23*eta22)/(omega2^2*(omega1 +
/// omega2)*(omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 37 operations.
template <class Scalar>
Scalar lump_107(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha23 = parameters[7];
  const Scalar delta23 = parameters[10];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -delta23 * eta22 * per_0 / omega2;
  const Scalar f_1 = -delta23 * eta22 * per_0 / omega1;
  const Scalar f_2 = alpha23 * eta22 * per_0 / (omega1 * omega2_2);
  const Scalar f_3 = (-alpha23 * eta12 + alpha23 * eta22) * per_1 * per_2 / omega2_2;
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2) * per_0;
  const Scalar q_1 = f_3 * per_1;
  const Scalar q_2 = f_3 * per_2;
  gradient[0] = (-f_1 - f_2) / omega1 - q_0 - q_1 - q_2;  // by omega1
  // by omega2
  gradient[1] = (-f_0 - Scalar(2.0) * f_2 - Scalar(2.0) * f_3) / omega2 - Scalar(2.0) * q_0 - q_1 + q_2;
  const Scalar c_0 = -per_1 * per_2 / omega2_2;  // multiplies alpha23*eta12
  const Scalar c_1 = per_0 / (omega1 * omega2_2) + per_1 * per_2 / omega2_2;  // multiplies alpha23*eta22
  const Scalar c_2 = (-omega1 - omega2) * per_0 / (omega1 * omega2);  // multiplies delta23*eta22
  gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
  gradient[10] = eta22 * c_2;  // by delta23
  gradient[21] = alpha23 * c_0;  // by eta12
  gradient[30] = alpha23 * c_1 + delta23 * c_2;  // by eta22
  return value;
}

/// harmonic_re_v2_F2 = -eta21*eta22/(2*omega1*omega2^2*(omega1 + 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 12 operations.
template <class Scalar>
Scalar lump_108(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar eta21 = parameters[29];
  const Scalar eta22 = parameters[30];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar f_0 = -eta21 * eta22 * per_0 / (Scalar(2.0) * omega1 * omega2_2);
  const Scalar value = f_0;
  if (gradient == nullptr) return value;
  const Scalar q_0 = f_0 * per_0;
  gradient[0] = -f_0 / omega1 - q_0;  // by omega1
  gradient[1] = -Scalar(2.0) * f_0 / omega2 - Scalar(2.0) * q_0;  // by omega2
  const Scalar c_0 = -per_0 / (Scalar(2.0) * omega1 * omega2_2);  // multiplies eta21*eta22
  gradient[29] = eta22 * c_0;  // by eta21
  gradient[30] = eta21 * c_0;  // by eta22
  return value;
}

/// harmonic_im_v2_F = (-omega1*eta11*mu21 - omega2*eta11*mu21)/(2*omega1*omega2*(omega1 + 2*omega2)*(2*omega1 +
/// omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 22 operations.
template <class Scalar>
Scalar lump_109(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar eta11 = parameters[20];
  const Scalar mu21 = parameters[23];
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar f_0 = -eta11 * mu21 * per_0 * per_1 / (Scalar(2.0) * omega2);
  const Scalar f_1 = -eta11 * mu21 * per_0 * per_1 / (Scalar(2.0) * omega1);
  const Scalar value = f_0 + f_1;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1) * per_0;
  const Scalar q_1 = (f_0 + f_1) * per_1;
  gradient[0] = -f_1 / omega1 - q_0 - Scalar(2.0) * q_1;  // by omega1
  gradient[1] = -f_0 / omega2 - Scalar(2.0) * q_0 - q_1;  // by omega2
  const Scalar c_0 = (-omega1 - omega2) * per_0 * per_1 / (Scalar(2.0) * omega1 * omega2);  // multiplies eta11*mu21
  gradient[20] = mu21 * c_0;  // by eta11
  gradient[23] = eta11 * c_0;  // by mu21
  return value;
}

/// harmonic_re_v2_A_v2_conjA_v2_F = (omega1^2*omega2^2*delta24*eta22 + omega1^2*alpha24*eta22 +
/// 2*omega1*omega2^3*delta24*eta22 + 2*omega1*omega2*alpha24*eta22 + 3*omega2^4*delta24*eta22 -
/// 5*omega2^2*alpha24*eta22)/(omega1*omega2^2*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 63 operations.
template <class Scalar>
Scalar lump_110(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(3.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = omega1 * delta24 * eta22 * per_0 * per_1 * per_2;
  const Scalar f_1 = omega1 * alpha24 * eta22 * per_0 * per_1 * per_2 / omega2_2;
  const Scalar f_2 = Scalar(2.0) * omega2 * delta24 * eta22 * per_0 * per_1 * per_2;
  const Scalar f_3 = Scalar(2.0) * alpha24 * eta22 * per_0 * per_1 * per_2 / omega2;
  const Scalar f_4 = Scalar(3.0) * omega2_2 * delta24 * eta22 * per_0 * per_1 * per_2 / omega1;
  const Scalar f_5 = -Scalar(5.0) * alpha24 * eta22 * per_0 * per_1 * per_2 / omega1;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_1;
  const Scalar q_2 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_2;
  gradient[0] = (f_0 + f_1 - f_4 - f_5) / omega1 - q_0 - q_1 - q_2;  // by omega1
  // by omega2
  gradient[1] = (-Scalar(2.0) * f_1 + f_2 - f_3 + Scalar(2.0) * f_4) / omega2 - Scalar(2.0) * q_0
      - Scalar(3.0) * q_1 + q_2;
  // multiplies alpha24*eta22
  const Scalar c_0 = (omega1_2 + Scalar(2.0) * omega1 * omega2
      - Scalar(5.0) * omega2_2) * per_0 * per_1 * per_2 / (omega1 * omega2_2);
  // multiplies delta24*eta22
  const Scalar c_1 = (omega1_2 + Scalar(2.0) * omega1 * omega2
      + Scalar(3.0) * omega2_2) * per_0 * per_1 * per_2 / omega1;
  gradient[25] = eta22 * c_0;  // by alpha24
  gradient[26] = eta22 * c_1;  // by delta24
  gradient[30] = alpha24 * c_0 + delta24 * c_1;  // by eta22
  return value;
}

/// harmonic_re_v2_A_v1_conjA_v1_F = (-omega1^2*delta22*eta22 + alpha22*eta22)/(omega1*omega2^2*(omega1 +
/// 2*omega2)) + (2*omega1^2*delta22*eta12 + 2*alpha22*eta12)/(omega1*(omega1 + 2*omega2)*(omega1 -
/// omega2)*(3*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 41 operations.
template <class Scalar>
Scalar lump_111(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar delta22 = parameters[9];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(3.0) * omega1 + omega2);
  const Scalar f_0 = -omega1 * delta22 * eta22 * per_0 / omega2_2;
  const Scalar f_1 = alpha22 * eta22 * per_0 / (omega1 * omega2_2);
  const Scalar f_2 = Scalar(2.0) * omega1 * delta22 * eta12 * per_0 * per_1 * per_2;
  const Scalar f_3 = Scalar(2.0) * alpha22 * eta12 * per_0 * per_1 * per_2 / omega1;
  const Scalar value = f_0 + f_1 + f_2 + f_3;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
  const Scalar q_1 = (f_2 + f_3) * per_1;
  const Scalar q_2 = (f_2 + f_3) * per_2;
  gradient[0] = (f_0 - f_1 + f_2 - f_3) / omega1 - q_0 - q_1 - Scalar(3.0) * q_2;  // by omega1
  gradient[1] = (-Scalar(2.0) * f_0 - Scalar(2.0) * f_1) / omega2 - Scalar(2.0) * q_0 + q_1 - q_2;  // by omega2
  const Scalar c_0 = Scalar(2.0) * per_0 * per_1 * per_2 / omega1;  // multiplies alpha22*eta12
  const Scalar c_1 = per_0 / (omega1 * omega2_2);  // multiplies alpha22*eta22
  const Scalar c_2 = Scalar(2.0) * omega1 * per_0 * per_1 * per_2;  // multiplies delta22*eta12
  const Scalar c_3 = -omega1 * per_0 / omega2_2;  // multiplies delta22*eta22
  gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
  gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
  gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
  gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  return value;
}

/// harmonic_re_v2_A_v2_F = (omega1^2*delta24*eta21 + 3*omega1*omega2*delta24*eta21 + 3*omega2^2*delta24*eta21 -
/// alpha24*eta21)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)) +
/// (omega1*omega2*delta23*eta11 + 2*omega2^2*delta23*eta11 - alpha23*eta11)/(omega2*(omega1 + omega2)*(omega1 +
/// 3*omega2)*(2*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 72 operations.
template <class Scalar>
Scalar lump_112(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha23 = parameters[7];
  const Scalar delta23 = parameters[10];
  const Scalar eta11 = parameters[20];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar eta21 = parameters[29];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + Scalar(3.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar f_0 = omega1 * delta24 * eta21 * per_0 * per_1 * per_2;
  const Scalar f_1 = Scalar(3.0) * omega2 * delta24 * eta21 * per_0 * per_1 * per_2;
  const Scalar f_2 = Scalar(3.0) * omega2_2 * delta24 * eta21 * per_0 * per_1 * per_2 / omega1;
  const Scalar f_3 = -alpha24 * eta21 * per_0 * per_1 * per_2 / omega1;
  const Scalar f_4 = omega1 * delta23 * eta11 * per_0 * per_2 * per_3;
  const Scalar f_5 = Scalar(2.0) * omega2 * delta23 * eta11 * per_0 * per_2 * per_3;
  const Scalar f_6 = -alpha23 * eta11 * per_0 * per_2 * per_3 / omega2;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3) * per_1;
  const Scalar q_2 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_2;
  const Scalar q_3 = (f_4 + f_5 + f_6) * per_3;
  gradient[0] = (f_0 - f_2 - f_3 + f_4) / omega1 - q_0 - q_1 - q_2 - Scalar(2.0) * q_3;  // by omega1
  // by omega2
  gradient[1] = (f_1 + Scalar(2.0) * f_2 + f_5 - f_6) / omega2 - q_0 - Scalar(2.0) * q_1 - Scalar(3.0) * q_2 - q_3;
  const Scalar c_0 = -per_0 * per_2 * per_3 / omega2;  // multiplies alpha23*eta11
  const Scalar c_1 = (omega1 + Scalar(2.0) * omega2) * per_0 * per_2 * per_3;  // multiplies delta23*eta11
  const Scalar c_2 = -per_0 * per_1 * per_2 / omega1;  // multiplies alpha24*eta21
  // multiplies delta24*eta21
  const Scalar c_3 = (omega1_2 + Scalar(3.0) * omega1 * omega2
      + Scalar(3.0) * omega2_2) * per_0 * per_1 * per_2 / omega1;
  gradient[7] = eta11 * c_0;  // by alpha23
  gradient[10] = eta11 * c_1;  // by delta23
  gradient[20] = alpha23 * c_0 + delta23 * c_1;  // by eta11
  gradient[25] = eta21 * c_2;  // by alpha24
  gradient[26] = eta21 * c_3;  // by delta24
  gradient[29] = alpha24 * c_2 + delta24 * c_3;  // by eta21
  return value;
}

/// harmonic_re_v2_A_v2_conjA_v1_F = -alpha23*eta22/(3*omega1*omega2^2*(omega1 - 2*omega2)) -
/// alpha23*eta22/(3*omega2^2*(omega1 + omega2)*(omega1 + 3*omega2)) + (-2*omega2^2*delta23*eta12 +
/// alpha23*eta12)/(3*omega2^2*(omega1 + omega2)*(omega1 - omega2)) + (omega1^3*delta23*eta22 -
/// 3*omega1^2*omega2*delta23*eta22 - 7*omega1*omega2^2*delta23*eta22 +
/// 3*omega2^3*delta23*eta22)/(3*omega1*omega2*(omega1 + omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 85 operations.
template <class Scalar>
Scalar lump_113(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha23 = parameters[7];
  const Scalar delta23 = parameters[10];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + Scalar(3.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 - omega2);
  const Scalar f_0 = -alpha23 * eta22 * per_0 / (Scalar(3.0) * omega1 * omega2_2);
  const Scalar f_1 = -alpha23 * eta22 * per_1 * per_2 / (Scalar(3.0) * omega2_2);
  const Scalar f_2 = -Scalar(2.0) * delta23 * eta12 * per_1 * per_3 / Scalar(3.0);
  const Scalar f_3 = alpha23 * eta12 * per_1 * per_3 / (Scalar(3.0) * omega2_2);
  const Scalar f_4 = omega1_2 * delta23 * eta22 * per_1 * per_2 * per_0 / (Scalar(3.0) * omega2);
  const Scalar f_5 = -omega1 * delta23 * eta22 * per_1 * per_2 * per_0;
  const Scalar f_6 = -Scalar(7.0) * omega2 * delta23 * eta22 * per_1 * per_2 * per_0 / Scalar(3.0);
  const Scalar f_7 = omega2_2 * delta23 * eta22 * per_1 * per_2 * per_0 / omega1;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_4 + f_5 + f_6 + f_7) * per_0;
  const Scalar q_1 = (f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7) * per_1;
  const Scalar q_2 = (f_1 + f_4 + f_5 + f_6 + f_7) * per_2;
  const Scalar q_3 = (f_2 + f_3) * per_3;
  gradient[0] = (-f_0 + Scalar(2.0) * f_4 + f_5 - f_7) / omega1 - q_0 - q_1 - q_2 - q_3;  // by omega1
  // by omega2
  gradient[1] = (-Scalar(2.0) * f_0 - Scalar(2.0) * f_1 - Scalar(2.0) * f_3 - f_4 + f_6
      + Scalar(2.0) * f_7) / omega2 + Scalar(2.0) * q_0 - q_1 - Scalar(3.0) * q_2 + q_3;
  const Scalar c_0 = per_1 * per_3 / (Scalar(3.0) * omega2_2);  // multiplies alpha23*eta12
  // multiplies alpha23*eta22
  const Scalar c_1 = -per_0 / (Scalar(3.0) * omega1 * omega2_2) - per_1 * per_2 / (Scalar(3.0) * omega2_2);
  const Scalar c_2 = -Scalar(2.0) * per_1 * per_3 / Scalar(3.0);  // multiplies delta23*eta12
  // multiplies delta23*eta22
  const Scalar c_3 = (omega1_3 - Scalar(3.0) * omega1_2 * omega2 - Scalar(7.0) * omega1 * omega2_2
      + Scalar(3.0) * omega2_3) * per_1 * per_2 * per_0 / (Scalar(3.0) * omega1 * omega2);
  gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
  gradient[10] = eta12 * c_2 + eta22 * c_3;  // by delta23
  gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
  gradient[30] = alpha23 * c_1 + delta23 * c_3;  // by eta22
  return value;
}

/// harmonic_re_v2_A_v1_conjA_v2_F = (-2*omega1*omega2*delta23*eta12 - alpha23*eta12)/((omega1 +
/// omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2)) + (2*omega1^4*delta23*eta22 -
/// 5*omega1^3*omega2*delta23*eta22 + omega1^2*omega2^2*delta23*eta22 - 2*omega1^2*alpha23*eta22 +
/// omega1*omega2^3*delta23*eta22 + 2*omega1*omega2*alpha23*eta22 - omega2^4*delta23*eta22 +
/// omega2^2*alpha23*eta22)/(omega1*(omega1 + omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(2*omega1 +
/// omega2)*(2*omega1 - omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 129 operations.
template <class Scalar>
Scalar lump_114(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha23 = parameters[7];
  const Scalar delta23 = parameters[10];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(3.0) * omega1 + omega2);
  const Scalar per_4 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_5 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  const Scalar f_0 = -Scalar(2.0) * omega1 * omega2 * delta23 * eta12 * per_0 * per_1 * per_2 * per_3;
  const Scalar f_1 = -alpha23 * eta12 * per_0 * per_1 * per_2 * per_3;
  const Scalar f_2 = Scalar(2.0) * omega1_3 * delta23 * eta22 * per_0 * per_4 * per_5 * per_1 * per_2;
  const Scalar f_3 = -Scalar(5.0) * omega1_2 * omega2 * delta23 * eta22 * per_0 * per_4 * per_5 * per_1 * per_2;
  const Scalar f_4 = omega1 * omega2_2 * delta23 * eta22 * per_0 * per_4 * per_5 * per_1 * per_2;
  const Scalar f_5 = -Scalar(2.0) * omega1 * alpha23 * eta22 * per_0 * per_4 * per_5 * per_1 * per_2;
  const Scalar f_6 = omega2_3 * delta23 * eta22 * per_0 * per_4 * per_5 * per_1 * per_2;
  const Scalar f_7 = Scalar(2.0) * omega2 * alpha23 * eta22 * per_0 * per_4 * per_5 * per_1 * per_2;
  const Scalar f_8 = -omega2_4 * delta23 * eta22 * per_0 * per_4 * per_5 * per_1 * per_2 / omega1;
  const Scalar f_9 = omega2_2 * alpha23 * eta22 * per_0 * per_4 * per_5 * per_1 * per_2 / omega1;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_1;
  const Scalar q_2 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_2;
  const Scalar q_3 = (f_0 + f_1) * per_3;
  const Scalar q_4 = (f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_4;
  const Scalar q_5 = (f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_5;
  // by omega1
  gradient[0] = (f_0 + Scalar(3.0) * f_2 + Scalar(2.0) * f_3 + f_4 + f_5 - f_8 - f_9) / omega1 - q_0
      - Scalar(2.0) * q_1 - Scalar(2.0) * q_2 - Scalar(3.0) * q_3 - q_4 - q_5;
  // by omega2
  gradient[1] = (f_0 + f_3 + Scalar(2.0) * f_4 + Scalar(3.0) * f_6 + f_7 + Scalar(4.0) * f_8
      + Scalar(2.0) * f_9) / omega2 - q_0 - q_1 + q_2 - q_3 + q_4 + Scalar(2.0) * q_5;
  const Scalar c_0 = -per_0 * per_1 * per_2 * per_3;  // multiplies alpha23*eta12
  // multiplies alpha23*eta22
  const Scalar c_1 = (-Scalar(2.0) * omega1_2 + Scalar(2.0) * omega1 * omega2
      + omega2_2) * per_0 * per_4 * per_5 * per_1 * per_2 / omega1;
  const Scalar c_2 = -Scalar(2.0) * omega1 * omega2 * per_0 * per_1 * per_2 * per_3;  // multiplies delta23*eta12
  // multiplies delta23*eta22
  const Scalar c_3 = (Scalar(2.0) * omega1_4 - Scalar(5.0) * omega1_3 * omega2 + omega1_2 * omega2_2
      + omega1 * omega2_3 - omega2_4) * per_0 * per_4 * per_5 * per_1 * per_2 / omega1;
  gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
  gradient[10] = eta12 * c_2 + eta22 * c_3;  // by delta23
  gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
  gradient[30] = alpha23 * c_1 + delta23 * c_3;  // by eta22
  return value;
}

/// harmonic_re_v2_A_v1_F = (2*omega1*delta23*eta21 + omega2*delta23*eta21)/(4*omega1^2*(omega1 + 2*omega2)) -
/// delta22*eta11/(4*omega2*(2*omega1 + omega2)) - alpha23*eta21/(4*omega1^2*(omega1 + omega2)*(omega1 +
/// 2*omega2)) - alpha22*eta11/(4*omega1*omega2*(omega1 + omega2)*(2*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 49 operations.
template <class Scalar>
Scalar lump_115(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar eta11 = parameters[20];
  const Scalar eta21 = parameters[29];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_2 = Scalar(1.0) / (omega1 + omega2);
  const Scalar f_0 = delta23 * eta21 * per_0 / (Scalar(2.0) * omega1);
  const Scalar f_1 = omega2 * delta23 * eta21 * per_0 / (Scalar(4.0) * omega1_2);
  const Scalar f_2 = -delta22 * eta11 * per_1 / (Scalar(4.0) * omega2);
  const Scalar f_3 = -alpha23 * eta21 * per_2 * per_0 / (Scalar(4.0) * omega1_2);
  const Scalar f_4 = -alpha22 * eta11 * per_2 * per_1 / (Scalar(4.0) * omega1 * omega2);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_3) * per_0;
  const Scalar q_1 = (f_2 + f_4) * per_1;
  const Scalar q_2 = (f_3 + f_4) * per_2;
  // by omega1
  gradient[0] = (-f_0 - Scalar(2.0) * f_1 - Scalar(2.0) * f_3 - f_4) / omega1 - q_0 - Scalar(2.0) * q_1 - q_2;
  gradient[1] = (f_1 - f_2 - f_4) / omega2 - Scalar(2.0) * q_0 - q_1 - q_2;  // by omega2
  const Scalar c_0 = -per_2 * per_1 / (Scalar(4.0) * omega1 * omega2);  // multiplies alpha22*eta11
  const Scalar c_1 = -per_2 * per_0 / (Scalar(4.0) * omega1_2);  // multiplies alpha23*eta21
  const Scalar c_2 = -per_1 / (Scalar(4.0) * omega2);  // multiplies delta22*eta11
  // multiplies delta23*eta21
  const Scalar c_3 = (Scalar(2.0) * omega1 + omega2) * per_0 / (Scalar(4.0) * omega1_2);
  gradient[6] = eta11 * c_0;  // by alpha22
  gradient[7] = eta21 * c_1;  // by alpha23
  gradient[9] = eta11 * c_2;  // by delta22
  gradient[10] = eta21 * c_3;  // by delta23
  gradient[20] = alpha22 * c_0 + delta22 * c_2;  // by eta11
  gradient[29] = alpha23 * c_1 + delta23 * c_3;  // by eta21
  return value;
}

/// harmonic_im_v2_A_v1_F = -mu21*eta22/(8*(omega1 + omega2)^2*(omega1 - omega2)) + (-2*omega1*eta12*mu21 -
/// omega2*eta12*mu21)/(8*omega1*(omega1 + omega2)^2*(3*omega1 + omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 30 operations.
template <class Scalar>
Scalar lump_116(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar eta12 = parameters[21];
  const Scalar mu21 = parameters[23];
  const Scalar eta22 = parameters[30];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(3.0) * omega1 + omega2);
  const Scalar f_0 = -mu21 * eta22 * per_0_2 * per_1 / Scalar(8.0);
  const Scalar f_1 = -eta12 * mu21 * per_0_2 * per_2 / Scalar(4.0);
  const Scalar f_2 = -omega2 * eta12 * mu21 * per_0_2 * per_2 / (Scalar(8.0) * omega1);
  const Scalar value = f_0 + f_1 + f_2;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (Scalar(2.0) * f_0 + Scalar(2.0) * f_1 + Scalar(2.0) * f_2) * per_0;
  const Scalar q_1 = f_0 * per_1;
  const Scalar q_2 = (f_1 + f_2) * per_2;
  gradient[0] = -f_2 / omega1 - q_0 - q_1 - Scalar(3.0) * q_2;  // by omega1
  gradient[1] = f_2 / omega2 - q_0 + q_1 - q_2;  // by omega2
  // multiplies eta12*mu21
  const Scalar c_0 = (-Scalar(2.0) * omega1 - omega2) * per_0_2 * per_2 / (Scalar(8.0) * omega1);
  const Scalar c_1 = -per_0_2 * per_1 / Scalar(8.0);  // multiplies mu21*eta22
  gradient[21] = mu21 * c_0;  // by eta12
  gradient[23] = eta12 * c_0 + eta22 * c_1;  // by mu21
  gradient[30] = mu21 * c_1;  // by eta22
  return value;
}

/// harmonic_re_v2_A_v1_A_v2_F = 2*omega2*delta23*eta12/((2*omega1 + omega2)*(2*omega1 + 3*omega2)*(3*omega1 +
/// omega2)) - alpha23*eta12/((omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 + 3*omega2)*(3*omega1 + omega2)) +
/// (2*omega1^3*delta23*eta22 + 9*omega1^2*omega2*delta23*eta22 + 12*omega1*omega2^2*delta23*eta22 +
/// 3*omega2^3*delta23*eta22)/(omega1*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(2*omega1 + omega2)*(2*omega1 +
/// 3*omega2)) + (-2*omega1^2*alpha23*eta22 - 6*omega1*omega2*alpha23*eta22 -
/// 3*omega2^2*alpha23*eta22)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(2*omega1 +
/// omega2)*(2*omega1 + 3*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 118 operations.
template <class Scalar>
Scalar lump_117(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha23 = parameters[7];
  const Scalar delta23 = parameters[10];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 + Scalar(3.0) * omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(3.0) * omega1 + omega2);
  const Scalar per_3 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_4 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_5 = Scalar(1.0) / (omega1 + Scalar(3.0) * omega2);
  const Scalar f_0 = Scalar(2.0) * omega2 * delta23 * eta12 * per_0 * per_1 * per_2;
  const Scalar f_1 = -alpha23 * eta12 * per_3 * per_0 * per_1 * per_2;
  const Scalar f_2 = Scalar(2.0) * omega1_2 * delta23 * eta22 * per_4 * per_5 * per_0 * per_1;
  const Scalar f_3 = Scalar(9.0) * omega1 * omega2 * delta23 * eta22 * per_4 * per_5 * per_0 * per_1;
  const Scalar f_4 = Scalar(12.0) * omega2_2 * delta23 * eta22 * per_4 * per_5 * per_0 * per_1;
  const Scalar f_5 = Scalar(3.0) * omega2_3 * delta23 * eta22 * per_4 * per_5 * per_0 * per_1 / omega1;
  const Scalar f_6 = -Scalar(2.0) * omega1 * alpha23 * eta22 * per_3 * per_4 * per_5 * per_0 * per_1;
  const Scalar f_7 = -Scalar(6.0) * omega2 * alpha23 * eta22 * per_3 * per_4 * per_5 * per_0 * per_1;
  const Scalar f_8 = -Scalar(3.0) * omega2_2 * alpha23 * eta22 * per_3 * per_4 * per_5 * per_0 * per_1 / omega1;
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_1;
  const Scalar q_2 = (f_0 + f_1) * per_2;
  const Scalar q_3 = (f_1 + f_6 + f_7 + f_8) * per_3;
  const Scalar q_4 = (f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_4;
  const Scalar q_5 = (f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_5;
  // by omega1
  gradient[0] = (Scalar(2.0) * f_2 + f_3 - f_5 + f_6 - f_8) / omega1 - Scalar(2.0) * q_0 - Scalar(2.0) * q_1
      - Scalar(3.0) * q_2 - q_3 - q_4 - q_5;
  // by omega2
  gradient[1] = (f_0 + f_3 + Scalar(2.0) * f_4 + Scalar(3.0) * f_5 + f_7 + Scalar(2.0) * f_8) / omega2 - q_0
      - Scalar(3.0) * q_1 - q_2 - q_3 - Scalar(2.0) * q_4 - Scalar(3.0) * q_5;
  const Scalar c_0 = -per_3 * per_0 * per_1 * per_2;  // multiplies alpha23*eta12
  // multiplies alpha23*eta22
  const Scalar c_1 = (-Scalar(2.0) * omega1_2 - Scalar(6.0) * omega1 * omega2
      - Scalar(3.0) * omega2_2) * per_3 * per_4 * per_5 * per_0 * per_1 / omega1;
  const Scalar c_2 = Scalar(2.0) * omega2 * per_0 * per_1 * per_2;  // multiplies delta23*eta12
  // multiplies delta23*eta22
  const Scalar c_3 = (Scalar(2.0) * omega1_3 + Scalar(9.0) * omega1_2 * omega2 + Scalar(12.0) * omega1 * omega2_2
      + Scalar(3.0) * omega2_3) * per_4 * per_5 * per_0 * per_1 / omega1;
  gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
  gradient[10] = eta12 * c_2 + eta22 * c_3;  // by delta23
  gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
  gradient[30] = alpha23 * c_1 + delta23 * c_3;  // by eta22
  return value;
}

/// harmonic_re_v2_A_v12_F = (-2*omega1^2*delta22*eta12 - omega1*omega2*delta22*eta12 -
/// alpha22*eta12)/(3*omega1*(omega1 + omega2)*(3*omega1 + omega2)*(3*omega1 + 2*omega2)) +
/// (-omega1^2*delta22*eta22 - alpha22*eta22)/(6*omega1*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 +
/// 2*omega2))
/// It is returned; gradient[p] = d/d parameters[p] where that is asked for. 66 operations.
template <class Scalar>
Scalar lump_118(const Scalar* parameters, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha22 = parameters[6];
  const Scalar delta22 = parameters[9];
  const Scalar eta12 = parameters[21];
  const Scalar eta22 = parameters[30];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(3.0) * omega1 + omega2);
  const Scalar per_2 = Scalar(1.0) / (Scalar(3.0) * omega1 + Scalar(2.0) * omega2);
  const Scalar per_3 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_4 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  const Scalar f_0 = -Scalar(2.0) * omega1 * delta22 * eta12 * per_0 * per_1 * per_2 / Scalar(3.0);
  const Scalar f_1 = -omega2 * delta22 * eta12 * per_0 * per_1 * per_2 / Scalar(3.0);
  const Scalar f_2 = -alpha22 * eta12 * per_0 * per_1 * per_2 / (Scalar(3.0) * omega1);
  const Scalar f_3 = -omega1 * delta22 * eta22 * per_3 * per_4 * per_2 / Scalar(6.0);
  const Scalar f_4 = -alpha22 * eta22 * per_3 * per_4 * per_2 / (Scalar(6.0) * omega1);
  const Scalar value = f_0 + f_1 + f_2 + f_3 + f_4;
  if (gradient == nullptr) return value;
  const Scalar q_0 = (f_0 + f_1 + f_2) * per_0;
  const Scalar q_1 = (f_0 + f_1 + f_2) * per_1;
  const Scalar q_2 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_2;
  const Scalar q_3 = (f_3 + f_4) * per_3;
  const Scalar q_4 = (f_3 + f_4) * per_4;
  // by omega1
  gradient[0] = (f_0 - f_2 + f_3 - f_4) / omega1 - q_0 - Scalar(3.0) * q_1 - Scalar(3.0) * q_2 - Scalar(2.0) * q_3
      - Scalar(2.0) * q_4;
  gradient[1] = f_1 / omega2 - q_0 - q_1 - Scalar(2.0) * q_2 - q_3 + q_4;  // by omega2
  const Scalar c_0 = -per_0 * per_1 * per_2 / (Scalar(3.0) * omega1);  // multiplies alpha22*eta12
  const Scalar c_1 = -per_3 * per_4 * per_2 / (Scalar(6.0) * omega1);  // multiplies alpha22*eta22
  // multiplies delta22*eta12
  const Scalar c_2 = (-Scalar(2.0) * omega1 - omega2) * per_0 * per_1 * per_2 / Scalar(3.0);
  const Scalar c_3 = -omega1 * per_3 * per_4 * per_2 / Scalar(6.0);  // multiplies delta22*eta22
  gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
  gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
  gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
  gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  return value;
}

namespace primary_1 {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: conservative_v1_A_v12_F = (-3*omega1^2*delta21*eta12 + 5*alpha21*eta12)/(12*omega1^3)
/// lumps[1]: mu11 = mu11
/// lumps[3]: conservative_v1_A_v1_F2 = -eta12^2/(12*omega1^3)
/// lumps[5]: mu13 = mu13
/// lumps[7]: eta11 = eta11
/// lumps[9]: mu22 = mu22
/// lumps[11]: mu23 = mu23
/// lumps[13]: eta12 = eta12
/// lumps[14]: harmonic_re_v1_A_v2_conjA_v2 = (2*omega2^2*delta23 - 2*alpha23)/omega1^2
/// lumps[15]: harmonic_re_v1_A_v1_conjA_v1 = (2*omega1^2*delta21 - 2*alpha21)/omega1^2
/// lumps[19]: mu12 = mu12
/// lumps[26]: harmonic_re_v1_A_v12 = (-3*omega1^2*delta21 + alpha21)/(3*omega1^2)
/// lumps[35]: harmonic_re_v1_A_v12_F = (17*omega1^2*delta21*eta12 - 3*alpha21*eta12)/(48*omega1^4)
/// lumps[39]: eta22 = eta22
/// lumps[41]: harmonic_re_v2_A_v2_conjA_v2 = (2*omega2^2*delta24 - 2*alpha24)/omega2^2
/// lumps[42]: harmonic_re_v2_A_v1_conjA_v1 = (2*omega1^2*delta22 - 2*alpha22)/omega2^2
/// lumps[46]: harmonic_re_v2_A_v22 = (-3*omega2^2*delta24 + alpha24)/(3*omega2^2)
/// lumps[48]: mu21 = mu21
/// lumps[49]: eta21 = eta21
/// 48 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu11 = parameters[2];
  const Scalar mu12 = parameters[3];
  const Scalar mu13 = parameters[4];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar eta11 = parameters[20];
  const Scalar eta12 = parameters[21];
  const Scalar mu22 = parameters[22];
  const Scalar mu21 = parameters[23];
  const Scalar mu23 = parameters[24];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar eta21 = parameters[29];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar eta12_2 = eta12 * eta12;
  // conservative_v1_A_v12_F
  lumps[0] = (-Scalar(3.0) * omega1_2 * delta21 * eta12
      + Scalar(5.0) * alpha21 * eta12) / (Scalar(12.0) * omega1_3);
  lumps[1] = mu11;  // mu11
  lumps[2] = lump_0(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v1
  lumps[3] = -eta12_2 / (Scalar(12.0) * omega1_3);  // conservative_v1_A_v1_F2
  lumps[4] = lump_1(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v1_A_v2_conjA_v2
  lumps[5] = mu13;  // mu13
  lumps[6] = lump_2(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v12_conjA_v1
  lumps[7] = eta11;  // eta11
  lumps[8] = lump_3(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v2_conjA_v2_F
  lumps[9] = mu22;  // mu22
  lumps[10] = lump_4(parameters, static_cast<Scalar*>(nullptr));  // conservative_v2_A_v2_F2
  lumps[11] = mu23;  // mu23
  lumps[12] = lump_5(parameters, static_cast<Scalar*>(nullptr));  // conservative_v2_A_v22_conjA_v2
  lumps[13] = eta12;  // eta12
  // harmonic_re_v1_A_v2_conjA_v2
  lumps[14] = (Scalar(2.0) * omega2_2 * delta23 - Scalar(2.0) * alpha23) / omega1_2;
  // harmonic_re_v1_A_v1_conjA_v1
  lumps[15] = (Scalar(2.0) * omega1_2 * delta21 - Scalar(2.0) * alpha21) / omega1_2;
  lumps[16] = lump_6(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v2_conjA_v1
  lumps[17] = lump_7(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v2_conjA_v1
  lumps[18] = lump_8(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v2_F
  lumps[19] = mu12;  // mu12
  lumps[20] = lump_9(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v2_conjA_v1_F
  lumps[21] = lump_10(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v22_conjA_v2
  lumps[22] = lump_11(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_A_v2_conjA_v1
  lumps[23] = lump_12(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_A_v2_F
  lumps[24] = lump_13(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v22
  lumps[25] = lump_14(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v22
  lumps[26] = (-Scalar(3.0) * omega1_2 * delta21 + alpha21) / (Scalar(3.0) * omega1_2);  // harmonic_re_v1_A_v12
  lumps[27] = lump_15(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v12
  lumps[28] = lump_16(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_A_v2
  lumps[29] = lump_17(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v1_A_v2
  lumps[30] = lump_18(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v2_conjA_v12
  lumps[31] = lump_19(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v22_conjA_v1
  lumps[32] = lump_20(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v22_F
  lumps[33] = lump_21(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_A_v22
  lumps[34] = lump_22(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v23
  // harmonic_re_v1_A_v12_F
  lumps[35] = (Scalar(17.0) * omega1_2 * delta21 * eta12
      - Scalar(3.0) * alpha21 * eta12) / (Scalar(48.0) * omega1_4);
  lumps[36] = lump_23(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v13
  lumps[37] = lump_24(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v12_A_v2
  lumps[38] = lump_25(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v2_conjA_v1
  lumps[39] = eta22;  // eta22
  lumps[40] = lump_26(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v2_conjA_v1
  // harmonic_re_v2_A_v2_conjA_v2
  lumps[41] = (Scalar(2.0) * omega2_2 * delta24 - Scalar(2.0) * alpha24) / omega2_2;
  // harmonic_re_v2_A_v1_conjA_v1
  lumps[42] = (Scalar(2.0) * omega1_2 * delta22 - Scalar(2.0) * alpha22) / omega2_2;
  lumps[43] = lump_27(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_conjA_v1_F
  lumps[44] = lump_28(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_A_v2
  lumps[45] = lump_29(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v1_A_v2
  lumps[46] = (-Scalar(3.0) * omega2_2 * delta24 + alpha24) / (Scalar(3.0) * omega2_2);  // harmonic_re_v2_A_v22
  lumps[47] = lump_30(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v22
  lumps[48] = mu21;  // mu21
  lumps[49] = eta21;  // eta21
  lumps[50] = lump_31(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v2_conjA_v2_F
  lumps[51] = lump_32(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_conjA_v1_F
  lumps[52] = lump_33(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_A_v2_conjA_v2
  lumps[53] = lump_34(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v12_conjA_v1
  lumps[54] = lump_35(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v12_F
  lumps[55] = lump_36(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v12
  lumps[56] = lump_37(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v1_F
  lumps[57] = lump_38(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v12
  lumps[58] = lump_39(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v2_conjA_v12
  lumps[59] = lump_40(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v2_conjA_v1_F
  lumps[60] = lump_41(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v22_conjA_v1
  lumps[61] = lump_42(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v22_F
  lumps[62] = lump_43(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_A_v2_F
  lumps[63] = lump_44(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v12_A_v2
  lumps[64] = lump_45(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_A_v22
  lumps[65] = lump_46(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v23
  lumps[66] = lump_47(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v13
}

/// jacobian[l * 31 + p] = d lumps[l] / d parameters[p]. 79 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar eta12 = parameters[21];
  const Scalar alpha24 = parameters[25];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar eta12_2 = eta12 * eta12;
  for (std::size_t i = 0; i < 2077; ++i) jacobian[i] = Scalar(0.0);
  // d conservative_v1_A_v12_F / d omega1
  jacobian[0] = (omega1_2 * delta21 * eta12 - Scalar(5.0) * alpha21 * eta12) / (Scalar(4.0) * omega1_4);
  jacobian[5] = Scalar(5.0) * eta12 / (Scalar(12.0) * omega1_3);  // d conservative_v1_A_v12_F / d alpha21
  jacobian[8] = -eta12 / (Scalar(4.0) * omega1);  // d conservative_v1_A_v12_F / d delta21
  // d conservative_v1_A_v12_F / d eta12
  jacobian[21] = (-Scalar(3.0) * omega1_2 * delta21 + Scalar(5.0) * alpha21) / (Scalar(12.0) * omega1_3);
  jacobian[33] = Scalar(1.0);  // d mu11 / d mu11
  lump_0(parameters, jacobian + 62);  // d conservative_v1_A_v1
  jacobian[93] = eta12_2 / (Scalar(4.0) * omega1_4);  // d conservative_v1_A_v1_F2 / d omega1
  jacobian[114] = -eta12 / (Scalar(6.0) * omega1_3);  // d conservative_v1_A_v1_F2 / d eta12
  lump_1(parameters, jacobian + 124);  // d conservative_v1_A_v1_A_v2_conjA_v2
  jacobian[159] = Scalar(1.0);  // d mu13 / d mu13
  lump_2(parameters, jacobian + 186);  // d conservative_v1_A_v12_conjA_v1
  jacobian[237] = Scalar(1.0);  // d eta11 / d eta11
  lump_3(parameters, jacobian + 248);  // d conservative_v1_A_v2_conjA_v2_F
  jacobian[301] = Scalar(1.0);  // d mu22 / d mu22
  lump_4(parameters, jacobian + 310);  // d conservative_v2_A_v2_F2
  jacobian[365] = Scalar(1.0);  // d mu23 / d mu23
  lump_5(parameters, jacobian + 372);  // d conservative_v2_A_v22_conjA_v2
  jacobian[424] = Scalar(1.0);  // d eta12 / d eta12
  // d harmonic_re_v1_A_v2_conjA_v2 / d omega1
  jacobian[434] = (-Scalar(4.0) * omega2_2 * delta23 + Scalar(4.0) * alpha23) / omega1_3;
  jacobian[435] = Scalar(4.0) * omega2 * delta23 / omega1_2;  // d harmonic_re_v1_A_v2_conjA_v2 / d omega2
  jacobian[441] = -Scalar(2.0) / omega1_2;  // d harmonic_re_v1_A_v2_conjA_v2 / d alpha23
  jacobian[444] = Scalar(2.0) * omega2_2 / omega1_2;  // d harmonic_re_v1_A_v2_conjA_v2 / d delta23
  jacobian[465] = Scalar(4.0) * alpha21 / omega1_3;  // d harmonic_re_v1_A_v1_conjA_v1 / d omega1
  jacobian[470] = -Scalar(2.0) / omega1_2;  // d harmonic_re_v1_A_v1_conjA_v1 / d alpha21
  jacobian[473] = Scalar(2.0);  // d harmonic_re_v1_A_v1_conjA_v1 / d delta21
  lump_6(parameters, jacobian + 496);  // d harmonic_re_v1_A_v2_conjA_v1
  lump_7(parameters, jacobian + 527);  // d harmonic_im_v1_A_v2_conjA_v1
  lump_8(parameters, jacobian + 558);  // d harmonic_im_v1_A_v2_F
  jacobian[592] = Scalar(1.0);  // d mu12 / d mu12
  lump_9(parameters, jacobian + 620);  // d harmonic_re_v1_A_v2_conjA_v1_F
  lump_10(parameters, jacobian + 651);  // d harmonic_re_v1_A_v22_conjA_v2
  lump_11(parameters, jacobian + 682);  // d harmonic_re_v1_A_v1_A_v2_conjA_v1
  lump_12(parameters, jacobian + 713);  // d harmonic_re_v1_A_v1_A_v2_F
  lump_13(parameters, jacobian + 744);  // d harmonic_re_v1_A_v22
  lump_14(parameters, jacobian + 775);  // d harmonic_im_v1_A_v22
  jacobian[806] = -Scalar(2.0) * alpha21 / (Scalar(3.0) * omega1_3);  // d harmonic_re_v1_A_v12 / d omega1
  jacobian[811] = Scalar(1.0) / (Scalar(3.0) * omega1_2);  // d harmonic_re_v1_A_v12 / d alpha21
  jacobian[814] = -Scalar(1.0);  // d harmonic_re_v1_A_v12 / d delta21
  lump_15(parameters, jacobian + 837);  // d harmonic_im_v1_A_v12
  lump_16(parameters, jacobian + 868);  // d harmonic_re_v1_A_v1_A_v2
  lump_17(parameters, jacobian + 899);  // d harmonic_im_v1_A_v1_A_v2
  lump_18(parameters, jacobian + 930);  // d harmonic_re_v1_A_v2_conjA_v12
  lump_19(parameters, jacobian + 961);  // d harmonic_re_v1_A_v22_conjA_v1
  lump_20(parameters, jacobian + 992);  // d harmonic_re_v1_A_v22_F
  lump_21(parameters, jacobian + 1023);  // d harmonic_re_v1_A_v1_A_v22
  lump_22(parameters, jacobian + 1054);  // d harmonic_re_v1_A_v23
  // d harmonic_re_v1_A_v12_F / d omega1
  jacobian[1085] = (-Scalar(17.0) * omega1_2 * delta21 * eta12
      + Scalar(6.0) * alpha21 * eta12) / (Scalar(24.0) * omega1_5);
  jacobian[1090] = -eta12 / (Scalar(16.0) * omega1_4);  // d harmonic_re_v1_A_v12_F / d alpha21
  jacobian[1093] = Scalar(17.0) * eta12 / (Scalar(48.0) * omega1_2);  // d harmonic_re_v1_A_v12_F / d delta21
  // d harmonic_re_v1_A_v12_F / d eta12
  jacobian[1106] = (Scalar(17.0) * omega1_2 * delta21 - Scalar(3.0) * alpha21) / (Scalar(48.0) * omega1_4);
  lump_23(parameters, jacobian + 1116);  // d harmonic_re_v1_A_v13
  lump_24(parameters, jacobian + 1147);  // d harmonic_re_v1_A_v12_A_v2
  lump_25(parameters, jacobian + 1178);  // d harmonic_re_v2_A_v2_conjA_v1
  jacobian[1239] = Scalar(1.0);  // d eta22 / d eta22
  lump_26(parameters, jacobian + 1240);  // d harmonic_im_v2_A_v2_conjA_v1
  jacobian[1272] = Scalar(4.0) * alpha24 / omega2_3;  // d harmonic_re_v2_A_v2_conjA_v2 / d omega2
  jacobian[1296] = -Scalar(2.0) / omega2_2;  // d harmonic_re_v2_A_v2_conjA_v2 / d alpha24
  jacobian[1297] = Scalar(2.0);  // d harmonic_re_v2_A_v2_conjA_v2 / d delta24
  jacobian[1302] = Scalar(4.0) * omega1 * delta22 / omega2_2;  // d harmonic_re_v2_A_v1_conjA_v1 / d omega1
  // d harmonic_re_v2_A_v1_conjA_v1 / d omega2
  jacobian[1303] = (-Scalar(4.0) * omega1_2 * delta22 + Scalar(4.0) * alpha22) / omega2_3;
  jacobian[1308] = -Scalar(2.0) / omega2_2;  // d harmonic_re_v2_A_v1_conjA_v1 / d alpha22
  jacobian[1311] = Scalar(2.0) * omega1_2 / omega2_2;  // d harmonic_re_v2_A_v1_conjA_v1 / d delta22
  lump_27(parameters, jacobian + 1333);  // d harmonic_im_v2_conjA_v1_F
  lump_28(parameters, jacobian + 1364);  // d harmonic_re_v2_A_v1_A_v2
  lump_29(parameters, jacobian + 1395);  // d harmonic_im_v2_A_v1_A_v2
  jacobian[1427] = -Scalar(2.0) * alpha24 / (Scalar(3.0) * omega2_3);  // d harmonic_re_v2_A_v22 / d omega2
  jacobian[1451] = Scalar(1.0) / (Scalar(3.0) * omega2_2);  // d harmonic_re_v2_A_v22 / d alpha24
  jacobian[1452] = -Scalar(1.0);  // d harmonic_re_v2_A_v22 / d delta24
  lump_30(parameters, jacobian + 1457);  // d harmonic_im_v2_A_v22
  jacobian[1511] = Scalar(1.0);  // d mu21 / d mu21
  jacobian[1548] = Scalar(1.0);  // d eta21 / d eta21
  lump_31(parameters, jacobian + 1550);  // d harmonic_re_v2_A_v2_conjA_v2_F
  lump_32(parameters, jacobian + 1581);  // d harmonic_re_v2_A_v1_conjA_v1_F
  lump_33(parameters, jacobian + 1612);  // d harmonic_re_v2_A_v1_A_v2_conjA_v2
  lump_34(parameters, jacobian + 1643);  // d harmonic_re_v2_A_v12_conjA_v1
  lump_35(parameters, jacobian + 1674);  // d harmonic_re_v2_A_v12_F
  lump_36(parameters, jacobian + 1705);  // d harmonic_re_v2_A_v12
  lump_37(parameters, jacobian + 1736);  // d harmonic_im_v2_A_v1_F
  lump_38(parameters, jacobian + 1767);  // d harmonic_im_v2_A_v12
  lump_39(parameters, jacobian + 1798);  // d harmonic_re_v2_A_v2_conjA_v12
  lump_40(parameters, jacobian + 1829);  // d harmonic_re_v2_A_v2_conjA_v1_F
  lump_41(parameters, jacobian + 1860);  // d harmonic_re_v2_A_v22_conjA_v1
  lump_42(parameters, jacobian + 1891);  // d harmonic_re_v2_A_v22_F
  lump_43(parameters, jacobian + 1922);  // d harmonic_re_v2_A_v1_A_v2_F
  lump_44(parameters, jacobian + 1953);  // d harmonic_re_v2_A_v12_A_v2
  lump_45(parameters, jacobian + 1984);  // d harmonic_re_v2_A_v1_A_v22
  lump_46(parameters, jacobian + 2015);  // d harmonic_re_v2_A_v23
  lump_47(parameters, jacobian + 2046);  // d harmonic_re_v2_A_v13
}

/// What multiplies the 11 terms of the modulation of v1: functions of the frequencies alone. 6 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(2.0);
  factor[2] = -Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(3.0) / Scalar(2.0);
  factor[6] = Scalar(1.0);
  factor[7] = -Scalar(3.0) * omega1_2 / Scalar(2.0);
  factor[8] = Scalar(1.0);
  factor[9] = -Scalar(1.0) / (Scalar(4.0) * omega1);
  factor[10] = Scalar(1.0);
}

/// Rows of the modulation of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega1)*A_v1 = i*conservative_v1_A_v12_F*A_v1^2*F + 2*i*conservative_v1_A_v12_F*A_v1*conj(A_v1)*F -
/// mu11*A_v1 + i*conservative_v1_A_v1*A_v1 + i*conservative_v1_A_v1_F2*A_v1*F^2 +
/// 3/2*i*conservative_v1_A_v1_F2*conj(A_v1)*F^2 + i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) -
/// 3*omega1^2/2*mu13*A_v1^2*conj(A_v1) + i*conservative_v1_A_v12_conjA_v1*A_v1^2*conj(A_v1) -
/// 1/(4*omega1)*i*eta11*F + i*conservative_v1_A_v2_conjA_v2_F*A_v2*conj(A_v2)*F
/// 9 columns; per observation at most 33 products and sums of complex numbers.
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
  Scalar factor[11];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    const Scalar norm_F = norm_of(F);
    // conservative_v1_A_v12_F
    store_complex(column_0, i, times_i(factor[0] * (A_v1 * A_v1 * conj_F))
        + times_i(factor[1] * (norm_A_v1 * F)));
    store_complex(column_1, i, factor[2] * (A_v1));  // mu11
    store_complex(column_2, i, times_i(factor[3] * (A_v1)));  // conservative_v1_A_v1
    // conservative_v1_A_v1_F2
    store_complex(column_3, i, times_i(factor[4] * (A_v1 * norm_F)) + times_i(factor[5] * (conj_A_v1 * F * F)));
    store_complex(column_4, i, times_i(factor[6] * (A_v1 * norm_A_v2)));  // conservative_v1_A_v1_A_v2_conjA_v2
    store_complex(column_5, i, factor[7] * (norm_A_v1 * A_v1));  // mu13
    store_complex(column_6, i, times_i(factor[8] * (norm_A_v1 * A_v1)));  // conservative_v1_A_v12_conjA_v1
    store_complex(column_7, i, times_i(factor[9] * (F)));  // eta11
    store_complex(column_8, i, times_i(factor[10] * (norm_A_v2 * F)));  // conservative_v1_A_v2_conjA_v2_F
  }
}

/// columns[j][i] of the rows.
inline void columns_0(const BatchArrays& data, double* const* columns) {
  rows_0(data, FactorValues<factors_0<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_0(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_0(data, FactorSlopes<factors_0<DualNumber>, 2, 1, 11>{mode}, columns);
}

/// What multiplies the 8 terms of the modulation of v2: functions of the frequencies alone. 7 operations.
template <class Scalar>
void factors_1([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega2_2 = omega2 * omega2;
  factor[0] = -omega2 / omega1;
  factor[1] = omega1 / omega2;
  factor[2] = omega1 / omega2;
  factor[3] = omega1 / omega2;
  factor[4] = -Scalar(1.0);
  factor[5] = Scalar(1.0);
  factor[6] = -Scalar(3.0) * omega2_2 / Scalar(2.0);
  factor[7] = Scalar(1.0);
}

/// Rows of the modulation of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega2)*A_v2 = -omega2/omega1*i*conservative_v1_A_v1*A_v2 +
/// omega1/omega2*i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*conj(A_v1)*A_v2 +
/// omega1/omega2*i*conservative_v1_A_v2_conjA_v2_F*A_v1*A_v2*F +
/// omega1/omega2*i*conservative_v1_A_v2_conjA_v2_F*conj(A_v1)*A_v2*F - mu22*A_v2 +
/// i*conservative_v2_A_v2_F2*A_v2*F^2 - 3*omega2^2/2*mu23*A_v2^2*conj(A_v2) +
/// i*conservative_v2_A_v22_conjA_v2*A_v2^2*conj(A_v2)
/// 7 columns; per observation at most 25 products and sums of complex numbers.
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
  Scalar factor[8];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    const Scalar norm_F = norm_of(F);
    store_complex(column_0, i, times_i(factor[0] * (A_v2)));  // conservative_v1_A_v1
    store_complex(column_1, i, times_i(factor[1] * (norm_A_v1 * A_v2)));  // conservative_v1_A_v1_A_v2_conjA_v2
    // conservative_v1_A_v2_conjA_v2_F
    store_complex(column_2, i, times_i(factor[2] * (A_v1 * A_v2 * conj_F))
        + times_i(factor[3] * (conj_A_v1 * A_v2 * F)));
    store_complex(column_3, i, factor[4] * (A_v2));  // mu22
    store_complex(column_4, i, times_i(factor[5] * (A_v2 * norm_F)));  // conservative_v2_A_v2_F2
    store_complex(column_5, i, factor[6] * (norm_A_v2 * A_v2));  // mu23
    store_complex(column_6, i, times_i(factor[7] * (norm_A_v2 * A_v2)));  // conservative_v2_A_v22_conjA_v2
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

/// What multiplies the 4 terms of the harmonic 0 of v1: functions of the frequencies alone. 7 operations.
template <class Scalar>
void factors_2([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 - Omega);
  factor[0] = per_0 / (Scalar(2.0) * Omega);
  factor[1] = per_0 / (Scalar(2.0) * Omega);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the harmonic 0 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in v1 = 1/(2*Omega*(2*omega1 - Omega))*eta12*conj(A_v1)*F + 1/(2*Omega*(2*omega1 -
/// Omega))*eta12*A_v1*F + harmonic_re_v1_A_v2_conjA_v2*A_v2*conj(A_v2) +
/// harmonic_re_v1_A_v1_conjA_v1*A_v1*conj(A_v1)
/// 3 columns; per observation at most 9 products and sums of complex numbers.
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
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * F) + factor[1] * (A_v1 * conj_F));  // eta12
    store_complex(column_1, i, Complex(factor[2] * (norm_A_v2)));  // harmonic_re_v1_A_v2_conjA_v2
    store_complex(column_2, i, Complex(factor[3] * (norm_A_v1)));  // harmonic_re_v1_A_v1_conjA_v1
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

/// What multiplies the 3 terms of the harmonic omega2-Omega of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_3([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega2-Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 - Omega)*t) in v1 = harmonic_re_v1_A_v2_conjA_v1*conj(A_v1)*A_v2 +
/// i*harmonic_im_v1_A_v2_conjA_v1*conj(A_v1)*A_v2 + i*harmonic_im_v1_A_v2_F*A_v2*F
/// 3 columns; per observation at most 9 products and sums of complex numbers.
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
  Scalar factor[3];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * A_v2));  // harmonic_re_v1_A_v2_conjA_v1
    store_complex(column_1, i, times_i(factor[1] * (conj_A_v1 * A_v2)));  // harmonic_im_v1_A_v2_conjA_v1
    store_complex(column_2, i, times_i(factor[2] * (A_v2 * conj_F)));  // harmonic_im_v1_A_v2_F
  }
}

/// columns[j][i] of the rows.
inline void columns_3(const BatchArrays& data, double* const* columns) {
  rows_3(data, FactorValues<factors_3<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_3(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 5 terms of the harmonic omega2 of v1: functions of the frequencies alone. 6 operations.
template <class Scalar>
void factors_4([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  factor[0] = -omega2 * per_0 * per_1;
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
}

/// Rows of the harmonic omega2 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2)*t) in v1 = -omega2/((omega1 + omega2)*(omega1 - omega2))*i*mu12*A_v2 +
/// harmonic_re_v1_A_v2_conjA_v1_F*conj(A_v1)*A_v2*F + harmonic_re_v1_A_v22_conjA_v2*A_v2^2*conj(A_v2) +
/// harmonic_re_v1_A_v1_A_v2_conjA_v1*A_v1*conj(A_v1)*A_v2 + harmonic_re_v1_A_v1_A_v2_F*A_v1*A_v2*F
/// 5 columns; per observation at most 17 products and sums of complex numbers.
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
  Scalar factor[5];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    store_complex(column_0, i, times_i(factor[0] * (A_v2)));  // mu12
    store_complex(column_1, i, factor[1] * (conj_A_v1 * A_v2 * F));  // harmonic_re_v1_A_v2_conjA_v1_F
    store_complex(column_2, i, factor[2] * (norm_A_v2 * A_v2));  // harmonic_re_v1_A_v22_conjA_v2
    store_complex(column_3, i, factor[3] * (norm_A_v1 * A_v2));  // harmonic_re_v1_A_v1_A_v2_conjA_v1
    store_complex(column_4, i, factor[4] * (A_v1 * A_v2 * conj_F));  // harmonic_re_v1_A_v1_A_v2_F
  }
}

/// columns[j][i] of the rows.
inline void columns_4(const BatchArrays& data, double* const* columns) {
  rows_4(data, FactorValues<factors_4<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_4(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_4(data, FactorSlopes<factors_4<DualNumber>, 2, 1, 5>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic 2*omega2 of v1: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_5([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega2 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega2)*t) in v1 = harmonic_re_v1_A_v22*A_v2^2 + i*harmonic_im_v1_A_v22*A_v2^2
/// 2 columns; per observation at most 6 products and sums of complex numbers.
template <class Factors>
void rows_5(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_v2 * A_v2));  // harmonic_re_v1_A_v22
    store_complex(column_1, i, times_i(factor[1] * (A_v2 * A_v2)));  // harmonic_im_v1_A_v22
  }
}

/// columns[j][i] of the rows.
inline void columns_5(const BatchArrays& data, double* const* columns) {
  rows_5(data, FactorValues<factors_5<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_5(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 3 terms of the harmonic omega1+Omega of v1: functions of the frequencies alone. 5
/// operations.
template <class Scalar>
void factors_6([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + Omega);
  factor[0] = -per_0 / (Scalar(2.0) * Omega);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega1+Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + Omega)*t) in v1 = -1/(2*Omega*(2*omega1 + Omega))*eta12*A_v1*F +
/// harmonic_re_v1_A_v12*A_v1^2 + i*harmonic_im_v1_A_v12*A_v1^2
/// 3 columns; per observation at most 9 products and sums of complex numbers.
template <class Factors>
void rows_6(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[3];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * F));  // eta12
    store_complex(column_1, i, factor[1] * (A_v1 * A_v1));  // harmonic_re_v1_A_v12
    store_complex(column_2, i, times_i(factor[2] * (A_v1 * A_v1)));  // harmonic_im_v1_A_v12
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

/// What multiplies the 3 terms of the harmonic omega2+Omega of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_7([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega2+Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + Omega)*t) in v1 = i*harmonic_im_v1_A_v2_F*A_v2*F +
/// harmonic_re_v1_A_v1_A_v2*A_v1*A_v2 + i*harmonic_im_v1_A_v1_A_v2*A_v1*A_v2
/// 3 columns; per observation at most 9 products and sums of complex numbers.
template <class Factors>
void rows_7(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, times_i(factor[0] * (A_v2 * F)));  // harmonic_im_v1_A_v2_F
    store_complex(column_1, i, factor[1] * (A_v1 * A_v2));  // harmonic_re_v1_A_v1_A_v2
    store_complex(column_2, i, times_i(factor[2] * (A_v1 * A_v2)));  // harmonic_im_v1_A_v1_A_v2
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

/// What multiplies the 2 terms of the harmonic -omega1+omega2-Omega of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_8([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic -omega1+omega2-Omega of v1: target = sum of columns[j][i] * lump_j, with the factors
/// above.
/// amplitude of exp(i*(-omega1 + omega2 - Omega)*t) in v1 = harmonic_re_v1_A_v2_conjA_v1_F*conj(A_v1)*A_v2*F +
/// harmonic_re_v1_A_v2_conjA_v12*conj(A_v1)^2*A_v2
/// 2 columns; per observation at most 10 products and sums of complex numbers.
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
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * A_v2 * conj_F));  // harmonic_re_v1_A_v2_conjA_v1_F
    store_complex(column_1, i, factor[1] * (conj_A_v1 * conj_A_v1 * A_v2));  // harmonic_re_v1_A_v2_conjA_v12
  }
}

/// columns[j][i] of the rows.
inline void columns_8(const BatchArrays& data, double* const* columns) {
  rows_8(data, FactorValues<factors_8<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_8(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 2 terms of the harmonic 2*omega2-Omega of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_9([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega2-Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega2 - Omega)*t) in v1 = harmonic_re_v1_A_v22_conjA_v1*conj(A_v1)*A_v2^2 +
/// harmonic_re_v1_A_v22_F*A_v2^2*F
/// 2 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_9(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * A_v2 * A_v2));  // harmonic_re_v1_A_v22_conjA_v1
    store_complex(column_1, i, factor[1] * (A_v2 * A_v2 * conj_F));  // harmonic_re_v1_A_v22_F
  }
}

/// columns[j][i] of the rows.
inline void columns_9(const BatchArrays& data, double* const* columns) {
  rows_9(data, FactorValues<factors_9<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_9(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 2 terms of the harmonic 2*omega2+Omega of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_10([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega2+Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega2 + Omega)*t) in v1 = harmonic_re_v1_A_v22_F*A_v2^2*F +
/// harmonic_re_v1_A_v1_A_v22*A_v1*A_v2^2
/// 2 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_10(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v2 * A_v2 * F));  // harmonic_re_v1_A_v22_F
    store_complex(column_1, i, factor[1] * (A_v1 * A_v2 * A_v2));  // harmonic_re_v1_A_v1_A_v22
  }
}

/// columns[j][i] of the rows.
inline void columns_10(const BatchArrays& data, double* const* columns) {
  rows_10(data, FactorValues<factors_10<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_10(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic 3*omega2 of v1: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_11([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic 3*omega2 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega2)*t) in v1 = harmonic_re_v1_A_v23*A_v2^3
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_11(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_v2 * A_v2 * A_v2));  // harmonic_re_v1_A_v23
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

/// What multiplies the 4 terms of the harmonic omega1+2*Omega of v1: functions of the frequencies alone. 3
/// operations.
template <class Scalar>
void factors_12([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  factor[0] = -Scalar(1.0) / (Scalar(8.0) * omega1);
  factor[1] = -omega1 / Scalar(8.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the harmonic omega1+2*Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + 2*Omega)*t) in v1 = -1/(8*omega1)*conservative_v1_A_v1_F2*A_v1*F^2 -
/// omega1/8*i*mu13*A_v1^3 + harmonic_re_v1_A_v12_F*A_v1^2*F + harmonic_re_v1_A_v13*A_v1^3
/// 4 columns; per observation at most 20 products and sums of complex numbers.
template <class Factors>
void rows_12(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * F * F));  // conservative_v1_A_v1_F2
    store_complex(column_1, i, times_i(factor[1] * (A_v1 * A_v1 * A_v1)));  // mu13
    store_complex(column_2, i, factor[2] * (A_v1 * A_v1 * F));  // harmonic_re_v1_A_v12_F
    store_complex(column_3, i, factor[3] * (A_v1 * A_v1 * A_v1));  // harmonic_re_v1_A_v13
  }
}

/// columns[j][i] of the rows.
inline void columns_12(const BatchArrays& data, double* const* columns) {
  rows_12(data, FactorValues<factors_12<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_12(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_12(data, FactorSlopes<factors_12<DualNumber>, 2, 1, 4>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic omega1+omega2+Omega of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_13([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic omega1+omega2+Omega of v1: target = sum of columns[j][i] * lump_j, with the factors
/// above.
/// amplitude of exp(i*(omega1 + omega2 + Omega)*t) in v1 = harmonic_re_v1_A_v1_A_v2_F*A_v1*A_v2*F +
/// harmonic_re_v1_A_v12_A_v2*A_v1^2*A_v2
/// 2 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_13(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v2 * F));  // harmonic_re_v1_A_v1_A_v2_F
    store_complex(column_1, i, factor[1] * (A_v1 * A_v1 * A_v2));  // harmonic_re_v1_A_v12_A_v2
  }
}

/// columns[j][i] of the rows.
inline void columns_13(const BatchArrays& data, double* const* columns) {
  rows_13(data, FactorValues<factors_13<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_13(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 3 terms of the harmonic omega2-Omega of v2: functions of the frequencies alone. 5
/// operations.
template <class Scalar>
void factors_14([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega2 = natural_frequency[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega2 - Omega);
  factor[0] = Scalar(1.0);
  factor[1] = per_0 / (Scalar(2.0) * Omega);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega2-Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 - Omega)*t) in v2 = harmonic_re_v2_A_v2_conjA_v1*conj(A_v1)*A_v2 +
/// 1/(2*Omega*(2*omega2 - Omega))*eta22*A_v2*F + i*harmonic_im_v2_A_v2_conjA_v1*conj(A_v1)*A_v2
/// 3 columns; per observation at most 9 products and sums of complex numbers.
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
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * A_v2));  // harmonic_re_v2_A_v2_conjA_v1
    store_complex(column_1, i, factor[1] * (A_v2 * conj_F));  // eta22
    store_complex(column_2, i, times_i(factor[2] * (conj_A_v1 * A_v2)));  // harmonic_im_v2_A_v2_conjA_v1
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

/// What multiplies the 4 terms of the harmonic 0 of v2: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_15([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = -Scalar(1.0);
}

/// Rows of the harmonic 0 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in v2 = harmonic_re_v2_A_v2_conjA_v2*A_v2*conj(A_v2) +
/// harmonic_re_v2_A_v1_conjA_v1*A_v1*conj(A_v1) + i*harmonic_im_v2_conjA_v1_F*conj(A_v1)*F -
/// i*harmonic_im_v2_conjA_v1_F*A_v1*F
/// 3 columns; per observation at most 9 products and sums of complex numbers.
template <class Factors>
void rows_15(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    store_complex(column_0, i, Complex(factor[0] * (norm_A_v2)));  // harmonic_re_v2_A_v2_conjA_v2
    store_complex(column_1, i, Complex(factor[1] * (norm_A_v1)));  // harmonic_re_v2_A_v1_conjA_v1
    // harmonic_im_v2_conjA_v1_F
    store_complex(column_2, i, times_i(factor[2] * (conj_A_v1 * F)) + times_i(factor[3] * (A_v1 * conj_F)));
  }
}

/// columns[j][i] of the rows.
inline void columns_15(const BatchArrays& data, double* const* columns) {
  rows_15(data, FactorValues<factors_15<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_15(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 3 terms of the harmonic omega2+Omega of v2: functions of the frequencies alone. 5
/// operations.
template <class Scalar>
void factors_16([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega2 = natural_frequency[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega2 + Omega);
  factor[0] = -per_0 / (Scalar(2.0) * Omega);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega2+Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + Omega)*t) in v2 = -1/(2*Omega*(2*omega2 + Omega))*eta22*A_v2*F +
/// harmonic_re_v2_A_v1_A_v2*A_v1*A_v2 + i*harmonic_im_v2_A_v1_A_v2*A_v1*A_v2
/// 3 columns; per observation at most 9 products and sums of complex numbers.
template <class Factors>
void rows_16(const BatchArrays& data, Factors factors, double* const* columns) {
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
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v2 * F));  // eta22
    store_complex(column_1, i, factor[1] * (A_v1 * A_v2));  // harmonic_re_v2_A_v1_A_v2
    store_complex(column_2, i, times_i(factor[2] * (A_v1 * A_v2)));  // harmonic_im_v2_A_v1_A_v2
  }
}

/// columns[j][i] of the rows.
inline void columns_16(const BatchArrays& data, double* const* columns) {
  rows_16(data, FactorValues<factors_16<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_16(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_16(data, FactorSlopes<factors_16<DualNumber>, 2, 1, 3>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic 2*omega2 of v2: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_17([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega2 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega2)*t) in v2 = harmonic_re_v2_A_v22*A_v2^2 + i*harmonic_im_v2_A_v22*A_v2^2
/// 2 columns; per observation at most 6 products and sums of complex numbers.
template <class Factors>
void rows_17(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_v2 * A_v2));  // harmonic_re_v2_A_v22
    store_complex(column_1, i, times_i(factor[1] * (A_v2 * A_v2)));  // harmonic_im_v2_A_v22
  }
}

/// columns[j][i] of the rows.
inline void columns_17(const BatchArrays& data, double* const* columns) {
  rows_17(data, FactorValues<factors_17<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_17(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 7 terms of the harmonic Omega of v2: functions of the frequencies alone. 8 operations.
template <class Scalar>
void factors_18([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  factor[0] = omega1 * per_0 * per_1;
  factor[1] = -per_0 * per_1 / Scalar(2.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
  factor[6] = Scalar(1.0);
}

/// Rows of the harmonic Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(Omega)*t) in v2 = omega1/((omega1 + omega2)*(omega1 - omega2))*i*mu21*A_v1 - 1/(2*(omega1
/// + omega2)*(omega1 - omega2))*eta21*F + harmonic_re_v2_A_v2_conjA_v2_F*A_v2*conj(A_v2)*F +
/// harmonic_re_v2_A_v1_conjA_v1_F*A_v1*conj(A_v1)*F + harmonic_re_v2_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) +
/// harmonic_re_v2_A_v12_conjA_v1*A_v1^2*conj(A_v1) + harmonic_re_v2_A_v12_F*A_v1^2*F
/// 7 columns; per observation at most 19 products and sums of complex numbers.
template <class Factors>
void rows_18(const BatchArrays& data, Factors factors, double* const* columns) {
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
  Scalar factor[7];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    store_complex(column_0, i, times_i(factor[0] * (A_v1)));  // mu21
    store_complex(column_1, i, factor[1] * (F));  // eta21
    store_complex(column_2, i, factor[2] * (norm_A_v2 * F));  // harmonic_re_v2_A_v2_conjA_v2_F
    store_complex(column_3, i, factor[3] * (norm_A_v1 * F));  // harmonic_re_v2_A_v1_conjA_v1_F
    store_complex(column_4, i, factor[4] * (A_v1 * norm_A_v2));  // harmonic_re_v2_A_v1_A_v2_conjA_v2
    store_complex(column_5, i, factor[5] * (norm_A_v1 * A_v1));  // harmonic_re_v2_A_v12_conjA_v1
    store_complex(column_6, i, factor[6] * (A_v1 * A_v1 * conj_F));  // harmonic_re_v2_A_v12_F
  }
}

/// columns[j][i] of the rows.
inline void columns_18(const BatchArrays& data, double* const* columns) {
  rows_18(data, FactorValues<factors_18<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_18(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_18(data, FactorSlopes<factors_18<DualNumber>, 2, 1, 7>{mode}, columns);
}

/// What multiplies the 3 terms of the harmonic omega1+Omega of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_19([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega1+Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + Omega)*t) in v2 = harmonic_re_v2_A_v12*A_v1^2 + i*harmonic_im_v2_A_v1_F*A_v1*F +
/// i*harmonic_im_v2_A_v12*A_v1^2
/// 3 columns; per observation at most 9 products and sums of complex numbers.
template <class Factors>
void rows_19(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[3];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v1));  // harmonic_re_v2_A_v12
    store_complex(column_1, i, times_i(factor[1] * (A_v1 * F)));  // harmonic_im_v2_A_v1_F
    store_complex(column_2, i, times_i(factor[2] * (A_v1 * A_v1)));  // harmonic_im_v2_A_v12
  }
}

/// columns[j][i] of the rows.
inline void columns_19(const BatchArrays& data, double* const* columns) {
  rows_19(data, FactorValues<factors_19<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_19(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 3 terms of the harmonic omega2-2*Omega of v2: functions of the frequencies alone. 10
/// operations.
template <class Scalar>
void factors_20([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  factor[0] = (omega1 * omega2 + Scalar(2.0) * omega2_2) * per_0 / (Scalar(4.0) * omega1_2);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega2-2*Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 - 2*Omega)*t) in v2 = (omega1*omega2 + 2*omega2^2)/(4*omega1^2*(omega1 -
/// omega2))*conservative_v2_A_v2_F2*A_v2*F^2 + harmonic_re_v2_A_v2_conjA_v12*conj(A_v1)^2*A_v2 +
/// harmonic_re_v2_A_v2_conjA_v1_F*conj(A_v1)*A_v2*F
/// 3 columns; per observation at most 15 products and sums of complex numbers.
template <class Factors>
void rows_20(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    store_complex(column_0, i, factor[0] * (A_v2 * conj_F * conj_F));  // conservative_v2_A_v2_F2
    store_complex(column_1, i, factor[1] * (conj_A_v1 * conj_A_v1 * A_v2));  // harmonic_re_v2_A_v2_conjA_v12
    store_complex(column_2, i, factor[2] * (conj_A_v1 * A_v2 * conj_F));  // harmonic_re_v2_A_v2_conjA_v1_F
  }
}

/// columns[j][i] of the rows.
inline void columns_20(const BatchArrays& data, double* const* columns) {
  rows_20(data, FactorValues<factors_20<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_20(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_20(data, FactorSlopes<factors_20<DualNumber>, 2, 1, 3>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic 2*omega2-Omega of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_21([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega2-Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega2 - Omega)*t) in v2 = harmonic_re_v2_A_v22_conjA_v1*conj(A_v1)*A_v2^2 +
/// harmonic_re_v2_A_v22_F*A_v2^2*F
/// 2 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_21(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * A_v2 * A_v2));  // harmonic_re_v2_A_v22_conjA_v1
    store_complex(column_1, i, factor[1] * (A_v2 * A_v2 * conj_F));  // harmonic_re_v2_A_v22_F
  }
}

/// columns[j][i] of the rows.
inline void columns_21(const BatchArrays& data, double* const* columns) {
  rows_21(data, FactorValues<factors_21<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_21(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 3 terms of the harmonic omega2+2*Omega of v2: functions of the frequencies alone. 10
/// operations.
template <class Scalar>
void factors_22([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  factor[0] = (omega1 * omega2 - Scalar(2.0) * omega2_2) * per_0 / (Scalar(4.0) * omega1_2);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega2+2*Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + 2*Omega)*t) in v2 = (omega1*omega2 - 2*omega2^2)/(4*omega1^2*(omega1 +
/// omega2))*conservative_v2_A_v2_F2*A_v2*F^2 + harmonic_re_v2_A_v1_A_v2_F*A_v1*A_v2*F +
/// harmonic_re_v2_A_v12_A_v2*A_v1^2*A_v2
/// 3 columns; per observation at most 15 products and sums of complex numbers.
template <class Factors>
void rows_22(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v2 * F * F));  // conservative_v2_A_v2_F2
    store_complex(column_1, i, factor[1] * (A_v1 * A_v2 * F));  // harmonic_re_v2_A_v1_A_v2_F
    store_complex(column_2, i, factor[2] * (A_v1 * A_v1 * A_v2));  // harmonic_re_v2_A_v12_A_v2
  }
}

/// columns[j][i] of the rows.
inline void columns_22(const BatchArrays& data, double* const* columns) {
  rows_22(data, FactorValues<factors_22<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_22(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_22(data, FactorSlopes<factors_22<DualNumber>, 2, 1, 3>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic 2*omega2+Omega of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_23([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega2+Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega2 + Omega)*t) in v2 = harmonic_re_v2_A_v22_F*A_v2^2*F +
/// harmonic_re_v2_A_v1_A_v22*A_v1*A_v2^2
/// 2 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_23(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v2 * A_v2 * F));  // harmonic_re_v2_A_v22_F
    store_complex(column_1, i, factor[1] * (A_v1 * A_v2 * A_v2));  // harmonic_re_v2_A_v1_A_v22
  }
}

/// columns[j][i] of the rows.
inline void columns_23(const BatchArrays& data, double* const* columns) {
  rows_23(data, FactorValues<factors_23<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_23(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 2 terms of the harmonic 3*omega2 of v2: functions of the frequencies alone. 1 operations.
template <class Scalar>
void factors_24([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega2 = natural_frequency[1];
  factor[0] = -omega2 / Scalar(8.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic 3*omega2 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega2)*t) in v2 = -omega2/8*i*mu23*A_v2^3 + harmonic_re_v2_A_v23*A_v2^3
/// 2 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_24(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, times_i(factor[0] * (A_v2 * A_v2 * A_v2)));  // mu23
    store_complex(column_1, i, factor[1] * (A_v2 * A_v2 * A_v2));  // harmonic_re_v2_A_v23
  }
}

/// columns[j][i] of the rows.
inline void columns_24(const BatchArrays& data, double* const* columns) {
  rows_24(data, FactorValues<factors_24<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_24(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_24(data, FactorSlopes<factors_24<DualNumber>, 2, 1, 2>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic 2*omega1+Omega of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_25([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega1+Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega1 + Omega)*t) in v2 = harmonic_re_v2_A_v12_F*A_v1^2*F +
/// harmonic_re_v2_A_v13*A_v1^3
/// 2 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_25(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v1 * F));  // harmonic_re_v2_A_v12_F
    store_complex(column_1, i, factor[1] * (A_v1 * A_v1 * A_v1));  // harmonic_re_v2_A_v13
  }
}

/// columns[j][i] of the rows.
inline void columns_25(const BatchArrays& data, double* const* columns) {
  rows_25(data, FactorValues<factors_25<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_25(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_v1/dt + i*(w_v1 - omega1)*B_v1 = i*conservative_v1_A_v12_F*A_v1^2*F +
/// 2*i*conservative_v1_A_v12_F*A_v1*conj(A_v1)*F - mu11*A_v1 + i*conservative_v1_A_v1*A_v1 +
/// i*conservative_v1_A_v1_F2*A_v1*F^2 + 3/2*i*conservative_v1_A_v1_F2*conj(A_v1)*F^2 +
/// i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) - 3*omega1^2/2*mu13*A_v1^2*conj(A_v1) +
/// i*conservative_v1_A_v12_conjA_v1*A_v1^2*conj(A_v1) - 1/(4*omega1)*i*eta11*F +
/// i*conservative_v1_A_v2_conjA_v2_F*A_v2*conj(A_v2)*F with A = B in that frame
/// dB_v2/dt + i*(w_v2 - omega2)*B_v2 = -omega2/omega1*i*conservative_v1_A_v1*A_v2 +
/// omega1/omega2*i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*conj(A_v1)*A_v2 +
/// omega1/omega2*i*conservative_v1_A_v2_conjA_v2_F*A_v1*A_v2*F +
/// omega1/omega2*i*conservative_v1_A_v2_conjA_v2_F*conj(A_v1)*A_v2*F - mu22*A_v2 +
/// i*conservative_v2_A_v2_F2*A_v2*F^2 - 3*omega2^2/2*mu23*A_v2^2*conj(A_v2) +
/// i*conservative_v2_A_v22_conjA_v2*A_v2^2*conj(A_v2) with A = B in that frame
/// 81 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  Scalar lumps[67];
  evaluate_lumps(parameters, lumps);
  const Complex A_v1 = load_complex(amplitude, 0);
  const Complex conj_A_v1 = conjugate(A_v1);
  const Scalar norm_A_v1 = norm_of(A_v1);
  const Complex A_v2 = load_complex(amplitude, 1);
  const Scalar norm_A_v2 = norm_of(A_v2);
  const Complex F = load_complex(forcing, 0);
  const Complex conj_F = conjugate(F);
  const Scalar norm_F = norm_of(F);
  store_complex(derivative, 0, times_i(lumps[0] * (A_v1 * A_v1 * conj_F))
       + times_i(lumps[0] * Scalar(2.0) * (norm_A_v1 * F))
       + lumps[1] * (-Scalar(1.0)) * (A_v1)
       + times_i(lumps[2] * (A_v1))
       + times_i(lumps[3] * (A_v1 * norm_F))
       + times_i(lumps[3] * Scalar(3.0) / Scalar(2.0) * (conj_A_v1 * F * F))
       + times_i(lumps[4] * (A_v1 * norm_A_v2))
       + lumps[5] * (-Scalar(3.0) * omega1_2 / Scalar(2.0)) * (norm_A_v1 * A_v1)
       + times_i(lumps[6] * (norm_A_v1 * A_v1))
       + times_i(lumps[7] * (-Scalar(1.0) / (Scalar(4.0) * omega1)) * (F))
       + times_i(lumps[8] * (norm_A_v2 * F))
       - times_i((-omega1 + excitation_frequency[0]) * A_v1));
  store_complex(derivative, 1, times_i(lumps[2] * (-omega2 / omega1) * (A_v2))
       + times_i(lumps[4] * omega1 / omega2 * (norm_A_v1 * A_v2))
       + times_i(lumps[8] * omega1 / omega2 * (A_v1 * A_v2 * conj_F))
       + times_i(lumps[8] * omega1 / omega2 * (conj_A_v1 * A_v2 * F))
       + lumps[9] * (-Scalar(1.0)) * (A_v2)
       + times_i(lumps[10] * (A_v2 * norm_F))
       + lumps[11] * (-Scalar(3.0) * omega2_2 / Scalar(2.0)) * (norm_A_v2 * A_v2)
       + times_i(lumps[12] * (norm_A_v2 * A_v2)));
}

/// jacobian[i * 4 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 125 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  Scalar lumps[67];
  evaluate_lumps(parameters, lumps);
  const Complex A_v1 = load_complex(amplitude, 0);
  const Complex conj_A_v1 = conjugate(A_v1);
  const Scalar norm_A_v1 = norm_of(A_v1);
  const Complex A_v2 = load_complex(amplitude, 1);
  const Complex conj_A_v2 = conjugate(A_v2);
  const Scalar norm_A_v2 = norm_of(A_v2);
  const Complex F = load_complex(forcing, 0);
  const Complex conj_F = conjugate(F);
  const Scalar norm_F = norm_of(F);
  for (std::size_t i = 0; i < 16; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = times_i(lumps[0] * Scalar(2) * (A_v1 * conj_F))
       + times_i(lumps[0] * Scalar(2.0) * (conj_A_v1 * F))
       + Complex(lumps[1] * (-Scalar(1.0)))
       + times_i(Complex(lumps[2]))
       + times_i(Complex(lumps[3] * (norm_F)))
       + times_i(Complex(lumps[4] * (norm_A_v2)))
       + Complex(lumps[5] * (-Scalar(3.0) * omega1_2 / Scalar(2.0)) * Scalar(2) * (norm_A_v1))
       + times_i(Complex(lumps[6] * Scalar(2) * (norm_A_v1)))
       - Complex(Scalar(0.0), -omega1 + excitation_frequency[0]);
  const Complex conj_by_0_0 = times_i(lumps[0] * Scalar(2.0) * (A_v1 * F))
       + times_i(lumps[3] * Scalar(3.0) / Scalar(2.0) * (F * F))
       + lumps[5] * (-Scalar(3.0) * omega1_2 / Scalar(2.0)) * (A_v1 * A_v1)
       + times_i(lumps[6] * (A_v1 * A_v1));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[4] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[5] = by_0_0.real - conj_by_0_0.real;
  const Complex by_0_1 = times_i(lumps[4] * (A_v1 * conj_A_v2))
       + times_i(lumps[8] * (conj_A_v2 * F));
  const Complex conj_by_0_1 = times_i(lumps[4] * (A_v1 * A_v2))
       + times_i(lumps[8] * (A_v2 * F));
  jacobian[2] = by_0_1.real + conj_by_0_1.real;
  jacobian[3] = conj_by_0_1.imag - by_0_1.imag;
  jacobian[6] = by_0_1.imag + conj_by_0_1.imag;
  jacobian[7] = by_0_1.real - conj_by_0_1.real;
  const Complex by_1_0 = times_i(lumps[4] * omega1 / omega2 * (conj_A_v1 * A_v2))
       + times_i(lumps[8] * omega1 / omega2 * (A_v2 * conj_F));
  const Complex conj_by_1_0 = times_i(lumps[4] * omega1 / omega2 * (A_v1 * A_v2))
       + times_i(lumps[8] * omega1 / omega2 * (A_v2 * F));
  jacobian[8] = by_1_0.real + conj_by_1_0.real;
  jacobian[9] = conj_by_1_0.imag - by_1_0.imag;
  jacobian[12] = by_1_0.imag + conj_by_1_0.imag;
  jacobian[13] = by_1_0.real - conj_by_1_0.real;
  const Complex by_1_1 = times_i(Complex(lumps[2] * (-omega2 / omega1)))
       + times_i(Complex(lumps[4] * omega1 / omega2 * (norm_A_v1)))
       + times_i(lumps[8] * omega1 / omega2 * (A_v1 * conj_F))
       + times_i(lumps[8] * omega1 / omega2 * (conj_A_v1 * F))
       + Complex(lumps[9] * (-Scalar(1.0)))
       + times_i(Complex(lumps[10] * (norm_F)))
       + Complex(lumps[11] * (-Scalar(3.0) * omega2_2 / Scalar(2.0)) * Scalar(2) * (norm_A_v2))
       + times_i(Complex(lumps[12] * Scalar(2) * (norm_A_v2)));
  const Complex conj_by_1_1 = lumps[11] * (-Scalar(3.0) * omega2_2 / Scalar(2.0)) * (A_v2 * A_v2)
       + times_i(lumps[12] * (A_v2 * A_v2));
  jacobian[10] = by_1_1.real + conj_by_1_1.real;
  jacobian[11] = conj_by_1_1.imag - by_1_1.imag;
  jacobian[14] = by_1_1.imag + conj_by_1_1.imag;
  jacobian[15] = by_1_1.real - conj_by_1_1.real;
}

}  // namespace primary_1

namespace primary_2 {

/// Lumps: the parameter combinations that multiply data.
/// lumps[1]: mu11 = mu11
/// lumps[5]: mu13 = mu13
/// lumps[7]: conservative_v2_A_v22_F = (-3*omega2^2*delta24*eta22 + 5*alpha24*eta22)/(12*omega2^3)
/// lumps[8]: mu22 = mu22
/// lumps[9]: conservative_v2_A_v2_F2 = -eta22^2/(12*omega2^3)
/// lumps[10]: mu23 = mu23
/// lumps[12]: eta21 = eta21
/// lumps[13]: eta12 = eta12
/// lumps[16]: harmonic_re_v1_A_v2_conjA_v2 = (2*omega2^2*delta23 - 2*alpha23)/omega1^2
/// lumps[17]: harmonic_re_v1_A_v1_conjA_v1 = (2*omega1^2*delta21 - 2*alpha21)/omega1^2
/// lumps[19]: mu12 = mu12
/// lumps[20]: eta11 = eta11
/// lumps[31]: harmonic_re_v1_A_v12 = (-3*omega1^2*delta21 + alpha21)/(3*omega1^2)
/// lumps[46]: eta22 = eta22
/// lumps[47]: harmonic_re_v2_A_v2_conjA_v2 = (2*omega2^2*delta24 - 2*alpha24)/omega2^2
/// lumps[48]: harmonic_re_v2_A_v1_conjA_v1 = (2*omega1^2*delta22 - 2*alpha22)/omega2^2
/// lumps[49]: harmonic_re_v2_A_v22 = (-3*omega2^2*delta24 + alpha24)/(3*omega2^2)
/// lumps[51]: mu21 = mu21
/// lumps[65]: harmonic_re_v2_A_v22_F = (17*omega2^2*delta24*eta22 - 3*alpha24*eta22)/(48*omega2^4)
/// 48 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu11 = parameters[2];
  const Scalar mu12 = parameters[3];
  const Scalar mu13 = parameters[4];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar eta11 = parameters[20];
  const Scalar eta12 = parameters[21];
  const Scalar mu22 = parameters[22];
  const Scalar mu21 = parameters[23];
  const Scalar mu23 = parameters[24];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar eta21 = parameters[29];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar eta22_2 = eta22 * eta22;
  lumps[0] = lump_48(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v1_A_v2_F
  lumps[1] = mu11;  // mu11
  lumps[2] = lump_0(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v1
  lumps[3] = lump_49(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v1_F2
  lumps[4] = lump_1(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v1_A_v2_conjA_v2
  lumps[5] = mu13;  // mu13
  lumps[6] = lump_2(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v12_conjA_v1
  // conservative_v2_A_v22_F
  lumps[7] = (-Scalar(3.0) * omega2_2 * delta24 * eta22
      + Scalar(5.0) * alpha24 * eta22) / (Scalar(12.0) * omega2_3);
  lumps[8] = mu22;  // mu22
  lumps[9] = -eta22_2 / (Scalar(12.0) * omega2_3);  // conservative_v2_A_v2_F2
  lumps[10] = mu23;  // mu23
  lumps[11] = lump_5(parameters, static_cast<Scalar*>(nullptr));  // conservative_v2_A_v22_conjA_v2
  lumps[12] = eta21;  // eta21
  lumps[13] = eta12;  // eta12
  lumps[14] = lump_6(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v2_conjA_v1
  lumps[15] = lump_7(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v2_conjA_v1
  // harmonic_re_v1_A_v2_conjA_v2
  lumps[16] = (Scalar(2.0) * omega2_2 * delta23 - Scalar(2.0) * alpha23) / omega1_2;
  // harmonic_re_v1_A_v1_conjA_v1
  lumps[17] = (Scalar(2.0) * omega1_2 * delta21 - Scalar(2.0) * alpha21) / omega1_2;
  lumps[18] = lump_50(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_conjA_v2_F
  lumps[19] = mu12;  // mu12
  lumps[20] = eta11;  // eta11
  lumps[21] = lump_51(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v2_conjA_v2_F
  lumps[22] = lump_52(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_conjA_v1_F
  lumps[23] = lump_10(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v22_conjA_v2
  lumps[24] = lump_11(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_A_v2_conjA_v1
  lumps[25] = lump_53(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v22_F
  lumps[26] = lump_13(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v22
  lumps[27] = lump_54(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v2_F
  lumps[28] = lump_14(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v22
  lumps[29] = lump_16(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_A_v2
  lumps[30] = lump_17(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v1_A_v2
  lumps[31] = (-Scalar(3.0) * omega1_2 * delta21 + alpha21) / (Scalar(3.0) * omega1_2);  // harmonic_re_v1_A_v12
  lumps[32] = lump_15(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v12
  lumps[33] = lump_55(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_conjA_v12_F
  lumps[34] = lump_18(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v2_conjA_v12
  lumps[35] = lump_56(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v2_conjA_v1_F
  lumps[36] = lump_19(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v22_conjA_v1
  lumps[37] = lump_22(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v23
  lumps[38] = lump_57(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_A_v2_F
  lumps[39] = lump_21(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_A_v22
  lumps[40] = lump_58(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v12_F
  lumps[41] = lump_24(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v12_A_v2
  lumps[42] = lump_23(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v13
  lumps[43] = lump_25(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v2_conjA_v1
  lumps[44] = lump_59(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_conjA_v1_F
  lumps[45] = lump_26(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v2_conjA_v1
  lumps[46] = eta22;  // eta22
  // harmonic_re_v2_A_v2_conjA_v2
  lumps[47] = (Scalar(2.0) * omega2_2 * delta24 - Scalar(2.0) * alpha24) / omega2_2;
  // harmonic_re_v2_A_v1_conjA_v1
  lumps[48] = (Scalar(2.0) * omega1_2 * delta22 - Scalar(2.0) * alpha22) / omega2_2;
  lumps[49] = (-Scalar(3.0) * omega2_2 * delta24 + alpha24) / (Scalar(3.0) * omega2_2);  // harmonic_re_v2_A_v22
  lumps[50] = lump_30(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v22
  lumps[51] = mu21;  // mu21
  lumps[52] = lump_60(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_conjA_v2_F
  lumps[53] = lump_33(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_A_v2_conjA_v2
  lumps[54] = lump_34(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v12_conjA_v1
  lumps[55] = lump_61(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_A_v2_F
  lumps[56] = lump_28(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_A_v2
  lumps[57] = lump_62(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v1_F
  lumps[58] = lump_29(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v1_A_v2
  lumps[59] = lump_36(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v12
  lumps[60] = lump_38(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v12
  lumps[61] = lump_63(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_conjA_v12_F
  lumps[62] = lump_39(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v2_conjA_v12
  lumps[63] = lump_64(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v2_conjA_v1_F
  lumps[64] = lump_41(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v22_conjA_v1
  // harmonic_re_v2_A_v22_F
  lumps[65] = (Scalar(17.0) * omega2_2 * delta24 * eta22
      - Scalar(3.0) * alpha24 * eta22) / (Scalar(48.0) * omega2_4);
  lumps[66] = lump_46(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v23
  lumps[67] = lump_45(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_A_v22
  lumps[68] = lump_65(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v12_F
  lumps[69] = lump_44(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v12_A_v2
  lumps[70] = lump_47(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v13
}

/// jacobian[l * 31 + p] = d lumps[l] / d parameters[p]. 79 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar eta22_2 = eta22 * eta22;
  for (std::size_t i = 0; i < 2201; ++i) jacobian[i] = Scalar(0.0);
  lump_48(parameters, jacobian + 0);  // d conservative_v1_A_v1_A_v2_F
  jacobian[33] = Scalar(1.0);  // d mu11 / d mu11
  lump_0(parameters, jacobian + 62);  // d conservative_v1_A_v1
  lump_49(parameters, jacobian + 93);  // d conservative_v1_A_v1_F2
  lump_1(parameters, jacobian + 124);  // d conservative_v1_A_v1_A_v2_conjA_v2
  jacobian[159] = Scalar(1.0);  // d mu13 / d mu13
  lump_2(parameters, jacobian + 186);  // d conservative_v1_A_v12_conjA_v1
  // d conservative_v2_A_v22_F / d omega2
  jacobian[218] = (omega2_2 * delta24 * eta22 - Scalar(5.0) * alpha24 * eta22) / (Scalar(4.0) * omega2_4);
  jacobian[242] = Scalar(5.0) * eta22 / (Scalar(12.0) * omega2_3);  // d conservative_v2_A_v22_F / d alpha24
  jacobian[243] = -eta22 / (Scalar(4.0) * omega2);  // d conservative_v2_A_v22_F / d delta24
  // d conservative_v2_A_v22_F / d eta22
  jacobian[247] = (-Scalar(3.0) * omega2_2 * delta24 + Scalar(5.0) * alpha24) / (Scalar(12.0) * omega2_3);
  jacobian[270] = Scalar(1.0);  // d mu22 / d mu22
  jacobian[280] = eta22_2 / (Scalar(4.0) * omega2_4);  // d conservative_v2_A_v2_F2 / d omega2
  jacobian[309] = -eta22 / (Scalar(6.0) * omega2_3);  // d conservative_v2_A_v2_F2 / d eta22
  jacobian[334] = Scalar(1.0);  // d mu23 / d mu23
  lump_5(parameters, jacobian + 341);  // d conservative_v2_A_v22_conjA_v2
  jacobian[401] = Scalar(1.0);  // d eta21 / d eta21
  jacobian[424] = Scalar(1.0);  // d eta12 / d eta12
  lump_6(parameters, jacobian + 434);  // d harmonic_re_v1_A_v2_conjA_v1
  lump_7(parameters, jacobian + 465);  // d harmonic_im_v1_A_v2_conjA_v1
  // d harmonic_re_v1_A_v2_conjA_v2 / d omega1
  jacobian[496] = (-Scalar(4.0) * omega2_2 * delta23 + Scalar(4.0) * alpha23) / omega1_3;
  jacobian[497] = Scalar(4.0) * omega2 * delta23 / omega1_2;  // d harmonic_re_v1_A_v2_conjA_v2 / d omega2
  jacobian[503] = -Scalar(2.0) / omega1_2;  // d harmonic_re_v1_A_v2_conjA_v2 / d alpha23
  jacobian[506] = Scalar(2.0) * omega2_2 / omega1_2;  // d harmonic_re_v1_A_v2_conjA_v2 / d delta23
  jacobian[527] = Scalar(4.0) * alpha21 / omega1_3;  // d harmonic_re_v1_A_v1_conjA_v1 / d omega1
  jacobian[532] = -Scalar(2.0) / omega1_2;  // d harmonic_re_v1_A_v1_conjA_v1 / d alpha21
  jacobian[535] = Scalar(2.0);  // d harmonic_re_v1_A_v1_conjA_v1 / d delta21
  lump_50(parameters, jacobian + 558);  // d harmonic_im_v1_conjA_v2_F
  jacobian[592] = Scalar(1.0);  // d mu12 / d mu12
  jacobian[640] = Scalar(1.0);  // d eta11 / d eta11
  lump_51(parameters, jacobian + 651);  // d harmonic_re_v1_A_v2_conjA_v2_F
  lump_52(parameters, jacobian + 682);  // d harmonic_re_v1_A_v1_conjA_v1_F
  lump_10(parameters, jacobian + 713);  // d harmonic_re_v1_A_v22_conjA_v2
  lump_11(parameters, jacobian + 744);  // d harmonic_re_v1_A_v1_A_v2_conjA_v1
  lump_53(parameters, jacobian + 775);  // d harmonic_re_v1_A_v22_F
  lump_13(parameters, jacobian + 806);  // d harmonic_re_v1_A_v22
  lump_54(parameters, jacobian + 837);  // d harmonic_im_v1_A_v2_F
  lump_14(parameters, jacobian + 868);  // d harmonic_im_v1_A_v22
  lump_16(parameters, jacobian + 899);  // d harmonic_re_v1_A_v1_A_v2
  lump_17(parameters, jacobian + 930);  // d harmonic_im_v1_A_v1_A_v2
  jacobian[961] = -Scalar(2.0) * alpha21 / (Scalar(3.0) * omega1_3);  // d harmonic_re_v1_A_v12 / d omega1
  jacobian[966] = Scalar(1.0) / (Scalar(3.0) * omega1_2);  // d harmonic_re_v1_A_v12 / d alpha21
  jacobian[969] = -Scalar(1.0);  // d harmonic_re_v1_A_v12 / d delta21
  lump_15(parameters, jacobian + 992);  // d harmonic_im_v1_A_v12
  lump_55(parameters, jacobian + 1023);  // d harmonic_re_v1_conjA_v12_F
  lump_18(parameters, jacobian + 1054);  // d harmonic_re_v1_A_v2_conjA_v12
  lump_56(parameters, jacobian + 1085);  // d harmonic_re_v1_A_v2_conjA_v1_F
  lump_19(parameters, jacobian + 1116);  // d harmonic_re_v1_A_v22_conjA_v1
  lump_22(parameters, jacobian + 1147);  // d harmonic_re_v1_A_v23
  lump_57(parameters, jacobian + 1178);  // d harmonic_re_v1_A_v1_A_v2_F
  lump_21(parameters, jacobian + 1209);  // d harmonic_re_v1_A_v1_A_v22
  lump_58(parameters, jacobian + 1240);  // d harmonic_re_v1_A_v12_F
  lump_24(parameters, jacobian + 1271);  // d harmonic_re_v1_A_v12_A_v2
  lump_23(parameters, jacobian + 1302);  // d harmonic_re_v1_A_v13
  lump_25(parameters, jacobian + 1333);  // d harmonic_re_v2_A_v2_conjA_v1
  lump_59(parameters, jacobian + 1364);  // d harmonic_im_v2_conjA_v1_F
  lump_26(parameters, jacobian + 1395);  // d harmonic_im_v2_A_v2_conjA_v1
  jacobian[1456] = Scalar(1.0);  // d eta22 / d eta22
  jacobian[1458] = Scalar(4.0) * alpha24 / omega2_3;  // d harmonic_re_v2_A_v2_conjA_v2 / d omega2
  jacobian[1482] = -Scalar(2.0) / omega2_2;  // d harmonic_re_v2_A_v2_conjA_v2 / d alpha24
  jacobian[1483] = Scalar(2.0);  // d harmonic_re_v2_A_v2_conjA_v2 / d delta24
  jacobian[1488] = Scalar(4.0) * omega1 * delta22 / omega2_2;  // d harmonic_re_v2_A_v1_conjA_v1 / d omega1
  // d harmonic_re_v2_A_v1_conjA_v1 / d omega2
  jacobian[1489] = (-Scalar(4.0) * omega1_2 * delta22 + Scalar(4.0) * alpha22) / omega2_3;
  jacobian[1494] = -Scalar(2.0) / omega2_2;  // d harmonic_re_v2_A_v1_conjA_v1 / d alpha22
  jacobian[1497] = Scalar(2.0) * omega1_2 / omega2_2;  // d harmonic_re_v2_A_v1_conjA_v1 / d delta22
  jacobian[1520] = -Scalar(2.0) * alpha24 / (Scalar(3.0) * omega2_3);  // d harmonic_re_v2_A_v22 / d omega2
  jacobian[1544] = Scalar(1.0) / (Scalar(3.0) * omega2_2);  // d harmonic_re_v2_A_v22 / d alpha24
  jacobian[1545] = -Scalar(1.0);  // d harmonic_re_v2_A_v22 / d delta24
  lump_30(parameters, jacobian + 1550);  // d harmonic_im_v2_A_v22
  jacobian[1604] = Scalar(1.0);  // d mu21 / d mu21
  lump_60(parameters, jacobian + 1612);  // d harmonic_re_v2_A_v1_conjA_v2_F
  lump_33(parameters, jacobian + 1643);  // d harmonic_re_v2_A_v1_A_v2_conjA_v2
  lump_34(parameters, jacobian + 1674);  // d harmonic_re_v2_A_v12_conjA_v1
  lump_61(parameters, jacobian + 1705);  // d harmonic_re_v2_A_v1_A_v2_F
  lump_28(parameters, jacobian + 1736);  // d harmonic_re_v2_A_v1_A_v2
  lump_62(parameters, jacobian + 1767);  // d harmonic_im_v2_A_v1_F
  lump_29(parameters, jacobian + 1798);  // d harmonic_im_v2_A_v1_A_v2
  lump_36(parameters, jacobian + 1829);  // d harmonic_re_v2_A_v12
  lump_38(parameters, jacobian + 1860);  // d harmonic_im_v2_A_v12
  lump_63(parameters, jacobian + 1891);  // d harmonic_re_v2_conjA_v12_F
  lump_39(parameters, jacobian + 1922);  // d harmonic_re_v2_A_v2_conjA_v12
  lump_64(parameters, jacobian + 1953);  // d harmonic_re_v2_A_v2_conjA_v1_F
  lump_41(parameters, jacobian + 1984);  // d harmonic_re_v2_A_v22_conjA_v1
  // d harmonic_re_v2_A_v22_F / d omega2
  jacobian[2016] = (-Scalar(17.0) * omega2_2 * delta24 * eta22
      + Scalar(6.0) * alpha24 * eta22) / (Scalar(24.0) * omega2_5);
  jacobian[2040] = -eta22 / (Scalar(16.0) * omega2_4);  // d harmonic_re_v2_A_v22_F / d alpha24
  jacobian[2041] = Scalar(17.0) * eta22 / (Scalar(48.0) * omega2_2);  // d harmonic_re_v2_A_v22_F / d delta24
  // d harmonic_re_v2_A_v22_F / d eta22
  jacobian[2045] = (Scalar(17.0) * omega2_2 * delta24 - Scalar(3.0) * alpha24) / (Scalar(48.0) * omega2_4);
  lump_46(parameters, jacobian + 2046);  // d harmonic_re_v2_A_v23
  lump_45(parameters, jacobian + 2077);  // d harmonic_re_v2_A_v1_A_v22
  lump_65(parameters, jacobian + 2108);  // d harmonic_re_v2_A_v12_F
  lump_44(parameters, jacobian + 2139);  // d harmonic_re_v2_A_v12_A_v2
  lump_47(parameters, jacobian + 2170);  // d harmonic_re_v2_A_v13
}

/// What multiplies the 8 terms of the modulation of v1: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = -Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
  factor[6] = -Scalar(3.0) * omega1_2 / Scalar(2.0);
  factor[7] = Scalar(1.0);
}

/// Rows of the modulation of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega1)*A_v1 = i*conservative_v1_A_v1_A_v2_F*A_v1*A_v2*F +
/// i*conservative_v1_A_v1_A_v2_F*A_v1*conj(A_v2)*F - mu11*A_v1 + i*conservative_v1_A_v1*A_v1 +
/// i*conservative_v1_A_v1_F2*A_v1*F^2 + i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) -
/// 3*omega1^2/2*mu13*A_v1^2*conj(A_v1) + i*conservative_v1_A_v12_conjA_v1*A_v1^2*conj(A_v1)
/// 7 columns; per observation at most 25 products and sums of complex numbers.
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex conj_A_v2 = conjugate(A_v2);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    const Scalar norm_F = norm_of(F);
    // conservative_v1_A_v1_A_v2_F
    store_complex(column_0, i, times_i(factor[0] * (A_v1 * A_v2 * conj_F))
        + times_i(factor[1] * (A_v1 * conj_A_v2 * F)));
    store_complex(column_1, i, factor[2] * (A_v1));  // mu11
    store_complex(column_2, i, times_i(factor[3] * (A_v1)));  // conservative_v1_A_v1
    store_complex(column_3, i, times_i(factor[4] * (A_v1 * norm_F)));  // conservative_v1_A_v1_F2
    store_complex(column_4, i, times_i(factor[5] * (A_v1 * norm_A_v2)));  // conservative_v1_A_v1_A_v2_conjA_v2
    store_complex(column_5, i, factor[6] * (norm_A_v1 * A_v1));  // mu13
    store_complex(column_6, i, times_i(factor[7] * (norm_A_v1 * A_v1)));  // conservative_v1_A_v12_conjA_v1
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

/// What multiplies the 11 terms of the modulation of v2: functions of the frequencies alone. 9 operations.
template <class Scalar>
void factors_1([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega2_2 = omega2 * omega2;
  factor[0] = omega1 / omega2;
  factor[1] = -omega2 / omega1;
  factor[2] = omega1 / omega2;
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(2.0);
  factor[5] = -Scalar(1.0);
  factor[6] = Scalar(1.0);
  factor[7] = Scalar(3.0) / Scalar(2.0);
  factor[8] = -Scalar(3.0) * omega2_2 / Scalar(2.0);
  factor[9] = Scalar(1.0);
  factor[10] = -Scalar(1.0) / (Scalar(4.0) * omega2);
}

/// Rows of the modulation of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega2)*A_v2 = omega1/omega2*i*conservative_v1_A_v1_A_v2_F*A_v1*conj(A_v1)*F -
/// omega2/omega1*i*conservative_v1_A_v1*A_v2 +
/// omega1/omega2*i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*conj(A_v1)*A_v2 + i*conservative_v2_A_v22_F*A_v2^2*F
/// + 2*i*conservative_v2_A_v22_F*A_v2*conj(A_v2)*F - mu22*A_v2 + i*conservative_v2_A_v2_F2*A_v2*F^2 +
/// 3/2*i*conservative_v2_A_v2_F2*conj(A_v2)*F^2 - 3*omega2^2/2*mu23*A_v2^2*conj(A_v2) +
/// i*conservative_v2_A_v22_conjA_v2*A_v2^2*conj(A_v2) - 1/(4*omega2)*i*eta21*F
/// 9 columns; per observation at most 33 products and sums of complex numbers.
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
  Scalar factor[11];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex conj_A_v2 = conjugate(A_v2);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    const Scalar norm_F = norm_of(F);
    store_complex(column_0, i, times_i(factor[0] * (norm_A_v1 * F)));  // conservative_v1_A_v1_A_v2_F
    store_complex(column_1, i, times_i(factor[1] * (A_v2)));  // conservative_v1_A_v1
    store_complex(column_2, i, times_i(factor[2] * (norm_A_v1 * A_v2)));  // conservative_v1_A_v1_A_v2_conjA_v2
    // conservative_v2_A_v22_F
    store_complex(column_3, i, times_i(factor[3] * (A_v2 * A_v2 * conj_F))
        + times_i(factor[4] * (norm_A_v2 * F)));
    store_complex(column_4, i, factor[5] * (A_v2));  // mu22
    // conservative_v2_A_v2_F2
    store_complex(column_5, i, times_i(factor[6] * (A_v2 * norm_F)) + times_i(factor[7] * (conj_A_v2 * F * F)));
    store_complex(column_6, i, factor[8] * (norm_A_v2 * A_v2));  // mu23
    store_complex(column_7, i, times_i(factor[9] * (norm_A_v2 * A_v2)));  // conservative_v2_A_v22_conjA_v2
    store_complex(column_8, i, times_i(factor[10] * (F)));  // eta21
  }
}

/// columns[j][i] of the rows.
inline void columns_1(const BatchArrays& data, double* const* columns) {
  rows_1(data, FactorValues<factors_1<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_1(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_1(data, FactorSlopes<factors_1<DualNumber>, 2, 1, 11>{mode}, columns);
}

/// What multiplies the 3 terms of the harmonic -omega1+Omega of v1: functions of the frequencies alone. 5
/// operations.
template <class Scalar>
void factors_2([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 - Omega);
  factor[0] = per_0 / (Scalar(2.0) * Omega);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic -omega1+Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + Omega)*t) in v1 = 1/(2*Omega*(2*omega1 - Omega))*eta12*conj(A_v1)*F +
/// harmonic_re_v1_A_v2_conjA_v1*conj(A_v1)*A_v2 + i*harmonic_im_v1_A_v2_conjA_v1*conj(A_v1)*A_v2
/// 3 columns; per observation at most 9 products and sums of complex numbers.
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
  Scalar factor[3];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * F));  // eta12
    store_complex(column_1, i, factor[1] * (conj_A_v1 * A_v2));  // harmonic_re_v1_A_v2_conjA_v1
    store_complex(column_2, i, times_i(factor[2] * (conj_A_v1 * A_v2)));  // harmonic_im_v1_A_v2_conjA_v1
  }
}

/// columns[j][i] of the rows.
inline void columns_2(const BatchArrays& data, double* const* columns) {
  rows_2(data, FactorValues<factors_2<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_2(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_2(data, FactorSlopes<factors_2<DualNumber>, 2, 1, 3>{mode}, columns);
}

/// What multiplies the 4 terms of the harmonic 0 of v1: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_3([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = -Scalar(1.0);
}

/// Rows of the harmonic 0 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in v1 = harmonic_re_v1_A_v2_conjA_v2*A_v2*conj(A_v2) +
/// harmonic_re_v1_A_v1_conjA_v1*A_v1*conj(A_v1) + i*harmonic_im_v1_conjA_v2_F*conj(A_v2)*F -
/// i*harmonic_im_v1_conjA_v2_F*A_v2*F
/// 3 columns; per observation at most 9 products and sums of complex numbers.
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
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex conj_A_v2 = conjugate(A_v2);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    store_complex(column_0, i, Complex(factor[0] * (norm_A_v2)));  // harmonic_re_v1_A_v2_conjA_v2
    store_complex(column_1, i, Complex(factor[1] * (norm_A_v1)));  // harmonic_re_v1_A_v1_conjA_v1
    // harmonic_im_v1_conjA_v2_F
    store_complex(column_2, i, times_i(factor[2] * (conj_A_v2 * F)) + times_i(factor[3] * (A_v2 * conj_F)));
  }
}

/// columns[j][i] of the rows.
inline void columns_3(const BatchArrays& data, double* const* columns) {
  rows_3(data, FactorValues<factors_3<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_3(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 7 terms of the harmonic Omega of v1: functions of the frequencies alone. 8 operations.
template <class Scalar>
void factors_4([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  factor[0] = -omega2 * per_0 * per_1;
  factor[1] = per_0 * per_1 / Scalar(2.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
  factor[6] = Scalar(1.0);
}

/// Rows of the harmonic Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(Omega)*t) in v1 = -omega2/((omega1 + omega2)*(omega1 - omega2))*i*mu12*A_v2 +
/// 1/(2*(omega1 + omega2)*(omega1 - omega2))*eta11*F + harmonic_re_v1_A_v2_conjA_v2_F*A_v2*conj(A_v2)*F +
/// harmonic_re_v1_A_v1_conjA_v1_F*A_v1*conj(A_v1)*F + harmonic_re_v1_A_v22_conjA_v2*A_v2^2*conj(A_v2) +
/// harmonic_re_v1_A_v1_A_v2_conjA_v1*A_v1*conj(A_v1)*A_v2 + harmonic_re_v1_A_v22_F*A_v2^2*F
/// 7 columns; per observation at most 19 products and sums of complex numbers.
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
  Scalar* __restrict column_5 = columns[5];
  Scalar* __restrict column_6 = columns[6];
  Scalar factor[7];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    store_complex(column_0, i, times_i(factor[0] * (A_v2)));  // mu12
    store_complex(column_1, i, factor[1] * (F));  // eta11
    store_complex(column_2, i, factor[2] * (norm_A_v2 * F));  // harmonic_re_v1_A_v2_conjA_v2_F
    store_complex(column_3, i, factor[3] * (norm_A_v1 * F));  // harmonic_re_v1_A_v1_conjA_v1_F
    store_complex(column_4, i, factor[4] * (norm_A_v2 * A_v2));  // harmonic_re_v1_A_v22_conjA_v2
    store_complex(column_5, i, factor[5] * (norm_A_v1 * A_v2));  // harmonic_re_v1_A_v1_A_v2_conjA_v1
    store_complex(column_6, i, factor[6] * (A_v2 * A_v2 * conj_F));  // harmonic_re_v1_A_v22_F
  }
}

/// columns[j][i] of the rows.
inline void columns_4(const BatchArrays& data, double* const* columns) {
  rows_4(data, FactorValues<factors_4<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_4(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_4(data, FactorSlopes<factors_4<DualNumber>, 2, 1, 7>{mode}, columns);
}

/// What multiplies the 3 terms of the harmonic omega2+Omega of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_5([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega2+Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + Omega)*t) in v1 = harmonic_re_v1_A_v22*A_v2^2 + i*harmonic_im_v1_A_v2_F*A_v2*F +
/// i*harmonic_im_v1_A_v22*A_v2^2
/// 3 columns; per observation at most 9 products and sums of complex numbers.
template <class Factors>
void rows_5(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[3];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v2 * A_v2));  // harmonic_re_v1_A_v22
    store_complex(column_1, i, times_i(factor[1] * (A_v2 * F)));  // harmonic_im_v1_A_v2_F
    store_complex(column_2, i, times_i(factor[2] * (A_v2 * A_v2)));  // harmonic_im_v1_A_v22
  }
}

/// columns[j][i] of the rows.
inline void columns_5(const BatchArrays& data, double* const* columns) {
  rows_5(data, FactorValues<factors_5<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_5(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 3 terms of the harmonic omega1+Omega of v1: functions of the frequencies alone. 5
/// operations.
template <class Scalar>
void factors_6([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + Omega);
  factor[0] = -per_0 / (Scalar(2.0) * Omega);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega1+Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + Omega)*t) in v1 = -1/(2*Omega*(2*omega1 + Omega))*eta12*A_v1*F +
/// harmonic_re_v1_A_v1_A_v2*A_v1*A_v2 + i*harmonic_im_v1_A_v1_A_v2*A_v1*A_v2
/// 3 columns; per observation at most 9 products and sums of complex numbers.
template <class Factors>
void rows_6(const BatchArrays& data, Factors factors, double* const* columns) {
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
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * F));  // eta12
    store_complex(column_1, i, factor[1] * (A_v1 * A_v2));  // harmonic_re_v1_A_v1_A_v2
    store_complex(column_2, i, times_i(factor[2] * (A_v1 * A_v2)));  // harmonic_im_v1_A_v1_A_v2
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

/// What multiplies the 2 terms of the harmonic 2*omega1 of v1: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_7([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega1 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega1)*t) in v1 = harmonic_re_v1_A_v12*A_v1^2 + i*harmonic_im_v1_A_v12*A_v1^2
/// 2 columns; per observation at most 6 products and sums of complex numbers.
template <class Factors>
void rows_7(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v1));  // harmonic_re_v1_A_v12
    store_complex(column_1, i, times_i(factor[1] * (A_v1 * A_v1)));  // harmonic_im_v1_A_v12
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

/// What multiplies the 2 terms of the harmonic -2*omega1+Omega of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_8([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic -2*omega1+Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-2*omega1 + Omega)*t) in v1 = harmonic_re_v1_conjA_v12_F*conj(A_v1)^2*F +
/// harmonic_re_v1_A_v2_conjA_v12*conj(A_v1)^2*A_v2
/// 2 columns; per observation at most 10 products and sums of complex numbers.
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
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * conj_A_v1 * F));  // harmonic_re_v1_conjA_v12_F
    store_complex(column_1, i, factor[1] * (conj_A_v1 * conj_A_v1 * A_v2));  // harmonic_re_v1_A_v2_conjA_v12
  }
}

/// columns[j][i] of the rows.
inline void columns_8(const BatchArrays& data, double* const* columns) {
  rows_8(data, FactorValues<factors_8<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_8(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 3 terms of the harmonic -omega1+2*Omega of v1: functions of the frequencies alone. 10
/// operations.
template <class Scalar>
void factors_9([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 - omega2);
  factor[0] = (-Scalar(2.0) * omega1_2 - omega1 * omega2) * per_0 / (Scalar(4.0) * omega2_2);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic -omega1+2*Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + 2*Omega)*t) in v1 = (-2*omega1^2 - omega1*omega2)/(4*omega2^2*(omega1 -
/// omega2))*conservative_v1_A_v1_F2*conj(A_v1)*F^2 + harmonic_re_v1_A_v2_conjA_v1_F*conj(A_v1)*A_v2*F +
/// harmonic_re_v1_A_v22_conjA_v1*conj(A_v1)*A_v2^2
/// 3 columns; per observation at most 15 products and sums of complex numbers.
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
  Scalar factor[3];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * F * F));  // conservative_v1_A_v1_F2
    store_complex(column_1, i, factor[1] * (conj_A_v1 * A_v2 * F));  // harmonic_re_v1_A_v2_conjA_v1_F
    store_complex(column_2, i, factor[2] * (conj_A_v1 * A_v2 * A_v2));  // harmonic_re_v1_A_v22_conjA_v1
  }
}

/// columns[j][i] of the rows.
inline void columns_9(const BatchArrays& data, double* const* columns) {
  rows_9(data, FactorValues<factors_9<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_9(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_9(data, FactorSlopes<factors_9<DualNumber>, 2, 1, 3>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic 2*omega2+Omega of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_10([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega2+Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega2 + Omega)*t) in v1 = harmonic_re_v1_A_v22_F*A_v2^2*F +
/// harmonic_re_v1_A_v23*A_v2^3
/// 2 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_10(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v2 * A_v2 * F));  // harmonic_re_v1_A_v22_F
    store_complex(column_1, i, factor[1] * (A_v2 * A_v2 * A_v2));  // harmonic_re_v1_A_v23
  }
}

/// columns[j][i] of the rows.
inline void columns_10(const BatchArrays& data, double* const* columns) {
  rows_10(data, FactorValues<factors_10<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_10(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 3 terms of the harmonic omega1+2*Omega of v1: functions of the frequencies alone. 10
/// operations.
template <class Scalar>
void factors_11([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  factor[0] = (-Scalar(2.0) * omega1_2 + omega1 * omega2) * per_0 / (Scalar(4.0) * omega2_2);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega1+2*Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + 2*Omega)*t) in v1 = (-2*omega1^2 + omega1*omega2)/(4*omega2^2*(omega1 +
/// omega2))*conservative_v1_A_v1_F2*A_v1*F^2 + harmonic_re_v1_A_v1_A_v2_F*A_v1*A_v2*F +
/// harmonic_re_v1_A_v1_A_v22*A_v1*A_v2^2
/// 3 columns; per observation at most 15 products and sums of complex numbers.
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
  Scalar factor[3];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * F * F));  // conservative_v1_A_v1_F2
    store_complex(column_1, i, factor[1] * (A_v1 * A_v2 * F));  // harmonic_re_v1_A_v1_A_v2_F
    store_complex(column_2, i, factor[2] * (A_v1 * A_v2 * A_v2));  // harmonic_re_v1_A_v1_A_v22
  }
}

/// columns[j][i] of the rows.
inline void columns_11(const BatchArrays& data, double* const* columns) {
  rows_11(data, FactorValues<factors_11<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_11(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_11(data, FactorSlopes<factors_11<DualNumber>, 2, 1, 3>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic 2*omega1+Omega of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_12([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega1+Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega1 + Omega)*t) in v1 = harmonic_re_v1_A_v12_F*A_v1^2*F +
/// harmonic_re_v1_A_v12_A_v2*A_v1^2*A_v2
/// 2 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_12(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v1 * F));  // harmonic_re_v1_A_v12_F
    store_complex(column_1, i, factor[1] * (A_v1 * A_v1 * A_v2));  // harmonic_re_v1_A_v12_A_v2
  }
}

/// columns[j][i] of the rows.
inline void columns_12(const BatchArrays& data, double* const* columns) {
  rows_12(data, FactorValues<factors_12<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_12(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 2 terms of the harmonic 3*omega1 of v1: functions of the frequencies alone. 1 operations.
template <class Scalar>
void factors_13([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  factor[0] = -omega1 / Scalar(8.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic 3*omega1 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega1)*t) in v1 = -omega1/8*i*mu13*A_v1^3 + harmonic_re_v1_A_v13*A_v1^3
/// 2 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_13(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    store_complex(column_0, i, times_i(factor[0] * (A_v1 * A_v1 * A_v1)));  // mu13
    store_complex(column_1, i, factor[1] * (A_v1 * A_v1 * A_v1));  // harmonic_re_v1_A_v13
  }
}

/// columns[j][i] of the rows.
inline void columns_13(const BatchArrays& data, double* const* columns) {
  rows_13(data, FactorValues<factors_13<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_13(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_13(data, FactorSlopes<factors_13<DualNumber>, 2, 1, 2>{mode}, columns);
}

/// What multiplies the 3 terms of the harmonic -omega1+Omega of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_14([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic -omega1+Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + Omega)*t) in v2 = harmonic_re_v2_A_v2_conjA_v1*conj(A_v1)*A_v2 +
/// i*harmonic_im_v2_conjA_v1_F*conj(A_v1)*F + i*harmonic_im_v2_A_v2_conjA_v1*conj(A_v1)*A_v2
/// 3 columns; per observation at most 9 products and sums of complex numbers.
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * A_v2));  // harmonic_re_v2_A_v2_conjA_v1
    store_complex(column_1, i, times_i(factor[1] * (conj_A_v1 * F)));  // harmonic_im_v2_conjA_v1_F
    store_complex(column_2, i, times_i(factor[2] * (conj_A_v1 * A_v2)));  // harmonic_im_v2_A_v2_conjA_v1
  }
}

/// columns[j][i] of the rows.
inline void columns_14(const BatchArrays& data, double* const* columns) {
  rows_14(data, FactorValues<factors_14<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_14(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 4 terms of the harmonic 0 of v2: functions of the frequencies alone. 7 operations.
template <class Scalar>
void factors_15([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega2 = natural_frequency[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega2 - Omega);
  factor[0] = per_0 / (Scalar(2.0) * Omega);
  factor[1] = per_0 / (Scalar(2.0) * Omega);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the harmonic 0 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in v2 = 1/(2*Omega*(2*omega2 - Omega))*eta22*conj(A_v2)*F + 1/(2*Omega*(2*omega2 -
/// Omega))*eta22*A_v2*F + harmonic_re_v2_A_v2_conjA_v2*A_v2*conj(A_v2) +
/// harmonic_re_v2_A_v1_conjA_v1*A_v1*conj(A_v1)
/// 3 columns; per observation at most 9 products and sums of complex numbers.
template <class Factors>
void rows_15(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex conj_A_v2 = conjugate(A_v2);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    store_complex(column_0, i, factor[0] * (conj_A_v2 * F) + factor[1] * (A_v2 * conj_F));  // eta22
    store_complex(column_1, i, Complex(factor[2] * (norm_A_v2)));  // harmonic_re_v2_A_v2_conjA_v2
    store_complex(column_2, i, Complex(factor[3] * (norm_A_v1)));  // harmonic_re_v2_A_v1_conjA_v1
  }
}

/// columns[j][i] of the rows.
inline void columns_15(const BatchArrays& data, double* const* columns) {
  rows_15(data, FactorValues<factors_15<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_15(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_15(data, FactorSlopes<factors_15<DualNumber>, 2, 1, 4>{mode}, columns);
}

/// What multiplies the 3 terms of the harmonic omega2+Omega of v2: functions of the frequencies alone. 5
/// operations.
template <class Scalar>
void factors_16([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega2 = natural_frequency[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega2 + Omega);
  factor[0] = -per_0 / (Scalar(2.0) * Omega);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega2+Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + Omega)*t) in v2 = -1/(2*Omega*(2*omega2 + Omega))*eta22*A_v2*F +
/// harmonic_re_v2_A_v22*A_v2^2 + i*harmonic_im_v2_A_v22*A_v2^2
/// 3 columns; per observation at most 9 products and sums of complex numbers.
template <class Factors>
void rows_16(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[3];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v2 * F));  // eta22
    store_complex(column_1, i, factor[1] * (A_v2 * A_v2));  // harmonic_re_v2_A_v22
    store_complex(column_2, i, times_i(factor[2] * (A_v2 * A_v2)));  // harmonic_im_v2_A_v22
  }
}

/// columns[j][i] of the rows.
inline void columns_16(const BatchArrays& data, double* const* columns) {
  rows_16(data, FactorValues<factors_16<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_16(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_16(data, FactorSlopes<factors_16<DualNumber>, 2, 1, 3>{mode}, columns);
}

/// What multiplies the 5 terms of the harmonic omega1 of v2: functions of the frequencies alone. 6 operations.
template <class Scalar>
void factors_17([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  factor[0] = omega1 * per_0 * per_1;
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
}

/// Rows of the harmonic omega1 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1)*t) in v2 = omega1/((omega1 + omega2)*(omega1 - omega2))*i*mu21*A_v1 +
/// harmonic_re_v2_A_v1_conjA_v2_F*A_v1*conj(A_v2)*F + harmonic_re_v2_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) +
/// harmonic_re_v2_A_v12_conjA_v1*A_v1^2*conj(A_v1) + harmonic_re_v2_A_v1_A_v2_F*A_v1*A_v2*F
/// 5 columns; per observation at most 17 products and sums of complex numbers.
template <class Factors>
void rows_17(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex conj_A_v2 = conjugate(A_v2);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    store_complex(column_0, i, times_i(factor[0] * (A_v1)));  // mu21
    store_complex(column_1, i, factor[1] * (A_v1 * conj_A_v2 * F));  // harmonic_re_v2_A_v1_conjA_v2_F
    store_complex(column_2, i, factor[2] * (A_v1 * norm_A_v2));  // harmonic_re_v2_A_v1_A_v2_conjA_v2
    store_complex(column_3, i, factor[3] * (norm_A_v1 * A_v1));  // harmonic_re_v2_A_v12_conjA_v1
    store_complex(column_4, i, factor[4] * (A_v1 * A_v2 * conj_F));  // harmonic_re_v2_A_v1_A_v2_F
  }
}

/// columns[j][i] of the rows.
inline void columns_17(const BatchArrays& data, double* const* columns) {
  rows_17(data, FactorValues<factors_17<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_17(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_17(data, FactorSlopes<factors_17<DualNumber>, 2, 1, 5>{mode}, columns);
}

/// What multiplies the 3 terms of the harmonic omega1+Omega of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_18([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega1+Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + Omega)*t) in v2 = harmonic_re_v2_A_v1_A_v2*A_v1*A_v2 +
/// i*harmonic_im_v2_A_v1_F*A_v1*F + i*harmonic_im_v2_A_v1_A_v2*A_v1*A_v2
/// 3 columns; per observation at most 9 products and sums of complex numbers.
template <class Factors>
void rows_18(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v2));  // harmonic_re_v2_A_v1_A_v2
    store_complex(column_1, i, times_i(factor[1] * (A_v1 * F)));  // harmonic_im_v2_A_v1_F
    store_complex(column_2, i, times_i(factor[2] * (A_v1 * A_v2)));  // harmonic_im_v2_A_v1_A_v2
  }
}

/// columns[j][i] of the rows.
inline void columns_18(const BatchArrays& data, double* const* columns) {
  rows_18(data, FactorValues<factors_18<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_18(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 2 terms of the harmonic 2*omega1 of v2: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_19([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega1 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega1)*t) in v2 = harmonic_re_v2_A_v12*A_v1^2 + i*harmonic_im_v2_A_v12*A_v1^2
/// 2 columns; per observation at most 6 products and sums of complex numbers.
template <class Factors>
void rows_19(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v1));  // harmonic_re_v2_A_v12
    store_complex(column_1, i, times_i(factor[1] * (A_v1 * A_v1)));  // harmonic_im_v2_A_v12
  }
}

/// columns[j][i] of the rows.
inline void columns_19(const BatchArrays& data, double* const* columns) {
  rows_19(data, FactorValues<factors_19<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_19(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 2 terms of the harmonic -2*omega1+Omega of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_20([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic -2*omega1+Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-2*omega1 + Omega)*t) in v2 = harmonic_re_v2_conjA_v12_F*conj(A_v1)^2*F +
/// harmonic_re_v2_A_v2_conjA_v12*conj(A_v1)^2*A_v2
/// 2 columns; per observation at most 10 products and sums of complex numbers.
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
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * conj_A_v1 * F));  // harmonic_re_v2_conjA_v12_F
    store_complex(column_1, i, factor[1] * (conj_A_v1 * conj_A_v1 * A_v2));  // harmonic_re_v2_A_v2_conjA_v12
  }
}

/// columns[j][i] of the rows.
inline void columns_20(const BatchArrays& data, double* const* columns) {
  rows_20(data, FactorValues<factors_20<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_20(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 2 terms of the harmonic -omega1+omega2+Omega of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_21([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic -omega1+omega2+Omega of v2: target = sum of columns[j][i] * lump_j, with the factors
/// above.
/// amplitude of exp(i*(-omega1 + omega2 + Omega)*t) in v2 = harmonic_re_v2_A_v2_conjA_v1_F*conj(A_v1)*A_v2*F +
/// harmonic_re_v2_A_v22_conjA_v1*conj(A_v1)*A_v2^2
/// 2 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_21(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * A_v2 * F));  // harmonic_re_v2_A_v2_conjA_v1_F
    store_complex(column_1, i, factor[1] * (conj_A_v1 * A_v2 * A_v2));  // harmonic_re_v2_A_v22_conjA_v1
  }
}

/// columns[j][i] of the rows.
inline void columns_21(const BatchArrays& data, double* const* columns) {
  rows_21(data, FactorValues<factors_21<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_21(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 4 terms of the harmonic omega2+2*Omega of v2: functions of the frequencies alone. 3
/// operations.
template <class Scalar>
void factors_22([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega2 = natural_frequency[1];
  factor[0] = -Scalar(1.0) / (Scalar(8.0) * omega2);
  factor[1] = -omega2 / Scalar(8.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the harmonic omega2+2*Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + 2*Omega)*t) in v2 = -1/(8*omega2)*conservative_v2_A_v2_F2*A_v2*F^2 -
/// omega2/8*i*mu23*A_v2^3 + harmonic_re_v2_A_v22_F*A_v2^2*F + harmonic_re_v2_A_v23*A_v2^3
/// 4 columns; per observation at most 20 products and sums of complex numbers.
template <class Factors>
void rows_22(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
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
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v2 * F * F));  // conservative_v2_A_v2_F2
    store_complex(column_1, i, times_i(factor[1] * (A_v2 * A_v2 * A_v2)));  // mu23
    store_complex(column_2, i, factor[2] * (A_v2 * A_v2 * F));  // harmonic_re_v2_A_v22_F
    store_complex(column_3, i, factor[3] * (A_v2 * A_v2 * A_v2));  // harmonic_re_v2_A_v23
  }
}

/// columns[j][i] of the rows.
inline void columns_22(const BatchArrays& data, double* const* columns) {
  rows_22(data, FactorValues<factors_22<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_22(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_22(data, FactorSlopes<factors_22<DualNumber>, 2, 1, 4>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic omega1+omega2+Omega of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_23([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic omega1+omega2+Omega of v2: target = sum of columns[j][i] * lump_j, with the factors
/// above.
/// amplitude of exp(i*(omega1 + omega2 + Omega)*t) in v2 = harmonic_re_v2_A_v1_A_v2_F*A_v1*A_v2*F +
/// harmonic_re_v2_A_v1_A_v22*A_v1*A_v2^2
/// 2 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_23(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v2 * F));  // harmonic_re_v2_A_v1_A_v2_F
    store_complex(column_1, i, factor[1] * (A_v1 * A_v2 * A_v2));  // harmonic_re_v2_A_v1_A_v22
  }
}

/// columns[j][i] of the rows.
inline void columns_23(const BatchArrays& data, double* const* columns) {
  rows_23(data, FactorValues<factors_23<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_23(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 2 terms of the harmonic 2*omega1+Omega of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_24([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega1+Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega1 + Omega)*t) in v2 = harmonic_re_v2_A_v12_F*A_v1^2*F +
/// harmonic_re_v2_A_v12_A_v2*A_v1^2*A_v2
/// 2 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_24(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v1 * F));  // harmonic_re_v2_A_v12_F
    store_complex(column_1, i, factor[1] * (A_v1 * A_v1 * A_v2));  // harmonic_re_v2_A_v12_A_v2
  }
}

/// columns[j][i] of the rows.
inline void columns_24(const BatchArrays& data, double* const* columns) {
  rows_24(data, FactorValues<factors_24<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_24(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic 3*omega1 of v2: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_25([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic 3*omega1 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega1)*t) in v2 = harmonic_re_v2_A_v13*A_v1^3
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_25(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v1 * A_v1));  // harmonic_re_v2_A_v13
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

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_v1/dt + i*(w_v1 - omega1)*B_v1 = i*conservative_v1_A_v1_A_v2_F*A_v1*A_v2*F +
/// i*conservative_v1_A_v1_A_v2_F*A_v1*conj(A_v2)*F - mu11*A_v1 + i*conservative_v1_A_v1*A_v1 +
/// i*conservative_v1_A_v1_F2*A_v1*F^2 + i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) -
/// 3*omega1^2/2*mu13*A_v1^2*conj(A_v1) + i*conservative_v1_A_v12_conjA_v1*A_v1^2*conj(A_v1) with A = B in that
/// frame
/// dB_v2/dt + i*(w_v2 - omega2)*B_v2 = omega1/omega2*i*conservative_v1_A_v1_A_v2_F*A_v1*conj(A_v1)*F -
/// omega2/omega1*i*conservative_v1_A_v1*A_v2 +
/// omega1/omega2*i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*conj(A_v1)*A_v2 + i*conservative_v2_A_v22_F*A_v2^2*F
/// + 2*i*conservative_v2_A_v22_F*A_v2*conj(A_v2)*F - mu22*A_v2 + i*conservative_v2_A_v2_F2*A_v2*F^2 +
/// 3/2*i*conservative_v2_A_v2_F2*conj(A_v2)*F^2 - 3*omega2^2/2*mu23*A_v2^2*conj(A_v2) +
/// i*conservative_v2_A_v22_conjA_v2*A_v2^2*conj(A_v2) - 1/(4*omega2)*i*eta21*F with A = B in that frame
/// 79 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  Scalar lumps[71];
  evaluate_lumps(parameters, lumps);
  const Complex A_v1 = load_complex(amplitude, 0);
  const Scalar norm_A_v1 = norm_of(A_v1);
  const Complex A_v2 = load_complex(amplitude, 1);
  const Complex conj_A_v2 = conjugate(A_v2);
  const Scalar norm_A_v2 = norm_of(A_v2);
  const Complex F = load_complex(forcing, 0);
  const Complex conj_F = conjugate(F);
  const Scalar norm_F = norm_of(F);
  store_complex(derivative, 0, times_i(lumps[0] * (A_v1 * A_v2 * conj_F))
       + times_i(lumps[0] * (A_v1 * conj_A_v2 * F))
       + lumps[1] * (-Scalar(1.0)) * (A_v1)
       + times_i(lumps[2] * (A_v1))
       + times_i(lumps[3] * (A_v1 * norm_F))
       + times_i(lumps[4] * (A_v1 * norm_A_v2))
       + lumps[5] * (-Scalar(3.0) * omega1_2 / Scalar(2.0)) * (norm_A_v1 * A_v1)
       + times_i(lumps[6] * (norm_A_v1 * A_v1)));
  store_complex(derivative, 1, times_i(lumps[0] * omega1 / omega2 * (norm_A_v1 * F))
       + times_i(lumps[2] * (-omega2 / omega1) * (A_v2))
       + times_i(lumps[4] * omega1 / omega2 * (norm_A_v1 * A_v2))
       + times_i(lumps[7] * (A_v2 * A_v2 * conj_F))
       + times_i(lumps[7] * Scalar(2.0) * (norm_A_v2 * F))
       + lumps[8] * (-Scalar(1.0)) * (A_v2)
       + times_i(lumps[9] * (A_v2 * norm_F))
       + times_i(lumps[9] * Scalar(3.0) / Scalar(2.0) * (conj_A_v2 * F * F))
       + lumps[10] * (-Scalar(3.0) * omega2_2 / Scalar(2.0)) * (norm_A_v2 * A_v2)
       + times_i(lumps[11] * (norm_A_v2 * A_v2))
       + times_i(lumps[12] * (-Scalar(1.0) / (Scalar(4.0) * omega2)) * (F))
       - times_i((-omega2 + excitation_frequency[0]) * A_v2));
}

/// jacobian[i * 4 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 121 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  Scalar lumps[71];
  evaluate_lumps(parameters, lumps);
  const Complex A_v1 = load_complex(amplitude, 0);
  const Complex conj_A_v1 = conjugate(A_v1);
  const Scalar norm_A_v1 = norm_of(A_v1);
  const Complex A_v2 = load_complex(amplitude, 1);
  const Complex conj_A_v2 = conjugate(A_v2);
  const Scalar norm_A_v2 = norm_of(A_v2);
  const Complex F = load_complex(forcing, 0);
  const Complex conj_F = conjugate(F);
  const Scalar norm_F = norm_of(F);
  for (std::size_t i = 0; i < 16; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = times_i(lumps[0] * (A_v2 * conj_F))
       + times_i(lumps[0] * (conj_A_v2 * F))
       + Complex(lumps[1] * (-Scalar(1.0)))
       + times_i(Complex(lumps[2]))
       + times_i(Complex(lumps[3] * (norm_F)))
       + times_i(Complex(lumps[4] * (norm_A_v2)))
       + Complex(lumps[5] * (-Scalar(3.0) * omega1_2 / Scalar(2.0)) * Scalar(2) * (norm_A_v1))
       + times_i(Complex(lumps[6] * Scalar(2) * (norm_A_v1)));
  const Complex conj_by_0_0 = lumps[5] * (-Scalar(3.0) * omega1_2 / Scalar(2.0)) * (A_v1 * A_v1)
       + times_i(lumps[6] * (A_v1 * A_v1));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[4] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[5] = by_0_0.real - conj_by_0_0.real;
  const Complex by_0_1 = times_i(lumps[0] * (A_v1 * conj_F))
       + times_i(lumps[4] * (A_v1 * conj_A_v2));
  const Complex conj_by_0_1 = times_i(lumps[0] * (A_v1 * F))
       + times_i(lumps[4] * (A_v1 * A_v2));
  jacobian[2] = by_0_1.real + conj_by_0_1.real;
  jacobian[3] = conj_by_0_1.imag - by_0_1.imag;
  jacobian[6] = by_0_1.imag + conj_by_0_1.imag;
  jacobian[7] = by_0_1.real - conj_by_0_1.real;
  const Complex by_1_0 = times_i(lumps[0] * omega1 / omega2 * (conj_A_v1 * F))
       + times_i(lumps[4] * omega1 / omega2 * (conj_A_v1 * A_v2));
  const Complex conj_by_1_0 = times_i(lumps[0] * omega1 / omega2 * (A_v1 * F))
       + times_i(lumps[4] * omega1 / omega2 * (A_v1 * A_v2));
  jacobian[8] = by_1_0.real + conj_by_1_0.real;
  jacobian[9] = conj_by_1_0.imag - by_1_0.imag;
  jacobian[12] = by_1_0.imag + conj_by_1_0.imag;
  jacobian[13] = by_1_0.real - conj_by_1_0.real;
  const Complex by_1_1 = times_i(Complex(lumps[2] * (-omega2 / omega1)))
       + times_i(Complex(lumps[4] * omega1 / omega2 * (norm_A_v1)))
       + times_i(lumps[7] * Scalar(2) * (A_v2 * conj_F))
       + times_i(lumps[7] * Scalar(2.0) * (conj_A_v2 * F))
       + Complex(lumps[8] * (-Scalar(1.0)))
       + times_i(Complex(lumps[9] * (norm_F)))
       + Complex(lumps[10] * (-Scalar(3.0) * omega2_2 / Scalar(2.0)) * Scalar(2) * (norm_A_v2))
       + times_i(Complex(lumps[11] * Scalar(2) * (norm_A_v2)))
       - Complex(Scalar(0.0), -omega2 + excitation_frequency[0]);
  const Complex conj_by_1_1 = times_i(lumps[7] * Scalar(2.0) * (A_v2 * F))
       + times_i(lumps[9] * Scalar(3.0) / Scalar(2.0) * (F * F))
       + lumps[10] * (-Scalar(3.0) * omega2_2 / Scalar(2.0)) * (A_v2 * A_v2)
       + times_i(lumps[11] * (A_v2 * A_v2));
  jacobian[10] = by_1_1.real + conj_by_1_1.real;
  jacobian[11] = conj_by_1_1.imag - by_1_1.imag;
  jacobian[14] = by_1_1.imag + conj_by_1_1.imag;
  jacobian[15] = by_1_1.real - conj_by_1_1.real;
}

}  // namespace primary_2

namespace principal_parametric_1 {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: mu11 = mu11
/// lumps[3]: mu13 = mu13
/// lumps[6]: mu22 = mu22
/// lumps[7]: mu23 = mu23
/// lumps[11]: harmonic_re_v1_A_v2_conjA_v2 = (2*omega2^2*delta23 - 2*alpha23)/omega1^2
/// lumps[12]: harmonic_re_v1_A_v1_conjA_v1 = (2*omega1^2*delta21 - 2*alpha21)/omega1^2
/// lumps[13]: eta11 = eta11
/// lumps[14]: harmonic_re_v1_A_v12 = (-3*omega1^2*delta21 + alpha21)/(3*omega1^2)
/// lumps[17]: mu12 = mu12
/// lumps[34]: harmonic_re_v2_A_v2_conjA_v2 = (2*omega2^2*delta24 - 2*alpha24)/omega2^2
/// lumps[35]: harmonic_re_v2_A_v1_conjA_v1 = (2*omega1^2*delta22 - 2*alpha22)/omega2^2
/// lumps[36]: eta21 = eta21
/// lumps[40]: harmonic_re_v2_A_v22 = (-3*omega2^2*delta24 + alpha24)/(3*omega2^2)
/// lumps[42]: mu21 = mu21
/// 30 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu11 = parameters[2];
  const Scalar mu12 = parameters[3];
  const Scalar mu13 = parameters[4];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar eta11 = parameters[20];
  const Scalar mu22 = parameters[22];
  const Scalar mu21 = parameters[23];
  const Scalar mu23 = parameters[24];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar eta21 = parameters[29];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  lumps[0] = mu11;  // mu11
  lumps[1] = lump_0(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v1
  lumps[2] = lump_1(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v1_A_v2_conjA_v2
  lumps[3] = mu13;  // mu13
  lumps[4] = lump_2(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v12_conjA_v1
  lumps[5] = lump_66(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_conjA_v1_F
  lumps[6] = mu22;  // mu22
  lumps[7] = mu23;  // mu23
  lumps[8] = lump_5(parameters, static_cast<Scalar*>(nullptr));  // conservative_v2_A_v22_conjA_v2
  lumps[9] = lump_6(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v2_conjA_v1
  lumps[10] = lump_7(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v2_conjA_v1
  // harmonic_re_v1_A_v2_conjA_v2
  lumps[11] = (Scalar(2.0) * omega2_2 * delta23 - Scalar(2.0) * alpha23) / omega1_2;
  // harmonic_re_v1_A_v1_conjA_v1
  lumps[12] = (Scalar(2.0) * omega1_2 * delta21 - Scalar(2.0) * alpha21) / omega1_2;
  lumps[13] = eta11;  // eta11
  lumps[14] = (-Scalar(3.0) * omega1_2 * delta21 + alpha21) / (Scalar(3.0) * omega1_2);  // harmonic_re_v1_A_v12
  lumps[15] = lump_67(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_F
  lumps[16] = lump_15(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v12
  lumps[17] = mu12;  // mu12
  lumps[18] = lump_10(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v22_conjA_v2
  lumps[19] = lump_11(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_A_v2_conjA_v1
  lumps[20] = lump_13(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v22
  lumps[21] = lump_14(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v22
  lumps[22] = lump_16(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_A_v2
  lumps[23] = lump_17(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v1_A_v2
  lumps[24] = lump_18(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v2_conjA_v12
  lumps[25] = lump_68(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v2_F
  lumps[26] = lump_19(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v22_conjA_v1
  lumps[27] = lump_24(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v12_A_v2
  lumps[28] = lump_22(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v23
  lumps[29] = lump_69(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_F
  lumps[30] = lump_23(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v13
  lumps[31] = lump_21(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_A_v22
  lumps[32] = lump_25(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v2_conjA_v1
  lumps[33] = lump_26(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v2_conjA_v1
  // harmonic_re_v2_A_v2_conjA_v2
  lumps[34] = (Scalar(2.0) * omega2_2 * delta24 - Scalar(2.0) * alpha24) / omega2_2;
  // harmonic_re_v2_A_v1_conjA_v1
  lumps[35] = (Scalar(2.0) * omega1_2 * delta22 - Scalar(2.0) * alpha22) / omega2_2;
  lumps[36] = eta21;  // eta21
  lumps[37] = lump_36(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v12
  lumps[38] = lump_70(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_F
  lumps[39] = lump_38(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v12
  lumps[40] = (-Scalar(3.0) * omega2_2 * delta24 + alpha24) / (Scalar(3.0) * omega2_2);  // harmonic_re_v2_A_v22
  lumps[41] = lump_30(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v22
  lumps[42] = mu21;  // mu21
  lumps[43] = lump_71(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_conjA_v1_F
  lumps[44] = lump_33(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_A_v2_conjA_v2
  lumps[45] = lump_34(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v12_conjA_v1
  lumps[46] = lump_28(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_A_v2
  lumps[47] = lump_29(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v1_A_v2
  lumps[48] = lump_39(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v2_conjA_v12
  lumps[49] = lump_72(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v2_F
  lumps[50] = lump_41(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v22_conjA_v1
  lumps[51] = lump_44(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v12_A_v2
  lumps[52] = lump_46(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v23
  lumps[53] = lump_73(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_F
  lumps[54] = lump_47(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v13
  lumps[55] = lump_45(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_A_v22
}

/// jacobian[l * 31 + p] = d lumps[l] / d parameters[p]. 38 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar alpha24 = parameters[25];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  for (std::size_t i = 0; i < 1736; ++i) jacobian[i] = Scalar(0.0);
  jacobian[2] = Scalar(1.0);  // d mu11 / d mu11
  lump_0(parameters, jacobian + 31);  // d conservative_v1_A_v1
  lump_1(parameters, jacobian + 62);  // d conservative_v1_A_v1_A_v2_conjA_v2
  jacobian[97] = Scalar(1.0);  // d mu13 / d mu13
  lump_2(parameters, jacobian + 124);  // d conservative_v1_A_v12_conjA_v1
  lump_66(parameters, jacobian + 155);  // d conservative_v1_conjA_v1_F
  jacobian[208] = Scalar(1.0);  // d mu22 / d mu22
  jacobian[241] = Scalar(1.0);  // d mu23 / d mu23
  lump_5(parameters, jacobian + 248);  // d conservative_v2_A_v22_conjA_v2
  lump_6(parameters, jacobian + 279);  // d harmonic_re_v1_A_v2_conjA_v1
  lump_7(parameters, jacobian + 310);  // d harmonic_im_v1_A_v2_conjA_v1
  // d harmonic_re_v1_A_v2_conjA_v2 / d omega1
  jacobian[341] = (-Scalar(4.0) * omega2_2 * delta23 + Scalar(4.0) * alpha23) / omega1_3;
  jacobian[342] = Scalar(4.0) * omega2 * delta23 / omega1_2;  // d harmonic_re_v1_A_v2_conjA_v2 / d omega2
  jacobian[348] = -Scalar(2.0) / omega1_2;  // d harmonic_re_v1_A_v2_conjA_v2 / d alpha23
  jacobian[351] = Scalar(2.0) * omega2_2 / omega1_2;  // d harmonic_re_v1_A_v2_conjA_v2 / d delta23
  jacobian[372] = Scalar(4.0) * alpha21 / omega1_3;  // d harmonic_re_v1_A_v1_conjA_v1 / d omega1
  jacobian[377] = -Scalar(2.0) / omega1_2;  // d harmonic_re_v1_A_v1_conjA_v1 / d alpha21
  jacobian[380] = Scalar(2.0);  // d harmonic_re_v1_A_v1_conjA_v1 / d delta21
  jacobian[423] = Scalar(1.0);  // d eta11 / d eta11
  jacobian[434] = -Scalar(2.0) * alpha21 / (Scalar(3.0) * omega1_3);  // d harmonic_re_v1_A_v12 / d omega1
  jacobian[439] = Scalar(1.0) / (Scalar(3.0) * omega1_2);  // d harmonic_re_v1_A_v12 / d alpha21
  jacobian[442] = -Scalar(1.0);  // d harmonic_re_v1_A_v12 / d delta21
  lump_67(parameters, jacobian + 465);  // d harmonic_im_v1_F
  lump_15(parameters, jacobian + 496);  // d harmonic_im_v1_A_v12
  jacobian[530] = Scalar(1.0);  // d mu12 / d mu12
  lump_10(parameters, jacobian + 558);  // d harmonic_re_v1_A_v22_conjA_v2
  lump_11(parameters, jacobian + 589);  // d harmonic_re_v1_A_v1_A_v2_conjA_v1
  lump_13(parameters, jacobian + 620);  // d harmonic_re_v1_A_v22
  lump_14(parameters, jacobian + 651);  // d harmonic_im_v1_A_v22
  lump_16(parameters, jacobian + 682);  // d harmonic_re_v1_A_v1_A_v2
  lump_17(parameters, jacobian + 713);  // d harmonic_im_v1_A_v1_A_v2
  lump_18(parameters, jacobian + 744);  // d harmonic_re_v1_A_v2_conjA_v12
  lump_68(parameters, jacobian + 775);  // d harmonic_re_v1_A_v2_F
  lump_19(parameters, jacobian + 806);  // d harmonic_re_v1_A_v22_conjA_v1
  lump_24(parameters, jacobian + 837);  // d harmonic_re_v1_A_v12_A_v2
  lump_22(parameters, jacobian + 868);  // d harmonic_re_v1_A_v23
  lump_69(parameters, jacobian + 899);  // d harmonic_re_v1_A_v1_F
  lump_23(parameters, jacobian + 930);  // d harmonic_re_v1_A_v13
  lump_21(parameters, jacobian + 961);  // d harmonic_re_v1_A_v1_A_v22
  lump_25(parameters, jacobian + 992);  // d harmonic_re_v2_A_v2_conjA_v1
  lump_26(parameters, jacobian + 1023);  // d harmonic_im_v2_A_v2_conjA_v1
  jacobian[1055] = Scalar(4.0) * alpha24 / omega2_3;  // d harmonic_re_v2_A_v2_conjA_v2 / d omega2
  jacobian[1079] = -Scalar(2.0) / omega2_2;  // d harmonic_re_v2_A_v2_conjA_v2 / d alpha24
  jacobian[1080] = Scalar(2.0);  // d harmonic_re_v2_A_v2_conjA_v2 / d delta24
  jacobian[1085] = Scalar(4.0) * omega1 * delta22 / omega2_2;  // d harmonic_re_v2_A_v1_conjA_v1 / d omega1
  // d harmonic_re_v2_A_v1_conjA_v1 / d omega2
  jacobian[1086] = (-Scalar(4.0) * omega1_2 * delta22 + Scalar(4.0) * alpha22) / omega2_3;
  jacobian[1091] = -Scalar(2.0) / omega2_2;  // d harmonic_re_v2_A_v1_conjA_v1 / d alpha22
  jacobian[1094] = Scalar(2.0) * omega1_2 / omega2_2;  // d harmonic_re_v2_A_v1_conjA_v1 / d delta22
  jacobian[1145] = Scalar(1.0);  // d eta21 / d eta21
  lump_36(parameters, jacobian + 1147);  // d harmonic_re_v2_A_v12
  lump_70(parameters, jacobian + 1178);  // d harmonic_im_v2_F
  lump_38(parameters, jacobian + 1209);  // d harmonic_im_v2_A_v12
  jacobian[1241] = -Scalar(2.0) * alpha24 / (Scalar(3.0) * omega2_3);  // d harmonic_re_v2_A_v22 / d omega2
  jacobian[1265] = Scalar(1.0) / (Scalar(3.0) * omega2_2);  // d harmonic_re_v2_A_v22 / d alpha24
  jacobian[1266] = -Scalar(1.0);  // d harmonic_re_v2_A_v22 / d delta24
  lump_30(parameters, jacobian + 1271);  // d harmonic_im_v2_A_v22
  jacobian[1325] = Scalar(1.0);  // d mu21 / d mu21
  lump_71(parameters, jacobian + 1333);  // d harmonic_re_v2_conjA_v1_F
  lump_33(parameters, jacobian + 1364);  // d harmonic_re_v2_A_v1_A_v2_conjA_v2
  lump_34(parameters, jacobian + 1395);  // d harmonic_re_v2_A_v12_conjA_v1
  lump_28(parameters, jacobian + 1426);  // d harmonic_re_v2_A_v1_A_v2
  lump_29(parameters, jacobian + 1457);  // d harmonic_im_v2_A_v1_A_v2
  lump_39(parameters, jacobian + 1488);  // d harmonic_re_v2_A_v2_conjA_v12
  lump_72(parameters, jacobian + 1519);  // d harmonic_re_v2_A_v2_F
  lump_41(parameters, jacobian + 1550);  // d harmonic_re_v2_A_v22_conjA_v1
  lump_44(parameters, jacobian + 1581);  // d harmonic_re_v2_A_v12_A_v2
  lump_46(parameters, jacobian + 1612);  // d harmonic_re_v2_A_v23
  lump_73(parameters, jacobian + 1643);  // d harmonic_re_v2_A_v1_F
  lump_47(parameters, jacobian + 1674);  // d harmonic_re_v2_A_v13
  lump_45(parameters, jacobian + 1705);  // d harmonic_re_v2_A_v1_A_v22
}

/// What multiplies the 6 terms of the modulation of v1: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  factor[0] = -Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = -Scalar(3.0) * omega1_2 / Scalar(2.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
}

/// Rows of the modulation of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega1)*A_v1 = -mu11*A_v1 + i*conservative_v1_A_v1*A_v1 +
/// i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) - 3*omega1^2/2*mu13*A_v1^2*conj(A_v1) +
/// i*conservative_v1_A_v12_conjA_v1*A_v1^2*conj(A_v1) + i*conservative_v1_conjA_v1_F*conj(A_v1)*F
/// 6 columns; per observation at most 14 products and sums of complex numbers.
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
  Scalar factor[6];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1));  // mu11
    store_complex(column_1, i, times_i(factor[1] * (A_v1)));  // conservative_v1_A_v1
    store_complex(column_2, i, times_i(factor[2] * (A_v1 * norm_A_v2)));  // conservative_v1_A_v1_A_v2_conjA_v2
    store_complex(column_3, i, factor[3] * (norm_A_v1 * A_v1));  // mu13
    store_complex(column_4, i, times_i(factor[4] * (norm_A_v1 * A_v1)));  // conservative_v1_A_v12_conjA_v1
    store_complex(column_5, i, times_i(factor[5] * (conj_A_v1 * F)));  // conservative_v1_conjA_v1_F
  }
}

/// columns[j][i] of the rows.
inline void columns_0(const BatchArrays& data, double* const* columns) {
  rows_0(data, FactorValues<factors_0<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_0(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_0(data, FactorSlopes<factors_0<DualNumber>, 2, 1, 6>{mode}, columns);
}

/// What multiplies the 5 terms of the modulation of v2: functions of the frequencies alone. 5 operations.
template <class Scalar>
void factors_1([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega2_2 = omega2 * omega2;
  factor[0] = -omega2 / omega1;
  factor[1] = omega1 / omega2;
  factor[2] = -Scalar(1.0);
  factor[3] = -Scalar(3.0) * omega2_2 / Scalar(2.0);
  factor[4] = Scalar(1.0);
}

/// Rows of the modulation of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega2)*A_v2 = -omega2/omega1*i*conservative_v1_A_v1*A_v2 +
/// omega1/omega2*i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*conj(A_v1)*A_v2 - mu22*A_v2 -
/// 3*omega2^2/2*mu23*A_v2^2*conj(A_v2) + i*conservative_v2_A_v22_conjA_v2*A_v2^2*conj(A_v2)
/// 5 columns; per observation at most 11 products and sums of complex numbers.
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
  Scalar factor[5];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    store_complex(column_0, i, times_i(factor[0] * (A_v2)));  // conservative_v1_A_v1
    store_complex(column_1, i, times_i(factor[1] * (norm_A_v1 * A_v2)));  // conservative_v1_A_v1_A_v2_conjA_v2
    store_complex(column_2, i, factor[2] * (A_v2));  // mu22
    store_complex(column_3, i, factor[3] * (norm_A_v2 * A_v2));  // mu23
    store_complex(column_4, i, times_i(factor[4] * (norm_A_v2 * A_v2)));  // conservative_v2_A_v22_conjA_v2
  }
}

/// columns[j][i] of the rows.
inline void columns_1(const BatchArrays& data, double* const* columns) {
  rows_1(data, FactorValues<factors_1<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_1(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_1(data, FactorSlopes<factors_1<DualNumber>, 2, 1, 5>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic -omega1+omega2 of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_2([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic -omega1+omega2 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + omega2)*t) in v1 = harmonic_re_v1_A_v2_conjA_v1*conj(A_v1)*A_v2 +
/// i*harmonic_im_v1_A_v2_conjA_v1*conj(A_v1)*A_v2
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * A_v2));  // harmonic_re_v1_A_v2_conjA_v1
    store_complex(column_1, i, times_i(factor[1] * (conj_A_v1 * A_v2)));  // harmonic_im_v1_A_v2_conjA_v1
  }
}

/// columns[j][i] of the rows.
inline void columns_2(const BatchArrays& data, double* const* columns) {
  rows_2(data, FactorValues<factors_2<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_2(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 2 terms of the harmonic 0 of v1: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_3([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic 0 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in v1 = harmonic_re_v1_A_v2_conjA_v2*A_v2*conj(A_v2) +
/// harmonic_re_v1_A_v1_conjA_v1*A_v1*conj(A_v1)
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    store_complex(column_0, i, Complex(factor[0] * (norm_A_v2)));  // harmonic_re_v1_A_v2_conjA_v2
    store_complex(column_1, i, Complex(factor[1] * (norm_A_v1)));  // harmonic_re_v1_A_v1_conjA_v1
  }
}

/// columns[j][i] of the rows.
inline void columns_3(const BatchArrays& data, double* const* columns) {
  rows_3(data, FactorValues<factors_3<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_3(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 4 terms of the harmonic Omega of v1: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_4([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  factor[0] = -Scalar(1.0) / (Scalar(6.0) * omega1_2);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the harmonic Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(Omega)*t) in v1 = -1/(6*omega1^2)*eta11*F + harmonic_re_v1_A_v12*A_v1^2 +
/// i*harmonic_im_v1_F*F + i*harmonic_im_v1_A_v12*A_v1^2
/// 4 columns; per observation at most 8 products and sums of complex numbers.
template <class Factors>
void rows_4(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (F));  // eta11
    store_complex(column_1, i, factor[1] * (A_v1 * A_v1));  // harmonic_re_v1_A_v12
    store_complex(column_2, i, times_i(factor[2] * (F)));  // harmonic_im_v1_F
    store_complex(column_3, i, times_i(factor[3] * (A_v1 * A_v1)));  // harmonic_im_v1_A_v12
  }
}

/// columns[j][i] of the rows.
inline void columns_4(const BatchArrays& data, double* const* columns) {
  rows_4(data, FactorValues<factors_4<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_4(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_4(data, FactorSlopes<factors_4<DualNumber>, 2, 1, 4>{mode}, columns);
}

/// What multiplies the 3 terms of the harmonic omega2 of v1: functions of the frequencies alone. 6 operations.
template <class Scalar>
void factors_5([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  factor[0] = -omega2 * per_0 * per_1;
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega2 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2)*t) in v1 = -omega2/((omega1 + omega2)*(omega1 - omega2))*i*mu12*A_v2 +
/// harmonic_re_v1_A_v22_conjA_v2*A_v2^2*conj(A_v2) + harmonic_re_v1_A_v1_A_v2_conjA_v1*A_v1*conj(A_v1)*A_v2
/// 3 columns; per observation at most 7 products and sums of complex numbers.
template <class Factors>
void rows_5(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    store_complex(column_0, i, times_i(factor[0] * (A_v2)));  // mu12
    store_complex(column_1, i, factor[1] * (norm_A_v2 * A_v2));  // harmonic_re_v1_A_v22_conjA_v2
    store_complex(column_2, i, factor[2] * (norm_A_v1 * A_v2));  // harmonic_re_v1_A_v1_A_v2_conjA_v1
  }
}

/// columns[j][i] of the rows.
inline void columns_5(const BatchArrays& data, double* const* columns) {
  rows_5(data, FactorValues<factors_5<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_5(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_5(data, FactorSlopes<factors_5<DualNumber>, 2, 1, 3>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic omega1+omega2 of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_7([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic omega1+omega2 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + omega2)*t) in v1 = harmonic_re_v1_A_v1_A_v2*A_v1*A_v2 +
/// i*harmonic_im_v1_A_v1_A_v2*A_v1*A_v2
/// 2 columns; per observation at most 6 products and sums of complex numbers.
template <class Factors>
void rows_7(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v2));  // harmonic_re_v1_A_v1_A_v2
    store_complex(column_1, i, times_i(factor[1] * (A_v1 * A_v2)));  // harmonic_im_v1_A_v1_A_v2
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

/// What multiplies the 2 terms of the harmonic omega2-Omega of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_8([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic omega2-Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 - Omega)*t) in v1 = harmonic_re_v1_A_v2_conjA_v12*conj(A_v1)^2*A_v2 +
/// harmonic_re_v1_A_v2_F*A_v2*F
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
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * conj_A_v1 * A_v2));  // harmonic_re_v1_A_v2_conjA_v12
    store_complex(column_1, i, factor[1] * (A_v2 * conj_F));  // harmonic_re_v1_A_v2_F
  }
}

/// columns[j][i] of the rows.
inline void columns_8(const BatchArrays& data, double* const* columns) {
  rows_8(data, FactorValues<factors_8<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_8(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
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
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
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

/// What multiplies the 2 terms of the harmonic omega2+Omega of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_10([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic omega2+Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + Omega)*t) in v1 = harmonic_re_v1_A_v2_F*A_v2*F +
/// harmonic_re_v1_A_v12_A_v2*A_v1^2*A_v2
/// 2 columns; per observation at most 8 products and sums of complex numbers.
template <class Factors>
void rows_10(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v2 * F));  // harmonic_re_v1_A_v2_F
    store_complex(column_1, i, factor[1] * (A_v1 * A_v1 * A_v2));  // harmonic_re_v1_A_v12_A_v2
  }
}

/// columns[j][i] of the rows.
inline void columns_10(const BatchArrays& data, double* const* columns) {
  rows_10(data, FactorValues<factors_10<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_10(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 3 terms of the harmonic omega1+Omega of v1: functions of the frequencies alone. 1
/// operations.
template <class Scalar>
void factors_12([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  factor[0] = -omega1 / Scalar(8.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega1+Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + Omega)*t) in v1 = -omega1/8*i*mu13*A_v1^3 + harmonic_re_v1_A_v1_F*A_v1*F +
/// harmonic_re_v1_A_v13*A_v1^3
/// 3 columns; per observation at most 13 products and sums of complex numbers.
template <class Factors>
void rows_12(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[3];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, times_i(factor[0] * (A_v1 * A_v1 * A_v1)));  // mu13
    store_complex(column_1, i, factor[1] * (A_v1 * F));  // harmonic_re_v1_A_v1_F
    store_complex(column_2, i, factor[2] * (A_v1 * A_v1 * A_v1));  // harmonic_re_v1_A_v13
  }
}

/// columns[j][i] of the rows.
inline void columns_12(const BatchArrays& data, double* const* columns) {
  rows_12(data, FactorValues<factors_12<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_12(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_12(data, FactorSlopes<factors_12<DualNumber>, 2, 1, 3>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic omega1+2*omega2 of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_13([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic omega1+2*omega2 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + 2*omega2)*t) in v1 = harmonic_re_v1_A_v1_A_v22*A_v1*A_v2^2
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v2 * A_v2));  // harmonic_re_v1_A_v1_A_v22
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

/// What multiplies the 2 terms of the harmonic -omega1+omega2 of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_14([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic -omega1+omega2 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + omega2)*t) in v2 = harmonic_re_v2_A_v2_conjA_v1*conj(A_v1)*A_v2 +
/// i*harmonic_im_v2_A_v2_conjA_v1*conj(A_v1)*A_v2
/// 2 columns; per observation at most 6 products and sums of complex numbers.
template <class Factors>
void rows_14(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * A_v2));  // harmonic_re_v2_A_v2_conjA_v1
    store_complex(column_1, i, times_i(factor[1] * (conj_A_v1 * A_v2)));  // harmonic_im_v2_A_v2_conjA_v1
  }
}

/// columns[j][i] of the rows.
inline void columns_14(const BatchArrays& data, double* const* columns) {
  rows_14(data, FactorValues<factors_14<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_14(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 2 terms of the harmonic 0 of v2: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_15([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic 0 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in v2 = harmonic_re_v2_A_v2_conjA_v2*A_v2*conj(A_v2) +
/// harmonic_re_v2_A_v1_conjA_v1*A_v1*conj(A_v1)
/// 2 columns; per observation at most 2 products and sums of complex numbers.
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    store_complex(column_0, i, Complex(factor[0] * (norm_A_v2)));  // harmonic_re_v2_A_v2_conjA_v2
    store_complex(column_1, i, Complex(factor[1] * (norm_A_v1)));  // harmonic_re_v2_A_v1_conjA_v1
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

/// What multiplies the 4 terms of the harmonic Omega of v2: functions of the frequencies alone. 8 operations.
template <class Scalar>
void factors_16([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 - omega2);
  factor[0] = -per_0 * per_1 / Scalar(2.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the harmonic Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(Omega)*t) in v2 = -1/(2*(2*omega1 + omega2)*(2*omega1 - omega2))*eta21*F +
/// harmonic_re_v2_A_v12*A_v1^2 + i*harmonic_im_v2_F*F + i*harmonic_im_v2_A_v12*A_v1^2
/// 4 columns; per observation at most 8 products and sums of complex numbers.
template <class Factors>
void rows_16(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (F));  // eta21
    store_complex(column_1, i, factor[1] * (A_v1 * A_v1));  // harmonic_re_v2_A_v12
    store_complex(column_2, i, times_i(factor[2] * (F)));  // harmonic_im_v2_F
    store_complex(column_3, i, times_i(factor[3] * (A_v1 * A_v1)));  // harmonic_im_v2_A_v12
  }
}

/// columns[j][i] of the rows.
inline void columns_16(const BatchArrays& data, double* const* columns) {
  rows_16(data, FactorValues<factors_16<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_16(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_16(data, FactorSlopes<factors_16<DualNumber>, 2, 1, 4>{mode}, columns);
}

/// What multiplies the 4 terms of the harmonic omega1 of v2: functions of the frequencies alone. 6 operations.
template <class Scalar>
void factors_18([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  factor[0] = omega1 * per_0 * per_1;
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the harmonic omega1 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1)*t) in v2 = omega1/((omega1 + omega2)*(omega1 - omega2))*i*mu21*A_v1 +
/// harmonic_re_v2_conjA_v1_F*conj(A_v1)*F + harmonic_re_v2_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) +
/// harmonic_re_v2_A_v12_conjA_v1*A_v1^2*conj(A_v1)
/// 4 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_18(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, times_i(factor[0] * (A_v1)));  // mu21
    store_complex(column_1, i, factor[1] * (conj_A_v1 * F));  // harmonic_re_v2_conjA_v1_F
    store_complex(column_2, i, factor[2] * (A_v1 * norm_A_v2));  // harmonic_re_v2_A_v1_A_v2_conjA_v2
    store_complex(column_3, i, factor[3] * (norm_A_v1 * A_v1));  // harmonic_re_v2_A_v12_conjA_v1
  }
}

/// columns[j][i] of the rows.
inline void columns_18(const BatchArrays& data, double* const* columns) {
  rows_18(data, FactorValues<factors_18<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_18(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_18(data, FactorSlopes<factors_18<DualNumber>, 2, 1, 4>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic omega1+omega2 of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_19([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic omega1+omega2 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + omega2)*t) in v2 = harmonic_re_v2_A_v1_A_v2*A_v1*A_v2 +
/// i*harmonic_im_v2_A_v1_A_v2*A_v1*A_v2
/// 2 columns; per observation at most 6 products and sums of complex numbers.
template <class Factors>
void rows_19(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v2));  // harmonic_re_v2_A_v1_A_v2
    store_complex(column_1, i, times_i(factor[1] * (A_v1 * A_v2)));  // harmonic_im_v2_A_v1_A_v2
  }
}

/// columns[j][i] of the rows.
inline void columns_19(const BatchArrays& data, double* const* columns) {
  rows_19(data, FactorValues<factors_19<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_19(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 2 terms of the harmonic omega2-Omega of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_20([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic omega2-Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 - Omega)*t) in v2 = harmonic_re_v2_A_v2_conjA_v12*conj(A_v1)^2*A_v2 +
/// harmonic_re_v2_A_v2_F*A_v2*F
/// 2 columns; per observation at most 8 products and sums of complex numbers.
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
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * conj_A_v1 * A_v2));  // harmonic_re_v2_A_v2_conjA_v12
    store_complex(column_1, i, factor[1] * (A_v2 * conj_F));  // harmonic_re_v2_A_v2_F
  }
}

/// columns[j][i] of the rows.
inline void columns_20(const BatchArrays& data, double* const* columns) {
  rows_20(data, FactorValues<factors_20<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_20(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic -omega1+2*omega2 of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_21([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic -omega1+2*omega2 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + 2*omega2)*t) in v2 = harmonic_re_v2_A_v22_conjA_v1*conj(A_v1)*A_v2^2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_21(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * A_v2 * A_v2));  // harmonic_re_v2_A_v22_conjA_v1
  }
}

/// columns[j][i] of the rows.
inline void columns_21(const BatchArrays& data, double* const* columns) {
  rows_21(data, FactorValues<factors_21<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_21(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 2 terms of the harmonic omega2+Omega of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_22([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic omega2+Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + Omega)*t) in v2 = harmonic_re_v2_A_v2_F*A_v2*F +
/// harmonic_re_v2_A_v12_A_v2*A_v1^2*A_v2
/// 2 columns; per observation at most 8 products and sums of complex numbers.
template <class Factors>
void rows_22(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v2 * F));  // harmonic_re_v2_A_v2_F
    store_complex(column_1, i, factor[1] * (A_v1 * A_v1 * A_v2));  // harmonic_re_v2_A_v12_A_v2
  }
}

/// columns[j][i] of the rows.
inline void columns_22(const BatchArrays& data, double* const* columns) {
  rows_22(data, FactorValues<factors_22<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_22(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 2 terms of the harmonic omega1+Omega of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_24([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic omega1+Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + Omega)*t) in v2 = harmonic_re_v2_A_v1_F*A_v1*F + harmonic_re_v2_A_v13*A_v1^3
/// 2 columns; per observation at most 8 products and sums of complex numbers.
template <class Factors>
void rows_24(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * F));  // harmonic_re_v2_A_v1_F
    store_complex(column_1, i, factor[1] * (A_v1 * A_v1 * A_v1));  // harmonic_re_v2_A_v13
  }
}

/// columns[j][i] of the rows.
inline void columns_24(const BatchArrays& data, double* const* columns) {
  rows_24(data, FactorValues<factors_24<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_24(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic omega1+2*omega2 of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_25([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic omega1+2*omega2 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + 2*omega2)*t) in v2 = harmonic_re_v2_A_v1_A_v22*A_v1*A_v2^2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_25(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v2 * A_v2));  // harmonic_re_v2_A_v1_A_v22
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

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_v1/dt + i*(w_v1 - omega1)*B_v1 = -mu11*A_v1 + i*conservative_v1_A_v1*A_v1 +
/// i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) - 3*omega1^2/2*mu13*A_v1^2*conj(A_v1) +
/// i*conservative_v1_A_v12_conjA_v1*A_v1^2*conj(A_v1) + i*conservative_v1_conjA_v1_F*conj(A_v1)*F with A = B in
/// that frame
/// dB_v2/dt + i*(w_v2 - omega2)*B_v2 = -omega2/omega1*i*conservative_v1_A_v1*A_v2 +
/// omega1/omega2*i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*conj(A_v1)*A_v2 - mu22*A_v2 -
/// 3*omega2^2/2*mu23*A_v2^2*conj(A_v2) + i*conservative_v2_A_v22_conjA_v2*A_v2^2*conj(A_v2) with A = B in that
/// frame
/// 45 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  Scalar lumps[56];
  evaluate_lumps(parameters, lumps);
  const Complex A_v1 = load_complex(amplitude, 0);
  const Complex conj_A_v1 = conjugate(A_v1);
  const Scalar norm_A_v1 = norm_of(A_v1);
  const Complex A_v2 = load_complex(amplitude, 1);
  const Scalar norm_A_v2 = norm_of(A_v2);
  const Complex F = load_complex(forcing, 0);
  store_complex(derivative, 0, lumps[0] * (-Scalar(1.0)) * (A_v1)
       + times_i(lumps[1] * (A_v1))
       + times_i(lumps[2] * (A_v1 * norm_A_v2))
       + lumps[3] * (-Scalar(3.0) * omega1_2 / Scalar(2.0)) * (norm_A_v1 * A_v1)
       + times_i(lumps[4] * (norm_A_v1 * A_v1))
       + times_i(lumps[5] * (conj_A_v1 * F))
       - times_i((-omega1 + excitation_frequency[0] / Scalar(2.0)) * A_v1));
  store_complex(derivative, 1, times_i(lumps[1] * (-omega2 / omega1) * (A_v2))
       + times_i(lumps[2] * omega1 / omega2 * (norm_A_v1 * A_v2))
       + lumps[6] * (-Scalar(1.0)) * (A_v2)
       + lumps[7] * (-Scalar(3.0) * omega2_2 / Scalar(2.0)) * (norm_A_v2 * A_v2)
       + times_i(lumps[8] * (norm_A_v2 * A_v2)));
}

/// jacobian[i * 4 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 81 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  Scalar lumps[56];
  evaluate_lumps(parameters, lumps);
  const Complex A_v1 = load_complex(amplitude, 0);
  const Complex conj_A_v1 = conjugate(A_v1);
  const Scalar norm_A_v1 = norm_of(A_v1);
  const Complex A_v2 = load_complex(amplitude, 1);
  const Complex conj_A_v2 = conjugate(A_v2);
  const Scalar norm_A_v2 = norm_of(A_v2);
  const Complex F = load_complex(forcing, 0);
  for (std::size_t i = 0; i < 16; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = Complex(lumps[0] * (-Scalar(1.0)))
       + times_i(Complex(lumps[1]))
       + times_i(Complex(lumps[2] * (norm_A_v2)))
       + Complex(lumps[3] * (-Scalar(3.0) * omega1_2 / Scalar(2.0)) * Scalar(2) * (norm_A_v1))
       + times_i(Complex(lumps[4] * Scalar(2) * (norm_A_v1)))
       - Complex(Scalar(0.0), -omega1 + excitation_frequency[0] / Scalar(2.0));
  const Complex conj_by_0_0 = lumps[3] * (-Scalar(3.0) * omega1_2 / Scalar(2.0)) * (A_v1 * A_v1)
       + times_i(lumps[4] * (A_v1 * A_v1))
       + times_i(lumps[5] * (F));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[4] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[5] = by_0_0.real - conj_by_0_0.real;
  const Complex by_0_1 = times_i(lumps[2] * (A_v1 * conj_A_v2));
  const Complex conj_by_0_1 = times_i(lumps[2] * (A_v1 * A_v2));
  jacobian[2] = by_0_1.real + conj_by_0_1.real;
  jacobian[3] = conj_by_0_1.imag - by_0_1.imag;
  jacobian[6] = by_0_1.imag + conj_by_0_1.imag;
  jacobian[7] = by_0_1.real - conj_by_0_1.real;
  const Complex by_1_0 = times_i(lumps[2] * omega1 / omega2 * (conj_A_v1 * A_v2));
  const Complex conj_by_1_0 = times_i(lumps[2] * omega1 / omega2 * (A_v1 * A_v2));
  jacobian[8] = by_1_0.real + conj_by_1_0.real;
  jacobian[9] = conj_by_1_0.imag - by_1_0.imag;
  jacobian[12] = by_1_0.imag + conj_by_1_0.imag;
  jacobian[13] = by_1_0.real - conj_by_1_0.real;
  const Complex by_1_1 = times_i(Complex(lumps[1] * (-omega2 / omega1)))
       + times_i(Complex(lumps[2] * omega1 / omega2 * (norm_A_v1)))
       + Complex(lumps[6] * (-Scalar(1.0)))
       + Complex(lumps[7] * (-Scalar(3.0) * omega2_2 / Scalar(2.0)) * Scalar(2) * (norm_A_v2))
       + times_i(Complex(lumps[8] * Scalar(2) * (norm_A_v2)));
  const Complex conj_by_1_1 = lumps[7] * (-Scalar(3.0) * omega2_2 / Scalar(2.0)) * (A_v2 * A_v2)
       + times_i(lumps[8] * (A_v2 * A_v2));
  jacobian[10] = by_1_1.real + conj_by_1_1.real;
  jacobian[11] = conj_by_1_1.imag - by_1_1.imag;
  jacobian[14] = by_1_1.imag + conj_by_1_1.imag;
  jacobian[15] = by_1_1.real - conj_by_1_1.real;
}

}  // namespace principal_parametric_1

namespace principal_parametric_2 {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: mu11 = mu11
/// lumps[3]: mu13 = mu13
/// lumps[5]: mu22 = mu22
/// lumps[6]: mu23 = mu23
/// lumps[11]: harmonic_re_v1_A_v2_conjA_v2 = (2*omega2^2*delta23 - 2*alpha23)/omega1^2
/// lumps[12]: harmonic_re_v1_A_v1_conjA_v1 = (2*omega1^2*delta21 - 2*alpha21)/omega1^2
/// lumps[13]: eta11 = eta11
/// lumps[17]: mu12 = mu12
/// lumps[23]: harmonic_re_v1_A_v12 = (-3*omega1^2*delta21 + alpha21)/(3*omega1^2)
/// lumps[36]: harmonic_re_v2_A_v2_conjA_v2 = (2*omega2^2*delta24 - 2*alpha24)/omega2^2
/// lumps[37]: harmonic_re_v2_A_v1_conjA_v1 = (2*omega1^2*delta22 - 2*alpha22)/omega2^2
/// lumps[38]: eta21 = eta21
/// lumps[39]: harmonic_re_v2_A_v22 = (-3*omega2^2*delta24 + alpha24)/(3*omega2^2)
/// lumps[42]: mu21 = mu21
/// 30 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu11 = parameters[2];
  const Scalar mu12 = parameters[3];
  const Scalar mu13 = parameters[4];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar eta11 = parameters[20];
  const Scalar mu22 = parameters[22];
  const Scalar mu21 = parameters[23];
  const Scalar mu23 = parameters[24];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar eta21 = parameters[29];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  lumps[0] = mu11;  // mu11
  lumps[1] = lump_0(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v1
  lumps[2] = lump_1(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v1_A_v2_conjA_v2
  lumps[3] = mu13;  // mu13
  lumps[4] = lump_2(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v12_conjA_v1
  lumps[5] = mu22;  // mu22
  lumps[6] = mu23;  // mu23
  lumps[7] = lump_5(parameters, static_cast<Scalar*>(nullptr));  // conservative_v2_A_v22_conjA_v2
  lumps[8] = lump_74(parameters, static_cast<Scalar*>(nullptr));  // conservative_v2_conjA_v2_F
  lumps[9] = lump_6(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v2_conjA_v1
  lumps[10] = lump_7(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v2_conjA_v1
  // harmonic_re_v1_A_v2_conjA_v2
  lumps[11] = (Scalar(2.0) * omega2_2 * delta23 - Scalar(2.0) * alpha23) / omega1_2;
  // harmonic_re_v1_A_v1_conjA_v1
  lumps[12] = (Scalar(2.0) * omega1_2 * delta21 - Scalar(2.0) * alpha21) / omega1_2;
  lumps[13] = eta11;  // eta11
  lumps[14] = lump_13(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v22
  lumps[15] = lump_75(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_F
  lumps[16] = lump_14(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v22
  lumps[17] = mu12;  // mu12
  lumps[18] = lump_76(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_conjA_v2_F
  lumps[19] = lump_10(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v22_conjA_v2
  lumps[20] = lump_11(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_A_v2_conjA_v1
  lumps[21] = lump_16(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_A_v2
  lumps[22] = lump_17(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v1_A_v2
  lumps[23] = (-Scalar(3.0) * omega1_2 * delta21 + alpha21) / (Scalar(3.0) * omega1_2);  // harmonic_re_v1_A_v12
  lumps[24] = lump_15(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v12
  lumps[25] = lump_18(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v2_conjA_v12
  lumps[26] = lump_77(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_conjA_v1_F
  lumps[27] = lump_19(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v22_conjA_v1
  lumps[28] = lump_78(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v2_F
  lumps[29] = lump_22(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v23
  lumps[30] = lump_79(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_F
  lumps[31] = lump_21(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_A_v22
  lumps[32] = lump_24(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v12_A_v2
  lumps[33] = lump_23(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v13
  lumps[34] = lump_25(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v2_conjA_v1
  lumps[35] = lump_26(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v2_conjA_v1
  // harmonic_re_v2_A_v2_conjA_v2
  lumps[36] = (Scalar(2.0) * omega2_2 * delta24 - Scalar(2.0) * alpha24) / omega2_2;
  // harmonic_re_v2_A_v1_conjA_v1
  lumps[37] = (Scalar(2.0) * omega1_2 * delta22 - Scalar(2.0) * alpha22) / omega2_2;
  lumps[38] = eta21;  // eta21
  lumps[39] = (-Scalar(3.0) * omega2_2 * delta24 + alpha24) / (Scalar(3.0) * omega2_2);  // harmonic_re_v2_A_v22
  lumps[40] = lump_80(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_F
  lumps[41] = lump_30(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v22
  lumps[42] = mu21;  // mu21
  lumps[43] = lump_33(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_A_v2_conjA_v2
  lumps[44] = lump_34(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v12_conjA_v1
  lumps[45] = lump_28(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_A_v2
  lumps[46] = lump_29(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v1_A_v2
  lumps[47] = lump_36(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v12
  lumps[48] = lump_38(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v12
  lumps[49] = lump_39(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v2_conjA_v12
  lumps[50] = lump_81(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_conjA_v1_F
  lumps[51] = lump_41(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v22_conjA_v1
  lumps[52] = lump_82(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v2_F
  lumps[53] = lump_46(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v23
  lumps[54] = lump_83(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_F
  lumps[55] = lump_45(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_A_v22
  lumps[56] = lump_44(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v12_A_v2
  lumps[57] = lump_47(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v13
}

/// jacobian[l * 31 + p] = d lumps[l] / d parameters[p]. 38 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar alpha24 = parameters[25];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  for (std::size_t i = 0; i < 1798; ++i) jacobian[i] = Scalar(0.0);
  jacobian[2] = Scalar(1.0);  // d mu11 / d mu11
  lump_0(parameters, jacobian + 31);  // d conservative_v1_A_v1
  lump_1(parameters, jacobian + 62);  // d conservative_v1_A_v1_A_v2_conjA_v2
  jacobian[97] = Scalar(1.0);  // d mu13 / d mu13
  lump_2(parameters, jacobian + 124);  // d conservative_v1_A_v12_conjA_v1
  jacobian[177] = Scalar(1.0);  // d mu22 / d mu22
  jacobian[210] = Scalar(1.0);  // d mu23 / d mu23
  lump_5(parameters, jacobian + 217);  // d conservative_v2_A_v22_conjA_v2
  lump_74(parameters, jacobian + 248);  // d conservative_v2_conjA_v2_F
  lump_6(parameters, jacobian + 279);  // d harmonic_re_v1_A_v2_conjA_v1
  lump_7(parameters, jacobian + 310);  // d harmonic_im_v1_A_v2_conjA_v1
  // d harmonic_re_v1_A_v2_conjA_v2 / d omega1
  jacobian[341] = (-Scalar(4.0) * omega2_2 * delta23 + Scalar(4.0) * alpha23) / omega1_3;
  jacobian[342] = Scalar(4.0) * omega2 * delta23 / omega1_2;  // d harmonic_re_v1_A_v2_conjA_v2 / d omega2
  jacobian[348] = -Scalar(2.0) / omega1_2;  // d harmonic_re_v1_A_v2_conjA_v2 / d alpha23
  jacobian[351] = Scalar(2.0) * omega2_2 / omega1_2;  // d harmonic_re_v1_A_v2_conjA_v2 / d delta23
  jacobian[372] = Scalar(4.0) * alpha21 / omega1_3;  // d harmonic_re_v1_A_v1_conjA_v1 / d omega1
  jacobian[377] = -Scalar(2.0) / omega1_2;  // d harmonic_re_v1_A_v1_conjA_v1 / d alpha21
  jacobian[380] = Scalar(2.0);  // d harmonic_re_v1_A_v1_conjA_v1 / d delta21
  jacobian[423] = Scalar(1.0);  // d eta11 / d eta11
  lump_13(parameters, jacobian + 434);  // d harmonic_re_v1_A_v22
  lump_75(parameters, jacobian + 465);  // d harmonic_im_v1_F
  lump_14(parameters, jacobian + 496);  // d harmonic_im_v1_A_v22
  jacobian[530] = Scalar(1.0);  // d mu12 / d mu12
  lump_76(parameters, jacobian + 558);  // d harmonic_re_v1_conjA_v2_F
  lump_10(parameters, jacobian + 589);  // d harmonic_re_v1_A_v22_conjA_v2
  lump_11(parameters, jacobian + 620);  // d harmonic_re_v1_A_v1_A_v2_conjA_v1
  lump_16(parameters, jacobian + 651);  // d harmonic_re_v1_A_v1_A_v2
  lump_17(parameters, jacobian + 682);  // d harmonic_im_v1_A_v1_A_v2
  jacobian[713] = -Scalar(2.0) * alpha21 / (Scalar(3.0) * omega1_3);  // d harmonic_re_v1_A_v12 / d omega1
  jacobian[718] = Scalar(1.0) / (Scalar(3.0) * omega1_2);  // d harmonic_re_v1_A_v12 / d alpha21
  jacobian[721] = -Scalar(1.0);  // d harmonic_re_v1_A_v12 / d delta21
  lump_15(parameters, jacobian + 744);  // d harmonic_im_v1_A_v12
  lump_18(parameters, jacobian + 775);  // d harmonic_re_v1_A_v2_conjA_v12
  lump_77(parameters, jacobian + 806);  // d harmonic_re_v1_conjA_v1_F
  lump_19(parameters, jacobian + 837);  // d harmonic_re_v1_A_v22_conjA_v1
  lump_78(parameters, jacobian + 868);  // d harmonic_re_v1_A_v2_F
  lump_22(parameters, jacobian + 899);  // d harmonic_re_v1_A_v23
  lump_79(parameters, jacobian + 930);  // d harmonic_re_v1_A_v1_F
  lump_21(parameters, jacobian + 961);  // d harmonic_re_v1_A_v1_A_v22
  lump_24(parameters, jacobian + 992);  // d harmonic_re_v1_A_v12_A_v2
  lump_23(parameters, jacobian + 1023);  // d harmonic_re_v1_A_v13
  lump_25(parameters, jacobian + 1054);  // d harmonic_re_v2_A_v2_conjA_v1
  lump_26(parameters, jacobian + 1085);  // d harmonic_im_v2_A_v2_conjA_v1
  jacobian[1117] = Scalar(4.0) * alpha24 / omega2_3;  // d harmonic_re_v2_A_v2_conjA_v2 / d omega2
  jacobian[1141] = -Scalar(2.0) / omega2_2;  // d harmonic_re_v2_A_v2_conjA_v2 / d alpha24
  jacobian[1142] = Scalar(2.0);  // d harmonic_re_v2_A_v2_conjA_v2 / d delta24
  jacobian[1147] = Scalar(4.0) * omega1 * delta22 / omega2_2;  // d harmonic_re_v2_A_v1_conjA_v1 / d omega1
  // d harmonic_re_v2_A_v1_conjA_v1 / d omega2
  jacobian[1148] = (-Scalar(4.0) * omega1_2 * delta22 + Scalar(4.0) * alpha22) / omega2_3;
  jacobian[1153] = -Scalar(2.0) / omega2_2;  // d harmonic_re_v2_A_v1_conjA_v1 / d alpha22
  jacobian[1156] = Scalar(2.0) * omega1_2 / omega2_2;  // d harmonic_re_v2_A_v1_conjA_v1 / d delta22
  jacobian[1207] = Scalar(1.0);  // d eta21 / d eta21
  jacobian[1210] = -Scalar(2.0) * alpha24 / (Scalar(3.0) * omega2_3);  // d harmonic_re_v2_A_v22 / d omega2
  jacobian[1234] = Scalar(1.0) / (Scalar(3.0) * omega2_2);  // d harmonic_re_v2_A_v22 / d alpha24
  jacobian[1235] = -Scalar(1.0);  // d harmonic_re_v2_A_v22 / d delta24
  lump_80(parameters, jacobian + 1240);  // d harmonic_im_v2_F
  lump_30(parameters, jacobian + 1271);  // d harmonic_im_v2_A_v22
  jacobian[1325] = Scalar(1.0);  // d mu21 / d mu21
  lump_33(parameters, jacobian + 1333);  // d harmonic_re_v2_A_v1_A_v2_conjA_v2
  lump_34(parameters, jacobian + 1364);  // d harmonic_re_v2_A_v12_conjA_v1
  lump_28(parameters, jacobian + 1395);  // d harmonic_re_v2_A_v1_A_v2
  lump_29(parameters, jacobian + 1426);  // d harmonic_im_v2_A_v1_A_v2
  lump_36(parameters, jacobian + 1457);  // d harmonic_re_v2_A_v12
  lump_38(parameters, jacobian + 1488);  // d harmonic_im_v2_A_v12
  lump_39(parameters, jacobian + 1519);  // d harmonic_re_v2_A_v2_conjA_v12
  lump_81(parameters, jacobian + 1550);  // d harmonic_re_v2_conjA_v1_F
  lump_41(parameters, jacobian + 1581);  // d harmonic_re_v2_A_v22_conjA_v1
  lump_82(parameters, jacobian + 1612);  // d harmonic_re_v2_A_v2_F
  lump_46(parameters, jacobian + 1643);  // d harmonic_re_v2_A_v23
  lump_83(parameters, jacobian + 1674);  // d harmonic_re_v2_A_v1_F
  lump_45(parameters, jacobian + 1705);  // d harmonic_re_v2_A_v1_A_v22
  lump_44(parameters, jacobian + 1736);  // d harmonic_re_v2_A_v12_A_v2
  lump_47(parameters, jacobian + 1767);  // d harmonic_re_v2_A_v13
}

/// What multiplies the 5 terms of the modulation of v1: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  factor[0] = -Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = -Scalar(3.0) * omega1_2 / Scalar(2.0);
  factor[4] = Scalar(1.0);
}

/// Rows of the modulation of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega1)*A_v1 = -mu11*A_v1 + i*conservative_v1_A_v1*A_v1 +
/// i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) - 3*omega1^2/2*mu13*A_v1^2*conj(A_v1) +
/// i*conservative_v1_A_v12_conjA_v1*A_v1^2*conj(A_v1)
/// 5 columns; per observation at most 11 products and sums of complex numbers.
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
  Scalar factor[5];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    store_complex(column_0, i, factor[0] * (A_v1));  // mu11
    store_complex(column_1, i, times_i(factor[1] * (A_v1)));  // conservative_v1_A_v1
    store_complex(column_2, i, times_i(factor[2] * (A_v1 * norm_A_v2)));  // conservative_v1_A_v1_A_v2_conjA_v2
    store_complex(column_3, i, factor[3] * (norm_A_v1 * A_v1));  // mu13
    store_complex(column_4, i, times_i(factor[4] * (norm_A_v1 * A_v1)));  // conservative_v1_A_v12_conjA_v1
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

/// What multiplies the 6 terms of the modulation of v2: functions of the frequencies alone. 5 operations.
template <class Scalar>
void factors_1([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega2_2 = omega2 * omega2;
  factor[0] = -omega2 / omega1;
  factor[1] = omega1 / omega2;
  factor[2] = -Scalar(1.0);
  factor[3] = -Scalar(3.0) * omega2_2 / Scalar(2.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
}

/// Rows of the modulation of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega2)*A_v2 = -omega2/omega1*i*conservative_v1_A_v1*A_v2 +
/// omega1/omega2*i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*conj(A_v1)*A_v2 - mu22*A_v2 -
/// 3*omega2^2/2*mu23*A_v2^2*conj(A_v2) + i*conservative_v2_A_v22_conjA_v2*A_v2^2*conj(A_v2) +
/// i*conservative_v2_conjA_v2_F*conj(A_v2)*F
/// 6 columns; per observation at most 14 products and sums of complex numbers.
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
  Scalar factor[6];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex conj_A_v2 = conjugate(A_v2);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, times_i(factor[0] * (A_v2)));  // conservative_v1_A_v1
    store_complex(column_1, i, times_i(factor[1] * (norm_A_v1 * A_v2)));  // conservative_v1_A_v1_A_v2_conjA_v2
    store_complex(column_2, i, factor[2] * (A_v2));  // mu22
    store_complex(column_3, i, factor[3] * (norm_A_v2 * A_v2));  // mu23
    store_complex(column_4, i, times_i(factor[4] * (norm_A_v2 * A_v2)));  // conservative_v2_A_v22_conjA_v2
    store_complex(column_5, i, times_i(factor[5] * (conj_A_v2 * F)));  // conservative_v2_conjA_v2_F
  }
}

/// columns[j][i] of the rows.
inline void columns_1(const BatchArrays& data, double* const* columns) {
  rows_1(data, FactorValues<factors_1<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_1(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_1(data, FactorSlopes<factors_1<DualNumber>, 2, 1, 6>{mode}, columns);
}

/// What multiplies the 4 terms of the harmonic Omega of v1: functions of the frequencies alone. 8 operations.
template <class Scalar>
void factors_4([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - Scalar(2.0) * omega2);
  factor[0] = per_0 * per_1 / Scalar(2.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the harmonic Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(Omega)*t) in v1 = 1/(2*(omega1 + 2*omega2)*(omega1 - 2*omega2))*eta11*F +
/// harmonic_re_v1_A_v22*A_v2^2 + i*harmonic_im_v1_F*F + i*harmonic_im_v1_A_v22*A_v2^2
/// 4 columns; per observation at most 8 products and sums of complex numbers.
template <class Factors>
void rows_4(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
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
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (F));  // eta11
    store_complex(column_1, i, factor[1] * (A_v2 * A_v2));  // harmonic_re_v1_A_v22
    store_complex(column_2, i, times_i(factor[2] * (F)));  // harmonic_im_v1_F
    store_complex(column_3, i, times_i(factor[3] * (A_v2 * A_v2)));  // harmonic_im_v1_A_v22
  }
}

/// columns[j][i] of the rows.
inline void columns_4(const BatchArrays& data, double* const* columns) {
  rows_4(data, FactorValues<factors_4<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_4(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_4(data, FactorSlopes<factors_4<DualNumber>, 2, 1, 4>{mode}, columns);
}

/// What multiplies the 4 terms of the harmonic omega2 of v1: functions of the frequencies alone. 6 operations.
template <class Scalar>
void factors_5([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  factor[0] = -omega2 * per_0 * per_1;
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the harmonic omega2 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2)*t) in v1 = -omega2/((omega1 + omega2)*(omega1 - omega2))*i*mu12*A_v2 +
/// harmonic_re_v1_conjA_v2_F*conj(A_v2)*F + harmonic_re_v1_A_v22_conjA_v2*A_v2^2*conj(A_v2) +
/// harmonic_re_v1_A_v1_A_v2_conjA_v1*A_v1*conj(A_v1)*A_v2
/// 4 columns; per observation at most 10 products and sums of complex numbers.
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
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex conj_A_v2 = conjugate(A_v2);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, times_i(factor[0] * (A_v2)));  // mu12
    store_complex(column_1, i, factor[1] * (conj_A_v2 * F));  // harmonic_re_v1_conjA_v2_F
    store_complex(column_2, i, factor[2] * (norm_A_v2 * A_v2));  // harmonic_re_v1_A_v22_conjA_v2
    store_complex(column_3, i, factor[3] * (norm_A_v1 * A_v2));  // harmonic_re_v1_A_v1_A_v2_conjA_v1
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

/// What multiplies the 1 terms of the harmonic -2*omega1+omega2 of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_8([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic -2*omega1+omega2 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-2*omega1 + omega2)*t) in v1 = harmonic_re_v1_A_v2_conjA_v12*conj(A_v1)^2*A_v2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_8(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * conj_A_v1 * A_v2));  // harmonic_re_v1_A_v2_conjA_v12
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

/// What multiplies the 2 terms of the harmonic -omega1+Omega of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_9([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic -omega1+Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + Omega)*t) in v1 = harmonic_re_v1_conjA_v1_F*conj(A_v1)*F +
/// harmonic_re_v1_A_v22_conjA_v1*conj(A_v1)*A_v2^2
/// 2 columns; per observation at most 8 products and sums of complex numbers.
template <class Factors>
void rows_9(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * F));  // harmonic_re_v1_conjA_v1_F
    store_complex(column_1, i, factor[1] * (conj_A_v1 * A_v2 * A_v2));  // harmonic_re_v1_A_v22_conjA_v1
  }
}

/// columns[j][i] of the rows.
inline void columns_9(const BatchArrays& data, double* const* columns) {
  rows_9(data, FactorValues<factors_9<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_9(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 2 terms of the harmonic omega2+Omega of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_10([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic omega2+Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + Omega)*t) in v1 = harmonic_re_v1_A_v2_F*A_v2*F + harmonic_re_v1_A_v23*A_v2^3
/// 2 columns; per observation at most 8 products and sums of complex numbers.
template <class Factors>
void rows_10(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v2 * F));  // harmonic_re_v1_A_v2_F
    store_complex(column_1, i, factor[1] * (A_v2 * A_v2 * A_v2));  // harmonic_re_v1_A_v23
  }
}

/// columns[j][i] of the rows.
inline void columns_10(const BatchArrays& data, double* const* columns) {
  rows_10(data, FactorValues<factors_10<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_10(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 2 terms of the harmonic omega1+Omega of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_11([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic omega1+Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + Omega)*t) in v1 = harmonic_re_v1_A_v1_F*A_v1*F +
/// harmonic_re_v1_A_v1_A_v22*A_v1*A_v2^2
/// 2 columns; per observation at most 8 products and sums of complex numbers.
template <class Factors>
void rows_11(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * F));  // harmonic_re_v1_A_v1_F
    store_complex(column_1, i, factor[1] * (A_v1 * A_v2 * A_v2));  // harmonic_re_v1_A_v1_A_v22
  }
}

/// columns[j][i] of the rows.
inline void columns_11(const BatchArrays& data, double* const* columns) {
  rows_11(data, FactorValues<factors_11<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_11(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic 2*omega1+omega2 of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_12([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega1+omega2 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega1 + omega2)*t) in v1 = harmonic_re_v1_A_v12_A_v2*A_v1^2*A_v2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_12(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v1 * A_v2));  // harmonic_re_v1_A_v12_A_v2
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

/// What multiplies the 4 terms of the harmonic Omega of v2: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_16([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega2_2 = omega2 * omega2;
  factor[0] = -Scalar(1.0) / (Scalar(6.0) * omega2_2);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the harmonic Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(Omega)*t) in v2 = -1/(6*omega2^2)*eta21*F + harmonic_re_v2_A_v22*A_v2^2 +
/// i*harmonic_im_v2_F*F + i*harmonic_im_v2_A_v22*A_v2^2
/// 4 columns; per observation at most 8 products and sums of complex numbers.
template <class Factors>
void rows_16(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
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
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (F));  // eta21
    store_complex(column_1, i, factor[1] * (A_v2 * A_v2));  // harmonic_re_v2_A_v22
    store_complex(column_2, i, times_i(factor[2] * (F)));  // harmonic_im_v2_F
    store_complex(column_3, i, times_i(factor[3] * (A_v2 * A_v2)));  // harmonic_im_v2_A_v22
  }
}

/// columns[j][i] of the rows.
inline void columns_16(const BatchArrays& data, double* const* columns) {
  rows_16(data, FactorValues<factors_16<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_16(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_16(data, FactorSlopes<factors_16<DualNumber>, 2, 1, 4>{mode}, columns);
}

/// What multiplies the 3 terms of the harmonic omega1 of v2: functions of the frequencies alone. 6 operations.
template <class Scalar>
void factors_17([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  factor[0] = omega1 * per_0 * per_1;
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega1 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1)*t) in v2 = omega1/((omega1 + omega2)*(omega1 - omega2))*i*mu21*A_v1 +
/// harmonic_re_v2_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) + harmonic_re_v2_A_v12_conjA_v1*A_v1^2*conj(A_v1)
/// 3 columns; per observation at most 7 products and sums of complex numbers.
template <class Factors>
void rows_17(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    store_complex(column_0, i, times_i(factor[0] * (A_v1)));  // mu21
    store_complex(column_1, i, factor[1] * (A_v1 * norm_A_v2));  // harmonic_re_v2_A_v1_A_v2_conjA_v2
    store_complex(column_2, i, factor[2] * (norm_A_v1 * A_v1));  // harmonic_re_v2_A_v12_conjA_v1
  }
}

/// columns[j][i] of the rows.
inline void columns_17(const BatchArrays& data, double* const* columns) {
  rows_17(data, FactorValues<factors_17<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_17(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_17(data, FactorSlopes<factors_17<DualNumber>, 2, 1, 3>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic -2*omega1+omega2 of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_20([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic -2*omega1+omega2 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-2*omega1 + omega2)*t) in v2 = harmonic_re_v2_A_v2_conjA_v12*conj(A_v1)^2*A_v2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_20(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * conj_A_v1 * A_v2));  // harmonic_re_v2_A_v2_conjA_v12
  }
}

/// columns[j][i] of the rows.
inline void columns_20(const BatchArrays& data, double* const* columns) {
  rows_20(data, FactorValues<factors_20<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_20(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 2 terms of the harmonic -omega1+Omega of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_21([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic -omega1+Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + Omega)*t) in v2 = harmonic_re_v2_conjA_v1_F*conj(A_v1)*F +
/// harmonic_re_v2_A_v22_conjA_v1*conj(A_v1)*A_v2^2
/// 2 columns; per observation at most 8 products and sums of complex numbers.
template <class Factors>
void rows_21(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * F));  // harmonic_re_v2_conjA_v1_F
    store_complex(column_1, i, factor[1] * (conj_A_v1 * A_v2 * A_v2));  // harmonic_re_v2_A_v22_conjA_v1
  }
}

/// columns[j][i] of the rows.
inline void columns_21(const BatchArrays& data, double* const* columns) {
  rows_21(data, FactorValues<factors_21<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_21(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 3 terms of the harmonic omega2+Omega of v2: functions of the frequencies alone. 1
/// operations.
template <class Scalar>
void factors_22([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega2 = natural_frequency[1];
  factor[0] = -omega2 / Scalar(8.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega2+Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + Omega)*t) in v2 = -omega2/8*i*mu23*A_v2^3 + harmonic_re_v2_A_v2_F*A_v2*F +
/// harmonic_re_v2_A_v23*A_v2^3
/// 3 columns; per observation at most 13 products and sums of complex numbers.
template <class Factors>
void rows_22(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[3];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, times_i(factor[0] * (A_v2 * A_v2 * A_v2)));  // mu23
    store_complex(column_1, i, factor[1] * (A_v2 * F));  // harmonic_re_v2_A_v2_F
    store_complex(column_2, i, factor[2] * (A_v2 * A_v2 * A_v2));  // harmonic_re_v2_A_v23
  }
}

/// columns[j][i] of the rows.
inline void columns_22(const BatchArrays& data, double* const* columns) {
  rows_22(data, FactorValues<factors_22<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_22(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_22(data, FactorSlopes<factors_22<DualNumber>, 2, 1, 3>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic omega1+Omega of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_23([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic omega1+Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + Omega)*t) in v2 = harmonic_re_v2_A_v1_F*A_v1*F +
/// harmonic_re_v2_A_v1_A_v22*A_v1*A_v2^2
/// 2 columns; per observation at most 8 products and sums of complex numbers.
template <class Factors>
void rows_23(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * F));  // harmonic_re_v2_A_v1_F
    store_complex(column_1, i, factor[1] * (A_v1 * A_v2 * A_v2));  // harmonic_re_v2_A_v1_A_v22
  }
}

/// columns[j][i] of the rows.
inline void columns_23(const BatchArrays& data, double* const* columns) {
  rows_23(data, FactorValues<factors_23<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_23(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic 2*omega1+omega2 of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_24([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega1+omega2 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega1 + omega2)*t) in v2 = harmonic_re_v2_A_v12_A_v2*A_v1^2*A_v2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_24(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v1 * A_v2));  // harmonic_re_v2_A_v12_A_v2
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

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_v1/dt + i*(w_v1 - omega1)*B_v1 = -mu11*A_v1 + i*conservative_v1_A_v1*A_v1 +
/// i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) - 3*omega1^2/2*mu13*A_v1^2*conj(A_v1) +
/// i*conservative_v1_A_v12_conjA_v1*A_v1^2*conj(A_v1) with A = B in that frame
/// dB_v2/dt + i*(w_v2 - omega2)*B_v2 = -omega2/omega1*i*conservative_v1_A_v1*A_v2 +
/// omega1/omega2*i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*conj(A_v1)*A_v2 - mu22*A_v2 -
/// 3*omega2^2/2*mu23*A_v2^2*conj(A_v2) + i*conservative_v2_A_v22_conjA_v2*A_v2^2*conj(A_v2) +
/// i*conservative_v2_conjA_v2_F*conj(A_v2)*F with A = B in that frame
/// 45 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  Scalar lumps[58];
  evaluate_lumps(parameters, lumps);
  const Complex A_v1 = load_complex(amplitude, 0);
  const Scalar norm_A_v1 = norm_of(A_v1);
  const Complex A_v2 = load_complex(amplitude, 1);
  const Complex conj_A_v2 = conjugate(A_v2);
  const Scalar norm_A_v2 = norm_of(A_v2);
  const Complex F = load_complex(forcing, 0);
  store_complex(derivative, 0, lumps[0] * (-Scalar(1.0)) * (A_v1)
       + times_i(lumps[1] * (A_v1))
       + times_i(lumps[2] * (A_v1 * norm_A_v2))
       + lumps[3] * (-Scalar(3.0) * omega1_2 / Scalar(2.0)) * (norm_A_v1 * A_v1)
       + times_i(lumps[4] * (norm_A_v1 * A_v1)));
  store_complex(derivative, 1, times_i(lumps[1] * (-omega2 / omega1) * (A_v2))
       + times_i(lumps[2] * omega1 / omega2 * (norm_A_v1 * A_v2))
       + lumps[5] * (-Scalar(1.0)) * (A_v2)
       + lumps[6] * (-Scalar(3.0) * omega2_2 / Scalar(2.0)) * (norm_A_v2 * A_v2)
       + times_i(lumps[7] * (norm_A_v2 * A_v2))
       + times_i(lumps[8] * (conj_A_v2 * F))
       - times_i((-omega2 + excitation_frequency[0] / Scalar(2.0)) * A_v2));
}

/// jacobian[i * 4 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 81 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  Scalar lumps[58];
  evaluate_lumps(parameters, lumps);
  const Complex A_v1 = load_complex(amplitude, 0);
  const Complex conj_A_v1 = conjugate(A_v1);
  const Scalar norm_A_v1 = norm_of(A_v1);
  const Complex A_v2 = load_complex(amplitude, 1);
  const Complex conj_A_v2 = conjugate(A_v2);
  const Scalar norm_A_v2 = norm_of(A_v2);
  const Complex F = load_complex(forcing, 0);
  for (std::size_t i = 0; i < 16; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = Complex(lumps[0] * (-Scalar(1.0)))
       + times_i(Complex(lumps[1]))
       + times_i(Complex(lumps[2] * (norm_A_v2)))
       + Complex(lumps[3] * (-Scalar(3.0) * omega1_2 / Scalar(2.0)) * Scalar(2) * (norm_A_v1))
       + times_i(Complex(lumps[4] * Scalar(2) * (norm_A_v1)));
  const Complex conj_by_0_0 = lumps[3] * (-Scalar(3.0) * omega1_2 / Scalar(2.0)) * (A_v1 * A_v1)
       + times_i(lumps[4] * (A_v1 * A_v1));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[4] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[5] = by_0_0.real - conj_by_0_0.real;
  const Complex by_0_1 = times_i(lumps[2] * (A_v1 * conj_A_v2));
  const Complex conj_by_0_1 = times_i(lumps[2] * (A_v1 * A_v2));
  jacobian[2] = by_0_1.real + conj_by_0_1.real;
  jacobian[3] = conj_by_0_1.imag - by_0_1.imag;
  jacobian[6] = by_0_1.imag + conj_by_0_1.imag;
  jacobian[7] = by_0_1.real - conj_by_0_1.real;
  const Complex by_1_0 = times_i(lumps[2] * omega1 / omega2 * (conj_A_v1 * A_v2));
  const Complex conj_by_1_0 = times_i(lumps[2] * omega1 / omega2 * (A_v1 * A_v2));
  jacobian[8] = by_1_0.real + conj_by_1_0.real;
  jacobian[9] = conj_by_1_0.imag - by_1_0.imag;
  jacobian[12] = by_1_0.imag + conj_by_1_0.imag;
  jacobian[13] = by_1_0.real - conj_by_1_0.real;
  const Complex by_1_1 = times_i(Complex(lumps[1] * (-omega2 / omega1)))
       + times_i(Complex(lumps[2] * omega1 / omega2 * (norm_A_v1)))
       + Complex(lumps[5] * (-Scalar(1.0)))
       + Complex(lumps[6] * (-Scalar(3.0) * omega2_2 / Scalar(2.0)) * Scalar(2) * (norm_A_v2))
       + times_i(Complex(lumps[7] * Scalar(2) * (norm_A_v2)))
       - Complex(Scalar(0.0), -omega2 + excitation_frequency[0] / Scalar(2.0));
  const Complex conj_by_1_1 = lumps[6] * (-Scalar(3.0) * omega2_2 / Scalar(2.0)) * (A_v2 * A_v2)
       + times_i(lumps[7] * (A_v2 * A_v2))
       + times_i(lumps[8] * (F));
  jacobian[10] = by_1_1.real + conj_by_1_1.real;
  jacobian[11] = conj_by_1_1.imag - by_1_1.imag;
  jacobian[14] = by_1_1.imag + conj_by_1_1.imag;
  jacobian[15] = by_1_1.real - conj_by_1_1.real;
}

}  // namespace principal_parametric_2

namespace additive_combination {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: mu11 = mu11
/// lumps[4]: mu13 = mu13
/// lumps[8]: mu22 = mu22
/// lumps[10]: mu23 = mu23
/// lumps[13]: eta12 = eta12
/// lumps[14]: mu12 = mu12
/// lumps[22]: harmonic_re_v1_A_v2_conjA_v2 = (2*omega2^2*delta23 - 2*alpha23)/omega1^2
/// lumps[23]: harmonic_re_v1_A_v1_conjA_v1 = (2*omega1^2*delta21 - 2*alpha21)/omega1^2
/// lumps[26]: eta11 = eta11
/// lumps[37]: harmonic_re_v1_A_v12 = (-3*omega1^2*delta21 + alpha21)/(3*omega1^2)
/// lumps[53]: eta22 = eta22
/// lumps[54]: mu21 = mu21
/// lumps[58]: harmonic_re_v2_A_v2_conjA_v2 = (2*omega2^2*delta24 - 2*alpha24)/omega2^2
/// lumps[59]: harmonic_re_v2_A_v1_conjA_v1 = (2*omega1^2*delta22 - 2*alpha22)/omega2^2
/// lumps[62]: eta21 = eta21
/// lumps[70]: harmonic_re_v2_A_v22 = (-3*omega2^2*delta24 + alpha24)/(3*omega2^2)
/// 30 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu11 = parameters[2];
  const Scalar mu12 = parameters[3];
  const Scalar mu13 = parameters[4];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar eta11 = parameters[20];
  const Scalar eta12 = parameters[21];
  const Scalar mu22 = parameters[22];
  const Scalar mu21 = parameters[23];
  const Scalar mu23 = parameters[24];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar eta21 = parameters[29];
  const Scalar eta22 = parameters[30];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  lumps[0] = mu11;  // mu11
  lumps[1] = lump_0(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v1
  lumps[2] = lump_84(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v1_F2
  lumps[3] = lump_1(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v1_A_v2_conjA_v2
  lumps[4] = mu13;  // mu13
  lumps[5] = lump_2(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v12_conjA_v1
  lumps[6] = lump_85(parameters, static_cast<Scalar*>(nullptr));  // dissipative_v1_conjA_v2_F
  lumps[7] = lump_86(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_conjA_v2_F
  lumps[8] = mu22;  // mu22
  lumps[9] = lump_87(parameters, static_cast<Scalar*>(nullptr));  // conservative_v2_A_v2_F2
  lumps[10] = mu23;  // mu23
  lumps[11] = lump_5(parameters, static_cast<Scalar*>(nullptr));  // conservative_v2_A_v22_conjA_v2
  lumps[12] = lump_88(parameters, static_cast<Scalar*>(nullptr));  // dissipative_v2_conjA_v1_F
  lumps[13] = eta12;  // eta12
  lumps[14] = mu12;  // mu12
  lumps[15] = lump_89(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_conjA_v1_F
  lumps[16] = lump_10(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v22_conjA_v2
  lumps[17] = lump_11(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_A_v2_conjA_v1
  lumps[18] = lump_6(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v2_conjA_v1
  lumps[19] = lump_90(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_conjA_v12_F
  lumps[20] = lump_7(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v2_conjA_v1
  lumps[21] = lump_91(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v22_F
  // harmonic_re_v1_A_v2_conjA_v2
  lumps[22] = (Scalar(2.0) * omega2_2 * delta23 - Scalar(2.0) * alpha23) / omega1_2;
  // harmonic_re_v1_A_v1_conjA_v1
  lumps[23] = (Scalar(2.0) * omega1_2 * delta21 - Scalar(2.0) * alpha21) / omega1_2;
  lumps[24] = lump_92(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_conjA_v1_conjA_v2_F
  lumps[25] = lump_93(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_F2
  lumps[26] = eta11;  // eta11
  lumps[27] = lump_16(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_A_v2
  lumps[28] = lump_94(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_F
  lumps[29] = lump_95(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v2_conjA_v2_F
  lumps[30] = lump_96(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_conjA_v1_F
  lumps[31] = lump_17(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v1_A_v2
  lumps[32] = lump_13(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v22
  lumps[33] = lump_97(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v2_conjA_v1_F
  lumps[34] = lump_14(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v22
  lumps[35] = lump_98(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_F
  lumps[36] = lump_24(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v12_A_v2
  lumps[37] = (-Scalar(3.0) * omega1_2 * delta21 + alpha21) / (Scalar(3.0) * omega1_2);  // harmonic_re_v1_A_v12
  lumps[38] = lump_99(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_conjA_v2_F
  lumps[39] = lump_15(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v12
  lumps[40] = lump_18(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v2_conjA_v12
  lumps[41] = lump_100(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v2_F
  lumps[42] = lump_101(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v2_F
  lumps[43] = lump_21(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_A_v22
  lumps[44] = lump_19(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v22_conjA_v1
  lumps[45] = lump_102(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_A_v2_F
  lumps[46] = lump_22(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v23
  lumps[47] = lump_103(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v12_F
  lumps[48] = lump_23(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v13
  lumps[49] = lump_25(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v2_conjA_v1
  lumps[50] = lump_104(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_conjA_v12_F
  lumps[51] = lump_26(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v2_conjA_v1
  lumps[52] = lump_105(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v22_F
  lumps[53] = eta22;  // eta22
  lumps[54] = mu21;  // mu21
  lumps[55] = lump_106(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_conjA_v2_F
  lumps[56] = lump_33(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_A_v2_conjA_v2
  lumps[57] = lump_34(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v12_conjA_v1
  // harmonic_re_v2_A_v2_conjA_v2
  lumps[58] = (Scalar(2.0) * omega2_2 * delta24 - Scalar(2.0) * alpha24) / omega2_2;
  // harmonic_re_v2_A_v1_conjA_v1
  lumps[59] = (Scalar(2.0) * omega1_2 * delta22 - Scalar(2.0) * alpha22) / omega2_2;
  lumps[60] = lump_107(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_conjA_v1_conjA_v2_F
  lumps[61] = lump_108(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_F2
  lumps[62] = eta21;  // eta21
  lumps[63] = lump_28(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_A_v2
  lumps[64] = lump_109(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_F
  lumps[65] = lump_110(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v2_conjA_v2_F
  lumps[66] = lump_111(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_conjA_v1_F
  lumps[67] = lump_29(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v1_A_v2
  lumps[68] = lump_112(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v2_F
  lumps[69] = lump_45(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_A_v22
  lumps[70] = (-Scalar(3.0) * omega2_2 * delta24 + alpha24) / (Scalar(3.0) * omega2_2);  // harmonic_re_v2_A_v22
  lumps[71] = lump_113(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v2_conjA_v1_F
  lumps[72] = lump_30(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v22
  lumps[73] = lump_36(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v12
  lumps[74] = lump_114(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_conjA_v2_F
  lumps[75] = lump_38(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v12
  lumps[76] = lump_39(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v2_conjA_v12
  lumps[77] = lump_41(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v22_conjA_v1
  lumps[78] = lump_115(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_F
  lumps[79] = lump_116(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v1_F
  lumps[80] = lump_44(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v12_A_v2
  lumps[81] = lump_117(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_A_v2_F
  lumps[82] = lump_46(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v23
  lumps[83] = lump_118(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v12_F
  lumps[84] = lump_47(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v13
}

/// jacobian[l * 31 + p] = d lumps[l] / d parameters[p]. 38 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar alpha24 = parameters[25];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  for (std::size_t i = 0; i < 2635; ++i) jacobian[i] = Scalar(0.0);
  jacobian[2] = Scalar(1.0);  // d mu11 / d mu11
  lump_0(parameters, jacobian + 31);  // d conservative_v1_A_v1
  lump_84(parameters, jacobian + 62);  // d conservative_v1_A_v1_F2
  lump_1(parameters, jacobian + 93);  // d conservative_v1_A_v1_A_v2_conjA_v2
  jacobian[128] = Scalar(1.0);  // d mu13 / d mu13
  lump_2(parameters, jacobian + 155);  // d conservative_v1_A_v12_conjA_v1
  lump_85(parameters, jacobian + 186);  // d dissipative_v1_conjA_v2_F
  lump_86(parameters, jacobian + 217);  // d conservative_v1_conjA_v2_F
  jacobian[270] = Scalar(1.0);  // d mu22 / d mu22
  lump_87(parameters, jacobian + 279);  // d conservative_v2_A_v2_F2
  jacobian[334] = Scalar(1.0);  // d mu23 / d mu23
  lump_5(parameters, jacobian + 341);  // d conservative_v2_A_v22_conjA_v2
  lump_88(parameters, jacobian + 372);  // d dissipative_v2_conjA_v1_F
  jacobian[424] = Scalar(1.0);  // d eta12 / d eta12
  jacobian[437] = Scalar(1.0);  // d mu12 / d mu12
  lump_89(parameters, jacobian + 465);  // d harmonic_re_v1_conjA_v1_F
  lump_10(parameters, jacobian + 496);  // d harmonic_re_v1_A_v22_conjA_v2
  lump_11(parameters, jacobian + 527);  // d harmonic_re_v1_A_v1_A_v2_conjA_v1
  lump_6(parameters, jacobian + 558);  // d harmonic_re_v1_A_v2_conjA_v1
  lump_90(parameters, jacobian + 589);  // d harmonic_re_v1_conjA_v12_F
  lump_7(parameters, jacobian + 620);  // d harmonic_im_v1_A_v2_conjA_v1
  lump_91(parameters, jacobian + 651);  // d harmonic_re_v1_A_v22_F
  // d harmonic_re_v1_A_v2_conjA_v2 / d omega1
  jacobian[682] = (-Scalar(4.0) * omega2_2 * delta23 + Scalar(4.0) * alpha23) / omega1_3;
  jacobian[683] = Scalar(4.0) * omega2 * delta23 / omega1_2;  // d harmonic_re_v1_A_v2_conjA_v2 / d omega2
  jacobian[689] = -Scalar(2.0) / omega1_2;  // d harmonic_re_v1_A_v2_conjA_v2 / d alpha23
  jacobian[692] = Scalar(2.0) * omega2_2 / omega1_2;  // d harmonic_re_v1_A_v2_conjA_v2 / d delta23
  jacobian[713] = Scalar(4.0) * alpha21 / omega1_3;  // d harmonic_re_v1_A_v1_conjA_v1 / d omega1
  jacobian[718] = -Scalar(2.0) / omega1_2;  // d harmonic_re_v1_A_v1_conjA_v1 / d alpha21
  jacobian[721] = Scalar(2.0);  // d harmonic_re_v1_A_v1_conjA_v1 / d delta21
  lump_92(parameters, jacobian + 744);  // d harmonic_re_v1_conjA_v1_conjA_v2_F
  lump_93(parameters, jacobian + 775);  // d harmonic_re_v1_F2
  jacobian[826] = Scalar(1.0);  // d eta11 / d eta11
  lump_16(parameters, jacobian + 837);  // d harmonic_re_v1_A_v1_A_v2
  lump_94(parameters, jacobian + 868);  // d harmonic_im_v1_F
  lump_95(parameters, jacobian + 899);  // d harmonic_re_v1_A_v2_conjA_v2_F
  lump_96(parameters, jacobian + 930);  // d harmonic_re_v1_A_v1_conjA_v1_F
  lump_17(parameters, jacobian + 961);  // d harmonic_im_v1_A_v1_A_v2
  lump_13(parameters, jacobian + 992);  // d harmonic_re_v1_A_v22
  lump_97(parameters, jacobian + 1023);  // d harmonic_re_v1_A_v2_conjA_v1_F
  lump_14(parameters, jacobian + 1054);  // d harmonic_im_v1_A_v22
  lump_98(parameters, jacobian + 1085);  // d harmonic_re_v1_A_v1_F
  lump_24(parameters, jacobian + 1116);  // d harmonic_re_v1_A_v12_A_v2
  jacobian[1147] = -Scalar(2.0) * alpha21 / (Scalar(3.0) * omega1_3);  // d harmonic_re_v1_A_v12 / d omega1
  jacobian[1152] = Scalar(1.0) / (Scalar(3.0) * omega1_2);  // d harmonic_re_v1_A_v12 / d alpha21
  jacobian[1155] = -Scalar(1.0);  // d harmonic_re_v1_A_v12 / d delta21
  lump_99(parameters, jacobian + 1178);  // d harmonic_re_v1_A_v1_conjA_v2_F
  lump_15(parameters, jacobian + 1209);  // d harmonic_im_v1_A_v12
  lump_18(parameters, jacobian + 1240);  // d harmonic_re_v1_A_v2_conjA_v12
  lump_100(parameters, jacobian + 1271);  // d harmonic_re_v1_A_v2_F
  lump_101(parameters, jacobian + 1302);  // d harmonic_im_v1_A_v2_F
  lump_21(parameters, jacobian + 1333);  // d harmonic_re_v1_A_v1_A_v22
  lump_19(parameters, jacobian + 1364);  // d harmonic_re_v1_A_v22_conjA_v1
  lump_102(parameters, jacobian + 1395);  // d harmonic_re_v1_A_v1_A_v2_F
  lump_22(parameters, jacobian + 1426);  // d harmonic_re_v1_A_v23
  lump_103(parameters, jacobian + 1457);  // d harmonic_re_v1_A_v12_F
  lump_23(parameters, jacobian + 1488);  // d harmonic_re_v1_A_v13
  lump_25(parameters, jacobian + 1519);  // d harmonic_re_v2_A_v2_conjA_v1
  lump_104(parameters, jacobian + 1550);  // d harmonic_re_v2_conjA_v12_F
  lump_26(parameters, jacobian + 1581);  // d harmonic_im_v2_A_v2_conjA_v1
  lump_105(parameters, jacobian + 1612);  // d harmonic_re_v2_A_v22_F
  jacobian[1673] = Scalar(1.0);  // d eta22 / d eta22
  jacobian[1697] = Scalar(1.0);  // d mu21 / d mu21
  lump_106(parameters, jacobian + 1705);  // d harmonic_re_v2_conjA_v2_F
  lump_33(parameters, jacobian + 1736);  // d harmonic_re_v2_A_v1_A_v2_conjA_v2
  lump_34(parameters, jacobian + 1767);  // d harmonic_re_v2_A_v12_conjA_v1
  jacobian[1799] = Scalar(4.0) * alpha24 / omega2_3;  // d harmonic_re_v2_A_v2_conjA_v2 / d omega2
  jacobian[1823] = -Scalar(2.0) / omega2_2;  // d harmonic_re_v2_A_v2_conjA_v2 / d alpha24
  jacobian[1824] = Scalar(2.0);  // d harmonic_re_v2_A_v2_conjA_v2 / d delta24
  jacobian[1829] = Scalar(4.0) * omega1 * delta22 / omega2_2;  // d harmonic_re_v2_A_v1_conjA_v1 / d omega1
  // d harmonic_re_v2_A_v1_conjA_v1 / d omega2
  jacobian[1830] = (-Scalar(4.0) * omega1_2 * delta22 + Scalar(4.0) * alpha22) / omega2_3;
  jacobian[1835] = -Scalar(2.0) / omega2_2;  // d harmonic_re_v2_A_v1_conjA_v1 / d alpha22
  jacobian[1838] = Scalar(2.0) * omega1_2 / omega2_2;  // d harmonic_re_v2_A_v1_conjA_v1 / d delta22
  lump_107(parameters, jacobian + 1860);  // d harmonic_re_v2_conjA_v1_conjA_v2_F
  lump_108(parameters, jacobian + 1891);  // d harmonic_re_v2_F2
  jacobian[1951] = Scalar(1.0);  // d eta21 / d eta21
  lump_28(parameters, jacobian + 1953);  // d harmonic_re_v2_A_v1_A_v2
  lump_109(parameters, jacobian + 1984);  // d harmonic_im_v2_F
  lump_110(parameters, jacobian + 2015);  // d harmonic_re_v2_A_v2_conjA_v2_F
  lump_111(parameters, jacobian + 2046);  // d harmonic_re_v2_A_v1_conjA_v1_F
  lump_29(parameters, jacobian + 2077);  // d harmonic_im_v2_A_v1_A_v2
  lump_112(parameters, jacobian + 2108);  // d harmonic_re_v2_A_v2_F
  lump_45(parameters, jacobian + 2139);  // d harmonic_re_v2_A_v1_A_v22
  jacobian[2171] = -Scalar(2.0) * alpha24 / (Scalar(3.0) * omega2_3);  // d harmonic_re_v2_A_v22 / d omega2
  jacobian[2195] = Scalar(1.0) / (Scalar(3.0) * omega2_2);  // d harmonic_re_v2_A_v22 / d alpha24
  jacobian[2196] = -Scalar(1.0);  // d harmonic_re_v2_A_v22 / d delta24
  lump_113(parameters, jacobian + 2201);  // d harmonic_re_v2_A_v2_conjA_v1_F
  lump_30(parameters, jacobian + 2232);  // d harmonic_im_v2_A_v22
  lump_36(parameters, jacobian + 2263);  // d harmonic_re_v2_A_v12
  lump_114(parameters, jacobian + 2294);  // d harmonic_re_v2_A_v1_conjA_v2_F
  lump_38(parameters, jacobian + 2325);  // d harmonic_im_v2_A_v12
  lump_39(parameters, jacobian + 2356);  // d harmonic_re_v2_A_v2_conjA_v12
  lump_41(parameters, jacobian + 2387);  // d harmonic_re_v2_A_v22_conjA_v1
  lump_115(parameters, jacobian + 2418);  // d harmonic_re_v2_A_v1_F
  lump_116(parameters, jacobian + 2449);  // d harmonic_im_v2_A_v1_F
  lump_44(parameters, jacobian + 2480);  // d harmonic_re_v2_A_v12_A_v2
  lump_117(parameters, jacobian + 2511);  // d harmonic_re_v2_A_v1_A_v2_F
  lump_46(parameters, jacobian + 2542);  // d harmonic_re_v2_A_v23
  lump_118(parameters, jacobian + 2573);  // d harmonic_re_v2_A_v12_F
  lump_47(parameters, jacobian + 2604);  // d harmonic_re_v2_A_v13
}

/// What multiplies the 8 terms of the modulation of v1: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  factor[0] = -Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = -Scalar(3.0) * omega1_2 / Scalar(2.0);
  factor[5] = Scalar(1.0);
  factor[6] = Scalar(1.0);
  factor[7] = Scalar(1.0);
}

/// Rows of the modulation of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega1)*A_v1 = -mu11*A_v1 + i*conservative_v1_A_v1*A_v1 + i*conservative_v1_A_v1_F2*A_v1*F^2 +
/// i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) - 3*omega1^2/2*mu13*A_v1^2*conj(A_v1) +
/// i*conservative_v1_A_v12_conjA_v1*A_v1^2*conj(A_v1) + dissipative_v1_conjA_v2_F*conj(A_v2)*F +
/// i*conservative_v1_conjA_v2_F*conj(A_v2)*F
/// 8 columns; per observation at most 20 products and sums of complex numbers.
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex conj_A_v2 = conjugate(A_v2);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    const Scalar norm_F = norm_of(F);
    store_complex(column_0, i, factor[0] * (A_v1));  // mu11
    store_complex(column_1, i, times_i(factor[1] * (A_v1)));  // conservative_v1_A_v1
    store_complex(column_2, i, times_i(factor[2] * (A_v1 * norm_F)));  // conservative_v1_A_v1_F2
    store_complex(column_3, i, times_i(factor[3] * (A_v1 * norm_A_v2)));  // conservative_v1_A_v1_A_v2_conjA_v2
    store_complex(column_4, i, factor[4] * (norm_A_v1 * A_v1));  // mu13
    store_complex(column_5, i, times_i(factor[5] * (norm_A_v1 * A_v1)));  // conservative_v1_A_v12_conjA_v1
    store_complex(column_6, i, factor[6] * (conj_A_v2 * F));  // dissipative_v1_conjA_v2_F
    store_complex(column_7, i, times_i(factor[7] * (conj_A_v2 * F)));  // conservative_v1_conjA_v2_F
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

/// What multiplies the 8 terms of the modulation of v2: functions of the frequencies alone. 6 operations.
template <class Scalar>
void factors_1([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega2_2 = omega2 * omega2;
  factor[0] = -omega2 / omega1;
  factor[1] = omega1 / omega2;
  factor[2] = omega1 / omega2;
  factor[3] = -Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = -Scalar(3.0) * omega2_2 / Scalar(2.0);
  factor[6] = Scalar(1.0);
  factor[7] = Scalar(1.0);
}

/// Rows of the modulation of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega2)*A_v2 = -omega2/omega1*i*conservative_v1_A_v1*A_v2 +
/// omega1/omega2*i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*conj(A_v1)*A_v2 +
/// omega1/omega2*i*conservative_v1_conjA_v2_F*conj(A_v1)*F - mu22*A_v2 + i*conservative_v2_A_v2_F2*A_v2*F^2 -
/// 3*omega2^2/2*mu23*A_v2^2*conj(A_v2) + i*conservative_v2_A_v22_conjA_v2*A_v2^2*conj(A_v2) +
/// dissipative_v2_conjA_v1_F*conj(A_v1)*F
/// 8 columns; per observation at most 20 products and sums of complex numbers.
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    const Scalar norm_F = norm_of(F);
    store_complex(column_0, i, times_i(factor[0] * (A_v2)));  // conservative_v1_A_v1
    store_complex(column_1, i, times_i(factor[1] * (norm_A_v1 * A_v2)));  // conservative_v1_A_v1_A_v2_conjA_v2
    store_complex(column_2, i, times_i(factor[2] * (conj_A_v1 * F)));  // conservative_v1_conjA_v2_F
    store_complex(column_3, i, factor[3] * (A_v2));  // mu22
    store_complex(column_4, i, times_i(factor[4] * (A_v2 * norm_F)));  // conservative_v2_A_v2_F2
    store_complex(column_5, i, factor[5] * (norm_A_v2 * A_v2));  // mu23
    store_complex(column_6, i, times_i(factor[6] * (norm_A_v2 * A_v2)));  // conservative_v2_A_v22_conjA_v2
    store_complex(column_7, i, factor[7] * (conj_A_v1 * F));  // dissipative_v2_conjA_v1_F
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

/// What multiplies the 5 terms of the harmonic omega2 of v1: functions of the frequencies alone. 8 operations.
template <class Scalar>
void factors_2([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  factor[0] = per_0 * per_1 / Scalar(2.0);
  factor[1] = -omega2 * per_0 * per_1;
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
}

/// Rows of the harmonic omega2 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2)*t) in v1 = 1/(2*(omega1 + omega2)*(omega1 - omega2))*eta12*conj(A_v1)*F -
/// omega2/((omega1 + omega2)*(omega1 - omega2))*i*mu12*A_v2 + harmonic_re_v1_conjA_v1_F*conj(A_v1)*F +
/// harmonic_re_v1_A_v22_conjA_v2*A_v2^2*conj(A_v2) + harmonic_re_v1_A_v1_A_v2_conjA_v1*A_v1*conj(A_v1)*A_v2
/// 5 columns; per observation at most 13 products and sums of complex numbers.
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
  Scalar factor[5];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * F));  // eta12
    store_complex(column_1, i, times_i(factor[1] * (A_v2)));  // mu12
    store_complex(column_2, i, factor[2] * (conj_A_v1 * F));  // harmonic_re_v1_conjA_v1_F
    store_complex(column_3, i, factor[3] * (norm_A_v2 * A_v2));  // harmonic_re_v1_A_v22_conjA_v2
    store_complex(column_4, i, factor[4] * (norm_A_v1 * A_v2));  // harmonic_re_v1_A_v1_A_v2_conjA_v1
  }
}

/// columns[j][i] of the rows.
inline void columns_2(const BatchArrays& data, double* const* columns) {
  rows_2(data, FactorValues<factors_2<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_2(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_2(data, FactorSlopes<factors_2<DualNumber>, 2, 1, 5>{mode}, columns);
}

/// What multiplies the 4 terms of the harmonic -omega1+omega2 of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_3([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the harmonic -omega1+omega2 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + omega2)*t) in v1 = harmonic_re_v1_A_v2_conjA_v1*conj(A_v1)*A_v2 +
/// harmonic_re_v1_conjA_v12_F*conj(A_v1)^2*F + i*harmonic_im_v1_A_v2_conjA_v1*conj(A_v1)*A_v2 +
/// harmonic_re_v1_A_v22_F*A_v2^2*F
/// 4 columns; per observation at most 16 products and sums of complex numbers.
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
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * A_v2));  // harmonic_re_v1_A_v2_conjA_v1
    store_complex(column_1, i, factor[1] * (conj_A_v1 * conj_A_v1 * F));  // harmonic_re_v1_conjA_v12_F
    store_complex(column_2, i, times_i(factor[2] * (conj_A_v1 * A_v2)));  // harmonic_im_v1_A_v2_conjA_v1
    store_complex(column_3, i, factor[3] * (A_v2 * A_v2 * conj_F));  // harmonic_re_v1_A_v22_F
  }
}

/// columns[j][i] of the rows.
inline void columns_3(const BatchArrays& data, double* const* columns) {
  rows_3(data, FactorValues<factors_3<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_3(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 5 terms of the harmonic 0 of v1: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_4([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
}

/// Rows of the harmonic 0 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in v1 = harmonic_re_v1_A_v2_conjA_v2*A_v2*conj(A_v2) +
/// harmonic_re_v1_A_v1_conjA_v1*A_v1*conj(A_v1) + harmonic_re_v1_conjA_v1_conjA_v2_F*conj(A_v1)*conj(A_v2)*F +
/// harmonic_re_v1_conjA_v1_conjA_v2_F*A_v1*A_v2*F + harmonic_re_v1_F2*F^2
/// 4 columns; per observation at most 14 products and sums of complex numbers.
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
  Scalar factor[5];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex conj_A_v2 = conjugate(A_v2);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    const Scalar norm_F = norm_of(F);
    store_complex(column_0, i, Complex(factor[0] * (norm_A_v2)));  // harmonic_re_v1_A_v2_conjA_v2
    store_complex(column_1, i, Complex(factor[1] * (norm_A_v1)));  // harmonic_re_v1_A_v1_conjA_v1
    // harmonic_re_v1_conjA_v1_conjA_v2_F
    store_complex(column_2, i, factor[2] * (conj_A_v1 * conj_A_v2 * F) + factor[3] * (A_v1 * A_v2 * conj_F));
    store_complex(column_3, i, Complex(factor[4] * (norm_F)));  // harmonic_re_v1_F2
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

/// What multiplies the 6 terms of the harmonic Omega of v1: functions of the frequencies alone. 5 operations.
template <class Scalar>
void factors_5([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  factor[0] = -per_0 / (Scalar(2.0) * omega2);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
}

/// Rows of the harmonic Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(Omega)*t) in v1 = -1/(2*omega2*(2*omega1 + omega2))*eta11*F +
/// harmonic_re_v1_A_v1_A_v2*A_v1*A_v2 + i*harmonic_im_v1_F*F + harmonic_re_v1_A_v2_conjA_v2_F*A_v2*conj(A_v2)*F
/// + harmonic_re_v1_A_v1_conjA_v1_F*A_v1*conj(A_v1)*F + i*harmonic_im_v1_A_v1_A_v2*A_v1*A_v2
/// 6 columns; per observation at most 14 products and sums of complex numbers.
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
  Scalar* __restrict column_5 = columns[5];
  Scalar factor[6];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (F));  // eta11
    store_complex(column_1, i, factor[1] * (A_v1 * A_v2));  // harmonic_re_v1_A_v1_A_v2
    store_complex(column_2, i, times_i(factor[2] * (F)));  // harmonic_im_v1_F
    store_complex(column_3, i, factor[3] * (norm_A_v2 * F));  // harmonic_re_v1_A_v2_conjA_v2_F
    store_complex(column_4, i, factor[4] * (norm_A_v1 * F));  // harmonic_re_v1_A_v1_conjA_v1_F
    store_complex(column_5, i, times_i(factor[5] * (A_v1 * A_v2)));  // harmonic_im_v1_A_v1_A_v2
  }
}

/// columns[j][i] of the rows.
inline void columns_5(const BatchArrays& data, double* const* columns) {
  rows_5(data, FactorValues<factors_5<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_5(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_5(data, FactorSlopes<factors_5<DualNumber>, 2, 1, 6>{mode}, columns);
}

/// What multiplies the 3 terms of the harmonic 2*omega2 of v1: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_6([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega2 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega2)*t) in v1 = harmonic_re_v1_A_v22*A_v2^2 +
/// harmonic_re_v1_A_v2_conjA_v1_F*conj(A_v1)*A_v2*F + i*harmonic_im_v1_A_v22*A_v2^2
/// 3 columns; per observation at most 11 products and sums of complex numbers.
template <class Factors>
void rows_6(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v2 * A_v2));  // harmonic_re_v1_A_v22
    store_complex(column_1, i, factor[1] * (conj_A_v1 * A_v2 * F));  // harmonic_re_v1_A_v2_conjA_v1_F
    store_complex(column_2, i, times_i(factor[2] * (A_v2 * A_v2)));  // harmonic_im_v1_A_v22
  }
}

/// columns[j][i] of the rows.
inline void columns_6(const BatchArrays& data, double* const* columns) {
  rows_6(data, FactorValues<factors_6<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_6(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 3 terms of the harmonic omega1+Omega of v1: functions of the frequencies alone. 7
/// operations.
template <class Scalar>
void factors_7([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(3.0) * omega1 + omega2);
  factor[0] = -per_0 * per_1 / Scalar(2.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega1+Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + Omega)*t) in v1 = -1/(2*(omega1 + omega2)*(3*omega1 + omega2))*eta12*A_v1*F +
/// harmonic_re_v1_A_v1_F*A_v1*F + harmonic_re_v1_A_v12_A_v2*A_v1^2*A_v2
/// 3 columns; per observation at most 11 products and sums of complex numbers.
template <class Factors>
void rows_7(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * F));  // eta12
    store_complex(column_1, i, factor[1] * (A_v1 * F));  // harmonic_re_v1_A_v1_F
    store_complex(column_2, i, factor[2] * (A_v1 * A_v1 * A_v2));  // harmonic_re_v1_A_v12_A_v2
  }
}

/// columns[j][i] of the rows.
inline void columns_7(const BatchArrays& data, double* const* columns) {
  rows_7(data, FactorValues<factors_7<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_7(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_7(data, FactorSlopes<factors_7<DualNumber>, 2, 1, 3>{mode}, columns);
}

/// What multiplies the 3 terms of the harmonic 2*omega1 of v1: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_8([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega1 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega1)*t) in v1 = harmonic_re_v1_A_v12*A_v1^2 +
/// harmonic_re_v1_A_v1_conjA_v2_F*A_v1*conj(A_v2)*F + i*harmonic_im_v1_A_v12*A_v1^2
/// 3 columns; per observation at most 11 products and sums of complex numbers.
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex conj_A_v2 = conjugate(A_v2);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v1));  // harmonic_re_v1_A_v12
    store_complex(column_1, i, factor[1] * (A_v1 * conj_A_v2 * F));  // harmonic_re_v1_A_v1_conjA_v2_F
    store_complex(column_2, i, times_i(factor[2] * (A_v1 * A_v1)));  // harmonic_im_v1_A_v12
  }
}

/// columns[j][i] of the rows.
inline void columns_8(const BatchArrays& data, double* const* columns) {
  rows_8(data, FactorValues<factors_8<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_8(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 4 terms of the harmonic omega2+Omega of v1: functions of the frequencies alone. 10
/// operations.
template <class Scalar>
void factors_10([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_0_2 = per_0 * per_0;
  factor[0] = (Scalar(3.0) * omega1_2 + omega1 * omega2) * per_0_2 / (Scalar(4.0) * omega2);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the harmonic omega2+Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + Omega)*t) in v1 = (3*omega1^2 + omega1*omega2)/(4*omega2*(omega1 +
/// omega2)^2)*conservative_v1_A_v1_F2*conj(A_v1)*F^2 + harmonic_re_v1_A_v2_F*A_v2*F +
/// i*harmonic_im_v1_A_v2_F*A_v2*F + harmonic_re_v1_A_v1_A_v22*A_v1*A_v2^2
/// 4 columns; per observation at most 16 products and sums of complex numbers.
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
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * F * F));  // conservative_v1_A_v1_F2
    store_complex(column_1, i, factor[1] * (A_v2 * F));  // harmonic_re_v1_A_v2_F
    store_complex(column_2, i, times_i(factor[2] * (A_v2 * F)));  // harmonic_im_v1_A_v2_F
    store_complex(column_3, i, factor[3] * (A_v1 * A_v2 * A_v2));  // harmonic_re_v1_A_v1_A_v22
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

/// What multiplies the 2 terms of the harmonic 2*Omega of v1: functions of the frequencies alone. 11 operations.
template <class Scalar>
void factors_12([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(3.0) * omega1 + Scalar(2.0) * omega2);
  factor[0] = -omega1_2 * per_0 * per_1 / Scalar(2.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic 2*Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*Omega)*t) in v1 = -omega1^2/(2*(omega1 + 2*omega2)*(3*omega1 +
/// 2*omega2))*harmonic_re_v1_F2*F^2 + harmonic_re_v1_A_v1_A_v2_F*A_v1*A_v2*F
/// 2 columns; per observation at most 8 products and sums of complex numbers.
template <class Factors>
void rows_12(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (F * F));  // harmonic_re_v1_F2
    store_complex(column_1, i, factor[1] * (A_v1 * A_v2 * F));  // harmonic_re_v1_A_v1_A_v2_F
  }
}

/// columns[j][i] of the rows.
inline void columns_12(const BatchArrays& data, double* const* columns) {
  rows_12(data, FactorValues<factors_12<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_12(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_12(data, FactorSlopes<factors_12<DualNumber>, 2, 1, 2>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 2*omega2+Omega of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_13([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega2+Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega2 + Omega)*t) in v1 = harmonic_re_v1_A_v22_F*A_v2^2*F
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_13(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v2 * A_v2 * F));  // harmonic_re_v1_A_v22_F
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

/// What multiplies the 1 terms of the harmonic omega1+2*Omega of v1: functions of the frequencies alone. 19
/// operations.
template <class Scalar>
void factors_15([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar Omega_2 = Omega * Omega;
  const Scalar per_0 = Scalar(1.0) / (omega1 + Omega);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 + Omega);
  factor[0] = (-Scalar(3.0) * omega1_3 + Scalar(2.0) * omega1_2 * omega2
      + omega1 * omega2_2) * per_0 * per_1 / (Scalar(4.0) * Omega_2);
}

/// Rows of the harmonic omega1+2*Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + 2*Omega)*t) in v1 = (-3*omega1^3 + 2*omega1^2*omega2 +
/// omega1*omega2^2)/(4*Omega^2*(omega1 + Omega)*(2*omega1 + Omega))*conservative_v1_A_v1_F2*A_v1*F^2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_15(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * F * F));  // conservative_v1_A_v1_F2
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

/// What multiplies the 1 terms of the harmonic 2*omega1+Omega of v1: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_16([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega1+Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega1 + Omega)*t) in v1 = harmonic_re_v1_A_v12_F*A_v1^2*F
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_16(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v1 * F));  // harmonic_re_v1_A_v12_F
  }
}

/// columns[j][i] of the rows.
inline void columns_16(const BatchArrays& data, double* const* columns) {
  rows_16(data, FactorValues<factors_16<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_16(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 4 terms of the harmonic -omega1+omega2 of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_18([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the harmonic -omega1+omega2 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + omega2)*t) in v2 = harmonic_re_v2_A_v2_conjA_v1*conj(A_v1)*A_v2 +
/// harmonic_re_v2_conjA_v12_F*conj(A_v1)^2*F + i*harmonic_im_v2_A_v2_conjA_v1*conj(A_v1)*A_v2 +
/// harmonic_re_v2_A_v22_F*A_v2^2*F
/// 4 columns; per observation at most 16 products and sums of complex numbers.
template <class Factors>
void rows_18(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * A_v2));  // harmonic_re_v2_A_v2_conjA_v1
    store_complex(column_1, i, factor[1] * (conj_A_v1 * conj_A_v1 * F));  // harmonic_re_v2_conjA_v12_F
    store_complex(column_2, i, times_i(factor[2] * (conj_A_v1 * A_v2)));  // harmonic_im_v2_A_v2_conjA_v1
    store_complex(column_3, i, factor[3] * (A_v2 * A_v2 * conj_F));  // harmonic_re_v2_A_v22_F
  }
}

/// columns[j][i] of the rows.
inline void columns_18(const BatchArrays& data, double* const* columns) {
  rows_18(data, FactorValues<factors_18<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_18(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 5 terms of the harmonic omega1 of v2: functions of the frequencies alone. 8 operations.
template <class Scalar>
void factors_19([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  factor[0] = -per_0 * per_1 / Scalar(2.0);
  factor[1] = omega1 * per_0 * per_1;
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
}

/// Rows of the harmonic omega1 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1)*t) in v2 = -1/(2*(omega1 + omega2)*(omega1 - omega2))*eta22*conj(A_v2)*F +
/// omega1/((omega1 + omega2)*(omega1 - omega2))*i*mu21*A_v1 + harmonic_re_v2_conjA_v2_F*conj(A_v2)*F +
/// harmonic_re_v2_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) + harmonic_re_v2_A_v12_conjA_v1*A_v1^2*conj(A_v1)
/// 5 columns; per observation at most 13 products and sums of complex numbers.
template <class Factors>
void rows_19(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex conj_A_v2 = conjugate(A_v2);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (conj_A_v2 * F));  // eta22
    store_complex(column_1, i, times_i(factor[1] * (A_v1)));  // mu21
    store_complex(column_2, i, factor[2] * (conj_A_v2 * F));  // harmonic_re_v2_conjA_v2_F
    store_complex(column_3, i, factor[3] * (A_v1 * norm_A_v2));  // harmonic_re_v2_A_v1_A_v2_conjA_v2
    store_complex(column_4, i, factor[4] * (norm_A_v1 * A_v1));  // harmonic_re_v2_A_v12_conjA_v1
  }
}

/// columns[j][i] of the rows.
inline void columns_19(const BatchArrays& data, double* const* columns) {
  rows_19(data, FactorValues<factors_19<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_19(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_19(data, FactorSlopes<factors_19<DualNumber>, 2, 1, 5>{mode}, columns);
}

/// What multiplies the 5 terms of the harmonic 0 of v2: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_20([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
}

/// Rows of the harmonic 0 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in v2 = harmonic_re_v2_A_v2_conjA_v2*A_v2*conj(A_v2) +
/// harmonic_re_v2_A_v1_conjA_v1*A_v1*conj(A_v1) + harmonic_re_v2_conjA_v1_conjA_v2_F*conj(A_v1)*conj(A_v2)*F +
/// harmonic_re_v2_conjA_v1_conjA_v2_F*A_v1*A_v2*F + harmonic_re_v2_F2*F^2
/// 4 columns; per observation at most 14 products and sums of complex numbers.
template <class Factors>
void rows_20(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar factor[5];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex conj_A_v2 = conjugate(A_v2);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    const Scalar norm_F = norm_of(F);
    store_complex(column_0, i, Complex(factor[0] * (norm_A_v2)));  // harmonic_re_v2_A_v2_conjA_v2
    store_complex(column_1, i, Complex(factor[1] * (norm_A_v1)));  // harmonic_re_v2_A_v1_conjA_v1
    // harmonic_re_v2_conjA_v1_conjA_v2_F
    store_complex(column_2, i, factor[2] * (conj_A_v1 * conj_A_v2 * F) + factor[3] * (A_v1 * A_v2 * conj_F));
    store_complex(column_3, i, Complex(factor[4] * (norm_F)));  // harmonic_re_v2_F2
  }
}

/// columns[j][i] of the rows.
inline void columns_20(const BatchArrays& data, double* const* columns) {
  rows_20(data, FactorValues<factors_20<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_20(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 6 terms of the harmonic Omega of v2: functions of the frequencies alone. 5 operations.
template <class Scalar>
void factors_21([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (omega1 + Scalar(2.0) * omega2);
  factor[0] = -per_0 / (Scalar(2.0) * omega1);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
}

/// Rows of the harmonic Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(Omega)*t) in v2 = -1/(2*omega1*(omega1 + 2*omega2))*eta21*F +
/// harmonic_re_v2_A_v1_A_v2*A_v1*A_v2 + i*harmonic_im_v2_F*F + harmonic_re_v2_A_v2_conjA_v2_F*A_v2*conj(A_v2)*F
/// + harmonic_re_v2_A_v1_conjA_v1_F*A_v1*conj(A_v1)*F + i*harmonic_im_v2_A_v1_A_v2*A_v1*A_v2
/// 6 columns; per observation at most 14 products and sums of complex numbers.
template <class Factors>
void rows_21(const BatchArrays& data, Factors factors, double* const* columns) {
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
  Scalar factor[6];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (F));  // eta21
    store_complex(column_1, i, factor[1] * (A_v1 * A_v2));  // harmonic_re_v2_A_v1_A_v2
    store_complex(column_2, i, times_i(factor[2] * (F)));  // harmonic_im_v2_F
    store_complex(column_3, i, factor[3] * (norm_A_v2 * F));  // harmonic_re_v2_A_v2_conjA_v2_F
    store_complex(column_4, i, factor[4] * (norm_A_v1 * F));  // harmonic_re_v2_A_v1_conjA_v1_F
    store_complex(column_5, i, times_i(factor[5] * (A_v1 * A_v2)));  // harmonic_im_v2_A_v1_A_v2
  }
}

/// columns[j][i] of the rows.
inline void columns_21(const BatchArrays& data, double* const* columns) {
  rows_21(data, FactorValues<factors_21<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_21(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_21(data, FactorSlopes<factors_21<DualNumber>, 2, 1, 6>{mode}, columns);
}

/// What multiplies the 3 terms of the harmonic omega2+Omega of v2: functions of the frequencies alone. 7
/// operations.
template <class Scalar>
void factors_22([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 + Scalar(3.0) * omega2);
  factor[0] = -per_0 * per_1 / Scalar(2.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic omega2+Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + Omega)*t) in v2 = -1/(2*(omega1 + omega2)*(omega1 + 3*omega2))*eta22*A_v2*F +
/// harmonic_re_v2_A_v2_F*A_v2*F + harmonic_re_v2_A_v1_A_v22*A_v1*A_v2^2
/// 3 columns; per observation at most 11 products and sums of complex numbers.
template <class Factors>
void rows_22(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v2 * F));  // eta22
    store_complex(column_1, i, factor[1] * (A_v2 * F));  // harmonic_re_v2_A_v2_F
    store_complex(column_2, i, factor[2] * (A_v1 * A_v2 * A_v2));  // harmonic_re_v2_A_v1_A_v22
  }
}

/// columns[j][i] of the rows.
inline void columns_22(const BatchArrays& data, double* const* columns) {
  rows_22(data, FactorValues<factors_22<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_22(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_22(data, FactorSlopes<factors_22<DualNumber>, 2, 1, 3>{mode}, columns);
}

/// What multiplies the 3 terms of the harmonic 2*omega2 of v2: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_23([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega2 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega2)*t) in v2 = harmonic_re_v2_A_v22*A_v2^2 +
/// harmonic_re_v2_A_v2_conjA_v1_F*conj(A_v1)*A_v2*F + i*harmonic_im_v2_A_v22*A_v2^2
/// 3 columns; per observation at most 11 products and sums of complex numbers.
template <class Factors>
void rows_23(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v2 * A_v2));  // harmonic_re_v2_A_v22
    store_complex(column_1, i, factor[1] * (conj_A_v1 * A_v2 * F));  // harmonic_re_v2_A_v2_conjA_v1_F
    store_complex(column_2, i, times_i(factor[2] * (A_v2 * A_v2)));  // harmonic_im_v2_A_v22
  }
}

/// columns[j][i] of the rows.
inline void columns_23(const BatchArrays& data, double* const* columns) {
  rows_23(data, FactorValues<factors_23<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_23(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 3 terms of the harmonic 2*omega1 of v2: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_24([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega1 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega1)*t) in v2 = harmonic_re_v2_A_v12*A_v1^2 +
/// harmonic_re_v2_A_v1_conjA_v2_F*A_v1*conj(A_v2)*F + i*harmonic_im_v2_A_v12*A_v1^2
/// 3 columns; per observation at most 11 products and sums of complex numbers.
template <class Factors>
void rows_24(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex conj_A_v2 = conjugate(A_v2);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v1));  // harmonic_re_v2_A_v12
    store_complex(column_1, i, factor[1] * (A_v1 * conj_A_v2 * F));  // harmonic_re_v2_A_v1_conjA_v2_F
    store_complex(column_2, i, times_i(factor[2] * (A_v1 * A_v1)));  // harmonic_im_v2_A_v12
  }
}

/// columns[j][i] of the rows.
inline void columns_24(const BatchArrays& data, double* const* columns) {
  rows_24(data, FactorValues<factors_24<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_24(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 4 terms of the harmonic omega1+Omega of v2: functions of the frequencies alone. 10
/// operations.
template <class Scalar>
void factors_27([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_0_2 = per_0 * per_0;
  factor[0] = (omega1 * omega2 + Scalar(3.0) * omega2_2) * per_0_2 / (Scalar(4.0) * omega1);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the harmonic omega1+Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + Omega)*t) in v2 = (omega1*omega2 + 3*omega2^2)/(4*omega1*(omega1 +
/// omega2)^2)*conservative_v2_A_v2_F2*conj(A_v2)*F^2 + harmonic_re_v2_A_v1_F*A_v1*F +
/// i*harmonic_im_v2_A_v1_F*A_v1*F + harmonic_re_v2_A_v12_A_v2*A_v1^2*A_v2
/// 4 columns; per observation at most 16 products and sums of complex numbers.
template <class Factors>
void rows_27(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex conj_A_v2 = conjugate(A_v2);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (conj_A_v2 * F * F));  // conservative_v2_A_v2_F2
    store_complex(column_1, i, factor[1] * (A_v1 * F));  // harmonic_re_v2_A_v1_F
    store_complex(column_2, i, times_i(factor[2] * (A_v1 * F)));  // harmonic_im_v2_A_v1_F
    store_complex(column_3, i, factor[3] * (A_v1 * A_v1 * A_v2));  // harmonic_re_v2_A_v12_A_v2
  }
}

/// columns[j][i] of the rows.
inline void columns_27(const BatchArrays& data, double* const* columns) {
  rows_27(data, FactorValues<factors_27<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_27(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_27(data, FactorSlopes<factors_27<DualNumber>, 2, 1, 4>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic 2*Omega of v2: functions of the frequencies alone. 11 operations.
template <class Scalar>
void factors_28([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega1 + Scalar(3.0) * omega2);
  factor[0] = -omega2_2 * per_0 * per_1 / Scalar(2.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic 2*Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*Omega)*t) in v2 = -omega2^2/(2*(2*omega1 + omega2)*(2*omega1 +
/// 3*omega2))*harmonic_re_v2_F2*F^2 + harmonic_re_v2_A_v1_A_v2_F*A_v1*A_v2*F
/// 2 columns; per observation at most 8 products and sums of complex numbers.
template <class Factors>
void rows_28(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (F * F));  // harmonic_re_v2_F2
    store_complex(column_1, i, factor[1] * (A_v1 * A_v2 * F));  // harmonic_re_v2_A_v1_A_v2_F
  }
}

/// columns[j][i] of the rows.
inline void columns_28(const BatchArrays& data, double* const* columns) {
  rows_28(data, FactorValues<factors_28<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_28(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_28(data, FactorSlopes<factors_28<DualNumber>, 2, 1, 2>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic omega2+2*Omega of v2: functions of the frequencies alone. 19
/// operations.
template <class Scalar>
void factors_29([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar Omega_2 = Omega * Omega;
  const Scalar per_0 = Scalar(1.0) / (omega2 + Omega);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega2 + Omega);
  factor[0] = (omega1_2 * omega2 + Scalar(2.0) * omega1 * omega2_2
      - Scalar(3.0) * omega2_3) * per_0 * per_1 / (Scalar(4.0) * Omega_2);
}

/// Rows of the harmonic omega2+2*Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + 2*Omega)*t) in v2 = (omega1^2*omega2 + 2*omega1*omega2^2 -
/// 3*omega2^3)/(4*Omega^2*(omega2 + Omega)*(2*omega2 + Omega))*conservative_v2_A_v2_F2*A_v2*F^2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_29(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v2 * F * F));  // conservative_v2_A_v2_F2
  }
}

/// columns[j][i] of the rows.
inline void columns_29(const BatchArrays& data, double* const* columns) {
  rows_29(data, FactorValues<factors_29<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_29(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_29(data, FactorSlopes<factors_29<DualNumber>, 2, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 2*omega2+Omega of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_30([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega2+Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega2 + Omega)*t) in v2 = harmonic_re_v2_A_v22_F*A_v2^2*F
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_30(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v2 * A_v2 * F));  // harmonic_re_v2_A_v22_F
  }
}

/// columns[j][i] of the rows.
inline void columns_30(const BatchArrays& data, double* const* columns) {
  rows_30(data, FactorValues<factors_30<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_30(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic 2*omega1+Omega of v2: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_32([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega1+Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega1 + Omega)*t) in v2 = harmonic_re_v2_A_v12_F*A_v1^2*F
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_32(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * A_v1 * F));  // harmonic_re_v2_A_v12_F
  }
}

/// columns[j][i] of the rows.
inline void columns_32(const BatchArrays& data, double* const* columns) {
  rows_32(data, FactorValues<factors_32<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_32(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_v1/dt + i*(w_v1 - omega1)*B_v1 = -mu11*A_v1 + i*conservative_v1_A_v1*A_v1 +
/// i*conservative_v1_A_v1_F2*A_v1*F^2 + i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) -
/// 3*omega1^2/2*mu13*A_v1^2*conj(A_v1) + i*conservative_v1_A_v12_conjA_v1*A_v1^2*conj(A_v1) +
/// dissipative_v1_conjA_v2_F*conj(A_v2)*F + i*conservative_v1_conjA_v2_F*conj(A_v2)*F with A = B in that frame
/// dB_v2/dt + i*(w_v2 - omega2)*B_v2 = -omega2/omega1*i*conservative_v1_A_v1*A_v2 +
/// omega1/omega2*i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*conj(A_v1)*A_v2 +
/// omega1/omega2*i*conservative_v1_conjA_v2_F*conj(A_v1)*F - mu22*A_v2 + i*conservative_v2_A_v2_F2*A_v2*F^2 -
/// 3*omega2^2/2*mu23*A_v2^2*conj(A_v2) + i*conservative_v2_A_v22_conjA_v2*A_v2^2*conj(A_v2) +
/// dissipative_v2_conjA_v1_F*conj(A_v1)*F with A = B in that frame
/// 62 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  Scalar lumps[85];
  evaluate_lumps(parameters, lumps);
  const Complex A_v1 = load_complex(amplitude, 0);
  const Complex conj_A_v1 = conjugate(A_v1);
  const Scalar norm_A_v1 = norm_of(A_v1);
  const Complex A_v2 = load_complex(amplitude, 1);
  const Complex conj_A_v2 = conjugate(A_v2);
  const Scalar norm_A_v2 = norm_of(A_v2);
  const Complex F = load_complex(forcing, 0);
  const Scalar norm_F = norm_of(F);
  store_complex(derivative, 0, lumps[0] * (-Scalar(1.0)) * (A_v1)
       + times_i(lumps[1] * (A_v1))
       + times_i(lumps[2] * (A_v1 * norm_F))
       + times_i(lumps[3] * (A_v1 * norm_A_v2))
       + lumps[4] * (-Scalar(3.0) * omega1_2 / Scalar(2.0)) * (norm_A_v1 * A_v1)
       + times_i(lumps[5] * (norm_A_v1 * A_v1))
       + lumps[6] * (conj_A_v2 * F)
       + times_i(lumps[7] * (conj_A_v2 * F))
       - times_i((-omega1 - omega2 + excitation_frequency[0]) * A_v1));
  store_complex(derivative, 1, times_i(lumps[1] * (-omega2 / omega1) * (A_v2))
       + times_i(lumps[3] * omega1 / omega2 * (norm_A_v1 * A_v2))
       + times_i(lumps[7] * omega1 / omega2 * (conj_A_v1 * F))
       + lumps[8] * (-Scalar(1.0)) * (A_v2)
       + times_i(lumps[9] * (A_v2 * norm_F))
       + lumps[10] * (-Scalar(3.0) * omega2_2 / Scalar(2.0)) * (norm_A_v2 * A_v2)
       + times_i(lumps[11] * (norm_A_v2 * A_v2))
       + lumps[12] * (conj_A_v1 * F));
}

/// jacobian[i * 4 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 93 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  Scalar lumps[85];
  evaluate_lumps(parameters, lumps);
  const Complex A_v1 = load_complex(amplitude, 0);
  const Complex conj_A_v1 = conjugate(A_v1);
  const Scalar norm_A_v1 = norm_of(A_v1);
  const Complex A_v2 = load_complex(amplitude, 1);
  const Complex conj_A_v2 = conjugate(A_v2);
  const Scalar norm_A_v2 = norm_of(A_v2);
  const Complex F = load_complex(forcing, 0);
  const Scalar norm_F = norm_of(F);
  for (std::size_t i = 0; i < 16; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = Complex(lumps[0] * (-Scalar(1.0)))
       + times_i(Complex(lumps[1]))
       + times_i(Complex(lumps[2] * (norm_F)))
       + times_i(Complex(lumps[3] * (norm_A_v2)))
       + Complex(lumps[4] * (-Scalar(3.0) * omega1_2 / Scalar(2.0)) * Scalar(2) * (norm_A_v1))
       + times_i(Complex(lumps[5] * Scalar(2) * (norm_A_v1)))
       - Complex(Scalar(0.0), -omega1 - omega2 + excitation_frequency[0]);
  const Complex conj_by_0_0 = lumps[4] * (-Scalar(3.0) * omega1_2 / Scalar(2.0)) * (A_v1 * A_v1)
       + times_i(lumps[5] * (A_v1 * A_v1));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[4] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[5] = by_0_0.real - conj_by_0_0.real;
  const Complex by_0_1 = times_i(lumps[3] * (A_v1 * conj_A_v2));
  const Complex conj_by_0_1 = times_i(lumps[3] * (A_v1 * A_v2))
       + lumps[6] * (F)
       + times_i(lumps[7] * (F));
  jacobian[2] = by_0_1.real + conj_by_0_1.real;
  jacobian[3] = conj_by_0_1.imag - by_0_1.imag;
  jacobian[6] = by_0_1.imag + conj_by_0_1.imag;
  jacobian[7] = by_0_1.real - conj_by_0_1.real;
  const Complex by_1_0 = times_i(lumps[3] * omega1 / omega2 * (conj_A_v1 * A_v2));
  const Complex conj_by_1_0 = times_i(lumps[3] * omega1 / omega2 * (A_v1 * A_v2))
       + times_i(lumps[7] * omega1 / omega2 * (F))
       + lumps[12] * (F);
  jacobian[8] = by_1_0.real + conj_by_1_0.real;
  jacobian[9] = conj_by_1_0.imag - by_1_0.imag;
  jacobian[12] = by_1_0.imag + conj_by_1_0.imag;
  jacobian[13] = by_1_0.real - conj_by_1_0.real;
  const Complex by_1_1 = times_i(Complex(lumps[1] * (-omega2 / omega1)))
       + times_i(Complex(lumps[3] * omega1 / omega2 * (norm_A_v1)))
       + Complex(lumps[8] * (-Scalar(1.0)))
       + times_i(Complex(lumps[9] * (norm_F)))
       + Complex(lumps[10] * (-Scalar(3.0) * omega2_2 / Scalar(2.0)) * Scalar(2) * (norm_A_v2))
       + times_i(Complex(lumps[11] * Scalar(2) * (norm_A_v2)));
  const Complex conj_by_1_1 = lumps[10] * (-Scalar(3.0) * omega2_2 / Scalar(2.0)) * (A_v2 * A_v2)
       + times_i(lumps[11] * (A_v2 * A_v2));
  jacobian[10] = by_1_1.real + conj_by_1_1.real;
  jacobian[11] = conj_by_1_1.imag - by_1_1.imag;
  jacobian[14] = by_1_1.imag + conj_by_1_1.imag;
  jacobian[15] = by_1_1.real - conj_by_1_1.real;
}

}  // namespace additive_combination

namespace free {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: mu11 = mu11
/// lumps[3]: mu13 = mu13
/// lumps[5]: mu22 = mu22
/// lumps[6]: mu23 = mu23
/// lumps[10]: harmonic_re_v1_A_v2_conjA_v2 = (2*omega2^2*delta23 - 2*alpha23)/omega1^2
/// lumps[11]: harmonic_re_v1_A_v1_conjA_v1 = (2*omega1^2*delta21 - 2*alpha21)/omega1^2
/// lumps[12]: mu12 = mu12
/// lumps[19]: harmonic_re_v1_A_v12 = (-3*omega1^2*delta21 + alpha21)/(3*omega1^2)
/// lumps[29]: harmonic_re_v2_A_v2_conjA_v2 = (2*omega2^2*delta24 - 2*alpha24)/omega2^2
/// lumps[30]: harmonic_re_v2_A_v1_conjA_v1 = (2*omega1^2*delta22 - 2*alpha22)/omega2^2
/// lumps[31]: harmonic_re_v2_A_v22 = (-3*omega2^2*delta24 + alpha24)/(3*omega2^2)
/// lumps[33]: mu21 = mu21
/// 30 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu11 = parameters[2];
  const Scalar mu12 = parameters[3];
  const Scalar mu13 = parameters[4];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar mu22 = parameters[22];
  const Scalar mu21 = parameters[23];
  const Scalar mu23 = parameters[24];
  const Scalar alpha24 = parameters[25];
  const Scalar delta24 = parameters[26];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  lumps[0] = mu11;  // mu11
  lumps[1] = lump_0(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v1
  lumps[2] = lump_1(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v1_A_v2_conjA_v2
  lumps[3] = mu13;  // mu13
  lumps[4] = lump_2(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v12_conjA_v1
  lumps[5] = mu22;  // mu22
  lumps[6] = mu23;  // mu23
  lumps[7] = lump_5(parameters, static_cast<Scalar*>(nullptr));  // conservative_v2_A_v22_conjA_v2
  lumps[8] = lump_6(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v2_conjA_v1
  lumps[9] = lump_7(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v2_conjA_v1
  // harmonic_re_v1_A_v2_conjA_v2
  lumps[10] = (Scalar(2.0) * omega2_2 * delta23 - Scalar(2.0) * alpha23) / omega1_2;
  // harmonic_re_v1_A_v1_conjA_v1
  lumps[11] = (Scalar(2.0) * omega1_2 * delta21 - Scalar(2.0) * alpha21) / omega1_2;
  lumps[12] = mu12;  // mu12
  lumps[13] = lump_10(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v22_conjA_v2
  lumps[14] = lump_11(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_A_v2_conjA_v1
  lumps[15] = lump_13(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v22
  lumps[16] = lump_14(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v22
  lumps[17] = lump_16(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_A_v2
  lumps[18] = lump_17(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v1_A_v2
  lumps[19] = (-Scalar(3.0) * omega1_2 * delta21 + alpha21) / (Scalar(3.0) * omega1_2);  // harmonic_re_v1_A_v12
  lumps[20] = lump_15(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v12
  lumps[21] = lump_18(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v2_conjA_v12
  lumps[22] = lump_19(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v22_conjA_v1
  lumps[23] = lump_22(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v23
  lumps[24] = lump_21(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v1_A_v22
  lumps[25] = lump_24(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v12_A_v2
  lumps[26] = lump_23(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v13
  lumps[27] = lump_25(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v2_conjA_v1
  lumps[28] = lump_26(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v2_conjA_v1
  // harmonic_re_v2_A_v2_conjA_v2
  lumps[29] = (Scalar(2.0) * omega2_2 * delta24 - Scalar(2.0) * alpha24) / omega2_2;
  // harmonic_re_v2_A_v1_conjA_v1
  lumps[30] = (Scalar(2.0) * omega1_2 * delta22 - Scalar(2.0) * alpha22) / omega2_2;
  lumps[31] = (-Scalar(3.0) * omega2_2 * delta24 + alpha24) / (Scalar(3.0) * omega2_2);  // harmonic_re_v2_A_v22
  lumps[32] = lump_30(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v22
  lumps[33] = mu21;  // mu21
  lumps[34] = lump_33(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_A_v2_conjA_v2
  lumps[35] = lump_34(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v12_conjA_v1
  lumps[36] = lump_28(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_A_v2
  lumps[37] = lump_29(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v1_A_v2
  lumps[38] = lump_36(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v12
  lumps[39] = lump_38(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v12
  lumps[40] = lump_39(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v2_conjA_v12
  lumps[41] = lump_41(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v22_conjA_v1
  lumps[42] = lump_46(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v23
  lumps[43] = lump_45(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v1_A_v22
  lumps[44] = lump_44(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v12_A_v2
  lumps[45] = lump_47(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v13
}

/// jacobian[l * 31 + p] = d lumps[l] / d parameters[p]. 38 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar alpha23 = parameters[7];
  const Scalar delta22 = parameters[9];
  const Scalar delta23 = parameters[10];
  const Scalar alpha24 = parameters[25];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  for (std::size_t i = 0; i < 1426; ++i) jacobian[i] = Scalar(0.0);
  jacobian[2] = Scalar(1.0);  // d mu11 / d mu11
  lump_0(parameters, jacobian + 31);  // d conservative_v1_A_v1
  lump_1(parameters, jacobian + 62);  // d conservative_v1_A_v1_A_v2_conjA_v2
  jacobian[97] = Scalar(1.0);  // d mu13 / d mu13
  lump_2(parameters, jacobian + 124);  // d conservative_v1_A_v12_conjA_v1
  jacobian[177] = Scalar(1.0);  // d mu22 / d mu22
  jacobian[210] = Scalar(1.0);  // d mu23 / d mu23
  lump_5(parameters, jacobian + 217);  // d conservative_v2_A_v22_conjA_v2
  lump_6(parameters, jacobian + 248);  // d harmonic_re_v1_A_v2_conjA_v1
  lump_7(parameters, jacobian + 279);  // d harmonic_im_v1_A_v2_conjA_v1
  // d harmonic_re_v1_A_v2_conjA_v2 / d omega1
  jacobian[310] = (-Scalar(4.0) * omega2_2 * delta23 + Scalar(4.0) * alpha23) / omega1_3;
  jacobian[311] = Scalar(4.0) * omega2 * delta23 / omega1_2;  // d harmonic_re_v1_A_v2_conjA_v2 / d omega2
  jacobian[317] = -Scalar(2.0) / omega1_2;  // d harmonic_re_v1_A_v2_conjA_v2 / d alpha23
  jacobian[320] = Scalar(2.0) * omega2_2 / omega1_2;  // d harmonic_re_v1_A_v2_conjA_v2 / d delta23
  jacobian[341] = Scalar(4.0) * alpha21 / omega1_3;  // d harmonic_re_v1_A_v1_conjA_v1 / d omega1
  jacobian[346] = -Scalar(2.0) / omega1_2;  // d harmonic_re_v1_A_v1_conjA_v1 / d alpha21
  jacobian[349] = Scalar(2.0);  // d harmonic_re_v1_A_v1_conjA_v1 / d delta21
  jacobian[375] = Scalar(1.0);  // d mu12 / d mu12
  lump_10(parameters, jacobian + 403);  // d harmonic_re_v1_A_v22_conjA_v2
  lump_11(parameters, jacobian + 434);  // d harmonic_re_v1_A_v1_A_v2_conjA_v1
  lump_13(parameters, jacobian + 465);  // d harmonic_re_v1_A_v22
  lump_14(parameters, jacobian + 496);  // d harmonic_im_v1_A_v22
  lump_16(parameters, jacobian + 527);  // d harmonic_re_v1_A_v1_A_v2
  lump_17(parameters, jacobian + 558);  // d harmonic_im_v1_A_v1_A_v2
  jacobian[589] = -Scalar(2.0) * alpha21 / (Scalar(3.0) * omega1_3);  // d harmonic_re_v1_A_v12 / d omega1
  jacobian[594] = Scalar(1.0) / (Scalar(3.0) * omega1_2);  // d harmonic_re_v1_A_v12 / d alpha21
  jacobian[597] = -Scalar(1.0);  // d harmonic_re_v1_A_v12 / d delta21
  lump_15(parameters, jacobian + 620);  // d harmonic_im_v1_A_v12
  lump_18(parameters, jacobian + 651);  // d harmonic_re_v1_A_v2_conjA_v12
  lump_19(parameters, jacobian + 682);  // d harmonic_re_v1_A_v22_conjA_v1
  lump_22(parameters, jacobian + 713);  // d harmonic_re_v1_A_v23
  lump_21(parameters, jacobian + 744);  // d harmonic_re_v1_A_v1_A_v22
  lump_24(parameters, jacobian + 775);  // d harmonic_re_v1_A_v12_A_v2
  lump_23(parameters, jacobian + 806);  // d harmonic_re_v1_A_v13
  lump_25(parameters, jacobian + 837);  // d harmonic_re_v2_A_v2_conjA_v1
  lump_26(parameters, jacobian + 868);  // d harmonic_im_v2_A_v2_conjA_v1
  jacobian[900] = Scalar(4.0) * alpha24 / omega2_3;  // d harmonic_re_v2_A_v2_conjA_v2 / d omega2
  jacobian[924] = -Scalar(2.0) / omega2_2;  // d harmonic_re_v2_A_v2_conjA_v2 / d alpha24
  jacobian[925] = Scalar(2.0);  // d harmonic_re_v2_A_v2_conjA_v2 / d delta24
  jacobian[930] = Scalar(4.0) * omega1 * delta22 / omega2_2;  // d harmonic_re_v2_A_v1_conjA_v1 / d omega1
  // d harmonic_re_v2_A_v1_conjA_v1 / d omega2
  jacobian[931] = (-Scalar(4.0) * omega1_2 * delta22 + Scalar(4.0) * alpha22) / omega2_3;
  jacobian[936] = -Scalar(2.0) / omega2_2;  // d harmonic_re_v2_A_v1_conjA_v1 / d alpha22
  jacobian[939] = Scalar(2.0) * omega1_2 / omega2_2;  // d harmonic_re_v2_A_v1_conjA_v1 / d delta22
  jacobian[962] = -Scalar(2.0) * alpha24 / (Scalar(3.0) * omega2_3);  // d harmonic_re_v2_A_v22 / d omega2
  jacobian[986] = Scalar(1.0) / (Scalar(3.0) * omega2_2);  // d harmonic_re_v2_A_v22 / d alpha24
  jacobian[987] = -Scalar(1.0);  // d harmonic_re_v2_A_v22 / d delta24
  lump_30(parameters, jacobian + 992);  // d harmonic_im_v2_A_v22
  jacobian[1046] = Scalar(1.0);  // d mu21 / d mu21
  lump_33(parameters, jacobian + 1054);  // d harmonic_re_v2_A_v1_A_v2_conjA_v2
  lump_34(parameters, jacobian + 1085);  // d harmonic_re_v2_A_v12_conjA_v1
  lump_28(parameters, jacobian + 1116);  // d harmonic_re_v2_A_v1_A_v2
  lump_29(parameters, jacobian + 1147);  // d harmonic_im_v2_A_v1_A_v2
  lump_36(parameters, jacobian + 1178);  // d harmonic_re_v2_A_v12
  lump_38(parameters, jacobian + 1209);  // d harmonic_im_v2_A_v12
  lump_39(parameters, jacobian + 1240);  // d harmonic_re_v2_A_v2_conjA_v12
  lump_41(parameters, jacobian + 1271);  // d harmonic_re_v2_A_v22_conjA_v1
  lump_46(parameters, jacobian + 1302);  // d harmonic_re_v2_A_v23
  lump_45(parameters, jacobian + 1333);  // d harmonic_re_v2_A_v1_A_v22
  lump_44(parameters, jacobian + 1364);  // d harmonic_re_v2_A_v12_A_v2
  lump_47(parameters, jacobian + 1395);  // d harmonic_re_v2_A_v13
}

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_v1/dt + i*(w_v1 - omega1)*B_v1 = -mu11*A_v1 + i*conservative_v1_A_v1*A_v1 +
/// i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) - 3*omega1^2/2*mu13*A_v1^2*conj(A_v1) +
/// i*conservative_v1_A_v12_conjA_v1*A_v1^2*conj(A_v1) with A = B in that frame
/// dB_v2/dt + i*(w_v2 - omega2)*B_v2 = -omega2/omega1*i*conservative_v1_A_v1*A_v2 +
/// omega1/omega2*i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*conj(A_v1)*A_v2 - mu22*A_v2 -
/// 3*omega2^2/2*mu23*A_v2^2*conj(A_v2) + i*conservative_v2_A_v22_conjA_v2*A_v2^2*conj(A_v2) with A = B in that
/// frame
/// 38 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  Scalar lumps[46];
  evaluate_lumps(parameters, lumps);
  const Complex A_v1 = load_complex(amplitude, 0);
  const Scalar norm_A_v1 = norm_of(A_v1);
  const Complex A_v2 = load_complex(amplitude, 1);
  const Scalar norm_A_v2 = norm_of(A_v2);
  store_complex(derivative, 0, lumps[0] * (-Scalar(1.0)) * (A_v1)
       + times_i(lumps[1] * (A_v1))
       + times_i(lumps[2] * (A_v1 * norm_A_v2))
       + lumps[3] * (-Scalar(3.0) * omega1_2 / Scalar(2.0)) * (norm_A_v1 * A_v1)
       + times_i(lumps[4] * (norm_A_v1 * A_v1)));
  store_complex(derivative, 1, times_i(lumps[1] * (-omega2 / omega1) * (A_v2))
       + times_i(lumps[2] * omega1 / omega2 * (norm_A_v1 * A_v2))
       + lumps[5] * (-Scalar(1.0)) * (A_v2)
       + lumps[6] * (-Scalar(3.0) * omega2_2 / Scalar(2.0)) * (norm_A_v2 * A_v2)
       + times_i(lumps[7] * (norm_A_v2 * A_v2)));
}

/// jacobian[i * 4 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 76 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  Scalar lumps[46];
  evaluate_lumps(parameters, lumps);
  const Complex A_v1 = load_complex(amplitude, 0);
  const Complex conj_A_v1 = conjugate(A_v1);
  const Scalar norm_A_v1 = norm_of(A_v1);
  const Complex A_v2 = load_complex(amplitude, 1);
  const Complex conj_A_v2 = conjugate(A_v2);
  const Scalar norm_A_v2 = norm_of(A_v2);
  for (std::size_t i = 0; i < 16; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = Complex(lumps[0] * (-Scalar(1.0)))
       + times_i(Complex(lumps[1]))
       + times_i(Complex(lumps[2] * (norm_A_v2)))
       + Complex(lumps[3] * (-Scalar(3.0) * omega1_2 / Scalar(2.0)) * Scalar(2) * (norm_A_v1))
       + times_i(Complex(lumps[4] * Scalar(2) * (norm_A_v1)));
  const Complex conj_by_0_0 = lumps[3] * (-Scalar(3.0) * omega1_2 / Scalar(2.0)) * (A_v1 * A_v1)
       + times_i(lumps[4] * (A_v1 * A_v1));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[4] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[5] = by_0_0.real - conj_by_0_0.real;
  const Complex by_0_1 = times_i(lumps[2] * (A_v1 * conj_A_v2));
  const Complex conj_by_0_1 = times_i(lumps[2] * (A_v1 * A_v2));
  jacobian[2] = by_0_1.real + conj_by_0_1.real;
  jacobian[3] = conj_by_0_1.imag - by_0_1.imag;
  jacobian[6] = by_0_1.imag + conj_by_0_1.imag;
  jacobian[7] = by_0_1.real - conj_by_0_1.real;
  const Complex by_1_0 = times_i(lumps[2] * omega1 / omega2 * (conj_A_v1 * A_v2));
  const Complex conj_by_1_0 = times_i(lumps[2] * omega1 / omega2 * (A_v1 * A_v2));
  jacobian[8] = by_1_0.real + conj_by_1_0.real;
  jacobian[9] = conj_by_1_0.imag - by_1_0.imag;
  jacobian[12] = by_1_0.imag + conj_by_1_0.imag;
  jacobian[13] = by_1_0.real - conj_by_1_0.real;
  const Complex by_1_1 = times_i(Complex(lumps[1] * (-omega2 / omega1)))
       + times_i(Complex(lumps[2] * omega1 / omega2 * (norm_A_v1)))
       + Complex(lumps[5] * (-Scalar(1.0)))
       + Complex(lumps[6] * (-Scalar(3.0) * omega2_2 / Scalar(2.0)) * Scalar(2) * (norm_A_v2))
       + times_i(Complex(lumps[7] * Scalar(2) * (norm_A_v2)));
  const Complex conj_by_1_1 = lumps[6] * (-Scalar(3.0) * omega2_2 / Scalar(2.0)) * (A_v2 * A_v2)
       + times_i(lumps[7] * (A_v2 * A_v2));
  jacobian[10] = by_1_1.real + conj_by_1_1.real;
  jacobian[11] = conj_by_1_1.imag - by_1_1.imag;
  jacobian[14] = by_1_1.imag + conj_by_1_1.imag;
  jacobian[15] = by_1_1.real - conj_by_1_1.real;
}

}  // namespace free

namespace free_1 {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: mu11 = mu11
/// lumps[2]: mu13 = mu13
/// lumps[4]: harmonic_re_v1_A_v1_conjA_v1 = (2*omega1^2*delta21 - 2*alpha21)/omega1^2
/// lumps[5]: harmonic_re_v1_A_v12 = (-3*omega1^2*delta21 + alpha21)/(3*omega1^2)
/// lumps[8]: harmonic_re_v2_A_v1_conjA_v1 = (2*omega1^2*delta22 - 2*alpha22)/omega2^2
/// lumps[9]: mu21 = mu21
/// 15 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu11 = parameters[2];
  const Scalar mu13 = parameters[4];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar delta21 = parameters[8];
  const Scalar delta22 = parameters[9];
  const Scalar mu21 = parameters[23];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  lumps[0] = mu11;  // mu11
  lumps[1] = lump_0(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v1
  lumps[2] = mu13;  // mu13
  lumps[3] = lump_2(parameters, static_cast<Scalar*>(nullptr));  // conservative_v1_A_v12_conjA_v1
  // harmonic_re_v1_A_v1_conjA_v1
  lumps[4] = (Scalar(2.0) * omega1_2 * delta21 - Scalar(2.0) * alpha21) / omega1_2;
  lumps[5] = (-Scalar(3.0) * omega1_2 * delta21 + alpha21) / (Scalar(3.0) * omega1_2);  // harmonic_re_v1_A_v12
  lumps[6] = lump_15(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v1_A_v12
  lumps[7] = lump_23(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v1_A_v13
  // harmonic_re_v2_A_v1_conjA_v1
  lumps[8] = (Scalar(2.0) * omega1_2 * delta22 - Scalar(2.0) * alpha22) / omega2_2;
  lumps[9] = mu21;  // mu21
  lumps[10] = lump_34(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v12_conjA_v1
  lumps[11] = lump_36(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v12
  lumps[12] = lump_38(parameters, static_cast<Scalar*>(nullptr));  // harmonic_im_v2_A_v12
  lumps[13] = lump_47(parameters, static_cast<Scalar*>(nullptr));  // harmonic_re_v2_A_v13
}

/// jacobian[l * 31 + p] = d lumps[l] / d parameters[p]. 19 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar alpha21 = parameters[5];
  const Scalar alpha22 = parameters[6];
  const Scalar delta22 = parameters[9];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  for (std::size_t i = 0; i < 434; ++i) jacobian[i] = Scalar(0.0);
  jacobian[2] = Scalar(1.0);  // d mu11 / d mu11
  lump_0(parameters, jacobian + 31);  // d conservative_v1_A_v1
  jacobian[66] = Scalar(1.0);  // d mu13 / d mu13
  lump_2(parameters, jacobian + 93);  // d conservative_v1_A_v12_conjA_v1
  jacobian[124] = Scalar(4.0) * alpha21 / omega1_3;  // d harmonic_re_v1_A_v1_conjA_v1 / d omega1
  jacobian[129] = -Scalar(2.0) / omega1_2;  // d harmonic_re_v1_A_v1_conjA_v1 / d alpha21
  jacobian[132] = Scalar(2.0);  // d harmonic_re_v1_A_v1_conjA_v1 / d delta21
  jacobian[155] = -Scalar(2.0) * alpha21 / (Scalar(3.0) * omega1_3);  // d harmonic_re_v1_A_v12 / d omega1
  jacobian[160] = Scalar(1.0) / (Scalar(3.0) * omega1_2);  // d harmonic_re_v1_A_v12 / d alpha21
  jacobian[163] = -Scalar(1.0);  // d harmonic_re_v1_A_v12 / d delta21
  lump_15(parameters, jacobian + 186);  // d harmonic_im_v1_A_v12
  lump_23(parameters, jacobian + 217);  // d harmonic_re_v1_A_v13
  jacobian[248] = Scalar(4.0) * omega1 * delta22 / omega2_2;  // d harmonic_re_v2_A_v1_conjA_v1 / d omega1
  // d harmonic_re_v2_A_v1_conjA_v1 / d omega2
  jacobian[249] = (-Scalar(4.0) * omega1_2 * delta22 + Scalar(4.0) * alpha22) / omega2_3;
  jacobian[254] = -Scalar(2.0) / omega2_2;  // d harmonic_re_v2_A_v1_conjA_v1 / d alpha22
  jacobian[257] = Scalar(2.0) * omega1_2 / omega2_2;  // d harmonic_re_v2_A_v1_conjA_v1 / d delta22
  jacobian[302] = Scalar(1.0);  // d mu21 / d mu21
  lump_34(parameters, jacobian + 310);  // d harmonic_re_v2_A_v12_conjA_v1
  lump_36(parameters, jacobian + 341);  // d harmonic_re_v2_A_v12
  lump_38(parameters, jacobian + 372);  // d harmonic_im_v2_A_v12
  lump_47(parameters, jacobian + 403);  // d harmonic_re_v2_A_v13
}

/// What multiplies the 4 terms of the modulation of v1: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  factor[0] = -Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = -Scalar(3.0) * omega1_2 / Scalar(2.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the modulation of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega1)*A_v1 = -mu11*A_v1 + i*conservative_v1_A_v1*A_v1 - 3*omega1^2/2*mu13*A_v1^2*conj(A_v1) +
/// i*conservative_v1_A_v12_conjA_v1*A_v1^2*conj(A_v1)
/// 4 columns; per observation at most 8 products and sums of complex numbers.
template <class Factors>
void rows_0(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    store_complex(column_0, i, factor[0] * (A_v1));  // mu11
    store_complex(column_1, i, times_i(factor[1] * (A_v1)));  // conservative_v1_A_v1
    store_complex(column_2, i, factor[2] * (norm_A_v1 * A_v1));  // mu13
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
  rows_0(data, FactorSlopes<factors_0<DualNumber>, 2, 1, 4>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 0 of v1: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_1([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic 0 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in v1 = harmonic_re_v1_A_v1_conjA_v1*A_v1*conj(A_v1)
/// 1 columns; per observation at most 1 products and sums of complex numbers.
template <class Factors>
void rows_1(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    store_complex(column_0, i, Complex(factor[0] * (norm_A_v1)));  // harmonic_re_v1_A_v1_conjA_v1
  }
}

/// columns[j][i] of the rows.
inline void columns_1(const BatchArrays& data, double* const* columns) {
  rows_1(data, FactorValues<factors_1<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_1(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic 0 of v2: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_4([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic 0 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in v2 = harmonic_re_v2_A_v1_conjA_v1*A_v1*conj(A_v1)
/// 1 columns; per observation at most 1 products and sums of complex numbers.
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
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    store_complex(column_0, i, Complex(factor[0] * (norm_A_v1)));  // harmonic_re_v2_A_v1_conjA_v1
  }
}

/// columns[j][i] of the rows.
inline void columns_4(const BatchArrays& data, double* const* columns) {
  rows_4(data, FactorValues<factors_4<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_4(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 2 terms of the harmonic omega1 of v2: functions of the frequencies alone. 6 operations.
template <class Scalar>
void factors_5([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2);
  factor[0] = omega1 * per_0 * per_1;
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic omega1 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1)*t) in v2 = omega1/((omega1 + omega2)*(omega1 - omega2))*i*mu21*A_v1 +
/// harmonic_re_v2_A_v12_conjA_v1*A_v1^2*conj(A_v1)
/// 2 columns; per observation at most 4 products and sums of complex numbers.
template <class Factors>
void rows_5(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    store_complex(column_0, i, times_i(factor[0] * (A_v1)));  // mu21
    store_complex(column_1, i, factor[1] * (norm_A_v1 * A_v1));  // harmonic_re_v2_A_v12_conjA_v1
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

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_v1/dt + i*(w_v1 - omega1)*B_v1 = -mu11*A_v1 + i*conservative_v1_A_v1*A_v1 -
/// 3*omega1^2/2*mu13*A_v1^2*conj(A_v1) + i*conservative_v1_A_v12_conjA_v1*A_v1^2*conj(A_v1) with A = B in that
/// frame
/// dB_v2/dt + i*(w_v2 - omega2)*B_v2 = 0 with A = B in that frame
/// 14 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  const Scalar omega1_2 = omega1 * omega1;
  Scalar lumps[14];
  evaluate_lumps(parameters, lumps);
  const Complex A_v1 = load_complex(amplitude, 0);
  const Scalar norm_A_v1 = norm_of(A_v1);
  store_complex(derivative, 0, lumps[0] * (-Scalar(1.0)) * (A_v1)
       + times_i(lumps[1] * (A_v1))
       + lumps[2] * (-Scalar(3.0) * omega1_2 / Scalar(2.0)) * (norm_A_v1 * A_v1)
       + times_i(lumps[3] * (norm_A_v1 * A_v1)));
  store_complex(derivative, 1, Complex());
}

/// jacobian[i * 4 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 24 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  const Scalar omega1_2 = omega1 * omega1;
  Scalar lumps[14];
  evaluate_lumps(parameters, lumps);
  const Complex A_v1 = load_complex(amplitude, 0);
  const Scalar norm_A_v1 = norm_of(A_v1);
  for (std::size_t i = 0; i < 16; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = Complex(lumps[0] * (-Scalar(1.0)))
       + times_i(Complex(lumps[1]))
       + Complex(lumps[2] * (-Scalar(3.0) * omega1_2 / Scalar(2.0)) * Scalar(2) * (norm_A_v1))
       + times_i(Complex(lumps[3] * Scalar(2) * (norm_A_v1)));
  const Complex conj_by_0_0 = lumps[2] * (-Scalar(3.0) * omega1_2 / Scalar(2.0)) * (A_v1 * A_v1)
       + times_i(lumps[3] * (A_v1 * A_v1));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[4] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[5] = by_0_0.real - conj_by_0_0.real;
}

}  // namespace free_1

}  // namespace secular::generated::two_mass
