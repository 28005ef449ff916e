#include "numerics/fourier_transform.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;
using Eigen::VectorXd;

// The sum itself.
VectorXcd by_definition(const VectorXcd& samples) {
  const Index n = samples.size();
  VectorXcd lines = VectorXcd::Zero(n);
  for (Index k = 0; k < n; ++k)
    for (Index i = 0; i < n; ++i)
      lines(k) += samples(i) *
                  std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(k * i % n) / static_cast<double>(n));
  return lines;
}

VectorXcd random_samples(Index n) {
  std::mt19937_64 random(71);
  std::normal_distribution<double> normal;
  VectorXcd samples(n);
  for (std::complex<double>& sample : samples) sample = {normal(random), normal(random)};
  return samples;
}

TEST(FourierTransform, IsTheSumOfItsDefinition) {
  for (const Index n : {1, 2, 3, 4, 6, 7, 12, 60, 61, 64}) {
    const VectorXcd samples = random_samples(n);
    EXPECT_LT((whole_spectrum(samples) - by_definition(samples)).norm(), 1e-12 * static_cast<double>(n)) << n;
    const VectorXd real = samples.real();
    const VectorXcd half = half_spectrum(real);
    ASSERT_EQ(half.size(), n / 2 + 1);
    EXPECT_LT((half - by_definition(real).head(half.size())).norm(), 1e-12 * static_cast<double>(n)) << n;
  }
}

TEST(FourierTransform, OfHalfASpectrumGivesTheSamplesBack) {
  for (const Index n : {1, 2, 4, 6, 14, 60, 122}) {
    const VectorXd samples = random_samples(n).real();
    EXPECT_LT((samples_of(half_spectrum(samples)) - samples).norm(), 1e-13 * static_cast<double>(n)) << n;
  }
}

}  // namespace
}  // namespace secular
