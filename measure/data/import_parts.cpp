#include "measure/data/import_parts.hpp"

#include <fmt/format.h>

#include <cmath>

#include "input/input_error.hpp"

namespace secular {

std::optional<double> of_file(const std::vector<double>& values, std::size_t file, std::size_t files,
                              const char* option) {
  if (values.empty()) return std::nullopt;
  if (values.size() != 1 && values.size() != files)
    throw InputError(option, "", fmt::format("has {} values for {} records", values.size(), files),
                     "one for all records or one for each was expected");
  const double value = values.size() == 1 ? values.front() : values[file];
  if (!std::isfinite(value) || value <= 0)
    throw InputError(option, "", fmt::format("is {}", value), "a positive number was expected");
  return value;
}

std::string record_file(const std::filesystem::path& source, std::set<std::string>& taken) {
  std::string stem;
  for (const char c : source.stem().string()) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
                       c == '-' || c == '.';
    stem += plain ? c : '_';
  }
  // The writer puts .csv in place of an extension: a point of the name must not look like one.
  std::string name = "records/" + stem + ".csv";
  for (int copy = 2; !taken.insert(name).second; ++copy) name = fmt::format("records/{}-{}.csv", stem, copy);
  return name;
}

}  // namespace secular
