#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "measure/data/campaign.hpp"
#include "measure/disturbances/disturbance.hpp"

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

/// "secular: note: ..." on standard error, unless that is to be quiet: how a model was loaded.
void print_note(const std::string& text);

/// One line for each kind, the worst first, under a heading; nothing where nothing was found. `records`: that were
/// looked at.
void print_disturbances(const std::vector<Disturbance>& found, const Campaign& campaign, std::size_t records);

}  // namespace secular::app
