#pragma once

#include <CLI/App.hpp>
#include <string>

namespace secular::app {

/// The command as it was given, for a report to say how it is made again: program and subcommands, positional
/// arguments, then every other option that was given, quoted for a shell. What changes no result (--json,
/// --threads, --timings, --force, --quiet) is left out.
std::string command_line_of(const CLI::App& command);

}  // namespace secular::app
