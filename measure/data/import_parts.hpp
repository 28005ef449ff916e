#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace secular {

/// A file name that says where a record came from, in characters every system knows: "records/STEM.csv", or with a
/// number behind it where that is taken.
std::string record_file(const std::filesystem::path& source, std::set<std::string>& taken);

/// Value of an option that is given once for all records or once a record. Throws InputError for another count and
/// for a number that is not positive.
std::optional<double> of_file(const std::vector<double>& values, std::size_t file, std::size_t files,
                              const char* option);

}  // namespace secular
