#pragma once

#include "estimator/identification/estimate.hpp"
#include "report/html_report.hpp"

namespace secular {

/// Parts of a report of an estimate, whichever equations it comes from.

/// A card for each of the first six parameters that are significant.
void add_cards(report::HtmlReport& page, const Estimate& estimate);

/// The table of the parameters, or of the lumps.
void add_values(report::HtmlReport& page, const Estimate& estimate, bool lumps);

/// What the records cannot tell apart, where there is anything.
void add_null_directions(report::HtmlReport& page, const Estimate& estimate);

}  // namespace secular
