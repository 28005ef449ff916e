#pragma once

#include <optional>
#include <vector>

#include "measure/data/time_axis.hpp"

namespace secular {

/// The axis of even samples whose stamps were rounded (to nearest, up or down) to a decimal tick of more than half
/// the step, so that stamps repeat or are as uneven as that: if steps alternate between two neighbouring numbers of
/// ticks, one line is within a tick of all stamps, and the rates of all such lines are the same to a thousandth. Of
/// these rates it is the expected one, or else the one with the fewest digits. Nothing for other stamps.
std::optional<TimeAxis> axis_of_rounded(const std::vector<double>& stamps, std::optional<double> expected_rate_hz);

}  // namespace secular
