#pragma once

#include <Eigen/Core>
#include <complex>

namespace secular {

/// rad/s: |lambda| of the pole lambda = -zeta omega + i omega sqrt(1 - zeta^2), Eq. (2.8).
inline double natural_frequency(std::complex<double> pole) {
  return std::abs(pole);
}

/// zeta of Eq. (2.8); negative where the motion grows.
inline double damping_ratio(std::complex<double> pole) {
  return -pole.real() / std::abs(pole);
}

/// Whether the receptance 1/(omega_0^2 - omega^2 + 2 i zeta omega_0 omega) has a peak, at omega_0 sqrt(1 - 2
/// zeta^2): |zeta| < 1/sqrt(2), that is |Re pole| < Im pole. Without one a motion is no resonance.
inline bool has_peak(std::complex<double> pole) {
  return std::abs(pole.real()) < pole.imag();
}

}  // namespace secular
