#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "codegen/runtime/file_bytes.hpp"

namespace secular {

/// Files kept from run to run, each found by the hash of everything it was made from. An entry ends with its key
/// and the digest of its content: an entry that is truncated, altered or misplaced is as good as none. Entries
/// appear whole (they are written elsewhere and renamed), so that any number of programs may use one cache at once.
class ModelCache {
 public:
  /// `folder`, or without it $XDG_CACHE_HOME/secular or ~/.cache/secular. Where none can be written, or others
  /// could write into it, a temporary folder that ends with this object.
  explicit ModelCache(const std::optional<std::filesystem::path>& folder = std::nullopt);

  /// The content stored under `key`; nothing if there is none or it is damaged.
  std::optional<std::string> read(const std::string& key, const std::string& suffix) const;
  /// Stores `content`, replacing what was there. False if that fails.
  bool store(const std::string& key, const std::string& suffix, std::string_view content) const;
  /// File of an entry. What stands after the content does not disturb the loader of shared objects.
  std::filesystem::path file(const std::string& key, const std::string& suffix) const;
  /// An empty folder on the cache's file system to work in.
  PrivateFolder work_folder() const { return PrivateFolder(writable_); }

 private:
  void remove_old_entries() const;

  std::filesystem::path readable_, writable_;
  std::unique_ptr<PrivateFolder> temporary_;
};

}  // namespace secular
