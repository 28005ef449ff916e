#include "measure/data/jitter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "measure/thresholds.hpp"
#include "numerics/distribution.hpp"
#include "numerics/fourier_transform.hpp"
#include "numerics/hertz.hpp"
#include "numerics/median.hpp"

namespace secular {
namespace {

constexpr std::size_t segment = 256;
constexpr auto& false_alarm = measure_thresholds().jitter_false_alarm;

// Mean power of every bin over segments that overlap by half, under a Hann window.
std::vector<double> mean_powers(const std::vector<double>& samples) {
  Eigen::VectorXd powers = Eigen::VectorXd::Zero(segment / 2 + 1), piece(segment);
  for (std::size_t begin = 0; begin + segment <= samples.size(); begin += segment / 2) {
    for (std::size_t i = 0; i < segment; ++i)
      piece(static_cast<Eigen::Index>(i)) =
          (samples[begin + i] - samples.front()) *
          (1 - std::cos(two_pi * static_cast<double>(i) / static_cast<double>(segment)));
    powers += half_spectrum(piece).cwiseAbs2();
  }
  return {powers.begin(), powers.end()};
}

}  // namespace

double highest_tone_hz(const std::vector<std::vector<double>>& channels, double sample_rate_hz) {
  std::size_t highest = 0;
  for (const std::vector<double>& samples : channels) {
    if (samples.size() < 4 * segment) continue;
    const std::vector<double> powers = mean_powers(samples);
    const double floor = upper_median(powers);
    if (!(floor > 0)) continue;
    const double segments = std::floor(static_cast<double>(samples.size()) / static_cast<double>(segment));
    for (std::size_t k = powers.size() - 2; k > std::max<std::size_t>(highest, 1); --k) {
      if (powers[k] < powers[k - 1] || powers[k] < powers[k + 1]) continue;
      // A bin of white noise is exponential; segments without overlap are independent.
      if (gamma_upper_tail(segments * powers[k] / floor, segments, 1) < false_alarm) highest = k;
    }
  }
  if (highest == 0) return 0.5 * sample_rate_hz;
  return static_cast<double>(highest) / static_cast<double>(segment) * sample_rate_hz;
}

std::string jitter_text(const TimeAxis& axis, const std::vector<std::vector<double>>& channels) {
  const double tone = highest_tone_hz(channels, axis.sample_rate_hz), phase = two_pi * tone * axis.jitter_s;
  return fmt::format(
      "time stamps scatter by {:.3g} s rms, {:.2g} % of the step, about the even ones that samples are read at: a "
      "tone "
      "of {:.4g} Hz, {}, loses {:.2g} % of its amplitude and gets noise of {:.2g} % of it; resample the record "
      "evenly "
      "first if the stamps are right",
      axis.jitter_s, 100 * axis.jitter_s * axis.sample_rate_hz, tone,
      tone < 0.5 * axis.sample_rate_hz ? "the highest found" : "half the sample rate", 50 * phase * phase,
      100 * phase);
}

}  // namespace secular
