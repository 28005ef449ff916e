#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/process_folder.hpp"
#include "tests/simulate/simulated_campaign.hpp"

namespace secular::testing_support {

/// An experiment of a pendulum with drag `mu2` and dry friction `fc` that swings for a minute.
inline std::string pendulum_swing(double mu2, double fc) {
  return R"(schema = 1
name = "swing"
model = "pendulum"
sample_rate_hz = 100.0
[parameters]
omega0 = 5.77
alpha3 = -5.55
alpha5 = 0.2775
mu1 = 0.004
mu2 = )" +
         std::to_string(mu2) + "\nfc = " + std::to_string(fc) + R"(
[[response]]
name = "theta"
quantity = "angle"
unit = "rad"
noise_sd = 2e-4
[[free_decay]]
initial_displacement = [0.9]
duration_s = 60.0
)";
}

/// The campaign of an experiment, given as text.
inline SimulatedCampaign simulated(const CompiledModel& model, const std::string& text, std::uint64_t seed) {
  const std::filesystem::path path = process_folder() / ("diagnosis_" + std::to_string(seed) + ".toml");
  std::ofstream(path) << text;
  return run_virtual_test(read_experiment(path, model), model, seed, 1);
}

}  // namespace secular::testing_support
