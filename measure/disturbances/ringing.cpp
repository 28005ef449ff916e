#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "measure/disturbances/motion_tones.hpp"
#include "measure/disturbances/rows.hpp"
#include "measure/signal/transform_length.hpp"
#include "measure/thresholds.hpp"
#include "numerics/distribution.hpp"
#include "numerics/median.hpp"

namespace secular {
namespace {

constexpr std::size_t most_late_blocks = 32;  // the F law with 64 degrees of freedom is near its limit
constexpr auto& shortest_block = measure_thresholds().local_samples;

// A line at the record's begin that has gone in its second half.
struct Ring {
  std::size_t length = 0;  // samples of the block that shows it best
  double frequency_hz = 0;
  double ratio = 0;                        // of the first block to the late ones
  double first = 0, second = 0, late = 0;  // powers
};

// Blocks of one length: the first two, and those of the second half.
void look_through(std::span<const double> samples, std::size_t length, double rate, double of_bin,
                  std::vector<Ring>& rings) {
  const std::vector<double> window = lobe_window(length);
  const std::vector<double> first = windowed_powers(samples.first(length), window),
                            second = windowed_powers(samples.subspan(length, length), window);
  std::vector<double> late(first.size(), 0.0), ratios;
  const std::size_t half = samples.size() / 2, blocks = std::min(most_late_blocks, half / length);
  const std::size_t hop = (half - length) / (blocks - 1);
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::vector<double> powers = windowed_powers(samples.subspan(half + b * hop, length), window);
    for (std::size_t k = 0; k < late.size(); ++k) late[k] += powers[k] / static_cast<double>(blocks);
  }
  const auto lobe = static_cast<std::size_t>(lobe_bins);
  if (late.size() < 4 * lobe) return;
  for (std::size_t k = lobe; k + lobe < late.size(); ++k) ratios.push_back(first[k] / late[k]);
  const double louder = std::max(1.0, upper_median(ratios));  // noise that is louder at the begin, all over
  for (std::size_t k = lobe; k + lobe < late.size(); ++k) {
    if (first[k] <= first[k - 1] || first[k] < first[k + 1] || second[k] >= first[k]) continue;
    const double ratio = first[k] / (louder * late[k]);
    if (!(late[k] > 0) || f_upper_tail(ratio, 2, 2 * static_cast<double>(blocks)) > of_bin) continue;
    const double before = std::log(first[k - 1]), here = std::log(first[k]), after = std::log(first[k + 1]);
    const double offset = 0.5 * (before - after) / (before - 2 * here + after);
    rings.push_back({length, (static_cast<double>(k) + offset) * rate / static_cast<double>(length), ratio,
                     first[k], second[k], late[k]});
  }
}

// The clearest of those that are within each other's lobes.
std::vector<Ring> apart(std::vector<Ring> rings, double rate) {
  std::stable_sort(rings.begin(), rings.end(), [](const Ring& a, const Ring& b) { return a.ratio > b.ratio; });
  std::vector<Ring> kept;
  for (const Ring& ring : rings)
    if (std::none_of(kept.begin(), kept.end(), [&](const Ring& other) {
          const auto shorter = static_cast<double>(std::min(ring.length, other.length));
          return std::abs(ring.frequency_hz - other.frequency_hz) < lobe_bins * rate / shorter;
        }))
      kept.push_back(ring);
  return kept;
}

std::vector<Ring> rings_of(const SearchedRecord& record, const SearchedChannel& channel) {
  std::vector<Ring> rings;
  const std::size_t samples = channel.intact.size();
  const double of_bin = record.level / (static_cast<double>(samples) / 16);  // bins of all lengths together
  for (std::size_t length = samples / 16; length >= shortest_block; length /= 2)
    look_through(channel.intact, static_cast<std::size_t>(cut_transform_length(static_cast<Eigen::Index>(length))),
                 record.rate, of_bin, rings);
  return apart(std::move(rings), record.rate);
}

Disturbance described(const SearchedRecord& record, std::size_t c, const Ring& ring) {
  // Powers fall by exp(-2 rate t) from block to block.
  const double block_s = static_cast<double>(ring.length) / record.rate;
  const double rate = std::log(ring.first / std::max(ring.second, ring.late)) / (2 * block_s);
  const std::vector<double> window = lobe_window(ring.length);
  double sum = 0, whole = 0;
  for (std::size_t i = 0; i < ring.length; ++i) {
    sum += window[i] * std::exp(-rate * static_cast<double>(i) / record.rate);
    whole += window[i];
  }
  Disturbance found = record.found_in_intact("neighbour_mode", c, 2 * std::sqrt(ring.first) / sum);
  found.frequency_hz = ring.frequency_hz;
  const double noise = 2 * std::sqrt(ring.late) / whole;
  if (rate > 0 && found.size > noise)
    found.to_s = std::min(found.to_s, record.start_s + std::log(found.size / noise) / rate);
  found.text =
      fmt::format("rings at {:.4g} Hz with {:.3g} {} at the begin, falling by {:.2g} 1/s{}", ring.frequency_hz,
                  found.size, found.unit, rate, ring.second > ring.late ? "" : " or faster");
  return found;
}

}  // namespace

void find_ringing(const SearchedRecord& record, std::vector<Disturbance>& found) {
  if (record.entry().kind != RecordKind::dwell || record.samples() < 16 * shortest_block) return;
  const MotionTones motion(record);
  std::vector<std::vector<Ring>> rings;
  std::vector<double> all;
  for (std::size_t c = 0; c < record.channels.size(); ++c) {
    rings.emplace_back();
    // What rings does so from the begin on; a break sounds like it.
    if (record.is_excitation(c) || record.channels[c].intact_from() > 0) continue;
    rings.back() = rings_of(record, record.channels[c]);
    for (const Ring& ring : rings.back()) all.push_back(ring.frequency_hz);
  }
  for (std::size_t c = 0; c < rings.size(); ++c)
    for (const Ring& ring : rings[c]) {
      // The frequency is known to a quarter of the block's bin: it decays there.
      if (motion.start_at(ring.frequency_hz, all, 0.25 * record.rate / static_cast<double>(ring.length))) continue;
      found.push_back(described(record, c, ring));
    }
}

}  // namespace secular
