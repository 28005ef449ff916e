#include "diagnose/evidence/predicted_segments.hpp"

#include "diagnose/evidence/frozen_states.hpp"

namespace secular {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

Segment to_predict(Segment s, double level) {
  s.excitation *= level;
  s.response.setZero();
  s.wandering.clear();
  s.tones.clear();
  s.coloured.clear();
  return s;
}

bool ran_away(const StretchOfMotion& motion) {
  const Index last = motion.displacement.cols() - 1;
  return motion.displacement.col(last).isZero(0) && motion.velocity.col(last).isZero(0);
}

}  // namespace

std::vector<Segment> predicted_segments(const SegmentModel& model, std::span<const FrozenSegment> segments,
                                        std::span<const SegmentNoise> noise, const VectorXd& unknowns,
                                        double level) {
  const std::vector<VectorXd> states = best_states(model, segments, unknowns, Stretch::whole);
  std::vector<Segment> predicted;
  for (const FrozenSegment& f : segments) predicted.push_back(to_predict(f.segment, level));
  for (std::size_t i = 0; i < noise.size(); ++i) predicted[i].noise_sd *= noise[i].white_sd();
  std::vector<SegmentTrial> trials;
  for (std::size_t i = 0; i < predicted.size(); ++i)
    trials.push_back({predicted[i], predicted[i].response.cols(), unknowns, level * states[i]});
  std::vector<StretchOfMotion> motions;
  const std::vector<VectorXd> errors = model.errors(trials, nullptr, &motions);
  for (std::size_t i = 0; i < predicted.size(); ++i) {
    if (!errors[i].allFinite() || ran_away(motions[i])) return {};
    Segment& s = predicted[i];
    const Index samples = s.response.cols();
    for (Index c = 0; c < s.response.rows(); ++c)
      s.response.row(c) = -s.noise_sd(c) * errors[i].segment(c * samples, samples).transpose();
  }
  return predicted;
}

}  // namespace secular
