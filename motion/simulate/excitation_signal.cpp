#include "motion/simulate/excitation_signal.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "motion/simulate/noise.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

// Wave with harmonics of an angle with given rates: chain rule for the first two derivatives.
ExcitationSample distorted(double amplitude, const std::vector<double>& harmonics, double angle, double rate,
                           double acceleration) {
  ExcitationSample sample;
  for (std::size_t n = 0; n <= harmonics.size(); ++n) {
    const double multiple = static_cast<double>(n + 1), size = amplitude * (n == 0 ? 1.0 : harmonics[n - 1]);
    const double c = std::cos(multiple * angle), s = std::sin(multiple * angle);
    sample.value += size * c;
    sample.first_derivative -= size * multiple * rate * s;
    sample.second_derivative -= size * (multiple * multiple * rate * rate * c + multiple * acceleration * s);
  }
  return sample;
}

}  // namespace

ExcitationSignal harmonic_wave(double omega, double amplitude, double phase, std::vector<double> harmonics) {
  return [=, harmonics = std::move(harmonics)](double time, ExcitationSample* samples) {
    samples[0] = distorted(amplitude, harmonics, omega * time + phase, omega, 0);
  };
}

ExcitationSignal linear_sweep(double from_hz, double rate_hz_per_s, double amplitude,
                              std::vector<double> harmonics) {
  return [=, harmonics = std::move(harmonics)](double time, ExcitationSample* samples) {
    const double angle = two_pi * (from_hz * time + 0.5 * rate_hz_per_s * time * time);
    samples[0] =
        distorted(amplitude, harmonics, angle, two_pi * (from_hz + rate_hz_per_s * time), two_pi * rate_hz_per_s);
  };
}

ExcitationSignal half_sine_pulse(double peak, double at_s, double width_s) {
  return [=](double time, ExcitationSample* samples) {
    samples[0] = {};
    if (time < at_s || time > at_s + width_s) return;
    const double rate = std::numbers::pi / width_s, angle = rate * (time - at_s);
    samples[0] = {peak * std::sin(angle), peak * rate * std::cos(angle), -peak * rate * rate * std::sin(angle)};
  };
}

ExcitationSignal random_phase_multisine(double low_hz, double high_hz, std::size_t lines, double rms,
                                        std::uint64_t seed) {
  struct Line {
    double omega, phase;
  };
  std::vector<Line> wave;
  NoiseStream random(seed, 0x6d756c7469ULL, 0);
  for (std::size_t n = 0; n < lines; ++n) {
    const double share = lines > 1 ? static_cast<double>(n) / static_cast<double>(lines - 1) : 0;
    // Two Gaussian numbers point in a uniformly distributed direction.
    const double x = random.gaussian(), y = random.gaussian();
    wave.push_back({two_pi * (low_hz + share * (high_hz - low_hz)), std::atan2(y, x)});
  }
  const double amplitude = rms * std::sqrt(2.0 / static_cast<double>(lines));
  return [wave = std::move(wave), amplitude](double time, ExcitationSample* samples) {
    samples[0] = {};
    for (const Line& line : wave) {
      const double c = amplitude * std::cos(line.omega * time + line.phase);
      const double s = amplitude * std::sin(line.omega * time + line.phase);
      samples[0].value += c;
      samples[0].first_derivative -= line.omega * s;
      samples[0].second_derivative -= line.omega * line.omega * c;
    }
  };
}

ExcitationSignal side_by_side(std::vector<ExcitationSignal> signals) {
  return [signals = std::move(signals)](double time, ExcitationSample* samples) {
    for (std::size_t j = 0; j < signals.size(); ++j) signals[j](time, samples + j);
  };
}

}  // namespace secular
