#pragma once

#include <cstdint>

#include "measure/observe/observation_set.hpp"

namespace secular {

/// Ensembles of dwells as another measurement might have shown them: everything that was measured of an ensemble
/// moved by Gaussian noise as large as the ensemble says its own is. One draw for every seed, the same on every
/// platform.
ObservationSet with_observation_noise(ObservationSet exact, std::uint64_t seed);

}  // namespace secular
