// Model mathieu_duffing: generated code, never edited by hand.
// Holds equations of motion, lumps, what rows are made of. Made by: secular generate mathieu_duffing.
// Source: E. Mathieu, Journal de Mathematiques 13, 137 (1868), with a cubic term
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// mathieu_duffing.principal.hpp: Omega = 2*omega0 + eps*sigma
// mathieu_duffing.fundamental.hpp: Omega = omega0 + eps^2*sigma
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

namespace secular::generated::mathieu_duffing {

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
/// 0 = omega0^2*x + h*x*F*cos(Omega*t) + a3*x^3 + 2*mu*D(x) + D2(x)
/// parameters: [0] omega0, [1] mu, [2] a3, [3] h. displacement, velocity, acceleration: 1 values.
template <class Scalar, class Parameter, class Sample>
void accelerations([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* acceleration) {
  const Scalar omega0 = parameters[0];
  const Scalar mu = parameters[1];
  const Scalar a3 = parameters[2];
  const Scalar h = parameters[3];
  const Scalar omega0_2 = omega0 * omega0;
  acceleration[0] = -(omega0_2 * displacement[0] + h * displacement[0] * excitation[0].value
      + a3 * displacement[0] * displacement[0] * displacement[0] + 2.0 * mu * velocity[0]);
}

/// slope[k * 2 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = x, D(x). Of
/// nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x) = 0.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_state([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  const Scalar omega0 = parameters[0];
  const Scalar mu = parameters[1];
  const Scalar a3 = parameters[2];
  const Scalar h = parameters[3];
  const Scalar omega0_2 = omega0 * omega0;
  for (std::size_t i = 0; i < 2; ++i) slope[i] = 0.0;
  // equation 1 by x
  slope[0] = -(omega0_2 + h * excitation[0].value + a3 * displacement[0] * displacement[0] * 3.0);
  slope[1] = -(2.0 * mu);  // equation 1 by D(x)
}

/// slope[k * 4 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = omega0, mu, a3, h.
/// Of nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x) = 0.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_parameters([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  const Scalar omega0 = parameters[0];
  for (std::size_t i = 0; i < 4; ++i) slope[i] = 0.0;
  slope[0] = -(2.0 * omega0 * displacement[0]);  // equation 1 by omega0
  slope[1] = -(2.0 * velocity[0]);  // equation 1 by mu
  slope[2] = -(displacement[0] * displacement[0] * displacement[0]);  // equation 1 by a3
  slope[3] = -(displacement[0] * excitation[0].value);  // equation 1 by h
}

/// Lumps: the parameter combinations that multiply data. Symbols, their powers and the inverses of sums that
/// divide (small divisors) first, each once.
struct Lumps {
  const double omega0, mu, a3, h;
  const double omega0_2 = omega0 * omega0;
  const double omega0_3 = omega0_2 * omega0;
  const double omega0_4 = omega0_3 * omega0;
  const double mu_2 = mu * mu;
  const double a3_2 = a3 * a3;
  const double h_2 = h * h;

  explicit Lumps(const double* parameters) : omega0(parameters[0]), mu(parameters[1]), a3(parameters[2]),
      h(parameters[3]) {}

  double lump_conservative_x_A_x3_F() const { return 7.0 * a3 * h / (32.0 * omega0_3); }
  double lump_mu() const { return mu; }
  double lump_conservative_x_A_x() const { return -mu_2 / (2.0 * omega0); }
  double lump_conservative_x_A_x_F2() const { return 3.0 * h_2 / (64.0 * omega0_3); }
  double lump_dissipative_x_A_x2_conjA_x() const { return 3.0 * mu * a3 / (2.0 * omega0_2); }
  double lump_a3() const { return a3; }
  double lump_conservative_x_A_x3_conjA_x2() const { return -15.0 * a3_2 / (16.0 * omega0_3); }
  double lump_h() const { return h; }
  double lump_conservative_x_A_x_F2_of_fundamental() const { return -h_2 / (12.0 * omega0_3); }

  /// By their numbers in the tables.
  static constexpr double (Lumps::*list[])() const = {&Lumps::lump_conservative_x_A_x3_F, &Lumps::lump_mu,
      &Lumps::lump_conservative_x_A_x, &Lumps::lump_conservative_x_A_x_F2, &Lumps::lump_dissipative_x_A_x2_conjA_x,
      &Lumps::lump_a3, &Lumps::lump_conservative_x_A_x3_conjA_x2, &Lumps::lump_h,
      &Lumps::lump_conservative_x_A_x_F2_of_fundamental};
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
    const Complex A_x;
    const Complex conj_A_x = conjugate(A_x);
    const Number norm_A_x = norm_of(A_x);
    const Complex F;
    const Complex conj_F = conjugate(F);
    const Number norm_F = norm_of(F);
    Signals(const Complex* amplitude, [[maybe_unused]] const Complex* forcing) : A_x(amplitude[0]), F(forcing[0]) {}
  };
};

}  // namespace secular::generated::mathieu_duffing
