// Model two_mass_mode1: generated code, never edited by hand.
// Holds rows of the case primary. Made by: secular generate two_mass_mode1.
// Omega = omega0 + eps^2*sigma, multiple scales to eps^2. Valid near that resonance for small amplitudes; what
// is left out is of order eps^3.
#pragma once

#include "two_mass_mode1.principal_parametric.hpp"
#include "two_mass_mode1.hpp"

namespace secular::generated::two_mass_mode1 {

namespace primary {

/// (rate - i*omega0)*A_v = i*conservative_v_A_v2_F*A_v^2*F + 2*i*conservative_v_A_v2_F*A_v*conj(A_v)*F - mu1*A_v
/// + i*conservative_v_A_v_F2*A_v*F^2 + 3/2*i*conservative_v_A_v_F2*conj(A_v)*F^2 -
/// 8*omega0/(3*Pi)*mu2*A_v*abs(A_v) - 3*omega0^2/2*mu3*A_v^2*conj(A_v) + 4/omega0*i*alpha_e*A_v^2*conj(A_v) -
/// 1/(4*omega0)*i*eta1*F
struct modulation_of_v : BlockShape<7, 8, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 8> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const double pi = std::numbers::pi;
    const Number omega0_2 = omega0 * omega0;
    return {1.0, 2.0, -1.0, 3.0 / 2.0, -8.0 * omega0 / (3.0 * pi), -3.0 * omega0_2 / 2.0, 4.0 / omega0,
        -1.0 / (4.0 * omega0)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v, conj_A_v, norm_A_v, abs_A_v, inverse_abs_A_v, unit_A_v, F, conj_F, norm_F] = signals;
    // conservative_v_A_v2_F
    column[0] = times_i(factor[0] * (A_v * A_v * conj_F)) + times_i(factor[1] * (norm_A_v * F));
    column[1] = factor[2] * A_v;  // mu1
    // conservative_v_A_v_F2
    column[2] = times_i(factor[0] * (A_v * norm_F)) + times_i(factor[3] * (conj_A_v * F * F));
    column[3] = factor[4] * (abs_A_v * A_v);  // mu2
    column[4] = factor[5] * (norm_A_v * A_v);  // mu3
    column[5] = times_i(factor[6] * (norm_A_v * A_v));  // alpha_e
    column[6] = times_i(factor[7] * F);  // eta1
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_v, conj_A_v, norm_A_v, abs_A_v, inverse_abs_A_v, unit_A_v, F, conj_F, norm_F] = signals;
    by[0] = ComplexNumber<double>(lump[1] * factor[2] + 1.5 * lump[3] * factor[4] * abs_A_v
        + 2.0 * lump[4] * factor[5] * norm_A_v, lump[2] * factor[0] * norm_F
        + 2.0 * lump[5] * factor[6] * norm_A_v) + times_i(2.0 * lump[0] * factor[0] * (A_v * conj_F)
        + lump[0] * factor[1] * (conj_A_v * F));
    by_conjugate[0] = 0.5 * lump[3] * factor[4] * (unit_A_v * A_v) + lump[4] * factor[5] * (A_v * A_v)
        + times_i(lump[0] * factor[1] * (A_v * F) + lump[2] * factor[3] * (F * F)
        + lump[5] * factor[6] * (A_v * A_v));
  }
};

/// amplitude of exp(i*(0)*t) in v = 1/(2*Omega*(2*omega0 - Omega))*eta2*conj(A_v)*F + 1/(2*Omega*(2*omega0 -
/// Omega))*eta2*A_v*F - 2/omega0^2*alpha_0*A_v*conj(A_v)
struct harmonic_0_of_v : BlockShape<2, 2, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    const Number per_0 = 1.0 / (2.0 * omega0 - Omega);
    return {per_0 / (2.0 * Omega), -2.0 / omega0_2};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v, conj_A_v, norm_A_v, abs_A_v, inverse_abs_A_v, unit_A_v, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (conj_A_v * F) + factor[0] * (A_v * conj_F);  // eta2
    column[1] = ComplexNumber<Number>(factor[1] * norm_A_v);  // alpha_0
  }
};

/// amplitude of exp(i*(omega0 + Omega)*t) in v = -1/(2*Omega*(2*omega0 + Omega))*eta2*A_v*F +
/// 1/(3*omega0^2)*alpha_q*A_v^2
struct harmonic_omega0_plus_Omega_of_v : BlockShape<2, 2, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    const Number per_0 = 1.0 / (2.0 * omega0 + Omega);
    return {-per_0 / (2.0 * Omega), 1.0 / (3.0 * omega0_2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v, conj_A_v, norm_A_v, abs_A_v, inverse_abs_A_v, unit_A_v, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_v * F);  // eta2
    column[1] = factor[1] * (A_v * A_v);  // alpha_q
  }
};

/// amplitude of exp(i*(omega0 + 2*Omega)*t) in v = -1/(8*omega0)*conservative_v_A_v_F2*A_v*F^2 -
/// 2/(15*Pi)*i*mu2*A_v^3*abs(A_v)^-1 - omega0/8*i*mu3*A_v^3 + harmonic_re_v_A_v2_F*A_v^2*F +
/// harmonic_re_v_A_v3*A_v^3
struct harmonic_omega0_plus_2_Omega_of_v : BlockShape<5, 4, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 4> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const double pi = std::numbers::pi;
    return {-1.0 / (8.0 * omega0), -2.0 / (15.0 * pi), -omega0 / 8.0, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v, conj_A_v, norm_A_v, abs_A_v, inverse_abs_A_v, unit_A_v, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_v * F * F);  // conservative_v_A_v_F2
    column[1] = times_i(factor[1] * (unit_A_v * A_v * A_v));  // mu2
    column[2] = times_i(factor[2] * (A_v * A_v * A_v));  // mu3
    column[3] = factor[3] * (A_v * A_v * F);  // harmonic_re_v_A_v2_F
    column[4] = factor[3] * (A_v * A_v * A_v);  // harmonic_re_v_A_v3
  }
};

inline constexpr BlockFunctions blocks[7] = {modulation_functions<Model, modulation_of_v>(),
    harmonic_functions<Model, harmonic_0_of_v>(), harmonic_functions<Model, harmonic_omega0_plus_Omega_of_v>(),
    harmonic_functions<Model, harmonic_omega0_plus_2_Omega_of_v>(),
    harmonic_functions<Model, principal_parametric::harmonic_5_omega0_of_v>(),
    harmonic_functions<Model, principal_parametric::harmonic_7_omega0_of_v>(),
    harmonic_functions<Model, principal_parametric::harmonic_9_omega0_of_v>()};

}  // namespace primary
}  // namespace secular::generated::two_mass_mode1
