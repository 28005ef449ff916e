#pragma once

#include <optional>
#include <span>

#include "measure/observe/observation_set.hpp"

namespace secular {

/// What means say of a sensor that reads y + k*y^2 of what there is to be read, docs/inference.md (73).
struct EvenSensor {
  const CompiledCase* resonance = nullptr;  ///< whose dwells tell it
  std::size_t mode = 0;
  double k = 0;         ///< 1 over the channels' unit
  double second = 0;    ///< share of the second harmonic that it makes in the largest motion
  int derivatives = 0;  ///< ModalProjection::derivatives
};

/// Of dwells whose channels show velocities or accelerations: a motion that lasts has no mean there. Nothing where
/// means do not grow as the square of the motion (level 0.1 %), or are filtered out. The case and mode that show it
/// most. Records are read once more, for what they hold at zero frequency.
std::optional<EvenSensor> even_sensor(const Campaign& campaign, const RecordReader& read,
                                      std::span<const ObservationSet> measured, const Window& window);

/// The observations as a sensor without its even part shows them: second harmonics without k B^2, (74).
ObservationSet without_even_part(const ObservationSet& set, const EvenSensor& sensor);

}  // namespace secular
