#pragma once

#include <vector>

#include "motion/response/response_curve.hpp"

namespace secular {

/// A motion that sustains itself: one mode oscillates at an amplitude that neither grows nor falls.
struct LimitCycle {
  BackbonePoint at;     ///< its growth is zero to rounding
  bool stable = false;  ///< small disturbances die out, those of other modes included
};

/// Limit cycles of active mode `mode` (index into ResponseField::active) with the other modes at rest and no
/// excitation: the zeros of the growth g(a) = Re(B'/B) among amplitudes |B| up to `largest`, each to rounding. Two
/// that lie within largest/`points` of one another are missed. Stability is that of the modulation equations in the
/// frame that turns with the cycle ((LC1) of docs/inference.md). Empty where the other modes cannot be at rest.
std::vector<LimitCycle> limit_cycles(const ResponseField& field,
                                     const Eigen::Ref<const Eigen::VectorXd>& parameters, std::size_t mode,
                                     double largest, int points);

}  // namespace secular
