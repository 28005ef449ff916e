#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace secular {

/// A format that is known by its content but not read, and what makes a file of it that is.
struct UnreadFormat {
  std::string_view name, way;
};

/// The format of that file if it is one of those; nullptr for others.
const UnreadFormat* unread_format(const std::filesystem::path& path);

}  // namespace secular
