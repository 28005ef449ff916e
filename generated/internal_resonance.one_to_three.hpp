// Model internal_resonance: generated code, never edited by hand.
// Holds rows of the case one_to_three. Made by: secular generate internal_resonance.
// omega2 = 3*omega1 + eps^2*sigma1; Omega = omega1 + eps^2*sigma2, multiple scales to eps^2. Valid near that
// resonance for small amplitudes; what is left out is of order eps^3.
#pragma once

#include "internal_resonance.one_to_two.hpp"
#include "internal_resonance.hpp"

namespace secular::generated::internal_resonance {

namespace one_to_three {

/// (rate - i*omega1)*A_x = -mu1*A_x + i*conservative_x_A_x_A_y_conjA_y*A_x*A_y*conj(A_y) +
/// i*conservative_x_A_x2_conjA_x*A_x^2*conj(A_x) - 1/(4*omega1)*i*e1*F +
/// i*conservative_x_A_y_conjA_x2*conj(A_x)^2*A_y
struct modulation_of_x : BlockShape<5, 3, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 3> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    return {-1.0, 1.0, -1.0 / (4.0 * omega1)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = factor[0] * A_x;  // mu1
    column[1] = times_i(factor[1] * (A_x * norm_A_y));  // conservative_x_A_x_A_y_conjA_y
    column[2] = times_i(factor[1] * (norm_A_x * A_x));  // conservative_x_A_x2_conjA_x
    column[3] = times_i(factor[2] * F);  // e1
    column[4] = times_i(factor[1] * (conj_A_x * conj_A_x * A_y));  // conservative_x_A_y_conjA_x2
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    by[0] = ComplexNumber<double>(lump[0] * factor[0], lump[1] * factor[1] * norm_A_y
        + 2.0 * lump[2] * factor[1] * norm_A_x);
    by_conjugate[0] = times_i(lump[2] * factor[1] * (A_x * A_x) + 2.0 * lump[4] * factor[1] * (conj_A_x * A_y));
    by[1] = times_i(lump[1] * factor[1] * (A_x * conj_A_y) + lump[4] * factor[1] * (conj_A_x * conj_A_x));
    by_conjugate[1] = times_i(lump[1] * factor[1] * (A_x * A_y));
  }
};

/// (rate - i*omega2)*A_y = omega1/omega2*i*conservative_x_A_x_A_y_conjA_y*A_x*conj(A_x)*A_y +
/// i*conservative_y_A_x3*A_x^3 - mu2*A_y + i*conservative_y_A_y2_conjA_y*A_y^2*conj(A_y)
struct modulation_of_y : BlockShape<4, 3, follows_modes> {
  template <class Number>
  static NumberList<Number, 3> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    return {omega1 / omega2, 1.0, -1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = times_i(factor[0] * (norm_A_x * A_y));  // conservative_x_A_x_A_y_conjA_y
    column[1] = times_i(factor[1] * (A_x * A_x * A_x));  // conservative_y_A_x3
    column[2] = factor[2] * A_y;  // mu2
    column[3] = times_i(factor[1] * (norm_A_y * A_y));  // conservative_y_A_y2_conjA_y
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    by[0] = times_i(lump[0] * factor[0] * (conj_A_x * A_y) + 3.0 * lump[1] * factor[1] * (A_x * A_x));
    by_conjugate[0] = times_i(lump[0] * factor[0] * (A_x * A_y));
    by[1] = ComplexNumber<double>(lump[2] * factor[2], lump[0] * factor[0] * norm_A_x
        + 2.0 * lump[3] * factor[1] * norm_A_y);
    by_conjugate[1] = times_i(lump[3] * factor[1] * (A_y * A_y));
  }
};

/// amplitude of exp(i*(-omega1 + omega2)*t) in x = -2/(omega2*(2*omega1 - omega2))*a2*conj(A_x)*A_y +
/// 1/(3*omega1^2)*a1*A_x^2
struct harmonic_minus_omega1_plus_omega2_of_x : BlockShape<2, 2, follows_modes> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    const Number per_0 = 1.0 / (2.0 * omega1 - omega2);
    return {-2.0 * per_0 / omega2, 1.0 / (3.0 * omega1_2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = factor[0] * (conj_A_x * A_y);  // a2
    column[1] = factor[1] * (A_x * A_x);  // a1
  }
};

/// amplitude of exp(i*(0)*t) in x = -2/omega1^2*a1*A_x*conj(A_x) - 2/omega1^2*a3*A_y*conj(A_y)
struct harmonic_0_of_x : BlockShape<2, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega1_2 = omega1 * omega1;
    return {-2.0 / omega1_2};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = ComplexNumber<Number>(factor[0] * norm_A_x);  // a1
    column[1] = ComplexNumber<Number>(factor[0] * norm_A_y);  // a3
  }
};

/// amplitude of exp(i*(2*omega2)*t) in x = -1/((omega1 + 2*omega2)*(omega1 - 2*omega2))*a3*A_y^2
struct harmonic_2_omega2_of_x : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 + 2.0 * omega2);
    const Number per_1 = 1.0 / (omega1 - 2.0 * omega2);
    const Number over_0 = per_0 * per_1;
    return {-over_0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = factor[0] * (A_y * A_y);  // a3
  }
};

/// amplitude of exp(i*(omega1 + omega2)*t) in x = 2/(omega2*(2*omega1 + omega2))*a2*A_x*A_y
struct harmonic_omega1_plus_omega2_of_x : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number per_0 = 1.0 / (2.0 * omega1 + omega2);
    return {2.0 * per_0 / omega2};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = factor[0] * (A_x * A_y);  // a2
  }
};

/// amplitude of exp(i*(-omega1 + 2*omega2)*t) in x = harmonic_re_x_A_y2_conjA_x*conj(A_x)*A_y^2 +
/// harmonic_re_x_A_x2_A_y*A_x^2*A_y
struct harmonic_minus_omega1_plus_2_omega2_of_x : BlockShape<2, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = factor[0] * (conj_A_x * A_y * A_y);  // harmonic_re_x_A_y2_conjA_x
    column[1] = factor[0] * (A_x * A_x * A_y);  // harmonic_re_x_A_x2_A_y
  }
};

/// amplitude of exp(i*(omega2)*t) in x = harmonic_re_x_A_y2_conjA_y*A_y^2*conj(A_y) +
/// harmonic_re_x_A_x_A_y_conjA_x*A_x*conj(A_x)*A_y + harmonic_re_x_A_x3*A_x^3
struct harmonic_omega2_of_x : BlockShape<3, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = factor[0] * (norm_A_y * A_y);  // harmonic_re_x_A_y2_conjA_y
    column[1] = factor[0] * (norm_A_x * A_y);  // harmonic_re_x_A_x_A_y_conjA_x
    column[2] = factor[0] * (A_x * A_x * A_x);  // harmonic_re_x_A_x3
  }
};

/// amplitude of exp(i*(-omega1 + omega2)*t) in y = 1/((2*omega1 + omega2)*(2*omega1 - omega2))*a2*A_x^2 +
/// 2/(omega1*(omega1 - 2*omega2))*a3*conj(A_x)*A_y
struct harmonic_minus_omega1_plus_omega2_of_y : BlockShape<2, 2, follows_modes> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number per_0 = 1.0 / (2.0 * omega1 + omega2);
    const Number per_1 = 1.0 / (2.0 * omega1 - omega2);
    const Number per_2 = 1.0 / (omega1 - 2.0 * omega2);
    const Number over_0 = per_0 * per_1;
    return {over_0, 2.0 * per_2 / omega1};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = factor[0] * (A_x * A_x);  // a2
    column[1] = factor[1] * (conj_A_x * A_y);  // a3
  }
};

/// amplitude of exp(i*(0)*t) in y = -2/omega2^2*a2*A_x*conj(A_x) - 2/omega2^2*a4*A_y*conj(A_y)
struct harmonic_0_of_y : BlockShape<2, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega2_2 = omega2 * omega2;
    return {-2.0 / omega2_2};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = ComplexNumber<Number>(factor[0] * norm_A_x);  // a2
    column[1] = ComplexNumber<Number>(factor[0] * norm_A_y);  // a4
  }
};

/// amplitude of exp(i*(2*omega2)*t) in y = 1/(3*omega2^2)*a4*A_y^2
struct harmonic_2_omega2_of_y : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number omega2_2 = omega2 * omega2;
    return {1.0 / (3.0 * omega2_2)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = factor[0] * (A_y * A_y);  // a4
  }
};

/// amplitude of exp(i*(omega1 + omega2)*t) in y = 2/(omega1*(omega1 + 2*omega2))*a3*A_x*A_y
struct harmonic_omega1_plus_omega2_of_y : BlockShape<1, 1, follows_modes> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega1 + 2.0 * omega2);
    return {2.0 * per_0 / omega1};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = factor[0] * (A_x * A_y);  // a3
  }
};

/// amplitude of exp(i*(Omega)*t) in y = harmonic_re_y_A_y_conjA_x2*conj(A_x)^2*A_y + 1/(2*(omega2 +
/// Omega)*(omega2 - Omega))*e2*F + harmonic_re_y_A_x_A_y_conjA_y*A_x*A_y*conj(A_y) +
/// harmonic_re_y_A_x2_conjA_x*A_x^2*conj(A_x)
struct harmonic_Omega_of_y : BlockShape<4, 2, follows_modes | follows_excitation | is_forced> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega1, omega2, Omega] = frequencies;
    const Number per_0 = 1.0 / (omega2 + Omega);
    const Number per_1 = 1.0 / (omega2 - Omega);
    const Number over_0 = per_0 * per_1;
    return {1.0, over_0 / 2.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = factor[0] * (conj_A_x * conj_A_x * A_y);  // harmonic_re_y_A_y_conjA_x2
    column[1] = factor[1] * F;  // e2
    column[2] = factor[0] * (A_x * norm_A_y);  // harmonic_re_y_A_x_A_y_conjA_y
    column[3] = factor[0] * (norm_A_x * A_x);  // harmonic_re_y_A_x2_conjA_x
  }
};

/// amplitude of exp(i*(-omega1 + 2*omega2)*t) in y = harmonic_re_y_A_y2_conjA_x*conj(A_x)*A_y^2 +
/// harmonic_re_y_A_x2_A_y*A_x^2*A_y
struct harmonic_minus_omega1_plus_2_omega2_of_y : BlockShape<2, 1, 0> {
  template <class Number>
  static NumberList<Number, 1> factors(const Model::Frequencies<Number>&) {
    return {1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, A_y, conj_A_y, norm_A_y, F, conj_F] = signals;
    column[0] = factor[0] * (conj_A_x * A_y * A_y);  // harmonic_re_y_A_y2_conjA_x
    column[1] = factor[0] * (A_x * A_x * A_y);  // harmonic_re_y_A_x2_A_y
  }
};

inline constexpr BlockFunctions blocks[18] = {modulation_functions<Model, modulation_of_x>(),
    modulation_functions<Model, modulation_of_y>(),
    harmonic_functions<Model, harmonic_minus_omega1_plus_omega2_of_x>(),
    harmonic_functions<Model, harmonic_0_of_x>(), harmonic_functions<Model, harmonic_2_omega2_of_x>(),
    harmonic_functions<Model, harmonic_omega1_plus_omega2_of_x>(),
    harmonic_functions<Model, harmonic_minus_omega1_plus_2_omega2_of_x>(),
    harmonic_functions<Model, harmonic_omega2_of_x>(),
    harmonic_functions<Model, one_to_two::harmonic_3_omega2_of_x>(),
    harmonic_functions<Model, one_to_two::harmonic_omega1_plus_2_omega2_of_x>(),
    harmonic_functions<Model, harmonic_minus_omega1_plus_omega2_of_y>(),
    harmonic_functions<Model, harmonic_0_of_y>(), harmonic_functions<Model, harmonic_2_omega2_of_y>(),
    harmonic_functions<Model, harmonic_omega1_plus_omega2_of_y>(),
    harmonic_functions<Model, harmonic_Omega_of_y>(),
    harmonic_functions<Model, harmonic_minus_omega1_plus_2_omega2_of_y>(),
    harmonic_functions<Model, one_to_two::harmonic_3_omega2_of_y>(),
    harmonic_functions<Model, one_to_two::harmonic_omega1_plus_2_omega2_of_y>()};

}  // namespace one_to_three
}  // namespace secular::generated::internal_resonance
