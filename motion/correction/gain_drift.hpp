#pragma once

#include <optional>
#include <span>
#include <vector>

#include "measure/observe/observation_set.hpp"

namespace secular {

/// docs/inference.md (64): by how much a second amplitudes over their excitation grow in all dwells alike,
/// relative, shrunk to zero where chance makes as much (level 0.1 %): a sensitivity that drifts in every record, as
/// an amplifier that warms up. Nothing of fewer than three dwells of two ensembles, or of several excitations.
std::optional<double> gain_drift(std::span<const ObservationSet> measured);

/// The observations with the sensitivity that acts at the begin of each dwell.
ObservationSet with_first_gain(ObservationSet set, double drift);

/// The longest dwell, from the middle of its first ensemble to that of its last, s.
double longest_dwell_s(std::span<const ObservationSet> measured);

}  // namespace secular
