// Noise beside a motion's frequency, as far as it is more than white.
#include "diagnose/evidence/noise_beside_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace secular {
namespace {

constexpr std::size_t samples_left = 4096;
constexpr double left_sample_s = 0.01, natural = 10;  // rad/s: 63 samples a turn

// What is left of a record: white noise, noise correlated over `time_s`, and a motion of `tone` that dies away.
SampledRest left_of_record(double coloured_sd, double time_s, double tone, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  SampledRest left;
  left.sample_s = left_sample_s;
  const double keeps = std::exp(-left_sample_s / time_s);
  double slow = normal(random);
  for (std::size_t i = 0; i < samples_left; ++i) {
    slow = keeps * slow + std::sqrt(1 - keeps * keeps) * normal(random);
    const double t = static_cast<double>(i) * left_sample_s;
    left.rest.push_back(normal(random) + coloured_sd * slow + tone * std::exp(-0.2 * t) * std::cos(natural * t));
  }
  return left;
}

double mean_noise_beside(double coloured_sd, double time_s, double tone) {
  std::mt19937_64 random(11);
  constexpr int draws = 20;
  double sum = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const std::vector<SampledRest> left{left_of_record(coloured_sd, time_s, tone, random)};
    sum += noise_beside_motion(left, Eigen::VectorXd::Constant(1, natural));
  }
  return sum / draws;
}

TEST(NoiseBesideMotion, OfWhiteNoiseIsHardlyEverSurelyMore) {
  EXPECT_LT(mean_noise_beside(0, 1, 0), 1.02);
}

// First-order noise has the power 2 s^2 T/(h (1 + (w T)^2)) a sample of length h; of 45 lines the median is known
// to a fifth, which is taken off once and a half.
TEST(NoiseBesideMotion, OfColouredNoiseIsItsPowerThere) {
  constexpr double sd = 2, time_s = 0.1, there = 1 + 2 * sd * sd * time_s / left_sample_s / 2;
  const double found = mean_noise_beside(sd, time_s, 0);
  EXPECT_GT(found, 0.4 * there);
  EXPECT_LT(found, there);
}

// What a law leaves is as narrow as the motion.
TEST(NoiseBesideMotion, IsNotWhatALawLeaves) {
  EXPECT_LT(mean_noise_beside(0, 1, 1), 1.1);
}

}  // namespace
}  // namespace secular
