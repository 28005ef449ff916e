#pragma once

#include "jobs/plan/dwell_evaluation.hpp"

namespace secular {

/// The programme that the plan is held against (PlanRequest::against): dwells of an experiment or of a campaign,
/// each at the stable response with the largest amplitude. Dwells without one cost time and tell nothing;
/// `warnings` says how many. Throws InputError where there are no dwells.
Programme programme_in_use(const PlanRequest& request, const PlanResult& plan, const DwellEvaluation& evaluation,
                           std::vector<std::string>& warnings);

}  // namespace secular
