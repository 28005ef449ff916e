#pragma once

#include "perturb/smooth_function.hpp"

namespace secular {

/// The function's value, as generated code computes it. `exponent`: of a power.
double smooth_value(SmoothKind kind, double exponent, double argument);

}  // namespace secular
