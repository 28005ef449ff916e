// Model internal_resonance: generated code, never edited by hand.
// Holds rows of the case one_to_two. Made by: secular generate internal_resonance.
// omega2 = 2*omega1 + eps*sigma1; Omega = omega2 + eps*sigma2, multiple scales to eps^2. Valid near that
// resonance for small amplitudes; what is left out is of order eps^3.
#pragma once

#include "internal_resonance.hpp"

namespace secular::generated::internal_resonance {

namespace one_to_two {

/// (rate - i*omega1)*A_x = -mu1*A_x + i*conservative_x_A_x*A_x +
/// i*conservative_x_A_x_A_y_conjA_y*A_x*A_y*conj(A_y) + i*conservative_x_A_x2_conjA_x*A_x^2*conj(A_x) +
/// dissipative_x_A_y_conjA_x*conj(A_x)*A_y + 1/omega1*i*a2*conj(A_x)*A_y + (2*omega1 -
/// omega2)/(2*omega1^2)*i*a2*conj(A_x)*A_y + i*conservative_x_conjA_x_F*conj(A_x)*F
struct modulation_of_x : BlockShape<7, 4, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 4> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    return {-1.0, 1.0, 1.0 / omega1, (2.0 * omega1 - omega2) / (2.0 * omega1_2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = factor[0] * A_x;  // mu1
    column[1] = times_i(factor[1] * A_x);  // conservative_x_A_x
    column[2] = times_i(factor[1] * (A_x * norm_A_y));  // conservative_x_A_x_A_y_conjA_y
    column[3] = times_i(factor[1] * (norm_A_x * A_x));  // conservative_x_A_x2_conjA_x
    column[4] = factor[1] * (conj_A_x * A_y);  // dissipative_x_A_y_conjA_x
    column[5] = times_i(factor[2] * (conj_A_x * A_y)) + times_i(factor[3] * (conj_A_x * A_y));  // a2
    column[6] = times_i(factor[1] * (conj_A_x * F));  // conservative_x_conjA_x_F
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    by[0] = ComplexNumber<double>(lump[0] * factor[0], lump[1] * factor[1] + lump[2] * factor[1] * norm_A_y
        + 2.0 * lump[3] * factor[1] * norm_A_x);
    by_conjugate[0] = lump[4] * factor[1] * A_y + times_i(lump[3] * factor[1] * (A_x * A_x)
        + lump[5] * factor[2] * A_y + lump[5] * factor[3] * A_y + lump[6] * factor[1] * F);
    by[1] = lump[4] * factor[1] * conj_A_x + times_i(lump[2] * factor[1] * (A_x * conj_A_y)
        + lump[5] * factor[2] * conj_A_x + lump[5] * factor[3] * conj_A_x);
    by_conjugate[1] = times_i(lump[2] * factor[1] * (A_x * A_y));
  }
};

/// (rate - i*omega2)*A_y = 1/(2*omega2)*i*a2*A_x^2 + (-2*omega1 + omega2)/(4*omega2^2)*i*a2*A_x^2 +
/// dissipative_y_A_x2*A_x^2 - mu2*A_y + i*conservative_y_A_y*A_y + i*conservative_y_A_y2_conjA_y*A_y^2*conj(A_y)
/// + i*conservative_y_A_x_A_y_conjA_x*A_x*conj(A_x)*A_y + dissipative_y_F*F - 1/(4*omega2)*i*e2*F + (-omega2 +
/// Omega)/(8*omega2^2)*i*e2*F
struct modulation_of_y : BlockShape<8, 6, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 6> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega2_2 = omega2 * omega2;
    return {1.0 / (2.0 * omega2), (-2.0 * omega1 + omega2) / (4.0 * omega2_2), 1.0, -1.0, -1.0 / (4.0 * omega2),
        (-omega2 + Omega) / (8.0 * omega2_2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = times_i(factor[0] * (A_x * A_x)) + times_i(factor[1] * (A_x * A_x));  // a2
    column[1] = factor[2] * (A_x * A_x);  // dissipative_y_A_x2
    column[2] = factor[3] * A_y;  // mu2
    column[3] = times_i(factor[2] * A_y);  // conservative_y_A_y
    column[4] = times_i(factor[2] * (norm_A_y * A_y));  // conservative_y_A_y2_conjA_y
    column[5] = times_i(factor[2] * (norm_A_x * A_y));  // conservative_y_A_x_A_y_conjA_x
    column[6] = factor[2] * F;  // dissipative_y_F
    column[7] = times_i(factor[4] * F) + times_i(factor[5] * F);  // e2
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    by[0] = 2.0 * lump[1] * factor[2] * A_x + times_i(2.0 * lump[0] * factor[0] * A_x
        + 2.0 * lump[0] * factor[1] * A_x + lump[5] * factor[2] * (conj_A_x * A_y));
    by_conjugate[0] = times_i(lump[5] * factor[2] * (A_x * A_y));
    by[1] = ComplexNumber<double>(lump[2] * factor[3], lump[3] * factor[2] + 2.0 * lump[4] * factor[2] * norm_A_y
        + lump[5] * factor[2] * norm_A_x);
    by_conjugate[1] = times_i(lump[4] * factor[2] * (A_y * A_y));
  }
};

/// amplitude of exp(i*(0)*t) in x = -2/omega1^2*a3*A_y*conj(A_y) - 2/omega1^2*a1*A_x*conj(A_x) +
/// harmonic_re_x_A_y_conjA_x2*conj(A_x)^2*A_y + harmonic_re_x_A_y_conjA_x2*A_x^2*conj(A_y) +
/// harmonic_re_x_conjA_y_F*conj(A_y)*F + harmonic_re_x_conjA_y_F*A_y*F
struct harmonic_0_of_x : BlockShape<4, 2, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    return {-2.0 / omega1_2, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = ComplexNumber<Number>(factor[0] * norm_A_y);  // a3
    column[1] = ComplexNumber<Number>(factor[0] * norm_A_x);  // a1
    // harmonic_re_x_A_y_conjA_x2
    column[2] = factor[1] * (conj_A_x * conj_A_x * A_y) + factor[1] * (A_x * A_x * conj_A_y);
    column[3] = factor[1] * (conj_A_y * F) + factor[1] * (A_y * conj_F);  // harmonic_re_x_conjA_y_F
  }
};

/// amplitude of exp(i*(Omega)*t) in x = 1/(3*omega1^2)*a1*A_x^2 + 1/(2*(omega1 + omega2)*(omega1 - omega2))*e1*F
/// + (-omega2^2 + omega2*Omega)/((omega1 + omega2)^2*(omega1 - omega2)^2)*e1*F + i*harmonic_im_x_F*F +
/// harmonic_re_x_A_y2_conjA_y*A_y^2*conj(A_y) + harmonic_re_x_A_x_A_y_conjA_x*A_x*conj(A_x)*A_y +
/// harmonic_re_x_A_x_A_y_conjA_x*A_x*conj(A_x)*A_y + i*harmonic_im_x_A_x2*A_x^2
struct harmonic_Omega_of_x : BlockShape<6, 4, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 4> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number omega2_2 = omega2 * omega2;
    const Number per_0 = 1.0 / (omega1 + omega2);
    const Number per_0_2 = per_0 * per_0;
    const Number per_1 = 1.0 / (omega1 - omega2);
    const Number per_1_2 = per_1 * per_1;
    const Number over_0 = per_0 * per_1;
    const Number over_1 = per_0_2 * per_1_2;
    return {1.0 / (3.0 * omega1_2), over_0 / 2.0, (-omega2_2 + omega2 * Omega) * over_1, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = factor[0] * (A_x * A_x);  // a1
    column[1] = factor[1] * F + factor[2] * F;  // e1
    column[2] = times_i(factor[3] * F);  // harmonic_im_x_F
    column[3] = factor[3] * (norm_A_y * A_y);  // harmonic_re_x_A_y2_conjA_y
    column[4] = factor[3] * (norm_A_x * A_y) + factor[3] * (norm_A_x * A_y);  // harmonic_re_x_A_x_A_y_conjA_x
    column[5] = times_i(factor[3] * (A_x * A_x));  // harmonic_im_x_A_x2
  }
};

/// amplitude of exp(i*(omega2 + Omega)*t) in x = -1/((omega1 + 2*omega2)*(omega1 - 2*omega2))*a3*A_y^2 +
/// (omega1^4 - omega1^2*omega2^2)/((omega1 + omega2 + Omega)*(omega1 - omega2 - Omega)*(omega1 + Omega)*(omega1
/// - Omega))*harmonic_re_x_conjA_y_F*A_y*F + harmonic_re_x_A_x2_A_y*A_x^2*A_y + harmonic_re_x_A_x2_A_y*A_x^2*A_y
/// + i*harmonic_im_x_A_y2*A_y^2 + harmonic_re_x_A_y_F*A_y*F
struct harmonic_omega2_plus_Omega_of_x : BlockShape<5, 3, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 3> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number omega1_3 = omega1_2 * omega1;
    const Number omega1_4 = omega1_3 * omega1;
    const Number omega2_2 = omega2 * omega2;
    const Number per_0 = 1.0 / (omega1 + 2.0 * omega2);
    const Number per_1 = 1.0 / (omega1 - 2.0 * omega2);
    const Number per_2 = 1.0 / (omega1 + omega2 + Omega);
    const Number per_3 = 1.0 / (omega1 - omega2 - Omega);
    const Number per_4 = 1.0 / (omega1 + Omega);
    const Number per_5 = 1.0 / (omega1 - Omega);
    const Number over_0 = per_0 * per_1;
    const Number over_1 = per_2 * per_3 * per_4 * per_5;
    return {-over_0, (omega1_4 - omega1_2 * omega2_2) * over_1, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = factor[0] * (A_y * A_y);  // a3
    column[1] = factor[1] * (A_y * F);  // harmonic_re_x_conjA_y_F
    column[2] = factor[2] * (A_x * A_x * A_y) + factor[2] * (A_x * A_x * A_y);  // harmonic_re_x_A_x2_A_y
    column[3] = times_i(factor[2] * (A_y * A_y));  // harmonic_im_x_A_y2
    column[4] = factor[2] * (A_y * F);  // harmonic_re_x_A_y_F
  }
};

/// amplitude of exp(i*(omega1 + Omega)*t) in x = (-8*omega1^3 - 8*omega1^2*omega2)/(omega2^2*(2*omega1 +
/// omega2)^2)*i*dissipative_x_A_y_conjA_x*A_x*A_y + 2/(omega2*(2*omega1 + omega2))*a2*A_x*A_y +
/// harmonic_re_x_A_y2_conjA_x*conj(A_x)*A_y^2 + harmonic_re_x_A_x_F*A_x*F + harmonic_re_x_A_x_F*A_x*F +
/// harmonic_re_x_A_x3*A_x^3 + 2*omega2/omega1*harmonic_re_x_A_x3*conj(A_x)*A_y^2 + harmonic_re_x_A_x3*A_x^3
struct harmonic_omega1_plus_Omega_of_x : BlockShape<5, 4, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 4> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number omega1_3 = omega1_2 * omega1;
    const Number omega2_2 = omega2 * omega2;
    const Number per_0 = 1.0 / (2.0 * omega1 + omega2);
    const Number per_0_2 = per_0 * per_0;
    return {(-8.0 * omega1_3 - 8.0 * omega1_2 * omega2) * per_0_2 / omega2_2, 2.0 * per_0 / omega2, 1.0,
        2.0 * omega2 / omega1};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = times_i(factor[0] * (A_x * A_y));  // dissipative_x_A_y_conjA_x
    column[1] = factor[1] * (A_x * A_y);  // a2
    column[2] = factor[2] * (conj_A_x * A_y * A_y);  // harmonic_re_x_A_y2_conjA_x
    column[3] = factor[2] * (A_x * F) + factor[2] * (A_x * F);  // harmonic_re_x_A_x_F
    // harmonic_re_x_A_x3
    column[4] = factor[2] * (A_x * A_x * A_x) + factor[3] * (conj_A_x * A_y * A_y)
        + factor[2] * (A_x * A_x * A_x);
  }
};

/// amplitude of exp(i*(3*omega2)*t) in x = harmonic_re_x_A_y3*A_y^3
struct harmonic_3_omega2_of_x : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = factor[0] * (A_y * A_y * A_y);  // harmonic_re_x_A_y3
  }
};

/// amplitude of exp(i*(omega1 + 2*omega2)*t) in x = harmonic_re_x_A_x_A_y2*A_x*A_y^2
struct harmonic_omega1_plus_2_omega2_of_x : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = factor[0] * (A_x * A_y * A_y);  // harmonic_re_x_A_x_A_y2
  }
};

/// amplitude of exp(i*(omega1)*t) in y = 2/(omega1*(omega1 - 2*omega2))*a3*conj(A_x)*A_y + (-omega1^4 +
/// omega1^2*omega2^2)/((omega1 + omega2 - Omega)*(omega1 - omega2 - Omega)*(omega1 + Omega)*(omega1 -
/// Omega))*harmonic_re_x_conjA_y_F*conj(A_x)*F + (omega1^3 + 3*omega1^2*omega2 -
/// 4*omega2^3)/omega1^3*harmonic_re_x_A_x2_A_y*A_x*A_y*conj(A_y) + (-omega1^3 - 3*omega1^2*omega2 +
/// 4*omega2^3)/(2*omega1^2*omega2)*harmonic_re_x_A_x2_A_y*A_x^2*conj(A_x) + (-omega1^3 - 3*omega1^2*omega2 +
/// 4*omega2^3)/(2*omega1^2*omega2)*harmonic_re_x_A_y_F*conj(A_x)*F + i*harmonic_im_y_A_y_conjA_x*conj(A_x)*A_y +
/// harmonic_re_y_A_x_A_y_conjA_y*A_x*A_y*conj(A_y) + harmonic_re_y_A_x2_conjA_x*A_x^2*conj(A_x)
struct harmonic_omega1_of_y : BlockShape<7, 5, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 5> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number omega1_3 = omega1_2 * omega1;
    const Number omega1_4 = omega1_3 * omega1;
    const Number omega2_2 = omega2 * omega2;
    const Number omega2_3 = omega2_2 * omega2;
    const Number per_0 = 1.0 / (omega1 - 2.0 * omega2);
    const Number per_1 = 1.0 / (omega1 + omega2 - Omega);
    const Number per_2 = 1.0 / (omega1 - omega2 - Omega);
    const Number per_3 = 1.0 / (omega1 + Omega);
    const Number per_4 = 1.0 / (omega1 - Omega);
    const Number over_0 = per_1 * per_2 * per_3 * per_4;
    return {2.0 * per_0 / omega1, (-omega1_4 + omega1_2 * omega2_2) * over_0,
        (omega1_3 + 3.0 * omega1_2 * omega2 - 4.0 * omega2_3) / omega1_3,
        (-omega1_3 - 3.0 * omega1_2 * omega2 + 4.0 * omega2_3) / (2.0 * omega1_2 * omega2), 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = factor[0] * (conj_A_x * A_y);  // a3
    column[1] = factor[1] * (conj_A_x * F);  // harmonic_re_x_conjA_y_F
    column[2] = factor[2] * (A_x * norm_A_y) + factor[3] * (norm_A_x * A_x);  // harmonic_re_x_A_x2_A_y
    column[3] = factor[3] * (conj_A_x * F);  // harmonic_re_x_A_y_F
    column[4] = times_i(factor[4] * (conj_A_x * A_y));  // harmonic_im_y_A_y_conjA_x
    column[5] = factor[4] * (A_x * norm_A_y);  // harmonic_re_y_A_x_A_y_conjA_y
    column[6] = factor[4] * (norm_A_x * A_x);  // harmonic_re_y_A_x2_conjA_x
  }
};

/// amplitude of exp(i*(0)*t) in y = -2/omega2^2*a2*A_x*conj(A_x) - 2/omega2^2*a4*A_y*conj(A_y) +
/// harmonic_re_y_A_y_conjA_x2*conj(A_x)^2*A_y + harmonic_re_y_A_y_conjA_x2*A_x^2*conj(A_y) +
/// harmonic_re_y_conjA_y_F*conj(A_y)*F + harmonic_re_y_conjA_y_F*A_y*F
struct harmonic_0_of_y : BlockShape<4, 2, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega2_2 = omega2 * omega2;
    return {-2.0 / omega2_2, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = ComplexNumber<Number>(factor[0] * norm_A_x);  // a2
    column[1] = ComplexNumber<Number>(factor[0] * norm_A_y);  // a4
    // harmonic_re_y_A_y_conjA_x2
    column[2] = factor[1] * (conj_A_x * conj_A_x * A_y) + factor[1] * (A_x * A_x * conj_A_y);
    column[3] = factor[1] * (conj_A_y * F) + factor[1] * (A_y * conj_F);  // harmonic_re_y_conjA_y_F
  }
};

/// amplitude of exp(i*(omega2 + Omega)*t) in y = 1/(3*omega2^2)*a4*A_y^2 + (-omega1^2*omega2^2 +
/// omega2^4)/(Omega*(omega1 + Omega)*(omega1 - Omega)*(2*omega2 + Omega))*harmonic_re_y_conjA_y_F*A_y*F +
/// harmonic_re_y_A_x2_A_y*A_x^2*A_y + harmonic_re_y_A_x2_A_y*A_x^2*A_y + i*harmonic_im_y_A_y2*A_y^2 +
/// harmonic_re_y_A_y_F*A_y*F
struct harmonic_omega2_plus_Omega_of_y : BlockShape<5, 3, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 3> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number omega2_2 = omega2 * omega2;
    const Number omega2_3 = omega2_2 * omega2;
    const Number omega2_4 = omega2_3 * omega2;
    const Number per_0 = 1.0 / (omega1 + Omega);
    const Number per_1 = 1.0 / (omega1 - Omega);
    const Number per_2 = 1.0 / (2.0 * omega2 + Omega);
    const Number over_0 = per_0 * per_1 * per_2;
    return {1.0 / (3.0 * omega2_2), (-omega1_2 * omega2_2 + omega2_4) * over_0 / Omega, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = factor[0] * (A_y * A_y);  // a4
    column[1] = factor[1] * (A_y * F);  // harmonic_re_y_conjA_y_F
    column[2] = factor[2] * (A_x * A_x * A_y) + factor[2] * (A_x * A_x * A_y);  // harmonic_re_y_A_x2_A_y
    column[3] = times_i(factor[2] * (A_y * A_y));  // harmonic_im_y_A_y2
    column[4] = factor[2] * (A_y * F);  // harmonic_re_y_A_y_F
  }
};

/// amplitude of exp(i*(omega1 + Omega)*t) in y = 2/(omega1*(omega1 + 2*omega2))*a3*A_x*A_y + (-omega1^4 +
/// omega1^2*omega2^2)/((omega1 + omega2 + Omega)*(omega1 - omega2 + Omega)*(omega1 + Omega)*(omega1 -
/// Omega))*harmonic_re_x_conjA_y_F*A_x*F + (omega1^3 - 3*omega1^2*omega2 +
/// 4*omega2^3)/(2*omega1^2*omega2)*harmonic_re_x_A_x2_A_y*A_x^3 + (omega1^3 - 3*omega1^2*omega2 +
/// 4*omega2^3)/omega1^3*harmonic_re_x_A_x2_A_y*conj(A_x)*A_y^2 + (omega1^3 - 3*omega1^2*omega2 +
/// 4*omega2^3)/(2*omega1^2*omega2)*harmonic_re_x_A_y_F*A_x*F + (-omega1^3 + 3*omega1^2*omega2 -
/// 4*omega2^3)/((omega1 + 2*omega2)^2*(omega1 - omega2))*i*harmonic_im_y_A_y_conjA_x*A_x*A_y +
/// harmonic_re_y_A_y2_conjA_x*conj(A_x)*A_y^2 + harmonic_re_y_A_x3*A_x^3
struct harmonic_omega1_plus_Omega_of_y : BlockShape<7, 6, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 6> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number omega1_3 = omega1_2 * omega1;
    const Number omega1_4 = omega1_3 * omega1;
    const Number omega2_2 = omega2 * omega2;
    const Number omega2_3 = omega2_2 * omega2;
    const Number per_0 = 1.0 / (omega1 + 2.0 * omega2);
    const Number per_0_2 = per_0 * per_0;
    const Number per_1 = 1.0 / (omega1 + omega2 + Omega);
    const Number per_2 = 1.0 / (omega1 - omega2 + Omega);
    const Number per_3 = 1.0 / (omega1 + Omega);
    const Number per_4 = 1.0 / (omega1 - Omega);
    const Number per_5 = 1.0 / (omega1 - omega2);
    const Number over_0 = per_1 * per_2 * per_3 * per_4;
    const Number over_1 = per_0_2 * per_5;
    return {2.0 * per_0 / omega1, (-omega1_4 + omega1_2 * omega2_2) * over_0,
        (omega1_3 - 3.0 * omega1_2 * omega2 + 4.0 * omega2_3) / (2.0 * omega1_2 * omega2),
        (omega1_3 - 3.0 * omega1_2 * omega2 + 4.0 * omega2_3) / omega1_3,
        (-omega1_3 + 3.0 * omega1_2 * omega2 - 4.0 * omega2_3) * over_1, 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = factor[0] * (A_x * A_y);  // a3
    column[1] = factor[1] * (A_x * F);  // harmonic_re_x_conjA_y_F
    column[2] = factor[2] * (A_x * A_x * A_x) + factor[3] * (conj_A_x * A_y * A_y);  // harmonic_re_x_A_x2_A_y
    column[3] = factor[2] * (A_x * F);  // harmonic_re_x_A_y_F
    column[4] = times_i(factor[4] * (A_x * A_y));  // harmonic_im_y_A_y_conjA_x
    column[5] = factor[5] * (conj_A_x * A_y * A_y);  // harmonic_re_y_A_y2_conjA_x
    column[6] = factor[5] * (A_x * A_x * A_x);  // harmonic_re_y_A_x3
  }
};

/// amplitude of exp(i*(3*omega2)*t) in y = harmonic_re_y_A_y3*A_y^3
struct harmonic_3_omega2_of_y : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = factor[0] * (A_y * A_y * A_y);  // harmonic_re_y_A_y3
  }
};

/// amplitude of exp(i*(omega1 + 2*omega2)*t) in y = harmonic_re_y_A_x_A_y2*A_x*A_y^2
struct harmonic_omega1_plus_2_omega2_of_y : BlockShape<1, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = factor[0] * (A_x * A_y * A_y);  // harmonic_re_y_A_x_A_y2
  }
};

inline constexpr BlockFunctions blocks[14] = {modulation_functions<Model, modulation_of_x>(),
    modulation_functions<Model, modulation_of_y>(), harmonic_functions<Model, harmonic_0_of_x>(),
    harmonic_functions<Model, harmonic_Omega_of_x>(),
    harmonic_functions<Model, harmonic_omega2_plus_Omega_of_x>(),
    harmonic_functions<Model, harmonic_omega1_plus_Omega_of_x>(),
    harmonic_functions<Model, harmonic_3_omega2_of_x>(),
    harmonic_functions<Model, harmonic_omega1_plus_2_omega2_of_x>(),
    harmonic_functions<Model, harmonic_omega1_of_y>(), harmonic_functions<Model, harmonic_0_of_y>(),
    harmonic_functions<Model, harmonic_omega2_plus_Omega_of_y>(),
    harmonic_functions<Model, harmonic_omega1_plus_Omega_of_y>(),
    harmonic_functions<Model, harmonic_3_omega2_of_y>(),
    harmonic_functions<Model, harmonic_omega1_plus_2_omega2_of_y>()};

}  // namespace one_to_two
}  // namespace secular::generated::internal_resonance
