#include "app/shared/unknown_word.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace secular::app {
namespace {

std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

std::string lower_case(std::string word) {
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return word;
}

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

std::optional<std::string> nearest_word(const std::string& word, const std::vector<std::string>& known) {
  std::optional<std::string> nearest;
  std::size_t least = word.size() / 3 + 1;
  for (const std::string& candidate : known)
    if (const std::size_t d = distance(lower_case(word), lower_case(candidate)); d < least) {
      least = d;
      nearest = candidate;
    }
  return nearest;
}

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
