// What records hold beside the motion: what a fit allows for of it, and what is found in what a model leaves.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "diagnose/verdict/left_content.hpp"
#include "tests/signal/gaussian.hpp"

namespace secular {
namespace {

constexpr double full_turn = 2 * std::numbers::pi, read_hz = 320;

class AdmittedContent : public testing::Test {
 protected:
  AdmittedContent() {
    campaign.channels.resize(2);
    campaign.channels[0].quantity = Quantity::displacement;
    campaign.channels[1].quantity = Quantity::velocity;
    campaign.records.resize(3);
    for (const std::size_t r : {0U, 1U}) campaign.records[r].kind = RecordKind::free_decay;
  }

  static Disturbance one(std::string_view kind, std::size_t record, std::size_t channel, double frequency_hz = 0) {
    Disturbance d;
    d.kind = kind;
    d.record = record;
    d.channel = channel;
    d.to_s = 10;
    if (frequency_hz > 0) d.frequency_hz = frequency_hz;
    return d;
  }

  // What is left of a decay of 10 Hz: white noise and more.
  SegmentEvidence::Left left(double hum, double ring) const {
    testing_support::Gaussian random(4);
    SegmentEvidence::Left l;
    l.channel = 1;
    l.sample_s = 1 / read_hz;
    l.to_s = 4;
    l.rms = 1;
    for (std::size_t i = 0; i < 1280; ++i) {
      const double t = static_cast<double>(i) / read_hz;
      l.reading.push_back(100 * std::exp(-0.75 * t) * std::cos(full_turn * 10 * t));
      l.noise.push_back(random());
      l.rest.push_back(l.noise.back() + hum * std::cos(full_turn * 47 * t + 1) +
                       ring * std::exp(-2 * t) * std::cos(full_turn * 24.1 * t));
    }
    l.unwhited = l.noise;
    return l;
  }

  Campaign campaign;
  DiagnosisOptions options;
};

TEST_F(AdmittedContent, AZeroWandersWhereNoMotionCouldBeIt) {
  allow_for({{one(wander_kind, 0, 0), one(wander_kind, 0, 1)}, {}, {}}, campaign, options);
  EXPECT_EQ(options.wandering, WanderingZeros{1});
  allow_for({{one(wander_kind, 0, 0), one(wander_kind, 1, 0)}, {}, {}}, campaign, options);
  EXPECT_EQ(options.wandering, WanderingZeros{0});
  options.window.band = Band{5, 50};
  allow_for({{one(wander_kind, 0, 0), one(wander_kind, 1, 0)}, {}, {}}, campaign, options);
  EXPECT_TRUE(options.wandering.empty());
}

TEST_F(AdmittedContent, AToneOfOneRecordIsInAllThatAreComparedSampleBySample) {
  allow_for({{one(tone_kind, 0, 1, 50), one(tone_kind, 1, 1, 50.01)}, {}, {}}, campaign, options);
  ASSERT_EQ(options.tones[0].size(), 1U);
  ASSERT_EQ(options.tones[1].size(), 1U);
  EXPECT_TRUE(options.tones[2].empty());
  // Of each record its own comes first.
  EXPECT_DOUBLE_EQ(options.tones[0][0].frequency, full_turn * 50);
  EXPECT_DOUBLE_EQ(options.tones[1][0].frequency, full_turn * 50.01);
}

TEST_F(AdmittedContent, WhatAModelLeavesIsFoundOnce) {
  ForeignContent content;
  EXPECT_EQ(find_left_content({left(1, 12)}, {left(1, 12)}, campaign, content), 2U);
  ASSERT_EQ(content.found.size(), 2U);
  EXPECT_EQ(content.found[0].kind, tone_kind);
  EXPECT_EQ(content.found[1].kind, ring_kind);
  ASSERT_EQ(content.ringing[0].size(), 1U);
  EXPECT_NEAR(content.ringing[0][0].rate, 2, 0.2);
  // A ring is looked for anew, a tone is known.
  EXPECT_EQ(find_left_content({left(1, 0)}, {left(1, 0)}, campaign, content), 0U);
  ASSERT_EQ(content.found.size(), 1U);
  EXPECT_EQ(content.found[0].kind, tone_kind);
}

TEST_F(AdmittedContent, NoiseAloneHoldsNothing) {
  ForeignContent content;
  EXPECT_EQ(find_left_content({left(0, 0)}, {left(0, 0)}, campaign, content), 0U);
}

}  // namespace
}  // namespace secular
