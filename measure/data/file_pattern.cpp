#include "measure/data/file_pattern.hpp"

#include <cstddef>

namespace secular {

bool matches_pattern(const std::string& pattern, const std::string& file) {
  // Linear in time with one remembered star.
  std::size_t p = 0, f = 0, star = std::string::npos, resume = 0;
  while (f < file.size()) {
    if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == file[f])) {
      ++p;
      ++f;
    } else if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      resume = f;
    } else if (star != std::string::npos) {
      p = star + 1;
      f = ++resume;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

}  // namespace secular
