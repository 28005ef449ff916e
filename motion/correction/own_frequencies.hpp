#pragma once

#include <vector>

#include "motion/correction/corrected_estimate.hpp"

namespace secular {

/// docs/inference.md (52) to (55). Where balances of frequency of dwells fail in `found`, as where temperature
/// or clamping change the structure from dwell to dwell: estimates once more with natural frequencies that differ
/// from record to record, as far as they do. That counts, in `sets` and `found`, where what they differ by follows
/// neither level, amplitude and frequency of the dwells nor time nor an order of the dwells, as what a missing law
/// makes of them does, and where every equation holds then, instruments_tell() so and the correction for the
/// truncation settles. Else both stay as they are. Throws NumericalFailure as estimate_corrected().
void let_frequencies_differ(std::vector<ObservationSet>& sets, const EstimateTask& task, CorrectedEstimate& found);

}  // namespace secular
