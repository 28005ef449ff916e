#pragma once

#include <string>

#include "jobs/diagnose/diagnosis_run.hpp"
#include "report/figure.hpp"

namespace secular {

/// The diagnosis as one self-contained HTML page. `command`: the line that made it, printed at its foot.
std::string diagnosis_report(const DiagnosisRun& run, const std::string& command);

/// "acts like a force of v that grows as |displacement|^6.90(20)": the law that explains better than the catalogue.
std::string open_law_sentence(const OpenLaw& law);

/// Why no verdict rests on rows that scatter far less than the repeatability that they are measured in.
std::string misjudged_noise_sentence();

/// What the first mode's equation of motion leaves, in phase and in quadrature, against the amplitude: with the
/// model as it is and with the best explanation added.
report::Figure gap_figure(const DiagnosisRun& run);

}  // namespace secular
