#include "measure/observe/passed_record.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "measure/observe/record_window.hpp"
#include "measure/signal/free_decay.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Sample of the record from which the response that moves most swings freely; 0 where no decay is found.
Index release(const Campaign& campaign, const Record& record, const Window& window) {
  Window of_any_band = window;
  of_any_band.band.reset();
  const auto [first, count] = range_of(record, of_any_band);
  std::optional<VectorXd> leading;
  double most = -1;
  for (const std::size_t c : channels_of(campaign, ChannelRole::response)) {
    if (count == 0) break;
    VectorXd samples = samples_of(record, {c}, first, count).col(0);
    const double size = (samples.array() - samples.mean()).matrix().norm();
    if (size <= most) continue;
    most = size;
    leading = std::move(samples);
  }
  const auto start = leading ? find_decay_start(*leading, record.sample_rate_hz) : std::nullopt;
  return start ? first + start->sample : 0;
}

// Rows of what a filter leaves that unusable ones of the record have a part in. Row i of it comes from the rows
// first + i to first + i + 2 reach.
std::vector<std::size_t> touched(const std::vector<std::size_t>& unusable, Index first, Index reach,
                                 std::size_t rows) {
  std::vector<std::size_t> all;
  Index next = 0;  // not yet looked at
  for (const std::size_t row : unusable) {
    const Index last = static_cast<Index>(row) - first;
    for (next = std::max(next, last - 2 * reach); next <= last && next < static_cast<Index>(rows); ++next)
      all.push_back(static_cast<std::size_t>(next));
  }
  return all;
}

}  // namespace

Record passed_record(const Campaign& campaign, std::size_t record, Record samples, const Window& window) {
  if (!window.band || samples.row) return samples;
  const RecordKind kind = campaign.records[record].kind;
  const bool decays = kind == RecordKind::free_decay || kind == RecordKind::impact;
  const Index first = decays ? release(campaign, samples, window) : 0;
  for (std::vector<double>& channel : samples.channels) {
    const auto count = static_cast<Index>(channel.size()) - first;
    const Eigen::MatrixXd passed =
        band_pass(VectorXd::Map(channel.data() + first, count), samples.sample_rate_hz, *window.band);
    channel.assign(passed.data(), passed.data() + passed.size());
  }
  const Index reach = band_pass_reach(*window.band, samples.sample_rate_hz);
  samples.unusable = touched(samples.unusable, first, reach, samples.samples());
  samples.start_s += static_cast<double>(first + reach) / samples.sample_rate_hz;
  return samples;
}

}  // namespace secular
