// One clock for all records of a campaign: what changes slowly is seen by dwells and by free decays.
#include "measure/data/campaign_clock.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "diagnose/evidence/segment.hpp"
#include "tests/diagnose/laboratory.hpp"

namespace secular {
namespace {

Campaign two_decays() {
  Campaign campaign;
  campaign.sample_rate_hz = 200;
  RecordEntry entry;
  entry.kind = RecordKind::free_decay;
  entry.file = "first";
  entry.started_s = 3600;
  campaign.records.push_back(entry);
  entry.file = "second";
  entry.started_s = 3690;
  campaign.records.push_back(entry);
  return campaign;
}

TEST(CampaignClock, IsZeroInTheMiddleAndKeepsDifferences) {
  Campaign campaign = two_decays();
  campaign.records.push_back(campaign.records.back());
  campaign.records.back().started_s.reset();
  const std::vector<double> times = record_times(campaign);
  ASSERT_EQ(times.size(), 3U);
  EXPECT_DOUBLE_EQ(times[1] - times[0], 90);
  EXPECT_DOUBLE_EQ(times[2] - times[1], 1);
  EXPECT_NEAR(times[0] + times[1] + times[2], 0, 1e-9);
  EXPECT_TRUE(record_times(Campaign()).empty());
}

TEST(CampaignClock, SegmentsKeepItsTime) {
  const Campaign campaign = two_decays();
  const testing_support::Laboratory lab;
  const RecordReader read = [](std::size_t r) {
    Record record;
    record.start_s = 5;
    record.sample_rate_hz = 200;
    const double rate = testing_support::damping, omega = testing_support::natural + static_cast<double>(r);
    record.channels.assign(2, std::vector<double>(2000));
    for (std::size_t i = 0; i < 2000; ++i) {
      const double t = static_cast<double>(i) / 200;
      record.channels[1][i] =
          std::exp(-rate * t) * std::cos(omega * t) + 1e-4 * std::sin(37.0 * static_cast<double>(i * i));
    }
    return record;
  };
  SensorModel sensors = lab.sensors;
  sensors.excitations.clear();
  sensors.excitation_names.clear();
  std::vector<std::string> warnings;
  const std::vector<Segment> segments = cut_segments(campaign, read, sensors, {testing_support::natural},
                                                     {{}, SegmentLength::turns, 100'000}, warnings);
  const std::vector<double> began = record_times(campaign);
  std::size_t of_second = 0;
  for (const Segment& s : segments) {
    EXPECT_DOUBLE_EQ(s.time_s - s.in_record_s, began[s.record]);
    EXPECT_GE(s.in_record_s, 0);
    EXPECT_LT(s.in_record_s, 10);
    of_second += s.record;
  }
  EXPECT_GT(of_second, 0U);
  EXPECT_GT(segments.size(), of_second);
}

}  // namespace
}  // namespace secular
