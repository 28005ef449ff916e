#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

#include "estimator/identification/estimate.hpp"
#include "motion/correction/full_motions.hpp"

namespace secular {

/// Called with what was just done, for the time that it took.
using StageDone = std::function<void(const char* stage)>;

struct TruncationCorrection {
  Estimate estimate;
  std::vector<ObservationSet> measured;  ///< what was corrected: where large motions had to be left out, the others
  std::vector<ObservationSet> corrected;  ///< the same with what was taken out of their equations
  std::vector<ObservationSet> replayed;   ///< at the parameters of the last correction
};

/// docs/inference.md (11) to (13). Takes what the truncated equations leave at the motions of the full ones out of
/// the equations, from the parameters of `raw` on (the estimate of the sets as measured), until that settles. The
/// null space of the parameters acts on the correction, too, and is estimated with them
/// (SharedParameters::null_coordinate). Passes on the way keep the weights of the equations; the last one finds
/// them again. The truncation may bend the first estimate so far that motions as large as those measured grow
/// beyond bounds: then the small ones are corrected first, and the others join them; where they grow beyond bounds
/// still, they are left out with a warning. Throws NumericalFailure where small ones do, too.
TruncationCorrection correct_truncation(std::span<const ObservationSet> measured, const Estimate& raw,
                                        const MeasuredUnits& units, const EstimateOptions& options,
                                        const ReplaySet& replay, const StageDone& done);

}  // namespace secular
