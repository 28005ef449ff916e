// Model duffing: generated code, never edited by hand.
// Holds derivatives of the lumps by the parameters. Made by: secular generate duffing.
#pragma once

#include "duffing.hpp"

namespace secular::generated::duffing {

/// gradient[p] = derivative of a lump by parameters[p], entries that are not zero. Of lumps with small divisors:
/// f_n are the fractions whose sum the lump is, q_d those of divisor d times its power and inverse, c_n what
/// multiplies a product of coefficients.
struct LumpGradients : Lumps {
  using Lumps::Lumps;

  void lump_mu([[maybe_unused]] double* gradient) const { gradient[1] = 1.0; }
  void lump_conservative_x_A_x2_conjA_x([[maybe_unused]] double* gradient) const {
    gradient[0] = (-3.0 * omega0_2 * a3 + 10.0 * a2_2) / (2.0 * omega0_4);  // by omega0
    gradient[2] = -10.0 * a2 / (3.0 * omega0_3);  // by a2
    gradient[3] = 3.0 / (2.0 * omega0);  // by a3
  }
  void lump_a2([[maybe_unused]] double* gradient) const { gradient[2] = 1.0; }
  void lump_harmonic_re_x_A_x3([[maybe_unused]] double* gradient) const {
    gradient[0] = (-3.0 * omega0_2 * a3 - 4.0 * a2_2) / (12.0 * omega0_5);  // by omega0
    gradient[2] = a2 / (6.0 * omega0_4);  // by a2
    gradient[3] = 1.0 / (8.0 * omega0_2);  // by a3
  }
  void lump_e([[maybe_unused]] double* gradient) const { gradient[4] = 1.0; }
  void lump_conservative_x_A_x_F2([[maybe_unused]] double* gradient) const {
    gradient[0] = -1215.0 * a3 * e_2 / (256.0 * omega0_6);  // by omega0
    gradient[3] = 243.0 * e_2 / (256.0 * omega0_5);  // by a3
    gradient[4] = 243.0 * a3 * e / (128.0 * omega0_5);  // by e
  }
  void lump_a3([[maybe_unused]] double* gradient) const { gradient[3] = 1.0; }
  void lump_conservative_x_F3([[maybe_unused]] double* gradient) const {
    gradient[0] = -5103.0 * a3 * e_3 / (8192.0 * omega0_8);  // by omega0
    gradient[3] = 729.0 * e_3 / (8192.0 * omega0_7);  // by a3
    gradient[4] = 2187.0 * a3 * e_2 / (8192.0 * omega0_7);  // by e
  }
  void lump_harmonic_im_x_F([[maybe_unused]] double* gradient) const {
    gradient[0] = 81.0 * mu * e / (64.0 * omega0_4);  // by omega0
    gradient[1] = -27.0 * e / (64.0 * omega0_3);  // by mu
    gradient[4] = -27.0 * mu / (64.0 * omega0_3);  // by e
  }
  void lump_harmonic_re_x_A_x_conjA_x_F([[maybe_unused]] double* gradient) const {
    gradient[0] = 243.0 * a3 * e / (16.0 * omega0_5);  // by omega0
    gradient[3] = -243.0 * e / (64.0 * omega0_4);  // by a3
    gradient[4] = -243.0 * a3 / (64.0 * omega0_4);  // by e
  }
  void lump_harmonic_re_x_F2([[maybe_unused]] double* gradient) const {
    gradient[0] = 243.0 * a2 * e_2 / (64.0 * omega0_7);  // by omega0
    gradient[2] = -81.0 * e_2 / (128.0 * omega0_6);  // by a2
    gradient[4] = -81.0 * a2 * e / (64.0 * omega0_6);  // by e
  }
  void lump_harmonic_re_x_A_x_F([[maybe_unused]] double* gradient) const {
    gradient[0] = 81.0 * a2 * e / (10.0 * omega0_5);  // by omega0
    gradient[2] = -81.0 * e / (40.0 * omega0_4);  // by a2
    gradient[4] = -81.0 * a2 / (40.0 * omega0_4);  // by e
  }
  void lump_conservative_x_A_x_F2_of_subharmonic_3([[maybe_unused]] double* gradient) const {
    gradient[0] = -15.0 * a3 * e_2 / (256.0 * omega0_6);  // by omega0
    gradient[3] = 3.0 * e_2 / (256.0 * omega0_5);  // by a3
    gradient[4] = 3.0 * a3 * e / (128.0 * omega0_5);  // by e
  }
  void lump_conservative_x_conjA_x2_F([[maybe_unused]] double* gradient) const {
    gradient[0] = 9.0 * a3 * e / (32.0 * omega0_4);  // by omega0
    gradient[3] = -3.0 * e / (32.0 * omega0_3);  // by a3
    gradient[4] = -3.0 * a3 / (32.0 * omega0_3);  // by e
  }
  void lump_harmonic_im_x_F_of_subharmonic_3([[maybe_unused]] double* gradient) const {
    gradient[0] = 9.0 * mu * e / (64.0 * omega0_4);  // by omega0
    gradient[1] = -3.0 * e / (64.0 * omega0_3);  // by mu
    gradient[4] = -3.0 * mu / (64.0 * omega0_3);  // by e
  }
  void lump_harmonic_re_x_F3([[maybe_unused]] double* gradient) const {
    gradient[0] = 3.0 * a3 * e_3 / (4096.0 * omega0_9);  // by omega0
    gradient[3] = -3.0 * e_3 / (32768.0 * omega0_8);  // by a3
    gradient[4] = -9.0 * a3 * e_2 / (32768.0 * omega0_8);  // by e
  }
  void lump_harmonic_re_x_conjA_x_F([[maybe_unused]] double* gradient) const {
    gradient[0] = a2 * e / (6.0 * omega0_5);  // by omega0
    gradient[2] = -e / (24.0 * omega0_4);  // by a2
    gradient[4] = -a2 / (24.0 * omega0_4);  // by e
  }
  void lump_harmonic_re_x_F2_of_subharmonic_3([[maybe_unused]] double* gradient) const {
    gradient[0] = 3.0 * a2 * e_2 / (64.0 * omega0_7);  // by omega0
    gradient[2] = -e_2 / (128.0 * omega0_6);  // by a2
    gradient[4] = -a2 * e / (64.0 * omega0_6);  // by e
  }
  void lump_conservative_x_A_x4_F([[maybe_unused]] double* gradient) const {
    gradient[0] = 15.0 * a3_2 * e / (32.0 * omega0_6);  // by omega0
    gradient[3] = -3.0 * a3 * e / (16.0 * omega0_5);  // by a3
    gradient[4] = -3.0 * a3_2 / (32.0 * omega0_5);  // by e
  }
  void lump_conservative_x_A_x([[maybe_unused]] double* gradient) const {
    gradient[0] = mu_2 / (2.0 * omega0_2);  // by omega0
    gradient[1] = -mu / omega0;  // by mu
  }
  void lump_conservative_x_A_x_F2_of_subharmonic_3_second_order([[maybe_unused]] double* gradient) const {
    gradient[0] = (-75.0 * omega0_2 * a3 * e_2 + 42.0 * a2_2 * e_2) / (1280.0 * omega0_8);  // by omega0
    gradient[2] = -3.0 * a2 * e_2 / (320.0 * omega0_7);  // by a2
    gradient[3] = 3.0 * e_2 / (256.0 * omega0_5);  // by a3
    gradient[4] = (15.0 * omega0_2 * a3 * e - 6.0 * a2_2 * e) / (640.0 * omega0_7);  // by e
  }
  void lump_conservative_x_A_x_F2_sigma([[maybe_unused]] double* gradient) const {
    gradient[0] = 27.0 * a3 * e_2 / (256.0 * omega0_7);  // by omega0
    gradient[3] = -9.0 * e_2 / (512.0 * omega0_6);  // by a3
    gradient[4] = -9.0 * a3 * e / (256.0 * omega0_6);  // by e
  }
  void lump_conservative_x_A_x_F4([[maybe_unused]] double* gradient) const {
    gradient[0] = 693.0 * a3_2 * e_4 / (2097152.0 * omega0_12);  // by omega0
    gradient[3] = -63.0 * a3 * e_4 / (1048576.0 * omega0_11);  // by a3
    gradient[4] = -63.0 * a3_2 * e_3 / (524288.0 * omega0_11);  // by e
  }
  void lump_dissipative_x_A_x2_conjA_x([[maybe_unused]] double* gradient) const {
    gradient[0] = -3.0 * mu * a3 / omega0_3;  // by omega0
    gradient[1] = 3.0 * a3 / (2.0 * omega0_2);  // by mu
    gradient[3] = 3.0 * mu / (2.0 * omega0_2);  // by a3
  }
  void lump_conservative_x_A_x2_conjA_x_F2([[maybe_unused]] double* gradient) const {
    gradient[0] = -147.0 * a3_2 * e_2 / (2048.0 * omega0_8);  // by omega0
    gradient[3] = 21.0 * a3 * e_2 / (1024.0 * omega0_7);  // by a3
    gradient[4] = 21.0 * a3_2 * e / (1024.0 * omega0_7);  // by e
  }
  void lump_conservative_x_A_x3_conjA_x2([[maybe_unused]] double* gradient) const {
    gradient[0] = 45.0 * a3_2 / (16.0 * omega0_4);  // by omega0
    gradient[3] = -15.0 * a3 / (8.0 * omega0_3);  // by a3
  }
  void lump_dissipative_x_conjA_x2_F([[maybe_unused]] double* gradient) const {
    gradient[0] = -3.0 * mu * a3 * e / (32.0 * omega0_5);  // by omega0
    gradient[1] = 3.0 * a3 * e / (128.0 * omega0_4);  // by mu
    gradient[3] = 3.0 * mu * e / (128.0 * omega0_4);  // by a3
    gradient[4] = 3.0 * mu * a3 / (128.0 * omega0_4);  // by e
  }
  void lump_conservative_x_conjA_x2_F_of_subharmonic_3_second_order([[maybe_unused]] double* gradient) const {
    gradient[0] = (9.0 * omega0_2 * a3 * e + 10.0 * a2_2 * e) / (32.0 * omega0_6);  // by omega0
    gradient[2] = -a2 * e / (8.0 * omega0_5);  // by a2
    gradient[3] = -3.0 * e / (32.0 * omega0_3);  // by a3
    gradient[4] = (-3.0 * omega0_2 * a3 - 2.0 * a2_2) / (32.0 * omega0_5);  // by e
  }
  void lump_conservative_x_conjA_x2_F_sigma([[maybe_unused]] double* gradient) const {
    gradient[0] = -15.0 * a3 * e / (32.0 * omega0_5);  // by omega0
    gradient[3] = 15.0 * e / (128.0 * omega0_4);  // by a3
    gradient[4] = 15.0 * a3 / (128.0 * omega0_4);  // by e
  }
  void lump_conservative_x_conjA_x2_F3([[maybe_unused]] double* gradient) const {
    gradient[0] = 243.0 * a3_2 * e_3 / (32768.0 * omega0_10);  // by omega0
    gradient[3] = -27.0 * a3 * e_3 / (16384.0 * omega0_9);  // by a3
    gradient[4] = -81.0 * a3_2 * e_2 / (32768.0 * omega0_9);  // by e
  }
  void lump_harmonic_re_x_F([[maybe_unused]] double* gradient) const {
    gradient[0] = -9.0 * mu_2 * e / (64.0 * omega0_5);  // by omega0
    gradient[1] = 9.0 * mu * e / (128.0 * omega0_4);  // by mu
    gradient[4] = 9.0 * mu_2 / (256.0 * omega0_4);  // by e
  }
  void lump_harmonic_im_x_F3([[maybe_unused]] double* gradient) const {
    gradient[0] = 81.0 * mu * a3 * e_3 / (65536.0 * omega0_10);  // by omega0
    gradient[1] = -9.0 * a3 * e_3 / (65536.0 * omega0_9);  // by mu
    gradient[3] = -9.0 * mu * e_3 / (65536.0 * omega0_9);  // by a3
    gradient[4] = -27.0 * mu * a3 * e_2 / (65536.0 * omega0_9);  // by e
  }
  void lump_harmonic_re_x_F5([[maybe_unused]] double* gradient) const {
    gradient[0] = 1911.0 * a3_2 * e_5 / (335544320.0 * omega0_15);  // by omega0
    gradient[3] = -273.0 * a3 * e_5 / (335544320.0 * omega0_14);  // by a3
    gradient[4] = -273.0 * a3_2 * e_4 / (134217728.0 * omega0_14);  // by e
  }
  void lump_harmonic_re_x_A_x_conjA_x_F_of_subharmonic_3_second_order([[maybe_unused]] double* gradient) const {
    gradient[0] = -9.0 * a2_2 * e / (80.0 * omega0_7);  // by omega0
    gradient[2] = 3.0 * a2 * e / (80.0 * omega0_6);  // by a2
    gradient[4] = 3.0 * a2_2 / (160.0 * omega0_6);  // by e
  }
  void lump_harmonic_re_x_A_x3_of_subharmonic_3_second_order([[maybe_unused]] double* gradient) const {
    gradient[0] = -a2_2 / (3.0 * omega0_5);  // by omega0
    gradient[2] = a2 / (6.0 * omega0_4);  // by a2
  }
  void lump_harmonic_re_x_A_x2_F2([[maybe_unused]] double* gradient) const {
    gradient[0] = -a2 * a3 * e_2 / (24.0 * omega0_9);  // by omega0
    gradient[2] = a3 * e_2 / (192.0 * omega0_8);  // by a2
    gradient[3] = a2 * e_2 / (192.0 * omega0_8);  // by a3
    gradient[4] = a2 * a3 * e / (96.0 * omega0_8);  // by e
  }
  void lump_harmonic_im_x_conjA_x_F([[maybe_unused]] double* gradient) const {
    gradient[0] = 5.0 * mu * a2 * e / (32.0 * omega0_6);  // by omega0
    gradient[1] = -a2 * e / (32.0 * omega0_5);  // by mu
    gradient[2] = -mu * e / (32.0 * omega0_5);  // by a2
    gradient[4] = -mu * a2 / (32.0 * omega0_5);  // by e
  }
  void lump_harmonic_re_x_conjA_x_F3([[maybe_unused]] double* gradient) const {
    gradient[0] = 55.0 * a2 * a3 * e_3 / (43008.0 * omega0_11);  // by omega0
    gradient[2] = -11.0 * a3 * e_3 / (86016.0 * omega0_10);  // by a2
    gradient[3] = -11.0 * a2 * e_3 / (86016.0 * omega0_10);  // by a3
    gradient[4] = -11.0 * a2 * a3 * e_2 / (28672.0 * omega0_10);  // by e
  }
  void lump_harmonic_re_x_A_x_conjA_x2_F([[maybe_unused]] double* gradient) const {
    gradient[0] = -a2 * a3 * e / (80.0 * omega0_7);  // by omega0
    gradient[2] = a3 * e / (480.0 * omega0_6);  // by a2
    gradient[3] = a2 * e / (480.0 * omega0_6);  // by a3
    gradient[4] = a2 * a3 / (480.0 * omega0_6);  // by e
  }
  void lump_harmonic_im_x_A_x2([[maybe_unused]] double* gradient) const {
    gradient[0] = 4.0 * mu * a2 / (3.0 * omega0_4);  // by omega0
    gradient[1] = -4.0 * a2 / (9.0 * omega0_3);  // by mu
    gradient[2] = -4.0 * mu / (9.0 * omega0_3);  // by a2
  }
  void lump_harmonic_re_x_A_x3_conjA_x([[maybe_unused]] double* gradient) const {
    gradient[0] = 31.0 * a2 * a3 / (3.0 * omega0_5);  // by omega0
    gradient[2] = -31.0 * a3 / (12.0 * omega0_4);  // by a2
    gradient[3] = -31.0 * a2 / (12.0 * omega0_4);  // by a3
  }
  void lump_harmonic_re_x_conjA_x_F2([[maybe_unused]] double* gradient) const {
    gradient[0] = -73.0 * a2_2 * e_2 / (40320.0 * omega0_9);  // by omega0
    gradient[2] = 73.0 * a2 * e_2 / (161280.0 * omega0_8);  // by a2
    gradient[4] = 73.0 * a2_2 * e / (161280.0 * omega0_8);  // by e
  }
  void lump_harmonic_im_x_conjA_x_F2([[maybe_unused]] double* gradient) const {
    gradient[0] = -21.0 * mu * a3 * e_2 / (4096.0 * omega0_8);  // by omega0
    gradient[1] = 3.0 * a3 * e_2 / (4096.0 * omega0_7);  // by mu
    gradient[3] = 3.0 * mu * e_2 / (4096.0 * omega0_7);  // by a3
    gradient[4] = 3.0 * mu * a3 * e / (2048.0 * omega0_7);  // by e
  }
  void lump_harmonic_re_x_F4([[maybe_unused]] double* gradient) const {
    gradient[0] = -2169.0 * a2 * a3 * e_4 / (1146880.0 * omega0_13);  // by omega0
    gradient[2] = 723.0 * a3 * e_4 / (4587520.0 * omega0_12);  // by a2
    gradient[3] = 723.0 * a2 * e_4 / (4587520.0 * omega0_12);  // by a3
    gradient[4] = 723.0 * a2 * a3 * e_3 / (1146880.0 * omega0_12);  // by e
  }
  void lump_harmonic_im_x_F2([[maybe_unused]] double* gradient) const {
    gradient[0] = -129.0 * mu * a2 * e_2 / (89600.0 * omega0_8);  // by omega0
    gradient[1] = 129.0 * a2 * e_2 / (627200.0 * omega0_7);  // by mu
    gradient[2] = 129.0 * mu * e_2 / (627200.0 * omega0_7);  // by a2
    gradient[4] = 129.0 * mu * a2 * e / (313600.0 * omega0_7);  // by e
  }

  using Gradient = void (LumpGradients::*)(double*) const;
  static constexpr Gradient gradients[] = {&LumpGradients::lump_mu,
      &LumpGradients::lump_conservative_x_A_x2_conjA_x, &LumpGradients::lump_a2,
      &LumpGradients::lump_harmonic_re_x_A_x3, &LumpGradients::lump_e, &LumpGradients::lump_conservative_x_A_x_F2,
      &LumpGradients::lump_a3, &LumpGradients::lump_conservative_x_F3, &LumpGradients::lump_harmonic_im_x_F,
      &LumpGradients::lump_harmonic_re_x_A_x_conjA_x_F, &LumpGradients::lump_harmonic_re_x_F2,
      &LumpGradients::lump_harmonic_re_x_A_x_F, &LumpGradients::lump_conservative_x_A_x_F2_of_subharmonic_3,
      &LumpGradients::lump_conservative_x_conjA_x2_F, &LumpGradients::lump_harmonic_im_x_F_of_subharmonic_3,
      &LumpGradients::lump_harmonic_re_x_F3, &LumpGradients::lump_harmonic_re_x_conjA_x_F,
      &LumpGradients::lump_harmonic_re_x_F2_of_subharmonic_3, &LumpGradients::lump_conservative_x_A_x4_F,
      &LumpGradients::lump_conservative_x_A_x,
      &LumpGradients::lump_conservative_x_A_x_F2_of_subharmonic_3_second_order,
      &LumpGradients::lump_conservative_x_A_x_F2_sigma, &LumpGradients::lump_conservative_x_A_x_F4,
      &LumpGradients::lump_dissipative_x_A_x2_conjA_x, &LumpGradients::lump_conservative_x_A_x2_conjA_x_F2,
      &LumpGradients::lump_conservative_x_A_x3_conjA_x2, &LumpGradients::lump_dissipative_x_conjA_x2_F,
      &LumpGradients::lump_conservative_x_conjA_x2_F_of_subharmonic_3_second_order,
      &LumpGradients::lump_conservative_x_conjA_x2_F_sigma, &LumpGradients::lump_conservative_x_conjA_x2_F3,
      &LumpGradients::lump_harmonic_re_x_F, &LumpGradients::lump_harmonic_im_x_F3,
      &LumpGradients::lump_harmonic_re_x_F5,
      &LumpGradients::lump_harmonic_re_x_A_x_conjA_x_F_of_subharmonic_3_second_order,
      &LumpGradients::lump_harmonic_re_x_A_x3_of_subharmonic_3_second_order,
      &LumpGradients::lump_harmonic_re_x_A_x2_F2, &LumpGradients::lump_harmonic_im_x_conjA_x_F,
      &LumpGradients::lump_harmonic_re_x_conjA_x_F3, &LumpGradients::lump_harmonic_re_x_A_x_conjA_x2_F,
      &LumpGradients::lump_harmonic_im_x_A_x2, &LumpGradients::lump_harmonic_re_x_A_x3_conjA_x,
      &LumpGradients::lump_harmonic_re_x_conjA_x_F2, &LumpGradients::lump_harmonic_im_x_conjA_x_F2,
      &LumpGradients::lump_harmonic_re_x_F4, &LumpGradients::lump_harmonic_im_x_F2};
};

inline constexpr LumpFunctions lump_functions = {lump_values<Lumps>, lump_jacobian<LumpGradients, 5>};

}  // namespace secular::generated::duffing
