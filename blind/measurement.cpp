#include "blind/measurement.hpp"

#include <algorithm>
#include <cmath>

namespace secular::blind {

std::vector<double> delayed(const std::vector<double>& samples, double late) {
  constexpr std::ptrdiff_t points = 8;
  const auto count = static_cast<std::ptrdiff_t>(samples.size());
  if (count < points || late == 0) return samples;
  std::vector<double> result(samples.size());
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const double at = static_cast<double>(i) - late * sample_rate_hz;
    const std::ptrdiff_t first =
        std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(std::floor(at)) - points / 2 + 1, 0, count - points);
    double sum = 0;
    for (std::ptrdiff_t a = 0; a < points; ++a) {
      double weight = 1;
      for (std::ptrdiff_t b = 0; b < points; ++b)
        if (b != a) weight *= (at - static_cast<double>(first + b)) / static_cast<double>(a - b);
      sum += weight * samples[static_cast<std::size_t>(first + a)];
    }
    result[static_cast<std::size_t>(i)] = sum;
  }
  return result;
}

std::vector<std::vector<double>> measured(const Measurement& measurement, const Drive& drive, const Motion& motion,
                                          bool clipped) {
  const std::size_t samples = motion.samples(), modes = motion.displacement.size();
  std::vector<std::vector<double>> channels(measurement.names.size(), std::vector<double>(samples));
  std::vector<double> base(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) / sample_rate_hz;
    base[i] = drive.at(t);
    channels[0][i] = drive.at(t - measurement.fault[0].late);
  }
  for (std::size_t c = 1; c < channels.size(); ++c) {
    const std::vector<double>& row = measurement.shapes[c - 1];
    for (std::size_t k = 0; k < modes; ++k) {
      const double weight = row[k] + (modes == 2 ? row[1 - k] * measurement.leak[1 - k] : 0);
      const std::vector<double>& from =
          measurement.of_displacement ? motion.displacement[k] : motion.acceleration[k];
      for (std::size_t i = 0; i < samples; ++i) channels[c][i] += weight * from[i];
    }
    const std::vector<double>& extra =
        measurement.of_displacement ? motion.extra_displacement : motion.extra_acceleration;
    for (std::size_t i = 0; i < samples; ++i) channels[c][i] += extra[i];
    channels[c] = delayed(channels[c], measurement.fault[c].late);
  }
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const ChannelFault& fault = measurement.fault[c];
    for (std::size_t i = 0; i < samples; ++i)
      channels[c][i] = (1 + fault.gain) * channels[c][i] + fault.cross_axis * base[i] + fault.offset;
  }
  if (clipped) clip(measurement, channels);
  return channels;
}

void clip(const Measurement& measurement, std::vector<std::vector<double>>& channels) {
  for (std::size_t c = 0; c < channels.size(); ++c)
    if (const double range = measurement.fault[c].range; range > 0)
      for (double& value : channels[c]) value = std::clamp(value, -range, range);
}

}  // namespace secular::blind
