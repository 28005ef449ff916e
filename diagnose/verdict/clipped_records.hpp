#pragma once

#include <cstddef>

namespace secular {

/// Whether samples at an end of their channel's range are left out of a diagnosis. Clipping of a few records is
/// beside the motion; of most of them, it is what they tell.
bool leaves_clipped_out(std::size_t clipped_records, std::size_t records);

}  // namespace secular
