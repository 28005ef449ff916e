#include "app/shared/number_file.hpp"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "input/input_error.hpp"

namespace secular::app {

std::map<std::string, double> read_numbers(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw InputError(path, "", "cannot be opened for reading", "a JSON file of symbol to number was expected");
  nlohmann::json document;
  try {
    document = nlohmann::json::parse(stream);
  } catch (const nlohmann::json::parse_error& error) {
    throw InputError(path, "byte " + std::to_string(error.byte), "is not JSON",
                     "an object such as {\"omega0\": 77.85, \"mu1\": 0.222} was expected");
  }
  if (!document.is_object())
    throw InputError(path, "", "is not a JSON object", "an object such as {\"omega0\": 77.85} was expected");
  std::map<std::string, double> numbers;
  for (const auto& [key, value] : document.items()) {
    if (!value.is_number() || !std::isfinite(value.get<double>()))
      throw InputError(path, "key " + key, "is not a finite number", "symbols map to numbers");
    numbers[key] = value.get<double>();
  }
  return numbers;
}

}  // namespace secular::app
