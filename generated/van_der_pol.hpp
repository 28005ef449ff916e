// Model van_der_pol: generated code, never edited by hand.
// Holds equations of motion, lumps, what rows are made of. Made by: secular generate van_der_pol.
// Source: B. van der Pol, Philosophical Magazine 2, 978 (1926)
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// van_der_pol.free.hpp: no resonance
// van_der_pol.free_third_order.hpp: no resonance
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

namespace secular::generated::van_der_pol {

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
/// 0 = omega0^2*x + mu*x^2*D(x) - mu*D(x) + D2(x)
/// parameters: [0] omega0, [1] mu. displacement, velocity, acceleration: 1 values.
template <class Scalar, class Parameter, class Sample>
void accelerations([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* acceleration) {
  const Scalar omega0 = parameters[0];
  const Scalar mu = parameters[1];
  const Scalar omega0_2 = omega0 * omega0;
  acceleration[0] = -(omega0_2 * displacement[0] + mu * displacement[0] * displacement[0] * velocity[0]
      - mu * velocity[0]);
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
  const Scalar omega0_2 = omega0 * omega0;
  for (std::size_t i = 0; i < 2; ++i) slope[i] = 0.0;
  slope[0] = -(omega0_2 + mu * displacement[0] * velocity[0] * 2.0);  // equation 1 by x
  slope[1] = -(mu * displacement[0] * displacement[0] - mu);  // equation 1 by D(x)
}

/// slope[k * 2 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = omega0, mu. Of
/// nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x) = 0.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_parameters([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  const Scalar omega0 = parameters[0];
  for (std::size_t i = 0; i < 2; ++i) slope[i] = 0.0;
  slope[0] = -(2.0 * omega0 * displacement[0]);  // equation 1 by omega0
  slope[1] = -(displacement[0] * displacement[0] * velocity[0] - velocity[0]);  // equation 1 by mu
}

/// Lumps: the parameter combinations that multiply data. Symbols, their powers and the inverses of sums that
/// divide (small divisors) first, each once.
struct Lumps {
  const double omega0, mu;
  const double omega0_2 = omega0 * omega0;
  const double omega0_3 = omega0_2 * omega0;
  const double mu_2 = mu * mu;
  const double mu_3 = mu_2 * mu;

  explicit Lumps(const double* parameters) : omega0(parameters[0]), mu(parameters[1]) {}

  double lump_mu() const { return mu; }
  double lump_conservative_x_A_x() const { return -mu_2 / (8.0 * omega0); }
  double lump_dissipative_x_A_x2_conjA_x() const { return (-2.0 * omega0_2 * mu - mu_3) / (4.0 * omega0_2); }
  double lump_dissipative_x_A_x3_conjA_x2() const { return 35.0 * mu_3 / (64.0 * omega0_2); }

  /// By their numbers in the tables.
  static constexpr double (Lumps::*list[])() const = {&Lumps::lump_mu, &Lumps::lump_conservative_x_A_x,
      &Lumps::lump_dissipative_x_A_x2_conjA_x, &Lumps::lump_dissipative_x_A_x3_conjA_x2};
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
    const Complex A_x;
    const Number norm_A_x = norm_of(A_x);
    Signals(const Complex* amplitude, [[maybe_unused]] const Complex* forcing) : A_x(amplitude[0]) {}
  };
};

}  // namespace secular::generated::van_der_pol
