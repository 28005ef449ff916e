#pragma once

#include <string>

#include "estimator/identification/estimate.hpp"

namespace secular {

/// Whether a value with an error bar differs from zero at 95 %.
bool is_significant(const EstimatedValue& value);

/// The value may be off by more than its error bar; `why` in plain words.
void doubt(EstimatedValue& value, const std::string& why);

/// A misfit (docs/inference.md (15), (46), (57), (69)) joins the error bar and the misfit that the value has; where
/// it dominates the error bar, the value is doubtful for the reason `why`, in plain words.
void add_misfit(EstimatedValue& value, double misfit,
                const std::string& why =
                    "the model does not fit, and what it lacks may have moved this by more than "
                    "its error bar");

}  // namespace secular
