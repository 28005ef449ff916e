#pragma once

#include <optional>
#include <string>
#include <vector>

namespace secular {

/// That of `known` which `word` is a slip of, if there is one: nearest by letters added, left out, exchanged or
/// swapped with their neighbour (Damerau 1964, of adjacent swaps), not more than a third of the word. Capitals are
/// small letters.
std::optional<std::string> nearest_word(const std::string& word, const std::vector<std::string>& known);

/// What to do about `word`: `remedy`, and which of `known` may be meant where it is none of them.
std::string remedy_for_word(const std::string& remedy, const std::string& word,
                            const std::vector<std::string>& known);

/// The words of a table of pairs of word and meaning.
template <class Table>
std::vector<std::string> words_of(const Table& table) {
  std::vector<std::string> words;
  for (const auto& [word, meaning] : table) words.emplace_back(word);
  return words;
}

}  // namespace secular
