#pragma once

#include <span>
#include <string>

namespace secular {

/// "a, b, c and 17 more": names for a sentence. The whole list stands with the values that it is about.
std::string short_list(std::span<const std::string> names);

}  // namespace secular
