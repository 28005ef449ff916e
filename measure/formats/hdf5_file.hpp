#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "measure/formats/mat_file.hpp"

namespace secular {

/// The numeric variables of an HDF5 file, MAT v7.3 among them: members of groups (fields of structs) as "a.b",
/// elements of MATLAB's struct arrays and cells as "a(2).b" and "c{2}"; with values (the first `limit`)
/// those of `wanted` (empty: all).
/// Reads what MATLAB and programs of HDF5's default, most compatible format write, not what only version 1.10 and
/// later of HDF5 know. Written for damaged files too, unlike HDF5's own library. Throws InputError.
std::vector<MatVariable> read_hdf5(const std::filesystem::path& path, const std::vector<std::string>& wanted = {},
                                   std::size_t limit = all_values);

/// True if the signature of HDF5 stands at the begin of the file or behind a user block of 512, 1024, ... bytes.
bool looks_like_hdf5(const std::filesystem::path& path);

}  // namespace secular
