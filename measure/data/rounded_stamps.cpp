#include "measure/data/rounded_stamps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>

#include "measure/thresholds.hpp"

namespace secular {
namespace {

/// Coarsest and finest tick that is looked for, as powers of ten: seconds to microseconds.
constexpr int coarsest = 0, finest = 6;

/// What arithmetic leaves of a stamp, in ticks.
constexpr double exact = 1e-6;

/// Relative difference of rates that a campaign counts as one rate.
constexpr auto& same_rate = measure_thresholds().same_setting;

/// Steps of either length that there are at least. A gap where a sample was lost is a longer step, too: so many at
/// random places are as evenly spread as rounding makes them once in a million (k!/k^k); and one in more than so
/// many steps could be lost regularly, by a buffer.
constexpr std::size_t fewest_steps = 16;
constexpr auto& rarest_share = measure_thresholds().rarest_share;

/// Halvings of an interval of rates, to what doubles hold.
constexpr int halvings = 60;

std::optional<double> tick_of(const std::vector<double>& stamps) {
  for (int digits = coarsest; digits <= finest; ++digits) {
    const double ticks = std::pow(10, digits);
    const auto whole = [&](double t) { return std::abs(t * ticks - std::round(t * ticks)) <= exact; };
    if (std::all_of(stamps.begin(), stamps.end(), whole)) return 1 / ticks;
  }
  return std::nullopt;
}

// Whether steps are a whole number of ticks or one more, and neither is rare.
bool alternates(const std::vector<double>& stamps, double mean_step, double tick) {
  const double shorter = std::floor(mean_step / tick);
  std::size_t long_ones = 0;
  for (std::size_t i = 1; i < stamps.size(); ++i) {
    const double more = std::round((stamps[i] - stamps[i - 1]) / tick) - shorter;
    if (more != 0 && more != 1) return false;
    if (more == 1) ++long_ones;
  }
  const std::size_t steps = stamps.size() - 1, rarer = std::min(long_ones, steps - long_ones);
  const bool clock_stands = shorter == 0 && rarer == long_ones;  // between ticks: no samples are lost at those
  return rarer >= fewest_steps && (clock_stands || rarer >= steps / rarest_share);
}

// Where lines of a given step begin that go through the stamps, one through each.
struct Offsets {
  double low = 0, high = 0;
  double width() const { return high - low; }
};

Offsets offsets(const std::vector<double>& stamps, double step) {
  Offsets found{stamps.front(), stamps.front()};
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    const double offset = stamps[i] - step * static_cast<double>(i);
    found.low = std::min(found.low, offset);
    found.high = std::max(found.high, offset);
  }
  return found;
}

// The width of the offsets is a convex function of the step: least somewhere between two steps.
double best_step(const std::vector<double>& stamps, double low, double high) {
  for (int i = 0; i < halvings; ++i) {
    const double first = low + (high - low) / 3, second = high - (high - low) / 3;
    if (offsets(stamps, first).width() < offsets(stamps, second).width())
      high = second;
    else
      low = first;
  }
  return 0.5 * (low + high);
}

// The last step from `inside` to `outside` at which the offsets are no wider than a tick.
double edge(const std::vector<double>& stamps, double inside, double outside, double tick) {
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (inside + outside);
    (offsets(stamps, middle).width() <= tick ? inside : outside) = middle;
  }
  return inside;
}

double with_digits(double value, int digits) {
  return std::strtod(fmt::format("{:.{}e}", value, digits - 1).c_str(), nullptr);
}

// The rate of fewest digits, of itself or of its step.
double simplest(double low, double high) {
  const double middle = 0.5 * (low + high);
  for (int digits = 1; digits <= 12; ++digits)
    for (const double rate : {with_digits(middle, digits), 1 / with_digits(1 / middle, digits)})
      if (rate >= low && rate <= high) return rate;
  return middle;
}

}  // namespace

std::optional<TimeAxis> axis_of_rounded(const std::vector<double>& stamps, std::optional<double> expected_rate_hz) {
  const double mean_step = (stamps.back() - stamps.front()) / static_cast<double>(stamps.size() - 1);
  const std::optional<double> found = tick_of(stamps);
  if (!found || !(mean_step > 0) || *found <= 0.5 * mean_step) return std::nullopt;
  const double tick = *found * (1 + exact), reach = *found / static_cast<double>(stamps.size() - 1);
  if (!alternates(stamps, mean_step, *found)) return std::nullopt;
  const double low = mean_step - 2 * reach, high = mean_step + 2 * reach;
  if (!(low > 0)) return std::nullopt;
  const double best = best_step(stamps, low, high);
  if (offsets(stamps, best).width() > tick) return std::nullopt;
  const double slowest = 1 / edge(stamps, best, high, tick), fastest = 1 / edge(stamps, best, low, tick);
  if (fastest / slowest - 1 > same_rate) return std::nullopt;
  const bool expected = expected_rate_hz && *expected_rate_hz >= slowest && *expected_rate_hz <= fastest;
  const double rate = expected ? *expected_rate_hz : simplest(slowest, fastest);
  const Offsets line = offsets(stamps, 1 / rate);
  // Rounded to nearest, the line begins within half a tick of every offset: at the first stamp, if it may.
  const double from = line.high - 0.5 * tick, to = line.low + 0.5 * tick;
  return TimeAxis{std::clamp(stamps.front(), std::min(from, to), std::max(from, to)), rate, 0};
}

}  // namespace secular
