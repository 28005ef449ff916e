#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "diagnose/verdict/full_estimate.hpp"
#include "estimator/identification/estimate.hpp"
#include "estimator/identification/record_lateness.hpp"
#include "jobs/identify/decay_refinement.hpp"
#include "jobs/identify/following_estimates.hpp"
#include "jobs/shared/model_loading.hpp"
#include "measure/data/campaign.hpp"
#include "measure/disturbances/disturbance.hpp"
#include "measure/observe/observation_set.hpp"
#include "motion/correction/held_out.hpp"

namespace secular {

/// The equations that numbers come from.
enum class Equations {
  modulation,  ///< of each resonance case: dwells, free decays, tables of lines
  full,        ///< of motion: records of any kind, in one likelihood
  both         ///< of each resonance case, and from there of motion: free decays alone
};

/// As --by names them: "full-equations", "modulation-equations", "both-equations".
Equations equations_named(const std::string& name);

struct IdentificationRequest {
  std::string model;                    ///< as ModelSource takes it
  std::vector<std::string> resonances;  ///< cases; empty: chosen from the records
  bool interpret = false;               ///< never use compiled code of the model
  Window window;
  std::map<std::string, double> fixed;
  unsigned threads = 1;
  int bootstrap = 0;                 ///< resamples of the conditions
  bool refine = false;               ///< maximum likelihood with errors in everything measured
  std::uint64_t seed = 1;            ///< of the bootstrap
  std::optional<Equations> by = {};  ///< none: chosen from the records
  NoteSink note = {};                ///< of loading the model
  SearchProgress progress = {};      ///< of the full equations: fits so far, of about how many
};

/// Everything that a run of `identify` found, before it is written.
struct Identification {
  Campaign campaign;
  std::shared_ptr<const CompiledModel> model;
  std::vector<ObservationSet> measured;  ///< by case
  /// What the full equations do at the estimated parameters, by case; observations empty if that failed.
  std::vector<ObservationSet> replayed;
  Estimate estimate;
  /// By the full equations, which have no cases, observations and lumps. Its estimate and disturbances are those
  /// beside it.
  std::optional<FullEstimate> full;
  /// Of free decays alone, whose equations the user leaves to the program.
  std::optional<DecayRefinement> refinement;
  std::vector<FollowingEstimate> following;  ///< where all that they follow from is estimated
  std::vector<HeldOutPrediction> held_out;
  /// The first few decays of one mode in one piece, over what was fitted: for reports.
  std::vector<HeldOutPrediction> followed;
  std::vector<CaseLateness> lateness;  ///< by case whose records are out of step with their excitation
  /// By case: what free phases made of its records, whether or not its equations hold then.
  std::vector<CaseLateness> freed;
  std::vector<Disturbance> disturbances;  ///< in the records that were read; of files alone
  std::size_t looked_at = 0;              ///< records
  std::string coordinate_unit;
  std::vector<std::string> excitation_units;
  std::vector<std::pair<std::string, double>> seconds;  ///< wall time by stage
  std::optional<std::string> mostly_left_out;           ///< see mostly_left_out()
};

/// The job `identify`: by the equations that are asked for, or by those that the records need. Throws InputError
/// (options that those equations have no meaning for included) and NumericalFailure.
Identification identify(const IdentificationRequest& request, const Campaign& campaign);

/// By the modulation equations: every record goes to the case whose resonance it excites (decays to cases of one
/// free mode); then observations, one regression of all cases, correction for the expansion's truncation,
/// prediction of what was held out.
Identification identify_by_modulation(const IdentificationRequest& request, const Campaign& campaign);

/// The same with records that `read` gives.
Identification identify_by_modulation(const IdentificationRequest& request, const Campaign& measured,
                                      const RecordReader& read);

/// Of free decays of one mode, what the full equations at the estimate make of them: `held_out` and `followed`
/// anew.
void follow_decays(const IdentificationRequest& request, const RecordReader& read, Identification& id);

/// What follows the observations: `id` holds campaign, model and what was measured, and gets the estimate, the
/// replays and the units.
void estimate_observed(const IdentificationRequest& request, Identification& id);

}  // namespace secular
