#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "estimator/campaign/campaign.hpp"
#include "estimator/identification/estimate.hpp"
#include "estimator/identification/observation_set.hpp"
#include "simulate/held_out.hpp"

namespace secular::app {

struct IdentificationRequest {
  std::string campaign, model, resonance;  ///< resonance empty: chosen from the records
  bool interpret = false;                  ///< never use compiled code of the model
  Window window;
  std::map<std::string, double> fixed;
  unsigned threads = 1;
};

/// Everything that a run of `identify` found, before it is written.
struct Identification {
  Campaign campaign;
  std::shared_ptr<const CompiledModel> model;
  const CompiledCase* resonance = nullptr;
  ObservationSet measured;
  ObservationSet replayed;  ///< what the full equations do at the estimated parameters; empty if that failed
  Estimate estimate;
  std::vector<HeldOutPrediction> held_out;
  std::string coordinate_unit;
  std::vector<std::string> excitation_units;
};

/// Observations, regression, correction for the expansion's truncation, prediction of what was held out.
Identification identify(const IdentificationRequest& request);

}  // namespace secular::app
