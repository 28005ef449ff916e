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

namespace {

constexpr double equal_share = 1e-8;  // rounding: of values that are equal

}  // namespace

SameValue::SameValue(const std::vector<double>& sorted) {
  const std::size_t eighth = sorted.size() / 8;
  const double usual = std::max(std::abs(sorted[eighth]), std::abs(sorted[sorted.size() - 1 - eighth]));
  floor_ = equal_share * usual;
  cap_ = 1e-6 * (sorted.back() - sorted.front());
}

double SameValue::within(double value) const {
  return std::min(cap_, std::max(floor_, equal_share * std::abs(value)));
}

bool SameValue::operator()(double a, double b) const {
  return std::abs(a - b) <= within(std::max(std::abs(a), std::abs(b)));
}

std::vector<ValueLevel> levels_of_sorted(const std::vector<double>& sorted, const SameValue& same) {
  std::vector<ValueLevel> levels;
  for (const double value : sorted) {
    if (levels.empty() || !same(value, levels.back().value)) levels.push_back({value, 0});
    ++levels.back().count;
  }
  return levels;
}

ValueGrid grid_of_sorted(const std::vector<double>& sorted) {
  ValueGrid grid;
  if (sorted.empty()) return grid;
  const SameValue same(sorted);
  const std::vector<ValueLevel> levels = levels_of_sorted(sorted, same);
  std::vector<double> gaps;
  for (std::size_t k = 1; k < levels.size(); ++k) gaps.push_back(levels[k].value - levels[k - 1].value);
  grid.levels = levels.size();
  if (gaps.empty()) return grid;
  const double smallest = *std::min_element(gaps.begin(), gaps.end());
  // Gaps that are hardly larger than what counts as equal are no lattice's: all of them would be one such gap long.
  if (smallest < 20 * same.within(0)) return grid;
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
