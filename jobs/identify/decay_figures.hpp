#pragma once

#include <cstddef>
#include <string>

#include "jobs/identify/case_view.hpp"
#include "report/figure.hpp"

namespace secular {

/// Figures of a free decay in mode `own`.

/// Frequency and decay rate of every window against amplitude, and those of the full equations, within a band of
/// two standard deviations by the parameters' covariance (docs/inference.md (R3)).
report::Figure decay_response(const CaseView& view, std::size_t own);

/// Measured minus computed in every window, with bars of two standard deviations.
report::Figure decay_residuals(const CaseView& view, std::size_t own);

/// A decay against time, measured and computed; `title` says which part of it.
report::Figure decay_in_time(const CaseView& view, const HeldOutPrediction& decay, const std::string& title);

}  // namespace secular
