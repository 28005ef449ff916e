#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "measure/observe/observation_set.hpp"

namespace secular {

/// Observations [begin, end) of one record.
struct RecordRange {
  std::size_t begin = 0, end = 0;

  std::span<const Observation> of(std::span<const Observation> all) const {
    return all.subspan(begin, end - begin);
  }
};

/// Runs of neighbours that are of one record: the ensembles of a dwell.
inline std::vector<RecordRange> ranges_of_records(std::span<const Observation> all) {
  std::vector<RecordRange> ranges;
  for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
    while (end < all.size() && all[end].record == all[begin].record) ++end;
    ranges.push_back({begin, end});
  }
  return ranges;
}

}  // namespace secular
