#include "diagnose/evidence/freeze_segments.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/evidence/frozen_directions.hpp"
#include "diagnose/evidence/frozen_states.hpp"
#include "diagnose/evidence/taken_off.hpp"
#include "diagnose/evidence/wide_errors.hpp"
#include "numerics/in_parallel.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

enum class Errors { wide, true_ones };

// While errors are wide, in which tones are small, zeros alone are fitted as foreign content, as far as what counts
// shows them.
void take_width(FrozenSegment& f, double coarse, double lowest) {
  const bool wide = coarse > 0;
  f.widening = wide ? widening(f.segment, std::sqrt(coarse)) : 1;
  f.beyond_horizon = wide ? beyond_horizon(f.measured, std::sqrt(coarse), lowest) : 0;
  f.held = wide ? zero_count(f.segment, f.horizon()) : f.may_hold.cols();
}

// States, and what whitens errors about them.
void freeze_motions(const SegmentModel& model, std::span<FrozenSegment> segments, const VectorXd& unknowns,
                    Errors errors) {
  freeze_states(model, segments, unknowns);
  for (FrozenSegment& f : segments)
    f.driven_noise = errors == Errors::wide ? DrivenNoise() : DrivenNoise(model, f.trial(unknowns), f.silent);
}

// Motions of these segments are integrated side by side.
void freeze_together(const SegmentModel& model, std::span<FrozenSegment> segments, const VectorXd& unknowns,
                     Errors errors) {
  for (FrozenSegment& f : segments) f.restore();
  freeze_motions(model, segments, unknowns, errors);
  if (std::any_of(segments.begin(), segments.end(), [](const FrozenSegment& f) { return f.held > 0; })) {
    freeze_directions(model, segments, unknowns);
    for (FrozenSegment& f : segments) take_foreign_content_off(model, f, unknowns);
    freeze_motions(model, segments, unknowns, errors);
  }
  for (FrozenSegment& f : segments) take_driven_noise_off(model, f, unknowns);
  freeze_directions(model, segments, unknowns);
}

}  // namespace

void freeze_segments(const SegmentModel& model, std::span<FrozenSegment> segments, const VectorXd& unknowns,
                     double coarse, unsigned threads) {
  const double lowest = unknowns.head(static_cast<Index>(model.modes())).minCoeff();
  for (FrozenSegment& f : segments) take_width(f, coarse, lowest);
  const Errors errors = coarse > 0 ? Errors::wide : Errors::true_ones;
  const std::size_t parts = std::min<std::size_t>(std::max(1U, threads), segments.size());
  in_parallel(parts, threads, [&](std::size_t part) {
    const std::size_t first = part * segments.size() / parts, end = (part + 1) * segments.size() / parts;
    freeze_together(model, segments.subspan(first, end - first), unknowns, errors);
  });
}

}  // namespace secular
