#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "measure/formats/data_file.hpp"

namespace secular {

/// A universal file as variables, one for each data set 58. Their names are the first of these that tells all of
/// them apart: ID line 1, the ordinate's label, the response's degree of freedom ("12x+"), "channel 1". In front of
/// them stands "t", the time in seconds, if all time responses share it; else "NAME.t" for each. Values are in SI
/// where the file says quantity and unit, at most `limit` of each. Throws InputError as read_uff does, and for a
/// file without data set 58.
DataFile read_uff_variables(const std::filesystem::path& path, const std::vector<std::string>& wanted,
                            std::size_t limit = all_values, std::size_t segment = 0);

/// How many records it holds: time responses at the same degrees of freedom of two or more channels repeat equally
/// often. `segment` above is the first of them, the second, ...; frequency response functions go with the first.
std::size_t count_uff_segments(const std::filesystem::path& path);

}  // namespace secular
