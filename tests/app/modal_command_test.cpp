// `secular modal` as a user meets it.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/program_run.hpp"
#include "tests/campaign/write_campaign.hpp"
#include "tests/modal/structure_campaign.hpp"
#include "tests/process_folder.hpp"
#include "tests/report/page_structure.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;
using testing_support::text_of;

class ModalCommand : public testing::Test {
 protected:
  void SetUp() override {
    folder = testing_support::process_folder() /
             ("secular_modal_cli_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  int run(const std::string& arguments) {
    const testing_support::Outcome outcome = testing_support::run_program(folder, "modal " + arguments);
    output = outcome.output;
    errors = outcome.errors;
    return outcome.status;
  }
  std::string path(const std::string& name) const { return (folder / name).string(); }

  fs::path folder;
  std::string output, errors;
};

TEST_F(ModalCommand, HelpsWithAnExample) {
  EXPECT_EQ(run("--help"), 0);
  EXPECT_NE(output.find("Example: secular modal"), std::string::npos);
}

TEST_F(ModalCommand, ImpactsToModesAndBasis) {
  const testing_support::CampaignData data = testing_support::impact_campaign(3, 1e-3, 5);
  write_campaign(data.campaign, data.samples, path("hits"));
  const std::string arguments = path("hits") + " --band 5:60 --driving-point uplx-=-uprx+";
  ASSERT_EQ(run(arguments + " -o " + path("out") + " --basis " + path("basis.toml")), 0) << errors;
  EXPECT_NE(output.find("modal mass"), std::string::npos) << output;
  const nlohmann::json json = nlohmann::json::parse(text_of(folder / "out/modal.json"));
  ASSERT_EQ(json["modes"].size(), 3u);
  EXPECT_NEAR(json["modes"][0]["modal_mass_kg"].get<double>(), 0.52, 0.05);
  EXPECT_GT(json["modes"][0]["natural_frequency_sd_hz"].get<double>(), 0);
  EXPECT_EQ(json["matrices"]["mass_kg"].size(), 3u);
  EXPECT_TRUE(text_of(folder / "basis.toml").starts_with("[modal_basis]\nchannels = [\"uprx+\", \"lorx+\""));
  const std::string html = text_of(folder / "out/report.html");
  for (const char* part : {"Stabilisation diagram", "Modal masses", "Coherence", "[modal_basis]", "<svg"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
  EXPECT_EQ(report::test::structure_faults(html), std::vector<std::string>());
  // The same input gives the same bytes.
  ASSERT_EQ(run(arguments + " -o " + path("again") + " --json"), 0) << errors;
  EXPECT_EQ(output, text_of(folder / "out/modal.json"));
}

TEST_F(ModalCommand, DecaysToAmplitudeDependence) {
  const testing_support::CampaignData data = testing_support::decay_campaign(2, 0.02, 3);
  write_campaign(data.campaign, data.samples, path("decays"));
  ASSERT_EQ(run(path("decays") + " --band 5:60 --modes 3 -o " + path("out")), 0) << errors;
  const nlohmann::json json = nlohmann::json::parse(text_of(folder / "out/modal.json"));
  ASSERT_EQ(json["modes"].size(), 3u);
  EXPECT_NEAR(json["modes"][0]["natural_frequency_hz"].get<double>(), 12.419, 0.02);
  EXPECT_GT(json["windows"].size(), 20u);
  for (const nlohmann::json& mode : json["modes"]) {
    EXPECT_TRUE(mode.contains("degrees_of_freedom"));
    for (const char* value : {"natural_frequency_interval_hz", "damping_ratio_interval"}) {
      ASSERT_EQ(mode[value].size(), 2u) << value;
      EXPECT_LT(mode[value][0].get<double>(), mode[value][1].get<double>()) << value;
    }
  }
  EXPECT_NE(text_of(folder / "out/report.html").find("Frequency and damping against amplitude"), std::string::npos);
}

TEST_F(ModalCommand, BadInputLeavesNothing) {
  const testing_support::CampaignData data = testing_support::decay_campaign(1, 0.02, 3, 4);
  write_campaign(data.campaign, data.samples, path("decays"));
  const auto refused = [&](const std::string& arguments, const std::string& part) {
    EXPECT_EQ(run(arguments + " -o " + path("out")), 2) << arguments << output;
    EXPECT_NE(errors.find(part), std::string::npos) << errors;
    EXPECT_FALSE(fs::exists(folder / "out")) << arguments;
    EXPECT_FALSE(fs::exists(folder / "basis.toml")) << arguments;
  };
  refused(path("nowhere"), "nowhere");
  refused(path("decays") + " --band 5", "LOW:HIGH");
  refused(path("decays") + " --band 60:5", "the band is empty");
  refused(path("decays") + " --band 5:sixty", "LOW:HIGH");
  refused(path("decays") + " --driving-point uprx+", "GROUP=CHANNEL");
  refused(path("decays") + " --from 3 --to 1", "--from must be before --to");
  refused(path("decays") + " --window -1", "--window");
  refused(path("decays") + " --order 2", "--order");
  refused(path("decays") + " --band 5:60 --basis " + path("basis.toml"), "modal masses are not known");
}

}  // namespace
}  // namespace secular
