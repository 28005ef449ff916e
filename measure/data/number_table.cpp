#include "measure/data/number_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <string_view>

#include "input/input_error.hpp"
#include "measure/data/csv_dialect.hpp"
#include "measure/data/mapped_file.hpp"
#include "measure/data/unit.hpp"

namespace secular {
namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) text.remove_suffix(1);
  return text;
}

std::string_view unquoted(std::string_view text) {
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') return text.substr(1, text.size() - 2);
  return text;
}

// The fields of a line that may have separators inside of quotes.
std::vector<std::string_view> split_quoted(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  bool inside = false;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') inside = !inside;
    if (i < line.size() && (inside || line[i] != separator)) continue;
    fields.push_back(unquoted(trimmed(line.substr(begin, i - begin))));
    begin = i + 1;
  }
  return fields;
}

CsvDialect dialect_of(std::string_view header) {
  const auto stands_in = [header](const CsvDialect& dialect) {
    bool inside = false;
    return std::any_of(header.begin(), header.end(), [&](char c) {
      if (c == '"') inside = !inside;
      return !inside && c == dialect.separator;
    });
  };
  const auto found = std::find_if(std::begin(csv_dialects), std::end(csv_dialects), stands_in);
  return found == std::end(csv_dialects) ? CsvDialect() : *found;
}

std::string shown(std::string_view field) {
  std::string text = "'";
  for (const char c : field.substr(0, 40)) text += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
  return text + (field.size() > 40 ? "...'" : "'");
}

// Takes the next line off `rest`, without its line break.
std::string_view next_line(std::string_view& rest) {
  const std::size_t end = rest.find('\n');
  const std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  return line;
}

struct Header {
  std::vector<std::string> names, units;
  CsvDialect dialect;
  std::size_t line = 0;       // of the names
  std::size_t last_line = 0;  // of the units, if there are any
  std::string_view rows;      // the text below the header
};

// A row of units: as many fields as there are names, some of them known units and none of them a number.
void read_units(Header& header) {
  header.last_line = header.line;
  for (const std::string& name : header.names) header.units.push_back(bracketed_unit(name).unit);
  std::string_view rest = header.rows;
  std::vector<std::string_view> fields = split_quoted(trimmed(next_line(rest)), header.dialect.separator);
  while (fields.size() > header.names.size() && fields.back().empty()) fields.pop_back();
  if (fields.size() != header.names.size()) return;
  bool known = false;
  for (const std::string_view field : fields) {
    const std::string unit(field);
    known = known || seconds_in(unit) || (unit_meaning(usual_spelling(unit)) && unit != "1");
    double number = 0;
    if (std::from_chars(field.data(), field.data() + field.size(), number).ec == std::errc()) return;
  }
  if (!known) return;
  for (std::size_t c = 0; c < fields.size(); ++c)
    if (!fields[c].empty()) header.units[c] = usual_spelling(std::string(fields[c]));
  header.rows = rest;
  ++header.last_line;
}

Header read_header(std::string_view text, const std::string& file) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    throw InputError(file, "", "is UTF-16 text", "save it as UTF-8 or ASCII");
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  Header header;
  std::string_view line;
  while (trimmed(line).empty() && !text.empty()) {
    line = next_line(text);
    ++header.line;
  }
  if (trimmed(line).empty())
    throw InputError(file, "", "is empty", "a header line and rows of numbers were expected");
  const std::string place = fmt::format("line {}", header.line);
  if (line.find('\0') != std::string_view::npos)
    throw InputError(file, place, "is not text", "a CSV or a MAT v5 file was expected");
  header.dialect = dialect_of(line);
  for (const std::string_view name : split_quoted(line, header.dialect.separator)) header.names.emplace_back(name);
  while (header.names.size() > 1 && header.names.back().empty()) header.names.pop_back();
  for (std::size_t c = 0; c < header.names.size(); ++c) {
    const std::string& name = header.names[c];
    if (name.empty())
      throw InputError(file, fmt::format("{}, column {}", place, c + 1), "has no name", "name every column");
    double number = 0;
    if (std::from_chars(name.data(), name.data() + name.size(), number).ptr == name.data() + name.size())
      throw InputError(file, place, "numbers where the column names should be",
                       "the first line names the columns, for example t,base,response");
    if (std::find(header.names.begin(), header.names.begin() + static_cast<std::ptrdiff_t>(c), name) !=
        header.names.begin() + static_cast<std::ptrdiff_t>(c))
      throw InputError(file, place, "names two columns " + shown(name), "every column has its own name");
  }
  header.rows = text;
  read_units(header);
  return header;
}

enum class FieldFault { none, empty, text, not_finite };

FieldFault parse_number(std::string_view field, bool decimal_comma, double& value) {
  field = unquoted(field);
  if (field.empty()) return FieldFault::empty;
  if (field.front() == '+' && field.size() > 1 && field[1] != '-') field.remove_prefix(1);
  char with_point[64];
  if (decimal_comma && field.size() <= sizeof with_point) {
    std::replace_copy(field.begin(), field.end(), with_point, ',', '.');
    field = std::string_view(with_point, field.size());
  }
  const auto result = std::from_chars(field.data(), field.data() + field.size(), value);
  if (result.ec == std::errc::invalid_argument || result.ptr != field.data() + field.size())
    return FieldFault::text;
  if (result.ec != std::errc() || !std::isfinite(value)) return FieldFault::not_finite;
  return FieldFault::none;
}

[[noreturn]] void refuse(const std::string& file, const std::string& place, FieldFault fault,
                         std::string_view field) {
  if (fault == FieldFault::empty) throw InputError(file, place, "is empty", "a number was expected");
  if (fault == FieldFault::text)
    throw InputError(file, place, shown(field) + " is not a number", "a number was expected");
  throw InputError(file, place, shown(field) + " is not a finite number", "cut the record around missing samples");
}

constexpr std::size_t skipped = std::numeric_limits<std::size_t>::max();

/// Puts the fields of rows into the columns of a table.
struct RowReader {
  const Header& header;
  const std::vector<std::size_t>& target;  // of every field: a column of the table, or `skipped`
  MissingNumbers missing;
  const std::string& file;

  void read(std::string_view line, std::size_t line_number, NumberTable& table) const {
    std::size_t fields = 0;
    for (bool more = true; more;) {
      const std::size_t end = line.find(header.dialect.separator);
      more = end != std::string_view::npos;
      const std::string_view field = trimmed(line.substr(0, end));
      if (more) line.remove_prefix(end + 1);
      if (fields >= target.size() && field.empty()) continue;  // separators at the end of the line
      ++fields;
      if (fields > target.size() || target[fields - 1] == skipped) continue;
      double value = 0;
      const FieldFault fault = parse_number(field, header.dialect.decimal_comma, value);
      if (fault != FieldFault::none) {
        if (missing == MissingNumbers::refuse && (more || fields == target.size()))
          refuse(file, fmt::format("line {}, column {}", line_number, header.names[fields - 1]), fault, field);
        value = std::numeric_limits<double>::quiet_NaN();
      }
      table.columns[target[fields - 1]].push_back(value);
    }
    if (fields != target.size())
      throw InputError(file, fmt::format("line {}", line_number),
                       fmt::format("has {} fields, the header names {}", fields, target.size()),
                       "every row has one number for every column");
  }
};

// The last line that is not empty; empty if it is longer than any row.
std::string_view last_line(std::string_view rows) {
  constexpr std::size_t longest_row = std::size_t{1} << 20;
  if (rows.size() > longest_row) rows = rows.substr(rows.size() - longest_row);
  const std::size_t end = rows.find_last_not_of(" \t\r\n");
  if (end == std::string_view::npos) return {};
  rows = rows.substr(0, end + 1);
  const std::size_t begin = rows.rfind('\n');
  return begin == std::string_view::npos ? std::string_view() : rows.substr(begin + 1);
}

void read_last_row(const RowReader& reader, NumberTable& table) {
  NumberTable last;
  last.columns.resize(table.columns.size());
  const RowReader forgiving{reader.header, reader.target, MissingNumbers::keep_as_nan, reader.file};
  try {
    forgiving.read(last_line(reader.header.rows), 0, last);
  } catch (const InputError&) {
    return;  // cut off: nothing is known of the end
  }
  for (const std::vector<double>& column : last.columns) table.last_row.push_back(column.front());
}

void read_rows(const RowReader& reader, MappedFile& mapped, std::size_t limit, NumberTable& table) {
  const std::string_view rows = reader.header.rows;
  const auto header_size = static_cast<std::size_t>(rows.data() - mapped.bytes().data());
  std::string_view rest = rows;
  std::size_t line_number = reader.header.last_line, empty_line = 0;
  while (!rest.empty() && table.rows() < limit) {
    std::string_view line = trimmed(next_line(rest));
    ++line_number;
    if (line.empty()) {
      if (empty_line == 0) empty_line = line_number;
      continue;
    }
    if (empty_line != 0 && table.rows() != 0)
      throw InputError(reader.file, fmt::format("line {}", empty_line), "an empty line between rows",
                       "remove it, or split the file into records");
    empty_line = 0;
    if (table.rows() == 0) table.first_line = line_number;
    reader.read(line, line_number, table);
    mapped.release_before(header_size + rows.size() - rest.size());
  }
  table.total_rows = table.rows();
  if (rest.find_first_not_of(" \t\r\n") == std::string_view::npos) return;
  const auto taken = static_cast<double>(rows.size() - rest.size());
  table.total_rows = static_cast<std::size_t>(
      std::llround(static_cast<double>(table.rows()) * static_cast<double>(rows.size()) / taken));
  read_last_row(reader, table);
}

// Rows to make room for: their exact count is worth a look at the file, since columns that grow take twice the
// room.
std::size_t count_lines(std::string_view rows, MappedFile& mapped, std::size_t limit) {
  constexpr std::size_t stretch = std::size_t{1} << 22;
  const auto header_size = static_cast<std::size_t>(rows.data() - mapped.bytes().data());
  std::size_t lines = 1;
  for (std::size_t begin = 0; begin < rows.size() && lines <= limit; begin += stretch) {
    const std::string_view part = rows.substr(begin, stretch);
    lines += static_cast<std::size_t>(std::count(part.begin(), part.end(), '\n'));
    if (limit == all_values) mapped.forget(header_size + begin, header_size + begin + part.size());
  }
  return std::min(lines, limit);
}

}  // namespace

CsvName bracketed_unit(const std::string& name) {
  if (name.size() < 3 || (name.back() != ')' && name.back() != ']')) return {name, ""};
  const std::size_t open = name.rfind(name.back() == ')' ? '(' : '[');
  if (open == std::string::npos || open == 0 || open + 2 >= name.size()) return {name, ""};
  return {std::string(trimmed(std::string_view(name).substr(0, open))),
          name.substr(open + 1, name.size() - open - 2)};
}

NumberTable read_csv_header(const std::filesystem::path& path) {
  const MappedFile mapped(path);
  Header header = read_header(mapped.bytes(), path.string());
  NumberTable table;
  table.names = std::move(header.names);
  table.units = std::move(header.units);
  return table;
}

NumberTable read_csv(const std::filesystem::path& path, const std::vector<std::string>& wanted,
                     MissingNumbers missing, std::size_t limit) {
  const std::string file = path.string();
  MappedFile mapped(path);
  const Header header = read_header(mapped.bytes(), file);
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
  const std::size_t lines = count_lines(header.rows, mapped, limit);
  for (std::vector<double>& column : table.columns) column.reserve(lines);
  read_rows({header, target, missing, file}, mapped, limit, table);
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
