#include "jobs/shared/number_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <vector>

#include "input/input_error.hpp"

namespace secular {

std::map<std::string, double> read_numbers(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw InputError(path, "", "cannot be opened for reading", "a JSON file of symbol to number was expected");
  return numbers_of({std::istreambuf_iterator<char>(stream), {}}, path);
}

std::map<std::string, double> numbers_of(const std::string& text, const std::string& path) {
  nlohmann::json document;
  try {
    document = nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    throw InputError(path, "byte " + std::to_string(error.byte), "is not JSON",
                     "an object such as {\"omega0\": 77.85, \"mu1\": 0.222} was expected");
  } catch (const nlohmann::json::out_of_range& error) {  // its message quotes the number
    const std::string message = error.what();
    throw InputError(path, "",
                     "holds a number beyond the range of double precision (" +
                         message.substr(std::min(message.find('\''), message.size())) + ")",
                     "numbers up to 1.8e308 in magnitude were expected");
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

std::string unused_numbers(const std::string& path, const std::map<std::string, double>& numbers,
                           const std::set<std::string, std::less<>>& known) {
  std::vector<std::string> unused;
  for (const auto& [name, value] : numbers)
    if (!known.contains(name)) unused.push_back(name);
  if (unused.empty()) return {};
  return fmt::format("{}: {} not used: the model has no such symbol; it has {}", path,
                     fmt::format("{} {}", fmt::join(unused, ", "), unused.size() == 1 ? "is" : "are"),
                     fmt::join(known, ", "));
}

std::string unused_numbers(const std::string& path, const std::map<std::string, double>& numbers,
                           const CompiledModel& model) {
  std::set<std::string, std::less<>> known;
  for (const CompiledSymbol& symbol : model.symbols) known.emplace(symbol.name);
  known.insert(model.excitations.begin(), model.excitations.end());
  known.insert(model.excitation_frequencies.begin(), model.excitation_frequencies.end());
  return unused_numbers(path, numbers, known);
}

}  // namespace secular
