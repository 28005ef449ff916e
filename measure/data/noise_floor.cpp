#include "measure/data/noise_floor.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>
#include <unsupported/Eigen/FFT>
#include <vector>

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

}  // namespace

std::optional<double> noise_floor(std::span<const double> samples) {
  if (samples.size() < 4 * noise_segment) return std::nullopt;
  std::vector<double> window(noise_segment);
  for (std::size_t i = 0; i < noise_segment; ++i)
    window[i] = 0.5 - 0.5 * std::cos(two_pi * static_cast<double>(i) / static_cast<double>(noise_segment));
  double gain = 0;  // sum of squares: expected power of a bin for unit white noise
  for (const double w : window) gain += w * w;
  constexpr std::size_t first = noise_segment / 4;
  constexpr std::size_t width = (noise_segment / 2 - first) / bands;
  std::vector<std::vector<double>> power(bands);
  Eigen::FFT<double> transform;
  std::vector<double> piece(noise_segment);
  std::vector<std::complex<double>> spectrum;
  for (std::size_t begin = 0; begin + noise_segment <= samples.size(); begin += noise_segment / 2) {
    const auto part = samples.subspan(begin, noise_segment);
    // Removing the line through the ends keeps a drift from leaking into the upper half.
    const double slope = (part.back() - part.front()) / static_cast<double>(noise_segment - 1);
    for (std::size_t i = 0; i < noise_segment; ++i)
      piece[i] = window[i] * (part[i] - part.front() - slope * static_cast<double>(i));
    transform.fwd(spectrum, piece);
    for (std::size_t b = 0; b < bands; ++b) {
      double sum = 0;
      for (std::size_t k = first + b * width; k < first + (b + 1) * width; ++k) sum += std::norm(spectrum[k]);
      power[b].push_back(sum / (gain * static_cast<double>(width)));
    }
  }
  // The Hann window correlates neighbouring bins: half as many are independent.
  double quietest = 0;
  for (std::size_t b = 0; b < bands; ++b) {
    const double level = upper_median(power[b]) / median_of_mean(0.5 * static_cast<double>(width));
    quietest = b == 0 ? level : std::min(quietest, level);
  }
  return std::sqrt(quietest);
}

}  // namespace secular
