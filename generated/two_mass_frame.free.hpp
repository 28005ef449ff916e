// Model two_mass_frame: generated code, never edited by hand.
// Holds rows of the case free. Made by: secular generate two_mass_frame.
// free vibration, multiple scales to eps^2. Valid near that resonance for small amplitudes; what is left out is
// of order eps^3.
#pragma once

#include "two_mass_frame.principal_parametric_1.hpp"
#include "two_mass_frame.additive_combination.hpp"
#include "two_mass_frame.hpp"

namespace secular::generated::two_mass_frame {

namespace free {

/// (rate - i*omega1)*A_v1 = -mu1*A_v1 + i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) +
/// i*conservative_v1_A_v12_conjA_v1*A_v1^2*conj(A_v1)
struct modulation_of_v1 : BlockShape<3, 2, 0> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>&) {
    return {-1.0, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F] = signals;
    column[0] = factor[0] * A_v1;  // mu1
    column[1] = times_i(factor[1] * (A_v1 * norm_A_v2));  // conservative_v1_A_v1_A_v2_conjA_v2
    column[2] = times_i(factor[1] * (norm_A_v1 * A_v1));  // conservative_v1_A_v12_conjA_v1
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F] = signals;
    by[0] = ComplexNumber<double>(lump[0] * factor[0], lump[1] * factor[1] * norm_A_v2
        + 2.0 * lump[2] * factor[1] * norm_A_v1);
    by_conjugate[0] = times_i(lump[2] * factor[1] * (A_v1 * A_v1));
    by[1] = times_i(lump[1] * factor[1] * (A_v1 * conj_A_v2));
    by_conjugate[1] = times_i(lump[1] * factor[1] * (A_v1 * A_v2));
  }
};

/// amplitude of exp(i*(2*omega1 + omega2)*t) in v1 = harmonic_re_v1_A_v12_A_v2*A_v1^2*A_v2
struct harmonic_2_omega1_plus_omega2_of_v1 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F] = signals;
    column[0] = factor[0] * (A_v1 * A_v1 * A_v2);  // harmonic_re_v1_A_v12_A_v2
  }
};

/// amplitude of exp(i*(omega1)*t) in v2 = harmonic_re_v2_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) +
/// harmonic_re_v2_A_v12_conjA_v1*A_v1^2*conj(A_v1)
struct harmonic_omega1_of_v2 : BlockShape<2, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F] = signals;
    column[0] = factor[0] * (A_v1 * norm_A_v2);  // harmonic_re_v2_A_v1_A_v2_conjA_v2
    column[1] = factor[0] * (norm_A_v1 * A_v1);  // harmonic_re_v2_A_v12_conjA_v1
  }
};

/// amplitude of exp(i*(2*omega1 + omega2)*t) in v2 = harmonic_re_v2_A_v12_A_v2*A_v1^2*A_v2
struct harmonic_2_omega1_plus_omega2_of_v2 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F] = signals;
    column[0] = factor[0] * (A_v1 * A_v1 * A_v2);  // harmonic_re_v2_A_v12_A_v2
  }
};

inline constexpr BlockFunctions blocks[16] = {modulation_functions<Model, modulation_of_v1>(),
    modulation_functions<Model, principal_parametric_1::modulation_of_v2>(),
    harmonic_functions<Model, additive_combination::harmonic_minus_2_omega1_plus_omega2_of_v1>(),
    harmonic_functions<Model, principal_parametric_1::harmonic_minus_omega1_plus_2_omega2_of_v1>(),
    harmonic_functions<Model, principal_parametric_1::harmonic_omega2_of_v1>(),
    harmonic_functions<Model, principal_parametric_1::harmonic_3_omega2_of_v1>(),
    harmonic_functions<Model, principal_parametric_1::harmonic_omega1_plus_2_omega2_of_v1>(),
    harmonic_functions<Model, harmonic_2_omega1_plus_omega2_of_v1>(),
    harmonic_functions<Model, additive_combination::harmonic_3_omega1_of_v1>(),
    harmonic_functions<Model, additive_combination::harmonic_minus_2_omega1_plus_omega2_of_v2>(),
    harmonic_functions<Model, principal_parametric_1::harmonic_minus_omega1_plus_2_omega2_of_v2>(),
    harmonic_functions<Model, principal_parametric_1::harmonic_3_omega2_of_v2>(),
    harmonic_functions<Model, harmonic_omega1_of_v2>(),
    harmonic_functions<Model, principal_parametric_1::harmonic_omega1_plus_2_omega2_of_v2>(),
    harmonic_functions<Model, harmonic_2_omega1_plus_omega2_of_v2>(),
    harmonic_functions<Model, additive_combination::harmonic_3_omega1_of_v2>()};

}  // namespace free
}  // namespace secular::generated::two_mass_frame
