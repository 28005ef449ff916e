#include "measure/data/clipping.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "measure/data/noise_floor.hpp"
#include "measure/thresholds.hpp"
#include "numerics/distribution.hpp"
#include "numerics/median.hpp"

namespace secular {
namespace {

constexpr auto& long_run = measure_thresholds().clipped_run;  // judged by itself; shorter ones are together
constexpr std::size_t fewest_points = 4;  // of the parabola beside a run: twice its unknowns, slope and curvature
constexpr auto& fit_depth_in_quanta =
    measure_thresholds().clipping_depth;  // how deep the parabola is fitted at least
constexpr auto& excess_in_quanta =
    measure_thresholds().clipping_excess;  // beyond the flat value; a turning point has at most about one
constexpr auto& fewest_quanta_in_range = measure_thresholds().coarse_levels;
constexpr auto& resting_share =
    measure_thresholds().resting_share;  // of all samples at one extreme: the signal's rest
constexpr auto& two_level_share =
    measure_thresholds().two_level_share;  // of all samples at either extreme: a square wave

// Levels that tell a common divisor: so many whole numbers at random have one with probability 1 - 1/zeta(n), next
// to 2^-n.
std::size_t fewest_levels() {
  return static_cast<std::size_t>(std::ceil(-std::log2(measure_thresholds().clipping_false_alarm)));
}

// Of the range: what tones leave of a noise floor, most (4e-5) where they lie in the upper half of the spectrum.
constexpr double most_leakage = 1e-4;

// How far the signal would have gone beyond the run, judged from one of its ends. depth(n): how far the n-th sample
// outside (n = 1 ... count) lies below the flat value. The run began somewhere between the first sample outside and
// the run, so the parabola starts at that sample: depth(1 + m) = depth(1) + slope*m + curvature*m^2.
double excess(const std::function<double(std::size_t)>& depth, std::size_t count, double quantum) {
  if (count <= fewest_points) return 0;
  const double start = depth(1);
  double m2 = 0, m3 = 0, m4 = 0, y1 = 0, y2 = 0, deepest = 0;
  for (std::size_t m = 1; m < count; ++m) {
    const double y = depth(1 + m) - start;
    if (m > fewest_points && (deepest >= fit_depth_in_quanta * quantum || y < deepest - quantum)) break;
    deepest = std::max(deepest, y);
    const auto x = static_cast<double>(m);
    m2 += x * x;
    m3 += x * x * x;
    m4 += x * x * x * x;
    y1 += x * y;
    y2 += x * x * y;
  }
  const double determinant = m2 * m4 - m3 * m3;  // least squares
  const double slope = (m4 * y1 - m3 * y2) / determinant;
  const double curvature = (m2 * y2 - m3 * y1) / determinant;
  if (slope <= 0) return 0;
  if (curvature <= 0) return std::numeric_limits<double>::infinity();
  return slope * slope / (4 * curvature) - start;
}

// A run of equal samples whose neighbours are both deeper, as the parabola depth = curvature*x^2 through it.
struct Peak {
  double depth = 0;      // of the run below the extreme
  double curvature = 0;  // in samples
  double offset = 0;     // of the parabola's top from the sample next to it: 0 ... 1/2
};

// The parabola that has the run's first and last sample at one depth on average, and passes by its neighbours.
Peak parabola(double depth, double before, double after, std::size_t length) {
  const auto n = static_cast<double>(length);
  const double rise = before + after - 2 * depth;
  const double from_middle = std::min(0.5, n / (n + 1) * std::abs(before - after) / rise);
  return {depth, rise / (2 * n), length % 2 == 1 ? from_middle : 0.5 - from_middle};
}

// Peaks whose largest sample is no deeper than that count; so many of them lie at the very extreme.
bool more_than_chance(const std::vector<Peak>& peaks, std::size_t at_extreme, double deepest, double chance) {
  const auto near =
      std::count_if(peaks.begin(), peaks.end(), [&](const Peak& peak) { return peak.depth <= deepest; });
  return chance < 1 && binomial_upper_tail(static_cast<double>(at_extreme - 1), static_cast<double>(near - 1),
                                           chance) < measure_thresholds().clipping_false_alarm;
}

// Whether more of the short peaks end at the very extreme than those of a smooth motion do.
bool too_many(std::span<const double> samples, const std::vector<Peak>& peaks, double range, double same,
              double quantum) {
  std::vector<double> curvatures;
  double least = 0.5, largest = 0;
  for (const Peak& peak : peaks) {
    if (peak.depth > same) continue;
    curvatures.push_back(peak.curvature);
    least = std::min(least, peak.offset);
    largest = std::max(largest, peak.offset);
  }
  if (curvatures.size() < 2) return false;
  const double curvature = upper_median(curvatures), ratio = quantum / curvature;
  const double half_width = std::sqrt(std::sqrt(ratio));  // of a flat top within a quantum, in samples
  const double offsets_of_one_top = half_width + 0.5 * ratio;
  if (largest - least > offsets_of_one_top)
    return more_than_chance(peaks, curvatures.size(), 0.25 * curvature + same, 2 * half_width);
  // In step with the motion: peaks repeat one but for the noise, of a normal law.
  const double noise = noise_floor(samples).value_or(0);
  if (noise < most_leakage * range) return false;
  return more_than_chance(peaks, curvatures.size(), std::max(0.25 * curvature, 6 * noise) + same,
                          quantum / (noise * std::sqrt(2 * std::numbers::pi)));
}

// The grid that depths of up to a quarter of the range lie on, and the first few levels at least: the greatest
// common divisor of their differences. depth(n): of the n-th sample from the extreme.
double grid_near_extreme(const std::function<double(std::size_t)>& depth_of, std::size_t count, double range,
                         double same) {
  double divisor = 0, level = 0;
  std::size_t levels = 0;
  for (std::size_t n = 0; n < count; ++n) {
    const double depth = depth_of(n);
    if (depth - level <= same) continue;
    if (depth > 0.25 * range && levels >= fewest_levels()) break;
    ++levels;
    double rest = depth - level;
    while (rest > same) {
      const double smaller = std::abs(divisor - rest * std::round(divisor / rest));
      divisor = std::exchange(rest, smaller);
    }
    level = depth;
  }
  return std::max(divisor, same);
}

// What is stuck at one end of the range; sign = -1 turns the smallest value into the largest.
struct Side {
  std::size_t at_extreme = 0, runs = 0;
  std::size_t samples_in_runs = 0;
  std::vector<std::size_t> at;  // all samples at the extreme
};

Side judge_side(std::span<const double> samples, const std::vector<double>& sorted, double sign, double quantum) {
  const double range = sorted.back() - sorted.front(), extreme = sign > 0 ? sorted.back() : sorted.front();
  const double same = SameValue(sorted).within(extreme);
  Side side;
  std::size_t short_runs = 0, samples_in_short_runs = 0;
  double least_step = std::numeric_limits<double>::infinity(), largest_step = 0;  // to the extreme; elsewhere
  std::vector<Peak> peaks;
  const auto depth = [&](std::size_t i) { return sign * (extreme - samples[i]); };
  for (std::size_t begin = 0, end = 0; begin < samples.size(); begin = end) {
    for (end = begin + 1; end < samples.size() && std::abs(depth(end) - depth(begin)) <= same;) ++end;
    const std::size_t length = end - begin;
    const bool at_extreme = depth(begin) <= same;
    if (at_extreme) side.at_extreme += length;
    for (std::size_t i = begin; at_extreme && i < end; ++i) side.at.push_back(i);
    if (begin == 0 || end == samples.size()) continue;
    if (const double before = depth(begin - 1); at_extreme)
      least_step = std::min(least_step, before);
    else if (before > same)
      largest_step = std::max(largest_step, std::abs(before - depth(begin)));
    if (length < long_run) {
      if (depth(begin - 1) <= depth(begin) || depth(end) <= depth(begin)) continue;
      peaks.push_back(parabola(depth(begin), depth(begin - 1), depth(end), length));
      short_runs += at_extreme ? 1 : 0;
      samples_in_short_runs += at_extreme ? length : 0;
      continue;
    }
    if (!at_extreme) continue;
    const double before = excess([&](std::size_t n) { return depth(begin - n); }, begin, quantum);
    const double after = excess([&](std::size_t n) { return depth(end - 1 + n); }, samples.size() - end, quantum);
    if (std::min(before, after) <= excess_in_quanta * quantum) continue;
    ++side.runs;
    side.samples_in_runs += length;
  }
  // What is clipped is on its way to the extreme before; a mark of lost samples lies out of reach.
  if (least_step > 2 * largest_step) return {side.at_extreme, 0, 0, {}};
  const auto nth_depth = [&](std::size_t n) {
    return sign * (extreme - (sign > 0 ? sorted[sorted.size() - 1 - n] : sorted[n]));
  };
  // Levels that are printed rounded have next to no common divisor; a step that all of them have is one of these,
  // too.
  if (too_many(samples, peaks, range, same,
               std::max(quantum, grid_near_extreme(nth_depth, sorted.size(), range, same)))) {
    side.runs += short_runs;
    side.samples_in_runs += samples_in_short_runs;
  }
  return side;
}

}  // namespace

Clipping find_clipping(std::span<const double> samples, const std::vector<double>& sorted, const ValueGrid& grid) {
  Clipping clipping;
  if (samples.empty()) return clipping;
  const double range = sorted.back() - sorted.front(), quantum = grid.step.value_or(0);
  if (!(range > 0) || range < static_cast<double>(fewest_quanta_in_range) * quantum) return clipping;
  const Side top = judge_side(samples, sorted, 1, quantum);
  const Side bottom = judge_side(samples, sorted, -1, quantum);
  const auto share = [&](std::size_t n) { return static_cast<double>(n) / static_cast<double>(samples.size()); };
  const bool two_levels = share(top.at_extreme + bottom.at_extreme) > two_level_share &&
                          share(std::max(top.at_extreme, bottom.at_extreme)) < two_level_share;
  if (two_levels) return clipping;
  const auto take = [&](const Side& side, std::size_t& runs) {
    if (side.runs == 0 || share(side.at_extreme) >= resting_share) return;
    runs = side.runs;
    clipping.samples += side.samples_in_runs;
    clipping.at.insert(clipping.at.end(), side.at.begin(), side.at.end());
  };
  take(top, clipping.runs_high);
  take(bottom, clipping.runs_low);
  std::sort(clipping.at.begin(), clipping.at.end());
  return clipping;
}

}  // namespace secular
