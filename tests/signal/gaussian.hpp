#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace secular::testing_support {

/// Reproducible standard normal numbers (Box-Muller on a 64-bit Mersenne twister).
class Gaussian {
 public:
  explicit Gaussian(std::uint64_t seed) : random_(seed) {}
  double operator()() {
    const double u = (static_cast<double>(random_() >> 11) + 0.5) * 0x1p-53;
    const double v = (static_cast<double>(random_() >> 11) + 0.5) * 0x1p-53;
    return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * v);
  }
  Eigen::VectorXd vector(Eigen::Index size) {
    Eigen::VectorXd values(size);
    for (double& x : values) x = (*this)();
    return values;
  }

 private:
  std::mt19937_64 random_;
};

/// Times of `n` samples, s.
inline Eigen::VectorXd sampled_times(Eigen::Index n, double rate) {
  return Eigen::VectorXd::LinSpaced(n, 0, static_cast<double>(n - 1)) / rate;
}

}  // namespace secular::testing_support
