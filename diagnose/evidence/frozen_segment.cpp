#include "diagnose/evidence/frozen_segment.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Errors of the first samples, of all channels, as those of all samples; the others do not count.
VectorXd of_all_samples(VectorXd error, Index first, Index all) {
  if (first == all) return error;
  const Index channels = error.size() / first;
  MatrixXd whole = MatrixXd::Zero(all, channels);
  whole.topRows(first) = error.reshaped(first, channels);
  return whole.reshaped();
}

}  // namespace

FrozenSegment::FrozenSegment(Segment of_record)
    : measured(std::move(of_record)), segment(measured), may_hold(foreign_columns(segment)) {}

void FrozenSegment::restore() {
  segment.excitation = measured.excitation;
  segment.response = measured.response;
  if (taken_off.size() > 0) segment.response -= taken_off;
}

MatrixXd FrozenSegment::seen_columns(MatrixXd columns) const {
  for (auto column : columns.colwise()) column = seen(column);
  return columns;
}

std::vector<VectorXd> seen_errors(const SegmentModel& model, const std::vector<const FrozenSegment*>& of,
                                  std::vector<SegmentTrial> trials) {
  for (std::size_t i = 0; i < trials.size(); ++i) trials[i].samples = of[i]->horizon();
  std::vector<VectorXd> all = model.errors(trials);
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = of[i]->seen(of_all_samples(std::move(all[i]), of[i]->horizon(), of[i]->samples()));
  return all;
}

std::vector<SegmentTrial> trials_of(std::span<const FrozenSegment> segments, const VectorXd& unknowns) {
  std::vector<SegmentTrial> trials;
  for (const FrozenSegment& f : segments) trials.push_back(f.trial(unknowns));
  return trials;
}

std::vector<VectorXd> seen_errors(const SegmentModel& model, std::span<const FrozenSegment> segments,
                                  const VectorXd& unknowns) {
  std::vector<const FrozenSegment*> of;
  for (const FrozenSegment& f : segments) of.push_back(&f);
  return seen_errors(model, of, trials_of(segments, unknowns));
}

std::size_t end_of_record(std::span<const FrozenSegment> segments, std::size_t first) {
  std::size_t end = first;
  while (end < segments.size() && segments[end].segment.record == segments[first].segment.record) ++end;
  return end;
}

}  // namespace secular
