#pragma once

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

namespace secular {

/// Channels, indices of the campaign, of which the zero moves slowly: what is read there at rest says nothing of
/// the motion, and is another thing in every record and from one stretch of a record to the next.
using WanderingZeros = std::set<std::size_t>;

/// Whether that of one of these channels does.
inline bool any_wanders(const WanderingZeros& zeros, const std::vector<std::size_t>& channels) {
  return std::any_of(channels.begin(), channels.end(), [&](std::size_t c) { return zeros.contains(c); });
}

}  // namespace secular
