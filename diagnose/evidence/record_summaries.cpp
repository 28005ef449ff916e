#include "diagnose/evidence/record_summaries.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <utility>

#include "diagnose/evidence/frozen_states.hpp"

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::vector<DisturbedRecord> disturbed_records(std::span<const FrozenSegment> segments,
                                               std::span<const SegmentNoise> noise) {
  std::vector<DisturbedRecord> records;
  for (std::size_t i = 0; i < noise.size(); ++i) {
    if (noise[i].disturbance == 0) continue;
    const Segment& s = segments[i].segment;
    if (records.empty() || records.back().record != s.record) records.push_back({s.record, 0, {}});
    DisturbedRecord& record = records.back();
    ++record.segments;
    if (noise[i].disturbance > 2) record.worst_s.push_back(s.in_record_s);
  }
  return records;
}

std::vector<RecordSize> record_sizes(std::span<const FrozenSegment> segments) {
  std::vector<RecordSize> sizes;
  for (const FrozenSegment& f : segments) {
    const Segment& s = f.measured;
    if (sizes.empty() || sizes.back().record != s.record) sizes.push_back({s.record, s.excitation.cols() > 0, 0});
    const MatrixXd& what = sizes.back().driven ? s.excitation : s.response;
    sizes.back().size = std::max(sizes.back().size, what.row(0).cwiseAbs().maxCoeff());
  }
  return sizes;
}

VectorXd mean_square_error(const SegmentModel& model, std::span<const FrozenSegment> segments,
                           const VectorXd& unknowns) {
  const auto channels = static_cast<Index>(model.sensors().response_names.size());
  std::vector<VectorXd> states = best_states(model, segments, unknowns, Stretch::whole);
  std::vector<SegmentTrial> trials = trials_of(segments, unknowns);
  for (std::size_t i = 0; i < trials.size(); ++i) trials[i].state = std::move(states[i]);
  const std::vector<VectorXd> errors = model.errors(trials);
  VectorXd sum = VectorXd::Zero(channels);
  double count = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& s = segments[i].segment;
    const Index samples = s.response.cols();
    for (Index c = 0; c < channels; ++c)
      sum(c) += errors[i].segment(c * samples, samples).squaredNorm() * s.noise_sd(c) * s.noise_sd(c);
    count += static_cast<double>(samples);
  }
  return sum / count;
}

VectorXd mean_square_signal(const SegmentModel& model, std::span<const FrozenSegment> segments) {
  VectorXd sum = VectorXd::Zero(static_cast<Index>(model.sensors().response_names.size()));
  double count = 0;
  for (const FrozenSegment& f : segments) {
    sum += f.segment.response.rowwise().squaredNorm();
    count += static_cast<double>(f.samples());
  }
  return sum / count;
}

}  // namespace secular
