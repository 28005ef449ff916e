#include "motion/correction/full_motions.hpp"

#include <utility>
#include <vector>

#include "measure/observe/common_observations.hpp"

namespace secular {
namespace {

// `motions`, as far as they were replayed, with what replays have beyond their balance.
ObservationSet with_remainder(ObservationSet motions, const ObservationSet& replayed,
                              const ObservationSet& balanced) {
  std::vector<Observation> kept;
  for_common_observations(motions, replayed, [&](std::size_t i, std::size_t at) {
    Observation o = motions.observations[i];
    const Observation &exact = replayed.observations[at], &known = balanced.observations[at];
    for (std::size_t k = 0; k < o.rate.size(); ++k) o.rate[k] += exact.rate[k] - known.rate[k];
    for (std::size_t b = 0; b < o.harmonic.size(); ++b) o.harmonic[b] += exact.harmonic[b] - known.harmonic[b];
    kept.push_back(std::move(o));
  });
  motions.observations = std::move(kept);
  return motions;
}

}  // namespace

FullMotions::FullMotions(std::span<const ObservationSet> measured, const ReplaySet& replay, unsigned threads)
    : measured_(measured),
      replay_(replay),
      threads_(threads),
      was_balanced_(measured.size(), false),
      reference_(measured.size()) {
  for (const ObservationSet& set : measured) of_measured_.push_back(std::make_unique<BalancedSet>(set, threads));
}

std::optional<ObservationSet> FullMotions::balanced(std::size_t s, const Eigen::VectorXd& parameters) {
  const auto& reference = reference_[s];
  if (!reference) return of_measured_[s]->at(parameters);
  if (!reference->balanced) return std::nullopt;
  const bool dwells = measured_[s].resonance->excited;
  auto motions = (dwells ? *of_measured_[s] : reference->balance).at(parameters);
  if (!motions) return std::nullopt;
  return with_remainder(std::move(*motions), reference->replayed, *reference->balanced);
}

std::optional<std::vector<ObservationSet>> FullMotions::at(const Eigen::VectorXd& parameters) {
  std::vector<ObservationSet> sets;
  for (std::size_t s = 0; s < measured_.size(); ++s) {
    auto set = balanced(s, parameters);
    if (set) was_balanced_[s] = true;
    if (!set && was_balanced_[s]) return std::nullopt;
    const bool known = reference_[s] && reference_[s]->parameters == parameters;
    if (!set) set = known ? reference_[s]->replayed : replay_(measured_[s], parameters);
    sets.push_back(std::move(*set));
  }
  return sets;
}

void FullMotions::replay(const Eigen::VectorXd& parameters) {
  std::vector<std::unique_ptr<Reference>> latest;
  for (const ObservationSet& set : measured_)
    latest.push_back(std::make_unique<Reference>(replay_(set, parameters), parameters, threads_));
  reference_ = std::move(latest);
  for (std::size_t s = 0; s < measured_.size(); ++s) was_balanced_[s] = reference_[s]->balanced.has_value();
}

std::vector<ObservationSet> FullMotions::replays() const {
  std::vector<ObservationSet> sets;
  for (const auto& reference : reference_)
    if (reference) sets.push_back(reference->replayed);
  return sets;
}

}  // namespace secular
