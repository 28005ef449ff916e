// Model two_mass: generated code, never edited by hand.
// Holds equations of motion, lumps, what rows are made of. Made by: secular generate two_mass.
// Source: S. O'F. Fahey, dissertation, Virginia Tech, 2000, Eqs. (6.1)-(6.2)
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// two_mass.primary_1.hpp: Omega = omega1 + eps^2*sigma
// two_mass.primary_2.hpp: Omega = omega2 + eps^2*sigma
// two_mass.principal_parametric_1.hpp: Omega = 2*omega1 + eps^2*sigma
// two_mass.principal_parametric_2.hpp: Omega = 2*omega2 + eps^2*sigma
// two_mass.additive_combination.hpp: Omega = omega1 + omega2 + eps^2*sigma
// two_mass.free.hpp: free vibration
// two_mass.free_1.hpp: free vibration
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

namespace secular::generated::two_mass {

/// Mass matrix M of the equations of motion M*acceleration + force = 0 below, state-dependent: mass[k * 2 + j]
/// multiplies the acceleration of mode j in equation k.
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
  mass[0] = 2.0 * delta21 * displacement[0] + 2.0 * delta32 * displacement[0] * displacement[1]
      + delta31 * displacement[0] * displacement[0] + 1.0 + 2.0 * delta22 * displacement[1]
      + delta33 * displacement[1] * displacement[1];
  mass[1] = 0.0;
  mass[2] = 0.0;
  mass[3] = 2.0 * delta35 * displacement[0] * displacement[1] + 2.0 * delta23 * displacement[0]
      + delta34 * displacement[0] * displacement[0] + 2.0 * delta24 * displacement[1]
      + delta36 * displacement[1] * displacement[1] + 1.0;
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
/// acceleration: 2 values.
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
  acceleration[0] = -(omega1_2 * displacement[0] + 2.0 * delta32 * displacement[0] * velocity[0] * velocity[1]
      + delta31 * displacement[0] * velocity[0] * velocity[0] + 2.0 * alpha22 * displacement[0] * displacement[1]
      + alpha33 * displacement[0] * displacement[1] * displacement[1]
      - delta34 * displacement[0] * velocity[1] * velocity[1] - eta12 * displacement[0] * excitation[0].value
      + alpha21 * displacement[0] * displacement[0]
      + 3.0 * alpha32 * displacement[0] * displacement[0] * displacement[1]
      + alpha31 * displacement[0] * displacement[0] * displacement[0] + 2.0 * mu11 * velocity[0]
      + 2.0 * delta33 * velocity[0] * displacement[1] * velocity[1] + 2.0 * delta22 * velocity[0] * velocity[1]
      + delta21 * velocity[0] * velocity[0] + delta32 * velocity[0] * velocity[0] * displacement[1]
      + mu13 * velocity[0] * velocity[0] * velocity[0] - delta35 * displacement[1] * velocity[1] * velocity[1]
      + alpha23 * displacement[1] * displacement[1] + alpha34 * displacement[1] * displacement[1] * displacement[1]
      + mu12 * velocity[1] - delta23 * velocity[1] * velocity[1] - eta11 * excitation[0].value);
  acceleration[1] = -(2.0 * delta34 * displacement[0] * velocity[0] * velocity[1]
      - delta32 * displacement[0] * velocity[0] * velocity[0] + 2.0 * alpha23 * displacement[0] * displacement[1]
      + 3.0 * alpha34 * displacement[0] * displacement[1] * displacement[1]
      + delta35 * displacement[0] * velocity[1] * velocity[1] + alpha22 * displacement[0] * displacement[0]
      + alpha33 * displacement[0] * displacement[0] * displacement[1]
      + alpha32 * displacement[0] * displacement[0] * displacement[0] + mu21 * velocity[0]
      + 2.0 * delta35 * velocity[0] * displacement[1] * velocity[1] + 2.0 * delta23 * velocity[0] * velocity[1]
      - delta22 * velocity[0] * velocity[0] - delta33 * velocity[0] * velocity[0] * displacement[1]
      + omega2_2 * displacement[1] + delta36 * displacement[1] * velocity[1] * velocity[1]
      - eta22 * displacement[1] * excitation[0].value + alpha24 * displacement[1] * displacement[1]
      + alpha35 * displacement[1] * displacement[1] * displacement[1] + 2.0 * mu22 * velocity[1]
      + delta24 * velocity[1] * velocity[1] + mu23 * velocity[1] * velocity[1] * velocity[1]
      - eta21 * excitation[0].value);
  Scalar mass[4];
  mass_matrix(parameters, excitation, displacement, velocity, mass);
  acceleration[0] = acceleration[0] / mass[0];
  acceleration[1] = acceleration[1] / mass[3];
}

/// slope[k * 4 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = v1, v2, D(v1),
/// D(v2). Of nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x) = 0.
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
  for (std::size_t i = 0; i < 8; ++i) slope[i] = 0.0;
  // equation 1 by v1
  slope[0] = -(omega1_2 + 2.0 * delta32 * velocity[0] * velocity[1] + delta31 * velocity[0] * velocity[0]
      + 2.0 * delta21 * acceleration[0] + 2.0 * delta32 * displacement[1] * acceleration[0]
      + 2.0 * alpha22 * displacement[1] + alpha33 * displacement[1] * displacement[1]
      - delta34 * velocity[1] * velocity[1] - eta12 * excitation[0].value + alpha21 * displacement[0] * 2.0
      + delta31 * displacement[0] * 2.0 * acceleration[0] + 3.0 * alpha32 * displacement[0] * displacement[1] * 2.0
      + alpha31 * displacement[0] * displacement[0] * 3.0);
  // equation 1 by v2
  slope[1] = -(2.0 * delta32 * displacement[0] * acceleration[0] + 2.0 * alpha22 * displacement[0]
      + alpha33 * displacement[0] * displacement[1] * 2.0 + 3.0 * alpha32 * displacement[0] * displacement[0]
      + 2.0 * delta33 * velocity[0] * velocity[1] + delta32 * velocity[0] * velocity[0]
      + 2.0 * delta22 * acceleration[0] + delta33 * displacement[1] * 2.0 * acceleration[0]
      - delta35 * velocity[1] * velocity[1] + alpha23 * displacement[1] * 2.0
      + alpha34 * displacement[1] * displacement[1] * 3.0);
  // equation 1 by D(v1)
  slope[2] = -(2.0 * delta32 * displacement[0] * velocity[1] + delta31 * displacement[0] * velocity[0] * 2.0
      + 2.0 * mu11 + 2.0 * delta33 * displacement[1] * velocity[1] + 2.0 * delta22 * velocity[1]
      + delta21 * velocity[0] * 2.0 + delta32 * velocity[0] * displacement[1] * 2.0
      + mu13 * velocity[0] * velocity[0] * 3.0);
  // equation 1 by D(v2)
  slope[3] = -(2.0 * delta32 * displacement[0] * velocity[0] - delta34 * displacement[0] * velocity[1] * 2.0
      + 2.0 * delta33 * velocity[0] * displacement[1] + 2.0 * delta22 * velocity[0]
      - delta35 * displacement[1] * velocity[1] * 2.0 + mu12 - delta23 * velocity[1] * 2.0);
  // equation 2 by v1
  slope[4] = -(2.0 * delta34 * velocity[0] * velocity[1] - delta32 * velocity[0] * velocity[0]
      + 2.0 * alpha23 * displacement[1] + 2.0 * delta35 * displacement[1] * acceleration[1]
      + 3.0 * alpha34 * displacement[1] * displacement[1] + delta35 * velocity[1] * velocity[1]
      + 2.0 * delta23 * acceleration[1] + alpha22 * displacement[0] * 2.0
      + alpha33 * displacement[0] * displacement[1] * 2.0 + delta34 * displacement[0] * 2.0 * acceleration[1]
      + alpha32 * displacement[0] * displacement[0] * 3.0);
  // equation 2 by v2
  slope[5] = -(2.0 * alpha23 * displacement[0] + 2.0 * delta35 * displacement[0] * acceleration[1]
      + 3.0 * alpha34 * displacement[0] * displacement[1] * 2.0 + alpha33 * displacement[0] * displacement[0]
      + 2.0 * delta35 * velocity[0] * velocity[1] - delta33 * velocity[0] * velocity[0] + omega2_2
      + delta36 * velocity[1] * velocity[1] + 2.0 * delta24 * acceleration[1] - eta22 * excitation[0].value
      + alpha24 * displacement[1] * 2.0 + delta36 * displacement[1] * 2.0 * acceleration[1]
      + alpha35 * displacement[1] * displacement[1] * 3.0);
  // equation 2 by D(v1)
  slope[6] = -(2.0 * delta34 * displacement[0] * velocity[1] - delta32 * displacement[0] * velocity[0] * 2.0 + mu21
      + 2.0 * delta35 * displacement[1] * velocity[1] + 2.0 * delta23 * velocity[1] - delta22 * velocity[0] * 2.0
      - delta33 * velocity[0] * displacement[1] * 2.0);
  // equation 2 by D(v2)
  slope[7] = -(2.0 * delta34 * displacement[0] * velocity[0] + delta35 * displacement[0] * velocity[1] * 2.0
      + 2.0 * delta35 * velocity[0] * displacement[1] + 2.0 * delta23 * velocity[0]
      + delta36 * displacement[1] * velocity[1] * 2.0 + 2.0 * mu22 + delta24 * velocity[1] * 2.0
      + mu23 * velocity[1] * velocity[1] * 3.0);
  Scalar mass[4];
  mass_matrix(parameters, excitation, displacement, velocity, mass);
  for (std::size_t i = 0; i < 4; ++i) slope[i] = slope[i] / mass[0];
  for (std::size_t i = 4; i < 8; ++i) slope[i] = slope[i] / mass[3];
}

/// slope[k * 31 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = omega1, omega2,
/// mu11, mu12, mu13, alpha21, alpha22, alpha23, delta21, delta22, delta23, alpha31, alpha32, alpha33, alpha34,
/// delta31, delta32, delta33, delta34, delta35, eta11, eta12, mu22, mu21, mu23, alpha24, delta24, alpha35,
/// delta36, eta21, eta22. Of nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and
/// d sgn(x) = 0.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_parameters([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  Scalar acceleration[2];
  accelerations(parameters, excitation, displacement, velocity, acceleration);
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  for (std::size_t i = 0; i < 62; ++i) slope[i] = 0.0;
  slope[0] = -(2.0 * omega1 * displacement[0]);  // equation 1 by omega1
  slope[2] = -(2.0 * velocity[0]);  // equation 1 by mu11
  slope[3] = -(velocity[1]);  // equation 1 by mu12
  slope[4] = -(velocity[0] * velocity[0] * velocity[0]);  // equation 1 by mu13
  slope[5] = -(displacement[0] * displacement[0]);  // equation 1 by alpha21
  slope[6] = -(2.0 * displacement[0] * displacement[1]);  // equation 1 by alpha22
  slope[7] = -(displacement[1] * displacement[1]);  // equation 1 by alpha23
  slope[8] = -(2.0 * displacement[0] * acceleration[0] + velocity[0] * velocity[0]);  // equation 1 by delta21
  slope[9] = -(2.0 * velocity[0] * velocity[1] + 2.0 * displacement[1] * acceleration[0]);  // equation 1 by delta22
  slope[10] = -(-velocity[1] * velocity[1]);  // equation 1 by delta23
  slope[11] = -(displacement[0] * displacement[0] * displacement[0]);  // equation 1 by alpha31
  slope[12] = -(3.0 * displacement[0] * displacement[0] * displacement[1]);  // equation 1 by alpha32
  slope[13] = -(displacement[0] * displacement[1] * displacement[1]);  // equation 1 by alpha33
  slope[14] = -(displacement[1] * displacement[1] * displacement[1]);  // equation 1 by alpha34
  // equation 1 by delta31
  slope[15] = -(displacement[0] * velocity[0] * velocity[0] + displacement[0] * displacement[0] * acceleration[0]);
  // equation 1 by delta32
  slope[16] = -(2.0 * displacement[0] * velocity[0] * velocity[1]
      + 2.0 * displacement[0] * displacement[1] * acceleration[0] + velocity[0] * velocity[0] * displacement[1]);
  // equation 1 by delta33
  slope[17] = -(2.0 * velocity[0] * displacement[1] * velocity[1]
      + displacement[1] * displacement[1] * acceleration[0]);
  slope[18] = -(-displacement[0] * velocity[1] * velocity[1]);  // equation 1 by delta34
  slope[19] = -(-displacement[1] * velocity[1] * velocity[1]);  // equation 1 by delta35
  slope[20] = -(-excitation[0].value);  // equation 1 by eta11
  slope[21] = -(-displacement[0] * excitation[0].value);  // equation 1 by eta12
  slope[32] = -(2.0 * omega2 * displacement[1]);  // equation 2 by omega2
  slope[37] = -(displacement[0] * displacement[0]);  // equation 2 by alpha22
  slope[38] = -(2.0 * displacement[0] * displacement[1]);  // equation 2 by alpha23
  slope[40] = -(-velocity[0] * velocity[0]);  // equation 2 by delta22
  // equation 2 by delta23
  slope[41] = -(2.0 * displacement[0] * acceleration[1] + 2.0 * velocity[0] * velocity[1]);
  slope[43] = -(displacement[0] * displacement[0] * displacement[0]);  // equation 2 by alpha32
  slope[44] = -(displacement[0] * displacement[0] * displacement[1]);  // equation 2 by alpha33
  slope[45] = -(3.0 * displacement[0] * displacement[1] * displacement[1]);  // equation 2 by alpha34
  slope[47] = -(-displacement[0] * velocity[0] * velocity[0]);  // equation 2 by delta32
  slope[48] = -(-velocity[0] * velocity[0] * displacement[1]);  // equation 2 by delta33
  // equation 2 by delta34
  slope[49] = -(2.0 * displacement[0] * velocity[0] * velocity[1]
      + displacement[0] * displacement[0] * acceleration[1]);
  // equation 2 by delta35
  slope[50] = -(2.0 * displacement[0] * displacement[1] * acceleration[1]
      + displacement[0] * velocity[1] * velocity[1] + 2.0 * velocity[0] * displacement[1] * velocity[1]);
  slope[53] = -(2.0 * velocity[1]);  // equation 2 by mu22
  slope[54] = -(velocity[0]);  // equation 2 by mu21
  slope[55] = -(velocity[1] * velocity[1] * velocity[1]);  // equation 2 by mu23
  slope[56] = -(displacement[1] * displacement[1]);  // equation 2 by alpha24
  slope[57] = -(2.0 * displacement[1] * acceleration[1] + velocity[1] * velocity[1]);  // equation 2 by delta24
  slope[58] = -(displacement[1] * displacement[1] * displacement[1]);  // equation 2 by alpha35
  // equation 2 by delta36
  slope[59] = -(displacement[1] * velocity[1] * velocity[1] + displacement[1] * displacement[1] * acceleration[1]);
  slope[60] = -(-excitation[0].value);  // equation 2 by eta21
  slope[61] = -(-displacement[1] * excitation[0].value);  // equation 2 by eta22
  Scalar mass[4];
  mass_matrix(parameters, excitation, displacement, velocity, mass);
  for (std::size_t i = 0; i < 31; ++i) slope[i] = slope[i] / mass[0];
  for (std::size_t i = 31; i < 62; ++i) slope[i] = slope[i] / mass[3];
}

/// Lumps: the parameter combinations that multiply data. Symbols, their powers and the inverses of sums that
/// divide (small divisors) first, each once.
struct Lumps {
  const double omega1, omega2, mu11, mu12, mu13, alpha21, alpha22, alpha23, delta21, delta22, delta23, alpha31,
      alpha32, alpha33, alpha34, delta31, delta32, delta33, delta34, delta35, eta11, eta12, mu22, mu21, mu23,
      alpha24, delta24, alpha35, delta36, eta21, eta22;
  const double omega1_2 = omega1 * omega1;
  const double omega1_3 = omega1_2 * omega1;
  const double omega1_4 = omega1_3 * omega1;
  const double omega1_5 = omega1_4 * omega1;
  const double omega1_6 = omega1_5 * omega1;
  const double omega2_2 = omega2 * omega2;
  const double omega2_3 = omega2_2 * omega2;
  const double omega2_4 = omega2_3 * omega2;
  const double omega2_5 = omega2_4 * omega2;
  const double omega2_6 = omega2_5 * omega2;
  const double alpha21_2 = alpha21 * alpha21;
  const double alpha22_2 = alpha22 * alpha22;
  const double alpha23_2 = alpha23 * alpha23;
  const double delta21_2 = delta21 * delta21;
  const double delta22_2 = delta22 * delta22;
  const double delta23_2 = delta23 * delta23;
  const double eta12_2 = eta12 * eta12;
  const double alpha24_2 = alpha24 * alpha24;
  const double delta24_2 = delta24 * delta24;
  const double eta22_2 = eta22 * eta22;
  const double per_0 = 1.0 / (omega1 + omega2);
  const double per_0_2 = per_0 * per_0;
  const double per_1 = 1.0 / (omega1 - omega2);
  const double per_2 = 1.0 / (omega1 + 2.0 * omega2);
  const double per_3 = 1.0 / (omega1 - 2.0 * omega2);
  const double per_4 = 1.0 / (2.0 * omega1 + omega2);
  const double per_5 = 1.0 / (2.0 * omega1 - omega2);
  const double per_6 = 1.0 / (3.0 * omega1 - omega2);
  const double per_7 = 1.0 / (omega1 + 3.0 * omega2);
  const double per_8 = 1.0 / (omega1 - 3.0 * omega2);
  const double per_9 = 1.0 / (3.0 * omega1 + omega2);
  const double per_10 = 1.0 / (3.0 * omega1 + 2.0 * omega2);
  const double per_11 = 1.0 / (4.0 * omega1 + omega2);
  const double per_12 = 1.0 / (2.0 * omega1 + 3.0 * omega2);
  const double over_0 = per_0 * per_1;
  const double over_1 = per_2 * per_3;
  const double over_2 = per_4 * per_5;
  const double over_3 = per_3 * per_5;
  const double over_4 = per_0 * per_1 * per_5;
  const double over_5 = per_0 * per_5;
  const double over_6 = per_0 * per_2 * per_1;
  const double over_7 = per_0 * per_2 * per_1 * per_3;
  const double over_8 = per_0 * per_1 * per_4 * per_5;
  const double over_9 = per_1 * per_4;
  const double over_10 = per_0 * per_1 * per_3;
  const double over_11 = per_0 * per_1 * per_4;
  const double over_12 = per_2 * per_4;
  const double over_13 = per_1 * per_6;
  const double over_14 = per_3 * per_6;
  const double over_15 = per_1 * per_5 * per_6;
  const double over_16 = per_1 * per_4 * per_5 * per_6;
  const double over_17 = per_1 * per_3 * per_4 * per_5 * per_6;
  const double over_18 = per_1 * per_3;
  const double over_19 = per_1 * per_5;
  const double over_20 = per_2 * per_1 * per_3;
  const double over_21 = per_0 * per_2;
  const double over_22 = per_0 * per_4;
  const double over_23 = per_0 * per_2 * per_3;
  const double over_24 = per_7 * per_8;
  const double over_25 = per_2 * per_7 * per_3 * per_8;
  const double over_26 = per_0 * per_9;
  const double over_27 = per_2 * per_9;
  const double over_28 = per_0 * per_4 * per_9;
  const double over_29 = per_0 * per_4 * per_5 * per_9;
  const double over_30 = per_0 * per_2 * per_4 * per_5 * per_9;
  const double over_31 = per_1 * per_4 * per_5;
  const double over_32 = per_1 * per_8;
  const double over_33 = per_8 * per_5;
  const double over_34 = per_1 * per_3 * per_8;
  const double over_35 = per_2 * per_1 * per_3 * per_8;
  const double over_36 = per_2 * per_1 * per_3 * per_8 * per_5;
  const double over_37 = per_0 * per_4 * per_5;
  const double over_38 = per_0 * per_7;
  const double over_39 = per_7 * per_4;
  const double over_40 = per_0 * per_2 * per_7;
  const double over_41 = per_0 * per_2 * per_7 * per_3;
  const double over_42 = per_0 * per_2 * per_7 * per_3 * per_4;
  const double over_43 = per_9 * per_6;
  const double over_44 = per_4 * per_5 * per_9 * per_6;
  const double over_45 = per_0 * per_3;
  const double over_46 = per_2 * per_1;
  const double over_47 = per_1 * per_8 * per_5;
  const double over_48 = per_1 * per_9;
  const double over_49 = per_7 * per_1;
  const double over_50 = per_2 * per_3 * per_5;
  const double over_51 = per_7 * per_1 * per_4;
  const double over_52 = per_1 * per_4 * per_9;
  const double over_53 = per_0 * per_2 * per_1 * per_3 * per_5;
  const double over_54 = per_0 * per_2 * per_9;
  const double over_55 = per_0 * per_5 * per_9;
  const double over_56 = per_0_2 * per_7;
  const double over_57 = per_0_2 * per_1;
  const double over_58 = per_2 * per_7 * per_10;
  const double over_59 = per_0 * per_2 * per_7 * per_10;
  const double over_60 = per_2 * per_4 * per_9 * per_10;
  const double over_61 = per_0 * per_2 * per_4 * per_9 * per_10;
  const double over_62 = per_0 * per_4 * per_9 * per_11;
  const double over_63 = per_3 * per_4 * per_5;
  const double over_64 = per_2 * per_7 * per_1;
  const double over_65 = per_2 * per_1 * per_9;
  const double over_66 = per_0 * per_7 * per_4;
  const double over_67 = per_0 * per_7 * per_3;
  const double over_68 = per_0 * per_1 * per_3 * per_4 * per_5;
  const double over_69 = per_0_2 * per_9;
  const double over_70 = per_4 * per_12 * per_9;
  const double over_71 = per_0 * per_4 * per_12 * per_9;
  const double over_72 = per_2 * per_7 * per_4 * per_12;
  const double over_73 = per_0 * per_2 * per_7 * per_4 * per_12;
  const double over_74 = per_0 * per_9 * per_10;
  const double over_75 = per_4 * per_5 * per_10;

  explicit Lumps(const double* parameters) : omega1(parameters[0]), omega2(parameters[1]), mu11(parameters[2]),
      mu12(parameters[3]), mu13(parameters[4]), alpha21(parameters[5]), alpha22(parameters[6]),
      alpha23(parameters[7]), delta21(parameters[8]), delta22(parameters[9]), delta23(parameters[10]),
      alpha31(parameters[11]), alpha32(parameters[12]), alpha33(parameters[13]), alpha34(parameters[14]),
      delta31(parameters[15]), delta32(parameters[16]), delta33(parameters[17]), delta34(parameters[18]),
      delta35(parameters[19]), eta11(parameters[20]), eta12(parameters[21]), mu22(parameters[22]),
      mu21(parameters[23]), mu23(parameters[24]), alpha24(parameters[25]), delta24(parameters[26]),
      alpha35(parameters[27]), delta36(parameters[28]), eta21(parameters[29]), eta22(parameters[30]) {}

  /// conservative_v1_A_v12_F = (-3*omega1^2*delta21*eta12 + 5*alpha21*eta12)/(12*omega1^3)
  double lump_conservative_v1_A_v12_F() const {
    return (-3.0 * omega1_2 * delta21 * eta12 + 5.0 * alpha21 * eta12) / (12.0 * omega1_3);
  }
  double lump_mu11() const { return mu11; }
  double lump_conservative_v1_A_v1() const { return -omega1 * mu12 * mu21 * over_0 / 2.0; }
  double lump_conservative_v1_A_v1_F2() const { return -eta12_2 / (12.0 * omega1_3); }
  /// conservative_v1_A_v1_A_v2_conjA_v2 = (-2*omega1^4*omega2^2*delta22*delta24 - omega1^4*omega2^2*delta33 +
  /// 2*omega1^4*delta22*alpha24 - 2*omega1^2*omega2^4*delta21*delta23 - omega1^2*omega2^4*delta34 +
  /// 2*omega1^2*omega2^2*alpha22*delta24 + 2*omega1^2*omega2^2*alpha23*delta21 + omega1^2*omega2^2*alpha33 -
  /// 2*omega1^2*alpha22*alpha24 + 2*omega2^4*alpha21*delta23 - 2*omega2^2*alpha21*alpha23)/(omega1^3*omega2^2) +
  /// (4*omega1^2*omega2^2*delta23^2 - 12*omega2^4*delta23^2 + 8*omega2^2*alpha23*delta23 +
  /// 4*alpha23^2)/(omega1*(omega1 + 2*omega2)*(omega1 - 2*omega2)) + (12*omega1^4*delta22^2 -
  /// 4*omega1^2*omega2^2*delta22^2 - 8*omega1^2*alpha22*delta22 - 4*alpha22^2)/(omega1*(2*omega1 +
  /// omega2)*(2*omega1 - omega2))
  double lump_conservative_v1_A_v1_A_v2_conjA_v2() const {
    return (-2.0 * omega1_4 * omega2_2 * delta22 * delta24 - omega1_4 * omega2_2 * delta33
        + 2.0 * omega1_4 * delta22 * alpha24 - 2.0 * omega1_2 * omega2_4 * delta21 * delta23
        - omega1_2 * omega2_4 * delta34 + 2.0 * omega1_2 * omega2_2 * alpha22 * delta24
        + 2.0 * omega1_2 * omega2_2 * alpha23 * delta21 + omega1_2 * omega2_2 * alpha33
        - 2.0 * omega1_2 * alpha22 * alpha24 + 2.0 * omega2_4 * alpha21 * delta23
        - 2.0 * omega2_2 * alpha21 * alpha23) / (omega1_3 * omega2_2) + (4.0 * omega1_2 * omega2_2 * delta23_2
        - 12.0 * omega2_4 * delta23_2 + 8.0 * omega2_2 * alpha23 * delta23 + 4.0 * alpha23_2) * over_1 / omega1
        + (12.0 * omega1_4 * delta22_2 - 4.0 * omega1_2 * omega2_2 * delta22_2 - 8.0 * omega1_2 * alpha22 * delta22
        - 4.0 * alpha22_2) * over_2 / omega1;
  }
  double lump_mu13() const { return mu13; }
  /// conservative_v1_A_v12_conjA_v1 = (6*omega1^4*delta21^2 - 6*omega1^4*delta31 + 12*omega1^2*alpha21*delta21 +
  /// 9*omega1^2*alpha31 - 10*alpha21^2)/(6*omega1^3) + (-8*omega1^6*delta22^2 + 3*omega1^4*omega2^2*delta22^2 +
  /// 16*omega1^4*alpha22*delta22 - 2*omega1^2*omega2^2*alpha22*delta22 - 8*omega1^2*alpha22^2 +
  /// 3*omega2^2*alpha22^2)/(omega1*omega2^2*(2*omega1 + omega2)*(2*omega1 - omega2))
  double lump_conservative_v1_A_v12_conjA_v1() const {
    return (6.0 * omega1_4 * delta21_2 - 6.0 * omega1_4 * delta31 + 12.0 * omega1_2 * alpha21 * delta21
        + 9.0 * omega1_2 * alpha31 - 10.0 * alpha21_2) / (6.0 * omega1_3) + (-8.0 * omega1_6 * delta22_2
        + 3.0 * omega1_4 * omega2_2 * delta22_2 + 16.0 * omega1_4 * alpha22 * delta22
        - 2.0 * omega1_2 * omega2_2 * alpha22 * delta22 - 8.0 * omega1_2 * alpha22_2
        + 3.0 * omega2_2 * alpha22_2) * over_2 / (omega1 * omega2_2);
  }
  double lump_eta11() const { return eta11; }
  /// conservative_v1_A_v2_conjA_v2_F = (-omega2^2*delta23*eta12 + alpha23*eta12)/(2*omega1^3) +
  /// (-omega2^2*delta23*eta22 - alpha23*eta22)/(omega1*(omega1 + 2*omega2)*(omega1 - 2*omega2))
  double lump_conservative_v1_A_v2_conjA_v2_F() const {
    return (-omega2_2 * delta23 * eta12 + alpha23 * eta12) / (2.0 * omega1_3) + (-omega2_2 * delta23 * eta22
        - alpha23 * eta22) * over_1 / omega1;
  }
  double lump_mu22() const { return mu22; }
  double lump_conservative_v2_A_v2_F2() const { return eta22_2 * over_1 / (4.0 * omega2); }
  double lump_mu23() const { return mu23; }
  /// conservative_v2_A_v22_conjA_v2 = (6*omega2^4*delta24^2 - 6*omega2^4*delta36 + 12*omega2^2*alpha24*delta24 +
  /// 9*omega2^2*alpha35 - 10*alpha24^2)/(6*omega2^3) + (-3*omega1^2*omega2^4*delta23^2 +
  /// 2*omega1^2*omega2^2*alpha23*delta23 - 3*omega1^2*alpha23^2 + 8*omega2^6*delta23^2 -
  /// 16*omega2^4*alpha23*delta23 + 8*omega2^2*alpha23^2)/(omega1^2*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))
  double lump_conservative_v2_A_v22_conjA_v2() const {
    return (6.0 * omega2_4 * delta24_2 - 6.0 * omega2_4 * delta36 + 12.0 * omega2_2 * alpha24 * delta24
        + 9.0 * omega2_2 * alpha35 - 10.0 * alpha24_2) / (6.0 * omega2_3) + (-3.0 * omega1_2 * omega2_4 * delta23_2
        + 2.0 * omega1_2 * omega2_2 * alpha23 * delta23 - 3.0 * omega1_2 * alpha23_2 + 8.0 * omega2_6 * delta23_2
        - 16.0 * omega2_4 * alpha23 * delta23 + 8.0 * omega2_2 * alpha23_2) * over_1 / (omega1_2 * omega2);
  }
  double lump_eta12() const { return eta12; }
  /// harmonic_re_v1_A_v2_conjA_v2 = (2*omega2^2*delta23 - 2*alpha23)/omega1^2
  double lump_harmonic_re_v1_A_v2_conjA_v2() const {
    return (2.0 * omega2_2 * delta23 - 2.0 * alpha23) / omega1_2;
  }
  /// harmonic_re_v1_A_v1_conjA_v1 = (2*omega1^2*delta21 - 2*alpha21)/omega1^2
  double lump_harmonic_re_v1_A_v1_conjA_v1() const {
    return (2.0 * omega1_2 * delta21 - 2.0 * alpha21) / omega1_2;
  }
  /// harmonic_re_v1_A_v2_conjA_v1 = (2*omega1^2*delta22 - 2*omega1*omega2*delta22 - 2*alpha22)/(omega2*(2*omega1 -
  /// omega2))
  double lump_harmonic_re_v1_A_v2_conjA_v1() const {
    return (2.0 * omega1_2 * delta22 - 2.0 * omega1 * omega2 * delta22 - 2.0 * alpha22) * per_5 / omega2;
  }
  /// harmonic_im_v1_A_v2_conjA_v1 = (2*omega1^2*omega2*mu12*delta23 - 4*omega1*omega2^2*mu12*delta23 +
  /// 2*omega1*mu12*alpha23 + 2*omega2^3*mu12*delta23 - 2*omega2*mu12*alpha23)/(omega1*omega2*(omega1 -
  /// 2*omega2)*(2*omega1 - omega2)) + (-2*omega1^2*omega2*mu12*delta21 - 2*omega1^2*omega2*delta23*mu21 +
  /// 2*omega1*omega2^2*mu12*delta21 + 2*omega1*alpha23*mu21 - 2*omega2^3*mu12*delta21 +
  /// 2*omega2*mu12*alpha21)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 - omega2))
  double lump_harmonic_im_v1_A_v2_conjA_v1() const {
    return (2.0 * omega1_2 * omega2 * mu12 * delta23 - 4.0 * omega1 * omega2_2 * mu12 * delta23
        + 2.0 * omega1 * mu12 * alpha23 + 2.0 * omega2_3 * mu12 * delta23
        - 2.0 * omega2 * mu12 * alpha23) * over_3 / (omega1 * omega2) + (-2.0 * omega1_2 * omega2 * mu12 * delta21
        - 2.0 * omega1_2 * omega2 * delta23 * mu21 + 2.0 * omega1 * omega2_2 * mu12 * delta21
        + 2.0 * omega1 * alpha23 * mu21 - 2.0 * omega2_3 * mu12 * delta21
        + 2.0 * omega2 * mu12 * alpha21) * over_4 / omega2;
  }
  /// harmonic_im_v1_A_v2_F = (-omega1*mu12*eta22 + omega2*mu12*eta22)/(2*omega1*omega2*(omega1 -
  /// 2*omega2)*(2*omega1 - omega2)) - mu12*eta12/(2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 - omega2))
  double lump_harmonic_im_v1_A_v2_F() const {
    return (-omega1 * mu12 * eta22 + omega2 * mu12 * eta22) * over_3 / (2.0 * omega1 * omega2)
        - mu12 * eta12 * over_4 / 2.0;
  }
  double lump_mu12() const { return mu12; }
  /// harmonic_re_v1_A_v2_conjA_v1_F = omega1*delta22*eta12/(omega2*(omega1 + omega2)*(2*omega1 - omega2)) +
  /// (omega1*omega2*delta22*eta22 + alpha22*eta22)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 -
  /// omega2)) + (-omega1^2*alpha22*eta12 - 2*omega1*omega2*alpha22*eta12 +
  /// omega2^2*alpha22*eta12)/(omega1^2*omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 - omega2))
  double lump_harmonic_re_v1_A_v2_conjA_v1_F() const {
    return omega1 * delta22 * eta12 * over_5 / omega2 + (omega1 * omega2 * delta22 * eta22
        + alpha22 * eta22) * over_6 / omega1 + (-omega1_2 * alpha22 * eta12
        - 2.0 * omega1 * omega2 * alpha22 * eta12 + omega2_2 * alpha22 * eta12) * over_4 / (omega1_2 * omega2);
  }
  /// harmonic_re_v1_A_v22_conjA_v2 = (-12*omega2^4*delta23*delta24 + 3*omega2^4*delta35 -
  /// 6*omega2^2*alpha23*delta24 + 4*omega2^2*delta23*alpha24 - 9*omega2^2*alpha34 +
  /// 10*alpha23*alpha24)/(3*omega2^2*(omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^2*omega2^4*delta22*delta23
  /// - 2*omega1^2*omega2^2*alpha22*delta23 - 4*omega1^2*omega2^2*alpha23*delta22 + 6*omega1^2*alpha22*alpha23 +
  /// 16*omega2^4*alpha22*delta23 - 16*omega2^2*alpha22*alpha23)/(omega1^2*(omega1 + omega2)*(omega1 +
  /// 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))
  double lump_harmonic_re_v1_A_v22_conjA_v2() const {
    return (-12.0 * omega2_4 * delta23 * delta24 + 3.0 * omega2_4 * delta35 - 6.0 * omega2_2 * alpha23 * delta24
        + 4.0 * omega2_2 * delta23 * alpha24 - 9.0 * omega2_2 * alpha34
        + 10.0 * alpha23 * alpha24) * over_0 / (3.0 * omega2_2) + (-4.0 * omega1_2 * omega2_4 * delta22 * delta23
        - 2.0 * omega1_2 * omega2_2 * alpha22 * delta23 - 4.0 * omega1_2 * omega2_2 * alpha23 * delta22
        + 6.0 * omega1_2 * alpha22 * alpha23 + 16.0 * omega2_4 * alpha22 * delta23
        - 16.0 * omega2_2 * alpha22 * alpha23) * over_7 / omega1_2;
  }
  /// harmonic_re_v1_A_v1_A_v2_conjA_v1 = (2*omega1^2*delta32 - 6*alpha32)/((omega1 + omega2)*(omega1 - omega2)) +
  /// (-4*omega1^4*alpha23*delta22 + 8*omega1^2*omega2^4*delta22*delta23 + 16*omega1^2*omega2^2*alpha23*delta22 +
  /// 4*omega1^2*alpha22*alpha23 - 16*omega2^6*delta22*delta23 - 8*omega2^4*alpha22*delta23 +
  /// 16*omega2^4*alpha23*delta22 - 24*omega2^2*alpha22*alpha23)/(omega2^2*(omega1 + omega2)*(omega1 +
  /// 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) + (-24*omega1^6*delta21*delta22 + 8*omega1^4*alpha21*delta22
  /// - 8*omega1^4*alpha22*delta21 - 4*omega1^2*omega2^2*alpha22*delta21 + 24*omega1^2*alpha21*alpha22 -
  /// 4*omega2^2*alpha21*alpha22)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 -
  /// omega2))
  double lump_harmonic_re_v1_A_v1_A_v2_conjA_v1() const {
    return (2.0 * omega1_2 * delta32 - 6.0 * alpha32) * over_0 + (-4.0 * omega1_4 * alpha23 * delta22
        + 8.0 * omega1_2 * omega2_4 * delta22 * delta23 + 16.0 * omega1_2 * omega2_2 * alpha23 * delta22
        + 4.0 * omega1_2 * alpha22 * alpha23 - 16.0 * omega2_6 * delta22 * delta23
        - 8.0 * omega2_4 * alpha22 * delta23 + 16.0 * omega2_4 * alpha23 * delta22
        - 24.0 * omega2_2 * alpha22 * alpha23) * over_7 / omega2_2 + (-24.0 * omega1_6 * delta21 * delta22
        + 8.0 * omega1_4 * alpha21 * delta22 - 8.0 * omega1_4 * alpha22 * delta21
        - 4.0 * omega1_2 * omega2_2 * alpha22 * delta21 + 24.0 * omega1_2 * alpha21 * alpha22
        - 4.0 * omega2_2 * alpha21 * alpha22) * over_8 / omega1_2;
  }
  /// harmonic_re_v1_A_v1_A_v2_F = -omega1*delta22*eta12/(omega2*(omega1 - omega2)*(2*omega1 + omega2)) +
  /// (-omega1*omega2*delta22*eta22 + alpha22*eta22)/(omega1*(omega1 + omega2)*(omega1 - omega2)*(omega1 -
  /// 2*omega2)) + (omega1^2*alpha22*eta12 - 2*omega1*omega2*alpha22*eta12 -
  /// omega2^2*alpha22*eta12)/(omega1^2*omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2))
  double lump_harmonic_re_v1_A_v1_A_v2_F() const {
    return -omega1 * delta22 * eta12 * over_9 / omega2 + (-omega1 * omega2 * delta22 * eta22
        + alpha22 * eta22) * over_10 / omega1 + (omega1_2 * alpha22 * eta12
        - 2.0 * omega1 * omega2 * alpha22 * eta12 - omega2_2 * alpha22 * eta12) * over_11 / (omega1_2 * omega2);
  }
  double lump_harmonic_re_v1_A_v22() const { return (-omega2_2 * delta23 - alpha23) * over_1; }
  /// harmonic_im_v1_A_v22 = (6*omega2^2*mu12*delta24 - 2*mu12*alpha24)/(3*omega2*(omega1 + 2*omega2)*(omega1 -
  /// 2*omega2)) + (-4*omega2^3*mu12*delta22 + 2*omega2*mu12*alpha22)/((omega1 + omega2)*(omega1 +
  /// 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))
  double lump_harmonic_im_v1_A_v22() const {
    return (6.0 * omega2_2 * mu12 * delta24 - 2.0 * mu12 * alpha24) * over_1 / (3.0 * omega2)
        + (-4.0 * omega2_3 * mu12 * delta22 + 2.0 * omega2 * mu12 * alpha22) * over_7;
  }
  double lump_harmonic_re_v1_A_v12() const { return (-3.0 * omega1_2 * delta21 + alpha21) / (3.0 * omega1_2); }
  /// harmonic_im_v1_A_v12 = (-4*omega1^2*delta22*mu21 + 2*alpha22*mu21)/(3*omega1*(omega1 + omega2)*(omega1 -
  /// omega2)) + (2*omega1^2*mu12*delta22 + 2*mu12*alpha22)/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2))
  double lump_harmonic_im_v1_A_v12() const {
    return (-4.0 * omega1_2 * delta22 * mu21 + 2.0 * alpha22 * mu21) * over_0 / (3.0 * omega1)
        + (2.0 * omega1_2 * mu12 * delta22 + 2.0 * mu12 * alpha22) * over_2 / (3.0 * omega1);
  }
  /// harmonic_re_v1_A_v1_A_v2 = (-2*omega1^2*delta22 - 2*omega1*omega2*delta22 + 2*alpha22)/(omega2*(2*omega1 +
  /// omega2))
  double lump_harmonic_re_v1_A_v1_A_v2() const {
    return (-2.0 * omega1_2 * delta22 - 2.0 * omega1 * omega2 * delta22 + 2.0 * alpha22) * per_4 / omega2;
  }
  /// harmonic_im_v1_A_v1_A_v2 = (-2*omega1^2*omega2*mu12*delta23 - 4*omega1*omega2^2*mu12*delta23 +
  /// 2*omega1*mu12*alpha23 - 2*omega2^3*mu12*delta23 + 2*omega2*mu12*alpha23)/(omega1*omega2*(omega1 +
  /// 2*omega2)*(2*omega1 + omega2)) + (2*omega1^2*omega2*mu12*delta21 + 2*omega1^2*omega2*delta23*mu21 +
  /// 2*omega1*omega2^2*mu12*delta21 + 2*omega1*alpha23*mu21 + 2*omega2^3*mu12*delta21 -
  /// 2*omega2*mu12*alpha21)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2))
  double lump_harmonic_im_v1_A_v1_A_v2() const {
    return (-2.0 * omega1_2 * omega2 * mu12 * delta23 - 4.0 * omega1 * omega2_2 * mu12 * delta23
        + 2.0 * omega1 * mu12 * alpha23 - 2.0 * omega2_3 * mu12 * delta23
        + 2.0 * omega2 * mu12 * alpha23) * over_12 / (omega1 * omega2) + (2.0 * omega1_2 * omega2 * mu12 * delta21
        + 2.0 * omega1_2 * omega2 * delta23 * mu21 + 2.0 * omega1 * omega2_2 * mu12 * delta21
        + 2.0 * omega1 * alpha23 * mu21 + 2.0 * omega2_3 * mu12 * delta21
        - 2.0 * omega2 * mu12 * alpha21) * over_11 / omega2;
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
  double lump_harmonic_re_v1_A_v2_conjA_v12() const {
    return (-3.0 * omega1_2 * delta32 + 2.0 * omega1 * omega2 * delta32 + 3.0 * alpha32) * over_13
        + (-8.0 * omega1_2 * omega2 * delta22 * delta23 + 4.0 * omega1 * omega2_2 * delta22 * delta23
        + 4.0 * omega2 * alpha22 * delta23) * over_14 / omega1 + (-36.0 * omega1_6 * delta21 * delta22
        + 120.0 * omega1_5 * omega2 * delta21 * delta22 - 96.0 * omega1_4 * omega2_2 * delta21 * delta22
        + 12.0 * omega1_4 * alpha21 * delta22 + 36.0 * omega1_4 * alpha22 * delta21
        + 24.0 * omega1_3 * omega2_3 * delta21 * delta22 - 28.0 * omega1_3 * omega2 * alpha21 * delta22
        - 48.0 * omega1_3 * omega2 * alpha22 * delta21 + 16.0 * omega1_2 * omega2_2 * alpha21 * delta22
        + 18.0 * omega1_2 * omega2_2 * alpha22 * delta21 - 12.0 * omega1_2 * alpha21 * alpha22
        - 4.0 * omega1 * omega2_3 * alpha21 * delta22 + 4.0 * omega1 * omega2 * alpha21 * alpha22
        - 2.0 * omega2_2 * alpha21 * alpha22) * over_15 / (3.0 * omega1_2 * omega2)
        + (-4.0 * omega1_3 * omega2 * delta22 * delta23 - 4.0 * omega1 * omega2 * alpha22 * delta23) * over_16
        + (-30.0 * omega1_4 * alpha23 * delta22 + 12.0 * omega1_3 * omega2 * alpha23 * delta22
        + 8.0 * omega1_2 * omega2_2 * alpha23 * delta22 + 18.0 * omega1_2 * alpha22 * alpha23
        - 4.0 * omega1 * omega2_3 * alpha23 * delta22 - 4.0 * omega1 * omega2 * alpha22 * alpha23
        - 4.0 * omega2_2 * alpha22 * alpha23) * over_17 / omega1;
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
  double lump_harmonic_re_v1_A_v22_conjA_v1() const {
    return (-6.0 * omega1_2 * omega2_2 * delta22 * delta24 + 3.0 * omega1_2 * omega2_2 * delta33
        + 2.0 * omega1_2 * delta22 * alpha24 + 12.0 * omega1 * omega2_3 * delta22 * delta24
        - 6.0 * omega1 * omega2_3 * delta33 - 4.0 * omega1 * omega2 * delta22 * alpha24 - 3.0 * omega2_4 * delta34
        + 6.0 * omega2_2 * alpha22 * delta24 - 3.0 * omega2_2 * alpha33
        - 2.0 * alpha22 * alpha24) * per_1 / (12.0 * omega2_3) + (omega1 * omega2 * delta23_2
        - omega2_2 * delta23_2) * per_3 / omega1 + (omega1_3 * delta22_2 - 3.0 * omega1_2 * omega2 * delta22_2
        + 2.0 * omega1 * omega2_2 * delta22_2 - 2.0 * omega1 * alpha22 * delta22
        + 2.0 * omega2 * alpha22 * delta22) * per_5 / omega2_2 - alpha23_2 * over_18 / (omega1 * omega2)
        + alpha22_2 * over_19 / omega2_2 + (-omega1_2 * omega2_2 * delta21 * delta23 - omega1_2 * alpha23 * delta21
        + 2.0 * omega1 * omega2_3 * delta21 * delta23 + 2.0 * omega1 * omega2 * alpha23 * delta21
        - 4.0 * omega2_4 * delta21 * delta23 + omega2_2 * alpha21 * delta23 - 4.0 * omega2_2 * alpha23 * delta21
        + alpha21 * alpha23) * over_20 / (2.0 * omega2);
  }
  /// harmonic_re_v1_A_v22_F = -delta23*eta22/(4*omega1*(omega1 - 2*omega2)) +
  /// alpha23*eta22/(4*omega1*omega2*(omega1 - omega2)*(omega1 - 2*omega2)) + (-omega2^2*delta23*eta12 -
  /// alpha23*eta12)/(8*omega2*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))
  double lump_harmonic_re_v1_A_v22_F() const {
    return -delta23 * eta22 * per_3 / (4.0 * omega1) + alpha23 * eta22 * over_18 / (4.0 * omega1 * omega2)
        + (-omega2_2 * delta23 * eta12 - alpha23 * eta12) * over_20 / (8.0 * omega2);
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
  double lump_harmonic_re_v1_A_v1_A_v22() const {
    return (6.0 * omega1_2 * omega2_2 * delta22 * delta24 - 3.0 * omega1_2 * omega2_2 * delta33
        - 2.0 * omega1_2 * delta22 * alpha24 + 12.0 * omega1 * omega2_3 * delta22 * delta24
        - 6.0 * omega1 * omega2_3 * delta33 - 4.0 * omega1 * omega2 * delta22 * alpha24 + 3.0 * omega2_4 * delta34
        - 6.0 * omega2_2 * alpha22 * delta24 + 3.0 * omega2_2 * alpha33
        + 2.0 * alpha22 * alpha24) * per_0 / (12.0 * omega2_3) + (-omega1 * omega2 * delta23_2
        - omega2_2 * delta23_2) * per_2 / omega1 + (omega1_3 * delta22_2 + 3.0 * omega1_2 * omega2 * delta22_2
        + 2.0 * omega1 * omega2_2 * delta22_2 - 2.0 * omega1 * alpha22 * delta22
        - 2.0 * omega2 * alpha22 * delta22) * per_4 / omega2_2 + alpha23_2 * over_21 / (omega1 * omega2)
        + alpha22_2 * over_22 / omega2_2 + (omega1_2 * omega2_2 * delta21 * delta23 + omega1_2 * alpha23 * delta21
        + 2.0 * omega1 * omega2_3 * delta21 * delta23 + 2.0 * omega1 * omega2 * alpha23 * delta21
        + 4.0 * omega2_4 * delta21 * delta23 - omega2_2 * alpha21 * delta23 + 4.0 * omega2_2 * alpha23 * delta21
        - alpha21 * alpha23) * over_23 / (2.0 * omega2);
  }
  /// harmonic_re_v1_A_v23 = (12*omega2^4*delta23*delta24 - 3*omega2^4*delta35 + 6*omega2^2*alpha23*delta24 -
  /// 4*omega2^2*delta23*alpha24 - 3*omega2^2*alpha34 - 2*alpha23*alpha24)/(3*omega2^2*(omega1 + 3*omega2)*(omega1
  /// - 3*omega2)) + (-12*omega2^4*delta22*delta23 + 2*omega2^2*alpha22*delta23 - 12*omega2^2*alpha23*delta22 +
  /// 2*alpha22*alpha23)/((omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))
  double lump_harmonic_re_v1_A_v23() const {
    return (12.0 * omega2_4 * delta23 * delta24 - 3.0 * omega2_4 * delta35 + 6.0 * omega2_2 * alpha23 * delta24
        - 4.0 * omega2_2 * delta23 * alpha24 - 3.0 * omega2_2 * alpha34
        - 2.0 * alpha23 * alpha24) * over_24 / (3.0 * omega2_2) + (-12.0 * omega2_4 * delta22 * delta23
        + 2.0 * omega2_2 * alpha22 * delta23 - 12.0 * omega2_2 * alpha23 * delta22
        + 2.0 * alpha22 * alpha23) * over_25;
  }
  /// harmonic_re_v1_A_v12_F = (17*omega1^2*delta21*eta12 - 3*alpha21*eta12)/(48*omega1^4)
  double lump_harmonic_re_v1_A_v12_F() const {
    return (17.0 * omega1_2 * delta21 * eta12 - 3.0 * alpha21 * eta12) / (48.0 * omega1_4);
  }
  /// harmonic_re_v1_A_v13 = (42*omega1^4*delta21^2 - 6*omega1^4*delta31 - 20*omega1^2*alpha21*delta21 +
  /// 3*omega1^2*alpha31 + 2*alpha21^2)/(24*omega1^4) + (-3*omega1^4*delta22^2 - 2*omega1^2*alpha22*delta22 +
  /// alpha22^2)/(4*omega1^2*(2*omega1 + omega2)*(2*omega1 - omega2))
  double lump_harmonic_re_v1_A_v13() const {
    return (42.0 * omega1_4 * delta21_2 - 6.0 * omega1_4 * delta31 - 20.0 * omega1_2 * alpha21 * delta21
        + 3.0 * omega1_2 * alpha31 + 2.0 * alpha21_2) / (24.0 * omega1_4) + (-3.0 * omega1_4 * delta22_2
        - 2.0 * omega1_2 * alpha22 * delta22 + alpha22_2) * over_2 / (4.0 * omega1_2);
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
  double lump_harmonic_re_v1_A_v12_A_v2() const {
    return (-3.0 * omega1_2 * delta32 - 2.0 * omega1 * omega2 * delta32 + 3.0 * alpha32) * over_26
        + (8.0 * omega1_2 * omega2 * delta22 * delta23 + 4.0 * omega1 * omega2_2 * delta22 * delta23
        - 4.0 * omega2 * alpha22 * delta23) * over_27 / omega1 + (36.0 * omega1_6 * delta21 * delta22
        + 120.0 * omega1_5 * omega2 * delta21 * delta22 + 96.0 * omega1_4 * omega2_2 * delta21 * delta22
        - 12.0 * omega1_4 * alpha21 * delta22 - 36.0 * omega1_4 * alpha22 * delta21
        + 24.0 * omega1_3 * omega2_3 * delta21 * delta22 - 28.0 * omega1_3 * omega2 * alpha21 * delta22
        - 48.0 * omega1_3 * omega2 * alpha22 * delta21 - 16.0 * omega1_2 * omega2_2 * alpha21 * delta22
        - 18.0 * omega1_2 * omega2_2 * alpha22 * delta21 + 12.0 * omega1_2 * alpha21 * alpha22
        - 4.0 * omega1 * omega2_3 * alpha21 * delta22 + 4.0 * omega1 * omega2 * alpha21 * alpha22
        + 2.0 * omega2_2 * alpha21 * alpha22) * over_28 / (3.0 * omega1_2 * omega2)
        + (4.0 * omega1_3 * omega2 * delta22 * delta23 + 4.0 * omega1 * omega2 * alpha22 * delta23) * over_29
        + (-30.0 * omega1_4 * alpha23 * delta22 - 12.0 * omega1_3 * omega2 * alpha23 * delta22
        + 8.0 * omega1_2 * omega2_2 * alpha23 * delta22 + 18.0 * omega1_2 * alpha22 * alpha23
        + 4.0 * omega1 * omega2_3 * alpha23 * delta22 + 4.0 * omega1 * omega2 * alpha22 * alpha23
        - 4.0 * omega2_2 * alpha22 * alpha23) * over_30 / omega1;
  }
  /// harmonic_re_v2_A_v2_conjA_v1 = (2*omega1*omega2*delta23 - 2*omega2^2*delta23 + 2*alpha23)/(omega1*(omega1 -
  /// 2*omega2))
  double lump_harmonic_re_v2_A_v2_conjA_v1() const {
    return (2.0 * omega1 * omega2 * delta23 - 2.0 * omega2_2 * delta23 + 2.0 * alpha23) * per_3 / omega1;
  }
  double lump_eta22() const { return eta22; }
  /// harmonic_im_v2_A_v2_conjA_v1 = (-2*omega1^3*delta22*mu21 + 4*omega1^2*omega2*delta22*mu21 -
  /// 2*omega1*omega2^2*delta22*mu21 + 2*omega1*alpha22*mu21 - 2*omega2*alpha22*mu21)/(omega1*omega2*(omega1 -
  /// 2*omega2)*(2*omega1 - omega2)) + (2*omega1^3*mu21*delta24 - 2*omega1^2*omega2*mu21*delta24 +
  /// 2*omega1*omega2^2*mu12*delta22 + 2*omega1*omega2^2*mu21*delta24 - 2*omega1*mu21*alpha24 -
  /// 2*omega2*mu12*alpha22)/(omega1*(omega1 + omega2)*(omega1 - omega2)*(omega1 - 2*omega2))
  double lump_harmonic_im_v2_A_v2_conjA_v1() const {
    return (-2.0 * omega1_3 * delta22 * mu21 + 4.0 * omega1_2 * omega2 * delta22 * mu21
        - 2.0 * omega1 * omega2_2 * delta22 * mu21 + 2.0 * omega1 * alpha22 * mu21
        - 2.0 * omega2 * alpha22 * mu21) * over_3 / (omega1 * omega2) + (2.0 * omega1_3 * mu21 * delta24
        - 2.0 * omega1_2 * omega2 * mu21 * delta24 + 2.0 * omega1 * omega2_2 * mu12 * delta22
        + 2.0 * omega1 * omega2_2 * mu21 * delta24 - 2.0 * omega1 * mu21 * alpha24
        - 2.0 * omega2 * mu12 * alpha22) * over_10 / omega1;
  }
  /// harmonic_re_v2_A_v2_conjA_v2 = (2*omega2^2*delta24 - 2*alpha24)/omega2^2
  double lump_harmonic_re_v2_A_v2_conjA_v2() const {
    return (2.0 * omega2_2 * delta24 - 2.0 * alpha24) / omega2_2;
  }
  /// harmonic_re_v2_A_v1_conjA_v1 = (2*omega1^2*delta22 - 2*alpha22)/omega2^2
  double lump_harmonic_re_v2_A_v1_conjA_v1() const {
    return (2.0 * omega1_2 * delta22 - 2.0 * alpha22) / omega2_2;
  }
  double lump_harmonic_im_v2_conjA_v1_F() const { return -omega1 * mu21 * eta22 * over_0 / (2.0 * omega2_2); }
  /// harmonic_re_v2_A_v1_A_v2 = (-2*omega1*omega2*delta23 - 2*omega2^2*delta23 + 2*alpha23)/(omega1*(omega1 +
  /// 2*omega2))
  double lump_harmonic_re_v2_A_v1_A_v2() const {
    return (-2.0 * omega1 * omega2 * delta23 - 2.0 * omega2_2 * delta23 + 2.0 * alpha23) * per_2 / omega1;
  }
  /// harmonic_im_v2_A_v1_A_v2 = (-2*omega1^3*delta22*mu21 - 4*omega1^2*omega2*delta22*mu21 -
  /// 2*omega1*omega2^2*delta22*mu21 + 2*omega1*alpha22*mu21 + 2*omega2*alpha22*mu21)/(omega1*omega2*(omega1 +
  /// 2*omega2)*(2*omega1 + omega2)) + (-2*omega1^3*mu21*delta24 - 2*omega1^2*omega2*mu21*delta24 -
  /// 2*omega1*omega2^2*mu12*delta22 - 2*omega1*omega2^2*mu21*delta24 + 2*omega1*mu21*alpha24 -
  /// 2*omega2*mu12*alpha22)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2))
  double lump_harmonic_im_v2_A_v1_A_v2() const {
    return (-2.0 * omega1_3 * delta22 * mu21 - 4.0 * omega1_2 * omega2 * delta22 * mu21
        - 2.0 * omega1 * omega2_2 * delta22 * mu21 + 2.0 * omega1 * alpha22 * mu21
        + 2.0 * omega2 * alpha22 * mu21) * over_12 / (omega1 * omega2) + (-2.0 * omega1_3 * mu21 * delta24
        - 2.0 * omega1_2 * omega2 * mu21 * delta24 - 2.0 * omega1 * omega2_2 * mu12 * delta22
        - 2.0 * omega1 * omega2_2 * mu21 * delta24 + 2.0 * omega1 * mu21 * alpha24
        - 2.0 * omega2 * mu12 * alpha22) * over_6 / omega1;
  }
  double lump_harmonic_re_v2_A_v22() const { return (-3.0 * omega2_2 * delta24 + alpha24) / (3.0 * omega2_2); }
  /// harmonic_im_v2_A_v22 = (4*omega2^2*mu12*delta23 - 2*mu12*alpha23)/(3*omega2*(omega1 + omega2)*(omega1 -
  /// omega2)) + (-2*omega2^2*delta23*mu21 - 2*alpha23*mu21)/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))
  double lump_harmonic_im_v2_A_v22() const {
    return (4.0 * omega2_2 * mu12 * delta23 - 2.0 * mu12 * alpha23) * over_0 / (3.0 * omega2)
        + (-2.0 * omega2_2 * delta23 * mu21 - 2.0 * alpha23 * mu21) * over_1 / (3.0 * omega2);
  }
  double lump_mu21() const { return mu21; }
  double lump_eta21() const { return eta21; }
  /// harmonic_re_v2_A_v2_conjA_v2_F = (omega1^2*omega2^2*delta24*eta22 + omega1^2*alpha24*eta22 +
  /// 2*omega2^4*delta24*eta22 - 6*omega2^2*alpha24*eta22)/(omega2^2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1
  /// - omega2)*(omega1 - 2*omega2))
  double lump_harmonic_re_v2_A_v2_conjA_v2_F() const {
    return (omega1_2 * omega2_2 * delta24 * eta22 + omega1_2 * alpha24 * eta22 + 2.0 * omega2_4 * delta24 * eta22
        - 6.0 * omega2_2 * alpha24 * eta22) * over_7 / omega2_2;
  }
  /// harmonic_re_v2_A_v1_conjA_v1_F = (-3*omega1^4*delta22*eta22 + 2*omega1^2*omega2^2*delta22*eta12 +
  /// 3*omega1^2*alpha22*eta22 + 2*omega2^2*alpha22*eta12)/(3*omega1^2*omega2^2*(omega1 + omega2)*(omega1 -
  /// omega2))
  double lump_harmonic_re_v2_A_v1_conjA_v1_F() const {
    return (-3.0 * omega1_4 * delta22 * eta22 + 2.0 * omega1_2 * omega2_2 * delta22 * eta12
        + 3.0 * omega1_2 * alpha22 * eta22
        + 2.0 * omega2_2 * alpha22 * eta12) * over_0 / (3.0 * omega1_2 * omega2_2);
  }
  /// harmonic_re_v2_A_v1_A_v2_conjA_v2 = (-2*omega2^2*delta35 + 6*alpha34)/((omega1 + omega2)*(omega1 - omega2)) +
  /// (-4*omega1^2*omega2^2*alpha23*delta24 - 4*omega1^2*alpha23*alpha24 - 24*omega2^6*delta23*delta24 -
  /// 8*omega2^4*alpha23*delta24 + 8*omega2^4*delta23*alpha24 + 24*omega2^2*alpha23*alpha24)/(omega2^2*(omega1 +
  /// omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) + (-16*omega1^6*delta22*delta23 +
  /// 8*omega1^4*omega2^2*delta22*delta23 + 16*omega1^4*alpha22*delta23 - 8*omega1^4*alpha23*delta22 +
  /// 16*omega1^2*omega2^2*alpha22*delta23 - 24*omega1^2*alpha22*alpha23 - 4*omega2^4*alpha22*delta23 +
  /// 4*omega2^2*alpha22*alpha23)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 -
  /// omega2))
  double lump_harmonic_re_v2_A_v1_A_v2_conjA_v2() const {
    return (-2.0 * omega2_2 * delta35 + 6.0 * alpha34) * over_0 + (-4.0 * omega1_2 * omega2_2 * alpha23 * delta24
        - 4.0 * omega1_2 * alpha23 * alpha24 - 24.0 * omega2_6 * delta23 * delta24
        - 8.0 * omega2_4 * alpha23 * delta24 + 8.0 * omega2_4 * delta23 * alpha24
        + 24.0 * omega2_2 * alpha23 * alpha24) * over_7 / omega2_2 + (-16.0 * omega1_6 * delta22 * delta23
        + 8.0 * omega1_4 * omega2_2 * delta22 * delta23 + 16.0 * omega1_4 * alpha22 * delta23
        - 8.0 * omega1_4 * alpha23 * delta22 + 16.0 * omega1_2 * omega2_2 * alpha22 * delta23
        - 24.0 * omega1_2 * alpha22 * alpha23 - 4.0 * omega2_4 * alpha22 * delta23
        + 4.0 * omega2_2 * alpha22 * alpha23) * over_8 / omega1_2;
  }
  /// harmonic_re_v2_A_v12_conjA_v1 = (12*omega1^4*delta21*delta22 - 3*omega1^4*delta32 -
  /// 4*omega1^2*alpha21*delta22 + 6*omega1^2*alpha22*delta21 + 9*omega1^2*alpha32 -
  /// 10*alpha21*alpha22)/(3*omega1^2*(omega1 + omega2)*(omega1 - omega2)) + (-4*omega1^4*omega2^2*delta22*delta23
  /// + 16*omega1^4*alpha23*delta22 - 4*omega1^2*omega2^2*alpha22*delta23 - 2*omega1^2*omega2^2*alpha23*delta22 -
  /// 16*omega1^2*alpha22*alpha23 + 6*omega2^2*alpha22*alpha23)/(omega2^2*(omega1 + omega2)*(omega1 -
  /// omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))
  double lump_harmonic_re_v2_A_v12_conjA_v1() const {
    return (12.0 * omega1_4 * delta21 * delta22 - 3.0 * omega1_4 * delta32 - 4.0 * omega1_2 * alpha21 * delta22
        + 6.0 * omega1_2 * alpha22 * delta21 + 9.0 * omega1_2 * alpha32
        - 10.0 * alpha21 * alpha22) * over_0 / (3.0 * omega1_2) + (-4.0 * omega1_4 * omega2_2 * delta22 * delta23
        + 16.0 * omega1_4 * alpha23 * delta22 - 4.0 * omega1_2 * omega2_2 * alpha22 * delta23
        - 2.0 * omega1_2 * omega2_2 * alpha23 * delta22 - 16.0 * omega1_2 * alpha22 * alpha23
        + 6.0 * omega2_2 * alpha22 * alpha23) * over_8 / omega2_2;
  }
  /// harmonic_re_v2_A_v12_F = alpha22*eta12/(omega1^2*(omega1 + omega2)*(omega1 - omega2)) +
  /// (-omega1^2*delta22*eta22 - alpha22*eta22)/(2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 +
  /// omega2)*(2*omega1 - omega2))
  double lump_harmonic_re_v2_A_v12_F() const {
    return alpha22 * eta12 * over_0 / omega1_2 + (-omega1_2 * delta22 * eta22 - alpha22 * eta22) * over_8 / 2.0;
  }
  double lump_harmonic_re_v2_A_v12() const { return (omega1_2 * delta22 + alpha22) * over_2; }
  /// harmonic_im_v2_A_v1_F = -eta12*mu21/(3*omega1*(2*omega1 + omega2)*(2*omega1 - omega2)) -
  /// omega1*mu21*eta22/(2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))
  double lump_harmonic_im_v2_A_v1_F() const {
    return -eta12 * mu21 * over_2 / (3.0 * omega1) - omega1 * mu21 * eta22 * over_8 / 2.0;
  }
  /// harmonic_im_v2_A_v12 = (-6*omega1^2*delta21*mu21 + 2*alpha21*mu21)/(3*omega1*(2*omega1 + omega2)*(2*omega1 -
  /// omega2)) + (-4*omega1^3*delta23*mu21 + 2*omega1*alpha23*mu21)/((omega1 + omega2)*(omega1 - omega2)*(2*omega1
  /// + omega2)*(2*omega1 - omega2))
  double lump_harmonic_im_v2_A_v12() const {
    return (-6.0 * omega1_2 * delta21 * mu21 + 2.0 * alpha21 * mu21) * over_2 / (3.0 * omega1)
        + (-4.0 * omega1_3 * delta23 * mu21 + 2.0 * omega1 * alpha23 * mu21) * over_8;
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
  double lump_harmonic_re_v2_A_v2_conjA_v12() const {
    return (3.0 * omega1_4 * delta33 - 12.0 * omega1_3 * omega2 * delta21 * delta23
        + 6.0 * omega1_3 * omega2 * delta34 + 6.0 * omega1_2 * omega2_2 * delta21 * delta23
        - 3.0 * omega1_2 * omega2_2 * delta34 - 6.0 * omega1_2 * alpha23 * delta21 + 3.0 * omega1_2 * alpha33
        + 4.0 * omega1 * omega2 * alpha21 * delta23 - 2.0 * omega2_2 * alpha21 * delta23
        + 2.0 * alpha21 * alpha23) * per_1 / (12.0 * omega1_3) + (-2.0 * omega1_2 * omega2 * delta23_2
        + 3.0 * omega1 * omega2_2 * delta23_2 - 2.0 * omega1 * alpha23 * delta23 - omega2_3 * delta23_2
        + 2.0 * omega2 * alpha23 * delta23) * per_3 / omega1_2 + (omega1_2 * delta22_2
        - omega1 * omega2 * delta22_2) * per_5 / omega2 + alpha23_2 * over_18 / omega1_2
        - alpha22_2 * over_19 / (omega1 * omega2) + (-4.0 * omega1_4 * delta22 * delta24
        + 2.0 * omega1_3 * omega2 * delta22 * delta24 - omega1_2 * omega2_2 * delta22 * delta24
        - 4.0 * omega1_2 * alpha22 * delta24 + omega1_2 * delta22 * alpha24
        + 2.0 * omega1 * omega2 * alpha22 * delta24 - omega2_2 * alpha22 * delta24
        + alpha22 * alpha24) * over_31 / (2.0 * omega1);
  }
  /// harmonic_re_v2_A_v2_conjA_v1_F = (-2*omega1*omega2*delta23*eta12 + omega2^2*delta23*eta12 -
  /// alpha23*eta12)/(12*omega1^3*(omega1 - omega2)) + (omega1*delta23*eta22 -
  /// omega2*delta23*eta22)/(2*omega1^2*(omega1 - 2*omega2)) - alpha23*eta22/(2*omega1^2*(omega1 - omega2)*(omega1
  /// - 2*omega2))
  double lump_harmonic_re_v2_A_v2_conjA_v1_F() const {
    return (-2.0 * omega1 * omega2 * delta23 * eta12 + omega2_2 * delta23 * eta12
        - alpha23 * eta12) * per_1 / (12.0 * omega1_3) + (omega1 * delta23 * eta22
        - omega2 * delta23 * eta22) * per_3 / (2.0 * omega1_2) - alpha23 * eta22 * over_18 / (2.0 * omega1_2);
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
  double lump_harmonic_re_v2_A_v22_conjA_v1() const {
    return (2.0 * omega1 * omega2 * delta35 - 3.0 * omega2_2 * delta35 + 3.0 * alpha34) * over_32
        + (4.0 * omega1_2 * omega2 * delta22 * delta23 - 8.0 * omega1 * omega2_2 * delta22 * delta23
        + 4.0 * omega1 * alpha23 * delta22) * over_33 / omega2 + (-24.0 * omega1_3 * omega2_3 * delta23 * delta24
        + 4.0 * omega1_3 * omega2 * delta23 * alpha24 + 96.0 * omega1_2 * omega2_4 * delta23 * delta24
        - 18.0 * omega1_2 * omega2_2 * alpha23 * delta24 - 16.0 * omega1_2 * omega2_2 * delta23 * alpha24
        + 2.0 * omega1_2 * alpha23 * alpha24 - 120.0 * omega1 * omega2_5 * delta23 * delta24
        + 48.0 * omega1 * omega2_3 * alpha23 * delta24 + 28.0 * omega1 * omega2_3 * delta23 * alpha24
        - 4.0 * omega1 * omega2 * alpha23 * alpha24 + 36.0 * omega2_6 * delta23 * delta24
        - 36.0 * omega2_4 * alpha23 * delta24 - 12.0 * omega2_4 * delta23 * alpha24
        + 12.0 * omega2_2 * alpha23 * alpha24) * over_34 / (3.0 * omega1 * omega2_2)
        + (4.0 * omega1 * omega2_3 * delta22 * delta23 + 4.0 * omega1 * omega2 * alpha23 * delta22) * over_35
        + (-4.0 * omega1_3 * omega2 * alpha22 * delta23 + 8.0 * omega1_2 * omega2_2 * alpha22 * delta23
        - 4.0 * omega1_2 * alpha22 * alpha23 + 12.0 * omega1 * omega2_3 * alpha22 * delta23
        - 4.0 * omega1 * omega2 * alpha22 * alpha23 - 30.0 * omega2_4 * alpha22 * delta23
        + 18.0 * omega2_2 * alpha22 * alpha23) * over_36 / omega2;
  }
  /// harmonic_re_v2_A_v22_F = (9*omega1^2*omega2^2*delta24*eta22 - omega1^2*alpha24*eta22 -
  /// 24*omega1*omega2^3*delta24*eta22 + 2*omega1*omega2*alpha24*eta22 + 18*omega2^4*delta24*eta22 -
  /// 6*omega2^2*alpha24*eta22)/(6*omega1*omega2^2*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))
  double lump_harmonic_re_v2_A_v22_F() const {
    return (9.0 * omega1_2 * omega2_2 * delta24 * eta22 - omega1_2 * alpha24 * eta22
        - 24.0 * omega1 * omega2_3 * delta24 * eta22 + 2.0 * omega1 * omega2 * alpha24 * eta22
        + 18.0 * omega2_4 * delta24 * eta22
        - 6.0 * omega2_2 * alpha24 * eta22) * over_34 / (6.0 * omega1 * omega2_2);
  }
  /// harmonic_re_v2_A_v1_A_v2_F = (2*omega1*omega2*delta23*eta12 + omega2^2*delta23*eta12 -
  /// alpha23*eta12)/(12*omega1^3*(omega1 + omega2)) + (omega1*delta23*eta22 +
  /// omega2*delta23*eta22)/(2*omega1^2*(omega1 + 2*omega2)) - alpha23*eta22/(2*omega1^2*(omega1 + omega2)*(omega1
  /// + 2*omega2))
  double lump_harmonic_re_v2_A_v1_A_v2_F() const {
    return (2.0 * omega1 * omega2 * delta23 * eta12 + omega2_2 * delta23 * eta12
        - alpha23 * eta12) * per_0 / (12.0 * omega1_3) + (omega1 * delta23 * eta22
        + omega2 * delta23 * eta22) * per_2 / (2.0 * omega1_2) - alpha23 * eta22 * over_21 / (2.0 * omega1_2);
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
  double lump_harmonic_re_v2_A_v12_A_v2() const {
    return (3.0 * omega1_4 * delta33 + 12.0 * omega1_3 * omega2 * delta21 * delta23
        - 6.0 * omega1_3 * omega2 * delta34 + 6.0 * omega1_2 * omega2_2 * delta21 * delta23
        - 3.0 * omega1_2 * omega2_2 * delta34 - 6.0 * omega1_2 * alpha23 * delta21 + 3.0 * omega1_2 * alpha33
        - 4.0 * omega1 * omega2 * alpha21 * delta23 - 2.0 * omega2_2 * alpha21 * delta23
        + 2.0 * alpha21 * alpha23) * per_0 / (12.0 * omega1_3) + (2.0 * omega1_2 * omega2 * delta23_2
        + 3.0 * omega1 * omega2_2 * delta23_2 - 2.0 * omega1 * alpha23 * delta23 + omega2_3 * delta23_2
        - 2.0 * omega2 * alpha23 * delta23) * per_2 / omega1_2 + (-omega1_2 * delta22_2
        - omega1 * omega2 * delta22_2) * per_4 / omega2 + alpha23_2 * over_21 / omega1_2
        + alpha22_2 * over_22 / (omega1 * omega2) + (-4.0 * omega1_4 * delta22 * delta24
        - 2.0 * omega1_3 * omega2 * delta22 * delta24 - omega1_2 * omega2_2 * delta22 * delta24
        - 4.0 * omega1_2 * alpha22 * delta24 + omega1_2 * delta22 * alpha24
        - 2.0 * omega1 * omega2 * alpha22 * delta24 - omega2_2 * alpha22 * delta24
        + alpha22 * alpha24) * over_37 / (2.0 * omega1);
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
  double lump_harmonic_re_v2_A_v1_A_v22() const {
    return (-2.0 * omega1 * omega2 * delta35 - 3.0 * omega2_2 * delta35 + 3.0 * alpha34) * over_38
        + (4.0 * omega1_2 * omega2 * delta22 * delta23 + 8.0 * omega1 * omega2_2 * delta22 * delta23
        - 4.0 * omega1 * alpha23 * delta22) * over_39 / omega2 + (24.0 * omega1_3 * omega2_3 * delta23 * delta24
        - 4.0 * omega1_3 * omega2 * delta23 * alpha24 + 96.0 * omega1_2 * omega2_4 * delta23 * delta24
        - 18.0 * omega1_2 * omega2_2 * alpha23 * delta24 - 16.0 * omega1_2 * omega2_2 * delta23 * alpha24
        + 2.0 * omega1_2 * alpha23 * alpha24 + 120.0 * omega1 * omega2_5 * delta23 * delta24
        - 48.0 * omega1 * omega2_3 * alpha23 * delta24 - 28.0 * omega1 * omega2_3 * delta23 * alpha24
        + 4.0 * omega1 * omega2 * alpha23 * alpha24 + 36.0 * omega2_6 * delta23 * delta24
        - 36.0 * omega2_4 * alpha23 * delta24 - 12.0 * omega2_4 * delta23 * alpha24
        + 12.0 * omega2_2 * alpha23 * alpha24) * over_40 / (3.0 * omega1 * omega2_2)
        + (-4.0 * omega1 * omega2_3 * delta22 * delta23 - 4.0 * omega1 * omega2 * alpha23 * delta22) * over_41
        + (-4.0 * omega1_3 * omega2 * alpha22 * delta23 - 8.0 * omega1_2 * omega2_2 * alpha22 * delta23
        + 4.0 * omega1_2 * alpha22 * alpha23 + 12.0 * omega1 * omega2_3 * alpha22 * delta23
        - 4.0 * omega1 * omega2 * alpha22 * alpha23 + 30.0 * omega2_4 * alpha22 * delta23
        - 18.0 * omega2_2 * alpha22 * alpha23) * over_42 / omega2;
  }
  /// harmonic_re_v2_A_v23 = (42*omega2^4*delta24^2 - 6*omega2^4*delta36 - 20*omega2^2*alpha24*delta24 +
  /// 3*omega2^2*alpha35 + 2*alpha24^2)/(24*omega2^4) + (3*omega2^4*delta23^2 + 2*omega2^2*alpha23*delta23 -
  /// alpha23^2)/(4*omega2^2*(omega1 + 2*omega2)*(omega1 - 2*omega2))
  double lump_harmonic_re_v2_A_v23() const {
    return (42.0 * omega2_4 * delta24_2 - 6.0 * omega2_4 * delta36 - 20.0 * omega2_2 * alpha24 * delta24
        + 3.0 * omega2_2 * alpha35 + 2.0 * alpha24_2) / (24.0 * omega2_4) + (3.0 * omega2_4 * delta23_2
        + 2.0 * omega2_2 * alpha23 * delta23 - alpha23_2) * over_1 / (4.0 * omega2_2);
  }
  /// harmonic_re_v2_A_v13 = (-12*omega1^4*delta21*delta22 + 3*omega1^4*delta32 + 4*omega1^2*alpha21*delta22 -
  /// 6*omega1^2*alpha22*delta21 + 3*omega1^2*alpha32 + 2*alpha21*alpha22)/(3*omega1^2*(3*omega1 +
  /// omega2)*(3*omega1 - omega2)) + (-12*omega1^4*delta22*delta23 - 12*omega1^2*alpha22*delta23 +
  /// 2*omega1^2*alpha23*delta22 + 2*alpha22*alpha23)/((2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 +
  /// omega2)*(3*omega1 - omega2))
  double lump_harmonic_re_v2_A_v13() const {
    return (-12.0 * omega1_4 * delta21 * delta22 + 3.0 * omega1_4 * delta32 + 4.0 * omega1_2 * alpha21 * delta22
        - 6.0 * omega1_2 * alpha22 * delta21 + 3.0 * omega1_2 * alpha32
        + 2.0 * alpha21 * alpha22) * over_43 / (3.0 * omega1_2) + (-12.0 * omega1_4 * delta22 * delta23
        - 12.0 * omega1_2 * alpha22 * delta23 + 2.0 * omega1_2 * alpha23 * delta22
        + 2.0 * alpha22 * alpha23) * over_44;
  }
  /// conservative_v1_A_v1_A_v2_F = (-omega1^2*delta22*eta22 + alpha22*eta22)/(2*omega1*omega2^2) +
  /// (omega1^2*delta22*eta12 + alpha22*eta12)/(omega1*(2*omega1 + omega2)*(2*omega1 - omega2))
  double lump_conservative_v1_A_v1_A_v2_F() const {
    return (-omega1_2 * delta22 * eta22 + alpha22 * eta22) / (2.0 * omega1 * omega2_2) + (omega1_2 * delta22 * eta12
        + alpha22 * eta12) * over_2 / omega1;
  }
  double lump_conservative_v1_A_v1_F2_of_primary_2() const { return -eta12_2 * over_2 / (4.0 * omega1); }
  /// conservative_v2_A_v22_F = (-3*omega2^2*delta24*eta22 + 5*alpha24*eta22)/(12*omega2^3)
  double lump_conservative_v2_A_v22_F() const {
    return (-3.0 * omega2_2 * delta24 * eta22 + 5.0 * alpha24 * eta22) / (12.0 * omega2_3);
  }
  double lump_conservative_v2_A_v2_F2_of_primary_2() const { return -eta22_2 / (12.0 * omega2_3); }
  double lump_harmonic_im_v1_conjA_v2_F() const { return omega2 * mu12 * eta12 * over_0 / (2.0 * omega1_2); }
  /// harmonic_re_v1_A_v2_conjA_v2_F = (-2*omega1^2*omega2^2*delta23*eta22 - 2*omega1^2*alpha23*eta22 +
  /// 3*omega2^4*delta23*eta12 - 3*omega2^2*alpha23*eta12)/(3*omega1^2*omega2^2*(omega1 + omega2)*(omega1 -
  /// omega2))
  double lump_harmonic_re_v1_A_v2_conjA_v2_F() const {
    return (-2.0 * omega1_2 * omega2_2 * delta23 * eta22 - 2.0 * omega1_2 * alpha23 * eta22
        + 3.0 * omega2_4 * delta23 * eta12
        - 3.0 * omega2_2 * alpha23 * eta12) * over_0 / (3.0 * omega1_2 * omega2_2);
  }
  /// harmonic_re_v1_A_v1_conjA_v1_F = (2*omega1^4*delta21*eta12 + omega1^2*omega2^2*delta21*eta12 -
  /// 6*omega1^2*alpha21*eta12 + omega2^2*alpha21*eta12)/(omega1^2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 +
  /// omega2)*(2*omega1 - omega2))
  double lump_harmonic_re_v1_A_v1_conjA_v1_F() const {
    return (2.0 * omega1_4 * delta21 * eta12 + omega1_2 * omega2_2 * delta21 * eta12
        - 6.0 * omega1_2 * alpha21 * eta12 + omega2_2 * alpha21 * eta12) * over_8 / omega1_2;
  }
  /// harmonic_re_v1_A_v22_F = -alpha23*eta22/(omega2^2*(omega1 + omega2)*(omega1 - omega2)) +
  /// (-omega2^2*delta23*eta12 - alpha23*eta12)/(2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1
  /// - 2*omega2))
  double lump_harmonic_re_v1_A_v22_F_of_primary_2() const {
    return -alpha23 * eta22 * over_0 / omega2_2 + (-omega2_2 * delta23 * eta12 - alpha23 * eta12) * over_7 / 2.0;
  }
  /// harmonic_im_v1_A_v2_F = mu12*eta22/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2)) -
  /// omega2*mu12*eta12/(2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2))
  double lump_harmonic_im_v1_A_v2_F_of_primary_2() const {
    return mu12 * eta22 * over_1 / (3.0 * omega2) - omega2 * mu12 * eta12 * over_7 / 2.0;
  }
  /// harmonic_re_v1_conjA_v12_F = (-18*omega1^4*delta21*eta12 + 24*omega1^3*omega2*delta21*eta12 -
  /// 9*omega1^2*omega2^2*delta21*eta12 + 6*omega1^2*alpha21*eta12 - 2*omega1*omega2*alpha21*eta12 +
  /// omega2^2*alpha21*eta12)/(6*omega1^2*omega2*(omega1 - omega2)*(2*omega1 - omega2)*(3*omega1 - omega2))
  double lump_harmonic_re_v1_conjA_v12_F() const {
    return (-18.0 * omega1_4 * delta21 * eta12 + 24.0 * omega1_3 * omega2 * delta21 * eta12
        - 9.0 * omega1_2 * omega2_2 * delta21 * eta12 + 6.0 * omega1_2 * alpha21 * eta12
        - 2.0 * omega1 * omega2 * alpha21 * eta12
        + omega2_2 * alpha21 * eta12) * over_15 / (6.0 * omega1_2 * omega2);
  }
  /// harmonic_re_v1_A_v2_conjA_v1_F = (-omega1^2*delta22*eta22 + 2*omega1*omega2*delta22*eta22 +
  /// alpha22*eta22)/(12*omega2^3*(omega1 - omega2)) + (omega1*delta22*eta12 -
  /// omega2*delta22*eta12)/(2*omega2^2*(2*omega1 - omega2)) - alpha22*eta12/(2*omega2^2*(omega1 -
  /// omega2)*(2*omega1 - omega2))
  double lump_harmonic_re_v1_A_v2_conjA_v1_F_of_primary_2() const {
    return (-omega1_2 * delta22 * eta22 + 2.0 * omega1 * omega2 * delta22 * eta22
        + alpha22 * eta22) * per_1 / (12.0 * omega2_3) + (omega1 * delta22 * eta12
        - omega2 * delta22 * eta12) * per_5 / (2.0 * omega2_2) - alpha22 * eta12 * over_19 / (2.0 * omega2_2);
  }
  /// harmonic_re_v1_A_v1_A_v2_F = (omega1^2*delta22*eta22 + 2*omega1*omega2*delta22*eta22 -
  /// alpha22*eta22)/(12*omega2^3*(omega1 + omega2)) + (omega1*delta22*eta12 +
  /// omega2*delta22*eta12)/(2*omega2^2*(2*omega1 + omega2)) - alpha22*eta12/(2*omega2^2*(omega1 +
  /// omega2)*(2*omega1 + omega2))
  double lump_harmonic_re_v1_A_v1_A_v2_F_of_primary_2() const {
    return (omega1_2 * delta22 * eta22 + 2.0 * omega1 * omega2 * delta22 * eta22
        - alpha22 * eta22) * per_0 / (12.0 * omega2_3) + (omega1 * delta22 * eta12
        + omega2 * delta22 * eta12) * per_4 / (2.0 * omega2_2) - alpha22 * eta12 * over_22 / (2.0 * omega2_2);
  }
  /// harmonic_re_v1_A_v12_F = (18*omega1^4*delta21*eta12 + 24*omega1^3*omega2*delta21*eta12 +
  /// 9*omega1^2*omega2^2*delta21*eta12 - 6*omega1^2*alpha21*eta12 - 2*omega1*omega2*alpha21*eta12 -
  /// omega2^2*alpha21*eta12)/(6*omega1^2*omega2*(omega1 + omega2)*(2*omega1 + omega2)*(3*omega1 + omega2))
  double lump_harmonic_re_v1_A_v12_F_of_primary_2() const {
    return (18.0 * omega1_4 * delta21 * eta12 + 24.0 * omega1_3 * omega2 * delta21 * eta12
        + 9.0 * omega1_2 * omega2_2 * delta21 * eta12 - 6.0 * omega1_2 * alpha21 * eta12
        - 2.0 * omega1 * omega2 * alpha21 * eta12
        - omega2_2 * alpha21 * eta12) * over_28 / (6.0 * omega1_2 * omega2);
  }
  /// harmonic_im_v2_conjA_v1_F = (-omega1*eta12*mu21 + omega2*eta12*mu21)/(2*omega1*omega2*(omega1 -
  /// 2*omega2)*(2*omega1 - omega2)) + mu21*eta22/(2*(omega1 + omega2)*(omega1 - omega2)*(omega1 - 2*omega2))
  double lump_harmonic_im_v2_conjA_v1_F_of_primary_2() const {
    return (-omega1 * eta12 * mu21 + omega2 * eta12 * mu21) * over_3 / (2.0 * omega1 * omega2)
        + mu21 * eta22 * over_10 / 2.0;
  }
  /// harmonic_re_v2_A_v1_conjA_v2_F = -omega2*delta23*eta22/(omega1*(omega1 + omega2)*(omega1 - 2*omega2)) +
  /// (omega1^2*alpha23*eta22 - 2*omega1*omega2*alpha23*eta22 - omega2^2*alpha23*eta22)/(omega1*omega2^2*(omega1 +
  /// omega2)*(omega1 - omega2)*(omega1 - 2*omega2)) + (-omega1*omega2*delta23*eta12 -
  /// alpha23*eta12)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2))
  double lump_harmonic_re_v2_A_v1_conjA_v2_F() const {
    return -omega2 * delta23 * eta22 * over_45 / omega1 + (omega1_2 * alpha23 * eta22
        - 2.0 * omega1 * omega2 * alpha23 * eta22 - omega2_2 * alpha23 * eta22) * over_10 / (omega1 * omega2_2)
        + (-omega1 * omega2 * delta23 * eta12 - alpha23 * eta12) * over_11 / omega2;
  }
  /// harmonic_re_v2_A_v1_A_v2_F = omega2*delta23*eta22/(omega1*(omega1 + 2*omega2)*(omega1 - omega2)) +
  /// (omega1^2*alpha23*eta22 + 2*omega1*omega2*alpha23*eta22 - omega2^2*alpha23*eta22)/(omega1*omega2^2*(omega1 +
  /// omega2)*(omega1 + 2*omega2)*(omega1 - omega2)) + (-omega1*omega2*delta23*eta12 +
  /// alpha23*eta12)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 - omega2))
  double lump_harmonic_re_v2_A_v1_A_v2_F_of_primary_2() const {
    return omega2 * delta23 * eta22 * over_46 / omega1 + (omega1_2 * alpha23 * eta22
        + 2.0 * omega1 * omega2 * alpha23 * eta22 - omega2_2 * alpha23 * eta22) * over_6 / (omega1 * omega2_2)
        + (-omega1 * omega2 * delta23 * eta12 + alpha23 * eta12) * over_4 / omega2;
  }
  /// harmonic_im_v2_A_v1_F = (-omega1*eta12*mu21 - omega2*eta12*mu21)/(2*omega1*omega2*(omega1 +
  /// 2*omega2)*(2*omega1 + omega2)) - mu21*eta22/(2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2))
  double lump_harmonic_im_v2_A_v1_F_of_primary_2() const {
    return (-omega1 * eta12 * mu21 - omega2 * eta12 * mu21) * over_12 / (2.0 * omega1 * omega2)
        - mu21 * eta22 * over_6 / 2.0;
  }
  /// harmonic_re_v2_conjA_v12_F = delta22*eta12/(4*omega2*(2*omega1 - omega2)) +
  /// alpha22*eta12/(4*omega1*omega2*(omega1 - omega2)*(2*omega1 - omega2)) + (-omega1^2*delta22*eta22 -
  /// alpha22*eta22)/(8*omega1*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))
  double lump_harmonic_re_v2_conjA_v12_F() const {
    return delta22 * eta12 * per_5 / (4.0 * omega2) + alpha22 * eta12 * over_19 / (4.0 * omega1 * omega2)
        + (-omega1_2 * delta22 * eta22 - alpha22 * eta22) * over_31 / (8.0 * omega1);
  }
  /// harmonic_re_v2_A_v2_conjA_v1_F = (-2*omega1^3*omega2*delta23*eta22 + 8*omega1^2*omega2^2*delta23*eta22 -
  /// omega1^2*alpha23*eta22 - 11*omega1*omega2^3*delta23*eta22 + 2*omega1*omega2*alpha23*eta22 +
  /// 3*omega2^4*delta23*eta22 - 3*omega2^2*alpha23*eta22)/(3*omega1*omega2^2*(omega1 - omega2)*(omega1 -
  /// 2*omega2)*(omega1 - 3*omega2)) + (omega1*omega2*delta23*eta12 - 2*omega2^2*delta23*eta12 +
  /// alpha23*eta12)/(omega2*(omega1 - omega2)*(omega1 - 3*omega2)*(2*omega1 - omega2))
  double lump_harmonic_re_v2_A_v2_conjA_v1_F_of_primary_2() const {
    return (-2.0 * omega1_3 * omega2 * delta23 * eta22 + 8.0 * omega1_2 * omega2_2 * delta23 * eta22
        - omega1_2 * alpha23 * eta22 - 11.0 * omega1 * omega2_3 * delta23 * eta22
        + 2.0 * omega1 * omega2 * alpha23 * eta22 + 3.0 * omega2_4 * delta23 * eta22
        - 3.0 * omega2_2 * alpha23 * eta22) * over_34 / (3.0 * omega1 * omega2_2)
        + (omega1 * omega2 * delta23 * eta12 - 2.0 * omega2_2 * delta23 * eta12
        + alpha23 * eta12) * over_47 / omega2;
  }
  /// harmonic_re_v2_A_v22_F = (17*omega2^2*delta24*eta22 - 3*alpha24*eta22)/(48*omega2^4)
  double lump_harmonic_re_v2_A_v22_F_of_primary_2() const {
    return (17.0 * omega2_2 * delta24 * eta22 - 3.0 * alpha24 * eta22) / (48.0 * omega2_4);
  }
  /// harmonic_re_v2_A_v12_F = -delta22*eta12/(4*omega2*(2*omega1 + omega2)) -
  /// alpha22*eta12/(4*omega1*omega2*(omega1 + omega2)*(2*omega1 + omega2)) + (-omega1^2*delta22*eta22 -
  /// alpha22*eta22)/(8*omega1*(omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))
  double lump_harmonic_re_v2_A_v12_F_of_primary_2() const {
    return -delta22 * eta12 * per_4 / (4.0 * omega2) - alpha22 * eta12 * over_22 / (4.0 * omega1 * omega2)
        + (-omega1_2 * delta22 * eta22 - alpha22 * eta22) * over_37 / (8.0 * omega1);
  }
  /// conservative_v1_conjA_v1_F = (6*omega1^2*delta21*eta11 - 3*omega1^2*eta12 - 2*alpha21*eta11)/(12*omega1^3) +
  /// (-omega1^2*delta22*eta21 - alpha22*eta21)/(2*omega1*(2*omega1 + omega2)*(2*omega1 - omega2))
  double lump_conservative_v1_conjA_v1_F() const {
    return (6.0 * omega1_2 * delta21 * eta11 - 3.0 * omega1_2 * eta12 - 2.0 * alpha21 * eta11) / (12.0 * omega1_3)
        + (-omega1_2 * delta22 * eta21 - alpha22 * eta21) * over_2 / (2.0 * omega1);
  }
  double lump_harmonic_im_v1_F() const { return -mu12 * eta21 * over_2 / (3.0 * omega1); }
  /// harmonic_re_v1_A_v2_F = (4*omega1^2*delta22*eta11 - 2*omega1*omega2*delta22*eta11 -
  /// alpha22*eta11)/(3*omega1^2*(omega1 - omega2)*(3*omega1 - omega2)) + (2*omega1*omega2*delta23*eta21 -
  /// alpha23*eta21)/((omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 - omega2))
  double lump_harmonic_re_v1_A_v2_F() const {
    return (4.0 * omega1_2 * delta22 * eta11 - 2.0 * omega1 * omega2 * delta22 * eta11
        - alpha22 * eta11) * over_13 / (3.0 * omega1_2) + (2.0 * omega1 * omega2 * delta23 * eta21
        - alpha23 * eta21) * over_16;
  }
  /// harmonic_re_v1_A_v1_F = (14*omega1^2*delta21*eta11 - 3*omega1^2*eta12 - 2*alpha21*eta11)/(48*omega1^4) +
  /// (3*omega1^2*delta22*eta21 - alpha22*eta21)/(8*omega1^2*(2*omega1 + omega2)*(2*omega1 - omega2))
  double lump_harmonic_re_v1_A_v1_F() const {
    return (14.0 * omega1_2 * delta21 * eta11 - 3.0 * omega1_2 * eta12 - 2.0 * alpha21 * eta11) / (48.0 * omega1_4)
        + (3.0 * omega1_2 * delta22 * eta21 - alpha22 * eta21) * over_2 / (8.0 * omega1_2);
  }
  double lump_harmonic_im_v2_F() const { return -eta11 * mu21 * over_2 / (3.0 * omega1); }
  /// harmonic_re_v2_conjA_v1_F = (2*omega1^2*delta22*eta11 - alpha22*eta11)/(3*omega1^2*(omega1 + omega2)*(omega1
  /// - omega2)) + (2*omega1^2*delta23*eta21 - alpha23*eta21)/((omega1 + omega2)*(omega1 - omega2)*(2*omega1 +
  /// omega2)*(2*omega1 - omega2))
  double lump_harmonic_re_v2_conjA_v1_F() const {
    return (2.0 * omega1_2 * delta22 * eta11 - alpha22 * eta11) * over_0 / (3.0 * omega1_2)
        + (2.0 * omega1_2 * delta23 * eta21 - alpha23 * eta21) * over_8;
  }
  /// harmonic_re_v2_A_v2_F = (-3*omega1^2*eta22 - 4*omega1*omega2*delta23*eta11 + 2*omega2^2*delta23*eta11 -
  /// 2*alpha23*eta11)/(24*omega1^3*(omega1 - omega2)) + (4*omega1^2*delta24*eta21 - 2*omega1*omega2*delta24*eta21
  /// + omega2^2*delta24*eta21 - alpha24*eta21)/(4*omega1*(omega1 - omega2)*(2*omega1 + omega2)*(2*omega1 -
  /// omega2))
  double lump_harmonic_re_v2_A_v2_F() const {
    return (-3.0 * omega1_2 * eta22 - 4.0 * omega1 * omega2 * delta23 * eta11 + 2.0 * omega2_2 * delta23 * eta11
        - 2.0 * alpha23 * eta11) * per_1 / (24.0 * omega1_3) + (4.0 * omega1_2 * delta24 * eta21
        - 2.0 * omega1 * omega2 * delta24 * eta21 + omega2_2 * delta24 * eta21
        - alpha24 * eta21) * over_31 / (4.0 * omega1);
  }
  /// harmonic_re_v2_A_v1_F = (-2*omega1^2*delta22*eta11 - alpha22*eta11)/(3*omega1^2*(3*omega1 + omega2)*(3*omega1
  /// - omega2)) + (6*omega1^2*delta23*eta21 - alpha23*eta21)/((2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 +
  /// omega2)*(3*omega1 - omega2))
  double lump_harmonic_re_v2_A_v1_F() const {
    return (-2.0 * omega1_2 * delta22 * eta11 - alpha22 * eta11) * over_43 / (3.0 * omega1_2)
        + (6.0 * omega1_2 * delta23 * eta21 - alpha23 * eta21) * over_44;
  }
  /// conservative_v2_conjA_v2_F = (6*omega2^2*delta24*eta21 - 3*omega2^2*eta22 - 2*alpha24*eta21)/(12*omega2^3) +
  /// (omega2^2*delta23*eta11 + alpha23*eta11)/(2*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))
  double lump_conservative_v2_conjA_v2_F() const {
    return (6.0 * omega2_2 * delta24 * eta21 - 3.0 * omega2_2 * eta22 - 2.0 * alpha24 * eta21) / (12.0 * omega2_3)
        + (omega2_2 * delta23 * eta11 + alpha23 * eta11) * over_1 / (2.0 * omega2);
  }
  /// harmonic_im_v1_F = mu12*eta21/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))
  double lump_harmonic_im_v1_F_of_principal_parametric_2() const {
    return mu12 * eta21 * over_1 / (3.0 * omega2);
  }
  /// harmonic_re_v1_conjA_v2_F = (-2*omega2^2*delta23*eta21 + alpha23*eta21)/(3*omega2^2*(omega1 + omega2)*(omega1
  /// - omega2)) + (2*omega2^2*delta22*eta11 - alpha22*eta11)/((omega1 + omega2)*(omega1 + 2*omega2)*(omega1 -
  /// omega2)*(omega1 - 2*omega2))
  double lump_harmonic_re_v1_conjA_v2_F() const {
    return (-2.0 * omega2_2 * delta23 * eta21 + alpha23 * eta21) * over_0 / (3.0 * omega2_2)
        + (2.0 * omega2_2 * delta22 * eta11 - alpha22 * eta11) * over_7;
  }
  /// harmonic_re_v1_conjA_v1_F = (-2*omega1^2*delta22*eta21 + 4*omega1*omega2*delta22*eta21 + 3*omega2^2*eta12 +
  /// 2*alpha22*eta21)/(24*omega2^3*(omega1 - omega2)) + (omega1^2*delta21*eta11 - 2*omega1*omega2*delta21*eta11 +
  /// 4*omega2^2*delta21*eta11 - alpha21*eta11)/(4*omega2*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 -
  /// 2*omega2))
  double lump_harmonic_re_v1_conjA_v1_F() const {
    return (-2.0 * omega1_2 * delta22 * eta21 + 4.0 * omega1 * omega2 * delta22 * eta21 + 3.0 * omega2_2 * eta12
        + 2.0 * alpha22 * eta21) * per_1 / (24.0 * omega2_3) + (omega1_2 * delta21 * eta11
        - 2.0 * omega1 * omega2 * delta21 * eta11 + 4.0 * omega2_2 * delta21 * eta11
        - alpha21 * eta11) * over_20 / (4.0 * omega2);
  }
  /// harmonic_re_v1_A_v2_F = (2*omega2^2*delta23*eta21 + alpha23*eta21)/(3*omega2^2*(omega1 + 3*omega2)*(omega1 -
  /// 3*omega2)) + (6*omega2^2*delta22*eta11 - alpha22*eta11)/((omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 -
  /// 2*omega2)*(omega1 - 3*omega2))
  double lump_harmonic_re_v1_A_v2_F_of_principal_parametric_2() const {
    return (2.0 * omega2_2 * delta23 * eta21 + alpha23 * eta21) * over_24 / (3.0 * omega2_2)
        + (6.0 * omega2_2 * delta22 * eta11 - alpha22 * eta11) * over_25;
  }
  /// harmonic_re_v1_A_v1_F = (2*omega1^2*delta22*eta21 + 4*omega1*omega2*delta22*eta21 - 3*omega2^2*eta12 -
  /// 2*alpha22*eta21)/(24*omega2^3*(omega1 + omega2)) + (-omega1^2*delta21*eta11 - 2*omega1*omega2*delta21*eta11 -
  /// 4*omega2^2*delta21*eta11 + alpha21*eta11)/(4*omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 -
  /// 2*omega2))
  double lump_harmonic_re_v1_A_v1_F_of_principal_parametric_2() const {
    return (2.0 * omega1_2 * delta22 * eta21 + 4.0 * omega1 * omega2 * delta22 * eta21 - 3.0 * omega2_2 * eta12
        - 2.0 * alpha22 * eta21) * per_0 / (24.0 * omega2_3) + (-omega1_2 * delta21 * eta11
        - 2.0 * omega1 * omega2 * delta21 * eta11 - 4.0 * omega2_2 * delta21 * eta11
        + alpha21 * eta11) * over_23 / (4.0 * omega2);
  }
  /// harmonic_im_v2_F = eta11*mu21/(3*omega2*(omega1 + 2*omega2)*(omega1 - 2*omega2))
  double lump_harmonic_im_v2_F_of_principal_parametric_2() const {
    return eta11 * mu21 * over_1 / (3.0 * omega2);
  }
  /// harmonic_re_v2_conjA_v1_F = (-2*omega1*omega2*delta23*eta21 + 4*omega2^2*delta23*eta21 -
  /// alpha23*eta21)/(3*omega2^2*(omega1 - omega2)*(omega1 - 3*omega2)) + (-2*omega1*omega2*delta22*eta11 +
  /// alpha22*eta11)/((omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(omega1 - 3*omega2))
  double lump_harmonic_re_v2_conjA_v1_F_of_principal_parametric_2() const {
    return (-2.0 * omega1 * omega2 * delta23 * eta21 + 4.0 * omega2_2 * delta23 * eta21
        - alpha23 * eta21) * over_32 / (3.0 * omega2_2) + (-2.0 * omega1 * omega2 * delta22 * eta11
        + alpha22 * eta11) * over_35;
  }
  /// harmonic_re_v2_A_v2_F = (14*omega2^2*delta24*eta21 - 3*omega2^2*eta22 - 2*alpha24*eta21)/(48*omega2^4) +
  /// (-3*omega2^2*delta23*eta11 + alpha23*eta11)/(8*omega2^2*(omega1 + 2*omega2)*(omega1 - 2*omega2))
  double lump_harmonic_re_v2_A_v2_F_of_principal_parametric_2() const {
    return (14.0 * omega2_2 * delta24 * eta21 - 3.0 * omega2_2 * eta22 - 2.0 * alpha24 * eta21) / (48.0 * omega2_4)
        + (-3.0 * omega2_2 * delta23 * eta11 + alpha23 * eta11) * over_1 / (8.0 * omega2_2);
  }
  /// harmonic_re_v2_A_v1_F = (2*omega1*omega2*delta23*eta21 + 4*omega2^2*delta23*eta21 -
  /// alpha23*eta21)/(3*omega2^2*(omega1 + omega2)*(omega1 + 3*omega2)) + (2*omega1*omega2*delta22*eta11 +
  /// alpha22*eta11)/((omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2))
  double lump_harmonic_re_v2_A_v1_F_of_principal_parametric_2() const {
    return (2.0 * omega1 * omega2 * delta23 * eta21 + 4.0 * omega2_2 * delta23 * eta21
        - alpha23 * eta21) * over_38 / (3.0 * omega2_2) + (2.0 * omega1 * omega2 * delta22 * eta11
        + alpha22 * eta11) * over_41;
  }
  /// conservative_v1_A_v1_F2 = -eta12^2/(4*omega1*(omega1 - omega2)*(3*omega1 + omega2))
  double lump_conservative_v1_A_v1_F2_of_additive_combination() const {
    return -eta12_2 * over_48 / (4.0 * omega1);
  }
  /// dissipative_v1_conjA_v2_F = (omega1*mu12*eta22 + omega2*mu12*eta12)/(4*omega1*(omega1 + omega2)*(omega1 -
  /// omega2))
  double lump_dissipative_v1_conjA_v2_F() const {
    return (omega1 * mu12 * eta22 + omega2 * mu12 * eta12) * over_0 / (4.0 * omega1);
  }
  /// conservative_v1_conjA_v2_F = (omega1*omega2*delta23*eta21 + omega2^2*delta23*eta21 -
  /// alpha23*eta21)/(2*omega1^2*(omega1 + 2*omega2)) + (omega1^2*delta22*eta11 + omega1*omega2*delta22*eta11 -
  /// alpha22*eta11)/(2*omega1*omega2*(2*omega1 + omega2))
  double lump_conservative_v1_conjA_v2_F() const {
    return (omega1 * omega2 * delta23 * eta21 + omega2_2 * delta23 * eta21
        - alpha23 * eta21) * per_2 / (2.0 * omega1_2) + (omega1_2 * delta22 * eta11
        + omega1 * omega2 * delta22 * eta11 - alpha22 * eta11) * per_4 / (2.0 * omega1 * omega2);
  }
  /// conservative_v2_A_v2_F2 = eta22^2/(4*omega2*(omega1 + 3*omega2)*(omega1 - omega2))
  double lump_conservative_v2_A_v2_F2_of_additive_combination() const {
    return eta22_2 * over_49 / (4.0 * omega2);
  }
  /// dissipative_v2_conjA_v1_F = (-omega1*mu21*eta22 - omega2*eta12*mu21)/(4*omega2*(omega1 + omega2)*(omega1 -
  /// omega2))
  double lump_dissipative_v2_conjA_v1_F() const {
    return (-omega1 * mu21 * eta22 - omega2 * eta12 * mu21) * over_0 / (4.0 * omega2);
  }
  /// harmonic_re_v1_conjA_v1_F = (omega1*omega2*delta22*eta21 + alpha22*eta21)/(omega1*(omega1 + omega2)*(omega1 +
  /// 2*omega2)*(omega1 - omega2)) + (-omega1^2*delta21*eta11 - omega1*omega2*delta21*eta11 -
  /// omega2^2*delta21*eta11 + alpha21*eta11)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega2))
  double lump_harmonic_re_v1_conjA_v1_F_of_additive_combination() const {
    return (omega1 * omega2 * delta22 * eta21 + alpha22 * eta21) * over_6 / omega1 + (-omega1_2 * delta21 * eta11
        - omega1 * omega2 * delta21 * eta11 - omega2_2 * delta21 * eta11 + alpha21 * eta11) * over_11 / omega2;
  }
  /// harmonic_re_v1_conjA_v12_F = (3*omega1^4*delta21*eta12 - 6*omega1^3*omega2*delta21*eta12 +
  /// 9*omega1^2*omega2^2*delta21*eta12 - 5*omega1^2*alpha21*eta12 -
  /// omega2^2*alpha21*eta12)/(6*omega1^2*omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 - omega2))
  double lump_harmonic_re_v1_conjA_v12_F_of_additive_combination() const {
    return (3.0 * omega1_4 * delta21 * eta12 - 6.0 * omega1_3 * omega2 * delta21 * eta12
        + 9.0 * omega1_2 * omega2_2 * delta21 * eta12 - 5.0 * omega1_2 * alpha21 * eta12
        - omega2_2 * alpha21 * eta12) * over_4 / (6.0 * omega1_2 * omega2);
  }
  /// harmonic_re_v1_A_v22_F = (-omega1*omega2*delta23*eta22 + alpha23*eta22)/(omega2*(omega1 + omega2)*(omega1 -
  /// omega2)*(2*omega1 - omega2)) + (-omega2^2*delta23*eta12 - alpha23*eta12)/(2*omega2*(omega1 +
  /// 2*omega2)*(omega1 - 2*omega2)*(2*omega1 - omega2))
  double lump_harmonic_re_v1_A_v22_F_of_additive_combination() const {
    return (-omega1 * omega2 * delta23 * eta22 + alpha23 * eta22) * over_4 / omega2 + (-omega2_2 * delta23 * eta12
        - alpha23 * eta12) * over_50 / (2.0 * omega2);
  }
  /// harmonic_re_v1_conjA_v1_conjA_v2_F = (-omega1^2*delta22*eta12 - omega1*omega2*delta22*eta12 +
  /// alpha22*eta12)/(omega1^2*omega2*(2*omega1 + omega2)) + (-alpha22*eta12 + alpha22*eta22)/(omega1^2*(omega1 +
  /// omega2)*(omega1 - omega2))
  double lump_harmonic_re_v1_conjA_v1_conjA_v2_F() const {
    return (-omega1_2 * delta22 * eta12 - omega1 * omega2 * delta22 * eta12
        + alpha22 * eta12) * per_4 / (omega1_2 * omega2) + (-alpha22 * eta12 + alpha22 * eta22) * over_0 / omega1_2;
  }
  double lump_harmonic_re_v1_F2() const { return -eta11 * eta12 * per_4 / (2.0 * omega1_2 * omega2); }
  /// harmonic_im_v1_F = (-omega1*mu12*eta21 - omega2*mu12*eta21)/(2*omega1*omega2*(omega1 + 2*omega2)*(2*omega1 +
  /// omega2))
  double lump_harmonic_im_v1_F_of_additive_combination() const {
    return (-omega1 * mu12 * eta21 - omega2 * mu12 * eta21) * over_12 / (2.0 * omega1 * omega2);
  }
  /// harmonic_re_v1_A_v2_conjA_v2_F = (-omega2^2*delta23*eta12 + alpha23*eta12)/(omega1^2*omega2*(2*omega1 +
  /// omega2)) + (-2*omega2^2*delta23*eta22 - 2*alpha23*eta22)/(omega2*(omega1 + 3*omega2)*(omega1 -
  /// omega2)*(2*omega1 + omega2))
  double lump_harmonic_re_v1_A_v2_conjA_v2_F_of_additive_combination() const {
    return (-omega2_2 * delta23 * eta12 + alpha23 * eta12) * per_4 / (omega1_2 * omega2)
        + (-2.0 * omega2_2 * delta23 * eta22 - 2.0 * alpha23 * eta22) * over_51 / omega2;
  }
  /// harmonic_re_v1_A_v1_conjA_v1_F = (-3*omega1^4*delta21*eta12 - 2*omega1^3*omega2*delta21*eta12 -
  /// omega1^2*omega2^2*delta21*eta12 + 5*omega1^2*alpha21*eta12 - 2*omega1*omega2*alpha21*eta12 -
  /// omega2^2*alpha21*eta12)/(omega1^2*omega2*(omega1 - omega2)*(2*omega1 + omega2)*(3*omega1 + omega2))
  double lump_harmonic_re_v1_A_v1_conjA_v1_F_of_additive_combination() const {
    return (-3.0 * omega1_4 * delta21 * eta12 - 2.0 * omega1_3 * omega2 * delta21 * eta12
        - omega1_2 * omega2_2 * delta21 * eta12 + 5.0 * omega1_2 * alpha21 * eta12
        - 2.0 * omega1 * omega2 * alpha21 * eta12 - omega2_2 * alpha21 * eta12) * over_52 / (omega1_2 * omega2);
  }
  /// harmonic_re_v1_A_v2_conjA_v1_F = (2*omega1*omega2*delta22*eta22 + alpha22*eta22)/((omega1 + omega2)*(omega1 +
  /// 2*omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2)) + (omega1^4*delta22*eta12 - omega1^3*omega2*delta22*eta12
  /// - omega1^2*omega2^2*delta22*eta12 - omega1^2*alpha22*eta12 + 5*omega1*omega2^3*delta22*eta12 -
  /// 2*omega1*omega2*alpha22*eta12 - 2*omega2^4*delta22*eta12 + 2*omega2^2*alpha22*eta12)/(omega2*(omega1 +
  /// omega2)*(omega1 + 2*omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(2*omega1 - omega2))
  double lump_harmonic_re_v1_A_v2_conjA_v1_F_of_additive_combination() const {
    return (2.0 * omega1 * omega2 * delta22 * eta22 + alpha22 * eta22) * over_41 + (omega1_4 * delta22 * eta12
        - omega1_3 * omega2 * delta22 * eta12 - omega1_2 * omega2_2 * delta22 * eta12 - omega1_2 * alpha22 * eta12
        + 5.0 * omega1 * omega2_3 * delta22 * eta12 - 2.0 * omega1 * omega2 * alpha22 * eta12
        - 2.0 * omega2_4 * delta22 * eta12 + 2.0 * omega2_2 * alpha22 * eta12) * over_53 / omega2;
  }
  /// harmonic_re_v1_A_v1_F = (2*omega1^2*delta22*eta21 + omega1*omega2*delta22*eta21 -
  /// alpha22*eta21)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(3*omega1 + omega2)) + (3*omega1^2*delta21*eta11
  /// + 3*omega1*omega2*delta21*eta11 + omega2^2*delta21*eta11 - alpha21*eta11)/(omega2*(omega1 + omega2)*(2*omega1
  /// + omega2)*(3*omega1 + omega2))
  double lump_harmonic_re_v1_A_v1_F_of_additive_combination() const {
    return (2.0 * omega1_2 * delta22 * eta21 + omega1 * omega2 * delta22 * eta21
        - alpha22 * eta21) * over_54 / omega1 + (3.0 * omega1_2 * delta21 * eta11
        + 3.0 * omega1 * omega2 * delta21 * eta11 + omega2_2 * delta21 * eta11
        - alpha21 * eta11) * over_28 / omega2;
  }
  /// harmonic_re_v1_A_v1_conjA_v2_F = alpha22*eta12/(3*omega1^2*omega2*(2*omega1 - omega2)) +
  /// (2*omega1^2*delta22*eta22 - alpha22*eta22)/(3*omega1^2*(omega1 + omega2)*(omega1 - omega2)) -
  /// alpha22*eta12/(3*omega1^2*(omega1 + omega2)*(3*omega1 + omega2)) + (-3*omega1^3*delta22*eta12 +
  /// 7*omega1^2*omega2*delta22*eta12 + 3*omega1*omega2^2*delta22*eta12 -
  /// omega2^3*delta22*eta12)/(3*omega1*omega2*(omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2))
  double lump_harmonic_re_v1_A_v1_conjA_v2_F() const {
    return alpha22 * eta12 * per_5 / (3.0 * omega1_2 * omega2) + (2.0 * omega1_2 * delta22 * eta22
        - alpha22 * eta22) * over_0 / (3.0 * omega1_2) - alpha22 * eta12 * over_26 / (3.0 * omega1_2)
        + (-3.0 * omega1_3 * delta22 * eta12 + 7.0 * omega1_2 * omega2 * delta22 * eta12
        + 3.0 * omega1 * omega2_2 * delta22 * eta12
        - omega2_3 * delta22 * eta12) * over_55 / (3.0 * omega1 * omega2);
  }
  /// harmonic_re_v1_A_v2_F = -delta23*eta21/(4*omega1*(omega1 + 2*omega2)) + (omega1*delta22*eta11 +
  /// 2*omega2*delta22*eta11)/(4*omega2^2*(2*omega1 + omega2)) - alpha23*eta21/(4*omega1*omega2*(omega1 +
  /// omega2)*(omega1 + 2*omega2)) - alpha22*eta11/(4*omega2^2*(omega1 + omega2)*(2*omega1 + omega2))
  double lump_harmonic_re_v1_A_v2_F_of_additive_combination() const {
    return -delta23 * eta21 * per_2 / (4.0 * omega1) + (omega1 * delta22 * eta11
        + 2.0 * omega2 * delta22 * eta11) * per_4 / (4.0 * omega2_2)
        - alpha23 * eta21 * over_21 / (4.0 * omega1 * omega2) - alpha22 * eta11 * over_22 / (4.0 * omega2_2);
  }
  /// harmonic_im_v1_A_v2_F = (-omega1*mu12*eta22 - 2*omega2*mu12*eta22)/(8*omega2*(omega1 + omega2)^2*(omega1 +
  /// 3*omega2)) + mu12*eta12/(8*(omega1 + omega2)^2*(omega1 - omega2))
  double lump_harmonic_im_v1_A_v2_F_of_additive_combination() const {
    return (-omega1 * mu12 * eta22 - 2.0 * omega2 * mu12 * eta22) * over_56 / (8.0 * omega2)
        + mu12 * eta12 * over_57 / 8.0;
  }
  /// harmonic_re_v1_A_v1_A_v2_F = 2*omega1*delta22*eta22/((omega1 + 2*omega2)*(omega1 + 3*omega2)*(3*omega1 +
  /// 2*omega2)) - alpha22*eta22/((omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(3*omega1 + 2*omega2))
  /// + (3*omega1^3*delta22*eta12 + 12*omega1^2*omega2*delta22*eta12 + 9*omega1*omega2^2*delta22*eta12 +
  /// 2*omega2^3*delta22*eta12)/(omega2*(omega1 + 2*omega2)*(2*omega1 + omega2)*(3*omega1 + omega2)*(3*omega1 +
  /// 2*omega2)) + (-3*omega1^2*alpha22*eta12 - 6*omega1*omega2*alpha22*eta12 -
  /// 2*omega2^2*alpha22*eta12)/(omega2*(omega1 + omega2)*(omega1 + 2*omega2)*(2*omega1 + omega2)*(3*omega1 +
  /// omega2)*(3*omega1 + 2*omega2))
  double lump_harmonic_re_v1_A_v1_A_v2_F_of_additive_combination() const {
    return 2.0 * omega1 * delta22 * eta22 * over_58 - alpha22 * eta22 * over_59 + (3.0 * omega1_3 * delta22 * eta12
        + 12.0 * omega1_2 * omega2 * delta22 * eta12 + 9.0 * omega1 * omega2_2 * delta22 * eta12
        + 2.0 * omega2_3 * delta22 * eta12) * over_60 / omega2 + (-3.0 * omega1_2 * alpha22 * eta12
        - 6.0 * omega1 * omega2 * alpha22 * eta12 - 2.0 * omega2_2 * alpha22 * eta12) * over_61 / omega2;
  }
  /// harmonic_re_v1_A_v12_F = (51*omega1^4*delta21*eta12 + 42*omega1^3*omega2*delta21*eta12 +
  /// 9*omega1^2*omega2^2*delta21*eta12 - 9*omega1^2*alpha21*eta12 - 4*omega1*omega2*alpha21*eta12 -
  /// omega2^2*alpha21*eta12)/(6*omega1^2*(omega1 + omega2)*(2*omega1 + omega2)*(3*omega1 + omega2)*(4*omega1 +
  /// omega2))
  double lump_harmonic_re_v1_A_v12_F_of_additive_combination() const {
    return (51.0 * omega1_4 * delta21 * eta12 + 42.0 * omega1_3 * omega2 * delta21 * eta12
        + 9.0 * omega1_2 * omega2_2 * delta21 * eta12 - 9.0 * omega1_2 * alpha21 * eta12
        - 4.0 * omega1 * omega2 * alpha21 * eta12 - omega2_2 * alpha21 * eta12) * over_62 / (6.0 * omega1_2);
  }
  /// harmonic_re_v2_conjA_v12_F = (-omega1*omega2*delta22*eta12 + alpha22*eta12)/(omega1*(omega1 + omega2)*(omega1
  /// - omega2)*(omega1 - 2*omega2)) + (-omega1^2*delta22*eta22 - alpha22*eta22)/(2*omega1*(omega1 -
  /// 2*omega2)*(2*omega1 + omega2)*(2*omega1 - omega2))
  double lump_harmonic_re_v2_conjA_v12_F_of_additive_combination() const {
    return (-omega1 * omega2 * delta22 * eta12 + alpha22 * eta12) * over_10 / omega1 + (-omega1_2 * delta22 * eta22
        - alpha22 * eta22) * over_63 / (2.0 * omega1);
  }
  /// harmonic_re_v2_A_v22_F = (9*omega1^2*omega2^2*delta24*eta22 - omega1^2*alpha24*eta22 -
  /// 6*omega1*omega2^3*delta24*eta22 + 3*omega2^4*delta24*eta22 -
  /// 5*omega2^2*alpha24*eta22)/(6*omega1*omega2^2*(omega1 + omega2)*(omega1 - omega2)*(omega1 - 2*omega2))
  double lump_harmonic_re_v2_A_v22_F_of_additive_combination() const {
    return (9.0 * omega1_2 * omega2_2 * delta24 * eta22 - omega1_2 * alpha24 * eta22
        - 6.0 * omega1 * omega2_3 * delta24 * eta22 + 3.0 * omega2_4 * delta24 * eta22
        - 5.0 * omega2_2 * alpha24 * eta22) * over_10 / (6.0 * omega1 * omega2_2);
  }
  /// harmonic_re_v2_conjA_v2_F = (omega1^2*delta24*eta21 + omega1*omega2*delta24*eta21 + omega2^2*delta24*eta21 -
  /// alpha24*eta21)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 - omega2)) +
  /// (-omega1*omega2*delta23*eta11 - alpha23*eta11)/(omega2*(omega1 + omega2)*(omega1 - omega2)*(2*omega1 +
  /// omega2))
  double lump_harmonic_re_v2_conjA_v2_F() const {
    return (omega1_2 * delta24 * eta21 + omega1 * omega2 * delta24 * eta21 + omega2_2 * delta24 * eta21
        - alpha24 * eta21) * over_6 / omega1 + (-omega1 * omega2 * delta23 * eta11
        - alpha23 * eta11) * over_11 / omega2;
  }
  /// harmonic_re_v2_conjA_v1_conjA_v2_F = (-omega1*omega2*delta23*eta22 - omega2^2*delta23*eta22 +
  /// alpha23*eta22)/(omega1*omega2^2*(omega1 + 2*omega2)) + (-alpha23*eta12 + alpha23*eta22)/(omega2^2*(omega1 +
  /// omega2)*(omega1 - omega2))
  double lump_harmonic_re_v2_conjA_v1_conjA_v2_F() const {
    return (-omega1 * omega2 * delta23 * eta22 - omega2_2 * delta23 * eta22
        + alpha23 * eta22) * per_2 / (omega1 * omega2_2) + (-alpha23 * eta12 + alpha23 * eta22) * over_0 / omega2_2;
  }
  double lump_harmonic_re_v2_F2() const { return -eta21 * eta22 * per_2 / (2.0 * omega1 * omega2_2); }
  /// harmonic_im_v2_F = (-omega1*eta11*mu21 - omega2*eta11*mu21)/(2*omega1*omega2*(omega1 + 2*omega2)*(2*omega1 +
  /// omega2))
  double lump_harmonic_im_v2_F_of_additive_combination() const {
    return (-omega1 * eta11 * mu21 - omega2 * eta11 * mu21) * over_12 / (2.0 * omega1 * omega2);
  }
  /// harmonic_re_v2_A_v2_conjA_v2_F = (omega1^2*omega2^2*delta24*eta22 + omega1^2*alpha24*eta22 +
  /// 2*omega1*omega2^3*delta24*eta22 + 2*omega1*omega2*alpha24*eta22 + 3*omega2^4*delta24*eta22 -
  /// 5*omega2^2*alpha24*eta22)/(omega1*omega2^2*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(omega1 - omega2))
  double lump_harmonic_re_v2_A_v2_conjA_v2_F_of_additive_combination() const {
    return (omega1_2 * omega2_2 * delta24 * eta22 + omega1_2 * alpha24 * eta22
        + 2.0 * omega1 * omega2_3 * delta24 * eta22 + 2.0 * omega1 * omega2 * alpha24 * eta22
        + 3.0 * omega2_4 * delta24 * eta22 - 5.0 * omega2_2 * alpha24 * eta22) * over_64 / (omega1 * omega2_2);
  }
  /// harmonic_re_v2_A_v1_conjA_v1_F = (-omega1^2*delta22*eta22 + alpha22*eta22)/(omega1*omega2^2*(omega1 +
  /// 2*omega2)) + (2*omega1^2*delta22*eta12 + 2*alpha22*eta12)/(omega1*(omega1 + 2*omega2)*(omega1 -
  /// omega2)*(3*omega1 + omega2))
  double lump_harmonic_re_v2_A_v1_conjA_v1_F_of_additive_combination() const {
    return (-omega1_2 * delta22 * eta22 + alpha22 * eta22) * per_2 / (omega1 * omega2_2)
        + (2.0 * omega1_2 * delta22 * eta12 + 2.0 * alpha22 * eta12) * over_65 / omega1;
  }
  /// harmonic_re_v2_A_v2_F = (omega1^2*delta24*eta21 + 3*omega1*omega2*delta24*eta21 + 3*omega2^2*delta24*eta21 -
  /// alpha24*eta21)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)) +
  /// (omega1*omega2*delta23*eta11 + 2*omega2^2*delta23*eta11 - alpha23*eta11)/(omega2*(omega1 + omega2)*(omega1 +
  /// 3*omega2)*(2*omega1 + omega2))
  double lump_harmonic_re_v2_A_v2_F_of_additive_combination() const {
    return (omega1_2 * delta24 * eta21 + 3.0 * omega1 * omega2 * delta24 * eta21 + 3.0 * omega2_2 * delta24 * eta21
        - alpha24 * eta21) * over_40 / omega1 + (omega1 * omega2 * delta23 * eta11
        + 2.0 * omega2_2 * delta23 * eta11 - alpha23 * eta11) * over_66 / omega2;
  }
  /// harmonic_re_v2_A_v2_conjA_v1_F = -alpha23*eta22/(3*omega1*omega2^2*(omega1 - 2*omega2)) -
  /// alpha23*eta22/(3*omega2^2*(omega1 + omega2)*(omega1 + 3*omega2)) + (-2*omega2^2*delta23*eta12 +
  /// alpha23*eta12)/(3*omega2^2*(omega1 + omega2)*(omega1 - omega2)) + (omega1^3*delta23*eta22 -
  /// 3*omega1^2*omega2*delta23*eta22 - 7*omega1*omega2^2*delta23*eta22 +
  /// 3*omega2^3*delta23*eta22)/(3*omega1*omega2*(omega1 + omega2)*(omega1 + 3*omega2)*(omega1 - 2*omega2))
  double lump_harmonic_re_v2_A_v2_conjA_v1_F_of_additive_combination() const {
    return -alpha23 * eta22 * per_3 / (3.0 * omega1 * omega2_2) - alpha23 * eta22 * over_38 / (3.0 * omega2_2)
        + (-2.0 * omega2_2 * delta23 * eta12 + alpha23 * eta12) * over_0 / (3.0 * omega2_2)
        + (omega1_3 * delta23 * eta22 - 3.0 * omega1_2 * omega2 * delta23 * eta22
        - 7.0 * omega1 * omega2_2 * delta23 * eta22
        + 3.0 * omega2_3 * delta23 * eta22) * over_67 / (3.0 * omega1 * omega2);
  }
  /// harmonic_re_v2_A_v1_conjA_v2_F = (-2*omega1*omega2*delta23*eta12 - alpha23*eta12)/((omega1 +
  /// omega2)*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 + omega2)) + (2*omega1^4*delta23*eta22 -
  /// 5*omega1^3*omega2*delta23*eta22 + omega1^2*omega2^2*delta23*eta22 - 2*omega1^2*alpha23*eta22 +
  /// omega1*omega2^3*delta23*eta22 + 2*omega1*omega2*alpha23*eta22 - omega2^4*delta23*eta22 +
  /// omega2^2*alpha23*eta22)/(omega1*(omega1 + omega2)*(omega1 - omega2)*(omega1 - 2*omega2)*(2*omega1 +
  /// omega2)*(2*omega1 - omega2))
  double lump_harmonic_re_v2_A_v1_conjA_v2_F_of_additive_combination() const {
    return (-2.0 * omega1 * omega2 * delta23 * eta12 - alpha23 * eta12) * over_29
        + (2.0 * omega1_4 * delta23 * eta22 - 5.0 * omega1_3 * omega2 * delta23 * eta22
        + omega1_2 * omega2_2 * delta23 * eta22 - 2.0 * omega1_2 * alpha23 * eta22
        + omega1 * omega2_3 * delta23 * eta22 + 2.0 * omega1 * omega2 * alpha23 * eta22 - omega2_4 * delta23 * eta22
        + omega2_2 * alpha23 * eta22) * over_68 / omega1;
  }
  /// harmonic_re_v2_A_v1_F = (2*omega1*delta23*eta21 + omega2*delta23*eta21)/(4*omega1^2*(omega1 + 2*omega2)) -
  /// delta22*eta11/(4*omega2*(2*omega1 + omega2)) - alpha23*eta21/(4*omega1^2*(omega1 + omega2)*(omega1 +
  /// 2*omega2)) - alpha22*eta11/(4*omega1*omega2*(omega1 + omega2)*(2*omega1 + omega2))
  double lump_harmonic_re_v2_A_v1_F_of_additive_combination() const {
    return (2.0 * omega1 * delta23 * eta21 + omega2 * delta23 * eta21) * per_2 / (4.0 * omega1_2)
        - delta22 * eta11 * per_4 / (4.0 * omega2) - alpha23 * eta21 * over_21 / (4.0 * omega1_2)
        - alpha22 * eta11 * over_22 / (4.0 * omega1 * omega2);
  }
  /// harmonic_im_v2_A_v1_F = -mu21*eta22/(8*(omega1 + omega2)^2*(omega1 - omega2)) + (-2*omega1*eta12*mu21 -
  /// omega2*eta12*mu21)/(8*omega1*(omega1 + omega2)^2*(3*omega1 + omega2))
  double lump_harmonic_im_v2_A_v1_F_of_additive_combination() const {
    return -mu21 * eta22 * over_57 / 8.0 + (-2.0 * omega1 * eta12 * mu21
        - omega2 * eta12 * mu21) * over_69 / (8.0 * omega1);
  }
  /// harmonic_re_v2_A_v1_A_v2_F = 2*omega2*delta23*eta12/((2*omega1 + omega2)*(2*omega1 + 3*omega2)*(3*omega1 +
  /// omega2)) - alpha23*eta12/((omega1 + omega2)*(2*omega1 + omega2)*(2*omega1 + 3*omega2)*(3*omega1 + omega2)) +
  /// (2*omega1^3*delta23*eta22 + 9*omega1^2*omega2*delta23*eta22 + 12*omega1*omega2^2*delta23*eta22 +
  /// 3*omega2^3*delta23*eta22)/(omega1*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(2*omega1 + omega2)*(2*omega1 +
  /// 3*omega2)) + (-2*omega1^2*alpha23*eta22 - 6*omega1*omega2*alpha23*eta22 -
  /// 3*omega2^2*alpha23*eta22)/(omega1*(omega1 + omega2)*(omega1 + 2*omega2)*(omega1 + 3*omega2)*(2*omega1 +
  /// omega2)*(2*omega1 + 3*omega2))
  double lump_harmonic_re_v2_A_v1_A_v2_F_of_additive_combination() const {
    return 2.0 * omega2 * delta23 * eta12 * over_70 - alpha23 * eta12 * over_71 + (2.0 * omega1_3 * delta23 * eta22
        + 9.0 * omega1_2 * omega2 * delta23 * eta22 + 12.0 * omega1 * omega2_2 * delta23 * eta22
        + 3.0 * omega2_3 * delta23 * eta22) * over_72 / omega1 + (-2.0 * omega1_2 * alpha23 * eta22
        - 6.0 * omega1 * omega2 * alpha23 * eta22 - 3.0 * omega2_2 * alpha23 * eta22) * over_73 / omega1;
  }
  /// harmonic_re_v2_A_v12_F = (-2*omega1^2*delta22*eta12 - omega1*omega2*delta22*eta12 -
  /// alpha22*eta12)/(3*omega1*(omega1 + omega2)*(3*omega1 + omega2)*(3*omega1 + 2*omega2)) +
  /// (-omega1^2*delta22*eta22 - alpha22*eta22)/(6*omega1*(2*omega1 + omega2)*(2*omega1 - omega2)*(3*omega1 +
  /// 2*omega2))
  double lump_harmonic_re_v2_A_v12_F_of_additive_combination() const {
    return (-2.0 * omega1_2 * delta22 * eta12 - omega1 * omega2 * delta22 * eta12
        - alpha22 * eta12) * over_74 / (3.0 * omega1) + (-omega1_2 * delta22 * eta22
        - alpha22 * eta22) * over_75 / (6.0 * omega1);
  }

  /// By their numbers in the tables.
  static constexpr double (Lumps::*list[])() const = {&Lumps::lump_conservative_v1_A_v12_F, &Lumps::lump_mu11,
      &Lumps::lump_conservative_v1_A_v1, &Lumps::lump_conservative_v1_A_v1_F2,
      &Lumps::lump_conservative_v1_A_v1_A_v2_conjA_v2, &Lumps::lump_mu13,
      &Lumps::lump_conservative_v1_A_v12_conjA_v1, &Lumps::lump_eta11, &Lumps::lump_conservative_v1_A_v2_conjA_v2_F,
      &Lumps::lump_mu22, &Lumps::lump_conservative_v2_A_v2_F2, &Lumps::lump_mu23,
      &Lumps::lump_conservative_v2_A_v22_conjA_v2, &Lumps::lump_eta12, &Lumps::lump_harmonic_re_v1_A_v2_conjA_v2,
      &Lumps::lump_harmonic_re_v1_A_v1_conjA_v1, &Lumps::lump_harmonic_re_v1_A_v2_conjA_v1,
      &Lumps::lump_harmonic_im_v1_A_v2_conjA_v1, &Lumps::lump_harmonic_im_v1_A_v2_F, &Lumps::lump_mu12,
      &Lumps::lump_harmonic_re_v1_A_v2_conjA_v1_F, &Lumps::lump_harmonic_re_v1_A_v22_conjA_v2,
      &Lumps::lump_harmonic_re_v1_A_v1_A_v2_conjA_v1, &Lumps::lump_harmonic_re_v1_A_v1_A_v2_F,
      &Lumps::lump_harmonic_re_v1_A_v22, &Lumps::lump_harmonic_im_v1_A_v22, &Lumps::lump_harmonic_re_v1_A_v12,
      &Lumps::lump_harmonic_im_v1_A_v12, &Lumps::lump_harmonic_re_v1_A_v1_A_v2,
      &Lumps::lump_harmonic_im_v1_A_v1_A_v2, &Lumps::lump_harmonic_re_v1_A_v2_conjA_v12,
      &Lumps::lump_harmonic_re_v1_A_v22_conjA_v1, &Lumps::lump_harmonic_re_v1_A_v22_F,
      &Lumps::lump_harmonic_re_v1_A_v1_A_v22, &Lumps::lump_harmonic_re_v1_A_v23,
      &Lumps::lump_harmonic_re_v1_A_v12_F, &Lumps::lump_harmonic_re_v1_A_v13,
      &Lumps::lump_harmonic_re_v1_A_v12_A_v2, &Lumps::lump_harmonic_re_v2_A_v2_conjA_v1, &Lumps::lump_eta22,
      &Lumps::lump_harmonic_im_v2_A_v2_conjA_v1, &Lumps::lump_harmonic_re_v2_A_v2_conjA_v2,
      &Lumps::lump_harmonic_re_v2_A_v1_conjA_v1, &Lumps::lump_harmonic_im_v2_conjA_v1_F,
      &Lumps::lump_harmonic_re_v2_A_v1_A_v2, &Lumps::lump_harmonic_im_v2_A_v1_A_v2,
      &Lumps::lump_harmonic_re_v2_A_v22, &Lumps::lump_harmonic_im_v2_A_v22, &Lumps::lump_mu21, &Lumps::lump_eta21,
      &Lumps::lump_harmonic_re_v2_A_v2_conjA_v2_F, &Lumps::lump_harmonic_re_v2_A_v1_conjA_v1_F,
      &Lumps::lump_harmonic_re_v2_A_v1_A_v2_conjA_v2, &Lumps::lump_harmonic_re_v2_A_v12_conjA_v1,
      &Lumps::lump_harmonic_re_v2_A_v12_F, &Lumps::lump_harmonic_re_v2_A_v12, &Lumps::lump_harmonic_im_v2_A_v1_F,
      &Lumps::lump_harmonic_im_v2_A_v12, &Lumps::lump_harmonic_re_v2_A_v2_conjA_v12,
      &Lumps::lump_harmonic_re_v2_A_v2_conjA_v1_F, &Lumps::lump_harmonic_re_v2_A_v22_conjA_v1,
      &Lumps::lump_harmonic_re_v2_A_v22_F, &Lumps::lump_harmonic_re_v2_A_v1_A_v2_F,
      &Lumps::lump_harmonic_re_v2_A_v12_A_v2, &Lumps::lump_harmonic_re_v2_A_v1_A_v22,
      &Lumps::lump_harmonic_re_v2_A_v23, &Lumps::lump_harmonic_re_v2_A_v13,
      &Lumps::lump_conservative_v1_A_v1_A_v2_F, &Lumps::lump_conservative_v1_A_v1_F2_of_primary_2,
      &Lumps::lump_conservative_v2_A_v22_F, &Lumps::lump_conservative_v2_A_v2_F2_of_primary_2,
      &Lumps::lump_harmonic_im_v1_conjA_v2_F, &Lumps::lump_harmonic_re_v1_A_v2_conjA_v2_F,
      &Lumps::lump_harmonic_re_v1_A_v1_conjA_v1_F, &Lumps::lump_harmonic_re_v1_A_v22_F_of_primary_2,
      &Lumps::lump_harmonic_im_v1_A_v2_F_of_primary_2, &Lumps::lump_harmonic_re_v1_conjA_v12_F,
      &Lumps::lump_harmonic_re_v1_A_v2_conjA_v1_F_of_primary_2,
      &Lumps::lump_harmonic_re_v1_A_v1_A_v2_F_of_primary_2, &Lumps::lump_harmonic_re_v1_A_v12_F_of_primary_2,
      &Lumps::lump_harmonic_im_v2_conjA_v1_F_of_primary_2, &Lumps::lump_harmonic_re_v2_A_v1_conjA_v2_F,
      &Lumps::lump_harmonic_re_v2_A_v1_A_v2_F_of_primary_2, &Lumps::lump_harmonic_im_v2_A_v1_F_of_primary_2,
      &Lumps::lump_harmonic_re_v2_conjA_v12_F, &Lumps::lump_harmonic_re_v2_A_v2_conjA_v1_F_of_primary_2,
      &Lumps::lump_harmonic_re_v2_A_v22_F_of_primary_2, &Lumps::lump_harmonic_re_v2_A_v12_F_of_primary_2,
      &Lumps::lump_conservative_v1_conjA_v1_F, &Lumps::lump_harmonic_im_v1_F, &Lumps::lump_harmonic_re_v1_A_v2_F,
      &Lumps::lump_harmonic_re_v1_A_v1_F, &Lumps::lump_harmonic_im_v2_F, &Lumps::lump_harmonic_re_v2_conjA_v1_F,
      &Lumps::lump_harmonic_re_v2_A_v2_F, &Lumps::lump_harmonic_re_v2_A_v1_F,
      &Lumps::lump_conservative_v2_conjA_v2_F, &Lumps::lump_harmonic_im_v1_F_of_principal_parametric_2,
      &Lumps::lump_harmonic_re_v1_conjA_v2_F, &Lumps::lump_harmonic_re_v1_conjA_v1_F,
      &Lumps::lump_harmonic_re_v1_A_v2_F_of_principal_parametric_2,
      &Lumps::lump_harmonic_re_v1_A_v1_F_of_principal_parametric_2,
      &Lumps::lump_harmonic_im_v2_F_of_principal_parametric_2,
      &Lumps::lump_harmonic_re_v2_conjA_v1_F_of_principal_parametric_2,
      &Lumps::lump_harmonic_re_v2_A_v2_F_of_principal_parametric_2,
      &Lumps::lump_harmonic_re_v2_A_v1_F_of_principal_parametric_2,
      &Lumps::lump_conservative_v1_A_v1_F2_of_additive_combination, &Lumps::lump_dissipative_v1_conjA_v2_F,
      &Lumps::lump_conservative_v1_conjA_v2_F, &Lumps::lump_conservative_v2_A_v2_F2_of_additive_combination,
      &Lumps::lump_dissipative_v2_conjA_v1_F, &Lumps::lump_harmonic_re_v1_conjA_v1_F_of_additive_combination,
      &Lumps::lump_harmonic_re_v1_conjA_v12_F_of_additive_combination,
      &Lumps::lump_harmonic_re_v1_A_v22_F_of_additive_combination, &Lumps::lump_harmonic_re_v1_conjA_v1_conjA_v2_F,
      &Lumps::lump_harmonic_re_v1_F2, &Lumps::lump_harmonic_im_v1_F_of_additive_combination,
      &Lumps::lump_harmonic_re_v1_A_v2_conjA_v2_F_of_additive_combination,
      &Lumps::lump_harmonic_re_v1_A_v1_conjA_v1_F_of_additive_combination,
      &Lumps::lump_harmonic_re_v1_A_v2_conjA_v1_F_of_additive_combination,
      &Lumps::lump_harmonic_re_v1_A_v1_F_of_additive_combination, &Lumps::lump_harmonic_re_v1_A_v1_conjA_v2_F,
      &Lumps::lump_harmonic_re_v1_A_v2_F_of_additive_combination,
      &Lumps::lump_harmonic_im_v1_A_v2_F_of_additive_combination,
      &Lumps::lump_harmonic_re_v1_A_v1_A_v2_F_of_additive_combination,
      &Lumps::lump_harmonic_re_v1_A_v12_F_of_additive_combination,
      &Lumps::lump_harmonic_re_v2_conjA_v12_F_of_additive_combination,
      &Lumps::lump_harmonic_re_v2_A_v22_F_of_additive_combination, &Lumps::lump_harmonic_re_v2_conjA_v2_F,
      &Lumps::lump_harmonic_re_v2_conjA_v1_conjA_v2_F, &Lumps::lump_harmonic_re_v2_F2,
      &Lumps::lump_harmonic_im_v2_F_of_additive_combination,
      &Lumps::lump_harmonic_re_v2_A_v2_conjA_v2_F_of_additive_combination,
      &Lumps::lump_harmonic_re_v2_A_v1_conjA_v1_F_of_additive_combination,
      &Lumps::lump_harmonic_re_v2_A_v2_F_of_additive_combination,
      &Lumps::lump_harmonic_re_v2_A_v2_conjA_v1_F_of_additive_combination,
      &Lumps::lump_harmonic_re_v2_A_v1_conjA_v2_F_of_additive_combination,
      &Lumps::lump_harmonic_re_v2_A_v1_F_of_additive_combination,
      &Lumps::lump_harmonic_im_v2_A_v1_F_of_additive_combination,
      &Lumps::lump_harmonic_re_v2_A_v1_A_v2_F_of_additive_combination,
      &Lumps::lump_harmonic_re_v2_A_v12_F_of_additive_combination};
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
    const Complex A_v1;
    const Complex conj_A_v1 = conjugate(A_v1);
    const Number norm_A_v1 = norm_of(A_v1);
    const Complex A_v2;
    const Complex conj_A_v2 = conjugate(A_v2);
    const Number norm_A_v2 = norm_of(A_v2);
    const Complex F;
    const Complex conj_F = conjugate(F);
    const Number norm_F = norm_of(F);
    Signals(const Complex* amplitude, [[maybe_unused]] const Complex* forcing) : A_v1(amplitude[0]),
        A_v2(amplitude[1]), F(forcing[0]) {}
  };
};

}  // namespace secular::generated::two_mass
