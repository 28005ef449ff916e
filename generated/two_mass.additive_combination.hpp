// Model two_mass: generated code, never edited by hand.
// Holds rows of the case additive_combination. Made by: secular generate two_mass.
// Omega = omega1 + omega2 + eps^2*sigma, multiple scales to eps^2. Valid near that resonance for small
// amplitudes; what is left out is of order eps^3.
#pragma once

#include "two_mass.primary_1.hpp"
#include "two_mass.primary_2.hpp"
#include "two_mass.principal_parametric_1.hpp"
#include "two_mass.principal_parametric_2.hpp"
#include "two_mass.hpp"

namespace secular::generated::two_mass {

namespace additive_combination {

/// (rate - i*omega1)*A_v1 = -mu11*A_v1 + i*conservative_v1_A_v1*A_v1 + i*conservative_v1_A_v1_F2*A_v1*F^2 +
/// i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) - 3*omega1^2/2*mu13*A_v1^2*conj(A_v1) +
/// i*conservative_v1_A_v12_conjA_v1*A_v1^2*conj(A_v1) + dissipative_v1_conjA_v2_F*conj(A_v2)*F +
/// i*conservative_v1_conjA_v2_F*conj(A_v2)*F
struct modulation_of_v1 : BlockShape<8, 3, follows_modes | is_forced> {
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
    column[2] = times_i(factor[1] * (A_v1 * norm_F));  // conservative_v1_A_v1_F2
    column[3] = times_i(factor[1] * (A_v1 * norm_A_v2));  // conservative_v1_A_v1_A_v2_conjA_v2
    column[4] = factor[2] * (norm_A_v1 * A_v1);  // mu13
    column[5] = times_i(factor[1] * (norm_A_v1 * A_v1));  // conservative_v1_A_v12_conjA_v1
    column[6] = factor[1] * (conj_A_v2 * F);  // dissipative_v1_conjA_v2_F
    column[7] = times_i(factor[1] * (conj_A_v2 * F));  // conservative_v1_conjA_v2_F
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    by[0] = ComplexNumber<double>(lump[0] * factor[0] + 2.0 * lump[4] * factor[2] * norm_A_v1, lump[1] * factor[1]
        + lump[2] * factor[1] * norm_F + lump[3] * factor[1] * norm_A_v2 + 2.0 * lump[5] * factor[1] * norm_A_v1);
    by_conjugate[0] = lump[4] * factor[2] * (A_v1 * A_v1) + times_i(lump[5] * factor[1] * (A_v1 * A_v1));
    by[1] = times_i(lump[3] * factor[1] * (A_v1 * conj_A_v2));
    by_conjugate[1] = lump[6] * factor[1] * F + times_i(lump[3] * factor[1] * (A_v1 * A_v2)
        + lump[7] * factor[1] * F);
  }
};

/// (rate - i*omega2)*A_v2 = -omega2/omega1*i*conservative_v1_A_v1*A_v2 +
/// omega1/omega2*i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*conj(A_v1)*A_v2 +
/// omega1/omega2*i*conservative_v1_conjA_v2_F*conj(A_v1)*F - mu22*A_v2 + i*conservative_v2_A_v2_F2*A_v2*F^2 -
/// 3*omega2^2/2*mu23*A_v2^2*conj(A_v2) + i*conservative_v2_A_v22_conjA_v2*A_v2^2*conj(A_v2) +
/// dissipative_v2_conjA_v1_F*conj(A_v1)*F
struct modulation_of_v2 : BlockShape<8, 5, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 5> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega2_2 = omega2 * omega2;
    return {-omega2 / omega1, omega1 / omega2, -1.0, 1.0, -3.0 * omega2_2 / 2.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = times_i(factor[0] * A_v2);  // conservative_v1_A_v1
    column[1] = times_i(factor[1] * (norm_A_v1 * A_v2));  // conservative_v1_A_v1_A_v2_conjA_v2
    column[2] = times_i(factor[1] * (conj_A_v1 * F));  // conservative_v1_conjA_v2_F
    column[3] = factor[2] * A_v2;  // mu22
    column[4] = times_i(factor[3] * (A_v2 * norm_F));  // conservative_v2_A_v2_F2
    column[5] = factor[4] * (norm_A_v2 * A_v2);  // mu23
    column[6] = times_i(factor[3] * (norm_A_v2 * A_v2));  // conservative_v2_A_v22_conjA_v2
    column[7] = factor[3] * (conj_A_v1 * F);  // dissipative_v2_conjA_v1_F
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    by[0] = times_i(lump[1] * factor[1] * (conj_A_v1 * A_v2));
    by_conjugate[0] = lump[7] * factor[3] * F + times_i(lump[1] * factor[1] * (A_v1 * A_v2)
        + lump[2] * factor[1] * F);
    by[1] = ComplexNumber<double>(lump[3] * factor[2] + 2.0 * lump[5] * factor[4] * norm_A_v2, lump[0] * factor[0]
        + lump[1] * factor[1] * norm_A_v1 + lump[4] * factor[3] * norm_F + 2.0 * lump[6] * factor[3] * norm_A_v2);
    by_conjugate[1] = lump[5] * factor[4] * (A_v2 * A_v2) + times_i(lump[6] * factor[3] * (A_v2 * A_v2));
  }
};

/// amplitude of exp(i*(omega2)*t) in v1 = 1/(2*(omega1 + omega2)*(omega1 - omega2))*eta12*conj(A_v1)*F -
/// omega2/((omega1 + omega2)*(omega1 - omega2))*i*mu12*A_v2 + harmonic_re_v1_conjA_v1_F*conj(A_v1)*F +
/// harmonic_re_v1_A_v22_conjA_v2*A_v2^2*conj(A_v2) + harmonic_re_v1_A_v1_A_v2_conjA_v1*A_v1*conj(A_v1)*A_v2
struct harmonic_omega2_of_v1 : BlockShape<5, 3, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 3> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 + omega2);
    const Number per_1 = 1.0 / (omega1 - omega2);
    const Number over_0 = per_0 * per_1;
    return {over_0 / 2.0, -omega2 * over_0, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (conj_A_v1 * F);  // eta12
    column[1] = times_i(factor[1] * A_v2);  // mu12
    column[2] = factor[2] * (conj_A_v1 * F);  // harmonic_re_v1_conjA_v1_F
    column[3] = factor[2] * (norm_A_v2 * A_v2);  // harmonic_re_v1_A_v22_conjA_v2
    column[4] = factor[2] * (norm_A_v1 * A_v2);  // harmonic_re_v1_A_v1_A_v2_conjA_v1
  }
};

/// amplitude of exp(i*(-omega1 + omega2)*t) in v1 = harmonic_re_v1_A_v2_conjA_v1*conj(A_v1)*A_v2 +
/// harmonic_re_v1_conjA_v12_F*conj(A_v1)^2*F + i*harmonic_im_v1_A_v2_conjA_v1*conj(A_v1)*A_v2 +
/// harmonic_re_v1_A_v22_F*A_v2^2*F
struct harmonic_minus_omega1_plus_omega2_of_v1 : BlockShape<4, 1, is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (conj_A_v1 * A_v2);  // harmonic_re_v1_A_v2_conjA_v1
    column[1] = factor[0] * (conj_A_v1 * conj_A_v1 * F);  // harmonic_re_v1_conjA_v12_F
    column[2] = times_i(factor[0] * (conj_A_v1 * A_v2));  // harmonic_im_v1_A_v2_conjA_v1
    column[3] = factor[0] * (A_v2 * A_v2 * conj_F);  // harmonic_re_v1_A_v22_F
  }
};

/// amplitude of exp(i*(0)*t) in v1 = harmonic_re_v1_A_v2_conjA_v2*A_v2*conj(A_v2) +
/// harmonic_re_v1_A_v1_conjA_v1*A_v1*conj(A_v1) + harmonic_re_v1_conjA_v1_conjA_v2_F*conj(A_v1)*conj(A_v2)*F +
/// harmonic_re_v1_conjA_v1_conjA_v2_F*A_v1*A_v2*F + harmonic_re_v1_F2*F^2
struct harmonic_0_of_v1 : BlockShape<4, 1, is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = ComplexNumber<Number>(factor[0] * norm_A_v2);  // harmonic_re_v1_A_v2_conjA_v2
    column[1] = ComplexNumber<Number>(factor[0] * norm_A_v1);  // harmonic_re_v1_A_v1_conjA_v1
    // harmonic_re_v1_conjA_v1_conjA_v2_F
    column[2] = factor[0] * (conj_A_v1 * conj_A_v2 * F) + factor[0] * (A_v1 * A_v2 * conj_F);
    column[3] = ComplexNumber<Number>(factor[0] * norm_F);  // harmonic_re_v1_F2
  }
};

/// amplitude of exp(i*(Omega)*t) in v1 = -1/(2*omega2*(2*omega1 + omega2))*eta11*F +
/// harmonic_re_v1_A_v1_A_v2*A_v1*A_v2 + i*harmonic_im_v1_F*F + harmonic_re_v1_A_v2_conjA_v2_F*A_v2*conj(A_v2)*F
/// + harmonic_re_v1_A_v1_conjA_v1_F*A_v1*conj(A_v1)*F + i*harmonic_im_v1_A_v1_A_v2*A_v1*A_v2
struct harmonic_Omega_of_v1 : BlockShape<6, 2, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number per_0 = 1.0 / (2.0 * omega1 + omega2);
    return {-per_0 / (2.0 * omega2), 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * F;  // eta11
    column[1] = factor[1] * (A_v1 * A_v2);  // harmonic_re_v1_A_v1_A_v2
    column[2] = times_i(factor[1] * F);  // harmonic_im_v1_F
    column[3] = factor[1] * (norm_A_v2 * F);  // harmonic_re_v1_A_v2_conjA_v2_F
    column[4] = factor[1] * (norm_A_v1 * F);  // harmonic_re_v1_A_v1_conjA_v1_F
    column[5] = times_i(factor[1] * (A_v1 * A_v2));  // harmonic_im_v1_A_v1_A_v2
  }
};

/// amplitude of exp(i*(2*omega2)*t) in v1 = harmonic_re_v1_A_v22*A_v2^2 +
/// harmonic_re_v1_A_v2_conjA_v1_F*conj(A_v1)*A_v2*F + i*harmonic_im_v1_A_v22*A_v2^2
struct harmonic_2_omega2_of_v1 : BlockShape<3, 1, is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_v2 * A_v2);  // harmonic_re_v1_A_v22
    column[1] = factor[0] * (conj_A_v1 * A_v2 * F);  // harmonic_re_v1_A_v2_conjA_v1_F
    column[2] = times_i(factor[0] * (A_v2 * A_v2));  // harmonic_im_v1_A_v22
  }
};

/// amplitude of exp(i*(omega1 + Omega)*t) in v1 = -1/(2*(omega1 + omega2)*(3*omega1 + omega2))*eta12*A_v1*F +
/// harmonic_re_v1_A_v1_F*A_v1*F + harmonic_re_v1_A_v12_A_v2*A_v1^2*A_v2
struct harmonic_omega1_plus_Omega_of_v1 : BlockShape<3, 2, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 + omega2);
    const Number per_1 = 1.0 / (3.0 * omega1 + omega2);
    const Number over_0 = per_0 * per_1;
    return {-over_0 / 2.0, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_v1 * F);  // eta12
    column[1] = factor[1] * (A_v1 * F);  // harmonic_re_v1_A_v1_F
    column[2] = factor[1] * (A_v1 * A_v1 * A_v2);  // harmonic_re_v1_A_v12_A_v2
  }
};

/// amplitude of exp(i*(2*omega1)*t) in v1 = harmonic_re_v1_A_v12*A_v1^2 +
/// harmonic_re_v1_A_v1_conjA_v2_F*A_v1*conj(A_v2)*F + i*harmonic_im_v1_A_v12*A_v1^2
struct harmonic_2_omega1_of_v1 : BlockShape<3, 1, is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_v1 * A_v1);  // harmonic_re_v1_A_v12
    column[1] = factor[0] * (A_v1 * conj_A_v2 * F);  // harmonic_re_v1_A_v1_conjA_v2_F
    column[2] = times_i(factor[0] * (A_v1 * A_v1));  // harmonic_im_v1_A_v12
  }
};

/// amplitude of exp(i*(omega2 + Omega)*t) in v1 = (3*omega1^2 + omega1*omega2)/(4*omega2*(omega1 +
/// omega2)^2)*conservative_v1_A_v1_F2*conj(A_v1)*F^2 + harmonic_re_v1_A_v2_F*A_v2*F +
/// i*harmonic_im_v1_A_v2_F*A_v2*F + harmonic_re_v1_A_v1_A_v22*A_v1*A_v2^2
struct harmonic_omega2_plus_Omega_of_v1 : BlockShape<4, 2, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number per_0 = 1.0 / (omega1 + omega2);
    const Number per_0_2 = per_0 * per_0;
    return {(3.0 * omega1_2 + omega1 * omega2) * per_0_2 / (4.0 * omega2), 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (conj_A_v1 * F * F);  // conservative_v1_A_v1_F2
    column[1] = factor[1] * (A_v2 * F);  // harmonic_re_v1_A_v2_F
    column[2] = times_i(factor[1] * (A_v2 * F));  // harmonic_im_v1_A_v2_F
    column[3] = factor[1] * (A_v1 * A_v2 * A_v2);  // harmonic_re_v1_A_v1_A_v22
  }
};

/// amplitude of exp(i*(2*Omega)*t) in v1 = -omega1^2/(2*(omega1 + 2*omega2)*(3*omega1 +
/// 2*omega2))*harmonic_re_v1_F2*F^2 + harmonic_re_v1_A_v1_A_v2_F*A_v1*A_v2*F
struct harmonic_2_Omega_of_v1 : BlockShape<2, 2, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number per_0 = 1.0 / (omega1 + 2.0 * omega2);
    const Number per_1 = 1.0 / (3.0 * omega1 + 2.0 * omega2);
    const Number over_0 = per_0 * per_1;
    return {-omega1_2 * over_0 / 2.0, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (F * F);  // harmonic_re_v1_F2
    column[1] = factor[1] * (A_v1 * A_v2 * F);  // harmonic_re_v1_A_v1_A_v2_F
  }
};

/// amplitude of exp(i*(2*omega2 + Omega)*t) in v1 = harmonic_re_v1_A_v22_F*A_v2^2*F
struct harmonic_2_omega2_plus_Omega_of_v1 : BlockShape<1, 1, is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_v2 * A_v2 * F);  // harmonic_re_v1_A_v22_F
  }
};

/// amplitude of exp(i*(omega1 + 2*Omega)*t) in v1 = (-3*omega1^3 + 2*omega1^2*omega2 +
/// omega1*omega2^2)/(4*Omega^2*(omega1 + Omega)*(2*omega1 + Omega))*conservative_v1_A_v1_F2*A_v1*F^2
struct harmonic_omega1_plus_2_Omega_of_v1 : BlockShape<1, 1, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number omega1_3 = omega1_2 * omega1;
    const Number omega2_2 = omega2 * omega2;
    const Number Omega_2 = Omega * Omega;
    const Number per_0 = 1.0 / (omega1 + Omega);
    const Number per_1 = 1.0 / (2.0 * omega1 + Omega);
    const Number over_0 = per_0 * per_1;
    return {(-3.0 * omega1_3 + 2.0 * omega1_2 * omega2 + omega1 * omega2_2) * over_0 / (4.0 * Omega_2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_v1 * F * F);  // conservative_v1_A_v1_F2
  }
};

/// amplitude of exp(i*(2*omega1 + Omega)*t) in v1 = harmonic_re_v1_A_v12_F*A_v1^2*F
struct harmonic_2_omega1_plus_Omega_of_v1 : BlockShape<1, 1, is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_v1 * A_v1 * F);  // harmonic_re_v1_A_v12_F
  }
};

/// amplitude of exp(i*(-omega1 + omega2)*t) in v2 = harmonic_re_v2_A_v2_conjA_v1*conj(A_v1)*A_v2 +
/// harmonic_re_v2_conjA_v12_F*conj(A_v1)^2*F + i*harmonic_im_v2_A_v2_conjA_v1*conj(A_v1)*A_v2 +
/// harmonic_re_v2_A_v22_F*A_v2^2*F
struct harmonic_minus_omega1_plus_omega2_of_v2 : BlockShape<4, 1, is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (conj_A_v1 * A_v2);  // harmonic_re_v2_A_v2_conjA_v1
    column[1] = factor[0] * (conj_A_v1 * conj_A_v1 * F);  // harmonic_re_v2_conjA_v12_F
    column[2] = times_i(factor[0] * (conj_A_v1 * A_v2));  // harmonic_im_v2_A_v2_conjA_v1
    column[3] = factor[0] * (A_v2 * A_v2 * conj_F);  // harmonic_re_v2_A_v22_F
  }
};

/// amplitude of exp(i*(omega1)*t) in v2 = -1/(2*(omega1 + omega2)*(omega1 - omega2))*eta22*conj(A_v2)*F +
/// omega1/((omega1 + omega2)*(omega1 - omega2))*i*mu21*A_v1 + harmonic_re_v2_conjA_v2_F*conj(A_v2)*F +
/// harmonic_re_v2_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) + harmonic_re_v2_A_v12_conjA_v1*A_v1^2*conj(A_v1)
struct harmonic_omega1_of_v2 : BlockShape<5, 3, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 3> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 + omega2);
    const Number per_1 = 1.0 / (omega1 - omega2);
    const Number over_0 = per_0 * per_1;
    return {-over_0 / 2.0, omega1 * over_0, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (conj_A_v2 * F);  // eta22
    column[1] = times_i(factor[1] * A_v1);  // mu21
    column[2] = factor[2] * (conj_A_v2 * F);  // harmonic_re_v2_conjA_v2_F
    column[3] = factor[2] * (A_v1 * norm_A_v2);  // harmonic_re_v2_A_v1_A_v2_conjA_v2
    column[4] = factor[2] * (norm_A_v1 * A_v1);  // harmonic_re_v2_A_v12_conjA_v1
  }
};

/// amplitude of exp(i*(0)*t) in v2 = harmonic_re_v2_A_v2_conjA_v2*A_v2*conj(A_v2) +
/// harmonic_re_v2_A_v1_conjA_v1*A_v1*conj(A_v1) + harmonic_re_v2_conjA_v1_conjA_v2_F*conj(A_v1)*conj(A_v2)*F +
/// harmonic_re_v2_conjA_v1_conjA_v2_F*A_v1*A_v2*F + harmonic_re_v2_F2*F^2
struct harmonic_0_of_v2 : BlockShape<4, 1, is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = ComplexNumber<Number>(factor[0] * norm_A_v2);  // harmonic_re_v2_A_v2_conjA_v2
    column[1] = ComplexNumber<Number>(factor[0] * norm_A_v1);  // harmonic_re_v2_A_v1_conjA_v1
    // harmonic_re_v2_conjA_v1_conjA_v2_F
    column[2] = factor[0] * (conj_A_v1 * conj_A_v2 * F) + factor[0] * (A_v1 * A_v2 * conj_F);
    column[3] = ComplexNumber<Number>(factor[0] * norm_F);  // harmonic_re_v2_F2
  }
};

/// amplitude of exp(i*(Omega)*t) in v2 = -1/(2*omega1*(omega1 + 2*omega2))*eta21*F +
/// harmonic_re_v2_A_v1_A_v2*A_v1*A_v2 + i*harmonic_im_v2_F*F + harmonic_re_v2_A_v2_conjA_v2_F*A_v2*conj(A_v2)*F
/// + harmonic_re_v2_A_v1_conjA_v1_F*A_v1*conj(A_v1)*F + i*harmonic_im_v2_A_v1_A_v2*A_v1*A_v2
struct harmonic_Omega_of_v2 : BlockShape<6, 2, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 + 2.0 * omega2);
    return {-per_0 / (2.0 * omega1), 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * F;  // eta21
    column[1] = factor[1] * (A_v1 * A_v2);  // harmonic_re_v2_A_v1_A_v2
    column[2] = times_i(factor[1] * F);  // harmonic_im_v2_F
    column[3] = factor[1] * (norm_A_v2 * F);  // harmonic_re_v2_A_v2_conjA_v2_F
    column[4] = factor[1] * (norm_A_v1 * F);  // harmonic_re_v2_A_v1_conjA_v1_F
    column[5] = times_i(factor[1] * (A_v1 * A_v2));  // harmonic_im_v2_A_v1_A_v2
  }
};

/// amplitude of exp(i*(omega2 + Omega)*t) in v2 = -1/(2*(omega1 + omega2)*(omega1 + 3*omega2))*eta22*A_v2*F +
/// harmonic_re_v2_A_v2_F*A_v2*F + harmonic_re_v2_A_v1_A_v22*A_v1*A_v2^2
struct harmonic_omega2_plus_Omega_of_v2 : BlockShape<3, 2, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 + omega2);
    const Number per_1 = 1.0 / (omega1 + 3.0 * omega2);
    const Number over_0 = per_0 * per_1;
    return {-over_0 / 2.0, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_v2 * F);  // eta22
    column[1] = factor[1] * (A_v2 * F);  // harmonic_re_v2_A_v2_F
    column[2] = factor[1] * (A_v1 * A_v2 * A_v2);  // harmonic_re_v2_A_v1_A_v22
  }
};

/// amplitude of exp(i*(2*omega2)*t) in v2 = harmonic_re_v2_A_v22*A_v2^2 +
/// harmonic_re_v2_A_v2_conjA_v1_F*conj(A_v1)*A_v2*F + i*harmonic_im_v2_A_v22*A_v2^2
struct harmonic_2_omega2_of_v2 : BlockShape<3, 1, is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_v2 * A_v2);  // harmonic_re_v2_A_v22
    column[1] = factor[0] * (conj_A_v1 * A_v2 * F);  // harmonic_re_v2_A_v2_conjA_v1_F
    column[2] = times_i(factor[0] * (A_v2 * A_v2));  // harmonic_im_v2_A_v22
  }
};

/// amplitude of exp(i*(2*omega1)*t) in v2 = harmonic_re_v2_A_v12*A_v1^2 +
/// harmonic_re_v2_A_v1_conjA_v2_F*A_v1*conj(A_v2)*F + i*harmonic_im_v2_A_v12*A_v1^2
struct harmonic_2_omega1_of_v2 : BlockShape<3, 1, is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_v1 * A_v1);  // harmonic_re_v2_A_v12
    column[1] = factor[0] * (A_v1 * conj_A_v2 * F);  // harmonic_re_v2_A_v1_conjA_v2_F
    column[2] = times_i(factor[0] * (A_v1 * A_v1));  // harmonic_im_v2_A_v12
  }
};

/// amplitude of exp(i*(omega1 + Omega)*t) in v2 = (omega1*omega2 + 3*omega2^2)/(4*omega1*(omega1 +
/// omega2)^2)*conservative_v2_A_v2_F2*conj(A_v2)*F^2 + harmonic_re_v2_A_v1_F*A_v1*F +
/// i*harmonic_im_v2_A_v1_F*A_v1*F + harmonic_re_v2_A_v12_A_v2*A_v1^2*A_v2
struct harmonic_omega1_plus_Omega_of_v2 : BlockShape<4, 2, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega2_2 = omega2 * omega2;
    const Number per_0 = 1.0 / (omega1 + omega2);
    const Number per_0_2 = per_0 * per_0;
    return {(omega1 * omega2 + 3.0 * omega2_2) * per_0_2 / (4.0 * omega1), 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (conj_A_v2 * F * F);  // conservative_v2_A_v2_F2
    column[1] = factor[1] * (A_v1 * F);  // harmonic_re_v2_A_v1_F
    column[2] = times_i(factor[1] * (A_v1 * F));  // harmonic_im_v2_A_v1_F
    column[3] = factor[1] * (A_v1 * A_v1 * A_v2);  // harmonic_re_v2_A_v12_A_v2
  }
};

/// amplitude of exp(i*(2*Omega)*t) in v2 = -omega2^2/(2*(2*omega1 + omega2)*(2*omega1 +
/// 3*omega2))*harmonic_re_v2_F2*F^2 + harmonic_re_v2_A_v1_A_v2_F*A_v1*A_v2*F
struct harmonic_2_Omega_of_v2 : BlockShape<2, 2, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega2_2 = omega2 * omega2;
    const Number per_0 = 1.0 / (2.0 * omega1 + omega2);
    const Number per_1 = 1.0 / (2.0 * omega1 + 3.0 * omega2);
    const Number over_0 = per_0 * per_1;
    return {-omega2_2 * over_0 / 2.0, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (F * F);  // harmonic_re_v2_F2
    column[1] = factor[1] * (A_v1 * A_v2 * F);  // harmonic_re_v2_A_v1_A_v2_F
  }
};

/// amplitude of exp(i*(omega2 + 2*Omega)*t) in v2 = (omega1^2*omega2 + 2*omega1*omega2^2 -
/// 3*omega2^3)/(4*Omega^2*(omega2 + Omega)*(2*omega2 + Omega))*conservative_v2_A_v2_F2*A_v2*F^2
struct harmonic_omega2_plus_2_Omega_of_v2 : BlockShape<1, 1, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number omega2_2 = omega2 * omega2;
    const Number omega2_3 = omega2_2 * omega2;
    const Number Omega_2 = Omega * Omega;
    const Number per_0 = 1.0 / (omega2 + Omega);
    const Number per_1 = 1.0 / (2.0 * omega2 + Omega);
    const Number over_0 = per_0 * per_1;
    return {(omega1_2 * omega2 + 2.0 * omega1 * omega2_2 - 3.0 * omega2_3) * over_0 / (4.0 * Omega_2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_v2 * F * F);  // conservative_v2_A_v2_F2
  }
};

/// amplitude of exp(i*(2*omega2 + Omega)*t) in v2 = harmonic_re_v2_A_v22_F*A_v2^2*F
struct harmonic_2_omega2_plus_Omega_of_v2 : BlockShape<1, 1, is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_v2 * A_v2 * F);  // harmonic_re_v2_A_v22_F
  }
};

/// amplitude of exp(i*(2*omega1 + Omega)*t) in v2 = harmonic_re_v2_A_v12_F*A_v1^2*F
struct harmonic_2_omega1_plus_Omega_of_v2 : BlockShape<1, 1, is_forced> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * (A_v1 * A_v1 * F);  // harmonic_re_v2_A_v12_F
  }
};

inline constexpr BlockFunctions blocks[34] = {modulation_functions<Model, modulation_of_v1>(),
    modulation_functions<Model, modulation_of_v2>(), harmonic_functions<Model, harmonic_omega2_of_v1>(),
    harmonic_functions<Model, harmonic_minus_omega1_plus_omega2_of_v1>(),
    harmonic_functions<Model, harmonic_0_of_v1>(), harmonic_functions<Model, harmonic_Omega_of_v1>(),
    harmonic_functions<Model, harmonic_2_omega2_of_v1>(),
    harmonic_functions<Model, harmonic_omega1_plus_Omega_of_v1>(),
    harmonic_functions<Model, harmonic_2_omega1_of_v1>(),
    harmonic_functions<Model, principal_parametric_2::harmonic_minus_2_omega1_plus_omega2_of_v1>(),
    harmonic_functions<Model, harmonic_omega2_plus_Omega_of_v1>(),
    harmonic_functions<Model, principal_parametric_1::harmonic_minus_omega1_plus_2_omega2_of_v1>(),
    harmonic_functions<Model, harmonic_2_Omega_of_v1>(),
    harmonic_functions<Model, harmonic_2_omega2_plus_Omega_of_v1>(),
    harmonic_functions<Model, primary_1::harmonic_3_omega2_of_v1>(),
    harmonic_functions<Model, harmonic_omega1_plus_2_Omega_of_v1>(),
    harmonic_functions<Model, harmonic_2_omega1_plus_Omega_of_v1>(),
    harmonic_functions<Model, primary_2::harmonic_3_omega1_of_v1>(),
    harmonic_functions<Model, harmonic_minus_omega1_plus_omega2_of_v2>(),
    harmonic_functions<Model, harmonic_omega1_of_v2>(), harmonic_functions<Model, harmonic_0_of_v2>(),
    harmonic_functions<Model, harmonic_Omega_of_v2>(),
    harmonic_functions<Model, harmonic_omega2_plus_Omega_of_v2>(),
    harmonic_functions<Model, harmonic_2_omega2_of_v2>(), harmonic_functions<Model, harmonic_2_omega1_of_v2>(),
    harmonic_functions<Model, principal_parametric_2::harmonic_minus_2_omega1_plus_omega2_of_v2>(),
    harmonic_functions<Model, principal_parametric_1::harmonic_minus_omega1_plus_2_omega2_of_v2>(),
    harmonic_functions<Model, harmonic_omega1_plus_Omega_of_v2>(),
    harmonic_functions<Model, harmonic_2_Omega_of_v2>(),
    harmonic_functions<Model, harmonic_omega2_plus_2_Omega_of_v2>(),
    harmonic_functions<Model, harmonic_2_omega2_plus_Omega_of_v2>(),
    harmonic_functions<Model, primary_1::harmonic_3_omega2_of_v2>(),
    harmonic_functions<Model, harmonic_2_omega1_plus_Omega_of_v2>(),
    harmonic_functions<Model, primary_2::harmonic_3_omega1_of_v2>()};

}  // namespace additive_combination
}  // namespace secular::generated::two_mass
