#include "motion/correction/balanced_set.hpp"

#include <algorithm>
#include <span>

#include "measure/observe/record_ranges.hpp"
#include "motion/correction/mean_motion.hpp"
#include "numerics/in_parallel.hpp"

namespace secular {
BalancedSet::BalancedSet(const ObservationSet& set, unsigned threads)
    : set_(set), motions_(*set.model, *set.resonance), threads_(threads) {
  const std::span<const Observation> all = set.observations;
  if (set.resonance->excited) {
    for (const RecordRange& dwell : ranges_of_records(all))
      groups_.push_back(
          {mean_motion(dwell.of(all), *set.model, *set.resonance), dwell.begin, dwell.end, std::nullopt});
  } else {
    for (std::size_t i = 0; i < all.size(); ++i) groups_.push_back({all[i], i, i + 1, std::nullopt});
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
