// Model pendulum: generated code, never edited by hand.
// Holds derivatives of the lumps by the parameters. Made by: secular generate pendulum.
#pragma once

#include "pendulum.hpp"

namespace secular::generated::pendulum {

/// gradient[p] = derivative of a lump by parameters[p], entries that are not zero. Of lumps with small divisors:
/// f_n are the fractions whose sum the lump is, q_d those of divisor d times its power and inverse, c_n what
/// multiplies a product of coefficients.
struct LumpGradients : Lumps {
  using Lumps::Lumps;

  void lump_fc([[maybe_unused]] double* gradient) const { gradient[5] = 1.0; }
  void lump_mu1([[maybe_unused]] double* gradient) const { gradient[3] = 1.0; }
  void lump_mu2([[maybe_unused]] double* gradient) const { gradient[4] = 1.0; }
  void lump_alpha3([[maybe_unused]] double* gradient) const { gradient[1] = 1.0; }
  void lump_beta5([[maybe_unused]] double* gradient) const {
    gradient[0] = 3.0 * alpha3_2 / (8.0 * omega0_3);  // by omega0
    gradient[1] = -3.0 * alpha3 / (8.0 * omega0_2);  // by alpha3
    gradient[2] = 1.0;  // by alpha5
  }
  void lump_harmonic_re_theta_A_theta4_conjA_theta([[maybe_unused]] double* gradient) const {
    gradient[0] = (-20.0 * omega0_2 * alpha5 + 21.0 * alpha3_2) / (16.0 * omega0_5);  // by omega0
    gradient[1] = -21.0 * alpha3 / (32.0 * omega0_4);  // by alpha3
    gradient[2] = 5.0 / (8.0 * omega0_2);  // by alpha5
  }
  void lump_harmonic_re_theta_A_theta5([[maybe_unused]] double* gradient) const {
    gradient[0] = (-4.0 * omega0_2 * alpha5 - 3.0 * alpha3_2) / (48.0 * omega0_5);  // by omega0
    gradient[1] = alpha3 / (32.0 * omega0_4);  // by alpha3
    gradient[2] = 1.0 / (24.0 * omega0_2);  // by alpha5
  }

  using Gradient = void (LumpGradients::*)(double*) const;
  static constexpr Gradient gradients[] = {&LumpGradients::lump_fc, &LumpGradients::lump_mu1,
      &LumpGradients::lump_mu2, &LumpGradients::lump_alpha3, &LumpGradients::lump_beta5,
      &LumpGradients::lump_harmonic_re_theta_A_theta4_conjA_theta, &LumpGradients::lump_harmonic_re_theta_A_theta5};
};

inline constexpr LumpFunctions lump_functions = {lump_values<Lumps>, lump_jacobian<LumpGradients, 6>};

}  // namespace secular::generated::pendulum
