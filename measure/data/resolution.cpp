#include "measure/data/resolution.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace secular {

std::vector<double> in_order(std::span<const double> samples) {
  std::vector<double> sorted(samples.begin(), samples.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

double equal_within(const std::vector<double>& sorted) {
  return std::min(1e-8 * std::max(std::abs(sorted.front()), std::abs(sorted.back())),
                  1e-6 * (sorted.back() - sorted.front()));
}

std::vector<ValueLevel> levels_of_sorted(const std::vector<double>& sorted, double same) {
  std::vector<ValueLevel> levels;
  for (const double value : sorted) {
    if (levels.empty() || value - levels.back().value > same) levels.push_back({value, 0});
    ++levels.back().count;
  }
  return levels;
}

ValueGrid grid_of_sorted(const std::vector<double>& sorted) {
  ValueGrid grid;
  if (sorted.empty()) return grid;
  const double same = equal_within(sorted);
  const std::vector<ValueLevel> levels = levels_of_sorted(sorted, same);
  std::vector<double> gaps;
  for (std::size_t k = 1; k < levels.size(); ++k) gaps.push_back(levels[k].value - levels[k - 1].value);
  grid.levels = levels.size();
  if (gaps.empty()) return grid;
  const double smallest = *std::min_element(gaps.begin(), gaps.end());
  // Gaps that are hardly larger than what counts as equal are no lattice's: all of them would be one such gap long.
  if (smallest < 20 * same) return grid;
  const auto on_grid = std::count_if(gaps.begin(), gaps.end(), [&](double gap) {
    const double multiple = gap / smallest;
    return std::abs(multiple - std::round(multiple)) < 0.05;
  });
  // Unquantised values hit a multiple by chance in one of ten gaps; three levels are too few to tell.
  if (gaps.size() < 3 || static_cast<double>(on_grid) < 0.95 * static_cast<double>(gaps.size())) return grid;
  grid.step = smallest;
  // The smallest gap is low by the rounding of two printed numbers, more than a step over many steps.
  double steps = 0;
  for (const double gap : gaps) steps += std::round(gap / smallest);
  grid.mean_step = (levels.back().value - sorted.front()) / steps;
  const auto middle = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2);
  std::nth_element(gaps.begin(), middle, gaps.end());
  grid.visited = *middle < 8.5 * smallest;
  return grid;
}

}  // namespace secular
