#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "estimator/planning/dwell_information.hpp"
#include "estimator/planning/exchange.hpp"
#include "estimator/planning/response_candidates.hpp"
#include "jobs/shared/model_loading.hpp"
#include "jobs/shared/parameter_file.hpp"
#include "measure/data/campaign.hpp"
#include "measure/observe/observation_set.hpp"
#include "motion/simulate/experiment.hpp"
#include "report/figure.hpp"

namespace secular {

struct PlanRequest {
  std::string model, resonance;          ///< as ModelSource takes them
  std::string parameters;                ///< as read_parameter_file takes it, or what messages call `given`
  std::optional<GivenParameters> given;  ///< in place of a file
  std::vector<std::string> wanted;
  std::vector<std::string> fixed;                  ///< lumps and frequencies taken as known
  DesignCriterion criterion = DesignCriterion::d;  ///< of a plan with a budget
  double noise = 0.05, excitation_noise = 0.05, dwell_scatter = 0;
  double sample_rate_hz = 256, ensemble_s = 4;
  std::vector<int> ensembles = {2, 5, 10, 20, 40};
  double lowest_hz = 0, highest_hz = 0, lowest_amplitude = 0, highest_amplitude = 0;
  int frequencies = 40, levels = 8;
  double settled = 1e-3, settle_limit_s = 600;
  std::optional<double> budget_s;
  std::optional<int> least;  ///< dwells; without it as many as error bars from the scatter between dwells need
  std::string against;       ///< experiment or campaign, or what messages call `campaign`
  std::optional<Campaign> campaign;  ///< that one, in place of a folder
  Window against_records;            ///< of a campaign
  double limit_s = 600;              ///< wall time of the search
  /// Of the stages of the search (`what` is counted, in the plural); `done` may come many times.
  std::function<void(const char* what, std::size_t done, std::size_t total)> progress{};
  NoteSink note = {};  ///< of loading the model
};

/// A dwell of a plan or of a programme in use.
struct PlannedDwell {
  double frequency_hz = 0, amplitude = 0;
  int ensembles = 0;
  double settle_s = 0, needed_s = 0;  ///< as programmed, and until the response has settled; equal in a plan
  bool responds = true;
  DwellCandidate candidate;
};

struct Programme {
  std::string name;
  std::vector<PlannedDwell> dwells;
  double time_s = 0;          ///< settling as programmed
  double settled_time_s = 0;  ///< settling as needed, by the same rule for plan and programme
  Eigen::VectorXd sd;         ///< [unknown] predicted
};

struct PlanResult {
  std::shared_ptr<const CompiledModel> model;
  const CompiledCase* resonance = nullptr;
  Eigen::VectorXd parameters;  ///< by symbol
  PlanUnknowns unknowns;
  std::vector<std::string> units;  ///< [unknown]
  std::vector<Eigen::Index> wanted;
  PlanningNoise noise;
  std::vector<DwellCandidate> candidates;
  Programme plan;
  std::optional<Programme> against;
  std::optional<Experiment> sensors;  ///< of the experiment in use
  std::optional<Campaign> channels;   ///< of the experiment or campaign in use, without its records
  std::string coordinate_unit;        ///< of responses
  double budget_s = 0;
  bool meets_target = true;  ///< every wanted deviation at or below that of `against` (where no budget was given)
  std::vector<std::string> warnings;
};

/// The job `plan`. Throws InputError for whatever in the request makes no sense, and NumericalFailure after
/// limit_s.
PlanResult plan_test(const PlanRequest& request);

/// Every stable response that was a candidate, and the dwells chosen among them.
report::Figure plan_figure(const PlanResult& plan);

/// plan.json and report.html; `command`: the command line, printed at the page's foot.
std::string plan_json(const PlanRequest& request, const PlanResult& plan);
std::string plan_report(const PlanRequest& request, const PlanResult& plan, const std::string& command);
/// An experiment file for `secular simulate`.
std::string plan_experiment(const PlanRequest& request, const PlanResult& plan);

}  // namespace secular
