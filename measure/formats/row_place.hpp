#pragma once

#include <cstddef>
#include <string>

namespace secular {

/// How messages name a row of a file: "line 7" of a CSV whose first row is line 2, "element 6" of a MAT vector.
struct RowPlace {
  std::string noun = "line";
  std::size_t first = 2;
  std::string of(std::size_t row) const { return noun + " " + std::to_string(first + row); }
};

}  // namespace secular
