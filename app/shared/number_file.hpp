#pragma once

#include <map>
#include <string>

namespace secular::app {

/// A JSON object of symbol to number. Throws InputError naming the file, the place and the key.
std::map<std::string, double> read_numbers(const std::string& path);

}  // namespace secular::app
