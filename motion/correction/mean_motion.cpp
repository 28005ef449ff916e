#include "motion/correction/mean_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "measure/observe/mode_frequencies.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

// Of numbers that differ by noise in real and imaginary part.
Complex median(const std::vector<Complex>& values) {
  std::vector<double> real, imaginary;
  for (const Complex& value : values) {
    real.push_back(value.real());
    imaginary.push_back(value.imag());
  }
  return {median(std::move(real)), median(std::move(imaginary))};
}

// The excitation's phase is known to whole turns, that of a mode locked to a half of it to half turns.
int smallest_turn(const CompiledModel& model, const CompiledCase& resonance, std::size_t mode) {
  const std::size_t width = model.modes() + model.excitations.size();
  int denominator = 1;
  for (std::size_t i = model.modes(); i < width; ++i)
    denominator = std::lcm(denominator, resonance.observed_frequency[mode * width + i].denominator);
  return denominator;
}

// By mode: phase of `o` against `first` beyond what a shift of the phases of excitations and free frequencies does.
std::vector<double> own_phases(const Observation& o, const Observation& first, const CompiledModel& model,
                               const CompiledCase& resonance, const ModeFrequencies& modes) {
  const auto turned = [](Complex to, Complex from) { return std::arg(to * std::conj(from)); };
  Eigen::VectorXd excitation(modes.forced.cols()), free(modes.coupling.cols());
  for (Eigen::Index j = 0; j < excitation.size(); ++j)
    excitation(j) = turned(o.forcing[static_cast<std::size_t>(j)], first.forcing[static_cast<std::size_t>(j)]);
  // A free frequency is that of its mode.
  for (Eigen::Index f = 0; f < free.size(); ++f) {
    const std::size_t k = modes.free[static_cast<std::size_t>(f)];
    free(f) = turned(o.amplitude[k], first.amplitude[k]);
  }
  std::vector<double> result(model.modes(), 0.0);
  for (std::size_t k = 0; k < result.size(); ++k) {
    if (!modes.oscillates[k]) continue;
    const auto row = static_cast<Eigen::Index>(k);
    const double shift = modes.forced.row(row).dot(excitation) + modes.coupling.row(row).dot(free);
    const double turn = two_pi / smallest_turn(model, resonance, k);
    result[k] = std::remainder(turned(o.amplitude[k], first.amplitude[k]) - shift, turn);
  }
  return result;
}

}  // namespace

Observation mean_motion(std::span<const Observation> ensembles, const CompiledModel& model,
                        const CompiledCase& resonance) {
  const Observation& first = ensembles.front();
  const ModeFrequencies modes = mode_frequencies(model, resonance);
  Observation mean = first;
  const auto over = [&](const auto& value) {
    std::vector<decltype(value(first))> values;
    for (const Observation& o : ensembles) values.push_back(value(o));
    return median(std::move(values));
  };
  for (std::size_t j = 0; j < first.forcing.size(); ++j) {
    mean.excitation_frequency[j] = over([&](const Observation& o) { return o.excitation_frequency[j]; });
    mean.forcing[j] =
        std::polar(over([&](const Observation& o) { return std::abs(o.forcing[j]); }), std::arg(first.forcing[j]));
  }
  std::vector<std::vector<double>> phases;  // [ensemble][mode]
  for (const Observation& o : ensembles) phases.push_back(own_phases(o, first, model, resonance, modes));
  for (std::size_t k = 0; k < first.amplitude.size(); ++k) {
    std::vector<Complex> turned;
    for (std::size_t e = 0; e < ensembles.size(); ++e)
      turned.push_back(std::polar(std::abs(ensembles[e].amplitude[k]), phases[e][k]));
    mean.amplitude[k] = std::polar(1.0, std::arg(first.amplitude[k])) * median(turned);
    mean.rate[k] = over([&](const Observation& o) { return o.rate[k]; });
  }
  return mean;
}

void take_motion(const Observation& exact, Observation& to) {
  to.excitation_frequency = exact.excitation_frequency;
  to.forcing = exact.forcing;
  to.amplitude = exact.amplitude;
  to.rate = exact.rate;
  to.harmonic = exact.harmonic;
}

}  // namespace secular
