// Records beside the project that once gave false modes, and one that grows.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "measure/modal/modal_survey.hpp"
#include "tests/campaign/imported_files.hpp"
#include "tests/campaign/write_campaign.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

class ModalFaults : public testing::Test {
 protected:
  void TearDown() override { fs::remove_all(folder_); }

  ModalSurvey survey(const std::string& kind, const std::vector<std::string>& files,
                     const std::vector<std::string>& channels) {
    ImportOptions import;
    for (const std::string& file : files) import.files.push_back(place / file);
    import.kind = kind;
    import.channels = channels;
    const ImportedFiles imported = import_files(import);
    fs::remove_all(folder_);
    write_campaign(imported.campaign, imported.samples, folder_);
    return modal_survey(folder_, {});
  }
  static bool missing(const std::string& file) { return !fs::exists(place / file); }

  static inline const fs::path place = testing_support::source_folder().parent_path() / "shared/faults";
  const fs::path folder_ =
      testing_support::process_folder() /
      (std::string("secular_modal_fault_") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(ModalFaults, OneModeInNoiseIsOne) {
  if (missing("modal_spurious_modes/d00_ref.csv")) GTEST_SKIP() << place << " is not there";
  const ModalSurvey found = survey("free_decay", {"modal_spurious_modes/d00_ref.csv"},
                                   {"tip:response:displacement:m", "mid:response:displacement:m"});
  ASSERT_EQ(found.modes.size(), 1u);
  EXPECT_NEAR(found.modes[0].natural_frequency_hz, 20, 0.01);
  EXPECT_NEAR(found.modes[0].damping_ratio, 0.01, 1e-4);
}

TEST_F(ModalFaults, ImpactsOnOneModeGiveOne) {
  if (missing("modal_negative_damping/imp0.csv")) GTEST_SKIP() << place << " is not there";
  const std::vector<std::string> channels = {"f:excitation:force:N", "a:response:acceleration:m/s^2"};
  const std::string at = "modal_negative_damping/imp";
  const std::vector<std::string> all = {at + "0.csv", at + "1.csv", at + "2.csv"};
  for (const std::vector<std::string>& files : {all, {at + "0.csv"}, {at + "1.csv"}, {at + "_double.csv"}}) {
    const ModalSurvey found = survey("impact", files, channels);
    ASSERT_EQ(found.modes.size(), 1u) << files.front();
    EXPECT_NEAR(found.modes[0].natural_frequency_hz, 60, 0.01) << files.front();
    EXPECT_NEAR(found.modes[0].damping_ratio, 0.01, 2e-4) << files.front();
    EXPECT_EQ(found.modes[0].trend(), MotionTrend::decays);
  }
}

TEST_F(ModalFaults, GrowthIsReported) {
  if (missing("modal_growing/d26_growing.csv")) GTEST_SKIP() << place << " is not there";
  const ModalSurvey found =
      survey("free_decay", {"modal_growing/d26_growing.csv"}, {"tip:response:displacement:m"});
  ASSERT_EQ(found.modes.size(), 1u);
  EXPECT_NEAR(found.modes[0].natural_frequency_hz, 20, 0.01);
  EXPECT_NEAR(found.modes[0].damping_ratio, -0.003, 1e-4);
  EXPECT_EQ(found.modes[0].trend(), MotionTrend::grows);
  ASSERT_FALSE(found.warnings.empty());
  EXPECT_NE(found.warnings.front().find("grows"), std::string::npos) << found.warnings.front();
}

}  // namespace
}  // namespace secular
