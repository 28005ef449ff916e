#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace secular {

/// A file's content; nothing if it cannot be read.
std::optional<std::string> read_file_bytes(const std::filesystem::path& path);

/// False if it could not be written whole.
bool write_file_bytes(const std::filesystem::path& path, std::string_view bytes);

/// A new folder inside `parent` that nobody else can enter, removed with everything in it at the end.
class PrivateFolder {
 public:
  explicit PrivateFolder(const std::filesystem::path& parent);  ///< path() is empty if it cannot be made
  ~PrivateFolder();
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace secular
