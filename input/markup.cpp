#include "input/markup.hpp"

#include <cstdint>

namespace secular {
namespace {

constexpr std::string_view replacement_character = "\xEF\xBF\xBD";

struct CodePoint {
  std::uint32_t value = 0;
  std::size_t bytes = 1;
  bool valid = false;
};

/// Decodes the code point at the front of non-empty `text`; overlong forms, surrogates and values above U+10FFFF
/// are invalid and one byte long.
CodePoint first_code_point(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])); };
  const std::uint32_t lead = byte(0);
  if (lead < 0x80) return {lead, 1, true};
  const std::size_t length = lead >= 0xF0 && lead <= 0xF4  ? 4
                             : lead >= 0xE0 && lead < 0xF0 ? 3
                             : lead >= 0xC2 && lead < 0xE0 ? 2
                                                           : 1;
  if (length == 1 || text.size() < length) return {lead, 1, false};
  std::uint32_t value = lead & (0xFFu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0u) != 0x80u) return {lead, 1, false};
    value = (value << 6u) | (byte(i) & 0x3Fu);
  }
  const bool overlong = (length == 3 && value < 0x800) || (length == 4 && value < 0x10000);
  const bool surrogate = value >= 0xD800 && value <= 0xDFFF;
  if (overlong || surrogate || value > 0x10FFFF) return {lead, 1, false};
  return {value, length, true};
}

bool allowed_in_xml(std::uint32_t value) {
  if (value == '\t' || value == '\n' || value == '\r') return true;
  return value >= 0x20 && value != 0x7F && !(value >= 0x80 && value < 0xA0) && value != 0xFFFE && value != 0xFFFF;
}

std::string escape(std::string_view text, bool one_line) {
  std::string safe;
  safe.reserve(text.size() + text.size() / 8);
  while (!text.empty()) {
    const CodePoint point = first_code_point(text);
    const std::string_view bytes = text.substr(0, point.bytes);
    text.remove_prefix(point.bytes);
    if (!point.valid || !allowed_in_xml(point.value)) {
      safe += replacement_character;
      continue;
    }
    switch (point.value) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      case '\t':
      case '\n':
      case '\r':
        if (one_line) {
          safe += ' ';
          break;
        }
        [[fallthrough]];
      default:
        safe += bytes;
    }
  }
  return safe;
}

}  // namespace

std::string escape_markup(std::string_view text) {
  return escape(text, false);
}

std::string escape_markup_line(std::string_view text) {
  return escape(text, true);
}

std::size_t code_points(std::string_view text) {
  std::size_t count = 0;
  for (; !text.empty(); ++count) text.remove_prefix(first_code_point(text).bytes);
  return count;
}

}  // namespace secular
