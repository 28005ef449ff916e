#include "diagnose/evidence/frozen_states.hpp"

#include <algorithm>
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
  if (model.sensors().derivatives != 2) return;
  std::vector<SegmentTrial> trials;
  for (const FrozenSegment& f : segments) trials.push_back({f.segment, f.horizon(), unknowns, f.state});
  std::vector<std::vector<Index>> jumps;
  model.errors(trials, &jumps);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    std::vector<Index>& silent = segments[i].silent;
    for (const Index before : jumps[i]) silent.insert(silent.end(), {before, before + 1});
    std::sort(silent.begin(), silent.end());
    silent.erase(std::unique(silent.begin(), silent.end()), silent.end());
  }
}

// Without the samples that are silent.
void improve_silenced(const SegmentModel& model, std::span<FrozenSegment> segments, const VectorXd& unknowns) {
  std::vector<StateSearch> searches;
  for (const FrozenSegment& f : segments)
    if (!f.silent.empty()) searches.push_back({f.segment, f.state, f.horizon(), f.silent});
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
    segments[i].silent = segments[i].segment.uncompared;
    std::erase_if(segments[i].silent, [&](Index sample) { return sample >= segments[i].horizon(); });
  }
  silence_jumps(model, segments, unknowns);
  improve_silenced(model, segments, unknowns);
  for (FrozenSegment& f : segments)
    for (Index k = f.horizon(); k < f.samples(); ++k) f.silent.push_back(k);
}

}  // namespace secular
