#include "report/whole_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <string>

#include "input/input_error.hpp"
#include "input/interruption.hpp"

namespace secular::report {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
  throw InputError(path.string(), "", std::string("cannot be written: ") + std::strerror(error),
                   "name a file in an existing folder that you may write to");
}

/// Removes the temporary file unless it has become the target.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& target) {
    // O_EXCL instead of mkstemp: the file is made with the user's usual permissions, and a left-over is never
    // reused.
    for (int attempt = 0; descriptor_ < 0; ++attempt) {
      name_ = fmt::format("{}.partial-{}-{}", target.string(), ::getpid(), attempt);
      descriptor_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor_ < 0 && errno != EEXIST && errno != EINTR) fail(target, errno);
    }
    Interruption& interruption = Interruption::instance();
    const std::lock_guard lock(interruption.guard());
    interruption.add(this, [this] { return ::unlink(name_.c_str()) == 0 || errno == ENOENT; });
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    Interruption& interruption = Interruption::instance();
    const std::lock_guard lock(interruption.guard());
    interruption.take_out(this);
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!renamed_) ::unlink(name_.c_str());
  }

  /// Each returns 0 or an errno value.
  int write(std::string_view text) const {
    while (!text.empty()) {
      const ssize_t written = ::write(descriptor_, text.data(), text.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return errno;
      text.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
  }
  int become(const std::filesystem::path& target) {
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0) return errno;
    const std::lock_guard lock(Interruption::instance().guard());
    if (::rename(name_.c_str(), target.c_str()) != 0) return errno;
    renamed_ = true;
    return 0;
  }

 private:
  std::string name_;
  int descriptor_ = -1;
  bool renamed_ = false;
};

}  // namespace

void write_whole_file(const std::filesystem::path& path, std::string_view text) {
  TemporaryFile file(path);
  if (const int error = file.write(text)) fail(path, error);
  if (const int error = file.become(path)) fail(path, error);
}

}  // namespace secular::report
