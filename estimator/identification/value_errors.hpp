#pragma once

#include "estimator/identification/estimate.hpp"

namespace secular {

/// Whether a value with an error bar differs from zero at 95 %.
bool is_significant(const EstimatedValue& value);

/// A misfit (docs/inference.md (15), (46)) joins the error bar; where it dominates that, the value is doubtful.
void add_misfit(EstimatedValue& value, double misfit);

}  // namespace secular
