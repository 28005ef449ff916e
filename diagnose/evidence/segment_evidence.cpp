#include "diagnose/evidence/segment_evidence.hpp"

#include <limits>
#include <utility>

#include "diagnose/evidence/between_samples.hpp"
#include "diagnose/evidence/freeze_segments.hpp"
#include "diagnose/evidence/predicted_segments.hpp"
#include "diagnose/evidence/segment_slopes.hpp"

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

SegmentEvidence::SegmentEvidence(const CompiledModel& model, std::vector<StateForce> forces, SensorModel sensors,
                                 FaultTable table, std::vector<Segment> segments, unsigned threads)
    : SegmentEvidence(SegmentModel(model, std::move(forces), std::move(sensors), std::move(table)),
                      std::move(segments), threads) {}

SegmentEvidence::SegmentEvidence(SegmentModel model, std::vector<Segment> segments, unsigned threads)
    : model_(std::move(model)), threads_(threads) {
  for (Segment& s : segments) {
    const std::vector<RowLabel> labels = segment_labels(model_, s);
    labels_.insert(labels_.end(), labels.begin(), labels.end());
    segments_.emplace_back(std::move(s));
  }
}

void SegmentEvidence::freeze(const VectorXd& unknowns, double coarse) {
  const std::span<const SegmentNoise> before = noise_in_use();
  freeze_segments(model_, segments_, unknowns, coarse, threads_);
  coarse_ = coarse > 0;
  if (!coarse_) noise_ = noise_at(unknowns, before);
}

std::vector<SegmentNoise> SegmentEvidence::noise_at(const VectorXd& unknowns,
                                                    std::span<const SegmentNoise> before) const {
  const auto modes = static_cast<Index>(model_.modes());
  if (noise_is_known_) return {segments_.size(), {VectorXd::Ones(2 * modes), 1}};
  const std::vector<LeftOfSegment> left = left_of_segments(segments_, seen_errors(model_, segments_, unknowns));
  std::vector<SegmentNoise> noise = noise_of_segments(segments_, left, unknowns.head(modes), before);
  widen_to_noise_beside_motion(segments_, left, unknowns.head(modes), noise);
  return noise;
}

void SegmentEvidence::set_frequency_offsets(const std::map<std::size_t, VectorXd>& offsets) {
  for (FrozenSegment& f : segments_) {
    const auto own = offsets.find(f.segment.record);
    f.segment.frequency_offset = own == offsets.end() ? VectorXd() : own->second;
  }
}

void SegmentEvidence::evaluate(const VectorXd& unknowns, Eigen::Ref<VectorXd> rows) const {
  if (!has_frequencies(unknowns, model_.modes())) {
    rows.setConstant(std::numeric_limits<double>::infinity());
    return;
  }
  const SegmentRows of = this->rows();
  const std::vector<Index> begins = of.begins();
  std::vector<VectorXd> errors = seen_errors(model_, segments_, unknowns);
  for (std::size_t i = 0; i < segments_.size(); ++i)
    of.fill(i, std::move(errors[i]), rows.segment(begins[i], of.count(i)));
}

MatrixXd SegmentEvidence::between_samples(const VectorXd& unknowns, const BetweenSamples& of_blows) const {
  return between_samples_columns(rows(), unknowns, of_blows);
}

MatrixXd SegmentEvidence::slopes(const VectorXd& unknowns, const std::vector<std::size_t>& which,
                                 const VectorXd& scale, unsigned threads) const {
  return segment_slopes(rows(), unknowns, which, scale, threads);
}

std::vector<Segment> SegmentEvidence::predicted(std::size_t record, const VectorXd& unknowns, double level) const {
  std::size_t first = 0;
  while (first < segments_.size() && segments_[first].segment.record != record) ++first;
  const std::size_t count = end_of_record(segments_, first) - first;
  const std::span<const SegmentNoise> noise = noise_in_use();
  return predicted_segments(model_, std::span(segments_).subspan(first, count),
                            noise.empty() ? noise : noise.subspan(first, count), unknowns, level);
}

SegmentEvidence SegmentEvidence::of_known_noise(std::vector<Segment> segments) const {
  SegmentEvidence evidence(model_, std::move(segments), 1);
  evidence.noise_is_known_ = true;
  return evidence;
}

}  // namespace secular
