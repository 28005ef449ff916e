#include "measure/data/numbered_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "input/input_error.hpp"

namespace secular {
namespace {

// What follows the "*" in a name is the same for all.
void put_number(std::string& text, const std::string& number) {
  for (const auto& [open, close] : {std::pair("(*)", ')'), std::pair("{*}", '}')})
    for (std::size_t at = text.find(open); at != std::string::npos; at = text.find(open))
      text = text.substr(0, at + 1) + number + close + text.substr(at + 3);
}

}  // namespace

ImportOptions numbered(ImportOptions options, const std::string& number) {
  put_number(options.time, number);
  for (auto* list : {&options.channels, &options.table.columns})
    for (std::string& text : *list) put_number(text, number);
  return options;
}

std::vector<std::string> numbers_in(const ImportOptions& options, const Variables& variables,
                                    const std::string& file) {
  std::vector<std::string> with_star;
  for (const auto* list : {&options.channels, &options.table.columns})
    for (const std::string& text : *list)
      if (text.find("(*)") != std::string::npos || text.find("{*}") != std::string::npos) with_star.push_back(text);
  if (with_star.empty()) return {""};
  std::string pattern = with_star.front();
  if (const std::size_t equals = pattern.find('='); equals != std::string::npos)
    pattern = pattern.substr(equals + 1);
  const std::size_t star = pattern.find('*');
  std::vector<std::string> numbers;
  for (int k = 1;; ++k) {
    std::string begin = pattern.substr(0, star + 2);
    put_number(begin, std::to_string(k));
    const bool there = std::any_of(variables.begin(), variables.end(),
                                   [&](const DataVariable& v) { return v.name.starts_with(begin); });
    if (!there) break;
    numbers.push_back(std::to_string(k));
  }
  if (numbers.empty())
    throw InputError(with_star.front(), "", fmt::format("{} has no variable {}1...", file, pattern.substr(0, star)),
                     "its variables are " + listed_names(variables));
  return numbers;
}

}  // namespace secular
