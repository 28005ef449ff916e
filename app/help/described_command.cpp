#include "app/help/described_command.hpp"

#include <sstream>

namespace secular::app {
namespace {

// "{short,full}=short", "{up->0,down->1}" and "up|down": what can be given. Other kinds of value (TEXT, INT in
// [0 - 9]) list nothing.
std::vector<std::string> choices_in(const std::string& kind) {
  const std::size_t open = kind.find('{'), close = kind.find('}');
  const bool in_braces = open != std::string::npos && close != std::string::npos;
  if (!in_braces && kind.find('|') == std::string::npos) return {};
  std::istringstream list(in_braces ? kind.substr(open + 1, close - open - 1) : kind);
  std::vector<std::string> choices;
  for (std::string choice; std::getline(list, choice, in_braces ? ',' : '|');)
    choices.push_back(choice.substr(0, choice.find("->")));
  return choices;
}

DescribedOption described(const CLI::Option& option) {
  DescribedOption result;
  result.positional = option.get_positional();
  for (const std::string& name : option.get_lnames()) result.names.push_back("--" + name);
  for (const std::string& name : option.get_snames()) result.names.push_back("-" + name);
  if (result.positional) result.names = {option.get_name()};
  if (option.get_expected_max() != 0)
    result.value = option.get_option_text().empty() ? option.get_type_name() : option.get_option_text();
  result.choices = choices_in(result.value);
  result.purpose = option.get_description();
  result.required = option.get_required();
  result.takes_command = result.positional && option.get_name() == "COMMAND";
  result.takes_model = option.get_name() == "MODEL" || option.get_name() == "--model";
  return result;
}

}  // namespace

DescribedCommand described(const CLI::App& command) {
  DescribedCommand result{command.get_name(), command.get_description(), command.get_footer(), {}, {}};
  for (const CLI::Option* option : command.get_options())
    if (!option->get_group().empty()) result.options.push_back(described(*option));  // others are hidden
  for (const CLI::App* below : command.get_subcommands({}))
    if (!below->get_group().empty()) result.commands.push_back(described(*below));
  return result;
}

}  // namespace secular::app
