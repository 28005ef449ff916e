#pragma once

#include <Eigen/Core>

#include "diagnose/evidence/frozen_segment.hpp"

namespace secular {

/// What the errors of a frozen segment hold of foreign content comes off its responses: rows do not see it, but
/// its state is found beside it, and slopes are those of the motion (docs/inference.md (36)).
void take_foreign_content_off(const SegmentModel& model, FrozenSegment& frozen, const Eigen::VectorXd& unknowns);

/// What the errors of a frozen segment say of the noise in its excitation comes off the excitation, and what that
/// does to its errors off its responses: slopes are those of the likeliest excitation, errors stay as they are
/// (docs/inference.md (33)).
void take_driven_noise_off(const SegmentModel& model, FrozenSegment& frozen, const Eigen::VectorXd& unknowns);

}  // namespace secular
