#include "app/shared/unknown_word.hpp"

#include <fmt/format.h>

#include <optional>
#include <vector>

#include "input/nearest_word.hpp"

namespace secular::app {
namespace {

// The command that was chosen, and of its subcommands.
const CLI::App& innermost(const CLI::App& program) {
  const CLI::App* app = &program;
  for (std::vector<CLI::App*> below = app->get_subcommands(); !below.empty(); below = app->get_subcommands())
    app = below.front();
  return *app;
}

std::vector<std::string> options_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::vector<std::string> commands_of(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* below : program.get_subcommands({})) names.push_back(below->get_name());
  return names;
}

std::string unknown(const CLI::App& command, const std::string& kind, const std::string& word,
                    const std::vector<std::string>& known) {
  const std::optional<std::string> meant = nearest_word(word, known);
  return fmt::format("{} is no {} of `{}`; {}", word, kind, full_name(command),
                     meant           ? "did you mean " + *meant + "?"
                     : known.empty() ? "it has none"
                                     : "`" + full_name(command) + " --help` lists them");
}

}  // namespace

std::string full_name(const CLI::App& command) {
  std::string name = command.get_name();
  for (const CLI::App* app = command.get_parent(); app != nullptr; app = app->get_parent())
    name = app->get_name() + " " + name;
  return name;
}

std::string no_such_command(const CLI::App& above, const std::string& word) {
  return unknown(above, "command", word, commands_of(above));
}

std::string unknown_word(const CLI::App& program) {
  const CLI::App& command = innermost(program);
  const bool needs_command = !command.get_subcommands({}).empty();
  for (const std::string& given : command.remaining()) {
    const bool is_option = given.size() > 1 && given.front() == '-' && given != "--";
    if (!is_option && !needs_command) continue;
    const std::string word = given.substr(0, given.find('='));
    return is_option ? unknown(command, "option", word, options_of(command)) : no_such_command(command, word);
  }
  return {};
}

}  // namespace secular::app
