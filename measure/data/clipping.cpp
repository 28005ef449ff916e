#include "measure/data/clipping.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "measure/data/resolution.hpp"

namespace secular {
namespace {

constexpr std::size_t shortest_run = 4;
constexpr std::size_t fewest_points = 4;    // of the parabola beside a run
constexpr double fit_depth_in_quanta = 16;  // how deep the parabola is fitted at least
constexpr double excess_in_quanta = 8;      // beyond the flat value; a turning point has at most about one
constexpr double fewest_quanta_in_range = 64;
constexpr double resting_share = 0.6;     // of all samples at one extreme: the signal's rest
constexpr double two_level_share = 0.95;  // of all samples at either extreme: a square wave

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

// What is stuck at one end of the range; sign = -1 turns the smallest value into the largest.
struct Side {
  std::size_t at_extreme = 0, runs = 0, samples_in_runs = 0;
};

Side judge_side(std::span<const double> samples, double sign, double extreme, double same, double quantum) {
  Side side;
  const auto depth = [&](std::size_t i) { return sign * (extreme - samples[i]); };
  for (std::size_t begin = 0, end = 0; begin < samples.size(); begin = end + 1) {
    for (end = begin; end < samples.size() && depth(end) <= same;) ++end;
    const std::size_t length = end - begin;
    side.at_extreme += length;
    if (length < shortest_run || begin == 0 || end == samples.size()) continue;
    const double before = excess([&](std::size_t n) { return depth(begin - n); }, begin, quantum);
    const double after = excess([&](std::size_t n) { return depth(end - 1 + n); }, samples.size() - end, quantum);
    if (std::min(before, after) <= excess_in_quanta * quantum) continue;
    ++side.runs;
    side.samples_in_runs += length;
  }
  return side;
}

}  // namespace

Clipping find_clipping(std::span<const double> samples) {
  Clipping clipping;
  if (samples.empty()) return clipping;
  const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
  const double range = *high - *low;
  const double quantum = value_grid(samples).step.value_or(0);
  if (!(range > 0) || range < fewest_quanta_in_range * quantum) return clipping;
  const double same = 1e-9 * range;  // differences by arithmetic on a stuck value
  const Side top = judge_side(samples, 1, *high, same, quantum);
  const Side bottom = judge_side(samples, -1, *low, same, quantum);
  const auto share = [&](std::size_t n) { return static_cast<double>(n) / static_cast<double>(samples.size()); };
  const bool two_levels = share(top.at_extreme + bottom.at_extreme) > two_level_share &&
                          share(std::max(top.at_extreme, bottom.at_extreme)) < two_level_share;
  if (two_levels) return clipping;
  if (share(top.at_extreme) < resting_share) {
    clipping.runs_high = top.runs;
    clipping.samples += top.samples_in_runs;
  }
  if (share(bottom.at_extreme) < resting_share) {
    clipping.runs_low = bottom.runs;
    clipping.samples += bottom.samples_in_runs;
  }
  return clipping;
}

}  // namespace secular
