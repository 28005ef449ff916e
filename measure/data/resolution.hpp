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

/// Which values of a channel are equal. Arithmetic on quantised ones (a factor, an offset) leaves differences of a
/// hundred-millionth, five times what a relative change of 1e-9 makes of equal values: next to the larger of two,
/// or to what an eighth of all samples lie beyond, whatever a few of them are. Behind an offset that large, no more
/// than a millionth of the range.
class SameValue {
 public:
  /// Of samples in ascending order.
  explicit SameValue(const std::vector<double>& sorted);
  /// Values that differ by no more from this one are equal to it.
  double within(double value) const;
  bool operator()(double a, double b) const;

 private:
  double floor_ = 0, cap_ = 0;
};

/// A copy of the samples in ascending order, O(n log n), and the grid of such a copy. All samples must be finite.
std::vector<double> in_order(std::span<const double> samples);
ValueGrid grid_of_sorted(const std::vector<double>& sorted);

/// One value and how many samples have it.
struct ValueLevel {
  double value = 0;
  std::size_t count = 0;
};

/// The different values of samples in ascending order.
std::vector<ValueLevel> levels_of_sorted(const std::vector<double>& sorted, const SameValue& same);

}  // namespace secular
