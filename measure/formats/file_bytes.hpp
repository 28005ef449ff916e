#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace secular {

/// At most `count` bytes of a file from `begin` on; empty if there are none or it cannot be read.
std::string some_bytes(const std::filesystem::path& path, std::size_t count, std::size_t begin = 0);

/// Text of unknown encoding as UTF-8: what is not UTF-8 already is taken for Latin-1 (ISO 8859-1).
std::string as_utf8(std::string_view text);

}  // namespace secular
