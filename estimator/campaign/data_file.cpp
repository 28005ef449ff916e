#include "estimator/campaign/data_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "estimator/campaign/mat_file.hpp"
#include "input/input_error.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

std::string lower_extension(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension;
}

// A universal file begins with the delimiter of its first data set: -1 in columns 5 and 6, nothing else.
bool begins_like_uff(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::array<char, 8> line{};
  stream.getline(line.data(), line.size());
  return stream && std::string_view(line.data()).starts_with("    -1");
}

// Decides by name and content: a MAT file says in its first bytes what it is.
bool is_mat(const fs::path& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored))
    throw InputError(path.string(), "", "does not exist", "a CSV or MAT v5 file was expected");
  if (!fs::is_regular_file(path, ignored))
    throw InputError(path.string(), "", "is not a regular file", "a CSV or MAT v5 file was expected");
  const std::string extension = lower_extension(path);
  constexpr std::array uff_extensions = {".uff", ".unv", ".uf", ".bunv"};
  if (std::find(uff_extensions.begin(), uff_extensions.end(), extension) != uff_extensions.end() ||
      begins_like_uff(path))
    throw InputError(path.string(), "", "is a UFF file, which is not supported yet", "export it as CSV or MAT v5");
  for (const char* other : {".h5", ".hdf5"})
    if (extension == other)
      throw InputError(path.string(), "", "is an HDF5 file, which is not supported yet",
                       "export it as CSV or MAT v5");
  return extension == ".mat" || looks_like_mat(path);
}

DataFile read_mat_file(const fs::path& path, const std::vector<std::string>& wanted) {
  DataFile data{path.string(), "MAT v5", {}, {"element", 1}};
  for (MatVariable& variable : read_mat(path, wanted))
    data.variables.push_back({std::move(variable.path), std::move(variable.shape), std::move(variable.type),
                              std::move(variable.values), std::move(variable.fault)});
  return data;
}

DataFile read_csv_file(const fs::path& path, const std::vector<std::string>& wanted, MissingNumbers missing) {
  NumberTable table = read_csv(path, wanted, missing);
  DataFile data{path.string(), "CSV", {}, {"line", table.first_line}};
  for (std::size_t c = 0; c < table.names.size(); ++c) {
    std::vector<double>& values = table.columns[c];
    const bool any = std::any_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
    data.variables.push_back(
        {table.names[c], {values.size()}, any ? "number" : "text", {}, any ? "" : "holds no number"});
    if (any) data.variables.back().values = std::move(values);
  }
  return data;
}

}  // namespace

std::string DataFile::names() const {
  std::string list;
  std::size_t listed = 0;
  for (const DataVariable& variable : variables) {
    if (++listed > 20) return list + fmt::format(" and {} more", variables.size() - 20);
    list += (list.empty() ? "" : ", ") + variable.name;
  }
  return list;
}

const DataVariable& DataFile::vector(const std::string& name) const {
  const auto found =
      std::find_if(variables.begin(), variables.end(), [&](const DataVariable& v) { return v.name == name; });
  if (found == variables.end())
    throw InputError(file, "", "has no numeric variable '" + name + "'",
                     variables.empty() ? "it holds no numeric variables" : "its variables are " + names());
  if (!found->fault.empty())
    throw InputError(file, "variable " + name, found->fault, "a row or a column of real numbers was expected");
  return *found;
}

DataFile read_data_file(const fs::path& path, const std::vector<std::string>& wanted, MissingNumbers missing) {
  if (!is_mat(path)) return read_csv_file(path, wanted, missing);
  DataFile data = read_mat_file(path, wanted);
  if (missing == MissingNumbers::keep_as_nan) return data;
  for (const DataVariable& variable : data.variables)
    for (std::size_t i = 0; i < variable.values.size(); ++i)
      if (!std::isfinite(variable.values[i]))
        throw InputError(data.file, fmt::format("variable {}, {}", variable.name, data.place.of(i)),
                         "is not a finite number", "cut the record around missing samples");
  return data;
}

std::vector<std::string> data_variable_names(const fs::path& path) {
  if (!is_mat(path)) return read_csv_names(path);
  std::vector<std::string> names;
  for (const MatVariable& variable : read_mat(path)) names.push_back(variable.path);
  return names;
}

}  // namespace secular
