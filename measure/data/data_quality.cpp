#include "measure/data/data_quality.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "measure/data/clipping.hpp"
#include "measure/data/noise_floor.hpp"
#include "measure/data/number_range.hpp"
#include "measure/data/resolution.hpp"
#include "measure/thresholds.hpp"

namespace secular {
namespace {

constexpr std::size_t offset_blocks = 16;
constexpr auto& coarse_levels = measure_thresholds().coarse_levels;

// The longest stretch without a missing sample: what spectra and runs are looked for in.
std::span<const double> longest_finite(std::span<const double> samples) {
  std::size_t best_begin = 0, best_size = 0, begin = 0;
  for (std::size_t i = 0; i <= samples.size(); ++i) {
    if (i < samples.size() && std::isfinite(samples[i])) continue;
    if (i - begin > best_size) {
      best_begin = begin;
      best_size = i - begin;
    }
    begin = i + 1;
  }
  return samples.subspan(best_begin, best_size);
}

double mean_of(std::span<const double> samples) {
  double sum = 0;
  for (const double x : samples) sum += x / static_cast<double>(samples.size());
  return sum;
}

// Standard error of the mean from the scatter of block means: holds for correlated samples too.
double error_of_mean(std::span<const double> samples, double mean) {
  const std::size_t size = samples.size() / offset_blocks;
  double square = 0;
  for (std::size_t b = 0; b < offset_blocks; ++b) {
    const double deviation = mean_of(samples.subspan(b * size, size)) - mean;
    square += deviation * deviation;
  }
  return std::sqrt(square / static_cast<double>(offset_blocks * (offset_blocks - 1)));
}

void check_offset(std::span<const double> samples, ChannelQuality& quality) {
  if (samples.size() < 8 * offset_blocks) return;
  const double mean = mean_of(samples);
  if (std::abs(mean) < measure_thresholds().smallest_offset * quality.rms ||
      std::abs(mean) < measure_thresholds().offset_sd * error_of_mean(samples, mean))
    return;
  quality.faults.push_back(
      {"offset",
       fmt::format("the mean, {:.4g}, is {:.2g} times the rms: an offset of the sensor, or of the structure", mean,
                   std::abs(mean) / quality.rms)});
}

}  // namespace

ChannelQuality check_channel(std::span<const double> samples) {
  ChannelQuality quality;
  quality.samples = samples.size();
  std::size_t first_missing = samples.size(), first_finite = samples.size();
  double sum = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!std::isfinite(samples[i])) {
      first_missing = std::min(first_missing, i);
      ++quality.missing;
      continue;
    }
    if (first_finite == samples.size()) {
      first_finite = i;
      quality.minimum = quality.maximum = samples[i];
    }
    quality.minimum = std::min(quality.minimum, samples[i]);
    quality.maximum = std::max(quality.maximum, samples[i]);
    sum += samples[i];
  }
  if (quality.missing > 0)
    quality.faults.push_back({"missing", fmt::format("{} of {} samples are missing or not finite, first sample {}",
                                                     quality.missing, samples.size(), first_missing + 1)});
  const std::size_t finite = samples.size() - quality.missing;
  if (finite == 0) return quality;
  quality.mean = sum / static_cast<double>(finite);
  quality.peak = std::max(std::abs(quality.minimum), std::abs(quality.maximum));
  double square = 0;
  for (const double x : samples)
    if (std::isfinite(x)) square += (x - quality.mean) * (x - quality.mean);
  quality.rms = std::sqrt(square / static_cast<double>(finite));
  if (quality.minimum == quality.maximum) {
    quality.rms = 0;
    if (finite > 1)  // a single number is a setting, no channel
      quality.faults.push_back({"constant", fmt::format("every sample is {}: a dead channel", quality.minimum)});
    return quality;
  }
  if (const std::string fault = number_range_fault(samples); !fault.empty()) {
    quality.faults.push_back({"range", fault});
    return quality;
  }
  const std::span<const double> whole = longest_finite(samples);
  quality.noise = noise_floor(whole);
  const std::vector<double> sorted = in_order(whole);
  const ValueGrid grid = grid_of_sorted(sorted);
  if (grid.visited) quality.resolution = grid.step;
  if (const Clipping clipping = find_clipping(whole, sorted, grid); clipping.found())
    quality.faults.push_back(
        {"clipping",
         fmt::format("{} samples are stuck at the extremes ({} times at {:.6g}, {} times at {:.6g})",
                     clipping.samples, clipping.runs_high, quality.maximum, clipping.runs_low, quality.minimum)});
  check_offset(whole, quality);
  if (whole.size() > 16 * coarse_levels && grid.step &&
      quality.maximum - quality.minimum < static_cast<double>(coarse_levels) * *grid.step)
    quality.faults.push_back(
        {"coarse", fmt::format("the range has {} steps of {:.3g} only",
                               std::lround((quality.maximum - quality.minimum) / *grid.step), *grid.step)});
  return quality;
}

}  // namespace secular
