#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "diagnose/evidence/frozen_segment.hpp"
#include "diagnose/evidence/segment_noise.hpp"

namespace secular {

/// Segments as these unknowns predict them, each from `level` times the state that it begins with and driven by
/// `level` times its excitation: without noise or foreign content, with the errors that were measured. Empty: a
/// motion runs away. `noise`: of each; empty: what the segments say.
std::vector<Segment> predicted_segments(const SegmentModel& model, std::span<const FrozenSegment> segments,
                                        std::span<const SegmentNoise> noise, const Eigen::VectorXd& unknowns,
                                        double level);

}  // namespace secular
