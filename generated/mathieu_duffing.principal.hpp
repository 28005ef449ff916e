// Model mathieu_duffing: generated code, never edited by hand.
// Holds rows of the case principal. Made by: secular generate mathieu_duffing.
// Omega = 2*omega0 + eps*sigma, multiple scales to eps^2. Valid near that resonance for small amplitudes; what
// is left out is of order eps^3.
#pragma once

#include "mathieu_duffing.hpp"

namespace secular::generated::mathieu_duffing {

namespace principal {

/// (rate - i*omega0)*A_x = i*conservative_x_A_x3_F*A_x^3*F - 3/7*i*conservative_x_A_x3_F*A_x*conj(A_x)^2*F -
/// mu*A_x + i*conservative_x_A_x*A_x + i*conservative_x_A_x_F2*A_x*F^2 +
/// dissipative_x_A_x2_conjA_x*A_x^2*conj(A_x) + 3/(2*omega0)*i*a3*A_x^2*conj(A_x) +
/// i*conservative_x_A_x3_conjA_x2*A_x^3*conj(A_x)^2 + 1/(4*omega0)*i*h*conj(A_x)*F + (2*omega0 -
/// Omega)/(8*omega0^2)*i*h*conj(A_x)*F
struct modulation_of_x : BlockShape<8, 6, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 6> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    return {1.0, -3.0 / 7.0, -1.0, 3.0 / (2.0 * omega0), 1.0 / (4.0 * omega0),
        (2.0 * omega0 - Omega) / (8.0 * omega0_2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    // conservative_x_A_x3_F
    column[0] = times_i(factor[0] * (A_x * A_x * A_x * conj_F)) + times_i(factor[1] * (norm_A_x * conj_A_x * F));
    column[1] = factor[2] * A_x;  // mu
    column[2] = times_i(factor[0] * A_x);  // conservative_x_A_x
    column[3] = times_i(factor[0] * (A_x * norm_F));  // conservative_x_A_x_F2
    column[4] = factor[0] * (norm_A_x * A_x);  // dissipative_x_A_x2_conjA_x
    column[5] = times_i(factor[3] * (norm_A_x * A_x));  // a3
    column[6] = times_i(factor[0] * (norm_A_x * norm_A_x * A_x));  // conservative_x_A_x3_conjA_x2
    column[7] = times_i(factor[4] * (conj_A_x * F)) + times_i(factor[5] * (conj_A_x * F));  // h
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    by[0] = ComplexNumber<double>(lump[1] * factor[2] + 2.0 * lump[4] * factor[0] * norm_A_x, lump[2] * factor[0]
        + lump[3] * factor[0] * norm_F + 2.0 * lump[5] * factor[3] * norm_A_x
        + 3.0 * lump[6] * factor[0] * (norm_A_x * norm_A_x))
        + times_i(3.0 * lump[0] * factor[0] * (A_x * A_x * conj_F)
        + lump[0] * factor[1] * (conj_A_x * conj_A_x * F));
    by_conjugate[0] = lump[4] * factor[0] * (A_x * A_x) + times_i(2.0 * lump[0] * factor[1] * (norm_A_x * F)
        + lump[5] * factor[3] * (A_x * A_x) + 2.0 * lump[6] * factor[0] * (norm_A_x * A_x * A_x)
        + lump[7] * factor[4] * F + lump[7] * factor[5] * F);
  }
};

/// amplitude of exp(i*(omega0 + Omega)*t) in x = (48*omega0^3 - 48*omega0^2*Omega)/(7*Omega^2*(2*omega0 +
/// Omega)^2)*conservative_x_A_x3_F*A_x^2*conj(A_x)*F - 9/(28*omega0)*conservative_x_A_x3_F*A_x^2*conj(A_x)*F +
/// (-16*omega0^3 - 16*omega0^2*Omega)/(3*Omega^2*(2*omega0 + Omega)^2)*conservative_x_A_x_F2*conj(A_x)*F^2 -
/// 1/(8*omega0)*i*dissipative_x_A_x2_conjA_x*A_x^3 + 1/(8*omega0^2)*a3*A_x^3 +
/// 7/(20*omega0)*conservative_x_A_x3_conjA_x2*A_x^4*conj(A_x) + 1/(2*Omega*(2*omega0 + Omega))*h*A_x*F
struct harmonic_omega0_plus_Omega_of_x : BlockShape<6, 7, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 7> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    const Number omega0_3 = omega0_2 * omega0;
    const Number Omega_2 = Omega * Omega;
    const Number per_0 = 1.0 / (2.0 * omega0 + Omega);
    const Number per_0_2 = per_0 * per_0;
    return {(48.0 * omega0_3 - 48.0 * omega0_2 * Omega) * per_0_2 / (7.0 * Omega_2), -9.0 / (28.0 * omega0),
        (-16.0 * omega0_3 - 16.0 * omega0_2 * Omega) * per_0_2 / (3.0 * Omega_2), -1.0 / (8.0 * omega0),
        1.0 / (8.0 * omega0_2), 7.0 / (20.0 * omega0), per_0 / (2.0 * Omega)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (norm_A_x * A_x * F) + factor[1] * (norm_A_x * A_x * F);  // conservative_x_A_x3_F
    column[1] = factor[2] * (conj_A_x * F * F);  // conservative_x_A_x_F2
    column[2] = times_i(factor[3] * (A_x * A_x * A_x));  // dissipative_x_A_x2_conjA_x
    column[3] = factor[4] * (A_x * A_x * A_x);  // a3
    column[4] = factor[5] * (norm_A_x * A_x * A_x * A_x);  // conservative_x_A_x3_conjA_x2
    column[5] = factor[6] * (A_x * F);  // h
  }
};

/// amplitude of exp(i*(omega0 + 2*Omega)*t) in x = (48*omega0^3 + 4*omega0^2*Omega +
/// 2*omega0*Omega^2)/(7*Omega*(2*omega0 + Omega)^2*(4*omega0 + Omega))*conservative_x_A_x3_F*A_x^3*F +
/// 4*omega0^3/(3*Omega^2*(omega0 + Omega)*(2*omega0 + Omega))*conservative_x_A_x_F2*A_x*F^2 -
/// 1/(60*omega0)*conservative_x_A_x3_conjA_x2*A_x^5
struct harmonic_omega0_plus_2_Omega_of_x : BlockShape<3, 3, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 3> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    const Number omega0_3 = omega0_2 * omega0;
    const Number Omega_2 = Omega * Omega;
    const Number per_0 = 1.0 / (2.0 * omega0 + Omega);
    const Number per_0_2 = per_0 * per_0;
    const Number per_1 = 1.0 / (4.0 * omega0 + Omega);
    const Number per_2 = 1.0 / (omega0 + Omega);
    const Number over_0 = per_0_2 * per_1;
    const Number over_1 = per_2 * per_0;
    return {(48.0 * omega0_3 + 4.0 * omega0_2 * Omega + 2.0 * omega0 * Omega_2) * over_0 / (7.0 * Omega),
        4.0 * omega0_3 * over_1 / (3.0 * Omega_2), -1.0 / (60.0 * omega0)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_x * A_x * A_x * F);  // conservative_x_A_x3_F
    column[1] = factor[1] * (A_x * F * F);  // conservative_x_A_x_F2
    column[2] = factor[2] * fixed_power<5>(A_x);  // conservative_x_A_x3_conjA_x2
  }
};

inline constexpr BlockFunctions blocks[3] = {modulation_functions<Model, modulation_of_x>(),
    harmonic_functions<Model, harmonic_omega0_plus_Omega_of_x>(),
    harmonic_functions<Model, harmonic_omega0_plus_2_Omega_of_x>()};

}  // namespace principal
}  // namespace secular::generated::mathieu_duffing
