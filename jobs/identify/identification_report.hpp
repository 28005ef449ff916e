#pragma once

#include <string>

#include "jobs/identify/identification.hpp"
#include "report/figure.hpp"

namespace secular {

/// The self-contained HTML report of a run of `identify`; `command` is how it was started.
std::string identification_report(const Identification& identification, const std::string& command);

/// Its first figure: response against excitation frequency, or frequency and damping against amplitude for decays;
/// by the full equations see full_figure().
report::Figure response_figure(const Identification& identification);

}  // namespace secular
