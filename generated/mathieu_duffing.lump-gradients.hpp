// Model mathieu_duffing: generated code, never edited by hand.
// Holds derivatives of the lumps by the parameters. Made by: secular generate mathieu_duffing.
#pragma once

#include "mathieu_duffing.hpp"

namespace secular::generated::mathieu_duffing {

/// gradient[p] = derivative of a lump by parameters[p], entries that are not zero. Of lumps with small divisors:
/// f_n are the fractions whose sum the lump is, q_d those of divisor d times its power and inverse, c_n what
/// multiplies a product of coefficients.
struct LumpGradients : Lumps {
  using Lumps::Lumps;

  void lump_conservative_x_A_x3_F([[maybe_unused]] double* gradient) const {
    gradient[0] = -21.0 * a3 * h / (32.0 * omega0_4);  // by omega0
    gradient[2] = 7.0 * h / (32.0 * omega0_3);  // by a3
    gradient[3] = 7.0 * a3 / (32.0 * omega0_3);  // by h
  }
  void lump_mu([[maybe_unused]] double* gradient) const { gradient[1] = 1.0; }
  void lump_conservative_x_A_x([[maybe_unused]] double* gradient) const {
    gradient[0] = mu_2 / (2.0 * omega0_2);  // by omega0
    gradient[1] = -mu / omega0;  // by mu
  }
  void lump_conservative_x_A_x_F2([[maybe_unused]] double* gradient) const {
    gradient[0] = -9.0 * h_2 / (64.0 * omega0_4);  // by omega0
    gradient[3] = 3.0 * h / (32.0 * omega0_3);  // by h
  }
  void lump_dissipative_x_A_x2_conjA_x([[maybe_unused]] double* gradient) const {
    gradient[0] = -3.0 * mu * a3 / omega0_3;  // by omega0
    gradient[1] = 3.0 * a3 / (2.0 * omega0_2);  // by mu
    gradient[2] = 3.0 * mu / (2.0 * omega0_2);  // by a3
  }
  void lump_a3([[maybe_unused]] double* gradient) const { gradient[2] = 1.0; }
  void lump_conservative_x_A_x3_conjA_x2([[maybe_unused]] double* gradient) const {
    gradient[0] = 45.0 * a3_2 / (16.0 * omega0_4);  // by omega0
    gradient[2] = -15.0 * a3 / (8.0 * omega0_3);  // by a3
  }
  void lump_h([[maybe_unused]] double* gradient) const { gradient[3] = 1.0; }
  void lump_conservative_x_A_x_F2_of_fundamental([[maybe_unused]] double* gradient) const {
    gradient[0] = h_2 / (4.0 * omega0_4);  // by omega0
    gradient[3] = -h / (6.0 * omega0_3);  // by h
  }

  using Gradient = void (LumpGradients::*)(double*) const;
  static constexpr Gradient gradients[] = {&LumpGradients::lump_conservative_x_A_x3_F, &LumpGradients::lump_mu,
      &LumpGradients::lump_conservative_x_A_x, &LumpGradients::lump_conservative_x_A_x_F2,
      &LumpGradients::lump_dissipative_x_A_x2_conjA_x, &LumpGradients::lump_a3,
      &LumpGradients::lump_conservative_x_A_x3_conjA_x2, &LumpGradients::lump_h,
      &LumpGradients::lump_conservative_x_A_x_F2_of_fundamental};
};

inline constexpr LumpFunctions lump_functions = {lump_values<Lumps>, lump_jacobian<LumpGradients, 4>};

}  // namespace secular::generated::mathieu_duffing
