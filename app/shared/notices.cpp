#include "app/shared/notices.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "measure/disturbances/disturbance_watch.hpp"
#include "report/html_report.hpp"

namespace secular::app {
namespace {

// Of the process, as standard error is; set while the command line is read.
bool quiet = false;

void add_quiet_flag(CLI::App& command) {
  command.add_flag("--quiet", quiet, "no progress and no warnings on standard error");
  for (CLI::App* below : command.get_subcommands({})) add_quiet_flag(*below);
}

}  // namespace

void add_common_flags(CLI::App& program) {
  program.set_version_flag("--version", report::program_version);
  add_quiet_flag(program);
}

bool is_quiet() {
  return quiet;
}

std::string visible(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    const bool obeyed = (code < 0x20 && c != '\n' && c != '\t') || code == 0x7f;
    result += obeyed ? fmt::format("\\x{:02x}", code) : std::string(1, c);
  }
  return result;
}

bool prints_for_programs() {
  return isatty(STDOUT_FILENO) == 0;
}

void print_warning(const std::string& text) {
  if (!quiet) fmt::print(stderr, "warning: {}\n", visible(text));
}

void print_warnings(const std::vector<std::string>& texts) {
  for (const std::string& text : texts) print_warning(text);
}

void print_note(const std::string& text) {
  if (!quiet) fmt::print(stderr, "secular: note: {}\n", text);
}

void print_disturbances(const std::vector<Disturbance>& found, const Campaign& campaign, std::size_t records) {
  if (found.empty()) return;
  fmt::print("beside the motion\n");
  for (const std::string& line : disturbance_lines(found, campaign, records)) fmt::print("  {}\n", line);
}

}  // namespace secular::app
