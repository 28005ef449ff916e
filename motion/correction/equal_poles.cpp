#include "motion/correction/equal_poles.hpp"

#include <cmath>
#include <complex>

#include "estimator/model/zero_frequency.hpp"
#include "measure/observe/observed_blocks.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;

void put_before(const EqualPoles& filter, const CompiledCase& resonance, Observation& o) {
  for (std::size_t k = 0; k < o.amplitude.size(); ++k) {
    const Complex by = filter.inverse(o.rate[k].imag());
    o.amplitude[k] *= by;
    o.amplitude_sd[k] *= std::abs(by);
  }
  for (std::size_t b = 0; b < o.harmonic.size(); ++b) {
    if (!(o.harmonic_sd[b] >= 0)) continue;
    if (filter.high_pass && is_zero_frequency(resonance.blocks[b])) {  // it passes nothing of a mean
      o.harmonic_sd[b] = -1;
      continue;
    }
    const Complex by = filter.inverse(block_frequency(resonance.blocks[b], o));
    o.harmonic[b] *= by;
    o.harmonic_sd[b] *= std::abs(by);
  }
}

void put_before_excitation(const EqualPoles& filter, const CompiledCase& resonance, Observation& o) {
  for (std::size_t j = 0; j < o.forcing.size(); ++j) {
    const Complex by = filter.inverse(o.excitation_frequency[j]);
    o.forcing[j] *= by;
    o.forcing_sd[j] *= std::abs(by);
  }
  for (std::size_t b = 0; b < o.forcing_harmonic.size(); ++b) {
    if (!(o.forcing_harmonic_sd[b] >= 0)) continue;
    const Complex by = filter.inverse(block_frequency(resonance.blocks[b], o));
    o.forcing_harmonic[b] *= by;
    o.forcing_harmonic_sd[b] *= std::abs(by);
  }
}

}  // namespace

double EqualPoles::time_constant() const {
  const double angle = std::tan(frequency * std::abs(late_s) / poles);
  return (high_pass ? 1 / angle : angle) / frequency;
}

double EqualPoles::amplitude() const {
  return std::pow(std::cos(frequency * late_s / poles), poles);
}

Complex EqualPoles::inverse(double at_frequency) const {
  const Complex pole(0, at_frequency * time_constant());
  const Complex before = std::pow(high_pass ? 1.0 + 1.0 / pole : 1.0 + pole, poles);
  return before * std::polar(1.0, (high_pass ? 1 : -1) * at_frequency * std::abs(late_s));
}

Complex EqualPoles::slope_of_inverse(double at_frequency) const {
  const Complex rate(0, time_constant()), pole = at_frequency * rate;
  const Complex one = high_pass ? -1.0 / (at_frequency * (1.0 + pole)) : rate / (1.0 + pole);
  return static_cast<double>(poles) * one + Complex(0, (high_pass ? 1 : -1) * std::abs(late_s));
}

std::vector<ObservationSet> before_poles(std::span<const ObservationSet> measured, const EqualPoles& filter) {
  std::vector<ObservationSet> result(measured.begin(), measured.end());
  for (ObservationSet& set : result) {
    if (!set.phase_unknown && (set.resonance->excited || filter.late_s < 0)) continue;
    for (Observation& o : set.observations)
      filter.late_s < 0 ? put_before_excitation(filter, *set.resonance, o) : put_before(filter, *set.resonance, o);
  }
  return result;
}

}  // namespace secular
