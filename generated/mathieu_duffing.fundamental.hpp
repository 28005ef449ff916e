// Model mathieu_duffing: generated code, never edited by hand.
// Holds rows of the case fundamental. Made by: secular generate mathieu_duffing.
// Omega = omega0 + eps^2*sigma, multiple scales to eps^2. Valid near that resonance for small amplitudes; what
// is left out is of order eps^3.
#pragma once

#include "mathieu_duffing.hpp"

namespace secular::generated::mathieu_duffing {

namespace fundamental {

/// (rate - i*omega0)*A_x = -mu*A_x + i*conservative_x_A_x_F2*A_x*F^2 + 3/2*i*conservative_x_A_x_F2*conj(A_x)*F^2
/// + 3/(2*omega0)*i*a3*A_x^2*conj(A_x)
struct modulation_of_x : BlockShape<3, 4, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 4> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    return {-1.0, 1.0, 3.0 / 2.0, 3.0 / (2.0 * omega0)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * A_x;  // mu
    // conservative_x_A_x_F2
    column[1] = times_i(factor[1] * (A_x * norm_F)) + times_i(factor[2] * (conj_A_x * F * F));
    column[2] = times_i(factor[3] * (norm_A_x * A_x));  // a3
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    by[0] = ComplexNumber<double>(lump[0] * factor[0], lump[1] * factor[1] * norm_F
        + 2.0 * lump[2] * factor[3] * norm_A_x);
    by_conjugate[0] = times_i(lump[1] * factor[2] * (F * F) + lump[2] * factor[3] * (A_x * A_x));
  }
};

/// amplitude of exp(i*(0)*t) in x = -1/(2*Omega*(2*omega0 - Omega))*h*conj(A_x)*F - 1/(2*Omega*(2*omega0 -
/// Omega))*h*A_x*F
struct harmonic_0_of_x : BlockShape<1, 1, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number per_0 = 1.0 / (2.0 * omega0 - Omega);
    return {-per_0 / (2.0 * Omega)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (conj_A_x * F) + factor[0] * (A_x * conj_F);  // h
  }
};

/// amplitude of exp(i*(omega0 + Omega)*t) in x = 1/(2*Omega*(2*omega0 + Omega))*h*A_x*F
struct harmonic_omega0_plus_Omega_of_x : BlockShape<1, 1, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number per_0 = 1.0 / (2.0 * omega0 + Omega);
    return {per_0 / (2.0 * Omega)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_x * F);  // h
  }
};

/// amplitude of exp(i*(omega0 + 2*Omega)*t) in x = -3*omega0^3/(4*Omega^2*(omega0 + Omega)*(2*omega0 +
/// Omega))*conservative_x_A_x_F2*A_x*F^2 + 1/(8*omega0^2)*a3*A_x^3
struct harmonic_omega0_plus_2_Omega_of_x : BlockShape<2, 2, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    const Number omega0_3 = omega0_2 * omega0;
    const Number Omega_2 = Omega * Omega;
    const Number per_0 = 1.0 / (omega0 + Omega);
    const Number per_1 = 1.0 / (2.0 * omega0 + Omega);
    const Number over_0 = per_0 * per_1;
    return {-3.0 * omega0_3 * over_0 / (4.0 * Omega_2), 1.0 / (8.0 * omega0_2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_x * F * F);  // conservative_x_A_x_F2
    column[1] = factor[1] * (A_x * A_x * A_x);  // a3
  }
};

inline constexpr BlockFunctions blocks[4] = {modulation_functions<Model, modulation_of_x>(),
    harmonic_functions<Model, harmonic_0_of_x>(), harmonic_functions<Model, harmonic_omega0_plus_Omega_of_x>(),
    harmonic_functions<Model, harmonic_omega0_plus_2_Omega_of_x>()};

}  // namespace fundamental
}  // namespace secular::generated::mathieu_duffing
