#include "measure/data/noise_floor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "numerics/fourier_transform.hpp"
#include "numerics/hertz.hpp"
#include "numerics/median.hpp"

namespace secular {
namespace {

constexpr std::size_t noise_segment = 256;
constexpr std::size_t bands = 8;  // of 8 bins each, in the upper half of the spectrum

// Median of the mean of n unit exponential variables (Wilson and Hilferty): what the median of a band's power over
// segments has to be divided by.
double median_of_mean(double n) {
  return std::pow(1 - 1 / (9 * n), 3);
}

// What white noise of the levels in the bands of the upper half would have as variance, and the relative standard
// deviation of each level. Empty for fewer than 1024 samples.
struct BandLevels {
  std::vector<double> variance;
  double relative_sd = 0;
};

BandLevels band_levels(std::span<const double> samples) {
  BandLevels result;
  if (samples.size() < 4 * noise_segment) return result;
  std::vector<double> window(noise_segment);
  for (std::size_t i = 0; i < noise_segment; ++i)
    window[i] = 0.5 - 0.5 * std::cos(two_pi * static_cast<double>(i) / static_cast<double>(noise_segment));
  double gain = 0;  // sum of squares: expected power of a bin for unit white noise
  for (const double w : window) gain += w * w;
  constexpr std::size_t first = noise_segment / 4;
  constexpr std::size_t width = (noise_segment / 2 - first) / bands;
  std::vector<std::vector<double>> power(bands);
  Eigen::VectorXd piece(static_cast<Eigen::Index>(noise_segment));
  for (std::size_t begin = 0; begin + noise_segment <= samples.size(); begin += noise_segment / 2) {
    const auto part = samples.subspan(begin, noise_segment);
    // Removing the line through the ends keeps a drift from leaking into the upper half.
    const double slope = (part.back() - part.front()) / static_cast<double>(noise_segment - 1);
    for (std::size_t i = 0; i < noise_segment; ++i)
      piece(static_cast<Eigen::Index>(i)) = window[i] * (part[i] - part.front() - slope * static_cast<double>(i));
    const Eigen::VectorXd powers = half_spectrum(piece).cwiseAbs2();
    for (std::size_t b = 0; b < bands; ++b) {
      double sum = 0;
      for (std::size_t k = first + b * width; k < first + (b + 1) * width; ++k)
        sum += powers(static_cast<Eigen::Index>(k));
      power[b].push_back(sum / (gain * static_cast<double>(width)));
    }
  }
  // The Hann window correlates neighbouring bins: half as many are independent. So are most of the segments that
  // overlap by half. The median of n normal values has the standard deviation of one times sqrt(pi/(2 n)).
  const double independent = 0.5 * static_cast<double>(width);
  for (std::vector<double>& of_band : power)
    result.variance.push_back(upper_median(of_band) / median_of_mean(independent));
  result.relative_sd =
      std::sqrt(std::numbers::pi / 2 / (independent * static_cast<double>(samples.size() / (noise_segment / 2))));
  return result;
}

double variance_of(std::span<const double> samples) {
  const double n = static_cast<double>(samples.size());
  const double mean = std::accumulate(samples.begin(), samples.end(), 0.0) / n;
  double sum = 0;
  for (const double x : samples) sum += (x - mean) * (x - mean);
  return sum / n;
}

}  // namespace

std::optional<double> noise_floor(std::span<const double> samples) {
  constexpr double range_of_eight = 4.99;  // 99 % of the ranges of eight normal values, in standard deviations
  const BandLevels levels = band_levels(samples);
  if (levels.variance.empty()) return std::nullopt;
  const double least = *std::min_element(levels.variance.begin(), levels.variance.end());
  double sum = 0;
  int alike = 0;
  for (const double variance : levels.variance)
    if (variance <= least * (1 + range_of_eight * levels.relative_sd)) {
      sum += variance;
      ++alike;
    }
  return std::sqrt(sum / alike);
}

std::optional<double> flat_noise_floor(std::span<const double> samples) {
  constexpr double range_of_three = 4.12;  // 99 % of the ranges of three normal values, in standard deviations
  const BandLevels levels = band_levels(samples);
  std::optional<double> least;
  for (std::size_t b = 0; b + 3 <= levels.variance.size(); ++b) {
    const std::span<const double> three = std::span(levels.variance).subspan(b, 3);
    const auto [low, high] = std::minmax_element(three.begin(), three.end());
    const double mean = (three[0] + three[1] + three[2]) / 3;
    if (*high - *low <= range_of_three * levels.relative_sd * mean) least = std::min(least.value_or(mean), mean);
  }
  if (!least || *least > 0.5 * variance_of(samples)) return std::nullopt;
  return std::sqrt(*least);
}

}  // namespace secular
