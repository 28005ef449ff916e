#include "measure/data/lost_rows.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "measure/data/rounded_stamps.hpp"
#include "measure/data/time_axis.hpp"
#include "numerics/fill_gaps.hpp"
#include "numerics/median.hpp"

namespace secular {

std::vector<std::size_t> lost_rows(const std::vector<double>& stamps_s) {
  const auto finite = [](double x) { return std::isfinite(x); };
  if (stamps_s.size() < 3 || !std::all_of(stamps_s.begin(), stamps_s.end(), finite)) return {};
  std::vector<double> steps(stamps_s.size() - 1);
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = stamps_s[i + 1] - stamps_s[i];
  const double step = upper_median(steps);
  if (!(step > 0)) return {};
  std::vector<std::size_t> lost;
  std::size_t place = 0;  // among all rows
  for (const double here : steps) {
    ++place;
    if (!(here > longest_step() * step)) continue;
    const double whole = std::round(here / step);
    if (std::abs(here / step - whole) > largest_jitter || whole > longest_filled + 1) return {};
    for (double n = 1; n < whole; ++n) lost.push_back(place++);
  }
  if (!lost.empty() && axis_of_rounded(stamps_s, std::nullopt)) return {};
  return lost;
}

bool fill_lost_rows(const std::vector<std::size_t>& lost, std::vector<double>& stamps_s,
                    std::vector<std::vector<double>>& channels) {
  if (lost.empty()) return false;
  const auto spread = [&](const std::vector<double>& values) {
    std::vector<double> all(values.size() + lost.size());
    auto next = lost.begin();
    std::size_t from = 0;
    for (std::size_t row = 0; row < all.size(); ++row) {
      if (next != lost.end() && *next == row)
        ++next;
      else
        all[row] = values[from++];
    }
    return all;
  };
  std::vector<std::vector<double>> filled;
  for (const std::vector<double>& channel : channels) {
    if (!std::all_of(channel.begin(), channel.end(), [](double x) { return std::isfinite(x); })) return false;
    filled.push_back(spread(channel));
    if (!fill_gaps(filled.back(), lost).empty()) return false;
  }
  // A run of lost rows shares the step across it.
  std::vector<double> stamps = spread(stamps_s);
  for (std::size_t i = 0; i < lost.size();) {
    std::size_t end = i + 1;
    while (end < lost.size() && lost[end] == lost[end - 1] + 1) ++end;
    const double before = stamps[lost[i] - 1], after = stamps[lost[end - 1] + 1];
    const auto parts = static_cast<double>(end - i + 1);
    for (std::size_t n = i; n < end; ++n)
      stamps[lost[n]] = before + (after - before) * static_cast<double>(n - i + 1) / parts;
    i = end;
  }
  stamps_s = std::move(stamps);
  channels = std::move(filled);
  return true;
}

}  // namespace secular
