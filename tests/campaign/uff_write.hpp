#pragma once

#include <string>
#include <vector>

#include "measure/formats/uff_function.hpp"

namespace secular {

enum class UffEncoding { ascii, little_endian, big_endian };

/// A universal file of data sets 58 (ASCII) or 58b. ASCII keeps six digits of single and thirteen of double
/// numbers; the abscissa of ASCII data and the interval of even data have six.
std::string uff_text(const std::vector<UffFunction>& functions, UffEncoding encoding);

}  // namespace secular
