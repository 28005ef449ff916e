#include "diagnose/evidence/frozen_states.hpp"

#include <utility>

#include "diagnose/evidence/state_search.hpp"

namespace secular {

using Eigen::Index;
using Eigen::VectorXd;

std::vector<VectorXd> best_states(const SegmentModel& model, std::span<const FrozenSegment> segments,
                                  const VectorXd& unknowns, Stretch stretch) {
  std::vector<StateSearch> searches;
  for (const FrozenSegment& f : segments)
    searches.push_back({f.segment, f.state, stretch == Stretch::whole ? f.samples() : f.horizon(), {}});
  find_states(model, unknowns, searches);
  std::vector<VectorXd> states;
  for (StateSearch& search : searches) states.push_back(std::move(search.state));
  return states;
}

namespace {

void silence_jumps(const SegmentModel& model, std::span<FrozenSegment> segments, const VectorXd& unknowns) {
  std::vector<SegmentTrial> trials;
  for (const FrozenSegment& f : segments) trials.push_back({f.segment, f.horizon(), unknowns, f.state});
  std::vector<std::vector<Index>> jumps;
  model.errors(trials, &jumps);
  std::vector<StateSearch> searches;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    FrozenSegment& f = segments[i];
    for (const Index before : jumps[i])
      for (const Index sample : {before, before + 1})
        if (f.silent.empty() || f.silent.back() < sample) f.silent.push_back(sample);
    if (!f.silent.empty()) searches.push_back({f.segment, f.state, f.horizon(), f.silent});
  }
  improve_states(model, unknowns, searches);
  auto found = searches.begin();
  for (FrozenSegment& f : segments)
    if (!f.silent.empty()) f.state = (found++)->state;
}

}  // namespace

void freeze_states(const SegmentModel& model, std::span<FrozenSegment> segments, const VectorXd& unknowns) {
  std::vector<VectorXd> states = best_states(model, segments, unknowns, Stretch::to_the_horizon);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    segments[i].state = std::move(states[i]);
    segments[i].silent.clear();
  }
  if (model.sensors().derivatives == 2) silence_jumps(model, segments, unknowns);
  for (FrozenSegment& f : segments)
    for (Index k = f.horizon(); k < f.samples(); ++k) f.silent.push_back(k);
}

}  // namespace secular
