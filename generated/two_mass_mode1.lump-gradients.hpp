// Model two_mass_mode1: generated code, never edited by hand.
// Holds derivatives of the lumps by the parameters. Made by: secular generate two_mass_mode1.
#pragma once

#include "two_mass_mode1.hpp"

namespace secular::generated::two_mass_mode1 {

/// gradient[p] = derivative of a lump by parameters[p], entries that are not zero. Of lumps with small divisors:
/// f_n are the fractions whose sum the lump is, q_d those of divisor d times its power and inverse, c_n what
/// multiplies a product of coefficients.
struct LumpGradients : Lumps {
  using Lumps::Lumps;

  void lump_mu1([[maybe_unused]] double* gradient) const { gradient[1] = 1.0; }
  void lump_mu2([[maybe_unused]] double* gradient) const { gradient[2] = 1.0; }
  void lump_mu3([[maybe_unused]] double* gradient) const { gradient[3] = 1.0; }
  void lump_alpha_e([[maybe_unused]] double* gradient) const {
    gradient[0] = (3.0 * omega0_4 * delta2_2 - 3.0 * omega0_4 * delta3 + 5.0 * alpha2_2) / (6.0 * omega0_3);
    gradient[4] = (3.0 * omega0_2 * delta2 - 5.0 * alpha2) / (6.0 * omega0_2);  // by alpha2
    gradient[5] = 3.0 / 8.0;  // by alpha3
    gradient[6] = (omega0_2 * delta2 + alpha2) / 2.0;  // by delta2
    gradient[7] = -omega0_2 / 4.0;  // by delta3
  }
  void lump_eta_e([[maybe_unused]] double* gradient) const {
    gradient[0] = -alpha2 * eta1 / (3.0 * omega0_3);  // by omega0
    gradient[4] = eta1 / (6.0 * omega0_2);  // by alpha2
    gradient[6] = -eta1 / 2.0;  // by delta2
    gradient[8] = (-3.0 * omega0_2 * delta2 + alpha2) / (6.0 * omega0_2);  // by eta1
    gradient[9] = 1.0 / 4.0;  // by eta2
  }
  void lump_alpha_0([[maybe_unused]] double* gradient) const {
    gradient[0] = -2.0 * omega0 * delta2;  // by omega0
    gradient[4] = 1.0;  // by alpha2
    gradient[6] = -omega0_2;  // by delta2
  }
  void lump_eta1([[maybe_unused]] double* gradient) const { gradient[8] = 1.0; }
  void lump_alpha_q([[maybe_unused]] double* gradient) const {
    gradient[0] = -6.0 * omega0 * delta2;  // by omega0
    gradient[4] = 1.0;  // by alpha2
    gradient[6] = -3.0 * omega0_2;  // by delta2
  }
  void lump_harmonic_re_v_A_v_F([[maybe_unused]] double* gradient) const {
    gradient[0] = (-14.0 * omega0_2 * delta2 * eta1 + 3.0 * omega0_2 * eta2
        + 4.0 * alpha2 * eta1) / (24.0 * omega0_5);
    gradient[4] = -eta1 / (24.0 * omega0_4);  // by alpha2
    gradient[6] = 7.0 * eta1 / (24.0 * omega0_2);  // by delta2
    gradient[8] = (7.0 * omega0_2 * delta2 - alpha2) / (24.0 * omega0_4);  // by eta1
    gradient[9] = -1.0 / (16.0 * omega0_2);  // by eta2
  }
  void lump_harmonic_re_v_A_v3([[maybe_unused]] double* gradient) const {
    gradient[0] = (20.0 * omega0_2 * alpha2 * delta2 - 3.0 * omega0_2 * alpha3
        - 4.0 * alpha2_2) / (12.0 * omega0_5);
    gradient[4] = (-5.0 * omega0_2 * delta2 + alpha2) / (6.0 * omega0_4);  // by alpha2
    gradient[5] = 1.0 / (8.0 * omega0_2);  // by alpha3
    gradient[6] = (21.0 * omega0_2 * delta2 - 5.0 * alpha2) / (6.0 * omega0_2);  // by delta2
    gradient[7] = -1.0 / 4.0;  // by delta3
  }
  void lump_conservative_v_A_v2_F([[maybe_unused]] double* gradient) const {
    gradient[0] = (omega0_2 * delta2 * eta2 - 5.0 * alpha2 * eta2) / (4.0 * omega0_4);  // by omega0
    gradient[4] = 5.0 * eta2 / (12.0 * omega0_3);  // by alpha2
    gradient[6] = -eta2 / (4.0 * omega0);  // by delta2
    gradient[9] = (-3.0 * omega0_2 * delta2 + 5.0 * alpha2) / (12.0 * omega0_3);  // by eta2
  }
  void lump_conservative_v_A_v_F2([[maybe_unused]] double* gradient) const {
    gradient[0] = eta2_2 / (4.0 * omega0_4);  // by omega0
    gradient[9] = -eta2 / (6.0 * omega0_3);  // by eta2
  }
  void lump_eta2([[maybe_unused]] double* gradient) const { gradient[9] = 1.0; }
  void lump_harmonic_re_v_A_v2_F([[maybe_unused]] double* gradient) const {
    gradient[0] = (-17.0 * omega0_2 * delta2 * eta2 + 6.0 * alpha2 * eta2) / (24.0 * omega0_5);  // by omega0
    gradient[4] = -eta2 / (16.0 * omega0_4);  // by alpha2
    gradient[6] = 17.0 * eta2 / (48.0 * omega0_2);  // by delta2
    gradient[9] = (17.0 * omega0_2 * delta2 - 3.0 * alpha2) / (48.0 * omega0_4);  // by eta2
  }

  using Gradient = void (LumpGradients::*)(double*) const;
  static constexpr Gradient gradients[] = {&LumpGradients::lump_mu1, &LumpGradients::lump_mu2,
      &LumpGradients::lump_mu3, &LumpGradients::lump_alpha_e, &LumpGradients::lump_eta_e,
      &LumpGradients::lump_alpha_0, &LumpGradients::lump_eta1, &LumpGradients::lump_alpha_q,
      &LumpGradients::lump_harmonic_re_v_A_v_F, &LumpGradients::lump_harmonic_re_v_A_v3,
      &LumpGradients::lump_conservative_v_A_v2_F, &LumpGradients::lump_conservative_v_A_v_F2,
      &LumpGradients::lump_eta2, &LumpGradients::lump_harmonic_re_v_A_v2_F};
};

inline constexpr LumpFunctions lump_functions = {lump_values<Lumps>, lump_jacobian<LumpGradients, 10>};

}  // namespace secular::generated::two_mass_mode1
