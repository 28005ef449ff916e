#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "measure/formats/mat_file.hpp"

namespace secular {

/// The variables of a text file of LabVIEW (LVM): the times "t" in seconds, X_Value of the file (where it has none,
/// from X0 and Delta_X), and the channels by the names and with the units of the file. Empty fields are missing
/// numbers; comments are passed over. At most `limit` values of each. Throws InputError, also for a file of several
/// segments, which are several records, and for channels with times that differ.
std::vector<MatVariable> read_lvm(const std::filesystem::path& path, const std::vector<std::string>& wanted = {},
                                  std::size_t limit = all_values);

/// True if the file begins like an LVM file.
bool looks_like_lvm(const std::filesystem::path& path);

}  // namespace secular
