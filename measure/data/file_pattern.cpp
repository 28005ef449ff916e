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

bool matches_record(const std::string& pattern, const std::string& record) {
  if (matches_pattern(pattern, record)) return true;
  const std::size_t colon = record.rfind(':');
  return colon != std::string::npos && record.find_first_not_of("0123456789", colon + 1) == std::string::npos &&
         matches_pattern(pattern, record.substr(0, colon));
}

}  // namespace secular
