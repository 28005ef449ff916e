#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace secular {

/// The grid that finite samples lie on, as an encoder, a converter or printed decimals leave it.
struct ValueGrid {
  std::size_t levels = 0;           ///< different values (equal_within)
  std::optional<double> step;       ///< smallest gap between levels, if (nearly) all gaps are multiples of it
  std::optional<double> mean_step;  ///< with `step`: the range over the steps in it, told far better than one gap
  bool visited = false;  ///< most neighbouring levels are few steps apart: the step is the channel's resolution
};

/// Values that differ by no more are equal: arithmetic on quantised ones (a factor, an offset) leaves such
/// differences. A hundred-millionth of the largest magnitude is five times what a relative change of 1e-9 makes of
/// equal values; behind an offset that large, no more than a millionth of the range.
double equal_within(const std::vector<double>& sorted);

/// A copy of the samples in ascending order, O(n log n), and the grid of such a copy. All samples must be finite.
std::vector<double> in_order(std::span<const double> samples);
ValueGrid grid_of_sorted(const std::vector<double>& sorted);

/// One value and how many samples have it.
struct ValueLevel {
  double value = 0;
  std::size_t count = 0;
};

/// The different values of such a copy: those that are more than `same` above the one before.
std::vector<ValueLevel> levels_of_sorted(const std::vector<double>& sorted, double same);

}  // namespace secular
