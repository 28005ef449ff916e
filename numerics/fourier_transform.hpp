#pragma once

#include <Eigen/Core>

namespace secular {

// Discrete Fourier transforms X(k) = sum over n of x(n) exp(-2 pi i k n / N), without a factor. Any length;
// quickest where it has no prime factors above 5. Each thread keeps its plans: to make one costs more than to use
// it.

/// Lines 0 ... N/2 of real samples.
Eigen::VectorXcd half_spectrum(const Eigen::Ref<const Eigen::VectorXd>& samples);

/// All N lines of complex samples.
Eigen::VectorXcd whole_spectrum(const Eigen::Ref<const Eigen::VectorXcd>& samples);

/// The real samples, an even number N of them or one, whose lines 0 ... N/2 are these: undoes half_spectrum().
Eigen::VectorXd samples_of(const Eigen::Ref<const Eigen::VectorXcd>& half_spectrum);

}  // namespace secular
