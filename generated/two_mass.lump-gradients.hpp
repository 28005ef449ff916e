// Model two_mass: generated code, never edited by hand.
// Holds derivatives of the lumps by the parameters. Made by: secular generate two_mass.
#pragma once

#include "two_mass.hpp"

namespace secular::generated::two_mass {

/// gradient[p] = derivative of a lump by parameters[p], entries that are not zero. Of lumps with small divisors:
/// f_n are the fractions whose sum the lump is, q_d those of divisor d times its power and inverse, c_n what
/// multiplies a product of coefficients.
struct LumpGradients : Lumps {
  using Lumps::Lumps;

  void lump_conservative_v1_A_v12_F([[maybe_unused]] double* gradient) const {
    gradient[0] = (omega1_2 * delta21 * eta12 - 5.0 * alpha21 * eta12) / (4.0 * omega1_4);  // by omega1
    gradient[5] = 5.0 * eta12 / (12.0 * omega1_3);  // by alpha21
    gradient[8] = -eta12 / (4.0 * omega1);  // by delta21
    gradient[21] = (-3.0 * omega1_2 * delta21 + 5.0 * alpha21) / (12.0 * omega1_3);  // by eta12
  }
  void lump_mu11([[maybe_unused]] double* gradient) const { gradient[2] = 1.0; }
  void lump_conservative_v1_A_v1([[maybe_unused]] double* gradient) const {
    const double f_0 = -omega1 * mu12 * mu21 * over_0 / 2.0;
    const double q_0 = f_0 * per_0;
    const double q_1 = f_0 * per_1;
    gradient[0] = f_0 / omega1 - q_0 - q_1;  // by omega1
    gradient[1] = -q_0 + q_1;  // by omega2
    const double c_0 = -omega1 * over_0 / 2.0;  // multiplies mu12*mu21
    gradient[3] = mu21 * c_0;  // by mu12
    gradient[23] = mu12 * c_0;  // by mu21
  }
  void lump_conservative_v1_A_v1_F2([[maybe_unused]] double* gradient) const {
    gradient[0] = eta12_2 / (4.0 * omega1_4);  // by omega1
    gradient[21] = -eta12 / (6.0 * omega1_3);  // by eta12
  }
  void lump_conservative_v1_A_v1_A_v2_conjA_v2([[maybe_unused]] double* gradient) const {
    const double f_0 = -2.0 * omega1 * delta22 * delta24 - omega1 * delta33;
    const double f_1 = 2.0 * omega1 * delta22 * alpha24 / omega2_2;
    const double f_2 = (-2.0 * omega2_2 * delta21 * delta23 - omega2_2 * delta34) / omega1;
    const double f_3 = (2.0 * alpha22 * delta24 + 2.0 * alpha23 * delta21 + alpha33) / omega1;
    const double f_4 = -2.0 * alpha22 * alpha24 / (omega1 * omega2_2);
    const double f_5 = 2.0 * omega2_2 * alpha21 * delta23 / omega1_3;
    const double f_6 = -2.0 * alpha21 * alpha23 / omega1_3;
    const double f_7 = 4.0 * omega1 * omega2_2 * delta23_2 * over_1;
    const double f_8 = -12.0 * omega2_4 * delta23_2 * over_1 / omega1;
    const double f_9 = 8.0 * omega2_2 * alpha23 * delta23 * over_1 / omega1;
    const double f_10 = 4.0 * alpha23_2 * over_1 / omega1;
    const double f_11 = 12.0 * omega1_3 * delta22_2 * over_2;
    const double f_12 = -4.0 * omega1 * omega2_2 * delta22_2 * over_2;
    const double f_13 = -8.0 * omega1 * alpha22 * delta22 * over_2;
    const double f_14 = -4.0 * alpha22_2 * over_2 / omega1;
    const double q_2 = (f_7 + f_8 + f_9 + f_10) * per_2;
    const double q_3 = (f_7 + f_8 + f_9 + f_10) * per_3;
    const double q_4 = (f_11 + f_12 + f_13 + f_14) * per_4;
    const double q_5 = (f_11 + f_12 + f_13 + f_14) * per_5;
    gradient[0] = (f_0 + f_1 - f_2 - f_3 - f_4 - 3.0 * f_5 - 3.0 * f_6 + f_7 - f_8 - f_9 - f_10 + 3.0 * f_11 + f_12
        + f_13 - f_14) / omega1 - q_2 - q_3 - 2.0 * q_4 - 2.0 * q_5;
    gradient[1] = (-2.0 * f_1 + 2.0 * f_2 - 2.0 * f_4 + 2.0 * f_5 + 2.0 * f_7 + 4.0 * f_8 + 2.0 * f_9
        + 2.0 * f_12) / omega2 - 2.0 * q_2 + 2.0 * q_3 - q_4 + q_5;
    const double c_0 = -2.0 / omega1_3;  // multiplies alpha21*alpha23
    const double c_1 = 2.0 * omega2_2 / omega1_3;  // multiplies alpha21*delta23
    const double c_2 = -4.0 * over_2 / omega1;  // multiplies alpha22^2
    const double c_3 = -8.0 * omega1 * over_2;  // multiplies alpha22*delta22
    const double c_4 = -2.0 / (omega1 * omega2_2);  // multiplies alpha22*alpha24
    const double c_5 = 2.0 / omega1;  // multiplies alpha22*delta24
    const double c_6 = 4.0 * over_1 / omega1;  // multiplies alpha23^2
    const double c_7 = 2.0 / omega1;  // multiplies alpha23*delta21
    const double c_8 = 8.0 * omega2_2 * over_1 / omega1;  // multiplies alpha23*delta23
    const double c_9 = -2.0 * omega2_2 / omega1;  // multiplies delta21*delta23
    const double c_10 = (12.0 * omega1_3 - 4.0 * omega1 * omega2_2) * over_2;  // multiplies delta22^2
    const double c_11 = 2.0 * omega1 / omega2_2;  // multiplies delta22*alpha24
    const double c_12 = -2.0 * omega1;  // multiplies delta22*delta24
    const double c_13 = (4.0 * omega1_2 * omega2_2 - 12.0 * omega2_4) * over_1 / omega1;  // multiplies delta23^2
    const double c_14 = 1.0 / omega1;  // multiplies alpha33
    const double c_15 = -omega1;  // multiplies delta33
    const double c_16 = -omega2_2 / omega1;  // multiplies delta34
    gradient[5] = alpha23 * c_0 + delta23 * c_1;  // by alpha21
    gradient[6] = 2.0 * alpha22 * c_2 + delta22 * c_3 + alpha24 * c_4 + delta24 * c_5;  // by alpha22
    gradient[7] = alpha21 * c_0 + 2.0 * alpha23 * c_6 + delta21 * c_7 + delta23 * c_8;  // by alpha23
    gradient[8] = alpha23 * c_7 + delta23 * c_9;  // by delta21
    gradient[9] = alpha22 * c_3 + 2.0 * delta22 * c_10 + alpha24 * c_11 + delta24 * c_12;  // by delta22
    gradient[10] = alpha21 * c_1 + alpha23 * c_8 + delta21 * c_9 + 2.0 * delta23 * c_13;  // by delta23
    gradient[13] = c_14;  // by alpha33
    gradient[17] = c_15;  // by delta33
    gradient[18] = c_16;  // by delta34
    gradient[25] = alpha22 * c_4 + delta22 * c_11;  // by alpha24
    gradient[26] = alpha22 * c_5 + delta22 * c_12;  // by delta24
  }
  void lump_mu13([[maybe_unused]] double* gradient) const { gradient[4] = 1.0; }
  void lump_conservative_v1_A_v12_conjA_v1([[maybe_unused]] double* gradient) const {
    const double f_0 = omega1 * delta21_2 - omega1 * delta31;
    const double f_1 = (4.0 * alpha21 * delta21 + 3.0 * alpha31) / (2.0 * omega1);
    const double f_2 = -5.0 * alpha21_2 / (3.0 * omega1_3);
    const double f_3 = -8.0 * omega1_5 * delta22_2 * over_2 / omega2_2;
    const double f_4 = 3.0 * omega1_3 * delta22_2 * over_2;
    const double f_5 = 16.0 * omega1_3 * alpha22 * delta22 * over_2 / omega2_2;
    const double f_6 = -2.0 * omega1 * alpha22 * delta22 * over_2;
    const double f_7 = -8.0 * omega1 * alpha22_2 * over_2 / omega2_2;
    const double f_8 = 3.0 * alpha22_2 * over_2 / omega1;
    const double q_4 = (f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_4;
    const double q_5 = (f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_5;
    gradient[0] = (f_0 - f_1 - 3.0 * f_2 + 5.0 * f_3 + 3.0 * f_4 + 3.0 * f_5 + f_6 + f_7 - f_8) / omega1 - 2.0 * q_4
        - 2.0 * q_5;
    gradient[1] = (-2.0 * f_3 - 2.0 * f_5 - 2.0 * f_7) / omega2 - q_4 + q_5;  // by omega2
    const double c_0 = -5.0 / (3.0 * omega1_3);  // multiplies alpha21^2
    const double c_1 = 2.0 / omega1;  // multiplies alpha21*delta21
    const double c_2 = (-8.0 * omega1_2 + 3.0 * omega2_2) * over_2 / (omega1 * omega2_2);  // multiplies alpha22^2
    const double c_3 = (16.0 * omega1_3 - 2.0 * omega1 * omega2_2) * over_2 / omega2_2;
    const double c_4 = omega1;  // multiplies delta21^2
    const double c_5 = (-8.0 * omega1_5 + 3.0 * omega1_3 * omega2_2) * over_2 / omega2_2;  // multiplies delta22^2
    const double c_6 = 3.0 / (2.0 * omega1);  // multiplies alpha31
    const double c_7 = -omega1;  // multiplies delta31
    gradient[5] = 2.0 * alpha21 * c_0 + delta21 * c_1;  // by alpha21
    gradient[6] = 2.0 * alpha22 * c_2 + delta22 * c_3;  // by alpha22
    gradient[8] = alpha21 * c_1 + 2.0 * delta21 * c_4;  // by delta21
    gradient[9] = alpha22 * c_3 + 2.0 * delta22 * c_5;  // by delta22
    gradient[11] = c_6;  // by alpha31
    gradient[15] = c_7;  // by delta31
  }
  void lump_eta11([[maybe_unused]] double* gradient) const { gradient[20] = 1.0; }
  void lump_conservative_v1_A_v2_conjA_v2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -omega2_2 * delta23 * eta12 / (2.0 * omega1_3);
    const double f_1 = alpha23 * eta12 / (2.0 * omega1_3);
    const double f_2 = -omega2_2 * delta23 * eta22 * over_1 / omega1;
    const double f_3 = -alpha23 * eta22 * over_1 / omega1;
    const double q_2 = (f_2 + f_3) * per_2;
    const double q_3 = (f_2 + f_3) * per_3;
    gradient[0] = (-3.0 * f_0 - 3.0 * f_1 - f_2 - f_3) / omega1 - q_2 - q_3;  // by omega1
    gradient[1] = (2.0 * f_0 + 2.0 * f_2) / omega2 - 2.0 * q_2 + 2.0 * q_3;  // by omega2
    const double c_0 = 1.0 / (2.0 * omega1_3);  // multiplies alpha23*eta12
    const double c_1 = -over_1 / omega1;  // multiplies alpha23*eta22
    const double c_2 = -omega2_2 / (2.0 * omega1_3);  // multiplies delta23*eta12
    const double c_3 = -omega2_2 * over_1 / omega1;  // multiplies delta23*eta22
    gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
    gradient[10] = eta12 * c_2 + eta22 * c_3;  // by delta23
    gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
    gradient[30] = alpha23 * c_1 + delta23 * c_3;  // by eta22
  }
  void lump_mu22([[maybe_unused]] double* gradient) const { gradient[22] = 1.0; }
  void lump_conservative_v2_A_v2_F2([[maybe_unused]] double* gradient) const {
    const double f_0 = eta22_2 * over_1 / (4.0 * omega2);
    const double q_2 = f_0 * per_2;
    const double q_3 = f_0 * per_3;
    gradient[0] = -q_2 - q_3;  // by omega1
    gradient[1] = -f_0 / omega2 - 2.0 * q_2 + 2.0 * q_3;  // by omega2
    const double c_0 = over_1 / (4.0 * omega2);  // multiplies eta22^2
    gradient[30] = 2.0 * eta22 * c_0;  // by eta22
  }
  void lump_mu23([[maybe_unused]] double* gradient) const { gradient[24] = 1.0; }
  void lump_conservative_v2_A_v22_conjA_v2([[maybe_unused]] double* gradient) const {
    const double f_0 = omega2 * delta24_2 - omega2 * delta36;
    const double f_1 = (4.0 * alpha24 * delta24 + 3.0 * alpha35) / (2.0 * omega2);
    const double f_2 = -5.0 * alpha24_2 / (3.0 * omega2_3);
    const double f_3 = -3.0 * omega2_3 * delta23_2 * over_1;
    const double f_4 = 2.0 * omega2 * alpha23 * delta23 * over_1;
    const double f_5 = -3.0 * alpha23_2 * over_1 / omega2;
    const double f_6 = 8.0 * omega2_5 * delta23_2 * over_1 / omega1_2;
    const double f_7 = -16.0 * omega2_3 * alpha23 * delta23 * over_1 / omega1_2;
    const double f_8 = 8.0 * omega2 * alpha23_2 * over_1 / omega1_2;
    const double q_2 = (f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_2;
    const double q_3 = (f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_3;
    gradient[0] = (-2.0 * f_6 - 2.0 * f_7 - 2.0 * f_8) / omega1 - q_2 - q_3;  // by omega1
    gradient[1] = (f_0 - f_1 - 3.0 * f_2 + 3.0 * f_3 + f_4 - f_5 + 5.0 * f_6 + 3.0 * f_7 + f_8) / omega2 - 2.0 * q_2
        + 2.0 * q_3;
    const double c_0 = (-3.0 * omega1_2 + 8.0 * omega2_2) * over_1 / (omega1_2 * omega2);  // multiplies alpha23^2
    const double c_1 = (2.0 * omega1_2 * omega2 - 16.0 * omega2_3) * over_1 / omega1_2;
    const double c_2 = (-3.0 * omega1_2 * omega2_3 + 8.0 * omega2_5) * over_1 / omega1_2;  // multiplies delta23^2
    const double c_3 = -5.0 / (3.0 * omega2_3);  // multiplies alpha24^2
    const double c_4 = 2.0 / omega2;  // multiplies alpha24*delta24
    const double c_5 = omega2;  // multiplies delta24^2
    const double c_6 = 3.0 / (2.0 * omega2);  // multiplies alpha35
    const double c_7 = -omega2;  // multiplies delta36
    gradient[7] = 2.0 * alpha23 * c_0 + delta23 * c_1;  // by alpha23
    gradient[10] = alpha23 * c_1 + 2.0 * delta23 * c_2;  // by delta23
    gradient[25] = 2.0 * alpha24 * c_3 + delta24 * c_4;  // by alpha24
    gradient[26] = alpha24 * c_4 + 2.0 * delta24 * c_5;  // by delta24
    gradient[27] = c_6;  // by alpha35
    gradient[28] = c_7;  // by delta36
  }
  void lump_eta12([[maybe_unused]] double* gradient) const { gradient[21] = 1.0; }
  void lump_harmonic_re_v1_A_v2_conjA_v2([[maybe_unused]] double* gradient) const {
    gradient[0] = (-4.0 * omega2_2 * delta23 + 4.0 * alpha23) / omega1_3;  // by omega1
    gradient[1] = 4.0 * omega2 * delta23 / omega1_2;  // by omega2
    gradient[7] = -2.0 / omega1_2;  // by alpha23
    gradient[10] = 2.0 * omega2_2 / omega1_2;  // by delta23
  }
  void lump_harmonic_re_v1_A_v1_conjA_v1([[maybe_unused]] double* gradient) const {
    gradient[0] = 4.0 * alpha21 / omega1_3;  // by omega1
    gradient[5] = -2.0 / omega1_2;  // by alpha21
    gradient[8] = 2.0;  // by delta21
  }
  void lump_harmonic_re_v1_A_v2_conjA_v1([[maybe_unused]] double* gradient) const {
    const double f_0 = 2.0 * omega1_2 * delta22 * per_5 / omega2;
    const double f_1 = -2.0 * omega1 * delta22 * per_5;
    const double f_2 = -2.0 * alpha22 * per_5 / omega2;
    const double q_5 = (f_0 + f_1 + f_2) * per_5;
    gradient[0] = (2.0 * f_0 + f_1) / omega1 - 2.0 * q_5;  // by omega1
    gradient[1] = (-f_0 - f_2) / omega2 + q_5;  // by omega2
    const double c_0 = -2.0 * per_5 / omega2;  // multiplies alpha22
    const double c_1 = (2.0 * omega1_2 - 2.0 * omega1 * omega2) * per_5 / omega2;  // multiplies delta22
    gradient[6] = c_0;  // by alpha22
    gradient[9] = c_1;  // by delta22
  }
  void lump_harmonic_im_v1_A_v2_conjA_v1([[maybe_unused]] double* gradient) const {
    const double f_0 = 2.0 * omega1 * mu12 * delta23 * over_3;
    const double f_1 = -4.0 * omega2 * mu12 * delta23 * over_3;
    const double f_2 = 2.0 * mu12 * alpha23 * over_3 / omega2;
    const double f_3 = 2.0 * omega2_2 * mu12 * delta23 * over_3 / omega1;
    const double f_4 = -2.0 * mu12 * alpha23 * over_3 / omega1;
    const double f_5 = (-2.0 * omega1_2 * mu12 * delta21 - 2.0 * omega1_2 * delta23 * mu21) * over_4;
    const double f_6 = 2.0 * omega1 * omega2 * mu12 * delta21 * over_4;
    const double f_7 = 2.0 * omega1 * alpha23 * mu21 * over_4 / omega2;
    const double f_8 = -2.0 * omega2_2 * mu12 * delta21 * over_4;
    const double f_9 = 2.0 * mu12 * alpha21 * over_4;
    const double q_0 = (f_5 + f_6 + f_7 + f_8 + f_9) * per_0;
    const double q_1 = (f_5 + f_6 + f_7 + f_8 + f_9) * per_1;
    const double q_3 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_3;
    const double q_5 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_5;
    gradient[0] = (f_0 - f_3 - f_4 + 2.0 * f_5 + f_6 + f_7) / omega1 - q_0 - q_1 - q_3 - 2.0 * q_5;  // by omega1
    gradient[1] = (f_1 - f_2 + 2.0 * f_3 + f_6 - f_7 + 2.0 * f_8) / omega2 - q_0 + q_1 + 2.0 * q_3 + q_5;
    const double c_0 = 2.0 * over_4;  // multiplies mu12*alpha21
    const double c_1 = (2.0 * omega1 - 2.0 * omega2) * over_3 / (omega1 * omega2);  // multiplies mu12*alpha23
    const double c_2 = (-2.0 * omega1_2 + 2.0 * omega1 * omega2 - 2.0 * omega2_2) * over_4;
    const double c_3 = (2.0 * omega1_2 - 4.0 * omega1 * omega2 + 2.0 * omega2_2) * over_3 / omega1;
    const double c_4 = 2.0 * omega1 * over_4 / omega2;  // multiplies alpha23*mu21
    const double c_5 = -2.0 * omega1_2 * over_4;  // multiplies delta23*mu21
    gradient[3] = alpha21 * c_0 + alpha23 * c_1 + delta21 * c_2 + delta23 * c_3;  // by mu12
    gradient[5] = mu12 * c_0;  // by alpha21
    gradient[7] = mu12 * c_1 + mu21 * c_4;  // by alpha23
    gradient[8] = mu12 * c_2;  // by delta21
    gradient[10] = mu12 * c_3 + mu21 * c_5;  // by delta23
    gradient[23] = alpha23 * c_4 + delta23 * c_5;  // by mu21
  }
  void lump_harmonic_im_v1_A_v2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -mu12 * eta22 * over_3 / (2.0 * omega2);
    const double f_1 = mu12 * eta22 * over_3 / (2.0 * omega1);
    const double f_2 = -mu12 * eta12 * over_4 / 2.0;
    const double q_0 = f_2 * per_0;
    const double q_1 = f_2 * per_1;
    const double q_3 = (f_0 + f_1) * per_3;
    const double q_5 = (f_0 + f_1 + f_2) * per_5;
    gradient[0] = -f_1 / omega1 - q_0 - q_1 - q_3 - 2.0 * q_5;  // by omega1
    gradient[1] = -f_0 / omega2 - q_0 + q_1 + 2.0 * q_3 + q_5;  // by omega2
    const double c_0 = -over_4 / 2.0;  // multiplies mu12*eta12
    const double c_1 = (-omega1 + omega2) * over_3 / (2.0 * omega1 * omega2);  // multiplies mu12*eta22
    gradient[3] = eta12 * c_0 + eta22 * c_1;  // by mu12
    gradient[21] = mu12 * c_0;  // by eta12
    gradient[30] = mu12 * c_1;  // by eta22
  }
  void lump_mu12([[maybe_unused]] double* gradient) const { gradient[3] = 1.0; }
  void lump_harmonic_re_v1_A_v2_conjA_v1_F([[maybe_unused]] double* gradient) const {
    const double f_0 = omega1 * delta22 * eta12 * over_5 / omega2;
    const double f_1 = omega2 * delta22 * eta22 * over_6;
    const double f_2 = alpha22 * eta22 * over_6 / omega1;
    const double f_3 = -alpha22 * eta12 * over_4 / omega2;
    const double f_4 = -2.0 * alpha22 * eta12 * over_4 / omega1;
    const double f_5 = omega2 * alpha22 * eta12 * over_4 / omega1_2;
    const double q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_0;
    const double q_1 = (f_1 + f_2 + f_3 + f_4 + f_5) * per_1;
    const double q_2 = (f_1 + f_2) * per_2;
    const double q_5 = (f_0 + f_3 + f_4 + f_5) * per_5;
    gradient[0] = (f_0 - f_2 - f_4 - 2.0 * f_5) / omega1 - q_0 - q_1 - q_2 - 2.0 * q_5;  // by omega1
    gradient[1] = (-f_0 + f_1 - f_3 + f_5) / omega2 - q_0 + q_1 - 2.0 * q_2 + q_5;  // by omega2
    const double c_0 = (-omega1_2 - 2.0 * omega1 * omega2 + omega2_2) * over_4 / (omega1_2 * omega2);
    const double c_1 = over_6 / omega1;  // multiplies alpha22*eta22
    const double c_2 = omega1 * over_5 / omega2;  // multiplies delta22*eta12
    const double c_3 = omega2 * over_6;  // multiplies delta22*eta22
    gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
    gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
    gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
    gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  }
  void lump_harmonic_re_v1_A_v22_conjA_v2([[maybe_unused]] double* gradient) const {
    const double f_0 = (-4.0 * omega2_2 * delta23 * delta24 + omega2_2 * delta35) * over_0;
    const double f_1 = (-6.0 * alpha23 * delta24 + 4.0 * delta23 * alpha24 - 9.0 * alpha34) * over_0 / 3.0;
    const double f_2 = 10.0 * alpha23 * alpha24 * over_0 / (3.0 * omega2_2);
    const double f_3 = -4.0 * omega2_4 * delta22 * delta23 * over_7;
    const double f_4 = (-2.0 * omega2_2 * alpha22 * delta23 - 4.0 * omega2_2 * alpha23 * delta22) * over_7;
    const double f_5 = 6.0 * alpha22 * alpha23 * over_7;
    const double f_6 = 16.0 * omega2_4 * alpha22 * delta23 * over_7 / omega1_2;
    const double f_7 = -16.0 * omega2_2 * alpha22 * alpha23 * over_7 / omega1_2;
    const double q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7) * per_0;
    const double q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7) * per_1;
    const double q_2 = (f_3 + f_4 + f_5 + f_6 + f_7) * per_2;
    const double q_3 = (f_3 + f_4 + f_5 + f_6 + f_7) * per_3;
    gradient[0] = (-2.0 * f_6 - 2.0 * f_7) / omega1 - q_0 - q_1 - q_2 - q_3;  // by omega1
    gradient[1] = (2.0 * f_0 - 2.0 * f_2 + 4.0 * f_3 + 2.0 * f_4 + 4.0 * f_6 + 2.0 * f_7) / omega2 - q_0 + q_1
        - 2.0 * q_2 + 2.0 * q_3;
    const double c_0 = (6.0 * omega1_2 - 16.0 * omega2_2) * over_7 / omega1_2;  // multiplies alpha22*alpha23
    const double c_1 = (-2.0 * omega1_2 * omega2_2 + 16.0 * omega2_4) * over_7 / omega1_2;
    const double c_2 = -4.0 * omega2_2 * over_7;  // multiplies alpha23*delta22
    const double c_3 = 10.0 * over_0 / (3.0 * omega2_2);  // multiplies alpha23*alpha24
    const double c_4 = -2.0 * over_0;  // multiplies alpha23*delta24
    const double c_5 = -4.0 * omega2_4 * over_7;  // multiplies delta22*delta23
    const double c_6 = 4.0 * over_0 / 3.0;  // multiplies delta23*alpha24
    const double c_7 = -4.0 * omega2_2 * over_0;  // multiplies delta23*delta24
    const double c_8 = -3.0 * over_0;  // multiplies alpha34
    const double c_9 = omega2_2 * over_0;  // multiplies delta35
    gradient[6] = alpha23 * c_0 + delta23 * c_1;  // by alpha22
    gradient[7] = alpha22 * c_0 + delta22 * c_2 + alpha24 * c_3 + delta24 * c_4;  // by alpha23
    gradient[9] = alpha23 * c_2 + delta23 * c_5;  // by delta22
    gradient[10] = alpha22 * c_1 + delta22 * c_5 + alpha24 * c_6 + delta24 * c_7;  // by delta23
    gradient[14] = c_8;  // by alpha34
    gradient[19] = c_9;  // by delta35
    gradient[25] = alpha23 * c_3 + delta23 * c_6;  // by alpha24
    gradient[26] = alpha23 * c_4 + delta23 * c_7;  // by delta24
  }
  void lump_harmonic_re_v1_A_v1_A_v2_conjA_v1([[maybe_unused]] double* gradient) const {
    const double f_0 = 2.0 * omega1_2 * delta32 * over_0;
    const double f_1 = -6.0 * alpha32 * over_0;
    const double f_2 = -4.0 * omega1_4 * alpha23 * delta22 * over_7 / omega2_2;
    const double f_3 = 8.0 * omega1_2 * omega2_2 * delta22 * delta23 * over_7;
    const double f_4 = 16.0 * omega1_2 * alpha23 * delta22 * over_7;
    const double f_5 = 4.0 * omega1_2 * alpha22 * alpha23 * over_7 / omega2_2;
    const double f_6 = -16.0 * omega2_4 * delta22 * delta23 * over_7;
    const double f_7 = (-8.0 * omega2_2 * alpha22 * delta23 + 16.0 * omega2_2 * alpha23 * delta22) * over_7;
    const double f_8 = -24.0 * alpha22 * alpha23 * over_7;
    const double f_9 = -24.0 * omega1_4 * delta21 * delta22 * over_8;
    const double f_10 = (8.0 * omega1_2 * alpha21 * delta22 - 8.0 * omega1_2 * alpha22 * delta21) * over_8;
    const double f_11 = -4.0 * omega2_2 * alpha22 * delta21 * over_8;
    const double f_12 = 24.0 * alpha21 * alpha22 * over_8;
    const double f_13 = -4.0 * omega2_2 * alpha21 * alpha22 * over_8 / omega1_2;
    const double q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12
        + f_13) * per_0;
    const double q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12
        + f_13) * per_1;
    const double q_2 = (f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_2;
    const double q_3 = (f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_3;
    const double q_4 = (f_9 + f_10 + f_11 + f_12 + f_13) * per_4;
    const double q_5 = (f_9 + f_10 + f_11 + f_12 + f_13) * per_5;
    gradient[0] = (2.0 * f_0 + 4.0 * f_2 + 2.0 * f_3 + 2.0 * f_4 + 2.0 * f_5 + 4.0 * f_9 + 2.0 * f_10
        - 2.0 * f_13) / omega1 - q_0 - q_1 - q_2 - q_3 - 2.0 * q_4 - 2.0 * q_5;
    gradient[1] = (-2.0 * f_2 + 2.0 * f_3 - 2.0 * f_5 + 4.0 * f_6 + 2.0 * f_7 + 2.0 * f_11 + 2.0 * f_13) / omega2
        - q_0 + q_1 - 2.0 * q_2 + 2.0 * q_3 - q_4 + q_5;
    const double c_0 = (24.0 * omega1_2 - 4.0 * omega2_2) * over_8 / omega1_2;  // multiplies alpha21*alpha22
    const double c_1 = 8.0 * omega1_2 * over_8;  // multiplies alpha21*delta22
    const double c_2 = (4.0 * omega1_2 - 24.0 * omega2_2) * over_7 / omega2_2;  // multiplies alpha22*alpha23
    const double c_3 = (-8.0 * omega1_2 - 4.0 * omega2_2) * over_8;  // multiplies alpha22*delta21
    const double c_4 = -8.0 * omega2_2 * over_7;  // multiplies alpha22*delta23
    const double c_5 = (-4.0 * omega1_4 + 16.0 * omega1_2 * omega2_2 + 16.0 * omega2_4) * over_7 / omega2_2;
    const double c_6 = -24.0 * omega1_4 * over_8;  // multiplies delta21*delta22
    const double c_7 = (8.0 * omega1_2 * omega2_2 - 16.0 * omega2_4) * over_7;  // multiplies delta22*delta23
    const double c_8 = -6.0 * over_0;  // multiplies alpha32
    const double c_9 = 2.0 * omega1_2 * over_0;  // multiplies delta32
    gradient[5] = alpha22 * c_0 + delta22 * c_1;  // by alpha21
    gradient[6] = alpha21 * c_0 + alpha23 * c_2 + delta21 * c_3 + delta23 * c_4;  // by alpha22
    gradient[7] = alpha22 * c_2 + delta22 * c_5;  // by alpha23
    gradient[8] = alpha22 * c_3 + delta22 * c_6;  // by delta21
    gradient[9] = alpha21 * c_1 + alpha23 * c_5 + delta21 * c_6 + delta23 * c_7;  // by delta22
    gradient[10] = alpha22 * c_4 + delta22 * c_7;  // by delta23
    gradient[12] = c_8;  // by alpha32
    gradient[16] = c_9;  // by delta32
  }
  void lump_harmonic_re_v1_A_v1_A_v2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -omega1 * delta22 * eta12 * over_9 / omega2;
    const double f_1 = -omega2 * delta22 * eta22 * over_10;
    const double f_2 = alpha22 * eta22 * over_10 / omega1;
    const double f_3 = alpha22 * eta12 * over_11 / omega2;
    const double f_4 = -2.0 * alpha22 * eta12 * over_11 / omega1;
    const double f_5 = -omega2 * alpha22 * eta12 * over_11 / omega1_2;
    const double q_0 = (f_1 + f_2 + f_3 + f_4 + f_5) * per_0;
    const double q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_1;
    const double q_3 = (f_1 + f_2) * per_3;
    const double q_4 = (f_0 + f_3 + f_4 + f_5) * per_4;
    gradient[0] = (f_0 - f_2 - f_4 - 2.0 * f_5) / omega1 - q_0 - q_1 - q_3 - 2.0 * q_4;  // by omega1
    gradient[1] = (-f_0 + f_1 - f_3 + f_5) / omega2 - q_0 + q_1 + 2.0 * q_3 - q_4;  // by omega2
    const double c_0 = (omega1_2 - 2.0 * omega1 * omega2 - omega2_2) * over_11 / (omega1_2 * omega2);
    const double c_1 = over_10 / omega1;  // multiplies alpha22*eta22
    const double c_2 = -omega1 * over_9 / omega2;  // multiplies delta22*eta12
    const double c_3 = -omega2 * over_10;  // multiplies delta22*eta22
    gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
    gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
    gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
    gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  }
  void lump_harmonic_re_v1_A_v22([[maybe_unused]] double* gradient) const {
    const double f_0 = -omega2_2 * delta23 * over_1;
    const double f_1 = -alpha23 * over_1;
    const double q_2 = (f_0 + f_1) * per_2;
    const double q_3 = (f_0 + f_1) * per_3;
    gradient[0] = -q_2 - q_3;  // by omega1
    gradient[1] = 2.0 * f_0 / omega2 - 2.0 * q_2 + 2.0 * q_3;  // by omega2
    const double c_0 = -over_1;  // multiplies alpha23
    const double c_1 = -omega2_2 * over_1;  // multiplies delta23
    gradient[7] = c_0;  // by alpha23
    gradient[10] = c_1;  // by delta23
  }
  void lump_harmonic_im_v1_A_v22([[maybe_unused]] double* gradient) const {
    const double f_0 = 2.0 * omega2 * mu12 * delta24 * over_1;
    const double f_1 = -2.0 * mu12 * alpha24 * over_1 / (3.0 * omega2);
    const double f_2 = -4.0 * omega2_3 * mu12 * delta22 * over_7;
    const double f_3 = 2.0 * omega2 * mu12 * alpha22 * over_7;
    const double q_0 = (f_2 + f_3) * per_0;
    const double q_1 = (f_2 + f_3) * per_1;
    const double q_2 = (f_0 + f_1 + f_2 + f_3) * per_2;
    const double q_3 = (f_0 + f_1 + f_2 + f_3) * per_3;
    gradient[0] = -q_0 - q_1 - q_2 - q_3;  // by omega1
    gradient[1] = (f_0 - f_1 + 3.0 * f_2 + f_3) / omega2 - q_0 + q_1 - 2.0 * q_2 + 2.0 * q_3;  // by omega2
    const double c_0 = 2.0 * omega2 * over_7;  // multiplies mu12*alpha22
    const double c_1 = -4.0 * omega2_3 * over_7;  // multiplies mu12*delta22
    const double c_2 = -2.0 * over_1 / (3.0 * omega2);  // multiplies mu12*alpha24
    const double c_3 = 2.0 * omega2 * over_1;  // multiplies mu12*delta24
    gradient[3] = alpha22 * c_0 + delta22 * c_1 + alpha24 * c_2 + delta24 * c_3;  // by mu12
    gradient[6] = mu12 * c_0;  // by alpha22
    gradient[9] = mu12 * c_1;  // by delta22
    gradient[25] = mu12 * c_2;  // by alpha24
    gradient[26] = mu12 * c_3;  // by delta24
  }
  void lump_harmonic_re_v1_A_v12([[maybe_unused]] double* gradient) const {
    gradient[0] = -2.0 * alpha21 / (3.0 * omega1_3);  // by omega1
    gradient[5] = 1.0 / (3.0 * omega1_2);  // by alpha21
    gradient[8] = -1.0;  // by delta21
  }
  void lump_harmonic_im_v1_A_v12([[maybe_unused]] double* gradient) const {
    const double f_0 = -4.0 * omega1 * delta22 * mu21 * over_0 / 3.0;
    const double f_1 = 2.0 * alpha22 * mu21 * over_0 / (3.0 * omega1);
    const double f_2 = 2.0 * omega1 * mu12 * delta22 * over_2 / 3.0;
    const double f_3 = 2.0 * mu12 * alpha22 * over_2 / (3.0 * omega1);
    const double q_0 = (f_0 + f_1) * per_0;
    const double q_1 = (f_0 + f_1) * per_1;
    const double q_4 = (f_2 + f_3) * per_4;
    const double q_5 = (f_2 + f_3) * per_5;
    gradient[0] = (f_0 - f_1 + f_2 - f_3) / omega1 - q_0 - q_1 - 2.0 * q_4 - 2.0 * q_5;  // by omega1
    gradient[1] = -q_0 + q_1 - q_4 + q_5;  // by omega2
    const double c_0 = 2.0 * over_2 / (3.0 * omega1);  // multiplies mu12*alpha22
    const double c_1 = 2.0 * omega1 * over_2 / 3.0;  // multiplies mu12*delta22
    const double c_2 = 2.0 * over_0 / (3.0 * omega1);  // multiplies alpha22*mu21
    const double c_3 = -4.0 * omega1 * over_0 / 3.0;  // multiplies delta22*mu21
    gradient[3] = alpha22 * c_0 + delta22 * c_1;  // by mu12
    gradient[6] = mu12 * c_0 + mu21 * c_2;  // by alpha22
    gradient[9] = mu12 * c_1 + mu21 * c_3;  // by delta22
    gradient[23] = alpha22 * c_2 + delta22 * c_3;  // by mu21
  }
  void lump_harmonic_re_v1_A_v1_A_v2([[maybe_unused]] double* gradient) const {
    const double f_0 = -2.0 * omega1_2 * delta22 * per_4 / omega2;
    const double f_1 = -2.0 * omega1 * delta22 * per_4;
    const double f_2 = 2.0 * alpha22 * per_4 / omega2;
    const double q_4 = (f_0 + f_1 + f_2) * per_4;
    gradient[0] = (2.0 * f_0 + f_1) / omega1 - 2.0 * q_4;  // by omega1
    gradient[1] = (-f_0 - f_2) / omega2 - q_4;  // by omega2
    const double c_0 = 2.0 * per_4 / omega2;  // multiplies alpha22
    const double c_1 = (-2.0 * omega1_2 - 2.0 * omega1 * omega2) * per_4 / omega2;  // multiplies delta22
    gradient[6] = c_0;  // by alpha22
    gradient[9] = c_1;  // by delta22
  }
  void lump_harmonic_im_v1_A_v1_A_v2([[maybe_unused]] double* gradient) const {
    const double f_0 = -2.0 * omega1 * mu12 * delta23 * over_12;
    const double f_1 = -4.0 * omega2 * mu12 * delta23 * over_12;
    const double f_2 = 2.0 * mu12 * alpha23 * over_12 / omega2;
    const double f_3 = -2.0 * omega2_2 * mu12 * delta23 * over_12 / omega1;
    const double f_4 = 2.0 * mu12 * alpha23 * over_12 / omega1;
    const double f_5 = (2.0 * omega1_2 * mu12 * delta21 + 2.0 * omega1_2 * delta23 * mu21) * over_11;
    const double f_6 = 2.0 * omega1 * omega2 * mu12 * delta21 * over_11;
    const double f_7 = 2.0 * omega1 * alpha23 * mu21 * over_11 / omega2;
    const double f_8 = 2.0 * omega2_2 * mu12 * delta21 * over_11;
    const double f_9 = -2.0 * mu12 * alpha21 * over_11;
    const double q_0 = (f_5 + f_6 + f_7 + f_8 + f_9) * per_0;
    const double q_1 = (f_5 + f_6 + f_7 + f_8 + f_9) * per_1;
    const double q_2 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_2;
    const double q_4 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_4;
    gradient[0] = (f_0 - f_3 - f_4 + 2.0 * f_5 + f_6 + f_7) / omega1 - q_0 - q_1 - q_2 - 2.0 * q_4;  // by omega1
    gradient[1] = (f_1 - f_2 + 2.0 * f_3 + f_6 - f_7 + 2.0 * f_8) / omega2 - q_0 + q_1 - 2.0 * q_2 - q_4;
    const double c_0 = -2.0 * over_11;  // multiplies mu12*alpha21
    const double c_1 = (2.0 * omega1 + 2.0 * omega2) * over_12 / (omega1 * omega2);  // multiplies mu12*alpha23
    const double c_2 = (2.0 * omega1_2 + 2.0 * omega1 * omega2 + 2.0 * omega2_2) * over_11;
    const double c_3 = (-2.0 * omega1_2 - 4.0 * omega1 * omega2 - 2.0 * omega2_2) * over_12 / omega1;
    const double c_4 = 2.0 * omega1 * over_11 / omega2;  // multiplies alpha23*mu21
    const double c_5 = 2.0 * omega1_2 * over_11;  // multiplies delta23*mu21
    gradient[3] = alpha21 * c_0 + alpha23 * c_1 + delta21 * c_2 + delta23 * c_3;  // by mu12
    gradient[5] = mu12 * c_0;  // by alpha21
    gradient[7] = mu12 * c_1 + mu21 * c_4;  // by alpha23
    gradient[8] = mu12 * c_2;  // by delta21
    gradient[10] = mu12 * c_3 + mu21 * c_5;  // by delta23
    gradient[23] = alpha23 * c_4 + delta23 * c_5;  // by mu21
  }
  void lump_harmonic_re_v1_A_v2_conjA_v12([[maybe_unused]] double* gradient) const {
    const double f_0 = -3.0 * omega1_2 * delta32 * over_13;
    const double f_1 = 2.0 * omega1 * omega2 * delta32 * over_13;
    const double f_2 = 3.0 * alpha32 * over_13;
    const double f_3 = -8.0 * omega1 * omega2 * delta22 * delta23 * over_14;
    const double f_4 = 4.0 * omega2_2 * delta22 * delta23 * over_14;
    const double f_5 = 4.0 * omega2 * alpha22 * delta23 * over_14 / omega1;
    const double f_6 = -12.0 * omega1_4 * delta21 * delta22 * over_15 / omega2;
    const double f_7 = 40.0 * omega1_3 * delta21 * delta22 * over_15;
    const double f_8 = -32.0 * omega1_2 * omega2 * delta21 * delta22 * over_15;
    const double f_9 = (4.0 * omega1_2 * alpha21 * delta22
        + 12.0 * omega1_2 * alpha22 * delta21) * over_15 / omega2;
    const double f_10 = 8.0 * omega1 * omega2_2 * delta21 * delta22 * over_15;
    const double f_11 = (-28.0 * omega1 * alpha21 * delta22 - 48.0 * omega1 * alpha22 * delta21) * over_15 / 3.0;
    const double f_12 = (16.0 * omega2 * alpha21 * delta22 + 18.0 * omega2 * alpha22 * delta21) * over_15 / 3.0;
    const double f_13 = -4.0 * alpha21 * alpha22 * over_15 / omega2;
    const double f_14 = -4.0 * omega2_2 * alpha21 * delta22 * over_15 / (3.0 * omega1);
    const double f_15 = 4.0 * alpha21 * alpha22 * over_15 / (3.0 * omega1);
    const double f_16 = -2.0 * omega2 * alpha21 * alpha22 * over_15 / (3.0 * omega1_2);
    const double f_17 = -4.0 * omega1_3 * omega2 * delta22 * delta23 * over_16;
    const double f_18 = -4.0 * omega1 * omega2 * alpha22 * delta23 * over_16;
    const double f_19 = -30.0 * omega1_3 * alpha23 * delta22 * over_17;
    const double f_20 = 12.0 * omega1_2 * omega2 * alpha23 * delta22 * over_17;
    const double f_21 = 8.0 * omega1 * omega2_2 * alpha23 * delta22 * over_17;
    const double f_22 = 18.0 * omega1 * alpha22 * alpha23 * over_17;
    const double f_23 = -4.0 * omega2_3 * alpha23 * delta22 * over_17;
    const double f_24 = -4.0 * omega2 * alpha22 * alpha23 * over_17;
    const double f_25 = -4.0 * omega2_2 * alpha22 * alpha23 * over_17 / omega1;
    const double q_1 = (f_0 + f_1 + f_2 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14 + f_15 + f_16
        + f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_1;
    const double q_3 = (f_3 + f_4 + f_5 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_3;
    const double q_4 = (f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_4;
    const double q_5 = (f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14 + f_15 + f_16 + f_17 + f_18 + f_19
        + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_5;
    const double q_6 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14
        + f_15 + f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_6;
    gradient[0] = (2.0 * f_0 + f_1 + f_3 - f_5 + 4.0 * f_6 + 3.0 * f_7 + 2.0 * f_8 + 2.0 * f_9 + f_10 + f_11 - f_14
        - f_15 - 2.0 * f_16 + 3.0 * f_17 + f_18 + 3.0 * f_19 + 2.0 * f_20 + f_21 + f_22 - f_25) / omega1 - q_1 - q_3
        - 2.0 * q_4 - 2.0 * q_5 - 3.0 * q_6;
    gradient[1] = (f_1 + f_3 + 2.0 * f_4 + f_5 - f_6 + f_8 - f_9 + 2.0 * f_10 + f_12 - f_13 + 2.0 * f_14 + f_16
        + f_17 + f_18 + f_20 + 2.0 * f_21 + 3.0 * f_23 + f_24 + 2.0 * f_25) / omega2 + q_1 + 2.0 * q_3 - q_4 + q_5
        + q_6;
    const double c_0 = (-12.0 * omega1_2 + 4.0 * omega1 * omega2
        - 2.0 * omega2_2) * over_15 / (3.0 * omega1_2 * omega2);
    const double c_1 = (12.0 * omega1_3 - 28.0 * omega1_2 * omega2 + 16.0 * omega1 * omega2_2
        - 4.0 * omega2_3) * over_15 / (3.0 * omega1 * omega2);
    const double c_2 = (18.0 * omega1_2 - 4.0 * omega1 * omega2 - 4.0 * omega2_2) * over_17 / omega1;
    const double c_3 = (12.0 * omega1_2 - 16.0 * omega1 * omega2 + 6.0 * omega2_2) * over_15 / omega2;
    const double c_4 = 4.0 * omega2 * over_14 / omega1 - 4.0 * omega1 * omega2 * over_16;
    const double c_5 = (-30.0 * omega1_3 + 12.0 * omega1_2 * omega2 + 8.0 * omega1 * omega2_2
        - 4.0 * omega2_3) * over_17;
    const double c_6 = (-12.0 * omega1_4 + 40.0 * omega1_3 * omega2 - 32.0 * omega1_2 * omega2_2
        + 8.0 * omega1 * omega2_3) * over_15 / omega2;
    const double c_7 = (-8.0 * omega1 * omega2 + 4.0 * omega2_2) * over_14 - 4.0 * omega1_3 * omega2 * over_16;
    const double c_8 = 3.0 * over_13;  // multiplies alpha32
    const double c_9 = (-3.0 * omega1_2 + 2.0 * omega1 * omega2) * over_13;  // multiplies delta32
    gradient[5] = alpha22 * c_0 + delta22 * c_1;  // by alpha21
    gradient[6] = alpha21 * c_0 + alpha23 * c_2 + delta21 * c_3 + delta23 * c_4;  // by alpha22
    gradient[7] = alpha22 * c_2 + delta22 * c_5;  // by alpha23
    gradient[8] = alpha22 * c_3 + delta22 * c_6;  // by delta21
    gradient[9] = alpha21 * c_1 + alpha23 * c_5 + delta21 * c_6 + delta23 * c_7;  // by delta22
    gradient[10] = alpha22 * c_4 + delta22 * c_7;  // by delta23
    gradient[12] = c_8;  // by alpha32
    gradient[16] = c_9;  // by delta32
  }
  void lump_harmonic_re_v1_A_v22_conjA_v1([[maybe_unused]] double* gradient) const {
    const double f_0 = (-2.0 * omega1_2 * delta22 * delta24 + omega1_2 * delta33) * per_1 / (4.0 * omega2);
    const double f_1 = omega1_2 * delta22 * alpha24 * per_1 / (6.0 * omega2_3);
    const double f_2 = (2.0 * omega1 * delta22 * delta24 - omega1 * delta33) * per_1 / 2.0;
    const double f_3 = -omega1 * delta22 * alpha24 * per_1 / (3.0 * omega2_2);
    const double f_4 = -omega2 * delta34 * per_1 / 4.0;
    const double f_5 = (2.0 * alpha22 * delta24 - alpha33) * per_1 / (4.0 * omega2);
    const double f_6 = -alpha22 * alpha24 * per_1 / (6.0 * omega2_3);
    const double f_7 = omega2 * delta23_2 * per_3;
    const double f_8 = -omega2_2 * delta23_2 * per_3 / omega1;
    const double f_9 = omega1_3 * delta22_2 * per_5 / omega2_2;
    const double f_10 = -3.0 * omega1_2 * delta22_2 * per_5 / omega2;
    const double f_11 = 2.0 * omega1 * delta22_2 * per_5;
    const double f_12 = -2.0 * omega1 * alpha22 * delta22 * per_5 / omega2_2;
    const double f_13 = 2.0 * alpha22 * delta22 * per_5 / omega2;
    const double f_14 = -alpha23_2 * over_18 / (omega1 * omega2);
    const double f_15 = alpha22_2 * over_19 / omega2_2;
    const double f_16 = -omega1_2 * omega2 * delta21 * delta23 * over_20 / 2.0;
    const double f_17 = -omega1_2 * alpha23 * delta21 * over_20 / (2.0 * omega2);
    const double f_18 = omega1 * omega2_2 * delta21 * delta23 * over_20;
    const double f_19 = omega1 * alpha23 * delta21 * over_20;
    const double f_20 = -2.0 * omega2_3 * delta21 * delta23 * over_20;
    const double f_21 = (omega2 * alpha21 * delta23 - 4.0 * omega2 * alpha23 * delta21) * over_20 / 2.0;
    const double f_22 = alpha21 * alpha23 * over_20 / (2.0 * omega2);
    const double q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_14 + f_15 + f_16 + f_17 + f_18 + f_19 + f_20
        + f_21 + f_22) * per_1;
    const double q_2 = (f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22) * per_2;
    const double q_3 = (f_7 + f_8 + f_14 + f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22) * per_3;
    const double q_5 = (f_9 + f_10 + f_11 + f_12 + f_13 + f_15) * per_5;
    gradient[0] = (2.0 * f_0 + 2.0 * f_1 + f_2 + f_3 - f_8 + 3.0 * f_9 + 2.0 * f_10 + f_11 + f_12 - f_14
        + 2.0 * f_16 + 2.0 * f_17 + f_18 + f_19) / omega1 - q_1 - q_2 - q_3 - 2.0 * q_5;
    gradient[1] = (-f_0 - 3.0 * f_1 - 2.0 * f_3 + f_4 - f_5 - 3.0 * f_6 + f_7 + 2.0 * f_8 - 2.0 * f_9 - f_10
        - 2.0 * f_12 - f_13 - f_14 - 2.0 * f_15 + f_16 - f_17 + 2.0 * f_18 + 3.0 * f_20 + f_21 - f_22) / omega2
        + q_1 - 2.0 * q_2 + 2.0 * q_3 + q_5;
    const double c_0 = over_20 / (2.0 * omega2);  // multiplies alpha21*alpha23
    const double c_1 = omega2 * over_20 / 2.0;  // multiplies alpha21*delta23
    const double c_2 = over_19 / omega2_2;  // multiplies alpha22^2
    const double c_3 = (-2.0 * omega1 + 2.0 * omega2) * per_5 / omega2_2;  // multiplies alpha22*delta22
    const double c_4 = -per_1 / (6.0 * omega2_3);  // multiplies alpha22*alpha24
    const double c_5 = per_1 / (2.0 * omega2);  // multiplies alpha22*delta24
    const double c_6 = -over_18 / (omega1 * omega2);  // multiplies alpha23^2
    const double c_7 = (-omega1_2 + 2.0 * omega1 * omega2 - 4.0 * omega2_2) * over_20 / (2.0 * omega2);
    const double c_8 = (-omega1_2 * omega2 + 2.0 * omega1 * omega2_2 - 4.0 * omega2_3) * over_20 / 2.0;
    const double c_9 = (omega1_3 - 3.0 * omega1_2 * omega2 + 2.0 * omega1 * omega2_2) * per_5 / omega2_2;
    const double c_10 = (omega1_2 - 2.0 * omega1 * omega2) * per_1 / (6.0 * omega2_3);
    const double c_11 = (-omega1_2 + 2.0 * omega1 * omega2) * per_1 / (2.0 * omega2);  // multiplies delta22*delta24
    const double c_12 = (omega1 * omega2 - omega2_2) * per_3 / omega1;  // multiplies delta23^2
    const double c_13 = -per_1 / (4.0 * omega2);  // multiplies alpha33
    const double c_14 = (omega1_2 - 2.0 * omega1 * omega2) * per_1 / (4.0 * omega2);  // multiplies delta33
    const double c_15 = -omega2 * per_1 / 4.0;  // multiplies delta34
    gradient[5] = alpha23 * c_0 + delta23 * c_1;  // by alpha21
    gradient[6] = 2.0 * alpha22 * c_2 + delta22 * c_3 + alpha24 * c_4 + delta24 * c_5;  // by alpha22
    gradient[7] = alpha21 * c_0 + 2.0 * alpha23 * c_6 + delta21 * c_7;  // by alpha23
    gradient[8] = alpha23 * c_7 + delta23 * c_8;  // by delta21
    gradient[9] = alpha22 * c_3 + 2.0 * delta22 * c_9 + alpha24 * c_10 + delta24 * c_11;  // by delta22
    gradient[10] = alpha21 * c_1 + delta21 * c_8 + 2.0 * delta23 * c_12;  // by delta23
    gradient[13] = c_13;  // by alpha33
    gradient[17] = c_14;  // by delta33
    gradient[18] = c_15;  // by delta34
    gradient[25] = alpha22 * c_4 + delta22 * c_10;  // by alpha24
    gradient[26] = alpha22 * c_5 + delta22 * c_11;  // by delta24
  }
  void lump_harmonic_re_v1_A_v22_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -delta23 * eta22 * per_3 / (4.0 * omega1);
    const double f_1 = alpha23 * eta22 * over_18 / (4.0 * omega1 * omega2);
    const double f_2 = -omega2 * delta23 * eta12 * over_20 / 8.0;
    const double f_3 = -alpha23 * eta12 * over_20 / (8.0 * omega2);
    const double q_1 = (f_1 + f_2 + f_3) * per_1;
    const double q_2 = (f_2 + f_3) * per_2;
    const double q_3 = (f_0 + f_1 + f_2 + f_3) * per_3;
    gradient[0] = (-f_0 - f_1) / omega1 - q_1 - q_2 - q_3;  // by omega1
    gradient[1] = (-f_1 + f_2 - f_3) / omega2 + q_1 - 2.0 * q_2 + 2.0 * q_3;  // by omega2
    const double c_0 = -over_20 / (8.0 * omega2);  // multiplies alpha23*eta12
    const double c_1 = over_18 / (4.0 * omega1 * omega2);  // multiplies alpha23*eta22
    const double c_2 = -omega2 * over_20 / 8.0;  // multiplies delta23*eta12
    const double c_3 = -per_3 / (4.0 * omega1);  // multiplies delta23*eta22
    gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
    gradient[10] = eta12 * c_2 + eta22 * c_3;  // by delta23
    gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
    gradient[30] = alpha23 * c_1 + delta23 * c_3;  // by eta22
  }
  void lump_harmonic_re_v1_A_v1_A_v22([[maybe_unused]] double* gradient) const {
    const double f_0 = (2.0 * omega1_2 * delta22 * delta24 - omega1_2 * delta33) * per_0 / (4.0 * omega2);
    const double f_1 = -omega1_2 * delta22 * alpha24 * per_0 / (6.0 * omega2_3);
    const double f_2 = (2.0 * omega1 * delta22 * delta24 - omega1 * delta33) * per_0 / 2.0;
    const double f_3 = -omega1 * delta22 * alpha24 * per_0 / (3.0 * omega2_2);
    const double f_4 = omega2 * delta34 * per_0 / 4.0;
    const double f_5 = (-2.0 * alpha22 * delta24 + alpha33) * per_0 / (4.0 * omega2);
    const double f_6 = alpha22 * alpha24 * per_0 / (6.0 * omega2_3);
    const double f_7 = -omega2 * delta23_2 * per_2;
    const double f_8 = -omega2_2 * delta23_2 * per_2 / omega1;
    const double f_9 = omega1_3 * delta22_2 * per_4 / omega2_2;
    const double f_10 = 3.0 * omega1_2 * delta22_2 * per_4 / omega2;
    const double f_11 = 2.0 * omega1 * delta22_2 * per_4;
    const double f_12 = -2.0 * omega1 * alpha22 * delta22 * per_4 / omega2_2;
    const double f_13 = -2.0 * alpha22 * delta22 * per_4 / omega2;
    const double f_14 = alpha23_2 * over_21 / (omega1 * omega2);
    const double f_15 = alpha22_2 * over_22 / omega2_2;
    const double f_16 = omega1_2 * omega2 * delta21 * delta23 * over_23 / 2.0;
    const double f_17 = omega1_2 * alpha23 * delta21 * over_23 / (2.0 * omega2);
    const double f_18 = omega1 * omega2_2 * delta21 * delta23 * over_23;
    const double f_19 = omega1 * alpha23 * delta21 * over_23;
    const double f_20 = 2.0 * omega2_3 * delta21 * delta23 * over_23;
    const double f_21 = (-omega2 * alpha21 * delta23 + 4.0 * omega2 * alpha23 * delta21) * over_23 / 2.0;
    const double f_22 = -alpha21 * alpha23 * over_23 / (2.0 * omega2);
    const double q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_14 + f_15 + f_16 + f_17 + f_18 + f_19 + f_20
        + f_21 + f_22) * per_0;
    const double q_2 = (f_7 + f_8 + f_14 + f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22) * per_2;
    const double q_3 = (f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22) * per_3;
    const double q_4 = (f_9 + f_10 + f_11 + f_12 + f_13 + f_15) * per_4;
    gradient[0] = (2.0 * f_0 + 2.0 * f_1 + f_2 + f_3 - f_8 + 3.0 * f_9 + 2.0 * f_10 + f_11 + f_12 - f_14
        + 2.0 * f_16 + 2.0 * f_17 + f_18 + f_19) / omega1 - q_0 - q_2 - q_3 - 2.0 * q_4;
    gradient[1] = (-f_0 - 3.0 * f_1 - 2.0 * f_3 + f_4 - f_5 - 3.0 * f_6 + f_7 + 2.0 * f_8 - 2.0 * f_9 - f_10
        - 2.0 * f_12 - f_13 - f_14 - 2.0 * f_15 + f_16 - f_17 + 2.0 * f_18 + 3.0 * f_20 + f_21 - f_22) / omega2
        - q_0 - 2.0 * q_2 + 2.0 * q_3 - q_4;
    const double c_0 = -over_23 / (2.0 * omega2);  // multiplies alpha21*alpha23
    const double c_1 = -omega2 * over_23 / 2.0;  // multiplies alpha21*delta23
    const double c_2 = over_22 / omega2_2;  // multiplies alpha22^2
    const double c_3 = (-2.0 * omega1 - 2.0 * omega2) * per_4 / omega2_2;  // multiplies alpha22*delta22
    const double c_4 = per_0 / (6.0 * omega2_3);  // multiplies alpha22*alpha24
    const double c_5 = -per_0 / (2.0 * omega2);  // multiplies alpha22*delta24
    const double c_6 = over_21 / (omega1 * omega2);  // multiplies alpha23^2
    const double c_7 = (omega1_2 + 2.0 * omega1 * omega2 + 4.0 * omega2_2) * over_23 / (2.0 * omega2);
    const double c_8 = (omega1_2 * omega2 + 2.0 * omega1 * omega2_2 + 4.0 * omega2_3) * over_23 / 2.0;
    const double c_9 = (omega1_3 + 3.0 * omega1_2 * omega2 + 2.0 * omega1 * omega2_2) * per_4 / omega2_2;
    const double c_10 = (-omega1_2 - 2.0 * omega1 * omega2) * per_0 / (6.0 * omega2_3);
    const double c_11 = (omega1_2 + 2.0 * omega1 * omega2) * per_0 / (2.0 * omega2);  // multiplies delta22*delta24
    const double c_12 = (-omega1 * omega2 - omega2_2) * per_2 / omega1;  // multiplies delta23^2
    const double c_13 = per_0 / (4.0 * omega2);  // multiplies alpha33
    const double c_14 = (-omega1_2 - 2.0 * omega1 * omega2) * per_0 / (4.0 * omega2);  // multiplies delta33
    const double c_15 = omega2 * per_0 / 4.0;  // multiplies delta34
    gradient[5] = alpha23 * c_0 + delta23 * c_1;  // by alpha21
    gradient[6] = 2.0 * alpha22 * c_2 + delta22 * c_3 + alpha24 * c_4 + delta24 * c_5;  // by alpha22
    gradient[7] = alpha21 * c_0 + 2.0 * alpha23 * c_6 + delta21 * c_7;  // by alpha23
    gradient[8] = alpha23 * c_7 + delta23 * c_8;  // by delta21
    gradient[9] = alpha22 * c_3 + 2.0 * delta22 * c_9 + alpha24 * c_10 + delta24 * c_11;  // by delta22
    gradient[10] = alpha21 * c_1 + delta21 * c_8 + 2.0 * delta23 * c_12;  // by delta23
    gradient[13] = c_13;  // by alpha33
    gradient[17] = c_14;  // by delta33
    gradient[18] = c_15;  // by delta34
    gradient[25] = alpha22 * c_4 + delta22 * c_10;  // by alpha24
    gradient[26] = alpha22 * c_5 + delta22 * c_11;  // by delta24
  }
  void lump_harmonic_re_v1_A_v23([[maybe_unused]] double* gradient) const {
    const double f_0 = (4.0 * omega2_2 * delta23 * delta24 - omega2_2 * delta35) * over_24;
    const double f_1 = (6.0 * alpha23 * delta24 - 4.0 * delta23 * alpha24 - 3.0 * alpha34) * over_24 / 3.0;
    const double f_2 = -2.0 * alpha23 * alpha24 * over_24 / (3.0 * omega2_2);
    const double f_3 = -12.0 * omega2_4 * delta22 * delta23 * over_25;
    const double f_4 = (2.0 * omega2_2 * alpha22 * delta23 - 12.0 * omega2_2 * alpha23 * delta22) * over_25;
    const double f_5 = 2.0 * alpha22 * alpha23 * over_25;
    const double q_2 = (f_3 + f_4 + f_5) * per_2;
    const double q_3 = (f_3 + f_4 + f_5) * per_3;
    const double q_7 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_7;
    const double q_8 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_8;
    gradient[0] = -q_2 - q_3 - q_7 - q_8;  // by omega1
    gradient[1] = (2.0 * f_0 - 2.0 * f_2 + 4.0 * f_3 + 2.0 * f_4) / omega2 - 2.0 * q_2 + 2.0 * q_3 - 3.0 * q_7
        + 3.0 * q_8;
    const double c_0 = 2.0 * over_25;  // multiplies alpha22*alpha23
    const double c_1 = 2.0 * omega2_2 * over_25;  // multiplies alpha22*delta23
    const double c_2 = -12.0 * omega2_2 * over_25;  // multiplies alpha23*delta22
    const double c_3 = -2.0 * over_24 / (3.0 * omega2_2);  // multiplies alpha23*alpha24
    const double c_4 = 2.0 * over_24;  // multiplies alpha23*delta24
    const double c_5 = -12.0 * omega2_4 * over_25;  // multiplies delta22*delta23
    const double c_6 = -4.0 * over_24 / 3.0;  // multiplies delta23*alpha24
    const double c_7 = 4.0 * omega2_2 * over_24;  // multiplies delta23*delta24
    const double c_8 = -over_24;  // multiplies alpha34
    const double c_9 = -omega2_2 * over_24;  // multiplies delta35
    gradient[6] = alpha23 * c_0 + delta23 * c_1;  // by alpha22
    gradient[7] = alpha22 * c_0 + delta22 * c_2 + alpha24 * c_3 + delta24 * c_4;  // by alpha23
    gradient[9] = alpha23 * c_2 + delta23 * c_5;  // by delta22
    gradient[10] = alpha22 * c_1 + delta22 * c_5 + alpha24 * c_6 + delta24 * c_7;  // by delta23
    gradient[14] = c_8;  // by alpha34
    gradient[19] = c_9;  // by delta35
    gradient[25] = alpha23 * c_3 + delta23 * c_6;  // by alpha24
    gradient[26] = alpha23 * c_4 + delta23 * c_7;  // by delta24
  }
  void lump_harmonic_re_v1_A_v12_F([[maybe_unused]] double* gradient) const {
    gradient[0] = (-17.0 * omega1_2 * delta21 * eta12 + 6.0 * alpha21 * eta12) / (24.0 * omega1_5);  // by omega1
    gradient[5] = -eta12 / (16.0 * omega1_4);  // by alpha21
    gradient[8] = 17.0 * eta12 / (48.0 * omega1_2);  // by delta21
    gradient[21] = (17.0 * omega1_2 * delta21 - 3.0 * alpha21) / (48.0 * omega1_4);  // by eta12
  }
  void lump_harmonic_re_v1_A_v13([[maybe_unused]] double* gradient) const {
    const double f_1 = (-20.0 * alpha21 * delta21 + 3.0 * alpha31) / (24.0 * omega1_2);
    const double f_2 = alpha21_2 / (12.0 * omega1_4);
    const double f_3 = -3.0 * omega1_2 * delta22_2 * over_2 / 4.0;
    const double f_4 = -alpha22 * delta22 * over_2 / 2.0;
    const double f_5 = alpha22_2 * over_2 / (4.0 * omega1_2);
    const double q_4 = (f_3 + f_4 + f_5) * per_4;
    const double q_5 = (f_3 + f_4 + f_5) * per_5;
    gradient[0] = (-2.0 * f_1 - 4.0 * f_2 + 2.0 * f_3 - 2.0 * f_5) / omega1 - 2.0 * q_4 - 2.0 * q_5;  // by omega1
    gradient[1] = -q_4 + q_5;  // by omega2
    const double c_0 = 1.0 / (12.0 * omega1_4);  // multiplies alpha21^2
    const double c_1 = -5.0 / (6.0 * omega1_2);  // multiplies alpha21*delta21
    const double c_2 = over_2 / (4.0 * omega1_2);  // multiplies alpha22^2
    const double c_3 = -over_2 / 2.0;  // multiplies alpha22*delta22
    const double c_4 = 7.0 / 4.0;  // multiplies delta21^2
    const double c_5 = -3.0 * omega1_2 * over_2 / 4.0;  // multiplies delta22^2
    const double c_6 = 1.0 / (8.0 * omega1_2);  // multiplies alpha31
    const double c_7 = -1.0 / 4.0;  // multiplies delta31
    gradient[5] = 2.0 * alpha21 * c_0 + delta21 * c_1;  // by alpha21
    gradient[6] = 2.0 * alpha22 * c_2 + delta22 * c_3;  // by alpha22
    gradient[8] = alpha21 * c_1 + 2.0 * delta21 * c_4;  // by delta21
    gradient[9] = alpha22 * c_3 + 2.0 * delta22 * c_5;  // by delta22
    gradient[11] = c_6;  // by alpha31
    gradient[15] = c_7;  // by delta31
  }
  void lump_harmonic_re_v1_A_v12_A_v2([[maybe_unused]] double* gradient) const {
    const double f_0 = -3.0 * omega1_2 * delta32 * over_26;
    const double f_1 = -2.0 * omega1 * omega2 * delta32 * over_26;
    const double f_2 = 3.0 * alpha32 * over_26;
    const double f_3 = 8.0 * omega1 * omega2 * delta22 * delta23 * over_27;
    const double f_4 = 4.0 * omega2_2 * delta22 * delta23 * over_27;
    const double f_5 = -4.0 * omega2 * alpha22 * delta23 * over_27 / omega1;
    const double f_6 = 12.0 * omega1_4 * delta21 * delta22 * over_28 / omega2;
    const double f_7 = 40.0 * omega1_3 * delta21 * delta22 * over_28;
    const double f_8 = 32.0 * omega1_2 * omega2 * delta21 * delta22 * over_28;
    const double f_9 = (-4.0 * omega1_2 * alpha21 * delta22
        - 12.0 * omega1_2 * alpha22 * delta21) * over_28 / omega2;
    const double f_10 = 8.0 * omega1 * omega2_2 * delta21 * delta22 * over_28;
    const double f_11 = (-28.0 * omega1 * alpha21 * delta22 - 48.0 * omega1 * alpha22 * delta21) * over_28 / 3.0;
    const double f_12 = (-16.0 * omega2 * alpha21 * delta22 - 18.0 * omega2 * alpha22 * delta21) * over_28 / 3.0;
    const double f_13 = 4.0 * alpha21 * alpha22 * over_28 / omega2;
    const double f_14 = -4.0 * omega2_2 * alpha21 * delta22 * over_28 / (3.0 * omega1);
    const double f_15 = 4.0 * alpha21 * alpha22 * over_28 / (3.0 * omega1);
    const double f_16 = 2.0 * omega2 * alpha21 * alpha22 * over_28 / (3.0 * omega1_2);
    const double f_17 = 4.0 * omega1_3 * omega2 * delta22 * delta23 * over_29;
    const double f_18 = 4.0 * omega1 * omega2 * alpha22 * delta23 * over_29;
    const double f_19 = -30.0 * omega1_3 * alpha23 * delta22 * over_30;
    const double f_20 = -12.0 * omega1_2 * omega2 * alpha23 * delta22 * over_30;
    const double f_21 = 8.0 * omega1 * omega2_2 * alpha23 * delta22 * over_30;
    const double f_22 = 18.0 * omega1 * alpha22 * alpha23 * over_30;
    const double f_23 = 4.0 * omega2_3 * alpha23 * delta22 * over_30;
    const double f_24 = 4.0 * omega2 * alpha22 * alpha23 * over_30;
    const double f_25 = -4.0 * omega2_2 * alpha22 * alpha23 * over_30 / omega1;
    const double q_0 = (f_0 + f_1 + f_2 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14 + f_15 + f_16
        + f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_0;
    const double q_2 = (f_3 + f_4 + f_5 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_2;
    const double q_4 = (f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14 + f_15 + f_16 + f_17 + f_18 + f_19
        + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_4;
    const double q_5 = (f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_5;
    const double q_9 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14
        + f_15 + f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_9;
    gradient[0] = (2.0 * f_0 + f_1 + f_3 - f_5 + 4.0 * f_6 + 3.0 * f_7 + 2.0 * f_8 + 2.0 * f_9 + f_10 + f_11 - f_14
        - f_15 - 2.0 * f_16 + 3.0 * f_17 + f_18 + 3.0 * f_19 + 2.0 * f_20 + f_21 + f_22 - f_25) / omega1 - q_0 - q_2
        - 2.0 * q_4 - 2.0 * q_5 - 3.0 * q_9;
    gradient[1] = (f_1 + f_3 + 2.0 * f_4 + f_5 - f_6 + f_8 - f_9 + 2.0 * f_10 + f_12 - f_13 + 2.0 * f_14 + f_16
        + f_17 + f_18 + f_20 + 2.0 * f_21 + 3.0 * f_23 + f_24 + 2.0 * f_25) / omega2 - q_0 - 2.0 * q_2 - q_4 + q_5
        - q_9;
    const double c_0 = (12.0 * omega1_2 + 4.0 * omega1 * omega2
        + 2.0 * omega2_2) * over_28 / (3.0 * omega1_2 * omega2);
    const double c_1 = (-12.0 * omega1_3 - 28.0 * omega1_2 * omega2 - 16.0 * omega1 * omega2_2
        - 4.0 * omega2_3) * over_28 / (3.0 * omega1 * omega2);
    const double c_2 = (18.0 * omega1_2 + 4.0 * omega1 * omega2 - 4.0 * omega2_2) * over_30 / omega1;
    const double c_3 = (-12.0 * omega1_2 - 16.0 * omega1 * omega2 - 6.0 * omega2_2) * over_28 / omega2;
    const double c_4 = -4.0 * omega2 * over_27 / omega1 + 4.0 * omega1 * omega2 * over_29;
    const double c_5 = (-30.0 * omega1_3 - 12.0 * omega1_2 * omega2 + 8.0 * omega1 * omega2_2
        + 4.0 * omega2_3) * over_30;
    const double c_6 = (12.0 * omega1_4 + 40.0 * omega1_3 * omega2 + 32.0 * omega1_2 * omega2_2
        + 8.0 * omega1 * omega2_3) * over_28 / omega2;
    const double c_7 = (8.0 * omega1 * omega2 + 4.0 * omega2_2) * over_27 + 4.0 * omega1_3 * omega2 * over_29;
    const double c_8 = 3.0 * over_26;  // multiplies alpha32
    const double c_9 = (-3.0 * omega1_2 - 2.0 * omega1 * omega2) * over_26;  // multiplies delta32
    gradient[5] = alpha22 * c_0 + delta22 * c_1;  // by alpha21
    gradient[6] = alpha21 * c_0 + alpha23 * c_2 + delta21 * c_3 + delta23 * c_4;  // by alpha22
    gradient[7] = alpha22 * c_2 + delta22 * c_5;  // by alpha23
    gradient[8] = alpha22 * c_3 + delta22 * c_6;  // by delta21
    gradient[9] = alpha21 * c_1 + alpha23 * c_5 + delta21 * c_6 + delta23 * c_7;  // by delta22
    gradient[10] = alpha22 * c_4 + delta22 * c_7;  // by delta23
    gradient[12] = c_8;  // by alpha32
    gradient[16] = c_9;  // by delta32
  }
  void lump_harmonic_re_v2_A_v2_conjA_v1([[maybe_unused]] double* gradient) const {
    const double f_0 = 2.0 * omega2 * delta23 * per_3;
    const double f_1 = -2.0 * omega2_2 * delta23 * per_3 / omega1;
    const double f_2 = 2.0 * alpha23 * per_3 / omega1;
    const double q_3 = (f_0 + f_1 + f_2) * per_3;
    gradient[0] = (-f_1 - f_2) / omega1 - q_3;  // by omega1
    gradient[1] = (f_0 + 2.0 * f_1) / omega2 + 2.0 * q_3;  // by omega2
    const double c_0 = 2.0 * per_3 / omega1;  // multiplies alpha23
    const double c_1 = (2.0 * omega1 * omega2 - 2.0 * omega2_2) * per_3 / omega1;  // multiplies delta23
    gradient[7] = c_0;  // by alpha23
    gradient[10] = c_1;  // by delta23
  }
  void lump_eta22([[maybe_unused]] double* gradient) const { gradient[30] = 1.0; }
  void lump_harmonic_im_v2_A_v2_conjA_v1([[maybe_unused]] double* gradient) const {
    const double f_0 = -2.0 * omega1_2 * delta22 * mu21 * over_3 / omega2;
    const double f_1 = 4.0 * omega1 * delta22 * mu21 * over_3;
    const double f_2 = -2.0 * omega2 * delta22 * mu21 * over_3;
    const double f_3 = 2.0 * alpha22 * mu21 * over_3 / omega2;
    const double f_4 = -2.0 * alpha22 * mu21 * over_3 / omega1;
    const double f_5 = 2.0 * omega1_2 * mu21 * delta24 * over_10;
    const double f_6 = -2.0 * omega1 * omega2 * mu21 * delta24 * over_10;
    const double f_7 = (2.0 * omega2_2 * mu12 * delta22 + 2.0 * omega2_2 * mu21 * delta24) * over_10;
    const double f_8 = -2.0 * mu21 * alpha24 * over_10;
    const double f_9 = -2.0 * omega2 * mu12 * alpha22 * over_10 / omega1;
    const double q_0 = (f_5 + f_6 + f_7 + f_8 + f_9) * per_0;
    const double q_1 = (f_5 + f_6 + f_7 + f_8 + f_9) * per_1;
    const double q_3 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_3;
    const double q_5 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_5;
    gradient[0] = (2.0 * f_0 + f_1 - f_4 + 2.0 * f_5 + f_6 - f_9) / omega1 - q_0 - q_1 - q_3 - 2.0 * q_5;
    gradient[1] = (-f_0 + f_2 - f_3 + f_6 + 2.0 * f_7 + f_9) / omega2 - q_0 + q_1 + 2.0 * q_3 + q_5;  // by omega2
    const double c_0 = -2.0 * omega2 * over_10 / omega1;  // multiplies mu12*alpha22
    const double c_1 = 2.0 * omega2_2 * over_10;  // multiplies mu12*delta22
    const double c_2 = (2.0 * omega1 - 2.0 * omega2) * over_3 / (omega1 * omega2);  // multiplies alpha22*mu21
    const double c_3 = (-2.0 * omega1_2 + 4.0 * omega1 * omega2 - 2.0 * omega2_2) * over_3 / omega2;
    const double c_4 = -2.0 * over_10;  // multiplies mu21*alpha24
    const double c_5 = (2.0 * omega1_2 - 2.0 * omega1 * omega2 + 2.0 * omega2_2) * over_10;
    gradient[3] = alpha22 * c_0 + delta22 * c_1;  // by mu12
    gradient[6] = mu12 * c_0 + mu21 * c_2;  // by alpha22
    gradient[9] = mu12 * c_1 + mu21 * c_3;  // by delta22
    gradient[23] = alpha22 * c_2 + delta22 * c_3 + alpha24 * c_4 + delta24 * c_5;  // by mu21
    gradient[25] = mu21 * c_4;  // by alpha24
    gradient[26] = mu21 * c_5;  // by delta24
  }
  void lump_harmonic_re_v2_A_v2_conjA_v2([[maybe_unused]] double* gradient) const {
    gradient[1] = 4.0 * alpha24 / omega2_3;  // by omega2
    gradient[25] = -2.0 / omega2_2;  // by alpha24
    gradient[26] = 2.0;  // by delta24
  }
  void lump_harmonic_re_v2_A_v1_conjA_v1([[maybe_unused]] double* gradient) const {
    gradient[0] = 4.0 * omega1 * delta22 / omega2_2;  // by omega1
    gradient[1] = (-4.0 * omega1_2 * delta22 + 4.0 * alpha22) / omega2_3;  // by omega2
    gradient[6] = -2.0 / omega2_2;  // by alpha22
    gradient[9] = 2.0 * omega1_2 / omega2_2;  // by delta22
  }
  void lump_harmonic_im_v2_conjA_v1_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -omega1 * mu21 * eta22 * over_0 / (2.0 * omega2_2);
    const double q_0 = f_0 * per_0;
    const double q_1 = f_0 * per_1;
    gradient[0] = f_0 / omega1 - q_0 - q_1;  // by omega1
    gradient[1] = -2.0 * f_0 / omega2 - q_0 + q_1;  // by omega2
    const double c_0 = -omega1 * over_0 / (2.0 * omega2_2);  // multiplies mu21*eta22
    gradient[23] = eta22 * c_0;  // by mu21
    gradient[30] = mu21 * c_0;  // by eta22
  }
  void lump_harmonic_re_v2_A_v1_A_v2([[maybe_unused]] double* gradient) const {
    const double f_0 = -2.0 * omega2 * delta23 * per_2;
    const double f_1 = -2.0 * omega2_2 * delta23 * per_2 / omega1;
    const double f_2 = 2.0 * alpha23 * per_2 / omega1;
    const double q_2 = (f_0 + f_1 + f_2) * per_2;
    gradient[0] = (-f_1 - f_2) / omega1 - q_2;  // by omega1
    gradient[1] = (f_0 + 2.0 * f_1) / omega2 - 2.0 * q_2;  // by omega2
    const double c_0 = 2.0 * per_2 / omega1;  // multiplies alpha23
    const double c_1 = (-2.0 * omega1 * omega2 - 2.0 * omega2_2) * per_2 / omega1;  // multiplies delta23
    gradient[7] = c_0;  // by alpha23
    gradient[10] = c_1;  // by delta23
  }
  void lump_harmonic_im_v2_A_v1_A_v2([[maybe_unused]] double* gradient) const {
    const double f_0 = -2.0 * omega1_2 * delta22 * mu21 * over_12 / omega2;
    const double f_1 = -4.0 * omega1 * delta22 * mu21 * over_12;
    const double f_2 = -2.0 * omega2 * delta22 * mu21 * over_12;
    const double f_3 = 2.0 * alpha22 * mu21 * over_12 / omega2;
    const double f_4 = 2.0 * alpha22 * mu21 * over_12 / omega1;
    const double f_5 = -2.0 * omega1_2 * mu21 * delta24 * over_6;
    const double f_6 = -2.0 * omega1 * omega2 * mu21 * delta24 * over_6;
    const double f_7 = (-2.0 * omega2_2 * mu12 * delta22 - 2.0 * omega2_2 * mu21 * delta24) * over_6;
    const double f_8 = 2.0 * mu21 * alpha24 * over_6;
    const double f_9 = -2.0 * omega2 * mu12 * alpha22 * over_6 / omega1;
    const double q_0 = (f_5 + f_6 + f_7 + f_8 + f_9) * per_0;
    const double q_1 = (f_5 + f_6 + f_7 + f_8 + f_9) * per_1;
    const double q_2 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_2;
    const double q_4 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_4;
    gradient[0] = (2.0 * f_0 + f_1 - f_4 + 2.0 * f_5 + f_6 - f_9) / omega1 - q_0 - q_1 - q_2 - 2.0 * q_4;
    gradient[1] = (-f_0 + f_2 - f_3 + f_6 + 2.0 * f_7 + f_9) / omega2 - q_0 + q_1 - 2.0 * q_2 - q_4;  // by omega2
    const double c_0 = -2.0 * omega2 * over_6 / omega1;  // multiplies mu12*alpha22
    const double c_1 = -2.0 * omega2_2 * over_6;  // multiplies mu12*delta22
    const double c_2 = (2.0 * omega1 + 2.0 * omega2) * over_12 / (omega1 * omega2);  // multiplies alpha22*mu21
    const double c_3 = (-2.0 * omega1_2 - 4.0 * omega1 * omega2 - 2.0 * omega2_2) * over_12 / omega2;
    const double c_4 = 2.0 * over_6;  // multiplies mu21*alpha24
    const double c_5 = (-2.0 * omega1_2 - 2.0 * omega1 * omega2 - 2.0 * omega2_2) * over_6;
    gradient[3] = alpha22 * c_0 + delta22 * c_1;  // by mu12
    gradient[6] = mu12 * c_0 + mu21 * c_2;  // by alpha22
    gradient[9] = mu12 * c_1 + mu21 * c_3;  // by delta22
    gradient[23] = alpha22 * c_2 + delta22 * c_3 + alpha24 * c_4 + delta24 * c_5;  // by mu21
    gradient[25] = mu21 * c_4;  // by alpha24
    gradient[26] = mu21 * c_5;  // by delta24
  }
  void lump_harmonic_re_v2_A_v22([[maybe_unused]] double* gradient) const {
    gradient[1] = -2.0 * alpha24 / (3.0 * omega2_3);  // by omega2
    gradient[25] = 1.0 / (3.0 * omega2_2);  // by alpha24
    gradient[26] = -1.0;  // by delta24
  }
  void lump_harmonic_im_v2_A_v22([[maybe_unused]] double* gradient) const {
    const double f_0 = 4.0 * omega2 * mu12 * delta23 * over_0 / 3.0;
    const double f_1 = -2.0 * mu12 * alpha23 * over_0 / (3.0 * omega2);
    const double f_2 = -2.0 * omega2 * delta23 * mu21 * over_1 / 3.0;
    const double f_3 = -2.0 * alpha23 * mu21 * over_1 / (3.0 * omega2);
    const double q_0 = (f_0 + f_1) * per_0;
    const double q_1 = (f_0 + f_1) * per_1;
    const double q_2 = (f_2 + f_3) * per_2;
    const double q_3 = (f_2 + f_3) * per_3;
    gradient[0] = -q_0 - q_1 - q_2 - q_3;  // by omega1
    gradient[1] = (f_0 - f_1 + f_2 - f_3) / omega2 - q_0 + q_1 - 2.0 * q_2 + 2.0 * q_3;  // by omega2
    const double c_0 = -2.0 * over_0 / (3.0 * omega2);  // multiplies mu12*alpha23
    const double c_1 = 4.0 * omega2 * over_0 / 3.0;  // multiplies mu12*delta23
    const double c_2 = -2.0 * over_1 / (3.0 * omega2);  // multiplies alpha23*mu21
    const double c_3 = -2.0 * omega2 * over_1 / 3.0;  // multiplies delta23*mu21
    gradient[3] = alpha23 * c_0 + delta23 * c_1;  // by mu12
    gradient[7] = mu12 * c_0 + mu21 * c_2;  // by alpha23
    gradient[10] = mu12 * c_1 + mu21 * c_3;  // by delta23
    gradient[23] = alpha23 * c_2 + delta23 * c_3;  // by mu21
  }
  void lump_mu21([[maybe_unused]] double* gradient) const { gradient[23] = 1.0; }
  void lump_eta21([[maybe_unused]] double* gradient) const { gradient[29] = 1.0; }
  void lump_harmonic_re_v2_A_v2_conjA_v2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = omega1_2 * delta24 * eta22 * over_7;
    const double f_1 = omega1_2 * alpha24 * eta22 * over_7 / omega2_2;
    const double f_2 = 2.0 * omega2_2 * delta24 * eta22 * over_7;
    const double f_3 = -6.0 * alpha24 * eta22 * over_7;
    const double q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
    const double q_1 = (f_0 + f_1 + f_2 + f_3) * per_1;
    const double q_2 = (f_0 + f_1 + f_2 + f_3) * per_2;
    const double q_3 = (f_0 + f_1 + f_2 + f_3) * per_3;
    gradient[0] = (2.0 * f_0 + 2.0 * f_1) / omega1 - q_0 - q_1 - q_2 - q_3;  // by omega1
    gradient[1] = (-2.0 * f_1 + 2.0 * f_2) / omega2 - q_0 + q_1 - 2.0 * q_2 + 2.0 * q_3;  // by omega2
    const double c_0 = (omega1_2 - 6.0 * omega2_2) * over_7 / omega2_2;  // multiplies alpha24*eta22
    const double c_1 = (omega1_2 + 2.0 * omega2_2) * over_7;  // multiplies delta24*eta22
    gradient[25] = eta22 * c_0;  // by alpha24
    gradient[26] = eta22 * c_1;  // by delta24
    gradient[30] = alpha24 * c_0 + delta24 * c_1;  // by eta22
  }
  void lump_harmonic_re_v2_A_v1_conjA_v1_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -omega1_2 * delta22 * eta22 * over_0 / omega2_2;
    const double f_1 = 2.0 * delta22 * eta12 * over_0 / 3.0;
    const double f_2 = alpha22 * eta22 * over_0 / omega2_2;
    const double f_3 = 2.0 * alpha22 * eta12 * over_0 / (3.0 * omega1_2);
    const double q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
    const double q_1 = (f_0 + f_1 + f_2 + f_3) * per_1;
    gradient[0] = (2.0 * f_0 - 2.0 * f_3) / omega1 - q_0 - q_1;  // by omega1
    gradient[1] = (-2.0 * f_0 - 2.0 * f_2) / omega2 - q_0 + q_1;  // by omega2
    const double c_0 = 2.0 * over_0 / (3.0 * omega1_2);  // multiplies alpha22*eta12
    const double c_1 = over_0 / omega2_2;  // multiplies alpha22*eta22
    const double c_2 = 2.0 * over_0 / 3.0;  // multiplies delta22*eta12
    const double c_3 = -omega1_2 * over_0 / omega2_2;  // multiplies delta22*eta22
    gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
    gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
    gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
    gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  }
  void lump_harmonic_re_v2_A_v1_A_v2_conjA_v2([[maybe_unused]] double* gradient) const {
    const double f_0 = -2.0 * omega2_2 * delta35 * over_0;
    const double f_1 = 6.0 * alpha34 * over_0;
    const double f_2 = -4.0 * omega1_2 * alpha23 * delta24 * over_7;
    const double f_3 = -4.0 * omega1_2 * alpha23 * alpha24 * over_7 / omega2_2;
    const double f_4 = -24.0 * omega2_4 * delta23 * delta24 * over_7;
    const double f_5 = (-8.0 * omega2_2 * alpha23 * delta24 + 8.0 * omega2_2 * delta23 * alpha24) * over_7;
    const double f_6 = 24.0 * alpha23 * alpha24 * over_7;
    const double f_7 = -16.0 * omega1_4 * delta22 * delta23 * over_8;
    const double f_8 = 8.0 * omega1_2 * omega2_2 * delta22 * delta23 * over_8;
    const double f_9 = (16.0 * omega1_2 * alpha22 * delta23 - 8.0 * omega1_2 * alpha23 * delta22) * over_8;
    const double f_10 = 16.0 * omega2_2 * alpha22 * delta23 * over_8;
    const double f_11 = -24.0 * alpha22 * alpha23 * over_8;
    const double f_12 = -4.0 * omega2_4 * alpha22 * delta23 * over_8 / omega1_2;
    const double f_13 = 4.0 * omega2_2 * alpha22 * alpha23 * over_8 / omega1_2;
    const double q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12
        + f_13) * per_0;
    const double q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12
        + f_13) * per_1;
    const double q_2 = (f_2 + f_3 + f_4 + f_5 + f_6) * per_2;
    const double q_3 = (f_2 + f_3 + f_4 + f_5 + f_6) * per_3;
    const double q_4 = (f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13) * per_4;
    const double q_5 = (f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13) * per_5;
    gradient[0] = (2.0 * f_2 + 2.0 * f_3 + 4.0 * f_7 + 2.0 * f_8 + 2.0 * f_9 - 2.0 * f_12 - 2.0 * f_13) / omega1
        - q_0 - q_1 - q_2 - q_3 - 2.0 * q_4 - 2.0 * q_5;
    gradient[1] = (2.0 * f_0 - 2.0 * f_3 + 4.0 * f_4 + 2.0 * f_5 + 2.0 * f_8 + 2.0 * f_10 + 4.0 * f_12
        + 2.0 * f_13) / omega2 - q_0 + q_1 - 2.0 * q_2 + 2.0 * q_3 - q_4 + q_5;
    const double c_0 = (-24.0 * omega1_2 + 4.0 * omega2_2) * over_8 / omega1_2;  // multiplies alpha22*alpha23
    const double c_1 = (16.0 * omega1_4 + 16.0 * omega1_2 * omega2_2 - 4.0 * omega2_4) * over_8 / omega1_2;
    const double c_2 = -8.0 * omega1_2 * over_8;  // multiplies alpha23*delta22
    const double c_3 = (-4.0 * omega1_2 + 24.0 * omega2_2) * over_7 / omega2_2;  // multiplies alpha23*alpha24
    const double c_4 = (-4.0 * omega1_2 - 8.0 * omega2_2) * over_7;  // multiplies alpha23*delta24
    const double c_5 = (-16.0 * omega1_4 + 8.0 * omega1_2 * omega2_2) * over_8;  // multiplies delta22*delta23
    const double c_6 = 8.0 * omega2_2 * over_7;  // multiplies delta23*alpha24
    const double c_7 = -24.0 * omega2_4 * over_7;  // multiplies delta23*delta24
    const double c_8 = 6.0 * over_0;  // multiplies alpha34
    const double c_9 = -2.0 * omega2_2 * over_0;  // multiplies delta35
    gradient[6] = alpha23 * c_0 + delta23 * c_1;  // by alpha22
    gradient[7] = alpha22 * c_0 + delta22 * c_2 + alpha24 * c_3 + delta24 * c_4;  // by alpha23
    gradient[9] = alpha23 * c_2 + delta23 * c_5;  // by delta22
    gradient[10] = alpha22 * c_1 + delta22 * c_5 + alpha24 * c_6 + delta24 * c_7;  // by delta23
    gradient[14] = c_8;  // by alpha34
    gradient[19] = c_9;  // by delta35
    gradient[25] = alpha23 * c_3 + delta23 * c_6;  // by alpha24
    gradient[26] = alpha23 * c_4 + delta23 * c_7;  // by delta24
  }
  void lump_harmonic_re_v2_A_v12_conjA_v1([[maybe_unused]] double* gradient) const {
    const double f_0 = (4.0 * omega1_2 * delta21 * delta22 - omega1_2 * delta32) * over_0;
    const double f_1 = (-4.0 * alpha21 * delta22 + 6.0 * alpha22 * delta21 + 9.0 * alpha32) * over_0 / 3.0;
    const double f_2 = -10.0 * alpha21 * alpha22 * over_0 / (3.0 * omega1_2);
    const double f_3 = -4.0 * omega1_4 * delta22 * delta23 * over_8;
    const double f_4 = 16.0 * omega1_4 * alpha23 * delta22 * over_8 / omega2_2;
    const double f_5 = (-4.0 * omega1_2 * alpha22 * delta23 - 2.0 * omega1_2 * alpha23 * delta22) * over_8;
    const double f_6 = -16.0 * omega1_2 * alpha22 * alpha23 * over_8 / omega2_2;
    const double f_7 = 6.0 * alpha22 * alpha23 * over_8;
    const double q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7) * per_0;
    const double q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7) * per_1;
    const double q_4 = (f_3 + f_4 + f_5 + f_6 + f_7) * per_4;
    const double q_5 = (f_3 + f_4 + f_5 + f_6 + f_7) * per_5;
    gradient[0] = (2.0 * f_0 - 2.0 * f_2 + 4.0 * f_3 + 4.0 * f_4 + 2.0 * f_5 + 2.0 * f_6) / omega1 - q_0 - q_1
        - 2.0 * q_4 - 2.0 * q_5;
    gradient[1] = (-2.0 * f_4 - 2.0 * f_6) / omega2 - q_0 + q_1 - q_4 + q_5;  // by omega2
    const double c_0 = -10.0 * over_0 / (3.0 * omega1_2);  // multiplies alpha21*alpha22
    const double c_1 = -4.0 * over_0 / 3.0;  // multiplies alpha21*delta22
    const double c_2 = (-16.0 * omega1_2 + 6.0 * omega2_2) * over_8 / omega2_2;  // multiplies alpha22*alpha23
    const double c_3 = 2.0 * over_0;  // multiplies alpha22*delta21
    const double c_4 = -4.0 * omega1_2 * over_8;  // multiplies alpha22*delta23
    const double c_5 = (16.0 * omega1_4 - 2.0 * omega1_2 * omega2_2) * over_8 / omega2_2;
    const double c_6 = 4.0 * omega1_2 * over_0;  // multiplies delta21*delta22
    const double c_7 = -4.0 * omega1_4 * over_8;  // multiplies delta22*delta23
    const double c_8 = 3.0 * over_0;  // multiplies alpha32
    const double c_9 = -omega1_2 * over_0;  // multiplies delta32
    gradient[5] = alpha22 * c_0 + delta22 * c_1;  // by alpha21
    gradient[6] = alpha21 * c_0 + alpha23 * c_2 + delta21 * c_3 + delta23 * c_4;  // by alpha22
    gradient[7] = alpha22 * c_2 + delta22 * c_5;  // by alpha23
    gradient[8] = alpha22 * c_3 + delta22 * c_6;  // by delta21
    gradient[9] = alpha21 * c_1 + alpha23 * c_5 + delta21 * c_6 + delta23 * c_7;  // by delta22
    gradient[10] = alpha22 * c_4 + delta22 * c_7;  // by delta23
    gradient[12] = c_8;  // by alpha32
    gradient[16] = c_9;  // by delta32
  }
  void lump_harmonic_re_v2_A_v12_F([[maybe_unused]] double* gradient) const {
    const double f_0 = alpha22 * eta12 * over_0 / omega1_2;
    const double f_1 = -omega1_2 * delta22 * eta22 * over_8 / 2.0;
    const double f_2 = -alpha22 * eta22 * over_8 / 2.0;
    const double q_0 = (f_0 + f_1 + f_2) * per_0;
    const double q_1 = (f_0 + f_1 + f_2) * per_1;
    const double q_4 = (f_1 + f_2) * per_4;
    const double q_5 = (f_1 + f_2) * per_5;
    gradient[0] = (-2.0 * f_0 + 2.0 * f_1) / omega1 - q_0 - q_1 - 2.0 * q_4 - 2.0 * q_5;  // by omega1
    gradient[1] = -q_0 + q_1 - q_4 + q_5;  // by omega2
    const double c_0 = over_0 / omega1_2;  // multiplies alpha22*eta12
    const double c_1 = -over_8 / 2.0;  // multiplies alpha22*eta22
    const double c_2 = -omega1_2 * over_8 / 2.0;  // multiplies delta22*eta22
    gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
    gradient[9] = eta22 * c_2;  // by delta22
    gradient[21] = alpha22 * c_0;  // by eta12
    gradient[30] = alpha22 * c_1 + delta22 * c_2;  // by eta22
  }
  void lump_harmonic_re_v2_A_v12([[maybe_unused]] double* gradient) const {
    const double f_0 = omega1_2 * delta22 * over_2;
    const double f_1 = alpha22 * over_2;
    const double q_4 = (f_0 + f_1) * per_4;
    const double q_5 = (f_0 + f_1) * per_5;
    gradient[0] = 2.0 * f_0 / omega1 - 2.0 * q_4 - 2.0 * q_5;  // by omega1
    gradient[1] = -q_4 + q_5;  // by omega2
    const double c_0 = over_2;  // multiplies alpha22
    const double c_1 = omega1_2 * over_2;  // multiplies delta22
    gradient[6] = c_0;  // by alpha22
    gradient[9] = c_1;  // by delta22
  }
  void lump_harmonic_im_v2_A_v1_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -eta12 * mu21 * over_2 / (3.0 * omega1);
    const double f_1 = -omega1 * mu21 * eta22 * over_8 / 2.0;
    const double q_0 = f_1 * per_0;
    const double q_1 = f_1 * per_1;
    const double q_4 = (f_0 + f_1) * per_4;
    const double q_5 = (f_0 + f_1) * per_5;
    gradient[0] = (-f_0 + f_1) / omega1 - q_0 - q_1 - 2.0 * q_4 - 2.0 * q_5;  // by omega1
    gradient[1] = -q_0 + q_1 - q_4 + q_5;  // by omega2
    const double c_0 = -over_2 / (3.0 * omega1);  // multiplies eta12*mu21
    const double c_1 = -omega1 * over_8 / 2.0;  // multiplies mu21*eta22
    gradient[21] = mu21 * c_0;  // by eta12
    gradient[23] = eta12 * c_0 + eta22 * c_1;  // by mu21
    gradient[30] = mu21 * c_1;  // by eta22
  }
  void lump_harmonic_im_v2_A_v12([[maybe_unused]] double* gradient) const {
    const double f_0 = -2.0 * omega1 * delta21 * mu21 * over_2;
    const double f_1 = 2.0 * alpha21 * mu21 * over_2 / (3.0 * omega1);
    const double f_2 = -4.0 * omega1_3 * delta23 * mu21 * over_8;
    const double f_3 = 2.0 * omega1 * alpha23 * mu21 * over_8;
    const double q_0 = (f_2 + f_3) * per_0;
    const double q_1 = (f_2 + f_3) * per_1;
    const double q_4 = (f_0 + f_1 + f_2 + f_3) * per_4;
    const double q_5 = (f_0 + f_1 + f_2 + f_3) * per_5;
    gradient[0] = (f_0 - f_1 + 3.0 * f_2 + f_3) / omega1 - q_0 - q_1 - 2.0 * q_4 - 2.0 * q_5;  // by omega1
    gradient[1] = -q_0 + q_1 - q_4 + q_5;  // by omega2
    const double c_0 = 2.0 * over_2 / (3.0 * omega1);  // multiplies alpha21*mu21
    const double c_1 = 2.0 * omega1 * over_8;  // multiplies alpha23*mu21
    const double c_2 = -2.0 * omega1 * over_2;  // multiplies delta21*mu21
    const double c_3 = -4.0 * omega1_3 * over_8;  // multiplies delta23*mu21
    gradient[5] = mu21 * c_0;  // by alpha21
    gradient[7] = mu21 * c_1;  // by alpha23
    gradient[8] = mu21 * c_2;  // by delta21
    gradient[10] = mu21 * c_3;  // by delta23
    gradient[23] = alpha21 * c_0 + alpha23 * c_1 + delta21 * c_2 + delta23 * c_3;  // by mu21
  }
  void lump_harmonic_re_v2_A_v2_conjA_v12([[maybe_unused]] double* gradient) const {
    const double f_0 = omega1 * delta33 * per_1 / 4.0;
    const double f_1 = (-2.0 * omega2 * delta21 * delta23 + omega2 * delta34) * per_1 / 2.0;
    const double f_2 = (2.0 * omega2_2 * delta21 * delta23 - omega2_2 * delta34) * per_1 / (4.0 * omega1);
    const double f_3 = (-2.0 * alpha23 * delta21 + alpha33) * per_1 / (4.0 * omega1);
    const double f_4 = omega2 * alpha21 * delta23 * per_1 / (3.0 * omega1_2);
    const double f_5 = -omega2_2 * alpha21 * delta23 * per_1 / (6.0 * omega1_3);
    const double f_6 = alpha21 * alpha23 * per_1 / (6.0 * omega1_3);
    const double f_7 = -2.0 * omega2 * delta23_2 * per_3;
    const double f_8 = 3.0 * omega2_2 * delta23_2 * per_3 / omega1;
    const double f_9 = -2.0 * alpha23 * delta23 * per_3 / omega1;
    const double f_10 = -omega2_3 * delta23_2 * per_3 / omega1_2;
    const double f_11 = 2.0 * omega2 * alpha23 * delta23 * per_3 / omega1_2;
    const double f_12 = omega1_2 * delta22_2 * per_5 / omega2;
    const double f_13 = -omega1 * delta22_2 * per_5;
    const double f_14 = alpha23_2 * over_18 / omega1_2;
    const double f_15 = -alpha22_2 * over_19 / (omega1 * omega2);
    const double f_16 = -2.0 * omega1_3 * delta22 * delta24 * over_31;
    const double f_17 = omega1_2 * omega2 * delta22 * delta24 * over_31;
    const double f_18 = -omega1 * omega2_2 * delta22 * delta24 * over_31 / 2.0;
    const double f_19 = (-4.0 * omega1 * alpha22 * delta24 + omega1 * delta22 * alpha24) * over_31 / 2.0;
    const double f_20 = omega2 * alpha22 * delta24 * over_31;
    const double f_21 = -omega2_2 * alpha22 * delta24 * over_31 / (2.0 * omega1);
    const double f_22 = alpha22 * alpha24 * over_31 / (2.0 * omega1);
    const double q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_14 + f_15 + f_16 + f_17 + f_18 + f_19 + f_20
        + f_21 + f_22) * per_1;
    const double q_3 = (f_7 + f_8 + f_9 + f_10 + f_11 + f_14) * per_3;
    const double q_4 = (f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22) * per_4;
    const double q_5 = (f_12 + f_13 + f_15 + f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22) * per_5;
    gradient[0] = (f_0 - f_2 - f_3 - 2.0 * f_4 - 3.0 * f_5 - 3.0 * f_6 - f_8 - f_9 - 2.0 * f_10 - 2.0 * f_11
        + 2.0 * f_12 + f_13 - 2.0 * f_14 - f_15 + 3.0 * f_16 + 2.0 * f_17 + f_18 + f_19 - f_21 - f_22) / omega1
        - q_1 - q_3 - 2.0 * q_4 - 2.0 * q_5;
    gradient[1] = (f_1 + 2.0 * f_2 + f_4 + 2.0 * f_5 + f_7 + 2.0 * f_8 + 3.0 * f_10 + f_11 - f_12 - f_15 + f_17
        + 2.0 * f_18 + f_20 + 2.0 * f_21) / omega2 + q_1 + 2.0 * q_3 - q_4 + q_5;
    const double c_0 = per_1 / (6.0 * omega1_3);  // multiplies alpha21*alpha23
    const double c_1 = (2.0 * omega1 * omega2 - omega2_2) * per_1 / (6.0 * omega1_3);  // multiplies alpha21*delta23
    const double c_2 = -over_19 / (omega1 * omega2);  // multiplies alpha22^2
    const double c_3 = over_31 / (2.0 * omega1);  // multiplies alpha22*alpha24
    const double c_4 = (-4.0 * omega1_2 + 2.0 * omega1 * omega2 - omega2_2) * over_31 / (2.0 * omega1);
    const double c_5 = over_18 / omega1_2;  // multiplies alpha23^2
    const double c_6 = -per_1 / (2.0 * omega1);  // multiplies alpha23*delta21
    const double c_7 = (-2.0 * omega1 + 2.0 * omega2) * per_3 / omega1_2;  // multiplies alpha23*delta23
    const double c_8 = (-2.0 * omega1 * omega2 + omega2_2) * per_1 / (2.0 * omega1);  // multiplies delta21*delta23
    const double c_9 = (omega1_2 - omega1 * omega2) * per_5 / omega2;  // multiplies delta22^2
    const double c_10 = omega1 * over_31 / 2.0;  // multiplies delta22*alpha24
    const double c_11 = (-4.0 * omega1_3 + 2.0 * omega1_2 * omega2 - omega1 * omega2_2) * over_31 / 2.0;
    const double c_12 = (-2.0 * omega1_2 * omega2 + 3.0 * omega1 * omega2_2 - omega2_3) * per_3 / omega1_2;
    const double c_13 = per_1 / (4.0 * omega1);  // multiplies alpha33
    const double c_14 = omega1 * per_1 / 4.0;  // multiplies delta33
    const double c_15 = (2.0 * omega1 * omega2 - omega2_2) * per_1 / (4.0 * omega1);  // multiplies delta34
    gradient[5] = alpha23 * c_0 + delta23 * c_1;  // by alpha21
    gradient[6] = 2.0 * alpha22 * c_2 + alpha24 * c_3 + delta24 * c_4;  // by alpha22
    gradient[7] = alpha21 * c_0 + 2.0 * alpha23 * c_5 + delta21 * c_6 + delta23 * c_7;  // by alpha23
    gradient[8] = alpha23 * c_6 + delta23 * c_8;  // by delta21
    gradient[9] = 2.0 * delta22 * c_9 + alpha24 * c_10 + delta24 * c_11;  // by delta22
    gradient[10] = alpha21 * c_1 + alpha23 * c_7 + delta21 * c_8 + 2.0 * delta23 * c_12;  // by delta23
    gradient[13] = c_13;  // by alpha33
    gradient[17] = c_14;  // by delta33
    gradient[18] = c_15;  // by delta34
    gradient[25] = alpha22 * c_3 + delta22 * c_10;  // by alpha24
    gradient[26] = alpha22 * c_4 + delta22 * c_11;  // by delta24
  }
  void lump_harmonic_re_v2_A_v2_conjA_v1_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -omega2 * delta23 * eta12 * per_1 / (6.0 * omega1_2);
    const double f_1 = omega2_2 * delta23 * eta12 * per_1 / (12.0 * omega1_3);
    const double f_2 = -alpha23 * eta12 * per_1 / (12.0 * omega1_3);
    const double f_3 = delta23 * eta22 * per_3 / (2.0 * omega1);
    const double f_4 = -omega2 * delta23 * eta22 * per_3 / (2.0 * omega1_2);
    const double f_5 = -alpha23 * eta22 * over_18 / (2.0 * omega1_2);
    const double q_1 = (f_0 + f_1 + f_2 + f_5) * per_1;
    const double q_3 = (f_3 + f_4 + f_5) * per_3;
    gradient[0] = (-2.0 * f_0 - 3.0 * f_1 - 3.0 * f_2 - f_3 - 2.0 * f_4 - 2.0 * f_5) / omega1 - q_1 - q_3;
    gradient[1] = (f_0 + 2.0 * f_1 + f_4) / omega2 + q_1 + 2.0 * q_3;  // by omega2
    const double c_0 = -per_1 / (12.0 * omega1_3);  // multiplies alpha23*eta12
    const double c_1 = -over_18 / (2.0 * omega1_2);  // multiplies alpha23*eta22
    const double c_2 = (-2.0 * omega1 * omega2 + omega2_2) * per_1 / (12.0 * omega1_3);  // multiplies delta23*eta12
    const double c_3 = (omega1 - omega2) * per_3 / (2.0 * omega1_2);  // multiplies delta23*eta22
    gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
    gradient[10] = eta12 * c_2 + eta22 * c_3;  // by delta23
    gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
    gradient[30] = alpha23 * c_1 + delta23 * c_3;  // by eta22
  }
  void lump_harmonic_re_v2_A_v22_conjA_v1([[maybe_unused]] double* gradient) const {
    const double f_0 = 2.0 * omega1 * omega2 * delta35 * over_32;
    const double f_1 = -3.0 * omega2_2 * delta35 * over_32;
    const double f_2 = 3.0 * alpha34 * over_32;
    const double f_3 = 4.0 * omega1_2 * delta22 * delta23 * over_33;
    const double f_4 = -8.0 * omega1 * omega2 * delta22 * delta23 * over_33;
    const double f_5 = 4.0 * omega1 * alpha23 * delta22 * over_33 / omega2;
    const double f_6 = -8.0 * omega1_2 * omega2 * delta23 * delta24 * over_34;
    const double f_7 = 4.0 * omega1_2 * delta23 * alpha24 * over_34 / (3.0 * omega2);
    const double f_8 = 32.0 * omega1 * omega2_2 * delta23 * delta24 * over_34;
    const double f_9 = (-18.0 * omega1 * alpha23 * delta24 - 16.0 * omega1 * delta23 * alpha24) * over_34 / 3.0;
    const double f_10 = 2.0 * omega1 * alpha23 * alpha24 * over_34 / (3.0 * omega2_2);
    const double f_11 = -40.0 * omega2_3 * delta23 * delta24 * over_34;
    const double f_12 = (48.0 * omega2 * alpha23 * delta24 + 28.0 * omega2 * delta23 * alpha24) * over_34 / 3.0;
    const double f_13 = -4.0 * alpha23 * alpha24 * over_34 / (3.0 * omega2);
    const double f_14 = 12.0 * omega2_4 * delta23 * delta24 * over_34 / omega1;
    const double f_15 = (-12.0 * omega2_2 * alpha23 * delta24
        - 4.0 * omega2_2 * delta23 * alpha24) * over_34 / omega1;
    const double f_16 = 4.0 * alpha23 * alpha24 * over_34 / omega1;
    const double f_17 = 4.0 * omega1 * omega2_3 * delta22 * delta23 * over_35;
    const double f_18 = 4.0 * omega1 * omega2 * alpha23 * delta22 * over_35;
    const double f_19 = -4.0 * omega1_3 * alpha22 * delta23 * over_36;
    const double f_20 = 8.0 * omega1_2 * omega2 * alpha22 * delta23 * over_36;
    const double f_21 = -4.0 * omega1_2 * alpha22 * alpha23 * over_36 / omega2;
    const double f_22 = 12.0 * omega1 * omega2_2 * alpha22 * delta23 * over_36;
    const double f_23 = -4.0 * omega1 * alpha22 * alpha23 * over_36;
    const double f_24 = -30.0 * omega2_3 * alpha22 * delta23 * over_36;
    const double f_25 = 18.0 * omega2 * alpha22 * alpha23 * over_36;
    const double q_1 = (f_0 + f_1 + f_2 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14 + f_15 + f_16
        + f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_1;
    const double q_2 = (f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_2;
    const double q_3 = (f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14 + f_15 + f_16 + f_17 + f_18 + f_19
        + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_3;
    const double q_5 = (f_3 + f_4 + f_5 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_5;
    const double q_8 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14
        + f_15 + f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_8;
    gradient[0] = (f_0 + 2.0 * f_3 + f_4 + f_5 + 2.0 * f_6 + 2.0 * f_7 + f_8 + f_9 + f_10 - f_14 - f_15 - f_16
        + f_17 + f_18 + 3.0 * f_19 + 2.0 * f_20 + 2.0 * f_21 + f_22 + f_23) / omega1 - q_1 - q_2 - q_3 - 2.0 * q_5
        - q_8;
    gradient[1] = (f_0 + 2.0 * f_1 + f_4 - f_5 + f_6 - f_7 + 2.0 * f_8 - 2.0 * f_10 + 3.0 * f_11 + f_12 - f_13
        + 4.0 * f_14 + 2.0 * f_15 + 3.0 * f_17 + f_18 + f_20 - f_21 + 2.0 * f_22 + 3.0 * f_24 + f_25) / omega2 + q_1
        - 2.0 * q_2 + 2.0 * q_3 + q_5 + 3.0 * q_8;
    const double c_0 = (-4.0 * omega1_2 - 4.0 * omega1 * omega2 + 18.0 * omega2_2) * over_36 / omega2;
    const double c_1 = (-4.0 * omega1_3 + 8.0 * omega1_2 * omega2 + 12.0 * omega1 * omega2_2
        - 30.0 * omega2_3) * over_36;
    const double c_2 = 4.0 * omega1 * over_33 / omega2 + 4.0 * omega1 * omega2 * over_35;
    const double c_3 = (2.0 * omega1_2 - 4.0 * omega1 * omega2
        + 12.0 * omega2_2) * over_34 / (3.0 * omega1 * omega2_2);
    const double c_4 = (-6.0 * omega1_2 + 16.0 * omega1 * omega2 - 12.0 * omega2_2) * over_34 / omega1;
    const double c_5 = (4.0 * omega1_2 - 8.0 * omega1 * omega2) * over_33 + 4.0 * omega1 * omega2_3 * over_35;
    const double c_6 = (4.0 * omega1_3 - 16.0 * omega1_2 * omega2 + 28.0 * omega1 * omega2_2
        - 12.0 * omega2_3) * over_34 / (3.0 * omega1 * omega2);
    const double c_7 = (-8.0 * omega1_3 * omega2 + 32.0 * omega1_2 * omega2_2 - 40.0 * omega1 * omega2_3
        + 12.0 * omega2_4) * over_34 / omega1;
    const double c_8 = 3.0 * over_32;  // multiplies alpha34
    const double c_9 = (2.0 * omega1 * omega2 - 3.0 * omega2_2) * over_32;  // multiplies delta35
    gradient[6] = alpha23 * c_0 + delta23 * c_1;  // by alpha22
    gradient[7] = alpha22 * c_0 + delta22 * c_2 + alpha24 * c_3 + delta24 * c_4;  // by alpha23
    gradient[9] = alpha23 * c_2 + delta23 * c_5;  // by delta22
    gradient[10] = alpha22 * c_1 + delta22 * c_5 + alpha24 * c_6 + delta24 * c_7;  // by delta23
    gradient[14] = c_8;  // by alpha34
    gradient[19] = c_9;  // by delta35
    gradient[25] = alpha23 * c_3 + delta23 * c_6;  // by alpha24
    gradient[26] = alpha23 * c_4 + delta23 * c_7;  // by delta24
  }
  void lump_harmonic_re_v2_A_v22_F([[maybe_unused]] double* gradient) const {
    const double f_0 = 3.0 * omega1 * delta24 * eta22 * over_34 / 2.0;
    const double f_1 = -omega1 * alpha24 * eta22 * over_34 / (6.0 * omega2_2);
    const double f_2 = -4.0 * omega2 * delta24 * eta22 * over_34;
    const double f_3 = alpha24 * eta22 * over_34 / (3.0 * omega2);
    const double f_4 = 3.0 * omega2_2 * delta24 * eta22 * over_34 / omega1;
    const double f_5 = -alpha24 * eta22 * over_34 / omega1;
    const double q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_1;
    const double q_3 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_3;
    const double q_8 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_8;
    gradient[0] = (f_0 + f_1 - f_4 - f_5) / omega1 - q_1 - q_3 - q_8;  // by omega1
    gradient[1] = (-2.0 * f_1 + f_2 - f_3 + 2.0 * f_4) / omega2 + q_1 + 2.0 * q_3 + 3.0 * q_8;  // by omega2
    const double c_0 = (-omega1_2 + 2.0 * omega1 * omega2 - 6.0 * omega2_2) * over_34 / (6.0 * omega1 * omega2_2);
    const double c_1 = (3.0 * omega1_2 - 8.0 * omega1 * omega2 + 6.0 * omega2_2) * over_34 / (2.0 * omega1);
    gradient[25] = eta22 * c_0;  // by alpha24
    gradient[26] = eta22 * c_1;  // by delta24
    gradient[30] = alpha24 * c_0 + delta24 * c_1;  // by eta22
  }
  void lump_harmonic_re_v2_A_v1_A_v2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = omega2 * delta23 * eta12 * per_0 / (6.0 * omega1_2);
    const double f_1 = omega2_2 * delta23 * eta12 * per_0 / (12.0 * omega1_3);
    const double f_2 = -alpha23 * eta12 * per_0 / (12.0 * omega1_3);
    const double f_3 = delta23 * eta22 * per_2 / (2.0 * omega1);
    const double f_4 = omega2 * delta23 * eta22 * per_2 / (2.0 * omega1_2);
    const double f_5 = -alpha23 * eta22 * over_21 / (2.0 * omega1_2);
    const double q_0 = (f_0 + f_1 + f_2 + f_5) * per_0;
    const double q_2 = (f_3 + f_4 + f_5) * per_2;
    gradient[0] = (-2.0 * f_0 - 3.0 * f_1 - 3.0 * f_2 - f_3 - 2.0 * f_4 - 2.0 * f_5) / omega1 - q_0 - q_2;
    gradient[1] = (f_0 + 2.0 * f_1 + f_4) / omega2 - q_0 - 2.0 * q_2;  // by omega2
    const double c_0 = -per_0 / (12.0 * omega1_3);  // multiplies alpha23*eta12
    const double c_1 = -over_21 / (2.0 * omega1_2);  // multiplies alpha23*eta22
    const double c_2 = (2.0 * omega1 * omega2 + omega2_2) * per_0 / (12.0 * omega1_3);  // multiplies delta23*eta12
    const double c_3 = (omega1 + omega2) * per_2 / (2.0 * omega1_2);  // multiplies delta23*eta22
    gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
    gradient[10] = eta12 * c_2 + eta22 * c_3;  // by delta23
    gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
    gradient[30] = alpha23 * c_1 + delta23 * c_3;  // by eta22
  }
  void lump_harmonic_re_v2_A_v12_A_v2([[maybe_unused]] double* gradient) const {
    const double f_0 = omega1 * delta33 * per_0 / 4.0;
    const double f_1 = (2.0 * omega2 * delta21 * delta23 - omega2 * delta34) * per_0 / 2.0;
    const double f_2 = (2.0 * omega2_2 * delta21 * delta23 - omega2_2 * delta34) * per_0 / (4.0 * omega1);
    const double f_3 = (-2.0 * alpha23 * delta21 + alpha33) * per_0 / (4.0 * omega1);
    const double f_4 = -omega2 * alpha21 * delta23 * per_0 / (3.0 * omega1_2);
    const double f_5 = -omega2_2 * alpha21 * delta23 * per_0 / (6.0 * omega1_3);
    const double f_6 = alpha21 * alpha23 * per_0 / (6.0 * omega1_3);
    const double f_7 = 2.0 * omega2 * delta23_2 * per_2;
    const double f_8 = 3.0 * omega2_2 * delta23_2 * per_2 / omega1;
    const double f_9 = -2.0 * alpha23 * delta23 * per_2 / omega1;
    const double f_10 = omega2_3 * delta23_2 * per_2 / omega1_2;
    const double f_11 = -2.0 * omega2 * alpha23 * delta23 * per_2 / omega1_2;
    const double f_12 = -omega1_2 * delta22_2 * per_4 / omega2;
    const double f_13 = -omega1 * delta22_2 * per_4;
    const double f_14 = alpha23_2 * over_21 / omega1_2;
    const double f_15 = alpha22_2 * over_22 / (omega1 * omega2);
    const double f_16 = -2.0 * omega1_3 * delta22 * delta24 * over_37;
    const double f_17 = -omega1_2 * omega2 * delta22 * delta24 * over_37;
    const double f_18 = -omega1 * omega2_2 * delta22 * delta24 * over_37 / 2.0;
    const double f_19 = (-4.0 * omega1 * alpha22 * delta24 + omega1 * delta22 * alpha24) * over_37 / 2.0;
    const double f_20 = -omega2 * alpha22 * delta24 * over_37;
    const double f_21 = -omega2_2 * alpha22 * delta24 * over_37 / (2.0 * omega1);
    const double f_22 = alpha22 * alpha24 * over_37 / (2.0 * omega1);
    const double q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_14 + f_15 + f_16 + f_17 + f_18 + f_19 + f_20
        + f_21 + f_22) * per_0;
    const double q_2 = (f_7 + f_8 + f_9 + f_10 + f_11 + f_14) * per_2;
    const double q_4 = (f_12 + f_13 + f_15 + f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22) * per_4;
    const double q_5 = (f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22) * per_5;
    gradient[0] = (f_0 - f_2 - f_3 - 2.0 * f_4 - 3.0 * f_5 - 3.0 * f_6 - f_8 - f_9 - 2.0 * f_10 - 2.0 * f_11
        + 2.0 * f_12 + f_13 - 2.0 * f_14 - f_15 + 3.0 * f_16 + 2.0 * f_17 + f_18 + f_19 - f_21 - f_22) / omega1
        - q_0 - q_2 - 2.0 * q_4 - 2.0 * q_5;
    gradient[1] = (f_1 + 2.0 * f_2 + f_4 + 2.0 * f_5 + f_7 + 2.0 * f_8 + 3.0 * f_10 + f_11 - f_12 - f_15 + f_17
        + 2.0 * f_18 + f_20 + 2.0 * f_21) / omega2 - q_0 - 2.0 * q_2 - q_4 + q_5;
    const double c_0 = per_0 / (6.0 * omega1_3);  // multiplies alpha21*alpha23
    const double c_1 = (-2.0 * omega1 * omega2 - omega2_2) * per_0 / (6.0 * omega1_3);
    const double c_2 = over_22 / (omega1 * omega2);  // multiplies alpha22^2
    const double c_3 = over_37 / (2.0 * omega1);  // multiplies alpha22*alpha24
    const double c_4 = (-4.0 * omega1_2 - 2.0 * omega1 * omega2 - omega2_2) * over_37 / (2.0 * omega1);
    const double c_5 = over_21 / omega1_2;  // multiplies alpha23^2
    const double c_6 = -per_0 / (2.0 * omega1);  // multiplies alpha23*delta21
    const double c_7 = (-2.0 * omega1 - 2.0 * omega2) * per_2 / omega1_2;  // multiplies alpha23*delta23
    const double c_8 = (2.0 * omega1 * omega2 + omega2_2) * per_0 / (2.0 * omega1);  // multiplies delta21*delta23
    const double c_9 = (-omega1_2 - omega1 * omega2) * per_4 / omega2;  // multiplies delta22^2
    const double c_10 = omega1 * over_37 / 2.0;  // multiplies delta22*alpha24
    const double c_11 = (-4.0 * omega1_3 - 2.0 * omega1_2 * omega2 - omega1 * omega2_2) * over_37 / 2.0;
    const double c_12 = (2.0 * omega1_2 * omega2 + 3.0 * omega1 * omega2_2 + omega2_3) * per_2 / omega1_2;
    const double c_13 = per_0 / (4.0 * omega1);  // multiplies alpha33
    const double c_14 = omega1 * per_0 / 4.0;  // multiplies delta33
    const double c_15 = (-2.0 * omega1 * omega2 - omega2_2) * per_0 / (4.0 * omega1);  // multiplies delta34
    gradient[5] = alpha23 * c_0 + delta23 * c_1;  // by alpha21
    gradient[6] = 2.0 * alpha22 * c_2 + alpha24 * c_3 + delta24 * c_4;  // by alpha22
    gradient[7] = alpha21 * c_0 + 2.0 * alpha23 * c_5 + delta21 * c_6 + delta23 * c_7;  // by alpha23
    gradient[8] = alpha23 * c_6 + delta23 * c_8;  // by delta21
    gradient[9] = 2.0 * delta22 * c_9 + alpha24 * c_10 + delta24 * c_11;  // by delta22
    gradient[10] = alpha21 * c_1 + alpha23 * c_7 + delta21 * c_8 + 2.0 * delta23 * c_12;  // by delta23
    gradient[13] = c_13;  // by alpha33
    gradient[17] = c_14;  // by delta33
    gradient[18] = c_15;  // by delta34
    gradient[25] = alpha22 * c_3 + delta22 * c_10;  // by alpha24
    gradient[26] = alpha22 * c_4 + delta22 * c_11;  // by delta24
  }
  void lump_harmonic_re_v2_A_v1_A_v22([[maybe_unused]] double* gradient) const {
    const double f_0 = -2.0 * omega1 * omega2 * delta35 * over_38;
    const double f_1 = -3.0 * omega2_2 * delta35 * over_38;
    const double f_2 = 3.0 * alpha34 * over_38;
    const double f_3 = 4.0 * omega1_2 * delta22 * delta23 * over_39;
    const double f_4 = 8.0 * omega1 * omega2 * delta22 * delta23 * over_39;
    const double f_5 = -4.0 * omega1 * alpha23 * delta22 * over_39 / omega2;
    const double f_6 = 8.0 * omega1_2 * omega2 * delta23 * delta24 * over_40;
    const double f_7 = -4.0 * omega1_2 * delta23 * alpha24 * over_40 / (3.0 * omega2);
    const double f_8 = 32.0 * omega1 * omega2_2 * delta23 * delta24 * over_40;
    const double f_9 = (-18.0 * omega1 * alpha23 * delta24 - 16.0 * omega1 * delta23 * alpha24) * over_40 / 3.0;
    const double f_10 = 2.0 * omega1 * alpha23 * alpha24 * over_40 / (3.0 * omega2_2);
    const double f_11 = 40.0 * omega2_3 * delta23 * delta24 * over_40;
    const double f_12 = (-48.0 * omega2 * alpha23 * delta24 - 28.0 * omega2 * delta23 * alpha24) * over_40 / 3.0;
    const double f_13 = 4.0 * alpha23 * alpha24 * over_40 / (3.0 * omega2);
    const double f_14 = 12.0 * omega2_4 * delta23 * delta24 * over_40 / omega1;
    const double f_15 = (-12.0 * omega2_2 * alpha23 * delta24
        - 4.0 * omega2_2 * delta23 * alpha24) * over_40 / omega1;
    const double f_16 = 4.0 * alpha23 * alpha24 * over_40 / omega1;
    const double f_17 = -4.0 * omega1 * omega2_3 * delta22 * delta23 * over_41;
    const double f_18 = -4.0 * omega1 * omega2 * alpha23 * delta22 * over_41;
    const double f_19 = -4.0 * omega1_3 * alpha22 * delta23 * over_42;
    const double f_20 = -8.0 * omega1_2 * omega2 * alpha22 * delta23 * over_42;
    const double f_21 = 4.0 * omega1_2 * alpha22 * alpha23 * over_42 / omega2;
    const double f_22 = 12.0 * omega1 * omega2_2 * alpha22 * delta23 * over_42;
    const double f_23 = -4.0 * omega1 * alpha22 * alpha23 * over_42;
    const double f_24 = 30.0 * omega2_3 * alpha22 * delta23 * over_42;
    const double f_25 = -18.0 * omega2 * alpha22 * alpha23 * over_42;
    const double q_0 = (f_0 + f_1 + f_2 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14 + f_15 + f_16
        + f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_0;
    const double q_2 = (f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14 + f_15 + f_16 + f_17 + f_18 + f_19
        + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_2;
    const double q_3 = (f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_3;
    const double q_4 = (f_3 + f_4 + f_5 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_4;
    const double q_7 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9 + f_10 + f_11 + f_12 + f_13 + f_14
        + f_15 + f_16 + f_17 + f_18 + f_19 + f_20 + f_21 + f_22 + f_23 + f_24 + f_25) * per_7;
    gradient[0] = (f_0 + 2.0 * f_3 + f_4 + f_5 + 2.0 * f_6 + 2.0 * f_7 + f_8 + f_9 + f_10 - f_14 - f_15 - f_16
        + f_17 + f_18 + 3.0 * f_19 + 2.0 * f_20 + 2.0 * f_21 + f_22 + f_23) / omega1 - q_0 - q_2 - q_3 - 2.0 * q_4
        - q_7;
    gradient[1] = (f_0 + 2.0 * f_1 + f_4 - f_5 + f_6 - f_7 + 2.0 * f_8 - 2.0 * f_10 + 3.0 * f_11 + f_12 - f_13
        + 4.0 * f_14 + 2.0 * f_15 + 3.0 * f_17 + f_18 + f_20 - f_21 + 2.0 * f_22 + 3.0 * f_24 + f_25) / omega2 - q_0
        - 2.0 * q_2 + 2.0 * q_3 - q_4 - 3.0 * q_7;
    const double c_0 = (4.0 * omega1_2 - 4.0 * omega1 * omega2 - 18.0 * omega2_2) * over_42 / omega2;
    const double c_1 = (-4.0 * omega1_3 - 8.0 * omega1_2 * omega2 + 12.0 * omega1 * omega2_2
        + 30.0 * omega2_3) * over_42;
    const double c_2 = -4.0 * omega1 * over_39 / omega2 - 4.0 * omega1 * omega2 * over_41;
    const double c_3 = (2.0 * omega1_2 + 4.0 * omega1 * omega2
        + 12.0 * omega2_2) * over_40 / (3.0 * omega1 * omega2_2);
    const double c_4 = (-6.0 * omega1_2 - 16.0 * omega1 * omega2 - 12.0 * omega2_2) * over_40 / omega1;
    const double c_5 = (4.0 * omega1_2 + 8.0 * omega1 * omega2) * over_39 - 4.0 * omega1 * omega2_3 * over_41;
    const double c_6 = (-4.0 * omega1_3 - 16.0 * omega1_2 * omega2 - 28.0 * omega1 * omega2_2
        - 12.0 * omega2_3) * over_40 / (3.0 * omega1 * omega2);
    const double c_7 = (8.0 * omega1_3 * omega2 + 32.0 * omega1_2 * omega2_2 + 40.0 * omega1 * omega2_3
        + 12.0 * omega2_4) * over_40 / omega1;
    const double c_8 = 3.0 * over_38;  // multiplies alpha34
    const double c_9 = (-2.0 * omega1 * omega2 - 3.0 * omega2_2) * over_38;  // multiplies delta35
    gradient[6] = alpha23 * c_0 + delta23 * c_1;  // by alpha22
    gradient[7] = alpha22 * c_0 + delta22 * c_2 + alpha24 * c_3 + delta24 * c_4;  // by alpha23
    gradient[9] = alpha23 * c_2 + delta23 * c_5;  // by delta22
    gradient[10] = alpha22 * c_1 + delta22 * c_5 + alpha24 * c_6 + delta24 * c_7;  // by delta23
    gradient[14] = c_8;  // by alpha34
    gradient[19] = c_9;  // by delta35
    gradient[25] = alpha23 * c_3 + delta23 * c_6;  // by alpha24
    gradient[26] = alpha23 * c_4 + delta23 * c_7;  // by delta24
  }
  void lump_harmonic_re_v2_A_v23([[maybe_unused]] double* gradient) const {
    const double f_1 = (-20.0 * alpha24 * delta24 + 3.0 * alpha35) / (24.0 * omega2_2);
    const double f_2 = alpha24_2 / (12.0 * omega2_4);
    const double f_3 = 3.0 * omega2_2 * delta23_2 * over_1 / 4.0;
    const double f_4 = alpha23 * delta23 * over_1 / 2.0;
    const double f_5 = -alpha23_2 * over_1 / (4.0 * omega2_2);
    const double q_2 = (f_3 + f_4 + f_5) * per_2;
    const double q_3 = (f_3 + f_4 + f_5) * per_3;
    gradient[0] = -q_2 - q_3;  // by omega1
    gradient[1] = (-2.0 * f_1 - 4.0 * f_2 + 2.0 * f_3 - 2.0 * f_5) / omega2 - 2.0 * q_2 + 2.0 * q_3;  // by omega2
    const double c_0 = -over_1 / (4.0 * omega2_2);  // multiplies alpha23^2
    const double c_1 = over_1 / 2.0;  // multiplies alpha23*delta23
    const double c_2 = 3.0 * omega2_2 * over_1 / 4.0;  // multiplies delta23^2
    const double c_3 = 1.0 / (12.0 * omega2_4);  // multiplies alpha24^2
    const double c_4 = -5.0 / (6.0 * omega2_2);  // multiplies alpha24*delta24
    const double c_5 = 7.0 / 4.0;  // multiplies delta24^2
    const double c_6 = 1.0 / (8.0 * omega2_2);  // multiplies alpha35
    const double c_7 = -1.0 / 4.0;  // multiplies delta36
    gradient[7] = 2.0 * alpha23 * c_0 + delta23 * c_1;  // by alpha23
    gradient[10] = alpha23 * c_1 + 2.0 * delta23 * c_2;  // by delta23
    gradient[25] = 2.0 * alpha24 * c_3 + delta24 * c_4;  // by alpha24
    gradient[26] = alpha24 * c_4 + 2.0 * delta24 * c_5;  // by delta24
    gradient[27] = c_6;  // by alpha35
    gradient[28] = c_7;  // by delta36
  }
  void lump_harmonic_re_v2_A_v13([[maybe_unused]] double* gradient) const {
    const double f_0 = (-4.0 * omega1_2 * delta21 * delta22 + omega1_2 * delta32) * over_43;
    const double f_1 = (4.0 * alpha21 * delta22 - 6.0 * alpha22 * delta21 + 3.0 * alpha32) * over_43 / 3.0;
    const double f_2 = 2.0 * alpha21 * alpha22 * over_43 / (3.0 * omega1_2);
    const double f_3 = -12.0 * omega1_4 * delta22 * delta23 * over_44;
    const double f_4 = (-12.0 * omega1_2 * alpha22 * delta23 + 2.0 * omega1_2 * alpha23 * delta22) * over_44;
    const double f_5 = 2.0 * alpha22 * alpha23 * over_44;
    const double q_4 = (f_3 + f_4 + f_5) * per_4;
    const double q_5 = (f_3 + f_4 + f_5) * per_5;
    const double q_6 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_6;
    const double q_9 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_9;
    gradient[0] = (2.0 * f_0 - 2.0 * f_2 + 4.0 * f_3 + 2.0 * f_4) / omega1 - 2.0 * q_4 - 2.0 * q_5 - 3.0 * q_6
        - 3.0 * q_9;
    gradient[1] = -q_4 + q_5 + q_6 - q_9;  // by omega2
    const double c_0 = 2.0 * over_43 / (3.0 * omega1_2);  // multiplies alpha21*alpha22
    const double c_1 = 4.0 * over_43 / 3.0;  // multiplies alpha21*delta22
    const double c_2 = 2.0 * over_44;  // multiplies alpha22*alpha23
    const double c_3 = -2.0 * over_43;  // multiplies alpha22*delta21
    const double c_4 = -12.0 * omega1_2 * over_44;  // multiplies alpha22*delta23
    const double c_5 = 2.0 * omega1_2 * over_44;  // multiplies alpha23*delta22
    const double c_6 = -4.0 * omega1_2 * over_43;  // multiplies delta21*delta22
    const double c_7 = -12.0 * omega1_4 * over_44;  // multiplies delta22*delta23
    const double c_8 = over_43;  // multiplies alpha32
    const double c_9 = omega1_2 * over_43;  // multiplies delta32
    gradient[5] = alpha22 * c_0 + delta22 * c_1;  // by alpha21
    gradient[6] = alpha21 * c_0 + alpha23 * c_2 + delta21 * c_3 + delta23 * c_4;  // by alpha22
    gradient[7] = alpha22 * c_2 + delta22 * c_5;  // by alpha23
    gradient[8] = alpha22 * c_3 + delta22 * c_6;  // by delta21
    gradient[9] = alpha21 * c_1 + alpha23 * c_5 + delta21 * c_6 + delta23 * c_7;  // by delta22
    gradient[10] = alpha22 * c_4 + delta22 * c_7;  // by delta23
    gradient[12] = c_8;  // by alpha32
    gradient[16] = c_9;  // by delta32
  }
  void lump_conservative_v1_A_v1_A_v2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -omega1 * delta22 * eta22 / (2.0 * omega2_2);
    const double f_1 = alpha22 * eta22 / (2.0 * omega1 * omega2_2);
    const double f_2 = omega1 * delta22 * eta12 * over_2;
    const double f_3 = alpha22 * eta12 * over_2 / omega1;
    const double q_4 = (f_2 + f_3) * per_4;
    const double q_5 = (f_2 + f_3) * per_5;
    gradient[0] = (f_0 - f_1 + f_2 - f_3) / omega1 - 2.0 * q_4 - 2.0 * q_5;  // by omega1
    gradient[1] = (-2.0 * f_0 - 2.0 * f_1) / omega2 - q_4 + q_5;  // by omega2
    const double c_0 = over_2 / omega1;  // multiplies alpha22*eta12
    const double c_1 = 1.0 / (2.0 * omega1 * omega2_2);  // multiplies alpha22*eta22
    const double c_2 = omega1 * over_2;  // multiplies delta22*eta12
    const double c_3 = -omega1 / (2.0 * omega2_2);  // multiplies delta22*eta22
    gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
    gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
    gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
    gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  }
  void lump_conservative_v1_A_v1_F2_of_primary_2([[maybe_unused]] double* gradient) const {
    const double f_0 = -eta12_2 * over_2 / (4.0 * omega1);
    const double q_4 = f_0 * per_4;
    const double q_5 = f_0 * per_5;
    gradient[0] = -f_0 / omega1 - 2.0 * q_4 - 2.0 * q_5;  // by omega1
    gradient[1] = -q_4 + q_5;  // by omega2
    const double c_0 = -over_2 / (4.0 * omega1);  // multiplies eta12^2
    gradient[21] = 2.0 * eta12 * c_0;  // by eta12
  }
  void lump_conservative_v2_A_v22_F([[maybe_unused]] double* gradient) const {
    gradient[1] = (omega2_2 * delta24 * eta22 - 5.0 * alpha24 * eta22) / (4.0 * omega2_4);  // by omega2
    gradient[25] = 5.0 * eta22 / (12.0 * omega2_3);  // by alpha24
    gradient[26] = -eta22 / (4.0 * omega2);  // by delta24
    gradient[30] = (-3.0 * omega2_2 * delta24 + 5.0 * alpha24) / (12.0 * omega2_3);  // by eta22
  }
  void lump_conservative_v2_A_v2_F2_of_primary_2([[maybe_unused]] double* gradient) const {
    gradient[1] = eta22_2 / (4.0 * omega2_4);  // by omega2
    gradient[30] = -eta22 / (6.0 * omega2_3);  // by eta22
  }
  void lump_harmonic_im_v1_conjA_v2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = omega2 * mu12 * eta12 * over_0 / (2.0 * omega1_2);
    const double q_0 = f_0 * per_0;
    const double q_1 = f_0 * per_1;
    gradient[0] = -2.0 * f_0 / omega1 - q_0 - q_1;  // by omega1
    gradient[1] = f_0 / omega2 - q_0 + q_1;  // by omega2
    const double c_0 = omega2 * over_0 / (2.0 * omega1_2);  // multiplies mu12*eta12
    gradient[3] = eta12 * c_0;  // by mu12
    gradient[21] = mu12 * c_0;  // by eta12
  }
  void lump_harmonic_re_v1_A_v2_conjA_v2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -2.0 * delta23 * eta22 * over_0 / 3.0;
    const double f_1 = -2.0 * alpha23 * eta22 * over_0 / (3.0 * omega2_2);
    const double f_2 = omega2_2 * delta23 * eta12 * over_0 / omega1_2;
    const double f_3 = -alpha23 * eta12 * over_0 / omega1_2;
    const double q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
    const double q_1 = (f_0 + f_1 + f_2 + f_3) * per_1;
    gradient[0] = (-2.0 * f_2 - 2.0 * f_3) / omega1 - q_0 - q_1;  // by omega1
    gradient[1] = (-2.0 * f_1 + 2.0 * f_2) / omega2 - q_0 + q_1;  // by omega2
    const double c_0 = -over_0 / omega1_2;  // multiplies alpha23*eta12
    const double c_1 = -2.0 * over_0 / (3.0 * omega2_2);  // multiplies alpha23*eta22
    const double c_2 = omega2_2 * over_0 / omega1_2;  // multiplies delta23*eta12
    const double c_3 = -2.0 * over_0 / 3.0;  // multiplies delta23*eta22
    gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
    gradient[10] = eta12 * c_2 + eta22 * c_3;  // by delta23
    gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
    gradient[30] = alpha23 * c_1 + delta23 * c_3;  // by eta22
  }
  void lump_harmonic_re_v1_A_v1_conjA_v1_F([[maybe_unused]] double* gradient) const {
    const double f_0 = 2.0 * omega1_2 * delta21 * eta12 * over_8;
    const double f_1 = omega2_2 * delta21 * eta12 * over_8;
    const double f_2 = -6.0 * alpha21 * eta12 * over_8;
    const double f_3 = omega2_2 * alpha21 * eta12 * over_8 / omega1_2;
    const double q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
    const double q_1 = (f_0 + f_1 + f_2 + f_3) * per_1;
    const double q_4 = (f_0 + f_1 + f_2 + f_3) * per_4;
    const double q_5 = (f_0 + f_1 + f_2 + f_3) * per_5;
    gradient[0] = (2.0 * f_0 - 2.0 * f_3) / omega1 - q_0 - q_1 - 2.0 * q_4 - 2.0 * q_5;  // by omega1
    gradient[1] = (2.0 * f_1 + 2.0 * f_3) / omega2 - q_0 + q_1 - q_4 + q_5;  // by omega2
    const double c_0 = (-6.0 * omega1_2 + omega2_2) * over_8 / omega1_2;  // multiplies alpha21*eta12
    const double c_1 = (2.0 * omega1_2 + omega2_2) * over_8;  // multiplies delta21*eta12
    gradient[5] = eta12 * c_0;  // by alpha21
    gradient[8] = eta12 * c_1;  // by delta21
    gradient[21] = alpha21 * c_0 + delta21 * c_1;  // by eta12
  }
  void lump_harmonic_re_v1_A_v22_F_of_primary_2([[maybe_unused]] double* gradient) const {
    const double f_0 = -alpha23 * eta22 * over_0 / omega2_2;
    const double f_1 = -omega2_2 * delta23 * eta12 * over_7 / 2.0;
    const double f_2 = -alpha23 * eta12 * over_7 / 2.0;
    const double q_0 = (f_0 + f_1 + f_2) * per_0;
    const double q_1 = (f_0 + f_1 + f_2) * per_1;
    const double q_2 = (f_1 + f_2) * per_2;
    const double q_3 = (f_1 + f_2) * per_3;
    gradient[0] = -q_0 - q_1 - q_2 - q_3;  // by omega1
    gradient[1] = (-2.0 * f_0 + 2.0 * f_1) / omega2 - q_0 + q_1 - 2.0 * q_2 + 2.0 * q_3;  // by omega2
    const double c_0 = -over_7 / 2.0;  // multiplies alpha23*eta12
    const double c_1 = -over_0 / omega2_2;  // multiplies alpha23*eta22
    const double c_2 = -omega2_2 * over_7 / 2.0;  // multiplies delta23*eta12
    gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
    gradient[10] = eta12 * c_2;  // by delta23
    gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
    gradient[30] = alpha23 * c_1;  // by eta22
  }
  void lump_harmonic_im_v1_A_v2_F_of_primary_2([[maybe_unused]] double* gradient) const {
    const double f_0 = mu12 * eta22 * over_1 / (3.0 * omega2);
    const double f_1 = -omega2 * mu12 * eta12 * over_7 / 2.0;
    const double q_0 = f_1 * per_0;
    const double q_1 = f_1 * per_1;
    const double q_2 = (f_0 + f_1) * per_2;
    const double q_3 = (f_0 + f_1) * per_3;
    gradient[0] = -q_0 - q_1 - q_2 - q_3;  // by omega1
    gradient[1] = (-f_0 + f_1) / omega2 - q_0 + q_1 - 2.0 * q_2 + 2.0 * q_3;  // by omega2
    const double c_0 = -omega2 * over_7 / 2.0;  // multiplies mu12*eta12
    const double c_1 = over_1 / (3.0 * omega2);  // multiplies mu12*eta22
    gradient[3] = eta12 * c_0 + eta22 * c_1;  // by mu12
    gradient[21] = mu12 * c_0;  // by eta12
    gradient[30] = mu12 * c_1;  // by eta22
  }
  void lump_harmonic_re_v1_conjA_v12_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -3.0 * omega1_2 * delta21 * eta12 * over_15 / omega2;
    const double f_1 = 4.0 * omega1 * delta21 * eta12 * over_15;
    const double f_2 = -3.0 * omega2 * delta21 * eta12 * over_15 / 2.0;
    const double f_3 = alpha21 * eta12 * over_15 / omega2;
    const double f_4 = -alpha21 * eta12 * over_15 / (3.0 * omega1);
    const double f_5 = omega2 * alpha21 * eta12 * over_15 / (6.0 * omega1_2);
    const double q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_1;
    const double q_5 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_5;
    const double q_6 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_6;
    gradient[0] = (2.0 * f_0 + f_1 - f_4 - 2.0 * f_5) / omega1 - q_1 - 2.0 * q_5 - 3.0 * q_6;  // by omega1
    gradient[1] = (-f_0 + f_2 - f_3 + f_5) / omega2 + q_1 + q_5 + q_6;  // by omega2
    const double c_0 = (6.0 * omega1_2 - 2.0 * omega1 * omega2 + omega2_2) * over_15 / (6.0 * omega1_2 * omega2);
    const double c_1 = (-6.0 * omega1_2 + 8.0 * omega1 * omega2 - 3.0 * omega2_2) * over_15 / (2.0 * omega2);
    gradient[5] = eta12 * c_0;  // by alpha21
    gradient[8] = eta12 * c_1;  // by delta21
    gradient[21] = alpha21 * c_0 + delta21 * c_1;  // by eta12
  }
  void lump_harmonic_re_v1_A_v2_conjA_v1_F_of_primary_2([[maybe_unused]] double* gradient) const {
    const double f_0 = -omega1_2 * delta22 * eta22 * per_1 / (12.0 * omega2_3);
    const double f_1 = omega1 * delta22 * eta22 * per_1 / (6.0 * omega2_2);
    const double f_2 = alpha22 * eta22 * per_1 / (12.0 * omega2_3);
    const double f_3 = omega1 * delta22 * eta12 * per_5 / (2.0 * omega2_2);
    const double f_4 = -delta22 * eta12 * per_5 / (2.0 * omega2);
    const double f_5 = -alpha22 * eta12 * over_19 / (2.0 * omega2_2);
    const double q_1 = (f_0 + f_1 + f_2 + f_5) * per_1;
    const double q_5 = (f_3 + f_4 + f_5) * per_5;
    gradient[0] = (2.0 * f_0 + f_1 + f_3) / omega1 - q_1 - 2.0 * q_5;  // by omega1
    gradient[1] = (-3.0 * f_0 - 2.0 * f_1 - 3.0 * f_2 - 2.0 * f_3 - f_4 - 2.0 * f_5) / omega2 + q_1 + q_5;
    const double c_0 = -over_19 / (2.0 * omega2_2);  // multiplies alpha22*eta12
    const double c_1 = per_1 / (12.0 * omega2_3);  // multiplies alpha22*eta22
    const double c_2 = (omega1 - omega2) * per_5 / (2.0 * omega2_2);  // multiplies delta22*eta12
    const double c_3 = (-omega1_2 + 2.0 * omega1 * omega2) * per_1 / (12.0 * omega2_3);  // multiplies delta22*eta22
    gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
    gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
    gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
    gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  }
  void lump_harmonic_re_v1_A_v1_A_v2_F_of_primary_2([[maybe_unused]] double* gradient) const {
    const double f_0 = omega1_2 * delta22 * eta22 * per_0 / (12.0 * omega2_3);
    const double f_1 = omega1 * delta22 * eta22 * per_0 / (6.0 * omega2_2);
    const double f_2 = -alpha22 * eta22 * per_0 / (12.0 * omega2_3);
    const double f_3 = omega1 * delta22 * eta12 * per_4 / (2.0 * omega2_2);
    const double f_4 = delta22 * eta12 * per_4 / (2.0 * omega2);
    const double f_5 = -alpha22 * eta12 * over_22 / (2.0 * omega2_2);
    const double q_0 = (f_0 + f_1 + f_2 + f_5) * per_0;
    const double q_4 = (f_3 + f_4 + f_5) * per_4;
    gradient[0] = (2.0 * f_0 + f_1 + f_3) / omega1 - q_0 - 2.0 * q_4;  // by omega1
    gradient[1] = (-3.0 * f_0 - 2.0 * f_1 - 3.0 * f_2 - 2.0 * f_3 - f_4 - 2.0 * f_5) / omega2 - q_0 - q_4;
    const double c_0 = -over_22 / (2.0 * omega2_2);  // multiplies alpha22*eta12
    const double c_1 = -per_0 / (12.0 * omega2_3);  // multiplies alpha22*eta22
    const double c_2 = (omega1 + omega2) * per_4 / (2.0 * omega2_2);  // multiplies delta22*eta12
    const double c_3 = (omega1_2 + 2.0 * omega1 * omega2) * per_0 / (12.0 * omega2_3);  // multiplies delta22*eta22
    gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
    gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
    gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
    gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  }
  void lump_harmonic_re_v1_A_v12_F_of_primary_2([[maybe_unused]] double* gradient) const {
    const double f_0 = 3.0 * omega1_2 * delta21 * eta12 * over_28 / omega2;
    const double f_1 = 4.0 * omega1 * delta21 * eta12 * over_28;
    const double f_2 = 3.0 * omega2 * delta21 * eta12 * over_28 / 2.0;
    const double f_3 = -alpha21 * eta12 * over_28 / omega2;
    const double f_4 = -alpha21 * eta12 * over_28 / (3.0 * omega1);
    const double f_5 = -omega2 * alpha21 * eta12 * over_28 / (6.0 * omega1_2);
    const double q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_0;
    const double q_4 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_4;
    const double q_9 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_9;
    gradient[0] = (2.0 * f_0 + f_1 - f_4 - 2.0 * f_5) / omega1 - q_0 - 2.0 * q_4 - 3.0 * q_9;  // by omega1
    gradient[1] = (-f_0 + f_2 - f_3 + f_5) / omega2 - q_0 - q_4 - q_9;  // by omega2
    const double c_0 = (-6.0 * omega1_2 - 2.0 * omega1 * omega2 - omega2_2) * over_28 / (6.0 * omega1_2 * omega2);
    const double c_1 = (6.0 * omega1_2 + 8.0 * omega1 * omega2 + 3.0 * omega2_2) * over_28 / (2.0 * omega2);
    gradient[5] = eta12 * c_0;  // by alpha21
    gradient[8] = eta12 * c_1;  // by delta21
    gradient[21] = alpha21 * c_0 + delta21 * c_1;  // by eta12
  }
  void lump_harmonic_im_v2_conjA_v1_F_of_primary_2([[maybe_unused]] double* gradient) const {
    const double f_0 = -eta12 * mu21 * over_3 / (2.0 * omega2);
    const double f_1 = eta12 * mu21 * over_3 / (2.0 * omega1);
    const double f_2 = mu21 * eta22 * over_10 / 2.0;
    const double q_0 = f_2 * per_0;
    const double q_1 = f_2 * per_1;
    const double q_3 = (f_0 + f_1 + f_2) * per_3;
    const double q_5 = (f_0 + f_1) * per_5;
    gradient[0] = -f_1 / omega1 - q_0 - q_1 - q_3 - 2.0 * q_5;  // by omega1
    gradient[1] = -f_0 / omega2 - q_0 + q_1 + 2.0 * q_3 + q_5;  // by omega2
    const double c_0 = (-omega1 + omega2) * over_3 / (2.0 * omega1 * omega2);  // multiplies eta12*mu21
    const double c_1 = over_10 / 2.0;  // multiplies mu21*eta22
    gradient[21] = mu21 * c_0;  // by eta12
    gradient[23] = eta12 * c_0 + eta22 * c_1;  // by mu21
    gradient[30] = mu21 * c_1;  // by eta22
  }
  void lump_harmonic_re_v2_A_v1_conjA_v2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -omega2 * delta23 * eta22 * over_45 / omega1;
    const double f_1 = omega1 * alpha23 * eta22 * over_10 / omega2_2;
    const double f_2 = -2.0 * alpha23 * eta22 * over_10 / omega2;
    const double f_3 = -alpha23 * eta22 * over_10 / omega1;
    const double f_4 = -omega1 * delta23 * eta12 * over_11;
    const double f_5 = -alpha23 * eta12 * over_11 / omega2;
    const double q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_0;
    const double q_1 = (f_1 + f_2 + f_3 + f_4 + f_5) * per_1;
    const double q_3 = (f_0 + f_1 + f_2 + f_3) * per_3;
    const double q_4 = (f_4 + f_5) * per_4;
    gradient[0] = (-f_0 + f_1 - f_3 + f_4) / omega1 - q_0 - q_1 - q_3 - 2.0 * q_4;  // by omega1
    gradient[1] = (f_0 - 2.0 * f_1 - f_2 - f_5) / omega2 - q_0 + q_1 + 2.0 * q_3 - q_4;  // by omega2
    const double c_0 = -over_11 / omega2;  // multiplies alpha23*eta12
    const double c_1 = (omega1_2 - 2.0 * omega1 * omega2 - omega2_2) * over_10 / (omega1 * omega2_2);
    const double c_2 = -omega1 * over_11;  // multiplies delta23*eta12
    const double c_3 = -omega2 * over_45 / omega1;  // multiplies delta23*eta22
    gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
    gradient[10] = eta12 * c_2 + eta22 * c_3;  // by delta23
    gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
    gradient[30] = alpha23 * c_1 + delta23 * c_3;  // by eta22
  }
  void lump_harmonic_re_v2_A_v1_A_v2_F_of_primary_2([[maybe_unused]] double* gradient) const {
    const double f_0 = omega2 * delta23 * eta22 * over_46 / omega1;
    const double f_1 = omega1 * alpha23 * eta22 * over_6 / omega2_2;
    const double f_2 = 2.0 * alpha23 * eta22 * over_6 / omega2;
    const double f_3 = -alpha23 * eta22 * over_6 / omega1;
    const double f_4 = -omega1 * delta23 * eta12 * over_4;
    const double f_5 = alpha23 * eta12 * over_4 / omega2;
    const double q_0 = (f_1 + f_2 + f_3 + f_4 + f_5) * per_0;
    const double q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_1;
    const double q_2 = (f_0 + f_1 + f_2 + f_3) * per_2;
    const double q_5 = (f_4 + f_5) * per_5;
    gradient[0] = (-f_0 + f_1 - f_3 + f_4) / omega1 - q_0 - q_1 - q_2 - 2.0 * q_5;  // by omega1
    gradient[1] = (f_0 - 2.0 * f_1 - f_2 - f_5) / omega2 - q_0 + q_1 - 2.0 * q_2 + q_5;  // by omega2
    const double c_0 = over_4 / omega2;  // multiplies alpha23*eta12
    const double c_1 = (omega1_2 + 2.0 * omega1 * omega2 - omega2_2) * over_6 / (omega1 * omega2_2);
    const double c_2 = -omega1 * over_4;  // multiplies delta23*eta12
    const double c_3 = omega2 * over_46 / omega1;  // multiplies delta23*eta22
    gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
    gradient[10] = eta12 * c_2 + eta22 * c_3;  // by delta23
    gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
    gradient[30] = alpha23 * c_1 + delta23 * c_3;  // by eta22
  }
  void lump_harmonic_im_v2_A_v1_F_of_primary_2([[maybe_unused]] double* gradient) const {
    const double f_0 = -eta12 * mu21 * over_12 / (2.0 * omega2);
    const double f_1 = -eta12 * mu21 * over_12 / (2.0 * omega1);
    const double f_2 = -mu21 * eta22 * over_6 / 2.0;
    const double q_0 = f_2 * per_0;
    const double q_1 = f_2 * per_1;
    const double q_2 = (f_0 + f_1 + f_2) * per_2;
    const double q_4 = (f_0 + f_1) * per_4;
    gradient[0] = -f_1 / omega1 - q_0 - q_1 - q_2 - 2.0 * q_4;  // by omega1
    gradient[1] = -f_0 / omega2 - q_0 + q_1 - 2.0 * q_2 - q_4;  // by omega2
    const double c_0 = (-omega1 - omega2) * over_12 / (2.0 * omega1 * omega2);  // multiplies eta12*mu21
    const double c_1 = -over_6 / 2.0;  // multiplies mu21*eta22
    gradient[21] = mu21 * c_0;  // by eta12
    gradient[23] = eta12 * c_0 + eta22 * c_1;  // by mu21
    gradient[30] = mu21 * c_1;  // by eta22
  }
  void lump_harmonic_re_v2_conjA_v12_F([[maybe_unused]] double* gradient) const {
    const double f_0 = delta22 * eta12 * per_5 / (4.0 * omega2);
    const double f_1 = alpha22 * eta12 * over_19 / (4.0 * omega1 * omega2);
    const double f_2 = -omega1 * delta22 * eta22 * over_31 / 8.0;
    const double f_3 = -alpha22 * eta22 * over_31 / (8.0 * omega1);
    const double q_1 = (f_1 + f_2 + f_3) * per_1;
    const double q_4 = (f_2 + f_3) * per_4;
    const double q_5 = (f_0 + f_1 + f_2 + f_3) * per_5;
    gradient[0] = (-f_1 + f_2 - f_3) / omega1 - q_1 - 2.0 * q_4 - 2.0 * q_5;  // by omega1
    gradient[1] = (-f_0 - f_1) / omega2 + q_1 - q_4 + q_5;  // by omega2
    const double c_0 = over_19 / (4.0 * omega1 * omega2);  // multiplies alpha22*eta12
    const double c_1 = -over_31 / (8.0 * omega1);  // multiplies alpha22*eta22
    const double c_2 = per_5 / (4.0 * omega2);  // multiplies delta22*eta12
    const double c_3 = -omega1 * over_31 / 8.0;  // multiplies delta22*eta22
    gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
    gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
    gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
    gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  }
  void lump_harmonic_re_v2_A_v2_conjA_v1_F_of_primary_2([[maybe_unused]] double* gradient) const {
    const double f_0 = -2.0 * omega1_2 * delta23 * eta22 * over_34 / (3.0 * omega2);
    const double f_1 = 8.0 * omega1 * delta23 * eta22 * over_34 / 3.0;
    const double f_2 = -omega1 * alpha23 * eta22 * over_34 / (3.0 * omega2_2);
    const double f_3 = -11.0 * omega2 * delta23 * eta22 * over_34 / 3.0;
    const double f_4 = 2.0 * alpha23 * eta22 * over_34 / (3.0 * omega2);
    const double f_5 = omega2_2 * delta23 * eta22 * over_34 / omega1;
    const double f_6 = -alpha23 * eta22 * over_34 / omega1;
    const double f_7 = omega1 * delta23 * eta12 * over_47;
    const double f_8 = -2.0 * omega2 * delta23 * eta12 * over_47;
    const double f_9 = alpha23 * eta12 * over_47 / omega2;
    const double q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_1;
    const double q_3 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_3;
    const double q_5 = (f_7 + f_8 + f_9) * per_5;
    const double q_8 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_8;
    gradient[0] = (2.0 * f_0 + f_1 + f_2 - f_5 - f_6 + f_7) / omega1 - q_1 - q_3 - 2.0 * q_5 - q_8;  // by omega1
    gradient[1] = (-f_0 - 2.0 * f_2 + f_3 - f_4 + 2.0 * f_5 + f_8 - f_9) / omega2 + q_1 + 2.0 * q_3 + q_5
        + 3.0 * q_8;
    const double c_0 = over_47 / omega2;  // multiplies alpha23*eta12
    const double c_1 = (-omega1_2 + 2.0 * omega1 * omega2 - 3.0 * omega2_2) * over_34 / (3.0 * omega1 * omega2_2);
    const double c_2 = (omega1 - 2.0 * omega2) * over_47;  // multiplies delta23*eta12
    const double c_3 = (-2.0 * omega1_3 + 8.0 * omega1_2 * omega2 - 11.0 * omega1 * omega2_2
        + 3.0 * omega2_3) * over_34 / (3.0 * omega1 * omega2);
    gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
    gradient[10] = eta12 * c_2 + eta22 * c_3;  // by delta23
    gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
    gradient[30] = alpha23 * c_1 + delta23 * c_3;  // by eta22
  }
  void lump_harmonic_re_v2_A_v22_F_of_primary_2([[maybe_unused]] double* gradient) const {
    gradient[1] = (-17.0 * omega2_2 * delta24 * eta22 + 6.0 * alpha24 * eta22) / (24.0 * omega2_5);  // by omega2
    gradient[25] = -eta22 / (16.0 * omega2_4);  // by alpha24
    gradient[26] = 17.0 * eta22 / (48.0 * omega2_2);  // by delta24
    gradient[30] = (17.0 * omega2_2 * delta24 - 3.0 * alpha24) / (48.0 * omega2_4);  // by eta22
  }
  void lump_harmonic_re_v2_A_v12_F_of_primary_2([[maybe_unused]] double* gradient) const {
    const double f_0 = -delta22 * eta12 * per_4 / (4.0 * omega2);
    const double f_1 = -alpha22 * eta12 * over_22 / (4.0 * omega1 * omega2);
    const double f_2 = -omega1 * delta22 * eta22 * over_37 / 8.0;
    const double f_3 = -alpha22 * eta22 * over_37 / (8.0 * omega1);
    const double q_0 = (f_1 + f_2 + f_3) * per_0;
    const double q_4 = (f_0 + f_1 + f_2 + f_3) * per_4;
    const double q_5 = (f_2 + f_3) * per_5;
    gradient[0] = (-f_1 + f_2 - f_3) / omega1 - q_0 - 2.0 * q_4 - 2.0 * q_5;  // by omega1
    gradient[1] = (-f_0 - f_1) / omega2 - q_0 - q_4 + q_5;  // by omega2
    const double c_0 = -over_22 / (4.0 * omega1 * omega2);  // multiplies alpha22*eta12
    const double c_1 = -over_37 / (8.0 * omega1);  // multiplies alpha22*eta22
    const double c_2 = -per_4 / (4.0 * omega2);  // multiplies delta22*eta12
    const double c_3 = -omega1 * over_37 / 8.0;  // multiplies delta22*eta22
    gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
    gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
    gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
    gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  }
  void lump_conservative_v1_conjA_v1_F([[maybe_unused]] double* gradient) const {
    const double f_0 = (2.0 * delta21 * eta11 - eta12) / (4.0 * omega1);
    const double f_1 = -alpha21 * eta11 / (6.0 * omega1_3);
    const double f_2 = -omega1 * delta22 * eta21 * over_2 / 2.0;
    const double f_3 = -alpha22 * eta21 * over_2 / (2.0 * omega1);
    const double q_4 = (f_2 + f_3) * per_4;
    const double q_5 = (f_2 + f_3) * per_5;
    gradient[0] = (-f_0 - 3.0 * f_1 + f_2 - f_3) / omega1 - 2.0 * q_4 - 2.0 * q_5;  // by omega1
    gradient[1] = -q_4 + q_5;  // by omega2
    const double c_0 = -1.0 / (6.0 * omega1_3);  // multiplies alpha21*eta11
    const double c_1 = -over_2 / (2.0 * omega1);  // multiplies alpha22*eta21
    const double c_2 = 1.0 / (2.0 * omega1);  // multiplies delta21*eta11
    const double c_3 = -omega1 * over_2 / 2.0;  // multiplies delta22*eta21
    const double c_4 = -1.0 / (4.0 * omega1);  // multiplies eta12
    gradient[5] = eta11 * c_0;  // by alpha21
    gradient[6] = eta21 * c_1;  // by alpha22
    gradient[8] = eta11 * c_2;  // by delta21
    gradient[9] = eta21 * c_3;  // by delta22
    gradient[20] = alpha21 * c_0 + delta21 * c_2;  // by eta11
    gradient[21] = c_4;  // by eta12
    gradient[29] = alpha22 * c_1 + delta22 * c_3;  // by eta21
  }
  void lump_harmonic_im_v1_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -mu12 * eta21 * over_2 / (3.0 * omega1);
    const double q_4 = f_0 * per_4;
    const double q_5 = f_0 * per_5;
    gradient[0] = -f_0 / omega1 - 2.0 * q_4 - 2.0 * q_5;  // by omega1
    gradient[1] = -q_4 + q_5;  // by omega2
    const double c_0 = -over_2 / (3.0 * omega1);  // multiplies mu12*eta21
    gradient[3] = eta21 * c_0;  // by mu12
    gradient[29] = mu12 * c_0;  // by eta21
  }
  void lump_harmonic_re_v1_A_v2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = 4.0 * delta22 * eta11 * over_13 / 3.0;
    const double f_1 = -2.0 * omega2 * delta22 * eta11 * over_13 / (3.0 * omega1);
    const double f_2 = -alpha22 * eta11 * over_13 / (3.0 * omega1_2);
    const double f_3 = 2.0 * omega1 * omega2 * delta23 * eta21 * over_16;
    const double f_4 = -alpha23 * eta21 * over_16;
    const double q_1 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_1;
    const double q_4 = (f_3 + f_4) * per_4;
    const double q_5 = (f_3 + f_4) * per_5;
    const double q_6 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_6;
    gradient[0] = (-f_1 - 2.0 * f_2 + f_3) / omega1 - q_1 - 2.0 * q_4 - 2.0 * q_5 - 3.0 * q_6;  // by omega1
    gradient[1] = (f_1 + f_3) / omega2 + q_1 - q_4 + q_5 + q_6;  // by omega2
    const double c_0 = -over_13 / (3.0 * omega1_2);  // multiplies alpha22*eta11
    const double c_1 = -over_16;  // multiplies alpha23*eta21
    const double c_2 = (4.0 * omega1 - 2.0 * omega2) * over_13 / (3.0 * omega1);  // multiplies delta22*eta11
    const double c_3 = 2.0 * omega1 * omega2 * over_16;  // multiplies delta23*eta21
    gradient[6] = eta11 * c_0;  // by alpha22
    gradient[7] = eta21 * c_1;  // by alpha23
    gradient[9] = eta11 * c_2;  // by delta22
    gradient[10] = eta21 * c_3;  // by delta23
    gradient[20] = alpha22 * c_0 + delta22 * c_2;  // by eta11
    gradient[29] = alpha23 * c_1 + delta23 * c_3;  // by eta21
  }
  void lump_harmonic_re_v1_A_v1_F([[maybe_unused]] double* gradient) const {
    const double f_0 = (14.0 * delta21 * eta11 - 3.0 * eta12) / (48.0 * omega1_2);
    const double f_1 = -alpha21 * eta11 / (24.0 * omega1_4);
    const double f_2 = 3.0 * delta22 * eta21 * over_2 / 8.0;
    const double f_3 = -alpha22 * eta21 * over_2 / (8.0 * omega1_2);
    const double q_4 = (f_2 + f_3) * per_4;
    const double q_5 = (f_2 + f_3) * per_5;
    gradient[0] = (-2.0 * f_0 - 4.0 * f_1 - 2.0 * f_3) / omega1 - 2.0 * q_4 - 2.0 * q_5;  // by omega1
    gradient[1] = -q_4 + q_5;  // by omega2
    const double c_0 = -1.0 / (24.0 * omega1_4);  // multiplies alpha21*eta11
    const double c_1 = -over_2 / (8.0 * omega1_2);  // multiplies alpha22*eta21
    const double c_2 = 7.0 / (24.0 * omega1_2);  // multiplies delta21*eta11
    const double c_3 = 3.0 * over_2 / 8.0;  // multiplies delta22*eta21
    const double c_4 = -1.0 / (16.0 * omega1_2);  // multiplies eta12
    gradient[5] = eta11 * c_0;  // by alpha21
    gradient[6] = eta21 * c_1;  // by alpha22
    gradient[8] = eta11 * c_2;  // by delta21
    gradient[9] = eta21 * c_3;  // by delta22
    gradient[20] = alpha21 * c_0 + delta21 * c_2;  // by eta11
    gradient[21] = c_4;  // by eta12
    gradient[29] = alpha22 * c_1 + delta22 * c_3;  // by eta21
  }
  void lump_harmonic_im_v2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -eta11 * mu21 * over_2 / (3.0 * omega1);
    const double q_4 = f_0 * per_4;
    const double q_5 = f_0 * per_5;
    gradient[0] = -f_0 / omega1 - 2.0 * q_4 - 2.0 * q_5;  // by omega1
    gradient[1] = -q_4 + q_5;  // by omega2
    const double c_0 = -over_2 / (3.0 * omega1);  // multiplies eta11*mu21
    gradient[20] = mu21 * c_0;  // by eta11
    gradient[23] = eta11 * c_0;  // by mu21
  }
  void lump_harmonic_re_v2_conjA_v1_F([[maybe_unused]] double* gradient) const {
    const double f_0 = 2.0 * delta22 * eta11 * over_0 / 3.0;
    const double f_1 = -alpha22 * eta11 * over_0 / (3.0 * omega1_2);
    const double f_2 = 2.0 * omega1_2 * delta23 * eta21 * over_8;
    const double f_3 = -alpha23 * eta21 * over_8;
    const double q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
    const double q_1 = (f_0 + f_1 + f_2 + f_3) * per_1;
    const double q_4 = (f_2 + f_3) * per_4;
    const double q_5 = (f_2 + f_3) * per_5;
    gradient[0] = (-2.0 * f_1 + 2.0 * f_2) / omega1 - q_0 - q_1 - 2.0 * q_4 - 2.0 * q_5;  // by omega1
    gradient[1] = -q_0 + q_1 - q_4 + q_5;  // by omega2
    const double c_0 = -over_0 / (3.0 * omega1_2);  // multiplies alpha22*eta11
    const double c_1 = -over_8;  // multiplies alpha23*eta21
    const double c_2 = 2.0 * over_0 / 3.0;  // multiplies delta22*eta11
    const double c_3 = 2.0 * omega1_2 * over_8;  // multiplies delta23*eta21
    gradient[6] = eta11 * c_0;  // by alpha22
    gradient[7] = eta21 * c_1;  // by alpha23
    gradient[9] = eta11 * c_2;  // by delta22
    gradient[10] = eta21 * c_3;  // by delta23
    gradient[20] = alpha22 * c_0 + delta22 * c_2;  // by eta11
    gradient[29] = alpha23 * c_1 + delta23 * c_3;  // by eta21
  }
  void lump_harmonic_re_v2_A_v2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -eta22 * per_1 / (8.0 * omega1);
    const double f_1 = -omega2 * delta23 * eta11 * per_1 / (6.0 * omega1_2);
    const double f_2 = omega2_2 * delta23 * eta11 * per_1 / (12.0 * omega1_3);
    const double f_3 = -alpha23 * eta11 * per_1 / (12.0 * omega1_3);
    const double f_4 = omega1 * delta24 * eta21 * over_31;
    const double f_5 = -omega2 * delta24 * eta21 * over_31 / 2.0;
    const double f_6 = omega2_2 * delta24 * eta21 * over_31 / (4.0 * omega1);
    const double f_7 = -alpha24 * eta21 * over_31 / (4.0 * omega1);
    const double q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7) * per_1;
    const double q_4 = (f_4 + f_5 + f_6 + f_7) * per_4;
    const double q_5 = (f_4 + f_5 + f_6 + f_7) * per_5;
    gradient[0] = (-f_0 - 2.0 * f_1 - 3.0 * f_2 - 3.0 * f_3 + f_4 - f_6 - f_7) / omega1 - q_1 - 2.0 * q_4
        - 2.0 * q_5;
    gradient[1] = (f_1 + 2.0 * f_2 + f_5 + 2.0 * f_6) / omega2 + q_1 - q_4 + q_5;  // by omega2
    const double c_0 = -per_1 / (12.0 * omega1_3);  // multiplies alpha23*eta11
    const double c_1 = (-2.0 * omega1 * omega2 + omega2_2) * per_1 / (12.0 * omega1_3);  // multiplies delta23*eta11
    const double c_2 = -over_31 / (4.0 * omega1);  // multiplies alpha24*eta21
    const double c_3 = (4.0 * omega1_2 - 2.0 * omega1 * omega2 + omega2_2) * over_31 / (4.0 * omega1);
    const double c_4 = -per_1 / (8.0 * omega1);  // multiplies eta22
    gradient[7] = eta11 * c_0;  // by alpha23
    gradient[10] = eta11 * c_1;  // by delta23
    gradient[20] = alpha23 * c_0 + delta23 * c_1;  // by eta11
    gradient[25] = eta21 * c_2;  // by alpha24
    gradient[26] = eta21 * c_3;  // by delta24
    gradient[29] = alpha24 * c_2 + delta24 * c_3;  // by eta21
    gradient[30] = c_4;  // by eta22
  }
  void lump_harmonic_re_v2_A_v1_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -2.0 * delta22 * eta11 * over_43 / 3.0;
    const double f_1 = -alpha22 * eta11 * over_43 / (3.0 * omega1_2);
    const double f_2 = 6.0 * omega1_2 * delta23 * eta21 * over_44;
    const double f_3 = -alpha23 * eta21 * over_44;
    const double q_4 = (f_2 + f_3) * per_4;
    const double q_5 = (f_2 + f_3) * per_5;
    const double q_6 = (f_0 + f_1 + f_2 + f_3) * per_6;
    const double q_9 = (f_0 + f_1 + f_2 + f_3) * per_9;
    gradient[0] = (-2.0 * f_1 + 2.0 * f_2) / omega1 - 2.0 * q_4 - 2.0 * q_5 - 3.0 * q_6 - 3.0 * q_9;  // by omega1
    gradient[1] = -q_4 + q_5 + q_6 - q_9;  // by omega2
    const double c_0 = -over_43 / (3.0 * omega1_2);  // multiplies alpha22*eta11
    const double c_1 = -over_44;  // multiplies alpha23*eta21
    const double c_2 = -2.0 * over_43 / 3.0;  // multiplies delta22*eta11
    const double c_3 = 6.0 * omega1_2 * over_44;  // multiplies delta23*eta21
    gradient[6] = eta11 * c_0;  // by alpha22
    gradient[7] = eta21 * c_1;  // by alpha23
    gradient[9] = eta11 * c_2;  // by delta22
    gradient[10] = eta21 * c_3;  // by delta23
    gradient[20] = alpha22 * c_0 + delta22 * c_2;  // by eta11
    gradient[29] = alpha23 * c_1 + delta23 * c_3;  // by eta21
  }
  void lump_conservative_v2_conjA_v2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = (2.0 * delta24 * eta21 - eta22) / (4.0 * omega2);
    const double f_1 = -alpha24 * eta21 / (6.0 * omega2_3);
    const double f_2 = omega2 * delta23 * eta11 * over_1 / 2.0;
    const double f_3 = alpha23 * eta11 * over_1 / (2.0 * omega2);
    const double q_2 = (f_2 + f_3) * per_2;
    const double q_3 = (f_2 + f_3) * per_3;
    gradient[0] = -q_2 - q_3;  // by omega1
    gradient[1] = (-f_0 - 3.0 * f_1 + f_2 - f_3) / omega2 - 2.0 * q_2 + 2.0 * q_3;  // by omega2
    const double c_0 = over_1 / (2.0 * omega2);  // multiplies alpha23*eta11
    const double c_1 = omega2 * over_1 / 2.0;  // multiplies delta23*eta11
    const double c_2 = -1.0 / (6.0 * omega2_3);  // multiplies alpha24*eta21
    const double c_3 = 1.0 / (2.0 * omega2);  // multiplies delta24*eta21
    const double c_4 = -1.0 / (4.0 * omega2);  // multiplies eta22
    gradient[7] = eta11 * c_0;  // by alpha23
    gradient[10] = eta11 * c_1;  // by delta23
    gradient[20] = alpha23 * c_0 + delta23 * c_1;  // by eta11
    gradient[25] = eta21 * c_2;  // by alpha24
    gradient[26] = eta21 * c_3;  // by delta24
    gradient[29] = alpha24 * c_2 + delta24 * c_3;  // by eta21
    gradient[30] = c_4;  // by eta22
  }
  void lump_harmonic_im_v1_F_of_principal_parametric_2([[maybe_unused]] double* gradient) const {
    const double f_0 = mu12 * eta21 * over_1 / (3.0 * omega2);
    const double q_2 = f_0 * per_2;
    const double q_3 = f_0 * per_3;
    gradient[0] = -q_2 - q_3;  // by omega1
    gradient[1] = -f_0 / omega2 - 2.0 * q_2 + 2.0 * q_3;  // by omega2
    const double c_0 = over_1 / (3.0 * omega2);  // multiplies mu12*eta21
    gradient[3] = eta21 * c_0;  // by mu12
    gradient[29] = mu12 * c_0;  // by eta21
  }
  void lump_harmonic_re_v1_conjA_v2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -2.0 * delta23 * eta21 * over_0 / 3.0;
    const double f_1 = alpha23 * eta21 * over_0 / (3.0 * omega2_2);
    const double f_2 = 2.0 * omega2_2 * delta22 * eta11 * over_7;
    const double f_3 = -alpha22 * eta11 * over_7;
    const double q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
    const double q_1 = (f_0 + f_1 + f_2 + f_3) * per_1;
    const double q_2 = (f_2 + f_3) * per_2;
    const double q_3 = (f_2 + f_3) * per_3;
    gradient[0] = -q_0 - q_1 - q_2 - q_3;  // by omega1
    gradient[1] = (-2.0 * f_1 + 2.0 * f_2) / omega2 - q_0 + q_1 - 2.0 * q_2 + 2.0 * q_3;  // by omega2
    const double c_0 = -over_7;  // multiplies alpha22*eta11
    const double c_1 = over_0 / (3.0 * omega2_2);  // multiplies alpha23*eta21
    const double c_2 = 2.0 * omega2_2 * over_7;  // multiplies delta22*eta11
    const double c_3 = -2.0 * over_0 / 3.0;  // multiplies delta23*eta21
    gradient[6] = eta11 * c_0;  // by alpha22
    gradient[7] = eta21 * c_1;  // by alpha23
    gradient[9] = eta11 * c_2;  // by delta22
    gradient[10] = eta21 * c_3;  // by delta23
    gradient[20] = alpha22 * c_0 + delta22 * c_2;  // by eta11
    gradient[29] = alpha23 * c_1 + delta23 * c_3;  // by eta21
  }
  void lump_harmonic_re_v1_conjA_v1_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -omega1_2 * delta22 * eta21 * per_1 / (12.0 * omega2_3);
    const double f_1 = omega1 * delta22 * eta21 * per_1 / (6.0 * omega2_2);
    const double f_2 = eta12 * per_1 / (8.0 * omega2);
    const double f_3 = alpha22 * eta21 * per_1 / (12.0 * omega2_3);
    const double f_4 = omega1_2 * delta21 * eta11 * over_20 / (4.0 * omega2);
    const double f_5 = -omega1 * delta21 * eta11 * over_20 / 2.0;
    const double f_6 = omega2 * delta21 * eta11 * over_20;
    const double f_7 = -alpha21 * eta11 * over_20 / (4.0 * omega2);
    const double q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7) * per_1;
    const double q_2 = (f_4 + f_5 + f_6 + f_7) * per_2;
    const double q_3 = (f_4 + f_5 + f_6 + f_7) * per_3;
    gradient[0] = (2.0 * f_0 + f_1 + 2.0 * f_4 + f_5) / omega1 - q_1 - q_2 - q_3;  // by omega1
    gradient[1] = (-3.0 * f_0 - 2.0 * f_1 - f_2 - 3.0 * f_3 - f_4 + f_6 - f_7) / omega2 + q_1 - 2.0 * q_2
        + 2.0 * q_3;
    const double c_0 = -over_20 / (4.0 * omega2);  // multiplies alpha21*eta11
    const double c_1 = per_1 / (12.0 * omega2_3);  // multiplies alpha22*eta21
    const double c_2 = (omega1_2 - 2.0 * omega1 * omega2 + 4.0 * omega2_2) * over_20 / (4.0 * omega2);
    const double c_3 = (-omega1_2 + 2.0 * omega1 * omega2) * per_1 / (12.0 * omega2_3);  // multiplies delta22*eta21
    const double c_4 = per_1 / (8.0 * omega2);  // multiplies eta12
    gradient[5] = eta11 * c_0;  // by alpha21
    gradient[6] = eta21 * c_1;  // by alpha22
    gradient[8] = eta11 * c_2;  // by delta21
    gradient[9] = eta21 * c_3;  // by delta22
    gradient[20] = alpha21 * c_0 + delta21 * c_2;  // by eta11
    gradient[21] = c_4;  // by eta12
    gradient[29] = alpha22 * c_1 + delta22 * c_3;  // by eta21
  }
  void lump_harmonic_re_v1_A_v2_F_of_principal_parametric_2([[maybe_unused]] double* gradient) const {
    const double f_0 = 2.0 * delta23 * eta21 * over_24 / 3.0;
    const double f_1 = alpha23 * eta21 * over_24 / (3.0 * omega2_2);
    const double f_2 = 6.0 * omega2_2 * delta22 * eta11 * over_25;
    const double f_3 = -alpha22 * eta11 * over_25;
    const double q_2 = (f_2 + f_3) * per_2;
    const double q_3 = (f_2 + f_3) * per_3;
    const double q_7 = (f_0 + f_1 + f_2 + f_3) * per_7;
    const double q_8 = (f_0 + f_1 + f_2 + f_3) * per_8;
    gradient[0] = -q_2 - q_3 - q_7 - q_8;  // by omega1
    gradient[1] = (-2.0 * f_1 + 2.0 * f_2) / omega2 - 2.0 * q_2 + 2.0 * q_3 - 3.0 * q_7 + 3.0 * q_8;  // by omega2
    const double c_0 = -over_25;  // multiplies alpha22*eta11
    const double c_1 = over_24 / (3.0 * omega2_2);  // multiplies alpha23*eta21
    const double c_2 = 6.0 * omega2_2 * over_25;  // multiplies delta22*eta11
    const double c_3 = 2.0 * over_24 / 3.0;  // multiplies delta23*eta21
    gradient[6] = eta11 * c_0;  // by alpha22
    gradient[7] = eta21 * c_1;  // by alpha23
    gradient[9] = eta11 * c_2;  // by delta22
    gradient[10] = eta21 * c_3;  // by delta23
    gradient[20] = alpha22 * c_0 + delta22 * c_2;  // by eta11
    gradient[29] = alpha23 * c_1 + delta23 * c_3;  // by eta21
  }
  void lump_harmonic_re_v1_A_v1_F_of_principal_parametric_2([[maybe_unused]] double* gradient) const {
    const double f_0 = omega1_2 * delta22 * eta21 * per_0 / (12.0 * omega2_3);
    const double f_1 = omega1 * delta22 * eta21 * per_0 / (6.0 * omega2_2);
    const double f_2 = -eta12 * per_0 / (8.0 * omega2);
    const double f_3 = -alpha22 * eta21 * per_0 / (12.0 * omega2_3);
    const double f_4 = -omega1_2 * delta21 * eta11 * over_23 / (4.0 * omega2);
    const double f_5 = -omega1 * delta21 * eta11 * over_23 / 2.0;
    const double f_6 = -omega2 * delta21 * eta11 * over_23;
    const double f_7 = alpha21 * eta11 * over_23 / (4.0 * omega2);
    const double q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7) * per_0;
    const double q_2 = (f_4 + f_5 + f_6 + f_7) * per_2;
    const double q_3 = (f_4 + f_5 + f_6 + f_7) * per_3;
    gradient[0] = (2.0 * f_0 + f_1 + 2.0 * f_4 + f_5) / omega1 - q_0 - q_2 - q_3;  // by omega1
    gradient[1] = (-3.0 * f_0 - 2.0 * f_1 - f_2 - 3.0 * f_3 - f_4 + f_6 - f_7) / omega2 - q_0 - 2.0 * q_2
        + 2.0 * q_3;
    const double c_0 = over_23 / (4.0 * omega2);  // multiplies alpha21*eta11
    const double c_1 = -per_0 / (12.0 * omega2_3);  // multiplies alpha22*eta21
    const double c_2 = (-omega1_2 - 2.0 * omega1 * omega2 - 4.0 * omega2_2) * over_23 / (4.0 * omega2);
    const double c_3 = (omega1_2 + 2.0 * omega1 * omega2) * per_0 / (12.0 * omega2_3);  // multiplies delta22*eta21
    const double c_4 = -per_0 / (8.0 * omega2);  // multiplies eta12
    gradient[5] = eta11 * c_0;  // by alpha21
    gradient[6] = eta21 * c_1;  // by alpha22
    gradient[8] = eta11 * c_2;  // by delta21
    gradient[9] = eta21 * c_3;  // by delta22
    gradient[20] = alpha21 * c_0 + delta21 * c_2;  // by eta11
    gradient[21] = c_4;  // by eta12
    gradient[29] = alpha22 * c_1 + delta22 * c_3;  // by eta21
  }
  void lump_harmonic_im_v2_F_of_principal_parametric_2([[maybe_unused]] double* gradient) const {
    const double f_0 = eta11 * mu21 * over_1 / (3.0 * omega2);
    const double q_2 = f_0 * per_2;
    const double q_3 = f_0 * per_3;
    gradient[0] = -q_2 - q_3;  // by omega1
    gradient[1] = -f_0 / omega2 - 2.0 * q_2 + 2.0 * q_3;  // by omega2
    const double c_0 = over_1 / (3.0 * omega2);  // multiplies eta11*mu21
    gradient[20] = mu21 * c_0;  // by eta11
    gradient[23] = eta11 * c_0;  // by mu21
  }
  void lump_harmonic_re_v2_conjA_v1_F_of_principal_parametric_2([[maybe_unused]] double* gradient) const {
    const double f_0 = -2.0 * omega1 * delta23 * eta21 * over_32 / (3.0 * omega2);
    const double f_1 = 4.0 * delta23 * eta21 * over_32 / 3.0;
    const double f_2 = -alpha23 * eta21 * over_32 / (3.0 * omega2_2);
    const double f_3 = -2.0 * omega1 * omega2 * delta22 * eta11 * over_35;
    const double f_4 = alpha22 * eta11 * over_35;
    const double q_1 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_1;
    const double q_2 = (f_3 + f_4) * per_2;
    const double q_3 = (f_3 + f_4) * per_3;
    const double q_8 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_8;
    gradient[0] = (f_0 + f_3) / omega1 - q_1 - q_2 - q_3 - q_8;  // by omega1
    gradient[1] = (-f_0 - 2.0 * f_2 + f_3) / omega2 + q_1 - 2.0 * q_2 + 2.0 * q_3 + 3.0 * q_8;  // by omega2
    const double c_0 = over_35;  // multiplies alpha22*eta11
    const double c_1 = -over_32 / (3.0 * omega2_2);  // multiplies alpha23*eta21
    const double c_2 = -2.0 * omega1 * omega2 * over_35;  // multiplies delta22*eta11
    const double c_3 = (-2.0 * omega1 + 4.0 * omega2) * over_32 / (3.0 * omega2);  // multiplies delta23*eta21
    gradient[6] = eta11 * c_0;  // by alpha22
    gradient[7] = eta21 * c_1;  // by alpha23
    gradient[9] = eta11 * c_2;  // by delta22
    gradient[10] = eta21 * c_3;  // by delta23
    gradient[20] = alpha22 * c_0 + delta22 * c_2;  // by eta11
    gradient[29] = alpha23 * c_1 + delta23 * c_3;  // by eta21
  }
  void lump_harmonic_re_v2_A_v2_F_of_principal_parametric_2([[maybe_unused]] double* gradient) const {
    const double f_0 = (14.0 * delta24 * eta21 - 3.0 * eta22) / (48.0 * omega2_2);
    const double f_1 = -alpha24 * eta21 / (24.0 * omega2_4);
    const double f_2 = -3.0 * delta23 * eta11 * over_1 / 8.0;
    const double f_3 = alpha23 * eta11 * over_1 / (8.0 * omega2_2);
    const double q_2 = (f_2 + f_3) * per_2;
    const double q_3 = (f_2 + f_3) * per_3;
    gradient[0] = -q_2 - q_3;  // by omega1
    gradient[1] = (-2.0 * f_0 - 4.0 * f_1 - 2.0 * f_3) / omega2 - 2.0 * q_2 + 2.0 * q_3;  // by omega2
    const double c_0 = over_1 / (8.0 * omega2_2);  // multiplies alpha23*eta11
    const double c_1 = -3.0 * over_1 / 8.0;  // multiplies delta23*eta11
    const double c_2 = -1.0 / (24.0 * omega2_4);  // multiplies alpha24*eta21
    const double c_3 = 7.0 / (24.0 * omega2_2);  // multiplies delta24*eta21
    const double c_4 = -1.0 / (16.0 * omega2_2);  // multiplies eta22
    gradient[7] = eta11 * c_0;  // by alpha23
    gradient[10] = eta11 * c_1;  // by delta23
    gradient[20] = alpha23 * c_0 + delta23 * c_1;  // by eta11
    gradient[25] = eta21 * c_2;  // by alpha24
    gradient[26] = eta21 * c_3;  // by delta24
    gradient[29] = alpha24 * c_2 + delta24 * c_3;  // by eta21
    gradient[30] = c_4;  // by eta22
  }
  void lump_harmonic_re_v2_A_v1_F_of_principal_parametric_2([[maybe_unused]] double* gradient) const {
    const double f_0 = 2.0 * omega1 * delta23 * eta21 * over_38 / (3.0 * omega2);
    const double f_1 = 4.0 * delta23 * eta21 * over_38 / 3.0;
    const double f_2 = -alpha23 * eta21 * over_38 / (3.0 * omega2_2);
    const double f_3 = 2.0 * omega1 * omega2 * delta22 * eta11 * over_41;
    const double f_4 = alpha22 * eta11 * over_41;
    const double q_0 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_0;
    const double q_2 = (f_3 + f_4) * per_2;
    const double q_3 = (f_3 + f_4) * per_3;
    const double q_7 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_7;
    gradient[0] = (f_0 + f_3) / omega1 - q_0 - q_2 - q_3 - q_7;  // by omega1
    gradient[1] = (-f_0 - 2.0 * f_2 + f_3) / omega2 - q_0 - 2.0 * q_2 + 2.0 * q_3 - 3.0 * q_7;  // by omega2
    const double c_0 = over_41;  // multiplies alpha22*eta11
    const double c_1 = -over_38 / (3.0 * omega2_2);  // multiplies alpha23*eta21
    const double c_2 = 2.0 * omega1 * omega2 * over_41;  // multiplies delta22*eta11
    const double c_3 = (2.0 * omega1 + 4.0 * omega2) * over_38 / (3.0 * omega2);  // multiplies delta23*eta21
    gradient[6] = eta11 * c_0;  // by alpha22
    gradient[7] = eta21 * c_1;  // by alpha23
    gradient[9] = eta11 * c_2;  // by delta22
    gradient[10] = eta21 * c_3;  // by delta23
    gradient[20] = alpha22 * c_0 + delta22 * c_2;  // by eta11
    gradient[29] = alpha23 * c_1 + delta23 * c_3;  // by eta21
  }
  void lump_conservative_v1_A_v1_F2_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = -eta12_2 * over_48 / (4.0 * omega1);
    const double q_1 = f_0 * per_1;
    const double q_9 = f_0 * per_9;
    gradient[0] = -f_0 / omega1 - q_1 - 3.0 * q_9;  // by omega1
    gradient[1] = q_1 - q_9;  // by omega2
    const double c_0 = -over_48 / (4.0 * omega1);  // multiplies eta12^2
    gradient[21] = 2.0 * eta12 * c_0;  // by eta12
  }
  void lump_dissipative_v1_conjA_v2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = mu12 * eta22 * over_0 / 4.0;
    const double f_1 = omega2 * mu12 * eta12 * over_0 / (4.0 * omega1);
    const double q_0 = (f_0 + f_1) * per_0;
    const double q_1 = (f_0 + f_1) * per_1;
    gradient[0] = -f_1 / omega1 - q_0 - q_1;  // by omega1
    gradient[1] = f_1 / omega2 - q_0 + q_1;  // by omega2
    const double c_0 = omega2 * over_0 / (4.0 * omega1);  // multiplies mu12*eta12
    const double c_1 = over_0 / 4.0;  // multiplies mu12*eta22
    gradient[3] = eta12 * c_0 + eta22 * c_1;  // by mu12
    gradient[21] = mu12 * c_0;  // by eta12
    gradient[30] = mu12 * c_1;  // by eta22
  }
  void lump_conservative_v1_conjA_v2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = omega2 * delta23 * eta21 * per_2 / (2.0 * omega1);
    const double f_1 = omega2_2 * delta23 * eta21 * per_2 / (2.0 * omega1_2);
    const double f_2 = -alpha23 * eta21 * per_2 / (2.0 * omega1_2);
    const double f_3 = omega1 * delta22 * eta11 * per_4 / (2.0 * omega2);
    const double f_4 = delta22 * eta11 * per_4 / 2.0;
    const double f_5 = -alpha22 * eta11 * per_4 / (2.0 * omega1 * omega2);
    const double q_2 = (f_0 + f_1 + f_2) * per_2;
    const double q_4 = (f_3 + f_4 + f_5) * per_4;
    gradient[0] = (-f_0 - 2.0 * f_1 - 2.0 * f_2 + f_3 - f_5) / omega1 - q_2 - 2.0 * q_4;  // by omega1
    gradient[1] = (f_0 + 2.0 * f_1 - f_3 - f_5) / omega2 - 2.0 * q_2 - q_4;  // by omega2
    const double c_0 = -per_4 / (2.0 * omega1 * omega2);  // multiplies alpha22*eta11
    const double c_1 = -per_2 / (2.0 * omega1_2);  // multiplies alpha23*eta21
    const double c_2 = (omega1 + omega2) * per_4 / (2.0 * omega2);  // multiplies delta22*eta11
    const double c_3 = (omega1 * omega2 + omega2_2) * per_2 / (2.0 * omega1_2);  // multiplies delta23*eta21
    gradient[6] = eta11 * c_0;  // by alpha22
    gradient[7] = eta21 * c_1;  // by alpha23
    gradient[9] = eta11 * c_2;  // by delta22
    gradient[10] = eta21 * c_3;  // by delta23
    gradient[20] = alpha22 * c_0 + delta22 * c_2;  // by eta11
    gradient[29] = alpha23 * c_1 + delta23 * c_3;  // by eta21
  }
  void lump_conservative_v2_A_v2_F2_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = eta22_2 * over_49 / (4.0 * omega2);
    const double q_1 = f_0 * per_1;
    const double q_7 = f_0 * per_7;
    gradient[0] = -q_1 - q_7;  // by omega1
    gradient[1] = -f_0 / omega2 + q_1 - 3.0 * q_7;  // by omega2
    const double c_0 = over_49 / (4.0 * omega2);  // multiplies eta22^2
    gradient[30] = 2.0 * eta22 * c_0;  // by eta22
  }
  void lump_dissipative_v2_conjA_v1_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -omega1 * mu21 * eta22 * over_0 / (4.0 * omega2);
    const double f_1 = -eta12 * mu21 * over_0 / 4.0;
    const double q_0 = (f_0 + f_1) * per_0;
    const double q_1 = (f_0 + f_1) * per_1;
    gradient[0] = f_0 / omega1 - q_0 - q_1;  // by omega1
    gradient[1] = -f_0 / omega2 - q_0 + q_1;  // by omega2
    const double c_0 = -over_0 / 4.0;  // multiplies eta12*mu21
    const double c_1 = -omega1 * over_0 / (4.0 * omega2);  // multiplies mu21*eta22
    gradient[21] = mu21 * c_0;  // by eta12
    gradient[23] = eta12 * c_0 + eta22 * c_1;  // by mu21
    gradient[30] = mu21 * c_1;  // by eta22
  }
  void lump_harmonic_re_v1_conjA_v1_F_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = omega2 * delta22 * eta21 * over_6;
    const double f_1 = alpha22 * eta21 * over_6 / omega1;
    const double f_2 = -omega1_2 * delta21 * eta11 * over_11 / omega2;
    const double f_3 = -omega1 * delta21 * eta11 * over_11;
    const double f_4 = -omega2 * delta21 * eta11 * over_11;
    const double f_5 = alpha21 * eta11 * over_11 / omega2;
    const double q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_0;
    const double q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_1;
    const double q_2 = (f_0 + f_1) * per_2;
    const double q_4 = (f_2 + f_3 + f_4 + f_5) * per_4;
    gradient[0] = (-f_1 + 2.0 * f_2 + f_3) / omega1 - q_0 - q_1 - q_2 - 2.0 * q_4;  // by omega1
    gradient[1] = (f_0 - f_2 + f_4 - f_5) / omega2 - q_0 + q_1 - 2.0 * q_2 - q_4;  // by omega2
    const double c_0 = over_11 / omega2;  // multiplies alpha21*eta11
    const double c_1 = over_6 / omega1;  // multiplies alpha22*eta21
    const double c_2 = (-omega1_2 - omega1 * omega2 - omega2_2) * over_11 / omega2;  // multiplies delta21*eta11
    const double c_3 = omega2 * over_6;  // multiplies delta22*eta21
    gradient[5] = eta11 * c_0;  // by alpha21
    gradient[6] = eta21 * c_1;  // by alpha22
    gradient[8] = eta11 * c_2;  // by delta21
    gradient[9] = eta21 * c_3;  // by delta22
    gradient[20] = alpha21 * c_0 + delta21 * c_2;  // by eta11
    gradient[29] = alpha22 * c_1 + delta22 * c_3;  // by eta21
  }
  void lump_harmonic_re_v1_conjA_v12_F_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = omega1_2 * delta21 * eta12 * over_4 / (2.0 * omega2);
    const double f_1 = -omega1 * delta21 * eta12 * over_4;
    const double f_2 = 3.0 * omega2 * delta21 * eta12 * over_4 / 2.0;
    const double f_3 = -5.0 * alpha21 * eta12 * over_4 / (6.0 * omega2);
    const double f_4 = -omega2 * alpha21 * eta12 * over_4 / (6.0 * omega1_2);
    const double q_0 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_0;
    const double q_1 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_1;
    const double q_5 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_5;
    gradient[0] = (2.0 * f_0 + f_1 - 2.0 * f_4) / omega1 - q_0 - q_1 - 2.0 * q_5;  // by omega1
    gradient[1] = (-f_0 + f_2 - f_3 + f_4) / omega2 - q_0 + q_1 + q_5;  // by omega2
    const double c_0 = (-5.0 * omega1_2 - omega2_2) * over_4 / (6.0 * omega1_2 * omega2);
    const double c_1 = (omega1_2 - 2.0 * omega1 * omega2 + 3.0 * omega2_2) * over_4 / (2.0 * omega2);
    gradient[5] = eta12 * c_0;  // by alpha21
    gradient[8] = eta12 * c_1;  // by delta21
    gradient[21] = alpha21 * c_0 + delta21 * c_1;  // by eta12
  }
  void lump_harmonic_re_v1_A_v22_F_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = -omega1 * delta23 * eta22 * over_4;
    const double f_1 = alpha23 * eta22 * over_4 / omega2;
    const double f_2 = -omega2 * delta23 * eta12 * over_50 / 2.0;
    const double f_3 = -alpha23 * eta12 * over_50 / (2.0 * omega2);
    const double q_0 = (f_0 + f_1) * per_0;
    const double q_1 = (f_0 + f_1) * per_1;
    const double q_2 = (f_2 + f_3) * per_2;
    const double q_3 = (f_2 + f_3) * per_3;
    const double q_5 = (f_0 + f_1 + f_2 + f_3) * per_5;
    gradient[0] = f_0 / omega1 - q_0 - q_1 - q_2 - q_3 - 2.0 * q_5;  // by omega1
    gradient[1] = (-f_1 + f_2 - f_3) / omega2 - q_0 + q_1 - 2.0 * q_2 + 2.0 * q_3 + q_5;  // by omega2
    const double c_0 = -over_50 / (2.0 * omega2);  // multiplies alpha23*eta12
    const double c_1 = over_4 / omega2;  // multiplies alpha23*eta22
    const double c_2 = -omega2 * over_50 / 2.0;  // multiplies delta23*eta12
    const double c_3 = -omega1 * over_4;  // multiplies delta23*eta22
    gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
    gradient[10] = eta12 * c_2 + eta22 * c_3;  // by delta23
    gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
    gradient[30] = alpha23 * c_1 + delta23 * c_3;  // by eta22
  }
  void lump_harmonic_re_v1_conjA_v1_conjA_v2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -delta22 * eta12 * per_4 / omega2;
    const double f_1 = -delta22 * eta12 * per_4 / omega1;
    const double f_2 = alpha22 * eta12 * per_4 / (omega1_2 * omega2);
    const double f_3 = (-alpha22 * eta12 + alpha22 * eta22) * over_0 / omega1_2;
    const double q_0 = f_3 * per_0;
    const double q_1 = f_3 * per_1;
    const double q_4 = (f_0 + f_1 + f_2) * per_4;
    gradient[0] = (-f_1 - 2.0 * f_2 - 2.0 * f_3) / omega1 - q_0 - q_1 - 2.0 * q_4;  // by omega1
    gradient[1] = (-f_0 - f_2) / omega2 - q_0 + q_1 - q_4;  // by omega2
    const double c_0 = per_4 / (omega1_2 * omega2) - over_0 / omega1_2;  // multiplies alpha22*eta12
    const double c_1 = over_0 / omega1_2;  // multiplies alpha22*eta22
    const double c_2 = (-omega1 - omega2) * per_4 / (omega1 * omega2);  // multiplies delta22*eta12
    gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
    gradient[9] = eta12 * c_2;  // by delta22
    gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
    gradient[30] = alpha22 * c_1;  // by eta22
  }
  void lump_harmonic_re_v1_F2([[maybe_unused]] double* gradient) const {
    const double f_0 = -eta11 * eta12 * per_4 / (2.0 * omega1_2 * omega2);
    const double q_4 = f_0 * per_4;
    gradient[0] = -2.0 * f_0 / omega1 - 2.0 * q_4;  // by omega1
    gradient[1] = -f_0 / omega2 - q_4;  // by omega2
    const double c_0 = -per_4 / (2.0 * omega1_2 * omega2);  // multiplies eta11*eta12
    gradient[20] = eta12 * c_0;  // by eta11
    gradient[21] = eta11 * c_0;  // by eta12
  }
  void lump_harmonic_im_v1_F_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = -mu12 * eta21 * over_12 / (2.0 * omega2);
    const double f_1 = -mu12 * eta21 * over_12 / (2.0 * omega1);
    const double q_2 = (f_0 + f_1) * per_2;
    const double q_4 = (f_0 + f_1) * per_4;
    gradient[0] = -f_1 / omega1 - q_2 - 2.0 * q_4;  // by omega1
    gradient[1] = -f_0 / omega2 - 2.0 * q_2 - q_4;  // by omega2
    const double c_0 = (-omega1 - omega2) * over_12 / (2.0 * omega1 * omega2);  // multiplies mu12*eta21
    gradient[3] = eta21 * c_0;  // by mu12
    gradient[29] = mu12 * c_0;  // by eta21
  }
  void lump_harmonic_re_v1_A_v2_conjA_v2_F_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = -omega2 * delta23 * eta12 * per_4 / omega1_2;
    const double f_1 = alpha23 * eta12 * per_4 / (omega1_2 * omega2);
    const double f_2 = -2.0 * omega2 * delta23 * eta22 * over_51;
    const double f_3 = -2.0 * alpha23 * eta22 * over_51 / omega2;
    const double q_1 = (f_2 + f_3) * per_1;
    const double q_4 = (f_0 + f_1 + f_2 + f_3) * per_4;
    const double q_7 = (f_2 + f_3) * per_7;
    gradient[0] = (-2.0 * f_0 - 2.0 * f_1) / omega1 - q_1 - 2.0 * q_4 - q_7;  // by omega1
    gradient[1] = (f_0 - f_1 + f_2 - f_3) / omega2 + q_1 - q_4 - 3.0 * q_7;  // by omega2
    const double c_0 = per_4 / (omega1_2 * omega2);  // multiplies alpha23*eta12
    const double c_1 = -2.0 * over_51 / omega2;  // multiplies alpha23*eta22
    const double c_2 = -omega2 * per_4 / omega1_2;  // multiplies delta23*eta12
    const double c_3 = -2.0 * omega2 * over_51;  // multiplies delta23*eta22
    gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
    gradient[10] = eta12 * c_2 + eta22 * c_3;  // by delta23
    gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
    gradient[30] = alpha23 * c_1 + delta23 * c_3;  // by eta22
  }
  void lump_harmonic_re_v1_A_v1_conjA_v1_F_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = -3.0 * omega1_2 * delta21 * eta12 * over_52 / omega2;
    const double f_1 = -2.0 * omega1 * delta21 * eta12 * over_52;
    const double f_2 = -omega2 * delta21 * eta12 * over_52;
    const double f_3 = 5.0 * alpha21 * eta12 * over_52 / omega2;
    const double f_4 = -2.0 * alpha21 * eta12 * over_52 / omega1;
    const double f_5 = -omega2 * alpha21 * eta12 * over_52 / omega1_2;
    const double q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_1;
    const double q_4 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_4;
    const double q_9 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_9;
    gradient[0] = (2.0 * f_0 + f_1 - f_4 - 2.0 * f_5) / omega1 - q_1 - 2.0 * q_4 - 3.0 * q_9;  // by omega1
    gradient[1] = (-f_0 + f_2 - f_3 + f_5) / omega2 + q_1 - q_4 - q_9;  // by omega2
    const double c_0 = (5.0 * omega1_2 - 2.0 * omega1 * omega2 - omega2_2) * over_52 / (omega1_2 * omega2);
    const double c_1 = (-3.0 * omega1_2 - 2.0 * omega1 * omega2 - omega2_2) * over_52 / omega2;
    gradient[5] = eta12 * c_0;  // by alpha21
    gradient[8] = eta12 * c_1;  // by delta21
    gradient[21] = alpha21 * c_0 + delta21 * c_1;  // by eta12
  }
  void lump_harmonic_re_v1_A_v2_conjA_v1_F_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = 2.0 * omega1 * omega2 * delta22 * eta22 * over_41;
    const double f_1 = alpha22 * eta22 * over_41;
    const double f_2 = omega1_4 * delta22 * eta12 * over_53 / omega2;
    const double f_3 = -omega1_3 * delta22 * eta12 * over_53;
    const double f_4 = -omega1_2 * omega2 * delta22 * eta12 * over_53;
    const double f_5 = -omega1_2 * alpha22 * eta12 * over_53 / omega2;
    const double f_6 = 5.0 * omega1 * omega2_2 * delta22 * eta12 * over_53;
    const double f_7 = -2.0 * omega1 * alpha22 * eta12 * over_53;
    const double f_8 = -2.0 * omega2_3 * delta22 * eta12 * over_53;
    const double f_9 = 2.0 * omega2 * alpha22 * eta12 * over_53;
    const double q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_0;
    const double q_1 = (f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_1;
    const double q_2 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_2;
    const double q_3 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_3;
    const double q_5 = (f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_5;
    const double q_7 = (f_0 + f_1) * per_7;
    gradient[0] = (f_0 + 4.0 * f_2 + 3.0 * f_3 + 2.0 * f_4 + 2.0 * f_5 + f_6 + f_7) / omega1 - q_0 - q_1 - q_2 - q_3
        - 2.0 * q_5 - q_7;
    gradient[1] = (f_0 - f_2 + f_4 - f_5 + 2.0 * f_6 + 3.0 * f_8 + f_9) / omega2 - q_0 + q_1 - 2.0 * q_2 + 2.0 * q_3
        + q_5 - 3.0 * q_7;
    const double c_0 = (-omega1_2 - 2.0 * omega1 * omega2 + 2.0 * omega2_2) * over_53 / omega2;
    const double c_1 = over_41;  // multiplies alpha22*eta22
    const double c_2 = (omega1_4 - omega1_3 * omega2 - omega1_2 * omega2_2 + 5.0 * omega1 * omega2_3
        - 2.0 * omega2_4) * over_53 / omega2;
    const double c_3 = 2.0 * omega1 * omega2 * over_41;  // multiplies delta22*eta22
    gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
    gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
    gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
    gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  }
  void lump_harmonic_re_v1_A_v1_F_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = 2.0 * omega1 * delta22 * eta21 * over_54;
    const double f_1 = omega2 * delta22 * eta21 * over_54;
    const double f_2 = -alpha22 * eta21 * over_54 / omega1;
    const double f_3 = 3.0 * omega1_2 * delta21 * eta11 * over_28 / omega2;
    const double f_4 = 3.0 * omega1 * delta21 * eta11 * over_28;
    const double f_5 = omega2 * delta21 * eta11 * over_28;
    const double f_6 = -alpha21 * eta11 * over_28 / omega2;
    const double q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_0;
    const double q_2 = (f_0 + f_1 + f_2) * per_2;
    const double q_4 = (f_3 + f_4 + f_5 + f_6) * per_4;
    const double q_9 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_9;
    gradient[0] = (f_0 - f_2 + 2.0 * f_3 + f_4) / omega1 - q_0 - q_2 - 2.0 * q_4 - 3.0 * q_9;  // by omega1
    gradient[1] = (f_1 - f_3 + f_5 - f_6) / omega2 - q_0 - 2.0 * q_2 - q_4 - q_9;  // by omega2
    const double c_0 = -over_28 / omega2;  // multiplies alpha21*eta11
    const double c_1 = -over_54 / omega1;  // multiplies alpha22*eta21
    const double c_2 = (3.0 * omega1_2 + 3.0 * omega1 * omega2 + omega2_2) * over_28 / omega2;
    const double c_3 = (2.0 * omega1 + omega2) * over_54;  // multiplies delta22*eta21
    gradient[5] = eta11 * c_0;  // by alpha21
    gradient[6] = eta21 * c_1;  // by alpha22
    gradient[8] = eta11 * c_2;  // by delta21
    gradient[9] = eta21 * c_3;  // by delta22
    gradient[20] = alpha21 * c_0 + delta21 * c_2;  // by eta11
    gradient[29] = alpha22 * c_1 + delta22 * c_3;  // by eta21
  }
  void lump_harmonic_re_v1_A_v1_conjA_v2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = alpha22 * eta12 * per_5 / (3.0 * omega1_2 * omega2);
    const double f_1 = 2.0 * delta22 * eta22 * over_0 / 3.0;
    const double f_2 = -alpha22 * eta22 * over_0 / (3.0 * omega1_2);
    const double f_3 = -alpha22 * eta12 * over_26 / (3.0 * omega1_2);
    const double f_4 = -omega1_2 * delta22 * eta12 * over_55 / omega2;
    const double f_5 = 7.0 * omega1 * delta22 * eta12 * over_55 / 3.0;
    const double f_6 = omega2 * delta22 * eta12 * over_55;
    const double f_7 = -omega2_2 * delta22 * eta12 * over_55 / (3.0 * omega1);
    const double q_0 = (f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7) * per_0;
    const double q_1 = (f_1 + f_2) * per_1;
    const double q_5 = (f_0 + f_4 + f_5 + f_6 + f_7) * per_5;
    const double q_9 = (f_3 + f_4 + f_5 + f_6 + f_7) * per_9;
    gradient[0] = (-2.0 * f_0 - 2.0 * f_2 - 2.0 * f_3 + 2.0 * f_4 + f_5 - f_7) / omega1 - q_0 - q_1 - 2.0 * q_5
        - 3.0 * q_9;
    gradient[1] = (-f_0 - f_4 + f_6 + 2.0 * f_7) / omega2 - q_0 + q_1 + q_5 - q_9;  // by omega2
    const double c_0 = per_5 / (3.0 * omega1_2 * omega2) - over_26 / (3.0 * omega1_2);  // multiplies alpha22*eta12
    const double c_1 = -over_0 / (3.0 * omega1_2);  // multiplies alpha22*eta22
    const double c_2 = (-3.0 * omega1_3 + 7.0 * omega1_2 * omega2 + 3.0 * omega1 * omega2_2
        - omega2_3) * over_55 / (3.0 * omega1 * omega2);
    const double c_3 = 2.0 * over_0 / 3.0;  // multiplies delta22*eta22
    gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
    gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
    gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
    gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  }
  void lump_harmonic_re_v1_A_v2_F_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = -delta23 * eta21 * per_2 / (4.0 * omega1);
    const double f_1 = omega1 * delta22 * eta11 * per_4 / (4.0 * omega2_2);
    const double f_2 = delta22 * eta11 * per_4 / (2.0 * omega2);
    const double f_3 = -alpha23 * eta21 * over_21 / (4.0 * omega1 * omega2);
    const double f_4 = -alpha22 * eta11 * over_22 / (4.0 * omega2_2);
    const double q_0 = (f_3 + f_4) * per_0;
    const double q_2 = (f_0 + f_3) * per_2;
    const double q_4 = (f_1 + f_2 + f_4) * per_4;
    gradient[0] = (-f_0 + f_1 - f_3) / omega1 - q_0 - q_2 - 2.0 * q_4;  // by omega1
    gradient[1] = (-2.0 * f_1 - f_2 - f_3 - 2.0 * f_4) / omega2 - q_0 - 2.0 * q_2 - q_4;  // by omega2
    const double c_0 = -over_22 / (4.0 * omega2_2);  // multiplies alpha22*eta11
    const double c_1 = -over_21 / (4.0 * omega1 * omega2);  // multiplies alpha23*eta21
    const double c_2 = (omega1 + 2.0 * omega2) * per_4 / (4.0 * omega2_2);  // multiplies delta22*eta11
    const double c_3 = -per_2 / (4.0 * omega1);  // multiplies delta23*eta21
    gradient[6] = eta11 * c_0;  // by alpha22
    gradient[7] = eta21 * c_1;  // by alpha23
    gradient[9] = eta11 * c_2;  // by delta22
    gradient[10] = eta21 * c_3;  // by delta23
    gradient[20] = alpha22 * c_0 + delta22 * c_2;  // by eta11
    gradient[29] = alpha23 * c_1 + delta23 * c_3;  // by eta21
  }
  void lump_harmonic_im_v1_A_v2_F_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = -omega1 * mu12 * eta22 * over_56 / (8.0 * omega2);
    const double f_1 = -mu12 * eta22 * over_56 / 4.0;
    const double f_2 = mu12 * eta12 * over_57 / 8.0;
    const double q_0 = (2.0 * f_0 + 2.0 * f_1 + 2.0 * f_2) * per_0;
    const double q_1 = f_2 * per_1;
    const double q_7 = (f_0 + f_1) * per_7;
    gradient[0] = f_0 / omega1 - q_0 - q_1 - q_7;  // by omega1
    gradient[1] = -f_0 / omega2 - q_0 + q_1 - 3.0 * q_7;  // by omega2
    const double c_0 = over_57 / 8.0;  // multiplies mu12*eta12
    const double c_1 = (-omega1 - 2.0 * omega2) * over_56 / (8.0 * omega2);  // multiplies mu12*eta22
    gradient[3] = eta12 * c_0 + eta22 * c_1;  // by mu12
    gradient[21] = mu12 * c_0;  // by eta12
    gradient[30] = mu12 * c_1;  // by eta22
  }
  void lump_harmonic_re_v1_A_v1_A_v2_F_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = 2.0 * omega1 * delta22 * eta22 * over_58;
    const double f_1 = -alpha22 * eta22 * over_59;
    const double f_2 = 3.0 * omega1_3 * delta22 * eta12 * over_60 / omega2;
    const double f_3 = 12.0 * omega1_2 * delta22 * eta12 * over_60;
    const double f_4 = 9.0 * omega1 * omega2 * delta22 * eta12 * over_60;
    const double f_5 = 2.0 * omega2_2 * delta22 * eta12 * over_60;
    const double f_6 = -3.0 * omega1_2 * alpha22 * eta12 * over_61 / omega2;
    const double f_7 = -6.0 * omega1 * alpha22 * eta12 * over_61;
    const double f_8 = -2.0 * omega2 * alpha22 * eta12 * over_61;
    const double q_0 = (f_1 + f_6 + f_7 + f_8) * per_0;
    const double q_2 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_2;
    const double q_4 = (f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_4;
    const double q_7 = (f_0 + f_1) * per_7;
    const double q_9 = (f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_9;
    const double q_10 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_10;
    gradient[0] = (f_0 + 3.0 * f_2 + 2.0 * f_3 + f_4 + 2.0 * f_6 + f_7) / omega1 - q_0 - q_2 - 2.0 * q_4 - q_7
        - 3.0 * q_9 - 3.0 * q_10;
    gradient[1] = (-f_2 + f_4 + 2.0 * f_5 - f_6 + f_8) / omega2 - q_0 - 2.0 * q_2 - q_4 - 3.0 * q_7 - q_9
        - 2.0 * q_10;
    const double c_0 = (-3.0 * omega1_2 - 6.0 * omega1 * omega2 - 2.0 * omega2_2) * over_61 / omega2;
    const double c_1 = -over_59;  // multiplies alpha22*eta22
    const double c_2 = (3.0 * omega1_3 + 12.0 * omega1_2 * omega2 + 9.0 * omega1 * omega2_2
        + 2.0 * omega2_3) * over_60 / omega2;
    const double c_3 = 2.0 * omega1 * over_58;  // multiplies delta22*eta22
    gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
    gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
    gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
    gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  }
  void lump_harmonic_re_v1_A_v12_F_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = 17.0 * omega1_2 * delta21 * eta12 * over_62 / 2.0;
    const double f_1 = 7.0 * omega1 * omega2 * delta21 * eta12 * over_62;
    const double f_2 = 3.0 * omega2_2 * delta21 * eta12 * over_62 / 2.0;
    const double f_3 = -3.0 * alpha21 * eta12 * over_62 / 2.0;
    const double f_4 = -2.0 * omega2 * alpha21 * eta12 * over_62 / (3.0 * omega1);
    const double f_5 = -omega2_2 * alpha21 * eta12 * over_62 / (6.0 * omega1_2);
    const double q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_0;
    const double q_4 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_4;
    const double q_9 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_9;
    const double q_11 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_11;
    gradient[0] = (2.0 * f_0 + f_1 - f_4 - 2.0 * f_5) / omega1 - q_0 - 2.0 * q_4 - 3.0 * q_9 - 4.0 * q_11;
    gradient[1] = (f_1 + 2.0 * f_2 + f_4 + 2.0 * f_5) / omega2 - q_0 - q_4 - q_9 - q_11;  // by omega2
    const double c_0 = (-9.0 * omega1_2 - 4.0 * omega1 * omega2 - omega2_2) * over_62 / (6.0 * omega1_2);
    const double c_1 = (17.0 * omega1_2 + 14.0 * omega1 * omega2 + 3.0 * omega2_2) * over_62 / 2.0;
    gradient[5] = eta12 * c_0;  // by alpha21
    gradient[8] = eta12 * c_1;  // by delta21
    gradient[21] = alpha21 * c_0 + delta21 * c_1;  // by eta12
  }
  void lump_harmonic_re_v2_conjA_v12_F_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = -omega2 * delta22 * eta12 * over_10;
    const double f_1 = alpha22 * eta12 * over_10 / omega1;
    const double f_2 = -omega1 * delta22 * eta22 * over_63 / 2.0;
    const double f_3 = -alpha22 * eta22 * over_63 / (2.0 * omega1);
    const double q_0 = (f_0 + f_1) * per_0;
    const double q_1 = (f_0 + f_1) * per_1;
    const double q_3 = (f_0 + f_1 + f_2 + f_3) * per_3;
    const double q_4 = (f_2 + f_3) * per_4;
    const double q_5 = (f_2 + f_3) * per_5;
    gradient[0] = (-f_1 + f_2 - f_3) / omega1 - q_0 - q_1 - q_3 - 2.0 * q_4 - 2.0 * q_5;  // by omega1
    gradient[1] = f_0 / omega2 - q_0 + q_1 + 2.0 * q_3 - q_4 + q_5;  // by omega2
    const double c_0 = over_10 / omega1;  // multiplies alpha22*eta12
    const double c_1 = -over_63 / (2.0 * omega1);  // multiplies alpha22*eta22
    const double c_2 = -omega2 * over_10;  // multiplies delta22*eta12
    const double c_3 = -omega1 * over_63 / 2.0;  // multiplies delta22*eta22
    gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
    gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
    gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
    gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  }
  void lump_harmonic_re_v2_A_v22_F_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = 3.0 * omega1 * delta24 * eta22 * over_10 / 2.0;
    const double f_1 = -omega1 * alpha24 * eta22 * over_10 / (6.0 * omega2_2);
    const double f_2 = -omega2 * delta24 * eta22 * over_10;
    const double f_3 = omega2_2 * delta24 * eta22 * over_10 / (2.0 * omega1);
    const double f_4 = -5.0 * alpha24 * eta22 * over_10 / (6.0 * omega1);
    const double q_0 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_0;
    const double q_1 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_1;
    const double q_3 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_3;
    gradient[0] = (f_0 + f_1 - f_3 - f_4) / omega1 - q_0 - q_1 - q_3;  // by omega1
    gradient[1] = (-2.0 * f_1 + f_2 + 2.0 * f_3) / omega2 - q_0 + q_1 + 2.0 * q_3;  // by omega2
    const double c_0 = (-omega1_2 - 5.0 * omega2_2) * over_10 / (6.0 * omega1 * omega2_2);
    const double c_1 = (3.0 * omega1_2 - 2.0 * omega1 * omega2 + omega2_2) * over_10 / (2.0 * omega1);
    gradient[25] = eta22 * c_0;  // by alpha24
    gradient[26] = eta22 * c_1;  // by delta24
    gradient[30] = alpha24 * c_0 + delta24 * c_1;  // by eta22
  }
  void lump_harmonic_re_v2_conjA_v2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = omega1 * delta24 * eta21 * over_6;
    const double f_1 = omega2 * delta24 * eta21 * over_6;
    const double f_2 = omega2_2 * delta24 * eta21 * over_6 / omega1;
    const double f_3 = -alpha24 * eta21 * over_6 / omega1;
    const double f_4 = -omega1 * delta23 * eta11 * over_11;
    const double f_5 = -alpha23 * eta11 * over_11 / omega2;
    const double q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_0;
    const double q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_1;
    const double q_2 = (f_0 + f_1 + f_2 + f_3) * per_2;
    const double q_4 = (f_4 + f_5) * per_4;
    gradient[0] = (f_0 - f_2 - f_3 + f_4) / omega1 - q_0 - q_1 - q_2 - 2.0 * q_4;  // by omega1
    gradient[1] = (f_1 + 2.0 * f_2 - f_5) / omega2 - q_0 + q_1 - 2.0 * q_2 - q_4;  // by omega2
    const double c_0 = -over_11 / omega2;  // multiplies alpha23*eta11
    const double c_1 = -omega1 * over_11;  // multiplies delta23*eta11
    const double c_2 = -over_6 / omega1;  // multiplies alpha24*eta21
    const double c_3 = (omega1_2 + omega1 * omega2 + omega2_2) * over_6 / omega1;  // multiplies delta24*eta21
    gradient[7] = eta11 * c_0;  // by alpha23
    gradient[10] = eta11 * c_1;  // by delta23
    gradient[20] = alpha23 * c_0 + delta23 * c_1;  // by eta11
    gradient[25] = eta21 * c_2;  // by alpha24
    gradient[26] = eta21 * c_3;  // by delta24
    gradient[29] = alpha24 * c_2 + delta24 * c_3;  // by eta21
  }
  void lump_harmonic_re_v2_conjA_v1_conjA_v2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -delta23 * eta22 * per_2 / omega2;
    const double f_1 = -delta23 * eta22 * per_2 / omega1;
    const double f_2 = alpha23 * eta22 * per_2 / (omega1 * omega2_2);
    const double f_3 = (-alpha23 * eta12 + alpha23 * eta22) * over_0 / omega2_2;
    const double q_0 = f_3 * per_0;
    const double q_1 = f_3 * per_1;
    const double q_2 = (f_0 + f_1 + f_2) * per_2;
    gradient[0] = (-f_1 - f_2) / omega1 - q_0 - q_1 - q_2;  // by omega1
    gradient[1] = (-f_0 - 2.0 * f_2 - 2.0 * f_3) / omega2 - q_0 + q_1 - 2.0 * q_2;  // by omega2
    const double c_0 = -over_0 / omega2_2;  // multiplies alpha23*eta12
    const double c_1 = per_2 / (omega1 * omega2_2) + over_0 / omega2_2;  // multiplies alpha23*eta22
    const double c_2 = (-omega1 - omega2) * per_2 / (omega1 * omega2);  // multiplies delta23*eta22
    gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
    gradient[10] = eta22 * c_2;  // by delta23
    gradient[21] = alpha23 * c_0;  // by eta12
    gradient[30] = alpha23 * c_1 + delta23 * c_2;  // by eta22
  }
  void lump_harmonic_re_v2_F2([[maybe_unused]] double* gradient) const {
    const double f_0 = -eta21 * eta22 * per_2 / (2.0 * omega1 * omega2_2);
    const double q_2 = f_0 * per_2;
    gradient[0] = -f_0 / omega1 - q_2;  // by omega1
    gradient[1] = -2.0 * f_0 / omega2 - 2.0 * q_2;  // by omega2
    const double c_0 = -per_2 / (2.0 * omega1 * omega2_2);  // multiplies eta21*eta22
    gradient[29] = eta22 * c_0;  // by eta21
    gradient[30] = eta21 * c_0;  // by eta22
  }
  void lump_harmonic_im_v2_F_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = -eta11 * mu21 * over_12 / (2.0 * omega2);
    const double f_1 = -eta11 * mu21 * over_12 / (2.0 * omega1);
    const double q_2 = (f_0 + f_1) * per_2;
    const double q_4 = (f_0 + f_1) * per_4;
    gradient[0] = -f_1 / omega1 - q_2 - 2.0 * q_4;  // by omega1
    gradient[1] = -f_0 / omega2 - 2.0 * q_2 - q_4;  // by omega2
    const double c_0 = (-omega1 - omega2) * over_12 / (2.0 * omega1 * omega2);  // multiplies eta11*mu21
    gradient[20] = mu21 * c_0;  // by eta11
    gradient[23] = eta11 * c_0;  // by mu21
  }
  void lump_harmonic_re_v2_A_v2_conjA_v2_F_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = omega1 * delta24 * eta22 * over_64;
    const double f_1 = omega1 * alpha24 * eta22 * over_64 / omega2_2;
    const double f_2 = 2.0 * omega2 * delta24 * eta22 * over_64;
    const double f_3 = 2.0 * alpha24 * eta22 * over_64 / omega2;
    const double f_4 = 3.0 * omega2_2 * delta24 * eta22 * over_64 / omega1;
    const double f_5 = -5.0 * alpha24 * eta22 * over_64 / omega1;
    const double q_1 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_1;
    const double q_2 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_2;
    const double q_7 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_7;
    gradient[0] = (f_0 + f_1 - f_4 - f_5) / omega1 - q_1 - q_2 - q_7;  // by omega1
    gradient[1] = (-2.0 * f_1 + f_2 - f_3 + 2.0 * f_4) / omega2 + q_1 - 2.0 * q_2 - 3.0 * q_7;  // by omega2
    const double c_0 = (omega1_2 + 2.0 * omega1 * omega2 - 5.0 * omega2_2) * over_64 / (omega1 * omega2_2);
    const double c_1 = (omega1_2 + 2.0 * omega1 * omega2 + 3.0 * omega2_2) * over_64 / omega1;
    gradient[25] = eta22 * c_0;  // by alpha24
    gradient[26] = eta22 * c_1;  // by delta24
    gradient[30] = alpha24 * c_0 + delta24 * c_1;  // by eta22
  }
  void lump_harmonic_re_v2_A_v1_conjA_v1_F_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = -omega1 * delta22 * eta22 * per_2 / omega2_2;
    const double f_1 = alpha22 * eta22 * per_2 / (omega1 * omega2_2);
    const double f_2 = 2.0 * omega1 * delta22 * eta12 * over_65;
    const double f_3 = 2.0 * alpha22 * eta12 * over_65 / omega1;
    const double q_1 = (f_2 + f_3) * per_1;
    const double q_2 = (f_0 + f_1 + f_2 + f_3) * per_2;
    const double q_9 = (f_2 + f_3) * per_9;
    gradient[0] = (f_0 - f_1 + f_2 - f_3) / omega1 - q_1 - q_2 - 3.0 * q_9;  // by omega1
    gradient[1] = (-2.0 * f_0 - 2.0 * f_1) / omega2 + q_1 - 2.0 * q_2 - q_9;  // by omega2
    const double c_0 = 2.0 * over_65 / omega1;  // multiplies alpha22*eta12
    const double c_1 = per_2 / (omega1 * omega2_2);  // multiplies alpha22*eta22
    const double c_2 = 2.0 * omega1 * over_65;  // multiplies delta22*eta12
    const double c_3 = -omega1 * per_2 / omega2_2;  // multiplies delta22*eta22
    gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
    gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
    gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
    gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  }
  void lump_harmonic_re_v2_A_v2_F_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = omega1 * delta24 * eta21 * over_40;
    const double f_1 = 3.0 * omega2 * delta24 * eta21 * over_40;
    const double f_2 = 3.0 * omega2_2 * delta24 * eta21 * over_40 / omega1;
    const double f_3 = -alpha24 * eta21 * over_40 / omega1;
    const double f_4 = omega1 * delta23 * eta11 * over_66;
    const double f_5 = 2.0 * omega2 * delta23 * eta11 * over_66;
    const double f_6 = -alpha23 * eta11 * over_66 / omega2;
    const double q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_0;
    const double q_2 = (f_0 + f_1 + f_2 + f_3) * per_2;
    const double q_4 = (f_4 + f_5 + f_6) * per_4;
    const double q_7 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_7;
    gradient[0] = (f_0 - f_2 - f_3 + f_4) / omega1 - q_0 - q_2 - 2.0 * q_4 - q_7;  // by omega1
    gradient[1] = (f_1 + 2.0 * f_2 + f_5 - f_6) / omega2 - q_0 - 2.0 * q_2 - q_4 - 3.0 * q_7;  // by omega2
    const double c_0 = -over_66 / omega2;  // multiplies alpha23*eta11
    const double c_1 = (omega1 + 2.0 * omega2) * over_66;  // multiplies delta23*eta11
    const double c_2 = -over_40 / omega1;  // multiplies alpha24*eta21
    const double c_3 = (omega1_2 + 3.0 * omega1 * omega2 + 3.0 * omega2_2) * over_40 / omega1;
    gradient[7] = eta11 * c_0;  // by alpha23
    gradient[10] = eta11 * c_1;  // by delta23
    gradient[20] = alpha23 * c_0 + delta23 * c_1;  // by eta11
    gradient[25] = eta21 * c_2;  // by alpha24
    gradient[26] = eta21 * c_3;  // by delta24
    gradient[29] = alpha24 * c_2 + delta24 * c_3;  // by eta21
  }
  void lump_harmonic_re_v2_A_v2_conjA_v1_F_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = -alpha23 * eta22 * per_3 / (3.0 * omega1 * omega2_2);
    const double f_1 = -alpha23 * eta22 * over_38 / (3.0 * omega2_2);
    const double f_2 = -2.0 * delta23 * eta12 * over_0 / 3.0;
    const double f_3 = alpha23 * eta12 * over_0 / (3.0 * omega2_2);
    const double f_4 = omega1_2 * delta23 * eta22 * over_67 / (3.0 * omega2);
    const double f_5 = -omega1 * delta23 * eta22 * over_67;
    const double f_6 = -7.0 * omega2 * delta23 * eta22 * over_67 / 3.0;
    const double f_7 = omega2_2 * delta23 * eta22 * over_67 / omega1;
    const double q_0 = (f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7) * per_0;
    const double q_1 = (f_2 + f_3) * per_1;
    const double q_3 = (f_0 + f_4 + f_5 + f_6 + f_7) * per_3;
    const double q_7 = (f_1 + f_4 + f_5 + f_6 + f_7) * per_7;
    gradient[0] = (-f_0 + 2.0 * f_4 + f_5 - f_7) / omega1 - q_0 - q_1 - q_3 - q_7;  // by omega1
    gradient[1] = (-2.0 * f_0 - 2.0 * f_1 - 2.0 * f_3 - f_4 + f_6 + 2.0 * f_7) / omega2 - q_0 + q_1 + 2.0 * q_3
        - 3.0 * q_7;
    const double c_0 = over_0 / (3.0 * omega2_2);  // multiplies alpha23*eta12
    const double c_1 = -per_3 / (3.0 * omega1 * omega2_2) - over_38 / (3.0 * omega2_2);  // multiplies alpha23*eta22
    const double c_2 = -2.0 * over_0 / 3.0;  // multiplies delta23*eta12
    const double c_3 = (omega1_3 - 3.0 * omega1_2 * omega2 - 7.0 * omega1 * omega2_2
        + 3.0 * omega2_3) * over_67 / (3.0 * omega1 * omega2);
    gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
    gradient[10] = eta12 * c_2 + eta22 * c_3;  // by delta23
    gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
    gradient[30] = alpha23 * c_1 + delta23 * c_3;  // by eta22
  }
  void lump_harmonic_re_v2_A_v1_conjA_v2_F_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = -2.0 * omega1 * omega2 * delta23 * eta12 * over_29;
    const double f_1 = -alpha23 * eta12 * over_29;
    const double f_2 = 2.0 * omega1_3 * delta23 * eta22 * over_68;
    const double f_3 = -5.0 * omega1_2 * omega2 * delta23 * eta22 * over_68;
    const double f_4 = omega1 * omega2_2 * delta23 * eta22 * over_68;
    const double f_5 = -2.0 * omega1 * alpha23 * eta22 * over_68;
    const double f_6 = omega2_3 * delta23 * eta22 * over_68;
    const double f_7 = 2.0 * omega2 * alpha23 * eta22 * over_68;
    const double f_8 = -omega2_4 * delta23 * eta22 * over_68 / omega1;
    const double f_9 = omega2_2 * alpha23 * eta22 * over_68 / omega1;
    const double q_0 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_0;
    const double q_1 = (f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_1;
    const double q_3 = (f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_3;
    const double q_4 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_4;
    const double q_5 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8 + f_9) * per_5;
    const double q_9 = (f_0 + f_1) * per_9;
    gradient[0] = (f_0 + 3.0 * f_2 + 2.0 * f_3 + f_4 + f_5 - f_8 - f_9) / omega1 - q_0 - q_1 - q_3 - 2.0 * q_4
        - 2.0 * q_5 - 3.0 * q_9;
    gradient[1] = (f_0 + f_3 + 2.0 * f_4 + 3.0 * f_6 + f_7 + 4.0 * f_8 + 2.0 * f_9) / omega2 - q_0 + q_1 + 2.0 * q_3
        - q_4 + q_5 - q_9;
    const double c_0 = -over_29;  // multiplies alpha23*eta12
    const double c_1 = (-2.0 * omega1_2 + 2.0 * omega1 * omega2 + omega2_2) * over_68 / omega1;
    const double c_2 = -2.0 * omega1 * omega2 * over_29;  // multiplies delta23*eta12
    const double c_3 = (2.0 * omega1_4 - 5.0 * omega1_3 * omega2 + omega1_2 * omega2_2 + omega1 * omega2_3
        - omega2_4) * over_68 / omega1;
    gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
    gradient[10] = eta12 * c_2 + eta22 * c_3;  // by delta23
    gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
    gradient[30] = alpha23 * c_1 + delta23 * c_3;  // by eta22
  }
  void lump_harmonic_re_v2_A_v1_F_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = delta23 * eta21 * per_2 / (2.0 * omega1);
    const double f_1 = omega2 * delta23 * eta21 * per_2 / (4.0 * omega1_2);
    const double f_2 = -delta22 * eta11 * per_4 / (4.0 * omega2);
    const double f_3 = -alpha23 * eta21 * over_21 / (4.0 * omega1_2);
    const double f_4 = -alpha22 * eta11 * over_22 / (4.0 * omega1 * omega2);
    const double q_0 = (f_3 + f_4) * per_0;
    const double q_2 = (f_0 + f_1 + f_3) * per_2;
    const double q_4 = (f_2 + f_4) * per_4;
    gradient[0] = (-f_0 - 2.0 * f_1 - 2.0 * f_3 - f_4) / omega1 - q_0 - q_2 - 2.0 * q_4;  // by omega1
    gradient[1] = (f_1 - f_2 - f_4) / omega2 - q_0 - 2.0 * q_2 - q_4;  // by omega2
    const double c_0 = -over_22 / (4.0 * omega1 * omega2);  // multiplies alpha22*eta11
    const double c_1 = -over_21 / (4.0 * omega1_2);  // multiplies alpha23*eta21
    const double c_2 = -per_4 / (4.0 * omega2);  // multiplies delta22*eta11
    const double c_3 = (2.0 * omega1 + omega2) * per_2 / (4.0 * omega1_2);  // multiplies delta23*eta21
    gradient[6] = eta11 * c_0;  // by alpha22
    gradient[7] = eta21 * c_1;  // by alpha23
    gradient[9] = eta11 * c_2;  // by delta22
    gradient[10] = eta21 * c_3;  // by delta23
    gradient[20] = alpha22 * c_0 + delta22 * c_2;  // by eta11
    gradient[29] = alpha23 * c_1 + delta23 * c_3;  // by eta21
  }
  void lump_harmonic_im_v2_A_v1_F_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = -mu21 * eta22 * over_57 / 8.0;
    const double f_1 = -eta12 * mu21 * over_69 / 4.0;
    const double f_2 = -omega2 * eta12 * mu21 * over_69 / (8.0 * omega1);
    const double q_0 = (2.0 * f_0 + 2.0 * f_1 + 2.0 * f_2) * per_0;
    const double q_1 = f_0 * per_1;
    const double q_9 = (f_1 + f_2) * per_9;
    gradient[0] = -f_2 / omega1 - q_0 - q_1 - 3.0 * q_9;  // by omega1
    gradient[1] = f_2 / omega2 - q_0 + q_1 - q_9;  // by omega2
    const double c_0 = (-2.0 * omega1 - omega2) * over_69 / (8.0 * omega1);  // multiplies eta12*mu21
    const double c_1 = -over_57 / 8.0;  // multiplies mu21*eta22
    gradient[21] = mu21 * c_0;  // by eta12
    gradient[23] = eta12 * c_0 + eta22 * c_1;  // by mu21
    gradient[30] = mu21 * c_1;  // by eta22
  }
  void lump_harmonic_re_v2_A_v1_A_v2_F_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = 2.0 * omega2 * delta23 * eta12 * over_70;
    const double f_1 = -alpha23 * eta12 * over_71;
    const double f_2 = 2.0 * omega1_2 * delta23 * eta22 * over_72;
    const double f_3 = 9.0 * omega1 * omega2 * delta23 * eta22 * over_72;
    const double f_4 = 12.0 * omega2_2 * delta23 * eta22 * over_72;
    const double f_5 = 3.0 * omega2_3 * delta23 * eta22 * over_72 / omega1;
    const double f_6 = -2.0 * omega1 * alpha23 * eta22 * over_73;
    const double f_7 = -6.0 * omega2 * alpha23 * eta22 * over_73;
    const double f_8 = -3.0 * omega2_2 * alpha23 * eta22 * over_73 / omega1;
    const double q_0 = (f_1 + f_6 + f_7 + f_8) * per_0;
    const double q_2 = (f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_2;
    const double q_4 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_4;
    const double q_7 = (f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_7;
    const double q_9 = (f_0 + f_1) * per_9;
    const double q_12 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6 + f_7 + f_8) * per_12;
    gradient[0] = (2.0 * f_2 + f_3 - f_5 + f_6 - f_8) / omega1 - q_0 - q_2 - 2.0 * q_4 - q_7 - 3.0 * q_9
        - 2.0 * q_12;
    gradient[1] = (f_0 + f_3 + 2.0 * f_4 + 3.0 * f_5 + f_7 + 2.0 * f_8) / omega2 - q_0 - 2.0 * q_2 - q_4 - 3.0 * q_7
        - q_9 - 3.0 * q_12;
    const double c_0 = -over_71;  // multiplies alpha23*eta12
    const double c_1 = (-2.0 * omega1_2 - 6.0 * omega1 * omega2 - 3.0 * omega2_2) * over_73 / omega1;
    const double c_2 = 2.0 * omega2 * over_70;  // multiplies delta23*eta12
    const double c_3 = (2.0 * omega1_3 + 9.0 * omega1_2 * omega2 + 12.0 * omega1 * omega2_2
        + 3.0 * omega2_3) * over_72 / omega1;
    gradient[7] = eta12 * c_0 + eta22 * c_1;  // by alpha23
    gradient[10] = eta12 * c_2 + eta22 * c_3;  // by delta23
    gradient[21] = alpha23 * c_0 + delta23 * c_2;  // by eta12
    gradient[30] = alpha23 * c_1 + delta23 * c_3;  // by eta22
  }
  void lump_harmonic_re_v2_A_v12_F_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = -2.0 * omega1 * delta22 * eta12 * over_74 / 3.0;
    const double f_1 = -omega2 * delta22 * eta12 * over_74 / 3.0;
    const double f_2 = -alpha22 * eta12 * over_74 / (3.0 * omega1);
    const double f_3 = -omega1 * delta22 * eta22 * over_75 / 6.0;
    const double f_4 = -alpha22 * eta22 * over_75 / (6.0 * omega1);
    const double q_0 = (f_0 + f_1 + f_2) * per_0;
    const double q_4 = (f_3 + f_4) * per_4;
    const double q_5 = (f_3 + f_4) * per_5;
    const double q_9 = (f_0 + f_1 + f_2) * per_9;
    const double q_10 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_10;
    gradient[0] = (f_0 - f_2 + f_3 - f_4) / omega1 - q_0 - 2.0 * q_4 - 2.0 * q_5 - 3.0 * q_9 - 3.0 * q_10;
    gradient[1] = f_1 / omega2 - q_0 - q_4 + q_5 - q_9 - 2.0 * q_10;  // by omega2
    const double c_0 = -over_74 / (3.0 * omega1);  // multiplies alpha22*eta12
    const double c_1 = -over_75 / (6.0 * omega1);  // multiplies alpha22*eta22
    const double c_2 = (-2.0 * omega1 - omega2) * over_74 / 3.0;  // multiplies delta22*eta12
    const double c_3 = -omega1 * over_75 / 6.0;  // multiplies delta22*eta22
    gradient[6] = eta12 * c_0 + eta22 * c_1;  // by alpha22
    gradient[9] = eta12 * c_2 + eta22 * c_3;  // by delta22
    gradient[21] = alpha22 * c_0 + delta22 * c_2;  // by eta12
    gradient[30] = alpha22 * c_1 + delta22 * c_3;  // by eta22
  }

  using Gradient = void (LumpGradients::*)(double*) const;
  static constexpr Gradient gradients[] = {&LumpGradients::lump_conservative_v1_A_v12_F, &LumpGradients::lump_mu11,
      &LumpGradients::lump_conservative_v1_A_v1, &LumpGradients::lump_conservative_v1_A_v1_F2,
      &LumpGradients::lump_conservative_v1_A_v1_A_v2_conjA_v2, &LumpGradients::lump_mu13,
      &LumpGradients::lump_conservative_v1_A_v12_conjA_v1, &LumpGradients::lump_eta11,
      &LumpGradients::lump_conservative_v1_A_v2_conjA_v2_F, &LumpGradients::lump_mu22,
      &LumpGradients::lump_conservative_v2_A_v2_F2, &LumpGradients::lump_mu23,
      &LumpGradients::lump_conservative_v2_A_v22_conjA_v2, &LumpGradients::lump_eta12,
      &LumpGradients::lump_harmonic_re_v1_A_v2_conjA_v2, &LumpGradients::lump_harmonic_re_v1_A_v1_conjA_v1,
      &LumpGradients::lump_harmonic_re_v1_A_v2_conjA_v1, &LumpGradients::lump_harmonic_im_v1_A_v2_conjA_v1,
      &LumpGradients::lump_harmonic_im_v1_A_v2_F, &LumpGradients::lump_mu12,
      &LumpGradients::lump_harmonic_re_v1_A_v2_conjA_v1_F, &LumpGradients::lump_harmonic_re_v1_A_v22_conjA_v2,
      &LumpGradients::lump_harmonic_re_v1_A_v1_A_v2_conjA_v1, &LumpGradients::lump_harmonic_re_v1_A_v1_A_v2_F,
      &LumpGradients::lump_harmonic_re_v1_A_v22, &LumpGradients::lump_harmonic_im_v1_A_v22,
      &LumpGradients::lump_harmonic_re_v1_A_v12, &LumpGradients::lump_harmonic_im_v1_A_v12,
      &LumpGradients::lump_harmonic_re_v1_A_v1_A_v2, &LumpGradients::lump_harmonic_im_v1_A_v1_A_v2,
      &LumpGradients::lump_harmonic_re_v1_A_v2_conjA_v12, &LumpGradients::lump_harmonic_re_v1_A_v22_conjA_v1,
      &LumpGradients::lump_harmonic_re_v1_A_v22_F, &LumpGradients::lump_harmonic_re_v1_A_v1_A_v22,
      &LumpGradients::lump_harmonic_re_v1_A_v23, &LumpGradients::lump_harmonic_re_v1_A_v12_F,
      &LumpGradients::lump_harmonic_re_v1_A_v13, &LumpGradients::lump_harmonic_re_v1_A_v12_A_v2,
      &LumpGradients::lump_harmonic_re_v2_A_v2_conjA_v1, &LumpGradients::lump_eta22,
      &LumpGradients::lump_harmonic_im_v2_A_v2_conjA_v1, &LumpGradients::lump_harmonic_re_v2_A_v2_conjA_v2,
      &LumpGradients::lump_harmonic_re_v2_A_v1_conjA_v1, &LumpGradients::lump_harmonic_im_v2_conjA_v1_F,
      &LumpGradients::lump_harmonic_re_v2_A_v1_A_v2, &LumpGradients::lump_harmonic_im_v2_A_v1_A_v2,
      &LumpGradients::lump_harmonic_re_v2_A_v22, &LumpGradients::lump_harmonic_im_v2_A_v22,
      &LumpGradients::lump_mu21, &LumpGradients::lump_eta21, &LumpGradients::lump_harmonic_re_v2_A_v2_conjA_v2_F,
      &LumpGradients::lump_harmonic_re_v2_A_v1_conjA_v1_F, &LumpGradients::lump_harmonic_re_v2_A_v1_A_v2_conjA_v2,
      &LumpGradients::lump_harmonic_re_v2_A_v12_conjA_v1, &LumpGradients::lump_harmonic_re_v2_A_v12_F,
      &LumpGradients::lump_harmonic_re_v2_A_v12, &LumpGradients::lump_harmonic_im_v2_A_v1_F,
      &LumpGradients::lump_harmonic_im_v2_A_v12, &LumpGradients::lump_harmonic_re_v2_A_v2_conjA_v12,
      &LumpGradients::lump_harmonic_re_v2_A_v2_conjA_v1_F, &LumpGradients::lump_harmonic_re_v2_A_v22_conjA_v1,
      &LumpGradients::lump_harmonic_re_v2_A_v22_F, &LumpGradients::lump_harmonic_re_v2_A_v1_A_v2_F,
      &LumpGradients::lump_harmonic_re_v2_A_v12_A_v2, &LumpGradients::lump_harmonic_re_v2_A_v1_A_v22,
      &LumpGradients::lump_harmonic_re_v2_A_v23, &LumpGradients::lump_harmonic_re_v2_A_v13,
      &LumpGradients::lump_conservative_v1_A_v1_A_v2_F, &LumpGradients::lump_conservative_v1_A_v1_F2_of_primary_2,
      &LumpGradients::lump_conservative_v2_A_v22_F, &LumpGradients::lump_conservative_v2_A_v2_F2_of_primary_2,
      &LumpGradients::lump_harmonic_im_v1_conjA_v2_F, &LumpGradients::lump_harmonic_re_v1_A_v2_conjA_v2_F,
      &LumpGradients::lump_harmonic_re_v1_A_v1_conjA_v1_F, &LumpGradients::lump_harmonic_re_v1_A_v22_F_of_primary_2,
      &LumpGradients::lump_harmonic_im_v1_A_v2_F_of_primary_2, &LumpGradients::lump_harmonic_re_v1_conjA_v12_F,
      &LumpGradients::lump_harmonic_re_v1_A_v2_conjA_v1_F_of_primary_2,
      &LumpGradients::lump_harmonic_re_v1_A_v1_A_v2_F_of_primary_2,
      &LumpGradients::lump_harmonic_re_v1_A_v12_F_of_primary_2,
      &LumpGradients::lump_harmonic_im_v2_conjA_v1_F_of_primary_2,
      &LumpGradients::lump_harmonic_re_v2_A_v1_conjA_v2_F,
      &LumpGradients::lump_harmonic_re_v2_A_v1_A_v2_F_of_primary_2,
      &LumpGradients::lump_harmonic_im_v2_A_v1_F_of_primary_2, &LumpGradients::lump_harmonic_re_v2_conjA_v12_F,
      &LumpGradients::lump_harmonic_re_v2_A_v2_conjA_v1_F_of_primary_2,
      &LumpGradients::lump_harmonic_re_v2_A_v22_F_of_primary_2,
      &LumpGradients::lump_harmonic_re_v2_A_v12_F_of_primary_2, &LumpGradients::lump_conservative_v1_conjA_v1_F,
      &LumpGradients::lump_harmonic_im_v1_F, &LumpGradients::lump_harmonic_re_v1_A_v2_F,
      &LumpGradients::lump_harmonic_re_v1_A_v1_F, &LumpGradients::lump_harmonic_im_v2_F,
      &LumpGradients::lump_harmonic_re_v2_conjA_v1_F, &LumpGradients::lump_harmonic_re_v2_A_v2_F,
      &LumpGradients::lump_harmonic_re_v2_A_v1_F, &LumpGradients::lump_conservative_v2_conjA_v2_F,
      &LumpGradients::lump_harmonic_im_v1_F_of_principal_parametric_2,
      &LumpGradients::lump_harmonic_re_v1_conjA_v2_F, &LumpGradients::lump_harmonic_re_v1_conjA_v1_F,
      &LumpGradients::lump_harmonic_re_v1_A_v2_F_of_principal_parametric_2,
      &LumpGradients::lump_harmonic_re_v1_A_v1_F_of_principal_parametric_2,
      &LumpGradients::lump_harmonic_im_v2_F_of_principal_parametric_2,
      &LumpGradients::lump_harmonic_re_v2_conjA_v1_F_of_principal_parametric_2,
      &LumpGradients::lump_harmonic_re_v2_A_v2_F_of_principal_parametric_2,
      &LumpGradients::lump_harmonic_re_v2_A_v1_F_of_principal_parametric_2,
      &LumpGradients::lump_conservative_v1_A_v1_F2_of_additive_combination,
      &LumpGradients::lump_dissipative_v1_conjA_v2_F, &LumpGradients::lump_conservative_v1_conjA_v2_F,
      &LumpGradients::lump_conservative_v2_A_v2_F2_of_additive_combination,
      &LumpGradients::lump_dissipative_v2_conjA_v1_F,
      &LumpGradients::lump_harmonic_re_v1_conjA_v1_F_of_additive_combination,
      &LumpGradients::lump_harmonic_re_v1_conjA_v12_F_of_additive_combination,
      &LumpGradients::lump_harmonic_re_v1_A_v22_F_of_additive_combination,
      &LumpGradients::lump_harmonic_re_v1_conjA_v1_conjA_v2_F, &LumpGradients::lump_harmonic_re_v1_F2,
      &LumpGradients::lump_harmonic_im_v1_F_of_additive_combination,
      &LumpGradients::lump_harmonic_re_v1_A_v2_conjA_v2_F_of_additive_combination,
      &LumpGradients::lump_harmonic_re_v1_A_v1_conjA_v1_F_of_additive_combination,
      &LumpGradients::lump_harmonic_re_v1_A_v2_conjA_v1_F_of_additive_combination,
      &LumpGradients::lump_harmonic_re_v1_A_v1_F_of_additive_combination,
      &LumpGradients::lump_harmonic_re_v1_A_v1_conjA_v2_F,
      &LumpGradients::lump_harmonic_re_v1_A_v2_F_of_additive_combination,
      &LumpGradients::lump_harmonic_im_v1_A_v2_F_of_additive_combination,
      &LumpGradients::lump_harmonic_re_v1_A_v1_A_v2_F_of_additive_combination,
      &LumpGradients::lump_harmonic_re_v1_A_v12_F_of_additive_combination,
      &LumpGradients::lump_harmonic_re_v2_conjA_v12_F_of_additive_combination,
      &LumpGradients::lump_harmonic_re_v2_A_v22_F_of_additive_combination,
      &LumpGradients::lump_harmonic_re_v2_conjA_v2_F, &LumpGradients::lump_harmonic_re_v2_conjA_v1_conjA_v2_F,
      &LumpGradients::lump_harmonic_re_v2_F2, &LumpGradients::lump_harmonic_im_v2_F_of_additive_combination,
      &LumpGradients::lump_harmonic_re_v2_A_v2_conjA_v2_F_of_additive_combination,
      &LumpGradients::lump_harmonic_re_v2_A_v1_conjA_v1_F_of_additive_combination,
      &LumpGradients::lump_harmonic_re_v2_A_v2_F_of_additive_combination,
      &LumpGradients::lump_harmonic_re_v2_A_v2_conjA_v1_F_of_additive_combination,
      &LumpGradients::lump_harmonic_re_v2_A_v1_conjA_v2_F_of_additive_combination,
      &LumpGradients::lump_harmonic_re_v2_A_v1_F_of_additive_combination,
      &LumpGradients::lump_harmonic_im_v2_A_v1_F_of_additive_combination,
      &LumpGradients::lump_harmonic_re_v2_A_v1_A_v2_F_of_additive_combination,
      &LumpGradients::lump_harmonic_re_v2_A_v12_F_of_additive_combination};
};

inline constexpr LumpFunctions lump_functions = {lump_values<Lumps>, lump_jacobian<LumpGradients, 31>};

}  // namespace secular::generated::two_mass
