#include "motion/correction/low_pass.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "estimator/thresholds.hpp"
#include "measure/observe/observed_blocks.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;

const Observation* first_of(std::span<const ObservationSet> sets, std::string_view resonance, std::size_t record) {
  for (const ObservationSet& set : sets)
    if (set.resonance->name == resonance)
      for (const Observation& o : set.observations)
        if (o.record == record) return &o;
  return nullptr;
}

// What a line at a frequency has to be multiplied with, as an amplitude of exp(i w t): the poles taken out, and the
// delay as which they were taken out before put back.
Complex factor(const LowPass& filter, double frequency) {
  return std::pow(Complex(1, frequency * filter.time_constant()), filter.poles) *
         std::polar(1.0, -frequency * std::abs(filter.late_s));
}

void put_before(const LowPass& filter, const CompiledCase& resonance, Observation& o) {
  for (std::size_t k = 0; k < o.amplitude.size(); ++k) {
    const Complex by = factor(filter, o.rate[k].imag());
    o.amplitude[k] *= by;
    o.amplitude_sd[k] *= std::abs(by);
  }
  for (std::size_t b = 0; b < o.harmonic.size(); ++b) {
    if (!(o.harmonic_sd[b] >= 0)) continue;
    const Complex by = factor(filter, block_frequency(resonance.blocks[b], o));
    o.harmonic[b] *= by;
    o.harmonic_sd[b] *= std::abs(by);
  }
}

void put_before_excitation(const LowPass& filter, const CompiledCase& resonance, Observation& o) {
  for (std::size_t j = 0; j < o.forcing.size(); ++j) {
    const Complex by = factor(filter, o.excitation_frequency[j]);
    o.forcing[j] *= by;
    o.forcing_sd[j] *= std::abs(by);
  }
  for (std::size_t b = 0; b < o.forcing_harmonic.size(); ++b) {
    if (!(o.forcing_harmonic_sd[b] >= 0)) continue;
    const Complex by = factor(filter, block_frequency(resonance.blocks[b], o));
    o.forcing_harmonic[b] *= by;
    o.forcing_harmonic_sd[b] *= std::abs(by);
  }
}

}  // namespace

double LowPass::time_constant() const {
  return std::tan(frequency * std::abs(late_s) / poles) / frequency;
}

double LowPass::amplitude() const {
  return std::pow(std::cos(frequency * late_s / poles), poles);
}

std::optional<LowPass> shared_low_pass(std::span<const CaseLateness> lateness,
                                       std::span<const ObservationSet> measured) {
  double least = INFINITY, most = 0, sum = 0, frequencies = 0;
  std::size_t early = 0, records = 0;
  for (const CaseLateness& here : lateness) {
    if (here.finding != PhaseFinding::late) continue;
    for (const RecordLateness& record : here.records) {
      const Observation* o = first_of(measured, here.resonance, record.record);
      if (o == nullptr) continue;
      // Whole periods of the excitation are no more than a choice.
      const double late = std::remainder(record.late_s, record.period_s);
      const double w = late < 0 ? o->excitation_frequency.front() : o->rate[largest_mode(*o)].imag();
      if (std::abs(w * late) >= 0.5 * std::numbers::pi) return std::nullopt;
      early += late < 0 ? 1 : 0;
      least = std::min(least, std::abs(late));
      most = std::max(most, std::abs(late));
      sum += late;
      frequencies += w;
      ++records;
    }
  }
  if (records < 2 || (early > 0 && early < records)) return std::nullopt;
  const auto count = static_cast<double>(records);
  const double at_random = std::pow(1 - least / most, count - 1);
  const double counts = 1 - at_random / estimator_thresholds().sign_alarm;
  if (!(counts > 0)) return std::nullopt;
  LowPass filter;
  filter.late_s = counts * sum / count;
  filter.frequency = frequencies / count;
  return filter;
}

std::vector<ObservationSet> before_low_pass(std::span<const ObservationSet> measured, const LowPass& filter) {
  std::vector<ObservationSet> result(measured.begin(), measured.end());
  for (ObservationSet& set : result) {
    if (!set.phase_unknown && (set.resonance->excited || filter.late_s < 0)) continue;
    for (Observation& o : set.observations)
      filter.late_s < 0 ? put_before_excitation(filter, *set.resonance, o) : put_before(filter, *set.resonance, o);
  }
  return result;
}

}  // namespace secular
