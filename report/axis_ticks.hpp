#pragma once

#include <string>
#include <vector>

namespace secular::report {

struct Tick {
  double position = 0;  ///< in units of the data
  std::string label;    ///< empty for a minor tick
};

/// Ticks of an axis and the power of ten taken out of its labels: label = position / 10^power.
struct AxisTicks {
  std::vector<Tick> ticks;
  int power_of_ten = 0;
};

/// About `count` ticks at multiples of 1, 2 or 5 times a power of ten inside [low, high], low < high, both finite.
/// The power of ten is taken out (in threes) where the labels would otherwise be below 0.01 or from 10^5 on.
AxisTicks linear_ticks(double low, double high, int count);

/// Decades inside [low, high], 0 < low < high, thinned to about `count`, with minor ticks between neighbouring
/// decades; where fewer than two decades lie inside, ticks at 1, 2, 5 (or, over less than that, as linear_ticks)
/// instead.
AxisTicks logarithmic_ticks(double low, double high, int count);

}  // namespace secular::report
