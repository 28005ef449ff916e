#include "diagnose/verdict/gap_shares.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "diagnose/thresholds.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// A smaller share is not worth a line.
constexpr auto& least_share = diagnose_thresholds().least_share;

/// A group with this share of its energy on one side of the middle amplitude is said to be there.
constexpr auto& one_sided = diagnose_thresholds().one_sided;

struct Energy {
  double low = 0, high = 0;  ///< below and above the place's middle amplitude
  double sum() const { return low + high; }
};

std::map<std::string, double> middle_amplitudes(const std::vector<RowLabel>& labels) {
  std::map<std::string, std::vector<double>> amplitudes;
  for (const RowLabel& label : labels) amplitudes[label.place].push_back(label.amplitude);
  std::map<std::string, double> middle;
  for (auto& [place, values] : amplitudes) {
    const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), half, values.end());
    middle[place] = *half;
  }
  return middle;
}

std::string region_of(const Energy& energy, double middle) {
  const double high = energy.high / energy.sum();
  if (high > one_sided) return fmt::format("amplitude > {:.3g}", 2 * middle);
  if (high < 1 - one_sided) return fmt::format("amplitude < {:.3g}", 2 * middle);
  return "all amplitudes";
}

}  // namespace

std::vector<GapShare> gap_shares(const VectorXd& rows, const VectorXd& unmixed, const std::vector<RowLabel>& labels,
                                 const Candidate* named) {
  std::map<std::string, double> middle = middle_amplitudes(labels);
  const bool finer = named && named->component != EffectComponent::conservative &&
                     named->component != EffectComponent::dissipative;
  std::map<std::tuple<std::string, EffectComponent, std::string>, Energy> groups;
  double total = 0;
  for (std::size_t r = 0; r < labels.size(); ++r) {
    const RowLabel& label = labels[r];
    const auto i = static_cast<Index>(r);
    double energy = rows(i) * rows(i);
    EffectComponent component = label.component;
    if (label.balance) {
      // Errors in phase and in quadrature are correlated: the pair's weight goes to where the force is.
      const Index pair = component == EffectComponent::conservative ? i + 1 : i - 1;
      const double here = unmixed(i) * unmixed(i), there = unmixed(pair) * unmixed(pair);
      energy = (energy + rows(pair) * rows(pair)) * here / std::max(here + there, 1e-300);
      if (finer && (!named->equation || named->mode == label.mode)) component = named->component;
    }
    total += energy;
    Energy& group = groups[{label.place, component, label.harmonic}];
    (label.amplitude > middle[label.place] ? group.high : group.low) += energy;
  }
  std::vector<GapShare> shares;
  for (const auto& [key, energy] : groups) {
    const double share = energy.sum() / std::max(total, 1e-300);
    if (share < least_share) continue;
    const auto& [place, component, harmonic] = key;
    shares.push_back({place, component, harmonic, region_of(energy, middle[place]), share});
  }
  std::stable_sort(shares.begin(), shares.end(),
                   [](const GapShare& a, const GapShare& b) { return a.share > b.share; });
  return shares;
}

}  // namespace secular
