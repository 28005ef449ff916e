#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "measure/data/line_row.hpp"

namespace secular {

/// What stands behind a channel's name for its line at a multiple of the excitation's frequency: "@1/2"; nothing
/// for the line at that frequency itself.
std::string line_suffix(LineNumber number);

/// The number in "3" or "1/2". Nothing for another text, and for parts above 999: a longer number is no line's.
std::optional<LineNumber> parsed_line_number(std::string_view text);

}  // namespace secular
