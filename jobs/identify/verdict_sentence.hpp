#pragma once

#include <string>

#include "estimator/identification/estimate.hpp"
#include "report/html_report.hpp"

namespace secular {

/// What an estimate comes to, in one sentence of plain English: whether the model holds, how many parameters have a
/// number, and how well the least known of them is known.
std::string verdict_sentence(const Estimate& estimate);

/// Good: the equations hold and nothing is doubtful. Bad: no parameter has a number.
report::Tone verdict_tone(const Estimate& estimate);

}  // namespace secular
