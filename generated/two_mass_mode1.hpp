// Model two_mass_mode1: generated code, never edited by hand.
// Holds equations of motion, lumps, what rows are made of. Made by: secular generate two_mass_mode1.
// Source: S. O'F. Fahey, dissertation, Virginia Tech, 2000, Eqs. (5.1)-(5.5)
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// two_mass_mode1.principal_parametric.hpp: Omega = 2*omega0 + eps^2*sigma
// two_mass_mode1.free.hpp: free vibration
// two_mass_mode1.primary.hpp: Omega = omega0 + eps^2*sigma
#pragma once

#include <cstddef>
#include <numbers>

#include "estimator/model/block_functions.hpp"
#include "estimator/model/dense_solve.hpp"
#include "estimator/model/excitation_sample.hpp"
#include "estimator/model/integer_power.hpp"
#include "estimator/model/lane_functions.hpp"
#include "estimator/model/lump_functions.hpp"
#include "estimator/model/scalar_functions.hpp"

namespace secular::generated::two_mass_mode1 {

/// Mass matrix M of the equations of motion M*acceleration + force = 0 below, state-dependent: mass[k * 1 + j]
/// multiplies the acceleration of mode j in equation k.
template <class Scalar, class Parameter, class Sample>
void mass_matrix([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* mass) {
  const Scalar delta2 = parameters[6];
  const Scalar delta3 = parameters[7];
  mass[0] = 2.0 * delta2 * displacement[0] + delta3 * displacement[0] * displacement[0] + 1.0;
}

/// Accelerations of the full equations of motion, solved from the state-dependent mass matrix.
/// 0 = omega0^2*v + delta3*v*D(v)^2 + 2*delta2*v*D2(v) - eta2*v*F*cos(Omega*t) + alpha2*v^2 + delta3*v^2*D2(v) +
/// alpha3*v^3 + 2*mu1*D(v) + mu2*D(v)*abs(D(v)) + delta2*D(v)^2 + mu3*D(v)^3 + D2(v) - eta1*F*cos(Omega*t)
/// parameters: [0] omega0, [1] mu1, [2] mu2, [3] mu3, [4] alpha2, [5] alpha3, [6] delta2, [7] delta3, [8] eta1,
/// [9] eta2. displacement, velocity, acceleration: 1 values.
template <class Scalar, class Parameter, class Sample>
void accelerations([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* acceleration) {
  const Scalar omega0 = parameters[0];
  const Scalar mu1 = parameters[1];
  const Scalar mu2 = parameters[2];
  const Scalar mu3 = parameters[3];
  const Scalar alpha2 = parameters[4];
  const Scalar alpha3 = parameters[5];
  const Scalar delta2 = parameters[6];
  const Scalar delta3 = parameters[7];
  const Scalar eta1 = parameters[8];
  const Scalar eta2 = parameters[9];
  const Scalar omega0_2 = omega0 * omega0;
  acceleration[0] = -(omega0_2 * displacement[0] + delta3 * displacement[0] * velocity[0] * velocity[0]
      - eta2 * displacement[0] * excitation[0].value + alpha2 * displacement[0] * displacement[0]
      + alpha3 * displacement[0] * displacement[0] * displacement[0] + 2.0 * mu1 * velocity[0]
      + mu2 * velocity[0] * absolute(velocity[0]) + delta2 * velocity[0] * velocity[0]
      + mu3 * velocity[0] * velocity[0] * velocity[0] - eta1 * excitation[0].value);
  Scalar mass[1];
  mass_matrix(parameters, excitation, displacement, velocity, mass);
  acceleration[0] = acceleration[0] / mass[0];
}

/// slope[k * 2 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = v, D(v). Of
/// nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x) = 0.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_state([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  Scalar acceleration[1];
  accelerations(parameters, excitation, displacement, velocity, acceleration);
  const Scalar omega0 = parameters[0];
  const Scalar mu1 = parameters[1];
  const Scalar mu2 = parameters[2];
  const Scalar mu3 = parameters[3];
  const Scalar alpha2 = parameters[4];
  const Scalar alpha3 = parameters[5];
  const Scalar delta2 = parameters[6];
  const Scalar delta3 = parameters[7];
  const Scalar eta2 = parameters[9];
  const Scalar omega0_2 = omega0 * omega0;
  for (std::size_t i = 0; i < 2; ++i) slope[i] = 0.0;
  // equation 1 by v
  slope[0] = -(omega0_2 + delta3 * velocity[0] * velocity[0] + 2.0 * delta2 * acceleration[0]
      - eta2 * excitation[0].value + alpha2 * displacement[0] * 2.0
      + delta3 * displacement[0] * 2.0 * acceleration[0] + alpha3 * displacement[0] * displacement[0] * 3.0);
  // equation 1 by D(v)
  slope[1] = -(delta3 * displacement[0] * velocity[0] * 2.0 + 2.0 * mu1 + mu2 * absolute(velocity[0])
      + mu2 * velocity[0] * sign_of(velocity[0]) + delta2 * velocity[0] * 2.0
      + mu3 * velocity[0] * velocity[0] * 3.0);
  Scalar mass[1];
  mass_matrix(parameters, excitation, displacement, velocity, mass);
  for (std::size_t i = 0; i < 2; ++i) slope[i] = slope[i] / mass[0];
}

/// slope[k * 10 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = omega0, mu1, mu2,
/// mu3, alpha2, alpha3, delta2, delta3, eta1, eta2. Of nonsmooth terms the classical derivative: d|x| = sgn(x)
/// dx, zero at the corner, and d sgn(x) = 0.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_parameters([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  Scalar acceleration[1];
  accelerations(parameters, excitation, displacement, velocity, acceleration);
  const Scalar omega0 = parameters[0];
  for (std::size_t i = 0; i < 10; ++i) slope[i] = 0.0;
  slope[0] = -(2.0 * omega0 * displacement[0]);  // equation 1 by omega0
  slope[1] = -(2.0 * velocity[0]);  // equation 1 by mu1
  slope[2] = -(velocity[0] * absolute(velocity[0]));  // equation 1 by mu2
  slope[3] = -(velocity[0] * velocity[0] * velocity[0]);  // equation 1 by mu3
  slope[4] = -(displacement[0] * displacement[0]);  // equation 1 by alpha2
  slope[5] = -(displacement[0] * displacement[0] * displacement[0]);  // equation 1 by alpha3
  slope[6] = -(2.0 * displacement[0] * acceleration[0] + velocity[0] * velocity[0]);  // equation 1 by delta2
  // equation 1 by delta3
  slope[7] = -(displacement[0] * velocity[0] * velocity[0] + displacement[0] * displacement[0] * acceleration[0]);
  slope[8] = -(-excitation[0].value);  // equation 1 by eta1
  slope[9] = -(-displacement[0] * excitation[0].value);  // equation 1 by eta2
  Scalar mass[1];
  mass_matrix(parameters, excitation, displacement, velocity, mass);
  for (std::size_t i = 0; i < 10; ++i) slope[i] = slope[i] / mass[0];
}

/// Lumps: the parameter combinations that multiply data. Symbols, their powers and the inverses of sums that
/// divide (small divisors) first, each once.
struct Lumps {
  const double omega0, mu1, mu2, mu3, alpha2, alpha3, delta2, delta3, eta1, eta2;
  const double omega0_2 = omega0 * omega0;
  const double omega0_3 = omega0_2 * omega0;
  const double omega0_4 = omega0_3 * omega0;
  const double omega0_5 = omega0_4 * omega0;
  const double alpha2_2 = alpha2 * alpha2;
  const double delta2_2 = delta2 * delta2;
  const double eta2_2 = eta2 * eta2;

  explicit Lumps(const double* parameters) : omega0(parameters[0]), mu1(parameters[1]), mu2(parameters[2]),
      mu3(parameters[3]), alpha2(parameters[4]), alpha3(parameters[5]), delta2(parameters[6]),
      delta3(parameters[7]), eta1(parameters[8]), eta2(parameters[9]) {}

  double lump_mu1() const { return mu1; }
  double lump_mu2() const { return mu2; }
  double lump_mu3() const { return mu3; }
  /// alpha_e = (6*omega0^4*delta2^2 - 6*omega0^4*delta3 + 12*omega0^2*alpha2*delta2 + 9*omega0^2*alpha3 -
  /// 10*alpha2^2)/(24*omega0^2)
  double lump_alpha_e() const {
    return (6.0 * omega0_4 * delta2_2 - 6.0 * omega0_4 * delta3 + 12.0 * omega0_2 * alpha2 * delta2
        + 9.0 * omega0_2 * alpha3 - 10.0 * alpha2_2) / (24.0 * omega0_2);
  }
  /// eta_e = (-6*omega0^2*delta2*eta1 + 3*omega0^2*eta2 + 2*alpha2*eta1)/(12*omega0^2)
  double lump_eta_e() const {
    return (-6.0 * omega0_2 * delta2 * eta1 + 3.0 * omega0_2 * eta2 + 2.0 * alpha2 * eta1) / (12.0 * omega0_2);
  }
  double lump_alpha_0() const { return -omega0_2 * delta2 + alpha2; }
  double lump_eta1() const { return eta1; }
  double lump_alpha_q() const { return -3.0 * omega0_2 * delta2 + alpha2; }
  /// harmonic_re_v_A_v_F = (14*omega0^2*delta2*eta1 - 3*omega0^2*eta2 - 2*alpha2*eta1)/(48*omega0^4)
  double lump_harmonic_re_v_A_v_F() const {
    return (14.0 * omega0_2 * delta2 * eta1 - 3.0 * omega0_2 * eta2 - 2.0 * alpha2 * eta1) / (48.0 * omega0_4);
  }
  /// harmonic_re_v_A_v3 = (42*omega0^4*delta2^2 - 6*omega0^4*delta3 - 20*omega0^2*alpha2*delta2 +
  /// 3*omega0^2*alpha3 + 2*alpha2^2)/(24*omega0^4)
  double lump_harmonic_re_v_A_v3() const {
    return (42.0 * omega0_4 * delta2_2 - 6.0 * omega0_4 * delta3 - 20.0 * omega0_2 * alpha2 * delta2
        + 3.0 * omega0_2 * alpha3 + 2.0 * alpha2_2) / (24.0 * omega0_4);
  }
  /// conservative_v_A_v2_F = (-3*omega0^2*delta2*eta2 + 5*alpha2*eta2)/(12*omega0^3)
  double lump_conservative_v_A_v2_F() const {
    return (-3.0 * omega0_2 * delta2 * eta2 + 5.0 * alpha2 * eta2) / (12.0 * omega0_3);
  }
  double lump_conservative_v_A_v_F2() const { return -eta2_2 / (12.0 * omega0_3); }
  double lump_eta2() const { return eta2; }
  /// harmonic_re_v_A_v2_F = (17*omega0^2*delta2*eta2 - 3*alpha2*eta2)/(48*omega0^4)
  double lump_harmonic_re_v_A_v2_F() const {
    return (17.0 * omega0_2 * delta2 * eta2 - 3.0 * alpha2 * eta2) / (48.0 * omega0_4);
  }

  /// By their numbers in the tables.
  static constexpr double (Lumps::*list[])() const = {&Lumps::lump_mu1, &Lumps::lump_mu2, &Lumps::lump_mu3,
      &Lumps::lump_alpha_e, &Lumps::lump_eta_e, &Lumps::lump_alpha_0, &Lumps::lump_eta1, &Lumps::lump_alpha_q,
      &Lumps::lump_harmonic_re_v_A_v_F, &Lumps::lump_harmonic_re_v_A_v3, &Lumps::lump_conservative_v_A_v2_F,
      &Lumps::lump_conservative_v_A_v_F2, &Lumps::lump_eta2, &Lumps::lump_harmonic_re_v_A_v2_F};
};

/// What rows are functions of: frequencies, and signals, which are amplitudes A, their conjugates, norms |A|^2
/// and moduli, and the excitation.
struct Model {
  static constexpr std::size_t modes = 1, excitations = 1;

  template <class Number>
  struct Frequencies {
    const Number omega0, Omega;
    Frequencies(const Number* natural, [[maybe_unused]] const Number* excitation) : omega0(natural[0]),
        Omega(excitation[0]) {}
  };

  template <class Number>
  struct Signals {
    using Complex = ComplexNumber<Number>;
    const Complex A_v;
    const Complex conj_A_v = conjugate(A_v);
    const Number norm_A_v = norm_of(A_v);
    const Number abs_A_v = modulus_of(A_v);
    const Number inverse_abs_A_v = inverse_or_zero(abs_A_v);
    const Complex unit_A_v = inverse_abs_A_v * A_v;
    const Complex F;
    const Complex conj_F = conjugate(F);
    const Number norm_F = norm_of(F);
    Signals(const Complex* amplitude, [[maybe_unused]] const Complex* forcing) : A_v(amplitude[0]), F(forcing[0]) {}
  };
};

}  // namespace secular::generated::two_mass_mode1
