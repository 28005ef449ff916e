#include "diagnose/verdict/clipped_records.hpp"

namespace secular {

bool leaves_clipped_out(std::size_t clipped_records, std::size_t records) {
  return 2 * clipped_records < records;
}

}  // namespace secular
