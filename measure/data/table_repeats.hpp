#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "measure/data/line_row.hpp"

namespace secular {

/// Rows with one label are of one condition, an excitation frequency with a level (channel `excitation`): throws
/// InputError naming `file` and the row where they are not.
void require_repeats(const std::vector<LineRow>& rows, std::size_t excitation, const std::string& file);

}  // namespace secular
