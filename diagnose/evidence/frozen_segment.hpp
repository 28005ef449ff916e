#pragma once

#include <Eigen/Core>
#include <span>
#include <utility>
#include <vector>

#include "diagnose/evidence/driven_noise.hpp"
#include "diagnose/evidence/error_directions.hpp"
#include "diagnose/evidence/segment_model.hpp"

namespace secular {

/// A segment, and all that is taken of it where errors are taken: until the next time its rows are errors about
/// this state, of these readings, as these samples see them.
struct FrozenSegment {
  explicit FrozenSegment(Segment of_record);

  Segment measured;
  Segment segment;            ///< the same; where a noise of the excitation is known, without it
  Eigen::MatrixXd may_hold;   ///< foreign_columns()
  Eigen::Index held = 0;      ///< the first ones of these, which are fitted
  Eigen::MatrixXd taken_off;  ///< foreign content that was taken off the responses so far; empty: none

  double widening = 1;              ///< errors times this
  Eigen::Index beyond_horizon = 0;  ///< samples at the end that do not count while errors are wide
  /// Samples that do not count: those, and where a channel may read either side of a jump of its signal, since
  /// errors there are not continuous in the unknowns.
  std::vector<Eigen::Index> silent;
  Eigen::VectorXd state;     ///< that it begins with
  DrivenNoise driven_noise;  ///< where errors are not wide: what whitens them before anything else
  ErrorDirections directions;

  Eigen::Index samples() const { return segment.response.cols(); }
  /// Samples that may count, the first ones.
  Eigen::Index horizon() const { return samples() - beyond_horizon; }
  /// Its readings as they were measured, but for foreign content that is known.
  void restore();
  /// As it is.
  SegmentTrial trial(const Eigen::VectorXd& unknowns) const { return {segment, samples(), unknowns, state}; }
  /// Errors as its rows see them.
  Eigen::VectorXd seen(Eigen::VectorXd error) const {
    return driven_noise.whitened(silenced(std::move(error), samples(), silent));
  }
  /// Each column of errors as its rows see it.
  Eigen::MatrixXd seen_columns(Eigen::MatrixXd columns) const;
  /// The columns of foreign content that are fitted, as its rows see them.
  Eigen::MatrixXd seen_foreign_columns() const { return seen_columns(may_hold.leftCols(held)); }
};

/// Errors of trials as the rows of their segments see them, computed as far as their horizons; `of`: the segment of
/// each.
std::vector<Eigen::VectorXd> seen_errors(const SegmentModel& model, const std::vector<const FrozenSegment*>& of,
                                         std::vector<SegmentTrial> trials);

/// Segments as they are.
std::vector<SegmentTrial> trials_of(std::span<const FrozenSegment> segments, const Eigen::VectorXd& unknowns);
/// Their errors as their rows see them.
std::vector<Eigen::VectorXd> seen_errors(const SegmentModel& model, std::span<const FrozenSegment> segments,
                                         const Eigen::VectorXd& unknowns);

/// Where the record of segment `first` ends; a record's segments stand one behind the other.
std::size_t end_of_record(std::span<const FrozenSegment> segments, std::size_t first);

}  // namespace secular
