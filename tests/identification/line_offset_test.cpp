// A steady motion is at the line_frequency that its excitation gives it.
#include "measure/observe/line_offset.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "tests/app/hardening_oscillator.hpp"
#include "tests/identification/virtual_campaign.hpp"

namespace secular {
namespace {

using testing_support::observed;
using testing_support::warns;

constexpr double line_rate = 256, line_frequency = 2 * std::numbers::pi * 20;

// Three windows of 512 samples of a tone whose phase gains `turn` in each, beside its second harmonic and a
// constant.
Eigen::MatrixXd windows_of(double turn) {
  const double w = line_frequency / line_rate + turn / 512;
  Eigen::MatrixXd windows(512, 3);
  for (Eigen::Index i = 0; i < windows.size(); ++i) {
    const auto t = static_cast<double>(i);
    windows(i % 512, i / 512) = 3 + std::cos(w * t + 0.3) + 0.2 * std::cos(2 * w * t);
  }
  return windows;
}

TEST(LineOffset, IsThePhaseThatALineGains) {
  for (const double turn : {-30.0, -6.0, -0.5, 0.0, 0.1, 0.49, 3.0, 25.0}) {
    const LineOffset line = line_offset(windows_of(turn), line_rate, line_frequency, 0.15);
    EXPECT_NEAR(line.turn, turn, 0.02 + 0.01 * std::abs(turn));
    // Of a Hann window's line, sin(x/2)/(x/2)/(1 - (x/2pi)^2) in amplitude.
    const double half = 0.5 * line.turn, bins = line.turn / (2 * std::numbers::pi);
    if (std::abs(bins) > 0.01 && std::abs(bins) < 0.9) {
      EXPECT_NEAR(line.gain, std::pow(half / std::sin(half) * (1 - bins * bins), 2) - 1, 0.01 + 0.05 * line.gain);
    }
  }
}

// Hum beside the motion, near or far, weaker or stronger: whether more than 1 % is lost is decided as without it.
TEST(LineOffset, AStrongerToneBesideALineIsNotItsMotion) {
  for (const double own : {0.0, 3.0})
    for (const double bins : {3.3, -5.0, 9.5})
      for (const double strength : {0.3, 2.0, 4.0}) {
        Eigen::MatrixXd windows = windows_of(own);
        const double w = line_frequency / line_rate + 2 * std::numbers::pi * bins / 512;
        for (Eigen::Index i = 0; i < windows.size(); ++i)
          windows(i % 512, i / 512) += strength * std::cos(w * static_cast<double>(i) + 1);
        const LineOffset line = line_offset(windows, line_rate, line_frequency, 0.15);
        EXPECT_EQ(lost_by_turn(line.turn) > 0.01, own > 0)
            << own << ' ' << bins << ' ' << strength << ' ' << line.turn;
      }
}

TEST(LineOffset, WhatATurnLosesIsTheMeanOfTurnedPhases) {
  for (const double turn : {0.0, 0.5, 3.0, 20.0}) {
    std::complex<double> mean = 0;
    for (int i = 0; i < 10000; ++i) mean += std::polar(1e-4, turn * ((i + 0.5) / 10000 - 0.5));
    EXPECT_NEAR(lost_by_turn(turn), 1 - std::abs(mean), 1e-6);
  }
}

// One dwell of 8 s.
SimulatedCampaign hardening_dwell(std::uint64_t seed) {
  return testing_support::oscillator_campaign(
      std::string(testing_support::hardening_oscillator) +
          "[[dwell]]\nfrequencies_hz = [20.2]\namplitudes = [0.2]\nsettle_s = 12.0\nensembles = 4\nensemble_s = "
          "2.0\n",
      seed);
}

ObservationSet primary_of(const SimulatedCampaign& made) {
  const CompiledModel& model = *generated::find_compiled_model("duffing");
  return observed(made, model, case_named(model, "primary"));
}

// Every `period`th row of the response twice, to the record's length.
void double_rows(std::vector<double>& samples, std::size_t period) {
  std::vector<double> rows;
  for (std::size_t i = 0; rows.size() < samples.size(); ++i) {
    rows.push_back(samples[i]);
    if (i % period == 7) rows.push_back(samples[i]);
  }
  rows.resize(samples.size());
  samples = rows;
}

TEST(LineOffset, ADwellWhoseResponseIsAtAnotherFrequencyIsLeftOut) {
  const SimulatedCampaign made = hardening_dwell(5);
  EXPECT_EQ(primary_of(made).observations.size(), 4U);
  for (const unsigned period : {50U, 80U, 120U}) {
    SimulatedCampaign doubled = made;
    double_rows(doubled.samples[0].channels[1], period);
    const ObservationSet set = primary_of(doubled);
    EXPECT_TRUE(set.observations.empty()) << period;
    EXPECT_TRUE(warns(set.warnings, "that the excitation gives it")) << period;
  }
}

// A late start of one channel turns phases and leaves frequencies; so does hum, as long as it is weaker.
TEST(LineOffset, LateAndNoisyDwellsStay) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SimulatedCampaign made = hardening_dwell(seed);
    std::vector<double>& tip = made.samples[0].channels[1];
    tip.erase(tip.begin(), tip.begin() + 9);
    tip.insert(tip.end(), 9, 0.0);
    for (std::size_t i = 0; i < tip.size(); ++i)  // a tenth of the motion's size, and noise as large as it is
      tip[i] += std::cos(2 * std::numbers::pi * 21.1 / line_rate * static_cast<double>(i)) +
                10 * std::sin(static_cast<double>((i + 1) * (i + seed) * 7919 % 100003));
    EXPECT_EQ(primary_of(made).observations.size(), 4U) << seed;
  }
}

}  // namespace
}  // namespace secular
