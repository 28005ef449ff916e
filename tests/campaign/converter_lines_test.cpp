// What a converter's steps add to the lines of a dwell, and that it is taken out.
#include "measure/disturbances/converter_lines.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "measure/signal/tone_fit.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

constexpr double rate = 256, step = 0.3, origin = -0.7;
constexpr std::size_t samples = 1024;

double rounded(double x) {
  return origin + step * std::round((x - origin) / step);
}

// By its definition: the mean over noise of where x + noise is rounded to.
double mean_by_sum(double x, double sd) {
  double mean = rounded(x - 10 * sd) - step;
  const double lowest = mean;
  for (double edge = lowest + step / 2; edge < x + 10 * sd; edge += step)
    mean += step * 0.5 * std::erfc((edge - x) / (std::sqrt(2.0) * sd));
  return mean - x;
}

TEST(ConverterLines, MeanOfRoundingIsThatOfItsDefinition) {
  for (const double noise : {0.1, 0.2, 0.4, 0.7})
    for (double x = -1; x < 1; x += 0.0137)
      EXPECT_NEAR(MeanRounding({step, origin, 0}, noise * step).at(x), mean_by_sum(x, noise * step), 1e-6 * step)
          << x << ", " << noise;
}

struct Draw {
  std::vector<double> values;
  std::complex<double> truth;
  double frequency_hz = 0;
};

// A tone and a harmonic of it with offset and noise, in steps, through the converter.
Draw drawn(std::mt19937_64& random, double amplitude, double noise) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  Draw draw;
  draw.frequency_hz = 8 + 19 * uniform(random);
  const double phase = two_pi * uniform(random), offset = uniform(random);
  draw.truth = 0.5 * amplitude * step * std::polar(1.0, phase);
  for (std::size_t i = 0; i < samples; ++i) {
    const double angle =
        two_pi * draw.frequency_hz * (static_cast<double>(i) - 0.5 * static_cast<double>(samples - 1)) / rate;
    draw.values.push_back(rounded(step * (offset + amplitude * std::cos(angle + phase) +
                                          0.05 * amplitude * std::cos(2 * angle + 1) + noise * normal(random))));
  }
  return draw;
}

// Error of the tone that a fit finds, over the standard deviation that it says.
double error_of(const Draw& draw, const std::vector<double>& values) {
  const double tones[] = {two_pi * draw.frequency_hz, 2 * two_pi * draw.frequency_hz};
  const KnownFrequencyFit fit =
      known_frequency_components(Eigen::VectorXd::Map(values.data(), samples), rate, tones, true);
  return std::abs(fit.amplitude(0, 0) - draw.truth) / (std::sqrt(2.0) * fit.amplitude_sd(0, 0));
}

// With noise of a tenth of a step rounding moves a line by more than its error bar; without its mean the error is
// what the bar says, to 0.15 (three standard deviations of 200 draws of two squares each are 0.11).
TEST(ConverterLines, TonesAreRightWithoutTheMeanOfRounding) {
  std::mt19937_64 random(3);
  for (const double noise : {0.1, 0.2})
    for (const double amplitude : {12.0, 25.0, 60.0}) {
      double before = 0, after = 0;
      constexpr int draws = 200;
      for (int draw = 0; draw < draws; ++draw) {
        const Draw one = drawn(random, amplitude, noise);
        std::vector<double> values = one.values;
        const std::vector<double> lines = {one.frequency_hz, 2 * one.frequency_hz};
        take_out_rounding(values, rate, lines, {step, origin, noise * step}, samples, {});
        before += std::pow(error_of(one, one.values), 2) / draws;
        after += std::pow(error_of(one, values), 2) / draws;
      }
      EXPECT_NEAR(std::sqrt(after), 1, 0.15) << amplitude << ", " << noise << ", before " << std::sqrt(before);
      if (noise < 0.15 && amplitude < 20) {  // what rounding adds falls with the root of the amplitude
        EXPECT_GT(std::sqrt(before), 1.15) << amplitude;
      }
    }
}

// Printed decimals make the smallest gap low; over many steps that is more than a step.
TEST(ConverterLines, TheStepIsRightThroughPrintedDecimals) {
  std::mt19937_64 random(6);
  std::normal_distribution<double> normal;
  for (const int digits : {5, 6, 7})
    for (const double bits : {10.0, 12.0, 14.0}) {
      const double q = 20 / std::pow(2, bits);
      std::vector<double> values;
      for (int i = 0; i < 6144; ++i) {
        const double x = q * std::round((7.3 * std::cos(0.3 * i) + 0.12 * q * normal(random)) / q);
        values.push_back(std::stod(fmt::format("{:.{}g}", x, digits)));
      }
      const ChannelValues known = values_of(values);
      SearchedChannel channel;
      channel.samples = values;
      channel.values = &known;
      const std::optional<ConverterLattice> lattice = repeating_lattice(channel, 1e-5);
      if (!known.grid.step) continue;  // too few decimals for that many bits
      ASSERT_TRUE(lattice) << digits << ", " << bits;
      EXPECT_NEAR(lattice->step * std::round(14.6 / q), q * std::round(14.6 / q), 0.1 * q)
          << digits << ", " << bits;
    }
}

// Printed coordinates far from their origin: no tolerance may make steps of their own out of them.
TEST(ConverterLines, AnOffsetOfAMillionRangesMakesNoLattice) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  for (const double offset : {1.0, 1e3, 5e6}) {
    std::vector<double> values;
    for (int i = 0; i < 4096; ++i) values.push_back(offset + 0.3 * std::cos(0.3 * i) + 1e-3 * normal(random));
    EXPECT_FALSE(values_of(values).grid.step) << offset;
    EXPECT_FALSE(values_of(values).clipping.found()) << offset;
  }
}

TEST(ConverterLines, NoiseOfAStepHidesThem) {
  std::mt19937_64 random(4);
  const Draw one = drawn(random, 20, 1.2);
  std::vector<double> values = one.values;
  take_out_rounding(values, rate, {one.frequency_hz, 2 * one.frequency_hz}, {step, origin, 1.2 * step}, samples,
                    {});
  EXPECT_EQ(values, one.values);
}

// Of blocks the last one overlaps the one before: every sample is treated once.
TEST(ConverterLines, BlocksCoverTheRecordOnce) {
  std::mt19937_64 random(9);
  const Draw one = drawn(random, 20, 0.15);
  const std::vector<double> lines = {one.frequency_hz, 2 * one.frequency_hz};
  std::vector<double> whole = one.values, parts = one.values;
  take_out_rounding(whole, rate, lines, {step, origin, 0.15 * step}, samples, {});
  take_out_rounding(parts, rate, lines, {step, origin, 0.15 * step}, 300, {});
  double difference = 0, moved = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    difference += std::pow(parts[i] - whole[i], 2);
    moved += std::pow(whole[i] - one.values[i], 2);
  }
  EXPECT_LT(difference, 0.2 * moved);
}

TEST(ConverterLines, SamplesThatNoConverterRoundedStay) {
  std::mt19937_64 random(5);
  const Draw one = drawn(random, 20, 0.1);
  std::vector<double> values = one.values;
  take_out_rounding(values, rate, {one.frequency_hz, 2 * one.frequency_hz}, {step, origin, 0.1 * step}, samples,
                    {7, 500});
  EXPECT_EQ(values[7], one.values[7]);
  EXPECT_EQ(values[500], one.values[500]);
  EXPECT_NE(values[8], one.values[8]);
}

}  // namespace
}  // namespace secular
