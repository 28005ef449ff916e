#include "blind/child_process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <thread>

namespace secular::blind {
namespace {

// Attributes and file actions of posix_spawn, released in any case.
class SpawnSettings {
 public:
  explicit SpawnSettings(const std::filesystem::path& log) {
    posix_spawnattr_init(&attributes_);
    posix_spawn_file_actions_init(&actions_);
    // A process group of its own, so that a compiler it has started ends with it.
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
  }
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  const posix_spawn_file_actions_t* actions() const { return &actions_; }
  const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

}  // namespace

Ended run_child(const std::vector<std::string>& arguments, const std::filesystem::path& log, double limit_s) {
  using Clock = std::chrono::steady_clock;
  Ended ended;
  if (arguments.empty()) return ended;
  const SpawnSettings settings(log);
  std::vector<std::string> texts = arguments;
  std::vector<char*> list;
  for (std::string& text : texts) list.push_back(text.data());
  list.push_back(nullptr);
  const Clock::time_point begun = Clock::now();
  pid_t child = 0;
  if (posix_spawn(&child, list[0], settings.actions(), settings.attributes(), list.data(), environ) != 0)
    return ended;
  auto pause = std::chrono::milliseconds(1);
  int status = 0;
  for (;;) {
    const pid_t reaped = waitpid(child, &status, WNOHANG);
    ended.seconds = std::chrono::duration<double>(Clock::now() - begun).count();
    if (reaped == child) break;
    if (reaped < 0 && errno != EINTR) return ended;
    if (ended.seconds > limit_s && !ended.out_of_time) {
      ended.out_of_time = true;
      kill(-child, SIGKILL);
    }
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, std::chrono::milliseconds(50));
  }
  if (WIFEXITED(status) && !ended.out_of_time) ended.status = WEXITSTATUS(status);
  return ended;
}

}  // namespace secular::blind
