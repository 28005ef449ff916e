#pragma once

#include <optional>
#include <span>

#include "measure/observe/observation_set.hpp"

namespace secular {

/// An even law of a sensor, s + k*s^2, behind an AC coupling.
struct CoupledLaw {
  double k = 0;                ///< 1 over the channels' unit
  double time_constant_s = 0;  ///< of the coupling
  double counts = 0;           ///< from 0, where chance makes as much, to 1
};

/// docs/inference.md (78), of the first mode's means in decays of velocities or accelerations (`derivatives` of a
/// displacement): what a law makes of them behind an AC coupling of one pole, beside what that itself makes of
/// a step before the record. `shortest_s`: of the coupling's time constants. `alarm`: with this probability chance
/// makes as much. Nothing where means are those of a chain that passes them, where a law explains no more, where
/// zeros wander otherwise, or where there are too few means.
std::optional<CoupledLaw> coupled_law(std::span<const ObservationSet> sets, int derivatives, double shortest_s,
                                      double alarm);

/// Windows of a stretch over the independent means that they hold: a mean takes all samples of its window alike, so
/// that a stretch of two lengths holds two.
double overlap_of_means(const Observation& window);

/// The weight of means that leave `chi_squared` of `freedom` beside what they are explained with: 1 where chance
/// leaves as much with 5 %, 0 where it does with `contradiction_alarm`.
double weight_by_what_is_left(double chi_squared, double freedom);

}  // namespace secular
