#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measure/formats/row_place.hpp"

namespace secular {

struct TimeAxis {
  double start_s = 0;
  double sample_rate_hz = 0;
  double jitter_s = 0;  ///< rms scatter of the stamps about it, where that is more than how they are rounded
};

/// Of a step, by which stamps may be off even ones: how many steps lie between any two is told to less than half of
/// one.
inline constexpr double largest_jitter = 0.25;

/// Steps between stamps that can be neighbours are no longer than this, next to their median: where one is missing
/// a step is two long, less what stamps may jitter against each other.
double longest_step();

/// Checks that time stamps are finite and increase evenly and gives their start and rate. The rate is the
/// least-squares line's, or rather the simplest number that follows the stamps as closely as that line:
/// `expected_rate_hz` if it does, else the rate or step with the fewest digits. Stamps may jitter by a quarter of
/// the step. What is left of them may be rounding: to the digits that all stamps are printed with, to single
/// precision, or (steps of two neighbouring sizes) to the ticks of a clock; anything else above a millionth of the
/// step is jitter_s. Throws InputError naming `file` and the row for a gap, a stamp that is no number, a repeated
/// or backward one.
TimeAxis even_time_axis(const std::vector<double>& stamps, const std::string& file, const RowPlace& place,
                        std::optional<double> expected_rate_hz = {});

}  // namespace secular
