#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace secular {

enum class ByteOrder16 { little_endian, big_endian };

/// Whether bytes begin as UTF-16 text: with its byte order mark, or with 16 characters of ASCII in two bytes each.
std::optional<ByteOrder16> utf16_order(std::string_view bytes);

/// The same text as UTF-8, without a byte order mark. What is half of a pair, or of a character, becomes U+FFFD.
std::string utf8_of_utf16(std::string_view bytes, ByteOrder16 order);

}  // namespace secular
