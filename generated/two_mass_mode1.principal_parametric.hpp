// Model two_mass_mode1: generated code, never edited by hand.
// Holds rows of the case principal_parametric. Made by: secular generate two_mass_mode1.
// Omega = 2*omega0 + eps^2*sigma, multiple scales to eps^2. Valid near that resonance for small amplitudes;
// what is left out is of order eps^3.
#pragma once

#include "two_mass_mode1.hpp"

namespace secular::generated::two_mass_mode1 {

namespace principal_parametric {

/// (rate - i*omega0)*A_v = -mu1*A_v - 8*omega0/(3*Pi)*mu2*A_v*abs(A_v) - 3*omega0^2/2*mu3*A_v^2*conj(A_v) +
/// 4/omega0*i*alpha_e*A_v^2*conj(A_v) - 1/omega0*i*eta_e*conj(A_v)*F
struct modulation_of_v : BlockShape<5, 5, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 5> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const double pi = std::numbers::pi;
    const Number omega0_2 = omega0 * omega0;
    return {-1.0, -8.0 * omega0 / (3.0 * pi), -3.0 * omega0_2 / 2.0, 4.0 / omega0, -1.0 / omega0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v, conj_A_v, norm_A_v, abs_A_v, inverse_abs_A_v, unit_A_v, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * A_v;  // mu1
    column[1] = factor[1] * (abs_A_v * A_v);  // mu2
    column[2] = factor[2] * (norm_A_v * A_v);  // mu3
    column[3] = times_i(factor[3] * (norm_A_v * A_v));  // alpha_e
    column[4] = times_i(factor[4] * (conj_A_v * F));  // eta_e
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_v, conj_A_v, norm_A_v, abs_A_v, inverse_abs_A_v, unit_A_v, F, conj_F, norm_F] = signals;
    by[0] = ComplexNumber<double>(lump[0] * factor[0] + 1.5 * lump[1] * factor[1] * abs_A_v
        + 2.0 * lump[2] * factor[2] * norm_A_v, 2.0 * lump[3] * factor[3] * norm_A_v);
    by_conjugate[0] = 0.5 * lump[1] * factor[1] * (unit_A_v * A_v) + lump[2] * factor[2] * (A_v * A_v)
        + times_i(lump[3] * factor[3] * (A_v * A_v) + lump[4] * factor[4] * F);
  }
};

/// amplitude of exp(i*(0)*t) in v = -2/omega0^2*alpha_0*A_v*conj(A_v)
struct harmonic_0_of_v : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    return {-2.0 / omega0_2};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v, conj_A_v, norm_A_v, abs_A_v, inverse_abs_A_v, unit_A_v, F, conj_F, norm_F] = signals;
    column[0] = ComplexNumber<Number>(factor[0] * norm_A_v);  // alpha_0
  }
};

/// amplitude of exp(i*(Omega)*t) in v = 1/(2*(omega0 + Omega)*(omega0 - Omega))*eta1*F +
/// 1/(3*omega0^2)*alpha_q*A_v^2
struct harmonic_Omega_of_v : BlockShape<2, 2, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    const Number per_0 = 1.0 / (omega0 + Omega);
    const Number per_1 = 1.0 / (omega0 - Omega);
    const Number over_0 = per_0 * per_1;
    return {over_0 / 2.0, 1.0 / (3.0 * omega0_2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v, conj_A_v, norm_A_v, abs_A_v, inverse_abs_A_v, unit_A_v, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * F;  // eta1
    column[1] = factor[1] * (A_v * A_v);  // alpha_q
  }
};

/// amplitude of exp(i*(omega0 + Omega)*t) in v = -2/(15*Pi)*i*mu2*A_v^3*abs(A_v)^-1 - omega0/8*i*mu3*A_v^3 +
/// harmonic_re_v_A_v_F*A_v*F + harmonic_re_v_A_v3*A_v^3
struct harmonic_omega0_plus_Omega_of_v : BlockShape<4, 3, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 3> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const double pi = std::numbers::pi;
    return {-2.0 / (15.0 * pi), -omega0 / 8.0, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v, conj_A_v, norm_A_v, abs_A_v, inverse_abs_A_v, unit_A_v, F, conj_F, norm_F] = signals;
    column[0] = times_i(factor[0] * (unit_A_v * A_v * A_v));  // mu2
    column[1] = times_i(factor[1] * (A_v * A_v * A_v));  // mu3
    column[2] = factor[2] * (A_v * F);  // harmonic_re_v_A_v_F
    column[3] = factor[2] * (A_v * A_v * A_v);  // harmonic_re_v_A_v3
  }
};

/// amplitude of exp(i*(5*omega0)*t) in v = -2/(315*Pi)*i*mu2*A_v^5*abs(A_v)^-3
struct harmonic_5_omega0_of_v : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    const double pi = std::numbers::pi;
    return {-2.0 / (315.0 * pi)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v, conj_A_v, norm_A_v, abs_A_v, inverse_abs_A_v, unit_A_v, F, conj_F, norm_F] = signals;
    column[0] = times_i(factor[0] * (unit_A_v * unit_A_v * unit_A_v * A_v * A_v));  // mu2
  }
};

/// amplitude of exp(i*(7*omega0)*t) in v = -1/(945*Pi)*i*mu2*A_v^7*abs(A_v)^-5
struct harmonic_7_omega0_of_v : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    const double pi = std::numbers::pi;
    return {-1.0 / (945.0 * pi)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v, conj_A_v, norm_A_v, abs_A_v, inverse_abs_A_v, unit_A_v, F, conj_F, norm_F] = signals;
    column[0] = times_i(factor[0] * (fixed_power<5>(unit_A_v) * A_v * A_v));  // mu2
  }
};

/// amplitude of exp(i*(9*omega0)*t) in v = -1/(3465*Pi)*i*mu2*A_v^9*abs(A_v)^-7
struct harmonic_9_omega0_of_v : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    const double pi = std::numbers::pi;
    return {-1.0 / (3465.0 * pi)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v, conj_A_v, norm_A_v, abs_A_v, inverse_abs_A_v, unit_A_v, F, conj_F, norm_F] = signals;
    column[0] = times_i(factor[0] * (fixed_power<7>(unit_A_v) * A_v * A_v));  // mu2
  }
};

inline constexpr BlockFunctions blocks[7] = {modulation_functions<Model, modulation_of_v>(),
    harmonic_functions<Model, harmonic_0_of_v>(), harmonic_functions<Model, harmonic_Omega_of_v>(),
    harmonic_functions<Model, harmonic_omega0_plus_Omega_of_v>(),
    harmonic_functions<Model, harmonic_5_omega0_of_v>(), harmonic_functions<Model, harmonic_7_omega0_of_v>(),
    harmonic_functions<Model, harmonic_9_omega0_of_v>()};

}  // namespace principal_parametric
}  // namespace secular::generated::two_mass_mode1
