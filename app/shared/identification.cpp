#include "app/shared/identification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>
#include <utility>

#include "app/shared/model_loading.hpp"
#include "input/input_error.hpp"
#include "input/numerical_failure.hpp"
#include "measure/data/watched_reader.hpp"
#include "measure/observe/modal_projection.hpp"
#include "measure/observe/steady_amplitude.hpp"
#include "motion/correction/replay.hpp"
#include "motion/correction/truncation_correction.hpp"
#include "numerics/hertz.hpp"

namespace secular::app {
namespace {

/// A dwell belongs to a resonance within this relative distance.
constexpr double resonance_width = 0.1;

// How far a dwell is from a case's resonances, relative; infinite where that cannot be told.
double mismatch(const ModelSource& model, const CaseOutline& resonance, double excitation_frequency) {
  const std::vector<double>& nominal = model.nominal_frequencies();
  if (resonance.relations.empty() || nominal.size() != model.modes() + 1) return INFINITY;
  double worst = 0;
  for (const std::vector<int>& relation : resonance.relations) {
    double sum = 0, size = 0;
    for (std::size_t i = 0; i < relation.size(); ++i) {
      const double term = relation[i] * (i < model.modes() ? nominal[i] : excitation_frequency);
      sum += term;
      size = std::max(size, std::abs(term));
    }
    worst = std::max(worst, std::abs(sum) / size);
  }
  return worst;
}

void require_case(const ModelSource& model, const std::string& name) {
  std::string known;
  for (const CaseOutline& resonance : model.cases()) {
    if (resonance.name == name) return;
    known += (known.empty() ? "" : ", ") + resonance.name;
  }
  throw InputError("--case " + name, "", "is no case of model " + model.name(), "its cases are " + known);
}

// Cases by name with the records that they explain, in the order of the model.
struct Assignment {
  std::vector<std::string> names;
  std::vector<std::vector<bool>> records;  ///< [case][record]
  std::vector<std::string> warnings;
};

// Which cases free decays go to. All modes ring together after a pluck, so the case with most of them takes the
// decays, from the first window to the last one in which any of them is seen; of several, one whose resonance
// between the modes the nominal frequencies fulfil. Cases of one mode each share the decays out.
std::vector<bool> decay_cases(const ModelSource& model, const std::vector<std::string>& chosen) {
  const std::vector<CaseOutline>& cases = model.cases();
  std::vector<bool> takes(cases.size(), false);
  std::size_t best = cases.size();
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const CaseOutline& resonance = cases[c];
    if (resonance.excited) continue;
    if (!chosen.empty()) {
      takes[c] = std::find(chosen.begin(), chosen.end(), resonance.name) != chosen.end() &&
                 (model.modes() > 1 || std::find(takes.begin(), takes.end(), true) == takes.end());
      continue;
    }
    const double off = mismatch(model, resonance, 0);  // infinite without relations or nominal frequencies
    if (std::isfinite(off) && off >= resonance_width) continue;
    if (best == cases.size() || resonance.active_modes > cases[best].active_modes ||
        (resonance.active_modes == cases[best].active_modes && off < mismatch(model, cases[best], 0)))
      best = c;
  }
  if (best == cases.size()) return takes;
  takes[best] = true;
  if (cases[best].active_modes == 1 && model.modes() > 1)
    for (std::size_t c = 0; c < cases.size(); ++c) takes[c] = !cases[c].excited && cases[c].active_modes == 1;
  return takes;
}

Assignment assign_records(const ModelSource& model, const Campaign& campaign,
                          const IdentificationRequest& request) {
  const auto allowed = [&](const CaseOutline& resonance) {
    return request.resonances.empty() || std::find(request.resonances.begin(), request.resonances.end(),
                                                   resonance.name) != request.resonances.end();
  };
  const std::vector<CaseOutline>& cases = model.cases();
  std::vector<std::vector<bool>> records(cases.size(), std::vector<bool>(campaign.records.size(), false));
  const auto excited =
      std::count_if(cases.begin(), cases.end(), [&](const CaseOutline& c) { return c.excited && allowed(c); });
  const std::vector<bool> decays_to = decay_cases(model, request.resonances);
  Assignment result;
  bool dwells = false, decays = false;
  double stray = 0;
  for (std::size_t r = 0; r < campaign.records.size(); ++r) {
    const RecordEntry& entry = campaign.records[r];
    if (!request.window.takes(r, entry.file)) continue;
    if (entry.kind == RecordKind::free_decay || entry.kind == RecordKind::impact) {
      decays = true;
      for (std::size_t c = 0; c < cases.size(); ++c)
        if (decays_to[c]) records[c][r] = true;
    }
    if (entry.kind != RecordKind::dwell) continue;
    dwells = true;
    if (excited == 1 && !request.resonances.empty()) {
      for (std::size_t c = 0; c < cases.size(); ++c)
        if (cases[c].excited && allowed(cases[c])) records[c][r] = true;
      continue;
    }
    if (!entry.excitation_frequency_hz) {
      result.warnings.push_back(
          fmt::format("{}: a dwell without excitation_frequency_hz belongs to no case, left out", entry.file));
      continue;
    }
    const double frequency = two_pi * *entry.excitation_frequency_hz;
    std::size_t best = cases.size();
    for (std::size_t c = 0; c < cases.size(); ++c)
      if (cases[c].excited && allowed(cases[c]) &&
          (best == cases.size() || mismatch(model, cases[c], frequency) < mismatch(model, cases[best], frequency)))
        best = c;
    if (best < cases.size() && mismatch(model, cases[best], frequency) < resonance_width) {
      records[best][r] = true;
    } else {
      stray = *entry.excitation_frequency_hz;
      result.warnings.push_back(fmt::format(
          "{}: {:.4g} Hz excites no resonance that the model has a case for, left out", entry.file, stray));
    }
  }
  for (std::size_t c = 0; c < cases.size(); ++c)
    if (std::find(records[c].begin(), records[c].end(), true) != records[c].end()) {
      result.names.push_back(cases[c].name);
      result.records.push_back(records[c]);
    }
  if (!result.names.empty()) return result;
  if (dwells)
    throw InputError(campaign.folder.string(), "",
                     stray > 0
                         ? fmt::format("its dwells near {:.4g} Hz excite no resonance that model {} has a case for",
                                       stray, model.name())
                         : "its dwells belong to no case of model " + model.name(),
                     "name the case with --case, or add a [[case]] to the model");
  throw InputError(campaign.folder.string(), "",
                   "has no records that model " + model.name() + " can be identified from",
                   decays ? "its free decays need a case with excitation = false"
                          : "dwells with excitation_frequency_hz or free decays were expected");
}

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

const CompiledCase& named_case(const CompiledModel& model, const std::string& name) {
  return *std::find_if(model.cases.begin(), model.cases.end(),
                       [&](const CompiledCase& resonance) { return resonance.name == name; });
}

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
    return estimate(id.measured, units, options);
  } catch (const NumericalFailure& failure) {
    const std::size_t conditions = count_of_conditions(id.measured);
    throw InputError(
        id.campaign.folder.string(), "",
        fmt::format("{} condition{} of it determine{} no parameters of {} ({})", conditions,
                    conditions == 1 ? "" : "s", conditions == 1 ? "s" : "", id.model->name, failure.what()),
        "dwells at several levels and frequencies around the resonance");
  }
}

}  // namespace

Identification identify(const IdentificationRequest& request) {
  const Campaign campaign = read_campaign(request.campaign);
  WatchedReader reader(campaign);
  Identification result = identify(request, campaign, [&](std::size_t r) { return reader.read(r); });
  for (std::string& warning : reader.warnings()) result.estimate.warnings.push_back(std::move(warning));
  return result;
}

Identification identify(const IdentificationRequest& request, const Campaign& measured, const RecordReader& read) {
  Identification result;
  StageClock clock(result.seconds);
  const ModelSource source(request.model, request.interpret);
  for (const std::string& name : request.resonances) require_case(source, name);
  result.campaign = measured;
  const Campaign& campaign = result.campaign;
  const Assignment assignment = assign_records(source, campaign, request);
  result.model = source.load(assignment.names);
  const CompiledModel& model = *result.model;
  clock.done("model");
  for (std::size_t c = 0; c < assignment.names.size(); ++c) {
    const CompiledCase& resonance = named_case(model, assignment.names[c]);
    Window window = request.window;
    window.chosen = assignment.records[c];
    window.threads = request.threads;
    result.measured.push_back(resonance.excited ? observe_dwells(campaign, read, model, resonance, window)
                                                : observe_free_decays(campaign, read, model, resonance, window));
  }
  clock.done("observation");
  estimate_observed(request, result);
  result.estimate.warnings.insert(result.estimate.warnings.begin(), assignment.warnings.begin(),
                                  assignment.warnings.end());
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

void estimate_observed(const IdentificationRequest& request, Identification& id) {
  StageClock clock(id.seconds);
  const Campaign& campaign = id.campaign;
  id.coordinate_unit = modal_projection(campaign, *id.model).unit;
  id.excitation_units.clear();
  if (std::any_of(id.measured.begin(), id.measured.end(),
                  [](const ObservationSet& s) { return s.resonance->excited; }))
    for (const std::size_t channel : excitation_channels(campaign, *id.model))
      id.excitation_units.push_back(campaign.channels[channel].unit);
  const MeasuredUnits units{id.coordinate_unit, id.excitation_units};
  EstimateOptions options;
  options.fixed = request.fixed;
  options.bootstrap = request.bootstrap;
  options.seed = request.seed;
  options.refine = request.refine;
  options.threads = request.threads;
  EstimateOptions first = options;
  first.judge_fit = first.damping_laws = false;
  first.rough_errors = true;
  first.bootstrap = 0;
  Estimate raw = first_estimate(id, units, first);
  clock.done("regression");
  const auto replay = [&](const ObservationSet& set, const Eigen::VectorXd& parameters) {
    return observe_replay(campaign, set, parameters, request.threads);
  };
  try {
    TruncationCorrection correction =
        correct_truncation(id.measured, raw, units, options, replay, [&](const char* stage) { clock.done(stage); });
    id.estimate = std::move(correction.estimate);
    id.measured = std::move(correction.measured);
    id.replayed = std::move(correction.replayed);
    for (ObservationSet& set : id.replayed)
      if (set.resonance->excited) to_steady_amplitudes(set, id.estimate.parameter_values);
  } catch (const NumericalFailure& failure) {
    id.replayed = id.measured;
    for (ObservationSet& set : id.replayed) set.observations.clear();
    EstimateOptions uncorrected = options;
    uncorrected.judge_fit = false;
    uncorrected.start = raw.state;
    id.estimate = estimate(id.measured, units, uncorrected);
    id.estimate = with_failed_correction(std::move(id.estimate), failure.what());
  }
}

}  // namespace secular::app
