// How long the segments of decays are: docs/inference.md (49).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "diagnose/evidence/segment.hpp"
#include "tests/diagnose/laboratory.hpp"
#include "tests/signal/gaussian.hpp"

namespace secular {
namespace {

constexpr double turn_s = 2 * std::numbers::pi / testing_support::natural, decay_rate_hz = 200;

TEST(DecayLength, MoreDecaysOrLongerOnesNeverShortenIt) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> turns(0, 400);
  for (int draw = 0; draw < 500; ++draw) {
    std::vector<double> loud;
    double before = turns_of_segments({});
    for (int i = 0; i < 5; ++i) {
      loud.push_back(turns(random));
      const double more = turns_of_segments(loud);
      EXPECT_GE(more, before);
      EXPECT_LE(more, 40);
      loud[random() % loud.size()] += turns(random);
      before = turns_of_segments(loud);
      EXPECT_GE(before, more);
    }
  }
}

TEST(DecayLength, TwoDecaysHoldFourSegments) {
  EXPECT_EQ(turns_of_segments({1000}), 6);  // one alone
  EXPECT_EQ(turns_of_segments({12, 1000, 18}), 6);
  EXPECT_EQ(turns_of_segments({12, 100, 1000}), 25);
  EXPECT_EQ(turns_of_segments({300, 12, 200}), 40);
}

struct Release {
  double rate = 0.8, began_s = 0, scale = 1;
  std::uint64_t rounding = 0;  // other than 0: readings times 1 + 1e-9 u
};

// Samples of the segments, by record.
std::vector<std::vector<Eigen::Index>> cut_lengths(const std::vector<Release>& releases) {
  const testing_support::Laboratory lab;
  SensorModel sensors = lab.sensors;
  sensors.excitations.clear();
  sensors.excitation_names.clear();
  Campaign campaign;
  campaign.sample_rate_hz = decay_rate_hz;
  campaign.records.resize(releases.size());
  for (RecordEntry& entry : campaign.records) entry.kind = RecordKind::free_decay;
  const RecordReader read = [&](std::size_t r) {
    const Release& release = releases[r];
    testing_support::Gaussian noise(r + 1), rounding(release.rounding);
    Record record;
    record.start_s = release.began_s;
    record.sample_rate_hz = decay_rate_hz;
    record.channels.assign(2, std::vector<double>(2400));
    for (std::size_t i = 0; i < 2400; ++i) {
      const double t = static_cast<double>(i) / decay_rate_hz;
      const double motion = std::exp(-release.rate * t) * std::cos(testing_support::natural * t) + 1e-4 * noise();
      record.channels[1][i] = release.scale * motion * (release.rounding > 0 ? 1 + 1e-9 * rounding() : 1);
    }
    return record;
  };
  std::vector<std::string> warnings;
  std::vector<std::vector<Eigen::Index>> lengths(releases.size());
  for (const Segment& s : cut_segments(campaign, read, sensors, {testing_support::natural},
                                       {{}, SegmentLength::turns, 100'000}, warnings))
    lengths[s.record].push_back(s.response.cols());
  EXPECT_TRUE(warnings.empty());
  return lengths;
}

TEST(DecayLength, SegmentsOfAllDecaysAreAsLongAsTheTwoLoudestAllow) {
  const auto lengths = cut_lengths({{0.8}, {1.6}, {1.0}});
  const double loud_turns = std::log(1 / 8e-4) / 1.0 / turn_s;  // of the second loudest, to six turns
  EXPECT_NEAR(static_cast<double>(lengths[0][0]), loud_turns / 4 * turn_s * decay_rate_hz,
              2 * turn_s * decay_rate_hz);
  for (const auto& of_record : lengths)
    for (const Eigen::Index length : of_record) EXPECT_EQ(length, lengths[0][0]);
  EXPECT_GE(lengths[0].size(), 4U);
  EXPECT_GE(lengths[2].size(), 4U);
  const auto alone = cut_lengths({Release{0.8}});
  for (const Eigen::Index length : alone[0])
    EXPECT_NEAR(static_cast<double>(length), 6 * turn_s * decay_rate_hz, 1);
}

TEST(DecayLength, UnitsClocksAndRoundingLeaveIt) {
  const auto lengths = cut_lengths({{0.8}, {1.0}});
  EXPECT_EQ(cut_lengths({{0.8, 100}, {1.0, -3}}), lengths);
  EXPECT_EQ(cut_lengths({{0.8, 0, 1e-6}, {1.0, 0, 1e-6}}), lengths);
  for (const std::uint64_t rounding : {5U, 6U})
    EXPECT_EQ(cut_lengths({{0.8, 0, 1, rounding}, {1.0, 0, 1, rounding + 10}}), lengths);
}

}  // namespace
}  // namespace secular
