#include "measure/disturbances/searched_record.hpp"

#include <algorithm>
#include <cmath>

#include "measure/disturbances/catalogue.hpp"
#include "measure/thresholds.hpp"

namespace secular {
namespace {

double rms_about_mean(std::span<const double> samples) {
  const auto n = static_cast<double>(samples.size());
  double mean = 0, square = 0;
  for (const double x : samples) mean += x / n;
  for (const double x : samples) square += (x - mean) * (x - mean) / n;
  return std::sqrt(square);
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

bool recurs_with_motion(const SearchedChannel& channel, const std::vector<std::size_t>& samples) {
  const std::vector<double>& powers = channel.powers;
  if (powers.size() < 2 || samples.size() < 3) return false;
  const auto strongest = std::max_element(powers.begin() + 1, powers.end()) - powers.begin();
  const double turns_a_sample = 0.5 * static_cast<double>(strongest) / (static_cast<double>(powers.size()) - 1);
  const auto [first, last] = std::minmax_element(samples.begin(), samples.end());
  return 2 * static_cast<double>(samples.size() - 1) >= turns_a_sample * static_cast<double>(*last - *first);
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
    channel.rms = stretch[c].empty() ? 0 : rms_about_mean(stretch[c]);
    if (!stretch[c].empty()) {
      channel.lines = find_lines(stretch[c], result.rate, result.level, &channel.powers);
      channel.held = find_held(stretch[c], values[c], result.level);
      channel.impulses = find_impulses(stretch[c], values[c].grid, channel.held, result.level);
    }
    result.start_s =
        record.start_s + static_cast<double>(stretch[c].data() - samples.data()) / record.sample_rate_hz;
    result.channels.push_back(std::move(channel));
  }
  return result;
}

}  // namespace secular
