#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace secular {

/// So many (`kept`) of a row of units, spread over it evenly by size: each is taken as often as its share of the
/// sizes (systematic sampling with probability proportional to size; W. G. Cochran, Sampling Techniques, 3rd ed.,
/// Wiley, 1977, section 9A.10). Those that are due more than once are taken, and the rest is spread over the
/// others. Nothing is drawn: of each of the equal parts of the sum one unit is taken, at another place in each part
/// (1/2, 1/4, 3/4, 1/8, ... of it: a Hammersley set), so that what repeats from part to part is not met at one
/// phase (docs/inference.md (59)). `sizes` >= 0, finite; places come in rising order, min(kept, sizes.size()) of
/// them.
std::vector<std::size_t> spread_by_size(std::span<const double> sizes, std::size_t kept);

}  // namespace secular
