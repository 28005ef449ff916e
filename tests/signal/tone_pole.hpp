#pragma once

#include <numbers>

#include "measure/signal/pole.hpp"

namespace secular {

/// Samples per second of the tests that take tones in hertz.
inline constexpr double rate = 256;

inline Pole tone(double hertz) { return {PoleFamily::circular, 2 * std::numbers::pi * hertz, 0, false}; }

}  // namespace secular
