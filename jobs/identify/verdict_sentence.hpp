#pragma once

#include <string>

#include "estimator/identification/estimate.hpp"
#include "report/html_report.hpp"

namespace secular {

/// Records that were compared with the model sample by sample, and those of which something is left that is not
/// white (docs/inference.md (R2)).
struct ComparedInTime {
  std::size_t records = 0, not_white = 0;
};

/// What an estimate comes to, in one sentence of plain English: what the tests of its equations and the comparison
/// in time say of the model, how many parameters have a number, and how well the least known of them is known.
std::string verdict_sentence(const Estimate& estimate, const ComparedInTime& in_time);

/// Good: equations were tested and none is contradicted, half of the parameters have a number, nothing is doubtful
/// and what is left in time is white. Bad: no parameter has a number.
report::Tone verdict_tone(const Estimate& estimate, const ComparedInTime& in_time);

}  // namespace secular
