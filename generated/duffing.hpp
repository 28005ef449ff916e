// Model duffing: generated code, never edited by hand.
// Holds equations of motion, lumps, what rows are made of. Made by: secular generate duffing.
// Source: Duffing oscillator with a quadratic term
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// duffing.free.hpp: free vibration
// duffing.primary.hpp: Omega = omega0 + eps^2*sigma
// duffing.superharmonic_3.hpp: 3*Omega = omega0 + eps*sigma
// duffing.subharmonic_3.hpp: Omega = 3*omega0 + eps*sigma
// duffing.subharmonic_3_second_order.hpp: Omega = 3*omega0 + eps*sigma
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

namespace secular::generated::duffing {

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
/// 0 = omega0^2*x + a2*x^2 + a3*x^3 + 2*mu*D(x) + D2(x) - e*F*cos(Omega*t)
/// parameters: [0] omega0, [1] mu, [2] a2, [3] a3, [4] e. displacement, velocity, acceleration: 1 values.
template <class Scalar, class Parameter, class Sample>
void accelerations([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* acceleration) {
  const Scalar omega0 = parameters[0];
  const Scalar mu = parameters[1];
  const Scalar a2 = parameters[2];
  const Scalar a3 = parameters[3];
  const Scalar e = parameters[4];
  const Scalar omega0_2 = omega0 * omega0;
  acceleration[0] = -(omega0_2 * displacement[0] + a2 * displacement[0] * displacement[0]
      + a3 * displacement[0] * displacement[0] * displacement[0] + 2.0 * mu * velocity[0]
      - e * excitation[0].value);
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
  const Scalar a2 = parameters[2];
  const Scalar a3 = parameters[3];
  const Scalar omega0_2 = omega0 * omega0;
  for (std::size_t i = 0; i < 2; ++i) slope[i] = 0.0;
  // equation 1 by x
  slope[0] = -(omega0_2 + a2 * displacement[0] * 2.0 + a3 * displacement[0] * displacement[0] * 3.0);
  slope[1] = -(2.0 * mu);  // equation 1 by D(x)
}

/// slope[k * 5 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = omega0, mu, a2,
/// a3, e. Of nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x) = 0.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_parameters([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  const Scalar omega0 = parameters[0];
  for (std::size_t i = 0; i < 5; ++i) slope[i] = 0.0;
  slope[0] = -(2.0 * omega0 * displacement[0]);  // equation 1 by omega0
  slope[1] = -(2.0 * velocity[0]);  // equation 1 by mu
  slope[2] = -(displacement[0] * displacement[0]);  // equation 1 by a2
  slope[3] = -(displacement[0] * displacement[0] * displacement[0]);  // equation 1 by a3
  slope[4] = -(-excitation[0].value);  // equation 1 by e
}

/// Lumps: the parameter combinations that multiply data. Symbols, their powers and the inverses of sums that
/// divide (small divisors) first, each once.
struct Lumps {
  const double omega0, mu, a2, a3, e;
  const double omega0_2 = omega0 * omega0;
  const double omega0_3 = omega0_2 * omega0;
  const double omega0_4 = omega0_3 * omega0;
  const double omega0_5 = omega0_4 * omega0;
  const double omega0_6 = omega0_5 * omega0;
  const double omega0_7 = omega0_6 * omega0;
  const double omega0_8 = omega0_7 * omega0;
  const double omega0_9 = omega0_8 * omega0;
  const double omega0_10 = omega0_9 * omega0;
  const double omega0_11 = omega0_10 * omega0;
  const double omega0_12 = omega0_11 * omega0;
  const double omega0_13 = omega0_12 * omega0;
  const double omega0_14 = omega0_13 * omega0;
  const double omega0_15 = omega0_14 * omega0;
  const double mu_2 = mu * mu;
  const double a2_2 = a2 * a2;
  const double a3_2 = a3 * a3;
  const double e_2 = e * e;
  const double e_3 = e_2 * e;
  const double e_4 = e_3 * e;
  const double e_5 = e_4 * e;

  explicit Lumps(const double* parameters) : omega0(parameters[0]), mu(parameters[1]), a2(parameters[2]),
      a3(parameters[3]), e(parameters[4]) {}

  double lump_mu() const { return mu; }
  /// conservative_x_A_x2_conjA_x = (9*omega0^2*a3 - 10*a2^2)/(6*omega0^3)
  double lump_conservative_x_A_x2_conjA_x() const {
    return (9.0 * omega0_2 * a3 - 10.0 * a2_2) / (6.0 * omega0_3);
  }
  double lump_a2() const { return a2; }
  double lump_harmonic_re_x_A_x3() const { return (3.0 * omega0_2 * a3 + 2.0 * a2_2) / (24.0 * omega0_4); }
  double lump_e() const { return e; }
  double lump_conservative_x_A_x_F2() const { return 243.0 * a3 * e_2 / (256.0 * omega0_5); }
  double lump_a3() const { return a3; }
  double lump_conservative_x_F3() const { return 729.0 * a3 * e_3 / (8192.0 * omega0_7); }
  double lump_harmonic_im_x_F() const { return -27.0 * mu * e / (64.0 * omega0_3); }
  double lump_harmonic_re_x_A_x_conjA_x_F() const { return -243.0 * a3 * e / (64.0 * omega0_4); }
  double lump_harmonic_re_x_F2() const { return -81.0 * a2 * e_2 / (128.0 * omega0_6); }
  double lump_harmonic_re_x_A_x_F() const { return -81.0 * a2 * e / (40.0 * omega0_4); }
  double lump_conservative_x_A_x_F2_of_subharmonic_3() const { return 3.0 * a3 * e_2 / (256.0 * omega0_5); }
  double lump_conservative_x_conjA_x2_F() const { return -3.0 * a3 * e / (32.0 * omega0_3); }
  double lump_harmonic_im_x_F_of_subharmonic_3() const { return -3.0 * mu * e / (64.0 * omega0_3); }
  double lump_harmonic_re_x_F3() const { return -3.0 * a3 * e_3 / (32768.0 * omega0_8); }
  double lump_harmonic_re_x_conjA_x_F() const { return -a2 * e / (24.0 * omega0_4); }
  double lump_harmonic_re_x_F2_of_subharmonic_3() const { return -a2 * e_2 / (128.0 * omega0_6); }
  double lump_conservative_x_A_x4_F() const { return -3.0 * a3_2 * e / (32.0 * omega0_5); }
  double lump_conservative_x_A_x() const { return -mu_2 / (2.0 * omega0); }
  /// conservative_x_A_x_F2 = (15*omega0^2*a3*e^2 - 6*a2^2*e^2)/(1280*omega0^7)
  double lump_conservative_x_A_x_F2_of_subharmonic_3_second_order() const {
    return (15.0 * omega0_2 * a3 * e_2 - 6.0 * a2_2 * e_2) / (1280.0 * omega0_7);
  }
  double lump_conservative_x_A_x_F2_sigma() const { return -9.0 * a3 * e_2 / (512.0 * omega0_6); }
  double lump_conservative_x_A_x_F4() const { return -63.0 * a3_2 * e_4 / (2097152.0 * omega0_11); }
  double lump_dissipative_x_A_x2_conjA_x() const { return 3.0 * mu * a3 / (2.0 * omega0_2); }
  double lump_conservative_x_A_x2_conjA_x_F2() const { return 21.0 * a3_2 * e_2 / (2048.0 * omega0_7); }
  double lump_conservative_x_A_x3_conjA_x2() const { return -15.0 * a3_2 / (16.0 * omega0_3); }
  double lump_dissipative_x_conjA_x2_F() const { return 3.0 * mu * a3 * e / (128.0 * omega0_4); }
  /// conservative_x_conjA_x2_F = (-3*omega0^2*a3*e - 2*a2^2*e)/(32*omega0^5)
  double lump_conservative_x_conjA_x2_F_of_subharmonic_3_second_order() const {
    return (-3.0 * omega0_2 * a3 * e - 2.0 * a2_2 * e) / (32.0 * omega0_5);
  }
  double lump_conservative_x_conjA_x2_F_sigma() const { return 15.0 * a3 * e / (128.0 * omega0_4); }
  double lump_conservative_x_conjA_x2_F3() const { return -27.0 * a3_2 * e_3 / (32768.0 * omega0_9); }
  double lump_harmonic_re_x_F() const { return 9.0 * mu_2 * e / (256.0 * omega0_4); }
  double lump_harmonic_im_x_F3() const { return -9.0 * mu * a3 * e_3 / (65536.0 * omega0_9); }
  double lump_harmonic_re_x_F5() const { return -273.0 * a3_2 * e_5 / (671088640.0 * omega0_14); }
  /// harmonic_re_x_A_x_conjA_x_F = 3*a2^2*e/(160*omega0^6)
  double lump_harmonic_re_x_A_x_conjA_x_F_of_subharmonic_3_second_order() const {
    return 3.0 * a2_2 * e / (160.0 * omega0_6);
  }
  double lump_harmonic_re_x_A_x3_of_subharmonic_3_second_order() const { return a2_2 / (12.0 * omega0_4); }
  double lump_harmonic_re_x_A_x2_F2() const { return a2 * a3 * e_2 / (192.0 * omega0_8); }
  double lump_harmonic_im_x_conjA_x_F() const { return -mu * a2 * e / (32.0 * omega0_5); }
  double lump_harmonic_re_x_conjA_x_F3() const { return -11.0 * a2 * a3 * e_3 / (86016.0 * omega0_10); }
  double lump_harmonic_re_x_A_x_conjA_x2_F() const { return a2 * a3 * e / (480.0 * omega0_6); }
  double lump_harmonic_im_x_A_x2() const { return -4.0 * mu * a2 / (9.0 * omega0_3); }
  double lump_harmonic_re_x_A_x3_conjA_x() const { return -31.0 * a2 * a3 / (12.0 * omega0_4); }
  double lump_harmonic_re_x_conjA_x_F2() const { return 73.0 * a2_2 * e_2 / (322560.0 * omega0_8); }
  double lump_harmonic_im_x_conjA_x_F2() const { return 3.0 * mu * a3 * e_2 / (4096.0 * omega0_7); }
  double lump_harmonic_re_x_F4() const { return 723.0 * a2 * a3 * e_4 / (4587520.0 * omega0_12); }
  double lump_harmonic_im_x_F2() const { return 129.0 * mu * a2 * e_2 / (627200.0 * omega0_7); }

  /// By their numbers in the tables.
  static constexpr double (Lumps::*list[])() const = {&Lumps::lump_mu, &Lumps::lump_conservative_x_A_x2_conjA_x,
      &Lumps::lump_a2, &Lumps::lump_harmonic_re_x_A_x3, &Lumps::lump_e, &Lumps::lump_conservative_x_A_x_F2,
      &Lumps::lump_a3, &Lumps::lump_conservative_x_F3, &Lumps::lump_harmonic_im_x_F,
      &Lumps::lump_harmonic_re_x_A_x_conjA_x_F, &Lumps::lump_harmonic_re_x_F2, &Lumps::lump_harmonic_re_x_A_x_F,
      &Lumps::lump_conservative_x_A_x_F2_of_subharmonic_3, &Lumps::lump_conservative_x_conjA_x2_F,
      &Lumps::lump_harmonic_im_x_F_of_subharmonic_3, &Lumps::lump_harmonic_re_x_F3,
      &Lumps::lump_harmonic_re_x_conjA_x_F, &Lumps::lump_harmonic_re_x_F2_of_subharmonic_3,
      &Lumps::lump_conservative_x_A_x4_F, &Lumps::lump_conservative_x_A_x,
      &Lumps::lump_conservative_x_A_x_F2_of_subharmonic_3_second_order, &Lumps::lump_conservative_x_A_x_F2_sigma,
      &Lumps::lump_conservative_x_A_x_F4, &Lumps::lump_dissipative_x_A_x2_conjA_x,
      &Lumps::lump_conservative_x_A_x2_conjA_x_F2, &Lumps::lump_conservative_x_A_x3_conjA_x2,
      &Lumps::lump_dissipative_x_conjA_x2_F, &Lumps::lump_conservative_x_conjA_x2_F_of_subharmonic_3_second_order,
      &Lumps::lump_conservative_x_conjA_x2_F_sigma, &Lumps::lump_conservative_x_conjA_x2_F3,
      &Lumps::lump_harmonic_re_x_F, &Lumps::lump_harmonic_im_x_F3, &Lumps::lump_harmonic_re_x_F5,
      &Lumps::lump_harmonic_re_x_A_x_conjA_x_F_of_subharmonic_3_second_order,
      &Lumps::lump_harmonic_re_x_A_x3_of_subharmonic_3_second_order, &Lumps::lump_harmonic_re_x_A_x2_F2,
      &Lumps::lump_harmonic_im_x_conjA_x_F, &Lumps::lump_harmonic_re_x_conjA_x_F3,
      &Lumps::lump_harmonic_re_x_A_x_conjA_x2_F, &Lumps::lump_harmonic_im_x_A_x2,
      &Lumps::lump_harmonic_re_x_A_x3_conjA_x, &Lumps::lump_harmonic_re_x_conjA_x_F2,
      &Lumps::lump_harmonic_im_x_conjA_x_F2, &Lumps::lump_harmonic_re_x_F4, &Lumps::lump_harmonic_im_x_F2};
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

}  // namespace secular::generated::duffing
