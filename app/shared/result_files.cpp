#include "app/shared/result_files.hpp"

#include <filesystem>
#include <system_error>

#include "input/input_error.hpp"
#include "report/whole_file.hpp"

namespace secular::app {

void write_result_files(const std::string& folder, const std::vector<std::pair<std::string, std::string>>& files) {
  const std::filesystem::path path(folder);
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw InputError(folder, "", "cannot be made a folder", "name a folder that can be written");
  for (const auto& [name, content] : files) report::write_whole_file(path / name, content);
}

}  // namespace secular::app
