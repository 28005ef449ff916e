#pragma once

#include <numbers>

namespace secular {

/// Angular frequency (rad/s) of one hertz.
inline constexpr double two_pi = 2 * std::numbers::pi;

/// Hertz of one rad/s.
inline constexpr double to_hz = 1 / two_pi;

}  // namespace secular
