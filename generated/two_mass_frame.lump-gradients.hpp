// Model two_mass_frame: generated code, never edited by hand.
// Holds derivatives of the lumps by the parameters. Made by: secular generate two_mass_frame.
#pragma once

#include "two_mass_frame.hpp"

namespace secular::generated::two_mass_frame {

/// gradient[p] = derivative of a lump by parameters[p], entries that are not zero. Of lumps with small divisors:
/// f_n are the fractions whose sum the lump is, q_d those of divisor d times its power and inverse, c_n what
/// multiplies a product of coefficients.
struct LumpGradients : Lumps {
  using Lumps::Lumps;

  void lump_mu1([[maybe_unused]] double* gradient) const { gradient[14] = 1.0; }
  void lump_conservative_v1_A_v1_A_v2_conjA_v2([[maybe_unused]] double* gradient) const {
    gradient[0] = (-252.0 * omega1_2 * m1 * p11_2 * p12_2 * h1 * h2_3
        - 252.0 * omega1_2 * p11_2 * p12_2 * h1_3 * m2 * h2 - 504.0 * omega1_2 * p11_2 * p12_2 * h1_2 * m2 * h2_2
        - 252.0 * omega1_2 * p11_2 * p12_2 * h1 * m2 * h2_3 + 504.0 * omega1_2 * p11_2 * p12 * h1_3 * m2 * p22 * h2
        + 504.0 * omega1_2 * p11_2 * p12 * h1_2 * m2 * p22 * h2_2
        - 252.0 * omega1_2 * p11_2 * h1_3 * m2 * p22_2 * h2 + 504.0 * omega1_2 * p11 * p12_2 * h1_3 * m2 * p21 * h2
        + 504.0 * omega1_2 * p11 * p12_2 * h1_2 * m2 * p21 * h2_2
        - 1008.0 * omega1_2 * p11 * p12 * h1_3 * m2 * p21 * p22 * h2
        - 504.0 * omega1_2 * p11 * p12 * h1_2 * m2 * p21 * p22 * h2_2
        + 504.0 * omega1_2 * p11 * h1_3 * m2 * p21 * p22_2 * h2 - 252.0 * omega1_2 * p12_2 * h1_3 * m2 * p21_2 * h2
        + 504.0 * omega1_2 * p12 * h1_3 * m2 * p21_2 * p22 * h2 - 252.0 * omega1_2 * h1_3 * m2 * p21_2 * p22_2 * h2
        + 252.0 * omega2_2 * m1 * p11_2 * p12_2 * h1 * h2_3 + 252.0 * omega2_2 * p11_2 * p12_2 * h1_3 * m2 * h2
        + 504.0 * omega2_2 * p11_2 * p12_2 * h1_2 * m2 * h2_2 + 252.0 * omega2_2 * p11_2 * p12_2 * h1 * m2 * h2_3
        - 504.0 * omega2_2 * p11_2 * p12 * h1_3 * m2 * p22 * h2
        - 504.0 * omega2_2 * p11_2 * p12 * h1_2 * m2 * p22 * h2_2
        + 252.0 * omega2_2 * p11_2 * h1_3 * m2 * p22_2 * h2 - 504.0 * omega2_2 * p11 * p12_2 * h1_3 * m2 * p21 * h2
        - 504.0 * omega2_2 * p11 * p12_2 * h1_2 * m2 * p21 * h2_2
        + 1008.0 * omega2_2 * p11 * p12 * h1_3 * m2 * p21 * p22 * h2
        + 504.0 * omega2_2 * p11 * p12 * h1_2 * m2 * p21 * p22 * h2_2
        - 504.0 * omega2_2 * p11 * h1_3 * m2 * p21 * p22_2 * h2 + 252.0 * omega2_2 * p12_2 * h1_3 * m2 * p21_2 * h2
        - 504.0 * omega2_2 * p12 * h1_3 * m2 * p21_2 * p22 * h2 + 252.0 * omega2_2 * h1_3 * m2 * p21_2 * p22_2 * h2
        + 540.0 * m1 * p11_2 * p12_2 * h2_3 * g + 540.0 * p11_2 * p12_2 * h1_3 * m2 * g
        - 540.0 * p11_2 * p12_2 * h1_3 * h2 * k2 - 540.0 * p11_2 * p12_2 * h1 * h2_3 * k1
        + 540.0 * p11_2 * p12_2 * m2 * h2_3 * g - 1080.0 * p11_2 * p12 * h1_3 * m2 * p22 * g
        + 1080.0 * p11_2 * p12 * h1_3 * p22 * h2 * k2 + 540.0 * p11_2 * h1_3 * m2 * p22_2 * g
        - 540.0 * p11_2 * h1_3 * p22_2 * h2 * k2 - 1080.0 * p11 * p12_2 * h1_3 * m2 * p21 * g
        + 1080.0 * p11 * p12_2 * h1_3 * p21 * h2 * k2 + 2160.0 * p11 * p12 * h1_3 * m2 * p21 * p22 * g
        - 2160.0 * p11 * p12 * h1_3 * p21 * p22 * h2 * k2 - 1080.0 * p11 * h1_3 * m2 * p21 * p22_2 * g
        + 1080.0 * p11 * h1_3 * p21 * p22_2 * h2 * k2 + 540.0 * p12_2 * h1_3 * m2 * p21_2 * g
        - 540.0 * p12_2 * h1_3 * p21_2 * h2 * k2 - 1080.0 * p12 * h1_3 * m2 * p21_2 * p22 * g
        + 1080.0 * p12 * h1_3 * p21_2 * p22 * h2 * k2 + 540.0 * h1_3 * m2 * p21_2 * p22_2 * g
        - 540.0 * h1_3 * p21_2 * p22_2 * h2 * k2) / (175.0 * omega1_2 * h1_3 * h2_3);
    gradient[1] = (-72.0 * omega2 * m1 * p11_2 * p12_2 * h2_2 - 72.0 * omega2 * p11_2 * p12_2 * h1_2 * m2
        - 144.0 * omega2 * p11_2 * p12_2 * h1 * m2 * h2 - 72.0 * omega2 * p11_2 * p12_2 * m2 * h2_2
        + 144.0 * omega2 * p11_2 * p12 * h1_2 * m2 * p22 + 144.0 * omega2 * p11_2 * p12 * h1 * m2 * p22 * h2
        - 72.0 * omega2 * p11_2 * h1_2 * m2 * p22_2 + 144.0 * omega2 * p11 * p12_2 * h1_2 * m2 * p21
        + 144.0 * omega2 * p11 * p12_2 * h1 * m2 * p21 * h2 - 288.0 * omega2 * p11 * p12 * h1_2 * m2 * p21 * p22
        - 144.0 * omega2 * p11 * p12 * h1 * m2 * p21 * p22 * h2 + 144.0 * omega2 * p11 * h1_2 * m2 * p21 * p22_2
        - 72.0 * omega2 * p12_2 * h1_2 * m2 * p21_2 + 144.0 * omega2 * p12 * h1_2 * m2 * p21_2 * p22
        - 72.0 * omega2 * h1_2 * m2 * p21_2 * p22_2) / (25.0 * omega1 * h1_2 * h2_2);
    gradient[2] = (-252.0 * omega1_2 * p11_2 * p12_2 * h1 - 252.0 * omega2_2 * p11_2 * p12_2 * h1
        - 540.0 * p11_2 * p12_2 * g) / (175.0 * omega1 * h1_3);
    gradient[3] = (-504.0 * omega1_2 * m1 * p11 * p12_2 * h1 * h2_3
        - 504.0 * omega1_2 * p11 * p12_2 * h1_3 * m2 * h2 - 1008.0 * omega1_2 * p11 * p12_2 * h1_2 * m2 * h2_2
        - 504.0 * omega1_2 * p11 * p12_2 * h1 * m2 * h2_3 + 1008.0 * omega1_2 * p11 * p12 * h1_3 * m2 * p22 * h2
        + 1008.0 * omega1_2 * p11 * p12 * h1_2 * m2 * p22 * h2_2 - 504.0 * omega1_2 * p11 * h1_3 * m2 * p22_2 * h2
        + 504.0 * omega1_2 * p12_2 * h1_3 * m2 * p21 * h2 + 504.0 * omega1_2 * p12_2 * h1_2 * m2 * p21 * h2_2
        - 1008.0 * omega1_2 * p12 * h1_3 * m2 * p21 * p22 * h2
        - 504.0 * omega1_2 * p12 * h1_2 * m2 * p21 * p22 * h2_2 + 504.0 * omega1_2 * h1_3 * m2 * p21 * p22_2 * h2
        - 504.0 * omega2_2 * m1 * p11 * p12_2 * h1 * h2_3 - 504.0 * omega2_2 * p11 * p12_2 * h1_3 * m2 * h2
        - 1008.0 * omega2_2 * p11 * p12_2 * h1_2 * m2 * h2_2 - 504.0 * omega2_2 * p11 * p12_2 * h1 * m2 * h2_3
        + 1008.0 * omega2_2 * p11 * p12 * h1_3 * m2 * p22 * h2
        + 1008.0 * omega2_2 * p11 * p12 * h1_2 * m2 * p22 * h2_2 - 504.0 * omega2_2 * p11 * h1_3 * m2 * p22_2 * h2
        + 504.0 * omega2_2 * p12_2 * h1_3 * m2 * p21 * h2 + 504.0 * omega2_2 * p12_2 * h1_2 * m2 * p21 * h2_2
        - 1008.0 * omega2_2 * p12 * h1_3 * m2 * p21 * p22 * h2
        - 504.0 * omega2_2 * p12 * h1_2 * m2 * p21 * p22 * h2_2 + 504.0 * omega2_2 * h1_3 * m2 * p21 * p22_2 * h2
        - 1080.0 * m1 * p11 * p12_2 * h2_3 * g - 1080.0 * p11 * p12_2 * h1_3 * m2 * g
        + 1080.0 * p11 * p12_2 * h1_3 * h2 * k2 + 1080.0 * p11 * p12_2 * h1 * h2_3 * k1
        - 1080.0 * p11 * p12_2 * m2 * h2_3 * g + 2160.0 * p11 * p12 * h1_3 * m2 * p22 * g
        - 2160.0 * p11 * p12 * h1_3 * p22 * h2 * k2 - 1080.0 * p11 * h1_3 * m2 * p22_2 * g
        + 1080.0 * p11 * h1_3 * p22_2 * h2 * k2 + 1080.0 * p12_2 * h1_3 * m2 * p21 * g
        - 1080.0 * p12_2 * h1_3 * p21 * h2 * k2 - 2160.0 * p12 * h1_3 * m2 * p21 * p22 * g
        + 2160.0 * p12 * h1_3 * p21 * p22 * h2 * k2 + 1080.0 * h1_3 * m2 * p21 * p22_2 * g
        - 1080.0 * h1_3 * p21 * p22_2 * h2 * k2) / (175.0 * omega1 * h1_3 * h2_3);
    gradient[4] = (-504.0 * omega1_2 * m1 * p11_2 * p12 * h1 * h2_3
        - 504.0 * omega1_2 * p11_2 * p12 * h1_3 * m2 * h2 - 1008.0 * omega1_2 * p11_2 * p12 * h1_2 * m2 * h2_2
        - 504.0 * omega1_2 * p11_2 * p12 * h1 * m2 * h2_3 + 504.0 * omega1_2 * p11_2 * h1_3 * m2 * p22 * h2
        + 504.0 * omega1_2 * p11_2 * h1_2 * m2 * p22 * h2_2 + 1008.0 * omega1_2 * p11 * p12 * h1_3 * m2 * p21 * h2
        + 1008.0 * omega1_2 * p11 * p12 * h1_2 * m2 * p21 * h2_2
        - 1008.0 * omega1_2 * p11 * h1_3 * m2 * p21 * p22 * h2
        - 504.0 * omega1_2 * p11 * h1_2 * m2 * p21 * p22 * h2_2 - 504.0 * omega1_2 * p12 * h1_3 * m2 * p21_2 * h2
        + 504.0 * omega1_2 * h1_3 * m2 * p21_2 * p22 * h2 - 504.0 * omega2_2 * m1 * p11_2 * p12 * h1 * h2_3
        - 504.0 * omega2_2 * p11_2 * p12 * h1_3 * m2 * h2 - 1008.0 * omega2_2 * p11_2 * p12 * h1_2 * m2 * h2_2
        - 504.0 * omega2_2 * p11_2 * p12 * h1 * m2 * h2_3 + 504.0 * omega2_2 * p11_2 * h1_3 * m2 * p22 * h2
        + 504.0 * omega2_2 * p11_2 * h1_2 * m2 * p22 * h2_2 + 1008.0 * omega2_2 * p11 * p12 * h1_3 * m2 * p21 * h2
        + 1008.0 * omega2_2 * p11 * p12 * h1_2 * m2 * p21 * h2_2
        - 1008.0 * omega2_2 * p11 * h1_3 * m2 * p21 * p22 * h2
        - 504.0 * omega2_2 * p11 * h1_2 * m2 * p21 * p22 * h2_2 - 504.0 * omega2_2 * p12 * h1_3 * m2 * p21_2 * h2
        + 504.0 * omega2_2 * h1_3 * m2 * p21_2 * p22 * h2 - 1080.0 * m1 * p11_2 * p12 * h2_3 * g
        - 1080.0 * p11_2 * p12 * h1_3 * m2 * g + 1080.0 * p11_2 * p12 * h1_3 * h2 * k2
        + 1080.0 * p11_2 * p12 * h1 * h2_3 * k1 - 1080.0 * p11_2 * p12 * m2 * h2_3 * g
        + 1080.0 * p11_2 * h1_3 * m2 * p22 * g - 1080.0 * p11_2 * h1_3 * p22 * h2 * k2
        + 2160.0 * p11 * p12 * h1_3 * m2 * p21 * g - 2160.0 * p11 * p12 * h1_3 * p21 * h2 * k2
        - 2160.0 * p11 * h1_3 * m2 * p21 * p22 * g + 2160.0 * p11 * h1_3 * p21 * p22 * h2 * k2
        - 1080.0 * p12 * h1_3 * m2 * p21_2 * g + 1080.0 * p12 * h1_3 * p21_2 * h2 * k2
        + 1080.0 * h1_3 * m2 * p21_2 * p22 * g
        - 1080.0 * h1_3 * p21_2 * p22 * h2 * k2) / (175.0 * omega1 * h1_3 * h2_3);
    gradient[5] = (504.0 * omega1_2 * m1 * p11_2 * p12_2 * h1 * h2 + 504.0 * omega1_2 * p11_2 * p12_2 * h1_2 * m2
        + 504.0 * omega1_2 * p11_2 * p12_2 * h1 * m2 * h2 - 504.0 * omega1_2 * p11_2 * p12 * h1_2 * m2 * p22
        - 504.0 * omega1_2 * p11 * p12_2 * h1_2 * m2 * p21 + 504.0 * omega1_2 * p11 * p12 * h1_2 * m2 * p21 * p22
        + 504.0 * omega2_2 * m1 * p11_2 * p12_2 * h1 * h2 + 504.0 * omega2_2 * p11_2 * p12_2 * h1_2 * m2
        + 504.0 * omega2_2 * p11_2 * p12_2 * h1 * m2 * h2 - 504.0 * omega2_2 * p11_2 * p12 * h1_2 * m2 * p22
        - 504.0 * omega2_2 * p11 * p12_2 * h1_2 * m2 * p21 + 504.0 * omega2_2 * p11 * p12 * h1_2 * m2 * p21 * p22
        + 1620.0 * m1 * p11_2 * p12_2 * h2 * g - 1080.0 * p11_2 * p12_2 * h1 * h2 * k1
        + 1620.0 * p11_2 * p12_2 * m2 * h2 * g) / (175.0 * omega1 * h1_4 * h2);
    gradient[6] = (-252.0 * omega1_2 * p11_2 * p12_2 * h1_3 * h2 - 504.0 * omega1_2 * p11_2 * p12_2 * h1_2 * h2_2
        - 252.0 * omega1_2 * p11_2 * p12_2 * h1 * h2_3 + 504.0 * omega1_2 * p11_2 * p12 * h1_3 * p22 * h2
        + 504.0 * omega1_2 * p11_2 * p12 * h1_2 * p22 * h2_2 - 252.0 * omega1_2 * p11_2 * h1_3 * p22_2 * h2
        + 504.0 * omega1_2 * p11 * p12_2 * h1_3 * p21 * h2 + 504.0 * omega1_2 * p11 * p12_2 * h1_2 * p21 * h2_2
        - 1008.0 * omega1_2 * p11 * p12 * h1_3 * p21 * p22 * h2
        - 504.0 * omega1_2 * p11 * p12 * h1_2 * p21 * p22 * h2_2 + 504.0 * omega1_2 * p11 * h1_3 * p21 * p22_2 * h2
        - 252.0 * omega1_2 * p12_2 * h1_3 * p21_2 * h2 + 504.0 * omega1_2 * p12 * h1_3 * p21_2 * p22 * h2
        - 252.0 * omega1_2 * h1_3 * p21_2 * p22_2 * h2 - 252.0 * omega2_2 * p11_2 * p12_2 * h1_3 * h2
        - 504.0 * omega2_2 * p11_2 * p12_2 * h1_2 * h2_2 - 252.0 * omega2_2 * p11_2 * p12_2 * h1 * h2_3
        + 504.0 * omega2_2 * p11_2 * p12 * h1_3 * p22 * h2 + 504.0 * omega2_2 * p11_2 * p12 * h1_2 * p22 * h2_2
        - 252.0 * omega2_2 * p11_2 * h1_3 * p22_2 * h2 + 504.0 * omega2_2 * p11 * p12_2 * h1_3 * p21 * h2
        + 504.0 * omega2_2 * p11 * p12_2 * h1_2 * p21 * h2_2 - 1008.0 * omega2_2 * p11 * p12 * h1_3 * p21 * p22 * h2
        - 504.0 * omega2_2 * p11 * p12 * h1_2 * p21 * p22 * h2_2 + 504.0 * omega2_2 * p11 * h1_3 * p21 * p22_2 * h2
        - 252.0 * omega2_2 * p12_2 * h1_3 * p21_2 * h2 + 504.0 * omega2_2 * p12 * h1_3 * p21_2 * p22 * h2
        - 252.0 * omega2_2 * h1_3 * p21_2 * p22_2 * h2 - 540.0 * p11_2 * p12_2 * h1_3 * g
        - 540.0 * p11_2 * p12_2 * h2_3 * g + 1080.0 * p11_2 * p12 * h1_3 * p22 * g
        - 540.0 * p11_2 * h1_3 * p22_2 * g + 1080.0 * p11 * p12_2 * h1_3 * p21 * g
        - 2160.0 * p11 * p12 * h1_3 * p21 * p22 * g + 1080.0 * p11 * h1_3 * p21 * p22_2 * g
        - 540.0 * p12_2 * h1_3 * p21_2 * g + 1080.0 * p12 * h1_3 * p21_2 * p22 * g
        - 540.0 * h1_3 * p21_2 * p22_2 * g) / (175.0 * omega1 * h1_3 * h2_3);
    gradient[7] = (504.0 * omega1_2 * p11 * p12_2 * h1 * m2 * h2 + 504.0 * omega1_2 * p11 * p12_2 * m2 * h2_2
        - 1008.0 * omega1_2 * p11 * p12 * h1 * m2 * p22 * h2 - 504.0 * omega1_2 * p11 * p12 * m2 * p22 * h2_2
        + 504.0 * omega1_2 * p11 * h1 * m2 * p22_2 * h2 - 504.0 * omega1_2 * p12_2 * h1 * m2 * p21 * h2
        + 1008.0 * omega1_2 * p12 * h1 * m2 * p21 * p22 * h2 - 504.0 * omega1_2 * h1 * m2 * p21 * p22_2 * h2
        + 504.0 * omega2_2 * p11 * p12_2 * h1 * m2 * h2 + 504.0 * omega2_2 * p11 * p12_2 * m2 * h2_2
        - 1008.0 * omega2_2 * p11 * p12 * h1 * m2 * p22 * h2 - 504.0 * omega2_2 * p11 * p12 * m2 * p22 * h2_2
        + 504.0 * omega2_2 * p11 * h1 * m2 * p22_2 * h2 - 504.0 * omega2_2 * p12_2 * h1 * m2 * p21 * h2
        + 1008.0 * omega2_2 * p12 * h1 * m2 * p21 * p22 * h2 - 504.0 * omega2_2 * h1 * m2 * p21 * p22_2 * h2
        + 1080.0 * p11 * p12_2 * h1 * m2 * g - 1080.0 * p11 * p12_2 * h1 * h2 * k2
        - 2160.0 * p11 * p12 * h1 * m2 * p22 * g + 2160.0 * p11 * p12 * h1 * p22 * h2 * k2
        + 1080.0 * p11 * h1 * m2 * p22_2 * g - 1080.0 * p11 * h1 * p22_2 * h2 * k2
        - 1080.0 * p12_2 * h1 * m2 * p21 * g + 1080.0 * p12_2 * h1 * p21 * h2 * k2
        + 2160.0 * p12 * h1 * m2 * p21 * p22 * g - 2160.0 * p12 * h1 * p21 * p22 * h2 * k2
        - 1080.0 * h1 * m2 * p21 * p22_2 * g + 1080.0 * h1 * p21 * p22_2 * h2 * k2) / (175.0 * omega1 * h1 * h2_3);
    gradient[8] = (504.0 * omega1_2 * p11_2 * p12 * h1 * m2 * h2 + 504.0 * omega1_2 * p11_2 * p12 * m2 * h2_2
        - 504.0 * omega1_2 * p11_2 * h1 * m2 * p22 * h2 - 1008.0 * omega1_2 * p11 * p12 * h1 * m2 * p21 * h2
        - 504.0 * omega1_2 * p11 * p12 * m2 * p21 * h2_2 + 1008.0 * omega1_2 * p11 * h1 * m2 * p21 * p22 * h2
        + 504.0 * omega1_2 * p12 * h1 * m2 * p21_2 * h2 - 504.0 * omega1_2 * h1 * m2 * p21_2 * p22 * h2
        + 504.0 * omega2_2 * p11_2 * p12 * h1 * m2 * h2 + 504.0 * omega2_2 * p11_2 * p12 * m2 * h2_2
        - 504.0 * omega2_2 * p11_2 * h1 * m2 * p22 * h2 - 1008.0 * omega2_2 * p11 * p12 * h1 * m2 * p21 * h2
        - 504.0 * omega2_2 * p11 * p12 * m2 * p21 * h2_2 + 1008.0 * omega2_2 * p11 * h1 * m2 * p21 * p22 * h2
        + 504.0 * omega2_2 * p12 * h1 * m2 * p21_2 * h2 - 504.0 * omega2_2 * h1 * m2 * p21_2 * p22 * h2
        + 1080.0 * p11_2 * p12 * h1 * m2 * g - 1080.0 * p11_2 * p12 * h1 * h2 * k2
        - 1080.0 * p11_2 * h1 * m2 * p22 * g + 1080.0 * p11_2 * h1 * p22 * h2 * k2
        - 2160.0 * p11 * p12 * h1 * m2 * p21 * g + 2160.0 * p11 * p12 * h1 * p21 * h2 * k2
        + 2160.0 * p11 * h1 * m2 * p21 * p22 * g - 2160.0 * p11 * h1 * p21 * p22 * h2 * k2
        + 1080.0 * p12 * h1 * m2 * p21_2 * g - 1080.0 * p12 * h1 * p21_2 * h2 * k2
        - 1080.0 * h1 * m2 * p21_2 * p22 * g + 1080.0 * h1 * p21_2 * p22 * h2 * k2) / (175.0 * omega1 * h1 * h2_3);
    gradient[9] = (504.0 * omega1_2 * p11_2 * p12_2 * h1 * m2 * h2 + 504.0 * omega1_2 * p11_2 * p12_2 * m2 * h2_2
        - 1008.0 * omega1_2 * p11_2 * p12 * h1 * m2 * p22 * h2 - 504.0 * omega1_2 * p11_2 * p12 * m2 * p22 * h2_2
        + 504.0 * omega1_2 * p11_2 * h1 * m2 * p22_2 * h2 - 1008.0 * omega1_2 * p11 * p12_2 * h1 * m2 * p21 * h2
        - 504.0 * omega1_2 * p11 * p12_2 * m2 * p21 * h2_2
        + 2016.0 * omega1_2 * p11 * p12 * h1 * m2 * p21 * p22 * h2
        + 504.0 * omega1_2 * p11 * p12 * m2 * p21 * p22 * h2_2
        - 1008.0 * omega1_2 * p11 * h1 * m2 * p21 * p22_2 * h2 + 504.0 * omega1_2 * p12_2 * h1 * m2 * p21_2 * h2
        - 1008.0 * omega1_2 * p12 * h1 * m2 * p21_2 * p22 * h2 + 504.0 * omega1_2 * h1 * m2 * p21_2 * p22_2 * h2
        + 504.0 * omega2_2 * p11_2 * p12_2 * h1 * m2 * h2 + 504.0 * omega2_2 * p11_2 * p12_2 * m2 * h2_2
        - 1008.0 * omega2_2 * p11_2 * p12 * h1 * m2 * p22 * h2 - 504.0 * omega2_2 * p11_2 * p12 * m2 * p22 * h2_2
        + 504.0 * omega2_2 * p11_2 * h1 * m2 * p22_2 * h2 - 1008.0 * omega2_2 * p11 * p12_2 * h1 * m2 * p21 * h2
        - 504.0 * omega2_2 * p11 * p12_2 * m2 * p21 * h2_2
        + 2016.0 * omega2_2 * p11 * p12 * h1 * m2 * p21 * p22 * h2
        + 504.0 * omega2_2 * p11 * p12 * m2 * p21 * p22 * h2_2
        - 1008.0 * omega2_2 * p11 * h1 * m2 * p21 * p22_2 * h2 + 504.0 * omega2_2 * p12_2 * h1 * m2 * p21_2 * h2
        - 1008.0 * omega2_2 * p12 * h1 * m2 * p21_2 * p22 * h2 + 504.0 * omega2_2 * h1 * m2 * p21_2 * p22_2 * h2
        + 1620.0 * p11_2 * p12_2 * h1 * m2 * g - 1080.0 * p11_2 * p12_2 * h1 * h2 * k2
        - 3240.0 * p11_2 * p12 * h1 * m2 * p22 * g + 2160.0 * p11_2 * p12 * h1 * p22 * h2 * k2
        + 1620.0 * p11_2 * h1 * m2 * p22_2 * g - 1080.0 * p11_2 * h1 * p22_2 * h2 * k2
        - 3240.0 * p11 * p12_2 * h1 * m2 * p21 * g + 2160.0 * p11 * p12_2 * h1 * p21 * h2 * k2
        + 6480.0 * p11 * p12 * h1 * m2 * p21 * p22 * g - 4320.0 * p11 * p12 * h1 * p21 * p22 * h2 * k2
        - 3240.0 * p11 * h1 * m2 * p21 * p22_2 * g + 2160.0 * p11 * h1 * p21 * p22_2 * h2 * k2
        + 1620.0 * p12_2 * h1 * m2 * p21_2 * g - 1080.0 * p12_2 * h1 * p21_2 * h2 * k2
        - 3240.0 * p12 * h1 * m2 * p21_2 * p22 * g + 2160.0 * p12 * h1 * p21_2 * p22 * h2 * k2
        + 1620.0 * h1 * m2 * p21_2 * p22_2 * g
        - 1080.0 * h1 * p21_2 * p22_2 * h2 * k2) / (175.0 * omega1 * h1 * h2_4);
    gradient[10] = 108.0 * p11_2 * p12_2 / (35.0 * omega1 * h1_2);  // by k1
    gradient[11] = (108.0 * p11_2 * p12_2 - 216.0 * p11_2 * p12 * p22 + 108.0 * p11_2 * p22_2
        - 216.0 * p11 * p12_2 * p21 + 432.0 * p11 * p12 * p21 * p22 - 216.0 * p11 * p21 * p22_2
        + 108.0 * p12_2 * p21_2 - 216.0 * p12 * p21_2 * p22 + 108.0 * p21_2 * p22_2) / (35.0 * omega1 * h2_2);
    gradient[12] = (-108.0 * m1 * p11_2 * p12_2 * h2_3 - 108.0 * p11_2 * p12_2 * h1_3 * m2
        - 108.0 * p11_2 * p12_2 * m2 * h2_3 + 216.0 * p11_2 * p12 * h1_3 * m2 * p22
        - 108.0 * p11_2 * h1_3 * m2 * p22_2 + 216.0 * p11 * p12_2 * h1_3 * m2 * p21
        - 432.0 * p11 * p12 * h1_3 * m2 * p21 * p22 + 216.0 * p11 * h1_3 * m2 * p21 * p22_2
        - 108.0 * p12_2 * h1_3 * m2 * p21_2 + 216.0 * p12 * h1_3 * m2 * p21_2 * p22
        - 108.0 * h1_3 * m2 * p21_2 * p22_2) / (35.0 * omega1 * h1_3 * h2_3);
  }
  void lump_conservative_v1_A_v12_conjA_v1([[maybe_unused]] double* gradient) const {
    gradient[0] = (-252.0 * omega1_2 * m1 * p11_4 * h1 * h2_3 - 252.0 * omega1_2 * p11_4 * h1_3 * m2 * h2
        - 504.0 * omega1_2 * p11_4 * h1_2 * m2 * h2_2 - 252.0 * omega1_2 * p11_4 * h1 * m2 * h2_3
        + 1008.0 * omega1_2 * p11_3 * h1_3 * m2 * p21 * h2 + 1008.0 * omega1_2 * p11_3 * h1_2 * m2 * p21 * h2_2
        - 1512.0 * omega1_2 * p11_2 * h1_3 * m2 * p21_2 * h2 - 504.0 * omega1_2 * p11_2 * h1_2 * m2 * p21_2 * h2_2
        + 1008.0 * omega1_2 * p11 * h1_3 * m2 * p21_3 * h2 - 252.0 * omega1_2 * h1_3 * m2 * p21_4 * h2
        + 270.0 * m1 * p11_4 * h2_3 * g + 270.0 * p11_4 * h1_3 * m2 * g - 270.0 * p11_4 * h1_3 * h2 * k2
        - 270.0 * p11_4 * h1 * h2_3 * k1 + 270.0 * p11_4 * m2 * h2_3 * g - 1080.0 * p11_3 * h1_3 * m2 * p21 * g
        + 1080.0 * p11_3 * h1_3 * p21 * h2 * k2 + 1620.0 * p11_2 * h1_3 * m2 * p21_2 * g
        - 1620.0 * p11_2 * h1_3 * p21_2 * h2 * k2 - 1080.0 * p11 * h1_3 * m2 * p21_3 * g
        + 1080.0 * p11 * h1_3 * p21_3 * h2 * k2 + 270.0 * h1_3 * m2 * p21_4 * g
        - 270.0 * h1_3 * p21_4 * h2 * k2) / (175.0 * omega1_2 * h1_3 * h2_3);
    gradient[2] = (-252.0 * omega1_2 * p11_4 * h1 - 270.0 * p11_4 * g) / (175.0 * omega1 * h1_3);  // by m1
    gradient[3] = (-1008.0 * omega1_2 * m1 * p11_3 * h1 * h2_3 - 1008.0 * omega1_2 * p11_3 * h1_3 * m2 * h2
        - 2016.0 * omega1_2 * p11_3 * h1_2 * m2 * h2_2 - 1008.0 * omega1_2 * p11_3 * h1 * m2 * h2_3
        + 3024.0 * omega1_2 * p11_2 * h1_3 * m2 * p21 * h2 + 3024.0 * omega1_2 * p11_2 * h1_2 * m2 * p21 * h2_2
        - 3024.0 * omega1_2 * p11 * h1_3 * m2 * p21_2 * h2 - 1008.0 * omega1_2 * p11 * h1_2 * m2 * p21_2 * h2_2
        + 1008.0 * omega1_2 * h1_3 * m2 * p21_3 * h2 - 1080.0 * m1 * p11_3 * h2_3 * g
        - 1080.0 * p11_3 * h1_3 * m2 * g + 1080.0 * p11_3 * h1_3 * h2 * k2 + 1080.0 * p11_3 * h1 * h2_3 * k1
        - 1080.0 * p11_3 * m2 * h2_3 * g + 3240.0 * p11_2 * h1_3 * m2 * p21 * g
        - 3240.0 * p11_2 * h1_3 * p21 * h2 * k2 - 3240.0 * p11 * h1_3 * m2 * p21_2 * g
        + 3240.0 * p11 * h1_3 * p21_2 * h2 * k2 + 1080.0 * h1_3 * m2 * p21_3 * g
        - 1080.0 * h1_3 * p21_3 * h2 * k2) / (175.0 * omega1 * h1_3 * h2_3);
    gradient[5] = (504.0 * omega1_2 * m1 * p11_4 * h1 * h2 + 504.0 * omega1_2 * p11_4 * h1_2 * m2
        + 504.0 * omega1_2 * p11_4 * h1 * m2 * h2 - 1008.0 * omega1_2 * p11_3 * h1_2 * m2 * p21
        + 504.0 * omega1_2 * p11_2 * h1_2 * m2 * p21_2 + 810.0 * m1 * p11_4 * h2 * g - 540.0 * p11_4 * h1 * h2 * k1
        + 810.0 * p11_4 * m2 * h2 * g) / (175.0 * omega1 * h1_4 * h2);
    gradient[6] = (-252.0 * omega1_2 * p11_4 * h1_3 * h2 - 504.0 * omega1_2 * p11_4 * h1_2 * h2_2
        - 252.0 * omega1_2 * p11_4 * h1 * h2_3 + 1008.0 * omega1_2 * p11_3 * h1_3 * p21 * h2
        + 1008.0 * omega1_2 * p11_3 * h1_2 * p21 * h2_2 - 1512.0 * omega1_2 * p11_2 * h1_3 * p21_2 * h2
        - 504.0 * omega1_2 * p11_2 * h1_2 * p21_2 * h2_2 + 1008.0 * omega1_2 * p11 * h1_3 * p21_3 * h2
        - 252.0 * omega1_2 * h1_3 * p21_4 * h2 - 270.0 * p11_4 * h1_3 * g - 270.0 * p11_4 * h2_3 * g
        + 1080.0 * p11_3 * h1_3 * p21 * g - 1620.0 * p11_2 * h1_3 * p21_2 * g + 1080.0 * p11 * h1_3 * p21_3 * g
        - 270.0 * h1_3 * p21_4 * g) / (175.0 * omega1 * h1_3 * h2_3);
    gradient[7] = (1008.0 * omega1_2 * p11_3 * h1 * m2 * h2 + 1008.0 * omega1_2 * p11_3 * m2 * h2_2
        - 3024.0 * omega1_2 * p11_2 * h1 * m2 * p21 * h2 - 1008.0 * omega1_2 * p11_2 * m2 * p21 * h2_2
        + 3024.0 * omega1_2 * p11 * h1 * m2 * p21_2 * h2 - 1008.0 * omega1_2 * h1 * m2 * p21_3 * h2
        + 1080.0 * p11_3 * h1 * m2 * g - 1080.0 * p11_3 * h1 * h2 * k2 - 3240.0 * p11_2 * h1 * m2 * p21 * g
        + 3240.0 * p11_2 * h1 * p21 * h2 * k2 + 3240.0 * p11 * h1 * m2 * p21_2 * g
        - 3240.0 * p11 * h1 * p21_2 * h2 * k2 - 1080.0 * h1 * m2 * p21_3 * g
        + 1080.0 * h1 * p21_3 * h2 * k2) / (175.0 * omega1 * h1 * h2_3);
    gradient[9] = (504.0 * omega1_2 * p11_4 * h1 * m2 * h2 + 504.0 * omega1_2 * p11_4 * m2 * h2_2
        - 2016.0 * omega1_2 * p11_3 * h1 * m2 * p21 * h2 - 1008.0 * omega1_2 * p11_3 * m2 * p21 * h2_2
        + 3024.0 * omega1_2 * p11_2 * h1 * m2 * p21_2 * h2 + 504.0 * omega1_2 * p11_2 * m2 * p21_2 * h2_2
        - 2016.0 * omega1_2 * p11 * h1 * m2 * p21_3 * h2 + 504.0 * omega1_2 * h1 * m2 * p21_4 * h2
        + 810.0 * p11_4 * h1 * m2 * g - 540.0 * p11_4 * h1 * h2 * k2 - 3240.0 * p11_3 * h1 * m2 * p21 * g
        + 2160.0 * p11_3 * h1 * p21 * h2 * k2 + 4860.0 * p11_2 * h1 * m2 * p21_2 * g
        - 3240.0 * p11_2 * h1 * p21_2 * h2 * k2 - 3240.0 * p11 * h1 * m2 * p21_3 * g
        + 2160.0 * p11 * h1 * p21_3 * h2 * k2 + 810.0 * h1 * m2 * p21_4 * g
        - 540.0 * h1 * p21_4 * h2 * k2) / (175.0 * omega1 * h1 * h2_4);
    gradient[10] = 54.0 * p11_4 / (35.0 * omega1 * h1_2);  // by k1
    gradient[11] = (54.0 * p11_4 - 216.0 * p11_3 * p21 + 324.0 * p11_2 * p21_2 - 216.0 * p11 * p21_3
        + 54.0 * p21_4) / (35.0 * omega1 * h2_2);
    gradient[12] = (-54.0 * m1 * p11_4 * h2_3 - 54.0 * p11_4 * h1_3 * m2 - 54.0 * p11_4 * m2 * h2_3
        + 216.0 * p11_3 * h1_3 * m2 * p21 - 324.0 * p11_2 * h1_3 * m2 * p21_2 + 216.0 * p11 * h1_3 * m2 * p21_3
        - 54.0 * h1_3 * m2 * p21_4) / (35.0 * omega1 * h1_3 * h2_3);
  }
  void lump_conservative_v1_conjA_v1_F([[maybe_unused]] double* gradient) const {
    gradient[0] = (3.0 * m1 * p11_2 * h2 * lift + 3.0 * p11_2 * h1 * m2 * lift + 3.0 * p11_2 * m2 * h2 * lift
        - 6.0 * p11 * h1 * m2 * p21 * lift + 3.0 * h1 * m2 * p21_2 * lift) / (10.0 * omega1_2 * h1 * h2);
    gradient[2] = -3.0 * p11_2 * lift / (10.0 * omega1 * h1);  // by m1
    gradient[3] = (-3.0 * m1 * p11 * h2 * lift - 3.0 * p11 * h1 * m2 * lift - 3.0 * p11 * m2 * h2 * lift
        + 3.0 * h1 * m2 * p21 * lift) / (5.0 * omega1 * h1 * h2);
    gradient[5] = (3.0 * m1 * p11_2 * lift + 3.0 * p11_2 * m2 * lift) / (10.0 * omega1 * h1_2);  // by h1
    gradient[6] = (-3.0 * p11_2 * h1 * lift - 3.0 * p11_2 * h2 * lift + 6.0 * p11 * h1 * p21 * lift
        - 3.0 * h1 * p21_2 * lift) / (10.0 * omega1 * h1 * h2);
    gradient[7] = (3.0 * p11 * m2 * lift - 3.0 * m2 * p21 * lift) / (5.0 * omega1 * h2);  // by p21
    gradient[9] = (3.0 * p11_2 * m2 * lift - 6.0 * p11 * m2 * p21 * lift
        + 3.0 * m2 * p21_2 * lift) / (10.0 * omega1 * h2_2);
    gradient[13] = (-3.0 * m1 * p11_2 * h2 - 3.0 * p11_2 * h1 * m2 - 3.0 * p11_2 * m2 * h2
        + 6.0 * p11 * h1 * m2 * p21 - 3.0 * h1 * m2 * p21_2) / (10.0 * omega1 * h1 * h2);
  }
  void lump_mu2([[maybe_unused]] double* gradient) const { gradient[16] = 1.0; }
  void lump_conservative_v2_A_v22_conjA_v2([[maybe_unused]] double* gradient) const {
    gradient[1] = (-252.0 * omega2_2 * m1 * p12_4 * h1 * h2_3 - 252.0 * omega2_2 * p12_4 * h1_3 * m2 * h2
        - 504.0 * omega2_2 * p12_4 * h1_2 * m2 * h2_2 - 252.0 * omega2_2 * p12_4 * h1 * m2 * h2_3
        + 1008.0 * omega2_2 * p12_3 * h1_3 * m2 * p22 * h2 + 1008.0 * omega2_2 * p12_3 * h1_2 * m2 * p22 * h2_2
        - 1512.0 * omega2_2 * p12_2 * h1_3 * m2 * p22_2 * h2 - 504.0 * omega2_2 * p12_2 * h1_2 * m2 * p22_2 * h2_2
        + 1008.0 * omega2_2 * p12 * h1_3 * m2 * p22_3 * h2 - 252.0 * omega2_2 * h1_3 * m2 * p22_4 * h2
        + 270.0 * m1 * p12_4 * h2_3 * g + 270.0 * p12_4 * h1_3 * m2 * g - 270.0 * p12_4 * h1_3 * h2 * k2
        - 270.0 * p12_4 * h1 * h2_3 * k1 + 270.0 * p12_4 * m2 * h2_3 * g - 1080.0 * p12_3 * h1_3 * m2 * p22 * g
        + 1080.0 * p12_3 * h1_3 * p22 * h2 * k2 + 1620.0 * p12_2 * h1_3 * m2 * p22_2 * g
        - 1620.0 * p12_2 * h1_3 * p22_2 * h2 * k2 - 1080.0 * p12 * h1_3 * m2 * p22_3 * g
        + 1080.0 * p12 * h1_3 * p22_3 * h2 * k2 + 270.0 * h1_3 * m2 * p22_4 * g
        - 270.0 * h1_3 * p22_4 * h2 * k2) / (175.0 * omega2_2 * h1_3 * h2_3);
    gradient[2] = (-252.0 * omega2_2 * p12_4 * h1 - 270.0 * p12_4 * g) / (175.0 * omega2 * h1_3);  // by m1
    gradient[4] = (-1008.0 * omega2_2 * m1 * p12_3 * h1 * h2_3 - 1008.0 * omega2_2 * p12_3 * h1_3 * m2 * h2
        - 2016.0 * omega2_2 * p12_3 * h1_2 * m2 * h2_2 - 1008.0 * omega2_2 * p12_3 * h1 * m2 * h2_3
        + 3024.0 * omega2_2 * p12_2 * h1_3 * m2 * p22 * h2 + 3024.0 * omega2_2 * p12_2 * h1_2 * m2 * p22 * h2_2
        - 3024.0 * omega2_2 * p12 * h1_3 * m2 * p22_2 * h2 - 1008.0 * omega2_2 * p12 * h1_2 * m2 * p22_2 * h2_2
        + 1008.0 * omega2_2 * h1_3 * m2 * p22_3 * h2 - 1080.0 * m1 * p12_3 * h2_3 * g
        - 1080.0 * p12_3 * h1_3 * m2 * g + 1080.0 * p12_3 * h1_3 * h2 * k2 + 1080.0 * p12_3 * h1 * h2_3 * k1
        - 1080.0 * p12_3 * m2 * h2_3 * g + 3240.0 * p12_2 * h1_3 * m2 * p22 * g
        - 3240.0 * p12_2 * h1_3 * p22 * h2 * k2 - 3240.0 * p12 * h1_3 * m2 * p22_2 * g
        + 3240.0 * p12 * h1_3 * p22_2 * h2 * k2 + 1080.0 * h1_3 * m2 * p22_3 * g
        - 1080.0 * h1_3 * p22_3 * h2 * k2) / (175.0 * omega2 * h1_3 * h2_3);
    gradient[5] = (504.0 * omega2_2 * m1 * p12_4 * h1 * h2 + 504.0 * omega2_2 * p12_4 * h1_2 * m2
        + 504.0 * omega2_2 * p12_4 * h1 * m2 * h2 - 1008.0 * omega2_2 * p12_3 * h1_2 * m2 * p22
        + 504.0 * omega2_2 * p12_2 * h1_2 * m2 * p22_2 + 810.0 * m1 * p12_4 * h2 * g - 540.0 * p12_4 * h1 * h2 * k1
        + 810.0 * p12_4 * m2 * h2 * g) / (175.0 * omega2 * h1_4 * h2);
    gradient[6] = (-252.0 * omega2_2 * p12_4 * h1_3 * h2 - 504.0 * omega2_2 * p12_4 * h1_2 * h2_2
        - 252.0 * omega2_2 * p12_4 * h1 * h2_3 + 1008.0 * omega2_2 * p12_3 * h1_3 * p22 * h2
        + 1008.0 * omega2_2 * p12_3 * h1_2 * p22 * h2_2 - 1512.0 * omega2_2 * p12_2 * h1_3 * p22_2 * h2
        - 504.0 * omega2_2 * p12_2 * h1_2 * p22_2 * h2_2 + 1008.0 * omega2_2 * p12 * h1_3 * p22_3 * h2
        - 252.0 * omega2_2 * h1_3 * p22_4 * h2 - 270.0 * p12_4 * h1_3 * g - 270.0 * p12_4 * h2_3 * g
        + 1080.0 * p12_3 * h1_3 * p22 * g - 1620.0 * p12_2 * h1_3 * p22_2 * g + 1080.0 * p12 * h1_3 * p22_3 * g
        - 270.0 * h1_3 * p22_4 * g) / (175.0 * omega2 * h1_3 * h2_3);
    gradient[8] = (1008.0 * omega2_2 * p12_3 * h1 * m2 * h2 + 1008.0 * omega2_2 * p12_3 * m2 * h2_2
        - 3024.0 * omega2_2 * p12_2 * h1 * m2 * p22 * h2 - 1008.0 * omega2_2 * p12_2 * m2 * p22 * h2_2
        + 3024.0 * omega2_2 * p12 * h1 * m2 * p22_2 * h2 - 1008.0 * omega2_2 * h1 * m2 * p22_3 * h2
        + 1080.0 * p12_3 * h1 * m2 * g - 1080.0 * p12_3 * h1 * h2 * k2 - 3240.0 * p12_2 * h1 * m2 * p22 * g
        + 3240.0 * p12_2 * h1 * p22 * h2 * k2 + 3240.0 * p12 * h1 * m2 * p22_2 * g
        - 3240.0 * p12 * h1 * p22_2 * h2 * k2 - 1080.0 * h1 * m2 * p22_3 * g
        + 1080.0 * h1 * p22_3 * h2 * k2) / (175.0 * omega2 * h1 * h2_3);
    gradient[9] = (504.0 * omega2_2 * p12_4 * h1 * m2 * h2 + 504.0 * omega2_2 * p12_4 * m2 * h2_2
        - 2016.0 * omega2_2 * p12_3 * h1 * m2 * p22 * h2 - 1008.0 * omega2_2 * p12_3 * m2 * p22 * h2_2
        + 3024.0 * omega2_2 * p12_2 * h1 * m2 * p22_2 * h2 + 504.0 * omega2_2 * p12_2 * m2 * p22_2 * h2_2
        - 2016.0 * omega2_2 * p12 * h1 * m2 * p22_3 * h2 + 504.0 * omega2_2 * h1 * m2 * p22_4 * h2
        + 810.0 * p12_4 * h1 * m2 * g - 540.0 * p12_4 * h1 * h2 * k2 - 3240.0 * p12_3 * h1 * m2 * p22 * g
        + 2160.0 * p12_3 * h1 * p22 * h2 * k2 + 4860.0 * p12_2 * h1 * m2 * p22_2 * g
        - 3240.0 * p12_2 * h1 * p22_2 * h2 * k2 - 3240.0 * p12 * h1 * m2 * p22_3 * g
        + 2160.0 * p12 * h1 * p22_3 * h2 * k2 + 810.0 * h1 * m2 * p22_4 * g
        - 540.0 * h1 * p22_4 * h2 * k2) / (175.0 * omega2 * h1 * h2_4);
    gradient[10] = 54.0 * p12_4 / (35.0 * omega2 * h1_2);  // by k1
    gradient[11] = (54.0 * p12_4 - 216.0 * p12_3 * p22 + 324.0 * p12_2 * p22_2 - 216.0 * p12 * p22_3
        + 54.0 * p22_4) / (35.0 * omega2 * h2_2);
    gradient[12] = (-54.0 * m1 * p12_4 * h2_3 - 54.0 * p12_4 * h1_3 * m2 - 54.0 * p12_4 * m2 * h2_3
        + 216.0 * p12_3 * h1_3 * m2 * p22 - 324.0 * p12_2 * h1_3 * m2 * p22_2 + 216.0 * p12 * h1_3 * m2 * p22_3
        - 54.0 * h1_3 * m2 * p22_4) / (35.0 * omega2 * h1_3 * h2_3);
  }
  void lump_harmonic_re_v1_F([[maybe_unused]] double* gradient) const {
    gradient[0] = (m1 * p11 * tilt + m2 * p21 * tilt) / (3.0 * omega1_3);  // by omega1
    gradient[2] = -p11 * tilt / (6.0 * omega1_2);  // by m1
    gradient[3] = -m1 * tilt / (6.0 * omega1_2);  // by p11
    gradient[6] = -p21 * tilt / (6.0 * omega1_2);  // by m2
    gradient[7] = -m2 * tilt / (6.0 * omega1_2);  // by p21
    gradient[15] = (-m1 * p11 - m2 * p21) / (6.0 * omega1_2);  // by tilt
  }
  void lump_harmonic_re_v1_A_v2_conjA_v12([[maybe_unused]] double* gradient) const {
    const double f_0 = (-108.0 * omega1_2 * m1 * p11_3 * p12 * h2_2 - 108.0 * omega1_2 * p11_3 * p12 * h1_2 * m2
        - 216.0 * omega1_2 * p11_3 * p12 * h1 * m2 * h2 - 108.0 * omega1_2 * p11_3 * p12 * m2 * h2_2
        + 108.0 * omega1_2 * p11_3 * h1_2 * m2 * p22 + 108.0 * omega1_2 * p11_3 * h1 * m2 * p22 * h2
        + 324.0 * omega1_2 * p11_2 * p12 * h1_2 * m2 * p21 + 324.0 * omega1_2 * p11_2 * p12 * h1 * m2 * p21 * h2
        - 324.0 * omega1_2 * p11_2 * h1_2 * m2 * p21 * p22 - 108.0 * omega1_2 * p11_2 * h1 * m2 * p21 * p22 * h2
        - 324.0 * omega1_2 * p11 * p12 * h1_2 * m2 * p21_2 - 108.0 * omega1_2 * p11 * p12 * h1 * m2 * p21_2 * h2
        + 324.0 * omega1_2 * p11 * h1_2 * m2 * p21_2 * p22 + 108.0 * omega1_2 * p12 * h1_2 * m2 * p21_3
        - 108.0 * omega1_2 * h1_2 * m2 * p21_3 * p22) * over_0 / (25.0 * h1_2 * h2_2);
    const double f_1 = (72.0 * omega1 * omega2 * m1 * p11_3 * p12 * h2_2
        + 72.0 * omega1 * omega2 * p11_3 * p12 * h1_2 * m2 + 144.0 * omega1 * omega2 * p11_3 * p12 * h1 * m2 * h2
        + 72.0 * omega1 * omega2 * p11_3 * p12 * m2 * h2_2 - 72.0 * omega1 * omega2 * p11_3 * h1_2 * m2 * p22
        - 72.0 * omega1 * omega2 * p11_3 * h1 * m2 * p22 * h2
        - 216.0 * omega1 * omega2 * p11_2 * p12 * h1_2 * m2 * p21
        - 216.0 * omega1 * omega2 * p11_2 * p12 * h1 * m2 * p21 * h2
        + 216.0 * omega1 * omega2 * p11_2 * h1_2 * m2 * p21 * p22
        + 72.0 * omega1 * omega2 * p11_2 * h1 * m2 * p21 * p22 * h2
        + 216.0 * omega1 * omega2 * p11 * p12 * h1_2 * m2 * p21_2
        + 72.0 * omega1 * omega2 * p11 * p12 * h1 * m2 * p21_2 * h2
        - 216.0 * omega1 * omega2 * p11 * h1_2 * m2 * p21_2 * p22 - 72.0 * omega1 * omega2 * p12 * h1_2 * m2 * p21_3
        + 72.0 * omega1 * omega2 * h1_2 * m2 * p21_3 * p22) * over_0 / (25.0 * h1_2 * h2_2);
    const double f_2 = (-36.0 * omega2_2 * m1 * p11_3 * p12 * h2_2 - 36.0 * omega2_2 * p11_3 * p12 * h1_2 * m2
        - 72.0 * omega2_2 * p11_3 * p12 * h1 * m2 * h2 - 36.0 * omega2_2 * p11_3 * p12 * m2 * h2_2
        + 36.0 * omega2_2 * p11_3 * h1_2 * m2 * p22 + 36.0 * omega2_2 * p11_3 * h1 * m2 * p22 * h2
        + 108.0 * omega2_2 * p11_2 * p12 * h1_2 * m2 * p21 + 108.0 * omega2_2 * p11_2 * p12 * h1 * m2 * p21 * h2
        - 108.0 * omega2_2 * p11_2 * h1_2 * m2 * p21 * p22 - 36.0 * omega2_2 * p11_2 * h1 * m2 * p21 * p22 * h2
        - 108.0 * omega2_2 * p11 * p12 * h1_2 * m2 * p21_2 - 36.0 * omega2_2 * p11 * p12 * h1 * m2 * p21_2 * h2
        + 108.0 * omega2_2 * p11 * h1_2 * m2 * p21_2 * p22 + 36.0 * omega2_2 * p12 * h1_2 * m2 * p21_3
        - 36.0 * omega2_2 * h1_2 * m2 * p21_3 * p22) * over_0 / (25.0 * h1_2 * h2_2);
    const double f_3 = (-108.0 * m1 * p11_3 * p12 * h2_3 * g - 108.0 * p11_3 * p12 * h1_3 * m2 * g
        + 108.0 * p11_3 * p12 * h1_3 * h2 * k2 + 108.0 * p11_3 * p12 * h1 * h2_3 * k1
        - 108.0 * p11_3 * p12 * m2 * h2_3 * g + 108.0 * p11_3 * h1_3 * m2 * p22 * g
        - 108.0 * p11_3 * h1_3 * p22 * h2 * k2 + 324.0 * p11_2 * p12 * h1_3 * m2 * p21 * g
        - 324.0 * p11_2 * p12 * h1_3 * p21 * h2 * k2 - 324.0 * p11_2 * h1_3 * m2 * p21 * p22 * g
        + 324.0 * p11_2 * h1_3 * p21 * p22 * h2 * k2 - 324.0 * p11 * p12 * h1_3 * m2 * p21_2 * g
        + 324.0 * p11 * p12 * h1_3 * p21_2 * h2 * k2 + 324.0 * p11 * h1_3 * m2 * p21_2 * p22 * g
        - 324.0 * p11 * h1_3 * p21_2 * p22 * h2 * k2 + 108.0 * p12 * h1_3 * m2 * p21_3 * g
        - 108.0 * p12 * h1_3 * p21_3 * h2 * k2 - 108.0 * h1_3 * m2 * p21_3 * p22 * g
        + 108.0 * h1_3 * p21_3 * p22 * h2 * k2) * over_0 / (35.0 * h1_3 * h2_3);
    const double q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
    const double q_1 = (f_0 + f_1 + f_2 + f_3) * per_1;
    gradient[0] = (2.0 * f_0 + f_1) / omega1 - q_0 - 3.0 * q_1;  // by omega1
    gradient[1] = (f_1 + 2.0 * f_2) / omega2 + q_0 + q_1;  // by omega2
    const double c_0 = (-108.0 * omega1_2 + 72.0 * omega1 * omega2 - 36.0 * omega2_2) * over_0 / 25.0;
    const double c_1 = -108.0 * over_0 / 35.0;  // multiplies m1*p11^3*p12*h2^3*g/(h1^3*h2^3)
    const double c_2 = (-108.0 * omega1_2 + 72.0 * omega1 * omega2 - 36.0 * omega2_2) * over_0 / 25.0;
    const double c_3 = -108.0 * over_0 / 35.0;  // multiplies p11^3*p12*h1^3*m2*g/(h1^3*h2^3)
    const double c_4 = 108.0 * over_0 / 35.0;  // multiplies p11^3*p12*h1^3*h2*k2/(h1^3*h2^3)
    const double c_5 = (-216.0 * omega1_2 + 144.0 * omega1 * omega2 - 72.0 * omega2_2) * over_0 / 25.0;
    const double c_6 = (-108.0 * omega1_2 + 72.0 * omega1 * omega2 - 36.0 * omega2_2) * over_0 / 25.0;
    const double c_7 = 108.0 * over_0 / 35.0;  // multiplies p11^3*p12*h1*h2^3*k1/(h1^3*h2^3)
    const double c_8 = -108.0 * over_0 / 35.0;  // multiplies p11^3*p12*m2*h2^3*g/(h1^3*h2^3)
    const double c_9 = (108.0 * omega1_2 - 72.0 * omega1 * omega2 + 36.0 * omega2_2) * over_0 / 25.0;
    const double c_10 = 108.0 * over_0 / 35.0;  // multiplies p11^3*h1^3*m2*p22*g/(h1^3*h2^3)
    const double c_11 = -108.0 * over_0 / 35.0;  // multiplies p11^3*h1^3*p22*h2*k2/(h1^3*h2^3)
    const double c_12 = (108.0 * omega1_2 - 72.0 * omega1 * omega2 + 36.0 * omega2_2) * over_0 / 25.0;
    const double c_13 = (324.0 * omega1_2 - 216.0 * omega1 * omega2 + 108.0 * omega2_2) * over_0 / 25.0;
    const double c_14 = 324.0 * over_0 / 35.0;  // multiplies p11^2*p12*h1^3*m2*p21*g/(h1^3*h2^3)
    const double c_15 = -324.0 * over_0 / 35.0;  // multiplies p11^2*p12*h1^3*p21*h2*k2/(h1^3*h2^3)
    const double c_16 = (324.0 * omega1_2 - 216.0 * omega1 * omega2 + 108.0 * omega2_2) * over_0 / 25.0;
    const double c_17 = (-324.0 * omega1_2 + 216.0 * omega1 * omega2 - 108.0 * omega2_2) * over_0 / 25.0;
    const double c_18 = -324.0 * over_0 / 35.0;  // multiplies p11^2*h1^3*m2*p21*p22*g/(h1^3*h2^3)
    const double c_19 = 324.0 * over_0 / 35.0;  // multiplies p11^2*h1^3*p21*p22*h2*k2/(h1^3*h2^3)
    const double c_20 = (-108.0 * omega1_2 + 72.0 * omega1 * omega2 - 36.0 * omega2_2) * over_0 / 25.0;
    const double c_21 = (-324.0 * omega1_2 + 216.0 * omega1 * omega2 - 108.0 * omega2_2) * over_0 / 25.0;
    const double c_22 = -324.0 * over_0 / 35.0;  // multiplies p11*p12*h1^3*m2*p21^2*g/(h1^3*h2^3)
    const double c_23 = 324.0 * over_0 / 35.0;  // multiplies p11*p12*h1^3*p21^2*h2*k2/(h1^3*h2^3)
    const double c_24 = (-108.0 * omega1_2 + 72.0 * omega1 * omega2 - 36.0 * omega2_2) * over_0 / 25.0;
    const double c_25 = (324.0 * omega1_2 - 216.0 * omega1 * omega2 + 108.0 * omega2_2) * over_0 / 25.0;
    const double c_26 = 324.0 * over_0 / 35.0;  // multiplies p11*h1^3*m2*p21^2*p22*g/(h1^3*h2^3)
    const double c_27 = -324.0 * over_0 / 35.0;  // multiplies p11*h1^3*p21^2*p22*h2*k2/(h1^3*h2^3)
    const double c_28 = (108.0 * omega1_2 - 72.0 * omega1 * omega2 + 36.0 * omega2_2) * over_0 / 25.0;
    const double c_29 = 108.0 * over_0 / 35.0;  // multiplies p12*h1^3*m2*p21^3*g/(h1^3*h2^3)
    const double c_30 = -108.0 * over_0 / 35.0;  // multiplies p12*h1^3*p21^3*h2*k2/(h1^3*h2^3)
    const double c_31 = (-108.0 * omega1_2 + 72.0 * omega1 * omega2 - 36.0 * omega2_2) * over_0 / 25.0;
    const double c_32 = -108.0 * over_0 / 35.0;  // multiplies h1^3*m2*p21^3*p22*g/(h1^3*h2^3)
    const double c_33 = 108.0 * over_0 / 35.0;  // multiplies h1^3*p21^3*p22*h2*k2/(h1^3*h2^3)
    gradient[2] = p11_3 * p12 / h1_2 * c_0 + p11_3 * p12 * g / h1_3 * c_1;  // by m1
    gradient[3] = 3.0 * m1 * p11_2 * p12 / h1_2 * c_0 + 3.0 * m1 * p11_2 * p12 * g / h1_3 * c_1
        + 3.0 * p11_2 * p12 * m2 / h2_2 * c_2 + 3.0 * p11_2 * p12 * m2 * g / h2_3 * c_3
        + 3.0 * p11_2 * p12 * k2 / h2_2 * c_4 + 3.0 * p11_2 * p12 * m2 / (h1 * h2) * c_5
        + 3.0 * p11_2 * p12 * m2 / h1_2 * c_6 + 3.0 * p11_2 * p12 * k1 / h1_2 * c_7
        + 3.0 * p11_2 * p12 * m2 * g / h1_3 * c_8 + 3.0 * p11_2 * m2 * p22 / h2_2 * c_9
        + 3.0 * p11_2 * m2 * p22 * g / h2_3 * c_10 + 3.0 * p11_2 * p22 * k2 / h2_2 * c_11
        + 3.0 * p11_2 * m2 * p22 / (h1 * h2) * c_12 + 2.0 * p11 * p12 * m2 * p21 / h2_2 * c_13
        + 2.0 * p11 * p12 * m2 * p21 * g / h2_3 * c_14 + 2.0 * p11 * p12 * p21 * k2 / h2_2 * c_15
        + 2.0 * p11 * p12 * m2 * p21 / (h1 * h2) * c_16 + 2.0 * p11 * m2 * p21 * p22 / h2_2 * c_17
        + 2.0 * p11 * m2 * p21 * p22 * g / h2_3 * c_18 + 2.0 * p11 * p21 * p22 * k2 / h2_2 * c_19
        + 2.0 * p11 * m2 * p21 * p22 / (h1 * h2) * c_20 + p12 * m2 * p21_2 / h2_2 * c_21
        + p12 * m2 * p21_2 * g / h2_3 * c_22 + p12 * p21_2 * k2 / h2_2 * c_23 + p12 * m2 * p21_2 / (h1 * h2) * c_24
        + m2 * p21_2 * p22 / h2_2 * c_25 + m2 * p21_2 * p22 * g / h2_3 * c_26 + p21_2 * p22 * k2 / h2_2 * c_27;
    gradient[4] = m1 * p11_3 / h1_2 * c_0 + m1 * p11_3 * g / h1_3 * c_1 + p11_3 * m2 / h2_2 * c_2
        + p11_3 * m2 * g / h2_3 * c_3 + p11_3 * k2 / h2_2 * c_4 + p11_3 * m2 / (h1 * h2) * c_5
        + p11_3 * m2 / h1_2 * c_6 + p11_3 * k1 / h1_2 * c_7 + p11_3 * m2 * g / h1_3 * c_8
        + p11_2 * m2 * p21 / h2_2 * c_13 + p11_2 * m2 * p21 * g / h2_3 * c_14 + p11_2 * p21 * k2 / h2_2 * c_15
        + p11_2 * m2 * p21 / (h1 * h2) * c_16 + p11 * m2 * p21_2 / h2_2 * c_21 + p11 * m2 * p21_2 * g / h2_3 * c_22
        + p11 * p21_2 * k2 / h2_2 * c_23 + p11 * m2 * p21_2 / (h1 * h2) * c_24 + m2 * p21_3 / h2_2 * c_28
        + m2 * p21_3 * g / h2_3 * c_29 + p21_3 * k2 / h2_2 * c_30;
    gradient[5] = -2.0 * m1 * p11_3 * p12 / h1_3 * c_0 - 3.0 * m1 * p11_3 * p12 * g / h1_4 * c_1
        - p11_3 * p12 * m2 / (h1_2 * h2) * c_5 - 2.0 * p11_3 * p12 * m2 / h1_3 * c_6
        - 2.0 * p11_3 * p12 * k1 / h1_3 * c_7 - 3.0 * p11_3 * p12 * m2 * g / h1_4 * c_8
        - p11_3 * m2 * p22 / (h1_2 * h2) * c_12 - p11_2 * p12 * m2 * p21 / (h1_2 * h2) * c_16
        - p11_2 * m2 * p21 * p22 / (h1_2 * h2) * c_20 - p11 * p12 * m2 * p21_2 / (h1_2 * h2) * c_24;
    gradient[6] = p11_3 * p12 / h2_2 * c_2 + p11_3 * p12 * g / h2_3 * c_3 + p11_3 * p12 / (h1 * h2) * c_5
        + p11_3 * p12 / h1_2 * c_6 + p11_3 * p12 * g / h1_3 * c_8 + p11_3 * p22 / h2_2 * c_9
        + p11_3 * p22 * g / h2_3 * c_10 + p11_3 * p22 / (h1 * h2) * c_12 + p11_2 * p12 * p21 / h2_2 * c_13
        + p11_2 * p12 * p21 * g / h2_3 * c_14 + p11_2 * p12 * p21 / (h1 * h2) * c_16
        + p11_2 * p21 * p22 / h2_2 * c_17 + p11_2 * p21 * p22 * g / h2_3 * c_18
        + p11_2 * p21 * p22 / (h1 * h2) * c_20 + p11 * p12 * p21_2 / h2_2 * c_21
        + p11 * p12 * p21_2 * g / h2_3 * c_22 + p11 * p12 * p21_2 / (h1 * h2) * c_24
        + p11 * p21_2 * p22 / h2_2 * c_25 + p11 * p21_2 * p22 * g / h2_3 * c_26 + p12 * p21_3 / h2_2 * c_28
        + p12 * p21_3 * g / h2_3 * c_29 + p21_3 * p22 / h2_2 * c_31 + p21_3 * p22 * g / h2_3 * c_32;
    gradient[7] = p11_2 * p12 * m2 / h2_2 * c_13 + p11_2 * p12 * m2 * g / h2_3 * c_14
        + p11_2 * p12 * k2 / h2_2 * c_15 + p11_2 * p12 * m2 / (h1 * h2) * c_16 + p11_2 * m2 * p22 / h2_2 * c_17
        + p11_2 * m2 * p22 * g / h2_3 * c_18 + p11_2 * p22 * k2 / h2_2 * c_19 + p11_2 * m2 * p22 / (h1 * h2) * c_20
        + 2.0 * p11 * p12 * m2 * p21 / h2_2 * c_21 + 2.0 * p11 * p12 * m2 * p21 * g / h2_3 * c_22
        + 2.0 * p11 * p12 * p21 * k2 / h2_2 * c_23 + 2.0 * p11 * p12 * m2 * p21 / (h1 * h2) * c_24
        + 2.0 * p11 * m2 * p21 * p22 / h2_2 * c_25 + 2.0 * p11 * m2 * p21 * p22 * g / h2_3 * c_26
        + 2.0 * p11 * p21 * p22 * k2 / h2_2 * c_27 + 3.0 * p12 * m2 * p21_2 / h2_2 * c_28
        + 3.0 * p12 * m2 * p21_2 * g / h2_3 * c_29 + 3.0 * p12 * p21_2 * k2 / h2_2 * c_30
        + 3.0 * m2 * p21_2 * p22 / h2_2 * c_31 + 3.0 * m2 * p21_2 * p22 * g / h2_3 * c_32
        + 3.0 * p21_2 * p22 * k2 / h2_2 * c_33;
    gradient[8] = p11_3 * m2 / h2_2 * c_9 + p11_3 * m2 * g / h2_3 * c_10 + p11_3 * k2 / h2_2 * c_11
        + p11_3 * m2 / (h1 * h2) * c_12 + p11_2 * m2 * p21 / h2_2 * c_17 + p11_2 * m2 * p21 * g / h2_3 * c_18
        + p11_2 * p21 * k2 / h2_2 * c_19 + p11_2 * m2 * p21 / (h1 * h2) * c_20 + p11 * m2 * p21_2 / h2_2 * c_25
        + p11 * m2 * p21_2 * g / h2_3 * c_26 + p11 * p21_2 * k2 / h2_2 * c_27 + m2 * p21_3 / h2_2 * c_31
        + m2 * p21_3 * g / h2_3 * c_32 + p21_3 * k2 / h2_2 * c_33;
    gradient[9] = -2.0 * p11_3 * p12 * m2 / h2_3 * c_2 - 3.0 * p11_3 * p12 * m2 * g / h2_4 * c_3
        - 2.0 * p11_3 * p12 * k2 / h2_3 * c_4 - p11_3 * p12 * m2 / (h1 * h2_2) * c_5
        - 2.0 * p11_3 * m2 * p22 / h2_3 * c_9 - 3.0 * p11_3 * m2 * p22 * g / h2_4 * c_10
        - 2.0 * p11_3 * p22 * k2 / h2_3 * c_11 - p11_3 * m2 * p22 / (h1 * h2_2) * c_12
        - 2.0 * p11_2 * p12 * m2 * p21 / h2_3 * c_13 - 3.0 * p11_2 * p12 * m2 * p21 * g / h2_4 * c_14
        - 2.0 * p11_2 * p12 * p21 * k2 / h2_3 * c_15 - p11_2 * p12 * m2 * p21 / (h1 * h2_2) * c_16
        - 2.0 * p11_2 * m2 * p21 * p22 / h2_3 * c_17 - 3.0 * p11_2 * m2 * p21 * p22 * g / h2_4 * c_18
        - 2.0 * p11_2 * p21 * p22 * k2 / h2_3 * c_19 - p11_2 * m2 * p21 * p22 / (h1 * h2_2) * c_20
        - 2.0 * p11 * p12 * m2 * p21_2 / h2_3 * c_21 - 3.0 * p11 * p12 * m2 * p21_2 * g / h2_4 * c_22
        - 2.0 * p11 * p12 * p21_2 * k2 / h2_3 * c_23 - p11 * p12 * m2 * p21_2 / (h1 * h2_2) * c_24
        - 2.0 * p11 * m2 * p21_2 * p22 / h2_3 * c_25 - 3.0 * p11 * m2 * p21_2 * p22 * g / h2_4 * c_26
        - 2.0 * p11 * p21_2 * p22 * k2 / h2_3 * c_27 - 2.0 * p12 * m2 * p21_3 / h2_3 * c_28
        - 3.0 * p12 * m2 * p21_3 * g / h2_4 * c_29 - 2.0 * p12 * p21_3 * k2 / h2_3 * c_30
        - 2.0 * m2 * p21_3 * p22 / h2_3 * c_31 - 3.0 * m2 * p21_3 * p22 * g / h2_4 * c_32
        - 2.0 * p21_3 * p22 * k2 / h2_3 * c_33;
    gradient[10] = p11_3 * p12 / h1_2 * c_7;  // by k1
    gradient[11] = p11_3 * p12 / h2_2 * c_4 + p11_3 * p22 / h2_2 * c_11 + p11_2 * p12 * p21 / h2_2 * c_15
        + p11_2 * p21 * p22 / h2_2 * c_19 + p11 * p12 * p21_2 / h2_2 * c_23 + p11 * p21_2 * p22 / h2_2 * c_27
        + p12 * p21_3 / h2_2 * c_30 + p21_3 * p22 / h2_2 * c_33;
    gradient[12] = m1 * p11_3 * p12 / h1_3 * c_1 + p11_3 * p12 * m2 / h2_3 * c_3 + p11_3 * p12 * m2 / h1_3 * c_8
        + p11_3 * m2 * p22 / h2_3 * c_10 + p11_2 * p12 * m2 * p21 / h2_3 * c_14
        + p11_2 * m2 * p21 * p22 / h2_3 * c_18 + p11 * p12 * m2 * p21_2 / h2_3 * c_22
        + p11 * m2 * p21_2 * p22 / h2_3 * c_26 + p12 * m2 * p21_3 / h2_3 * c_29 + m2 * p21_3 * p22 / h2_3 * c_32;
  }
  void lump_harmonic_re_v1_A_v2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = (-3.0 * m1 * p11 * p12 * h2 * lift - 3.0 * p11 * p12 * h1 * m2 * lift
        - 3.0 * p11 * p12 * m2 * h2 * lift + 3.0 * p11 * h1 * m2 * p22 * lift + 3.0 * p12 * h1 * m2 * p21 * lift
        - 3.0 * h1 * m2 * p21 * p22 * lift) * over_0 / (5.0 * h1 * h2);
    const double q_0 = f_0 * per_0;
    const double q_1 = f_0 * per_1;
    gradient[0] = -q_0 - 3.0 * q_1;  // by omega1
    gradient[1] = q_0 + q_1;  // by omega2
    const double c_0 = -3.0 * over_0 / 5.0;  // multiplies m1*p11*p12*h2*lift/(h1*h2)
    const double c_1 = -3.0 * over_0 / 5.0;  // multiplies p11*p12*h1*m2*lift/(h1*h2)
    const double c_2 = -3.0 * over_0 / 5.0;  // multiplies p11*p12*m2*h2*lift/(h1*h2)
    const double c_3 = 3.0 * over_0 / 5.0;  // multiplies p11*h1*m2*p22*lift/(h1*h2)
    const double c_4 = 3.0 * over_0 / 5.0;  // multiplies p12*h1*m2*p21*lift/(h1*h2)
    const double c_5 = -3.0 * over_0 / 5.0;  // multiplies h1*m2*p21*p22*lift/(h1*h2)
    gradient[2] = p11 * p12 * lift / h1 * c_0;  // by m1
    gradient[3] = m1 * p12 * lift / h1 * c_0 + p12 * m2 * lift / h2 * c_1 + p12 * m2 * lift / h1 * c_2
        + m2 * p22 * lift / h2 * c_3;
    gradient[4] = m1 * p11 * lift / h1 * c_0 + p11 * m2 * lift / h2 * c_1 + p11 * m2 * lift / h1 * c_2
        + m2 * p21 * lift / h2 * c_4;
    gradient[5] = -m1 * p11 * p12 * lift / h1_2 * c_0 - p11 * p12 * m2 * lift / h1_2 * c_2;  // by h1
    gradient[6] = p11 * p12 * lift / h2 * c_1 + p11 * p12 * lift / h1 * c_2 + p11 * p22 * lift / h2 * c_3
        + p12 * p21 * lift / h2 * c_4 + p21 * p22 * lift / h2 * c_5;
    gradient[7] = p12 * m2 * lift / h2 * c_4 + m2 * p22 * lift / h2 * c_5;  // by p21
    gradient[8] = p11 * m2 * lift / h2 * c_3 + m2 * p21 * lift / h2 * c_5;  // by p22
    gradient[9] = -p11 * p12 * m2 * lift / h2_2 * c_1 - p11 * m2 * p22 * lift / h2_2 * c_3
        - p12 * m2 * p21 * lift / h2_2 * c_4 - m2 * p21 * p22 * lift / h2_2 * c_5;
    gradient[13] = m1 * p11 * p12 / h1 * c_0 + p11 * p12 * m2 / h2 * c_1 + p11 * p12 * m2 / h1 * c_2
        + p11 * m2 * p22 / h2 * c_3 + p12 * m2 * p21 / h2 * c_4 + m2 * p21 * p22 / h2 * c_5;
  }
  void lump_harmonic_re_v1_A_v22_conjA_v1([[maybe_unused]] double* gradient) const {
    const double f_0 = 18.0 * omega1 * p11 * p12 * m2 * p21 * p22 / (25.0 * omega2 * h1 * h2);
    const double f_2 = (9.0 * omega1_2 * m1 * p11_2 * p12_2 * h2_2 + 9.0 * omega1_2 * p11_2 * p12_2 * h1_2 * m2
        + 18.0 * omega1_2 * p11_2 * p12_2 * h1 * m2 * h2 + 9.0 * omega1_2 * p11_2 * p12_2 * m2 * h2_2
        - 18.0 * omega1_2 * p11_2 * p12 * h1_2 * m2 * p22 - 18.0 * omega1_2 * p11_2 * p12 * h1 * m2 * p22 * h2
        + 9.0 * omega1_2 * p11_2 * h1_2 * m2 * p22_2 - 18.0 * omega1_2 * p11 * p12_2 * h1_2 * m2 * p21
        - 18.0 * omega1_2 * p11 * p12_2 * h1 * m2 * p21 * h2 + 36.0 * omega1_2 * p11 * p12 * h1_2 * m2 * p21 * p22
        - 18.0 * omega1_2 * p11 * h1_2 * m2 * p21 * p22_2 + 9.0 * omega1_2 * p12_2 * h1_2 * m2 * p21_2
        - 18.0 * omega1_2 * p12 * h1_2 * m2 * p21_2 * p22
        + 9.0 * omega1_2 * h1_2 * m2 * p21_2 * p22_2) * per_0 / (25.0 * omega2 * h1_2 * h2_2);
    const double f_3 = (-18.0 * omega1 * m1 * p11_2 * p12_2 * h2_2 - 18.0 * omega1 * p11_2 * p12_2 * h1_2 * m2
        - 36.0 * omega1 * p11_2 * p12_2 * h1 * m2 * h2 - 18.0 * omega1 * p11_2 * p12_2 * m2 * h2_2
        + 36.0 * omega1 * p11_2 * p12 * h1_2 * m2 * p22 + 36.0 * omega1 * p11_2 * p12 * h1 * m2 * p22 * h2
        - 18.0 * omega1 * p11_2 * h1_2 * m2 * p22_2 + 36.0 * omega1 * p11 * p12_2 * h1_2 * m2 * p21
        + 36.0 * omega1 * p11 * p12_2 * h1 * m2 * p21 * h2 - 72.0 * omega1 * p11 * p12 * h1_2 * m2 * p21 * p22
        + 36.0 * omega1 * p11 * h1_2 * m2 * p21 * p22_2 - 18.0 * omega1 * p12_2 * h1_2 * m2 * p21_2
        + 36.0 * omega1 * p12 * h1_2 * m2 * p21_2 * p22
        - 18.0 * omega1 * h1_2 * m2 * p21_2 * p22_2) * per_0 / (25.0 * h1_2 * h2_2);
    const double f_4 = (27.0 * omega2 * m1 * p11_2 * p12_2 * h2_2 + 27.0 * omega2 * p11_2 * p12_2 * h1_2 * m2
        + 54.0 * omega2 * p11_2 * p12_2 * h1 * m2 * h2 + 27.0 * omega2 * p11_2 * p12_2 * m2 * h2_2
        - 54.0 * omega2 * p11_2 * p12 * h1_2 * m2 * p22 - 54.0 * omega2 * p11_2 * p12 * h1 * m2 * p22 * h2
        + 27.0 * omega2 * p11_2 * h1_2 * m2 * p22_2 + 18.0 * omega2 * p11_2 * h1 * m2 * p22_2 * h2
        - 54.0 * omega2 * p11 * p12_2 * h1_2 * m2 * p21 - 54.0 * omega2 * p11 * p12_2 * h1 * m2 * p21 * h2
        + 108.0 * omega2 * p11 * p12 * h1_2 * m2 * p21 * p22 - 54.0 * omega2 * p11 * h1_2 * m2 * p21 * p22_2
        + 27.0 * omega2 * p12_2 * h1_2 * m2 * p21_2 + 18.0 * omega2 * p12_2 * h1 * m2 * p21_2 * h2
        - 54.0 * omega2 * p12 * h1_2 * m2 * p21_2 * p22
        + 27.0 * omega2 * h1_2 * m2 * p21_2 * p22_2) * per_0 / (25.0 * h1_2 * h2_2);
    const double f_5 = (27.0 * m1 * p11_2 * p12_2 * h2_3 * g + 27.0 * p11_2 * p12_2 * h1_3 * m2 * g
        - 27.0 * p11_2 * p12_2 * h1_3 * h2 * k2 - 27.0 * p11_2 * p12_2 * h1 * h2_3 * k1
        + 27.0 * p11_2 * p12_2 * m2 * h2_3 * g - 54.0 * p11_2 * p12 * h1_3 * m2 * p22 * g
        + 54.0 * p11_2 * p12 * h1_3 * p22 * h2 * k2 + 27.0 * p11_2 * h1_3 * m2 * p22_2 * g
        - 27.0 * p11_2 * h1_3 * p22_2 * h2 * k2 - 54.0 * p11 * p12_2 * h1_3 * m2 * p21 * g
        + 54.0 * p11 * p12_2 * h1_3 * p21 * h2 * k2 + 108.0 * p11 * p12 * h1_3 * m2 * p21 * p22 * g
        - 108.0 * p11 * p12 * h1_3 * p21 * p22 * h2 * k2 - 54.0 * p11 * h1_3 * m2 * p21 * p22_2 * g
        + 54.0 * p11 * h1_3 * p21 * p22_2 * h2 * k2 + 27.0 * p12_2 * h1_3 * m2 * p21_2 * g
        - 27.0 * p12_2 * h1_3 * p21_2 * h2 * k2 - 54.0 * p12 * h1_3 * m2 * p21_2 * p22 * g
        + 54.0 * p12 * h1_3 * p21_2 * p22 * h2 * k2 + 27.0 * h1_3 * m2 * p21_2 * p22_2 * g
        - 27.0 * h1_3 * p21_2 * p22_2 * h2 * k2) * per_0 / (35.0 * omega2 * h1_3 * h2_3);
    const double q_0 = (f_2 + f_3 + f_4 + f_5) * per_0;
    gradient[0] = (f_0 + 2.0 * f_2 + f_3) / omega1 - q_0;  // by omega1
    gradient[1] = (-f_0 - f_2 + f_4 - f_5) / omega2 + q_0;  // by omega2
    const double c_0 = (9.0 * omega1_2 - 18.0 * omega1 * omega2 + 27.0 * omega2_2) * per_0 / (25.0 * omega2);
    const double c_1 = 27.0 * per_0 / (35.0 * omega2);  // multiplies m1*p11^2*p12^2*h2^3*g/(h1^3*h2^3)
    const double c_2 = (9.0 * omega1_2 - 18.0 * omega1 * omega2 + 27.0 * omega2_2) * per_0 / (25.0 * omega2);
    const double c_3 = 27.0 * per_0 / (35.0 * omega2);  // multiplies p11^2*p12^2*h1^3*m2*g/(h1^3*h2^3)
    const double c_4 = -27.0 * per_0 / (35.0 * omega2);  // multiplies p11^2*p12^2*h1^3*h2*k2/(h1^3*h2^3)
    const double c_5 = (18.0 * omega1_2 - 36.0 * omega1 * omega2 + 54.0 * omega2_2) * per_0 / (25.0 * omega2);
    const double c_6 = (9.0 * omega1_2 - 18.0 * omega1 * omega2 + 27.0 * omega2_2) * per_0 / (25.0 * omega2);
    const double c_7 = -27.0 * per_0 / (35.0 * omega2);  // multiplies p11^2*p12^2*h1*h2^3*k1/(h1^3*h2^3)
    const double c_8 = 27.0 * per_0 / (35.0 * omega2);  // multiplies p11^2*p12^2*m2*h2^3*g/(h1^3*h2^3)
    const double c_9 = (-18.0 * omega1_2 + 36.0 * omega1 * omega2 - 54.0 * omega2_2) * per_0 / (25.0 * omega2);
    const double c_10 = -54.0 * per_0 / (35.0 * omega2);  // multiplies p11^2*p12*h1^3*m2*p22*g/(h1^3*h2^3)
    const double c_11 = 54.0 * per_0 / (35.0 * omega2);  // multiplies p11^2*p12*h1^3*p22*h2*k2/(h1^3*h2^3)
    const double c_12 = (-18.0 * omega1_2 + 36.0 * omega1 * omega2 - 54.0 * omega2_2) * per_0 / (25.0 * omega2);
    const double c_13 = (9.0 * omega1_2 - 18.0 * omega1 * omega2 + 27.0 * omega2_2) * per_0 / (25.0 * omega2);
    const double c_14 = 27.0 * per_0 / (35.0 * omega2);  // multiplies p11^2*h1^3*m2*p22^2*g/(h1^3*h2^3)
    const double c_15 = -27.0 * per_0 / (35.0 * omega2);  // multiplies p11^2*h1^3*p22^2*h2*k2/(h1^3*h2^3)
    const double c_16 = 18.0 * omega2 * per_0 / 25.0;  // multiplies p11^2*h1^2*m2*p22^2*h2^2/(h1^3*h2^3)
    const double c_17 = (-18.0 * omega1_2 + 36.0 * omega1 * omega2 - 54.0 * omega2_2) * per_0 / (25.0 * omega2);
    const double c_18 = -54.0 * per_0 / (35.0 * omega2);  // multiplies p11*p12^2*h1^3*m2*p21*g/(h1^3*h2^3)
    const double c_19 = 54.0 * per_0 / (35.0 * omega2);  // multiplies p11*p12^2*h1^3*p21*h2*k2/(h1^3*h2^3)
    const double c_20 = (-18.0 * omega1_2 + 36.0 * omega1 * omega2 - 54.0 * omega2_2) * per_0 / (25.0 * omega2);
    const double c_21 = (36.0 * omega1_2 - 72.0 * omega1 * omega2 + 108.0 * omega2_2) * per_0 / (25.0 * omega2);
    const double c_22 = 108.0 * per_0 / (35.0 * omega2);  // multiplies p11*p12*h1^3*m2*p21*p22*g/(h1^3*h2^3)
    const double c_23 = -108.0 * per_0 / (35.0 * omega2);  // multiplies p11*p12*h1^3*p21*p22*h2*k2/(h1^3*h2^3)
    const double c_24 = (18.0 * omega1 - 18.0 * omega2) / (25.0 * omega2);
    const double c_25 = (-18.0 * omega1_2 + 36.0 * omega1 * omega2 - 54.0 * omega2_2) * per_0 / (25.0 * omega2);
    const double c_26 = -54.0 * per_0 / (35.0 * omega2);  // multiplies p11*h1^3*m2*p21*p22^2*g/(h1^3*h2^3)
    const double c_27 = 54.0 * per_0 / (35.0 * omega2);  // multiplies p11*h1^3*p21*p22^2*h2*k2/(h1^3*h2^3)
    const double c_28 = (9.0 * omega1_2 - 18.0 * omega1 * omega2 + 27.0 * omega2_2) * per_0 / (25.0 * omega2);
    const double c_29 = 27.0 * per_0 / (35.0 * omega2);  // multiplies p12^2*h1^3*m2*p21^2*g/(h1^3*h2^3)
    const double c_30 = -27.0 * per_0 / (35.0 * omega2);  // multiplies p12^2*h1^3*p21^2*h2*k2/(h1^3*h2^3)
    const double c_31 = 18.0 * omega2 * per_0 / 25.0;  // multiplies p12^2*h1^2*m2*p21^2*h2^2/(h1^3*h2^3)
    const double c_32 = (-18.0 * omega1_2 + 36.0 * omega1 * omega2 - 54.0 * omega2_2) * per_0 / (25.0 * omega2);
    const double c_33 = -54.0 * per_0 / (35.0 * omega2);  // multiplies p12*h1^3*m2*p21^2*p22*g/(h1^3*h2^3)
    const double c_34 = 54.0 * per_0 / (35.0 * omega2);  // multiplies p12*h1^3*p21^2*p22*h2*k2/(h1^3*h2^3)
    const double c_35 = (9.0 * omega1_2 - 18.0 * omega1 * omega2 + 27.0 * omega2_2) * per_0 / (25.0 * omega2);
    const double c_36 = 27.0 * per_0 / (35.0 * omega2);  // multiplies h1^3*m2*p21^2*p22^2*g/(h1^3*h2^3)
    const double c_37 = -27.0 * per_0 / (35.0 * omega2);  // multiplies h1^3*p21^2*p22^2*h2*k2/(h1^3*h2^3)
    gradient[2] = p11_2 * p12_2 / h1_2 * c_0 + p11_2 * p12_2 * g / h1_3 * c_1;  // by m1
    gradient[3] = 2.0 * m1 * p11 * p12_2 / h1_2 * c_0 + 2.0 * m1 * p11 * p12_2 * g / h1_3 * c_1
        + 2.0 * p11 * p12_2 * m2 / h2_2 * c_2 + 2.0 * p11 * p12_2 * m2 * g / h2_3 * c_3
        + 2.0 * p11 * p12_2 * k2 / h2_2 * c_4 + 2.0 * p11 * p12_2 * m2 / (h1 * h2) * c_5
        + 2.0 * p11 * p12_2 * m2 / h1_2 * c_6 + 2.0 * p11 * p12_2 * k1 / h1_2 * c_7
        + 2.0 * p11 * p12_2 * m2 * g / h1_3 * c_8 + 2.0 * p11 * p12 * m2 * p22 / h2_2 * c_9
        + 2.0 * p11 * p12 * m2 * p22 * g / h2_3 * c_10 + 2.0 * p11 * p12 * p22 * k2 / h2_2 * c_11
        + 2.0 * p11 * p12 * m2 * p22 / (h1 * h2) * c_12 + 2.0 * p11 * m2 * p22_2 / h2_2 * c_13
        + 2.0 * p11 * m2 * p22_2 * g / h2_3 * c_14 + 2.0 * p11 * p22_2 * k2 / h2_2 * c_15
        + 2.0 * p11 * m2 * p22_2 / (h1 * h2) * c_16 + p12_2 * m2 * p21 / h2_2 * c_17
        + p12_2 * m2 * p21 * g / h2_3 * c_18 + p12_2 * p21 * k2 / h2_2 * c_19 + p12_2 * m2 * p21 / (h1 * h2) * c_20
        + p12 * m2 * p21 * p22 / h2_2 * c_21 + p12 * m2 * p21 * p22 * g / h2_3 * c_22
        + p12 * p21 * p22 * k2 / h2_2 * c_23 + p12 * m2 * p21 * p22 / (h1 * h2) * c_24
        + m2 * p21 * p22_2 / h2_2 * c_25 + m2 * p21 * p22_2 * g / h2_3 * c_26 + p21 * p22_2 * k2 / h2_2 * c_27;
    gradient[4] = 2.0 * m1 * p11_2 * p12 / h1_2 * c_0 + 2.0 * m1 * p11_2 * p12 * g / h1_3 * c_1
        + 2.0 * p11_2 * p12 * m2 / h2_2 * c_2 + 2.0 * p11_2 * p12 * m2 * g / h2_3 * c_3
        + 2.0 * p11_2 * p12 * k2 / h2_2 * c_4 + 2.0 * p11_2 * p12 * m2 / (h1 * h2) * c_5
        + 2.0 * p11_2 * p12 * m2 / h1_2 * c_6 + 2.0 * p11_2 * p12 * k1 / h1_2 * c_7
        + 2.0 * p11_2 * p12 * m2 * g / h1_3 * c_8 + p11_2 * m2 * p22 / h2_2 * c_9
        + p11_2 * m2 * p22 * g / h2_3 * c_10 + p11_2 * p22 * k2 / h2_2 * c_11 + p11_2 * m2 * p22 / (h1 * h2) * c_12
        + 2.0 * p11 * p12 * m2 * p21 / h2_2 * c_17 + 2.0 * p11 * p12 * m2 * p21 * g / h2_3 * c_18
        + 2.0 * p11 * p12 * p21 * k2 / h2_2 * c_19 + 2.0 * p11 * p12 * m2 * p21 / (h1 * h2) * c_20
        + p11 * m2 * p21 * p22 / h2_2 * c_21 + p11 * m2 * p21 * p22 * g / h2_3 * c_22
        + p11 * p21 * p22 * k2 / h2_2 * c_23 + p11 * m2 * p21 * p22 / (h1 * h2) * c_24
        + 2.0 * p12 * m2 * p21_2 / h2_2 * c_28 + 2.0 * p12 * m2 * p21_2 * g / h2_3 * c_29
        + 2.0 * p12 * p21_2 * k2 / h2_2 * c_30 + 2.0 * p12 * m2 * p21_2 / (h1 * h2) * c_31
        + m2 * p21_2 * p22 / h2_2 * c_32 + m2 * p21_2 * p22 * g / h2_3 * c_33 + p21_2 * p22 * k2 / h2_2 * c_34;
    gradient[5] = -2.0 * m1 * p11_2 * p12_2 / h1_3 * c_0 - 3.0 * m1 * p11_2 * p12_2 * g / h1_4 * c_1
        - p11_2 * p12_2 * m2 / (h1_2 * h2) * c_5 - 2.0 * p11_2 * p12_2 * m2 / h1_3 * c_6
        - 2.0 * p11_2 * p12_2 * k1 / h1_3 * c_7 - 3.0 * p11_2 * p12_2 * m2 * g / h1_4 * c_8
        - p11_2 * p12 * m2 * p22 / (h1_2 * h2) * c_12 - p11_2 * m2 * p22_2 / (h1_2 * h2) * c_16
        - p11 * p12_2 * m2 * p21 / (h1_2 * h2) * c_20 - p11 * p12 * m2 * p21 * p22 / (h1_2 * h2) * c_24
        - p12_2 * m2 * p21_2 / (h1_2 * h2) * c_31;
    gradient[6] = p11_2 * p12_2 / h2_2 * c_2 + p11_2 * p12_2 * g / h2_3 * c_3 + p11_2 * p12_2 / (h1 * h2) * c_5
        + p11_2 * p12_2 / h1_2 * c_6 + p11_2 * p12_2 * g / h1_3 * c_8 + p11_2 * p12 * p22 / h2_2 * c_9
        + p11_2 * p12 * p22 * g / h2_3 * c_10 + p11_2 * p12 * p22 / (h1 * h2) * c_12 + p11_2 * p22_2 / h2_2 * c_13
        + p11_2 * p22_2 * g / h2_3 * c_14 + p11_2 * p22_2 / (h1 * h2) * c_16 + p11 * p12_2 * p21 / h2_2 * c_17
        + p11 * p12_2 * p21 * g / h2_3 * c_18 + p11 * p12_2 * p21 / (h1 * h2) * c_20
        + p11 * p12 * p21 * p22 / h2_2 * c_21 + p11 * p12 * p21 * p22 * g / h2_3 * c_22
        + p11 * p12 * p21 * p22 / (h1 * h2) * c_24 + p11 * p21 * p22_2 / h2_2 * c_25
        + p11 * p21 * p22_2 * g / h2_3 * c_26 + p12_2 * p21_2 / h2_2 * c_28 + p12_2 * p21_2 * g / h2_3 * c_29
        + p12_2 * p21_2 / (h1 * h2) * c_31 + p12 * p21_2 * p22 / h2_2 * c_32 + p12 * p21_2 * p22 * g / h2_3 * c_33
        + p21_2 * p22_2 / h2_2 * c_35 + p21_2 * p22_2 * g / h2_3 * c_36;
    gradient[7] = p11 * p12_2 * m2 / h2_2 * c_17 + p11 * p12_2 * m2 * g / h2_3 * c_18
        + p11 * p12_2 * k2 / h2_2 * c_19 + p11 * p12_2 * m2 / (h1 * h2) * c_20 + p11 * p12 * m2 * p22 / h2_2 * c_21
        + p11 * p12 * m2 * p22 * g / h2_3 * c_22 + p11 * p12 * p22 * k2 / h2_2 * c_23
        + p11 * p12 * m2 * p22 / (h1 * h2) * c_24 + p11 * m2 * p22_2 / h2_2 * c_25
        + p11 * m2 * p22_2 * g / h2_3 * c_26 + p11 * p22_2 * k2 / h2_2 * c_27 + 2.0 * p12_2 * m2 * p21 / h2_2 * c_28
        + 2.0 * p12_2 * m2 * p21 * g / h2_3 * c_29 + 2.0 * p12_2 * p21 * k2 / h2_2 * c_30
        + 2.0 * p12_2 * m2 * p21 / (h1 * h2) * c_31 + 2.0 * p12 * m2 * p21 * p22 / h2_2 * c_32
        + 2.0 * p12 * m2 * p21 * p22 * g / h2_3 * c_33 + 2.0 * p12 * p21 * p22 * k2 / h2_2 * c_34
        + 2.0 * m2 * p21 * p22_2 / h2_2 * c_35 + 2.0 * m2 * p21 * p22_2 * g / h2_3 * c_36
        + 2.0 * p21 * p22_2 * k2 / h2_2 * c_37;
    gradient[8] = p11_2 * p12 * m2 / h2_2 * c_9 + p11_2 * p12 * m2 * g / h2_3 * c_10
        + p11_2 * p12 * k2 / h2_2 * c_11 + p11_2 * p12 * m2 / (h1 * h2) * c_12
        + 2.0 * p11_2 * m2 * p22 / h2_2 * c_13 + 2.0 * p11_2 * m2 * p22 * g / h2_3 * c_14
        + 2.0 * p11_2 * p22 * k2 / h2_2 * c_15 + 2.0 * p11_2 * m2 * p22 / (h1 * h2) * c_16
        + p11 * p12 * m2 * p21 / h2_2 * c_21 + p11 * p12 * m2 * p21 * g / h2_3 * c_22
        + p11 * p12 * p21 * k2 / h2_2 * c_23 + p11 * p12 * m2 * p21 / (h1 * h2) * c_24
        + 2.0 * p11 * m2 * p21 * p22 / h2_2 * c_25 + 2.0 * p11 * m2 * p21 * p22 * g / h2_3 * c_26
        + 2.0 * p11 * p21 * p22 * k2 / h2_2 * c_27 + p12 * m2 * p21_2 / h2_2 * c_32
        + p12 * m2 * p21_2 * g / h2_3 * c_33 + p12 * p21_2 * k2 / h2_2 * c_34 + 2.0 * m2 * p21_2 * p22 / h2_2 * c_35
        + 2.0 * m2 * p21_2 * p22 * g / h2_3 * c_36 + 2.0 * p21_2 * p22 * k2 / h2_2 * c_37;
    gradient[9] = -2.0 * p11_2 * p12_2 * m2 / h2_3 * c_2 - 3.0 * p11_2 * p12_2 * m2 * g / h2_4 * c_3
        - 2.0 * p11_2 * p12_2 * k2 / h2_3 * c_4 - p11_2 * p12_2 * m2 / (h1 * h2_2) * c_5
        - 2.0 * p11_2 * p12 * m2 * p22 / h2_3 * c_9 - 3.0 * p11_2 * p12 * m2 * p22 * g / h2_4 * c_10
        - 2.0 * p11_2 * p12 * p22 * k2 / h2_3 * c_11 - p11_2 * p12 * m2 * p22 / (h1 * h2_2) * c_12
        - 2.0 * p11_2 * m2 * p22_2 / h2_3 * c_13 - 3.0 * p11_2 * m2 * p22_2 * g / h2_4 * c_14
        - 2.0 * p11_2 * p22_2 * k2 / h2_3 * c_15 - p11_2 * m2 * p22_2 / (h1 * h2_2) * c_16
        - 2.0 * p11 * p12_2 * m2 * p21 / h2_3 * c_17 - 3.0 * p11 * p12_2 * m2 * p21 * g / h2_4 * c_18
        - 2.0 * p11 * p12_2 * p21 * k2 / h2_3 * c_19 - p11 * p12_2 * m2 * p21 / (h1 * h2_2) * c_20
        - 2.0 * p11 * p12 * m2 * p21 * p22 / h2_3 * c_21 - 3.0 * p11 * p12 * m2 * p21 * p22 * g / h2_4 * c_22
        - 2.0 * p11 * p12 * p21 * p22 * k2 / h2_3 * c_23 - p11 * p12 * m2 * p21 * p22 / (h1 * h2_2) * c_24
        - 2.0 * p11 * m2 * p21 * p22_2 / h2_3 * c_25 - 3.0 * p11 * m2 * p21 * p22_2 * g / h2_4 * c_26
        - 2.0 * p11 * p21 * p22_2 * k2 / h2_3 * c_27 - 2.0 * p12_2 * m2 * p21_2 / h2_3 * c_28
        - 3.0 * p12_2 * m2 * p21_2 * g / h2_4 * c_29 - 2.0 * p12_2 * p21_2 * k2 / h2_3 * c_30
        - p12_2 * m2 * p21_2 / (h1 * h2_2) * c_31 - 2.0 * p12 * m2 * p21_2 * p22 / h2_3 * c_32
        - 3.0 * p12 * m2 * p21_2 * p22 * g / h2_4 * c_33 - 2.0 * p12 * p21_2 * p22 * k2 / h2_3 * c_34
        - 2.0 * m2 * p21_2 * p22_2 / h2_3 * c_35 - 3.0 * m2 * p21_2 * p22_2 * g / h2_4 * c_36
        - 2.0 * p21_2 * p22_2 * k2 / h2_3 * c_37;
    gradient[10] = p11_2 * p12_2 / h1_2 * c_7;  // by k1
    gradient[11] = p11_2 * p12_2 / h2_2 * c_4 + p11_2 * p12 * p22 / h2_2 * c_11 + p11_2 * p22_2 / h2_2 * c_15
        + p11 * p12_2 * p21 / h2_2 * c_19 + p11 * p12 * p21 * p22 / h2_2 * c_23 + p11 * p21 * p22_2 / h2_2 * c_27
        + p12_2 * p21_2 / h2_2 * c_30 + p12 * p21_2 * p22 / h2_2 * c_34 + p21_2 * p22_2 / h2_2 * c_37;
    gradient[12] = m1 * p11_2 * p12_2 / h1_3 * c_1 + p11_2 * p12_2 * m2 / h2_3 * c_3
        + p11_2 * p12_2 * m2 / h1_3 * c_8 + p11_2 * p12 * m2 * p22 / h2_3 * c_10 + p11_2 * m2 * p22_2 / h2_3 * c_14
        + p11 * p12_2 * m2 * p21 / h2_3 * c_18 + p11 * p12 * m2 * p21 * p22 / h2_3 * c_22
        + p11 * m2 * p21 * p22_2 / h2_3 * c_26 + p12_2 * m2 * p21_2 / h2_3 * c_29
        + p12 * m2 * p21_2 * p22 / h2_3 * c_33 + m2 * p21_2 * p22_2 / h2_3 * c_36;
  }
  void lump_harmonic_re_v1_A_v22_conjA_v2([[maybe_unused]] double* gradient) const {
    const double f_0 = (72.0 * omega2_2 * m1 * p11 * p12_3 * h2_2 + 72.0 * omega2_2 * p11 * p12_3 * h1_2 * m2
        + 144.0 * omega2_2 * p11 * p12_3 * h1 * m2 * h2 + 72.0 * omega2_2 * p11 * p12_3 * m2 * h2_2
        - 216.0 * omega2_2 * p11 * p12_2 * h1_2 * m2 * p22 - 216.0 * omega2_2 * p11 * p12_2 * h1 * m2 * p22 * h2
        + 216.0 * omega2_2 * p11 * p12 * h1_2 * m2 * p22_2 + 72.0 * omega2_2 * p11 * p12 * h1 * m2 * p22_2 * h2
        - 72.0 * omega2_2 * p11 * h1_2 * m2 * p22_3 - 72.0 * omega2_2 * p12_3 * h1_2 * m2 * p21
        - 72.0 * omega2_2 * p12_3 * h1 * m2 * p21 * h2 + 216.0 * omega2_2 * p12_2 * h1_2 * m2 * p21 * p22
        + 72.0 * omega2_2 * p12_2 * h1 * m2 * p21 * p22 * h2 - 216.0 * omega2_2 * p12 * h1_2 * m2 * p21 * p22_2
        + 72.0 * omega2_2 * h1_2 * m2 * p21 * p22_3) * over_1 / (25.0 * h1_2 * h2_2);
    const double f_1 = (108.0 * m1 * p11 * p12_3 * h2_3 * g + 108.0 * p11 * p12_3 * h1_3 * m2 * g
        - 108.0 * p11 * p12_3 * h1_3 * h2 * k2 - 108.0 * p11 * p12_3 * h1 * h2_3 * k1
        + 108.0 * p11 * p12_3 * m2 * h2_3 * g - 324.0 * p11 * p12_2 * h1_3 * m2 * p22 * g
        + 324.0 * p11 * p12_2 * h1_3 * p22 * h2 * k2 + 324.0 * p11 * p12 * h1_3 * m2 * p22_2 * g
        - 324.0 * p11 * p12 * h1_3 * p22_2 * h2 * k2 - 108.0 * p11 * h1_3 * m2 * p22_3 * g
        + 108.0 * p11 * h1_3 * p22_3 * h2 * k2 - 108.0 * p12_3 * h1_3 * m2 * p21 * g
        + 108.0 * p12_3 * h1_3 * p21 * h2 * k2 + 324.0 * p12_2 * h1_3 * m2 * p21 * p22 * g
        - 324.0 * p12_2 * h1_3 * p21 * p22 * h2 * k2 - 324.0 * p12 * h1_3 * m2 * p21 * p22_2 * g
        + 324.0 * p12 * h1_3 * p21 * p22_2 * h2 * k2 + 108.0 * h1_3 * m2 * p21 * p22_3 * g
        - 108.0 * h1_3 * p21 * p22_3 * h2 * k2) * over_1 / (35.0 * h1_3 * h2_3);
    const double q_0 = (f_0 + f_1) * per_0;
    const double q_2 = (f_0 + f_1) * per_2;
    gradient[0] = -q_0 - q_2;  // by omega1
    gradient[1] = 2.0 * f_0 / omega2 + q_0 - q_2;  // by omega2
    const double c_0 = 72.0 * omega2_2 * over_1 / 25.0;  // multiplies m1*p11*p12^3*h1*h2^3/(h1^3*h2^3)
    const double c_1 = 108.0 * over_1 / 35.0;  // multiplies m1*p11*p12^3*h2^3*g/(h1^3*h2^3)
    const double c_2 = 72.0 * omega2_2 * over_1 / 25.0;  // multiplies p11*p12^3*h1^3*m2*h2/(h1^3*h2^3)
    const double c_3 = 108.0 * over_1 / 35.0;  // multiplies p11*p12^3*h1^3*m2*g/(h1^3*h2^3)
    const double c_4 = -108.0 * over_1 / 35.0;  // multiplies p11*p12^3*h1^3*h2*k2/(h1^3*h2^3)
    const double c_5 = 144.0 * omega2_2 * over_1 / 25.0;  // multiplies p11*p12^3*h1^2*m2*h2^2/(h1^3*h2^3)
    const double c_6 = 72.0 * omega2_2 * over_1 / 25.0;  // multiplies p11*p12^3*h1*m2*h2^3/(h1^3*h2^3)
    const double c_7 = -108.0 * over_1 / 35.0;  // multiplies p11*p12^3*h1*h2^3*k1/(h1^3*h2^3)
    const double c_8 = 108.0 * over_1 / 35.0;  // multiplies p11*p12^3*m2*h2^3*g/(h1^3*h2^3)
    const double c_9 = -216.0 * omega2_2 * over_1 / 25.0;  // multiplies p11*p12^2*h1^3*m2*p22*h2/(h1^3*h2^3)
    const double c_10 = -324.0 * over_1 / 35.0;  // multiplies p11*p12^2*h1^3*m2*p22*g/(h1^3*h2^3)
    const double c_11 = 324.0 * over_1 / 35.0;  // multiplies p11*p12^2*h1^3*p22*h2*k2/(h1^3*h2^3)
    const double c_12 = -216.0 * omega2_2 * over_1 / 25.0;  // multiplies p11*p12^2*h1^2*m2*p22*h2^2/(h1^3*h2^3)
    const double c_13 = 216.0 * omega2_2 * over_1 / 25.0;  // multiplies p11*p12*h1^3*m2*p22^2*h2/(h1^3*h2^3)
    const double c_14 = 324.0 * over_1 / 35.0;  // multiplies p11*p12*h1^3*m2*p22^2*g/(h1^3*h2^3)
    const double c_15 = -324.0 * over_1 / 35.0;  // multiplies p11*p12*h1^3*p22^2*h2*k2/(h1^3*h2^3)
    const double c_16 = 72.0 * omega2_2 * over_1 / 25.0;  // multiplies p11*p12*h1^2*m2*p22^2*h2^2/(h1^3*h2^3)
    const double c_17 = -72.0 * omega2_2 * over_1 / 25.0;  // multiplies p11*h1^3*m2*p22^3*h2/(h1^3*h2^3)
    const double c_18 = -108.0 * over_1 / 35.0;  // multiplies p11*h1^3*m2*p22^3*g/(h1^3*h2^3)
    const double c_19 = 108.0 * over_1 / 35.0;  // multiplies p11*h1^3*p22^3*h2*k2/(h1^3*h2^3)
    const double c_20 = -72.0 * omega2_2 * over_1 / 25.0;  // multiplies p12^3*h1^3*m2*p21*h2/(h1^3*h2^3)
    const double c_21 = -108.0 * over_1 / 35.0;  // multiplies p12^3*h1^3*m2*p21*g/(h1^3*h2^3)
    const double c_22 = 108.0 * over_1 / 35.0;  // multiplies p12^3*h1^3*p21*h2*k2/(h1^3*h2^3)
    const double c_23 = -72.0 * omega2_2 * over_1 / 25.0;  // multiplies p12^3*h1^2*m2*p21*h2^2/(h1^3*h2^3)
    const double c_24 = 216.0 * omega2_2 * over_1 / 25.0;  // multiplies p12^2*h1^3*m2*p21*p22*h2/(h1^3*h2^3)
    const double c_25 = 324.0 * over_1 / 35.0;  // multiplies p12^2*h1^3*m2*p21*p22*g/(h1^3*h2^3)
    const double c_26 = -324.0 * over_1 / 35.0;  // multiplies p12^2*h1^3*p21*p22*h2*k2/(h1^3*h2^3)
    const double c_27 = 72.0 * omega2_2 * over_1 / 25.0;  // multiplies p12^2*h1^2*m2*p21*p22*h2^2/(h1^3*h2^3)
    const double c_28 = -216.0 * omega2_2 * over_1 / 25.0;  // multiplies p12*h1^3*m2*p21*p22^2*h2/(h1^3*h2^3)
    const double c_29 = -324.0 * over_1 / 35.0;  // multiplies p12*h1^3*m2*p21*p22^2*g/(h1^3*h2^3)
    const double c_30 = 324.0 * over_1 / 35.0;  // multiplies p12*h1^3*p21*p22^2*h2*k2/(h1^3*h2^3)
    const double c_31 = 72.0 * omega2_2 * over_1 / 25.0;  // multiplies h1^3*m2*p21*p22^3*h2/(h1^3*h2^3)
    const double c_32 = 108.0 * over_1 / 35.0;  // multiplies h1^3*m2*p21*p22^3*g/(h1^3*h2^3)
    const double c_33 = -108.0 * over_1 / 35.0;  // multiplies h1^3*p21*p22^3*h2*k2/(h1^3*h2^3)
    gradient[2] = p11 * p12_3 / h1_2 * c_0 + p11 * p12_3 * g / h1_3 * c_1;  // by m1
    gradient[3] = m1 * p12_3 / h1_2 * c_0 + m1 * p12_3 * g / h1_3 * c_1 + p12_3 * m2 / h2_2 * c_2
        + p12_3 * m2 * g / h2_3 * c_3 + p12_3 * k2 / h2_2 * c_4 + p12_3 * m2 / (h1 * h2) * c_5
        + p12_3 * m2 / h1_2 * c_6 + p12_3 * k1 / h1_2 * c_7 + p12_3 * m2 * g / h1_3 * c_8
        + p12_2 * m2 * p22 / h2_2 * c_9 + p12_2 * m2 * p22 * g / h2_3 * c_10 + p12_2 * p22 * k2 / h2_2 * c_11
        + p12_2 * m2 * p22 / (h1 * h2) * c_12 + p12 * m2 * p22_2 / h2_2 * c_13 + p12 * m2 * p22_2 * g / h2_3 * c_14
        + p12 * p22_2 * k2 / h2_2 * c_15 + p12 * m2 * p22_2 / (h1 * h2) * c_16 + m2 * p22_3 / h2_2 * c_17
        + m2 * p22_3 * g / h2_3 * c_18 + p22_3 * k2 / h2_2 * c_19;
    gradient[4] = 3.0 * m1 * p11 * p12_2 / h1_2 * c_0 + 3.0 * m1 * p11 * p12_2 * g / h1_3 * c_1
        + 3.0 * p11 * p12_2 * m2 / h2_2 * c_2 + 3.0 * p11 * p12_2 * m2 * g / h2_3 * c_3
        + 3.0 * p11 * p12_2 * k2 / h2_2 * c_4 + 3.0 * p11 * p12_2 * m2 / (h1 * h2) * c_5
        + 3.0 * p11 * p12_2 * m2 / h1_2 * c_6 + 3.0 * p11 * p12_2 * k1 / h1_2 * c_7
        + 3.0 * p11 * p12_2 * m2 * g / h1_3 * c_8 + 2.0 * p11 * p12 * m2 * p22 / h2_2 * c_9
        + 2.0 * p11 * p12 * m2 * p22 * g / h2_3 * c_10 + 2.0 * p11 * p12 * p22 * k2 / h2_2 * c_11
        + 2.0 * p11 * p12 * m2 * p22 / (h1 * h2) * c_12 + p11 * m2 * p22_2 / h2_2 * c_13
        + p11 * m2 * p22_2 * g / h2_3 * c_14 + p11 * p22_2 * k2 / h2_2 * c_15 + p11 * m2 * p22_2 / (h1 * h2) * c_16
        + 3.0 * p12_2 * m2 * p21 / h2_2 * c_20 + 3.0 * p12_2 * m2 * p21 * g / h2_3 * c_21
        + 3.0 * p12_2 * p21 * k2 / h2_2 * c_22 + 3.0 * p12_2 * m2 * p21 / (h1 * h2) * c_23
        + 2.0 * p12 * m2 * p21 * p22 / h2_2 * c_24 + 2.0 * p12 * m2 * p21 * p22 * g / h2_3 * c_25
        + 2.0 * p12 * p21 * p22 * k2 / h2_2 * c_26 + 2.0 * p12 * m2 * p21 * p22 / (h1 * h2) * c_27
        + m2 * p21 * p22_2 / h2_2 * c_28 + m2 * p21 * p22_2 * g / h2_3 * c_29 + p21 * p22_2 * k2 / h2_2 * c_30;
    gradient[5] = -2.0 * m1 * p11 * p12_3 / h1_3 * c_0 - 3.0 * m1 * p11 * p12_3 * g / h1_4 * c_1
        - p11 * p12_3 * m2 / (h1_2 * h2) * c_5 - 2.0 * p11 * p12_3 * m2 / h1_3 * c_6
        - 2.0 * p11 * p12_3 * k1 / h1_3 * c_7 - 3.0 * p11 * p12_3 * m2 * g / h1_4 * c_8
        - p11 * p12_2 * m2 * p22 / (h1_2 * h2) * c_12 - p11 * p12 * m2 * p22_2 / (h1_2 * h2) * c_16
        - p12_3 * m2 * p21 / (h1_2 * h2) * c_23 - p12_2 * m2 * p21 * p22 / (h1_2 * h2) * c_27;
    gradient[6] = p11 * p12_3 / h2_2 * c_2 + p11 * p12_3 * g / h2_3 * c_3 + p11 * p12_3 / (h1 * h2) * c_5
        + p11 * p12_3 / h1_2 * c_6 + p11 * p12_3 * g / h1_3 * c_8 + p11 * p12_2 * p22 / h2_2 * c_9
        + p11 * p12_2 * p22 * g / h2_3 * c_10 + p11 * p12_2 * p22 / (h1 * h2) * c_12
        + p11 * p12 * p22_2 / h2_2 * c_13 + p11 * p12 * p22_2 * g / h2_3 * c_14
        + p11 * p12 * p22_2 / (h1 * h2) * c_16 + p11 * p22_3 / h2_2 * c_17 + p11 * p22_3 * g / h2_3 * c_18
        + p12_3 * p21 / h2_2 * c_20 + p12_3 * p21 * g / h2_3 * c_21 + p12_3 * p21 / (h1 * h2) * c_23
        + p12_2 * p21 * p22 / h2_2 * c_24 + p12_2 * p21 * p22 * g / h2_3 * c_25
        + p12_2 * p21 * p22 / (h1 * h2) * c_27 + p12 * p21 * p22_2 / h2_2 * c_28
        + p12 * p21 * p22_2 * g / h2_3 * c_29 + p21 * p22_3 / h2_2 * c_31 + p21 * p22_3 * g / h2_3 * c_32;
    gradient[7] = p12_3 * m2 / h2_2 * c_20 + p12_3 * m2 * g / h2_3 * c_21 + p12_3 * k2 / h2_2 * c_22
        + p12_3 * m2 / (h1 * h2) * c_23 + p12_2 * m2 * p22 / h2_2 * c_24 + p12_2 * m2 * p22 * g / h2_3 * c_25
        + p12_2 * p22 * k2 / h2_2 * c_26 + p12_2 * m2 * p22 / (h1 * h2) * c_27 + p12 * m2 * p22_2 / h2_2 * c_28
        + p12 * m2 * p22_2 * g / h2_3 * c_29 + p12 * p22_2 * k2 / h2_2 * c_30 + m2 * p22_3 / h2_2 * c_31
        + m2 * p22_3 * g / h2_3 * c_32 + p22_3 * k2 / h2_2 * c_33;
    gradient[8] = p11 * p12_2 * m2 / h2_2 * c_9 + p11 * p12_2 * m2 * g / h2_3 * c_10
        + p11 * p12_2 * k2 / h2_2 * c_11 + p11 * p12_2 * m2 / (h1 * h2) * c_12
        + 2.0 * p11 * p12 * m2 * p22 / h2_2 * c_13 + 2.0 * p11 * p12 * m2 * p22 * g / h2_3 * c_14
        + 2.0 * p11 * p12 * p22 * k2 / h2_2 * c_15 + 2.0 * p11 * p12 * m2 * p22 / (h1 * h2) * c_16
        + 3.0 * p11 * m2 * p22_2 / h2_2 * c_17 + 3.0 * p11 * m2 * p22_2 * g / h2_3 * c_18
        + 3.0 * p11 * p22_2 * k2 / h2_2 * c_19 + p12_2 * m2 * p21 / h2_2 * c_24 + p12_2 * m2 * p21 * g / h2_3 * c_25
        + p12_2 * p21 * k2 / h2_2 * c_26 + p12_2 * m2 * p21 / (h1 * h2) * c_27
        + 2.0 * p12 * m2 * p21 * p22 / h2_2 * c_28 + 2.0 * p12 * m2 * p21 * p22 * g / h2_3 * c_29
        + 2.0 * p12 * p21 * p22 * k2 / h2_2 * c_30 + 3.0 * m2 * p21 * p22_2 / h2_2 * c_31
        + 3.0 * m2 * p21 * p22_2 * g / h2_3 * c_32 + 3.0 * p21 * p22_2 * k2 / h2_2 * c_33;
    gradient[9] = -2.0 * p11 * p12_3 * m2 / h2_3 * c_2 - 3.0 * p11 * p12_3 * m2 * g / h2_4 * c_3
        - 2.0 * p11 * p12_3 * k2 / h2_3 * c_4 - p11 * p12_3 * m2 / (h1 * h2_2) * c_5
        - 2.0 * p11 * p12_2 * m2 * p22 / h2_3 * c_9 - 3.0 * p11 * p12_2 * m2 * p22 * g / h2_4 * c_10
        - 2.0 * p11 * p12_2 * p22 * k2 / h2_3 * c_11 - p11 * p12_2 * m2 * p22 / (h1 * h2_2) * c_12
        - 2.0 * p11 * p12 * m2 * p22_2 / h2_3 * c_13 - 3.0 * p11 * p12 * m2 * p22_2 * g / h2_4 * c_14
        - 2.0 * p11 * p12 * p22_2 * k2 / h2_3 * c_15 - p11 * p12 * m2 * p22_2 / (h1 * h2_2) * c_16
        - 2.0 * p11 * m2 * p22_3 / h2_3 * c_17 - 3.0 * p11 * m2 * p22_3 * g / h2_4 * c_18
        - 2.0 * p11 * p22_3 * k2 / h2_3 * c_19 - 2.0 * p12_3 * m2 * p21 / h2_3 * c_20
        - 3.0 * p12_3 * m2 * p21 * g / h2_4 * c_21 - 2.0 * p12_3 * p21 * k2 / h2_3 * c_22
        - p12_3 * m2 * p21 / (h1 * h2_2) * c_23 - 2.0 * p12_2 * m2 * p21 * p22 / h2_3 * c_24
        - 3.0 * p12_2 * m2 * p21 * p22 * g / h2_4 * c_25 - 2.0 * p12_2 * p21 * p22 * k2 / h2_3 * c_26
        - p12_2 * m2 * p21 * p22 / (h1 * h2_2) * c_27 - 2.0 * p12 * m2 * p21 * p22_2 / h2_3 * c_28
        - 3.0 * p12 * m2 * p21 * p22_2 * g / h2_4 * c_29 - 2.0 * p12 * p21 * p22_2 * k2 / h2_3 * c_30
        - 2.0 * m2 * p21 * p22_3 / h2_3 * c_31 - 3.0 * m2 * p21 * p22_3 * g / h2_4 * c_32
        - 2.0 * p21 * p22_3 * k2 / h2_3 * c_33;
    gradient[10] = p11 * p12_3 / h1_2 * c_7;  // by k1
    gradient[11] = p11 * p12_3 / h2_2 * c_4 + p11 * p12_2 * p22 / h2_2 * c_11 + p11 * p12 * p22_2 / h2_2 * c_15
        + p11 * p22_3 / h2_2 * c_19 + p12_3 * p21 / h2_2 * c_22 + p12_2 * p21 * p22 / h2_2 * c_26
        + p12 * p21 * p22_2 / h2_2 * c_30 + p21 * p22_3 / h2_2 * c_33;
    gradient[12] = m1 * p11 * p12_3 / h1_3 * c_1 + p11 * p12_3 * m2 / h2_3 * c_3 + p11 * p12_3 * m2 / h1_3 * c_8
        + p11 * p12_2 * m2 * p22 / h2_3 * c_10 + p11 * p12 * m2 * p22_2 / h2_3 * c_14
        + p11 * m2 * p22_3 / h2_3 * c_18 + p12_3 * m2 * p21 / h2_3 * c_21 + p12_2 * m2 * p21 * p22 / h2_3 * c_25
        + p12 * m2 * p21 * p22_2 / h2_3 * c_29 + m2 * p21 * p22_3 / h2_3 * c_32;
  }
  void lump_harmonic_re_v1_A_v1_A_v2_conjA_v1([[maybe_unused]] double* gradient) const {
    const double f_0 = (72.0 * omega1_2 * m1 * p11_3 * p12 * h2_2 + 72.0 * omega1_2 * p11_3 * p12 * h1_2 * m2
        + 144.0 * omega1_2 * p11_3 * p12 * h1 * m2 * h2 + 72.0 * omega1_2 * p11_3 * p12 * m2 * h2_2
        - 72.0 * omega1_2 * p11_3 * h1_2 * m2 * p22 - 72.0 * omega1_2 * p11_3 * h1 * m2 * p22 * h2
        - 216.0 * omega1_2 * p11_2 * p12 * h1_2 * m2 * p21 - 216.0 * omega1_2 * p11_2 * p12 * h1 * m2 * p21 * h2
        + 216.0 * omega1_2 * p11_2 * h1_2 * m2 * p21 * p22 + 72.0 * omega1_2 * p11_2 * h1 * m2 * p21 * p22 * h2
        + 216.0 * omega1_2 * p11 * p12 * h1_2 * m2 * p21_2 + 72.0 * omega1_2 * p11 * p12 * h1 * m2 * p21_2 * h2
        - 216.0 * omega1_2 * p11 * h1_2 * m2 * p21_2 * p22 - 72.0 * omega1_2 * p12 * h1_2 * m2 * p21_3
        + 72.0 * omega1_2 * h1_2 * m2 * p21_3 * p22) * over_1 / (25.0 * h1_2 * h2_2);
    const double f_1 = (72.0 * omega2_2 * m1 * p11_3 * p12 * h2_2 + 72.0 * omega2_2 * p11_3 * p12 * h1_2 * m2
        + 144.0 * omega2_2 * p11_3 * p12 * h1 * m2 * h2 + 72.0 * omega2_2 * p11_3 * p12 * m2 * h2_2
        - 72.0 * omega2_2 * p11_3 * h1_2 * m2 * p22 - 72.0 * omega2_2 * p11_3 * h1 * m2 * p22 * h2
        - 216.0 * omega2_2 * p11_2 * p12 * h1_2 * m2 * p21 - 216.0 * omega2_2 * p11_2 * p12 * h1 * m2 * p21 * h2
        + 216.0 * omega2_2 * p11_2 * h1_2 * m2 * p21 * p22 + 72.0 * omega2_2 * p11_2 * h1 * m2 * p21 * p22 * h2
        + 216.0 * omega2_2 * p11 * p12 * h1_2 * m2 * p21_2 + 72.0 * omega2_2 * p11 * p12 * h1 * m2 * p21_2 * h2
        - 216.0 * omega2_2 * p11 * h1_2 * m2 * p21_2 * p22 - 72.0 * omega2_2 * p12 * h1_2 * m2 * p21_3
        + 72.0 * omega2_2 * h1_2 * m2 * p21_3 * p22) * over_1 / (25.0 * h1_2 * h2_2);
    const double f_2 = (216.0 * m1 * p11_3 * p12 * h2_3 * g + 216.0 * p11_3 * p12 * h1_3 * m2 * g
        - 216.0 * p11_3 * p12 * h1_3 * h2 * k2 - 216.0 * p11_3 * p12 * h1 * h2_3 * k1
        + 216.0 * p11_3 * p12 * m2 * h2_3 * g - 216.0 * p11_3 * h1_3 * m2 * p22 * g
        + 216.0 * p11_3 * h1_3 * p22 * h2 * k2 - 648.0 * p11_2 * p12 * h1_3 * m2 * p21 * g
        + 648.0 * p11_2 * p12 * h1_3 * p21 * h2 * k2 + 648.0 * p11_2 * h1_3 * m2 * p21 * p22 * g
        - 648.0 * p11_2 * h1_3 * p21 * p22 * h2 * k2 + 648.0 * p11 * p12 * h1_3 * m2 * p21_2 * g
        - 648.0 * p11 * p12 * h1_3 * p21_2 * h2 * k2 - 648.0 * p11 * h1_3 * m2 * p21_2 * p22 * g
        + 648.0 * p11 * h1_3 * p21_2 * p22 * h2 * k2 - 216.0 * p12 * h1_3 * m2 * p21_3 * g
        + 216.0 * p12 * h1_3 * p21_3 * h2 * k2 + 216.0 * h1_3 * m2 * p21_3 * p22 * g
        - 216.0 * h1_3 * p21_3 * p22 * h2 * k2) * over_1 / (35.0 * h1_3 * h2_3);
    const double q_0 = (f_0 + f_1 + f_2) * per_0;
    const double q_2 = (f_0 + f_1 + f_2) * per_2;
    gradient[0] = 2.0 * f_0 / omega1 - q_0 - q_2;  // by omega1
    gradient[1] = 2.0 * f_1 / omega2 + q_0 - q_2;  // by omega2
    const double c_0 = (72.0 * omega1_2 + 72.0 * omega2_2) * over_1 / 25.0;
    const double c_1 = 216.0 * over_1 / 35.0;  // multiplies m1*p11^3*p12*h2^3*g/(h1^3*h2^3)
    const double c_2 = (72.0 * omega1_2 + 72.0 * omega2_2) * over_1 / 25.0;
    const double c_3 = 216.0 * over_1 / 35.0;  // multiplies p11^3*p12*h1^3*m2*g/(h1^3*h2^3)
    const double c_4 = -216.0 * over_1 / 35.0;  // multiplies p11^3*p12*h1^3*h2*k2/(h1^3*h2^3)
    const double c_5 = (144.0 * omega1_2 + 144.0 * omega2_2) * over_1 / 25.0;
    const double c_6 = (72.0 * omega1_2 + 72.0 * omega2_2) * over_1 / 25.0;
    const double c_7 = -216.0 * over_1 / 35.0;  // multiplies p11^3*p12*h1*h2^3*k1/(h1^3*h2^3)
    const double c_8 = 216.0 * over_1 / 35.0;  // multiplies p11^3*p12*m2*h2^3*g/(h1^3*h2^3)
    const double c_9 = (-72.0 * omega1_2 - 72.0 * omega2_2) * over_1 / 25.0;
    const double c_10 = -216.0 * over_1 / 35.0;  // multiplies p11^3*h1^3*m2*p22*g/(h1^3*h2^3)
    const double c_11 = 216.0 * over_1 / 35.0;  // multiplies p11^3*h1^3*p22*h2*k2/(h1^3*h2^3)
    const double c_12 = (-72.0 * omega1_2 - 72.0 * omega2_2) * over_1 / 25.0;
    const double c_13 = (-216.0 * omega1_2 - 216.0 * omega2_2) * over_1 / 25.0;
    const double c_14 = -648.0 * over_1 / 35.0;  // multiplies p11^2*p12*h1^3*m2*p21*g/(h1^3*h2^3)
    const double c_15 = 648.0 * over_1 / 35.0;  // multiplies p11^2*p12*h1^3*p21*h2*k2/(h1^3*h2^3)
    const double c_16 = (-216.0 * omega1_2 - 216.0 * omega2_2) * over_1 / 25.0;
    const double c_17 = (216.0 * omega1_2 + 216.0 * omega2_2) * over_1 / 25.0;
    const double c_18 = 648.0 * over_1 / 35.0;  // multiplies p11^2*h1^3*m2*p21*p22*g/(h1^3*h2^3)
    const double c_19 = -648.0 * over_1 / 35.0;  // multiplies p11^2*h1^3*p21*p22*h2*k2/(h1^3*h2^3)
    const double c_20 = (72.0 * omega1_2 + 72.0 * omega2_2) * over_1 / 25.0;
    const double c_21 = (216.0 * omega1_2 + 216.0 * omega2_2) * over_1 / 25.0;
    const double c_22 = 648.0 * over_1 / 35.0;  // multiplies p11*p12*h1^3*m2*p21^2*g/(h1^3*h2^3)
    const double c_23 = -648.0 * over_1 / 35.0;  // multiplies p11*p12*h1^3*p21^2*h2*k2/(h1^3*h2^3)
    const double c_24 = (72.0 * omega1_2 + 72.0 * omega2_2) * over_1 / 25.0;
    const double c_25 = (-216.0 * omega1_2 - 216.0 * omega2_2) * over_1 / 25.0;
    const double c_26 = -648.0 * over_1 / 35.0;  // multiplies p11*h1^3*m2*p21^2*p22*g/(h1^3*h2^3)
    const double c_27 = 648.0 * over_1 / 35.0;  // multiplies p11*h1^3*p21^2*p22*h2*k2/(h1^3*h2^3)
    const double c_28 = (-72.0 * omega1_2 - 72.0 * omega2_2) * over_1 / 25.0;
    const double c_29 = -216.0 * over_1 / 35.0;  // multiplies p12*h1^3*m2*p21^3*g/(h1^3*h2^3)
    const double c_30 = 216.0 * over_1 / 35.0;  // multiplies p12*h1^3*p21^3*h2*k2/(h1^3*h2^3)
    const double c_31 = (72.0 * omega1_2 + 72.0 * omega2_2) * over_1 / 25.0;
    const double c_32 = 216.0 * over_1 / 35.0;  // multiplies h1^3*m2*p21^3*p22*g/(h1^3*h2^3)
    const double c_33 = -216.0 * over_1 / 35.0;  // multiplies h1^3*p21^3*p22*h2*k2/(h1^3*h2^3)
    gradient[2] = p11_3 * p12 / h1_2 * c_0 + p11_3 * p12 * g / h1_3 * c_1;  // by m1
    gradient[3] = 3.0 * m1 * p11_2 * p12 / h1_2 * c_0 + 3.0 * m1 * p11_2 * p12 * g / h1_3 * c_1
        + 3.0 * p11_2 * p12 * m2 / h2_2 * c_2 + 3.0 * p11_2 * p12 * m2 * g / h2_3 * c_3
        + 3.0 * p11_2 * p12 * k2 / h2_2 * c_4 + 3.0 * p11_2 * p12 * m2 / (h1 * h2) * c_5
        + 3.0 * p11_2 * p12 * m2 / h1_2 * c_6 + 3.0 * p11_2 * p12 * k1 / h1_2 * c_7
        + 3.0 * p11_2 * p12 * m2 * g / h1_3 * c_8 + 3.0 * p11_2 * m2 * p22 / h2_2 * c_9
        + 3.0 * p11_2 * m2 * p22 * g / h2_3 * c_10 + 3.0 * p11_2 * p22 * k2 / h2_2 * c_11
        + 3.0 * p11_2 * m2 * p22 / (h1 * h2) * c_12 + 2.0 * p11 * p12 * m2 * p21 / h2_2 * c_13
        + 2.0 * p11 * p12 * m2 * p21 * g / h2_3 * c_14 + 2.0 * p11 * p12 * p21 * k2 / h2_2 * c_15
        + 2.0 * p11 * p12 * m2 * p21 / (h1 * h2) * c_16 + 2.0 * p11 * m2 * p21 * p22 / h2_2 * c_17
        + 2.0 * p11 * m2 * p21 * p22 * g / h2_3 * c_18 + 2.0 * p11 * p21 * p22 * k2 / h2_2 * c_19
        + 2.0 * p11 * m2 * p21 * p22 / (h1 * h2) * c_20 + p12 * m2 * p21_2 / h2_2 * c_21
        + p12 * m2 * p21_2 * g / h2_3 * c_22 + p12 * p21_2 * k2 / h2_2 * c_23 + p12 * m2 * p21_2 / (h1 * h2) * c_24
        + m2 * p21_2 * p22 / h2_2 * c_25 + m2 * p21_2 * p22 * g / h2_3 * c_26 + p21_2 * p22 * k2 / h2_2 * c_27;
    gradient[4] = m1 * p11_3 / h1_2 * c_0 + m1 * p11_3 * g / h1_3 * c_1 + p11_3 * m2 / h2_2 * c_2
        + p11_3 * m2 * g / h2_3 * c_3 + p11_3 * k2 / h2_2 * c_4 + p11_3 * m2 / (h1 * h2) * c_5
        + p11_3 * m2 / h1_2 * c_6 + p11_3 * k1 / h1_2 * c_7 + p11_3 * m2 * g / h1_3 * c_8
        + p11_2 * m2 * p21 / h2_2 * c_13 + p11_2 * m2 * p21 * g / h2_3 * c_14 + p11_2 * p21 * k2 / h2_2 * c_15
        + p11_2 * m2 * p21 / (h1 * h2) * c_16 + p11 * m2 * p21_2 / h2_2 * c_21 + p11 * m2 * p21_2 * g / h2_3 * c_22
        + p11 * p21_2 * k2 / h2_2 * c_23 + p11 * m2 * p21_2 / (h1 * h2) * c_24 + m2 * p21_3 / h2_2 * c_28
        + m2 * p21_3 * g / h2_3 * c_29 + p21_3 * k2 / h2_2 * c_30;
    gradient[5] = -2.0 * m1 * p11_3 * p12 / h1_3 * c_0 - 3.0 * m1 * p11_3 * p12 * g / h1_4 * c_1
        - p11_3 * p12 * m2 / (h1_2 * h2) * c_5 - 2.0 * p11_3 * p12 * m2 / h1_3 * c_6
        - 2.0 * p11_3 * p12 * k1 / h1_3 * c_7 - 3.0 * p11_3 * p12 * m2 * g / h1_4 * c_8
        - p11_3 * m2 * p22 / (h1_2 * h2) * c_12 - p11_2 * p12 * m2 * p21 / (h1_2 * h2) * c_16
        - p11_2 * m2 * p21 * p22 / (h1_2 * h2) * c_20 - p11 * p12 * m2 * p21_2 / (h1_2 * h2) * c_24;
    gradient[6] = p11_3 * p12 / h2_2 * c_2 + p11_3 * p12 * g / h2_3 * c_3 + p11_3 * p12 / (h1 * h2) * c_5
        + p11_3 * p12 / h1_2 * c_6 + p11_3 * p12 * g / h1_3 * c_8 + p11_3 * p22 / h2_2 * c_9
        + p11_3 * p22 * g / h2_3 * c_10 + p11_3 * p22 / (h1 * h2) * c_12 + p11_2 * p12 * p21 / h2_2 * c_13
        + p11_2 * p12 * p21 * g / h2_3 * c_14 + p11_2 * p12 * p21 / (h1 * h2) * c_16
        + p11_2 * p21 * p22 / h2_2 * c_17 + p11_2 * p21 * p22 * g / h2_3 * c_18
        + p11_2 * p21 * p22 / (h1 * h2) * c_20 + p11 * p12 * p21_2 / h2_2 * c_21
        + p11 * p12 * p21_2 * g / h2_3 * c_22 + p11 * p12 * p21_2 / (h1 * h2) * c_24
        + p11 * p21_2 * p22 / h2_2 * c_25 + p11 * p21_2 * p22 * g / h2_3 * c_26 + p12 * p21_3 / h2_2 * c_28
        + p12 * p21_3 * g / h2_3 * c_29 + p21_3 * p22 / h2_2 * c_31 + p21_3 * p22 * g / h2_3 * c_32;
    gradient[7] = p11_2 * p12 * m2 / h2_2 * c_13 + p11_2 * p12 * m2 * g / h2_3 * c_14
        + p11_2 * p12 * k2 / h2_2 * c_15 + p11_2 * p12 * m2 / (h1 * h2) * c_16 + p11_2 * m2 * p22 / h2_2 * c_17
        + p11_2 * m2 * p22 * g / h2_3 * c_18 + p11_2 * p22 * k2 / h2_2 * c_19 + p11_2 * m2 * p22 / (h1 * h2) * c_20
        + 2.0 * p11 * p12 * m2 * p21 / h2_2 * c_21 + 2.0 * p11 * p12 * m2 * p21 * g / h2_3 * c_22
        + 2.0 * p11 * p12 * p21 * k2 / h2_2 * c_23 + 2.0 * p11 * p12 * m2 * p21 / (h1 * h2) * c_24
        + 2.0 * p11 * m2 * p21 * p22 / h2_2 * c_25 + 2.0 * p11 * m2 * p21 * p22 * g / h2_3 * c_26
        + 2.0 * p11 * p21 * p22 * k2 / h2_2 * c_27 + 3.0 * p12 * m2 * p21_2 / h2_2 * c_28
        + 3.0 * p12 * m2 * p21_2 * g / h2_3 * c_29 + 3.0 * p12 * p21_2 * k2 / h2_2 * c_30
        + 3.0 * m2 * p21_2 * p22 / h2_2 * c_31 + 3.0 * m2 * p21_2 * p22 * g / h2_3 * c_32
        + 3.0 * p21_2 * p22 * k2 / h2_2 * c_33;
    gradient[8] = p11_3 * m2 / h2_2 * c_9 + p11_3 * m2 * g / h2_3 * c_10 + p11_3 * k2 / h2_2 * c_11
        + p11_3 * m2 / (h1 * h2) * c_12 + p11_2 * m2 * p21 / h2_2 * c_17 + p11_2 * m2 * p21 * g / h2_3 * c_18
        + p11_2 * p21 * k2 / h2_2 * c_19 + p11_2 * m2 * p21 / (h1 * h2) * c_20 + p11 * m2 * p21_2 / h2_2 * c_25
        + p11 * m2 * p21_2 * g / h2_3 * c_26 + p11 * p21_2 * k2 / h2_2 * c_27 + m2 * p21_3 / h2_2 * c_31
        + m2 * p21_3 * g / h2_3 * c_32 + p21_3 * k2 / h2_2 * c_33;
    gradient[9] = -2.0 * p11_3 * p12 * m2 / h2_3 * c_2 - 3.0 * p11_3 * p12 * m2 * g / h2_4 * c_3
        - 2.0 * p11_3 * p12 * k2 / h2_3 * c_4 - p11_3 * p12 * m2 / (h1 * h2_2) * c_5
        - 2.0 * p11_3 * m2 * p22 / h2_3 * c_9 - 3.0 * p11_3 * m2 * p22 * g / h2_4 * c_10
        - 2.0 * p11_3 * p22 * k2 / h2_3 * c_11 - p11_3 * m2 * p22 / (h1 * h2_2) * c_12
        - 2.0 * p11_2 * p12 * m2 * p21 / h2_3 * c_13 - 3.0 * p11_2 * p12 * m2 * p21 * g / h2_4 * c_14
        - 2.0 * p11_2 * p12 * p21 * k2 / h2_3 * c_15 - p11_2 * p12 * m2 * p21 / (h1 * h2_2) * c_16
        - 2.0 * p11_2 * m2 * p21 * p22 / h2_3 * c_17 - 3.0 * p11_2 * m2 * p21 * p22 * g / h2_4 * c_18
        - 2.0 * p11_2 * p21 * p22 * k2 / h2_3 * c_19 - p11_2 * m2 * p21 * p22 / (h1 * h2_2) * c_20
        - 2.0 * p11 * p12 * m2 * p21_2 / h2_3 * c_21 - 3.0 * p11 * p12 * m2 * p21_2 * g / h2_4 * c_22
        - 2.0 * p11 * p12 * p21_2 * k2 / h2_3 * c_23 - p11 * p12 * m2 * p21_2 / (h1 * h2_2) * c_24
        - 2.0 * p11 * m2 * p21_2 * p22 / h2_3 * c_25 - 3.0 * p11 * m2 * p21_2 * p22 * g / h2_4 * c_26
        - 2.0 * p11 * p21_2 * p22 * k2 / h2_3 * c_27 - 2.0 * p12 * m2 * p21_3 / h2_3 * c_28
        - 3.0 * p12 * m2 * p21_3 * g / h2_4 * c_29 - 2.0 * p12 * p21_3 * k2 / h2_3 * c_30
        - 2.0 * m2 * p21_3 * p22 / h2_3 * c_31 - 3.0 * m2 * p21_3 * p22 * g / h2_4 * c_32
        - 2.0 * p21_3 * p22 * k2 / h2_3 * c_33;
    gradient[10] = p11_3 * p12 / h1_2 * c_7;  // by k1
    gradient[11] = p11_3 * p12 / h2_2 * c_4 + p11_3 * p22 / h2_2 * c_11 + p11_2 * p12 * p21 / h2_2 * c_15
        + p11_2 * p21 * p22 / h2_2 * c_19 + p11 * p12 * p21_2 / h2_2 * c_23 + p11 * p21_2 * p22 / h2_2 * c_27
        + p12 * p21_3 / h2_2 * c_30 + p21_3 * p22 / h2_2 * c_33;
    gradient[12] = m1 * p11_3 * p12 / h1_3 * c_1 + p11_3 * p12 * m2 / h2_3 * c_3 + p11_3 * p12 * m2 / h1_3 * c_8
        + p11_3 * m2 * p22 / h2_3 * c_10 + p11_2 * p12 * m2 * p21 / h2_3 * c_14
        + p11_2 * m2 * p21 * p22 / h2_3 * c_18 + p11 * p12 * m2 * p21_2 / h2_3 * c_22
        + p11 * m2 * p21_2 * p22 / h2_3 * c_26 + p12 * m2 * p21_3 / h2_3 * c_29 + m2 * p21_3 * p22 / h2_3 * c_32;
  }
  void lump_harmonic_re_v1_A_v12_A_v2([[maybe_unused]] double* gradient) const {
    const double f_0 = (-108.0 * omega1_2 * m1 * p11_3 * p12 * h2_2 - 108.0 * omega1_2 * p11_3 * p12 * h1_2 * m2
        - 216.0 * omega1_2 * p11_3 * p12 * h1 * m2 * h2 - 108.0 * omega1_2 * p11_3 * p12 * m2 * h2_2
        + 108.0 * omega1_2 * p11_3 * h1_2 * m2 * p22 + 108.0 * omega1_2 * p11_3 * h1 * m2 * p22 * h2
        + 324.0 * omega1_2 * p11_2 * p12 * h1_2 * m2 * p21 + 324.0 * omega1_2 * p11_2 * p12 * h1 * m2 * p21 * h2
        - 324.0 * omega1_2 * p11_2 * h1_2 * m2 * p21 * p22 - 108.0 * omega1_2 * p11_2 * h1 * m2 * p21 * p22 * h2
        - 324.0 * omega1_2 * p11 * p12 * h1_2 * m2 * p21_2 - 108.0 * omega1_2 * p11 * p12 * h1 * m2 * p21_2 * h2
        + 324.0 * omega1_2 * p11 * h1_2 * m2 * p21_2 * p22 + 108.0 * omega1_2 * p12 * h1_2 * m2 * p21_3
        - 108.0 * omega1_2 * h1_2 * m2 * p21_3 * p22) * over_2 / (25.0 * h1_2 * h2_2);
    const double f_1 = (-72.0 * omega1 * omega2 * m1 * p11_3 * p12 * h2_2
        - 72.0 * omega1 * omega2 * p11_3 * p12 * h1_2 * m2 - 144.0 * omega1 * omega2 * p11_3 * p12 * h1 * m2 * h2
        - 72.0 * omega1 * omega2 * p11_3 * p12 * m2 * h2_2 + 72.0 * omega1 * omega2 * p11_3 * h1_2 * m2 * p22
        + 72.0 * omega1 * omega2 * p11_3 * h1 * m2 * p22 * h2
        + 216.0 * omega1 * omega2 * p11_2 * p12 * h1_2 * m2 * p21
        + 216.0 * omega1 * omega2 * p11_2 * p12 * h1 * m2 * p21 * h2
        - 216.0 * omega1 * omega2 * p11_2 * h1_2 * m2 * p21 * p22
        - 72.0 * omega1 * omega2 * p11_2 * h1 * m2 * p21 * p22 * h2
        - 216.0 * omega1 * omega2 * p11 * p12 * h1_2 * m2 * p21_2
        - 72.0 * omega1 * omega2 * p11 * p12 * h1 * m2 * p21_2 * h2
        + 216.0 * omega1 * omega2 * p11 * h1_2 * m2 * p21_2 * p22 + 72.0 * omega1 * omega2 * p12 * h1_2 * m2 * p21_3
        - 72.0 * omega1 * omega2 * h1_2 * m2 * p21_3 * p22) * over_2 / (25.0 * h1_2 * h2_2);
    const double f_2 = (-36.0 * omega2_2 * m1 * p11_3 * p12 * h2_2 - 36.0 * omega2_2 * p11_3 * p12 * h1_2 * m2
        - 72.0 * omega2_2 * p11_3 * p12 * h1 * m2 * h2 - 36.0 * omega2_2 * p11_3 * p12 * m2 * h2_2
        + 36.0 * omega2_2 * p11_3 * h1_2 * m2 * p22 + 36.0 * omega2_2 * p11_3 * h1 * m2 * p22 * h2
        + 108.0 * omega2_2 * p11_2 * p12 * h1_2 * m2 * p21 + 108.0 * omega2_2 * p11_2 * p12 * h1 * m2 * p21 * h2
        - 108.0 * omega2_2 * p11_2 * h1_2 * m2 * p21 * p22 - 36.0 * omega2_2 * p11_2 * h1 * m2 * p21 * p22 * h2
        - 108.0 * omega2_2 * p11 * p12 * h1_2 * m2 * p21_2 - 36.0 * omega2_2 * p11 * p12 * h1 * m2 * p21_2 * h2
        + 108.0 * omega2_2 * p11 * h1_2 * m2 * p21_2 * p22 + 36.0 * omega2_2 * p12 * h1_2 * m2 * p21_3
        - 36.0 * omega2_2 * h1_2 * m2 * p21_3 * p22) * over_2 / (25.0 * h1_2 * h2_2);
    const double f_3 = (-108.0 * m1 * p11_3 * p12 * h2_3 * g - 108.0 * p11_3 * p12 * h1_3 * m2 * g
        + 108.0 * p11_3 * p12 * h1_3 * h2 * k2 + 108.0 * p11_3 * p12 * h1 * h2_3 * k1
        - 108.0 * p11_3 * p12 * m2 * h2_3 * g + 108.0 * p11_3 * h1_3 * m2 * p22 * g
        - 108.0 * p11_3 * h1_3 * p22 * h2 * k2 + 324.0 * p11_2 * p12 * h1_3 * m2 * p21 * g
        - 324.0 * p11_2 * p12 * h1_3 * p21 * h2 * k2 - 324.0 * p11_2 * h1_3 * m2 * p21 * p22 * g
        + 324.0 * p11_2 * h1_3 * p21 * p22 * h2 * k2 - 324.0 * p11 * p12 * h1_3 * m2 * p21_2 * g
        + 324.0 * p11 * p12 * h1_3 * p21_2 * h2 * k2 + 324.0 * p11 * h1_3 * m2 * p21_2 * p22 * g
        - 324.0 * p11 * h1_3 * p21_2 * p22 * h2 * k2 + 108.0 * p12 * h1_3 * m2 * p21_3 * g
        - 108.0 * p12 * h1_3 * p21_3 * h2 * k2 - 108.0 * h1_3 * m2 * p21_3 * p22 * g
        + 108.0 * h1_3 * p21_3 * p22 * h2 * k2) * over_2 / (35.0 * h1_3 * h2_3);
    const double q_2 = (f_0 + f_1 + f_2 + f_3) * per_2;
    const double q_3 = (f_0 + f_1 + f_2 + f_3) * per_3;
    gradient[0] = (2.0 * f_0 + f_1) / omega1 - q_2 - 3.0 * q_3;  // by omega1
    gradient[1] = (f_1 + 2.0 * f_2) / omega2 - q_2 - q_3;  // by omega2
    const double c_0 = (-108.0 * omega1_2 - 72.0 * omega1 * omega2 - 36.0 * omega2_2) * over_2 / 25.0;
    const double c_1 = -108.0 * over_2 / 35.0;  // multiplies m1*p11^3*p12*h2^3*g/(h1^3*h2^3)
    const double c_2 = (-108.0 * omega1_2 - 72.0 * omega1 * omega2 - 36.0 * omega2_2) * over_2 / 25.0;
    const double c_3 = -108.0 * over_2 / 35.0;  // multiplies p11^3*p12*h1^3*m2*g/(h1^3*h2^3)
    const double c_4 = 108.0 * over_2 / 35.0;  // multiplies p11^3*p12*h1^3*h2*k2/(h1^3*h2^3)
    const double c_5 = (-216.0 * omega1_2 - 144.0 * omega1 * omega2 - 72.0 * omega2_2) * over_2 / 25.0;
    const double c_6 = (-108.0 * omega1_2 - 72.0 * omega1 * omega2 - 36.0 * omega2_2) * over_2 / 25.0;
    const double c_7 = 108.0 * over_2 / 35.0;  // multiplies p11^3*p12*h1*h2^3*k1/(h1^3*h2^3)
    const double c_8 = -108.0 * over_2 / 35.0;  // multiplies p11^3*p12*m2*h2^3*g/(h1^3*h2^3)
    const double c_9 = (108.0 * omega1_2 + 72.0 * omega1 * omega2 + 36.0 * omega2_2) * over_2 / 25.0;
    const double c_10 = 108.0 * over_2 / 35.0;  // multiplies p11^3*h1^3*m2*p22*g/(h1^3*h2^3)
    const double c_11 = -108.0 * over_2 / 35.0;  // multiplies p11^3*h1^3*p22*h2*k2/(h1^3*h2^3)
    const double c_12 = (108.0 * omega1_2 + 72.0 * omega1 * omega2 + 36.0 * omega2_2) * over_2 / 25.0;
    const double c_13 = (324.0 * omega1_2 + 216.0 * omega1 * omega2 + 108.0 * omega2_2) * over_2 / 25.0;
    const double c_14 = 324.0 * over_2 / 35.0;  // multiplies p11^2*p12*h1^3*m2*p21*g/(h1^3*h2^3)
    const double c_15 = -324.0 * over_2 / 35.0;  // multiplies p11^2*p12*h1^3*p21*h2*k2/(h1^3*h2^3)
    const double c_16 = (324.0 * omega1_2 + 216.0 * omega1 * omega2 + 108.0 * omega2_2) * over_2 / 25.0;
    const double c_17 = (-324.0 * omega1_2 - 216.0 * omega1 * omega2 - 108.0 * omega2_2) * over_2 / 25.0;
    const double c_18 = -324.0 * over_2 / 35.0;  // multiplies p11^2*h1^3*m2*p21*p22*g/(h1^3*h2^3)
    const double c_19 = 324.0 * over_2 / 35.0;  // multiplies p11^2*h1^3*p21*p22*h2*k2/(h1^3*h2^3)
    const double c_20 = (-108.0 * omega1_2 - 72.0 * omega1 * omega2 - 36.0 * omega2_2) * over_2 / 25.0;
    const double c_21 = (-324.0 * omega1_2 - 216.0 * omega1 * omega2 - 108.0 * omega2_2) * over_2 / 25.0;
    const double c_22 = -324.0 * over_2 / 35.0;  // multiplies p11*p12*h1^3*m2*p21^2*g/(h1^3*h2^3)
    const double c_23 = 324.0 * over_2 / 35.0;  // multiplies p11*p12*h1^3*p21^2*h2*k2/(h1^3*h2^3)
    const double c_24 = (-108.0 * omega1_2 - 72.0 * omega1 * omega2 - 36.0 * omega2_2) * over_2 / 25.0;
    const double c_25 = (324.0 * omega1_2 + 216.0 * omega1 * omega2 + 108.0 * omega2_2) * over_2 / 25.0;
    const double c_26 = 324.0 * over_2 / 35.0;  // multiplies p11*h1^3*m2*p21^2*p22*g/(h1^3*h2^3)
    const double c_27 = -324.0 * over_2 / 35.0;  // multiplies p11*h1^3*p21^2*p22*h2*k2/(h1^3*h2^3)
    const double c_28 = (108.0 * omega1_2 + 72.0 * omega1 * omega2 + 36.0 * omega2_2) * over_2 / 25.0;
    const double c_29 = 108.0 * over_2 / 35.0;  // multiplies p12*h1^3*m2*p21^3*g/(h1^3*h2^3)
    const double c_30 = -108.0 * over_2 / 35.0;  // multiplies p12*h1^3*p21^3*h2*k2/(h1^3*h2^3)
    const double c_31 = (-108.0 * omega1_2 - 72.0 * omega1 * omega2 - 36.0 * omega2_2) * over_2 / 25.0;
    const double c_32 = -108.0 * over_2 / 35.0;  // multiplies h1^3*m2*p21^3*p22*g/(h1^3*h2^3)
    const double c_33 = 108.0 * over_2 / 35.0;  // multiplies h1^3*p21^3*p22*h2*k2/(h1^3*h2^3)
    gradient[2] = p11_3 * p12 / h1_2 * c_0 + p11_3 * p12 * g / h1_3 * c_1;  // by m1
    gradient[3] = 3.0 * m1 * p11_2 * p12 / h1_2 * c_0 + 3.0 * m1 * p11_2 * p12 * g / h1_3 * c_1
        + 3.0 * p11_2 * p12 * m2 / h2_2 * c_2 + 3.0 * p11_2 * p12 * m2 * g / h2_3 * c_3
        + 3.0 * p11_2 * p12 * k2 / h2_2 * c_4 + 3.0 * p11_2 * p12 * m2 / (h1 * h2) * c_5
        + 3.0 * p11_2 * p12 * m2 / h1_2 * c_6 + 3.0 * p11_2 * p12 * k1 / h1_2 * c_7
        + 3.0 * p11_2 * p12 * m2 * g / h1_3 * c_8 + 3.0 * p11_2 * m2 * p22 / h2_2 * c_9
        + 3.0 * p11_2 * m2 * p22 * g / h2_3 * c_10 + 3.0 * p11_2 * p22 * k2 / h2_2 * c_11
        + 3.0 * p11_2 * m2 * p22 / (h1 * h2) * c_12 + 2.0 * p11 * p12 * m2 * p21 / h2_2 * c_13
        + 2.0 * p11 * p12 * m2 * p21 * g / h2_3 * c_14 + 2.0 * p11 * p12 * p21 * k2 / h2_2 * c_15
        + 2.0 * p11 * p12 * m2 * p21 / (h1 * h2) * c_16 + 2.0 * p11 * m2 * p21 * p22 / h2_2 * c_17
        + 2.0 * p11 * m2 * p21 * p22 * g / h2_3 * c_18 + 2.0 * p11 * p21 * p22 * k2 / h2_2 * c_19
        + 2.0 * p11 * m2 * p21 * p22 / (h1 * h2) * c_20 + p12 * m2 * p21_2 / h2_2 * c_21
        + p12 * m2 * p21_2 * g / h2_3 * c_22 + p12 * p21_2 * k2 / h2_2 * c_23 + p12 * m2 * p21_2 / (h1 * h2) * c_24
        + m2 * p21_2 * p22 / h2_2 * c_25 + m2 * p21_2 * p22 * g / h2_3 * c_26 + p21_2 * p22 * k2 / h2_2 * c_27;
    gradient[4] = m1 * p11_3 / h1_2 * c_0 + m1 * p11_3 * g / h1_3 * c_1 + p11_3 * m2 / h2_2 * c_2
        + p11_3 * m2 * g / h2_3 * c_3 + p11_3 * k2 / h2_2 * c_4 + p11_3 * m2 / (h1 * h2) * c_5
        + p11_3 * m2 / h1_2 * c_6 + p11_3 * k1 / h1_2 * c_7 + p11_3 * m2 * g / h1_3 * c_8
        + p11_2 * m2 * p21 / h2_2 * c_13 + p11_2 * m2 * p21 * g / h2_3 * c_14 + p11_2 * p21 * k2 / h2_2 * c_15
        + p11_2 * m2 * p21 / (h1 * h2) * c_16 + p11 * m2 * p21_2 / h2_2 * c_21 + p11 * m2 * p21_2 * g / h2_3 * c_22
        + p11 * p21_2 * k2 / h2_2 * c_23 + p11 * m2 * p21_2 / (h1 * h2) * c_24 + m2 * p21_3 / h2_2 * c_28
        + m2 * p21_3 * g / h2_3 * c_29 + p21_3 * k2 / h2_2 * c_30;
    gradient[5] = -2.0 * m1 * p11_3 * p12 / h1_3 * c_0 - 3.0 * m1 * p11_3 * p12 * g / h1_4 * c_1
        - p11_3 * p12 * m2 / (h1_2 * h2) * c_5 - 2.0 * p11_3 * p12 * m2 / h1_3 * c_6
        - 2.0 * p11_3 * p12 * k1 / h1_3 * c_7 - 3.0 * p11_3 * p12 * m2 * g / h1_4 * c_8
        - p11_3 * m2 * p22 / (h1_2 * h2) * c_12 - p11_2 * p12 * m2 * p21 / (h1_2 * h2) * c_16
        - p11_2 * m2 * p21 * p22 / (h1_2 * h2) * c_20 - p11 * p12 * m2 * p21_2 / (h1_2 * h2) * c_24;
    gradient[6] = p11_3 * p12 / h2_2 * c_2 + p11_3 * p12 * g / h2_3 * c_3 + p11_3 * p12 / (h1 * h2) * c_5
        + p11_3 * p12 / h1_2 * c_6 + p11_3 * p12 * g / h1_3 * c_8 + p11_3 * p22 / h2_2 * c_9
        + p11_3 * p22 * g / h2_3 * c_10 + p11_3 * p22 / (h1 * h2) * c_12 + p11_2 * p12 * p21 / h2_2 * c_13
        + p11_2 * p12 * p21 * g / h2_3 * c_14 + p11_2 * p12 * p21 / (h1 * h2) * c_16
        + p11_2 * p21 * p22 / h2_2 * c_17 + p11_2 * p21 * p22 * g / h2_3 * c_18
        + p11_2 * p21 * p22 / (h1 * h2) * c_20 + p11 * p12 * p21_2 / h2_2 * c_21
        + p11 * p12 * p21_2 * g / h2_3 * c_22 + p11 * p12 * p21_2 / (h1 * h2) * c_24
        + p11 * p21_2 * p22 / h2_2 * c_25 + p11 * p21_2 * p22 * g / h2_3 * c_26 + p12 * p21_3 / h2_2 * c_28
        + p12 * p21_3 * g / h2_3 * c_29 + p21_3 * p22 / h2_2 * c_31 + p21_3 * p22 * g / h2_3 * c_32;
    gradient[7] = p11_2 * p12 * m2 / h2_2 * c_13 + p11_2 * p12 * m2 * g / h2_3 * c_14
        + p11_2 * p12 * k2 / h2_2 * c_15 + p11_2 * p12 * m2 / (h1 * h2) * c_16 + p11_2 * m2 * p22 / h2_2 * c_17
        + p11_2 * m2 * p22 * g / h2_3 * c_18 + p11_2 * p22 * k2 / h2_2 * c_19 + p11_2 * m2 * p22 / (h1 * h2) * c_20
        + 2.0 * p11 * p12 * m2 * p21 / h2_2 * c_21 + 2.0 * p11 * p12 * m2 * p21 * g / h2_3 * c_22
        + 2.0 * p11 * p12 * p21 * k2 / h2_2 * c_23 + 2.0 * p11 * p12 * m2 * p21 / (h1 * h2) * c_24
        + 2.0 * p11 * m2 * p21 * p22 / h2_2 * c_25 + 2.0 * p11 * m2 * p21 * p22 * g / h2_3 * c_26
        + 2.0 * p11 * p21 * p22 * k2 / h2_2 * c_27 + 3.0 * p12 * m2 * p21_2 / h2_2 * c_28
        + 3.0 * p12 * m2 * p21_2 * g / h2_3 * c_29 + 3.0 * p12 * p21_2 * k2 / h2_2 * c_30
        + 3.0 * m2 * p21_2 * p22 / h2_2 * c_31 + 3.0 * m2 * p21_2 * p22 * g / h2_3 * c_32
        + 3.0 * p21_2 * p22 * k2 / h2_2 * c_33;
    gradient[8] = p11_3 * m2 / h2_2 * c_9 + p11_3 * m2 * g / h2_3 * c_10 + p11_3 * k2 / h2_2 * c_11
        + p11_3 * m2 / (h1 * h2) * c_12 + p11_2 * m2 * p21 / h2_2 * c_17 + p11_2 * m2 * p21 * g / h2_3 * c_18
        + p11_2 * p21 * k2 / h2_2 * c_19 + p11_2 * m2 * p21 / (h1 * h2) * c_20 + p11 * m2 * p21_2 / h2_2 * c_25
        + p11 * m2 * p21_2 * g / h2_3 * c_26 + p11 * p21_2 * k2 / h2_2 * c_27 + m2 * p21_3 / h2_2 * c_31
        + m2 * p21_3 * g / h2_3 * c_32 + p21_3 * k2 / h2_2 * c_33;
    gradient[9] = -2.0 * p11_3 * p12 * m2 / h2_3 * c_2 - 3.0 * p11_3 * p12 * m2 * g / h2_4 * c_3
        - 2.0 * p11_3 * p12 * k2 / h2_3 * c_4 - p11_3 * p12 * m2 / (h1 * h2_2) * c_5
        - 2.0 * p11_3 * m2 * p22 / h2_3 * c_9 - 3.0 * p11_3 * m2 * p22 * g / h2_4 * c_10
        - 2.0 * p11_3 * p22 * k2 / h2_3 * c_11 - p11_3 * m2 * p22 / (h1 * h2_2) * c_12
        - 2.0 * p11_2 * p12 * m2 * p21 / h2_3 * c_13 - 3.0 * p11_2 * p12 * m2 * p21 * g / h2_4 * c_14
        - 2.0 * p11_2 * p12 * p21 * k2 / h2_3 * c_15 - p11_2 * p12 * m2 * p21 / (h1 * h2_2) * c_16
        - 2.0 * p11_2 * m2 * p21 * p22 / h2_3 * c_17 - 3.0 * p11_2 * m2 * p21 * p22 * g / h2_4 * c_18
        - 2.0 * p11_2 * p21 * p22 * k2 / h2_3 * c_19 - p11_2 * m2 * p21 * p22 / (h1 * h2_2) * c_20
        - 2.0 * p11 * p12 * m2 * p21_2 / h2_3 * c_21 - 3.0 * p11 * p12 * m2 * p21_2 * g / h2_4 * c_22
        - 2.0 * p11 * p12 * p21_2 * k2 / h2_3 * c_23 - p11 * p12 * m2 * p21_2 / (h1 * h2_2) * c_24
        - 2.0 * p11 * m2 * p21_2 * p22 / h2_3 * c_25 - 3.0 * p11 * m2 * p21_2 * p22 * g / h2_4 * c_26
        - 2.0 * p11 * p21_2 * p22 * k2 / h2_3 * c_27 - 2.0 * p12 * m2 * p21_3 / h2_3 * c_28
        - 3.0 * p12 * m2 * p21_3 * g / h2_4 * c_29 - 2.0 * p12 * p21_3 * k2 / h2_3 * c_30
        - 2.0 * m2 * p21_3 * p22 / h2_3 * c_31 - 3.0 * m2 * p21_3 * p22 * g / h2_4 * c_32
        - 2.0 * p21_3 * p22 * k2 / h2_3 * c_33;
    gradient[10] = p11_3 * p12 / h1_2 * c_7;  // by k1
    gradient[11] = p11_3 * p12 / h2_2 * c_4 + p11_3 * p22 / h2_2 * c_11 + p11_2 * p12 * p21 / h2_2 * c_15
        + p11_2 * p21 * p22 / h2_2 * c_19 + p11 * p12 * p21_2 / h2_2 * c_23 + p11 * p21_2 * p22 / h2_2 * c_27
        + p12 * p21_3 / h2_2 * c_30 + p21_3 * p22 / h2_2 * c_33;
    gradient[12] = m1 * p11_3 * p12 / h1_3 * c_1 + p11_3 * p12 * m2 / h2_3 * c_3 + p11_3 * p12 * m2 / h1_3 * c_8
        + p11_3 * m2 * p22 / h2_3 * c_10 + p11_2 * p12 * m2 * p21 / h2_3 * c_14
        + p11_2 * m2 * p21 * p22 / h2_3 * c_18 + p11 * p12 * m2 * p21_2 / h2_3 * c_22
        + p11 * m2 * p21_2 * p22 / h2_3 * c_26 + p12 * m2 * p21_3 / h2_3 * c_29 + m2 * p21_3 * p22 / h2_3 * c_32;
  }
  void lump_harmonic_re_v1_A_v23([[maybe_unused]] double* gradient) const {
    const double f_0 = (72.0 * omega2_2 * m1 * p11 * p12_3 * h2_2 + 72.0 * omega2_2 * p11 * p12_3 * h1_2 * m2
        + 144.0 * omega2_2 * p11 * p12_3 * h1 * m2 * h2 + 72.0 * omega2_2 * p11 * p12_3 * m2 * h2_2
        - 216.0 * omega2_2 * p11 * p12_2 * h1_2 * m2 * p22 - 216.0 * omega2_2 * p11 * p12_2 * h1 * m2 * p22 * h2
        + 216.0 * omega2_2 * p11 * p12 * h1_2 * m2 * p22_2 + 72.0 * omega2_2 * p11 * p12 * h1 * m2 * p22_2 * h2
        - 72.0 * omega2_2 * p11 * h1_2 * m2 * p22_3 - 72.0 * omega2_2 * p12_3 * h1_2 * m2 * p21
        - 72.0 * omega2_2 * p12_3 * h1 * m2 * p21 * h2 + 216.0 * omega2_2 * p12_2 * h1_2 * m2 * p21 * p22
        + 72.0 * omega2_2 * p12_2 * h1 * m2 * p21 * p22 * h2 - 216.0 * omega2_2 * p12 * h1_2 * m2 * p21 * p22_2
        + 72.0 * omega2_2 * h1_2 * m2 * p21 * p22_3) * over_3 / (25.0 * h1_2 * h2_2);
    const double f_1 = (36.0 * m1 * p11 * p12_3 * h2_3 * g + 36.0 * p11 * p12_3 * h1_3 * m2 * g
        - 36.0 * p11 * p12_3 * h1_3 * h2 * k2 - 36.0 * p11 * p12_3 * h1 * h2_3 * k1
        + 36.0 * p11 * p12_3 * m2 * h2_3 * g - 108.0 * p11 * p12_2 * h1_3 * m2 * p22 * g
        + 108.0 * p11 * p12_2 * h1_3 * p22 * h2 * k2 + 108.0 * p11 * p12 * h1_3 * m2 * p22_2 * g
        - 108.0 * p11 * p12 * h1_3 * p22_2 * h2 * k2 - 36.0 * p11 * h1_3 * m2 * p22_3 * g
        + 36.0 * p11 * h1_3 * p22_3 * h2 * k2 - 36.0 * p12_3 * h1_3 * m2 * p21 * g
        + 36.0 * p12_3 * h1_3 * p21 * h2 * k2 + 108.0 * p12_2 * h1_3 * m2 * p21 * p22 * g
        - 108.0 * p12_2 * h1_3 * p21 * p22 * h2 * k2 - 108.0 * p12 * h1_3 * m2 * p21 * p22_2 * g
        + 108.0 * p12 * h1_3 * p21 * p22_2 * h2 * k2 + 36.0 * h1_3 * m2 * p21 * p22_3 * g
        - 36.0 * h1_3 * p21 * p22_3 * h2 * k2) * over_3 / (35.0 * h1_3 * h2_3);
    const double q_4 = (f_0 + f_1) * per_4;
    const double q_5 = (f_0 + f_1) * per_5;
    gradient[0] = -q_4 - q_5;  // by omega1
    gradient[1] = 2.0 * f_0 / omega2 - 3.0 * q_4 + 3.0 * q_5;  // by omega2
    const double c_0 = 72.0 * omega2_2 * over_3 / 25.0;  // multiplies m1*p11*p12^3*h1*h2^3/(h1^3*h2^3)
    const double c_1 = 36.0 * over_3 / 35.0;  // multiplies m1*p11*p12^3*h2^3*g/(h1^3*h2^3)
    const double c_2 = 72.0 * omega2_2 * over_3 / 25.0;  // multiplies p11*p12^3*h1^3*m2*h2/(h1^3*h2^3)
    const double c_3 = 36.0 * over_3 / 35.0;  // multiplies p11*p12^3*h1^3*m2*g/(h1^3*h2^3)
    const double c_4 = -36.0 * over_3 / 35.0;  // multiplies p11*p12^3*h1^3*h2*k2/(h1^3*h2^3)
    const double c_5 = 144.0 * omega2_2 * over_3 / 25.0;  // multiplies p11*p12^3*h1^2*m2*h2^2/(h1^3*h2^3)
    const double c_6 = 72.0 * omega2_2 * over_3 / 25.0;  // multiplies p11*p12^3*h1*m2*h2^3/(h1^3*h2^3)
    const double c_7 = -36.0 * over_3 / 35.0;  // multiplies p11*p12^3*h1*h2^3*k1/(h1^3*h2^3)
    const double c_8 = 36.0 * over_3 / 35.0;  // multiplies p11*p12^3*m2*h2^3*g/(h1^3*h2^3)
    const double c_9 = -216.0 * omega2_2 * over_3 / 25.0;  // multiplies p11*p12^2*h1^3*m2*p22*h2/(h1^3*h2^3)
    const double c_10 = -108.0 * over_3 / 35.0;  // multiplies p11*p12^2*h1^3*m2*p22*g/(h1^3*h2^3)
    const double c_11 = 108.0 * over_3 / 35.0;  // multiplies p11*p12^2*h1^3*p22*h2*k2/(h1^3*h2^3)
    const double c_12 = -216.0 * omega2_2 * over_3 / 25.0;  // multiplies p11*p12^2*h1^2*m2*p22*h2^2/(h1^3*h2^3)
    const double c_13 = 216.0 * omega2_2 * over_3 / 25.0;  // multiplies p11*p12*h1^3*m2*p22^2*h2/(h1^3*h2^3)
    const double c_14 = 108.0 * over_3 / 35.0;  // multiplies p11*p12*h1^3*m2*p22^2*g/(h1^3*h2^3)
    const double c_15 = -108.0 * over_3 / 35.0;  // multiplies p11*p12*h1^3*p22^2*h2*k2/(h1^3*h2^3)
    const double c_16 = 72.0 * omega2_2 * over_3 / 25.0;  // multiplies p11*p12*h1^2*m2*p22^2*h2^2/(h1^3*h2^3)
    const double c_17 = -72.0 * omega2_2 * over_3 / 25.0;  // multiplies p11*h1^3*m2*p22^3*h2/(h1^3*h2^3)
    const double c_18 = -36.0 * over_3 / 35.0;  // multiplies p11*h1^3*m2*p22^3*g/(h1^3*h2^3)
    const double c_19 = 36.0 * over_3 / 35.0;  // multiplies p11*h1^3*p22^3*h2*k2/(h1^3*h2^3)
    const double c_20 = -72.0 * omega2_2 * over_3 / 25.0;  // multiplies p12^3*h1^3*m2*p21*h2/(h1^3*h2^3)
    const double c_21 = -36.0 * over_3 / 35.0;  // multiplies p12^3*h1^3*m2*p21*g/(h1^3*h2^3)
    const double c_22 = 36.0 * over_3 / 35.0;  // multiplies p12^3*h1^3*p21*h2*k2/(h1^3*h2^3)
    const double c_23 = -72.0 * omega2_2 * over_3 / 25.0;  // multiplies p12^3*h1^2*m2*p21*h2^2/(h1^3*h2^3)
    const double c_24 = 216.0 * omega2_2 * over_3 / 25.0;  // multiplies p12^2*h1^3*m2*p21*p22*h2/(h1^3*h2^3)
    const double c_25 = 108.0 * over_3 / 35.0;  // multiplies p12^2*h1^3*m2*p21*p22*g/(h1^3*h2^3)
    const double c_26 = -108.0 * over_3 / 35.0;  // multiplies p12^2*h1^3*p21*p22*h2*k2/(h1^3*h2^3)
    const double c_27 = 72.0 * omega2_2 * over_3 / 25.0;  // multiplies p12^2*h1^2*m2*p21*p22*h2^2/(h1^3*h2^3)
    const double c_28 = -216.0 * omega2_2 * over_3 / 25.0;  // multiplies p12*h1^3*m2*p21*p22^2*h2/(h1^3*h2^3)
    const double c_29 = -108.0 * over_3 / 35.0;  // multiplies p12*h1^3*m2*p21*p22^2*g/(h1^3*h2^3)
    const double c_30 = 108.0 * over_3 / 35.0;  // multiplies p12*h1^3*p21*p22^2*h2*k2/(h1^3*h2^3)
    const double c_31 = 72.0 * omega2_2 * over_3 / 25.0;  // multiplies h1^3*m2*p21*p22^3*h2/(h1^3*h2^3)
    const double c_32 = 36.0 * over_3 / 35.0;  // multiplies h1^3*m2*p21*p22^3*g/(h1^3*h2^3)
    const double c_33 = -36.0 * over_3 / 35.0;  // multiplies h1^3*p21*p22^3*h2*k2/(h1^3*h2^3)
    gradient[2] = p11 * p12_3 / h1_2 * c_0 + p11 * p12_3 * g / h1_3 * c_1;  // by m1
    gradient[3] = m1 * p12_3 / h1_2 * c_0 + m1 * p12_3 * g / h1_3 * c_1 + p12_3 * m2 / h2_2 * c_2
        + p12_3 * m2 * g / h2_3 * c_3 + p12_3 * k2 / h2_2 * c_4 + p12_3 * m2 / (h1 * h2) * c_5
        + p12_3 * m2 / h1_2 * c_6 + p12_3 * k1 / h1_2 * c_7 + p12_3 * m2 * g / h1_3 * c_8
        + p12_2 * m2 * p22 / h2_2 * c_9 + p12_2 * m2 * p22 * g / h2_3 * c_10 + p12_2 * p22 * k2 / h2_2 * c_11
        + p12_2 * m2 * p22 / (h1 * h2) * c_12 + p12 * m2 * p22_2 / h2_2 * c_13 + p12 * m2 * p22_2 * g / h2_3 * c_14
        + p12 * p22_2 * k2 / h2_2 * c_15 + p12 * m2 * p22_2 / (h1 * h2) * c_16 + m2 * p22_3 / h2_2 * c_17
        + m2 * p22_3 * g / h2_3 * c_18 + p22_3 * k2 / h2_2 * c_19;
    gradient[4] = 3.0 * m1 * p11 * p12_2 / h1_2 * c_0 + 3.0 * m1 * p11 * p12_2 * g / h1_3 * c_1
        + 3.0 * p11 * p12_2 * m2 / h2_2 * c_2 + 3.0 * p11 * p12_2 * m2 * g / h2_3 * c_3
        + 3.0 * p11 * p12_2 * k2 / h2_2 * c_4 + 3.0 * p11 * p12_2 * m2 / (h1 * h2) * c_5
        + 3.0 * p11 * p12_2 * m2 / h1_2 * c_6 + 3.0 * p11 * p12_2 * k1 / h1_2 * c_7
        + 3.0 * p11 * p12_2 * m2 * g / h1_3 * c_8 + 2.0 * p11 * p12 * m2 * p22 / h2_2 * c_9
        + 2.0 * p11 * p12 * m2 * p22 * g / h2_3 * c_10 + 2.0 * p11 * p12 * p22 * k2 / h2_2 * c_11
        + 2.0 * p11 * p12 * m2 * p22 / (h1 * h2) * c_12 + p11 * m2 * p22_2 / h2_2 * c_13
        + p11 * m2 * p22_2 * g / h2_3 * c_14 + p11 * p22_2 * k2 / h2_2 * c_15 + p11 * m2 * p22_2 / (h1 * h2) * c_16
        + 3.0 * p12_2 * m2 * p21 / h2_2 * c_20 + 3.0 * p12_2 * m2 * p21 * g / h2_3 * c_21
        + 3.0 * p12_2 * p21 * k2 / h2_2 * c_22 + 3.0 * p12_2 * m2 * p21 / (h1 * h2) * c_23
        + 2.0 * p12 * m2 * p21 * p22 / h2_2 * c_24 + 2.0 * p12 * m2 * p21 * p22 * g / h2_3 * c_25
        + 2.0 * p12 * p21 * p22 * k2 / h2_2 * c_26 + 2.0 * p12 * m2 * p21 * p22 / (h1 * h2) * c_27
        + m2 * p21 * p22_2 / h2_2 * c_28 + m2 * p21 * p22_2 * g / h2_3 * c_29 + p21 * p22_2 * k2 / h2_2 * c_30;
    gradient[5] = -2.0 * m1 * p11 * p12_3 / h1_3 * c_0 - 3.0 * m1 * p11 * p12_3 * g / h1_4 * c_1
        - p11 * p12_3 * m2 / (h1_2 * h2) * c_5 - 2.0 * p11 * p12_3 * m2 / h1_3 * c_6
        - 2.0 * p11 * p12_3 * k1 / h1_3 * c_7 - 3.0 * p11 * p12_3 * m2 * g / h1_4 * c_8
        - p11 * p12_2 * m2 * p22 / (h1_2 * h2) * c_12 - p11 * p12 * m2 * p22_2 / (h1_2 * h2) * c_16
        - p12_3 * m2 * p21 / (h1_2 * h2) * c_23 - p12_2 * m2 * p21 * p22 / (h1_2 * h2) * c_27;
    gradient[6] = p11 * p12_3 / h2_2 * c_2 + p11 * p12_3 * g / h2_3 * c_3 + p11 * p12_3 / (h1 * h2) * c_5
        + p11 * p12_3 / h1_2 * c_6 + p11 * p12_3 * g / h1_3 * c_8 + p11 * p12_2 * p22 / h2_2 * c_9
        + p11 * p12_2 * p22 * g / h2_3 * c_10 + p11 * p12_2 * p22 / (h1 * h2) * c_12
        + p11 * p12 * p22_2 / h2_2 * c_13 + p11 * p12 * p22_2 * g / h2_3 * c_14
        + p11 * p12 * p22_2 / (h1 * h2) * c_16 + p11 * p22_3 / h2_2 * c_17 + p11 * p22_3 * g / h2_3 * c_18
        + p12_3 * p21 / h2_2 * c_20 + p12_3 * p21 * g / h2_3 * c_21 + p12_3 * p21 / (h1 * h2) * c_23
        + p12_2 * p21 * p22 / h2_2 * c_24 + p12_2 * p21 * p22 * g / h2_3 * c_25
        + p12_2 * p21 * p22 / (h1 * h2) * c_27 + p12 * p21 * p22_2 / h2_2 * c_28
        + p12 * p21 * p22_2 * g / h2_3 * c_29 + p21 * p22_3 / h2_2 * c_31 + p21 * p22_3 * g / h2_3 * c_32;
    gradient[7] = p12_3 * m2 / h2_2 * c_20 + p12_3 * m2 * g / h2_3 * c_21 + p12_3 * k2 / h2_2 * c_22
        + p12_3 * m2 / (h1 * h2) * c_23 + p12_2 * m2 * p22 / h2_2 * c_24 + p12_2 * m2 * p22 * g / h2_3 * c_25
        + p12_2 * p22 * k2 / h2_2 * c_26 + p12_2 * m2 * p22 / (h1 * h2) * c_27 + p12 * m2 * p22_2 / h2_2 * c_28
        + p12 * m2 * p22_2 * g / h2_3 * c_29 + p12 * p22_2 * k2 / h2_2 * c_30 + m2 * p22_3 / h2_2 * c_31
        + m2 * p22_3 * g / h2_3 * c_32 + p22_3 * k2 / h2_2 * c_33;
    gradient[8] = p11 * p12_2 * m2 / h2_2 * c_9 + p11 * p12_2 * m2 * g / h2_3 * c_10
        + p11 * p12_2 * k2 / h2_2 * c_11 + p11 * p12_2 * m2 / (h1 * h2) * c_12
        + 2.0 * p11 * p12 * m2 * p22 / h2_2 * c_13 + 2.0 * p11 * p12 * m2 * p22 * g / h2_3 * c_14
        + 2.0 * p11 * p12 * p22 * k2 / h2_2 * c_15 + 2.0 * p11 * p12 * m2 * p22 / (h1 * h2) * c_16
        + 3.0 * p11 * m2 * p22_2 / h2_2 * c_17 + 3.0 * p11 * m2 * p22_2 * g / h2_3 * c_18
        + 3.0 * p11 * p22_2 * k2 / h2_2 * c_19 + p12_2 * m2 * p21 / h2_2 * c_24 + p12_2 * m2 * p21 * g / h2_3 * c_25
        + p12_2 * p21 * k2 / h2_2 * c_26 + p12_2 * m2 * p21 / (h1 * h2) * c_27
        + 2.0 * p12 * m2 * p21 * p22 / h2_2 * c_28 + 2.0 * p12 * m2 * p21 * p22 * g / h2_3 * c_29
        + 2.0 * p12 * p21 * p22 * k2 / h2_2 * c_30 + 3.0 * m2 * p21 * p22_2 / h2_2 * c_31
        + 3.0 * m2 * p21 * p22_2 * g / h2_3 * c_32 + 3.0 * p21 * p22_2 * k2 / h2_2 * c_33;
    gradient[9] = -2.0 * p11 * p12_3 * m2 / h2_3 * c_2 - 3.0 * p11 * p12_3 * m2 * g / h2_4 * c_3
        - 2.0 * p11 * p12_3 * k2 / h2_3 * c_4 - p11 * p12_3 * m2 / (h1 * h2_2) * c_5
        - 2.0 * p11 * p12_2 * m2 * p22 / h2_3 * c_9 - 3.0 * p11 * p12_2 * m2 * p22 * g / h2_4 * c_10
        - 2.0 * p11 * p12_2 * p22 * k2 / h2_3 * c_11 - p11 * p12_2 * m2 * p22 / (h1 * h2_2) * c_12
        - 2.0 * p11 * p12 * m2 * p22_2 / h2_3 * c_13 - 3.0 * p11 * p12 * m2 * p22_2 * g / h2_4 * c_14
        - 2.0 * p11 * p12 * p22_2 * k2 / h2_3 * c_15 - p11 * p12 * m2 * p22_2 / (h1 * h2_2) * c_16
        - 2.0 * p11 * m2 * p22_3 / h2_3 * c_17 - 3.0 * p11 * m2 * p22_3 * g / h2_4 * c_18
        - 2.0 * p11 * p22_3 * k2 / h2_3 * c_19 - 2.0 * p12_3 * m2 * p21 / h2_3 * c_20
        - 3.0 * p12_3 * m2 * p21 * g / h2_4 * c_21 - 2.0 * p12_3 * p21 * k2 / h2_3 * c_22
        - p12_3 * m2 * p21 / (h1 * h2_2) * c_23 - 2.0 * p12_2 * m2 * p21 * p22 / h2_3 * c_24
        - 3.0 * p12_2 * m2 * p21 * p22 * g / h2_4 * c_25 - 2.0 * p12_2 * p21 * p22 * k2 / h2_3 * c_26
        - p12_2 * m2 * p21 * p22 / (h1 * h2_2) * c_27 - 2.0 * p12 * m2 * p21 * p22_2 / h2_3 * c_28
        - 3.0 * p12 * m2 * p21 * p22_2 * g / h2_4 * c_29 - 2.0 * p12 * p21 * p22_2 * k2 / h2_3 * c_30
        - 2.0 * m2 * p21 * p22_3 / h2_3 * c_31 - 3.0 * m2 * p21 * p22_3 * g / h2_4 * c_32
        - 2.0 * p21 * p22_3 * k2 / h2_3 * c_33;
    gradient[10] = p11 * p12_3 / h1_2 * c_7;  // by k1
    gradient[11] = p11 * p12_3 / h2_2 * c_4 + p11 * p12_2 * p22 / h2_2 * c_11 + p11 * p12 * p22_2 / h2_2 * c_15
        + p11 * p22_3 / h2_2 * c_19 + p12_3 * p21 / h2_2 * c_22 + p12_2 * p21 * p22 / h2_2 * c_26
        + p12 * p21 * p22_2 / h2_2 * c_30 + p21 * p22_3 / h2_2 * c_33;
    gradient[12] = m1 * p11 * p12_3 / h1_3 * c_1 + p11 * p12_3 * m2 / h2_3 * c_3 + p11 * p12_3 * m2 / h1_3 * c_8
        + p11 * p12_2 * m2 * p22 / h2_3 * c_10 + p11 * p12 * m2 * p22_2 / h2_3 * c_14
        + p11 * m2 * p22_3 / h2_3 * c_18 + p12_3 * m2 * p21 / h2_3 * c_21 + p12_2 * m2 * p21 * p22 / h2_3 * c_25
        + p12 * m2 * p21 * p22_2 / h2_3 * c_29 + m2 * p21 * p22_3 / h2_3 * c_32;
  }
  void lump_harmonic_re_v1_A_v13([[maybe_unused]] double* gradient) const {
    gradient[0] = (9.0 * m1 * p11_4 * h2_3 * g + 9.0 * p11_4 * h1_3 * m2 * g - 9.0 * p11_4 * h1_3 * h2 * k2
        - 9.0 * p11_4 * h1 * h2_3 * k1 + 9.0 * p11_4 * m2 * h2_3 * g - 36.0 * p11_3 * h1_3 * m2 * p21 * g
        + 36.0 * p11_3 * h1_3 * p21 * h2 * k2 + 54.0 * p11_2 * h1_3 * m2 * p21_2 * g
        - 54.0 * p11_2 * h1_3 * p21_2 * h2 * k2 - 36.0 * p11 * h1_3 * m2 * p21_3 * g
        + 36.0 * p11 * h1_3 * p21_3 * h2 * k2 + 9.0 * h1_3 * m2 * p21_4 * g
        - 9.0 * h1_3 * p21_4 * h2 * k2) / (35.0 * omega1_3 * h1_3 * h2_3);
    gradient[2] = (-126.0 * omega1_2 * p11_4 * h1 - 45.0 * p11_4 * g) / (350.0 * omega1_2 * h1_3);  // by m1
    gradient[3] = (-252.0 * omega1_2 * m1 * p11_3 * h1 * h2_3 - 252.0 * omega1_2 * p11_3 * h1_3 * m2 * h2
        - 504.0 * omega1_2 * p11_3 * h1_2 * m2 * h2_2 - 252.0 * omega1_2 * p11_3 * h1 * m2 * h2_3
        + 756.0 * omega1_2 * p11_2 * h1_3 * m2 * p21 * h2 + 756.0 * omega1_2 * p11_2 * h1_2 * m2 * p21 * h2_2
        - 756.0 * omega1_2 * p11 * h1_3 * m2 * p21_2 * h2 - 252.0 * omega1_2 * p11 * h1_2 * m2 * p21_2 * h2_2
        + 252.0 * omega1_2 * h1_3 * m2 * p21_3 * h2 - 90.0 * m1 * p11_3 * h2_3 * g - 90.0 * p11_3 * h1_3 * m2 * g
        + 90.0 * p11_3 * h1_3 * h2 * k2 + 90.0 * p11_3 * h1 * h2_3 * k1 - 90.0 * p11_3 * m2 * h2_3 * g
        + 270.0 * p11_2 * h1_3 * m2 * p21 * g - 270.0 * p11_2 * h1_3 * p21 * h2 * k2
        - 270.0 * p11 * h1_3 * m2 * p21_2 * g + 270.0 * p11 * h1_3 * p21_2 * h2 * k2 + 90.0 * h1_3 * m2 * p21_3 * g
        - 90.0 * h1_3 * p21_3 * h2 * k2) / (175.0 * omega1_2 * h1_3 * h2_3);
    gradient[5] = (252.0 * omega1_2 * m1 * p11_4 * h1 * h2 + 252.0 * omega1_2 * p11_4 * h1_2 * m2
        + 252.0 * omega1_2 * p11_4 * h1 * m2 * h2 - 504.0 * omega1_2 * p11_3 * h1_2 * m2 * p21
        + 252.0 * omega1_2 * p11_2 * h1_2 * m2 * p21_2 + 135.0 * m1 * p11_4 * h2 * g - 90.0 * p11_4 * h1 * h2 * k1
        + 135.0 * p11_4 * m2 * h2 * g) / (350.0 * omega1_2 * h1_4 * h2);
    gradient[6] = (-126.0 * omega1_2 * p11_4 * h1_3 * h2 - 252.0 * omega1_2 * p11_4 * h1_2 * h2_2
        - 126.0 * omega1_2 * p11_4 * h1 * h2_3 + 504.0 * omega1_2 * p11_3 * h1_3 * p21 * h2
        + 504.0 * omega1_2 * p11_3 * h1_2 * p21 * h2_2 - 756.0 * omega1_2 * p11_2 * h1_3 * p21_2 * h2
        - 252.0 * omega1_2 * p11_2 * h1_2 * p21_2 * h2_2 + 504.0 * omega1_2 * p11 * h1_3 * p21_3 * h2
        - 126.0 * omega1_2 * h1_3 * p21_4 * h2 - 45.0 * p11_4 * h1_3 * g - 45.0 * p11_4 * h2_3 * g
        + 180.0 * p11_3 * h1_3 * p21 * g - 270.0 * p11_2 * h1_3 * p21_2 * g + 180.0 * p11 * h1_3 * p21_3 * g
        - 45.0 * h1_3 * p21_4 * g) / (350.0 * omega1_2 * h1_3 * h2_3);
    gradient[7] = (252.0 * omega1_2 * p11_3 * h1 * m2 * h2 + 252.0 * omega1_2 * p11_3 * m2 * h2_2
        - 756.0 * omega1_2 * p11_2 * h1 * m2 * p21 * h2 - 252.0 * omega1_2 * p11_2 * m2 * p21 * h2_2
        + 756.0 * omega1_2 * p11 * h1 * m2 * p21_2 * h2 - 252.0 * omega1_2 * h1 * m2 * p21_3 * h2
        + 90.0 * p11_3 * h1 * m2 * g - 90.0 * p11_3 * h1 * h2 * k2 - 270.0 * p11_2 * h1 * m2 * p21 * g
        + 270.0 * p11_2 * h1 * p21 * h2 * k2 + 270.0 * p11 * h1 * m2 * p21_2 * g
        - 270.0 * p11 * h1 * p21_2 * h2 * k2 - 90.0 * h1 * m2 * p21_3 * g
        + 90.0 * h1 * p21_3 * h2 * k2) / (175.0 * omega1_2 * h1 * h2_3);
    gradient[9] = (252.0 * omega1_2 * p11_4 * h1 * m2 * h2 + 252.0 * omega1_2 * p11_4 * m2 * h2_2
        - 1008.0 * omega1_2 * p11_3 * h1 * m2 * p21 * h2 - 504.0 * omega1_2 * p11_3 * m2 * p21 * h2_2
        + 1512.0 * omega1_2 * p11_2 * h1 * m2 * p21_2 * h2 + 252.0 * omega1_2 * p11_2 * m2 * p21_2 * h2_2
        - 1008.0 * omega1_2 * p11 * h1 * m2 * p21_3 * h2 + 252.0 * omega1_2 * h1 * m2 * p21_4 * h2
        + 135.0 * p11_4 * h1 * m2 * g - 90.0 * p11_4 * h1 * h2 * k2 - 540.0 * p11_3 * h1 * m2 * p21 * g
        + 360.0 * p11_3 * h1 * p21 * h2 * k2 + 810.0 * p11_2 * h1 * m2 * p21_2 * g
        - 540.0 * p11_2 * h1 * p21_2 * h2 * k2 - 540.0 * p11 * h1 * m2 * p21_3 * g
        + 360.0 * p11 * h1 * p21_3 * h2 * k2 + 135.0 * h1 * m2 * p21_4 * g
        - 90.0 * h1 * p21_4 * h2 * k2) / (350.0 * omega1_2 * h1 * h2_4);
    gradient[10] = 9.0 * p11_4 / (70.0 * omega1_2 * h1_2);  // by k1
    gradient[11] = (9.0 * p11_4 - 36.0 * p11_3 * p21 + 54.0 * p11_2 * p21_2 - 36.0 * p11 * p21_3
        + 9.0 * p21_4) / (70.0 * omega1_2 * h2_2);
    gradient[12] = (-9.0 * m1 * p11_4 * h2_3 - 9.0 * p11_4 * h1_3 * m2 - 9.0 * p11_4 * m2 * h2_3
        + 36.0 * p11_3 * h1_3 * m2 * p21 - 54.0 * p11_2 * h1_3 * m2 * p21_2 + 36.0 * p11 * h1_3 * m2 * p21_3
        - 9.0 * h1_3 * m2 * p21_4) / (70.0 * omega1_2 * h1_3 * h2_3);
  }
  void lump_harmonic_re_v1_A_v1_A_v22([[maybe_unused]] double* gradient) const {
    const double f_0 = -18.0 * omega1 * p11 * p12 * m2 * p21 * p22 / (25.0 * omega2 * h1 * h2);
    const double f_2 = (-9.0 * omega1_2 * m1 * p11_2 * p12_2 * h2_2 - 9.0 * omega1_2 * p11_2 * p12_2 * h1_2 * m2
        - 18.0 * omega1_2 * p11_2 * p12_2 * h1 * m2 * h2 - 9.0 * omega1_2 * p11_2 * p12_2 * m2 * h2_2
        + 18.0 * omega1_2 * p11_2 * p12 * h1_2 * m2 * p22 + 18.0 * omega1_2 * p11_2 * p12 * h1 * m2 * p22 * h2
        - 9.0 * omega1_2 * p11_2 * h1_2 * m2 * p22_2 + 18.0 * omega1_2 * p11 * p12_2 * h1_2 * m2 * p21
        + 18.0 * omega1_2 * p11 * p12_2 * h1 * m2 * p21 * h2 - 36.0 * omega1_2 * p11 * p12 * h1_2 * m2 * p21 * p22
        + 18.0 * omega1_2 * p11 * h1_2 * m2 * p21 * p22_2 - 9.0 * omega1_2 * p12_2 * h1_2 * m2 * p21_2
        + 18.0 * omega1_2 * p12 * h1_2 * m2 * p21_2 * p22
        - 9.0 * omega1_2 * h1_2 * m2 * p21_2 * p22_2) * per_2 / (25.0 * omega2 * h1_2 * h2_2);
    const double f_3 = (-18.0 * omega1 * m1 * p11_2 * p12_2 * h2_2 - 18.0 * omega1 * p11_2 * p12_2 * h1_2 * m2
        - 36.0 * omega1 * p11_2 * p12_2 * h1 * m2 * h2 - 18.0 * omega1 * p11_2 * p12_2 * m2 * h2_2
        + 36.0 * omega1 * p11_2 * p12 * h1_2 * m2 * p22 + 36.0 * omega1 * p11_2 * p12 * h1 * m2 * p22 * h2
        - 18.0 * omega1 * p11_2 * h1_2 * m2 * p22_2 + 36.0 * omega1 * p11 * p12_2 * h1_2 * m2 * p21
        + 36.0 * omega1 * p11 * p12_2 * h1 * m2 * p21 * h2 - 72.0 * omega1 * p11 * p12 * h1_2 * m2 * p21 * p22
        + 36.0 * omega1 * p11 * h1_2 * m2 * p21 * p22_2 - 18.0 * omega1 * p12_2 * h1_2 * m2 * p21_2
        + 36.0 * omega1 * p12 * h1_2 * m2 * p21_2 * p22
        - 18.0 * omega1 * h1_2 * m2 * p21_2 * p22_2) * per_2 / (25.0 * h1_2 * h2_2);
    const double f_4 = (-27.0 * omega2 * m1 * p11_2 * p12_2 * h2_2 - 27.0 * omega2 * p11_2 * p12_2 * h1_2 * m2
        - 54.0 * omega2 * p11_2 * p12_2 * h1 * m2 * h2 - 27.0 * omega2 * p11_2 * p12_2 * m2 * h2_2
        + 54.0 * omega2 * p11_2 * p12 * h1_2 * m2 * p22 + 54.0 * omega2 * p11_2 * p12 * h1 * m2 * p22 * h2
        - 27.0 * omega2 * p11_2 * h1_2 * m2 * p22_2 - 18.0 * omega2 * p11_2 * h1 * m2 * p22_2 * h2
        + 54.0 * omega2 * p11 * p12_2 * h1_2 * m2 * p21 + 54.0 * omega2 * p11 * p12_2 * h1 * m2 * p21 * h2
        - 108.0 * omega2 * p11 * p12 * h1_2 * m2 * p21 * p22 + 54.0 * omega2 * p11 * h1_2 * m2 * p21 * p22_2
        - 27.0 * omega2 * p12_2 * h1_2 * m2 * p21_2 - 18.0 * omega2 * p12_2 * h1 * m2 * p21_2 * h2
        + 54.0 * omega2 * p12 * h1_2 * m2 * p21_2 * p22
        - 27.0 * omega2 * h1_2 * m2 * p21_2 * p22_2) * per_2 / (25.0 * h1_2 * h2_2);
    const double f_5 = (-27.0 * m1 * p11_2 * p12_2 * h2_3 * g - 27.0 * p11_2 * p12_2 * h1_3 * m2 * g
        + 27.0 * p11_2 * p12_2 * h1_3 * h2 * k2 + 27.0 * p11_2 * p12_2 * h1 * h2_3 * k1
        - 27.0 * p11_2 * p12_2 * m2 * h2_3 * g + 54.0 * p11_2 * p12 * h1_3 * m2 * p22 * g
        - 54.0 * p11_2 * p12 * h1_3 * p22 * h2 * k2 - 27.0 * p11_2 * h1_3 * m2 * p22_2 * g
        + 27.0 * p11_2 * h1_3 * p22_2 * h2 * k2 + 54.0 * p11 * p12_2 * h1_3 * m2 * p21 * g
        - 54.0 * p11 * p12_2 * h1_3 * p21 * h2 * k2 - 108.0 * p11 * p12 * h1_3 * m2 * p21 * p22 * g
        + 108.0 * p11 * p12 * h1_3 * p21 * p22 * h2 * k2 + 54.0 * p11 * h1_3 * m2 * p21 * p22_2 * g
        - 54.0 * p11 * h1_3 * p21 * p22_2 * h2 * k2 - 27.0 * p12_2 * h1_3 * m2 * p21_2 * g
        + 27.0 * p12_2 * h1_3 * p21_2 * h2 * k2 + 54.0 * p12 * h1_3 * m2 * p21_2 * p22 * g
        - 54.0 * p12 * h1_3 * p21_2 * p22 * h2 * k2 - 27.0 * h1_3 * m2 * p21_2 * p22_2 * g
        + 27.0 * h1_3 * p21_2 * p22_2 * h2 * k2) * per_2 / (35.0 * omega2 * h1_3 * h2_3);
    const double q_2 = (f_2 + f_3 + f_4 + f_5) * per_2;
    gradient[0] = (f_0 + 2.0 * f_2 + f_3) / omega1 - q_2;  // by omega1
    gradient[1] = (-f_0 - f_2 + f_4 - f_5) / omega2 - q_2;  // by omega2
    const double c_0 = (-9.0 * omega1_2 - 18.0 * omega1 * omega2 - 27.0 * omega2_2) * per_2 / (25.0 * omega2);
    const double c_1 = -27.0 * per_2 / (35.0 * omega2);  // multiplies m1*p11^2*p12^2*h2^3*g/(h1^3*h2^3)
    const double c_2 = (-9.0 * omega1_2 - 18.0 * omega1 * omega2 - 27.0 * omega2_2) * per_2 / (25.0 * omega2);
    const double c_3 = -27.0 * per_2 / (35.0 * omega2);  // multiplies p11^2*p12^2*h1^3*m2*g/(h1^3*h2^3)
    const double c_4 = 27.0 * per_2 / (35.0 * omega2);  // multiplies p11^2*p12^2*h1^3*h2*k2/(h1^3*h2^3)
    const double c_5 = (-18.0 * omega1_2 - 36.0 * omega1 * omega2 - 54.0 * omega2_2) * per_2 / (25.0 * omega2);
    const double c_6 = (-9.0 * omega1_2 - 18.0 * omega1 * omega2 - 27.0 * omega2_2) * per_2 / (25.0 * omega2);
    const double c_7 = 27.0 * per_2 / (35.0 * omega2);  // multiplies p11^2*p12^2*h1*h2^3*k1/(h1^3*h2^3)
    const double c_8 = -27.0 * per_2 / (35.0 * omega2);  // multiplies p11^2*p12^2*m2*h2^3*g/(h1^3*h2^3)
    const double c_9 = (18.0 * omega1_2 + 36.0 * omega1 * omega2 + 54.0 * omega2_2) * per_2 / (25.0 * omega2);
    const double c_10 = 54.0 * per_2 / (35.0 * omega2);  // multiplies p11^2*p12*h1^3*m2*p22*g/(h1^3*h2^3)
    const double c_11 = -54.0 * per_2 / (35.0 * omega2);  // multiplies p11^2*p12*h1^3*p22*h2*k2/(h1^3*h2^3)
    const double c_12 = (18.0 * omega1_2 + 36.0 * omega1 * omega2 + 54.0 * omega2_2) * per_2 / (25.0 * omega2);
    const double c_13 = (-9.0 * omega1_2 - 18.0 * omega1 * omega2 - 27.0 * omega2_2) * per_2 / (25.0 * omega2);
    const double c_14 = -27.0 * per_2 / (35.0 * omega2);  // multiplies p11^2*h1^3*m2*p22^2*g/(h1^3*h2^3)
    const double c_15 = 27.0 * per_2 / (35.0 * omega2);  // multiplies p11^2*h1^3*p22^2*h2*k2/(h1^3*h2^3)
    const double c_16 = -18.0 * omega2 * per_2 / 25.0;  // multiplies p11^2*h1^2*m2*p22^2*h2^2/(h1^3*h2^3)
    const double c_17 = (18.0 * omega1_2 + 36.0 * omega1 * omega2 + 54.0 * omega2_2) * per_2 / (25.0 * omega2);
    const double c_18 = 54.0 * per_2 / (35.0 * omega2);  // multiplies p11*p12^2*h1^3*m2*p21*g/(h1^3*h2^3)
    const double c_19 = -54.0 * per_2 / (35.0 * omega2);  // multiplies p11*p12^2*h1^3*p21*h2*k2/(h1^3*h2^3)
    const double c_20 = (18.0 * omega1_2 + 36.0 * omega1 * omega2 + 54.0 * omega2_2) * per_2 / (25.0 * omega2);
    const double c_21 = (-36.0 * omega1_2 - 72.0 * omega1 * omega2 - 108.0 * omega2_2) * per_2 / (25.0 * omega2);
    const double c_22 = -108.0 * per_2 / (35.0 * omega2);  // multiplies p11*p12*h1^3*m2*p21*p22*g/(h1^3*h2^3)
    const double c_23 = 108.0 * per_2 / (35.0 * omega2);  // multiplies p11*p12*h1^3*p21*p22*h2*k2/(h1^3*h2^3)
    const double c_24 = (-18.0 * omega1 - 18.0 * omega2) / (25.0 * omega2);
    const double c_25 = (18.0 * omega1_2 + 36.0 * omega1 * omega2 + 54.0 * omega2_2) * per_2 / (25.0 * omega2);
    const double c_26 = 54.0 * per_2 / (35.0 * omega2);  // multiplies p11*h1^3*m2*p21*p22^2*g/(h1^3*h2^3)
    const double c_27 = -54.0 * per_2 / (35.0 * omega2);  // multiplies p11*h1^3*p21*p22^2*h2*k2/(h1^3*h2^3)
    const double c_28 = (-9.0 * omega1_2 - 18.0 * omega1 * omega2 - 27.0 * omega2_2) * per_2 / (25.0 * omega2);
    const double c_29 = -27.0 * per_2 / (35.0 * omega2);  // multiplies p12^2*h1^3*m2*p21^2*g/(h1^3*h2^3)
    const double c_30 = 27.0 * per_2 / (35.0 * omega2);  // multiplies p12^2*h1^3*p21^2*h2*k2/(h1^3*h2^3)
    const double c_31 = -18.0 * omega2 * per_2 / 25.0;  // multiplies p12^2*h1^2*m2*p21^2*h2^2/(h1^3*h2^3)
    const double c_32 = (18.0 * omega1_2 + 36.0 * omega1 * omega2 + 54.0 * omega2_2) * per_2 / (25.0 * omega2);
    const double c_33 = 54.0 * per_2 / (35.0 * omega2);  // multiplies p12*h1^3*m2*p21^2*p22*g/(h1^3*h2^3)
    const double c_34 = -54.0 * per_2 / (35.0 * omega2);  // multiplies p12*h1^3*p21^2*p22*h2*k2/(h1^3*h2^3)
    const double c_35 = (-9.0 * omega1_2 - 18.0 * omega1 * omega2 - 27.0 * omega2_2) * per_2 / (25.0 * omega2);
    const double c_36 = -27.0 * per_2 / (35.0 * omega2);  // multiplies h1^3*m2*p21^2*p22^2*g/(h1^3*h2^3)
    const double c_37 = 27.0 * per_2 / (35.0 * omega2);  // multiplies h1^3*p21^2*p22^2*h2*k2/(h1^3*h2^3)
    gradient[2] = p11_2 * p12_2 / h1_2 * c_0 + p11_2 * p12_2 * g / h1_3 * c_1;  // by m1
    gradient[3] = 2.0 * m1 * p11 * p12_2 / h1_2 * c_0 + 2.0 * m1 * p11 * p12_2 * g / h1_3 * c_1
        + 2.0 * p11 * p12_2 * m2 / h2_2 * c_2 + 2.0 * p11 * p12_2 * m2 * g / h2_3 * c_3
        + 2.0 * p11 * p12_2 * k2 / h2_2 * c_4 + 2.0 * p11 * p12_2 * m2 / (h1 * h2) * c_5
        + 2.0 * p11 * p12_2 * m2 / h1_2 * c_6 + 2.0 * p11 * p12_2 * k1 / h1_2 * c_7
        + 2.0 * p11 * p12_2 * m2 * g / h1_3 * c_8 + 2.0 * p11 * p12 * m2 * p22 / h2_2 * c_9
        + 2.0 * p11 * p12 * m2 * p22 * g / h2_3 * c_10 + 2.0 * p11 * p12 * p22 * k2 / h2_2 * c_11
        + 2.0 * p11 * p12 * m2 * p22 / (h1 * h2) * c_12 + 2.0 * p11 * m2 * p22_2 / h2_2 * c_13
        + 2.0 * p11 * m2 * p22_2 * g / h2_3 * c_14 + 2.0 * p11 * p22_2 * k2 / h2_2 * c_15
        + 2.0 * p11 * m2 * p22_2 / (h1 * h2) * c_16 + p12_2 * m2 * p21 / h2_2 * c_17
        + p12_2 * m2 * p21 * g / h2_3 * c_18 + p12_2 * p21 * k2 / h2_2 * c_19 + p12_2 * m2 * p21 / (h1 * h2) * c_20
        + p12 * m2 * p21 * p22 / h2_2 * c_21 + p12 * m2 * p21 * p22 * g / h2_3 * c_22
        + p12 * p21 * p22 * k2 / h2_2 * c_23 + p12 * m2 * p21 * p22 / (h1 * h2) * c_24
        + m2 * p21 * p22_2 / h2_2 * c_25 + m2 * p21 * p22_2 * g / h2_3 * c_26 + p21 * p22_2 * k2 / h2_2 * c_27;
    gradient[4] = 2.0 * m1 * p11_2 * p12 / h1_2 * c_0 + 2.0 * m1 * p11_2 * p12 * g / h1_3 * c_1
        + 2.0 * p11_2 * p12 * m2 / h2_2 * c_2 + 2.0 * p11_2 * p12 * m2 * g / h2_3 * c_3
        + 2.0 * p11_2 * p12 * k2 / h2_2 * c_4 + 2.0 * p11_2 * p12 * m2 / (h1 * h2) * c_5
        + 2.0 * p11_2 * p12 * m2 / h1_2 * c_6 + 2.0 * p11_2 * p12 * k1 / h1_2 * c_7
        + 2.0 * p11_2 * p12 * m2 * g / h1_3 * c_8 + p11_2 * m2 * p22 / h2_2 * c_9
        + p11_2 * m2 * p22 * g / h2_3 * c_10 + p11_2 * p22 * k2 / h2_2 * c_11 + p11_2 * m2 * p22 / (h1 * h2) * c_12
        + 2.0 * p11 * p12 * m2 * p21 / h2_2 * c_17 + 2.0 * p11 * p12 * m2 * p21 * g / h2_3 * c_18
        + 2.0 * p11 * p12 * p21 * k2 / h2_2 * c_19 + 2.0 * p11 * p12 * m2 * p21 / (h1 * h2) * c_20
        + p11 * m2 * p21 * p22 / h2_2 * c_21 + p11 * m2 * p21 * p22 * g / h2_3 * c_22
        + p11 * p21 * p22 * k2 / h2_2 * c_23 + p11 * m2 * p21 * p22 / (h1 * h2) * c_24
        + 2.0 * p12 * m2 * p21_2 / h2_2 * c_28 + 2.0 * p12 * m2 * p21_2 * g / h2_3 * c_29
        + 2.0 * p12 * p21_2 * k2 / h2_2 * c_30 + 2.0 * p12 * m2 * p21_2 / (h1 * h2) * c_31
        + m2 * p21_2 * p22 / h2_2 * c_32 + m2 * p21_2 * p22 * g / h2_3 * c_33 + p21_2 * p22 * k2 / h2_2 * c_34;
    gradient[5] = -2.0 * m1 * p11_2 * p12_2 / h1_3 * c_0 - 3.0 * m1 * p11_2 * p12_2 * g / h1_4 * c_1
        - p11_2 * p12_2 * m2 / (h1_2 * h2) * c_5 - 2.0 * p11_2 * p12_2 * m2 / h1_3 * c_6
        - 2.0 * p11_2 * p12_2 * k1 / h1_3 * c_7 - 3.0 * p11_2 * p12_2 * m2 * g / h1_4 * c_8
        - p11_2 * p12 * m2 * p22 / (h1_2 * h2) * c_12 - p11_2 * m2 * p22_2 / (h1_2 * h2) * c_16
        - p11 * p12_2 * m2 * p21 / (h1_2 * h2) * c_20 - p11 * p12 * m2 * p21 * p22 / (h1_2 * h2) * c_24
        - p12_2 * m2 * p21_2 / (h1_2 * h2) * c_31;
    gradient[6] = p11_2 * p12_2 / h2_2 * c_2 + p11_2 * p12_2 * g / h2_3 * c_3 + p11_2 * p12_2 / (h1 * h2) * c_5
        + p11_2 * p12_2 / h1_2 * c_6 + p11_2 * p12_2 * g / h1_3 * c_8 + p11_2 * p12 * p22 / h2_2 * c_9
        + p11_2 * p12 * p22 * g / h2_3 * c_10 + p11_2 * p12 * p22 / (h1 * h2) * c_12 + p11_2 * p22_2 / h2_2 * c_13
        + p11_2 * p22_2 * g / h2_3 * c_14 + p11_2 * p22_2 / (h1 * h2) * c_16 + p11 * p12_2 * p21 / h2_2 * c_17
        + p11 * p12_2 * p21 * g / h2_3 * c_18 + p11 * p12_2 * p21 / (h1 * h2) * c_20
        + p11 * p12 * p21 * p22 / h2_2 * c_21 + p11 * p12 * p21 * p22 * g / h2_3 * c_22
        + p11 * p12 * p21 * p22 / (h1 * h2) * c_24 + p11 * p21 * p22_2 / h2_2 * c_25
        + p11 * p21 * p22_2 * g / h2_3 * c_26 + p12_2 * p21_2 / h2_2 * c_28 + p12_2 * p21_2 * g / h2_3 * c_29
        + p12_2 * p21_2 / (h1 * h2) * c_31 + p12 * p21_2 * p22 / h2_2 * c_32 + p12 * p21_2 * p22 * g / h2_3 * c_33
        + p21_2 * p22_2 / h2_2 * c_35 + p21_2 * p22_2 * g / h2_3 * c_36;
    gradient[7] = p11 * p12_2 * m2 / h2_2 * c_17 + p11 * p12_2 * m2 * g / h2_3 * c_18
        + p11 * p12_2 * k2 / h2_2 * c_19 + p11 * p12_2 * m2 / (h1 * h2) * c_20 + p11 * p12 * m2 * p22 / h2_2 * c_21
        + p11 * p12 * m2 * p22 * g / h2_3 * c_22 + p11 * p12 * p22 * k2 / h2_2 * c_23
        + p11 * p12 * m2 * p22 / (h1 * h2) * c_24 + p11 * m2 * p22_2 / h2_2 * c_25
        + p11 * m2 * p22_2 * g / h2_3 * c_26 + p11 * p22_2 * k2 / h2_2 * c_27 + 2.0 * p12_2 * m2 * p21 / h2_2 * c_28
        + 2.0 * p12_2 * m2 * p21 * g / h2_3 * c_29 + 2.0 * p12_2 * p21 * k2 / h2_2 * c_30
        + 2.0 * p12_2 * m2 * p21 / (h1 * h2) * c_31 + 2.0 * p12 * m2 * p21 * p22 / h2_2 * c_32
        + 2.0 * p12 * m2 * p21 * p22 * g / h2_3 * c_33 + 2.0 * p12 * p21 * p22 * k2 / h2_2 * c_34
        + 2.0 * m2 * p21 * p22_2 / h2_2 * c_35 + 2.0 * m2 * p21 * p22_2 * g / h2_3 * c_36
        + 2.0 * p21 * p22_2 * k2 / h2_2 * c_37;
    gradient[8] = p11_2 * p12 * m2 / h2_2 * c_9 + p11_2 * p12 * m2 * g / h2_3 * c_10
        + p11_2 * p12 * k2 / h2_2 * c_11 + p11_2 * p12 * m2 / (h1 * h2) * c_12
        + 2.0 * p11_2 * m2 * p22 / h2_2 * c_13 + 2.0 * p11_2 * m2 * p22 * g / h2_3 * c_14
        + 2.0 * p11_2 * p22 * k2 / h2_2 * c_15 + 2.0 * p11_2 * m2 * p22 / (h1 * h2) * c_16
        + p11 * p12 * m2 * p21 / h2_2 * c_21 + p11 * p12 * m2 * p21 * g / h2_3 * c_22
        + p11 * p12 * p21 * k2 / h2_2 * c_23 + p11 * p12 * m2 * p21 / (h1 * h2) * c_24
        + 2.0 * p11 * m2 * p21 * p22 / h2_2 * c_25 + 2.0 * p11 * m2 * p21 * p22 * g / h2_3 * c_26
        + 2.0 * p11 * p21 * p22 * k2 / h2_2 * c_27 + p12 * m2 * p21_2 / h2_2 * c_32
        + p12 * m2 * p21_2 * g / h2_3 * c_33 + p12 * p21_2 * k2 / h2_2 * c_34 + 2.0 * m2 * p21_2 * p22 / h2_2 * c_35
        + 2.0 * m2 * p21_2 * p22 * g / h2_3 * c_36 + 2.0 * p21_2 * p22 * k2 / h2_2 * c_37;
    gradient[9] = -2.0 * p11_2 * p12_2 * m2 / h2_3 * c_2 - 3.0 * p11_2 * p12_2 * m2 * g / h2_4 * c_3
        - 2.0 * p11_2 * p12_2 * k2 / h2_3 * c_4 - p11_2 * p12_2 * m2 / (h1 * h2_2) * c_5
        - 2.0 * p11_2 * p12 * m2 * p22 / h2_3 * c_9 - 3.0 * p11_2 * p12 * m2 * p22 * g / h2_4 * c_10
        - 2.0 * p11_2 * p12 * p22 * k2 / h2_3 * c_11 - p11_2 * p12 * m2 * p22 / (h1 * h2_2) * c_12
        - 2.0 * p11_2 * m2 * p22_2 / h2_3 * c_13 - 3.0 * p11_2 * m2 * p22_2 * g / h2_4 * c_14
        - 2.0 * p11_2 * p22_2 * k2 / h2_3 * c_15 - p11_2 * m2 * p22_2 / (h1 * h2_2) * c_16
        - 2.0 * p11 * p12_2 * m2 * p21 / h2_3 * c_17 - 3.0 * p11 * p12_2 * m2 * p21 * g / h2_4 * c_18
        - 2.0 * p11 * p12_2 * p21 * k2 / h2_3 * c_19 - p11 * p12_2 * m2 * p21 / (h1 * h2_2) * c_20
        - 2.0 * p11 * p12 * m2 * p21 * p22 / h2_3 * c_21 - 3.0 * p11 * p12 * m2 * p21 * p22 * g / h2_4 * c_22
        - 2.0 * p11 * p12 * p21 * p22 * k2 / h2_3 * c_23 - p11 * p12 * m2 * p21 * p22 / (h1 * h2_2) * c_24
        - 2.0 * p11 * m2 * p21 * p22_2 / h2_3 * c_25 - 3.0 * p11 * m2 * p21 * p22_2 * g / h2_4 * c_26
        - 2.0 * p11 * p21 * p22_2 * k2 / h2_3 * c_27 - 2.0 * p12_2 * m2 * p21_2 / h2_3 * c_28
        - 3.0 * p12_2 * m2 * p21_2 * g / h2_4 * c_29 - 2.0 * p12_2 * p21_2 * k2 / h2_3 * c_30
        - p12_2 * m2 * p21_2 / (h1 * h2_2) * c_31 - 2.0 * p12 * m2 * p21_2 * p22 / h2_3 * c_32
        - 3.0 * p12 * m2 * p21_2 * p22 * g / h2_4 * c_33 - 2.0 * p12 * p21_2 * p22 * k2 / h2_3 * c_34
        - 2.0 * m2 * p21_2 * p22_2 / h2_3 * c_35 - 3.0 * m2 * p21_2 * p22_2 * g / h2_4 * c_36
        - 2.0 * p21_2 * p22_2 * k2 / h2_3 * c_37;
    gradient[10] = p11_2 * p12_2 / h1_2 * c_7;  // by k1
    gradient[11] = p11_2 * p12_2 / h2_2 * c_4 + p11_2 * p12 * p22 / h2_2 * c_11 + p11_2 * p22_2 / h2_2 * c_15
        + p11 * p12_2 * p21 / h2_2 * c_19 + p11 * p12 * p21 * p22 / h2_2 * c_23 + p11 * p21 * p22_2 / h2_2 * c_27
        + p12_2 * p21_2 / h2_2 * c_30 + p12 * p21_2 * p22 / h2_2 * c_34 + p21_2 * p22_2 / h2_2 * c_37;
    gradient[12] = m1 * p11_2 * p12_2 / h1_3 * c_1 + p11_2 * p12_2 * m2 / h2_3 * c_3
        + p11_2 * p12_2 * m2 / h1_3 * c_8 + p11_2 * p12 * m2 * p22 / h2_3 * c_10 + p11_2 * m2 * p22_2 / h2_3 * c_14
        + p11 * p12_2 * m2 * p21 / h2_3 * c_18 + p11 * p12 * m2 * p21 * p22 / h2_3 * c_22
        + p11 * m2 * p21 * p22_2 / h2_3 * c_26 + p12_2 * m2 * p21_2 / h2_3 * c_29
        + p12 * m2 * p21_2 * p22 / h2_3 * c_33 + m2 * p21_2 * p22_2 / h2_3 * c_36;
  }
  void lump_harmonic_re_v2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = (-m1 * p12 * tilt - m2 * p22 * tilt) * over_4 / 2.0;
    const double q_6 = f_0 * per_6;
    const double q_7 = f_0 * per_7;
    gradient[0] = -2.0 * q_6 - 2.0 * q_7;  // by omega1
    gradient[1] = -q_6 + q_7;  // by omega2
    const double c_0 = -over_4 / 2.0;  // multiplies m1*p12*tilt
    const double c_1 = -over_4 / 2.0;  // multiplies m2*p22*tilt
    gradient[2] = p12 * tilt * c_0;  // by m1
    gradient[4] = m1 * tilt * c_0;  // by p12
    gradient[6] = p22 * tilt * c_1;  // by m2
    gradient[8] = m2 * tilt * c_1;  // by p22
    gradient[15] = m1 * p12 * c_0 + m2 * p22 * c_1;  // by tilt
  }
  void lump_harmonic_re_v2_A_v2_conjA_v12([[maybe_unused]] double* gradient) const {
    const double f_1 = 18.0 * omega2 * p11 * p12 * m2 * p21 * p22 / (25.0 * omega1 * h1 * h2);
    const double f_2 = (-27.0 * omega1 * m1 * p11_2 * p12_2 * h2_2 - 27.0 * omega1 * p11_2 * p12_2 * h1_2 * m2
        - 54.0 * omega1 * p11_2 * p12_2 * h1 * m2 * h2 - 27.0 * omega1 * p11_2 * p12_2 * m2 * h2_2
        + 54.0 * omega1 * p11_2 * p12 * h1_2 * m2 * p22 + 54.0 * omega1 * p11_2 * p12 * h1 * m2 * p22 * h2
        - 27.0 * omega1 * p11_2 * h1_2 * m2 * p22_2 - 18.0 * omega1 * p11_2 * h1 * m2 * p22_2 * h2
        + 54.0 * omega1 * p11 * p12_2 * h1_2 * m2 * p21 + 54.0 * omega1 * p11 * p12_2 * h1 * m2 * p21 * h2
        - 108.0 * omega1 * p11 * p12 * h1_2 * m2 * p21 * p22 + 54.0 * omega1 * p11 * h1_2 * m2 * p21 * p22_2
        - 27.0 * omega1 * p12_2 * h1_2 * m2 * p21_2 - 18.0 * omega1 * p12_2 * h1 * m2 * p21_2 * h2
        + 54.0 * omega1 * p12 * h1_2 * m2 * p21_2 * p22
        - 27.0 * omega1 * h1_2 * m2 * p21_2 * p22_2) * per_0 / (25.0 * h1_2 * h2_2);
    const double f_3 = (18.0 * omega2 * m1 * p11_2 * p12_2 * h2_2 + 18.0 * omega2 * p11_2 * p12_2 * h1_2 * m2
        + 36.0 * omega2 * p11_2 * p12_2 * h1 * m2 * h2 + 18.0 * omega2 * p11_2 * p12_2 * m2 * h2_2
        - 36.0 * omega2 * p11_2 * p12 * h1_2 * m2 * p22 - 36.0 * omega2 * p11_2 * p12 * h1 * m2 * p22 * h2
        + 18.0 * omega2 * p11_2 * h1_2 * m2 * p22_2 - 36.0 * omega2 * p11 * p12_2 * h1_2 * m2 * p21
        - 36.0 * omega2 * p11 * p12_2 * h1 * m2 * p21 * h2 + 72.0 * omega2 * p11 * p12 * h1_2 * m2 * p21 * p22
        - 36.0 * omega2 * p11 * h1_2 * m2 * p21 * p22_2 + 18.0 * omega2 * p12_2 * h1_2 * m2 * p21_2
        - 36.0 * omega2 * p12 * h1_2 * m2 * p21_2 * p22
        + 18.0 * omega2 * h1_2 * m2 * p21_2 * p22_2) * per_0 / (25.0 * h1_2 * h2_2);
    const double f_4 = (-9.0 * omega2_2 * m1 * p11_2 * p12_2 * h2_2 - 9.0 * omega2_2 * p11_2 * p12_2 * h1_2 * m2
        - 18.0 * omega2_2 * p11_2 * p12_2 * h1 * m2 * h2 - 9.0 * omega2_2 * p11_2 * p12_2 * m2 * h2_2
        + 18.0 * omega2_2 * p11_2 * p12 * h1_2 * m2 * p22 + 18.0 * omega2_2 * p11_2 * p12 * h1 * m2 * p22 * h2
        - 9.0 * omega2_2 * p11_2 * h1_2 * m2 * p22_2 + 18.0 * omega2_2 * p11 * p12_2 * h1_2 * m2 * p21
        + 18.0 * omega2_2 * p11 * p12_2 * h1 * m2 * p21 * h2 - 36.0 * omega2_2 * p11 * p12 * h1_2 * m2 * p21 * p22
        + 18.0 * omega2_2 * p11 * h1_2 * m2 * p21 * p22_2 - 9.0 * omega2_2 * p12_2 * h1_2 * m2 * p21_2
        + 18.0 * omega2_2 * p12 * h1_2 * m2 * p21_2 * p22
        - 9.0 * omega2_2 * h1_2 * m2 * p21_2 * p22_2) * per_0 / (25.0 * omega1 * h1_2 * h2_2);
    const double f_5 = (-27.0 * m1 * p11_2 * p12_2 * h2_3 * g - 27.0 * p11_2 * p12_2 * h1_3 * m2 * g
        + 27.0 * p11_2 * p12_2 * h1_3 * h2 * k2 + 27.0 * p11_2 * p12_2 * h1 * h2_3 * k1
        - 27.0 * p11_2 * p12_2 * m2 * h2_3 * g + 54.0 * p11_2 * p12 * h1_3 * m2 * p22 * g
        - 54.0 * p11_2 * p12 * h1_3 * p22 * h2 * k2 - 27.0 * p11_2 * h1_3 * m2 * p22_2 * g
        + 27.0 * p11_2 * h1_3 * p22_2 * h2 * k2 + 54.0 * p11 * p12_2 * h1_3 * m2 * p21 * g
        - 54.0 * p11 * p12_2 * h1_3 * p21 * h2 * k2 - 108.0 * p11 * p12 * h1_3 * m2 * p21 * p22 * g
        + 108.0 * p11 * p12 * h1_3 * p21 * p22 * h2 * k2 + 54.0 * p11 * h1_3 * m2 * p21 * p22_2 * g
        - 54.0 * p11 * h1_3 * p21 * p22_2 * h2 * k2 - 27.0 * p12_2 * h1_3 * m2 * p21_2 * g
        + 27.0 * p12_2 * h1_3 * p21_2 * h2 * k2 + 54.0 * p12 * h1_3 * m2 * p21_2 * p22 * g
        - 54.0 * p12 * h1_3 * p21_2 * p22 * h2 * k2 - 27.0 * h1_3 * m2 * p21_2 * p22_2 * g
        + 27.0 * h1_3 * p21_2 * p22_2 * h2 * k2) * per_0 / (35.0 * omega1 * h1_3 * h2_3);
    const double q_0 = (f_2 + f_3 + f_4 + f_5) * per_0;
    gradient[0] = (-f_1 + f_2 - f_4 - f_5) / omega1 - q_0;  // by omega1
    gradient[1] = (f_1 + f_3 + 2.0 * f_4) / omega2 + q_0;  // by omega2
    const double c_0 = (-27.0 * omega1_2 + 18.0 * omega1 * omega2 - 9.0 * omega2_2) * per_0 / (25.0 * omega1);
    const double c_1 = -27.0 * per_0 / (35.0 * omega1);  // multiplies m1*p11^2*p12^2*h2^3*g/(h1^3*h2^3)
    const double c_2 = (-27.0 * omega1_2 + 18.0 * omega1 * omega2 - 9.0 * omega2_2) * per_0 / (25.0 * omega1);
    const double c_3 = -27.0 * per_0 / (35.0 * omega1);  // multiplies p11^2*p12^2*h1^3*m2*g/(h1^3*h2^3)
    const double c_4 = 27.0 * per_0 / (35.0 * omega1);  // multiplies p11^2*p12^2*h1^3*h2*k2/(h1^3*h2^3)
    const double c_5 = (-54.0 * omega1_2 + 36.0 * omega1 * omega2 - 18.0 * omega2_2) * per_0 / (25.0 * omega1);
    const double c_6 = (-27.0 * omega1_2 + 18.0 * omega1 * omega2 - 9.0 * omega2_2) * per_0 / (25.0 * omega1);
    const double c_7 = 27.0 * per_0 / (35.0 * omega1);  // multiplies p11^2*p12^2*h1*h2^3*k1/(h1^3*h2^3)
    const double c_8 = -27.0 * per_0 / (35.0 * omega1);  // multiplies p11^2*p12^2*m2*h2^3*g/(h1^3*h2^3)
    const double c_9 = (54.0 * omega1_2 - 36.0 * omega1 * omega2 + 18.0 * omega2_2) * per_0 / (25.0 * omega1);
    const double c_10 = 54.0 * per_0 / (35.0 * omega1);  // multiplies p11^2*p12*h1^3*m2*p22*g/(h1^3*h2^3)
    const double c_11 = -54.0 * per_0 / (35.0 * omega1);  // multiplies p11^2*p12*h1^3*p22*h2*k2/(h1^3*h2^3)
    const double c_12 = (54.0 * omega1_2 - 36.0 * omega1 * omega2 + 18.0 * omega2_2) * per_0 / (25.0 * omega1);
    const double c_13 = (-27.0 * omega1_2 + 18.0 * omega1 * omega2 - 9.0 * omega2_2) * per_0 / (25.0 * omega1);
    const double c_14 = -27.0 * per_0 / (35.0 * omega1);  // multiplies p11^2*h1^3*m2*p22^2*g/(h1^3*h2^3)
    const double c_15 = 27.0 * per_0 / (35.0 * omega1);  // multiplies p11^2*h1^3*p22^2*h2*k2/(h1^3*h2^3)
    const double c_16 = -18.0 * omega1 * per_0 / 25.0;  // multiplies p11^2*h1^2*m2*p22^2*h2^2/(h1^3*h2^3)
    const double c_17 = (54.0 * omega1_2 - 36.0 * omega1 * omega2 + 18.0 * omega2_2) * per_0 / (25.0 * omega1);
    const double c_18 = 54.0 * per_0 / (35.0 * omega1);  // multiplies p11*p12^2*h1^3*m2*p21*g/(h1^3*h2^3)
    const double c_19 = -54.0 * per_0 / (35.0 * omega1);  // multiplies p11*p12^2*h1^3*p21*h2*k2/(h1^3*h2^3)
    const double c_20 = (54.0 * omega1_2 - 36.0 * omega1 * omega2 + 18.0 * omega2_2) * per_0 / (25.0 * omega1);
    const double c_21 = (-108.0 * omega1_2 + 72.0 * omega1 * omega2 - 36.0 * omega2_2) * per_0 / (25.0 * omega1);
    const double c_22 = -108.0 * per_0 / (35.0 * omega1);  // multiplies p11*p12*h1^3*m2*p21*p22*g/(h1^3*h2^3)
    const double c_23 = 108.0 * per_0 / (35.0 * omega1);  // multiplies p11*p12*h1^3*p21*p22*h2*k2/(h1^3*h2^3)
    const double c_24 = (-18.0 * omega1 + 18.0 * omega2) / (25.0 * omega1);
    const double c_25 = (54.0 * omega1_2 - 36.0 * omega1 * omega2 + 18.0 * omega2_2) * per_0 / (25.0 * omega1);
    const double c_26 = 54.0 * per_0 / (35.0 * omega1);  // multiplies p11*h1^3*m2*p21*p22^2*g/(h1^3*h2^3)
    const double c_27 = -54.0 * per_0 / (35.0 * omega1);  // multiplies p11*h1^3*p21*p22^2*h2*k2/(h1^3*h2^3)
    const double c_28 = (-27.0 * omega1_2 + 18.0 * omega1 * omega2 - 9.0 * omega2_2) * per_0 / (25.0 * omega1);
    const double c_29 = -27.0 * per_0 / (35.0 * omega1);  // multiplies p12^2*h1^3*m2*p21^2*g/(h1^3*h2^3)
    const double c_30 = 27.0 * per_0 / (35.0 * omega1);  // multiplies p12^2*h1^3*p21^2*h2*k2/(h1^3*h2^3)
    const double c_31 = -18.0 * omega1 * per_0 / 25.0;  // multiplies p12^2*h1^2*m2*p21^2*h2^2/(h1^3*h2^3)
    const double c_32 = (54.0 * omega1_2 - 36.0 * omega1 * omega2 + 18.0 * omega2_2) * per_0 / (25.0 * omega1);
    const double c_33 = 54.0 * per_0 / (35.0 * omega1);  // multiplies p12*h1^3*m2*p21^2*p22*g/(h1^3*h2^3)
    const double c_34 = -54.0 * per_0 / (35.0 * omega1);  // multiplies p12*h1^3*p21^2*p22*h2*k2/(h1^3*h2^3)
    const double c_35 = (-27.0 * omega1_2 + 18.0 * omega1 * omega2 - 9.0 * omega2_2) * per_0 / (25.0 * omega1);
    const double c_36 = -27.0 * per_0 / (35.0 * omega1);  // multiplies h1^3*m2*p21^2*p22^2*g/(h1^3*h2^3)
    const double c_37 = 27.0 * per_0 / (35.0 * omega1);  // multiplies h1^3*p21^2*p22^2*h2*k2/(h1^3*h2^3)
    gradient[2] = p11_2 * p12_2 / h1_2 * c_0 + p11_2 * p12_2 * g / h1_3 * c_1;  // by m1
    gradient[3] = 2.0 * m1 * p11 * p12_2 / h1_2 * c_0 + 2.0 * m1 * p11 * p12_2 * g / h1_3 * c_1
        + 2.0 * p11 * p12_2 * m2 / h2_2 * c_2 + 2.0 * p11 * p12_2 * m2 * g / h2_3 * c_3
        + 2.0 * p11 * p12_2 * k2 / h2_2 * c_4 + 2.0 * p11 * p12_2 * m2 / (h1 * h2) * c_5
        + 2.0 * p11 * p12_2 * m2 / h1_2 * c_6 + 2.0 * p11 * p12_2 * k1 / h1_2 * c_7
        + 2.0 * p11 * p12_2 * m2 * g / h1_3 * c_8 + 2.0 * p11 * p12 * m2 * p22 / h2_2 * c_9
        + 2.0 * p11 * p12 * m2 * p22 * g / h2_3 * c_10 + 2.0 * p11 * p12 * p22 * k2 / h2_2 * c_11
        + 2.0 * p11 * p12 * m2 * p22 / (h1 * h2) * c_12 + 2.0 * p11 * m2 * p22_2 / h2_2 * c_13
        + 2.0 * p11 * m2 * p22_2 * g / h2_3 * c_14 + 2.0 * p11 * p22_2 * k2 / h2_2 * c_15
        + 2.0 * p11 * m2 * p22_2 / (h1 * h2) * c_16 + p12_2 * m2 * p21 / h2_2 * c_17
        + p12_2 * m2 * p21 * g / h2_3 * c_18 + p12_2 * p21 * k2 / h2_2 * c_19 + p12_2 * m2 * p21 / (h1 * h2) * c_20
        + p12 * m2 * p21 * p22 / h2_2 * c_21 + p12 * m2 * p21 * p22 * g / h2_3 * c_22
        + p12 * p21 * p22 * k2 / h2_2 * c_23 + p12 * m2 * p21 * p22 / (h1 * h2) * c_24
        + m2 * p21 * p22_2 / h2_2 * c_25 + m2 * p21 * p22_2 * g / h2_3 * c_26 + p21 * p22_2 * k2 / h2_2 * c_27;
    gradient[4] = 2.0 * m1 * p11_2 * p12 / h1_2 * c_0 + 2.0 * m1 * p11_2 * p12 * g / h1_3 * c_1
        + 2.0 * p11_2 * p12 * m2 / h2_2 * c_2 + 2.0 * p11_2 * p12 * m2 * g / h2_3 * c_3
        + 2.0 * p11_2 * p12 * k2 / h2_2 * c_4 + 2.0 * p11_2 * p12 * m2 / (h1 * h2) * c_5
        + 2.0 * p11_2 * p12 * m2 / h1_2 * c_6 + 2.0 * p11_2 * p12 * k1 / h1_2 * c_7
        + 2.0 * p11_2 * p12 * m2 * g / h1_3 * c_8 + p11_2 * m2 * p22 / h2_2 * c_9
        + p11_2 * m2 * p22 * g / h2_3 * c_10 + p11_2 * p22 * k2 / h2_2 * c_11 + p11_2 * m2 * p22 / (h1 * h2) * c_12
        + 2.0 * p11 * p12 * m2 * p21 / h2_2 * c_17 + 2.0 * p11 * p12 * m2 * p21 * g / h2_3 * c_18
        + 2.0 * p11 * p12 * p21 * k2 / h2_2 * c_19 + 2.0 * p11 * p12 * m2 * p21 / (h1 * h2) * c_20
        + p11 * m2 * p21 * p22 / h2_2 * c_21 + p11 * m2 * p21 * p22 * g / h2_3 * c_22
        + p11 * p21 * p22 * k2 / h2_2 * c_23 + p11 * m2 * p21 * p22 / (h1 * h2) * c_24
        + 2.0 * p12 * m2 * p21_2 / h2_2 * c_28 + 2.0 * p12 * m2 * p21_2 * g / h2_3 * c_29
        + 2.0 * p12 * p21_2 * k2 / h2_2 * c_30 + 2.0 * p12 * m2 * p21_2 / (h1 * h2) * c_31
        + m2 * p21_2 * p22 / h2_2 * c_32 + m2 * p21_2 * p22 * g / h2_3 * c_33 + p21_2 * p22 * k2 / h2_2 * c_34;
    gradient[5] = -2.0 * m1 * p11_2 * p12_2 / h1_3 * c_0 - 3.0 * m1 * p11_2 * p12_2 * g / h1_4 * c_1
        - p11_2 * p12_2 * m2 / (h1_2 * h2) * c_5 - 2.0 * p11_2 * p12_2 * m2 / h1_3 * c_6
        - 2.0 * p11_2 * p12_2 * k1 / h1_3 * c_7 - 3.0 * p11_2 * p12_2 * m2 * g / h1_4 * c_8
        - p11_2 * p12 * m2 * p22 / (h1_2 * h2) * c_12 - p11_2 * m2 * p22_2 / (h1_2 * h2) * c_16
        - p11 * p12_2 * m2 * p21 / (h1_2 * h2) * c_20 - p11 * p12 * m2 * p21 * p22 / (h1_2 * h2) * c_24
        - p12_2 * m2 * p21_2 / (h1_2 * h2) * c_31;
    gradient[6] = p11_2 * p12_2 / h2_2 * c_2 + p11_2 * p12_2 * g / h2_3 * c_3 + p11_2 * p12_2 / (h1 * h2) * c_5
        + p11_2 * p12_2 / h1_2 * c_6 + p11_2 * p12_2 * g / h1_3 * c_8 + p11_2 * p12 * p22 / h2_2 * c_9
        + p11_2 * p12 * p22 * g / h2_3 * c_10 + p11_2 * p12 * p22 / (h1 * h2) * c_12 + p11_2 * p22_2 / h2_2 * c_13
        + p11_2 * p22_2 * g / h2_3 * c_14 + p11_2 * p22_2 / (h1 * h2) * c_16 + p11 * p12_2 * p21 / h2_2 * c_17
        + p11 * p12_2 * p21 * g / h2_3 * c_18 + p11 * p12_2 * p21 / (h1 * h2) * c_20
        + p11 * p12 * p21 * p22 / h2_2 * c_21 + p11 * p12 * p21 * p22 * g / h2_3 * c_22
        + p11 * p12 * p21 * p22 / (h1 * h2) * c_24 + p11 * p21 * p22_2 / h2_2 * c_25
        + p11 * p21 * p22_2 * g / h2_3 * c_26 + p12_2 * p21_2 / h2_2 * c_28 + p12_2 * p21_2 * g / h2_3 * c_29
        + p12_2 * p21_2 / (h1 * h2) * c_31 + p12 * p21_2 * p22 / h2_2 * c_32 + p12 * p21_2 * p22 * g / h2_3 * c_33
        + p21_2 * p22_2 / h2_2 * c_35 + p21_2 * p22_2 * g / h2_3 * c_36;
    gradient[7] = p11 * p12_2 * m2 / h2_2 * c_17 + p11 * p12_2 * m2 * g / h2_3 * c_18
        + p11 * p12_2 * k2 / h2_2 * c_19 + p11 * p12_2 * m2 / (h1 * h2) * c_20 + p11 * p12 * m2 * p22 / h2_2 * c_21
        + p11 * p12 * m2 * p22 * g / h2_3 * c_22 + p11 * p12 * p22 * k2 / h2_2 * c_23
        + p11 * p12 * m2 * p22 / (h1 * h2) * c_24 + p11 * m2 * p22_2 / h2_2 * c_25
        + p11 * m2 * p22_2 * g / h2_3 * c_26 + p11 * p22_2 * k2 / h2_2 * c_27 + 2.0 * p12_2 * m2 * p21 / h2_2 * c_28
        + 2.0 * p12_2 * m2 * p21 * g / h2_3 * c_29 + 2.0 * p12_2 * p21 * k2 / h2_2 * c_30
        + 2.0 * p12_2 * m2 * p21 / (h1 * h2) * c_31 + 2.0 * p12 * m2 * p21 * p22 / h2_2 * c_32
        + 2.0 * p12 * m2 * p21 * p22 * g / h2_3 * c_33 + 2.0 * p12 * p21 * p22 * k2 / h2_2 * c_34
        + 2.0 * m2 * p21 * p22_2 / h2_2 * c_35 + 2.0 * m2 * p21 * p22_2 * g / h2_3 * c_36
        + 2.0 * p21 * p22_2 * k2 / h2_2 * c_37;
    gradient[8] = p11_2 * p12 * m2 / h2_2 * c_9 + p11_2 * p12 * m2 * g / h2_3 * c_10
        + p11_2 * p12 * k2 / h2_2 * c_11 + p11_2 * p12 * m2 / (h1 * h2) * c_12
        + 2.0 * p11_2 * m2 * p22 / h2_2 * c_13 + 2.0 * p11_2 * m2 * p22 * g / h2_3 * c_14
        + 2.0 * p11_2 * p22 * k2 / h2_2 * c_15 + 2.0 * p11_2 * m2 * p22 / (h1 * h2) * c_16
        + p11 * p12 * m2 * p21 / h2_2 * c_21 + p11 * p12 * m2 * p21 * g / h2_3 * c_22
        + p11 * p12 * p21 * k2 / h2_2 * c_23 + p11 * p12 * m2 * p21 / (h1 * h2) * c_24
        + 2.0 * p11 * m2 * p21 * p22 / h2_2 * c_25 + 2.0 * p11 * m2 * p21 * p22 * g / h2_3 * c_26
        + 2.0 * p11 * p21 * p22 * k2 / h2_2 * c_27 + p12 * m2 * p21_2 / h2_2 * c_32
        + p12 * m2 * p21_2 * g / h2_3 * c_33 + p12 * p21_2 * k2 / h2_2 * c_34 + 2.0 * m2 * p21_2 * p22 / h2_2 * c_35
        + 2.0 * m2 * p21_2 * p22 * g / h2_3 * c_36 + 2.0 * p21_2 * p22 * k2 / h2_2 * c_37;
    gradient[9] = -2.0 * p11_2 * p12_2 * m2 / h2_3 * c_2 - 3.0 * p11_2 * p12_2 * m2 * g / h2_4 * c_3
        - 2.0 * p11_2 * p12_2 * k2 / h2_3 * c_4 - p11_2 * p12_2 * m2 / (h1 * h2_2) * c_5
        - 2.0 * p11_2 * p12 * m2 * p22 / h2_3 * c_9 - 3.0 * p11_2 * p12 * m2 * p22 * g / h2_4 * c_10
        - 2.0 * p11_2 * p12 * p22 * k2 / h2_3 * c_11 - p11_2 * p12 * m2 * p22 / (h1 * h2_2) * c_12
        - 2.0 * p11_2 * m2 * p22_2 / h2_3 * c_13 - 3.0 * p11_2 * m2 * p22_2 * g / h2_4 * c_14
        - 2.0 * p11_2 * p22_2 * k2 / h2_3 * c_15 - p11_2 * m2 * p22_2 / (h1 * h2_2) * c_16
        - 2.0 * p11 * p12_2 * m2 * p21 / h2_3 * c_17 - 3.0 * p11 * p12_2 * m2 * p21 * g / h2_4 * c_18
        - 2.0 * p11 * p12_2 * p21 * k2 / h2_3 * c_19 - p11 * p12_2 * m2 * p21 / (h1 * h2_2) * c_20
        - 2.0 * p11 * p12 * m2 * p21 * p22 / h2_3 * c_21 - 3.0 * p11 * p12 * m2 * p21 * p22 * g / h2_4 * c_22
        - 2.0 * p11 * p12 * p21 * p22 * k2 / h2_3 * c_23 - p11 * p12 * m2 * p21 * p22 / (h1 * h2_2) * c_24
        - 2.0 * p11 * m2 * p21 * p22_2 / h2_3 * c_25 - 3.0 * p11 * m2 * p21 * p22_2 * g / h2_4 * c_26
        - 2.0 * p11 * p21 * p22_2 * k2 / h2_3 * c_27 - 2.0 * p12_2 * m2 * p21_2 / h2_3 * c_28
        - 3.0 * p12_2 * m2 * p21_2 * g / h2_4 * c_29 - 2.0 * p12_2 * p21_2 * k2 / h2_3 * c_30
        - p12_2 * m2 * p21_2 / (h1 * h2_2) * c_31 - 2.0 * p12 * m2 * p21_2 * p22 / h2_3 * c_32
        - 3.0 * p12 * m2 * p21_2 * p22 * g / h2_4 * c_33 - 2.0 * p12 * p21_2 * p22 * k2 / h2_3 * c_34
        - 2.0 * m2 * p21_2 * p22_2 / h2_3 * c_35 - 3.0 * m2 * p21_2 * p22_2 * g / h2_4 * c_36
        - 2.0 * p21_2 * p22_2 * k2 / h2_3 * c_37;
    gradient[10] = p11_2 * p12_2 / h1_2 * c_7;  // by k1
    gradient[11] = p11_2 * p12_2 / h2_2 * c_4 + p11_2 * p12 * p22 / h2_2 * c_11 + p11_2 * p22_2 / h2_2 * c_15
        + p11 * p12_2 * p21 / h2_2 * c_19 + p11 * p12 * p21 * p22 / h2_2 * c_23 + p11 * p21 * p22_2 / h2_2 * c_27
        + p12_2 * p21_2 / h2_2 * c_30 + p12 * p21_2 * p22 / h2_2 * c_34 + p21_2 * p22_2 / h2_2 * c_37;
    gradient[12] = m1 * p11_2 * p12_2 / h1_3 * c_1 + p11_2 * p12_2 * m2 / h2_3 * c_3
        + p11_2 * p12_2 * m2 / h1_3 * c_8 + p11_2 * p12 * m2 * p22 / h2_3 * c_10 + p11_2 * m2 * p22_2 / h2_3 * c_14
        + p11 * p12_2 * m2 * p21 / h2_3 * c_18 + p11 * p12 * m2 * p21 * p22 / h2_3 * c_22
        + p11 * m2 * p21 * p22_2 / h2_3 * c_26 + p12_2 * m2 * p21_2 / h2_3 * c_29
        + p12 * m2 * p21_2 * p22 / h2_3 * c_33 + m2 * p21_2 * p22_2 / h2_3 * c_36;
  }
  void lump_harmonic_re_v2_A_v2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = (-3.0 * m1 * p12_2 * h2 * lift - 3.0 * p12_2 * h1 * m2 * lift - 3.0 * p12_2 * m2 * h2 * lift
        + 6.0 * p12 * h1 * m2 * p22 * lift - 3.0 * h1 * m2 * p22_2 * lift) * per_0 / (20.0 * omega1 * h1 * h2);
    const double q_0 = f_0 * per_0;
    gradient[0] = -f_0 / omega1 - q_0;  // by omega1
    gradient[1] = q_0;  // by omega2
    const double c_0 = -3.0 * per_0 / (20.0 * omega1);  // multiplies m1*p12^2*h2*lift/(h1*h2)
    const double c_1 = -3.0 * per_0 / (20.0 * omega1);  // multiplies p12^2*h1*m2*lift/(h1*h2)
    const double c_2 = -3.0 * per_0 / (20.0 * omega1);  // multiplies p12^2*m2*h2*lift/(h1*h2)
    const double c_3 = 3.0 * per_0 / (10.0 * omega1);  // multiplies p12*h1*m2*p22*lift/(h1*h2)
    const double c_4 = -3.0 * per_0 / (20.0 * omega1);  // multiplies h1*m2*p22^2*lift/(h1*h2)
    gradient[2] = p12_2 * lift / h1 * c_0;  // by m1
    gradient[4] = 2.0 * m1 * p12 * lift / h1 * c_0 + 2.0 * p12 * m2 * lift / h2 * c_1
        + 2.0 * p12 * m2 * lift / h1 * c_2 + m2 * p22 * lift / h2 * c_3;
    gradient[5] = -m1 * p12_2 * lift / h1_2 * c_0 - p12_2 * m2 * lift / h1_2 * c_2;  // by h1
    gradient[6] = p12_2 * lift / h2 * c_1 + p12_2 * lift / h1 * c_2 + p12 * p22 * lift / h2 * c_3
        + p22_2 * lift / h2 * c_4;
    gradient[8] = p12 * m2 * lift / h2 * c_3 + 2.0 * m2 * p22 * lift / h2 * c_4;  // by p22
    gradient[9] = -p12_2 * m2 * lift / h2_2 * c_1 - p12 * m2 * p22 * lift / h2_2 * c_3
        - m2 * p22_2 * lift / h2_2 * c_4;
    gradient[13] = m1 * p12_2 / h1 * c_0 + p12_2 * m2 / h2 * c_1 + p12_2 * m2 / h1 * c_2 + p12 * m2 * p22 / h2 * c_3
        + m2 * p22_2 / h2 * c_4;
  }
  void lump_harmonic_re_v2_A_v1_A_v2_conjA_v2([[maybe_unused]] double* gradient) const {
    const double f_0 = (-72.0 * omega1_2 * m1 * p11 * p12_3 * h2_2 - 72.0 * omega1_2 * p11 * p12_3 * h1_2 * m2
        - 144.0 * omega1_2 * p11 * p12_3 * h1 * m2 * h2 - 72.0 * omega1_2 * p11 * p12_3 * m2 * h2_2
        + 216.0 * omega1_2 * p11 * p12_2 * h1_2 * m2 * p22 + 216.0 * omega1_2 * p11 * p12_2 * h1 * m2 * p22 * h2
        - 216.0 * omega1_2 * p11 * p12 * h1_2 * m2 * p22_2 - 72.0 * omega1_2 * p11 * p12 * h1 * m2 * p22_2 * h2
        + 72.0 * omega1_2 * p11 * h1_2 * m2 * p22_3 + 72.0 * omega1_2 * p12_3 * h1_2 * m2 * p21
        + 72.0 * omega1_2 * p12_3 * h1 * m2 * p21 * h2 - 216.0 * omega1_2 * p12_2 * h1_2 * m2 * p21 * p22
        - 72.0 * omega1_2 * p12_2 * h1 * m2 * p21 * p22 * h2 + 216.0 * omega1_2 * p12 * h1_2 * m2 * p21 * p22_2
        - 72.0 * omega1_2 * h1_2 * m2 * p21 * p22_3) * over_1 / (25.0 * h1_2 * h2_2);
    const double f_1 = (-72.0 * omega2_2 * m1 * p11 * p12_3 * h2_2 - 72.0 * omega2_2 * p11 * p12_3 * h1_2 * m2
        - 144.0 * omega2_2 * p11 * p12_3 * h1 * m2 * h2 - 72.0 * omega2_2 * p11 * p12_3 * m2 * h2_2
        + 216.0 * omega2_2 * p11 * p12_2 * h1_2 * m2 * p22 + 216.0 * omega2_2 * p11 * p12_2 * h1 * m2 * p22 * h2
        - 216.0 * omega2_2 * p11 * p12 * h1_2 * m2 * p22_2 - 72.0 * omega2_2 * p11 * p12 * h1 * m2 * p22_2 * h2
        + 72.0 * omega2_2 * p11 * h1_2 * m2 * p22_3 + 72.0 * omega2_2 * p12_3 * h1_2 * m2 * p21
        + 72.0 * omega2_2 * p12_3 * h1 * m2 * p21 * h2 - 216.0 * omega2_2 * p12_2 * h1_2 * m2 * p21 * p22
        - 72.0 * omega2_2 * p12_2 * h1 * m2 * p21 * p22 * h2 + 216.0 * omega2_2 * p12 * h1_2 * m2 * p21 * p22_2
        - 72.0 * omega2_2 * h1_2 * m2 * p21 * p22_3) * over_1 / (25.0 * h1_2 * h2_2);
    const double f_2 = (-216.0 * m1 * p11 * p12_3 * h2_3 * g - 216.0 * p11 * p12_3 * h1_3 * m2 * g
        + 216.0 * p11 * p12_3 * h1_3 * h2 * k2 + 216.0 * p11 * p12_3 * h1 * h2_3 * k1
        - 216.0 * p11 * p12_3 * m2 * h2_3 * g + 648.0 * p11 * p12_2 * h1_3 * m2 * p22 * g
        - 648.0 * p11 * p12_2 * h1_3 * p22 * h2 * k2 - 648.0 * p11 * p12 * h1_3 * m2 * p22_2 * g
        + 648.0 * p11 * p12 * h1_3 * p22_2 * h2 * k2 + 216.0 * p11 * h1_3 * m2 * p22_3 * g
        - 216.0 * p11 * h1_3 * p22_3 * h2 * k2 + 216.0 * p12_3 * h1_3 * m2 * p21 * g
        - 216.0 * p12_3 * h1_3 * p21 * h2 * k2 - 648.0 * p12_2 * h1_3 * m2 * p21 * p22 * g
        + 648.0 * p12_2 * h1_3 * p21 * p22 * h2 * k2 + 648.0 * p12 * h1_3 * m2 * p21 * p22_2 * g
        - 648.0 * p12 * h1_3 * p21 * p22_2 * h2 * k2 - 216.0 * h1_3 * m2 * p21 * p22_3 * g
        + 216.0 * h1_3 * p21 * p22_3 * h2 * k2) * over_1 / (35.0 * h1_3 * h2_3);
    const double q_0 = (f_0 + f_1 + f_2) * per_0;
    const double q_2 = (f_0 + f_1 + f_2) * per_2;
    gradient[0] = 2.0 * f_0 / omega1 - q_0 - q_2;  // by omega1
    gradient[1] = 2.0 * f_1 / omega2 + q_0 - q_2;  // by omega2
    const double c_0 = (-72.0 * omega1_2 - 72.0 * omega2_2) * over_1 / 25.0;
    const double c_1 = -216.0 * over_1 / 35.0;  // multiplies m1*p11*p12^3*h2^3*g/(h1^3*h2^3)
    const double c_2 = (-72.0 * omega1_2 - 72.0 * omega2_2) * over_1 / 25.0;
    const double c_3 = -216.0 * over_1 / 35.0;  // multiplies p11*p12^3*h1^3*m2*g/(h1^3*h2^3)
    const double c_4 = 216.0 * over_1 / 35.0;  // multiplies p11*p12^3*h1^3*h2*k2/(h1^3*h2^3)
    const double c_5 = (-144.0 * omega1_2 - 144.0 * omega2_2) * over_1 / 25.0;
    const double c_6 = (-72.0 * omega1_2 - 72.0 * omega2_2) * over_1 / 25.0;
    const double c_7 = 216.0 * over_1 / 35.0;  // multiplies p11*p12^3*h1*h2^3*k1/(h1^3*h2^3)
    const double c_8 = -216.0 * over_1 / 35.0;  // multiplies p11*p12^3*m2*h2^3*g/(h1^3*h2^3)
    const double c_9 = (216.0 * omega1_2 + 216.0 * omega2_2) * over_1 / 25.0;
    const double c_10 = 648.0 * over_1 / 35.0;  // multiplies p11*p12^2*h1^3*m2*p22*g/(h1^3*h2^3)
    const double c_11 = -648.0 * over_1 / 35.0;  // multiplies p11*p12^2*h1^3*p22*h2*k2/(h1^3*h2^3)
    const double c_12 = (216.0 * omega1_2 + 216.0 * omega2_2) * over_1 / 25.0;
    const double c_13 = (-216.0 * omega1_2 - 216.0 * omega2_2) * over_1 / 25.0;
    const double c_14 = -648.0 * over_1 / 35.0;  // multiplies p11*p12*h1^3*m2*p22^2*g/(h1^3*h2^3)
    const double c_15 = 648.0 * over_1 / 35.0;  // multiplies p11*p12*h1^3*p22^2*h2*k2/(h1^3*h2^3)
    const double c_16 = (-72.0 * omega1_2 - 72.0 * omega2_2) * over_1 / 25.0;
    const double c_17 = (72.0 * omega1_2 + 72.0 * omega2_2) * over_1 / 25.0;
    const double c_18 = 216.0 * over_1 / 35.0;  // multiplies p11*h1^3*m2*p22^3*g/(h1^3*h2^3)
    const double c_19 = -216.0 * over_1 / 35.0;  // multiplies p11*h1^3*p22^3*h2*k2/(h1^3*h2^3)
    const double c_20 = (72.0 * omega1_2 + 72.0 * omega2_2) * over_1 / 25.0;
    const double c_21 = 216.0 * over_1 / 35.0;  // multiplies p12^3*h1^3*m2*p21*g/(h1^3*h2^3)
    const double c_22 = -216.0 * over_1 / 35.0;  // multiplies p12^3*h1^3*p21*h2*k2/(h1^3*h2^3)
    const double c_23 = (72.0 * omega1_2 + 72.0 * omega2_2) * over_1 / 25.0;
    const double c_24 = (-216.0 * omega1_2 - 216.0 * omega2_2) * over_1 / 25.0;
    const double c_25 = -648.0 * over_1 / 35.0;  // multiplies p12^2*h1^3*m2*p21*p22*g/(h1^3*h2^3)
    const double c_26 = 648.0 * over_1 / 35.0;  // multiplies p12^2*h1^3*p21*p22*h2*k2/(h1^3*h2^3)
    const double c_27 = (-72.0 * omega1_2 - 72.0 * omega2_2) * over_1 / 25.0;
    const double c_28 = (216.0 * omega1_2 + 216.0 * omega2_2) * over_1 / 25.0;
    const double c_29 = 648.0 * over_1 / 35.0;  // multiplies p12*h1^3*m2*p21*p22^2*g/(h1^3*h2^3)
    const double c_30 = -648.0 * over_1 / 35.0;  // multiplies p12*h1^3*p21*p22^2*h2*k2/(h1^3*h2^3)
    const double c_31 = (-72.0 * omega1_2 - 72.0 * omega2_2) * over_1 / 25.0;
    const double c_32 = -216.0 * over_1 / 35.0;  // multiplies h1^3*m2*p21*p22^3*g/(h1^3*h2^3)
    const double c_33 = 216.0 * over_1 / 35.0;  // multiplies h1^3*p21*p22^3*h2*k2/(h1^3*h2^3)
    gradient[2] = p11 * p12_3 / h1_2 * c_0 + p11 * p12_3 * g / h1_3 * c_1;  // by m1
    gradient[3] = m1 * p12_3 / h1_2 * c_0 + m1 * p12_3 * g / h1_3 * c_1 + p12_3 * m2 / h2_2 * c_2
        + p12_3 * m2 * g / h2_3 * c_3 + p12_3 * k2 / h2_2 * c_4 + p12_3 * m2 / (h1 * h2) * c_5
        + p12_3 * m2 / h1_2 * c_6 + p12_3 * k1 / h1_2 * c_7 + p12_3 * m2 * g / h1_3 * c_8
        + p12_2 * m2 * p22 / h2_2 * c_9 + p12_2 * m2 * p22 * g / h2_3 * c_10 + p12_2 * p22 * k2 / h2_2 * c_11
        + p12_2 * m2 * p22 / (h1 * h2) * c_12 + p12 * m2 * p22_2 / h2_2 * c_13 + p12 * m2 * p22_2 * g / h2_3 * c_14
        + p12 * p22_2 * k2 / h2_2 * c_15 + p12 * m2 * p22_2 / (h1 * h2) * c_16 + m2 * p22_3 / h2_2 * c_17
        + m2 * p22_3 * g / h2_3 * c_18 + p22_3 * k2 / h2_2 * c_19;
    gradient[4] = 3.0 * m1 * p11 * p12_2 / h1_2 * c_0 + 3.0 * m1 * p11 * p12_2 * g / h1_3 * c_1
        + 3.0 * p11 * p12_2 * m2 / h2_2 * c_2 + 3.0 * p11 * p12_2 * m2 * g / h2_3 * c_3
        + 3.0 * p11 * p12_2 * k2 / h2_2 * c_4 + 3.0 * p11 * p12_2 * m2 / (h1 * h2) * c_5
        + 3.0 * p11 * p12_2 * m2 / h1_2 * c_6 + 3.0 * p11 * p12_2 * k1 / h1_2 * c_7
        + 3.0 * p11 * p12_2 * m2 * g / h1_3 * c_8 + 2.0 * p11 * p12 * m2 * p22 / h2_2 * c_9
        + 2.0 * p11 * p12 * m2 * p22 * g / h2_3 * c_10 + 2.0 * p11 * p12 * p22 * k2 / h2_2 * c_11
        + 2.0 * p11 * p12 * m2 * p22 / (h1 * h2) * c_12 + p11 * m2 * p22_2 / h2_2 * c_13
        + p11 * m2 * p22_2 * g / h2_3 * c_14 + p11 * p22_2 * k2 / h2_2 * c_15 + p11 * m2 * p22_2 / (h1 * h2) * c_16
        + 3.0 * p12_2 * m2 * p21 / h2_2 * c_20 + 3.0 * p12_2 * m2 * p21 * g / h2_3 * c_21
        + 3.0 * p12_2 * p21 * k2 / h2_2 * c_22 + 3.0 * p12_2 * m2 * p21 / (h1 * h2) * c_23
        + 2.0 * p12 * m2 * p21 * p22 / h2_2 * c_24 + 2.0 * p12 * m2 * p21 * p22 * g / h2_3 * c_25
        + 2.0 * p12 * p21 * p22 * k2 / h2_2 * c_26 + 2.0 * p12 * m2 * p21 * p22 / (h1 * h2) * c_27
        + m2 * p21 * p22_2 / h2_2 * c_28 + m2 * p21 * p22_2 * g / h2_3 * c_29 + p21 * p22_2 * k2 / h2_2 * c_30;
    gradient[5] = -2.0 * m1 * p11 * p12_3 / h1_3 * c_0 - 3.0 * m1 * p11 * p12_3 * g / h1_4 * c_1
        - p11 * p12_3 * m2 / (h1_2 * h2) * c_5 - 2.0 * p11 * p12_3 * m2 / h1_3 * c_6
        - 2.0 * p11 * p12_3 * k1 / h1_3 * c_7 - 3.0 * p11 * p12_3 * m2 * g / h1_4 * c_8
        - p11 * p12_2 * m2 * p22 / (h1_2 * h2) * c_12 - p11 * p12 * m2 * p22_2 / (h1_2 * h2) * c_16
        - p12_3 * m2 * p21 / (h1_2 * h2) * c_23 - p12_2 * m2 * p21 * p22 / (h1_2 * h2) * c_27;
    gradient[6] = p11 * p12_3 / h2_2 * c_2 + p11 * p12_3 * g / h2_3 * c_3 + p11 * p12_3 / (h1 * h2) * c_5
        + p11 * p12_3 / h1_2 * c_6 + p11 * p12_3 * g / h1_3 * c_8 + p11 * p12_2 * p22 / h2_2 * c_9
        + p11 * p12_2 * p22 * g / h2_3 * c_10 + p11 * p12_2 * p22 / (h1 * h2) * c_12
        + p11 * p12 * p22_2 / h2_2 * c_13 + p11 * p12 * p22_2 * g / h2_3 * c_14
        + p11 * p12 * p22_2 / (h1 * h2) * c_16 + p11 * p22_3 / h2_2 * c_17 + p11 * p22_3 * g / h2_3 * c_18
        + p12_3 * p21 / h2_2 * c_20 + p12_3 * p21 * g / h2_3 * c_21 + p12_3 * p21 / (h1 * h2) * c_23
        + p12_2 * p21 * p22 / h2_2 * c_24 + p12_2 * p21 * p22 * g / h2_3 * c_25
        + p12_2 * p21 * p22 / (h1 * h2) * c_27 + p12 * p21 * p22_2 / h2_2 * c_28
        + p12 * p21 * p22_2 * g / h2_3 * c_29 + p21 * p22_3 / h2_2 * c_31 + p21 * p22_3 * g / h2_3 * c_32;
    gradient[7] = p12_3 * m2 / h2_2 * c_20 + p12_3 * m2 * g / h2_3 * c_21 + p12_3 * k2 / h2_2 * c_22
        + p12_3 * m2 / (h1 * h2) * c_23 + p12_2 * m2 * p22 / h2_2 * c_24 + p12_2 * m2 * p22 * g / h2_3 * c_25
        + p12_2 * p22 * k2 / h2_2 * c_26 + p12_2 * m2 * p22 / (h1 * h2) * c_27 + p12 * m2 * p22_2 / h2_2 * c_28
        + p12 * m2 * p22_2 * g / h2_3 * c_29 + p12 * p22_2 * k2 / h2_2 * c_30 + m2 * p22_3 / h2_2 * c_31
        + m2 * p22_3 * g / h2_3 * c_32 + p22_3 * k2 / h2_2 * c_33;
    gradient[8] = p11 * p12_2 * m2 / h2_2 * c_9 + p11 * p12_2 * m2 * g / h2_3 * c_10
        + p11 * p12_2 * k2 / h2_2 * c_11 + p11 * p12_2 * m2 / (h1 * h2) * c_12
        + 2.0 * p11 * p12 * m2 * p22 / h2_2 * c_13 + 2.0 * p11 * p12 * m2 * p22 * g / h2_3 * c_14
        + 2.0 * p11 * p12 * p22 * k2 / h2_2 * c_15 + 2.0 * p11 * p12 * m2 * p22 / (h1 * h2) * c_16
        + 3.0 * p11 * m2 * p22_2 / h2_2 * c_17 + 3.0 * p11 * m2 * p22_2 * g / h2_3 * c_18
        + 3.0 * p11 * p22_2 * k2 / h2_2 * c_19 + p12_2 * m2 * p21 / h2_2 * c_24 + p12_2 * m2 * p21 * g / h2_3 * c_25
        + p12_2 * p21 * k2 / h2_2 * c_26 + p12_2 * m2 * p21 / (h1 * h2) * c_27
        + 2.0 * p12 * m2 * p21 * p22 / h2_2 * c_28 + 2.0 * p12 * m2 * p21 * p22 * g / h2_3 * c_29
        + 2.0 * p12 * p21 * p22 * k2 / h2_2 * c_30 + 3.0 * m2 * p21 * p22_2 / h2_2 * c_31
        + 3.0 * m2 * p21 * p22_2 * g / h2_3 * c_32 + 3.0 * p21 * p22_2 * k2 / h2_2 * c_33;
    gradient[9] = -2.0 * p11 * p12_3 * m2 / h2_3 * c_2 - 3.0 * p11 * p12_3 * m2 * g / h2_4 * c_3
        - 2.0 * p11 * p12_3 * k2 / h2_3 * c_4 - p11 * p12_3 * m2 / (h1 * h2_2) * c_5
        - 2.0 * p11 * p12_2 * m2 * p22 / h2_3 * c_9 - 3.0 * p11 * p12_2 * m2 * p22 * g / h2_4 * c_10
        - 2.0 * p11 * p12_2 * p22 * k2 / h2_3 * c_11 - p11 * p12_2 * m2 * p22 / (h1 * h2_2) * c_12
        - 2.0 * p11 * p12 * m2 * p22_2 / h2_3 * c_13 - 3.0 * p11 * p12 * m2 * p22_2 * g / h2_4 * c_14
        - 2.0 * p11 * p12 * p22_2 * k2 / h2_3 * c_15 - p11 * p12 * m2 * p22_2 / (h1 * h2_2) * c_16
        - 2.0 * p11 * m2 * p22_3 / h2_3 * c_17 - 3.0 * p11 * m2 * p22_3 * g / h2_4 * c_18
        - 2.0 * p11 * p22_3 * k2 / h2_3 * c_19 - 2.0 * p12_3 * m2 * p21 / h2_3 * c_20
        - 3.0 * p12_3 * m2 * p21 * g / h2_4 * c_21 - 2.0 * p12_3 * p21 * k2 / h2_3 * c_22
        - p12_3 * m2 * p21 / (h1 * h2_2) * c_23 - 2.0 * p12_2 * m2 * p21 * p22 / h2_3 * c_24
        - 3.0 * p12_2 * m2 * p21 * p22 * g / h2_4 * c_25 - 2.0 * p12_2 * p21 * p22 * k2 / h2_3 * c_26
        - p12_2 * m2 * p21 * p22 / (h1 * h2_2) * c_27 - 2.0 * p12 * m2 * p21 * p22_2 / h2_3 * c_28
        - 3.0 * p12 * m2 * p21 * p22_2 * g / h2_4 * c_29 - 2.0 * p12 * p21 * p22_2 * k2 / h2_3 * c_30
        - 2.0 * m2 * p21 * p22_3 / h2_3 * c_31 - 3.0 * m2 * p21 * p22_3 * g / h2_4 * c_32
        - 2.0 * p21 * p22_3 * k2 / h2_3 * c_33;
    gradient[10] = p11 * p12_3 / h1_2 * c_7;  // by k1
    gradient[11] = p11 * p12_3 / h2_2 * c_4 + p11 * p12_2 * p22 / h2_2 * c_11 + p11 * p12 * p22_2 / h2_2 * c_15
        + p11 * p22_3 / h2_2 * c_19 + p12_3 * p21 / h2_2 * c_22 + p12_2 * p21 * p22 / h2_2 * c_26
        + p12 * p21 * p22_2 / h2_2 * c_30 + p21 * p22_3 / h2_2 * c_33;
    gradient[12] = m1 * p11 * p12_3 / h1_3 * c_1 + p11 * p12_3 * m2 / h2_3 * c_3 + p11 * p12_3 * m2 / h1_3 * c_8
        + p11 * p12_2 * m2 * p22 / h2_3 * c_10 + p11 * p12 * m2 * p22_2 / h2_3 * c_14
        + p11 * m2 * p22_3 / h2_3 * c_18 + p12_3 * m2 * p21 / h2_3 * c_21 + p12_2 * m2 * p21 * p22 / h2_3 * c_25
        + p12 * m2 * p21 * p22_2 / h2_3 * c_29 + m2 * p21 * p22_3 / h2_3 * c_32;
  }
  void lump_harmonic_re_v2_A_v12_conjA_v1([[maybe_unused]] double* gradient) const {
    const double f_0 = (-72.0 * omega1_2 * m1 * p11_3 * p12 * h2_2 - 72.0 * omega1_2 * p11_3 * p12 * h1_2 * m2
        - 144.0 * omega1_2 * p11_3 * p12 * h1 * m2 * h2 - 72.0 * omega1_2 * p11_3 * p12 * m2 * h2_2
        + 72.0 * omega1_2 * p11_3 * h1_2 * m2 * p22 + 72.0 * omega1_2 * p11_3 * h1 * m2 * p22 * h2
        + 216.0 * omega1_2 * p11_2 * p12 * h1_2 * m2 * p21 + 216.0 * omega1_2 * p11_2 * p12 * h1 * m2 * p21 * h2
        - 216.0 * omega1_2 * p11_2 * h1_2 * m2 * p21 * p22 - 72.0 * omega1_2 * p11_2 * h1 * m2 * p21 * p22 * h2
        - 216.0 * omega1_2 * p11 * p12 * h1_2 * m2 * p21_2 - 72.0 * omega1_2 * p11 * p12 * h1 * m2 * p21_2 * h2
        + 216.0 * omega1_2 * p11 * h1_2 * m2 * p21_2 * p22 + 72.0 * omega1_2 * p12 * h1_2 * m2 * p21_3
        - 72.0 * omega1_2 * h1_2 * m2 * p21_3 * p22) * over_1 / (25.0 * h1_2 * h2_2);
    const double f_1 = (-108.0 * m1 * p11_3 * p12 * h2_3 * g - 108.0 * p11_3 * p12 * h1_3 * m2 * g
        + 108.0 * p11_3 * p12 * h1_3 * h2 * k2 + 108.0 * p11_3 * p12 * h1 * h2_3 * k1
        - 108.0 * p11_3 * p12 * m2 * h2_3 * g + 108.0 * p11_3 * h1_3 * m2 * p22 * g
        - 108.0 * p11_3 * h1_3 * p22 * h2 * k2 + 324.0 * p11_2 * p12 * h1_3 * m2 * p21 * g
        - 324.0 * p11_2 * p12 * h1_3 * p21 * h2 * k2 - 324.0 * p11_2 * h1_3 * m2 * p21 * p22 * g
        + 324.0 * p11_2 * h1_3 * p21 * p22 * h2 * k2 - 324.0 * p11 * p12 * h1_3 * m2 * p21_2 * g
        + 324.0 * p11 * p12 * h1_3 * p21_2 * h2 * k2 + 324.0 * p11 * h1_3 * m2 * p21_2 * p22 * g
        - 324.0 * p11 * h1_3 * p21_2 * p22 * h2 * k2 + 108.0 * p12 * h1_3 * m2 * p21_3 * g
        - 108.0 * p12 * h1_3 * p21_3 * h2 * k2 - 108.0 * h1_3 * m2 * p21_3 * p22 * g
        + 108.0 * h1_3 * p21_3 * p22 * h2 * k2) * over_1 / (35.0 * h1_3 * h2_3);
    const double q_0 = (f_0 + f_1) * per_0;
    const double q_2 = (f_0 + f_1) * per_2;
    gradient[0] = 2.0 * f_0 / omega1 - q_0 - q_2;  // by omega1
    gradient[1] = q_0 - q_2;  // by omega2
    const double c_0 = -72.0 * omega1_2 * over_1 / 25.0;  // multiplies m1*p11^3*p12*h1*h2^3/(h1^3*h2^3)
    const double c_1 = -108.0 * over_1 / 35.0;  // multiplies m1*p11^3*p12*h2^3*g/(h1^3*h2^3)
    const double c_2 = -72.0 * omega1_2 * over_1 / 25.0;  // multiplies p11^3*p12*h1^3*m2*h2/(h1^3*h2^3)
    const double c_3 = -108.0 * over_1 / 35.0;  // multiplies p11^3*p12*h1^3*m2*g/(h1^3*h2^3)
    const double c_4 = 108.0 * over_1 / 35.0;  // multiplies p11^3*p12*h1^3*h2*k2/(h1^3*h2^3)
    const double c_5 = -144.0 * omega1_2 * over_1 / 25.0;  // multiplies p11^3*p12*h1^2*m2*h2^2/(h1^3*h2^3)
    const double c_6 = -72.0 * omega1_2 * over_1 / 25.0;  // multiplies p11^3*p12*h1*m2*h2^3/(h1^3*h2^3)
    const double c_7 = 108.0 * over_1 / 35.0;  // multiplies p11^3*p12*h1*h2^3*k1/(h1^3*h2^3)
    const double c_8 = -108.0 * over_1 / 35.0;  // multiplies p11^3*p12*m2*h2^3*g/(h1^3*h2^3)
    const double c_9 = 72.0 * omega1_2 * over_1 / 25.0;  // multiplies p11^3*h1^3*m2*p22*h2/(h1^3*h2^3)
    const double c_10 = 108.0 * over_1 / 35.0;  // multiplies p11^3*h1^3*m2*p22*g/(h1^3*h2^3)
    const double c_11 = -108.0 * over_1 / 35.0;  // multiplies p11^3*h1^3*p22*h2*k2/(h1^3*h2^3)
    const double c_12 = 72.0 * omega1_2 * over_1 / 25.0;  // multiplies p11^3*h1^2*m2*p22*h2^2/(h1^3*h2^3)
    const double c_13 = 216.0 * omega1_2 * over_1 / 25.0;  // multiplies p11^2*p12*h1^3*m2*p21*h2/(h1^3*h2^3)
    const double c_14 = 324.0 * over_1 / 35.0;  // multiplies p11^2*p12*h1^3*m2*p21*g/(h1^3*h2^3)
    const double c_15 = -324.0 * over_1 / 35.0;  // multiplies p11^2*p12*h1^3*p21*h2*k2/(h1^3*h2^3)
    const double c_16 = 216.0 * omega1_2 * over_1 / 25.0;  // multiplies p11^2*p12*h1^2*m2*p21*h2^2/(h1^3*h2^3)
    const double c_17 = -216.0 * omega1_2 * over_1 / 25.0;  // multiplies p11^2*h1^3*m2*p21*p22*h2/(h1^3*h2^3)
    const double c_18 = -324.0 * over_1 / 35.0;  // multiplies p11^2*h1^3*m2*p21*p22*g/(h1^3*h2^3)
    const double c_19 = 324.0 * over_1 / 35.0;  // multiplies p11^2*h1^3*p21*p22*h2*k2/(h1^3*h2^3)
    const double c_20 = -72.0 * omega1_2 * over_1 / 25.0;  // multiplies p11^2*h1^2*m2*p21*p22*h2^2/(h1^3*h2^3)
    const double c_21 = -216.0 * omega1_2 * over_1 / 25.0;  // multiplies p11*p12*h1^3*m2*p21^2*h2/(h1^3*h2^3)
    const double c_22 = -324.0 * over_1 / 35.0;  // multiplies p11*p12*h1^3*m2*p21^2*g/(h1^3*h2^3)
    const double c_23 = 324.0 * over_1 / 35.0;  // multiplies p11*p12*h1^3*p21^2*h2*k2/(h1^3*h2^3)
    const double c_24 = -72.0 * omega1_2 * over_1 / 25.0;  // multiplies p11*p12*h1^2*m2*p21^2*h2^2/(h1^3*h2^3)
    const double c_25 = 216.0 * omega1_2 * over_1 / 25.0;  // multiplies p11*h1^3*m2*p21^2*p22*h2/(h1^3*h2^3)
    const double c_26 = 324.0 * over_1 / 35.0;  // multiplies p11*h1^3*m2*p21^2*p22*g/(h1^3*h2^3)
    const double c_27 = -324.0 * over_1 / 35.0;  // multiplies p11*h1^3*p21^2*p22*h2*k2/(h1^3*h2^3)
    const double c_28 = 72.0 * omega1_2 * over_1 / 25.0;  // multiplies p12*h1^3*m2*p21^3*h2/(h1^3*h2^3)
    const double c_29 = 108.0 * over_1 / 35.0;  // multiplies p12*h1^3*m2*p21^3*g/(h1^3*h2^3)
    const double c_30 = -108.0 * over_1 / 35.0;  // multiplies p12*h1^3*p21^3*h2*k2/(h1^3*h2^3)
    const double c_31 = -72.0 * omega1_2 * over_1 / 25.0;  // multiplies h1^3*m2*p21^3*p22*h2/(h1^3*h2^3)
    const double c_32 = -108.0 * over_1 / 35.0;  // multiplies h1^3*m2*p21^3*p22*g/(h1^3*h2^3)
    const double c_33 = 108.0 * over_1 / 35.0;  // multiplies h1^3*p21^3*p22*h2*k2/(h1^3*h2^3)
    gradient[2] = p11_3 * p12 / h1_2 * c_0 + p11_3 * p12 * g / h1_3 * c_1;  // by m1
    gradient[3] = 3.0 * m1 * p11_2 * p12 / h1_2 * c_0 + 3.0 * m1 * p11_2 * p12 * g / h1_3 * c_1
        + 3.0 * p11_2 * p12 * m2 / h2_2 * c_2 + 3.0 * p11_2 * p12 * m2 * g / h2_3 * c_3
        + 3.0 * p11_2 * p12 * k2 / h2_2 * c_4 + 3.0 * p11_2 * p12 * m2 / (h1 * h2) * c_5
        + 3.0 * p11_2 * p12 * m2 / h1_2 * c_6 + 3.0 * p11_2 * p12 * k1 / h1_2 * c_7
        + 3.0 * p11_2 * p12 * m2 * g / h1_3 * c_8 + 3.0 * p11_2 * m2 * p22 / h2_2 * c_9
        + 3.0 * p11_2 * m2 * p22 * g / h2_3 * c_10 + 3.0 * p11_2 * p22 * k2 / h2_2 * c_11
        + 3.0 * p11_2 * m2 * p22 / (h1 * h2) * c_12 + 2.0 * p11 * p12 * m2 * p21 / h2_2 * c_13
        + 2.0 * p11 * p12 * m2 * p21 * g / h2_3 * c_14 + 2.0 * p11 * p12 * p21 * k2 / h2_2 * c_15
        + 2.0 * p11 * p12 * m2 * p21 / (h1 * h2) * c_16 + 2.0 * p11 * m2 * p21 * p22 / h2_2 * c_17
        + 2.0 * p11 * m2 * p21 * p22 * g / h2_3 * c_18 + 2.0 * p11 * p21 * p22 * k2 / h2_2 * c_19
        + 2.0 * p11 * m2 * p21 * p22 / (h1 * h2) * c_20 + p12 * m2 * p21_2 / h2_2 * c_21
        + p12 * m2 * p21_2 * g / h2_3 * c_22 + p12 * p21_2 * k2 / h2_2 * c_23 + p12 * m2 * p21_2 / (h1 * h2) * c_24
        + m2 * p21_2 * p22 / h2_2 * c_25 + m2 * p21_2 * p22 * g / h2_3 * c_26 + p21_2 * p22 * k2 / h2_2 * c_27;
    gradient[4] = m1 * p11_3 / h1_2 * c_0 + m1 * p11_3 * g / h1_3 * c_1 + p11_3 * m2 / h2_2 * c_2
        + p11_3 * m2 * g / h2_3 * c_3 + p11_3 * k2 / h2_2 * c_4 + p11_3 * m2 / (h1 * h2) * c_5
        + p11_3 * m2 / h1_2 * c_6 + p11_3 * k1 / h1_2 * c_7 + p11_3 * m2 * g / h1_3 * c_8
        + p11_2 * m2 * p21 / h2_2 * c_13 + p11_2 * m2 * p21 * g / h2_3 * c_14 + p11_2 * p21 * k2 / h2_2 * c_15
        + p11_2 * m2 * p21 / (h1 * h2) * c_16 + p11 * m2 * p21_2 / h2_2 * c_21 + p11 * m2 * p21_2 * g / h2_3 * c_22
        + p11 * p21_2 * k2 / h2_2 * c_23 + p11 * m2 * p21_2 / (h1 * h2) * c_24 + m2 * p21_3 / h2_2 * c_28
        + m2 * p21_3 * g / h2_3 * c_29 + p21_3 * k2 / h2_2 * c_30;
    gradient[5] = -2.0 * m1 * p11_3 * p12 / h1_3 * c_0 - 3.0 * m1 * p11_3 * p12 * g / h1_4 * c_1
        - p11_3 * p12 * m2 / (h1_2 * h2) * c_5 - 2.0 * p11_3 * p12 * m2 / h1_3 * c_6
        - 2.0 * p11_3 * p12 * k1 / h1_3 * c_7 - 3.0 * p11_3 * p12 * m2 * g / h1_4 * c_8
        - p11_3 * m2 * p22 / (h1_2 * h2) * c_12 - p11_2 * p12 * m2 * p21 / (h1_2 * h2) * c_16
        - p11_2 * m2 * p21 * p22 / (h1_2 * h2) * c_20 - p11 * p12 * m2 * p21_2 / (h1_2 * h2) * c_24;
    gradient[6] = p11_3 * p12 / h2_2 * c_2 + p11_3 * p12 * g / h2_3 * c_3 + p11_3 * p12 / (h1 * h2) * c_5
        + p11_3 * p12 / h1_2 * c_6 + p11_3 * p12 * g / h1_3 * c_8 + p11_3 * p22 / h2_2 * c_9
        + p11_3 * p22 * g / h2_3 * c_10 + p11_3 * p22 / (h1 * h2) * c_12 + p11_2 * p12 * p21 / h2_2 * c_13
        + p11_2 * p12 * p21 * g / h2_3 * c_14 + p11_2 * p12 * p21 / (h1 * h2) * c_16
        + p11_2 * p21 * p22 / h2_2 * c_17 + p11_2 * p21 * p22 * g / h2_3 * c_18
        + p11_2 * p21 * p22 / (h1 * h2) * c_20 + p11 * p12 * p21_2 / h2_2 * c_21
        + p11 * p12 * p21_2 * g / h2_3 * c_22 + p11 * p12 * p21_2 / (h1 * h2) * c_24
        + p11 * p21_2 * p22 / h2_2 * c_25 + p11 * p21_2 * p22 * g / h2_3 * c_26 + p12 * p21_3 / h2_2 * c_28
        + p12 * p21_3 * g / h2_3 * c_29 + p21_3 * p22 / h2_2 * c_31 + p21_3 * p22 * g / h2_3 * c_32;
    gradient[7] = p11_2 * p12 * m2 / h2_2 * c_13 + p11_2 * p12 * m2 * g / h2_3 * c_14
        + p11_2 * p12 * k2 / h2_2 * c_15 + p11_2 * p12 * m2 / (h1 * h2) * c_16 + p11_2 * m2 * p22 / h2_2 * c_17
        + p11_2 * m2 * p22 * g / h2_3 * c_18 + p11_2 * p22 * k2 / h2_2 * c_19 + p11_2 * m2 * p22 / (h1 * h2) * c_20
        + 2.0 * p11 * p12 * m2 * p21 / h2_2 * c_21 + 2.0 * p11 * p12 * m2 * p21 * g / h2_3 * c_22
        + 2.0 * p11 * p12 * p21 * k2 / h2_2 * c_23 + 2.0 * p11 * p12 * m2 * p21 / (h1 * h2) * c_24
        + 2.0 * p11 * m2 * p21 * p22 / h2_2 * c_25 + 2.0 * p11 * m2 * p21 * p22 * g / h2_3 * c_26
        + 2.0 * p11 * p21 * p22 * k2 / h2_2 * c_27 + 3.0 * p12 * m2 * p21_2 / h2_2 * c_28
        + 3.0 * p12 * m2 * p21_2 * g / h2_3 * c_29 + 3.0 * p12 * p21_2 * k2 / h2_2 * c_30
        + 3.0 * m2 * p21_2 * p22 / h2_2 * c_31 + 3.0 * m2 * p21_2 * p22 * g / h2_3 * c_32
        + 3.0 * p21_2 * p22 * k2 / h2_2 * c_33;
    gradient[8] = p11_3 * m2 / h2_2 * c_9 + p11_3 * m2 * g / h2_3 * c_10 + p11_3 * k2 / h2_2 * c_11
        + p11_3 * m2 / (h1 * h2) * c_12 + p11_2 * m2 * p21 / h2_2 * c_17 + p11_2 * m2 * p21 * g / h2_3 * c_18
        + p11_2 * p21 * k2 / h2_2 * c_19 + p11_2 * m2 * p21 / (h1 * h2) * c_20 + p11 * m2 * p21_2 / h2_2 * c_25
        + p11 * m2 * p21_2 * g / h2_3 * c_26 + p11 * p21_2 * k2 / h2_2 * c_27 + m2 * p21_3 / h2_2 * c_31
        + m2 * p21_3 * g / h2_3 * c_32 + p21_3 * k2 / h2_2 * c_33;
    gradient[9] = -2.0 * p11_3 * p12 * m2 / h2_3 * c_2 - 3.0 * p11_3 * p12 * m2 * g / h2_4 * c_3
        - 2.0 * p11_3 * p12 * k2 / h2_3 * c_4 - p11_3 * p12 * m2 / (h1 * h2_2) * c_5
        - 2.0 * p11_3 * m2 * p22 / h2_3 * c_9 - 3.0 * p11_3 * m2 * p22 * g / h2_4 * c_10
        - 2.0 * p11_3 * p22 * k2 / h2_3 * c_11 - p11_3 * m2 * p22 / (h1 * h2_2) * c_12
        - 2.0 * p11_2 * p12 * m2 * p21 / h2_3 * c_13 - 3.0 * p11_2 * p12 * m2 * p21 * g / h2_4 * c_14
        - 2.0 * p11_2 * p12 * p21 * k2 / h2_3 * c_15 - p11_2 * p12 * m2 * p21 / (h1 * h2_2) * c_16
        - 2.0 * p11_2 * m2 * p21 * p22 / h2_3 * c_17 - 3.0 * p11_2 * m2 * p21 * p22 * g / h2_4 * c_18
        - 2.0 * p11_2 * p21 * p22 * k2 / h2_3 * c_19 - p11_2 * m2 * p21 * p22 / (h1 * h2_2) * c_20
        - 2.0 * p11 * p12 * m2 * p21_2 / h2_3 * c_21 - 3.0 * p11 * p12 * m2 * p21_2 * g / h2_4 * c_22
        - 2.0 * p11 * p12 * p21_2 * k2 / h2_3 * c_23 - p11 * p12 * m2 * p21_2 / (h1 * h2_2) * c_24
        - 2.0 * p11 * m2 * p21_2 * p22 / h2_3 * c_25 - 3.0 * p11 * m2 * p21_2 * p22 * g / h2_4 * c_26
        - 2.0 * p11 * p21_2 * p22 * k2 / h2_3 * c_27 - 2.0 * p12 * m2 * p21_3 / h2_3 * c_28
        - 3.0 * p12 * m2 * p21_3 * g / h2_4 * c_29 - 2.0 * p12 * p21_3 * k2 / h2_3 * c_30
        - 2.0 * m2 * p21_3 * p22 / h2_3 * c_31 - 3.0 * m2 * p21_3 * p22 * g / h2_4 * c_32
        - 2.0 * p21_3 * p22 * k2 / h2_3 * c_33;
    gradient[10] = p11_3 * p12 / h1_2 * c_7;  // by k1
    gradient[11] = p11_3 * p12 / h2_2 * c_4 + p11_3 * p22 / h2_2 * c_11 + p11_2 * p12 * p21 / h2_2 * c_15
        + p11_2 * p21 * p22 / h2_2 * c_19 + p11 * p12 * p21_2 / h2_2 * c_23 + p11 * p21_2 * p22 / h2_2 * c_27
        + p12 * p21_3 / h2_2 * c_30 + p21_3 * p22 / h2_2 * c_33;
    gradient[12] = m1 * p11_3 * p12 / h1_3 * c_1 + p11_3 * p12 * m2 / h2_3 * c_3 + p11_3 * p12 * m2 / h1_3 * c_8
        + p11_3 * m2 * p22 / h2_3 * c_10 + p11_2 * p12 * m2 * p21 / h2_3 * c_14
        + p11_2 * m2 * p21 * p22 / h2_3 * c_18 + p11 * p12 * m2 * p21_2 / h2_3 * c_22
        + p11 * m2 * p21_2 * p22 / h2_3 * c_26 + p12 * m2 * p21_3 / h2_3 * c_29 + m2 * p21_3 * p22 / h2_3 * c_32;
  }
  void lump_harmonic_re_v2_A_v22_conjA_v1([[maybe_unused]] double* gradient) const {
    const double f_0 = (-36.0 * omega1_2 * m1 * p11 * p12_3 * h2_2 - 36.0 * omega1_2 * p11 * p12_3 * h1_2 * m2
        - 72.0 * omega1_2 * p11 * p12_3 * h1 * m2 * h2 - 36.0 * omega1_2 * p11 * p12_3 * m2 * h2_2
        + 108.0 * omega1_2 * p11 * p12_2 * h1_2 * m2 * p22 + 108.0 * omega1_2 * p11 * p12_2 * h1 * m2 * p22 * h2
        - 108.0 * omega1_2 * p11 * p12 * h1_2 * m2 * p22_2 - 36.0 * omega1_2 * p11 * p12 * h1 * m2 * p22_2 * h2
        + 36.0 * omega1_2 * p11 * h1_2 * m2 * p22_3 + 36.0 * omega1_2 * p12_3 * h1_2 * m2 * p21
        + 36.0 * omega1_2 * p12_3 * h1 * m2 * p21 * h2 - 108.0 * omega1_2 * p12_2 * h1_2 * m2 * p21 * p22
        - 36.0 * omega1_2 * p12_2 * h1 * m2 * p21 * p22 * h2 + 108.0 * omega1_2 * p12 * h1_2 * m2 * p21 * p22_2
        - 36.0 * omega1_2 * h1_2 * m2 * p21 * p22_3) * over_5 / (25.0 * h1_2 * h2_2);
    const double f_1 = (72.0 * omega1 * omega2 * m1 * p11 * p12_3 * h2_2
        + 72.0 * omega1 * omega2 * p11 * p12_3 * h1_2 * m2 + 144.0 * omega1 * omega2 * p11 * p12_3 * h1 * m2 * h2
        + 72.0 * omega1 * omega2 * p11 * p12_3 * m2 * h2_2 - 216.0 * omega1 * omega2 * p11 * p12_2 * h1_2 * m2 * p22
        - 216.0 * omega1 * omega2 * p11 * p12_2 * h1 * m2 * p22 * h2
        + 216.0 * omega1 * omega2 * p11 * p12 * h1_2 * m2 * p22_2
        + 72.0 * omega1 * omega2 * p11 * p12 * h1 * m2 * p22_2 * h2
        - 72.0 * omega1 * omega2 * p11 * h1_2 * m2 * p22_3 - 72.0 * omega1 * omega2 * p12_3 * h1_2 * m2 * p21
        - 72.0 * omega1 * omega2 * p12_3 * h1 * m2 * p21 * h2
        + 216.0 * omega1 * omega2 * p12_2 * h1_2 * m2 * p21 * p22
        + 72.0 * omega1 * omega2 * p12_2 * h1 * m2 * p21 * p22 * h2
        - 216.0 * omega1 * omega2 * p12 * h1_2 * m2 * p21 * p22_2
        + 72.0 * omega1 * omega2 * h1_2 * m2 * p21 * p22_3) * over_5 / (25.0 * h1_2 * h2_2);
    const double f_2 = (-108.0 * omega2_2 * m1 * p11 * p12_3 * h2_2 - 108.0 * omega2_2 * p11 * p12_3 * h1_2 * m2
        - 216.0 * omega2_2 * p11 * p12_3 * h1 * m2 * h2 - 108.0 * omega2_2 * p11 * p12_3 * m2 * h2_2
        + 324.0 * omega2_2 * p11 * p12_2 * h1_2 * m2 * p22 + 324.0 * omega2_2 * p11 * p12_2 * h1 * m2 * p22 * h2
        - 324.0 * omega2_2 * p11 * p12 * h1_2 * m2 * p22_2 - 108.0 * omega2_2 * p11 * p12 * h1 * m2 * p22_2 * h2
        + 108.0 * omega2_2 * p11 * h1_2 * m2 * p22_3 + 108.0 * omega2_2 * p12_3 * h1_2 * m2 * p21
        + 108.0 * omega2_2 * p12_3 * h1 * m2 * p21 * h2 - 324.0 * omega2_2 * p12_2 * h1_2 * m2 * p21 * p22
        - 108.0 * omega2_2 * p12_2 * h1 * m2 * p21 * p22 * h2 + 324.0 * omega2_2 * p12 * h1_2 * m2 * p21 * p22_2
        - 108.0 * omega2_2 * h1_2 * m2 * p21 * p22_3) * over_5 / (25.0 * h1_2 * h2_2);
    const double f_3 = (-108.0 * m1 * p11 * p12_3 * h2_3 * g - 108.0 * p11 * p12_3 * h1_3 * m2 * g
        + 108.0 * p11 * p12_3 * h1_3 * h2 * k2 + 108.0 * p11 * p12_3 * h1 * h2_3 * k1
        - 108.0 * p11 * p12_3 * m2 * h2_3 * g + 324.0 * p11 * p12_2 * h1_3 * m2 * p22 * g
        - 324.0 * p11 * p12_2 * h1_3 * p22 * h2 * k2 - 324.0 * p11 * p12 * h1_3 * m2 * p22_2 * g
        + 324.0 * p11 * p12 * h1_3 * p22_2 * h2 * k2 + 108.0 * p11 * h1_3 * m2 * p22_3 * g
        - 108.0 * p11 * h1_3 * p22_3 * h2 * k2 + 108.0 * p12_3 * h1_3 * m2 * p21 * g
        - 108.0 * p12_3 * h1_3 * p21 * h2 * k2 - 324.0 * p12_2 * h1_3 * m2 * p21 * p22 * g
        + 324.0 * p12_2 * h1_3 * p21 * p22 * h2 * k2 + 324.0 * p12 * h1_3 * m2 * p21 * p22_2 * g
        - 324.0 * p12 * h1_3 * p21 * p22_2 * h2 * k2 - 108.0 * h1_3 * m2 * p21 * p22_3 * g
        + 108.0 * h1_3 * p21 * p22_3 * h2 * k2) * over_5 / (35.0 * h1_3 * h2_3);
    const double q_0 = (f_0 + f_1 + f_2 + f_3) * per_0;
    const double q_5 = (f_0 + f_1 + f_2 + f_3) * per_5;
    gradient[0] = (2.0 * f_0 + f_1) / omega1 - q_0 - q_5;  // by omega1
    gradient[1] = (f_1 + 2.0 * f_2) / omega2 + q_0 + 3.0 * q_5;  // by omega2
    const double c_0 = (-36.0 * omega1_2 + 72.0 * omega1 * omega2 - 108.0 * omega2_2) * over_5 / 25.0;
    const double c_1 = -108.0 * over_5 / 35.0;  // multiplies m1*p11*p12^3*h2^3*g/(h1^3*h2^3)
    const double c_2 = (-36.0 * omega1_2 + 72.0 * omega1 * omega2 - 108.0 * omega2_2) * over_5 / 25.0;
    const double c_3 = -108.0 * over_5 / 35.0;  // multiplies p11*p12^3*h1^3*m2*g/(h1^3*h2^3)
    const double c_4 = 108.0 * over_5 / 35.0;  // multiplies p11*p12^3*h1^3*h2*k2/(h1^3*h2^3)
    const double c_5 = (-72.0 * omega1_2 + 144.0 * omega1 * omega2 - 216.0 * omega2_2) * over_5 / 25.0;
    const double c_6 = (-36.0 * omega1_2 + 72.0 * omega1 * omega2 - 108.0 * omega2_2) * over_5 / 25.0;
    const double c_7 = 108.0 * over_5 / 35.0;  // multiplies p11*p12^3*h1*h2^3*k1/(h1^3*h2^3)
    const double c_8 = -108.0 * over_5 / 35.0;  // multiplies p11*p12^3*m2*h2^3*g/(h1^3*h2^3)
    const double c_9 = (108.0 * omega1_2 - 216.0 * omega1 * omega2 + 324.0 * omega2_2) * over_5 / 25.0;
    const double c_10 = 324.0 * over_5 / 35.0;  // multiplies p11*p12^2*h1^3*m2*p22*g/(h1^3*h2^3)
    const double c_11 = -324.0 * over_5 / 35.0;  // multiplies p11*p12^2*h1^3*p22*h2*k2/(h1^3*h2^3)
    const double c_12 = (108.0 * omega1_2 - 216.0 * omega1 * omega2 + 324.0 * omega2_2) * over_5 / 25.0;
    const double c_13 = (-108.0 * omega1_2 + 216.0 * omega1 * omega2 - 324.0 * omega2_2) * over_5 / 25.0;
    const double c_14 = -324.0 * over_5 / 35.0;  // multiplies p11*p12*h1^3*m2*p22^2*g/(h1^3*h2^3)
    const double c_15 = 324.0 * over_5 / 35.0;  // multiplies p11*p12*h1^3*p22^2*h2*k2/(h1^3*h2^3)
    const double c_16 = (-36.0 * omega1_2 + 72.0 * omega1 * omega2 - 108.0 * omega2_2) * over_5 / 25.0;
    const double c_17 = (36.0 * omega1_2 - 72.0 * omega1 * omega2 + 108.0 * omega2_2) * over_5 / 25.0;
    const double c_18 = 108.0 * over_5 / 35.0;  // multiplies p11*h1^3*m2*p22^3*g/(h1^3*h2^3)
    const double c_19 = -108.0 * over_5 / 35.0;  // multiplies p11*h1^3*p22^3*h2*k2/(h1^3*h2^3)
    const double c_20 = (36.0 * omega1_2 - 72.0 * omega1 * omega2 + 108.0 * omega2_2) * over_5 / 25.0;
    const double c_21 = 108.0 * over_5 / 35.0;  // multiplies p12^3*h1^3*m2*p21*g/(h1^3*h2^3)
    const double c_22 = -108.0 * over_5 / 35.0;  // multiplies p12^3*h1^3*p21*h2*k2/(h1^3*h2^3)
    const double c_23 = (36.0 * omega1_2 - 72.0 * omega1 * omega2 + 108.0 * omega2_2) * over_5 / 25.0;
    const double c_24 = (-108.0 * omega1_2 + 216.0 * omega1 * omega2 - 324.0 * omega2_2) * over_5 / 25.0;
    const double c_25 = -324.0 * over_5 / 35.0;  // multiplies p12^2*h1^3*m2*p21*p22*g/(h1^3*h2^3)
    const double c_26 = 324.0 * over_5 / 35.0;  // multiplies p12^2*h1^3*p21*p22*h2*k2/(h1^3*h2^3)
    const double c_27 = (-36.0 * omega1_2 + 72.0 * omega1 * omega2 - 108.0 * omega2_2) * over_5 / 25.0;
    const double c_28 = (108.0 * omega1_2 - 216.0 * omega1 * omega2 + 324.0 * omega2_2) * over_5 / 25.0;
    const double c_29 = 324.0 * over_5 / 35.0;  // multiplies p12*h1^3*m2*p21*p22^2*g/(h1^3*h2^3)
    const double c_30 = -324.0 * over_5 / 35.0;  // multiplies p12*h1^3*p21*p22^2*h2*k2/(h1^3*h2^3)
    const double c_31 = (-36.0 * omega1_2 + 72.0 * omega1 * omega2 - 108.0 * omega2_2) * over_5 / 25.0;
    const double c_32 = -108.0 * over_5 / 35.0;  // multiplies h1^3*m2*p21*p22^3*g/(h1^3*h2^3)
    const double c_33 = 108.0 * over_5 / 35.0;  // multiplies h1^3*p21*p22^3*h2*k2/(h1^3*h2^3)
    gradient[2] = p11 * p12_3 / h1_2 * c_0 + p11 * p12_3 * g / h1_3 * c_1;  // by m1
    gradient[3] = m1 * p12_3 / h1_2 * c_0 + m1 * p12_3 * g / h1_3 * c_1 + p12_3 * m2 / h2_2 * c_2
        + p12_3 * m2 * g / h2_3 * c_3 + p12_3 * k2 / h2_2 * c_4 + p12_3 * m2 / (h1 * h2) * c_5
        + p12_3 * m2 / h1_2 * c_6 + p12_3 * k1 / h1_2 * c_7 + p12_3 * m2 * g / h1_3 * c_8
        + p12_2 * m2 * p22 / h2_2 * c_9 + p12_2 * m2 * p22 * g / h2_3 * c_10 + p12_2 * p22 * k2 / h2_2 * c_11
        + p12_2 * m2 * p22 / (h1 * h2) * c_12 + p12 * m2 * p22_2 / h2_2 * c_13 + p12 * m2 * p22_2 * g / h2_3 * c_14
        + p12 * p22_2 * k2 / h2_2 * c_15 + p12 * m2 * p22_2 / (h1 * h2) * c_16 + m2 * p22_3 / h2_2 * c_17
        + m2 * p22_3 * g / h2_3 * c_18 + p22_3 * k2 / h2_2 * c_19;
    gradient[4] = 3.0 * m1 * p11 * p12_2 / h1_2 * c_0 + 3.0 * m1 * p11 * p12_2 * g / h1_3 * c_1
        + 3.0 * p11 * p12_2 * m2 / h2_2 * c_2 + 3.0 * p11 * p12_2 * m2 * g / h2_3 * c_3
        + 3.0 * p11 * p12_2 * k2 / h2_2 * c_4 + 3.0 * p11 * p12_2 * m2 / (h1 * h2) * c_5
        + 3.0 * p11 * p12_2 * m2 / h1_2 * c_6 + 3.0 * p11 * p12_2 * k1 / h1_2 * c_7
        + 3.0 * p11 * p12_2 * m2 * g / h1_3 * c_8 + 2.0 * p11 * p12 * m2 * p22 / h2_2 * c_9
        + 2.0 * p11 * p12 * m2 * p22 * g / h2_3 * c_10 + 2.0 * p11 * p12 * p22 * k2 / h2_2 * c_11
        + 2.0 * p11 * p12 * m2 * p22 / (h1 * h2) * c_12 + p11 * m2 * p22_2 / h2_2 * c_13
        + p11 * m2 * p22_2 * g / h2_3 * c_14 + p11 * p22_2 * k2 / h2_2 * c_15 + p11 * m2 * p22_2 / (h1 * h2) * c_16
        + 3.0 * p12_2 * m2 * p21 / h2_2 * c_20 + 3.0 * p12_2 * m2 * p21 * g / h2_3 * c_21
        + 3.0 * p12_2 * p21 * k2 / h2_2 * c_22 + 3.0 * p12_2 * m2 * p21 / (h1 * h2) * c_23
        + 2.0 * p12 * m2 * p21 * p22 / h2_2 * c_24 + 2.0 * p12 * m2 * p21 * p22 * g / h2_3 * c_25
        + 2.0 * p12 * p21 * p22 * k2 / h2_2 * c_26 + 2.0 * p12 * m2 * p21 * p22 / (h1 * h2) * c_27
        + m2 * p21 * p22_2 / h2_2 * c_28 + m2 * p21 * p22_2 * g / h2_3 * c_29 + p21 * p22_2 * k2 / h2_2 * c_30;
    gradient[5] = -2.0 * m1 * p11 * p12_3 / h1_3 * c_0 - 3.0 * m1 * p11 * p12_3 * g / h1_4 * c_1
        - p11 * p12_3 * m2 / (h1_2 * h2) * c_5 - 2.0 * p11 * p12_3 * m2 / h1_3 * c_6
        - 2.0 * p11 * p12_3 * k1 / h1_3 * c_7 - 3.0 * p11 * p12_3 * m2 * g / h1_4 * c_8
        - p11 * p12_2 * m2 * p22 / (h1_2 * h2) * c_12 - p11 * p12 * m2 * p22_2 / (h1_2 * h2) * c_16
        - p12_3 * m2 * p21 / (h1_2 * h2) * c_23 - p12_2 * m2 * p21 * p22 / (h1_2 * h2) * c_27;
    gradient[6] = p11 * p12_3 / h2_2 * c_2 + p11 * p12_3 * g / h2_3 * c_3 + p11 * p12_3 / (h1 * h2) * c_5
        + p11 * p12_3 / h1_2 * c_6 + p11 * p12_3 * g / h1_3 * c_8 + p11 * p12_2 * p22 / h2_2 * c_9
        + p11 * p12_2 * p22 * g / h2_3 * c_10 + p11 * p12_2 * p22 / (h1 * h2) * c_12
        + p11 * p12 * p22_2 / h2_2 * c_13 + p11 * p12 * p22_2 * g / h2_3 * c_14
        + p11 * p12 * p22_2 / (h1 * h2) * c_16 + p11 * p22_3 / h2_2 * c_17 + p11 * p22_3 * g / h2_3 * c_18
        + p12_3 * p21 / h2_2 * c_20 + p12_3 * p21 * g / h2_3 * c_21 + p12_3 * p21 / (h1 * h2) * c_23
        + p12_2 * p21 * p22 / h2_2 * c_24 + p12_2 * p21 * p22 * g / h2_3 * c_25
        + p12_2 * p21 * p22 / (h1 * h2) * c_27 + p12 * p21 * p22_2 / h2_2 * c_28
        + p12 * p21 * p22_2 * g / h2_3 * c_29 + p21 * p22_3 / h2_2 * c_31 + p21 * p22_3 * g / h2_3 * c_32;
    gradient[7] = p12_3 * m2 / h2_2 * c_20 + p12_3 * m2 * g / h2_3 * c_21 + p12_3 * k2 / h2_2 * c_22
        + p12_3 * m2 / (h1 * h2) * c_23 + p12_2 * m2 * p22 / h2_2 * c_24 + p12_2 * m2 * p22 * g / h2_3 * c_25
        + p12_2 * p22 * k2 / h2_2 * c_26 + p12_2 * m2 * p22 / (h1 * h2) * c_27 + p12 * m2 * p22_2 / h2_2 * c_28
        + p12 * m2 * p22_2 * g / h2_3 * c_29 + p12 * p22_2 * k2 / h2_2 * c_30 + m2 * p22_3 / h2_2 * c_31
        + m2 * p22_3 * g / h2_3 * c_32 + p22_3 * k2 / h2_2 * c_33;
    gradient[8] = p11 * p12_2 * m2 / h2_2 * c_9 + p11 * p12_2 * m2 * g / h2_3 * c_10
        + p11 * p12_2 * k2 / h2_2 * c_11 + p11 * p12_2 * m2 / (h1 * h2) * c_12
        + 2.0 * p11 * p12 * m2 * p22 / h2_2 * c_13 + 2.0 * p11 * p12 * m2 * p22 * g / h2_3 * c_14
        + 2.0 * p11 * p12 * p22 * k2 / h2_2 * c_15 + 2.0 * p11 * p12 * m2 * p22 / (h1 * h2) * c_16
        + 3.0 * p11 * m2 * p22_2 / h2_2 * c_17 + 3.0 * p11 * m2 * p22_2 * g / h2_3 * c_18
        + 3.0 * p11 * p22_2 * k2 / h2_2 * c_19 + p12_2 * m2 * p21 / h2_2 * c_24 + p12_2 * m2 * p21 * g / h2_3 * c_25
        + p12_2 * p21 * k2 / h2_2 * c_26 + p12_2 * m2 * p21 / (h1 * h2) * c_27
        + 2.0 * p12 * m2 * p21 * p22 / h2_2 * c_28 + 2.0 * p12 * m2 * p21 * p22 * g / h2_3 * c_29
        + 2.0 * p12 * p21 * p22 * k2 / h2_2 * c_30 + 3.0 * m2 * p21 * p22_2 / h2_2 * c_31
        + 3.0 * m2 * p21 * p22_2 * g / h2_3 * c_32 + 3.0 * p21 * p22_2 * k2 / h2_2 * c_33;
    gradient[9] = -2.0 * p11 * p12_3 * m2 / h2_3 * c_2 - 3.0 * p11 * p12_3 * m2 * g / h2_4 * c_3
        - 2.0 * p11 * p12_3 * k2 / h2_3 * c_4 - p11 * p12_3 * m2 / (h1 * h2_2) * c_5
        - 2.0 * p11 * p12_2 * m2 * p22 / h2_3 * c_9 - 3.0 * p11 * p12_2 * m2 * p22 * g / h2_4 * c_10
        - 2.0 * p11 * p12_2 * p22 * k2 / h2_3 * c_11 - p11 * p12_2 * m2 * p22 / (h1 * h2_2) * c_12
        - 2.0 * p11 * p12 * m2 * p22_2 / h2_3 * c_13 - 3.0 * p11 * p12 * m2 * p22_2 * g / h2_4 * c_14
        - 2.0 * p11 * p12 * p22_2 * k2 / h2_3 * c_15 - p11 * p12 * m2 * p22_2 / (h1 * h2_2) * c_16
        - 2.0 * p11 * m2 * p22_3 / h2_3 * c_17 - 3.0 * p11 * m2 * p22_3 * g / h2_4 * c_18
        - 2.0 * p11 * p22_3 * k2 / h2_3 * c_19 - 2.0 * p12_3 * m2 * p21 / h2_3 * c_20
        - 3.0 * p12_3 * m2 * p21 * g / h2_4 * c_21 - 2.0 * p12_3 * p21 * k2 / h2_3 * c_22
        - p12_3 * m2 * p21 / (h1 * h2_2) * c_23 - 2.0 * p12_2 * m2 * p21 * p22 / h2_3 * c_24
        - 3.0 * p12_2 * m2 * p21 * p22 * g / h2_4 * c_25 - 2.0 * p12_2 * p21 * p22 * k2 / h2_3 * c_26
        - p12_2 * m2 * p21 * p22 / (h1 * h2_2) * c_27 - 2.0 * p12 * m2 * p21 * p22_2 / h2_3 * c_28
        - 3.0 * p12 * m2 * p21 * p22_2 * g / h2_4 * c_29 - 2.0 * p12 * p21 * p22_2 * k2 / h2_3 * c_30
        - 2.0 * m2 * p21 * p22_3 / h2_3 * c_31 - 3.0 * m2 * p21 * p22_3 * g / h2_4 * c_32
        - 2.0 * p21 * p22_3 * k2 / h2_3 * c_33;
    gradient[10] = p11 * p12_3 / h1_2 * c_7;  // by k1
    gradient[11] = p11 * p12_3 / h2_2 * c_4 + p11 * p12_2 * p22 / h2_2 * c_11 + p11 * p12 * p22_2 / h2_2 * c_15
        + p11 * p22_3 / h2_2 * c_19 + p12_3 * p21 / h2_2 * c_22 + p12_2 * p21 * p22 / h2_2 * c_26
        + p12 * p21 * p22_2 / h2_2 * c_30 + p21 * p22_3 / h2_2 * c_33;
    gradient[12] = m1 * p11 * p12_3 / h1_3 * c_1 + p11 * p12_3 * m2 / h2_3 * c_3 + p11 * p12_3 * m2 / h1_3 * c_8
        + p11 * p12_2 * m2 * p22 / h2_3 * c_10 + p11 * p12 * m2 * p22_2 / h2_3 * c_14
        + p11 * m2 * p22_3 / h2_3 * c_18 + p12_3 * m2 * p21 / h2_3 * c_21 + p12_2 * m2 * p21 * p22 / h2_3 * c_25
        + p12 * m2 * p21 * p22_2 / h2_3 * c_29 + m2 * p21 * p22_3 / h2_3 * c_32;
  }
  void lump_harmonic_re_v2_A_v12_A_v2([[maybe_unused]] double* gradient) const {
    const double f_1 = -18.0 * omega2 * p11 * p12 * m2 * p21 * p22 / (25.0 * omega1 * h1 * h2);
    const double f_2 = (-27.0 * omega1 * m1 * p11_2 * p12_2 * h2_2 - 27.0 * omega1 * p11_2 * p12_2 * h1_2 * m2
        - 54.0 * omega1 * p11_2 * p12_2 * h1 * m2 * h2 - 27.0 * omega1 * p11_2 * p12_2 * m2 * h2_2
        + 54.0 * omega1 * p11_2 * p12 * h1_2 * m2 * p22 + 54.0 * omega1 * p11_2 * p12 * h1 * m2 * p22 * h2
        - 27.0 * omega1 * p11_2 * h1_2 * m2 * p22_2 - 18.0 * omega1 * p11_2 * h1 * m2 * p22_2 * h2
        + 54.0 * omega1 * p11 * p12_2 * h1_2 * m2 * p21 + 54.0 * omega1 * p11 * p12_2 * h1 * m2 * p21 * h2
        - 108.0 * omega1 * p11 * p12 * h1_2 * m2 * p21 * p22 + 54.0 * omega1 * p11 * h1_2 * m2 * p21 * p22_2
        - 27.0 * omega1 * p12_2 * h1_2 * m2 * p21_2 - 18.0 * omega1 * p12_2 * h1 * m2 * p21_2 * h2
        + 54.0 * omega1 * p12 * h1_2 * m2 * p21_2 * p22
        - 27.0 * omega1 * h1_2 * m2 * p21_2 * p22_2) * per_2 / (25.0 * h1_2 * h2_2);
    const double f_3 = (-18.0 * omega2 * m1 * p11_2 * p12_2 * h2_2 - 18.0 * omega2 * p11_2 * p12_2 * h1_2 * m2
        - 36.0 * omega2 * p11_2 * p12_2 * h1 * m2 * h2 - 18.0 * omega2 * p11_2 * p12_2 * m2 * h2_2
        + 36.0 * omega2 * p11_2 * p12 * h1_2 * m2 * p22 + 36.0 * omega2 * p11_2 * p12 * h1 * m2 * p22 * h2
        - 18.0 * omega2 * p11_2 * h1_2 * m2 * p22_2 + 36.0 * omega2 * p11 * p12_2 * h1_2 * m2 * p21
        + 36.0 * omega2 * p11 * p12_2 * h1 * m2 * p21 * h2 - 72.0 * omega2 * p11 * p12 * h1_2 * m2 * p21 * p22
        + 36.0 * omega2 * p11 * h1_2 * m2 * p21 * p22_2 - 18.0 * omega2 * p12_2 * h1_2 * m2 * p21_2
        + 36.0 * omega2 * p12 * h1_2 * m2 * p21_2 * p22
        - 18.0 * omega2 * h1_2 * m2 * p21_2 * p22_2) * per_2 / (25.0 * h1_2 * h2_2);
    const double f_4 = (-9.0 * omega2_2 * m1 * p11_2 * p12_2 * h2_2 - 9.0 * omega2_2 * p11_2 * p12_2 * h1_2 * m2
        - 18.0 * omega2_2 * p11_2 * p12_2 * h1 * m2 * h2 - 9.0 * omega2_2 * p11_2 * p12_2 * m2 * h2_2
        + 18.0 * omega2_2 * p11_2 * p12 * h1_2 * m2 * p22 + 18.0 * omega2_2 * p11_2 * p12 * h1 * m2 * p22 * h2
        - 9.0 * omega2_2 * p11_2 * h1_2 * m2 * p22_2 + 18.0 * omega2_2 * p11 * p12_2 * h1_2 * m2 * p21
        + 18.0 * omega2_2 * p11 * p12_2 * h1 * m2 * p21 * h2 - 36.0 * omega2_2 * p11 * p12 * h1_2 * m2 * p21 * p22
        + 18.0 * omega2_2 * p11 * h1_2 * m2 * p21 * p22_2 - 9.0 * omega2_2 * p12_2 * h1_2 * m2 * p21_2
        + 18.0 * omega2_2 * p12 * h1_2 * m2 * p21_2 * p22
        - 9.0 * omega2_2 * h1_2 * m2 * p21_2 * p22_2) * per_2 / (25.0 * omega1 * h1_2 * h2_2);
    const double f_5 = (-27.0 * m1 * p11_2 * p12_2 * h2_3 * g - 27.0 * p11_2 * p12_2 * h1_3 * m2 * g
        + 27.0 * p11_2 * p12_2 * h1_3 * h2 * k2 + 27.0 * p11_2 * p12_2 * h1 * h2_3 * k1
        - 27.0 * p11_2 * p12_2 * m2 * h2_3 * g + 54.0 * p11_2 * p12 * h1_3 * m2 * p22 * g
        - 54.0 * p11_2 * p12 * h1_3 * p22 * h2 * k2 - 27.0 * p11_2 * h1_3 * m2 * p22_2 * g
        + 27.0 * p11_2 * h1_3 * p22_2 * h2 * k2 + 54.0 * p11 * p12_2 * h1_3 * m2 * p21 * g
        - 54.0 * p11 * p12_2 * h1_3 * p21 * h2 * k2 - 108.0 * p11 * p12 * h1_3 * m2 * p21 * p22 * g
        + 108.0 * p11 * p12 * h1_3 * p21 * p22 * h2 * k2 + 54.0 * p11 * h1_3 * m2 * p21 * p22_2 * g
        - 54.0 * p11 * h1_3 * p21 * p22_2 * h2 * k2 - 27.0 * p12_2 * h1_3 * m2 * p21_2 * g
        + 27.0 * p12_2 * h1_3 * p21_2 * h2 * k2 + 54.0 * p12 * h1_3 * m2 * p21_2 * p22 * g
        - 54.0 * p12 * h1_3 * p21_2 * p22 * h2 * k2 - 27.0 * h1_3 * m2 * p21_2 * p22_2 * g
        + 27.0 * h1_3 * p21_2 * p22_2 * h2 * k2) * per_2 / (35.0 * omega1 * h1_3 * h2_3);
    const double q_2 = (f_2 + f_3 + f_4 + f_5) * per_2;
    gradient[0] = (-f_1 + f_2 - f_4 - f_5) / omega1 - q_2;  // by omega1
    gradient[1] = (f_1 + f_3 + 2.0 * f_4) / omega2 - q_2;  // by omega2
    const double c_0 = (-27.0 * omega1_2 - 18.0 * omega1 * omega2 - 9.0 * omega2_2) * per_2 / (25.0 * omega1);
    const double c_1 = -27.0 * per_2 / (35.0 * omega1);  // multiplies m1*p11^2*p12^2*h2^3*g/(h1^3*h2^3)
    const double c_2 = (-27.0 * omega1_2 - 18.0 * omega1 * omega2 - 9.0 * omega2_2) * per_2 / (25.0 * omega1);
    const double c_3 = -27.0 * per_2 / (35.0 * omega1);  // multiplies p11^2*p12^2*h1^3*m2*g/(h1^3*h2^3)
    const double c_4 = 27.0 * per_2 / (35.0 * omega1);  // multiplies p11^2*p12^2*h1^3*h2*k2/(h1^3*h2^3)
    const double c_5 = (-54.0 * omega1_2 - 36.0 * omega1 * omega2 - 18.0 * omega2_2) * per_2 / (25.0 * omega1);
    const double c_6 = (-27.0 * omega1_2 - 18.0 * omega1 * omega2 - 9.0 * omega2_2) * per_2 / (25.0 * omega1);
    const double c_7 = 27.0 * per_2 / (35.0 * omega1);  // multiplies p11^2*p12^2*h1*h2^3*k1/(h1^3*h2^3)
    const double c_8 = -27.0 * per_2 / (35.0 * omega1);  // multiplies p11^2*p12^2*m2*h2^3*g/(h1^3*h2^3)
    const double c_9 = (54.0 * omega1_2 + 36.0 * omega1 * omega2 + 18.0 * omega2_2) * per_2 / (25.0 * omega1);
    const double c_10 = 54.0 * per_2 / (35.0 * omega1);  // multiplies p11^2*p12*h1^3*m2*p22*g/(h1^3*h2^3)
    const double c_11 = -54.0 * per_2 / (35.0 * omega1);  // multiplies p11^2*p12*h1^3*p22*h2*k2/(h1^3*h2^3)
    const double c_12 = (54.0 * omega1_2 + 36.0 * omega1 * omega2 + 18.0 * omega2_2) * per_2 / (25.0 * omega1);
    const double c_13 = (-27.0 * omega1_2 - 18.0 * omega1 * omega2 - 9.0 * omega2_2) * per_2 / (25.0 * omega1);
    const double c_14 = -27.0 * per_2 / (35.0 * omega1);  // multiplies p11^2*h1^3*m2*p22^2*g/(h1^3*h2^3)
    const double c_15 = 27.0 * per_2 / (35.0 * omega1);  // multiplies p11^2*h1^3*p22^2*h2*k2/(h1^3*h2^3)
    const double c_16 = -18.0 * omega1 * per_2 / 25.0;  // multiplies p11^2*h1^2*m2*p22^2*h2^2/(h1^3*h2^3)
    const double c_17 = (54.0 * omega1_2 + 36.0 * omega1 * omega2 + 18.0 * omega2_2) * per_2 / (25.0 * omega1);
    const double c_18 = 54.0 * per_2 / (35.0 * omega1);  // multiplies p11*p12^2*h1^3*m2*p21*g/(h1^3*h2^3)
    const double c_19 = -54.0 * per_2 / (35.0 * omega1);  // multiplies p11*p12^2*h1^3*p21*h2*k2/(h1^3*h2^3)
    const double c_20 = (54.0 * omega1_2 + 36.0 * omega1 * omega2 + 18.0 * omega2_2) * per_2 / (25.0 * omega1);
    const double c_21 = (-108.0 * omega1_2 - 72.0 * omega1 * omega2 - 36.0 * omega2_2) * per_2 / (25.0 * omega1);
    const double c_22 = -108.0 * per_2 / (35.0 * omega1);  // multiplies p11*p12*h1^3*m2*p21*p22*g/(h1^3*h2^3)
    const double c_23 = 108.0 * per_2 / (35.0 * omega1);  // multiplies p11*p12*h1^3*p21*p22*h2*k2/(h1^3*h2^3)
    const double c_24 = (-18.0 * omega1 - 18.0 * omega2) / (25.0 * omega1);
    const double c_25 = (54.0 * omega1_2 + 36.0 * omega1 * omega2 + 18.0 * omega2_2) * per_2 / (25.0 * omega1);
    const double c_26 = 54.0 * per_2 / (35.0 * omega1);  // multiplies p11*h1^3*m2*p21*p22^2*g/(h1^3*h2^3)
    const double c_27 = -54.0 * per_2 / (35.0 * omega1);  // multiplies p11*h1^3*p21*p22^2*h2*k2/(h1^3*h2^3)
    const double c_28 = (-27.0 * omega1_2 - 18.0 * omega1 * omega2 - 9.0 * omega2_2) * per_2 / (25.0 * omega1);
    const double c_29 = -27.0 * per_2 / (35.0 * omega1);  // multiplies p12^2*h1^3*m2*p21^2*g/(h1^3*h2^3)
    const double c_30 = 27.0 * per_2 / (35.0 * omega1);  // multiplies p12^2*h1^3*p21^2*h2*k2/(h1^3*h2^3)
    const double c_31 = -18.0 * omega1 * per_2 / 25.0;  // multiplies p12^2*h1^2*m2*p21^2*h2^2/(h1^3*h2^3)
    const double c_32 = (54.0 * omega1_2 + 36.0 * omega1 * omega2 + 18.0 * omega2_2) * per_2 / (25.0 * omega1);
    const double c_33 = 54.0 * per_2 / (35.0 * omega1);  // multiplies p12*h1^3*m2*p21^2*p22*g/(h1^3*h2^3)
    const double c_34 = -54.0 * per_2 / (35.0 * omega1);  // multiplies p12*h1^3*p21^2*p22*h2*k2/(h1^3*h2^3)
    const double c_35 = (-27.0 * omega1_2 - 18.0 * omega1 * omega2 - 9.0 * omega2_2) * per_2 / (25.0 * omega1);
    const double c_36 = -27.0 * per_2 / (35.0 * omega1);  // multiplies h1^3*m2*p21^2*p22^2*g/(h1^3*h2^3)
    const double c_37 = 27.0 * per_2 / (35.0 * omega1);  // multiplies h1^3*p21^2*p22^2*h2*k2/(h1^3*h2^3)
    gradient[2] = p11_2 * p12_2 / h1_2 * c_0 + p11_2 * p12_2 * g / h1_3 * c_1;  // by m1
    gradient[3] = 2.0 * m1 * p11 * p12_2 / h1_2 * c_0 + 2.0 * m1 * p11 * p12_2 * g / h1_3 * c_1
        + 2.0 * p11 * p12_2 * m2 / h2_2 * c_2 + 2.0 * p11 * p12_2 * m2 * g / h2_3 * c_3
        + 2.0 * p11 * p12_2 * k2 / h2_2 * c_4 + 2.0 * p11 * p12_2 * m2 / (h1 * h2) * c_5
        + 2.0 * p11 * p12_2 * m2 / h1_2 * c_6 + 2.0 * p11 * p12_2 * k1 / h1_2 * c_7
        + 2.0 * p11 * p12_2 * m2 * g / h1_3 * c_8 + 2.0 * p11 * p12 * m2 * p22 / h2_2 * c_9
        + 2.0 * p11 * p12 * m2 * p22 * g / h2_3 * c_10 + 2.0 * p11 * p12 * p22 * k2 / h2_2 * c_11
        + 2.0 * p11 * p12 * m2 * p22 / (h1 * h2) * c_12 + 2.0 * p11 * m2 * p22_2 / h2_2 * c_13
        + 2.0 * p11 * m2 * p22_2 * g / h2_3 * c_14 + 2.0 * p11 * p22_2 * k2 / h2_2 * c_15
        + 2.0 * p11 * m2 * p22_2 / (h1 * h2) * c_16 + p12_2 * m2 * p21 / h2_2 * c_17
        + p12_2 * m2 * p21 * g / h2_3 * c_18 + p12_2 * p21 * k2 / h2_2 * c_19 + p12_2 * m2 * p21 / (h1 * h2) * c_20
        + p12 * m2 * p21 * p22 / h2_2 * c_21 + p12 * m2 * p21 * p22 * g / h2_3 * c_22
        + p12 * p21 * p22 * k2 / h2_2 * c_23 + p12 * m2 * p21 * p22 / (h1 * h2) * c_24
        + m2 * p21 * p22_2 / h2_2 * c_25 + m2 * p21 * p22_2 * g / h2_3 * c_26 + p21 * p22_2 * k2 / h2_2 * c_27;
    gradient[4] = 2.0 * m1 * p11_2 * p12 / h1_2 * c_0 + 2.0 * m1 * p11_2 * p12 * g / h1_3 * c_1
        + 2.0 * p11_2 * p12 * m2 / h2_2 * c_2 + 2.0 * p11_2 * p12 * m2 * g / h2_3 * c_3
        + 2.0 * p11_2 * p12 * k2 / h2_2 * c_4 + 2.0 * p11_2 * p12 * m2 / (h1 * h2) * c_5
        + 2.0 * p11_2 * p12 * m2 / h1_2 * c_6 + 2.0 * p11_2 * p12 * k1 / h1_2 * c_7
        + 2.0 * p11_2 * p12 * m2 * g / h1_3 * c_8 + p11_2 * m2 * p22 / h2_2 * c_9
        + p11_2 * m2 * p22 * g / h2_3 * c_10 + p11_2 * p22 * k2 / h2_2 * c_11 + p11_2 * m2 * p22 / (h1 * h2) * c_12
        + 2.0 * p11 * p12 * m2 * p21 / h2_2 * c_17 + 2.0 * p11 * p12 * m2 * p21 * g / h2_3 * c_18
        + 2.0 * p11 * p12 * p21 * k2 / h2_2 * c_19 + 2.0 * p11 * p12 * m2 * p21 / (h1 * h2) * c_20
        + p11 * m2 * p21 * p22 / h2_2 * c_21 + p11 * m2 * p21 * p22 * g / h2_3 * c_22
        + p11 * p21 * p22 * k2 / h2_2 * c_23 + p11 * m2 * p21 * p22 / (h1 * h2) * c_24
        + 2.0 * p12 * m2 * p21_2 / h2_2 * c_28 + 2.0 * p12 * m2 * p21_2 * g / h2_3 * c_29
        + 2.0 * p12 * p21_2 * k2 / h2_2 * c_30 + 2.0 * p12 * m2 * p21_2 / (h1 * h2) * c_31
        + m2 * p21_2 * p22 / h2_2 * c_32 + m2 * p21_2 * p22 * g / h2_3 * c_33 + p21_2 * p22 * k2 / h2_2 * c_34;
    gradient[5] = -2.0 * m1 * p11_2 * p12_2 / h1_3 * c_0 - 3.0 * m1 * p11_2 * p12_2 * g / h1_4 * c_1
        - p11_2 * p12_2 * m2 / (h1_2 * h2) * c_5 - 2.0 * p11_2 * p12_2 * m2 / h1_3 * c_6
        - 2.0 * p11_2 * p12_2 * k1 / h1_3 * c_7 - 3.0 * p11_2 * p12_2 * m2 * g / h1_4 * c_8
        - p11_2 * p12 * m2 * p22 / (h1_2 * h2) * c_12 - p11_2 * m2 * p22_2 / (h1_2 * h2) * c_16
        - p11 * p12_2 * m2 * p21 / (h1_2 * h2) * c_20 - p11 * p12 * m2 * p21 * p22 / (h1_2 * h2) * c_24
        - p12_2 * m2 * p21_2 / (h1_2 * h2) * c_31;
    gradient[6] = p11_2 * p12_2 / h2_2 * c_2 + p11_2 * p12_2 * g / h2_3 * c_3 + p11_2 * p12_2 / (h1 * h2) * c_5
        + p11_2 * p12_2 / h1_2 * c_6 + p11_2 * p12_2 * g / h1_3 * c_8 + p11_2 * p12 * p22 / h2_2 * c_9
        + p11_2 * p12 * p22 * g / h2_3 * c_10 + p11_2 * p12 * p22 / (h1 * h2) * c_12 + p11_2 * p22_2 / h2_2 * c_13
        + p11_2 * p22_2 * g / h2_3 * c_14 + p11_2 * p22_2 / (h1 * h2) * c_16 + p11 * p12_2 * p21 / h2_2 * c_17
        + p11 * p12_2 * p21 * g / h2_3 * c_18 + p11 * p12_2 * p21 / (h1 * h2) * c_20
        + p11 * p12 * p21 * p22 / h2_2 * c_21 + p11 * p12 * p21 * p22 * g / h2_3 * c_22
        + p11 * p12 * p21 * p22 / (h1 * h2) * c_24 + p11 * p21 * p22_2 / h2_2 * c_25
        + p11 * p21 * p22_2 * g / h2_3 * c_26 + p12_2 * p21_2 / h2_2 * c_28 + p12_2 * p21_2 * g / h2_3 * c_29
        + p12_2 * p21_2 / (h1 * h2) * c_31 + p12 * p21_2 * p22 / h2_2 * c_32 + p12 * p21_2 * p22 * g / h2_3 * c_33
        + p21_2 * p22_2 / h2_2 * c_35 + p21_2 * p22_2 * g / h2_3 * c_36;
    gradient[7] = p11 * p12_2 * m2 / h2_2 * c_17 + p11 * p12_2 * m2 * g / h2_3 * c_18
        + p11 * p12_2 * k2 / h2_2 * c_19 + p11 * p12_2 * m2 / (h1 * h2) * c_20 + p11 * p12 * m2 * p22 / h2_2 * c_21
        + p11 * p12 * m2 * p22 * g / h2_3 * c_22 + p11 * p12 * p22 * k2 / h2_2 * c_23
        + p11 * p12 * m2 * p22 / (h1 * h2) * c_24 + p11 * m2 * p22_2 / h2_2 * c_25
        + p11 * m2 * p22_2 * g / h2_3 * c_26 + p11 * p22_2 * k2 / h2_2 * c_27 + 2.0 * p12_2 * m2 * p21 / h2_2 * c_28
        + 2.0 * p12_2 * m2 * p21 * g / h2_3 * c_29 + 2.0 * p12_2 * p21 * k2 / h2_2 * c_30
        + 2.0 * p12_2 * m2 * p21 / (h1 * h2) * c_31 + 2.0 * p12 * m2 * p21 * p22 / h2_2 * c_32
        + 2.0 * p12 * m2 * p21 * p22 * g / h2_3 * c_33 + 2.0 * p12 * p21 * p22 * k2 / h2_2 * c_34
        + 2.0 * m2 * p21 * p22_2 / h2_2 * c_35 + 2.0 * m2 * p21 * p22_2 * g / h2_3 * c_36
        + 2.0 * p21 * p22_2 * k2 / h2_2 * c_37;
    gradient[8] = p11_2 * p12 * m2 / h2_2 * c_9 + p11_2 * p12 * m2 * g / h2_3 * c_10
        + p11_2 * p12 * k2 / h2_2 * c_11 + p11_2 * p12 * m2 / (h1 * h2) * c_12
        + 2.0 * p11_2 * m2 * p22 / h2_2 * c_13 + 2.0 * p11_2 * m2 * p22 * g / h2_3 * c_14
        + 2.0 * p11_2 * p22 * k2 / h2_2 * c_15 + 2.0 * p11_2 * m2 * p22 / (h1 * h2) * c_16
        + p11 * p12 * m2 * p21 / h2_2 * c_21 + p11 * p12 * m2 * p21 * g / h2_3 * c_22
        + p11 * p12 * p21 * k2 / h2_2 * c_23 + p11 * p12 * m2 * p21 / (h1 * h2) * c_24
        + 2.0 * p11 * m2 * p21 * p22 / h2_2 * c_25 + 2.0 * p11 * m2 * p21 * p22 * g / h2_3 * c_26
        + 2.0 * p11 * p21 * p22 * k2 / h2_2 * c_27 + p12 * m2 * p21_2 / h2_2 * c_32
        + p12 * m2 * p21_2 * g / h2_3 * c_33 + p12 * p21_2 * k2 / h2_2 * c_34 + 2.0 * m2 * p21_2 * p22 / h2_2 * c_35
        + 2.0 * m2 * p21_2 * p22 * g / h2_3 * c_36 + 2.0 * p21_2 * p22 * k2 / h2_2 * c_37;
    gradient[9] = -2.0 * p11_2 * p12_2 * m2 / h2_3 * c_2 - 3.0 * p11_2 * p12_2 * m2 * g / h2_4 * c_3
        - 2.0 * p11_2 * p12_2 * k2 / h2_3 * c_4 - p11_2 * p12_2 * m2 / (h1 * h2_2) * c_5
        - 2.0 * p11_2 * p12 * m2 * p22 / h2_3 * c_9 - 3.0 * p11_2 * p12 * m2 * p22 * g / h2_4 * c_10
        - 2.0 * p11_2 * p12 * p22 * k2 / h2_3 * c_11 - p11_2 * p12 * m2 * p22 / (h1 * h2_2) * c_12
        - 2.0 * p11_2 * m2 * p22_2 / h2_3 * c_13 - 3.0 * p11_2 * m2 * p22_2 * g / h2_4 * c_14
        - 2.0 * p11_2 * p22_2 * k2 / h2_3 * c_15 - p11_2 * m2 * p22_2 / (h1 * h2_2) * c_16
        - 2.0 * p11 * p12_2 * m2 * p21 / h2_3 * c_17 - 3.0 * p11 * p12_2 * m2 * p21 * g / h2_4 * c_18
        - 2.0 * p11 * p12_2 * p21 * k2 / h2_3 * c_19 - p11 * p12_2 * m2 * p21 / (h1 * h2_2) * c_20
        - 2.0 * p11 * p12 * m2 * p21 * p22 / h2_3 * c_21 - 3.0 * p11 * p12 * m2 * p21 * p22 * g / h2_4 * c_22
        - 2.0 * p11 * p12 * p21 * p22 * k2 / h2_3 * c_23 - p11 * p12 * m2 * p21 * p22 / (h1 * h2_2) * c_24
        - 2.0 * p11 * m2 * p21 * p22_2 / h2_3 * c_25 - 3.0 * p11 * m2 * p21 * p22_2 * g / h2_4 * c_26
        - 2.0 * p11 * p21 * p22_2 * k2 / h2_3 * c_27 - 2.0 * p12_2 * m2 * p21_2 / h2_3 * c_28
        - 3.0 * p12_2 * m2 * p21_2 * g / h2_4 * c_29 - 2.0 * p12_2 * p21_2 * k2 / h2_3 * c_30
        - p12_2 * m2 * p21_2 / (h1 * h2_2) * c_31 - 2.0 * p12 * m2 * p21_2 * p22 / h2_3 * c_32
        - 3.0 * p12 * m2 * p21_2 * p22 * g / h2_4 * c_33 - 2.0 * p12 * p21_2 * p22 * k2 / h2_3 * c_34
        - 2.0 * m2 * p21_2 * p22_2 / h2_3 * c_35 - 3.0 * m2 * p21_2 * p22_2 * g / h2_4 * c_36
        - 2.0 * p21_2 * p22_2 * k2 / h2_3 * c_37;
    gradient[10] = p11_2 * p12_2 / h1_2 * c_7;  // by k1
    gradient[11] = p11_2 * p12_2 / h2_2 * c_4 + p11_2 * p12 * p22 / h2_2 * c_11 + p11_2 * p22_2 / h2_2 * c_15
        + p11 * p12_2 * p21 / h2_2 * c_19 + p11 * p12 * p21 * p22 / h2_2 * c_23 + p11 * p21 * p22_2 / h2_2 * c_27
        + p12_2 * p21_2 / h2_2 * c_30 + p12 * p21_2 * p22 / h2_2 * c_34 + p21_2 * p22_2 / h2_2 * c_37;
    gradient[12] = m1 * p11_2 * p12_2 / h1_3 * c_1 + p11_2 * p12_2 * m2 / h2_3 * c_3
        + p11_2 * p12_2 * m2 / h1_3 * c_8 + p11_2 * p12 * m2 * p22 / h2_3 * c_10 + p11_2 * m2 * p22_2 / h2_3 * c_14
        + p11 * p12_2 * m2 * p21 / h2_3 * c_18 + p11 * p12 * m2 * p21 * p22 / h2_3 * c_22
        + p11 * m2 * p21 * p22_2 / h2_3 * c_26 + p12_2 * m2 * p21_2 / h2_3 * c_29
        + p12 * m2 * p21_2 * p22 / h2_3 * c_33 + m2 * p21_2 * p22_2 / h2_3 * c_36;
  }
  void lump_harmonic_re_v2_A_v23([[maybe_unused]] double* gradient) const {
    gradient[1] = (9.0 * m1 * p12_4 * h2_3 * g + 9.0 * p12_4 * h1_3 * m2 * g - 9.0 * p12_4 * h1_3 * h2 * k2
        - 9.0 * p12_4 * h1 * h2_3 * k1 + 9.0 * p12_4 * m2 * h2_3 * g - 36.0 * p12_3 * h1_3 * m2 * p22 * g
        + 36.0 * p12_3 * h1_3 * p22 * h2 * k2 + 54.0 * p12_2 * h1_3 * m2 * p22_2 * g
        - 54.0 * p12_2 * h1_3 * p22_2 * h2 * k2 - 36.0 * p12 * h1_3 * m2 * p22_3 * g
        + 36.0 * p12 * h1_3 * p22_3 * h2 * k2 + 9.0 * h1_3 * m2 * p22_4 * g
        - 9.0 * h1_3 * p22_4 * h2 * k2) / (35.0 * omega2_3 * h1_3 * h2_3);
    gradient[2] = (-126.0 * omega2_2 * p12_4 * h1 - 45.0 * p12_4 * g) / (350.0 * omega2_2 * h1_3);  // by m1
    gradient[4] = (-252.0 * omega2_2 * m1 * p12_3 * h1 * h2_3 - 252.0 * omega2_2 * p12_3 * h1_3 * m2 * h2
        - 504.0 * omega2_2 * p12_3 * h1_2 * m2 * h2_2 - 252.0 * omega2_2 * p12_3 * h1 * m2 * h2_3
        + 756.0 * omega2_2 * p12_2 * h1_3 * m2 * p22 * h2 + 756.0 * omega2_2 * p12_2 * h1_2 * m2 * p22 * h2_2
        - 756.0 * omega2_2 * p12 * h1_3 * m2 * p22_2 * h2 - 252.0 * omega2_2 * p12 * h1_2 * m2 * p22_2 * h2_2
        + 252.0 * omega2_2 * h1_3 * m2 * p22_3 * h2 - 90.0 * m1 * p12_3 * h2_3 * g - 90.0 * p12_3 * h1_3 * m2 * g
        + 90.0 * p12_3 * h1_3 * h2 * k2 + 90.0 * p12_3 * h1 * h2_3 * k1 - 90.0 * p12_3 * m2 * h2_3 * g
        + 270.0 * p12_2 * h1_3 * m2 * p22 * g - 270.0 * p12_2 * h1_3 * p22 * h2 * k2
        - 270.0 * p12 * h1_3 * m2 * p22_2 * g + 270.0 * p12 * h1_3 * p22_2 * h2 * k2 + 90.0 * h1_3 * m2 * p22_3 * g
        - 90.0 * h1_3 * p22_3 * h2 * k2) / (175.0 * omega2_2 * h1_3 * h2_3);
    gradient[5] = (252.0 * omega2_2 * m1 * p12_4 * h1 * h2 + 252.0 * omega2_2 * p12_4 * h1_2 * m2
        + 252.0 * omega2_2 * p12_4 * h1 * m2 * h2 - 504.0 * omega2_2 * p12_3 * h1_2 * m2 * p22
        + 252.0 * omega2_2 * p12_2 * h1_2 * m2 * p22_2 + 135.0 * m1 * p12_4 * h2 * g - 90.0 * p12_4 * h1 * h2 * k1
        + 135.0 * p12_4 * m2 * h2 * g) / (350.0 * omega2_2 * h1_4 * h2);
    gradient[6] = (-126.0 * omega2_2 * p12_4 * h1_3 * h2 - 252.0 * omega2_2 * p12_4 * h1_2 * h2_2
        - 126.0 * omega2_2 * p12_4 * h1 * h2_3 + 504.0 * omega2_2 * p12_3 * h1_3 * p22 * h2
        + 504.0 * omega2_2 * p12_3 * h1_2 * p22 * h2_2 - 756.0 * omega2_2 * p12_2 * h1_3 * p22_2 * h2
        - 252.0 * omega2_2 * p12_2 * h1_2 * p22_2 * h2_2 + 504.0 * omega2_2 * p12 * h1_3 * p22_3 * h2
        - 126.0 * omega2_2 * h1_3 * p22_4 * h2 - 45.0 * p12_4 * h1_3 * g - 45.0 * p12_4 * h2_3 * g
        + 180.0 * p12_3 * h1_3 * p22 * g - 270.0 * p12_2 * h1_3 * p22_2 * g + 180.0 * p12 * h1_3 * p22_3 * g
        - 45.0 * h1_3 * p22_4 * g) / (350.0 * omega2_2 * h1_3 * h2_3);
    gradient[8] = (252.0 * omega2_2 * p12_3 * h1 * m2 * h2 + 252.0 * omega2_2 * p12_3 * m2 * h2_2
        - 756.0 * omega2_2 * p12_2 * h1 * m2 * p22 * h2 - 252.0 * omega2_2 * p12_2 * m2 * p22 * h2_2
        + 756.0 * omega2_2 * p12 * h1 * m2 * p22_2 * h2 - 252.0 * omega2_2 * h1 * m2 * p22_3 * h2
        + 90.0 * p12_3 * h1 * m2 * g - 90.0 * p12_3 * h1 * h2 * k2 - 270.0 * p12_2 * h1 * m2 * p22 * g
        + 270.0 * p12_2 * h1 * p22 * h2 * k2 + 270.0 * p12 * h1 * m2 * p22_2 * g
        - 270.0 * p12 * h1 * p22_2 * h2 * k2 - 90.0 * h1 * m2 * p22_3 * g
        + 90.0 * h1 * p22_3 * h2 * k2) / (175.0 * omega2_2 * h1 * h2_3);
    gradient[9] = (252.0 * omega2_2 * p12_4 * h1 * m2 * h2 + 252.0 * omega2_2 * p12_4 * m2 * h2_2
        - 1008.0 * omega2_2 * p12_3 * h1 * m2 * p22 * h2 - 504.0 * omega2_2 * p12_3 * m2 * p22 * h2_2
        + 1512.0 * omega2_2 * p12_2 * h1 * m2 * p22_2 * h2 + 252.0 * omega2_2 * p12_2 * m2 * p22_2 * h2_2
        - 1008.0 * omega2_2 * p12 * h1 * m2 * p22_3 * h2 + 252.0 * omega2_2 * h1 * m2 * p22_4 * h2
        + 135.0 * p12_4 * h1 * m2 * g - 90.0 * p12_4 * h1 * h2 * k2 - 540.0 * p12_3 * h1 * m2 * p22 * g
        + 360.0 * p12_3 * h1 * p22 * h2 * k2 + 810.0 * p12_2 * h1 * m2 * p22_2 * g
        - 540.0 * p12_2 * h1 * p22_2 * h2 * k2 - 540.0 * p12 * h1 * m2 * p22_3 * g
        + 360.0 * p12 * h1 * p22_3 * h2 * k2 + 135.0 * h1 * m2 * p22_4 * g
        - 90.0 * h1 * p22_4 * h2 * k2) / (350.0 * omega2_2 * h1 * h2_4);
    gradient[10] = 9.0 * p12_4 / (70.0 * omega2_2 * h1_2);  // by k1
    gradient[11] = (9.0 * p12_4 - 36.0 * p12_3 * p22 + 54.0 * p12_2 * p22_2 - 36.0 * p12 * p22_3
        + 9.0 * p22_4) / (70.0 * omega2_2 * h2_2);
    gradient[12] = (-9.0 * m1 * p12_4 * h2_3 - 9.0 * p12_4 * h1_3 * m2 - 9.0 * p12_4 * m2 * h2_3
        + 36.0 * p12_3 * h1_3 * m2 * p22 - 54.0 * p12_2 * h1_3 * m2 * p22_2 + 36.0 * p12 * h1_3 * m2 * p22_3
        - 9.0 * h1_3 * m2 * p22_4) / (70.0 * omega2_2 * h1_3 * h2_3);
  }
  void lump_harmonic_re_v2_A_v13([[maybe_unused]] double* gradient) const {
    const double f_0 = (-72.0 * omega1_2 * m1 * p11_3 * p12 * h2_2 - 72.0 * omega1_2 * p11_3 * p12 * h1_2 * m2
        - 144.0 * omega1_2 * p11_3 * p12 * h1 * m2 * h2 - 72.0 * omega1_2 * p11_3 * p12 * m2 * h2_2
        + 72.0 * omega1_2 * p11_3 * h1_2 * m2 * p22 + 72.0 * omega1_2 * p11_3 * h1 * m2 * p22 * h2
        + 216.0 * omega1_2 * p11_2 * p12 * h1_2 * m2 * p21 + 216.0 * omega1_2 * p11_2 * p12 * h1 * m2 * p21 * h2
        - 216.0 * omega1_2 * p11_2 * h1_2 * m2 * p21 * p22 - 72.0 * omega1_2 * p11_2 * h1 * m2 * p21 * p22 * h2
        - 216.0 * omega1_2 * p11 * p12 * h1_2 * m2 * p21_2 - 72.0 * omega1_2 * p11 * p12 * h1 * m2 * p21_2 * h2
        + 216.0 * omega1_2 * p11 * h1_2 * m2 * p21_2 * p22 + 72.0 * omega1_2 * p12 * h1_2 * m2 * p21_3
        - 72.0 * omega1_2 * h1_2 * m2 * p21_3 * p22) * over_6 / (25.0 * h1_2 * h2_2);
    const double f_1 = (-36.0 * m1 * p11_3 * p12 * h2_3 * g - 36.0 * p11_3 * p12 * h1_3 * m2 * g
        + 36.0 * p11_3 * p12 * h1_3 * h2 * k2 + 36.0 * p11_3 * p12 * h1 * h2_3 * k1
        - 36.0 * p11_3 * p12 * m2 * h2_3 * g + 36.0 * p11_3 * h1_3 * m2 * p22 * g
        - 36.0 * p11_3 * h1_3 * p22 * h2 * k2 + 108.0 * p11_2 * p12 * h1_3 * m2 * p21 * g
        - 108.0 * p11_2 * p12 * h1_3 * p21 * h2 * k2 - 108.0 * p11_2 * h1_3 * m2 * p21 * p22 * g
        + 108.0 * p11_2 * h1_3 * p21 * p22 * h2 * k2 - 108.0 * p11 * p12 * h1_3 * m2 * p21_2 * g
        + 108.0 * p11 * p12 * h1_3 * p21_2 * h2 * k2 + 108.0 * p11 * h1_3 * m2 * p21_2 * p22 * g
        - 108.0 * p11 * h1_3 * p21_2 * p22 * h2 * k2 + 36.0 * p12 * h1_3 * m2 * p21_3 * g
        - 36.0 * p12 * h1_3 * p21_3 * h2 * k2 - 36.0 * h1_3 * m2 * p21_3 * p22 * g
        + 36.0 * h1_3 * p21_3 * p22 * h2 * k2) * over_6 / (35.0 * h1_3 * h2_3);
    const double q_1 = (f_0 + f_1) * per_1;
    const double q_3 = (f_0 + f_1) * per_3;
    gradient[0] = 2.0 * f_0 / omega1 - 3.0 * q_1 - 3.0 * q_3;  // by omega1
    gradient[1] = q_1 - q_3;  // by omega2
    const double c_0 = -72.0 * omega1_2 * over_6 / 25.0;  // multiplies m1*p11^3*p12*h1*h2^3/(h1^3*h2^3)
    const double c_1 = -36.0 * over_6 / 35.0;  // multiplies m1*p11^3*p12*h2^3*g/(h1^3*h2^3)
    const double c_2 = -72.0 * omega1_2 * over_6 / 25.0;  // multiplies p11^3*p12*h1^3*m2*h2/(h1^3*h2^3)
    const double c_3 = -36.0 * over_6 / 35.0;  // multiplies p11^3*p12*h1^3*m2*g/(h1^3*h2^3)
    const double c_4 = 36.0 * over_6 / 35.0;  // multiplies p11^3*p12*h1^3*h2*k2/(h1^3*h2^3)
    const double c_5 = -144.0 * omega1_2 * over_6 / 25.0;  // multiplies p11^3*p12*h1^2*m2*h2^2/(h1^3*h2^3)
    const double c_6 = -72.0 * omega1_2 * over_6 / 25.0;  // multiplies p11^3*p12*h1*m2*h2^3/(h1^3*h2^3)
    const double c_7 = 36.0 * over_6 / 35.0;  // multiplies p11^3*p12*h1*h2^3*k1/(h1^3*h2^3)
    const double c_8 = -36.0 * over_6 / 35.0;  // multiplies p11^3*p12*m2*h2^3*g/(h1^3*h2^3)
    const double c_9 = 72.0 * omega1_2 * over_6 / 25.0;  // multiplies p11^3*h1^3*m2*p22*h2/(h1^3*h2^3)
    const double c_10 = 36.0 * over_6 / 35.0;  // multiplies p11^3*h1^3*m2*p22*g/(h1^3*h2^3)
    const double c_11 = -36.0 * over_6 / 35.0;  // multiplies p11^3*h1^3*p22*h2*k2/(h1^3*h2^3)
    const double c_12 = 72.0 * omega1_2 * over_6 / 25.0;  // multiplies p11^3*h1^2*m2*p22*h2^2/(h1^3*h2^3)
    const double c_13 = 216.0 * omega1_2 * over_6 / 25.0;  // multiplies p11^2*p12*h1^3*m2*p21*h2/(h1^3*h2^3)
    const double c_14 = 108.0 * over_6 / 35.0;  // multiplies p11^2*p12*h1^3*m2*p21*g/(h1^3*h2^3)
    const double c_15 = -108.0 * over_6 / 35.0;  // multiplies p11^2*p12*h1^3*p21*h2*k2/(h1^3*h2^3)
    const double c_16 = 216.0 * omega1_2 * over_6 / 25.0;  // multiplies p11^2*p12*h1^2*m2*p21*h2^2/(h1^3*h2^3)
    const double c_17 = -216.0 * omega1_2 * over_6 / 25.0;  // multiplies p11^2*h1^3*m2*p21*p22*h2/(h1^3*h2^3)
    const double c_18 = -108.0 * over_6 / 35.0;  // multiplies p11^2*h1^3*m2*p21*p22*g/(h1^3*h2^3)
    const double c_19 = 108.0 * over_6 / 35.0;  // multiplies p11^2*h1^3*p21*p22*h2*k2/(h1^3*h2^3)
    const double c_20 = -72.0 * omega1_2 * over_6 / 25.0;  // multiplies p11^2*h1^2*m2*p21*p22*h2^2/(h1^3*h2^3)
    const double c_21 = -216.0 * omega1_2 * over_6 / 25.0;  // multiplies p11*p12*h1^3*m2*p21^2*h2/(h1^3*h2^3)
    const double c_22 = -108.0 * over_6 / 35.0;  // multiplies p11*p12*h1^3*m2*p21^2*g/(h1^3*h2^3)
    const double c_23 = 108.0 * over_6 / 35.0;  // multiplies p11*p12*h1^3*p21^2*h2*k2/(h1^3*h2^3)
    const double c_24 = -72.0 * omega1_2 * over_6 / 25.0;  // multiplies p11*p12*h1^2*m2*p21^2*h2^2/(h1^3*h2^3)
    const double c_25 = 216.0 * omega1_2 * over_6 / 25.0;  // multiplies p11*h1^3*m2*p21^2*p22*h2/(h1^3*h2^3)
    const double c_26 = 108.0 * over_6 / 35.0;  // multiplies p11*h1^3*m2*p21^2*p22*g/(h1^3*h2^3)
    const double c_27 = -108.0 * over_6 / 35.0;  // multiplies p11*h1^3*p21^2*p22*h2*k2/(h1^3*h2^3)
    const double c_28 = 72.0 * omega1_2 * over_6 / 25.0;  // multiplies p12*h1^3*m2*p21^3*h2/(h1^3*h2^3)
    const double c_29 = 36.0 * over_6 / 35.0;  // multiplies p12*h1^3*m2*p21^3*g/(h1^3*h2^3)
    const double c_30 = -36.0 * over_6 / 35.0;  // multiplies p12*h1^3*p21^3*h2*k2/(h1^3*h2^3)
    const double c_31 = -72.0 * omega1_2 * over_6 / 25.0;  // multiplies h1^3*m2*p21^3*p22*h2/(h1^3*h2^3)
    const double c_32 = -36.0 * over_6 / 35.0;  // multiplies h1^3*m2*p21^3*p22*g/(h1^3*h2^3)
    const double c_33 = 36.0 * over_6 / 35.0;  // multiplies h1^3*p21^3*p22*h2*k2/(h1^3*h2^3)
    gradient[2] = p11_3 * p12 / h1_2 * c_0 + p11_3 * p12 * g / h1_3 * c_1;  // by m1
    gradient[3] = 3.0 * m1 * p11_2 * p12 / h1_2 * c_0 + 3.0 * m1 * p11_2 * p12 * g / h1_3 * c_1
        + 3.0 * p11_2 * p12 * m2 / h2_2 * c_2 + 3.0 * p11_2 * p12 * m2 * g / h2_3 * c_3
        + 3.0 * p11_2 * p12 * k2 / h2_2 * c_4 + 3.0 * p11_2 * p12 * m2 / (h1 * h2) * c_5
        + 3.0 * p11_2 * p12 * m2 / h1_2 * c_6 + 3.0 * p11_2 * p12 * k1 / h1_2 * c_7
        + 3.0 * p11_2 * p12 * m2 * g / h1_3 * c_8 + 3.0 * p11_2 * m2 * p22 / h2_2 * c_9
        + 3.0 * p11_2 * m2 * p22 * g / h2_3 * c_10 + 3.0 * p11_2 * p22 * k2 / h2_2 * c_11
        + 3.0 * p11_2 * m2 * p22 / (h1 * h2) * c_12 + 2.0 * p11 * p12 * m2 * p21 / h2_2 * c_13
        + 2.0 * p11 * p12 * m2 * p21 * g / h2_3 * c_14 + 2.0 * p11 * p12 * p21 * k2 / h2_2 * c_15
        + 2.0 * p11 * p12 * m2 * p21 / (h1 * h2) * c_16 + 2.0 * p11 * m2 * p21 * p22 / h2_2 * c_17
        + 2.0 * p11 * m2 * p21 * p22 * g / h2_3 * c_18 + 2.0 * p11 * p21 * p22 * k2 / h2_2 * c_19
        + 2.0 * p11 * m2 * p21 * p22 / (h1 * h2) * c_20 + p12 * m2 * p21_2 / h2_2 * c_21
        + p12 * m2 * p21_2 * g / h2_3 * c_22 + p12 * p21_2 * k2 / h2_2 * c_23 + p12 * m2 * p21_2 / (h1 * h2) * c_24
        + m2 * p21_2 * p22 / h2_2 * c_25 + m2 * p21_2 * p22 * g / h2_3 * c_26 + p21_2 * p22 * k2 / h2_2 * c_27;
    gradient[4] = m1 * p11_3 / h1_2 * c_0 + m1 * p11_3 * g / h1_3 * c_1 + p11_3 * m2 / h2_2 * c_2
        + p11_3 * m2 * g / h2_3 * c_3 + p11_3 * k2 / h2_2 * c_4 + p11_3 * m2 / (h1 * h2) * c_5
        + p11_3 * m2 / h1_2 * c_6 + p11_3 * k1 / h1_2 * c_7 + p11_3 * m2 * g / h1_3 * c_8
        + p11_2 * m2 * p21 / h2_2 * c_13 + p11_2 * m2 * p21 * g / h2_3 * c_14 + p11_2 * p21 * k2 / h2_2 * c_15
        + p11_2 * m2 * p21 / (h1 * h2) * c_16 + p11 * m2 * p21_2 / h2_2 * c_21 + p11 * m2 * p21_2 * g / h2_3 * c_22
        + p11 * p21_2 * k2 / h2_2 * c_23 + p11 * m2 * p21_2 / (h1 * h2) * c_24 + m2 * p21_3 / h2_2 * c_28
        + m2 * p21_3 * g / h2_3 * c_29 + p21_3 * k2 / h2_2 * c_30;
    gradient[5] = -2.0 * m1 * p11_3 * p12 / h1_3 * c_0 - 3.0 * m1 * p11_3 * p12 * g / h1_4 * c_1
        - p11_3 * p12 * m2 / (h1_2 * h2) * c_5 - 2.0 * p11_3 * p12 * m2 / h1_3 * c_6
        - 2.0 * p11_3 * p12 * k1 / h1_3 * c_7 - 3.0 * p11_3 * p12 * m2 * g / h1_4 * c_8
        - p11_3 * m2 * p22 / (h1_2 * h2) * c_12 - p11_2 * p12 * m2 * p21 / (h1_2 * h2) * c_16
        - p11_2 * m2 * p21 * p22 / (h1_2 * h2) * c_20 - p11 * p12 * m2 * p21_2 / (h1_2 * h2) * c_24;
    gradient[6] = p11_3 * p12 / h2_2 * c_2 + p11_3 * p12 * g / h2_3 * c_3 + p11_3 * p12 / (h1 * h2) * c_5
        + p11_3 * p12 / h1_2 * c_6 + p11_3 * p12 * g / h1_3 * c_8 + p11_3 * p22 / h2_2 * c_9
        + p11_3 * p22 * g / h2_3 * c_10 + p11_3 * p22 / (h1 * h2) * c_12 + p11_2 * p12 * p21 / h2_2 * c_13
        + p11_2 * p12 * p21 * g / h2_3 * c_14 + p11_2 * p12 * p21 / (h1 * h2) * c_16
        + p11_2 * p21 * p22 / h2_2 * c_17 + p11_2 * p21 * p22 * g / h2_3 * c_18
        + p11_2 * p21 * p22 / (h1 * h2) * c_20 + p11 * p12 * p21_2 / h2_2 * c_21
        + p11 * p12 * p21_2 * g / h2_3 * c_22 + p11 * p12 * p21_2 / (h1 * h2) * c_24
        + p11 * p21_2 * p22 / h2_2 * c_25 + p11 * p21_2 * p22 * g / h2_3 * c_26 + p12 * p21_3 / h2_2 * c_28
        + p12 * p21_3 * g / h2_3 * c_29 + p21_3 * p22 / h2_2 * c_31 + p21_3 * p22 * g / h2_3 * c_32;
    gradient[7] = p11_2 * p12 * m2 / h2_2 * c_13 + p11_2 * p12 * m2 * g / h2_3 * c_14
        + p11_2 * p12 * k2 / h2_2 * c_15 + p11_2 * p12 * m2 / (h1 * h2) * c_16 + p11_2 * m2 * p22 / h2_2 * c_17
        + p11_2 * m2 * p22 * g / h2_3 * c_18 + p11_2 * p22 * k2 / h2_2 * c_19 + p11_2 * m2 * p22 / (h1 * h2) * c_20
        + 2.0 * p11 * p12 * m2 * p21 / h2_2 * c_21 + 2.0 * p11 * p12 * m2 * p21 * g / h2_3 * c_22
        + 2.0 * p11 * p12 * p21 * k2 / h2_2 * c_23 + 2.0 * p11 * p12 * m2 * p21 / (h1 * h2) * c_24
        + 2.0 * p11 * m2 * p21 * p22 / h2_2 * c_25 + 2.0 * p11 * m2 * p21 * p22 * g / h2_3 * c_26
        + 2.0 * p11 * p21 * p22 * k2 / h2_2 * c_27 + 3.0 * p12 * m2 * p21_2 / h2_2 * c_28
        + 3.0 * p12 * m2 * p21_2 * g / h2_3 * c_29 + 3.0 * p12 * p21_2 * k2 / h2_2 * c_30
        + 3.0 * m2 * p21_2 * p22 / h2_2 * c_31 + 3.0 * m2 * p21_2 * p22 * g / h2_3 * c_32
        + 3.0 * p21_2 * p22 * k2 / h2_2 * c_33;
    gradient[8] = p11_3 * m2 / h2_2 * c_9 + p11_3 * m2 * g / h2_3 * c_10 + p11_3 * k2 / h2_2 * c_11
        + p11_3 * m2 / (h1 * h2) * c_12 + p11_2 * m2 * p21 / h2_2 * c_17 + p11_2 * m2 * p21 * g / h2_3 * c_18
        + p11_2 * p21 * k2 / h2_2 * c_19 + p11_2 * m2 * p21 / (h1 * h2) * c_20 + p11 * m2 * p21_2 / h2_2 * c_25
        + p11 * m2 * p21_2 * g / h2_3 * c_26 + p11 * p21_2 * k2 / h2_2 * c_27 + m2 * p21_3 / h2_2 * c_31
        + m2 * p21_3 * g / h2_3 * c_32 + p21_3 * k2 / h2_2 * c_33;
    gradient[9] = -2.0 * p11_3 * p12 * m2 / h2_3 * c_2 - 3.0 * p11_3 * p12 * m2 * g / h2_4 * c_3
        - 2.0 * p11_3 * p12 * k2 / h2_3 * c_4 - p11_3 * p12 * m2 / (h1 * h2_2) * c_5
        - 2.0 * p11_3 * m2 * p22 / h2_3 * c_9 - 3.0 * p11_3 * m2 * p22 * g / h2_4 * c_10
        - 2.0 * p11_3 * p22 * k2 / h2_3 * c_11 - p11_3 * m2 * p22 / (h1 * h2_2) * c_12
        - 2.0 * p11_2 * p12 * m2 * p21 / h2_3 * c_13 - 3.0 * p11_2 * p12 * m2 * p21 * g / h2_4 * c_14
        - 2.0 * p11_2 * p12 * p21 * k2 / h2_3 * c_15 - p11_2 * p12 * m2 * p21 / (h1 * h2_2) * c_16
        - 2.0 * p11_2 * m2 * p21 * p22 / h2_3 * c_17 - 3.0 * p11_2 * m2 * p21 * p22 * g / h2_4 * c_18
        - 2.0 * p11_2 * p21 * p22 * k2 / h2_3 * c_19 - p11_2 * m2 * p21 * p22 / (h1 * h2_2) * c_20
        - 2.0 * p11 * p12 * m2 * p21_2 / h2_3 * c_21 - 3.0 * p11 * p12 * m2 * p21_2 * g / h2_4 * c_22
        - 2.0 * p11 * p12 * p21_2 * k2 / h2_3 * c_23 - p11 * p12 * m2 * p21_2 / (h1 * h2_2) * c_24
        - 2.0 * p11 * m2 * p21_2 * p22 / h2_3 * c_25 - 3.0 * p11 * m2 * p21_2 * p22 * g / h2_4 * c_26
        - 2.0 * p11 * p21_2 * p22 * k2 / h2_3 * c_27 - 2.0 * p12 * m2 * p21_3 / h2_3 * c_28
        - 3.0 * p12 * m2 * p21_3 * g / h2_4 * c_29 - 2.0 * p12 * p21_3 * k2 / h2_3 * c_30
        - 2.0 * m2 * p21_3 * p22 / h2_3 * c_31 - 3.0 * m2 * p21_3 * p22 * g / h2_4 * c_32
        - 2.0 * p21_3 * p22 * k2 / h2_3 * c_33;
    gradient[10] = p11_3 * p12 / h1_2 * c_7;  // by k1
    gradient[11] = p11_3 * p12 / h2_2 * c_4 + p11_3 * p22 / h2_2 * c_11 + p11_2 * p12 * p21 / h2_2 * c_15
        + p11_2 * p21 * p22 / h2_2 * c_19 + p11 * p12 * p21_2 / h2_2 * c_23 + p11 * p21_2 * p22 / h2_2 * c_27
        + p12 * p21_3 / h2_2 * c_30 + p21_3 * p22 / h2_2 * c_33;
    gradient[12] = m1 * p11_3 * p12 / h1_3 * c_1 + p11_3 * p12 * m2 / h2_3 * c_3 + p11_3 * p12 * m2 / h1_3 * c_8
        + p11_3 * m2 * p22 / h2_3 * c_10 + p11_2 * p12 * m2 * p21 / h2_3 * c_14
        + p11_2 * m2 * p21 * p22 / h2_3 * c_18 + p11 * p12 * m2 * p21_2 / h2_3 * c_22
        + p11 * m2 * p21_2 * p22 / h2_3 * c_26 + p12 * m2 * p21_3 / h2_3 * c_29 + m2 * p21_3 * p22 / h2_3 * c_32;
  }
  void lump_harmonic_re_v2_A_v1_A_v22([[maybe_unused]] double* gradient) const {
    const double f_0 = (-36.0 * omega1_2 * m1 * p11 * p12_3 * h2_2 - 36.0 * omega1_2 * p11 * p12_3 * h1_2 * m2
        - 72.0 * omega1_2 * p11 * p12_3 * h1 * m2 * h2 - 36.0 * omega1_2 * p11 * p12_3 * m2 * h2_2
        + 108.0 * omega1_2 * p11 * p12_2 * h1_2 * m2 * p22 + 108.0 * omega1_2 * p11 * p12_2 * h1 * m2 * p22 * h2
        - 108.0 * omega1_2 * p11 * p12 * h1_2 * m2 * p22_2 - 36.0 * omega1_2 * p11 * p12 * h1 * m2 * p22_2 * h2
        + 36.0 * omega1_2 * p11 * h1_2 * m2 * p22_3 + 36.0 * omega1_2 * p12_3 * h1_2 * m2 * p21
        + 36.0 * omega1_2 * p12_3 * h1 * m2 * p21 * h2 - 108.0 * omega1_2 * p12_2 * h1_2 * m2 * p21 * p22
        - 36.0 * omega1_2 * p12_2 * h1 * m2 * p21 * p22 * h2 + 108.0 * omega1_2 * p12 * h1_2 * m2 * p21 * p22_2
        - 36.0 * omega1_2 * h1_2 * m2 * p21 * p22_3) * over_7 / (25.0 * h1_2 * h2_2);
    const double f_1 = (-72.0 * omega1 * omega2 * m1 * p11 * p12_3 * h2_2
        - 72.0 * omega1 * omega2 * p11 * p12_3 * h1_2 * m2 - 144.0 * omega1 * omega2 * p11 * p12_3 * h1 * m2 * h2
        - 72.0 * omega1 * omega2 * p11 * p12_3 * m2 * h2_2 + 216.0 * omega1 * omega2 * p11 * p12_2 * h1_2 * m2 * p22
        + 216.0 * omega1 * omega2 * p11 * p12_2 * h1 * m2 * p22 * h2
        - 216.0 * omega1 * omega2 * p11 * p12 * h1_2 * m2 * p22_2
        - 72.0 * omega1 * omega2 * p11 * p12 * h1 * m2 * p22_2 * h2
        + 72.0 * omega1 * omega2 * p11 * h1_2 * m2 * p22_3 + 72.0 * omega1 * omega2 * p12_3 * h1_2 * m2 * p21
        + 72.0 * omega1 * omega2 * p12_3 * h1 * m2 * p21 * h2
        - 216.0 * omega1 * omega2 * p12_2 * h1_2 * m2 * p21 * p22
        - 72.0 * omega1 * omega2 * p12_2 * h1 * m2 * p21 * p22 * h2
        + 216.0 * omega1 * omega2 * p12 * h1_2 * m2 * p21 * p22_2
        - 72.0 * omega1 * omega2 * h1_2 * m2 * p21 * p22_3) * over_7 / (25.0 * h1_2 * h2_2);
    const double f_2 = (-108.0 * omega2_2 * m1 * p11 * p12_3 * h2_2 - 108.0 * omega2_2 * p11 * p12_3 * h1_2 * m2
        - 216.0 * omega2_2 * p11 * p12_3 * h1 * m2 * h2 - 108.0 * omega2_2 * p11 * p12_3 * m2 * h2_2
        + 324.0 * omega2_2 * p11 * p12_2 * h1_2 * m2 * p22 + 324.0 * omega2_2 * p11 * p12_2 * h1 * m2 * p22 * h2
        - 324.0 * omega2_2 * p11 * p12 * h1_2 * m2 * p22_2 - 108.0 * omega2_2 * p11 * p12 * h1 * m2 * p22_2 * h2
        + 108.0 * omega2_2 * p11 * h1_2 * m2 * p22_3 + 108.0 * omega2_2 * p12_3 * h1_2 * m2 * p21
        + 108.0 * omega2_2 * p12_3 * h1 * m2 * p21 * h2 - 324.0 * omega2_2 * p12_2 * h1_2 * m2 * p21 * p22
        - 108.0 * omega2_2 * p12_2 * h1 * m2 * p21 * p22 * h2 + 324.0 * omega2_2 * p12 * h1_2 * m2 * p21 * p22_2
        - 108.0 * omega2_2 * h1_2 * m2 * p21 * p22_3) * over_7 / (25.0 * h1_2 * h2_2);
    const double f_3 = (-108.0 * m1 * p11 * p12_3 * h2_3 * g - 108.0 * p11 * p12_3 * h1_3 * m2 * g
        + 108.0 * p11 * p12_3 * h1_3 * h2 * k2 + 108.0 * p11 * p12_3 * h1 * h2_3 * k1
        - 108.0 * p11 * p12_3 * m2 * h2_3 * g + 324.0 * p11 * p12_2 * h1_3 * m2 * p22 * g
        - 324.0 * p11 * p12_2 * h1_3 * p22 * h2 * k2 - 324.0 * p11 * p12 * h1_3 * m2 * p22_2 * g
        + 324.0 * p11 * p12 * h1_3 * p22_2 * h2 * k2 + 108.0 * p11 * h1_3 * m2 * p22_3 * g
        - 108.0 * p11 * h1_3 * p22_3 * h2 * k2 + 108.0 * p12_3 * h1_3 * m2 * p21 * g
        - 108.0 * p12_3 * h1_3 * p21 * h2 * k2 - 324.0 * p12_2 * h1_3 * m2 * p21 * p22 * g
        + 324.0 * p12_2 * h1_3 * p21 * p22 * h2 * k2 + 324.0 * p12 * h1_3 * m2 * p21 * p22_2 * g
        - 324.0 * p12 * h1_3 * p21 * p22_2 * h2 * k2 - 108.0 * h1_3 * m2 * p21 * p22_3 * g
        + 108.0 * h1_3 * p21 * p22_3 * h2 * k2) * over_7 / (35.0 * h1_3 * h2_3);
    const double q_2 = (f_0 + f_1 + f_2 + f_3) * per_2;
    const double q_4 = (f_0 + f_1 + f_2 + f_3) * per_4;
    gradient[0] = (2.0 * f_0 + f_1) / omega1 - q_2 - q_4;  // by omega1
    gradient[1] = (f_1 + 2.0 * f_2) / omega2 - q_2 - 3.0 * q_4;  // by omega2
    const double c_0 = (-36.0 * omega1_2 - 72.0 * omega1 * omega2 - 108.0 * omega2_2) * over_7 / 25.0;
    const double c_1 = -108.0 * over_7 / 35.0;  // multiplies m1*p11*p12^3*h2^3*g/(h1^3*h2^3)
    const double c_2 = (-36.0 * omega1_2 - 72.0 * omega1 * omega2 - 108.0 * omega2_2) * over_7 / 25.0;
    const double c_3 = -108.0 * over_7 / 35.0;  // multiplies p11*p12^3*h1^3*m2*g/(h1^3*h2^3)
    const double c_4 = 108.0 * over_7 / 35.0;  // multiplies p11*p12^3*h1^3*h2*k2/(h1^3*h2^3)
    const double c_5 = (-72.0 * omega1_2 - 144.0 * omega1 * omega2 - 216.0 * omega2_2) * over_7 / 25.0;
    const double c_6 = (-36.0 * omega1_2 - 72.0 * omega1 * omega2 - 108.0 * omega2_2) * over_7 / 25.0;
    const double c_7 = 108.0 * over_7 / 35.0;  // multiplies p11*p12^3*h1*h2^3*k1/(h1^3*h2^3)
    const double c_8 = -108.0 * over_7 / 35.0;  // multiplies p11*p12^3*m2*h2^3*g/(h1^3*h2^3)
    const double c_9 = (108.0 * omega1_2 + 216.0 * omega1 * omega2 + 324.0 * omega2_2) * over_7 / 25.0;
    const double c_10 = 324.0 * over_7 / 35.0;  // multiplies p11*p12^2*h1^3*m2*p22*g/(h1^3*h2^3)
    const double c_11 = -324.0 * over_7 / 35.0;  // multiplies p11*p12^2*h1^3*p22*h2*k2/(h1^3*h2^3)
    const double c_12 = (108.0 * omega1_2 + 216.0 * omega1 * omega2 + 324.0 * omega2_2) * over_7 / 25.0;
    const double c_13 = (-108.0 * omega1_2 - 216.0 * omega1 * omega2 - 324.0 * omega2_2) * over_7 / 25.0;
    const double c_14 = -324.0 * over_7 / 35.0;  // multiplies p11*p12*h1^3*m2*p22^2*g/(h1^3*h2^3)
    const double c_15 = 324.0 * over_7 / 35.0;  // multiplies p11*p12*h1^3*p22^2*h2*k2/(h1^3*h2^3)
    const double c_16 = (-36.0 * omega1_2 - 72.0 * omega1 * omega2 - 108.0 * omega2_2) * over_7 / 25.0;
    const double c_17 = (36.0 * omega1_2 + 72.0 * omega1 * omega2 + 108.0 * omega2_2) * over_7 / 25.0;
    const double c_18 = 108.0 * over_7 / 35.0;  // multiplies p11*h1^3*m2*p22^3*g/(h1^3*h2^3)
    const double c_19 = -108.0 * over_7 / 35.0;  // multiplies p11*h1^3*p22^3*h2*k2/(h1^3*h2^3)
    const double c_20 = (36.0 * omega1_2 + 72.0 * omega1 * omega2 + 108.0 * omega2_2) * over_7 / 25.0;
    const double c_21 = 108.0 * over_7 / 35.0;  // multiplies p12^3*h1^3*m2*p21*g/(h1^3*h2^3)
    const double c_22 = -108.0 * over_7 / 35.0;  // multiplies p12^3*h1^3*p21*h2*k2/(h1^3*h2^3)
    const double c_23 = (36.0 * omega1_2 + 72.0 * omega1 * omega2 + 108.0 * omega2_2) * over_7 / 25.0;
    const double c_24 = (-108.0 * omega1_2 - 216.0 * omega1 * omega2 - 324.0 * omega2_2) * over_7 / 25.0;
    const double c_25 = -324.0 * over_7 / 35.0;  // multiplies p12^2*h1^3*m2*p21*p22*g/(h1^3*h2^3)
    const double c_26 = 324.0 * over_7 / 35.0;  // multiplies p12^2*h1^3*p21*p22*h2*k2/(h1^3*h2^3)
    const double c_27 = (-36.0 * omega1_2 - 72.0 * omega1 * omega2 - 108.0 * omega2_2) * over_7 / 25.0;
    const double c_28 = (108.0 * omega1_2 + 216.0 * omega1 * omega2 + 324.0 * omega2_2) * over_7 / 25.0;
    const double c_29 = 324.0 * over_7 / 35.0;  // multiplies p12*h1^3*m2*p21*p22^2*g/(h1^3*h2^3)
    const double c_30 = -324.0 * over_7 / 35.0;  // multiplies p12*h1^3*p21*p22^2*h2*k2/(h1^3*h2^3)
    const double c_31 = (-36.0 * omega1_2 - 72.0 * omega1 * omega2 - 108.0 * omega2_2) * over_7 / 25.0;
    const double c_32 = -108.0 * over_7 / 35.0;  // multiplies h1^3*m2*p21*p22^3*g/(h1^3*h2^3)
    const double c_33 = 108.0 * over_7 / 35.0;  // multiplies h1^3*p21*p22^3*h2*k2/(h1^3*h2^3)
    gradient[2] = p11 * p12_3 / h1_2 * c_0 + p11 * p12_3 * g / h1_3 * c_1;  // by m1
    gradient[3] = m1 * p12_3 / h1_2 * c_0 + m1 * p12_3 * g / h1_3 * c_1 + p12_3 * m2 / h2_2 * c_2
        + p12_3 * m2 * g / h2_3 * c_3 + p12_3 * k2 / h2_2 * c_4 + p12_3 * m2 / (h1 * h2) * c_5
        + p12_3 * m2 / h1_2 * c_6 + p12_3 * k1 / h1_2 * c_7 + p12_3 * m2 * g / h1_3 * c_8
        + p12_2 * m2 * p22 / h2_2 * c_9 + p12_2 * m2 * p22 * g / h2_3 * c_10 + p12_2 * p22 * k2 / h2_2 * c_11
        + p12_2 * m2 * p22 / (h1 * h2) * c_12 + p12 * m2 * p22_2 / h2_2 * c_13 + p12 * m2 * p22_2 * g / h2_3 * c_14
        + p12 * p22_2 * k2 / h2_2 * c_15 + p12 * m2 * p22_2 / (h1 * h2) * c_16 + m2 * p22_3 / h2_2 * c_17
        + m2 * p22_3 * g / h2_3 * c_18 + p22_3 * k2 / h2_2 * c_19;
    gradient[4] = 3.0 * m1 * p11 * p12_2 / h1_2 * c_0 + 3.0 * m1 * p11 * p12_2 * g / h1_3 * c_1
        + 3.0 * p11 * p12_2 * m2 / h2_2 * c_2 + 3.0 * p11 * p12_2 * m2 * g / h2_3 * c_3
        + 3.0 * p11 * p12_2 * k2 / h2_2 * c_4 + 3.0 * p11 * p12_2 * m2 / (h1 * h2) * c_5
        + 3.0 * p11 * p12_2 * m2 / h1_2 * c_6 + 3.0 * p11 * p12_2 * k1 / h1_2 * c_7
        + 3.0 * p11 * p12_2 * m2 * g / h1_3 * c_8 + 2.0 * p11 * p12 * m2 * p22 / h2_2 * c_9
        + 2.0 * p11 * p12 * m2 * p22 * g / h2_3 * c_10 + 2.0 * p11 * p12 * p22 * k2 / h2_2 * c_11
        + 2.0 * p11 * p12 * m2 * p22 / (h1 * h2) * c_12 + p11 * m2 * p22_2 / h2_2 * c_13
        + p11 * m2 * p22_2 * g / h2_3 * c_14 + p11 * p22_2 * k2 / h2_2 * c_15 + p11 * m2 * p22_2 / (h1 * h2) * c_16
        + 3.0 * p12_2 * m2 * p21 / h2_2 * c_20 + 3.0 * p12_2 * m2 * p21 * g / h2_3 * c_21
        + 3.0 * p12_2 * p21 * k2 / h2_2 * c_22 + 3.0 * p12_2 * m2 * p21 / (h1 * h2) * c_23
        + 2.0 * p12 * m2 * p21 * p22 / h2_2 * c_24 + 2.0 * p12 * m2 * p21 * p22 * g / h2_3 * c_25
        + 2.0 * p12 * p21 * p22 * k2 / h2_2 * c_26 + 2.0 * p12 * m2 * p21 * p22 / (h1 * h2) * c_27
        + m2 * p21 * p22_2 / h2_2 * c_28 + m2 * p21 * p22_2 * g / h2_3 * c_29 + p21 * p22_2 * k2 / h2_2 * c_30;
    gradient[5] = -2.0 * m1 * p11 * p12_3 / h1_3 * c_0 - 3.0 * m1 * p11 * p12_3 * g / h1_4 * c_1
        - p11 * p12_3 * m2 / (h1_2 * h2) * c_5 - 2.0 * p11 * p12_3 * m2 / h1_3 * c_6
        - 2.0 * p11 * p12_3 * k1 / h1_3 * c_7 - 3.0 * p11 * p12_3 * m2 * g / h1_4 * c_8
        - p11 * p12_2 * m2 * p22 / (h1_2 * h2) * c_12 - p11 * p12 * m2 * p22_2 / (h1_2 * h2) * c_16
        - p12_3 * m2 * p21 / (h1_2 * h2) * c_23 - p12_2 * m2 * p21 * p22 / (h1_2 * h2) * c_27;
    gradient[6] = p11 * p12_3 / h2_2 * c_2 + p11 * p12_3 * g / h2_3 * c_3 + p11 * p12_3 / (h1 * h2) * c_5
        + p11 * p12_3 / h1_2 * c_6 + p11 * p12_3 * g / h1_3 * c_8 + p11 * p12_2 * p22 / h2_2 * c_9
        + p11 * p12_2 * p22 * g / h2_3 * c_10 + p11 * p12_2 * p22 / (h1 * h2) * c_12
        + p11 * p12 * p22_2 / h2_2 * c_13 + p11 * p12 * p22_2 * g / h2_3 * c_14
        + p11 * p12 * p22_2 / (h1 * h2) * c_16 + p11 * p22_3 / h2_2 * c_17 + p11 * p22_3 * g / h2_3 * c_18
        + p12_3 * p21 / h2_2 * c_20 + p12_3 * p21 * g / h2_3 * c_21 + p12_3 * p21 / (h1 * h2) * c_23
        + p12_2 * p21 * p22 / h2_2 * c_24 + p12_2 * p21 * p22 * g / h2_3 * c_25
        + p12_2 * p21 * p22 / (h1 * h2) * c_27 + p12 * p21 * p22_2 / h2_2 * c_28
        + p12 * p21 * p22_2 * g / h2_3 * c_29 + p21 * p22_3 / h2_2 * c_31 + p21 * p22_3 * g / h2_3 * c_32;
    gradient[7] = p12_3 * m2 / h2_2 * c_20 + p12_3 * m2 * g / h2_3 * c_21 + p12_3 * k2 / h2_2 * c_22
        + p12_3 * m2 / (h1 * h2) * c_23 + p12_2 * m2 * p22 / h2_2 * c_24 + p12_2 * m2 * p22 * g / h2_3 * c_25
        + p12_2 * p22 * k2 / h2_2 * c_26 + p12_2 * m2 * p22 / (h1 * h2) * c_27 + p12 * m2 * p22_2 / h2_2 * c_28
        + p12 * m2 * p22_2 * g / h2_3 * c_29 + p12 * p22_2 * k2 / h2_2 * c_30 + m2 * p22_3 / h2_2 * c_31
        + m2 * p22_3 * g / h2_3 * c_32 + p22_3 * k2 / h2_2 * c_33;
    gradient[8] = p11 * p12_2 * m2 / h2_2 * c_9 + p11 * p12_2 * m2 * g / h2_3 * c_10
        + p11 * p12_2 * k2 / h2_2 * c_11 + p11 * p12_2 * m2 / (h1 * h2) * c_12
        + 2.0 * p11 * p12 * m2 * p22 / h2_2 * c_13 + 2.0 * p11 * p12 * m2 * p22 * g / h2_3 * c_14
        + 2.0 * p11 * p12 * p22 * k2 / h2_2 * c_15 + 2.0 * p11 * p12 * m2 * p22 / (h1 * h2) * c_16
        + 3.0 * p11 * m2 * p22_2 / h2_2 * c_17 + 3.0 * p11 * m2 * p22_2 * g / h2_3 * c_18
        + 3.0 * p11 * p22_2 * k2 / h2_2 * c_19 + p12_2 * m2 * p21 / h2_2 * c_24 + p12_2 * m2 * p21 * g / h2_3 * c_25
        + p12_2 * p21 * k2 / h2_2 * c_26 + p12_2 * m2 * p21 / (h1 * h2) * c_27
        + 2.0 * p12 * m2 * p21 * p22 / h2_2 * c_28 + 2.0 * p12 * m2 * p21 * p22 * g / h2_3 * c_29
        + 2.0 * p12 * p21 * p22 * k2 / h2_2 * c_30 + 3.0 * m2 * p21 * p22_2 / h2_2 * c_31
        + 3.0 * m2 * p21 * p22_2 * g / h2_3 * c_32 + 3.0 * p21 * p22_2 * k2 / h2_2 * c_33;
    gradient[9] = -2.0 * p11 * p12_3 * m2 / h2_3 * c_2 - 3.0 * p11 * p12_3 * m2 * g / h2_4 * c_3
        - 2.0 * p11 * p12_3 * k2 / h2_3 * c_4 - p11 * p12_3 * m2 / (h1 * h2_2) * c_5
        - 2.0 * p11 * p12_2 * m2 * p22 / h2_3 * c_9 - 3.0 * p11 * p12_2 * m2 * p22 * g / h2_4 * c_10
        - 2.0 * p11 * p12_2 * p22 * k2 / h2_3 * c_11 - p11 * p12_2 * m2 * p22 / (h1 * h2_2) * c_12
        - 2.0 * p11 * p12 * m2 * p22_2 / h2_3 * c_13 - 3.0 * p11 * p12 * m2 * p22_2 * g / h2_4 * c_14
        - 2.0 * p11 * p12 * p22_2 * k2 / h2_3 * c_15 - p11 * p12 * m2 * p22_2 / (h1 * h2_2) * c_16
        - 2.0 * p11 * m2 * p22_3 / h2_3 * c_17 - 3.0 * p11 * m2 * p22_3 * g / h2_4 * c_18
        - 2.0 * p11 * p22_3 * k2 / h2_3 * c_19 - 2.0 * p12_3 * m2 * p21 / h2_3 * c_20
        - 3.0 * p12_3 * m2 * p21 * g / h2_4 * c_21 - 2.0 * p12_3 * p21 * k2 / h2_3 * c_22
        - p12_3 * m2 * p21 / (h1 * h2_2) * c_23 - 2.0 * p12_2 * m2 * p21 * p22 / h2_3 * c_24
        - 3.0 * p12_2 * m2 * p21 * p22 * g / h2_4 * c_25 - 2.0 * p12_2 * p21 * p22 * k2 / h2_3 * c_26
        - p12_2 * m2 * p21 * p22 / (h1 * h2_2) * c_27 - 2.0 * p12 * m2 * p21 * p22_2 / h2_3 * c_28
        - 3.0 * p12 * m2 * p21 * p22_2 * g / h2_4 * c_29 - 2.0 * p12 * p21 * p22_2 * k2 / h2_3 * c_30
        - 2.0 * m2 * p21 * p22_3 / h2_3 * c_31 - 3.0 * m2 * p21 * p22_3 * g / h2_4 * c_32
        - 2.0 * p21 * p22_3 * k2 / h2_3 * c_33;
    gradient[10] = p11 * p12_3 / h1_2 * c_7;  // by k1
    gradient[11] = p11 * p12_3 / h2_2 * c_4 + p11 * p12_2 * p22 / h2_2 * c_11 + p11 * p12 * p22_2 / h2_2 * c_15
        + p11 * p22_3 / h2_2 * c_19 + p12_3 * p21 / h2_2 * c_22 + p12_2 * p21 * p22 / h2_2 * c_26
        + p12 * p21 * p22_2 / h2_2 * c_30 + p21 * p22_3 / h2_2 * c_33;
    gradient[12] = m1 * p11 * p12_3 / h1_3 * c_1 + p11 * p12_3 * m2 / h2_3 * c_3 + p11 * p12_3 * m2 / h1_3 * c_8
        + p11 * p12_2 * m2 * p22 / h2_3 * c_10 + p11 * p12 * m2 * p22_2 / h2_3 * c_14
        + p11 * m2 * p22_3 / h2_3 * c_18 + p12_3 * m2 * p21 / h2_3 * c_21 + p12_2 * m2 * p21 * p22 / h2_3 * c_25
        + p12 * m2 * p21 * p22_2 / h2_3 * c_29 + m2 * p21 * p22_3 / h2_3 * c_32;
  }
  void lump_conservative_v1_conjA_v2_F([[maybe_unused]] double* gradient) const {
    gradient[0] = (3.0 * m1 * p11 * p12 * h2 * lift + 3.0 * p11 * p12 * h1 * m2 * lift
        + 3.0 * p11 * p12 * m2 * h2 * lift - 3.0 * p11 * h1 * m2 * p22 * lift - 3.0 * p12 * h1 * m2 * p21 * lift
        + 3.0 * h1 * m2 * p21 * p22 * lift) / (10.0 * omega1_2 * h1 * h2);
    gradient[2] = -3.0 * p11 * p12 * lift / (10.0 * omega1 * h1);  // by m1
    gradient[3] = (-3.0 * m1 * p12 * h2 * lift - 3.0 * p12 * h1 * m2 * lift - 3.0 * p12 * m2 * h2 * lift
        + 3.0 * h1 * m2 * p22 * lift) / (10.0 * omega1 * h1 * h2);
    gradient[4] = (-3.0 * m1 * p11 * h2 * lift - 3.0 * p11 * h1 * m2 * lift - 3.0 * p11 * m2 * h2 * lift
        + 3.0 * h1 * m2 * p21 * lift) / (10.0 * omega1 * h1 * h2);
    gradient[5] = (3.0 * m1 * p11 * p12 * lift + 3.0 * p11 * p12 * m2 * lift) / (10.0 * omega1 * h1_2);  // by h1
    gradient[6] = (-3.0 * p11 * p12 * h1 * lift - 3.0 * p11 * p12 * h2 * lift + 3.0 * p11 * h1 * p22 * lift
        + 3.0 * p12 * h1 * p21 * lift - 3.0 * h1 * p21 * p22 * lift) / (10.0 * omega1 * h1 * h2);
    gradient[7] = (3.0 * p12 * m2 * lift - 3.0 * m2 * p22 * lift) / (10.0 * omega1 * h2);  // by p21
    gradient[8] = (3.0 * p11 * m2 * lift - 3.0 * m2 * p21 * lift) / (10.0 * omega1 * h2);  // by p22
    gradient[9] = (3.0 * p11 * p12 * m2 * lift - 3.0 * p11 * m2 * p22 * lift - 3.0 * p12 * m2 * p21 * lift
        + 3.0 * m2 * p21 * p22 * lift) / (10.0 * omega1 * h2_2);
    gradient[13] = (-3.0 * m1 * p11 * p12 * h2 - 3.0 * p11 * p12 * h1 * m2 - 3.0 * p11 * p12 * m2 * h2
        + 3.0 * p11 * h1 * m2 * p22 + 3.0 * p12 * h1 * m2 * p21
        - 3.0 * h1 * m2 * p21 * p22) / (10.0 * omega1 * h1 * h2);
  }
  void lump_harmonic_re_v1_F_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = (-m1 * p11 * tilt - m2 * p21 * tilt) * per_6 / (2.0 * omega2);
    const double q_6 = f_0 * per_6;
    gradient[0] = -2.0 * q_6;  // by omega1
    gradient[1] = -f_0 / omega2 - q_6;  // by omega2
    const double c_0 = -per_6 / (2.0 * omega2);  // multiplies m1*p11*tilt
    const double c_1 = -per_6 / (2.0 * omega2);  // multiplies m2*p21*tilt
    gradient[2] = p11 * tilt * c_0;  // by m1
    gradient[3] = m1 * tilt * c_0;  // by p11
    gradient[6] = p21 * tilt * c_1;  // by m2
    gradient[7] = m2 * tilt * c_1;  // by p21
    gradient[15] = m1 * p11 * c_0 + m2 * p21 * c_1;  // by tilt
  }
  void lump_harmonic_re_v1_conjA_v1_F([[maybe_unused]] double* gradient) const {
    const double f_0 = (3.0 * m1 * p11_2 * h2 * lift + 3.0 * p11_2 * h1 * m2 * lift + 3.0 * p11_2 * m2 * h2 * lift
        - 6.0 * p11 * h1 * m2 * p21 * lift + 3.0 * h1 * m2 * p21_2 * lift) * over_1 / (5.0 * h1 * h2);
    const double q_0 = f_0 * per_0;
    const double q_2 = f_0 * per_2;
    gradient[0] = -q_0 - q_2;  // by omega1
    gradient[1] = q_0 - q_2;  // by omega2
    const double c_0 = 3.0 * over_1 / 5.0;  // multiplies m1*p11^2*h2*lift/(h1*h2)
    const double c_1 = 3.0 * over_1 / 5.0;  // multiplies p11^2*h1*m2*lift/(h1*h2)
    const double c_2 = 3.0 * over_1 / 5.0;  // multiplies p11^2*m2*h2*lift/(h1*h2)
    const double c_3 = -6.0 * over_1 / 5.0;  // multiplies p11*h1*m2*p21*lift/(h1*h2)
    const double c_4 = 3.0 * over_1 / 5.0;  // multiplies h1*m2*p21^2*lift/(h1*h2)
    gradient[2] = p11_2 * lift / h1 * c_0;  // by m1
    gradient[3] = 2.0 * m1 * p11 * lift / h1 * c_0 + 2.0 * p11 * m2 * lift / h2 * c_1
        + 2.0 * p11 * m2 * lift / h1 * c_2 + m2 * p21 * lift / h2 * c_3;
    gradient[5] = -m1 * p11_2 * lift / h1_2 * c_0 - p11_2 * m2 * lift / h1_2 * c_2;  // by h1
    gradient[6] = p11_2 * lift / h2 * c_1 + p11_2 * lift / h1 * c_2 + p11 * p21 * lift / h2 * c_3
        + p21_2 * lift / h2 * c_4;
    gradient[7] = p11 * m2 * lift / h2 * c_3 + 2.0 * m2 * p21 * lift / h2 * c_4;  // by p21
    gradient[9] = -p11_2 * m2 * lift / h2_2 * c_1 - p11 * m2 * p21 * lift / h2_2 * c_3
        - m2 * p21_2 * lift / h2_2 * c_4;
    gradient[13] = m1 * p11_2 / h1 * c_0 + p11_2 * m2 / h2 * c_1 + p11_2 * m2 / h1 * c_2 + p11 * m2 * p21 / h2 * c_3
        + m2 * p21_2 / h2 * c_4;
  }
  void lump_harmonic_re_v2_F_of_additive_combination([[maybe_unused]] double* gradient) const {
    const double f_0 = (-m1 * p12 * tilt - m2 * p22 * tilt) * per_8 / (2.0 * omega1);
    const double q_8 = f_0 * per_8;
    gradient[0] = -f_0 / omega1 - q_8;  // by omega1
    gradient[1] = -2.0 * q_8;  // by omega2
    const double c_0 = -per_8 / (2.0 * omega1);  // multiplies m1*p12*tilt
    const double c_1 = -per_8 / (2.0 * omega1);  // multiplies m2*p22*tilt
    gradient[2] = p12 * tilt * c_0;  // by m1
    gradient[4] = m1 * tilt * c_0;  // by p12
    gradient[6] = p22 * tilt * c_1;  // by m2
    gradient[8] = m2 * tilt * c_1;  // by p22
    gradient[15] = m1 * p12 * c_0 + m2 * p22 * c_1;  // by tilt
  }
  void lump_harmonic_re_v2_conjA_v2_F([[maybe_unused]] double* gradient) const {
    const double f_0 = (-3.0 * m1 * p12_2 * h2 * lift - 3.0 * p12_2 * h1 * m2 * lift - 3.0 * p12_2 * m2 * h2 * lift
        + 6.0 * p12 * h1 * m2 * p22 * lift - 3.0 * h1 * m2 * p22_2 * lift) * over_1 / (5.0 * h1 * h2);
    const double q_0 = f_0 * per_0;
    const double q_2 = f_0 * per_2;
    gradient[0] = -q_0 - q_2;  // by omega1
    gradient[1] = q_0 - q_2;  // by omega2
    const double c_0 = -3.0 * over_1 / 5.0;  // multiplies m1*p12^2*h2*lift/(h1*h2)
    const double c_1 = -3.0 * over_1 / 5.0;  // multiplies p12^2*h1*m2*lift/(h1*h2)
    const double c_2 = -3.0 * over_1 / 5.0;  // multiplies p12^2*m2*h2*lift/(h1*h2)
    const double c_3 = 6.0 * over_1 / 5.0;  // multiplies p12*h1*m2*p22*lift/(h1*h2)
    const double c_4 = -3.0 * over_1 / 5.0;  // multiplies h1*m2*p22^2*lift/(h1*h2)
    gradient[2] = p12_2 * lift / h1 * c_0;  // by m1
    gradient[4] = 2.0 * m1 * p12 * lift / h1 * c_0 + 2.0 * p12 * m2 * lift / h2 * c_1
        + 2.0 * p12 * m2 * lift / h1 * c_2 + m2 * p22 * lift / h2 * c_3;
    gradient[5] = -m1 * p12_2 * lift / h1_2 * c_0 - p12_2 * m2 * lift / h1_2 * c_2;  // by h1
    gradient[6] = p12_2 * lift / h2 * c_1 + p12_2 * lift / h1 * c_2 + p12 * p22 * lift / h2 * c_3
        + p22_2 * lift / h2 * c_4;
    gradient[8] = p12 * m2 * lift / h2 * c_3 + 2.0 * m2 * p22 * lift / h2 * c_4;  // by p22
    gradient[9] = -p12_2 * m2 * lift / h2_2 * c_1 - p12 * m2 * p22 * lift / h2_2 * c_3
        - m2 * p22_2 * lift / h2_2 * c_4;
    gradient[13] = m1 * p12_2 / h1 * c_0 + p12_2 * m2 / h2 * c_1 + p12_2 * m2 / h1 * c_2 + p12 * m2 * p22 / h2 * c_3
        + m2 * p22_2 / h2 * c_4;
  }

  using Gradient = void (LumpGradients::*)(double*) const;
  static constexpr Gradient gradients[] = {&LumpGradients::lump_mu1,
      &LumpGradients::lump_conservative_v1_A_v1_A_v2_conjA_v2, &LumpGradients::lump_conservative_v1_A_v12_conjA_v1,
      &LumpGradients::lump_conservative_v1_conjA_v1_F, &LumpGradients::lump_mu2,
      &LumpGradients::lump_conservative_v2_A_v22_conjA_v2, &LumpGradients::lump_harmonic_re_v1_F,
      &LumpGradients::lump_harmonic_re_v1_A_v2_conjA_v12, &LumpGradients::lump_harmonic_re_v1_A_v2_F,
      &LumpGradients::lump_harmonic_re_v1_A_v22_conjA_v1, &LumpGradients::lump_harmonic_re_v1_A_v22_conjA_v2,
      &LumpGradients::lump_harmonic_re_v1_A_v1_A_v2_conjA_v1, &LumpGradients::lump_harmonic_re_v1_A_v12_A_v2,
      &LumpGradients::lump_harmonic_re_v1_A_v23, &LumpGradients::lump_harmonic_re_v1_A_v13,
      &LumpGradients::lump_harmonic_re_v1_A_v1_A_v22, &LumpGradients::lump_harmonic_re_v2_F,
      &LumpGradients::lump_harmonic_re_v2_A_v2_conjA_v12, &LumpGradients::lump_harmonic_re_v2_A_v2_F,
      &LumpGradients::lump_harmonic_re_v2_A_v1_A_v2_conjA_v2, &LumpGradients::lump_harmonic_re_v2_A_v12_conjA_v1,
      &LumpGradients::lump_harmonic_re_v2_A_v22_conjA_v1, &LumpGradients::lump_harmonic_re_v2_A_v12_A_v2,
      &LumpGradients::lump_harmonic_re_v2_A_v23, &LumpGradients::lump_harmonic_re_v2_A_v13,
      &LumpGradients::lump_harmonic_re_v2_A_v1_A_v22, &LumpGradients::lump_conservative_v1_conjA_v2_F,
      &LumpGradients::lump_harmonic_re_v1_F_of_additive_combination, &LumpGradients::lump_harmonic_re_v1_conjA_v1_F,
      &LumpGradients::lump_harmonic_re_v2_F_of_additive_combination,
      &LumpGradients::lump_harmonic_re_v2_conjA_v2_F};
};

inline constexpr LumpFunctions lump_functions = {lump_values<Lumps>, lump_jacobian<LumpGradients, 17>};

}  // namespace secular::generated::two_mass_frame
