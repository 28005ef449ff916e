// Model parametric_pair: generated code, never edited by hand.
// Holds derivatives of the lumps by the parameters. Made by: secular generate parametric_pair.
#pragma once

#include "parametric_pair.hpp"

namespace secular::generated::parametric_pair {

/// gradient[p] = derivative of a lump by parameters[p], entries that are not zero. Of lumps with small divisors:
/// f_n are the fractions whose sum the lump is, q_d those of divisor d times its power and inverse, c_n what
/// multiplies a product of coefficients.
struct LumpGradients : Lumps {
  using Lumps::Lumps;

  void lump_mu1([[maybe_unused]] double* gradient) const { gradient[2] = 1.0; }
  void lump_b3([[maybe_unused]] double* gradient) const { gradient[4] = 1.0; }
  void lump_b1([[maybe_unused]] double* gradient) const { gradient[3] = 1.0; }
  void lump_p([[maybe_unused]] double* gradient) const { gradient[5] = 1.0; }
  void lump_mu2([[maybe_unused]] double* gradient) const { gradient[6] = 1.0; }
  void lump_b5([[maybe_unused]] double* gradient) const { gradient[7] = 1.0; }
  void lump_q([[maybe_unused]] double* gradient) const { gradient[8] = 1.0; }
  void lump_conservative_x_A_x2_A_y_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -b3 * q / (8.0 * omega1_2 * omega2);
    const double f_1 = -3.0 * b1 * p / (16.0 * omega1_3);
    const double f_2 = -b3 * p * per_0 / (16.0 * omega1_2);
    const double q_0 = f_2 * per_0;
    gradient[0] = (-2.0 * f_0 - 3.0 * f_1 - 2.0 * f_2) / omega1 - q_0;  // by omega1
    gradient[1] = -f_0 / omega2 - q_0;  // by omega2
    const double c_0 = -3.0 / (16.0 * omega1_3);  // multiplies b1*p
    const double c_1 = -per_0 / (16.0 * omega1_2);  // multiplies b3*p
    const double c_2 = -1.0 / (8.0 * omega1_2 * omega2);  // multiplies b3*q
    gradient[3] = p * c_0;  // by b1
    gradient[4] = p * c_1 + q * c_2;  // by b3
    gradient[5] = b1 * c_0 + b3 * c_1;  // by p
    gradient[8] = b3 * c_2;  // by q
  }
  void lump_conservative_x_A_x([[maybe_unused]] double* gradient) const {
    gradient[0] = mu1_2 / (2.0 * omega1_2);  // by omega1
    gradient[2] = -mu1 / omega1;  // by mu1
  }
  void lump_conservative_x_A_x_F2([[maybe_unused]] double* gradient) const {
    const double f_0 = p * q * per_0 / (32.0 * omega1 * omega2);
    const double f_1 = p * q * per_0 / (16.0 * omega1_2);
    const double q_0 = (f_0 + f_1) * per_0;
    gradient[0] = (-f_0 - 2.0 * f_1) / omega1 - q_0;  // by omega1
    gradient[1] = -f_0 / omega2 - q_0;  // by omega2
    const double c_0 = (omega1 + 2.0 * omega2) * per_0 / (32.0 * omega1_2 * omega2);  // multiplies p*q
    gradient[5] = q * c_0;  // by p
    gradient[8] = p * c_0;  // by q
  }
  void lump_dissipative_x_A_x_A_y_conjA_y([[maybe_unused]] double* gradient) const {
    gradient[0] = -2.0 * b3 * mu2 / omega1_3;  // by omega1
    gradient[4] = mu2 / omega1_2;  // by b3
    gradient[6] = b3 / omega1_2;  // by mu2
  }
  void lump_conservative_x_A_x_A_y2_conjA_y2([[maybe_unused]] double* gradient) const {
    const double f_0 = -3.0 * b3_2 * over_0 / (4.0 * omega1);
    const double f_1 = omega2_2 * b3_2 * over_0 / (2.0 * omega1_3);
    const double q_0 = (f_0 + f_1) * per_0;
    const double q_1 = (f_0 + f_1) * per_1;
    gradient[0] = (-f_0 - 3.0 * f_1) / omega1 - q_0 - q_1;  // by omega1
    gradient[1] = 2.0 * f_1 / omega2 - q_0 + q_1;  // by omega2
    const double c_0 = (-3.0 * omega1_2 + 2.0 * omega2_2) * over_0 / (4.0 * omega1_3);  // multiplies b3^2
    gradient[4] = 2.0 * b3 * c_0;  // by b3
  }
  void lump_dissipative_x_A_x2_conjA_x([[maybe_unused]] double* gradient) const {
    gradient[0] = -3.0 * mu1 * b1 / omega1_3;  // by omega1
    gradient[2] = 3.0 * b1 / (2.0 * omega1_2);  // by mu1
    gradient[3] = 3.0 * mu1 / (2.0 * omega1_2);  // by b1
  }
  void lump_conservative_x_A_x2_A_y_conjA_x_conjA_y([[maybe_unused]] double* gradient) const {
    const double f_0 = -3.0 * b1 * b3 / (2.0 * omega1_3);
    const double f_1 = b3_2 * over_0 / (2.0 * omega1);
    const double q_0 = f_1 * per_0;
    const double q_1 = f_1 * per_1;
    gradient[0] = (-3.0 * f_0 - f_1) / omega1 - q_0 - q_1;  // by omega1
    gradient[1] = -q_0 + q_1;  // by omega2
    const double c_0 = -3.0 / (2.0 * omega1_3);  // multiplies b1*b3
    const double c_1 = over_0 / (2.0 * omega1);  // multiplies b3^2
    gradient[3] = b3 * c_0;  // by b1
    gradient[4] = b1 * c_0 + 2.0 * b3 * c_1;  // by b3
  }
  void lump_conservative_x_A_x3_conjA_x2([[maybe_unused]] double* gradient) const {
    gradient[0] = 45.0 * b1_2 / (16.0 * omega1_4);  // by omega1
    gradient[3] = -15.0 * b1 / (8.0 * omega1_3);  // by b1
  }
  void lump_dissipative_x_conjA_y_F([[maybe_unused]] double* gradient) const {
    gradient[0] = (-mu1 * p + p * mu2) / (4.0 * omega1_3);  // by omega1
    gradient[2] = p / (8.0 * omega1_2);  // by mu1
    gradient[5] = (mu1 - mu2) / (8.0 * omega1_2);  // by p
    gradient[6] = -p / (8.0 * omega1_2);  // by mu2
  }
  void lump_conservative_x_A_y_conjA_y2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -3.0 * p * b5 / (16.0 * omega1_2 * omega2);
    const double f_1 = b3 * p / (8.0 * omega1_3);
    const double f_2 = -b3 * p * per_0 / (16.0 * omega1 * omega2);
    const double q_0 = f_2 * per_0;
    gradient[0] = (-2.0 * f_0 - 3.0 * f_1 - f_2) / omega1 - q_0;  // by omega1
    gradient[1] = (-f_0 - f_2) / omega2 - q_0;  // by omega2
    const double c_0 = 1.0 / (8.0 * omega1_3) - per_0 / (16.0 * omega1 * omega2);  // multiplies b3*p
    const double c_1 = -3.0 / (16.0 * omega1_2 * omega2);  // multiplies p*b5
    gradient[4] = p * c_0;  // by b3
    gradient[5] = b3 * c_0 + b5 * c_1;  // by p
    gradient[7] = p * c_1;  // by b5
  }
  void lump_conservative_x_A_x_conjA_x_conjA_y_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -b3 * p / (8.0 * omega1_2 * omega2);
    const double f_1 = 3.0 * b1 * p / (8.0 * omega1_3);
    const double f_2 = b3 * q * per_0 / (8.0 * omega1 * omega2);
    const double q_0 = f_2 * per_0;
    gradient[0] = (-2.0 * f_0 - 3.0 * f_1 - f_2) / omega1 - q_0;  // by omega1
    gradient[1] = (-f_0 - f_2) / omega2 - q_0;  // by omega2
    const double c_0 = 3.0 / (8.0 * omega1_3);  // multiplies b1*p
    const double c_1 = -1.0 / (8.0 * omega1_2 * omega2);  // multiplies b3*p
    const double c_2 = per_0 / (8.0 * omega1 * omega2);  // multiplies b3*q
    gradient[3] = p * c_0;  // by b1
    gradient[4] = p * c_1 + q * c_2;  // by b3
    gradient[5] = b1 * c_0 + b3 * c_1;  // by p
    gradient[8] = b3 * c_2;  // by q
  }
  void lump_conservative_y_A_x_A_y2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -3.0 * b5 * q / (16.0 * omega2_3);
    const double f_1 = -b3 * p / (8.0 * omega1 * omega2_2);
    const double f_2 = -b3 * q * per_0 / (16.0 * omega2_2);
    const double q_0 = f_2 * per_0;
    gradient[0] = -f_1 / omega1 - q_0;  // by omega1
    gradient[1] = (-3.0 * f_0 - 2.0 * f_1 - 2.0 * f_2) / omega2 - q_0;  // by omega2
    const double c_0 = -1.0 / (8.0 * omega1 * omega2_2);  // multiplies b3*p
    const double c_1 = -per_0 / (16.0 * omega2_2);  // multiplies b3*q
    const double c_2 = -3.0 / (16.0 * omega2_3);  // multiplies b5*q
    gradient[4] = p * c_0 + q * c_1;  // by b3
    gradient[5] = b3 * c_0;  // by p
    gradient[7] = q * c_2;  // by b5
    gradient[8] = b3 * c_1 + b5 * c_2;  // by q
  }
  void lump_conservative_y_A_y([[maybe_unused]] double* gradient) const {
    gradient[1] = mu2_2 / (2.0 * omega2_2);  // by omega2
    gradient[6] = -mu2 / omega2;  // by mu2
  }
  void lump_dissipative_y_A_y2_conjA_y([[maybe_unused]] double* gradient) const {
    gradient[1] = -3.0 * mu2 * b5 / omega2_3;  // by omega2
    gradient[6] = 3.0 * b5 / (2.0 * omega2_2);  // by mu2
    gradient[7] = 3.0 * mu2 / (2.0 * omega2_2);  // by b5
  }
  void lump_conservative_y_A_y3_conjA_y2([[maybe_unused]] double* gradient) const {
    gradient[1] = 45.0 * b5_2 / (16.0 * omega2_4);  // by omega2
    gradient[7] = -15.0 * b5 / (8.0 * omega2_3);  // by b5
  }
  void lump_dissipative_y_A_x_A_y_conjA_x([[maybe_unused]] double* gradient) const {
    gradient[1] = -2.0 * mu1 * b3 / omega2_3;  // by omega2
    gradient[2] = b3 / omega2_2;  // by mu1
    gradient[4] = mu1 / omega2_2;  // by b3
  }
  void lump_conservative_y_A_x_A_y2_conjA_x_conjA_y([[maybe_unused]] double* gradient) const {
    const double f_0 = -3.0 * b3 * b5 / (2.0 * omega2_3);
    const double f_1 = -b3_2 * over_0 / (2.0 * omega2);
    const double q_0 = f_1 * per_0;
    const double q_1 = f_1 * per_1;
    gradient[0] = -q_0 - q_1;  // by omega1
    gradient[1] = (-3.0 * f_0 - f_1) / omega2 - q_0 + q_1;  // by omega2
    const double c_0 = -over_0 / (2.0 * omega2);  // multiplies b3^2
    const double c_1 = -3.0 / (2.0 * omega2_3);  // multiplies b3*b5
    gradient[4] = 2.0 * b3 * c_0 + b5 * c_1;  // by b3
    gradient[7] = b3 * c_1;  // by b5
  }
  void lump_dissipative_y_conjA_x_F([[maybe_unused]] double* gradient) const {
    gradient[1] = (mu1 * q - mu2 * q) / (4.0 * omega2_3);  // by omega2
    gradient[2] = -q / (8.0 * omega2_2);  // by mu1
    gradient[6] = q / (8.0 * omega2_2);  // by mu2
    gradient[8] = (-mu1 + mu2) / (8.0 * omega2_2);  // by q
  }
  void lump_conservative_y_A_y_conjA_x_conjA_y_F([[maybe_unused]] double* gradient) const {
    const double f_0 = 3.0 * b5 * q / (8.0 * omega2_3);
    const double f_1 = -b3 * q / (8.0 * omega1 * omega2_2);
    const double f_2 = b3 * p * per_0 / (8.0 * omega1 * omega2);
    const double q_0 = f_2 * per_0;
    gradient[0] = (-f_1 - f_2) / omega1 - q_0;  // by omega1
    gradient[1] = (-3.0 * f_0 - 2.0 * f_1 - f_2) / omega2 - q_0;  // by omega2
    const double c_0 = per_0 / (8.0 * omega1 * omega2);  // multiplies b3*p
    const double c_1 = -1.0 / (8.0 * omega1 * omega2_2);  // multiplies b3*q
    const double c_2 = 3.0 / (8.0 * omega2_3);  // multiplies b5*q
    gradient[4] = p * c_0 + q * c_1;  // by b3
    gradient[5] = b3 * c_0;  // by p
    gradient[7] = q * c_2;  // by b5
    gradient[8] = b3 * c_1 + b5 * c_2;  // by q
  }
  void lump_conservative_y_A_x_conjA_x2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = b3 * q / (8.0 * omega2_3);
    const double f_1 = -3.0 * b1 * q / (16.0 * omega1 * omega2_2);
    const double f_2 = -b3 * q * per_0 / (16.0 * omega1 * omega2);
    const double q_0 = f_2 * per_0;
    gradient[0] = (-f_1 - f_2) / omega1 - q_0;  // by omega1
    gradient[1] = (-3.0 * f_0 - 2.0 * f_1 - f_2) / omega2 - q_0;  // by omega2
    const double c_0 = -3.0 / (16.0 * omega1 * omega2_2);  // multiplies b1*q
    const double c_1 = 1.0 / (8.0 * omega2_3) - per_0 / (16.0 * omega1 * omega2);  // multiplies b3*q
    gradient[3] = q * c_0;  // by b1
    gradient[4] = q * c_1;  // by b3
    gradient[8] = b1 * c_0 + b3 * c_1;  // by q
  }
  void lump_harmonic_re_x_A_y_conjA_x2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = b3 * p * per_1_2 / (32.0 * omega1 * omega2);
    const double f_1 = 3.0 * b1 * p * over_0 / (32.0 * omega2_2);
    const double q_0 = f_1 * per_0;
    const double q_1 = (2.0 * f_0 + f_1) * per_1;
    gradient[0] = -f_0 / omega1 - q_0 - q_1;  // by omega1
    gradient[1] = (-f_0 - 2.0 * f_1) / omega2 - q_0 + q_1;  // by omega2
    const double c_0 = 3.0 * over_0 / (32.0 * omega2_2);  // multiplies b1*p
    const double c_1 = per_1_2 / (32.0 * omega1 * omega2);  // multiplies b3*p
    gradient[3] = p * c_0;  // by b1
    gradient[4] = p * c_1;  // by b3
    gradient[5] = b1 * c_0 + b3 * c_1;  // by p
  }
  void lump_harmonic_re_x_A_y3_F([[maybe_unused]] double* gradient) const {
    const double f_0 = b3 * p * per_1_2 / (32.0 * omega2_2);
    const double f_1 = -b3 * p * per_1_2 / (16.0 * omega1 * omega2);
    const double q_1 = (2.0 * f_0 + 2.0 * f_1) * per_1;
    gradient[0] = -f_1 / omega1 - q_1;  // by omega1
    gradient[1] = (-2.0 * f_0 - f_1) / omega2 + q_1;  // by omega2
    const double c_0 = (omega1 - 2.0 * omega2) * per_1_2 / (32.0 * omega1 * omega2_2);  // multiplies b3*p
    gradient[4] = p * c_0;  // by b3
    gradient[5] = b3 * c_0;  // by p
  }
  void lump_harmonic_re_x_A_y3_conjA_x_conjA_y([[maybe_unused]] double* gradient) const {
    const double f_0 = 5.0 * omega1 * b3 * b5 * per_1_2 / (16.0 * omega2_3);
    const double f_1 = -11.0 * b3 * b5 * per_1_2 / (16.0 * omega2_2);
    const double f_2 = b3_2 * per_1_2 / (4.0 * omega1 * omega2);
    const double q_1 = (2.0 * f_0 + 2.0 * f_1 + 2.0 * f_2) * per_1;
    gradient[0] = (f_0 - f_2) / omega1 - q_1;  // by omega1
    gradient[1] = (-3.0 * f_0 - 2.0 * f_1 - f_2) / omega2 + q_1;  // by omega2
    const double c_0 = per_1_2 / (4.0 * omega1 * omega2);  // multiplies b3^2
    const double c_1 = (5.0 * omega1 - 11.0 * omega2) * per_1_2 / (16.0 * omega2_3);  // multiplies b3*b5
    gradient[4] = 2.0 * b3 * c_0 + b5 * c_1;  // by b3
    gradient[7] = b3 * c_1;  // by b5
  }
  void lump_harmonic_re_x_A_x_A_y2_conjA_x2([[maybe_unused]] double* gradient) const {
    const double f_0 = omega1 * b3_2 * per_1_2 / (4.0 * omega2_3);
    const double f_1 = -b3_2 * per_1_2 / (2.0 * omega2_2);
    const double f_2 = -b3_2 * per_1_2 / (8.0 * omega1 * omega2);
    const double f_3 = 3.0 * b1 * b3 * over_1 / (4.0 * omega2);
    const double f_4 = 3.0 * b1 * b3 * over_1 / (8.0 * omega1);
    const double q_0 = (f_3 + f_4) * per_0;
    const double q_1 = (2.0 * f_0 + 2.0 * f_1 + 2.0 * f_2 + 2.0 * f_3 + 2.0 * f_4) * per_1;
    gradient[0] = (f_0 - f_2 - f_4) / omega1 - q_0 - q_1;  // by omega1
    gradient[1] = (-3.0 * f_0 - 2.0 * f_1 - f_2 - f_3) / omega2 - q_0 + q_1;  // by omega2
    const double c_0 = (6.0 * omega1 + 3.0 * omega2) * over_1 / (8.0 * omega1 * omega2);  // multiplies b1*b3
    const double c_1 = (2.0 * omega1_2 - 4.0 * omega1 * omega2 - omega2_2) * per_1_2 / (8.0 * omega1 * omega2_3);
    gradient[3] = b3 * c_0;  // by b1
    gradient[4] = b1 * c_0 + 2.0 * b3 * c_1;  // by b3
  }
  void lump_harmonic_re_x_A_y2_conjA_y_F([[maybe_unused]] double* gradient) const {
    const double f_0 = 3.0 * omega1 * p * b5 * per_0_2 / (32.0 * omega2_3);
    const double f_1 = (-b3 * p + 3.0 * p * b5) * per_0_2 / (16.0 * omega2_2);
    const double q_0 = (2.0 * f_0 + 2.0 * f_1) * per_0;
    gradient[0] = f_0 / omega1 - q_0;  // by omega1
    gradient[1] = (-3.0 * f_0 - 2.0 * f_1) / omega2 - q_0;  // by omega2
    const double c_0 = -per_0_2 / (16.0 * omega2_2);  // multiplies b3*p
    const double c_1 = (3.0 * omega1 + 6.0 * omega2) * per_0_2 / (32.0 * omega2_3);  // multiplies p*b5
    gradient[4] = p * c_0;  // by b3
    gradient[5] = b3 * c_0 + b5 * c_1;  // by p
    gradient[7] = p * c_1;  // by b5
  }
  void lump_harmonic_re_x_A_x_A_y_conjA_x_F([[maybe_unused]] double* gradient) const {
    const double f_0 = omega1 * b3 * p * per_0_2 / (16.0 * omega2_3);
    const double f_1 = (-3.0 * b1 * p + 2.0 * b3 * p) * per_0_2 / (16.0 * omega2_2);
    const double f_2 = -b3 * q * per_0_2 / (16.0 * omega1 * omega2);
    const double q_0 = (2.0 * f_0 + 2.0 * f_1 + 2.0 * f_2) * per_0;
    gradient[0] = (f_0 - f_2) / omega1 - q_0;  // by omega1
    gradient[1] = (-3.0 * f_0 - 2.0 * f_1 - f_2) / omega2 - q_0;  // by omega2
    const double c_0 = -3.0 * per_0_2 / (16.0 * omega2_2);  // multiplies b1*p
    const double c_1 = (omega1 + 2.0 * omega2) * per_0_2 / (16.0 * omega2_3);  // multiplies b3*p
    const double c_2 = -per_0_2 / (16.0 * omega1 * omega2);  // multiplies b3*q
    gradient[3] = p * c_0;  // by b1
    gradient[4] = p * c_1 + q * c_2;  // by b3
    gradient[5] = b1 * c_0 + b3 * c_1;  // by p
    gradient[8] = b3 * c_2;  // by q
  }
  void lump_harmonic_re_x_A_x_A_y3_conjA_y([[maybe_unused]] double* gradient) const {
    const double f_0 = -5.0 * omega1 * b3 * b5 * per_0_2 / (16.0 * omega2_3);
    const double f_1 = -11.0 * b3 * b5 * per_0_2 / (16.0 * omega2_2);
    const double f_2 = -b3_2 * per_0_2 / (4.0 * omega1 * omega2);
    const double q_0 = (2.0 * f_0 + 2.0 * f_1 + 2.0 * f_2) * per_0;
    gradient[0] = (f_0 - f_2) / omega1 - q_0;  // by omega1
    gradient[1] = (-3.0 * f_0 - 2.0 * f_1 - f_2) / omega2 - q_0;  // by omega2
    const double c_0 = -per_0_2 / (4.0 * omega1 * omega2);  // multiplies b3^2
    const double c_1 = (-5.0 * omega1 - 11.0 * omega2) * per_0_2 / (16.0 * omega2_3);  // multiplies b3*b5
    gradient[4] = 2.0 * b3 * c_0 + b5 * c_1;  // by b3
    gradient[7] = b3 * c_1;  // by b5
  }
  void lump_harmonic_re_x_A_x2_A_y2_conjA_x([[maybe_unused]] double* gradient) const {
    const double f_0 = -omega1 * b3_2 * per_0_2 / (4.0 * omega2_3);
    const double f_1 = -b3_2 * per_0_2 / (2.0 * omega2_2);
    const double f_2 = b3_2 * per_0_2 / (8.0 * omega1 * omega2);
    const double f_3 = -3.0 * b1 * b3 * over_2 / (4.0 * omega2);
    const double f_4 = 3.0 * b1 * b3 * over_2 / (8.0 * omega1);
    const double q_0 = (2.0 * f_0 + 2.0 * f_1 + 2.0 * f_2 + 2.0 * f_3 + 2.0 * f_4) * per_0;
    const double q_1 = (f_3 + f_4) * per_1;
    gradient[0] = (f_0 - f_2 - f_4) / omega1 - q_0 - q_1;  // by omega1
    gradient[1] = (-3.0 * f_0 - 2.0 * f_1 - f_2 - f_3) / omega2 - q_0 + q_1;  // by omega2
    const double c_0 = (-6.0 * omega1 + 3.0 * omega2) * over_2 / (8.0 * omega1 * omega2);  // multiplies b1*b3
    const double c_1 = (-2.0 * omega1_2 - 4.0 * omega1 * omega2 + omega2_2) * per_0_2 / (8.0 * omega1 * omega2_3);
    gradient[3] = b3 * c_0;  // by b1
    gradient[4] = b1 * c_0 + 2.0 * b3 * c_1;  // by b3
  }
  void lump_harmonic_re_x_A_x2_conjA_y_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -b3 * q * per_0 / (32.0 * omega1_3);
    const double f_1 = -b3 * p * per_1 / (64.0 * omega1_3);
    const double q_0 = f_0 * per_0;
    const double q_1 = f_1 * per_1;
    gradient[0] = (-3.0 * f_0 - 3.0 * f_1) / omega1 - q_0 - q_1;  // by omega1
    gradient[1] = -q_0 + q_1;  // by omega2
    const double c_0 = -per_1 / (64.0 * omega1_3);  // multiplies b3*p
    const double c_1 = -per_0 / (32.0 * omega1_3);  // multiplies b3*q
    gradient[4] = p * c_0 + q * c_1;  // by b3
    gradient[5] = b3 * c_0;  // by p
    gradient[8] = b3 * c_1;  // by q
  }
  void lump_harmonic_re_x_A_x3_A_y_conjA_y([[maybe_unused]] double* gradient) const {
    const double f_0 = -b1 * b3 / (4.0 * omega1_4);
    const double f_1 = b3_2 * over_0 / (8.0 * omega1_2);
    const double q_0 = f_1 * per_0;
    const double q_1 = f_1 * per_1;
    gradient[0] = (-4.0 * f_0 - 2.0 * f_1) / omega1 - q_0 - q_1;  // by omega1
    gradient[1] = -q_0 + q_1;  // by omega2
    const double c_0 = -1.0 / (4.0 * omega1_4);  // multiplies b1*b3
    const double c_1 = over_0 / (8.0 * omega1_2);  // multiplies b3^2
    gradient[3] = b3 * c_0;  // by b1
    gradient[4] = b1 * c_0 + 2.0 * b3 * c_1;  // by b3
  }
  void lump_harmonic_re_x_A_y2_conjA_x3([[maybe_unused]] double* gradient) const {
    const double f_0 = -3.0 * b1 * b3 * over_3 / (16.0 * omega2);
    const double f_1 = (b1 * b3 + 4.0 * b3_2) * over_3 / (32.0 * omega1);
    const double f_2 = -omega2 * b1 * b3 * over_3 / (32.0 * omega1_2);
    const double q_1 = (2.0 * f_0 + 2.0 * f_1 + 2.0 * f_2) * per_1;
    const double q_2 = (f_0 + f_1 + f_2) * per_2;
    gradient[0] = (-f_1 - 2.0 * f_2) / omega1 - q_1 - 2.0 * q_2;  // by omega1
    gradient[1] = (-f_0 + f_2) / omega2 + q_1 + q_2;  // by omega2
    const double c_0 = (-6.0 * omega1_2 + omega1 * omega2 - omega2_2) * over_3 / (32.0 * omega1_2 * omega2);
    const double c_1 = over_3 / (8.0 * omega1);  // multiplies b3^2
    gradient[3] = b3 * c_0;  // by b1
    gradient[4] = b1 * c_0 + 2.0 * b3 * c_1;  // by b3
  }
  void lump_harmonic_re_x_A_y4_conjA_x([[maybe_unused]] double* gradient) const {
    const double f_0 = -b3 * b5 * per_3 / (32.0 * omega2_3);
    const double f_1 = b3_2 * over_4 / (32.0 * omega2_2);
    const double q_1 = f_1 * per_1;
    const double q_3 = (f_0 + f_1) * per_3;
    gradient[0] = -q_1 - q_3;  // by omega1
    gradient[1] = (-3.0 * f_0 - 2.0 * f_1) / omega2 + q_1 + 2.0 * q_3;  // by omega2
    const double c_0 = over_4 / (32.0 * omega2_2);  // multiplies b3^2
    const double c_1 = -per_3 / (32.0 * omega2_3);  // multiplies b3*b5
    gradient[4] = 2.0 * b3 * c_0 + b5 * c_1;  // by b3
    gradient[7] = b3 * c_1;  // by b5
  }
  void lump_harmonic_re_x_A_x_A_y4([[maybe_unused]] double* gradient) const {
    const double f_0 = b3 * b5 * per_4 / (32.0 * omega2_3);
    const double f_1 = b3_2 * over_5 / (32.0 * omega2_2);
    const double q_0 = f_1 * per_0;
    const double q_4 = (f_0 + f_1) * per_4;
    gradient[0] = -q_0 - q_4;  // by omega1
    gradient[1] = (-3.0 * f_0 - 2.0 * f_1) / omega2 - q_0 - 2.0 * q_4;  // by omega2
    const double c_0 = over_5 / (32.0 * omega2_2);  // multiplies b3^2
    const double c_1 = per_4 / (32.0 * omega2_3);  // multiplies b3*b5
    gradient[4] = 2.0 * b3 * c_0 + b5 * c_1;  // by b3
    gradient[7] = b3 * c_1;  // by b5
  }
  void lump_harmonic_re_x_A_x2_A_y_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -3.0 * b1 * p * over_6 / (32.0 * omega2);
    const double f_1 = (-b3 * p - 2.0 * b3 * q) * over_6 / (32.0 * omega1);
    const double q_0 = (2.0 * f_0 + 2.0 * f_1) * per_0;
    const double q_5 = (f_0 + f_1) * per_5;
    gradient[0] = -f_1 / omega1 - q_0 - 2.0 * q_5;  // by omega1
    gradient[1] = -f_0 / omega2 - q_0 - q_5;  // by omega2
    const double c_0 = -3.0 * over_6 / (32.0 * omega2);  // multiplies b1*p
    const double c_1 = -over_6 / (32.0 * omega1);  // multiplies b3*p
    const double c_2 = -over_6 / (16.0 * omega1);  // multiplies b3*q
    gradient[3] = p * c_0;  // by b1
    gradient[4] = p * c_1 + q * c_2;  // by b3
    gradient[5] = b1 * c_0 + b3 * c_1;  // by p
    gradient[8] = b3 * c_2;  // by q
  }
  void lump_harmonic_re_x_A_x3_A_y2([[maybe_unused]] double* gradient) const {
    const double f_0 = 3.0 * b1 * b3 * over_6 / (16.0 * omega2);
    const double f_1 = (b1 * b3 + 4.0 * b3_2) * over_6 / (32.0 * omega1);
    const double f_2 = omega2 * b1 * b3 * over_6 / (32.0 * omega1_2);
    const double q_0 = (2.0 * f_0 + 2.0 * f_1 + 2.0 * f_2) * per_0;
    const double q_5 = (f_0 + f_1 + f_2) * per_5;
    gradient[0] = (-f_1 - 2.0 * f_2) / omega1 - q_0 - 2.0 * q_5;  // by omega1
    gradient[1] = (-f_0 + f_2) / omega2 - q_0 - q_5;  // by omega2
    const double c_0 = (6.0 * omega1_2 + omega1 * omega2 + omega2_2) * over_6 / (32.0 * omega1_2 * omega2);
    const double c_1 = over_6 / (8.0 * omega1);  // multiplies b3^2
    gradient[3] = b3 * c_0;  // by b1
    gradient[4] = b1 * c_0 + 2.0 * b3 * c_1;  // by b3
  }
  void lump_harmonic_re_y_conjA_x3_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -b1 * q * per_1 / (64.0 * omega1_3);
    const double q_1 = f_0 * per_1;
    gradient[0] = -3.0 * f_0 / omega1 - q_1;  // by omega1
    gradient[1] = q_1;  // by omega2
    const double c_0 = -per_1 / (64.0 * omega1_3);  // multiplies b1*q
    gradient[3] = q * c_0;  // by b1
    gradient[8] = b1 * c_0;  // by q
  }
  void lump_harmonic_re_y_A_y2_conjA_x2_conjA_y([[maybe_unused]] double* gradient) const {
    const double f_0 = -b3_2 * per_1_2 / (8.0 * omega1 * omega2);
    const double f_1 = -b3_2 * per_1_2 / (2.0 * omega1_2);
    const double f_2 = omega2 * b3_2 * per_1_2 / (4.0 * omega1_3);
    const double f_3 = 3.0 * b3 * b5 * over_1 / (8.0 * omega2);
    const double f_4 = 3.0 * b3 * b5 * over_1 / (4.0 * omega1);
    const double q_0 = (f_3 + f_4) * per_0;
    const double q_1 = (2.0 * f_0 + 2.0 * f_1 + 2.0 * f_2 + 2.0 * f_3 + 2.0 * f_4) * per_1;
    gradient[0] = (-f_0 - 2.0 * f_1 - 3.0 * f_2 - f_4) / omega1 - q_0 - q_1;  // by omega1
    gradient[1] = (-f_0 + f_2 - f_3) / omega2 - q_0 + q_1;  // by omega2
    const double c_0 = (-omega1_2 - 4.0 * omega1 * omega2 + 2.0 * omega2_2) * per_1_2 / (8.0 * omega1_3 * omega2);
    const double c_1 = (3.0 * omega1 + 6.0 * omega2) * over_1 / (8.0 * omega1 * omega2);  // multiplies b3*b5
    gradient[4] = 2.0 * b3 * c_0 + b5 * c_1;  // by b3
    gradient[7] = b3 * c_1;  // by b5
  }
  void lump_harmonic_re_y_A_x_A_y_conjA_x3([[maybe_unused]] double* gradient) const {
    const double f_0 = b3_2 * per_1_2 / (4.0 * omega1 * omega2);
    const double f_1 = -11.0 * b1 * b3 * per_1_2 / (16.0 * omega1_2);
    const double f_2 = 5.0 * omega2 * b1 * b3 * per_1_2 / (16.0 * omega1_3);
    const double q_1 = (2.0 * f_0 + 2.0 * f_1 + 2.0 * f_2) * per_1;
    gradient[0] = (-f_0 - 2.0 * f_1 - 3.0 * f_2) / omega1 - q_1;  // by omega1
    gradient[1] = (-f_0 + f_2) / omega2 + q_1;  // by omega2
    const double c_0 = (-11.0 * omega1 + 5.0 * omega2) * per_1_2 / (16.0 * omega1_3);  // multiplies b1*b3
    const double c_1 = per_1_2 / (4.0 * omega1 * omega2);  // multiplies b3^2
    gradient[3] = b3 * c_0;  // by b1
    gradient[4] = b1 * c_0 + 2.0 * b3 * c_1;  // by b3
  }
  void lump_harmonic_re_y_A_y2_conjA_x_F([[maybe_unused]] double* gradient) const {
    const double f_0 = b3 * q * per_1_2 / (32.0 * omega1 * omega2);
    const double f_1 = -3.0 * b5 * q * over_0 / (32.0 * omega1_2);
    const double q_0 = f_1 * per_0;
    const double q_1 = (2.0 * f_0 + f_1) * per_1;
    gradient[0] = (-f_0 - 2.0 * f_1) / omega1 - q_0 - q_1;  // by omega1
    gradient[1] = -f_0 / omega2 - q_0 + q_1;  // by omega2
    const double c_0 = per_1_2 / (32.0 * omega1 * omega2);  // multiplies b3*q
    const double c_1 = -3.0 * over_0 / (32.0 * omega1_2);  // multiplies b5*q
    gradient[4] = q * c_0;  // by b3
    gradient[7] = q * c_1;  // by b5
    gradient[8] = b3 * c_0 + b5 * c_1;  // by q
  }
  void lump_harmonic_re_y_A_x_A_y3_conjA_x([[maybe_unused]] double* gradient) const {
    const double f_0 = -b3 * b5 / (4.0 * omega2_4);
    const double f_1 = -b3_2 * over_0 / (8.0 * omega2_2);
    const double q_0 = f_1 * per_0;
    const double q_1 = f_1 * per_1;
    gradient[0] = -q_0 - q_1;  // by omega1
    gradient[1] = (-4.0 * f_0 - 2.0 * f_1) / omega2 - q_0 + q_1;  // by omega2
    const double c_0 = -over_0 / (8.0 * omega2_2);  // multiplies b3^2
    const double c_1 = -1.0 / (4.0 * omega2_4);  // multiplies b3*b5
    gradient[4] = 2.0 * b3 * c_0 + b5 * c_1;  // by b3
    gradient[7] = b3 * c_1;  // by b5
  }
  void lump_harmonic_re_y_A_x_A_y_conjA_y_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -b3 * p * per_0_2 / (16.0 * omega1 * omega2);
    const double f_1 = (2.0 * b3 * q - 3.0 * b5 * q) * per_0_2 / (16.0 * omega1_2);
    const double f_2 = omega2 * b3 * q * per_0_2 / (16.0 * omega1_3);
    const double q_0 = (2.0 * f_0 + 2.0 * f_1 + 2.0 * f_2) * per_0;
    gradient[0] = (-f_0 - 2.0 * f_1 - 3.0 * f_2) / omega1 - q_0;  // by omega1
    gradient[1] = (-f_0 + f_2) / omega2 - q_0;  // by omega2
    const double c_0 = -per_0_2 / (16.0 * omega1 * omega2);  // multiplies b3*p
    const double c_1 = (2.0 * omega1 + omega2) * per_0_2 / (16.0 * omega1_3);  // multiplies b3*q
    const double c_2 = -3.0 * per_0_2 / (16.0 * omega1_2);  // multiplies b5*q
    gradient[4] = p * c_0 + q * c_1;  // by b3
    gradient[5] = b3 * c_0;  // by p
    gradient[7] = q * c_2;  // by b5
    gradient[8] = b3 * c_1 + b5 * c_2;  // by q
  }
  void lump_harmonic_re_y_A_x2_conjA_x_F([[maybe_unused]] double* gradient) const {
    const double f_0 = (3.0 * b1 * q - b3 * q) * per_0_2 / (16.0 * omega1_2);
    const double f_1 = 3.0 * omega2 * b1 * q * per_0_2 / (32.0 * omega1_3);
    const double q_0 = (2.0 * f_0 + 2.0 * f_1) * per_0;
    gradient[0] = (-2.0 * f_0 - 3.0 * f_1) / omega1 - q_0;  // by omega1
    gradient[1] = f_1 / omega2 - q_0;  // by omega2
    const double c_0 = (6.0 * omega1 + 3.0 * omega2) * per_0_2 / (32.0 * omega1_3);  // multiplies b1*q
    const double c_1 = -per_0_2 / (16.0 * omega1_2);  // multiplies b3*q
    gradient[3] = q * c_0;  // by b1
    gradient[4] = q * c_1;  // by b3
    gradient[8] = b1 * c_0 + b3 * c_1;  // by q
  }
  void lump_harmonic_re_y_A_x2_A_y2_conjA_y([[maybe_unused]] double* gradient) const {
    const double f_0 = b3_2 * per_0_2 / (8.0 * omega1 * omega2);
    const double f_1 = -b3_2 * per_0_2 / (2.0 * omega1_2);
    const double f_2 = -omega2 * b3_2 * per_0_2 / (4.0 * omega1_3);
    const double f_3 = -3.0 * b3 * b5 * over_2 / (8.0 * omega2);
    const double f_4 = 3.0 * b3 * b5 * over_2 / (4.0 * omega1);
    const double q_0 = (2.0 * f_0 + 2.0 * f_1 + 2.0 * f_2 + 2.0 * f_3 + 2.0 * f_4) * per_0;
    const double q_1 = (f_3 + f_4) * per_1;
    gradient[0] = (-f_0 - 2.0 * f_1 - 3.0 * f_2 - f_4) / omega1 - q_0 - q_1;  // by omega1
    gradient[1] = (-f_0 + f_2 - f_3) / omega2 - q_0 + q_1;  // by omega2
    const double c_0 = (omega1_2 - 4.0 * omega1 * omega2 - 2.0 * omega2_2) * per_0_2 / (8.0 * omega1_3 * omega2);
    const double c_1 = (-3.0 * omega1 + 6.0 * omega2) * over_2 / (8.0 * omega1 * omega2);  // multiplies b3*b5
    gradient[4] = 2.0 * b3 * c_0 + b5 * c_1;  // by b3
    gradient[7] = b3 * c_1;  // by b5
  }
  void lump_harmonic_re_y_A_x3_A_y_conjA_x([[maybe_unused]] double* gradient) const {
    const double f_0 = -b3_2 * per_0_2 / (4.0 * omega1 * omega2);
    const double f_1 = -11.0 * b1 * b3 * per_0_2 / (16.0 * omega1_2);
    const double f_2 = -5.0 * omega2 * b1 * b3 * per_0_2 / (16.0 * omega1_3);
    const double q_0 = (2.0 * f_0 + 2.0 * f_1 + 2.0 * f_2) * per_0;
    gradient[0] = (-f_0 - 2.0 * f_1 - 3.0 * f_2) / omega1 - q_0;  // by omega1
    gradient[1] = (-f_0 + f_2) / omega2 - q_0;  // by omega2
    const double c_0 = (-11.0 * omega1 - 5.0 * omega2) * per_0_2 / (16.0 * omega1_3);  // multiplies b1*b3
    const double c_1 = -per_0_2 / (4.0 * omega1 * omega2);  // multiplies b3^2
    gradient[3] = b3 * c_0;  // by b1
    gradient[4] = b1 * c_0 + 2.0 * b3 * c_1;  // by b3
  }
  void lump_harmonic_re_y_A_y3_conjA_x2([[maybe_unused]] double* gradient) const {
    const double f_0 = omega1 * b3 * b5 * over_7 / (32.0 * omega2_2);
    const double f_1 = (-4.0 * b3_2 - b3 * b5) * over_7 / (32.0 * omega2);
    const double f_2 = 3.0 * b3 * b5 * over_7 / (16.0 * omega1);
    const double q_1 = (2.0 * f_0 + 2.0 * f_1 + 2.0 * f_2) * per_1;
    const double q_3 = (f_0 + f_1 + f_2) * per_3;
    gradient[0] = (f_0 - f_2) / omega1 - q_1 - q_3;  // by omega1
    gradient[1] = (-2.0 * f_0 - f_1) / omega2 + q_1 + 2.0 * q_3;  // by omega2
    const double c_0 = -over_7 / (8.0 * omega2);  // multiplies b3^2
    const double c_1 = (omega1_2 - omega1 * omega2 + 6.0 * omega2_2) * over_7 / (32.0 * omega1 * omega2_2);
    gradient[4] = 2.0 * b3 * c_0 + b5 * c_1;  // by b3
    gradient[7] = b3 * c_1;  // by b5
  }
  void lump_harmonic_re_y_A_x_A_y2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = (-2.0 * b3 * p - b3 * q) * over_8 / (32.0 * omega2);
    const double f_1 = -3.0 * b5 * q * over_8 / (32.0 * omega1);
    const double q_0 = (2.0 * f_0 + 2.0 * f_1) * per_0;
    const double q_4 = (f_0 + f_1) * per_4;
    gradient[0] = -f_1 / omega1 - q_0 - q_4;  // by omega1
    gradient[1] = -f_0 / omega2 - q_0 - 2.0 * q_4;  // by omega2
    const double c_0 = -over_8 / (16.0 * omega2);  // multiplies b3*p
    const double c_1 = -over_8 / (32.0 * omega2);  // multiplies b3*q
    const double c_2 = -3.0 * over_8 / (32.0 * omega1);  // multiplies b5*q
    gradient[4] = p * c_0 + q * c_1;  // by b3
    gradient[5] = b3 * c_0;  // by p
    gradient[7] = q * c_2;  // by b5
    gradient[8] = b3 * c_1 + b5 * c_2;  // by q
  }
  void lump_harmonic_re_y_A_x2_A_y3([[maybe_unused]] double* gradient) const {
    const double f_0 = omega1 * b3 * b5 * over_8 / (32.0 * omega2_2);
    const double f_1 = (4.0 * b3_2 + b3 * b5) * over_8 / (32.0 * omega2);
    const double f_2 = 3.0 * b3 * b5 * over_8 / (16.0 * omega1);
    const double q_0 = (2.0 * f_0 + 2.0 * f_1 + 2.0 * f_2) * per_0;
    const double q_4 = (f_0 + f_1 + f_2) * per_4;
    gradient[0] = (f_0 - f_2) / omega1 - q_0 - q_4;  // by omega1
    gradient[1] = (-2.0 * f_0 - f_1) / omega2 - q_0 - 2.0 * q_4;  // by omega2
    const double c_0 = over_8 / (8.0 * omega2);  // multiplies b3^2
    const double c_1 = (omega1_2 + omega1 * omega2 + 6.0 * omega2_2) * over_8 / (32.0 * omega1 * omega2_2);
    gradient[4] = 2.0 * b3 * c_0 + b5 * c_1;  // by b3
    gradient[7] = b3 * c_1;  // by b5
  }
  void lump_harmonic_re_y_A_x3_F([[maybe_unused]] double* gradient) const {
    const double f_0 = -b1 * q * per_5 / (128.0 * omega1_3);
    const double f_1 = -b3 * q * over_9 / (64.0 * omega1_2);
    const double q_0 = f_1 * per_0;
    const double q_5 = (f_0 + f_1) * per_5;
    gradient[0] = (-3.0 * f_0 - 2.0 * f_1) / omega1 - q_0 - 2.0 * q_5;  // by omega1
    gradient[1] = -q_0 - q_5;  // by omega2
    const double c_0 = -per_5 / (128.0 * omega1_3);  // multiplies b1*q
    const double c_1 = -over_9 / (64.0 * omega1_2);  // multiplies b3*q
    gradient[3] = q * c_0;  // by b1
    gradient[4] = q * c_1;  // by b3
    gradient[8] = b1 * c_0 + b3 * c_1;  // by q
  }
  void lump_harmonic_re_y_A_x4_A_y([[maybe_unused]] double* gradient) const {
    const double f_0 = b1 * b3 * per_5 / (32.0 * omega1_3);
    const double f_1 = b3_2 * over_9 / (32.0 * omega1_2);
    const double q_0 = f_1 * per_0;
    const double q_5 = (f_0 + f_1) * per_5;
    gradient[0] = (-3.0 * f_0 - 2.0 * f_1) / omega1 - q_0 - 2.0 * q_5;  // by omega1
    gradient[1] = -q_0 - q_5;  // by omega2
    const double c_0 = per_5 / (32.0 * omega1_3);  // multiplies b1*b3
    const double c_1 = over_9 / (32.0 * omega1_2);  // multiplies b3^2
    gradient[3] = b3 * c_0;  // by b1
    gradient[4] = b1 * c_0 + 2.0 * b3 * c_1;  // by b3
  }
  void lump_harmonic_re_y_A_x4_conjA_y([[maybe_unused]] double* gradient) const {
    const double f_0 = b1 * b3 * per_2 / (32.0 * omega1_3);
    const double f_1 = b3_2 * over_10 / (32.0 * omega1_2);
    const double q_1 = f_1 * per_1;
    const double q_2 = (f_0 + f_1) * per_2;
    gradient[0] = (-3.0 * f_0 - 2.0 * f_1) / omega1 - q_1 - 2.0 * q_2;  // by omega1
    gradient[1] = q_1 + q_2;  // by omega2
    const double c_0 = per_2 / (32.0 * omega1_3);  // multiplies b1*b3
    const double c_1 = over_10 / (32.0 * omega1_2);  // multiplies b3^2
    gradient[3] = b3 * c_0;  // by b1
    gradient[4] = b1 * c_0 + 2.0 * b3 * c_1;  // by b3
  }

  using Gradient = void (LumpGradients::*)(double*) const;
  static constexpr Gradient gradients[] = {&LumpGradients::lump_mu1, &LumpGradients::lump_b3,
      &LumpGradients::lump_b1, &LumpGradients::lump_p, &LumpGradients::lump_mu2, &LumpGradients::lump_b5,
      &LumpGradients::lump_q, &LumpGradients::lump_conservative_x_A_x2_A_y_F,
      &LumpGradients::lump_conservative_x_A_x, &LumpGradients::lump_conservative_x_A_x_F2,
      &LumpGradients::lump_dissipative_x_A_x_A_y_conjA_y, &LumpGradients::lump_conservative_x_A_x_A_y2_conjA_y2,
      &LumpGradients::lump_dissipative_x_A_x2_conjA_x, &LumpGradients::lump_conservative_x_A_x2_A_y_conjA_x_conjA_y,
      &LumpGradients::lump_conservative_x_A_x3_conjA_x2, &LumpGradients::lump_dissipative_x_conjA_y_F,
      &LumpGradients::lump_conservative_x_A_y_conjA_y2_F, &LumpGradients::lump_conservative_x_A_x_conjA_x_conjA_y_F,
      &LumpGradients::lump_conservative_y_A_x_A_y2_F, &LumpGradients::lump_conservative_y_A_y,
      &LumpGradients::lump_dissipative_y_A_y2_conjA_y, &LumpGradients::lump_conservative_y_A_y3_conjA_y2,
      &LumpGradients::lump_dissipative_y_A_x_A_y_conjA_x,
      &LumpGradients::lump_conservative_y_A_x_A_y2_conjA_x_conjA_y, &LumpGradients::lump_dissipative_y_conjA_x_F,
      &LumpGradients::lump_conservative_y_A_y_conjA_x_conjA_y_F, &LumpGradients::lump_conservative_y_A_x_conjA_x2_F,
      &LumpGradients::lump_harmonic_re_x_A_y_conjA_x2_F, &LumpGradients::lump_harmonic_re_x_A_y3_F,
      &LumpGradients::lump_harmonic_re_x_A_y3_conjA_x_conjA_y, &LumpGradients::lump_harmonic_re_x_A_x_A_y2_conjA_x2,
      &LumpGradients::lump_harmonic_re_x_A_y2_conjA_y_F, &LumpGradients::lump_harmonic_re_x_A_x_A_y_conjA_x_F,
      &LumpGradients::lump_harmonic_re_x_A_x_A_y3_conjA_y, &LumpGradients::lump_harmonic_re_x_A_x2_A_y2_conjA_x,
      &LumpGradients::lump_harmonic_re_x_A_x2_conjA_y_F, &LumpGradients::lump_harmonic_re_x_A_x3_A_y_conjA_y,
      &LumpGradients::lump_harmonic_re_x_A_y2_conjA_x3, &LumpGradients::lump_harmonic_re_x_A_y4_conjA_x,
      &LumpGradients::lump_harmonic_re_x_A_x_A_y4, &LumpGradients::lump_harmonic_re_x_A_x2_A_y_F,
      &LumpGradients::lump_harmonic_re_x_A_x3_A_y2, &LumpGradients::lump_harmonic_re_y_conjA_x3_F,
      &LumpGradients::lump_harmonic_re_y_A_y2_conjA_x2_conjA_y, &LumpGradients::lump_harmonic_re_y_A_x_A_y_conjA_x3,
      &LumpGradients::lump_harmonic_re_y_A_y2_conjA_x_F, &LumpGradients::lump_harmonic_re_y_A_x_A_y3_conjA_x,
      &LumpGradients::lump_harmonic_re_y_A_x_A_y_conjA_y_F, &LumpGradients::lump_harmonic_re_y_A_x2_conjA_x_F,
      &LumpGradients::lump_harmonic_re_y_A_x2_A_y2_conjA_y, &LumpGradients::lump_harmonic_re_y_A_x3_A_y_conjA_x,
      &LumpGradients::lump_harmonic_re_y_A_y3_conjA_x2, &LumpGradients::lump_harmonic_re_y_A_x_A_y2_F,
      &LumpGradients::lump_harmonic_re_y_A_x2_A_y3, &LumpGradients::lump_harmonic_re_y_A_x3_F,
      &LumpGradients::lump_harmonic_re_y_A_x4_A_y, &LumpGradients::lump_harmonic_re_y_A_x4_conjA_y};
};

inline constexpr LumpFunctions lump_functions = {lump_values<Lumps>, lump_jacobian<LumpGradients, 9>};

}  // namespace secular::generated::parametric_pair
