#include "measure/formats/utf16.hpp"

#include <cstddef>

namespace secular {
namespace {

constexpr char32_t replacement = 0xFFFD;

void append_utf8(char32_t c, std::string& text) {
  const auto byte = [](char32_t bits) { return static_cast<char>(static_cast<unsigned char>(bits)); };
  if (c < 0x80) {
    text += byte(c);
  } else if (c < 0x800) {
    text += byte(0xC0 | c >> 6);
    text += byte(0x80 | (c & 0x3F));
  } else if (c < 0x10000) {
    text += byte(0xE0 | c >> 12);
    text += byte(0x80 | (c >> 6 & 0x3F));
    text += byte(0x80 | (c & 0x3F));
  } else {
    text += byte(0xF0 | c >> 18);
    text += byte(0x80 | (c >> 12 & 0x3F));
    text += byte(0x80 | (c >> 6 & 0x3F));
    text += byte(0x80 | (c & 0x3F));
  }
}

}  // namespace

std::optional<ByteOrder16> utf16_order(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE")) return ByteOrder16::little_endian;
  if (bytes.starts_with("\xFE\xFF")) return ByteOrder16::big_endian;
  constexpr std::size_t looked_at = 32;
  if (bytes.size() < looked_at) return std::nullopt;
  const auto ascii_at = [&](std::size_t first) {
    for (std::size_t i = 0; i < looked_at; ++i) {
      const auto value = static_cast<unsigned char>(bytes[i]);
      if (i % 2 == first ? value == 0 || value >= 0x80 : value != 0) return false;
    }
    return true;
  };
  if (ascii_at(0)) return ByteOrder16::little_endian;
  if (ascii_at(1)) return ByteOrder16::big_endian;
  return std::nullopt;
}

std::string utf8_of_utf16(std::string_view bytes, ByteOrder16 order) {
  const auto unit = [&](std::size_t i) -> char32_t {
    const auto first = static_cast<unsigned char>(bytes[i]), second = static_cast<unsigned char>(bytes[i + 1]);
    return static_cast<char32_t>(order == ByteOrder16::little_endian ? second << 8U | first : first << 8U | second);
  };
  std::string text;
  text.reserve(bytes.size() / 2);
  for (std::size_t i = 0; i < bytes.size(); i += 2) {
    if (i + 1 == bytes.size()) {
      append_utf8(replacement, text);
      break;
    }
    char32_t c = unit(i);
    if (i == 0 && c == 0xFEFF) continue;
    const bool high = c >= 0xD800 && c < 0xDC00, low = c >= 0xDC00 && c < 0xE000;
    if (high && i + 3 < bytes.size() && unit(i + 2) >= 0xDC00 && unit(i + 2) < 0xE000) {
      c = 0x10000 + ((c - 0xD800) << 10) + (unit(i + 2) - 0xDC00);
      i += 2;
    } else if (high || low) {
      c = replacement;
    }
    append_utf8(c, text);
  }
  return text;
}

}  // namespace secular
