// Model two_mass: generated code, never edited by hand.
// Holds rows of the case free_1. Made by: secular generate two_mass.
// free vibration, multiple scales to eps^2. Valid near that resonance for small amplitudes; what is left out is
// of order eps^3.
#pragma once

#include "two_mass.primary_2.hpp"
#include "two_mass.hpp"

namespace secular::generated::two_mass {

namespace free_1 {

/// (rate - i*omega1)*A_v1 = -mu11*A_v1 + i*conservative_v1_A_v1*A_v1 - 3*omega1^2/2*mu13*A_v1^2*conj(A_v1) +
/// i*conservative_v1_A_v12_conjA_v1*A_v1^2*conj(A_v1)
struct modulation_of_v1 : BlockShape<4, 3, follows_modes> {
  template <class Number>
  static NumberList<Number, 3> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    return {-1.0, 1.0, -3.0 * omega1_2 / 2.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * A_v1;  // mu11
    column[1] = times_i(factor[1] * A_v1);  // conservative_v1_A_v1
    column[2] = factor[2] * (norm_A_v1 * A_v1);  // mu13
    column[3] = times_i(factor[1] * (norm_A_v1 * A_v1));  // conservative_v1_A_v12_conjA_v1
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    by[0] = ComplexNumber<double>(lump[0] * factor[0] + 2.0 * lump[2] * factor[2] * norm_A_v1, lump[1] * factor[1]
        + 2.0 * lump[3] * factor[1] * norm_A_v1);
    by_conjugate[0] = lump[2] * factor[2] * (A_v1 * A_v1) + times_i(lump[3] * factor[1] * (A_v1 * A_v1));
  }
};

/// amplitude of exp(i*(0)*t) in v1 = harmonic_re_v1_A_v1_conjA_v1*A_v1*conj(A_v1)
struct harmonic_0_of_v1 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = ComplexNumber<Number>(factor[0] * norm_A_v1);  // harmonic_re_v1_A_v1_conjA_v1
  }
};

/// amplitude of exp(i*(0)*t) in v2 = harmonic_re_v2_A_v1_conjA_v1*A_v1*conj(A_v1)
struct harmonic_0_of_v2 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = ComplexNumber<Number>(factor[0] * norm_A_v1);  // harmonic_re_v2_A_v1_conjA_v1
  }
};

/// amplitude of exp(i*(omega1)*t) in v2 = omega1/((omega1 + omega2)*(omega1 - omega2))*i*mu21*A_v1 +
/// harmonic_re_v2_A_v12_conjA_v1*A_v1^2*conj(A_v1)
struct harmonic_omega1_of_v2 : BlockShape<2, 2, follows_modes> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 + omega2);
    const Number per_1 = 1.0 / (omega1 - omega2);
    const Number over_0 = per_0 * per_1;
    return {omega1 * over_0, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = times_i(factor[0] * A_v1);  // mu21
    column[1] = factor[1] * (norm_A_v1 * A_v1);  // harmonic_re_v2_A_v12_conjA_v1
  }
};

inline constexpr BlockFunctions blocks[8] = {modulation_functions<Model, modulation_of_v1>(),
    harmonic_functions<Model, harmonic_0_of_v1>(),
    harmonic_functions<Model, primary_2::harmonic_2_omega1_of_v1>(),
    harmonic_functions<Model, primary_2::harmonic_3_omega1_of_v1>(),
    harmonic_functions<Model, harmonic_0_of_v2>(), harmonic_functions<Model, harmonic_omega1_of_v2>(),
    harmonic_functions<Model, primary_2::harmonic_2_omega1_of_v2>(),
    harmonic_functions<Model, primary_2::harmonic_3_omega1_of_v2>()};

}  // namespace free_1
}  // namespace secular::generated::two_mass
