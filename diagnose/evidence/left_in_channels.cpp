#include "diagnose/evidence/left_in_channels.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numeric>
#include <utility>

#include "diagnose/evidence/left_of_segment.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

LeftInChannel nothing_yet(const Segment& first, std::size_t channel) {
  LeftInChannel left;
  left.record = first.record;
  left.channel = channel;
  left.sample_s = first.sample_s;
  left.from_s = first.in_record_s - 0.5 * static_cast<double>(first.response.cols()) * first.sample_s;
  return left;
}

// Foreign content that was taken off a segment, as its rows see it, in units of noise.
VectorXd foreign_content(const FrozenSegment& f) {
  const Index samples = f.samples();
  VectorXd content = VectorXd::Zero(f.segment.response.size());
  for (Index c = 0; c < f.taken_off.rows(); ++c)
    content.segment(c * samples, samples) = f.taken_off.row(c).transpose() / f.segment.noise_sd(c);
  content = f.seen(std::move(content));
  const MatrixXd moved = f.directions.of_motion();
  content -= moved * (moved.transpose() * content);
  return content;
}

// `rest`: of the segment, all channels; `known`: directions that are no rest.
void add_slow(LeftInChannel& left, const FrozenSegment& f, Index channel, const VectorXd& rest,
              const MatrixXd& known) {
  const MatrixXd slow = orthonormal_beyond(known, f.seen_columns(wander_columns(f.segment, channel)));
  const double gained = (slow.transpose() * rest).squaredNorm(), freedom = slow.colwise().squaredNorm().sum();
  const VectorXd own = rest.segment(channel * f.samples(), f.samples());
  left.slow += gained;
  left.slow_freedom += freedom;
  left.other += own.squaredNorm() - gained;
  left.other_freedom += static_cast<double>(f.samples()) - freedom;
}

}  // namespace

std::vector<LeftInChannel> left_in_channels(const SegmentModel& model, std::span<const FrozenSegment> segments,
                                            const VectorXd& unknowns) {
  const std::vector<VectorXd> errors = model.errors(trials_of(segments, unknowns));
  const auto channels = static_cast<Index>(model.sensors().responses.size());
  std::vector<LeftInChannel> all;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const FrozenSegment& f = segments[i];
    const Segment& s = f.segment;
    const Index samples = f.samples();
    if (i == 0 || segments[i - 1].segment.record != s.record)
      for (Index c = 0; c < channels; ++c)
        all.push_back(nothing_yet(s, model.sensors().responses[static_cast<std::size_t>(c)]));
    MatrixXd known(s.response.size(), f.directions.count());
    known << f.directions.of_state, f.directions.of_change;
    const VectorXd rest = left_of_segment(f, f.seen(errors[i])).rest, foreign = foreign_content(f);
    for (Index c = 0; c < channels; ++c) {
      LeftInChannel& left = all[all.size() - static_cast<std::size_t>(channels - c)];
      for (Index k = c * samples; k < (c + 1) * samples; ++k) {
        left.rest.push_back(s.noise_sd(c) * (rest(k) + foreign(k)));
        left.noise.push_back(s.noise_sd(c) * rest(k));
        left.unwhited.push_back(s.noise_sd(c) * errors[i](k));
        left.reading.push_back(s.response(c, k - c * samples));
      }
      add_slow(left, f, c, rest, known);
      left.to_s = s.in_record_s + 0.5 * static_cast<double>(samples) * s.sample_s;
    }
  }
  for (LeftInChannel& left : all)
    left.rms = std::sqrt(std::inner_product(left.rest.begin(), left.rest.end(), left.rest.begin(), 0.0) /
                         static_cast<double>(left.rest.size()));
  return all;
}

}  // namespace secular
