// Model duffing: generated code, never edited by hand.
// Holds rows of the case free. Made by: secular generate duffing.
// free vibration, multiple scales to eps^2. Valid near that resonance for small amplitudes; what is left out is
// of order eps^3.
#pragma once

#include "duffing.hpp"

namespace secular::generated::duffing {

namespace free {

/// (rate - i*omega0)*A_x = -mu*A_x + i*conservative_x_A_x2_conjA_x*A_x^2*conj(A_x)
struct modulation_of_x : BlockShape<2, 2, 0> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>&) {
    return {-1.0, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * A_x;  // mu
    column[1] = times_i(factor[1] * (norm_A_x * A_x));  // conservative_x_A_x2_conjA_x
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    by[0] = ComplexNumber<double>(lump[0] * factor[0], 2.0 * lump[1] * factor[1] * norm_A_x);
    by_conjugate[0] = times_i(lump[1] * factor[1] * (A_x * A_x));
  }
};

/// amplitude of exp(i*(0)*t) in x = -2/omega0^2*a2*A_x*conj(A_x)
struct harmonic_0_of_x : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    return {-2.0 / omega0_2};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = ComplexNumber<Number>(factor[0] * norm_A_x);  // a2
  }
};

/// amplitude of exp(i*(2*omega0)*t) in x = 1/(3*omega0^2)*a2*A_x^2
struct harmonic_2_omega0_of_x : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    const Number omega0_2 = omega0 * omega0;
    return {1.0 / (3.0 * omega0_2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_x * A_x);  // a2
  }
};

/// amplitude of exp(i*(3*omega0)*t) in x = harmonic_re_x_A_x3*A_x^3
struct harmonic_3_omega0_of_x : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_x * A_x * A_x);  // harmonic_re_x_A_x3
  }
};

inline constexpr BlockFunctions blocks[4] = {modulation_functions<Model, modulation_of_x>(),
    harmonic_functions<Model, harmonic_0_of_x>(), harmonic_functions<Model, harmonic_2_omega0_of_x>(),
    harmonic_functions<Model, harmonic_3_omega0_of_x>()};

}  // namespace free
}  // namespace secular::generated::duffing
