// Steadiness of dwells: false alarms of the test, and what it sees.
#include "diagnose/evidence/nonstationarity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "diagnose/thresholds.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

class Dwells {
 public:
  explicit Dwells(unsigned seed) : random_(seed) {}

  // One dwell whose amplitude drifts along a straight line, under noise of standard deviation 1, and swells by
  // `wave`.
  Nonstationarity one(double wave) {
    Eigen::VectorXcd amplitude(ensembles);
    Eigen::MatrixXcd noise(ensembles, 8);
    for (Index e = 0; e < ensembles; ++e) {
      const auto t = static_cast<double>(e);
      amplitude(e) =
          Complex(300, -200) + Complex(3, 5) * t + wave * std::sin(2 * std::numbers::pi * t / 2.25) + draw();
      for (Index f = 0; f < noise.cols(); ++f) noise(e, f) = draw();
    }
    return nonstationarity_of(amplitude, noise);
  }

  std::vector<Nonstationarity> several(std::size_t count, double wave) {
    std::vector<Nonstationarity> all;
    for (std::size_t d = 0; d < count; ++d) {
      all.push_back(one(wave));
      all.back().record = d;
    }
    return all;
  }

 private:
  static constexpr Index ensembles = 6;
  Complex draw() {
    const double real = normal_(random_);
    return {real, normal_(random_)};
  }
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
};

TEST(Nonstationarity, ProbabilityOfOneDwellIsUniformUnderNoise) {
  Dwells dwells(3);
  constexpr int draws = 4000;
  int below_a_tenth = 0, below_a_half = 0;
  for (int i = 0; i < draws; ++i) {
    // Of one dwell alone both tests are the same one, and their number is paid for.
    const double p = 0.5 * test_nonstationarity({dwells.one(0)}).p_value;
    below_a_tenth += p < 0.1;
    below_a_half += p < 0.49;  // half of what is cut off at one
  }
  const auto sd = [&](double share) { return std::sqrt(draws * share * (1 - share)); };
  EXPECT_NEAR(below_a_tenth, 0.1 * draws, 3.5 * sd(0.1));
  EXPECT_NEAR(below_a_half, 0.49 * draws, 3.5 * sd(0.49));
}

TEST(Nonstationarity, ManyDwellsAlarmNoMoreOftenThanStated) {
  Dwells dwells(4);
  constexpr int draws = 1000;
  int alarms = 0;
  for (int i = 0; i < draws; ++i) alarms += test_nonstationarity(dwells.several(40, 0)).p_value < 0.05;
  EXPECT_LT(alarms, 0.05 * draws + 3.5 * std::sqrt(draws * 0.05 * 0.95));
  EXPECT_GT(alarms, 0.015 * draws);  // 0.025 to 0.05 for two tests that depend on one another
}

TEST(Nonstationarity, AWaveOfTheNoisesSizeIsSeenInManyDwellsAndALargeOneInASingleOne) {
  Dwells dwells(5);
  EXPECT_LT(test_nonstationarity(dwells.several(40, 1.5)).p_value, 1e-6);
  std::vector<Nonstationarity> all = dwells.several(40, 0);
  const std::size_t disturbed = 17;
  all[disturbed] = dwells.one(8);
  all[disturbed].record = disturbed;
  const NonstationarityTest test = test_nonstationarity(all);
  EXPECT_LT(test.p_value, 1e-6);
  EXPECT_EQ(test.record, disturbed);
}

Eigen::MatrixXcd unit_noise() {
  std::mt19937_64 random(6);
  std::normal_distribution<double> normal;
  return Eigen::MatrixXcd::NullaryExpr(6, 8, [&] {
    const double real = normal(random);
    return Complex(real, normal(random));
  });
}

// A steady motion is approached along a spiral: z^n and conj(z)^n at ensemble n.
TEST(Nonstationarity, WhatDiesOutIsNoUnsteadiness) {
  for (const Complex z : {Complex(0.5, 0), Complex(0.4, 0.3), Complex(-0.2, 0.5)}) {
    Eigen::VectorXcd amplitude(6);
    for (Index n = 0; n < amplitude.size(); ++n) {
      const Complex power = std::pow(z, static_cast<double>(n));
      amplitude(n) = Complex(300, -200) + Complex(80, 30) * power + Complex(-20, 50) * std::conj(power);
    }
    const Nonstationarity nonstationarity = nonstationarity_of(amplitude, unit_noise());
    EXPECT_LT(test_nonstationarity({nonstationarity}).p_value, diagnose_thresholds().unsteady_alarm) << z;
    EXPECT_TRUE(nonstationarity.dies_out) << z;
  }
}

TEST(Nonstationarity, WavesDoNotDieOut) {
  for (const double period : {2.25, 2.6, 3.0, 4.0})
    for (const double phase : {0.0, 0.7, 1.4, 2.1}) {
      Eigen::VectorXcd amplitude(6);
      for (Index n = 0; n < amplitude.size(); ++n)
        amplitude(n) = Complex(300, -200) +
                       Complex(40, 20) * std::sin(2 * std::numbers::pi * static_cast<double>(n) / period + phase);
      const Nonstationarity nonstationarity = nonstationarity_of(amplitude, unit_noise());
      EXPECT_LT(test_nonstationarity({nonstationarity}).p_value, diagnose_thresholds().unsteady_alarm)
          << period << ' ' << phase;
      EXPECT_FALSE(nonstationarity.dies_out) << period << ' ' << phase;
    }
}

TEST(Nonstationarity, TooFewEnsemblesSayNothing) {
  EXPECT_EQ(test_nonstationarity({}).p_value, 1);
  EXPECT_EQ(
      test_nonstationarity({nonstationarity_of(Eigen::VectorXcd::Ones(2), Eigen::MatrixXcd::Ones(2, 8))}).p_value,
      1);
  EXPECT_EQ(test_nonstationarity({nonstationarity_of(Eigen::VectorXcd::Ones(6), Eigen::MatrixXcd(6, 0))}).p_value,
            1);
}

}  // namespace
}  // namespace secular
