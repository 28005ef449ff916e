#include "tests/campaign/uff_write.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/campaign/append_numbers.hpp"

namespace secular {
namespace {

constexpr const char* delimiter = "    -1\n";

// The format has no empty texts.
std::string cut(const std::string& text, std::size_t width) {
  return text.empty() ? "NONE" : text.substr(0, width);
}

std::string point_text(const UffPoint& point) {
  return fmt::format(" {:<10}{:10}{:4}", cut(point.entity, 10), point.node, point.direction);
}

std::string axis_text(const UffAxis& axis) {
  return fmt::format("{:10}{:5}{:5}{:5} {:<20} {:<20}\n", axis.data_type, axis.length_exponent, axis.force_exponent,
                     axis.temperature_exponent, cut(axis.label, 20), cut(axis.unit, 20));
}

std::string header_text(const UffFunction& function) {
  std::string text;
  for (const std::string& line : function.id_lines) text += cut(line, 80) + "\n";
  text += fmt::format("{:5}{:10}{:5}{:10}{}{}\n", function.type, function.identification, function.version,
                      function.load_case, point_text(function.response), point_text(function.reference));
  text += fmt::format("{:10}{:10}{:10}{:13.5E}{:13.5E}{:13.5E}\n", static_cast<int>(function.ordinate),
                      function.real.size(), function.even ? 1 : 0, function.even ? function.start : 0.0,
                      function.even ? 1 / function.rate : 0.0, function.z_value);
  for (const UffAxis* axis : {&function.abscissa, &function.numerator, &function.denominator, &function.z})
    text += axis_text(*axis);
  return text;
}

struct StoredNumber {
  double value = 0;
  bool of_abscissa = false;
};

std::vector<StoredNumber> stored_numbers(const UffFunction& function) {
  std::vector<StoredNumber> numbers;
  for (std::size_t i = 0; i < function.real.size(); ++i) {
    if (!function.even) numbers.push_back({function.uneven_abscissa[i], true});
    numbers.push_back({function.real[i], false});
    if (is_complex(function.ordinate)) numbers.push_back({function.imaginary[i], false});
  }
  return numbers;
}

std::string ascii_numbers(const UffFunction& function) {
  const bool twice = is_double(function.ordinate);
  std::size_t a_line = twice ? 4 : 6;
  if (twice && !function.even && is_complex(function.ordinate)) a_line = 3;
  std::string text;
  std::size_t on_line = 0;
  for (const StoredNumber& number : stored_numbers(function)) {
    text += twice && !number.of_abscissa ? fmt::format("{:20.12E}", number.value)
                                         : fmt::format("{:13.5E}", number.value);
    if (++on_line == a_line) {
      text += '\n';
      on_line = 0;
    }
  }
  return on_line == 0 ? text : text + '\n';
}

std::string binary_numbers(const UffFunction& function, ByteOrder order) {
  std::string bytes;
  for (const StoredNumber& number : stored_numbers(function))
    append_float(bytes, number.value, is_double(function.ordinate) ? 8 : 4, order);
  return bytes;
}

}  // namespace

std::string uff_text(const std::vector<UffFunction>& functions, UffEncoding encoding) {
  std::string text;
  for (const UffFunction& function : functions) {
    text += delimiter;
    if (encoding == UffEncoding::ascii) {
      text += "    58\n" + header_text(function) + ascii_numbers(function);
    } else {
      const bool little = encoding == UffEncoding::little_endian;
      const std::string bytes = binary_numbers(function, little ? ByteOrder::little : ByteOrder::big);
      constexpr int ieee_754 = 2, header_lines = 11;
      text += fmt::format("    58b{:6}{:6}{:12}{:12}{:6}{:6}{:12}{:12}\n", little ? 1 : 2, ieee_754, header_lines,
                          bytes.size(), 0, 0, 0, 0);
      text += header_text(function) + bytes;  // the delimiter follows the last byte
    }
    text += delimiter;
  }
  return text;
}

}  // namespace secular
