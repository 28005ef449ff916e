#pragma once

#include <Eigen/Core>
#include <span>

#include "diagnose/evidence/frozen_segment.hpp"

namespace secular {

/// Directions in which the errors of segments move, as their rows see them, about the state of each: with its
/// foreign content, with each part of the state, and with the stiffness and the damping of every mode. By
/// differences of motions, all of which are integrated side by side.
void freeze_directions(const SegmentModel& model, std::span<FrozenSegment> segments,
                       const Eigen::VectorXd& unknowns);

}  // namespace secular
