#include "measure/disturbances/searched_record.hpp"

#include <algorithm>
#include <cmath>

#include "measure/disturbances/catalogue.hpp"
#include "measure/disturbances/motion_events.hpp"
#include "measure/thresholds.hpp"
#include "numerics/fill_gaps.hpp"

namespace secular {
namespace {

double rms_about_mean(std::span<const double> samples) {
  const auto n = static_cast<double>(samples.size());
  double mean = 0, square = 0;
  for (const double x : samples) mean += x / n;
  for (const double x : samples) square += (x - mean) * (x - mean) / n;
  return std::sqrt(square);
}

// Channel by what its file holds, then by what is left once wrong samples are replaced.
void look_at(SearchedChannel& channel, const RecordEntry& entry, bool excitation, double rate, double level) {
  channel.lines = find_lines(channel.samples, rate, level, &channel.powers);
  channel.wrong = find_wrong(channel.samples, *channel.values, level);
  const WrongSamples& wrong = channel.wrong;
  std::vector<std::size_t> held, impulses;
  for (const HeldSamples::Run& run : wrong.held.runs) held.push_back(run.begin);
  for (const auto* list : {&wrong.impulses.spikes, &wrong.impulses.knocks})
    for (const Impulses::One& one : *list) impulses.push_back(one.at);
  channel.is_held = !held.empty() && !recurs_with_motion(channel.samples, channel.powers, held);
  const bool of_motion = recurs_with_motion(channel.samples, channel.powers, impulses);
  // A blow is the record's subject.
  channel.has_spikes =
      !(entry.kind == RecordKind::impact && excitation) && !wrong.impulses.spikes.empty() && !of_motion;
  channel.has_knocks = entry.kind != RecordKind::impact && !wrong.impulses.knocks.empty() && !of_motion;
  channel.masked = wrong.marks.at;
  if (channel.is_held) {
    channel.masked.insert(channel.masked.end(), wrong.foreign.begin(), wrong.foreign.end());
    for (const HeldSamples::Run& run : wrong.held.runs)
      for (std::size_t i = run.begin; i < run.end; ++i) channel.masked.push_back(i);
  }
  if (channel.has_spikes)
    for (const Impulses::One& spike : wrong.impulses.spikes) channel.masked.push_back(spike.at);
  if (channel.masked.empty()) return;
  std::sort(channel.masked.begin(), channel.masked.end());
  channel.masked.erase(std::unique(channel.masked.begin(), channel.masked.end()), channel.masked.end());
  channel.mended.assign(channel.samples.begin(), channel.samples.end());
  fill_gaps(channel.mended, channel.masked);
  channel.samples = channel.mended;
  channel.lines = find_lines(channel.samples, rate, level, &channel.powers);
}

}  // namespace

std::vector<std::span<const double>> complete_stretch(const Record& record) {
  std::size_t begin = 0, best_begin = 0, best_size = 0;
  for (std::size_t i = 0; i <= record.samples(); ++i) {
    if (i < record.samples() && std::all_of(record.channels.begin(), record.channels.end(),
                                            [&](const auto& samples) { return std::isfinite(samples[i]); }))
      continue;
    if (i - begin > best_size) {
      best_begin = begin;
      best_size = i - begin;
    }
    begin = i + 1;
  }
  std::vector<std::span<const double>> stretch;
  for (const std::vector<double>& samples : record.channels)
    stretch.push_back(std::span(samples).subspan(best_begin, best_size));
  return stretch;
}

Disturbance SearchedRecord::found(std::string_view kind, std::size_t c, double size) const {
  Disturbance disturbance;
  disturbance.kind = kind;
  disturbance.record = index;
  disturbance.channel = c;
  disturbance.from_s = start_s;
  disturbance.to_s = time_s(samples());
  disturbance.size = size;
  disturbance.unit = channel(c).unit;
  disturbance.share = channels[c].rms > 0 ? size / channels[c].rms : 0;
  return disturbance;
}

double false_alarm_of_channel(const Campaign& campaign) {
  return measure_thresholds().disturbance_false_alarm /
         static_cast<double>(campaign.records.size() * campaign.channels.size());
}

SearchedRecord searched(const Campaign& campaign, std::size_t index, const Record& record,
                        const std::vector<ChannelValues>& values) {
  SearchedRecord result;
  result.campaign = &campaign;
  result.index = index;
  result.total = record.samples();
  result.lost_rows = record.lost.size();
  result.rate = record.sample_rate_hz;
  result.jitter_s = record.jitter_s;
  result.level = false_alarm_of_channel(campaign);
  const std::vector<std::span<const double>> stretch = complete_stretch(record);
  for (std::size_t c = 0; c < record.channels.size(); ++c) {
    const std::vector<double>& samples = record.channels[c];
    SearchedChannel channel;
    channel.samples = stretch[c];
    channel.values = &values[c];
    channel.missing = static_cast<std::size_t>(
        std::count_if(samples.begin(), samples.end(), [](double x) { return !std::isfinite(x); }));
    if (c < record.no_numbers.size()) channel.filled = record.no_numbers[c].size();
    if (!stretch[c].empty()) look_at(channel, result.entry(), result.is_excitation(c), result.rate, result.level);
    if (!channel.samples.empty()) channel.rms = rms_about_mean(channel.samples);
    result.start_s =
        record.start_s + static_cast<double>(stretch[c].data() - samples.data()) / record.sample_rate_hz;
    result.channels.push_back(std::move(channel));
  }
  return result;
}

}  // namespace secular
