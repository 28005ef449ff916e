#pragma once

#include <string>

#include "app/identify/full_equations.hpp"
#include "report/figure.hpp"

namespace secular::app {

/// The HTML report of a run by the full equations; `command` is how it was started.
std::string full_report(const FullIdentification& run, const std::string& command);

/// Its first figure: a stretch of the first record that is compared sample by sample, measured and computed, and
/// what is left; where there is none, what every record leaves.
report::Figure full_figure(const FullIdentification& run);

}  // namespace secular::app
