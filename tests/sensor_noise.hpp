#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "measure/data/campaign.hpp"
#include "motion/simulate/experiment.hpp"
#include "motion/simulate/noise.hpp"

// Campaigns whose motions are integrated once and measured often.
namespace secular::testing_support {

inline Experiment without_noise(Experiment e) {
  for (auto& excitation : e.excitations) excitation.noise_sd = excitation.quantisation = 0;
  for (SimulatedChannel& channel : e.responses) channel.noise_sd = channel.quantisation = 0;
  return e;
}

/// Record number `r` of such a campaign without noise as the experiment's sensors measure it, the same as in a
/// simulation with that seed.
inline Record with_sensor_noise(Record record, const Experiment& experiment, std::uint64_t seed, std::size_t r) {
  const std::size_t excitations = experiment.excitations.size();
  for (std::size_t c = 0; c < record.channels.size(); ++c) {
    NoiseStream noise(seed, r, c);
    const SimulatedChannel& sensor =
        c < excitations ? experiment.excitations[c] : experiment.responses[c - excitations];
    for (double& x : record.channels[c]) {
      if (sensor.noise_sd > 0) x += sensor.noise_sd * noise.gaussian();
      if (sensor.quantisation > 0) x = sensor.quantisation * std::round(x / sensor.quantisation);
    }
  }
  return record;
}

/// A number of draws, or which is the first: by a variable of the environment for longer runs.
inline int number_from(const char* variable, int otherwise) {
  const char* text = std::getenv(variable);
  return text ? std::atoi(text) : otherwise;
}

}  // namespace secular::testing_support
