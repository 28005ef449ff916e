#pragma once

#include <string>

#include "app/diagnosis_run.hpp"

namespace secular::app {

/// The diagnosis as one self-contained HTML page. `command`: the line that made it, printed at its foot.
std::string diagnosis_report(const DiagnosisRun& run, const std::string& command);

}  // namespace secular::app
