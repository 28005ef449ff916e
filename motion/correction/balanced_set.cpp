#include "motion/correction/balanced_set.hpp"

#include <algorithm>
#include <span>

#include "motion/correction/mean_motion.hpp"
#include "numerics/in_parallel.hpp"

namespace secular {
namespace {

// Of a replay, whose ensembles are alike, the mean is each of them.
Observation mean_of(std::span<const Observation> observations, const ObservationSet& set) {
  return set.resonance->excited ? mean_motion(observations, *set.model, *set.resonance) : observations.front();
}

}  // namespace

BalancedSet::BalancedSet(const ObservationSet& set, unsigned threads)
    : set_(set), motions_(*set.model, *set.resonance), threads_(threads) {
  const std::vector<Observation>& all = set.observations;
  for (std::size_t begin = 0; begin < all.size();) {
    std::size_t end = begin + 1;
    while (set.resonance->excited && end < all.size() && all[end].record == all[begin].record) ++end;
    groups_.push_back({mean_of(std::span(all).subspan(begin, end - begin), set), begin, end, std::nullopt});
    begin = end;
  }
}

std::optional<ObservationSet> BalancedSet::at(const Eigen::VectorXd& parameters) {
  ObservationSet result = set_;
  std::vector<char> found(groups_.size(), false);  // not of bool, whose elements share bytes
  in_parallel(groups_.size(), threads_, [&](std::size_t g) {
    Group& group = groups_[g];
    auto balanced = motions_.at(parameters, group.mean, group.latest ? &*group.latest : nullptr);
    if (!balanced && group.latest) balanced = motions_.at(parameters, group.mean);
    if (!balanced) return;
    Observation exact = group.mean;
    motions_.show(*balanced, exact);
    for (std::size_t i = group.begin; i < group.end; ++i) take_motion(exact, result.observations[i]);
    group.latest = std::move(balanced->motion);
    found[g] = true;
  });
  if (std::find(found.begin(), found.end(), false) != found.end()) return std::nullopt;
  return result;
}

}  // namespace secular
