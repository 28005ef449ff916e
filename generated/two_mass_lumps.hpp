// Model two_mass_lumps: generated code, never edited by hand.
// Source: S. O'F. Fahey, dissertation, Virginia Tech, 2000, Eqs. (6.25)-(6.35)
// Equation of motion: 0 = (omega1^2 + lambda)*v1 + kappa*v1*(F*cos(Omega*t))^2 + alpha1*v1^3 + 2*mu11*D(v1) +
// mu13*D(v1)^3 + D2(v1) - p*v2*F*cos(Omega*t) - q1*D(v2)*F*cos(Omega*t)
// Equation of motion: 0 = -p*v1*F*cos(Omega*t) - q2*D(v1)*F*cos(Omega*t) + omega2^2*v2 + alpha2*v2^3 +
// 2*mu22*D(v2) + mu23*D(v2)^3 + D2(v2)
// Case additive_combination: Omega = omega1 + omega2 + eps*sigma, multiple scales to eps^1. Valid near that
// resonance for small amplitudes; what is left out is of order eps^2.
// Units: SI; frequencies in rad/s; amplitudes as in estimator/compiled_model.hpp.
// Made by: secular generate two_mass_lumps
#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

#include "estimator/compiled_model.hpp"
#include "estimator/dense_solve.hpp"
#include "estimator/integer_power.hpp"

namespace secular::generated::two_mass_lumps {

/// Accelerations of the full equations of motion, solved from the state-dependent mass matrix.
/// 0 = (omega1^2 + lambda)*v1 + kappa*v1*(F*cos(Omega*t))^2 + alpha1*v1^3 + 2*mu11*D(v1) + mu13*D(v1)^3 + D2(v1)
/// - p*v2*F*cos(Omega*t) - q1*D(v2)*F*cos(Omega*t)
/// 0 = -p*v1*F*cos(Omega*t) - q2*D(v1)*F*cos(Omega*t) + omega2^2*v2 + alpha2*v2^3 + 2*mu22*D(v2) + mu23*D(v2)^3
/// + D2(v2)
/// parameters: [0] omega1, [1] omega2, [2] mu11, [3] mu13, [4] lambda, [5] alpha1, [6] kappa, [7] p, [8] q1, [9]
/// mu22, [10] mu23, [11] alpha2, [12] q2. displacement, velocity, acceleration: 2 values. 3 operations.
template <class Scalar>
void accelerations(const Scalar* parameters, [[maybe_unused]] const ExcitationSample* excitation,
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
  Scalar mass[2 * 2] = {
    Scalar(1.0),
    Scalar(0.0),
    Scalar(0.0),
    Scalar(1.0),
  };
  acceleration[0] = -((omega1_2 + lambda) * displacement[0]
      + kappa * displacement[0] * Scalar(excitation[0].value) * Scalar(excitation[0].value)
      + alpha1 * displacement[0] * displacement[0] * displacement[0] + Scalar(2.0) * mu11 * velocity[0]
      + mu13 * velocity[0] * velocity[0] * velocity[0] - p * displacement[1] * Scalar(excitation[0].value)
      - q1 * velocity[1] * Scalar(excitation[0].value));
  acceleration[1] = -(-p * displacement[0] * Scalar(excitation[0].value)
      - q2 * velocity[0] * Scalar(excitation[0].value) + omega2_2 * displacement[1]
      + alpha2 * displacement[1] * displacement[1] * displacement[1] + Scalar(2.0) * mu22 * velocity[1]
      + mu23 * velocity[1] * velocity[1] * velocity[1]);
  solve_in_place<2>(mass, acceleration);
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

/// Regressor rows of the modulation of v1: target = sum of columns[j][i] * lump_j.
/// (rate - i*omega1)*A_v1 = -mu11*A_v1 + 1/(2*omega1)*i*lambda*A_v1 + 1/(4*omega1)*i*kappa*A_v1*F^2 -
/// 3*omega1^2/2*mu13*A_v1^2*conj(A_v1) + 3/(2*omega1)*i*alpha1*A_v1^2*conj(A_v1) -
/// omega2/(4*omega1)*q1*conj(A_v2)*F - 1/(4*omega1)*i*p*conj(A_v2)*F
/// 7 columns; per observation 12 complex products, 0 complex sums.
inline void columns_0(const ObservationBatch& data, std::complex<double>* const* columns) {
  using Scalar = double;
  using Complex = std::complex<double>;
  const Scalar omega1 = data.natural_frequency[0];
  const Scalar omega2 = data.natural_frequency[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar factor_0_0 = -Scalar(1.0);
  const Scalar factor_1_0 = Scalar(1.0) / (Scalar(2.0) * omega1);
  const Scalar factor_2_0 = Scalar(1.0) / (Scalar(4.0) * omega1);
  const Scalar factor_3_0 = -Scalar(3.0) * omega1_2 / Scalar(2.0);
  const Scalar factor_4_0 = Scalar(3.0) / (Scalar(2.0) * omega1);
  const Scalar factor_5_0 = -omega2 / (Scalar(4.0) * omega1);
  const Scalar factor_6_0 = -Scalar(1.0) / (Scalar(4.0) * omega1);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = data.amplitude[0][i];
    const Scalar norm_A_v1 = std::norm(A_v1);
    const Complex A_v2 = data.amplitude[1][i];
    const Complex conj_A_v2 = std::conj(A_v2);
    const Complex F = data.forcing[0][i];
    const Scalar norm_F = std::norm(F);
    columns[0][i] = factor_0_0 * (A_v1);  // mu11
    columns[1][i] = Complex(Scalar(0), Scalar(1)) * factor_1_0 * (A_v1);  // lambda
    columns[2][i] = Complex(Scalar(0), Scalar(1)) * factor_2_0 * (A_v1 * norm_F);  // kappa
    columns[3][i] = factor_3_0 * (norm_A_v1 * A_v1);  // mu13
    columns[4][i] = Complex(Scalar(0), Scalar(1)) * factor_4_0 * (norm_A_v1 * A_v1);  // alpha1
    columns[5][i] = factor_5_0 * (conj_A_v2 * F);  // q1
    columns[6][i] = Complex(Scalar(0), Scalar(1)) * factor_6_0 * (conj_A_v2 * F);  // p
  }
}

/// Regressor rows of the modulation of v2: target = sum of columns[j][i] * lump_j.
/// (rate - i*omega2)*A_v2 = -1/(4*omega2)*i*p*conj(A_v1)*F - mu22*A_v2 - 3*omega2^2/2*mu23*A_v2^2*conj(A_v2) +
/// 3/(2*omega2)*i*alpha2*A_v2^2*conj(A_v2) - omega1/(4*omega2)*q2*conj(A_v1)*F
/// 5 columns; per observation 9 complex products, 0 complex sums.
inline void columns_1(const ObservationBatch& data, std::complex<double>* const* columns) {
  using Scalar = double;
  using Complex = std::complex<double>;
  const Scalar omega1 = data.natural_frequency[0];
  const Scalar omega2 = data.natural_frequency[1];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar factor_0_0 = -Scalar(1.0) / (Scalar(4.0) * omega2);
  const Scalar factor_1_0 = -Scalar(1.0);
  const Scalar factor_2_0 = -Scalar(3.0) * omega2_2 / Scalar(2.0);
  const Scalar factor_3_0 = Scalar(3.0) / (Scalar(2.0) * omega2);
  const Scalar factor_4_0 = -omega1 / (Scalar(4.0) * omega2);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = data.amplitude[0][i];
    const Complex conj_A_v1 = std::conj(A_v1);
    const Complex A_v2 = data.amplitude[1][i];
    const Scalar norm_A_v2 = std::norm(A_v2);
    const Complex F = data.forcing[0][i];
    columns[0][i] = Complex(Scalar(0), Scalar(1)) * factor_0_0 * (conj_A_v1 * F);  // p
    columns[1][i] = factor_1_0 * (A_v2);  // mu22
    columns[2][i] = factor_2_0 * (norm_A_v2 * A_v2);  // mu23
    columns[3][i] = Complex(Scalar(0), Scalar(1)) * factor_3_0 * (norm_A_v2 * A_v2);  // alpha2
    columns[4][i] = factor_4_0 * (conj_A_v1 * F);  // q2
  }
}

/// Regressor rows of the harmonic omega2+Omega of v1: target = sum of columns[j][i] * lump_j.
/// amplitude of exp(i*(omega2 + Omega)*t) in v1 = -1/(16*omega1*Omega - 16*Omega^2)*kappa*conj(A_v1)*F^2 +
/// omega2/(2*omega1^2 - 2*omega2^2 - 4*omega2*Omega - 2*Omega^2)*i*q1*A_v2*F + 1/(2*omega1^2 - 2*omega2^2 -
/// 4*omega2*Omega - 2*Omega^2)*p*A_v2*F
/// 3 columns; per observation 7 complex products, 0 complex sums.
inline void columns_2(const ObservationBatch& data, std::complex<double>* const* columns) {
  using Scalar = double;
  using Complex = std::complex<double>;
  const Scalar omega1 = data.natural_frequency[0];
  const Scalar omega2 = data.natural_frequency[1];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = data.amplitude[0][i];
    const Complex conj_A_v1 = std::conj(A_v1);
    const Complex A_v2 = data.amplitude[1][i];
    const Complex F = data.forcing[0][i];
    const Scalar Omega = data.excitation_frequency[0][i];
    const Scalar omega1_2 = omega1 * omega1;
    const Scalar omega2_2 = omega2 * omega2;
    const Scalar Omega_2 = Omega * Omega;
    const Scalar factor_0_0 = -Scalar(1.0) / (Scalar(16.0) * omega1 * Omega - Scalar(16.0) * Omega_2);
    const Scalar factor_1_0 = omega2 / (Scalar(2.0) * omega1_2 - Scalar(2.0) * omega2_2
        - Scalar(4.0) * omega2 * Omega - Scalar(2.0) * Omega_2);
    const Scalar factor_2_0 = Scalar(1.0) / (Scalar(2.0) * omega1_2 - Scalar(2.0) * omega2_2
        - Scalar(4.0) * omega2 * Omega - Scalar(2.0) * Omega_2);
    columns[0][i] = factor_0_0 * (conj_A_v1 * F * F);  // kappa
    columns[1][i] = Complex(Scalar(0), Scalar(1)) * factor_1_0 * (A_v2 * F);  // q1
    columns[2][i] = factor_2_0 * (A_v2 * F);  // p
  }
}

/// Regressor rows of the harmonic omega1+2*Omega of v1: target = sum of columns[j][i] * lump_j.
/// amplitude of exp(i*(omega1 + 2*Omega)*t) in v1 = 1/(16*omega1*Omega + 16*Omega^2)*kappa*A_v1*F^2
/// 1 columns; per observation 3 complex products, 0 complex sums.
inline void columns_3(const ObservationBatch& data, std::complex<double>* const* columns) {
  using Scalar = double;
  using Complex = std::complex<double>;
  const Scalar omega1 = data.natural_frequency[0];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = data.amplitude[0][i];
    const Complex F = data.forcing[0][i];
    const Scalar Omega = data.excitation_frequency[0][i];
    const Scalar Omega_2 = Omega * Omega;
    const Scalar factor_0_0 = Scalar(1.0) / (Scalar(16.0) * omega1 * Omega + Scalar(16.0) * Omega_2);
    columns[0][i] = factor_0_0 * (A_v1 * F * F);  // kappa
  }
}

/// Regressor rows of the harmonic 3*omega1 of v1: target = sum of columns[j][i] * lump_j.
/// amplitude of exp(i*(3*omega1)*t) in v1 = -omega1/8*i*mu13*A_v1^3 + 1/(8*omega1^2)*alpha1*A_v1^3
/// 2 columns; per observation 6 complex products, 0 complex sums.
inline void columns_4(const ObservationBatch& data, std::complex<double>* const* columns) {
  using Scalar = double;
  using Complex = std::complex<double>;
  const Scalar omega1 = data.natural_frequency[0];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar factor_0_0 = -omega1 / Scalar(8.0);
  const Scalar factor_1_0 = Scalar(1.0) / (Scalar(8.0) * omega1_2);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = data.amplitude[0][i];
    columns[0][i] = Complex(Scalar(0), Scalar(1)) * factor_0_0 * (A_v1 * A_v1 * A_v1);  // mu13
    columns[1][i] = factor_1_0 * (A_v1 * A_v1 * A_v1);  // alpha1
  }
}

/// Regressor rows of the harmonic 3*omega2 of v2: target = sum of columns[j][i] * lump_j.
/// amplitude of exp(i*(3*omega2)*t) in v2 = -omega2/8*i*mu23*A_v2^3 + 1/(8*omega2^2)*alpha2*A_v2^3
/// 2 columns; per observation 6 complex products, 0 complex sums.
inline void columns_5(const ObservationBatch& data, std::complex<double>* const* columns) {
  using Scalar = double;
  using Complex = std::complex<double>;
  const Scalar omega2 = data.natural_frequency[1];
  const Scalar omega2_2 = omega2 * omega2;
  const Scalar factor_0_0 = -omega2 / Scalar(8.0);
  const Scalar factor_1_0 = Scalar(1.0) / (Scalar(8.0) * omega2_2);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v2 = data.amplitude[1][i];
    columns[0][i] = Complex(Scalar(0), Scalar(1)) * factor_0_0 * (A_v2 * A_v2 * A_v2);  // mu23
    columns[1][i] = factor_1_0 * (A_v2 * A_v2 * A_v2);  // alpha2
  }
}

/// Regressor rows of the harmonic omega1+Omega of v2: target = sum of columns[j][i] * lump_j.
/// amplitude of exp(i*(omega1 + Omega)*t) in v2 = -1/(2*omega1^2 + 4*omega1*Omega - 2*omega2^2 +
/// 2*Omega^2)*p*A_v1*F - omega1/(2*omega1^2 + 4*omega1*Omega - 2*omega2^2 + 2*Omega^2)*i*q2*A_v1*F
/// 2 columns; per observation 4 complex products, 0 complex sums.
inline void columns_6(const ObservationBatch& data, std::complex<double>* const* columns) {
  using Scalar = double;
  using Complex = std::complex<double>;
  const Scalar omega1 = data.natural_frequency[0];
  const Scalar omega2 = data.natural_frequency[1];
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_v1 = data.amplitude[0][i];
    const Complex F = data.forcing[0][i];
    const Scalar Omega = data.excitation_frequency[0][i];
    const Scalar omega1_2 = omega1 * omega1;
    const Scalar omega2_2 = omega2 * omega2;
    const Scalar Omega_2 = Omega * Omega;
    const Scalar factor_0_0 = -Scalar(1.0) / (Scalar(2.0) * omega1_2 + Scalar(4.0) * omega1 * Omega
        - Scalar(2.0) * omega2_2 + Scalar(2.0) * Omega_2);
    const Scalar factor_1_0 = -omega1 / (Scalar(2.0) * omega1_2 + Scalar(4.0) * omega1 * Omega
        - Scalar(2.0) * omega2_2 + Scalar(2.0) * Omega_2);
    columns[0][i] = factor_0_0 * (A_v1 * F);  // p
    columns[1][i] = Complex(Scalar(0), Scalar(1)) * factor_1_0 * (A_v1 * F);  // q2
  }
}

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state.
/// dB_v1/dt + i*(w_v1 - omega1)*B_v1 = -mu11*A_v1 + 1/(2*omega1)*i*lambda*A_v1 + 1/(4*omega1)*i*kappa*A_v1*F^2 -
/// 3*omega1^2/2*mu13*A_v1^2*conj(A_v1) + 3/(2*omega1)*i*alpha1*A_v1^2*conj(A_v1) -
/// omega2/(4*omega1)*q1*conj(A_v2)*F - 1/(4*omega1)*i*p*conj(A_v2)*F with A = B in that frame
/// dB_v2/dt + i*(w_v2 - omega2)*B_v2 = -1/(4*omega2)*i*p*conj(A_v1)*F - mu22*A_v2 -
/// 3*omega2^2/2*mu23*A_v2^2*conj(A_v2) + 3/(2*omega2)*i*alpha2*A_v2^2*conj(A_v2) -
/// omega1/(4*omega2)*q2*conj(A_v1)*F with A = B in that frame
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
                const std::complex<Scalar>* amplitude,
                [[maybe_unused]] const std::complex<Scalar>* forcing, std::complex<Scalar>* derivative) {
  using Complex = std::complex<Scalar>;
  const Scalar omega1 = parameters[0];
  const Scalar omega2 = parameters[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  Scalar lumps[11];
  evaluate_lumps(parameters, lumps);
  const Complex A_v1 = amplitude[0];
  const Complex conj_A_v1 = std::conj(A_v1);
  const Scalar norm_A_v1 = std::norm(A_v1);
  const Complex A_v2 = amplitude[1];
  const Complex conj_A_v2 = std::conj(A_v2);
  const Scalar norm_A_v2 = std::norm(A_v2);
  const Complex F = forcing[0];
  const Scalar norm_F = std::norm(F);
  derivative[0] = (lumps[0] * -Scalar(1.0) * (A_v1))
       + Complex(Scalar(0), Scalar(1)) * (lumps[1] * Scalar(1.0) / (Scalar(2.0) * omega1) * (A_v1))
       + Complex(Scalar(0), Scalar(1)) * (lumps[2] * Scalar(1.0) / (Scalar(4.0) * omega1) * (A_v1 * norm_F))
       + (lumps[3] * -Scalar(3.0) * omega1_2 / Scalar(2.0) * (norm_A_v1 * A_v1))
       + Complex(Scalar(0), Scalar(1)) * (lumps[4] * Scalar(3.0) / (Scalar(2.0) * omega1) * (norm_A_v1 * A_v1))
       + (lumps[5] * -omega2 / (Scalar(4.0) * omega1) * (conj_A_v2 * F))
       + Complex(Scalar(0), Scalar(1)) * (lumps[6] * -Scalar(1.0) / (Scalar(4.0) * omega1) * (conj_A_v2 * F))
       - Complex(Scalar(0), Scalar(-1.0) / Scalar(1.0) * omega1 + Scalar(-1.0) / Scalar(1.0) * omega2
      + Scalar(1.0) / Scalar(1.0) * excitation_frequency[0]) * A_v1;
  derivative[1] = Complex(Scalar(0), Scalar(1)) * (lumps[6] * -Scalar(1.0) / (Scalar(4.0) * omega2) * (conj_A_v1
      * F))
       + (lumps[7] * -Scalar(1.0) * (A_v2))
       + (lumps[8] * -Scalar(3.0) * omega2_2 / Scalar(2.0) * (norm_A_v2 * A_v2))
       + Complex(Scalar(0), Scalar(1)) * (lumps[9] * Scalar(3.0) / (Scalar(2.0) * omega2) * (norm_A_v2 * A_v2))
       + (lumps[10] * -omega1 / (Scalar(4.0) * omega2) * (conj_A_v1 * F));
}

/// jacobian[i * 4 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const std::complex<Scalar>* amplitude,
    [[maybe_unused]] const std::complex<Scalar>* forcing, Scalar* jacobian) {
  using Complex = std::complex<Scalar>;
  [[maybe_unused]] const Scalar omega1 = parameters[0];
  [[maybe_unused]] const Scalar omega2 = parameters[1];
  const Scalar omega1_2 = omega1 * omega1;
  const Scalar omega2_2 = omega2 * omega2;
  Scalar lumps[11];
  evaluate_lumps(parameters, lumps);
  const Complex A_v1 = amplitude[0];
  const Scalar norm_A_v1 = std::norm(A_v1);
  const Complex A_v2 = amplitude[1];
  const Scalar norm_A_v2 = std::norm(A_v2);
  const Complex F = forcing[0];
  const Scalar norm_F = std::norm(F);
  for (std::size_t i = 0; i < 16; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = (lumps[0] * -Scalar(1.0) * (Complex(Scalar(1.0))))
      
      + Complex(Scalar(0), Scalar(1)) * (lumps[1] * Scalar(1.0) / (Scalar(2.0) * omega1) * (Complex(Scalar(1.0))))
       + Complex(Scalar(0), Scalar(1)) * (lumps[2] * Scalar(1.0) / (Scalar(4.0) * omega1) * (norm_F))
       + (lumps[3] * -Scalar(3.0) * omega1_2 / Scalar(2.0) * Scalar(2) * (norm_A_v1))
      
      + Complex(Scalar(0), Scalar(1)) * (lumps[4] * Scalar(3.0) / (Scalar(2.0) * omega1) * Scalar(2)
      * (norm_A_v1))
       - Complex(Scalar(0), Scalar(-1.0) / Scalar(1.0) * omega1 + Scalar(-1.0) / Scalar(1.0) * omega2
      + Scalar(1.0) / Scalar(1.0) * excitation_frequency[0]);
  const Complex conj_by_0_0 = (lumps[3] * -Scalar(3.0) * omega1_2 / Scalar(2.0) * (A_v1 * A_v1))
       + Complex(Scalar(0), Scalar(1)) * (lumps[4] * Scalar(3.0) / (Scalar(2.0) * omega1) * (A_v1 * A_v1));
  jacobian[0] = by_0_0.real() + conj_by_0_0.real();
  jacobian[1] = conj_by_0_0.imag() - by_0_0.imag();
  jacobian[4] = by_0_0.imag() + conj_by_0_0.imag();
  jacobian[5] = by_0_0.real() - conj_by_0_0.real();
  const Complex by_0_1 = Complex();
  const Complex conj_by_0_1 = (lumps[5] * -omega2 / (Scalar(4.0) * omega1) * (F))
       + Complex(Scalar(0), Scalar(1)) * (lumps[6] * -Scalar(1.0) / (Scalar(4.0) * omega1) * (F));
  jacobian[2] = by_0_1.real() + conj_by_0_1.real();
  jacobian[3] = conj_by_0_1.imag() - by_0_1.imag();
  jacobian[6] = by_0_1.imag() + conj_by_0_1.imag();
  jacobian[7] = by_0_1.real() - conj_by_0_1.real();
  const Complex by_1_0 = Complex();
  const Complex conj_by_1_0 = Complex(Scalar(0), Scalar(1)) * (lumps[6] * -Scalar(1.0) / (Scalar(4.0) * omega2)
      * (F))
       + (lumps[10] * -omega1 / (Scalar(4.0) * omega2) * (F));
  jacobian[8] = by_1_0.real() + conj_by_1_0.real();
  jacobian[9] = conj_by_1_0.imag() - by_1_0.imag();
  jacobian[12] = by_1_0.imag() + conj_by_1_0.imag();
  jacobian[13] = by_1_0.real() - conj_by_1_0.real();
  const Complex by_1_1 = (lumps[7] * -Scalar(1.0) * (Complex(Scalar(1.0))))
       + (lumps[8] * -Scalar(3.0) * omega2_2 / Scalar(2.0) * Scalar(2) * (norm_A_v2))
      
      + Complex(Scalar(0), Scalar(1)) * (lumps[9] * Scalar(3.0) / (Scalar(2.0) * omega2) * Scalar(2)
      * (norm_A_v2));
  const Complex conj_by_1_1 = (lumps[8] * -Scalar(3.0) * omega2_2 / Scalar(2.0) * (A_v2 * A_v2))
       + Complex(Scalar(0), Scalar(1)) * (lumps[9] * Scalar(3.0) / (Scalar(2.0) * omega2) * (A_v2 * A_v2));
  jacobian[10] = by_1_1.real() + conj_by_1_1.real();
  jacobian[11] = conj_by_1_1.imag() - by_1_1.imag();
  jacobian[14] = by_1_1.imag() + conj_by_1_1.imag();
  jacobian[15] = by_1_1.real() - conj_by_1_1.real();
}

}  // namespace additive_combination

}  // namespace secular::generated::two_mass_lumps
