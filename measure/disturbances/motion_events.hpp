#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace secular {

/// Events that the motion makes itself, turn for turn: dry friction that turns over or sticks, play that is taken
/// up, a stop that is struck while the amplitude lasts. They come in every other turn or more, between the first
/// and the last of them, and at the same phases of a turn: of their phases theta the mean of exp(i k theta) is
/// above the root of 1/2 for a k from 1 to 4 (1 for fixed phases, 0 for any). Fewer than eight tell no phases.
/// `powers`: of the spectrum up to Nyquist, whose strongest bin says how long a turn is.
bool keeps_to_phases(std::span<const double> samples, const std::vector<double>& powers,
                     const std::vector<std::size_t>& events);

/// The same, and events in every other turn or more that tell no phases or come more than twice a turn: where
/// corners of the motion are among the events (the steps of an encoder that is filtered, too) they may be its own.
bool recurs_with_motion(std::span<const double> samples, const std::vector<double>& powers,
                        const std::vector<std::size_t>& events);

}  // namespace secular
