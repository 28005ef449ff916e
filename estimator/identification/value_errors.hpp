#pragma once

#include <string>

#include "estimator/identification/estimate.hpp"

namespace secular {

/// Whether a value with an error bar differs from zero at 95 %.
bool is_significant(const EstimatedValue& value);

/// The value may be off by more than its error bar; `why` in plain words.
void doubt(EstimatedValue& value, const std::string& why);

/// A misfit (docs/inference.md (15), (46)) joins the error bar; where it dominates that, the value is doubtful.
void add_misfit(EstimatedValue& value, double misfit);

}  // namespace secular
