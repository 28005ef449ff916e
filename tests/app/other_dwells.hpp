#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "generated/registry.hpp"
#include "tests/campaign/write_campaign.hpp"
#include "tests/places.hpp"
#include "tests/simulate/simulated_campaign.hpp"

namespace secular::testing_support {

/// The shipped parametric experiment on two_mass_mode1 with these dwells in place of its own, as a campaign in
/// `folder`/campaign.
inline std::filesystem::path campaign_of_other_dwells(const std::string& dwells,
                                                      const std::filesystem::path& folder) {
  std::ifstream shipped(source_folder() / "models/experiments/principal_parametric.toml");
  std::string text(std::istreambuf_iterator<char>(shipped), {});
  text.resize(text.find("[[dwell]]"));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "experiment.toml") << text + dwells;
  const CompiledModel& model = *generated::find_compiled_model("two_mass_mode1");
  const SimulatedCampaign made = run_virtual_test(read_experiment(folder / "experiment.toml", model), model, 1, 2);
  write_campaign(made.campaign, made.samples, folder / "campaign");
  return folder / "campaign";
}

}  // namespace secular::testing_support
