#include "estimator/identification/short_list.hpp"

#include <fmt/format.h>

namespace secular {

namespace {

/// A list that is longer by one is written out, too: "and 1 more" saves nothing.
constexpr std::size_t names_shown = 4;

}  // namespace

std::string short_list(std::span<const std::string> names) {
  const std::size_t shown = names.size() <= names_shown + 1 ? names.size() : names_shown;
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) text += (i == 0 ? "" : ", ") + names[i];
  return shown == names.size() ? text : fmt::format("{} and {} more", text, names.size() - shown);
}

}  // namespace secular
