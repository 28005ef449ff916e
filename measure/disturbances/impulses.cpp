#include "measure/disturbances/impulses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "measure/disturbances/roughness.hpp"
#include "measure/disturbances/rows.hpp"
#include "measure/thresholds.hpp"

namespace secular {
namespace {

constexpr int most_spike_rounds = 8;

// Of a hundred wrong samples one is not told from a corner of the motion.
constexpr auto& not_told = measure_thresholds().spikes_not_told;

// Of a corner of the motion so much is left beside a spike, next to its own size (beside_spike): off it leaves
// c = (0, 1/2, -1, 1/2, 0), of which (c's)^2/(s's) lies along the spike's shares s, and c'c - (c's)^2/(s's) = 1/14.
constexpr double left_by_a_corner = 0.26726124191242440;

// What values follow beyond their upper quarter, if they fall exponentially there as they do from the middle to it:
// the one that a value exceeds with that probability. Of a normal law this is too large. As long as less than a
// quarter of all values are of another kind, they move it little. Values that are known to `blur` alone have
// distances larger by as much on either side.
double beyond_most(std::vector<double> values, double blur, double probability) {
  if (values.size() < 2 * 16) return INFINITY;
  const auto at = [&](double share) {
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
    std::nth_element(values.begin(), place, values.end());
    return *place;
  };
  const double middle = at(0.5), quarter = at(0.75);
  return quarter + 2 * blur + (quarter - middle + 2 * blur) / std::log(2.0) * std::log(0.25 / probability);
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
  const double scale = rough.scales[i], h = rough.off[i];
  for (std::size_t j = 0; j < spike_shares.size(); ++j)
    if (std::abs(rough.off[i + j - 2] - spike_shares[j] * h) > limit * scale) return false;
  return true;
}

// A sample that one of a held run, or the one before it, is among the neighbours of.
bool is_beside_held(const HeldSamples& held, std::size_t i) {
  const auto near = std::partition_point(held.runs.begin(), held.runs.end(),
                                         [&](const HeldSamples::Run& run) { return run.end + 2 <= i; });
  return near != held.runs.end() && near->begin <= i + 3;
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
  if (samples.size() < 4 * measure_thresholds().local_samples) return impulses;
  std::vector<double> x(samples.begin(), samples.end());
  for (int round = 0; round < most_spike_rounds; ++round) {
    const Roughness rough = roughness(x, grid.step.value_or(0));
    const std::vector<std::size_t> all = peaks(rough);
    std::vector<double> sizes, beside;
    for (const std::size_t i : all) {
      sizes.push_back(rough.relative[i]);
      beside.push_back(beside_spike(rough, i));
    }
    const double limit = end_of_tail(sizes, rough.blur, false_alarm);
    impulses.many = beyond_most(sizes, rough.blur, false_alarm / static_cast<double>(all.size()));
    impulses.scales = rough.scales;
    const double alone = beyond_most(beside, rough.blur, not_told);
    std::vector<Impulses::One> spikes;
    impulses.knocks.clear();
    for (std::size_t p = 0; p < all.size(); ++p) {
      const Impulses::One one = {all[p], std::abs(rough.off[all[p]])};
      if (is_beside_held(held, one.at)) continue;
      const bool is_mended = sizes[p] > limit && is_spike(rough, one.at, limit);
      const bool stands_alone =
          sizes[p] > impulses.many && beside[p] <= alone && left_by_a_corner * sizes[p] > alone;
      if ((is_mended || stands_alone) && beside[p] < beside_corner(rough, one.at))
        spikes.push_back(one);
      else if (sizes[p] > limit)
        impulses.knocks.push_back(one);
    }
    if (spikes.empty()) break;
    for (const Impulses::One& one : spikes) x[one.at] -= rough.off[one.at];
    impulses.spikes.insert(impulses.spikes.end(), spikes.begin(), spikes.end());
  }
  std::sort(impulses.spikes.begin(), impulses.spikes.end(),
            [](const auto& a, const auto& b) { return a.at < b.at; });
  return impulses;
}

void find_spikes(const SearchedRecord& record, std::vector<Disturbance>& found) {
  for (std::size_t c = 0; c < record.channels.size(); ++c) {
    if (!record.channels[c].has_spikes) continue;
    add(record, c, "spikes", record.channels[c].wrong.impulses.spikes, found);
    found.back().treated = record.channels[c].treated_as();
  }
}

void find_knocks(const SearchedRecord& record, std::vector<Disturbance>& found) {
  for (std::size_t c = 0; c < record.channels.size(); ++c) {
    if (!record.channels[c].has_knocks) continue;
    std::vector<Impulses::One> knocks = record.channels[c].wrong.impulses.knocks;
    const std::span<const double> samples = record.channels[c].samples;
    const double mean = std::accumulate(samples.begin(), samples.end(), 0.0) / static_cast<double>(samples.size());
    const auto largest = std::max_element(samples.begin(), samples.end(), [&](double a, double b) {
      return std::abs(a - mean) < std::abs(b - mean);
    });
    // The release or the blow that begins a decay is none of its disturbances.
    if (record.entry().kind == RecordKind::free_decay)
      std::erase_if(knocks, [&](const Impulses::One& knock) {
        return static_cast<std::ptrdiff_t>(knock.at) <= largest - samples.begin();
      });
    add(record, c, "knock", knocks, found);
  }
}

}  // namespace secular
