#include "motion/simulate/stepped_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "motion/simulate/motion.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;

constexpr double samples_per_period = 32;

class Sweep {
 public:
  Sweep(const CompiledModel& model, const CompiledCase& resonance, const SteppedSweep& sweep)
      : model_(model),
        case_(resonance),
        sweep_(sweep),
        state_{std::vector<double>(model.modes(), 0.0), std::vector<double>(model.modes(), 0.0)},
        phase_(model.excitations.size(), 0.0) {}

  SweepPoint dwell(const SweepStep& step) {
    for (std::size_t k = 0; k < model_.modes(); ++k)
      if (!case_.mode_at_rest[k] && std::abs(state_.displacement[k]) < sweep_.disturbance)
        state_.displacement[k] = std::copysign(sweep_.disturbance, state_.displacement[k]);
    SweepPoint point;
    for (int w = 0; w < sweep_.window_limit && !point.settled; ++w) {
      const std::vector<double> before = std::move(point.amplitude);
      point.amplitude = window(step);
      point.settled = w > 1;
      for (std::size_t k = 0; k < before.size(); ++k)
        if (std::abs(point.amplitude[k] - before[k]) >
            sweep_.settled * std::max(point.amplitude[k], sweep_.disturbance))
          point.settled = false;
    }
    return point;
  }

 private:
  double observed(std::size_t mode, const SweepStep& step) const {
    const std::size_t columns = model_.modes() + model_.excitations.size();
    double sum = 0;
    for (std::size_t c = 0; c < columns; ++c) {
      const Ratio weight = case_.observed_frequency[mode * columns + c];
      if (weight.numerator == 0) continue;
      sum += static_cast<double>(weight.numerator) / weight.denominator *
             (c < model_.modes() ? sweep_.parameters(static_cast<Eigen::Index>(c))
                                 : step.frequency[c - model_.modes()]);
    }
    return sum;
  }

  // Integrates over whole periods of the slowest mode; peak amplitudes seen through a Hann window.
  std::vector<double> window(const SweepStep& step) {
    std::vector<double> frequency(model_.modes());
    for (std::size_t k = 0; k < model_.modes(); ++k) frequency[k] = observed(k, step);
    const double slowest = *std::min_element(frequency.begin(), frequency.end());
    double fastest = *std::max_element(frequency.begin(), frequency.end());
    for (const double w : step.frequency) fastest = std::max(fastest, w);
    const double length = sweep_.window_periods * two_pi / slowest;
    const auto count = static_cast<std::size_t>(std::ceil(length * fastest * to_hz * samples_per_period));
    const double interval = length / static_cast<double>(count);
    const ExcitationSignal signal = [&](double time, ExcitationSample* samples) {
      for (std::size_t j = 0; j < phase_.size(); ++j) {
        const double w = step.frequency[j], f = case_.excited ? step.forcing[j] : 0, angle = w * time + phase_[j];
        samples[j] = {f * std::cos(angle), -f * w * std::sin(angle), -f * w * w * std::cos(angle)};
      }
    };
    MotionSettings settings;
    settings.label = "simulated sweep";
    settings.relative_tolerance = 1e-8;
    settings.absolute_tolerance = 1e-12 + 1e-6 * sweep_.disturbance;
    std::vector<Complex> sum(model_.modes());
    integrate_motion({model_, sweep_.parameters.data(), signal}, {0, interval, interval, count}, settings, state_,
                     [&](const MotionSample& sample) {
                       const double weight = 1 - std::cos(two_pi * sample.time / length);
                       for (std::size_t k = 0; k < sum.size(); ++k)
                         sum[k] += weight * sample.displacement[k] * std::polar(1.0, -frequency[k] * sample.time);
                     });
    for (std::size_t j = 0; j < phase_.size(); ++j)
      phase_[j] = std::remainder(phase_[j] + step.frequency[j] * length, two_pi);
    std::vector<double> amplitude;
    for (const Complex& s : sum) amplitude.push_back(2 * std::abs(s) / static_cast<double>(count));
    return amplitude;
  }

  const CompiledModel& model_;
  const CompiledCase& case_;
  const SteppedSweep& sweep_;
  MotionState state_;
  std::vector<double> phase_;
};

}  // namespace

std::vector<SweepPoint> stepped_sweep(const CompiledModel& model, const CompiledCase& resonance,
                                      const SteppedSweep& sweep, const std::function<void()>& done) {
  Sweep motion(model, resonance, sweep);
  std::vector<SweepPoint> points;
  for (const SweepStep& step : sweep.steps) {
    points.push_back(motion.dwell(step));
    if (done) done();
  }
  return points;
}

}  // namespace secular
