#include "motion/correction/gain_drift.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "estimator/identification/beyond_chance.hpp"
#include "measure/observe/observed_blocks.hpp"
#include "measure/observe/record_ranges.hpp"

namespace secular {
namespace {

/// Dwells that tell a common drift and how it scatters.
constexpr std::size_t fewest_dwells = 3;

struct Slope {
  double value = 0, variance = 0;
};

// Of the logarithm of the largest mode's amplitude over the excitation's, in one dwell; nothing without noise.
std::optional<Slope> slope_of(std::span<const Observation> ensembles) {
  if (ensembles.size() < 2 || ensembles.front().forcing.size() != 1) return std::nullopt;
  const std::size_t mode = largest_mode(ensembles.front());
  double mean = 0;
  for (const Observation& o : ensembles) mean += o.centre_s / static_cast<double>(ensembles.size());
  double squares = 0;
  for (const Observation& o : ensembles) squares += (o.centre_s - mean) * (o.centre_s - mean);
  if (!(squares > 0)) return std::nullopt;
  Slope slope;
  for (const Observation& o : ensembles) {
    const double size = std::abs(o.amplitude[mode]), level = std::abs(o.forcing.front());
    if (!(size > 0) || !(level > 0) || !o.noise_known) return std::nullopt;
    const double share = (o.centre_s - mean) / squares;
    slope.value += share * std::log(size / level);
    slope.variance +=
        share * share * (std::pow(o.amplitude_sd[mode] / size, 2) + std::pow(o.forcing_sd.front() / level, 2));
  }
  return slope.variance > 0 ? std::optional(slope) : std::nullopt;
}

}  // namespace

std::optional<double> gain_drift(std::span<const ObservationSet> measured) {
  std::vector<Slope> slopes;
  for (const ObservationSet& set : measured)
    for (const RecordRange& range : ranges_of_records(set.observations))
      if (set.resonance->excited)
        if (const auto slope = slope_of(range.of(set.observations))) slopes.push_back(*slope);
  if (slopes.size() < fewest_dwells) return std::nullopt;
  const auto count = static_cast<Eigen::Index>(slopes.size());
  Eigen::MatrixXd matrix(count, 1);
  Eigen::VectorXd target(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Slope& one = slopes[static_cast<std::size_t>(i)];
    matrix(i, 0) = 1 / std::sqrt(one.variance);
    target(i) = one.value / std::sqrt(one.variance);
  }
  const double drift = beyond_chance(matrix, target, 0, static_cast<double>(count - 1));
  return drift != 0 ? std::optional(drift) : std::nullopt;
}

ObservationSet with_first_gain(ObservationSet set, double drift) {
  if (!set.resonance->excited) return set;
  for (const RecordRange& range : ranges_of_records(set.observations)) {
    const Observation& first = set.observations[range.begin];
    const double begin =
        first.centre_s -
        0.5 * (range.end - range.begin > 1 ? set.observations[range.begin + 1].centre_s - first.centre_s : 0.0);
    for (std::size_t i = range.begin; i < range.end; ++i) {
      Observation& o = set.observations[i];
      const double by = std::exp(-drift * (o.centre_s - begin));
      for (std::complex<double>& amplitude : o.amplitude) amplitude *= by;
      for (std::complex<double>& harmonic : o.harmonic) harmonic *= by;
    }
  }
  return set;
}

double longest_dwell_s(std::span<const ObservationSet> measured) {
  double longest = 0;
  for (const ObservationSet& set : measured)
    for (const RecordRange& range : ranges_of_records(set.observations))
      if (set.resonance->excited)
        longest =
            std::max(longest, set.observations[range.end - 1].centre_s - set.observations[range.begin].centre_s);
  return longest;
}

}  // namespace secular
