// Model van_der_pol: generated code, never edited by hand.
// Holds derivatives of the lumps by the parameters. Made by: secular generate van_der_pol.
#pragma once

#include "van_der_pol.hpp"

namespace secular::generated::van_der_pol {

/// gradient[p] = derivative of a lump by parameters[p], entries that are not zero. Of lumps with small divisors:
/// f_n are the fractions whose sum the lump is, q_d those of divisor d times its power and inverse, c_n what
/// multiplies a product of coefficients.
struct LumpGradients : Lumps {
  using Lumps::Lumps;

  void lump_mu([[maybe_unused]] double* gradient) const { gradient[1] = 1.0; }
  void lump_conservative_x_A_x([[maybe_unused]] double* gradient) const {
    gradient[0] = mu_2 / (8.0 * omega0_2);  // by omega0
    gradient[1] = -mu / (4.0 * omega0);  // by mu
  }
  void lump_dissipative_x_A_x2_conjA_x([[maybe_unused]] double* gradient) const {
    gradient[0] = mu_3 / (2.0 * omega0_3);  // by omega0
    gradient[1] = (-2.0 * omega0_2 - 3.0 * mu_2) / (4.0 * omega0_2);  // by mu
  }
  void lump_dissipative_x_A_x3_conjA_x2([[maybe_unused]] double* gradient) const {
    gradient[0] = -35.0 * mu_3 / (32.0 * omega0_3);  // by omega0
    gradient[1] = 105.0 * mu_2 / (64.0 * omega0_2);  // by mu
  }

  using Gradient = void (LumpGradients::*)(double*) const;
  static constexpr Gradient gradients[] = {&LumpGradients::lump_mu, &LumpGradients::lump_conservative_x_A_x,
      &LumpGradients::lump_dissipative_x_A_x2_conjA_x, &LumpGradients::lump_dissipative_x_A_x3_conjA_x2};
};

inline constexpr LumpFunctions lump_functions = {lump_values<Lumps>, lump_jacobian<LumpGradients, 2>};

}  // namespace secular::generated::van_der_pol
