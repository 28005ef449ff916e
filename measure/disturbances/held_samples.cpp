#include "measure/disturbances/held_samples.hpp"

#include <fmt/format.h>

#include <algorithm>
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

constexpr auto& block = measure_thresholds().held_block;  // of samples that share the scatter of differences
constexpr auto& neighbours = measure_thresholds().held_neighbours;  // values in order that share the smallest gap
constexpr double sd_of_median = 1.4826;  // normal law: sd over the median of absolute values

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

// Slope per sample around a run of equal samples that begins at `i` and ends before `end`: the smaller of that
// before it and that across it.
double slope_around(std::span<const double> x, std::size_t i, std::size_t end) {
  const double before = x[i - 1] - x[i - 2];
  const double across = (x[end] - x[i - 1]) / static_cast<double>(end - i + 1);
  return before * across > 0 ? std::min(std::abs(before), std::abs(across)) : 0;
}

// Sd of differences about the slope of their neighbours, by block.
std::vector<double> scatters(std::span<const double> x) {
  std::vector<double> result, rest;
  for (std::size_t begin = 2; begin + 1 < x.size(); begin += block) {
    rest.clear();
    for (std::size_t i = begin; i < std::min(begin + block, x.size() - 1); ++i)
      rest.push_back(std::abs(x[i] - x[i - 1] - (x[i + 1] - x[i - 2]) / 3));
    result.push_back(sd_of_median * upper_median(rest));
  }
  return result;
}

}  // namespace

HeldSamples find_held(std::span<const double> x, const ChannelValues& values, double false_alarm) {
  HeldSamples held;
  if (x.size() < block || values.clipping.found() || !(values.sorted.back() > values.sorted.front())) return held;
  bool any = false;
  const SameValue same(values.sorted);
  const auto equals = [&](std::size_t i, std::size_t j) { return same(x[i], x[j]); };
  for (std::size_t i = 2; i + 1 < x.size() && !any; ++i) any = equals(i, i - 1);
  if (!any) return held;
  const LocalGaps gaps(values.sorted);
  const std::vector<double> scatter = scatters(x);
  const double noise = noise_floor(x).value_or(std::numeric_limits<double>::infinity());
  std::size_t runs = 0;
  std::vector<HeldSamples::Run> long_ones;  // that chance does not make in the whole record
  for (std::size_t i = 2; i + 1 < x.size(); ++i) {
    std::size_t end = i + 1;
    const bool equal = equals(i, i - 1);
    if (equal)
      while (end < x.size() && equals(end, i)) ++end;
    if (end == x.size()) break;
    if (i == 2 && equal && equals(1, 0)) {  // at rest, until the record's motion begins
      i = end - 1;
      continue;
    }
    const double slope = slope_around(x, i, end), around = scatter[(i - 2) / block];
    // Where sampling is in step with the motion, neighbours at a turning point differ by noise alone.
    const double p = chance_of_repeat(gaps.at(x[i - 1]), slope > 0 ? around : std::min(around, noise), slope);
    held.expected += p;
    if (!equal) continue;
    ++runs;
    // More likely held than not, as far as there are as many held as chance makes.
    if (p < 0.5) held.likely.push_back({i, end});
    if (std::pow(p, static_cast<double>(end - i)) * static_cast<double>(x.size()) < false_alarm)
      long_ones.push_back({i, end});
    i = end - 1;
  }
  // At least that many by chance: the sum of as many waiting times is below the expected number.
  const double probability = poisson_upper_tail(runs, held.expected);
  held.runs = probability > false_alarm ? std::move(long_ones) : held.likely;
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
    if (record.channels[c].is_held) entry.treated = "masked";
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
    found.push_back(std::move(entry));
  }
}

}  // namespace secular
