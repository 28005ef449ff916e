#include "input/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <thread>
#include <utility>

#include "input/input_error.hpp"

namespace secular {

FolderLock::FolderLock(const std::filesystem::path& folder, double limit_s) {
  descriptor_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor_ < 0) return;
  const auto begun = std::chrono::steady_clock::now();
  const auto spent = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  };
  do {
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) {
      state_ = State::held;
      return;
    }
    state_ = errno == EWOULDBLOCK || errno == EINTR ? State::taken : State::unknown;
    if (state_ == State::taken && spent() < limit_s) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  } while (state_ == State::taken && spent() < limit_s);
}

FolderLock::FolderLock(FolderLock&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), state_(std::exchange(other.state_, State::unknown)) {}

FolderLock& FolderLock::operator=(FolderLock&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(state_, other.state_);
  return *this;
}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

FolderLock lock_or_refuse(const std::filesystem::path& folder) {
  FolderLock lock(folder);
  if (lock.state() == FolderLock::State::taken)
    throw InputError(folder.string(), "", "another command is at work in it",
                     "wait until that has ended, or name another folder");
  return lock;
}

}  // namespace secular
