#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "measure/data/line_row.hpp"
#include "measure/data/table_request.hpp"
#include "measure/formats/data_file.hpp"

namespace secular {

/// Columns of one line of one channel; those that are not there are empty.
struct LineColumns {
  std::size_t channel = 0;  ///< in TableRequest::channels
  LineNumber number{};
  std::string amplitude{}, phase{}, real{}, imaginary{}, sd{}, phase_sd{};

  bool found() const { return !amplitude.empty() || !real.empty(); }
};

/// Which variables of a file make a table of lines.
struct FoundColumns {
  std::string frequency, condition;  ///< condition: empty if there is none
  std::vector<LineColumns> lines;
  std::size_t excitation = 0;       ///< in TableRequest::channels
  bool per_excitation = false;      ///< as asked for, or because the file says that it holds response functions
  std::vector<std::string> unused;  ///< variables of the file

  /// All of them, each once.
  std::vector<std::string> all() const;
};

/// Finds them among the variables of `file`: by TableRequest::columns, else by name. Throws InputError where a
/// column that is needed is not there or not the only one, and where a given one belongs to nothing.
FoundColumns find_columns(const std::string& file, const std::vector<DataVariable>& variables,
                          const TableRequest& request);

}  // namespace secular
