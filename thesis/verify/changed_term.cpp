#include "thesis/verify/changed_term.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

namespace secular::verify {
namespace {

// Names, numbers and single marks; blanks are none.
std::vector<std::string> tokens_of(const std::string& text) {
  std::vector<std::string> tokens;
  bool open = false;
  for (const char c : text) {
    const bool part = std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.';
    if (part && open)
      tokens.back() += c;
    else if (!std::isspace(static_cast<unsigned char>(c)))
      tokens.emplace_back(1, c);
    open = part;
  }
  return tokens;
}

bool is_one_of(const std::string& token, std::string_view marks) {
  return token.size() == 1 && marks.find(token[0]) != std::string_view::npos;
}

/// A stretch of tokens that grows until it is made of whole terms with all their brackets.
struct Stretch {
  const std::vector<std::string>& tokens;
  std::size_t begin, end;

  bool grow() {
    int opened = 0, closed = 0;  // brackets whose partner is outside
    for (std::size_t i = begin; i < end; ++i)
      if (tokens[i] == "(")
        ++opened;
      else if (tokens[i] == ")")
        opened > 0 ? --opened : ++closed;
    const bool starts = begin == 0 || is_one_of(tokens[begin - 1], "(,=") ||
                        (begin < tokens.size() && is_one_of(tokens[begin], "+-"));
    const bool ends = end == tokens.size() || is_one_of(tokens[end], "+-=),");
    if ((closed > 0 || !starts) && begin > 0) return --begin, true;
    if ((opened > 0 || !ends) && end < tokens.size()) return ++end, true;
    return false;
  }
};

std::string joined(const std::vector<std::string>& tokens, std::size_t begin, std::size_t end) {
  std::string text;
  for (std::size_t i = begin; i < end; ++i)
    text +=
        (tokens[i] == "+" || tokens[i] == "-" || tokens[i] == "=") && i > begin ? " " + tokens[i] + " " : tokens[i];
  return text;
}

}  // namespace

std::pair<std::string, std::string> changed_term(const std::string& printed, const std::string& corrected) {
  const std::vector<std::string> a = tokens_of(printed), b = tokens_of(corrected);
  if (a == b) return {};
  const auto first = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  const auto begin = static_cast<std::size_t>(first.first - a.begin());
  std::size_t same = 0;  // tokens at the end
  while (same < std::min(a.size(), b.size()) - begin && a[a.size() - 1 - same] == b[b.size() - 1 - same]) ++same;
  Stretch of_printed{a, begin, a.size() - same}, of_corrected{b, begin, b.size() - same};
  while (of_printed.grow() || of_corrected.grow()) {
    const std::size_t after = std::min(a.size() - of_printed.end, b.size() - of_corrected.end);
    of_printed.begin = of_corrected.begin = std::min(of_printed.begin, of_corrected.begin);
    of_printed.end = a.size() - after;
    of_corrected.end = b.size() - after;
  }
  return {joined(a, of_printed.begin, of_printed.end), joined(b, of_corrected.begin, of_corrected.end)};
}

}  // namespace secular::verify
