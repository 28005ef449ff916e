// Where driven records show modes (docs/inference.md (51)).
#include "measure/observe/driven_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include "measure/observe/natural_frequency_starts.hpp"
#include "measure/thresholds_list.hpp"
#include "numerics/hertz.hpp"
#include "tests/changed_thresholds.hpp"
#include "tests/driven_response.hpp"

namespace secular {
namespace {

using testing_support::driven_response;
using testing_support::DrivenMode;

constexpr double rate = 200, none = std::numeric_limits<double>::quiet_NaN();

Campaign driven_campaign(RecordKind kind, std::size_t records) {
  Campaign campaign;
  campaign.sample_rate_hz = rate;
  campaign.channels = {{"base", ChannelRole::excitation, Quantity::acceleration, "m/s^2", Frame::relative},
                       {"tip", ChannelRole::response, Quantity::displacement, "m", Frame::relative}};
  campaign.records.resize(records);
  for (RecordEntry& entry : campaign.records) entry.kind = kind;
  return campaign;
}

// Broadband records; `beside(i)`: a foreign reading over the response's root mean square.
ModeLines lines_of(
    const std::vector<DrivenMode>& modes, std::size_t records, unsigned seed, const std::vector<double>& nominal_hz,
    const std::function<double(std::size_t)>& beside = [](std::size_t) { return 0.0; }) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  std::vector<Record> all(records);
  for (Record& record : all) {
    record.sample_rate_hz = rate;
    std::vector<double> force(4000);
    for (double& f : force) f = normal(engine);
    std::vector<double> tip = driven_response(force, modes, rate);
    double square = 0;
    for (const double x : tip) square += x * x;
    const double rms = modes.empty() ? 1 : std::sqrt(square / static_cast<double>(tip.size()));
    for (std::size_t i = 0; i < tip.size(); ++i)
      tip[i] += rms * ((modes.empty() ? 1 : 0.01) * normal(engine) + beside(i));
    record.channels = {force, tip};
  }
  std::vector<double> nominal;
  for (const double hz : nominal_hz) nominal.push_back(two_pi * hz);
  return driven_lines(driven_campaign(RecordKind::broadband, records), [&](std::size_t r) { return all[r]; },
                      nominal, {});
}

TEST(DrivenLines, TwoModesAreSeenBesideAForeignTone) {
  const auto hum = [](std::size_t i) { return 0.5 * std::sin(two_pi * 50 * static_cast<double>(i) / rate); };
  for (const double damping : {0.002, 0.01, 0.05}) {
    const ModeLines lines = lines_of({{11, damping}, {31, damping}}, 2, 5, {none, none}, hum);
    EXPECT_EQ(lines.records, 2U);
    ASSERT_EQ(lines.further.size(), 2U) << damping;
    const double low = std::min(lines.further[0], lines.further[1]),
                 high = std::max(lines.further[0], lines.further[1]);
    EXPECT_NEAR(low, two_pi * 11, 0.03 * low);
    EXPECT_NEAR(high, two_pi * 31, 0.03 * high);
  }
}

TEST(DrivenLines, ModesAreLookedForElsewhereOnlyWhereTheyAreDriven) {
  const ModeLines right = lines_of({{11, 0.01}, {31, 0.01}}, 1, 6, {11.3, 30});
  ASSERT_TRUE(right.at_nominal[0] && right.at_nominal[1]);
  EXPECT_TRUE(right.further.empty());
  const ModeLines one_off = lines_of({{11, 0.01}, {31, 0.01}}, 1, 6, {11.3, 22});
  EXPECT_TRUE(one_off.at_nominal[0]);
  EXPECT_FALSE(one_off.at_nominal[1]);
  ASSERT_EQ(one_off.further.size(), 1U);
  EXPECT_NEAR(one_off.further[0], two_pi * 31, two_pi);
  // Half of the rate is 100 Hz.
  const ModeLines not_driven = lines_of({{11, 0.01}, {31, 0.01}}, 1, 6, {11.3, 140});
  EXPECT_TRUE(not_driven.further.empty());
  EXPECT_FALSE(not_driven.may_be_further[1]);
}

// A peak is that of the mode it is nearest to, and a mode that is right is not moved to another's.
TEST(DrivenLines, APeakBelongsToOneMode) {
  const ModeLines hidden = lines_of({{10, 0.01}}, 1, 6, {10, 11.3});
  ASSERT_TRUE(hidden.at_nominal[0]);
  EXPECT_NEAR(*hidden.at_nominal[0], two_pi * 10, 0.3 * two_pi);
  EXPECT_FALSE(hidden.at_nominal[1]);
  EXPECT_TRUE(hidden.further.empty());
  // A neighbour outside of the model, twice as strong.
  const ModeLines neighbour = lines_of({{10, 0.01}, {11.2, 0.005}}, 2, 6, {10});
  ASSERT_TRUE(neighbour.at_nominal[0]);
  EXPECT_NEAR(*neighbour.at_nominal[0], two_pi * 10, 0.3 * two_pi);
}

// A mode that a sweep passes early is seen beside a weak one amid it; a nominal value is never moved past its
// double.
TEST(DrivenLines, AModeNearTheEndOfASweepIsSeen) {
  Record record;
  record.sample_rate_hz = rate;
  std::vector<double> force;
  for (int i = 0; i < 22000; ++i) {
    const double t = i / rate;
    force.push_back(std::sin(two_pi * (8 * t + 0.1 * t * t)));
  }
  std::vector<double> tip = driven_response(force, {{10, 0.01}}, rate);
  const std::vector<double> weak = driven_response(force, {{23, 0.01}}, rate);
  for (std::size_t i = 0; i < tip.size(); ++i) tip[i] += 0.05 * weak[i];
  record.channels = {force, tip};
  const RecordReader read = [&](std::size_t) { return record; };
  const auto start = [&](double hz) {
    return natural_frequency_starts(driven_campaign(RecordKind::sweep, 1), read, {two_pi * hz}, {}, {}, {});
  };
  EXPECT_FALSE(start(10).moved[0]);
  EXPECT_NEAR(start(7).frequency[0], two_pi * 10, 0.02 * two_pi * 10);
  EXPECT_FALSE(start(3).moved[0]);
}

// Tuned numbers by half and by twice: frequencies of modes that stand out stay within the range, and noise shows
// none.
TEST(DrivenLines, NoNumberDecidesWhereAModeIs) {
  for (const auto& threshold : measure_threshold_list) {
    if (threshold.where != "observe/driven_lines.cpp" || threshold.kind != ThresholdKind::tuned) continue;
    for (const double by : {0.5, 2.0}) {
      testing_support::ChangedThresholds<MeasureThresholds> changed;
      changed.multiply(threshold, by);
      const ModeLines lines = lines_of({{11, 0.01}, {31, 0.02}}, 2, 5, {11, 31});
      for (std::size_t k = 0; k < 2; ++k) {
        ASSERT_TRUE(lines.at_nominal[k]) << threshold.name << ' ' << by;
        EXPECT_NEAR(*lines.at_nominal[k], two_pi * (k == 0 ? 11 : 31), 0.03 * *lines.at_nominal[k])
            << threshold.name << ' ' << by;
      }
      for (unsigned seed = 0; seed < 10; ++seed)
        EXPECT_TRUE(lines_of({}, 1, seed, {none}).further.empty()) << threshold.name << ' ' << by;
    }
  }
}

// Of a multisine of few lines nothing is told, whatever the noise: second differences need lines that are next.
TEST(DrivenLines, FewLinesTellNoMode) {
  for (const double noise : {0.0, 0.5, 2.0})
    for (unsigned seed = 0; seed < 10; ++seed) {
      std::mt19937 engine(seed);
      std::normal_distribution<double> normal;
      std::vector<double> force(8000, 0);
      for (int line = 0; line < 70; ++line) {
        const double phase = two_pi * std::uniform_real_distribution<double>()(engine);
        for (std::size_t i = 0; i < force.size(); ++i)
          force[i] += std::cos(two_pi * (5 + 0.5 * line) * static_cast<double>(i) / rate + phase);
      }
      Record record;
      record.sample_rate_hz = rate;
      record.channels = {force, driven_response(force, {{10, 0.01}}, rate)};
      double square = 0;
      for (const double x : record.channels[1]) square += x * x / 8000;
      for (double& x : record.channels[1]) x += noise * std::sqrt(square) * normal(engine);
      const NaturalFrequencyStarts starts =
          natural_frequency_starts(driven_campaign(RecordKind::broadband, 1), [&](std::size_t) { return record; },
                                   {two_pi * 10}, {}, {}, {});
      EXPECT_FALSE(starts.moved[0]) << noise << ' ' << starts.frequency[0];
    }
}

// 1 in 300 where ranges are a hundred independent ones and each passes by chance once in 30,000: four at most with
// a probability of 0.9999.
TEST(DrivenLines, NoiseShowsNoMode) {
  int seen = 0;
  for (unsigned seed = 0; seed < 200; ++seed) seen += lines_of({}, 1, seed, {none}).further.empty() ? 0 : 1;
  EXPECT_LE(seen, 4);
}

// A sweep that hardly leaves the resonance, and a nominal value that is off by more than six turns allow.
TEST(DrivenLines, ASweepMovesANominalValueThatIsTooFarOff) {
  const Campaign campaign = driven_campaign(RecordKind::sweep, 1);
  Record record;
  record.sample_rate_hz = rate;
  std::vector<double> force;
  for (int i = 0; i < 12000; ++i) {
    const double t = i / rate;
    force.push_back(std::sin(two_pi * (18.5 * t + 0.5 * 3.5 / 60 * t * t)));
  }
  record.channels = {force, driven_response(force, {{20, 0.008}}, rate)};
  const RecordReader read = [&](std::size_t) { return record; };
  for (const double nominal : {10.5, 18.2, 22.5, 31.0}) {
    const NaturalFrequencyStarts starts = natural_frequency_starts(campaign, read, {two_pi * nominal}, {}, {}, {});
    EXPECT_TRUE(starts.moved[0]) << nominal;
    EXPECT_NEAR(starts.frequency[0], two_pi * 20, 0.02 * two_pi * 20) << nominal;
  }
  const NaturalFrequencyStarts near = natural_frequency_starts(campaign, read, {two_pi * 20.9}, {}, {}, {});
  EXPECT_FALSE(near.moved[0]);
  EXPECT_EQ(near.frequency[0], two_pi * 20.9);
}

}  // namespace
}  // namespace secular
