#pragma once

#include <vector>

#include "estimator/identification/estimate.hpp"
#include "motion/correction/truncation_correction.hpp"

namespace secular {

/// What a campaign's observations are estimated with.
struct EstimateTask {
  const Campaign& campaign;
  MeasuredUnits units;
  EstimateOptions options;
  StageDone done;
};

/// An estimate, corrected for the expansion's truncation where that is possible.
struct CorrectedEstimate {
  Estimate estimate;
  std::vector<ObservationSet> measured;  ///< by case, what it is made of
  /// By case, what the full equations do at the estimated parameters; observations empty if that failed.
  std::vector<ObservationSet> replayed;
  /// By case, equations with the truncation taken out; none where that was not possible.
  std::vector<ObservationSet> corrected;
};

/// Of sets as they were observed, from `start` on, an estimate of the same observations, where there is one. Throws
/// NumericalFailure where they determine no parameters at all.
CorrectedEstimate estimate_corrected(std::vector<ObservationSet> measured, const EstimateTask& task,
                                     const Estimate* start = nullptr);

}  // namespace secular
