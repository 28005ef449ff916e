#pragma once

#include <Eigen/Core>

namespace secular {

/// Complex exponential algorithm (least-squares Prony), thesis Eqs. (4.14)-(4.19): frequency of one tone, rad/s.
/// Its polynomial is biased by noise.
double complex_exponential_frequency(const Eigen::VectorXd& samples, double sample_rate_hz);

/// Pisarenko's harmonic decomposition: frequency of one stationary tone, rad/s, from the eigenvector of the
/// smallest eigenvalue of the Toeplitz matrix of autocorrelations.
double pisarenko_frequency(const Eigen::VectorXd& samples, double sample_rate_hz);

}  // namespace secular
