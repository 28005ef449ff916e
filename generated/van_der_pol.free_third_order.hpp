// Model van_der_pol: generated code, never edited by hand.
// Holds rows of the case free_third_order. Made by: secular generate van_der_pol.
// no resonance, multiple scales to eps^3. Valid near that resonance for small amplitudes; what is left out is
// of order eps^4.
#pragma once

#include "van_der_pol.hpp"

namespace secular::generated::van_der_pol {

namespace free_third_order {

/// (rate - i*omega0)*A_x = 1/2*mu*A_x + i*conservative_x_A_x*A_x - 4*i*conservative_x_A_x*A_x^2*conj(A_x) +
/// 7/2*i*conservative_x_A_x*A_x^3*conj(A_x)^2 + dissipative_x_A_x2_conjA_x*A_x^2*conj(A_x) +
/// dissipative_x_A_x3_conjA_x2*A_x^3*conj(A_x)^2 - 37/70*dissipative_x_A_x3_conjA_x2*A_x^4*conj(A_x)^3
struct modulation_of_x : BlockShape<4, 5, 0> {
  template <class Number>
  static NumberList<Number, 5> factors(const Model::Frequencies<Number>&) {
    return {1.0 / 2.0, 1.0, -4.0, 7.0 / 2.0, -37.0 / 70.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, norm_A_x] = signals;
    column[0] = factor[0] * A_x;  // mu
    // conservative_x_A_x
    column[1] = times_i(factor[1] * A_x) + times_i(factor[2] * (norm_A_x * A_x))
        + times_i(factor[3] * (norm_A_x * norm_A_x * A_x));
    column[2] = factor[1] * (norm_A_x * A_x);  // dissipative_x_A_x2_conjA_x
    // dissipative_x_A_x3_conjA_x2
    column[3] = factor[1] * (norm_A_x * norm_A_x * A_x) + factor[4] * (norm_A_x * norm_A_x * norm_A_x * A_x);
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_x, norm_A_x] = signals;
    by[0] = ComplexNumber<double>(lump[0] * factor[0] + 2.0 * lump[2] * factor[1] * norm_A_x
        + 3.0 * lump[3] * factor[1] * (norm_A_x * norm_A_x)
        + 4.0 * lump[3] * factor[4] * (norm_A_x * norm_A_x * norm_A_x), lump[1] * factor[1]
        + 2.0 * lump[1] * factor[2] * norm_A_x + 3.0 * lump[1] * factor[3] * (norm_A_x * norm_A_x));
    by_conjugate[0] = lump[2] * factor[1] * (A_x * A_x) + 2.0 * lump[3] * factor[1] * (norm_A_x * A_x * A_x)
        + 3.0 * lump[3] * factor[4] * (norm_A_x * norm_A_x * A_x * A_x)
        + times_i(lump[1] * factor[2] * (A_x * A_x) + 2.0 * lump[1] * factor[3] * (norm_A_x * A_x * A_x));
  }
};

/// amplitude of exp(i*(3*omega0)*t) in x = 1/(8*omega0)*i*mu*A_x^3 + 1/(4*omega0)*conservative_x_A_x*A_x^3 +
/// 1/(8*omega0)*conservative_x_A_x*A_x^4*conj(A_x) + 1/(70*omega0)*i*dissipative_x_A_x3_conjA_x2*A_x^3 -
/// 3/(20*omega0)*i*dissipative_x_A_x3_conjA_x2*A_x^4*conj(A_x) +
/// 29/(280*omega0)*i*dissipative_x_A_x3_conjA_x2*A_x^5*conj(A_x)^2
struct harmonic_3_omega0_of_x : BlockShape<3, 5, follows_modes> {
  template <class Number>
  static NumberList<Number, 5> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0] = frequencies;
    return {1.0 / (8.0 * omega0), 1.0 / (4.0 * omega0), 1.0 / (70.0 * omega0), -3.0 / (20.0 * omega0),
        29.0 / (280.0 * omega0)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, norm_A_x] = signals;
    column[0] = times_i(factor[0] * (A_x * A_x * A_x));  // mu
    column[1] = factor[1] * (A_x * A_x * A_x) + factor[0] * (norm_A_x * A_x * A_x * A_x);  // conservative_x_A_x
    // dissipative_x_A_x3_conjA_x2
    column[2] = times_i(factor[2] * (A_x * A_x * A_x)) + times_i(factor[3] * (norm_A_x * A_x * A_x * A_x))
        + times_i(factor[4] * (norm_A_x * norm_A_x * A_x * A_x * A_x));
  }
};

/// amplitude of exp(i*(5*omega0)*t) in x = 5/(24*omega0)*conservative_x_A_x*A_x^5 -
/// 1/(36*omega0)*i*dissipative_x_A_x3_conjA_x2*A_x^5 -
/// 1/(168*omega0)*i*dissipative_x_A_x3_conjA_x2*A_x^6*conj(A_x)
struct harmonic_5_omega0_of_x : BlockShape<2, 3, follows_modes> {
  template <class Number>
  static NumberList<Number, 3> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0] = frequencies;
    return {5.0 / (24.0 * omega0), -1.0 / (36.0 * omega0), -1.0 / (168.0 * omega0)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, norm_A_x] = signals;
    column[0] = factor[0] * fixed_power<5>(A_x);  // conservative_x_A_x
    // dissipative_x_A_x3_conjA_x2
    column[1] = times_i(factor[1] * fixed_power<5>(A_x)) + times_i(factor[2] * (norm_A_x * fixed_power<5>(A_x)));
  }
};

/// amplitude of exp(i*(7*omega0)*t) in x = -1/(90*omega0)*i*dissipative_x_A_x3_conjA_x2*A_x^7
struct harmonic_7_omega0_of_x : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0] = frequencies;
    return {-1.0 / (90.0 * omega0)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, norm_A_x] = signals;
    column[0] = times_i(factor[0] * fixed_power<7>(A_x));  // dissipative_x_A_x3_conjA_x2
  }
};

inline constexpr BlockFunctions blocks[4] = {modulation_functions<Model, modulation_of_x>(),
    harmonic_functions<Model, harmonic_3_omega0_of_x>(), harmonic_functions<Model, harmonic_5_omega0_of_x>(),
    harmonic_functions<Model, harmonic_7_omega0_of_x>()};

}  // namespace free_third_order
}  // namespace secular::generated::van_der_pol
