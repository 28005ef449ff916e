#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace secular::app {

/// An option, a flag or a positional argument, as `--help` has it.
struct DescribedOption {
  std::vector<std::string> names;  ///< with their dashes, long ones first; of a positional argument its name alone
  std::string value;               ///< kind of value (TEXT, UINT:UINT in [1 - 1024]); empty for a flag
  std::vector<std::string> choices;  ///< the only values there are; empty where others are possible
  std::string purpose;
  bool positional = false;
  bool required = false;
  bool takes_command = false;  ///< the name of a command of the program
  bool takes_model = false;    ///< a model file, or the name of a shipped model
};

/// A command with what stands below it.
struct DescribedCommand {
  std::string name, purpose, footer;
  std::vector<DescribedOption> options;
  std::vector<DescribedCommand> commands;
};

/// What `--help` says of `command` and all below it, as values: whatever prints it otherwise (a page of the manual,
/// completions of a shell) has no list of its own.
DescribedCommand described(const CLI::App& command);

}  // namespace secular::app
