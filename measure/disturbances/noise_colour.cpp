#include "measure/disturbances/noise_colour.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "measure/disturbances/lines.hpp"
#include "numerics/distribution.hpp"

namespace secular {
namespace {

/// What a missing term makes of a motion that changes is within this share of the distance between two multiples on
/// either side of each: half of all bins are left.
constexpr double about_a_multiple = 0.25;

/// Of the window of the lines, in bins: so many bins share their noise.
constexpr double noise_bandwidth = 2;

/// Parts of a record are told by whether the motion is louder there than in half of them: twice so many.
constexpr std::size_t halves_of_blocks = 8;

struct Bin {
  double angle, power;  ///< angle: rad from sample to sample
};

std::vector<Bin> free_bins(std::span<const double> left, std::span<const double> motion) {
  const std::size_t length = left.size() / 2 * 2;
  const std::vector<double> window = lobe_window(length), powers = windowed_powers(left.first(length), window),
                            moved = windowed_powers(motion.first(length), window);
  double gain = 0;
  for (const double w : window) gain += w * w;
  const auto first = static_cast<std::size_t>(lobe_bins);
  const auto line = static_cast<double>(
      std::max_element(moved.begin() + static_cast<std::ptrdiff_t>(first), moved.end()) - moved.begin());
  std::vector<Bin> bins;
  for (std::size_t k = first; k < powers.size(); ++k) {
    const double order = static_cast<double>(k) / line;
    if (order > about_a_multiple && std::abs(order - std::round(order)) <= about_a_multiple &&
        std::round(order) >= 1)
      continue;
    bins.push_back({2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(length), powers[k] / gain});
  }
  return bins;
}

// Of a first-order process of variance one.
double spectrum_at(double angle, double keeps) {
  return (1 - keeps * keeps) / (1 - 2 * keeps * std::cos(angle) + keeps * keeps);
}

// Minus twice the logarithm of the likelihood, but for what is common, with the likeliest level of the white noise.
struct Fit {
  double deviance, white;
};

Fit fit_of(const std::vector<Bin>& bins, const std::vector<double>& shape, double ratio) {
  double sum = 0, logarithms = 0;
  for (std::size_t b = 0; b < bins.size(); ++b) {
    const double level = 1 + ratio * shape[b];
    sum += bins[b].power / level;
    logarithms += std::log(level);
  }
  const auto count = static_cast<double>(bins.size());
  return {2 / noise_bandwidth * (count * std::log(sum / count) + logarithms), sum / count};
}

}  // namespace

std::optional<NoiseColour> find_noise_colour(std::span<const double> left, std::span<const double> motion,
                                             double rate_hz, double false_alarm) {
  if (left.size() < 8 * static_cast<std::size_t>(line_reach)) return std::nullopt;
  const std::vector<Bin> bins = free_bins(left, motion);
  std::vector<double> shape(bins.size(), 0.0);
  const double white = fit_of(bins, shape, 0).deviance;
  // Correlation times from two samples to a quarter of the record, ratios of variances that a record can tell.
  const double longest = 0.25 * static_cast<double>(left.size());
  double best = white, octaves = 0;
  NoiseColour colour;
  for (double samples = 2; samples < longest; samples *= std::pow(2, 0.125), octaves += 0.125) {
    const double keeps = std::exp(-1 / samples);
    for (std::size_t b = 0; b < bins.size(); ++b) shape[b] = spectrum_at(bins[b].angle, keeps);
    for (double ratio = 1e-3; ratio < 1e6; ratio *= 1.1) {
      const Fit fit = fit_of(bins, shape, ratio);
      if (!(fit.deviance < best)) continue;
      best = fit.deviance;
      colour = {std::sqrt(ratio * fit.white), samples / rate_hz, std::sqrt(fit.white)};
    }
  }
  if (octaves * chi_squared_upper_tail(white - best, 2) > false_alarm) return std::nullopt;
  return colour;
}

bool follows(const NoiseColour& colour, std::span<const double> left, std::span<const double> motion,
             double rate_hz, double false_alarm) {
  struct Block {
    double motion, left;  // sums of squares
  };
  const std::size_t length = left.size() / halves_of_blocks / 2;
  std::vector<Block> blocks;
  for (std::size_t begin = 0; begin + length <= left.size() && length > 0; begin += length) {
    const auto square = [&](std::span<const double> all) {
      const auto part = all.subspan(begin, length);
      return std::inner_product(part.begin(), part.end(), part.begin(), 0.0);
    };
    blocks.push_back({square(motion), square(left)});
  }
  std::stable_sort(blocks.begin(), blocks.end(),
                   [](const Block& a, const Block& b) { return a.motion < b.motion; });
  double quiet = 0, loud = 0;
  for (std::size_t b = 0; b < blocks.size() / 2; ++b) {
    quiet += blocks[b].left;
    loud += blocks[blocks.size() - 1 - b].left;
  }
  // Of a first-order process of variance s^2 the mean of n squares varies by 2 s^4/n (1 + q^2)/(1 - q^2).
  const double keeps = std::exp(-1 / (rate_hz * colour.time_s)),
               freedom =
                   static_cast<double>(blocks.size() / 2 * length) * (1 - keeps * keeps) / (1 + keeps * keeps);
  return f_upper_tail(std::max(loud / quiet, quiet / loud), freedom, freedom) < 0.5 * false_alarm;
}

}  // namespace secular
