#pragma once

#include <set>
#include <string>

#include "estimator/identification/estimate.hpp"
#include "jobs/identify/identification.hpp"
#include "report/html_report.hpp"

namespace secular {

/// Parts of a report of an estimate, whichever equations it comes from.

/// Names of the symbols that are natural frequencies: said in rad/s and in Hz.
std::set<std::string> natural_frequencies(const CompiledModel& model);

/// A card for each of the first six parameters that are significant.
void add_cards(report::HtmlReport& page, const Estimate& estimate, const std::set<std::string>& frequencies);

/// The table of the parameters, or of the lumps.
void add_values(report::HtmlReport& page, const Estimate& estimate, bool lumps,
                const std::set<std::string>& frequencies);

/// The parameters by either equations, where there are both.
void add_refinement(report::HtmlReport& page, const DecayRefinement& refinement);

/// The table of coefficients that follow from the rest position, where there are any.
void add_following(report::HtmlReport& page, const Identification& id);

/// Pairs of the first six parameters with a number and an error bar, with their correlations; nothing for one
/// alone.
void add_pairs(report::HtmlReport& page, const Estimate& estimate, const std::set<std::string>& frequencies);

/// What the records cannot tell apart, where there is anything.
void add_null_directions(report::HtmlReport& page, const Estimate& estimate);

}  // namespace secular
