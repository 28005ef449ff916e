#include "measure/disturbances/held_samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "measure/data/chance_of_repeat.hpp"
#include "measure/data/noise_floor.hpp"
#include "measure/disturbances/rows.hpp"
#include "measure/thresholds.hpp"
#include "numerics/distribution.hpp"
#include "numerics/median.hpp"

namespace secular {
namespace {

constexpr auto& neighbours = measure_thresholds().local_samples;  // values in order that share the smallest gap

// Samples that share the scatter of differences: a hold of up to two local stretches leaves their median to the
// others.
std::size_t block() {
  return 4 * measure_thresholds().local_samples;
}

// The smallest gap between different values near a value: at least the step of whatever lattice is there.
class LocalGaps {
 public:
  explicit LocalGaps(const std::vector<double>& sorted) {
    const SameValue same(sorted);
    const std::vector<ValueLevel> levels = levels_of_sorted(sorted, same);
    for (std::size_t begin = 0; begin < levels.size(); begin += neighbours) {
      double gap = std::numeric_limits<double>::infinity();
      const std::size_t end = std::min(levels.size(), begin + neighbours + 1);
      for (std::size_t i = end - std::min(end, neighbours + 1) + 1; i < end; ++i)
        gap = std::min(gap, levels[i].value - levels[i - 1].value);
      first_.push_back(levels[begin].value);
      gap_.push_back(std::max(gap, 2 * same.within(levels[begin].value)));
    }
  }
  double at(double value) const {
    const auto next = std::upper_bound(first_.begin(), first_.end(), value);
    return gap_[next == first_.begin() ? 0 : static_cast<std::size_t>(next - first_.begin()) - 1];
  }

 private:
  std::vector<double> first_, gap_;
};

// What the samples around tell of the difference x[i] - x[i-1] without these two: from one on either side, which is
// right for a straight line and a parabola, or from two, which is right up to the fourth degree.
double difference_from_one(std::span<const double> x, std::size_t i) {
  return (x[i + 1] - x[i - 2]) / 3;
}
double difference_from_two(std::span<const double> x, std::size_t i) {
  return 0.5 * (x[i + 1] - x[i - 2]) - 0.1 * (x[i + 2] - x[i - 3]);
}

// How a block's samples differ from what is told by the better of the two.
struct BlockScatter {
  double sd = 0;
  bool from_two = false;
};

std::vector<BlockScatter> scatters(std::span<const double> x) {
  std::vector<BlockScatter> result;
  std::vector<double> one, two;
  for (std::size_t begin = 3; begin + 2 < x.size(); begin += block()) {
    one.clear();
    two.clear();
    for (std::size_t i = begin; i < std::min(begin + block(), x.size() - 2); ++i) {
      one.push_back(std::abs(x[i] - x[i - 1] - difference_from_one(x, i)));
      two.push_back(std::abs(x[i] - x[i - 1] - difference_from_two(x, i)));
    }
    const double by_one = sd_of_median * upper_median(one), by_two = sd_of_median * upper_median(two);
    result.push_back({std::min(by_one, by_two), by_two < by_one});
  }
  return result;
}

// Slope per sample around samples that equal the one before, from `i` to before `end`, and the scatter about it.
struct LocalSlope {
  double slope = 0, scatter = 0;
};

LocalSlope slope_around(std::span<const double> x, std::size_t i, std::size_t end, const BlockScatter& usual,
                        double noise) {
  LocalSlope local{0, usual.sd};
  if (end == i + 1 && usual.from_two) {
    local.slope = std::abs(difference_from_two(x, i));
    if (local.slope <= usual.sd) local.slope = 0;
  } else {  // the smaller of that before and that across
    const double before = x[i - 1] - x[i - 2];
    const double across = (x[end] - x[i - 1]) / static_cast<double>(end - i + 1);
    if (before * across > 0) local.slope = std::min(std::abs(before), std::abs(across));
  }
  // Where sampling is in step with the motion, neighbours at a turning point differ by noise alone.
  if (local.slope == 0) local.scatter = std::min(usual.sd, noise);
  return local;
}

/// Repeats are counted among samples of which chance repeats no more than this share.
constexpr std::array rarities = {1.0, 0.1, 0.01, 0.001};

// Samples, those among them that repeat the one before, and what chance makes of these at most, by rarity.
struct Repeats {
  std::array<double, rarities.size()> samples{}, expected{};
  std::array<std::size_t, rarities.size()> runs{};

  void see(double probability, bool repeated) {
    for (std::size_t r = 0; r < rarities.size(); ++r)
      if (probability <= rarities[r]) {
        samples[r] += 1;
        expected[r] += probability;
        runs[r] += repeated ? 1 : 0;
      }
  }
  // The share of samples that are held, where chance hardly explains all that repeat; else 0. (At least that many
  // by chance: the sum of as many waiting times is below the expected number.)
  double held_share(double false_alarm) const {
    double least = false_alarm / static_cast<double>(rarities.size()), share = 0;
    for (std::size_t r = 0; r < rarities.size(); ++r) {
      const double tail = poisson_upper_tail(runs[r], expected[r]);
      if (!(tail < least)) continue;
      least = tail;
      share = (static_cast<double>(runs[r]) - expected[r]) / samples[r];
    }
    return share;
  }
};

}  // namespace

HeldSamples find_held(std::span<const double> x, const ChannelValues& values, double false_alarm) {
  HeldSamples held;
  if (x.size() < block() || values.clipping.found() || !(values.sorted.back() > values.sorted.front())) return held;
  bool any = false;
  const SameValue same(values.sorted);
  const auto equals = [&](std::size_t i, std::size_t j) { return same(x[i], x[j]); };
  for (std::size_t i = 3; i + 2 < x.size() && !any; ++i) any = equals(i, i - 1);
  if (!any) return held;
  const LocalGaps gaps(values.sorted);
  const std::vector<BlockScatter> scatter = scatters(x);
  const double noise = noise_floor(x).value_or(std::numeric_limits<double>::infinity());
  Repeats repeats;
  std::vector<std::pair<HeldSamples::Run, double>> chances;
  for (std::size_t i = 3; i + 2 < x.size(); ++i) {
    std::size_t end = i + 1;
    const bool equal = equals(i, i - 1);
    if (equal)
      while (end < x.size() && equals(end, i)) ++end;
    if (end == x.size()) break;
    if (i == 3 && equal && equals(1, 0) && equals(2, 1)) {  // at rest, until the record's motion begins
      i = end - 1;
      continue;
    }
    const LocalSlope local = slope_around(x, i, end, scatter[(i - 3) / block()], noise);
    const double p = chance_of_repeat(gaps.at(x[i - 1]), local.scatter, local.slope);
    repeats.see(p, equal);
    if (!equal) continue;
    if (p < 0.5) held.likely.push_back({i, end});
    chances.push_back({{i, end}, p});
    i = end - 1;
  }
  held.expected = repeats.expected.front();
  const double share = repeats.held_share(false_alarm);
  // Of a repeat the odds are share to p that it is held. A run that chance does not make in the whole record is
  // held however few others are.
  const auto is_too_long = [&](const HeldSamples::Run& run, double p) {
    return std::pow(p, static_cast<double>(run.end - run.begin)) * static_cast<double>(x.size()) < false_alarm;
  };
  for (const auto& [run, p] : chances)
    if (p < share || is_too_long(run, p)) held.runs.push_back(run);
  return held;
}

void find_held_samples(const SearchedRecord& record, std::vector<Disturbance>& found) {
  for (std::size_t c = 0; c < record.channels.size(); ++c) {
    const HeldSamples& held = record.channels[c].wrong.held;
    if (held.runs.empty()) continue;
    std::size_t samples = 0;
    for (const HeldSamples::Run& run : held.runs) samples += run.end - run.begin;
    Disturbance entry = record.found("held_samples", c, static_cast<double>(samples));
    entry.unit = "samples";
    if (record.channels[c].is_held) entry.treated = record.channels[c].treated_as();
    if (!record.doubled.empty()) entry.treated = "removed";
    entry.share = entry.size / static_cast<double>(record.samples());
    entry.from_s = record.time_s(held.runs.front().begin);
    entry.to_s = record.time_s(held.runs.back().end);
    entry.text = fmt::format(
        "{} samples repeat the one before although the signal went on ({} places; by chance "
        "{:.2g} at most), first at {:.6g} s",
        samples, held.runs.size(), held.expected, entry.from_s);
    if (const std::size_t foreign = record.channels[c].wrong.foreign.size(); foreign > 0)
      entry.text += fmt::format("; {} of those before them {} no measured value{} either", foreign,
                                foreign == 1 ? "is" : "are", foreign == 1 ? "" : "s");
    if (!record.doubled.empty())
      entry.text += fmt::format(
          "; {} are rows that the file holds twice, for what follows goes on as if they were not there: taken out, "
          "and the record is {:.3g} % shorter",
          record.doubled.size(),
          100 * static_cast<double>(record.doubled.size()) / static_cast<double>(record.samples()));
    found.push_back(std::move(entry));
  }
}

}  // namespace secular
