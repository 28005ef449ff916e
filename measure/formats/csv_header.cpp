#include "measure/formats/csv_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>

#include "input/input_error.hpp"
#include "measure/formats/clock_stamp.hpp"
#include "measure/formats/file_bytes.hpp"
#include "measure/formats/fortran_number.hpp"
#include "measure/formats/number_table.hpp"
#include "measure/formats/unit.hpp"

namespace secular {
namespace {

/// Lines, but for empty ones and comments, in which the names are looked for: exports of instruments have some
/// dozens of lines above them.
constexpr std::size_t preamble_lines = 200;

/// Ends a text in DOS, and fills its last block.
constexpr char control_z = 0x1A;

std::string_view without_end_mark(std::string_view text) {
  const std::size_t end = text.find_last_not_of("\r\n\x1A") + 1;
  return text.find(control_z, end) == std::string_view::npos ? text : text.substr(0, end);
}

// The fields of a line that may have separators inside of quotes.
std::vector<std::string_view> split_quoted(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  bool inside = false;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') inside = !inside;
    if (i < line.size() && (inside || line[i] != separator)) continue;
    if (separator == blank_dialect.separator && i == begin) {  // one blank more
      begin = i + 1;
      continue;
    }
    fields.push_back(unquoted(trimmed(line.substr(begin, i - begin))));
    begin = i + 1;
  }
  return fields;
}

// The same without empty fields at the end of the line, but those among the first `columns`.
std::vector<std::string_view> split_row(std::string_view line, char separator, std::size_t columns) {
  std::vector<std::string_view> fields = split_quoted(line, separator);
  while (fields.size() > columns && fields.back().empty()) fields.pop_back();
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

bool is_number(std::string_view field, bool decimal_comma) {
  double value = 0;
  const FieldFault fault = parse_number(field, decimal_comma, value);
  return fault == FieldFault::none || fault == FieldFault::not_finite;
}

struct Line {
  std::string_view text;
  std::size_t number = 0;  // of the file, counted from 1
};

// Names: fields of which only the last may be empty and none is a number.
std::vector<std::string_view> names_in(std::string_view line, char separator) {
  // "Time (s)   Force (N)": where some names are two blanks apart, one blank belongs to a name.
  if (const std::string_view all = trimmed(line);
      separator == blank_dialect.separator && all.find("  ") != std::string_view::npos) {
    std::vector<std::string_view> names;
    for (std::size_t begin = 0, end = 0; begin < all.size(); begin = all.find_first_not_of(' ', end)) {
      end = std::min(all.find("  ", begin), all.size());
      names.push_back(unquoted(all.substr(begin, end - begin)));
    }
    return names;
  }
  return split_row(line, separator, 1);
}

// The first column may have none: an index that was written with the rest.
bool are_names(const std::vector<std::string_view>& fields) {
  const auto is_none = [](std::string_view field) { return field.empty() || is_number(field, true); };
  const bool indexed = fields.size() > 1 && fields.front().empty();
  return std::none_of(fields.begin() + (indexed ? 1 : 0), fields.end(), is_none);
}

bool is_unit(std::string_view field) {
  const std::string unit = usual_spelling(as_utf8(field));
  return seconds_in(unit) || !other_measure(unit).empty() || (unit_meaning(unit) && unit != "1");
}

// Units of columns: no number, and a known unit in every field (of a row between names and numbers: in one).
bool are_units(const std::vector<std::string_view>& fields, bool all) {
  const auto known = std::count_if(fields.begin(), fields.end(), is_unit);
  const bool number =
      std::any_of(fields.begin(), fields.end(), [](std::string_view f) { return is_number(f, true); });
  return !number && (all ? known == std::ssize(fields) : known > 0);
}

bool are_numbers(const std::vector<std::string_view>& fields, bool decimal_comma) {
  const auto number = [&](std::string_view field) { return is_number(field, decimal_comma); };
  return std::any_of(fields.begin(), fields.end(), number) &&
         std::all_of(fields.begin(), fields.end(),
                     [&](std::string_view field) { return field.empty() || number(field); });
}

// The beginning of a text: lines that may hold names or rows, comments above them, and what `sep=` says.
struct Beginning {
  std::vector<Line> lines, comments;
  std::optional<CsvDialect> dialect;

  CsvDialect dialect_for(const Line& line) const { return dialect ? *dialect : dialect_of(line.text); }

  // The same, where blanks part columns in no other way.
  CsvDialect dialect_of_names(std::size_t i) const {
    const CsvDialect its = dialect_for(lines[i]);
    const bool parted = lines[i].text.find(its.separator) != std::string_view::npos;
    return !dialect && !parted && !names_rows(i, its) && names_rows(i, blank_dialect) ? blank_dialect : its;
  }

  // Whether line i holds the names of the columns of a row of numbers below it, or below one further line (of
  // units).
  bool names_rows(std::size_t i) const { return names_rows(i, dialect_of_names(i)); }

  bool names_rows(std::size_t i, const CsvDialect& its) const {
    const std::vector<std::string_view> names = names_in(lines[i].text, its.separator);
    if (!are_names(names)) return false;
    const auto row = [&](std::size_t line) { return split_row(lines[line].text, its.separator, names.size()); };
    std::size_t last = i + 2;
    for (std::size_t line = i + 1; line < lines.size() && line <= last; ++line) {
      const std::vector<std::string_view> fields = row(line);
      if (fields.size() != names.size()) return false;
      if (line == i + 1 && are_units(fields, true)) last = i + 3;  // a remark a column may stand below them
      // A line of a preamble may be followed by one number; rows are followed by rows.
      if (are_numbers(fields, its.decimal_comma))
        return names.size() > 1 || line + 1 >= lines.size() || are_numbers(row(line + 1), its.decimal_comma);
    }
    return false;
  }

  // Whether line i names the columns of numbers behind it, and line i + 1 has nothing but their units: then names
  // may be numbers, as of channels that are counted.
  bool names_units(std::size_t i) const {
    if (i + 2 >= lines.size()) return false;
    const CsvDialect its = dialect_for(lines[i]);
    const std::vector<std::string_view> names = names_in(lines[i].text, its.separator);
    const auto fields = [&](std::size_t line) { return split_row(lines[line].text, its.separator, names.size()); };
    const std::vector<std::string_view> units = fields(i + 1), numbers = fields(i + 2);
    return names.size() > 1 && names.size() == units.size() && names.size() == numbers.size() &&
           !is_number(names.front(), true) && are_units(units, true) && are_numbers(numbers, its.decimal_comma);
  }

  // NumPy parts the names in a comment as it parts the rows.
  CsvDialect dialect_of_comment(const Line& comment) const {
    const CsvDialect its = dialect_for(comment);
    const bool parted = comment.text.find(its.separator) != std::string_view::npos ||
                        lines.front().text.find(its.separator) != std::string_view::npos;
    return dialect || parted ? its : blank_dialect;
  }

  // A comment that names the columns of the rows that begin with the first line, as NumPy writes them.
  std::optional<Line> names_in_comment() const {
    if (lines.empty() || comments.empty()) return std::nullopt;
    const Line& last = comments.back();
    const CsvDialect its = dialect_of_comment(last);
    const std::vector<std::string_view> names = names_in(last.text, its.separator);
    const std::vector<std::string_view> fields = split_quoted(lines.front().text, its.separator);
    const bool fits = fields.size() == names.size() && are_names(names) && are_numbers(fields, its.decimal_comma);
    return fits ? std::optional(last) : std::nullopt;
  }
};

// Rows of numbers without names above them.
struct NamelessRows {
  CsvDialect dialect;
  std::size_t columns = 0;
};

bool is_whole_number(std::string_view field) {
  return field.find_first_not_of("+-0123456789") == std::string_view::npos;
}

// A row of numbers as the dialect parts it: empty where it is none.
std::vector<std::string_view> number_row(std::string_view line, const CsvDialect& dialect) {
  const std::vector<std::string_view> fields = split_row(trimmed(line), dialect.separator, 1);
  const bool numbers = std::all_of(fields.begin(), fields.end(),
                                   [&](std::string_view field) { return is_number(field, dialect.decimal_comma); });
  return numbers ? fields : std::vector<std::string_view>();
}

// 0,1,2 or 1,2,3 in the first line: columns that have been counted (pandas does), or a row.
bool counts_columns(const std::vector<std::string_view>& fields) {
  if (fields.size() < 2 || (fields[0] != "0" && fields[0] != "1")) return false;
  for (std::size_t c = 0; c < fields.size(); ++c)
    if (fields[c] != std::to_string(c + (fields[0] == "1" ? 1 : 0))) return false;
  return true;
}

// Whether commas may be decimal marks as well as separators: whole numbers alone, and two in a line, or one that
// begins with a nought as digits behind a comma do.
bool may_be_decimals(const std::vector<std::vector<std::string_view>>& rows) {
  bool nought = false;
  for (const std::vector<std::string_view>& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) {
      if (!is_whole_number(row[c])) return false;
      nought = nought || (c > 0 && row[c].size() > 1 && row[c].front() == '0');
    }
  return nought || rows.front().size() == 2;
}

// Of a text whose first line that may hold names or a row is a row: the first dialect that parts all the lines into
// equally many numbers.
std::optional<NamelessRows> nameless_rows(const Beginning& beginning, const std::string& file) {
  std::vector<CsvDialect> dialects(std::begin(csv_dialects), std::end(csv_dialects));
  dialects.push_back(blank_dialect);
  if (beginning.dialect) dialects = {*beginning.dialect};
  for (const CsvDialect& dialect : dialects) {
    std::vector<std::vector<std::string_view>> rows;
    for (const Line& line : beginning.lines) rows.push_back(number_row(line.text, dialect));
    const std::size_t columns = rows.front().size();
    const bool parted = beginning.lines.front().text.find(dialect.separator) != std::string_view::npos;
    if (columns == 0 || (!parted && dialect.separator != blank_dialect.separator)) continue;
    // The last line may be cut off.
    if (!std::all_of(rows.begin(), rows.end() - (rows.size() > 1 ? 1 : 0),
                     [&](const auto& row) { return row.size() == columns; }))
      continue;
    const bool counted = counts_columns(rows.front());
    if (counted || (dialect.separator == ',' && may_be_decimals(rows)))
      throw InputError(file, fmt::format("line {}", beginning.lines.front().number),
                       counted ? "numbers that may be the columns' names or a row"
                               : "commas that may part columns or be decimal marks",
                       "put a line above that names the columns, for example t,base,response");
    return NamelessRows{dialect, columns};
  }
  return std::nullopt;
}

// sep=; of a spreadsheet.
std::optional<CsvDialect> stated_dialect(std::string_view line, const std::string& file, std::size_t number) {
  while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
  if (line.size() != 5 || !(line.starts_with("sep=") || line.starts_with("SEP="))) return std::nullopt;
  for (const CsvDialect& dialect : csv_dialects)
    if (dialect.separator == line.back()) return dialect;
  std::string known;
  for (const CsvDialect& dialect : csv_dialects) known += (known.empty() ? "" : ", ") + std::string(dialect.name);
  throw InputError(file, fmt::format("line {}", number), "states a separator that is not read",
                   "one of these: " + known);
}

Beginning beginning_of(std::string_view text, char line_break, const std::string& file) {
  Beginning beginning;
  for (std::size_t number = 1; !text.empty() && beginning.lines.size() < preamble_lines; ++number) {
    const std::string_view line = next_line(text, line_break), content = trimmed(line);
    if (content.empty()) continue;
    if (content.find('\0') != std::string_view::npos) {
      if (!beginning.lines.empty()) break;
      const bool classic = text.starts_with("CDF");
      throw InputError(file, fmt::format("line {}", number),
                       classic ? "is a netCDF file of the classic format, which is not read" : "is not text",
                       classic ? "netCDF-4, by nccopy -k netCDF-4" : "a CSV or a MAT v5 file was expected");
    }
    if (beginning.lines.empty() && !beginning.dialect)
      if ((beginning.dialect = stated_dialect(line, file, number))) continue;
    if (content.front() != '#')
      beginning.lines.push_back({line, number});
    else if (beginning.lines.empty())
      beginning.comments.push_back({content.substr(1), number});
  }
  return beginning;
}

// A row of units: as many fields as there are names, some of them known units and none of them a number.
void read_units(CsvHeader& header) {
  for (const std::string& name : header.names) header.units.push_back(bracketed_unit(name).unit);
  std::string_view rest = header.rows;
  const std::vector<std::string_view> fields =
      split_row(next_line(rest, header.line_break), header.dialect.separator, header.names.size());
  if (fields.size() != header.names.size() || !are_units(fields, false)) return;
  for (std::size_t c = 0; c < fields.size(); ++c)
    if (!fields[c].empty()) header.units[c] = usual_spelling(as_utf8(fields[c]));
  header.rows = rest;
  ++header.last_line;
  // A remark a column below the units.
  const std::string_view next = next_line(rest, header.line_break);
  const std::vector<std::string_view> remarks = split_row(next, header.dialect.separator, header.names.size());
  const bool text =
      std::all_of(remarks.begin(), remarks.end(), [](std::string_view f) { return !is_number(f, true); });
  if (remarks.size() != header.names.size() || !text || !are_units(fields, true)) return;
  header.rows = rest;
  ++header.last_line;
}

void take_names(const Line& line, CsvHeader& header) {
  header.line = line.number;
  for (const std::string_view name : names_in(line.text, header.dialect.separator))
    header.names.push_back(as_utf8(name));
  if (header.names.size() > 1 && header.names.front().empty()) header.names.front() = nameless_column(0);
}

// Rows below a preamble that names no columns: the line from which on all are rows of equally many numbers, in the
// dialect that parts most of them; the first line if there are none.
std::size_t first_of_rows(const std::vector<Line>& lines) {
  std::size_t first = lines.size() - 1;
  std::vector<CsvDialect> dialects(std::begin(csv_dialects), std::end(csv_dialects));
  dialects.push_back(blank_dialect);
  for (const CsvDialect& dialect : dialects) {
    std::size_t begin = lines.size(), columns = 0;
    for (; begin > 0; --begin) {
      const std::size_t count = number_row(lines[begin - 1].text, dialect).size();
      if (count < 2 || (columns != 0 && count != columns)) break;
      columns = count;
    }
    // A line of as many texts above them names the columns, though not in a way that is known.
    if (begin > 0 && split_row(lines[begin - 1].text, dialect.separator, 1).size() == columns) return 0;
    first = std::min(first, begin);
  }
  return first + 1 == lines.size() ? 0 : first;
}

// "X,CH1,Start,Increment" and "Sequence,VOLT,-0.5,1e-3" of oscilloscopes: rows count their samples, and begin and
// step of the time stand above, behind the names and units.
bool read_counted_samples(const Beginning& beginning, std::string_view text, CsvHeader& header) {
  const std::vector<Line>& lines = beginning.lines;
  if (lines.size() < 3) return false;
  const CsvDialect dialect = beginning.dialect_for(lines.front());
  const std::vector<std::string_view> names = split_row(lines[0].text, dialect.separator, 1),
                                      units = split_row(lines[1].text, dialect.separator, 1);
  if (names.size() < 4 || units.size() != names.size()) return false;
  const std::size_t columns = names.size() - 2;
  if (names[columns] != "Start" || names[columns + 1] != "Increment") return false;
  if (parse_number(units[columns], dialect.decimal_comma, header.counted_from) != FieldFault::none ||
      parse_number(units[columns + 1], dialect.decimal_comma, header.counted_by) != FieldFault::none)
    return false;
  header.dialect = dialect;
  for (std::size_t c = 0; c < columns; ++c) {
    header.names.push_back(as_utf8(names[c]));
    header.units.push_back(c == 0 ? "s" : usual_spelling(as_utf8(units[c])));
  }
  header.line = lines[0].number;
  header.last_line = lines[2].number - 1;
  header.rows = text.substr(static_cast<std::size_t>(lines[2].text.data() - text.data()));
  return true;
}

// Rows with the oscilloscope's settings in front of the first ones (Tektronix TDS): "Record
// Length,2500,,-0.5,0.04".
bool read_rows_beside_settings(const Beginning& beginning, std::string_view text, CsvHeader& header) {
  const std::vector<Line>& lines = beginning.lines;
  const auto fields = [](const Line& line) { return split_row(line.text, ',', 5); };
  const auto is_row = [&](const Line& line) {
    const std::vector<std::string_view> row = fields(line);
    return row.size() == 5 && is_number(row[3], false) && is_number(row[4], false);
  };
  if (lines.size() < 2 || fields(lines.front()).front() != "Record Length") return false;
  if (!std::all_of(lines.begin(), lines.end(), is_row)) return false;
  const auto setting = [&](std::string_view key) {
    for (const Line& line : lines)
      if (fields(line)[0] == key) return as_utf8(fields(line)[1]);
    return std::string();
  };
  const std::string source = setting("Source"), unit = setting("Vertical Units");
  header.names = {"setting", "value", "column3", "t", source.empty() ? "column5" : source};
  header.units = {"", "", "", "s", usual_spelling(unit)};
  header.line = lines.front().number;
  header.last_line = header.line - 1;
  header.rows = text.substr(static_cast<std::size_t>(lines.front().text.data() - text.data()));
  return true;
}

void check_names(const CsvHeader& header, bool may_be_numbers, const std::string& file) {
  const std::string place = fmt::format("line {}", header.line);
  for (std::size_t c = 0; c < header.names.size(); ++c) {
    const std::string& name = header.names[c];
    if (name.empty())
      throw InputError(file, fmt::format("{}, column {}", place, c + 1), "has no name", "name every column");
    double number = 0;
    if (!may_be_numbers &&
        std::from_chars(name.data(), name.data() + name.size(), number).ptr == name.data() + name.size())
      throw InputError(file, place, "numbers where the column names should be",
                       "the first line names the columns, for example t,base,response");
    if (std::find(header.names.begin(), header.names.begin() + static_cast<std::ptrdiff_t>(c), name) !=
        header.names.begin() + static_cast<std::ptrdiff_t>(c))
      throw InputError(file, place, "names two columns " + shown(name), "every column has its own name");
  }
}

}  // namespace

std::string nameless_column(std::size_t column) {
  return fmt::format("column{}", column + 1);
}

bool is_nameless_column(std::string_view name) {
  constexpr std::string_view start = "column";
  return name.starts_with(start) && name.size() > start.size() &&
         name.find_first_not_of("0123456789", start.size()) == std::string_view::npos;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) text.remove_suffix(1);
  return text;
}

std::string_view unquoted(std::string_view text) {
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') return text.substr(1, text.size() - 2);
  return text;
}

std::string shown(std::string_view field) {
  std::string text = "'";
  for (const char c : field.substr(0, 40)) text += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
  return text + (field.size() > 40 ? "...'" : "'");
}

std::string_view next_line(std::string_view& rest, char line_break) {
  const std::size_t end = rest.find(line_break);
  const std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  return line;
}

FieldFault parse_number(std::string_view field, bool decimal_comma, double& value) {
  field = unquoted(field);
  if (field.empty()) return FieldFault::empty;
  const std::string_view as_it_is = field;
  if (field.front() == '+' && field.size() > 1 && field[1] != '-') field.remove_prefix(1);
  char with_point[64];
  if (decimal_comma && field.size() <= sizeof with_point) {
    std::replace_copy(field.begin(), field.end(), with_point, ',', '.');
    field = std::string_view(with_point, field.size());
  }
  const auto result = std::from_chars(field.data(), field.data() + field.size(), value);
  if (result.ec == std::errc::invalid_argument || result.ptr != field.data() + field.size()) {
    std::optional<double> other = clock_stamp(as_it_is);
    if (!other && (*result.ptr == 'D' || *result.ptr == 'd')) other = fortran_number(field);  // 1.0D+00
    if (!other) return FieldFault::text;
    value = *other;
    return FieldFault::none;
  }
  if (result.ec != std::errc() || !std::isfinite(value)) return FieldFault::not_finite;
  return FieldFault::none;
}

FieldFault parse_grouped_number(std::string_view field, bool decimal_comma, double& value) {
  constexpr std::size_t group = 3;
  field = unquoted(field);
  const std::string_view parting = decimal_comma ? ". '" : ", '";
  std::string plain;
  std::size_t digits = 0;  // since the last mark
  bool parted = false, whole = true;
  const auto is_mark = [&](char c) { return parting.find(c) != std::string_view::npos; };
  for (const char c : field) {
    if (whole && is_mark(c)) {
      if (parted ? digits != group : digits == 0 || digits > group) return FieldFault::text;
      parted = true;
      digits = 0;
      continue;
    }
    const bool digit = c >= '0' && c <= '9', sign = plain.empty() && (c == '-' || c == '+');
    if (whole && !digit && !sign) {
      whole = false;
      if (parted && digits != group) return FieldFault::text;
    }
    if (!whole && c == (decimal_comma ? '.' : ',')) return FieldFault::text;
    if (digit) ++digits;
    plain += c;
  }
  if (whole && parted && digits != group) return FieldFault::text;
  return parse_number(plain, decimal_comma, value);
}

CsvHeader read_header(std::string_view text, const std::string& file) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  text = without_end_mark(text);
  CsvHeader header;
  if (text.find('\n') == std::string_view::npos && text.find('\r') != std::string_view::npos)
    header.line_break = '\r';
  Beginning beginning = beginning_of(text, header.line_break, file);
  if (beginning.lines.empty())
    throw InputError(file, "", "is empty", "a header line and rows of numbers were expected");
  if (read_counted_samples(beginning, text, header) || read_rows_beside_settings(beginning, text, header))
    return header;
  std::size_t row = 0;         // of beginning.lines, the first below the names
  bool counted_names = false;  // are numbers
  if (const std::optional<Line> comment = beginning.names_in_comment()) {
    header.dialect = beginning.dialect_of_comment(*comment);
    take_names(*comment, header);
  } else {
    while (row < beginning.lines.size() && !beginning.names_rows(row)) ++row;
    const bool named = row < beginning.lines.size();
    if (!named) row = 0;
    counted_names = named && row > 0 && beginning.names_units(row - 1);
    if (counted_names) --row;
    if (!named)
      beginning.lines.erase(beginning.lines.begin(),
                            beginning.lines.begin() + static_cast<std::ptrdiff_t>(first_of_rows(beginning.lines)));
    if (const auto nameless = named ? std::nullopt : nameless_rows(beginning, file)) {
      header.dialect = nameless->dialect;
      header.line = beginning.lines.front().number;
      for (std::size_t c = 0; c < nameless->columns; ++c) header.names.push_back(nameless_column(c));
    } else {
      header.dialect = beginning.dialect_of_names(row);
      take_names(beginning.lines[row++], header);
    }
  }
  check_names(header, counted_names, file);
  header.last_line = header.line;
  header.rows = text.substr(text.size());
  if (row < beginning.lines.size()) {
    const Line& first = beginning.lines[row];
    header.last_line = first.number - 1;
    header.rows = text.substr(static_cast<std::size_t>(first.text.data() - text.data()));
  }
  read_units(header);
  return header;
}

}  // namespace secular
