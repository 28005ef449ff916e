#include "measure/formats/clock_stamp.hpp"

#include <charconv>
#include <chrono>

namespace secular {
namespace {

// Takes a whole number of so many digits off the begin; nothing if it is none.
std::optional<int> take_digits(std::string_view& text, std::size_t digits) {
  int value = 0;
  if (text.size() < digits) return std::nullopt;
  const auto end = std::from_chars(text.data(), text.data() + digits, value);
  if (end.ec != std::errc() || end.ptr != text.data() + digits || value < 0) return std::nullopt;
  text.remove_prefix(digits);
  return value;
}

bool take_mark(std::string_view& text, std::string_view marks) {
  if (text.empty() || marks.find(text.front()) == std::string_view::npos) return false;
  text.remove_prefix(1);
  return true;
}

// Days since the begin of 1970.
std::optional<double> take_date(std::string_view& text) {
  std::optional<int> year, month, day;
  if (text.size() > 4 && (text[4] == '-' || text[4] == '/')) {
    const std::string_view mark = text.substr(4, 1);
    year = take_digits(text, 4);
    take_mark(text, mark);
    month = take_digits(text, 2);
    if (!take_mark(text, mark)) return std::nullopt;
    day = take_digits(text, 2);
  } else {
    day = take_digits(text, 2);
    if (!take_mark(text, ".")) return std::nullopt;
    month = take_digits(text, 2);
    if (!take_mark(text, ".")) return std::nullopt;
    year = take_digits(text, 4);
  }
  if (!year || !month || !day || !take_mark(text, "T ")) return std::nullopt;
  const std::chrono::year_month_day date(std::chrono::year(*year),
                                         std::chrono::month(static_cast<unsigned>(*month)),
                                         std::chrono::day(static_cast<unsigned>(*day)));
  if (!date.ok()) return std::nullopt;
  return static_cast<double>(std::chrono::sys_days(date).time_since_epoch().count());
}

// "+02:00" or "Z", in seconds; nothing if something else is left.
std::optional<double> take_offset(std::string_view text) {
  if (text.empty() || text == "Z") return 0;
  const double sign = text.front() == '-' ? -1 : 1;
  if (!take_mark(text, "+-")) return std::nullopt;
  const std::optional<int> hours = take_digits(text, 2);
  take_mark(text, ":");
  const std::optional<int> minutes = take_digits(text, 2);
  if (!hours || !minutes || !text.empty()) return std::nullopt;
  return sign * (3600.0 * *hours + 60.0 * *minutes);
}

}  // namespace

std::optional<double> clock_stamp(std::string_view text) {
  if (text.find(':') == std::string_view::npos) return std::nullopt;
  double days = 0;
  if (const std::size_t word = text.find(" days "); word != std::string_view::npos) {  // "0 days 00:00:00.5"
    const std::optional<int> whole = take_digits(text, word);
    if (!whole) return std::nullopt;
    days = *whole;
    text.remove_prefix(std::string_view(" days ").size());
  } else if (text.size() > 10 && text[2] != ':') {
    const std::optional<double> date = take_date(text);
    if (!date) return std::nullopt;
    days = *date;
  }
  const std::optional<int> hours = take_digits(text, 2);
  if (!hours || !take_mark(text, ":")) return std::nullopt;
  const std::optional<int> minutes = take_digits(text, 2);
  if (!minutes || !take_mark(text, ":")) return std::nullopt;
  const std::optional<int> whole = take_digits(text, 2);
  if (!whole || *hours > 24 || *minutes > 59 || *whole > 60) return std::nullopt;
  double digits = 0, scale = 1;  // one rounding: 0.000488281 is the number that this text means
  if (take_mark(text, ".,"))
    for (; !text.empty() && text.front() >= '0' && text.front() <= '9'; text.remove_prefix(1), scale *= 10)
      digits = 10 * digits + (text.front() - '0');
  const double fraction = digits / scale;
  const std::optional<double> offset = take_offset(text);
  if (!offset) return std::nullopt;
  return 86400 * days + 3600.0 * *hours + 60.0 * *minutes + *whole + fraction - *offset;
}

}  // namespace secular
