#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "generated/registry.hpp"
#include "motion/simulate/experiment.hpp"
#include "tests/process_folder.hpp"
#include "tests/simulate/simulated_campaign.hpp"

namespace secular::testing_support {

/// An experiment without its records: an oscillator of 20 Hz that hardens, on a base that moves.
constexpr const char* hardening_oscillator = R"toml(schema = 1
name = "duff"
model = "duffing"
sample_rate_hz = 256.0
[parameters]
omega0 = 125.66370614359172
mu = 1.0
a2 = 0.0
a3 = 2.5e8
e = 1.0
[excitation]
name = "base"
quantity = "acceleration"
unit = "m/s^2"
noise_sd = 0.01
[[response]]
name = "tip"
quantity = "acceleration"
unit = "m/s^2"
noise_sd = 0.02
)toml";

/// The same with a quadratic term: second harmonics are equations then.
inline std::string lopsided_oscillator() {
  std::string text = hardening_oscillator;
  text.replace(text.find("a2 = 0.0"), 8, "a2 = 4e5");
  return text;
}

/// Twelve dwells of it at two levels.
inline const std::string dwells_at_two_levels = R"toml([[dwell]]
frequencies_hz = [19.7, 19.85, 20.0, 20.1, 20.2, 20.35]
amplitudes = [0.2, 0.4]
settle_s = 12.0
ensembles = 4
ensemble_s = 2.0
)toml";

/// The campaign of an experiment on it, in memory.
inline SimulatedCampaign oscillator_campaign(const std::string& experiment, std::uint64_t seed) {
  const auto file = process_folder() / "oscillator.toml";
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << experiment;
  const CompiledModel& model = *generated::find_compiled_model("duffing");
  return run_virtual_test(read_experiment(file, model), model, seed, 2);
}

/// Of the response, in all records.
inline double largest_response(const SimulatedCampaign& made) {
  double largest = 0;
  for (const Record& record : made.samples)
    for (const double y : record.channels[1]) largest = std::max(largest, std::abs(y));
  return largest;
}

}  // namespace secular::testing_support
