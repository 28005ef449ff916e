#include "measure/data/line_table.hpp"

#include <utility>

#include "input/input_error.hpp"
#include "measure/data/converted_row.hpp"
#include "measure/data/found_columns.hpp"
#include "measure/data/loaded_table.hpp"
#include "measure/data/table_repeats.hpp"

namespace secular {

LineTable read_line_table(const std::filesystem::path& path, const TableRequest& request) {
  const FoundColumns columns = find_columns(path.string(), describe_data_file(path), request);
  const LoadedTable loaded =
      loaded_table(read_data_file(path, columns.all(), MissingNumbers::keep_gaps), columns, request);
  LineTable table;
  table.unused = columns.unused;
  for (std::size_t i = 0; i < loaded.rows; ++i) {
    ConvertedRow converted = converted_row(loaded, i, columns, request);
    if (converted.damage.empty())
      table.rows.push_back(std::move(converted.row));
    else
      table.damaged.push_back(converted.row.place + ": " + converted.damage);
  }
  require_repeats(table.rows, columns.excitation, path.string());
  if (table.rows.empty())
    throw InputError(path.string(), "", "has no row that can be used",
                     table.damaged.empty() ? "a row for every settled dwell was expected"
                                           : "its first: " + table.damaged.front());
  return table;
}

}  // namespace secular
