#include "report/gnuplot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

#include "input/child_process.hpp"

namespace secular::report {
namespace {

std::string first_line_with_text(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n^");
  if (begin == std::string_view::npos) return "no message";
  return std::string(text.substr(begin, std::min<std::size_t>(text.find('\n', begin) - begin, 200)));
}

}  // namespace

GnuplotOutput run_gnuplot(std::string_view script) {
  const char* const chosen = std::getenv("SECULAR_GNUPLOT");
  const std::string program = chosen != nullptr && *chosen != '\0' ? chosen : "gnuplot";

  // Without what would change gnuplot's reading or writing.
  const ProcessEnd ended = run_process({.arguments = {program, "-d"},
                                        .input = script,
                                        .hidden = {"GNU", "LC_", "LANG"},
                                        .settings = {"LC_ALL=C"},
                                        .errors_apart = true});
  if (ended.refused == ENOENT)
    return {"", fmt::format("the program '{}' is not installed (Debian: apt-get install gnuplot-nox)", program)};
  if (ended.refused != 0)
    return {"", fmt::format("'{}' cannot be started: {}", program, std::strerror(ended.refused))};
  if (ended.status != 0) return {"", fmt::format("'{}' failed: {}", program, first_line_with_text(ended.errors))};
  if (ended.output.empty())
    return {"", fmt::format("'{}' drew nothing: {}", program, first_line_with_text(ended.errors))};
  return {ended.output, ""};
}

}  // namespace secular::report
