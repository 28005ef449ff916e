#pragma once

#include <string>

#include "app/diagnose/diagnosis_run.hpp"

namespace secular::app {

/// diagnosis.json, schema 1.
std::string diagnosis_json(const DiagnosisRun& run);

}  // namespace secular::app
