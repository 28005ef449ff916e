#pragma once

#include <cstddef>

namespace secular {

/// The largest single allocation by operator new since the last call.
std::size_t take_largest_allocation();

/// The most that operator new held at any time since the last call beyond what it held then (one thread at a time).
std::size_t take_allocated_peak();

}  // namespace secular
