#include "measure/disturbances/impulses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "measure/disturbances/rows.hpp"
#include "measure/thresholds.hpp"
#include "numerics/median.hpp"

namespace secular {
namespace {

constexpr auto& impulse_block =
    measure_thresholds().impulse_block;  // of samples that share a scale: their median is known to 15 %

// How far every sample is off the cubic through two neighbours on either side, in units of the median of that over
// the block around it, or beside it where that is larger: motion begins and dies away. Rounding to a lattice
// changes it by 4/3 of a step at most.
struct Roughness {
  std::vector<double> off, relative;  // signed, in the channel's unit; modulus over the block's scale
  double blur = 0;                    // how far rounding may change a relative one, in either direction
};

Roughness roughness(std::span<const double> x, double step) {
  Roughness result{std::vector<double>(x.size(), 0.0), std::vector<double>(x.size(), 0.0), 0};
  for (std::size_t i = 2; i + 2 < x.size(); ++i)
    result.off[i] = x[i] - (4 * (x[i - 1] + x[i + 1]) - x[i - 2] - x[i + 2]) / 6;
  std::vector<double> medians, size;
  for (std::size_t begin = 2; begin + 2 < x.size(); begin += impulse_block) {
    size.clear();
    for (std::size_t i = begin; i < std::min(x.size() - 2, begin + impulse_block); ++i)
      size.push_back(std::abs(result.off[i]));
    medians.push_back(upper_median(size));
  }
  const double rounding = 4.0 / 3 * step;
  for (std::size_t b = 0; b < medians.size(); ++b) {
    const double scale =
        std::max({medians[b == 0 ? 0 : b - 1], medians[b], medians[std::min(b + 1, medians.size() - 1)], rounding});
    if (!(scale > 0)) continue;
    result.blur = std::max(result.blur, rounding / scale);
    for (std::size_t i = 2 + b * impulse_block; i < std::min(x.size() - 2, 2 + (b + 1) * impulse_block); ++i)
      result.relative[i] = std::abs(result.off[i]) / scale;
  }
  return result;
}

bool is_peak(const std::vector<double>& values, std::size_t i) {
  for (const std::size_t j : {i - 2, i - 1, i + 1, i + 2})
    if (values[j] > values[i] || (values[j] == values[i] && j < i)) return false;
  return true;
}

// What values lie beyond a gap in the tail; infinite if none do. In an exponential tail the m+1 values above the
// (m+2)-th have spacings x_i - x_(i+1) that are exponential with means beta/(i+1); m gaps are tried. Values that
// are known to `blur` alone have gaps smaller, and a tail wider, by as much on either side.
double end_of_tail(std::vector<double> values, double blur, double false_alarm) {
  const auto m = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(values.size()))));
  if (m < 16 || values.size() < 2 * m + 1) return INFINITY;
  std::partial_sort(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(2 * m + 1), values.end(),
                    std::greater<>());
  const auto count = static_cast<double>(m);
  // Of the gap over the sum of m spacings, (1 + gap/sum)^-m is the probability.
  const double least_ratio = std::expm1(std::log(count / false_alarm) / count);
  for (std::size_t k = m; k > 0; --k) {
    double sum = 2 * count * blur;
    for (std::size_t i = 1; i <= m; ++i) sum += static_cast<double>(i + 1) * (values[k + i - 1] - values[k + i]);
    const double end = values[k] + least_ratio * sum + 2 * blur;
    if (values[k - 1] > end) return end;
  }
  return INFINITY;
}

// A spike is repaired by putting one sample where its neighbours say: none of them stands out then.
bool is_spike(const Roughness& rough, std::size_t i, double limit) {
  const double scale = std::abs(rough.off[i]) / rough.relative[i], h = rough.off[i];
  const auto stands_out = [&](std::size_t j, double share) {
    return std::abs(rough.off[j] - share * h) > limit * scale;
  };
  return !stands_out(i - 2, 1.0 / 6) && !stands_out(i - 1, -2.0 / 3) && !stands_out(i + 1, -2.0 / 3) &&
         !stands_out(i + 2, 1.0 / 6);
}

// A held sample and what follows it.
bool is_beside_held(const HeldSamples& held, std::size_t i) {
  const auto near = std::lower_bound(held.at.begin(), held.at.end(), i - 2);
  return near != held.at.end() && *near <= i + 2;
}

bool is_of_motion(const SearchedChannel& channel) {
  std::vector<std::size_t> at;
  for (const auto* list : {&channel.impulses.spikes, &channel.impulses.knocks})
    for (const Impulses::One& one : *list) at.push_back(one.at);
  return recurs_with_motion(channel, at);
}

void add(const SearchedRecord& record, std::size_t c, std::string_view kind,
         const std::vector<Impulses::One>& impulses, std::vector<Disturbance>& found) {
  if (impulses.empty()) return;
  const Impulses::One largest = *std::max_element(impulses.begin(), impulses.end(),
                                                  [](const auto& a, const auto& b) { return a.size < b.size; });
  Disturbance entry = record.found(kind, c, largest.size);
  entry.from_s = record.time_s(impulses.front().at);
  entry.to_s = record.time_s(impulses.back().at);
  entry.text = fmt::format("{} sample{} off {} neighbours, the most at {:.6g} s by {:.3g} {}", impulses.size(),
                           impulses.size() == 1 ? "" : "s", impulses.size() == 1 ? "its" : "their",
                           record.time_s(largest.at), entry.size, entry.unit);
  found.push_back(std::move(entry));
}

}  // namespace

Impulses find_impulses(std::span<const double> samples, const ValueGrid& grid, const HeldSamples& held,
                       double false_alarm) {
  Impulses impulses;
  if (samples.size() < 4 * impulse_block) return impulses;
  const Roughness rough = roughness(samples, grid.step.value_or(0));
  std::vector<std::size_t> peaks;
  std::vector<double> sizes;
  for (std::size_t i = 2; i + 2 < samples.size(); ++i)
    if (rough.relative[i] > 0 && is_peak(rough.relative, i)) {
      peaks.push_back(i);
      sizes.push_back(rough.relative[i]);
    }
  const double limit = end_of_tail(sizes, rough.blur, false_alarm);
  for (std::size_t p = 0; p < peaks.size(); ++p)
    if (sizes[p] > limit && !is_beside_held(held, peaks[p]))
      (is_spike(rough, peaks[p], limit) ? impulses.spikes : impulses.knocks)
          .push_back({peaks[p], std::abs(rough.off[peaks[p]])});
  return impulses;
}

bool has_spikes(const SearchedRecord& record, std::size_t c) {
  return (record.entry().kind != RecordKind::impact || !record.is_excitation(c)) &&
         !record.channels[c].impulses.spikes.empty() && !is_of_motion(record.channels[c]);
}

void find_spikes(const SearchedRecord& record, std::vector<Disturbance>& found) {
  for (std::size_t c = 0; c < record.channels.size(); ++c) {
    if (!has_spikes(record, c)) continue;
    add(record, c, "spikes", record.channels[c].impulses.spikes, found);
    found.back().treated = "masked";
  }
}

void find_knocks(const SearchedRecord& record, std::vector<Disturbance>& found) {
  const RecordKind kind = record.entry().kind;
  if (kind == RecordKind::impact) return;  // the blow is the record's subject
  for (std::size_t c = 0; c < record.channels.size(); ++c) {
    if (is_of_motion(record.channels[c])) continue;
    std::vector<Impulses::One> knocks = record.channels[c].impulses.knocks;
    const std::span<const double> samples = record.channels[c].samples;
    const auto largest = std::max_element(samples.begin(), samples.end(),
                                          [](double a, double b) { return std::abs(a) < std::abs(b); });
    // The release or the blow that begins a decay is none of its disturbances.
    if (kind == RecordKind::free_decay)
      std::erase_if(knocks, [&](const Impulses::One& knock) {
        return static_cast<std::ptrdiff_t>(knock.at) <= largest - samples.begin();
      });
    add(record, c, "knock", knocks, found);
  }
}

}  // namespace secular
