#pragma once

#include <optional>
#include <span>

#include "estimator/identification/estimate.hpp"
#include "measure/observe/observation_set.hpp"

namespace secular {

/// What third harmonics say of a sensor that reads y + k*y^3 of what there is to be read, docs/inference.md (56).
struct CubicSensor {
  const CompiledCase* resonance = nullptr;  ///< whose dwells tell it
  double k = 0;                             ///< |half amplitude as the channels show it|^-2
  double third = 0;     ///< share of the third harmonic in the largest motion beyond what model and excitation make
  int derivatives = 0;  ///< ModalProjection::derivatives
};

/// Of dwells, at amplitudes and excitations as measured, all lines of the excitation with them: nothing where the
/// third harmonic is as the model makes it (level 0.1 %), where the estimate does not determine what the model
/// makes, or where no case has an equation for that line. Cases without a balance (BalancedMotions::known) and
/// tables of lines say nothing. `derivatives`: of ModalProjection.
std::optional<CubicSensor> cubic_sensor(std::span<const ObservationSet> measured, const Estimate& estimate,
                                        int derivatives, unsigned threads);

/// The observations as a sensor without its cubic part shows them: amplitudes B (1 - 3 k |B|^2).
ObservationSet without_cubic_part(const ObservationSet& set, const CubicSensor& sensor);

}  // namespace secular
