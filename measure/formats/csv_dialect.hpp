#pragma once

#include <string_view>

namespace secular {

/// What may stand between the fields of a CSV, and whether numbers may then have a decimal comma.
struct CsvDialect {
  char separator = ',';
  std::string_view name;
  bool decimal_comma = false;
  bool in_names = false;  ///< names may hold it: a campaign's files have commas, which are looked for before
};

/// A file is of the first one whose separator stands in its header line outside of quotes; of the comma if none
/// does. No channel's name holds one of them without `in_names`.
inline constexpr CsvDialect csv_dialects[] = {
    {';', "semicolon", true}, {',', "comma"}, {'\t', "tabulator", true}, {'|', "vertical bar", true, true}};

/// Columns of a text without any of these separators, which one blank or more part.
inline constexpr CsvDialect blank_dialect = {' ', "blank", true};

}  // namespace secular
