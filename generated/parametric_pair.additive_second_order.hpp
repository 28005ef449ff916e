// Model parametric_pair: generated code, never edited by hand.
// Holds rows of the case additive_second_order. Made by: secular generate parametric_pair.
// Omega = omega1 + omega2 + eps*sigma, multiple scales to eps^2. Valid near that resonance for small
// amplitudes; what is left out is of order eps^3.
#pragma once

#include "parametric_pair.hpp"

namespace secular::generated::parametric_pair {

namespace additive_second_order {

/// (rate - i*omega1)*A_x = i*conservative_x_A_x2_A_y_F*A_x^2*A_y*F - mu1*A_x + i*conservative_x_A_x*A_x +
/// i*conservative_x_A_x_F2*A_x*F^2 + dissipative_x_A_x_A_y_conjA_y*A_x*A_y*conj(A_y) +
/// 1/omega1*i*b3*A_x*A_y*conj(A_y) + i*conservative_x_A_x_A_y2_conjA_y2*A_x*A_y^2*conj(A_y)^2 +
/// dissipative_x_A_x2_conjA_x*A_x^2*conj(A_x) + 3/(2*omega1)*i*b1*A_x^2*conj(A_x) +
/// i*conservative_x_A_x2_A_y_conjA_x_conjA_y*A_x^2*conj(A_x)*A_y*conj(A_y) +
/// i*conservative_x_A_x3_conjA_x2*A_x^3*conj(A_x)^2 + dissipative_x_conjA_y_F*conj(A_y)*F -
/// 1/(4*omega1)*i*p*conj(A_y)*F + (-omega1 - omega2 + Omega)/(8*omega1^2)*i*p*conj(A_y)*F +
/// i*conservative_x_A_y_conjA_y2_F*A_y*conj(A_y)^2*F +
/// i*conservative_x_A_x_conjA_x_conjA_y_F*A_x*conj(A_x)*conj(A_y)*F
struct modulation_of_x : BlockShape<15, 6, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 6> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    return {1.0, -1.0, 1.0 / omega1, 3.0 / (2.0 * omega1), -1.0 / (4.0 * omega1),
        (-omega1 - omega2 + Omega) / (8.0 * omega1_2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    column[0] = times_i(factor[0] * (A_x * A_x * A_y * conj_F));  // conservative_x_A_x2_A_y_F
    column[1] = factor[1] * A_x;  // mu1
    column[2] = times_i(factor[0] * A_x);  // conservative_x_A_x
    column[3] = times_i(factor[0] * (A_x * norm_F));  // conservative_x_A_x_F2
    column[4] = factor[0] * (A_x * norm_A_y);  // dissipative_x_A_x_A_y_conjA_y
    column[5] = times_i(factor[2] * (A_x * norm_A_y));  // b3
    column[6] = times_i(factor[0] * (A_x * norm_A_y * norm_A_y));  // conservative_x_A_x_A_y2_conjA_y2
    column[7] = factor[0] * (norm_A_x * A_x);  // dissipative_x_A_x2_conjA_x
    column[8] = times_i(factor[3] * (norm_A_x * A_x));  // b1
    column[9] = times_i(factor[0] * (norm_A_x * A_x * norm_A_y));  // conservative_x_A_x2_A_y_conjA_x_conjA_y
    column[10] = times_i(factor[0] * (norm_A_x * norm_A_x * A_x));  // conservative_x_A_x3_conjA_x2
    column[11] = factor[0] * (conj_A_y * F);  // dissipative_x_conjA_y_F
    column[12] = times_i(factor[4] * (conj_A_y * F)) + times_i(factor[5] * (conj_A_y * F));  // p
    column[13] = times_i(factor[0] * (norm_A_y * conj_A_y * F));  // conservative_x_A_y_conjA_y2_F
    column[14] = times_i(factor[0] * (norm_A_x * conj_A_y * F));  // conservative_x_A_x_conjA_x_conjA_y_F
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    by[0] = ComplexNumber<double>(lump[1] * factor[1] + lump[4] * factor[0] * norm_A_y
        + 2.0 * lump[7] * factor[0] * norm_A_x, lump[2] * factor[0] + lump[3] * factor[0] * norm_F
        + lump[5] * factor[2] * norm_A_y + lump[6] * factor[0] * (norm_A_y * norm_A_y)
        + 2.0 * lump[8] * factor[3] * norm_A_x + 2.0 * lump[9] * factor[0] * (norm_A_x * norm_A_y)
        + 3.0 * lump[10] * factor[0] * (norm_A_x * norm_A_x))
        + times_i(2.0 * lump[0] * factor[0] * (A_x * A_y * conj_F)
        + lump[14] * factor[0] * (conj_A_x * conj_A_y * F));
    by_conjugate[0] = lump[7] * factor[0] * (A_x * A_x) + times_i(lump[8] * factor[3] * (A_x * A_x)
        + lump[9] * factor[0] * (A_x * A_x * norm_A_y) + 2.0 * lump[10] * factor[0] * (norm_A_x * A_x * A_x)
        + lump[14] * factor[0] * (A_x * conj_A_y * F));
    by[1] = lump[4] * factor[0] * (A_x * conj_A_y) + times_i(lump[0] * factor[0] * (A_x * A_x * conj_F)
        + lump[5] * factor[2] * (A_x * conj_A_y) + 2.0 * lump[6] * factor[0] * (A_x * norm_A_y * conj_A_y)
        + lump[9] * factor[0] * (norm_A_x * A_x * conj_A_y) + lump[13] * factor[0] * (conj_A_y * conj_A_y * F));
    by_conjugate[1] = lump[4] * factor[0] * (A_x * A_y) + lump[11] * factor[0] * F
        + times_i(lump[5] * factor[2] * (A_x * A_y) + 2.0 * lump[6] * factor[0] * (A_x * norm_A_y * A_y)
        + lump[9] * factor[0] * (norm_A_x * A_x * A_y) + lump[12] * factor[4] * F + lump[12] * factor[5] * F
        + 2.0 * lump[13] * factor[0] * (norm_A_y * F) + lump[14] * factor[0] * (norm_A_x * F));
  }
};

/// (rate - i*omega2)*A_y = (2*omega1^2 + omega1*omega2)/(omega2*(omega1 +
/// 2*omega2))*i*conservative_x_A_x_F2*A_y*F^2 + 1/omega2*i*b3*A_x*conj(A_x)*A_y + (2*omega1^5 -
/// 3*omega1^3*omega2^2)/(omega2^3*(3*omega1^2 -
/// 2*omega2^2))*i*conservative_x_A_x_A_y2_conjA_y2*A_x^2*conj(A_x)^2*A_y +
/// i*conservative_y_A_x_A_y2_F*A_x*A_y^2*F - mu2*A_y + i*conservative_y_A_y*A_y +
/// dissipative_y_A_y2_conjA_y*A_y^2*conj(A_y) + 3/(2*omega2)*i*b5*A_y^2*conj(A_y) +
/// i*conservative_y_A_y3_conjA_y2*A_y^3*conj(A_y)^2 + dissipative_y_A_x_A_y_conjA_x*A_x*conj(A_x)*A_y +
/// i*conservative_y_A_x_A_y2_conjA_x_conjA_y*A_x*conj(A_x)*A_y^2*conj(A_y) + dissipative_y_conjA_x_F*conj(A_x)*F
/// - 1/(4*omega2)*i*q*conj(A_x)*F + (-omega1 - omega2 + Omega)/(8*omega2^2)*i*q*conj(A_x)*F +
/// i*conservative_y_A_y_conjA_x_conjA_y_F*conj(A_x)*A_y*conj(A_y)*F +
/// i*conservative_y_A_x_conjA_x2_F*A_x*conj(A_x)^2*F
struct modulation_of_y : BlockShape<15, 8, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 8> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number omega1_3 = omega1_2 * omega1;
    const Number omega1_4 = omega1_3 * omega1;
    const Number omega1_5 = omega1_4 * omega1;
    const Number omega2_2 = omega2 * omega2;
    const Number omega2_3 = omega2_2 * omega2;
    const Number per_0 = 1.0 / (omega1 + 2.0 * omega2);
    const Number per_1 = 1.0 / (3.0 * omega1_2 - 2.0 * omega2_2);
    return {(2.0 * omega1_2 + omega1 * omega2) * per_0 / omega2, 1.0 / omega2,
        (2.0 * omega1_5 - 3.0 * omega1_3 * omega2_2) * per_1 / omega2_3, 1.0, -1.0, 3.0 / (2.0 * omega2),
        -1.0 / (4.0 * omega2), (-omega1 - omega2 + Omega) / (8.0 * omega2_2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    column[0] = times_i(factor[0] * (A_y * norm_F));  // conservative_x_A_x_F2
    column[1] = times_i(factor[1] * (norm_A_x * A_y));  // b3
    column[2] = times_i(factor[2] * (norm_A_x * norm_A_x * A_y));  // conservative_x_A_x_A_y2_conjA_y2
    column[3] = times_i(factor[3] * (A_x * A_y * A_y * conj_F));  // conservative_y_A_x_A_y2_F
    column[4] = factor[4] * A_y;  // mu2
    column[5] = times_i(factor[3] * A_y);  // conservative_y_A_y
    column[6] = factor[3] * (norm_A_y * A_y);  // dissipative_y_A_y2_conjA_y
    column[7] = times_i(factor[5] * (norm_A_y * A_y));  // b5
    column[8] = times_i(factor[3] * (norm_A_y * norm_A_y * A_y));  // conservative_y_A_y3_conjA_y2
    column[9] = factor[3] * (norm_A_x * A_y);  // dissipative_y_A_x_A_y_conjA_x
    column[10] = times_i(factor[3] * (norm_A_x * norm_A_y * A_y));  // conservative_y_A_x_A_y2_conjA_x_conjA_y
    column[11] = factor[3] * (conj_A_x * F);  // dissipative_y_conjA_x_F
    column[12] = times_i(factor[6] * (conj_A_x * F)) + times_i(factor[7] * (conj_A_x * F));  // q
    column[13] = times_i(factor[3] * (conj_A_x * norm_A_y * F));  // conservative_y_A_y_conjA_x_conjA_y_F
    column[14] = times_i(factor[3] * (norm_A_x * conj_A_x * F));  // conservative_y_A_x_conjA_x2_F
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    by[0] = lump[9] * factor[3] * (conj_A_x * A_y) + times_i(lump[1] * factor[1] * (conj_A_x * A_y)
        + 2.0 * lump[2] * factor[2] * (norm_A_x * conj_A_x * A_y) + lump[3] * factor[3] * (A_y * A_y * conj_F)
        + lump[10] * factor[3] * (conj_A_x * norm_A_y * A_y) + lump[14] * factor[3] * (conj_A_x * conj_A_x * F));
    by_conjugate[0] = lump[9] * factor[3] * (A_x * A_y) + lump[11] * factor[3] * F
        + times_i(lump[1] * factor[1] * (A_x * A_y) + 2.0 * lump[2] * factor[2] * (norm_A_x * A_x * A_y)
        + lump[10] * factor[3] * (A_x * norm_A_y * A_y) + lump[12] * factor[6] * F + lump[12] * factor[7] * F
        + lump[13] * factor[3] * (norm_A_y * F) + 2.0 * lump[14] * factor[3] * (norm_A_x * F));
    by[1] = ComplexNumber<double>(lump[4] * factor[4] + 2.0 * lump[6] * factor[3] * norm_A_y
        + lump[9] * factor[3] * norm_A_x, lump[0] * factor[0] * norm_F + lump[1] * factor[1] * norm_A_x
        + lump[2] * factor[2] * (norm_A_x * norm_A_x) + lump[5] * factor[3] + 2.0 * lump[7] * factor[5] * norm_A_y
        + 3.0 * lump[8] * factor[3] * (norm_A_y * norm_A_y) + 2.0 * lump[10] * factor[3] * (norm_A_x * norm_A_y))
        + times_i(2.0 * lump[3] * factor[3] * (A_x * A_y * conj_F)
        + lump[13] * factor[3] * (conj_A_x * conj_A_y * F));
    by_conjugate[1] = lump[6] * factor[3] * (A_y * A_y) + times_i(lump[7] * factor[5] * (A_y * A_y)
        + 2.0 * lump[8] * factor[3] * (norm_A_y * A_y * A_y) + lump[10] * factor[3] * (norm_A_x * A_y * A_y)
        + lump[13] * factor[3] * (conj_A_x * A_y * F));
  }
};

/// amplitude of exp(i*(-omega1 + 2*omega2)*t) in x = (omega1^3 - 2*omega1^2*omega2)/(4*omega2^2*(omega1 -
/// omega2)^2)*i*dissipative_x_A_x_A_y_conjA_y*conj(A_x)*A_y^2 - 1/(4*omega2*(omega1 -
/// omega2))*b3*conj(A_x)*A_y^2 + harmonic_re_x_A_y_conjA_x2_F*conj(A_x)^2*A_y*F +
/// harmonic_re_x_A_y_conjA_x2_F*conj(A_x)^2*A_y*F + harmonic_re_x_A_y3_F*A_y^3*F + harmonic_re_x_A_y3_F*A_y^3*F
/// + harmonic_re_x_A_y3_conjA_x_conjA_y*conj(A_x)*A_y^3*conj(A_y) +
/// harmonic_re_x_A_x_A_y2_conjA_x2*A_x*conj(A_x)^2*A_y^2
struct harmonic_minus_omega1_plus_2_omega2_of_x : BlockShape<6, 3, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 3> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number omega1_3 = omega1_2 * omega1;
    const Number omega2_2 = omega2 * omega2;
    const Number per_0 = 1.0 / (omega1 - omega2);
    const Number per_0_2 = per_0 * per_0;
    return {(omega1_3 - 2.0 * omega1_2 * omega2) * per_0_2 / (4.0 * omega2_2), -per_0 / (4.0 * omega2), 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    column[0] = times_i(factor[0] * (conj_A_x * A_y * A_y));  // dissipative_x_A_x_A_y_conjA_y
    column[1] = factor[1] * (conj_A_x * A_y * A_y);  // b3
    // harmonic_re_x_A_y_conjA_x2_F
    column[2] = factor[2] * (conj_A_x * conj_A_x * A_y * F) + factor[2] * (conj_A_x * conj_A_x * A_y * F);
    // harmonic_re_x_A_y3_F
    column[3] = factor[2] * (A_y * A_y * A_y * conj_F) + factor[2] * (A_y * A_y * A_y * conj_F);
    column[4] = factor[2] * (conj_A_x * norm_A_y * A_y * A_y);  // harmonic_re_x_A_y3_conjA_x_conjA_y
    column[5] = factor[2] * (norm_A_x * conj_A_x * A_y * A_y);  // harmonic_re_x_A_x_A_y2_conjA_x2
  }
};

/// amplitude of exp(i*(omega2 + Omega)*t) in x = -omega1^2/(2*omega2^2*(omega1 +
/// omega2))*conservative_x_A_x_F2*conj(A_x)*F^2 + (-omega1^3 - 2*omega1^2*omega2)/(4*omega2^2*(omega1 +
/// omega2)^2)*i*dissipative_x_A_x_A_y_conjA_y*A_x*A_y^2 + 1/(4*omega2*(omega1 + omega2))*b3*A_x*A_y^2 +
/// (-omega1^3 - 2*omega1^2*omega2)/(2*omega2^2*(omega1 + omega2)^2)*i*dissipative_x_conjA_y_F*A_y*F -
/// 1/(8*omega2*(omega1 + omega2))*p*A_y*F + (-omega1^2 - 3*omega1*omega2 + omega1*Omega - 2*omega2^2 +
/// 2*omega2*Omega)/(16*omega2^2*(omega1 + omega2)^2)*p*A_y*F + (omega1^3 - 3*omega1*omega2^2 +
/// 2*omega2^3)/((omega1 + omega2)^2*(omega1 - 2*omega2))*harmonic_re_x_A_y3_F*A_y^2*conj(A_y)*F +
/// harmonic_re_x_A_y2_conjA_y_F*A_y^2*conj(A_y)*F + harmonic_re_x_A_x_A_y_conjA_x_F*A_x*conj(A_x)*A_y*F +
/// harmonic_re_x_A_x_A_y_conjA_x_F*A_x*conj(A_x)*A_y*F + harmonic_re_x_A_x_A_y3_conjA_y*A_x*A_y^3*conj(A_y) +
/// harmonic_re_x_A_x2_A_y2_conjA_x*A_x^2*conj(A_x)*A_y^2
struct harmonic_omega2_plus_Omega_of_x : BlockShape<10, 8, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 8> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number omega1_3 = omega1_2 * omega1;
    const Number omega2_2 = omega2 * omega2;
    const Number omega2_3 = omega2_2 * omega2;
    const Number per_0 = 1.0 / (omega1 + omega2);
    const Number per_0_2 = per_0 * per_0;
    const Number per_1 = 1.0 / (omega1 - 2.0 * omega2);
    const Number over_0 = per_0_2 * per_1;
    return {-omega1_2 * per_0 / (2.0 * omega2_2),
        (-omega1_3 - 2.0 * omega1_2 * omega2) * per_0_2 / (4.0 * omega2_2), per_0 / (4.0 * omega2),
        (-omega1_3 - 2.0 * omega1_2 * omega2) * per_0_2 / (2.0 * omega2_2), -per_0 / (8.0 * omega2),
        (-omega1_2 - 3.0 * omega1 * omega2 + omega1 * Omega - 2.0 * omega2_2
            + 2.0 * omega2 * Omega) * per_0_2 / (16.0 * omega2_2),
        (omega1_3 - 3.0 * omega1 * omega2_2 + 2.0 * omega2_3) * over_0, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (conj_A_x * F * F);  // conservative_x_A_x_F2
    column[1] = times_i(factor[1] * (A_x * A_y * A_y));  // dissipative_x_A_x_A_y_conjA_y
    column[2] = factor[2] * (A_x * A_y * A_y);  // b3
    column[3] = times_i(factor[3] * (A_y * F));  // dissipative_x_conjA_y_F
    column[4] = factor[4] * (A_y * F) + factor[5] * (A_y * F);  // p
    column[5] = factor[6] * (norm_A_y * A_y * F);  // harmonic_re_x_A_y3_F
    column[6] = factor[7] * (norm_A_y * A_y * F);  // harmonic_re_x_A_y2_conjA_y_F
    // harmonic_re_x_A_x_A_y_conjA_x_F
    column[7] = factor[7] * (norm_A_x * A_y * F) + factor[7] * (norm_A_x * A_y * F);
    column[8] = factor[7] * (A_x * norm_A_y * A_y * A_y);  // harmonic_re_x_A_x_A_y3_conjA_y
    column[9] = factor[7] * (norm_A_x * A_x * A_y * A_y);  // harmonic_re_x_A_x2_A_y2_conjA_x
  }
};

/// amplitude of exp(i*(3*omega1)*t) in x = -1/(8*omega1)*i*dissipative_x_A_x2_conjA_x*A_x^3 +
/// 1/(8*omega1^2)*b1*A_x^3 + 7/(20*omega1)*conservative_x_A_x3_conjA_x2*A_x^4*conj(A_x) +
/// harmonic_re_x_A_x2_conjA_y_F*A_x^2*conj(A_y)*F + harmonic_re_x_A_x2_conjA_y_F*A_x^2*conj(A_y)*F +
/// harmonic_re_x_A_x3_A_y_conjA_y*A_x^3*A_y*conj(A_y)
struct harmonic_3_omega1_of_x : BlockShape<5, 4, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 4> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    return {-1.0 / (8.0 * omega1), 1.0 / (8.0 * omega1_2), 7.0 / (20.0 * omega1), 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    column[0] = times_i(factor[0] * (A_x * A_x * A_x));  // dissipative_x_A_x2_conjA_x
    column[1] = factor[1] * (A_x * A_x * A_x);  // b1
    column[2] = factor[2] * (norm_A_x * A_x * A_x * A_x);  // conservative_x_A_x3_conjA_x2
    // harmonic_re_x_A_x2_conjA_y_F
    column[3] = factor[3] * (A_x * A_x * conj_A_y * F) + factor[3] * (A_x * A_x * conj_A_y * F);
    column[4] = factor[3] * (A_x * A_x * A_x * norm_A_y);  // harmonic_re_x_A_x3_A_y_conjA_y
  }
};

/// amplitude of exp(i*(-3*omega1 + 2*omega2)*t) in x = harmonic_re_x_A_y2_conjA_x3*conj(A_x)^3*A_y^2
struct harmonic_minus_3_omega1_plus_2_omega2_of_x : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (conj_A_x * conj_A_x * conj_A_x * A_y * A_y);  // harmonic_re_x_A_y2_conjA_x3
  }
};

/// amplitude of exp(i*(-omega1 + 4*omega2)*t) in x = harmonic_re_x_A_y4_conjA_x*conj(A_x)*A_y^4
struct harmonic_minus_omega1_plus_4_omega2_of_x : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (conj_A_x * fixed_power<4>(A_y));  // harmonic_re_x_A_y4_conjA_x
  }
};

/// amplitude of exp(i*(3*omega2 + Omega)*t) in x = harmonic_re_x_A_y3_F*A_y^3*F +
/// harmonic_re_x_A_x_A_y4*A_x*A_y^4
struct harmonic_3_omega2_plus_Omega_of_x : BlockShape<2, 1, is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_y * A_y * A_y * F);  // harmonic_re_x_A_y3_F
    column[1] = factor[0] * (A_x * fixed_power<4>(A_y));  // harmonic_re_x_A_x_A_y4
  }
};

/// amplitude of exp(i*(omega1 + 2*Omega)*t) in x = omega1*omega2/(2*(omega1 + omega2)*(omega1 +
/// 2*omega2)*(2*omega1 + omega2))*conservative_x_A_x_F2*A_x*F^2 + harmonic_re_x_A_x2_A_y_F*A_x^2*A_y*F +
/// harmonic_re_x_A_x3_A_y2*A_x^3*A_y^2
struct harmonic_omega1_plus_2_Omega_of_x : BlockShape<3, 2, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 + omega2);
    const Number per_1 = 1.0 / (omega1 + 2.0 * omega2);
    const Number per_2 = 1.0 / (2.0 * omega1 + omega2);
    const Number over_0 = per_0 * per_1 * per_2;
    return {omega1 * omega2 * over_0 / 2.0, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_x * F * F);  // conservative_x_A_x_F2
    column[1] = factor[1] * (A_x * A_x * A_y * F);  // harmonic_re_x_A_x2_A_y_F
    column[2] = factor[1] * (A_x * A_x * A_x * A_y * A_y);  // harmonic_re_x_A_x3_A_y2
  }
};

/// amplitude of exp(i*(5*omega1)*t) in x = -1/(60*omega1)*conservative_x_A_x3_conjA_x2*A_x^5
struct harmonic_5_omega1_of_x : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    return {-1.0 / (60.0 * omega1)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * fixed_power<5>(A_x);  // conservative_x_A_x3_conjA_x2
  }
};

/// amplitude of exp(i*(-2*omega1 + omega2)*t) in y = 1/(4*omega1*(omega1 - omega2))*b3*conj(A_x)^2*A_y +
/// (2*omega1*omega2^2 - omega2^3)/(4*omega1^2*(omega1 -
/// omega2)^2)*i*dissipative_y_A_x_A_y_conjA_x*conj(A_x)^2*A_y + (4*omega1*omega2^2 -
/// 2*omega2^3)/(omega1^2*(omega1 - 2*omega2))*harmonic_re_x_A_y3_F*conj(A_x)*A_y^2*F +
/// harmonic_re_y_conjA_x3_F*conj(A_x)^3*F + harmonic_re_y_conjA_x3_F*conj(A_x)^3*F +
/// harmonic_re_y_A_y2_conjA_x2_conjA_y*conj(A_x)^2*A_y^2*conj(A_y) +
/// harmonic_re_y_A_x_A_y_conjA_x3*A_x*conj(A_x)^3*A_y + harmonic_re_y_A_y2_conjA_x_F*conj(A_x)*A_y^2*F
struct harmonic_minus_2_omega1_plus_omega2_of_y : BlockShape<7, 4, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 4> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number omega2_2 = omega2 * omega2;
    const Number omega2_3 = omega2_2 * omega2;
    const Number per_0 = 1.0 / (omega1 - omega2);
    const Number per_0_2 = per_0 * per_0;
    const Number per_1 = 1.0 / (omega1 - 2.0 * omega2);
    return {per_0 / (4.0 * omega1), (2.0 * omega1 * omega2_2 - omega2_3) * per_0_2 / (4.0 * omega1_2),
        (4.0 * omega1 * omega2_2 - 2.0 * omega2_3) * per_1 / omega1_2, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (conj_A_x * conj_A_x * A_y);  // b3
    column[1] = times_i(factor[1] * (conj_A_x * conj_A_x * A_y));  // dissipative_y_A_x_A_y_conjA_x
    column[2] = factor[2] * (conj_A_x * A_y * A_y * conj_F);  // harmonic_re_x_A_y3_F
    // harmonic_re_y_conjA_x3_F
    column[3] = factor[3] * (conj_A_x * conj_A_x * conj_A_x * F)
        + factor[3] * (conj_A_x * conj_A_x * conj_A_x * F);
    column[4] = factor[3] * (conj_A_x * conj_A_x * norm_A_y * A_y);  // harmonic_re_y_A_y2_conjA_x2_conjA_y
    column[5] = factor[3] * (norm_A_x * conj_A_x * conj_A_x * A_y);  // harmonic_re_y_A_x_A_y_conjA_x3
    column[6] = factor[3] * (conj_A_x * A_y * A_y * conj_F);  // harmonic_re_y_A_y2_conjA_x_F
  }
};

/// amplitude of exp(i*(3*omega2)*t) in y = -1/(8*omega2)*i*dissipative_y_A_y2_conjA_y*A_y^3 +
/// 1/(8*omega2^2)*b5*A_y^3 + 7/(20*omega2)*conservative_y_A_y3_conjA_y2*A_y^4*conj(A_y) +
/// harmonic_re_y_A_y2_conjA_x_F*conj(A_x)*A_y^2*F + harmonic_re_y_A_y2_conjA_x_F*conj(A_x)*A_y^2*F +
/// harmonic_re_y_A_x_A_y3_conjA_x*A_x*conj(A_x)*A_y^3
struct harmonic_3_omega2_of_y : BlockShape<5, 4, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 4> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega2_2 = omega2 * omega2;
    return {-1.0 / (8.0 * omega2), 1.0 / (8.0 * omega2_2), 7.0 / (20.0 * omega2), 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    column[0] = times_i(factor[0] * (A_y * A_y * A_y));  // dissipative_y_A_y2_conjA_y
    column[1] = factor[1] * (A_y * A_y * A_y);  // b5
    column[2] = factor[2] * (norm_A_y * A_y * A_y * A_y);  // conservative_y_A_y3_conjA_y2
    // harmonic_re_y_A_y2_conjA_x_F
    column[3] = factor[3] * (conj_A_x * A_y * A_y * F) + factor[3] * (conj_A_x * A_y * A_y * F);
    column[4] = factor[3] * (norm_A_x * A_y * A_y * A_y);  // harmonic_re_y_A_x_A_y3_conjA_x
  }
};

/// amplitude of exp(i*(omega1 + Omega)*t) in y = (-2*omega1*omega2 - omega2^2)/(2*omega1*(omega1 +
/// omega2)*(omega1 + 2*omega2))*conservative_x_A_x_F2*conj(A_y)*F^2 + 1/(4*omega1*(omega1 +
/// omega2))*b3*A_x^2*A_y + (-2*omega1*omega2^2 - omega2^3)/(4*omega1^2*(omega1 +
/// omega2)^2)*i*dissipative_y_A_x_A_y_conjA_x*A_x^2*A_y + (-2*omega1*omega2^2 - omega2^3)/(2*omega1^2*(omega1 +
/// omega2)^2)*i*dissipative_y_conjA_x_F*A_x*F - 1/(8*omega1*(omega1 + omega2))*q*A_x*F + (-2*omega1^2 -
/// 3*omega1*omega2 + 2*omega1*Omega - omega2^2 + omega2*Omega)/(16*omega1^2*(omega1 + omega2)^2)*q*A_x*F +
/// (4*omega1^3*omega2^2 - 6*omega1^2*omega2^3 + 2*omega2^5)/(omega1^2*(omega1 + omega2)^2*(omega1 -
/// 2*omega2))*harmonic_re_x_A_y3_F*A_x*A_y*conj(A_y)*F + harmonic_re_y_A_x_A_y_conjA_y_F*A_x*A_y*conj(A_y)*F +
/// harmonic_re_y_A_x2_conjA_x_F*A_x^2*conj(A_x)*F + harmonic_re_y_A_x2_conjA_x_F*A_x^2*conj(A_x)*F +
/// harmonic_re_y_A_x2_A_y2_conjA_y*A_x^2*A_y^2*conj(A_y) + harmonic_re_y_A_x3_A_y_conjA_x*A_x^3*conj(A_x)*A_y
struct harmonic_omega1_plus_Omega_of_y : BlockShape<10, 8, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 8> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number omega1_3 = omega1_2 * omega1;
    const Number omega2_2 = omega2 * omega2;
    const Number omega2_3 = omega2_2 * omega2;
    const Number omega2_4 = omega2_3 * omega2;
    const Number omega2_5 = omega2_4 * omega2;
    const Number per_0 = 1.0 / (omega1 + omega2);
    const Number per_0_2 = per_0 * per_0;
    const Number per_1 = 1.0 / (omega1 + 2.0 * omega2);
    const Number per_2 = 1.0 / (omega1 - 2.0 * omega2);
    const Number over_0 = per_0 * per_1;
    const Number over_1 = per_0_2 * per_2;
    return {(-2.0 * omega1 * omega2 - omega2_2) * over_0 / (2.0 * omega1), per_0 / (4.0 * omega1),
        (-2.0 * omega1 * omega2_2 - omega2_3) * per_0_2 / (4.0 * omega1_2),
        (-2.0 * omega1 * omega2_2 - omega2_3) * per_0_2 / (2.0 * omega1_2), -per_0 / (8.0 * omega1),
        (-2.0 * omega1_2 - 3.0 * omega1 * omega2 + 2.0 * omega1 * Omega - omega2_2
            + omega2 * Omega) * per_0_2 / (16.0 * omega1_2),
        (4.0 * omega1_3 * omega2_2 - 6.0 * omega1_2 * omega2_3 + 2.0 * omega2_5) * over_1 / omega1_2, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (conj_A_y * F * F);  // conservative_x_A_x_F2
    column[1] = factor[1] * (A_x * A_x * A_y);  // b3
    column[2] = times_i(factor[2] * (A_x * A_x * A_y));  // dissipative_y_A_x_A_y_conjA_x
    column[3] = times_i(factor[3] * (A_x * F));  // dissipative_y_conjA_x_F
    column[4] = factor[4] * (A_x * F) + factor[5] * (A_x * F);  // q
    column[5] = factor[6] * (A_x * norm_A_y * F);  // harmonic_re_x_A_y3_F
    column[6] = factor[7] * (A_x * norm_A_y * F);  // harmonic_re_y_A_x_A_y_conjA_y_F
    // harmonic_re_y_A_x2_conjA_x_F
    column[7] = factor[7] * (norm_A_x * A_x * F) + factor[7] * (norm_A_x * A_x * F);
    column[8] = factor[7] * (A_x * A_x * norm_A_y * A_y);  // harmonic_re_y_A_x2_A_y2_conjA_y
    column[9] = factor[7] * (norm_A_x * A_x * A_x * A_y);  // harmonic_re_y_A_x3_A_y_conjA_x
  }
};

/// amplitude of exp(i*(-2*omega1 + 3*omega2)*t) in y = harmonic_re_y_A_y3_conjA_x2*conj(A_x)^2*A_y^3
struct harmonic_minus_2_omega1_plus_3_omega2_of_y : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (conj_A_x * conj_A_x * A_y * A_y * A_y);  // harmonic_re_y_A_y3_conjA_x2
  }
};

/// amplitude of exp(i*(omega2 + 2*Omega)*t) in y = omega1^2/(2*(omega1 + omega2)*(omega1 +
/// 2*omega2)^2)*conservative_x_A_x_F2*A_y*F^2 + harmonic_re_y_A_x_A_y2_F*A_x*A_y^2*F +
/// harmonic_re_y_A_x2_A_y3*A_x^2*A_y^3
struct harmonic_omega2_plus_2_Omega_of_y : BlockShape<3, 2, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number per_0 = 1.0 / (omega1 + omega2);
    const Number per_1 = 1.0 / (omega1 + 2.0 * omega2);
    const Number per_1_2 = per_1 * per_1;
    const Number over_0 = per_0 * per_1_2;
    return {omega1_2 * over_0 / 2.0, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_y * F * F);  // conservative_x_A_x_F2
    column[1] = factor[1] * (A_x * A_y * A_y * F);  // harmonic_re_y_A_x_A_y2_F
    column[2] = factor[1] * (A_x * A_x * A_y * A_y * A_y);  // harmonic_re_y_A_x2_A_y3
  }
};

/// amplitude of exp(i*(5*omega2)*t) in y = -1/(60*omega2)*conservative_y_A_y3_conjA_y2*A_y^5
struct harmonic_5_omega2_of_y : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    return {-1.0 / (60.0 * omega2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * fixed_power<5>(A_y);  // conservative_y_A_y3_conjA_y2
  }
};

/// amplitude of exp(i*(3*omega1 + Omega)*t) in y = harmonic_re_y_A_x3_F*A_x^3*F +
/// harmonic_re_y_A_x4_A_y*A_x^4*A_y
struct harmonic_3_omega1_plus_Omega_of_y : BlockShape<2, 1, is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_x * A_x * A_x * F);  // harmonic_re_y_A_x3_F
    column[1] = factor[0] * (fixed_power<4>(A_x) * A_y);  // harmonic_re_y_A_x4_A_y
  }
};

/// amplitude of exp(i*(4*omega1 - omega2)*t) in y = harmonic_re_y_A_x4_conjA_y*A_x^4*conj(A_y)
struct harmonic_4_omega1_minus_omega2_of_y : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (fixed_power<4>(A_x) * conj_A_y);  // harmonic_re_y_A_x4_conjA_y
  }
};

inline constexpr BlockFunctions blocks[18] = {modulation_functions<Model, modulation_of_x>(),
    modulation_functions<Model, modulation_of_y>(),
    harmonic_functions<Model, harmonic_minus_omega1_plus_2_omega2_of_x>(),
    harmonic_functions<Model, harmonic_omega2_plus_Omega_of_x>(),
    harmonic_functions<Model, harmonic_3_omega1_of_x>(),
    harmonic_functions<Model, harmonic_minus_3_omega1_plus_2_omega2_of_x>(),
    harmonic_functions<Model, harmonic_minus_omega1_plus_4_omega2_of_x>(),
    harmonic_functions<Model, harmonic_3_omega2_plus_Omega_of_x>(),
    harmonic_functions<Model, harmonic_omega1_plus_2_Omega_of_x>(),
    harmonic_functions<Model, harmonic_5_omega1_of_x>(),
    harmonic_functions<Model, harmonic_minus_2_omega1_plus_omega2_of_y>(),
    harmonic_functions<Model, harmonic_3_omega2_of_y>(),
    harmonic_functions<Model, harmonic_omega1_plus_Omega_of_y>(),
    harmonic_functions<Model, harmonic_minus_2_omega1_plus_3_omega2_of_y>(),
    harmonic_functions<Model, harmonic_omega2_plus_2_Omega_of_y>(),
    harmonic_functions<Model, harmonic_5_omega2_of_y>(),
    harmonic_functions<Model, harmonic_3_omega1_plus_Omega_of_y>(),
    harmonic_functions<Model, harmonic_4_omega1_minus_omega2_of_y>()};

}  // namespace additive_second_order
}  // namespace secular::generated::parametric_pair
