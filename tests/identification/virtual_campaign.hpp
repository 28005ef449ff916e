#pragma once

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "estimator/identification/estimate.hpp"
#include "estimator/model/by_name.hpp"
#include "generated/registry.hpp"
#include "measure/observe/modal_projection.hpp"
#include "tests/places.hpp"
#include "tests/sensor_noise.hpp"
#include "tests/simulate/simulated_campaign.hpp"

// Virtual tests in memory and what is identified from them.
namespace secular::testing_support {

inline const EstimatedValue& value_of(const Estimate& estimate, const std::string& name) {
  for (const auto* list : {&estimate.parameters, &estimate.lumps})
    for (const EstimatedValue& v : *list)
      if (v.name == name && (v.value || list == &estimate.lumps)) return v;
  for (const EstimatedValue& v : estimate.parameters)
    if (v.name == name) return v;
  throw std::out_of_range(name);
}

inline double truth_of(const CompiledModel& model, const CompiledCase& resonance, const Eigen::VectorXd& parameters,
                       const std::string& name) {
  if (const auto place = place_of(model.symbols, name)) return parameters(static_cast<Eigen::Index>(*place));
  std::vector<double> lumps(resonance.lumps.size());
  resonance.evaluate_lumps(parameters.data(), lumps.data());
  if (const auto place = place_of(resonance.lumps, name)) return lumps[*place];
  throw std::out_of_range(name);
}

inline Experiment shipped_experiment(const std::string& name) {
  const auto path = source_folder() / "models/experiments" / (name + ".toml");
  return read_experiment(path, *generated::find_compiled_model(experiment_model(path)));
}

/// Observations of the records of a simulated campaign that belong to a case: all dwells, or all decays.
inline ObservationSet observed(const SimulatedCampaign& simulated, const CompiledModel& model,
                               const CompiledCase& resonance) {
  const RecordReader read = [&](std::size_t r) { return simulated.samples[r]; };
  return resonance.excited ? observe_dwells(simulated.campaign, read, model, resonance, {})
                           : observe_free_decays(simulated.campaign, read, model, resonance, {});
}

inline bool warns(const std::vector<std::string>& warnings, const std::string& text) {
  for (const std::string& warning : warnings)
    if (warning.find(text) != std::string::npos) return true;
  return false;
}

}  // namespace secular::testing_support
