#include "app/shared/command_line.hpp"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#define SECULAR_INSTANCE template
#include "cmake/precompiled/options.inc"
#undef SECULAR_INSTANCE

namespace secular::app {
namespace {

constexpr std::string_view without_effect[] = {"--json", "--threads", "--timings", "--force", "--quiet"};

std::string quoted(const std::string& text) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./:=,+-@%^";
  if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) return text;
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "'\\''" : std::string(1, c);
  return result + "'";
}

void add(const CLI::Option& option, std::string& line) {
  if (option.get_expected_max() == 0) {  // a flag
    line += " " + option.get_name();
    return;
  }
  const auto count = static_cast<int>(option.results().size());
  const bool together = option.get_allow_extra_args() || option.get_items_expected_max() == count;
  for (int i = 0; i < count; ++i) {
    if (!option.get_positional() && (i == 0 || !together)) line += " " + option.get_name();
    line += " " + quoted(option.results()[static_cast<std::size_t>(i)]);
  }
}

}  // namespace

std::string command_line_of(const CLI::App& command) {
  std::string line;
  for (const CLI::App* app = &command; app != nullptr; app = app->get_parent())
    line = app->get_name() + (line.empty() ? "" : " ") + line;
  for (const bool positional : {true, false})
    for (const CLI::Option* option : command.get_options())
      if (option->count() > 0 && option->get_positional() == positional &&
          std::find(std::begin(without_effect), std::end(without_effect), option->get_name()) ==
              std::end(without_effect))
        add(*option, line);
  return line;
}

}  // namespace secular::app
