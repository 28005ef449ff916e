#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

#include "estimator/identification/estimate.hpp"

namespace secular {

/// What the full equations do at some parameters where sets were measured: observe_replay of each.
using ReplaySets = std::function<std::vector<ObservationSet>(const Eigen::VectorXd& parameters)>;

/// Called with what was just done, for the time that it took.
using StageDone = std::function<void(const char* stage)>;

struct TruncationCorrection {
  Estimate estimate;
  std::vector<ObservationSet> replayed;  ///< at the parameters of the last correction
};

/// Takes what the truncated equations leave at the motions of the full ones out of the equations, from the
/// parameters of `raw` on (the estimate of the sets as measured), until that settles. What no lump tells of the
/// parameters acts on the correction, too, and is estimated with them (SharedParameters::shift). Passes on the way
/// keep the weights of the equations; the last one finds them again. Throws InputError where a motion grows beyond
/// bounds.
TruncationCorrection correct_truncation(std::span<const ObservationSet> measured, const Estimate& raw,
                                        const MeasuredUnits& units, const EstimateOptions& options,
                                        const ReplaySets& replay, const StageDone& done);

}  // namespace secular
