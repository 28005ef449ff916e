#pragma once

#include <string>

namespace secular {

/// True if `file` matches a shell pattern with * and ?.
bool matches_pattern(const std::string& pattern, const std::string& file);

}  // namespace secular
