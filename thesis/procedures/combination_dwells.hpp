#pragma once

#include "measure/observe/observation_set.hpp"

namespace secular {

/// Ensembles of every dwell at an additive combination resonance, where neither mode's frequency follows from the
/// excitation's alone: excitation by maximum likelihood, both responses by circular-hyperbolic decomposition of the
/// modal signals (thesis section 6.4: their sum is the excitation's frequency, neither is a bin's), amplitudes and
/// harmonics by least squares at the frequencies found. Takes and returns what observe_dwells does. Dwells without
/// a response of both modes are reported and left out. Throws InputError where the case is another one.
ObservationSet observe_combination_dwells(const Campaign& campaign, const RecordReader& read,
                                          const CompiledModel& model, const CompiledCase& resonance,
                                          const Window& window);

}  // namespace secular
