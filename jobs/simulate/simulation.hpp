#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "jobs/shared/model_loading.hpp"
#include "measure/data/campaign_writer.hpp"

namespace secular {

struct SimulationRequest {
  std::string experiment;  ///< file, or experiments/NAME of a shipped one
  std::uint64_t seed = 1;  ///< of the measurement noise
  unsigned threads = 1;    ///< records computed at once; the result does not depend on it
  bool interpret = false;  ///< no compiled code of the model
  NoteSink note = {};      ///< of loading the model
  std::function<void(std::size_t done, std::size_t total)> progress = {};  ///< records
};

/// Name of the model and text of an experiment as requests name it. Throws InputError.
struct ExperimentText {
  std::string model, text;
};
ExperimentText experiment_text(const std::string& experiment);

/// The job `simulate`: a virtual test on the full equations of motion. `sink` gets every record once it is
/// computed, from any thread; what is returned has no samples. Throws InputError.
Campaign simulate(const SimulationRequest& request, const RecordSink& sink);

}  // namespace secular
