// Model pendulum: generated code, never edited by hand.
// Source: Rigid pendulum; damping laws as in A. H. Nayfeh and D. T. Mook, Nonlinear Oscillations, section 3.3
// Equation of motion: 0 = omega0^2*theta + alpha3*theta^3 + alpha5*theta^5 + 2*mu1*D(theta) +
// mu2*D(theta)*abs(D(theta)) + D2(theta) + fc*sgn(D(theta))
// Case free: free vibration, multiple scales to eps^2. Valid near that resonance for small amplitudes; what is
// left out is of order eps^3.
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// Made by: secular generate pendulum
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

namespace secular::generated::pendulum {

/// Mass matrix M of the equations of motion M*acceleration + force = 0 below, state-dependent: mass[k * 1 + j]
/// multiplies the acceleration of mode j in equation k. 0 operations.
template <class Scalar, class Parameter, class Sample>
void mass_matrix([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* mass) {
  mass[0] = Scalar(1.0);
}

/// Accelerations of the full equations of motion, solved from the state-dependent mass matrix.
/// 0 = omega0^2*theta + alpha3*theta^3 + alpha5*theta^5 + 2*mu1*D(theta) + mu2*D(theta)*abs(D(theta)) +
/// D2(theta) + fc*sgn(D(theta))
/// parameters: [0] omega0, [1] alpha3, [2] alpha5, [3] mu1, [4] mu2, [5] fc. displacement, velocity,
/// acceleration: 1 values. 20 operations.
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
      + Scalar(2.0) * mu1 * velocity[0] + mu2 * velocity[0] * absolute(velocity[0]) + fc * sign_of(velocity[0]));
}

/// slope[k * 2 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = theta, D(theta).
/// Of nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x) = 0. 17
/// operations before the solution of 2 right sides.
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
  for (std::size_t i = 0; i < 2; ++i) slope[i] = Scalar(0.0);
  // equation 1 by theta
  slope[0] = -(omega0_2 + alpha3 * displacement[0] * displacement[0] * Scalar(3.0)
      + alpha5 * displacement[0] * displacement[0] * displacement[0] * displacement[0] * Scalar(5.0));
  // equation 1 by D(theta)
  slope[1] = -(Scalar(2.0) * mu1 + mu2 * absolute(velocity[0]) + mu2 * velocity[0] * sign_of(velocity[0]));
}

/// slope[k * 6 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = omega0, alpha3,
/// alpha5, mu1, mu2, fc. Of nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and
/// d sgn(x) = 0. 10 operations before the solution of 6 right sides.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_parameters([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  const Scalar omega0 = parameters[0];
  for (std::size_t i = 0; i < 6; ++i) slope[i] = Scalar(0.0);
  slope[0] = -(Scalar(2.0) * omega0 * displacement[0]);  // equation 1 by omega0
  slope[1] = -(displacement[0] * displacement[0] * displacement[0]);  // equation 1 by alpha3
  // equation 1 by alpha5
  slope[2] = -(displacement[0] * displacement[0] * displacement[0] * displacement[0] * displacement[0]);
  slope[3] = -(Scalar(2.0) * velocity[0]);  // equation 1 by mu1
  slope[4] = -(velocity[0] * absolute(velocity[0]));  // equation 1 by mu2
  slope[5] = -(sign_of(velocity[0]));  // equation 1 by fc
}

namespace free {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: fc = fc
/// lumps[1]: mu1 = mu1
/// lumps[2]: mu2 = mu2
/// lumps[3]: alpha3 = alpha3
/// lumps[4]: beta5 = (16*omega0^2*alpha5 - 3*alpha3^2)/(16*omega0^2)
/// lumps[5]: harmonic_re_theta_A_theta4_conjA_theta = (40*omega0^2*alpha5 - 21*alpha3^2)/(64*omega0^4)
/// lumps[6]: harmonic_re_theta_A_theta5 = (8*omega0^2*alpha5 + 3*alpha3^2)/(192*omega0^4)
/// 18 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
  const Scalar omega0 = parameters[0];
  const Scalar alpha3 = parameters[1];
  const Scalar alpha5 = parameters[2];
  const Scalar mu1 = parameters[3];
  const Scalar mu2 = parameters[4];
  const Scalar fc = parameters[5];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar alpha3_2 = alpha3 * alpha3;
  lumps[0] = fc;  // fc
  lumps[1] = mu1;  // mu1
  lumps[2] = mu2;  // mu2
  lumps[3] = alpha3;  // alpha3
  lumps[4] = (Scalar(16.0) * omega0_2 * alpha5 - Scalar(3.0) * alpha3_2) / (Scalar(16.0) * omega0_2);  // beta5
  // harmonic_re_theta_A_theta4_conjA_theta
  lumps[5] = (Scalar(40.0) * omega0_2 * alpha5 - Scalar(21.0) * alpha3_2) / (Scalar(64.0) * omega0_4);
  // harmonic_re_theta_A_theta5
  lumps[6] = (Scalar(8.0) * omega0_2 * alpha5 + Scalar(3.0) * alpha3_2) / (Scalar(192.0) * omega0_4);
}

/// jacobian[l * 6 + p] = d lumps[l] / d parameters[p]. 27 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  const Scalar omega0 = parameters[0];
  const Scalar alpha3 = parameters[1];
  const Scalar alpha5 = parameters[2];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar omega0_5 = omega0_4 * omega0;
  const Scalar alpha3_2 = alpha3 * alpha3;
  for (std::size_t i = 0; i < 42; ++i) jacobian[i] = Scalar(0.0);
  jacobian[5] = Scalar(1.0);  // d fc / d fc
  jacobian[9] = Scalar(1.0);  // d mu1 / d mu1
  jacobian[16] = Scalar(1.0);  // d mu2 / d mu2
  jacobian[19] = Scalar(1.0);  // d alpha3 / d alpha3
  jacobian[24] = Scalar(3.0) * alpha3_2 / (Scalar(8.0) * omega0_3);  // d beta5 / d omega0
  jacobian[25] = -Scalar(3.0) * alpha3 / (Scalar(8.0) * omega0_2);  // d beta5 / d alpha3
  jacobian[26] = Scalar(1.0);  // d beta5 / d alpha5
  // d harmonic_re_theta_A_theta4_conjA_theta / d omega0
  jacobian[30] = (-Scalar(20.0) * omega0_2 * alpha5 + Scalar(21.0) * alpha3_2) / (Scalar(16.0) * omega0_5);
  // d harmonic_re_theta_A_theta4_conjA_theta / d alpha3
  jacobian[31] = -Scalar(21.0) * alpha3 / (Scalar(32.0) * omega0_4);
  jacobian[32] = Scalar(5.0) / (Scalar(8.0) * omega0_2);  // d harmonic_re_theta_A_theta4_conjA_theta / d alpha5
  // d harmonic_re_theta_A_theta5 / d omega0
  jacobian[36] = (-Scalar(4.0) * omega0_2 * alpha5 - Scalar(3.0) * alpha3_2) / (Scalar(48.0) * omega0_5);
  jacobian[37] = alpha3 / (Scalar(32.0) * omega0_4);  // d harmonic_re_theta_A_theta5 / d alpha3
  jacobian[38] = Scalar(1.0) / (Scalar(24.0) * omega0_2);  // d harmonic_re_theta_A_theta5 / d alpha5
}

/// What multiplies the 5 terms of the modulation of theta: functions of the frequencies alone. 8 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar pi = Scalar(std::numbers::pi);
  factor[0] = -Scalar(1.0) / (omega0 * pi);
  factor[1] = -Scalar(1.0);
  factor[2] = -Scalar(8.0) * omega0 / (Scalar(3.0) * pi);
  factor[3] = Scalar(3.0) / (Scalar(2.0) * omega0);
  factor[4] = Scalar(5.0) / omega0;
}

/// Rows of the modulation of theta: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega0)*A_theta = -1/(omega0*Pi)*fc*A_theta*abs(A_theta)^-1 - mu1*A_theta -
/// 8*omega0/(3*Pi)*mu2*A_theta*abs(A_theta) + 3/(2*omega0)*i*alpha3*A_theta^2*conj(A_theta) +
/// 5/omega0*i*beta5*A_theta^3*conj(A_theta)^2
/// 5 columns; per observation at most 13 products and sums of complex numbers.
template <class Factors>
void rows_0(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar* __restrict column_4 = columns[4];
  Scalar factor[5];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_theta = load_complex(amplitude_0, i);
    const Scalar norm_A_theta = norm_of(A_theta);
    const Scalar abs_A_theta = modulus_of(A_theta);
    const Scalar inverse_abs_A_theta = inverse_or_zero(abs_A_theta);
    const Complex unit_A_theta = inverse_abs_A_theta * A_theta;
    store_complex(column_0, i, factor[0] * (unit_A_theta));  // fc
    store_complex(column_1, i, factor[1] * (A_theta));  // mu1
    store_complex(column_2, i, factor[2] * (abs_A_theta * A_theta));  // mu2
    store_complex(column_3, i, times_i(factor[3] * (norm_A_theta * A_theta)));  // alpha3
    store_complex(column_4, i, times_i(factor[4] * (norm_A_theta * norm_A_theta * A_theta)));  // beta5
  }
}

/// columns[j][i] of the rows.
inline void columns_0(const BatchArrays& data, double* const* columns) {
  rows_0(data, FactorValues<factors_0<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_0(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_0(data, FactorSlopes<factors_0<DualNumber>, 1, 0, 5>{mode}, columns);
}

/// What multiplies the 4 terms of the harmonic 3*omega0 of theta: functions of the frequencies alone. 8
/// operations.
template <class Scalar>
void factors_1([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar pi = Scalar(std::numbers::pi);
  const Scalar omega0_2 = omega0 * omega0;
  factor[0] = Scalar(1.0) / (Scalar(12.0) * omega0_2 * pi);
  factor[1] = -Scalar(2.0) / (Scalar(15.0) * pi);
  factor[2] = Scalar(1.0) / (Scalar(8.0) * omega0_2);
  factor[3] = Scalar(1.0);
}

/// Rows of the harmonic 3*omega0 of theta: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega0)*t) in theta = 1/(12*omega0^2*Pi)*i*fc*A_theta^3*abs(A_theta)^-3 -
/// 2/(15*Pi)*i*mu2*A_theta^3*abs(A_theta)^-1 + 1/(8*omega0^2)*alpha3*A_theta^3 +
/// harmonic_re_theta_A_theta4_conjA_theta*A_theta^4*conj(A_theta)
/// 4 columns; per observation at most 22 products and sums of complex numbers.
template <class Factors>
void rows_1(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_theta = load_complex(amplitude_0, i);
    const Scalar norm_A_theta = norm_of(A_theta);
    const Scalar abs_A_theta = modulus_of(A_theta);
    const Scalar inverse_abs_A_theta = inverse_or_zero(abs_A_theta);
    const Complex unit_A_theta = inverse_abs_A_theta * A_theta;
    store_complex(column_0, i, times_i(factor[0] * (unit_A_theta * unit_A_theta * unit_A_theta)));  // fc
    store_complex(column_1, i, times_i(factor[1] * (unit_A_theta * A_theta * A_theta)));  // mu2
    store_complex(column_2, i, factor[2] * (A_theta * A_theta * A_theta));  // alpha3
    // harmonic_re_theta_A_theta4_conjA_theta
    store_complex(column_3, i, factor[3] * (norm_A_theta * A_theta * A_theta * A_theta));
  }
}

/// columns[j][i] of the rows.
inline void columns_1(const BatchArrays& data, double* const* columns) {
  rows_1(data, FactorValues<factors_1<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_1(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_1(data, FactorSlopes<factors_1<DualNumber>, 1, 0, 4>{mode}, columns);
}

/// What multiplies the 3 terms of the harmonic 5*omega0 of theta: functions of the frequencies alone. 6
/// operations.
template <class Scalar>
void factors_2([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar pi = Scalar(std::numbers::pi);
  const Scalar omega0_2 = omega0 * omega0;
  factor[0] = Scalar(1.0) / (Scalar(60.0) * omega0_2 * pi);
  factor[1] = -Scalar(2.0) / (Scalar(315.0) * pi);
  factor[2] = Scalar(1.0);
}

/// Rows of the harmonic 5*omega0 of theta: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(5*omega0)*t) in theta = 1/(60*omega0^2*Pi)*i*fc*A_theta^5*abs(A_theta)^-5 -
/// 2/(315*Pi)*i*mu2*A_theta^5*abs(A_theta)^-3 + harmonic_re_theta_A_theta5*A_theta^5
/// 3 columns; per observation at most 11 products and sums of complex numbers.
template <class Factors>
void rows_2(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_theta = load_complex(amplitude_0, i);
    const Scalar abs_A_theta = modulus_of(A_theta);
    const Scalar inverse_abs_A_theta = inverse_or_zero(abs_A_theta);
    const Complex unit_A_theta = inverse_abs_A_theta * A_theta;
    store_complex(column_0, i, times_i(factor[0] * (fixed_power<5>(unit_A_theta))));  // fc
    // mu2
    store_complex(column_1, i, times_i(factor[1] * (unit_A_theta * unit_A_theta * unit_A_theta * A_theta
        * A_theta)));
    store_complex(column_2, i, factor[2] * (fixed_power<5>(A_theta)));  // harmonic_re_theta_A_theta5
  }
}

/// columns[j][i] of the rows.
inline void columns_2(const BatchArrays& data, double* const* columns) {
  rows_2(data, FactorValues<factors_2<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_2(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_2(data, FactorSlopes<factors_2<DualNumber>, 1, 0, 3>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic 7*omega0 of theta: functions of the frequencies alone. 6
/// operations.
template <class Scalar>
void factors_3([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar pi = Scalar(std::numbers::pi);
  const Scalar omega0_2 = omega0 * omega0;
  factor[0] = Scalar(1.0) / (Scalar(168.0) * omega0_2 * pi);
  factor[1] = -Scalar(1.0) / (Scalar(945.0) * pi);
}

/// Rows of the harmonic 7*omega0 of theta: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(7*omega0)*t) in theta = 1/(168*omega0^2*Pi)*i*fc*A_theta^7*abs(A_theta)^-7 -
/// 1/(945*Pi)*i*mu2*A_theta^7*abs(A_theta)^-5
/// 2 columns; per observation at most 6 products and sums of complex numbers.
template <class Factors>
void rows_3(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_theta = load_complex(amplitude_0, i);
    const Scalar abs_A_theta = modulus_of(A_theta);
    const Scalar inverse_abs_A_theta = inverse_or_zero(abs_A_theta);
    const Complex unit_A_theta = inverse_abs_A_theta * A_theta;
    store_complex(column_0, i, times_i(factor[0] * (fixed_power<7>(unit_A_theta))));  // fc
    store_complex(column_1, i, times_i(factor[1] * (fixed_power<5>(unit_A_theta) * A_theta * A_theta)));  // mu2
  }
}

/// columns[j][i] of the rows.
inline void columns_3(const BatchArrays& data, double* const* columns) {
  rows_3(data, FactorValues<factors_3<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_3(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_3(data, FactorSlopes<factors_3<DualNumber>, 1, 0, 2>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic 9*omega0 of theta: functions of the frequencies alone. 6
/// operations.
template <class Scalar>
void factors_4([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar pi = Scalar(std::numbers::pi);
  const Scalar omega0_2 = omega0 * omega0;
  factor[0] = Scalar(1.0) / (Scalar(360.0) * omega0_2 * pi);
  factor[1] = -Scalar(1.0) / (Scalar(3465.0) * pi);
}

/// Rows of the harmonic 9*omega0 of theta: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(9*omega0)*t) in theta = 1/(360*omega0^2*Pi)*i*fc*A_theta^9*abs(A_theta)^-9 -
/// 1/(3465*Pi)*i*mu2*A_theta^9*abs(A_theta)^-7
/// 2 columns; per observation at most 6 products and sums of complex numbers.
template <class Factors>
void rows_4(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_theta = load_complex(amplitude_0, i);
    const Scalar abs_A_theta = modulus_of(A_theta);
    const Scalar inverse_abs_A_theta = inverse_or_zero(abs_A_theta);
    const Complex unit_A_theta = inverse_abs_A_theta * A_theta;
    store_complex(column_0, i, times_i(factor[0] * (fixed_power<9>(unit_A_theta))));  // fc
    store_complex(column_1, i, times_i(factor[1] * (fixed_power<7>(unit_A_theta) * A_theta * A_theta)));  // mu2
  }
}

/// columns[j][i] of the rows.
inline void columns_4(const BatchArrays& data, double* const* columns) {
  rows_4(data, FactorValues<factors_4<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_4(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_4(data, FactorSlopes<factors_4<DualNumber>, 1, 0, 2>{mode}, columns);
}

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_theta/dt + i*(w_theta - omega0)*B_theta = -1/(omega0*Pi)*fc*A_theta*abs(A_theta)^-1 - mu1*A_theta -
/// 8*omega0/(3*Pi)*mu2*A_theta*abs(A_theta) + 3/(2*omega0)*i*alpha3*A_theta^2*conj(A_theta) +
/// 5/omega0*i*beta5*A_theta^3*conj(A_theta)^2 with A = B in that frame
/// 26 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega0 = parameters[0];
  const Scalar pi = Scalar(std::numbers::pi);
  Scalar lumps[7];
  evaluate_lumps(parameters, lumps);
  const Complex A_theta = load_complex(amplitude, 0);
  const Scalar norm_A_theta = norm_of(A_theta);
  const Scalar abs_A_theta = modulus_of(A_theta);
  const Scalar inverse_abs_A_theta = inverse_or_zero(abs_A_theta);
  const Complex unit_A_theta = inverse_abs_A_theta * A_theta;
  store_complex(derivative, 0, lumps[0] * (-Scalar(1.0) / (omega0 * pi)) * (unit_A_theta)
       + lumps[1] * (-Scalar(1.0)) * (A_theta)
       + lumps[2] * (-Scalar(8.0) * omega0 / (Scalar(3.0) * pi)) * (abs_A_theta * A_theta)
       + times_i(lumps[3] * Scalar(3.0) / (Scalar(2.0) * omega0) * (norm_A_theta * A_theta))
       + times_i(lumps[4] * Scalar(5.0) / omega0 * (norm_A_theta * norm_A_theta * A_theta)));
}

/// jacobian[i * 2 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 58 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega0 = parameters[0];
  const Scalar pi = Scalar(std::numbers::pi);
  Scalar lumps[7];
  evaluate_lumps(parameters, lumps);
  const Complex A_theta = load_complex(amplitude, 0);
  const Scalar norm_A_theta = norm_of(A_theta);
  const Scalar abs_A_theta = modulus_of(A_theta);
  const Scalar inverse_abs_A_theta = inverse_or_zero(abs_A_theta);
  const Complex unit_A_theta = inverse_abs_A_theta * A_theta;
  for (std::size_t i = 0; i < 4; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = Complex(lumps[0] * (-Scalar(1.0) / (omega0 * pi)) * Scalar(0.5) * (inverse_abs_A_theta))
       + Complex(lumps[1] * (-Scalar(1.0)))
       + Complex(lumps[2] * (-Scalar(8.0) * omega0 / (Scalar(3.0) * pi)) * Scalar(1.5) * (abs_A_theta))
       + times_i(Complex(lumps[3] * Scalar(3.0) / (Scalar(2.0) * omega0) * Scalar(2) * (norm_A_theta)))
       + times_i(Complex(lumps[4] * Scalar(5.0) / omega0 * Scalar(3) * (norm_A_theta * norm_A_theta)));
  const Complex conj_by_0_0 = lumps[0] * (-Scalar(1.0) / (omega0 * pi)) * Scalar(-0.5) * (inverse_abs_A_theta
      * unit_A_theta * unit_A_theta)
       + lumps[2] * (-Scalar(8.0) * omega0 / (Scalar(3.0) * pi)) * Scalar(0.5) * (unit_A_theta * A_theta)
       + times_i(lumps[3] * Scalar(3.0) / (Scalar(2.0) * omega0) * (A_theta * A_theta))
       + times_i(lumps[4] * Scalar(5.0) / omega0 * Scalar(2) * (norm_A_theta * A_theta * A_theta));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[2] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[3] = by_0_0.real - conj_by_0_0.real;
}

}  // namespace free

}  // namespace secular::generated::pendulum
