// Model duffing: generated code, never edited by hand.
// Holds rows of the case subharmonic_3_second_order. Made by: secular generate duffing.
// Omega = 3*omega0 + eps*sigma, multiple scales to eps^2. Valid near that resonance for small amplitudes; what
// is left out is of order eps^3.
#pragma once

#include "duffing.hpp"

namespace secular::generated::duffing {

namespace subharmonic_3_second_order {

/// (rate - i*omega0)*A_x = i*conservative_x_A_x4_F*A_x^4*F + i*conservative_x_A_x4_F*A_x*conj(A_x)^3*F - mu*A_x
/// + i*conservative_x_A_x*A_x + i*conservative_x_A_x_F2*A_x*F^2 + (-3*omega0 +
/// Omega)*i*conservative_x_A_x_F2_sigma*A_x*F^2 + i*conservative_x_A_x_F4*A_x*F^4 +
/// dissipative_x_A_x2_conjA_x*A_x^2*conj(A_x) + i*conservative_x_A_x2_conjA_x*A_x^2*conj(A_x) +
/// i*conservative_x_A_x2_conjA_x_F2*A_x^2*conj(A_x)*F^2 + i*conservative_x_A_x3_conjA_x2*A_x^3*conj(A_x)^2 +
/// dissipative_x_conjA_x2_F*conj(A_x)^2*F + i*conservative_x_conjA_x2_F*conj(A_x)^2*F + (-3*omega0 +
/// Omega)*i*conservative_x_conjA_x2_F_sigma*conj(A_x)^2*F + i*conservative_x_conjA_x2_F3*conj(A_x)^2*F^3
struct modulation_of_x : BlockShape<14, 3, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 3> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    return {1.0, -1.0, -3.0 * omega0 + Omega};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    // conservative_x_A_x4_F
    column[0] = times_i(factor[0] * (fixed_power<4>(A_x) * conj_F))
        + times_i(factor[0] * (norm_A_x * conj_A_x * conj_A_x * F));
    column[1] = factor[1] * A_x;  // mu
    column[2] = times_i(factor[0] * A_x);  // conservative_x_A_x
    column[3] = times_i(factor[0] * (A_x * norm_F));  // conservative_x_A_x_F2
    column[4] = times_i(factor[2] * (A_x * norm_F));  // conservative_x_A_x_F2_sigma
    column[5] = times_i(factor[0] * (A_x * norm_F * norm_F));  // conservative_x_A_x_F4
    column[6] = factor[0] * (norm_A_x * A_x);  // dissipative_x_A_x2_conjA_x
    column[7] = times_i(factor[0] * (norm_A_x * A_x));  // conservative_x_A_x2_conjA_x
    column[8] = times_i(factor[0] * (norm_A_x * A_x * norm_F));  // conservative_x_A_x2_conjA_x_F2
    column[9] = times_i(factor[0] * (norm_A_x * norm_A_x * A_x));  // conservative_x_A_x3_conjA_x2
    column[10] = factor[0] * (conj_A_x * conj_A_x * F);  // dissipative_x_conjA_x2_F
    column[11] = times_i(factor[0] * (conj_A_x * conj_A_x * F));  // conservative_x_conjA_x2_F
    column[12] = times_i(factor[2] * (conj_A_x * conj_A_x * F));  // conservative_x_conjA_x2_F_sigma
    column[13] = times_i(factor[0] * (conj_A_x * conj_A_x * norm_F * F));  // conservative_x_conjA_x2_F3
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    by[0] = ComplexNumber<double>(lump[1] * factor[1] + 2.0 * lump[6] * factor[0] * norm_A_x, lump[2] * factor[0]
        + lump[3] * factor[0] * norm_F + lump[4] * factor[2] * norm_F + lump[5] * factor[0] * (norm_F * norm_F)
        + 2.0 * lump[7] * factor[0] * norm_A_x + 2.0 * lump[8] * factor[0] * (norm_A_x * norm_F)
        + 3.0 * lump[9] * factor[0] * (norm_A_x * norm_A_x))
        + times_i(4.0 * lump[0] * factor[0] * (A_x * A_x * A_x * conj_F)
        + lump[0] * factor[0] * (conj_A_x * conj_A_x * conj_A_x * F));
    by_conjugate[0] = lump[6] * factor[0] * (A_x * A_x) + 2.0 * lump[10] * factor[0] * (conj_A_x * F)
        + times_i(3.0 * lump[0] * factor[0] * (norm_A_x * conj_A_x * F) + lump[7] * factor[0] * (A_x * A_x)
        + lump[8] * factor[0] * (A_x * A_x * norm_F) + 2.0 * lump[9] * factor[0] * (norm_A_x * A_x * A_x)
        + 2.0 * lump[11] * factor[0] * (conj_A_x * F) + 2.0 * lump[12] * factor[2] * (conj_A_x * F)
        + 2.0 * lump[13] * factor[0] * (conj_A_x * norm_F * F));
  }
};

/// amplitude of exp(i*(Omega)*t) in x = 13/(32*omega0)*conservative_x_A_x4_F*A_x^2*conj(A_x)^2*F -
/// 9/(32*omega0)*conservative_x_A_x4_F*A_x^2*conj(A_x)^2*F - 1/(8*omega0)*i*dissipative_x_A_x2_conjA_x*A_x^3 +
/// 1/(28*omega0)*conservative_x_A_x2_conjA_x_F2*conj(A_x)^3*F^2 +
/// 9/(28*omega0)*conservative_x_A_x2_conjA_x_F2*A_x^3*F^2 -
/// 9/(28*omega0)*conservative_x_A_x2_conjA_x_F2*conj(A_x)^3*F^2 -
/// 1/(4*omega0)*conservative_x_A_x2_conjA_x_F2*A_x^3*F^2 +
/// 7/(20*omega0)*conservative_x_A_x3_conjA_x2*A_x^4*conj(A_x) -
/// 2/5*conservative_x_conjA_x2_F_sigma*A_x*conj(A_x)*F + (-9*omega0 +
/// 3*Omega)/(5*omega0)*conservative_x_conjA_x2_F_sigma*A_x*conj(A_x)*F +
/// 3/(8*omega0)*conservative_x_conjA_x2_F3*A_x*conj(A_x)*F^3 - 1/(16*omega0^2)*e*F + (-9*omega0 +
/// 3*Omega)/(64*omega0^3)*e*F + (-63*omega0^2 + 42*omega0*Omega - 7*Omega^2)/(256*omega0^4)*e*F +
/// i*harmonic_im_x_F*F + (21*omega0 - 7*Omega)/(6*omega0)*i*harmonic_im_x_F*F + harmonic_re_x_F3*F^3 +
/// harmonic_re_x_F3*F^3 + (9*omega0 - 3*Omega)/omega0*harmonic_re_x_F3*F^3 + 1/(8*omega0^2)*a3*A_x^3 +
/// harmonic_re_x_F*F + i*harmonic_im_x_F3*F^3 + harmonic_re_x_F5*F^5 +
/// harmonic_re_x_A_x_conjA_x_F*A_x*conj(A_x)*F + harmonic_re_x_A_x3*A_x^3
struct harmonic_Omega_of_x : BlockShape<15, 18, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 18> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    const Number omega0_3 = omega0_2 * omega0;
    const Number omega0_4 = omega0_3 * omega0;
    const Number Omega_2 = Omega * Omega;
    return {13.0 / (32.0 * omega0), -9.0 / (32.0 * omega0), -1.0 / (8.0 * omega0), 1.0 / (28.0 * omega0),
        9.0 / (28.0 * omega0), -9.0 / (28.0 * omega0), -1.0 / (4.0 * omega0), 7.0 / (20.0 * omega0), -2.0 / 5.0,
        (-9.0 * omega0 + 3.0 * Omega) / (5.0 * omega0), 3.0 / (8.0 * omega0), -1.0 / (16.0 * omega0_2),
        (-9.0 * omega0 + 3.0 * Omega) / (64.0 * omega0_3),
        (-63.0 * omega0_2 + 42.0 * omega0 * Omega - 7.0 * Omega_2) / (256.0 * omega0_4), 1.0,
        (21.0 * omega0 - 7.0 * Omega) / (6.0 * omega0), (9.0 * omega0 - 3.0 * Omega) / omega0,
        1.0 / (8.0 * omega0_2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    // conservative_x_A_x4_F
    column[0] = factor[0] * (norm_A_x * norm_A_x * F) + factor[1] * (norm_A_x * norm_A_x * F);
    column[1] = times_i(factor[2] * (A_x * A_x * A_x));  // dissipative_x_A_x2_conjA_x
    // conservative_x_A_x2_conjA_x_F2
    column[2] = factor[3] * (conj_A_x * conj_A_x * conj_A_x * F * F) + factor[4] * (A_x * A_x * A_x * norm_F)
        + factor[5] * (conj_A_x * conj_A_x * conj_A_x * F * F) + factor[6] * (A_x * A_x * A_x * norm_F);
    column[3] = factor[7] * (norm_A_x * A_x * A_x * A_x);  // conservative_x_A_x3_conjA_x2
    column[4] = factor[8] * (norm_A_x * F) + factor[9] * (norm_A_x * F);  // conservative_x_conjA_x2_F_sigma
    column[5] = factor[10] * (norm_A_x * norm_F * F);  // conservative_x_conjA_x2_F3
    column[6] = factor[11] * F + factor[12] * F + factor[13] * F;  // e
    column[7] = times_i(factor[14] * F) + times_i(factor[15] * F);  // harmonic_im_x_F
    // harmonic_re_x_F3
    column[8] = factor[14] * (norm_F * F) + factor[14] * (norm_F * F) + factor[16] * (norm_F * F);
    column[9] = factor[17] * (A_x * A_x * A_x);  // a3
    column[10] = factor[14] * F;  // harmonic_re_x_F
    column[11] = times_i(factor[14] * (norm_F * F));  // harmonic_im_x_F3
    column[12] = factor[14] * (norm_F * norm_F * F);  // harmonic_re_x_F5
    column[13] = factor[14] * (norm_A_x * F);  // harmonic_re_x_A_x_conjA_x_F
    column[14] = factor[14] * (A_x * A_x * A_x);  // harmonic_re_x_A_x3
  }
};

/// amplitude of exp(i*(-omega0 + Omega)*t) in x = harmonic_re_x_conjA_x_F*conj(A_x)*F + (75*omega0 -
/// 25*Omega)/(12*omega0)*harmonic_re_x_conjA_x_F*conj(A_x)*F + 1/(3*omega0^2)*a2*A_x^2 +
/// harmonic_re_x_A_x2_F2*A_x^2*F^2 - 139/80*harmonic_re_x_A_x2_F2*A_x^2*F^2 +
/// i*harmonic_im_x_conjA_x_F*conj(A_x)*F + harmonic_re_x_conjA_x_F3*conj(A_x)*F^3 +
/// harmonic_re_x_A_x_conjA_x2_F*A_x*conj(A_x)^2*F + 40*harmonic_re_x_A_x_conjA_x2_F*A_x*conj(A_x)^2*F +
/// i*harmonic_im_x_A_x2*A_x^2 + harmonic_re_x_A_x3_conjA_x*A_x^3*conj(A_x)
struct harmonic_minus_omega0_plus_Omega_of_x : BlockShape<8, 5, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 5> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    return {1.0, (75.0 * omega0 - 25.0 * Omega) / (12.0 * omega0), 1.0 / (3.0 * omega0_2), -139.0 / 80.0, 40.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (conj_A_x * F) + factor[1] * (conj_A_x * F);  // harmonic_re_x_conjA_x_F
    column[1] = factor[2] * (A_x * A_x);  // a2
    column[2] = factor[0] * (A_x * A_x * norm_F) + factor[3] * (A_x * A_x * norm_F);  // harmonic_re_x_A_x2_F2
    column[3] = times_i(factor[0] * (conj_A_x * F));  // harmonic_im_x_conjA_x_F
    column[4] = factor[0] * (conj_A_x * norm_F * F);  // harmonic_re_x_conjA_x_F3
    // harmonic_re_x_A_x_conjA_x2_F
    column[5] = factor[0] * (norm_A_x * conj_A_x * F) + factor[4] * (norm_A_x * conj_A_x * F);
    column[6] = times_i(factor[0] * (A_x * A_x));  // harmonic_im_x_A_x2
    column[7] = factor[0] * (norm_A_x * A_x * A_x);  // harmonic_re_x_A_x3_conjA_x
  }
};

/// amplitude of exp(i*(-omega0 + 2*Omega)*t) in x = -1/36*conservative_x_A_x_F2_sigma*conj(A_x)*F^2 +
/// (-21*omega0 + 7*Omega)/(108*omega0)*conservative_x_A_x_F2_sigma*conj(A_x)*F^2 -
/// 13/(90*omega0)*conservative_x_A_x_F4*conj(A_x)*F^4 +
/// 13/(112*omega0)*conservative_x_A_x2_conjA_x_F2*A_x*conj(A_x)^2*F^2 -
/// 5/(84*omega0)*conservative_x_A_x2_conjA_x_F2*A_x*conj(A_x)^2*F^2 -
/// 1/(60*omega0)*conservative_x_A_x3_conjA_x2*A_x^5 - 1/(9*omega0)*i*dissipative_x_conjA_x2_F*A_x^2*F -
/// 1/15*conservative_x_conjA_x2_F_sigma*A_x^2*F + (-21*omega0 +
/// 7*Omega)/(90*omega0)*conservative_x_conjA_x2_F_sigma*A_x^2*F +
/// 5/(216*omega0)*conservative_x_conjA_x2_F3*A_x^2*F^3 - 7/(108*omega0)*conservative_x_conjA_x2_F3*A_x^2*F^3 -
/// 7/54*harmonic_re_x_A_x_conjA_x_F*A_x^2*F + harmonic_re_x_conjA_x_F2*conj(A_x)*F^2 +
/// i*harmonic_im_x_conjA_x_F2*conj(A_x)*F^2
struct harmonic_minus_omega0_plus_2_Omega_of_x : BlockShape<10, 13, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 13> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    return {-1.0 / 36.0, (-21.0 * omega0 + 7.0 * Omega) / (108.0 * omega0), -13.0 / (90.0 * omega0),
        13.0 / (112.0 * omega0), -5.0 / (84.0 * omega0), -1.0 / (60.0 * omega0), -1.0 / (9.0 * omega0),
        -1.0 / 15.0, (-21.0 * omega0 + 7.0 * Omega) / (90.0 * omega0), 5.0 / (216.0 * omega0),
        -7.0 / (108.0 * omega0), -7.0 / 54.0, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (conj_A_x * F * F) + factor[1] * (conj_A_x * F * F);  // conservative_x_A_x_F2_sigma
    column[1] = factor[2] * (conj_A_x * norm_F * F * F);  // conservative_x_A_x_F4
    // conservative_x_A_x2_conjA_x_F2
    column[2] = factor[3] * (norm_A_x * conj_A_x * F * F) + factor[4] * (norm_A_x * conj_A_x * F * F);
    column[3] = factor[5] * fixed_power<5>(A_x);  // conservative_x_A_x3_conjA_x2
    column[4] = times_i(factor[6] * (A_x * A_x * F));  // dissipative_x_conjA_x2_F
    column[5] = factor[7] * (A_x * A_x * F) + factor[8] * (A_x * A_x * F);  // conservative_x_conjA_x2_F_sigma
    // conservative_x_conjA_x2_F3
    column[6] = factor[9] * (A_x * A_x * norm_F * F) + factor[10] * (A_x * A_x * norm_F * F);
    column[7] = factor[11] * (A_x * A_x * F);  // harmonic_re_x_A_x_conjA_x_F
    column[8] = factor[12] * (conj_A_x * F * F);  // harmonic_re_x_conjA_x_F2
    column[9] = times_i(factor[12] * (conj_A_x * F * F));  // harmonic_im_x_conjA_x_F2
  }
};

/// amplitude of exp(i*(0)*t) in x = -2/omega0^2*a2*A_x*conj(A_x) +
/// 171/20*harmonic_re_x_A_x2_F2*A_x*conj(A_x)*F^2 + 255/2*harmonic_re_x_A_x_conjA_x2_F*conj(A_x)^3*F +
/// 255/2*harmonic_re_x_A_x_conjA_x2_F*A_x^3*F - 120/31*harmonic_re_x_A_x3_conjA_x*A_x^2*conj(A_x)^2 +
/// harmonic_re_x_F2*F^2 + (9*omega0 - 3*Omega)/(2*omega0)*harmonic_re_x_F2*F^2 + harmonic_re_x_F4*F^4
struct harmonic_0_of_x : BlockShape<6, 6, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 6> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    return {-2.0 / omega0_2, 171.0 / 20.0, 255.0 / 2.0, -120.0 / 31.0, 1.0,
        (9.0 * omega0 - 3.0 * Omega) / (2.0 * omega0)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = ComplexNumber<Number>(factor[0] * norm_A_x);  // a2
    column[1] = ComplexNumber<Number>(factor[1] * (norm_A_x * norm_F));  // harmonic_re_x_A_x2_F2
    // harmonic_re_x_A_x_conjA_x2_F
    column[2] = factor[2] * (conj_A_x * conj_A_x * conj_A_x * F) + factor[2] * (A_x * A_x * A_x * conj_F);
    column[3] = ComplexNumber<Number>(factor[3] * (norm_A_x * norm_A_x));  // harmonic_re_x_A_x3_conjA_x
    // harmonic_re_x_F2
    column[4] = ComplexNumber<Number>(factor[4] * norm_F) + ComplexNumber<Number>(factor[5] * norm_F);
    column[5] = ComplexNumber<Number>(factor[4] * (norm_F * norm_F));  // harmonic_re_x_F4
  }
};

/// amplitude of exp(i*(2*Omega)*t) in x = 711/39200*harmonic_re_x_A_x2_F2*A_x*conj(A_x)*F^2 -
/// 87/35*harmonic_re_x_A_x_conjA_x2_F*A_x^3*F - 1/70*harmonic_re_x_F2*F^2 + (-459*omega0 +
/// 153*Omega)/(4900*omega0)*harmonic_re_x_F2*F^2 - 283/20244*harmonic_re_x_F4*F^4 + i*harmonic_im_x_F2*F^2
struct harmonic_2_Omega_of_x : BlockShape<5, 6, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 6> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    return {711.0 / 39200.0, -87.0 / 35.0, -1.0 / 70.0, (-459.0 * omega0 + 153.0 * Omega) / (4900.0 * omega0),
        -283.0 / 20244.0, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (norm_A_x * F * F);  // harmonic_re_x_A_x2_F2
    column[1] = factor[1] * (A_x * A_x * A_x * F);  // harmonic_re_x_A_x_conjA_x2_F
    column[2] = factor[2] * (F * F) + factor[3] * (F * F);  // harmonic_re_x_F2
    column[3] = factor[4] * (norm_F * F * F);  // harmonic_re_x_F4
    column[4] = times_i(factor[5] * (F * F));  // harmonic_im_x_F2
  }
};

/// amplitude of exp(i*(3*Omega)*t) in x = 1/(160*omega0)*conservative_x_A_x2_conjA_x_F2*A_x^3*F^2 +
/// 23/(1800*omega0)*conservative_x_conjA_x2_F3*A_x*conj(A_x)*F^3 + 1/30*harmonic_re_x_F3*F^3 +
/// harmonic_re_x_F3*F^3 + (117*omega0 - 39*Omega)/(400*omega0)*harmonic_re_x_F3*F^3 +
/// 11/200*i*harmonic_im_x_F3*F^3 + 16/455*harmonic_re_x_F5*F^5
struct harmonic_3_Omega_of_x : BlockShape<5, 7, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 7> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    return {1.0 / (160.0 * omega0), 23.0 / (1800.0 * omega0), 1.0 / 30.0, 1.0,
        (117.0 * omega0 - 39.0 * Omega) / (400.0 * omega0), 11.0 / 200.0, 16.0 / 455.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_x * A_x * A_x * F * F);  // conservative_x_A_x2_conjA_x_F2
    column[1] = factor[1] * (norm_A_x * F * F * F);  // conservative_x_conjA_x2_F3
    column[2] = factor[2] * (F * F * F) + factor[3] * (F * F * F) + factor[4] * (F * F * F);  // harmonic_re_x_F3
    column[3] = times_i(factor[5] * (F * F * F));  // harmonic_im_x_F3
    column[4] = factor[6] * (norm_F * F * F * F);  // harmonic_re_x_F5
  }
};

/// amplitude of exp(i*(omega0 + Omega)*t) in x = -24*omega0^4/(Omega*(omega0 + Omega)*(omega0 - Omega)*(2*omega0
/// + Omega))*harmonic_re_x_conjA_x_F*A_x*F + (-720*omega0^11 + 456*omega0^10*Omega + 3168*omega0^9*Omega^2 -
/// 3072*omega0^8*Omega^3 + 576*omega0^7*Omega^4 - 192*omega0^6*Omega^5)/(Omega*(omega0 + Omega)^2*(omega0 +
/// 2*Omega)*(omega0 - Omega)^3*(omega0 - 2*Omega)^2*(2*omega0 - Omega)*(3*omega0 -
/// 2*Omega))*harmonic_re_x_A_x2_F2*conj(A_x)^2*F^2 - 288*omega0^7/(Omega^2*(omega0 + Omega)*(omega0 -
/// Omega)^2*(2*omega0 + Omega)^2)*harmonic_re_x_A_x2_F2*conj(A_x)^2*F^2 + 64*omega0^5/((omega0 +
/// Omega)^2*(omega0 - Omega)^2*(2*omega0 + Omega))*i*harmonic_im_x_conjA_x_F*A_x*F + (64512*omega0^15 +
/// 1419264*omega0^14*Omega - 499968*omega0^13*Omega^2 - 6015744*omega0^12*Omega^3 + 1096704*omega0^11*Omega^4 +
/// 4386816*omega0^10*Omega^5 - 516096*omega0^9*Omega^6 - 516096*omega0^8*Omega^7)/(11*Omega^2*(omega0 +
/// Omega)^4*(omega0 + 2*Omega)*(omega0 - Omega)^4*(omega0 - 2*Omega)*(2*omega0 + Omega)^2*(2*omega0 -
/// Omega))*harmonic_re_x_conjA_x_F3*A_x*F^3 + (-74880*omega0^9 - 28320*omega0^8*Omega + 61920*omega0^7*Omega^2 +
/// 17760*omega0^6*Omega^3 - 8640*omega0^5*Omega^4 - 2400*omega0^4*Omega^5)/(Omega*(omega0 + Omega)^2*(omega0 -
/// Omega)^2*(2*omega0 + Omega)^2*(2*omega0 - Omega)*(3*omega0 +
/// Omega))*harmonic_re_x_A_x_conjA_x2_F*A_x^2*conj(A_x)*F - 1/31*harmonic_re_x_A_x3_conjA_x*A_x^4
struct harmonic_omega0_plus_Omega_of_x : BlockShape<6, 7, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 7> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    const Number omega0_3 = omega0_2 * omega0;
    const Number omega0_4 = omega0_3 * omega0;
    const Number omega0_5 = omega0_4 * omega0;
    const Number omega0_6 = omega0_5 * omega0;
    const Number omega0_7 = omega0_6 * omega0;
    const Number omega0_8 = omega0_7 * omega0;
    const Number omega0_9 = omega0_8 * omega0;
    const Number omega0_10 = omega0_9 * omega0;
    const Number omega0_11 = omega0_10 * omega0;
    const Number omega0_12 = omega0_11 * omega0;
    const Number omega0_13 = omega0_12 * omega0;
    const Number omega0_14 = omega0_13 * omega0;
    const Number omega0_15 = omega0_14 * omega0;
    const Number Omega_2 = Omega * Omega;
    const Number Omega_3 = Omega_2 * Omega;
    const Number Omega_4 = Omega_3 * Omega;
    const Number Omega_5 = Omega_4 * Omega;
    const Number Omega_6 = Omega_5 * Omega;
    const Number Omega_7 = Omega_6 * Omega;
    const Number per_0 = 1.0 / (omega0 + Omega);
    const Number per_0_2 = per_0 * per_0;
    const Number per_0_3 = per_0_2 * per_0;
    const Number per_0_4 = per_0_3 * per_0;
    const Number per_1 = 1.0 / (omega0 - Omega);
    const Number per_1_2 = per_1 * per_1;
    const Number per_1_3 = per_1_2 * per_1;
    const Number per_1_4 = per_1_3 * per_1;
    const Number per_2 = 1.0 / (2.0 * omega0 + Omega);
    const Number per_2_2 = per_2 * per_2;
    const Number per_3 = 1.0 / (omega0 + 2.0 * Omega);
    const Number per_4 = 1.0 / (omega0 - 2.0 * Omega);
    const Number per_4_2 = per_4 * per_4;
    const Number per_5 = 1.0 / (2.0 * omega0 - Omega);
    const Number per_6 = 1.0 / (3.0 * omega0 - 2.0 * Omega);
    const Number per_7 = 1.0 / (3.0 * omega0 + Omega);
    const Number over_0 = per_0 * per_1 * per_2;
    const Number over_1 = per_0_2 * per_3 * per_1_3 * per_4_2 * per_5 * per_6;
    const Number over_2 = per_0 * per_1_2 * per_2_2;
    const Number over_3 = per_0_2 * per_1_2 * per_2;
    const Number over_4 = per_0_4 * per_3 * per_1_4 * per_4 * per_2_2 * per_5;
    const Number over_5 = per_0_2 * per_1_2 * per_2_2 * per_5 * per_7;
    return {-24.0 * omega0_4 * over_0 / Omega,
        (-720.0 * omega0_11 + 456.0 * omega0_10 * Omega + 3168.0 * omega0_9 * Omega_2
            - 3072.0 * omega0_8 * Omega_3 + 576.0 * omega0_7 * Omega_4
            - 192.0 * omega0_6 * Omega_5) * over_1 / Omega,
        -288.0 * omega0_7 * over_2 / Omega_2, 64.0 * omega0_5 * over_3,
        (64512.0 * omega0_15 + 1419264.0 * omega0_14 * Omega - 499968.0 * omega0_13 * Omega_2
            - 6015744.0 * omega0_12 * Omega_3 + 1096704.0 * omega0_11 * Omega_4 + 4386816.0 * omega0_10 * Omega_5
            - 516096.0 * omega0_9 * Omega_6 - 516096.0 * omega0_8 * Omega_7) * over_4 / (11.0 * Omega_2),
        (-74880.0 * omega0_9 - 28320.0 * omega0_8 * Omega + 61920.0 * omega0_7 * Omega_2
            + 17760.0 * omega0_6 * Omega_3 - 8640.0 * omega0_5 * Omega_4
            - 2400.0 * omega0_4 * Omega_5) * over_5 / Omega,
        -1.0 / 31.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_x * F);  // harmonic_re_x_conjA_x_F
    // harmonic_re_x_A_x2_F2
    column[1] = factor[1] * (conj_A_x * conj_A_x * F * F) + factor[2] * (conj_A_x * conj_A_x * F * F);
    column[2] = times_i(factor[3] * (A_x * F));  // harmonic_im_x_conjA_x_F
    column[3] = factor[4] * (A_x * norm_F * F);  // harmonic_re_x_conjA_x_F3
    column[4] = factor[5] * (norm_A_x * A_x * F);  // harmonic_re_x_A_x_conjA_x2_F
    column[5] = factor[6] * fixed_power<4>(A_x);  // harmonic_re_x_A_x3_conjA_x
  }
};

/// amplitude of exp(i*(omega0 + 2*Omega)*t) in x = (-60*omega0^5 - 16*omega0^4*Omega -
/// 4*omega0^3*Omega^2)/((omega0 + Omega)^2*(omega0 - Omega)*(3*omega0 + Omega)^2*(5*omega0 +
/// Omega))*conservative_x_A_x4_F*A_x^4*F - 32*omega0^6/(3*Omega*(omega0 + Omega)^3*(omega0 -
/// Omega)^2)*conservative_x_A_x_F2_sigma*A_x*F^2 + (360448*omega0^13 - 98304*omega0^12*Omega -
/// 2719744*omega0^11*Omega^2 + 884736*omega0^10*Omega^3)/(21*Omega*(omega0 + Omega)^6*(omega0 + 3*Omega)*(omega0
/// - Omega)^5*(omega0 - 3*Omega))*conservative_x_A_x_F4*A_x*F^4 + (-4992*omega0^8 - 2112*omega0^7*Omega +
/// 192*omega0^6*Omega^2)/(7*Omega*(omega0 + Omega)^4*(omega0 - Omega)^3*(3*omega0 +
/// Omega))*conservative_x_A_x2_conjA_x_F2*A_x^2*conj(A_x)*F^2 + (6144*omega0^11 + 4096*omega0^10*Omega -
/// 59392*omega0^9*Omega^2)/(27*Omega*(omega0 + Omega)^3*(omega0 + 3*Omega)*(omega0 - Omega)^5*(omega0 -
/// 3*Omega)^2)*conservative_x_conjA_x2_F3*conj(A_x)^2*F^3 + (256*omega0^9 +
/// 512*omega0^8*Omega)/(3*Omega^2*(omega0 + Omega)^5*(omega0 -
/// Omega)^3)*conservative_x_conjA_x2_F3*conj(A_x)^2*F^3 + (80640*omega0^10 - 80640*omega0^9*Omega -
/// 362880*omega0^8*Omega^2)/(73*Omega^2*(omega0 + Omega)^3*(omega0 + 2*Omega)*(omega0 - Omega)^2*(omega0 -
/// 2*Omega)*(2*omega0 + Omega))*harmonic_re_x_conjA_x_F2*A_x*F^2 - 1024*omega0^7/((omega0 + Omega)^4*(omega0 -
/// Omega)^3)*i*harmonic_im_x_conjA_x_F2*A_x*F^2
struct harmonic_omega0_plus_2_Omega_of_x : BlockShape<7, 8, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 8> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    const Number omega0_3 = omega0_2 * omega0;
    const Number omega0_4 = omega0_3 * omega0;
    const Number omega0_5 = omega0_4 * omega0;
    const Number omega0_6 = omega0_5 * omega0;
    const Number omega0_7 = omega0_6 * omega0;
    const Number omega0_8 = omega0_7 * omega0;
    const Number omega0_9 = omega0_8 * omega0;
    const Number omega0_10 = omega0_9 * omega0;
    const Number omega0_11 = omega0_10 * omega0;
    const Number omega0_12 = omega0_11 * omega0;
    const Number omega0_13 = omega0_12 * omega0;
    const Number Omega_2 = Omega * Omega;
    const Number Omega_3 = Omega_2 * Omega;
    const Number per_0 = 1.0 / (omega0 + Omega);
    const Number per_0_2 = per_0 * per_0;
    const Number per_0_3 = per_0_2 * per_0;
    const Number per_0_4 = per_0_3 * per_0;
    const Number per_0_5 = per_0_4 * per_0;
    const Number per_0_6 = per_0_5 * per_0;
    const Number per_1 = 1.0 / (omega0 - Omega);
    const Number per_1_2 = per_1 * per_1;
    const Number per_1_3 = per_1_2 * per_1;
    const Number per_1_4 = per_1_3 * per_1;
    const Number per_1_5 = per_1_4 * per_1;
    const Number per_2 = 1.0 / (3.0 * omega0 + Omega);
    const Number per_2_2 = per_2 * per_2;
    const Number per_3 = 1.0 / (5.0 * omega0 + Omega);
    const Number per_4 = 1.0 / (omega0 + 3.0 * Omega);
    const Number per_5 = 1.0 / (omega0 - 3.0 * Omega);
    const Number per_5_2 = per_5 * per_5;
    const Number per_6 = 1.0 / (omega0 + 2.0 * Omega);
    const Number per_7 = 1.0 / (omega0 - 2.0 * Omega);
    const Number per_8 = 1.0 / (2.0 * omega0 + Omega);
    const Number over_0 = per_0_2 * per_1 * per_2_2 * per_3;
    const Number over_1 = per_0_3 * per_1_2;
    const Number over_2 = per_0_6 * per_4 * per_1_5 * per_5;
    const Number over_3 = per_0_4 * per_1_3 * per_2;
    const Number over_4 = per_0_3 * per_4 * per_1_5 * per_5_2;
    const Number over_5 = per_0_5 * per_1_3;
    const Number over_6 = per_0_3 * per_6 * per_1_2 * per_7 * per_8;
    const Number over_7 = per_0_4 * per_1_3;
    return {(-60.0 * omega0_5 - 16.0 * omega0_4 * Omega - 4.0 * omega0_3 * Omega_2) * over_0,
        -32.0 * omega0_6 * over_1 / (3.0 * Omega),
        (360448.0 * omega0_13 - 98304.0 * omega0_12 * Omega - 2719744.0 * omega0_11 * Omega_2
            + 884736.0 * omega0_10 * Omega_3) * over_2 / (21.0 * Omega),
        (-4992.0 * omega0_8 - 2112.0 * omega0_7 * Omega + 192.0 * omega0_6 * Omega_2) * over_3 / (7.0 * Omega),
        (6144.0 * omega0_11 + 4096.0 * omega0_10 * Omega
            - 59392.0 * omega0_9 * Omega_2) * over_4 / (27.0 * Omega),
        (256.0 * omega0_9 + 512.0 * omega0_8 * Omega) * over_5 / (3.0 * Omega_2),
        (80640.0 * omega0_10 - 80640.0 * omega0_9 * Omega
            - 362880.0 * omega0_8 * Omega_2) * over_6 / (73.0 * Omega_2),
        -1024.0 * omega0_7 * over_7};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (fixed_power<4>(A_x) * F);  // conservative_x_A_x4_F
    column[1] = factor[1] * (A_x * F * F);  // conservative_x_A_x_F2_sigma
    column[2] = factor[2] * (A_x * norm_F * F * F);  // conservative_x_A_x_F4
    column[3] = factor[3] * (norm_A_x * A_x * F * F);  // conservative_x_A_x2_conjA_x_F2
    // conservative_x_conjA_x2_F3
    column[4] = factor[4] * (conj_A_x * conj_A_x * F * F * F) + factor[5] * (conj_A_x * conj_A_x * F * F * F);
    column[5] = factor[6] * (A_x * F * F);  // harmonic_re_x_conjA_x_F2
    column[6] = times_i(factor[7] * (A_x * F * F));  // harmonic_im_x_conjA_x_F2
  }
};

/// amplitude of exp(i*(-omega0 + 3*Omega)*t) in x = (2160*omega0^12 + 2664*omega0^11*Omega -
/// 8760*omega0^10*Omega^2 - 14688*omega0^9*Omega^3 - 5952*omega0^8*Omega^4 - 1152*omega0^7*Omega^5 -
/// 192*omega0^6*Omega^6)/(Omega*(omega0 + Omega)^3*(omega0 + 2*Omega)^2*(omega0 - Omega)^2*(omega0 -
/// 2*Omega)*(2*omega0 + Omega)*(3*omega0 + Omega)*(3*omega0 + 2*Omega))*harmonic_re_x_A_x2_F2*A_x^2*F^2 +
/// (-32256*omega0^15 - 30464*omega0^14*Omega + 505344*omega0^13*Omega^2 + 66304*omega0^12*Omega^3 -
/// 1827840*omega0^11*Omega^4 + 1189888*omega0^10*Omega^5)/(11*Omega^2*(omega0 + Omega)^3*(omega0 +
/// 2*Omega)*(omega0 + 3*Omega)*(omega0 - Omega)^4*(omega0 - 2*Omega)*(omega0 - 3*Omega)*(2*omega0 -
/// Omega)*(2*omega0 - 3*Omega))*harmonic_re_x_conjA_x_F3*conj(A_x)*F^3
struct harmonic_minus_omega0_plus_3_Omega_of_x : BlockShape<2, 2, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    const Number omega0_3 = omega0_2 * omega0;
    const Number omega0_4 = omega0_3 * omega0;
    const Number omega0_5 = omega0_4 * omega0;
    const Number omega0_6 = omega0_5 * omega0;
    const Number omega0_7 = omega0_6 * omega0;
    const Number omega0_8 = omega0_7 * omega0;
    const Number omega0_9 = omega0_8 * omega0;
    const Number omega0_10 = omega0_9 * omega0;
    const Number omega0_11 = omega0_10 * omega0;
    const Number omega0_12 = omega0_11 * omega0;
    const Number omega0_13 = omega0_12 * omega0;
    const Number omega0_14 = omega0_13 * omega0;
    const Number omega0_15 = omega0_14 * omega0;
    const Number Omega_2 = Omega * Omega;
    const Number Omega_3 = Omega_2 * Omega;
    const Number Omega_4 = Omega_3 * Omega;
    const Number Omega_5 = Omega_4 * Omega;
    const Number Omega_6 = Omega_5 * Omega;
    const Number per_0 = 1.0 / (omega0 + Omega);
    const Number per_0_2 = per_0 * per_0;
    const Number per_0_3 = per_0_2 * per_0;
    const Number per_1 = 1.0 / (omega0 + 2.0 * Omega);
    const Number per_1_2 = per_1 * per_1;
    const Number per_2 = 1.0 / (omega0 - Omega);
    const Number per_2_2 = per_2 * per_2;
    const Number per_2_3 = per_2_2 * per_2;
    const Number per_2_4 = per_2_3 * per_2;
    const Number per_3 = 1.0 / (omega0 - 2.0 * Omega);
    const Number per_4 = 1.0 / (2.0 * omega0 + Omega);
    const Number per_5 = 1.0 / (3.0 * omega0 + Omega);
    const Number per_6 = 1.0 / (3.0 * omega0 + 2.0 * Omega);
    const Number per_7 = 1.0 / (omega0 + 3.0 * Omega);
    const Number per_8 = 1.0 / (omega0 - 3.0 * Omega);
    const Number per_9 = 1.0 / (2.0 * omega0 - Omega);
    const Number per_10 = 1.0 / (2.0 * omega0 - 3.0 * Omega);
    const Number over_0 = per_0_3 * per_1_2 * per_2_2 * per_3 * per_4 * per_5 * per_6;
    const Number over_1 = per_0_3 * per_1 * per_7 * per_2_4 * per_3 * per_8 * per_9 * per_10;
    return {(2160.0 * omega0_12 + 2664.0 * omega0_11 * Omega - 8760.0 * omega0_10 * Omega_2
        - 14688.0 * omega0_9 * Omega_3 - 5952.0 * omega0_8 * Omega_4 - 1152.0 * omega0_7 * Omega_5
        - 192.0 * omega0_6 * Omega_6) * over_0 / Omega,
        (-32256.0 * omega0_15 - 30464.0 * omega0_14 * Omega + 505344.0 * omega0_13 * Omega_2
            + 66304.0 * omega0_12 * Omega_3 - 1827840.0 * omega0_11 * Omega_4
            + 1189888.0 * omega0_10 * Omega_5) * over_1 / (11.0 * Omega_2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_x * A_x * F * F);  // harmonic_re_x_A_x2_F2
    column[1] = factor[1] * (conj_A_x * F * F * F);  // harmonic_re_x_conjA_x_F3
  }
};

/// amplitude of exp(i*(-omega0 + 4*Omega)*t) in x = (-12288*omega0^13 - 32768*omega0^12*Omega +
/// 143360*omega0^11*Omega^2)/(21*Omega^2*(omega0 + Omega)^4*(omega0 + 3*Omega)*(omega0 - Omega)^5*(omega0 -
/// 2*Omega)*(omega0 - 3*Omega))*conservative_x_A_x_F4*conj(A_x)*F^4 + (-18432*omega0^11 + 12288*omega0^10*Omega
/// + 169984*omega0^9*Omega^2)/(27*Omega*(omega0 + Omega)^4*(omega0 + 3*Omega)^2*(omega0 - Omega)^3*(omega0 -
/// 3*Omega)*(3*omega0 + Omega))*conservative_x_conjA_x2_F3*A_x^2*F^3
struct harmonic_minus_omega0_plus_4_Omega_of_x : BlockShape<2, 2, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    const Number omega0_3 = omega0_2 * omega0;
    const Number omega0_4 = omega0_3 * omega0;
    const Number omega0_5 = omega0_4 * omega0;
    const Number omega0_6 = omega0_5 * omega0;
    const Number omega0_7 = omega0_6 * omega0;
    const Number omega0_8 = omega0_7 * omega0;
    const Number omega0_9 = omega0_8 * omega0;
    const Number omega0_10 = omega0_9 * omega0;
    const Number omega0_11 = omega0_10 * omega0;
    const Number omega0_12 = omega0_11 * omega0;
    const Number omega0_13 = omega0_12 * omega0;
    const Number Omega_2 = Omega * Omega;
    const Number per_0 = 1.0 / (omega0 + Omega);
    const Number per_0_2 = per_0 * per_0;
    const Number per_0_3 = per_0_2 * per_0;
    const Number per_0_4 = per_0_3 * per_0;
    const Number per_1 = 1.0 / (omega0 + 3.0 * Omega);
    const Number per_1_2 = per_1 * per_1;
    const Number per_2 = 1.0 / (omega0 - Omega);
    const Number per_2_2 = per_2 * per_2;
    const Number per_2_3 = per_2_2 * per_2;
    const Number per_2_4 = per_2_3 * per_2;
    const Number per_2_5 = per_2_4 * per_2;
    const Number per_3 = 1.0 / (omega0 - 2.0 * Omega);
    const Number per_4 = 1.0 / (omega0 - 3.0 * Omega);
    const Number per_5 = 1.0 / (3.0 * omega0 + Omega);
    const Number over_0 = per_0_4 * per_1 * per_2_5 * per_3 * per_4;
    const Number over_1 = per_0_4 * per_1_2 * per_2_3 * per_4 * per_5;
    return {(-12288.0 * omega0_13 - 32768.0 * omega0_12 * Omega
        + 143360.0 * omega0_11 * Omega_2) * over_0 / (21.0 * Omega_2),
        (-18432.0 * omega0_11 + 12288.0 * omega0_10 * Omega
            + 169984.0 * omega0_9 * Omega_2) * over_1 / (27.0 * Omega)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (conj_A_x * fixed_power<4>(F));  // conservative_x_A_x_F4
    column[1] = factor[1] * (A_x * A_x * F * F * F);  // conservative_x_conjA_x2_F3
  }
};

/// amplitude of exp(i*(4*Omega)*t) in x = (1433600*omega0^14 - 10035200*omega0^12*Omega^2)/(723*(omega0 +
/// Omega)^4*(omega0 + 2*Omega)*(omega0 + 3*Omega)*(omega0 + 4*Omega)*(omega0 - Omega)^4*(omega0 -
/// 2*Omega)*(omega0 - 3*Omega)*(omega0 - 4*Omega))*harmonic_re_x_F4*F^4
struct harmonic_4_Omega_of_x : BlockShape<1, 1, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    const Number omega0_3 = omega0_2 * omega0;
    const Number omega0_4 = omega0_3 * omega0;
    const Number omega0_5 = omega0_4 * omega0;
    const Number omega0_6 = omega0_5 * omega0;
    const Number omega0_7 = omega0_6 * omega0;
    const Number omega0_8 = omega0_7 * omega0;
    const Number omega0_9 = omega0_8 * omega0;
    const Number omega0_10 = omega0_9 * omega0;
    const Number omega0_11 = omega0_10 * omega0;
    const Number omega0_12 = omega0_11 * omega0;
    const Number omega0_13 = omega0_12 * omega0;
    const Number omega0_14 = omega0_13 * omega0;
    const Number Omega_2 = Omega * Omega;
    const Number per_0 = 1.0 / (omega0 + Omega);
    const Number per_0_2 = per_0 * per_0;
    const Number per_0_3 = per_0_2 * per_0;
    const Number per_0_4 = per_0_3 * per_0;
    const Number per_1 = 1.0 / (omega0 + 2.0 * Omega);
    const Number per_2 = 1.0 / (omega0 + 3.0 * Omega);
    const Number per_3 = 1.0 / (omega0 + 4.0 * Omega);
    const Number per_4 = 1.0 / (omega0 - Omega);
    const Number per_4_2 = per_4 * per_4;
    const Number per_4_3 = per_4_2 * per_4;
    const Number per_4_4 = per_4_3 * per_4;
    const Number per_5 = 1.0 / (omega0 - 2.0 * Omega);
    const Number per_6 = 1.0 / (omega0 - 3.0 * Omega);
    const Number per_7 = 1.0 / (omega0 - 4.0 * Omega);
    const Number over_0 = per_0_4 * per_1 * per_2 * per_3 * per_4_4 * per_5 * per_6 * per_7;
    return {(1433600.0 * omega0_14 - 10035200.0 * omega0_12 * Omega_2) * over_0 / 723.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * fixed_power<4>(F);  // harmonic_re_x_F4
  }
};

/// amplitude of exp(i*(5*Omega)*t) in x = -20971520*omega0^14/(91*(omega0 + Omega)^5*(omega0 + 3*Omega)*(omega0
/// + 5*Omega)*(omega0 - Omega)^5*(omega0 - 3*Omega)*(omega0 - 5*Omega))*harmonic_re_x_F5*F^5
struct harmonic_5_Omega_of_x : BlockShape<1, 1, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    const Number omega0_3 = omega0_2 * omega0;
    const Number omega0_4 = omega0_3 * omega0;
    const Number omega0_5 = omega0_4 * omega0;
    const Number omega0_6 = omega0_5 * omega0;
    const Number omega0_7 = omega0_6 * omega0;
    const Number omega0_8 = omega0_7 * omega0;
    const Number omega0_9 = omega0_8 * omega0;
    const Number omega0_10 = omega0_9 * omega0;
    const Number omega0_11 = omega0_10 * omega0;
    const Number omega0_12 = omega0_11 * omega0;
    const Number omega0_13 = omega0_12 * omega0;
    const Number omega0_14 = omega0_13 * omega0;
    const Number per_0 = 1.0 / (omega0 + Omega);
    const Number per_0_2 = per_0 * per_0;
    const Number per_0_3 = per_0_2 * per_0;
    const Number per_0_4 = per_0_3 * per_0;
    const Number per_0_5 = per_0_4 * per_0;
    const Number per_1 = 1.0 / (omega0 + 3.0 * Omega);
    const Number per_2 = 1.0 / (omega0 + 5.0 * Omega);
    const Number per_3 = 1.0 / (omega0 - Omega);
    const Number per_3_2 = per_3 * per_3;
    const Number per_3_3 = per_3_2 * per_3;
    const Number per_3_4 = per_3_3 * per_3;
    const Number per_3_5 = per_3_4 * per_3;
    const Number per_4 = 1.0 / (omega0 - 3.0 * Omega);
    const Number per_5 = 1.0 / (omega0 - 5.0 * Omega);
    const Number over_0 = per_0_5 * per_1 * per_2 * per_3_5 * per_4 * per_5;
    return {-20971520.0 * omega0_14 * over_0 / 91.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * fixed_power<5>(F);  // harmonic_re_x_F5
  }
};

/// amplitude of exp(i*(omega0 + 3*Omega)*t) in x = (-32256*omega0^15 + 30464*omega0^14*Omega +
/// 505344*omega0^13*Omega^2 - 66304*omega0^12*Omega^3 - 1827840*omega0^11*Omega^4 -
/// 1189888*omega0^10*Omega^5)/(11*Omega^2*(omega0 + Omega)^4*(omega0 + 2*Omega)*(omega0 + 3*Omega)*(omega0 -
/// Omega)^3*(omega0 - 2*Omega)*(omega0 - 3*Omega)*(2*omega0 + Omega)*(2*omega0 +
/// 3*Omega))*harmonic_re_x_conjA_x_F3*A_x*F^3
struct harmonic_omega0_plus_3_Omega_of_x : BlockShape<1, 1, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    const Number omega0_3 = omega0_2 * omega0;
    const Number omega0_4 = omega0_3 * omega0;
    const Number omega0_5 = omega0_4 * omega0;
    const Number omega0_6 = omega0_5 * omega0;
    const Number omega0_7 = omega0_6 * omega0;
    const Number omega0_8 = omega0_7 * omega0;
    const Number omega0_9 = omega0_8 * omega0;
    const Number omega0_10 = omega0_9 * omega0;
    const Number omega0_11 = omega0_10 * omega0;
    const Number omega0_12 = omega0_11 * omega0;
    const Number omega0_13 = omega0_12 * omega0;
    const Number omega0_14 = omega0_13 * omega0;
    const Number omega0_15 = omega0_14 * omega0;
    const Number Omega_2 = Omega * Omega;
    const Number Omega_3 = Omega_2 * Omega;
    const Number Omega_4 = Omega_3 * Omega;
    const Number Omega_5 = Omega_4 * Omega;
    const Number per_0 = 1.0 / (omega0 + Omega);
    const Number per_0_2 = per_0 * per_0;
    const Number per_0_3 = per_0_2 * per_0;
    const Number per_0_4 = per_0_3 * per_0;
    const Number per_1 = 1.0 / (omega0 + 2.0 * Omega);
    const Number per_2 = 1.0 / (omega0 + 3.0 * Omega);
    const Number per_3 = 1.0 / (omega0 - Omega);
    const Number per_3_2 = per_3 * per_3;
    const Number per_3_3 = per_3_2 * per_3;
    const Number per_4 = 1.0 / (omega0 - 2.0 * Omega);
    const Number per_5 = 1.0 / (omega0 - 3.0 * Omega);
    const Number per_6 = 1.0 / (2.0 * omega0 + Omega);
    const Number per_7 = 1.0 / (2.0 * omega0 + 3.0 * Omega);
    const Number over_0 = per_0_4 * per_1 * per_2 * per_3_3 * per_4 * per_5 * per_6 * per_7;
    return {(-32256.0 * omega0_15 + 30464.0 * omega0_14 * Omega + 505344.0 * omega0_13 * Omega_2
        - 66304.0 * omega0_12 * Omega_3 - 1827840.0 * omega0_11 * Omega_4
        - 1189888.0 * omega0_10 * Omega_5) * over_0 / (11.0 * Omega_2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_x * F * F * F);  // harmonic_re_x_conjA_x_F3
  }
};

/// amplitude of exp(i*(omega0 + 4*Omega)*t) in x = (-12288*omega0^13 + 32768*omega0^12*Omega +
/// 143360*omega0^11*Omega^2)/(21*Omega^2*(omega0 + Omega)^5*(omega0 + 2*Omega)*(omega0 + 3*Omega)*(omega0 -
/// Omega)^4*(omega0 - 3*Omega))*conservative_x_A_x_F4*A_x*F^4
struct harmonic_omega0_plus_4_Omega_of_x : BlockShape<1, 1, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    const Number omega0_3 = omega0_2 * omega0;
    const Number omega0_4 = omega0_3 * omega0;
    const Number omega0_5 = omega0_4 * omega0;
    const Number omega0_6 = omega0_5 * omega0;
    const Number omega0_7 = omega0_6 * omega0;
    const Number omega0_8 = omega0_7 * omega0;
    const Number omega0_9 = omega0_8 * omega0;
    const Number omega0_10 = omega0_9 * omega0;
    const Number omega0_11 = omega0_10 * omega0;
    const Number omega0_12 = omega0_11 * omega0;
    const Number omega0_13 = omega0_12 * omega0;
    const Number Omega_2 = Omega * Omega;
    const Number per_0 = 1.0 / (omega0 + Omega);
    const Number per_0_2 = per_0 * per_0;
    const Number per_0_3 = per_0_2 * per_0;
    const Number per_0_4 = per_0_3 * per_0;
    const Number per_0_5 = per_0_4 * per_0;
    const Number per_1 = 1.0 / (omega0 + 2.0 * Omega);
    const Number per_2 = 1.0 / (omega0 + 3.0 * Omega);
    const Number per_3 = 1.0 / (omega0 - Omega);
    const Number per_3_2 = per_3 * per_3;
    const Number per_3_3 = per_3_2 * per_3;
    const Number per_3_4 = per_3_3 * per_3;
    const Number per_4 = 1.0 / (omega0 - 3.0 * Omega);
    const Number over_0 = per_0_5 * per_1 * per_2 * per_3_4 * per_4;
    return {(-12288.0 * omega0_13 + 32768.0 * omega0_12 * Omega
        + 143360.0 * omega0_11 * Omega_2) * over_0 / (21.0 * Omega_2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_x * fixed_power<4>(F));  // conservative_x_A_x_F4
  }
};

inline constexpr BlockFunctions blocks[15] = {modulation_functions<Model, modulation_of_x>(),
    harmonic_functions<Model, harmonic_Omega_of_x>(),
    harmonic_functions<Model, harmonic_minus_omega0_plus_Omega_of_x>(),
    harmonic_functions<Model, harmonic_minus_omega0_plus_2_Omega_of_x>(),
    harmonic_functions<Model, harmonic_0_of_x>(), harmonic_functions<Model, harmonic_2_Omega_of_x>(),
    harmonic_functions<Model, harmonic_3_Omega_of_x>(),
    harmonic_functions<Model, harmonic_omega0_plus_Omega_of_x>(),
    harmonic_functions<Model, harmonic_omega0_plus_2_Omega_of_x>(),
    harmonic_functions<Model, harmonic_minus_omega0_plus_3_Omega_of_x>(),
    harmonic_functions<Model, harmonic_minus_omega0_plus_4_Omega_of_x>(),
    harmonic_functions<Model, harmonic_4_Omega_of_x>(), harmonic_functions<Model, harmonic_5_Omega_of_x>(),
    harmonic_functions<Model, harmonic_omega0_plus_3_Omega_of_x>(),
    harmonic_functions<Model, harmonic_omega0_plus_4_Omega_of_x>()};

}  // namespace subharmonic_3_second_order
}  // namespace secular::generated::duffing
