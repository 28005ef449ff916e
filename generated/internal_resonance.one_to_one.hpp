// Model internal_resonance: generated code, never edited by hand.
// Holds rows of the case one_to_one. Made by: secular generate internal_resonance.
// omega2 = omega1 + eps^2*sigma1; Omega = omega1 + eps^2*sigma2, multiple scales to eps^2. Valid near that
// resonance for small amplitudes; what is left out is of order eps^3.
#pragma once

#include "internal_resonance.hpp"

namespace secular::generated::internal_resonance {

namespace one_to_one {

/// (rate - i*omega1)*A_x = i*conservative_x_A_x2_conjA_y*A_x^2*conj(A_y) - mu1*A_x +
/// i*conservative_x_A_x_A_y_conjA_y*A_x*A_y*conj(A_y) + i*conservative_x_A_x2_conjA_x*A_x^2*conj(A_x) -
/// 1/(4*omega1)*i*e1*F + i*conservative_x_A_y2_conjA_y*A_y^2*conj(A_y) +
/// i*conservative_x_A_x_A_y_conjA_x*A_x*conj(A_x)*A_y + i*conservative_x_A_y2_conjA_x*conj(A_x)*A_y^2
struct modulation_of_x : BlockShape<8, 3, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 3> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    return {1.0, -1.0, -1.0 / (4.0 * omega1)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = times_i(factor[0] * (A_x * A_x * conj_A_y));  // conservative_x_A_x2_conjA_y
    column[1] = factor[1] * A_x;  // mu1
    column[2] = times_i(factor[0] * (A_x * norm_A_y));  // conservative_x_A_x_A_y_conjA_y
    column[3] = times_i(factor[0] * (norm_A_x * A_x));  // conservative_x_A_x2_conjA_x
    column[4] = times_i(factor[2] * F);  // e1
    column[5] = times_i(factor[0] * (norm_A_y * A_y));  // conservative_x_A_y2_conjA_y
    column[6] = times_i(factor[0] * (norm_A_x * A_y));  // conservative_x_A_x_A_y_conjA_x
    column[7] = times_i(factor[0] * (conj_A_x * A_y * A_y));  // conservative_x_A_y2_conjA_x
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    by[0] = ComplexNumber<double>(lump[1] * factor[1], lump[2] * factor[0] * norm_A_y
        + 2.0 * lump[3] * factor[0] * norm_A_x) + times_i(2.0 * lump[0] * factor[0] * (A_x * conj_A_y)
        + lump[6] * factor[0] * (conj_A_x * A_y));
    by_conjugate[0] = times_i(lump[3] * factor[0] * (A_x * A_x) + lump[6] * factor[0] * (A_x * A_y)
        + lump[7] * factor[0] * (A_y * A_y));
    by[1] = ComplexNumber<double>(0.0, 2.0 * lump[5] * factor[0] * norm_A_y + lump[6] * factor[0] * norm_A_x)
        + times_i(lump[2] * factor[0] * (A_x * conj_A_y) + 2.0 * lump[7] * factor[0] * (conj_A_x * A_y));
    by_conjugate[1] = times_i(lump[0] * factor[0] * (A_x * A_x) + lump[2] * factor[0] * (A_x * A_y)
        + lump[5] * factor[0] * (A_y * A_y));
  }
};

/// (rate - i*omega2)*A_y = omega1/omega2*i*conservative_x_A_x_A_y_conjA_y*A_x*conj(A_x)*A_y +
/// i*conservative_y_A_x2_conjA_y*A_x^2*conj(A_y) + i*conservative_y_A_x_A_y_conjA_y*A_x*A_y*conj(A_y) +
/// i*conservative_y_A_x2_conjA_x*A_x^2*conj(A_x) - 1/(4*omega2)*i*e2*F - mu2*A_y +
/// i*conservative_y_A_y2_conjA_y*A_y^2*conj(A_y) + i*conservative_y_A_y2_conjA_x*conj(A_x)*A_y^2
struct modulation_of_y : BlockShape<8, 4, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 4> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    return {omega1 / omega2, 1.0, -1.0 / (4.0 * omega2), -1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = times_i(factor[0] * (norm_A_x * A_y));  // conservative_x_A_x_A_y_conjA_y
    column[1] = times_i(factor[1] * (A_x * A_x * conj_A_y));  // conservative_y_A_x2_conjA_y
    column[2] = times_i(factor[1] * (A_x * norm_A_y));  // conservative_y_A_x_A_y_conjA_y
    column[3] = times_i(factor[1] * (norm_A_x * A_x));  // conservative_y_A_x2_conjA_x
    column[4] = times_i(factor[2] * F);  // e2
    column[5] = factor[3] * A_y;  // mu2
    column[6] = times_i(factor[1] * (norm_A_y * A_y));  // conservative_y_A_y2_conjA_y
    column[7] = times_i(factor[1] * (conj_A_x * A_y * A_y));  // conservative_y_A_y2_conjA_x
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    by[0] = ComplexNumber<double>(0.0, lump[2] * factor[1] * norm_A_y + 2.0 * lump[3] * factor[1] * norm_A_x)
        + times_i(lump[0] * factor[0] * (conj_A_x * A_y) + 2.0 * lump[1] * factor[1] * (A_x * conj_A_y));
    by_conjugate[0] = times_i(lump[0] * factor[0] * (A_x * A_y) + lump[3] * factor[1] * (A_x * A_x)
        + lump[7] * factor[1] * (A_y * A_y));
    by[1] = ComplexNumber<double>(lump[5] * factor[3], lump[0] * factor[0] * norm_A_x
        + 2.0 * lump[6] * factor[1] * norm_A_y) + times_i(lump[2] * factor[1] * (A_x * conj_A_y)
        + 2.0 * lump[7] * factor[1] * (conj_A_x * A_y));
    by_conjugate[1] = times_i(lump[1] * factor[1] * (A_x * A_x) + lump[2] * factor[1] * (A_x * A_y)
        + lump[6] * factor[1] * (A_y * A_y));
  }
};

/// amplitude of exp(i*(0)*t) in x = -2/(omega2*(2*omega1 - omega2))*a2*conj(A_x)*A_y - 2/(omega2*(2*omega1 -
/// omega2))*a2*A_x*conj(A_y) - 2/omega1^2*a3*A_y*conj(A_y) - 2/omega1^2*a1*A_x*conj(A_x)
struct harmonic_0_of_x : BlockShape<3, 2, follows_modes> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number per_0 = 1.0 / (2.0 * omega1 - omega2);
    return {-2.0 * per_0 / omega2, -2.0 / omega1_2};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = factor[0] * (conj_A_x * A_y) + factor[0] * (A_x * conj_A_y);  // a2
    column[1] = ComplexNumber<Number>(factor[1] * norm_A_y);  // a3
    column[2] = ComplexNumber<Number>(factor[1] * norm_A_x);  // a1
  }
};

/// amplitude of exp(i*(2*omega2)*t) in x = 2/(omega2*(2*omega1 + omega2))*a2*A_x*A_y - 1/((omega1 +
/// 2*omega2)*(omega1 - 2*omega2))*a3*A_y^2 + 1/(3*omega1^2)*a1*A_x^2
struct harmonic_2_omega2_of_x : BlockShape<3, 3, follows_modes> {
  template <class Number>
  static NumberList<Number, 3> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number per_0 = 1.0 / (2.0 * omega1 + omega2);
    const Number per_1 = 1.0 / (omega1 + 2.0 * omega2);
    const Number per_2 = 1.0 / (omega1 - 2.0 * omega2);
    const Number over_0 = per_1 * per_2;
    return {2.0 * per_0 / omega2, -over_0, 1.0 / (3.0 * omega1_2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = factor[0] * (A_x * A_y);  // a2
    column[1] = factor[1] * (A_y * A_y);  // a3
    column[2] = factor[2] * (A_x * A_x);  // a1
  }
};

/// amplitude of exp(i*(3*omega2)*t) in x = harmonic_re_x_A_y3*A_y^3 + harmonic_re_x_A_x_A_y2*A_x*A_y^2 +
/// harmonic_re_x_A_x2_A_y*A_x^2*A_y + harmonic_re_x_A_x3*A_x^3
struct harmonic_3_omega2_of_x : BlockShape<4, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = factor[0] * (A_y * A_y * A_y);  // harmonic_re_x_A_y3
    column[1] = factor[0] * (A_x * A_y * A_y);  // harmonic_re_x_A_x_A_y2
    column[2] = factor[0] * (A_x * A_x * A_y);  // harmonic_re_x_A_x2_A_y
    column[3] = factor[0] * (A_x * A_x * A_x);  // harmonic_re_x_A_x3
  }
};

/// amplitude of exp(i*(0)*t) in y = -2/omega2^2*a2*A_x*conj(A_x) + 2/(omega1*(omega1 -
/// 2*omega2))*a3*conj(A_x)*A_y + 2/(omega1*(omega1 - 2*omega2))*a3*A_x*conj(A_y) - 2/omega2^2*a4*A_y*conj(A_y)
struct harmonic_0_of_y : BlockShape<3, 2, follows_modes> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega2_2 = omega2 * omega2;
    const Number per_0 = 1.0 / (omega1 - 2.0 * omega2);
    return {-2.0 / omega2_2, 2.0 * per_0 / omega1};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = ComplexNumber<Number>(factor[0] * norm_A_x);  // a2
    column[1] = factor[1] * (conj_A_x * A_y) + factor[1] * (A_x * conj_A_y);  // a3
    column[2] = ComplexNumber<Number>(factor[0] * norm_A_y);  // a4
  }
};

/// amplitude of exp(i*(2*omega2)*t) in y = 1/((2*omega1 + omega2)*(2*omega1 - omega2))*a2*A_x^2 +
/// 2/(omega1*(omega1 + 2*omega2))*a3*A_x*A_y + 1/(3*omega2^2)*a4*A_y^2
struct harmonic_2_omega2_of_y : BlockShape<3, 3, follows_modes> {
  template <class Number>
  static NumberList<Number, 3> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega2_2 = omega2 * omega2;
    const Number per_0 = 1.0 / (2.0 * omega1 + omega2);
    const Number per_1 = 1.0 / (2.0 * omega1 - omega2);
    const Number per_2 = 1.0 / (omega1 + 2.0 * omega2);
    const Number over_0 = per_0 * per_1;
    return {over_0, 2.0 * per_2 / omega1, 1.0 / (3.0 * omega2_2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = factor[0] * (A_x * A_x);  // a2
    column[1] = factor[1] * (A_x * A_y);  // a3
    column[2] = factor[2] * (A_y * A_y);  // a4
  }
};

/// amplitude of exp(i*(3*omega2)*t) in y = harmonic_re_y_A_y3*A_y^3 + harmonic_re_y_A_x_A_y2*A_x*A_y^2 +
/// harmonic_re_y_A_x2_A_y*A_x^2*A_y + harmonic_re_y_A_x3*A_x^3
struct harmonic_3_omega2_of_y : BlockShape<4, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = factor[0] * (A_y * A_y * A_y);  // harmonic_re_y_A_y3
    column[1] = factor[0] * (A_x * A_y * A_y);  // harmonic_re_y_A_x_A_y2
    column[2] = factor[0] * (A_x * A_x * A_y);  // harmonic_re_y_A_x2_A_y
    column[3] = factor[0] * (A_x * A_x * A_x);  // harmonic_re_y_A_x3
  }
};

inline constexpr BlockFunctions blocks[8] = {modulation_functions<Model, modulation_of_x>(),
    modulation_functions<Model, modulation_of_y>(), harmonic_functions<Model, harmonic_0_of_x>(),
    harmonic_functions<Model, harmonic_2_omega2_of_x>(), harmonic_functions<Model, harmonic_3_omega2_of_x>(),
    harmonic_functions<Model, harmonic_0_of_y>(), harmonic_functions<Model, harmonic_2_omega2_of_y>(),
    harmonic_functions<Model, harmonic_3_omega2_of_y>()};

}  // namespace one_to_one
}  // namespace secular::generated::internal_resonance
