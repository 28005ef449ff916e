#include "measure/disturbances/treatment.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "measure/data/false_alarm.hpp"
#include "measure/disturbances/converter_lines.hpp"
#include "measure/disturbances/doubled_rows.hpp"
#include "measure/disturbances/rows.hpp"
#include "measure/disturbances/searched_record.hpp"

namespace secular {
namespace {

// Without ensembles: samples in which frequencies of the strongest lines are told apart to a few turns (a size:
// half and twice as many move nothing).
constexpr std::size_t longest_block = 4096;

struct RoundedChannel {
  std::size_t index = 0;  // of the channel
  ConverterLattice lattice;
  std::vector<double> frequencies_hz;
  std::vector<std::size_t> masked;
};

// Samples that the file does not hold were no values of the converter, nor is what replaces wrong ones.
std::vector<std::size_t> not_rounded(const Record& record, std::size_t channel,
                                     const std::vector<std::size_t>& masked) {
  std::vector<std::size_t> all = filled_samples(record, channel);
  all.insert(all.end(), masked.begin(), masked.end());
  std::sort(all.begin(), all.end());
  return all;
}

// Whether anything may have to be mended, before the record's lines are looked for.
bool needs_a_look(bool dwell, const ChannelValues& values, const std::vector<double>& samples, double level) {
  if (dwell && is_lattice(values.grid, level)) return true;
  return !find_wrong(samples, values, level).none();
}

void take_out_rows(Record& record, const std::vector<std::size_t>& rows) {
  const auto goes = [&](std::size_t i) { return std::binary_search(rows.begin(), rows.end(), i); };
  for (std::vector<double>& samples : record.channels) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (!goes(i)) samples[kept++] = samples[i];
    samples.resize(kept);
  }
  std::erase_if(record.unusable, goes);
  for (std::size_t& row : record.unusable)
    row -= static_cast<std::size_t>(std::lower_bound(rows.begin(), rows.end(), row) - rows.begin());
}

std::vector<RoundedChannel> rounded_channels(const SearchedRecord& look, const Record& record,
                                             const std::vector<std::vector<std::size_t>>& masked) {
  std::vector<RoundedChannel> rounded;
  for (std::size_t c = 0; c < look.channels.size(); ++c) {
    const std::optional<ConverterLattice> lattice = repeating_lattice(look.channels[c], look.level);
    if (!lattice) continue;
    RoundedChannel& channel =
        rounded.emplace_back(c, *lattice, std::vector<double>(), not_rounded(record, c, masked[c]));
    std::vector<Line> lines = look.channels[c].lines;
    std::stable_sort(lines.begin(), lines.end(),
                     [](const Line& a, const Line& b) { return a.amplitude > b.amplitude; });
    for (const Line& line : lines) channel.frequencies_hz.push_back(line.frequency_hz);
  }
  return rounded;
}

}  // namespace

Treatment treatment_of(const Campaign& campaign, std::size_t index, const Record& record,
                       const std::vector<ChannelValues>& values) {
  const RecordEntry& entry = campaign.records[index];
  const bool dwell = entry.kind == RecordKind::dwell;
  const double level = false_alarm_of_channel(campaign);
  bool nothing = true;
  for (std::size_t c = 0; c < record.channels.size() && nothing; ++c)
    nothing = !needs_a_look(dwell, values[c], record.channels[c], level);
  Treatment treatment;
  if (nothing) return treatment;
  const SearchedRecord look = searched(campaign, index, record, values);
  for (std::size_t c = 0; c < record.channels.size(); ++c)
    treatment.masked.push_back(beside_doubled(look.channels[c].masked, look.doubled));
  if (!look.doubled.empty()) {  // lines of a time that stops now and then are no lines
    treatment.then = [rows = look.doubled](Record& mended) { take_out_rows(mended, rows); };
    return treatment;
  }
  if (!dwell) return treatment;
  std::vector<RoundedChannel> rounded = rounded_channels(look, record, treatment.masked);
  if (rounded.empty()) return treatment;
  const double ensemble_s = entry.ensemble_s.value_or(INFINITY);
  treatment.then = [rounded = std::move(rounded), ensemble_s](Record& mended) {
    const double ensemble = std::round(ensemble_s * mended.sample_rate_hz);
    const std::size_t block =
        ensemble < static_cast<double>(longest_block) ? static_cast<std::size_t>(ensemble) : longest_block;
    for (const RoundedChannel& c : rounded)
      take_out_rounding(mended.channels[c.index], mended.sample_rate_hz, c.frequencies_hz, c.lattice, block,
                        c.masked);
  };
  return treatment;
}

WatchedReader::Treat treatments_of(const Campaign& campaign) {
  return [&campaign](std::size_t index, const Record& record, const std::vector<ChannelValues>& values) {
    return treatment_of(campaign, index, record, values);
  };
}

}  // namespace secular
