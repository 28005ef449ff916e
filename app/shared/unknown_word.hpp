#pragma once

#include <CLI/App.hpp>
#include <string>

namespace secular::app {

/// As it is typed, with all commands above it.
std::string full_name(const CLI::App& command);

/// That `word` is no command below `above`, one line with the command that may have been meant.
std::string no_such_command(const CLI::App& above, const std::string& word);

/// After parsing has failed: what it says of the first word that no command of `program` knows, one line with the
/// command or option that may have been meant; empty where every word is known.
std::string unknown_word(const CLI::App& program);

}  // namespace secular::app
