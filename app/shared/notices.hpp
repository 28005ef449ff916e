#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace secular::app {

/// --version of the program, and --quiet of it and of all its commands: no progress and no warnings on standard
/// error. Errors, what was asked for and standard output stay.
void add_common_flags(CLI::App& program);

/// Whether --quiet was given.
bool is_quiet();

/// Whether what is printed on standard output goes elsewhere than to a terminal: numbers are plain ASCII then
/// (report::PlainNumbers).
bool prints_for_programs();

/// With control characters as \xNN: a terminal would obey them.
std::string visible(const std::string& text);

/// "warning: ..." on standard error, unless that is to be quiet.
void print_warning(const std::string& text);
void print_warnings(const std::vector<std::string>& texts);

}  // namespace secular::app
