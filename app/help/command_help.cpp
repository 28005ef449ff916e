#include <fmt/format.h>

#include <CLI/App.hpp>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/help/completion_script.hpp"
#include "app/help/described_command.hpp"
#include "app/help/manual_page.hpp"
#include "app/shared/commands.hpp"
#include "app/shared/word_choice.hpp"
#include "app/shared/unknown_word.hpp"
#include "input/input_error.hpp"
#include "jobs/shared/shipped_models.hpp"

namespace secular::app {
namespace {

// The command that `words` lead to.
const CLI::App& command_of(const CLI::App& program, const std::vector<std::string>& words) {
  const CLI::App* command = &program;
  for (const std::string& word : words) {
    const CLI::App* found = nullptr;
    for (const CLI::App* below : command->get_subcommands({}))
      if (below->get_name() == word) found = below;
    if (found == nullptr) throw InputError({}, {}, no_such_command(*command, word));
    command = found;
  }
  return *command;
}

}  // namespace

void add_help_command(CLI::App* command, Action& chosen) {
  struct Options {
    std::vector<std::string> words;
    std::string shell;
    bool manual = false;
  };
  static const std::map<std::string, Shell> shells = {
      {"bash", Shell::bash}, {"fish", Shell::fish}, {"zsh", Shell::zsh}};
  auto options = std::make_shared<Options>();
  CLI::Option* words =
      command->add_option("COMMAND", options->words, "the command to tell about; without it all are listed");
  CLI::Option* manual =
      command->add_flag("--manual", options->manual, "print the page of the manual: man -l FILE shows it");
  command->add_option("--completion", options->shell, "print what this shell reads to complete command lines")
      ->check(one_of({"bash", "fish", "zsh"}))
      ->excludes(manual)
      ->excludes(words);
  manual->excludes(words);
  command->footer(
      "Example: secular help blind generate\n"
      "Example: secular help --completion bash > ~/.local/share/bash-completion/completions/secular");
  command->callback([command, options, &chosen] {
    chosen = [command, options] {
      const CLI::App& program = *command->get_parent();
      if (options->manual)
        fmt::print("{}", manual_page(described(program), program.version()));
      else if (!options->shell.empty())
        fmt::print("{}", completion_script(described(program), shells.at(options->shell), shipped_models()));
      else {
        const CLI::App& asked = command_of(program, options->words);
        // Not help() of the program, which tells about the command that runs.
        fmt::print("{}", program.get_formatter()->make_help(&asked, full_name(asked), CLI::AppFormatMode::Normal));
      }
      return 0;
    };
  });
}

}  // namespace secular::app
