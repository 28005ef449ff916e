// What records are allowed to have of their own, and in which order: of fits of the model as it is that are made
// up.
#include "diagnose/verdict/allowances.hpp"

#include <gtest/gtest.h>

#include "generated/registry.hpp"

namespace secular {
namespace {

using Eigen::VectorXd;

constexpr double own_sd = 0.01;

class AllowancesOfRecords : public testing::Test {
 protected:
  AllowancesOfRecords() {
    add_channel(ChannelRole::excitation);
    add_channel(ChannelRole::response);
    campaign.records.resize(4);
    campaign.records.front().file = "1.csv";
    plain.left = {1000, 100};
    scattering.left = {400, 100};
    scattering.scatter.sd = VectorXd::Constant(1, own_sd);
    late.left = {200, 100};
    common = plain;
    both = late;
  }

  void add_channel(ChannelRole role) { campaign.channels.emplace_back().role = role; }

  void let_records_be_late() {
    for (std::size_t r = 0; r < campaign.records.size(); ++r)
      late.late.records.push_back({r, 1e-3 * static_cast<double>(r)});
    late.late.differ = late.late.plain = true;
    both.late = late.late;
  }

  std::vector<Allowance> found() {
    const FitBeside fit = [&](const Allowance& allowance, std::optional<double> common_late_s) {
      if (common_late_s) return common;
      if (allowance.late) ++asked_late;
      return !allowance.late ? scattering : allowance.frequency_scatter.size() == 0 ? late : both;
    };
    return in_turn(find_allowances({campaign, {}, model, {}}, plain, decays, fit).all);
  }

  const CompiledModel& model = *generated::find_compiled_model("two_mass_mode1");
  Campaign campaign;
  ModelAlone plain, scattering, late, common, both;
  VectorXd decays;
  int asked_late = 0;
};

TEST_F(AllowancesOfRecords, FrequenciesThatFollowNoSettingAreTriedBeforeThePlainEquations) {
  const std::vector<Allowance> all = found();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].frequency_scatter, VectorXd::Constant(1, own_sd));
  EXPECT_EQ(all[0].left, 4);
  EXPECT_EQ(all[1].turn, Allowance::plain);
  EXPECT_EQ(all[1].frequency_scatter.size(), 0);
}

TEST_F(AllowancesOfRecords, ThoseThatFollowTheSettingsAreTriedLastUnlessMuchOfThemDoesNot) {
  scattering.scatter.follows_settings = true;
  scattering.scatter.at_random = 0.05;
  EXPECT_EQ(found().back().turn, Allowance::at_last);
  scattering.scatter.at_random = 0.2;
  EXPECT_EQ(found().front().turn, Allowance::at_random);
}

TEST_F(AllowancesOfRecords, FrequenciesThatDoNotDifferAreNotAllowedTo) {
  scattering.scatter.sd.setZero();
  EXPECT_EQ(found().size(), 1U);
}

TEST_F(AllowancesOfRecords, WhatDecaysTellOfAModeIsTaken) {
  decays = VectorXd::Constant(1, 0.03);
  EXPECT_EQ(found().front().frequency_scatter, decays);
  decays.setZero();
  EXPECT_EQ(found().front().frequency_scatter, VectorXd::Constant(1, own_sd));
}

TEST_F(AllowancesOfRecords, OfTwoAtRandomTheOneThatLeavesLessIsTriedFirst) {
  let_records_be_late();
  const std::vector<Allowance> all = found();
  ASSERT_EQ(all.size(), 3U);
  EXPECT_TRUE(all[0].late);
  EXPECT_FALSE(all[1].late);
  EXPECT_EQ(all[1].turn, Allowance::at_random);
  EXPECT_EQ(all[2].turn, Allowance::plain);
}

TEST_F(AllowancesOfRecords, LatenessAndFrequenciesTogetherAreTriedLastOfAll) {
  let_records_be_late();
  both.scatter = scattering.scatter;
  const std::vector<Allowance> all = found();
  ASSERT_EQ(all.size(), 4U);
  EXPECT_TRUE(all.back().late);
  EXPECT_EQ(all.back().frequency_scatter.size(), 1);
}

TEST_F(AllowancesOfRecords, OneTimeForAllIsNoLatenessOfRecords) {
  let_records_be_late();
  common = late;
  for (const Allowance& allowance : found()) EXPECT_FALSE(allowance.late);
}

TEST_F(AllowancesOfRecords, DecaysAndTwoExcitationsAreNotAskedHowLateTheyAre) {
  add_channel(ChannelRole::excitation);
  found();
  campaign.channels.pop_back();
  for (RecordEntry& record : campaign.records) record.kind = RecordKind::free_decay;
  found();
  EXPECT_EQ(asked_late, 0);
}

TEST_F(AllowancesOfRecords, BlowsCountWhereTheWindowTakesOneAndTheModelIsDriven) {
  DiagnosisOptions options;
  const CampaignAndModel sides{campaign, {}, model, {}};
  EXPECT_FALSE(has_blows(sides, options));
  campaign.records.back().kind = RecordKind::impact;
  EXPECT_TRUE(has_blows(sides, options));
  options.window.records = "1.csv";
  EXPECT_FALSE(has_blows(sides, options));
}

}  // namespace
}  // namespace secular
