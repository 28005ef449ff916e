#include "motion/correction/corrected_estimate.hpp"

#include <fmt/format.h>

#include <set>
#include <string>
#include <utility>

#include "input/numerical_failure.hpp"
#include "measure/observe/steady_amplitude.hpp"
#include "motion/correction/balanced_set.hpp"
#include "motion/correction/replay.hpp"

namespace secular {
namespace {

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
Estimate first_estimate(const std::vector<ObservationSet>& measured, const EstimateTask& task) {
  try {
    return estimate(measured, task.units, task.options, pass_between());
  } catch (const NothingObserved&) {
    throw;  // no conditions to speak of
  } catch (const NumericalFailure& failure) {
    const std::size_t conditions = count_of_conditions(measured);
    throw NumericalFailure(
        failure.ending(),
        fmt::format("{}: {} condition{} of it determine{} no parameters of {} ({}); dwells at several levels and "
                    "frequencies around the resonance may",
                    task.campaign.folder.string(), conditions, conditions == 1 ? "" : "s",
                    conditions == 1 ? "s" : "", measured.front().model->name, failure.what()));
  }
}

}  // namespace

CorrectedEstimate estimate_corrected(std::vector<ObservationSet> measured, const EstimateTask& task,
                                     const Estimate* start) {
  const Estimate raw = start ? *start : first_estimate(measured, task);
  task.done("regression");
  const auto replay = [&](const ObservationSet& set, const Eigen::VectorXd& parameters) {
    // With the natural frequency that all records share a dwell does not stay with the motion that was measured:
    // while it goes away, its rates are not those at the amplitude where it began.
    if (!set.frequency_scatter.empty())
      if (auto balanced = BalancedSet(set, task.options.threads).at(parameters)) return std::move(*balanced);
    return observe_replay(task.campaign, set, parameters, task.options.threads);
  };
  CorrectedEstimate result;
  try {
    TruncationCorrection correction =
        correct_truncation(measured, raw, task.units, task.options, replay, task.done);
    result.estimate = std::move(correction.estimate);
    result.measured = std::move(correction.measured);
    result.replayed = std::move(correction.replayed);
    for (ObservationSet& set : result.replayed)
      if (set.resonance->excited) to_steady_amplitudes(set, result.estimate.parameter_values);
    result.corrected = std::move(correction.corrected);
  } catch (const NumericalFailure& failure) {
    result.replayed = measured;
    for (ObservationSet& set : result.replayed) set.observations.clear();
    result.estimate = with_failed_correction(
        estimate(measured, task.units, task.options, {.judge_fit = false, .start = raw.state}), failure.what());
    result.measured = std::move(measured);
  }
  return result;
}

}  // namespace secular
