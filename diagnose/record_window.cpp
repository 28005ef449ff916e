#include "diagnose/record_window.hpp"

#include <algorithm>
#include <cmath>

namespace secular {

using Eigen::Index;

RecordPart part_of(const Record& record, const std::vector<std::size_t>& channels, const Window& window) {
  const auto count = static_cast<double>(record.samples());
  const double begin = std::clamp((window.from_s - record.start_s) * record.sample_rate_hz, 0.0, count);
  const double end = std::clamp((window.to_s - record.start_s) * record.sample_rate_hz + 1, 0.0, count);
  const auto first = static_cast<Index>(std::ceil(begin - 1e-6));
  const Index length = std::max<Index>(0, static_cast<Index>(std::floor(end + 1e-6)) - first);
  RecordPart part;
  part.start_s = record.start_s + static_cast<double>(first) / record.sample_rate_hz;
  part.samples.resize(length, static_cast<Index>(channels.size()));
  for (std::size_t c = 0; c < channels.size(); ++c)
    part.samples.col(static_cast<Index>(c)) =
        Eigen::Map<const Eigen::VectorXd>(record.channels[channels[c]].data() + first, length);
  return part;
}

}  // namespace secular
