#include "diagnose/evidence/noise_levels.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/signal/gaussian.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr Index series_length = 4000;

VectorXd noise_and_a_law(double sd, std::uint64_t seed) {
  VectorXd values = sd * testing_support::Gaussian(seed).vector(series_length);
  for (Index i = 0; i < series_length; ++i) values(i) += 50 * std::cos(1e-2 * static_cast<double>(i));
  return values;
}

// Standard deviations by 4000 values are good to 2 %.
TEST(NoiseLevels, NoSmoothLawIsRoughOrWhite) {
  const VectorXd values = noise_and_a_law(0.3, 1);
  EXPECT_NEAR(roughness({values.begin(), values.end()}), 0.3, 0.03);
  EXPECT_NEAR(std::sqrt(white_variance(values, series_length, {})), 0.3, 0.02);
}

TEST(NoiseLevels, OneWildValueIsNotRough) {
  VectorXd values = noise_and_a_law(0.3, 2);
  values(series_length / 2) = 1e4;
  EXPECT_NEAR(roughness({values.begin(), values.end()}), 0.3, 0.03);
}

// Of two channels one behind the other; nothing is seen across.
TEST(NoiseLevels, SilentSamplesTakeNothingFromTheVariance) {
  VectorXd errors(2 * series_length);
  errors << testing_support::Gaussian(3).vector(series_length),
      (testing_support::Gaussian(4).vector(series_length).array() + 1e6).matrix();
  EXPECT_NEAR(white_variance(errors, series_length, {}), 1, 0.06);
  std::vector<Index> silent;
  for (Index i = 0; i < series_length / 2; ++i) silent.push_back(i);
  errors.tail(series_length).array() -= 1e6;
  for (const Index i : silent) errors(i) = errors(series_length + i) = 0;
  EXPECT_NEAR(white_variance(errors, series_length, silent), 1, 0.09);
}

TEST(NoiseLevels, AQuarterIsBelowTheLowerQuartile) {
  EXPECT_EQ(lower_quartile({8, 1, 6, 3, 5, 2, 7, 4}), 3);
}

TEST(NoiseLevels, AreNeverZero) {
  EXPECT_EQ(white_level({0, 0}), 1e-3);
  EXPECT_EQ(white_level({1, 7}), 2);
}

}  // namespace
}  // namespace secular
