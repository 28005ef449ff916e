#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "estimator/model/by_name.hpp"
#include "generated/registry.hpp"
#include "measure/observe/modal_projection.hpp"
#include "measure/observe/observation_set.hpp"
#include "tests/places.hpp"
#include "tests/sensor_noise.hpp"
#include "tests/simulate/simulated_campaign.hpp"

namespace secular::testing_support {

/// A shipped experiment simulated once without noise; every seed adds the noise of its sensors to the samples.
class NoisyCampaign {
 public:
  explicit NoisyCampaign(Experiment experiment)
      : model_(*generated::find_compiled_model(experiment.model)), experiment_(std::move(experiment)) {
    simulated_ = run_virtual_test(without_noise(experiment_), model_, 1, 2);
    resonance_ = &case_named(model_, "principal_parametric");
  }

  static Experiment shipped(const std::string& name) {
    const std::filesystem::path path = source_folder() / "models/experiments" / (name + ".toml");
    return read_experiment(path, *generated::find_compiled_model(experiment_model(path)));
  }

  ObservationSet observe(std::uint64_t seed) const {
    const RecordReader read = [&](std::size_t r) {
      return with_sensor_noise(simulated_.samples[r], experiment_, seed, r);
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
