#pragma once

#include <string>

#include "jobs/identify/identification.hpp"
#include "report/figure.hpp"

namespace secular {

/// The first figure of a report: response against excitation frequency, or frequency and damping against amplitude
/// for decays; by the full equations see full_figure().
report::Figure response_figure(const Identification& identification);

/// The self-contained HTML report of a run of `identify`; `response` is its response_figure() (the model's curves
/// take time), `command` how it was started.
std::string identification_report(const Identification& identification, const report::Figure& response,
                                  const std::string& command);

}  // namespace secular
