#pragma once

#include <span>

#include "measure/observe/observation_set.hpp"

namespace secular {

/// The excitation, amplitudes and frequencies that the ensembles of one dwell agree on, at the first one's phases;
/// the rest is the first one's. Ensembles show the same motion at other phases of the excitation and, where the
/// resonance leaves frequencies free, of the modes; each is turned back by that, and the median of every complex
/// number is taken: `ensembles`, not empty, may hold outliers.
Observation mean_motion(std::span<const Observation> ensembles, const CompiledModel& model,
                        const CompiledCase& resonance);

/// Gives `to` the excitation, amplitudes, rates and harmonics of a motion without noise; it keeps its noise levels.
void take_motion(const Observation& exact, Observation& to);

}  // namespace secular
