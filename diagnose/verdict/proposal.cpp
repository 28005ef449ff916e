#include "diagnose/verdict/proposal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "diagnose/thresholds.hpp"
#include "diagnose/verdict/next_record.hpp"

namespace secular {
namespace {

using Names = std::vector<std::string>;

/// A test is proposed if it has this chance of leaving one explanation, and takes away as large a share of the
/// probability that another one is right.
constexpr auto& worth_a_test = diagnose_thresholds().worth_a_test;

/// Explanations that a next experiment is planned for. Each counts with the odds that keep an explanation in, at
/// least.
constexpr std::size_t most_hypotheses = 4;
constexpr auto& least_rival = diagnose_thresholds().told_apart;

bool is_worth_it(const ProposedTest& test) {
  return test.compared > 0 && test.chance >= worth_a_test &&
         1 - test.probability <= (1 - worth_a_test) * (1 - test.before);
}

}  // namespace

NextExperiment propose_experiment(const std::vector<Rival>& rivals, const Naming& naming,
                                  const ConditionModel& model, const std::vector<Condition>& conditions,
                                  const SegmentEvidence* segments, const ProposalOptions& options) {
  NextExperiment next;
  std::vector<Hypothesis> hypotheses;
  std::vector<Names> taken;
  for (const Rival& r : rivals) {
    const bool in_set = std::all_of(r.effects.begin(), r.effects.end(),
                                    [&](const std::string& effect) { return naming.names(effect); });
    const bool wanted = hypotheses.empty() || in_set || (naming.set.size() < 2 && hypotheses.size() < 2);
    if (!wanted || std::find(taken.begin(), taken.end(), r.effects) != taken.end()) continue;
    hypotheses.push_back({r.explanation, std::max(r.probability, least_rival)});
    taken.push_back(r.effects);
    if (hypotheses.size() == most_hypotheses) break;
  }
  if (hypotheses.size() < 2) {
    next.reason = "nothing competes with the explanation";
    return next;
  }
  ProposedTest test;
  if (!conditions.empty()) test = next_dwell(model, conditions, hypotheses, options);
  if (segments && !is_worth_it(test)) {
    ProposedTest record = next_record(*segments, hypotheses, options);
    if (record.compared > 0 && record.probability > test.probability) test = std::move(record);
  }
  if (test.compared == 0) {
    next.reason = "no motion near the measured ones could be predicted under every explanation";
    return next;
  }
  for (const Names& effects : taken) next.separates.push_back(fmt::format("{}", fmt::join(effects, " + ")));
  next.proposed = is_worth_it(test);
  if (!next.proposed)
    next.reason = fmt::format(
        "no test between half the lowest and {:.3g} times the highest level used would part {}: the best has a "
        "chance of {:.0f} % and takes the right one's probability from {:.1f} to {:.1f} %; it takes another kind "
        "of test, for example a second sensor, a calibration of the excitation, or a resonance that was not "
        "measured yet",
        options.highest_level, fmt::join(next.separates, ", "), 100 * test.chance, 100 * test.before,
        100 * test.probability);
  next.test = std::move(test);
  return next;
}

}  // namespace secular
