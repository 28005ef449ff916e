#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace secular {

/// Named columns of numbers of equal length, as read from a file.
struct NumberTable {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;
  std::size_t first_line = 2;  ///< of the file, counted from 1: where row 0 stands; the rows follow without a break
  std::size_t total_rows = 0;  ///< of the file; estimated from its size where only the first rows were read
  std::vector<double>
      last_row{};  ///< of the file, by column, where only the first rows were read; empty if damaged
  std::vector<std::string> units{};  ///< by name: from brackets behind it, or from a row of units; else empty
  std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
};

/// As a limit: every value that is there.
inline constexpr std::size_t all_values = std::numeric_limits<std::size_t>::max();

/// What becomes of a field that holds no finite number.
enum class MissingNumbers {
  refuse,
  keep_gaps,   ///< empty, NaN, infinity: NaN; text is refused
  keep_as_nan  ///< text as well
};

/// The decimal mark of a CSV: as its dialect has it, or one that is known, and then the other mark, a blank or an
/// apostrophe between groups of three digits part thousands.
enum class DecimalMark { by_dialect, point, comma };

struct CsvName {
  std::string name, unit;
};

/// "Time (ms)" or "Time [ms]" -> "Time", "ms".
CsvName bracketed_unit(const std::string& name);

/// Reads a CSV of one of `csv_dialects` with one header line and perhaps a row of units below it; quoted names,
/// CRLF, byte order mark, blanks and trailing empty lines are accepted. Only the `wanted` columns are read, in that
/// order (empty: all), and at most `limit` rows of them. Throws InputError with the line for a row of another
/// length, a field that is no finite number (unless `missing` keeps it), a wanted column that is not there, two
/// columns of one name, and for a file without rows. Times of day without a date go on behind midnight.
NumberTable read_csv(const std::filesystem::path& path, const std::vector<std::string>& wanted = {},
                     MissingNumbers missing = MissingNumbers::refuse, std::size_t limit = all_values,
                     DecimalMark mark = DecimalMark::by_dialect);

/// The header of a CSV, by the same rules: names and units.
NumberTable read_csv_header(const std::filesystem::path& path);

/// The header line of a CSV, and rows of it: numbers so that reading restores them bit by bit.
std::string csv_header(const std::vector<std::string>& names);
std::string csv_rows(const std::vector<std::vector<double>>& columns);

/// Shortest decimal text that restores the number.
std::string number_text(double value);

}  // namespace secular
