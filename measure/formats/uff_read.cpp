#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "input/input_error.hpp"
#include "measure/formats/damaged_file.hpp"
#include "measure/formats/file_bytes.hpp"
#include "measure/formats/fortran_number.hpp"
#include "measure/formats/mapped_file.hpp"
#include "measure/formats/stored_numbers.hpp"
#include "measure/formats/uff_data_set.hpp"
#include "measure/formats/uff_file.hpp"
#include "measure/formats/uff_header.hpp"
#include "measure/formats/uff_lines.hpp"

namespace secular {
namespace {

/// Gives the numbers of a data set, in stored order, to their places in the function.
class NumberSink {
 public:
  explicit NumberSink(UffHeader& header)
      : function_(header.function),
        a_value_((header.function.even ? 1u : 2u) + (is_complex(header.function.ordinate) ? 1u : 0u)) {}

  void put(double value) {
    const std::size_t part = taken_++ % a_value_;
    if (!function_.even && part == 0)
      function_.uneven_abscissa.push_back(value);
    else if (part == (function_.even ? 0u : 1u))
      function_.real.push_back(value);
    else
      function_.imaginary.push_back(value);
  }
  std::size_t a_value() const { return a_value_; }
  std::size_t taken() const { return taken_; }

 private:
  UffFunction& function_;
  std::size_t a_value_, taken_ = 0;
};

std::span<const std::size_t> column_widths(const UffFunction& function) {
  static constexpr std::array<std::size_t, 6> single = {13, 13, 13, 13, 13, 13};
  static constexpr std::array<std::size_t, 4> even = {20, 20, 20, 20}, uneven = {13, 20, 13, 20};
  static constexpr std::array<std::size_t, 3> complex_uneven = {13, 20, 20};
  if (!is_double(function.ordinate)) return single;
  if (function.even) return even;
  if (is_complex(function.ordinate)) return complex_uneven;
  return uneven;
}

// Numbers by the blanks between them; nothing if some text between blanks is no number.
std::optional<std::vector<double>> numbers_by_blanks(std::string_view line) {
  std::vector<double> numbers;
  for (line = stripped(line); !line.empty(); line = stripped(line)) {
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    const auto number = fortran_number(line.substr(0, end));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    line.remove_prefix(end);
  }
  return numbers;
}

// Numbers that fill their columns have no blanks between them: -1.00000E-100-1.00000E-100.
std::optional<std::vector<double>> numbers_by_columns(std::string_view line, std::span<const std::size_t> widths) {
  std::vector<double> numbers;
  for (const std::size_t width : widths) {
    if (stripped(line).empty()) break;
    const std::size_t end = std::min(width, line.size());
    const auto number = fortran_number(line.substr(0, end));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    line.remove_prefix(end);
  }
  return stripped(line).empty() ? std::optional(std::move(numbers)) : std::nullopt;
}

// From inside of the numbers to behind the delimiter: it is tried where lines of equal length would put it.
bool skip_numbers(UffLines& lines, std::size_t missing, std::size_t a_line, std::size_t line_size) {
  if (missing > a_line) {
    const std::size_t full = (missing - 1) / a_line;
    UffLines ahead = lines;
    if (full <= ahead.left() / line_size && ahead.skip_lines(full, full * line_size)) {
      ahead.take();
      if (!ahead.at_end() && is_uff_delimiter(ahead.take())) {
        lines = ahead;
        return true;
      }
    }
  }
  while (!lines.at_end())
    if (is_uff_delimiter(lines.take())) return true;
  return false;
}

// Takes the delimiter too.
void read_ascii_numbers(UffLines& lines, UffHeader& header, std::size_t limit) {
  NumberSink sink(header);
  const std::span<const std::size_t> widths = column_widths(header.function);
  const auto announced = [&] {
    return fmt::format("{} {}", header.count, header.function.even ? "values" : "pairs");
  };
  const auto is_more = [&](std::size_t count) {
    return (count + sink.a_value() - 1) / sink.a_value() > header.count;
  };
  while (!lines.at_end()) {
    const std::string_view line = lines.take();
    if (is_uff_delimiter(line)) {
      if (sink.taken() % sink.a_value() != 0 || sink.taken() / sink.a_value() != header.count)
        lines.fail(
            fmt::format("the data set ends after {} numbers, its header announces {}", sink.taken(), announced()),
            whole_again);
      return;
    }
    auto numbers = numbers_by_blanks(line);
    if (!numbers) numbers = numbers_by_columns(line, widths);
    if (!numbers) lines.fail("is no line of numbers", "numbers or the delimiter -1 were expected");
    if (is_more(sink.taken() + numbers->size()))
      lines.fail("holds more numbers than the header announces: " + announced(), whole_again);
    for (const double number : *numbers) sink.put(number);
    if (sink.taken() / sink.a_value() >= limit && sink.taken() / sink.a_value() < header.count &&
        sink.taken() % sink.a_value() == 0 && !numbers->empty()) {
      const std::size_t missing = header.count * sink.a_value() - sink.taken();
      if (skip_numbers(lines, missing, numbers->size(), line.size() + 1)) return;
      break;
    }
  }
  lines.fail("the data set does not end: the delimiter -1 is missing", whole_again);
}

// What writers fill blocks with: zeros, blanks, ends of lines.
bool is_padding(std::string_view bytes) {
  return bytes.find_first_not_of(std::string_view("\0 \t\r\n", 5)) == std::string_view::npos;
}

// Whether what is counted behind the numbers fills a block, and nothing of the delimiter is.
bool ends_in_padding(std::string_view padding, std::string_view behind) {
  if (padding.empty()) return true;
  return is_padding(padding) &&
         behind.substr(std::min(behind.find_first_not_of("\r\n"), behind.size())).starts_with("    -1");
}

// The abscissa of double numbers is single in the ASCII format; binary writers store it so or as double. Some count
// what fills their last block, too.
std::size_t abscissa_size(const UffLines& lines, const UffHeader& header, std::size_t bytes) {
  const UffFunction& function = header.function;
  const std::size_t size = is_double(function.ordinate) ? 8 : 4;
  const std::size_t ordinate = is_complex(function.ordinate) ? 2 * size : size;
  const auto fits = [&](std::size_t a_value) {
    const std::size_t used = header.count * a_value;
    return header.count <= bytes / a_value &&
           ends_in_padding(lines.rest().substr(used, bytes - used), lines.rest().substr(bytes));
  };
  if (header.count > bytes / ordinate)
    lines.fail(fmt::format("announces {} values and {} bytes for them", header.count, bytes), whole_again);
  if (function.even) {
    if (fits(ordinate)) return 0;
  } else {
    for (const std::size_t abscissa : {size, std::size_t{4}})
      if (fits(ordinate + abscissa)) return abscissa;
  }
  lines.fail(fmt::format("announces {} bytes for {} {} of {} bytes", bytes, header.count,
                         function.even ? "values" : "pairs", ordinate),
             whole_again);
}

// Takes the delimiter too, which may follow with or without a line break.
void read_binary_numbers(UffLines& lines, const UffDataSetHead& head, UffHeader& header, std::size_t limit) {
  const UffFunction& function = header.function;
  if (static_cast<unsigned long long>(head.bytes) > lines.left())
    lines.fail(fmt::format("{} bytes of data are announced, {} follow", head.bytes, lines.left()), whole_again);
  const auto bytes = static_cast<std::size_t>(head.bytes);
  const std::size_t abscissa = abscissa_size(lines, header, bytes);
  const std::string_view data = lines.take_bytes(bytes);
  const ByteOrder order = head.byte_order == 1 ? ByteOrder::little : ByteOrder::big;
  NumberSink sink(header);
  std::size_t at = 0;
  while (sink.taken() / sink.a_value() < std::min(header.count, limit)) {
    const bool of_abscissa = !function.even && sink.taken() % sink.a_value() == 0;
    const std::size_t size = of_abscissa ? abscissa : is_double(function.ordinate) ? 8 : 4;
    sink.put(float_at(data, at, size, order));
    at += size;
  }
  std::string_view line = lines.take();
  while (is_padding(line) && !lines.at_end()) line = lines.take();
  line.remove_prefix(std::min(line.find_first_not_of('\0'), line.size()));
  if (!is_uff_delimiter(line)) lines.fail("the delimiter -1 does not follow the binary data", whole_again);
}

UffFunction read_function(UffLines& lines, const UffDataSetHead& head, std::size_t limit) {
  if (head.binary) {
    if (head.byte_order != 1 && head.byte_order != 2)
      lines.fail(fmt::format("byte order {} is not known", head.byte_order), "1 (little) or 2 (big) was expected");
    if (head.float_format != 2)
      lines.fail(fmt::format("floating point format {} (1 VAX, 3 IBM) is not read", head.float_format),
                 "2 (IEEE 754) was expected: export the file again on another system or as ASCII");
    if (head.header_lines != 11)
      lines.fail(fmt::format("has {} lines in front of the data", head.header_lines), "11 were expected");
  }
  UffHeader header = read_uff_header(lines);
  header.function.count = header.count;
  if (head.binary)
    read_binary_numbers(lines, head, header, limit);
  else
    read_ascii_numbers(lines, header, limit);
  return std::move(header.function);
}

}  // namespace

std::vector<UffFunction> read_uff(const std::filesystem::path& path, std::size_t limit) {
  const MappedFile mapped(path);
  const std::string_view text = mapped.bytes();
  UffLines lines(text, path.string());
  if (stripped(text).empty()) throw InputError(path.string(), "", "is empty", "data sets 58 were expected");
  std::vector<UffFunction> functions;
  UffDataSetHead head;
  while (next_data_set(lines, head)) {
    if (head.number == 58)
      functions.push_back(read_function(lines, head, limit));
    else
      skip_data_set(head, lines);
  }
  return functions;
}

bool looks_like_uff(const std::filesystem::path& path) {
  const std::string begin = some_bytes(path, 100);
  const std::size_t end = begin.find('\n');
  return end != std::string::npos && is_uff_delimiter(std::string_view(begin).substr(0, end));
}

}  // namespace secular
