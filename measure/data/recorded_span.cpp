#include "measure/data/recorded_span.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "measure/data/chance_of_repeat.hpp"
#include "measure/data/false_alarm.hpp"
#include "measure/data/resolution.hpp"
#include "measure/thresholds.hpp"
#include "numerics/fill_gaps.hpp"
#include "numerics/median.hpp"

namespace secular {
namespace {

constexpr auto& neighbours_of_end = measure_thresholds().local_samples;  // that tell how the motion goes there

enum class End { first, last };

// One end of a channel, as the last one: samples of the first one come in reverse.
class Tail {
 public:
  Tail(std::span<const double> samples, std::size_t end, bool reversed)
      : x_(samples), end_(end), reversed_(reversed) {
    while (end_ > 0 && !std::isfinite(at(end_ - 1))) --end_;
    begin_ = end_;
    while (begin_ > 0 && equals(at(begin_ - 1))) --begin_;
  }

  // Nothing recorded from there on.
  std::size_t of_no_number() const { return end_; }
  std::size_t of_one_value() const { return begin_; }
  bool repeats() const { return begin_ > 0 && begin_ + 1 < end_; }
  double value() const { return at(end_ - 1); }

  // Rounding: of values that are equal.
  bool equals(double x) const { return std::abs(x - value()) <= 1e-8 * std::abs(value()); }

  // The differences of that order of the samples beside the repeated value, the first to be told last.
  std::vector<double> differences(int order) const {
    std::vector<double> all;
    for (std::size_t i = begin_ - std::min(begin_, neighbours_of_end); i < begin_; ++i) all.push_back(at(i));
    for (; order > 0 && !all.empty(); --order) {
      for (std::size_t i = 1; i < all.size(); ++i) all[i - 1] = all[i] - all[i - 1];
      all.pop_back();
    }
    std::erase_if(all, [](double x) { return !std::isfinite(x); });
    return all;
  }

  double step() const { return std::abs(value() - at(begin_ - 1)); }

  // Whether other samples repeat the value, too: a range's end, a converter's step.
  bool recurs() const {
    for (std::size_t i = 1; i < begin_; ++i)
      if (equals(at(i)) && equals(at(i - 1))) return true;
    return false;
  }

  // Out of the range of all other samples, of which there are many, by more than twice the widest step between
  // them.
  bool is_out_of_reach() const {
    double low = std::numeric_limits<double>::infinity(), high = -low, widest = 0;
    for (std::size_t i = 0; i < begin_; ++i) {
      if (equals(at(i))) continue;
      low = std::min(low, at(i)), high = std::max(high, at(i));
      if (i > 0 && !equals(at(i - 1))) widest = std::max(widest, std::abs(at(i) - at(i - 1)));
    }
    return (value() < low || value() > high) && step() > 2.2 * widest && others().levels > neighbours_of_end;
  }

  // The smallest difference between values: a converter's step, or what counts as equal.
  double gap() const {
    const Others all = others();
    return all.levels > neighbours_of_end ? all.gap : std::numeric_limits<double>::infinity();
  }

  // Whether chance repeats the value so often, the signal going on by `slope` a sample and scattering about that.
  bool is_chance(double gap, double scatter, double slope, double false_alarm) const {
    return std::pow(chance_of_repeat(gap, scatter, slope), static_cast<double>(end_ - begin_ - 1)) >= false_alarm;
  }

 private:
  struct Others {
    std::size_t levels = 0;  // different values
    double gap = 0;
  };

  Others others() const {
    std::vector<double> finite;
    for (std::size_t i = 0; i < begin_; ++i)
      if (std::isfinite(at(i)) && !equals(at(i))) finite.push_back(at(i));
    if (finite.empty()) return {};
    std::sort(finite.begin(), finite.end());
    const ValueGrid grid = grid_of_sorted(finite);
    return {grid.levels, grid.step.value_or(2 * SameValue(finite).within(value()))};
  }

  double at(std::size_t i) const { return reversed_ ? x_[x_.size() - 1 - i] : x_[i]; }

  std::span<const double> x_;
  std::size_t begin_ = 0, end_ = 0;  // of the repeated value
  bool reversed_;
};

double median_modulus(std::vector<double> values) {
  for (double& x : values) x = std::abs(x);
  return values.empty() ? 0 : upper_median(values);
}

double largest_modulus(const std::vector<double>& values) {
  double most = 0;
  for (const double x : values) most = std::max(most, std::abs(x));
  return most;
}

// Sd of white noise among samples; 0 where none is seen. From one order to the next differences of a smooth motion
// become smaller by 2 pi over its samples a turn, those of noise larger by the root of (4k + 2)/(k + 1), nearly 2;
// k-th differences of noise have its variance times the binomial coefficient of 2k and k. Medians pass over
// corners.
double noise_beside(const Tail& tail) {
  constexpr int highest = 6;
  double variance = 2, before = median_modulus(tail.differences(1));
  for (int k = 2; k <= highest; ++k) {
    variance *= (4.0 * k - 2) / k;
    const double here = median_modulus(tail.differences(k));
    if (here > 1.5 * before) return sd_of_median * here / std::sqrt(variance);
    before = here;
  }
  return 0;
}

bool goes_to_zero_continuously(const Channel& channel) {
  return channel.role == ChannelRole::response &&
         (channel.quantity == Quantity::displacement || channel.quantity == Quantity::angle);
}

// Steps are compared half a step of the converter off whole ones: what they are by rounding decides nothing.
bool is_recorded(const Tail& tail, const Channel& channel, End end, bool at_both_ends, double false_alarm) {
  if (!tail.repeats()) return true;
  const bool excitation = channel.role == ChannelRole::excitation;
  if (excitation && (tail.value() == 0 || at_both_ends)) return true;
  if (tail.is_out_of_reach()) return false;
  if (excitation || end == End::first || tail.recurs()) return true;
  const double gap = tail.gap(), step = tail.step(), noise = noise_beside(tail);
  const std::vector<double> second = tail.differences(2);
  if (second.size() + 2 < neighbours_of_end || !(step > 2.5 * gap)) return true;
  if (noise >= 2 * gap) return tail.is_chance(gap, std::sqrt(2.0) * noise, 0, false_alarm);
  if (!goes_to_zero_continuously(channel)) return true;
  return step <= largest_modulus(second) + 2.5 * gap ||
         tail.is_chance(gap, std::sqrt(2.0) * noise, step, false_alarm);
}

void keep(std::vector<double>& values, std::size_t begin, std::size_t end) {
  values.resize(end);
  values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(begin));
}

}  // namespace

RecordedSpan recorded_span(std::span<const double> x, const Channel& channel, double false_alarm) {
  RecordedSpan span{0, x.size()};
  const Tail last(x, x.size(), false), first(x, x.size(), true);
  if (last.of_no_number() == 0 || last.of_one_value() == 0) return span;  // nothing, or one value alone
  const bool at_both_ends = first.repeats() && last.repeats() && first.equals(last.value());
  const auto is_recorded_at = [&](const Tail& tail, End end) {
    return is_recorded(tail, channel, end, at_both_ends, false_alarm);
  };
  span.begin = x.size() - (is_recorded_at(first, End::first) ? first.of_no_number() : first.of_one_value());
  span.end = is_recorded_at(last, End::last) ? last.of_no_number() : last.of_one_value();
  return span;
}

void cut_record(Record& record, std::size_t first, std::size_t count) {
  const std::size_t whole = record.samples();
  const auto keep_within = [&](std::vector<std::size_t>& places) {
    std::erase_if(places, [&](std::size_t place) { return place < first || place >= first + count; });
    for (std::size_t& place : places) place -= first;
  };
  for (std::vector<double>& samples : record.channels) keep(samples, first, first + count);
  std::erase_if(record.unrecorded, [&](const Unrecorded& part) {
    return part.replaced && (part.at_end ? first + count < whole : first > 0);
  });
  keep_within(record.lost);
  keep_within(record.unusable);
  for (std::vector<std::size_t>& places : record.no_numbers) keep_within(places);
  record.start_s += static_cast<double>(first) / record.sample_rate_hz;
}

CutEnds cut_unrecorded(const Campaign& campaign, std::vector<double>& stamps,
                       std::vector<std::vector<double>>& channels) {
  const std::size_t rows = stamps.size();
  const double false_alarm = false_alarm_of_channel(campaign) / 2;  // of one end
  std::size_t begin = 0, end = rows;
  std::vector<RecordedSpan> spans;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    spans.push_back(recorded_span(channels[c], campaign.channels[c], false_alarm));
    if (spans[c].begin > longest_filled) begin = std::max(begin, spans[c].begin);
    if (rows - spans[c].end > longest_filled) end = std::min(end, spans[c].end);
  }
  if (end < begin + fewest_recorded) return {};
  CutEnds cut{begin, rows - (end - begin), {}};
  for (std::size_t c = 0; c < channels.size(); ++c) {
    std::vector<double>& x = channels[c];
    const auto note = [&](bool at_end, std::size_t from, std::size_t to) {
      if (from == to) return;
      const bool few = to - from <= longest_filled && from >= begin && to <= end;
      cut.unrecorded.push_back({c, at_end, to - from, at_end ? x.back() : x.front(), few});
      if (few)
        std::fill(x.begin() + static_cast<std::ptrdiff_t>(from), x.begin() + static_cast<std::ptrdiff_t>(to), NAN);
    };
    note(false, 0, spans[c].begin);
    note(true, spans[c].end, rows);
    keep(x, begin, end);
  }
  keep(stamps, begin, end);
  return cut;
}

}  // namespace secular
