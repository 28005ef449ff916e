#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

namespace secular {

/// A file as memory: only the pages that are looked at are read, whatever its size. The file must not be cut short
/// while it is mapped.
class MappedFile {
 public:
  /// Throws InputError if it is a folder or cannot be read.
  explicit MappedFile(const std::filesystem::path& path);
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;
  ~MappedFile();

  std::string_view bytes() const { return {begin_, size_}; }

  /// Whoever reads from begin to end says so: pages in front of `offset` leave memory (and come back when they are
  /// looked at again).
  void release_before(std::size_t offset);

  /// The same for the whole pages between two places.
  void forget(std::size_t begin, std::size_t end);

 private:
  const char* begin_ = nullptr;
  std::size_t size_ = 0, released_ = 0;
};

}  // namespace secular
