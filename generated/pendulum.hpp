// Model pendulum: generated code, never edited by hand.
// Source: Rigid pendulum; damping laws as in A. H. Nayfeh and D. T. Mook, Nonlinear Oscillations, section 3.3
// Equation of motion: 0 = omega0^2*theta + alpha3*theta^3 + alpha5*theta^5 + 2*mu1*D(theta) +
// mu2*D(theta)*abs(D(theta)) + D2(theta) + fc*sgn(D(theta))
// Case free: free vibration, multiple scales to eps^2. Valid near that resonance for small amplitudes; what is
// left out is of order eps^3.
// Units: SI; frequencies in rad/s; amplitudes as in estimator/compiled_model.hpp.
// Made by: secular generate pendulum
#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

#include "estimator/compiled_model.hpp"
#include "estimator/integer_power.hpp"

namespace secular::generated::pendulum {

/// Accelerations of the full equations of motion, solved from the state-dependent mass matrix.
/// 0 = omega0^2*theta + alpha3*theta^3 + alpha5*theta^5 + 2*mu1*D(theta) + mu2*D(theta)*abs(D(theta)) +
/// D2(theta) + fc*sgn(D(theta))
/// parameters: [0] omega0, [1] alpha3, [2] alpha5, [3] mu1, [4] mu2, [5] fc. displacement, velocity,
/// acceleration: 1 values. 1 operations.
template <class Scalar>
void accelerations(const Scalar* parameters, [[maybe_unused]] const ExcitationSample* excitation,
                   [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,
                   Scalar* acceleration) {
  const Scalar omega0 = parameters[0];
  const Scalar alpha3 = parameters[1];
  const Scalar alpha5 = parameters[2];
  const Scalar mu1 = parameters[3];
  const Scalar mu2 = parameters[4];
  const Scalar fc = parameters[5];
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar mass = Scalar(1.0);
  const Scalar force = omega0_2 * displacement[0] + alpha3 * displacement[0] * displacement[0] * displacement[0]
      + alpha5 * displacement[0] * displacement[0] * displacement[0] * displacement[0] * displacement[0]
      + Scalar(2.0) * mu1 * velocity[0] + mu2 * velocity[0] * std::abs(velocity[0])
      + fc * (Scalar(velocity[0] > Scalar(0)) - Scalar(velocity[0] < Scalar(0)));
  acceleration[0] = -force / mass;
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

/// Regressor rows of the modulation of theta: target = sum of columns[j][i] * lump_j.
/// (rate - i*omega0)*A_theta = -1/(omega0*Pi)*fc*A_theta*abs(A_theta)^-1 - mu1*A_theta -
/// 8*omega0/(3*Pi)*mu2*A_theta*abs(A_theta) + 3/(2*omega0)*i*alpha3*A_theta^2*conj(A_theta) +
/// 5/omega0*i*beta5*A_theta^3*conj(A_theta)^2
/// 5 columns; per observation 9 complex products, 0 complex sums.
inline void columns_0(const ObservationBatch& data, std::complex<double>* const* columns) {
  using Scalar = double;
  using Complex = std::complex<double>;
  const Scalar omega0 = data.natural_frequency[0];
  const Scalar pi = std::numbers::pi;
  const Scalar factor_0_0 = -Scalar(1.0) / (omega0 * pi);
  const Scalar factor_1_0 = -Scalar(1.0);
  const Scalar factor_2_0 = -Scalar(8.0) * omega0 / (Scalar(3.0) * pi);
  const Scalar factor_3_0 = Scalar(3.0) / (Scalar(2.0) * omega0);
  const Scalar factor_4_0 = Scalar(5.0) / omega0;
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_theta = data.amplitude[0][i];
    const Scalar norm_A_theta = std::norm(A_theta);
    const Scalar abs_A_theta = std::abs(A_theta);
    const Complex unit_A_theta = abs_A_theta > Scalar(0) ? A_theta / abs_A_theta : Complex();
    columns[0][i] = factor_0_0 * (unit_A_theta);  // fc
    columns[1][i] = factor_1_0 * (A_theta);  // mu1
    columns[2][i] = factor_2_0 * (abs_A_theta * A_theta);  // mu2
    columns[3][i] = Complex(Scalar(0), Scalar(1)) * factor_3_0 * (norm_A_theta * A_theta);  // alpha3
    // beta5
    columns[4][i] = Complex(Scalar(0), Scalar(1)) * factor_4_0 * (norm_A_theta * norm_A_theta * A_theta);
  }
}

/// Regressor rows of the harmonic 3*omega0 of theta: target = sum of columns[j][i] * lump_j.
/// amplitude of exp(i*(3*omega0)*t) in theta = 1/(12*omega0^2*Pi)*i*fc*A_theta^3*abs(A_theta)^-3 -
/// 2/(15*Pi)*i*mu2*A_theta^3*abs(A_theta)^-1 + 1/(8*omega0^2)*alpha3*A_theta^3 +
/// harmonic_re_theta_A_theta4_conjA_theta*A_theta^4*conj(A_theta)
/// 4 columns; per observation 13 complex products, 0 complex sums.
inline void columns_1(const ObservationBatch& data, std::complex<double>* const* columns) {
  using Scalar = double;
  using Complex = std::complex<double>;
  const Scalar omega0 = data.natural_frequency[0];
  const Scalar pi = std::numbers::pi;
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar factor_0_0 = Scalar(1.0) / (Scalar(12.0) * omega0_2 * pi);
  const Scalar factor_1_0 = -Scalar(2.0) / (Scalar(15.0) * pi);
  const Scalar factor_2_0 = Scalar(1.0) / (Scalar(8.0) * omega0_2);
  const Scalar factor_3_0 = Scalar(1.0);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_theta = data.amplitude[0][i];
    const Scalar norm_A_theta = std::norm(A_theta);
    const Scalar abs_A_theta = std::abs(A_theta);
    const Complex unit_A_theta = abs_A_theta > Scalar(0) ? A_theta / abs_A_theta : Complex();
    // fc
    columns[0][i] = Complex(Scalar(0), Scalar(1)) * factor_0_0 * (unit_A_theta * unit_A_theta * unit_A_theta);
    columns[1][i] = Complex(Scalar(0), Scalar(1)) * factor_1_0 * (unit_A_theta * A_theta * A_theta);  // mu2
    columns[2][i] = factor_2_0 * (A_theta * A_theta * A_theta);  // alpha3
    // harmonic_re_theta_A_theta4_conjA_theta
    columns[3][i] = factor_3_0 * (norm_A_theta * A_theta * A_theta * A_theta);
  }
}

/// Regressor rows of the harmonic 5*omega0 of theta: target = sum of columns[j][i] * lump_j.
/// amplitude of exp(i*(5*omega0)*t) in theta = 1/(60*omega0^2*Pi)*i*fc*A_theta^5*abs(A_theta)^-5 -
/// 2/(315*Pi)*i*mu2*A_theta^5*abs(A_theta)^-3 + harmonic_re_theta_A_theta5*A_theta^5
/// 3 columns; per observation 7 complex products, 0 complex sums.
inline void columns_2(const ObservationBatch& data, std::complex<double>* const* columns) {
  using Scalar = double;
  using Complex = std::complex<double>;
  const Scalar omega0 = data.natural_frequency[0];
  const Scalar pi = std::numbers::pi;
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar factor_0_0 = Scalar(1.0) / (Scalar(60.0) * omega0_2 * pi);
  const Scalar factor_1_0 = -Scalar(2.0) / (Scalar(315.0) * pi);
  const Scalar factor_2_0 = Scalar(1.0);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_theta = data.amplitude[0][i];
    const Scalar abs_A_theta = std::abs(A_theta);
    const Complex unit_A_theta = abs_A_theta > Scalar(0) ? A_theta / abs_A_theta : Complex();
    columns[0][i] = Complex(Scalar(0), Scalar(1)) * factor_0_0 * (integer_power(unit_A_theta, 5));  // fc
    // mu2
    columns[1][i] = Complex(Scalar(0), Scalar(1)) * factor_1_0 * (unit_A_theta * unit_A_theta * unit_A_theta
        * A_theta * A_theta);
    columns[2][i] = factor_2_0 * (integer_power(A_theta, 5));  // harmonic_re_theta_A_theta5
  }
}

/// Regressor rows of the harmonic 7*omega0 of theta: target = sum of columns[j][i] * lump_j.
/// amplitude of exp(i*(7*omega0)*t) in theta = 1/(168*omega0^2*Pi)*i*fc*A_theta^7*abs(A_theta)^-7 -
/// 1/(945*Pi)*i*mu2*A_theta^7*abs(A_theta)^-5
/// 2 columns; per observation 4 complex products, 0 complex sums.
inline void columns_3(const ObservationBatch& data, std::complex<double>* const* columns) {
  using Scalar = double;
  using Complex = std::complex<double>;
  const Scalar omega0 = data.natural_frequency[0];
  const Scalar pi = std::numbers::pi;
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar factor_0_0 = Scalar(1.0) / (Scalar(168.0) * omega0_2 * pi);
  const Scalar factor_1_0 = -Scalar(1.0) / (Scalar(945.0) * pi);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_theta = data.amplitude[0][i];
    const Scalar abs_A_theta = std::abs(A_theta);
    const Complex unit_A_theta = abs_A_theta > Scalar(0) ? A_theta / abs_A_theta : Complex();
    columns[0][i] = Complex(Scalar(0), Scalar(1)) * factor_0_0 * (integer_power(unit_A_theta, 7));  // fc
    // mu2
    columns[1][i] = Complex(Scalar(0), Scalar(1)) * factor_1_0 * (integer_power(unit_A_theta, 5) * A_theta
        * A_theta);
  }
}

/// Regressor rows of the harmonic 9*omega0 of theta: target = sum of columns[j][i] * lump_j.
/// amplitude of exp(i*(9*omega0)*t) in theta = 1/(360*omega0^2*Pi)*i*fc*A_theta^9*abs(A_theta)^-9 -
/// 1/(3465*Pi)*i*mu2*A_theta^9*abs(A_theta)^-7
/// 2 columns; per observation 4 complex products, 0 complex sums.
inline void columns_4(const ObservationBatch& data, std::complex<double>* const* columns) {
  using Scalar = double;
  using Complex = std::complex<double>;
  const Scalar omega0 = data.natural_frequency[0];
  const Scalar pi = std::numbers::pi;
  const Scalar omega0_2 = omega0 * omega0;
  const Scalar factor_0_0 = Scalar(1.0) / (Scalar(360.0) * omega0_2 * pi);
  const Scalar factor_1_0 = -Scalar(1.0) / (Scalar(3465.0) * pi);
  for (std::size_t i = 0; i < data.count; ++i) {
    const Complex A_theta = data.amplitude[0][i];
    const Scalar abs_A_theta = std::abs(A_theta);
    const Complex unit_A_theta = abs_A_theta > Scalar(0) ? A_theta / abs_A_theta : Complex();
    columns[0][i] = Complex(Scalar(0), Scalar(1)) * factor_0_0 * (integer_power(unit_A_theta, 9));  // fc
    // mu2
    columns[1][i] = Complex(Scalar(0), Scalar(1)) * factor_1_0 * (integer_power(unit_A_theta, 7) * A_theta
        * A_theta);
  }
}

/// dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state.
/// dB_theta/dt + i*(w_theta - omega0)*B_theta = -1/(omega0*Pi)*fc*A_theta*abs(A_theta)^-1 - mu1*A_theta -
/// 8*omega0/(3*Pi)*mu2*A_theta*abs(A_theta) + 3/(2*omega0)*i*alpha3*A_theta^2*conj(A_theta) +
/// 5/omega0*i*beta5*A_theta^3*conj(A_theta)^2 with A = B in that frame
template <class Scalar>
void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
                const std::complex<Scalar>* amplitude,
                [[maybe_unused]] const std::complex<Scalar>* forcing, std::complex<Scalar>* derivative) {
  using Complex = std::complex<Scalar>;
  const Scalar omega0 = parameters[0];
  const Scalar pi = std::numbers::pi_v<Scalar>;
  Scalar lumps[7];
  evaluate_lumps(parameters, lumps);
  const Complex A_theta = amplitude[0];
  const Scalar norm_A_theta = std::norm(A_theta);
  const Scalar abs_A_theta = std::abs(A_theta);
  const Complex unit_A_theta = abs_A_theta > Scalar(0) ? A_theta / abs_A_theta : Complex();
  derivative[0] = (lumps[0] * -Scalar(1.0) / (omega0 * pi) * (unit_A_theta))
       + (lumps[1] * -Scalar(1.0) * (A_theta))
       + (lumps[2] * -Scalar(8.0) * omega0 / (Scalar(3.0) * pi) * (abs_A_theta * A_theta))
      
      + Complex(Scalar(0), Scalar(1)) * (lumps[3] * Scalar(3.0) / (Scalar(2.0) * omega0) * (norm_A_theta
      * A_theta))
      
      + Complex(Scalar(0), Scalar(1)) * (lumps[4] * Scalar(5.0) / omega0 * (norm_A_theta * norm_A_theta
      * A_theta));
}

/// jacobian[i * 2 + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what `modulation`
/// computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), d/dRe(B_j) = d/dB_j +
/// d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero amplitude; a term that has no
/// derivative there counts as zero.
template <class Scalar>
void modulation_jacobian(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,
    [[maybe_unused]] const std::complex<Scalar>* amplitude,
    [[maybe_unused]] const std::complex<Scalar>* forcing, Scalar* jacobian) {
  using Complex = std::complex<Scalar>;
  [[maybe_unused]] const Scalar omega0 = parameters[0];
  const Scalar pi = std::numbers::pi_v<Scalar>;
  Scalar lumps[7];
  evaluate_lumps(parameters, lumps);
  const Complex A_theta = amplitude[0];
  const Scalar norm_A_theta = std::norm(A_theta);
  const Scalar abs_A_theta = std::abs(A_theta);
  const Complex unit_A_theta = abs_A_theta > Scalar(0) ? A_theta / abs_A_theta : Complex();
  const Scalar inverse_abs_A_theta = abs_A_theta > Scalar(0) ? Scalar(1) / abs_A_theta : Scalar(0);
  for (std::size_t i = 0; i < 4; ++i) jacobian[i] = Scalar(0.0);
  const Complex by_0_0 = (lumps[0] * -Scalar(1.0) / (omega0 * pi) * Scalar(0.5) * (inverse_abs_A_theta))
       + (lumps[1] * -Scalar(1.0) * (Complex(Scalar(1.0))))
       + (lumps[2] * -Scalar(8.0) * omega0 / (Scalar(3.0) * pi) * Scalar(1.5) * (abs_A_theta))
      
      + Complex(Scalar(0), Scalar(1)) * (lumps[3] * Scalar(3.0) / (Scalar(2.0) * omega0) * Scalar(2)
      * (norm_A_theta))
      
      + Complex(Scalar(0), Scalar(1)) * (lumps[4] * Scalar(5.0) / omega0 * Scalar(3) * (norm_A_theta
      * norm_A_theta));
  const Complex conj_by_0_0 = (lumps[0] * -Scalar(1.0) / (omega0 * pi) * Scalar(-0.5) * (inverse_abs_A_theta
      * unit_A_theta * unit_A_theta))
       + (lumps[2] * -Scalar(8.0) * omega0 / (Scalar(3.0) * pi) * Scalar(0.5) * (unit_A_theta * A_theta))
       + Complex(Scalar(0), Scalar(1)) * (lumps[3] * Scalar(3.0) / (Scalar(2.0) * omega0) * (A_theta * A_theta))
      
      + Complex(Scalar(0), Scalar(1)) * (lumps[4] * Scalar(5.0) / omega0 * Scalar(2) * (norm_A_theta * A_theta
      * A_theta));
  jacobian[0] = by_0_0.real() + conj_by_0_0.real();
  jacobian[1] = conj_by_0_0.imag() - by_0_0.imag();
  jacobian[2] = by_0_0.imag() + conj_by_0_0.imag();
  jacobian[3] = by_0_0.real() - conj_by_0_0.real();
}

}  // namespace free

}  // namespace secular::generated::pendulum
