#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "estimator/campaign/number_table.hpp"
#include "estimator/campaign/time_axis.hpp"

namespace secular {

/// A named variable of a data file: a column of a CSV or a numeric variable of a MAT file.
struct DataVariable {
  std::string name;
  std::vector<std::size_t> shape;
  std::string type;            ///< "double", "int16", ...; "text" for a CSV column without any number
  std::vector<double> values;  ///< NaN where no number stands (MissingNumbers::keep_as_nan)
  std::string fault;           ///< why it has no values: "is a matrix", ...; empty if it has
};

/// What a CSV or MAT v5 file holds.
struct DataFile {
  std::string file;
  std::string format;  ///< "CSV" or "MAT v5"
  std::vector<DataVariable> variables;
  RowPlace place;

  /// The variable of that name, which must be a vector of numbers. Throws InputError that names the variables there
  /// are.
  const DataVariable& vector(const std::string& name) const;
  /// Their names, as messages list them.
  std::string names() const;
};

/// Reads the variables (values of `wanted` only; empty: of all). Throws InputError for a file of another format
/// (UFF and MAT v7.3 are not supported yet), a damaged one, and (MissingNumbers::refuse) a value that is no finite
/// number.
DataFile read_data_file(const std::filesystem::path& path, const std::vector<std::string>& wanted = {},
                        MissingNumbers missing = MissingNumbers::refuse);

/// Names of the variables that `read_data_file` would find.
std::vector<std::string> data_variable_names(const std::filesystem::path& path);

}  // namespace secular
