#include "measure/disturbances/searched_record.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "measure/data/false_alarm.hpp"
#include "measure/disturbances/answered_blows.hpp"
#include "measure/disturbances/catalogue.hpp"
#include "measure/disturbances/doubled_rows.hpp"
#include "measure/disturbances/motion_events.hpp"
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

// The longest stretch beside samples at `places`, rising.
std::span<const double> longest_beside(std::span<const double> samples, const std::vector<std::size_t>& places) {
  std::span<const double> best;
  std::size_t begin = 0;
  const auto end_at = [&](std::size_t end) {
    if (end - begin > best.size()) best = samples.subspan(begin, end - begin);
    begin = end + 1;
  };
  for (const std::size_t place : places) end_at(place);
  end_at(samples.size());
  return best;
}

// Puts the samples right that are to be replaced, and looks for lines in what is left.
void put_right(SearchedChannel& channel, std::span<const double> samples, std::vector<std::size_t> masked,
               double rate, double level) {
  channel.masked = std::move(masked);
  channel.samples = samples;
  std::vector<std::size_t> left;
  if (!channel.masked.empty()) {
    channel.mended.assign(samples.begin(), samples.end());
    left = fill_gaps(channel.mended, channel.masked);
    channel.samples = channel.mended;
  }
  channel.is_broken = !left.empty();
  channel.intact = longest_beside(channel.samples, left);
  channel.lines = find_lines(channel.intact, rate, level, &channel.powers);
}

// What the motion makes itself is not wrong. How long its turns are is told without all that may be.
void look_at(SearchedChannel& channel, const RecordEntry& entry, bool excitation, double rate, double level) {
  const std::span<const double> samples = channel.samples;
  channel.wrong = find_wrong(samples, *channel.values, level);
  const WrongSamples& wrong = channel.wrong;
  const std::vector<std::size_t> held = held_places(wrong), spikes = places_of(wrong.impulses.spikes),
                                 impulses = in_one({spikes, places_of(wrong.impulses.knocks)});
  put_right(channel, samples, in_one({wrong.marks.at, held, spikes}), rate, level);
  std::vector<std::size_t> begins;
  for (const HeldSamples::Run& run : wrong.held.runs) begins.push_back(run.begin);
  const std::vector<double> powers = channel.powers;
  const bool impact = entry.kind == RecordKind::impact;  // a blow is the record's subject
  channel.is_held = !held.empty() && !recurs_with_motion(samples, powers, begins);
  channel.has_spikes = !spikes.empty() && !(impact && excitation) && !keeps_to_phases(samples, powers, spikes);
  channel.has_knocks = !impact && !wrong.impulses.knocks.empty() && !recurs_with_motion(samples, powers, impulses);
  if (keeps_to_phases(samples, powers, wrong.marks.at)) channel.wrong.marks = {};
  std::vector<std::size_t> masked = in_one({wrong.marks.at, channel.is_held ? held : std::vector<std::size_t>(),
                                            channel.has_spikes ? spikes : std::vector<std::size_t>()});
  if (masked != channel.masked) put_right(channel, samples, std::move(masked), rate, level);
}

// Spikes of an excitation that responses answer are blows of one sample.
void keep_blows(SearchedRecord& record, const std::vector<std::span<const double>>& stretch) {
  for (std::size_t c = 0; c < record.channels.size(); ++c) {
    SearchedChannel& channel = record.channels[c];
    if (!record.is_excitation(c) || !channel.has_spikes) continue;
    std::vector<Impulses::One>& spikes = channel.wrong.impulses.spikes;
    const std::vector<std::size_t> places = places_of(spikes);
    std::vector<std::size_t> blows;
    for (std::size_t r = 0; r < record.channels.size(); ++r)
      if (!record.is_excitation(r)) blows = in_one({blows, answered_blows(record.channels[r].samples, places)});
    if (blows.empty()) continue;
    std::erase_if(spikes,
                  [&](const Impulses::One& one) { return std::binary_search(blows.begin(), blows.end(), one.at); });
    channel.has_spikes = !spikes.empty();
    std::vector<std::size_t> masked = channel.masked;
    std::erase_if(masked, [&](std::size_t at) { return std::binary_search(blows.begin(), blows.end(), at); });
    channel.mended.clear();
    put_right(channel, stretch[c], std::move(masked), record.rate, record.level);
    channel.rms = rms_about_mean(channel.samples);
  }
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

Disturbance SearchedRecord::found_in_intact(std::string_view kind, std::size_t c, double size) const {
  Disturbance disturbance = found(kind, c, size);
  const SearchedChannel& searched = channels[c];
  disturbance.from_s = time_s(searched.intact_from());
  disturbance.to_s = time_s(searched.intact_from() + searched.intact.size());
  return disturbance;
}

SearchedRecord searched(const Campaign& campaign, std::size_t index, const Record& record,
                        const std::vector<ChannelValues>& values) {
  SearchedRecord result;
  result.campaign = &campaign;
  result.index = index;
  result.total = record.samples() + record.cut_off;
  result.lost_rows = record.lost.size();
  result.unrecorded = record.unrecorded;
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
  keep_blows(result, stretch);
  result.doubled = doubled_rows(result, stretch);
  return result;
}

}  // namespace secular
