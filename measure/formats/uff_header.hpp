#pragma once

#include <cstddef>

#include "measure/formats/uff_function.hpp"
#include "measure/formats/uff_lines.hpp"

namespace secular {

struct UffHeader {
  UffFunction function;   ///< all but its numbers
  std::size_t count = 0;  ///< of values (of pairs, where the abscissa is uneven) that are to follow
};

/// The eleven lines of a data set 58 in front of its numbers. Throws InputError.
UffHeader read_uff_header(UffLines& lines);

}  // namespace secular
