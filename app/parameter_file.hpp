#pragma once

#include <map>
#include <string>

namespace secular::app {

/// Values of symbols from an estimate.json of `identify` or a plain JSON object of symbol to number; `path` is a
/// file, or the name of a shipped one ("predictions/table_5_4"). Of an estimate, symbols that the data could not
/// identify are left out. Throws InputError naming the file, the place and what was expected.
std::map<std::string, double> read_parameter_file(const std::string& path);

/// Standard deviations of the values of an estimate.json; empty for a plain object. Call read_parameter_file first:
/// it is the one that complains.
std::map<std::string, double> read_parameter_errors(const std::string& path);

}  // namespace secular::app
