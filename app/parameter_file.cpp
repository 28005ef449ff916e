#include "app/parameter_file.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "app/number_file.hpp"
#include "app/shipped_models.hpp"
#include "input/input_error.hpp"

namespace secular::app {
namespace {

namespace fs = std::filesystem;

std::string resolved(const std::string& path) {
  std::error_code unreadable;
  if (fs::is_regular_file(path, unreadable) || path.empty() || fs::path(path).is_absolute()) return path;
  for (const fs::path& folder : model_folders()) {
    const fs::path shipped = folder / (path + ".json");
    if (fs::is_regular_file(shipped, unreadable)) return shipped.string();
  }
  return path;
}

}  // namespace

std::map<std::string, double> read_parameter_file(const std::string& name) {
  const std::string path = resolved(name);
  std::ifstream stream(path, std::ios::binary);
  const nlohmann::json document = nlohmann::json::parse(stream, nullptr, false);
  if (!stream || !document.is_object() || !document.contains("estimates")) return read_numbers(path);
  std::map<std::string, double> values;
  const nlohmann::json& estimates = document["estimates"];
  if (!estimates.is_array())
    throw InputError(path, "key estimates", "is not a list", "an estimate.json of `secular identify` was expected");
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    const nlohmann::json& entry = estimates[i];
    const std::string place = "estimates, entry " + std::to_string(i + 1);
    if (!entry.is_object() || !entry.contains("name") || !entry["name"].is_string() || !entry.contains("value"))
      throw InputError(path, place, "has no name and value", "an estimate.json of `secular identify` was expected");
    if (entry["value"].is_null()) continue;
    if (!entry["value"].is_number() || !std::isfinite(entry["value"].get<double>()))
      throw InputError(path, place, "has a value that is not a number", "a number, or null, was expected");
    values[entry["name"].get<std::string>()] = entry["value"].get<double>();
  }
  return values;
}

std::map<std::string, double> read_parameter_errors(const std::string& name) {
  std::ifstream stream(resolved(name), std::ios::binary);
  const nlohmann::json document = nlohmann::json::parse(stream, nullptr, false);
  std::map<std::string, double> errors;
  if (!stream || !document.is_object() || !document.contains("estimates")) return errors;
  for (const nlohmann::json& entry : document["estimates"])
    if (entry.is_object() && entry.contains("sd") && entry["sd"].is_number() && entry["sd"].get<double>() > 0 &&
        entry.contains("value") && entry["value"].is_number())
      errors[entry["name"].get<std::string>()] = entry["sd"].get<double>();
  return errors;
}

}  // namespace secular::app
