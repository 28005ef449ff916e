#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

#include "diagnose/evidence/freeze_segments.hpp"
#include "diagnose/evidence/left_of_segment.hpp"
#include "tests/diagnose/decay_segments.hpp"
#include "tests/signal/gaussian.hpp"

namespace secular::testing_support {

/// What the full equations make of segments of a laboratory.
inline SegmentModel segment_model(const Laboratory& lab) {
  return {lab.compiled, {}, lab.sensors, lab.faults};
}

inline std::vector<FrozenSegment> as_measured(std::vector<Segment> segments) {
  std::vector<FrozenSegment> all;
  for (Segment& s : segments) all.emplace_back(std::move(s));
  return all;
}

/// A free decay, frozen at its true numbers and true errors.
inline std::vector<FrozenSegment> frozen_decay(const Laboratory& lab, const Eigen::VectorXd& truth,
                                               std::uint64_t seed) {
  std::vector<FrozenSegment> all = as_measured(decay(lab, truth, seed));
  freeze_segments(segment_model(lab), all, truth, 0, 1);
  return all;
}

/// Segments of so many samples without a motion, of which nothing is eliminated but so many random directions.
inline FrozenSegment quiet_segment(Eigen::Index samples, std::size_t record, Gaussian& gaussian) {
  Segment s;
  s.record = record;
  s.sample_s = 1e-3;
  s.response = Eigen::MatrixXd::Zero(1, samples);
  s.noise_sd = Eigen::VectorXd::Ones(1);
  FrozenSegment f(std::move(s));
  const auto random = [&] {
    Eigen::MatrixXd columns(samples, 2);
    columns << gaussian.vector(samples), gaussian.vector(samples);
    return columns;
  };
  f.directions = ErrorDirections(Eigen::MatrixXd(samples, 0), random(), random());
  return f;
}

inline std::vector<FrozenSegment> quiet_segments(Eigen::Index samples, std::size_t count, std::size_t of_record,
                                                 Gaussian& gaussian) {
  std::vector<FrozenSegment> all;
  for (std::size_t i = 0; i < count; ++i) all.push_back(quiet_segment(samples, i / of_record, gaussian));
  return all;
}

}  // namespace secular::testing_support
