#include "app/shared/word_choice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "input/nearest_word.hpp"

namespace secular::app {

CLI::Validator one_of(std::vector<std::string> words) {
  const std::string listed = fmt::format("{{{}}}", fmt::join(words, ","));
  return {[words = std::move(words)](const std::string& given) -> std::string {
            if (std::find(words.begin(), words.end(), given) != words.end()) return {};
            return remedy_for_word(fmt::format("'{}' is none of {}", given, fmt::join(words, ", ")), given, words);
          },
          listed};
}

}  // namespace secular::app
