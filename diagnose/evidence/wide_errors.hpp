#pragma once

#include <Eigen/Core>

#include "diagnose/evidence/segment.hpp"

namespace secular {

/// What errors are multiplied by, in units of noise, where they are as wide as this share of the motion.
double widening(const Segment& segment, double share);

/// Samples at the end of a driven segment that do not count beside errors widened by this share of the motion: the
/// finer the errors, the more turns of the lowest mode count, from where something drives (docs/inference.md (40)).
/// Over n turns a natural frequency that is wrong by d of itself turns the motion by 2 pi n d, and where that is
/// half a turn a fit finds no way. `lowest`: natural frequency, rad/s.
Eigen::Index beyond_horizon(const Segment& segment, double share, double lowest);

}  // namespace secular
