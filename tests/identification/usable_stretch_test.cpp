// What counts of a record in which rows are unusable.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "measure/data/recorded_span.hpp"
#include "measure/observe/passed_record.hpp"
#include "measure/observe/record_window.hpp"
#include "measure/signal/band_pass.hpp"

namespace secular {
namespace {

using Places = std::vector<std::size_t>;

// A decay in one channel and a steady tone in the other, 100 samples a second.
Record two_channels(double rate_of_decay) {
  Record record;
  record.start_s = 2;
  record.sample_rate_hz = 100;
  record.channels.resize(2);
  for (int i = 0; i < 1000; ++i) {
    record.channels[0].push_back(std::exp(-rate_of_decay * i / 100) * std::cos(0.7 * i));
    record.channels[1].push_back(1 + std::sin(0.3 * i));
  }
  return record;
}

void expect_range(const Record& record, const Window& window, Eigen::Index first, Eigen::Index count) {
  const SampleRange range = range_of(record, window);
  EXPECT_EQ(range.first, first);
  EXPECT_EQ(range.count, count);
}

TEST(UsableStretch, HoldsMostOfTheMotion) {
  Record steady = two_channels(0), decay = two_channels(2);
  for (Record* record : {&steady, &decay}) record->unusable = {0, 300, 301, 900};
  expect_range(steady, {}, 302, 598);
  expect_range(decay, {}, 1, 299);
  steady.unusable = {999};
  expect_range(steady, {}, 0, 999);
}

TEST(UsableStretch, LiesInTheWindow) {
  Record steady = two_channels(0);
  steady.unusable = {100, 700};
  Window window;
  window.from_s = 2.5;  // sample 50
  window.to_s = 4.995;  // after sample 299
  expect_range(steady, window, 101, 199);
  window.from_s = 3.5;
  expect_range(steady, window, 150, 150);
}

TEST(UsableStretch, IsNothingWhereNoRowIsUsable) {
  Record steady = two_channels(0);
  for (std::size_t i = 0; i < steady.samples(); ++i) steady.unusable.push_back(i);
  EXPECT_EQ(range_of(steady, {}).count, 0);
}

TEST(UsableStretch, StaysWhereItIsInTime) {
  Record record = two_channels(0);
  record.unusable = {100, 300, 700};
  cut_record(record, 200, 600);
  EXPECT_EQ(record.unusable, (Places{100, 500}));
}

// A filter spreads one wrong sample over its reach on either side, and over nothing else.
TEST(UsableStretch, KeepsClearOfWhatAFilterSpreads) {
  Campaign campaign;
  campaign.sample_rate_hz = 100;
  campaign.channels.resize(2);
  campaign.records.emplace_back();
  campaign.records.front().kind = RecordKind::dwell;
  Window window;
  window.band = Band{5, 20};
  const Record right = two_channels(0);
  Record wrong = right;
  wrong.channels[0][400] = 1e3;
  wrong.unusable = {400};
  const Record passed = passed_record(campaign, 0, right, window),
               spread = passed_record(campaign, 0, wrong, window);
  ASSERT_FALSE(spread.unusable.empty());
  EXPECT_EQ(spread.unusable.size(), static_cast<std::size_t>(2 * band_pass_reach(*window.band, 100) + 1));
  for (std::size_t i = 0; i < passed.samples(); ++i) {
    const bool differs = passed.channels[0][i] != spread.channels[0][i];
    EXPECT_TRUE(!differs || std::binary_search(spread.unusable.begin(), spread.unusable.end(), i)) << i;
  }
}

}  // namespace
}  // namespace secular
