#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "codegen/document/latex_math.hpp"

namespace secular::typeset {
namespace {

// The code point at `at` and the bytes it takes; a stray byte counts as itself.
std::pair<std::uint32_t, std::size_t> code_point(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])); };
  const std::uint32_t lead = byte(at);
  const std::size_t length = lead < 0xC0 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  if (length == 1 || at + length > text.size()) return {lead, 1};
  std::uint32_t value = lead & (0xFFu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) value = (value << 6u) | (byte(at + i) & 0x3Fu);
  return {value, length};
}

// What LaTeX's default input encoding and fonts have for certain: accented Latin letters, dashes and quotes.
bool latex_has(std::uint32_t value) {
  return (value >= 0xC0 && value <= 0xFF && value != 0xD0 && value != 0xDE && value != 0xF0 && value != 0xFE &&
          value != 0xD7 && value != 0xF7) ||
         value == 0x2013 || value == 0x2014 || value == 0x2018 || value == 0x2019 || value == 0x201C ||
         value == 0x201D;
}

std::string special(char c) {
  switch (c) {
    case '\\':
      return "\\textbackslash{}";
    case '~':
      return "\\textasciitilde{}";
    case '^':
      return "\\textasciicircum{}";
    case '<':
      return "\\textless{}";
    case '>':
      return "\\textgreater{}";
    case '|':
      return "\\textbar{}";
    case '"':
      return "{''}";
    case '#':
    case '$':
    case '%':
    case '&':
    case '_':
    case '{':
    case '}':
      return std::string("\\") + c;
    default:
      return static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? " " : std::string(1, c);
  }
}

}  // namespace

std::string latex_text(std::string_view text) {
  std::string safe;
  for (std::size_t at = 0; at < text.size();) {
    const auto [value, length] = code_point(text, at);
    if (value < 0x80)
      safe += special(text[at]);
    else if (latex_has(value) && length > 1)
      safe += text.substr(at, length);
    else
      safe += fmt::format("[U+{:04X}]", value);
    at += length;
  }
  return safe;
}

}  // namespace secular::typeset
