// Model internal_resonance: generated code, never edited by hand.
// Holds derivatives of the lumps by the parameters. Made by: secular generate internal_resonance.
#pragma once

#include "internal_resonance.hpp"

namespace secular::generated::internal_resonance {

/// gradient[p] = derivative of a lump by parameters[p], entries that are not zero. Of lumps with small divisors:
/// f_n are the fractions whose sum the lump is, q_d those of divisor d times its power and inverse, c_n what
/// multiplies a product of coefficients.
struct LumpGradients : Lumps {
  using Lumps::Lumps;

  void lump_conservative_x_A_x2_conjA_y([[maybe_unused]] double* gradient) const {
    const double f_0 = 3.0 * b2 / (2.0 * omega1);
    const double f_1 = a1 * a2 / (3.0 * omega1_3);
    const double f_2 = 2.0 * a2 * a3 * per_0 / omega1_2;
    const double f_3 = -2.0 * a1 * a2 * per_1 / (omega1 * omega2);
    const double f_4 = a2 * a3 * over_0 / omega1;
    const double q_0 = f_2 * per_0;
    const double q_1 = (f_3 + f_4) * per_1;
    const double q_2 = f_4 * per_2;
    gradient[0] = (-f_0 - 3.0 * f_1 - 2.0 * f_2 - f_3 - f_4) / omega1 - q_0 - 2.0 * q_1 - 2.0 * q_2;  // by omega1
    gradient[1] = -f_3 / omega2 + 2.0 * q_0 + q_1 - q_2;  // by omega2
    const double c_0 = 1.0 / (3.0 * omega1_3) - 2.0 * per_1 / (omega1 * omega2);  // multiplies a1*a2
    const double c_1 = 2.0 * per_0 / omega1_2 + over_0 / omega1;  // multiplies a2*a3
    const double c_2 = 3.0 / (2.0 * omega1);  // multiplies b2
    gradient[2] = a2 * c_0;  // by a1
    gradient[3] = a1 * c_0 + a3 * c_1;  // by a2
    gradient[4] = a2 * c_1;  // by a3
    gradient[7] = c_2;  // by b2
  }
  void lump_mu1([[maybe_unused]] double* gradient) const { gradient[11] = 1.0; }
  void lump_conservative_x_A_x_A_y_conjA_y([[maybe_unused]] double* gradient) const {
    const double f_0 = b3 / omega1;
    const double f_1 = -2.0 * a2 * a4 / (omega1 * omega2_2);
    const double f_2 = -2.0 * a1 * a3 / omega1_3;
    const double f_3 = 4.0 * a3_2 * over_1 / omega1;
    const double f_4 = -4.0 * a2_2 * over_0 / omega1;
    const double q_0 = f_3 * per_0;
    const double q_1 = f_4 * per_1;
    const double q_2 = f_4 * per_2;
    const double q_3 = f_3 * per_3;
    gradient[0] = (-f_0 - f_1 - 3.0 * f_2 - f_3 - f_4) / omega1 - q_0 - 2.0 * q_1 - 2.0 * q_2 - q_3;  // by omega1
    gradient[1] = -2.0 * f_1 / omega2 + 2.0 * q_0 + q_1 - q_2 - 2.0 * q_3;  // by omega2
    const double c_0 = -2.0 / omega1_3;  // multiplies a1*a3
    const double c_1 = -4.0 * over_0 / omega1;  // multiplies a2^2
    const double c_2 = -2.0 / (omega1 * omega2_2);  // multiplies a2*a4
    const double c_3 = 4.0 * over_1 / omega1;  // multiplies a3^2
    const double c_4 = 1.0 / omega1;  // multiplies b3
    gradient[2] = a3 * c_0;  // by a1
    gradient[3] = 2.0 * a2 * c_1 + a4 * c_2;  // by a2
    gradient[4] = a1 * c_0 + 2.0 * a3 * c_3;  // by a3
    gradient[5] = a2 * c_2;  // by a4
    gradient[8] = c_4;  // by b3
  }
  void lump_conservative_x_A_x2_conjA_x([[maybe_unused]] double* gradient) const {
    const double f_0 = 3.0 * b1 / (2.0 * omega1);
    const double f_1 = -5.0 * a1_2 / (3.0 * omega1_3);
    const double f_2 = -8.0 * omega1 * a2_2 * over_0 / omega2_2;
    const double f_3 = 3.0 * a2_2 * over_0 / omega1;
    const double q_1 = (f_2 + f_3) * per_1;
    const double q_2 = (f_2 + f_3) * per_2;
    gradient[0] = (-f_0 - 3.0 * f_1 + f_2 - f_3) / omega1 - 2.0 * q_1 - 2.0 * q_2;  // by omega1
    gradient[1] = -2.0 * f_2 / omega2 + q_1 - q_2;  // by omega2
    const double c_0 = -5.0 / (3.0 * omega1_3);  // multiplies a1^2
    const double c_1 = (-8.0 * omega1_2 + 3.0 * omega2_2) * over_0 / (omega1 * omega2_2);  // multiplies a2^2
    const double c_2 = 3.0 / (2.0 * omega1);  // multiplies b1
    gradient[2] = 2.0 * a1 * c_0;  // by a1
    gradient[3] = 2.0 * a2 * c_1;  // by a2
    gradient[6] = c_2;  // by b1
  }
  void lump_e1([[maybe_unused]] double* gradient) const { gradient[12] = 1.0; }
  void lump_conservative_x_A_y2_conjA_y([[maybe_unused]] double* gradient) const {
    const double f_0 = 3.0 * b4 / (2.0 * omega1);
    const double f_1 = -5.0 * a3 * a4 / (3.0 * omega1 * omega2_2);
    const double f_2 = -3.0 * a2 * a3 * over_1 / omega1;
    const double f_3 = 8.0 * omega2_2 * a2 * a3 * over_1 / omega1_3;
    const double q_0 = (f_2 + f_3) * per_0;
    const double q_3 = (f_2 + f_3) * per_3;
    gradient[0] = (-f_0 - f_1 - f_2 - 3.0 * f_3) / omega1 - q_0 - q_3;  // by omega1
    gradient[1] = (-2.0 * f_1 + 2.0 * f_3) / omega2 + 2.0 * q_0 - 2.0 * q_3;  // by omega2
    const double c_0 = (-3.0 * omega1_2 + 8.0 * omega2_2) * over_1 / omega1_3;  // multiplies a2*a3
    const double c_1 = -5.0 / (3.0 * omega1 * omega2_2);  // multiplies a3*a4
    const double c_2 = 3.0 / (2.0 * omega1);  // multiplies b4
    gradient[3] = a3 * c_0;  // by a2
    gradient[4] = a2 * c_0 + a4 * c_1;  // by a3
    gradient[5] = a3 * c_1;  // by a4
    gradient[9] = c_2;  // by b4
  }
  void lump_conservative_x_A_x_A_y_conjA_x([[maybe_unused]] double* gradient) const {
    const double f_0 = 3.0 * b2 / omega1;
    const double f_1 = -2.0 * omega1 * a2 * a3 * over_1 / omega2_2;
    const double f_2 = 12.0 * a2 * a3 * over_1 / omega1;
    const double f_3 = -12.0 * a1 * a2 * over_0 / omega1;
    const double f_4 = 2.0 * omega2_2 * a1 * a2 * over_0 / omega1_3;
    const double q_0 = (f_1 + f_2) * per_0;
    const double q_1 = (f_3 + f_4) * per_1;
    const double q_2 = (f_3 + f_4) * per_2;
    const double q_3 = (f_1 + f_2) * per_3;
    gradient[0] = (-f_0 + f_1 - f_2 - f_3 - 3.0 * f_4) / omega1 - q_0 - 2.0 * q_1 - 2.0 * q_2 - q_3;  // by omega1
    gradient[1] = (-2.0 * f_1 + 2.0 * f_4) / omega2 + 2.0 * q_0 + q_1 - q_2 - 2.0 * q_3;  // by omega2
    const double c_0 = (-12.0 * omega1_2 + 2.0 * omega2_2) * over_0 / omega1_3;  // multiplies a1*a2
    const double c_1 = (-2.0 * omega1_2 + 12.0 * omega2_2) * over_1 / (omega1 * omega2_2);  // multiplies a2*a3
    const double c_2 = 3.0 / omega1;  // multiplies b2
    gradient[2] = a2 * c_0;  // by a1
    gradient[3] = a1 * c_0 + a3 * c_1;  // by a2
    gradient[4] = a2 * c_1;  // by a3
    gradient[7] = c_2;  // by b2
  }
  void lump_conservative_x_A_y2_conjA_x([[maybe_unused]] double* gradient) const {
    const double f_0 = b3 / (2.0 * omega1);
    const double f_1 = a2 * a4 / (3.0 * omega1 * omega2_2);
    const double f_2 = 2.0 * a3_2 * per_0 / omega1_2;
    const double f_3 = -2.0 * a2_2 * per_1 / (omega1 * omega2);
    const double f_4 = -a1 * a3 * over_1 / omega1;
    const double q_0 = (f_2 + f_4) * per_0;
    const double q_1 = f_3 * per_1;
    const double q_3 = f_4 * per_3;
    gradient[0] = (-f_0 - f_1 - 2.0 * f_2 - f_3 - f_4) / omega1 - q_0 - 2.0 * q_1 - q_3;  // by omega1
    gradient[1] = (-2.0 * f_1 - f_3) / omega2 + 2.0 * q_0 + q_1 - 2.0 * q_3;  // by omega2
    const double c_0 = -over_1 / omega1;  // multiplies a1*a3
    const double c_1 = -2.0 * per_1 / (omega1 * omega2);  // multiplies a2^2
    const double c_2 = 1.0 / (3.0 * omega1 * omega2_2);  // multiplies a2*a4
    const double c_3 = 2.0 * per_0 / omega1_2;  // multiplies a3^2
    const double c_4 = 1.0 / (2.0 * omega1);  // multiplies b3
    gradient[2] = a3 * c_0;  // by a1
    gradient[3] = 2.0 * a2 * c_1 + a4 * c_2;  // by a2
    gradient[4] = a1 * c_0 + 2.0 * a3 * c_3;  // by a3
    gradient[5] = a2 * c_2;  // by a4
    gradient[8] = c_4;  // by b3
  }
  void lump_conservative_y_A_x2_conjA_y([[maybe_unused]] double* gradient) const {
    const double f_0 = b3 / (2.0 * omega2);
    const double f_1 = a1 * a3 / (3.0 * omega1_2 * omega2);
    const double f_2 = 2.0 * a3_2 * per_0 / (omega1 * omega2);
    const double f_3 = -2.0 * a2_2 * per_1 / omega2_2;
    const double f_4 = a2 * a4 * over_0 / omega2;
    const double q_0 = f_2 * per_0;
    const double q_1 = (f_3 + f_4) * per_1;
    const double q_2 = f_4 * per_2;
    gradient[0] = (-2.0 * f_1 - f_2) / omega1 - q_0 - 2.0 * q_1 - 2.0 * q_2;  // by omega1
    gradient[1] = (-f_0 - f_1 - f_2 - 2.0 * f_3 - f_4) / omega2 + 2.0 * q_0 + q_1 - q_2;  // by omega2
    const double c_0 = 1.0 / (3.0 * omega1_2 * omega2);  // multiplies a1*a3
    const double c_1 = -2.0 * per_1 / omega2_2;  // multiplies a2^2
    const double c_2 = over_0 / omega2;  // multiplies a2*a4
    const double c_3 = 2.0 * per_0 / (omega1 * omega2);  // multiplies a3^2
    const double c_4 = 1.0 / (2.0 * omega2);  // multiplies b3
    gradient[2] = a3 * c_0;  // by a1
    gradient[3] = 2.0 * a2 * c_1 + a4 * c_2;  // by a2
    gradient[4] = a1 * c_0 + 2.0 * a3 * c_3;  // by a3
    gradient[5] = a2 * c_2;  // by a4
    gradient[8] = c_4;  // by b3
  }
  void lump_conservative_y_A_x_A_y_conjA_y([[maybe_unused]] double* gradient) const {
    const double f_0 = 3.0 * b4 / omega2;
    const double f_1 = -2.0 * omega1_2 * a3 * a4 * over_1 / omega2_3;
    const double f_2 = 12.0 * a3 * a4 * over_1 / omega2;
    const double f_3 = -12.0 * a2 * a3 * over_0 / omega2;
    const double f_4 = 2.0 * omega2 * a2 * a3 * over_0 / omega1_2;
    const double q_0 = (f_1 + f_2) * per_0;
    const double q_1 = (f_3 + f_4) * per_1;
    const double q_2 = (f_3 + f_4) * per_2;
    const double q_3 = (f_1 + f_2) * per_3;
    gradient[0] = (2.0 * f_1 - 2.0 * f_4) / omega1 - q_0 - 2.0 * q_1 - 2.0 * q_2 - q_3;  // by omega1
    gradient[1] = (-f_0 - 3.0 * f_1 - f_2 - f_3 + f_4) / omega2 + 2.0 * q_0 + q_1 - q_2 - 2.0 * q_3;  // by omega2
    const double c_0 = (-12.0 * omega1_2 + 2.0 * omega2_2) * over_0 / (omega1_2 * omega2);  // multiplies a2*a3
    const double c_1 = (-2.0 * omega1_2 + 12.0 * omega2_2) * over_1 / omega2_3;  // multiplies a3*a4
    const double c_2 = 3.0 / omega2;  // multiplies b4
    gradient[3] = a3 * c_0;  // by a2
    gradient[4] = a2 * c_0 + a4 * c_1;  // by a3
    gradient[5] = a3 * c_1;  // by a4
    gradient[9] = c_2;  // by b4
  }
  void lump_conservative_y_A_x2_conjA_x([[maybe_unused]] double* gradient) const {
    const double f_0 = 3.0 * b2 / (2.0 * omega2);
    const double f_1 = -5.0 * a1 * a2 / (3.0 * omega1_2 * omega2);
    const double f_2 = -8.0 * omega1_2 * a2 * a3 * over_0 / omega2_3;
    const double f_3 = 3.0 * a2 * a3 * over_0 / omega2;
    const double q_1 = (f_2 + f_3) * per_1;
    const double q_2 = (f_2 + f_3) * per_2;
    gradient[0] = (-2.0 * f_1 + 2.0 * f_2) / omega1 - 2.0 * q_1 - 2.0 * q_2;  // by omega1
    gradient[1] = (-f_0 - f_1 - 3.0 * f_2 - f_3) / omega2 + q_1 - q_2;  // by omega2
    const double c_0 = -5.0 / (3.0 * omega1_2 * omega2);  // multiplies a1*a2
    const double c_1 = (-8.0 * omega1_2 + 3.0 * omega2_2) * over_0 / omega2_3;  // multiplies a2*a3
    const double c_2 = 3.0 / (2.0 * omega2);  // multiplies b2
    gradient[2] = a2 * c_0;  // by a1
    gradient[3] = a1 * c_0 + a3 * c_1;  // by a2
    gradient[4] = a2 * c_1;  // by a3
    gradient[7] = c_2;  // by b2
  }
  void lump_e2([[maybe_unused]] double* gradient) const { gradient[14] = 1.0; }
  void lump_mu2([[maybe_unused]] double* gradient) const { gradient[13] = 1.0; }
  void lump_conservative_y_A_y2_conjA_y([[maybe_unused]] double* gradient) const {
    const double f_0 = 3.0 * b5 / (2.0 * omega2);
    const double f_1 = -5.0 * a4_2 / (3.0 * omega2_3);
    const double f_2 = -3.0 * a3_2 * over_1 / omega2;
    const double f_3 = 8.0 * omega2 * a3_2 * over_1 / omega1_2;
    const double q_0 = (f_2 + f_3) * per_0;
    const double q_3 = (f_2 + f_3) * per_3;
    gradient[0] = -2.0 * f_3 / omega1 - q_0 - q_3;  // by omega1
    gradient[1] = (-f_0 - 3.0 * f_1 - f_2 + f_3) / omega2 + 2.0 * q_0 - 2.0 * q_3;  // by omega2
    const double c_0 = (-3.0 * omega1_2 + 8.0 * omega2_2) * over_1 / (omega1_2 * omega2);  // multiplies a3^2
    const double c_1 = -5.0 / (3.0 * omega2_3);  // multiplies a4^2
    const double c_2 = 3.0 / (2.0 * omega2);  // multiplies b5
    gradient[4] = 2.0 * a3 * c_0;  // by a3
    gradient[5] = 2.0 * a4 * c_1;  // by a4
    gradient[10] = c_2;  // by b5
  }
  void lump_conservative_y_A_y2_conjA_x([[maybe_unused]] double* gradient) const {
    const double f_0 = 3.0 * b4 / (2.0 * omega2);
    const double f_1 = a3 * a4 / (3.0 * omega2_3);
    const double f_2 = 2.0 * a3 * a4 * per_0 / (omega1 * omega2);
    const double f_3 = -2.0 * a2 * a3 * per_1 / omega2_2;
    const double f_4 = -a2 * a3 * over_1 / omega2;
    const double q_0 = (f_2 + f_4) * per_0;
    const double q_1 = f_3 * per_1;
    const double q_3 = f_4 * per_3;
    gradient[0] = -f_2 / omega1 - q_0 - 2.0 * q_1 - q_3;  // by omega1
    gradient[1] = (-f_0 - 3.0 * f_1 - f_2 - 2.0 * f_3 - f_4) / omega2 + 2.0 * q_0 + q_1 - 2.0 * q_3;  // by omega2
    const double c_0 = -2.0 * per_1 / omega2_2 - over_1 / omega2;  // multiplies a2*a3
    const double c_1 = 1.0 / (3.0 * omega2_3) + 2.0 * per_0 / (omega1 * omega2);  // multiplies a3*a4
    const double c_2 = 3.0 / (2.0 * omega2);  // multiplies b4
    gradient[3] = a3 * c_0;  // by a2
    gradient[4] = a2 * c_0 + a4 * c_1;  // by a3
    gradient[5] = a3 * c_1;  // by a4
    gradient[9] = c_2;  // by b4
  }
  void lump_a2([[maybe_unused]] double* gradient) const { gradient[3] = 1.0; }
  void lump_a3([[maybe_unused]] double* gradient) const { gradient[4] = 1.0; }
  void lump_a1([[maybe_unused]] double* gradient) const { gradient[2] = 1.0; }
  void lump_harmonic_re_x_A_y3([[maybe_unused]] double* gradient) const {
    const double f_0 = -b4 * over_2;
    const double f_1 = -2.0 * a3 * a4 * over_2 / (3.0 * omega2_2);
    const double f_2 = 2.0 * a2 * a3 * over_3;
    const double q_0 = f_2 * per_0;
    const double q_3 = f_2 * per_3;
    const double q_4 = (f_0 + f_1 + f_2) * per_4;
    const double q_5 = (f_0 + f_1 + f_2) * per_5;
    gradient[0] = -q_0 - q_3 - q_4 - q_5;  // by omega1
    gradient[1] = -2.0 * f_1 / omega2 + 2.0 * q_0 - 2.0 * q_3 - 3.0 * q_4 + 3.0 * q_5;  // by omega2
    const double c_0 = 2.0 * over_3;  // multiplies a2*a3
    const double c_1 = -2.0 * over_2 / (3.0 * omega2_2);  // multiplies a3*a4
    const double c_2 = -over_2;  // multiplies b4
    gradient[3] = a3 * c_0;  // by a2
    gradient[4] = a2 * c_0 + a4 * c_1;  // by a3
    gradient[5] = a3 * c_1;  // by a4
    gradient[9] = c_2;  // by b4
  }
  void lump_harmonic_re_x_A_x_A_y2([[maybe_unused]] double* gradient) const {
    const double f_0 = b3 * per_6 / (4.0 * omega2);
    const double f_1 = a2 * a4 * per_6 / (6.0 * omega2_3);
    const double f_2 = a3_2 * over_4 / (omega1 * omega2);
    const double f_3 = a2_2 * over_5 / omega2_2;
    const double f_4 = -a1 * a3 * over_6 / (2.0 * omega2);
    const double q_0 = f_4 * per_0;
    const double q_2 = f_3 * per_2;
    const double q_3 = (f_2 + f_4) * per_3;
    const double q_6 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_6;
    gradient[0] = -f_2 / omega1 - q_0 - 2.0 * q_2 - q_3 - q_6;  // by omega1
    gradient[1] = (-f_0 - 3.0 * f_1 - f_2 - 2.0 * f_3 - f_4) / omega2 + 2.0 * q_0 - q_2 - 2.0 * q_3 - q_6;
    const double c_0 = -over_6 / (2.0 * omega2);  // multiplies a1*a3
    const double c_1 = over_5 / omega2_2;  // multiplies a2^2
    const double c_2 = per_6 / (6.0 * omega2_3);  // multiplies a2*a4
    const double c_3 = over_4 / (omega1 * omega2);  // multiplies a3^2
    const double c_4 = per_6 / (4.0 * omega2);  // multiplies b3
    gradient[2] = a3 * c_0;  // by a1
    gradient[3] = 2.0 * a2 * c_1 + a4 * c_2;  // by a2
    gradient[4] = a1 * c_0 + 2.0 * a3 * c_3;  // by a3
    gradient[5] = a2 * c_2;  // by a4
    gradient[8] = c_4;  // by b3
  }
  void lump_harmonic_re_x_A_x2_A_y([[maybe_unused]] double* gradient) const {
    const double f_0 = 3.0 * b2 * over_7;
    const double f_1 = 4.0 * a1 * a2 * over_8 / omega2;
    const double f_2 = 4.0 * a1 * a2 * over_8 / (3.0 * omega1);
    const double f_3 = 2.0 * omega2 * a1 * a2 * over_8 / (3.0 * omega1_2);
    const double f_4 = 18.0 * omega1 * a2 * a3 * over_9;
    const double f_5 = 4.0 * omega2 * a2 * a3 * over_9;
    const double f_6 = -4.0 * omega2_2 * a2 * a3 * over_9 / omega1;
    const double q_1 = (f_4 + f_5 + f_6) * per_1;
    const double q_2 = (f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_2;
    const double q_3 = (f_4 + f_5 + f_6) * per_3;
    const double q_6 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_6;
    const double q_7 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_7;
    gradient[0] = (-f_2 - 2.0 * f_3 + f_4 - f_6) / omega1 - 2.0 * q_1 - 2.0 * q_2 - q_3 - q_6 - 3.0 * q_7;
    gradient[1] = (-f_1 + f_3 + f_5 + 2.0 * f_6) / omega2 + q_1 - q_2 - 2.0 * q_3 - q_6 - q_7;  // by omega2
    const double c_0 = (12.0 * omega1_2 + 4.0 * omega1 * omega2
        + 2.0 * omega2_2) * over_8 / (3.0 * omega1_2 * omega2);
    const double c_1 = (18.0 * omega1_2 + 4.0 * omega1 * omega2 - 4.0 * omega2_2) * over_9 / omega1;
    const double c_2 = 3.0 * over_7;  // multiplies b2
    gradient[2] = a2 * c_0;  // by a1
    gradient[3] = a1 * c_0 + a3 * c_1;  // by a2
    gradient[4] = a2 * c_1;  // by a3
    gradient[7] = c_2;  // by b2
  }
  void lump_harmonic_re_x_A_x3([[maybe_unused]] double* gradient) const {
    const double f_0 = b1 / (8.0 * omega1_2);
    const double f_1 = a1_2 / (12.0 * omega1_4);
    const double f_2 = a2_2 * over_0 / (4.0 * omega1_2);
    const double q_1 = f_2 * per_1;
    const double q_2 = f_2 * per_2;
    gradient[0] = (-2.0 * f_0 - 4.0 * f_1 - 2.0 * f_2) / omega1 - 2.0 * q_1 - 2.0 * q_2;  // by omega1
    gradient[1] = q_1 - q_2;  // by omega2
    const double c_0 = 1.0 / (12.0 * omega1_4);  // multiplies a1^2
    const double c_1 = over_0 / (4.0 * omega1_2);  // multiplies a2^2
    const double c_2 = 1.0 / (8.0 * omega1_2);  // multiplies b1
    gradient[2] = 2.0 * a1 * c_0;  // by a1
    gradient[3] = 2.0 * a2 * c_1;  // by a2
    gradient[6] = c_2;  // by b1
  }
  void lump_a4([[maybe_unused]] double* gradient) const { gradient[5] = 1.0; }
  void lump_harmonic_re_y_A_y3([[maybe_unused]] double* gradient) const {
    const double f_0 = b5 / (8.0 * omega2_2);
    const double f_1 = a4_2 / (12.0 * omega2_4);
    const double f_2 = -a3_2 * over_1 / (4.0 * omega2_2);
    const double q_0 = f_2 * per_0;
    const double q_3 = f_2 * per_3;
    gradient[0] = -q_0 - q_3;  // by omega1
    gradient[1] = (-2.0 * f_0 - 4.0 * f_1 - 2.0 * f_2) / omega2 + 2.0 * q_0 - 2.0 * q_3;  // by omega2
    const double c_0 = -over_1 / (4.0 * omega2_2);  // multiplies a3^2
    const double c_1 = 1.0 / (12.0 * omega2_4);  // multiplies a4^2
    const double c_2 = 1.0 / (8.0 * omega2_2);  // multiplies b5
    gradient[4] = 2.0 * a3 * c_0;  // by a3
    gradient[5] = 2.0 * a4 * c_1;  // by a4
    gradient[10] = c_2;  // by b5
  }
  void lump_harmonic_re_y_A_x_A_y2([[maybe_unused]] double* gradient) const {
    const double f_0 = 3.0 * b4 * over_10;
    const double f_1 = 2.0 * omega1 * a3 * a4 * over_11 / (3.0 * omega2_2);
    const double f_2 = 4.0 * a3 * a4 * over_11 / (3.0 * omega2);
    const double f_3 = 4.0 * a3 * a4 * over_11 / omega1;
    const double f_4 = 4.0 * omega1_2 * a2 * a3 * over_12 / omega2;
    const double f_5 = -4.0 * omega1 * a2 * a3 * over_12;
    const double f_6 = -18.0 * omega2 * a2 * a3 * over_12;
    const double q_0 = (f_4 + f_5 + f_6) * per_0;
    const double q_2 = (f_4 + f_5 + f_6) * per_2;
    const double q_3 = (f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_3;
    const double q_4 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_4;
    const double q_6 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_6;
    gradient[0] = (f_1 - f_3 + 2.0 * f_4 + f_5) / omega1 - q_0 - 2.0 * q_2 - q_3 - q_4 - q_6;  // by omega1
    gradient[1] = (-2.0 * f_1 - f_2 - f_4 + f_6) / omega2 + 2.0 * q_0 - q_2 - 2.0 * q_3 - 3.0 * q_4 - q_6;
    const double c_0 = (4.0 * omega1_2 - 4.0 * omega1 * omega2 - 18.0 * omega2_2) * over_12 / omega2;
    const double c_1 = (2.0 * omega1_2 + 4.0 * omega1 * omega2
        + 12.0 * omega2_2) * over_11 / (3.0 * omega1 * omega2_2);
    const double c_2 = 3.0 * over_10;  // multiplies b4
    gradient[3] = a3 * c_0;  // by a2
    gradient[4] = a2 * c_0 + a4 * c_1;  // by a3
    gradient[5] = a3 * c_1;  // by a4
    gradient[9] = c_2;  // by b4
  }
  void lump_harmonic_re_y_A_x2_A_y([[maybe_unused]] double* gradient) const {
    const double f_0 = b3 * per_6 / (4.0 * omega1);
    const double f_1 = a1 * a3 * per_6 / (6.0 * omega1_3);
    const double f_2 = a3_2 * over_4 / omega1_2;
    const double f_3 = a2_2 * over_5 / (omega1 * omega2);
    const double f_4 = a2 * a4 * over_13 / (2.0 * omega1);
    const double q_1 = f_4 * per_1;
    const double q_2 = (f_3 + f_4) * per_2;
    const double q_3 = f_2 * per_3;
    const double q_6 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_6;
    gradient[0] = (-f_0 - 3.0 * f_1 - 2.0 * f_2 - f_3 - f_4) / omega1 - 2.0 * q_1 - 2.0 * q_2 - q_3 - q_6;
    gradient[1] = -f_3 / omega2 + q_1 - q_2 - 2.0 * q_3 - q_6;  // by omega2
    const double c_0 = per_6 / (6.0 * omega1_3);  // multiplies a1*a3
    const double c_1 = over_5 / (omega1 * omega2);  // multiplies a2^2
    const double c_2 = over_13 / (2.0 * omega1);  // multiplies a2*a4
    const double c_3 = over_4 / omega1_2;  // multiplies a3^2
    const double c_4 = per_6 / (4.0 * omega1);  // multiplies b3
    gradient[2] = a3 * c_0;  // by a1
    gradient[3] = 2.0 * a2 * c_1 + a4 * c_2;  // by a2
    gradient[4] = a1 * c_0 + 2.0 * a3 * c_3;  // by a3
    gradient[5] = a2 * c_2;  // by a4
    gradient[8] = c_4;  // by b3
  }
  void lump_harmonic_re_y_A_x3([[maybe_unused]] double* gradient) const {
    const double f_0 = b2 * over_14;
    const double f_1 = 2.0 * a1 * a2 * over_14 / (3.0 * omega1_2);
    const double f_2 = 2.0 * a2 * a3 * over_15;
    const double q_1 = f_2 * per_1;
    const double q_2 = f_2 * per_2;
    const double q_7 = (f_0 + f_1 + f_2) * per_7;
    const double q_8 = (f_0 + f_1 + f_2) * per_8;
    gradient[0] = -2.0 * f_1 / omega1 - 2.0 * q_1 - 2.0 * q_2 - 3.0 * q_7 - 3.0 * q_8;  // by omega1
    gradient[1] = q_1 - q_2 - q_7 + q_8;  // by omega2
    const double c_0 = 2.0 * over_14 / (3.0 * omega1_2);  // multiplies a1*a2
    const double c_1 = 2.0 * over_15;  // multiplies a2*a3
    const double c_2 = over_14;  // multiplies b2
    gradient[2] = a2 * c_0;  // by a1
    gradient[3] = a1 * c_0 + a3 * c_1;  // by a2
    gradient[4] = a2 * c_1;  // by a3
    gradient[7] = c_2;  // by b2
  }
  void lump_conservative_x_A_x([[maybe_unused]] double* gradient) const {
    gradient[0] = mu1_2 / (2.0 * omega1_2);  // by omega1
    gradient[11] = -mu1 / omega1;  // by mu1
  }
  void lump_conservative_x_A_x_A_y_conjA_y_of_one_to_two([[maybe_unused]] double* gradient) const {
    const double f_0 = b3 / omega1;
    const double f_1 = -2.0 * a2 * a4 / (omega1 * omega2_2);
    const double f_2 = (-4.0 * a1 * a3 + a2_2) / (2.0 * omega1_3);
    const double f_3 = 2.0 * a2_2 * per_2 / (omega1 * omega2);
    const double f_4 = 4.0 * a3_2 * over_1 / omega1;
    const double q_0 = f_4 * per_0;
    const double q_2 = f_3 * per_2;
    const double q_3 = f_4 * per_3;
    gradient[0] = (-f_0 - f_1 - 3.0 * f_2 - f_3 - f_4) / omega1 - q_0 - 2.0 * q_2 - q_3;  // by omega1
    gradient[1] = (-2.0 * f_1 - f_3) / omega2 + 2.0 * q_0 - q_2 - 2.0 * q_3;  // by omega2
    const double c_0 = -2.0 / omega1_3;  // multiplies a1*a3
    const double c_1 = 1.0 / (2.0 * omega1_3) + 2.0 * per_2 / (omega1 * omega2);  // multiplies a2^2
    const double c_2 = -2.0 / (omega1 * omega2_2);  // multiplies a2*a4
    const double c_3 = 4.0 * over_1 / omega1;  // multiplies a3^2
    const double c_4 = 1.0 / omega1;  // multiplies b3
    gradient[2] = a3 * c_0;  // by a1
    gradient[3] = 2.0 * a2 * c_1 + a4 * c_2;  // by a2
    gradient[4] = a1 * c_0 + 2.0 * a3 * c_3;  // by a3
    gradient[5] = a2 * c_2;  // by a4
    gradient[8] = c_4;  // by b3
  }
  void lump_conservative_x_A_x2_conjA_x_of_one_to_two([[maybe_unused]] double* gradient) const {
    gradient[0] = (-3.0 * omega1_2 * omega2_2 * b1 + 4.0 * omega1_2 * a2_2 + omega1 * omega2 * a2_2
        + 10.0 * omega2_2 * a1_2) / (2.0 * omega1_4 * omega2_2);
    gradient[1] = (16.0 * omega1 * a2_2 + omega2 * a2_2) / (4.0 * omega1_2 * omega2_3);  // by omega2
    gradient[2] = -10.0 * a1 / (3.0 * omega1_3);  // by a1
    gradient[3] = (-8.0 * omega1 * a2 - omega2 * a2) / (2.0 * omega1_2 * omega2_2);  // by a2
    gradient[6] = 3.0 / (2.0 * omega1);  // by b1
  }
  void lump_dissipative_x_A_y_conjA_x([[maybe_unused]] double* gradient) const {
    gradient[0] = -a2 * mu2 / omega1_3;  // by omega1
    gradient[3] = mu2 / (2.0 * omega1_2);  // by a2
    gradient[13] = a2 / (2.0 * omega1_2);  // by mu2
  }
  void lump_conservative_x_conjA_x_F([[maybe_unused]] double* gradient) const {
    const double f_0 = a2 * e2 / (8.0 * omega1_2 * omega2);
    const double f_1 = a1 * e1 * over_16 / (2.0 * omega1);
    const double q_6 = f_1 * per_6;
    const double q_9 = f_1 * per_9;
    gradient[0] = (-2.0 * f_0 - f_1) / omega1 - q_6 - q_9;  // by omega1
    gradient[1] = -f_0 / omega2 - q_6 + q_9;  // by omega2
    const double c_0 = over_16 / (2.0 * omega1);  // multiplies a1*e1
    const double c_1 = 1.0 / (8.0 * omega1_2 * omega2);  // multiplies a2*e2
    gradient[2] = e1 * c_0;  // by a1
    gradient[3] = e2 * c_1;  // by a2
    gradient[12] = a1 * c_0;  // by e1
    gradient[14] = a2 * c_1;  // by e2
  }
  void lump_dissipative_y_A_x2([[maybe_unused]] double* gradient) const {
    gradient[1] = (-2.0 * a2 * mu1 + a2 * mu2) / (2.0 * omega2_3);  // by omega2
    gradient[3] = (2.0 * mu1 - mu2) / (4.0 * omega2_2);  // by a2
    gradient[11] = a2 / (2.0 * omega2_2);  // by mu1
    gradient[13] = -a2 / (4.0 * omega2_2);  // by mu2
  }
  void lump_conservative_y_A_y([[maybe_unused]] double* gradient) const {
    gradient[1] = mu2_2 / (2.0 * omega2_2);  // by omega2
    gradient[13] = -mu2 / omega2;  // by mu2
  }
  void lump_conservative_y_A_x_A_y_conjA_x([[maybe_unused]] double* gradient) const {
    const double f_0 = b3 / omega2;
    const double f_1 = -2.0 * a2 * a4 / omega2_3;
    const double f_2 = -2.0 * a1 * a3 / (omega1_2 * omega2);
    const double f_3 = a2_2 * per_2 / omega2_2;
    const double f_4 = -a2_2 * per_2 / (2.0 * omega1 * omega2);
    const double f_5 = 4.0 * a3_2 * over_1 / omega2;
    const double q_0 = f_5 * per_0;
    const double q_2 = (f_3 + f_4) * per_2;
    const double q_3 = f_5 * per_3;
    gradient[0] = (-2.0 * f_2 - f_4) / omega1 - q_0 - 2.0 * q_2 - q_3;  // by omega1
    gradient[1] = (-f_0 - 3.0 * f_1 - f_2 - 2.0 * f_3 - f_4 - f_5) / omega2 + 2.0 * q_0 - q_2 - 2.0 * q_3;
    const double c_0 = -2.0 / (omega1_2 * omega2);  // multiplies a1*a3
    const double c_1 = (2.0 * omega1 - omega2) * per_2 / (2.0 * omega1 * omega2_2);  // multiplies a2^2
    const double c_2 = -2.0 / omega2_3;  // multiplies a2*a4
    const double c_3 = 4.0 * over_1 / omega2;  // multiplies a3^2
    const double c_4 = 1.0 / omega2;  // multiplies b3
    gradient[2] = a3 * c_0;  // by a1
    gradient[3] = 2.0 * a2 * c_1 + a4 * c_2;  // by a2
    gradient[4] = a1 * c_0 + 2.0 * a3 * c_3;  // by a3
    gradient[5] = a2 * c_2;  // by a4
    gradient[8] = c_4;  // by b3
  }
  void lump_dissipative_y_F([[maybe_unused]] double* gradient) const {
    gradient[1] = -mu2 * e2 / (4.0 * omega2_3);  // by omega2
    gradient[13] = e2 / (8.0 * omega2_2);  // by mu2
    gradient[14] = mu2 / (8.0 * omega2_2);  // by e2
  }
  void lump_harmonic_re_x_A_y_conjA_x2([[maybe_unused]] double* gradient) const {
    const double f_0 = 3.0 * b2 * over_17;
    const double f_1 = 2.0 * a1 * a2 * over_17 / (3.0 * omega1_2);
    const double f_2 = 4.0 * a2 * a3 * over_18 / omega1;
    const double q_0 = f_2 * per_0;
    const double q_8 = (f_0 + f_1 + f_2) * per_8;
    const double q_9 = (f_0 + f_1 + f_2) * per_9;
    gradient[0] = (-2.0 * f_1 - f_2) / omega1 - q_0 - 3.0 * q_8 - q_9;  // by omega1
    gradient[1] = 2.0 * q_0 + q_8 + q_9;  // by omega2
    const double c_0 = 2.0 * over_17 / (3.0 * omega1_2);  // multiplies a1*a2
    const double c_1 = 4.0 * over_18 / omega1;  // multiplies a2*a3
    const double c_2 = 3.0 * over_17;  // multiplies b2
    gradient[2] = a2 * c_0;  // by a1
    gradient[3] = a1 * c_0 + a3 * c_1;  // by a2
    gradient[4] = a2 * c_1;  // by a3
    gradient[7] = c_2;  // by b2
  }
  void lump_harmonic_re_x_conjA_y_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -a2 * e1 * over_16 / omega1_2;
    const double q_6 = f_0 * per_6;
    const double q_9 = f_0 * per_9;
    gradient[0] = -2.0 * f_0 / omega1 - q_6 - q_9;  // by omega1
    gradient[1] = -q_6 + q_9;  // by omega2
    const double c_0 = -over_16 / omega1_2;  // multiplies a2*e1
    gradient[3] = e1 * c_0;  // by a2
    gradient[12] = a2 * c_0;  // by e1
  }
  void lump_harmonic_im_x_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -omega2 * mu1 * e1 * over_19;
    const double q_6 = 2.0 * f_0 * per_6;
    const double q_9 = 2.0 * f_0 * per_9;
    gradient[0] = -q_6 - q_9;  // by omega1
    gradient[1] = f_0 / omega2 - q_6 + q_9;  // by omega2
    const double c_0 = -omega2 * over_19;  // multiplies mu1*e1
    gradient[11] = e1 * c_0;  // by mu1
    gradient[12] = mu1 * c_0;  // by e1
  }
  void lump_harmonic_re_x_A_y2_conjA_y([[maybe_unused]] double* gradient) const {
    const double f_0 = -3.0 * b4 * over_16;
    const double f_1 = 10.0 * a3 * a4 * over_16 / (3.0 * omega2_2);
    const double f_2 = 6.0 * a2 * a3 * over_20;
    const double f_3 = -16.0 * omega2_2 * a2 * a3 * over_20 / omega1_2;
    const double q_0 = (f_2 + f_3) * per_0;
    const double q_3 = (f_2 + f_3) * per_3;
    const double q_6 = (f_0 + f_1 + f_2 + f_3) * per_6;
    const double q_9 = (f_0 + f_1 + f_2 + f_3) * per_9;
    gradient[0] = -2.0 * f_3 / omega1 - q_0 - q_3 - q_6 - q_9;  // by omega1
    gradient[1] = (-2.0 * f_1 + 2.0 * f_3) / omega2 + 2.0 * q_0 - 2.0 * q_3 - q_6 + q_9;  // by omega2
    const double c_0 = (6.0 * omega1_2 - 16.0 * omega2_2) * over_20 / omega1_2;  // multiplies a2*a3
    const double c_1 = 10.0 * over_16 / (3.0 * omega2_2);  // multiplies a3*a4
    const double c_2 = -3.0 * over_16;  // multiplies b4
    gradient[3] = a3 * c_0;  // by a2
    gradient[4] = a2 * c_0 + a4 * c_1;  // by a3
    gradient[5] = a3 * c_1;  // by a4
    gradient[9] = c_2;  // by b4
  }
  void lump_harmonic_re_x_A_x_A_y_conjA_x([[maybe_unused]] double* gradient) const {
    const double f_0 = -6.0 * b2 * over_16;
    const double f_1 = -4.0 * a1 * a2 * over_21 / omega2;
    const double f_2 = 8.0 * a1 * a2 * over_21 / omega1;
    const double f_3 = 4.0 * omega2 * a1 * a2 * over_21 / omega1_2;
    const double f_4 = 4.0 * omega1_2 * a2 * a3 * over_20 / omega2_2;
    const double f_5 = -24.0 * a2 * a3 * over_20;
    const double q_0 = (f_4 + f_5) * per_0;
    const double q_2 = (f_1 + f_2 + f_3) * per_2;
    const double q_3 = (f_4 + f_5) * per_3;
    const double q_6 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_6;
    const double q_9 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_9;
    gradient[0] = (-f_2 - 2.0 * f_3 + 2.0 * f_4) / omega1 - q_0 - 2.0 * q_2 - q_3 - q_6 - q_9;  // by omega1
    gradient[1] = (-f_1 + f_3 - 2.0 * f_4) / omega2 + 2.0 * q_0 - q_2 - 2.0 * q_3 - q_6 + q_9;  // by omega2
    const double c_0 = (-4.0 * omega1_2 + 8.0 * omega1 * omega2 + 4.0 * omega2_2) * over_21 / (omega1_2 * omega2);
    const double c_1 = (4.0 * omega1_2 - 24.0 * omega2_2) * over_20 / omega2_2;  // multiplies a2*a3
    const double c_2 = -6.0 * over_16;  // multiplies b2
    gradient[2] = a2 * c_0;  // by a1
    gradient[3] = a1 * c_0 + a3 * c_1;  // by a2
    gradient[4] = a2 * c_1;  // by a3
    gradient[7] = c_2;  // by b2
  }
  void lump_harmonic_im_x_A_x2([[maybe_unused]] double* gradient) const {
    gradient[0] = 4.0 * a1 * mu1 / (3.0 * omega1_4);  // by omega1
    gradient[2] = -4.0 * mu1 / (9.0 * omega1_3);  // by a1
    gradient[11] = -4.0 * a1 / (9.0 * omega1_3);  // by mu1
  }
  void lump_harmonic_re_x_A_x2_A_y_of_one_to_two([[maybe_unused]] double* gradient) const {
    const double f_0 = -4.0 * a2 * a3 * over_22;
    const double q_0 = 2.0 * f_0 * per_0;
    const double q_3 = 2.0 * f_0 * per_3;
    gradient[0] = -q_0 - q_3;  // by omega1
    gradient[1] = 2.0 * q_0 - 2.0 * q_3;  // by omega2
    const double c_0 = -4.0 * over_22;  // multiplies a2*a3
    gradient[3] = a3 * c_0;  // by a2
    gradient[4] = a2 * c_0;  // by a3
  }
  void lump_harmonic_im_x_A_y2([[maybe_unused]] double* gradient) const {
    const double f_0 = (4.0 * omega2 * a3 * mu1 - 8.0 * omega2 * a3 * mu2) * over_22;
    const double q_0 = 2.0 * f_0 * per_0;
    const double q_3 = 2.0 * f_0 * per_3;
    gradient[0] = -q_0 - q_3;  // by omega1
    gradient[1] = f_0 / omega2 + 2.0 * q_0 - 2.0 * q_3;  // by omega2
    const double c_0 = 4.0 * omega2 * over_22;  // multiplies a3*mu1
    const double c_1 = -8.0 * omega2 * over_22;  // multiplies a3*mu2
    gradient[4] = mu1 * c_0 + mu2 * c_1;  // by a3
    gradient[11] = a3 * c_0;  // by mu1
    gradient[13] = a3 * c_1;  // by mu2
  }
  void lump_harmonic_re_x_A_y_F([[maybe_unused]] double* gradient) const {
    const double f_0 = 2.0 * a3 * e2 * over_22;
    const double q_0 = 2.0 * f_0 * per_0;
    const double q_3 = 2.0 * f_0 * per_3;
    gradient[0] = -q_0 - q_3;  // by omega1
    gradient[1] = 2.0 * q_0 - 2.0 * q_3;  // by omega2
    const double c_0 = 2.0 * over_22;  // multiplies a3*e2
    gradient[4] = e2 * c_0;  // by a3
    gradient[14] = a3 * c_0;  // by e2
  }
  void lump_harmonic_re_x_A_y2_conjA_x([[maybe_unused]] double* gradient) const {
    const double f_0 = -b3 * per_9 / (4.0 * omega2);
    const double f_1 = -a2 * a4 * per_9 / (6.0 * omega2_3);
    const double f_2 = -a3_2 * over_23 / (omega1 * omega2);
    const double f_3 = a1 * a3 * over_24 / (2.0 * omega2);
    const double q_0 = (f_2 + f_3) * per_0;
    const double q_3 = f_3 * per_3;
    const double q_9 = (f_0 + f_1 + f_2 + f_3) * per_9;
    gradient[0] = -f_2 / omega1 - q_0 - q_3 - q_9;  // by omega1
    gradient[1] = (-f_0 - 3.0 * f_1 - f_2 - f_3) / omega2 + 2.0 * q_0 - 2.0 * q_3 + q_9;  // by omega2
    const double c_0 = over_24 / (2.0 * omega2);  // multiplies a1*a3
    const double c_1 = -per_9 / (6.0 * omega2_3);  // multiplies a2*a4
    const double c_2 = -over_23 / (omega1 * omega2);  // multiplies a3^2
    const double c_3 = -per_9 / (4.0 * omega2);  // multiplies b3
    gradient[2] = a3 * c_0;  // by a1
    gradient[3] = a4 * c_1;  // by a2
    gradient[4] = a1 * c_0 + 2.0 * a3 * c_2;  // by a3
    gradient[5] = a2 * c_1;  // by a4
    gradient[8] = c_3;  // by b3
  }
  void lump_harmonic_re_x_A_x_F([[maybe_unused]] double* gradient) const {
    const double f_0 = a1 * e1 * over_21 / omega2;
    const double q_2 = f_0 * per_2;
    const double q_6 = f_0 * per_6;
    const double q_9 = f_0 * per_9;
    gradient[0] = -2.0 * q_2 - q_6 - q_9;  // by omega1
    gradient[1] = -f_0 / omega2 - q_2 - q_6 + q_9;  // by omega2
    const double c_0 = over_21 / omega2;  // multiplies a1*e1
    gradient[2] = e1 * c_0;  // by a1
    gradient[12] = a1 * c_0;  // by e1
  }
  void lump_harmonic_re_x_A_x3_of_one_to_two([[maybe_unused]] double* gradient) const {
    const double f_0 = -2.0 * omega1 * a2_2 * per_2_2 / omega2_3;
    const double f_1 = -2.0 * a2_2 * per_2_2 / omega2_2;
    const double q_2 = (2.0 * f_0 + 2.0 * f_1) * per_2;
    gradient[0] = f_0 / omega1 - 2.0 * q_2;  // by omega1
    gradient[1] = (-3.0 * f_0 - 2.0 * f_1) / omega2 - q_2;  // by omega2
    const double c_0 = (-2.0 * omega1 - 2.0 * omega2) * per_2_2 / omega2_3;  // multiplies a2^2
    gradient[3] = 2.0 * a2 * c_0;  // by a2
  }
  void lump_harmonic_im_y_A_y_conjA_x([[maybe_unused]] double* gradient) const {
    const double f_0 = 4.0 * a3 * mu1 * per_0_2 / omega1;
    const double f_1 = -4.0 * omega2 * a3 * mu1 * per_0_2 / omega1_2;
    const double q_0 = (2.0 * f_0 + 2.0 * f_1) * per_0;
    gradient[0] = (-f_0 - 2.0 * f_1) / omega1 - q_0;  // by omega1
    gradient[1] = f_1 / omega2 + 2.0 * q_0;  // by omega2
    const double c_0 = (4.0 * omega1 - 4.0 * omega2) * per_0_2 / omega1_2;  // multiplies a3*mu1
    gradient[4] = mu1 * c_0;  // by a3
    gradient[11] = a3 * c_0;  // by mu1
  }
  void lump_harmonic_re_y_A_x_A_y_conjA_y([[maybe_unused]] double* gradient) const {
    const double f_0 = 6.0 * b4 * over_16;
    const double f_1 = 4.0 * a2 * a3 * over_21 / omega2;
    const double f_2 = -8.0 * a2 * a3 * over_21 / omega1;
    const double f_3 = -4.0 * omega2 * a2 * a3 * over_21 / omega1_2;
    const double f_4 = -4.0 * omega1_2 * a3 * a4 * over_20 / omega2_2;
    const double f_5 = 24.0 * a3 * a4 * over_20;
    const double q_0 = (f_4 + f_5) * per_0;
    const double q_2 = (f_1 + f_2 + f_3) * per_2;
    const double q_3 = (f_4 + f_5) * per_3;
    const double q_6 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_6;
    const double q_9 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5) * per_9;
    gradient[0] = (-f_2 - 2.0 * f_3 + 2.0 * f_4) / omega1 - q_0 - 2.0 * q_2 - q_3 - q_6 - q_9;  // by omega1
    gradient[1] = (-f_1 + f_3 - 2.0 * f_4) / omega2 + 2.0 * q_0 - q_2 - 2.0 * q_3 - q_6 + q_9;  // by omega2
    const double c_0 = (4.0 * omega1_2 - 8.0 * omega1 * omega2 - 4.0 * omega2_2) * over_21 / (omega1_2 * omega2);
    const double c_1 = (-4.0 * omega1_2 + 24.0 * omega2_2) * over_20 / omega2_2;  // multiplies a3*a4
    const double c_2 = 6.0 * over_16;  // multiplies b4
    gradient[3] = a3 * c_0;  // by a2
    gradient[4] = a2 * c_0 + a4 * c_1;  // by a3
    gradient[5] = a3 * c_1;  // by a4
    gradient[9] = c_2;  // by b4
  }
  void lump_harmonic_re_y_A_x2_conjA_x([[maybe_unused]] double* gradient) const {
    const double f_0 = 3.0 * b2 * over_16;
    const double f_1 = -4.0 * a2 * a3 * over_16 / omega2_2;
    const double f_2 = -10.0 * a1 * a2 * over_16 / (3.0 * omega1_2);
    const double q_6 = (f_0 + f_1 + f_2) * per_6;
    const double q_9 = (f_0 + f_1 + f_2) * per_9;
    gradient[0] = -2.0 * f_2 / omega1 - q_6 - q_9;  // by omega1
    gradient[1] = -2.0 * f_1 / omega2 - q_6 + q_9;  // by omega2
    const double c_0 = -10.0 * over_16 / (3.0 * omega1_2);  // multiplies a1*a2
    const double c_1 = -4.0 * over_16 / omega2_2;  // multiplies a2*a3
    const double c_2 = 3.0 * over_16;  // multiplies b2
    gradient[2] = a2 * c_0;  // by a1
    gradient[3] = a1 * c_0 + a3 * c_1;  // by a2
    gradient[4] = a2 * c_1;  // by a3
    gradient[7] = c_2;  // by b2
  }
  void lump_harmonic_re_y_A_y_conjA_x2([[maybe_unused]] double* gradient) const {
    const double f_0 = b3 * per_9 / (4.0 * omega1);
    const double f_1 = a1 * a3 * per_9 / (6.0 * omega1_3);
    const double f_2 = a3_2 * over_23 / omega1_2;
    const double q_0 = f_2 * per_0;
    const double q_9 = (f_0 + f_1 + f_2) * per_9;
    gradient[0] = (-f_0 - 3.0 * f_1 - 2.0 * f_2) / omega1 - q_0 - q_9;  // by omega1
    gradient[1] = 2.0 * q_0 + q_9;  // by omega2
    const double c_0 = per_9 / (6.0 * omega1_3);  // multiplies a1*a3
    const double c_1 = over_23 / omega1_2;  // multiplies a3^2
    const double c_2 = per_9 / (4.0 * omega1);  // multiplies b3
    gradient[2] = a3 * c_0;  // by a1
    gradient[4] = a1 * c_0 + 2.0 * a3 * c_1;  // by a3
    gradient[8] = c_2;  // by b3
  }
  void lump_harmonic_re_y_conjA_y_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -a3 * e1 * over_16 / omega2_2;
    const double q_6 = f_0 * per_6;
    const double q_9 = f_0 * per_9;
    gradient[0] = -q_6 - q_9;  // by omega1
    gradient[1] = -2.0 * f_0 / omega2 - q_6 + q_9;  // by omega2
    const double c_0 = -over_16 / omega2_2;  // multiplies a3*e1
    gradient[4] = e1 * c_0;  // by a3
    gradient[12] = a3 * c_0;  // by e1
  }
  void lump_harmonic_re_y_A_x2_A_y_of_one_to_two([[maybe_unused]] double* gradient) const {
    gradient[1] = 16.0 * a2 * a4 / (9.0 * omega2_5);  // by omega2
    gradient[3] = -4.0 * a4 / (9.0 * omega2_4);  // by a2
    gradient[5] = -4.0 * a2 / (9.0 * omega2_4);  // by a4
  }
  void lump_harmonic_im_y_A_y2([[maybe_unused]] double* gradient) const {
    gradient[1] = 4.0 * a4 * mu2 / (3.0 * omega2_4);  // by omega2
    gradient[5] = -4.0 * mu2 / (9.0 * omega2_3);  // by a4
    gradient[13] = -4.0 * a4 / (9.0 * omega2_3);  // by mu2
  }
  void lump_harmonic_re_y_A_y_F([[maybe_unused]] double* gradient) const {
    gradient[1] = -8.0 * a4 * e2 / (9.0 * omega2_5);  // by omega2
    gradient[5] = 2.0 * e2 / (9.0 * omega2_4);  // by a4
    gradient[14] = 2.0 * a4 / (9.0 * omega2_4);  // by e2
  }
  void lump_harmonic_re_y_A_y2_conjA_x([[maybe_unused]] double* gradient) const {
    const double f_0 = 3.0 * b4 * over_25;
    const double f_1 = 2.0 * omega1 * a3 * a4 * over_26 / (3.0 * omega2_2);
    const double f_2 = -4.0 * a3 * a4 * over_26 / (3.0 * omega2);
    const double f_3 = 4.0 * a3 * a4 * over_26 / omega1;
    const double f_4 = -2.0 * a2 * a3 * over_27;
    const double q_0 = (f_1 + f_2 + f_3 + f_4) * per_0;
    const double q_3 = f_4 * per_3;
    const double q_5 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_5;
    const double q_9 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_9;
    gradient[0] = (f_1 - f_3) / omega1 - q_0 - q_3 - q_5 - q_9;  // by omega1
    gradient[1] = (-2.0 * f_1 - f_2) / omega2 + 2.0 * q_0 - 2.0 * q_3 + 3.0 * q_5 + q_9;  // by omega2
    const double c_0 = -2.0 * over_27;  // multiplies a2*a3
    const double c_1 = (2.0 * omega1_2 - 4.0 * omega1 * omega2
        + 12.0 * omega2_2) * over_26 / (3.0 * omega1 * omega2_2);
    const double c_2 = 3.0 * over_25;  // multiplies b4
    gradient[3] = a3 * c_0;  // by a2
    gradient[4] = a2 * c_0 + a4 * c_1;  // by a3
    gradient[5] = a3 * c_1;  // by a4
    gradient[9] = c_2;  // by b4
  }
  void lump_harmonic_re_y_A_x3_of_one_to_two([[maybe_unused]] double* gradient) const {
    const double f_0 = b2 * over_14;
    const double f_1 = 2.0 * a1 * a2 * over_14 / (3.0 * omega1_2);
    const double q_7 = (f_0 + f_1) * per_7;
    const double q_8 = (f_0 + f_1) * per_8;
    gradient[0] = -2.0 * f_1 / omega1 - 3.0 * q_7 - 3.0 * q_8;  // by omega1
    gradient[1] = -q_7 + q_8;  // by omega2
    const double c_0 = 2.0 * over_14 / (3.0 * omega1_2);  // multiplies a1*a2
    const double c_1 = over_14;  // multiplies b2
    gradient[2] = a2 * c_0;  // by a1
    gradient[3] = a1 * c_0;  // by a2
    gradient[7] = c_1;  // by b2
  }
  void lump_conservative_x_A_y_conjA_x2([[maybe_unused]] double* gradient) const {
    const double f_0 = 3.0 * b2 / (2.0 * omega1);
    const double f_1 = a1 * a2 / (3.0 * omega1_3);
    const double f_2 = 2.0 * a2 * a3 * per_0 / omega1_2;
    const double f_3 = -2.0 * a1 * a2 * per_1 / (omega1 * omega2);
    const double f_4 = a2 * a3 * over_0 / omega1;
    const double q_0 = f_2 * per_0;
    const double q_1 = (f_3 + f_4) * per_1;
    const double q_2 = f_4 * per_2;
    gradient[0] = (-f_0 - 3.0 * f_1 - 2.0 * f_2 - f_3 - f_4) / omega1 - q_0 - 2.0 * q_1 - 2.0 * q_2;  // by omega1
    gradient[1] = -f_3 / omega2 + 2.0 * q_0 + q_1 - q_2;  // by omega2
    const double c_0 = 1.0 / (3.0 * omega1_3) - 2.0 * per_1 / (omega1 * omega2);  // multiplies a1*a2
    const double c_1 = 2.0 * per_0 / omega1_2 + over_0 / omega1;  // multiplies a2*a3
    const double c_2 = 3.0 / (2.0 * omega1);  // multiplies b2
    gradient[2] = a2 * c_0;  // by a1
    gradient[3] = a1 * c_0 + a3 * c_1;  // by a2
    gradient[4] = a2 * c_1;  // by a3
    gradient[7] = c_2;  // by b2
  }
  void lump_conservative_y_A_x3([[maybe_unused]] double* gradient) const {
    const double f_0 = b2 / (2.0 * omega2);
    const double f_1 = a1 * a2 / (3.0 * omega1_2 * omega2);
    const double f_2 = a2 * a3 * over_0 / omega2;
    const double q_1 = f_2 * per_1;
    const double q_2 = f_2 * per_2;
    gradient[0] = -2.0 * f_1 / omega1 - 2.0 * q_1 - 2.0 * q_2;  // by omega1
    gradient[1] = (-f_0 - f_1 - f_2) / omega2 + q_1 - q_2;  // by omega2
    const double c_0 = 1.0 / (3.0 * omega1_2 * omega2);  // multiplies a1*a2
    const double c_1 = over_0 / omega2;  // multiplies a2*a3
    const double c_2 = 1.0 / (2.0 * omega2);  // multiplies b2
    gradient[2] = a2 * c_0;  // by a1
    gradient[3] = a1 * c_0 + a3 * c_1;  // by a2
    gradient[4] = a2 * c_1;  // by a3
    gradient[7] = c_2;  // by b2
  }
  void lump_harmonic_re_x_A_y2_conjA_x_of_one_to_three([[maybe_unused]] double* gradient) const {
    const double f_0 = -b3 * per_9 / (4.0 * omega2);
    const double f_1 = -a2 * a4 * per_9 / (6.0 * omega2_3);
    const double f_2 = -a3_2 * over_23 / (omega1 * omega2);
    const double f_3 = a2_2 * over_28 / omega2_2;
    const double f_4 = a1 * a3 * over_24 / (2.0 * omega2);
    const double q_0 = (f_2 + f_4) * per_0;
    const double q_1 = f_3 * per_1;
    const double q_3 = f_4 * per_3;
    const double q_9 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_9;
    gradient[0] = -f_2 / omega1 - q_0 - 2.0 * q_1 - q_3 - q_9;  // by omega1
    gradient[1] = (-f_0 - 3.0 * f_1 - f_2 - 2.0 * f_3 - f_4) / omega2 + 2.0 * q_0 + q_1 - 2.0 * q_3 + q_9;
    const double c_0 = over_24 / (2.0 * omega2);  // multiplies a1*a3
    const double c_1 = over_28 / omega2_2;  // multiplies a2^2
    const double c_2 = -per_9 / (6.0 * omega2_3);  // multiplies a2*a4
    const double c_3 = -over_23 / (omega1 * omega2);  // multiplies a3^2
    const double c_4 = -per_9 / (4.0 * omega2);  // multiplies b3
    gradient[2] = a3 * c_0;  // by a1
    gradient[3] = 2.0 * a2 * c_1 + a4 * c_2;  // by a2
    gradient[4] = a1 * c_0 + 2.0 * a3 * c_3;  // by a3
    gradient[5] = a2 * c_2;  // by a4
    gradient[8] = c_4;  // by b3
  }
  void lump_harmonic_re_x_A_x_A_y_conjA_x_of_one_to_three([[maybe_unused]] double* gradient) const {
    const double f_0 = -6.0 * b2 * over_16;
    const double f_1 = 4.0 * omega1_2 * a2 * a3 * over_20 / omega2_2;
    const double f_2 = -24.0 * a2 * a3 * over_20;
    const double f_3 = 24.0 * a1 * a2 * over_29;
    const double f_4 = -4.0 * omega2_2 * a1 * a2 * over_29 / omega1_2;
    const double q_0 = (f_1 + f_2) * per_0;
    const double q_1 = (f_3 + f_4) * per_1;
    const double q_2 = (f_3 + f_4) * per_2;
    const double q_3 = (f_1 + f_2) * per_3;
    const double q_6 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_6;
    const double q_9 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_9;
    gradient[0] = (2.0 * f_1 - 2.0 * f_4) / omega1 - q_0 - 2.0 * q_1 - 2.0 * q_2 - q_3 - q_6 - q_9;  // by omega1
    gradient[1] = (-2.0 * f_1 + 2.0 * f_4) / omega2 + 2.0 * q_0 + q_1 - q_2 - 2.0 * q_3 - q_6 + q_9;  // by omega2
    const double c_0 = (24.0 * omega1_2 - 4.0 * omega2_2) * over_29 / omega1_2;  // multiplies a1*a2
    const double c_1 = (4.0 * omega1_2 - 24.0 * omega2_2) * over_20 / omega2_2;  // multiplies a2*a3
    const double c_2 = -6.0 * over_16;  // multiplies b2
    gradient[2] = a2 * c_0;  // by a1
    gradient[3] = a1 * c_0 + a3 * c_1;  // by a2
    gradient[4] = a2 * c_1;  // by a3
    gradient[7] = c_2;  // by b2
  }
  void lump_harmonic_re_y_A_y_conjA_x2_of_one_to_three([[maybe_unused]] double* gradient) const {
    const double f_0 = b3 * per_9 / (4.0 * omega1);
    const double f_1 = a1 * a3 * per_9 / (6.0 * omega1_3);
    const double f_2 = a3_2 * over_23 / omega1_2;
    const double f_3 = -a2_2 * over_28 / (omega1 * omega2);
    const double f_4 = a2 * a4 * over_30 / (2.0 * omega1);
    const double q_0 = f_2 * per_0;
    const double q_1 = (f_3 + f_4) * per_1;
    const double q_2 = f_4 * per_2;
    const double q_9 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_9;
    gradient[0] = (-f_0 - 3.0 * f_1 - 2.0 * f_2 - f_3 - f_4) / omega1 - q_0 - 2.0 * q_1 - 2.0 * q_2 - q_9;
    gradient[1] = -f_3 / omega2 + 2.0 * q_0 + q_1 - q_2 + q_9;  // by omega2
    const double c_0 = per_9 / (6.0 * omega1_3);  // multiplies a1*a3
    const double c_1 = -over_28 / (omega1 * omega2);  // multiplies a2^2
    const double c_2 = over_30 / (2.0 * omega1);  // multiplies a2*a4
    const double c_3 = over_23 / omega1_2;  // multiplies a3^2
    const double c_4 = per_9 / (4.0 * omega1);  // multiplies b3
    gradient[2] = a3 * c_0;  // by a1
    gradient[3] = 2.0 * a2 * c_1 + a4 * c_2;  // by a2
    gradient[4] = a1 * c_0 + 2.0 * a3 * c_3;  // by a3
    gradient[5] = a2 * c_2;  // by a4
    gradient[8] = c_4;  // by b3
  }
  void lump_harmonic_re_y_A_x_A_y_conjA_y_of_one_to_three([[maybe_unused]] double* gradient) const {
    const double f_0 = 6.0 * b4 * over_16;
    const double f_1 = -4.0 * omega1_2 * a3 * a4 * over_20 / omega2_2;
    const double f_2 = 24.0 * a3 * a4 * over_20;
    const double f_3 = -24.0 * a2 * a3 * over_29;
    const double f_4 = 4.0 * omega2_2 * a2 * a3 * over_29 / omega1_2;
    const double q_0 = (f_1 + f_2) * per_0;
    const double q_1 = (f_3 + f_4) * per_1;
    const double q_2 = (f_3 + f_4) * per_2;
    const double q_3 = (f_1 + f_2) * per_3;
    const double q_6 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_6;
    const double q_9 = (f_0 + f_1 + f_2 + f_3 + f_4) * per_9;
    gradient[0] = (2.0 * f_1 - 2.0 * f_4) / omega1 - q_0 - 2.0 * q_1 - 2.0 * q_2 - q_3 - q_6 - q_9;  // by omega1
    gradient[1] = (-2.0 * f_1 + 2.0 * f_4) / omega2 + 2.0 * q_0 + q_1 - q_2 - 2.0 * q_3 - q_6 + q_9;  // by omega2
    const double c_0 = (-24.0 * omega1_2 + 4.0 * omega2_2) * over_29 / omega1_2;  // multiplies a2*a3
    const double c_1 = (-4.0 * omega1_2 + 24.0 * omega2_2) * over_20 / omega2_2;  // multiplies a3*a4
    const double c_2 = 6.0 * over_16;  // multiplies b4
    gradient[3] = a3 * c_0;  // by a2
    gradient[4] = a2 * c_0 + a4 * c_1;  // by a3
    gradient[5] = a3 * c_1;  // by a4
    gradient[9] = c_2;  // by b4
  }
  void lump_harmonic_re_y_A_x2_conjA_x_of_one_to_three([[maybe_unused]] double* gradient) const {
    const double f_0 = 3.0 * b2 * over_16;
    const double f_1 = -10.0 * a1 * a2 * over_16 / (3.0 * omega1_2);
    const double f_2 = -16.0 * omega1_2 * a2 * a3 * over_29 / omega2_2;
    const double f_3 = 6.0 * a2 * a3 * over_29;
    const double q_1 = (f_2 + f_3) * per_1;
    const double q_2 = (f_2 + f_3) * per_2;
    const double q_6 = (f_0 + f_1 + f_2 + f_3) * per_6;
    const double q_9 = (f_0 + f_1 + f_2 + f_3) * per_9;
    gradient[0] = (-2.0 * f_1 + 2.0 * f_2) / omega1 - 2.0 * q_1 - 2.0 * q_2 - q_6 - q_9;  // by omega1
    gradient[1] = -2.0 * f_2 / omega2 + q_1 - q_2 - q_6 + q_9;  // by omega2
    const double c_0 = -10.0 * over_16 / (3.0 * omega1_2);  // multiplies a1*a2
    const double c_1 = (-16.0 * omega1_2 + 6.0 * omega2_2) * over_29 / omega2_2;  // multiplies a2*a3
    const double c_2 = 3.0 * over_16;  // multiplies b2
    gradient[2] = a2 * c_0;  // by a1
    gradient[3] = a1 * c_0 + a3 * c_1;  // by a2
    gradient[4] = a2 * c_1;  // by a3
    gradient[7] = c_2;  // by b2
  }
  void lump_harmonic_re_y_A_y2_conjA_x_of_one_to_three([[maybe_unused]] double* gradient) const {
    const double f_0 = 3.0 * b4 * over_25;
    const double f_1 = 2.0 * omega1 * a3 * a4 * over_26 / (3.0 * omega2_2);
    const double f_2 = -4.0 * a3 * a4 * over_26 / (3.0 * omega2);
    const double f_3 = 4.0 * a3 * a4 * over_26 / omega1;
    const double f_4 = -4.0 * omega1_2 * a2 * a3 * over_31 / omega2;
    const double f_5 = -4.0 * omega1 * a2 * a3 * over_31;
    const double f_6 = 18.0 * omega2 * a2 * a3 * over_31;
    const double q_0 = (f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_0;
    const double q_1 = (f_4 + f_5 + f_6) * per_1;
    const double q_3 = (f_4 + f_5 + f_6) * per_3;
    const double q_5 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_5;
    const double q_9 = (f_0 + f_1 + f_2 + f_3 + f_4 + f_5 + f_6) * per_9;
    gradient[0] = (f_1 - f_3 + 2.0 * f_4 + f_5) / omega1 - q_0 - 2.0 * q_1 - q_3 - q_5 - q_9;  // by omega1
    gradient[1] = (-2.0 * f_1 - f_2 - f_4 + f_6) / omega2 + 2.0 * q_0 + q_1 - 2.0 * q_3 + 3.0 * q_5 + q_9;
    const double c_0 = (-4.0 * omega1_2 - 4.0 * omega1 * omega2 + 18.0 * omega2_2) * over_31 / omega2;
    const double c_1 = (2.0 * omega1_2 - 4.0 * omega1 * omega2
        + 12.0 * omega2_2) * over_26 / (3.0 * omega1 * omega2_2);
    const double c_2 = 3.0 * over_25;  // multiplies b4
    gradient[3] = a3 * c_0;  // by a2
    gradient[4] = a2 * c_0 + a4 * c_1;  // by a3
    gradient[5] = a3 * c_1;  // by a4
    gradient[9] = c_2;  // by b4
  }

  using Gradient = void (LumpGradients::*)(double*) const;
  static constexpr Gradient gradients[] = {&LumpGradients::lump_conservative_x_A_x2_conjA_y,
      &LumpGradients::lump_mu1, &LumpGradients::lump_conservative_x_A_x_A_y_conjA_y,
      &LumpGradients::lump_conservative_x_A_x2_conjA_x, &LumpGradients::lump_e1,
      &LumpGradients::lump_conservative_x_A_y2_conjA_y, &LumpGradients::lump_conservative_x_A_x_A_y_conjA_x,
      &LumpGradients::lump_conservative_x_A_y2_conjA_x, &LumpGradients::lump_conservative_y_A_x2_conjA_y,
      &LumpGradients::lump_conservative_y_A_x_A_y_conjA_y, &LumpGradients::lump_conservative_y_A_x2_conjA_x,
      &LumpGradients::lump_e2, &LumpGradients::lump_mu2, &LumpGradients::lump_conservative_y_A_y2_conjA_y,
      &LumpGradients::lump_conservative_y_A_y2_conjA_x, &LumpGradients::lump_a2, &LumpGradients::lump_a3,
      &LumpGradients::lump_a1, &LumpGradients::lump_harmonic_re_x_A_y3, &LumpGradients::lump_harmonic_re_x_A_x_A_y2,
      &LumpGradients::lump_harmonic_re_x_A_x2_A_y, &LumpGradients::lump_harmonic_re_x_A_x3, &LumpGradients::lump_a4,
      &LumpGradients::lump_harmonic_re_y_A_y3, &LumpGradients::lump_harmonic_re_y_A_x_A_y2,
      &LumpGradients::lump_harmonic_re_y_A_x2_A_y, &LumpGradients::lump_harmonic_re_y_A_x3,
      &LumpGradients::lump_conservative_x_A_x, &LumpGradients::lump_conservative_x_A_x_A_y_conjA_y_of_one_to_two,
      &LumpGradients::lump_conservative_x_A_x2_conjA_x_of_one_to_two,
      &LumpGradients::lump_dissipative_x_A_y_conjA_x, &LumpGradients::lump_conservative_x_conjA_x_F,
      &LumpGradients::lump_dissipative_y_A_x2, &LumpGradients::lump_conservative_y_A_y,
      &LumpGradients::lump_conservative_y_A_x_A_y_conjA_x, &LumpGradients::lump_dissipative_y_F,
      &LumpGradients::lump_harmonic_re_x_A_y_conjA_x2, &LumpGradients::lump_harmonic_re_x_conjA_y_F,
      &LumpGradients::lump_harmonic_im_x_F, &LumpGradients::lump_harmonic_re_x_A_y2_conjA_y,
      &LumpGradients::lump_harmonic_re_x_A_x_A_y_conjA_x, &LumpGradients::lump_harmonic_im_x_A_x2,
      &LumpGradients::lump_harmonic_re_x_A_x2_A_y_of_one_to_two, &LumpGradients::lump_harmonic_im_x_A_y2,
      &LumpGradients::lump_harmonic_re_x_A_y_F, &LumpGradients::lump_harmonic_re_x_A_y2_conjA_x,
      &LumpGradients::lump_harmonic_re_x_A_x_F, &LumpGradients::lump_harmonic_re_x_A_x3_of_one_to_two,
      &LumpGradients::lump_harmonic_im_y_A_y_conjA_x, &LumpGradients::lump_harmonic_re_y_A_x_A_y_conjA_y,
      &LumpGradients::lump_harmonic_re_y_A_x2_conjA_x, &LumpGradients::lump_harmonic_re_y_A_y_conjA_x2,
      &LumpGradients::lump_harmonic_re_y_conjA_y_F, &LumpGradients::lump_harmonic_re_y_A_x2_A_y_of_one_to_two,
      &LumpGradients::lump_harmonic_im_y_A_y2, &LumpGradients::lump_harmonic_re_y_A_y_F,
      &LumpGradients::lump_harmonic_re_y_A_y2_conjA_x, &LumpGradients::lump_harmonic_re_y_A_x3_of_one_to_two,
      &LumpGradients::lump_conservative_x_A_y_conjA_x2, &LumpGradients::lump_conservative_y_A_x3,
      &LumpGradients::lump_harmonic_re_x_A_y2_conjA_x_of_one_to_three,
      &LumpGradients::lump_harmonic_re_x_A_x_A_y_conjA_x_of_one_to_three,
      &LumpGradients::lump_harmonic_re_y_A_y_conjA_x2_of_one_to_three,
      &LumpGradients::lump_harmonic_re_y_A_x_A_y_conjA_y_of_one_to_three,
      &LumpGradients::lump_harmonic_re_y_A_x2_conjA_x_of_one_to_three,
      &LumpGradients::lump_harmonic_re_y_A_y2_conjA_x_of_one_to_three};
};

inline constexpr LumpFunctions lump_functions = {lump_values<Lumps>, lump_jacobian<LumpGradients, 15>};

}  // namespace secular::generated::internal_resonance
