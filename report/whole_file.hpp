#pragma once

#include <filesystem>
#include <string_view>

namespace secular::report {

/// Writes `text` to `path` so that a reader sees the old file or the whole new one, never a part: a temporary file
/// beside it, then a rename. Throws InputError where the folder is missing or cannot be written to; then nothing is
/// left behind.
void write_whole_file(const std::filesystem::path& path, std::string_view text);

}  // namespace secular::report
