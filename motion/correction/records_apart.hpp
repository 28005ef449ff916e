#pragma once

#include <cstddef>
#include <vector>

#include "motion/correction/corrected_estimate.hpp"

namespace secular {

/// A decay that tells other numbers than everything else does.
struct RecordApart {
  std::size_t record = 0;
  double counts = 1;  ///< share of what leaving it out moves that chance does not make
  Estimate without;   ///< what everything else tells
};

/// docs/inference.md (64): decays whose coefficients (natural frequencies, which differ from record to record, aside)
/// contradict those of all else (level 0.1 % of a campaign). None of campaigns with one record.
std::vector<RecordApart> records_apart(const CorrectedEstimate& found, const EstimateTask& task);

}  // namespace secular
