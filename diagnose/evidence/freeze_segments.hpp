#pragma once

#include <Eigen/Core>
#include <span>

#include "diagnose/evidence/frozen_segment.hpp"

namespace secular {

/// Takes all of segments that rows are made of at these unknowns, one stage after the other: how far they count,
/// their states, what whitens errors about them, the directions that are eliminated, and what comes off the
/// readings. `coarse`: as Evidence::freeze(). Each segment goes as it would alone.
void freeze_segments(const SegmentModel& model, std::span<FrozenSegment> segments, const Eigen::VectorXd& unknowns,
                     double coarse, unsigned threads);

}  // namespace secular
