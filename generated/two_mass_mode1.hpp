// Model two_mass_mode1: generated code, never edited by hand.
// Source: S. O'F. Fahey, dissertation, Virginia Tech, 2000, Eqs. (5.1)-(5.5)
// Equation of motion: 0 = omega0^2*v + delta3*v*D(v)^2 + 2*delta2*v*D2(v) - eta2*v*F*cos(Omega*t) + alpha2*v^2
// + delta3*v^2*D2(v) + alpha3*v^3 + 2*mu1*D(v) + mu2*D(v)*abs(D(v)) + delta2*D(v)^2 + mu3*D(v)^3 + D2(v) -
// eta1*F*cos(Omega*t)
// Case principal_parametric: Omega = 2*omega0 + eps^2*sigma, multiple scales to eps^2. Valid near that
// resonance for small amplitudes; what is left out is of order eps^3.
// Case free: free vibration, multiple scales to eps^2. Valid near that resonance for small amplitudes; what is
// left out is of order eps^3.
// Case primary: Omega = omega0 + eps^2*sigma, multiple scales to eps^2. Valid near that resonance for small
// amplitudes; what is left out is of order eps^3.
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// Made by: secular generate two_mass_mode1
#pragma once

#include <cstddef>
#include <numbers>

#include "estimator/model/batch_arrays.hpp"
#include "estimator/model/complex_number.hpp"
#include "estimator/model/dense_solve.hpp"
#include "estimator/model/dual_number.hpp"
#include "estimator/model/excitation_sample.hpp"
#include "estimator/model/integer_power.hpp"
#include "estimator/model/lane_functions.hpp"
#include "estimator/model/scalar_functions.hpp"

namespace secular::generated::two_mass_mode1 {

/// Mass matrix M of the equations of motion M*acceleration + force = 0 below, state-dependent: mass[k * 1 + j]
/// multiplies the acceleration of mode j in equation k. 6 operations.
template <class Scalar, class Parameter, class Sample>
void mass_matrix([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* mass) {
  const Scalar delta2 = parameters[6];
  const Scalar delta3 = parameters[7];
  mass[0] = Scalar(2.0) * delta2 * displacement[0] + delta3 * displacement[0] * displacement[0] + Scalar(1.0);
}

/// Accelerations of the full equations of motion, solved from the state-dependent mass matrix.
/// 0 = omega0^2*v + delta3*v*D(v)^2 + 2*delta2*v*D2(v) - eta2*v*F*cos(Omega*t) + alpha2*v^2 + delta3*v^2*D2(v) +
/// alpha3*v^3 + 2*mu1*D(v) + mu2*D(v)*abs(D(v)) + delta2*D(v)^2 + mu3*D(v)^3 + D2(v) - eta1*F*cos(Omega*t)
/// parameters: [0] omega0, [1] mu1, [2] mu2, [3] mu3, [4] alpha2, [5] alpha3, [6] delta2, [7] delta3, [8] eta1,
/// [9] eta2. displacement, velocity, acceleration: 1 values. 31 operations.
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
      - eta2 * displacement[0] * Scalar(excitation[0].value) + alpha2 * displacement[0] * displacement[0]
      + alpha3 * displacement[0] * displacement[0] * displacement[0] + Scalar(2.0) * mu1 * velocity[0]
      + mu2 * velocity[0] * absolute(velocity[0]) + delta2 * velocity[0] * velocity[0]
      + mu3 * velocity[0] * velocity[0] * velocity[0] - eta1 * Scalar(excitation[0].value));
  Scalar mass[1];
  mass_matrix(parameters, excitation, displacement, velocity, mass);
  acceleration[0] = acceleration[0] / mass[0];
}

/// slope[k * 2 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = v, D(v). Of
/// nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x) = 0. 37
/// operations before the solution of 2 right sides.
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
  for (std::size_t i = 0; i < 2; ++i) slope[i] = Scalar(0.0);
  // equation 1 by v
  slope[0] = -(omega0_2 + delta3 * velocity[0] * velocity[0] + Scalar(2.0) * delta2 * acceleration[0]
      - eta2 * Scalar(excitation[0].value) + alpha2 * displacement[0] * Scalar(2.0)
      + delta3 * displacement[0] * Scalar(2.0) * acceleration[0]
      + alpha3 * displacement[0] * displacement[0] * Scalar(3.0));
  // equation 1 by D(v)
  slope[1] = -(delta3 * displacement[0] * velocity[0] * Scalar(2.0) + Scalar(2.0) * mu1
      + mu2 * absolute(velocity[0]) + mu2 * velocity[0] * sign_of(velocity[0]) + delta2 * velocity[0] * Scalar(2.0)
      + mu3 * velocity[0] * velocity[0] * Scalar(3.0));
  Scalar mass[1];
  mass_matrix(parameters, excitation, displacement, velocity, mass);
  for (std::size_t i = 0; i < 2; ++i) slope[i] = slope[i] / mass[0];
}

/// slope[k * 10 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = omega0, mu1, mu2,
/// mu3, alpha2, alpha3, delta2, delta3, eta1, eta2. Of nonsmooth terms the classical derivative: d|x| = sgn(x)
/// dx, zero at the corner, and d sgn(x) = 0. 21 operations before the solution of 10 right sides.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_parameters([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  Scalar acceleration[1];
  accelerations(parameters, excitation, displacement, velocity, acceleration);
  const Scalar omega0 = parameters[0];
  for (std::size_t i = 0; i < 10; ++i) slope[i] = Scalar(0.0);
  slope[0] = -(Scalar(2.0) * omega0 * displacement[0]);  // equation 1 by omega0
  slope[1] = -(Scalar(2.0) * velocity[0]);  // equation 1 by mu1
  slope[2] = -(velocity[0] * absolute(velocity[0]));  // equation 1 by mu2
  slope[3] = -(velocity[0] * velocity[0] * velocity[0]);  // equation 1 by mu3
  slope[4] = -(displacement[0] * displacement[0]);  // equation 1 by alpha2
  slope[5] = -(displacement[0] * displacement[0] * displacement[0]);  // equation 1 by alpha3
  // equation 1 by delta2
  slope[6] = -(Scalar(2.0) * displacement[0] * acceleration[0] + velocity[0] * velocity[0]);
  // equation 1 by delta3
  slope[7] = -(displacement[0] * velocity[0] * velocity[0] + displacement[0] * displacement[0] * acceleration[0]);
  slope[8] = -(-Scalar(1.0) * Scalar(excitation[0].value));  // equation 1 by eta1
  slope[9] = -(-Scalar(1.0) * displacement[0] * Scalar(excitation[0].value));  // equation 1 by eta2
  Scalar mass[1];
  mass_matrix(parameters, excitation, displacement, velocity, mass);
  for (std::size_t i = 0; i < 10; ++i) slope[i] = slope[i] / mass[0];
}

namespace principal_parametric {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: mu1 = mu1
/// lumps[1]: mu2 = mu2
/// lumps[2]: mu3 = mu3
/// lumps[3]: alpha_e = (6*omega0^4*delta2^2 - 6*omega0^4*delta3 + 12*omega0^2*alpha2*delta2 + 9*omega0^2*alpha3
/// - 10*alpha2^2)/(24*omega0^2)
/// lumps[4]: eta_e = (-6*omega0^2*delta2*eta1 + 3*omega0^2*eta2 + 2*alpha2*eta1)/(12*omega0^2)
/// lumps[5]: alpha_0 = -omega0^2*delta2 + alpha2
/// lumps[6]: eta1 = eta1
/// lumps[7]: alpha_q = -3*omega0^2*delta2 + alpha2
/// lumps[8]: harmonic_re_v_A_v_F = (14*omega0^2*delta2*eta1 - 3*omega0^2*eta2 - 2*alpha2*eta1)/(48*omega0^4)
/// lumps[9]: harmonic_re_v_A_v3 = (42*omega0^4*delta2^2 - 6*omega0^4*delta3 - 20*omega0^2*alpha2*delta2 +
/// 3*omega0^2*alpha3 + 2*alpha2^2)/(24*omega0^4)
/// 59 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
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
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar alpha2_2 = alpha2 * alpha2;
  const Scalar delta2_2 = delta2 * delta2;
  lumps[0] = mu1;  // mu1
  lumps[1] = mu2;  // mu2
  lumps[2] = mu3;  // mu3
  // alpha_e
  lumps[3] = (Scalar(6.0) * omega0_4 * delta2_2 - Scalar(6.0) * omega0_4 * delta3
      + Scalar(12.0) * omega0_2 * alpha2 * delta2 + Scalar(9.0) * omega0_2 * alpha3
      - Scalar(10.0) * alpha2_2) / (Scalar(24.0) * omega0_2);
  // eta_e
  lumps[4] = (-Scalar(6.0) * omega0_2 * delta2 * eta1 + Scalar(3.0) * omega0_2 * eta2
      + Scalar(2.0) * alpha2 * eta1) / (Scalar(12.0) * omega0_2);
  lumps[5] = -omega0_2 * delta2 + alpha2;  // alpha_0
  lumps[6] = eta1;  // eta1
  lumps[7] = -Scalar(3.0) * omega0_2 * delta2 + alpha2;  // alpha_q
  // harmonic_re_v_A_v_F
  lumps[8] = (Scalar(14.0) * omega0_2 * delta2 * eta1 - Scalar(3.0) * omega0_2 * eta2
      - Scalar(2.0) * alpha2 * eta1) / (Scalar(48.0) * omega0_4);
  // harmonic_re_v_A_v3
  lumps[9] = (Scalar(42.0) * omega0_4 * delta2_2 - Scalar(6.0) * omega0_4 * delta3
      - Scalar(20.0) * omega0_2 * alpha2 * delta2 + Scalar(3.0) * omega0_2 * alpha3
      + Scalar(2.0) * alpha2_2) / (Scalar(24.0) * omega0_4);
}

/// jacobian[l * 10 + p] = d lumps[l] / d parameters[p]. 84 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  const Scalar omega0 = parameters[0];
  const Scalar alpha2 = parameters[4];
  const Scalar alpha3 = parameters[5];
  const Scalar delta2 = parameters[6];
  const Scalar delta3 = parameters[7];
  const Scalar eta1 = parameters[8];
  const Scalar eta2 = parameters[9];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar omega0_5 = omega0_4 * omega0;
  const Scalar alpha2_2 = alpha2 * alpha2;
  const Scalar delta2_2 = delta2 * delta2;
  for (std::size_t i = 0; i < 100; ++i) jacobian[i] = Scalar(0.0);
  jacobian[1] = Scalar(1.0);  // d mu1 / d mu1
  jacobian[12] = Scalar(1.0);  // d mu2 / d mu2
  jacobian[23] = Scalar(1.0);  // d mu3 / d mu3
  // d alpha_e / d omega0
  jacobian[30] = (Scalar(3.0) * omega0_4 * delta2_2 - Scalar(3.0) * omega0_4 * delta3
      + Scalar(5.0) * alpha2_2) / (Scalar(6.0) * omega0_3);
  // d alpha_e / d alpha2
  jacobian[34] = (Scalar(3.0) * omega0_2 * delta2 - Scalar(5.0) * alpha2) / (Scalar(6.0) * omega0_2);
  jacobian[35] = Scalar(3.0) / Scalar(8.0);  // d alpha_e / d alpha3
  jacobian[36] = (omega0_2 * delta2 + alpha2) / Scalar(2.0);  // d alpha_e / d delta2
  jacobian[37] = -omega0_2 / Scalar(4.0);  // d alpha_e / d delta3
  jacobian[40] = -alpha2 * eta1 / (Scalar(3.0) * omega0_3);  // d eta_e / d omega0
  jacobian[44] = eta1 / (Scalar(6.0) * omega0_2);  // d eta_e / d alpha2
  jacobian[46] = -eta1 / Scalar(2.0);  // d eta_e / d delta2
  jacobian[48] = (-Scalar(3.0) * omega0_2 * delta2 + alpha2) / (Scalar(6.0) * omega0_2);  // d eta_e / d eta1
  jacobian[49] = Scalar(1.0) / Scalar(4.0);  // d eta_e / d eta2
  jacobian[50] = -Scalar(2.0) * omega0 * delta2;  // d alpha_0 / d omega0
  jacobian[54] = Scalar(1.0);  // d alpha_0 / d alpha2
  jacobian[56] = -omega0_2;  // d alpha_0 / d delta2
  jacobian[68] = Scalar(1.0);  // d eta1 / d eta1
  jacobian[70] = -Scalar(6.0) * omega0 * delta2;  // d alpha_q / d omega0
  jacobian[74] = Scalar(1.0);  // d alpha_q / d alpha2
  jacobian[76] = -Scalar(3.0) * omega0_2;  // d alpha_q / d delta2
  // d harmonic_re_v_A_v_F / d omega0
  jacobian[80] = (-Scalar(14.0) * omega0_2 * delta2 * eta1 + Scalar(3.0) * omega0_2 * eta2
      + Scalar(4.0) * alpha2 * eta1) / (Scalar(24.0) * omega0_5);
  jacobian[84] = -eta1 / (Scalar(24.0) * omega0_4);  // d harmonic_re_v_A_v_F / d alpha2
  jacobian[86] = Scalar(7.0) * eta1 / (Scalar(24.0) * omega0_2);  // d harmonic_re_v_A_v_F / d delta2
  // d harmonic_re_v_A_v_F / d eta1
  jacobian[88] = (Scalar(7.0) * omega0_2 * delta2 - alpha2) / (Scalar(24.0) * omega0_4);
  jacobian[89] = -Scalar(1.0) / (Scalar(16.0) * omega0_2);  // d harmonic_re_v_A_v_F / d eta2
  // d harmonic_re_v_A_v3 / d omega0
  jacobian[90] = (Scalar(20.0) * omega0_2 * alpha2 * delta2 - Scalar(3.0) * omega0_2 * alpha3
      - Scalar(4.0) * alpha2_2) / (Scalar(12.0) * omega0_5);
  // d harmonic_re_v_A_v3 / d alpha2
  jacobian[94] = (-Scalar(5.0) * omega0_2 * delta2 + alpha2) / (Scalar(6.0) * omega0_4);
  jacobian[95] = Scalar(1.0) / (Scalar(8.0) * omega0_2);  // d harmonic_re_v_A_v3 / d alpha3
  // d harmonic_re_v_A_v3 / d delta2
  jacobian[96] = (Scalar(21.0) * omega0_2 * delta2 - Scalar(5.0) * alpha2) / (Scalar(6.0) * omega0_2);
  jacobian[97] = -Scalar(1.0) / Scalar(4.0);  // d harmonic_re_v_A_v3 / d delta3
}

/// What multiplies the 5 terms of the modulation of v: functions of the frequencies alone. 8 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar pi = Scalar(std::numbers::pi);
  const Scalar omega0_2 = omega0 * omega0;
  factor[0] = -Scalar(1.0);
  factor[1] = -Scalar(8.0) * omega0 / (Scalar(3.0) * pi);
  factor[2] = -Scalar(3.0) * omega0_2 / Scalar(2.0);
  factor[3] = Scalar(4.0) / omega0;
  factor[4] = -Scalar(1.0) / omega0;
}

/// Rows of the modulation of v: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega0)*A_v = -mu1*A_v - 8*omega0/(3*Pi)*mu2*A_v*abs(A_v) - 3*omega0^2/2*mu3*A_v^2*conj(A_v) +
/// 4/omega0*i*alpha_e*A_v^2*conj(A_v) - 1/omega0*i*eta_e*conj(A_v)*F
/// 5 columns; per observation at most 13 products and sums of complex numbers.
template <class Factors>
void rows_0(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar* __restrict column_4 = columns[4];
  Scalar factor[5];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v = load_complex(amplitude_0, i);
    const Complex conj_A_v = conjugate(A_v);
    const Scalar norm_A_v = norm_of(A_v);
    const Scalar abs_A_v = modulus_of(A_v);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v));  // mu1
    store_complex(column_1, i, factor[1] * (abs_A_v * A_v));  // mu2
    store_complex(column_2, i, factor[2] * (norm_A_v * A_v));  // mu3
    store_complex(column_3, i, times_i(factor[3] * (norm_A_v * A_v)));  // alpha_e
    store_complex(column_4, i, times_i(factor[4] * (conj_A_v * F)));  // eta_e
  }
}

/// columns[j][i] of the rows.
inline void columns_0(const BatchArrays& data, double* const* columns) {
  rows_0(data, FactorValues<factors_0<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_0(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_0(data, FactorSlopes<factors_0<DualNumber>, 1, 1, 5>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 0 of v: functions of the frequencies alone. 2 operations.
template <class Scalar>
void factors_1([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  factor[0] = -Scalar(2.0) / omega0_2;
}

/// Rows of the harmonic 0 of v: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in v = -2/omega0^2*alpha_0*A_v*conj(A_v)
/// 1 columns; per observation at most 1 products and sums of complex numbers.
template <class Factors>
void rows_1(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v = load_complex(amplitude_0, i);
    const Scalar norm_A_v = norm_of(A_v);
    store_complex(column_0, i, Complex(factor[0] * (norm_A_v)));  // alpha_0
  }
}

/// columns[j][i] of the rows.
inline void columns_1(const BatchArrays& data, double* const* columns) {
  rows_1(data, FactorValues<factors_1<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_1(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_1(data, FactorSlopes<factors_1<DualNumber>, 1, 1, 1>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic Omega of v: functions of the frequencies alone. 9 operations.
template <class Scalar>
void factors_2([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar per_0 = Scalar(1.0) / (omega0 + Omega);
  const Scalar per_1 = Scalar(1.0) / (omega0 - Omega);
  factor[0] = per_0 * per_1 / Scalar(2.0);
  factor[1] = Scalar(1.0) / (Scalar(3.0) * omega0_2);
}

/// Rows of the harmonic Omega of v: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(Omega)*t) in v = 1/(2*(omega0 + Omega)*(omega0 - Omega))*eta1*F +
/// 1/(3*omega0^2)*alpha_q*A_v^2
/// 2 columns; per observation at most 4 products and sums of complex numbers.
template <class Factors>
void rows_2(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_v = load_complex(amplitude_0, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (F));  // eta1
    store_complex(column_1, i, factor[1] * (A_v * A_v));  // alpha_q
  }
}

/// columns[j][i] of the rows.
inline void columns_2(const BatchArrays& data, double* const* columns) {
  rows_2(data, FactorValues<factors_2<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_2(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_2(data, FactorSlopes<factors_2<DualNumber>, 1, 1, 2>{mode}, columns);
}

/// What multiplies the 4 terms of the harmonic omega0+Omega of v: functions of the frequencies alone. 3
/// operations.
template <class Scalar>
void factors_3([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar pi = Scalar(std::numbers::pi);
  factor[0] = -Scalar(2.0) / (Scalar(15.0) * pi);
  factor[1] = -omega0 / Scalar(8.0);
  factor[2] = Scalar(1.0);
  factor[3] = Scalar(1.0);
}

/// Rows of the harmonic omega0+Omega of v: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega0 + Omega)*t) in v = -2/(15*Pi)*i*mu2*A_v^3*abs(A_v)^-1 - omega0/8*i*mu3*A_v^3 +
/// harmonic_re_v_A_v_F*A_v*F + harmonic_re_v_A_v3*A_v^3
/// 4 columns; per observation at most 18 products and sums of complex numbers.
template <class Factors>
void rows_3(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v = load_complex(amplitude_0, i);
    const Scalar abs_A_v = modulus_of(A_v);
    const Scalar inverse_abs_A_v = inverse_or_zero(abs_A_v);
    const Complex unit_A_v = inverse_abs_A_v * A_v;
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, times_i(factor[0] * (unit_A_v * A_v * A_v)));  // mu2
    store_complex(column_1, i, times_i(factor[1] * (A_v * A_v * A_v)));  // mu3
    store_complex(column_2, i, factor[2] * (A_v * F));  // harmonic_re_v_A_v_F
    store_complex(column_3, i, factor[3] * (A_v * A_v * A_v));  // harmonic_re_v_A_v3
  }
}

/// columns[j][i] of the rows.
inline void columns_3(const BatchArrays& data, double* const* columns) {
  rows_3(data, FactorValues<factors_3<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_3(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_3(data, FactorSlopes<factors_3<DualNumber>, 1, 1, 4>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 5*omega0 of v: functions of the frequencies alone. 2 operations.
template <class Scalar>
void factors_4([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar pi = Scalar(std::numbers::pi);
  factor[0] = -Scalar(2.0) / (Scalar(315.0) * pi);
}

/// Rows of the harmonic 5*omega0 of v: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(5*omega0)*t) in v = -2/(315*Pi)*i*mu2*A_v^5*abs(A_v)^-3
/// 1 columns; per observation at most 9 products and sums of complex numbers.
template <class Factors>
void rows_4(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v = load_complex(amplitude_0, i);
    const Scalar abs_A_v = modulus_of(A_v);
    const Scalar inverse_abs_A_v = inverse_or_zero(abs_A_v);
    const Complex unit_A_v = inverse_abs_A_v * A_v;
    store_complex(column_0, i, times_i(factor[0] * (unit_A_v * unit_A_v * unit_A_v * A_v * A_v)));  // mu2
  }
}

/// columns[j][i] of the rows.
inline void columns_4(const BatchArrays& data, double* const* columns) {
  rows_4(data, FactorValues<factors_4<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_4(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic 7*omega0 of v: functions of the frequencies alone. 2 operations.
template <class Scalar>
void factors_5([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar pi = Scalar(std::numbers::pi);
  factor[0] = -Scalar(1.0) / (Scalar(945.0) * pi);
}

/// Rows of the harmonic 7*omega0 of v: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(7*omega0)*t) in v = -1/(945*Pi)*i*mu2*A_v^7*abs(A_v)^-5
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_5(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v = load_complex(amplitude_0, i);
    const Scalar abs_A_v = modulus_of(A_v);
    const Scalar inverse_abs_A_v = inverse_or_zero(abs_A_v);
    const Complex unit_A_v = inverse_abs_A_v * A_v;
    store_complex(column_0, i, times_i(factor[0] * (fixed_power<5>(unit_A_v) * A_v * A_v)));  // mu2
  }
}

/// columns[j][i] of the rows.
inline void columns_5(const BatchArrays& data, double* const* columns) {
  rows_5(data, FactorValues<factors_5<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_5(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic 9*omega0 of v: functions of the frequencies alone. 2 operations.
template <class Scalar>
void factors_6([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar pi = Scalar(std::numbers::pi);
  factor[0] = -Scalar(1.0) / (Scalar(3465.0) * pi);
}

/// Rows of the harmonic 9*omega0 of v: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(9*omega0)*t) in v = -1/(3465*Pi)*i*mu2*A_v^9*abs(A_v)^-7
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_6(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v = load_complex(amplitude_0, i);
    const Scalar abs_A_v = modulus_of(A_v);
    const Scalar inverse_abs_A_v = inverse_or_zero(abs_A_v);
    const Complex unit_A_v = inverse_abs_A_v * A_v;
    store_complex(column_0, i, times_i(factor[0] * (fixed_power<7>(unit_A_v) * A_v * A_v)));  // mu2
  }
}

/// columns[j][i] of the rows.
inline void columns_6(const BatchArrays& data, double* const* columns) {
  rows_6(data, FactorValues<factors_6<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_6(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_v/dt + i*(w_v - omega0)*B_v = -mu1*A_v - 8*omega0/(3*Pi)*mu2*A_v*abs(A_v) -
/// 3*omega0^2/2*mu3*A_v^2*conj(A_v) + 4/omega0*i*alpha_e*A_v^2*conj(A_v) - 1/omega0*i*eta_e*conj(A_v)*F with A =
/// B in that frame
/// 30 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega0 = parameters[0];
  const Scalar pi = Scalar(std::numbers::pi);
  const Scalar omega0_2 = omega0 * omega0;
  Scalar lumps[10];
  evaluate_lumps(parameters, lumps);
  const Complex A_v = load_complex(amplitude, 0);
  const Complex conj_A_v = conjugate(A_v);
  const Scalar norm_A_v = norm_of(A_v);
  const Scalar abs_A_v = modulus_of(A_v);
  const Complex F = load_complex(forcing, 0);
  store_complex(derivative, 0, lumps[0] * (-Scalar(1.0)) * (A_v)
       + lumps[1] * (-Scalar(8.0) * omega0 / (Scalar(3.0) * pi)) * (abs_A_v * A_v)
       + lumps[2] * (-Scalar(3.0) * omega0_2 / Scalar(2.0)) * (norm_A_v * A_v)
       + times_i(lumps[3] * Scalar(4.0) / omega0 * (norm_A_v * A_v))
       + times_i(lumps[4] * (-Scalar(1.0) / omega0) * (conj_A_v * F))
       - times_i((-omega0 + excitation_frequency[0] / Scalar(2.0)) * A_v));
}

/// jacobian[i * 2 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 49 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega0 = parameters[0];
  const Scalar pi = Scalar(std::numbers::pi);
  const Scalar omega0_2 = omega0 * omega0;
  Scalar lumps[10];
  evaluate_lumps(parameters, lumps);
  const Complex A_v = load_complex(amplitude, 0);
  const Scalar norm_A_v = norm_of(A_v);
  const Scalar abs_A_v = modulus_of(A_v);
  const Scalar inverse_abs_A_v = inverse_or_zero(abs_A_v);
  const Complex unit_A_v = inverse_abs_A_v * A_v;
  const Complex F = load_complex(forcing, 0);
  for (std::size_t i = 0; i < 4; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = Complex(lumps[0] * (-Scalar(1.0)))
       + Complex(lumps[1] * (-Scalar(8.0) * omega0 / (Scalar(3.0) * pi)) * Scalar(1.5) * (abs_A_v))
       + Complex(lumps[2] * (-Scalar(3.0) * omega0_2 / Scalar(2.0)) * Scalar(2) * (norm_A_v))
       + times_i(Complex(lumps[3] * Scalar(4.0) / omega0 * Scalar(2) * (norm_A_v)))
       - Complex(Scalar(0.0), -omega0 + excitation_frequency[0] / Scalar(2.0));
  const Complex conj_by_0_0 = lumps[1] * (-Scalar(8.0) * omega0 / (Scalar(3.0) * pi)) * Scalar(0.5) * (unit_A_v
      * A_v)
       + lumps[2] * (-Scalar(3.0) * omega0_2 / Scalar(2.0)) * (A_v * A_v)
       + times_i(lumps[3] * Scalar(4.0) / omega0 * (A_v * A_v))
       + times_i(lumps[4] * (-Scalar(1.0) / omega0) * (F));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[2] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[3] = by_0_0.real - conj_by_0_0.real;
}

}  // namespace principal_parametric

namespace free {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: mu1 = mu1
/// lumps[1]: mu2 = mu2
/// lumps[2]: mu3 = mu3
/// lumps[3]: alpha_e = (6*omega0^4*delta2^2 - 6*omega0^4*delta3 + 12*omega0^2*alpha2*delta2 + 9*omega0^2*alpha3
/// - 10*alpha2^2)/(24*omega0^2)
/// lumps[4]: alpha_0 = -omega0^2*delta2 + alpha2
/// lumps[5]: alpha_q = -3*omega0^2*delta2 + alpha2
/// lumps[6]: harmonic_re_v_A_v3 = (42*omega0^4*delta2^2 - 6*omega0^4*delta3 - 20*omega0^2*alpha2*delta2 +
/// 3*omega0^2*alpha3 + 2*alpha2^2)/(24*omega0^4)
/// 37 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
  const Scalar omega0 = parameters[0];
  const Scalar mu1 = parameters[1];
  const Scalar mu2 = parameters[2];
  const Scalar mu3 = parameters[3];
  const Scalar alpha2 = parameters[4];
  const Scalar alpha3 = parameters[5];
  const Scalar delta2 = parameters[6];
  const Scalar delta3 = parameters[7];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar alpha2_2 = alpha2 * alpha2;
  const Scalar delta2_2 = delta2 * delta2;
  lumps[0] = mu1;  // mu1
  lumps[1] = mu2;  // mu2
  lumps[2] = mu3;  // mu3
  // alpha_e
  lumps[3] = (Scalar(6.0) * omega0_4 * delta2_2 - Scalar(6.0) * omega0_4 * delta3
      + Scalar(12.0) * omega0_2 * alpha2 * delta2 + Scalar(9.0) * omega0_2 * alpha3
      - Scalar(10.0) * alpha2_2) / (Scalar(24.0) * omega0_2);
  lumps[4] = -omega0_2 * delta2 + alpha2;  // alpha_0
  lumps[5] = -Scalar(3.0) * omega0_2 * delta2 + alpha2;  // alpha_q
  // harmonic_re_v_A_v3
  lumps[6] = (Scalar(42.0) * omega0_4 * delta2_2 - Scalar(6.0) * omega0_4 * delta3
      - Scalar(20.0) * omega0_2 * alpha2 * delta2 + Scalar(3.0) * omega0_2 * alpha3
      + Scalar(2.0) * alpha2_2) / (Scalar(24.0) * omega0_4);
}

/// jacobian[l * 10 + p] = d lumps[l] / d parameters[p]. 49 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  const Scalar omega0 = parameters[0];
  const Scalar alpha2 = parameters[4];
  const Scalar alpha3 = parameters[5];
  const Scalar delta2 = parameters[6];
  const Scalar delta3 = parameters[7];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar omega0_5 = omega0_4 * omega0;
  const Scalar alpha2_2 = alpha2 * alpha2;
  const Scalar delta2_2 = delta2 * delta2;
  for (std::size_t i = 0; i < 70; ++i) jacobian[i] = Scalar(0.0);
  jacobian[1] = Scalar(1.0);  // d mu1 / d mu1
  jacobian[12] = Scalar(1.0);  // d mu2 / d mu2
  jacobian[23] = Scalar(1.0);  // d mu3 / d mu3
  // d alpha_e / d omega0
  jacobian[30] = (Scalar(3.0) * omega0_4 * delta2_2 - Scalar(3.0) * omega0_4 * delta3
      + Scalar(5.0) * alpha2_2) / (Scalar(6.0) * omega0_3);
  // d alpha_e / d alpha2
  jacobian[34] = (Scalar(3.0) * omega0_2 * delta2 - Scalar(5.0) * alpha2) / (Scalar(6.0) * omega0_2);
  jacobian[35] = Scalar(3.0) / Scalar(8.0);  // d alpha_e / d alpha3
  jacobian[36] = (omega0_2 * delta2 + alpha2) / Scalar(2.0);  // d alpha_e / d delta2
  jacobian[37] = -omega0_2 / Scalar(4.0);  // d alpha_e / d delta3
  jacobian[40] = -Scalar(2.0) * omega0 * delta2;  // d alpha_0 / d omega0
  jacobian[44] = Scalar(1.0);  // d alpha_0 / d alpha2
  jacobian[46] = -omega0_2;  // d alpha_0 / d delta2
  jacobian[50] = -Scalar(6.0) * omega0 * delta2;  // d alpha_q / d omega0
  jacobian[54] = Scalar(1.0);  // d alpha_q / d alpha2
  jacobian[56] = -Scalar(3.0) * omega0_2;  // d alpha_q / d delta2
  // d harmonic_re_v_A_v3 / d omega0
  jacobian[60] = (Scalar(20.0) * omega0_2 * alpha2 * delta2 - Scalar(3.0) * omega0_2 * alpha3
      - Scalar(4.0) * alpha2_2) / (Scalar(12.0) * omega0_5);
  // d harmonic_re_v_A_v3 / d alpha2
  jacobian[64] = (-Scalar(5.0) * omega0_2 * delta2 + alpha2) / (Scalar(6.0) * omega0_4);
  jacobian[65] = Scalar(1.0) / (Scalar(8.0) * omega0_2);  // d harmonic_re_v_A_v3 / d alpha3
  // d harmonic_re_v_A_v3 / d delta2
  jacobian[66] = (Scalar(21.0) * omega0_2 * delta2 - Scalar(5.0) * alpha2) / (Scalar(6.0) * omega0_2);
  jacobian[67] = -Scalar(1.0) / Scalar(4.0);  // d harmonic_re_v_A_v3 / d delta3
}

/// What multiplies the 4 terms of the modulation of v: functions of the frequencies alone. 7 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar pi = Scalar(std::numbers::pi);
  const Scalar omega0_2 = omega0 * omega0;
  factor[0] = -Scalar(1.0);
  factor[1] = -Scalar(8.0) * omega0 / (Scalar(3.0) * pi);
  factor[2] = -Scalar(3.0) * omega0_2 / Scalar(2.0);
  factor[3] = Scalar(4.0) / omega0;
}

/// Rows of the modulation of v: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega0)*A_v = -mu1*A_v - 8*omega0/(3*Pi)*mu2*A_v*abs(A_v) - 3*omega0^2/2*mu3*A_v^2*conj(A_v) +
/// 4/omega0*i*alpha_e*A_v^2*conj(A_v)
/// 4 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_0(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v = load_complex(amplitude_0, i);
    const Scalar norm_A_v = norm_of(A_v);
    const Scalar abs_A_v = modulus_of(A_v);
    store_complex(column_0, i, factor[0] * (A_v));  // mu1
    store_complex(column_1, i, factor[1] * (abs_A_v * A_v));  // mu2
    store_complex(column_2, i, factor[2] * (norm_A_v * A_v));  // mu3
    store_complex(column_3, i, times_i(factor[3] * (norm_A_v * A_v)));  // alpha_e
  }
}

/// columns[j][i] of the rows.
inline void columns_0(const BatchArrays& data, double* const* columns) {
  rows_0(data, FactorValues<factors_0<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_0(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_0(data, FactorSlopes<factors_0<DualNumber>, 1, 1, 4>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 2*omega0 of v: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_2([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  factor[0] = Scalar(1.0) / (Scalar(3.0) * omega0_2);
}

/// Rows of the harmonic 2*omega0 of v: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega0)*t) in v = 1/(3*omega0^2)*alpha_q*A_v^2
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_2(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v = load_complex(amplitude_0, i);
    store_complex(column_0, i, factor[0] * (A_v * A_v));  // alpha_q
  }
}

/// columns[j][i] of the rows.
inline void columns_2(const BatchArrays& data, double* const* columns) {
  rows_2(data, FactorValues<factors_2<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_2(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_2(data, FactorSlopes<factors_2<DualNumber>, 1, 1, 1>{mode}, columns);
}

/// What multiplies the 3 terms of the harmonic 3*omega0 of v: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_3([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar pi = Scalar(std::numbers::pi);
  factor[0] = -Scalar(2.0) / (Scalar(15.0) * pi);
  factor[1] = -omega0 / Scalar(8.0);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic 3*omega0 of v: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega0)*t) in v = -2/(15*Pi)*i*mu2*A_v^3*abs(A_v)^-1 - omega0/8*i*mu3*A_v^3 +
/// harmonic_re_v_A_v3*A_v^3
/// 3 columns; per observation at most 15 products and sums of complex numbers.
template <class Factors>
void rows_3(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[3];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v = load_complex(amplitude_0, i);
    const Scalar abs_A_v = modulus_of(A_v);
    const Scalar inverse_abs_A_v = inverse_or_zero(abs_A_v);
    const Complex unit_A_v = inverse_abs_A_v * A_v;
    store_complex(column_0, i, times_i(factor[0] * (unit_A_v * A_v * A_v)));  // mu2
    store_complex(column_1, i, times_i(factor[1] * (A_v * A_v * A_v)));  // mu3
    store_complex(column_2, i, factor[2] * (A_v * A_v * A_v));  // harmonic_re_v_A_v3
  }
}

/// columns[j][i] of the rows.
inline void columns_3(const BatchArrays& data, double* const* columns) {
  rows_3(data, FactorValues<factors_3<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_3(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_3(data, FactorSlopes<factors_3<DualNumber>, 1, 1, 3>{mode}, columns);
}

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_v/dt + i*(w_v - omega0)*B_v = -mu1*A_v - 8*omega0/(3*Pi)*mu2*A_v*abs(A_v) -
/// 3*omega0^2/2*mu3*A_v^2*conj(A_v) + 4/omega0*i*alpha_e*A_v^2*conj(A_v) with A = B in that frame
/// 21 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega0 = parameters[0];
  const Scalar pi = Scalar(std::numbers::pi);
  const Scalar omega0_2 = omega0 * omega0;
  Scalar lumps[7];
  evaluate_lumps(parameters, lumps);
  const Complex A_v = load_complex(amplitude, 0);
  const Scalar norm_A_v = norm_of(A_v);
  const Scalar abs_A_v = modulus_of(A_v);
  store_complex(derivative, 0, lumps[0] * (-Scalar(1.0)) * (A_v)
       + lumps[1] * (-Scalar(8.0) * omega0 / (Scalar(3.0) * pi)) * (abs_A_v * A_v)
       + lumps[2] * (-Scalar(3.0) * omega0_2 / Scalar(2.0)) * (norm_A_v * A_v)
       + times_i(lumps[3] * Scalar(4.0) / omega0 * (norm_A_v * A_v)));
}

/// jacobian[i * 2 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 42 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega0 = parameters[0];
  const Scalar pi = Scalar(std::numbers::pi);
  const Scalar omega0_2 = omega0 * omega0;
  Scalar lumps[7];
  evaluate_lumps(parameters, lumps);
  const Complex A_v = load_complex(amplitude, 0);
  const Scalar norm_A_v = norm_of(A_v);
  const Scalar abs_A_v = modulus_of(A_v);
  const Scalar inverse_abs_A_v = inverse_or_zero(abs_A_v);
  const Complex unit_A_v = inverse_abs_A_v * A_v;
  for (std::size_t i = 0; i < 4; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = Complex(lumps[0] * (-Scalar(1.0)))
       + Complex(lumps[1] * (-Scalar(8.0) * omega0 / (Scalar(3.0) * pi)) * Scalar(1.5) * (abs_A_v))
       + Complex(lumps[2] * (-Scalar(3.0) * omega0_2 / Scalar(2.0)) * Scalar(2) * (norm_A_v))
       + times_i(Complex(lumps[3] * Scalar(4.0) / omega0 * Scalar(2) * (norm_A_v)));
  const Complex conj_by_0_0 = lumps[1] * (-Scalar(8.0) * omega0 / (Scalar(3.0) * pi)) * Scalar(0.5) * (unit_A_v
      * A_v)
       + lumps[2] * (-Scalar(3.0) * omega0_2 / Scalar(2.0)) * (A_v * A_v)
       + times_i(lumps[3] * Scalar(4.0) / omega0 * (A_v * A_v));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[2] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[3] = by_0_0.real - conj_by_0_0.real;
}

}  // namespace free

namespace primary {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: conservative_v_A_v2_F = (-3*omega0^2*delta2*eta2 + 5*alpha2*eta2)/(12*omega0^3)
/// lumps[1]: mu1 = mu1
/// lumps[2]: conservative_v_A_v_F2 = -eta2^2/(12*omega0^3)
/// lumps[3]: mu2 = mu2
/// lumps[4]: mu3 = mu3
/// lumps[5]: alpha_e = (6*omega0^4*delta2^2 - 6*omega0^4*delta3 + 12*omega0^2*alpha2*delta2 + 9*omega0^2*alpha3
/// - 10*alpha2^2)/(24*omega0^2)
/// lumps[6]: eta1 = eta1
/// lumps[7]: eta2 = eta2
/// lumps[8]: alpha_0 = -omega0^2*delta2 + alpha2
/// lumps[9]: alpha_q = -3*omega0^2*delta2 + alpha2
/// lumps[10]: harmonic_re_v_A_v2_F = (17*omega0^2*delta2*eta2 - 3*alpha2*eta2)/(48*omega0^4)
/// lumps[11]: harmonic_re_v_A_v3 = (42*omega0^4*delta2^2 - 6*omega0^4*delta3 - 20*omega0^2*alpha2*delta2 +
/// 3*omega0^2*alpha3 + 2*alpha2^2)/(24*omega0^4)
/// 55 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
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
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar alpha2_2 = alpha2 * alpha2;
  const Scalar delta2_2 = delta2 * delta2;
  const Scalar eta2_2 = eta2 * eta2;
  // conservative_v_A_v2_F
  lumps[0] = (-Scalar(3.0) * omega0_2 * delta2 * eta2 + Scalar(5.0) * alpha2 * eta2) / (Scalar(12.0) * omega0_3);
  lumps[1] = mu1;  // mu1
  lumps[2] = -eta2_2 / (Scalar(12.0) * omega0_3);  // conservative_v_A_v_F2
  lumps[3] = mu2;  // mu2
  lumps[4] = mu3;  // mu3
  // alpha_e
  lumps[5] = (Scalar(6.0) * omega0_4 * delta2_2 - Scalar(6.0) * omega0_4 * delta3
      + Scalar(12.0) * omega0_2 * alpha2 * delta2 + Scalar(9.0) * omega0_2 * alpha3
      - Scalar(10.0) * alpha2_2) / (Scalar(24.0) * omega0_2);
  lumps[6] = eta1;  // eta1
  lumps[7] = eta2;  // eta2
  lumps[8] = -omega0_2 * delta2 + alpha2;  // alpha_0
  lumps[9] = -Scalar(3.0) * omega0_2 * delta2 + alpha2;  // alpha_q
  // harmonic_re_v_A_v2_F
  lumps[10] = (Scalar(17.0) * omega0_2 * delta2 * eta2 - Scalar(3.0) * alpha2 * eta2) / (Scalar(48.0) * omega0_4);
  // harmonic_re_v_A_v3
  lumps[11] = (Scalar(42.0) * omega0_4 * delta2_2 - Scalar(6.0) * omega0_4 * delta3
      - Scalar(20.0) * omega0_2 * alpha2 * delta2 + Scalar(3.0) * omega0_2 * alpha3
      + Scalar(2.0) * alpha2_2) / (Scalar(24.0) * omega0_4);
}

/// jacobian[l * 10 + p] = d lumps[l] / d parameters[p]. 90 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  const Scalar omega0 = parameters[0];
  const Scalar alpha2 = parameters[4];
  const Scalar alpha3 = parameters[5];
  const Scalar delta2 = parameters[6];
  const Scalar delta3 = parameters[7];
  const Scalar eta2 = parameters[9];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar omega0_5 = omega0_4 * omega0;
  const Scalar alpha2_2 = alpha2 * alpha2;
  const Scalar delta2_2 = delta2 * delta2;
  const Scalar eta2_2 = eta2 * eta2;
  for (std::size_t i = 0; i < 120; ++i) jacobian[i] = Scalar(0.0);
  // d conservative_v_A_v2_F / d omega0
  jacobian[0] = (omega0_2 * delta2 * eta2 - Scalar(5.0) * alpha2 * eta2) / (Scalar(4.0) * omega0_4);
  jacobian[4] = Scalar(5.0) * eta2 / (Scalar(12.0) * omega0_3);  // d conservative_v_A_v2_F / d alpha2
  jacobian[6] = -eta2 / (Scalar(4.0) * omega0);  // d conservative_v_A_v2_F / d delta2
  // d conservative_v_A_v2_F / d eta2
  jacobian[9] = (-Scalar(3.0) * omega0_2 * delta2 + Scalar(5.0) * alpha2) / (Scalar(12.0) * omega0_3);
  jacobian[11] = Scalar(1.0);  // d mu1 / d mu1
  jacobian[20] = eta2_2 / (Scalar(4.0) * omega0_4);  // d conservative_v_A_v_F2 / d omega0
  jacobian[29] = -eta2 / (Scalar(6.0) * omega0_3);  // d conservative_v_A_v_F2 / d eta2
  jacobian[32] = Scalar(1.0);  // d mu2 / d mu2
  jacobian[43] = Scalar(1.0);  // d mu3 / d mu3
  // d alpha_e / d omega0
  jacobian[50] = (Scalar(3.0) * omega0_4 * delta2_2 - Scalar(3.0) * omega0_4 * delta3
      + Scalar(5.0) * alpha2_2) / (Scalar(6.0) * omega0_3);
  // d alpha_e / d alpha2
  jacobian[54] = (Scalar(3.0) * omega0_2 * delta2 - Scalar(5.0) * alpha2) / (Scalar(6.0) * omega0_2);
  jacobian[55] = Scalar(3.0) / Scalar(8.0);  // d alpha_e / d alpha3
  jacobian[56] = (omega0_2 * delta2 + alpha2) / Scalar(2.0);  // d alpha_e / d delta2
  jacobian[57] = -omega0_2 / Scalar(4.0);  // d alpha_e / d delta3
  jacobian[68] = Scalar(1.0);  // d eta1 / d eta1
  jacobian[79] = Scalar(1.0);  // d eta2 / d eta2
  jacobian[80] = -Scalar(2.0) * omega0 * delta2;  // d alpha_0 / d omega0
  jacobian[84] = Scalar(1.0);  // d alpha_0 / d alpha2
  jacobian[86] = -omega0_2;  // d alpha_0 / d delta2
  jacobian[90] = -Scalar(6.0) * omega0 * delta2;  // d alpha_q / d omega0
  jacobian[94] = Scalar(1.0);  // d alpha_q / d alpha2
  jacobian[96] = -Scalar(3.0) * omega0_2;  // d alpha_q / d delta2
  // d harmonic_re_v_A_v2_F / d omega0
  jacobian[100] = (-Scalar(17.0) * omega0_2 * delta2 * eta2
      + Scalar(6.0) * alpha2 * eta2) / (Scalar(24.0) * omega0_5);
  jacobian[104] = -eta2 / (Scalar(16.0) * omega0_4);  // d harmonic_re_v_A_v2_F / d alpha2
  jacobian[106] = Scalar(17.0) * eta2 / (Scalar(48.0) * omega0_2);  // d harmonic_re_v_A_v2_F / d delta2
  // d harmonic_re_v_A_v2_F / d eta2
  jacobian[109] = (Scalar(17.0) * omega0_2 * delta2 - Scalar(3.0) * alpha2) / (Scalar(48.0) * omega0_4);
  // d harmonic_re_v_A_v3 / d omega0
  jacobian[110] = (Scalar(20.0) * omega0_2 * alpha2 * delta2 - Scalar(3.0) * omega0_2 * alpha3
      - Scalar(4.0) * alpha2_2) / (Scalar(12.0) * omega0_5);
  // d harmonic_re_v_A_v3 / d alpha2
  jacobian[114] = (-Scalar(5.0) * omega0_2 * delta2 + alpha2) / (Scalar(6.0) * omega0_4);
  jacobian[115] = Scalar(1.0) / (Scalar(8.0) * omega0_2);  // d harmonic_re_v_A_v3 / d alpha3
  // d harmonic_re_v_A_v3 / d delta2
  jacobian[116] = (Scalar(21.0) * omega0_2 * delta2 - Scalar(5.0) * alpha2) / (Scalar(6.0) * omega0_2);
  jacobian[117] = -Scalar(1.0) / Scalar(4.0);  // d harmonic_re_v_A_v3 / d delta3
}

/// What multiplies the 9 terms of the modulation of v: functions of the frequencies alone. 10 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar pi = Scalar(std::numbers::pi);
  const Scalar omega0_2 = omega0 * omega0;
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(2.0);
  factor[2] = -Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(3.0) / Scalar(2.0);
  factor[5] = -Scalar(8.0) * omega0 / (Scalar(3.0) * pi);
  factor[6] = -Scalar(3.0) * omega0_2 / Scalar(2.0);
  factor[7] = Scalar(4.0) / omega0;
  factor[8] = -Scalar(1.0) / (Scalar(4.0) * omega0);
}

/// Rows of the modulation of v: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega0)*A_v = i*conservative_v_A_v2_F*A_v^2*F + 2*i*conservative_v_A_v2_F*A_v*conj(A_v)*F - mu1*A_v
/// + i*conservative_v_A_v_F2*A_v*F^2 + 3/2*i*conservative_v_A_v_F2*conj(A_v)*F^2 -
/// 8*omega0/(3*Pi)*mu2*A_v*abs(A_v) - 3*omega0^2/2*mu3*A_v^2*conj(A_v) + 4/omega0*i*alpha_e*A_v^2*conj(A_v) -
/// 1/(4*omega0)*i*eta1*F
/// 7 columns; per observation at most 29 products and sums of complex numbers.
template <class Factors>
void rows_0(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar* __restrict column_4 = columns[4];
  Scalar* __restrict column_5 = columns[5];
  Scalar* __restrict column_6 = columns[6];
  Scalar factor[9];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v = load_complex(amplitude_0, i);
    const Complex conj_A_v = conjugate(A_v);
    const Scalar norm_A_v = norm_of(A_v);
    const Scalar abs_A_v = modulus_of(A_v);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    const Scalar norm_F = norm_of(F);
    // conservative_v_A_v2_F
    store_complex(column_0, i, times_i(factor[0] * (A_v * A_v * conj_F)) + times_i(factor[1] * (norm_A_v * F)));
    store_complex(column_1, i, factor[2] * (A_v));  // mu1
    // conservative_v_A_v_F2
    store_complex(column_2, i, times_i(factor[3] * (A_v * norm_F)) + times_i(factor[4] * (conj_A_v * F * F)));
    store_complex(column_3, i, factor[5] * (abs_A_v * A_v));  // mu2
    store_complex(column_4, i, factor[6] * (norm_A_v * A_v));  // mu3
    store_complex(column_5, i, times_i(factor[7] * (norm_A_v * A_v)));  // alpha_e
    store_complex(column_6, i, times_i(factor[8] * (F)));  // eta1
  }
}

/// columns[j][i] of the rows.
inline void columns_0(const BatchArrays& data, double* const* columns) {
  rows_0(data, FactorValues<factors_0<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_0(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_0(data, FactorSlopes<factors_0<DualNumber>, 1, 1, 9>{mode}, columns);
}

/// What multiplies the 3 terms of the harmonic 0 of v: functions of the frequencies alone. 9 operations.
template <class Scalar>
void factors_1([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega0 - Omega);
  factor[0] = per_0 / (Scalar(2.0) * Omega);
  factor[1] = per_0 / (Scalar(2.0) * Omega);
  factor[2] = -Scalar(2.0) / omega0_2;
}

/// Rows of the harmonic 0 of v: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in v = 1/(2*Omega*(2*omega0 - Omega))*eta2*conj(A_v)*F + 1/(2*Omega*(2*omega0 -
/// Omega))*eta2*A_v*F - 2/omega0^2*alpha_0*A_v*conj(A_v)
/// 2 columns; per observation at most 8 products and sums of complex numbers.
template <class Factors>
void rows_1(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[3];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_v = load_complex(amplitude_0, i);
    const Complex conj_A_v = conjugate(A_v);
    const Scalar norm_A_v = norm_of(A_v);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    store_complex(column_0, i, factor[0] * (conj_A_v * F) + factor[1] * (A_v * conj_F));  // eta2
    store_complex(column_1, i, Complex(factor[2] * (norm_A_v)));  // alpha_0
  }
}

/// columns[j][i] of the rows.
inline void columns_1(const BatchArrays& data, double* const* columns) {
  rows_1(data, FactorValues<factors_1<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_1(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_1(data, FactorSlopes<factors_1<DualNumber>, 1, 1, 3>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic omega0+Omega of v: functions of the frequencies alone. 8
/// operations.
template <class Scalar>
void factors_2([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega0 + Omega);
  factor[0] = -per_0 / (Scalar(2.0) * Omega);
  factor[1] = Scalar(1.0) / (Scalar(3.0) * omega0_2);
}

/// Rows of the harmonic omega0+Omega of v: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega0 + Omega)*t) in v = -1/(2*Omega*(2*omega0 + Omega))*eta2*A_v*F +
/// 1/(3*omega0^2)*alpha_q*A_v^2
/// 2 columns; per observation at most 6 products and sums of complex numbers.
template <class Factors>
void rows_2(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_v = load_complex(amplitude_0, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v * F));  // eta2
    store_complex(column_1, i, factor[1] * (A_v * A_v));  // alpha_q
  }
}

/// columns[j][i] of the rows.
inline void columns_2(const BatchArrays& data, double* const* columns) {
  rows_2(data, FactorValues<factors_2<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_2(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_2(data, FactorSlopes<factors_2<DualNumber>, 1, 1, 2>{mode}, columns);
}

/// What multiplies the 5 terms of the harmonic omega0+2*Omega of v: functions of the frequencies alone. 5
/// operations.
template <class Scalar>
void factors_3([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar pi = Scalar(std::numbers::pi);
  factor[0] = -Scalar(1.0) / (Scalar(8.0) * omega0);
  factor[1] = -Scalar(2.0) / (Scalar(15.0) * pi);
  factor[2] = -omega0 / Scalar(8.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
}

/// Rows of the harmonic omega0+2*Omega of v: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega0 + 2*Omega)*t) in v = -1/(8*omega0)*conservative_v_A_v_F2*A_v*F^2 -
/// 2/(15*Pi)*i*mu2*A_v^3*abs(A_v)^-1 - omega0/8*i*mu3*A_v^3 + harmonic_re_v_A_v2_F*A_v^2*F +
/// harmonic_re_v_A_v3*A_v^3
/// 5 columns; per observation at most 25 products and sums of complex numbers.
template <class Factors>
void rows_3(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar* __restrict column_4 = columns[4];
  Scalar factor[5];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v = load_complex(amplitude_0, i);
    const Scalar abs_A_v = modulus_of(A_v);
    const Scalar inverse_abs_A_v = inverse_or_zero(abs_A_v);
    const Complex unit_A_v = inverse_abs_A_v * A_v;
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v * F * F));  // conservative_v_A_v_F2
    store_complex(column_1, i, times_i(factor[1] * (unit_A_v * A_v * A_v)));  // mu2
    store_complex(column_2, i, times_i(factor[2] * (A_v * A_v * A_v)));  // mu3
    store_complex(column_3, i, factor[3] * (A_v * A_v * F));  // harmonic_re_v_A_v2_F
    store_complex(column_4, i, factor[4] * (A_v * A_v * A_v));  // harmonic_re_v_A_v3
  }
}

/// columns[j][i] of the rows.
inline void columns_3(const BatchArrays& data, double* const* columns) {
  rows_3(data, FactorValues<factors_3<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_3(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_3(data, FactorSlopes<factors_3<DualNumber>, 1, 1, 5>{mode}, columns);
}

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_v/dt + i*(w_v - omega0)*B_v = i*conservative_v_A_v2_F*A_v^2*F + 2*i*conservative_v_A_v2_F*A_v*conj(A_v)*F
/// - mu1*A_v + i*conservative_v_A_v_F2*A_v*F^2 + 3/2*i*conservative_v_A_v_F2*conj(A_v)*F^2 -
/// 8*omega0/(3*Pi)*mu2*A_v*abs(A_v) - 3*omega0^2/2*mu3*A_v^2*conj(A_v) + 4/omega0*i*alpha_e*A_v^2*conj(A_v) -
/// 1/(4*omega0)*i*eta1*F with A = B in that frame
/// 46 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega0 = parameters[0];
  const Scalar pi = Scalar(std::numbers::pi);
  const Scalar omega0_2 = omega0 * omega0;
  Scalar lumps[12];
  evaluate_lumps(parameters, lumps);
  const Complex A_v = load_complex(amplitude, 0);
  const Complex conj_A_v = conjugate(A_v);
  const Scalar norm_A_v = norm_of(A_v);
  const Scalar abs_A_v = modulus_of(A_v);
  const Complex F = load_complex(forcing, 0);
  const Complex conj_F = conjugate(F);
  const Scalar norm_F = norm_of(F);
  store_complex(derivative, 0, times_i(lumps[0] * (A_v * A_v * conj_F))
       + times_i(lumps[0] * Scalar(2.0) * (norm_A_v * F))
       + lumps[1] * (-Scalar(1.0)) * (A_v)
       + times_i(lumps[2] * (A_v * norm_F))
       + times_i(lumps[2] * Scalar(3.0) / Scalar(2.0) * (conj_A_v * F * F))
       + lumps[3] * (-Scalar(8.0) * omega0 / (Scalar(3.0) * pi)) * (abs_A_v * A_v)
       + lumps[4] * (-Scalar(3.0) * omega0_2 / Scalar(2.0)) * (norm_A_v * A_v)
       + times_i(lumps[5] * Scalar(4.0) / omega0 * (norm_A_v * A_v))
       + times_i(lumps[6] * (-Scalar(1.0) / (Scalar(4.0) * omega0)) * (F))
       - times_i((-omega0 + excitation_frequency[0]) * A_v));
}

/// jacobian[i * 2 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 63 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega0 = parameters[0];
  const Scalar pi = Scalar(std::numbers::pi);
  const Scalar omega0_2 = omega0 * omega0;
  Scalar lumps[12];
  evaluate_lumps(parameters, lumps);
  const Complex A_v = load_complex(amplitude, 0);
  const Complex conj_A_v = conjugate(A_v);
  const Scalar norm_A_v = norm_of(A_v);
  const Scalar abs_A_v = modulus_of(A_v);
  const Scalar inverse_abs_A_v = inverse_or_zero(abs_A_v);
  const Complex unit_A_v = inverse_abs_A_v * A_v;
  const Complex F = load_complex(forcing, 0);
  const Complex conj_F = conjugate(F);
  const Scalar norm_F = norm_of(F);
  for (std::size_t i = 0; i < 4; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = times_i(lumps[0] * Scalar(2) * (A_v * conj_F))
       + times_i(lumps[0] * Scalar(2.0) * (conj_A_v * F))
       + Complex(lumps[1] * (-Scalar(1.0)))
       + times_i(Complex(lumps[2] * (norm_F)))
       + Complex(lumps[3] * (-Scalar(8.0) * omega0 / (Scalar(3.0) * pi)) * Scalar(1.5) * (abs_A_v))
       + Complex(lumps[4] * (-Scalar(3.0) * omega0_2 / Scalar(2.0)) * Scalar(2) * (norm_A_v))
       + times_i(Complex(lumps[5] * Scalar(4.0) / omega0 * Scalar(2) * (norm_A_v)))
       - Complex(Scalar(0.0), -omega0 + excitation_frequency[0]);
  const Complex conj_by_0_0 = times_i(lumps[0] * Scalar(2.0) * (A_v * F))
       + times_i(lumps[2] * Scalar(3.0) / Scalar(2.0) * (F * F))
       + lumps[3] * (-Scalar(8.0) * omega0 / (Scalar(3.0) * pi)) * Scalar(0.5) * (unit_A_v * A_v)
       + lumps[4] * (-Scalar(3.0) * omega0_2 / Scalar(2.0)) * (A_v * A_v)
       + times_i(lumps[5] * Scalar(4.0) / omega0 * (A_v * A_v));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[2] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[3] = by_0_0.real - conj_by_0_0.real;
}

}  // namespace primary

}  // namespace secular::generated::two_mass_mode1
