#include "diagnose/evidence/record_part.hpp"

#include "measure/observe/record_window.hpp"

namespace secular {

RecordPart part_of(const Record& record, const std::vector<std::size_t>& channels, const Window& window) {
  const SampleRange range = range_of(record, window);
  RecordPart part;
  part.start_s = record.start_s + static_cast<double>(range.first) / record.sample_rate_hz;
  part.samples = samples_of(record, channels, range.first, range.count);
  return part;
}

}  // namespace secular
