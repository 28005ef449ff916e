#pragma once

#include <Eigen/Core>
#include <complex>

#include "measure/signal/decomposition.hpp"

namespace secular {

/// Displacement from an acceleration component, thesis section 6.4: division by the square of the complex circular
/// frequency, growth + i frequency (1/s); -1/frequency^2 for a steady tone.
std::complex<double> displacement_of(std::complex<double> acceleration, double frequency, double growth = 0);

/// One circular component of a decomposed acceleration as half of the peak (the coefficient of exp(i frequency t)),
/// in displacement, with the covariance of its real and imaginary part; the frequency's own uncertainty and its
/// correlation with the amplitude are carried through where the decomposition was refined (else covariance is
/// empty).
struct DisplacementComponent {
  std::complex<double> value;  ///< unit of the acceleration times s^2
  Eigen::MatrixXd covariance;  ///< 2 x 2, real and imaginary part
};
DisplacementComponent displacement_component(const Decomposition& acceleration, std::size_t pole,
                                             Eigen::Index channel);

}  // namespace secular
