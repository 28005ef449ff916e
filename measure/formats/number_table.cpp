#include "measure/formats/number_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <string_view>

#include "input/input_error.hpp"
#include "measure/formats/csv_header.hpp"
#include "measure/formats/mapped_file.hpp"
#include "measure/formats/unit.hpp"
#include "measure/formats/utf16.hpp"

namespace secular {
namespace {

[[noreturn]] void refuse(const std::string& file, const std::string& place, FieldFault fault,
                         std::string_view field) {
  if (fault == FieldFault::empty) throw InputError(file, place, "is empty", "a number was expected");
  if (double value = 0; fault == FieldFault::text)
    for (const bool comma : {false, true})
      if (parse_grouped_number(field, comma, value) == FieldFault::none)
        throw InputError(
            file, place, shown(field) + " is not a number as it stands",
            fmt::format("if its decimal mark is {0}: secular import with --decimal-mark {0}", comma ? ',' : '.'));
  if (fault == FieldFault::text)
    throw InputError(file, place, shown(field) + " is not a number", "a number was expected");
  throw InputError(file, place, shown(field) + " is not a finite number", "cut the record around missing samples");
}

constexpr std::size_t skipped = std::numeric_limits<std::size_t>::max();

// Where numbers of a file have a decimal point and a comma: both in one file means that one of them parts
// thousands, and nothing says which.
struct DecimalMarks {
  std::size_t point = 0, comma = 0;  // first lines

  void see(std::string_view field, std::size_t line, const std::string& file) {
    if (point == 0 && field.find('.') != std::string_view::npos) point = line;
    if (comma == 0 && field.find(',') != std::string_view::npos) comma = line;
    if (point > 0 && comma > 0)
      throw InputError(
          file, fmt::format("line {}", std::max(point, comma)),
          fmt::format("numbers have decimal points (line {}) and commas (line {})", point, comma),
          "say which mark is decimal: secular import with --decimal-mark . or --decimal-mark , (the other one "
          "then parts thousands)");
  }
};

// Where the first field of a line ends at the earliest: separators inside of quotes part nothing.
std::size_t behind_quotes(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t");
  if (begin == std::string_view::npos || line[begin] != '"') return 0;
  const std::size_t end = line.find('"', begin + 1);
  return end == std::string_view::npos ? 0 : end + 1;
}

/// The text of a file: as it is, or all of it made anew where it is UTF-16.
class TextFile {
 public:
  explicit TextFile(const std::filesystem::path& path) : mapped_(path) {
    if (const std::optional<ByteOrder16> order = utf16_order(mapped_.bytes()))
      made_ = utf8_of_utf16(mapped_.bytes(), *order);
  }
  std::string_view bytes() const { return made_ ? *made_ : mapped_.bytes(); }
  /// See MappedFile.
  void release_before(std::size_t offset) {
    if (!made_) mapped_.release_before(offset);
  }
  void forget(std::size_t begin, std::size_t end) {
    if (!made_) mapped_.forget(begin, end);
  }

 private:
  MappedFile mapped_;
  std::optional<std::string> made_;
};

constexpr double day_s = 86400;

// Times of day go on behind midnight: a stamp that is earlier than the one before by more than half a day is of the
// next one. (A clock that is set back goes back by less.)
void continue_behind_midnight(std::vector<double>& stamps) {
  double days = 0, before = -day_s;
  for (double& stamp : stamps) {
    if (!std::isfinite(stamp)) continue;
    while (stamp + days < before - day_s / 2) days += day_s;
    stamp += days;
    before = stamp;
  }
}

/// Puts the fields of rows into the columns of a table.
struct RowReader {
  const CsvHeader& header;
  const std::vector<std::size_t>& target;  // of every field: a column of the table, or `skipped`
  MissingNumbers missing;
  const std::string& file;
  DecimalMarks& marks;
  DecimalMark mark;           // where it is known
  std::vector<bool>& clock;   // by column of the table: a time of day without a date stands in its first row
  std::vector<bool>& stamps;  // the same, with a date or without

  void read(std::string_view line, std::size_t line_number, NumberTable& table) const {
    std::size_t fields = 0;
    for (bool more = true; more;) {
      const std::size_t end = line.find(header.dialect.separator, behind_quotes(line));
      more = end != std::string_view::npos;
      const std::string_view field = trimmed(line.substr(0, end));
      if (more) line.remove_prefix(end + 1);
      if (header.dialect.separator == blank_dialect.separator)
        line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
      if (fields >= target.size() && field.empty()) continue;  // separators at the end of the line
      ++fields;
      if (fields > target.size() || target[fields - 1] == skipped) continue;
      double value = 0;
      const bool known = mark != DecimalMark::by_dialect;
      const FieldFault fault = known ? parse_grouped_number(field, mark == DecimalMark::comma, value)
                                     : parse_number(field, header.dialect.decimal_comma, value);
      const bool stamp = fault == FieldFault::none && field.find(':') != std::string_view::npos;
      if (fault == FieldFault::none && header.dialect.decimal_comma && !known && !stamp)
        marks.see(field, line_number, file);
      if (fault != FieldFault::none) {
        const bool kept = missing == MissingNumbers::keep_as_nan ||
                          (missing == MissingNumbers::keep_gaps && fault != FieldFault::text);
        if (!kept && (more || fields == target.size()))
          refuse(file, fmt::format("line {}, column {}", line_number, header.names[fields - 1]), fault, field);
        value = std::numeric_limits<double>::quiet_NaN();
      }
      const std::size_t column = target[fields - 1];
      if (table.columns[column].empty()) {
        stamps[column] = stamp;
        clock[column] = stamp && value < 2 * day_s;
      }
      table.columns[column].push_back(value);
    }
    if (fields != target.size())
      throw InputError(file, fmt::format("line {}", line_number),
                       fmt::format("has {} fields, the header names {}", fields, target.size()),
                       "every row has one number for every column");
  }
};

// A line without blanks at its ends: where tabulators part fields, one at the end is an empty field.
std::string_view row_of(std::string_view line, char separator) {
  const std::string_view blanks = separator == '\t' ? " \r" : " \t\r";
  const std::size_t begin = std::min(line.find_first_not_of(blanks), line.size());
  return line.substr(begin, line.find_last_not_of(blanks) + 1 - begin);
}

// The last line that is not empty; empty if it is longer than any row.
std::string_view last_line(std::string_view rows, char line_break) {
  constexpr std::size_t longest_row = std::size_t{1} << 20;
  if (rows.size() > longest_row) rows = rows.substr(rows.size() - longest_row);
  const std::size_t last = rows.find_last_not_of(" \t\r\n");
  if (last == std::string_view::npos) return {};
  rows = rows.substr(0, rows.find(line_break, last));
  const std::size_t begin = rows.rfind(line_break);
  return begin == std::string_view::npos ? std::string_view() : rows.substr(begin + 1);
}

void read_last_row(const RowReader& reader, NumberTable& table) {
  NumberTable last;
  last.columns.resize(table.columns.size());
  std::vector<bool> ignored(table.columns.size(), false);
  RowReader forgiving{reader.header, reader.target, MissingNumbers::keep_as_nan,
                      reader.file,   reader.marks,  reader.mark,
                      ignored,       ignored};
  try {
    const CsvHeader& header = reader.header;
    forgiving.read(row_of(last_line(header.rows, header.line_break), header.dialect.separator), 0, last);
  } catch (const InputError&) {
    return;  // cut off: nothing is known of the end
  }
  for (const std::vector<double>& column : last.columns) table.last_row.push_back(column.front());
}

// The last row of a file of which the first rows were read is of the day that they lead to.
void continue_to_last_row(NumberTable& table, std::size_t column) {
  const std::vector<double>& stamps = table.columns[column];
  if (table.last_row.empty() || stamps.size() < 2) return;
  const double step = (stamps.back() - stamps.front()) / static_cast<double>(stamps.size() - 1);
  const double expected = stamps.back() + step * static_cast<double>(table.total_rows - table.rows());
  if (const double days = std::round((expected - table.last_row[column]) / day_s); days > 0)
    table.last_row[column] += days * day_s;
}

void read_rows(const RowReader& reader, TextFile& text, std::size_t limit, NumberTable& table) {
  const std::string_view rows = reader.header.rows;
  const auto header_size = static_cast<std::size_t>(rows.data() - text.bytes().data());
  std::string_view rest = rows;
  std::size_t line_number = reader.header.last_line, empty_line = 0;
  while (!rest.empty() && table.rows() < limit) {
    const std::string_view line = next_line(rest, reader.header.line_break);
    ++line_number;
    if (trimmed(line).empty() || trimmed(line).starts_with('#')) {
      if (empty_line == 0) empty_line = line_number;
      continue;
    }
    if (empty_line != 0 && table.rows() != 0)
      throw InputError(reader.file, fmt::format("line {}", empty_line), "an empty line or a remark between rows",
                       "remove it, or split the file into records");
    empty_line = 0;
    if (table.rows() == 0) table.first_line = line_number;
    reader.read(row_of(line, reader.header.dialect.separator), line_number, table);
    text.release_before(header_size + rows.size() - rest.size());
  }
  table.total_rows = table.rows();
  if (rest.find_first_not_of(" \t\r\n") == std::string_view::npos) return;
  const auto taken = static_cast<double>(rows.size() - rest.size());
  table.total_rows = static_cast<std::size_t>(
      std::llround(static_cast<double>(table.rows()) * static_cast<double>(rows.size()) / taken));
  read_last_row(reader, table);
}

void count_time(const CsvHeader& header, std::size_t column, NumberTable& table) {
  const auto time = [&](double count) { return header.counted_from + header.counted_by * count; };
  for (double& count : table.columns[column]) count = time(count);
  if (!table.last_row.empty()) table.last_row[column] = time(table.last_row[column]);
}

// Rows to make room for: their exact count is worth a look at the file, since columns that grow take twice the
// room.
std::size_t count_lines(const CsvHeader& header, TextFile& text, std::size_t limit) {
  constexpr std::size_t stretch = std::size_t{1} << 22;
  const std::string_view rows = header.rows;
  const auto header_size = static_cast<std::size_t>(rows.data() - text.bytes().data());
  std::size_t lines = 1;
  for (std::size_t begin = 0; begin < rows.size() && lines <= limit; begin += stretch) {
    const std::string_view part = rows.substr(begin, stretch);
    lines += static_cast<std::size_t>(std::count(part.begin(), part.end(), header.line_break));
    if (limit == all_values) text.forget(header_size + begin, header_size + begin + part.size());
  }
  return std::min(lines, limit);
}

// "Kraft in kN", and "in s" of a time without a name: a known unit behind the last " in ".
CsvName unit_behind_in(const std::string& name) {
  const bool nameless = name.starts_with("in ");
  const std::size_t in = nameless ? 0 : name.rfind(" in ");
  if (in == std::string::npos) return {name, ""};
  const std::string unit = usual_spelling(name.substr(in + (nameless ? 3 : 4)));
  if (!seconds_in(unit) && (!unit_meaning(unit) || is_bare_ratio(unit))) return {name, ""};
  return {nameless ? name : name.substr(0, in), unit};
}

// "Kraft/N", "a/(m/s^2)" (DIN 1313): a name without blanks that is no unit itself, and a known unit.
CsvName unit_behind_slash(const std::string& name) {
  const std::size_t slash = name.find('/');
  if (CsvName behind_in = unit_behind_in(name); !behind_in.unit.empty()) return behind_in;
  if (slash == 0 || slash == std::string::npos) return {name, ""};
  const std::string before = name.substr(0, slash), unit = usual_spelling(name.substr(slash + 1));
  const auto is_unit = [](const std::string& text) {
    return seconds_in(text) || unit_meaning(usual_spelling(text)) || !other_measure(text).empty();
  };
  constexpr std::string_view words[] = {"in", "ft", "mil", "g", "A", "h", "d", "min", "day", "days", "rev"};
  if (std::find(std::begin(words), std::end(words), unit) != std::end(words)) return {name, ""};  // pump/in
  if (before.find(' ') != std::string::npos || is_unit(before) || is_bare_ratio(unit) || !is_unit(unit))
    return {name, ""};
  return {before, unit};
}

}  // namespace

CsvName bracketed_unit(const std::string& name) {
  constexpr std::string_view opening = "([{<", closing = ")]}>";
  const std::size_t kind = name.empty() ? std::string_view::npos : closing.find(name.back());
  if (name.size() < 3 || kind == std::string_view::npos) return unit_behind_slash(name);
  const std::size_t open = name.rfind(opening[kind]);
  if (open == std::string::npos || open == 0 || open + 2 >= name.size()) return {name, ""};
  if (name[open - 1] == '/') return unit_behind_slash(name);
  return {std::string(trimmed(std::string_view(name).substr(0, open))),
          name.substr(open + 1, name.size() - open - 2)};
}

NumberTable read_csv_header(const std::filesystem::path& path) {
  const TextFile text(path);
  CsvHeader header = read_header(text.bytes(), path.string());
  NumberTable table;
  table.names = std::move(header.names);
  table.units = std::move(header.units);
  return table;
}

NumberTable read_csv(const std::filesystem::path& path, const std::vector<std::string>& wanted,
                     MissingNumbers missing, std::size_t limit, DecimalMark mark) {
  const std::string file = path.string();
  TextFile text(path);
  const CsvHeader header = read_header(text.bytes(), file);
  NumberTable table;
  table.names = wanted.empty() ? header.names : wanted;
  table.columns.resize(table.names.size());
  std::vector<std::size_t> target(header.names.size(), skipped);
  for (std::size_t c = 0; c < table.names.size(); ++c) {
    const auto found = std::find(header.names.begin(), header.names.end(), table.names[c]);
    if (found == header.names.end())
      throw InputError(file, fmt::format("line {}", header.line), "has no column " + shown(table.names[c]),
                       fmt::format("its columns are {}", fmt::join(header.names, ", ")));
    target[static_cast<std::size_t>(found - header.names.begin())] = c;
    table.units.push_back(header.units[static_cast<std::size_t>(found - header.names.begin())]);
  }
  const std::size_t lines = count_lines(header, text, limit);
  for (std::vector<double>& column : table.columns) column.reserve(lines);
  DecimalMarks marks;
  std::vector<bool> clock(table.names.size(), false), stamps = clock;
  read_rows({header, target, missing, file, marks, mark, clock, stamps}, text, limit, table);
  for (std::size_t c = 0; c < clock.size(); ++c) {
    if (stamps[c]) table.units[c] = "s";  // whatever a row of units says: date, hh:mm:ss
    if (target.front() == c && header.counted_by != 0) count_time(header, c, table);
    if (!clock[c]) continue;
    continue_behind_midnight(table.columns[c]);
    continue_to_last_row(table, c);
  }
  if (table.rows() == 0) throw InputError(file, "", "has a header but no rows", "rows of numbers were expected");
  return table;
}

std::string number_text(double value) {
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
  return std::string(buffer, result.ptr);
}

std::string csv_header(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t c = 0; c < names.size(); ++c) text += (c ? "," : "") + names[c];
  return text + '\n';
}

std::string csv_rows(const std::vector<std::vector<double>>& columns) {
  std::string text;
  const std::size_t rows = columns.empty() ? 0 : columns.front().size();
  text.reserve(rows * columns.size() * 20);
  char buffer[32];
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const auto result = std::to_chars(buffer, buffer + sizeof buffer, columns[c][r]);
      text.append(buffer, result.ptr);
      text += c + 1 == columns.size() ? '\n' : ',';
    }
  return text;
}

}  // namespace secular
