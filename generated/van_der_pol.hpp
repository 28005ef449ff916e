// Model van_der_pol: generated code, never edited by hand.
// Source: B. van der Pol, Philosophical Magazine 2, 978 (1926)
// Equation of motion: 0 = omega0^2*x + mu*x^2*D(x) - mu*D(x) + D2(x)
// Case free: no resonance, multiple scales to eps^2. Valid near that resonance for small amplitudes; what is
// left out is of order eps^3.
// Case free_third_order: no resonance, multiple scales to eps^3. Valid near that resonance for small
// amplitudes; what is left out is of order eps^4.
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// Made by: secular generate van_der_pol
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

namespace secular::generated::van_der_pol {

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
/// 0 = omega0^2*x + mu*x^2*D(x) - mu*D(x) + D2(x)
/// parameters: [0] omega0, [1] mu. displacement, velocity, acceleration: 1 values. 8 operations.
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
/// nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x) = 0. 8
/// operations before the solution of 2 right sides.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_state([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  const Scalar omega0 = parameters[0];
  const Scalar mu = parameters[1];
  const Scalar omega0_2 = omega0 * omega0;
  for (std::size_t i = 0; i < 2; ++i) slope[i] = Scalar(0.0);
  slope[0] = -(omega0_2 + mu * displacement[0] * velocity[0] * Scalar(2.0));  // equation 1 by x
  slope[1] = -(mu * displacement[0] * displacement[0] - mu);  // equation 1 by D(x)
}

/// slope[k * 2 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = omega0, mu. Of
/// nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x) = 0. 6
/// operations before the solution of 2 right sides.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_parameters([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  const Scalar omega0 = parameters[0];
  for (std::size_t i = 0; i < 2; ++i) slope[i] = Scalar(0.0);
  slope[0] = -(Scalar(2.0) * omega0 * displacement[0]);  // equation 1 by omega0
  slope[1] = -(displacement[0] * displacement[0] * velocity[0] - Scalar(1.0) * velocity[0]);  // equation 1 by mu
}

namespace free {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: mu = mu
/// lumps[1]: conservative_x_A_x = -mu^2/(8*omega0)
/// 2 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
  const Scalar omega0 = parameters[0];
  const Scalar mu = parameters[1];
  const Scalar mu_2 = mu * mu;
  lumps[0] = mu;  // mu
  lumps[1] = -mu_2 / (Scalar(8.0) * omega0);  // conservative_x_A_x
}

/// jacobian[l * 2 + p] = d lumps[l] / d parameters[p]. 4 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  const Scalar omega0 = parameters[0];
  const Scalar mu = parameters[1];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar mu_2 = mu * mu;
  for (std::size_t i = 0; i < 4; ++i) jacobian[i] = Scalar(0.0);
  jacobian[1] = Scalar(1.0);  // d mu / d mu
  jacobian[2] = mu_2 / (Scalar(8.0) * omega0_2);  // d conservative_x_A_x / d omega0
  jacobian[3] = -mu / (Scalar(4.0) * omega0);  // d conservative_x_A_x / d mu
}

/// What multiplies the 5 terms of the modulation of x: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0) / Scalar(2.0);
  factor[1] = -Scalar(1.0) / Scalar(2.0);
  factor[2] = Scalar(1.0);
  factor[3] = -Scalar(4.0);
  factor[4] = Scalar(7.0) / Scalar(2.0);
}

/// Rows of the modulation of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega0)*A_x = 1/2*mu*A_x - 1/2*mu*A_x^2*conj(A_x) + i*conservative_x_A_x*A_x -
/// 4*i*conservative_x_A_x*A_x^2*conj(A_x) + 7/2*i*conservative_x_A_x*A_x^3*conj(A_x)^2
/// 2 columns; per observation at most 16 products and sums of complex numbers.
template <class Factors>
void rows_0(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[5];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    store_complex(column_0, i, factor[0] * (A_x) + factor[1] * (norm_A_x * A_x));  // mu
    // conservative_x_A_x
    store_complex(column_1, i, times_i(factor[2] * (A_x)) + times_i(factor[3] * (norm_A_x * A_x))
        + times_i(factor[4] * (norm_A_x * norm_A_x * A_x)));
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

/// What multiplies the 3 terms of the harmonic 3*omega0 of x: functions of the frequencies alone. 6 operations.
template <class Scalar>
void factors_1([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  factor[0] = Scalar(1.0) / (Scalar(8.0) * omega0);
  factor[1] = Scalar(1.0) / (Scalar(4.0) * omega0);
  factor[2] = Scalar(1.0) / (Scalar(8.0) * omega0);
}

/// Rows of the harmonic 3*omega0 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega0)*t) in x = 1/(8*omega0)*i*mu*A_x^3 + 1/(4*omega0)*conservative_x_A_x*A_x^3 +
/// 1/(8*omega0)*conservative_x_A_x*A_x^4*conj(A_x)
/// 2 columns; per observation at most 18 products and sums of complex numbers.
template <class Factors>
void rows_1(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[3];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    store_complex(column_0, i, times_i(factor[0] * (A_x * A_x * A_x)));  // mu
    // conservative_x_A_x
    store_complex(column_1, i, factor[1] * (A_x * A_x * A_x) + factor[2] * (norm_A_x * A_x * A_x * A_x));
  }
}

/// columns[j][i] of the rows.
inline void columns_1(const BatchArrays& data, double* const* columns) {
  rows_1(data, FactorValues<factors_1<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_1(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_1(data, FactorSlopes<factors_1<DualNumber>, 1, 0, 3>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic 5*omega0 of x: functions of the frequencies alone. 2 operations.
template <class Scalar>
void factors_2([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  factor[0] = Scalar(5.0) / (Scalar(24.0) * omega0);
}

/// Rows of the harmonic 5*omega0 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(5*omega0)*t) in x = 5/(24*omega0)*conservative_x_A_x*A_x^5
/// 1 columns; per observation at most 1 products and sums of complex numbers.
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
    store_complex(column_0, i, factor[0] * (fixed_power<5>(A_x)));  // conservative_x_A_x
  }
}

/// columns[j][i] of the rows.
inline void columns_2(const BatchArrays& data, double* const* columns) {
  rows_2(data, FactorValues<factors_2<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_2(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_2(data, FactorSlopes<factors_2<DualNumber>, 1, 0, 1>{mode}, columns);
}

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_x/dt + i*(w_x - omega0)*B_x = 1/2*mu*A_x - 1/2*mu*A_x^2*conj(A_x) + i*conservative_x_A_x*A_x -
/// 4*i*conservative_x_A_x*A_x^2*conj(A_x) + 7/2*i*conservative_x_A_x*A_x^3*conj(A_x)^2 with A = B in that frame
/// 20 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  Scalar lumps[2];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Scalar norm_A_x = norm_of(A_x);
  store_complex(derivative, 0, lumps[0] * Scalar(1.0) / Scalar(2.0) * (A_x)
       + lumps[0] * (-Scalar(1.0) / Scalar(2.0)) * (norm_A_x * A_x)
       + times_i(lumps[1] * (A_x))
       + times_i(lumps[1] * (-Scalar(4.0)) * (norm_A_x * A_x))
       + times_i(lumps[1] * Scalar(7.0) / Scalar(2.0) * (norm_A_x * norm_A_x * A_x)));
}

/// jacobian[i * 2 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 37 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  Scalar lumps[2];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Scalar norm_A_x = norm_of(A_x);
  for (std::size_t i = 0; i < 4; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = Complex(lumps[0] * Scalar(1.0) / Scalar(2.0))
       + Complex(lumps[0] * (-Scalar(1.0) / Scalar(2.0)) * Scalar(2) * (norm_A_x))
       + times_i(Complex(lumps[1]))
       + times_i(Complex(lumps[1] * (-Scalar(4.0)) * Scalar(2) * (norm_A_x)))
       + times_i(Complex(lumps[1] * Scalar(7.0) / Scalar(2.0) * Scalar(3) * (norm_A_x * norm_A_x)));
  const Complex conj_by_0_0 = lumps[0] * (-Scalar(1.0) / Scalar(2.0)) * (A_x * A_x)
       + times_i(lumps[1] * (-Scalar(4.0)) * (A_x * A_x))
       + times_i(lumps[1] * Scalar(7.0) / Scalar(2.0) * Scalar(2) * (norm_A_x * A_x * A_x));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[2] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[3] = by_0_0.real - conj_by_0_0.real;
}

}  // namespace free

namespace free_third_order {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: mu = mu
/// lumps[1]: conservative_x_A_x = -mu^2/(8*omega0)
/// lumps[2]: dissipative_x_A_x2_conjA_x = (-2*omega0^2*mu - mu^3)/(4*omega0^2)
/// lumps[3]: dissipative_x_A_x3_conjA_x2 = 35*mu^3/(64*omega0^2)
/// 10 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
  const Scalar omega0 = parameters[0];
  const Scalar mu = parameters[1];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar mu_2 = mu * mu;
  const Scalar mu_3 = mu_2 * mu;
  lumps[0] = mu;  // mu
  lumps[1] = -mu_2 / (Scalar(8.0) * omega0);  // conservative_x_A_x
  lumps[2] = (-Scalar(2.0) * omega0_2 * mu - mu_3) / (Scalar(4.0) * omega0_2);  // dissipative_x_A_x2_conjA_x
  lumps[3] = Scalar(35.0) * mu_3 / (Scalar(64.0) * omega0_2);  // dissipative_x_A_x3_conjA_x2
}

/// jacobian[l * 2 + p] = d lumps[l] / d parameters[p]. 17 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  const Scalar omega0 = parameters[0];
  const Scalar mu = parameters[1];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar mu_2 = mu * mu;
  const Scalar mu_3 = mu_2 * mu;
  for (std::size_t i = 0; i < 8; ++i) jacobian[i] = Scalar(0.0);
  jacobian[1] = Scalar(1.0);  // d mu / d mu
  jacobian[2] = mu_2 / (Scalar(8.0) * omega0_2);  // d conservative_x_A_x / d omega0
  jacobian[3] = -mu / (Scalar(4.0) * omega0);  // d conservative_x_A_x / d mu
  jacobian[4] = mu_3 / (Scalar(2.0) * omega0_3);  // d dissipative_x_A_x2_conjA_x / d omega0
  // d dissipative_x_A_x2_conjA_x / d mu
  jacobian[5] = (-Scalar(2.0) * omega0_2 - Scalar(3.0) * mu_2) / (Scalar(4.0) * omega0_2);
  jacobian[6] = -Scalar(35.0) * mu_3 / (Scalar(32.0) * omega0_3);  // d dissipative_x_A_x3_conjA_x2 / d omega0
  jacobian[7] = Scalar(105.0) * mu_2 / (Scalar(64.0) * omega0_2);  // d dissipative_x_A_x3_conjA_x2 / d mu
}

/// What multiplies the 7 terms of the modulation of x: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  factor[0] = Scalar(1.0) / Scalar(2.0);
  factor[1] = Scalar(1.0);
  factor[2] = -Scalar(4.0);
  factor[3] = Scalar(7.0) / Scalar(2.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
  factor[6] = -Scalar(37.0) / Scalar(70.0);
}

/// Rows of the modulation of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega0)*A_x = 1/2*mu*A_x + i*conservative_x_A_x*A_x - 4*i*conservative_x_A_x*A_x^2*conj(A_x) +
/// 7/2*i*conservative_x_A_x*A_x^3*conj(A_x)^2 + dissipative_x_A_x2_conjA_x*A_x^2*conj(A_x) +
/// dissipative_x_A_x3_conjA_x2*A_x^3*conj(A_x)^2 - 37/70*dissipative_x_A_x3_conjA_x2*A_x^4*conj(A_x)^3
/// 4 columns; per observation at most 28 products and sums of complex numbers.
template <class Factors>
void rows_0(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar factor[7];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    store_complex(column_0, i, factor[0] * (A_x));  // mu
    // conservative_x_A_x
    store_complex(column_1, i, times_i(factor[1] * (A_x)) + times_i(factor[2] * (norm_A_x * A_x))
        + times_i(factor[3] * (norm_A_x * norm_A_x * A_x)));
    store_complex(column_2, i, factor[4] * (norm_A_x * A_x));  // dissipative_x_A_x2_conjA_x
    // dissipative_x_A_x3_conjA_x2
    store_complex(column_3, i, factor[5] * (norm_A_x * norm_A_x * A_x)
        + factor[6] * (norm_A_x * norm_A_x * norm_A_x * A_x));
  }
}

/// columns[j][i] of the rows.
inline void columns_0(const BatchArrays& data, double* const* columns) {
  rows_0(data, FactorValues<factors_0<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_0(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i < 2 * data.count; ++i) columns[j][i] = 0;
}

/// What multiplies the 6 terms of the harmonic 3*omega0 of x: functions of the frequencies alone. 12 operations.
template <class Scalar>
void factors_1([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  factor[0] = Scalar(1.0) / (Scalar(8.0) * omega0);
  factor[1] = Scalar(1.0) / (Scalar(4.0) * omega0);
  factor[2] = Scalar(1.0) / (Scalar(8.0) * omega0);
  factor[3] = Scalar(1.0) / (Scalar(70.0) * omega0);
  factor[4] = -Scalar(3.0) / (Scalar(20.0) * omega0);
  factor[5] = Scalar(29.0) / (Scalar(280.0) * omega0);
}

/// Rows of the harmonic 3*omega0 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega0)*t) in x = 1/(8*omega0)*i*mu*A_x^3 + 1/(4*omega0)*conservative_x_A_x*A_x^3 +
/// 1/(8*omega0)*conservative_x_A_x*A_x^4*conj(A_x) + 1/(70*omega0)*i*dissipative_x_A_x3_conjA_x2*A_x^3 -
/// 3/(20*omega0)*i*dissipative_x_A_x3_conjA_x2*A_x^4*conj(A_x) +
/// 29/(280*omega0)*i*dissipative_x_A_x3_conjA_x2*A_x^5*conj(A_x)^2
/// 3 columns; per observation at most 41 products and sums of complex numbers.
template <class Factors>
void rows_1(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[6];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    store_complex(column_0, i, times_i(factor[0] * (A_x * A_x * A_x)));  // mu
    // conservative_x_A_x
    store_complex(column_1, i, factor[1] * (A_x * A_x * A_x) + factor[2] * (norm_A_x * A_x * A_x * A_x));
    // dissipative_x_A_x3_conjA_x2
    store_complex(column_2, i, times_i(factor[3] * (A_x * A_x * A_x))
        + times_i(factor[4] * (norm_A_x * A_x * A_x * A_x))
        + times_i(factor[5] * (norm_A_x * norm_A_x * A_x * A_x * A_x)));
  }
}

/// columns[j][i] of the rows.
inline void columns_1(const BatchArrays& data, double* const* columns) {
  rows_1(data, FactorValues<factors_1<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_1(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_1(data, FactorSlopes<factors_1<DualNumber>, 1, 0, 6>{mode}, columns);
}

/// What multiplies the 3 terms of the harmonic 5*omega0 of x: functions of the frequencies alone. 6 operations.
template <class Scalar>
void factors_2([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  factor[0] = Scalar(5.0) / (Scalar(24.0) * omega0);
  factor[1] = -Scalar(1.0) / (Scalar(36.0) * omega0);
  factor[2] = -Scalar(1.0) / (Scalar(168.0) * omega0);
}

/// Rows of the harmonic 5*omega0 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(5*omega0)*t) in x = 5/(24*omega0)*conservative_x_A_x*A_x^5 -
/// 1/(36*omega0)*i*dissipative_x_A_x3_conjA_x2*A_x^5 -
/// 1/(168*omega0)*i*dissipative_x_A_x3_conjA_x2*A_x^6*conj(A_x)
/// 2 columns; per observation at most 6 products and sums of complex numbers.
template <class Factors>
void rows_2(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[3];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_x = load_complex(amplitude_0, i);
    const Scalar norm_A_x = norm_of(A_x);
    store_complex(column_0, i, factor[0] * (fixed_power<5>(A_x)));  // conservative_x_A_x
    // dissipative_x_A_x3_conjA_x2
    store_complex(column_1, i, times_i(factor[1] * (fixed_power<5>(A_x)))
        + times_i(factor[2] * (norm_A_x * fixed_power<5>(A_x))));
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

/// What multiplies the 1 terms of the harmonic 7*omega0 of x: functions of the frequencies alone. 2 operations.
template <class Scalar>
void factors_3([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  factor[0] = -Scalar(1.0) / (Scalar(90.0) * omega0);
}

/// Rows of the harmonic 7*omega0 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(7*omega0)*t) in x = -1/(90*omega0)*i*dissipative_x_A_x3_conjA_x2*A_x^7
/// 1 columns; per observation at most 1 products and sums of complex numbers.
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
    store_complex(column_0, i, times_i(factor[0] * (fixed_power<7>(A_x))));  // dissipative_x_A_x3_conjA_x2
  }
}

/// columns[j][i] of the rows.
inline void columns_3(const BatchArrays& data, double* const* columns) {
  rows_3(data, FactorValues<factors_3<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_3(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_3(data, FactorSlopes<factors_3<DualNumber>, 1, 0, 1>{mode}, columns);
}

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_x/dt + i*(w_x - omega0)*B_x = 1/2*mu*A_x + i*conservative_x_A_x*A_x -
/// 4*i*conservative_x_A_x*A_x^2*conj(A_x) + 7/2*i*conservative_x_A_x*A_x^3*conj(A_x)^2 +
/// dissipative_x_A_x2_conjA_x*A_x^2*conj(A_x) + dissipative_x_A_x3_conjA_x2*A_x^3*conj(A_x)^2 -
/// 37/70*dissipative_x_A_x3_conjA_x2*A_x^4*conj(A_x)^3 with A = B in that frame
/// 29 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  Scalar lumps[4];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Scalar norm_A_x = norm_of(A_x);
  store_complex(derivative, 0, lumps[0] * Scalar(1.0) / Scalar(2.0) * (A_x)
       + times_i(lumps[1] * (A_x))
       + times_i(lumps[1] * (-Scalar(4.0)) * (norm_A_x * A_x))
       + times_i(lumps[1] * Scalar(7.0) / Scalar(2.0) * (norm_A_x * norm_A_x * A_x))
       + lumps[2] * (norm_A_x * A_x)
       + lumps[3] * (norm_A_x * norm_A_x * A_x)
       + lumps[3] * (-Scalar(37.0) / Scalar(70.0)) * (norm_A_x * norm_A_x * norm_A_x * A_x));
}

/// jacobian[i * 2 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 57 operations besides the lumps.
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
  const Complex by_0_0 = Complex(lumps[0] * Scalar(1.0) / Scalar(2.0))
       + times_i(Complex(lumps[1]))
       + times_i(Complex(lumps[1] * (-Scalar(4.0)) * Scalar(2) * (norm_A_x)))
       + times_i(Complex(lumps[1] * Scalar(7.0) / Scalar(2.0) * Scalar(3) * (norm_A_x * norm_A_x)))
       + Complex(lumps[2] * Scalar(2) * (norm_A_x))
       + Complex(lumps[3] * Scalar(3) * (norm_A_x * norm_A_x))
       + Complex(lumps[3] * (-Scalar(37.0) / Scalar(70.0)) * Scalar(4) * (norm_A_x * norm_A_x * norm_A_x));
  const Complex conj_by_0_0 = times_i(lumps[1] * (-Scalar(4.0)) * (A_x * A_x))
       + times_i(lumps[1] * Scalar(7.0) / Scalar(2.0) * Scalar(2) * (norm_A_x * A_x * A_x))
       + lumps[2] * (A_x * A_x)
       + lumps[3] * Scalar(2) * (norm_A_x * A_x * A_x)
       + lumps[3] * (-Scalar(37.0) / Scalar(70.0)) * Scalar(3) * (norm_A_x * norm_A_x * A_x * A_x);
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[2] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[3] = by_0_0.real - conj_by_0_0.real;
}

}  // namespace free_third_order

}  // namespace secular::generated::van_der_pol
