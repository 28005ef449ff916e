#pragma once

#include <cstddef>

namespace secular {

/// The largest single allocation by operator new since the last call.
std::size_t take_largest_allocation();

}  // namespace secular
