#pragma once

#include <optional>
#include <string>

#include "jobs/identify/case_view.hpp"
#include "report/figure.hpp"

namespace secular {

/// Figures of a case that is excited: peak amplitudes of the first oscillating mode.

/// Measured dwells and the model's curve at each level of the excitation. Points of different levels are not
/// joined.
report::Figure dwell_response(const CaseView& view);

/// Against the excitation's level, measured and computed, where there are three levels or more.
std::optional<report::Figure> dwells_by_level(const CaseView& view);

/// Measured minus computed of amplitude and phase, with bars of two standard deviations of a dwell's mean.
report::Figure dwell_differences(const CaseView& view);

/// "Root mean square of the amplitude's difference: 0.012 %."
std::string size_of_differences(const CaseView& view);

}  // namespace secular
