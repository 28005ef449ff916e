#pragma once

#include <string>

#include "estimator/identification/estimate.hpp"

namespace secular {

/// docs/inference.md, "No number". What an equation lacks differs from condition to condition, and error bars by
/// the scatter between conditions know something of it. Those by the scatter of repeats, where there are too few
/// conditions, know nothing: once something is known to be wrong (`what`, in words), no number of such a case is
/// left, nor a parameter if no case has another kind. A warning names them.
void take_out_unsupported(Estimate& estimate, const std::string& what);

}  // namespace secular
