// Model duffing: generated code, never edited by hand.
// Holds rows of the case subharmonic_3. Made by: secular generate duffing.
// Omega = 3*omega0 + eps*sigma, multiple scales to eps^1. Valid near that resonance for small amplitudes; what
// is left out is of order eps^2.
#pragma once

#include "duffing.hpp"

namespace secular::generated::duffing {

namespace subharmonic_3 {

/// (rate - i*omega0)*A_x = -mu*A_x + i*conservative_x_A_x_F2*A_x*F^2 + 3/(2*omega0)*i*a3*A_x^2*conj(A_x) +
/// i*conservative_x_conjA_x2_F*conj(A_x)^2*F
struct modulation_of_x : BlockShape<4, 3, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 3> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    return {-1.0, 1.0, 3.0 / (2.0 * omega0)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * A_x;  // mu
    column[1] = times_i(factor[1] * (A_x * norm_F));  // conservative_x_A_x_F2
    column[2] = times_i(factor[2] * (norm_A_x * A_x));  // a3
    column[3] = times_i(factor[1] * (conj_A_x * conj_A_x * F));  // conservative_x_conjA_x2_F
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    by[0] = ComplexNumber<double>(lump[0] * factor[0], lump[1] * factor[1] * norm_F
        + 2.0 * lump[2] * factor[2] * norm_A_x);
    by_conjugate[0] = times_i(lump[2] * factor[2] * (A_x * A_x) + 2.0 * lump[3] * factor[1] * (conj_A_x * F));
  }
};

/// amplitude of exp(i*(Omega)*t) in x = 1/(8*omega0^2)*a3*A_x^3 +
/// 1/(2*omega0)*conservative_x_conjA_x2_F*A_x*conj(A_x)*F - 1/(16*omega0^2)*e*F + (-9*omega0 +
/// 3*Omega)/(64*omega0^3)*e*F + i*harmonic_im_x_F*F + harmonic_re_x_F3*F^3
struct harmonic_Omega_of_x : BlockShape<5, 5, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 5> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    const Number omega0_3 = omega0_2 * omega0;
    return {1.0 / (8.0 * omega0_2), 1.0 / (2.0 * omega0), -1.0 / (16.0 * omega0_2),
        (-9.0 * omega0 + 3.0 * Omega) / (64.0 * omega0_3), 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_x * A_x * A_x);  // a3
    column[1] = factor[1] * (norm_A_x * F);  // conservative_x_conjA_x2_F
    column[2] = factor[2] * F + factor[3] * F;  // e
    column[3] = times_i(factor[4] * F);  // harmonic_im_x_F
    column[4] = factor[4] * (norm_F * F);  // harmonic_re_x_F3
  }
};

/// amplitude of exp(i*(-omega0 + Omega)*t) in x = harmonic_re_x_conjA_x_F*conj(A_x)*F + 1/(3*omega0^2)*a2*A_x^2
struct harmonic_minus_omega0_plus_Omega_of_x : BlockShape<2, 2, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    return {1.0, 1.0 / (3.0 * omega0_2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (conj_A_x * F);  // harmonic_re_x_conjA_x_F
    column[1] = factor[1] * (A_x * A_x);  // a2
  }
};

/// amplitude of exp(i*(-omega0 + 2*Omega)*t) in x = -16*omega0^5/(Omega*(omega0 + Omega)^2*(omega0 -
/// Omega)^3)*conservative_x_A_x_F2*conj(A_x)*F^2 - 16*omega0^3/((omega0 + Omega)^2*(omega0 - Omega)*(3*omega0 +
/// Omega))*conservative_x_conjA_x2_F*A_x^2*F
struct harmonic_minus_omega0_plus_2_Omega_of_x : BlockShape<2, 2, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    const Number omega0_3 = omega0_2 * omega0;
    const Number omega0_4 = omega0_3 * omega0;
    const Number omega0_5 = omega0_4 * omega0;
    const Number per_0 = 1.0 / (omega0 + Omega);
    const Number per_0_2 = per_0 * per_0;
    const Number per_1 = 1.0 / (omega0 - Omega);
    const Number per_1_2 = per_1 * per_1;
    const Number per_1_3 = per_1_2 * per_1;
    const Number per_2 = 1.0 / (3.0 * omega0 + Omega);
    const Number over_0 = per_0_2 * per_1_3;
    const Number over_1 = per_0_2 * per_1 * per_2;
    return {-16.0 * omega0_5 * over_0 / Omega, -16.0 * omega0_3 * over_1};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (conj_A_x * F * F);  // conservative_x_A_x_F2
    column[1] = factor[1] * (A_x * A_x * F);  // conservative_x_conjA_x2_F
  }
};

/// amplitude of exp(i*(0)*t) in x = -2/omega0^2*a2*A_x*conj(A_x) + harmonic_re_x_F2*F^2
struct harmonic_0_of_x : BlockShape<2, 2, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    return {-2.0 / omega0_2, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = ComplexNumber<Number>(factor[0] * norm_A_x);  // a2
    column[1] = ComplexNumber<Number>(factor[1] * norm_F);  // harmonic_re_x_F2
  }
};

/// amplitude of exp(i*(2*Omega)*t) in x = 32*omega0^6/((omega0 + Omega)^2*(omega0 + 2*Omega)*(omega0 -
/// Omega)^2*(omega0 - 2*Omega))*harmonic_re_x_F2*F^2
struct harmonic_2_Omega_of_x : BlockShape<1, 1, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    const Number omega0_3 = omega0_2 * omega0;
    const Number omega0_4 = omega0_3 * omega0;
    const Number omega0_5 = omega0_4 * omega0;
    const Number omega0_6 = omega0_5 * omega0;
    const Number per_0 = 1.0 / (omega0 + Omega);
    const Number per_0_2 = per_0 * per_0;
    const Number per_1 = 1.0 / (omega0 + 2.0 * Omega);
    const Number per_2 = 1.0 / (omega0 - Omega);
    const Number per_2_2 = per_2 * per_2;
    const Number per_3 = 1.0 / (omega0 - 2.0 * Omega);
    const Number over_0 = per_0_2 * per_1 * per_2_2 * per_3;
    return {32.0 * omega0_6 * over_0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (F * F);  // harmonic_re_x_F2
  }
};

/// amplitude of exp(i*(3*Omega)*t) in x = 4096*omega0^8/(3*(omega0 + Omega)^3*(omega0 + 3*Omega)*(omega0 -
/// Omega)^3*(omega0 - 3*Omega))*harmonic_re_x_F3*F^3
struct harmonic_3_Omega_of_x : BlockShape<1, 1, follows_modes | follows_excitation | is_forced> {
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
    const Number per_0 = 1.0 / (omega0 + Omega);
    const Number per_0_2 = per_0 * per_0;
    const Number per_0_3 = per_0_2 * per_0;
    const Number per_1 = 1.0 / (omega0 + 3.0 * Omega);
    const Number per_2 = 1.0 / (omega0 - Omega);
    const Number per_2_2 = per_2 * per_2;
    const Number per_2_3 = per_2_2 * per_2;
    const Number per_3 = 1.0 / (omega0 - 3.0 * Omega);
    const Number over_0 = per_0_3 * per_1 * per_2_3 * per_3;
    return {4096.0 * omega0_8 * over_0 / 3.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (F * F * F);  // harmonic_re_x_F3
  }
};

/// amplitude of exp(i*(omega0 + Omega)*t) in x = -24*omega0^4/(Omega*(omega0 + Omega)*(omega0 - Omega)*(2*omega0
/// + Omega))*harmonic_re_x_conjA_x_F*A_x*F
struct harmonic_omega0_plus_Omega_of_x : BlockShape<1, 1, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    const Number omega0_3 = omega0_2 * omega0;
    const Number omega0_4 = omega0_3 * omega0;
    const Number per_0 = 1.0 / (omega0 + Omega);
    const Number per_1 = 1.0 / (omega0 - Omega);
    const Number per_2 = 1.0 / (2.0 * omega0 + Omega);
    const Number over_0 = per_0 * per_1 * per_2;
    return {-24.0 * omega0_4 * over_0 / Omega};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_x * F);  // harmonic_re_x_conjA_x_F
  }
};

/// amplitude of exp(i*(omega0 + 2*Omega)*t) in x = 16*omega0^5/(Omega*(omega0 + Omega)^3*(omega0 -
/// Omega)^2)*conservative_x_A_x_F2*A_x*F^2
struct harmonic_omega0_plus_2_Omega_of_x : BlockShape<1, 1, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    const Number omega0_3 = omega0_2 * omega0;
    const Number omega0_4 = omega0_3 * omega0;
    const Number omega0_5 = omega0_4 * omega0;
    const Number per_0 = 1.0 / (omega0 + Omega);
    const Number per_0_2 = per_0 * per_0;
    const Number per_0_3 = per_0_2 * per_0;
    const Number per_1 = 1.0 / (omega0 - Omega);
    const Number per_1_2 = per_1 * per_1;
    const Number over_0 = per_0_3 * per_1_2;
    return {16.0 * omega0_5 * over_0 / Omega};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_x * F * F);  // conservative_x_A_x_F2
  }
};

inline constexpr BlockFunctions blocks[9] = {modulation_functions<Model, modulation_of_x>(),
    harmonic_functions<Model, harmonic_Omega_of_x>(),
    harmonic_functions<Model, harmonic_minus_omega0_plus_Omega_of_x>(),
    harmonic_functions<Model, harmonic_minus_omega0_plus_2_Omega_of_x>(),
    harmonic_functions<Model, harmonic_0_of_x>(), harmonic_functions<Model, harmonic_2_Omega_of_x>(),
    harmonic_functions<Model, harmonic_3_Omega_of_x>(),
    harmonic_functions<Model, harmonic_omega0_plus_Omega_of_x>(),
    harmonic_functions<Model, harmonic_omega0_plus_2_Omega_of_x>()};

}  // namespace subharmonic_3
}  // namespace secular::generated::duffing
