#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "diagnose/evidence/frozen_segment.hpp"
#include "diagnose/evidence/segment_noise.hpp"

namespace secular {

/// A decay whose segments depart from any smooth law of the amplitude: how many it has, and the middles of those
/// that depart by more than twice the quiet ones, in seconds of the record.
struct DisturbedRecord {
  std::size_t record = 0, segments = 0;
  std::vector<double> worst_s;
};
std::vector<DisturbedRecord> disturbed_records(std::span<const FrozenSegment> segments,
                                               std::span<const SegmentNoise> noise);

/// How much is in a record: the excitation (first channel), or the response's largest (first channel), in that
/// channel's unit.
struct RecordSize {
  std::size_t record = 0;
  bool driven = false;
  double size = 0;
};
std::vector<RecordSize> record_sizes(std::span<const FrozenSegment> segments);

/// Mean square of the error over all samples, by response channel, in the square of its unit; every segment from
/// its best state.
Eigen::VectorXd mean_square_error(const SegmentModel& model, std::span<const FrozenSegment> segments,
                                  const Eigen::VectorXd& unknowns);
/// That of the channels themselves.
Eigen::VectorXd mean_square_signal(const SegmentModel& model, std::span<const FrozenSegment> segments);

}  // namespace secular
