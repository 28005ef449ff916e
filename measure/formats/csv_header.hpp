#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "measure/formats/csv_dialect.hpp"

namespace secular {

/// What stands above the rows of a CSV.
struct CsvHeader {
  std::vector<std::string> names, units;
  CsvDialect dialect;
  char line_break = '\n';                   ///< or, in a text without any, a carriage return
  std::size_t line = 0;                     ///< of the names, or of the first row where there are none
  std::size_t last_line = 0;                ///< before the rows
  std::string_view rows;                    ///< the text below
  double counted_from = 0, counted_by = 0;  ///< the first column counts samples: its time in s is from + by*count
};

/// Lines that begin with # and empty ones are passed over, and so is what has another number of fields than the
/// names above the first row of numbers; sep= states the separator; a comment directly above the rows may hold the
/// names. Where no line has a separator of csv_dialects, blanks part columns. Where the first line is a row of
/// numbers and no line names columns, they are column1, column2, ...; so is a first one without a name. Names may
/// be numbers where a line of units follows. Text that is not UTF-8 is taken for Latin-1. A control-Z at the end
/// belongs to no row. Throws InputError.
CsvHeader read_header(std::string_view text, const std::string& file);

/// "column1", ...: what columns without names are called, counted from 0 here.
std::string nameless_column(std::size_t column);
bool is_nameless_column(std::string_view name);

/// Takes the next line off `rest`, without its line break.
std::string_view next_line(std::string_view& rest, char line_break);

/// Without blanks, tabulators and carriage returns at its ends.
std::string_view trimmed(std::string_view text);
/// Without the double quotes around it, if it stands in them.
std::string_view unquoted(std::string_view text);

/// A field as messages show it.
std::string shown(std::string_view field);

/// What a field is that is no number.
enum class FieldFault { none, empty, text, not_finite };

/// A number as programs write it: also with a sign, in quotes, with D for its exponent, or as a time of day (then
/// in s). `value` counts only where there is no fault.
FieldFault parse_number(std::string_view field, bool decimal_comma, double& value);

/// A number whose decimal mark is known: the other mark, a blank or an apostrophe may part its whole part into
/// groups of three digits (the first of one to three).
FieldFault parse_grouped_number(std::string_view field, bool decimal_comma, double& value);

}  // namespace secular
