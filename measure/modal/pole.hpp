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

}  // namespace secular
