#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "diagnose/evidence/discrepancy.hpp"
#include "diagnose/evidence/frozen_segment.hpp"
#include "diagnose/evidence/segment_noise.hpp"

namespace secular {

/// What the rows of a segment speak of: the change of every mode's stiffness and damping, then every reading.
std::vector<RowLabel> segment_labels(const SegmentModel& model, const Segment& segment);

/// Rows of frozen segments, one behind the other. The state is eliminated to first order about its best value. The
/// first rows of a segment are the errors that a change of every mode's stiffness and damping would make, the
/// conservative and the dissipative part of the discrepancy; the others hold the rest. Those of a segment in folds
/// are zero: its samples hold everything, so that a fold that is left out takes its part of it along.
struct SegmentRows {
  const SegmentModel& model;
  std::span<const FrozenSegment> segments;
  std::span<const SegmentNoise> noise;  ///< empty: errors are wide, and nothing repeats worse

  /// Of a segment.
  Eigen::Index count(std::size_t segment) const {
    return static_cast<Eigen::Index>(2 * model.modes()) + segments[segment].segment.response.size();
  }
  /// Where those of each segment begin, and where all end.
  std::vector<Eigen::Index> begins() const;
  /// From errors of a segment's samples, as its rows see them.
  void fill(std::size_t segment, Eigen::VectorXd error, Eigen::Ref<Eigen::VectorXd> rows) const;
  /// The rows of a segment in folds with the first ones apart, as those of other segments are (of white noise; sums
  /// of squares stay).
  Eigen::VectorXd by_balance(Eigen::VectorXd rows) const;
};

/// How many of the rows are independent of each other.
Eigen::Index freedom_of(const SegmentRows& rows);

}  // namespace secular
