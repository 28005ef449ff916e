#include "diagnose/evidence/saturation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace secular {
namespace {

// E f(noise) by the trapezoidal rule over ten standard deviations either side.
template <class Function>
double mean_over_noise(double sd, const Function& f) {
  constexpr int half = 20000;
  double sum = 0, weights = 0;
  for (int i = -half; i <= half; ++i) {
    const double z = 10.0 * i / half, weight = std::exp(-0.5 * z * z);
    sum += weight * f(sd * z);
    weights += weight;
  }
  return sum / weights;
}

TEST(Saturation, ReadingIsTheMeanOfCutNoise) {
  for (const double noise : {0.02, 0.3, 2.0})
    for (const double value : {0.0, 0.4, 0.95, 1.0, 1.2, -1.05, -3.0}) {
      const double mean = mean_over_noise(noise, [&](double n) { return std::clamp(value + n, -1.0, 1.0); });
      EXPECT_NEAR(saturated(value, 1, noise), mean, 1e-7) << value << " " << noise;
    }
}

TEST(Saturation, WithoutNoiseItIsAPlainCut) {
  for (const double value : {-2.0, -1.0, 0.3, 1.0, 1.5}) EXPECT_EQ(saturated(value, 1, 0), std::clamp(value, -1.0, 1.0));
}

TEST(Saturation, FundamentalIsThatOfTheCutSinusoid) {
  for (const double noise : {0.0, 0.05, 0.4})
    for (const double half : {0.3, 0.52, 0.7, 2.0}) {
      std::complex<double> sum = 0;
      constexpr int points = 4096;
      for (int i = 0; i < points; ++i) {
        const double angle = 2 * std::numbers::pi * i / points;
        sum += saturated(2 * half * std::cos(angle), 1, noise) * std::polar(1.0 / points, -angle);
      }
      // A round corner is averaged over 128 points a turn.
      EXPECT_NEAR(saturated_fundamental(half, 1, noise), sum.real(), noise > 0 ? 2e-5 : 1e-6) << half << " " << noise;
    }
}

TEST(Saturation, FundamentalTendsToThatOfASquareWave) {
  EXPECT_NEAR(2 * saturated_fundamental(1e4, 1, 0), 4 / std::numbers::pi, 1e-6);
}

TEST(Saturation, UndoingACutBringsTheAmplitudeBack) {
  for (const double noise : {0.0, 0.05, 0.4})
    for (const double half : {0.3, 0.52, 0.7, 2.0})
      EXPECT_NEAR(unsaturated_amplitude(saturated_fundamental(half, 1, noise), 1, noise), half, 1e-9 * half);
  EXPECT_EQ(unsaturated_amplitude(0.7, 1, 0), 50);  // more than a square wave shows
}

TEST(Saturation, ScalesWithTheUnitOfTheChannel) {
  EXPECT_DOUBLE_EQ(saturated(950, 1000, 40), 1000 * saturated(0.95, 1, 0.04));
  EXPECT_NEAR(unsaturated_amplitude(480, 1000, 40), 1000 * unsaturated_amplitude(0.48, 1, 0.04), 1e-9);
}

}  // namespace
}  // namespace secular
