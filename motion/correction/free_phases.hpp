#pragma once

#include <vector>

#include "estimator/identification/record_lateness.hpp"
#include "motion/correction/corrected_estimate.hpp"

namespace secular {

/// An estimate, and what phases that are unknowns say of its records.
struct PhasedEstimate {
  CorrectedEstimate of;
  std::vector<CaseLateness> lateness;  ///< by case whose records are out of step with their excitation
  /// By case: what free phases made of its records, whether or not its equations hold then.
  std::vector<CaseLateness> freed;
};

/// Which estimate of a campaign counts. With phases as measured, and where equations do not hold, once more with
/// phases as unknowns. Numbers stay as they were, and those that this moves are doubtful, where it is no
/// explanation: equations still do not hold, or phases follow a law of the amplitude. Where it is one, those that
/// the other sign of the excitation moves are doubtful if that is not told. docs/inference.md (16) to (22). Errors
/// as of estimate_corrected().
PhasedEstimate estimate_with_phases(const std::vector<ObservationSet>& observed, const EstimateTask& task);

}  // namespace secular
