// What a diagnosis says of the disturbances that were found in records, and what it adds to them.
#include "diagnose/verdict/told_disturbances.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "diagnose/verdict/left_content.hpp"
#include "generated/registry.hpp"

namespace secular {
namespace {

class ToldDisturbances : public testing::Test {
 protected:
  ToldDisturbances() {
    campaign.channels.resize(2);
    campaign.channels[0].role = ChannelRole::excitation;
    campaign.channels[1].name = "v";
    campaign.channels[1].unit = "m";
    campaign.records.resize(2);
    diagnosis.spans = {{0, {1, 5}}, {1, {2, 6}}};
  }

  void fit_offset(double value, double sd) {
    diagnosis.fitted.names = {"offset(v)"};
    diagnosis.fitted.values = Eigen::VectorXd::Constant(1, value);
    diagnosis.fitted.covariance = Eigen::MatrixXd::Constant(1, 1, sd * sd);
  }

  std::vector<Disturbance> told(std::vector<Disturbance> found = {}) const {
    return told_disturbances(std::move(found), diagnosis, options, campaign, model);
  }

  static Disturbance hum() {
    Disturbance d;
    d.kind = tone_kind;
    d.record = 1;
    d.channel = 1;
    d.frequency_hz = 50;
    return d;
  }

  const CompiledModel& model = *generated::find_compiled_model("two_mass_mode1");
  Campaign campaign;
  Diagnosis diagnosis;
  DiagnosisOptions options;
};

TEST_F(ToldDisturbances, AToneIsFittedInTheRecordThatAllowsForIt) {
  EXPECT_EQ(told({hum()}).front().treated, "listed");
  options.tones[0] = {{1, 2 * std::numbers::pi * 50}};
  EXPECT_EQ(told({hum()}).front().treated, "listed");
  options.tones[1] = options.tones[0];
  EXPECT_EQ(told({hum()}).front().treated, "fitted");
}

TEST_F(ToldDisturbances, AnOffsetThatTheFitTellsPlainlyIsAdded) {
  fit_offset(-1e-3, 1e-4);
  const std::vector<Disturbance> plain = told();
  ASSERT_EQ(plain.size(), 1U);
  EXPECT_EQ(plain[0].kind, "offset");
  EXPECT_EQ(plain[0].size, 1e-3);
  EXPECT_EQ(plain[0].from_s, 1);
  fit_offset(-1e-3, 5e-4);
  EXPECT_TRUE(told().empty());
}

TEST_F(ToldDisturbances, AnOffsetThatRecordsShowIsFittedAndNotAddedOnceMore) {
  fit_offset(-1e-3, 1e-4);
  Disturbance known;
  known.kind = "offset";
  known.channel = 1;
  const std::vector<Disturbance> found = told({known});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].treated, "fitted");
}

TEST_F(ToldDisturbances, RecordsThatAreLateOrHaveFrequenciesOfTheirOwnAreAdded) {
  diagnosis.late.records = {{.record = 1, .late_s = -2e-3, .period_s = 0.05}};
  diagnosis.frequency_scatter.sd = Eigen::VectorXd::Constant(1, 0.01);
  diagnosis.frequency_scatter.records = {{.record = 0, .mode = 0, .offset = 0.02, .variance = 1e-6}};
  const std::vector<Disturbance> found = told();
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].kind, "late_record");
  EXPECT_EQ(found[0].record, 1U);
  EXPECT_DOUBLE_EQ(found[0].share, 0.04);
  EXPECT_NE(found[0].text.find("ahead of"), std::string::npos);
  EXPECT_EQ(found[1].kind, "record_scatter");
  EXPECT_NE(found[1].text.find("omega0 is 2 % above the mean"), std::string::npos) << found[1].text;
}

TEST_F(ToldDisturbances, BlowsSayByHowMuchTheirStrengthIsTheirOwn) {
  BlowsAlone blows;
  blows.records = {0, 1};
  blows.left = {400, 100};
  blows.strengths = {{.symbol = 8, .records = {{0, 0.9, 1e-6}, {1, 1.1, 1e-6}}, .mean = 1, .sd = 0.14}};
  const std::vector<Disturbance> found = blow_mismatches(blows, diagnosis, model);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].treated, "left_out");
  EXPECT_NEAR(found[0].size, -0.1, 1e-12);
  EXPECT_NEAR(found[1].size, 0.1, 1e-12);
  EXPECT_NE(found[1].text.find("leave 2 times the noise"), std::string::npos) << found[1].text;
}

}  // namespace
}  // namespace secular
