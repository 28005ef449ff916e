// Model pendulum: generated code, never edited by hand.
// Holds equations of motion, lumps, what rows are made of. Made by: secular generate pendulum.
// Source: Rigid pendulum; damping laws as in A. H. Nayfeh and D. T. Mook, Nonlinear Oscillations, section 3.3
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// pendulum.free.hpp: free vibration
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

namespace secular::generated::pendulum {

/// Mass matrix M of the equations of motion M*acceleration + force = 0 below, state-dependent: mass[k * 1 + j]
/// multiplies the acceleration of mode j in equation k.
template <class Scalar, class Parameter, class Sample>
void mass_matrix([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* mass) {
  mass[0] = 1.0;
}

/// Accelerations of the full equations of motion, solved from the state-dependent mass matrix.
/// 0 = omega0^2*theta + alpha3*theta^3 + alpha5*theta^5 + 2*mu1*D(theta) + mu2*D(theta)*abs(D(theta)) +
/// D2(theta) + fc*sgn(D(theta))
/// parameters: [0] omega0, [1] alpha3, [2] alpha5, [3] mu1, [4] mu2, [5] fc. displacement, velocity,
/// acceleration: 1 values.
template <class Scalar, class Parameter, class Sample>
void accelerations([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* acceleration) {
  const Scalar omega0 = parameters[0];
  const Scalar alpha3 = parameters[1];
  const Scalar alpha5 = parameters[2];
  const Scalar mu1 = parameters[3];
  const Scalar mu2 = parameters[4];
  const Scalar fc = parameters[5];
  const Scalar omega0_2 = omega0 * omega0;
  acceleration[0] = -(omega0_2 * displacement[0] + alpha3 * displacement[0] * displacement[0] * displacement[0]
      + alpha5 * displacement[0] * displacement[0] * displacement[0] * displacement[0] * displacement[0]
      + 2.0 * mu1 * velocity[0] + mu2 * velocity[0] * absolute(velocity[0]) + fc * sign_of(velocity[0]));
}

/// slope[k * 2 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = theta, D(theta).
/// Of nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x) = 0.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_state([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  const Scalar omega0 = parameters[0];
  const Scalar alpha3 = parameters[1];
  const Scalar alpha5 = parameters[2];
  const Scalar mu1 = parameters[3];
  const Scalar mu2 = parameters[4];
  const Scalar omega0_2 = omega0 * omega0;
  for (std::size_t i = 0; i < 2; ++i) slope[i] = 0.0;
  // equation 1 by theta
  slope[0] = -(omega0_2 + alpha3 * displacement[0] * displacement[0] * 3.0
      + alpha5 * displacement[0] * displacement[0] * displacement[0] * displacement[0] * 5.0);
  // equation 1 by D(theta)
  slope[1] = -(2.0 * mu1 + mu2 * absolute(velocity[0]) + mu2 * velocity[0] * sign_of(velocity[0]));
}

/// slope[k * 6 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = omega0, alpha3,
/// alpha5, mu1, mu2, fc. Of nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and
/// d sgn(x) = 0.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_parameters([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  const Scalar omega0 = parameters[0];
  for (std::size_t i = 0; i < 6; ++i) slope[i] = 0.0;
  slope[0] = -(2.0 * omega0 * displacement[0]);  // equation 1 by omega0
  slope[1] = -(displacement[0] * displacement[0] * displacement[0]);  // equation 1 by alpha3
  // equation 1 by alpha5
  slope[2] = -(displacement[0] * displacement[0] * displacement[0] * displacement[0] * displacement[0]);
  slope[3] = -(2.0 * velocity[0]);  // equation 1 by mu1
  slope[4] = -(velocity[0] * absolute(velocity[0]));  // equation 1 by mu2
  slope[5] = -(sign_of(velocity[0]));  // equation 1 by fc
}

/// Lumps: the parameter combinations that multiply data. Symbols, their powers and the inverses of sums that
/// divide (small divisors) first, each once.
struct Lumps {
  const double omega0, alpha3, alpha5, mu1, mu2, fc;
  const double omega0_2 = omega0 * omega0;
  const double omega0_3 = omega0_2 * omega0;
  const double omega0_4 = omega0_3 * omega0;
  const double omega0_5 = omega0_4 * omega0;
  const double alpha3_2 = alpha3 * alpha3;

  explicit Lumps(const double* parameters) : omega0(parameters[0]), alpha3(parameters[1]), alpha5(parameters[2]),
      mu1(parameters[3]), mu2(parameters[4]), fc(parameters[5]) {}

  double lump_fc() const { return fc; }
  double lump_mu1() const { return mu1; }
  double lump_mu2() const { return mu2; }
  double lump_alpha3() const { return alpha3; }
  double lump_beta5() const { return (16.0 * omega0_2 * alpha5 - 3.0 * alpha3_2) / (16.0 * omega0_2); }
  /// harmonic_re_theta_A_theta4_conjA_theta = (40*omega0^2*alpha5 - 21*alpha3^2)/(64*omega0^4)
  double lump_harmonic_re_theta_A_theta4_conjA_theta() const {
    return (40.0 * omega0_2 * alpha5 - 21.0 * alpha3_2) / (64.0 * omega0_4);
  }
  /// harmonic_re_theta_A_theta5 = (8*omega0^2*alpha5 + 3*alpha3^2)/(192*omega0^4)
  double lump_harmonic_re_theta_A_theta5() const {
    return (8.0 * omega0_2 * alpha5 + 3.0 * alpha3_2) / (192.0 * omega0_4);
  }

  /// By their numbers in the tables.
  static constexpr double (Lumps::*list[])() const = {&Lumps::lump_fc, &Lumps::lump_mu1, &Lumps::lump_mu2,
      &Lumps::lump_alpha3, &Lumps::lump_beta5, &Lumps::lump_harmonic_re_theta_A_theta4_conjA_theta,
      &Lumps::lump_harmonic_re_theta_A_theta5};
};

/// What rows are functions of: frequencies, and signals, which are amplitudes A, their conjugates, norms |A|^2
/// and moduli, and the excitation.
struct Model {
  static constexpr std::size_t modes = 1, excitations = 0;

  template <class Number>
  struct Frequencies {
    const Number omega0;
    Frequencies(const Number* natural, [[maybe_unused]] const Number* excitation) : omega0(natural[0]) {}
  };

  template <class Number>
  struct Signals {
    using Complex = ComplexNumber<Number>;
    const Complex A_theta;
    const Number norm_A_theta = norm_of(A_theta);
    const Number abs_A_theta = modulus_of(A_theta);
    const Number inverse_abs_A_theta = inverse_or_zero(abs_A_theta);
    const Complex unit_A_theta = inverse_abs_A_theta * A_theta;
    Signals(const Complex* amplitude, [[maybe_unused]] const Complex* forcing) : A_theta(amplitude[0]) {}
  };
};

}  // namespace secular::generated::pendulum
