// Missing samples of tones in noise, against what they were.
#include "numerics/fill_gaps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace secular {
namespace {

std::vector<double> tones(std::size_t samples, double noise, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> x(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(i);
    x[i] = std::cos(0.0431 * turn) + 0.2 * std::sin(0.1293 * turn) +
           0.3 * std::exp(-1e-3 * static_cast<double>(i)) * std::cos(0.217 * turn) + noise * normal(random);
  }
  return x;
}

TEST(FillGaps, SingleSamplesAreFoundToTheNoise) {
  const double noise = 0.01;
  const std::vector<double> x = tones(6000, noise, 1);
  std::vector<double> holed = x;
  std::vector<std::size_t> missing;
  for (std::size_t i = 50; i < x.size(); i += 97) {
    missing.push_back(i);
    holed[i] = 1e6;  // whatever stands there counts for nothing
  }
  EXPECT_TRUE(fill_gaps(holed, missing).empty());
  double squares = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double off = holed[i] - x[i];
    if (std::find(missing.begin(), missing.end(), i) == missing.end())
      EXPECT_EQ(off, 0);
    else
      squares += off * off / static_cast<double>(missing.size());
  }
  // What was there had noise of its own; the sample found has less than that much again.
  EXPECT_LT(std::sqrt(squares), 1.5 * noise);
}

TEST(FillGaps, ARunOfSixteenIsFoundAndOneOfSeventeenIsLeft) {
  const std::vector<double> x = tones(4000, 1e-4, 2);
  std::vector<std::size_t> missing;
  for (std::size_t i = 1000; i < 1016; ++i) missing.push_back(i);
  std::vector<double> holed = x;
  for (const std::size_t i : missing) holed[i] = 0;
  EXPECT_TRUE(fill_gaps(holed, missing).empty());
  for (const std::size_t i : missing) EXPECT_NEAR(holed[i], x[i], 5e-3) << i;
  missing.push_back(1016);
  std::vector<double> longer = x;
  EXPECT_EQ(fill_gaps(longer, missing), missing);
  EXPECT_EQ(longer, x);
}

// Near an end one side tells it alone: the error of prediction is the noise's, and that of the samples before it.
TEST(FillGaps, TheEndsOfARecord) {
  const double noise = 0.01;
  for (const std::size_t place :
       {std::size_t{0}, std::size_t{2}, std::size_t{8}, std::size_t{28}, std::size_t{2990}, std::size_t{2999}}) {
    double squares = 0;
    constexpr unsigned draws = 40;
    for (unsigned seed = 0; seed < draws; ++seed) {
      const std::vector<double> x = tones(3000, noise, 100 + seed);
      std::vector<double> holed = x;
      holed[place] = 7;
      EXPECT_TRUE(fill_gaps(holed, {place}).empty());
      squares += (holed[place] - x[place]) * (holed[place] - x[place]) / draws;
    }
    EXPECT_LT(std::sqrt(squares), 2 * noise) << place;
  }
}

TEST(FillGaps, WhatIsTooShortOrHangsTogetherTooLongIsLeft) {
  std::vector<double> many = tones(6000, 0.01, 5);
  std::vector<std::size_t> missing;
  for (std::size_t i = 3000; i < 5000; i += 20) missing.push_back(i);
  EXPECT_EQ(fill_gaps(many, missing), missing);
  std::vector<double> brief(60, 1.0);
  EXPECT_EQ(fill_gaps(brief, {30}), std::vector<std::size_t>{30});
}

// A scale of the samples changes nothing but the scale.
TEST(FillGaps, IsLinear) {
  std::vector<double> x = tones(3000, 1e-2, 4), scaled = x;
  for (double& value : scaled) value *= 1024;
  const std::vector<std::size_t> missing = {700, 701, 1500};
  fill_gaps(x, missing);
  fill_gaps(scaled, missing);
  for (const std::size_t i : missing) EXPECT_NEAR(scaled[i] / 1024, x[i], 1e-9);
}

}  // namespace
}  // namespace secular
