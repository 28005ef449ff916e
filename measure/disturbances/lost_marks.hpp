#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "measure/disturbances/impulses.hpp"

namespace secular {

/// Samples that were lost on their way and are written as one and the same number, wherever the signal stood.
struct LostMarks {
  std::vector<std::size_t> at;  ///< rising
  std::optional<double> value;
};

/// A value of that kind either stands at three spikes or more, or is found by its frequency and by what stands
/// beside it. Its frequency: the record comes to it in more runs than samples hit any one value there. That number
/// of hits is a Poisson law, of which the 32 values on either side tell the mean: values that n samples hit at
/// least once are hit c = lambda / (1 - exp(-lambda)) times in the mean, hence lambda <= min(c, 2 (c - 1)); where
/// lambda is above 1 values recur anyhow, and nothing is told. Beside it: a motion that dwells at a value, or turns
/// there, comes from values near it and leaves to such, those half of all samples that are nearest to it; lost
/// samples have half of their neighbours outside of these. More than a quarter must lie outside. An end of the
/// range, where a channel may be clipped, is such a number where the record comes to it three times or more, each
/// time by more than twice the largest of all other steps, and has more than 64 values. A quarter of a record is
/// not lost.
LostMarks find_lost_marks(std::span<const double> samples, const std::vector<double>& sorted,
                          const Impulses& impulses, double false_alarm);

}  // namespace secular
