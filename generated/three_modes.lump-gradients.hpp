// Model three_modes: generated code, never edited by hand.
// Holds derivatives of the lumps by the parameters. Made by: secular generate three_modes.
#pragma once

#include "three_modes.hpp"

namespace secular::generated::three_modes {

/// gradient[p] = derivative of a lump by parameters[p], entries that are not zero. Of lumps with small divisors:
/// f_n are the fractions whose sum the lump is, q_d those of divisor d times its power and inverse, c_n what
/// multiplies a product of coefficients.
struct LumpGradients : Lumps {
  using Lumps::Lumps;

  void lump_mu1([[maybe_unused]] double* gradient) const { gradient[13] = 1.0; }
  void lump_conservative_v1_A_v1_A_v2_conjA_v2([[maybe_unused]] double* gradient) const {
    const double f_0 = b1122 / omega1;
    const double f_1 = -2.0 * a113 * a223 / (omega1 * omega3_2);
    const double f_2 = a123_2 * over_0 / (2.0 * omega1);
    const double f_3 = a123_2 * over_1 / (2.0 * omega1);
    const double q_0 = f_2 * per_0;
    const double q_1 = f_2 * per_1;
    const double q_2 = f_3 * per_2;
    const double q_3 = f_3 * per_3;
    gradient[0] = (-f_0 - f_1 - f_2 - f_3) / omega1 - q_0 - q_1 - q_2 - q_3;  // by omega1
    gradient[1] = -q_0 - q_1 + q_2 + q_3;  // by omega2
    gradient[2] = -2.0 * f_1 / omega3 - q_0 + q_1 - q_2 + q_3;  // by omega3
    const double c_0 = -2.0 / (omega1 * omega3_2);  // multiplies a113*a223
    const double c_1 = over_0 / (2.0 * omega1) + over_1 / (2.0 * omega1);  // multiplies a123^2
    const double c_2 = 1.0 / omega1;  // multiplies b1122
    gradient[3] = a223 * c_0;  // by a113
    gradient[4] = 2.0 * a123 * c_1;  // by a123
    gradient[5] = a113 * c_0;  // by a223
    gradient[8] = c_2;  // by b1122
  }
  void lump_conservative_v1_A_v12_conjA_v1([[maybe_unused]] double* gradient) const {
    const double f_0 = 3.0 * b1111 / (2.0 * omega1);
    const double f_1 = -8.0 * omega1 * a113_2 * over_2 / omega3_2;
    const double f_2 = 3.0 * a113_2 * over_2 / omega1;
    const double q_4 = (f_1 + f_2) * per_4;
    const double q_5 = (f_1 + f_2) * per_5;
    gradient[0] = (-f_0 + f_1 - f_2) / omega1 - 2.0 * q_4 - 2.0 * q_5;  // by omega1
    gradient[2] = -2.0 * f_1 / omega3 - q_4 + q_5;  // by omega3
    const double c_0 = (-8.0 * omega1_2 + 3.0 * omega3_2) * over_2 / (omega1 * omega3_2);  // multiplies a113^2
    const double c_1 = 3.0 / (2.0 * omega1);  // multiplies b1111
    gradient[3] = 2.0 * a113 * c_0;  // by a113
    gradient[7] = c_1;  // by b1111
  }
  void lump_conservative_v1_conjA_v2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -e12 / (4.0 * omega1);
    const double f_1 = -a123 * e3 * over_0 / (4.0 * omega1);
    const double q_0 = f_1 * per_0;
    const double q_1 = f_1 * per_1;
    gradient[0] = (-f_0 - f_1) / omega1 - q_0 - q_1;  // by omega1
    gradient[1] = -q_0 - q_1;  // by omega2
    gradient[2] = -q_0 + q_1;  // by omega3
    const double c_0 = -over_0 / (4.0 * omega1);  // multiplies a123*e3
    const double c_1 = -1.0 / (4.0 * omega1);  // multiplies e12
    gradient[4] = e3 * c_0;  // by a123
    gradient[12] = c_1;  // by e12
    gradient[18] = a123 * c_0;  // by e3
  }
  void lump_mu2([[maybe_unused]] double* gradient) const { gradient[15] = 1.0; }
  void lump_conservative_v2_A_v22_conjA_v2([[maybe_unused]] double* gradient) const {
    const double f_0 = 3.0 * b2222 / (2.0 * omega2);
    const double f_1 = -8.0 * omega2 * a223_2 * over_3 / omega3_2;
    const double f_2 = 3.0 * a223_2 * over_3 / omega2;
    const double q_6 = (f_1 + f_2) * per_6;
    const double q_7 = (f_1 + f_2) * per_7;
    gradient[1] = (-f_0 + f_1 - f_2) / omega2 - 2.0 * q_6 - 2.0 * q_7;  // by omega2
    gradient[2] = -2.0 * f_1 / omega3 - q_6 + q_7;  // by omega3
    const double c_0 = (-8.0 * omega2_2 + 3.0 * omega3_2) * over_3 / (omega2 * omega3_2);  // multiplies a223^2
    const double c_1 = 3.0 / (2.0 * omega2);  // multiplies b2222
    gradient[5] = 2.0 * a223 * c_0;  // by a223
    gradient[9] = c_1;  // by b2222
  }
  void lump_e1([[maybe_unused]] double* gradient) const { gradient[14] = 1.0; }
  void lump_harmonic_re_v1_A_v2_conjA_v12([[maybe_unused]] double* gradient) const {
    const double f_0 = 9.0 * omega1_2 * a113 * a123 * over_4;
    const double f_1 = -2.0 * omega1 * omega2 * a113 * a123 * over_4;
    const double f_2 = omega2_2 * a113 * a123 * over_4;
    const double f_3 = -3.0 * omega3_2 * a113 * a123 * over_4;
    const double q_2 = (f_0 + f_1 + f_2 + f_3) * per_2;
    const double q_3 = (f_0 + f_1 + f_2 + f_3) * per_3;
    const double q_4 = (f_0 + f_1 + f_2 + f_3) * per_4;
    const double q_5 = (f_0 + f_1 + f_2 + f_3) * per_5;
    const double q_8 = (f_0 + f_1 + f_2 + f_3) * per_8;
    const double q_9 = (f_0 + f_1 + f_2 + f_3) * per_9;
    gradient[0] = (2.0 * f_0 + f_1) / omega1 - q_2 - q_3 - 2.0 * q_4 - 2.0 * q_5 - q_8 - 3.0 * q_9;  // by omega1
    gradient[1] = (f_1 + 2.0 * f_2) / omega2 + q_2 + q_3 + q_8 + q_9;  // by omega2
    gradient[2] = 2.0 * f_3 / omega3 - q_2 + q_3 - q_4 + q_5;  // by omega3
    const double c_0 = (9.0 * omega1_2 - 2.0 * omega1 * omega2 + omega2_2 - 3.0 * omega3_2) * over_4;
    gradient[3] = a123 * c_0;  // by a113
    gradient[4] = a113 * c_0;  // by a123
  }
  void lump_harmonic_re_v1_conjA_v1_F([[maybe_unused]] double* gradient) const {
    const double f_0 = a113 * e3 * over_5;
    const double q_0 = f_0 * per_0;
    const double q_1 = f_0 * per_1;
    const double q_8 = f_0 * per_8;
    const double q_10 = f_0 * per_10;
    gradient[0] = -q_0 - q_1 - q_8 - q_10;  // by omega1
    gradient[1] = -q_0 - q_1 + q_8 - q_10;  // by omega2
    gradient[2] = -q_0 + q_1;  // by omega3
    const double c_0 = over_5;  // multiplies a113*e3
    gradient[3] = e3 * c_0;  // by a113
    gradient[18] = a113 * c_0;  // by e3
  }
  void lump_harmonic_re_v1_A_v22_conjA_v2([[maybe_unused]] double* gradient) const {
    const double f_0 = 8.0 * omega2_2 * a123 * a223 * over_6 / omega3_2;
    const double f_1 = -3.0 * a123 * a223 * over_6;
    const double q_6 = (f_0 + f_1) * per_6;
    const double q_7 = (f_0 + f_1) * per_7;
    const double q_8 = (f_0 + f_1) * per_8;
    const double q_10 = (f_0 + f_1) * per_10;
    gradient[0] = -q_8 - q_10;  // by omega1
    gradient[1] = 2.0 * f_0 / omega2 - 2.0 * q_6 - 2.0 * q_7 + q_8 - q_10;  // by omega2
    gradient[2] = -2.0 * f_0 / omega3 - q_6 + q_7;  // by omega3
    const double c_0 = (8.0 * omega2_2 - 3.0 * omega3_2) * over_6 / omega3_2;  // multiplies a123*a223
    gradient[4] = a223 * c_0;  // by a123
    gradient[5] = a123 * c_0;  // by a223
  }
  void lump_harmonic_re_v1_A_v22_conjA_v1([[maybe_unused]] double* gradient) const {
    const double f_0 = -b1122 * per_8 / (4.0 * omega2);
    const double f_1 = -a123_2 * over_7 / (4.0 * omega2);
    const double f_2 = -a113 * a223 * over_8 / (2.0 * omega2);
    const double q_2 = f_1 * per_2;
    const double q_3 = f_1 * per_3;
    const double q_6 = f_2 * per_6;
    const double q_7 = f_2 * per_7;
    const double q_8 = (f_0 + f_1 + f_2) * per_8;
    gradient[0] = -q_2 - q_3 - q_8;  // by omega1
    gradient[1] = (-f_0 - f_1 - f_2) / omega2 + q_2 + q_3 - 2.0 * q_6 - 2.0 * q_7 + q_8;  // by omega2
    gradient[2] = -q_2 + q_3 - q_6 + q_7;  // by omega3
    const double c_0 = -over_8 / (2.0 * omega2);  // multiplies a113*a223
    const double c_1 = -over_7 / (4.0 * omega2);  // multiplies a123^2
    const double c_2 = -per_8 / (4.0 * omega2);  // multiplies b1122
    gradient[3] = a223 * c_0;  // by a113
    gradient[4] = 2.0 * a123 * c_1;  // by a123
    gradient[5] = a113 * c_0;  // by a223
    gradient[8] = c_2;  // by b1122
  }
  void lump_harmonic_re_v1_A_v1_A_v22([[maybe_unused]] double* gradient) const {
    const double f_0 = b1122 * per_10 / (4.0 * omega2);
    const double f_1 = a123_2 * over_9 / (4.0 * omega2);
    const double f_2 = a113 * a223 * over_10 / (2.0 * omega2);
    const double q_0 = f_1 * per_0;
    const double q_1 = f_1 * per_1;
    const double q_6 = f_2 * per_6;
    const double q_7 = f_2 * per_7;
    const double q_10 = (f_0 + f_1 + f_2) * per_10;
    gradient[0] = -q_0 - q_1 - q_10;  // by omega1
    gradient[1] = (-f_0 - f_1 - f_2) / omega2 - q_0 - q_1 - 2.0 * q_6 - 2.0 * q_7 - q_10;  // by omega2
    gradient[2] = -q_0 + q_1 - q_6 + q_7;  // by omega3
    const double c_0 = over_10 / (2.0 * omega2);  // multiplies a113*a223
    const double c_1 = over_9 / (4.0 * omega2);  // multiplies a123^2
    const double c_2 = per_10 / (4.0 * omega2);  // multiplies b1122
    gradient[3] = a223 * c_0;  // by a113
    gradient[4] = 2.0 * a123 * c_1;  // by a123
    gradient[5] = a113 * c_0;  // by a223
    gradient[8] = c_2;  // by b1122
  }
  void lump_harmonic_re_v1_A_v13([[maybe_unused]] double* gradient) const {
    const double f_0 = b1111 / (8.0 * omega1_2);
    const double f_1 = a113_2 * over_2 / (4.0 * omega1_2);
    const double q_4 = f_1 * per_4;
    const double q_5 = f_1 * per_5;
    gradient[0] = (-2.0 * f_0 - 2.0 * f_1) / omega1 - 2.0 * q_4 - 2.0 * q_5;  // by omega1
    gradient[2] = -q_4 + q_5;  // by omega3
    const double c_0 = over_2 / (4.0 * omega1_2);  // multiplies a113^2
    const double c_1 = 1.0 / (8.0 * omega1_2);  // multiplies b1111
    gradient[3] = 2.0 * a113 * c_0;  // by a113
    gradient[7] = c_1;  // by b1111
  }
  void lump_e2([[maybe_unused]] double* gradient) const { gradient[16] = 1.0; }
  void lump_harmonic_re_v2_A_v2_conjA_v12([[maybe_unused]] double* gradient) const {
    const double f_0 = b1122 * per_8 / (4.0 * omega1);
    const double f_1 = a123_2 * over_7 / (4.0 * omega1);
    const double f_2 = a113 * a223 * over_11 / (2.0 * omega1);
    const double q_2 = f_1 * per_2;
    const double q_3 = f_1 * per_3;
    const double q_4 = f_2 * per_4;
    const double q_5 = f_2 * per_5;
    const double q_8 = (f_0 + f_1 + f_2) * per_8;
    gradient[0] = (-f_0 - f_1 - f_2) / omega1 - q_2 - q_3 - 2.0 * q_4 - 2.0 * q_5 - q_8;  // by omega1
    gradient[1] = q_2 + q_3 + q_8;  // by omega2
    gradient[2] = -q_2 + q_3 - q_4 + q_5;  // by omega3
    const double c_0 = over_11 / (2.0 * omega1);  // multiplies a113*a223
    const double c_1 = over_7 / (4.0 * omega1);  // multiplies a123^2
    const double c_2 = per_8 / (4.0 * omega1);  // multiplies b1122
    gradient[3] = a223 * c_0;  // by a113
    gradient[4] = 2.0 * a123 * c_1;  // by a123
    gradient[5] = a113 * c_0;  // by a223
    gradient[8] = c_2;  // by b1122
  }
  void lump_harmonic_re_v2_conjA_v2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -a223 * e3 * over_5;
    const double q_0 = f_0 * per_0;
    const double q_1 = f_0 * per_1;
    const double q_8 = f_0 * per_8;
    const double q_10 = f_0 * per_10;
    gradient[0] = -q_0 - q_1 - q_8 - q_10;  // by omega1
    gradient[1] = -q_0 - q_1 + q_8 - q_10;  // by omega2
    gradient[2] = -q_0 + q_1;  // by omega3
    const double c_0 = -over_5;  // multiplies a223*e3
    gradient[5] = e3 * c_0;  // by a223
    gradient[18] = a223 * c_0;  // by e3
  }
  void lump_harmonic_re_v2_A_v23([[maybe_unused]] double* gradient) const {
    const double f_0 = b2222 / (8.0 * omega2_2);
    const double f_1 = a223_2 * over_3 / (4.0 * omega2_2);
    const double q_6 = f_1 * per_6;
    const double q_7 = f_1 * per_7;
    gradient[1] = (-2.0 * f_0 - 2.0 * f_1) / omega2 - 2.0 * q_6 - 2.0 * q_7;  // by omega2
    gradient[2] = -q_6 + q_7;  // by omega3
    const double c_0 = over_3 / (4.0 * omega2_2);  // multiplies a223^2
    const double c_1 = 1.0 / (8.0 * omega2_2);  // multiplies b2222
    gradient[5] = 2.0 * a223 * c_0;  // by a223
    gradient[9] = c_1;  // by b2222
  }
  void lump_harmonic_re_v2_A_v12_A_v2([[maybe_unused]] double* gradient) const {
    const double f_0 = b1122 * per_10 / (4.0 * omega1);
    const double f_1 = a123_2 * over_9 / (4.0 * omega1);
    const double f_2 = a113 * a223 * over_12 / (2.0 * omega1);
    const double q_0 = f_1 * per_0;
    const double q_1 = f_1 * per_1;
    const double q_4 = f_2 * per_4;
    const double q_5 = f_2 * per_5;
    const double q_10 = (f_0 + f_1 + f_2) * per_10;
    gradient[0] = (-f_0 - f_1 - f_2) / omega1 - q_0 - q_1 - 2.0 * q_4 - 2.0 * q_5 - q_10;  // by omega1
    gradient[1] = -q_0 - q_1 - q_10;  // by omega2
    gradient[2] = -q_0 + q_1 - q_4 + q_5;  // by omega3
    const double c_0 = over_12 / (2.0 * omega1);  // multiplies a113*a223
    const double c_1 = over_9 / (4.0 * omega1);  // multiplies a123^2
    const double c_2 = per_10 / (4.0 * omega1);  // multiplies b1122
    gradient[3] = a223 * c_0;  // by a113
    gradient[4] = 2.0 * a123 * c_1;  // by a123
    gradient[5] = a113 * c_0;  // by a223
    gradient[8] = c_2;  // by b1122
  }
  void lump_a123([[maybe_unused]] double* gradient) const { gradient[4] = 1.0; }
  void lump_a223([[maybe_unused]] double* gradient) const { gradient[5] = 1.0; }
  void lump_a113([[maybe_unused]] double* gradient) const { gradient[3] = 1.0; }
  void lump_e3([[maybe_unused]] double* gradient) const { gradient[18] = 1.0; }
  void lump_harmonic_re_v3_conjA_v1_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -a123 * e2 * over_13 / (2.0 * omega1);
    const double f_1 = -a113 * e1 * over_14 / omega2;
    const double q_11 = f_0 * per_11;
    const double q_12 = (f_0 + f_1) * per_12;
    const double q_13 = (f_0 + f_1) * per_13;
    const double q_14 = f_1 * per_14;
    gradient[0] = -f_0 / omega1 - q_11 - 2.0 * q_14;  // by omega1
    gradient[1] = -f_1 / omega2 - 2.0 * q_11 - q_12 - q_13 - q_14;  // by omega2
    gradient[2] = -q_12 + q_13;  // by omega3
    const double c_0 = -over_14 / omega2;  // multiplies a113*e1
    const double c_1 = -over_13 / (2.0 * omega1);  // multiplies a123*e2
    gradient[3] = e1 * c_0;  // by a113
    gradient[4] = e2 * c_1;  // by a123
    gradient[14] = a113 * c_0;  // by e1
    gradient[16] = a123 * c_1;  // by e2
  }
  void lump_harmonic_re_v3_conjA_v2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -a223 * e2 * over_15 / omega1;
    const double f_1 = -a123 * e1 * over_16 / (2.0 * omega2);
    const double q_11 = f_0 * per_11;
    const double q_14 = f_1 * per_14;
    const double q_15 = (f_0 + f_1) * per_15;
    const double q_16 = (f_0 + f_1) * per_16;
    gradient[0] = -f_0 / omega1 - q_11 - 2.0 * q_14 - q_15 - q_16;  // by omega1
    gradient[1] = -f_1 / omega2 - 2.0 * q_11 - q_14;  // by omega2
    gradient[2] = -q_15 + q_16;  // by omega3
    const double c_0 = -over_16 / (2.0 * omega2);  // multiplies a123*e1
    const double c_1 = -over_15 / omega1;  // multiplies a223*e2
    gradient[4] = e1 * c_0;  // by a123
    gradient[5] = e2 * c_1;  // by a223
    gradient[14] = a123 * c_0;  // by e1
    gradient[16] = a223 * c_1;  // by e2
  }
  void lump_conservative_v1_A_v1_A_v3_conjA_v3([[maybe_unused]] double* gradient) const {
    const double f_0 = b1133 / omega1;
    const double f_1 = -2.0 * a113 * a333 / (omega1 * omega3_2);
    const double f_2 = a123_2 * over_17 / (2.0 * omega1);
    const double f_3 = a123_2 * over_18 / (2.0 * omega1);
    const double f_4 = -4.0 * a113_2 * over_2 / omega1;
    const double q_0 = f_2 * per_0;
    const double q_1 = f_3 * per_1;
    const double q_2 = f_2 * per_2;
    const double q_3 = f_3 * per_3;
    const double q_4 = f_4 * per_4;
    const double q_5 = f_4 * per_5;
    gradient[0] = (-f_0 - f_1 - f_2 - f_3 - f_4) / omega1 - q_0 - q_1 - q_2 - q_3 - 2.0 * q_4 - 2.0 * q_5;
    gradient[1] = -q_0 - q_1 + q_2 + q_3;  // by omega2
    gradient[2] = -2.0 * f_1 / omega3 - q_0 + q_1 - q_2 + q_3 - q_4 + q_5;  // by omega3
    const double c_0 = -4.0 * over_2 / omega1;  // multiplies a113^2
    const double c_1 = -2.0 / (omega1 * omega3_2);  // multiplies a113*a333
    const double c_2 = over_17 / (2.0 * omega1) + over_18 / (2.0 * omega1);  // multiplies a123^2
    const double c_3 = 1.0 / omega1;  // multiplies b1133
    gradient[3] = 2.0 * a113 * c_0 + a333 * c_1;  // by a113
    gradient[4] = 2.0 * a123 * c_2;  // by a123
    gradient[6] = a113 * c_1;  // by a333
    gradient[10] = c_3;  // by b1133
  }
  void lump_conservative_v2_A_v2_A_v3_conjA_v3([[maybe_unused]] double* gradient) const {
    const double f_0 = b2233 / omega2;
    const double f_1 = -2.0 * a223 * a333 / (omega2 * omega3_2);
    const double f_2 = -a123_2 * over_19 / (2.0 * omega2);
    const double f_3 = -a123_2 * over_20 / (2.0 * omega2);
    const double f_4 = -4.0 * a223_2 * over_3 / omega2;
    const double q_0 = f_2 * per_0;
    const double q_1 = f_3 * per_1;
    const double q_2 = f_3 * per_2;
    const double q_3 = f_2 * per_3;
    const double q_6 = f_4 * per_6;
    const double q_7 = f_4 * per_7;
    gradient[0] = -q_0 - q_1 - q_2 - q_3;  // by omega1
    gradient[1] = (-f_0 - f_1 - f_2 - f_3 - f_4) / omega2 - q_0 - q_1 + q_2 + q_3 - 2.0 * q_6 - 2.0 * q_7;
    gradient[2] = -2.0 * f_1 / omega3 - q_0 + q_1 - q_2 + q_3 - q_6 + q_7;  // by omega3
    const double c_0 = -over_19 / (2.0 * omega2) - over_20 / (2.0 * omega2);  // multiplies a123^2
    const double c_1 = -4.0 * over_3 / omega2;  // multiplies a223^2
    const double c_2 = -2.0 / (omega2 * omega3_2);  // multiplies a223*a333
    const double c_3 = 1.0 / omega2;  // multiplies b2233
    gradient[4] = 2.0 * a123 * c_0;  // by a123
    gradient[5] = 2.0 * a223 * c_1 + a333 * c_2;  // by a223
    gradient[6] = a223 * c_2;  // by a333
    gradient[11] = c_3;  // by b2233
  }
  void lump_mu3([[maybe_unused]] double* gradient) const { gradient[17] = 1.0; }
  void lump_conservative_v3_A_v32_conjA_v3([[maybe_unused]] double* gradient) const {
    gradient[2] = 5.0 * a333_2 / omega3_4;  // by omega3
    gradient[6] = -10.0 * a333 / (3.0 * omega3_3);  // by a333
  }
  void lump_harmonic_re_v1_A_v32_conjA_v1([[maybe_unused]] double* gradient) const {
    const double f_0 = -b1133 * per_16 / (4.0 * omega3);
    const double f_1 = -a113 * a333 * per_16 / (6.0 * omega3_3);
    const double f_2 = a113_2 * over_21 / omega3_2;
    const double f_3 = -a123_2 * over_22 / (4.0 * omega3);
    const double q_1 = f_3 * per_1;
    const double q_3 = f_3 * per_3;
    const double q_5 = f_2 * per_5;
    const double q_16 = (f_0 + f_1 + f_2 + f_3) * per_16;
    gradient[0] = -q_1 - q_3 - 2.0 * q_5 - q_16;  // by omega1
    gradient[1] = -q_1 + q_3;  // by omega2
    gradient[2] = (-f_0 - 3.0 * f_1 - 2.0 * f_2 - f_3) / omega3 + q_1 + q_3 + q_5 + q_16;  // by omega3
    const double c_0 = over_21 / omega3_2;  // multiplies a113^2
    const double c_1 = -per_16 / (6.0 * omega3_3);  // multiplies a113*a333
    const double c_2 = -over_22 / (4.0 * omega3);  // multiplies a123^2
    const double c_3 = -per_16 / (4.0 * omega3);  // multiplies b1133
    gradient[3] = 2.0 * a113 * c_0 + a333 * c_1;  // by a113
    gradient[4] = 2.0 * a123 * c_2;  // by a123
    gradient[6] = a113 * c_1;  // by a333
    gradient[10] = c_3;  // by b1133
  }
  void lump_harmonic_re_v1_A_v32_conjA_v2([[maybe_unused]] double* gradient) const {
    const double f_0 = -a123 * a333 * over_23 / (3.0 * omega3_2);
    const double f_1 = 2.0 * a123 * a223 * over_24 / omega3;
    const double f_2 = 2.0 * a113 * a123 * over_25;
    const double q_1 = f_2 * per_1;
    const double q_2 = f_2 * per_2;
    const double q_7 = f_1 * per_7;
    const double q_17 = (f_0 + f_1 + f_2) * per_17;
    const double q_18 = (f_0 + f_1 + f_2) * per_18;
    gradient[0] = -q_1 - q_2 - q_17 - q_18;  // by omega1
    gradient[1] = -q_1 + q_2 - 2.0 * q_7 - q_17 + q_18;  // by omega2
    gradient[2] = (-2.0 * f_0 - f_1) / omega3 + q_1 - q_2 + q_7 + 2.0 * q_17 - 2.0 * q_18;  // by omega3
    const double c_0 = 2.0 * over_25;  // multiplies a113*a123
    const double c_1 = 2.0 * over_24 / omega3;  // multiplies a123*a223
    const double c_2 = -over_23 / (3.0 * omega3_2);  // multiplies a123*a333
    gradient[3] = a123 * c_0;  // by a113
    gradient[4] = a113 * c_0 + a223 * c_1 + a333 * c_2;  // by a123
    gradient[5] = a123 * c_1;  // by a223
    gradient[6] = a123 * c_2;  // by a333
  }
  void lump_harmonic_re_v1_A_v2_A_v3_conjA_v3([[maybe_unused]] double* gradient) const {
    const double f_0 = 2.0 * a123 * a333 * over_26 / omega3_2;
    const double f_1 = 4.0 * a123 * a223 * over_6;
    const double f_2 = 4.0 * omega1_2 * a113 * a123 * over_27;
    const double f_3 = -4.0 * omega2_2 * a113 * a123 * over_27;
    const double f_4 = -4.0 * omega3_2 * a113 * a123 * over_27;
    const double q_0 = (f_2 + f_3 + f_4) * per_0;
    const double q_1 = (f_2 + f_3 + f_4) * per_1;
    const double q_2 = (f_2 + f_3 + f_4) * per_2;
    const double q_3 = (f_2 + f_3 + f_4) * per_3;
    const double q_6 = f_1 * per_6;
    const double q_7 = f_1 * per_7;
    const double q_8 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_8;
    const double q_10 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_10;
    gradient[0] = 2.0 * f_2 / omega1 - q_0 - q_1 - q_2 - q_3 - q_8 - q_10;  // by omega1
    gradient[1] = 2.0 * f_3 / omega2 - q_0 - q_1 + q_2 + q_3 - 2.0 * q_6 - 2.0 * q_7 + q_8 - q_10;  // by omega2
    gradient[2] = (-2.0 * f_0 + 2.0 * f_4) / omega3 - q_0 + q_1 - q_2 + q_3 - q_6 + q_7;  // by omega3
    const double c_0 = (4.0 * omega1_2 - 4.0 * omega2_2 - 4.0 * omega3_2) * over_27;  // multiplies a113*a123
    const double c_1 = 4.0 * over_6;  // multiplies a123*a223
    const double c_2 = 2.0 * over_26 / omega3_2;  // multiplies a123*a333
    gradient[3] = a123 * c_0;  // by a113
    gradient[4] = a113 * c_0 + a223 * c_1 + a333 * c_2;  // by a123
    gradient[5] = a123 * c_1;  // by a223
    gradient[6] = a123 * c_2;  // by a333
  }
  void lump_harmonic_re_v1_A_v2_A_v32([[maybe_unused]] double* gradient) const {
    const double f_0 = -a123 * a333 * over_28 / (3.0 * omega3_2);
    const double f_1 = -2.0 * a123 * a223 * over_29 / omega3;
    const double f_2 = 2.0 * a113 * a123 * over_30;
    const double q_0 = f_2 * per_0;
    const double q_3 = f_2 * per_3;
    const double q_6 = f_1 * per_6;
    const double q_19 = (f_0 + f_1 + f_2) * per_19;
    const double q_20 = (f_0 + f_1 + f_2) * per_20;
    gradient[0] = -q_0 - q_3 - q_19 - q_20;  // by omega1
    gradient[1] = -q_0 + q_3 - 2.0 * q_6 - q_19 + q_20;  // by omega2
    gradient[2] = (-2.0 * f_0 - f_1) / omega3 - q_0 + q_3 - q_6 - 2.0 * q_19 + 2.0 * q_20;  // by omega3
    const double c_0 = 2.0 * over_30;  // multiplies a113*a123
    const double c_1 = -2.0 * over_29 / omega3;  // multiplies a123*a223
    const double c_2 = -over_28 / (3.0 * omega3_2);  // multiplies a123*a333
    gradient[3] = a123 * c_0;  // by a113
    gradient[4] = a113 * c_0 + a223 * c_1 + a333 * c_2;  // by a123
    gradient[5] = a123 * c_1;  // by a223
    gradient[6] = a123 * c_2;  // by a333
  }
  void lump_harmonic_re_v1_A_v1_A_v32([[maybe_unused]] double* gradient) const {
    const double f_0 = b1133 * per_15 / (4.0 * omega3);
    const double f_1 = a113 * a333 * per_15 / (6.0 * omega3_3);
    const double f_2 = a113_2 * over_31 / omega3_2;
    const double f_3 = a123_2 * over_32 / (4.0 * omega3);
    const double q_0 = f_3 * per_0;
    const double q_2 = f_3 * per_2;
    const double q_4 = f_2 * per_4;
    const double q_15 = (f_0 + f_1 + f_2 + f_3) * per_15;
    gradient[0] = -q_0 - q_2 - 2.0 * q_4 - q_15;  // by omega1
    gradient[1] = -q_0 + q_2;  // by omega2
    gradient[2] = (-f_0 - 3.0 * f_1 - 2.0 * f_2 - f_3) / omega3 - q_0 - q_2 - q_4 - q_15;  // by omega3
    const double c_0 = over_31 / omega3_2;  // multiplies a113^2
    const double c_1 = per_15 / (6.0 * omega3_3);  // multiplies a113*a333
    const double c_2 = over_32 / (4.0 * omega3);  // multiplies a123^2
    const double c_3 = per_15 / (4.0 * omega3);  // multiplies b1133
    gradient[3] = 2.0 * a113 * c_0 + a333 * c_1;  // by a113
    gradient[4] = 2.0 * a123 * c_2;  // by a123
    gradient[6] = a113 * c_1;  // by a333
    gradient[10] = c_3;  // by b1133
  }
  void lump_harmonic_re_v2_A_v32_conjA_v1([[maybe_unused]] double* gradient) const {
    const double f_0 = a123 * a333 * over_33 / (3.0 * omega3_2);
    const double f_1 = -2.0 * a113 * a123 * over_34 / omega3;
    const double f_2 = 2.0 * a123 * a223 * over_35;
    const double q_1 = f_2 * per_1;
    const double q_3 = f_2 * per_3;
    const double q_5 = f_1 * per_5;
    const double q_17 = (f_0 + f_1 + f_2) * per_17;
    const double q_20 = (f_0 + f_1 + f_2) * per_20;
    gradient[0] = -q_1 - q_3 - 2.0 * q_5 - q_17 - q_20;  // by omega1
    gradient[1] = -q_1 + q_3 - q_17 + q_20;  // by omega2
    gradient[2] = (-2.0 * f_0 - f_1) / omega3 + q_1 + q_3 + q_5 + 2.0 * q_17 + 2.0 * q_20;  // by omega3
    const double c_0 = -2.0 * over_34 / omega3;  // multiplies a113*a123
    const double c_1 = 2.0 * over_35;  // multiplies a123*a223
    const double c_2 = over_33 / (3.0 * omega3_2);  // multiplies a123*a333
    gradient[3] = a123 * c_0;  // by a113
    gradient[4] = a113 * c_0 + a223 * c_1 + a333 * c_2;  // by a123
    gradient[5] = a123 * c_1;  // by a223
    gradient[6] = a123 * c_2;  // by a333
  }
  void lump_harmonic_re_v2_A_v32_conjA_v2([[maybe_unused]] double* gradient) const {
    const double f_0 = -b2233 * per_13 / (4.0 * omega3);
    const double f_1 = -a223 * a333 * per_13 / (6.0 * omega3_3);
    const double f_2 = a223_2 * over_36 / omega3_2;
    const double f_3 = a123_2 * over_37 / (4.0 * omega3);
    const double q_1 = f_3 * per_1;
    const double q_2 = f_3 * per_2;
    const double q_7 = f_2 * per_7;
    const double q_13 = (f_0 + f_1 + f_2 + f_3) * per_13;
    gradient[0] = -q_1 - q_2;  // by omega1
    gradient[1] = -q_1 + q_2 - 2.0 * q_7 - q_13;  // by omega2
    gradient[2] = (-f_0 - 3.0 * f_1 - 2.0 * f_2 - f_3) / omega3 + q_1 - q_2 + q_7 + q_13;  // by omega3
    const double c_0 = over_37 / (4.0 * omega3);  // multiplies a123^2
    const double c_1 = over_36 / omega3_2;  // multiplies a223^2
    const double c_2 = -per_13 / (6.0 * omega3_3);  // multiplies a223*a333
    const double c_3 = -per_13 / (4.0 * omega3);  // multiplies b2233
    gradient[4] = 2.0 * a123 * c_0;  // by a123
    gradient[5] = 2.0 * a223 * c_1 + a333 * c_2;  // by a223
    gradient[6] = a223 * c_2;  // by a333
    gradient[11] = c_3;  // by b2233
  }
  void lump_harmonic_re_v2_A_v2_A_v32([[maybe_unused]] double* gradient) const {
    const double f_0 = b2233 * per_12 / (4.0 * omega3);
    const double f_1 = a223 * a333 * per_12 / (6.0 * omega3_3);
    const double f_2 = a223_2 * over_38 / omega3_2;
    const double f_3 = -a123_2 * over_39 / (4.0 * omega3);
    const double q_0 = f_3 * per_0;
    const double q_3 = f_3 * per_3;
    const double q_6 = f_2 * per_6;
    const double q_12 = (f_0 + f_1 + f_2 + f_3) * per_12;
    gradient[0] = -q_0 - q_3;  // by omega1
    gradient[1] = -q_0 + q_3 - 2.0 * q_6 - q_12;  // by omega2
    gradient[2] = (-f_0 - 3.0 * f_1 - 2.0 * f_2 - f_3) / omega3 - q_0 + q_3 - q_6 - q_12;  // by omega3
    const double c_0 = -over_39 / (4.0 * omega3);  // multiplies a123^2
    const double c_1 = over_38 / omega3_2;  // multiplies a223^2
    const double c_2 = per_12 / (6.0 * omega3_3);  // multiplies a223*a333
    const double c_3 = per_12 / (4.0 * omega3);  // multiplies b2233
    gradient[4] = 2.0 * a123 * c_0;  // by a123
    gradient[5] = 2.0 * a223 * c_1 + a333 * c_2;  // by a223
    gradient[6] = a223 * c_2;  // by a333
    gradient[11] = c_3;  // by b2233
  }
  void lump_harmonic_re_v2_A_v1_A_v3_conjA_v3([[maybe_unused]] double* gradient) const {
    const double f_0 = -2.0 * a123 * a333 * over_26 / omega3_2;
    const double f_1 = -4.0 * a113 * a123 * over_40;
    const double f_2 = 4.0 * omega1_2 * a123 * a223 * over_27;
    const double f_3 = -4.0 * omega2_2 * a123 * a223 * over_27;
    const double f_4 = 4.0 * omega3_2 * a123 * a223 * over_27;
    const double q_0 = (f_2 + f_3 + f_4) * per_0;
    const double q_1 = (f_2 + f_3 + f_4) * per_1;
    const double q_2 = (f_2 + f_3 + f_4) * per_2;
    const double q_3 = (f_2 + f_3 + f_4) * per_3;
    const double q_4 = f_1 * per_4;
    const double q_5 = f_1 * per_5;
    const double q_8 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_8;
    const double q_10 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_10;
    gradient[0] = 2.0 * f_2 / omega1 - q_0 - q_1 - q_2 - q_3 - 2.0 * q_4 - 2.0 * q_5 - q_8 - q_10;  // by omega1
    gradient[1] = 2.0 * f_3 / omega2 - q_0 - q_1 + q_2 + q_3 + q_8 - q_10;  // by omega2
    gradient[2] = (-2.0 * f_0 + 2.0 * f_4) / omega3 - q_0 + q_1 - q_2 + q_3 - q_4 + q_5;  // by omega3
    const double c_0 = -4.0 * over_40;  // multiplies a113*a123
    const double c_1 = (4.0 * omega1_2 - 4.0 * omega2_2 + 4.0 * omega3_2) * over_27;  // multiplies a123*a223
    const double c_2 = -2.0 * over_26 / omega3_2;  // multiplies a123*a333
    gradient[3] = a123 * c_0;  // by a113
    gradient[4] = a113 * c_0 + a223 * c_1 + a333 * c_2;  // by a123
    gradient[5] = a123 * c_1;  // by a223
    gradient[6] = a123 * c_2;  // by a333
  }
  void lump_harmonic_re_v2_A_v1_A_v32([[maybe_unused]] double* gradient) const {
    const double f_0 = a123 * a333 * over_41 / (3.0 * omega3_2);
    const double f_1 = 2.0 * a113 * a123 * over_42 / omega3;
    const double f_2 = 2.0 * a123 * a223 * over_43;
    const double q_0 = f_2 * per_0;
    const double q_2 = f_2 * per_2;
    const double q_4 = f_1 * per_4;
    const double q_18 = (f_0 + f_1 + f_2) * per_18;
    const double q_19 = (f_0 + f_1 + f_2) * per_19;
    gradient[0] = -q_0 - q_2 - 2.0 * q_4 - q_18 - q_19;  // by omega1
    gradient[1] = -q_0 + q_2 + q_18 - q_19;  // by omega2
    gradient[2] = (-2.0 * f_0 - f_1) / omega3 - q_0 - q_2 - q_4 - 2.0 * q_18 - 2.0 * q_19;  // by omega3
    const double c_0 = 2.0 * over_42 / omega3;  // multiplies a113*a123
    const double c_1 = 2.0 * over_43;  // multiplies a123*a223
    const double c_2 = over_41 / (3.0 * omega3_2);  // multiplies a123*a333
    gradient[3] = a123 * c_0;  // by a113
    gradient[4] = a113 * c_0 + a223 * c_1 + a333 * c_2;  // by a123
    gradient[5] = a123 * c_1;  // by a223
    gradient[6] = a123 * c_2;  // by a333
  }
  void lump_a333([[maybe_unused]] double* gradient) const { gradient[6] = 1.0; }
  void lump_harmonic_re_v3_A_v3_conjA_v12([[maybe_unused]] double* gradient) const {
    const double f_0 = b1133 * per_16 / (4.0 * omega1);
    const double f_1 = -a113_2 * over_21 / (omega1 * omega3);
    const double f_2 = a123_2 * over_22 / (4.0 * omega1);
    const double f_3 = a113 * a333 * over_44 / (2.0 * omega1);
    const double q_1 = f_2 * per_1;
    const double q_3 = f_2 * per_3;
    const double q_4 = f_3 * per_4;
    const double q_5 = (f_1 + f_3) * per_5;
    const double q_16 = (f_0 + f_1 + f_2 + f_3) * per_16;
    gradient[0] = (-f_0 - f_1 - f_2 - f_3) / omega1 - q_1 - q_3 - 2.0 * q_4 - 2.0 * q_5 - q_16;  // by omega1
    gradient[1] = -q_1 + q_3;  // by omega2
    gradient[2] = -f_1 / omega3 + q_1 + q_3 - q_4 + q_5 + q_16;  // by omega3
    const double c_0 = -over_21 / (omega1 * omega3);  // multiplies a113^2
    const double c_1 = over_44 / (2.0 * omega1);  // multiplies a113*a333
    const double c_2 = over_22 / (4.0 * omega1);  // multiplies a123^2
    const double c_3 = per_16 / (4.0 * omega1);  // multiplies b1133
    gradient[3] = 2.0 * a113 * c_0 + a333 * c_1;  // by a113
    gradient[4] = 2.0 * a123 * c_2;  // by a123
    gradient[6] = a113 * c_1;  // by a333
    gradient[10] = c_3;  // by b1133
  }
  void lump_harmonic_re_v3_A_v3_conjA_v1_conjA_v2([[maybe_unused]] double* gradient) const {
    const double f_0 = -2.0 * a113 * a123 * over_45 / omega3;
    const double f_1 = -2.0 * a123 * a223 * over_46 / omega3;
    const double f_2 = 2.0 * a123 * a333 * over_47;
    const double f_3 = -2.0 * a113 * a123 * over_48;
    const double f_4 = 2.0 * a123 * a223 * over_49;
    const double q_0 = f_2 * per_0;
    const double q_1 = (f_2 + f_3 + f_4) * per_1;
    const double q_2 = f_3 * per_2;
    const double q_3 = f_4 * per_3;
    const double q_5 = f_0 * per_5;
    const double q_7 = f_1 * per_7;
    const double q_10 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_10;
    const double q_17 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_17;
    gradient[0] = -q_0 - q_1 - q_2 - q_3 - 2.0 * q_5 - q_10 - q_17;  // by omega1
    gradient[1] = -q_0 - q_1 + q_2 + q_3 - 2.0 * q_7 - q_10 - q_17;  // by omega2
    gradient[2] = (-f_0 - f_1) / omega3 - q_0 + q_1 - q_2 + q_3 + q_5 + q_7 + 2.0 * q_17;  // by omega3
    const double c_0 = -2.0 * over_45 / omega3 - 2.0 * over_48;  // multiplies a113*a123
    const double c_1 = -2.0 * over_46 / omega3 + 2.0 * over_49;  // multiplies a123*a223
    const double c_2 = 2.0 * over_47;  // multiplies a123*a333
    gradient[3] = a123 * c_0;  // by a113
    gradient[4] = a113 * c_0 + a223 * c_1 + a333 * c_2;  // by a123
    gradient[5] = a123 * c_1;  // by a223
    gradient[6] = a123 * c_2;  // by a333
  }
  void lump_harmonic_re_v3_A_v2_A_v3_conjA_v1([[maybe_unused]] double* gradient) const {
    const double f_0 = -2.0 * a113 * a123 * over_50 / omega3;
    const double f_1 = 2.0 * a123 * a223 * over_51 / omega3;
    const double f_2 = -2.0 * a113 * a123 * over_52;
    const double f_3 = 2.0 * a123 * a223 * over_53;
    const double f_4 = 2.0 * a123 * a333 * over_54;
    const double q_0 = f_2 * per_0;
    const double q_1 = f_3 * per_1;
    const double q_2 = f_4 * per_2;
    const double q_3 = (f_2 + f_3 + f_4) * per_3;
    const double q_5 = f_0 * per_5;
    const double q_6 = f_1 * per_6;
    const double q_8 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_8;
    const double q_20 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_20;
    gradient[0] = -q_0 - q_1 - q_2 - q_3 - 2.0 * q_5 - q_8 - q_20;  // by omega1
    gradient[1] = -q_0 - q_1 + q_2 + q_3 - 2.0 * q_6 + q_8 + q_20;  // by omega2
    gradient[2] = (-f_0 - f_1) / omega3 - q_0 + q_1 - q_2 + q_3 + q_5 - q_6 + 2.0 * q_20;  // by omega3
    const double c_0 = -2.0 * over_50 / omega3 - 2.0 * over_52;  // multiplies a113*a123
    const double c_1 = 2.0 * over_51 / omega3 + 2.0 * over_53;  // multiplies a123*a223
    const double c_2 = 2.0 * over_54;  // multiplies a123*a333
    gradient[3] = a123 * c_0;  // by a113
    gradient[4] = a113 * c_0 + a223 * c_1 + a333 * c_2;  // by a123
    gradient[5] = a123 * c_1;  // by a223
    gradient[6] = a123 * c_2;  // by a333
  }
  void lump_harmonic_re_v3_A_v22_conjA_v3([[maybe_unused]] double* gradient) const {
    const double f_0 = b2233 * per_13 / (4.0 * omega2);
    const double f_1 = -a223_2 * over_36 / (omega2 * omega3);
    const double f_2 = -a123_2 * over_37 / (4.0 * omega2);
    const double f_3 = a223 * a333 * over_55 / (2.0 * omega2);
    const double q_1 = f_2 * per_1;
    const double q_2 = f_2 * per_2;
    const double q_6 = f_3 * per_6;
    const double q_7 = (f_1 + f_3) * per_7;
    const double q_13 = (f_0 + f_1 + f_2 + f_3) * per_13;
    gradient[0] = -q_1 - q_2;  // by omega1
    gradient[1] = (-f_0 - f_1 - f_2 - f_3) / omega2 - q_1 + q_2 - 2.0 * q_6 - 2.0 * q_7 - q_13;  // by omega2
    gradient[2] = -f_1 / omega3 + q_1 - q_2 - q_6 + q_7 + q_13;  // by omega3
    const double c_0 = -over_37 / (4.0 * omega2);  // multiplies a123^2
    const double c_1 = -over_36 / (omega2 * omega3);  // multiplies a223^2
    const double c_2 = over_55 / (2.0 * omega2);  // multiplies a223*a333
    const double c_3 = per_13 / (4.0 * omega2);  // multiplies b2233
    gradient[4] = 2.0 * a123 * c_0;  // by a123
    gradient[5] = 2.0 * a223 * c_1 + a333 * c_2;  // by a223
    gradient[6] = a223 * c_2;  // by a333
    gradient[11] = c_3;  // by b2233
  }
  void lump_harmonic_re_v3_A_v22_A_v3([[maybe_unused]] double* gradient) const {
    const double f_0 = b2233 * per_12 / (4.0 * omega2);
    const double f_1 = a223_2 * over_38 / (omega2 * omega3);
    const double f_2 = -a123_2 * over_39 / (4.0 * omega2);
    const double f_3 = a223 * a333 * over_56 / (2.0 * omega2);
    const double q_0 = f_2 * per_0;
    const double q_3 = f_2 * per_3;
    const double q_6 = (f_1 + f_3) * per_6;
    const double q_7 = f_3 * per_7;
    const double q_12 = (f_0 + f_1 + f_2 + f_3) * per_12;
    gradient[0] = -q_0 - q_3;  // by omega1
    gradient[1] = (-f_0 - f_1 - f_2 - f_3) / omega2 - q_0 + q_3 - 2.0 * q_6 - 2.0 * q_7 - q_12;  // by omega2
    gradient[2] = -f_1 / omega3 - q_0 + q_3 - q_6 + q_7 - q_12;  // by omega3
    const double c_0 = -over_39 / (4.0 * omega2);  // multiplies a123^2
    const double c_1 = over_38 / (omega2 * omega3);  // multiplies a223^2
    const double c_2 = over_56 / (2.0 * omega2);  // multiplies a223*a333
    const double c_3 = per_12 / (4.0 * omega2);  // multiplies b2233
    gradient[4] = 2.0 * a123 * c_0;  // by a123
    gradient[5] = 2.0 * a223 * c_1 + a333 * c_2;  // by a223
    gradient[6] = a223 * c_2;  // by a333
    gradient[11] = c_3;  // by b2233
  }
  void lump_harmonic_re_v3_A_v1_A_v3_conjA_v2([[maybe_unused]] double* gradient) const {
    const double f_0 = 2.0 * a113 * a123 * over_57 / omega3;
    const double f_1 = -2.0 * a123 * a223 * over_58 / omega3;
    const double f_2 = 2.0 * a123 * a223 * over_59;
    const double f_3 = -2.0 * a113 * a123 * over_60;
    const double f_4 = 2.0 * a123 * a333 * over_61;
    const double q_0 = f_2 * per_0;
    const double q_1 = f_3 * per_1;
    const double q_2 = (f_2 + f_3 + f_4) * per_2;
    const double q_3 = f_4 * per_3;
    const double q_4 = f_0 * per_4;
    const double q_7 = f_1 * per_7;
    const double q_8 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_8;
    const double q_18 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_18;
    gradient[0] = -q_0 - q_1 - q_2 - q_3 - 2.0 * q_4 - q_8 - q_18;  // by omega1
    gradient[1] = -q_0 - q_1 + q_2 + q_3 - 2.0 * q_7 + q_8 + q_18;  // by omega2
    gradient[2] = (-f_0 - f_1) / omega3 - q_0 + q_1 - q_2 + q_3 - q_4 + q_7 - 2.0 * q_18;  // by omega3
    const double c_0 = 2.0 * over_57 / omega3 - 2.0 * over_60;  // multiplies a113*a123
    const double c_1 = -2.0 * over_58 / omega3 + 2.0 * over_59;  // multiplies a123*a223
    const double c_2 = 2.0 * over_61;  // multiplies a123*a333
    gradient[3] = a123 * c_0;  // by a113
    gradient[4] = a113 * c_0 + a223 * c_1 + a333 * c_2;  // by a123
    gradient[5] = a123 * c_1;  // by a223
    gradient[6] = a123 * c_2;  // by a333
  }
  void lump_harmonic_re_v3_A_v1_A_v2_A_v3([[maybe_unused]] double* gradient) const {
    const double f_0 = 2.0 * a113 * a123 * over_62 / omega3;
    const double f_1 = 2.0 * a123 * a223 * over_63 / omega3;
    const double f_2 = 2.0 * a123 * a333 * over_64;
    const double f_3 = 2.0 * a123 * a223 * over_65;
    const double f_4 = -2.0 * a113 * a123 * over_66;
    const double q_0 = (f_2 + f_3 + f_4) * per_0;
    const double q_1 = f_2 * per_1;
    const double q_2 = f_3 * per_2;
    const double q_3 = f_4 * per_3;
    const double q_4 = f_0 * per_4;
    const double q_6 = f_1 * per_6;
    const double q_10 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_10;
    const double q_19 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_19;
    gradient[0] = -q_0 - q_1 - q_2 - q_3 - 2.0 * q_4 - q_10 - q_19;  // by omega1
    gradient[1] = -q_0 - q_1 + q_2 + q_3 - 2.0 * q_6 - q_10 - q_19;  // by omega2
    gradient[2] = (-f_0 - f_1) / omega3 - q_0 + q_1 - q_2 + q_3 - q_4 - q_6 - 2.0 * q_19;  // by omega3
    const double c_0 = 2.0 * over_62 / omega3 - 2.0 * over_66;  // multiplies a113*a123
    const double c_1 = 2.0 * over_63 / omega3 + 2.0 * over_65;  // multiplies a123*a223
    const double c_2 = 2.0 * over_64;  // multiplies a123*a333
    gradient[3] = a123 * c_0;  // by a113
    gradient[4] = a113 * c_0 + a223 * c_1 + a333 * c_2;  // by a123
    gradient[5] = a123 * c_1;  // by a223
    gradient[6] = a123 * c_2;  // by a333
  }
  void lump_harmonic_re_v3_A_v12_A_v3([[maybe_unused]] double* gradient) const {
    const double f_0 = b1133 * per_15 / (4.0 * omega1);
    const double f_1 = a113_2 * over_31 / (omega1 * omega3);
    const double f_2 = a123_2 * over_32 / (4.0 * omega1);
    const double f_3 = a113 * a333 * over_67 / (2.0 * omega1);
    const double q_0 = f_2 * per_0;
    const double q_2 = f_2 * per_2;
    const double q_4 = (f_1 + f_3) * per_4;
    const double q_5 = f_3 * per_5;
    const double q_15 = (f_0 + f_1 + f_2 + f_3) * per_15;
    gradient[0] = (-f_0 - f_1 - f_2 - f_3) / omega1 - q_0 - q_2 - 2.0 * q_4 - 2.0 * q_5 - q_15;  // by omega1
    gradient[1] = -q_0 + q_2;  // by omega2
    gradient[2] = -f_1 / omega3 - q_0 - q_2 - q_4 + q_5 - q_15;  // by omega3
    const double c_0 = over_31 / (omega1 * omega3);  // multiplies a113^2
    const double c_1 = over_67 / (2.0 * omega1);  // multiplies a113*a333
    const double c_2 = over_32 / (4.0 * omega1);  // multiplies a123^2
    const double c_3 = per_15 / (4.0 * omega1);  // multiplies b1133
    gradient[3] = 2.0 * a113 * c_0 + a333 * c_1;  // by a113
    gradient[4] = 2.0 * a123 * c_2;  // by a123
    gradient[6] = a113 * c_1;  // by a333
    gradient[10] = c_3;  // by b1133
  }

  using Gradient = void (LumpGradients::*)(double*) const;
  static constexpr Gradient gradients[] = {&LumpGradients::lump_mu1,
      &LumpGradients::lump_conservative_v1_A_v1_A_v2_conjA_v2, &LumpGradients::lump_conservative_v1_A_v12_conjA_v1,
      &LumpGradients::lump_conservative_v1_conjA_v2_F, &LumpGradients::lump_mu2,
      &LumpGradients::lump_conservative_v2_A_v22_conjA_v2, &LumpGradients::lump_e1,
      &LumpGradients::lump_harmonic_re_v1_A_v2_conjA_v12, &LumpGradients::lump_harmonic_re_v1_conjA_v1_F,
      &LumpGradients::lump_harmonic_re_v1_A_v22_conjA_v2, &LumpGradients::lump_harmonic_re_v1_A_v22_conjA_v1,
      &LumpGradients::lump_harmonic_re_v1_A_v1_A_v22, &LumpGradients::lump_harmonic_re_v1_A_v13,
      &LumpGradients::lump_e2, &LumpGradients::lump_harmonic_re_v2_A_v2_conjA_v12,
      &LumpGradients::lump_harmonic_re_v2_conjA_v2_F, &LumpGradients::lump_harmonic_re_v2_A_v23,
      &LumpGradients::lump_harmonic_re_v2_A_v12_A_v2, &LumpGradients::lump_a123, &LumpGradients::lump_a223,
      &LumpGradients::lump_a113, &LumpGradients::lump_e3, &LumpGradients::lump_harmonic_re_v3_conjA_v1_F,
      &LumpGradients::lump_harmonic_re_v3_conjA_v2_F, &LumpGradients::lump_conservative_v1_A_v1_A_v3_conjA_v3,
      &LumpGradients::lump_conservative_v2_A_v2_A_v3_conjA_v3, &LumpGradients::lump_mu3,
      &LumpGradients::lump_conservative_v3_A_v32_conjA_v3, &LumpGradients::lump_harmonic_re_v1_A_v32_conjA_v1,
      &LumpGradients::lump_harmonic_re_v1_A_v32_conjA_v2, &LumpGradients::lump_harmonic_re_v1_A_v2_A_v3_conjA_v3,
      &LumpGradients::lump_harmonic_re_v1_A_v2_A_v32, &LumpGradients::lump_harmonic_re_v1_A_v1_A_v32,
      &LumpGradients::lump_harmonic_re_v2_A_v32_conjA_v1, &LumpGradients::lump_harmonic_re_v2_A_v32_conjA_v2,
      &LumpGradients::lump_harmonic_re_v2_A_v2_A_v32, &LumpGradients::lump_harmonic_re_v2_A_v1_A_v3_conjA_v3,
      &LumpGradients::lump_harmonic_re_v2_A_v1_A_v32, &LumpGradients::lump_a333,
      &LumpGradients::lump_harmonic_re_v3_A_v3_conjA_v12,
      &LumpGradients::lump_harmonic_re_v3_A_v3_conjA_v1_conjA_v2,
      &LumpGradients::lump_harmonic_re_v3_A_v2_A_v3_conjA_v1, &LumpGradients::lump_harmonic_re_v3_A_v22_conjA_v3,
      &LumpGradients::lump_harmonic_re_v3_A_v22_A_v3, &LumpGradients::lump_harmonic_re_v3_A_v1_A_v3_conjA_v2,
      &LumpGradients::lump_harmonic_re_v3_A_v1_A_v2_A_v3, &LumpGradients::lump_harmonic_re_v3_A_v12_A_v3};
};

inline constexpr LumpFunctions lump_functions = {lump_values<Lumps>, lump_jacobian<LumpGradients, 19>};

}  // namespace secular::generated::three_modes
