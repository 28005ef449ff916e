#include "codegen/runtime/process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <system_error>

namespace secular {
namespace {

namespace fs = std::filesystem;

bool is_executable(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error) && access(path.c_str(), X_OK) == 0;
}

class FileActions {
 public:
  FileActions() { posix_spawn_file_actions_init(&actions_); }
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  void open(int descriptor, const char* path, int flags) {
    posix_spawn_file_actions_addopen(&actions_, descriptor, path, flags, 0);
  }
  void duplicate(int from, int to) { posix_spawn_file_actions_adddup2(&actions_, from, to); }
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

// This process's environment with messages in English.
std::vector<std::string> environment() {
  std::vector<std::string> entries;
  for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry)
    if (std::string(*entry).rfind("LC_ALL=", 0) != 0) entries.emplace_back(*entry);
  entries.emplace_back("LC_ALL=C");
  return entries;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
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

ProcessResult run_process(const std::vector<std::string>& arguments) {
  constexpr std::size_t longest_output = 1 << 16;
  ProcessResult result;
  int pipe_ends[2];
  if (arguments.empty() || pipe2(pipe_ends, O_CLOEXEC) != 0) return result;
  FileActions actions;
  actions.open(STDIN_FILENO, "/dev/null", O_RDONLY);
  actions.duplicate(pipe_ends[1], STDOUT_FILENO);
  actions.duplicate(pipe_ends[1], STDERR_FILENO);
  std::vector<std::string> texts = arguments, variables = environment();
  const std::vector<char*> argument_list = pointers(texts), variable_list = pointers(variables);
  pid_t child = 0;
  const int refused =
      posix_spawn(&child, argument_list[0], actions.get(), nullptr, argument_list.data(), variable_list.data());
  close(pipe_ends[1]);
  char buffer[4096];
  for (ssize_t size = 0; refused == 0;) {
    size = ::read(pipe_ends[0], buffer, sizeof buffer);
    if (size == 0 || (size < 0 && errno != EINTR)) break;
    // The rest of a very long output is read and dropped: the process must be able to end.
    if (size > 0 && result.output.size() < longest_output)
      result.output.append(buffer, static_cast<std::size_t>(size));
  }
  close(pipe_ends[0]);
  if (refused != 0) return result;
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return result;
  if (WIFEXITED(status)) result.status = WEXITSTATUS(status);
  return result;
}

}  // namespace secular
