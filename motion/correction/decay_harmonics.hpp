#pragma once

#include <vector>

#include "motion/correction/chain_fault.hpp"
#include "motion/correction/corrected_estimate.hpp"

namespace secular {

/// A fault of the measuring chain that the harmonics of decays speak of.
struct FoundFault {
  SizedFault fault;
  double counts = 1;  ///< share of what it moves that chance does not make: from 0, where chance ends, to 1
};

/// docs/inference.md (62): harmonics and means of decays against those of the full equations' motions at the
/// estimate. The fault of the chain that explains best what differs beyond chance (level 0.1 % over all faults),
/// and those that explain it nearly as well. None where nothing differs, where the model makes no harmonics, or
/// where the full equations did not make the motion. Laws of a sensor are looked for where one channel shows one
/// mode.
std::vector<FoundFault> faults_in_decays(const CorrectedEstimate& found, const EstimateTask& task);

}  // namespace secular
