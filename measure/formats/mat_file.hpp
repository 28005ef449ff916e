#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "measure/formats/number_table.hpp"

namespace secular {

/// One numeric variable of a MAT file: fields of structs as "a.b", elements of struct arrays and cells as "a(2).b"
/// and "c{2}".
struct MatVariable {
  std::string path;
  std::vector<std::size_t> shape;
  std::string type;            ///< "double", "int16", "complex double", ...
  std::vector<double> values;  ///< if it was wanted and is a vector
  std::string fault;           ///< why it has no values: "is complex", "is empty", ...; empty if it has
  std::string unit{};          ///< as the file spells it (HDF5: the attribute `units`)
};

/// The numeric variables of a MAT v5 file, in file order; with values (the first `limit`) those of `wanted`
/// (empty: all). Throws
/// InputError for anything else (v7.3 is HDF5: read_hdf5) and for a file that is damaged or cut short.
std::vector<MatVariable> read_mat(const std::filesystem::path& path, const std::vector<std::string>& wanted = {},
                                  std::size_t limit = all_values);

/// True if the file begins like a MAT file (v5 or v7.3).
bool looks_like_mat(const std::filesystem::path& path);

/// Why an object of MATLAB's (a timetable, ...) is no channel, and what makes channels of it.
std::string matlab_object_fault(const std::string& name);

}  // namespace secular
