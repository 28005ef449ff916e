#include "jobs/identify/identification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "estimator/identification/even_sensor.hpp"
#include "estimator/identification/other_estimate.hpp"
#include "estimator/identification/unsupported_values.hpp"
#include "estimator/model/by_name.hpp"
#include "input/input_error.hpp"
#include "input/numerical_failure.hpp"
#include "jobs/identify/scatter_output.hpp"
#include "jobs/shared/model_loading.hpp"
#include "jobs/shared/record_assignment.hpp"
#include "jobs/shared/record_selection.hpp"
#include "measure/disturbances/disturbance_watch.hpp"
#include "measure/observe/modal_projection.hpp"
#include "motion/correction/cubic_sensor.hpp"
#include "motion/correction/decay_harmonics.hpp"
#include "motion/correction/free_phases.hpp"
#include "motion/correction/gain_drift.hpp"
#include "motion/correction/gain_step.hpp"
#include "motion/correction/low_pass.hpp"

namespace secular {
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

/// Decays that are followed.
constexpr std::size_t most_followed = 3;

/// What the full equations make of a decay: where it was held out, and in one piece where it was fitted.
void take_decay(const IdentificationRequest& request, const RecordReader& read, std::size_t record,
                const ObservationSet& set, Identification& result) {
  const Eigen::VectorXd& parameters = result.estimate.parameter_values;
  if (auto prediction = predict_held_out_decay(result.campaign, read, set, record, parameters, request.window))
    result.held_out.push_back(std::move(*prediction));
  if (result.followed.size() == most_followed) return;
  if (auto followed = follow_decay(result.campaign, read, set, record, parameters))
    result.followed.push_back(std::move(*followed));
}

EstimateOptions options_of(const IdentificationRequest& request) {
  EstimateOptions options;
  options.fixed = request.fixed;
  options.bootstrap = request.bootstrap;
  options.seed = request.seed;
  options.refine = request.refine;
  options.threads = request.threads;
  return options;
}

/// What numbers are allowed where they may be those of `other`, in words. `without`: of what the other is free.
/// `share`: how much of what they move by.
std::string allow_for(Estimate& estimate, const std::string& without, const std::function<Estimate()>& other,
                      double share = 1) {
  try {
    allow_for_other(estimate, other(), "it moves where " + without + " is taken off", share);
    return "numbers are allowed what they move by where that is taken off";
  } catch (const NumericalFailure&) {
    doubt_all(estimate, "nothing can be identified where " + without + " is taken off");
    return "where that is taken off nothing can be identified, so that no number is sure";
  }
}

/// The same of an estimate from the observations without a part that `take_off` takes off each set of them.
template <class TakeOff>
std::string allow_for_estimate_without(const std::string& part, const std::vector<ObservationSet>& observed,
                                       const EstimateTask& task, Estimate& estimate, const TakeOff& take_off) {
  std::vector<ObservationSet> without;
  for (const ObservationSet& set : observed) without.push_back(take_off(set));
  return allow_for(estimate, part, [&] { return estimate_with_phases(without, task).of.estimate; });
}

/// Equal poles of a low-pass, until harmonics and the amplitudes' course with frequency do not exclude it.
constexpr int numbers_of_poles[] = {1, 4, 16, 64};

/// What makes all records late alike may be a low-pass, which takes amplitude off, too. docs/inference.md (71),
/// (72).
void judge_lateness(const EstimateTask& task, Identification& id) {
  auto filter = shared_low_pass(id.lateness, id.measured);
  for (const int poles : numbers_of_poles) {
    if (!filter) return;
    filter->poles = poles;
    bool holds = true;
    const std::string allowed = allow_for(id.estimate, "a low-pass that makes records late", [&] {
      Estimate other = estimate_corrected(before_poles(id.measured, *filter), task).estimate;
      holds = cases_with_lack_of_fit(other).empty() && !other.consistency.significant;
      return holds ? other : id.estimate;
    });
    if (!holds) continue;
    const char* const channel = filter->late_s < 0 ? "excitation" : "responses";
    id.estimate.warnings.push_back(fmt::format(
        "all records are late alike, as a low-pass in the {} makes them: one of {} takes {:.2g} % off amplitudes "
        "(steeper ones less, a mere delay nothing), and nothing tells that it is none: {}. Pass both through "
        "filters "
        "alike, or take out of the {} what the filter does",
        channel, poles == 1 ? "a single pole" : fmt::format("{} equal poles", poles),
        100 * (1 - filter->amplitude()), allowed, channel));
    return;
  }
}

/// Means that grow as the square of the motion are a sensor's, whose second harmonics are wrong, too.
/// docs/inference.md (73), (74).
void judge_means(const std::vector<ObservationSet>& observed, const RecordReader& read, const Window& window,
                 const EstimateTask& task, Identification& id) {
  const auto sensor = even_sensor(id.campaign, read, observed, window);
  if (!sensor) return;
  const std::string allowed =
      allow_for_estimate_without("the even part of a sensor's law", observed, task, id.estimate,
                                 [&](const ObservationSet& set) { return without_even_part(set, *sensor); });
  id.estimate.warnings.push_back(fmt::format(
      "case {}: the mean of {} grows as the square of its motion, where a lasting motion has none. A sensor that "
      "is not "
      "linear makes that, and {:.2g} % of second harmonic with it at the largest motion: {}",
      sensor->resonance->name, id.model->coordinates[sensor->mode], 100 * std::abs(sensor->second), allowed));
}

/// Third harmonics that neither model nor excitation makes may be those of a sensor whose amplitudes are wrong,
/// too: numbers are allowed what they move by where its law is taken off. docs/inference.md (56), (57).
void judge_sensor(const std::vector<ObservationSet>& observed, const EstimateTask& task, int derivatives,
                  Identification& id) {
  const auto sensor = cubic_sensor(id.measured, id.estimate, derivatives, task.options.threads);
  if (!sensor) return;
  const std::string allowed =
      allow_for_estimate_without("the cubic part of a sensor's law", observed, task, id.estimate,
                                 [&](const ObservationSet& set) { return without_cubic_part(set, *sensor); });
  id.estimate.warnings.push_back(fmt::format(
      "case {}: beyond what model and excitation make, the responses' third harmonic grows as the cube "
      "of the motion, to {:.2g} % of it, as that of a sensor which is not linear. Such a sensor's amplitudes are "
      "{:.2g} % off there: {}. Where it is the structure's (a law that the model lacks), `secular diagnose` looks "
      "for it",
      sensor->resonance->name, 100 * std::abs(sensor->third), 300 * std::abs(sensor->third), allowed));
}

// Says what came of one of several faults, once.
void add_clause(std::string& all, const std::string& one) {
  if (all.find(one) == std::string::npos) all += (all.empty() ? "" : "; ") + one;
}

// What is taken off, and how large it is, in words.
std::pair<std::string, std::string> words_of(const SizedFault& fault) {
  const double percent = 100 * std::abs(fault.size);
  switch (fault.kind) {
    case ChainFault::even_law: {
      const std::string told =
          fault.coupling_s > 0
              ? fmt::format(", which means show behind an AC coupling with its corner at {:.2g} Hz",
                            0.5 / (std::numbers::pi * fault.coupling_s))
          : fault.shows_mean && fault.derivatives > 0 ? ", which means show"
                                                      : "";
      return {"the even part of a sensor's law",
              fmt::format("an even part of a sensor's law, {:.2g} % of second harmonic at the largest motion{}",
                          percent, told)};
    }
    case ChainFault::cubic_law:
      return {
          "the cubic part of a sensor's law",
          fmt::format("a cubic part of a sensor's law, {:.2g} % of third harmonic at the largest motion", percent)};
    default: {
      const std::string kind = fault.kind == ChainFault::low_pass ? "a low-pass" : "a high-pass";
      const std::string poles = fault.poles == 1 ? "a single pole" : fmt::format("{} equal poles", fault.poles);
      const std::string does =
          fault.kind == ChainFault::low_pass
              ? fmt::format("takes {:.2g} % off amplitudes", 100 * (1 - fault.filter().amplitude()))
              : fmt::format("turns the motion by {:.2g} degrees",
                            180 / std::numbers::pi * fault.poles * std::atan(fault.size / fault.poles));
      return {kind + " in the responses", fmt::format("{} of {} in the responses that {}", kind, poles, does)};
    }
  }
}

/// Harmonics of decays that the model does not make may be the measuring chain's, whose amplitudes are wrong, too.
/// docs/inference.md (61), (62).
void judge_decays(const std::vector<FoundFault>& faults, const std::vector<ObservationSet>& observed,
                  const EstimateTask& task, Identification& id) {
  std::string made_by, allowed;
  for (const FoundFault& one : faults) {
    const auto [part, words] = words_of(one.fault);
    made_by += (made_by.empty() ? "" : ", or ") + words;
    add_clause(allowed,
               allow_for(
                   id.estimate, part,
                   [&] { return estimate_with_phases(without_fault(observed, one.fault), task).of.estimate; },
                   one.counts));
  }
  if (!faults.empty())
    id.estimate.warnings.push_back(
        fmt::format("harmonics of the decays, or means that follow their motion, are not those that the model "
                    "makes of it. What may have made them: {}; {}. "
                    "Where it is the structure's (a law that the model lacks), `secular diagnose` looks for it",
                    made_by, allowed));
}

/// A step of the sensitivity in a decay: either of the two may be the right one. docs/inference.md (63).
void judge_step(const std::optional<GainStep>& step, const std::vector<ObservationSet>& observed,
                const EstimateTask& task, Identification& id) {
  if (!step) return;
  std::string allowed;
  for (const RightGain right : {RightGain::before, RightGain::behind})
    add_clause(allowed,
               allow_for(
                   id.estimate, "a step of the sensitivity",
                   [&] { return estimate_with_phases(with_one_gain(observed, *step, right), task).of.estimate; },
                   step->counts));
  id.estimate.warnings.push_back(fmt::format(
      "{}: the amplitude steps by {:.2g} % at {:.4g} s and the phase does not, as where a sensitivity changes: {}. "
      "--to or --from leave one side of it",
      id.campaign.records[step->record].file, 100 * std::expm1(step->size), step->at_s, allowed));
}

/// A sensitivity that drifts in every dwell alike: the one at their begin may be the right one. docs/inference.md
/// (64).
void judge_drift(const std::vector<ObservationSet>& observed, const EstimateTask& task, Identification& id) {
  const auto drift = gain_drift(id.measured);
  if (!drift) return;
  const std::string allowed =
      allow_for_estimate_without("a drift of the sensitivity", observed, task, id.estimate,
                                 [&](const ObservationSet& set) { return with_first_gain(set, *drift); });
  id.estimate.warnings.push_back(fmt::format(
      "amplitudes over their excitation change by {:.2g} % along every dwell alike, as where a sensitivity "
      "drifts: {}",
      100 * std::expm1(*drift * longest_dwell_s(id.measured)), allowed));
}

/// `read`: what reads the records that were observed; none: they are not read again.
void estimate_sets(const IdentificationRequest& request, const RecordReader* read, Identification& id) {
  const ModalProjection projection = modal_projection(id.campaign, *id.model);
  id.coordinate_unit = projection.unit;
  id.excitation_units.clear();
  if (std::any_of(id.measured.begin(), id.measured.end(),
                  [](const ObservationSet& s) { return s.resonance->excited; }))
    for (const std::size_t channel : excitation_channels(id.campaign, *id.model))
      id.excitation_units.push_back(id.campaign.channels[channel].unit);
  StageClock clock(id.seconds);
  const EstimateTask task{
      id.campaign, {id.coordinate_unit, id.excitation_units}, options_of(request), [&](const char* stage) {
        clock.done(stage);
      }};
  try {
    const std::vector<ObservationSet> observed = id.measured;
    PhasedEstimate found = estimate_with_phases(observed, task);
    const std::vector<FoundFault> faults = faults_in_decays(found.of, task);
    const std::optional<GainStep> step = gain_step(found.of);
    id.estimate = std::move(found.of.estimate);
    id.measured = std::move(found.of.measured);
    id.replayed = std::move(found.of.replayed);
    id.lateness = std::move(found.lateness);
    id.freed = std::move(found.freed);
    judge_lateness(task, id);
    if (read != nullptr) judge_means(observed, *read, request.window, task, id);
    judge_sensor(observed, task, projection.derivatives, id);
    judge_decays(faults, observed, task, id);
    judge_step(step, observed, task, id);
    judge_drift(observed, task, id);
  } catch (const NothingObserved& nothing) {  // here it is the campaign itself
    throw InputError(id.campaign.folder.string(), "", nothing.what());
  }
}

}  // namespace

void estimate_observed(const IdentificationRequest& request, Identification& id) {
  estimate_sets(request, nullptr, id);
}

Identification identify_by_modulation(const IdentificationRequest& request, const Campaign& campaign) {
  DisturbanceWatch watch(campaign);
  SelectedRecords reader(campaign, request.window, watch.look());
  reader.leave_clipped_out();
  Identification result = identify_by_modulation(request, campaign, [&](std::size_t r) { return reader.read(r); });
  for (std::string& warning : reader.warnings()) result.estimate.warnings.push_back(std::move(warning));
  result.disturbances = watch.found();
  list_clipped_as_left_out(result.disturbances);
  for (Disturbance& scatter : scatter_disturbances(result)) result.disturbances.push_back(std::move(scatter));
  result.looked_at = watch.records();
  return result;
}

Identification identify_by_modulation(const IdentificationRequest& request, const Campaign& measured,
                                      const RecordReader& read) {
  Identification result;
  StageClock clock(result.seconds);
  const ModelSource source(request.model, request.interpret, request.note);
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
  estimate_sets(request, &read, result);
  for (const auto* warnings : {&assignment.warnings, &starts.warnings})
    result.estimate.warnings.insert(result.estimate.warnings.begin(), warnings->begin(), warnings->end());
  clock.skip();
  follow_decays(request, read, result);
  clock.done("held out");
  return result;
}

void follow_decays(const IdentificationRequest& request, const RecordReader& read, Identification& id) {
  id.held_out.clear();
  id.followed.clear();
  try {
    for (const ObservationSet& set : id.measured)
      if (!set.resonance->excited && id.model->modes() == 1)
        for (std::size_t r = 0; r < id.campaign.records.size(); ++r) take_decay(request, read, r, set, id);
  } catch (const NumericalFailure& failure) {
    id.estimate.warnings.push_back(std::string("what was held out could not be predicted (") + failure.what() +
                                   ")");
  }
}

}  // namespace secular
