// Where driven records show modes (docs/inference.md (51)).
#include "measure/observe/driven_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include "measure/observe/natural_frequency_starts.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

constexpr double rate = 200, none = std::numeric_limits<double>::quiet_NaN();

struct DrivenMode {
  double hz = 0, damping_ratio = 0;
};

// Displacements of modes that a signal drives, exact where the signal is constant from sample to sample.
std::vector<double> driven(const std::vector<double>& excitation, const std::vector<DrivenMode>& modes) {
  std::vector<double> response(excitation.size(), 0);
  for (const DrivenMode& mode : modes) {
    const double w = two_pi * mode.hz, decay = mode.damping_ratio * w, own = std::sqrt(w * w - decay * decay);
    const double e = std::exp(-decay / rate), c = std::cos(own / rate), s = std::sin(own / rate);
    double x = 0, v = 0;
    for (std::size_t i = 0; i < excitation.size(); ++i) {
      response[i] += x;
      const double y = x - excitation[i] / (w * w);
      x = e * (y * (c + decay / own * s) + v / own * s) + excitation[i] / (w * w);
      v = e * (v * (c - decay / own * s) - y * w * w / own * s);
    }
  }
  return response;
}

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
    std::vector<double> tip = driven(force, modes);
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
  record.channels = {force, driven(force, {{20, 0.008}})};
  const RecordReader read = [&](std::size_t) { return record; };
  for (const double nominal : {10.0, 18.2, 22.5, 31.0}) {
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
