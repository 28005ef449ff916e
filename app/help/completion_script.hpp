#pragma once

#include <string>
#include <vector>

#include "app/help/described_command.hpp"

namespace secular::app {

enum class Shell { bash, zsh, fish };

/// What `shell` reads to complete the command line of `program`: commands, options, values where only some can be
/// given, and the names in `models` where a model is asked for; files otherwise.
std::string completion_script(const DescribedCommand& program, Shell shell, const std::vector<std::string>& models);

}  // namespace secular::app
