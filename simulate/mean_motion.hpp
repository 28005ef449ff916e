#pragma once

#include <span>

#include "estimator/identification/observation_set.hpp"

namespace secular {

/// What the ensembles of one dwell agree on, at the first one's phases. Ensembles show the same motion at other
/// phases of the excitation and, where the resonance leaves frequencies free, of the modes; each is turned back by
/// that, and the median of every complex number is taken: `ensembles` may hold outliers. Standard deviations are
/// those of medians of white noise. Not empty.
Observation mean_motion(std::span<const Observation> ensembles, const CompiledModel& model,
                        const CompiledCase& resonance);

}  // namespace secular
