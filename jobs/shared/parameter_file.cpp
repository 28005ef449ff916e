#include "jobs/shared/parameter_file.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <system_error>

#include "input/input_error.hpp"
#include "jobs/shared/number_file.hpp"
#include "jobs/shared/shipped_models.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

std::string file_named(const std::string& path) {
  std::error_code unreadable;
  if (fs::is_regular_file(path, unreadable) || path.empty() || fs::path(path).is_absolute()) return path;
  for (const fs::path& folder : model_folders()) {
    const fs::path shipped = folder / (path + ".json");
    if (fs::is_regular_file(shipped, unreadable)) return shipped.string();
  }
  return path;
}

[[noreturn]] void refuse(const std::string& path, const std::string& place, const std::string& fault,
                         const std::string& expected = "an estimate.json of `secular identify` was expected") {
  throw InputError(path, place, fault, expected);
}

/// Relative, of a covariance in a file: what its digits leave of symmetry and of a correlation of one.
constexpr double of_digits = 1e-6;

// Numbers that no covariance holds. Those that are not known are left to who needs them.
void check_covariance(const NamedCovariance& covariance, const std::string& path, const std::string& place) {
  const Eigen::MatrixXd& m = covariance.matrix;
  for (Eigen::Index r = 0; r < m.rows(); ++r) {
    const std::string& name = covariance.names[static_cast<std::size_t>(r)];
    const std::string row = place + ", row " + std::to_string(r + 1) + " (" + name + ")";
    if (std::count(covariance.names.begin(), covariance.names.end(), name) > 1)
      refuse(path, place, "names " + name + " twice");
    if (m(r, r) < 0) refuse(path, row, "has a negative variance");
    for (Eigen::Index c = 0; c < r; ++c) {
      const double largest = std::sqrt(m(r, r)) * std::sqrt(m(c, c));
      const std::string& other = covariance.names[static_cast<std::size_t>(c)];
      if (std::abs(m(r, c) - m(c, r)) > of_digits * largest)
        refuse(path, row, "differs from its column at " + other, "a covariance is symmetric");
      if (std::abs(m(r, c)) > (1 + of_digits) * largest)
        refuse(path, row, "has a correlation beyond one with " + other);
    }
  }
}

// A list of names and a square matrix of as many numbers a side; null stands for a number that is not known.
NamedCovariance read_covariance(const nlohmann::json& entry, const std::string& path, const std::string& place) {
  const auto is_list = [&](const char* key) {
    return entry.is_object() && entry.contains(key) && entry[key].is_array();
  };
  if (!is_list("names") || !is_list("matrix") || entry["matrix"].size() != entry["names"].size())
    refuse(path, place, "has no names and as many rows of a matrix");
  NamedCovariance result;
  for (const nlohmann::json& name : entry["names"]) {
    if (!name.is_string()) refuse(path, place, "has a name that is no text");
    result.names.push_back(name.get<std::string>());
  }
  const auto count = static_cast<Eigen::Index>(result.names.size());
  result.matrix.resize(count, count);
  for (Eigen::Index r = 0; r < count; ++r) {
    const nlohmann::json& row = entry["matrix"][static_cast<std::size_t>(r)];
    if (!row.is_array() || static_cast<Eigen::Index>(row.size()) != count)
      refuse(path, place + ", row " + std::to_string(r + 1), "has not as many numbers as there are names");
    for (Eigen::Index c = 0; c < count; ++c) {
      const nlohmann::json& number = row[static_cast<std::size_t>(c)];
      if (!number.is_number() && !number.is_null())
        refuse(path, place + ", row " + std::to_string(r + 1), "has an entry that is no number");
      result.matrix(r, c) = number.is_null() ? std::numeric_limits<double>::quiet_NaN() : number.get<double>();
    }
  }
  check_covariance(result, path, place);
  return result;
}

void read_representative(const nlohmann::json& entry, const std::string& path, GivenParameters& given) {
  const std::string place = "key representative";
  if (!entry.is_object() || !entry.contains("values") || !entry["values"].is_object() ||
      !entry.contains("steady_motions_of") || !entry["steady_motions_of"].is_array())
    refuse(path, place, "has no values and steady_motions_of");
  for (const auto& [name, value] : entry["values"].items()) {
    if (!value.is_number() || !std::isfinite(value.get<double>()))
      refuse(path, place, "has a value that is not a number", "a number was expected for " + name);
    given.representative[name] = value.get<double>();
  }
  if (entry.contains("covariance"))
    given.representative_covariance = read_covariance(entry["covariance"], path, place + ", covariance");
  for (const nlohmann::json& name : entry["steady_motions_of"]) {
    if (!name.is_string()) refuse(path, place, "has a case that is no name");
    given.identified_cases.insert(name.get<std::string>());
  }
}

void read_lump_units(const nlohmann::json& lumps, GivenParameters& given) {
  const auto is_text = [](const nlohmann::json& lump, const char* key) {
    return lump.is_object() && lump.contains(key) && lump[key].is_string();
  };
  for (const nlohmann::json& lump : lumps)
    if (is_text(lump, "case") && is_text(lump, "name") && is_text(lump, "unit"))
      given.lump_units[lump["case"].get<std::string>()][lump["name"].get<std::string>()] = lump["unit"];
}

}  // namespace

GivenParameters read_parameter_file(const std::string& name) {
  const std::string path = file_named(name);
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw InputError(path, "", "cannot be opened for reading", "a JSON file of symbol to number was expected");
  return parameters_of({std::istreambuf_iterator<char>(stream), {}}, path);
}

GivenParameters parameters_of(const std::string& text, const std::string& path) {
  const nlohmann::json document = nlohmann::json::parse(text, nullptr, false);
  GivenParameters given;
  if (!document.is_object() || !document.contains("estimates")) {
    given.values = numbers_of(text, path);
    return given;
  }
  const nlohmann::json& estimates = document["estimates"];
  if (!estimates.is_array()) refuse(path, "key estimates", "is not a list");
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    const nlohmann::json& entry = estimates[i];
    const std::string place = "estimates, entry " + std::to_string(i + 1);
    if (!entry.is_object() || !entry.contains("name") || !entry["name"].is_string() || !entry.contains("value"))
      refuse(path, place, "has no name and value");
    if (entry["value"].is_null()) continue;
    if (!entry["value"].is_number() || !std::isfinite(entry["value"].get<double>()))
      refuse(path, place, "has a value that is not a number", "a number, or null, was expected");
    const auto symbol = entry["name"].get<std::string>();
    given.values[symbol] = entry["value"].get<double>();
    if (entry.contains("sd") && entry["sd"].is_number() && entry["sd"].get<double>() > 0)
      given.sd[symbol] = entry["sd"].get<double>();
    if (entry.contains("unit") && entry["unit"].is_string()) given.units[symbol] = entry["unit"];
    if (entry.contains("doubtful") && entry["doubtful"] == true) given.doubtful.insert(symbol);
  }
  if (document.contains("coordinate_unit") && document["coordinate_unit"].is_string())
    given.coordinate_unit = document["coordinate_unit"];
  if (document.contains("covariance"))
    given.covariance = read_covariance(document["covariance"], path, "key covariance");
  if (document.contains("lumps")) read_lump_units(document["lumps"], given);
  if (document.contains("representative")) read_representative(document["representative"], path, given);
  return given;
}

}  // namespace secular
