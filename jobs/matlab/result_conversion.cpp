#include "jobs/matlab/result_conversion.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>

#include "input/input_error.hpp"
#include "jobs/matlab/mat_text.hpp"

namespace secular {

namespace fs = std::filesystem;

std::vector<std::pair<std::string, std::string>> mat_files_of(const fs::path& folder) {
  const char* const expected = "a folder that identify, diagnose, predict, modal, spectrum or plan wrote (-o)";
  std::error_code error;
  if (!fs::is_directory(folder, error)) throw InputError(folder.string(), "", "is no folder", expected);
  std::vector<fs::path> results;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().extension() == ".json") results.push_back(entry.path());
  if (results.empty()) throw InputError(folder.string(), "", "holds no JSON file", expected);
  std::sort(results.begin(), results.end());
  std::vector<std::pair<std::string, std::string>> files;
  for (const fs::path& result : results) {
    std::ifstream stream(result, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    files.emplace_back(result.stem().string() + ".mat", mat_of_json(text, result.stem().string(), result.string()));
  }
  return files;
}

}  // namespace secular
