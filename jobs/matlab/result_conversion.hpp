#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace secular {

/// The job `to-matlab`: for every JSON file of a folder of results the MAT file beside it, by name and content
/// (mat_of_json), the variable being called as the file: estimate.json becomes `estimate` in estimate.mat. In the
/// order of the names. Throws InputError where there is no such folder or no such file.
std::vector<std::pair<std::string, std::string>> mat_files_of(const std::filesystem::path& folder);

}  // namespace secular
