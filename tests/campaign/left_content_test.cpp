// Lines and colours of what a model leaves of a record: found where they are, and not in white noise.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "measure/disturbances/left_lines.hpp"
#include "measure/disturbances/noise_colour.hpp"
#include "tests/signal/gaussian.hpp"

namespace secular {
namespace {

constexpr double turn = 2 * std::numbers::pi, rate_hz = 320, level = 1e-3;
constexpr std::size_t count = 1280;

double at(std::size_t i) {
  return static_cast<double>(i) / rate_hz;
}

std::vector<double> motion() {
  std::vector<double> x;
  for (std::size_t i = 0; i < count; ++i) x.push_back(100 * std::exp(-0.75 * at(i)) * std::cos(turn * 10 * at(i)));
  return x;
}

std::vector<double> white(testing_support::Gaussian& random) {
  std::vector<double> x;
  for (std::size_t i = 0; i < count; ++i) x.push_back(random());
  return x;
}

// A binomial law of 200 draws at 1e-3 has more than three once in 600 times; bins and lengths are counted in.
TEST(LeftContent, WhiteNoiseHoldsNeitherLinesNorColour) {
  testing_support::Gaussian random(3);
  int lines = 0, colours = 0;
  for (int draw = 0; draw < 200; ++draw) {
    const std::vector<double> x = white(random);
    lines += find_left_lines(x, motion(), rate_hz, level).empty() ? 0 : 1;
    colours += find_noise_colour(x, motion(), rate_hz, level) ? 1 : 0;
  }
  EXPECT_LE(lines, 3);
  EXPECT_LE(colours, 3);
}

TEST(LeftContent, ASteadyToneAndAFallingOneAreToldApart) {
  testing_support::Gaussian random(4);
  std::vector<double> x = white(random);
  for (std::size_t i = 0; i < count; ++i)
    x[i] += std::cos(turn * 47 * at(i) + 1) + 12 * std::exp(-2 * at(i)) * std::cos(turn * 24.1 * at(i));
  const std::vector<LeftLine> found = find_left_lines(x, motion(), rate_hz, level);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].rate, 0);
  EXPECT_NEAR(found[0].frequency_hz, 47, 0.05);
  EXPECT_NEAR(found[0].amplitude, 1, 0.15);
  // Standard deviations of a falling line of that size are 0.005 Hz, 0.03 1/s and 0.2.
  EXPECT_NEAR(found[1].frequency_hz, 24.1, 0.03);
  EXPECT_NEAR(found[1].rate, 2, 0.2);
  EXPECT_NEAR(found[1].amplitude, 12, 1);
}

// What a missing term makes of a motion is at its multiples.
TEST(LeftContent, AMultipleOfTheMotionIsNoForeignLine) {
  testing_support::Gaussian random(5);
  for (const double order : {1.0, 2.0, 3.0}) {
    std::vector<double> x = white(random);
    for (std::size_t i = 0; i < count; ++i)
      x[i] += 12 * std::exp(-0.75 * order * at(i)) * std::cos(turn * 10 * order * at(i));
    EXPECT_TRUE(find_left_lines(x, motion(), rate_hz, level).empty()) << order;
  }
}

// It lasts while the motion falls, which no power of the motion does: mains at five times a structure's frequency.
TEST(LeftContent, ASteadyToneAtAMultipleOfADecayIsForeign) {
  testing_support::Gaussian random(9);
  for (const double tone_hz : {20.0, 30.3, 50.0}) {
    std::vector<double> x = white(random);
    for (std::size_t i = 0; i < count; ++i) x[i] += std::cos(turn * tone_hz * at(i) + 1);
    const std::vector<LeftLine> found = find_left_lines(x, motion(), rate_hz, level);
    ASSERT_EQ(found.size(), 1U) << tone_hz;
    EXPECT_EQ(found[0].rate, 0) << tone_hz;
    EXPECT_NEAR(found[0].frequency_hz, tone_hz, 0.05) << tone_hz;
  }
}

// However slowly the motion falls, and however little stands out of the noise: a square's fall may be hidden by it,
// and then the line is left to the terms. 1e-3 is asked of half the campaign's probability of one line.
TEST(LeftContent, AProductIsNoForeignLineHoweverSlowlyItFalls) {
  testing_support::Gaussian random(10);
  int lines = 0;
  for (const double rate : {0.02, 0.1, 0.4})
    for (const double order : {2.0, 3.0})
      for (const double size : {1.0, 2.0, 8.0})
        for (int draw = 0; draw < 3; ++draw) {
          std::vector<double> x = white(random), moves = x;
          for (std::size_t i = 0; i < count; ++i) {
            const double falls = std::exp(-rate * at(i)), phase = turn * 10 * at(i) + draw;
            moves[i] = 100 * falls * std::cos(phase) + random();
            x[i] += size * std::pow(falls, order) * std::cos(order * phase + 1);
          }
          lines += find_left_lines(x, moves, rate_hz, level).empty() ? 0 : 1;
        }
  EXPECT_LE(lines, 2);
}

// A resonance of 5 % damping that noise drives over 400 of its turns, its cube, and a tone at three times its
// frequency or in its midst.
TEST(LeftContent, AToneIsForeignWhereNoiseDrivesTheMotion) {
  testing_support::Gaussian random(8);
  constexpr std::size_t samples = 5 * count;
  const double keeps = std::exp(-turn * 20 * 0.05 / rate_hz), advance = turn * 20 / rate_hz;
  int alarms = 0;
  for (int draw = 0; draw < 20; ++draw) {
    std::vector<double> moves(samples), left(samples);
    std::complex<double> state;
    for (std::size_t i = 0; i < samples; ++i) {
      state = keeps * std::polar(1.0, advance) * state + std::complex<double>(random(), random());
      moves[i] = state.real();
      left[i] = random() + 0.001 * std::pow(moves[i], 3);
    }
    alarms += find_left_lines(left, moves, rate_hz, level).empty() ? 0 : 1;
    for (const double tone_hz : {60.0, 20.3}) {
      std::vector<double> with = left;
      for (std::size_t i = 0; i < samples; ++i) with[i] += 2 * std::cos(turn * tone_hz * at(i) + draw);
      const std::vector<LeftLine> found = find_left_lines(with, moves, rate_hz, level);
      const bool is_found = std::any_of(found.begin(), found.end(), [&](const LeftLine& line) {
        return line.rate == 0 && std::abs(line.frequency_hz - tone_hz) < 0.03;
      });
      EXPECT_TRUE(is_found) << draw << ", " << tone_hz << " Hz";
    }
  }
  EXPECT_LE(alarms, 2);  // more once in a thousand times at 0.015, what the parts of a record come to
}

TEST(LeftContent, AColourIsFoundWithItsSizeAndTime) {
  testing_support::Gaussian random(6);
  double variance = 0, time_s = 0, white_variance = 0;
  constexpr int draws = 48;
  for (int draw = 0; draw < draws; ++draw) {
    std::vector<double> x = white(random);
    const double keeps = std::exp(-1 / (rate_hz * 0.05));
    double now = random();
    for (double& value : x) {
      now = keeps * now + std::sqrt(1 - keeps * keeps) * random();
      value += 4 * now;
    }
    const std::optional<NoiseColour> colour = find_noise_colour(x, motion(), rate_hz, level);
    ASSERT_TRUE(colour);
    variance += colour->sd * colour->sd / draws;
    time_s += colour->time_s / draws;
    white_variance += colour->white_sd * colour->white_sd / draws;
  }
  // Half of the spectrum of 80 correlation times tells time and variance to 40 %, white noise to a fourth; means of
  // 48 within four standard deviations of theirs.
  EXPECT_NEAR(variance, 16, 4 * 0.4 * 16 / std::sqrt(draws));
  EXPECT_NEAR(time_s, 0.05, 4 * 0.4 * 0.05 / std::sqrt(draws));
  EXPECT_NEAR(white_variance, 1, 4 * 0.25 / std::sqrt(draws));
}

// What a missing term leaves is larger where the motion is; a sensor's noise is the same everywhere.
TEST(LeftContent, NoiseThatFollowsTheMotionIsToldFromASensors) {
  testing_support::Gaussian random(7);
  const std::vector<double> moves = motion();
  constexpr NoiseColour colour{1, 0.05, 0.2};
  int alarms = 0;
  for (int draw = 0; draw < 200; ++draw) {
    std::vector<double> noise = white(random), following = noise;
    alarms += follows({1, 0.001, 0.2}, noise, moves, rate_hz, level) ? 1 : 0;
    for (std::size_t i = 0; i < count; ++i) following[i] *= std::exp(-0.75 * at(i));
    EXPECT_TRUE(follows(colour, following, moves, rate_hz, level)) << draw;
  }
  EXPECT_LE(alarms, 3);
}

}  // namespace
}  // namespace secular
