#pragma once

#include <filesystem>

namespace secular {

/// Says that somebody is at work in a folder, to all other processes of this machine, until it is destroyed or the
/// process ends in whatever way.
class FolderLock {
 public:
  enum class State {
    held,     ///< by this object
    taken,    ///< by another one
    unknown,  ///< there is no such folder, or its file system knows no locks
  };

  FolderLock() = default;
  /// Where another one has it, waits up to `limit_s` seconds.
  explicit FolderLock(const std::filesystem::path& folder, double limit_s = 0);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&& other) noexcept;
  ~FolderLock();

  State state() const { return state_; }

 private:
  int descriptor_ = -1;
  State state_ = State::unknown;
};

/// The lock of `folder`. Throws InputError where another command has it.
FolderLock lock_or_refuse(const std::filesystem::path& folder);

}  // namespace secular
