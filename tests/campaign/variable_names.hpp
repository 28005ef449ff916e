#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "measure/formats/data_file.hpp"

namespace secular {

inline std::vector<std::string> data_variable_names(const std::filesystem::path& path) {
  std::vector<std::string> names;
  for (const DataVariable& variable : describe_data_file(path)) names.push_back(variable.name);
  return names;
}

}  // namespace secular
