// A campaign whose dwells all stay at rest: what is said, and that it is bad input.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "input/input_error.hpp"
#include "jobs/identify/identification.hpp"
#include "tests/app/other_dwells.hpp"
#include "tests/process_folder.hpp"

namespace secular::app {
namespace {

namespace fs = std::filesystem;

TEST(NothingLeft, IsBadInputOfTheCampaign) {
  const fs::path folder = testing_support::process_folder() / "secular_nothing_left";
  IdentificationRequest request;
  const Campaign campaign = read_campaign(testing_support::campaign_of_other_dwells(
      "[[dwell]]\nfrequencies_hz = [24.6, 24.7]\namplitudes = [1.0]\nensembles = 2\n"
      "ensemble_s = 2.0\nsettle_s = 30.0\ninitial_displacement = [0.0001]\ngroup = \"level\"\n",
      folder));
  request.model = "two_mass_mode1";
  try {
    identify(request, campaign);
    FAIL() << "identified";
  } catch (const InputError& error) {
    EXPECT_EQ(error.file(), campaign.folder);
    for (const char* part : {"principal_parametric", "no observations are left", "trivial branch"})
      EXPECT_NE(error.wrong().find(part), std::string::npos) << error.wrong();
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace secular::app
