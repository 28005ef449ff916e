#include "measure/data/whole_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "input/input_error.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

// Removes what is being built when the program is told to end: a handler may not, so that it wakes a thread that
// does. A signal that was ignored before stays so; programs that are started from here know nothing of this.
class Interruption {
 public:
  static Interruption& instance() {
    static Interruption* const only = new Interruption;  // its thread may outlive static objects
    return *only;
  }
  std::mutex& guard() { return guard_; }
  // With guard() held.
  void add(const WholeFolder* folder) { unfinished_.push_back(folder); }
  void take_out(const WholeFolder* folder) { std::erase(unfinished_, folder); }

 private:
  Interruption() {
    if (::pipe2(pipe_, O_CLOEXEC) != 0) return;
    wake_ = pipe_[1];
    std::thread([this] { wait(); }).detach();
    struct sigaction action = {}, before = {};
    action.sa_handler = [](int signal) {
      const int error = errno;
      const auto byte = static_cast<unsigned char>(signal);
      [[maybe_unused]] const ssize_t written = ::write(wake_, &byte, 1);
      errno = error;
    };
    ::sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    for (const int signal : {SIGINT, SIGTERM})
      if (::sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_DFL)
        ::sigaction(signal, &action, nullptr);
  }

  void wait() {
    unsigned char signal = 0;
    ssize_t count = 0;
    while ((count = ::read(pipe_[0], &signal, 1)) < 0 && errno == EINTR) {
    }
    if (count != 1) return;
    const std::lock_guard lock(guard_);
    for (const WholeFolder* folder : unfinished_) {
      // Other threads may still be writing into it.
      std::error_code error;
      for (int attempt = 0; attempt < 100 && (attempt == 0 || fs::exists(folder->path(), error)); ++attempt) {
        folder->abandon();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    }
    struct sigaction usual = {};
    usual.sa_handler = SIG_DFL;
    ::sigaction(signal, &usual, nullptr);
    ::kill(::getpid(), signal);
    for (;;) ::pause();  // the guard is held: nothing is put in place any more
  }

  static inline int wake_ = -1;
  int pipe_[2] = {-1, -1};
  std::mutex guard_;
  std::vector<const WholeFolder*> unfinished_;
};

// A name beside the target that nobody else has.
fs::path beside(const fs::path& target, int attempt) {
  return target.parent_path() /
         fmt::format(".{}.unfinished-{}-{}", target.filename().string(), ::getpid(), attempt);
}

}  // namespace

WholeFolder::WholeFolder(const fs::path& target) : target_(fs::absolute(target).lexically_normal()) {
  if (target_.filename().empty()) target_ = target_.parent_path();
  std::error_code error;
  if (fs::exists(target_, error)) target_ = fs::canonical(target_, error);  // what a link points to, not the link
  for (fs::path parent = target_.parent_path(); !parent.empty() && !fs::exists(parent, error);
       parent = parent.parent_path())
    made_ = parent;
  Interruption& interruption = Interruption::instance();
  const std::lock_guard lock(interruption.guard());
  fs::create_directories(target_.parent_path(), error);
  for (int attempt = 0; !error && path_.empty(); ++attempt) {
    const fs::path name = beside(target_, attempt);
    if (fs::create_directory(name, error)) path_ = name;
  }
  if (error) {
    abandon();
    throw InputError(target.string(), "", "cannot be created: " + error.message(),
                     "name a folder in a place that you may write to");
  }
  interruption.add(this);
}

WholeFolder::~WholeFolder() {
  Interruption& interruption = Interruption::instance();
  const std::lock_guard lock(interruption.guard());
  interruption.take_out(this);
  if (!finished_) abandon();
}

void WholeFolder::write(const fs::path& file, const std::function<std::string()>& next) const {
  std::error_code error;
  fs::create_directories((path_ / file).parent_path(), error);
  std::ofstream stream(path_ / file, std::ios::binary);
  for (std::string piece = next(); stream && !piece.empty(); piece = next()) stream << piece;
  stream.close();
  if (!stream)
    throw InputError((target_ / file).string(), "", "cannot be written",
                     "check the name, the permissions and the free space");
}

void WholeFolder::finish(bool replace) {
  const std::lock_guard lock(Interruption::instance().guard());
  const auto fail = [&](const std::error_code& error) {
    throw InputError(target_.string(), "", "cannot be put in place: " + error.message(), "name a new folder");
  };
  std::error_code error;
  fs::rename(path_, target_, error);  // takes the place of an empty folder
  if (error && replace && fs::is_directory(target_)) {
    // Both names change at once. Where the file system cannot, the old folder steps aside and comes back if need
    // be.
    if (::renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) == 0) {
      error.clear();
    } else {
      const fs::path aside = path_.string() + "-replaced";
      fs::rename(target_, aside, error);
      if (error) fail(error);
      fs::rename(path_, target_, error);
      std::error_code ignored;
      fs::rename(aside, error ? target_ : path_, ignored);
    }
    if (!error) fs::remove_all(path_, error);
    error = {};
  }
  if (error) fail(error);
  finished_ = true;
}

void WholeFolder::abandon() const {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
  if (made_.empty()) return;
  for (fs::path parent = target_.parent_path(); fs::remove(parent, ignored) && parent != made_;)
    parent = parent.parent_path();
}

}  // namespace secular
