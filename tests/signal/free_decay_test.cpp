// Where a free decay begins.
#include "measure/signal/free_decay.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace secular {
namespace {

Eigen::VectorXd decay(double noise, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Eigen::VectorXd x(4096);
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const double t = static_cast<double>(i) / 256;
    x(i) = std::exp(-0.4 * t) * std::cos(2 * std::numbers::pi * 12 * t) + noise * normal(random);
  }
  return x;
}

TEST(DecayStart, IsFoundWithItsFrequency) {
  const auto start = find_decay_start(decay(1e-3, 1), 256);
  ASSERT_TRUE(start);
  EXPECT_LT(start->sample, 64);
  EXPECT_NEAR(start->frequency, 2 * std::numbers::pi * 12, 0.02 * 2 * std::numbers::pi * 12);
}

// A motion that excites itself grows: a decay backwards, from the first sample on.
TEST(DecayStart, OfAGrowingMotionIsTheRecordsStart) {
  for (const double noise : {0.0, 1e-3}) {
    const Eigen::VectorXd growing = decay(noise, 1).reverse();
    const auto start = find_decay_start(growing, 256);
    ASSERT_TRUE(start) << noise;
    EXPECT_EQ(start->sample, 0);
    EXPECT_NEAR(start->frequency, 2 * std::numbers::pi * 12, 0.02 * 2 * std::numbers::pi * 12);
  }
}

// Of motion that keeps its size any turn may be the largest: one of the last two, too.
TEST(DecayStart, OfAGrowthOntoASteadySwingIsTheRecordsStart) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    Eigen::VectorXd x(4096);
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const double turns = static_cast<double>(i) / 21;
      x(i) = std::tanh(turns / 60) * (1 + 1e-4 * turns) * std::cos(2 * std::numbers::pi * turns) +
             2e-3 * normal(random);
    }
    const auto start = find_decay_start(x, 256);
    ASSERT_TRUE(start) << seed;
    EXPECT_EQ(start->sample, 0) << seed;
  }
}

// A pendulum that is filmed for a few seconds; a damper that stops the motion within a few turns.
TEST(DecayStart, IsFoundInFewTurns) {
  const auto motion = [](double turns, double ratio, unsigned seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    Eigen::VectorXd x(static_cast<Eigen::Index>(160 * turns));
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(i) / 160;
      x(i) = std::exp(-ratio * angle) * std::cos(angle) + 2e-3 * normal(random);
    }
    return x;
  };
  for (unsigned seed = 1; seed <= 10; ++seed)
    for (const auto& [turns, ratio] : {std::pair{3.2, 0.005}, {2.9, 0.03}, {3.7, 0.0}, {6.3, 0.0}, {12.0, 0.12}}) {
      const auto start = find_decay_start(motion(turns, ratio, seed), 160);
      ASSERT_TRUE(start) << turns << ' ' << ratio << ' ' << seed;
      EXPECT_LT(start->sample, 160) << turns << ' ' << ratio << ' ' << seed;
      // A start: within half the bandwidth.
      EXPECT_NEAR(start->frequency / (2 * std::numbers::pi), 1, 0.02 + ratio)
          << turns << ' ' << ratio << ' ' << seed;
    }
}

// Up to three harmonics below half the sample rate, with noise of a twentieth as well.
TEST(DecayStart, IsFoundWithFewSamplesATurn) {
  for (const double per_turn : {6.5, 7.7, 9.3, 14.0})
    for (unsigned seed = 1; seed <= 10; ++seed) {
      std::mt19937_64 random(seed);
      std::normal_distribution<double> normal;
      Eigen::VectorXd x(2048);
      for (Eigen::Index i = 0; i < x.size(); ++i) {
        const double turns = static_cast<double>(i) / per_turn;
        x(i) = std::exp(-0.02 * turns) * std::cos(2 * std::numbers::pi * turns) + 0.05 * normal(random);
      }
      const auto start = find_decay_start(x, 1);
      ASSERT_TRUE(start) << per_turn << ' ' << seed;
      // Of 16 samples, with growth and sweep unknown: 1.5 % sd (0.4 % is the Cramer-Rao bound without them).
      EXPECT_NEAR(start->frequency * per_turn / (2 * std::numbers::pi), 1, 0.06) << per_turn << ' ' << seed;
    }
}

// Noise crosses any level at every other sample: no start, and no failure, whatever the draw.
TEST(DecayStart, OfNoiseIsNoneOrAnywhere) {
  for (unsigned seed = 1; seed <= 40; ++seed)
    EXPECT_NO_THROW(find_decay_start(decay(0.5 * seed, seed), 256)) << seed;
}

}  // namespace
}  // namespace secular
