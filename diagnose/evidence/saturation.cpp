#include "diagnose/evidence/saturation.hpp"

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "numerics/distribution.hpp"

namespace secular {
namespace {

/// Noise counts up to so many standard deviations from the level, and not at all below this share of it.
constexpr double reach = 6, least_noise = 1e-9;

/// Points in a quarter of a turn, over which a round corner is averaged.
constexpr int quarter_points = 32;

double density(double x) {
  return std::exp(-0.5 * x * x) / std::sqrt(2 * std::numbers::pi);
}

// E max(x + noise - level, 0): what is cut off above.
double expected_excess(double x, double level, double noise_sd) {
  const double below = (level - x) / noise_sd;
  if (below > reach) return 0;
  if (below < -reach) return x - level;
  return noise_sd * density(below) - noise_sd * below * normal_upper_tail(below);
}

bool quiet(double level, double noise_sd) {
  return noise_sd <= least_noise * level;
}

// cos of the middles of equal parts of a quarter turn.
const std::array<double, quarter_points>& quarter_cosines() {
  static const std::array<double, quarter_points> cosines = [] {
    std::array<double, quarter_points> c{};
    for (int i = 0; i < quarter_points; ++i)
      c[static_cast<std::size_t>(i)] = std::cos((i + 0.5) * std::numbers::pi / (2 * quarter_points));
    return c;
  }();
  return cosines;
}

}  // namespace

double saturated(double value, double level, double noise_sd) {
  if (quiet(level, noise_sd)) return std::clamp(value, -level, level);
  return value - expected_excess(value, level, noise_sd) + expected_excess(-value, level, noise_sd);
}

double saturated_fundamental(double half, double level, double noise_sd) {
  const double peak = 2 * half;
  if (peak <= level - reach * noise_sd) return half;
  if (quiet(level, noise_sd)) {
    if (peak <= level) return half;
    // a sin(t) cut at level: fundamental (2/pi) (a asin(level/a) + level sqrt(1 - (level/a)^2)).
    const double ratio = level / peak;
    return half * 2 / std::numbers::pi * (std::asin(ratio) + ratio * std::sqrt(1 - ratio * ratio));
  }
  double sum = 0;
  for (const double cosine : quarter_cosines()) sum += saturated(peak * cosine, level, noise_sd) * cosine;
  return sum / quarter_points;
}

double unsaturated_amplitude(double shown, double level, double noise_sd) {
  const double most = 50 * level;
  const auto surplus = [&](double half) { return saturated_fundamental(half, level, noise_sd) - shown; };
  const double low = surplus(shown);
  if (low >= 0) return shown;
  const double high = surplus(most);
  if (high <= 0) return most;
  std::uintmax_t limit = 60;
  const auto bracket = boost::math::tools::toms748_solve(surplus, shown, most, low, high,
                                                         boost::math::tools::eps_tolerance<double>(48), limit);
  return 0.5 * (bracket.first + bracket.second);
}

}  // namespace secular
