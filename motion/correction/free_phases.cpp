#include "motion/correction/free_phases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <utility>

#include "estimator/identification/unsupported_values.hpp"
#include "input/numerical_failure.hpp"
#include "motion/correction/noise_left.hpp"
#include "motion/correction/own_frequencies.hpp"

namespace secular {
namespace {

// Phases at truncated equations, then at corrected ones: each round leaves the square of what was left.
constexpr int most_phase_rounds = 4;

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

bool is_freed(const CaseLateness& lateness) {
  return lateness.finding != PhaseFinding::nothing_told;
}

// Numbers that the other sign of a case's excitation moves are doubtful, all of them where that cannot be
// estimated.
void doubt_by_rival(const UnknownPhases& unknown, UnknownPhases::Rival& rival, const EstimateTask& task,
                    Estimate& estimate) {
  std::vector<ObservationSet> sets = unknown.sets;
  sets[rival.place] = std::move(rival.set);
  Estimate other;
  const std::string failure = failure_of([&] { other = estimate_corrected(std::move(sets), task).estimate; });
  if (failure.empty())
    return doubt_what_differs(estimate, other,
                              "the sign of the excitation's effect is not determined, and turns it");
  doubt_all(estimate, "what the other sign of the excitation would make of it cannot be said");
  estimate.warnings.push_back(
      fmt::format("what the other sign of the excitation would make of the numbers cannot be said ({}): all are "
                  "doubtful",
                  failure));
}

// Phases that are right leave numbers that agree with one another and with the full equations: records of cases
// that do not are out of step in part. Whether phases explain all that does not hold.
bool explain(UnknownPhases& unknown, const CorrectedEstimate& freed) {
  const std::set<std::string> not_fitting = cases_with_lack_of_fit(freed.estimate);
  const bool agrees = !freed.corrected.empty() && !freed.estimate.consistency.significant;
  bool explained = true;
  for (CaseLateness& lateness : unknown.cases) {
    if (lateness.finding == PhaseFinding::late && (!agrees || not_fitting.contains(lateness.resonance)))
      lateness.finding = PhaseFinding::in_part;
    explained = explained && (lateness.finding == PhaseFinding::late || !is_freed(lateness));
  }
  return explained;
}

// `result` is as it was if this throws.
void free_phases(const std::vector<ObservationSet>& observed, const EstimateTask& task, PhasedEstimate& result) {
  UnknownPhases unknown = find_unknown_phases(observed, task.units, task.options, result.of.estimate);
  task.done("regression");
  std::vector<CaseLateness> found = unknown.cases;
  if (std::any_of(unknown.cases.begin(), unknown.cases.end(), is_freed)) {
    CorrectedEstimate freed = estimate_corrected(unknown.sets, task);
    for (int round = 1; round < most_phase_rounds &&
                        refine_phases(unknown, freed.corrected, task.units, task.options, freed.estimate);
         ++round)
      freed = estimate_corrected(unknown.sets, task);
    found = unknown.cases;
    if (explain(unknown, freed)) {
      for (UnknownPhases::Rival& rival : unknown.rivals) doubt_by_rival(unknown, rival, task, freed.estimate);
      result.of = std::move(freed);
    } else {
      doubt_what_differs(result.of.estimate, freed.estimate,
                         "it moves where the phase between excitation and responses is free in each record");
      std::erase_if(unknown.cases, [](const CaseLateness& l) { return l.finding == PhaseFinding::late; });
    }
  }
  Estimate& estimate = result.of.estimate;
  for (const CaseLateness& lateness : unknown.cases) {
    estimate.warnings.push_back(text_of(lateness));
    if (!is_freed(lateness))
      take_out(estimate, {lateness.resonance}, "phases do not hold, and nothing determines it without them");
  }
  result.lateness = std::move(unknown.cases);
  result.freed = std::move(found);
}

}  // namespace

PhasedEstimate estimate_with_phases(const std::vector<ObservationSet>& observed, const EstimateTask& task) {
  std::vector<ObservationSet> sets = observed;
  PhasedEstimate result{estimate_with_noise_left(sets, task), {}, {}};
  if (!result.of.estimate.unstated_noise.empty()) return result;  // nothing says whether the phases hold
  const std::string failure = failure_of([&] {
    let_frequencies_differ(sets, task, result.of);
    free_phases(sets, task, result);
  });
  if (!failure.empty())  // the numbers with phases as measured stay
    result.of.estimate.warnings.push_back(fmt::format("whether records are late was not found out: {}", failure));
  return result;
}

}  // namespace secular
