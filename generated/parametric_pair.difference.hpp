// Model parametric_pair: generated code, never edited by hand.
// Holds rows of the case difference. Made by: secular generate parametric_pair.
// Omega = omega2 - omega1 + eps*sigma, multiple scales to eps^1. Valid near that resonance for small
// amplitudes; what is left out is of order eps^2.
#pragma once

#include "parametric_pair.additive.hpp"
#include "parametric_pair.hpp"

namespace secular::generated::parametric_pair {

namespace difference {

/// (rate - i*omega1)*A_x = -1/(4*omega1)*i*p*A_y*F - mu1*A_x + 1/omega1*i*b3*A_x*A_y*conj(A_y) +
/// 3/(2*omega1)*i*b1*A_x^2*conj(A_x)
struct modulation_of_x : BlockShape<4, 4, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 4> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    return {-1.0 / (4.0 * omega1), -1.0, 1.0 / omega1, 3.0 / (2.0 * omega1)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    column[0] = times_i(factor[0] * (A_y * conj_F));  // p
    column[1] = factor[1] * A_x;  // mu1
    column[2] = times_i(factor[2] * (A_x * norm_A_y));  // b3
    column[3] = times_i(factor[3] * (norm_A_x * A_x));  // b1
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    by[0] = ComplexNumber<double>(lump[1] * factor[1], lump[2] * factor[2] * norm_A_y
        + 2.0 * lump[3] * factor[3] * norm_A_x);
    by_conjugate[0] = times_i(lump[3] * factor[3] * (A_x * A_x));
    by[1] = times_i(lump[0] * factor[0] * conj_F + lump[2] * factor[2] * (A_x * conj_A_y));
    by_conjugate[1] = times_i(lump[2] * factor[2] * (A_x * A_y));
  }
};

/// (rate - i*omega2)*A_y = 1/omega2*i*b3*A_x*conj(A_x)*A_y - mu2*A_y + 3/(2*omega2)*i*b5*A_y^2*conj(A_y) -
/// 1/(4*omega2)*i*q*A_x*F
struct modulation_of_y : BlockShape<4, 4, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 4> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    return {1.0 / omega2, -1.0, 3.0 / (2.0 * omega2), -1.0 / (4.0 * omega2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    column[0] = times_i(factor[0] * (norm_A_x * A_y));  // b3
    column[1] = factor[1] * A_y;  // mu2
    column[2] = times_i(factor[2] * (norm_A_y * A_y));  // b5
    column[3] = times_i(factor[3] * (A_x * F));  // q
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    by[0] = times_i(lump[0] * factor[0] * (conj_A_x * A_y) + lump[3] * factor[3] * F);
    by_conjugate[0] = times_i(lump[0] * factor[0] * (A_x * A_y));
    by[1] = ComplexNumber<double>(lump[1] * factor[1], lump[0] * factor[0] * norm_A_x
        + 2.0 * lump[2] * factor[2] * norm_A_y);
    by_conjugate[1] = times_i(lump[2] * factor[2] * (A_y * A_y));
  }
};

/// amplitude of exp(i*(omega2 + Omega)*t) in x = 1/(2*(omega1 + omega2 + Omega)*(omega1 - omega2 -
/// Omega))*p*A_y*F - 1/(4*omega2*(omega1 - omega2))*b3*conj(A_x)*A_y^2
struct harmonic_omega2_plus_Omega_of_x : BlockShape<2, 2, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 + omega2 + Omega);
    const Number per_1 = 1.0 / (omega1 - omega2 - Omega);
    const Number per_2 = 1.0 / (omega1 - omega2);
    const Number over_0 = per_0 * per_1;
    return {over_0 / 2.0, -per_2 / (4.0 * omega2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_y * F);  // p
    column[1] = factor[1] * (conj_A_x * A_y * A_y);  // b3
  }
};

/// amplitude of exp(i*(omega1 + 2*omega2)*t) in x = 1/(4*omega2*(omega1 + omega2))*b3*A_x*A_y^2
struct harmonic_omega1_plus_2_omega2_of_x : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 + omega2);
    return {per_0 / (4.0 * omega2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_x * A_y * A_y);  // b3
  }
};

/// amplitude of exp(i*(-omega1 + Omega)*t) in y = 1/(4*omega1*(omega1 - omega2))*b3*conj(A_x)^2*A_y -
/// 1/(2*(omega1 + omega2 - Omega)*(omega1 - omega2 - Omega))*q*conj(A_x)*F
struct harmonic_minus_omega1_plus_Omega_of_y : BlockShape<2, 2, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 - omega2);
    const Number per_1 = 1.0 / (omega1 + omega2 - Omega);
    const Number per_2 = 1.0 / (omega1 - omega2 - Omega);
    const Number over_0 = per_1 * per_2;
    return {per_0 / (4.0 * omega1), -over_0 / 2.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (conj_A_x * conj_A_x * A_y);  // b3
    column[1] = factor[1] * (conj_A_x * F);  // q
  }
};

/// amplitude of exp(i*(2*omega1 + omega2)*t) in y = 1/(4*omega1*(omega1 + omega2))*b3*A_x^2*A_y
struct harmonic_2_omega1_plus_omega2_of_y : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 + omega2);
    return {per_0 / (4.0 * omega1)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_x * A_x * A_y);  // b3
  }
};

inline constexpr BlockFunctions blocks[8] = {modulation_functions<Model, modulation_of_x>(),
    modulation_functions<Model, modulation_of_y>(), harmonic_functions<Model, harmonic_omega2_plus_Omega_of_x>(),
    harmonic_functions<Model, harmonic_omega1_plus_2_omega2_of_x>(),
    harmonic_functions<Model, additive::harmonic_3_omega1_of_x>(),
    harmonic_functions<Model, harmonic_minus_omega1_plus_Omega_of_y>(),
    harmonic_functions<Model, additive::harmonic_3_omega2_of_y>(),
    harmonic_functions<Model, harmonic_2_omega1_plus_omega2_of_y>()};

}  // namespace difference
}  // namespace secular::generated::parametric_pair
