#pragma once

#include "jobs/plan/planning.hpp"

namespace secular {

/// What a plan's request says of it, candidates and dwells aside: model and case, parameters, the sensors of the
/// experiment in use, noise, unknowns with their units and which of them are wanted. Throws InputError.
PlanResult plan_inputs(const PlanRequest& request);

}  // namespace secular
