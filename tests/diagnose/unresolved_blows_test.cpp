// What a blow does between its samples: docs/inference.md (42).
#include "diagnose/evidence/unresolved_blows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "diagnose/thresholds.hpp"
#include "tests/changed_thresholds.hpp"

namespace secular {
namespace {

using Eigen::Index;

constexpr double step_s = 1.0 / 512, at_rad_s = 90;
using Signal = std::function<double(double)>;

Segment sampled(const Signal& signal) {
  Segment s;
  s.sample_s = step_s;
  s.excitation.setZero(1, 2 * 400 - 1);
  for (Index i = 0; i < s.excitation.cols(); i += 2)
    s.excitation(0, i) = signal(0.5 * step_s * static_cast<double>(i));
  s.excitation_noise_sd = Eigen::VectorXd::Zero(1);
  return s;
}

Signal half_sine(double begin_s, double width_s) {
  return [=](double t) {
    const double phase = std::numbers::pi * (t - begin_s) / width_s;
    return phase > 0 && phase < std::numbers::pi ? std::sin(phase) : 0;
  };
}

// The sum over the samples against that over a thousand times as many.
double error_of_samples(const Signal& signal) {
  const auto sum = [&](int finer) {
    std::complex<double> all = 0;
    const double step = step_s / finer;
    for (int i = 0; i < 400 * finer; ++i) all += step * signal(i * step) * std::polar(1.0, -at_rad_s * i * step);
    return all;
  };
  return std::abs(sum(1) / sum(1000) - 1.0);
}

TEST(UnresolvedBlows, SharpEdgesAreOffByWhatIsSaid) {
  std::mt19937_64 draw(4);
  std::uniform_real_distribution<double> phase(0, step_s);
  for (const double width_s : {0.009, 0.012, 0.025}) {
    std::vector<Segment> segments;
    double squares = 0;
    for (int blow = 0; blow < 40; ++blow) {
      const Signal signal = half_sine(0.2 + phase(draw), width_s);
      segments.push_back(sampled(signal));
      segments.back().record = segments.size();
      squares += std::pow(error_of_samples(signal), 2) / 40;
    }
    std::vector<const Segment*> all;
    for (const Segment& s : segments) all.push_back(&s);
    const double said = unresolved_share(all, at_rad_s);
    EXPECT_GT(said, 0.7 * std::sqrt(squares)) << width_s;
    EXPECT_LT(said, 2 * std::sqrt(squares)) << width_s;
  }
}

TEST(UnresolvedBlows, BehindAFilterNothingIsOpen) {
  const Segment smooth = sampled([](double t) { return std::exp(-0.5 * std::pow((t - 0.3) / (2.5 * step_s), 2)); });
  EXPECT_LT(unresolved_share({&smooth}, at_rad_s), 1e-5);
}

// An offset of the reading, its noise, and a stretch at rest behind the blow.
TEST(UnresolvedBlows, WhatElseIsInTheReadingIsNoBlow) {
  const Signal blow = half_sine(0.3, 0.012);
  const Segment clean = sampled(blow);
  const Segment dirty = sampled([&](double t) { return blow(t) + 0.03 + 0.003 * std::sin(1.7e5 * t * t); });
  const Segment after = sampled([](double t) { return 0.03 + 0.003 * std::sin(1.3e5 * t * t); });
  EXPECT_NEAR(unresolved_share({&dirty, &after}, at_rad_s), unresolved_share({&clean}, at_rad_s), 1e-3);
  EXPECT_GT(unresolved_share({&clean}, at_rad_s), 3e-3);
}

TEST(UnresolvedBlows, HalfAndTwiceTheShareThatBeginsABlowMoveLittle) {
  const Segment blow = sampled([](double t) {
    return half_sine(0.3, 0.012)(t) + 0.002 * std::exp(-std::abs(t - 0.3) / 0.01) * std::sin(900 * t);
  });
  const double usual = unresolved_share({&blow}, at_rad_s);
  for (const double factor : {0.5, 2.0}) {
    testing_support::ChangedThresholds<DiagnoseThresholds> changed;
    changed->drives_from *= factor;
    EXPECT_NEAR(unresolved_share({&blow}, at_rad_s), usual, 0.05 * usual) << factor;
  }
}

TEST(UnresolvedBlows, WithoutABlowNothingIsOpen) {
  const Segment at_rest = sampled([](double) { return 0; });
  const Segment lasting = sampled([](double t) { return std::cos(at_rad_s * t); });
  EXPECT_EQ(unresolved_share({}, at_rad_s), 0);
  EXPECT_EQ(unresolved_share({&at_rest, &lasting}, at_rad_s), 0);
}

}  // namespace
}  // namespace secular
