#include "input/child_process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <mutex>
#include <system_error>
#include <thread>

#include "input/interruption.hpp"
#include "input/stop_request.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

bool is_executable(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error) && access(path.c_str(), X_OK) == 0;
}

// A file in memory instead of a pipe: neither side can block the other.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(memfd_create("secular", MFD_CLOEXEC)) {}
  ~MemoryFile() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  int descriptor() const { return descriptor_; }
  bool open() const { return descriptor_ >= 0; }

  bool fill(std::string_view text) {
    while (!text.empty()) {
      const ssize_t written = ::write(descriptor_, text.data(), text.size());
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) return false;
      text.remove_prefix(static_cast<std::size_t>(written));
    }
    return lseek(descriptor_, 0, SEEK_SET) == 0;
  }

  std::string contents() const {
    std::string text;
    std::array<char, 1 << 16> buffer{};
    while (true) {
      const ssize_t size = pread(descriptor_, buffer.data(), buffer.size(), static_cast<off_t>(text.size()));
      if (size < 0 && errno == EINTR) continue;
      if (size <= 0) return text;
      text.append(buffer.data(), static_cast<std::size_t>(size));
    }
  }

 private:
  int descriptor_;
};

// Attributes and file actions of posix_spawn, released in any case.
class SpawnSettings {
 public:
  SpawnSettings() {
    posix_spawnattr_init(&attributes_);
    posix_spawn_file_actions_init(&actions_);
  }
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  void own_group() {
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes_, 0);
  }
  void open(int descriptor, const char* path, int flags) {
    posix_spawn_file_actions_addopen(&actions_, descriptor, path, flags, 0666);
  }
  void duplicate(int from, int to) { posix_spawn_file_actions_adddup2(&actions_, from, to); }

  const posix_spawn_file_actions_t* actions() const { return &actions_; }
  const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

std::vector<std::string> environment_of(const ChildProcess& process) {
  std::vector<std::string> entries = process.settings;
  if (Interruption::is_on()) entries.push_back(Interruption::setting_for_children());
  for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
    const std::string_view setting = *entry;
    if (std::none_of(process.hidden.begin(), process.hidden.end(),
                     [&](const std::string& hidden) { return setting.starts_with(hidden); }))
      entries.emplace_back(setting);
  }
  return entries;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

// Started, and known to Interruption where that is on. From posix_spawnp: 0 or an errno value.
class StartedChild {
 public:
  StartedChild(const SpawnSettings& spawn, const std::vector<char*>& arguments,
               const std::vector<char*>& environment) {
    std::unique_lock<std::mutex> lock;
    if (Interruption::is_on()) lock = std::unique_lock(Interruption::instance().guard());
    refused_ = posix_spawnp(&child_, arguments[0], spawn.actions(), spawn.attributes(), arguments.data(),
                            environment.data());
    if (refused_ == 0 && lock) {
      Interruption::instance().add_child(child_);
      known_ = true;
    }
  }
  ~StartedChild() {
    if (!known_) return;
    const std::lock_guard lock(Interruption::instance().guard());
    Interruption::instance().take_out_child(child_);
  }
  StartedChild(const StartedChild&) = delete;
  StartedChild& operator=(const StartedChild&) = delete;

  int refused() const { return refused_; }
  pid_t number() const { return child_; }

 private:
  pid_t child_ = 0;
  int refused_ = 0;
  bool known_ = false;
};

// Seconds of wall time since it was made; while this process was stopped by the terminal it did not run.
class Watch {
 public:
  double seconds() const {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begun_;
    return passed.count() - (Interruption::stopped_s() - stopped_before_);
  }
  bool is_beyond(double limit_s) const {
    if (seconds() <= limit_s) return false;
    // Just after a stop, how long it was is known to who holds the guard.
    std::unique_lock<std::mutex> lock;
    if (Interruption::is_on()) lock = std::unique_lock(Interruption::instance().guard());
    return seconds() > limit_s;
  }

 private:
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  double stopped_before_ = Interruption::stopped_s();
};

// Status of waitpid, or nothing: it cannot be waited for. Throws Stopped.
std::optional<int> wait_for(pid_t child, double limit_s, ProcessEnd& end) {
  int status = 0;
  const std::atomic<bool>* const stop = StopScope::current();
  if (!(limit_s > 0) && !stop) {
    while (waitpid(child, &status, 0) < 0)
      if (errno != EINTR) return std::nullopt;
    return status;
  }
  const Watch watch;
  for (auto pause = std::chrono::milliseconds(1);; pause = std::min(2 * pause, std::chrono::milliseconds(50))) {
    const pid_t reaped = waitpid(child, &status, WNOHANG);
    if (reaped == child) return status;
    if (reaped < 0 && errno != EINTR) return std::nullopt;
    if (limit_s > 0 && !end.out_of_time && watch.is_beyond(limit_s)) {
      end.out_of_time = true;
      kill(-child, SIGKILL);
    }
    if (stop && *stop) {
      kill(-child, SIGKILL);
      waitpid(child, &status, 0);
      throw Stopped{};
    }
    std::this_thread::sleep_for(pause);
  }
}

}  // namespace

std::optional<fs::path> find_program(const std::string& name) {
  if (name.empty()) return std::nullopt;
  if (name.find('/') != std::string::npos)
    return is_executable(name) ? std::optional<fs::path>(name) : std::nullopt;
  const char* const variable = std::getenv("PATH");
  const std::string folders = variable ? variable : "/usr/local/bin:/usr/bin:/bin";
  for (std::size_t begin = 0; begin <= folders.size();) {
    const std::size_t end = std::min(folders.find(':', begin), folders.size());
    const fs::path folder = folders.substr(begin, end - begin);
    // A relative entry would run whatever lies in the current folder.
    if (folder.is_absolute() && is_executable(folder / name)) return folder / name;
    begin = end + 1;
  }
  return std::nullopt;
}

ProcessEnd run_process(const ChildProcess& process) {
  ProcessEnd end;
  const auto refused = [&end](int why) {
    end.refused = why;
    return end;
  };
  if (process.arguments.empty()) return refused(ENOENT);
  MemoryFile input, output, errors;
  if (!input.open() || !output.open() || !errors.open() || !input.fill(process.input)) return refused(errno);
  SpawnSettings spawn;
  if (process.limit_s > 0 || Interruption::is_on() || StopScope::current()) spawn.own_group();
  spawn.duplicate(input.descriptor(), STDIN_FILENO);
  if (process.log.empty())
    spawn.duplicate(output.descriptor(), STDOUT_FILENO);
  else
    spawn.open(STDOUT_FILENO, process.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC);
  spawn.duplicate(process.errors_apart ? errors.descriptor() : STDOUT_FILENO, STDERR_FILENO);
  std::vector<std::string> texts = process.arguments, variables = environment_of(process);
  const std::vector<char*> arguments = pointers(texts), environment = pointers(variables);
  const Watch watch;
  std::optional<int> status;
  int why = 0;
  {
    const StartedChild child(spawn, arguments, environment);
    if (child.refused() != 0) return refused(child.refused());
    status = wait_for(child.number(), process.limit_s, end);
    why = errno;
  }
  end.seconds = watch.seconds();
  if (!status) return refused(why);
  if (WIFEXITED(*status) && !end.out_of_time) end.status = WEXITSTATUS(*status);
  end.output = output.contents();
  end.errors = errors.contents();
  return end;
}

}  // namespace secular
