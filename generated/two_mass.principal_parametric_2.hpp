// Model two_mass: generated code, never edited by hand.
// Holds rows of the case principal_parametric_2. Made by: secular generate two_mass.
// Omega = 2*omega2 + eps^2*sigma, multiple scales to eps^2. Valid near that resonance for small amplitudes;
// what is left out is of order eps^3.
#pragma once

#include "two_mass.primary_2.hpp"
#include "two_mass.principal_parametric_1.hpp"
#include "two_mass.hpp"

namespace secular::generated::two_mass {

namespace principal_parametric_2 {

/// (rate - i*omega1)*A_v1 = -mu11*A_v1 + i*conservative_v1_A_v1*A_v1 +
/// i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) - 3*omega1^2/2*mu13*A_v1^2*conj(A_v1) +
/// i*conservative_v1_A_v12_conjA_v1*A_v1^2*conj(A_v1)
struct modulation_of_v1 : BlockShape<5, 3, follows_modes> {
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
    column[2] = times_i(factor[1] * (A_v1 * norm_A_v2));  // conservative_v1_A_v1_A_v2_conjA_v2
    column[3] = factor[2] * (norm_A_v1 * A_v1);  // mu13
    column[4] = times_i(factor[1] * (norm_A_v1 * A_v1));  // conservative_v1_A_v12_conjA_v1
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    by[0] = ComplexNumber<double>(lump[0] * factor[0] + 2.0 * lump[3] * factor[2] * norm_A_v1, lump[1] * factor[1]
        + lump[2] * factor[1] * norm_A_v2 + 2.0 * lump[4] * factor[1] * norm_A_v1);
    by_conjugate[0] = lump[3] * factor[2] * (A_v1 * A_v1) + times_i(lump[4] * factor[1] * (A_v1 * A_v1));
    by[1] = times_i(lump[2] * factor[1] * (A_v1 * conj_A_v2));
    by_conjugate[1] = times_i(lump[2] * factor[1] * (A_v1 * A_v2));
  }
};

/// (rate - i*omega2)*A_v2 = -omega2/omega1*i*conservative_v1_A_v1*A_v2 +
/// omega1/omega2*i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*conj(A_v1)*A_v2 - mu22*A_v2 -
/// 3*omega2^2/2*mu23*A_v2^2*conj(A_v2) + i*conservative_v2_A_v22_conjA_v2*A_v2^2*conj(A_v2) +
/// i*conservative_v2_conjA_v2_F*conj(A_v2)*F
struct modulation_of_v2 : BlockShape<6, 5, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 5> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega2_2 = omega2 * omega2;
    return {-omega2 / omega1, omega1 / omega2, -1.0, -3.0 * omega2_2 / 2.0, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = times_i(factor[0] * A_v2);  // conservative_v1_A_v1
    column[1] = times_i(factor[1] * (norm_A_v1 * A_v2));  // conservative_v1_A_v1_A_v2_conjA_v2
    column[2] = factor[2] * A_v2;  // mu22
    column[3] = factor[3] * (norm_A_v2 * A_v2);  // mu23
    column[4] = times_i(factor[4] * (norm_A_v2 * A_v2));  // conservative_v2_A_v22_conjA_v2
    column[5] = times_i(factor[4] * (conj_A_v2 * F));  // conservative_v2_conjA_v2_F
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    by[0] = times_i(lump[1] * factor[1] * (conj_A_v1 * A_v2));
    by_conjugate[0] = times_i(lump[1] * factor[1] * (A_v1 * A_v2));
    by[1] = ComplexNumber<double>(lump[2] * factor[2] + 2.0 * lump[3] * factor[3] * norm_A_v2, lump[0] * factor[0]
        + lump[1] * factor[1] * norm_A_v1 + 2.0 * lump[4] * factor[4] * norm_A_v2);
    by_conjugate[1] = lump[3] * factor[3] * (A_v2 * A_v2) + times_i(lump[4] * factor[4] * (A_v2 * A_v2)
        + lump[5] * factor[4] * F);
  }
};

/// amplitude of exp(i*(Omega)*t) in v1 = 1/(2*(omega1 + 2*omega2)*(omega1 - 2*omega2))*eta11*F +
/// harmonic_re_v1_A_v22*A_v2^2 + i*harmonic_im_v1_F*F + i*harmonic_im_v1_A_v22*A_v2^2
struct harmonic_Omega_of_v1 : BlockShape<4, 2, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 + 2.0 * omega2);
    const Number per_1 = 1.0 / (omega1 - 2.0 * omega2);
    const Number over_0 = per_0 * per_1;
    return {over_0 / 2.0, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * F;  // eta11
    column[1] = factor[1] * (A_v2 * A_v2);  // harmonic_re_v1_A_v22
    column[2] = times_i(factor[1] * F);  // harmonic_im_v1_F
    column[3] = times_i(factor[1] * (A_v2 * A_v2));  // harmonic_im_v1_A_v22
  }
};

/// amplitude of exp(i*(omega2)*t) in v1 = -omega2/((omega1 + omega2)*(omega1 - omega2))*i*mu12*A_v2 +
/// harmonic_re_v1_conjA_v2_F*conj(A_v2)*F + harmonic_re_v1_A_v22_conjA_v2*A_v2^2*conj(A_v2) +
/// harmonic_re_v1_A_v1_A_v2_conjA_v1*A_v1*conj(A_v1)*A_v2
struct harmonic_omega2_of_v1 : BlockShape<4, 2, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 + omega2);
    const Number per_1 = 1.0 / (omega1 - omega2);
    const Number over_0 = per_0 * per_1;
    return {-omega2 * over_0, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = times_i(factor[0] * A_v2);  // mu12
    column[1] = factor[1] * (conj_A_v2 * F);  // harmonic_re_v1_conjA_v2_F
    column[2] = factor[1] * (norm_A_v2 * A_v2);  // harmonic_re_v1_A_v22_conjA_v2
    column[3] = factor[1] * (norm_A_v1 * A_v2);  // harmonic_re_v1_A_v1_A_v2_conjA_v1
  }
};

/// amplitude of exp(i*(-2*omega1 + omega2)*t) in v1 = harmonic_re_v1_A_v2_conjA_v12*conj(A_v1)^2*A_v2
struct harmonic_minus_2_omega1_plus_omega2_of_v1 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (conj_A_v1 * conj_A_v1 * A_v2);  // harmonic_re_v1_A_v2_conjA_v12
  }
};

/// amplitude of exp(i*(-omega1 + Omega)*t) in v1 = harmonic_re_v1_conjA_v1_F*conj(A_v1)*F +
/// harmonic_re_v1_A_v22_conjA_v1*conj(A_v1)*A_v2^2
struct harmonic_minus_omega1_plus_Omega_of_v1 : BlockShape<2, 1, is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (conj_A_v1 * F);  // harmonic_re_v1_conjA_v1_F
    column[1] = factor[0] * (conj_A_v1 * A_v2 * A_v2);  // harmonic_re_v1_A_v22_conjA_v1
  }
};

/// amplitude of exp(i*(omega2 + Omega)*t) in v1 = harmonic_re_v1_A_v2_F*A_v2*F + harmonic_re_v1_A_v23*A_v2^3
struct harmonic_omega2_plus_Omega_of_v1 : BlockShape<2, 1, is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_v2 * F);  // harmonic_re_v1_A_v2_F
    column[1] = factor[0] * (A_v2 * A_v2 * A_v2);  // harmonic_re_v1_A_v23
  }
};

/// amplitude of exp(i*(omega1 + Omega)*t) in v1 = harmonic_re_v1_A_v1_F*A_v1*F +
/// harmonic_re_v1_A_v1_A_v22*A_v1*A_v2^2
struct harmonic_omega1_plus_Omega_of_v1 : BlockShape<2, 1, is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_v1 * F);  // harmonic_re_v1_A_v1_F
    column[1] = factor[0] * (A_v1 * A_v2 * A_v2);  // harmonic_re_v1_A_v1_A_v22
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
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_v1 * A_v1 * A_v2);  // harmonic_re_v1_A_v12_A_v2
  }
};

/// amplitude of exp(i*(Omega)*t) in v2 = -1/(6*omega2^2)*eta21*F + harmonic_re_v2_A_v22*A_v2^2 +
/// i*harmonic_im_v2_F*F + i*harmonic_im_v2_A_v22*A_v2^2
struct harmonic_Omega_of_v2 : BlockShape<4, 2, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega2_2 = omega2 * omega2;
    return {-1.0 / (6.0 * omega2_2), 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * F;  // eta21
    column[1] = factor[1] * (A_v2 * A_v2);  // harmonic_re_v2_A_v22
    column[2] = times_i(factor[1] * F);  // harmonic_im_v2_F
    column[3] = times_i(factor[1] * (A_v2 * A_v2));  // harmonic_im_v2_A_v22
  }
};

/// amplitude of exp(i*(omega1)*t) in v2 = omega1/((omega1 + omega2)*(omega1 - omega2))*i*mu21*A_v1 +
/// harmonic_re_v2_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) + harmonic_re_v2_A_v12_conjA_v1*A_v1^2*conj(A_v1)
struct harmonic_omega1_of_v2 : BlockShape<3, 2, follows_modes> {
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
    column[1] = factor[1] * (A_v1 * norm_A_v2);  // harmonic_re_v2_A_v1_A_v2_conjA_v2
    column[2] = factor[1] * (norm_A_v1 * A_v1);  // harmonic_re_v2_A_v12_conjA_v1
  }
};

/// amplitude of exp(i*(-2*omega1 + omega2)*t) in v2 = harmonic_re_v2_A_v2_conjA_v12*conj(A_v1)^2*A_v2
struct harmonic_minus_2_omega1_plus_omega2_of_v2 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (conj_A_v1 * conj_A_v1 * A_v2);  // harmonic_re_v2_A_v2_conjA_v12
  }
};

/// amplitude of exp(i*(-omega1 + Omega)*t) in v2 = harmonic_re_v2_conjA_v1_F*conj(A_v1)*F +
/// harmonic_re_v2_A_v22_conjA_v1*conj(A_v1)*A_v2^2
struct harmonic_minus_omega1_plus_Omega_of_v2 : BlockShape<2, 1, is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (conj_A_v1 * F);  // harmonic_re_v2_conjA_v1_F
    column[1] = factor[0] * (conj_A_v1 * A_v2 * A_v2);  // harmonic_re_v2_A_v22_conjA_v1
  }
};

/// amplitude of exp(i*(omega2 + Omega)*t) in v2 = -omega2/8*i*mu23*A_v2^3 + harmonic_re_v2_A_v2_F*A_v2*F +
/// harmonic_re_v2_A_v23*A_v2^3
struct harmonic_omega2_plus_Omega_of_v2 : BlockShape<3, 2, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    return {-omega2 / 8.0, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = times_i(factor[0] * (A_v2 * A_v2 * A_v2));  // mu23
    column[1] = factor[1] * (A_v2 * F);  // harmonic_re_v2_A_v2_F
    column[2] = factor[1] * (A_v2 * A_v2 * A_v2);  // harmonic_re_v2_A_v23
  }
};

/// amplitude of exp(i*(omega1 + Omega)*t) in v2 = harmonic_re_v2_A_v1_F*A_v1*F +
/// harmonic_re_v2_A_v1_A_v22*A_v1*A_v2^2
struct harmonic_omega1_plus_Omega_of_v2 : BlockShape<2, 1, is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_v1 * F);  // harmonic_re_v2_A_v1_F
    column[1] = factor[0] * (A_v1 * A_v2 * A_v2);  // harmonic_re_v2_A_v1_A_v22
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
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_v1 * A_v1 * A_v2);  // harmonic_re_v2_A_v12_A_v2
  }
};

inline constexpr BlockFunctions blocks[26] = {modulation_functions<Model, modulation_of_v1>(),
    modulation_functions<Model, modulation_of_v2>(),
    harmonic_functions<Model, principal_parametric_1::harmonic_minus_omega1_plus_omega2_of_v1>(),
    harmonic_functions<Model, principal_parametric_1::harmonic_0_of_v1>(),
    harmonic_functions<Model, harmonic_Omega_of_v1>(), harmonic_functions<Model, harmonic_omega2_of_v1>(),
    harmonic_functions<Model, principal_parametric_1::harmonic_omega1_plus_omega2_of_v1>(),
    harmonic_functions<Model, primary_2::harmonic_2_omega1_of_v1>(),
    harmonic_functions<Model, harmonic_minus_2_omega1_plus_omega2_of_v1>(),
    harmonic_functions<Model, harmonic_minus_omega1_plus_Omega_of_v1>(),
    harmonic_functions<Model, harmonic_omega2_plus_Omega_of_v1>(),
    harmonic_functions<Model, harmonic_omega1_plus_Omega_of_v1>(),
    harmonic_functions<Model, harmonic_2_omega1_plus_omega2_of_v1>(),
    harmonic_functions<Model, primary_2::harmonic_3_omega1_of_v1>(),
    harmonic_functions<Model, principal_parametric_1::harmonic_minus_omega1_plus_omega2_of_v2>(),
    harmonic_functions<Model, principal_parametric_1::harmonic_0_of_v2>(),
    harmonic_functions<Model, harmonic_Omega_of_v2>(), harmonic_functions<Model, harmonic_omega1_of_v2>(),
    harmonic_functions<Model, principal_parametric_1::harmonic_omega1_plus_omega2_of_v2>(),
    harmonic_functions<Model, primary_2::harmonic_2_omega1_of_v2>(),
    harmonic_functions<Model, harmonic_minus_2_omega1_plus_omega2_of_v2>(),
    harmonic_functions<Model, harmonic_minus_omega1_plus_Omega_of_v2>(),
    harmonic_functions<Model, harmonic_omega2_plus_Omega_of_v2>(),
    harmonic_functions<Model, harmonic_omega1_plus_Omega_of_v2>(),
    harmonic_functions<Model, harmonic_2_omega1_plus_omega2_of_v2>(),
    harmonic_functions<Model, primary_2::harmonic_3_omega1_of_v2>()};

}  // namespace principal_parametric_2
}  // namespace secular::generated::two_mass
