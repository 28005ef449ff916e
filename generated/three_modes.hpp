// Model three_modes: generated code, never edited by hand.
// Holds equations of motion, lumps, what rows are made of. Made by: secular generate three_modes.
// Source: Generic; the case of S. O'F. Fahey, dissertation, Virginia Tech, 2000, section 3.2.3, with the third
// mode kept
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// three_modes.additive_combination.hpp: Omega = omega1 + omega2 + eps^2*sigma
// three_modes.free.hpp: free vibration
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

namespace secular::generated::three_modes {

/// Mass matrix M of the equations of motion M*acceleration + force = 0 below, state-dependent: mass[k * 3 + j]
/// multiplies the acceleration of mode j in equation k.
template <class Scalar, class Parameter, class Sample>
void mass_matrix([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* mass) {
  mass[0] = 1.0;
  mass[1] = 0.0;
  mass[2] = 0.0;
  mass[3] = 0.0;
  mass[4] = 1.0;
  mass[5] = 0.0;
  mass[6] = 0.0;
  mass[7] = 0.0;
  mass[8] = 1.0;
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
/// displacement, velocity, acceleration: 3 values.
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
      + 2.0 * a113 * displacement[0] * displacement[2] + b1133 * displacement[0] * displacement[2] * displacement[2]
      + b1111 * displacement[0] * displacement[0] * displacement[0] + 2.0 * mu1 * velocity[0]
      + a123 * displacement[1] * displacement[2] - e12 * displacement[1] * excitation[0].value
      - e1 * excitation[0].value);
  acceleration[1] = -(a123 * displacement[0] * displacement[2] - e12 * displacement[0] * excitation[0].value
      + b1122 * displacement[0] * displacement[0] * displacement[1] + omega2_2 * displacement[1]
      + 2.0 * a223 * displacement[1] * displacement[2] + b2233 * displacement[1] * displacement[2] * displacement[2]
      + b2222 * displacement[1] * displacement[1] * displacement[1] + 2.0 * mu2 * velocity[1]
      - e2 * excitation[0].value);
  acceleration[2] = -(a123 * displacement[0] * displacement[1] + a113 * displacement[0] * displacement[0]
      + b1133 * displacement[0] * displacement[0] * displacement[2] + a223 * displacement[1] * displacement[1]
      + b2233 * displacement[1] * displacement[1] * displacement[2] + omega3_2 * displacement[2]
      + a333 * displacement[2] * displacement[2] + 2.0 * mu3 * velocity[2] - e3 * excitation[0].value);
}

/// slope[k * 6 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = v1, v2, v3, D(v1),
/// D(v2), D(v3). Of nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x)
/// = 0.
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
  for (std::size_t i = 0; i < 18; ++i) slope[i] = 0.0;
  // equation 1 by v1
  slope[0] = -(omega1_2 + b1122 * displacement[1] * displacement[1] + 2.0 * a113 * displacement[2]
      + b1133 * displacement[2] * displacement[2] + b1111 * displacement[0] * displacement[0] * 3.0);
  // equation 1 by v2
  slope[1] = -(b1122 * displacement[0] * displacement[1] * 2.0 + a123 * displacement[2]
      - e12 * excitation[0].value);
  // equation 1 by v3
  slope[2] = -(2.0 * a113 * displacement[0] + b1133 * displacement[0] * displacement[2] * 2.0
      + a123 * displacement[1]);
  slope[3] = -(2.0 * mu1);  // equation 1 by D(v1)
  // equation 2 by v1
  slope[6] = -(a123 * displacement[2] - e12 * excitation[0].value
      + b1122 * displacement[0] * displacement[1] * 2.0);
  // equation 2 by v2
  slope[7] = -(b1122 * displacement[0] * displacement[0] + omega2_2 + 2.0 * a223 * displacement[2]
      + b2233 * displacement[2] * displacement[2] + b2222 * displacement[1] * displacement[1] * 3.0);
  // equation 2 by v3
  slope[8] = -(a123 * displacement[0] + 2.0 * a223 * displacement[1]
      + b2233 * displacement[1] * displacement[2] * 2.0);
  slope[10] = -(2.0 * mu2);  // equation 2 by D(v2)
  // equation 3 by v1
  slope[12] = -(a123 * displacement[1] + a113 * displacement[0] * 2.0
      + b1133 * displacement[0] * displacement[2] * 2.0);
  // equation 3 by v2
  slope[13] = -(a123 * displacement[0] + a223 * displacement[1] * 2.0
      + b2233 * displacement[1] * displacement[2] * 2.0);
  // equation 3 by v3
  slope[14] = -(b1133 * displacement[0] * displacement[0] + b2233 * displacement[1] * displacement[1] + omega3_2
      + a333 * displacement[2] * 2.0);
  slope[17] = -(2.0 * mu3);  // equation 3 by D(v3)
}

/// slope[k * 19 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = omega1, omega2,
/// omega3, a113, a123, a223, a333, b1111, b1122, b2222, b1133, b2233, e12, mu1, e1, mu2, e2, mu3, e3. Of
/// nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x) = 0.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_parameters([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega3 = parameters[2];
  for (std::size_t i = 0; i < 57; ++i) slope[i] = 0.0;
  slope[0] = -(2.0 * omega1 * displacement[0]);  // equation 1 by omega1
  slope[3] = -(2.0 * displacement[0] * displacement[2]);  // equation 1 by a113
  slope[4] = -(displacement[1] * displacement[2]);  // equation 1 by a123
  slope[7] = -(displacement[0] * displacement[0] * displacement[0]);  // equation 1 by b1111
  slope[8] = -(displacement[0] * displacement[1] * displacement[1]);  // equation 1 by b1122
  slope[10] = -(displacement[0] * displacement[2] * displacement[2]);  // equation 1 by b1133
  slope[12] = -(-displacement[1] * excitation[0].value);  // equation 1 by e12
  slope[13] = -(2.0 * velocity[0]);  // equation 1 by mu1
  slope[14] = -(-excitation[0].value);  // equation 1 by e1
  slope[20] = -(2.0 * omega2 * displacement[1]);  // equation 2 by omega2
  slope[23] = -(displacement[0] * displacement[2]);  // equation 2 by a123
  slope[24] = -(2.0 * displacement[1] * displacement[2]);  // equation 2 by a223
  slope[27] = -(displacement[0] * displacement[0] * displacement[1]);  // equation 2 by b1122
  slope[28] = -(displacement[1] * displacement[1] * displacement[1]);  // equation 2 by b2222
  slope[30] = -(displacement[1] * displacement[2] * displacement[2]);  // equation 2 by b2233
  slope[31] = -(-displacement[0] * excitation[0].value);  // equation 2 by e12
  slope[34] = -(2.0 * velocity[1]);  // equation 2 by mu2
  slope[35] = -(-excitation[0].value);  // equation 2 by e2
  slope[40] = -(2.0 * omega3 * displacement[2]);  // equation 3 by omega3
  slope[41] = -(displacement[0] * displacement[0]);  // equation 3 by a113
  slope[42] = -(displacement[0] * displacement[1]);  // equation 3 by a123
  slope[43] = -(displacement[1] * displacement[1]);  // equation 3 by a223
  slope[44] = -(displacement[2] * displacement[2]);  // equation 3 by a333
  slope[48] = -(displacement[0] * displacement[0] * displacement[2]);  // equation 3 by b1133
  slope[49] = -(displacement[1] * displacement[1] * displacement[2]);  // equation 3 by b2233
  slope[55] = -(2.0 * velocity[2]);  // equation 3 by mu3
  slope[56] = -(-excitation[0].value);  // equation 3 by e3
}

/// Lumps: the parameter combinations that multiply data. Symbols, their powers and the inverses of sums that
/// divide (small divisors) first, each once.
struct Lumps {
  const double omega1, omega2, omega3, a113, a123, a223, a333, b1111, b1122, b2222, b1133, b2233, e12, mu1, e1, mu2,
      e2, mu3, e3;
  const double omega1_2 = omega1 * omega1;
  const double omega2_2 = omega2 * omega2;
  const double omega3_2 = omega3 * omega3;
  const double omega3_3 = omega3_2 * omega3;
  const double omega3_4 = omega3_3 * omega3;
  const double a113_2 = a113 * a113;
  const double a123_2 = a123 * a123;
  const double a223_2 = a223 * a223;
  const double a333_2 = a333 * a333;
  const double per_0 = 1.0 / (omega1 + omega2 + omega3);
  const double per_1 = 1.0 / (omega1 + omega2 - omega3);
  const double per_2 = 1.0 / (omega1 - omega2 + omega3);
  const double per_3 = 1.0 / (omega1 - omega2 - omega3);
  const double per_4 = 1.0 / (2.0 * omega1 + omega3);
  const double per_5 = 1.0 / (2.0 * omega1 - omega3);
  const double per_6 = 1.0 / (2.0 * omega2 + omega3);
  const double per_7 = 1.0 / (2.0 * omega2 - omega3);
  const double per_8 = 1.0 / (omega1 - omega2);
  const double per_9 = 1.0 / (3.0 * omega1 - omega2);
  const double per_10 = 1.0 / (omega1 + omega2);
  const double per_11 = 1.0 / (omega1 + 2.0 * omega2);
  const double per_12 = 1.0 / (omega2 + omega3);
  const double per_13 = 1.0 / (omega2 - omega3);
  const double per_14 = 1.0 / (2.0 * omega1 + omega2);
  const double per_15 = 1.0 / (omega1 + omega3);
  const double per_16 = 1.0 / (omega1 - omega3);
  const double per_17 = 1.0 / (omega1 + omega2 - 2.0 * omega3);
  const double per_18 = 1.0 / (omega1 - omega2 + 2.0 * omega3);
  const double per_19 = 1.0 / (omega1 + omega2 + 2.0 * omega3);
  const double per_20 = 1.0 / (omega1 - omega2 - 2.0 * omega3);
  const double over_0 = per_0 * per_1;
  const double over_1 = per_2 * per_3;
  const double over_2 = per_4 * per_5;
  const double over_3 = per_6 * per_7;
  const double over_4 = per_8 * per_2 * per_3 * per_4 * per_5 * per_9;
  const double over_5 = per_10 * per_0 * per_1 * per_8;
  const double over_6 = per_10 * per_8 * per_6 * per_7;
  const double over_7 = per_8 * per_2 * per_3;
  const double over_8 = per_8 * per_6 * per_7;
  const double over_9 = per_10 * per_0 * per_1;
  const double over_10 = per_10 * per_6 * per_7;
  const double over_11 = per_8 * per_4 * per_5;
  const double over_12 = per_10 * per_4 * per_5;
  const double over_13 = per_11 * per_12 * per_13;
  const double over_14 = per_14 * per_12 * per_13;
  const double over_15 = per_11 * per_15 * per_16;
  const double over_16 = per_15 * per_16 * per_14;
  const double over_17 = per_0 * per_2;
  const double over_18 = per_1 * per_3;
  const double over_19 = per_0 * per_3;
  const double over_20 = per_1 * per_2;
  const double over_21 = per_16 * per_5;
  const double over_22 = per_1 * per_3 * per_16;
  const double over_23 = per_17 * per_18;
  const double over_24 = per_17 * per_18 * per_7;
  const double over_25 = per_1 * per_17 * per_2 * per_18;
  const double over_26 = per_10 * per_8;
  const double over_27 = per_10 * per_0 * per_1 * per_8 * per_2 * per_3;
  const double over_28 = per_19 * per_20;
  const double over_29 = per_19 * per_20 * per_6;
  const double over_30 = per_0 * per_19 * per_3 * per_20;
  const double over_31 = per_15 * per_4;
  const double over_32 = per_0 * per_2 * per_15;
  const double over_33 = per_17 * per_20;
  const double over_34 = per_17 * per_20 * per_5;
  const double over_35 = per_1 * per_17 * per_3 * per_20;
  const double over_36 = per_13 * per_7;
  const double over_37 = per_1 * per_2 * per_13;
  const double over_38 = per_12 * per_6;
  const double over_39 = per_0 * per_3 * per_12;
  const double over_40 = per_10 * per_8 * per_4 * per_5;
  const double over_41 = per_19 * per_18;
  const double over_42 = per_19 * per_18 * per_4;
  const double over_43 = per_0 * per_19 * per_2 * per_18;
  const double over_44 = per_16 * per_4 * per_5;
  const double over_45 = per_10 * per_17 * per_5;
  const double over_46 = per_10 * per_17 * per_7;
  const double over_47 = per_10 * per_0 * per_1 * per_17;
  const double over_48 = per_10 * per_1 * per_17 * per_2;
  const double over_49 = per_10 * per_1 * per_17 * per_3;
  const double over_50 = per_8 * per_20 * per_5;
  const double over_51 = per_8 * per_20 * per_6;
  const double over_52 = per_0 * per_8 * per_3 * per_20;
  const double over_53 = per_1 * per_8 * per_3 * per_20;
  const double over_54 = per_8 * per_2 * per_3 * per_20;
  const double over_55 = per_13 * per_6 * per_7;
  const double over_56 = per_12 * per_6 * per_7;
  const double over_57 = per_8 * per_18 * per_4;
  const double over_58 = per_8 * per_18 * per_7;
  const double over_59 = per_0 * per_8 * per_2 * per_18;
  const double over_60 = per_1 * per_8 * per_2 * per_18;
  const double over_61 = per_8 * per_2 * per_18 * per_3;
  const double over_62 = per_10 * per_19 * per_4;
  const double over_63 = per_10 * per_19 * per_6;
  const double over_64 = per_10 * per_0 * per_19 * per_1;
  const double over_65 = per_10 * per_0 * per_19 * per_2;
  const double over_66 = per_10 * per_0 * per_19 * per_3;
  const double over_67 = per_15 * per_4 * per_5;

  explicit Lumps(const double* parameters) : omega1(parameters[0]), omega2(parameters[1]), omega3(parameters[2]),
      a113(parameters[3]), a123(parameters[4]), a223(parameters[5]), a333(parameters[6]), b1111(parameters[7]),
      b1122(parameters[8]), b2222(parameters[9]), b1133(parameters[10]), b2233(parameters[11]), e12(parameters[12]),
      mu1(parameters[13]), e1(parameters[14]), mu2(parameters[15]), e2(parameters[16]), mu3(parameters[17]),
      e3(parameters[18]) {}

  double lump_mu1() const { return mu1; }
  /// conservative_v1_A_v1_A_v2_conjA_v2 = (omega3^2*b1122 - 2*a113*a223)/(omega1*omega3^2) +
  /// a123^2/(2*omega1*(omega1 + omega2 + omega3)*(omega1 + omega2 - omega3)) + a123^2/(2*omega1*(omega1 - omega2 +
  /// omega3)*(omega1 - omega2 - omega3))
  double lump_conservative_v1_A_v1_A_v2_conjA_v2() const {
    return (omega3_2 * b1122 - 2.0 * a113 * a223) / (omega1 * omega3_2) + a123_2 * over_0 / (2.0 * omega1)
        + a123_2 * over_1 / (2.0 * omega1);
  }
  /// conservative_v1_A_v12_conjA_v1 = 3*b1111/(2*omega1) + (-8*omega1^2*a113^2 +
  /// 3*omega3^2*a113^2)/(omega1*omega3^2*(2*omega1 + omega3)*(2*omega1 - omega3))
  double lump_conservative_v1_A_v12_conjA_v1() const {
    return 3.0 * b1111 / (2.0 * omega1) + (-8.0 * omega1_2 * a113_2
        + 3.0 * omega3_2 * a113_2) * over_2 / (omega1 * omega3_2);
  }
  /// conservative_v1_conjA_v2_F = -e12/(4*omega1) - a123*e3/(4*omega1*(omega1 + omega2 + omega3)*(omega1 + omega2
  /// - omega3))
  double lump_conservative_v1_conjA_v2_F() const {
    return -e12 / (4.0 * omega1) - a123 * e3 * over_0 / (4.0 * omega1);
  }
  double lump_mu2() const { return mu2; }
  /// conservative_v2_A_v22_conjA_v2 = 3*b2222/(2*omega2) + (-8*omega2^2*a223^2 +
  /// 3*omega3^2*a223^2)/(omega2*omega3^2*(2*omega2 + omega3)*(2*omega2 - omega3))
  double lump_conservative_v2_A_v22_conjA_v2() const {
    return 3.0 * b2222 / (2.0 * omega2) + (-8.0 * omega2_2 * a223_2
        + 3.0 * omega3_2 * a223_2) * over_3 / (omega2 * omega3_2);
  }
  double lump_e1() const { return e1; }
  /// harmonic_re_v1_A_v2_conjA_v12 = (9*omega1^2*a113*a123 - 2*omega1*omega2*a113*a123 + omega2^2*a113*a123 -
  /// 3*omega3^2*a113*a123)/((omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3)*(2*omega1 +
  /// omega3)*(2*omega1 - omega3)*(3*omega1 - omega2))
  double lump_harmonic_re_v1_A_v2_conjA_v12() const {
    return (9.0 * omega1_2 * a113 * a123 - 2.0 * omega1 * omega2 * a113 * a123 + omega2_2 * a113 * a123
        - 3.0 * omega3_2 * a113 * a123) * over_4;
  }
  double lump_harmonic_re_v1_conjA_v1_F() const { return a113 * e3 * over_5; }
  /// harmonic_re_v1_A_v22_conjA_v2 = (8*omega2^2*a123*a223 - 3*omega3^2*a123*a223)/(omega3^2*(omega1 +
  /// omega2)*(omega1 - omega2)*(2*omega2 + omega3)*(2*omega2 - omega3))
  double lump_harmonic_re_v1_A_v22_conjA_v2() const {
    return (8.0 * omega2_2 * a123 * a223 - 3.0 * omega3_2 * a123 * a223) * over_6 / omega3_2;
  }
  /// harmonic_re_v1_A_v22_conjA_v1 = -b1122/(4*omega2*(omega1 - omega2)) - a123^2/(4*omega2*(omega1 -
  /// omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3)) - a113*a223/(2*omega2*(omega1 -
  /// omega2)*(2*omega2 + omega3)*(2*omega2 - omega3))
  double lump_harmonic_re_v1_A_v22_conjA_v1() const {
    return -b1122 * per_8 / (4.0 * omega2) - a123_2 * over_7 / (4.0 * omega2)
        - a113 * a223 * over_8 / (2.0 * omega2);
  }
  /// harmonic_re_v1_A_v1_A_v22 = b1122/(4*omega2*(omega1 + omega2)) + a123^2/(4*omega2*(omega1 + omega2)*(omega1 +
  /// omega2 + omega3)*(omega1 + omega2 - omega3)) + a113*a223/(2*omega2*(omega1 + omega2)*(2*omega2 +
  /// omega3)*(2*omega2 - omega3))
  double lump_harmonic_re_v1_A_v1_A_v22() const {
    return b1122 * per_10 / (4.0 * omega2) + a123_2 * over_9 / (4.0 * omega2)
        + a113 * a223 * over_10 / (2.0 * omega2);
  }
  /// harmonic_re_v1_A_v13 = b1111/(8*omega1^2) + a113^2/(4*omega1^2*(2*omega1 + omega3)*(2*omega1 - omega3))
  double lump_harmonic_re_v1_A_v13() const {
    return b1111 / (8.0 * omega1_2) + a113_2 * over_2 / (4.0 * omega1_2);
  }
  double lump_e2() const { return e2; }
  /// harmonic_re_v2_A_v2_conjA_v12 = b1122/(4*omega1*(omega1 - omega2)) + a123^2/(4*omega1*(omega1 -
  /// omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3)) + a113*a223/(2*omega1*(omega1 -
  /// omega2)*(2*omega1 + omega3)*(2*omega1 - omega3))
  double lump_harmonic_re_v2_A_v2_conjA_v12() const {
    return b1122 * per_8 / (4.0 * omega1) + a123_2 * over_7 / (4.0 * omega1)
        + a113 * a223 * over_11 / (2.0 * omega1);
  }
  double lump_harmonic_re_v2_conjA_v2_F() const { return -a223 * e3 * over_5; }
  /// harmonic_re_v2_A_v23 = b2222/(8*omega2^2) + a223^2/(4*omega2^2*(2*omega2 + omega3)*(2*omega2 - omega3))
  double lump_harmonic_re_v2_A_v23() const {
    return b2222 / (8.0 * omega2_2) + a223_2 * over_3 / (4.0 * omega2_2);
  }
  /// harmonic_re_v2_A_v12_A_v2 = b1122/(4*omega1*(omega1 + omega2)) + a123^2/(4*omega1*(omega1 + omega2)*(omega1 +
  /// omega2 + omega3)*(omega1 + omega2 - omega3)) + a113*a223/(2*omega1*(omega1 + omega2)*(2*omega1 +
  /// omega3)*(2*omega1 - omega3))
  double lump_harmonic_re_v2_A_v12_A_v2() const {
    return b1122 * per_10 / (4.0 * omega1) + a123_2 * over_9 / (4.0 * omega1)
        + a113 * a223 * over_12 / (2.0 * omega1);
  }
  double lump_a123() const { return a123; }
  double lump_a223() const { return a223; }
  double lump_a113() const { return a113; }
  double lump_e3() const { return e3; }
  /// harmonic_re_v3_conjA_v1_F = -a123*e2/(2*omega1*(omega1 + 2*omega2)*(omega2 + omega3)*(omega2 - omega3)) -
  /// a113*e1/(omega2*(2*omega1 + omega2)*(omega2 + omega3)*(omega2 - omega3))
  double lump_harmonic_re_v3_conjA_v1_F() const {
    return -a123 * e2 * over_13 / (2.0 * omega1) - a113 * e1 * over_14 / omega2;
  }
  /// harmonic_re_v3_conjA_v2_F = -a223*e2/(omega1*(omega1 + 2*omega2)*(omega1 + omega3)*(omega1 - omega3)) -
  /// a123*e1/(2*omega2*(omega1 + omega3)*(omega1 - omega3)*(2*omega1 + omega2))
  double lump_harmonic_re_v3_conjA_v2_F() const {
    return -a223 * e2 * over_15 / omega1 - a123 * e1 * over_16 / (2.0 * omega2);
  }
  /// conservative_v1_A_v1_A_v3_conjA_v3 = (omega3^2*b1133 - 2*a113*a333)/(omega1*omega3^2) +
  /// a123^2/(2*omega1*(omega1 + omega2 + omega3)*(omega1 - omega2 + omega3)) + a123^2/(2*omega1*(omega1 + omega2 -
  /// omega3)*(omega1 - omega2 - omega3)) - 4*a113^2/(omega1*(2*omega1 + omega3)*(2*omega1 - omega3))
  double lump_conservative_v1_A_v1_A_v3_conjA_v3() const {
    return (omega3_2 * b1133 - 2.0 * a113 * a333) / (omega1 * omega3_2) + a123_2 * over_17 / (2.0 * omega1)
        + a123_2 * over_18 / (2.0 * omega1) - 4.0 * a113_2 * over_2 / omega1;
  }
  /// conservative_v2_A_v2_A_v3_conjA_v3 = (omega3^2*b2233 - 2*a223*a333)/(omega2*omega3^2) -
  /// a123^2/(2*omega2*(omega1 + omega2 + omega3)*(omega1 - omega2 - omega3)) - a123^2/(2*omega2*(omega1 + omega2 -
  /// omega3)*(omega1 - omega2 + omega3)) - 4*a223^2/(omega2*(2*omega2 + omega3)*(2*omega2 - omega3))
  double lump_conservative_v2_A_v2_A_v3_conjA_v3() const {
    return (omega3_2 * b2233 - 2.0 * a223 * a333) / (omega2 * omega3_2) - a123_2 * over_19 / (2.0 * omega2)
        - a123_2 * over_20 / (2.0 * omega2) - 4.0 * a223_2 * over_3 / omega2;
  }
  double lump_mu3() const { return mu3; }
  double lump_conservative_v3_A_v32_conjA_v3() const { return -5.0 * a333_2 / (3.0 * omega3_3); }
  /// harmonic_re_v1_A_v32_conjA_v1 = (-3*omega3^2*b1133 - 2*a113*a333)/(12*omega3^3*(omega1 - omega3)) +
  /// a113^2/(omega3^2*(omega1 - omega3)*(2*omega1 - omega3)) - a123^2/(4*omega3*(omega1 + omega2 - omega3)*(omega1
  /// - omega2 - omega3)*(omega1 - omega3))
  double lump_harmonic_re_v1_A_v32_conjA_v1() const {
    return (-3.0 * omega3_2 * b1133 - 2.0 * a113 * a333) * per_16 / (12.0 * omega3_3) + a113_2 * over_21 / omega3_2
        - a123_2 * over_22 / (4.0 * omega3);
  }
  /// harmonic_re_v1_A_v32_conjA_v2 = -a123*a333/(3*omega3^2*(omega1 + omega2 - 2*omega3)*(omega1 - omega2 +
  /// 2*omega3)) + 2*a123*a223/(omega3*(omega1 + omega2 - 2*omega3)*(omega1 - omega2 + 2*omega3)*(2*omega2 -
  /// omega3)) + 2*a113*a123/((omega1 + omega2 - omega3)*(omega1 + omega2 - 2*omega3)*(omega1 - omega2 +
  /// omega3)*(omega1 - omega2 + 2*omega3))
  double lump_harmonic_re_v1_A_v32_conjA_v2() const {
    return -a123 * a333 * over_23 / (3.0 * omega3_2) + 2.0 * a123 * a223 * over_24 / omega3
        + 2.0 * a113 * a123 * over_25;
  }
  /// harmonic_re_v1_A_v2_A_v3_conjA_v3 = 2*a123*a333/(omega3^2*(omega1 + omega2)*(omega1 - omega2)) +
  /// 4*a123*a223/((omega1 + omega2)*(omega1 - omega2)*(2*omega2 + omega3)*(2*omega2 - omega3)) +
  /// (4*omega1^2*a113*a123 - 4*omega2^2*a113*a123 - 4*omega3^2*a113*a123)/((omega1 + omega2)*(omega1 + omega2 +
  /// omega3)*(omega1 + omega2 - omega3)*(omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3))
  double lump_harmonic_re_v1_A_v2_A_v3_conjA_v3() const {
    return 2.0 * a123 * a333 * over_26 / omega3_2 + 4.0 * a123 * a223 * over_6 + (4.0 * omega1_2 * a113 * a123
        - 4.0 * omega2_2 * a113 * a123 - 4.0 * omega3_2 * a113 * a123) * over_27;
  }
  /// harmonic_re_v1_A_v2_A_v32 = -a123*a333/(3*omega3^2*(omega1 + omega2 + 2*omega3)*(omega1 - omega2 - 2*omega3))
  /// - 2*a123*a223/(omega3*(omega1 + omega2 + 2*omega3)*(omega1 - omega2 - 2*omega3)*(2*omega2 + omega3)) +
  /// 2*a113*a123/((omega1 + omega2 + omega3)*(omega1 + omega2 + 2*omega3)*(omega1 - omega2 - omega3)*(omega1 -
  /// omega2 - 2*omega3))
  double lump_harmonic_re_v1_A_v2_A_v32() const {
    return -a123 * a333 * over_28 / (3.0 * omega3_2) - 2.0 * a123 * a223 * over_29 / omega3
        + 2.0 * a113 * a123 * over_30;
  }
  /// harmonic_re_v1_A_v1_A_v32 = (3*omega3^2*b1133 + 2*a113*a333)/(12*omega3^3*(omega1 + omega3)) +
  /// a113^2/(omega3^2*(omega1 + omega3)*(2*omega1 + omega3)) + a123^2/(4*omega3*(omega1 + omega2 + omega3)*(omega1
  /// - omega2 + omega3)*(omega1 + omega3))
  double lump_harmonic_re_v1_A_v1_A_v32() const {
    return (3.0 * omega3_2 * b1133 + 2.0 * a113 * a333) * per_15 / (12.0 * omega3_3) + a113_2 * over_31 / omega3_2
        + a123_2 * over_32 / (4.0 * omega3);
  }
  /// harmonic_re_v2_A_v32_conjA_v1 = a123*a333/(3*omega3^2*(omega1 + omega2 - 2*omega3)*(omega1 - omega2 -
  /// 2*omega3)) - 2*a113*a123/(omega3*(omega1 + omega2 - 2*omega3)*(omega1 - omega2 - 2*omega3)*(2*omega1 -
  /// omega3)) + 2*a123*a223/((omega1 + omega2 - omega3)*(omega1 + omega2 - 2*omega3)*(omega1 - omega2 -
  /// omega3)*(omega1 - omega2 - 2*omega3))
  double lump_harmonic_re_v2_A_v32_conjA_v1() const {
    return a123 * a333 * over_33 / (3.0 * omega3_2) - 2.0 * a113 * a123 * over_34 / omega3
        + 2.0 * a123 * a223 * over_35;
  }
  /// harmonic_re_v2_A_v32_conjA_v2 = (-3*omega3^2*b2233 - 2*a223*a333)/(12*omega3^3*(omega2 - omega3)) +
  /// a223^2/(omega3^2*(omega2 - omega3)*(2*omega2 - omega3)) + a123^2/(4*omega3*(omega1 + omega2 - omega3)*(omega1
  /// - omega2 + omega3)*(omega2 - omega3))
  double lump_harmonic_re_v2_A_v32_conjA_v2() const {
    return (-3.0 * omega3_2 * b2233 - 2.0 * a223 * a333) * per_13 / (12.0 * omega3_3) + a223_2 * over_36 / omega3_2
        + a123_2 * over_37 / (4.0 * omega3);
  }
  /// harmonic_re_v2_A_v2_A_v32 = (3*omega3^2*b2233 + 2*a223*a333)/(12*omega3^3*(omega2 + omega3)) +
  /// a223^2/(omega3^2*(omega2 + omega3)*(2*omega2 + omega3)) - a123^2/(4*omega3*(omega1 + omega2 + omega3)*(omega1
  /// - omega2 - omega3)*(omega2 + omega3))
  double lump_harmonic_re_v2_A_v2_A_v32() const {
    return (3.0 * omega3_2 * b2233 + 2.0 * a223 * a333) * per_12 / (12.0 * omega3_3) + a223_2 * over_38 / omega3_2
        - a123_2 * over_39 / (4.0 * omega3);
  }
  /// harmonic_re_v2_A_v1_A_v3_conjA_v3 = -2*a123*a333/(omega3^2*(omega1 + omega2)*(omega1 - omega2)) -
  /// 4*a113*a123/((omega1 + omega2)*(omega1 - omega2)*(2*omega1 + omega3)*(2*omega1 - omega3)) +
  /// (4*omega1^2*a123*a223 - 4*omega2^2*a123*a223 + 4*omega3^2*a123*a223)/((omega1 + omega2)*(omega1 + omega2 +
  /// omega3)*(omega1 + omega2 - omega3)*(omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3))
  double lump_harmonic_re_v2_A_v1_A_v3_conjA_v3() const {
    return -2.0 * a123 * a333 * over_26 / omega3_2 - 4.0 * a113 * a123 * over_40 + (4.0 * omega1_2 * a123 * a223
        - 4.0 * omega2_2 * a123 * a223 + 4.0 * omega3_2 * a123 * a223) * over_27;
  }
  /// harmonic_re_v2_A_v1_A_v32 = a123*a333/(3*omega3^2*(omega1 + omega2 + 2*omega3)*(omega1 - omega2 + 2*omega3))
  /// + 2*a113*a123/(omega3*(omega1 + omega2 + 2*omega3)*(omega1 - omega2 + 2*omega3)*(2*omega1 + omega3)) +
  /// 2*a123*a223/((omega1 + omega2 + omega3)*(omega1 + omega2 + 2*omega3)*(omega1 - omega2 + omega3)*(omega1 -
  /// omega2 + 2*omega3))
  double lump_harmonic_re_v2_A_v1_A_v32() const {
    return a123 * a333 * over_41 / (3.0 * omega3_2) + 2.0 * a113 * a123 * over_42 / omega3
        + 2.0 * a123 * a223 * over_43;
  }
  double lump_a333() const { return a333; }
  /// harmonic_re_v3_A_v3_conjA_v12 = b1133/(4*omega1*(omega1 - omega3)) - a113^2/(omega1*omega3*(omega1 -
  /// omega3)*(2*omega1 - omega3)) + a123^2/(4*omega1*(omega1 + omega2 - omega3)*(omega1 - omega2 - omega3)*(omega1
  /// - omega3)) + a113*a333/(2*omega1*(omega1 - omega3)*(2*omega1 + omega3)*(2*omega1 - omega3))
  double lump_harmonic_re_v3_A_v3_conjA_v12() const {
    return b1133 * per_16 / (4.0 * omega1) - a113_2 * over_21 / (omega1 * omega3)
        + a123_2 * over_22 / (4.0 * omega1) + a113 * a333 * over_44 / (2.0 * omega1);
  }
  /// harmonic_re_v3_A_v3_conjA_v1_conjA_v2 = -2*a113*a123/(omega3*(omega1 + omega2)*(omega1 + omega2 -
  /// 2*omega3)*(2*omega1 - omega3)) - 2*a123*a223/(omega3*(omega1 + omega2)*(omega1 + omega2 - 2*omega3)*(2*omega2
  /// - omega3)) + 2*a123*a333/((omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 - omega3)*(omega1 +
  /// omega2 - 2*omega3)) - 2*a113*a123/((omega1 + omega2)*(omega1 + omega2 - omega3)*(omega1 + omega2 -
  /// 2*omega3)*(omega1 - omega2 + omega3)) + 2*a123*a223/((omega1 + omega2)*(omega1 + omega2 - omega3)*(omega1 +
  /// omega2 - 2*omega3)*(omega1 - omega2 - omega3))
  double lump_harmonic_re_v3_A_v3_conjA_v1_conjA_v2() const {
    return -2.0 * a113 * a123 * over_45 / omega3 - 2.0 * a123 * a223 * over_46 / omega3
        + 2.0 * a123 * a333 * over_47 - 2.0 * a113 * a123 * over_48 + 2.0 * a123 * a223 * over_49;
  }
  /// harmonic_re_v3_A_v2_A_v3_conjA_v1 = -2*a113*a123/(omega3*(omega1 - omega2)*(omega1 - omega2 -
  /// 2*omega3)*(2*omega1 - omega3)) + 2*a123*a223/(omega3*(omega1 - omega2)*(omega1 - omega2 - 2*omega3)*(2*omega2
  /// + omega3)) - 2*a113*a123/((omega1 + omega2 + omega3)*(omega1 - omega2)*(omega1 - omega2 - omega3)*(omega1 -
  /// omega2 - 2*omega3)) + 2*a123*a223/((omega1 + omega2 - omega3)*(omega1 - omega2)*(omega1 - omega2 -
  /// omega3)*(omega1 - omega2 - 2*omega3)) + 2*a123*a333/((omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 -
  /// omega2 - omega3)*(omega1 - omega2 - 2*omega3))
  double lump_harmonic_re_v3_A_v2_A_v3_conjA_v1() const {
    return -2.0 * a113 * a123 * over_50 / omega3 + 2.0 * a123 * a223 * over_51 / omega3
        - 2.0 * a113 * a123 * over_52 + 2.0 * a123 * a223 * over_53 + 2.0 * a123 * a333 * over_54;
  }
  /// harmonic_re_v3_A_v22_conjA_v3 = b2233/(4*omega2*(omega2 - omega3)) - a223^2/(omega2*omega3*(omega2 -
  /// omega3)*(2*omega2 - omega3)) - a123^2/(4*omega2*(omega1 + omega2 - omega3)*(omega1 - omega2 + omega3)*(omega2
  /// - omega3)) + a223*a333/(2*omega2*(omega2 - omega3)*(2*omega2 + omega3)*(2*omega2 - omega3))
  double lump_harmonic_re_v3_A_v22_conjA_v3() const {
    return b2233 * per_13 / (4.0 * omega2) - a223_2 * over_36 / (omega2 * omega3)
        - a123_2 * over_37 / (4.0 * omega2) + a223 * a333 * over_55 / (2.0 * omega2);
  }
  /// harmonic_re_v3_A_v22_A_v3 = b2233/(4*omega2*(omega2 + omega3)) + a223^2/(omega2*omega3*(omega2 +
  /// omega3)*(2*omega2 + omega3)) - a123^2/(4*omega2*(omega1 + omega2 + omega3)*(omega1 - omega2 - omega3)*(omega2
  /// + omega3)) + a223*a333/(2*omega2*(omega2 + omega3)*(2*omega2 + omega3)*(2*omega2 - omega3))
  double lump_harmonic_re_v3_A_v22_A_v3() const {
    return b2233 * per_12 / (4.0 * omega2) + a223_2 * over_38 / (omega2 * omega3)
        - a123_2 * over_39 / (4.0 * omega2) + a223 * a333 * over_56 / (2.0 * omega2);
  }
  /// harmonic_re_v3_A_v1_A_v3_conjA_v2 = 2*a113*a123/(omega3*(omega1 - omega2)*(omega1 - omega2 +
  /// 2*omega3)*(2*omega1 + omega3)) - 2*a123*a223/(omega3*(omega1 - omega2)*(omega1 - omega2 + 2*omega3)*(2*omega2
  /// - omega3)) + 2*a123*a223/((omega1 + omega2 + omega3)*(omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 -
  /// omega2 + 2*omega3)) - 2*a113*a123/((omega1 + omega2 - omega3)*(omega1 - omega2)*(omega1 - omega2 +
  /// omega3)*(omega1 - omega2 + 2*omega3)) + 2*a123*a333/((omega1 - omega2)*(omega1 - omega2 + omega3)*(omega1 -
  /// omega2 + 2*omega3)*(omega1 - omega2 - omega3))
  double lump_harmonic_re_v3_A_v1_A_v3_conjA_v2() const {
    return 2.0 * a113 * a123 * over_57 / omega3 - 2.0 * a123 * a223 * over_58 / omega3 + 2.0 * a123 * a223 * over_59
        - 2.0 * a113 * a123 * over_60 + 2.0 * a123 * a333 * over_61;
  }
  /// harmonic_re_v3_A_v1_A_v2_A_v3 = 2*a113*a123/(omega3*(omega1 + omega2)*(omega1 + omega2 + 2*omega3)*(2*omega1
  /// + omega3)) + 2*a123*a223/(omega3*(omega1 + omega2)*(omega1 + omega2 + 2*omega3)*(2*omega2 + omega3)) +
  /// 2*a123*a333/((omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 + 2*omega3)*(omega1 + omega2 -
  /// omega3)) + 2*a123*a223/((omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 + 2*omega3)*(omega1 -
  /// omega2 + omega3)) - 2*a113*a123/((omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 +
  /// 2*omega3)*(omega1 - omega2 - omega3))
  double lump_harmonic_re_v3_A_v1_A_v2_A_v3() const {
    return 2.0 * a113 * a123 * over_62 / omega3 + 2.0 * a123 * a223 * over_63 / omega3 + 2.0 * a123 * a333 * over_64
        + 2.0 * a123 * a223 * over_65 - 2.0 * a113 * a123 * over_66;
  }
  /// harmonic_re_v3_A_v12_A_v3 = b1133/(4*omega1*(omega1 + omega3)) + a113^2/(omega1*omega3*(omega1 +
  /// omega3)*(2*omega1 + omega3)) + a123^2/(4*omega1*(omega1 + omega2 + omega3)*(omega1 - omega2 + omega3)*(omega1
  /// + omega3)) + a113*a333/(2*omega1*(omega1 + omega3)*(2*omega1 + omega3)*(2*omega1 - omega3))
  double lump_harmonic_re_v3_A_v12_A_v3() const {
    return b1133 * per_15 / (4.0 * omega1) + a113_2 * over_31 / (omega1 * omega3)
        + a123_2 * over_32 / (4.0 * omega1) + a113 * a333 * over_67 / (2.0 * omega1);
  }

  /// By their numbers in the tables.
  static constexpr double (Lumps::*list[])() const = {&Lumps::lump_mu1,
      &Lumps::lump_conservative_v1_A_v1_A_v2_conjA_v2, &Lumps::lump_conservative_v1_A_v12_conjA_v1,
      &Lumps::lump_conservative_v1_conjA_v2_F, &Lumps::lump_mu2, &Lumps::lump_conservative_v2_A_v22_conjA_v2,
      &Lumps::lump_e1, &Lumps::lump_harmonic_re_v1_A_v2_conjA_v12, &Lumps::lump_harmonic_re_v1_conjA_v1_F,
      &Lumps::lump_harmonic_re_v1_A_v22_conjA_v2, &Lumps::lump_harmonic_re_v1_A_v22_conjA_v1,
      &Lumps::lump_harmonic_re_v1_A_v1_A_v22, &Lumps::lump_harmonic_re_v1_A_v13, &Lumps::lump_e2,
      &Lumps::lump_harmonic_re_v2_A_v2_conjA_v12, &Lumps::lump_harmonic_re_v2_conjA_v2_F,
      &Lumps::lump_harmonic_re_v2_A_v23, &Lumps::lump_harmonic_re_v2_A_v12_A_v2, &Lumps::lump_a123,
      &Lumps::lump_a223, &Lumps::lump_a113, &Lumps::lump_e3, &Lumps::lump_harmonic_re_v3_conjA_v1_F,
      &Lumps::lump_harmonic_re_v3_conjA_v2_F, &Lumps::lump_conservative_v1_A_v1_A_v3_conjA_v3,
      &Lumps::lump_conservative_v2_A_v2_A_v3_conjA_v3, &Lumps::lump_mu3,
      &Lumps::lump_conservative_v3_A_v32_conjA_v3, &Lumps::lump_harmonic_re_v1_A_v32_conjA_v1,
      &Lumps::lump_harmonic_re_v1_A_v32_conjA_v2, &Lumps::lump_harmonic_re_v1_A_v2_A_v3_conjA_v3,
      &Lumps::lump_harmonic_re_v1_A_v2_A_v32, &Lumps::lump_harmonic_re_v1_A_v1_A_v32,
      &Lumps::lump_harmonic_re_v2_A_v32_conjA_v1, &Lumps::lump_harmonic_re_v2_A_v32_conjA_v2,
      &Lumps::lump_harmonic_re_v2_A_v2_A_v32, &Lumps::lump_harmonic_re_v2_A_v1_A_v3_conjA_v3,
      &Lumps::lump_harmonic_re_v2_A_v1_A_v32, &Lumps::lump_a333, &Lumps::lump_harmonic_re_v3_A_v3_conjA_v12,
      &Lumps::lump_harmonic_re_v3_A_v3_conjA_v1_conjA_v2, &Lumps::lump_harmonic_re_v3_A_v2_A_v3_conjA_v1,
      &Lumps::lump_harmonic_re_v3_A_v22_conjA_v3, &Lumps::lump_harmonic_re_v3_A_v22_A_v3,
      &Lumps::lump_harmonic_re_v3_A_v1_A_v3_conjA_v2, &Lumps::lump_harmonic_re_v3_A_v1_A_v2_A_v3,
      &Lumps::lump_harmonic_re_v3_A_v12_A_v3};
};

/// What rows are functions of: frequencies, and signals, which are amplitudes A, their conjugates, norms |A|^2
/// and moduli, and the excitation.
struct Model {
  static constexpr std::size_t modes = 3, excitations = 1;

  template <class Number>
  struct Frequencies {
    const Number omega1, omega2, omega3, Omega;
    Frequencies(const Number* natural, [[maybe_unused]] const Number* excitation) : omega1(natural[0]),
        omega2(natural[1]), omega3(natural[2]), Omega(excitation[0]) {}
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
    const Complex A_v3;
    const Complex conj_A_v3 = conjugate(A_v3);
    const Number norm_A_v3 = norm_of(A_v3);
    const Complex F;
    Signals(const Complex* amplitude, [[maybe_unused]] const Complex* forcing) : A_v1(amplitude[0]),
        A_v2(amplitude[1]), A_v3(amplitude[2]), F(forcing[0]) {}
  };
};

}  // namespace secular::generated::three_modes
