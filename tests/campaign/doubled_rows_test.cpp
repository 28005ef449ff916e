// Rows that a file holds twice, and samples that are held.
#include "measure/disturbances/doubled_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "measure/data/watched_reader.hpp"
#include "measure/disturbances/treatment.hpp"

namespace secular {
namespace {

constexpr double doubled_rate = 256;
constexpr std::size_t doubled_count = 4096;

using ChannelSamples = std::vector<std::vector<double>>;

// A response that decays, and, of a dwell, what drives it.
ChannelSamples swinging(bool driven, double noise, double frequency_hz = 7.3) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  ChannelSamples channels(driven ? 2 : 1, std::vector<double>(doubled_count));
  for (std::size_t i = 0; i < doubled_count; ++i) {
    const double t = static_cast<double>(i) / doubled_rate, angle = 2 * std::numbers::pi * frequency_hz * t;
    for (std::size_t c = 0; c < channels.size(); ++c)
      channels[c][i] =
          (driven ? 1 : std::exp(-0.1 * t)) * std::cos(angle + static_cast<double>(c)) + noise * normal(random);
  }
  return channels;
}

// Of the channels the rows at these places once or more again, to the length that they had.
std::vector<double> rows_twice(const std::vector<double>& x, std::size_t period, std::size_t times) {
  std::vector<double> rows;
  for (std::size_t i = 0; rows.size() < x.size(); ++i)
    rows.insert(rows.end(), 1 + (i % period == 11 ? times : 0), x[i]);
  rows.resize(x.size());
  return rows;
}

std::vector<double> rows_held(std::vector<double> x, std::size_t period, std::size_t times) {
  for (std::size_t i = 11; i + times < x.size(); i += period)
    for (std::size_t n = 1; n <= times; ++n) x[i + n] = x[i];
  return x;
}

Campaign campaign_with_channels(std::size_t channels) {
  Campaign campaign;
  campaign.name = "doubled";
  campaign.sample_rate_hz = doubled_rate;
  for (std::size_t c = 0; c < channels; ++c) {
    Channel channel;
    channel.name = c + 1 < channels ? "base" : "tip";
    channel.role = c + 1 < channels ? ChannelRole::excitation : ChannelRole::response;
    channel.unit = "m/s^2";
    campaign.channels.push_back(channel);
  }
  RecordEntry entry;
  entry.file = "records/0001.csv";
  entry.kind = channels > 1 ? RecordKind::dwell : RecordKind::free_decay;
  if (channels > 1) entry.excitation_frequency_hz = 7.3;
  campaign.records.push_back(entry);
  return campaign;
}

// What is left of a file's channels.
ChannelSamples mended_of(const ChannelSamples& channels) {
  const Campaign campaign = campaign_with_channels(channels.size());
  Record record;
  record.sample_rate_hz = doubled_rate;
  record.channels = channels;
  std::vector<ChannelValues> values;
  for (const std::vector<double>& samples : channels) values.push_back(values_of(samples));
  const Treatment treatment = treatment_of(campaign, 0, record, values);
  if (treatment.then) treatment.then(record);
  return record.channels;
}

TEST(DoubledRows, AreTakenOutOfAllChannels) {
  for (const bool driven : {false, true})
    for (const unsigned times : {1U, 3U, 12U}) {
      const ChannelSamples plain = swinging(driven, 1e-2);
      ChannelSamples file;
      for (const std::vector<double>& x : plain) file.push_back(rows_twice(x, 97, times));
      const ChannelSamples left = mended_of(file);
      for (std::size_t c = 0; c < file.size(); ++c) {
        ASSERT_LT(left[c].size(), doubled_count) << driven << ", " << times;
        // A run that the record's end cuts stays.
        for (std::size_t i = 0; i + 16 < left[c].size(); ++i)
          ASSERT_EQ(left[c][i], plain[c][i]) << driven << ", " << times << ", " << i << " of " << left[c].size();
      }
    }
}

TEST(DoubledRows, AreNoHeldSamples) {
  for (const bool driven : {false, true})
    for (const unsigned times : {1U, 3U, 12U}) {
      ChannelSamples file;
      for (const std::vector<double>& x : swinging(driven, 1e-3)) file.push_back(rows_held(x, 97, times));
      EXPECT_EQ(mended_of(file)[0].size(), doubled_count) << driven << ", " << times;
    }
}

// One channel that repeats is no row, nor is a record without repeats.
TEST(DoubledRows, AreRowsOfAllChannels) {
  ChannelSamples file = swinging(true, 1e-3);
  EXPECT_EQ(mended_of(file)[0].size(), doubled_count);
  file[1] = rows_twice(file[1], 97, 1);
  EXPECT_EQ(mended_of(file)[0].size(), doubled_count);
}

// Neighbours on a converter's steps are equal wherever the motion is slow.
TEST(DoubledRows, AreNoConverterSteps) {
  for (const double step : {0.3, 0.1, 0.02, 0.004})
    for (const double frequency : {1.3, 7.3}) {
      ChannelSamples file = swinging(false, step / 30, frequency);
      for (double& x : file[0]) x = step * std::round(x / step);
      EXPECT_EQ(mended_of(file)[0].size(), doubled_count) << step << ", " << frequency;
    }
}

// A motion that dry friction holds at its turning points, without noise: it stops with a deceleration, and starts
// without.
TEST(DoubledRows, AreNoStickingMotion) {
  constexpr int moving = 23;
  for (const int stuck : {5, 20}) {
    ChannelSamples file(1);
    for (int i = 0; file[0].size() < doubled_count; ++i) {
      const int step = i % (moving + stuck), half_turn = i / (moving + stuck);
      const double u = std::min(1.0, static_cast<double>(step) / moving);
      file[0].push_back((half_turn % 2 == 0 ? 1 : -1) * (1 - 2 * u * u * u * (4 - 3 * u)));
    }
    EXPECT_EQ(mended_of(file)[0].size(), doubled_count) << stuck;
  }
}

}  // namespace
}  // namespace secular
