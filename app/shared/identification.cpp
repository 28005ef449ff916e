#include "app/shared/identification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

#include "app/shared/model_loading.hpp"
#include "app/shared/record_assignment.hpp"
#include "app/shared/record_selection.hpp"
#include "app/shared/scatter_output.hpp"
#include "estimator/identification/unsupported_values.hpp"
#include "estimator/model/by_name.hpp"
#include "input/input_error.hpp"
#include "input/numerical_failure.hpp"
#include "measure/disturbances/disturbance_watch.hpp"
#include "measure/observe/modal_projection.hpp"
#include "measure/observe/steady_amplitude.hpp"
#include "motion/correction/replay.hpp"
#include "motion/correction/truncation_correction.hpp"
#include "numerics/hertz.hpp"

namespace secular::app {
namespace {

// Wall time by stage.
class StageClock {
 public:
  explicit StageClock(std::vector<std::pair<std::string, double>>& seconds) : seconds_(seconds) {}

  /// Time since the last call belongs to this stage.
  void done(const std::string& stage) {
    const auto now = std::chrono::steady_clock::now();
    const double passed = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    for (auto& [name, sum] : seconds_)
      if (name == stage) {
        sum += passed;
        return;
      }
    seconds_.emplace_back(stage, passed);
  }
  /// Time since the last call belongs to none.
  void skip() { last_ = std::chrono::steady_clock::now(); }

 private:
  std::vector<std::pair<std::string, double>>& seconds_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

std::size_t count_of_conditions(const std::vector<ObservationSet>& sets) {
  std::size_t count = 0;
  for (const ObservationSet& set : sets) {
    std::set<int> conditions;
    for (const Observation& o : set.observations) conditions.insert(o.condition);
    count += conditions.size();
  }
  return count;
}

// Lumps of few conditions may lead to no finite parameters at all.
Estimate first_estimate(const Identification& id, const MeasuredUnits& units, const EstimateOptions& options) {
  try {
    return estimate(id.measured, units, options, pass_between());
  } catch (const NothingObserved&) {
    throw;  // no conditions to speak of
  } catch (const NumericalFailure& failure) {
    const std::size_t conditions = count_of_conditions(id.measured);
    throw NumericalFailure(
        failure.ending(),
        fmt::format("{}: {} condition{} of it determine{} no parameters of {} ({}); dwells at several levels and "
                    "frequencies around the resonance may",
                    id.campaign.folder.string(), conditions, conditions == 1 ? "" : "s", conditions == 1 ? "s" : "",
                    id.model->name, failure.what()));
  }
}

}  // namespace

Identification identify(const IdentificationRequest& request) {
  const Campaign campaign = read_campaign(request.campaign);
  DisturbanceWatch watch(campaign);
  SelectedRecords reader(campaign, request.window, watch.look());
  reader.leave_clipped_out();
  Identification result = identify(request, campaign, [&](std::size_t r) { return reader.read(r); });
  for (std::string& warning : reader.warnings()) result.estimate.warnings.push_back(std::move(warning));
  result.disturbances = watch.found();
  list_clipped_as_left_out(result.disturbances);
  for (Disturbance& scatter : scatter_disturbances(result)) result.disturbances.push_back(std::move(scatter));
  result.looked_at = watch.records();
  return result;
}

Identification identify(const IdentificationRequest& request, const Campaign& measured, const RecordReader& read) {
  Identification result;
  StageClock clock(result.seconds);
  const ModelSource source(request.model, request.interpret);
  for (const std::string& name : request.resonances) source.case_named(name);
  result.campaign = measured;
  const Campaign& campaign = result.campaign;
  std::vector<double> nominal = source.nominal_frequencies();
  nominal.resize(source.modes());
  const FrequencyStarts starts =
      frequency_starts(source, campaign, read, nominal, request.resonances, request.window);
  const Assignment assignment = assign_records(source, campaign, starts, request.resonances, request.window);
  result.model = with_starts(source.load(assignment.names), starts);
  const CompiledModel& model = *result.model;
  clock.done("model");
  for (std::size_t c = 0; c < assignment.names.size(); ++c) {
    const CompiledCase& resonance = case_named(model, assignment.names[c]);
    Window window = request.window;
    window.chosen = assignment.records[c];
    window.threads = request.threads;
    result.measured.push_back(resonance.excited ? observe_dwells(campaign, read, model, resonance, window)
                                                : observe_free_decays(campaign, read, model, resonance, window));
  }
  clock.done("observation");
  estimate_observed(request, result);
  for (const auto* warnings : {&assignment.warnings, &starts.warnings})
    result.estimate.warnings.insert(result.estimate.warnings.begin(), warnings->begin(), warnings->end());
  clock.skip();
  try {
    for (const ObservationSet& set : result.measured)
      if (!set.resonance->excited && model.modes() == 1)
        for (std::size_t r = 0; r < campaign.records.size(); ++r)
          if (auto prediction =
                  predict_held_out_decay(campaign, read, set, r, result.estimate.parameter_values, request.window))
            result.held_out.push_back(std::move(*prediction));
  } catch (const NumericalFailure& failure) {
    result.estimate.warnings.push_back(std::string("what was held out could not be predicted (") + failure.what() +
                                       ")");
  }
  clock.done("held out");
  return result;
}

namespace {

// Phases at truncated equations, then at corrected ones: each round leaves the square of what was left.
constexpr int most_phase_rounds = 4;

EstimateOptions options_of(const IdentificationRequest& request) {
  EstimateOptions options;
  options.fixed = request.fixed;
  options.bootstrap = request.bootstrap;
  options.seed = request.seed;
  options.refine = request.refine;
  options.threads = request.threads;
  return options;
}

// Corrected for the expansion's truncation, if that is possible. Returns what equations it was estimated from, with
// the truncation taken out; nothing where that was not possible.
std::vector<ObservationSet> estimate_corrected(const IdentificationRequest& request, Identification& id) {
  StageClock clock(id.seconds);
  const MeasuredUnits units{id.coordinate_unit, id.excitation_units};
  const EstimateOptions options = options_of(request);
  Estimate raw = first_estimate(id, units, options);
  clock.done("regression");
  const auto replay = [&](const ObservationSet& set, const Eigen::VectorXd& parameters) {
    return observe_replay(id.campaign, set, parameters, request.threads);
  };
  try {
    TruncationCorrection correction =
        correct_truncation(id.measured, raw, units, options, replay, [&](const char* stage) { clock.done(stage); });
    id.estimate = std::move(correction.estimate);
    id.measured = std::move(correction.measured);
    id.replayed = std::move(correction.replayed);
    for (ObservationSet& set : id.replayed)
      if (set.resonance->excited) to_steady_amplitudes(set, id.estimate.parameter_values);
    return std::move(correction.corrected);
  } catch (const NumericalFailure& failure) {
    id.replayed = id.measured;
    for (ObservationSet& set : id.replayed) set.observations.clear();
    id.estimate = estimate(id.measured, units, options, {.judge_fit = false, .start = raw.state});
    id.estimate = with_failed_correction(std::move(id.estimate), failure.what());
    return {};
  }
}

// Why an estimate without phases came to no result; empty: it did. Without them nothing may be left to estimate
// from.
std::string failure_of(const std::function<void()>& estimate) {
  try {
    estimate();
  } catch (const NumericalFailure& failure) {
    return failure.what();
  }
  return "";
}

// Numbers that the other sign of a case's excitation moves are doubtful, all of them where that cannot be
// estimated. `before`: with phases as measured.
void doubt_by_rival(const IdentificationRequest& request, const UnknownPhases& unknown, UnknownPhases::Rival& rival,
                    const Identification& before, Estimate& estimate) {
  Identification other = before;
  other.measured = unknown.sets;
  other.measured[rival.place] = std::move(rival.set);
  const std::string failure = failure_of([&] { estimate_corrected(request, other); });
  if (failure.empty()) return doubt_what_differs(estimate, other.estimate);
  doubt_all(estimate);
  estimate.warnings.push_back(
      fmt::format("what the other sign of the excitation would make of the numbers cannot be said ({}): all are "
                  "doubtful",
                  failure));
}

// Once more with phases as unknowns where equations do not hold. Numbers stay as they were, and those that this
// moves are doubtful, where it is no explanation: equations still do not hold, or phases follow a law of the
// amplitude. Where it is one, those that the other sign of the excitation moves are doubtful if that is not
// determined. `id` is as it was if this throws.
void free_phases(const IdentificationRequest& request, const std::vector<ObservationSet>& observed,
                 Identification& id) {
  const MeasuredUnits units{id.coordinate_unit, id.excitation_units};
  const EstimateOptions options = options_of(request);
  UnknownPhases unknown = find_unknown_phases(observed, units, options, id.estimate);
  std::vector<CaseLateness> found = unknown.cases;
  const auto is_freed = [](const CaseLateness& lateness) { return lateness.finding != PhaseFinding::nothing_told; };
  if (std::any_of(unknown.cases.begin(), unknown.cases.end(), is_freed)) {
    Identification freed = id;
    const auto estimate_freed = [&] {
      freed.measured = unknown.sets;
      return estimate_corrected(request, freed);
    };
    std::vector<ObservationSet> corrected = estimate_freed();
    for (int round = 1;
         round < most_phase_rounds && refine_phases(unknown, corrected, units, options, freed.estimate); ++round)
      corrected = estimate_freed();
    found = unknown.cases;
    const std::set<std::string> not_fitting = cases_with_lack_of_fit(freed.estimate);
    // Phases that are right leave numbers that agree with one another and with the full equations.
    const bool agrees = !corrected.empty() && !freed.estimate.consistency.significant;
    bool explained = true;
    for (CaseLateness& lateness : unknown.cases) {
      if (lateness.finding == PhaseFinding::shifted && (!agrees || not_fitting.contains(lateness.resonance)))
        lateness.finding = PhaseFinding::in_part;
      explained = explained && (lateness.finding == PhaseFinding::shifted || !is_freed(lateness));
    }
    if (explained) {
      for (UnknownPhases::Rival& rival : unknown.rivals)
        doubt_by_rival(request, unknown, rival, id, freed.estimate);
      id = std::move(freed);
    } else {
      doubt_what_differs(id.estimate, freed.estimate);
      std::erase_if(unknown.cases, [](const CaseLateness& l) { return l.finding == PhaseFinding::shifted; });
    }
  }
  for (const CaseLateness& lateness : unknown.cases) {
    id.estimate.warnings.push_back(text_of(lateness));
    if (!is_freed(lateness))
      take_out(id.estimate, {lateness.resonance}, "phases do not hold, and nothing determines it without them");
  }
  id.lateness = std::move(unknown.cases);
  id.freed = found;
}

}  // namespace

void estimate_observed(const IdentificationRequest& request, Identification& id) {
  id.coordinate_unit = modal_projection(id.campaign, *id.model).unit;
  id.excitation_units.clear();
  if (std::any_of(id.measured.begin(), id.measured.end(),
                  [](const ObservationSet& s) { return s.resonance->excited; }))
    for (const std::size_t channel : excitation_channels(id.campaign, *id.model))
      id.excitation_units.push_back(id.campaign.channels[channel].unit);
  const std::vector<ObservationSet> observed = id.measured;
  try {
    estimate_corrected(request, id);
  } catch (const NothingObserved& nothing) {  // here it is the campaign itself
    throw InputError(id.campaign.folder.string(), "", nothing.what());
  }
  const std::string failure = failure_of([&] { free_phases(request, observed, id); });
  if (!failure.empty())  // the numbers with phases as measured stay
    id.estimate.warnings.push_back(fmt::format("whether records are late was not found out: {}", failure));
}

}  // namespace secular::app
