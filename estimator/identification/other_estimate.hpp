#pragma once

#include <string>

#include "estimator/identification/estimate.hpp"

namespace secular {

/// Lets every number be wrong by what it is in another estimate of the same symbols, docs/inference.md (57): the
/// difference joins its misfit, or a `share` of it. `why`: the reason of a doubt where that dominates the error
/// bar.
void allow_for_other(Estimate& estimate, const Estimate& other, const std::string& why, double share = 1);

}  // namespace secular
