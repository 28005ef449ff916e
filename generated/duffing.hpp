// Model duffing: generated code, never edited by hand.
// Source: Duffing oscillator with a quadratic term
// Equation of motion: 0 = omega0^2*x + a2*x^2 + a3*x^3 + 2*mu*D(x) + D2(x) - e*F*cos(Omega*t)
// Case free: free vibration, multiple scales to eps^2. Valid near that resonance for small amplitudes; what is
// left out is of order eps^3.
// Case primary: Omega = omega0 + eps^2*sigma, multiple scales to eps^2. Valid near that resonance for small
// amplitudes; what is left out is of order eps^3.
// Case superharmonic_3: 3*Omega = omega0 + eps*sigma, multiple scales to eps^1. Valid near that resonance for
// small amplitudes; what is left out is of order eps^2.
// Case subharmonic_3: Omega = 3*omega0 + eps*sigma, multiple scales to eps^1. Valid near that resonance for
// small amplitudes; what is left out is of order eps^2.
// Case subharmonic_3_second_order: Omega = 3*omega0 + eps*sigma, multiple scales to eps^2. Valid near that
// resonance for small amplitudes; what is left out is of order eps^3.
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// Made by: secular generate duffing
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

namespace secular::generated::duffing {

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
/// 0 = omega0^2*x + a2*x^2 + a3*x^3 + 2*mu*D(x) + D2(x) - e*F*cos(Omega*t)
/// parameters: [0] omega0, [1] mu, [2] a2, [3] a3, [4] e. displacement, velocity, acceleration: 1 values. 14
/// operations.
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
      + a3 * displacement[0] * displacement[0] * displacement[0] + Scalar(2.0) * mu * velocity[0]
      - e * Scalar(excitation[0].value));
}

/// slope[k * 2 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = x, D(x). Of
/// nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x) = 0. 9
/// operations before the solution of 2 right sides.
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
  for (std::size_t i = 0; i < 2; ++i) slope[i] = Scalar(0.0);
  // equation 1 by x
  slope[0] = -(omega0_2 + a2 * displacement[0] * Scalar(2.0)
      + a3 * displacement[0] * displacement[0] * Scalar(3.0));
  slope[1] = -(Scalar(2.0) * mu);  // equation 1 by D(x)
}

/// slope[k * 5 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = omega0, mu, a2,
/// a3, e. Of nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x) = 0. 7
/// operations before the solution of 5 right sides.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_parameters([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  const Scalar omega0 = parameters[0];
  for (std::size_t i = 0; i < 5; ++i) slope[i] = Scalar(0.0);
  slope[0] = -(Scalar(2.0) * omega0 * displacement[0]);  // equation 1 by omega0
  slope[1] = -(Scalar(2.0) * velocity[0]);  // equation 1 by mu
  slope[2] = -(displacement[0] * displacement[0]);  // equation 1 by a2
  slope[3] = -(displacement[0] * displacement[0] * displacement[0]);  // equation 1 by a3
  slope[4] = -(-Scalar(1.0) * Scalar(excitation[0].value));  // equation 1 by e
}

namespace free {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: mu = mu
/// lumps[1]: conservative_x_A_x2_conjA_x = (9*omega0^2*a3 - 10*a2^2)/(6*omega0^3)
/// lumps[2]: a2 = a2
/// lumps[3]: harmonic_re_x_A_x3 = (3*omega0^2*a3 + 2*a2^2)/(24*omega0^4)
/// 12 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
  const Scalar omega0 = parameters[0];
  const Scalar mu = parameters[1];
  const Scalar a2 = parameters[2];
  const Scalar a3 = parameters[3];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar a2_2 = a2 * a2;
  lumps[0] = mu;  // mu
  // conservative_x_A_x2_conjA_x
  lumps[1] = (Scalar(9.0) * omega0_2 * a3 - Scalar(10.0) * a2_2) / (Scalar(6.0) * omega0_3);
  lumps[2] = a2;  // a2
  // harmonic_re_x_A_x3
  lumps[3] = (Scalar(3.0) * omega0_2 * a3 + Scalar(2.0) * a2_2) / (Scalar(24.0) * omega0_4);
}

/// jacobian[l * 5 + p] = d lumps[l] / d parameters[p]. 21 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  const Scalar omega0 = parameters[0];
  const Scalar a2 = parameters[2];
  const Scalar a3 = parameters[3];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar omega0_5 = omega0_4 * omega0;
  const Scalar a2_2 = a2 * a2;
  for (std::size_t i = 0; i < 20; ++i) jacobian[i] = Scalar(0.0);
  jacobian[1] = Scalar(1.0);  // d mu / d mu
  // d conservative_x_A_x2_conjA_x / d omega0
  jacobian[5] = (-Scalar(3.0) * omega0_2 * a3 + Scalar(10.0) * a2_2) / (Scalar(2.0) * omega0_4);
  jacobian[7] = -Scalar(10.0) * a2 / (Scalar(3.0) * omega0_3);  // d conservative_x_A_x2_conjA_x / d a2
  jacobian[8] = Scalar(3.0) / (Scalar(2.0) * omega0);  // d conservative_x_A_x2_conjA_x / d a3
  jacobian[12] = Scalar(1.0);  // d a2 / d a2
  // d harmonic_re_x_A_x3 / d omega0
  jacobian[15] = (-Scalar(3.0) * omega0_2 * a3 - Scalar(4.0) * a2_2) / (Scalar(12.0) * omega0_5);
  jacobian[17] = a2 / (Scalar(6.0) * omega0_4);  // d harmonic_re_x_A_x3 / d a2
  jacobian[18] = Scalar(1.0) / (Scalar(8.0) * omega0_2);  // d harmonic_re_x_A_x3 / d a3
}

/// What multiplies the 2 terms of the modulation of x: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = -Scalar(1.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the modulation of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega0)*A_x = -mu*A_x + i*conservative_x_A_x2_conjA_x*A_x^2*conj(A_x)
/// 2 columns; per observation at most 4 products and sums of complex numbers.
template <class Factors>
void rows_0(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    store_complex(column_0, i, factor[0] * (A_x));  // mu
    store_complex(column_1, i, times_i(factor[1] * (norm_A_x * A_x)));  // conservative_x_A_x2_conjA_x
  }
}

/// columns[j][i] of the rows.
inline void columns_0(const BatchArrays& data, double* const* columns) {
  rows_0(data, FactorValues<factors_0<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_0(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic 0 of x: functions of the frequencies alone. 2 operations.
template <class Scalar>
void factors_1([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  factor[0] = -Scalar(2.0) / omega0_2;
}

/// Rows of the harmonic 0 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in x = -2/omega0^2*a2*A_x*conj(A_x)
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
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    store_complex(column_0, i, Complex(factor[0] * (norm_A_x)));  // a2
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

/// What multiplies the 1 terms of the harmonic 2*omega0 of x: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_2([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  factor[0] = Scalar(1.0) / (Scalar(3.0) * omega0_2);
}

/// Rows of the harmonic 2*omega0 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega0)*t) in x = 1/(3*omega0^2)*a2*A_x^2
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
    const Complex A_x = load_complex(amplitude_0, i);
    store_complex(column_0, i, factor[0] * (A_x * A_x));  // a2
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

/// What multiplies the 1 terms of the harmonic 3*omega0 of x: functions of the frequencies alone. 0 operations.
template <class Scalar>
void factors_3([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0);
}

/// Rows of the harmonic 3*omega0 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega0)*t) in x = harmonic_re_x_A_x3*A_x^3
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_3(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    store_complex(column_0, i, factor[0] * (A_x * A_x * A_x));  // harmonic_re_x_A_x3
  }
}

/// columns[j][i] of the rows.
inline void columns_3(const BatchArrays& data, double* const* columns) {
  rows_3(data, FactorValues<factors_3<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_3(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 1; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_x/dt + i*(w_x - omega0)*B_x = -mu*A_x + i*conservative_x_A_x2_conjA_x*A_x^2*conj(A_x) with A = B in that
/// frame
/// 5 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  Scalar lumps[4];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Scalar norm_A_x = norm_of(A_x);
  store_complex(derivative, 0, lumps[0] * (-Scalar(1.0)) * (A_x)
       + times_i(lumps[1] * (norm_A_x * A_x)));
}

/// jacobian[i * 2 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 10 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  Scalar lumps[4];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Scalar norm_A_x = norm_of(A_x);
  for (std::size_t i = 0; i < 4; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = Complex(lumps[0] * (-Scalar(1.0)))
       + times_i(Complex(lumps[1] * Scalar(2) * (norm_A_x)));
  const Complex conj_by_0_0 = times_i(lumps[1] * (A_x * A_x));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[2] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[3] = by_0_0.real - conj_by_0_0.real;
}

}  // namespace free

namespace primary {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: mu = mu
/// lumps[1]: conservative_x_A_x2_conjA_x = (9*omega0^2*a3 - 10*a2^2)/(6*omega0^3)
/// lumps[2]: e = e
/// lumps[3]: a2 = a2
/// lumps[4]: harmonic_re_x_A_x3 = (3*omega0^2*a3 + 2*a2^2)/(24*omega0^4)
/// 12 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
  const Scalar omega0 = parameters[0];
  const Scalar mu = parameters[1];
  const Scalar a2 = parameters[2];
  const Scalar a3 = parameters[3];
  const Scalar e = parameters[4];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar a2_2 = a2 * a2;
  lumps[0] = mu;  // mu
  // conservative_x_A_x2_conjA_x
  lumps[1] = (Scalar(9.0) * omega0_2 * a3 - Scalar(10.0) * a2_2) / (Scalar(6.0) * omega0_3);
  lumps[2] = e;  // e
  lumps[3] = a2;  // a2
  // harmonic_re_x_A_x3
  lumps[4] = (Scalar(3.0) * omega0_2 * a3 + Scalar(2.0) * a2_2) / (Scalar(24.0) * omega0_4);
}

/// jacobian[l * 5 + p] = d lumps[l] / d parameters[p]. 21 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  const Scalar omega0 = parameters[0];
  const Scalar a2 = parameters[2];
  const Scalar a3 = parameters[3];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar omega0_5 = omega0_4 * omega0;
  const Scalar a2_2 = a2 * a2;
  for (std::size_t i = 0; i < 25; ++i) jacobian[i] = Scalar(0.0);
  jacobian[1] = Scalar(1.0);  // d mu / d mu
  // d conservative_x_A_x2_conjA_x / d omega0
  jacobian[5] = (-Scalar(3.0) * omega0_2 * a3 + Scalar(10.0) * a2_2) / (Scalar(2.0) * omega0_4);
  jacobian[7] = -Scalar(10.0) * a2 / (Scalar(3.0) * omega0_3);  // d conservative_x_A_x2_conjA_x / d a2
  jacobian[8] = Scalar(3.0) / (Scalar(2.0) * omega0);  // d conservative_x_A_x2_conjA_x / d a3
  jacobian[14] = Scalar(1.0);  // d e / d e
  jacobian[17] = Scalar(1.0);  // d a2 / d a2
  // d harmonic_re_x_A_x3 / d omega0
  jacobian[20] = (-Scalar(3.0) * omega0_2 * a3 - Scalar(4.0) * a2_2) / (Scalar(12.0) * omega0_5);
  jacobian[22] = a2 / (Scalar(6.0) * omega0_4);  // d harmonic_re_x_A_x3 / d a2
  jacobian[23] = Scalar(1.0) / (Scalar(8.0) * omega0_2);  // d harmonic_re_x_A_x3 / d a3
}

/// What multiplies the 3 terms of the modulation of x: functions of the frequencies alone. 2 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  factor[0] = -Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = -Scalar(1.0) / (Scalar(4.0) * omega0);
}

/// Rows of the modulation of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega0)*A_x = -mu*A_x + i*conservative_x_A_x2_conjA_x*A_x^2*conj(A_x) - 1/(4*omega0)*i*e*F
/// 3 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_0(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[3];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_x));  // mu
    store_complex(column_1, i, times_i(factor[1] * (norm_A_x * A_x)));  // conservative_x_A_x2_conjA_x
    store_complex(column_2, i, times_i(factor[2] * (F)));  // e
  }
}

/// columns[j][i] of the rows.
inline void columns_0(const BatchArrays& data, double* const* columns) {
  rows_0(data, FactorValues<factors_0<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_0(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_0(data, FactorSlopes<factors_0<DualNumber>, 1, 1, 3>{mode}, columns);
}

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_x/dt + i*(w_x - omega0)*B_x = -mu*A_x + i*conservative_x_A_x2_conjA_x*A_x^2*conj(A_x) - 1/(4*omega0)*i*e*F
/// with A = B in that frame
/// 13 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega0 = parameters[0];
  Scalar lumps[5];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Scalar norm_A_x = norm_of(A_x);
  const Complex F = load_complex(forcing, 0);
  store_complex(derivative, 0, lumps[0] * (-Scalar(1.0)) * (A_x)
       + times_i(lumps[1] * (norm_A_x * A_x))
       + times_i(lumps[2] * (-Scalar(1.0) / (Scalar(4.0) * omega0)) * (F))
       - times_i((-omega0 + excitation_frequency[0]) * A_x));
}

/// jacobian[i * 2 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 12 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega0 = parameters[0];
  Scalar lumps[5];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Scalar norm_A_x = norm_of(A_x);
  for (std::size_t i = 0; i < 4; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = Complex(lumps[0] * (-Scalar(1.0)))
       + times_i(Complex(lumps[1] * Scalar(2) * (norm_A_x)))
       - Complex(Scalar(0.0), -omega0 + excitation_frequency[0]);
  const Complex conj_by_0_0 = times_i(lumps[1] * (A_x * A_x));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[2] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[3] = by_0_0.real - conj_by_0_0.real;
}

}  // namespace primary

namespace superharmonic_3 {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: mu = mu
/// lumps[1]: conservative_x_A_x_F2 = 243*a3*e^2/(256*omega0^5)
/// lumps[2]: a3 = a3
/// lumps[3]: conservative_x_F3 = 729*a3*e^3/(8192*omega0^7)
/// lumps[4]: e = e
/// lumps[5]: harmonic_im_x_F = -27*mu*e/(64*omega0^3)
/// lumps[6]: harmonic_re_x_A_x_conjA_x_F = -243*a3*e/(64*omega0^4)
/// lumps[7]: harmonic_re_x_F2 = -81*a2*e^2/(128*omega0^6)
/// lumps[8]: a2 = a2
/// lumps[9]: harmonic_re_x_A_x_F = -81*a2*e/(40*omega0^4)
/// 24 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
  const Scalar omega0 = parameters[0];
  const Scalar mu = parameters[1];
  const Scalar a2 = parameters[2];
  const Scalar a3 = parameters[3];
  const Scalar e = parameters[4];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar omega0_5 = omega0_4 * omega0;
  const Scalar omega0_6 = omega0_5 * omega0;
  const Scalar omega0_7 = omega0_6 * omega0;
  const Scalar e_2 = e * e;
  const Scalar e_3 = e_2 * e;
  lumps[0] = mu;  // mu
  lumps[1] = Scalar(243.0) * a3 * e_2 / (Scalar(256.0) * omega0_5);  // conservative_x_A_x_F2
  lumps[2] = a3;  // a3
  lumps[3] = Scalar(729.0) * a3 * e_3 / (Scalar(8192.0) * omega0_7);  // conservative_x_F3
  lumps[4] = e;  // e
  lumps[5] = -Scalar(27.0) * mu * e / (Scalar(64.0) * omega0_3);  // harmonic_im_x_F
  lumps[6] = -Scalar(243.0) * a3 * e / (Scalar(64.0) * omega0_4);  // harmonic_re_x_A_x_conjA_x_F
  lumps[7] = -Scalar(81.0) * a2 * e_2 / (Scalar(128.0) * omega0_6);  // harmonic_re_x_F2
  lumps[8] = a2;  // a2
  lumps[9] = -Scalar(81.0) * a2 * e / (Scalar(40.0) * omega0_4);  // harmonic_re_x_A_x_F
}

/// jacobian[l * 5 + p] = d lumps[l] / d parameters[p]. 63 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  const Scalar omega0 = parameters[0];
  const Scalar mu = parameters[1];
  const Scalar a2 = parameters[2];
  const Scalar a3 = parameters[3];
  const Scalar e = parameters[4];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar omega0_5 = omega0_4 * omega0;
  const Scalar omega0_6 = omega0_5 * omega0;
  const Scalar omega0_7 = omega0_6 * omega0;
  const Scalar omega0_8 = omega0_7 * omega0;
  const Scalar e_2 = e * e;
  const Scalar e_3 = e_2 * e;
  for (std::size_t i = 0; i < 50; ++i) jacobian[i] = Scalar(0.0);
  jacobian[1] = Scalar(1.0);  // d mu / d mu
  jacobian[5] = -Scalar(1215.0) * a3 * e_2 / (Scalar(256.0) * omega0_6);  // d conservative_x_A_x_F2 / d omega0
  jacobian[8] = Scalar(243.0) * e_2 / (Scalar(256.0) * omega0_5);  // d conservative_x_A_x_F2 / d a3
  jacobian[9] = Scalar(243.0) * a3 * e / (Scalar(128.0) * omega0_5);  // d conservative_x_A_x_F2 / d e
  jacobian[13] = Scalar(1.0);  // d a3 / d a3
  jacobian[15] = -Scalar(5103.0) * a3 * e_3 / (Scalar(8192.0) * omega0_8);  // d conservative_x_F3 / d omega0
  jacobian[18] = Scalar(729.0) * e_3 / (Scalar(8192.0) * omega0_7);  // d conservative_x_F3 / d a3
  jacobian[19] = Scalar(2187.0) * a3 * e_2 / (Scalar(8192.0) * omega0_7);  // d conservative_x_F3 / d e
  jacobian[24] = Scalar(1.0);  // d e / d e
  jacobian[25] = Scalar(81.0) * mu * e / (Scalar(64.0) * omega0_4);  // d harmonic_im_x_F / d omega0
  jacobian[26] = -Scalar(27.0) * e / (Scalar(64.0) * omega0_3);  // d harmonic_im_x_F / d mu
  jacobian[29] = -Scalar(27.0) * mu / (Scalar(64.0) * omega0_3);  // d harmonic_im_x_F / d e
  jacobian[30] = Scalar(243.0) * a3 * e / (Scalar(16.0) * omega0_5);  // d harmonic_re_x_A_x_conjA_x_F / d omega0
  jacobian[33] = -Scalar(243.0) * e / (Scalar(64.0) * omega0_4);  // d harmonic_re_x_A_x_conjA_x_F / d a3
  jacobian[34] = -Scalar(243.0) * a3 / (Scalar(64.0) * omega0_4);  // d harmonic_re_x_A_x_conjA_x_F / d e
  jacobian[35] = Scalar(243.0) * a2 * e_2 / (Scalar(64.0) * omega0_7);  // d harmonic_re_x_F2 / d omega0
  jacobian[37] = -Scalar(81.0) * e_2 / (Scalar(128.0) * omega0_6);  // d harmonic_re_x_F2 / d a2
  jacobian[39] = -Scalar(81.0) * a2 * e / (Scalar(64.0) * omega0_6);  // d harmonic_re_x_F2 / d e
  jacobian[42] = Scalar(1.0);  // d a2 / d a2
  jacobian[45] = Scalar(81.0) * a2 * e / (Scalar(10.0) * omega0_5);  // d harmonic_re_x_A_x_F / d omega0
  jacobian[47] = -Scalar(81.0) * e / (Scalar(40.0) * omega0_4);  // d harmonic_re_x_A_x_F / d a2
  jacobian[49] = -Scalar(81.0) * a2 / (Scalar(40.0) * omega0_4);  // d harmonic_re_x_A_x_F / d e
}

/// What multiplies the 4 terms of the modulation of x: functions of the frequencies alone. 2 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  factor[0] = -Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(3.0) / (Scalar(2.0) * omega0);
  factor[3] = Scalar(1.0);
}

/// Rows of the modulation of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega0)*A_x = -mu*A_x + i*conservative_x_A_x_F2*A_x*F^2 + 3/(2*omega0)*i*a3*A_x^2*conj(A_x) +
/// i*conservative_x_F3*F^3
/// 4 columns; per observation at most 12 products and sums of complex numbers.
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
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex F = load_complex(forcing_0, i);
    const Scalar norm_F = norm_of(F);
    store_complex(column_0, i, factor[0] * (A_x));  // mu
    store_complex(column_1, i, times_i(factor[1] * (A_x * norm_F)));  // conservative_x_A_x_F2
    store_complex(column_2, i, times_i(factor[2] * (norm_A_x * A_x)));  // a3
    store_complex(column_3, i, times_i(factor[3] * (F * F * F)));  // conservative_x_F3
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

/// What multiplies the 6 terms of the harmonic Omega of x: functions of the frequencies alone. 13 operations.
template <class Scalar>
void factors_1([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  factor[0] = -Scalar(9.0) / (Scalar(8.0) * omega0);
  factor[1] = -Scalar(27.0) / (Scalar(4.0) * omega0);
  factor[2] = Scalar(9.0) / (Scalar(16.0) * omega0_2);
  factor[3] = (-Scalar(9.0) * omega0 + Scalar(27.0) * Omega) / (Scalar(64.0) * omega0_3);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
}

/// Rows of the harmonic Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(Omega)*t) in x = -9/(8*omega0)*conservative_x_A_x_F2*A_x*F^2 -
/// 27/(4*omega0)*conservative_x_F3*F^3 + 9/(16*omega0^2)*e*F + (-9*omega0 + 27*Omega)/(64*omega0^3)*e*F +
/// i*harmonic_im_x_F*F + harmonic_re_x_A_x_conjA_x_F*A_x*conj(A_x)*F
/// 5 columns; per observation at most 15 products and sums of complex numbers.
template <class Factors>
void rows_1(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar* __restrict column_4 = columns[4];
  Scalar factor[6];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    const Scalar norm_F = norm_of(F);
    store_complex(column_0, i, factor[0] * (A_x * conj_F * conj_F));  // conservative_x_A_x_F2
    store_complex(column_1, i, factor[1] * (norm_F * F));  // conservative_x_F3
    store_complex(column_2, i, factor[2] * (F) + factor[3] * (F));  // e
    store_complex(column_3, i, times_i(factor[4] * (F)));  // harmonic_im_x_F
    store_complex(column_4, i, factor[5] * (norm_A_x * F));  // harmonic_re_x_A_x_conjA_x_F
  }
}

/// columns[j][i] of the rows.
inline void columns_1(const BatchArrays& data, double* const* columns) {
  rows_1(data, FactorValues<factors_1<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_1(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_1(data, FactorSlopes<factors_1<DualNumber>, 1, 1, 6>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic 0 of x: functions of the frequencies alone. 2 operations.
template <class Scalar>
void factors_2([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  factor[0] = Scalar(1.0);
  factor[1] = -Scalar(2.0) / omega0_2;
}

/// Rows of the harmonic 0 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in x = harmonic_re_x_F2*F^2 - 2/omega0^2*a2*A_x*conj(A_x)
/// 2 columns; per observation at most 2 products and sums of complex numbers.
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
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex F = load_complex(forcing_0, i);
    const Scalar norm_F = norm_of(F);
    store_complex(column_0, i, Complex(factor[0] * (norm_F)));  // harmonic_re_x_F2
    store_complex(column_1, i, Complex(factor[1] * (norm_A_x)));  // a2
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

/// What multiplies the 2 terms of the harmonic 2*Omega of x: functions of the frequencies alone. 1 operations.
template <class Scalar>
void factors_3([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(9.0) / Scalar(10.0);
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic 2*Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*Omega)*t) in x = 9/10*harmonic_re_x_F2*F^2 + harmonic_re_x_A_x_F*A_x*F
/// 2 columns; per observation at most 6 products and sums of complex numbers.
template <class Factors>
void rows_3(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    store_complex(column_0, i, factor[0] * (F * F));  // harmonic_re_x_F2
    store_complex(column_1, i, factor[1] * (A_x * conj_F));  // harmonic_re_x_A_x_F
  }
}

/// columns[j][i] of the rows.
inline void columns_3(const BatchArrays& data, double* const* columns) {
  rows_3(data, FactorValues<factors_3<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_3(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 1 terms of the harmonic omega0+Omega of x: functions of the frequencies alone. 16
/// operations.
template <class Scalar>
void factors_4([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar per_0 = Scalar(1.0) / (omega0 + Omega);
  const Scalar per_1 = Scalar(1.0) / (omega0 - Omega);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega0 + Omega);
  factor[0] = -Scalar(40.0) * omega0_4 * per_0 * per_1 * per_2 / (Scalar(81.0) * Omega);
}

/// Rows of the harmonic omega0+Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega0 + Omega)*t) in x = -40*omega0^4/(81*Omega*(omega0 + Omega)*(omega0 -
/// Omega)*(2*omega0 + Omega))*harmonic_re_x_A_x_F*A_x*F
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_4(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_x * F));  // harmonic_re_x_A_x_F
  }
}

/// columns[j][i] of the rows.
inline void columns_4(const BatchArrays& data, double* const* columns) {
  rows_4(data, FactorValues<factors_4<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_4(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_4(data, FactorSlopes<factors_4<DualNumber>, 1, 1, 1>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic omega0+2*Omega of x: functions of the frequencies alone. 24
/// operations.
template <class Scalar>
void factors_5([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar omega0_5 = omega0_4 * omega0;
  const Scalar per_0 = Scalar(1.0) / (omega0 + Omega);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_0_3 = per_0_2 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega0 - Omega);
  const Scalar per_1_2 = per_1 * per_1;
  const Scalar per_2 = Scalar(1.0) / (Scalar(3.0) * omega0 - Omega);
  factor[0] = Scalar(16.0) * omega0_5 * per_0_3 * per_1_2 / (Scalar(81.0) * Omega);
  factor[1] = -Scalar(32.0) * omega0_4 * per_0 * per_1_2 * per_2 / Scalar(81.0);
}

/// Rows of the harmonic omega0+2*Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega0 + 2*Omega)*t) in x = 16*omega0^5/(81*Omega*(omega0 + Omega)^3*(omega0 -
/// Omega)^2)*conservative_x_A_x_F2*A_x*F^2 - 32*omega0^4/(81*(omega0 + Omega)*(omega0 - Omega)^2*(3*omega0 -
/// Omega))*harmonic_re_x_A_x_conjA_x_F*A_x^2*F
/// 2 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_5(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    store_complex(column_0, i, factor[0] * (A_x * F * F));  // conservative_x_A_x_F2
    store_complex(column_1, i, factor[1] * (A_x * A_x * conj_F));  // harmonic_re_x_A_x_conjA_x_F
  }
}

/// columns[j][i] of the rows.
inline void columns_5(const BatchArrays& data, double* const* columns) {
  rows_5(data, FactorValues<factors_5<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_5(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_5(data, FactorSlopes<factors_5<DualNumber>, 1, 1, 2>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 2*omega0+Omega of x: functions of the frequencies alone. 16
/// operations.
template <class Scalar>
void factors_7([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar per_0 = Scalar(1.0) / (omega0 + Omega);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega0 - Omega);
  const Scalar per_2 = Scalar(1.0) / (Scalar(3.0) * omega0 + Omega);
  factor[0] = -Scalar(32.0) * omega0_4 * per_0_2 * per_1 * per_2 / Scalar(81.0);
}

/// Rows of the harmonic 2*omega0+Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*omega0 + Omega)*t) in x = -32*omega0^4/(81*(omega0 + Omega)^2*(omega0 -
/// Omega)*(3*omega0 + Omega))*harmonic_re_x_A_x_conjA_x_F*A_x^2*F
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_7(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_x * A_x * F));  // harmonic_re_x_A_x_conjA_x_F
  }
}

/// columns[j][i] of the rows.
inline void columns_7(const BatchArrays& data, double* const* columns) {
  rows_7(data, FactorValues<factors_7<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_7(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_7(data, FactorSlopes<factors_7<DualNumber>, 1, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 3*omega0 of x: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_8([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  factor[0] = Scalar(1.0) / (Scalar(8.0) * omega0_2);
}

/// Rows of the harmonic 3*omega0 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega0)*t) in x = 1/(8*omega0^2)*a3*A_x^3
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_8(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    store_complex(column_0, i, factor[0] * (A_x * A_x * A_x));  // a3
  }
}

/// columns[j][i] of the rows.
inline void columns_8(const BatchArrays& data, double* const* columns) {
  rows_8(data, FactorValues<factors_8<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_8(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_8(data, FactorSlopes<factors_8<DualNumber>, 1, 1, 1>{mode}, columns);
}

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_x/dt + i*(w_x - omega0)*B_x = -mu*A_x + i*conservative_x_A_x_F2*A_x*F^2 +
/// 3/(2*omega0)*i*a3*A_x^2*conj(A_x) + i*conservative_x_F3*F^3 with A = B in that frame
/// 19 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega0 = parameters[0];
  Scalar lumps[10];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Scalar norm_A_x = norm_of(A_x);
  const Complex F = load_complex(forcing, 0);
  const Scalar norm_F = norm_of(F);
  store_complex(derivative, 0, lumps[0] * (-Scalar(1.0)) * (A_x)
       + times_i(lumps[1] * (A_x * norm_F))
       + times_i(lumps[2] * Scalar(3.0) / (Scalar(2.0) * omega0) * (norm_A_x * A_x))
       + times_i(lumps[3] * (F * F * F))
       - times_i((-omega0 + Scalar(3.0) * excitation_frequency[0]) * A_x));
}

/// jacobian[i * 2 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 21 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega0 = parameters[0];
  Scalar lumps[10];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Scalar norm_A_x = norm_of(A_x);
  const Complex F = load_complex(forcing, 0);
  const Scalar norm_F = norm_of(F);
  for (std::size_t i = 0; i < 4; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = Complex(lumps[0] * (-Scalar(1.0)))
       + times_i(Complex(lumps[1] * (norm_F)))
       + times_i(Complex(lumps[2] * Scalar(3.0) / (Scalar(2.0) * omega0) * Scalar(2) * (norm_A_x)))
       - Complex(Scalar(0.0), -omega0 + Scalar(3.0) * excitation_frequency[0]);
  const Complex conj_by_0_0 = times_i(lumps[2] * Scalar(3.0) / (Scalar(2.0) * omega0) * (A_x * A_x));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[2] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[3] = by_0_0.real - conj_by_0_0.real;
}

}  // namespace superharmonic_3

namespace subharmonic_3 {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: mu = mu
/// lumps[1]: conservative_x_A_x_F2 = 3*a3*e^2/(256*omega0^5)
/// lumps[2]: a3 = a3
/// lumps[3]: conservative_x_conjA_x2_F = -3*a3*e/(32*omega0^3)
/// lumps[4]: e = e
/// lumps[5]: harmonic_im_x_F = -3*mu*e/(64*omega0^3)
/// lumps[6]: harmonic_re_x_F3 = -3*a3*e^3/(32768*omega0^8)
/// lumps[7]: harmonic_re_x_conjA_x_F = -a2*e/(24*omega0^4)
/// lumps[8]: a2 = a2
/// lumps[9]: harmonic_re_x_F2 = -a2*e^2/(128*omega0^6)
/// 22 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
  const Scalar omega0 = parameters[0];
  const Scalar mu = parameters[1];
  const Scalar a2 = parameters[2];
  const Scalar a3 = parameters[3];
  const Scalar e = parameters[4];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar omega0_5 = omega0_4 * omega0;
  const Scalar omega0_6 = omega0_5 * omega0;
  const Scalar omega0_7 = omega0_6 * omega0;
  const Scalar omega0_8 = omega0_7 * omega0;
  const Scalar e_2 = e * e;
  const Scalar e_3 = e_2 * e;
  lumps[0] = mu;  // mu
  lumps[1] = Scalar(3.0) * a3 * e_2 / (Scalar(256.0) * omega0_5);  // conservative_x_A_x_F2
  lumps[2] = a3;  // a3
  lumps[3] = -Scalar(3.0) * a3 * e / (Scalar(32.0) * omega0_3);  // conservative_x_conjA_x2_F
  lumps[4] = e;  // e
  lumps[5] = -Scalar(3.0) * mu * e / (Scalar(64.0) * omega0_3);  // harmonic_im_x_F
  lumps[6] = -Scalar(3.0) * a3 * e_3 / (Scalar(32768.0) * omega0_8);  // harmonic_re_x_F3
  lumps[7] = -a2 * e / (Scalar(24.0) * omega0_4);  // harmonic_re_x_conjA_x_F
  lumps[8] = a2;  // a2
  lumps[9] = -a2 * e_2 / (Scalar(128.0) * omega0_6);  // harmonic_re_x_F2
}

/// jacobian[l * 5 + p] = d lumps[l] / d parameters[p]. 58 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  const Scalar omega0 = parameters[0];
  const Scalar mu = parameters[1];
  const Scalar a2 = parameters[2];
  const Scalar a3 = parameters[3];
  const Scalar e = parameters[4];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar omega0_5 = omega0_4 * omega0;
  const Scalar omega0_6 = omega0_5 * omega0;
  const Scalar omega0_7 = omega0_6 * omega0;
  const Scalar omega0_8 = omega0_7 * omega0;
  const Scalar omega0_9 = omega0_8 * omega0;
  const Scalar e_2 = e * e;
  const Scalar e_3 = e_2 * e;
  for (std::size_t i = 0; i < 50; ++i) jacobian[i] = Scalar(0.0);
  jacobian[1] = Scalar(1.0);  // d mu / d mu
  jacobian[5] = -Scalar(15.0) * a3 * e_2 / (Scalar(256.0) * omega0_6);  // d conservative_x_A_x_F2 / d omega0
  jacobian[8] = Scalar(3.0) * e_2 / (Scalar(256.0) * omega0_5);  // d conservative_x_A_x_F2 / d a3
  jacobian[9] = Scalar(3.0) * a3 * e / (Scalar(128.0) * omega0_5);  // d conservative_x_A_x_F2 / d e
  jacobian[13] = Scalar(1.0);  // d a3 / d a3
  jacobian[15] = Scalar(9.0) * a3 * e / (Scalar(32.0) * omega0_4);  // d conservative_x_conjA_x2_F / d omega0
  jacobian[18] = -Scalar(3.0) * e / (Scalar(32.0) * omega0_3);  // d conservative_x_conjA_x2_F / d a3
  jacobian[19] = -Scalar(3.0) * a3 / (Scalar(32.0) * omega0_3);  // d conservative_x_conjA_x2_F / d e
  jacobian[24] = Scalar(1.0);  // d e / d e
  jacobian[25] = Scalar(9.0) * mu * e / (Scalar(64.0) * omega0_4);  // d harmonic_im_x_F / d omega0
  jacobian[26] = -Scalar(3.0) * e / (Scalar(64.0) * omega0_3);  // d harmonic_im_x_F / d mu
  jacobian[29] = -Scalar(3.0) * mu / (Scalar(64.0) * omega0_3);  // d harmonic_im_x_F / d e
  jacobian[30] = Scalar(3.0) * a3 * e_3 / (Scalar(4096.0) * omega0_9);  // d harmonic_re_x_F3 / d omega0
  jacobian[33] = -Scalar(3.0) * e_3 / (Scalar(32768.0) * omega0_8);  // d harmonic_re_x_F3 / d a3
  jacobian[34] = -Scalar(9.0) * a3 * e_2 / (Scalar(32768.0) * omega0_8);  // d harmonic_re_x_F3 / d e
  jacobian[35] = a2 * e / (Scalar(6.0) * omega0_5);  // d harmonic_re_x_conjA_x_F / d omega0
  jacobian[37] = -e / (Scalar(24.0) * omega0_4);  // d harmonic_re_x_conjA_x_F / d a2
  jacobian[39] = -a2 / (Scalar(24.0) * omega0_4);  // d harmonic_re_x_conjA_x_F / d e
  jacobian[42] = Scalar(1.0);  // d a2 / d a2
  jacobian[45] = Scalar(3.0) * a2 * e_2 / (Scalar(64.0) * omega0_7);  // d harmonic_re_x_F2 / d omega0
  jacobian[47] = -e_2 / (Scalar(128.0) * omega0_6);  // d harmonic_re_x_F2 / d a2
  jacobian[49] = -a2 * e / (Scalar(64.0) * omega0_6);  // d harmonic_re_x_F2 / d e
}

/// What multiplies the 4 terms of the modulation of x: functions of the frequencies alone. 2 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  factor[0] = -Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(3.0) / (Scalar(2.0) * omega0);
  factor[3] = Scalar(1.0);
}

/// Rows of the modulation of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega0)*A_x = -mu*A_x + i*conservative_x_A_x_F2*A_x*F^2 + 3/(2*omega0)*i*a3*A_x^2*conj(A_x) +
/// i*conservative_x_conjA_x2_F*conj(A_x)^2*F
/// 4 columns; per observation at most 12 products and sums of complex numbers.
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
  Scalar factor[4];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex F = load_complex(forcing_0, i);
    const Scalar norm_F = norm_of(F);
    store_complex(column_0, i, factor[0] * (A_x));  // mu
    store_complex(column_1, i, times_i(factor[1] * (A_x * norm_F)));  // conservative_x_A_x_F2
    store_complex(column_2, i, times_i(factor[2] * (norm_A_x * A_x)));  // a3
    store_complex(column_3, i, times_i(factor[3] * (conj_A_x * conj_A_x * F)));  // conservative_x_conjA_x2_F
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

/// What multiplies the 6 terms of the harmonic Omega of x: functions of the frequencies alone. 13 operations.
template <class Scalar>
void factors_1([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  factor[0] = Scalar(1.0) / (Scalar(8.0) * omega0_2);
  factor[1] = Scalar(1.0) / (Scalar(2.0) * omega0);
  factor[2] = -Scalar(1.0) / (Scalar(16.0) * omega0_2);
  factor[3] = (-Scalar(9.0) * omega0 + Scalar(3.0) * Omega) / (Scalar(64.0) * omega0_3);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
}

/// Rows of the harmonic Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(Omega)*t) in x = 1/(8*omega0^2)*a3*A_x^3 +
/// 1/(2*omega0)*conservative_x_conjA_x2_F*A_x*conj(A_x)*F - 1/(16*omega0^2)*e*F + (-9*omega0 +
/// 3*Omega)/(64*omega0^3)*e*F + i*harmonic_im_x_F*F + harmonic_re_x_F3*F^3
/// 5 columns; per observation at most 15 products and sums of complex numbers.
template <class Factors>
void rows_1(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar* __restrict column_4 = columns[4];
  Scalar factor[6];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex F = load_complex(forcing_0, i);
    const Scalar norm_F = norm_of(F);
    store_complex(column_0, i, factor[0] * (A_x * A_x * A_x));  // a3
    store_complex(column_1, i, factor[1] * (norm_A_x * F));  // conservative_x_conjA_x2_F
    store_complex(column_2, i, factor[2] * (F) + factor[3] * (F));  // e
    store_complex(column_3, i, times_i(factor[4] * (F)));  // harmonic_im_x_F
    store_complex(column_4, i, factor[5] * (norm_F * F));  // harmonic_re_x_F3
  }
}

/// columns[j][i] of the rows.
inline void columns_1(const BatchArrays& data, double* const* columns) {
  rows_1(data, FactorValues<factors_1<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_1(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_1(data, FactorSlopes<factors_1<DualNumber>, 1, 1, 6>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic -omega0+Omega of x: functions of the frequencies alone. 3
/// operations.
template <class Scalar>
void factors_2([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0) / (Scalar(3.0) * omega0_2);
}

/// Rows of the harmonic -omega0+Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega0 + Omega)*t) in x = harmonic_re_x_conjA_x_F*conj(A_x)*F + 1/(3*omega0^2)*a2*A_x^2
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
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (conj_A_x * F));  // harmonic_re_x_conjA_x_F
    store_complex(column_1, i, factor[1] * (A_x * A_x));  // a2
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

/// What multiplies the 2 terms of the harmonic -omega0+2*Omega of x: functions of the frequencies alone. 22
/// operations.
template <class Scalar>
void factors_3([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar omega0_5 = omega0_4 * omega0;
  const Scalar per_0 = Scalar(1.0) / (omega0 + Omega);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega0 - Omega);
  const Scalar per_1_2 = per_1 * per_1;
  const Scalar per_1_3 = per_1_2 * per_1;
  const Scalar per_2 = Scalar(1.0) / (Scalar(3.0) * omega0 + Omega);
  factor[0] = -Scalar(16.0) * omega0_5 * per_0_2 * per_1_3 / Omega;
  factor[1] = -Scalar(16.0) * omega0_3 * per_0_2 * per_1 * per_2;
}

/// Rows of the harmonic -omega0+2*Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega0 + 2*Omega)*t) in x = -16*omega0^5/(Omega*(omega0 + Omega)^2*(omega0 -
/// Omega)^3)*conservative_x_A_x_F2*conj(A_x)*F^2 - 16*omega0^3/((omega0 + Omega)^2*(omega0 - Omega)*(3*omega0 +
/// Omega))*conservative_x_conjA_x2_F*A_x^2*F
/// 2 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_3(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (conj_A_x * F * F));  // conservative_x_A_x_F2
    store_complex(column_1, i, factor[1] * (A_x * A_x * F));  // conservative_x_conjA_x2_F
  }
}

/// columns[j][i] of the rows.
inline void columns_3(const BatchArrays& data, double* const* columns) {
  rows_3(data, FactorValues<factors_3<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_3(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_3(data, FactorSlopes<factors_3<DualNumber>, 1, 1, 2>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic 0 of x: functions of the frequencies alone. 2 operations.
template <class Scalar>
void factors_4([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  factor[0] = -Scalar(2.0) / omega0_2;
  factor[1] = Scalar(1.0);
}

/// Rows of the harmonic 0 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in x = -2/omega0^2*a2*A_x*conj(A_x) + harmonic_re_x_F2*F^2
/// 2 columns; per observation at most 2 products and sums of complex numbers.
template <class Factors>
void rows_4(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex F = load_complex(forcing_0, i);
    const Scalar norm_F = norm_of(F);
    store_complex(column_0, i, Complex(factor[0] * (norm_A_x)));  // a2
    store_complex(column_1, i, Complex(factor[1] * (norm_F)));  // harmonic_re_x_F2
  }
}

/// columns[j][i] of the rows.
inline void columns_4(const BatchArrays& data, double* const* columns) {
  rows_4(data, FactorValues<factors_4<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_4(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_4(data, FactorSlopes<factors_4<DualNumber>, 1, 1, 2>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 2*Omega of x: functions of the frequencies alone. 22 operations.
template <class Scalar>
void factors_5([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar omega0_5 = omega0_4 * omega0;
  const Scalar omega0_6 = omega0_5 * omega0;
  const Scalar per_0 = Scalar(1.0) / (omega0 + Omega);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega0 + Scalar(2.0) * Omega);
  const Scalar per_2 = Scalar(1.0) / (omega0 - Omega);
  const Scalar per_2_2 = per_2 * per_2;
  const Scalar per_3 = Scalar(1.0) / (omega0 - Scalar(2.0) * Omega);
  factor[0] = Scalar(32.0) * omega0_6 * per_0_2 * per_1 * per_2_2 * per_3;
}

/// Rows of the harmonic 2*Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*Omega)*t) in x = 32*omega0^6/((omega0 + Omega)^2*(omega0 + 2*Omega)*(omega0 -
/// Omega)^2*(omega0 - 2*Omega))*harmonic_re_x_F2*F^2
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_5(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (F * F));  // harmonic_re_x_F2
  }
}

/// columns[j][i] of the rows.
inline void columns_5(const BatchArrays& data, double* const* columns) {
  rows_5(data, FactorValues<factors_5<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_5(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_5(data, FactorSlopes<factors_5<DualNumber>, 1, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 3*Omega of x: functions of the frequencies alone. 27 operations.
template <class Scalar>
void factors_6([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar omega0_5 = omega0_4 * omega0;
  const Scalar omega0_6 = omega0_5 * omega0;
  const Scalar omega0_7 = omega0_6 * omega0;
  const Scalar omega0_8 = omega0_7 * omega0;
  const Scalar per_0 = Scalar(1.0) / (omega0 + Omega);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_0_3 = per_0_2 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega0 + Scalar(3.0) * Omega);
  const Scalar per_2 = Scalar(1.0) / (omega0 - Omega);
  const Scalar per_2_2 = per_2 * per_2;
  const Scalar per_2_3 = per_2_2 * per_2;
  const Scalar per_3 = Scalar(1.0) / (omega0 - Scalar(3.0) * Omega);
  factor[0] = Scalar(4096.0) * omega0_8 * per_0_3 * per_1 * per_2_3 * per_3 / Scalar(3.0);
}

/// Rows of the harmonic 3*Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*Omega)*t) in x = 4096*omega0^8/(3*(omega0 + Omega)^3*(omega0 + 3*Omega)*(omega0 -
/// Omega)^3*(omega0 - 3*Omega))*harmonic_re_x_F3*F^3
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_6(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (F * F * F));  // harmonic_re_x_F3
  }
}

/// columns[j][i] of the rows.
inline void columns_6(const BatchArrays& data, double* const* columns) {
  rows_6(data, FactorValues<factors_6<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_6(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_6(data, FactorSlopes<factors_6<DualNumber>, 1, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic omega0+Omega of x: functions of the frequencies alone. 15
/// operations.
template <class Scalar>
void factors_7([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar per_0 = Scalar(1.0) / (omega0 + Omega);
  const Scalar per_1 = Scalar(1.0) / (omega0 - Omega);
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega0 + Omega);
  factor[0] = -Scalar(24.0) * omega0_4 * per_0 * per_1 * per_2 / Omega;
}

/// Rows of the harmonic omega0+Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega0 + Omega)*t) in x = -24*omega0^4/(Omega*(omega0 + Omega)*(omega0 - Omega)*(2*omega0
/// + Omega))*harmonic_re_x_conjA_x_F*A_x*F
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_7(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_x * F));  // harmonic_re_x_conjA_x_F
  }
}

/// columns[j][i] of the rows.
inline void columns_7(const BatchArrays& data, double* const* columns) {
  rows_7(data, FactorValues<factors_7<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_7(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_7(data, FactorSlopes<factors_7<DualNumber>, 1, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic omega0+2*Omega of x: functions of the frequencies alone. 15
/// operations.
template <class Scalar>
void factors_8([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar omega0_5 = omega0_4 * omega0;
  const Scalar per_0 = Scalar(1.0) / (omega0 + Omega);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_0_3 = per_0_2 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega0 - Omega);
  const Scalar per_1_2 = per_1 * per_1;
  factor[0] = Scalar(16.0) * omega0_5 * per_0_3 * per_1_2 / Omega;
}

/// Rows of the harmonic omega0+2*Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega0 + 2*Omega)*t) in x = 16*omega0^5/(Omega*(omega0 + Omega)^3*(omega0 -
/// Omega)^2)*conservative_x_A_x_F2*A_x*F^2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_8(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_x * F * F));  // conservative_x_A_x_F2
  }
}

/// columns[j][i] of the rows.
inline void columns_8(const BatchArrays& data, double* const* columns) {
  rows_8(data, FactorValues<factors_8<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_8(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_8(data, FactorSlopes<factors_8<DualNumber>, 1, 1, 1>{mode}, columns);
}

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_x/dt + i*(w_x - omega0)*B_x = -mu*A_x + i*conservative_x_A_x_F2*A_x*F^2 +
/// 3/(2*omega0)*i*a3*A_x^2*conj(A_x) + i*conservative_x_conjA_x2_F*conj(A_x)^2*F with A = B in that frame
/// 19 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega0 = parameters[0];
  Scalar lumps[10];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Complex conj_A_x = conjugate(A_x);
  const Scalar norm_A_x = norm_of(A_x);
  const Complex F = load_complex(forcing, 0);
  const Scalar norm_F = norm_of(F);
  store_complex(derivative, 0, lumps[0] * (-Scalar(1.0)) * (A_x)
       + times_i(lumps[1] * (A_x * norm_F))
       + times_i(lumps[2] * Scalar(3.0) / (Scalar(2.0) * omega0) * (norm_A_x * A_x))
       + times_i(lumps[3] * (conj_A_x * conj_A_x * F))
       - times_i((-omega0 + excitation_frequency[0] / Scalar(3.0)) * A_x));
}

/// jacobian[i * 2 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 25 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega0 = parameters[0];
  Scalar lumps[10];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Complex conj_A_x = conjugate(A_x);
  const Scalar norm_A_x = norm_of(A_x);
  const Complex F = load_complex(forcing, 0);
  const Scalar norm_F = norm_of(F);
  for (std::size_t i = 0; i < 4; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = Complex(lumps[0] * (-Scalar(1.0)))
       + times_i(Complex(lumps[1] * (norm_F)))
       + times_i(Complex(lumps[2] * Scalar(3.0) / (Scalar(2.0) * omega0) * Scalar(2) * (norm_A_x)))
       - Complex(Scalar(0.0), -omega0 + excitation_frequency[0] / Scalar(3.0));
  const Complex conj_by_0_0 = times_i(lumps[2] * Scalar(3.0) / (Scalar(2.0) * omega0) * (A_x * A_x))
       + times_i(lumps[3] * Scalar(2) * (conj_A_x * F));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[2] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[3] = by_0_0.real - conj_by_0_0.real;
}

}  // namespace subharmonic_3

namespace subharmonic_3_second_order {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: conservative_x_A_x4_F = -3*a3^2*e/(32*omega0^5)
/// lumps[1]: mu = mu
/// lumps[2]: conservative_x_A_x = -mu^2/(2*omega0)
/// lumps[3]: conservative_x_A_x_F2 = (15*omega0^2*a3*e^2 - 6*a2^2*e^2)/(1280*omega0^7)
/// lumps[4]: conservative_x_A_x_F2_sigma = -9*a3*e^2/(512*omega0^6)
/// lumps[5]: conservative_x_A_x_F4 = -63*a3^2*e^4/(2097152*omega0^11)
/// lumps[6]: dissipative_x_A_x2_conjA_x = 3*mu*a3/(2*omega0^2)
/// lumps[7]: conservative_x_A_x2_conjA_x = (9*omega0^2*a3 - 10*a2^2)/(6*omega0^3)
/// lumps[8]: conservative_x_A_x2_conjA_x_F2 = 21*a3^2*e^2/(2048*omega0^7)
/// lumps[9]: conservative_x_A_x3_conjA_x2 = -15*a3^2/(16*omega0^3)
/// lumps[10]: dissipative_x_conjA_x2_F = 3*mu*a3*e/(128*omega0^4)
/// lumps[11]: conservative_x_conjA_x2_F = (-3*omega0^2*a3*e - 2*a2^2*e)/(32*omega0^5)
/// lumps[12]: conservative_x_conjA_x2_F_sigma = 15*a3*e/(128*omega0^4)
/// lumps[13]: conservative_x_conjA_x2_F3 = -27*a3^2*e^3/(32768*omega0^9)
/// lumps[14]: e = e
/// lumps[15]: harmonic_im_x_F = -3*mu*e/(64*omega0^3)
/// lumps[16]: harmonic_re_x_F3 = -3*a3*e^3/(32768*omega0^8)
/// lumps[17]: a3 = a3
/// lumps[18]: harmonic_re_x_F = 9*mu^2*e/(256*omega0^4)
/// lumps[19]: harmonic_im_x_F3 = -9*mu*a3*e^3/(65536*omega0^9)
/// lumps[20]: harmonic_re_x_F5 = -273*a3^2*e^5/(671088640*omega0^14)
/// lumps[21]: harmonic_re_x_A_x_conjA_x_F = 3*a2^2*e/(160*omega0^6)
/// lumps[22]: harmonic_re_x_A_x3 = a2^2/(12*omega0^4)
/// lumps[23]: harmonic_re_x_conjA_x_F = -a2*e/(24*omega0^4)
/// lumps[24]: a2 = a2
/// lumps[25]: harmonic_re_x_A_x2_F2 = a2*a3*e^2/(192*omega0^8)
/// lumps[26]: harmonic_im_x_conjA_x_F = -mu*a2*e/(32*omega0^5)
/// lumps[27]: harmonic_re_x_conjA_x_F3 = -11*a2*a3*e^3/(86016*omega0^10)
/// lumps[28]: harmonic_re_x_A_x_conjA_x2_F = a2*a3*e/(480*omega0^6)
/// lumps[29]: harmonic_im_x_A_x2 = -4*mu*a2/(9*omega0^3)
/// lumps[30]: harmonic_re_x_A_x3_conjA_x = -31*a2*a3/(12*omega0^4)
/// lumps[31]: harmonic_re_x_conjA_x_F2 = 73*a2^2*e^2/(322560*omega0^8)
/// lumps[32]: harmonic_im_x_conjA_x_F2 = 3*mu*a3*e^2/(4096*omega0^7)
/// lumps[33]: harmonic_re_x_F2 = -a2*e^2/(128*omega0^6)
/// lumps[34]: harmonic_re_x_F4 = 723*a2*a3*e^4/(4587520*omega0^12)
/// lumps[35]: harmonic_im_x_F2 = 129*mu*a2*e^2/(627200*omega0^7)
/// 137 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
  const Scalar omega0 = parameters[0];
  const Scalar mu = parameters[1];
  const Scalar a2 = parameters[2];
  const Scalar a3 = parameters[3];
  const Scalar e = parameters[4];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar omega0_5 = omega0_4 * omega0;
  const Scalar omega0_6 = omega0_5 * omega0;
  const Scalar omega0_7 = omega0_6 * omega0;
  const Scalar omega0_8 = omega0_7 * omega0;
  const Scalar omega0_9 = omega0_8 * omega0;
  const Scalar omega0_10 = omega0_9 * omega0;
  const Scalar omega0_11 = omega0_10 * omega0;
  const Scalar omega0_12 = omega0_11 * omega0;
  const Scalar omega0_13 = omega0_12 * omega0;
  const Scalar omega0_14 = omega0_13 * omega0;
  const Scalar mu_2 = mu * mu;
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar e_2 = e * e;
  const Scalar e_3 = e_2 * e;
  const Scalar e_4 = e_3 * e;
  const Scalar e_5 = e_4 * e;
  lumps[0] = -Scalar(3.0) * a3_2 * e / (Scalar(32.0) * omega0_5);  // conservative_x_A_x4_F
  lumps[1] = mu;  // mu
  lumps[2] = -mu_2 / (Scalar(2.0) * omega0);  // conservative_x_A_x
  // conservative_x_A_x_F2
  lumps[3] = (Scalar(15.0) * omega0_2 * a3 * e_2 - Scalar(6.0) * a2_2 * e_2) / (Scalar(1280.0) * omega0_7);
  lumps[4] = -Scalar(9.0) * a3 * e_2 / (Scalar(512.0) * omega0_6);  // conservative_x_A_x_F2_sigma
  lumps[5] = -Scalar(63.0) * a3_2 * e_4 / (Scalar(2097152.0) * omega0_11);  // conservative_x_A_x_F4
  lumps[6] = Scalar(3.0) * mu * a3 / (Scalar(2.0) * omega0_2);  // dissipative_x_A_x2_conjA_x
  // conservative_x_A_x2_conjA_x
  lumps[7] = (Scalar(9.0) * omega0_2 * a3 - Scalar(10.0) * a2_2) / (Scalar(6.0) * omega0_3);
  lumps[8] = Scalar(21.0) * a3_2 * e_2 / (Scalar(2048.0) * omega0_7);  // conservative_x_A_x2_conjA_x_F2
  lumps[9] = -Scalar(15.0) * a3_2 / (Scalar(16.0) * omega0_3);  // conservative_x_A_x3_conjA_x2
  lumps[10] = Scalar(3.0) * mu * a3 * e / (Scalar(128.0) * omega0_4);  // dissipative_x_conjA_x2_F
  // conservative_x_conjA_x2_F
  lumps[11] = (-Scalar(3.0) * omega0_2 * a3 * e - Scalar(2.0) * a2_2 * e) / (Scalar(32.0) * omega0_5);
  lumps[12] = Scalar(15.0) * a3 * e / (Scalar(128.0) * omega0_4);  // conservative_x_conjA_x2_F_sigma
  lumps[13] = -Scalar(27.0) * a3_2 * e_3 / (Scalar(32768.0) * omega0_9);  // conservative_x_conjA_x2_F3
  lumps[14] = e;  // e
  lumps[15] = -Scalar(3.0) * mu * e / (Scalar(64.0) * omega0_3);  // harmonic_im_x_F
  lumps[16] = -Scalar(3.0) * a3 * e_3 / (Scalar(32768.0) * omega0_8);  // harmonic_re_x_F3
  lumps[17] = a3;  // a3
  lumps[18] = Scalar(9.0) * mu_2 * e / (Scalar(256.0) * omega0_4);  // harmonic_re_x_F
  lumps[19] = -Scalar(9.0) * mu * a3 * e_3 / (Scalar(65536.0) * omega0_9);  // harmonic_im_x_F3
  lumps[20] = -Scalar(273.0) * a3_2 * e_5 / (Scalar(671088640.0) * omega0_14);  // harmonic_re_x_F5
  lumps[21] = Scalar(3.0) * a2_2 * e / (Scalar(160.0) * omega0_6);  // harmonic_re_x_A_x_conjA_x_F
  lumps[22] = a2_2 / (Scalar(12.0) * omega0_4);  // harmonic_re_x_A_x3
  lumps[23] = -a2 * e / (Scalar(24.0) * omega0_4);  // harmonic_re_x_conjA_x_F
  lumps[24] = a2;  // a2
  lumps[25] = a2 * a3 * e_2 / (Scalar(192.0) * omega0_8);  // harmonic_re_x_A_x2_F2
  lumps[26] = -mu * a2 * e / (Scalar(32.0) * omega0_5);  // harmonic_im_x_conjA_x_F
  lumps[27] = -Scalar(11.0) * a2 * a3 * e_3 / (Scalar(86016.0) * omega0_10);  // harmonic_re_x_conjA_x_F3
  lumps[28] = a2 * a3 * e / (Scalar(480.0) * omega0_6);  // harmonic_re_x_A_x_conjA_x2_F
  lumps[29] = -Scalar(4.0) * mu * a2 / (Scalar(9.0) * omega0_3);  // harmonic_im_x_A_x2
  lumps[30] = -Scalar(31.0) * a2 * a3 / (Scalar(12.0) * omega0_4);  // harmonic_re_x_A_x3_conjA_x
  lumps[31] = Scalar(73.0) * a2_2 * e_2 / (Scalar(322560.0) * omega0_8);  // harmonic_re_x_conjA_x_F2
  lumps[32] = Scalar(3.0) * mu * a3 * e_2 / (Scalar(4096.0) * omega0_7);  // harmonic_im_x_conjA_x_F2
  lumps[33] = -a2 * e_2 / (Scalar(128.0) * omega0_6);  // harmonic_re_x_F2
  lumps[34] = Scalar(723.0) * a2 * a3 * e_4 / (Scalar(4587520.0) * omega0_12);  // harmonic_re_x_F4
  lumps[35] = Scalar(129.0) * mu * a2 * e_2 / (Scalar(627200.0) * omega0_7);  // harmonic_im_x_F2
}

/// jacobian[l * 5 + p] = d lumps[l] / d parameters[p]. 395 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  const Scalar omega0 = parameters[0];
  const Scalar mu = parameters[1];
  const Scalar a2 = parameters[2];
  const Scalar a3 = parameters[3];
  const Scalar e = parameters[4];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar omega0_5 = omega0_4 * omega0;
  const Scalar omega0_6 = omega0_5 * omega0;
  const Scalar omega0_7 = omega0_6 * omega0;
  const Scalar omega0_8 = omega0_7 * omega0;
  const Scalar omega0_9 = omega0_8 * omega0;
  const Scalar omega0_10 = omega0_9 * omega0;
  const Scalar omega0_11 = omega0_10 * omega0;
  const Scalar omega0_12 = omega0_11 * omega0;
  const Scalar omega0_13 = omega0_12 * omega0;
  const Scalar omega0_14 = omega0_13 * omega0;
  const Scalar omega0_15 = omega0_14 * omega0;
  const Scalar mu_2 = mu * mu;
  const Scalar a2_2 = a2 * a2;
  const Scalar a3_2 = a3 * a3;
  const Scalar e_2 = e * e;
  const Scalar e_3 = e_2 * e;
  const Scalar e_4 = e_3 * e;
  const Scalar e_5 = e_4 * e;
  for (std::size_t i = 0; i < 180; ++i) jacobian[i] = Scalar(0.0);
  jacobian[0] = Scalar(15.0) * a3_2 * e / (Scalar(32.0) * omega0_6);  // d conservative_x_A_x4_F / d omega0
  jacobian[3] = -Scalar(3.0) * a3 * e / (Scalar(16.0) * omega0_5);  // d conservative_x_A_x4_F / d a3
  jacobian[4] = -Scalar(3.0) * a3_2 / (Scalar(32.0) * omega0_5);  // d conservative_x_A_x4_F / d e
  jacobian[6] = Scalar(1.0);  // d mu / d mu
  jacobian[10] = mu_2 / (Scalar(2.0) * omega0_2);  // d conservative_x_A_x / d omega0
  jacobian[11] = -mu / omega0;  // d conservative_x_A_x / d mu
  // d conservative_x_A_x_F2 / d omega0
  jacobian[15] = (-Scalar(75.0) * omega0_2 * a3 * e_2 + Scalar(42.0) * a2_2 * e_2) / (Scalar(1280.0) * omega0_8);
  jacobian[17] = -Scalar(3.0) * a2 * e_2 / (Scalar(320.0) * omega0_7);  // d conservative_x_A_x_F2 / d a2
  jacobian[18] = Scalar(3.0) * e_2 / (Scalar(256.0) * omega0_5);  // d conservative_x_A_x_F2 / d a3
  // d conservative_x_A_x_F2 / d e
  jacobian[19] = (Scalar(15.0) * omega0_2 * a3 * e - Scalar(6.0) * a2_2 * e) / (Scalar(640.0) * omega0_7);
  // d conservative_x_A_x_F2_sigma / d omega0
  jacobian[20] = Scalar(27.0) * a3 * e_2 / (Scalar(256.0) * omega0_7);
  jacobian[23] = -Scalar(9.0) * e_2 / (Scalar(512.0) * omega0_6);  // d conservative_x_A_x_F2_sigma / d a3
  jacobian[24] = -Scalar(9.0) * a3 * e / (Scalar(256.0) * omega0_6);  // d conservative_x_A_x_F2_sigma / d e
  // d conservative_x_A_x_F4 / d omega0
  jacobian[25] = Scalar(693.0) * a3_2 * e_4 / (Scalar(2097152.0) * omega0_12);
  jacobian[28] = -Scalar(63.0) * a3 * e_4 / (Scalar(1048576.0) * omega0_11);  // d conservative_x_A_x_F4 / d a3
  jacobian[29] = -Scalar(63.0) * a3_2 * e_3 / (Scalar(524288.0) * omega0_11);  // d conservative_x_A_x_F4 / d e
  jacobian[30] = -Scalar(3.0) * mu * a3 / omega0_3;  // d dissipative_x_A_x2_conjA_x / d omega0
  jacobian[31] = Scalar(3.0) * a3 / (Scalar(2.0) * omega0_2);  // d dissipative_x_A_x2_conjA_x / d mu
  jacobian[33] = Scalar(3.0) * mu / (Scalar(2.0) * omega0_2);  // d dissipative_x_A_x2_conjA_x / d a3
  // d conservative_x_A_x2_conjA_x / d omega0
  jacobian[35] = (-Scalar(3.0) * omega0_2 * a3 + Scalar(10.0) * a2_2) / (Scalar(2.0) * omega0_4);
  jacobian[37] = -Scalar(10.0) * a2 / (Scalar(3.0) * omega0_3);  // d conservative_x_A_x2_conjA_x / d a2
  jacobian[38] = Scalar(3.0) / (Scalar(2.0) * omega0);  // d conservative_x_A_x2_conjA_x / d a3
  // d conservative_x_A_x2_conjA_x_F2 / d omega0
  jacobian[40] = -Scalar(147.0) * a3_2 * e_2 / (Scalar(2048.0) * omega0_8);
  // d conservative_x_A_x2_conjA_x_F2 / d a3
  jacobian[43] = Scalar(21.0) * a3 * e_2 / (Scalar(1024.0) * omega0_7);
  jacobian[44] = Scalar(21.0) * a3_2 * e / (Scalar(1024.0) * omega0_7);  // d conservative_x_A_x2_conjA_x_F2 / d e
  jacobian[45] = Scalar(45.0) * a3_2 / (Scalar(16.0) * omega0_4);  // d conservative_x_A_x3_conjA_x2 / d omega0
  jacobian[48] = -Scalar(15.0) * a3 / (Scalar(8.0) * omega0_3);  // d conservative_x_A_x3_conjA_x2 / d a3
  jacobian[50] = -Scalar(3.0) * mu * a3 * e / (Scalar(32.0) * omega0_5);  // d dissipative_x_conjA_x2_F / d omega0
  jacobian[51] = Scalar(3.0) * a3 * e / (Scalar(128.0) * omega0_4);  // d dissipative_x_conjA_x2_F / d mu
  jacobian[53] = Scalar(3.0) * mu * e / (Scalar(128.0) * omega0_4);  // d dissipative_x_conjA_x2_F / d a3
  jacobian[54] = Scalar(3.0) * mu * a3 / (Scalar(128.0) * omega0_4);  // d dissipative_x_conjA_x2_F / d e
  // d conservative_x_conjA_x2_F / d omega0
  jacobian[55] = (Scalar(9.0) * omega0_2 * a3 * e + Scalar(10.0) * a2_2 * e) / (Scalar(32.0) * omega0_6);
  jacobian[57] = -a2 * e / (Scalar(8.0) * omega0_5);  // d conservative_x_conjA_x2_F / d a2
  jacobian[58] = -Scalar(3.0) * e / (Scalar(32.0) * omega0_3);  // d conservative_x_conjA_x2_F / d a3
  // d conservative_x_conjA_x2_F / d e
  jacobian[59] = (-Scalar(3.0) * omega0_2 * a3 - Scalar(2.0) * a2_2) / (Scalar(32.0) * omega0_5);
  // d conservative_x_conjA_x2_F_sigma / d omega0
  jacobian[60] = -Scalar(15.0) * a3 * e / (Scalar(32.0) * omega0_5);
  jacobian[63] = Scalar(15.0) * e / (Scalar(128.0) * omega0_4);  // d conservative_x_conjA_x2_F_sigma / d a3
  jacobian[64] = Scalar(15.0) * a3 / (Scalar(128.0) * omega0_4);  // d conservative_x_conjA_x2_F_sigma / d e
  // d conservative_x_conjA_x2_F3 / d omega0
  jacobian[65] = Scalar(243.0) * a3_2 * e_3 / (Scalar(32768.0) * omega0_10);
  jacobian[68] = -Scalar(27.0) * a3 * e_3 / (Scalar(16384.0) * omega0_9);  // d conservative_x_conjA_x2_F3 / d a3
  jacobian[69] = -Scalar(81.0) * a3_2 * e_2 / (Scalar(32768.0) * omega0_9);  // d conservative_x_conjA_x2_F3 / d e
  jacobian[74] = Scalar(1.0);  // d e / d e
  jacobian[75] = Scalar(9.0) * mu * e / (Scalar(64.0) * omega0_4);  // d harmonic_im_x_F / d omega0
  jacobian[76] = -Scalar(3.0) * e / (Scalar(64.0) * omega0_3);  // d harmonic_im_x_F / d mu
  jacobian[79] = -Scalar(3.0) * mu / (Scalar(64.0) * omega0_3);  // d harmonic_im_x_F / d e
  jacobian[80] = Scalar(3.0) * a3 * e_3 / (Scalar(4096.0) * omega0_9);  // d harmonic_re_x_F3 / d omega0
  jacobian[83] = -Scalar(3.0) * e_3 / (Scalar(32768.0) * omega0_8);  // d harmonic_re_x_F3 / d a3
  jacobian[84] = -Scalar(9.0) * a3 * e_2 / (Scalar(32768.0) * omega0_8);  // d harmonic_re_x_F3 / d e
  jacobian[88] = Scalar(1.0);  // d a3 / d a3
  jacobian[90] = -Scalar(9.0) * mu_2 * e / (Scalar(64.0) * omega0_5);  // d harmonic_re_x_F / d omega0
  jacobian[91] = Scalar(9.0) * mu * e / (Scalar(128.0) * omega0_4);  // d harmonic_re_x_F / d mu
  jacobian[94] = Scalar(9.0) * mu_2 / (Scalar(256.0) * omega0_4);  // d harmonic_re_x_F / d e
  jacobian[95] = Scalar(81.0) * mu * a3 * e_3 / (Scalar(65536.0) * omega0_10);  // d harmonic_im_x_F3 / d omega0
  jacobian[96] = -Scalar(9.0) * a3 * e_3 / (Scalar(65536.0) * omega0_9);  // d harmonic_im_x_F3 / d mu
  jacobian[98] = -Scalar(9.0) * mu * e_3 / (Scalar(65536.0) * omega0_9);  // d harmonic_im_x_F3 / d a3
  jacobian[99] = -Scalar(27.0) * mu * a3 * e_2 / (Scalar(65536.0) * omega0_9);  // d harmonic_im_x_F3 / d e
  // d harmonic_re_x_F5 / d omega0
  jacobian[100] = Scalar(1911.0) * a3_2 * e_5 / (Scalar(335544320.0) * omega0_15);
  jacobian[103] = -Scalar(273.0) * a3 * e_5 / (Scalar(335544320.0) * omega0_14);  // d harmonic_re_x_F5 / d a3
  jacobian[104] = -Scalar(273.0) * a3_2 * e_4 / (Scalar(134217728.0) * omega0_14);  // d harmonic_re_x_F5 / d e
  // d harmonic_re_x_A_x_conjA_x_F / d omega0
  jacobian[105] = -Scalar(9.0) * a2_2 * e / (Scalar(80.0) * omega0_7);
  jacobian[107] = Scalar(3.0) * a2 * e / (Scalar(80.0) * omega0_6);  // d harmonic_re_x_A_x_conjA_x_F / d a2
  jacobian[109] = Scalar(3.0) * a2_2 / (Scalar(160.0) * omega0_6);  // d harmonic_re_x_A_x_conjA_x_F / d e
  jacobian[110] = -a2_2 / (Scalar(3.0) * omega0_5);  // d harmonic_re_x_A_x3 / d omega0
  jacobian[112] = a2 / (Scalar(6.0) * omega0_4);  // d harmonic_re_x_A_x3 / d a2
  jacobian[115] = a2 * e / (Scalar(6.0) * omega0_5);  // d harmonic_re_x_conjA_x_F / d omega0
  jacobian[117] = -e / (Scalar(24.0) * omega0_4);  // d harmonic_re_x_conjA_x_F / d a2
  jacobian[119] = -a2 / (Scalar(24.0) * omega0_4);  // d harmonic_re_x_conjA_x_F / d e
  jacobian[122] = Scalar(1.0);  // d a2 / d a2
  jacobian[125] = -a2 * a3 * e_2 / (Scalar(24.0) * omega0_9);  // d harmonic_re_x_A_x2_F2 / d omega0
  jacobian[127] = a3 * e_2 / (Scalar(192.0) * omega0_8);  // d harmonic_re_x_A_x2_F2 / d a2
  jacobian[128] = a2 * e_2 / (Scalar(192.0) * omega0_8);  // d harmonic_re_x_A_x2_F2 / d a3
  jacobian[129] = a2 * a3 * e / (Scalar(96.0) * omega0_8);  // d harmonic_re_x_A_x2_F2 / d e
  jacobian[130] = Scalar(5.0) * mu * a2 * e / (Scalar(32.0) * omega0_6);  // d harmonic_im_x_conjA_x_F / d omega0
  jacobian[131] = -a2 * e / (Scalar(32.0) * omega0_5);  // d harmonic_im_x_conjA_x_F / d mu
  jacobian[132] = -mu * e / (Scalar(32.0) * omega0_5);  // d harmonic_im_x_conjA_x_F / d a2
  jacobian[134] = -mu * a2 / (Scalar(32.0) * omega0_5);  // d harmonic_im_x_conjA_x_F / d e
  // d harmonic_re_x_conjA_x_F3 / d omega0
  jacobian[135] = Scalar(55.0) * a2 * a3 * e_3 / (Scalar(43008.0) * omega0_11);
  jacobian[137] = -Scalar(11.0) * a3 * e_3 / (Scalar(86016.0) * omega0_10);  // d harmonic_re_x_conjA_x_F3 / d a2
  jacobian[138] = -Scalar(11.0) * a2 * e_3 / (Scalar(86016.0) * omega0_10);  // d harmonic_re_x_conjA_x_F3 / d a3
  // d harmonic_re_x_conjA_x_F3 / d e
  jacobian[139] = -Scalar(11.0) * a2 * a3 * e_2 / (Scalar(28672.0) * omega0_10);
  jacobian[140] = -a2 * a3 * e / (Scalar(80.0) * omega0_7);  // d harmonic_re_x_A_x_conjA_x2_F / d omega0
  jacobian[142] = a3 * e / (Scalar(480.0) * omega0_6);  // d harmonic_re_x_A_x_conjA_x2_F / d a2
  jacobian[143] = a2 * e / (Scalar(480.0) * omega0_6);  // d harmonic_re_x_A_x_conjA_x2_F / d a3
  jacobian[144] = a2 * a3 / (Scalar(480.0) * omega0_6);  // d harmonic_re_x_A_x_conjA_x2_F / d e
  jacobian[145] = Scalar(4.0) * mu * a2 / (Scalar(3.0) * omega0_4);  // d harmonic_im_x_A_x2 / d omega0
  jacobian[146] = -Scalar(4.0) * a2 / (Scalar(9.0) * omega0_3);  // d harmonic_im_x_A_x2 / d mu
  jacobian[147] = -Scalar(4.0) * mu / (Scalar(9.0) * omega0_3);  // d harmonic_im_x_A_x2 / d a2
  jacobian[150] = Scalar(31.0) * a2 * a3 / (Scalar(3.0) * omega0_5);  // d harmonic_re_x_A_x3_conjA_x / d omega0
  jacobian[152] = -Scalar(31.0) * a3 / (Scalar(12.0) * omega0_4);  // d harmonic_re_x_A_x3_conjA_x / d a2
  jacobian[153] = -Scalar(31.0) * a2 / (Scalar(12.0) * omega0_4);  // d harmonic_re_x_A_x3_conjA_x / d a3
  // d harmonic_re_x_conjA_x_F2 / d omega0
  jacobian[155] = -Scalar(73.0) * a2_2 * e_2 / (Scalar(40320.0) * omega0_9);
  jacobian[157] = Scalar(73.0) * a2 * e_2 / (Scalar(161280.0) * omega0_8);  // d harmonic_re_x_conjA_x_F2 / d a2
  jacobian[159] = Scalar(73.0) * a2_2 * e / (Scalar(161280.0) * omega0_8);  // d harmonic_re_x_conjA_x_F2 / d e
  // d harmonic_im_x_conjA_x_F2 / d omega0
  jacobian[160] = -Scalar(21.0) * mu * a3 * e_2 / (Scalar(4096.0) * omega0_8);
  jacobian[161] = Scalar(3.0) * a3 * e_2 / (Scalar(4096.0) * omega0_7);  // d harmonic_im_x_conjA_x_F2 / d mu
  jacobian[163] = Scalar(3.0) * mu * e_2 / (Scalar(4096.0) * omega0_7);  // d harmonic_im_x_conjA_x_F2 / d a3
  jacobian[164] = Scalar(3.0) * mu * a3 * e / (Scalar(2048.0) * omega0_7);  // d harmonic_im_x_conjA_x_F2 / d e
  jacobian[165] = Scalar(3.0) * a2 * e_2 / (Scalar(64.0) * omega0_7);  // d harmonic_re_x_F2 / d omega0
  jacobian[167] = -e_2 / (Scalar(128.0) * omega0_6);  // d harmonic_re_x_F2 / d a2
  jacobian[169] = -a2 * e / (Scalar(64.0) * omega0_6);  // d harmonic_re_x_F2 / d e
  // d harmonic_re_x_F4 / d omega0
  jacobian[170] = -Scalar(2169.0) * a2 * a3 * e_4 / (Scalar(1146880.0) * omega0_13);
  jacobian[172] = Scalar(723.0) * a3 * e_4 / (Scalar(4587520.0) * omega0_12);  // d harmonic_re_x_F4 / d a2
  jacobian[173] = Scalar(723.0) * a2 * e_4 / (Scalar(4587520.0) * omega0_12);  // d harmonic_re_x_F4 / d a3
  jacobian[174] = Scalar(723.0) * a2 * a3 * e_3 / (Scalar(1146880.0) * omega0_12);  // d harmonic_re_x_F4 / d e
  jacobian[175] = -Scalar(129.0) * mu * a2 * e_2 / (Scalar(89600.0) * omega0_8);  // d harmonic_im_x_F2 / d omega0
  jacobian[176] = Scalar(129.0) * a2 * e_2 / (Scalar(627200.0) * omega0_7);  // d harmonic_im_x_F2 / d mu
  jacobian[177] = Scalar(129.0) * mu * e_2 / (Scalar(627200.0) * omega0_7);  // d harmonic_im_x_F2 / d a2
  jacobian[179] = Scalar(129.0) * mu * a2 * e / (Scalar(313600.0) * omega0_7);  // d harmonic_im_x_F2 / d e
}

/// What multiplies the 15 terms of the modulation of x: functions of the frequencies alone. 4 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  factor[0] = Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = -Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = -Scalar(3.0) * omega0 + Omega;
  factor[6] = Scalar(1.0);
  factor[7] = Scalar(1.0);
  factor[8] = Scalar(1.0);
  factor[9] = Scalar(1.0);
  factor[10] = Scalar(1.0);
  factor[11] = Scalar(1.0);
  factor[12] = Scalar(1.0);
  factor[13] = -Scalar(3.0) * omega0 + Omega;
  factor[14] = Scalar(1.0);
}

/// Rows of the modulation of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega0)*A_x = i*conservative_x_A_x4_F*A_x^4*F + i*conservative_x_A_x4_F*A_x*conj(A_x)^3*F - mu*A_x
/// + i*conservative_x_A_x*A_x + i*conservative_x_A_x_F2*A_x*F^2 + (-3*omega0 +
/// Omega)*i*conservative_x_A_x_F2_sigma*A_x*F^2 + i*conservative_x_A_x_F4*A_x*F^4 +
/// dissipative_x_A_x2_conjA_x*A_x^2*conj(A_x) + i*conservative_x_A_x2_conjA_x*A_x^2*conj(A_x) +
/// i*conservative_x_A_x2_conjA_x_F2*A_x^2*conj(A_x)*F^2 + i*conservative_x_A_x3_conjA_x2*A_x^3*conj(A_x)^2 +
/// dissipative_x_conjA_x2_F*conj(A_x)^2*F + i*conservative_x_conjA_x2_F*conj(A_x)^2*F + (-3*omega0 +
/// Omega)*i*conservative_x_conjA_x2_F_sigma*conj(A_x)^2*F + i*conservative_x_conjA_x2_F3*conj(A_x)^2*F^3
/// 14 columns; per observation at most 62 products and sums of complex numbers.
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
  Scalar* __restrict column_7 = columns[7];
  Scalar* __restrict column_8 = columns[8];
  Scalar* __restrict column_9 = columns[9];
  Scalar* __restrict column_10 = columns[10];
  Scalar* __restrict column_11 = columns[11];
  Scalar* __restrict column_12 = columns[12];
  Scalar* __restrict column_13 = columns[13];
  Scalar factor[15];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    const Scalar norm_F = norm_of(F);
    // conservative_x_A_x4_F
    store_complex(column_0, i, times_i(factor[0] * (fixed_power<4>(A_x) * conj_F))
        + times_i(factor[1] * (norm_A_x * conj_A_x * conj_A_x * F)));
    store_complex(column_1, i, factor[2] * (A_x));  // mu
    store_complex(column_2, i, times_i(factor[3] * (A_x)));  // conservative_x_A_x
    store_complex(column_3, i, times_i(factor[4] * (A_x * norm_F)));  // conservative_x_A_x_F2
    store_complex(column_4, i, times_i(factor[5] * (A_x * norm_F)));  // conservative_x_A_x_F2_sigma
    store_complex(column_5, i, times_i(factor[6] * (A_x * norm_F * norm_F)));  // conservative_x_A_x_F4
    store_complex(column_6, i, factor[7] * (norm_A_x * A_x));  // dissipative_x_A_x2_conjA_x
    store_complex(column_7, i, times_i(factor[8] * (norm_A_x * A_x)));  // conservative_x_A_x2_conjA_x
    store_complex(column_8, i, times_i(factor[9] * (norm_A_x * A_x * norm_F)));  // conservative_x_A_x2_conjA_x_F2
    // conservative_x_A_x3_conjA_x2
    store_complex(column_9, i, times_i(factor[10] * (norm_A_x * norm_A_x * A_x)));
    store_complex(column_10, i, factor[11] * (conj_A_x * conj_A_x * F));  // dissipative_x_conjA_x2_F
    store_complex(column_11, i, times_i(factor[12] * (conj_A_x * conj_A_x * F)));  // conservative_x_conjA_x2_F
    // conservative_x_conjA_x2_F_sigma
    store_complex(column_12, i, times_i(factor[13] * (conj_A_x * conj_A_x * F)));
    // conservative_x_conjA_x2_F3
    store_complex(column_13, i, times_i(factor[14] * (conj_A_x * conj_A_x * norm_F * F)));
  }
}

/// columns[j][i] of the rows.
inline void columns_0(const BatchArrays& data, double* const* columns) {
  rows_0(data, FactorValues<factors_0<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_0(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_0(data, FactorSlopes<factors_0<DualNumber>, 1, 1, 15>{mode}, columns);
}

/// What multiplies the 25 terms of the harmonic Omega of x: functions of the frequencies alone. 54 operations.
template <class Scalar>
void factors_1([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar Omega_2 = Omega * Omega;
  factor[0] = Scalar(13.0) / (Scalar(32.0) * omega0);
  factor[1] = -Scalar(9.0) / (Scalar(32.0) * omega0);
  factor[2] = -Scalar(1.0) / (Scalar(8.0) * omega0);
  factor[3] = Scalar(1.0) / (Scalar(28.0) * omega0);
  factor[4] = Scalar(9.0) / (Scalar(28.0) * omega0);
  factor[5] = -Scalar(9.0) / (Scalar(28.0) * omega0);
  factor[6] = -Scalar(1.0) / (Scalar(4.0) * omega0);
  factor[7] = Scalar(7.0) / (Scalar(20.0) * omega0);
  factor[8] = -Scalar(2.0) / Scalar(5.0);
  factor[9] = (-Scalar(9.0) * omega0 + Scalar(3.0) * Omega) / (Scalar(5.0) * omega0);
  factor[10] = Scalar(3.0) / (Scalar(8.0) * omega0);
  factor[11] = -Scalar(1.0) / (Scalar(16.0) * omega0_2);
  factor[12] = (-Scalar(9.0) * omega0 + Scalar(3.0) * Omega) / (Scalar(64.0) * omega0_3);
  factor[13] = (-Scalar(63.0) * omega0_2 + Scalar(42.0) * omega0 * Omega
      - Scalar(7.0) * Omega_2) / (Scalar(256.0) * omega0_4);
  factor[14] = Scalar(1.0);
  factor[15] = (Scalar(21.0) * omega0 - Scalar(7.0) * Omega) / (Scalar(6.0) * omega0);
  factor[16] = Scalar(1.0);
  factor[17] = Scalar(1.0);
  factor[18] = (Scalar(9.0) * omega0 - Scalar(3.0) * Omega) / omega0;
  factor[19] = Scalar(1.0) / (Scalar(8.0) * omega0_2);
  factor[20] = Scalar(1.0);
  factor[21] = Scalar(1.0);
  factor[22] = Scalar(1.0);
  factor[23] = Scalar(1.0);
  factor[24] = Scalar(1.0);
}

/// Rows of the harmonic Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(Omega)*t) in x = 13/(32*omega0)*conservative_x_A_x4_F*A_x^2*conj(A_x)^2*F -
/// 9/(32*omega0)*conservative_x_A_x4_F*A_x^2*conj(A_x)^2*F - 1/(8*omega0)*i*dissipative_x_A_x2_conjA_x*A_x^3 +
/// 1/(28*omega0)*conservative_x_A_x2_conjA_x_F2*conj(A_x)^3*F^2 +
/// 9/(28*omega0)*conservative_x_A_x2_conjA_x_F2*A_x^3*F^2 -
/// 9/(28*omega0)*conservative_x_A_x2_conjA_x_F2*conj(A_x)^3*F^2 -
/// 1/(4*omega0)*conservative_x_A_x2_conjA_x_F2*A_x^3*F^2 +
/// 7/(20*omega0)*conservative_x_A_x3_conjA_x2*A_x^4*conj(A_x) -
/// 2/5*conservative_x_conjA_x2_F_sigma*A_x*conj(A_x)*F + (-9*omega0 +
/// 3*Omega)/(5*omega0)*conservative_x_conjA_x2_F_sigma*A_x*conj(A_x)*F +
/// 3/(8*omega0)*conservative_x_conjA_x2_F3*A_x*conj(A_x)*F^3 - 1/(16*omega0^2)*e*F + (-9*omega0 +
/// 3*Omega)/(64*omega0^3)*e*F + (-63*omega0^2 + 42*omega0*Omega - 7*Omega^2)/(256*omega0^4)*e*F +
/// i*harmonic_im_x_F*F + (21*omega0 - 7*Omega)/(6*omega0)*i*harmonic_im_x_F*F + harmonic_re_x_F3*F^3 +
/// harmonic_re_x_F3*F^3 + (9*omega0 - 3*Omega)/omega0*harmonic_re_x_F3*F^3 + 1/(8*omega0^2)*a3*A_x^3 +
/// harmonic_re_x_F*F + i*harmonic_im_x_F3*F^3 + harmonic_re_x_F5*F^5 +
/// harmonic_re_x_A_x_conjA_x_F*A_x*conj(A_x)*F + harmonic_re_x_A_x3*A_x^3
/// 15 columns; per observation at most 111 products and sums of complex numbers.
template <class Factors>
void rows_1(const BatchArrays& data, Factors factors, double* const* columns) {
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
  Scalar* __restrict column_7 = columns[7];
  Scalar* __restrict column_8 = columns[8];
  Scalar* __restrict column_9 = columns[9];
  Scalar* __restrict column_10 = columns[10];
  Scalar* __restrict column_11 = columns[11];
  Scalar* __restrict column_12 = columns[12];
  Scalar* __restrict column_13 = columns[13];
  Scalar* __restrict column_14 = columns[14];
  Scalar factor[25];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex F = load_complex(forcing_0, i);
    const Scalar norm_F = norm_of(F);
    // conservative_x_A_x4_F
    store_complex(column_0, i, factor[0] * (norm_A_x * norm_A_x * F) + factor[1] * (norm_A_x * norm_A_x * F));
    store_complex(column_1, i, times_i(factor[2] * (A_x * A_x * A_x)));  // dissipative_x_A_x2_conjA_x
    // conservative_x_A_x2_conjA_x_F2
    store_complex(column_2, i, factor[3] * (conj_A_x * conj_A_x * conj_A_x * F * F)
        + factor[4] * (A_x * A_x * A_x * norm_F) + factor[5] * (conj_A_x * conj_A_x * conj_A_x * F * F)
        + factor[6] * (A_x * A_x * A_x * norm_F));
    store_complex(column_3, i, factor[7] * (norm_A_x * A_x * A_x * A_x));  // conservative_x_A_x3_conjA_x2
    // conservative_x_conjA_x2_F_sigma
    store_complex(column_4, i, factor[8] * (norm_A_x * F) + factor[9] * (norm_A_x * F));
    store_complex(column_5, i, factor[10] * (norm_A_x * norm_F * F));  // conservative_x_conjA_x2_F3
    store_complex(column_6, i, factor[11] * (F) + factor[12] * (F) + factor[13] * (F));  // e
    store_complex(column_7, i, times_i(factor[14] * (F)) + times_i(factor[15] * (F)));  // harmonic_im_x_F
    // harmonic_re_x_F3
    store_complex(column_8, i, factor[16] * (norm_F * F) + factor[17] * (norm_F * F) + factor[18] * (norm_F * F));
    store_complex(column_9, i, factor[19] * (A_x * A_x * A_x));  // a3
    store_complex(column_10, i, factor[20] * (F));  // harmonic_re_x_F
    store_complex(column_11, i, times_i(factor[21] * (norm_F * F)));  // harmonic_im_x_F3
    store_complex(column_12, i, factor[22] * (norm_F * norm_F * F));  // harmonic_re_x_F5
    store_complex(column_13, i, factor[23] * (norm_A_x * F));  // harmonic_re_x_A_x_conjA_x_F
    store_complex(column_14, i, factor[24] * (A_x * A_x * A_x));  // harmonic_re_x_A_x3
  }
}

/// columns[j][i] of the rows.
inline void columns_1(const BatchArrays& data, double* const* columns) {
  rows_1(data, FactorValues<factors_1<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_1(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_1(data, FactorSlopes<factors_1<DualNumber>, 1, 1, 25>{mode}, columns);
}

/// What multiplies the 11 terms of the harmonic -omega0+Omega of x: functions of the frequencies alone. 9
/// operations.
template <class Scalar>
void factors_2([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  factor[0] = Scalar(1.0);
  factor[1] = (Scalar(75.0) * omega0 - Scalar(25.0) * Omega) / (Scalar(12.0) * omega0);
  factor[2] = Scalar(1.0) / (Scalar(3.0) * omega0_2);
  factor[3] = Scalar(1.0);
  factor[4] = -Scalar(139.0) / Scalar(80.0);
  factor[5] = Scalar(1.0);
  factor[6] = Scalar(1.0);
  factor[7] = Scalar(1.0);
  factor[8] = Scalar(40.0);
  factor[9] = Scalar(1.0);
  factor[10] = Scalar(1.0);
}

/// Rows of the harmonic -omega0+Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega0 + Omega)*t) in x = harmonic_re_x_conjA_x_F*conj(A_x)*F + (75*omega0 -
/// 25*Omega)/(12*omega0)*harmonic_re_x_conjA_x_F*conj(A_x)*F + 1/(3*omega0^2)*a2*A_x^2 +
/// harmonic_re_x_A_x2_F2*A_x^2*F^2 - 139/80*harmonic_re_x_A_x2_F2*A_x^2*F^2 +
/// i*harmonic_im_x_conjA_x_F*conj(A_x)*F + harmonic_re_x_conjA_x_F3*conj(A_x)*F^3 +
/// harmonic_re_x_A_x_conjA_x2_F*A_x*conj(A_x)^2*F + 40*harmonic_re_x_A_x_conjA_x2_F*A_x*conj(A_x)^2*F +
/// i*harmonic_im_x_A_x2*A_x^2 + harmonic_re_x_A_x3_conjA_x*A_x^3*conj(A_x)
/// 8 columns; per observation at most 48 products and sums of complex numbers.
template <class Factors>
void rows_2(const BatchArrays& data, Factors factors, double* const* columns) {
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
  Scalar* __restrict column_7 = columns[7];
  Scalar factor[11];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex F = load_complex(forcing_0, i);
    const Scalar norm_F = norm_of(F);
    // harmonic_re_x_conjA_x_F
    store_complex(column_0, i, factor[0] * (conj_A_x * F) + factor[1] * (conj_A_x * F));
    store_complex(column_1, i, factor[2] * (A_x * A_x));  // a2
    // harmonic_re_x_A_x2_F2
    store_complex(column_2, i, factor[3] * (A_x * A_x * norm_F) + factor[4] * (A_x * A_x * norm_F));
    store_complex(column_3, i, times_i(factor[5] * (conj_A_x * F)));  // harmonic_im_x_conjA_x_F
    store_complex(column_4, i, factor[6] * (conj_A_x * norm_F * F));  // harmonic_re_x_conjA_x_F3
    // harmonic_re_x_A_x_conjA_x2_F
    store_complex(column_5, i, factor[7] * (norm_A_x * conj_A_x * F) + factor[8] * (norm_A_x * conj_A_x * F));
    store_complex(column_6, i, times_i(factor[9] * (A_x * A_x)));  // harmonic_im_x_A_x2
    store_complex(column_7, i, factor[10] * (norm_A_x * A_x * A_x));  // harmonic_re_x_A_x3_conjA_x
  }
}

/// columns[j][i] of the rows.
inline void columns_2(const BatchArrays& data, double* const* columns) {
  rows_2(data, FactorValues<factors_2<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_2(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_2(data, FactorSlopes<factors_2<DualNumber>, 1, 1, 11>{mode}, columns);
}

/// What multiplies the 14 terms of the harmonic -omega0+2*Omega of x: functions of the frequencies alone. 27
/// operations.
template <class Scalar>
void factors_3([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  factor[0] = -Scalar(1.0) / Scalar(36.0);
  factor[1] = (-Scalar(21.0) * omega0 + Scalar(7.0) * Omega) / (Scalar(108.0) * omega0);
  factor[2] = -Scalar(13.0) / (Scalar(90.0) * omega0);
  factor[3] = Scalar(13.0) / (Scalar(112.0) * omega0);
  factor[4] = -Scalar(5.0) / (Scalar(84.0) * omega0);
  factor[5] = -Scalar(1.0) / (Scalar(60.0) * omega0);
  factor[6] = -Scalar(1.0) / (Scalar(9.0) * omega0);
  factor[7] = -Scalar(1.0) / Scalar(15.0);
  factor[8] = (-Scalar(21.0) * omega0 + Scalar(7.0) * Omega) / (Scalar(90.0) * omega0);
  factor[9] = Scalar(5.0) / (Scalar(216.0) * omega0);
  factor[10] = -Scalar(7.0) / (Scalar(108.0) * omega0);
  factor[11] = -Scalar(7.0) / Scalar(54.0);
  factor[12] = Scalar(1.0);
  factor[13] = Scalar(1.0);
}

/// Rows of the harmonic -omega0+2*Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega0 + 2*Omega)*t) in x = -1/36*conservative_x_A_x_F2_sigma*conj(A_x)*F^2 +
/// (-21*omega0 + 7*Omega)/(108*omega0)*conservative_x_A_x_F2_sigma*conj(A_x)*F^2 -
/// 13/(90*omega0)*conservative_x_A_x_F4*conj(A_x)*F^4 +
/// 13/(112*omega0)*conservative_x_A_x2_conjA_x_F2*A_x*conj(A_x)^2*F^2 -
/// 5/(84*omega0)*conservative_x_A_x2_conjA_x_F2*A_x*conj(A_x)^2*F^2 -
/// 1/(60*omega0)*conservative_x_A_x3_conjA_x2*A_x^5 - 1/(9*omega0)*i*dissipative_x_conjA_x2_F*A_x^2*F -
/// 1/15*conservative_x_conjA_x2_F_sigma*A_x^2*F + (-21*omega0 +
/// 7*Omega)/(90*omega0)*conservative_x_conjA_x2_F_sigma*A_x^2*F +
/// 5/(216*omega0)*conservative_x_conjA_x2_F3*A_x^2*F^3 - 7/(108*omega0)*conservative_x_conjA_x2_F3*A_x^2*F^3 -
/// 7/54*harmonic_re_x_A_x_conjA_x_F*A_x^2*F + harmonic_re_x_conjA_x_F2*conj(A_x)*F^2 +
/// i*harmonic_im_x_conjA_x_F2*conj(A_x)*F^2
/// 10 columns; per observation at most 80 products and sums of complex numbers.
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
  Scalar* __restrict column_5 = columns[5];
  Scalar* __restrict column_6 = columns[6];
  Scalar* __restrict column_7 = columns[7];
  Scalar* __restrict column_8 = columns[8];
  Scalar* __restrict column_9 = columns[9];
  Scalar factor[14];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex F = load_complex(forcing_0, i);
    const Scalar norm_F = norm_of(F);
    // conservative_x_A_x_F2_sigma
    store_complex(column_0, i, factor[0] * (conj_A_x * F * F) + factor[1] * (conj_A_x * F * F));
    store_complex(column_1, i, factor[2] * (conj_A_x * norm_F * F * F));  // conservative_x_A_x_F4
    // conservative_x_A_x2_conjA_x_F2
    store_complex(column_2, i, factor[3] * (norm_A_x * conj_A_x * F * F)
        + factor[4] * (norm_A_x * conj_A_x * F * F));
    store_complex(column_3, i, factor[5] * (fixed_power<5>(A_x)));  // conservative_x_A_x3_conjA_x2
    store_complex(column_4, i, times_i(factor[6] * (A_x * A_x * F)));  // dissipative_x_conjA_x2_F
    // conservative_x_conjA_x2_F_sigma
    store_complex(column_5, i, factor[7] * (A_x * A_x * F) + factor[8] * (A_x * A_x * F));
    // conservative_x_conjA_x2_F3
    store_complex(column_6, i, factor[9] * (A_x * A_x * norm_F * F) + factor[10] * (A_x * A_x * norm_F * F));
    store_complex(column_7, i, factor[11] * (A_x * A_x * F));  // harmonic_re_x_A_x_conjA_x_F
    store_complex(column_8, i, factor[12] * (conj_A_x * F * F));  // harmonic_re_x_conjA_x_F2
    store_complex(column_9, i, times_i(factor[13] * (conj_A_x * F * F)));  // harmonic_im_x_conjA_x_F2
  }
}

/// columns[j][i] of the rows.
inline void columns_3(const BatchArrays& data, double* const* columns) {
  rows_3(data, FactorValues<factors_3<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_3(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_3(data, FactorSlopes<factors_3<DualNumber>, 1, 1, 14>{mode}, columns);
}

/// What multiplies the 8 terms of the harmonic 0 of x: functions of the frequencies alone. 11 operations.
template <class Scalar>
void factors_4([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  factor[0] = -Scalar(2.0) / omega0_2;
  factor[1] = Scalar(171.0) / Scalar(20.0);
  factor[2] = Scalar(255.0) / Scalar(2.0);
  factor[3] = Scalar(255.0) / Scalar(2.0);
  factor[4] = -Scalar(120.0) / Scalar(31.0);
  factor[5] = Scalar(1.0);
  factor[6] = (Scalar(9.0) * omega0 - Scalar(3.0) * Omega) / (Scalar(2.0) * omega0);
  factor[7] = Scalar(1.0);
}

/// Rows of the harmonic 0 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in x = -2/omega0^2*a2*A_x*conj(A_x) +
/// 171/20*harmonic_re_x_A_x2_F2*A_x*conj(A_x)*F^2 + 255/2*harmonic_re_x_A_x_conjA_x2_F*conj(A_x)^3*F +
/// 255/2*harmonic_re_x_A_x_conjA_x2_F*A_x^3*F - 120/31*harmonic_re_x_A_x3_conjA_x*A_x^2*conj(A_x)^2 +
/// harmonic_re_x_F2*F^2 + (9*omega0 - 3*Omega)/(2*omega0)*harmonic_re_x_F2*F^2 + harmonic_re_x_F4*F^4
/// 6 columns; per observation at most 28 products and sums of complex numbers.
template <class Factors>
void rows_4(const BatchArrays& data, Factors factors, double* const* columns) {
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
  Scalar factor[8];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    const Scalar norm_F = norm_of(F);
    store_complex(column_0, i, Complex(factor[0] * (norm_A_x)));  // a2
    store_complex(column_1, i, Complex(factor[1] * (norm_A_x * norm_F)));  // harmonic_re_x_A_x2_F2
    // harmonic_re_x_A_x_conjA_x2_F
    store_complex(column_2, i, factor[2] * (conj_A_x * conj_A_x * conj_A_x * F)
        + factor[3] * (A_x * A_x * A_x * conj_F));
    store_complex(column_3, i, Complex(factor[4] * (norm_A_x * norm_A_x)));  // harmonic_re_x_A_x3_conjA_x
    // harmonic_re_x_F2
    store_complex(column_4, i, Complex(factor[5] * (norm_F)) + Complex(factor[6] * (norm_F)));
    store_complex(column_5, i, Complex(factor[7] * (norm_F * norm_F)));  // harmonic_re_x_F4
  }
}

/// columns[j][i] of the rows.
inline void columns_4(const BatchArrays& data, double* const* columns) {
  rows_4(data, FactorValues<factors_4<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_4(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_4(data, FactorSlopes<factors_4<DualNumber>, 1, 1, 8>{mode}, columns);
}

/// What multiplies the 6 terms of the harmonic 2*Omega of x: functions of the frequencies alone. 9 operations.
template <class Scalar>
void factors_5([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  factor[0] = Scalar(711.0) / Scalar(39200.0);
  factor[1] = -Scalar(87.0) / Scalar(35.0);
  factor[2] = -Scalar(1.0) / Scalar(70.0);
  factor[3] = (-Scalar(459.0) * omega0 + Scalar(153.0) * Omega) / (Scalar(4900.0) * omega0);
  factor[4] = -Scalar(283.0) / Scalar(20244.0);
  factor[5] = Scalar(1.0);
}

/// Rows of the harmonic 2*Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(2*Omega)*t) in x = 711/39200*harmonic_re_x_A_x2_F2*A_x*conj(A_x)*F^2 -
/// 87/35*harmonic_re_x_A_x_conjA_x2_F*A_x^3*F - 1/70*harmonic_re_x_F2*F^2 + (-459*omega0 +
/// 153*Omega)/(4900*omega0)*harmonic_re_x_F2*F^2 - 283/20244*harmonic_re_x_F4*F^4 + i*harmonic_im_x_F2*F^2
/// 5 columns; per observation at most 27 products and sums of complex numbers.
template <class Factors>
void rows_5(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar* __restrict column_4 = columns[4];
  Scalar factor[6];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex F = load_complex(forcing_0, i);
    const Scalar norm_F = norm_of(F);
    store_complex(column_0, i, factor[0] * (norm_A_x * F * F));  // harmonic_re_x_A_x2_F2
    store_complex(column_1, i, factor[1] * (A_x * A_x * A_x * F));  // harmonic_re_x_A_x_conjA_x2_F
    store_complex(column_2, i, factor[2] * (F * F) + factor[3] * (F * F));  // harmonic_re_x_F2
    store_complex(column_3, i, factor[4] * (norm_F * F * F));  // harmonic_re_x_F4
    store_complex(column_4, i, times_i(factor[5] * (F * F)));  // harmonic_im_x_F2
  }
}

/// columns[j][i] of the rows.
inline void columns_5(const BatchArrays& data, double* const* columns) {
  rows_5(data, FactorValues<factors_5<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_5(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_5(data, FactorSlopes<factors_5<DualNumber>, 1, 1, 6>{mode}, columns);
}

/// What multiplies the 7 terms of the harmonic 3*Omega of x: functions of the frequencies alone. 12 operations.
template <class Scalar>
void factors_6([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  factor[0] = Scalar(1.0) / (Scalar(160.0) * omega0);
  factor[1] = Scalar(23.0) / (Scalar(1800.0) * omega0);
  factor[2] = Scalar(1.0) / Scalar(30.0);
  factor[3] = Scalar(1.0);
  factor[4] = (Scalar(117.0) * omega0 - Scalar(39.0) * Omega) / (Scalar(400.0) * omega0);
  factor[5] = Scalar(11.0) / Scalar(200.0);
  factor[6] = Scalar(16.0) / Scalar(455.0);
}

/// Rows of the harmonic 3*Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*Omega)*t) in x = 1/(160*omega0)*conservative_x_A_x2_conjA_x_F2*A_x^3*F^2 +
/// 23/(1800*omega0)*conservative_x_conjA_x2_F3*A_x*conj(A_x)*F^3 + 1/30*harmonic_re_x_F3*F^3 +
/// harmonic_re_x_F3*F^3 + (117*omega0 - 39*Omega)/(400*omega0)*harmonic_re_x_F3*F^3 +
/// 11/200*i*harmonic_im_x_F3*F^3 + 16/455*harmonic_re_x_F5*F^5
/// 5 columns; per observation at most 45 products and sums of complex numbers.
template <class Factors>
void rows_6(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar* __restrict column_4 = columns[4];
  Scalar factor[7];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex F = load_complex(forcing_0, i);
    const Scalar norm_F = norm_of(F);
    store_complex(column_0, i, factor[0] * (A_x * A_x * A_x * F * F));  // conservative_x_A_x2_conjA_x_F2
    store_complex(column_1, i, factor[1] * (norm_A_x * F * F * F));  // conservative_x_conjA_x2_F3
    // harmonic_re_x_F3
    store_complex(column_2, i, factor[2] * (F * F * F) + factor[3] * (F * F * F) + factor[4] * (F * F * F));
    store_complex(column_3, i, times_i(factor[5] * (F * F * F)));  // harmonic_im_x_F3
    store_complex(column_4, i, factor[6] * (norm_F * F * F * F));  // harmonic_re_x_F5
  }
}

/// columns[j][i] of the rows.
inline void columns_6(const BatchArrays& data, double* const* columns) {
  rows_6(data, FactorValues<factors_6<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_6(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_6(data, FactorSlopes<factors_6<DualNumber>, 1, 1, 7>{mode}, columns);
}

/// What multiplies the 7 terms of the harmonic omega0+Omega of x: functions of the frequencies alone. 141
/// operations.
template <class Scalar>
void factors_7([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar omega0_5 = omega0_4 * omega0;
  const Scalar omega0_6 = omega0_5 * omega0;
  const Scalar omega0_7 = omega0_6 * omega0;
  const Scalar omega0_8 = omega0_7 * omega0;
  const Scalar omega0_9 = omega0_8 * omega0;
  const Scalar omega0_10 = omega0_9 * omega0;
  const Scalar omega0_11 = omega0_10 * omega0;
  const Scalar omega0_12 = omega0_11 * omega0;
  const Scalar omega0_13 = omega0_12 * omega0;
  const Scalar omega0_14 = omega0_13 * omega0;
  const Scalar omega0_15 = omega0_14 * omega0;
  const Scalar Omega_2 = Omega * Omega;
  const Scalar Omega_3 = Omega_2 * Omega;
  const Scalar Omega_4 = Omega_3 * Omega;
  const Scalar Omega_5 = Omega_4 * Omega;
  const Scalar Omega_6 = Omega_5 * Omega;
  const Scalar Omega_7 = Omega_6 * Omega;
  const Scalar per_0 = Scalar(1.0) / (omega0 + Omega);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_0_3 = per_0_2 * per_0;
  const Scalar per_0_4 = per_0_3 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega0 - Omega);
  const Scalar per_1_2 = per_1 * per_1;
  const Scalar per_1_3 = per_1_2 * per_1;
  const Scalar per_1_4 = per_1_3 * per_1;
  const Scalar per_2 = Scalar(1.0) / (Scalar(2.0) * omega0 + Omega);
  const Scalar per_2_2 = per_2 * per_2;
  const Scalar per_3 = Scalar(1.0) / (omega0 + Scalar(2.0) * Omega);
  const Scalar per_4 = Scalar(1.0) / (omega0 - Scalar(2.0) * Omega);
  const Scalar per_4_2 = per_4 * per_4;
  const Scalar per_5 = Scalar(1.0) / (Scalar(2.0) * omega0 - Omega);
  const Scalar per_6 = Scalar(1.0) / (Scalar(3.0) * omega0 - Scalar(2.0) * Omega);
  const Scalar per_7 = Scalar(1.0) / (Scalar(3.0) * omega0 + Omega);
  factor[0] = -Scalar(24.0) * omega0_4 * per_0 * per_1 * per_2 / Omega;
  factor[1] = (-Scalar(720.0) * omega0_11 + Scalar(456.0) * omega0_10 * Omega
      + Scalar(3168.0) * omega0_9 * Omega_2 - Scalar(3072.0) * omega0_8 * Omega_3
      + Scalar(576.0) * omega0_7 * Omega_4
      - Scalar(192.0) * omega0_6 * Omega_5) * per_0_2 * per_3 * per_1_3 * per_4_2 * per_5 * per_6 / Omega;
  factor[2] = -Scalar(288.0) * omega0_7 * per_0 * per_1_2 * per_2_2 / Omega_2;
  factor[3] = Scalar(64.0) * omega0_5 * per_0_2 * per_1_2 * per_2;
  factor[4] = (Scalar(64512.0) * omega0_15 + Scalar(1419264.0) * omega0_14 * Omega
      - Scalar(499968.0) * omega0_13 * Omega_2 - Scalar(6015744.0) * omega0_12 * Omega_3
      + Scalar(1096704.0) * omega0_11 * Omega_4 + Scalar(4386816.0) * omega0_10 * Omega_5
      - Scalar(516096.0) * omega0_9 * Omega_6
      - Scalar(516096.0) * omega0_8 * Omega_7) * per_0_4 * per_3 * per_1_4 * per_4 * per_2_2
      * per_5 / (Scalar(11.0) * Omega_2);
  factor[5] = (-Scalar(74880.0) * omega0_9 - Scalar(28320.0) * omega0_8 * Omega
      + Scalar(61920.0) * omega0_7 * Omega_2 + Scalar(17760.0) * omega0_6 * Omega_3
      - Scalar(8640.0) * omega0_5 * Omega_4
      - Scalar(2400.0) * omega0_4 * Omega_5) * per_0_2 * per_1_2 * per_2_2 * per_5 * per_7 / Omega;
  factor[6] = -Scalar(1.0) / Scalar(31.0);
}

/// Rows of the harmonic omega0+Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega0 + Omega)*t) in x = -24*omega0^4/(Omega*(omega0 + Omega)*(omega0 - Omega)*(2*omega0
/// + Omega))*harmonic_re_x_conjA_x_F*A_x*F + (-720*omega0^11 + 456*omega0^10*Omega + 3168*omega0^9*Omega^2 -
/// 3072*omega0^8*Omega^3 + 576*omega0^7*Omega^4 - 192*omega0^6*Omega^5)/(Omega*(omega0 + Omega)^2*(omega0 +
/// 2*Omega)*(omega0 - Omega)^3*(omega0 - 2*Omega)^2*(2*omega0 - Omega)*(3*omega0 -
/// 2*Omega))*harmonic_re_x_A_x2_F2*conj(A_x)^2*F^2 - 288*omega0^7/(Omega^2*(omega0 + Omega)*(omega0 -
/// Omega)^2*(2*omega0 + Omega)^2)*harmonic_re_x_A_x2_F2*conj(A_x)^2*F^2 + 64*omega0^5/((omega0 +
/// Omega)^2*(omega0 - Omega)^2*(2*omega0 + Omega))*i*harmonic_im_x_conjA_x_F*A_x*F + (64512*omega0^15 +
/// 1419264*omega0^14*Omega - 499968*omega0^13*Omega^2 - 6015744*omega0^12*Omega^3 + 1096704*omega0^11*Omega^4 +
/// 4386816*omega0^10*Omega^5 - 516096*omega0^9*Omega^6 - 516096*omega0^8*Omega^7)/(11*Omega^2*(omega0 +
/// Omega)^4*(omega0 + 2*Omega)*(omega0 - Omega)^4*(omega0 - 2*Omega)*(2*omega0 + Omega)^2*(2*omega0 -
/// Omega))*harmonic_re_x_conjA_x_F3*A_x*F^3 + (-74880*omega0^9 - 28320*omega0^8*Omega + 61920*omega0^7*Omega^2 +
/// 17760*omega0^6*Omega^3 - 8640*omega0^5*Omega^4 - 2400*omega0^4*Omega^5)/(Omega*(omega0 + Omega)^2*(omega0 -
/// Omega)^2*(2*omega0 + Omega)^2*(2*omega0 - Omega)*(3*omega0 +
/// Omega))*harmonic_re_x_A_x_conjA_x2_F*A_x^2*conj(A_x)*F - 1/31*harmonic_re_x_A_x3_conjA_x*A_x^4
/// 6 columns; per observation at most 32 products and sums of complex numbers.
template <class Factors>
void rows_7(const BatchArrays& data, Factors factors, double* const* columns) {
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
  Scalar factor[7];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex F = load_complex(forcing_0, i);
    const Scalar norm_F = norm_of(F);
    store_complex(column_0, i, factor[0] * (A_x * F));  // harmonic_re_x_conjA_x_F
    // harmonic_re_x_A_x2_F2
    store_complex(column_1, i, factor[1] * (conj_A_x * conj_A_x * F * F)
        + factor[2] * (conj_A_x * conj_A_x * F * F));
    store_complex(column_2, i, times_i(factor[3] * (A_x * F)));  // harmonic_im_x_conjA_x_F
    store_complex(column_3, i, factor[4] * (A_x * norm_F * F));  // harmonic_re_x_conjA_x_F3
    store_complex(column_4, i, factor[5] * (norm_A_x * A_x * F));  // harmonic_re_x_A_x_conjA_x2_F
    store_complex(column_5, i, factor[6] * (fixed_power<4>(A_x)));  // harmonic_re_x_A_x3_conjA_x
  }
}

/// columns[j][i] of the rows.
inline void columns_7(const BatchArrays& data, double* const* columns) {
  rows_7(data, FactorValues<factors_7<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_7(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_7(data, FactorSlopes<factors_7<DualNumber>, 1, 1, 7>{mode}, columns);
}

/// What multiplies the 8 terms of the harmonic omega0+2*Omega of x: functions of the frequencies alone. 132
/// operations.
template <class Scalar>
void factors_8([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar omega0_5 = omega0_4 * omega0;
  const Scalar omega0_6 = omega0_5 * omega0;
  const Scalar omega0_7 = omega0_6 * omega0;
  const Scalar omega0_8 = omega0_7 * omega0;
  const Scalar omega0_9 = omega0_8 * omega0;
  const Scalar omega0_10 = omega0_9 * omega0;
  const Scalar omega0_11 = omega0_10 * omega0;
  const Scalar omega0_12 = omega0_11 * omega0;
  const Scalar omega0_13 = omega0_12 * omega0;
  const Scalar Omega_2 = Omega * Omega;
  const Scalar Omega_3 = Omega_2 * Omega;
  const Scalar per_0 = Scalar(1.0) / (omega0 + Omega);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_0_3 = per_0_2 * per_0;
  const Scalar per_0_4 = per_0_3 * per_0;
  const Scalar per_0_5 = per_0_4 * per_0;
  const Scalar per_0_6 = per_0_5 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega0 - Omega);
  const Scalar per_1_2 = per_1 * per_1;
  const Scalar per_1_3 = per_1_2 * per_1;
  const Scalar per_1_4 = per_1_3 * per_1;
  const Scalar per_1_5 = per_1_4 * per_1;
  const Scalar per_2 = Scalar(1.0) / (Scalar(3.0) * omega0 + Omega);
  const Scalar per_2_2 = per_2 * per_2;
  const Scalar per_3 = Scalar(1.0) / (Scalar(5.0) * omega0 + Omega);
  const Scalar per_4 = Scalar(1.0) / (omega0 + Scalar(3.0) * Omega);
  const Scalar per_5 = Scalar(1.0) / (omega0 - Scalar(3.0) * Omega);
  const Scalar per_5_2 = per_5 * per_5;
  const Scalar per_6 = Scalar(1.0) / (omega0 + Scalar(2.0) * Omega);
  const Scalar per_7 = Scalar(1.0) / (omega0 - Scalar(2.0) * Omega);
  const Scalar per_8 = Scalar(1.0) / (Scalar(2.0) * omega0 + Omega);
  factor[0] = (-Scalar(60.0) * omega0_5 - Scalar(16.0) * omega0_4 * Omega
      - Scalar(4.0) * omega0_3 * Omega_2) * per_0_2 * per_1 * per_2_2 * per_3;
  factor[1] = -Scalar(32.0) * omega0_6 * per_0_3 * per_1_2 / (Scalar(3.0) * Omega);
  factor[2] = (Scalar(360448.0) * omega0_13 - Scalar(98304.0) * omega0_12 * Omega
      - Scalar(2719744.0) * omega0_11 * Omega_2
      + Scalar(884736.0) * omega0_10 * Omega_3) * per_0_6 * per_4 * per_1_5 * per_5 / (Scalar(21.0) * Omega);
  factor[3] = (-Scalar(4992.0) * omega0_8 - Scalar(2112.0) * omega0_7 * Omega
      + Scalar(192.0) * omega0_6 * Omega_2) * per_0_4 * per_1_3 * per_2 / (Scalar(7.0) * Omega);
  factor[4] = (Scalar(6144.0) * omega0_11 + Scalar(4096.0) * omega0_10 * Omega
      - Scalar(59392.0) * omega0_9 * Omega_2) * per_0_3 * per_4 * per_1_5 * per_5_2 / (Scalar(27.0) * Omega);
  factor[5] = (Scalar(256.0) * omega0_9
      + Scalar(512.0) * omega0_8 * Omega) * per_0_5 * per_1_3 / (Scalar(3.0) * Omega_2);
  factor[6] = (Scalar(80640.0) * omega0_10 - Scalar(80640.0) * omega0_9 * Omega
      - Scalar(362880.0) * omega0_8 * Omega_2) * per_0_3 * per_6 * per_1_2 * per_7 * per_8 / (Scalar(73.0)
      * Omega_2);
  factor[7] = -Scalar(1024.0) * omega0_7 * per_0_4 * per_1_3;
}

/// Rows of the harmonic omega0+2*Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega0 + 2*Omega)*t) in x = (-60*omega0^5 - 16*omega0^4*Omega -
/// 4*omega0^3*Omega^2)/((omega0 + Omega)^2*(omega0 - Omega)*(3*omega0 + Omega)^2*(5*omega0 +
/// Omega))*conservative_x_A_x4_F*A_x^4*F - 32*omega0^6/(3*Omega*(omega0 + Omega)^3*(omega0 -
/// Omega)^2)*conservative_x_A_x_F2_sigma*A_x*F^2 + (360448*omega0^13 - 98304*omega0^12*Omega -
/// 2719744*omega0^11*Omega^2 + 884736*omega0^10*Omega^3)/(21*Omega*(omega0 + Omega)^6*(omega0 + 3*Omega)*(omega0
/// - Omega)^5*(omega0 - 3*Omega))*conservative_x_A_x_F4*A_x*F^4 + (-4992*omega0^8 - 2112*omega0^7*Omega +
/// 192*omega0^6*Omega^2)/(7*Omega*(omega0 + Omega)^4*(omega0 - Omega)^3*(3*omega0 +
/// Omega))*conservative_x_A_x2_conjA_x_F2*A_x^2*conj(A_x)*F^2 + (6144*omega0^11 + 4096*omega0^10*Omega -
/// 59392*omega0^9*Omega^2)/(27*Omega*(omega0 + Omega)^3*(omega0 + 3*Omega)*(omega0 - Omega)^5*(omega0 -
/// 3*Omega)^2)*conservative_x_conjA_x2_F3*conj(A_x)^2*F^3 + (256*omega0^9 +
/// 512*omega0^8*Omega)/(3*Omega^2*(omega0 + Omega)^5*(omega0 -
/// Omega)^3)*conservative_x_conjA_x2_F3*conj(A_x)^2*F^3 + (80640*omega0^10 - 80640*omega0^9*Omega -
/// 362880*omega0^8*Omega^2)/(73*Omega^2*(omega0 + Omega)^3*(omega0 + 2*Omega)*(omega0 - Omega)^2*(omega0 -
/// 2*Omega)*(2*omega0 + Omega))*harmonic_re_x_conjA_x_F2*A_x*F^2 - 1024*omega0^7/((omega0 + Omega)^4*(omega0 -
/// Omega)^3)*i*harmonic_im_x_conjA_x_F2*A_x*F^2
/// 7 columns; per observation at most 51 products and sums of complex numbers.
template <class Factors>
void rows_8(const BatchArrays& data, Factors factors, double* const* columns) {
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
  Scalar factor[8];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Scalar norm_A_x = norm_of(A_x);
    const Complex F = load_complex(forcing_0, i);
    const Scalar norm_F = norm_of(F);
    store_complex(column_0, i, factor[0] * (fixed_power<4>(A_x) * F));  // conservative_x_A_x4_F
    store_complex(column_1, i, factor[1] * (A_x * F * F));  // conservative_x_A_x_F2_sigma
    store_complex(column_2, i, factor[2] * (A_x * norm_F * F * F));  // conservative_x_A_x_F4
    store_complex(column_3, i, factor[3] * (norm_A_x * A_x * F * F));  // conservative_x_A_x2_conjA_x_F2
    // conservative_x_conjA_x2_F3
    store_complex(column_4, i, factor[4] * (conj_A_x * conj_A_x * F * F * F)
        + factor[5] * (conj_A_x * conj_A_x * F * F * F));
    store_complex(column_5, i, factor[6] * (A_x * F * F));  // harmonic_re_x_conjA_x_F2
    store_complex(column_6, i, times_i(factor[7] * (A_x * F * F)));  // harmonic_im_x_conjA_x_F2
  }
}

/// columns[j][i] of the rows.
inline void columns_8(const BatchArrays& data, double* const* columns) {
  rows_8(data, FactorValues<factors_8<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_8(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_8(data, FactorSlopes<factors_8<DualNumber>, 1, 1, 8>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic -omega0+3*Omega of x: functions of the frequencies alone. 111
/// operations.
template <class Scalar>
void factors_9([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar omega0_5 = omega0_4 * omega0;
  const Scalar omega0_6 = omega0_5 * omega0;
  const Scalar omega0_7 = omega0_6 * omega0;
  const Scalar omega0_8 = omega0_7 * omega0;
  const Scalar omega0_9 = omega0_8 * omega0;
  const Scalar omega0_10 = omega0_9 * omega0;
  const Scalar omega0_11 = omega0_10 * omega0;
  const Scalar omega0_12 = omega0_11 * omega0;
  const Scalar omega0_13 = omega0_12 * omega0;
  const Scalar omega0_14 = omega0_13 * omega0;
  const Scalar omega0_15 = omega0_14 * omega0;
  const Scalar Omega_2 = Omega * Omega;
  const Scalar Omega_3 = Omega_2 * Omega;
  const Scalar Omega_4 = Omega_3 * Omega;
  const Scalar Omega_5 = Omega_4 * Omega;
  const Scalar Omega_6 = Omega_5 * Omega;
  const Scalar per_0 = Scalar(1.0) / (omega0 + Omega);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_0_3 = per_0_2 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega0 + Scalar(2.0) * Omega);
  const Scalar per_1_2 = per_1 * per_1;
  const Scalar per_2 = Scalar(1.0) / (omega0 - Omega);
  const Scalar per_2_2 = per_2 * per_2;
  const Scalar per_2_3 = per_2_2 * per_2;
  const Scalar per_2_4 = per_2_3 * per_2;
  const Scalar per_3 = Scalar(1.0) / (omega0 - Scalar(2.0) * Omega);
  const Scalar per_4 = Scalar(1.0) / (Scalar(2.0) * omega0 + Omega);
  const Scalar per_5 = Scalar(1.0) / (Scalar(3.0) * omega0 + Omega);
  const Scalar per_6 = Scalar(1.0) / (Scalar(3.0) * omega0 + Scalar(2.0) * Omega);
  const Scalar per_7 = Scalar(1.0) / (omega0 + Scalar(3.0) * Omega);
  const Scalar per_8 = Scalar(1.0) / (omega0 - Scalar(3.0) * Omega);
  const Scalar per_9 = Scalar(1.0) / (Scalar(2.0) * omega0 - Omega);
  const Scalar per_10 = Scalar(1.0) / (Scalar(2.0) * omega0 - Scalar(3.0) * Omega);
  factor[0] = (Scalar(2160.0) * omega0_12 + Scalar(2664.0) * omega0_11 * Omega
      - Scalar(8760.0) * omega0_10 * Omega_2 - Scalar(14688.0) * omega0_9 * Omega_3
      - Scalar(5952.0) * omega0_8 * Omega_4 - Scalar(1152.0) * omega0_7 * Omega_5
      - Scalar(192.0) * omega0_6 * Omega_6) * per_0_3 * per_1_2 * per_2_2 * per_3 * per_4 * per_5 * per_6 / Omega;
  factor[1] = (-Scalar(32256.0) * omega0_15 - Scalar(30464.0) * omega0_14 * Omega
      + Scalar(505344.0) * omega0_13 * Omega_2 + Scalar(66304.0) * omega0_12 * Omega_3
      - Scalar(1827840.0) * omega0_11 * Omega_4
      + Scalar(1189888.0) * omega0_10 * Omega_5) * per_0_3 * per_1 * per_7 * per_2_4 * per_3 * per_8 * per_9
      * per_10 / (Scalar(11.0) * Omega_2);
}

/// Rows of the harmonic -omega0+3*Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega0 + 3*Omega)*t) in x = (2160*omega0^12 + 2664*omega0^11*Omega -
/// 8760*omega0^10*Omega^2 - 14688*omega0^9*Omega^3 - 5952*omega0^8*Omega^4 - 1152*omega0^7*Omega^5 -
/// 192*omega0^6*Omega^6)/(Omega*(omega0 + Omega)^3*(omega0 + 2*Omega)^2*(omega0 - Omega)^2*(omega0 -
/// 2*Omega)*(2*omega0 + Omega)*(3*omega0 + Omega)*(3*omega0 + 2*Omega))*harmonic_re_x_A_x2_F2*A_x^2*F^2 +
/// (-32256*omega0^15 - 30464*omega0^14*Omega + 505344*omega0^13*Omega^2 + 66304*omega0^12*Omega^3 -
/// 1827840*omega0^11*Omega^4 + 1189888*omega0^10*Omega^5)/(11*Omega^2*(omega0 + Omega)^3*(omega0 +
/// 2*Omega)*(omega0 + 3*Omega)*(omega0 - Omega)^4*(omega0 - 2*Omega)*(omega0 - 3*Omega)*(2*omega0 -
/// Omega)*(2*omega0 - 3*Omega))*harmonic_re_x_conjA_x_F3*conj(A_x)*F^3
/// 2 columns; per observation at most 14 products and sums of complex numbers.
template <class Factors>
void rows_9(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_x * A_x * F * F));  // harmonic_re_x_A_x2_F2
    store_complex(column_1, i, factor[1] * (conj_A_x * F * F * F));  // harmonic_re_x_conjA_x_F3
  }
}

/// columns[j][i] of the rows.
inline void columns_9(const BatchArrays& data, double* const* columns) {
  rows_9(data, FactorValues<factors_9<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_9(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_9(data, FactorSlopes<factors_9<DualNumber>, 1, 1, 2>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic -omega0+4*Omega of x: functions of the frequencies alone. 65
/// operations.
template <class Scalar>
void factors_10([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar omega0_5 = omega0_4 * omega0;
  const Scalar omega0_6 = omega0_5 * omega0;
  const Scalar omega0_7 = omega0_6 * omega0;
  const Scalar omega0_8 = omega0_7 * omega0;
  const Scalar omega0_9 = omega0_8 * omega0;
  const Scalar omega0_10 = omega0_9 * omega0;
  const Scalar omega0_11 = omega0_10 * omega0;
  const Scalar omega0_12 = omega0_11 * omega0;
  const Scalar omega0_13 = omega0_12 * omega0;
  const Scalar Omega_2 = Omega * Omega;
  const Scalar per_0 = Scalar(1.0) / (omega0 + Omega);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_0_3 = per_0_2 * per_0;
  const Scalar per_0_4 = per_0_3 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega0 + Scalar(3.0) * Omega);
  const Scalar per_1_2 = per_1 * per_1;
  const Scalar per_2 = Scalar(1.0) / (omega0 - Omega);
  const Scalar per_2_2 = per_2 * per_2;
  const Scalar per_2_3 = per_2_2 * per_2;
  const Scalar per_2_4 = per_2_3 * per_2;
  const Scalar per_2_5 = per_2_4 * per_2;
  const Scalar per_3 = Scalar(1.0) / (omega0 - Scalar(2.0) * Omega);
  const Scalar per_4 = Scalar(1.0) / (omega0 - Scalar(3.0) * Omega);
  const Scalar per_5 = Scalar(1.0) / (Scalar(3.0) * omega0 + Omega);
  factor[0] = (-Scalar(12288.0) * omega0_13 - Scalar(32768.0) * omega0_12 * Omega
      + Scalar(143360.0) * omega0_11 * Omega_2) * per_0_4 * per_1 * per_2_5 * per_3 * per_4 / (Scalar(21.0)
      * Omega_2);
  factor[1] = (-Scalar(18432.0) * omega0_11 + Scalar(12288.0) * omega0_10 * Omega
      + Scalar(169984.0) * omega0_9 * Omega_2) * per_0_4 * per_1_2 * per_2_3 * per_4 * per_5 / (Scalar(27.0)
      * Omega);
}

/// Rows of the harmonic -omega0+4*Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(-omega0 + 4*Omega)*t) in x = (-12288*omega0^13 - 32768*omega0^12*Omega +
/// 143360*omega0^11*Omega^2)/(21*Omega^2*(omega0 + Omega)^4*(omega0 + 3*Omega)*(omega0 - Omega)^5*(omega0 -
/// 2*Omega)*(omega0 - 3*Omega))*conservative_x_A_x_F4*conj(A_x)*F^4 + (-18432*omega0^11 + 12288*omega0^10*Omega
/// + 169984*omega0^9*Omega^2)/(27*Omega*(omega0 + Omega)^4*(omega0 + 3*Omega)^2*(omega0 - Omega)^3*(omega0 -
/// 3*Omega)*(3*omega0 + Omega))*conservative_x_conjA_x2_F3*A_x^2*F^3
/// 2 columns; per observation at most 12 products and sums of complex numbers.
template <class Factors>
void rows_10(const BatchArrays& data, Factors factors, double* const* columns) {
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
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (conj_A_x * fixed_power<4>(F)));  // conservative_x_A_x_F4
    store_complex(column_1, i, factor[1] * (A_x * A_x * F * F * F));  // conservative_x_conjA_x2_F3
  }
}

/// columns[j][i] of the rows.
inline void columns_10(const BatchArrays& data, double* const* columns) {
  rows_10(data, FactorValues<factors_10<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_10(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_10(data, FactorSlopes<factors_10<DualNumber>, 1, 1, 2>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 4*Omega of x: functions of the frequencies alone. 55 operations.
template <class Scalar>
void factors_11([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar omega0_5 = omega0_4 * omega0;
  const Scalar omega0_6 = omega0_5 * omega0;
  const Scalar omega0_7 = omega0_6 * omega0;
  const Scalar omega0_8 = omega0_7 * omega0;
  const Scalar omega0_9 = omega0_8 * omega0;
  const Scalar omega0_10 = omega0_9 * omega0;
  const Scalar omega0_11 = omega0_10 * omega0;
  const Scalar omega0_12 = omega0_11 * omega0;
  const Scalar omega0_13 = omega0_12 * omega0;
  const Scalar omega0_14 = omega0_13 * omega0;
  const Scalar Omega_2 = Omega * Omega;
  const Scalar per_0 = Scalar(1.0) / (omega0 + Omega);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_0_3 = per_0_2 * per_0;
  const Scalar per_0_4 = per_0_3 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega0 + Scalar(2.0) * Omega);
  const Scalar per_2 = Scalar(1.0) / (omega0 + Scalar(3.0) * Omega);
  const Scalar per_3 = Scalar(1.0) / (omega0 + Scalar(4.0) * Omega);
  const Scalar per_4 = Scalar(1.0) / (omega0 - Omega);
  const Scalar per_4_2 = per_4 * per_4;
  const Scalar per_4_3 = per_4_2 * per_4;
  const Scalar per_4_4 = per_4_3 * per_4;
  const Scalar per_5 = Scalar(1.0) / (omega0 - Scalar(2.0) * Omega);
  const Scalar per_6 = Scalar(1.0) / (omega0 - Scalar(3.0) * Omega);
  const Scalar per_7 = Scalar(1.0) / (omega0 - Scalar(4.0) * Omega);
  factor[0] = (Scalar(1433600.0) * omega0_14
      - Scalar(10035200.0) * omega0_12 * Omega_2) * per_0_4 * per_1 * per_2 * per_3 * per_4_4 * per_5 * per_6
      * per_7 / Scalar(723.0);
}

/// Rows of the harmonic 4*Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(4*Omega)*t) in x = (1433600*omega0^14 - 10035200*omega0^12*Omega^2)/(723*(omega0 +
/// Omega)^4*(omega0 + 2*Omega)*(omega0 + 3*Omega)*(omega0 + 4*Omega)*(omega0 - Omega)^4*(omega0 -
/// 2*Omega)*(omega0 - 3*Omega)*(omega0 - 4*Omega))*harmonic_re_x_F4*F^4
/// 1 columns; per observation at most 1 products and sums of complex numbers.
template <class Factors>
void rows_11(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (fixed_power<4>(F)));  // harmonic_re_x_F4
  }
}

/// columns[j][i] of the rows.
inline void columns_11(const BatchArrays& data, double* const* columns) {
  rows_11(data, FactorValues<factors_11<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_11(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_11(data, FactorSlopes<factors_11<DualNumber>, 1, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 5*Omega of x: functions of the frequencies alone. 45 operations.
template <class Scalar>
void factors_12([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar omega0_5 = omega0_4 * omega0;
  const Scalar omega0_6 = omega0_5 * omega0;
  const Scalar omega0_7 = omega0_6 * omega0;
  const Scalar omega0_8 = omega0_7 * omega0;
  const Scalar omega0_9 = omega0_8 * omega0;
  const Scalar omega0_10 = omega0_9 * omega0;
  const Scalar omega0_11 = omega0_10 * omega0;
  const Scalar omega0_12 = omega0_11 * omega0;
  const Scalar omega0_13 = omega0_12 * omega0;
  const Scalar omega0_14 = omega0_13 * omega0;
  const Scalar per_0 = Scalar(1.0) / (omega0 + Omega);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_0_3 = per_0_2 * per_0;
  const Scalar per_0_4 = per_0_3 * per_0;
  const Scalar per_0_5 = per_0_4 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega0 + Scalar(3.0) * Omega);
  const Scalar per_2 = Scalar(1.0) / (omega0 + Scalar(5.0) * Omega);
  const Scalar per_3 = Scalar(1.0) / (omega0 - Omega);
  const Scalar per_3_2 = per_3 * per_3;
  const Scalar per_3_3 = per_3_2 * per_3;
  const Scalar per_3_4 = per_3_3 * per_3;
  const Scalar per_3_5 = per_3_4 * per_3;
  const Scalar per_4 = Scalar(1.0) / (omega0 - Scalar(3.0) * Omega);
  const Scalar per_5 = Scalar(1.0) / (omega0 - Scalar(5.0) * Omega);
  factor[0] = -Scalar(20971520.0) * omega0_14 * per_0_5 * per_1 * per_2 * per_3_5 * per_4 * per_5 / Scalar(91.0);
}

/// Rows of the harmonic 5*Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(5*Omega)*t) in x = -20971520*omega0^14/(91*(omega0 + Omega)^5*(omega0 + 3*Omega)*(omega0
/// + 5*Omega)*(omega0 - Omega)^5*(omega0 - 3*Omega)*(omega0 - 5*Omega))*harmonic_re_x_F5*F^5
/// 1 columns; per observation at most 1 products and sums of complex numbers.
template <class Factors>
void rows_12(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (fixed_power<5>(F)));  // harmonic_re_x_F5
  }
}

/// columns[j][i] of the rows.
inline void columns_12(const BatchArrays& data, double* const* columns) {
  rows_12(data, FactorValues<factors_12<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_12(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_12(data, FactorSlopes<factors_12<DualNumber>, 1, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic omega0+3*Omega of x: functions of the frequencies alone. 72
/// operations.
template <class Scalar>
void factors_13([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar omega0_5 = omega0_4 * omega0;
  const Scalar omega0_6 = omega0_5 * omega0;
  const Scalar omega0_7 = omega0_6 * omega0;
  const Scalar omega0_8 = omega0_7 * omega0;
  const Scalar omega0_9 = omega0_8 * omega0;
  const Scalar omega0_10 = omega0_9 * omega0;
  const Scalar omega0_11 = omega0_10 * omega0;
  const Scalar omega0_12 = omega0_11 * omega0;
  const Scalar omega0_13 = omega0_12 * omega0;
  const Scalar omega0_14 = omega0_13 * omega0;
  const Scalar omega0_15 = omega0_14 * omega0;
  const Scalar Omega_2 = Omega * Omega;
  const Scalar Omega_3 = Omega_2 * Omega;
  const Scalar Omega_4 = Omega_3 * Omega;
  const Scalar Omega_5 = Omega_4 * Omega;
  const Scalar per_0 = Scalar(1.0) / (omega0 + Omega);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_0_3 = per_0_2 * per_0;
  const Scalar per_0_4 = per_0_3 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega0 + Scalar(2.0) * Omega);
  const Scalar per_2 = Scalar(1.0) / (omega0 + Scalar(3.0) * Omega);
  const Scalar per_3 = Scalar(1.0) / (omega0 - Omega);
  const Scalar per_3_2 = per_3 * per_3;
  const Scalar per_3_3 = per_3_2 * per_3;
  const Scalar per_4 = Scalar(1.0) / (omega0 - Scalar(2.0) * Omega);
  const Scalar per_5 = Scalar(1.0) / (omega0 - Scalar(3.0) * Omega);
  const Scalar per_6 = Scalar(1.0) / (Scalar(2.0) * omega0 + Omega);
  const Scalar per_7 = Scalar(1.0) / (Scalar(2.0) * omega0 + Scalar(3.0) * Omega);
  factor[0] = (-Scalar(32256.0) * omega0_15 + Scalar(30464.0) * omega0_14 * Omega
      + Scalar(505344.0) * omega0_13 * Omega_2 - Scalar(66304.0) * omega0_12 * Omega_3
      - Scalar(1827840.0) * omega0_11 * Omega_4
      - Scalar(1189888.0) * omega0_10 * Omega_5) * per_0_4 * per_1 * per_2 * per_3_3 * per_4 * per_5 * per_6
      * per_7 / (Scalar(11.0) * Omega_2);
}

/// Rows of the harmonic omega0+3*Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega0 + 3*Omega)*t) in x = (-32256*omega0^15 + 30464*omega0^14*Omega +
/// 505344*omega0^13*Omega^2 - 66304*omega0^12*Omega^3 - 1827840*omega0^11*Omega^4 -
/// 1189888*omega0^10*Omega^5)/(11*Omega^2*(omega0 + Omega)^4*(omega0 + 2*Omega)*(omega0 + 3*Omega)*(omega0 -
/// Omega)^3*(omega0 - 2*Omega)*(omega0 - 3*Omega)*(2*omega0 + Omega)*(2*omega0 +
/// 3*Omega))*harmonic_re_x_conjA_x_F3*A_x*F^3
/// 1 columns; per observation at most 7 products and sums of complex numbers.
template <class Factors>
void rows_13(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_x * F * F * F));  // harmonic_re_x_conjA_x_F3
  }
}

/// columns[j][i] of the rows.
inline void columns_13(const BatchArrays& data, double* const* columns) {
  rows_13(data, FactorValues<factors_13<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_13(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_13(data, FactorSlopes<factors_13<DualNumber>, 1, 1, 1>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic omega0+4*Omega of x: functions of the frequencies alone. 47
/// operations.
template <class Scalar>
void factors_14([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar omega0_5 = omega0_4 * omega0;
  const Scalar omega0_6 = omega0_5 * omega0;
  const Scalar omega0_7 = omega0_6 * omega0;
  const Scalar omega0_8 = omega0_7 * omega0;
  const Scalar omega0_9 = omega0_8 * omega0;
  const Scalar omega0_10 = omega0_9 * omega0;
  const Scalar omega0_11 = omega0_10 * omega0;
  const Scalar omega0_12 = omega0_11 * omega0;
  const Scalar omega0_13 = omega0_12 * omega0;
  const Scalar Omega_2 = Omega * Omega;
  const Scalar per_0 = Scalar(1.0) / (omega0 + Omega);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_0_3 = per_0_2 * per_0;
  const Scalar per_0_4 = per_0_3 * per_0;
  const Scalar per_0_5 = per_0_4 * per_0;
  const Scalar per_1 = Scalar(1.0) / (omega0 + Scalar(2.0) * Omega);
  const Scalar per_2 = Scalar(1.0) / (omega0 + Scalar(3.0) * Omega);
  const Scalar per_3 = Scalar(1.0) / (omega0 - Omega);
  const Scalar per_3_2 = per_3 * per_3;
  const Scalar per_3_3 = per_3_2 * per_3;
  const Scalar per_3_4 = per_3_3 * per_3;
  const Scalar per_4 = Scalar(1.0) / (omega0 - Scalar(3.0) * Omega);
  factor[0] = (-Scalar(12288.0) * omega0_13 + Scalar(32768.0) * omega0_12 * Omega
      + Scalar(143360.0) * omega0_11 * Omega_2) * per_0_5 * per_1 * per_2 * per_3_4 * per_4 / (Scalar(21.0)
      * Omega_2);
}

/// Rows of the harmonic omega0+4*Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega0 + 4*Omega)*t) in x = (-12288*omega0^13 + 32768*omega0^12*Omega +
/// 143360*omega0^11*Omega^2)/(21*Omega^2*(omega0 + Omega)^5*(omega0 + 2*Omega)*(omega0 + 3*Omega)*(omega0 -
/// Omega)^4*(omega0 - 3*Omega))*conservative_x_A_x_F4*A_x*F^4
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_14(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_x * fixed_power<4>(F)));  // conservative_x_A_x_F4
  }
}

/// columns[j][i] of the rows.
inline void columns_14(const BatchArrays& data, double* const* columns) {
  rows_14(data, FactorValues<factors_14<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_14(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_14(data, FactorSlopes<factors_14<DualNumber>, 1, 1, 1>{mode}, columns);
}

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_x/dt + i*(w_x - omega0)*B_x = i*conservative_x_A_x4_F*A_x^4*F + i*conservative_x_A_x4_F*A_x*conj(A_x)^3*F
/// - mu*A_x + i*conservative_x_A_x*A_x + i*conservative_x_A_x_F2*A_x*F^2 + (-3*omega0 +
/// Omega)*i*conservative_x_A_x_F2_sigma*A_x*F^2 + i*conservative_x_A_x_F4*A_x*F^4 +
/// dissipative_x_A_x2_conjA_x*A_x^2*conj(A_x) + i*conservative_x_A_x2_conjA_x*A_x^2*conj(A_x) +
/// i*conservative_x_A_x2_conjA_x_F2*A_x^2*conj(A_x)*F^2 + i*conservative_x_A_x3_conjA_x2*A_x^3*conj(A_x)^2 +
/// dissipative_x_conjA_x2_F*conj(A_x)^2*F + i*conservative_x_conjA_x2_F*conj(A_x)^2*F + (-3*omega0 +
/// Omega)*i*conservative_x_conjA_x2_F_sigma*conj(A_x)^2*F + i*conservative_x_conjA_x2_F3*conj(A_x)^2*F^3 with A
/// = B in that frame
/// 63 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega0 = parameters[0];
  const Scalar Omega = excitation_frequency[0];
  Scalar lumps[36];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Complex conj_A_x = conjugate(A_x);
  const Scalar norm_A_x = norm_of(A_x);
  const Complex F = load_complex(forcing, 0);
  const Complex conj_F = conjugate(F);
  const Scalar norm_F = norm_of(F);
  store_complex(derivative, 0, times_i(lumps[0] * (fixed_power<4>(A_x) * conj_F))
       + times_i(lumps[0] * (norm_A_x * conj_A_x * conj_A_x * F))
       + lumps[1] * (-Scalar(1.0)) * (A_x)
       + times_i(lumps[2] * (A_x))
       + times_i(lumps[3] * (A_x * norm_F))
       + times_i(lumps[4] * (-Scalar(3.0) * omega0 + Omega) * (A_x * norm_F))
       + times_i(lumps[5] * (A_x * norm_F * norm_F))
       + lumps[6] * (norm_A_x * A_x)
       + times_i(lumps[7] * (norm_A_x * A_x))
       + times_i(lumps[8] * (norm_A_x * A_x * norm_F))
       + times_i(lumps[9] * (norm_A_x * norm_A_x * A_x))
       + lumps[10] * (conj_A_x * conj_A_x * F)
       + times_i(lumps[11] * (conj_A_x * conj_A_x * F))
       + times_i(lumps[12] * (-Scalar(3.0) * omega0 + Omega) * (conj_A_x * conj_A_x * F))
       + times_i(lumps[13] * (conj_A_x * conj_A_x * norm_F * F))
       - times_i((-omega0 + excitation_frequency[0] / Scalar(3.0)) * A_x));
}

/// jacobian[i * 2 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 83 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega0 = parameters[0];
  const Scalar Omega = excitation_frequency[0];
  Scalar lumps[36];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Complex conj_A_x = conjugate(A_x);
  const Scalar norm_A_x = norm_of(A_x);
  const Complex F = load_complex(forcing, 0);
  const Complex conj_F = conjugate(F);
  const Scalar norm_F = norm_of(F);
  for (std::size_t i = 0; i < 4; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = times_i(lumps[0] * Scalar(4) * (A_x * A_x * A_x * conj_F))
       + times_i(lumps[0] * (conj_A_x * conj_A_x * conj_A_x * F))
       + Complex(lumps[1] * (-Scalar(1.0)))
       + times_i(Complex(lumps[2]))
       + times_i(Complex(lumps[3] * (norm_F)))
       + times_i(Complex(lumps[4] * (-Scalar(3.0) * omega0 + Omega) * (norm_F)))
       + times_i(Complex(lumps[5] * (norm_F * norm_F)))
       + Complex(lumps[6] * Scalar(2) * (norm_A_x))
       + times_i(Complex(lumps[7] * Scalar(2) * (norm_A_x)))
       + times_i(Complex(lumps[8] * Scalar(2) * (norm_A_x * norm_F)))
       + times_i(Complex(lumps[9] * Scalar(3) * (norm_A_x * norm_A_x)))
       - Complex(Scalar(0.0), -omega0 + excitation_frequency[0] / Scalar(3.0));
  const Complex conj_by_0_0 = times_i(lumps[0] * Scalar(3) * (norm_A_x * conj_A_x * F))
       + lumps[6] * (A_x * A_x)
       + times_i(lumps[7] * (A_x * A_x))
       + times_i(lumps[8] * (A_x * A_x * norm_F))
       + times_i(lumps[9] * Scalar(2) * (norm_A_x * A_x * A_x))
       + lumps[10] * Scalar(2) * (conj_A_x * F)
       + times_i(lumps[11] * Scalar(2) * (conj_A_x * F))
       + times_i(lumps[12] * (-Scalar(3.0) * omega0 + Omega) * Scalar(2) * (conj_A_x * F))
       + times_i(lumps[13] * Scalar(2) * (conj_A_x * norm_F * F));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[2] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[3] = by_0_0.real - conj_by_0_0.real;
}

}  // namespace subharmonic_3_second_order

}  // namespace secular::generated::duffing
