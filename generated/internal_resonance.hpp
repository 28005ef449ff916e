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

namespace one_to_one {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: conservative_x_A_x2_conjA_y = (36*omega1^5*omega2*b2 - 72*omega1^4*omega2^2*b2 - 24*omega1^4*a1*a2
/// - 9*omega1^3*omega2^3*b2 + 44*omega1^3*omega2*a1*a2 + 54*omega1^3*omega2*a2*a3 + 18*omega1^2*omega2^4*b2 +
/// 8*omega1^2*omega2^2*a1*a2 - 12*omega1^2*omega2^2*a2*a3 - 2*omega1*omega2^3*a1*a2 - 12*omega1*omega2^3*a2*a3 +
/// 4*omega2^4*a1*a2)/(24*omega1^6*omega2 - 48*omega1^5*omega2^2 - 6*omega1^4*omega2^3 + 12*omega1^3*omega2^4)
/// lumps[1]: mu1 = mu1
/// lumps[2]: conservative_x_A_x_A_y_conjA_y = (4*omega1^6*omega2^2*b3 - 8*omega1^6*a2*a4 -
/// 17*omega1^4*omega2^4*b3 - 8*omega1^4*omega2^2*a1*a3 - 4*omega1^4*omega2^2*a2^2 + 34*omega1^4*omega2^2*a2*a4 +
/// 16*omega1^4*omega2^2*a3^2 + 4*omega1^2*omega2^6*b3 + 34*omega1^2*omega2^4*a1*a3 + 16*omega1^2*omega2^4*a2^2 -
/// 8*omega1^2*omega2^4*a2*a4 - 4*omega1^2*omega2^4*a3^2 - 8*omega2^6*a1*a3)/(4*omega1^7*omega2^2 -
/// 17*omega1^5*omega2^4 + 4*omega1^3*omega2^6)
/// lumps[3]: conservative_x_A_x2_conjA_x = (36*omega1^4*omega2^2*b1 - 48*omega1^4*a2^2 - 9*omega1^2*omega2^4*b1
/// - 40*omega1^2*omega2^2*a1^2 + 18*omega1^2*omega2^2*a2^2 + 10*omega2^4*a1^2)/(24*omega1^5*omega2^2 -
/// 6*omega1^3*omega2^4)
/// lumps[4]: e1 = e1
/// lumps[5]: conservative_x_A_y2_conjA_y = (9*omega1^4*omega2^2*b4 - 10*omega1^4*a3*a4 - 36*omega1^2*omega2^4*b4
/// - 18*omega1^2*omega2^2*a2*a3 + 40*omega1^2*omega2^2*a3*a4 + 48*omega2^4*a2*a3)/(6*omega1^5*omega2^2 -
/// 24*omega1^3*omega2^4)
/// lumps[6]: conservative_x_A_x_A_y_conjA_x = (12*omega1^6*omega2^2*b2 - 8*omega1^6*a2*a3 -
/// 51*omega1^4*omega2^4*b2 - 12*omega1^4*omega2^2*a1*a2 + 50*omega1^4*omega2^2*a2*a3 + 12*omega1^2*omega2^6*b2 +
/// 50*omega1^2*omega2^4*a1*a2 - 12*omega1^2*omega2^4*a2*a3 - 8*omega2^6*a1*a2)/(4*omega1^7*omega2^2 -
/// 17*omega1^5*omega2^4 + 4*omega1^3*omega2^6)
/// lumps[7]: conservative_x_A_y2_conjA_x = (6*omega1^4*omega2^2*b3 + 4*omega1^4*a2*a4 - 3*omega1^3*omega2^3*b3 -
/// 12*omega1^3*omega2*a2^2 - 2*omega1^3*omega2*a2*a4 - 24*omega1^2*omega2^4*b3 - 12*omega1^2*omega2^2*a1*a3 -
/// 16*omega1^2*omega2^2*a2*a4 + 24*omega1^2*omega2^2*a3^2 + 12*omega1*omega2^5*b3 + 6*omega1*omega2^3*a1*a3 +
/// 48*omega1*omega2^3*a2^2 + 8*omega1*omega2^3*a2*a4 + 36*omega1*omega2^3*a3^2 -
/// 24*omega2^4*a3^2)/(12*omega1^5*omega2^2 - 6*omega1^4*omega2^3 - 48*omega1^3*omega2^4 + 24*omega1^2*omega2^5)
/// lumps[8]: conservative_y_A_x2_conjA_y = (12*omega1^5*omega2*b3 - 24*omega1^4*omega2^2*b3 - 24*omega1^4*a2^2 -
/// 3*omega1^3*omega2^3*b3 + 8*omega1^3*omega2*a1*a3 + 36*omega1^3*omega2*a2^2 + 6*omega1^3*omega2*a2*a4 +
/// 48*omega1^3*omega2*a3^2 + 6*omega1^2*omega2^4*b3 - 16*omega1^2*omega2^2*a1*a3 + 24*omega1^2*omega2^2*a2^2 -
/// 12*omega1^2*omega2^2*a2*a4 - 2*omega1*omega2^3*a1*a3 - 12*omega1*omega2^3*a3^2 +
/// 4*omega2^4*a1*a3)/(24*omega1^5*omega2^2 - 48*omega1^4*omega2^3 - 6*omega1^3*omega2^4 + 12*omega1^2*omega2^5)
/// lumps[9]: conservative_y_A_x_A_y_conjA_y = (12*omega1^6*omega2^2*b4 - 8*omega1^6*a3*a4 -
/// 51*omega1^4*omega2^4*b4 - 12*omega1^4*omega2^2*a2*a3 + 50*omega1^4*omega2^2*a3*a4 + 12*omega1^2*omega2^6*b4 +
/// 50*omega1^2*omega2^4*a2*a3 - 12*omega1^2*omega2^4*a3*a4 - 8*omega2^6*a2*a3)/(4*omega1^6*omega2^3 -
/// 17*omega1^4*omega2^5 + 4*omega1^2*omega2^7)
/// lumps[10]: conservative_y_A_x2_conjA_x = (36*omega1^4*omega2^2*b2 - 48*omega1^4*a2*a3 -
/// 9*omega1^2*omega2^4*b2 - 40*omega1^2*omega2^2*a1*a2 + 18*omega1^2*omega2^2*a2*a3 +
/// 10*omega2^4*a1*a2)/(24*omega1^4*omega2^3 - 6*omega1^2*omega2^5)
/// lumps[11]: e2 = e2
/// lumps[12]: mu2 = mu2
/// lumps[13]: conservative_y_A_y2_conjA_y = (9*omega1^4*omega2^2*b5 - 10*omega1^4*a4^2 - 36*omega1^2*omega2^4*b5
/// - 18*omega1^2*omega2^2*a3^2 + 40*omega1^2*omega2^2*a4^2 + 48*omega2^4*a3^2)/(6*omega1^4*omega2^3 -
/// 24*omega1^2*omega2^5)
/// lumps[14]: conservative_y_A_y2_conjA_x = (18*omega1^4*omega2^2*b4 + 4*omega1^4*a3*a4 - 9*omega1^3*omega2^3*b4
/// - 12*omega1^3*omega2*a2*a3 - 2*omega1^3*omega2*a3*a4 - 72*omega1^2*omega2^4*b4 - 12*omega1^2*omega2^2*a2*a3 +
/// 8*omega1^2*omega2^2*a3*a4 + 36*omega1*omega2^5*b4 + 54*omega1*omega2^3*a2*a3 + 44*omega1*omega2^3*a3*a4 -
/// 24*omega2^4*a3*a4)/(12*omega1^4*omega2^3 - 6*omega1^3*omega2^4 - 48*omega1^2*omega2^5 + 24*omega1*omega2^6)
/// lumps[15]: a2 = a2
/// lumps[16]: a3 = a3
/// lumps[17]: a1 = a1
/// lumps[18]: harmonic_re_x_A_y3 = (-3*omega1^2*omega2^2*b4 - 2*omega1^2*a3*a4 + 12*omega2^4*b4 +
/// 6*omega2^2*a2*a3 + 8*omega2^2*a3*a4)/(3*omega1^4*omega2^2 - 39*omega1^2*omega2^4 + 108*omega2^6)
/// lumps[19]: harmonic_re_x_A_x_A_y2 = (6*omega1^4*omega2^2*b3 + 4*omega1^4*a2*a4 + 3*omega1^3*omega2^3*b3 +
/// 12*omega1^3*omega2*a2^2 + 2*omega1^3*omega2*a2*a4 - 24*omega1^2*omega2^4*b3 - 12*omega1^2*omega2^2*a1*a3 -
/// 16*omega1^2*omega2^2*a2*a4 + 24*omega1^2*omega2^2*a3^2 - 12*omega1*omega2^5*b3 - 6*omega1*omega2^3*a1*a3 -
/// 48*omega1*omega2^3*a2^2 - 8*omega1*omega2^3*a2*a4 - 36*omega1*omega2^3*a3^2 -
/// 24*omega2^4*a3^2)/(24*omega1^5*omega2^3 + 36*omega1^4*omega2^4 - 84*omega1^3*omega2^5 - 144*omega1^2*omega2^6
/// - 48*omega1*omega2^7)
/// lumps[20]: harmonic_re_x_A_x2_A_y = (36*omega1^5*omega2*b2 + 72*omega1^4*omega2^2*b2 + 24*omega1^4*a1*a2 -
/// 9*omega1^3*omega2^3*b2 + 44*omega1^3*omega2*a1*a2 + 54*omega1^3*omega2*a2*a3 - 18*omega1^2*omega2^4*b2 -
/// 8*omega1^2*omega2^2*a1*a2 + 12*omega1^2*omega2^2*a2*a3 - 2*omega1*omega2^3*a1*a2 - 12*omega1*omega2^3*a2*a3 -
/// 4*omega2^4*a1*a2)/(36*omega1^7*omega2 + 120*omega1^6*omega2^2 + 99*omega1^5*omega2^3 - 6*omega1^4*omega2^4 -
/// 27*omega1^3*omega2^5 - 6*omega1^2*omega2^6)
/// lumps[21]: harmonic_re_x_A_x3 = (12*omega1^4*b1 - 3*omega1^2*omega2^2*b1 + 8*omega1^2*a1^2 + 6*omega1^2*a2^2
/// - 2*omega2^2*a1^2)/(96*omega1^6 - 24*omega1^4*omega2^2)
/// lumps[22]: a4 = a4
/// lumps[23]: harmonic_re_y_A_y3 = (3*omega1^2*omega2^2*b5 + 2*omega1^2*a4^2 - 12*omega2^4*b5 - 6*omega2^2*a3^2
/// - 8*omega2^2*a4^2)/(24*omega1^2*omega2^4 - 96*omega2^6)
/// lumps[24]: harmonic_re_y_A_x_A_y2 = (18*omega1^4*omega2^2*b4 + 4*omega1^4*a3*a4 + 9*omega1^3*omega2^3*b4 +
/// 12*omega1^3*omega2*a2*a3 + 2*omega1^3*omega2*a3*a4 - 72*omega1^2*omega2^4*b4 - 12*omega1^2*omega2^2*a2*a3 +
/// 8*omega1^2*omega2^2*a3*a4 - 36*omega1*omega2^5*b4 - 54*omega1*omega2^3*a2*a3 - 44*omega1*omega2^3*a3*a4 -
/// 24*omega2^4*a3*a4)/(6*omega1^6*omega2^2 + 27*omega1^5*omega2^3 + 6*omega1^4*omega2^4 - 99*omega1^3*omega2^5 -
/// 120*omega1^2*omega2^6 - 36*omega1*omega2^7)
/// lumps[25]: harmonic_re_y_A_x2_A_y = (12*omega1^5*omega2*b3 + 24*omega1^4*omega2^2*b3 + 24*omega1^4*a2^2 -
/// 3*omega1^3*omega2^3*b3 + 8*omega1^3*omega2*a1*a3 + 36*omega1^3*omega2*a2^2 + 6*omega1^3*omega2*a2*a4 +
/// 48*omega1^3*omega2*a3^2 - 6*omega1^2*omega2^4*b3 + 16*omega1^2*omega2^2*a1*a3 - 24*omega1^2*omega2^2*a2^2 +
/// 12*omega1^2*omega2^2*a2*a4 - 2*omega1*omega2^3*a1*a3 - 12*omega1*omega2^3*a3^2 -
/// 4*omega2^4*a1*a3)/(48*omega1^7*omega2 + 144*omega1^6*omega2^2 + 84*omega1^5*omega2^3 - 36*omega1^4*omega2^4 -
/// 24*omega1^3*omega2^5)
/// lumps[26]: harmonic_re_y_A_x3 = (12*omega1^4*b2 - 3*omega1^2*omega2^2*b2 + 8*omega1^2*a1*a2 +
/// 6*omega1^2*a2*a3 - 2*omega2^2*a1*a2)/(108*omega1^6 - 39*omega1^4*omega2^2 + 3*omega1^2*omega2^4)
/// 946 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
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
  const Scalar a1_2 = a1 * a1;
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar a4_2 = a4 * a4;
  // conservative_x_A_x2_conjA_y
  lumps[0] = (Scalar(36.0) * omega1_5 * omega2 * b2 - Scalar(72.0) * omega1_4 * omega2_2 * b2
      - Scalar(24.0) * omega1_4 * a1 * a2 - Scalar(9.0) * omega1_3 * omega2_3 * b2
      + Scalar(44.0) * omega1_3 * omega2 * a1 * a2 + Scalar(54.0) * omega1_3 * omega2 * a2 * a3
      + Scalar(18.0) * omega1_2 * omega2_4 * b2 + Scalar(8.0) * omega1_2 * omega2_2 * a1 * a2
      - Scalar(12.0) * omega1_2 * omega2_2 * a2 * a3 - Scalar(2.0) * omega1 * omega2_3 * a1 * a2
      - Scalar(12.0) * omega1 * omega2_3 * a2 * a3
      + Scalar(4.0) * omega2_4 * a1 * a2) / (Scalar(24.0) * omega1_6 * omega2 - Scalar(48.0) * omega1_5 * omega2_2
      - Scalar(6.0) * omega1_4 * omega2_3 + Scalar(12.0) * omega1_3 * omega2_4);
  lumps[1] = mu1;  // mu1
  // conservative_x_A_x_A_y_conjA_y
  lumps[2] = (Scalar(4.0) * omega1_6 * omega2_2 * b3 - Scalar(8.0) * omega1_6 * a2 * a4
      - Scalar(17.0) * omega1_4 * omega2_4 * b3 - Scalar(8.0) * omega1_4 * omega2_2 * a1 * a3
      - Scalar(4.0) * omega1_4 * omega2_2 * a2_2 + Scalar(34.0) * omega1_4 * omega2_2 * a2 * a4
      + Scalar(16.0) * omega1_4 * omega2_2 * a3_2 + Scalar(4.0) * omega1_2 * omega2_6 * b3
      + Scalar(34.0) * omega1_2 * omega2_4 * a1 * a3 + Scalar(16.0) * omega1_2 * omega2_4 * a2_2
      - Scalar(8.0) * omega1_2 * omega2_4 * a2 * a4 - Scalar(4.0) * omega1_2 * omega2_4 * a3_2
      - Scalar(8.0) * omega2_6 * a1 * a3) / (Scalar(4.0) * omega1_7 * omega2_2
      - Scalar(17.0) * omega1_5 * omega2_4 + Scalar(4.0) * omega1_3 * omega2_6);
  // conservative_x_A_x2_conjA_x
  lumps[3] = (Scalar(36.0) * omega1_4 * omega2_2 * b1 - Scalar(48.0) * omega1_4 * a2_2
      - Scalar(9.0) * omega1_2 * omega2_4 * b1 - Scalar(40.0) * omega1_2 * omega2_2 * a1_2
      + Scalar(18.0) * omega1_2 * omega2_2 * a2_2
      + Scalar(10.0) * omega2_4 * a1_2) / (Scalar(24.0) * omega1_5 * omega2_2
      - Scalar(6.0) * omega1_3 * omega2_4);
  lumps[4] = e1;  // e1
  // conservative_x_A_y2_conjA_y
  lumps[5] = (Scalar(9.0) * omega1_4 * omega2_2 * b4 - Scalar(10.0) * omega1_4 * a3 * a4
      - Scalar(36.0) * omega1_2 * omega2_4 * b4 - Scalar(18.0) * omega1_2 * omega2_2 * a2 * a3
      + Scalar(40.0) * omega1_2 * omega2_2 * a3 * a4
      + Scalar(48.0) * omega2_4 * a2 * a3) / (Scalar(6.0) * omega1_5 * omega2_2
      - Scalar(24.0) * omega1_3 * omega2_4);
  // conservative_x_A_x_A_y_conjA_x
  lumps[6] = (Scalar(12.0) * omega1_6 * omega2_2 * b2 - Scalar(8.0) * omega1_6 * a2 * a3
      - Scalar(51.0) * omega1_4 * omega2_4 * b2 - Scalar(12.0) * omega1_4 * omega2_2 * a1 * a2
      + Scalar(50.0) * omega1_4 * omega2_2 * a2 * a3 + Scalar(12.0) * omega1_2 * omega2_6 * b2
      + Scalar(50.0) * omega1_2 * omega2_4 * a1 * a2 - Scalar(12.0) * omega1_2 * omega2_4 * a2 * a3
      - Scalar(8.0) * omega2_6 * a1 * a2) / (Scalar(4.0) * omega1_7 * omega2_2
      - Scalar(17.0) * omega1_5 * omega2_4 + Scalar(4.0) * omega1_3 * omega2_6);
  // conservative_x_A_y2_conjA_x
  lumps[7] = (Scalar(6.0) * omega1_4 * omega2_2 * b3 + Scalar(4.0) * omega1_4 * a2 * a4
      - Scalar(3.0) * omega1_3 * omega2_3 * b3 - Scalar(12.0) * omega1_3 * omega2 * a2_2
      - Scalar(2.0) * omega1_3 * omega2 * a2 * a4 - Scalar(24.0) * omega1_2 * omega2_4 * b3
      - Scalar(12.0) * omega1_2 * omega2_2 * a1 * a3 - Scalar(16.0) * omega1_2 * omega2_2 * a2 * a4
      + Scalar(24.0) * omega1_2 * omega2_2 * a3_2 + Scalar(12.0) * omega1 * omega2_5 * b3
      + Scalar(6.0) * omega1 * omega2_3 * a1 * a3 + Scalar(48.0) * omega1 * omega2_3 * a2_2
      + Scalar(8.0) * omega1 * omega2_3 * a2 * a4 + Scalar(36.0) * omega1 * omega2_3 * a3_2
      - Scalar(24.0) * omega2_4 * a3_2) / (Scalar(12.0) * omega1_5 * omega2_2 - Scalar(6.0) * omega1_4 * omega2_3
      - Scalar(48.0) * omega1_3 * omega2_4 + Scalar(24.0) * omega1_2 * omega2_5);
  // conservative_y_A_x2_conjA_y
  lumps[8] = (Scalar(12.0) * omega1_5 * omega2 * b3 - Scalar(24.0) * omega1_4 * omega2_2 * b3
      - Scalar(24.0) * omega1_4 * a2_2 - Scalar(3.0) * omega1_3 * omega2_3 * b3
      + Scalar(8.0) * omega1_3 * omega2 * a1 * a3 + Scalar(36.0) * omega1_3 * omega2 * a2_2
      + Scalar(6.0) * omega1_3 * omega2 * a2 * a4 + Scalar(48.0) * omega1_3 * omega2 * a3_2
      + Scalar(6.0) * omega1_2 * omega2_4 * b3 - Scalar(16.0) * omega1_2 * omega2_2 * a1 * a3
      + Scalar(24.0) * omega1_2 * omega2_2 * a2_2 - Scalar(12.0) * omega1_2 * omega2_2 * a2 * a4
      - Scalar(2.0) * omega1 * omega2_3 * a1 * a3 - Scalar(12.0) * omega1 * omega2_3 * a3_2
      + Scalar(4.0) * omega2_4 * a1 * a3) / (Scalar(24.0) * omega1_5 * omega2_2
      - Scalar(48.0) * omega1_4 * omega2_3 - Scalar(6.0) * omega1_3 * omega2_4
      + Scalar(12.0) * omega1_2 * omega2_5);
  // conservative_y_A_x_A_y_conjA_y
  lumps[9] = (Scalar(12.0) * omega1_6 * omega2_2 * b4 - Scalar(8.0) * omega1_6 * a3 * a4
      - Scalar(51.0) * omega1_4 * omega2_4 * b4 - Scalar(12.0) * omega1_4 * omega2_2 * a2 * a3
      + Scalar(50.0) * omega1_4 * omega2_2 * a3 * a4 + Scalar(12.0) * omega1_2 * omega2_6 * b4
      + Scalar(50.0) * omega1_2 * omega2_4 * a2 * a3 - Scalar(12.0) * omega1_2 * omega2_4 * a3 * a4
      - Scalar(8.0) * omega2_6 * a2 * a3) / (Scalar(4.0) * omega1_6 * omega2_3
      - Scalar(17.0) * omega1_4 * omega2_5 + Scalar(4.0) * omega1_2 * omega2_7);
  // conservative_y_A_x2_conjA_x
  lumps[10] = (Scalar(36.0) * omega1_4 * omega2_2 * b2 - Scalar(48.0) * omega1_4 * a2 * a3
      - Scalar(9.0) * omega1_2 * omega2_4 * b2 - Scalar(40.0) * omega1_2 * omega2_2 * a1 * a2
      + Scalar(18.0) * omega1_2 * omega2_2 * a2 * a3
      + Scalar(10.0) * omega2_4 * a1 * a2) / (Scalar(24.0) * omega1_4 * omega2_3
      - Scalar(6.0) * omega1_2 * omega2_5);
  lumps[11] = e2;  // e2
  lumps[12] = mu2;  // mu2
  // conservative_y_A_y2_conjA_y
  lumps[13] = (Scalar(9.0) * omega1_4 * omega2_2 * b5 - Scalar(10.0) * omega1_4 * a4_2
      - Scalar(36.0) * omega1_2 * omega2_4 * b5 - Scalar(18.0) * omega1_2 * omega2_2 * a3_2
      + Scalar(40.0) * omega1_2 * omega2_2 * a4_2
      + Scalar(48.0) * omega2_4 * a3_2) / (Scalar(6.0) * omega1_4 * omega2_3
      - Scalar(24.0) * omega1_2 * omega2_5);
  // conservative_y_A_y2_conjA_x
  lumps[14] = (Scalar(18.0) * omega1_4 * omega2_2 * b4 + Scalar(4.0) * omega1_4 * a3 * a4
      - Scalar(9.0) * omega1_3 * omega2_3 * b4 - Scalar(12.0) * omega1_3 * omega2 * a2 * a3
      - Scalar(2.0) * omega1_3 * omega2 * a3 * a4 - Scalar(72.0) * omega1_2 * omega2_4 * b4
      - Scalar(12.0) * omega1_2 * omega2_2 * a2 * a3 + Scalar(8.0) * omega1_2 * omega2_2 * a3 * a4
      + Scalar(36.0) * omega1 * omega2_5 * b4 + Scalar(54.0) * omega1 * omega2_3 * a2 * a3
      + Scalar(44.0) * omega1 * omega2_3 * a3 * a4
      - Scalar(24.0) * omega2_4 * a3 * a4) / (Scalar(12.0) * omega1_4 * omega2_3
      - Scalar(6.0) * omega1_3 * omega2_4 - Scalar(48.0) * omega1_2 * omega2_5
      + Scalar(24.0) * omega1 * omega2_6);
  lumps[15] = a2;  // a2
  lumps[16] = a3;  // a3
  lumps[17] = a1;  // a1
  // harmonic_re_x_A_y3
  lumps[18] = (-Scalar(3.0) * omega1_2 * omega2_2 * b4 - Scalar(2.0) * omega1_2 * a3 * a4
      + Scalar(12.0) * omega2_4 * b4 + Scalar(6.0) * omega2_2 * a2 * a3
      + Scalar(8.0) * omega2_2 * a3 * a4) / (Scalar(3.0) * omega1_4 * omega2_2
      - Scalar(39.0) * omega1_2 * omega2_4 + Scalar(108.0) * omega2_6);
  // harmonic_re_x_A_x_A_y2
  lumps[19] = (Scalar(6.0) * omega1_4 * omega2_2 * b3 + Scalar(4.0) * omega1_4 * a2 * a4
      + Scalar(3.0) * omega1_3 * omega2_3 * b3 + Scalar(12.0) * omega1_3 * omega2 * a2_2
      + Scalar(2.0) * omega1_3 * omega2 * a2 * a4 - Scalar(24.0) * omega1_2 * omega2_4 * b3
      - Scalar(12.0) * omega1_2 * omega2_2 * a1 * a3 - Scalar(16.0) * omega1_2 * omega2_2 * a2 * a4
      + Scalar(24.0) * omega1_2 * omega2_2 * a3_2 - Scalar(12.0) * omega1 * omega2_5 * b3
      - Scalar(6.0) * omega1 * omega2_3 * a1 * a3 - Scalar(48.0) * omega1 * omega2_3 * a2_2
      - Scalar(8.0) * omega1 * omega2_3 * a2 * a4 - Scalar(36.0) * omega1 * omega2_3 * a3_2
      - Scalar(24.0) * omega2_4 * a3_2) / (Scalar(24.0) * omega1_5 * omega2_3 + Scalar(36.0) * omega1_4 * omega2_4
      - Scalar(84.0) * omega1_3 * omega2_5 - Scalar(144.0) * omega1_2 * omega2_6
      - Scalar(48.0) * omega1 * omega2_7);
  // harmonic_re_x_A_x2_A_y
  lumps[20] = (Scalar(36.0) * omega1_5 * omega2 * b2 + Scalar(72.0) * omega1_4 * omega2_2 * b2
      + Scalar(24.0) * omega1_4 * a1 * a2 - Scalar(9.0) * omega1_3 * omega2_3 * b2
      + Scalar(44.0) * omega1_3 * omega2 * a1 * a2 + Scalar(54.0) * omega1_3 * omega2 * a2 * a3
      - Scalar(18.0) * omega1_2 * omega2_4 * b2 - Scalar(8.0) * omega1_2 * omega2_2 * a1 * a2
      + Scalar(12.0) * omega1_2 * omega2_2 * a2 * a3 - Scalar(2.0) * omega1 * omega2_3 * a1 * a2
      - Scalar(12.0) * omega1 * omega2_3 * a2 * a3
      - Scalar(4.0) * omega2_4 * a1 * a2) / (Scalar(36.0) * omega1_7 * omega2
      + Scalar(120.0) * omega1_6 * omega2_2 + Scalar(99.0) * omega1_5 * omega2_3
      - Scalar(6.0) * omega1_4 * omega2_4 - Scalar(27.0) * omega1_3 * omega2_5
      - Scalar(6.0) * omega1_2 * omega2_6);
  // harmonic_re_x_A_x3
  lumps[21] = (Scalar(12.0) * omega1_4 * b1 - Scalar(3.0) * omega1_2 * omega2_2 * b1
      + Scalar(8.0) * omega1_2 * a1_2 + Scalar(6.0) * omega1_2 * a2_2
      - Scalar(2.0) * omega2_2 * a1_2) / (Scalar(96.0) * omega1_6 - Scalar(24.0) * omega1_4 * omega2_2);
  lumps[22] = a4;  // a4
  // harmonic_re_y_A_y3
  lumps[23] = (Scalar(3.0) * omega1_2 * omega2_2 * b5 + Scalar(2.0) * omega1_2 * a4_2
      - Scalar(12.0) * omega2_4 * b5 - Scalar(6.0) * omega2_2 * a3_2
      - Scalar(8.0) * omega2_2 * a4_2) / (Scalar(24.0) * omega1_2 * omega2_4 - Scalar(96.0) * omega2_6);
  // harmonic_re_y_A_x_A_y2
  lumps[24] = (Scalar(18.0) * omega1_4 * omega2_2 * b4 + Scalar(4.0) * omega1_4 * a3 * a4
      + Scalar(9.0) * omega1_3 * omega2_3 * b4 + Scalar(12.0) * omega1_3 * omega2 * a2 * a3
      + Scalar(2.0) * omega1_3 * omega2 * a3 * a4 - Scalar(72.0) * omega1_2 * omega2_4 * b4
      - Scalar(12.0) * omega1_2 * omega2_2 * a2 * a3 + Scalar(8.0) * omega1_2 * omega2_2 * a3 * a4
      - Scalar(36.0) * omega1 * omega2_5 * b4 - Scalar(54.0) * omega1 * omega2_3 * a2 * a3
      - Scalar(44.0) * omega1 * omega2_3 * a3 * a4
      - Scalar(24.0) * omega2_4 * a3 * a4) / (Scalar(6.0) * omega1_6 * omega2_2
      + Scalar(27.0) * omega1_5 * omega2_3 + Scalar(6.0) * omega1_4 * omega2_4
      - Scalar(99.0) * omega1_3 * omega2_5 - Scalar(120.0) * omega1_2 * omega2_6
      - Scalar(36.0) * omega1 * omega2_7);
  // harmonic_re_y_A_x2_A_y
  lumps[25] = (Scalar(12.0) * omega1_5 * omega2 * b3 + Scalar(24.0) * omega1_4 * omega2_2 * b3
      + Scalar(24.0) * omega1_4 * a2_2 - Scalar(3.0) * omega1_3 * omega2_3 * b3
      + Scalar(8.0) * omega1_3 * omega2 * a1 * a3 + Scalar(36.0) * omega1_3 * omega2 * a2_2
      + Scalar(6.0) * omega1_3 * omega2 * a2 * a4 + Scalar(48.0) * omega1_3 * omega2 * a3_2
      - Scalar(6.0) * omega1_2 * omega2_4 * b3 + Scalar(16.0) * omega1_2 * omega2_2 * a1 * a3
      - Scalar(24.0) * omega1_2 * omega2_2 * a2_2 + Scalar(12.0) * omega1_2 * omega2_2 * a2 * a4
      - Scalar(2.0) * omega1 * omega2_3 * a1 * a3 - Scalar(12.0) * omega1 * omega2_3 * a3_2
      - Scalar(4.0) * omega2_4 * a1 * a3) / (Scalar(48.0) * omega1_7 * omega2
      + Scalar(144.0) * omega1_6 * omega2_2 + Scalar(84.0) * omega1_5 * omega2_3
      - Scalar(36.0) * omega1_4 * omega2_4 - Scalar(24.0) * omega1_3 * omega2_5);
  // harmonic_re_y_A_x3
  lumps[26] = (Scalar(12.0) * omega1_4 * b2 - Scalar(3.0) * omega1_2 * omega2_2 * b2
      + Scalar(8.0) * omega1_2 * a1 * a2 + Scalar(6.0) * omega1_2 * a2 * a3
      - Scalar(2.0) * omega2_2 * a1 * a2) / (Scalar(108.0) * omega1_6 - Scalar(39.0) * omega1_4 * omega2_2
      + Scalar(3.0) * omega1_2 * omega2_4);
}

/// gradient[p] = d conservative_x_A_x2_conjA_y / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 110 operations.
template <class Scalar>
void lump_gradient_0(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar b2 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega1_6 = omega1_5 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar denominator = Scalar(24.0) * omega1_6 * omega2 - Scalar(48.0) * omega1_5 * omega2_2
      - Scalar(6.0) * omega1_4 * omega2_3 + Scalar(12.0) * omega1_3 * omega2_4;
  // multiplies a1*a2
  const Scalar c_0 = -Scalar(24.0) * omega1_4 + Scalar(44.0) * omega1_3 * omega2
      + Scalar(8.0) * omega1_2 * omega2_2 - Scalar(2.0) * omega1 * omega2_3 + Scalar(4.0) * omega2_4;
  // multiplies a2*a3
  const Scalar c_1 = Scalar(54.0) * omega1_3 * omega2 - Scalar(12.0) * omega1_2 * omega2_2
      - Scalar(12.0) * omega1 * omega2_3;
  // multiplies b2
  const Scalar c_2 = Scalar(36.0) * omega1_5 * omega2 - Scalar(72.0) * omega1_4 * omega2_2
      - Scalar(9.0) * omega1_3 * omega2_3 + Scalar(18.0) * omega1_2 * omega2_4;
  const Scalar w_0 = Scalar(36.0) * b2;  // multiplies omega1^5*omega2
  const Scalar w_1 = -Scalar(72.0) * b2;  // multiplies omega1^4*omega2^2
  const Scalar w_2 = -Scalar(24.0) * a1 * a2;  // multiplies omega1^4
  const Scalar w_3 = -Scalar(9.0) * b2;  // multiplies omega1^3*omega2^3
  const Scalar w_4 = Scalar(44.0) * a1 * a2 + Scalar(54.0) * a2 * a3;  // multiplies omega1^3*omega2
  const Scalar w_5 = Scalar(18.0) * b2;  // multiplies omega1^2*omega2^4
  const Scalar w_6 = Scalar(8.0) * a1 * a2 - Scalar(12.0) * a2 * a3;  // multiplies omega1^2*omega2^2
  const Scalar w_7 = -Scalar(2.0) * a1 * a2 - Scalar(12.0) * a2 * a3;  // multiplies omega1*omega2^3
  const Scalar w_8 = Scalar(4.0) * a1 * a2;  // multiplies omega2^4
  // by omega1
  gradient[0] = (Scalar(5.0) * omega1_4 * omega2 * w_0 + Scalar(4.0) * omega1_3 * omega2_2 * w_1
      + Scalar(4.0) * omega1_3 * w_2 + Scalar(3.0) * omega1_2 * omega2_3 * w_3
      + Scalar(3.0) * omega1_2 * omega2 * w_4 + Scalar(2.0) * omega1 * omega2_4 * w_5
      + Scalar(2.0) * omega1 * omega2_2 * w_6 + omega2_3 * w_7 - lump * (Scalar(144.0) * omega1_5 * omega2
      - Scalar(240.0) * omega1_4 * omega2_2 - Scalar(24.0) * omega1_3 * omega2_3
      + Scalar(36.0) * omega1_2 * omega2_4)) / denominator;
  // by omega2
  gradient[1] = (omega1_5 * w_0 + Scalar(2.0) * omega1_4 * omega2 * w_1 + Scalar(3.0) * omega1_3 * omega2_2 * w_3
      + omega1_3 * w_4 + Scalar(4.0) * omega1_2 * omega2_3 * w_5 + Scalar(2.0) * omega1_2 * omega2 * w_6
      + Scalar(3.0) * omega1 * omega2_2 * w_7 + Scalar(4.0) * omega2_3 * w_8 - lump * (Scalar(24.0) * omega1_6
      - Scalar(96.0) * omega1_5 * omega2 - Scalar(18.0) * omega1_4 * omega2_2
      + Scalar(48.0) * omega1_3 * omega2_3)) / denominator;
  gradient[2] = (a2 * c_0) / denominator;  // by a1
  gradient[3] = (a1 * c_0 + a3 * c_1) / denominator;  // by a2
  gradient[4] = (a2 * c_1) / denominator;  // by a3
  gradient[7] = (c_2) / denominator;  // by b2
}

/// gradient[p] = d conservative_x_A_x_A_y_conjA_y / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 105 operations.
template <class Scalar>
void lump_gradient_2(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
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
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar denominator = Scalar(4.0) * omega1_7 * omega2_2 - Scalar(17.0) * omega1_5 * omega2_4
      + Scalar(4.0) * omega1_3 * omega2_6;
  // multiplies a1*a3
  const Scalar c_0 = -Scalar(8.0) * omega1_4 * omega2_2 + Scalar(34.0) * omega1_2 * omega2_4
      - Scalar(8.0) * omega2_6;
  const Scalar c_1 = -Scalar(4.0) * omega1_4 * omega2_2 + Scalar(16.0) * omega1_2 * omega2_4;  // multiplies a2^2
  // multiplies a2*a4
  const Scalar c_2 = -Scalar(8.0) * omega1_6 + Scalar(34.0) * omega1_4 * omega2_2
      - Scalar(8.0) * omega1_2 * omega2_4;
  const Scalar c_3 = Scalar(16.0) * omega1_4 * omega2_2 - Scalar(4.0) * omega1_2 * omega2_4;  // multiplies a3^2
  // multiplies b3
  const Scalar c_4 = Scalar(4.0) * omega1_6 * omega2_2 - Scalar(17.0) * omega1_4 * omega2_4
      + Scalar(4.0) * omega1_2 * omega2_6;
  const Scalar w_0 = Scalar(4.0) * b3;  // multiplies omega1^6*omega2^2
  const Scalar w_1 = -Scalar(8.0) * a2 * a4;  // multiplies omega1^6
  const Scalar w_2 = -Scalar(17.0) * b3;  // multiplies omega1^4*omega2^4
  // multiplies omega1^4*omega2^2
  const Scalar w_3 = -Scalar(8.0) * a1 * a3 - Scalar(4.0) * a2_2 + Scalar(34.0) * a2 * a4 + Scalar(16.0) * a3_2;
  const Scalar w_4 = Scalar(4.0) * b3;  // multiplies omega1^2*omega2^6
  // multiplies omega1^2*omega2^4
  const Scalar w_5 = Scalar(34.0) * a1 * a3 + Scalar(16.0) * a2_2 - Scalar(8.0) * a2 * a4 - Scalar(4.0) * a3_2;
  const Scalar w_6 = -Scalar(8.0) * a1 * a3;  // multiplies omega2^6
  // by omega1
  gradient[0] = (Scalar(6.0) * omega1_5 * omega2_2 * w_0 + Scalar(6.0) * omega1_5 * w_1
      + Scalar(4.0) * omega1_3 * omega2_4 * w_2 + Scalar(4.0) * omega1_3 * omega2_2 * w_3
      + Scalar(2.0) * omega1 * omega2_6 * w_4 + Scalar(2.0) * omega1 * omega2_4 * w_5
      - lump * (Scalar(28.0) * omega1_6 * omega2_2 - Scalar(85.0) * omega1_4 * omega2_4
      + Scalar(12.0) * omega1_2 * omega2_6)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_6 * omega2 * w_0 + Scalar(4.0) * omega1_4 * omega2_3 * w_2
      + Scalar(2.0) * omega1_4 * omega2 * w_3 + Scalar(6.0) * omega1_2 * omega2_5 * w_4
      + Scalar(4.0) * omega1_2 * omega2_3 * w_5 + Scalar(6.0) * omega2_5 * w_6
      - lump * (Scalar(8.0) * omega1_7 * omega2 - Scalar(68.0) * omega1_5 * omega2_3
      + Scalar(24.0) * omega1_3 * omega2_5)) / denominator;
  gradient[2] = (a3 * c_0) / denominator;  // by a1
  gradient[3] = (Scalar(2.0) * a2 * c_1 + a4 * c_2) / denominator;  // by a2
  gradient[4] = (a1 * c_0 + Scalar(2.0) * a3 * c_3) / denominator;  // by a3
  gradient[5] = (a2 * c_2) / denominator;  // by a4
  gradient[8] = (c_4) / denominator;  // by b3
}

/// gradient[p] = d conservative_x_A_x2_conjA_x / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 68 operations.
template <class Scalar>
void lump_gradient_3(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar b1 = parameters[6];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar a1_2 = a1 * a1;
  const Scalar a2_2 = a2 * a2;
  const Scalar denominator = Scalar(24.0) * omega1_5 * omega2_2 - Scalar(6.0) * omega1_3 * omega2_4;
  // by omega1
  gradient[0] = (Scalar(144.0) * omega1_3 * omega2_2 * b1 - Scalar(192.0) * omega1_3 * a2_2
      - Scalar(18.0) * omega1 * omega2_4 * b1 - Scalar(80.0) * omega1 * omega2_2 * a1_2
      + Scalar(36.0) * omega1 * omega2_2 * a2_2 - lump * (Scalar(120.0) * omega1_4 * omega2_2
      - Scalar(18.0) * omega1_2 * omega2_4)) / denominator;
  // by omega2
  gradient[1] = (Scalar(72.0) * omega1_4 * omega2 * b1 - Scalar(36.0) * omega1_2 * omega2_3 * b1
      - Scalar(80.0) * omega1_2 * omega2 * a1_2 + Scalar(36.0) * omega1_2 * omega2 * a2_2
      + Scalar(40.0) * omega2_3 * a1_2 - lump * (Scalar(48.0) * omega1_5 * omega2
      - Scalar(24.0) * omega1_3 * omega2_3)) / denominator;
  gradient[2] = (-Scalar(80.0) * omega1_2 * omega2_2 * a1 + Scalar(20.0) * omega2_4 * a1) / denominator;  // by a1
  gradient[3] = (-Scalar(96.0) * omega1_4 * a2 + Scalar(36.0) * omega1_2 * omega2_2 * a2) / denominator;  // by a2
  gradient[6] = (Scalar(36.0) * omega1_4 * omega2_2 - Scalar(9.0) * omega1_2 * omega2_4) / denominator;  // by b1
}

/// gradient[p] = d conservative_x_A_y2_conjA_y / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 87 operations.
template <class Scalar>
void lump_gradient_5(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar denominator = Scalar(6.0) * omega1_5 * omega2_2 - Scalar(24.0) * omega1_3 * omega2_4;
  // by omega1
  gradient[0] = (Scalar(36.0) * omega1_3 * omega2_2 * b4 - Scalar(40.0) * omega1_3 * a3 * a4
      - Scalar(72.0) * omega1 * omega2_4 * b4 - Scalar(36.0) * omega1 * omega2_2 * a2 * a3
      + Scalar(80.0) * omega1 * omega2_2 * a3 * a4 - lump * (Scalar(30.0) * omega1_4 * omega2_2
      - Scalar(72.0) * omega1_2 * omega2_4)) / denominator;
  // by omega2
  gradient[1] = (Scalar(18.0) * omega1_4 * omega2 * b4 - Scalar(144.0) * omega1_2 * omega2_3 * b4
      - Scalar(36.0) * omega1_2 * omega2 * a2 * a3 + Scalar(80.0) * omega1_2 * omega2 * a3 * a4
      + Scalar(192.0) * omega2_3 * a2 * a3 - lump * (Scalar(12.0) * omega1_5 * omega2
      - Scalar(96.0) * omega1_3 * omega2_3)) / denominator;
  gradient[3] = (-Scalar(18.0) * omega1_2 * omega2_2 * a3 + Scalar(48.0) * omega2_4 * a3) / denominator;  // by a2
  // by a3
  gradient[4] = (-Scalar(10.0) * omega1_4 * a4 - Scalar(18.0) * omega1_2 * omega2_2 * a2
      + Scalar(40.0) * omega1_2 * omega2_2 * a4 + Scalar(48.0) * omega2_4 * a2) / denominator;
  gradient[5] = (-Scalar(10.0) * omega1_4 * a3 + Scalar(40.0) * omega1_2 * omega2_2 * a3) / denominator;  // by a4
  gradient[9] = (Scalar(9.0) * omega1_4 * omega2_2 - Scalar(36.0) * omega1_2 * omega2_4) / denominator;  // by b4
}

/// gradient[p] = d conservative_x_A_x_A_y_conjA_x / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 85 operations.
template <class Scalar>
void lump_gradient_6(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar b2 = parameters[7];
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
  const Scalar denominator = Scalar(4.0) * omega1_7 * omega2_2 - Scalar(17.0) * omega1_5 * omega2_4
      + Scalar(4.0) * omega1_3 * omega2_6;
  // multiplies a1*a2
  const Scalar c_0 = -Scalar(12.0) * omega1_4 * omega2_2 + Scalar(50.0) * omega1_2 * omega2_4
      - Scalar(8.0) * omega2_6;
  // multiplies a2*a3
  const Scalar c_1 = -Scalar(8.0) * omega1_6 + Scalar(50.0) * omega1_4 * omega2_2
      - Scalar(12.0) * omega1_2 * omega2_4;
  // multiplies b2
  const Scalar c_2 = Scalar(12.0) * omega1_6 * omega2_2 - Scalar(51.0) * omega1_4 * omega2_4
      + Scalar(12.0) * omega1_2 * omega2_6;
  const Scalar w_0 = Scalar(12.0) * b2;  // multiplies omega1^6*omega2^2
  const Scalar w_1 = -Scalar(8.0) * a2 * a3;  // multiplies omega1^6
  const Scalar w_2 = -Scalar(51.0) * b2;  // multiplies omega1^4*omega2^4
  const Scalar w_3 = -Scalar(12.0) * a1 * a2 + Scalar(50.0) * a2 * a3;  // multiplies omega1^4*omega2^2
  const Scalar w_4 = Scalar(12.0) * b2;  // multiplies omega1^2*omega2^6
  const Scalar w_5 = Scalar(50.0) * a1 * a2 - Scalar(12.0) * a2 * a3;  // multiplies omega1^2*omega2^4
  const Scalar w_6 = -Scalar(8.0) * a1 * a2;  // multiplies omega2^6
  // by omega1
  gradient[0] = (Scalar(6.0) * omega1_5 * omega2_2 * w_0 + Scalar(6.0) * omega1_5 * w_1
      + Scalar(4.0) * omega1_3 * omega2_4 * w_2 + Scalar(4.0) * omega1_3 * omega2_2 * w_3
      + Scalar(2.0) * omega1 * omega2_6 * w_4 + Scalar(2.0) * omega1 * omega2_4 * w_5
      - lump * (Scalar(28.0) * omega1_6 * omega2_2 - Scalar(85.0) * omega1_4 * omega2_4
      + Scalar(12.0) * omega1_2 * omega2_6)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_6 * omega2 * w_0 + Scalar(4.0) * omega1_4 * omega2_3 * w_2
      + Scalar(2.0) * omega1_4 * omega2 * w_3 + Scalar(6.0) * omega1_2 * omega2_5 * w_4
      + Scalar(4.0) * omega1_2 * omega2_3 * w_5 + Scalar(6.0) * omega2_5 * w_6
      - lump * (Scalar(8.0) * omega1_7 * omega2 - Scalar(68.0) * omega1_5 * omega2_3
      + Scalar(24.0) * omega1_3 * omega2_5)) / denominator;
  gradient[2] = (a2 * c_0) / denominator;  // by a1
  gradient[3] = (a1 * c_0 + a3 * c_1) / denominator;  // by a2
  gradient[4] = (a2 * c_1) / denominator;  // by a3
  gradient[7] = (c_2) / denominator;  // by b2
}

/// gradient[p] = d conservative_x_A_y2_conjA_x / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 124 operations.
template <class Scalar>
void lump_gradient_7(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar denominator = Scalar(12.0) * omega1_5 * omega2_2 - Scalar(6.0) * omega1_4 * omega2_3
      - Scalar(48.0) * omega1_3 * omega2_4 + Scalar(24.0) * omega1_2 * omega2_5;
  const Scalar c_0 = -Scalar(12.0) * omega1_2 * omega2_2 + Scalar(6.0) * omega1 * omega2_3;  // multiplies a1*a3
  const Scalar c_1 = -Scalar(12.0) * omega1_3 * omega2 + Scalar(48.0) * omega1 * omega2_3;  // multiplies a2^2
  // multiplies a2*a4
  const Scalar c_2 = Scalar(4.0) * omega1_4 - Scalar(2.0) * omega1_3 * omega2 - Scalar(16.0) * omega1_2 * omega2_2
      + Scalar(8.0) * omega1 * omega2_3;
  // multiplies a3^2
  const Scalar c_3 = Scalar(24.0) * omega1_2 * omega2_2 + Scalar(36.0) * omega1 * omega2_3
      - Scalar(24.0) * omega2_4;
  // multiplies b3
  const Scalar c_4 = Scalar(6.0) * omega1_4 * omega2_2 - Scalar(3.0) * omega1_3 * omega2_3
      - Scalar(24.0) * omega1_2 * omega2_4 + Scalar(12.0) * omega1 * omega2_5;
  const Scalar w_0 = Scalar(6.0) * b3;  // multiplies omega1^4*omega2^2
  const Scalar w_1 = Scalar(4.0) * a2 * a4;  // multiplies omega1^4
  const Scalar w_2 = -Scalar(3.0) * b3;  // multiplies omega1^3*omega2^3
  const Scalar w_3 = -Scalar(12.0) * a2_2 - Scalar(2.0) * a2 * a4;  // multiplies omega1^3*omega2
  const Scalar w_4 = -Scalar(24.0) * b3;  // multiplies omega1^2*omega2^4
  // multiplies omega1^2*omega2^2
  const Scalar w_5 = -Scalar(12.0) * a1 * a3 - Scalar(16.0) * a2 * a4 + Scalar(24.0) * a3_2;
  const Scalar w_6 = Scalar(12.0) * b3;  // multiplies omega1*omega2^5
  // multiplies omega1*omega2^3
  const Scalar w_7 = Scalar(6.0) * a1 * a3 + Scalar(48.0) * a2_2 + Scalar(8.0) * a2 * a4 + Scalar(36.0) * a3_2;
  const Scalar w_8 = -Scalar(24.0) * a3_2;  // multiplies omega2^4
  // by omega1
  gradient[0] = (Scalar(4.0) * omega1_3 * omega2_2 * w_0 + Scalar(4.0) * omega1_3 * w_1
      + Scalar(3.0) * omega1_2 * omega2_3 * w_2 + Scalar(3.0) * omega1_2 * omega2 * w_3
      + Scalar(2.0) * omega1 * omega2_4 * w_4 + Scalar(2.0) * omega1 * omega2_2 * w_5 + omega2_5 * w_6
      + omega2_3 * w_7 - lump * (Scalar(60.0) * omega1_4 * omega2_2 - Scalar(24.0) * omega1_3 * omega2_3
      - Scalar(144.0) * omega1_2 * omega2_4 + Scalar(48.0) * omega1 * omega2_5)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_4 * omega2 * w_0 + Scalar(3.0) * omega1_3 * omega2_2 * w_2 + omega1_3 * w_3
      + Scalar(4.0) * omega1_2 * omega2_3 * w_4 + Scalar(2.0) * omega1_2 * omega2 * w_5
      + Scalar(5.0) * omega1 * omega2_4 * w_6 + Scalar(3.0) * omega1 * omega2_2 * w_7
      + Scalar(4.0) * omega2_3 * w_8 - lump * (Scalar(24.0) * omega1_5 * omega2
      - Scalar(18.0) * omega1_4 * omega2_2 - Scalar(192.0) * omega1_3 * omega2_3
      + Scalar(120.0) * omega1_2 * omega2_4)) / denominator;
  gradient[2] = (a3 * c_0) / denominator;  // by a1
  gradient[3] = (Scalar(2.0) * a2 * c_1 + a4 * c_2) / denominator;  // by a2
  gradient[4] = (a1 * c_0 + Scalar(2.0) * a3 * c_3) / denominator;  // by a3
  gradient[5] = (a2 * c_2) / denominator;  // by a4
  gradient[8] = (c_4) / denominator;  // by b3
}

/// gradient[p] = d conservative_y_A_x2_conjA_y / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 124 operations.
template <class Scalar>
void lump_gradient_8(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar denominator = Scalar(24.0) * omega1_5 * omega2_2 - Scalar(48.0) * omega1_4 * omega2_3
      - Scalar(6.0) * omega1_3 * omega2_4 + Scalar(12.0) * omega1_2 * omega2_5;
  // multiplies a1*a3
  const Scalar c_0 = Scalar(8.0) * omega1_3 * omega2 - Scalar(16.0) * omega1_2 * omega2_2
      - Scalar(2.0) * omega1 * omega2_3 + Scalar(4.0) * omega2_4;
  // multiplies a2^2
  const Scalar c_1 = -Scalar(24.0) * omega1_4 + Scalar(36.0) * omega1_3 * omega2
      + Scalar(24.0) * omega1_2 * omega2_2;
  const Scalar c_2 = Scalar(6.0) * omega1_3 * omega2 - Scalar(12.0) * omega1_2 * omega2_2;  // multiplies a2*a4
  const Scalar c_3 = Scalar(48.0) * omega1_3 * omega2 - Scalar(12.0) * omega1 * omega2_3;  // multiplies a3^2
  // multiplies b3
  const Scalar c_4 = Scalar(12.0) * omega1_5 * omega2 - Scalar(24.0) * omega1_4 * omega2_2
      - Scalar(3.0) * omega1_3 * omega2_3 + Scalar(6.0) * omega1_2 * omega2_4;
  const Scalar w_0 = Scalar(12.0) * b3;  // multiplies omega1^5*omega2
  const Scalar w_1 = -Scalar(24.0) * b3;  // multiplies omega1^4*omega2^2
  const Scalar w_2 = -Scalar(24.0) * a2_2;  // multiplies omega1^4
  const Scalar w_3 = -Scalar(3.0) * b3;  // multiplies omega1^3*omega2^3
  // multiplies omega1^3*omega2
  const Scalar w_4 = Scalar(8.0) * a1 * a3 + Scalar(36.0) * a2_2 + Scalar(6.0) * a2 * a4 + Scalar(48.0) * a3_2;
  const Scalar w_5 = Scalar(6.0) * b3;  // multiplies omega1^2*omega2^4
  // multiplies omega1^2*omega2^2
  const Scalar w_6 = -Scalar(16.0) * a1 * a3 + Scalar(24.0) * a2_2 - Scalar(12.0) * a2 * a4;
  const Scalar w_7 = -Scalar(2.0) * a1 * a3 - Scalar(12.0) * a3_2;  // multiplies omega1*omega2^3
  const Scalar w_8 = Scalar(4.0) * a1 * a3;  // multiplies omega2^4
  // by omega1
  gradient[0] = (Scalar(5.0) * omega1_4 * omega2 * w_0 + Scalar(4.0) * omega1_3 * omega2_2 * w_1
      + Scalar(4.0) * omega1_3 * w_2 + Scalar(3.0) * omega1_2 * omega2_3 * w_3
      + Scalar(3.0) * omega1_2 * omega2 * w_4 + Scalar(2.0) * omega1 * omega2_4 * w_5
      + Scalar(2.0) * omega1 * omega2_2 * w_6 + omega2_3 * w_7 - lump * (Scalar(120.0) * omega1_4 * omega2_2
      - Scalar(192.0) * omega1_3 * omega2_3 - Scalar(18.0) * omega1_2 * omega2_4
      + Scalar(24.0) * omega1 * omega2_5)) / denominator;
  // by omega2
  gradient[1] = (omega1_5 * w_0 + Scalar(2.0) * omega1_4 * omega2 * w_1 + Scalar(3.0) * omega1_3 * omega2_2 * w_3
      + omega1_3 * w_4 + Scalar(4.0) * omega1_2 * omega2_3 * w_5 + Scalar(2.0) * omega1_2 * omega2 * w_6
      + Scalar(3.0) * omega1 * omega2_2 * w_7 + Scalar(4.0) * omega2_3 * w_8
      - lump * (Scalar(48.0) * omega1_5 * omega2 - Scalar(144.0) * omega1_4 * omega2_2
      - Scalar(24.0) * omega1_3 * omega2_3 + Scalar(60.0) * omega1_2 * omega2_4)) / denominator;
  gradient[2] = (a3 * c_0) / denominator;  // by a1
  gradient[3] = (Scalar(2.0) * a2 * c_1 + a4 * c_2) / denominator;  // by a2
  gradient[4] = (a1 * c_0 + Scalar(2.0) * a3 * c_3) / denominator;  // by a3
  gradient[5] = (a2 * c_2) / denominator;  // by a4
  gradient[8] = (c_4) / denominator;  // by b3
}

/// gradient[p] = d conservative_y_A_x_A_y_conjA_y / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 85 operations.
template <class Scalar>
void lump_gradient_9(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
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
  const Scalar denominator = Scalar(4.0) * omega1_6 * omega2_3 - Scalar(17.0) * omega1_4 * omega2_5
      + Scalar(4.0) * omega1_2 * omega2_7;
  // multiplies a2*a3
  const Scalar c_0 = -Scalar(12.0) * omega1_4 * omega2_2 + Scalar(50.0) * omega1_2 * omega2_4
      - Scalar(8.0) * omega2_6;
  // multiplies a3*a4
  const Scalar c_1 = -Scalar(8.0) * omega1_6 + Scalar(50.0) * omega1_4 * omega2_2
      - Scalar(12.0) * omega1_2 * omega2_4;
  // multiplies b4
  const Scalar c_2 = Scalar(12.0) * omega1_6 * omega2_2 - Scalar(51.0) * omega1_4 * omega2_4
      + Scalar(12.0) * omega1_2 * omega2_6;
  const Scalar w_0 = Scalar(12.0) * b4;  // multiplies omega1^6*omega2^2
  const Scalar w_1 = -Scalar(8.0) * a3 * a4;  // multiplies omega1^6
  const Scalar w_2 = -Scalar(51.0) * b4;  // multiplies omega1^4*omega2^4
  const Scalar w_3 = -Scalar(12.0) * a2 * a3 + Scalar(50.0) * a3 * a4;  // multiplies omega1^4*omega2^2
  const Scalar w_4 = Scalar(12.0) * b4;  // multiplies omega1^2*omega2^6
  const Scalar w_5 = Scalar(50.0) * a2 * a3 - Scalar(12.0) * a3 * a4;  // multiplies omega1^2*omega2^4
  const Scalar w_6 = -Scalar(8.0) * a2 * a3;  // multiplies omega2^6
  // by omega1
  gradient[0] = (Scalar(6.0) * omega1_5 * omega2_2 * w_0 + Scalar(6.0) * omega1_5 * w_1
      + Scalar(4.0) * omega1_3 * omega2_4 * w_2 + Scalar(4.0) * omega1_3 * omega2_2 * w_3
      + Scalar(2.0) * omega1 * omega2_6 * w_4 + Scalar(2.0) * omega1 * omega2_4 * w_5
      - lump * (Scalar(24.0) * omega1_5 * omega2_3 - Scalar(68.0) * omega1_3 * omega2_5
      + Scalar(8.0) * omega1 * omega2_7)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_6 * omega2 * w_0 + Scalar(4.0) * omega1_4 * omega2_3 * w_2
      + Scalar(2.0) * omega1_4 * omega2 * w_3 + Scalar(6.0) * omega1_2 * omega2_5 * w_4
      + Scalar(4.0) * omega1_2 * omega2_3 * w_5 + Scalar(6.0) * omega2_5 * w_6
      - lump * (Scalar(12.0) * omega1_6 * omega2_2 - Scalar(85.0) * omega1_4 * omega2_4
      + Scalar(28.0) * omega1_2 * omega2_6)) / denominator;
  gradient[3] = (a3 * c_0) / denominator;  // by a2
  gradient[4] = (a2 * c_0 + a4 * c_1) / denominator;  // by a3
  gradient[5] = (a3 * c_1) / denominator;  // by a4
  gradient[9] = (c_2) / denominator;  // by b4
}

/// gradient[p] = d conservative_y_A_x2_conjA_x / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 87 operations.
template <class Scalar>
void lump_gradient_10(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar b2 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar denominator = Scalar(24.0) * omega1_4 * omega2_3 - Scalar(6.0) * omega1_2 * omega2_5;
  // by omega1
  gradient[0] = (Scalar(144.0) * omega1_3 * omega2_2 * b2 - Scalar(192.0) * omega1_3 * a2 * a3
      - Scalar(18.0) * omega1 * omega2_4 * b2 - Scalar(80.0) * omega1 * omega2_2 * a1 * a2
      + Scalar(36.0) * omega1 * omega2_2 * a2 * a3 - lump * (Scalar(96.0) * omega1_3 * omega2_3
      - Scalar(12.0) * omega1 * omega2_5)) / denominator;
  // by omega2
  gradient[1] = (Scalar(72.0) * omega1_4 * omega2 * b2 - Scalar(36.0) * omega1_2 * omega2_3 * b2
      - Scalar(80.0) * omega1_2 * omega2 * a1 * a2 + Scalar(36.0) * omega1_2 * omega2 * a2 * a3
      + Scalar(40.0) * omega2_3 * a1 * a2 - lump * (Scalar(72.0) * omega1_4 * omega2_2
      - Scalar(30.0) * omega1_2 * omega2_4)) / denominator;
  gradient[2] = (-Scalar(40.0) * omega1_2 * omega2_2 * a2 + Scalar(10.0) * omega2_4 * a2) / denominator;  // by a1
  // by a2
  gradient[3] = (-Scalar(48.0) * omega1_4 * a3 - Scalar(40.0) * omega1_2 * omega2_2 * a1
      + Scalar(18.0) * omega1_2 * omega2_2 * a3 + Scalar(10.0) * omega2_4 * a1) / denominator;
  gradient[4] = (-Scalar(48.0) * omega1_4 * a2 + Scalar(18.0) * omega1_2 * omega2_2 * a2) / denominator;  // by a3
  gradient[7] = (Scalar(36.0) * omega1_4 * omega2_2 - Scalar(9.0) * omega1_2 * omega2_4) / denominator;  // by b2
}

/// gradient[p] = d conservative_y_A_y2_conjA_y / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 68 operations.
template <class Scalar>
void lump_gradient_13(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b5 = parameters[10];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar a3_2 = a3 * a3;
  const Scalar a4_2 = a4 * a4;
  const Scalar denominator = Scalar(6.0) * omega1_4 * omega2_3 - Scalar(24.0) * omega1_2 * omega2_5;
  // by omega1
  gradient[0] = (Scalar(36.0) * omega1_3 * omega2_2 * b5 - Scalar(40.0) * omega1_3 * a4_2
      - Scalar(72.0) * omega1 * omega2_4 * b5 - Scalar(36.0) * omega1 * omega2_2 * a3_2
      + Scalar(80.0) * omega1 * omega2_2 * a4_2 - lump * (Scalar(24.0) * omega1_3 * omega2_3
      - Scalar(48.0) * omega1 * omega2_5)) / denominator;
  // by omega2
  gradient[1] = (Scalar(18.0) * omega1_4 * omega2 * b5 - Scalar(144.0) * omega1_2 * omega2_3 * b5
      - Scalar(36.0) * omega1_2 * omega2 * a3_2 + Scalar(80.0) * omega1_2 * omega2 * a4_2
      + Scalar(192.0) * omega2_3 * a3_2 - lump * (Scalar(18.0) * omega1_4 * omega2_2
      - Scalar(120.0) * omega1_2 * omega2_4)) / denominator;
  gradient[4] = (-Scalar(36.0) * omega1_2 * omega2_2 * a3 + Scalar(96.0) * omega2_4 * a3) / denominator;  // by a3
  gradient[5] = (-Scalar(20.0) * omega1_4 * a4 + Scalar(80.0) * omega1_2 * omega2_2 * a4) / denominator;  // by a4
  gradient[10] = (Scalar(9.0) * omega1_4 * omega2_2 - Scalar(36.0) * omega1_2 * omega2_4) / denominator;  // by b5
}

/// gradient[p] = d conservative_y_A_y2_conjA_x / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 110 operations.
template <class Scalar>
void lump_gradient_14(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar denominator = Scalar(12.0) * omega1_4 * omega2_3 - Scalar(6.0) * omega1_3 * omega2_4
      - Scalar(48.0) * omega1_2 * omega2_5 + Scalar(24.0) * omega1 * omega2_6;
  // multiplies a2*a3
  const Scalar c_0 = -Scalar(12.0) * omega1_3 * omega2 - Scalar(12.0) * omega1_2 * omega2_2
      + Scalar(54.0) * omega1 * omega2_3;
  // multiplies a3*a4
  const Scalar c_1 = Scalar(4.0) * omega1_4 - Scalar(2.0) * omega1_3 * omega2 + Scalar(8.0) * omega1_2 * omega2_2
      + Scalar(44.0) * omega1 * omega2_3 - Scalar(24.0) * omega2_4;
  // multiplies b4
  const Scalar c_2 = Scalar(18.0) * omega1_4 * omega2_2 - Scalar(9.0) * omega1_3 * omega2_3
      - Scalar(72.0) * omega1_2 * omega2_4 + Scalar(36.0) * omega1 * omega2_5;
  const Scalar w_0 = Scalar(18.0) * b4;  // multiplies omega1^4*omega2^2
  const Scalar w_1 = Scalar(4.0) * a3 * a4;  // multiplies omega1^4
  const Scalar w_2 = -Scalar(9.0) * b4;  // multiplies omega1^3*omega2^3
  const Scalar w_3 = -Scalar(12.0) * a2 * a3 - Scalar(2.0) * a3 * a4;  // multiplies omega1^3*omega2
  const Scalar w_4 = -Scalar(72.0) * b4;  // multiplies omega1^2*omega2^4
  const Scalar w_5 = -Scalar(12.0) * a2 * a3 + Scalar(8.0) * a3 * a4;  // multiplies omega1^2*omega2^2
  const Scalar w_6 = Scalar(36.0) * b4;  // multiplies omega1*omega2^5
  const Scalar w_7 = Scalar(54.0) * a2 * a3 + Scalar(44.0) * a3 * a4;  // multiplies omega1*omega2^3
  const Scalar w_8 = -Scalar(24.0) * a3 * a4;  // multiplies omega2^4
  // by omega1
  gradient[0] = (Scalar(4.0) * omega1_3 * omega2_2 * w_0 + Scalar(4.0) * omega1_3 * w_1
      + Scalar(3.0) * omega1_2 * omega2_3 * w_2 + Scalar(3.0) * omega1_2 * omega2 * w_3
      + Scalar(2.0) * omega1 * omega2_4 * w_4 + Scalar(2.0) * omega1 * omega2_2 * w_5 + omega2_5 * w_6
      + omega2_3 * w_7 - lump * (Scalar(48.0) * omega1_3 * omega2_3 - Scalar(18.0) * omega1_2 * omega2_4
      - Scalar(96.0) * omega1 * omega2_5 + Scalar(24.0) * omega2_6)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_4 * omega2 * w_0 + Scalar(3.0) * omega1_3 * omega2_2 * w_2 + omega1_3 * w_3
      + Scalar(4.0) * omega1_2 * omega2_3 * w_4 + Scalar(2.0) * omega1_2 * omega2 * w_5
      + Scalar(5.0) * omega1 * omega2_4 * w_6 + Scalar(3.0) * omega1 * omega2_2 * w_7
      + Scalar(4.0) * omega2_3 * w_8 - lump * (Scalar(36.0) * omega1_4 * omega2_2
      - Scalar(24.0) * omega1_3 * omega2_3 - Scalar(240.0) * omega1_2 * omega2_4
      + Scalar(144.0) * omega1 * omega2_5)) / denominator;
  gradient[3] = (a3 * c_0) / denominator;  // by a2
  gradient[4] = (a2 * c_0 + a4 * c_1) / denominator;  // by a3
  gradient[5] = (a3 * c_1) / denominator;  // by a4
  gradient[9] = (c_2) / denominator;  // by b4
}

/// gradient[p] = d harmonic_re_x_A_y3 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 59 operations.
template <class Scalar>
void lump_gradient_18(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar denominator = Scalar(3.0) * omega1_4 * omega2_2 - Scalar(39.0) * omega1_2 * omega2_4
      + Scalar(108.0) * omega2_6;
  // by omega1
  gradient[0] = (-Scalar(6.0) * omega1 * omega2_2 * b4 - Scalar(4.0) * omega1 * a3 * a4
      - lump * (Scalar(12.0) * omega1_3 * omega2_2 - Scalar(78.0) * omega1 * omega2_4)) / denominator;
  // by omega2
  gradient[1] = (-Scalar(6.0) * omega1_2 * omega2 * b4 + Scalar(48.0) * omega2_3 * b4
      + Scalar(12.0) * omega2 * a2 * a3 + Scalar(16.0) * omega2 * a3 * a4
      - lump * (Scalar(6.0) * omega1_4 * omega2 - Scalar(156.0) * omega1_2 * omega2_3
      + Scalar(648.0) * omega2_5)) / denominator;
  gradient[3] = (Scalar(6.0) * omega2_2 * a3) / denominator;  // by a2
  // by a3
  gradient[4] = (-Scalar(2.0) * omega1_2 * a4 + Scalar(6.0) * omega2_2 * a2
      + Scalar(8.0) * omega2_2 * a4) / denominator;
  gradient[5] = (-Scalar(2.0) * omega1_2 * a3 + Scalar(8.0) * omega2_2 * a3) / denominator;  // by a4
  gradient[9] = (-Scalar(3.0) * omega1_2 * omega2_2 + Scalar(12.0) * omega2_4) / denominator;  // by b4
}

/// gradient[p] = d harmonic_re_x_A_x_A_y2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 132 operations.
template <class Scalar>
void lump_gradient_19(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar omega2_7 = omega2_6 * omega2;
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar denominator = Scalar(24.0) * omega1_5 * omega2_3 + Scalar(36.0) * omega1_4 * omega2_4
      - Scalar(84.0) * omega1_3 * omega2_5 - Scalar(144.0) * omega1_2 * omega2_6
      - Scalar(48.0) * omega1 * omega2_7;
  const Scalar c_0 = -Scalar(12.0) * omega1_2 * omega2_2 - Scalar(6.0) * omega1 * omega2_3;  // multiplies a1*a3
  const Scalar c_1 = Scalar(12.0) * omega1_3 * omega2 - Scalar(48.0) * omega1 * omega2_3;  // multiplies a2^2
  // multiplies a2*a4
  const Scalar c_2 = Scalar(4.0) * omega1_4 + Scalar(2.0) * omega1_3 * omega2 - Scalar(16.0) * omega1_2 * omega2_2
      - Scalar(8.0) * omega1 * omega2_3;
  // multiplies a3^2
  const Scalar c_3 = Scalar(24.0) * omega1_2 * omega2_2 - Scalar(36.0) * omega1 * omega2_3
      - Scalar(24.0) * omega2_4;
  // multiplies b3
  const Scalar c_4 = Scalar(6.0) * omega1_4 * omega2_2 + Scalar(3.0) * omega1_3 * omega2_3
      - Scalar(24.0) * omega1_2 * omega2_4 - Scalar(12.0) * omega1 * omega2_5;
  const Scalar w_0 = Scalar(6.0) * b3;  // multiplies omega1^4*omega2^2
  const Scalar w_1 = Scalar(4.0) * a2 * a4;  // multiplies omega1^4
  const Scalar w_2 = Scalar(3.0) * b3;  // multiplies omega1^3*omega2^3
  const Scalar w_3 = Scalar(12.0) * a2_2 + Scalar(2.0) * a2 * a4;  // multiplies omega1^3*omega2
  const Scalar w_4 = -Scalar(24.0) * b3;  // multiplies omega1^2*omega2^4
  // multiplies omega1^2*omega2^2
  const Scalar w_5 = -Scalar(12.0) * a1 * a3 - Scalar(16.0) * a2 * a4 + Scalar(24.0) * a3_2;
  const Scalar w_6 = -Scalar(12.0) * b3;  // multiplies omega1*omega2^5
  // multiplies omega1*omega2^3
  const Scalar w_7 = -Scalar(6.0) * a1 * a3 - Scalar(48.0) * a2_2 - Scalar(8.0) * a2 * a4 - Scalar(36.0) * a3_2;
  const Scalar w_8 = -Scalar(24.0) * a3_2;  // multiplies omega2^4
  // by omega1
  gradient[0] = (Scalar(4.0) * omega1_3 * omega2_2 * w_0 + Scalar(4.0) * omega1_3 * w_1
      + Scalar(3.0) * omega1_2 * omega2_3 * w_2 + Scalar(3.0) * omega1_2 * omega2 * w_3
      + Scalar(2.0) * omega1 * omega2_4 * w_4 + Scalar(2.0) * omega1 * omega2_2 * w_5 + omega2_5 * w_6
      + omega2_3 * w_7 - lump * (Scalar(120.0) * omega1_4 * omega2_3 + Scalar(144.0) * omega1_3 * omega2_4
      - Scalar(252.0) * omega1_2 * omega2_5 - Scalar(288.0) * omega1 * omega2_6
      - Scalar(48.0) * omega2_7)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_4 * omega2 * w_0 + Scalar(3.0) * omega1_3 * omega2_2 * w_2 + omega1_3 * w_3
      + Scalar(4.0) * omega1_2 * omega2_3 * w_4 + Scalar(2.0) * omega1_2 * omega2 * w_5
      + Scalar(5.0) * omega1 * omega2_4 * w_6 + Scalar(3.0) * omega1 * omega2_2 * w_7
      + Scalar(4.0) * omega2_3 * w_8 - lump * (Scalar(72.0) * omega1_5 * omega2_2
      + Scalar(144.0) * omega1_4 * omega2_3 - Scalar(420.0) * omega1_3 * omega2_4
      - Scalar(864.0) * omega1_2 * omega2_5 - Scalar(336.0) * omega1 * omega2_6)) / denominator;
  gradient[2] = (a3 * c_0) / denominator;  // by a1
  gradient[3] = (Scalar(2.0) * a2 * c_1 + a4 * c_2) / denominator;  // by a2
  gradient[4] = (a1 * c_0 + Scalar(2.0) * a3 * c_3) / denominator;  // by a3
  gradient[5] = (a2 * c_2) / denominator;  // by a4
  gradient[8] = (c_4) / denominator;  // by b3
}

/// gradient[p] = d harmonic_re_x_A_x2_A_y / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 128 operations.
template <class Scalar>
void lump_gradient_20(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar b2 = parameters[7];
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
  const Scalar denominator = Scalar(36.0) * omega1_7 * omega2 + Scalar(120.0) * omega1_6 * omega2_2
      + Scalar(99.0) * omega1_5 * omega2_3 - Scalar(6.0) * omega1_4 * omega2_4
      - Scalar(27.0) * omega1_3 * omega2_5 - Scalar(6.0) * omega1_2 * omega2_6;
  // multiplies a1*a2
  const Scalar c_0 = Scalar(24.0) * omega1_4 + Scalar(44.0) * omega1_3 * omega2
      - Scalar(8.0) * omega1_2 * omega2_2 - Scalar(2.0) * omega1 * omega2_3 - Scalar(4.0) * omega2_4;
  // multiplies a2*a3
  const Scalar c_1 = Scalar(54.0) * omega1_3 * omega2 + Scalar(12.0) * omega1_2 * omega2_2
      - Scalar(12.0) * omega1 * omega2_3;
  // multiplies b2
  const Scalar c_2 = Scalar(36.0) * omega1_5 * omega2 + Scalar(72.0) * omega1_4 * omega2_2
      - Scalar(9.0) * omega1_3 * omega2_3 - Scalar(18.0) * omega1_2 * omega2_4;
  const Scalar w_0 = Scalar(36.0) * b2;  // multiplies omega1^5*omega2
  const Scalar w_1 = Scalar(72.0) * b2;  // multiplies omega1^4*omega2^2
  const Scalar w_2 = Scalar(24.0) * a1 * a2;  // multiplies omega1^4
  const Scalar w_3 = -Scalar(9.0) * b2;  // multiplies omega1^3*omega2^3
  const Scalar w_4 = Scalar(44.0) * a1 * a2 + Scalar(54.0) * a2 * a3;  // multiplies omega1^3*omega2
  const Scalar w_5 = -Scalar(18.0) * b2;  // multiplies omega1^2*omega2^4
  const Scalar w_6 = -Scalar(8.0) * a1 * a2 + Scalar(12.0) * a2 * a3;  // multiplies omega1^2*omega2^2
  const Scalar w_7 = -Scalar(2.0) * a1 * a2 - Scalar(12.0) * a2 * a3;  // multiplies omega1*omega2^3
  const Scalar w_8 = -Scalar(4.0) * a1 * a2;  // multiplies omega2^4
  // by omega1
  gradient[0] = (Scalar(5.0) * omega1_4 * omega2 * w_0 + Scalar(4.0) * omega1_3 * omega2_2 * w_1
      + Scalar(4.0) * omega1_3 * w_2 + Scalar(3.0) * omega1_2 * omega2_3 * w_3
      + Scalar(3.0) * omega1_2 * omega2 * w_4 + Scalar(2.0) * omega1 * omega2_4 * w_5
      + Scalar(2.0) * omega1 * omega2_2 * w_6 + omega2_3 * w_7 - lump * (Scalar(252.0) * omega1_6 * omega2
      + Scalar(720.0) * omega1_5 * omega2_2 + Scalar(495.0) * omega1_4 * omega2_3
      - Scalar(24.0) * omega1_3 * omega2_4 - Scalar(81.0) * omega1_2 * omega2_5
      - Scalar(12.0) * omega1 * omega2_6)) / denominator;
  // by omega2
  gradient[1] = (omega1_5 * w_0 + Scalar(2.0) * omega1_4 * omega2 * w_1 + Scalar(3.0) * omega1_3 * omega2_2 * w_3
      + omega1_3 * w_4 + Scalar(4.0) * omega1_2 * omega2_3 * w_5 + Scalar(2.0) * omega1_2 * omega2 * w_6
      + Scalar(3.0) * omega1 * omega2_2 * w_7 + Scalar(4.0) * omega2_3 * w_8 - lump * (Scalar(36.0) * omega1_7
      + Scalar(240.0) * omega1_6 * omega2 + Scalar(297.0) * omega1_5 * omega2_2
      - Scalar(24.0) * omega1_4 * omega2_3 - Scalar(135.0) * omega1_3 * omega2_4
      - Scalar(36.0) * omega1_2 * omega2_5)) / denominator;
  gradient[2] = (a2 * c_0) / denominator;  // by a1
  gradient[3] = (a1 * c_0 + a3 * c_1) / denominator;  // by a2
  gradient[4] = (a2 * c_1) / denominator;  // by a3
  gradient[7] = (c_2) / denominator;  // by b2
}

/// gradient[p] = d harmonic_re_x_A_x3 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 39 operations.
template <class Scalar>
void lump_gradient_21(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar b1 = parameters[6];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega1_6 = omega1_5 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar a1_2 = a1 * a1;
  const Scalar a2_2 = a2 * a2;
  const Scalar denominator = Scalar(96.0) * omega1_6 - Scalar(24.0) * omega1_4 * omega2_2;
  // by omega1
  gradient[0] = (Scalar(48.0) * omega1_3 * b1 - Scalar(6.0) * omega1 * omega2_2 * b1
      + Scalar(16.0) * omega1 * a1_2 + Scalar(12.0) * omega1 * a2_2 - lump * (Scalar(576.0) * omega1_5
      - Scalar(96.0) * omega1_3 * omega2_2)) / denominator;
  // by omega2
  gradient[1] = (-Scalar(6.0) * omega1_2 * omega2 * b1 - Scalar(4.0) * omega2 * a1_2
      - lump * (-Scalar(48.0) * omega1_4 * omega2)) / denominator;
  gradient[2] = (Scalar(16.0) * omega1_2 * a1 - Scalar(4.0) * omega2_2 * a1) / denominator;  // by a1
  gradient[3] = (Scalar(12.0) * omega1_2 * a2) / denominator;  // by a2
  gradient[6] = (Scalar(12.0) * omega1_4 - Scalar(3.0) * omega1_2 * omega2_2) / denominator;  // by b1
}

/// gradient[p] = d harmonic_re_y_A_y3 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 39 operations.
template <class Scalar>
void lump_gradient_23(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b5 = parameters[10];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar a3_2 = a3 * a3;
  const Scalar a4_2 = a4 * a4;
  const Scalar denominator = Scalar(24.0) * omega1_2 * omega2_4 - Scalar(96.0) * omega2_6;
  // by omega1
  gradient[0] = (Scalar(6.0) * omega1 * omega2_2 * b5 + Scalar(4.0) * omega1 * a4_2
      - lump * (Scalar(48.0) * omega1 * omega2_4)) / denominator;
  // by omega2
  gradient[1] = (Scalar(6.0) * omega1_2 * omega2 * b5 - Scalar(48.0) * omega2_3 * b5
      - Scalar(12.0) * omega2 * a3_2 - Scalar(16.0) * omega2 * a4_2 - lump * (Scalar(96.0) * omega1_2 * omega2_3
      - Scalar(576.0) * omega2_5)) / denominator;
  gradient[4] = (-Scalar(12.0) * omega2_2 * a3) / denominator;  // by a3
  gradient[5] = (Scalar(4.0) * omega1_2 * a4 - Scalar(16.0) * omega2_2 * a4) / denominator;  // by a4
  gradient[10] = (Scalar(3.0) * omega1_2 * omega2_2 - Scalar(12.0) * omega2_4) / denominator;  // by b5
}

/// gradient[p] = d harmonic_re_y_A_x_A_y2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 128 operations.
template <class Scalar>
void lump_gradient_24(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
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
  const Scalar denominator = Scalar(6.0) * omega1_6 * omega2_2 + Scalar(27.0) * omega1_5 * omega2_3
      + Scalar(6.0) * omega1_4 * omega2_4 - Scalar(99.0) * omega1_3 * omega2_5
      - Scalar(120.0) * omega1_2 * omega2_6 - Scalar(36.0) * omega1 * omega2_7;
  // multiplies a2*a3
  const Scalar c_0 = Scalar(12.0) * omega1_3 * omega2 - Scalar(12.0) * omega1_2 * omega2_2
      - Scalar(54.0) * omega1 * omega2_3;
  // multiplies a3*a4
  const Scalar c_1 = Scalar(4.0) * omega1_4 + Scalar(2.0) * omega1_3 * omega2 + Scalar(8.0) * omega1_2 * omega2_2
      - Scalar(44.0) * omega1 * omega2_3 - Scalar(24.0) * omega2_4;
  // multiplies b4
  const Scalar c_2 = Scalar(18.0) * omega1_4 * omega2_2 + Scalar(9.0) * omega1_3 * omega2_3
      - Scalar(72.0) * omega1_2 * omega2_4 - Scalar(36.0) * omega1 * omega2_5;
  const Scalar w_0 = Scalar(18.0) * b4;  // multiplies omega1^4*omega2^2
  const Scalar w_1 = Scalar(4.0) * a3 * a4;  // multiplies omega1^4
  const Scalar w_2 = Scalar(9.0) * b4;  // multiplies omega1^3*omega2^3
  const Scalar w_3 = Scalar(12.0) * a2 * a3 + Scalar(2.0) * a3 * a4;  // multiplies omega1^3*omega2
  const Scalar w_4 = -Scalar(72.0) * b4;  // multiplies omega1^2*omega2^4
  const Scalar w_5 = -Scalar(12.0) * a2 * a3 + Scalar(8.0) * a3 * a4;  // multiplies omega1^2*omega2^2
  const Scalar w_6 = -Scalar(36.0) * b4;  // multiplies omega1*omega2^5
  const Scalar w_7 = -Scalar(54.0) * a2 * a3 - Scalar(44.0) * a3 * a4;  // multiplies omega1*omega2^3
  const Scalar w_8 = -Scalar(24.0) * a3 * a4;  // multiplies omega2^4
  // by omega1
  gradient[0] = (Scalar(4.0) * omega1_3 * omega2_2 * w_0 + Scalar(4.0) * omega1_3 * w_1
      + Scalar(3.0) * omega1_2 * omega2_3 * w_2 + Scalar(3.0) * omega1_2 * omega2 * w_3
      + Scalar(2.0) * omega1 * omega2_4 * w_4 + Scalar(2.0) * omega1 * omega2_2 * w_5 + omega2_5 * w_6
      + omega2_3 * w_7 - lump * (Scalar(36.0) * omega1_5 * omega2_2 + Scalar(135.0) * omega1_4 * omega2_3
      + Scalar(24.0) * omega1_3 * omega2_4 - Scalar(297.0) * omega1_2 * omega2_5
      - Scalar(240.0) * omega1 * omega2_6 - Scalar(36.0) * omega2_7)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_4 * omega2 * w_0 + Scalar(3.0) * omega1_3 * omega2_2 * w_2 + omega1_3 * w_3
      + Scalar(4.0) * omega1_2 * omega2_3 * w_4 + Scalar(2.0) * omega1_2 * omega2 * w_5
      + Scalar(5.0) * omega1 * omega2_4 * w_6 + Scalar(3.0) * omega1 * omega2_2 * w_7
      + Scalar(4.0) * omega2_3 * w_8 - lump * (Scalar(12.0) * omega1_6 * omega2
      + Scalar(81.0) * omega1_5 * omega2_2 + Scalar(24.0) * omega1_4 * omega2_3
      - Scalar(495.0) * omega1_3 * omega2_4 - Scalar(720.0) * omega1_2 * omega2_5
      - Scalar(252.0) * omega1 * omega2_6)) / denominator;
  gradient[3] = (a3 * c_0) / denominator;  // by a2
  gradient[4] = (a2 * c_0 + a4 * c_1) / denominator;  // by a3
  gradient[5] = (a3 * c_1) / denominator;  // by a4
  gradient[9] = (c_2) / denominator;  // by b4
}

/// gradient[p] = d harmonic_re_y_A_x2_A_y / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 132 operations.
template <class Scalar>
void lump_gradient_25(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
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
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar denominator = Scalar(48.0) * omega1_7 * omega2 + Scalar(144.0) * omega1_6 * omega2_2
      + Scalar(84.0) * omega1_5 * omega2_3 - Scalar(36.0) * omega1_4 * omega2_4
      - Scalar(24.0) * omega1_3 * omega2_5;
  // multiplies a1*a3
  const Scalar c_0 = Scalar(8.0) * omega1_3 * omega2 + Scalar(16.0) * omega1_2 * omega2_2
      - Scalar(2.0) * omega1 * omega2_3 - Scalar(4.0) * omega2_4;
  // multiplies a2^2
  const Scalar c_1 = Scalar(24.0) * omega1_4 + Scalar(36.0) * omega1_3 * omega2
      - Scalar(24.0) * omega1_2 * omega2_2;
  const Scalar c_2 = Scalar(6.0) * omega1_3 * omega2 + Scalar(12.0) * omega1_2 * omega2_2;  // multiplies a2*a4
  const Scalar c_3 = Scalar(48.0) * omega1_3 * omega2 - Scalar(12.0) * omega1 * omega2_3;  // multiplies a3^2
  // multiplies b3
  const Scalar c_4 = Scalar(12.0) * omega1_5 * omega2 + Scalar(24.0) * omega1_4 * omega2_2
      - Scalar(3.0) * omega1_3 * omega2_3 - Scalar(6.0) * omega1_2 * omega2_4;
  const Scalar w_0 = Scalar(12.0) * b3;  // multiplies omega1^5*omega2
  const Scalar w_1 = Scalar(24.0) * b3;  // multiplies omega1^4*omega2^2
  const Scalar w_2 = Scalar(24.0) * a2_2;  // multiplies omega1^4
  const Scalar w_3 = -Scalar(3.0) * b3;  // multiplies omega1^3*omega2^3
  // multiplies omega1^3*omega2
  const Scalar w_4 = Scalar(8.0) * a1 * a3 + Scalar(36.0) * a2_2 + Scalar(6.0) * a2 * a4 + Scalar(48.0) * a3_2;
  const Scalar w_5 = -Scalar(6.0) * b3;  // multiplies omega1^2*omega2^4
  // multiplies omega1^2*omega2^2
  const Scalar w_6 = Scalar(16.0) * a1 * a3 - Scalar(24.0) * a2_2 + Scalar(12.0) * a2 * a4;
  const Scalar w_7 = -Scalar(2.0) * a1 * a3 - Scalar(12.0) * a3_2;  // multiplies omega1*omega2^3
  const Scalar w_8 = -Scalar(4.0) * a1 * a3;  // multiplies omega2^4
  // by omega1
  gradient[0] = (Scalar(5.0) * omega1_4 * omega2 * w_0 + Scalar(4.0) * omega1_3 * omega2_2 * w_1
      + Scalar(4.0) * omega1_3 * w_2 + Scalar(3.0) * omega1_2 * omega2_3 * w_3
      + Scalar(3.0) * omega1_2 * omega2 * w_4 + Scalar(2.0) * omega1 * omega2_4 * w_5
      + Scalar(2.0) * omega1 * omega2_2 * w_6 + omega2_3 * w_7 - lump * (Scalar(336.0) * omega1_6 * omega2
      + Scalar(864.0) * omega1_5 * omega2_2 + Scalar(420.0) * omega1_4 * omega2_3
      - Scalar(144.0) * omega1_3 * omega2_4 - Scalar(72.0) * omega1_2 * omega2_5)) / denominator;
  // by omega2
  gradient[1] = (omega1_5 * w_0 + Scalar(2.0) * omega1_4 * omega2 * w_1 + Scalar(3.0) * omega1_3 * omega2_2 * w_3
      + omega1_3 * w_4 + Scalar(4.0) * omega1_2 * omega2_3 * w_5 + Scalar(2.0) * omega1_2 * omega2 * w_6
      + Scalar(3.0) * omega1 * omega2_2 * w_7 + Scalar(4.0) * omega2_3 * w_8 - lump * (Scalar(48.0) * omega1_7
      + Scalar(288.0) * omega1_6 * omega2 + Scalar(252.0) * omega1_5 * omega2_2
      - Scalar(144.0) * omega1_4 * omega2_3 - Scalar(120.0) * omega1_3 * omega2_4)) / denominator;
  gradient[2] = (a3 * c_0) / denominator;  // by a1
  gradient[3] = (Scalar(2.0) * a2 * c_1 + a4 * c_2) / denominator;  // by a2
  gradient[4] = (a1 * c_0 + Scalar(2.0) * a3 * c_3) / denominator;  // by a3
  gradient[5] = (a2 * c_2) / denominator;  // by a4
  gradient[8] = (c_4) / denominator;  // by b3
}

/// gradient[p] = d harmonic_re_y_A_x3 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 59 operations.
template <class Scalar>
void lump_gradient_26(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar b2 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega1_6 = omega1_5 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar denominator = Scalar(108.0) * omega1_6 - Scalar(39.0) * omega1_4 * omega2_2
      + Scalar(3.0) * omega1_2 * omega2_4;
  // by omega1
  gradient[0] = (Scalar(48.0) * omega1_3 * b2 - Scalar(6.0) * omega1 * omega2_2 * b2
      + Scalar(16.0) * omega1 * a1 * a2 + Scalar(12.0) * omega1 * a2 * a3 - lump * (Scalar(648.0) * omega1_5
      - Scalar(156.0) * omega1_3 * omega2_2 + Scalar(6.0) * omega1 * omega2_4)) / denominator;
  // by omega2
  gradient[1] = (-Scalar(6.0) * omega1_2 * omega2 * b2 - Scalar(4.0) * omega2 * a1 * a2
      - lump * (-Scalar(78.0) * omega1_4 * omega2 + Scalar(12.0) * omega1_2 * omega2_3)) / denominator;
  gradient[2] = (Scalar(8.0) * omega1_2 * a2 - Scalar(2.0) * omega2_2 * a2) / denominator;  // by a1
  // by a2
  gradient[3] = (Scalar(8.0) * omega1_2 * a1 + Scalar(6.0) * omega1_2 * a3
      - Scalar(2.0) * omega2_2 * a1) / denominator;
  gradient[4] = (Scalar(6.0) * omega1_2 * a2) / denominator;  // by a3
  gradient[7] = (Scalar(12.0) * omega1_4 - Scalar(3.0) * omega1_2 * omega2_2) / denominator;  // by b2
}

/// jacobian[l * 15 + p] = d lumps[l] / d parameters[p]. 0 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  Scalar lumps[27];
  evaluate_lumps(parameters, lumps);
  for (std::size_t i = 0; i < 405; ++i) jacobian[i] = Scalar(0.0);
  lump_gradient_0(parameters, lumps[0], jacobian + 0);  // d conservative_x_A_x2_conjA_y
  jacobian[26] = Scalar(1.0);  // d mu1 / d mu1
  lump_gradient_2(parameters, lumps[2], jacobian + 30);  // d conservative_x_A_x_A_y_conjA_y
  lump_gradient_3(parameters, lumps[3], jacobian + 45);  // d conservative_x_A_x2_conjA_x
  jacobian[72] = Scalar(1.0);  // d e1 / d e1
  lump_gradient_5(parameters, lumps[5], jacobian + 75);  // d conservative_x_A_y2_conjA_y
  lump_gradient_6(parameters, lumps[6], jacobian + 90);  // d conservative_x_A_x_A_y_conjA_x
  lump_gradient_7(parameters, lumps[7], jacobian + 105);  // d conservative_x_A_y2_conjA_x
  lump_gradient_8(parameters, lumps[8], jacobian + 120);  // d conservative_y_A_x2_conjA_y
  lump_gradient_9(parameters, lumps[9], jacobian + 135);  // d conservative_y_A_x_A_y_conjA_y
  lump_gradient_10(parameters, lumps[10], jacobian + 150);  // d conservative_y_A_x2_conjA_x
  jacobian[179] = Scalar(1.0);  // d e2 / d e2
  jacobian[193] = Scalar(1.0);  // d mu2 / d mu2
  lump_gradient_13(parameters, lumps[13], jacobian + 195);  // d conservative_y_A_y2_conjA_y
  lump_gradient_14(parameters, lumps[14], jacobian + 210);  // d conservative_y_A_y2_conjA_x
  jacobian[228] = Scalar(1.0);  // d a2 / d a2
  jacobian[244] = Scalar(1.0);  // d a3 / d a3
  jacobian[257] = Scalar(1.0);  // d a1 / d a1
  lump_gradient_18(parameters, lumps[18], jacobian + 270);  // d harmonic_re_x_A_y3
  lump_gradient_19(parameters, lumps[19], jacobian + 285);  // d harmonic_re_x_A_x_A_y2
  lump_gradient_20(parameters, lumps[20], jacobian + 300);  // d harmonic_re_x_A_x2_A_y
  lump_gradient_21(parameters, lumps[21], jacobian + 315);  // d harmonic_re_x_A_x3
  jacobian[335] = Scalar(1.0);  // d a4 / d a4
  lump_gradient_23(parameters, lumps[23], jacobian + 345);  // d harmonic_re_y_A_y3
  lump_gradient_24(parameters, lumps[24], jacobian + 360);  // d harmonic_re_y_A_x_A_y2
  lump_gradient_25(parameters, lumps[25], jacobian + 375);  // d harmonic_re_y_A_x2_A_y
  lump_gradient_26(parameters, lumps[26], jacobian + 390);  // d harmonic_re_y_A_x3
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

/// What multiplies the 4 terms of the harmonic 0 of x: functions of the frequencies alone. 12 operations.
template <class Scalar>
void factors_2([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  factor[0] = -Scalar(2.0) / (Scalar(2.0) * omega1 * omega2 - omega2_2);
  factor[1] = -Scalar(2.0) / (Scalar(2.0) * omega1 * omega2 - omega2_2);
  factor[2] = -Scalar(2.0) / omega1_2;
  factor[3] = -Scalar(2.0) / omega1_2;
}

/// Rows of the harmonic 0 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in x = -2/(2*omega1*omega2 - omega2^2)*a2*conj(A_x)*A_y - 2/(2*omega1*omega2 -
/// omega2^2)*a2*A_x*conj(A_y) - 2/omega1^2*a3*A_y*conj(A_y) - 2/omega1^2*a1*A_x*conj(A_x)
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

/// What multiplies the 3 terms of the harmonic 2*omega2 of x: functions of the frequencies alone. 11 operations.
template <class Scalar>
void factors_3([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  factor[0] = Scalar(2.0) / (Scalar(2.0) * omega1 * omega2 + omega2_2);
  factor[1] = -Scalar(1.0) / (omega1_2 - Scalar(4.0) * omega2_2);
  factor[2] = Scalar(1.0) / (Scalar(3.0) * omega1_2);
}

/// Rows of the harmonic 2*omega2 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega2)*t) in x = 2/(2*omega1*omega2 + omega2^2)*a2*A_x*A_y - 1/(omega1^2 -
/// 4*omega2^2)*a3*A_y^2 + 1/(3*omega1^2)*a1*A_x^2
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

/// What multiplies the 4 terms of the harmonic 0 of y: functions of the frequencies alone. 12 operations.
template <class Scalar>
void factors_5([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  factor[0] = -Scalar(2.0) / omega2_2;
  factor[1] = Scalar(2.0) / (omega1_2 - Scalar(2.0) * omega1 * omega2);
  factor[2] = Scalar(2.0) / (omega1_2 - Scalar(2.0) * omega1 * omega2);
  factor[3] = -Scalar(2.0) / omega2_2;
}

/// Rows of the harmonic 0 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in y = -2/omega2^2*a2*A_x*conj(A_x) + 2/(omega1^2 -
/// 2*omega1*omega2)*a3*conj(A_x)*A_y + 2/(omega1^2 - 2*omega1*omega2)*a3*A_x*conj(A_y) -
/// 2/omega2^2*a4*A_y*conj(A_y)
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

/// What multiplies the 3 terms of the harmonic 2*omega2 of y: functions of the frequencies alone. 11 operations.
template <class Scalar>
void factors_6([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  factor[0] = Scalar(1.0) / (Scalar(4.0) * omega1_2 - omega2_2);
  factor[1] = Scalar(2.0) / (omega1_2 + Scalar(2.0) * omega1 * omega2);
  factor[2] = Scalar(1.0) / (Scalar(3.0) * omega2_2);
}

/// Rows of the harmonic 2*omega2 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega2)*t) in y = 1/(4*omega1^2 - omega2^2)*a2*A_x^2 + 2/(omega1^2 +
/// 2*omega1*omega2)*a3*A_x*A_y + 1/(3*omega2^2)*a4*A_y^2
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
/// lumps[2]: conservative_x_A_x_A_y_conjA_y = (4*omega1^5*omega2^2*b3 - 8*omega1^5*a2*a4 +
/// 2*omega1^4*omega2^3*b3 + 4*omega1^4*omega2*a2^2 - 4*omega1^4*omega2*a2*a4 - 16*omega1^3*omega2^4*b3 -
/// 8*omega1^3*omega2^2*a1*a3 + 2*omega1^3*omega2^2*a2^2 + 32*omega1^3*omega2^2*a2*a4 + 16*omega1^3*omega2^2*a3^2
/// - 8*omega1^2*omega2^5*b3 - 4*omega1^2*omega2^3*a1*a3 - 15*omega1^2*omega2^3*a2^2 + 16*omega1^2*omega2^3*a2*a4
/// + 8*omega1^2*omega2^3*a3^2 + 32*omega1*omega2^4*a1*a3 - 8*omega1*omega2^4*a2^2 + 16*omega2^5*a1*a3 -
/// 4*omega2^5*a2^2)/(4*omega1^6*omega2^2 + 2*omega1^5*omega2^3 - 16*omega1^4*omega2^4 - 8*omega1^3*omega2^5)
/// lumps[3]: conservative_x_A_x2_conjA_x = (18*omega1^2*omega2^2*b1 - 24*omega1^2*a2^2 - 3*omega1*omega2*a2^2 -
/// 20*omega2^2*a1^2)/(12*omega1^3*omega2^2)
/// lumps[4]: dissipative_x_A_y_conjA_x = a2*mu2/(2*omega1^2)
/// lumps[5]: a2 = a2
/// lumps[6]: conservative_x_conjA_x_F = (omega1^2*a2*e2 + 4*omega1*omega2*a1*e1 -
/// omega2^2*a2*e2)/(8*omega1^4*omega2 - 8*omega1^2*omega2^3)
/// lumps[7]: dissipative_y_A_x2 = (2*a2*mu1 - a2*mu2)/(4*omega2^2)
/// lumps[8]: mu2 = mu2
/// lumps[9]: conservative_y_A_y = -mu2^2/(2*omega2)
/// lumps[10]: conservative_y_A_y2_conjA_y = (9*omega1^4*omega2^2*b5 - 10*omega1^4*a4^2 - 36*omega1^2*omega2^4*b5
/// - 18*omega1^2*omega2^2*a3^2 + 40*omega1^2*omega2^2*a4^2 + 48*omega2^4*a3^2)/(6*omega1^4*omega2^3 -
/// 24*omega1^2*omega2^5)
/// lumps[11]: conservative_y_A_x_A_y_conjA_x = (4*omega1^5*omega2^2*b3 - 8*omega1^5*a2*a4 +
/// 2*omega1^4*omega2^3*b3 + 2*omega1^4*omega2*a2^2 - 4*omega1^4*omega2*a2*a4 - 16*omega1^3*omega2^4*b3 -
/// 8*omega1^3*omega2^2*a1*a3 - omega1^3*omega2^2*a2^2 + 32*omega1^3*omega2^2*a2*a4 + 16*omega1^3*omega2^2*a3^2 -
/// 8*omega1^2*omega2^5*b3 - 4*omega1^2*omega2^3*a1*a3 - 8*omega1^2*omega2^3*a2^2 + 16*omega1^2*omega2^3*a2*a4 +
/// 8*omega1^2*omega2^3*a3^2 + 32*omega1*omega2^4*a1*a3 + 4*omega1*omega2^4*a2^2 +
/// 16*omega2^5*a1*a3)/(4*omega1^5*omega2^3 + 2*omega1^4*omega2^4 - 16*omega1^3*omega2^5 - 8*omega1^2*omega2^6)
/// lumps[12]: dissipative_y_F = mu2*e2/(8*omega2^2)
/// lumps[13]: e2 = e2
/// lumps[14]: a3 = a3
/// lumps[15]: a1 = a1
/// lumps[16]: harmonic_re_x_A_y_conjA_x2 = (9*omega1^3*b2 - 18*omega1^2*omega2*b2 + 2*omega1*a1*a2 +
/// 12*omega1*a2*a3 - 4*omega2*a1*a2)/(9*omega1^5 - 30*omega1^4*omega2 + 27*omega1^3*omega2^2 -
/// 6*omega1^2*omega2^3)
/// lumps[17]: harmonic_re_x_conjA_y_F = -a2*e1/(omega1^4 - omega1^2*omega2^2)
/// lumps[18]: e1 = e1
/// lumps[19]: harmonic_im_x_F = -omega2*mu1*e1/(omega1^4 - 2*omega1^2*omega2^2 + omega2^4)
/// lumps[20]: harmonic_re_x_A_y2_conjA_y = (-9*omega1^4*omega2^2*b4 + 10*omega1^4*a3*a4 +
/// 36*omega1^2*omega2^4*b4 + 18*omega1^2*omega2^2*a2*a3 - 40*omega1^2*omega2^2*a3*a4 -
/// 48*omega2^4*a2*a3)/(3*omega1^6*omega2^2 - 15*omega1^4*omega2^4 + 12*omega1^2*omega2^6)
/// lumps[21]: harmonic_re_x_A_x_A_y_conjA_x = (-12*omega1^5*omega2^2*b2 + 8*omega1^5*a2*a3 -
/// 6*omega1^4*omega2^3*b2 - 4*omega1^4*omega2*a1*a2 + 4*omega1^4*omega2*a2*a3 + 48*omega1^3*omega2^4*b2 +
/// 8*omega1^3*omega2^2*a1*a2 - 48*omega1^3*omega2^2*a2*a3 + 24*omega1^2*omega2^5*b2 + 20*omega1^2*omega2^3*a1*a2
/// - 24*omega1^2*omega2^3*a2*a3 - 32*omega1*omega2^4*a1*a2 - 16*omega2^5*a1*a2)/(2*omega1^7*omega2^2 +
/// omega1^6*omega2^3 - 10*omega1^5*omega2^4 - 5*omega1^4*omega2^5 + 8*omega1^3*omega2^6 + 4*omega1^2*omega2^7)
/// lumps[22]: harmonic_im_x_A_x2 = -4*a1*mu1/(9*omega1^3)
/// lumps[23]: harmonic_re_x_A_x2_A_y = -4*a2*a3/(omega1^4 - 8*omega1^2*omega2^2 + 16*omega2^4)
/// lumps[24]: harmonic_im_x_A_y2 = (4*omega2*a3*mu1 - 8*omega2*a3*mu2)/(omega1^4 - 8*omega1^2*omega2^2 +
/// 16*omega2^4)
/// lumps[25]: harmonic_re_x_A_y_F = 2*a3*e2/(omega1^4 - 8*omega1^2*omega2^2 + 16*omega2^4)
/// lumps[26]: harmonic_re_x_A_y2_conjA_x = (-3*omega1^3*omega2^2*b3 - 2*omega1^3*a2*a4 + 12*omega1*omega2^4*b3 +
/// 6*omega1*omega2^2*a1*a3 + 8*omega1*omega2^2*a2*a4 - 12*omega1*omega2^2*a3^2 -
/// 24*omega2^3*a3^2)/(12*omega1^4*omega2^3 - 12*omega1^3*omega2^4 - 48*omega1^2*omega2^5 + 48*omega1*omega2^6)
/// lumps[27]: harmonic_re_x_A_x_F = a1*e1/(2*omega1^3*omega2 + omega1^2*omega2^2 - 2*omega1*omega2^3 - omega2^4)
/// lumps[28]: harmonic_re_x_A_x3 = (-2*omega1*a2^2 - 2*omega2*a2^2)/(4*omega1^2*omega2^3 + 4*omega1*omega2^4 +
/// omega2^5)
/// lumps[29]: harmonic_re_x_A_y3 = (-3*omega1^2*omega2^2*b4 - 2*omega1^2*a3*a4 + 12*omega2^4*b4 +
/// 6*omega2^2*a2*a3 + 8*omega2^2*a3*a4)/(3*omega1^4*omega2^2 - 39*omega1^2*omega2^4 + 108*omega2^6)
/// lumps[30]: harmonic_re_x_A_x_A_y2 = (6*omega1^4*omega2^2*b3 + 4*omega1^4*a2*a4 + 3*omega1^3*omega2^3*b3 +
/// 12*omega1^3*omega2*a2^2 + 2*omega1^3*omega2*a2*a4 - 24*omega1^2*omega2^4*b3 - 12*omega1^2*omega2^2*a1*a3 -
/// 16*omega1^2*omega2^2*a2*a4 + 24*omega1^2*omega2^2*a3^2 - 12*omega1*omega2^5*b3 - 6*omega1*omega2^3*a1*a3 -
/// 48*omega1*omega2^3*a2^2 - 8*omega1*omega2^3*a2*a4 - 36*omega1*omega2^3*a3^2 -
/// 24*omega2^4*a3^2)/(24*omega1^5*omega2^3 + 36*omega1^4*omega2^4 - 84*omega1^3*omega2^5 - 144*omega1^2*omega2^6
/// - 48*omega1*omega2^7)
/// lumps[31]: harmonic_im_y_A_y_conjA_x = (4*omega1*a3*mu1 - 4*omega2*a3*mu1)/(omega1^4 - 4*omega1^3*omega2 +
/// 4*omega1^2*omega2^2)
/// lumps[32]: harmonic_re_y_A_x_A_y_conjA_y = (12*omega1^5*omega2^2*b4 - 8*omega1^5*a3*a4 +
/// 6*omega1^4*omega2^3*b4 + 4*omega1^4*omega2*a2*a3 - 4*omega1^4*omega2*a3*a4 - 48*omega1^3*omega2^4*b4 -
/// 8*omega1^3*omega2^2*a2*a3 + 48*omega1^3*omega2^2*a3*a4 - 24*omega1^2*omega2^5*b4 - 20*omega1^2*omega2^3*a2*a3
/// + 24*omega1^2*omega2^3*a3*a4 + 32*omega1*omega2^4*a2*a3 + 16*omega2^5*a2*a3)/(2*omega1^7*omega2^2 +
/// omega1^6*omega2^3 - 10*omega1^5*omega2^4 - 5*omega1^4*omega2^5 + 8*omega1^3*omega2^6 + 4*omega1^2*omega2^7)
/// lumps[33]: harmonic_re_y_A_x2_conjA_x = (9*omega1^2*omega2^2*b2 - 12*omega1^2*a2*a3 -
/// 10*omega2^2*a1*a2)/(3*omega1^4*omega2^2 - 3*omega1^2*omega2^4)
/// lumps[34]: a4 = a4
/// lumps[35]: harmonic_re_y_A_y_conjA_x2 = (3*omega1^3*b3 - 6*omega1^2*omega2*b3 + 2*omega1*a1*a3 +
/// 12*omega1*a3^2 - 4*omega2*a1*a3)/(12*omega1^5 - 36*omega1^4*omega2 + 24*omega1^3*omega2^2)
/// lumps[36]: harmonic_re_y_conjA_y_F = -a3*e1/(omega1^2*omega2^2 - omega2^4)
/// lumps[37]: harmonic_re_y_A_x2_A_y = -4*a2*a4/(9*omega2^4)
/// lumps[38]: harmonic_im_y_A_y2 = -4*a4*mu2/(9*omega2^3)
/// lumps[39]: harmonic_re_y_A_y_F = 2*a4*e2/(9*omega2^4)
/// lumps[40]: harmonic_re_y_A_y2_conjA_x = (9*omega1^3*omega2^2*b4 + 2*omega1^3*a3*a4 - 36*omega1*omega2^4*b4 -
/// 6*omega1*omega2^2*a2*a3 + 4*omega1*omega2^2*a3*a4 + 24*omega2^3*a3*a4)/(3*omega1^5*omega2^2 -
/// 12*omega1^4*omega2^3 - 3*omega1^3*omega2^4 + 48*omega1^2*omega2^5 - 36*omega1*omega2^6)
/// lumps[41]: harmonic_re_y_A_x3 = (3*omega1^2*b2 + 2*a1*a2)/(27*omega1^4 - 3*omega1^2*omega2^2)
/// lumps[42]: harmonic_re_y_A_y3 = (3*omega1^2*omega2^2*b5 + 2*omega1^2*a4^2 - 12*omega2^4*b5 - 6*omega2^2*a3^2
/// - 8*omega2^2*a4^2)/(24*omega1^2*omega2^4 - 96*omega2^6)
/// lumps[43]: harmonic_re_y_A_x_A_y2 = (18*omega1^4*omega2^2*b4 + 4*omega1^4*a3*a4 + 9*omega1^3*omega2^3*b4 +
/// 12*omega1^3*omega2*a2*a3 + 2*omega1^3*omega2*a3*a4 - 72*omega1^2*omega2^4*b4 - 12*omega1^2*omega2^2*a2*a3 +
/// 8*omega1^2*omega2^2*a3*a4 - 36*omega1*omega2^5*b4 - 54*omega1*omega2^3*a2*a3 - 44*omega1*omega2^3*a3*a4 -
/// 24*omega2^4*a3*a4)/(6*omega1^6*omega2^2 + 27*omega1^5*omega2^3 + 6*omega1^4*omega2^4 - 99*omega1^3*omega2^5 -
/// 120*omega1^2*omega2^6 - 36*omega1*omega2^7)
/// 891 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
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
  const Scalar a1_2 = a1 * a1;
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar a4_2 = a4 * a4;
  const Scalar mu1_2 = mu1 * mu1;
  const Scalar mu2_2 = mu2 * mu2;
  lumps[0] = mu1;  // mu1
  lumps[1] = -mu1_2 / (Scalar(2.0) * omega1);  // conservative_x_A_x
  // conservative_x_A_x_A_y_conjA_y
  lumps[2] = (Scalar(4.0) * omega1_5 * omega2_2 * b3 - Scalar(8.0) * omega1_5 * a2 * a4
      + Scalar(2.0) * omega1_4 * omega2_3 * b3 + Scalar(4.0) * omega1_4 * omega2 * a2_2
      - Scalar(4.0) * omega1_4 * omega2 * a2 * a4 - Scalar(16.0) * omega1_3 * omega2_4 * b3
      - Scalar(8.0) * omega1_3 * omega2_2 * a1 * a3 + Scalar(2.0) * omega1_3 * omega2_2 * a2_2
      + Scalar(32.0) * omega1_3 * omega2_2 * a2 * a4 + Scalar(16.0) * omega1_3 * omega2_2 * a3_2
      - Scalar(8.0) * omega1_2 * omega2_5 * b3 - Scalar(4.0) * omega1_2 * omega2_3 * a1 * a3
      - Scalar(15.0) * omega1_2 * omega2_3 * a2_2 + Scalar(16.0) * omega1_2 * omega2_3 * a2 * a4
      + Scalar(8.0) * omega1_2 * omega2_3 * a3_2 + Scalar(32.0) * omega1 * omega2_4 * a1 * a3
      - Scalar(8.0) * omega1 * omega2_4 * a2_2 + Scalar(16.0) * omega2_5 * a1 * a3
      - Scalar(4.0) * omega2_5 * a2_2) / (Scalar(4.0) * omega1_6 * omega2_2 + Scalar(2.0) * omega1_5 * omega2_3
      - Scalar(16.0) * omega1_4 * omega2_4 - Scalar(8.0) * omega1_3 * omega2_5);
  // conservative_x_A_x2_conjA_x
  lumps[3] = (Scalar(18.0) * omega1_2 * omega2_2 * b1 - Scalar(24.0) * omega1_2 * a2_2
      - Scalar(3.0) * omega1 * omega2 * a2_2
      - Scalar(20.0) * omega2_2 * a1_2) / (Scalar(12.0) * omega1_3 * omega2_2);
  lumps[4] = a2 * mu2 / (Scalar(2.0) * omega1_2);  // dissipative_x_A_y_conjA_x
  lumps[5] = a2;  // a2
  // conservative_x_conjA_x_F
  lumps[6] = (omega1_2 * a2 * e2 + Scalar(4.0) * omega1 * omega2 * a1 * e1
      - omega2_2 * a2 * e2) / (Scalar(8.0) * omega1_4 * omega2 - Scalar(8.0) * omega1_2 * omega2_3);
  lumps[7] = (Scalar(2.0) * a2 * mu1 - a2 * mu2) / (Scalar(4.0) * omega2_2);  // dissipative_y_A_x2
  lumps[8] = mu2;  // mu2
  lumps[9] = -mu2_2 / (Scalar(2.0) * omega2);  // conservative_y_A_y
  // conservative_y_A_y2_conjA_y
  lumps[10] = (Scalar(9.0) * omega1_4 * omega2_2 * b5 - Scalar(10.0) * omega1_4 * a4_2
      - Scalar(36.0) * omega1_2 * omega2_4 * b5 - Scalar(18.0) * omega1_2 * omega2_2 * a3_2
      + Scalar(40.0) * omega1_2 * omega2_2 * a4_2
      + Scalar(48.0) * omega2_4 * a3_2) / (Scalar(6.0) * omega1_4 * omega2_3
      - Scalar(24.0) * omega1_2 * omega2_5);
  // conservative_y_A_x_A_y_conjA_x
  lumps[11] = (Scalar(4.0) * omega1_5 * omega2_2 * b3 - Scalar(8.0) * omega1_5 * a2 * a4
      + Scalar(2.0) * omega1_4 * omega2_3 * b3 + Scalar(2.0) * omega1_4 * omega2 * a2_2
      - Scalar(4.0) * omega1_4 * omega2 * a2 * a4 - Scalar(16.0) * omega1_3 * omega2_4 * b3
      - Scalar(8.0) * omega1_3 * omega2_2 * a1 * a3 - omega1_3 * omega2_2 * a2_2
      + Scalar(32.0) * omega1_3 * omega2_2 * a2 * a4 + Scalar(16.0) * omega1_3 * omega2_2 * a3_2
      - Scalar(8.0) * omega1_2 * omega2_5 * b3 - Scalar(4.0) * omega1_2 * omega2_3 * a1 * a3
      - Scalar(8.0) * omega1_2 * omega2_3 * a2_2 + Scalar(16.0) * omega1_2 * omega2_3 * a2 * a4
      + Scalar(8.0) * omega1_2 * omega2_3 * a3_2 + Scalar(32.0) * omega1 * omega2_4 * a1 * a3
      + Scalar(4.0) * omega1 * omega2_4 * a2_2
      + Scalar(16.0) * omega2_5 * a1 * a3) / (Scalar(4.0) * omega1_5 * omega2_3
      + Scalar(2.0) * omega1_4 * omega2_4 - Scalar(16.0) * omega1_3 * omega2_5
      - Scalar(8.0) * omega1_2 * omega2_6);
  lumps[12] = mu2 * e2 / (Scalar(8.0) * omega2_2);  // dissipative_y_F
  lumps[13] = e2;  // e2
  lumps[14] = a3;  // a3
  lumps[15] = a1;  // a1
  // harmonic_re_x_A_y_conjA_x2
  lumps[16] = (Scalar(9.0) * omega1_3 * b2 - Scalar(18.0) * omega1_2 * omega2 * b2
      + Scalar(2.0) * omega1 * a1 * a2 + Scalar(12.0) * omega1 * a2 * a3
      - Scalar(4.0) * omega2 * a1 * a2) / (Scalar(9.0) * omega1_5 - Scalar(30.0) * omega1_4 * omega2
      + Scalar(27.0) * omega1_3 * omega2_2 - Scalar(6.0) * omega1_2 * omega2_3);
  lumps[17] = -a2 * e1 / (omega1_4 - omega1_2 * omega2_2);  // harmonic_re_x_conjA_y_F
  lumps[18] = e1;  // e1
  lumps[19] = -omega2 * mu1 * e1 / (omega1_4 - Scalar(2.0) * omega1_2 * omega2_2 + omega2_4);  // harmonic_im_x_F
  // harmonic_re_x_A_y2_conjA_y
  lumps[20] = (-Scalar(9.0) * omega1_4 * omega2_2 * b4 + Scalar(10.0) * omega1_4 * a3 * a4
      + Scalar(36.0) * omega1_2 * omega2_4 * b4 + Scalar(18.0) * omega1_2 * omega2_2 * a2 * a3
      - Scalar(40.0) * omega1_2 * omega2_2 * a3 * a4
      - Scalar(48.0) * omega2_4 * a2 * a3) / (Scalar(3.0) * omega1_6 * omega2_2
      - Scalar(15.0) * omega1_4 * omega2_4 + Scalar(12.0) * omega1_2 * omega2_6);
  // harmonic_re_x_A_x_A_y_conjA_x
  lumps[21] = (-Scalar(12.0) * omega1_5 * omega2_2 * b2 + Scalar(8.0) * omega1_5 * a2 * a3
      - Scalar(6.0) * omega1_4 * omega2_3 * b2 - Scalar(4.0) * omega1_4 * omega2 * a1 * a2
      + Scalar(4.0) * omega1_4 * omega2 * a2 * a3 + Scalar(48.0) * omega1_3 * omega2_4 * b2
      + Scalar(8.0) * omega1_3 * omega2_2 * a1 * a2 - Scalar(48.0) * omega1_3 * omega2_2 * a2 * a3
      + Scalar(24.0) * omega1_2 * omega2_5 * b2 + Scalar(20.0) * omega1_2 * omega2_3 * a1 * a2
      - Scalar(24.0) * omega1_2 * omega2_3 * a2 * a3 - Scalar(32.0) * omega1 * omega2_4 * a1 * a2
      - Scalar(16.0) * omega2_5 * a1 * a2) / (Scalar(2.0) * omega1_7 * omega2_2 + omega1_6 * omega2_3
      - Scalar(10.0) * omega1_5 * omega2_4 - Scalar(5.0) * omega1_4 * omega2_5 + Scalar(8.0) * omega1_3 * omega2_6
      + Scalar(4.0) * omega1_2 * omega2_7);
  lumps[22] = -Scalar(4.0) * a1 * mu1 / (Scalar(9.0) * omega1_3);  // harmonic_im_x_A_x2
  // harmonic_re_x_A_x2_A_y
  lumps[23] = -Scalar(4.0) * a2 * a3 / (omega1_4 - Scalar(8.0) * omega1_2 * omega2_2 + Scalar(16.0) * omega2_4);
  // harmonic_im_x_A_y2
  lumps[24] = (Scalar(4.0) * omega2 * a3 * mu1 - Scalar(8.0) * omega2 * a3 * mu2) / (omega1_4
      - Scalar(8.0) * omega1_2 * omega2_2 + Scalar(16.0) * omega2_4);
  // harmonic_re_x_A_y_F
  lumps[25] = Scalar(2.0) * a3 * e2 / (omega1_4 - Scalar(8.0) * omega1_2 * omega2_2 + Scalar(16.0) * omega2_4);
  // harmonic_re_x_A_y2_conjA_x
  lumps[26] = (-Scalar(3.0) * omega1_3 * omega2_2 * b3 - Scalar(2.0) * omega1_3 * a2 * a4
      + Scalar(12.0) * omega1 * omega2_4 * b3 + Scalar(6.0) * omega1 * omega2_2 * a1 * a3
      + Scalar(8.0) * omega1 * omega2_2 * a2 * a4 - Scalar(12.0) * omega1 * omega2_2 * a3_2
      - Scalar(24.0) * omega2_3 * a3_2) / (Scalar(12.0) * omega1_4 * omega2_3 - Scalar(12.0) * omega1_3 * omega2_4
      - Scalar(48.0) * omega1_2 * omega2_5 + Scalar(48.0) * omega1 * omega2_6);
  // harmonic_re_x_A_x_F
  lumps[27] = a1 * e1 / (Scalar(2.0) * omega1_3 * omega2 + omega1_2 * omega2_2 - Scalar(2.0) * omega1 * omega2_3
      - omega2_4);
  // harmonic_re_x_A_x3
  lumps[28] = (-Scalar(2.0) * omega1 * a2_2 - Scalar(2.0) * omega2 * a2_2) / (Scalar(4.0) * omega1_2 * omega2_3
      + Scalar(4.0) * omega1 * omega2_4 + omega2_5);
  // harmonic_re_x_A_y3
  lumps[29] = (-Scalar(3.0) * omega1_2 * omega2_2 * b4 - Scalar(2.0) * omega1_2 * a3 * a4
      + Scalar(12.0) * omega2_4 * b4 + Scalar(6.0) * omega2_2 * a2 * a3
      + Scalar(8.0) * omega2_2 * a3 * a4) / (Scalar(3.0) * omega1_4 * omega2_2
      - Scalar(39.0) * omega1_2 * omega2_4 + Scalar(108.0) * omega2_6);
  // harmonic_re_x_A_x_A_y2
  lumps[30] = (Scalar(6.0) * omega1_4 * omega2_2 * b3 + Scalar(4.0) * omega1_4 * a2 * a4
      + Scalar(3.0) * omega1_3 * omega2_3 * b3 + Scalar(12.0) * omega1_3 * omega2 * a2_2
      + Scalar(2.0) * omega1_3 * omega2 * a2 * a4 - Scalar(24.0) * omega1_2 * omega2_4 * b3
      - Scalar(12.0) * omega1_2 * omega2_2 * a1 * a3 - Scalar(16.0) * omega1_2 * omega2_2 * a2 * a4
      + Scalar(24.0) * omega1_2 * omega2_2 * a3_2 - Scalar(12.0) * omega1 * omega2_5 * b3
      - Scalar(6.0) * omega1 * omega2_3 * a1 * a3 - Scalar(48.0) * omega1 * omega2_3 * a2_2
      - Scalar(8.0) * omega1 * omega2_3 * a2 * a4 - Scalar(36.0) * omega1 * omega2_3 * a3_2
      - Scalar(24.0) * omega2_4 * a3_2) / (Scalar(24.0) * omega1_5 * omega2_3 + Scalar(36.0) * omega1_4 * omega2_4
      - Scalar(84.0) * omega1_3 * omega2_5 - Scalar(144.0) * omega1_2 * omega2_6
      - Scalar(48.0) * omega1 * omega2_7);
  // harmonic_im_y_A_y_conjA_x
  lumps[31] = (Scalar(4.0) * omega1 * a3 * mu1 - Scalar(4.0) * omega2 * a3 * mu1) / (omega1_4
      - Scalar(4.0) * omega1_3 * omega2 + Scalar(4.0) * omega1_2 * omega2_2);
  // harmonic_re_y_A_x_A_y_conjA_y
  lumps[32] = (Scalar(12.0) * omega1_5 * omega2_2 * b4 - Scalar(8.0) * omega1_5 * a3 * a4
      + Scalar(6.0) * omega1_4 * omega2_3 * b4 + Scalar(4.0) * omega1_4 * omega2 * a2 * a3
      - Scalar(4.0) * omega1_4 * omega2 * a3 * a4 - Scalar(48.0) * omega1_3 * omega2_4 * b4
      - Scalar(8.0) * omega1_3 * omega2_2 * a2 * a3 + Scalar(48.0) * omega1_3 * omega2_2 * a3 * a4
      - Scalar(24.0) * omega1_2 * omega2_5 * b4 - Scalar(20.0) * omega1_2 * omega2_3 * a2 * a3
      + Scalar(24.0) * omega1_2 * omega2_3 * a3 * a4 + Scalar(32.0) * omega1 * omega2_4 * a2 * a3
      + Scalar(16.0) * omega2_5 * a2 * a3) / (Scalar(2.0) * omega1_7 * omega2_2 + omega1_6 * omega2_3
      - Scalar(10.0) * omega1_5 * omega2_4 - Scalar(5.0) * omega1_4 * omega2_5 + Scalar(8.0) * omega1_3 * omega2_6
      + Scalar(4.0) * omega1_2 * omega2_7);
  // harmonic_re_y_A_x2_conjA_x
  lumps[33] = (Scalar(9.0) * omega1_2 * omega2_2 * b2 - Scalar(12.0) * omega1_2 * a2 * a3
      - Scalar(10.0) * omega2_2 * a1 * a2) / (Scalar(3.0) * omega1_4 * omega2_2
      - Scalar(3.0) * omega1_2 * omega2_4);
  lumps[34] = a4;  // a4
  // harmonic_re_y_A_y_conjA_x2
  lumps[35] = (Scalar(3.0) * omega1_3 * b3 - Scalar(6.0) * omega1_2 * omega2 * b3 + Scalar(2.0) * omega1 * a1 * a3
      + Scalar(12.0) * omega1 * a3_2 - Scalar(4.0) * omega2 * a1 * a3) / (Scalar(12.0) * omega1_5
      - Scalar(36.0) * omega1_4 * omega2 + Scalar(24.0) * omega1_3 * omega2_2);
  lumps[36] = -a3 * e1 / (omega1_2 * omega2_2 - omega2_4);  // harmonic_re_y_conjA_y_F
  lumps[37] = -Scalar(4.0) * a2 * a4 / (Scalar(9.0) * omega2_4);  // harmonic_re_y_A_x2_A_y
  lumps[38] = -Scalar(4.0) * a4 * mu2 / (Scalar(9.0) * omega2_3);  // harmonic_im_y_A_y2
  lumps[39] = Scalar(2.0) * a4 * e2 / (Scalar(9.0) * omega2_4);  // harmonic_re_y_A_y_F
  // harmonic_re_y_A_y2_conjA_x
  lumps[40] = (Scalar(9.0) * omega1_3 * omega2_2 * b4 + Scalar(2.0) * omega1_3 * a3 * a4
      - Scalar(36.0) * omega1 * omega2_4 * b4 - Scalar(6.0) * omega1 * omega2_2 * a2 * a3
      + Scalar(4.0) * omega1 * omega2_2 * a3 * a4
      + Scalar(24.0) * omega2_3 * a3 * a4) / (Scalar(3.0) * omega1_5 * omega2_2
      - Scalar(12.0) * omega1_4 * omega2_3 - Scalar(3.0) * omega1_3 * omega2_4
      + Scalar(48.0) * omega1_2 * omega2_5 - Scalar(36.0) * omega1 * omega2_6);
  // harmonic_re_y_A_x3
  lumps[41] = (Scalar(3.0) * omega1_2 * b2 + Scalar(2.0) * a1 * a2) / (Scalar(27.0) * omega1_4
      - Scalar(3.0) * omega1_2 * omega2_2);
  // harmonic_re_y_A_y3
  lumps[42] = (Scalar(3.0) * omega1_2 * omega2_2 * b5 + Scalar(2.0) * omega1_2 * a4_2
      - Scalar(12.0) * omega2_4 * b5 - Scalar(6.0) * omega2_2 * a3_2
      - Scalar(8.0) * omega2_2 * a4_2) / (Scalar(24.0) * omega1_2 * omega2_4 - Scalar(96.0) * omega2_6);
  // harmonic_re_y_A_x_A_y2
  lumps[43] = (Scalar(18.0) * omega1_4 * omega2_2 * b4 + Scalar(4.0) * omega1_4 * a3 * a4
      + Scalar(9.0) * omega1_3 * omega2_3 * b4 + Scalar(12.0) * omega1_3 * omega2 * a2 * a3
      + Scalar(2.0) * omega1_3 * omega2 * a3 * a4 - Scalar(72.0) * omega1_2 * omega2_4 * b4
      - Scalar(12.0) * omega1_2 * omega2_2 * a2 * a3 + Scalar(8.0) * omega1_2 * omega2_2 * a3 * a4
      - Scalar(36.0) * omega1 * omega2_5 * b4 - Scalar(54.0) * omega1 * omega2_3 * a2 * a3
      - Scalar(44.0) * omega1 * omega2_3 * a3 * a4
      - Scalar(24.0) * omega2_4 * a3 * a4) / (Scalar(6.0) * omega1_6 * omega2_2
      + Scalar(27.0) * omega1_5 * omega2_3 + Scalar(6.0) * omega1_4 * omega2_4
      - Scalar(99.0) * omega1_3 * omega2_5 - Scalar(120.0) * omega1_2 * omega2_6
      - Scalar(36.0) * omega1 * omega2_7);
}

/// gradient[p] = d conservative_x_A_x_A_y_conjA_y / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 150 operations.
template <class Scalar>
void lump_gradient_2(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega1_6 = omega1_5 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar denominator = Scalar(4.0) * omega1_6 * omega2_2 + Scalar(2.0) * omega1_5 * omega2_3
      - Scalar(16.0) * omega1_4 * omega2_4 - Scalar(8.0) * omega1_3 * omega2_5;
  // multiplies a1*a3
  const Scalar c_0 = -Scalar(8.0) * omega1_3 * omega2_2 - Scalar(4.0) * omega1_2 * omega2_3
      + Scalar(32.0) * omega1 * omega2_4 + Scalar(16.0) * omega2_5;
  // multiplies a2^2
  const Scalar c_1 = Scalar(4.0) * omega1_4 * omega2 + Scalar(2.0) * omega1_3 * omega2_2
      - Scalar(15.0) * omega1_2 * omega2_3 - Scalar(8.0) * omega1 * omega2_4 - Scalar(4.0) * omega2_5;
  // multiplies a2*a4
  const Scalar c_2 = -Scalar(8.0) * omega1_5 - Scalar(4.0) * omega1_4 * omega2
      + Scalar(32.0) * omega1_3 * omega2_2 + Scalar(16.0) * omega1_2 * omega2_3;
  const Scalar c_3 = Scalar(16.0) * omega1_3 * omega2_2 + Scalar(8.0) * omega1_2 * omega2_3;  // multiplies a3^2
  // multiplies b3
  const Scalar c_4 = Scalar(4.0) * omega1_5 * omega2_2 + Scalar(2.0) * omega1_4 * omega2_3
      - Scalar(16.0) * omega1_3 * omega2_4 - Scalar(8.0) * omega1_2 * omega2_5;
  const Scalar w_0 = Scalar(4.0) * b3;  // multiplies omega1^5*omega2^2
  const Scalar w_1 = -Scalar(8.0) * a2 * a4;  // multiplies omega1^5
  const Scalar w_2 = Scalar(2.0) * b3;  // multiplies omega1^4*omega2^3
  const Scalar w_3 = Scalar(4.0) * a2_2 - Scalar(4.0) * a2 * a4;  // multiplies omega1^4*omega2
  const Scalar w_4 = -Scalar(16.0) * b3;  // multiplies omega1^3*omega2^4
  // multiplies omega1^3*omega2^2
  const Scalar w_5 = -Scalar(8.0) * a1 * a3 + Scalar(2.0) * a2_2 + Scalar(32.0) * a2 * a4 + Scalar(16.0) * a3_2;
  const Scalar w_6 = -Scalar(8.0) * b3;  // multiplies omega1^2*omega2^5
  // multiplies omega1^2*omega2^3
  const Scalar w_7 = -Scalar(4.0) * a1 * a3 - Scalar(15.0) * a2_2 + Scalar(16.0) * a2 * a4 + Scalar(8.0) * a3_2;
  const Scalar w_8 = Scalar(32.0) * a1 * a3 - Scalar(8.0) * a2_2;  // multiplies omega1*omega2^4
  const Scalar w_9 = Scalar(16.0) * a1 * a3 - Scalar(4.0) * a2_2;  // multiplies omega2^5
  // by omega1
  gradient[0] = (Scalar(5.0) * omega1_4 * omega2_2 * w_0 + Scalar(5.0) * omega1_4 * w_1
      + Scalar(4.0) * omega1_3 * omega2_3 * w_2 + Scalar(4.0) * omega1_3 * omega2 * w_3
      + Scalar(3.0) * omega1_2 * omega2_4 * w_4 + Scalar(3.0) * omega1_2 * omega2_2 * w_5
      + Scalar(2.0) * omega1 * omega2_5 * w_6 + Scalar(2.0) * omega1 * omega2_3 * w_7 + omega2_4 * w_8
      - lump * (Scalar(24.0) * omega1_5 * omega2_2 + Scalar(10.0) * omega1_4 * omega2_3
      - Scalar(64.0) * omega1_3 * omega2_4 - Scalar(24.0) * omega1_2 * omega2_5)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_5 * omega2 * w_0 + Scalar(3.0) * omega1_4 * omega2_2 * w_2 + omega1_4 * w_3
      + Scalar(4.0) * omega1_3 * omega2_3 * w_4 + Scalar(2.0) * omega1_3 * omega2 * w_5
      + Scalar(5.0) * omega1_2 * omega2_4 * w_6 + Scalar(3.0) * omega1_2 * omega2_2 * w_7
      + Scalar(4.0) * omega1 * omega2_3 * w_8 + Scalar(5.0) * omega2_4 * w_9
      - lump * (Scalar(8.0) * omega1_6 * omega2 + Scalar(6.0) * omega1_5 * omega2_2
      - Scalar(64.0) * omega1_4 * omega2_3 - Scalar(40.0) * omega1_3 * omega2_4)) / denominator;
  gradient[2] = (a3 * c_0) / denominator;  // by a1
  gradient[3] = (Scalar(2.0) * a2 * c_1 + a4 * c_2) / denominator;  // by a2
  gradient[4] = (a1 * c_0 + Scalar(2.0) * a3 * c_3) / denominator;  // by a3
  gradient[5] = (a2 * c_2) / denominator;  // by a4
  gradient[8] = (c_4) / denominator;  // by b3
}

/// gradient[p] = d conservative_x_conjA_x_F / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 40 operations.
template <class Scalar>
void lump_gradient_6(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar e1 = parameters[12];
  const Scalar e2 = parameters[14];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar denominator = Scalar(8.0) * omega1_4 * omega2 - Scalar(8.0) * omega1_2 * omega2_3;
  // by omega1
  gradient[0] = (Scalar(2.0) * omega1 * a2 * e2 + Scalar(4.0) * omega2 * a1 * e1
      - lump * (Scalar(32.0) * omega1_3 * omega2 - Scalar(16.0) * omega1 * omega2_3)) / denominator;
  // by omega2
  gradient[1] = (Scalar(4.0) * omega1 * a1 * e1 - Scalar(2.0) * omega2 * a2 * e2 - lump * (Scalar(8.0) * omega1_4
      - Scalar(24.0) * omega1_2 * omega2_2)) / denominator;
  gradient[2] = (Scalar(4.0) * omega1 * omega2 * e1) / denominator;  // by a1
  gradient[3] = (omega1_2 * e2 - omega2_2 * e2) / denominator;  // by a2
  gradient[12] = (Scalar(4.0) * omega1 * omega2 * a1) / denominator;  // by e1
  gradient[14] = (omega1_2 * a2 - omega2_2 * a2) / denominator;  // by e2
}

/// gradient[p] = d conservative_y_A_y2_conjA_y / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 68 operations.
template <class Scalar>
void lump_gradient_10(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b5 = parameters[10];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar a3_2 = a3 * a3;
  const Scalar a4_2 = a4 * a4;
  const Scalar denominator = Scalar(6.0) * omega1_4 * omega2_3 - Scalar(24.0) * omega1_2 * omega2_5;
  // by omega1
  gradient[0] = (Scalar(36.0) * omega1_3 * omega2_2 * b5 - Scalar(40.0) * omega1_3 * a4_2
      - Scalar(72.0) * omega1 * omega2_4 * b5 - Scalar(36.0) * omega1 * omega2_2 * a3_2
      + Scalar(80.0) * omega1 * omega2_2 * a4_2 - lump * (Scalar(24.0) * omega1_3 * omega2_3
      - Scalar(48.0) * omega1 * omega2_5)) / denominator;
  // by omega2
  gradient[1] = (Scalar(18.0) * omega1_4 * omega2 * b5 - Scalar(144.0) * omega1_2 * omega2_3 * b5
      - Scalar(36.0) * omega1_2 * omega2 * a3_2 + Scalar(80.0) * omega1_2 * omega2 * a4_2
      + Scalar(192.0) * omega2_3 * a3_2 - lump * (Scalar(18.0) * omega1_4 * omega2_2
      - Scalar(120.0) * omega1_2 * omega2_4)) / denominator;
  gradient[4] = (-Scalar(36.0) * omega1_2 * omega2_2 * a3 + Scalar(96.0) * omega2_4 * a3) / denominator;  // by a3
  gradient[5] = (-Scalar(20.0) * omega1_4 * a4 + Scalar(80.0) * omega1_2 * omega2_2 * a4) / denominator;  // by a4
  gradient[10] = (Scalar(9.0) * omega1_4 * omega2_2 - Scalar(36.0) * omega1_2 * omega2_4) / denominator;  // by b5
}

/// gradient[p] = d conservative_y_A_x_A_y_conjA_x / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 144 operations.
template <class Scalar>
void lump_gradient_11(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar denominator = Scalar(4.0) * omega1_5 * omega2_3 + Scalar(2.0) * omega1_4 * omega2_4
      - Scalar(16.0) * omega1_3 * omega2_5 - Scalar(8.0) * omega1_2 * omega2_6;
  // multiplies a1*a3
  const Scalar c_0 = -Scalar(8.0) * omega1_3 * omega2_2 - Scalar(4.0) * omega1_2 * omega2_3
      + Scalar(32.0) * omega1 * omega2_4 + Scalar(16.0) * omega2_5;
  // multiplies a2^2
  const Scalar c_1 = Scalar(2.0) * omega1_4 * omega2 - omega1_3 * omega2_2 - Scalar(8.0) * omega1_2 * omega2_3
      + Scalar(4.0) * omega1 * omega2_4;
  // multiplies a2*a4
  const Scalar c_2 = -Scalar(8.0) * omega1_5 - Scalar(4.0) * omega1_4 * omega2
      + Scalar(32.0) * omega1_3 * omega2_2 + Scalar(16.0) * omega1_2 * omega2_3;
  const Scalar c_3 = Scalar(16.0) * omega1_3 * omega2_2 + Scalar(8.0) * omega1_2 * omega2_3;  // multiplies a3^2
  // multiplies b3
  const Scalar c_4 = Scalar(4.0) * omega1_5 * omega2_2 + Scalar(2.0) * omega1_4 * omega2_3
      - Scalar(16.0) * omega1_3 * omega2_4 - Scalar(8.0) * omega1_2 * omega2_5;
  const Scalar w_0 = Scalar(4.0) * b3;  // multiplies omega1^5*omega2^2
  const Scalar w_1 = -Scalar(8.0) * a2 * a4;  // multiplies omega1^5
  const Scalar w_2 = Scalar(2.0) * b3;  // multiplies omega1^4*omega2^3
  const Scalar w_3 = Scalar(2.0) * a2_2 - Scalar(4.0) * a2 * a4;  // multiplies omega1^4*omega2
  const Scalar w_4 = -Scalar(16.0) * b3;  // multiplies omega1^3*omega2^4
  // multiplies omega1^3*omega2^2
  const Scalar w_5 = -Scalar(8.0) * a1 * a3 - a2_2 + Scalar(32.0) * a2 * a4 + Scalar(16.0) * a3_2;
  const Scalar w_6 = -Scalar(8.0) * b3;  // multiplies omega1^2*omega2^5
  // multiplies omega1^2*omega2^3
  const Scalar w_7 = -Scalar(4.0) * a1 * a3 - Scalar(8.0) * a2_2 + Scalar(16.0) * a2 * a4 + Scalar(8.0) * a3_2;
  const Scalar w_8 = Scalar(32.0) * a1 * a3 + Scalar(4.0) * a2_2;  // multiplies omega1*omega2^4
  const Scalar w_9 = Scalar(16.0) * a1 * a3;  // multiplies omega2^5
  // by omega1
  gradient[0] = (Scalar(5.0) * omega1_4 * omega2_2 * w_0 + Scalar(5.0) * omega1_4 * w_1
      + Scalar(4.0) * omega1_3 * omega2_3 * w_2 + Scalar(4.0) * omega1_3 * omega2 * w_3
      + Scalar(3.0) * omega1_2 * omega2_4 * w_4 + Scalar(3.0) * omega1_2 * omega2_2 * w_5
      + Scalar(2.0) * omega1 * omega2_5 * w_6 + Scalar(2.0) * omega1 * omega2_3 * w_7 + omega2_4 * w_8
      - lump * (Scalar(20.0) * omega1_4 * omega2_3 + Scalar(8.0) * omega1_3 * omega2_4
      - Scalar(48.0) * omega1_2 * omega2_5 - Scalar(16.0) * omega1 * omega2_6)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_5 * omega2 * w_0 + Scalar(3.0) * omega1_4 * omega2_2 * w_2 + omega1_4 * w_3
      + Scalar(4.0) * omega1_3 * omega2_3 * w_4 + Scalar(2.0) * omega1_3 * omega2 * w_5
      + Scalar(5.0) * omega1_2 * omega2_4 * w_6 + Scalar(3.0) * omega1_2 * omega2_2 * w_7
      + Scalar(4.0) * omega1 * omega2_3 * w_8 + Scalar(5.0) * omega2_4 * w_9
      - lump * (Scalar(12.0) * omega1_5 * omega2_2 + Scalar(8.0) * omega1_4 * omega2_3
      - Scalar(80.0) * omega1_3 * omega2_4 - Scalar(48.0) * omega1_2 * omega2_5)) / denominator;
  gradient[2] = (a3 * c_0) / denominator;  // by a1
  gradient[3] = (Scalar(2.0) * a2 * c_1 + a4 * c_2) / denominator;  // by a2
  gradient[4] = (a1 * c_0 + Scalar(2.0) * a3 * c_3) / denominator;  // by a3
  gradient[5] = (a2 * c_2) / denominator;  // by a4
  gradient[8] = (c_4) / denominator;  // by b3
}

/// gradient[p] = d harmonic_re_x_A_y_conjA_x2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 63 operations.
template <class Scalar>
void lump_gradient_16(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar b2 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar denominator = Scalar(9.0) * omega1_5 - Scalar(30.0) * omega1_4 * omega2
      + Scalar(27.0) * omega1_3 * omega2_2 - Scalar(6.0) * omega1_2 * omega2_3;
  // by omega1
  gradient[0] = (Scalar(27.0) * omega1_2 * b2 - Scalar(36.0) * omega1 * omega2 * b2 + Scalar(2.0) * a1 * a2
      + Scalar(12.0) * a2 * a3 - lump * (Scalar(45.0) * omega1_4 - Scalar(120.0) * omega1_3 * omega2
      + Scalar(81.0) * omega1_2 * omega2_2 - Scalar(12.0) * omega1 * omega2_3)) / denominator;
  // by omega2
  gradient[1] = (-Scalar(18.0) * omega1_2 * b2 - Scalar(4.0) * a1 * a2 - lump * (-Scalar(30.0) * omega1_4
      + Scalar(54.0) * omega1_3 * omega2 - Scalar(18.0) * omega1_2 * omega2_2)) / denominator;
  gradient[2] = (Scalar(2.0) * omega1 * a2 - Scalar(4.0) * omega2 * a2) / denominator;  // by a1
  // by a2
  gradient[3] = (Scalar(2.0) * omega1 * a1 + Scalar(12.0) * omega1 * a3
      - Scalar(4.0) * omega2 * a1) / denominator;
  gradient[4] = (Scalar(12.0) * omega1 * a2) / denominator;  // by a3
  gradient[7] = (Scalar(9.0) * omega1_3 - Scalar(18.0) * omega1_2 * omega2) / denominator;  // by b2
}

/// gradient[p] = d harmonic_re_x_conjA_y_F / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 8 operations.
template <class Scalar>
void lump_gradient_17(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar e1 = parameters[12];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar denominator = omega1_4 - omega1_2 * omega2_2;
  gradient[0] = (-lump * (Scalar(4.0) * omega1_3 - Scalar(2.0) * omega1 * omega2_2)) / denominator;  // by omega1
  gradient[1] = (-lump * (-Scalar(2.0) * omega1_2 * omega2)) / denominator;  // by omega2
  gradient[3] = (-e1) / denominator;  // by a2
  gradient[12] = (-a2) / denominator;  // by e1
}

/// gradient[p] = d harmonic_im_x_F / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 15 operations.
template <class Scalar>
void lump_gradient_19(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu1 = parameters[11];
  const Scalar e1 = parameters[12];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar denominator = omega1_4 - Scalar(2.0) * omega1_2 * omega2_2 + omega2_4;
  gradient[0] = (-lump * (Scalar(4.0) * omega1_3 - Scalar(4.0) * omega1 * omega2_2)) / denominator;  // by omega1
  // by omega2
  gradient[1] = (-mu1 * e1 - lump * (-Scalar(4.0) * omega1_2 * omega2 + Scalar(4.0) * omega2_3)) / denominator;
  gradient[11] = (-omega2 * e1) / denominator;  // by mu1
  gradient[12] = (-omega2 * mu1) / denominator;  // by e1
}

/// gradient[p] = d harmonic_re_x_A_y2_conjA_y / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 96 operations.
template <class Scalar>
void lump_gradient_20(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
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
  const Scalar denominator = Scalar(3.0) * omega1_6 * omega2_2 - Scalar(15.0) * omega1_4 * omega2_4
      + Scalar(12.0) * omega1_2 * omega2_6;
  // by omega1
  gradient[0] = (-Scalar(36.0) * omega1_3 * omega2_2 * b4 + Scalar(40.0) * omega1_3 * a3 * a4
      + Scalar(72.0) * omega1 * omega2_4 * b4 + Scalar(36.0) * omega1 * omega2_2 * a2 * a3
      - Scalar(80.0) * omega1 * omega2_2 * a3 * a4 - lump * (Scalar(18.0) * omega1_5 * omega2_2
      - Scalar(60.0) * omega1_3 * omega2_4 + Scalar(24.0) * omega1 * omega2_6)) / denominator;
  // by omega2
  gradient[1] = (-Scalar(18.0) * omega1_4 * omega2 * b4 + Scalar(144.0) * omega1_2 * omega2_3 * b4
      + Scalar(36.0) * omega1_2 * omega2 * a2 * a3 - Scalar(80.0) * omega1_2 * omega2 * a3 * a4
      - Scalar(192.0) * omega2_3 * a2 * a3 - lump * (Scalar(6.0) * omega1_6 * omega2
      - Scalar(60.0) * omega1_4 * omega2_3 + Scalar(72.0) * omega1_2 * omega2_5)) / denominator;
  gradient[3] = (Scalar(18.0) * omega1_2 * omega2_2 * a3 - Scalar(48.0) * omega2_4 * a3) / denominator;  // by a2
  // by a3
  gradient[4] = (Scalar(10.0) * omega1_4 * a4 + Scalar(18.0) * omega1_2 * omega2_2 * a2
      - Scalar(40.0) * omega1_2 * omega2_2 * a4 - Scalar(48.0) * omega2_4 * a2) / denominator;
  gradient[5] = (Scalar(10.0) * omega1_4 * a3 - Scalar(40.0) * omega1_2 * omega2_2 * a3) / denominator;  // by a4
  gradient[9] = (-Scalar(9.0) * omega1_4 * omega2_2 + Scalar(36.0) * omega1_2 * omega2_4) / denominator;  // by b4
}

/// gradient[p] = d harmonic_re_x_A_x_A_y_conjA_x / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 139 operations.
template <class Scalar>
void lump_gradient_21(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar b2 = parameters[7];
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
  const Scalar denominator = Scalar(2.0) * omega1_7 * omega2_2 + omega1_6 * omega2_3
      - Scalar(10.0) * omega1_5 * omega2_4 - Scalar(5.0) * omega1_4 * omega2_5 + Scalar(8.0) * omega1_3 * omega2_6
      + Scalar(4.0) * omega1_2 * omega2_7;
  // multiplies a1*a2
  const Scalar c_0 = -Scalar(4.0) * omega1_4 * omega2 + Scalar(8.0) * omega1_3 * omega2_2
      + Scalar(20.0) * omega1_2 * omega2_3 - Scalar(32.0) * omega1 * omega2_4 - Scalar(16.0) * omega2_5;
  // multiplies a2*a3
  const Scalar c_1 = Scalar(8.0) * omega1_5 + Scalar(4.0) * omega1_4 * omega2 - Scalar(48.0) * omega1_3 * omega2_2
      - Scalar(24.0) * omega1_2 * omega2_3;
  // multiplies b2
  const Scalar c_2 = -Scalar(12.0) * omega1_5 * omega2_2 - Scalar(6.0) * omega1_4 * omega2_3
      + Scalar(48.0) * omega1_3 * omega2_4 + Scalar(24.0) * omega1_2 * omega2_5;
  const Scalar w_0 = -Scalar(12.0) * b2;  // multiplies omega1^5*omega2^2
  const Scalar w_1 = Scalar(8.0) * a2 * a3;  // multiplies omega1^5
  const Scalar w_2 = -Scalar(6.0) * b2;  // multiplies omega1^4*omega2^3
  const Scalar w_3 = -Scalar(4.0) * a1 * a2 + Scalar(4.0) * a2 * a3;  // multiplies omega1^4*omega2
  const Scalar w_4 = Scalar(48.0) * b2;  // multiplies omega1^3*omega2^4
  const Scalar w_5 = Scalar(8.0) * a1 * a2 - Scalar(48.0) * a2 * a3;  // multiplies omega1^3*omega2^2
  const Scalar w_6 = Scalar(24.0) * b2;  // multiplies omega1^2*omega2^5
  const Scalar w_7 = Scalar(20.0) * a1 * a2 - Scalar(24.0) * a2 * a3;  // multiplies omega1^2*omega2^3
  const Scalar w_8 = -Scalar(32.0) * a1 * a2;  // multiplies omega1*omega2^4
  const Scalar w_9 = -Scalar(16.0) * a1 * a2;  // multiplies omega2^5
  // by omega1
  gradient[0] = (Scalar(5.0) * omega1_4 * omega2_2 * w_0 + Scalar(5.0) * omega1_4 * w_1
      + Scalar(4.0) * omega1_3 * omega2_3 * w_2 + Scalar(4.0) * omega1_3 * omega2 * w_3
      + Scalar(3.0) * omega1_2 * omega2_4 * w_4 + Scalar(3.0) * omega1_2 * omega2_2 * w_5
      + Scalar(2.0) * omega1 * omega2_5 * w_6 + Scalar(2.0) * omega1 * omega2_3 * w_7 + omega2_4 * w_8
      - lump * (Scalar(14.0) * omega1_6 * omega2_2 + Scalar(6.0) * omega1_5 * omega2_3
      - Scalar(50.0) * omega1_4 * omega2_4 - Scalar(20.0) * omega1_3 * omega2_5
      + Scalar(24.0) * omega1_2 * omega2_6 + Scalar(8.0) * omega1 * omega2_7)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_5 * omega2 * w_0 + Scalar(3.0) * omega1_4 * omega2_2 * w_2 + omega1_4 * w_3
      + Scalar(4.0) * omega1_3 * omega2_3 * w_4 + Scalar(2.0) * omega1_3 * omega2 * w_5
      + Scalar(5.0) * omega1_2 * omega2_4 * w_6 + Scalar(3.0) * omega1_2 * omega2_2 * w_7
      + Scalar(4.0) * omega1 * omega2_3 * w_8 + Scalar(5.0) * omega2_4 * w_9
      - lump * (Scalar(4.0) * omega1_7 * omega2 + Scalar(3.0) * omega1_6 * omega2_2
      - Scalar(40.0) * omega1_5 * omega2_3 - Scalar(25.0) * omega1_4 * omega2_4
      + Scalar(48.0) * omega1_3 * omega2_5 + Scalar(28.0) * omega1_2 * omega2_6)) / denominator;
  gradient[2] = (a2 * c_0) / denominator;  // by a1
  gradient[3] = (a1 * c_0 + a3 * c_1) / denominator;  // by a2
  gradient[4] = (a2 * c_1) / denominator;  // by a3
  gradient[7] = (c_2) / denominator;  // by b2
}

/// gradient[p] = d harmonic_re_x_A_x2_A_y / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 15 operations.
template <class Scalar>
void lump_gradient_23(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar denominator = omega1_4 - Scalar(8.0) * omega1_2 * omega2_2 + Scalar(16.0) * omega2_4;
  gradient[0] = (-lump * (Scalar(4.0) * omega1_3 - Scalar(16.0) * omega1 * omega2_2)) / denominator;  // by omega1
  // by omega2
  gradient[1] = (-lump * (-Scalar(16.0) * omega1_2 * omega2 + Scalar(64.0) * omega2_3)) / denominator;
  gradient[3] = (-Scalar(4.0) * a3) / denominator;  // by a2
  gradient[4] = (-Scalar(4.0) * a2) / denominator;  // by a3
}

/// gradient[p] = d harmonic_im_x_A_y2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 27 operations.
template <class Scalar>
void lump_gradient_24(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a3 = parameters[4];
  const Scalar mu1 = parameters[11];
  const Scalar mu2 = parameters[13];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar denominator = omega1_4 - Scalar(8.0) * omega1_2 * omega2_2 + Scalar(16.0) * omega2_4;
  gradient[0] = (-lump * (Scalar(4.0) * omega1_3 - Scalar(16.0) * omega1 * omega2_2)) / denominator;  // by omega1
  // by omega2
  gradient[1] = (Scalar(4.0) * a3 * mu1 - Scalar(8.0) * a3 * mu2 - lump * (-Scalar(16.0) * omega1_2 * omega2
      + Scalar(64.0) * omega2_3)) / denominator;
  gradient[4] = (Scalar(4.0) * omega2 * mu1 - Scalar(8.0) * omega2 * mu2) / denominator;  // by a3
  gradient[11] = (Scalar(4.0) * omega2 * a3) / denominator;  // by mu1
  gradient[13] = (-Scalar(8.0) * omega2 * a3) / denominator;  // by mu2
}

/// gradient[p] = d harmonic_re_x_A_y_F / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 15 operations.
template <class Scalar>
void lump_gradient_25(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a3 = parameters[4];
  const Scalar e2 = parameters[14];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar denominator = omega1_4 - Scalar(8.0) * omega1_2 * omega2_2 + Scalar(16.0) * omega2_4;
  gradient[0] = (-lump * (Scalar(4.0) * omega1_3 - Scalar(16.0) * omega1 * omega2_2)) / denominator;  // by omega1
  // by omega2
  gradient[1] = (-lump * (-Scalar(16.0) * omega1_2 * omega2 + Scalar(64.0) * omega2_3)) / denominator;
  gradient[4] = (Scalar(2.0) * e2) / denominator;  // by a3
  gradient[14] = (Scalar(2.0) * a3) / denominator;  // by e2
}

/// gradient[p] = d harmonic_re_x_A_y2_conjA_x / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 70 operations.
template <class Scalar>
void lump_gradient_26(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar a3_2 = a3 * a3;
  const Scalar denominator = Scalar(12.0) * omega1_4 * omega2_3 - Scalar(12.0) * omega1_3 * omega2_4
      - Scalar(48.0) * omega1_2 * omega2_5 + Scalar(48.0) * omega1 * omega2_6;
  const Scalar c_0 = Scalar(6.0) * omega1 * omega2_2;  // multiplies a1*a3
  const Scalar c_1 = -Scalar(2.0) * omega1_3 + Scalar(8.0) * omega1 * omega2_2;  // multiplies a2*a4
  const Scalar c_2 = -Scalar(12.0) * omega1 * omega2_2 - Scalar(24.0) * omega2_3;  // multiplies a3^2
  const Scalar c_3 = -Scalar(3.0) * omega1_3 * omega2_2 + Scalar(12.0) * omega1 * omega2_4;  // multiplies b3
  const Scalar w_0 = -Scalar(3.0) * b3;  // multiplies omega1^3*omega2^2
  const Scalar w_1 = -Scalar(2.0) * a2 * a4;  // multiplies omega1^3
  const Scalar w_2 = Scalar(12.0) * b3;  // multiplies omega1*omega2^4
  // multiplies omega1*omega2^2
  const Scalar w_3 = Scalar(6.0) * a1 * a3 + Scalar(8.0) * a2 * a4 - Scalar(12.0) * a3_2;
  const Scalar w_4 = -Scalar(24.0) * a3_2;  // multiplies omega2^3
  // by omega1
  gradient[0] = (Scalar(3.0) * omega1_2 * omega2_2 * w_0 + Scalar(3.0) * omega1_2 * w_1 + omega2_4 * w_2
      + omega2_2 * w_3 - lump * (Scalar(48.0) * omega1_3 * omega2_3 - Scalar(36.0) * omega1_2 * omega2_4
      - Scalar(96.0) * omega1 * omega2_5 + Scalar(48.0) * omega2_6)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_3 * omega2 * w_0 + Scalar(4.0) * omega1 * omega2_3 * w_2
      + Scalar(2.0) * omega1 * omega2 * w_3 + Scalar(3.0) * omega2_2 * w_4
      - lump * (Scalar(36.0) * omega1_4 * omega2_2 - Scalar(48.0) * omega1_3 * omega2_3
      - Scalar(240.0) * omega1_2 * omega2_4 + Scalar(288.0) * omega1 * omega2_5)) / denominator;
  gradient[2] = (a3 * c_0) / denominator;  // by a1
  gradient[3] = (a4 * c_1) / denominator;  // by a2
  gradient[4] = (a1 * c_0 + Scalar(2.0) * a3 * c_2) / denominator;  // by a3
  gradient[5] = (a2 * c_1) / denominator;  // by a4
  gradient[8] = (c_3) / denominator;  // by b3
}

/// gradient[p] = d harmonic_re_x_A_x_F / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 24 operations.
template <class Scalar>
void lump_gradient_27(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar e1 = parameters[12];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar denominator = Scalar(2.0) * omega1_3 * omega2 + omega1_2 * omega2_2
      - Scalar(2.0) * omega1 * omega2_3 - omega2_4;
  // by omega1
  gradient[0] = (-lump * (Scalar(6.0) * omega1_2 * omega2 + Scalar(2.0) * omega1 * omega2_2
      - Scalar(2.0) * omega2_3)) / denominator;
  // by omega2
  gradient[1] = (-lump * (Scalar(2.0) * omega1_3 + Scalar(2.0) * omega1_2 * omega2
      - Scalar(6.0) * omega1 * omega2_2 - Scalar(4.0) * omega2_3)) / denominator;
  gradient[2] = (e1) / denominator;  // by a1
  gradient[12] = (a1) / denominator;  // by e1
}

/// gradient[p] = d harmonic_re_x_A_x3 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 24 operations.
template <class Scalar>
void lump_gradient_28(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar a2_2 = a2 * a2;
  const Scalar denominator = Scalar(4.0) * omega1_2 * omega2_3 + Scalar(4.0) * omega1 * omega2_4 + omega2_5;
  // by omega1
  gradient[0] = (-Scalar(2.0) * a2_2 - lump * (Scalar(8.0) * omega1 * omega2_3
      + Scalar(4.0) * omega2_4)) / denominator;
  // by omega2
  gradient[1] = (-Scalar(2.0) * a2_2 - lump * (Scalar(12.0) * omega1_2 * omega2_2
      + Scalar(16.0) * omega1 * omega2_3 + Scalar(5.0) * omega2_4)) / denominator;
  gradient[3] = (-Scalar(4.0) * omega1 * a2 - Scalar(4.0) * omega2 * a2) / denominator;  // by a2
}

/// gradient[p] = d harmonic_re_x_A_y3 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 59 operations.
template <class Scalar>
void lump_gradient_29(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar denominator = Scalar(3.0) * omega1_4 * omega2_2 - Scalar(39.0) * omega1_2 * omega2_4
      + Scalar(108.0) * omega2_6;
  // by omega1
  gradient[0] = (-Scalar(6.0) * omega1 * omega2_2 * b4 - Scalar(4.0) * omega1 * a3 * a4
      - lump * (Scalar(12.0) * omega1_3 * omega2_2 - Scalar(78.0) * omega1 * omega2_4)) / denominator;
  // by omega2
  gradient[1] = (-Scalar(6.0) * omega1_2 * omega2 * b4 + Scalar(48.0) * omega2_3 * b4
      + Scalar(12.0) * omega2 * a2 * a3 + Scalar(16.0) * omega2 * a3 * a4
      - lump * (Scalar(6.0) * omega1_4 * omega2 - Scalar(156.0) * omega1_2 * omega2_3
      + Scalar(648.0) * omega2_5)) / denominator;
  gradient[3] = (Scalar(6.0) * omega2_2 * a3) / denominator;  // by a2
  // by a3
  gradient[4] = (-Scalar(2.0) * omega1_2 * a4 + Scalar(6.0) * omega2_2 * a2
      + Scalar(8.0) * omega2_2 * a4) / denominator;
  gradient[5] = (-Scalar(2.0) * omega1_2 * a3 + Scalar(8.0) * omega2_2 * a3) / denominator;  // by a4
  gradient[9] = (-Scalar(3.0) * omega1_2 * omega2_2 + Scalar(12.0) * omega2_4) / denominator;  // by b4
}

/// gradient[p] = d harmonic_re_x_A_x_A_y2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 132 operations.
template <class Scalar>
void lump_gradient_30(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar omega2_7 = omega2_6 * omega2;
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar denominator = Scalar(24.0) * omega1_5 * omega2_3 + Scalar(36.0) * omega1_4 * omega2_4
      - Scalar(84.0) * omega1_3 * omega2_5 - Scalar(144.0) * omega1_2 * omega2_6
      - Scalar(48.0) * omega1 * omega2_7;
  const Scalar c_0 = -Scalar(12.0) * omega1_2 * omega2_2 - Scalar(6.0) * omega1 * omega2_3;  // multiplies a1*a3
  const Scalar c_1 = Scalar(12.0) * omega1_3 * omega2 - Scalar(48.0) * omega1 * omega2_3;  // multiplies a2^2
  // multiplies a2*a4
  const Scalar c_2 = Scalar(4.0) * omega1_4 + Scalar(2.0) * omega1_3 * omega2 - Scalar(16.0) * omega1_2 * omega2_2
      - Scalar(8.0) * omega1 * omega2_3;
  // multiplies a3^2
  const Scalar c_3 = Scalar(24.0) * omega1_2 * omega2_2 - Scalar(36.0) * omega1 * omega2_3
      - Scalar(24.0) * omega2_4;
  // multiplies b3
  const Scalar c_4 = Scalar(6.0) * omega1_4 * omega2_2 + Scalar(3.0) * omega1_3 * omega2_3
      - Scalar(24.0) * omega1_2 * omega2_4 - Scalar(12.0) * omega1 * omega2_5;
  const Scalar w_0 = Scalar(6.0) * b3;  // multiplies omega1^4*omega2^2
  const Scalar w_1 = Scalar(4.0) * a2 * a4;  // multiplies omega1^4
  const Scalar w_2 = Scalar(3.0) * b3;  // multiplies omega1^3*omega2^3
  const Scalar w_3 = Scalar(12.0) * a2_2 + Scalar(2.0) * a2 * a4;  // multiplies omega1^3*omega2
  const Scalar w_4 = -Scalar(24.0) * b3;  // multiplies omega1^2*omega2^4
  // multiplies omega1^2*omega2^2
  const Scalar w_5 = -Scalar(12.0) * a1 * a3 - Scalar(16.0) * a2 * a4 + Scalar(24.0) * a3_2;
  const Scalar w_6 = -Scalar(12.0) * b3;  // multiplies omega1*omega2^5
  // multiplies omega1*omega2^3
  const Scalar w_7 = -Scalar(6.0) * a1 * a3 - Scalar(48.0) * a2_2 - Scalar(8.0) * a2 * a4 - Scalar(36.0) * a3_2;
  const Scalar w_8 = -Scalar(24.0) * a3_2;  // multiplies omega2^4
  // by omega1
  gradient[0] = (Scalar(4.0) * omega1_3 * omega2_2 * w_0 + Scalar(4.0) * omega1_3 * w_1
      + Scalar(3.0) * omega1_2 * omega2_3 * w_2 + Scalar(3.0) * omega1_2 * omega2 * w_3
      + Scalar(2.0) * omega1 * omega2_4 * w_4 + Scalar(2.0) * omega1 * omega2_2 * w_5 + omega2_5 * w_6
      + omega2_3 * w_7 - lump * (Scalar(120.0) * omega1_4 * omega2_3 + Scalar(144.0) * omega1_3 * omega2_4
      - Scalar(252.0) * omega1_2 * omega2_5 - Scalar(288.0) * omega1 * omega2_6
      - Scalar(48.0) * omega2_7)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_4 * omega2 * w_0 + Scalar(3.0) * omega1_3 * omega2_2 * w_2 + omega1_3 * w_3
      + Scalar(4.0) * omega1_2 * omega2_3 * w_4 + Scalar(2.0) * omega1_2 * omega2 * w_5
      + Scalar(5.0) * omega1 * omega2_4 * w_6 + Scalar(3.0) * omega1 * omega2_2 * w_7
      + Scalar(4.0) * omega2_3 * w_8 - lump * (Scalar(72.0) * omega1_5 * omega2_2
      + Scalar(144.0) * omega1_4 * omega2_3 - Scalar(420.0) * omega1_3 * omega2_4
      - Scalar(864.0) * omega1_2 * omega2_5 - Scalar(336.0) * omega1 * omega2_6)) / denominator;
  gradient[2] = (a3 * c_0) / denominator;  // by a1
  gradient[3] = (Scalar(2.0) * a2 * c_1 + a4 * c_2) / denominator;  // by a2
  gradient[4] = (a1 * c_0 + Scalar(2.0) * a3 * c_3) / denominator;  // by a3
  gradient[5] = (a2 * c_2) / denominator;  // by a4
  gradient[8] = (c_4) / denominator;  // by b3
}

/// gradient[p] = d harmonic_im_y_A_y_conjA_x / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 31 operations.
template <class Scalar>
void lump_gradient_31(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a3 = parameters[4];
  const Scalar mu1 = parameters[11];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar denominator = omega1_4 - Scalar(4.0) * omega1_3 * omega2 + Scalar(4.0) * omega1_2 * omega2_2;
  // by omega1
  gradient[0] = (Scalar(4.0) * a3 * mu1 - lump * (Scalar(4.0) * omega1_3 - Scalar(12.0) * omega1_2 * omega2
      + Scalar(8.0) * omega1 * omega2_2)) / denominator;
  // by omega2
  gradient[1] = (-Scalar(4.0) * a3 * mu1 - lump * (-Scalar(4.0) * omega1_3
      + Scalar(8.0) * omega1_2 * omega2)) / denominator;
  gradient[4] = (Scalar(4.0) * omega1 * mu1 - Scalar(4.0) * omega2 * mu1) / denominator;  // by a3
  gradient[11] = (Scalar(4.0) * omega1 * a3 - Scalar(4.0) * omega2 * a3) / denominator;  // by mu1
}

/// gradient[p] = d harmonic_re_y_A_x_A_y_conjA_y / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 139 operations.
template <class Scalar>
void lump_gradient_32(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
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
  const Scalar denominator = Scalar(2.0) * omega1_7 * omega2_2 + omega1_6 * omega2_3
      - Scalar(10.0) * omega1_5 * omega2_4 - Scalar(5.0) * omega1_4 * omega2_5 + Scalar(8.0) * omega1_3 * omega2_6
      + Scalar(4.0) * omega1_2 * omega2_7;
  // multiplies a2*a3
  const Scalar c_0 = Scalar(4.0) * omega1_4 * omega2 - Scalar(8.0) * omega1_3 * omega2_2
      - Scalar(20.0) * omega1_2 * omega2_3 + Scalar(32.0) * omega1 * omega2_4 + Scalar(16.0) * omega2_5;
  // multiplies a3*a4
  const Scalar c_1 = -Scalar(8.0) * omega1_5 - Scalar(4.0) * omega1_4 * omega2
      + Scalar(48.0) * omega1_3 * omega2_2 + Scalar(24.0) * omega1_2 * omega2_3;
  // multiplies b4
  const Scalar c_2 = Scalar(12.0) * omega1_5 * omega2_2 + Scalar(6.0) * omega1_4 * omega2_3
      - Scalar(48.0) * omega1_3 * omega2_4 - Scalar(24.0) * omega1_2 * omega2_5;
  const Scalar w_0 = Scalar(12.0) * b4;  // multiplies omega1^5*omega2^2
  const Scalar w_1 = -Scalar(8.0) * a3 * a4;  // multiplies omega1^5
  const Scalar w_2 = Scalar(6.0) * b4;  // multiplies omega1^4*omega2^3
  const Scalar w_3 = Scalar(4.0) * a2 * a3 - Scalar(4.0) * a3 * a4;  // multiplies omega1^4*omega2
  const Scalar w_4 = -Scalar(48.0) * b4;  // multiplies omega1^3*omega2^4
  const Scalar w_5 = -Scalar(8.0) * a2 * a3 + Scalar(48.0) * a3 * a4;  // multiplies omega1^3*omega2^2
  const Scalar w_6 = -Scalar(24.0) * b4;  // multiplies omega1^2*omega2^5
  const Scalar w_7 = -Scalar(20.0) * a2 * a3 + Scalar(24.0) * a3 * a4;  // multiplies omega1^2*omega2^3
  const Scalar w_8 = Scalar(32.0) * a2 * a3;  // multiplies omega1*omega2^4
  const Scalar w_9 = Scalar(16.0) * a2 * a3;  // multiplies omega2^5
  // by omega1
  gradient[0] = (Scalar(5.0) * omega1_4 * omega2_2 * w_0 + Scalar(5.0) * omega1_4 * w_1
      + Scalar(4.0) * omega1_3 * omega2_3 * w_2 + Scalar(4.0) * omega1_3 * omega2 * w_3
      + Scalar(3.0) * omega1_2 * omega2_4 * w_4 + Scalar(3.0) * omega1_2 * omega2_2 * w_5
      + Scalar(2.0) * omega1 * omega2_5 * w_6 + Scalar(2.0) * omega1 * omega2_3 * w_7 + omega2_4 * w_8
      - lump * (Scalar(14.0) * omega1_6 * omega2_2 + Scalar(6.0) * omega1_5 * omega2_3
      - Scalar(50.0) * omega1_4 * omega2_4 - Scalar(20.0) * omega1_3 * omega2_5
      + Scalar(24.0) * omega1_2 * omega2_6 + Scalar(8.0) * omega1 * omega2_7)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_5 * omega2 * w_0 + Scalar(3.0) * omega1_4 * omega2_2 * w_2 + omega1_4 * w_3
      + Scalar(4.0) * omega1_3 * omega2_3 * w_4 + Scalar(2.0) * omega1_3 * omega2 * w_5
      + Scalar(5.0) * omega1_2 * omega2_4 * w_6 + Scalar(3.0) * omega1_2 * omega2_2 * w_7
      + Scalar(4.0) * omega1 * omega2_3 * w_8 + Scalar(5.0) * omega2_4 * w_9
      - lump * (Scalar(4.0) * omega1_7 * omega2 + Scalar(3.0) * omega1_6 * omega2_2
      - Scalar(40.0) * omega1_5 * omega2_3 - Scalar(25.0) * omega1_4 * omega2_4
      + Scalar(48.0) * omega1_3 * omega2_5 + Scalar(28.0) * omega1_2 * omega2_6)) / denominator;
  gradient[3] = (a3 * c_0) / denominator;  // by a2
  gradient[4] = (a2 * c_0 + a4 * c_1) / denominator;  // by a3
  gradient[5] = (a3 * c_1) / denominator;  // by a4
  gradient[9] = (c_2) / denominator;  // by b4
}

/// gradient[p] = d harmonic_re_y_A_x2_conjA_x / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 40 operations.
template <class Scalar>
void lump_gradient_33(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar b2 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar denominator = Scalar(3.0) * omega1_4 * omega2_2 - Scalar(3.0) * omega1_2 * omega2_4;
  // by omega1
  gradient[0] = (Scalar(18.0) * omega1 * omega2_2 * b2 - Scalar(24.0) * omega1 * a2 * a3
      - lump * (Scalar(12.0) * omega1_3 * omega2_2 - Scalar(6.0) * omega1 * omega2_4)) / denominator;
  // by omega2
  gradient[1] = (Scalar(18.0) * omega1_2 * omega2 * b2 - Scalar(20.0) * omega2 * a1 * a2
      - lump * (Scalar(6.0) * omega1_4 * omega2 - Scalar(12.0) * omega1_2 * omega2_3)) / denominator;
  gradient[2] = (-Scalar(10.0) * omega2_2 * a2) / denominator;  // by a1
  gradient[3] = (-Scalar(12.0) * omega1_2 * a3 - Scalar(10.0) * omega2_2 * a1) / denominator;  // by a2
  gradient[4] = (-Scalar(12.0) * omega1_2 * a2) / denominator;  // by a3
  gradient[7] = (Scalar(9.0) * omega1_2 * omega2_2) / denominator;  // by b2
}

/// gradient[p] = d harmonic_re_y_A_y_conjA_x2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 51 operations.
template <class Scalar>
void lump_gradient_35(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a3 = parameters[4];
  const Scalar b3 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar a3_2 = a3 * a3;
  const Scalar denominator = Scalar(12.0) * omega1_5 - Scalar(36.0) * omega1_4 * omega2
      + Scalar(24.0) * omega1_3 * omega2_2;
  // by omega1
  gradient[0] = (Scalar(9.0) * omega1_2 * b3 - Scalar(12.0) * omega1 * omega2 * b3 + Scalar(2.0) * a1 * a3
      + Scalar(12.0) * a3_2 - lump * (Scalar(60.0) * omega1_4 - Scalar(144.0) * omega1_3 * omega2
      + Scalar(72.0) * omega1_2 * omega2_2)) / denominator;
  // by omega2
  gradient[1] = (-Scalar(6.0) * omega1_2 * b3 - Scalar(4.0) * a1 * a3 - lump * (-Scalar(36.0) * omega1_4
      + Scalar(48.0) * omega1_3 * omega2)) / denominator;
  gradient[2] = (Scalar(2.0) * omega1 * a3 - Scalar(4.0) * omega2 * a3) / denominator;  // by a1
  // by a3
  gradient[4] = (Scalar(2.0) * omega1 * a1 + Scalar(24.0) * omega1 * a3
      - Scalar(4.0) * omega2 * a1) / denominator;
  gradient[8] = (Scalar(3.0) * omega1_3 - Scalar(6.0) * omega1_2 * omega2) / denominator;  // by b3
}

/// gradient[p] = d harmonic_re_y_conjA_y_F / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 8 operations.
template <class Scalar>
void lump_gradient_36(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a3 = parameters[4];
  const Scalar e1 = parameters[12];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar denominator = omega1_2 * omega2_2 - omega2_4;
  gradient[0] = (-lump * (Scalar(2.0) * omega1 * omega2_2)) / denominator;  // by omega1
  gradient[1] = (-lump * (Scalar(2.0) * omega1_2 * omega2 - Scalar(4.0) * omega2_3)) / denominator;  // by omega2
  gradient[4] = (-e1) / denominator;  // by a3
  gradient[12] = (-a3) / denominator;  // by e1
}

/// gradient[p] = d harmonic_re_y_A_y2_conjA_x / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 110 operations.
template <class Scalar>
void lump_gradient_40(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar denominator = Scalar(3.0) * omega1_5 * omega2_2 - Scalar(12.0) * omega1_4 * omega2_3
      - Scalar(3.0) * omega1_3 * omega2_4 + Scalar(48.0) * omega1_2 * omega2_5 - Scalar(36.0) * omega1 * omega2_6;
  // by omega1
  gradient[0] = (Scalar(27.0) * omega1_2 * omega2_2 * b4 + Scalar(6.0) * omega1_2 * a3 * a4
      - Scalar(36.0) * omega2_4 * b4 - Scalar(6.0) * omega2_2 * a2 * a3 + Scalar(4.0) * omega2_2 * a3 * a4
      - lump * (Scalar(15.0) * omega1_4 * omega2_2 - Scalar(48.0) * omega1_3 * omega2_3
      - Scalar(9.0) * omega1_2 * omega2_4 + Scalar(96.0) * omega1 * omega2_5
      - Scalar(36.0) * omega2_6)) / denominator;
  // by omega2
  gradient[1] = (Scalar(18.0) * omega1_3 * omega2 * b4 - Scalar(144.0) * omega1 * omega2_3 * b4
      - Scalar(12.0) * omega1 * omega2 * a2 * a3 + Scalar(8.0) * omega1 * omega2 * a3 * a4
      + Scalar(72.0) * omega2_2 * a3 * a4 - lump * (Scalar(6.0) * omega1_5 * omega2
      - Scalar(36.0) * omega1_4 * omega2_2 - Scalar(12.0) * omega1_3 * omega2_3
      + Scalar(240.0) * omega1_2 * omega2_4 - Scalar(216.0) * omega1 * omega2_5)) / denominator;
  gradient[3] = (-Scalar(6.0) * omega1 * omega2_2 * a3) / denominator;  // by a2
  // by a3
  gradient[4] = (Scalar(2.0) * omega1_3 * a4 - Scalar(6.0) * omega1 * omega2_2 * a2
      + Scalar(4.0) * omega1 * omega2_2 * a4 + Scalar(24.0) * omega2_3 * a4) / denominator;
  // by a4
  gradient[5] = (Scalar(2.0) * omega1_3 * a3 + Scalar(4.0) * omega1 * omega2_2 * a3
      + Scalar(24.0) * omega2_3 * a3) / denominator;
  gradient[9] = (Scalar(9.0) * omega1_3 * omega2_2 - Scalar(36.0) * omega1 * omega2_4) / denominator;  // by b4
}

/// gradient[p] = d harmonic_re_y_A_x3 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 15 operations.
template <class Scalar>
void lump_gradient_41(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar b2 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar denominator = Scalar(27.0) * omega1_4 - Scalar(3.0) * omega1_2 * omega2_2;
  // by omega1
  gradient[0] = (Scalar(6.0) * omega1 * b2 - lump * (Scalar(108.0) * omega1_3
      - Scalar(6.0) * omega1 * omega2_2)) / denominator;
  gradient[1] = (-lump * (-Scalar(6.0) * omega1_2 * omega2)) / denominator;  // by omega2
  gradient[2] = (Scalar(2.0) * a2) / denominator;  // by a1
  gradient[3] = (Scalar(2.0) * a1) / denominator;  // by a2
  gradient[7] = (Scalar(3.0) * omega1_2) / denominator;  // by b2
}

/// gradient[p] = d harmonic_re_y_A_y3 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 39 operations.
template <class Scalar>
void lump_gradient_42(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b5 = parameters[10];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar a3_2 = a3 * a3;
  const Scalar a4_2 = a4 * a4;
  const Scalar denominator = Scalar(24.0) * omega1_2 * omega2_4 - Scalar(96.0) * omega2_6;
  // by omega1
  gradient[0] = (Scalar(6.0) * omega1 * omega2_2 * b5 + Scalar(4.0) * omega1 * a4_2
      - lump * (Scalar(48.0) * omega1 * omega2_4)) / denominator;
  // by omega2
  gradient[1] = (Scalar(6.0) * omega1_2 * omega2 * b5 - Scalar(48.0) * omega2_3 * b5
      - Scalar(12.0) * omega2 * a3_2 - Scalar(16.0) * omega2 * a4_2 - lump * (Scalar(96.0) * omega1_2 * omega2_3
      - Scalar(576.0) * omega2_5)) / denominator;
  gradient[4] = (-Scalar(12.0) * omega2_2 * a3) / denominator;  // by a3
  gradient[5] = (Scalar(4.0) * omega1_2 * a4 - Scalar(16.0) * omega2_2 * a4) / denominator;  // by a4
  gradient[10] = (Scalar(3.0) * omega1_2 * omega2_2 - Scalar(12.0) * omega2_4) / denominator;  // by b5
}

/// gradient[p] = d harmonic_re_y_A_x_A_y2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 128 operations.
template <class Scalar>
void lump_gradient_43(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
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
  const Scalar denominator = Scalar(6.0) * omega1_6 * omega2_2 + Scalar(27.0) * omega1_5 * omega2_3
      + Scalar(6.0) * omega1_4 * omega2_4 - Scalar(99.0) * omega1_3 * omega2_5
      - Scalar(120.0) * omega1_2 * omega2_6 - Scalar(36.0) * omega1 * omega2_7;
  // multiplies a2*a3
  const Scalar c_0 = Scalar(12.0) * omega1_3 * omega2 - Scalar(12.0) * omega1_2 * omega2_2
      - Scalar(54.0) * omega1 * omega2_3;
  // multiplies a3*a4
  const Scalar c_1 = Scalar(4.0) * omega1_4 + Scalar(2.0) * omega1_3 * omega2 + Scalar(8.0) * omega1_2 * omega2_2
      - Scalar(44.0) * omega1 * omega2_3 - Scalar(24.0) * omega2_4;
  // multiplies b4
  const Scalar c_2 = Scalar(18.0) * omega1_4 * omega2_2 + Scalar(9.0) * omega1_3 * omega2_3
      - Scalar(72.0) * omega1_2 * omega2_4 - Scalar(36.0) * omega1 * omega2_5;
  const Scalar w_0 = Scalar(18.0) * b4;  // multiplies omega1^4*omega2^2
  const Scalar w_1 = Scalar(4.0) * a3 * a4;  // multiplies omega1^4
  const Scalar w_2 = Scalar(9.0) * b4;  // multiplies omega1^3*omega2^3
  const Scalar w_3 = Scalar(12.0) * a2 * a3 + Scalar(2.0) * a3 * a4;  // multiplies omega1^3*omega2
  const Scalar w_4 = -Scalar(72.0) * b4;  // multiplies omega1^2*omega2^4
  const Scalar w_5 = -Scalar(12.0) * a2 * a3 + Scalar(8.0) * a3 * a4;  // multiplies omega1^2*omega2^2
  const Scalar w_6 = -Scalar(36.0) * b4;  // multiplies omega1*omega2^5
  const Scalar w_7 = -Scalar(54.0) * a2 * a3 - Scalar(44.0) * a3 * a4;  // multiplies omega1*omega2^3
  const Scalar w_8 = -Scalar(24.0) * a3 * a4;  // multiplies omega2^4
  // by omega1
  gradient[0] = (Scalar(4.0) * omega1_3 * omega2_2 * w_0 + Scalar(4.0) * omega1_3 * w_1
      + Scalar(3.0) * omega1_2 * omega2_3 * w_2 + Scalar(3.0) * omega1_2 * omega2 * w_3
      + Scalar(2.0) * omega1 * omega2_4 * w_4 + Scalar(2.0) * omega1 * omega2_2 * w_5 + omega2_5 * w_6
      + omega2_3 * w_7 - lump * (Scalar(36.0) * omega1_5 * omega2_2 + Scalar(135.0) * omega1_4 * omega2_3
      + Scalar(24.0) * omega1_3 * omega2_4 - Scalar(297.0) * omega1_2 * omega2_5
      - Scalar(240.0) * omega1 * omega2_6 - Scalar(36.0) * omega2_7)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_4 * omega2 * w_0 + Scalar(3.0) * omega1_3 * omega2_2 * w_2 + omega1_3 * w_3
      + Scalar(4.0) * omega1_2 * omega2_3 * w_4 + Scalar(2.0) * omega1_2 * omega2 * w_5
      + Scalar(5.0) * omega1 * omega2_4 * w_6 + Scalar(3.0) * omega1 * omega2_2 * w_7
      + Scalar(4.0) * omega2_3 * w_8 - lump * (Scalar(12.0) * omega1_6 * omega2
      + Scalar(81.0) * omega1_5 * omega2_2 + Scalar(24.0) * omega1_4 * omega2_3
      - Scalar(495.0) * omega1_3 * omega2_4 - Scalar(720.0) * omega1_2 * omega2_5
      - Scalar(252.0) * omega1 * omega2_6)) / denominator;
  gradient[3] = (a3 * c_0) / denominator;  // by a2
  gradient[4] = (a2 * c_0 + a4 * c_1) / denominator;  // by a3
  gradient[5] = (a3 * c_1) / denominator;  // by a4
  gradient[9] = (c_2) / denominator;  // by b4
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
  Scalar lumps[44];
  evaluate_lumps(parameters, lumps);
  for (std::size_t i = 0; i < 660; ++i) jacobian[i] = Scalar(0.0);
  jacobian[11] = Scalar(1.0);  // d mu1 / d mu1
  jacobian[15] = mu1_2 / (Scalar(2.0) * omega1_2);  // d conservative_x_A_x / d omega1
  jacobian[26] = -mu1 / omega1;  // d conservative_x_A_x / d mu1
  lump_gradient_2(parameters, lumps[2], jacobian + 30);  // d conservative_x_A_x_A_y_conjA_y
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
  lump_gradient_6(parameters, lumps[6], jacobian + 90);  // d conservative_x_conjA_x_F
  // d dissipative_y_A_x2 / d omega2
  jacobian[106] = (-Scalar(2.0) * a2 * mu1 + a2 * mu2) / (Scalar(2.0) * omega2_3);
  jacobian[108] = (Scalar(2.0) * mu1 - mu2) / (Scalar(4.0) * omega2_2);  // d dissipative_y_A_x2 / d a2
  jacobian[116] = a2 / (Scalar(2.0) * omega2_2);  // d dissipative_y_A_x2 / d mu1
  jacobian[118] = -a2 / (Scalar(4.0) * omega2_2);  // d dissipative_y_A_x2 / d mu2
  jacobian[133] = Scalar(1.0);  // d mu2 / d mu2
  jacobian[136] = mu2_2 / (Scalar(2.0) * omega2_2);  // d conservative_y_A_y / d omega2
  jacobian[148] = -mu2 / omega2;  // d conservative_y_A_y / d mu2
  lump_gradient_10(parameters, lumps[10], jacobian + 150);  // d conservative_y_A_y2_conjA_y
  lump_gradient_11(parameters, lumps[11], jacobian + 165);  // d conservative_y_A_x_A_y_conjA_x
  jacobian[181] = -mu2 * e2 / (Scalar(4.0) * omega2_3);  // d dissipative_y_F / d omega2
  jacobian[193] = e2 / (Scalar(8.0) * omega2_2);  // d dissipative_y_F / d mu2
  jacobian[194] = mu2 / (Scalar(8.0) * omega2_2);  // d dissipative_y_F / d e2
  jacobian[209] = Scalar(1.0);  // d e2 / d e2
  jacobian[214] = Scalar(1.0);  // d a3 / d a3
  jacobian[227] = Scalar(1.0);  // d a1 / d a1
  lump_gradient_16(parameters, lumps[16], jacobian + 240);  // d harmonic_re_x_A_y_conjA_x2
  lump_gradient_17(parameters, lumps[17], jacobian + 255);  // d harmonic_re_x_conjA_y_F
  jacobian[282] = Scalar(1.0);  // d e1 / d e1
  lump_gradient_19(parameters, lumps[19], jacobian + 285);  // d harmonic_im_x_F
  lump_gradient_20(parameters, lumps[20], jacobian + 300);  // d harmonic_re_x_A_y2_conjA_y
  lump_gradient_21(parameters, lumps[21], jacobian + 315);  // d harmonic_re_x_A_x_A_y_conjA_x
  jacobian[330] = Scalar(4.0) * a1 * mu1 / (Scalar(3.0) * omega1_4);  // d harmonic_im_x_A_x2 / d omega1
  jacobian[332] = -Scalar(4.0) * mu1 / (Scalar(9.0) * omega1_3);  // d harmonic_im_x_A_x2 / d a1
  jacobian[341] = -Scalar(4.0) * a1 / (Scalar(9.0) * omega1_3);  // d harmonic_im_x_A_x2 / d mu1
  lump_gradient_23(parameters, lumps[23], jacobian + 345);  // d harmonic_re_x_A_x2_A_y
  lump_gradient_24(parameters, lumps[24], jacobian + 360);  // d harmonic_im_x_A_y2
  lump_gradient_25(parameters, lumps[25], jacobian + 375);  // d harmonic_re_x_A_y_F
  lump_gradient_26(parameters, lumps[26], jacobian + 390);  // d harmonic_re_x_A_y2_conjA_x
  lump_gradient_27(parameters, lumps[27], jacobian + 405);  // d harmonic_re_x_A_x_F
  lump_gradient_28(parameters, lumps[28], jacobian + 420);  // d harmonic_re_x_A_x3
  lump_gradient_29(parameters, lumps[29], jacobian + 435);  // d harmonic_re_x_A_y3
  lump_gradient_30(parameters, lumps[30], jacobian + 450);  // d harmonic_re_x_A_x_A_y2
  lump_gradient_31(parameters, lumps[31], jacobian + 465);  // d harmonic_im_y_A_y_conjA_x
  lump_gradient_32(parameters, lumps[32], jacobian + 480);  // d harmonic_re_y_A_x_A_y_conjA_y
  lump_gradient_33(parameters, lumps[33], jacobian + 495);  // d harmonic_re_y_A_x2_conjA_x
  jacobian[515] = Scalar(1.0);  // d a4 / d a4
  lump_gradient_35(parameters, lumps[35], jacobian + 525);  // d harmonic_re_y_A_y_conjA_x2
  lump_gradient_36(parameters, lumps[36], jacobian + 540);  // d harmonic_re_y_conjA_y_F
  jacobian[556] = Scalar(16.0) * a2 * a4 / (Scalar(9.0) * omega2_5);  // d harmonic_re_y_A_x2_A_y / d omega2
  jacobian[558] = -Scalar(4.0) * a4 / (Scalar(9.0) * omega2_4);  // d harmonic_re_y_A_x2_A_y / d a2
  jacobian[560] = -Scalar(4.0) * a2 / (Scalar(9.0) * omega2_4);  // d harmonic_re_y_A_x2_A_y / d a4
  jacobian[571] = Scalar(4.0) * a4 * mu2 / (Scalar(3.0) * omega2_4);  // d harmonic_im_y_A_y2 / d omega2
  jacobian[575] = -Scalar(4.0) * mu2 / (Scalar(9.0) * omega2_3);  // d harmonic_im_y_A_y2 / d a4
  jacobian[583] = -Scalar(4.0) * a4 / (Scalar(9.0) * omega2_3);  // d harmonic_im_y_A_y2 / d mu2
  jacobian[586] = -Scalar(8.0) * a4 * e2 / (Scalar(9.0) * omega2_5);  // d harmonic_re_y_A_y_F / d omega2
  jacobian[590] = Scalar(2.0) * e2 / (Scalar(9.0) * omega2_4);  // d harmonic_re_y_A_y_F / d a4
  jacobian[599] = Scalar(2.0) * a4 / (Scalar(9.0) * omega2_4);  // d harmonic_re_y_A_y_F / d e2
  lump_gradient_40(parameters, lumps[40], jacobian + 600);  // d harmonic_re_y_A_y2_conjA_x
  lump_gradient_41(parameters, lumps[41], jacobian + 615);  // d harmonic_re_y_A_x3
  lump_gradient_42(parameters, lumps[42], jacobian + 630);  // d harmonic_re_y_A_y3
  lump_gradient_43(parameters, lumps[43], jacobian + 645);  // d harmonic_re_y_A_x_A_y2
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

/// What multiplies the 8 terms of the harmonic Omega of x: functions of the frequencies alone. 19 operations.
template <class Scalar>
void factors_3([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  factor[0] = Scalar(1.0) / (Scalar(3.0) * omega1_2);
  factor[1] = Scalar(1.0) / (Scalar(2.0) * omega1_2 - Scalar(2.0) * omega2_2);
  factor[2] = (-omega2_2 + omega2 * Omega) / (omega1_4 - Scalar(2.0) * omega1_2 * omega2_2 + omega2_4);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
  factor[6] = Scalar(1.0);
  factor[7] = Scalar(1.0);
}

/// Rows of the harmonic Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(Omega)*t) in x = 1/(3*omega1^2)*a1*A_x^2 + 1/(2*omega1^2 - 2*omega2^2)*e1*F + (-omega2^2
/// + omega2*Omega)/(omega1^4 - 2*omega1^2*omega2^2 + omega2^4)*e1*F + i*harmonic_im_x_F*F +
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

/// What multiplies the 6 terms of the harmonic omega2+Omega of x: functions of the frequencies alone. 28
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
  const Scalar Omega_2 = Omega * Omega;
  const Scalar Omega_3 = Omega_2 * Omega;
  const Scalar Omega_4 = Omega_3 * Omega;
  factor[0] = -Scalar(1.0) / (omega1_2 - Scalar(4.0) * omega2_2);
  factor[1] = (omega1_4 - omega1_2 * omega2_2) / (omega1_4 - omega1_2 * omega2_2
      - Scalar(2.0) * omega1_2 * omega2 * Omega - Scalar(2.0) * omega1_2 * Omega_2 + omega2_2 * Omega_2
      + Scalar(2.0) * omega2 * Omega_3 + Omega_4);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
}

/// Rows of the harmonic omega2+Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + Omega)*t) in x = -1/(omega1^2 - 4*omega2^2)*a3*A_y^2 + (omega1^4 -
/// omega1^2*omega2^2)/(omega1^4 - omega1^2*omega2^2 - 2*omega1^2*omega2*Omega - 2*omega1^2*Omega^2 +
/// omega2^2*Omega^2 + 2*omega2*Omega^3 + Omega^4)*harmonic_re_x_conjA_y_F*A_y*F +
/// harmonic_re_x_A_x2_A_y*A_x^2*A_y + harmonic_re_x_A_x2_A_y*A_x^2*A_y + i*harmonic_im_x_A_y2*A_y^2 +
/// harmonic_re_x_A_y_F*A_y*F
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

/// What multiplies the 8 terms of the harmonic omega1+Omega of x: functions of the frequencies alone. 22
/// operations.
template <class Scalar>
void factors_5([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  factor[0] = (-Scalar(8.0) * omega1_3 - Scalar(8.0) * omega1_2 * omega2) / (Scalar(4.0) * omega1_2 * omega2_2
      + Scalar(4.0) * omega1 * omega2_3 + omega2_4);
  factor[1] = Scalar(2.0) / (Scalar(2.0) * omega1 * omega2 + omega2_2);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
  factor[6] = Scalar(2.0) * omega2 / omega1;
  factor[7] = Scalar(1.0);
}

/// Rows of the harmonic omega1+Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + Omega)*t) in x = (-8*omega1^3 - 8*omega1^2*omega2)/(4*omega1^2*omega2^2 +
/// 4*omega1*omega2^3 + omega2^4)*i*dissipative_x_A_y_conjA_x*A_x*A_y + 2/(2*omega1*omega2 + omega2^2)*a2*A_x*A_y
/// + harmonic_re_x_A_y2_conjA_x*conj(A_x)*A_y^2 + harmonic_re_x_A_x_F*A_x*F + harmonic_re_x_A_x_F*A_x*F +
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
  const Scalar Omega_2 = Omega * Omega;
  const Scalar Omega_3 = Omega_2 * Omega;
  const Scalar Omega_4 = Omega_3 * Omega;
  factor[0] = Scalar(2.0) / (omega1_2 - Scalar(2.0) * omega1 * omega2);
  factor[1] = (-omega1_4 + omega1_2 * omega2_2) / (omega1_4 - Scalar(2.0) * omega1_3 * Omega - omega1_2 * omega2_2
      + Scalar(2.0) * omega1 * Omega_3 + omega2_2 * Omega_2 - Omega_4);
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
/// amplitude of exp(i*(omega1)*t) in y = 2/(omega1^2 - 2*omega1*omega2)*a3*conj(A_x)*A_y + (-omega1^4 +
/// omega1^2*omega2^2)/(omega1^4 - 2*omega1^3*Omega - omega1^2*omega2^2 + 2*omega1*Omega^3 + omega2^2*Omega^2 -
/// Omega^4)*harmonic_re_x_conjA_y_F*conj(A_x)*F + (omega1^3 + 3*omega1^2*omega2 -
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

/// What multiplies the 6 terms of the harmonic omega2+Omega of y: functions of the frequencies alone. 21
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
  const Scalar Omega_2 = Omega * Omega;
  const Scalar Omega_3 = Omega_2 * Omega;
  const Scalar Omega_4 = Omega_3 * Omega;
  factor[0] = Scalar(1.0) / (Scalar(3.0) * omega2_2);
  factor[1] = (-omega1_2 * omega2_2 + omega2_4) / (Scalar(2.0) * omega1_2 * omega2 * Omega + omega1_2 * Omega_2
      - Scalar(2.0) * omega2 * Omega_3 - Omega_4);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
}

/// Rows of the harmonic omega2+Omega of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + Omega)*t) in y = 1/(3*omega2^2)*a4*A_y^2 + (-omega1^2*omega2^2 +
/// omega2^4)/(2*omega1^2*omega2*Omega + omega1^2*Omega^2 - 2*omega2*Omega^3 -
/// Omega^4)*harmonic_re_y_conjA_y_F*A_y*F + harmonic_re_y_A_x2_A_y*A_x^2*A_y + harmonic_re_y_A_x2_A_y*A_x^2*A_y
/// + i*harmonic_im_y_A_y2*A_y^2 + harmonic_re_y_A_y_F*A_y*F
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

/// What multiplies the 8 terms of the harmonic omega1+Omega of y: functions of the frequencies alone. 59
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
  const Scalar Omega_2 = Omega * Omega;
  const Scalar Omega_3 = Omega_2 * Omega;
  const Scalar Omega_4 = Omega_3 * Omega;
  factor[0] = Scalar(2.0) / (omega1_2 + Scalar(2.0) * omega1 * omega2);
  factor[1] = (-omega1_4 + omega1_2 * omega2_2) / (omega1_4 + Scalar(2.0) * omega1_3 * Omega - omega1_2 * omega2_2
      - Scalar(2.0) * omega1 * Omega_3 + omega2_2 * Omega_2 - Omega_4);
  factor[2] = (omega1_3 - Scalar(3.0) * omega1_2 * omega2
      + Scalar(4.0) * omega2_3) / (Scalar(2.0) * omega1_2 * omega2);
  factor[3] = (omega1_3 - Scalar(3.0) * omega1_2 * omega2 + Scalar(4.0) * omega2_3) / omega1_3;
  factor[4] = (omega1_3 - Scalar(3.0) * omega1_2 * omega2
      + Scalar(4.0) * omega2_3) / (Scalar(2.0) * omega1_2 * omega2);
  factor[5] = (-omega1_3 + Scalar(3.0) * omega1_2 * omega2 - Scalar(4.0) * omega2_3) / (omega1_3
      + Scalar(3.0) * omega1_2 * omega2 - Scalar(4.0) * omega2_3);
  factor[6] = Scalar(1.0);
  factor[7] = Scalar(1.0);
}

/// Rows of the harmonic omega1+Omega of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + Omega)*t) in y = 2/(omega1^2 + 2*omega1*omega2)*a3*A_x*A_y + (-omega1^4 +
/// omega1^2*omega2^2)/(omega1^4 + 2*omega1^3*Omega - omega1^2*omega2^2 - 2*omega1*Omega^3 + omega2^2*Omega^2 -
/// Omega^4)*harmonic_re_x_conjA_y_F*A_x*F + (omega1^3 - 3*omega1^2*omega2 +
/// 4*omega2^3)/(2*omega1^2*omega2)*harmonic_re_x_A_x2_A_y*A_x^3 + (omega1^3 - 3*omega1^2*omega2 +
/// 4*omega2^3)/omega1^3*harmonic_re_x_A_x2_A_y*conj(A_x)*A_y^2 + (omega1^3 - 3*omega1^2*omega2 +
/// 4*omega2^3)/(2*omega1^2*omega2)*harmonic_re_x_A_y_F*A_x*F + (-omega1^3 + 3*omega1^2*omega2 -
/// 4*omega2^3)/(omega1^3 + 3*omega1^2*omega2 - 4*omega2^3)*i*harmonic_im_y_A_y_conjA_x*A_x*A_y +
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
       + times_i(lumps[5] * ((Scalar(2.0) * omega1 - omega2) / (Scalar(2.0) * omega1_2)) * (conj_A_x * A_y))
       + times_i(lumps[6] * (conj_A_x * F))
       - times_i((-omega1 + excitation_frequency[0] / Scalar(2.0)) * A_x));
  store_complex(derivative, 1, times_i(lumps[5] * Scalar(1.0) / (Scalar(2.0) * omega2) * (A_x * A_x))
       + times_i(lumps[5] * ((-Scalar(2.0) * omega1 + omega2) / (Scalar(4.0) * omega2_2)) * (A_x * A_x))
       + lumps[7] * (A_x * A_x)
       + lumps[8] * (-Scalar(1.0)) * (A_y)
       + times_i(lumps[9] * (A_y))
       + times_i(lumps[10] * (norm_A_y * A_y))
       + times_i(lumps[11] * (norm_A_x * A_y))
       + lumps[12] * (F)
       + times_i(lumps[13] * (-Scalar(1.0) / (Scalar(4.0) * omega2)) * (F))
       + times_i(lumps[13] * ((-omega2 + Omega) / (Scalar(8.0) * omega2_2)) * (F))
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
       + times_i(lumps[5] * ((Scalar(2.0) * omega1 - omega2) / (Scalar(2.0) * omega1_2)) * (A_y))
       + times_i(lumps[6] * (F));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[4] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[5] = by_0_0.real - conj_by_0_0.real;
  const Complex by_0_1 = times_i(lumps[2] * (A_x * conj_A_y))
       + lumps[4] * (conj_A_x)
       + times_i(lumps[5] * Scalar(1.0) / omega1 * (conj_A_x))
       + times_i(lumps[5] * ((Scalar(2.0) * omega1 - omega2) / (Scalar(2.0) * omega1_2)) * (conj_A_x));
  const Complex conj_by_0_1 = times_i(lumps[2] * (A_x * A_y));
  jacobian[2] = by_0_1.real + conj_by_0_1.real;
  jacobian[3] = conj_by_0_1.imag - by_0_1.imag;
  jacobian[6] = by_0_1.imag + conj_by_0_1.imag;
  jacobian[7] = by_0_1.real - conj_by_0_1.real;
  const Complex by_1_0 = times_i(lumps[5] * Scalar(1.0) / (Scalar(2.0) * omega2) * Scalar(2) * (A_x))
       + times_i(lumps[5] * ((-Scalar(2.0) * omega1 + omega2) / (Scalar(4.0) * omega2_2)) * Scalar(2) * (A_x))
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
/// lumps[1]: conservative_x_A_x_A_y_conjA_y = (4*omega1^6*omega2^2*b3 - 8*omega1^6*a2*a4 -
/// 17*omega1^4*omega2^4*b3 - 8*omega1^4*omega2^2*a1*a3 - 4*omega1^4*omega2^2*a2^2 + 34*omega1^4*omega2^2*a2*a4 +
/// 16*omega1^4*omega2^2*a3^2 + 4*omega1^2*omega2^6*b3 + 34*omega1^2*omega2^4*a1*a3 + 16*omega1^2*omega2^4*a2^2 -
/// 8*omega1^2*omega2^4*a2*a4 - 4*omega1^2*omega2^4*a3^2 - 8*omega2^6*a1*a3)/(4*omega1^7*omega2^2 -
/// 17*omega1^5*omega2^4 + 4*omega1^3*omega2^6)
/// lumps[2]: conservative_x_A_x2_conjA_x = (36*omega1^4*omega2^2*b1 - 48*omega1^4*a2^2 - 9*omega1^2*omega2^4*b1
/// - 40*omega1^2*omega2^2*a1^2 + 18*omega1^2*omega2^2*a2^2 + 10*omega2^4*a1^2)/(24*omega1^5*omega2^2 -
/// 6*omega1^3*omega2^4)
/// lumps[3]: e1 = e1
/// lumps[4]: conservative_x_A_y_conjA_x2 = (36*omega1^5*omega2*b2 - 72*omega1^4*omega2^2*b2 - 24*omega1^4*a1*a2
/// - 9*omega1^3*omega2^3*b2 + 44*omega1^3*omega2*a1*a2 + 54*omega1^3*omega2*a2*a3 + 18*omega1^2*omega2^4*b2 +
/// 8*omega1^2*omega2^2*a1*a2 - 12*omega1^2*omega2^2*a2*a3 - 2*omega1*omega2^3*a1*a2 - 12*omega1*omega2^3*a2*a3 +
/// 4*omega2^4*a1*a2)/(24*omega1^6*omega2 - 48*omega1^5*omega2^2 - 6*omega1^4*omega2^3 + 12*omega1^3*omega2^4)
/// lumps[5]: conservative_y_A_x3 = (12*omega1^4*b2 - 3*omega1^2*omega2^2*b2 + 8*omega1^2*a1*a2 +
/// 6*omega1^2*a2*a3 - 2*omega2^2*a1*a2)/(24*omega1^4*omega2 - 6*omega1^2*omega2^3)
/// lumps[6]: mu2 = mu2
/// lumps[7]: conservative_y_A_y2_conjA_y = (9*omega1^4*omega2^2*b5 - 10*omega1^4*a4^2 - 36*omega1^2*omega2^4*b5
/// - 18*omega1^2*omega2^2*a3^2 + 40*omega1^2*omega2^2*a4^2 + 48*omega2^4*a3^2)/(6*omega1^4*omega2^3 -
/// 24*omega1^2*omega2^5)
/// lumps[8]: a2 = a2
/// lumps[9]: a1 = a1
/// lumps[10]: a3 = a3
/// lumps[11]: harmonic_re_x_A_y2_conjA_x = (-6*omega1^4*omega2^2*b3 - 4*omega1^4*a2*a4 + 3*omega1^3*omega2^3*b3
/// + 12*omega1^3*omega2*a2^2 + 2*omega1^3*omega2*a2*a4 + 24*omega1^2*omega2^4*b3 + 12*omega1^2*omega2^2*a1*a3 +
/// 16*omega1^2*omega2^2*a2*a4 - 24*omega1^2*omega2^2*a3^2 - 12*omega1*omega2^5*b3 - 6*omega1*omega2^3*a1*a3 -
/// 48*omega1*omega2^3*a2^2 - 8*omega1*omega2^3*a2*a4 - 36*omega1*omega2^3*a3^2 +
/// 24*omega2^4*a3^2)/(24*omega1^5*omega2^3 - 36*omega1^4*omega2^4 - 84*omega1^3*omega2^5 + 144*omega1^2*omega2^6
/// - 48*omega1*omega2^7)
/// lumps[12]: harmonic_re_x_A_x2_A_y = (36*omega1^5*omega2*b2 + 72*omega1^4*omega2^2*b2 + 24*omega1^4*a1*a2 -
/// 9*omega1^3*omega2^3*b2 + 44*omega1^3*omega2*a1*a2 + 54*omega1^3*omega2*a2*a3 - 18*omega1^2*omega2^4*b2 -
/// 8*omega1^2*omega2^2*a1*a2 + 12*omega1^2*omega2^2*a2*a3 - 2*omega1*omega2^3*a1*a2 - 12*omega1*omega2^3*a2*a3 -
/// 4*omega2^4*a1*a2)/(36*omega1^7*omega2 + 120*omega1^6*omega2^2 + 99*omega1^5*omega2^3 - 6*omega1^4*omega2^4 -
/// 27*omega1^3*omega2^5 - 6*omega1^2*omega2^6)
/// lumps[13]: harmonic_re_x_A_y2_conjA_y = (-9*omega1^4*omega2^2*b4 + 10*omega1^4*a3*a4 +
/// 36*omega1^2*omega2^4*b4 + 18*omega1^2*omega2^2*a2*a3 - 40*omega1^2*omega2^2*a3*a4 -
/// 48*omega2^4*a2*a3)/(3*omega1^6*omega2^2 - 15*omega1^4*omega2^4 + 12*omega1^2*omega2^6)
/// lumps[14]: harmonic_re_x_A_x_A_y_conjA_x = (-24*omega1^6*omega2^2*b2 + 16*omega1^6*a2*a3 +
/// 102*omega1^4*omega2^4*b2 + 24*omega1^4*omega2^2*a1*a2 - 100*omega1^4*omega2^2*a2*a3 - 24*omega1^2*omega2^6*b2
/// - 100*omega1^2*omega2^4*a1*a2 + 24*omega1^2*omega2^4*a2*a3 + 16*omega2^6*a1*a2)/(4*omega1^8*omega2^2 -
/// 21*omega1^6*omega2^4 + 21*omega1^4*omega2^6 - 4*omega1^2*omega2^8)
/// lumps[15]: harmonic_re_x_A_x3 = (12*omega1^4*b1 - 3*omega1^2*omega2^2*b1 + 8*omega1^2*a1^2 + 6*omega1^2*a2^2
/// - 2*omega2^2*a1^2)/(96*omega1^6 - 24*omega1^4*omega2^2)
/// lumps[16]: harmonic_re_x_A_y3 = (-3*omega1^2*omega2^2*b4 - 2*omega1^2*a3*a4 + 12*omega2^4*b4 +
/// 6*omega2^2*a2*a3 + 8*omega2^2*a3*a4)/(3*omega1^4*omega2^2 - 39*omega1^2*omega2^4 + 108*omega2^6)
/// lumps[17]: harmonic_re_x_A_x_A_y2 = (6*omega1^4*omega2^2*b3 + 4*omega1^4*a2*a4 + 3*omega1^3*omega2^3*b3 +
/// 12*omega1^3*omega2*a2^2 + 2*omega1^3*omega2*a2*a4 - 24*omega1^2*omega2^4*b3 - 12*omega1^2*omega2^2*a1*a3 -
/// 16*omega1^2*omega2^2*a2*a4 + 24*omega1^2*omega2^2*a3^2 - 12*omega1*omega2^5*b3 - 6*omega1*omega2^3*a1*a3 -
/// 48*omega1*omega2^3*a2^2 - 8*omega1*omega2^3*a2*a4 - 36*omega1*omega2^3*a3^2 -
/// 24*omega2^4*a3^2)/(24*omega1^5*omega2^3 + 36*omega1^4*omega2^4 - 84*omega1^3*omega2^5 - 144*omega1^2*omega2^6
/// - 48*omega1*omega2^7)
/// lumps[18]: a4 = a4
/// lumps[19]: harmonic_re_y_A_y_conjA_x2 = (12*omega1^5*omega2*b3 - 24*omega1^4*omega2^2*b3 - 24*omega1^4*a2^2 -
/// 3*omega1^3*omega2^3*b3 + 8*omega1^3*omega2*a1*a3 + 36*omega1^3*omega2*a2^2 + 6*omega1^3*omega2*a2*a4 +
/// 48*omega1^3*omega2*a3^2 + 6*omega1^2*omega2^4*b3 - 16*omega1^2*omega2^2*a1*a3 + 24*omega1^2*omega2^2*a2^2 -
/// 12*omega1^2*omega2^2*a2*a4 - 2*omega1*omega2^3*a1*a3 - 12*omega1*omega2^3*a3^2 +
/// 4*omega2^4*a1*a3)/(48*omega1^7*omega2 - 144*omega1^6*omega2^2 + 84*omega1^5*omega2^3 + 36*omega1^4*omega2^4 -
/// 24*omega1^3*omega2^5)
/// lumps[20]: e2 = e2
/// lumps[21]: harmonic_re_y_A_x_A_y_conjA_y = (24*omega1^6*omega2^2*b4 - 16*omega1^6*a3*a4 -
/// 102*omega1^4*omega2^4*b4 - 24*omega1^4*omega2^2*a2*a3 + 100*omega1^4*omega2^2*a3*a4 + 24*omega1^2*omega2^6*b4
/// + 100*omega1^2*omega2^4*a2*a3 - 24*omega1^2*omega2^4*a3*a4 - 16*omega2^6*a2*a3)/(4*omega1^8*omega2^2 -
/// 21*omega1^6*omega2^4 + 21*omega1^4*omega2^6 - 4*omega1^2*omega2^8)
/// lumps[22]: harmonic_re_y_A_x2_conjA_x = (36*omega1^4*omega2^2*b2 - 48*omega1^4*a2*a3 - 9*omega1^2*omega2^4*b2
/// - 40*omega1^2*omega2^2*a1*a2 + 18*omega1^2*omega2^2*a2*a3 + 10*omega2^4*a1*a2)/(12*omega1^6*omega2^2 -
/// 15*omega1^4*omega2^4 + 3*omega1^2*omega2^6)
/// lumps[23]: harmonic_re_y_A_y2_conjA_x = (18*omega1^4*omega2^2*b4 + 4*omega1^4*a3*a4 - 9*omega1^3*omega2^3*b4
/// - 12*omega1^3*omega2*a2*a3 - 2*omega1^3*omega2*a3*a4 - 72*omega1^2*omega2^4*b4 - 12*omega1^2*omega2^2*a2*a3 +
/// 8*omega1^2*omega2^2*a3*a4 + 36*omega1*omega2^5*b4 + 54*omega1*omega2^3*a2*a3 + 44*omega1*omega2^3*a3*a4 -
/// 24*omega2^4*a3*a4)/(6*omega1^6*omega2^2 - 27*omega1^5*omega2^3 + 6*omega1^4*omega2^4 + 99*omega1^3*omega2^5 -
/// 120*omega1^2*omega2^6 + 36*omega1*omega2^7)
/// lumps[24]: harmonic_re_y_A_x2_A_y = (12*omega1^5*omega2*b3 + 24*omega1^4*omega2^2*b3 + 24*omega1^4*a2^2 -
/// 3*omega1^3*omega2^3*b3 + 8*omega1^3*omega2*a1*a3 + 36*omega1^3*omega2*a2^2 + 6*omega1^3*omega2*a2*a4 +
/// 48*omega1^3*omega2*a3^2 - 6*omega1^2*omega2^4*b3 + 16*omega1^2*omega2^2*a1*a3 - 24*omega1^2*omega2^2*a2^2 +
/// 12*omega1^2*omega2^2*a2*a4 - 2*omega1*omega2^3*a1*a3 - 12*omega1*omega2^3*a3^2 -
/// 4*omega2^4*a1*a3)/(48*omega1^7*omega2 + 144*omega1^6*omega2^2 + 84*omega1^5*omega2^3 - 36*omega1^4*omega2^4 -
/// 24*omega1^3*omega2^5)
/// lumps[25]: harmonic_re_y_A_y3 = (3*omega1^2*omega2^2*b5 + 2*omega1^2*a4^2 - 12*omega2^4*b5 - 6*omega2^2*a3^2
/// - 8*omega2^2*a4^2)/(24*omega1^2*omega2^4 - 96*omega2^6)
/// lumps[26]: harmonic_re_y_A_x_A_y2 = (18*omega1^4*omega2^2*b4 + 4*omega1^4*a3*a4 + 9*omega1^3*omega2^3*b4 +
/// 12*omega1^3*omega2*a2*a3 + 2*omega1^3*omega2*a3*a4 - 72*omega1^2*omega2^4*b4 - 12*omega1^2*omega2^2*a2*a3 +
/// 8*omega1^2*omega2^2*a3*a4 - 36*omega1*omega2^5*b4 - 54*omega1*omega2^3*a2*a3 - 44*omega1*omega2^3*a3*a4 -
/// 24*omega2^4*a3*a4)/(6*omega1^6*omega2^2 + 27*omega1^5*omega2^3 + 6*omega1^4*omega2^4 - 99*omega1^3*omega2^5 -
/// 120*omega1^2*omega2^6 - 36*omega1*omega2^7)
/// 968 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
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
  const Scalar a1_2 = a1 * a1;
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar a4_2 = a4 * a4;
  lumps[0] = mu1;  // mu1
  // conservative_x_A_x_A_y_conjA_y
  lumps[1] = (Scalar(4.0) * omega1_6 * omega2_2 * b3 - Scalar(8.0) * omega1_6 * a2 * a4
      - Scalar(17.0) * omega1_4 * omega2_4 * b3 - Scalar(8.0) * omega1_4 * omega2_2 * a1 * a3
      - Scalar(4.0) * omega1_4 * omega2_2 * a2_2 + Scalar(34.0) * omega1_4 * omega2_2 * a2 * a4
      + Scalar(16.0) * omega1_4 * omega2_2 * a3_2 + Scalar(4.0) * omega1_2 * omega2_6 * b3
      + Scalar(34.0) * omega1_2 * omega2_4 * a1 * a3 + Scalar(16.0) * omega1_2 * omega2_4 * a2_2
      - Scalar(8.0) * omega1_2 * omega2_4 * a2 * a4 - Scalar(4.0) * omega1_2 * omega2_4 * a3_2
      - Scalar(8.0) * omega2_6 * a1 * a3) / (Scalar(4.0) * omega1_7 * omega2_2
      - Scalar(17.0) * omega1_5 * omega2_4 + Scalar(4.0) * omega1_3 * omega2_6);
  // conservative_x_A_x2_conjA_x
  lumps[2] = (Scalar(36.0) * omega1_4 * omega2_2 * b1 - Scalar(48.0) * omega1_4 * a2_2
      - Scalar(9.0) * omega1_2 * omega2_4 * b1 - Scalar(40.0) * omega1_2 * omega2_2 * a1_2
      + Scalar(18.0) * omega1_2 * omega2_2 * a2_2
      + Scalar(10.0) * omega2_4 * a1_2) / (Scalar(24.0) * omega1_5 * omega2_2
      - Scalar(6.0) * omega1_3 * omega2_4);
  lumps[3] = e1;  // e1
  // conservative_x_A_y_conjA_x2
  lumps[4] = (Scalar(36.0) * omega1_5 * omega2 * b2 - Scalar(72.0) * omega1_4 * omega2_2 * b2
      - Scalar(24.0) * omega1_4 * a1 * a2 - Scalar(9.0) * omega1_3 * omega2_3 * b2
      + Scalar(44.0) * omega1_3 * omega2 * a1 * a2 + Scalar(54.0) * omega1_3 * omega2 * a2 * a3
      + Scalar(18.0) * omega1_2 * omega2_4 * b2 + Scalar(8.0) * omega1_2 * omega2_2 * a1 * a2
      - Scalar(12.0) * omega1_2 * omega2_2 * a2 * a3 - Scalar(2.0) * omega1 * omega2_3 * a1 * a2
      - Scalar(12.0) * omega1 * omega2_3 * a2 * a3
      + Scalar(4.0) * omega2_4 * a1 * a2) / (Scalar(24.0) * omega1_6 * omega2 - Scalar(48.0) * omega1_5 * omega2_2
      - Scalar(6.0) * omega1_4 * omega2_3 + Scalar(12.0) * omega1_3 * omega2_4);
  // conservative_y_A_x3
  lumps[5] = (Scalar(12.0) * omega1_4 * b2 - Scalar(3.0) * omega1_2 * omega2_2 * b2
      + Scalar(8.0) * omega1_2 * a1 * a2 + Scalar(6.0) * omega1_2 * a2 * a3
      - Scalar(2.0) * omega2_2 * a1 * a2) / (Scalar(24.0) * omega1_4 * omega2
      - Scalar(6.0) * omega1_2 * omega2_3);
  lumps[6] = mu2;  // mu2
  // conservative_y_A_y2_conjA_y
  lumps[7] = (Scalar(9.0) * omega1_4 * omega2_2 * b5 - Scalar(10.0) * omega1_4 * a4_2
      - Scalar(36.0) * omega1_2 * omega2_4 * b5 - Scalar(18.0) * omega1_2 * omega2_2 * a3_2
      + Scalar(40.0) * omega1_2 * omega2_2 * a4_2
      + Scalar(48.0) * omega2_4 * a3_2) / (Scalar(6.0) * omega1_4 * omega2_3
      - Scalar(24.0) * omega1_2 * omega2_5);
  lumps[8] = a2;  // a2
  lumps[9] = a1;  // a1
  lumps[10] = a3;  // a3
  // harmonic_re_x_A_y2_conjA_x
  lumps[11] = (-Scalar(6.0) * omega1_4 * omega2_2 * b3 - Scalar(4.0) * omega1_4 * a2 * a4
      + Scalar(3.0) * omega1_3 * omega2_3 * b3 + Scalar(12.0) * omega1_3 * omega2 * a2_2
      + Scalar(2.0) * omega1_3 * omega2 * a2 * a4 + Scalar(24.0) * omega1_2 * omega2_4 * b3
      + Scalar(12.0) * omega1_2 * omega2_2 * a1 * a3 + Scalar(16.0) * omega1_2 * omega2_2 * a2 * a4
      - Scalar(24.0) * omega1_2 * omega2_2 * a3_2 - Scalar(12.0) * omega1 * omega2_5 * b3
      - Scalar(6.0) * omega1 * omega2_3 * a1 * a3 - Scalar(48.0) * omega1 * omega2_3 * a2_2
      - Scalar(8.0) * omega1 * omega2_3 * a2 * a4 - Scalar(36.0) * omega1 * omega2_3 * a3_2
      + Scalar(24.0) * omega2_4 * a3_2) / (Scalar(24.0) * omega1_5 * omega2_3 - Scalar(36.0) * omega1_4 * omega2_4
      - Scalar(84.0) * omega1_3 * omega2_5 + Scalar(144.0) * omega1_2 * omega2_6
      - Scalar(48.0) * omega1 * omega2_7);
  // harmonic_re_x_A_x2_A_y
  lumps[12] = (Scalar(36.0) * omega1_5 * omega2 * b2 + Scalar(72.0) * omega1_4 * omega2_2 * b2
      + Scalar(24.0) * omega1_4 * a1 * a2 - Scalar(9.0) * omega1_3 * omega2_3 * b2
      + Scalar(44.0) * omega1_3 * omega2 * a1 * a2 + Scalar(54.0) * omega1_3 * omega2 * a2 * a3
      - Scalar(18.0) * omega1_2 * omega2_4 * b2 - Scalar(8.0) * omega1_2 * omega2_2 * a1 * a2
      + Scalar(12.0) * omega1_2 * omega2_2 * a2 * a3 - Scalar(2.0) * omega1 * omega2_3 * a1 * a2
      - Scalar(12.0) * omega1 * omega2_3 * a2 * a3
      - Scalar(4.0) * omega2_4 * a1 * a2) / (Scalar(36.0) * omega1_7 * omega2
      + Scalar(120.0) * omega1_6 * omega2_2 + Scalar(99.0) * omega1_5 * omega2_3
      - Scalar(6.0) * omega1_4 * omega2_4 - Scalar(27.0) * omega1_3 * omega2_5
      - Scalar(6.0) * omega1_2 * omega2_6);
  // harmonic_re_x_A_y2_conjA_y
  lumps[13] = (-Scalar(9.0) * omega1_4 * omega2_2 * b4 + Scalar(10.0) * omega1_4 * a3 * a4
      + Scalar(36.0) * omega1_2 * omega2_4 * b4 + Scalar(18.0) * omega1_2 * omega2_2 * a2 * a3
      - Scalar(40.0) * omega1_2 * omega2_2 * a3 * a4
      - Scalar(48.0) * omega2_4 * a2 * a3) / (Scalar(3.0) * omega1_6 * omega2_2
      - Scalar(15.0) * omega1_4 * omega2_4 + Scalar(12.0) * omega1_2 * omega2_6);
  // harmonic_re_x_A_x_A_y_conjA_x
  lumps[14] = (-Scalar(24.0) * omega1_6 * omega2_2 * b2 + Scalar(16.0) * omega1_6 * a2 * a3
      + Scalar(102.0) * omega1_4 * omega2_4 * b2 + Scalar(24.0) * omega1_4 * omega2_2 * a1 * a2
      - Scalar(100.0) * omega1_4 * omega2_2 * a2 * a3 - Scalar(24.0) * omega1_2 * omega2_6 * b2
      - Scalar(100.0) * omega1_2 * omega2_4 * a1 * a2 + Scalar(24.0) * omega1_2 * omega2_4 * a2 * a3
      + Scalar(16.0) * omega2_6 * a1 * a2) / (Scalar(4.0) * omega1_8 * omega2_2
      - Scalar(21.0) * omega1_6 * omega2_4 + Scalar(21.0) * omega1_4 * omega2_6
      - Scalar(4.0) * omega1_2 * omega2_8);
  // harmonic_re_x_A_x3
  lumps[15] = (Scalar(12.0) * omega1_4 * b1 - Scalar(3.0) * omega1_2 * omega2_2 * b1
      + Scalar(8.0) * omega1_2 * a1_2 + Scalar(6.0) * omega1_2 * a2_2
      - Scalar(2.0) * omega2_2 * a1_2) / (Scalar(96.0) * omega1_6 - Scalar(24.0) * omega1_4 * omega2_2);
  // harmonic_re_x_A_y3
  lumps[16] = (-Scalar(3.0) * omega1_2 * omega2_2 * b4 - Scalar(2.0) * omega1_2 * a3 * a4
      + Scalar(12.0) * omega2_4 * b4 + Scalar(6.0) * omega2_2 * a2 * a3
      + Scalar(8.0) * omega2_2 * a3 * a4) / (Scalar(3.0) * omega1_4 * omega2_2
      - Scalar(39.0) * omega1_2 * omega2_4 + Scalar(108.0) * omega2_6);
  // harmonic_re_x_A_x_A_y2
  lumps[17] = (Scalar(6.0) * omega1_4 * omega2_2 * b3 + Scalar(4.0) * omega1_4 * a2 * a4
      + Scalar(3.0) * omega1_3 * omega2_3 * b3 + Scalar(12.0) * omega1_3 * omega2 * a2_2
      + Scalar(2.0) * omega1_3 * omega2 * a2 * a4 - Scalar(24.0) * omega1_2 * omega2_4 * b3
      - Scalar(12.0) * omega1_2 * omega2_2 * a1 * a3 - Scalar(16.0) * omega1_2 * omega2_2 * a2 * a4
      + Scalar(24.0) * omega1_2 * omega2_2 * a3_2 - Scalar(12.0) * omega1 * omega2_5 * b3
      - Scalar(6.0) * omega1 * omega2_3 * a1 * a3 - Scalar(48.0) * omega1 * omega2_3 * a2_2
      - Scalar(8.0) * omega1 * omega2_3 * a2 * a4 - Scalar(36.0) * omega1 * omega2_3 * a3_2
      - Scalar(24.0) * omega2_4 * a3_2) / (Scalar(24.0) * omega1_5 * omega2_3 + Scalar(36.0) * omega1_4 * omega2_4
      - Scalar(84.0) * omega1_3 * omega2_5 - Scalar(144.0) * omega1_2 * omega2_6
      - Scalar(48.0) * omega1 * omega2_7);
  lumps[18] = a4;  // a4
  // harmonic_re_y_A_y_conjA_x2
  lumps[19] = (Scalar(12.0) * omega1_5 * omega2 * b3 - Scalar(24.0) * omega1_4 * omega2_2 * b3
      - Scalar(24.0) * omega1_4 * a2_2 - Scalar(3.0) * omega1_3 * omega2_3 * b3
      + Scalar(8.0) * omega1_3 * omega2 * a1 * a3 + Scalar(36.0) * omega1_3 * omega2 * a2_2
      + Scalar(6.0) * omega1_3 * omega2 * a2 * a4 + Scalar(48.0) * omega1_3 * omega2 * a3_2
      + Scalar(6.0) * omega1_2 * omega2_4 * b3 - Scalar(16.0) * omega1_2 * omega2_2 * a1 * a3
      + Scalar(24.0) * omega1_2 * omega2_2 * a2_2 - Scalar(12.0) * omega1_2 * omega2_2 * a2 * a4
      - Scalar(2.0) * omega1 * omega2_3 * a1 * a3 - Scalar(12.0) * omega1 * omega2_3 * a3_2
      + Scalar(4.0) * omega2_4 * a1 * a3) / (Scalar(48.0) * omega1_7 * omega2
      - Scalar(144.0) * omega1_6 * omega2_2 + Scalar(84.0) * omega1_5 * omega2_3
      + Scalar(36.0) * omega1_4 * omega2_4 - Scalar(24.0) * omega1_3 * omega2_5);
  lumps[20] = e2;  // e2
  // harmonic_re_y_A_x_A_y_conjA_y
  lumps[21] = (Scalar(24.0) * omega1_6 * omega2_2 * b4 - Scalar(16.0) * omega1_6 * a3 * a4
      - Scalar(102.0) * omega1_4 * omega2_4 * b4 - Scalar(24.0) * omega1_4 * omega2_2 * a2 * a3
      + Scalar(100.0) * omega1_4 * omega2_2 * a3 * a4 + Scalar(24.0) * omega1_2 * omega2_6 * b4
      + Scalar(100.0) * omega1_2 * omega2_4 * a2 * a3 - Scalar(24.0) * omega1_2 * omega2_4 * a3 * a4
      - Scalar(16.0) * omega2_6 * a2 * a3) / (Scalar(4.0) * omega1_8 * omega2_2
      - Scalar(21.0) * omega1_6 * omega2_4 + Scalar(21.0) * omega1_4 * omega2_6
      - Scalar(4.0) * omega1_2 * omega2_8);
  // harmonic_re_y_A_x2_conjA_x
  lumps[22] = (Scalar(36.0) * omega1_4 * omega2_2 * b2 - Scalar(48.0) * omega1_4 * a2 * a3
      - Scalar(9.0) * omega1_2 * omega2_4 * b2 - Scalar(40.0) * omega1_2 * omega2_2 * a1 * a2
      + Scalar(18.0) * omega1_2 * omega2_2 * a2 * a3
      + Scalar(10.0) * omega2_4 * a1 * a2) / (Scalar(12.0) * omega1_6 * omega2_2
      - Scalar(15.0) * omega1_4 * omega2_4 + Scalar(3.0) * omega1_2 * omega2_6);
  // harmonic_re_y_A_y2_conjA_x
  lumps[23] = (Scalar(18.0) * omega1_4 * omega2_2 * b4 + Scalar(4.0) * omega1_4 * a3 * a4
      - Scalar(9.0) * omega1_3 * omega2_3 * b4 - Scalar(12.0) * omega1_3 * omega2 * a2 * a3
      - Scalar(2.0) * omega1_3 * omega2 * a3 * a4 - Scalar(72.0) * omega1_2 * omega2_4 * b4
      - Scalar(12.0) * omega1_2 * omega2_2 * a2 * a3 + Scalar(8.0) * omega1_2 * omega2_2 * a3 * a4
      + Scalar(36.0) * omega1 * omega2_5 * b4 + Scalar(54.0) * omega1 * omega2_3 * a2 * a3
      + Scalar(44.0) * omega1 * omega2_3 * a3 * a4
      - Scalar(24.0) * omega2_4 * a3 * a4) / (Scalar(6.0) * omega1_6 * omega2_2
      - Scalar(27.0) * omega1_5 * omega2_3 + Scalar(6.0) * omega1_4 * omega2_4
      + Scalar(99.0) * omega1_3 * omega2_5 - Scalar(120.0) * omega1_2 * omega2_6
      + Scalar(36.0) * omega1 * omega2_7);
  // harmonic_re_y_A_x2_A_y
  lumps[24] = (Scalar(12.0) * omega1_5 * omega2 * b3 + Scalar(24.0) * omega1_4 * omega2_2 * b3
      + Scalar(24.0) * omega1_4 * a2_2 - Scalar(3.0) * omega1_3 * omega2_3 * b3
      + Scalar(8.0) * omega1_3 * omega2 * a1 * a3 + Scalar(36.0) * omega1_3 * omega2 * a2_2
      + Scalar(6.0) * omega1_3 * omega2 * a2 * a4 + Scalar(48.0) * omega1_3 * omega2 * a3_2
      - Scalar(6.0) * omega1_2 * omega2_4 * b3 + Scalar(16.0) * omega1_2 * omega2_2 * a1 * a3
      - Scalar(24.0) * omega1_2 * omega2_2 * a2_2 + Scalar(12.0) * omega1_2 * omega2_2 * a2 * a4
      - Scalar(2.0) * omega1 * omega2_3 * a1 * a3 - Scalar(12.0) * omega1 * omega2_3 * a3_2
      - Scalar(4.0) * omega2_4 * a1 * a3) / (Scalar(48.0) * omega1_7 * omega2
      + Scalar(144.0) * omega1_6 * omega2_2 + Scalar(84.0) * omega1_5 * omega2_3
      - Scalar(36.0) * omega1_4 * omega2_4 - Scalar(24.0) * omega1_3 * omega2_5);
  // harmonic_re_y_A_y3
  lumps[25] = (Scalar(3.0) * omega1_2 * omega2_2 * b5 + Scalar(2.0) * omega1_2 * a4_2
      - Scalar(12.0) * omega2_4 * b5 - Scalar(6.0) * omega2_2 * a3_2
      - Scalar(8.0) * omega2_2 * a4_2) / (Scalar(24.0) * omega1_2 * omega2_4 - Scalar(96.0) * omega2_6);
  // harmonic_re_y_A_x_A_y2
  lumps[26] = (Scalar(18.0) * omega1_4 * omega2_2 * b4 + Scalar(4.0) * omega1_4 * a3 * a4
      + Scalar(9.0) * omega1_3 * omega2_3 * b4 + Scalar(12.0) * omega1_3 * omega2 * a2 * a3
      + Scalar(2.0) * omega1_3 * omega2 * a3 * a4 - Scalar(72.0) * omega1_2 * omega2_4 * b4
      - Scalar(12.0) * omega1_2 * omega2_2 * a2 * a3 + Scalar(8.0) * omega1_2 * omega2_2 * a3 * a4
      - Scalar(36.0) * omega1 * omega2_5 * b4 - Scalar(54.0) * omega1 * omega2_3 * a2 * a3
      - Scalar(44.0) * omega1 * omega2_3 * a3 * a4
      - Scalar(24.0) * omega2_4 * a3 * a4) / (Scalar(6.0) * omega1_6 * omega2_2
      + Scalar(27.0) * omega1_5 * omega2_3 + Scalar(6.0) * omega1_4 * omega2_4
      - Scalar(99.0) * omega1_3 * omega2_5 - Scalar(120.0) * omega1_2 * omega2_6
      - Scalar(36.0) * omega1 * omega2_7);
}

/// gradient[p] = d conservative_x_A_x_A_y_conjA_y / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 105 operations.
template <class Scalar>
void lump_gradient_1(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
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
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar denominator = Scalar(4.0) * omega1_7 * omega2_2 - Scalar(17.0) * omega1_5 * omega2_4
      + Scalar(4.0) * omega1_3 * omega2_6;
  // multiplies a1*a3
  const Scalar c_0 = -Scalar(8.0) * omega1_4 * omega2_2 + Scalar(34.0) * omega1_2 * omega2_4
      - Scalar(8.0) * omega2_6;
  const Scalar c_1 = -Scalar(4.0) * omega1_4 * omega2_2 + Scalar(16.0) * omega1_2 * omega2_4;  // multiplies a2^2
  // multiplies a2*a4
  const Scalar c_2 = -Scalar(8.0) * omega1_6 + Scalar(34.0) * omega1_4 * omega2_2
      - Scalar(8.0) * omega1_2 * omega2_4;
  const Scalar c_3 = Scalar(16.0) * omega1_4 * omega2_2 - Scalar(4.0) * omega1_2 * omega2_4;  // multiplies a3^2
  // multiplies b3
  const Scalar c_4 = Scalar(4.0) * omega1_6 * omega2_2 - Scalar(17.0) * omega1_4 * omega2_4
      + Scalar(4.0) * omega1_2 * omega2_6;
  const Scalar w_0 = Scalar(4.0) * b3;  // multiplies omega1^6*omega2^2
  const Scalar w_1 = -Scalar(8.0) * a2 * a4;  // multiplies omega1^6
  const Scalar w_2 = -Scalar(17.0) * b3;  // multiplies omega1^4*omega2^4
  // multiplies omega1^4*omega2^2
  const Scalar w_3 = -Scalar(8.0) * a1 * a3 - Scalar(4.0) * a2_2 + Scalar(34.0) * a2 * a4 + Scalar(16.0) * a3_2;
  const Scalar w_4 = Scalar(4.0) * b3;  // multiplies omega1^2*omega2^6
  // multiplies omega1^2*omega2^4
  const Scalar w_5 = Scalar(34.0) * a1 * a3 + Scalar(16.0) * a2_2 - Scalar(8.0) * a2 * a4 - Scalar(4.0) * a3_2;
  const Scalar w_6 = -Scalar(8.0) * a1 * a3;  // multiplies omega2^6
  // by omega1
  gradient[0] = (Scalar(6.0) * omega1_5 * omega2_2 * w_0 + Scalar(6.0) * omega1_5 * w_1
      + Scalar(4.0) * omega1_3 * omega2_4 * w_2 + Scalar(4.0) * omega1_3 * omega2_2 * w_3
      + Scalar(2.0) * omega1 * omega2_6 * w_4 + Scalar(2.0) * omega1 * omega2_4 * w_5
      - lump * (Scalar(28.0) * omega1_6 * omega2_2 - Scalar(85.0) * omega1_4 * omega2_4
      + Scalar(12.0) * omega1_2 * omega2_6)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_6 * omega2 * w_0 + Scalar(4.0) * omega1_4 * omega2_3 * w_2
      + Scalar(2.0) * omega1_4 * omega2 * w_3 + Scalar(6.0) * omega1_2 * omega2_5 * w_4
      + Scalar(4.0) * omega1_2 * omega2_3 * w_5 + Scalar(6.0) * omega2_5 * w_6
      - lump * (Scalar(8.0) * omega1_7 * omega2 - Scalar(68.0) * omega1_5 * omega2_3
      + Scalar(24.0) * omega1_3 * omega2_5)) / denominator;
  gradient[2] = (a3 * c_0) / denominator;  // by a1
  gradient[3] = (Scalar(2.0) * a2 * c_1 + a4 * c_2) / denominator;  // by a2
  gradient[4] = (a1 * c_0 + Scalar(2.0) * a3 * c_3) / denominator;  // by a3
  gradient[5] = (a2 * c_2) / denominator;  // by a4
  gradient[8] = (c_4) / denominator;  // by b3
}

/// gradient[p] = d conservative_x_A_x2_conjA_x / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 68 operations.
template <class Scalar>
void lump_gradient_2(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar b1 = parameters[6];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar a1_2 = a1 * a1;
  const Scalar a2_2 = a2 * a2;
  const Scalar denominator = Scalar(24.0) * omega1_5 * omega2_2 - Scalar(6.0) * omega1_3 * omega2_4;
  // by omega1
  gradient[0] = (Scalar(144.0) * omega1_3 * omega2_2 * b1 - Scalar(192.0) * omega1_3 * a2_2
      - Scalar(18.0) * omega1 * omega2_4 * b1 - Scalar(80.0) * omega1 * omega2_2 * a1_2
      + Scalar(36.0) * omega1 * omega2_2 * a2_2 - lump * (Scalar(120.0) * omega1_4 * omega2_2
      - Scalar(18.0) * omega1_2 * omega2_4)) / denominator;
  // by omega2
  gradient[1] = (Scalar(72.0) * omega1_4 * omega2 * b1 - Scalar(36.0) * omega1_2 * omega2_3 * b1
      - Scalar(80.0) * omega1_2 * omega2 * a1_2 + Scalar(36.0) * omega1_2 * omega2 * a2_2
      + Scalar(40.0) * omega2_3 * a1_2 - lump * (Scalar(48.0) * omega1_5 * omega2
      - Scalar(24.0) * omega1_3 * omega2_3)) / denominator;
  gradient[2] = (-Scalar(80.0) * omega1_2 * omega2_2 * a1 + Scalar(20.0) * omega2_4 * a1) / denominator;  // by a1
  gradient[3] = (-Scalar(96.0) * omega1_4 * a2 + Scalar(36.0) * omega1_2 * omega2_2 * a2) / denominator;  // by a2
  gradient[6] = (Scalar(36.0) * omega1_4 * omega2_2 - Scalar(9.0) * omega1_2 * omega2_4) / denominator;  // by b1
}

/// gradient[p] = d conservative_x_A_y_conjA_x2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 110 operations.
template <class Scalar>
void lump_gradient_4(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar b2 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega1_6 = omega1_5 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar denominator = Scalar(24.0) * omega1_6 * omega2 - Scalar(48.0) * omega1_5 * omega2_2
      - Scalar(6.0) * omega1_4 * omega2_3 + Scalar(12.0) * omega1_3 * omega2_4;
  // multiplies a1*a2
  const Scalar c_0 = -Scalar(24.0) * omega1_4 + Scalar(44.0) * omega1_3 * omega2
      + Scalar(8.0) * omega1_2 * omega2_2 - Scalar(2.0) * omega1 * omega2_3 + Scalar(4.0) * omega2_4;
  // multiplies a2*a3
  const Scalar c_1 = Scalar(54.0) * omega1_3 * omega2 - Scalar(12.0) * omega1_2 * omega2_2
      - Scalar(12.0) * omega1 * omega2_3;
  // multiplies b2
  const Scalar c_2 = Scalar(36.0) * omega1_5 * omega2 - Scalar(72.0) * omega1_4 * omega2_2
      - Scalar(9.0) * omega1_3 * omega2_3 + Scalar(18.0) * omega1_2 * omega2_4;
  const Scalar w_0 = Scalar(36.0) * b2;  // multiplies omega1^5*omega2
  const Scalar w_1 = -Scalar(72.0) * b2;  // multiplies omega1^4*omega2^2
  const Scalar w_2 = -Scalar(24.0) * a1 * a2;  // multiplies omega1^4
  const Scalar w_3 = -Scalar(9.0) * b2;  // multiplies omega1^3*omega2^3
  const Scalar w_4 = Scalar(44.0) * a1 * a2 + Scalar(54.0) * a2 * a3;  // multiplies omega1^3*omega2
  const Scalar w_5 = Scalar(18.0) * b2;  // multiplies omega1^2*omega2^4
  const Scalar w_6 = Scalar(8.0) * a1 * a2 - Scalar(12.0) * a2 * a3;  // multiplies omega1^2*omega2^2
  const Scalar w_7 = -Scalar(2.0) * a1 * a2 - Scalar(12.0) * a2 * a3;  // multiplies omega1*omega2^3
  const Scalar w_8 = Scalar(4.0) * a1 * a2;  // multiplies omega2^4
  // by omega1
  gradient[0] = (Scalar(5.0) * omega1_4 * omega2 * w_0 + Scalar(4.0) * omega1_3 * omega2_2 * w_1
      + Scalar(4.0) * omega1_3 * w_2 + Scalar(3.0) * omega1_2 * omega2_3 * w_3
      + Scalar(3.0) * omega1_2 * omega2 * w_4 + Scalar(2.0) * omega1 * omega2_4 * w_5
      + Scalar(2.0) * omega1 * omega2_2 * w_6 + omega2_3 * w_7 - lump * (Scalar(144.0) * omega1_5 * omega2
      - Scalar(240.0) * omega1_4 * omega2_2 - Scalar(24.0) * omega1_3 * omega2_3
      + Scalar(36.0) * omega1_2 * omega2_4)) / denominator;
  // by omega2
  gradient[1] = (omega1_5 * w_0 + Scalar(2.0) * omega1_4 * omega2 * w_1 + Scalar(3.0) * omega1_3 * omega2_2 * w_3
      + omega1_3 * w_4 + Scalar(4.0) * omega1_2 * omega2_3 * w_5 + Scalar(2.0) * omega1_2 * omega2 * w_6
      + Scalar(3.0) * omega1 * omega2_2 * w_7 + Scalar(4.0) * omega2_3 * w_8 - lump * (Scalar(24.0) * omega1_6
      - Scalar(96.0) * omega1_5 * omega2 - Scalar(18.0) * omega1_4 * omega2_2
      + Scalar(48.0) * omega1_3 * omega2_3)) / denominator;
  gradient[2] = (a2 * c_0) / denominator;  // by a1
  gradient[3] = (a1 * c_0 + a3 * c_1) / denominator;  // by a2
  gradient[4] = (a2 * c_1) / denominator;  // by a3
  gradient[7] = (c_2) / denominator;  // by b2
}

/// gradient[p] = d conservative_y_A_x3 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 54 operations.
template <class Scalar>
void lump_gradient_5(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar b2 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar denominator = Scalar(24.0) * omega1_4 * omega2 - Scalar(6.0) * omega1_2 * omega2_3;
  // by omega1
  gradient[0] = (Scalar(48.0) * omega1_3 * b2 - Scalar(6.0) * omega1 * omega2_2 * b2
      + Scalar(16.0) * omega1 * a1 * a2 + Scalar(12.0) * omega1 * a2 * a3
      - lump * (Scalar(96.0) * omega1_3 * omega2 - Scalar(12.0) * omega1 * omega2_3)) / denominator;
  // by omega2
  gradient[1] = (-Scalar(6.0) * omega1_2 * omega2 * b2 - Scalar(4.0) * omega2 * a1 * a2
      - lump * (Scalar(24.0) * omega1_4 - Scalar(18.0) * omega1_2 * omega2_2)) / denominator;
  gradient[2] = (Scalar(8.0) * omega1_2 * a2 - Scalar(2.0) * omega2_2 * a2) / denominator;  // by a1
  // by a2
  gradient[3] = (Scalar(8.0) * omega1_2 * a1 + Scalar(6.0) * omega1_2 * a3
      - Scalar(2.0) * omega2_2 * a1) / denominator;
  gradient[4] = (Scalar(6.0) * omega1_2 * a2) / denominator;  // by a3
  gradient[7] = (Scalar(12.0) * omega1_4 - Scalar(3.0) * omega1_2 * omega2_2) / denominator;  // by b2
}

/// gradient[p] = d conservative_y_A_y2_conjA_y / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 68 operations.
template <class Scalar>
void lump_gradient_7(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b5 = parameters[10];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar a3_2 = a3 * a3;
  const Scalar a4_2 = a4 * a4;
  const Scalar denominator = Scalar(6.0) * omega1_4 * omega2_3 - Scalar(24.0) * omega1_2 * omega2_5;
  // by omega1
  gradient[0] = (Scalar(36.0) * omega1_3 * omega2_2 * b5 - Scalar(40.0) * omega1_3 * a4_2
      - Scalar(72.0) * omega1 * omega2_4 * b5 - Scalar(36.0) * omega1 * omega2_2 * a3_2
      + Scalar(80.0) * omega1 * omega2_2 * a4_2 - lump * (Scalar(24.0) * omega1_3 * omega2_3
      - Scalar(48.0) * omega1 * omega2_5)) / denominator;
  // by omega2
  gradient[1] = (Scalar(18.0) * omega1_4 * omega2 * b5 - Scalar(144.0) * omega1_2 * omega2_3 * b5
      - Scalar(36.0) * omega1_2 * omega2 * a3_2 + Scalar(80.0) * omega1_2 * omega2 * a4_2
      + Scalar(192.0) * omega2_3 * a3_2 - lump * (Scalar(18.0) * omega1_4 * omega2_2
      - Scalar(120.0) * omega1_2 * omega2_4)) / denominator;
  gradient[4] = (-Scalar(36.0) * omega1_2 * omega2_2 * a3 + Scalar(96.0) * omega2_4 * a3) / denominator;  // by a3
  gradient[5] = (-Scalar(20.0) * omega1_4 * a4 + Scalar(80.0) * omega1_2 * omega2_2 * a4) / denominator;  // by a4
  gradient[10] = (Scalar(9.0) * omega1_4 * omega2_2 - Scalar(36.0) * omega1_2 * omega2_4) / denominator;  // by b5
}

/// gradient[p] = d harmonic_re_x_A_y2_conjA_x / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 132 operations.
template <class Scalar>
void lump_gradient_11(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar omega2_7 = omega2_6 * omega2;
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar denominator = Scalar(24.0) * omega1_5 * omega2_3 - Scalar(36.0) * omega1_4 * omega2_4
      - Scalar(84.0) * omega1_3 * omega2_5 + Scalar(144.0) * omega1_2 * omega2_6
      - Scalar(48.0) * omega1 * omega2_7;
  const Scalar c_0 = Scalar(12.0) * omega1_2 * omega2_2 - Scalar(6.0) * omega1 * omega2_3;  // multiplies a1*a3
  const Scalar c_1 = Scalar(12.0) * omega1_3 * omega2 - Scalar(48.0) * omega1 * omega2_3;  // multiplies a2^2
  // multiplies a2*a4
  const Scalar c_2 = -Scalar(4.0) * omega1_4 + Scalar(2.0) * omega1_3 * omega2
      + Scalar(16.0) * omega1_2 * omega2_2 - Scalar(8.0) * omega1 * omega2_3;
  // multiplies a3^2
  const Scalar c_3 = -Scalar(24.0) * omega1_2 * omega2_2 - Scalar(36.0) * omega1 * omega2_3
      + Scalar(24.0) * omega2_4;
  // multiplies b3
  const Scalar c_4 = -Scalar(6.0) * omega1_4 * omega2_2 + Scalar(3.0) * omega1_3 * omega2_3
      + Scalar(24.0) * omega1_2 * omega2_4 - Scalar(12.0) * omega1 * omega2_5;
  const Scalar w_0 = -Scalar(6.0) * b3;  // multiplies omega1^4*omega2^2
  const Scalar w_1 = -Scalar(4.0) * a2 * a4;  // multiplies omega1^4
  const Scalar w_2 = Scalar(3.0) * b3;  // multiplies omega1^3*omega2^3
  const Scalar w_3 = Scalar(12.0) * a2_2 + Scalar(2.0) * a2 * a4;  // multiplies omega1^3*omega2
  const Scalar w_4 = Scalar(24.0) * b3;  // multiplies omega1^2*omega2^4
  // multiplies omega1^2*omega2^2
  const Scalar w_5 = Scalar(12.0) * a1 * a3 + Scalar(16.0) * a2 * a4 - Scalar(24.0) * a3_2;
  const Scalar w_6 = -Scalar(12.0) * b3;  // multiplies omega1*omega2^5
  // multiplies omega1*omega2^3
  const Scalar w_7 = -Scalar(6.0) * a1 * a3 - Scalar(48.0) * a2_2 - Scalar(8.0) * a2 * a4 - Scalar(36.0) * a3_2;
  const Scalar w_8 = Scalar(24.0) * a3_2;  // multiplies omega2^4
  // by omega1
  gradient[0] = (Scalar(4.0) * omega1_3 * omega2_2 * w_0 + Scalar(4.0) * omega1_3 * w_1
      + Scalar(3.0) * omega1_2 * omega2_3 * w_2 + Scalar(3.0) * omega1_2 * omega2 * w_3
      + Scalar(2.0) * omega1 * omega2_4 * w_4 + Scalar(2.0) * omega1 * omega2_2 * w_5 + omega2_5 * w_6
      + omega2_3 * w_7 - lump * (Scalar(120.0) * omega1_4 * omega2_3 - Scalar(144.0) * omega1_3 * omega2_4
      - Scalar(252.0) * omega1_2 * omega2_5 + Scalar(288.0) * omega1 * omega2_6
      - Scalar(48.0) * omega2_7)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_4 * omega2 * w_0 + Scalar(3.0) * omega1_3 * omega2_2 * w_2 + omega1_3 * w_3
      + Scalar(4.0) * omega1_2 * omega2_3 * w_4 + Scalar(2.0) * omega1_2 * omega2 * w_5
      + Scalar(5.0) * omega1 * omega2_4 * w_6 + Scalar(3.0) * omega1 * omega2_2 * w_7
      + Scalar(4.0) * omega2_3 * w_8 - lump * (Scalar(72.0) * omega1_5 * omega2_2
      - Scalar(144.0) * omega1_4 * omega2_3 - Scalar(420.0) * omega1_3 * omega2_4
      + Scalar(864.0) * omega1_2 * omega2_5 - Scalar(336.0) * omega1 * omega2_6)) / denominator;
  gradient[2] = (a3 * c_0) / denominator;  // by a1
  gradient[3] = (Scalar(2.0) * a2 * c_1 + a4 * c_2) / denominator;  // by a2
  gradient[4] = (a1 * c_0 + Scalar(2.0) * a3 * c_3) / denominator;  // by a3
  gradient[5] = (a2 * c_2) / denominator;  // by a4
  gradient[8] = (c_4) / denominator;  // by b3
}

/// gradient[p] = d harmonic_re_x_A_x2_A_y / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 128 operations.
template <class Scalar>
void lump_gradient_12(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar b2 = parameters[7];
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
  const Scalar denominator = Scalar(36.0) * omega1_7 * omega2 + Scalar(120.0) * omega1_6 * omega2_2
      + Scalar(99.0) * omega1_5 * omega2_3 - Scalar(6.0) * omega1_4 * omega2_4
      - Scalar(27.0) * omega1_3 * omega2_5 - Scalar(6.0) * omega1_2 * omega2_6;
  // multiplies a1*a2
  const Scalar c_0 = Scalar(24.0) * omega1_4 + Scalar(44.0) * omega1_3 * omega2
      - Scalar(8.0) * omega1_2 * omega2_2 - Scalar(2.0) * omega1 * omega2_3 - Scalar(4.0) * omega2_4;
  // multiplies a2*a3
  const Scalar c_1 = Scalar(54.0) * omega1_3 * omega2 + Scalar(12.0) * omega1_2 * omega2_2
      - Scalar(12.0) * omega1 * omega2_3;
  // multiplies b2
  const Scalar c_2 = Scalar(36.0) * omega1_5 * omega2 + Scalar(72.0) * omega1_4 * omega2_2
      - Scalar(9.0) * omega1_3 * omega2_3 - Scalar(18.0) * omega1_2 * omega2_4;
  const Scalar w_0 = Scalar(36.0) * b2;  // multiplies omega1^5*omega2
  const Scalar w_1 = Scalar(72.0) * b2;  // multiplies omega1^4*omega2^2
  const Scalar w_2 = Scalar(24.0) * a1 * a2;  // multiplies omega1^4
  const Scalar w_3 = -Scalar(9.0) * b2;  // multiplies omega1^3*omega2^3
  const Scalar w_4 = Scalar(44.0) * a1 * a2 + Scalar(54.0) * a2 * a3;  // multiplies omega1^3*omega2
  const Scalar w_5 = -Scalar(18.0) * b2;  // multiplies omega1^2*omega2^4
  const Scalar w_6 = -Scalar(8.0) * a1 * a2 + Scalar(12.0) * a2 * a3;  // multiplies omega1^2*omega2^2
  const Scalar w_7 = -Scalar(2.0) * a1 * a2 - Scalar(12.0) * a2 * a3;  // multiplies omega1*omega2^3
  const Scalar w_8 = -Scalar(4.0) * a1 * a2;  // multiplies omega2^4
  // by omega1
  gradient[0] = (Scalar(5.0) * omega1_4 * omega2 * w_0 + Scalar(4.0) * omega1_3 * omega2_2 * w_1
      + Scalar(4.0) * omega1_3 * w_2 + Scalar(3.0) * omega1_2 * omega2_3 * w_3
      + Scalar(3.0) * omega1_2 * omega2 * w_4 + Scalar(2.0) * omega1 * omega2_4 * w_5
      + Scalar(2.0) * omega1 * omega2_2 * w_6 + omega2_3 * w_7 - lump * (Scalar(252.0) * omega1_6 * omega2
      + Scalar(720.0) * omega1_5 * omega2_2 + Scalar(495.0) * omega1_4 * omega2_3
      - Scalar(24.0) * omega1_3 * omega2_4 - Scalar(81.0) * omega1_2 * omega2_5
      - Scalar(12.0) * omega1 * omega2_6)) / denominator;
  // by omega2
  gradient[1] = (omega1_5 * w_0 + Scalar(2.0) * omega1_4 * omega2 * w_1 + Scalar(3.0) * omega1_3 * omega2_2 * w_3
      + omega1_3 * w_4 + Scalar(4.0) * omega1_2 * omega2_3 * w_5 + Scalar(2.0) * omega1_2 * omega2 * w_6
      + Scalar(3.0) * omega1 * omega2_2 * w_7 + Scalar(4.0) * omega2_3 * w_8 - lump * (Scalar(36.0) * omega1_7
      + Scalar(240.0) * omega1_6 * omega2 + Scalar(297.0) * omega1_5 * omega2_2
      - Scalar(24.0) * omega1_4 * omega2_3 - Scalar(135.0) * omega1_3 * omega2_4
      - Scalar(36.0) * omega1_2 * omega2_5)) / denominator;
  gradient[2] = (a2 * c_0) / denominator;  // by a1
  gradient[3] = (a1 * c_0 + a3 * c_1) / denominator;  // by a2
  gradient[4] = (a2 * c_1) / denominator;  // by a3
  gradient[7] = (c_2) / denominator;  // by b2
}

/// gradient[p] = d harmonic_re_x_A_y2_conjA_y / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 96 operations.
template <class Scalar>
void lump_gradient_13(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
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
  const Scalar denominator = Scalar(3.0) * omega1_6 * omega2_2 - Scalar(15.0) * omega1_4 * omega2_4
      + Scalar(12.0) * omega1_2 * omega2_6;
  // by omega1
  gradient[0] = (-Scalar(36.0) * omega1_3 * omega2_2 * b4 + Scalar(40.0) * omega1_3 * a3 * a4
      + Scalar(72.0) * omega1 * omega2_4 * b4 + Scalar(36.0) * omega1 * omega2_2 * a2 * a3
      - Scalar(80.0) * omega1 * omega2_2 * a3 * a4 - lump * (Scalar(18.0) * omega1_5 * omega2_2
      - Scalar(60.0) * omega1_3 * omega2_4 + Scalar(24.0) * omega1 * omega2_6)) / denominator;
  // by omega2
  gradient[1] = (-Scalar(18.0) * omega1_4 * omega2 * b4 + Scalar(144.0) * omega1_2 * omega2_3 * b4
      + Scalar(36.0) * omega1_2 * omega2 * a2 * a3 - Scalar(80.0) * omega1_2 * omega2 * a3 * a4
      - Scalar(192.0) * omega2_3 * a2 * a3 - lump * (Scalar(6.0) * omega1_6 * omega2
      - Scalar(60.0) * omega1_4 * omega2_3 + Scalar(72.0) * omega1_2 * omega2_5)) / denominator;
  gradient[3] = (Scalar(18.0) * omega1_2 * omega2_2 * a3 - Scalar(48.0) * omega2_4 * a3) / denominator;  // by a2
  // by a3
  gradient[4] = (Scalar(10.0) * omega1_4 * a4 + Scalar(18.0) * omega1_2 * omega2_2 * a2
      - Scalar(40.0) * omega1_2 * omega2_2 * a4 - Scalar(48.0) * omega2_4 * a2) / denominator;
  gradient[5] = (Scalar(10.0) * omega1_4 * a3 - Scalar(40.0) * omega1_2 * omega2_2 * a3) / denominator;  // by a4
  gradient[9] = (-Scalar(9.0) * omega1_4 * omega2_2 + Scalar(36.0) * omega1_2 * omega2_4) / denominator;  // by b4
}

/// gradient[p] = d harmonic_re_x_A_x_A_y_conjA_x / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 94 operations.
template <class Scalar>
void lump_gradient_14(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar b2 = parameters[7];
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
  const Scalar denominator = Scalar(4.0) * omega1_8 * omega2_2 - Scalar(21.0) * omega1_6 * omega2_4
      + Scalar(21.0) * omega1_4 * omega2_6 - Scalar(4.0) * omega1_2 * omega2_8;
  // multiplies a1*a2
  const Scalar c_0 = Scalar(24.0) * omega1_4 * omega2_2 - Scalar(100.0) * omega1_2 * omega2_4
      + Scalar(16.0) * omega2_6;
  // multiplies a2*a3
  const Scalar c_1 = Scalar(16.0) * omega1_6 - Scalar(100.0) * omega1_4 * omega2_2
      + Scalar(24.0) * omega1_2 * omega2_4;
  // multiplies b2
  const Scalar c_2 = -Scalar(24.0) * omega1_6 * omega2_2 + Scalar(102.0) * omega1_4 * omega2_4
      - Scalar(24.0) * omega1_2 * omega2_6;
  const Scalar w_0 = -Scalar(24.0) * b2;  // multiplies omega1^6*omega2^2
  const Scalar w_1 = Scalar(16.0) * a2 * a3;  // multiplies omega1^6
  const Scalar w_2 = Scalar(102.0) * b2;  // multiplies omega1^4*omega2^4
  const Scalar w_3 = Scalar(24.0) * a1 * a2 - Scalar(100.0) * a2 * a3;  // multiplies omega1^4*omega2^2
  const Scalar w_4 = -Scalar(24.0) * b2;  // multiplies omega1^2*omega2^6
  const Scalar w_5 = -Scalar(100.0) * a1 * a2 + Scalar(24.0) * a2 * a3;  // multiplies omega1^2*omega2^4
  const Scalar w_6 = Scalar(16.0) * a1 * a2;  // multiplies omega2^6
  // by omega1
  gradient[0] = (Scalar(6.0) * omega1_5 * omega2_2 * w_0 + Scalar(6.0) * omega1_5 * w_1
      + Scalar(4.0) * omega1_3 * omega2_4 * w_2 + Scalar(4.0) * omega1_3 * omega2_2 * w_3
      + Scalar(2.0) * omega1 * omega2_6 * w_4 + Scalar(2.0) * omega1 * omega2_4 * w_5
      - lump * (Scalar(32.0) * omega1_7 * omega2_2 - Scalar(126.0) * omega1_5 * omega2_4
      + Scalar(84.0) * omega1_3 * omega2_6 - Scalar(8.0) * omega1 * omega2_8)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_6 * omega2 * w_0 + Scalar(4.0) * omega1_4 * omega2_3 * w_2
      + Scalar(2.0) * omega1_4 * omega2 * w_3 + Scalar(6.0) * omega1_2 * omega2_5 * w_4
      + Scalar(4.0) * omega1_2 * omega2_3 * w_5 + Scalar(6.0) * omega2_5 * w_6
      - lump * (Scalar(8.0) * omega1_8 * omega2 - Scalar(84.0) * omega1_6 * omega2_3
      + Scalar(126.0) * omega1_4 * omega2_5 - Scalar(32.0) * omega1_2 * omega2_7)) / denominator;
  gradient[2] = (a2 * c_0) / denominator;  // by a1
  gradient[3] = (a1 * c_0 + a3 * c_1) / denominator;  // by a2
  gradient[4] = (a2 * c_1) / denominator;  // by a3
  gradient[7] = (c_2) / denominator;  // by b2
}

/// gradient[p] = d harmonic_re_x_A_x3 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 39 operations.
template <class Scalar>
void lump_gradient_15(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar b1 = parameters[6];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega1_6 = omega1_5 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar a1_2 = a1 * a1;
  const Scalar a2_2 = a2 * a2;
  const Scalar denominator = Scalar(96.0) * omega1_6 - Scalar(24.0) * omega1_4 * omega2_2;
  // by omega1
  gradient[0] = (Scalar(48.0) * omega1_3 * b1 - Scalar(6.0) * omega1 * omega2_2 * b1
      + Scalar(16.0) * omega1 * a1_2 + Scalar(12.0) * omega1 * a2_2 - lump * (Scalar(576.0) * omega1_5
      - Scalar(96.0) * omega1_3 * omega2_2)) / denominator;
  // by omega2
  gradient[1] = (-Scalar(6.0) * omega1_2 * omega2 * b1 - Scalar(4.0) * omega2 * a1_2
      - lump * (-Scalar(48.0) * omega1_4 * omega2)) / denominator;
  gradient[2] = (Scalar(16.0) * omega1_2 * a1 - Scalar(4.0) * omega2_2 * a1) / denominator;  // by a1
  gradient[3] = (Scalar(12.0) * omega1_2 * a2) / denominator;  // by a2
  gradient[6] = (Scalar(12.0) * omega1_4 - Scalar(3.0) * omega1_2 * omega2_2) / denominator;  // by b1
}

/// gradient[p] = d harmonic_re_x_A_y3 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 59 operations.
template <class Scalar>
void lump_gradient_16(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar denominator = Scalar(3.0) * omega1_4 * omega2_2 - Scalar(39.0) * omega1_2 * omega2_4
      + Scalar(108.0) * omega2_6;
  // by omega1
  gradient[0] = (-Scalar(6.0) * omega1 * omega2_2 * b4 - Scalar(4.0) * omega1 * a3 * a4
      - lump * (Scalar(12.0) * omega1_3 * omega2_2 - Scalar(78.0) * omega1 * omega2_4)) / denominator;
  // by omega2
  gradient[1] = (-Scalar(6.0) * omega1_2 * omega2 * b4 + Scalar(48.0) * omega2_3 * b4
      + Scalar(12.0) * omega2 * a2 * a3 + Scalar(16.0) * omega2 * a3 * a4
      - lump * (Scalar(6.0) * omega1_4 * omega2 - Scalar(156.0) * omega1_2 * omega2_3
      + Scalar(648.0) * omega2_5)) / denominator;
  gradient[3] = (Scalar(6.0) * omega2_2 * a3) / denominator;  // by a2
  // by a3
  gradient[4] = (-Scalar(2.0) * omega1_2 * a4 + Scalar(6.0) * omega2_2 * a2
      + Scalar(8.0) * omega2_2 * a4) / denominator;
  gradient[5] = (-Scalar(2.0) * omega1_2 * a3 + Scalar(8.0) * omega2_2 * a3) / denominator;  // by a4
  gradient[9] = (-Scalar(3.0) * omega1_2 * omega2_2 + Scalar(12.0) * omega2_4) / denominator;  // by b4
}

/// gradient[p] = d harmonic_re_x_A_x_A_y2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 132 operations.
template <class Scalar>
void lump_gradient_17(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar omega2_7 = omega2_6 * omega2;
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar denominator = Scalar(24.0) * omega1_5 * omega2_3 + Scalar(36.0) * omega1_4 * omega2_4
      - Scalar(84.0) * omega1_3 * omega2_5 - Scalar(144.0) * omega1_2 * omega2_6
      - Scalar(48.0) * omega1 * omega2_7;
  const Scalar c_0 = -Scalar(12.0) * omega1_2 * omega2_2 - Scalar(6.0) * omega1 * omega2_3;  // multiplies a1*a3
  const Scalar c_1 = Scalar(12.0) * omega1_3 * omega2 - Scalar(48.0) * omega1 * omega2_3;  // multiplies a2^2
  // multiplies a2*a4
  const Scalar c_2 = Scalar(4.0) * omega1_4 + Scalar(2.0) * omega1_3 * omega2 - Scalar(16.0) * omega1_2 * omega2_2
      - Scalar(8.0) * omega1 * omega2_3;
  // multiplies a3^2
  const Scalar c_3 = Scalar(24.0) * omega1_2 * omega2_2 - Scalar(36.0) * omega1 * omega2_3
      - Scalar(24.0) * omega2_4;
  // multiplies b3
  const Scalar c_4 = Scalar(6.0) * omega1_4 * omega2_2 + Scalar(3.0) * omega1_3 * omega2_3
      - Scalar(24.0) * omega1_2 * omega2_4 - Scalar(12.0) * omega1 * omega2_5;
  const Scalar w_0 = Scalar(6.0) * b3;  // multiplies omega1^4*omega2^2
  const Scalar w_1 = Scalar(4.0) * a2 * a4;  // multiplies omega1^4
  const Scalar w_2 = Scalar(3.0) * b3;  // multiplies omega1^3*omega2^3
  const Scalar w_3 = Scalar(12.0) * a2_2 + Scalar(2.0) * a2 * a4;  // multiplies omega1^3*omega2
  const Scalar w_4 = -Scalar(24.0) * b3;  // multiplies omega1^2*omega2^4
  // multiplies omega1^2*omega2^2
  const Scalar w_5 = -Scalar(12.0) * a1 * a3 - Scalar(16.0) * a2 * a4 + Scalar(24.0) * a3_2;
  const Scalar w_6 = -Scalar(12.0) * b3;  // multiplies omega1*omega2^5
  // multiplies omega1*omega2^3
  const Scalar w_7 = -Scalar(6.0) * a1 * a3 - Scalar(48.0) * a2_2 - Scalar(8.0) * a2 * a4 - Scalar(36.0) * a3_2;
  const Scalar w_8 = -Scalar(24.0) * a3_2;  // multiplies omega2^4
  // by omega1
  gradient[0] = (Scalar(4.0) * omega1_3 * omega2_2 * w_0 + Scalar(4.0) * omega1_3 * w_1
      + Scalar(3.0) * omega1_2 * omega2_3 * w_2 + Scalar(3.0) * omega1_2 * omega2 * w_3
      + Scalar(2.0) * omega1 * omega2_4 * w_4 + Scalar(2.0) * omega1 * omega2_2 * w_5 + omega2_5 * w_6
      + omega2_3 * w_7 - lump * (Scalar(120.0) * omega1_4 * omega2_3 + Scalar(144.0) * omega1_3 * omega2_4
      - Scalar(252.0) * omega1_2 * omega2_5 - Scalar(288.0) * omega1 * omega2_6
      - Scalar(48.0) * omega2_7)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_4 * omega2 * w_0 + Scalar(3.0) * omega1_3 * omega2_2 * w_2 + omega1_3 * w_3
      + Scalar(4.0) * omega1_2 * omega2_3 * w_4 + Scalar(2.0) * omega1_2 * omega2 * w_5
      + Scalar(5.0) * omega1 * omega2_4 * w_6 + Scalar(3.0) * omega1 * omega2_2 * w_7
      + Scalar(4.0) * omega2_3 * w_8 - lump * (Scalar(72.0) * omega1_5 * omega2_2
      + Scalar(144.0) * omega1_4 * omega2_3 - Scalar(420.0) * omega1_3 * omega2_4
      - Scalar(864.0) * omega1_2 * omega2_5 - Scalar(336.0) * omega1 * omega2_6)) / denominator;
  gradient[2] = (a3 * c_0) / denominator;  // by a1
  gradient[3] = (Scalar(2.0) * a2 * c_1 + a4 * c_2) / denominator;  // by a2
  gradient[4] = (a1 * c_0 + Scalar(2.0) * a3 * c_3) / denominator;  // by a3
  gradient[5] = (a2 * c_2) / denominator;  // by a4
  gradient[8] = (c_4) / denominator;  // by b3
}

/// gradient[p] = d harmonic_re_y_A_y_conjA_x2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 132 operations.
template <class Scalar>
void lump_gradient_19(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
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
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar denominator = Scalar(48.0) * omega1_7 * omega2 - Scalar(144.0) * omega1_6 * omega2_2
      + Scalar(84.0) * omega1_5 * omega2_3 + Scalar(36.0) * omega1_4 * omega2_4
      - Scalar(24.0) * omega1_3 * omega2_5;
  // multiplies a1*a3
  const Scalar c_0 = Scalar(8.0) * omega1_3 * omega2 - Scalar(16.0) * omega1_2 * omega2_2
      - Scalar(2.0) * omega1 * omega2_3 + Scalar(4.0) * omega2_4;
  // multiplies a2^2
  const Scalar c_1 = -Scalar(24.0) * omega1_4 + Scalar(36.0) * omega1_3 * omega2
      + Scalar(24.0) * omega1_2 * omega2_2;
  const Scalar c_2 = Scalar(6.0) * omega1_3 * omega2 - Scalar(12.0) * omega1_2 * omega2_2;  // multiplies a2*a4
  const Scalar c_3 = Scalar(48.0) * omega1_3 * omega2 - Scalar(12.0) * omega1 * omega2_3;  // multiplies a3^2
  // multiplies b3
  const Scalar c_4 = Scalar(12.0) * omega1_5 * omega2 - Scalar(24.0) * omega1_4 * omega2_2
      - Scalar(3.0) * omega1_3 * omega2_3 + Scalar(6.0) * omega1_2 * omega2_4;
  const Scalar w_0 = Scalar(12.0) * b3;  // multiplies omega1^5*omega2
  const Scalar w_1 = -Scalar(24.0) * b3;  // multiplies omega1^4*omega2^2
  const Scalar w_2 = -Scalar(24.0) * a2_2;  // multiplies omega1^4
  const Scalar w_3 = -Scalar(3.0) * b3;  // multiplies omega1^3*omega2^3
  // multiplies omega1^3*omega2
  const Scalar w_4 = Scalar(8.0) * a1 * a3 + Scalar(36.0) * a2_2 + Scalar(6.0) * a2 * a4 + Scalar(48.0) * a3_2;
  const Scalar w_5 = Scalar(6.0) * b3;  // multiplies omega1^2*omega2^4
  // multiplies omega1^2*omega2^2
  const Scalar w_6 = -Scalar(16.0) * a1 * a3 + Scalar(24.0) * a2_2 - Scalar(12.0) * a2 * a4;
  const Scalar w_7 = -Scalar(2.0) * a1 * a3 - Scalar(12.0) * a3_2;  // multiplies omega1*omega2^3
  const Scalar w_8 = Scalar(4.0) * a1 * a3;  // multiplies omega2^4
  // by omega1
  gradient[0] = (Scalar(5.0) * omega1_4 * omega2 * w_0 + Scalar(4.0) * omega1_3 * omega2_2 * w_1
      + Scalar(4.0) * omega1_3 * w_2 + Scalar(3.0) * omega1_2 * omega2_3 * w_3
      + Scalar(3.0) * omega1_2 * omega2 * w_4 + Scalar(2.0) * omega1 * omega2_4 * w_5
      + Scalar(2.0) * omega1 * omega2_2 * w_6 + omega2_3 * w_7 - lump * (Scalar(336.0) * omega1_6 * omega2
      - Scalar(864.0) * omega1_5 * omega2_2 + Scalar(420.0) * omega1_4 * omega2_3
      + Scalar(144.0) * omega1_3 * omega2_4 - Scalar(72.0) * omega1_2 * omega2_5)) / denominator;
  // by omega2
  gradient[1] = (omega1_5 * w_0 + Scalar(2.0) * omega1_4 * omega2 * w_1 + Scalar(3.0) * omega1_3 * omega2_2 * w_3
      + omega1_3 * w_4 + Scalar(4.0) * omega1_2 * omega2_3 * w_5 + Scalar(2.0) * omega1_2 * omega2 * w_6
      + Scalar(3.0) * omega1 * omega2_2 * w_7 + Scalar(4.0) * omega2_3 * w_8 - lump * (Scalar(48.0) * omega1_7
      - Scalar(288.0) * omega1_6 * omega2 + Scalar(252.0) * omega1_5 * omega2_2
      + Scalar(144.0) * omega1_4 * omega2_3 - Scalar(120.0) * omega1_3 * omega2_4)) / denominator;
  gradient[2] = (a3 * c_0) / denominator;  // by a1
  gradient[3] = (Scalar(2.0) * a2 * c_1 + a4 * c_2) / denominator;  // by a2
  gradient[4] = (a1 * c_0 + Scalar(2.0) * a3 * c_3) / denominator;  // by a3
  gradient[5] = (a2 * c_2) / denominator;  // by a4
  gradient[8] = (c_4) / denominator;  // by b3
}

/// gradient[p] = d harmonic_re_y_A_x_A_y_conjA_y / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 94 operations.
template <class Scalar>
void lump_gradient_21(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
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
  const Scalar denominator = Scalar(4.0) * omega1_8 * omega2_2 - Scalar(21.0) * omega1_6 * omega2_4
      + Scalar(21.0) * omega1_4 * omega2_6 - Scalar(4.0) * omega1_2 * omega2_8;
  // multiplies a2*a3
  const Scalar c_0 = -Scalar(24.0) * omega1_4 * omega2_2 + Scalar(100.0) * omega1_2 * omega2_4
      - Scalar(16.0) * omega2_6;
  // multiplies a3*a4
  const Scalar c_1 = -Scalar(16.0) * omega1_6 + Scalar(100.0) * omega1_4 * omega2_2
      - Scalar(24.0) * omega1_2 * omega2_4;
  // multiplies b4
  const Scalar c_2 = Scalar(24.0) * omega1_6 * omega2_2 - Scalar(102.0) * omega1_4 * omega2_4
      + Scalar(24.0) * omega1_2 * omega2_6;
  const Scalar w_0 = Scalar(24.0) * b4;  // multiplies omega1^6*omega2^2
  const Scalar w_1 = -Scalar(16.0) * a3 * a4;  // multiplies omega1^6
  const Scalar w_2 = -Scalar(102.0) * b4;  // multiplies omega1^4*omega2^4
  const Scalar w_3 = -Scalar(24.0) * a2 * a3 + Scalar(100.0) * a3 * a4;  // multiplies omega1^4*omega2^2
  const Scalar w_4 = Scalar(24.0) * b4;  // multiplies omega1^2*omega2^6
  const Scalar w_5 = Scalar(100.0) * a2 * a3 - Scalar(24.0) * a3 * a4;  // multiplies omega1^2*omega2^4
  const Scalar w_6 = -Scalar(16.0) * a2 * a3;  // multiplies omega2^6
  // by omega1
  gradient[0] = (Scalar(6.0) * omega1_5 * omega2_2 * w_0 + Scalar(6.0) * omega1_5 * w_1
      + Scalar(4.0) * omega1_3 * omega2_4 * w_2 + Scalar(4.0) * omega1_3 * omega2_2 * w_3
      + Scalar(2.0) * omega1 * omega2_6 * w_4 + Scalar(2.0) * omega1 * omega2_4 * w_5
      - lump * (Scalar(32.0) * omega1_7 * omega2_2 - Scalar(126.0) * omega1_5 * omega2_4
      + Scalar(84.0) * omega1_3 * omega2_6 - Scalar(8.0) * omega1 * omega2_8)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_6 * omega2 * w_0 + Scalar(4.0) * omega1_4 * omega2_3 * w_2
      + Scalar(2.0) * omega1_4 * omega2 * w_3 + Scalar(6.0) * omega1_2 * omega2_5 * w_4
      + Scalar(4.0) * omega1_2 * omega2_3 * w_5 + Scalar(6.0) * omega2_5 * w_6
      - lump * (Scalar(8.0) * omega1_8 * omega2 - Scalar(84.0) * omega1_6 * omega2_3
      + Scalar(126.0) * omega1_4 * omega2_5 - Scalar(32.0) * omega1_2 * omega2_7)) / denominator;
  gradient[3] = (a3 * c_0) / denominator;  // by a2
  gradient[4] = (a2 * c_0 + a4 * c_1) / denominator;  // by a3
  gradient[5] = (a3 * c_1) / denominator;  // by a4
  gradient[9] = (c_2) / denominator;  // by b4
}

/// gradient[p] = d harmonic_re_y_A_x2_conjA_x / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 96 operations.
template <class Scalar>
void lump_gradient_22(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar b2 = parameters[7];
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
  const Scalar denominator = Scalar(12.0) * omega1_6 * omega2_2 - Scalar(15.0) * omega1_4 * omega2_4
      + Scalar(3.0) * omega1_2 * omega2_6;
  // by omega1
  gradient[0] = (Scalar(144.0) * omega1_3 * omega2_2 * b2 - Scalar(192.0) * omega1_3 * a2 * a3
      - Scalar(18.0) * omega1 * omega2_4 * b2 - Scalar(80.0) * omega1 * omega2_2 * a1 * a2
      + Scalar(36.0) * omega1 * omega2_2 * a2 * a3 - lump * (Scalar(72.0) * omega1_5 * omega2_2
      - Scalar(60.0) * omega1_3 * omega2_4 + Scalar(6.0) * omega1 * omega2_6)) / denominator;
  // by omega2
  gradient[1] = (Scalar(72.0) * omega1_4 * omega2 * b2 - Scalar(36.0) * omega1_2 * omega2_3 * b2
      - Scalar(80.0) * omega1_2 * omega2 * a1 * a2 + Scalar(36.0) * omega1_2 * omega2 * a2 * a3
      + Scalar(40.0) * omega2_3 * a1 * a2 - lump * (Scalar(24.0) * omega1_6 * omega2
      - Scalar(60.0) * omega1_4 * omega2_3 + Scalar(18.0) * omega1_2 * omega2_5)) / denominator;
  gradient[2] = (-Scalar(40.0) * omega1_2 * omega2_2 * a2 + Scalar(10.0) * omega2_4 * a2) / denominator;  // by a1
  // by a2
  gradient[3] = (-Scalar(48.0) * omega1_4 * a3 - Scalar(40.0) * omega1_2 * omega2_2 * a1
      + Scalar(18.0) * omega1_2 * omega2_2 * a3 + Scalar(10.0) * omega2_4 * a1) / denominator;
  gradient[4] = (-Scalar(48.0) * omega1_4 * a2 + Scalar(18.0) * omega1_2 * omega2_2 * a2) / denominator;  // by a3
  gradient[7] = (Scalar(36.0) * omega1_4 * omega2_2 - Scalar(9.0) * omega1_2 * omega2_4) / denominator;  // by b2
}

/// gradient[p] = d harmonic_re_y_A_y2_conjA_x / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 128 operations.
template <class Scalar>
void lump_gradient_23(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
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
  const Scalar denominator = Scalar(6.0) * omega1_6 * omega2_2 - Scalar(27.0) * omega1_5 * omega2_3
      + Scalar(6.0) * omega1_4 * omega2_4 + Scalar(99.0) * omega1_3 * omega2_5
      - Scalar(120.0) * omega1_2 * omega2_6 + Scalar(36.0) * omega1 * omega2_7;
  // multiplies a2*a3
  const Scalar c_0 = -Scalar(12.0) * omega1_3 * omega2 - Scalar(12.0) * omega1_2 * omega2_2
      + Scalar(54.0) * omega1 * omega2_3;
  // multiplies a3*a4
  const Scalar c_1 = Scalar(4.0) * omega1_4 - Scalar(2.0) * omega1_3 * omega2 + Scalar(8.0) * omega1_2 * omega2_2
      + Scalar(44.0) * omega1 * omega2_3 - Scalar(24.0) * omega2_4;
  // multiplies b4
  const Scalar c_2 = Scalar(18.0) * omega1_4 * omega2_2 - Scalar(9.0) * omega1_3 * omega2_3
      - Scalar(72.0) * omega1_2 * omega2_4 + Scalar(36.0) * omega1 * omega2_5;
  const Scalar w_0 = Scalar(18.0) * b4;  // multiplies omega1^4*omega2^2
  const Scalar w_1 = Scalar(4.0) * a3 * a4;  // multiplies omega1^4
  const Scalar w_2 = -Scalar(9.0) * b4;  // multiplies omega1^3*omega2^3
  const Scalar w_3 = -Scalar(12.0) * a2 * a3 - Scalar(2.0) * a3 * a4;  // multiplies omega1^3*omega2
  const Scalar w_4 = -Scalar(72.0) * b4;  // multiplies omega1^2*omega2^4
  const Scalar w_5 = -Scalar(12.0) * a2 * a3 + Scalar(8.0) * a3 * a4;  // multiplies omega1^2*omega2^2
  const Scalar w_6 = Scalar(36.0) * b4;  // multiplies omega1*omega2^5
  const Scalar w_7 = Scalar(54.0) * a2 * a3 + Scalar(44.0) * a3 * a4;  // multiplies omega1*omega2^3
  const Scalar w_8 = -Scalar(24.0) * a3 * a4;  // multiplies omega2^4
  // by omega1
  gradient[0] = (Scalar(4.0) * omega1_3 * omega2_2 * w_0 + Scalar(4.0) * omega1_3 * w_1
      + Scalar(3.0) * omega1_2 * omega2_3 * w_2 + Scalar(3.0) * omega1_2 * omega2 * w_3
      + Scalar(2.0) * omega1 * omega2_4 * w_4 + Scalar(2.0) * omega1 * omega2_2 * w_5 + omega2_5 * w_6
      + omega2_3 * w_7 - lump * (Scalar(36.0) * omega1_5 * omega2_2 - Scalar(135.0) * omega1_4 * omega2_3
      + Scalar(24.0) * omega1_3 * omega2_4 + Scalar(297.0) * omega1_2 * omega2_5
      - Scalar(240.0) * omega1 * omega2_6 + Scalar(36.0) * omega2_7)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_4 * omega2 * w_0 + Scalar(3.0) * omega1_3 * omega2_2 * w_2 + omega1_3 * w_3
      + Scalar(4.0) * omega1_2 * omega2_3 * w_4 + Scalar(2.0) * omega1_2 * omega2 * w_5
      + Scalar(5.0) * omega1 * omega2_4 * w_6 + Scalar(3.0) * omega1 * omega2_2 * w_7
      + Scalar(4.0) * omega2_3 * w_8 - lump * (Scalar(12.0) * omega1_6 * omega2
      - Scalar(81.0) * omega1_5 * omega2_2 + Scalar(24.0) * omega1_4 * omega2_3
      + Scalar(495.0) * omega1_3 * omega2_4 - Scalar(720.0) * omega1_2 * omega2_5
      + Scalar(252.0) * omega1 * omega2_6)) / denominator;
  gradient[3] = (a3 * c_0) / denominator;  // by a2
  gradient[4] = (a2 * c_0 + a4 * c_1) / denominator;  // by a3
  gradient[5] = (a3 * c_1) / denominator;  // by a4
  gradient[9] = (c_2) / denominator;  // by b4
}

/// gradient[p] = d harmonic_re_y_A_x2_A_y / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 132 operations.
template <class Scalar>
void lump_gradient_24(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
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
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar denominator = Scalar(48.0) * omega1_7 * omega2 + Scalar(144.0) * omega1_6 * omega2_2
      + Scalar(84.0) * omega1_5 * omega2_3 - Scalar(36.0) * omega1_4 * omega2_4
      - Scalar(24.0) * omega1_3 * omega2_5;
  // multiplies a1*a3
  const Scalar c_0 = Scalar(8.0) * omega1_3 * omega2 + Scalar(16.0) * omega1_2 * omega2_2
      - Scalar(2.0) * omega1 * omega2_3 - Scalar(4.0) * omega2_4;
  // multiplies a2^2
  const Scalar c_1 = Scalar(24.0) * omega1_4 + Scalar(36.0) * omega1_3 * omega2
      - Scalar(24.0) * omega1_2 * omega2_2;
  const Scalar c_2 = Scalar(6.0) * omega1_3 * omega2 + Scalar(12.0) * omega1_2 * omega2_2;  // multiplies a2*a4
  const Scalar c_3 = Scalar(48.0) * omega1_3 * omega2 - Scalar(12.0) * omega1 * omega2_3;  // multiplies a3^2
  // multiplies b3
  const Scalar c_4 = Scalar(12.0) * omega1_5 * omega2 + Scalar(24.0) * omega1_4 * omega2_2
      - Scalar(3.0) * omega1_3 * omega2_3 - Scalar(6.0) * omega1_2 * omega2_4;
  const Scalar w_0 = Scalar(12.0) * b3;  // multiplies omega1^5*omega2
  const Scalar w_1 = Scalar(24.0) * b3;  // multiplies omega1^4*omega2^2
  const Scalar w_2 = Scalar(24.0) * a2_2;  // multiplies omega1^4
  const Scalar w_3 = -Scalar(3.0) * b3;  // multiplies omega1^3*omega2^3
  // multiplies omega1^3*omega2
  const Scalar w_4 = Scalar(8.0) * a1 * a3 + Scalar(36.0) * a2_2 + Scalar(6.0) * a2 * a4 + Scalar(48.0) * a3_2;
  const Scalar w_5 = -Scalar(6.0) * b3;  // multiplies omega1^2*omega2^4
  // multiplies omega1^2*omega2^2
  const Scalar w_6 = Scalar(16.0) * a1 * a3 - Scalar(24.0) * a2_2 + Scalar(12.0) * a2 * a4;
  const Scalar w_7 = -Scalar(2.0) * a1 * a3 - Scalar(12.0) * a3_2;  // multiplies omega1*omega2^3
  const Scalar w_8 = -Scalar(4.0) * a1 * a3;  // multiplies omega2^4
  // by omega1
  gradient[0] = (Scalar(5.0) * omega1_4 * omega2 * w_0 + Scalar(4.0) * omega1_3 * omega2_2 * w_1
      + Scalar(4.0) * omega1_3 * w_2 + Scalar(3.0) * omega1_2 * omega2_3 * w_3
      + Scalar(3.0) * omega1_2 * omega2 * w_4 + Scalar(2.0) * omega1 * omega2_4 * w_5
      + Scalar(2.0) * omega1 * omega2_2 * w_6 + omega2_3 * w_7 - lump * (Scalar(336.0) * omega1_6 * omega2
      + Scalar(864.0) * omega1_5 * omega2_2 + Scalar(420.0) * omega1_4 * omega2_3
      - Scalar(144.0) * omega1_3 * omega2_4 - Scalar(72.0) * omega1_2 * omega2_5)) / denominator;
  // by omega2
  gradient[1] = (omega1_5 * w_0 + Scalar(2.0) * omega1_4 * omega2 * w_1 + Scalar(3.0) * omega1_3 * omega2_2 * w_3
      + omega1_3 * w_4 + Scalar(4.0) * omega1_2 * omega2_3 * w_5 + Scalar(2.0) * omega1_2 * omega2 * w_6
      + Scalar(3.0) * omega1 * omega2_2 * w_7 + Scalar(4.0) * omega2_3 * w_8 - lump * (Scalar(48.0) * omega1_7
      + Scalar(288.0) * omega1_6 * omega2 + Scalar(252.0) * omega1_5 * omega2_2
      - Scalar(144.0) * omega1_4 * omega2_3 - Scalar(120.0) * omega1_3 * omega2_4)) / denominator;
  gradient[2] = (a3 * c_0) / denominator;  // by a1
  gradient[3] = (Scalar(2.0) * a2 * c_1 + a4 * c_2) / denominator;  // by a2
  gradient[4] = (a1 * c_0 + Scalar(2.0) * a3 * c_3) / denominator;  // by a3
  gradient[5] = (a2 * c_2) / denominator;  // by a4
  gradient[8] = (c_4) / denominator;  // by b3
}

/// gradient[p] = d harmonic_re_y_A_y3 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 39 operations.
template <class Scalar>
void lump_gradient_25(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b5 = parameters[10];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar a3_2 = a3 * a3;
  const Scalar a4_2 = a4 * a4;
  const Scalar denominator = Scalar(24.0) * omega1_2 * omega2_4 - Scalar(96.0) * omega2_6;
  // by omega1
  gradient[0] = (Scalar(6.0) * omega1 * omega2_2 * b5 + Scalar(4.0) * omega1 * a4_2
      - lump * (Scalar(48.0) * omega1 * omega2_4)) / denominator;
  // by omega2
  gradient[1] = (Scalar(6.0) * omega1_2 * omega2 * b5 - Scalar(48.0) * omega2_3 * b5
      - Scalar(12.0) * omega2 * a3_2 - Scalar(16.0) * omega2 * a4_2 - lump * (Scalar(96.0) * omega1_2 * omega2_3
      - Scalar(576.0) * omega2_5)) / denominator;
  gradient[4] = (-Scalar(12.0) * omega2_2 * a3) / denominator;  // by a3
  gradient[5] = (Scalar(4.0) * omega1_2 * a4 - Scalar(16.0) * omega2_2 * a4) / denominator;  // by a4
  gradient[10] = (Scalar(3.0) * omega1_2 * omega2_2 - Scalar(12.0) * omega2_4) / denominator;  // by b5
}

/// gradient[p] = d harmonic_re_y_A_x_A_y2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 128 operations.
template <class Scalar>
void lump_gradient_26(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
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
  const Scalar denominator = Scalar(6.0) * omega1_6 * omega2_2 + Scalar(27.0) * omega1_5 * omega2_3
      + Scalar(6.0) * omega1_4 * omega2_4 - Scalar(99.0) * omega1_3 * omega2_5
      - Scalar(120.0) * omega1_2 * omega2_6 - Scalar(36.0) * omega1 * omega2_7;
  // multiplies a2*a3
  const Scalar c_0 = Scalar(12.0) * omega1_3 * omega2 - Scalar(12.0) * omega1_2 * omega2_2
      - Scalar(54.0) * omega1 * omega2_3;
  // multiplies a3*a4
  const Scalar c_1 = Scalar(4.0) * omega1_4 + Scalar(2.0) * omega1_3 * omega2 + Scalar(8.0) * omega1_2 * omega2_2
      - Scalar(44.0) * omega1 * omega2_3 - Scalar(24.0) * omega2_4;
  // multiplies b4
  const Scalar c_2 = Scalar(18.0) * omega1_4 * omega2_2 + Scalar(9.0) * omega1_3 * omega2_3
      - Scalar(72.0) * omega1_2 * omega2_4 - Scalar(36.0) * omega1 * omega2_5;
  const Scalar w_0 = Scalar(18.0) * b4;  // multiplies omega1^4*omega2^2
  const Scalar w_1 = Scalar(4.0) * a3 * a4;  // multiplies omega1^4
  const Scalar w_2 = Scalar(9.0) * b4;  // multiplies omega1^3*omega2^3
  const Scalar w_3 = Scalar(12.0) * a2 * a3 + Scalar(2.0) * a3 * a4;  // multiplies omega1^3*omega2
  const Scalar w_4 = -Scalar(72.0) * b4;  // multiplies omega1^2*omega2^4
  const Scalar w_5 = -Scalar(12.0) * a2 * a3 + Scalar(8.0) * a3 * a4;  // multiplies omega1^2*omega2^2
  const Scalar w_6 = -Scalar(36.0) * b4;  // multiplies omega1*omega2^5
  const Scalar w_7 = -Scalar(54.0) * a2 * a3 - Scalar(44.0) * a3 * a4;  // multiplies omega1*omega2^3
  const Scalar w_8 = -Scalar(24.0) * a3 * a4;  // multiplies omega2^4
  // by omega1
  gradient[0] = (Scalar(4.0) * omega1_3 * omega2_2 * w_0 + Scalar(4.0) * omega1_3 * w_1
      + Scalar(3.0) * omega1_2 * omega2_3 * w_2 + Scalar(3.0) * omega1_2 * omega2 * w_3
      + Scalar(2.0) * omega1 * omega2_4 * w_4 + Scalar(2.0) * omega1 * omega2_2 * w_5 + omega2_5 * w_6
      + omega2_3 * w_7 - lump * (Scalar(36.0) * omega1_5 * omega2_2 + Scalar(135.0) * omega1_4 * omega2_3
      + Scalar(24.0) * omega1_3 * omega2_4 - Scalar(297.0) * omega1_2 * omega2_5
      - Scalar(240.0) * omega1 * omega2_6 - Scalar(36.0) * omega2_7)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_4 * omega2 * w_0 + Scalar(3.0) * omega1_3 * omega2_2 * w_2 + omega1_3 * w_3
      + Scalar(4.0) * omega1_2 * omega2_3 * w_4 + Scalar(2.0) * omega1_2 * omega2 * w_5
      + Scalar(5.0) * omega1 * omega2_4 * w_6 + Scalar(3.0) * omega1 * omega2_2 * w_7
      + Scalar(4.0) * omega2_3 * w_8 - lump * (Scalar(12.0) * omega1_6 * omega2
      + Scalar(81.0) * omega1_5 * omega2_2 + Scalar(24.0) * omega1_4 * omega2_3
      - Scalar(495.0) * omega1_3 * omega2_4 - Scalar(720.0) * omega1_2 * omega2_5
      - Scalar(252.0) * omega1 * omega2_6)) / denominator;
  gradient[3] = (a3 * c_0) / denominator;  // by a2
  gradient[4] = (a2 * c_0 + a4 * c_1) / denominator;  // by a3
  gradient[5] = (a3 * c_1) / denominator;  // by a4
  gradient[9] = (c_2) / denominator;  // by b4
}

/// jacobian[l * 15 + p] = d lumps[l] / d parameters[p]. 0 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  Scalar lumps[27];
  evaluate_lumps(parameters, lumps);
  for (std::size_t i = 0; i < 405; ++i) jacobian[i] = Scalar(0.0);
  jacobian[11] = Scalar(1.0);  // d mu1 / d mu1
  lump_gradient_1(parameters, lumps[1], jacobian + 15);  // d conservative_x_A_x_A_y_conjA_y
  lump_gradient_2(parameters, lumps[2], jacobian + 30);  // d conservative_x_A_x2_conjA_x
  jacobian[57] = Scalar(1.0);  // d e1 / d e1
  lump_gradient_4(parameters, lumps[4], jacobian + 60);  // d conservative_x_A_y_conjA_x2
  lump_gradient_5(parameters, lumps[5], jacobian + 75);  // d conservative_y_A_x3
  jacobian[103] = Scalar(1.0);  // d mu2 / d mu2
  lump_gradient_7(parameters, lumps[7], jacobian + 105);  // d conservative_y_A_y2_conjA_y
  jacobian[123] = Scalar(1.0);  // d a2 / d a2
  jacobian[137] = Scalar(1.0);  // d a1 / d a1
  jacobian[154] = Scalar(1.0);  // d a3 / d a3
  lump_gradient_11(parameters, lumps[11], jacobian + 165);  // d harmonic_re_x_A_y2_conjA_x
  lump_gradient_12(parameters, lumps[12], jacobian + 180);  // d harmonic_re_x_A_x2_A_y
  lump_gradient_13(parameters, lumps[13], jacobian + 195);  // d harmonic_re_x_A_y2_conjA_y
  lump_gradient_14(parameters, lumps[14], jacobian + 210);  // d harmonic_re_x_A_x_A_y_conjA_x
  lump_gradient_15(parameters, lumps[15], jacobian + 225);  // d harmonic_re_x_A_x3
  lump_gradient_16(parameters, lumps[16], jacobian + 240);  // d harmonic_re_x_A_y3
  lump_gradient_17(parameters, lumps[17], jacobian + 255);  // d harmonic_re_x_A_x_A_y2
  jacobian[275] = Scalar(1.0);  // d a4 / d a4
  lump_gradient_19(parameters, lumps[19], jacobian + 285);  // d harmonic_re_y_A_y_conjA_x2
  jacobian[314] = Scalar(1.0);  // d e2 / d e2
  lump_gradient_21(parameters, lumps[21], jacobian + 315);  // d harmonic_re_y_A_x_A_y_conjA_y
  lump_gradient_22(parameters, lumps[22], jacobian + 330);  // d harmonic_re_y_A_x2_conjA_x
  lump_gradient_23(parameters, lumps[23], jacobian + 345);  // d harmonic_re_y_A_y2_conjA_x
  lump_gradient_24(parameters, lumps[24], jacobian + 360);  // d harmonic_re_y_A_x2_A_y
  lump_gradient_25(parameters, lumps[25], jacobian + 375);  // d harmonic_re_y_A_y3
  lump_gradient_26(parameters, lumps[26], jacobian + 390);  // d harmonic_re_y_A_x_A_y2
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
  const Scalar omega2_2 = omega2 * omega2;
  factor[0] = -Scalar(2.0) / (Scalar(2.0) * omega1 * omega2 - omega2_2);
  factor[1] = Scalar(1.0) / (Scalar(3.0) * omega1_2);
}

/// Rows of the harmonic -omega1+omega2 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + omega2)*t) in x = -2/(2*omega1*omega2 - omega2^2)*a2*conj(A_x)*A_y +
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

/// What multiplies the 1 terms of the harmonic 2*omega2 of x: functions of the frequencies alone. 5 operations.
template <class Scalar>
void factors_4([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  factor[0] = -Scalar(1.0) / (omega1_2 - Scalar(4.0) * omega2_2);
}

/// Rows of the harmonic 2*omega2 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega2)*t) in x = -1/(omega1^2 - 4*omega2^2)*a3*A_y^2
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
  const Scalar omega2_2 = omega2 * omega2;
  factor[0] = Scalar(2.0) / (Scalar(2.0) * omega1 * omega2 + omega2_2);
}

/// Rows of the harmonic omega1+omega2 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + omega2)*t) in x = 2/(2*omega1*omega2 + omega2^2)*a2*A_x*A_y
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

/// What multiplies the 1 terms of the harmonic 3*omega2 of x: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_8([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic 3*omega2 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega2)*t) in x = harmonic_re_x_A_y3*A_y^3
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_8(const BatchArrays& data, Factors factors, double* const* columns) {
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
inline void columns_8(const BatchArrays& data, double* const* columns) {
  rows_8(data, FactorValues<factors_8<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_8(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic omega1+2*omega2 of x: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_9([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic omega1+2*omega2 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + 2*omega2)*t) in x = harmonic_re_x_A_x_A_y2*A_x*A_y^2
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
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex A_y = load_complex(amplitude_1, i);
    store_complex(column_0, i, factor[0] * (A_x * A_y * A_y));  // harmonic_re_x_A_x_A_y2
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

/// What multiplies the 2 terms of the harmonic -omega1+omega2 of y: functions of the frequencies alone. 9
/// operations.
template <class Scalar>
void factors_10([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  factor[0] = Scalar(1.0) / (Scalar(4.0) * omega1_2 - omega2_2);
  factor[1] = Scalar(2.0) / (omega1_2 - Scalar(2.0) * omega1 * omega2);
}

/// Rows of the harmonic -omega1+omega2 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega1 + omega2)*t) in y = 1/(4*omega1^2 - omega2^2)*a2*A_x^2 + 2/(omega1^2 -
/// 2*omega1*omega2)*a3*conj(A_x)*A_y
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
  const Scalar omega1_2 = omega1 * omega1;
  factor[0] = Scalar(2.0) / (omega1_2 + Scalar(2.0) * omega1 * omega2);
}

/// Rows of the harmonic omega1+omega2 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + omega2)*t) in y = 2/(omega1^2 + 2*omega1*omega2)*a3*A_x*A_y
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
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar Omega_2 = Omega * Omega;
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0) / (Scalar(2.0) * omega2_2 - Scalar(2.0) * Omega_2);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the harmonic Omega of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(Omega)*t) in y = harmonic_re_y_A_y_conjA_x2*conj(A_x)^2*A_y + 1/(2*omega2^2 -
/// 2*Omega^2)*e2*F + harmonic_re_y_A_x_A_y_conjA_y*A_x*A_y*conj(A_y) +
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

/// What multiplies the 1 terms of the harmonic 3*omega2 of y: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_16([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic 3*omega2 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega2)*t) in y = harmonic_re_y_A_y3*A_y^3
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_16(const BatchArrays& data, Factors factors, double* const* columns) {
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
inline void columns_16(const BatchArrays& data, double* const* columns) {
  rows_16(data, FactorValues<factors_16<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_16(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic omega1+2*omega2 of y: functions of the frequencies alone. 0
/// operations.
template <class Scalar>
void factors_17([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic omega1+2*omega2 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + 2*omega2)*t) in y = harmonic_re_y_A_x_A_y2*A_x*A_y^2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
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
    store_complex(column_0, i, factor[0] * (A_x * A_y * A_y));  // harmonic_re_y_A_x_A_y2
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
/// lumps[2]: conservative_x_A_x_A_y_conjA_y = (4*omega1^5*omega2^2*b3 - 8*omega1^5*a2*a4 +
/// 2*omega1^4*omega2^3*b3 + 4*omega1^4*omega2*a2^2 - 4*omega1^4*omega2*a2*a4 - 16*omega1^3*omega2^4*b3 -
/// 8*omega1^3*omega2^2*a1*a3 + 2*omega1^3*omega2^2*a2^2 + 32*omega1^3*omega2^2*a2*a4 + 16*omega1^3*omega2^2*a3^2
/// - 8*omega1^2*omega2^5*b3 - 4*omega1^2*omega2^3*a1*a3 - 15*omega1^2*omega2^3*a2^2 + 16*omega1^2*omega2^3*a2*a4
/// + 8*omega1^2*omega2^3*a3^2 + 32*omega1*omega2^4*a1*a3 - 8*omega1*omega2^4*a2^2 + 16*omega2^5*a1*a3 -
/// 4*omega2^5*a2^2)/(4*omega1^6*omega2^2 + 2*omega1^5*omega2^3 - 16*omega1^4*omega2^4 - 8*omega1^3*omega2^5)
/// lumps[3]: conservative_x_A_x2_conjA_x = (18*omega1^2*omega2^2*b1 - 24*omega1^2*a2^2 - 3*omega1*omega2*a2^2 -
/// 20*omega2^2*a1^2)/(12*omega1^3*omega2^2)
/// lumps[4]: dissipative_x_A_y_conjA_x = a2*mu2/(2*omega1^2)
/// lumps[5]: a2 = a2
/// lumps[6]: dissipative_y_A_x2 = (2*a2*mu1 - a2*mu2)/(4*omega2^2)
/// lumps[7]: mu2 = mu2
/// lumps[8]: conservative_y_A_y = -mu2^2/(2*omega2)
/// lumps[9]: conservative_y_A_y2_conjA_y = (9*omega1^4*omega2^2*b5 - 10*omega1^4*a4^2 - 36*omega1^2*omega2^4*b5
/// - 18*omega1^2*omega2^2*a3^2 + 40*omega1^2*omega2^2*a4^2 + 48*omega2^4*a3^2)/(6*omega1^4*omega2^3 -
/// 24*omega1^2*omega2^5)
/// lumps[10]: conservative_y_A_x_A_y_conjA_x = (4*omega1^5*omega2^2*b3 - 8*omega1^5*a2*a4 +
/// 2*omega1^4*omega2^3*b3 + 2*omega1^4*omega2*a2^2 - 4*omega1^4*omega2*a2*a4 - 16*omega1^3*omega2^4*b3 -
/// 8*omega1^3*omega2^2*a1*a3 - omega1^3*omega2^2*a2^2 + 32*omega1^3*omega2^2*a2*a4 + 16*omega1^3*omega2^2*a3^2 -
/// 8*omega1^2*omega2^5*b3 - 4*omega1^2*omega2^3*a1*a3 - 8*omega1^2*omega2^3*a2^2 + 16*omega1^2*omega2^3*a2*a4 +
/// 8*omega1^2*omega2^3*a3^2 + 32*omega1*omega2^4*a1*a3 + 4*omega1*omega2^4*a2^2 +
/// 16*omega2^5*a1*a3)/(4*omega1^5*omega2^3 + 2*omega1^4*omega2^4 - 16*omega1^3*omega2^5 - 8*omega1^2*omega2^6)
/// lumps[11]: a3 = a3
/// lumps[12]: a1 = a1
/// lumps[13]: harmonic_re_x_A_y_conjA_x2 = (9*omega1^3*b2 - 18*omega1^2*omega2*b2 + 2*omega1*a1*a2 +
/// 12*omega1*a2*a3 - 4*omega2*a1*a2)/(9*omega1^5 - 30*omega1^4*omega2 + 27*omega1^3*omega2^2 -
/// 6*omega1^2*omega2^3)
/// lumps[14]: harmonic_re_x_A_x2_A_y = -4*a2*a3/(omega1^4 - 8*omega1^2*omega2^2 + 16*omega2^4)
/// lumps[15]: harmonic_im_x_A_y2 = (4*omega2*a3*mu1 - 8*omega2*a3*mu2)/(omega1^4 - 8*omega1^2*omega2^2 +
/// 16*omega2^4)
/// lumps[16]: harmonic_re_x_A_y2_conjA_x = (-3*omega1^3*omega2^2*b3 - 2*omega1^3*a2*a4 + 12*omega1*omega2^4*b3 +
/// 6*omega1*omega2^2*a1*a3 + 8*omega1*omega2^2*a2*a4 - 12*omega1*omega2^2*a3^2 -
/// 24*omega2^3*a3^2)/(12*omega1^4*omega2^3 - 12*omega1^3*omega2^4 - 48*omega1^2*omega2^5 + 48*omega1*omega2^6)
/// lumps[17]: harmonic_re_x_A_x3 = (-2*omega1*a2^2 - 2*omega2*a2^2)/(4*omega1^2*omega2^3 + 4*omega1*omega2^4 +
/// omega2^5)
/// lumps[18]: harmonic_re_x_A_y2_conjA_y = (-9*omega1^4*omega2^2*b4 + 10*omega1^4*a3*a4 +
/// 36*omega1^2*omega2^4*b4 + 18*omega1^2*omega2^2*a2*a3 - 40*omega1^2*omega2^2*a3*a4 -
/// 48*omega2^4*a2*a3)/(3*omega1^6*omega2^2 - 15*omega1^4*omega2^4 + 12*omega1^2*omega2^6)
/// lumps[19]: harmonic_re_x_A_x_A_y_conjA_x = (-12*omega1^5*omega2^2*b2 + 8*omega1^5*a2*a3 -
/// 6*omega1^4*omega2^3*b2 - 4*omega1^4*omega2*a1*a2 + 4*omega1^4*omega2*a2*a3 + 48*omega1^3*omega2^4*b2 +
/// 8*omega1^3*omega2^2*a1*a2 - 48*omega1^3*omega2^2*a2*a3 + 24*omega1^2*omega2^5*b2 + 20*omega1^2*omega2^3*a1*a2
/// - 24*omega1^2*omega2^3*a2*a3 - 32*omega1*omega2^4*a1*a2 - 16*omega2^5*a1*a2)/(2*omega1^7*omega2^2 +
/// omega1^6*omega2^3 - 10*omega1^5*omega2^4 - 5*omega1^4*omega2^5 + 8*omega1^3*omega2^6 + 4*omega1^2*omega2^7)
/// lumps[20]: harmonic_im_x_A_x2 = -4*a1*mu1/(9*omega1^3)
/// lumps[21]: harmonic_re_x_A_y3 = (-3*omega1^2*omega2^2*b4 - 2*omega1^2*a3*a4 + 12*omega2^4*b4 +
/// 6*omega2^2*a2*a3 + 8*omega2^2*a3*a4)/(3*omega1^4*omega2^2 - 39*omega1^2*omega2^4 + 108*omega2^6)
/// lumps[22]: harmonic_re_x_A_x_A_y2 = (6*omega1^4*omega2^2*b3 + 4*omega1^4*a2*a4 + 3*omega1^3*omega2^3*b3 +
/// 12*omega1^3*omega2*a2^2 + 2*omega1^3*omega2*a2*a4 - 24*omega1^2*omega2^4*b3 - 12*omega1^2*omega2^2*a1*a3 -
/// 16*omega1^2*omega2^2*a2*a4 + 24*omega1^2*omega2^2*a3^2 - 12*omega1*omega2^5*b3 - 6*omega1*omega2^3*a1*a3 -
/// 48*omega1*omega2^3*a2^2 - 8*omega1*omega2^3*a2*a4 - 36*omega1*omega2^3*a3^2 -
/// 24*omega2^4*a3^2)/(24*omega1^5*omega2^3 + 36*omega1^4*omega2^4 - 84*omega1^3*omega2^5 - 144*omega1^2*omega2^6
/// - 48*omega1*omega2^7)
/// lumps[23]: harmonic_im_y_A_y_conjA_x = (4*omega1*a3*mu1 - 4*omega2*a3*mu1)/(omega1^4 - 4*omega1^3*omega2 +
/// 4*omega1^2*omega2^2)
/// lumps[24]: harmonic_re_y_A_x_A_y_conjA_y = (12*omega1^5*omega2^2*b4 - 8*omega1^5*a3*a4 +
/// 6*omega1^4*omega2^3*b4 + 4*omega1^4*omega2*a2*a3 - 4*omega1^4*omega2*a3*a4 - 48*omega1^3*omega2^4*b4 -
/// 8*omega1^3*omega2^2*a2*a3 + 48*omega1^3*omega2^2*a3*a4 - 24*omega1^2*omega2^5*b4 - 20*omega1^2*omega2^3*a2*a3
/// + 24*omega1^2*omega2^3*a3*a4 + 32*omega1*omega2^4*a2*a3 + 16*omega2^5*a2*a3)/(2*omega1^7*omega2^2 +
/// omega1^6*omega2^3 - 10*omega1^5*omega2^4 - 5*omega1^4*omega2^5 + 8*omega1^3*omega2^6 + 4*omega1^2*omega2^7)
/// lumps[25]: harmonic_re_y_A_x2_conjA_x = (9*omega1^2*omega2^2*b2 - 12*omega1^2*a2*a3 -
/// 10*omega2^2*a1*a2)/(3*omega1^4*omega2^2 - 3*omega1^2*omega2^4)
/// lumps[26]: a4 = a4
/// lumps[27]: harmonic_re_y_A_y_conjA_x2 = (3*omega1^3*b3 - 6*omega1^2*omega2*b3 + 2*omega1*a1*a3 +
/// 12*omega1*a3^2 - 4*omega2*a1*a3)/(12*omega1^5 - 36*omega1^4*omega2 + 24*omega1^3*omega2^2)
/// lumps[28]: harmonic_re_y_A_x2_A_y = -4*a2*a4/(9*omega2^4)
/// lumps[29]: harmonic_im_y_A_y2 = -4*a4*mu2/(9*omega2^3)
/// lumps[30]: harmonic_re_y_A_y2_conjA_x = (9*omega1^3*omega2^2*b4 + 2*omega1^3*a3*a4 - 36*omega1*omega2^4*b4 -
/// 6*omega1*omega2^2*a2*a3 + 4*omega1*omega2^2*a3*a4 + 24*omega2^3*a3*a4)/(3*omega1^5*omega2^2 -
/// 12*omega1^4*omega2^3 - 3*omega1^3*omega2^4 + 48*omega1^2*omega2^5 - 36*omega1*omega2^6)
/// lumps[31]: harmonic_re_y_A_x3 = (3*omega1^2*b2 + 2*a1*a2)/(27*omega1^4 - 3*omega1^2*omega2^2)
/// lumps[32]: harmonic_re_y_A_y3 = (3*omega1^2*omega2^2*b5 + 2*omega1^2*a4^2 - 12*omega2^4*b5 - 6*omega2^2*a3^2
/// - 8*omega2^2*a4^2)/(24*omega1^2*omega2^4 - 96*omega2^6)
/// lumps[33]: harmonic_re_y_A_x_A_y2 = (18*omega1^4*omega2^2*b4 + 4*omega1^4*a3*a4 + 9*omega1^3*omega2^3*b4 +
/// 12*omega1^3*omega2*a2*a3 + 2*omega1^3*omega2*a3*a4 - 72*omega1^2*omega2^4*b4 - 12*omega1^2*omega2^2*a2*a3 +
/// 8*omega1^2*omega2^2*a3*a4 - 36*omega1*omega2^5*b4 - 54*omega1*omega2^3*a2*a3 - 44*omega1*omega2^3*a3*a4 -
/// 24*omega2^4*a3*a4)/(6*omega1^6*omega2^2 + 27*omega1^5*omega2^3 + 6*omega1^4*omega2^4 - 99*omega1^3*omega2^5 -
/// 120*omega1^2*omega2^6 - 36*omega1*omega2^7)
/// 835 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
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
  const Scalar a1_2 = a1 * a1;
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar a4_2 = a4 * a4;
  const Scalar mu1_2 = mu1 * mu1;
  const Scalar mu2_2 = mu2 * mu2;
  lumps[0] = mu1;  // mu1
  lumps[1] = -mu1_2 / (Scalar(2.0) * omega1);  // conservative_x_A_x
  // conservative_x_A_x_A_y_conjA_y
  lumps[2] = (Scalar(4.0) * omega1_5 * omega2_2 * b3 - Scalar(8.0) * omega1_5 * a2 * a4
      + Scalar(2.0) * omega1_4 * omega2_3 * b3 + Scalar(4.0) * omega1_4 * omega2 * a2_2
      - Scalar(4.0) * omega1_4 * omega2 * a2 * a4 - Scalar(16.0) * omega1_3 * omega2_4 * b3
      - Scalar(8.0) * omega1_3 * omega2_2 * a1 * a3 + Scalar(2.0) * omega1_3 * omega2_2 * a2_2
      + Scalar(32.0) * omega1_3 * omega2_2 * a2 * a4 + Scalar(16.0) * omega1_3 * omega2_2 * a3_2
      - Scalar(8.0) * omega1_2 * omega2_5 * b3 - Scalar(4.0) * omega1_2 * omega2_3 * a1 * a3
      - Scalar(15.0) * omega1_2 * omega2_3 * a2_2 + Scalar(16.0) * omega1_2 * omega2_3 * a2 * a4
      + Scalar(8.0) * omega1_2 * omega2_3 * a3_2 + Scalar(32.0) * omega1 * omega2_4 * a1 * a3
      - Scalar(8.0) * omega1 * omega2_4 * a2_2 + Scalar(16.0) * omega2_5 * a1 * a3
      - Scalar(4.0) * omega2_5 * a2_2) / (Scalar(4.0) * omega1_6 * omega2_2 + Scalar(2.0) * omega1_5 * omega2_3
      - Scalar(16.0) * omega1_4 * omega2_4 - Scalar(8.0) * omega1_3 * omega2_5);
  // conservative_x_A_x2_conjA_x
  lumps[3] = (Scalar(18.0) * omega1_2 * omega2_2 * b1 - Scalar(24.0) * omega1_2 * a2_2
      - Scalar(3.0) * omega1 * omega2 * a2_2
      - Scalar(20.0) * omega2_2 * a1_2) / (Scalar(12.0) * omega1_3 * omega2_2);
  lumps[4] = a2 * mu2 / (Scalar(2.0) * omega1_2);  // dissipative_x_A_y_conjA_x
  lumps[5] = a2;  // a2
  lumps[6] = (Scalar(2.0) * a2 * mu1 - a2 * mu2) / (Scalar(4.0) * omega2_2);  // dissipative_y_A_x2
  lumps[7] = mu2;  // mu2
  lumps[8] = -mu2_2 / (Scalar(2.0) * omega2);  // conservative_y_A_y
  // conservative_y_A_y2_conjA_y
  lumps[9] = (Scalar(9.0) * omega1_4 * omega2_2 * b5 - Scalar(10.0) * omega1_4 * a4_2
      - Scalar(36.0) * omega1_2 * omega2_4 * b5 - Scalar(18.0) * omega1_2 * omega2_2 * a3_2
      + Scalar(40.0) * omega1_2 * omega2_2 * a4_2
      + Scalar(48.0) * omega2_4 * a3_2) / (Scalar(6.0) * omega1_4 * omega2_3
      - Scalar(24.0) * omega1_2 * omega2_5);
  // conservative_y_A_x_A_y_conjA_x
  lumps[10] = (Scalar(4.0) * omega1_5 * omega2_2 * b3 - Scalar(8.0) * omega1_5 * a2 * a4
      + Scalar(2.0) * omega1_4 * omega2_3 * b3 + Scalar(2.0) * omega1_4 * omega2 * a2_2
      - Scalar(4.0) * omega1_4 * omega2 * a2 * a4 - Scalar(16.0) * omega1_3 * omega2_4 * b3
      - Scalar(8.0) * omega1_3 * omega2_2 * a1 * a3 - omega1_3 * omega2_2 * a2_2
      + Scalar(32.0) * omega1_3 * omega2_2 * a2 * a4 + Scalar(16.0) * omega1_3 * omega2_2 * a3_2
      - Scalar(8.0) * omega1_2 * omega2_5 * b3 - Scalar(4.0) * omega1_2 * omega2_3 * a1 * a3
      - Scalar(8.0) * omega1_2 * omega2_3 * a2_2 + Scalar(16.0) * omega1_2 * omega2_3 * a2 * a4
      + Scalar(8.0) * omega1_2 * omega2_3 * a3_2 + Scalar(32.0) * omega1 * omega2_4 * a1 * a3
      + Scalar(4.0) * omega1 * omega2_4 * a2_2
      + Scalar(16.0) * omega2_5 * a1 * a3) / (Scalar(4.0) * omega1_5 * omega2_3
      + Scalar(2.0) * omega1_4 * omega2_4 - Scalar(16.0) * omega1_3 * omega2_5
      - Scalar(8.0) * omega1_2 * omega2_6);
  lumps[11] = a3;  // a3
  lumps[12] = a1;  // a1
  // harmonic_re_x_A_y_conjA_x2
  lumps[13] = (Scalar(9.0) * omega1_3 * b2 - Scalar(18.0) * omega1_2 * omega2 * b2
      + Scalar(2.0) * omega1 * a1 * a2 + Scalar(12.0) * omega1 * a2 * a3
      - Scalar(4.0) * omega2 * a1 * a2) / (Scalar(9.0) * omega1_5 - Scalar(30.0) * omega1_4 * omega2
      + Scalar(27.0) * omega1_3 * omega2_2 - Scalar(6.0) * omega1_2 * omega2_3);
  // harmonic_re_x_A_x2_A_y
  lumps[14] = -Scalar(4.0) * a2 * a3 / (omega1_4 - Scalar(8.0) * omega1_2 * omega2_2 + Scalar(16.0) * omega2_4);
  // harmonic_im_x_A_y2
  lumps[15] = (Scalar(4.0) * omega2 * a3 * mu1 - Scalar(8.0) * omega2 * a3 * mu2) / (omega1_4
      - Scalar(8.0) * omega1_2 * omega2_2 + Scalar(16.0) * omega2_4);
  // harmonic_re_x_A_y2_conjA_x
  lumps[16] = (-Scalar(3.0) * omega1_3 * omega2_2 * b3 - Scalar(2.0) * omega1_3 * a2 * a4
      + Scalar(12.0) * omega1 * omega2_4 * b3 + Scalar(6.0) * omega1 * omega2_2 * a1 * a3
      + Scalar(8.0) * omega1 * omega2_2 * a2 * a4 - Scalar(12.0) * omega1 * omega2_2 * a3_2
      - Scalar(24.0) * omega2_3 * a3_2) / (Scalar(12.0) * omega1_4 * omega2_3 - Scalar(12.0) * omega1_3 * omega2_4
      - Scalar(48.0) * omega1_2 * omega2_5 + Scalar(48.0) * omega1 * omega2_6);
  // harmonic_re_x_A_x3
  lumps[17] = (-Scalar(2.0) * omega1 * a2_2 - Scalar(2.0) * omega2 * a2_2) / (Scalar(4.0) * omega1_2 * omega2_3
      + Scalar(4.0) * omega1 * omega2_4 + omega2_5);
  // harmonic_re_x_A_y2_conjA_y
  lumps[18] = (-Scalar(9.0) * omega1_4 * omega2_2 * b4 + Scalar(10.0) * omega1_4 * a3 * a4
      + Scalar(36.0) * omega1_2 * omega2_4 * b4 + Scalar(18.0) * omega1_2 * omega2_2 * a2 * a3
      - Scalar(40.0) * omega1_2 * omega2_2 * a3 * a4
      - Scalar(48.0) * omega2_4 * a2 * a3) / (Scalar(3.0) * omega1_6 * omega2_2
      - Scalar(15.0) * omega1_4 * omega2_4 + Scalar(12.0) * omega1_2 * omega2_6);
  // harmonic_re_x_A_x_A_y_conjA_x
  lumps[19] = (-Scalar(12.0) * omega1_5 * omega2_2 * b2 + Scalar(8.0) * omega1_5 * a2 * a3
      - Scalar(6.0) * omega1_4 * omega2_3 * b2 - Scalar(4.0) * omega1_4 * omega2 * a1 * a2
      + Scalar(4.0) * omega1_4 * omega2 * a2 * a3 + Scalar(48.0) * omega1_3 * omega2_4 * b2
      + Scalar(8.0) * omega1_3 * omega2_2 * a1 * a2 - Scalar(48.0) * omega1_3 * omega2_2 * a2 * a3
      + Scalar(24.0) * omega1_2 * omega2_5 * b2 + Scalar(20.0) * omega1_2 * omega2_3 * a1 * a2
      - Scalar(24.0) * omega1_2 * omega2_3 * a2 * a3 - Scalar(32.0) * omega1 * omega2_4 * a1 * a2
      - Scalar(16.0) * omega2_5 * a1 * a2) / (Scalar(2.0) * omega1_7 * omega2_2 + omega1_6 * omega2_3
      - Scalar(10.0) * omega1_5 * omega2_4 - Scalar(5.0) * omega1_4 * omega2_5 + Scalar(8.0) * omega1_3 * omega2_6
      + Scalar(4.0) * omega1_2 * omega2_7);
  lumps[20] = -Scalar(4.0) * a1 * mu1 / (Scalar(9.0) * omega1_3);  // harmonic_im_x_A_x2
  // harmonic_re_x_A_y3
  lumps[21] = (-Scalar(3.0) * omega1_2 * omega2_2 * b4 - Scalar(2.0) * omega1_2 * a3 * a4
      + Scalar(12.0) * omega2_4 * b4 + Scalar(6.0) * omega2_2 * a2 * a3
      + Scalar(8.0) * omega2_2 * a3 * a4) / (Scalar(3.0) * omega1_4 * omega2_2
      - Scalar(39.0) * omega1_2 * omega2_4 + Scalar(108.0) * omega2_6);
  // harmonic_re_x_A_x_A_y2
  lumps[22] = (Scalar(6.0) * omega1_4 * omega2_2 * b3 + Scalar(4.0) * omega1_4 * a2 * a4
      + Scalar(3.0) * omega1_3 * omega2_3 * b3 + Scalar(12.0) * omega1_3 * omega2 * a2_2
      + Scalar(2.0) * omega1_3 * omega2 * a2 * a4 - Scalar(24.0) * omega1_2 * omega2_4 * b3
      - Scalar(12.0) * omega1_2 * omega2_2 * a1 * a3 - Scalar(16.0) * omega1_2 * omega2_2 * a2 * a4
      + Scalar(24.0) * omega1_2 * omega2_2 * a3_2 - Scalar(12.0) * omega1 * omega2_5 * b3
      - Scalar(6.0) * omega1 * omega2_3 * a1 * a3 - Scalar(48.0) * omega1 * omega2_3 * a2_2
      - Scalar(8.0) * omega1 * omega2_3 * a2 * a4 - Scalar(36.0) * omega1 * omega2_3 * a3_2
      - Scalar(24.0) * omega2_4 * a3_2) / (Scalar(24.0) * omega1_5 * omega2_3 + Scalar(36.0) * omega1_4 * omega2_4
      - Scalar(84.0) * omega1_3 * omega2_5 - Scalar(144.0) * omega1_2 * omega2_6
      - Scalar(48.0) * omega1 * omega2_7);
  // harmonic_im_y_A_y_conjA_x
  lumps[23] = (Scalar(4.0) * omega1 * a3 * mu1 - Scalar(4.0) * omega2 * a3 * mu1) / (omega1_4
      - Scalar(4.0) * omega1_3 * omega2 + Scalar(4.0) * omega1_2 * omega2_2);
  // harmonic_re_y_A_x_A_y_conjA_y
  lumps[24] = (Scalar(12.0) * omega1_5 * omega2_2 * b4 - Scalar(8.0) * omega1_5 * a3 * a4
      + Scalar(6.0) * omega1_4 * omega2_3 * b4 + Scalar(4.0) * omega1_4 * omega2 * a2 * a3
      - Scalar(4.0) * omega1_4 * omega2 * a3 * a4 - Scalar(48.0) * omega1_3 * omega2_4 * b4
      - Scalar(8.0) * omega1_3 * omega2_2 * a2 * a3 + Scalar(48.0) * omega1_3 * omega2_2 * a3 * a4
      - Scalar(24.0) * omega1_2 * omega2_5 * b4 - Scalar(20.0) * omega1_2 * omega2_3 * a2 * a3
      + Scalar(24.0) * omega1_2 * omega2_3 * a3 * a4 + Scalar(32.0) * omega1 * omega2_4 * a2 * a3
      + Scalar(16.0) * omega2_5 * a2 * a3) / (Scalar(2.0) * omega1_7 * omega2_2 + omega1_6 * omega2_3
      - Scalar(10.0) * omega1_5 * omega2_4 - Scalar(5.0) * omega1_4 * omega2_5 + Scalar(8.0) * omega1_3 * omega2_6
      + Scalar(4.0) * omega1_2 * omega2_7);
  // harmonic_re_y_A_x2_conjA_x
  lumps[25] = (Scalar(9.0) * omega1_2 * omega2_2 * b2 - Scalar(12.0) * omega1_2 * a2 * a3
      - Scalar(10.0) * omega2_2 * a1 * a2) / (Scalar(3.0) * omega1_4 * omega2_2
      - Scalar(3.0) * omega1_2 * omega2_4);
  lumps[26] = a4;  // a4
  // harmonic_re_y_A_y_conjA_x2
  lumps[27] = (Scalar(3.0) * omega1_3 * b3 - Scalar(6.0) * omega1_2 * omega2 * b3 + Scalar(2.0) * omega1 * a1 * a3
      + Scalar(12.0) * omega1 * a3_2 - Scalar(4.0) * omega2 * a1 * a3) / (Scalar(12.0) * omega1_5
      - Scalar(36.0) * omega1_4 * omega2 + Scalar(24.0) * omega1_3 * omega2_2);
  lumps[28] = -Scalar(4.0) * a2 * a4 / (Scalar(9.0) * omega2_4);  // harmonic_re_y_A_x2_A_y
  lumps[29] = -Scalar(4.0) * a4 * mu2 / (Scalar(9.0) * omega2_3);  // harmonic_im_y_A_y2
  // harmonic_re_y_A_y2_conjA_x
  lumps[30] = (Scalar(9.0) * omega1_3 * omega2_2 * b4 + Scalar(2.0) * omega1_3 * a3 * a4
      - Scalar(36.0) * omega1 * omega2_4 * b4 - Scalar(6.0) * omega1 * omega2_2 * a2 * a3
      + Scalar(4.0) * omega1 * omega2_2 * a3 * a4
      + Scalar(24.0) * omega2_3 * a3 * a4) / (Scalar(3.0) * omega1_5 * omega2_2
      - Scalar(12.0) * omega1_4 * omega2_3 - Scalar(3.0) * omega1_3 * omega2_4
      + Scalar(48.0) * omega1_2 * omega2_5 - Scalar(36.0) * omega1 * omega2_6);
  // harmonic_re_y_A_x3
  lumps[31] = (Scalar(3.0) * omega1_2 * b2 + Scalar(2.0) * a1 * a2) / (Scalar(27.0) * omega1_4
      - Scalar(3.0) * omega1_2 * omega2_2);
  // harmonic_re_y_A_y3
  lumps[32] = (Scalar(3.0) * omega1_2 * omega2_2 * b5 + Scalar(2.0) * omega1_2 * a4_2
      - Scalar(12.0) * omega2_4 * b5 - Scalar(6.0) * omega2_2 * a3_2
      - Scalar(8.0) * omega2_2 * a4_2) / (Scalar(24.0) * omega1_2 * omega2_4 - Scalar(96.0) * omega2_6);
  // harmonic_re_y_A_x_A_y2
  lumps[33] = (Scalar(18.0) * omega1_4 * omega2_2 * b4 + Scalar(4.0) * omega1_4 * a3 * a4
      + Scalar(9.0) * omega1_3 * omega2_3 * b4 + Scalar(12.0) * omega1_3 * omega2 * a2 * a3
      + Scalar(2.0) * omega1_3 * omega2 * a3 * a4 - Scalar(72.0) * omega1_2 * omega2_4 * b4
      - Scalar(12.0) * omega1_2 * omega2_2 * a2 * a3 + Scalar(8.0) * omega1_2 * omega2_2 * a3 * a4
      - Scalar(36.0) * omega1 * omega2_5 * b4 - Scalar(54.0) * omega1 * omega2_3 * a2 * a3
      - Scalar(44.0) * omega1 * omega2_3 * a3 * a4
      - Scalar(24.0) * omega2_4 * a3 * a4) / (Scalar(6.0) * omega1_6 * omega2_2
      + Scalar(27.0) * omega1_5 * omega2_3 + Scalar(6.0) * omega1_4 * omega2_4
      - Scalar(99.0) * omega1_3 * omega2_5 - Scalar(120.0) * omega1_2 * omega2_6
      - Scalar(36.0) * omega1 * omega2_7);
}

/// gradient[p] = d conservative_x_A_x_A_y_conjA_y / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 150 operations.
template <class Scalar>
void lump_gradient_2(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega1_6 = omega1_5 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar denominator = Scalar(4.0) * omega1_6 * omega2_2 + Scalar(2.0) * omega1_5 * omega2_3
      - Scalar(16.0) * omega1_4 * omega2_4 - Scalar(8.0) * omega1_3 * omega2_5;
  // multiplies a1*a3
  const Scalar c_0 = -Scalar(8.0) * omega1_3 * omega2_2 - Scalar(4.0) * omega1_2 * omega2_3
      + Scalar(32.0) * omega1 * omega2_4 + Scalar(16.0) * omega2_5;
  // multiplies a2^2
  const Scalar c_1 = Scalar(4.0) * omega1_4 * omega2 + Scalar(2.0) * omega1_3 * omega2_2
      - Scalar(15.0) * omega1_2 * omega2_3 - Scalar(8.0) * omega1 * omega2_4 - Scalar(4.0) * omega2_5;
  // multiplies a2*a4
  const Scalar c_2 = -Scalar(8.0) * omega1_5 - Scalar(4.0) * omega1_4 * omega2
      + Scalar(32.0) * omega1_3 * omega2_2 + Scalar(16.0) * omega1_2 * omega2_3;
  const Scalar c_3 = Scalar(16.0) * omega1_3 * omega2_2 + Scalar(8.0) * omega1_2 * omega2_3;  // multiplies a3^2
  // multiplies b3
  const Scalar c_4 = Scalar(4.0) * omega1_5 * omega2_2 + Scalar(2.0) * omega1_4 * omega2_3
      - Scalar(16.0) * omega1_3 * omega2_4 - Scalar(8.0) * omega1_2 * omega2_5;
  const Scalar w_0 = Scalar(4.0) * b3;  // multiplies omega1^5*omega2^2
  const Scalar w_1 = -Scalar(8.0) * a2 * a4;  // multiplies omega1^5
  const Scalar w_2 = Scalar(2.0) * b3;  // multiplies omega1^4*omega2^3
  const Scalar w_3 = Scalar(4.0) * a2_2 - Scalar(4.0) * a2 * a4;  // multiplies omega1^4*omega2
  const Scalar w_4 = -Scalar(16.0) * b3;  // multiplies omega1^3*omega2^4
  // multiplies omega1^3*omega2^2
  const Scalar w_5 = -Scalar(8.0) * a1 * a3 + Scalar(2.0) * a2_2 + Scalar(32.0) * a2 * a4 + Scalar(16.0) * a3_2;
  const Scalar w_6 = -Scalar(8.0) * b3;  // multiplies omega1^2*omega2^5
  // multiplies omega1^2*omega2^3
  const Scalar w_7 = -Scalar(4.0) * a1 * a3 - Scalar(15.0) * a2_2 + Scalar(16.0) * a2 * a4 + Scalar(8.0) * a3_2;
  const Scalar w_8 = Scalar(32.0) * a1 * a3 - Scalar(8.0) * a2_2;  // multiplies omega1*omega2^4
  const Scalar w_9 = Scalar(16.0) * a1 * a3 - Scalar(4.0) * a2_2;  // multiplies omega2^5
  // by omega1
  gradient[0] = (Scalar(5.0) * omega1_4 * omega2_2 * w_0 + Scalar(5.0) * omega1_4 * w_1
      + Scalar(4.0) * omega1_3 * omega2_3 * w_2 + Scalar(4.0) * omega1_3 * omega2 * w_3
      + Scalar(3.0) * omega1_2 * omega2_4 * w_4 + Scalar(3.0) * omega1_2 * omega2_2 * w_5
      + Scalar(2.0) * omega1 * omega2_5 * w_6 + Scalar(2.0) * omega1 * omega2_3 * w_7 + omega2_4 * w_8
      - lump * (Scalar(24.0) * omega1_5 * omega2_2 + Scalar(10.0) * omega1_4 * omega2_3
      - Scalar(64.0) * omega1_3 * omega2_4 - Scalar(24.0) * omega1_2 * omega2_5)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_5 * omega2 * w_0 + Scalar(3.0) * omega1_4 * omega2_2 * w_2 + omega1_4 * w_3
      + Scalar(4.0) * omega1_3 * omega2_3 * w_4 + Scalar(2.0) * omega1_3 * omega2 * w_5
      + Scalar(5.0) * omega1_2 * omega2_4 * w_6 + Scalar(3.0) * omega1_2 * omega2_2 * w_7
      + Scalar(4.0) * omega1 * omega2_3 * w_8 + Scalar(5.0) * omega2_4 * w_9
      - lump * (Scalar(8.0) * omega1_6 * omega2 + Scalar(6.0) * omega1_5 * omega2_2
      - Scalar(64.0) * omega1_4 * omega2_3 - Scalar(40.0) * omega1_3 * omega2_4)) / denominator;
  gradient[2] = (a3 * c_0) / denominator;  // by a1
  gradient[3] = (Scalar(2.0) * a2 * c_1 + a4 * c_2) / denominator;  // by a2
  gradient[4] = (a1 * c_0 + Scalar(2.0) * a3 * c_3) / denominator;  // by a3
  gradient[5] = (a2 * c_2) / denominator;  // by a4
  gradient[8] = (c_4) / denominator;  // by b3
}

/// gradient[p] = d conservative_y_A_y2_conjA_y / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 68 operations.
template <class Scalar>
void lump_gradient_9(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b5 = parameters[10];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar a3_2 = a3 * a3;
  const Scalar a4_2 = a4 * a4;
  const Scalar denominator = Scalar(6.0) * omega1_4 * omega2_3 - Scalar(24.0) * omega1_2 * omega2_5;
  // by omega1
  gradient[0] = (Scalar(36.0) * omega1_3 * omega2_2 * b5 - Scalar(40.0) * omega1_3 * a4_2
      - Scalar(72.0) * omega1 * omega2_4 * b5 - Scalar(36.0) * omega1 * omega2_2 * a3_2
      + Scalar(80.0) * omega1 * omega2_2 * a4_2 - lump * (Scalar(24.0) * omega1_3 * omega2_3
      - Scalar(48.0) * omega1 * omega2_5)) / denominator;
  // by omega2
  gradient[1] = (Scalar(18.0) * omega1_4 * omega2 * b5 - Scalar(144.0) * omega1_2 * omega2_3 * b5
      - Scalar(36.0) * omega1_2 * omega2 * a3_2 + Scalar(80.0) * omega1_2 * omega2 * a4_2
      + Scalar(192.0) * omega2_3 * a3_2 - lump * (Scalar(18.0) * omega1_4 * omega2_2
      - Scalar(120.0) * omega1_2 * omega2_4)) / denominator;
  gradient[4] = (-Scalar(36.0) * omega1_2 * omega2_2 * a3 + Scalar(96.0) * omega2_4 * a3) / denominator;  // by a3
  gradient[5] = (-Scalar(20.0) * omega1_4 * a4 + Scalar(80.0) * omega1_2 * omega2_2 * a4) / denominator;  // by a4
  gradient[10] = (Scalar(9.0) * omega1_4 * omega2_2 - Scalar(36.0) * omega1_2 * omega2_4) / denominator;  // by b5
}

/// gradient[p] = d conservative_y_A_x_A_y_conjA_x / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 144 operations.
template <class Scalar>
void lump_gradient_10(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar denominator = Scalar(4.0) * omega1_5 * omega2_3 + Scalar(2.0) * omega1_4 * omega2_4
      - Scalar(16.0) * omega1_3 * omega2_5 - Scalar(8.0) * omega1_2 * omega2_6;
  // multiplies a1*a3
  const Scalar c_0 = -Scalar(8.0) * omega1_3 * omega2_2 - Scalar(4.0) * omega1_2 * omega2_3
      + Scalar(32.0) * omega1 * omega2_4 + Scalar(16.0) * omega2_5;
  // multiplies a2^2
  const Scalar c_1 = Scalar(2.0) * omega1_4 * omega2 - omega1_3 * omega2_2 - Scalar(8.0) * omega1_2 * omega2_3
      + Scalar(4.0) * omega1 * omega2_4;
  // multiplies a2*a4
  const Scalar c_2 = -Scalar(8.0) * omega1_5 - Scalar(4.0) * omega1_4 * omega2
      + Scalar(32.0) * omega1_3 * omega2_2 + Scalar(16.0) * omega1_2 * omega2_3;
  const Scalar c_3 = Scalar(16.0) * omega1_3 * omega2_2 + Scalar(8.0) * omega1_2 * omega2_3;  // multiplies a3^2
  // multiplies b3
  const Scalar c_4 = Scalar(4.0) * omega1_5 * omega2_2 + Scalar(2.0) * omega1_4 * omega2_3
      - Scalar(16.0) * omega1_3 * omega2_4 - Scalar(8.0) * omega1_2 * omega2_5;
  const Scalar w_0 = Scalar(4.0) * b3;  // multiplies omega1^5*omega2^2
  const Scalar w_1 = -Scalar(8.0) * a2 * a4;  // multiplies omega1^5
  const Scalar w_2 = Scalar(2.0) * b3;  // multiplies omega1^4*omega2^3
  const Scalar w_3 = Scalar(2.0) * a2_2 - Scalar(4.0) * a2 * a4;  // multiplies omega1^4*omega2
  const Scalar w_4 = -Scalar(16.0) * b3;  // multiplies omega1^3*omega2^4
  // multiplies omega1^3*omega2^2
  const Scalar w_5 = -Scalar(8.0) * a1 * a3 - a2_2 + Scalar(32.0) * a2 * a4 + Scalar(16.0) * a3_2;
  const Scalar w_6 = -Scalar(8.0) * b3;  // multiplies omega1^2*omega2^5
  // multiplies omega1^2*omega2^3
  const Scalar w_7 = -Scalar(4.0) * a1 * a3 - Scalar(8.0) * a2_2 + Scalar(16.0) * a2 * a4 + Scalar(8.0) * a3_2;
  const Scalar w_8 = Scalar(32.0) * a1 * a3 + Scalar(4.0) * a2_2;  // multiplies omega1*omega2^4
  const Scalar w_9 = Scalar(16.0) * a1 * a3;  // multiplies omega2^5
  // by omega1
  gradient[0] = (Scalar(5.0) * omega1_4 * omega2_2 * w_0 + Scalar(5.0) * omega1_4 * w_1
      + Scalar(4.0) * omega1_3 * omega2_3 * w_2 + Scalar(4.0) * omega1_3 * omega2 * w_3
      + Scalar(3.0) * omega1_2 * omega2_4 * w_4 + Scalar(3.0) * omega1_2 * omega2_2 * w_5
      + Scalar(2.0) * omega1 * omega2_5 * w_6 + Scalar(2.0) * omega1 * omega2_3 * w_7 + omega2_4 * w_8
      - lump * (Scalar(20.0) * omega1_4 * omega2_3 + Scalar(8.0) * omega1_3 * omega2_4
      - Scalar(48.0) * omega1_2 * omega2_5 - Scalar(16.0) * omega1 * omega2_6)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_5 * omega2 * w_0 + Scalar(3.0) * omega1_4 * omega2_2 * w_2 + omega1_4 * w_3
      + Scalar(4.0) * omega1_3 * omega2_3 * w_4 + Scalar(2.0) * omega1_3 * omega2 * w_5
      + Scalar(5.0) * omega1_2 * omega2_4 * w_6 + Scalar(3.0) * omega1_2 * omega2_2 * w_7
      + Scalar(4.0) * omega1 * omega2_3 * w_8 + Scalar(5.0) * omega2_4 * w_9
      - lump * (Scalar(12.0) * omega1_5 * omega2_2 + Scalar(8.0) * omega1_4 * omega2_3
      - Scalar(80.0) * omega1_3 * omega2_4 - Scalar(48.0) * omega1_2 * omega2_5)) / denominator;
  gradient[2] = (a3 * c_0) / denominator;  // by a1
  gradient[3] = (Scalar(2.0) * a2 * c_1 + a4 * c_2) / denominator;  // by a2
  gradient[4] = (a1 * c_0 + Scalar(2.0) * a3 * c_3) / denominator;  // by a3
  gradient[5] = (a2 * c_2) / denominator;  // by a4
  gradient[8] = (c_4) / denominator;  // by b3
}

/// gradient[p] = d harmonic_re_x_A_y_conjA_x2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 63 operations.
template <class Scalar>
void lump_gradient_13(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar b2 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar denominator = Scalar(9.0) * omega1_5 - Scalar(30.0) * omega1_4 * omega2
      + Scalar(27.0) * omega1_3 * omega2_2 - Scalar(6.0) * omega1_2 * omega2_3;
  // by omega1
  gradient[0] = (Scalar(27.0) * omega1_2 * b2 - Scalar(36.0) * omega1 * omega2 * b2 + Scalar(2.0) * a1 * a2
      + Scalar(12.0) * a2 * a3 - lump * (Scalar(45.0) * omega1_4 - Scalar(120.0) * omega1_3 * omega2
      + Scalar(81.0) * omega1_2 * omega2_2 - Scalar(12.0) * omega1 * omega2_3)) / denominator;
  // by omega2
  gradient[1] = (-Scalar(18.0) * omega1_2 * b2 - Scalar(4.0) * a1 * a2 - lump * (-Scalar(30.0) * omega1_4
      + Scalar(54.0) * omega1_3 * omega2 - Scalar(18.0) * omega1_2 * omega2_2)) / denominator;
  gradient[2] = (Scalar(2.0) * omega1 * a2 - Scalar(4.0) * omega2 * a2) / denominator;  // by a1
  // by a2
  gradient[3] = (Scalar(2.0) * omega1 * a1 + Scalar(12.0) * omega1 * a3
      - Scalar(4.0) * omega2 * a1) / denominator;
  gradient[4] = (Scalar(12.0) * omega1 * a2) / denominator;  // by a3
  gradient[7] = (Scalar(9.0) * omega1_3 - Scalar(18.0) * omega1_2 * omega2) / denominator;  // by b2
}

/// gradient[p] = d harmonic_re_x_A_x2_A_y / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 15 operations.
template <class Scalar>
void lump_gradient_14(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar denominator = omega1_4 - Scalar(8.0) * omega1_2 * omega2_2 + Scalar(16.0) * omega2_4;
  gradient[0] = (-lump * (Scalar(4.0) * omega1_3 - Scalar(16.0) * omega1 * omega2_2)) / denominator;  // by omega1
  // by omega2
  gradient[1] = (-lump * (-Scalar(16.0) * omega1_2 * omega2 + Scalar(64.0) * omega2_3)) / denominator;
  gradient[3] = (-Scalar(4.0) * a3) / denominator;  // by a2
  gradient[4] = (-Scalar(4.0) * a2) / denominator;  // by a3
}

/// gradient[p] = d harmonic_im_x_A_y2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 27 operations.
template <class Scalar>
void lump_gradient_15(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a3 = parameters[4];
  const Scalar mu1 = parameters[11];
  const Scalar mu2 = parameters[13];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar denominator = omega1_4 - Scalar(8.0) * omega1_2 * omega2_2 + Scalar(16.0) * omega2_4;
  gradient[0] = (-lump * (Scalar(4.0) * omega1_3 - Scalar(16.0) * omega1 * omega2_2)) / denominator;  // by omega1
  // by omega2
  gradient[1] = (Scalar(4.0) * a3 * mu1 - Scalar(8.0) * a3 * mu2 - lump * (-Scalar(16.0) * omega1_2 * omega2
      + Scalar(64.0) * omega2_3)) / denominator;
  gradient[4] = (Scalar(4.0) * omega2 * mu1 - Scalar(8.0) * omega2 * mu2) / denominator;  // by a3
  gradient[11] = (Scalar(4.0) * omega2 * a3) / denominator;  // by mu1
  gradient[13] = (-Scalar(8.0) * omega2 * a3) / denominator;  // by mu2
}

/// gradient[p] = d harmonic_re_x_A_y2_conjA_x / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 70 operations.
template <class Scalar>
void lump_gradient_16(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar a3_2 = a3 * a3;
  const Scalar denominator = Scalar(12.0) * omega1_4 * omega2_3 - Scalar(12.0) * omega1_3 * omega2_4
      - Scalar(48.0) * omega1_2 * omega2_5 + Scalar(48.0) * omega1 * omega2_6;
  const Scalar c_0 = Scalar(6.0) * omega1 * omega2_2;  // multiplies a1*a3
  const Scalar c_1 = -Scalar(2.0) * omega1_3 + Scalar(8.0) * omega1 * omega2_2;  // multiplies a2*a4
  const Scalar c_2 = -Scalar(12.0) * omega1 * omega2_2 - Scalar(24.0) * omega2_3;  // multiplies a3^2
  const Scalar c_3 = -Scalar(3.0) * omega1_3 * omega2_2 + Scalar(12.0) * omega1 * omega2_4;  // multiplies b3
  const Scalar w_0 = -Scalar(3.0) * b3;  // multiplies omega1^3*omega2^2
  const Scalar w_1 = -Scalar(2.0) * a2 * a4;  // multiplies omega1^3
  const Scalar w_2 = Scalar(12.0) * b3;  // multiplies omega1*omega2^4
  // multiplies omega1*omega2^2
  const Scalar w_3 = Scalar(6.0) * a1 * a3 + Scalar(8.0) * a2 * a4 - Scalar(12.0) * a3_2;
  const Scalar w_4 = -Scalar(24.0) * a3_2;  // multiplies omega2^3
  // by omega1
  gradient[0] = (Scalar(3.0) * omega1_2 * omega2_2 * w_0 + Scalar(3.0) * omega1_2 * w_1 + omega2_4 * w_2
      + omega2_2 * w_3 - lump * (Scalar(48.0) * omega1_3 * omega2_3 - Scalar(36.0) * omega1_2 * omega2_4
      - Scalar(96.0) * omega1 * omega2_5 + Scalar(48.0) * omega2_6)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_3 * omega2 * w_0 + Scalar(4.0) * omega1 * omega2_3 * w_2
      + Scalar(2.0) * omega1 * omega2 * w_3 + Scalar(3.0) * omega2_2 * w_4
      - lump * (Scalar(36.0) * omega1_4 * omega2_2 - Scalar(48.0) * omega1_3 * omega2_3
      - Scalar(240.0) * omega1_2 * omega2_4 + Scalar(288.0) * omega1 * omega2_5)) / denominator;
  gradient[2] = (a3 * c_0) / denominator;  // by a1
  gradient[3] = (a4 * c_1) / denominator;  // by a2
  gradient[4] = (a1 * c_0 + Scalar(2.0) * a3 * c_2) / denominator;  // by a3
  gradient[5] = (a2 * c_1) / denominator;  // by a4
  gradient[8] = (c_3) / denominator;  // by b3
}

/// gradient[p] = d harmonic_re_x_A_x3 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 24 operations.
template <class Scalar>
void lump_gradient_17(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar a2_2 = a2 * a2;
  const Scalar denominator = Scalar(4.0) * omega1_2 * omega2_3 + Scalar(4.0) * omega1 * omega2_4 + omega2_5;
  // by omega1
  gradient[0] = (-Scalar(2.0) * a2_2 - lump * (Scalar(8.0) * omega1 * omega2_3
      + Scalar(4.0) * omega2_4)) / denominator;
  // by omega2
  gradient[1] = (-Scalar(2.0) * a2_2 - lump * (Scalar(12.0) * omega1_2 * omega2_2
      + Scalar(16.0) * omega1 * omega2_3 + Scalar(5.0) * omega2_4)) / denominator;
  gradient[3] = (-Scalar(4.0) * omega1 * a2 - Scalar(4.0) * omega2 * a2) / denominator;  // by a2
}

/// gradient[p] = d harmonic_re_x_A_y2_conjA_y / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 96 operations.
template <class Scalar>
void lump_gradient_18(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
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
  const Scalar denominator = Scalar(3.0) * omega1_6 * omega2_2 - Scalar(15.0) * omega1_4 * omega2_4
      + Scalar(12.0) * omega1_2 * omega2_6;
  // by omega1
  gradient[0] = (-Scalar(36.0) * omega1_3 * omega2_2 * b4 + Scalar(40.0) * omega1_3 * a3 * a4
      + Scalar(72.0) * omega1 * omega2_4 * b4 + Scalar(36.0) * omega1 * omega2_2 * a2 * a3
      - Scalar(80.0) * omega1 * omega2_2 * a3 * a4 - lump * (Scalar(18.0) * omega1_5 * omega2_2
      - Scalar(60.0) * omega1_3 * omega2_4 + Scalar(24.0) * omega1 * omega2_6)) / denominator;
  // by omega2
  gradient[1] = (-Scalar(18.0) * omega1_4 * omega2 * b4 + Scalar(144.0) * omega1_2 * omega2_3 * b4
      + Scalar(36.0) * omega1_2 * omega2 * a2 * a3 - Scalar(80.0) * omega1_2 * omega2 * a3 * a4
      - Scalar(192.0) * omega2_3 * a2 * a3 - lump * (Scalar(6.0) * omega1_6 * omega2
      - Scalar(60.0) * omega1_4 * omega2_3 + Scalar(72.0) * omega1_2 * omega2_5)) / denominator;
  gradient[3] = (Scalar(18.0) * omega1_2 * omega2_2 * a3 - Scalar(48.0) * omega2_4 * a3) / denominator;  // by a2
  // by a3
  gradient[4] = (Scalar(10.0) * omega1_4 * a4 + Scalar(18.0) * omega1_2 * omega2_2 * a2
      - Scalar(40.0) * omega1_2 * omega2_2 * a4 - Scalar(48.0) * omega2_4 * a2) / denominator;
  gradient[5] = (Scalar(10.0) * omega1_4 * a3 - Scalar(40.0) * omega1_2 * omega2_2 * a3) / denominator;  // by a4
  gradient[9] = (-Scalar(9.0) * omega1_4 * omega2_2 + Scalar(36.0) * omega1_2 * omega2_4) / denominator;  // by b4
}

/// gradient[p] = d harmonic_re_x_A_x_A_y_conjA_x / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 139 operations.
template <class Scalar>
void lump_gradient_19(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar b2 = parameters[7];
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
  const Scalar denominator = Scalar(2.0) * omega1_7 * omega2_2 + omega1_6 * omega2_3
      - Scalar(10.0) * omega1_5 * omega2_4 - Scalar(5.0) * omega1_4 * omega2_5 + Scalar(8.0) * omega1_3 * omega2_6
      + Scalar(4.0) * omega1_2 * omega2_7;
  // multiplies a1*a2
  const Scalar c_0 = -Scalar(4.0) * omega1_4 * omega2 + Scalar(8.0) * omega1_3 * omega2_2
      + Scalar(20.0) * omega1_2 * omega2_3 - Scalar(32.0) * omega1 * omega2_4 - Scalar(16.0) * omega2_5;
  // multiplies a2*a3
  const Scalar c_1 = Scalar(8.0) * omega1_5 + Scalar(4.0) * omega1_4 * omega2 - Scalar(48.0) * omega1_3 * omega2_2
      - Scalar(24.0) * omega1_2 * omega2_3;
  // multiplies b2
  const Scalar c_2 = -Scalar(12.0) * omega1_5 * omega2_2 - Scalar(6.0) * omega1_4 * omega2_3
      + Scalar(48.0) * omega1_3 * omega2_4 + Scalar(24.0) * omega1_2 * omega2_5;
  const Scalar w_0 = -Scalar(12.0) * b2;  // multiplies omega1^5*omega2^2
  const Scalar w_1 = Scalar(8.0) * a2 * a3;  // multiplies omega1^5
  const Scalar w_2 = -Scalar(6.0) * b2;  // multiplies omega1^4*omega2^3
  const Scalar w_3 = -Scalar(4.0) * a1 * a2 + Scalar(4.0) * a2 * a3;  // multiplies omega1^4*omega2
  const Scalar w_4 = Scalar(48.0) * b2;  // multiplies omega1^3*omega2^4
  const Scalar w_5 = Scalar(8.0) * a1 * a2 - Scalar(48.0) * a2 * a3;  // multiplies omega1^3*omega2^2
  const Scalar w_6 = Scalar(24.0) * b2;  // multiplies omega1^2*omega2^5
  const Scalar w_7 = Scalar(20.0) * a1 * a2 - Scalar(24.0) * a2 * a3;  // multiplies omega1^2*omega2^3
  const Scalar w_8 = -Scalar(32.0) * a1 * a2;  // multiplies omega1*omega2^4
  const Scalar w_9 = -Scalar(16.0) * a1 * a2;  // multiplies omega2^5
  // by omega1
  gradient[0] = (Scalar(5.0) * omega1_4 * omega2_2 * w_0 + Scalar(5.0) * omega1_4 * w_1
      + Scalar(4.0) * omega1_3 * omega2_3 * w_2 + Scalar(4.0) * omega1_3 * omega2 * w_3
      + Scalar(3.0) * omega1_2 * omega2_4 * w_4 + Scalar(3.0) * omega1_2 * omega2_2 * w_5
      + Scalar(2.0) * omega1 * omega2_5 * w_6 + Scalar(2.0) * omega1 * omega2_3 * w_7 + omega2_4 * w_8
      - lump * (Scalar(14.0) * omega1_6 * omega2_2 + Scalar(6.0) * omega1_5 * omega2_3
      - Scalar(50.0) * omega1_4 * omega2_4 - Scalar(20.0) * omega1_3 * omega2_5
      + Scalar(24.0) * omega1_2 * omega2_6 + Scalar(8.0) * omega1 * omega2_7)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_5 * omega2 * w_0 + Scalar(3.0) * omega1_4 * omega2_2 * w_2 + omega1_4 * w_3
      + Scalar(4.0) * omega1_3 * omega2_3 * w_4 + Scalar(2.0) * omega1_3 * omega2 * w_5
      + Scalar(5.0) * omega1_2 * omega2_4 * w_6 + Scalar(3.0) * omega1_2 * omega2_2 * w_7
      + Scalar(4.0) * omega1 * omega2_3 * w_8 + Scalar(5.0) * omega2_4 * w_9
      - lump * (Scalar(4.0) * omega1_7 * omega2 + Scalar(3.0) * omega1_6 * omega2_2
      - Scalar(40.0) * omega1_5 * omega2_3 - Scalar(25.0) * omega1_4 * omega2_4
      + Scalar(48.0) * omega1_3 * omega2_5 + Scalar(28.0) * omega1_2 * omega2_6)) / denominator;
  gradient[2] = (a2 * c_0) / denominator;  // by a1
  gradient[3] = (a1 * c_0 + a3 * c_1) / denominator;  // by a2
  gradient[4] = (a2 * c_1) / denominator;  // by a3
  gradient[7] = (c_2) / denominator;  // by b2
}

/// gradient[p] = d harmonic_re_x_A_y3 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 59 operations.
template <class Scalar>
void lump_gradient_21(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar denominator = Scalar(3.0) * omega1_4 * omega2_2 - Scalar(39.0) * omega1_2 * omega2_4
      + Scalar(108.0) * omega2_6;
  // by omega1
  gradient[0] = (-Scalar(6.0) * omega1 * omega2_2 * b4 - Scalar(4.0) * omega1 * a3 * a4
      - lump * (Scalar(12.0) * omega1_3 * omega2_2 - Scalar(78.0) * omega1 * omega2_4)) / denominator;
  // by omega2
  gradient[1] = (-Scalar(6.0) * omega1_2 * omega2 * b4 + Scalar(48.0) * omega2_3 * b4
      + Scalar(12.0) * omega2 * a2 * a3 + Scalar(16.0) * omega2 * a3 * a4
      - lump * (Scalar(6.0) * omega1_4 * omega2 - Scalar(156.0) * omega1_2 * omega2_3
      + Scalar(648.0) * omega2_5)) / denominator;
  gradient[3] = (Scalar(6.0) * omega2_2 * a3) / denominator;  // by a2
  // by a3
  gradient[4] = (-Scalar(2.0) * omega1_2 * a4 + Scalar(6.0) * omega2_2 * a2
      + Scalar(8.0) * omega2_2 * a4) / denominator;
  gradient[5] = (-Scalar(2.0) * omega1_2 * a3 + Scalar(8.0) * omega2_2 * a3) / denominator;  // by a4
  gradient[9] = (-Scalar(3.0) * omega1_2 * omega2_2 + Scalar(12.0) * omega2_4) / denominator;  // by b4
}

/// gradient[p] = d harmonic_re_x_A_x_A_y2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 132 operations.
template <class Scalar>
void lump_gradient_22(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b3 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar omega2_7 = omega2_6 * omega2;
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar denominator = Scalar(24.0) * omega1_5 * omega2_3 + Scalar(36.0) * omega1_4 * omega2_4
      - Scalar(84.0) * omega1_3 * omega2_5 - Scalar(144.0) * omega1_2 * omega2_6
      - Scalar(48.0) * omega1 * omega2_7;
  const Scalar c_0 = -Scalar(12.0) * omega1_2 * omega2_2 - Scalar(6.0) * omega1 * omega2_3;  // multiplies a1*a3
  const Scalar c_1 = Scalar(12.0) * omega1_3 * omega2 - Scalar(48.0) * omega1 * omega2_3;  // multiplies a2^2
  // multiplies a2*a4
  const Scalar c_2 = Scalar(4.0) * omega1_4 + Scalar(2.0) * omega1_3 * omega2 - Scalar(16.0) * omega1_2 * omega2_2
      - Scalar(8.0) * omega1 * omega2_3;
  // multiplies a3^2
  const Scalar c_3 = Scalar(24.0) * omega1_2 * omega2_2 - Scalar(36.0) * omega1 * omega2_3
      - Scalar(24.0) * omega2_4;
  // multiplies b3
  const Scalar c_4 = Scalar(6.0) * omega1_4 * omega2_2 + Scalar(3.0) * omega1_3 * omega2_3
      - Scalar(24.0) * omega1_2 * omega2_4 - Scalar(12.0) * omega1 * omega2_5;
  const Scalar w_0 = Scalar(6.0) * b3;  // multiplies omega1^4*omega2^2
  const Scalar w_1 = Scalar(4.0) * a2 * a4;  // multiplies omega1^4
  const Scalar w_2 = Scalar(3.0) * b3;  // multiplies omega1^3*omega2^3
  const Scalar w_3 = Scalar(12.0) * a2_2 + Scalar(2.0) * a2 * a4;  // multiplies omega1^3*omega2
  const Scalar w_4 = -Scalar(24.0) * b3;  // multiplies omega1^2*omega2^4
  // multiplies omega1^2*omega2^2
  const Scalar w_5 = -Scalar(12.0) * a1 * a3 - Scalar(16.0) * a2 * a4 + Scalar(24.0) * a3_2;
  const Scalar w_6 = -Scalar(12.0) * b3;  // multiplies omega1*omega2^5
  // multiplies omega1*omega2^3
  const Scalar w_7 = -Scalar(6.0) * a1 * a3 - Scalar(48.0) * a2_2 - Scalar(8.0) * a2 * a4 - Scalar(36.0) * a3_2;
  const Scalar w_8 = -Scalar(24.0) * a3_2;  // multiplies omega2^4
  // by omega1
  gradient[0] = (Scalar(4.0) * omega1_3 * omega2_2 * w_0 + Scalar(4.0) * omega1_3 * w_1
      + Scalar(3.0) * omega1_2 * omega2_3 * w_2 + Scalar(3.0) * omega1_2 * omega2 * w_3
      + Scalar(2.0) * omega1 * omega2_4 * w_4 + Scalar(2.0) * omega1 * omega2_2 * w_5 + omega2_5 * w_6
      + omega2_3 * w_7 - lump * (Scalar(120.0) * omega1_4 * omega2_3 + Scalar(144.0) * omega1_3 * omega2_4
      - Scalar(252.0) * omega1_2 * omega2_5 - Scalar(288.0) * omega1 * omega2_6
      - Scalar(48.0) * omega2_7)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_4 * omega2 * w_0 + Scalar(3.0) * omega1_3 * omega2_2 * w_2 + omega1_3 * w_3
      + Scalar(4.0) * omega1_2 * omega2_3 * w_4 + Scalar(2.0) * omega1_2 * omega2 * w_5
      + Scalar(5.0) * omega1 * omega2_4 * w_6 + Scalar(3.0) * omega1 * omega2_2 * w_7
      + Scalar(4.0) * omega2_3 * w_8 - lump * (Scalar(72.0) * omega1_5 * omega2_2
      + Scalar(144.0) * omega1_4 * omega2_3 - Scalar(420.0) * omega1_3 * omega2_4
      - Scalar(864.0) * omega1_2 * omega2_5 - Scalar(336.0) * omega1 * omega2_6)) / denominator;
  gradient[2] = (a3 * c_0) / denominator;  // by a1
  gradient[3] = (Scalar(2.0) * a2 * c_1 + a4 * c_2) / denominator;  // by a2
  gradient[4] = (a1 * c_0 + Scalar(2.0) * a3 * c_3) / denominator;  // by a3
  gradient[5] = (a2 * c_2) / denominator;  // by a4
  gradient[8] = (c_4) / denominator;  // by b3
}

/// gradient[p] = d harmonic_im_y_A_y_conjA_x / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 31 operations.
template <class Scalar>
void lump_gradient_23(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a3 = parameters[4];
  const Scalar mu1 = parameters[11];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar denominator = omega1_4 - Scalar(4.0) * omega1_3 * omega2 + Scalar(4.0) * omega1_2 * omega2_2;
  // by omega1
  gradient[0] = (Scalar(4.0) * a3 * mu1 - lump * (Scalar(4.0) * omega1_3 - Scalar(12.0) * omega1_2 * omega2
      + Scalar(8.0) * omega1 * omega2_2)) / denominator;
  // by omega2
  gradient[1] = (-Scalar(4.0) * a3 * mu1 - lump * (-Scalar(4.0) * omega1_3
      + Scalar(8.0) * omega1_2 * omega2)) / denominator;
  gradient[4] = (Scalar(4.0) * omega1 * mu1 - Scalar(4.0) * omega2 * mu1) / denominator;  // by a3
  gradient[11] = (Scalar(4.0) * omega1 * a3 - Scalar(4.0) * omega2 * a3) / denominator;  // by mu1
}

/// gradient[p] = d harmonic_re_y_A_x_A_y_conjA_y / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 139 operations.
template <class Scalar>
void lump_gradient_24(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
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
  const Scalar denominator = Scalar(2.0) * omega1_7 * omega2_2 + omega1_6 * omega2_3
      - Scalar(10.0) * omega1_5 * omega2_4 - Scalar(5.0) * omega1_4 * omega2_5 + Scalar(8.0) * omega1_3 * omega2_6
      + Scalar(4.0) * omega1_2 * omega2_7;
  // multiplies a2*a3
  const Scalar c_0 = Scalar(4.0) * omega1_4 * omega2 - Scalar(8.0) * omega1_3 * omega2_2
      - Scalar(20.0) * omega1_2 * omega2_3 + Scalar(32.0) * omega1 * omega2_4 + Scalar(16.0) * omega2_5;
  // multiplies a3*a4
  const Scalar c_1 = -Scalar(8.0) * omega1_5 - Scalar(4.0) * omega1_4 * omega2
      + Scalar(48.0) * omega1_3 * omega2_2 + Scalar(24.0) * omega1_2 * omega2_3;
  // multiplies b4
  const Scalar c_2 = Scalar(12.0) * omega1_5 * omega2_2 + Scalar(6.0) * omega1_4 * omega2_3
      - Scalar(48.0) * omega1_3 * omega2_4 - Scalar(24.0) * omega1_2 * omega2_5;
  const Scalar w_0 = Scalar(12.0) * b4;  // multiplies omega1^5*omega2^2
  const Scalar w_1 = -Scalar(8.0) * a3 * a4;  // multiplies omega1^5
  const Scalar w_2 = Scalar(6.0) * b4;  // multiplies omega1^4*omega2^3
  const Scalar w_3 = Scalar(4.0) * a2 * a3 - Scalar(4.0) * a3 * a4;  // multiplies omega1^4*omega2
  const Scalar w_4 = -Scalar(48.0) * b4;  // multiplies omega1^3*omega2^4
  const Scalar w_5 = -Scalar(8.0) * a2 * a3 + Scalar(48.0) * a3 * a4;  // multiplies omega1^3*omega2^2
  const Scalar w_6 = -Scalar(24.0) * b4;  // multiplies omega1^2*omega2^5
  const Scalar w_7 = -Scalar(20.0) * a2 * a3 + Scalar(24.0) * a3 * a4;  // multiplies omega1^2*omega2^3
  const Scalar w_8 = Scalar(32.0) * a2 * a3;  // multiplies omega1*omega2^4
  const Scalar w_9 = Scalar(16.0) * a2 * a3;  // multiplies omega2^5
  // by omega1
  gradient[0] = (Scalar(5.0) * omega1_4 * omega2_2 * w_0 + Scalar(5.0) * omega1_4 * w_1
      + Scalar(4.0) * omega1_3 * omega2_3 * w_2 + Scalar(4.0) * omega1_3 * omega2 * w_3
      + Scalar(3.0) * omega1_2 * omega2_4 * w_4 + Scalar(3.0) * omega1_2 * omega2_2 * w_5
      + Scalar(2.0) * omega1 * omega2_5 * w_6 + Scalar(2.0) * omega1 * omega2_3 * w_7 + omega2_4 * w_8
      - lump * (Scalar(14.0) * omega1_6 * omega2_2 + Scalar(6.0) * omega1_5 * omega2_3
      - Scalar(50.0) * omega1_4 * omega2_4 - Scalar(20.0) * omega1_3 * omega2_5
      + Scalar(24.0) * omega1_2 * omega2_6 + Scalar(8.0) * omega1 * omega2_7)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_5 * omega2 * w_0 + Scalar(3.0) * omega1_4 * omega2_2 * w_2 + omega1_4 * w_3
      + Scalar(4.0) * omega1_3 * omega2_3 * w_4 + Scalar(2.0) * omega1_3 * omega2 * w_5
      + Scalar(5.0) * omega1_2 * omega2_4 * w_6 + Scalar(3.0) * omega1_2 * omega2_2 * w_7
      + Scalar(4.0) * omega1 * omega2_3 * w_8 + Scalar(5.0) * omega2_4 * w_9
      - lump * (Scalar(4.0) * omega1_7 * omega2 + Scalar(3.0) * omega1_6 * omega2_2
      - Scalar(40.0) * omega1_5 * omega2_3 - Scalar(25.0) * omega1_4 * omega2_4
      + Scalar(48.0) * omega1_3 * omega2_5 + Scalar(28.0) * omega1_2 * omega2_6)) / denominator;
  gradient[3] = (a3 * c_0) / denominator;  // by a2
  gradient[4] = (a2 * c_0 + a4 * c_1) / denominator;  // by a3
  gradient[5] = (a3 * c_1) / denominator;  // by a4
  gradient[9] = (c_2) / denominator;  // by b4
}

/// gradient[p] = d harmonic_re_y_A_x2_conjA_x / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 40 operations.
template <class Scalar>
void lump_gradient_25(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar b2 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar denominator = Scalar(3.0) * omega1_4 * omega2_2 - Scalar(3.0) * omega1_2 * omega2_4;
  // by omega1
  gradient[0] = (Scalar(18.0) * omega1 * omega2_2 * b2 - Scalar(24.0) * omega1 * a2 * a3
      - lump * (Scalar(12.0) * omega1_3 * omega2_2 - Scalar(6.0) * omega1 * omega2_4)) / denominator;
  // by omega2
  gradient[1] = (Scalar(18.0) * omega1_2 * omega2 * b2 - Scalar(20.0) * omega2 * a1 * a2
      - lump * (Scalar(6.0) * omega1_4 * omega2 - Scalar(12.0) * omega1_2 * omega2_3)) / denominator;
  gradient[2] = (-Scalar(10.0) * omega2_2 * a2) / denominator;  // by a1
  gradient[3] = (-Scalar(12.0) * omega1_2 * a3 - Scalar(10.0) * omega2_2 * a1) / denominator;  // by a2
  gradient[4] = (-Scalar(12.0) * omega1_2 * a2) / denominator;  // by a3
  gradient[7] = (Scalar(9.0) * omega1_2 * omega2_2) / denominator;  // by b2
}

/// gradient[p] = d harmonic_re_y_A_y_conjA_x2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 51 operations.
template <class Scalar>
void lump_gradient_27(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a3 = parameters[4];
  const Scalar b3 = parameters[8];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar a3_2 = a3 * a3;
  const Scalar denominator = Scalar(12.0) * omega1_5 - Scalar(36.0) * omega1_4 * omega2
      + Scalar(24.0) * omega1_3 * omega2_2;
  // by omega1
  gradient[0] = (Scalar(9.0) * omega1_2 * b3 - Scalar(12.0) * omega1 * omega2 * b3 + Scalar(2.0) * a1 * a3
      + Scalar(12.0) * a3_2 - lump * (Scalar(60.0) * omega1_4 - Scalar(144.0) * omega1_3 * omega2
      + Scalar(72.0) * omega1_2 * omega2_2)) / denominator;
  // by omega2
  gradient[1] = (-Scalar(6.0) * omega1_2 * b3 - Scalar(4.0) * a1 * a3 - lump * (-Scalar(36.0) * omega1_4
      + Scalar(48.0) * omega1_3 * omega2)) / denominator;
  gradient[2] = (Scalar(2.0) * omega1 * a3 - Scalar(4.0) * omega2 * a3) / denominator;  // by a1
  // by a3
  gradient[4] = (Scalar(2.0) * omega1 * a1 + Scalar(24.0) * omega1 * a3
      - Scalar(4.0) * omega2 * a1) / denominator;
  gradient[8] = (Scalar(3.0) * omega1_3 - Scalar(6.0) * omega1_2 * omega2) / denominator;  // by b3
}

/// gradient[p] = d harmonic_re_y_A_y2_conjA_x / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 110 operations.
template <class Scalar>
void lump_gradient_30(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega1_5 = omega1_4 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar denominator = Scalar(3.0) * omega1_5 * omega2_2 - Scalar(12.0) * omega1_4 * omega2_3
      - Scalar(3.0) * omega1_3 * omega2_4 + Scalar(48.0) * omega1_2 * omega2_5 - Scalar(36.0) * omega1 * omega2_6;
  // by omega1
  gradient[0] = (Scalar(27.0) * omega1_2 * omega2_2 * b4 + Scalar(6.0) * omega1_2 * a3 * a4
      - Scalar(36.0) * omega2_4 * b4 - Scalar(6.0) * omega2_2 * a2 * a3 + Scalar(4.0) * omega2_2 * a3 * a4
      - lump * (Scalar(15.0) * omega1_4 * omega2_2 - Scalar(48.0) * omega1_3 * omega2_3
      - Scalar(9.0) * omega1_2 * omega2_4 + Scalar(96.0) * omega1 * omega2_5
      - Scalar(36.0) * omega2_6)) / denominator;
  // by omega2
  gradient[1] = (Scalar(18.0) * omega1_3 * omega2 * b4 - Scalar(144.0) * omega1 * omega2_3 * b4
      - Scalar(12.0) * omega1 * omega2 * a2 * a3 + Scalar(8.0) * omega1 * omega2 * a3 * a4
      + Scalar(72.0) * omega2_2 * a3 * a4 - lump * (Scalar(6.0) * omega1_5 * omega2
      - Scalar(36.0) * omega1_4 * omega2_2 - Scalar(12.0) * omega1_3 * omega2_3
      + Scalar(240.0) * omega1_2 * omega2_4 - Scalar(216.0) * omega1 * omega2_5)) / denominator;
  gradient[3] = (-Scalar(6.0) * omega1 * omega2_2 * a3) / denominator;  // by a2
  // by a3
  gradient[4] = (Scalar(2.0) * omega1_3 * a4 - Scalar(6.0) * omega1 * omega2_2 * a2
      + Scalar(4.0) * omega1 * omega2_2 * a4 + Scalar(24.0) * omega2_3 * a4) / denominator;
  // by a4
  gradient[5] = (Scalar(2.0) * omega1_3 * a3 + Scalar(4.0) * omega1 * omega2_2 * a3
      + Scalar(24.0) * omega2_3 * a3) / denominator;
  gradient[9] = (Scalar(9.0) * omega1_3 * omega2_2 - Scalar(36.0) * omega1 * omega2_4) / denominator;  // by b4
}

/// gradient[p] = d harmonic_re_y_A_x3 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 15 operations.
template <class Scalar>
void lump_gradient_31(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a1 = parameters[2];
  const Scalar a2 = parameters[3];
  const Scalar b2 = parameters[7];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega1_4 = omega1_3 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar denominator = Scalar(27.0) * omega1_4 - Scalar(3.0) * omega1_2 * omega2_2;
  // by omega1
  gradient[0] = (Scalar(6.0) * omega1 * b2 - lump * (Scalar(108.0) * omega1_3
      - Scalar(6.0) * omega1 * omega2_2)) / denominator;
  gradient[1] = (-lump * (-Scalar(6.0) * omega1_2 * omega2)) / denominator;  // by omega2
  gradient[2] = (Scalar(2.0) * a2) / denominator;  // by a1
  gradient[3] = (Scalar(2.0) * a1) / denominator;  // by a2
  gradient[7] = (Scalar(3.0) * omega1_2) / denominator;  // by b2
}

/// gradient[p] = d harmonic_re_y_A_y3 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// 39 operations.
template <class Scalar>
void lump_gradient_32(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b5 = parameters[10];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  const Scalar omega2_5 = omega2_4 * omega2;
  const Scalar omega2_6 = omega2_5 * omega2;
  const Scalar a3_2 = a3 * a3;
  const Scalar a4_2 = a4 * a4;
  const Scalar denominator = Scalar(24.0) * omega1_2 * omega2_4 - Scalar(96.0) * omega2_6;
  // by omega1
  gradient[0] = (Scalar(6.0) * omega1 * omega2_2 * b5 + Scalar(4.0) * omega1 * a4_2
      - lump * (Scalar(48.0) * omega1 * omega2_4)) / denominator;
  // by omega2
  gradient[1] = (Scalar(6.0) * omega1_2 * omega2 * b5 - Scalar(48.0) * omega2_3 * b5
      - Scalar(12.0) * omega2 * a3_2 - Scalar(16.0) * omega2 * a4_2 - lump * (Scalar(96.0) * omega1_2 * omega2_3
      - Scalar(576.0) * omega2_5)) / denominator;
  gradient[4] = (-Scalar(12.0) * omega2_2 * a3) / denominator;  // by a3
  gradient[5] = (Scalar(4.0) * omega1_2 * a4 - Scalar(16.0) * omega2_2 * a4) / denominator;  // by a4
  gradient[10] = (Scalar(3.0) * omega1_2 * omega2_2 - Scalar(12.0) * omega2_4) / denominator;  // by b5
}

/// gradient[p] = d harmonic_re_y_A_x_A_y2 / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.
/// N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has none of
/// them.
/// 128 operations.
template <class Scalar>
void lump_gradient_33(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar a2 = parameters[3];
  const Scalar a3 = parameters[4];
  const Scalar a4 = parameters[5];
  const Scalar b4 = parameters[9];
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
  const Scalar denominator = Scalar(6.0) * omega1_6 * omega2_2 + Scalar(27.0) * omega1_5 * omega2_3
      + Scalar(6.0) * omega1_4 * omega2_4 - Scalar(99.0) * omega1_3 * omega2_5
      - Scalar(120.0) * omega1_2 * omega2_6 - Scalar(36.0) * omega1 * omega2_7;
  // multiplies a2*a3
  const Scalar c_0 = Scalar(12.0) * omega1_3 * omega2 - Scalar(12.0) * omega1_2 * omega2_2
      - Scalar(54.0) * omega1 * omega2_3;
  // multiplies a3*a4
  const Scalar c_1 = Scalar(4.0) * omega1_4 + Scalar(2.0) * omega1_3 * omega2 + Scalar(8.0) * omega1_2 * omega2_2
      - Scalar(44.0) * omega1 * omega2_3 - Scalar(24.0) * omega2_4;
  // multiplies b4
  const Scalar c_2 = Scalar(18.0) * omega1_4 * omega2_2 + Scalar(9.0) * omega1_3 * omega2_3
      - Scalar(72.0) * omega1_2 * omega2_4 - Scalar(36.0) * omega1 * omega2_5;
  const Scalar w_0 = Scalar(18.0) * b4;  // multiplies omega1^4*omega2^2
  const Scalar w_1 = Scalar(4.0) * a3 * a4;  // multiplies omega1^4
  const Scalar w_2 = Scalar(9.0) * b4;  // multiplies omega1^3*omega2^3
  const Scalar w_3 = Scalar(12.0) * a2 * a3 + Scalar(2.0) * a3 * a4;  // multiplies omega1^3*omega2
  const Scalar w_4 = -Scalar(72.0) * b4;  // multiplies omega1^2*omega2^4
  const Scalar w_5 = -Scalar(12.0) * a2 * a3 + Scalar(8.0) * a3 * a4;  // multiplies omega1^2*omega2^2
  const Scalar w_6 = -Scalar(36.0) * b4;  // multiplies omega1*omega2^5
  const Scalar w_7 = -Scalar(54.0) * a2 * a3 - Scalar(44.0) * a3 * a4;  // multiplies omega1*omega2^3
  const Scalar w_8 = -Scalar(24.0) * a3 * a4;  // multiplies omega2^4
  // by omega1
  gradient[0] = (Scalar(4.0) * omega1_3 * omega2_2 * w_0 + Scalar(4.0) * omega1_3 * w_1
      + Scalar(3.0) * omega1_2 * omega2_3 * w_2 + Scalar(3.0) * omega1_2 * omega2 * w_3
      + Scalar(2.0) * omega1 * omega2_4 * w_4 + Scalar(2.0) * omega1 * omega2_2 * w_5 + omega2_5 * w_6
      + omega2_3 * w_7 - lump * (Scalar(36.0) * omega1_5 * omega2_2 + Scalar(135.0) * omega1_4 * omega2_3
      + Scalar(24.0) * omega1_3 * omega2_4 - Scalar(297.0) * omega1_2 * omega2_5
      - Scalar(240.0) * omega1 * omega2_6 - Scalar(36.0) * omega2_7)) / denominator;
  // by omega2
  gradient[1] = (Scalar(2.0) * omega1_4 * omega2 * w_0 + Scalar(3.0) * omega1_3 * omega2_2 * w_2 + omega1_3 * w_3
      + Scalar(4.0) * omega1_2 * omega2_3 * w_4 + Scalar(2.0) * omega1_2 * omega2 * w_5
      + Scalar(5.0) * omega1 * omega2_4 * w_6 + Scalar(3.0) * omega1 * omega2_2 * w_7
      + Scalar(4.0) * omega2_3 * w_8 - lump * (Scalar(12.0) * omega1_6 * omega2
      + Scalar(81.0) * omega1_5 * omega2_2 + Scalar(24.0) * omega1_4 * omega2_3
      - Scalar(495.0) * omega1_3 * omega2_4 - Scalar(720.0) * omega1_2 * omega2_5
      - Scalar(252.0) * omega1 * omega2_6)) / denominator;
  gradient[3] = (a3 * c_0) / denominator;  // by a2
  gradient[4] = (a2 * c_0 + a4 * c_1) / denominator;  // by a3
  gradient[5] = (a3 * c_1) / denominator;  // by a4
  gradient[9] = (c_2) / denominator;  // by b4
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
  Scalar lumps[34];
  evaluate_lumps(parameters, lumps);
  for (std::size_t i = 0; i < 510; ++i) jacobian[i] = Scalar(0.0);
  jacobian[11] = Scalar(1.0);  // d mu1 / d mu1
  jacobian[15] = mu1_2 / (Scalar(2.0) * omega1_2);  // d conservative_x_A_x / d omega1
  jacobian[26] = -mu1 / omega1;  // d conservative_x_A_x / d mu1
  lump_gradient_2(parameters, lumps[2], jacobian + 30);  // d conservative_x_A_x_A_y_conjA_y
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
  lump_gradient_9(parameters, lumps[9], jacobian + 135);  // d conservative_y_A_y2_conjA_y
  lump_gradient_10(parameters, lumps[10], jacobian + 150);  // d conservative_y_A_x_A_y_conjA_x
  jacobian[169] = Scalar(1.0);  // d a3 / d a3
  jacobian[182] = Scalar(1.0);  // d a1 / d a1
  lump_gradient_13(parameters, lumps[13], jacobian + 195);  // d harmonic_re_x_A_y_conjA_x2
  lump_gradient_14(parameters, lumps[14], jacobian + 210);  // d harmonic_re_x_A_x2_A_y
  lump_gradient_15(parameters, lumps[15], jacobian + 225);  // d harmonic_im_x_A_y2
  lump_gradient_16(parameters, lumps[16], jacobian + 240);  // d harmonic_re_x_A_y2_conjA_x
  lump_gradient_17(parameters, lumps[17], jacobian + 255);  // d harmonic_re_x_A_x3
  lump_gradient_18(parameters, lumps[18], jacobian + 270);  // d harmonic_re_x_A_y2_conjA_y
  lump_gradient_19(parameters, lumps[19], jacobian + 285);  // d harmonic_re_x_A_x_A_y_conjA_x
  jacobian[300] = Scalar(4.0) * a1 * mu1 / (Scalar(3.0) * omega1_4);  // d harmonic_im_x_A_x2 / d omega1
  jacobian[302] = -Scalar(4.0) * mu1 / (Scalar(9.0) * omega1_3);  // d harmonic_im_x_A_x2 / d a1
  jacobian[311] = -Scalar(4.0) * a1 / (Scalar(9.0) * omega1_3);  // d harmonic_im_x_A_x2 / d mu1
  lump_gradient_21(parameters, lumps[21], jacobian + 315);  // d harmonic_re_x_A_y3
  lump_gradient_22(parameters, lumps[22], jacobian + 330);  // d harmonic_re_x_A_x_A_y2
  lump_gradient_23(parameters, lumps[23], jacobian + 345);  // d harmonic_im_y_A_y_conjA_x
  lump_gradient_24(parameters, lumps[24], jacobian + 360);  // d harmonic_re_y_A_x_A_y_conjA_y
  lump_gradient_25(parameters, lumps[25], jacobian + 375);  // d harmonic_re_y_A_x2_conjA_x
  jacobian[395] = Scalar(1.0);  // d a4 / d a4
  lump_gradient_27(parameters, lumps[27], jacobian + 405);  // d harmonic_re_y_A_y_conjA_x2
  jacobian[421] = Scalar(16.0) * a2 * a4 / (Scalar(9.0) * omega2_5);  // d harmonic_re_y_A_x2_A_y / d omega2
  jacobian[423] = -Scalar(4.0) * a4 / (Scalar(9.0) * omega2_4);  // d harmonic_re_y_A_x2_A_y / d a2
  jacobian[425] = -Scalar(4.0) * a2 / (Scalar(9.0) * omega2_4);  // d harmonic_re_y_A_x2_A_y / d a4
  jacobian[436] = Scalar(4.0) * a4 * mu2 / (Scalar(3.0) * omega2_4);  // d harmonic_im_y_A_y2 / d omega2
  jacobian[440] = -Scalar(4.0) * mu2 / (Scalar(9.0) * omega2_3);  // d harmonic_im_y_A_y2 / d a4
  jacobian[448] = -Scalar(4.0) * a4 / (Scalar(9.0) * omega2_3);  // d harmonic_im_y_A_y2 / d mu2
  lump_gradient_30(parameters, lumps[30], jacobian + 450);  // d harmonic_re_y_A_y2_conjA_x
  lump_gradient_31(parameters, lumps[31], jacobian + 465);  // d harmonic_re_y_A_x3
  lump_gradient_32(parameters, lumps[32], jacobian + 480);  // d harmonic_re_y_A_y3
  lump_gradient_33(parameters, lumps[33], jacobian + 495);  // d harmonic_re_y_A_x_A_y2
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

/// What multiplies the 4 terms of the harmonic 2*omega2 of x: functions of the frequencies alone. 5 operations.
template <class Scalar>
void factors_3([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  factor[0] = -Scalar(1.0) / (omega1_2 - Scalar(4.0) * omega2_2);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the harmonic 2*omega2 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega2)*t) in x = -1/(omega1^2 - 4*omega2^2)*a3*A_y^2 +
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

/// What multiplies the 6 terms of the harmonic omega1+omega2 of x: functions of the frequencies alone. 22
/// operations.
template <class Scalar>
void factors_4([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  const Scalar omega2_4 = omega2_3 * omega2;
  factor[0] = (-Scalar(8.0) * omega1_3 - Scalar(8.0) * omega1_2 * omega2) / (Scalar(4.0) * omega1_2 * omega2_2
      + Scalar(4.0) * omega1 * omega2_3 + omega2_4);
  factor[1] = Scalar(2.0) / (Scalar(2.0) * omega1 * omega2 + omega2_2);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(2.0) * omega2 / omega1;
  factor[5] = Scalar(1.0);
}

/// Rows of the harmonic omega1+omega2 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + omega2)*t) in x = (-8*omega1^3 - 8*omega1^2*omega2)/(4*omega1^2*omega2^2 +
/// 4*omega1*omega2^3 + omega2^4)*i*dissipative_x_A_y_conjA_x*A_x*A_y + 2/(2*omega1*omega2 + omega2^2)*a2*A_x*A_y
/// + harmonic_re_x_A_y2_conjA_x*conj(A_x)*A_y^2 + harmonic_re_x_A_x3*A_x^3 +
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

/// What multiplies the 6 terms of the harmonic omega1 of y: functions of the frequencies alone. 22 operations.
template <class Scalar>
void factors_8([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega1_3 = omega1_2 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar omega2_3 = omega2_2 * omega2;
  factor[0] = Scalar(2.0) / (omega1_2 - Scalar(2.0) * omega1 * omega2);
  factor[1] = (omega1_3 + Scalar(3.0) * omega1_2 * omega2 - Scalar(4.0) * omega2_3) / omega1_3;
  factor[2] = (-omega1_3 - Scalar(3.0) * omega1_2 * omega2
      + Scalar(4.0) * omega2_3) / (Scalar(2.0) * omega1_2 * omega2);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
}

/// Rows of the harmonic omega1 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1)*t) in y = 2/(omega1^2 - 2*omega1*omega2)*a3*conj(A_x)*A_y + (omega1^3 +
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
  factor[0] = Scalar(2.0) / (omega1_2 + Scalar(2.0) * omega1 * omega2);
  factor[1] = (omega1_3 - Scalar(3.0) * omega1_2 * omega2
      + Scalar(4.0) * omega2_3) / (Scalar(2.0) * omega1_2 * omega2);
  factor[2] = (omega1_3 - Scalar(3.0) * omega1_2 * omega2 + Scalar(4.0) * omega2_3) / omega1_3;
  factor[3] = (-omega1_3 + Scalar(3.0) * omega1_2 * omega2 - Scalar(4.0) * omega2_3) / (omega1_3
      + Scalar(3.0) * omega1_2 * omega2 - Scalar(4.0) * omega2_3);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
}

/// Rows of the harmonic omega1+omega2 of y: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + omega2)*t) in y = 2/(omega1^2 + 2*omega1*omega2)*a3*A_x*A_y + (omega1^3 -
/// 3*omega1^2*omega2 + 4*omega2^3)/(2*omega1^2*omega2)*harmonic_re_x_A_x2_A_y*A_x^3 + (omega1^3 -
/// 3*omega1^2*omega2 + 4*omega2^3)/omega1^3*harmonic_re_x_A_x2_A_y*conj(A_x)*A_y^2 + (-omega1^3 +
/// 3*omega1^2*omega2 - 4*omega2^3)/(omega1^3 + 3*omega1^2*omega2 -
/// 4*omega2^3)*i*harmonic_im_y_A_y_conjA_x*A_x*A_y + harmonic_re_y_A_y2_conjA_x*conj(A_x)*A_y^2 +
/// harmonic_re_y_A_x3*A_x^3
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
       + times_i(lumps[5] * ((Scalar(2.0) * omega1 - omega2) / (Scalar(2.0) * omega1_2)) * (conj_A_x * A_y))
       - times_i((-omega1 + omega2 / Scalar(2.0)) * A_x));
  store_complex(derivative, 1, times_i(lumps[5] * Scalar(1.0) / (Scalar(2.0) * omega2) * (A_x * A_x))
       + times_i(lumps[5] * ((-Scalar(2.0) * omega1 + omega2) / (Scalar(4.0) * omega2_2)) * (A_x * A_x))
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
       + times_i(lumps[5] * ((Scalar(2.0) * omega1 - omega2) / (Scalar(2.0) * omega1_2)) * (A_y));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[4] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[5] = by_0_0.real - conj_by_0_0.real;
  const Complex by_0_1 = times_i(lumps[2] * (A_x * conj_A_y))
       + lumps[4] * (conj_A_x)
       + times_i(lumps[5] * Scalar(1.0) / omega1 * (conj_A_x))
       + times_i(lumps[5] * ((Scalar(2.0) * omega1 - omega2) / (Scalar(2.0) * omega1_2)) * (conj_A_x));
  const Complex conj_by_0_1 = times_i(lumps[2] * (A_x * A_y));
  jacobian[2] = by_0_1.real + conj_by_0_1.real;
  jacobian[3] = conj_by_0_1.imag - by_0_1.imag;
  jacobian[6] = by_0_1.imag + conj_by_0_1.imag;
  jacobian[7] = by_0_1.real - conj_by_0_1.real;
  const Complex by_1_0 = times_i(lumps[5] * Scalar(1.0) / (Scalar(2.0) * omega2) * Scalar(2) * (A_x))
       + times_i(lumps[5] * ((-Scalar(2.0) * omega1 + omega2) / (Scalar(4.0) * omega2_2)) * Scalar(2) * (A_x))
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
