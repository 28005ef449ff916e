#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "estimator/identification/estimate.hpp"
#include "estimator/identification/record_lateness.hpp"
#include "measure/data/campaign.hpp"
#include "measure/disturbances/disturbance.hpp"
#include "measure/observe/observation_set.hpp"
#include "motion/correction/held_out.hpp"

namespace secular::app {

struct IdentificationRequest {
  std::string campaign, model;
  std::vector<std::string> resonances;  ///< cases; empty: chosen from the records
  bool interpret = false;               ///< never use compiled code of the model
  Window window;
  std::map<std::string, double> fixed;
  unsigned threads = 1;
  int bootstrap = 0;       ///< resamples of the conditions
  bool refine = false;     ///< maximum likelihood with errors in everything measured
  std::uint64_t seed = 1;  ///< of the bootstrap
};

/// Everything that a run of `identify` found, before it is written.
struct Identification {
  Campaign campaign;
  std::shared_ptr<const CompiledModel> model;
  std::vector<ObservationSet> measured;  ///< by case
  /// What the full equations do at the estimated parameters, by case; observations empty if that failed.
  std::vector<ObservationSet> replayed;
  Estimate estimate;
  std::vector<HeldOutPrediction> held_out;
  std::vector<CaseLateness> lateness;     ///< by case whose records are out of step with their excitation
  /// By case: what free phases made of its records, whether or not its equations hold then.
  std::vector<CaseLateness> freed;
  std::vector<Disturbance> disturbances;  ///< in the records that were read; of files alone
  std::size_t looked_at = 0;              ///< records
  std::string coordinate_unit;
  std::vector<std::string> excitation_units;
  std::vector<std::pair<std::string, double>> seconds;  ///< wall time by stage
};

/// Every record goes to the case whose resonance it excites (decays to cases of one free mode); then observations,
/// one regression of all cases, correction for the expansion's truncation, prediction of what was held out.
Identification identify(const IdentificationRequest& request);

/// The same for records that are not in files: `request.campaign` is not read.
Identification identify(const IdentificationRequest& request, const Campaign& measured, const RecordReader& read);

/// What follows the observations: `id` holds campaign, model and what was measured, and gets the estimate, the
/// replays and the units.
void estimate_observed(const IdentificationRequest& request, Identification& id);

}  // namespace secular::app
