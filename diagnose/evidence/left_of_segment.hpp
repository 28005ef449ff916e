#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "diagnose/evidence/frozen_segment.hpp"

namespace secular {

/// What unknowns leave of a frozen segment's errors beside its state and foreign content.
struct LeftOfSegment {
  double white = 0;         ///< variance of what is white
  Eigen::VectorXd changes;  ///< along the changes of stiffness and damping: in the first rows
  Eigen::VectorXd rest;     ///< in the others
  double rest_rms = 0;      ///< by the degrees of freedom that it has
};

/// `error`: as the segment's rows see it.
LeftOfSegment left_of_segment(const FrozenSegment& frozen, const Eigen::VectorXd& error);

/// Of all segments.
std::vector<LeftOfSegment> left_of_segments(std::span<const FrozenSegment> segments,
                                            const std::vector<Eigen::VectorXd>& errors);

}  // namespace secular
