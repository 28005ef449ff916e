#pragma once

#include <string>
#include <utility>
#include <vector>

namespace secular::app {

/// Writes files, by name and content, into a folder that is made where it is missing. Throws InputError where it
/// cannot be; each file appears whole or not at all.
void write_result_files(const std::string& folder, const std::vector<std::pair<std::string, std::string>>& files);

}  // namespace secular::app
