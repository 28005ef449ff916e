#pragma once

#include <cstddef>
#include <string>

#include "measure/data/found_columns.hpp"
#include "measure/data/table_request.hpp"
#include "measure/formats/data_file.hpp"

namespace secular {

/// The columns of a table with their numbers: of one length, in range, and of what their channels measure. Units
/// that the file states are taken to SI.
struct LoadedTable {
  DataFile data;
  double hertz = 1;  ///< of one unit of its frequencies
  std::size_t rows = 0;

  double at(const std::string& column, std::size_t row) const { return data.vector(column).values[row]; }
};

/// `data` holds the values of FoundColumns::all(). Throws InputError with file and place.
LoadedTable loaded_table(DataFile data, const FoundColumns& columns, const TableRequest& request);

}  // namespace secular
