#pragma once

#include <vector>

#include "diagnose/evidence/condition_rows.hpp"
#include "diagnose/verdict/test_outcome.hpp"

namespace secular {

/// The dwell, among levels and frequencies around those measured, after which the right one of `hypotheses` is
/// expected to have the largest probability. Under each hypothesis in turn the dwell is predicted with its fitted
/// unknowns and judged by every other (a discrimination design; Box and Hill 1967, Atkinson and Fedorov 1975).
/// Levels stay within half the lowest and `highest_level` times the highest used; where no dwell as long as those
/// measured is as good as certain, one of the next of `test_lengths` is looked for. Without a proposal (compared =
/// 0) there is no dwell to start from.
ProposedTest next_dwell(const ConditionModel& model, const std::vector<Condition>& conditions,
                        const std::vector<Hypothesis>& hypotheses, const ProposalOptions& options);

}  // namespace secular
