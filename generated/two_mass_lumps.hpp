// Model two_mass_lumps: generated code, never edited by hand.
// Source: S. O'F. Fahey, dissertation, Virginia Tech, 2000, Eqs. (6.25)-(6.35)
// Equation of motion: 0 = (omega1^2 + lambda)*v1 + kappa*v1*(F*cos(Omega*t))^2 + alpha1*v1^3 + 2*mu11*D(v1) +
// mu13*D(v1)^3 + D2(v1) - p*v2*F*cos(Omega*t) - q1*D(v2)*F*cos(Omega*t)
// Equation of motion: 0 = -p*v1*F*cos(Omega*t) - q2*D(v1)*F*cos(Omega*t) + omega2^2*v2 + alpha2*v2^3 +
// 2*mu22*D(v2) + mu23*D(v2)^3 + D2(v2)
// Case additive_combination: Omega = omega1 + omega2 + eps*sigma, multiple scales to eps^1. Valid near that
// resonance for small amplitudes; what is left out is of order eps^2.
// Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.
// Made by: secular generate two_mass_lumps
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

namespace secular::generated::two_mass_lumps {

/// Mass matrix M of the equations of motion M*acceleration + force = 0 below, state-dependent: mass[k * 2 + j]
/// multiplies the acceleration of mode j in equation k. 0 operations.
template <class Scalar, class Parameter, class Sample>
void mass_matrix([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* mass) {
  mass[0] = Scalar(1.0);
  mass[1] = Scalar(0.0);
  mass[2] = Scalar(0.0);
  mass[3] = Scalar(1.0);
}

/// Accelerations of the full equations of motion, solved from the state-dependent mass matrix.
/// 0 = (omega1^2 + lambda)*v1 + kappa*v1*(F*cos(Omega*t))^2 + alpha1*v1^3 + 2*mu11*D(v1) + mu13*D(v1)^3 + D2(v1)
/// - p*v2*F*cos(Omega*t) - q1*D(v2)*F*cos(Omega*t)
/// 0 = -p*v1*F*cos(Omega*t) - q2*D(v1)*F*cos(Omega*t) + omega2^2*v2 + alpha2*v2^3 + 2*mu22*D(v2) + mu23*D(v2)^3
/// + D2(v2)
/// parameters: [0] omega1, [1] omega2, [2] mu11, [3] mu13, [4] lambda, [5] alpha1, [6] kappa, [7] p, [8] q1, [9]
/// mu22, [10] mu23, [11] alpha2, [12] q2. displacement, velocity, acceleration: 2 values. 43 operations.
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
      + kappa * displacement[0] * Scalar(excitation[0].value) * Scalar(excitation[0].value)
      + alpha1 * displacement[0] * displacement[0] * displacement[0] + Scalar(2.0) * mu11 * velocity[0]
      + mu13 * velocity[0] * velocity[0] * velocity[0] - p * displacement[1] * Scalar(excitation[0].value)
      - q1 * velocity[1] * Scalar(excitation[0].value));
  acceleration[1] = -(-p * displacement[0] * Scalar(excitation[0].value)
      - q2 * velocity[0] * Scalar(excitation[0].value) + omega2_2 * displacement[1]
      + alpha2 * displacement[1] * displacement[1] * displacement[1] + Scalar(2.0) * mu22 * velocity[1]
      + mu23 * velocity[1] * velocity[1] * velocity[1]);
}

/// slope[k * 4 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = v1, v2, D(v1),
/// D(v2). Of nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x) = 0.
/// 28 operations before the solution of 4 right sides.
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
  for (std::size_t i = 0; i < 8; ++i) slope[i] = Scalar(0.0);
  // equation 1 by v1
  slope[0] = -(omega1_2 + lambda + kappa * Scalar(excitation[0].value) * Scalar(excitation[0].value)
      + alpha1 * displacement[0] * displacement[0] * Scalar(3.0));
  slope[1] = -(-p * Scalar(excitation[0].value));  // equation 1 by v2
  slope[2] = -(Scalar(2.0) * mu11 + mu13 * velocity[0] * velocity[0] * Scalar(3.0));  // equation 1 by D(v1)
  slope[3] = -(-q1 * Scalar(excitation[0].value));  // equation 1 by D(v2)
  slope[4] = -(-p * Scalar(excitation[0].value));  // equation 2 by v1
  slope[5] = -(omega2_2 + alpha2 * displacement[1] * displacement[1] * Scalar(3.0));  // equation 2 by v2
  slope[6] = -(-q2 * Scalar(excitation[0].value));  // equation 2 by D(v1)
  slope[7] = -(Scalar(2.0) * mu22 + mu23 * velocity[1] * velocity[1] * Scalar(3.0));  // equation 2 by D(v2)
}

/// slope[k * 13 + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = omega1, omega2,
/// mu11, mu13, lambda, alpha1, kappa, p, q1, mu22, mu23, alpha2, q2. Of nonsmooth terms the classical
/// derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x) = 0. 24 operations before the solution of 13
/// right sides.
template <class Scalar, class Parameter, class Sample>
void acceleration_by_parameters([[maybe_unused]] const Parameter* parameters,
    [[maybe_unused]] const Sample* excitation,
    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
    Scalar* slope) {
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  for (std::size_t i = 0; i < 26; ++i) slope[i] = Scalar(0.0);
  slope[0] = -(Scalar(2.0) * omega1 * displacement[0]);  // equation 1 by omega1
  slope[2] = -(Scalar(2.0) * velocity[0]);  // equation 1 by mu11
  slope[3] = -(velocity[0] * velocity[0] * velocity[0]);  // equation 1 by mu13
  slope[4] = -(displacement[0]);  // equation 1 by lambda
  slope[5] = -(displacement[0] * displacement[0] * displacement[0]);  // equation 1 by alpha1
  slope[6] = -(displacement[0] * Scalar(excitation[0].value) * Scalar(excitation[0].value));  // equation 1 by kappa
  slope[7] = -(-Scalar(1.0) * displacement[1] * Scalar(excitation[0].value));  // equation 1 by p
  slope[8] = -(-Scalar(1.0) * velocity[1] * Scalar(excitation[0].value));  // equation 1 by q1
  slope[14] = -(Scalar(2.0) * omega2 * displacement[1]);  // equation 2 by omega2
  slope[20] = -(-Scalar(1.0) * displacement[0] * Scalar(excitation[0].value));  // equation 2 by p
  slope[22] = -(Scalar(2.0) * velocity[1]);  // equation 2 by mu22
  slope[23] = -(velocity[1] * velocity[1] * velocity[1]);  // equation 2 by mu23
  slope[24] = -(displacement[1] * displacement[1] * displacement[1]);  // equation 2 by alpha2
  slope[25] = -(-Scalar(1.0) * velocity[0] * Scalar(excitation[0].value));  // equation 2 by q2
}

namespace additive_combination {

/// Lumps: the parameter combinations that multiply data.
/// lumps[0]: mu11 = mu11
/// lumps[1]: lambda = lambda
/// lumps[2]: kappa = kappa
/// lumps[3]: mu13 = mu13
/// lumps[4]: alpha1 = alpha1
/// lumps[5]: q1 = q1
/// lumps[6]: p = p
/// lumps[7]: mu22 = mu22
/// lumps[8]: mu23 = mu23
/// lumps[9]: alpha2 = alpha2
/// lumps[10]: q2 = q2
/// 0 operations.
template <class Scalar>
void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {
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
  lumps[0] = mu11;  // mu11
  lumps[1] = lambda;  // lambda
  lumps[2] = kappa;  // kappa
  lumps[3] = mu13;  // mu13
  lumps[4] = alpha1;  // alpha1
  lumps[5] = q1;  // q1
  lumps[6] = p;  // p
  lumps[7] = mu22;  // mu22
  lumps[8] = mu23;  // mu23
  lumps[9] = alpha2;  // alpha2
  lumps[10] = q2;  // q2
}

/// jacobian[l * 13 + p] = d lumps[l] / d parameters[p]. 0 operations.
template <class Scalar>
void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* jacobian) {
  for (std::size_t i = 0; i < 143; ++i) jacobian[i] = Scalar(0.0);
  jacobian[2] = Scalar(1.0);  // d mu11 / d mu11
  jacobian[17] = Scalar(1.0);  // d lambda / d lambda
  jacobian[32] = Scalar(1.0);  // d kappa / d kappa
  jacobian[42] = Scalar(1.0);  // d mu13 / d mu13
  jacobian[57] = Scalar(1.0);  // d alpha1 / d alpha1
  jacobian[73] = Scalar(1.0);  // d q1 / d q1
  jacobian[85] = Scalar(1.0);  // d p / d p
  jacobian[100] = Scalar(1.0);  // d mu22 / d mu22
  jacobian[114] = Scalar(1.0);  // d mu23 / d mu23
  jacobian[128] = Scalar(1.0);  // d alpha2 / d alpha2
  jacobian[142] = Scalar(1.0);  // d q2 / d q2
}

/// What multiplies the 7 terms of the modulation of v1: functions of the frequencies alone. 13 operations.
template <class Scalar>
void factors_0([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  factor[0] = -Scalar(1.0);
  factor[1] = Scalar(1.0) / (Scalar(2.0) * omega1);
  factor[2] = Scalar(1.0) / (Scalar(4.0) * omega1);
  factor[3] = -Scalar(3.0) * omega1_2 / Scalar(2.0);
  factor[4] = Scalar(3.0) / (Scalar(2.0) * omega1);
  factor[5] = -omega2 / (Scalar(4.0) * omega1);
  factor[6] = -Scalar(1.0) / (Scalar(4.0) * omega1);
}

/// Rows of the modulation of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega1)*A_v1 = -mu11*A_v1 + 1/(2*omega1)*i*lambda*A_v1 + 1/(4*omega1)*i*kappa*A_v1*F^2 -
/// 3*omega1^2/2*mu13*A_v1^2*conj(A_v1) + 3/(2*omega1)*i*alpha1*A_v1^2*conj(A_v1) -
/// omega2/(4*omega1)*q1*conj(A_v2)*F - 1/(4*omega1)*i*p*conj(A_v2)*F
/// 7 columns; per observation at most 17 products and sums of complex numbers.
template <class Factors>
void rows_0(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar* __restrict column_4 = columns[4];
  Scalar* __restrict column_5 = columns[5];
  Scalar* __restrict column_6 = columns[6];
  Scalar factor[7];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Scalar norm_A_v1 = norm_of(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex conj_A_v2 = conjugate(A_v2);
    const Complex F = load_complex(forcing_0, i);
    const Scalar norm_F = norm_of(F);
    store_complex(column_0, i, factor[0] * (A_v1));  // mu11
    store_complex(column_1, i, times_i(factor[1] * (A_v1)));  // lambda
    store_complex(column_2, i, times_i(factor[2] * (A_v1 * norm_F)));  // kappa
    store_complex(column_3, i, factor[3] * (norm_A_v1 * A_v1));  // mu13
    store_complex(column_4, i, times_i(factor[4] * (norm_A_v1 * A_v1)));  // alpha1
    store_complex(column_5, i, factor[5] * (conj_A_v2 * F));  // q1
    store_complex(column_6, i, times_i(factor[6] * (conj_A_v2 * F)));  // p
  }
}

/// columns[j][i] of the rows.
inline void columns_0(const BatchArrays& data, double* const* columns) {
  rows_0(data, FactorValues<factors_0<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_0(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_0(data, FactorSlopes<factors_0<DualNumber>, 2, 1, 7>{mode}, columns);
}

/// What multiplies the 5 terms of the modulation of v2: functions of the frequencies alone. 9 operations.
template <class Scalar>
void factors_1([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega2_2 = omega2 * omega2;
  factor[0] = -Scalar(1.0) / (Scalar(4.0) * omega2);
  factor[1] = -Scalar(1.0);
  factor[2] = -Scalar(3.0) * omega2_2 / Scalar(2.0);
  factor[3] = Scalar(3.0) / (Scalar(2.0) * omega2);
  factor[4] = -omega1 / (Scalar(4.0) * omega2);
}

/// Rows of the modulation of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// (rate - i*omega2)*A_v2 = -1/(4*omega2)*i*p*conj(A_v1)*F - mu22*A_v2 - 3*omega2^2/2*mu23*A_v2^2*conj(A_v2) +
/// 3/(2*omega2)*i*alpha2*A_v2^2*conj(A_v2) - omega1/(4*omega2)*q2*conj(A_v1)*F
/// 5 columns; per observation at most 13 products and sums of complex numbers.
template <class Factors>
void rows_1(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar* __restrict column_3 = columns[3];
  Scalar* __restrict column_4 = columns[4];
  Scalar factor[5];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Scalar norm_A_v2 = norm_of(A_v2);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, times_i(factor[0] * (conj_A_v1 * F)));  // p
    store_complex(column_1, i, factor[1] * (A_v2));  // mu22
    store_complex(column_2, i, factor[2] * (norm_A_v2 * A_v2));  // mu23
    store_complex(column_3, i, times_i(factor[3] * (norm_A_v2 * A_v2)));  // alpha2
    store_complex(column_4, i, factor[4] * (conj_A_v1 * F));  // q2
  }
}

/// columns[j][i] of the rows.
inline void columns_1(const BatchArrays& data, double* const* columns) {
  rows_1(data, FactorValues<factors_1<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_1(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_1(data, FactorSlopes<factors_1<DualNumber>, 2, 1, 5>{mode}, columns);
}

/// What multiplies the 3 terms of the harmonic omega2+Omega of v1: functions of the frequencies alone. 15
/// operations.
template <class Scalar>
void factors_2([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar per_0 = Scalar(1.0) / (omega1 - Omega);
  const Scalar per_1 = Scalar(1.0) / (omega1 + omega2 + Omega);
  const Scalar per_2 = Scalar(1.0) / (omega1 - omega2 - Omega);
  factor[0] = -per_0 / (Scalar(16.0) * Omega);
  factor[1] = omega2 * per_1 * per_2 / Scalar(2.0);
  factor[2] = per_1 * per_2 / Scalar(2.0);
}

/// Rows of the harmonic omega2+Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega2 + Omega)*t) in v1 = -1/(16*Omega*(omega1 - Omega))*kappa*conj(A_v1)*F^2 +
/// omega2/(2*(omega1 + omega2 + Omega)*(omega1 - omega2 - Omega))*i*q1*A_v2*F + 1/(2*(omega1 + omega2 +
/// Omega)*(omega1 - omega2 - Omega))*p*A_v2*F
/// 3 columns; per observation at most 11 products and sums of complex numbers.
template <class Factors>
void rows_2(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar* __restrict column_2 = columns[2];
  Scalar factor[3];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex conj_A_v1 = conjugate(A_v1);
    const Complex A_v2 = load_complex(amplitude_1, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (conj_A_v1 * F * F));  // kappa
    store_complex(column_1, i, times_i(factor[1] * (A_v2 * F)));  // q1
    store_complex(column_2, i, factor[2] * (A_v2 * F));  // p
  }
}

/// columns[j][i] of the rows.
inline void columns_2(const BatchArrays& data, double* const* columns) {
  rows_2(data, FactorValues<factors_2<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_2(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_2(data, FactorSlopes<factors_2<DualNumber>, 2, 1, 3>{mode}, columns);
}

/// What multiplies the 1 terms of the harmonic omega1+2*Omega of v1: functions of the frequencies alone. 4
/// operations.
template <class Scalar>
void factors_3([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar Omega = excitation_frequency[0];
  const Scalar per_0 = Scalar(1.0) / (omega1 + Omega);
  factor[0] = per_0 / (Scalar(16.0) * Omega);
}

/// Rows of the harmonic omega1+2*Omega of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + 2*Omega)*t) in v1 = 1/(16*Omega*(omega1 + Omega))*kappa*A_v1*F^2
/// 1 columns; per observation at most 5 products and sums of complex numbers.
template <class Factors>
void rows_3(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar factor[1];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * F * F));  // kappa
  }
}

/// columns[j][i] of the rows.
inline void columns_3(const BatchArrays& data, double* const* columns) {
  rows_3(data, FactorValues<factors_3<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_3(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_3(data, FactorSlopes<factors_3<DualNumber>, 2, 1, 1>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic 3*omega1 of v1: functions of the frequencies alone. 4 operations.
template <class Scalar>
void factors_4([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  factor[0] = -omega1 / Scalar(8.0);
  factor[1] = Scalar(1.0) / (Scalar(8.0) * omega1_2);
}

/// Rows of the harmonic 3*omega1 of v1: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega1)*t) in v1 = -omega1/8*i*mu13*A_v1^3 + 1/(8*omega1^2)*alpha1*A_v1^3
/// 2 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_4(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = load_complex(amplitude_0, i);
    store_complex(column_0, i, times_i(factor[0] * (A_v1 * A_v1 * A_v1)));  // mu13
    store_complex(column_1, i, factor[1] * (A_v1 * A_v1 * A_v1));  // alpha1
  }
}

/// columns[j][i] of the rows.
inline void columns_4(const BatchArrays& data, double* const* columns) {
  rows_4(data, FactorValues<factors_4<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_4(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_4(data, FactorSlopes<factors_4<DualNumber>, 2, 1, 2>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic 3*omega2 of v2: functions of the frequencies alone. 4 operations.
template <class Scalar>
void factors_5([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega2 = natural_frequency[1];
  const Scalar omega2_2 = omega2 * omega2;
  factor[0] = -omega2 / Scalar(8.0);
  factor[1] = Scalar(1.0) / (Scalar(8.0) * omega2_2);
}

/// Rows of the harmonic 3*omega2 of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(3*omega2)*t) in v2 = -omega2/8*i*mu23*A_v2^3 + 1/(8*omega2^2)*alpha2*A_v2^3
/// 2 columns; per observation at most 10 products and sums of complex numbers.
template <class Factors>
void rows_5(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_1 = data.amplitude[1];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  factors(natural_frequency, nullptr, factor);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v2 = load_complex(amplitude_1, i);
    store_complex(column_0, i, times_i(factor[0] * (A_v2 * A_v2 * A_v2)));  // mu23
    store_complex(column_1, i, factor[1] * (A_v2 * A_v2 * A_v2));  // alpha2
  }
}

/// columns[j][i] of the rows.
inline void columns_5(const BatchArrays& data, double* const* columns) {
  rows_5(data, FactorValues<factors_5<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_5(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_5(data, FactorSlopes<factors_5<DualNumber>, 2, 1, 2>{mode}, columns);
}

/// What multiplies the 2 terms of the harmonic omega1+Omega of v2: functions of the frequencies alone. 11
/// operations.
template <class Scalar>
void factors_6([[maybe_unused]] const Scalar* natural_frequency,
    [[maybe_unused]] const Scalar* excitation_frequency, Scalar* factor) {
  const Scalar omega1 = natural_frequency[0];
  const Scalar omega2 = natural_frequency[1];
  const Scalar Omega = excitation_frequency[0];
  const Scalar per_0 = Scalar(1.0) / (omega1 + omega2 + Omega);
  const Scalar per_1 = Scalar(1.0) / (omega1 - omega2 + Omega);
  factor[0] = -per_0 * per_1 / Scalar(2.0);
  factor[1] = -omega1 * per_0 * per_1 / Scalar(2.0);
}

/// Rows of the harmonic omega1+Omega of v2: target = sum of columns[j][i] * lump_j, with the factors above.
/// amplitude of exp(i*(omega1 + Omega)*t) in v2 = -1/(2*(omega1 + omega2 + Omega)*(omega1 - omega2 +
/// Omega))*p*A_v1*F - omega1/(2*(omega1 + omega2 + Omega)*(omega1 - omega2 + Omega))*i*q2*A_v1*F
/// 2 columns; per observation at most 6 products and sums of complex numbers.
template <class Factors>
void rows_6(const BatchArrays& data, Factors factors, double* const* columns) {
  using Scalar = double;
  using Complex = ComplexNumber<double>;
  const Scalar* __restrict amplitude_0 = data.amplitude[0];
  const Scalar* __restrict forcing_0 = data.forcing[0];
  Scalar* __restrict column_0 = columns[0];
  Scalar* __restrict column_1 = columns[1];
  Scalar factor[2];
  const Scalar natural_frequency[] = {data.natural_frequency[0], data.natural_frequency[1]};
  const Scalar* __restrict frequency_0 = data.excitation_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Scalar excitation_frequency[] = {frequency_0[i]};
    factors(natural_frequency, excitation_frequency, factor);
    const Complex A_v1 = load_complex(amplitude_0, i);
    const Complex F = load_complex(forcing_0, i);
    store_complex(column_0, i, factor[0] * (A_v1 * F));  // p
    store_complex(column_1, i, times_i(factor[1] * (A_v1 * F)));  // q2
  }
}

/// columns[j][i] of the rows.
inline void columns_6(const BatchArrays& data, double* const* columns) {
  rows_6(data, FactorValues<factors_6<double>>{}, columns);
}

/// columns[j][i] = d(column j)/d(natural frequency of `mode`).
inline void column_slopes_6(const BatchArrays& data, [[maybe_unused]] std::size_t mode,
    double* const* columns) {
  rows_6(data, FactorSlopes<factors_6<DualNumber>, 2, 1, 2>{mode}, columns);
}

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state. amplitude
/// and derivative hold Re B_0, Im B_0, Re B_1, ..., forcing Re F, Im F of every excitation.
/// dB_v1/dt + i*(w_v1 - omega1)*B_v1 = -mu11*A_v1 + 1/(2*omega1)*i*lambda*A_v1 + 1/(4*omega1)*i*kappa*A_v1*F^2 -
/// 3*omega1^2/2*mu13*A_v1^2*conj(A_v1) + 3/(2*omega1)*i*alpha1*A_v1^2*conj(A_v1) -
/// omega2/(4*omega1)*q1*conj(A_v2)*F - 1/(4*omega1)*i*p*conj(A_v2)*F with A = B in that frame
/// dB_v2/dt + i*(w_v2 - omega2)*B_v2 = -1/(4*omega2)*i*p*conj(A_v1)*F - mu22*A_v2 -
/// 3*omega2^2/2*mu23*A_v2^2*conj(A_v2) + 3/(2*omega2)*i*alpha2*A_v2^2*conj(A_v2) -
/// omega1/(4*omega2)*q2*conj(A_v1)*F with A = B in that frame
/// 69 operations besides the lumps.
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* derivative) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  Scalar lumps[11];
  evaluate_lumps(parameters, lumps);
  const Complex A_v1 = load_complex(amplitude, 0);
  const Complex conj_A_v1 = conjugate(A_v1);
  const Scalar norm_A_v1 = norm_of(A_v1);
  const Complex A_v2 = load_complex(amplitude, 1);
  const Complex conj_A_v2 = conjugate(A_v2);
  const Scalar norm_A_v2 = norm_of(A_v2);
  const Complex F = load_complex(forcing, 0);
  const Scalar norm_F = norm_of(F);
  store_complex(derivative, 0, lumps[0] * (-Scalar(1.0)) * (A_v1)
       + times_i(lumps[1] * Scalar(1.0) / (Scalar(2.0) * omega1) * (A_v1))
       + times_i(lumps[2] * Scalar(1.0) / (Scalar(4.0) * omega1) * (A_v1 * norm_F))
       + lumps[3] * (-Scalar(3.0) * omega1_2 / Scalar(2.0)) * (norm_A_v1 * A_v1)
       + times_i(lumps[4] * Scalar(3.0) / (Scalar(2.0) * omega1) * (norm_A_v1 * A_v1))
       + lumps[5] * (-omega2 / (Scalar(4.0) * omega1)) * (conj_A_v2 * F)
       + times_i(lumps[6] * (-Scalar(1.0) / (Scalar(4.0) * omega1)) * (conj_A_v2 * F))
       - times_i((-omega1 - omega2 + excitation_frequency[0]) * A_v1));
  store_complex(derivative, 1, times_i(lumps[6] * (-Scalar(1.0) / (Scalar(4.0) * omega2)) * (conj_A_v1 * F))
       + lumps[7] * (-Scalar(1.0)) * (A_v2)
       + lumps[8] * (-Scalar(3.0) * omega2_2 / Scalar(2.0)) * (norm_A_v2 * A_v2)
       + times_i(lumps[9] * Scalar(3.0) / (Scalar(2.0) * omega2) * (norm_A_v2 * A_v2))
       + lumps[10] * (-omega1 / (Scalar(4.0) * omega2)) * (conj_A_v1 * F));
}

/// jacobian[i * 4 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero. 96 operations besides the lumps.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const Scalar* amplitude, [[maybe_unused]] const Scalar* forcing,
    Scalar* jacobian) {
  using Complex = ComplexNumber<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  Scalar lumps[11];
  evaluate_lumps(parameters, lumps);
  const Complex A_v1 = load_complex(amplitude, 0);
  const Scalar norm_A_v1 = norm_of(A_v1);
  const Complex A_v2 = load_complex(amplitude, 1);
  const Scalar norm_A_v2 = norm_of(A_v2);
  const Complex F = load_complex(forcing, 0);
  const Scalar norm_F = norm_of(F);
  for (std::size_t i = 0; i < 16; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = Complex(lumps[0] * (-Scalar(1.0)))
       + times_i(Complex(lumps[1] * Scalar(1.0) / (Scalar(2.0) * omega1)))
       + times_i(Complex(lumps[2] * Scalar(1.0) / (Scalar(4.0) * omega1) * (norm_F)))
       + Complex(lumps[3] * (-Scalar(3.0) * omega1_2 / Scalar(2.0)) * Scalar(2) * (norm_A_v1))
       + times_i(Complex(lumps[4] * Scalar(3.0) / (Scalar(2.0) * omega1) * Scalar(2) * (norm_A_v1)))
       - Complex(Scalar(0.0), -omega1 - omega2 + excitation_frequency[0]);
  const Complex conj_by_0_0 = lumps[3] * (-Scalar(3.0) * omega1_2 / Scalar(2.0)) * (A_v1 * A_v1)
       + times_i(lumps[4] * Scalar(3.0) / (Scalar(2.0) * omega1) * (A_v1 * A_v1));
  jacobian[0] = by_0_0.real + conj_by_0_0.real;
  jacobian[1] = conj_by_0_0.imag - by_0_0.imag;
  jacobian[4] = by_0_0.imag + conj_by_0_0.imag;
  jacobian[5] = by_0_0.real - conj_by_0_0.real;
  const Complex by_0_1 = Complex();
  const Complex conj_by_0_1 = lumps[5] * (-omega2 / (Scalar(4.0) * omega1)) * (F)
       + times_i(lumps[6] * (-Scalar(1.0) / (Scalar(4.0) * omega1)) * (F));
  jacobian[2] = by_0_1.real + conj_by_0_1.real;
  jacobian[3] = conj_by_0_1.imag - by_0_1.imag;
  jacobian[6] = by_0_1.imag + conj_by_0_1.imag;
  jacobian[7] = by_0_1.real - conj_by_0_1.real;
  const Complex by_1_0 = Complex();
  const Complex conj_by_1_0 = times_i(lumps[6] * (-Scalar(1.0) / (Scalar(4.0) * omega2)) * (F))
       + lumps[10] * (-omega1 / (Scalar(4.0) * omega2)) * (F);
  jacobian[8] = by_1_0.real + conj_by_1_0.real;
  jacobian[9] = conj_by_1_0.imag - by_1_0.imag;
  jacobian[12] = by_1_0.imag + conj_by_1_0.imag;
  jacobian[13] = by_1_0.real - conj_by_1_0.real;
  const Complex by_1_1 = Complex(lumps[7] * (-Scalar(1.0)))
       + Complex(lumps[8] * (-Scalar(3.0) * omega2_2 / Scalar(2.0)) * Scalar(2) * (norm_A_v2))
       + times_i(Complex(lumps[9] * Scalar(3.0) / (Scalar(2.0) * omega2) * Scalar(2) * (norm_A_v2)));
  const Complex conj_by_1_1 = lumps[8] * (-Scalar(3.0) * omega2_2 / Scalar(2.0)) * (A_v2 * A_v2)
       + times_i(lumps[9] * Scalar(3.0) / (Scalar(2.0) * omega2) * (A_v2 * A_v2));
  jacobian[10] = by_1_1.real + conj_by_1_1.real;
  jacobian[11] = conj_by_1_1.imag - by_1_1.imag;
  jacobian[14] = by_1_1.imag + conj_by_1_1.imag;
  jacobian[15] = by_1_1.real - conj_by_1_1.real;
}

}  // namespace additive_combination

}  // namespace secular::generated::two_mass_lumps
