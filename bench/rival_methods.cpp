// Methods that are known beside the circular-hyperbolic decomposition, for one tone.
#include "bench/rival_methods.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>

namespace secular {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::VectorXd;

double complex_exponential_frequency(const VectorXd& samples, double sample_rate_hz) {
  const Index rows = samples.size() - 2;
  Eigen::MatrixXd hankel(rows, 3);
  for (Index k = 0; k < 3; ++k) hankel.col(k) = samples.segment(k, rows);
  const Eigen::Vector2d polynomial = -hankel.leftCols(2).colPivHouseholderQr().solve(hankel.col(2));
  // Roots of z^2 + p1 z + p0.
  const double half = -0.5 * polynomial(1);
  const std::complex<double> apart = std::sqrt(std::complex<double>(half * half - polynomial(0)));
  return std::max(std::abs(std::arg(half + apart)), std::abs(std::arg(half - apart))) * sample_rate_hz;
}

double pisarenko_frequency(const VectorXd& samples, double sample_rate_hz) {
  const Index n = samples.size();
  // Unbiased autocorrelations: the biased ones of a tone are those of a tone that fades.
  Matrix3d toeplitz;
  for (Index i = 0; i < 3; ++i)
    for (Index j = 0; j < 3; ++j) {
      const Index k = std::abs(i - j);
      toeplitz(i, j) = samples.head(n - k).dot(samples.tail(n - k)) / static_cast<double>(n - k);
    }
  const Eigen::Vector3d polynomial = Eigen::SelfAdjointEigenSolver<Matrix3d>(toeplitz).eigenvectors().col(0);
  // Its roots are on the unit circle: z + 1/z = 2 cos(w).
  const double twice_cosine = -polynomial(1) / (0.5 * (polynomial(0) + polynomial(2)));
  return std::acos(std::clamp(0.5 * twice_cosine, -1.0, 1.0)) * sample_rate_hz;
}

}  // namespace secular
