#pragma once

#include <cmath>
#include <complex>

namespace secular {

/// The pole of Eq. (2.8) from natural frequency (rad/s) and damping ratio below one.
inline std::complex<double> pole_of(double frequency, double damping) {
  return {-damping * frequency, frequency * std::sqrt(1 - damping * damping)};
}

}  // namespace secular
