// Model mathieu_duffing: generated code, never edited by hand.
// Source: E. Mathieu, Journal de Mathematiques 13, 137 (1868), with a cubic term
// Equation of motion: 0 = omega0^2*x + h*x*F*cos(Omega*t) + a3*x^3 + 2*mu*D(x) + D2(x)
// Case principal: Omega = 2*omega0 + eps*sigma, multiple scales to eps^2. Valid near that resonance for small
// amplitudes; what is left out is of order eps^3.
// Case fundamental: Omega = omega0 + eps^2*sigma, multiple scales to eps^2. Valid near that resonance for small
// amplitudes; what is left out is of order eps^3.
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// Made by: secular generate mathieu_duffing
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

namespace secular::generated::mathieu_duffing {

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
/// 0 = omega0^2*x + h*x*F*cos(Omega*t) + a3*x^3 + 2*mu*D(x) + D2(x)
/// parameters: [0] omega0, [1] mu, [2] a3, [3] h. displacement, velocity, acceleration: 1 values. 12 operations.
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
  acceleration[0] = -(omega0_2 * displacement[0] + h * displacement[0] * Scalar(excitation[0].value)
      + a3 * displacement[0] * displacement[0] * displacement[0] + Scalar(2.0) * mu * velocity[0]);
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
  const Scalar a3 = parameters[2];
  const Scalar h = parameters[3];
  const Scalar omega0_2 = omega0 * omega0;
  for (std::size_t i = 0; i < 2; ++i) slope[i] = Scalar(0.0);
  // equation 1 by x
  slope[0] = -(omega0_2 + h * Scalar(excitation[0].value) + a3 * displacement[0] * displacement[0] * Scalar(3.0));
  slope[1] = -(Scalar(2.0) * mu);  // equation 1 by D(x)
}

/// slope[k * 4 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = omega0, mu, a3, h.
/// Of nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x) = 0. 6
/// operations before the solution of 4 right sides.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_parameters([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  const Scalar omega0 = parameters[0];
  for (std::size_t i = 0; i < 4; ++i) slope[i] = Scalar(0.0);
  slope[0] = -(Scalar(2.0) * omega0 * displacement[0]);  // equation 1 by omega0
  slope[1] = -(Scalar(2.0) * velocity[0]);  // equation 1 by mu
  slope[2] = -(displacement[0] * displacement[0] * displacement[0]);  // equation 1 by a3
  slope[3] = -(displacement[0] * Scalar(excitation[0].value));  // equation 1 by h
}

namespace principal {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: conservative_x_A_x3_F = 7*a3*h/(32*omega0^3)
/// lumps[1]: mu = mu
/// lumps[2]: conservative_x_A_x = -mu^2/(2*omega0)
/// lumps[3]: conservative_x_A_x_F2 = 3*h^2/(64*omega0^3)
/// lumps[4]: dissipative_x_A_x2_conjA_x = 3*mu*a3/(2*omega0^2)
/// lumps[5]: a3 = a3
/// lumps[6]: conservative_x_A_x3_conjA_x2 = -15*a3^2/(16*omega0^3)
/// lumps[7]: h = h
/// 16 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
  const Scalar omega0 = parameters[0];
  const Scalar mu = parameters[1];
  const Scalar a3 = parameters[2];
  const Scalar h = parameters[3];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar mu_2 = mu * mu;
  const Scalar a3_2 = a3 * a3;
  const Scalar h_2 = h * h;
  lumps[0] = Scalar(7.0) * a3 * h / (Scalar(32.0) * omega0_3);  // conservative_x_A_x3_F
  lumps[1] = mu;  // mu
  lumps[2] = -mu_2 / (Scalar(2.0) * omega0);  // conservative_x_A_x
  lumps[3] = Scalar(3.0) * h_2 / (Scalar(64.0) * omega0_3);  // conservative_x_A_x_F2
  lumps[4] = Scalar(3.0) * mu * a3 / (Scalar(2.0) * omega0_2);  // dissipative_x_A_x2_conjA_x
  lumps[5] = a3;  // a3
  lumps[6] = -Scalar(15.0) * a3_2 / (Scalar(16.0) * omega0_3);  // conservative_x_A_x3_conjA_x2
  lumps[7] = h;  // h
}

/// jacobian[l * 4 + p] = d lumps[l] / d parameters[p]. 34 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  const Scalar omega0 = parameters[0];
  const Scalar mu = parameters[1];
  const Scalar a3 = parameters[2];
  const Scalar h = parameters[3];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar mu_2 = mu * mu;
  const Scalar a3_2 = a3 * a3;
  const Scalar h_2 = h * h;
  for (std::size_t i = 0; i < 32; ++i) jacobian[i] = Scalar(0.0);
  jacobian[0] = -Scalar(21.0) * a3 * h / (Scalar(32.0) * omega0_4);  // d conservative_x_A_x3_F / d omega0
  jacobian[2] = Scalar(7.0) * h / (Scalar(32.0) * omega0_3);  // d conservative_x_A_x3_F / d a3
  jacobian[3] = Scalar(7.0) * a3 / (Scalar(32.0) * omega0_3);  // d conservative_x_A_x3_F / d h
  jacobian[5] = Scalar(1.0);  // d mu / d mu
  jacobian[8] = mu_2 / (Scalar(2.0) * omega0_2);  // d conservative_x_A_x / d omega0
  jacobian[9] = -mu / omega0;  // d conservative_x_A_x / d mu
  jacobian[12] = -Scalar(9.0) * h_2 / (Scalar(64.0) * omega0_4);  // d conservative_x_A_x_F2 / d omega0
  jacobian[15] = Scalar(3.0) * h / (Scalar(32.0) * omega0_3);  // d conservative_x_A_x_F2 / d h
  jacobian[16] = -Scalar(3.0) * mu * a3 / omega0_3;  // d dissipative_x_A_x2_conjA_x / d omega0
  jacobian[17] = Scalar(3.0) * a3 / (Scalar(2.0) * omega0_2);  // d dissipative_x_A_x2_conjA_x / d mu
  jacobian[18] = Scalar(3.0) * mu / (Scalar(2.0) * omega0_2);  // d dissipative_x_A_x2_conjA_x / d a3
  jacobian[22] = Scalar(1.0);  // d a3 / d a3
  jacobian[24] = Scalar(45.0) * a3_2 / (Scalar(16.0) * omega0_4);  // d conservative_x_A_x3_conjA_x2 / d omega0
  jacobian[26] = -Scalar(15.0) * a3 / (Scalar(8.0) * omega0_3);  // d conservative_x_A_x3_conjA_x2 / d a3
  jacobian[31] = Scalar(1.0);  // d h / d h
}

/// What multiplies the 10 terms of the modulation of x: functions of the frequencies alone. 10 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  factor[0] = Scalar(1.0);
  factor[1] = -Scalar(3.0) / Scalar(7.0);
  factor[2] = -Scalar(1.0);
  factor[3] = Scalar(1.0);
  factor[4] = Scalar(1.0);
  factor[5] = Scalar(1.0);
  factor[6] = Scalar(3.0) / (Scalar(2.0) * omega0);
  factor[7] = Scalar(1.0);
  factor[8] = Scalar(1.0) / (Scalar(4.0) * omega0);
  factor[9] = (Scalar(2.0) * omega0 - Omega) / (Scalar(8.0) * omega0_2);
}

/// Rows of the modulation of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega0)*A_x = i*conservative_x_A_x3_F*A_x^3*F - 3/7*i*conservative_x_A_x3_F*A_x*conj(A_x)^2*F -
/// mu*A_x + i*conservative_x_A_x*A_x + i*conservative_x_A_x_F2*A_x*F^2 +
/// dissipative_x_A_x2_conjA_x*A_x^2*conj(A_x) + 3/(2*omega0)*i*a3*A_x^2*conj(A_x) +
/// i*conservative_x_A_x3_conjA_x2*A_x^3*conj(A_x)^2 + 1/(4*omega0)*i*h*conj(A_x)*F + (2*omega0 -
/// Omega)/(8*omega0^2)*i*h*conj(A_x)*F
/// 8 columns; per observation at most 36 products and sums of complex numbers.
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
  Scalar factor[10];
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
    // conservative_x_A_x3_F
    store_complex(column_0, i, times_i(factor[0] * (A_x * A_x * A_x * conj_F))
        + times_i(factor[1] * (norm_A_x * conj_A_x * F)));
    store_complex(column_1, i, factor[2] * (A_x));  // mu
    store_complex(column_2, i, times_i(factor[3] * (A_x)));  // conservative_x_A_x
    store_complex(column_3, i, times_i(factor[4] * (A_x * norm_F)));  // conservative_x_A_x_F2
    store_complex(column_4, i, factor[5] * (norm_A_x * A_x));  // dissipative_x_A_x2_conjA_x
    store_complex(column_5, i, times_i(factor[6] * (norm_A_x * A_x)));  // a3
    store_complex(column_6, i, times_i(factor[7] * (norm_A_x * norm_A_x * A_x)));  // conservative_x_A_x3_conjA_x2
    store_complex(column_7, i, times_i(factor[8] * (conj_A_x * F)) + times_i(factor[9] * (conj_A_x * F)));  // h
  }
}

/// columns[j][i] of the rows.
inline void columns_0(const BatchArrays& data, double* const* columns) {
  rows_0(data, FactorValues<factors_0<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_0(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_0(data, FactorSlopes<factors_0<DualNumber>, 1, 1, 10>{mode}, columns);
}

/// What multiplies the 7 terms of the harmonic omega0+Omega of x: functions of the frequencies alone. 31
/// operations.
template <class Scalar>
void factors_1([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar Omega_2 = Omega * Omega;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega0 + Omega);
  const Scalar per_0_2 = per_0 * per_0;
  factor[0] = (Scalar(48.0) * omega0_3 - Scalar(48.0) * omega0_2 * Omega) * per_0_2 / (Scalar(7.0) * Omega_2);
  factor[1] = -Scalar(9.0) / (Scalar(28.0) * omega0);
  factor[2] = (-Scalar(16.0) * omega0_3 - Scalar(16.0) * omega0_2 * Omega) * per_0_2 / (Scalar(3.0) * Omega_2);
  factor[3] = -Scalar(1.0) / (Scalar(8.0) * omega0);
  factor[4] = Scalar(1.0) / (Scalar(8.0) * omega0_2);
  factor[5] = Scalar(7.0) / (Scalar(20.0) * omega0);
  factor[6] = per_0 / (Scalar(2.0) * Omega);
}

/// Rows of the harmonic omega0+Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega0 + Omega)*t) in x = (48*omega0^3 - 48*omega0^2*Omega)/(7*Omega^2*(2*omega0 +
/// Omega)^2)*conservative_x_A_x3_F*A_x^2*conj(A_x)*F - 9/(28*omega0)*conservative_x_A_x3_F*A_x^2*conj(A_x)*F +
/// (-16*omega0^3 - 16*omega0^2*Omega)/(3*Omega^2*(2*omega0 + Omega)^2)*conservative_x_A_x_F2*conj(A_x)*F^2 -
/// 1/(8*omega0)*i*dissipative_x_A_x2_conjA_x*A_x^3 + 1/(8*omega0^2)*a3*A_x^3 +
/// 7/(20*omega0)*conservative_x_A_x3_conjA_x2*A_x^4*conj(A_x) + 1/(2*Omega*(2*omega0 + Omega))*h*A_x*F
/// 6 columns; per observation at most 36 products and sums of complex numbers.
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
    // conservative_x_A_x3_F
    store_complex(column_0, i, factor[0] * (norm_A_x * A_x * F) + factor[1] * (norm_A_x * A_x * F));
    store_complex(column_1, i, factor[2] * (conj_A_x * F * F));  // conservative_x_A_x_F2
    store_complex(column_2, i, times_i(factor[3] * (A_x * A_x * A_x)));  // dissipative_x_A_x2_conjA_x
    store_complex(column_3, i, factor[4] * (A_x * A_x * A_x));  // a3
    store_complex(column_4, i, factor[5] * (norm_A_x * A_x * A_x * A_x));  // conservative_x_A_x3_conjA_x2
    store_complex(column_5, i, factor[6] * (A_x * F));  // h
  }
}

/// columns[j][i] of the rows.
inline void columns_1(const BatchArrays& data, double* const* columns) {
  rows_1(data, FactorValues<factors_1<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_1(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_1(data, FactorSlopes<factors_1<DualNumber>, 1, 1, 7>{mode}, columns);
}

/// What multiplies the 3 terms of the harmonic omega0+2*Omega of x: functions of the frequencies alone. 30
/// operations.
template <class Scalar>
void factors_2([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar Omega_2 = Omega * Omega;
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega0 + Omega);
  const Scalar per_0_2 = per_0 * per_0;
  const Scalar per_1 = Scalar(1.0) / (Scalar(4.0) * omega0 + Omega);
  const Scalar per_2 = Scalar(1.0) / (omega0 + Omega);
  factor[0] = (Scalar(48.0) * omega0_3 + Scalar(4.0) * omega0_2 * Omega
      + Scalar(2.0) * omega0 * Omega_2) * per_0_2 * per_1 / (Scalar(7.0) * Omega);
  factor[1] = Scalar(4.0) * omega0_3 * per_2 * per_0 / (Scalar(3.0) * Omega_2);
  factor[2] = -Scalar(1.0) / (Scalar(60.0) * omega0);
}

/// Rows of the harmonic omega0+2*Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega0 + 2*Omega)*t) in x = (48*omega0^3 + 4*omega0^2*Omega +
/// 2*omega0*Omega^2)/(7*Omega*(2*omega0 + Omega)^2*(4*omega0 + Omega))*conservative_x_A_x3_F*A_x^3*F +
/// 4*omega0^3/(3*Omega^2*(omega0 + Omega)*(2*omega0 + Omega))*conservative_x_A_x_F2*A_x*F^2 -
/// 1/(60*omega0)*conservative_x_A_x3_conjA_x2*A_x^5
/// 3 columns; per observation at most 13 products and sums of complex numbers.
template <class Factors>
void rows_2(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[3];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_x * A_x * A_x * F));  // conservative_x_A_x3_F
    store_complex(column_1, i, factor[1] * (A_x * F * F));  // conservative_x_A_x_F2
    store_complex(column_2, i, factor[2] * (fixed_power<5>(A_x)));  // conservative_x_A_x3_conjA_x2
  }
}

/// columns[j][i] of the rows.
inline void columns_2(const BatchArrays& data, double* const* columns) {
  rows_2(data, FactorValues<factors_2<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_2(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_2(data, FactorSlopes<factors_2<DualNumber>, 1, 1, 3>{mode}, columns);
}

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_x/dt + i*(w_x - omega0)*B_x = i*conservative_x_A_x3_F*A_x^3*F -
/// 3/7*i*conservative_x_A_x3_F*A_x*conj(A_x)^2*F - mu*A_x + i*conservative_x_A_x*A_x +
/// i*conservative_x_A_x_F2*A_x*F^2 + dissipative_x_A_x2_conjA_x*A_x^2*conj(A_x) +
/// 3/(2*omega0)*i*a3*A_x^2*conj(A_x) + i*conservative_x_A_x3_conjA_x2*A_x^3*conj(A_x)^2 +
/// 1/(4*omega0)*i*h*conj(A_x)*F + (2*omega0 - Omega)/(8*omega0^2)*i*h*conj(A_x)*F with A = B in that frame
/// 50 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega0 = parameters[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  Scalar lumps[8];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Complex conj_A_x = conjugate(A_x);
  const Scalar norm_A_x = norm_of(A_x);
  const Complex F = load_complex(forcing, 0);
  const Complex conj_F = conjugate(F);
  const Scalar norm_F = norm_of(F);
  store_complex(derivative, 0, times_i(lumps[0] * (A_x * A_x * A_x * conj_F))
       + times_i(lumps[0] * (-Scalar(3.0) / Scalar(7.0)) * (norm_A_x * conj_A_x * F))
       + lumps[1] * (-Scalar(1.0)) * (A_x)
       + times_i(lumps[2] * (A_x))
       + times_i(lumps[3] * (A_x * norm_F))
       + lumps[4] * (norm_A_x * A_x)
       + times_i(lumps[5] * Scalar(3.0) / (Scalar(2.0) * omega0) * (norm_A_x * A_x))
       + times_i(lumps[6] * (norm_A_x * norm_A_x * A_x))
       + times_i(lumps[7] * Scalar(1.0) / (Scalar(4.0) * omega0) * (conj_A_x * F))
       + times_i(lumps[7] * (Scalar(2.0) * omega0 - Omega) / (Scalar(8.0) * omega0_2) * (conj_A_x * F))
       - times_i((-omega0 + excitation_frequency[0] / Scalar(2.0)) * A_x));
}

/// jacobian[i * 2 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 67 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega0 = parameters[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  Scalar lumps[8];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Complex conj_A_x = conjugate(A_x);
  const Scalar norm_A_x = norm_of(A_x);
  const Complex F = load_complex(forcing, 0);
  const Complex conj_F = conjugate(F);
  const Scalar norm_F = norm_of(F);
  for (std::size_t i = 0; i < 4; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = times_i(lumps[0] * Scalar(3) * (A_x * A_x * conj_F))
       + times_i(lumps[0] * (-Scalar(3.0) / Scalar(7.0)) * (conj_A_x * conj_A_x * F))
       + Complex(lumps[1] * (-Scalar(1.0)))
       + times_i(Complex(lumps[2]))
       + times_i(Complex(lumps[3] * (norm_F)))
       + Complex(lumps[4] * Scalar(2) * (norm_A_x))
       + times_i(Complex(lumps[5] * Scalar(3.0) / (Scalar(2.0) * omega0) * Scalar(2) * (norm_A_x)))
       + times_i(Complex(lumps[6] * Scalar(3) * (norm_A_x * norm_A_x)))
       - Complex(Scalar(0.0), -omega0 + excitation_frequency[0] / Scalar(2.0));
  const Complex conj_by_0_0 = times_i(lumps[0] * (-Scalar(3.0) / Scalar(7.0)) * Scalar(2) * (norm_A_x * F))
       + lumps[4] * (A_x * A_x)
       + times_i(lumps[5] * Scalar(3.0) / (Scalar(2.0) * omega0) * (A_x * A_x))
       + times_i(lumps[6] * Scalar(2) * (norm_A_x * A_x * A_x))
       + times_i(lumps[7] * Scalar(1.0) / (Scalar(4.0) * omega0) * (F))
       + times_i(lumps[7] * (Scalar(2.0) * omega0 - Omega) / (Scalar(8.0) * omega0_2) * (F));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[2] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[3] = by_0_0.real - conj_by_0_0.real;
}

}  // namespace principal

namespace fundamental {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: mu = mu
/// lumps[1]: conservative_x_A_x_F2 = -h^2/(12*omega0^3)
/// lumps[2]: a3 = a3
/// lumps[3]: h = h
/// 2 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
  const Scalar omega0 = parameters[0];
  const Scalar mu = parameters[1];
  const Scalar a3 = parameters[2];
  const Scalar h = parameters[3];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar h_2 = h * h;
  lumps[0] = mu;  // mu
  lumps[1] = -h_2 / (Scalar(12.0) * omega0_3);  // conservative_x_A_x_F2
  lumps[2] = a3;  // a3
  lumps[3] = h;  // h
}

/// jacobian[l * 4 + p] = d lumps[l] / d parameters[p]. 4 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  const Scalar omega0 = parameters[0];
  const Scalar h = parameters[3];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar omega0_4 = omega0_3 * omega0;
  const Scalar h_2 = h * h;
  for (std::size_t i = 0; i < 16; ++i) jacobian[i] = Scalar(0.0);
  jacobian[1] = Scalar(1.0);  // d mu / d mu
  jacobian[4] = h_2 / (Scalar(4.0) * omega0_4);  // d conservative_x_A_x_F2 / d omega0
  jacobian[7] = -h / (Scalar(6.0) * omega0_3);  // d conservative_x_A_x_F2 / d h
  jacobian[10] = Scalar(1.0);  // d a3 / d a3
  jacobian[15] = Scalar(1.0);  // d h / d h
}

/// What multiplies the 4 terms of the modulation of x: functions of the frequencies alone. 3 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  factor[0] = -Scalar(1.0);
  factor[1] = Scalar(1.0);
  factor[2] = Scalar(3.0) / Scalar(2.0);
  factor[3] = Scalar(3.0) / (Scalar(2.0) * omega0);
}

/// Rows of the modulation of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega0)*A_x = -mu*A_x + i*conservative_x_A_x_F2*A_x*F^2 + 3/2*i*conservative_x_A_x_F2*conj(A_x)*F^2
/// + 3/(2*omega0)*i*a3*A_x^2*conj(A_x)
/// 3 columns; per observation at most 13 products and sums of complex numbers.
template <class Factors>
void rows_0(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
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
    // conservative_x_A_x_F2
    store_complex(column_1, i, times_i(factor[1] * (A_x * norm_F)) + times_i(factor[2] * (conj_A_x * F * F)));
    store_complex(column_2, i, times_i(factor[3] * (norm_A_x * A_x)));  // a3
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

/// What multiplies the 2 terms of the harmonic 0 of x: functions of the frequencies alone. 7 operations.
template <class Scalar>
void factors_1([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega0 - Omega);
  factor[0] = -per_0 / (Scalar(2.0) * Omega);
  factor[1] = -per_0 / (Scalar(2.0) * Omega);
}

/// Rows of the harmonic 0 of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(0)*t) in x = -1/(2*Omega*(2*omega0 - Omega))*h*conj(A_x)*F - 1/(2*Omega*(2*omega0 -
/// Omega))*h*A_x*F
/// 1 columns; per observation at most 7 products and sums of complex numbers.
template <class Factors>
void rows_1(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_x = load_complex(amplitude_0, i);
    const Complex conj_A_x = conjugate(A_x);
    const Complex F = load_complex(forcing_0, i);
    const Complex conj_F = conjugate(F);
    store_complex(column_0, i, factor[0] * (conj_A_x * F) + factor[1] * (A_x * conj_F));  // h
  }
}

/// columns[j][i] of the rows.
inline void columns_1(const BatchArrays& data, double* const* columns) {
  rows_1(data, FactorValues<factors_1<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_1(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_1(data, FactorSlopes<factors_1<DualNumber>, 1, 1, 2>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic omega0+Omega of x: functions of the frequencies alone. 5
/// operations.
template <class Scalar>
void factors_2([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar per_0 = Scalar(1.0) / (Scalar(2.0) * omega0 + Omega);
  factor[0] = per_0 / (Scalar(2.0) * Omega);
}

/// Rows of the harmonic omega0+Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega0 + Omega)*t) in x = 1/(2*Omega*(2*omega0 + Omega))*h*A_x*F
/// 1 columns; per observation at most 3 products and sums of complex numbers.
template <class Factors>
void rows_2(const BatchArrays& data, Factors factors, double* const* columns) {
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
    store_complex(column_0, i, factor[0] * (A_x * F));  // h
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

/// What multiplies the 2 terms of the harmonic omega0+2*Omega of x: functions of the frequencies alone. 15
/// operations.
template <class Scalar>
void factors_3([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega0 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar omega0_3 = omega0_2 * omega0;
  const Scalar Omega_2 = Omega * Omega;
  const Scalar per_0 = Scalar(1.0) / (omega0 + Omega);
  const Scalar per_1 = Scalar(1.0) / (Scalar(2.0) * omega0 + Omega);
  factor[0] = -Scalar(3.0) * omega0_3 * per_0 * per_1 / (Scalar(4.0) * Omega_2);
  factor[1] = Scalar(1.0) / (Scalar(8.0) * omega0_2);
}

/// Rows of the harmonic omega0+2*Omega of x: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega0 + 2*Omega)*t) in x = -3*omega0^3/(4*Omega^2*(omega0 + Omega)*(2*omega0 +
/// Omega))*conservative_x_A_x_F2*A_x*F^2 + 1/(8*omega0^2)*a3*A_x^3
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
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_x * F * F));  // conservative_x_A_x_F2
    store_complex(column_1, i, factor[1] * (A_x * A_x * A_x));  // a3
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

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_x/dt + i*(w_x - omega0)*B_x = -mu*A_x + i*conservative_x_A_x_F2*A_x*F^2 +
/// 3/2*i*conservative_x_A_x_F2*conj(A_x)*F^2 + 3/(2*omega0)*i*a3*A_x^2*conj(A_x) with A = B in that frame
/// 20 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega0 = parameters[0];
  Scalar lumps[4];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Complex conj_A_x = conjugate(A_x);
  const Scalar norm_A_x = norm_of(A_x);
  const Complex F = load_complex(forcing, 0);
  const Scalar norm_F = norm_of(F);
  store_complex(derivative, 0, lumps[0] * (-Scalar(1.0)) * (A_x)
       + times_i(lumps[1] * (A_x * norm_F))
       + times_i(lumps[1] * Scalar(3.0) / Scalar(2.0) * (conj_A_x * F * F))
       + times_i(lumps[2] * Scalar(3.0) / (Scalar(2.0) * omega0) * (norm_A_x * A_x))
       - times_i((-omega0 + excitation_frequency[0]) * A_x));
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
  Scalar lumps[4];
  evaluate_lumps(parameters, lumps);
  const Complex A_x = load_complex(amplitude, 0);
  const Scalar norm_A_x = norm_of(A_x);
  const Complex F = load_complex(forcing, 0);
  const Scalar norm_F = norm_of(F);
  for (std::size_t i = 0; i < 4; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = Complex(lumps[0] * (-Scalar(1.0)))
       + times_i(Complex(lumps[1] * (norm_F)))
       + times_i(Complex(lumps[2] * Scalar(3.0) / (Scalar(2.0) * omega0) * Scalar(2) * (norm_A_x)))
       - Complex(Scalar(0.0), -omega0 + excitation_frequency[0]);
  const Complex conj_by_0_0 = times_i(lumps[1] * Scalar(3.0) / Scalar(2.0) * (F * F))
       + times_i(lumps[2] * Scalar(3.0) / (Scalar(2.0) * omega0) * (A_x * A_x));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[2] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[3] = by_0_0.real - conj_by_0_0.real;
}

}  // namespace fundamental

}  // namespace secular::generated::mathieu_duffing
