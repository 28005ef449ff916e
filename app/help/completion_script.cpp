#include "app/help/completion_script.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>

namespace secular::app {
namespace {

// One word of the shell's language, whatever it holds.
std::string quoted(const std::string& text, Shell shell) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'')
      result += shell == Shell::fish ? "\\'" : "'\\''";
    else if (c == '\\' && shell == Shell::fish)
      result += "\\\\";
    else
      result += c;
  }
  return result + "'";
}

// All commands, `program` the first, each with the words that lead to it.
void each(const DescribedCommand& command, const std::string& words,
          const std::function<void(const DescribedCommand&, const std::string&)>& then) {
  then(command, words);
  for (const DescribedCommand& below : command.commands) each(below, words + " " + below.name, then);
}

struct Lists {
  std::vector<std::string> commands, models;
};

// What follows an option or a positional argument, where it can be listed.
std::vector<std::string> listed_values(const DescribedOption& option, const Lists& lists) {
  if (option.takes_command) return lists.commands;
  return option.takes_model ? lists.models : option.choices;
}

// Both shells look up words by the command that the line has come to: `next` holds commands, `dashed` options,
// `valued` those that a value follows, `listed` values by command and option, or by command alone for positional
// arguments.
std::string bash_script(const DescribedCommand& program, const Lists& lists) {
  std::string tables;
  each(program, program.name, [&](const DescribedCommand& command, const std::string& words) {
    std::vector<std::string> dashed, next, valued;
    for (const DescribedCommand& below : command.commands) next.push_back(below.name);
    for (const DescribedOption& option : command.options) {
      if (!option.positional) dashed.insert(dashed.end(), option.names.begin(), option.names.end());
      if (!option.positional && !option.value.empty())
        valued.insert(valued.end(), option.names.begin(), option.names.end());
      if (const std::vector<std::string> values = listed_values(option, lists); !values.empty())
        for (const std::string& name : option.names)
          tables +=
              fmt::format("  listed[{}]={}\n", quoted(option.positional ? words : words + " " + name, Shell::bash),
                          quoted(fmt::format("{}", fmt::join(values, " ")), Shell::bash));
    }
    const std::string key = quoted(words, Shell::bash);
    if (!next.empty()) tables += fmt::format("  next[{}]='{}'\n", key, fmt::join(next, " "));
    tables += fmt::format("  dashed[{}]='{}'\n  valued[{}]='{}'\n", key, fmt::join(dashed, " "), key,
                          fmt::join(valued, " "));
  });
  return "# Completion of " + program.name + " for bash.\n_" + program.name + R"(() {
  COMPREPLY=()
  local -A next dashed valued listed
)" + tables +
         R"(  local at=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=)" + program.name +
         R"( word
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    [[ " ${next[$command]} " == *" $word "* ]] && command+=" $word"
  done
  if [[ $before == -* && -n ${listed[$command $before]} ]]; then
    COMPREPLY=($(compgen -W "${listed[$command $before]}" -- "$at"))
  elif [[ $at == -* ]]; then
    COMPREPLY=($(compgen -W "${dashed[$command]}" -- "$at"))
  elif [[ -n ${next[$command]} ]]; then
    COMPREPLY=($(compgen -W "${next[$command]}" -- "$at"))
  else
    [[ " ${valued[$command]} " == *" $before "* ]] || COMPREPLY=($(compgen -W "${listed[$command]}" -- "$at"))
    compopt -o bashdefault -o default
  fi
}
complete -F _)" +
         program.name + " " + program.name + "\n";
}

// A name with its purpose, as _describe takes it: a colon of the name has a backslash before it.
std::string zsh_entry(const std::string& name, const std::string& purpose) {
  return " " + quoted(name + ":" + purpose, Shell::zsh);
}

std::string zsh_script(const DescribedCommand& program, const Lists& lists) {
  std::string steps, cases;
  each(program, program.name, [&](const DescribedCommand& command, const std::string& words) {
    std::string next, dashed, listed;
    for (const DescribedCommand& below : command.commands) {
      next += zsh_entry(below.name, below.purpose);
      steps += fmt::format("    ({}) command+=\" $word\" ;;\n", quoted(words + " " + below.name, Shell::zsh));
    }
    for (const DescribedOption& option : command.options) {
      if (!option.positional)
        for (const std::string& name : option.names) dashed += zsh_entry(name, option.purpose);
      if (const std::vector<std::string> values = listed_values(option, lists); !values.empty())
        for (const std::string& name : option.names)
          listed +=
              fmt::format("      ({}) listed=({}) ;;\n", option.positional ? "''" : name, fmt::join(values, " "));
    }
    // A value of the option before, else of a positional argument.
    cases += fmt::format("  ({})\n    next=({})\n    dashed=({})\n    case \"$option\" in\n{}    esac\n    ;;\n",
                         quoted(words, Shell::zsh), next, dashed, listed);
  });
  return "#compdef " + program.name + "\n# Completion of " + program.name + R"( for zsh.
local -a next dashed listed
local at=${words[CURRENT]} option= command=)" +
         program.name + R"( word
[[ ${words[CURRENT-1]} == -* ]] && option=${words[CURRENT-1]}
for word in ${words[2,CURRENT-1]}; do
  case "$command $word" in
)" + steps +
         R"(  esac
done
case "$command" in
)" + cases +
         R"(esac
if [[ $at == -* ]]; then
  _describe option dashed
elif (( $#next )); then
  _describe command next
else
  (( $#listed )) && compadd -a listed
  [[ -n $option ]] && (( $#listed )) || _files
fi
)";
}

std::string fish_script(const DescribedCommand& program, const Lists& lists) {
  std::string lines = "# Completion of " + program.name + " for fish.\n";
  each(program, program.name, [&](const DescribedCommand& command, const std::string& words) {
    std::string condition, names;
    for (std::size_t at = words.find(' '); at != std::string::npos;) {
      const std::size_t end = words.find(' ', at + 1);
      condition +=
          (condition.empty() ? "" : "; and ") +
          ("__fish_seen_subcommand_from " + words.substr(at + 1, end == std::string::npos ? end : end - at - 1));
      at = end;
    }
    for (const DescribedCommand& below : command.commands) names += " " + below.name;
    const std::string start =
        "complete -c " + program.name + (condition.empty() ? "" : " -n " + quoted(condition, Shell::fish));
    const std::string none_yet =
        (condition.empty() ? "" : condition + "; and ") + "not __fish_seen_subcommand_from" + names;
    for (const DescribedCommand& below : command.commands)
      lines += fmt::format("complete -c {} -f -n {} -a {} -d {}\n", program.name, quoted(none_yet, Shell::fish),
                           below.name, quoted(below.purpose, Shell::fish));
    for (const DescribedOption& option : command.options) {
      std::string line = start;
      if (!option.positional)
        for (const std::string& name : option.names)
          line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      const std::vector<std::string> values = listed_values(option, lists);
      if (option.positional && values.empty()) continue;  // files, as everywhere
      if (!option.value.empty() && !option.positional) line += " -r";
      if (!values.empty())
        line += (option.takes_model ? " -a " : " -f -a ") +
                quoted(fmt::format("{}", fmt::join(values, " ")), Shell::fish);
      lines += line + " -d " + quoted(option.purpose, Shell::fish) + "\n";
    }
  });
  return lines;
}

}  // namespace

std::string completion_script(const DescribedCommand& program, Shell shell,
                              const std::vector<std::string>& models) {
  Lists lists{{}, models};
  for (const DescribedCommand& command : program.commands) lists.commands.push_back(command.name);
  switch (shell) {
    case Shell::bash:
      return bash_script(program, lists);
    case Shell::zsh:
      return zsh_script(program, lists);
    case Shell::fish:
      break;
  }
  return fish_script(program, lists);
}

}  // namespace secular::app
