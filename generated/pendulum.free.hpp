// Model pendulum: generated code, never edited by hand.
// Holds rows of the case free. Made by: secular generate pendulum.
// free vibration, multiple scales to eps^2. Valid near that resonance for small amplitudes; what is left out is
// of order eps^3.
#pragma once

#include "pendulum.hpp"

namespace secular::generated::pendulum {

namespace free {

/// (rate - i*omega0)*A_theta = -1/(omega0*Pi)*fc*A_theta*abs(A_theta)^-1 - mu1*A_theta -
/// 8*omega0/(3*Pi)*mu2*A_theta*abs(A_theta) + 3/(2*omega0)*i*alpha3*A_theta^2*conj(A_theta) +
/// 5/omega0*i*beta5*A_theta^3*conj(A_theta)^2
struct modulation_of_theta : BlockShape<5, 5, follows_modes> {
  template <class Number>
  static NumberList<Number, 5> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0] = frequencies;
    const double pi = std::numbers::pi;
    return {-1.0 / (omega0 * pi), -1.0, -8.0 * omega0 / (3.0 * pi), 3.0 / (2.0 * omega0), 5.0 / omega0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_theta, norm_A_theta, abs_A_theta, inverse_abs_A_theta, unit_A_theta] = signals;
    column[0] = factor[0] * unit_A_theta;  // fc
    column[1] = factor[1] * A_theta;  // mu1
    column[2] = factor[2] * (abs_A_theta * A_theta);  // mu2
    column[3] = times_i(factor[3] * (norm_A_theta * A_theta));  // alpha3
    column[4] = times_i(factor[4] * (norm_A_theta * norm_A_theta * A_theta));  // beta5
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_theta, norm_A_theta, abs_A_theta, inverse_abs_A_theta, unit_A_theta] = signals;
    by[0] = ComplexNumber<double>(0.5 * lump[0] * factor[0] * inverse_abs_A_theta + lump[1] * factor[1]
        + 1.5 * lump[2] * factor[2] * abs_A_theta, 2.0 * lump[3] * factor[3] * norm_A_theta
        + 3.0 * lump[4] * factor[4] * (norm_A_theta * norm_A_theta));
    by_conjugate[0] = -0.5 * lump[0] * factor[0] * (inverse_abs_A_theta * unit_A_theta * unit_A_theta)
        + 0.5 * lump[2] * factor[2] * (unit_A_theta * A_theta) + times_i(lump[3] * factor[3] * (A_theta * A_theta)
        + 2.0 * lump[4] * factor[4] * (norm_A_theta * A_theta * A_theta));
  }
};

/// amplitude of exp(i*(3*omega0)*t) in theta = 1/(12*omega0^2*Pi)*i*fc*A_theta^3*abs(A_theta)^-3 -
/// 2/(15*Pi)*i*mu2*A_theta^3*abs(A_theta)^-1 + 1/(8*omega0^2)*alpha3*A_theta^3 +
/// harmonic_re_theta_A_theta4_conjA_theta*A_theta^4*conj(A_theta)
struct harmonic_3_omega0_of_theta : BlockShape<4, 4, follows_modes> {
  template <class Number>
  static NumberList<Number, 4> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0] = frequencies;
    const double pi = std::numbers::pi;
    const Number omega0_2 = omega0 * omega0;
    return {1.0 / (12.0 * omega0_2 * pi), -2.0 / (15.0 * pi), 1.0 / (8.0 * omega0_2), 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_theta, norm_A_theta, abs_A_theta, inverse_abs_A_theta, unit_A_theta] = signals;
    column[0] = times_i(factor[0] * (unit_A_theta * unit_A_theta * unit_A_theta));  // fc
    column[1] = times_i(factor[1] * (unit_A_theta * A_theta * A_theta));  // mu2
    column[2] = factor[2] * (A_theta * A_theta * A_theta);  // alpha3
    // harmonic_re_theta_A_theta4_conjA_theta
    column[3] = factor[3] * (norm_A_theta * A_theta * A_theta * A_theta);
  }
};

/// amplitude of exp(i*(5*omega0)*t) in theta = 1/(60*omega0^2*Pi)*i*fc*A_theta^5*abs(A_theta)^-5 -
/// 2/(315*Pi)*i*mu2*A_theta^5*abs(A_theta)^-3 + harmonic_re_theta_A_theta5*A_theta^5
struct harmonic_5_omega0_of_theta : BlockShape<3, 3, follows_modes> {
  template <class Number>
  static NumberList<Number, 3> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0] = frequencies;
    const double pi = std::numbers::pi;
    const Number omega0_2 = omega0 * omega0;
    return {1.0 / (60.0 * omega0_2 * pi), -2.0 / (315.0 * pi), 1.0};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_theta, norm_A_theta, abs_A_theta, inverse_abs_A_theta, unit_A_theta] = signals;
    column[0] = times_i(factor[0] * fixed_power<5>(unit_A_theta));  // fc
    column[1] = times_i(factor[1] * (unit_A_theta * unit_A_theta * unit_A_theta * A_theta * A_theta));  // mu2
    column[2] = factor[2] * fixed_power<5>(A_theta);  // harmonic_re_theta_A_theta5
  }
};

/// amplitude of exp(i*(7*omega0)*t) in theta = 1/(168*omega0^2*Pi)*i*fc*A_theta^7*abs(A_theta)^-7 -
/// 1/(945*Pi)*i*mu2*A_theta^7*abs(A_theta)^-5
struct harmonic_7_omega0_of_theta : BlockShape<2, 2, follows_modes> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0] = frequencies;
    const double pi = std::numbers::pi;
    const Number omega0_2 = omega0 * omega0;
    return {1.0 / (168.0 * omega0_2 * pi), -1.0 / (945.0 * pi)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_theta, norm_A_theta, abs_A_theta, inverse_abs_A_theta, unit_A_theta] = signals;
    column[0] = times_i(factor[0] * fixed_power<7>(unit_A_theta));  // fc
    column[1] = times_i(factor[1] * (fixed_power<5>(unit_A_theta) * A_theta * A_theta));  // mu2
  }
};

/// amplitude of exp(i*(9*omega0)*t) in theta = 1/(360*omega0^2*Pi)*i*fc*A_theta^9*abs(A_theta)^-9 -
/// 1/(3465*Pi)*i*mu2*A_theta^9*abs(A_theta)^-7
struct harmonic_9_omega0_of_theta : BlockShape<2, 2, follows_modes> {
  template <class Number>
  static NumberList<Number, 2> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0] = frequencies;
    const double pi = std::numbers::pi;
    const Number omega0_2 = omega0 * omega0;
    return {1.0 / (360.0 * omega0_2 * pi), -1.0 / (3465.0 * pi)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_theta, norm_A_theta, abs_A_theta, inverse_abs_A_theta, unit_A_theta] = signals;
    column[0] = times_i(factor[0] * fixed_power<9>(unit_A_theta));  // fc
    column[1] = times_i(factor[1] * (fixed_power<7>(unit_A_theta) * A_theta * A_theta));  // mu2
  }
};

inline constexpr BlockFunctions blocks[5] = {modulation_functions<Model, modulation_of_theta>(),
    harmonic_functions<Model, harmonic_3_omega0_of_theta>(),
    harmonic_functions<Model, harmonic_5_omega0_of_theta>(),
    harmonic_functions<Model, harmonic_7_omega0_of_theta>(),
    harmonic_functions<Model, harmonic_9_omega0_of_theta>()};

}  // namespace free
}  // namespace secular::generated::pendulum
