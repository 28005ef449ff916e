#pragma once

#include <string>
#include <vector>

namespace secular {

/// The two parts of csv_text (number_table.hpp), for tables that are written piece by piece.
std::string csv_header(const std::vector<std::string>& names);
std::string csv_rows(const std::vector<std::vector<double>>& columns);

}  // namespace secular
