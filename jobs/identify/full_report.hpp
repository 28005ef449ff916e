#pragma once

#include <string>

#include "jobs/identify/identification.hpp"
#include "report/figure.hpp"

namespace secular {

/// The HTML report of a run by the full equations; `command` is how it was started.
std::string full_report(const Identification& id, const std::string& command);

/// Its first figure: a stretch of the first record that is compared sample by sample, measured and computed, and
/// what is left; where there is none, what every record leaves.
report::Figure full_figure(const Identification& id);

}  // namespace secular
