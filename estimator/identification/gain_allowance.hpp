#pragma once

#include "estimator/identification/estimate.hpp"

namespace secular {

/// Lets all responses be wrong by the share `share` of their amplitude, docs/inference.md (56): a number whose unit
/// holds the coordinate's to the power p may be wrong by |p| times as much of itself, which joins its misfit.
void allow_for_gain(Estimate& estimate, const CompiledModel& model, double share);

}  // namespace secular
