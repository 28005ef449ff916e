#pragma once

#include <string>

#include "jobs/diagnose/diagnosis_run.hpp"

namespace secular {

/// diagnosis.json, schema 1.
std::string diagnosis_json(const DiagnosisRun& run);

}  // namespace secular
