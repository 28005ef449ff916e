#pragma once

#include <string>

#include "app/shared/identification.hpp"
#include "report/figure.hpp"

namespace secular::app {

/// The self-contained HTML report of a run of `identify`; `command` is how it was started.
std::string identification_report(const Identification& identification, const std::string& command);

/// Its first figure: response against excitation frequency, or frequency and damping against amplitude for decays.
report::Figure response_figure(const Identification& identification);

}  // namespace secular::app
