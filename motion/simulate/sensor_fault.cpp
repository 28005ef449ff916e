#include "motion/simulate/sensor_fault.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace secular {
namespace {

// samples at t - delay, in units of the sample interval.
std::vector<double> delayed(const std::vector<double>& samples, double delay) {
  constexpr int half_width = 16;
  const double whole = std::floor(delay), fraction = delay - whole;
  const auto size = static_cast<std::ptrdiff_t>(samples.size());
  const auto at = [&](std::ptrdiff_t i) {
    return samples[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, size - 1))];
  };
  std::vector<double> result(samples.size());
  for (std::ptrdiff_t i = 0; i < size; ++i) {
    const std::ptrdiff_t centre = i - static_cast<std::ptrdiff_t>(whole);
    double sum = 0, weights = 0;
    for (std::ptrdiff_t j = -half_width; j <= half_width; ++j) {
      const double x = -fraction - static_cast<double>(j);
      const double sinc = std::abs(x) < 1e-12 ? 1 : std::sin(std::numbers::pi * x) / (std::numbers::pi * x);
      const double window = std::cos(0.5 * std::numbers::pi * x / (half_width + 1));
      const double weight = sinc * window * window;
      sum += weight * at(centre + j);
      weights += weight;
    }
    result[static_cast<std::size_t>(i)] = sum / weights;
  }
  return result;
}

}  // namespace

void apply_sensor_faults(const std::vector<SensorFault>& faults, const std::vector<std::string>& names,
                         bool excited, Record& record) {
  if (faults.empty()) return;
  const std::vector<double> excitation = excited ? record.channels[0] : std::vector<double>{};
  for (std::size_t c = 0; c < names.size(); ++c)
    for (const auto kind : {ChannelFault::gain, ChannelFault::offset, ChannelFault::cross_axis, ChannelFault::skew})
      for (const SensorFault& fault : faults) {
        if (fault.kind != kind || fault.channel != names[c]) continue;
        std::vector<double>& samples = record.channels[c];
        for (std::size_t i = 0; i < samples.size(); ++i) {
          if (kind == ChannelFault::gain) samples[i] *= fault.strength;
          if (kind == ChannelFault::offset) samples[i] += fault.strength;
          if (kind == ChannelFault::cross_axis) samples[i] += fault.strength * excitation[i];
        }
        if (kind == ChannelFault::skew) samples = delayed(samples, fault.strength * record.sample_rate_hz);
      }
}

void clip(const std::vector<SensorFault>& faults, const std::string& name, std::vector<double>& samples) {
  for (const SensorFault& fault : faults)
    if (fault.kind == ChannelFault::clipping && fault.channel == name)
      for (double& x : samples) x = std::clamp(x, -fault.strength, fault.strength);
}

}  // namespace secular
