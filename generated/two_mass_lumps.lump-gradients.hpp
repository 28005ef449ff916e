// Model two_mass_lumps: generated code, never edited by hand.
// Holds derivatives of the lumps by the parameters. Made by: secular generate two_mass_lumps.
#pragma once

#include "two_mass_lumps.hpp"

namespace secular::generated::two_mass_lumps {

/// gradient[p] = derivative of a lump by parameters[p], entries that are not zero. Of lumps with small divisors:
/// f_n are the fractions whose sum the lump is, q_d those of divisor d times its power and inverse, c_n what
/// multiplies a product of coefficients.
struct LumpGradients : Lumps {
  using Lumps::Lumps;

  void lump_mu11([[maybe_unused]] double* gradient) const { gradient[2] = 1.0; }
  void lump_lambda([[maybe_unused]] double* gradient) const { gradient[4] = 1.0; }
  void lump_kappa([[maybe_unused]] double* gradient) const { gradient[6] = 1.0; }
  void lump_mu13([[maybe_unused]] double* gradient) const { gradient[3] = 1.0; }
  void lump_alpha1([[maybe_unused]] double* gradient) const { gradient[5] = 1.0; }
  void lump_q1([[maybe_unused]] double* gradient) const { gradient[8] = 1.0; }
  void lump_p([[maybe_unused]] double* gradient) const { gradient[7] = 1.0; }
  void lump_mu22([[maybe_unused]] double* gradient) const { gradient[9] = 1.0; }
  void lump_mu23([[maybe_unused]] double* gradient) const { gradient[10] = 1.0; }
  void lump_alpha2([[maybe_unused]] double* gradient) const { gradient[11] = 1.0; }
  void lump_q2([[maybe_unused]] double* gradient) const { gradient[12] = 1.0; }

  using Gradient = void (LumpGradients::*)(double*) const;
  static constexpr Gradient gradients[] = {&LumpGradients::lump_mu11, &LumpGradients::lump_lambda,
      &LumpGradients::lump_kappa, &LumpGradients::lump_mu13, &LumpGradients::lump_alpha1, &LumpGradients::lump_q1,
      &LumpGradients::lump_p, &LumpGradients::lump_mu22, &LumpGradients::lump_mu23, &LumpGradients::lump_alpha2,
      &LumpGradients::lump_q2};
};

inline constexpr LumpFunctions lump_functions = {lump_values<Lumps>, lump_jacobian<LumpGradients, 13>};

}  // namespace secular::generated::two_mass_lumps
