#include "report/warning_kinds.hpp"

#include <map>
#include <string_view>

namespace secular::report {
namespace {

bool digit(char c) {
  return c >= '0' && c <= '9';
}

/// The text with '#' in the place of every number.
std::string without_numbers(std::string_view text) {
  std::string kept;
  for (std::size_t i = 0; i < text.size();) {
    const bool signed_number = (text[i] == '-' || text[i] == '+') && i + 1 < text.size() && digit(text[i + 1]);
    if (!digit(text[i]) && !signed_number) {
      kept += text[i++];
      continue;
    }
    kept += '#';
    ++i;
    const auto goes_on = [&](std::size_t at) {
      return digit(text[at]) ||
             ((text[at] == '.' || text[at] == ',' || text[at] == 'e' || text[at] == '-' || text[at] == '+') &&
              at + 1 < text.size() && (digit(text[at + 1]) || text[at] == 'e'));
    };
    while (i < text.size() && goes_on(i)) ++i;
  }
  return kept;
}

}  // namespace

std::vector<std::vector<std::size_t>> warning_kinds(const std::vector<std::string>& texts) {
  std::map<std::string, std::size_t> place;
  std::vector<std::vector<std::size_t>> kinds;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const auto [at, fresh] = place.emplace(without_numbers(texts[i]), kinds.size());
    if (fresh) kinds.emplace_back();
    kinds[at->second].push_back(i);
  }
  return kinds;
}

}  // namespace secular::report
