// A campaign whose dwells all stay at rest: what is said, and that it is bad input.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "app/shared/identification.hpp"
#include "generated/registry.hpp"
#include "input/input_error.hpp"
#include "motion/simulate/virtual_test.hpp"
#include "tests/campaign/write_campaign.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"

namespace secular::app {
namespace {

namespace fs = std::filesystem;

TEST(NothingLeft, IsBadInputOfTheCampaign) {
  std::ifstream shipped(testing_support::source_folder() / "models/experiments/principal_parametric.toml");
  std::string text(std::istreambuf_iterator<char>(shipped), {});
  text.resize(text.find("[[dwell]]"));
  text +=
      "[[dwell]]\nfrequencies_hz = [24.6, 24.7]\namplitudes = [1.0]\nensembles = 2\nensemble_s = 2.0\n"
      "settle_s = 30.0\ninitial_displacement = [0.0001]\ngroup = \"level\"\n";
  const fs::path folder = testing_support::process_folder() / "secular_nothing_left";
  fs::create_directories(folder);
  std::ofstream(folder / "rest.toml") << text;
  const CompiledModel& model = *generated::find_compiled_model("two_mass_mode1");
  const SimulatedCampaign simulated = run_virtual_test(read_experiment(folder / "rest.toml", model), model, 1, 2);
  write_campaign(simulated.campaign, simulated.samples, folder / "campaign");
  IdentificationRequest request;
  request.campaign = (folder / "campaign").string();
  request.model = "two_mass_mode1";
  try {
    identify(request);
    FAIL() << "identified";
  } catch (const InputError& error) {
    EXPECT_EQ(error.file(), request.campaign);
    for (const char* part : {"principal_parametric", "no observations are left", "trivial branch"})
      EXPECT_NE(error.wrong().find(part), std::string::npos) << error.wrong();
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace secular::app
