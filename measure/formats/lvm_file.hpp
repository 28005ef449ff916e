#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "measure/formats/mat_file.hpp"

namespace secular {

/// The variables of a text file of LabVIEW (LVM): the times "t" in seconds, X_Value of the file (where it has none,
/// from X0 and Delta_X), and the channels by the names and with the units of the file. Empty fields are missing
/// numbers; comments and what stands between ***Start_Special*** and ***End_Special*** are passed over. At most
/// `limit` values of each. `segment`: which of the file's segments, from 0. Throws InputError, also for channels
/// with times that differ.
std::vector<MatVariable> read_lvm(const std::filesystem::path& path, const std::vector<std::string>& wanted = {},
                                  std::size_t limit = all_values, std::size_t segment = 0);

/// How many parts with a header of their own the file has, each of them a record; 1 for one header in all.
std::size_t count_lvm_segments(const std::filesystem::path& path);

/// True if the file begins like an LVM file.
bool looks_like_lvm(const std::filesystem::path& path);

}  // namespace secular
