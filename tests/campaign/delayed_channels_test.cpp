// Channels that campaign.toml says to be late.
#include "measure/data/delayed_channels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "input/input_error.hpp"
#include "measure/data/campaign_text.hpp"
#include "measure/data/watched_reader.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

constexpr double delayed_rate = 400;

double two_tones(double t) {
  return std::cos(2 * std::numbers::pi * 11.3 * t) + 0.2 * std::cos(2 * std::numbers::pi * 97 * t + 1);
}

// A decay of two channels, the second of which is late.
Campaign late_campaign(double delay_s) {
  Campaign campaign;
  campaign.folder = testing_support::process_folder() / "late";
  campaign.name = "late";
  campaign.sample_rate_hz = delayed_rate;
  campaign.channels = {{"base", ChannelRole::excitation, Quantity::acceleration, "m/s^2"},
                       {"tip", ChannelRole::response, Quantity::acceleration, "m/s^2"}};
  campaign.channels[1].delay_s = delay_s;
  campaign.records.emplace_back();
  campaign.records[0].file = "records/0001.csv";
  campaign.records[0].kind = RecordKind::broadband;
  return campaign;
}

Record late_record(double delay_s, std::size_t samples) {
  Record record;
  record.start_s = 3;
  record.sample_rate_hz = delayed_rate;
  record.channels.resize(2);
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = record.start_s + static_cast<double>(i) / delayed_rate;
    record.channels[0].push_back(two_tones(t));
    record.channels[1].push_back(two_tones(t - delay_s));
  }
  return record;
}

TEST(DelayedChannels, ComeInStep) {
  for (const double delay : {0.0021, -0.0137, 0.0025, 0.05}) {
    const Record moved = without_delays(late_campaign(delay), late_record(delay, 800), "a.csv");
    const auto cut = static_cast<std::size_t>(std::ceil(std::abs(delay) * delayed_rate - 1e-9));
    EXPECT_EQ(moved.samples() + moved.cut_for_delay, 800U);
    EXPECT_NEAR(static_cast<double>(moved.cut_for_delay), static_cast<double>(cut), 1) << delay;
    for (std::size_t i = 20; i + 20 < moved.samples(); ++i) {
      const double t = moved.start_s + static_cast<double>(i) / delayed_rate;
      ASSERT_NEAR(moved.channels[0][i], two_tones(t), 1e-9) << delay;
      ASSERT_NEAR(moved.channels[1][i], two_tones(t), 1e-5) << delay << ' ' << i;
    }
  }
}

// Polynomials alone would take 7 % off it where samples are half way between samples.
TEST(DelayedChannels, NoiseStaysWhiteAndAsLargeAsItIs) {
  const auto power_at_lag = [](const std::vector<double>& y, std::size_t lag) {
    double sum = 0;
    for (std::size_t i = 0; i + lag < y.size(); ++i) sum += y[i] * y[i + lag];
    return sum / static_cast<double>(y.size());
  };
  Record record = late_record(0, 8000);
  std::mt19937_64 draw(5);
  std::normal_distribution<double> noise;
  for (double& y : record.channels[1]) y = noise(draw);
  for (const double share : {0.5, 0.3, 0.9, -0.5, 1.5}) {
    const Record moved = without_delays(late_campaign(share / delayed_rate), record, "a.csv");
    for (const std::size_t lag : {0U, 1U, 2U})
      EXPECT_NEAR(power_at_lag(moved.channels[1], lag), power_at_lag(record.channels[1], lag), 0.003) << share;
  }
}

TEST(DelayedChannels, WithoutADelayStayAsTheyAre) {
  const Record record = late_record(0, 100);
  EXPECT_EQ(without_delays(late_campaign(0), record, "a.csv").channels, record.channels);
}

TEST(DelayedChannels, UnusableRowsMoveWithTheirChannel) {
  Record record = late_record(0.05, 800);
  record.unusable = {400};
  const Record moved = without_delays(late_campaign(0.05), record, "a.csv");
  ASSERT_FALSE(moved.unusable.empty());
  EXPECT_LE(moved.unusable.front(), 380U);
  EXPECT_GE(moved.unusable.back(), 400U);
}

TEST(DelayedChannels, OfARowTurnItsPhases) {
  LineRow row;
  row.frequency_hz = 20;
  row.lines = {{0, {}, 1.0, {}},
               {1, {}, std::polar(2.0, -2 * std::numbers::pi * 20 * 0.002), {}},
               {1, {2, 1}, std::polar(1.0, -2 * std::numbers::pi * 40 * 0.002), {}}};
  const LineRow moved = without_delays(late_campaign(0.002), row);
  EXPECT_NEAR(std::arg(moved.lines[1].amplitude), 0, 1e-12);
  EXPECT_NEAR(std::arg(moved.lines[2].amplitude), 0, 1e-12);
  EXPECT_EQ(moved.lines[0].amplitude, row.lines[0].amplitude);
}

TEST(DelayedChannels, HalfARecordIsRefused) {
  try {
    without_delays(late_campaign(2), late_record(0, 800), "a.csv");
    FAIL();
  } catch (const InputError& error) {
    const std::string text = error.what();
    for (const char* part : {"campaign.toml", "delay_s", "less than half of a.csv", "seconds"})
      EXPECT_NE(text.find(part), std::string::npos) << text;
  }
}

// campaign.toml says it, and keeps it.
TEST(DelayedChannels, AreWrittenAndRead) {
  const Campaign campaign = late_campaign(0.002);
  const std::string text = campaign_text(campaign);
  EXPECT_NE(text.find("delay_s = 0.002\n"), std::string::npos) << text;
  EXPECT_EQ(campaign_text(late_campaign(0)).find("delay_s"), std::string::npos);
  std::filesystem::create_directories(campaign.folder / "records");
  std::ofstream(campaign.folder / "campaign.toml") << text;
  std::ofstream file(campaign.folder / "records/0001.csv");
  file.precision(12);
  file << "t,base,tip\n";
  const Record record = late_record(0.002, 800);
  for (std::size_t i = 0; i < 800; ++i)
    file << 3 + static_cast<double>(i) / delayed_rate << ',' << record.channels[0][i] << ','
         << record.channels[1][i] << '\n';
  file.close();
  const Campaign read = read_campaign(campaign.folder);
  EXPECT_EQ(read.channels[1].delay_s, 0.002);
  const Record moved = WatchedReader(read).read(0);
  for (std::size_t i = 20; i + 20 < moved.samples(); ++i)
    ASSERT_NEAR(moved.channels[1][i], moved.channels[0][i], 1e-5);
  std::ofstream(campaign.folder / "campaign.toml")
      << std::string(text).replace(text.find("delay_s = 0.002"), 15, "delay_s = \"2ms\"");
  EXPECT_THROW(read_campaign(campaign.folder), InputError);
}

}  // namespace
}  // namespace secular
