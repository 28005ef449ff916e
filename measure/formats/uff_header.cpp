#include "measure/formats/uff_header.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "measure/formats/file_bytes.hpp"
#include "measure/formats/fortran_number.hpp"

namespace secular {
namespace {

// A text of the format, which writes NONE for an empty one.
std::string label(std::string_view text) {
  const std::string plain = as_utf8(stripped(text));
  std::string clean;
  for (const char c : plain) clean += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? ' ' : c;
  return clean == "NONE" ? "" : clean;
}

std::string_view column(std::string_view line, std::size_t begin, std::size_t width) {
  return begin < line.size() ? line.substr(begin, width) : std::string_view();
}

std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> found;
  for (line = stripped(line); !line.empty(); line = stripped(line)) {
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    found.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
  return found;
}

// Fields by their columns; by the blanks between them in files of programs that do not count columns.
std::vector<std::string_view> fields(std::string_view line, std::span<const std::size_t> widths, bool by_blanks) {
  if (by_blanks) return words(line);
  std::vector<std::string_view> found;
  std::size_t begin = 0;
  for (const std::size_t width : widths) {
    found.push_back(column(line, begin, width));
    begin += width;
  }
  return found;
}

std::optional<long long> whole_or_blank(std::string_view text) {
  return stripped(text).empty() ? 0 : whole_number(text);
}

std::optional<int> small_or_blank(std::string_view text) {
  const std::optional<long long> value = whole_or_blank(text);
  if (!value || *value > std::numeric_limits<int>::max() || *value < std::numeric_limits<int>::min())
    return std::nullopt;
  return static_cast<int>(*value);
}

bool read_identification(std::string_view line, bool by_blanks, UffFunction& function) {
  constexpr std::size_t widths[] = {5, 10, 5, 10, 11, 10, 4, 11, 10, 4};
  const std::vector<std::string_view> f = fields(line, widths, by_blanks);
  if (f.size() != std::size(widths)) return false;
  const auto type = small_or_blank(f[0]), response = small_or_blank(f[6]), reference = small_or_blank(f[9]);
  const auto identification = whole_or_blank(f[1]), version = whole_or_blank(f[2]),
             load_case = whole_or_blank(f[3]);
  const auto response_node = whole_or_blank(f[5]), reference_node = whole_or_blank(f[8]);
  if (!type || !response || !reference || !identification || !version || !load_case || !response_node ||
      !reference_node)
    return false;
  function.type = *type;
  function.identification = *identification;
  function.version = *version;
  function.load_case = *load_case;
  function.response = {label(f[4]), *response_node, *response};
  function.reference = {label(f[7]), *reference_node, *reference};
  return true;
}

bool read_data_form(std::string_view line, bool by_blanks, UffHeader& header) {
  constexpr std::size_t widths[] = {10, 10, 10, 13, 13, 13};
  std::vector<std::string_view> f = fields(line, widths, by_blanks);
  if (by_blanks && f.size() == 5) f.emplace_back();  // no z value
  if (f.size() != std::size(widths)) return false;
  const auto number_or_blank = [](std::string_view text) {
    return stripped(text).empty() ? 0 : fortran_number(text);
  };
  const auto type = whole_number(f[0]), count = whole_number(f[1]), spacing = whole_number(f[2]);
  const auto start = number_or_blank(f[3]), step = number_or_blank(f[4]), z = number_or_blank(f[5]);
  if (!type || !count || !spacing || !start || !step || !z) return false;
  if (*count < 0 || *type < 2 || *type > 6 || *type == 3 || *spacing < 0 || *spacing > 1) return false;
  header.count = static_cast<std::size_t>(*count);
  UffFunction& function = header.function;
  function.ordinate = static_cast<UffOrdinate>(*type);
  function.even = *spacing == 1;
  function.start = *start;
  function.z_value = *z;
  if (!function.even) return true;
  function.rate = meant_rate(f[4], *step);
  return std::isfinite(*start) && std::isfinite(function.rate) && function.rate > 0;
}

UffAxis read_axis(UffLines& lines) {
  const std::string_view line = lines.take();
  const auto type = small_or_blank(column(line, 0, 10)), length = small_or_blank(column(line, 10, 5)),
             force = small_or_blank(column(line, 15, 5)), temperature = small_or_blank(column(line, 20, 5));
  if (!type || !length || !force || !temperature)
    lines.fail("does not describe an axis",
               "a data type, three exponents and two texts were expected (format I10,3I5,2(1X,20A1))");
  // The unit ends the line: letters of two bytes may push it past its column.
  return {*type, *length, *force, *temperature, label(column(line, 26, 20)), label(column(line, 47, 80))};
}

}  // namespace

UffHeader read_uff_header(UffLines& lines) {
  UffHeader header;
  UffFunction& function = header.function;
  for (std::string& id_line : function.id_lines) id_line = label(lines.take().substr(0, 160));
  const std::string_view identification = lines.take();
  if (!read_identification(identification, false, function) && !read_identification(identification, true, function))
    lines.fail("does not identify a function",
               "numbers and names in the format 2(I5,I10),2(1X,10A1,I10,I4) were expected");
  const std::string_view form = lines.take();
  // By blanks first: numbers of seven and more digits are common and move the fields behind them.
  if (!read_data_form(form, true, header) && !read_data_form(form, false, header))
    lines.fail(
        "does not say the form of the data",
        "the type (2, 4, 5, 6), the count, the spacing (0 uneven, 1 even), the start and a positive interval "
        "were expected (format 3I10,3E13.5)");
  for (UffAxis* axis : {&function.abscissa, &function.numerator, &function.denominator, &function.z})
    *axis = read_axis(lines);
  return header;
}

}  // namespace secular
