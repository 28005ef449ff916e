#include "input/nearest_word.hpp"

#include <algorithm>
#include <cctype>

namespace secular {
namespace {

std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

std::string lower_case(std::string word) {
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return word;
}

}  // namespace

std::optional<std::string> nearest_word(const std::string& word, const std::vector<std::string>& known) {
  std::optional<std::string> nearest;
  std::size_t least = word.size() / 3 + 1;
  for (const std::string& candidate : known)
    if (const std::size_t d = distance(lower_case(word), lower_case(candidate)); d < least) {
      least = d;
      nearest = candidate;
    }
  return nearest;
}

std::string remedy_for_word(const std::string& remedy, const std::string& word,
                            const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), word) != known.end()) return remedy;
  const std::optional<std::string> meant = nearest_word(word, known);
  return meant ? remedy + "; did you mean " + *meant + "?" : remedy;
}

}  // namespace secular
