// Model two_mass_lumps: generated code, never edited by hand.
// Holds rows of the case additive_combination. Made by: secular generate two_mass_lumps.
// Omega = omega1 + omega2 + eps*sigma, multiple scales to eps^1. Valid near that resonance for small
// amplitudes; what is left out is of order eps^2.
#pragma once

#include "two_mass_lumps.hpp"

namespace secular::generated::two_mass_lumps {

namespace additive_combination {

/// (rate - i*omega1)*A_v1 = -mu11*A_v1 + 1/(2*omega1)*i*lambda*A_v1 + 1/(4*omega1)*i*kappa*A_v1*F^2 -
/// 3*omega1^2/2*mu13*A_v1^2*conj(A_v1) + 3/(2*omega1)*i*alpha1*A_v1^2*conj(A_v1) -
/// omega2/(4*omega1)*q1*conj(A_v2)*F - 1/(4*omega1)*i*p*conj(A_v2)*F
struct modulation_of_v1 : BlockShape<7, 7, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 7> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    return {-1.0, 1.0 / (2.0 * omega1), 1.0 / (4.0 * omega1), -3.0 * omega1_2 / 2.0, 3.0 / (2.0 * omega1),
        -omega2 / (4.0 * omega1), -1.0 / (4.0 * omega1)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, norm_F] = signals;
    column[0] = factor[0] * A_v1;  // mu11
    column[1] = times_i(factor[1] * A_v1);  // lambda
    column[2] = times_i(factor[2] * (A_v1 * norm_F));  // kappa
    column[3] = factor[3] * (norm_A_v1 * A_v1);  // mu13
    column[4] = times_i(factor[4] * (norm_A_v1 * A_v1));  // alpha1
    column[5] = factor[5] * (conj_A_v2 * F);  // q1
    column[6] = times_i(factor[6] * (conj_A_v2 * F));  // p
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, norm_F] = signals;
    by[0] = ComplexNumber<double>(lump[0] * factor[0] + 2.0 * lump[3] * factor[3] * norm_A_v1, lump[1] * factor[1]
        + lump[2] * factor[2] * norm_F + 2.0 * lump[4] * factor[4] * norm_A_v1);
    by_conjugate[0] = lump[3] * factor[3] * (A_v1 * A_v1) + times_i(lump[4] * factor[4] * (A_v1 * A_v1));
    by_conjugate[1] = lump[5] * factor[5] * F + times_i(lump[6] * factor[6] * F);
  }
};

/// (rate - i*omega2)*A_v2 = -1/(4*omega2)*i*p*conj(A_v1)*F - mu22*A_v2 - 3*omega2^2/2*mu23*A_v2^2*conj(A_v2) +
/// 3/(2*omega2)*i*alpha2*A_v2^2*conj(A_v2) - omega1/(4*omega2)*q2*conj(A_v1)*F
struct modulation_of_v2 : BlockShape<5, 5, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 5> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega2_2 = omega2 * omega2;
    return {-1.0 / (4.0 * omega2), -1.0, -3.0 * omega2_2 / 2.0, 3.0 / (2.0 * omega2), -omega1 / (4.0 * omega2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, norm_F] = signals;
    column[0] = times_i(factor[0] * (conj_A_v1 * F));  // p
    column[1] = factor[1] * A_v2;  // mu22
    column[2] = factor[2] * (norm_A_v2 * A_v2);  // mu23
    column[3] = times_i(factor[3] * (norm_A_v2 * A_v2));  // alpha2
    column[4] = factor[4] * (conj_A_v1 * F);  // q2
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, norm_F] = signals;
    by_conjugate[0] = lump[4] * factor[4] * F + times_i(lump[0] * factor[0] * F);
    by[1] = ComplexNumber<double>(lump[1] * factor[1]
        + 2.0 * lump[2] * factor[2] * norm_A_v2, 2.0 * lump[3] * factor[3] * norm_A_v2);
    by_conjugate[1] = lump[2] * factor[2] * (A_v2 * A_v2) + times_i(lump[3] * factor[3] * (A_v2 * A_v2));
  }
};

/// amplitude of exp(i*(omega2 + Omega)*t) in v1 = -1/(16*Omega*(omega1 - Omega))*kappa*conj(A_v1)*F^2 +
/// omega2/(2*(omega1 + omega2 + Omega)*(omega1 - omega2 - Omega))*i*q1*A_v2*F + 1/(2*(omega1 + omega2 +
/// Omega)*(omega1 - omega2 - Omega))*p*A_v2*F
struct harmonic_omega2_plus_Omega_of_v1 : BlockShape<3, 3, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 3> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 - Omega);
    const Number per_1 = 1.0 / (omega1 + omega2 + Omega);
    const Number per_2 = 1.0 / (omega1 - omega2 - Omega);
    const Number over_0 = per_1 * per_2;
    return {-per_0 / (16.0 * Omega), omega2 * over_0 / 2.0, over_0 / 2.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, norm_F] = signals;
    column[0] = factor[0] * (conj_A_v1 * F * F);  // kappa
    column[1] = times_i(factor[1] * (A_v2 * F));  // q1
    column[2] = factor[2] * (A_v2 * F);  // p
  }
};

/// amplitude of exp(i*(omega1 + 2*Omega)*t) in v1 = 1/(16*Omega*(omega1 + Omega))*kappa*A_v1*F^2
struct harmonic_omega1_plus_2_Omega_of_v1 : BlockShape<1, 1, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 + Omega);
    return {per_0 / (16.0 * Omega)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, norm_F] = signals;
    column[0] = factor[0] * (A_v1 * F * F);  // kappa
  }
};

/// amplitude of exp(i*(3*omega1)*t) in v1 = -omega1/8*i*mu13*A_v1^3 + 1/(8*omega1^2)*alpha1*A_v1^3
struct harmonic_3_omega1_of_v1 : BlockShape<2, 2, follows_modes> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    return {-omega1 / 8.0, 1.0 / (8.0 * omega1_2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, norm_F] = signals;
    column[0] = times_i(factor[0] * (A_v1 * A_v1 * A_v1));  // mu13
    column[1] = factor[1] * (A_v1 * A_v1 * A_v1);  // alpha1
  }
};

/// amplitude of exp(i*(3*omega2)*t) in v2 = -omega2/8*i*mu23*A_v2^3 + 1/(8*omega2^2)*alpha2*A_v2^3
struct harmonic_3_omega2_of_v2 : BlockShape<2, 2, follows_modes> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega2_2 = omega2 * omega2;
    return {-omega2 / 8.0, 1.0 / (8.0 * omega2_2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, norm_F] = signals;
    column[0] = times_i(factor[0] * (A_v2 * A_v2 * A_v2));  // mu23
    column[1] = factor[1] * (A_v2 * A_v2 * A_v2);  // alpha2
  }
};

/// amplitude of exp(i*(omega1 + Omega)*t) in v2 = -1/(2*(omega1 + omega2 + Omega)*(omega1 - omega2 +
/// Omega))*p*A_v1*F - omega1/(2*(omega1 + omega2 + Omega)*(omega1 - omega2 + Omega))*i*q2*A_v1*F
struct harmonic_omega1_plus_Omega_of_v2 : BlockShape<2, 2, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 + omega2 + Omega);
    const Number per_1 = 1.0 / (omega1 - omega2 + Omega);
    const Number over_0 = per_0 * per_1;
    return {-over_0 / 2.0, -omega1 * over_0 / 2.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, norm_F] = signals;
    column[0] = factor[0] * (A_v1 * F);  // p
    column[1] = times_i(factor[1] * (A_v1 * F));  // q2
  }
};

inline constexpr BlockFunctions blocks[7] = {modulation_functions<Model, modulation_of_v1>(),
    modulation_functions<Model, modulation_of_v2>(),
    harmonic_functions<Model, harmonic_omega2_plus_Omega_of_v1>(),
    harmonic_functions<Model, harmonic_omega1_plus_2_Omega_of_v1>(),
    harmonic_functions<Model, harmonic_3_omega1_of_v1>(), harmonic_functions<Model, harmonic_3_omega2_of_v2>(),
    harmonic_functions<Model, harmonic_omega1_plus_Omega_of_v2>()};

}  // namespace additive_combination
}  // namespace secular::generated::two_mass_lumps
