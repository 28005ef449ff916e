#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "generated/registry.hpp"
#include "measure/observe/modal_projection.hpp"
#include "measure/observe/observation_set.hpp"
#include "motion/simulate/noise.hpp"
#include "motion/simulate/virtual_test.hpp"
#include "tests/places.hpp"

namespace secular::testing_support {

/// A shipped experiment simulated once without noise; every seed adds the noise of its sensors to the samples.
class NoisyCampaign {
 public:
  explicit NoisyCampaign(Experiment experiment)
      : model_(*generated::find_compiled_model(experiment.model)), experiment_(std::move(experiment)) {
    Experiment quiet = experiment_;
    quiet.excitation->noise_sd = 0;
    for (SimulatedChannel& response : quiet.responses) response.noise_sd = 0;
    simulated_ = run_virtual_test(quiet, model_, 1, 2);
    for (const CompiledCase& c : model_.cases)
      if (c.name == "principal_parametric") resonance_ = &c;
  }

  static Experiment shipped(const std::string& name) {
    const std::filesystem::path path = source_folder() / "models/experiments" / (name + ".toml");
    return read_experiment(path, *generated::find_compiled_model(experiment_model(path)));
  }

  ObservationSet observe(std::uint64_t seed) const {
    const RecordReader read = [&](std::size_t r) {
      Record record = simulated_.samples[r];
      for (std::size_t c = 0; c < record.channels.size(); ++c) {
        NoiseStream noise(seed, r, c);
        const double sd = c == 0 ? experiment_.excitation->noise_sd : experiment_.responses[c - 1].noise_sd;
        for (double& x : record.channels[c]) x += sd * noise.gaussian();
      }
      return record;
    };
    return observe_dwells(simulated_.campaign, read, model_, *resonance_, {});
  }

  std::string unit() const { return modal_projection(simulated_.campaign, model_).unit; }
  const CompiledModel& model() const { return model_; }
  const CompiledCase& resonance() const { return *resonance_; }
  const Experiment& experiment() const { return experiment_; }

 private:
  const CompiledModel& model_;
  Experiment experiment_;
  SimulatedCampaign simulated_;
  const CompiledCase* resonance_ = nullptr;
};

}  // namespace secular::testing_support
