#include "measure/data/lost_rows.hpp"

#include <cmath>

#include "measure/data/rounded_stamps.hpp"
#include "numerics/fill_gaps.hpp"
#include "numerics/median.hpp"

namespace secular {
namespace {

/// How far a step may be off a whole number of steps: stamps that scatter by more are no even ones.
constexpr double off_a_whole_number = 0.1;

/// From one and three quarters of a step on, as even_time_axis has it.
constexpr double longer = 1.75;

}  // namespace

std::vector<std::size_t> insert_lost_rows(std::vector<double>& stamps_s,
                                          std::vector<std::vector<double>>& channels) {
  if (stamps_s.size() < 3 || axis_of_rounded(stamps_s, std::nullopt)) return {};
  std::vector<double> steps(stamps_s.size() - 1);
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = stamps_s[i + 1] - stamps_s[i];
  const double step = upper_median(steps);
  if (!(step > 0)) return {};
  std::vector<std::size_t> lost, kept = {0};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double whole = std::round(steps[i] / step);
    if (steps[i] > longer * step) {
      if (std::abs(steps[i] / step - whole) > off_a_whole_number || whole > longest_filled + 1) return {};
      for (int n = 1; n < static_cast<int>(whole); ++n) lost.push_back(kept.back() + static_cast<std::size_t>(n));
    }
    kept.push_back(steps[i] > longer * step ? kept.back() + static_cast<std::size_t>(whole) : kept.back() + 1);
  }
  if (lost.empty()) return {};
  const auto spread = [&](const std::vector<double>& values) {
    std::vector<double> result(kept.back() + 1);
    for (std::size_t i = 0; i < kept.size(); ++i) result[kept[i]] = values[i];
    return result;
  };
  std::vector<double> even = spread(stamps_s);
  for (const std::size_t row : lost) even[row] = even[row - 1] + step;
  stamps_s = std::move(even);
  for (std::vector<double>& channel : channels) channel = spread(channel);
  return lost;
}

}  // namespace secular
