#include "measure/disturbances/roughness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "measure/thresholds.hpp"
#include "numerics/median.hpp"

namespace secular {
namespace {

constexpr auto& impulse_block = measure_thresholds().local_samples;

}  // namespace

Roughness roughness(std::span<const double> x, double step) {
  const std::vector<double> none(x.size(), 0.0);
  Roughness result{none, none, none, 0};
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
    for (std::size_t i = 2 + b * impulse_block; i < std::min(x.size() - 2, 2 + (b + 1) * impulse_block); ++i) {
      result.scales[i] = scale;
      result.relative[i] = std::abs(result.off[i]) / scale;
    }
  }
  return result;
}

std::vector<std::size_t> peaks(const Roughness& rough) {
  const std::vector<double>& values = rough.relative;
  const auto is_peak = [&](std::size_t i) {
    for (const std::size_t j : {i - 2, i - 1, i + 1, i + 2})
      if (values[j] > values[i] || (values[j] == values[i] && j < i)) return false;
    return values[i] > 0;
  };
  std::vector<std::size_t> result;
  for (std::size_t i = 2; i + 2 < values.size(); ++i)
    if (is_peak(i)) result.push_back(i);
  return result;
}

double beside_spike(const Roughness& rough, std::size_t i) {
  double along = 0, square = 0, shares = 0;
  for (std::size_t j = 0; j < spike_shares.size(); ++j) {
    const double value = rough.off[i + j - 2];
    along += spike_shares[j] * value;
    shares += spike_shares[j] * spike_shares[j];
    square += value * value;
  }
  return std::sqrt(std::max(0.0, square - along * along / shares)) / rough.scales[i];
}

double beside_corner(const Roughness& rough, std::size_t i) {
  // What a corner at one sample leaves there and around it, but for its size; one between two samples leaves a sum
  // of what corners at both leave.
  constexpr std::array<double, 7> corner = {0, 0, 0.5, -1, 0.5, 0, 0};
  double best = std::numeric_limits<double>::infinity();
  for (const std::size_t shifted : {std::size_t{0}, std::size_t{2}}) {
    double cc = 0, cs = 0, ss = 0, cy = 0, sy = 0, yy = 0;
    for (std::size_t j = 0; j < 5; ++j) {
      const double value = rough.off[i + j - 2], c = corner[j + 1], s = corner[j + shifted];
      cc += c * c;
      cs += c * s;
      ss += s * s;
      cy += c * value;
      sy += s * value;
      yy += value * value;
    }
    const double explained = (ss * cy * cy - 2 * cs * cy * sy + cc * sy * sy) / (cc * ss - cs * cs);
    best = std::min(best, std::sqrt(std::max(0.0, yy - explained)));
  }
  return best / rough.scales[i];
}

}  // namespace secular
