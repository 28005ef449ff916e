#include "measure/data/line_names.hpp"

#include <fmt/format.h>

#include <charconv>
#include <numeric>

namespace secular {
namespace {

/// Of the parts of a line's number that are read.
constexpr int largest_multiple = 999;

}  // namespace

std::string line_suffix(LineNumber number) {
  if (number == LineNumber{}) return "";
  if (number.divisor == 1) return fmt::format("@{}", number.numerator);
  return fmt::format("@{}/{}", number.numerator, number.divisor);
}

std::optional<LineNumber> parsed_line_number(std::string_view text) {
  const auto whole = [](std::string_view digits) -> std::optional<int> {
    int value = 0;
    const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (digits.empty() || end.ec != std::errc() || end.ptr != digits.data() + digits.size() || value < 0 ||
        value > largest_multiple)
      return std::nullopt;
    return value;
  };
  const std::size_t slash = text.find('/');
  const auto over = whole(text.substr(0, slash));
  const auto under = slash == std::string_view::npos ? std::optional(1) : whole(text.substr(slash + 1));
  if (!over || !under || *under == 0) return std::nullopt;
  const int common = std::gcd(*over, *under);
  return LineNumber{*over / common, *under / common};
}

}  // namespace secular
