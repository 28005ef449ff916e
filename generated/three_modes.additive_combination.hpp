// Model three_modes: generated code, never edited by hand.
// Holds rows of the case additive_combination. Made by: secular generate three_modes.
// Omega = omega1 + omega2 + eps^2*sigma, multiple scales to eps^2. Valid near that resonance for small
// amplitudes; what is left out is of order eps^3.
#pragma once

#include "three_modes.hpp"

namespace secular::generated::three_modes {

namespace additive_combination {

/// (rate - i*omega1)*A_v1 = -mu1*A_v1 + i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) +
/// i*conservative_v1_A_v12_conjA_v1*A_v1^2*conj(A_v1) + i*conservative_v1_conjA_v2_F*conj(A_v2)*F
struct modulation_of_v1 : BlockShape<4, 2, is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>&) {
    return {-1.0, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * A_v1;  // mu1
    column[1] = times_i(factor[1] * (A_v1 * norm_A_v2));  // conservative_v1_A_v1_A_v2_conjA_v2
    column[2] = times_i(factor[1] * (norm_A_v1 * A_v1));  // conservative_v1_A_v12_conjA_v1
    column[3] = times_i(factor[1] * (conj_A_v2 * F));  // conservative_v1_conjA_v2_F
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    by[0] = ComplexNumber<double>(lump[0] * factor[0], lump[1] * factor[1] * norm_A_v2
        + 2.0 * lump[2] * factor[1] * norm_A_v1);
    by_conjugate[0] = times_i(lump[2] * factor[1] * (A_v1 * A_v1));
    by[1] = times_i(lump[1] * factor[1] * (A_v1 * conj_A_v2));
    by_conjugate[1] = times_i(lump[1] * factor[1] * (A_v1 * A_v2) + lump[3] * factor[1] * F);
  }
};

/// (rate - i*omega2)*A_v2 = omega1/omega2*i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*conj(A_v1)*A_v2 +
/// omega1/omega2*i*conservative_v1_conjA_v2_F*conj(A_v1)*F - mu2*A_v2 +
/// i*conservative_v2_A_v22_conjA_v2*A_v2^2*conj(A_v2)
struct modulation_of_v2 : BlockShape<4, 3, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 3> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    return {omega1 / omega2, -1.0, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = times_i(factor[0] * (norm_A_v1 * A_v2));  // conservative_v1_A_v1_A_v2_conjA_v2
    column[1] = times_i(factor[0] * (conj_A_v1 * F));  // conservative_v1_conjA_v2_F
    column[2] = factor[1] * A_v2;  // mu2
    column[3] = times_i(factor[2] * (norm_A_v2 * A_v2));  // conservative_v2_A_v22_conjA_v2
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    by[0] = times_i(lump[0] * factor[0] * (conj_A_v1 * A_v2));
    by_conjugate[0] = times_i(lump[0] * factor[0] * (A_v1 * A_v2) + lump[1] * factor[0] * F);
    by[1] = ComplexNumber<double>(lump[2] * factor[1], lump[0] * factor[0] * norm_A_v1
        + 2.0 * lump[3] * factor[2] * norm_A_v2);
    by_conjugate[1] = times_i(lump[3] * factor[2] * (A_v2 * A_v2));
  }
};

/// amplitude of exp(i*(Omega)*t) in v1 = 1/(2*(omega1 + Omega)*(omega1 - Omega))*e1*F
struct harmonic_Omega_of_v1 : BlockShape<1, 1, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 + Omega);
    const Number per_1 = 1.0 / (omega1 - Omega);
    const Number over_0 = per_0 * per_1;
    return {over_0 / 2.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * F;  // e1
  }
};

/// amplitude of exp(i*(-2*omega1 + omega2)*t) in v1 = harmonic_re_v1_A_v2_conjA_v12*conj(A_v1)^2*A_v2
struct harmonic_minus_2_omega1_plus_omega2_of_v1 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (conj_A_v1 * conj_A_v1 * A_v2);  // harmonic_re_v1_A_v2_conjA_v12
  }
};

/// amplitude of exp(i*(omega2)*t) in v1 = (24*omega1^7 - 8*omega1^6*omega2 - 48*omega1^5*omega2^2 -
/// 102*omega1^5*omega3^2 + 16*omega1^4*omega2^3 + 34*omega1^4*omega2*omega3^2 + 24*omega1^3*omega2^4 -
/// 84*omega1^3*omega2^2*omega3^2 + 96*omega1^3*omega3^4 - 8*omega1^2*omega2^5 + 28*omega1^2*omega2^3*omega3^2 -
/// 32*omega1^2*omega2*omega3^4 - 6*omega1*omega2^4*omega3^2 + 24*omega1*omega2^2*omega3^4 - 18*omega1*omega3^6 +
/// 2*omega2^5*omega3^2 - 8*omega2^3*omega3^4 + 6*omega2*omega3^6)/(omega3^2*(9*omega1^2 - 2*omega1*omega2 +
/// omega2^2 - 3*omega3^2)*(omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 -
/// omega3))*harmonic_re_v1_A_v2_conjA_v12*A_v1*conj(A_v1)*A_v2 + harmonic_re_v1_conjA_v1_F*conj(A_v1)*F +
/// harmonic_re_v1_A_v22_conjA_v2*A_v2^2*conj(A_v2)
struct harmonic_omega2_of_v1 : BlockShape<3, 2, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number omega1_3 = omega1_2 * omega1;
    const Number omega1_4 = omega1_3 * omega1;
    const Number omega1_5 = omega1_4 * omega1;
    const Number omega1_6 = omega1_5 * omega1;
    const Number omega1_7 = omega1_6 * omega1;
    const Number omega2_2 = omega2 * omega2;
    const Number omega2_3 = omega2_2 * omega2;
    const Number omega2_4 = omega2_3 * omega2;
    const Number omega2_5 = omega2_4 * omega2;
    const Number omega3_2 = omega3 * omega3;
    const Number omega3_3 = omega3_2 * omega3;
    const Number omega3_4 = omega3_3 * omega3;
    const Number omega3_5 = omega3_4 * omega3;
    const Number omega3_6 = omega3_5 * omega3;
    const Number per_0 = 1.0 / (9.0 * omega1_2 - 2.0 * omega1 * omega2 + omega2_2 - 3.0 * omega3_2);
    const Number per_1 = 1.0 / (omega1 + omega2);
    const Number per_2 = 1.0 / (omega1 + omega2 + omega3);
    const Number per_3 = 1.0 / (omega1 + omega2 - omega3);
    const Number over_0 = per_0 * per_1 * per_2 * per_3;
    return {(24.0 * omega1_7 - 8.0 * omega1_6 * omega2 - 48.0 * omega1_5 * omega2_2 - 102.0 * omega1_5 * omega3_2
        + 16.0 * omega1_4 * omega2_3 + 34.0 * omega1_4 * omega2 * omega3_2 + 24.0 * omega1_3 * omega2_4
        - 84.0 * omega1_3 * omega2_2 * omega3_2 + 96.0 * omega1_3 * omega3_4 - 8.0 * omega1_2 * omega2_5
        + 28.0 * omega1_2 * omega2_3 * omega3_2 - 32.0 * omega1_2 * omega2 * omega3_4
        - 6.0 * omega1 * omega2_4 * omega3_2 + 24.0 * omega1 * omega2_2 * omega3_4 - 18.0 * omega1 * omega3_6
        + 2.0 * omega2_5 * omega3_2 - 8.0 * omega2_3 * omega3_4 + 6.0 * omega2 * omega3_6) * over_0 / omega3_2,
        1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (norm_A_v1 * A_v2);  // harmonic_re_v1_A_v2_conjA_v12
    column[1] = factor[1] * (conj_A_v1 * F);  // harmonic_re_v1_conjA_v1_F
    column[2] = factor[1] * (norm_A_v2 * A_v2);  // harmonic_re_v1_A_v22_conjA_v2
  }
};

/// amplitude of exp(i*(-omega1 + 2*omega2)*t) in v1 = harmonic_re_v1_A_v22_conjA_v1*conj(A_v1)*A_v2^2
struct harmonic_minus_omega1_plus_2_omega2_of_v1 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (conj_A_v1 * A_v2 * A_v2);  // harmonic_re_v1_A_v22_conjA_v1
  }
};

/// amplitude of exp(i*(omega2 + Omega)*t) in v1 = omega1/(2*omega2*(omega1 +
/// omega2))*conservative_v1_conjA_v2_F*A_v2*F + harmonic_re_v1_A_v1_A_v22*A_v1*A_v2^2
struct harmonic_omega2_plus_Omega_of_v1 : BlockShape<2, 2, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 + omega2);
    return {omega1 * per_0 / (2.0 * omega2), 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v2 * F);  // conservative_v1_conjA_v2_F
    column[1] = factor[1] * (A_v1 * A_v2 * A_v2);  // harmonic_re_v1_A_v1_A_v22
  }
};

/// amplitude of exp(i*(3*omega2)*t) in v1 = (-omega1^2*omega3^2 + omega2^2*omega3^2)/((omega1 +
/// 3*omega2)*(omega1 - 3*omega2)*(8*omega2^2 - 3*omega3^2))*harmonic_re_v1_A_v22_conjA_v2*A_v2^3
struct harmonic_3_omega2_of_v1 : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number omega2_2 = omega2 * omega2;
    const Number omega3_2 = omega3 * omega3;
    const Number per_0 = 1.0 / (omega1 + 3.0 * omega2);
    const Number per_1 = 1.0 / (omega1 - 3.0 * omega2);
    const Number per_2 = 1.0 / (8.0 * omega2_2 - 3.0 * omega3_2);
    const Number over_0 = per_0 * per_1 * per_2;
    return {(-omega1_2 * omega3_2 + omega2_2 * omega3_2) * over_0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v2 * A_v2 * A_v2);  // harmonic_re_v1_A_v22_conjA_v2
  }
};

/// amplitude of exp(i*(omega1 + Omega)*t) in v1 = (27*omega1^6 - 84*omega1^5*omega2 + 91*omega1^4*omega2^2 -
/// 36*omega1^4*omega3^2 - 40*omega1^3*omega2^3 + 60*omega1^3*omega2*omega3^2 + 9*omega1^2*omega2^4 -
/// 40*omega1^2*omega2^2*omega3^2 + 9*omega1^2*omega3^4 - 4*omega1*omega2^5 + 20*omega1*omega2^3*omega3^2 -
/// 12*omega1*omega2*omega3^4 + omega2^6 - 4*omega2^4*omega3^2 + 3*omega2^2*omega3^4)/((9*omega1^2 -
/// 2*omega1*omega2 + omega2^2 - 3*omega3^2)*(omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 -
/// omega3)*(3*omega1 + omega2))*harmonic_re_v1_A_v2_conjA_v12*A_v1^2*A_v2 + (omega1^4 + 2*omega1^3*omega2 -
/// omega1^2*omega3^2 - 2*omega1*omega2^3 - omega2^4 + omega2^2*omega3^2)/(Omega*(2*omega1 + Omega)*(omega3 +
/// Omega)*(omega3 - Omega))*harmonic_re_v1_conjA_v1_F*A_v1*F
struct harmonic_omega1_plus_Omega_of_v1 : BlockShape<2, 2, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number omega1_3 = omega1_2 * omega1;
    const Number omega1_4 = omega1_3 * omega1;
    const Number omega1_5 = omega1_4 * omega1;
    const Number omega1_6 = omega1_5 * omega1;
    const Number omega2_2 = omega2 * omega2;
    const Number omega2_3 = omega2_2 * omega2;
    const Number omega2_4 = omega2_3 * omega2;
    const Number omega2_5 = omega2_4 * omega2;
    const Number omega2_6 = omega2_5 * omega2;
    const Number omega3_2 = omega3 * omega3;
    const Number omega3_3 = omega3_2 * omega3;
    const Number omega3_4 = omega3_3 * omega3;
    const Number per_0 = 1.0 / (9.0 * omega1_2 - 2.0 * omega1 * omega2 + omega2_2 - 3.0 * omega3_2);
    const Number per_1 = 1.0 / (omega1 + omega2);
    const Number per_2 = 1.0 / (omega1 + omega2 + omega3);
    const Number per_3 = 1.0 / (omega1 + omega2 - omega3);
    const Number per_4 = 1.0 / (3.0 * omega1 + omega2);
    const Number per_5 = 1.0 / (2.0 * omega1 + Omega);
    const Number per_6 = 1.0 / (omega3 + Omega);
    const Number per_7 = 1.0 / (omega3 - Omega);
    const Number over_0 = per_0 * per_1 * per_2 * per_3 * per_4;
    const Number over_1 = per_5 * per_6 * per_7;
    return {(27.0 * omega1_6 - 84.0 * omega1_5 * omega2 + 91.0 * omega1_4 * omega2_2 - 36.0 * omega1_4 * omega3_2
        - 40.0 * omega1_3 * omega2_3 + 60.0 * omega1_3 * omega2 * omega3_2 + 9.0 * omega1_2 * omega2_4
        - 40.0 * omega1_2 * omega2_2 * omega3_2 + 9.0 * omega1_2 * omega3_4 - 4.0 * omega1 * omega2_5
        + 20.0 * omega1 * omega2_3 * omega3_2 - 12.0 * omega1 * omega2 * omega3_4 + omega2_6
        - 4.0 * omega2_4 * omega3_2 + 3.0 * omega2_2 * omega3_4) * over_0,
        (omega1_4 + 2.0 * omega1_3 * omega2 - omega1_2 * omega3_2 - 2.0 * omega1 * omega2_3 - omega2_4
            + omega2_2 * omega3_2) * over_1 / Omega};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v1 * A_v1 * A_v2);  // harmonic_re_v1_A_v2_conjA_v12
    column[1] = factor[1] * (A_v1 * F);  // harmonic_re_v1_conjA_v1_F
  }
};

/// amplitude of exp(i*(3*omega1)*t) in v1 = harmonic_re_v1_A_v13*A_v1^3
struct harmonic_3_omega1_of_v1 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v1 * A_v1 * A_v1);  // harmonic_re_v1_A_v13
  }
};

/// amplitude of exp(i*(Omega)*t) in v2 = 1/(2*(omega2 + Omega)*(omega2 - Omega))*e2*F
struct harmonic_Omega_of_v2 : BlockShape<1, 1, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega2 + Omega);
    const Number per_1 = 1.0 / (omega2 - Omega);
    const Number over_0 = per_0 * per_1;
    return {over_0 / 2.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * F;  // e2
  }
};

/// amplitude of exp(i*(-2*omega1 + omega2)*t) in v2 = harmonic_re_v2_A_v2_conjA_v12*conj(A_v1)^2*A_v2
struct harmonic_minus_2_omega1_plus_omega2_of_v2 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (conj_A_v1 * conj_A_v1 * A_v2);  // harmonic_re_v2_A_v2_conjA_v12
  }
};

/// amplitude of exp(i*(-omega1 + 2*omega2)*t) in v2 = (omega1^3*omega3^2 - omega1^2*omega2*omega3^2 +
/// 7*omega1*omega2^2*omega3^2 - 3*omega1*omega3^4 + 9*omega2^3*omega3^2 - 3*omega2*omega3^4)/((omega1 - omega2 +
/// omega3)*(omega1 - omega2 - omega3)*(omega1 - 3*omega2)*(8*omega2^2 -
/// 3*omega3^2))*harmonic_re_v1_A_v22_conjA_v2*conj(A_v1)*A_v2^2
struct harmonic_minus_omega1_plus_2_omega2_of_v2 : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number omega1_3 = omega1_2 * omega1;
    const Number omega2_2 = omega2 * omega2;
    const Number omega2_3 = omega2_2 * omega2;
    const Number omega3_2 = omega3 * omega3;
    const Number omega3_3 = omega3_2 * omega3;
    const Number omega3_4 = omega3_3 * omega3;
    const Number per_0 = 1.0 / (omega1 - omega2 + omega3);
    const Number per_1 = 1.0 / (omega1 - omega2 - omega3);
    const Number per_2 = 1.0 / (omega1 - 3.0 * omega2);
    const Number per_3 = 1.0 / (8.0 * omega2_2 - 3.0 * omega3_2);
    const Number over_0 = per_0 * per_1 * per_2 * per_3;
    return {(omega1_3 * omega3_2 - omega1_2 * omega2 * omega3_2 + 7.0 * omega1 * omega2_2 * omega3_2
        - 3.0 * omega1 * omega3_4 + 9.0 * omega2_3 * omega3_2 - 3.0 * omega2 * omega3_4) * over_0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (conj_A_v1 * A_v2 * A_v2);  // harmonic_re_v1_A_v22_conjA_v2
  }
};

/// amplitude of exp(i*(omega1)*t) in v2 = (-24*omega1^5 + 56*omega1^4*omega2 - 40*omega1^3*omega2^2 +
/// 33*omega1^3*omega3^2 + 8*omega1^2*omega2^3 - 29*omega1^2*omega2*omega3^2 + 15*omega1*omega2^2*omega3^2 -
/// 9*omega1*omega3^4 - 3*omega2^3*omega3^2 + 3*omega2*omega3^4)/(omega3^2*(9*omega1^2 - 2*omega1*omega2 +
/// omega2^2 - 3*omega3^2)*(omega1 + omega2))*harmonic_re_v1_A_v2_conjA_v12*A_v1^2*conj(A_v1) +
/// (-8*omega1^4*omega2^2 + 2*omega1^4*omega3^2 + 16*omega1^2*omega2^4 + 28*omega1^2*omega2^2*omega3^2 -
/// 8*omega1^2*omega3^4 - 8*omega2^6 + 34*omega2^4*omega3^2 - 32*omega2^2*omega3^4 + 6*omega3^6)/((omega1 +
/// omega2 + omega3)*(omega1 + omega2 - omega3)*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3)*(8*omega2^2
/// - 3*omega3^2))*harmonic_re_v1_A_v22_conjA_v2*A_v1*A_v2*conj(A_v2) + harmonic_re_v2_conjA_v2_F*conj(A_v2)*F
struct harmonic_omega1_of_v2 : BlockShape<3, 3, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 3> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number omega1_3 = omega1_2 * omega1;
    const Number omega1_4 = omega1_3 * omega1;
    const Number omega1_5 = omega1_4 * omega1;
    const Number omega2_2 = omega2 * omega2;
    const Number omega2_3 = omega2_2 * omega2;
    const Number omega2_4 = omega2_3 * omega2;
    const Number omega2_5 = omega2_4 * omega2;
    const Number omega2_6 = omega2_5 * omega2;
    const Number omega3_2 = omega3 * omega3;
    const Number omega3_3 = omega3_2 * omega3;
    const Number omega3_4 = omega3_3 * omega3;
    const Number omega3_5 = omega3_4 * omega3;
    const Number omega3_6 = omega3_5 * omega3;
    const Number per_0 = 1.0 / (9.0 * omega1_2 - 2.0 * omega1 * omega2 + omega2_2 - 3.0 * omega3_2);
    const Number per_1 = 1.0 / (omega1 + omega2);
    const Number per_2 = 1.0 / (omega1 + omega2 + omega3);
    const Number per_3 = 1.0 / (omega1 + omega2 - omega3);
    const Number per_4 = 1.0 / (omega1 - omega2 + omega3);
    const Number per_5 = 1.0 / (omega1 - omega2 - omega3);
    const Number per_6 = 1.0 / (8.0 * omega2_2 - 3.0 * omega3_2);
    const Number over_0 = per_0 * per_1;
    const Number over_1 = per_2 * per_3 * per_4 * per_5 * per_6;
    return {(-24.0 * omega1_5 + 56.0 * omega1_4 * omega2 - 40.0 * omega1_3 * omega2_2 + 33.0 * omega1_3 * omega3_2
        + 8.0 * omega1_2 * omega2_3 - 29.0 * omega1_2 * omega2 * omega3_2 + 15.0 * omega1 * omega2_2 * omega3_2
        - 9.0 * omega1 * omega3_4 - 3.0 * omega2_3 * omega3_2 + 3.0 * omega2 * omega3_4) * over_0 / omega3_2,
        (-8.0 * omega1_4 * omega2_2 + 2.0 * omega1_4 * omega3_2 + 16.0 * omega1_2 * omega2_4
            + 28.0 * omega1_2 * omega2_2 * omega3_2 - 8.0 * omega1_2 * omega3_4 - 8.0 * omega2_6
            + 34.0 * omega2_4 * omega3_2 - 32.0 * omega2_2 * omega3_4 + 6.0 * omega3_6) * over_1,
        1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (norm_A_v1 * A_v1);  // harmonic_re_v1_A_v2_conjA_v12
    column[1] = factor[1] * (A_v1 * norm_A_v2);  // harmonic_re_v1_A_v22_conjA_v2
    column[2] = factor[2] * (conj_A_v2 * F);  // harmonic_re_v2_conjA_v2_F
  }
};

/// amplitude of exp(i*(omega2 + Omega)*t) in v2 = (omega1^3*omega3^2 + omega1^2*omega2*omega3^2 +
/// 7*omega1*omega2^2*omega3^2 - 3*omega1*omega3^4 - 9*omega2^3*omega3^2 + 3*omega2*omega3^4)/((omega1 + omega2 +
/// omega3)*(omega1 + omega2 - omega3)*(omega1 + 3*omega2)*(8*omega2^2 -
/// 3*omega3^2))*harmonic_re_v1_A_v22_conjA_v2*A_v1*A_v2^2 + (-omega1^4 - 2*omega1^3*omega2 + omega1^2*omega3^2 +
/// 2*omega1*omega2^3 + omega2^4 - omega2^2*omega3^2)/(Omega*(2*omega2 + Omega)*(omega3 + Omega)*(omega3 -
/// Omega))*harmonic_re_v2_conjA_v2_F*A_v2*F
struct harmonic_omega2_plus_Omega_of_v2 : BlockShape<2, 2, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number omega1_3 = omega1_2 * omega1;
    const Number omega1_4 = omega1_3 * omega1;
    const Number omega2_2 = omega2 * omega2;
    const Number omega2_3 = omega2_2 * omega2;
    const Number omega2_4 = omega2_3 * omega2;
    const Number omega3_2 = omega3 * omega3;
    const Number omega3_3 = omega3_2 * omega3;
    const Number omega3_4 = omega3_3 * omega3;
    const Number per_0 = 1.0 / (omega1 + omega2 + omega3);
    const Number per_1 = 1.0 / (omega1 + omega2 - omega3);
    const Number per_2 = 1.0 / (omega1 + 3.0 * omega2);
    const Number per_3 = 1.0 / (8.0 * omega2_2 - 3.0 * omega3_2);
    const Number per_4 = 1.0 / (2.0 * omega2 + Omega);
    const Number per_5 = 1.0 / (omega3 + Omega);
    const Number per_6 = 1.0 / (omega3 - Omega);
    const Number over_0 = per_0 * per_1 * per_2 * per_3;
    const Number over_1 = per_4 * per_5 * per_6;
    return {(omega1_3 * omega3_2 + omega1_2 * omega2 * omega3_2 + 7.0 * omega1 * omega2_2 * omega3_2
        - 3.0 * omega1 * omega3_4 - 9.0 * omega2_3 * omega3_2 + 3.0 * omega2 * omega3_4) * over_0,
        (-omega1_4 - 2.0 * omega1_3 * omega2 + omega1_2 * omega3_2 + 2.0 * omega1 * omega2_3 + omega2_4
            - omega2_2 * omega3_2) * over_1 / Omega};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v1 * A_v2 * A_v2);  // harmonic_re_v1_A_v22_conjA_v2
    column[1] = factor[1] * (A_v2 * F);  // harmonic_re_v2_conjA_v2_F
  }
};

/// amplitude of exp(i*(3*omega2)*t) in v2 = harmonic_re_v2_A_v23*A_v2^3
struct harmonic_3_omega2_of_v2 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v2 * A_v2 * A_v2);  // harmonic_re_v2_A_v23
  }
};

/// amplitude of exp(i*(omega1 + Omega)*t) in v2 = 1/(2*(omega1 + omega2))*conservative_v1_conjA_v2_F*A_v1*F +
/// harmonic_re_v2_A_v12_A_v2*A_v1^2*A_v2
struct harmonic_omega1_plus_Omega_of_v2 : BlockShape<2, 2, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 + omega2);
    return {per_0 / 2.0, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v1 * F);  // conservative_v1_conjA_v2_F
    column[1] = factor[1] * (A_v1 * A_v1 * A_v2);  // harmonic_re_v2_A_v12_A_v2
  }
};

/// amplitude of exp(i*(3*omega1)*t) in v2 = (omega1^3 - 3*omega1^2*omega2 + 3*omega1*omega2^2 - omega1*omega3^2
/// - omega2^3 + omega2*omega3^2)/((9*omega1^2 - 2*omega1*omega2 + omega2^2 - 3*omega3^2)*(3*omega1 +
/// omega2))*harmonic_re_v1_A_v2_conjA_v12*A_v1^3
struct harmonic_3_omega1_of_v2 : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number omega1_3 = omega1_2 * omega1;
    const Number omega2_2 = omega2 * omega2;
    const Number omega2_3 = omega2_2 * omega2;
    const Number omega3_2 = omega3 * omega3;
    const Number per_0 = 1.0 / (9.0 * omega1_2 - 2.0 * omega1 * omega2 + omega2_2 - 3.0 * omega3_2);
    const Number per_1 = 1.0 / (3.0 * omega1 + omega2);
    const Number over_0 = per_0 * per_1;
    return {(omega1_3 - 3.0 * omega1_2 * omega2 + 3.0 * omega1 * omega2_2 - omega1 * omega3_2 - omega2_3
        + omega2 * omega3_2) * over_0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v1 * A_v1 * A_v1);  // harmonic_re_v1_A_v2_conjA_v12
  }
};

/// amplitude of exp(i*(-omega1 + omega2)*t) in v3 = 1/((omega1 - omega2 + omega3)*(omega1 - omega2 -
/// omega3))*a123*conj(A_v1)*A_v2
struct harmonic_minus_omega1_plus_omega2_of_v3 : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 - omega2 + omega3);
    const Number per_1 = 1.0 / (omega1 - omega2 - omega3);
    const Number over_0 = per_0 * per_1;
    return {over_0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (conj_A_v1 * A_v2);  // a123
  }
};

/// amplitude of exp(i*(0)*t) in v3 = -2/omega3^2*a223*A_v2*conj(A_v2) - 2/omega3^2*a113*A_v1*conj(A_v1)
struct harmonic_0_of_v3 : BlockShape<2, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number omega3_2 = omega3 * omega3;
    return {-2.0 / omega3_2};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = ComplexNumber<Number>(factor[0] * norm_A_v2);  // a223
    column[1] = ComplexNumber<Number>(factor[0] * norm_A_v1);  // a113
  }
};

/// amplitude of exp(i*(Omega)*t) in v3 = 1/((omega1 + omega2 + omega3)*(omega1 + omega2 -
/// omega3))*a123*A_v1*A_v2 + 1/(2*(omega3 + Omega)*(omega3 - Omega))*e3*F
struct harmonic_Omega_of_v3 : BlockShape<2, 2, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 + omega2 + omega3);
    const Number per_1 = 1.0 / (omega1 + omega2 - omega3);
    const Number per_2 = 1.0 / (omega3 + Omega);
    const Number per_3 = 1.0 / (omega3 - Omega);
    const Number over_0 = per_0 * per_1;
    const Number over_1 = per_2 * per_3;
    return {over_0, over_1 / 2.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v1 * A_v2);  // a123
    column[1] = factor[1] * F;  // e3
  }
};

/// amplitude of exp(i*(2*omega2)*t) in v3 = 1/((2*omega2 + omega3)*(2*omega2 - omega3))*a223*A_v2^2
struct harmonic_2_omega2_of_v3 : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number per_0 = 1.0 / (2.0 * omega2 + omega3);
    const Number per_1 = 1.0 / (2.0 * omega2 - omega3);
    const Number over_0 = per_0 * per_1;
    return {over_0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v2 * A_v2);  // a223
  }
};

/// amplitude of exp(i*(2*omega1)*t) in v3 = 1/((2*omega1 + omega3)*(2*omega1 - omega3))*a113*A_v1^2
struct harmonic_2_omega1_of_v3 : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number per_0 = 1.0 / (2.0 * omega1 + omega3);
    const Number per_1 = 1.0 / (2.0 * omega1 - omega3);
    const Number over_0 = per_0 * per_1;
    return {over_0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v1 * A_v1);  // a113
  }
};

/// amplitude of exp(i*(-omega1 + Omega)*t) in v3 = harmonic_re_v3_conjA_v1_F*conj(A_v1)*F
struct harmonic_minus_omega1_plus_Omega_of_v3 : BlockShape<1, 1, is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (conj_A_v1 * F);  // harmonic_re_v3_conjA_v1_F
  }
};

/// amplitude of exp(i*(-omega2 + Omega)*t) in v3 = harmonic_re_v3_conjA_v2_F*conj(A_v2)*F
struct harmonic_minus_omega2_plus_Omega_of_v3 : BlockShape<1, 1, is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (conj_A_v2 * F);  // harmonic_re_v3_conjA_v2_F
  }
};

/// amplitude of exp(i*(omega2 + Omega)*t) in v3 = (omega1^2 - omega3^2)/((omega1 + 2*omega2 + omega3)*(omega1 +
/// 2*omega2 - omega3))*harmonic_re_v3_conjA_v2_F*A_v2*F
struct harmonic_omega2_plus_Omega_of_v3 : BlockShape<1, 1, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number omega3_2 = omega3 * omega3;
    const Number per_0 = 1.0 / (omega1 + 2.0 * omega2 + omega3);
    const Number per_1 = 1.0 / (omega1 + 2.0 * omega2 - omega3);
    const Number over_0 = per_0 * per_1;
    return {(omega1_2 - omega3_2) * over_0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v2 * F);  // harmonic_re_v3_conjA_v2_F
  }
};

/// amplitude of exp(i*(omega1 + Omega)*t) in v3 = (omega2^2 - omega3^2)/((2*omega1 + omega2 + omega3)*(2*omega1
/// + omega2 - omega3))*harmonic_re_v3_conjA_v1_F*A_v1*F
struct harmonic_omega1_plus_Omega_of_v3 : BlockShape<1, 1, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number omega2_2 = omega2 * omega2;
    const Number omega3_2 = omega3 * omega3;
    const Number per_0 = 1.0 / (2.0 * omega1 + omega2 + omega3);
    const Number per_1 = 1.0 / (2.0 * omega1 + omega2 - omega3);
    const Number over_0 = per_0 * per_1;
    return {(omega2_2 - omega3_2) * over_0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v1 * F);  // harmonic_re_v3_conjA_v1_F
  }
};

inline constexpr BlockFunctions blocks[27] = {modulation_functions<Model, modulation_of_v1>(),
    modulation_functions<Model, modulation_of_v2>(), harmonic_functions<Model, harmonic_Omega_of_v1>(),
    harmonic_functions<Model, harmonic_minus_2_omega1_plus_omega2_of_v1>(),
    harmonic_functions<Model, harmonic_omega2_of_v1>(),
    harmonic_functions<Model, harmonic_minus_omega1_plus_2_omega2_of_v1>(),
    harmonic_functions<Model, harmonic_omega2_plus_Omega_of_v1>(),
    harmonic_functions<Model, harmonic_3_omega2_of_v1>(),
    harmonic_functions<Model, harmonic_omega1_plus_Omega_of_v1>(),
    harmonic_functions<Model, harmonic_3_omega1_of_v1>(), harmonic_functions<Model, harmonic_Omega_of_v2>(),
    harmonic_functions<Model, harmonic_minus_2_omega1_plus_omega2_of_v2>(),
    harmonic_functions<Model, harmonic_minus_omega1_plus_2_omega2_of_v2>(),
    harmonic_functions<Model, harmonic_omega1_of_v2>(),
    harmonic_functions<Model, harmonic_omega2_plus_Omega_of_v2>(),
    harmonic_functions<Model, harmonic_3_omega2_of_v2>(),
    harmonic_functions<Model, harmonic_omega1_plus_Omega_of_v2>(),
    harmonic_functions<Model, harmonic_3_omega1_of_v2>(),
    harmonic_functions<Model, harmonic_minus_omega1_plus_omega2_of_v3>(),
    harmonic_functions<Model, harmonic_0_of_v3>(), harmonic_functions<Model, harmonic_Omega_of_v3>(),
    harmonic_functions<Model, harmonic_2_omega2_of_v3>(), harmonic_functions<Model, harmonic_2_omega1_of_v3>(),
    harmonic_functions<Model, harmonic_minus_omega1_plus_Omega_of_v3>(),
    harmonic_functions<Model, harmonic_minus_omega2_plus_Omega_of_v3>(),
    harmonic_functions<Model, harmonic_omega2_plus_Omega_of_v3>(),
    harmonic_functions<Model, harmonic_omega1_plus_Omega_of_v3>()};

}  // namespace additive_combination
}  // namespace secular::generated::three_modes
