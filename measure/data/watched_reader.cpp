#include "measure/data/watched_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace secular {

Record WatchedReader::read(std::size_t index) {
  Record record = read_record(campaign_, campaign_.records[index]);
  {
    const std::lock_guard lock(mutex_);
    if (seen_.contains(index)) return record;
  }
  std::vector<Clipping> clipping;
  for (const std::vector<double>& samples : record.channels) clipping.push_back(find_clipping(samples));
  const std::lock_guard lock(mutex_);
  seen_.emplace(index, std::move(clipping));
  return record;
}

std::vector<std::string> WatchedReader::warnings() const {
  const std::lock_guard lock(mutex_);
  std::vector<std::string> warnings;
  for (std::size_t c = 0; c < campaign_.channels.size(); ++c) {
    std::size_t clipped = 0, samples = 0;
    std::string first;
    for (const auto& [record, clipping] : seen_) {
      if (!clipping[c].found()) continue;
      if (clipped == 0) first = campaign_.records[record].file;
      ++clipped;
      samples += clipping[c].samples;
    }
    if (clipped > 0)
      warnings.push_back(fmt::format(
          "{}: {} samples are stuck at the ends of its range (clipping), in {} of {} records, first {}: "
          "what they hold is too small and has harmonics that the motion has not",
          campaign_.channels[c].name, samples, clipped, seen_.size(), first));
  }
  return warnings;
}

}  // namespace secular
