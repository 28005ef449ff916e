#include "measure/formats/fortran_number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

namespace secular {
namespace {

constexpr std::size_t widest_number = 60;
constexpr int fewest_digits_of_a_rounded_interval = 5;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

struct Digits {
  int printed = 0;      // without leading zeros
  int significant = 0;  // without trailing zeros either
};

Digits mantissa_digits(std::string_view text) {
  Digits digits;
  for (const char c : stripped(text)) {
    if (is_digit(c) && (c != '0' || digits.printed > 0)) {
      ++digits.printed;
      if (c != '0') digits.significant = digits.printed;
    } else if (!is_digit(c) && c != '.' && c != '+' && c != '-') {
      break;
    } else if ((c == '+' || c == '-') && digits.printed > 0) {
      break;
    }
  }
  return digits;
}

}  // namespace

double of_digits(double value, int digits) {
  return std::strtod(fmt::format("{:.{}e}", value, digits - 1).c_str(), nullptr);
}

std::string_view stripped(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::optional<double> fortran_number(std::string_view text) {
  text = stripped(text);
  if (text.starts_with('+') && text.size() > 1 && text[1] != '-' && text[1] != '+') text.remove_prefix(1);
  if (text.empty() || text.size() > widest_number) return std::nullopt;
  double value = 0;
  const auto direct = std::from_chars(text.data(), text.data() + text.size(), value);
  if (direct.ec == std::errc() && direct.ptr == text.data() + text.size()) return value;
  constexpr double missing = std::numeric_limits<double>::quiet_NaN();
  if (text.find_first_not_of('*') == std::string_view::npos || text.find(".#") != std::string_view::npos)
    return missing;
  std::string plain;
  for (const char c : text) {
    const bool sign = c == '+' || c == '-';
    if (sign && !plain.empty() && (is_digit(plain.back()) || plain.back() == '.')) plain += 'e';
    const bool exponent =
        (c == 'D' || c == 'd') && !plain.empty() && (is_digit(plain.back()) || plain.back() == '.');
    plain += exponent ? 'e' : c;
  }
  const auto result = std::from_chars(plain.data(), plain.data() + plain.size(), value);
  if (result.ec == std::errc::invalid_argument || result.ptr != plain.data() + plain.size()) return std::nullopt;
  if (result.ec == std::errc::result_out_of_range) return std::strtod(plain.c_str(), nullptr);
  return value;
}

std::optional<long long> whole_number(std::string_view text) {
  text = stripped(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  long long value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size()) return std::nullopt;
  return value;
}

double meant_rate(std::string_view text, double step) {
  const Digits digits = mantissa_digits(text);
  if (digits.printed < fewest_digits_of_a_rounded_interval) return 1 / step;
  const double last_digit = std::pow(10, std::floor(std::log10(step)) + 1 - digits.printed);
  for (int count = 1; count < digits.significant; ++count)
    if (const double rate = of_digits(1 / step, count); std::abs(1 / rate - step) <= 0.501 * last_digit)
      return rate;
  return 1 / step;
}

}  // namespace secular
