#pragma once

#include "estimator/identification/estimate.hpp"

namespace secular {

/// Lets every number be wrong by what it is in another estimate of the same symbols, docs/inference.md (57): the
/// difference joins its misfit.
void allow_for_other(Estimate& estimate, const Estimate& other);

}  // namespace secular
