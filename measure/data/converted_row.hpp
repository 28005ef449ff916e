#pragma once

#include <cstddef>
#include <string>

#include "measure/data/found_columns.hpp"
#include "measure/data/line_row.hpp"
#include "measure/data/loaded_table.hpp"
#include "measure/data/table_request.hpp"

namespace secular {

struct ConvertedRow {
  LineRow row;
  std::string damage;  ///< "tip is no number": why the row cannot be used; empty: it can
};

/// Row `i` as a LineRow has it: in SI units, peak, phases against the excitation, responses no longer over it. The
/// lines stand in the order of channels and numbers, the excitation's level always among them. Throws InputError
/// where it is not known whether a phase is in degrees or radians.
ConvertedRow converted_row(const LoadedTable& table, std::size_t i, const FoundColumns& columns,
                           const TableRequest& request);

}  // namespace secular
