#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "diagnose/evidence/frozen_segment.hpp"

namespace secular {

/// What is left of a response channel in the segments of a record, one behind the other: beside the state that is
/// fitted for each segment, in the channel's unit, with foreign content that was fitted beside it.
struct LeftInChannel {
  std::size_t record = 0, channel = 0;        ///< of the campaign
  double sample_s = 0, from_s = 0, to_s = 0;  ///< in the record's time
  std::vector<double> rest, reading;
  std::vector<double> noise;     ///< the rest without foreign content
  std::vector<double> unwhited;  ///< the same before anything makes it white
  double rms = 0;                ///< of the rest
  /// In units of noise: the square that zeros which wander would make of it, with its degrees of freedom, and
  /// that of all else.
  double slow = 0, slow_freedom = 0, other = 0, other_freedom = 0;
};

/// Channel after channel of every record.
std::vector<LeftInChannel> left_in_channels(const SegmentModel& model, std::span<const FrozenSegment> segments,
                                            const Eigen::VectorXd& unknowns);

}  // namespace secular
