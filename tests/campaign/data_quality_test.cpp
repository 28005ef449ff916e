#include "measure/data/data_quality.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>
#include <random>

#include "measure/data/clipping.hpp"
#include "measure/data/inspection.hpp"
#include "measure/data/jitter.hpp"
#include "measure/data/noise_floor.hpp"
#include "measure/data/resolution.hpp"
#include "measure/data/watched_reader.hpp"
#include "measure/formats/data_file.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

using Samples = std::vector<double>;

Samples sine(std::size_t count, double per_period, double amplitude = 1) {
  Samples samples(count);
  for (std::size_t i = 0; i < count; ++i)
    samples[i] = amplitude * std::sin(2 * std::numbers::pi * static_cast<double>(i) / per_period + 0.3);
  return samples;
}

Samples quantised(Samples samples, double quantum) {
  for (double& x : samples) x = std::round(x / quantum) * quantum;
  return samples;
}

Samples limited(Samples samples, double limit) {
  for (double& x : samples) x = std::clamp(x, -limit, limit);
  return samples;
}

// Unit normal numbers by Box and Muller: the same on every machine.
Samples noise(std::size_t count, double sd, unsigned seed = 11) {
  std::mt19937_64 random(seed);
  const auto uniform = [&] { return (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53; };
  Samples samples(count);
  for (double& x : samples)
    x = sd * std::sqrt(-2 * std::log(uniform())) * std::cos(2 * std::numbers::pi * uniform());
  return samples;
}

Samples sum(Samples a, const Samples& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
  return a;
}

bool has(const ChannelQuality& quality, const std::string& kind) {
  return std::any_of(quality.faults.begin(), quality.faults.end(),
                     [&](const DataFault& f) { return f.kind == kind; });
}

Clipping find_clipping(std::span<const double> samples) {
  return values_of(samples).clipping;
}

TEST(Clipping, FindsLimitedSignals) {
  for (const double per_period : {40.0, 100.3, 1234.5})
    for (const double limit : {0.5, 0.8, 0.95}) {
      const Samples samples = limited(sine(20000, per_period), limit);
      const Clipping clipping = find_clipping(samples);
      const auto periods = static_cast<std::size_t>(20000 / per_period);
      EXPECT_GE(clipping.runs_high + clipping.runs_low, periods) << per_period << " " << limit;
      const auto stuck =
          std::count_if(samples.begin(), samples.end(), [&](double x) { return std::abs(x) == limit; });
      EXPECT_LE(clipping.samples, static_cast<std::size_t>(stuck));
    }
}

TEST(Clipping, FindsLimitsOfAConverterAndOfASingleKnock) {
  EXPECT_TRUE(find_clipping(limited(quantised(sine(20000, 100.3), 1.0 / 2048), 0.9)).found());
  EXPECT_TRUE(find_clipping(limited(sum(sine(20000, 100.3), noise(20000, 0.01)), 0.8)).found());
  Samples knock(2000, 0.0);
  for (std::size_t i = 0; i < 40; ++i) knock[500 + i] = std::sin(std::numbers::pi * static_cast<double>(i) / 40);
  EXPECT_FALSE(find_clipping(knock).found());
  EXPECT_EQ(find_clipping(limited(knock, 0.7)).runs_high, 1u);
  EXPECT_EQ(find_clipping(limited(knock, 0.7)).runs_low, 0u);
}

TEST(Clipping, FlatTurningPointsOfQuantisedSignalsAreNone) {
  for (const double per_period : {50.0, 317.7, 1000.0, 20000.1})
    for (const double quantum : {0.05, 0.011, 0.003, 0.0004})
      for (const double amplitude : {1.0, 0.987, 1.0173}) {
        const Samples samples = quantised(sine(40000, per_period, amplitude), quantum);
        EXPECT_FALSE(find_clipping(samples).found()) << per_period << " " << quantum << " " << amplitude;
      }
}

// A converter's levels as files hold them, with seven digits: no two differences of levels are the same.
TEST(Clipping, LevelsThatArePrintedRoundedAreNoLimit) {
  for (const double per_period : {11.3, 17.77, 29.34})
    for (const double quantum : {0.03320728485892773, 0.0190529366777, 0.0047177})
      for (const double amplitude : {1.0, 1.2918, 0.947}) {
        Samples samples = quantised(sine(6144, per_period, amplitude), quantum);
        for (double& x : samples) x = std::round(x * 1e6) * 1e-6;
        EXPECT_FALSE(find_clipping(samples).found()) << per_period << " " << quantum << " " << amplitude;
        EXPECT_TRUE(find_clipping(limited(samples, 0.5)).found())
            << per_period << " " << quantum << " " << amplitude;
      }
}

TEST(Clipping, APendulumHeldBeforeItsReleaseIsNone) {
  // Lifted within two seconds, held for three, released: quantum 0.025 degrees as of an encoder, 1 kHz.
  Samples angle;
  for (int i = 0; i < 2000; ++i) angle.push_back(57 * std::sin(0.5 * std::numbers::pi * i / 2000));
  for (int i = 0; i < 3000; ++i) angle.push_back(57);
  for (int i = 0; i < 60000; ++i) angle.push_back(57 * std::exp(-2e-5 * i) * std::cos(5.77e-3 * i));
  EXPECT_FALSE(find_clipping(quantised(angle, 0.025)).found());
  // The same when it is lifted at constant speed: it arrives with a slope, but leaves from rest.
  for (int i = 0; i < 2000; ++i) angle[static_cast<std::size_t>(i)] = 57.0 * i / 2000;
  EXPECT_FALSE(find_clipping(quantised(angle, 0.025)).found());
}

TEST(Clipping, SquareWavesRestAndNoiseAreNone) {
  Samples square = sine(5000, 100.3);
  for (double& x : square) x = x > 0 ? 1 : -1;
  EXPECT_FALSE(find_clipping(square).found());
  EXPECT_FALSE(find_clipping(noise(20000, 1)).found());
  // A hammer's force: zero between knocks is rest, its flattened peaks are not.
  Samples force(20000, 0.0);
  for (std::size_t i = 0; i < 20000; ++i)
    if (i % 1000 < 40) force[i] = std::sin(std::numbers::pi * static_cast<double>(i % 1000) / 40);
  EXPECT_FALSE(find_clipping(force).found());
  EXPECT_EQ(find_clipping(limited(force, 0.7)).runs_high, 20u);
  EXPECT_EQ(find_clipping(limited(force, 0.7)).runs_low, 0u);
  EXPECT_FALSE(find_clipping(quantised(noise(20000, 1), 0.01)).found());
  EXPECT_FALSE(find_clipping(Samples(100, 3.0)).found());
  EXPECT_FALSE(find_clipping({}).found());
}

TEST(Clipping, FindsShortRunsTogether) {
  for (const double per_period : {7.3, 12.8, 17.31})
    for (const double limit : {0.85, 0.97}) {
      const Samples exact = limited(sine(2048, per_period), limit);
      const Samples noisy = limited(sum(sine(2048, per_period), noise(2048, 0.003)), limit);
      for (const Samples& samples : {exact, noisy, quantised(exact, 1.0 / 8192), quantised(noisy, 1e-6)}) {
        const Clipping clipping = find_clipping(samples);
        EXPECT_GT(clipping.runs_high, 20u) << per_period << " " << limit;
        EXPECT_GT(clipping.runs_low, 20u) << per_period << " " << limit;
      }
    }
  const Samples once = limited(sum(sine(2048, 12.8), sine(2048, 31.7)), 1.7);  // only where both are high
  EXPECT_TRUE(find_clipping(once).found());
}

TEST(Clipping, PeaksThatSamplingRepeatsAreNone) {
  // In step with the motion or nearly so, round and flattened by harmonics, as exact numbers and in 8 to 14 bits,
  // with noise from none to three quanta: not one false alarm in all.
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform;
  for (int trial = 0; trial < 4000; ++trial) {
    double per_period = std::round(4 * (3 + 20 * uniform(random))) / 4;
    if (trial % 3 != 0) per_period *= 1 + (uniform(random) - 0.5) * std::pow(10, -2 - 4 * uniform(random));
    const double quantum = std::pow(0.5, 7 + trial % 7), scatter = trial % 2 * 3 * uniform(random) * quantum;
    Samples samples = sine(3000, per_period, 0.9 + 0.1 * uniform(random));  // harmonics have four samples a period
    const double second = per_period > 8 ? 0.5 * uniform(random) : 0,
                 third = per_period > 12 ? 0.3 * uniform(random) : 0;
    if (trial % 5 > 1) samples = sum(samples, sine(3000, per_period / 2, second));
    if (trial % 5 > 2) samples = sum(samples, sine(3000, per_period / 3, third));
    if (scatter > 0) samples = sum(samples, noise(3000, scatter));
    if (trial % 11 != 0) samples = quantised(samples, quantum);
    EXPECT_FALSE(find_clipping(samples).found()) << "trial " << trial << ", " << per_period;
  }
}

TEST(Clipping, FindsPeaksThatSamplingRepeatsByTheirNoise) {
  for (const double per_period : {5.0, 8.0, 13.0, 16.0})
    for (const double sd : {1e-3, 1e-2}) {
      const Samples noisy = sum(sine(4096, per_period), noise(4096, sd));
      EXPECT_TRUE(find_clipping(limited(noisy, 0.9)).found()) << per_period << " " << sd;
      EXPECT_TRUE(find_clipping(quantised(limited(noisy, 0.9), 0.1 * sd)).found()) << per_period << " " << sd;
      EXPECT_FALSE(find_clipping(noisy).found()) << per_period << " " << sd;
      EXPECT_FALSE(find_clipping(quantised(noisy, 0.1 * sd)).found()) << per_period << " " << sd;
    }
}

TEST(Clipping, AShortHoldOfAStaircaseIsNone) {
  Samples steps;
  const Samples levels = noise(1000, 1);
  for (const double level : levels) steps.insert(steps.end(), 3, level);
  EXPECT_FALSE(find_clipping(steps).found());
}

TEST(Clipping, FindsTheRecordThatShortRunsHid) {
  const std::filesystem::path path = testing_support::source_folder() / "../shared/faults/clipping_missed/0014.csv";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "../shared/faults is not there";
  const DataFile data = read_data_file(path);
  EXPECT_EQ(find_clipping(data.vector("tip").values).samples, 648u);
  EXPECT_FALSE(find_clipping(data.vector("base").values).found());
}

TEST(Jitter, IsNamedWithWhatItDoesToTheHighestTone) {
  const Samples tones = sum(sum(sine(8192, 32, 1), sine(8192, 5.12, 0.1)), noise(8192, 0.003));
  EXPECT_NEAR(highest_tone_hz({noise(8192, 1), tones, Samples(8192, 1.0)}, 512), 100, 2);
  EXPECT_EQ(highest_tone_hz({noise(8192, 1)}, 512), 256);
  EXPECT_EQ(highest_tone_hz({sine(100, 32)}, 512), 256);
  const std::string text = jitter_text({0, 512, 1e-4}, {tones});  // (2 pi 100 Hz 0.1 ms)^2/2 = 0.2 %
  EXPECT_NE(text.find("by 0.0001 s rms, 5.1 % of the step"), std::string::npos) << text;
  EXPECT_NE(text.find("a tone of 100 Hz, the highest found, loses 0.2 % of its amplitude and gets noise of 6.3 %"),
            std::string::npos)
      << text;
}

TEST(Jitter, OfAFileIsAFault) {
  const std::filesystem::path path =
      testing_support::source_folder() / "../shared/faults/jitter_silent/d15c_jitter20.csv";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "../shared/faults is not there";
  const FileInspection file = inspect_file(path);
  ASSERT_EQ(file.faults.size(), 1u);
  EXPECT_EQ(file.faults[0].kind, "time");
  EXPECT_NE(file.faults[0].text.find("a tone of 20 Hz"), std::string::npos) << file.faults[0].text;
}

// Beside an offset of a sensor, which is one.
TEST(OffsetOfAFile, IsNoneOfAFrequency) {
  const std::filesystem::path path = testing_support::process_folder() / "frequencies.csv";
  std::ofstream file(path);
  file << "f,a\n";
  for (int i = 0; i < 400; ++i) file << 20 + 0.01 * i * i << ',' << 9 + std::sin(0.31 * i) << '\n';
  file.close();
  const FileInspection inspection = inspect_file(path);
  EXPECT_TRUE(inspection.variables.at(0).quality.value().faults.empty());
  ASSERT_EQ(inspection.variables.at(1).quality.value().faults.size(), 1u);
  EXPECT_EQ(inspection.variables[1].quality->faults[0].kind, "offset");
}

// Numbers that stand for none are named with their count and what to write; levels are those of the others.
TEST(FillValuesOfAFile, AreNamed) {
  const std::filesystem::path path = testing_support::process_folder() / "fill_values.csv";
  const auto inspected = [&](const std::string& mark, bool time) {
    std::ofstream file(path);
    file << (time ? "t,a\n" : "b,a\n");
    for (int i = 0; i < 400; ++i)
      file << 0.01 * i << ',' << (i % 100 == 37 ? mark : std::to_string(3 * std::sin(0.31 * i))) << '\n';
    file.close();
    return inspect_file(path).variables.at(1).quality.value();
  };
  for (const std::string mark : {"-9999", "1e20", "9.96921e36", "-999", "-99999.9", "32767", "-2147483648", "1e30"})
    for (const bool time : {true, false}) {
      const ChannelQuality quality = inspected(mark, time);
      ASSERT_EQ(quality.faults.size(), 1u) << mark;
      EXPECT_EQ(quality.faults[0].kind, "fill_value") << mark;
      EXPECT_NE(quality.faults[0].text.find("4 of 400 samples"), std::string::npos) << quality.faults[0].text;
      EXPECT_NE(quality.faults[0].text.find("first sample 38"), std::string::npos) << quality.faults[0].text;
      EXPECT_NE(quality.faults[0].text.find("write nan"), std::string::npos) << quality.faults[0].text;
      EXPECT_NEAR(quality.rms, 3 / std::sqrt(2.0), 0.05) << mark;
      EXPECT_NEAR(quality.peak, 3, 0.05) << mark;
    }
  // A value of the motion, one that is large by itself, and nines within the range of the others.
  for (const std::string mark : {"2.999", "17.3", "0.999", "-2000"})
    for (const DataFault& fault : inspected(mark, true).faults) EXPECT_NE(fault.kind, "fill_value") << mark;
}

TEST(NoiseFloor, IsThatOfWhiteNoiseUnderALine) {
  for (const double sd : {1e-5, 1e-3, 0.2}) {
    const std::optional<double> level = noise_floor(sum(sine(60000, 37.7, 3), noise(60000, sd)));
    ASSERT_TRUE(level);
    EXPECT_NEAR(*level, sd, 0.05 * sd);
  }
}

TEST(NoiseFloor, IgnoresASingleKnockAndALineInTheUpperHalf) {
  Samples samples = sum(noise(60000, 0.01), sine(60000, 2.7, 5));
  samples[3000] += 100;
  const std::optional<double> level = noise_floor(samples);
  ASSERT_TRUE(level);
  EXPECT_NEAR(*level, 0.01, 0.05 * 0.01);
  EXPECT_FALSE(noise_floor(noise(200, 1)));
}

// The least of eight levels that scatter by 6 % would be 8 % of the variance below all of them.
TEST(NoiseFloor, OfShortRecordsIsNotTheirQuietestPart) {
  double sum_of_squares = 0;
  constexpr int records = 60;
  for (unsigned seed = 1; seed <= records; ++seed) {
    const double level = noise_floor(noise(12000, 0.3, seed)).value();
    sum_of_squares += level * level;
  }
  EXPECT_NEAR(sum_of_squares / records, 0.09, 0.01 * 0.09);  // 24 bands a record: 3 sd are 0.8 %
}

TEST(NoiseFloor, OfBroadbandExcitationIsKnownWhereItIsFlat) {
  const Samples floor = noise(20000, 0.02);
  // What has passed ten times through a first-order filter falls by 60 dB within the upper half.
  Samples narrow = noise(20000, 1, 12);
  for (int pass = 0; pass < 10; ++pass)
    for (std::size_t i = 1; i < narrow.size(); ++i) narrow[i] = 0.5 * narrow[i] + 0.5 * narrow[i - 1];
  const std::optional<double> level = flat_noise_floor(sum(floor, narrow));
  ASSERT_TRUE(level);
  EXPECT_NEAR(*level, 0.02, 0.05 * 0.02);
  EXPECT_FALSE(flat_noise_floor(floor)) << "white excitation";
}

TEST(Resolution, IsTheQuantumOfAnEncoder) {
  const auto value_grid = [](const Samples& samples) { return grid_of_sorted(in_order(samples)); };
  const double quantum = 0.025 * std::numbers::pi / 180;
  const ValueGrid grid = value_grid(quantised(sine(50000, 333.3), quantum));
  ASSERT_TRUE(grid.step);
  EXPECT_NEAR(*grid.step, quantum, 1e-6 * quantum);
  EXPECT_FALSE(value_grid(sine(50000, 333.3)).step);
  EXPECT_FALSE(value_grid(noise(50000, 1)).step);
  EXPECT_EQ(value_grid(Samples(5, 2.0)).levels, 1u);
}

TEST(ChannelQuality, LevelsOfASine) {
  const ChannelQuality quality = check_channel(sine(10000, 100, 2));
  EXPECT_NEAR(quality.mean, 0, 1e-12);
  EXPECT_NEAR(quality.rms, std::sqrt(2), 1e-12);
  EXPECT_NEAR(quality.peak, 2, 1e-3);
  EXPECT_EQ(quality.samples, 10000u);
  EXPECT_TRUE(quality.faults.empty());
}

TEST(ChannelQuality, NamesFaults) {
  Samples samples = sine(10000, 100);
  samples[70] = samples[71] = std::numeric_limits<double>::quiet_NaN();
  const ChannelQuality missing = check_channel(samples);
  EXPECT_EQ(missing.missing, 2u);
  EXPECT_NEAR(missing.rms, std::sqrt(0.5), 1e-3);
  ASSERT_TRUE(has(missing, "missing"));
  EXPECT_NE(missing.faults.front().text.find("sample 71"), std::string::npos);
  EXPECT_TRUE(has(check_channel(Samples(100, 0.0)), "constant"));
  EXPECT_TRUE(check_channel(Samples(1, 1000.0)).faults.empty());  // a rate among the variables of a file
  EXPECT_TRUE(has(check_channel(limited(sine(10000, 100.3), 0.7)), "clipping"));
  EXPECT_TRUE(has(check_channel(quantised(sine(10000, 100.3), 0.1)), "coarse"));
  EXPECT_TRUE(has(check_channel(sum(sine(10000, 100.3), Samples(10000, 0.2))), "offset"));
  EXPECT_FALSE(has(check_channel(sum(sine(10000, 100.3), Samples(10000, 0.01))), "offset"));
  EXPECT_TRUE(has(check_channel(Samples(3, std::nan(""))), "missing"));
  EXPECT_TRUE(has(check_channel(sine(10000, 100.3, 1e31)), "range"));
  EXPECT_TRUE(has(check_channel(sine(10000, 100.3, 1e-31)), "range"));
  EXPECT_TRUE(check_channel(sine(10000, 100.3, 1e-29)).faults.empty());
  EXPECT_EQ(check_channel({}).samples, 0u);
}

// A free decay has a mean that is no offset: less than one swing is left over.
TEST(ChannelQuality, AFreeDecayHasNoOffset) {
  Samples samples = sine(50000, 700.7);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] *= std::exp(-1e-3 * static_cast<double>(i));
  EXPECT_TRUE(check_channel(samples).faults.empty());
}

ChannelQuality measured(const std::string& file, const std::string& variable) {
  return check_channel(
      read_data_file(testing_support::source_folder() / "../shared/data" / file).vector(variable).values);
}

class MeasuredQuality : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(testing_support::source_folder() / "../shared/data"))
      GTEST_SKIP() << "../shared/data is not there";
  }
};

TEST_F(MeasuredQuality, ThePendulumIsFaultlessAndOnItsEncodersGrid) {
  const ChannelQuality theta = measured("pendulum/cdip_pend_data.mat", "theta");
  EXPECT_TRUE(theta.faults.empty());
  ASSERT_TRUE(theta.resolution);
  EXPECT_NEAR(*theta.resolution * 180 / std::numbers::pi, 0.025, 1e-6);
}

TEST_F(MeasuredQuality, TheSilverboxInputHasAnOffset) {
  const ChannelQuality input = measured("silverbox/SNLS80mV.csv", "V1");
  ASSERT_EQ(input.faults.size(), 1u);
  EXPECT_EQ(input.faults.front().kind, "offset");
  EXPECT_NEAR(input.mean, 6.2e-3, 0.1e-3);
  EXPECT_TRUE(measured("silverbox/SNLS80mV.csv", "V2").faults.empty());
}

TEST_F(MeasuredQuality, TheBeamIsFaultless) {
  for (const char* const channel : {"HIdata.acc1", "HIdata.acc2", "HIdata.acc3"})
    EXPECT_TRUE(measured("brake_reuss_beam/HammerImpact.mat", channel).faults.empty()) << channel;
}

}  // namespace
}  // namespace secular
