#include "diagnose/evidence/segment_noise.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "diagnose/evidence/noise_beside_motion.hpp"
#include "diagnose/evidence/noise_levels.hpp"
#include "diagnose/evidence/noise_of_decays.hpp"
#include "diagnose/thresholds.hpp"

namespace secular {
namespace {

/// Fewest segments of one decay that tell a repeatability.
constexpr auto& fewest_segments = diagnose_thresholds().fewest_segments;

/// What remains of a decay's segments changes by this factor's logarithm from one to the next, beyond any smooth
/// law, where the record itself is disturbed (slips of its clock, knocks).
constexpr auto& irregular = diagnose_thresholds().irregular;

using Eigen::Index;
using Eigen::VectorXd;

}  // namespace

void SegmentNoise::whiten(const VectorXd& error, Eigen::Ref<VectorXd> rest) const {
  if (!coloured) {
    rest = error / rest_sd;
    return;
  }
  const auto& [cosines, sd, least] = *coloured;
  const Index samples = cosines.rows();
  for (Index c = 0; c < sd.cols(); ++c)
    rest.segment(c * samples, samples) = (cosines * error.segment(c * samples, samples)).cwiseQuotient(sd.col(c));
}

// What the first rows repeat to from segment to segment is what noise makes of them where the segments are too few
// to tell.
SegmentNoise noise_of_record(std::span<const FrozenSegment> segments, std::span<const LeftOfSegment> left,
                             std::shared_ptr<const NoiseInCosines> coloured) {
  const Segment& s = segments.front().segment;
  std::vector<double> white, rest;
  for (const LeftOfSegment& l : left) {
    white.push_back(l.white);
    rest.push_back(l.rest_rms);
  }
  const double level = white_level(white);
  const Index changes = left.front().changes.size();
  SegmentNoise noise{VectorXd::Constant(changes, level), level};
  if (s.excitation.cols() > 0) return noise;
  const bool repeats = left.size() >= fewest_segments;
  if (coloured && coloured->cosines.rows() == s.response.cols()) {
    if (!repeats) noise.change_sd = sd_along(*coloured, segments.front().directions.of_change);
    noise.coloured = std::move(coloured);
  } else if (repeats) {
    noise.rest_sd = std::max(level, lower_quartile(std::move(rest)));
  }
  for (Index row = 0; repeats && row < changes; ++row) {
    std::vector<double> series;
    for (const LeftOfSegment& l : left) series.push_back(l.changes(row));
    noise.change_sd(row) = std::max(noise.change_sd(row), roughness(series));
  }
  return noise;
}

std::vector<double> disturbances(std::span<const LeftOfSegment> left, const SegmentNoise& noise) {
  std::vector<double> in_noise, logarithm;
  for (const LeftOfSegment& l : left) {
    VectorXd rows(l.rest.size());
    noise.whiten(l.rest, rows);
    in_noise.push_back(l.rest_rms * rows.norm() / l.rest.norm());
    logarithm.push_back(std::log(std::max(in_noise.back(), std::sqrt(l.white) / noise.white_sd())));
  }
  if (!(roughness(logarithm) > irregular)) in_noise.assign(left.size(), 0);
  return in_noise;
}

std::vector<SegmentNoise> noise_of_segments(std::span<const FrozenSegment> segments,
                                            std::span<const LeftOfSegment> left, const VectorXd& natural_frequency,
                                            std::span<const SegmentNoise> before) {
  const std::shared_ptr<const NoiseInCosines> coloured = noise_of_decays(segments, left, natural_frequency);
  std::vector<SegmentNoise> found;
  for (std::size_t first = 0, end = 0; first < segments.size(); first = end) {
    end = end_of_record(segments, first);
    const auto of_record = left.subspan(first, end - first);
    found.insert(found.end(), end - first,
                 noise_of_record(segments.subspan(first, end - first), of_record, coloured));
    if (segments[first].segment.excitation.cols() > 0 || end - first < fewest_segments) continue;
    const std::vector<double> disturbed = disturbances(of_record, found[first]);
    for (std::size_t i = first; i < end; ++i) {
      found[i].disturbance = disturbed[i - first];
      if (!before.empty()) found[i].change_sd = found[i].change_sd.cwiseMax(before[i].change_sd);
    }
  }
  return found;
}

void widen_to_noise_beside_motion(std::span<const FrozenSegment> segments, std::span<const LeftOfSegment> left,
                                  const VectorXd& natural_frequency, std::vector<SegmentNoise>& noise) {
  std::vector<SampledRest> rests;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& s = segments[i].segment;
    const auto samples = static_cast<std::ptrdiff_t>(s.response.cols());
    if (!s.is_in_folds()) continue;
    for (auto first = left[i].rest.begin(); first != left[i].rest.end(); first += samples)
      rests.push_back({{first, first + samples}, s.sample_s});
  }
  const double wider = std::sqrt(noise_beside_motion(rests, natural_frequency));
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (!segments[i].segment.is_in_folds() || noise[i].coloured) continue;
    noise[i].change_sd *= wider;
    noise[i].rest_sd *= wider;
  }
}

}  // namespace secular
