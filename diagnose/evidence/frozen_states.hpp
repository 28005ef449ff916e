#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "diagnose/evidence/frozen_segment.hpp"

namespace secular {

/// What of a segment a state is found from.
enum class Stretch { to_the_horizon, whole };

/// The state of each segment that fits best: from the one that it has, or from a new one, whichever leaves less.
std::vector<Eigen::VectorXd> best_states(const SegmentModel& model, std::span<const FrozenSegment> segments,
                                         const Eigen::VectorXd& unknowns, Stretch stretch);

/// Puts segments into these states, as far as their horizon, and silences the samples that do not count: those
/// beyond it, and of accelerations those on either side of a jump, beside which the state is found once more.
void freeze_states(const SegmentModel& model, std::span<FrozenSegment> segments, const Eigen::VectorXd& unknowns);

}  // namespace secular
