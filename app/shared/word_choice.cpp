#include "app/shared/word_choice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "app/shared/unknown_word.hpp"

namespace secular::app {

CLI::Validator one_of(std::vector<std::string> words) {
  const std::string listed = fmt::format("{{{}}}", fmt::join(words, ","));
  return {[words = std::move(words)](const std::string& given) -> std::string {
            if (std::find(words.begin(), words.end(), given) != words.end()) return {};
            const std::optional<std::string> meant = nearest_word(given, words);
            return fmt::format("'{}' is none of {}{}", given, fmt::join(words, ", "),
                               meant ? "; did you mean " + *meant + "?" : "");
          },
          listed};
}

}  // namespace secular::app
