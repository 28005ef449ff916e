// Model van_der_pol: generated code, never edited by hand.
// Holds rows of the case free. Made by: secular generate van_der_pol.
// no resonance, multiple scales to eps^2. Valid near that resonance for small amplitudes; what is left out is
// of order eps^3.
#pragma once

#include "van_der_pol.hpp"

namespace secular::generated::van_der_pol {

namespace free {

/// (rate - i*omega0)*A_x = 1/2*mu*A_x - 1/2*mu*A_x^2*conj(A_x) + i*conservative_x_A_x*A_x -
/// 4*i*conservative_x_A_x*A_x^2*conj(A_x) + 7/2*i*conservative_x_A_x*A_x^3*conj(A_x)^2
struct modulation_of_x : BlockShape<2, 5, 0> {
  template <class Number>
  static NumberList<Number, 5> factors(const Model::Frequencies<Number>&) {
    return {1.0 / 2.0, -1.0 / 2.0, 1.0, -4.0, 7.0 / 2.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, norm_A_x] = signals;
    column[0] = factor[0] * A_x + factor[1] * (norm_A_x * A_x);  // mu
    // conservative_x_A_x
    column[1] = times_i(factor[2] * A_x) + times_i(factor[3] * (norm_A_x * A_x))
        + times_i(factor[4] * (norm_A_x * norm_A_x * A_x));
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_x, norm_A_x] = signals;
    by[0] = ComplexNumber<double>(lump[0] * factor[0] + 2.0 * lump[0] * factor[1] * norm_A_x, lump[1] * factor[2]
        + 2.0 * lump[1] * factor[3] * norm_A_x + 3.0 * lump[1] * factor[4] * (norm_A_x * norm_A_x));
    by_conjugate[0] = lump[0] * factor[1] * (A_x * A_x) + times_i(lump[1] * factor[3] * (A_x * A_x)
        + 2.0 * lump[1] * factor[4] * (norm_A_x * A_x * A_x));
  }
};

/// amplitude of exp(i*(3*omega0)*t) in x = 1/(8*omega0)*i*mu*A_x^3 + 1/(4*omega0)*conservative_x_A_x*A_x^3 +
/// 1/(8*omega0)*conservative_x_A_x*A_x^4*conj(A_x)
struct harmonic_3_omega0_of_x : BlockShape<2, 2, follows_modes> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0] = frequencies;
    return {1.0 / (8.0 * omega0), 1.0 / (4.0 * omega0)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, norm_A_x] = signals;
    column[0] = times_i(factor[0] * (A_x * A_x * A_x));  // mu
    column[1] = factor[1] * (A_x * A_x * A_x) + factor[0] * (norm_A_x * A_x * A_x * A_x);  // conservative_x_A_x
  }
};

/// amplitude of exp(i*(5*omega0)*t) in x = 5/(24*omega0)*conservative_x_A_x*A_x^5
struct harmonic_5_omega0_of_x : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0] = frequencies;
    return {5.0 / (24.0 * omega0)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, norm_A_x] = signals;
    column[0] = factor[0] * fixed_power<5>(A_x);  // conservative_x_A_x
  }
};

inline constexpr BlockFunctions blocks[3] = {modulation_functions<Model, modulation_of_x>(),
    harmonic_functions<Model, harmonic_3_omega0_of_x>(), harmonic_functions<Model, harmonic_5_omega0_of_x>()};

}  // namespace free
}  // namespace secular::generated::van_der_pol
