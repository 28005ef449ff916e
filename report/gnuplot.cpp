#include "report/gnuplot.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

extern char** environ;

namespace secular::report {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
/// A file without a name. Files instead of pipes: neither side can block the other.
using NamelessFile = std::unique_ptr<std::FILE, CloseFile>;

std::string contents(std::FILE* file) {
  std::string text;
  std::array<char, 1 << 16> buffer{};
  std::rewind(file);
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file))
    text.append(buffer.data(), count);
  return text;
}

std::string first_line_with_text(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n^");
  if (begin == std::string_view::npos) return "no message";
  return std::string(text.substr(begin, std::min<std::size_t>(text.find('\n', begin) - begin, 200)));
}

}  // namespace

GnuplotOutput run_gnuplot(std::string_view script) {
  const char* const chosen = std::getenv("SECULAR_GNUPLOT");
  const std::string program = chosen != nullptr && *chosen != '\0' ? chosen : "gnuplot";

  const NamelessFile input(std::tmpfile()), output(std::tmpfile()), errors(std::tmpfile());
  if (!input || !output || !errors || std::fwrite(script.data(), 1, script.size(), input.get()) != script.size() ||
      std::fflush(input.get()) != 0)
    return {"", fmt::format("no room for temporary files: {}", std::strerror(errno))};
  std::rewind(input.get());

  // The parent's environment without what would change gnuplot's reading or writing.
  std::vector<std::string> settings = {"LC_ALL=C"};
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view setting = *entry;
    const bool changes_output =
        setting.starts_with("GNU") || setting.starts_with("LC_") || setting.starts_with("LANG");
    if (!changes_output) settings.emplace_back(setting);
  }
  std::vector<char*> environment;
  for (std::string& setting : settings) environment.push_back(setting.data());
  environment.push_back(nullptr);

  std::string name = program, no_startup_files = "-d";
  std::array<char*, 3> arguments = {name.data(), no_startup_files.data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ::fileno(input.get()), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, ::fileno(output.get()), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, ::fileno(errors.get()), STDERR_FILENO);
  pid_t child = 0;
  const int spawned =
      ::posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments.data(), environment.data());
  posix_spawn_file_actions_destroy(&actions);
  if (spawned == ENOENT)
    return {"", fmt::format("the program '{}' is not installed (Debian: apt-get install gnuplot-nox)", program)};
  if (spawned != 0) return {"", fmt::format("'{}' cannot be started: {}", program, std::strerror(spawned))};

  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return {"", fmt::format("waiting for '{}' failed: {}", program, std::strerror(errno))};
  const std::string complaints = contents(errors.get());
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    return {"", fmt::format("'{}' failed: {}", program, first_line_with_text(complaints))};
  GnuplotOutput result{contents(output.get()), ""};
  if (result.svg.empty())
    result.problem = fmt::format("'{}' drew nothing: {}", program, first_line_with_text(complaints));
  return result;
}

}  // namespace secular::report
