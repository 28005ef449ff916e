#include "report/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace secular::report {
namespace {

// Set by PlainNumbers.
bool plain = false;

std::string_view minus() {
  return plain ? "-" : "\u2212";
}
std::string_view narrow_space() {
  return plain ? " " : "\u202F";
}
std::string_view plus_or_minus() {
  return plain ? " +- " : " ± ";
}
constexpr std::string_view not_available = "n/a";

/// Decimal exponent of |value| after rounding to `significant` digits: 9.996 with three digits is 10.0, exponent 1.
int decimal_exponent(double value, int significant) {
  const std::string text = fmt::format("{:.{}e}", std::abs(value), significant - 1);
  return std::atoi(text.c_str() + text.find('e') + 1);
}

std::string infinity_text(double value) {
  return std::string(value < 0 ? minus() : "") + (plain ? "inf" : "∞");
}

std::string times_power_of_ten(int exponent) {
  if (exponent == 0) return "";
  return plain ? fmt::format("e{:+03}", exponent) : "\u202F×\u202F10" + superscript(exponent);
}

bool plain_notation(int exponent) {
  return exponent >= -3 && exponent < 5;
}

/// value / 10^exponent; dividing by the exact power keeps 0.3 of 0.3e-6 where multiplying by 1e6 would not.
double scaled(double value, int exponent) {
  return exponent >= 0 ? value / std::pow(10.0, exponent) : value * std::pow(10.0, -exponent);
}

}  // namespace

PlainNumbers::PlainNumbers(bool wanted) : before_(plain) {
  plain = wanted;
}

PlainNumbers::~PlainNumbers() {
  plain = before_;
}

std::string superscript(int number) {
  if (plain) return fmt::format("^{}", number);
  static constexpr std::array<std::string_view, 10> digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char c : fmt::format("{}", number)) text += c == '-' ? "⁻" : digits[static_cast<std::size_t>(c - '0')];
  return text;
}

std::string format_fixed(double value, int decimals) {
  std::string digits = fmt::format("{:.{}f}", std::abs(value), decimals);
  const bool is_zero = digits.find_first_not_of("0.") == std::string::npos;
  return value < 0 && !is_zero ? std::string(minus()) + digits : digits;
}

std::string format_number(double value, int significant) {
  if (std::isnan(value)) return std::string(not_available);
  if (std::isinf(value)) return infinity_text(value);
  if (value == 0) return "0";
  significant = std::max(significant, 1);
  const int exponent = decimal_exponent(value, significant);
  if (exponent >= -3 && exponent < 6) return format_fixed(value, std::max(0, significant - 1 - exponent));
  return format_fixed(scaled(value, exponent), significant - 1) + times_power_of_ten(exponent);
}

std::string format_uncertain(double value, double sd, UncertaintyStyle style) {
  if (!std::isfinite(value)) return format_number(value);
  if (std::isnan(sd)) return format_number(value, 6) + std::string(plus_or_minus()) + "?";
  if (!(sd > 0) || std::isinf(sd)) return format_number(value, 6);

  const int sd_exponent = decimal_exponent(sd, 2);
  const int last_digit = sd_exponent - 1;  // the power of ten of the last digit shown
  const int value_exponent = value == 0 ? sd_exponent : decimal_exponent(value, 1);
  const int leading = std::max(value_exponent, sd_exponent);
  const int power = plain_notation(leading) && last_digit <= 0 ? 0 : leading;
  const int decimals = std::max(0, power - last_digit);
  const std::string mean = format_fixed(scaled(value, power), decimals);
  const double spread = scaled(sd, power);

  if (style == UncertaintyStyle::plus_minus) {
    const std::string both = mean + std::string(plus_or_minus()) + format_fixed(spread, decimals);
    return power == 0 ? both : "(" + both + ")" + times_power_of_ten(power);
  }
  // Digits in parentheses count in units of the last place; once sd reaches past the decimal point that is misread,
  // so the point is written: 12.3(1.4).
  const std::string digits =
      power - sd_exponent <= 0 ? format_fixed(spread, decimals) : format_fixed(scaled(sd, last_digit), 0);
  return mean + "(" + digits + ")" + times_power_of_ten(power);
}

std::string format_quantity(double value, double sd, std::string_view unit, UncertaintyStyle style) {
  const std::string shown_unit = pretty_unit(unit);
  std::string text = format_uncertain(value, sd, style);
  if (shown_unit.empty()) return text;
  if (text.find(plus_or_minus()) != std::string::npos && text.front() != '(') text = "(" + text + ")";
  return text + std::string(narrow_space()) + shown_unit;
}

std::string format_interval(double low, double high) {
  if (!std::isfinite(low) || !std::isfinite(high) || high <= low)
    return "[" + format_number(low) + ", " + format_number(high) + "]";
  const int width_exponent = decimal_exponent(high - low, 2);
  const int last_digit = width_exponent - 1;
  const int leading = decimal_exponent(std::max(std::abs(low), std::abs(high)), 1);
  const int power = plain_notation(leading) && last_digit <= 0 ? 0 : leading;
  const int decimals = std::max(0, power - last_digit);
  return "[" + format_fixed(scaled(low, power), decimals) + ", " + format_fixed(scaled(high, power), decimals) +
         "]" + times_power_of_ten(power);
}

std::string format_percent(double fraction, int decimals) {
  if (!std::isfinite(fraction)) return format_number(fraction);
  return format_fixed(100 * fraction, decimals) + std::string(narrow_space()) + "%";
}

std::string format_p(double probability) {
  return probability < 1e-15 ? "p < 1e-15" : fmt::format("p = {:.2g}", probability);
}

std::string pretty_unit(std::string_view unit) {
  if (unit.empty() || unit == "1") return "";
  std::string text;
  for (std::size_t i = 0; i < unit.size();) {
    if (unit[i] != '^') {
      text += unit[i++];
      continue;
    }
    std::size_t end = i + 1;
    if (end < unit.size() && unit[end] == '-') ++end;
    const std::size_t digits_begin = end;
    while (end < unit.size() && unit[end] >= '0' && unit[end] <= '9') ++end;
    const bool is_small_integer = end > digits_begin && end - digits_begin <= 3;
    const bool is_decimal =
        end + 1 < unit.size() && unit[end] == '.' && unit[end + 1] >= '0' && unit[end + 1] <= '9';
    if (!is_small_integer || is_decimal) {
      text += unit[i++];
      continue;
    }
    text += superscript(std::atoi(std::string(unit.substr(i + 1, end - i - 1)).c_str()));
    i = end;
  }
  return text;
}

}  // namespace secular::report
