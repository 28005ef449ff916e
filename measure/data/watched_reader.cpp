#include "measure/data/watched_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>

#include "measure/data/delayed_channels.hpp"
#include "measure/data/jitter.hpp"
#include "measure/data/relative_row.hpp"
#include "numerics/fill_gaps.hpp"

namespace secular {

namespace {

// Takes the base's acceleration out of the responses that carry it.
Record to_relative(const Campaign& campaign, Record record) {
  const std::optional<std::size_t> base = base_channel(campaign);
  for (std::size_t c = 0; base && c < campaign.channels.size(); ++c)
    if (campaign.channels[c].frame == Frame::absolute)
      std::transform(record.channels[c].begin(), record.channels[c].end(), record.channels[*base].begin(),
                     record.channels[c].begin(), std::minus<>());
  return record;
}

// Channels in step, and relative to the base.
Record as_motion(const Campaign& campaign, Record record, const std::string& file) {
  return to_relative(campaign, without_delays(campaign, std::move(record), file));
}

void make_unusable(Record& record, const std::vector<std::size_t>& rows) {
  std::vector<std::size_t> all;
  std::set_union(record.unusable.begin(), record.unusable.end(), rows.begin(), rows.end(), std::back_inserter(all));
  record.unusable = std::move(all);
}

// By channel, whether a model sees it: excitations, and responses of the modal basis.
std::vector<bool> seen_by_models(const Campaign& campaign, const std::vector<std::size_t>& responses) {
  std::vector<bool> seen;
  for (const Channel& channel : campaign.channels) seen.push_back(channel.role == ChannelRole::excitation);
  for (const std::size_t c : responses) seen[c] = true;
  return seen;
}

// `seen`: channels whose wrong samples break the record.
void mend(Record& record, const Treatment& treatment, const std::vector<bool>& seen) {
  for (std::size_t c = 0; c < treatment.masked.size(); ++c) {
    const std::vector<std::size_t> left = fill_gaps(record.channels[c], treatment.masked[c]);
    if (seen[c]) make_unusable(record, left);
  }
  if (treatment.then) treatment.then(record);
}

}  // namespace

ChannelValues values_of(std::span<const double> samples) {
  ChannelValues values{in_order(samples), {}, {}};
  values.grid = grid_of_sorted(values.sorted);
  values.clipping = find_clipping(samples, values.sorted, values.grid);
  return values;
}

ChannelValues values_of(const Record& record, std::size_t channel, std::span<const double> stretch) {
  const std::vector<std::size_t> filled = filled_samples(record, channel);
  if (filled.empty()) return values_of(stretch);
  const auto begin = static_cast<std::size_t>(stretch.data() - record.channels[channel].data());
  std::vector<double> read;
  for (std::size_t i = 0; i < stretch.size(); ++i)
    if (!std::binary_search(filled.begin(), filled.end(), begin + i)) read.push_back(stretch[i]);
  if (read.empty()) return values_of(stretch);
  ChannelValues values{in_order(read), {}, {}};
  values.grid = grid_of_sorted(values.sorted);
  values.clipping = find_clipping(stretch, values.sorted, values.grid);
  return values;
}

Record WatchedReader::read(std::size_t index) {
  Record record = read_record(campaign_, campaign_.records[index]);
  if (record.row) {
    record.row =
        std::make_shared<const LineRow>(relative_to_base(campaign_, without_delays(campaign_, *record.row)));
    return record;
  }
  const Seen* known = nullptr;
  bool without_clipped = false;
  {
    const std::lock_guard lock(mutex_);
    if (const auto before = seen_.find(index); before != seen_.end()) known = &before->second;
    without_clipped = leaves_clipped_out_;
  }
  record.moving = seen_responses(campaign_);
  const std::vector<bool> seen_channels = seen_by_models(campaign_, record.moving);
  const auto without = [&](const std::vector<Clipping>& channels) {
    for (std::size_t c = 0; without_clipped && c < channels.size(); ++c)
      if (seen_channels[c]) make_unusable(record, channels[c].at);
  };
  if (known != nullptr) {  // it stays where it is, and as it is
    mend(record, known->treatment, seen_channels);
    without(known->clipping);
    return as_motion(campaign_, std::move(record), campaign_.records[index].file);
  }
  Seen seen;
  std::vector<ChannelValues> values;
  for (std::size_t c = 0; c < record.channels.size(); ++c) {
    values.push_back(values_of(record, c, record.channels[c]));
    seen.clipping.push_back(values.back().clipping);
  }
  seen.jitter_of_step = record.jitter_s * record.sample_rate_hz;
  if (record.jitter_s > 0)
    seen.jitter = jitter_text({record.start_s, record.sample_rate_hz, record.jitter_s}, record.channels);
  if (look_) look_(index, record, values);
  if (treat_) seen.treatment = treat_(index, record, values);
  mend(record, seen.treatment, seen_channels);
  seen.not_replaced = record.unusable.size();
  without(seen.clipping);
  const std::lock_guard lock(mutex_);
  seen_.emplace(index, std::move(seen));
  return as_motion(campaign_, std::move(record), campaign_.records[index].file);
}

void WatchedReader::leave_clipped_out() {
  const std::lock_guard lock(mutex_);
  leaves_clipped_out_ = true;
}

std::size_t WatchedReader::clipped_records() const {
  const std::lock_guard lock(mutex_);
  const std::vector<bool> seen = seen_by_models(campaign_, seen_responses(campaign_));
  return static_cast<std::size_t>(std::count_if(seen_.begin(), seen_.end(), [&](const auto& one) {
    const std::vector<Clipping>& channels = one.second.clipping;
    bool clipped = false;
    for (std::size_t c = 0; c < channels.size(); ++c) clipped = clipped || (seen[c] && channels[c].found());
    return clipped;
  }));
}

std::vector<std::string> WatchedReader::warnings(WhatIsLeft left) const {
  const std::lock_guard lock(mutex_);
  std::vector<std::string> warnings;
  for (std::size_t c = 0; c < campaign_.channels.size(); ++c) {
    std::size_t clipped = 0, samples = 0;
    std::string first;
    for (const auto& [record, seen] : seen_) {
      if (!seen.clipping[c].found()) continue;
      if (clipped == 0) first = campaign_.records[record].file;
      ++clipped;
      samples += seen.clipping[c].samples;
    }
    if (clipped > 0)
      warnings.push_back(fmt::format(
          "{}: {} samples are stuck at the ends of its range (clipping), in {} of {} records, first {}: "
          "what they hold is too small and has harmonics that the motion has not{}",
          campaign_.channels[c].name, samples, clipped, seen_.size(), first,
          leaves_clipped_out_
              ? "; of these records the stretch without such samples that holds most of the motion counts"
              : ""));
  }
  for (const auto& [record, seen] : seen_)
    if (seen.not_replaced > 0)
      warnings.push_back(fmt::format(
          "{}: {} rows whose samples its file holds wrongly (held, lost, spikes) lie too close or are "
          "too many in a "
          "row to be replaced: {}",
          campaign_.records[record].file, seen.not_replaced,
          left == WhatIsLeft::used ? "they are used as they are; --from and --to choose a stretch without them"
                                   : "the stretch between them that holds most of the motion counts"));
  const auto worst = std::max_element(seen_.begin(), seen_.end(), [](const auto& a, const auto& b) {
    return a.second.jitter_of_step < b.second.jitter_of_step;
  });
  if (worst != seen_.end() && worst->second.jitter_of_step > 0)
    warnings.push_back(fmt::format("{}: {}", campaign_.records[worst->first].file, worst->second.jitter));
  return warnings;
}

}  // namespace secular
