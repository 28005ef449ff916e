// Model two_mass_lumps: generated code, never edited by hand.
// Holds equations of motion, lumps, what rows are made of. Made by: secular generate two_mass_lumps.
// Source: S. O'F. Fahey, dissertation, Virginia Tech, 2000, Eqs. (6.25)-(6.35)
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// two_mass_lumps.additive_combination.hpp: Omega = omega1 + omega2 + eps*sigma
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

namespace secular::generated::two_mass_lumps {

/// Mass matrix M of the equations of motion M*acceleration + force = 0 below, state-dependent: mass[k * 2 + j]
/// multiplies the acceleration of mode j in equation k.
template <class Scalar, class Parameter, class Sample>
void mass_matrix([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* mass) {
  mass[0] = 1.0;
  mass[1] = 0.0;
  mass[2] = 0.0;
  mass[3] = 1.0;
}

/// Accelerations of the full equations of motion, solved from the state-dependent mass matrix.
/// 0 = (omega1^2 + lambda)*v1 + kappa*v1*(F*cos(Omega*t))^2 + alpha1*v1^3 + 2*mu11*D(v1) + mu13*D(v1)^3 + D2(v1)
/// - p*v2*F*cos(Omega*t) - q1*D(v2)*F*cos(Omega*t)
/// 0 = -p*v1*F*cos(Omega*t) - q2*D(v1)*F*cos(Omega*t) + omega2^2*v2 + alpha2*v2^3 + 2*mu22*D(v2) + mu23*D(v2)^3
/// + D2(v2)
/// parameters: [0] omega1, [1] omega2, [2] mu11, [3] mu13, [4] lambda, [5] alpha1, [6] kappa, [7] p, [8] q1, [9]
/// mu22, [10] mu23, [11] alpha2, [12] q2. displacement, velocity, acceleration: 2 values.
template <class Scalar, class Parameter, class Sample>
void accelerations([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* acceleration) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu11 = parameters[2];
  const Scalar mu13 = parameters[3];
  const Scalar lambda = parameters[4];
  const Scalar alpha1 = parameters[5];
  const Scalar kappa = parameters[6];
  const Scalar p = parameters[7];
  const Scalar q1 = parameters[8];
  const Scalar mu22 = parameters[9];
  const Scalar mu23 = parameters[10];
  const Scalar alpha2 = parameters[11];
  const Scalar q2 = parameters[12];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  acceleration[0] = -((omega1_2 + lambda) * displacement[0]
      + kappa * displacement[0] * excitation[0].value * excitation[0].value
      + alpha1 * displacement[0] * displacement[0] * displacement[0] + 2.0 * mu11 * velocity[0]
      + mu13 * velocity[0] * velocity[0] * velocity[0] - p * displacement[1] * excitation[0].value
      - q1 * velocity[1] * excitation[0].value);
  acceleration[1] = -(-p * displacement[0] * excitation[0].value - q2 * velocity[0] * excitation[0].value
      + omega2_2 * displacement[1] + alpha2 * displacement[1] * displacement[1] * displacement[1]
      + 2.0 * mu22 * velocity[1] + mu23 * velocity[1] * velocity[1] * velocity[1]);
}

/// slope[k * 4 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = v1, v2, D(v1),
/// D(v2). Of nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x) = 0.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_state([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar mu11 = parameters[2];
  const Scalar mu13 = parameters[3];
  const Scalar lambda = parameters[4];
  const Scalar alpha1 = parameters[5];
  const Scalar kappa = parameters[6];
  const Scalar p = parameters[7];
  const Scalar q1 = parameters[8];
  const Scalar mu22 = parameters[9];
  const Scalar mu23 = parameters[10];
  const Scalar alpha2 = parameters[11];
  const Scalar q2 = parameters[12];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  for (std::size_t i = 0; i < 8; ++i) slope[i] = 0.0;
  // equation 1 by v1
  slope[0] = -(omega1_2 + lambda + kappa * excitation[0].value * excitation[0].value
      + alpha1 * displacement[0] * displacement[0] * 3.0);
  slope[1] = -(-p * excitation[0].value);  // equation 1 by v2
  slope[2] = -(2.0 * mu11 + mu13 * velocity[0] * velocity[0] * 3.0);  // equation 1 by D(v1)
  slope[3] = -(-q1 * excitation[0].value);  // equation 1 by D(v2)
  slope[4] = -(-p * excitation[0].value);  // equation 2 by v1
  slope[5] = -(omega2_2 + alpha2 * displacement[1] * displacement[1] * 3.0);  // equation 2 by v2
  slope[6] = -(-q2 * excitation[0].value);  // equation 2 by D(v1)
  slope[7] = -(2.0 * mu22 + mu23 * velocity[1] * velocity[1] * 3.0);  // equation 2 by D(v2)
}

/// slope[k * 13 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = omega1, omega2,
/// mu11, mu13, lambda, alpha1, kappa, p, q1, mu22, mu23, alpha2, q2. Of nonsmooth terms the classical
/// derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x) = 0.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_parameters([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  for (std::size_t i = 0; i < 26; ++i) slope[i] = 0.0;
  slope[0] = -(2.0 * omega1 * displacement[0]);  // equation 1 by omega1
  slope[2] = -(2.0 * velocity[0]);  // equation 1 by mu11
  slope[3] = -(velocity[0] * velocity[0] * velocity[0]);  // equation 1 by mu13
  slope[4] = -(displacement[0]);  // equation 1 by lambda
  slope[5] = -(displacement[0] * displacement[0] * displacement[0]);  // equation 1 by alpha1
  slope[6] = -(displacement[0] * excitation[0].value * excitation[0].value);  // equation 1 by kappa
  slope[7] = -(-displacement[1] * excitation[0].value);  // equation 1 by p
  slope[8] = -(-velocity[1] * excitation[0].value);  // equation 1 by q1
  slope[14] = -(2.0 * omega2 * displacement[1]);  // equation 2 by omega2
  slope[20] = -(-displacement[0] * excitation[0].value);  // equation 2 by p
  slope[22] = -(2.0 * velocity[1]);  // equation 2 by mu22
  slope[23] = -(velocity[1] * velocity[1] * velocity[1]);  // equation 2 by mu23
  slope[24] = -(displacement[1] * displacement[1] * displacement[1]);  // equation 2 by alpha2
  slope[25] = -(-velocity[0] * excitation[0].value);  // equation 2 by q2
}

/// Lumps: the parameter combinations that multiply data. Symbols, their powers and the inverses of sums that
/// divide (small divisors) first, each once.
struct Lumps {
  const double mu11, mu13, lambda, alpha1, kappa, p, q1, mu22, mu23, alpha2, q2;

  explicit Lumps(const double* parameters) : mu11(parameters[2]), mu13(parameters[3]), lambda(parameters[4]),
      alpha1(parameters[5]), kappa(parameters[6]), p(parameters[7]), q1(parameters[8]), mu22(parameters[9]),
      mu23(parameters[10]), alpha2(parameters[11]), q2(parameters[12]) {}

  double lump_mu11() const { return mu11; }
  double lump_lambda() const { return lambda; }
  double lump_kappa() const { return kappa; }
  double lump_mu13() const { return mu13; }
  double lump_alpha1() const { return alpha1; }
  double lump_q1() const { return q1; }
  double lump_p() const { return p; }
  double lump_mu22() const { return mu22; }
  double lump_mu23() const { return mu23; }
  double lump_alpha2() const { return alpha2; }
  double lump_q2() const { return q2; }

  /// By their numbers in the tables.
  static constexpr double (Lumps::*list[])() const = {&Lumps::lump_mu11, &Lumps::lump_lambda, &Lumps::lump_kappa,
      &Lumps::lump_mu13, &Lumps::lump_alpha1, &Lumps::lump_q1, &Lumps::lump_p, &Lumps::lump_mu22, &Lumps::lump_mu23,
      &Lumps::lump_alpha2, &Lumps::lump_q2};
};

/// What rows are functions of: frequencies, and signals, which are amplitudes A, their conjugates, norms |A|^2
/// and moduli, and the excitation.
struct Model {
  static constexpr std::size_t modes = 2, excitations = 1;

  template <class Number>
  struct Frequencies {
    const Number omega1, omega2, Omega;
    Frequencies(const Number* natural, [[maybe_unused]] const Number* excitation) : omega1(natural[0]),
        omega2(natural[1]), Omega(excitation[0]) {}
  };

  template <class Number>
  struct Signals {
    using Complex = ComplexNumber<Number>;
    const Complex A_v1;
    const Complex conj_A_v1 = conjugate(A_v1);
    const Number norm_A_v1 = norm_of(A_v1);
    const Complex A_v2;
    const Complex conj_A_v2 = conjugate(A_v2);
    const Number norm_A_v2 = norm_of(A_v2);
    const Complex F;
    const Number norm_F = norm_of(F);
    Signals(const Complex* amplitude, [[maybe_unused]] const Complex* forcing) : A_v1(amplitude[0]),
        A_v2(amplitude[1]), F(forcing[0]) {}
  };
};

}  // namespace secular::generated::two_mass_lumps
