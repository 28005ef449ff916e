// Model three_modes: generated code, never edited by hand.
// Holds rows of the case free. Made by: secular generate three_modes.
// free vibration, multiple scales to eps^2. Valid near that resonance for small amplitudes; what is left out is
// of order eps^3.
#pragma once

#include "three_modes.additive_combination.hpp"
#include "three_modes.hpp"

namespace secular::generated::three_modes {

namespace free {

/// (rate - i*omega1)*A_v1 = -mu1*A_v1 + i*conservative_v1_A_v1_A_v3_conjA_v3*A_v1*A_v3*conj(A_v3) +
/// i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*A_v2*conj(A_v2) +
/// i*conservative_v1_A_v12_conjA_v1*A_v1^2*conj(A_v1)
struct modulation_of_v1 : BlockShape<4, 2, 0> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>&) {
    return {-1.0, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * A_v1;  // mu1
    column[1] = times_i(factor[1] * (A_v1 * norm_A_v3));  // conservative_v1_A_v1_A_v3_conjA_v3
    column[2] = times_i(factor[1] * (A_v1 * norm_A_v2));  // conservative_v1_A_v1_A_v2_conjA_v2
    column[3] = times_i(factor[1] * (norm_A_v1 * A_v1));  // conservative_v1_A_v12_conjA_v1
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    by[0] = ComplexNumber<double>(lump[0] * factor[0], lump[1] * factor[1] * norm_A_v3
        + lump[2] * factor[1] * norm_A_v2 + 2.0 * lump[3] * factor[1] * norm_A_v1);
    by_conjugate[0] = times_i(lump[3] * factor[1] * (A_v1 * A_v1));
    by[1] = times_i(lump[2] * factor[1] * (A_v1 * conj_A_v2));
    by_conjugate[1] = times_i(lump[2] * factor[1] * (A_v1 * A_v2));
    by[2] = times_i(lump[1] * factor[1] * (A_v1 * conj_A_v3));
    by_conjugate[2] = times_i(lump[1] * factor[1] * (A_v1 * A_v3));
  }
};

/// (rate - i*omega2)*A_v2 = omega1/omega2*i*conservative_v1_A_v1_A_v2_conjA_v2*A_v1*conj(A_v1)*A_v2 - mu2*A_v2 +
/// i*conservative_v2_A_v2_A_v3_conjA_v3*A_v2*A_v3*conj(A_v3) +
/// i*conservative_v2_A_v22_conjA_v2*A_v2^2*conj(A_v2)
struct modulation_of_v2 : BlockShape<4, 3, follows_modes> {
  template <class Number>
  static NumberList<Number, 3> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    return {omega1 / omega2, -1.0, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = times_i(factor[0] * (norm_A_v1 * A_v2));  // conservative_v1_A_v1_A_v2_conjA_v2
    column[1] = factor[1] * A_v2;  // mu2
    column[2] = times_i(factor[2] * (A_v2 * norm_A_v3));  // conservative_v2_A_v2_A_v3_conjA_v3
    column[3] = times_i(factor[2] * (norm_A_v2 * A_v2));  // conservative_v2_A_v22_conjA_v2
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    by[0] = times_i(lump[0] * factor[0] * (conj_A_v1 * A_v2));
    by_conjugate[0] = times_i(lump[0] * factor[0] * (A_v1 * A_v2));
    by[1] = ComplexNumber<double>(lump[1] * factor[1], lump[0] * factor[0] * norm_A_v1
        + lump[2] * factor[2] * norm_A_v3 + 2.0 * lump[3] * factor[2] * norm_A_v2);
    by_conjugate[1] = times_i(lump[3] * factor[2] * (A_v2 * A_v2));
    by[2] = times_i(lump[2] * factor[2] * (A_v2 * conj_A_v3));
    by_conjugate[2] = times_i(lump[2] * factor[2] * (A_v2 * A_v3));
  }
};

/// (rate - i*omega3)*A_v3 = omega1/omega3*i*conservative_v1_A_v1_A_v3_conjA_v3*A_v1*conj(A_v1)*A_v3 +
/// omega2/omega3*i*conservative_v2_A_v2_A_v3_conjA_v3*A_v2*conj(A_v2)*A_v3 - mu3*A_v3 +
/// i*conservative_v3_A_v32_conjA_v3*A_v3^2*conj(A_v3)
struct modulation_of_v3 : BlockShape<4, 4, follows_modes> {
  template <class Number>
  static NumberList<Number, 4> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    return {omega1 / omega3, omega2 / omega3, -1.0, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = times_i(factor[0] * (norm_A_v1 * A_v3));  // conservative_v1_A_v1_A_v3_conjA_v3
    column[1] = times_i(factor[1] * (norm_A_v2 * A_v3));  // conservative_v2_A_v2_A_v3_conjA_v3
    column[2] = factor[2] * A_v3;  // mu3
    column[3] = times_i(factor[3] * (norm_A_v3 * A_v3));  // conservative_v3_A_v32_conjA_v3
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    by[0] = times_i(lump[0] * factor[0] * (conj_A_v1 * A_v3));
    by_conjugate[0] = times_i(lump[0] * factor[0] * (A_v1 * A_v3));
    by[1] = times_i(lump[1] * factor[1] * (conj_A_v2 * A_v3));
    by_conjugate[1] = times_i(lump[1] * factor[1] * (A_v2 * A_v3));
    by[2] = ComplexNumber<double>(lump[2] * factor[2], lump[0] * factor[0] * norm_A_v1
        + lump[1] * factor[1] * norm_A_v2 + 2.0 * lump[3] * factor[3] * norm_A_v3);
    by_conjugate[2] = times_i(lump[3] * factor[3] * (A_v3 * A_v3));
  }
};

/// amplitude of exp(i*(-omega1 + omega3)*t) in v1 = -2/(omega3*(2*omega1 - omega3))*a113*conj(A_v1)*A_v3
struct harmonic_minus_omega1_plus_omega3_of_v1 : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number per_0 = 1.0 / (2.0 * omega1 - omega3);
    return {-2.0 * per_0 / omega3};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (conj_A_v1 * A_v3);  // a113
  }
};

/// amplitude of exp(i*(-omega2 + omega3)*t) in v1 = -1/((omega1 + omega2 - omega3)*(omega1 - omega2 +
/// omega3))*a123*conj(A_v2)*A_v3
struct harmonic_minus_omega2_plus_omega3_of_v1 : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 + omega2 - omega3);
    const Number per_1 = 1.0 / (omega1 - omega2 + omega3);
    const Number over_0 = per_0 * per_1;
    return {-over_0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (conj_A_v2 * A_v3);  // a123
  }
};

/// amplitude of exp(i*(omega2 + omega3)*t) in v1 = -1/((omega1 + omega2 + omega3)*(omega1 - omega2 -
/// omega3))*a123*A_v2*A_v3
struct harmonic_omega2_plus_omega3_of_v1 : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 + omega2 + omega3);
    const Number per_1 = 1.0 / (omega1 - omega2 - omega3);
    const Number over_0 = per_0 * per_1;
    return {-over_0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v2 * A_v3);  // a123
  }
};

/// amplitude of exp(i*(omega1 + omega3)*t) in v1 = 2/(omega3*(2*omega1 + omega3))*a113*A_v1*A_v3
struct harmonic_omega1_plus_omega3_of_v1 : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number per_0 = 1.0 / (2.0 * omega1 + omega3);
    return {2.0 * per_0 / omega3};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v1 * A_v3);  // a113
  }
};

/// amplitude of exp(i*(-omega1 + 2*omega3)*t) in v1 = harmonic_re_v1_A_v32_conjA_v1*conj(A_v1)*A_v3^2
struct harmonic_minus_omega1_plus_2_omega3_of_v1 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (conj_A_v1 * A_v3 * A_v3);  // harmonic_re_v1_A_v32_conjA_v1
  }
};

/// amplitude of exp(i*(-omega2 + 2*omega3)*t) in v1 = harmonic_re_v1_A_v32_conjA_v2*conj(A_v2)*A_v3^2
struct harmonic_minus_omega2_plus_2_omega3_of_v1 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (conj_A_v2 * A_v3 * A_v3);  // harmonic_re_v1_A_v32_conjA_v2
  }
};

/// amplitude of exp(i*(omega2)*t) in v1 = (24*omega1^7 - 8*omega1^6*omega2 - 48*omega1^5*omega2^2 -
/// 102*omega1^5*omega3^2 + 16*omega1^4*omega2^3 + 34*omega1^4*omega2*omega3^2 + 24*omega1^3*omega2^4 -
/// 84*omega1^3*omega2^2*omega3^2 + 96*omega1^3*omega3^4 - 8*omega1^2*omega2^5 + 28*omega1^2*omega2^3*omega3^2 -
/// 32*omega1^2*omega2*omega3^4 - 6*omega1*omega2^4*omega3^2 + 24*omega1*omega2^2*omega3^4 - 18*omega1*omega3^6 +
/// 2*omega2^5*omega3^2 - 8*omega2^3*omega3^4 + 6*omega2*omega3^6)/(omega3^2*(9*omega1^2 - 2*omega1*omega2 +
/// omega2^2 - 3*omega3^2)*(omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 -
/// omega3))*harmonic_re_v1_A_v2_conjA_v12*A_v1*conj(A_v1)*A_v2 +
/// harmonic_re_v1_A_v2_A_v3_conjA_v3*A_v2*A_v3*conj(A_v3) + harmonic_re_v1_A_v22_conjA_v2*A_v2^2*conj(A_v2)
struct harmonic_omega2_of_v1 : BlockShape<3, 2, follows_modes> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number omega1_3 = omega1_2 * omega1;
    const Number omega1_4 = omega1_3 * omega1;
    const Number omega1_5 = omega1_4 * omega1;
    const Number omega1_6 = omega1_5 * omega1;
    const Number omega1_7 = omega1_6 * omega1;
    const Number omega2_2 = omega2 * omega2;
    const Number omega2_3 = omega2_2 * omega2;
    const Number omega2_4 = omega2_3 * omega2;
    const Number omega2_5 = omega2_4 * omega2;
    const Number omega3_2 = omega3 * omega3;
    const Number omega3_3 = omega3_2 * omega3;
    const Number omega3_4 = omega3_3 * omega3;
    const Number omega3_5 = omega3_4 * omega3;
    const Number omega3_6 = omega3_5 * omega3;
    const Number per_0 = 1.0 / (9.0 * omega1_2 - 2.0 * omega1 * omega2 + omega2_2 - 3.0 * omega3_2);
    const Number per_1 = 1.0 / (omega1 + omega2);
    const Number per_2 = 1.0 / (omega1 + omega2 + omega3);
    const Number per_3 = 1.0 / (omega1 + omega2 - omega3);
    const Number over_0 = per_0 * per_1 * per_2 * per_3;
    return {(24.0 * omega1_7 - 8.0 * omega1_6 * omega2 - 48.0 * omega1_5 * omega2_2 - 102.0 * omega1_5 * omega3_2
        + 16.0 * omega1_4 * omega2_3 + 34.0 * omega1_4 * omega2 * omega3_2 + 24.0 * omega1_3 * omega2_4
        - 84.0 * omega1_3 * omega2_2 * omega3_2 + 96.0 * omega1_3 * omega3_4 - 8.0 * omega1_2 * omega2_5
        + 28.0 * omega1_2 * omega2_3 * omega3_2 - 32.0 * omega1_2 * omega2 * omega3_4
        - 6.0 * omega1 * omega2_4 * omega3_2 + 24.0 * omega1 * omega2_2 * omega3_4 - 18.0 * omega1 * omega3_6
        + 2.0 * omega2_5 * omega3_2 - 8.0 * omega2_3 * omega3_4 + 6.0 * omega2 * omega3_6) * over_0 / omega3_2,
        1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (norm_A_v1 * A_v2);  // harmonic_re_v1_A_v2_conjA_v12
    column[1] = factor[1] * (A_v2 * norm_A_v3);  // harmonic_re_v1_A_v2_A_v3_conjA_v3
    column[2] = factor[1] * (norm_A_v2 * A_v2);  // harmonic_re_v1_A_v22_conjA_v2
  }
};

/// amplitude of exp(i*(omega2 + 2*omega3)*t) in v1 = harmonic_re_v1_A_v2_A_v32*A_v2*A_v3^2
struct harmonic_omega2_plus_2_omega3_of_v1 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v2 * A_v3 * A_v3);  // harmonic_re_v1_A_v2_A_v32
  }
};

/// amplitude of exp(i*(omega1 + 2*omega3)*t) in v1 = harmonic_re_v1_A_v1_A_v32*A_v1*A_v3^2
struct harmonic_omega1_plus_2_omega3_of_v1 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v1 * A_v3 * A_v3);  // harmonic_re_v1_A_v1_A_v32
  }
};

/// amplitude of exp(i*(omega1 + 2*omega2)*t) in v1 = harmonic_re_v1_A_v1_A_v22*A_v1*A_v2^2
struct harmonic_omega1_plus_2_omega2_of_v1 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v1 * A_v2 * A_v2);  // harmonic_re_v1_A_v1_A_v22
  }
};

/// amplitude of exp(i*(2*omega1 + omega2)*t) in v1 = (27*omega1^6 - 84*omega1^5*omega2 + 91*omega1^4*omega2^2 -
/// 36*omega1^4*omega3^2 - 40*omega1^3*omega2^3 + 60*omega1^3*omega2*omega3^2 + 9*omega1^2*omega2^4 -
/// 40*omega1^2*omega2^2*omega3^2 + 9*omega1^2*omega3^4 - 4*omega1*omega2^5 + 20*omega1*omega2^3*omega3^2 -
/// 12*omega1*omega2*omega3^4 + omega2^6 - 4*omega2^4*omega3^2 + 3*omega2^2*omega3^4)/((9*omega1^2 -
/// 2*omega1*omega2 + omega2^2 - 3*omega3^2)*(omega1 + omega2)*(omega1 + omega2 + omega3)*(omega1 + omega2 -
/// omega3)*(3*omega1 + omega2))*harmonic_re_v1_A_v2_conjA_v12*A_v1^2*A_v2
struct harmonic_2_omega1_plus_omega2_of_v1 : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number omega1_3 = omega1_2 * omega1;
    const Number omega1_4 = omega1_3 * omega1;
    const Number omega1_5 = omega1_4 * omega1;
    const Number omega1_6 = omega1_5 * omega1;
    const Number omega2_2 = omega2 * omega2;
    const Number omega2_3 = omega2_2 * omega2;
    const Number omega2_4 = omega2_3 * omega2;
    const Number omega2_5 = omega2_4 * omega2;
    const Number omega2_6 = omega2_5 * omega2;
    const Number omega3_2 = omega3 * omega3;
    const Number omega3_3 = omega3_2 * omega3;
    const Number omega3_4 = omega3_3 * omega3;
    const Number per_0 = 1.0 / (9.0 * omega1_2 - 2.0 * omega1 * omega2 + omega2_2 - 3.0 * omega3_2);
    const Number per_1 = 1.0 / (omega1 + omega2);
    const Number per_2 = 1.0 / (omega1 + omega2 + omega3);
    const Number per_3 = 1.0 / (omega1 + omega2 - omega3);
    const Number per_4 = 1.0 / (3.0 * omega1 + omega2);
    const Number over_0 = per_0 * per_1 * per_2 * per_3 * per_4;
    return {(27.0 * omega1_6 - 84.0 * omega1_5 * omega2 + 91.0 * omega1_4 * omega2_2 - 36.0 * omega1_4 * omega3_2
        - 40.0 * omega1_3 * omega2_3 + 60.0 * omega1_3 * omega2 * omega3_2 + 9.0 * omega1_2 * omega2_4
        - 40.0 * omega1_2 * omega2_2 * omega3_2 + 9.0 * omega1_2 * omega3_4 - 4.0 * omega1 * omega2_5
        + 20.0 * omega1 * omega2_3 * omega3_2 - 12.0 * omega1 * omega2 * omega3_4 + omega2_6
        - 4.0 * omega2_4 * omega3_2 + 3.0 * omega2_2 * omega3_4) * over_0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v1 * A_v1 * A_v2);  // harmonic_re_v1_A_v2_conjA_v12
  }
};

/// amplitude of exp(i*(-omega1 + omega3)*t) in v2 = 1/((omega1 + omega2 - omega3)*(omega1 - omega2 -
/// omega3))*a123*conj(A_v1)*A_v3
struct harmonic_minus_omega1_plus_omega3_of_v2 : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 + omega2 - omega3);
    const Number per_1 = 1.0 / (omega1 - omega2 - omega3);
    const Number over_0 = per_0 * per_1;
    return {over_0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (conj_A_v1 * A_v3);  // a123
  }
};

/// amplitude of exp(i*(-omega2 + omega3)*t) in v2 = -2/(omega3*(2*omega2 - omega3))*a223*conj(A_v2)*A_v3
struct harmonic_minus_omega2_plus_omega3_of_v2 : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number per_0 = 1.0 / (2.0 * omega2 - omega3);
    return {-2.0 * per_0 / omega3};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (conj_A_v2 * A_v3);  // a223
  }
};

/// amplitude of exp(i*(omega2 + omega3)*t) in v2 = 2/(omega3*(2*omega2 + omega3))*a223*A_v2*A_v3
struct harmonic_omega2_plus_omega3_of_v2 : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number per_0 = 1.0 / (2.0 * omega2 + omega3);
    return {2.0 * per_0 / omega3};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v2 * A_v3);  // a223
  }
};

/// amplitude of exp(i*(omega1 + omega3)*t) in v2 = 1/((omega1 + omega2 + omega3)*(omega1 - omega2 +
/// omega3))*a123*A_v1*A_v3
struct harmonic_omega1_plus_omega3_of_v2 : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 + omega2 + omega3);
    const Number per_1 = 1.0 / (omega1 - omega2 + omega3);
    const Number over_0 = per_0 * per_1;
    return {over_0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v1 * A_v3);  // a123
  }
};

/// amplitude of exp(i*(-omega1 + 2*omega3)*t) in v2 = harmonic_re_v2_A_v32_conjA_v1*conj(A_v1)*A_v3^2
struct harmonic_minus_omega1_plus_2_omega3_of_v2 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (conj_A_v1 * A_v3 * A_v3);  // harmonic_re_v2_A_v32_conjA_v1
  }
};

/// amplitude of exp(i*(-omega2 + 2*omega3)*t) in v2 = harmonic_re_v2_A_v32_conjA_v2*conj(A_v2)*A_v3^2
struct harmonic_minus_omega2_plus_2_omega3_of_v2 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (conj_A_v2 * A_v3 * A_v3);  // harmonic_re_v2_A_v32_conjA_v2
  }
};

/// amplitude of exp(i*(omega2 + 2*omega3)*t) in v2 = harmonic_re_v2_A_v2_A_v32*A_v2*A_v3^2
struct harmonic_omega2_plus_2_omega3_of_v2 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v2 * A_v3 * A_v3);  // harmonic_re_v2_A_v2_A_v32
  }
};

/// amplitude of exp(i*(omega1)*t) in v2 = (-24*omega1^5 + 56*omega1^4*omega2 - 40*omega1^3*omega2^2 +
/// 33*omega1^3*omega3^2 + 8*omega1^2*omega2^3 - 29*omega1^2*omega2*omega3^2 + 15*omega1*omega2^2*omega3^2 -
/// 9*omega1*omega3^4 - 3*omega2^3*omega3^2 + 3*omega2*omega3^4)/(omega3^2*(9*omega1^2 - 2*omega1*omega2 +
/// omega2^2 - 3*omega3^2)*(omega1 + omega2))*harmonic_re_v1_A_v2_conjA_v12*A_v1^2*conj(A_v1) +
/// (-8*omega1^4*omega2^2 + 2*omega1^4*omega3^2 + 16*omega1^2*omega2^4 + 28*omega1^2*omega2^2*omega3^2 -
/// 8*omega1^2*omega3^4 - 8*omega2^6 + 34*omega2^4*omega3^2 - 32*omega2^2*omega3^4 + 6*omega3^6)/((omega1 +
/// omega2 + omega3)*(omega1 + omega2 - omega3)*(omega1 - omega2 + omega3)*(omega1 - omega2 - omega3)*(8*omega2^2
/// - 3*omega3^2))*harmonic_re_v1_A_v22_conjA_v2*A_v1*A_v2*conj(A_v2) +
/// harmonic_re_v2_A_v1_A_v3_conjA_v3*A_v1*A_v3*conj(A_v3)
struct harmonic_omega1_of_v2 : BlockShape<3, 3, follows_modes> {
  template <class Number>
  static NumberList<Number, 3> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number omega1_3 = omega1_2 * omega1;
    const Number omega1_4 = omega1_3 * omega1;
    const Number omega1_5 = omega1_4 * omega1;
    const Number omega2_2 = omega2 * omega2;
    const Number omega2_3 = omega2_2 * omega2;
    const Number omega2_4 = omega2_3 * omega2;
    const Number omega2_5 = omega2_4 * omega2;
    const Number omega2_6 = omega2_5 * omega2;
    const Number omega3_2 = omega3 * omega3;
    const Number omega3_3 = omega3_2 * omega3;
    const Number omega3_4 = omega3_3 * omega3;
    const Number omega3_5 = omega3_4 * omega3;
    const Number omega3_6 = omega3_5 * omega3;
    const Number per_0 = 1.0 / (9.0 * omega1_2 - 2.0 * omega1 * omega2 + omega2_2 - 3.0 * omega3_2);
    const Number per_1 = 1.0 / (omega1 + omega2);
    const Number per_2 = 1.0 / (omega1 + omega2 + omega3);
    const Number per_3 = 1.0 / (omega1 + omega2 - omega3);
    const Number per_4 = 1.0 / (omega1 - omega2 + omega3);
    const Number per_5 = 1.0 / (omega1 - omega2 - omega3);
    const Number per_6 = 1.0 / (8.0 * omega2_2 - 3.0 * omega3_2);
    const Number over_0 = per_0 * per_1;
    const Number over_1 = per_2 * per_3 * per_4 * per_5 * per_6;
    return {(-24.0 * omega1_5 + 56.0 * omega1_4 * omega2 - 40.0 * omega1_3 * omega2_2 + 33.0 * omega1_3 * omega3_2
        + 8.0 * omega1_2 * omega2_3 - 29.0 * omega1_2 * omega2 * omega3_2 + 15.0 * omega1 * omega2_2 * omega3_2
        - 9.0 * omega1 * omega3_4 - 3.0 * omega2_3 * omega3_2 + 3.0 * omega2 * omega3_4) * over_0 / omega3_2,
        (-8.0 * omega1_4 * omega2_2 + 2.0 * omega1_4 * omega3_2 + 16.0 * omega1_2 * omega2_4
            + 28.0 * omega1_2 * omega2_2 * omega3_2 - 8.0 * omega1_2 * omega3_4 - 8.0 * omega2_6
            + 34.0 * omega2_4 * omega3_2 - 32.0 * omega2_2 * omega3_4 + 6.0 * omega3_6) * over_1,
        1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (norm_A_v1 * A_v1);  // harmonic_re_v1_A_v2_conjA_v12
    column[1] = factor[1] * (A_v1 * norm_A_v2);  // harmonic_re_v1_A_v22_conjA_v2
    column[2] = factor[2] * (A_v1 * norm_A_v3);  // harmonic_re_v2_A_v1_A_v3_conjA_v3
  }
};

/// amplitude of exp(i*(omega1 + 2*omega3)*t) in v2 = harmonic_re_v2_A_v1_A_v32*A_v1*A_v3^2
struct harmonic_omega1_plus_2_omega3_of_v2 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v1 * A_v3 * A_v3);  // harmonic_re_v2_A_v1_A_v32
  }
};

/// amplitude of exp(i*(omega1 + 2*omega2)*t) in v2 = (omega1^3*omega3^2 + omega1^2*omega2*omega3^2 +
/// 7*omega1*omega2^2*omega3^2 - 3*omega1*omega3^4 - 9*omega2^3*omega3^2 + 3*omega2*omega3^4)/((omega1 + omega2 +
/// omega3)*(omega1 + omega2 - omega3)*(omega1 + 3*omega2)*(8*omega2^2 -
/// 3*omega3^2))*harmonic_re_v1_A_v22_conjA_v2*A_v1*A_v2^2
struct harmonic_omega1_plus_2_omega2_of_v2 : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number omega1_3 = omega1_2 * omega1;
    const Number omega2_2 = omega2 * omega2;
    const Number omega2_3 = omega2_2 * omega2;
    const Number omega3_2 = omega3 * omega3;
    const Number omega3_3 = omega3_2 * omega3;
    const Number omega3_4 = omega3_3 * omega3;
    const Number per_0 = 1.0 / (omega1 + omega2 + omega3);
    const Number per_1 = 1.0 / (omega1 + omega2 - omega3);
    const Number per_2 = 1.0 / (omega1 + 3.0 * omega2);
    const Number per_3 = 1.0 / (8.0 * omega2_2 - 3.0 * omega3_2);
    const Number over_0 = per_0 * per_1 * per_2 * per_3;
    return {(omega1_3 * omega3_2 + omega1_2 * omega2 * omega3_2 + 7.0 * omega1 * omega2_2 * omega3_2
        - 3.0 * omega1 * omega3_4 - 9.0 * omega2_3 * omega3_2 + 3.0 * omega2 * omega3_4) * over_0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v1 * A_v2 * A_v2);  // harmonic_re_v1_A_v22_conjA_v2
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
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v1 * A_v1 * A_v2);  // harmonic_re_v2_A_v12_A_v2
  }
};

/// amplitude of exp(i*(0)*t) in v3 = -2/omega3^2*a113*A_v1*conj(A_v1) - 2/omega3^2*a223*A_v2*conj(A_v2) -
/// 2/omega3^2*a333*A_v3*conj(A_v3)
struct harmonic_0_of_v3 : BlockShape<3, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number omega3_2 = omega3 * omega3;
    return {-2.0 / omega3_2};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = ComplexNumber<Number>(factor[0] * norm_A_v1);  // a113
    column[1] = ComplexNumber<Number>(factor[0] * norm_A_v2);  // a223
    column[2] = ComplexNumber<Number>(factor[0] * norm_A_v3);  // a333
  }
};

/// amplitude of exp(i*(2*omega3)*t) in v3 = 1/(3*omega3^2)*a333*A_v3^2
struct harmonic_2_omega3_of_v3 : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number omega3_2 = omega3 * omega3;
    return {1.0 / (3.0 * omega3_2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v3 * A_v3);  // a333
  }
};

/// amplitude of exp(i*(omega1 + omega2)*t) in v3 = 1/((omega1 + omega2 + omega3)*(omega1 + omega2 -
/// omega3))*a123*A_v1*A_v2
struct harmonic_omega1_plus_omega2_of_v3 : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 + omega2 + omega3);
    const Number per_1 = 1.0 / (omega1 + omega2 - omega3);
    const Number over_0 = per_0 * per_1;
    return {over_0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v1 * A_v2);  // a123
  }
};

/// amplitude of exp(i*(-2*omega1 + omega3)*t) in v3 = harmonic_re_v3_A_v3_conjA_v12*conj(A_v1)^2*A_v3
struct harmonic_minus_2_omega1_plus_omega3_of_v3 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (conj_A_v1 * conj_A_v1 * A_v3);  // harmonic_re_v3_A_v3_conjA_v12
  }
};

/// amplitude of exp(i*(-omega1 - omega2 + omega3)*t) in v3 =
/// harmonic_re_v3_A_v3_conjA_v1_conjA_v2*conj(A_v1)*conj(A_v2)*A_v3
struct harmonic_minus_omega1_minus_omega2_plus_omega3_of_v3 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (conj_A_v1 * conj_A_v2 * A_v3);  // harmonic_re_v3_A_v3_conjA_v1_conjA_v2
  }
};

/// amplitude of exp(i*(-omega1 + omega2 + omega3)*t) in v3 =
/// harmonic_re_v3_A_v2_A_v3_conjA_v1*conj(A_v1)*A_v2*A_v3
struct harmonic_minus_omega1_plus_omega2_plus_omega3_of_v3 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (conj_A_v1 * A_v2 * A_v3);  // harmonic_re_v3_A_v2_A_v3_conjA_v1
  }
};

/// amplitude of exp(i*(3*omega3)*t) in v3 = -1/(20*omega3)*conservative_v3_A_v32_conjA_v3*A_v3^3
struct harmonic_3_omega3_of_v3 : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, omega3, Omega] = frequencies;
    return {-1.0 / (20.0 * omega3)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v3 * A_v3 * A_v3);  // conservative_v3_A_v32_conjA_v3
  }
};

/// amplitude of exp(i*(2*omega2 - omega3)*t) in v3 = harmonic_re_v3_A_v22_conjA_v3*A_v2^2*conj(A_v3)
struct harmonic_2_omega2_minus_omega3_of_v3 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v2 * A_v2 * conj_A_v3);  // harmonic_re_v3_A_v22_conjA_v3
  }
};

/// amplitude of exp(i*(2*omega2 + omega3)*t) in v3 = harmonic_re_v3_A_v22_A_v3*A_v2^2*A_v3
struct harmonic_2_omega2_plus_omega3_of_v3 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v2 * A_v2 * A_v3);  // harmonic_re_v3_A_v22_A_v3
  }
};

/// amplitude of exp(i*(omega1 - omega2 + omega3)*t) in v3 =
/// harmonic_re_v3_A_v1_A_v3_conjA_v2*A_v1*conj(A_v2)*A_v3
struct harmonic_omega1_minus_omega2_plus_omega3_of_v3 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v1 * conj_A_v2 * A_v3);  // harmonic_re_v3_A_v1_A_v3_conjA_v2
  }
};

/// amplitude of exp(i*(omega1 + omega2 + omega3)*t) in v3 = harmonic_re_v3_A_v1_A_v2_A_v3*A_v1*A_v2*A_v3
struct harmonic_omega1_plus_omega2_plus_omega3_of_v3 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v1 * A_v2 * A_v3);  // harmonic_re_v3_A_v1_A_v2_A_v3
  }
};

/// amplitude of exp(i*(2*omega1 + omega3)*t) in v3 = harmonic_re_v3_A_v12_A_v3*A_v1^2*A_v3
struct harmonic_2_omega1_plus_omega3_of_v3 : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_v1, conj_A_v1, norm_A_v1, A_v2, conj_A_v2, norm_A_v2, A_v3, conj_A_v3, norm_A_v3, F] = signals;
    column[0] = factor[0] * (A_v1 * A_v1 * A_v3);  // harmonic_re_v3_A_v12_A_v3
  }
};

inline constexpr BlockFunctions blocks[48] = {modulation_functions<Model, modulation_of_v1>(),
    modulation_functions<Model, modulation_of_v2>(), modulation_functions<Model, modulation_of_v3>(),
    harmonic_functions<Model, harmonic_minus_omega1_plus_omega3_of_v1>(),
    harmonic_functions<Model, harmonic_minus_omega2_plus_omega3_of_v1>(),
    harmonic_functions<Model, harmonic_omega2_plus_omega3_of_v1>(),
    harmonic_functions<Model, harmonic_omega1_plus_omega3_of_v1>(),
    harmonic_functions<Model, additive_combination::harmonic_minus_2_omega1_plus_omega2_of_v1>(),
    harmonic_functions<Model, harmonic_minus_omega1_plus_2_omega3_of_v1>(),
    harmonic_functions<Model, additive_combination::harmonic_minus_omega1_plus_2_omega2_of_v1>(),
    harmonic_functions<Model, harmonic_minus_omega2_plus_2_omega3_of_v1>(),
    harmonic_functions<Model, harmonic_omega2_of_v1>(),
    harmonic_functions<Model, harmonic_omega2_plus_2_omega3_of_v1>(),
    harmonic_functions<Model, additive_combination::harmonic_3_omega2_of_v1>(),
    harmonic_functions<Model, harmonic_omega1_plus_2_omega3_of_v1>(),
    harmonic_functions<Model, harmonic_omega1_plus_2_omega2_of_v1>(),
    harmonic_functions<Model, harmonic_2_omega1_plus_omega2_of_v1>(),
    harmonic_functions<Model, additive_combination::harmonic_3_omega1_of_v1>(),
    harmonic_functions<Model, harmonic_minus_omega1_plus_omega3_of_v2>(),
    harmonic_functions<Model, harmonic_minus_omega2_plus_omega3_of_v2>(),
    harmonic_functions<Model, harmonic_omega2_plus_omega3_of_v2>(),
    harmonic_functions<Model, harmonic_omega1_plus_omega3_of_v2>(),
    harmonic_functions<Model, additive_combination::harmonic_minus_2_omega1_plus_omega2_of_v2>(),
    harmonic_functions<Model, harmonic_minus_omega1_plus_2_omega3_of_v2>(),
    harmonic_functions<Model, additive_combination::harmonic_minus_omega1_plus_2_omega2_of_v2>(),
    harmonic_functions<Model, harmonic_minus_omega2_plus_2_omega3_of_v2>(),
    harmonic_functions<Model, harmonic_omega2_plus_2_omega3_of_v2>(),
    harmonic_functions<Model, additive_combination::harmonic_3_omega2_of_v2>(),
    harmonic_functions<Model, harmonic_omega1_of_v2>(),
    harmonic_functions<Model, harmonic_omega1_plus_2_omega3_of_v2>(),
    harmonic_functions<Model, harmonic_omega1_plus_2_omega2_of_v2>(),
    harmonic_functions<Model, harmonic_2_omega1_plus_omega2_of_v2>(),
    harmonic_functions<Model, additive_combination::harmonic_3_omega1_of_v2>(),
    harmonic_functions<Model, additive_combination::harmonic_minus_omega1_plus_omega2_of_v3>(),
    harmonic_functions<Model, harmonic_0_of_v3>(), harmonic_functions<Model, harmonic_2_omega3_of_v3>(),
    harmonic_functions<Model, additive_combination::harmonic_2_omega2_of_v3>(),
    harmonic_functions<Model, harmonic_omega1_plus_omega2_of_v3>(),
    harmonic_functions<Model, additive_combination::harmonic_2_omega1_of_v3>(),
    harmonic_functions<Model, harmonic_minus_2_omega1_plus_omega3_of_v3>(),
    harmonic_functions<Model, harmonic_minus_omega1_minus_omega2_plus_omega3_of_v3>(),
    harmonic_functions<Model, harmonic_minus_omega1_plus_omega2_plus_omega3_of_v3>(),
    harmonic_functions<Model, harmonic_3_omega3_of_v3>(),
    harmonic_functions<Model, harmonic_2_omega2_minus_omega3_of_v3>(),
    harmonic_functions<Model, harmonic_2_omega2_plus_omega3_of_v3>(),
    harmonic_functions<Model, harmonic_omega1_minus_omega2_plus_omega3_of_v3>(),
    harmonic_functions<Model, harmonic_omega1_plus_omega2_plus_omega3_of_v3>(),
    harmonic_functions<Model, harmonic_2_omega1_plus_omega3_of_v3>()};

}  // namespace free
}  // namespace secular::generated::three_modes
