#include "motion/correction/chain_fault.hpp"

#include <cmath>
#include <complex>

#include "estimator/model/zero_frequency.hpp"
#include "measure/observe/modal_projection.hpp"
#include "measure/observe/observed_blocks.hpp"
#include "motion/correction/low_pass.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;

/// Lines at a multiple of a frequency are there to this, relative.
constexpr double same_line = 1e-3;

// Of the one mode of a set, what a law of the sensor makes of its lines. docs/inference.md (61).
void take_law_off(const SizedFault& fault, const CompiledCase& resonance, Observation& o) {
  const int d = fault.derivatives;
  const bool even = fault.kind == ChainFault::even_law;
  const double k = fault.size / (even ? fault.largest : fault.largest * fault.largest);
  const double own = o.rate.front().imag();
  const Complex motion = o.amplitude.front() * derived(own, d);
  const double square = std::norm(motion);
  for (std::size_t b = 0; b < o.harmonic.size(); ++b) {
    const RegressorBlock& block = resonance.blocks[b];
    if (!(o.harmonic_sd[b] >= 0)) continue;
    if (even && d == 0 && is_zero_frequency(block)) o.harmonic[b] -= 2 * k * square;
    const int order = even ? 2 : 3;
    const double f = block_frequency(block, o);
    if (std::abs(std::abs(f) / own - order) > same_line) continue;
    const Complex line = k * std::pow(motion, order) / derived(order * own, d);
    o.harmonic[b] -= f < 0 ? std::conj(line) : line;
  }
  if (even && !o.mean.empty()) o.mean.front() -= 2 * k * square;
  if (!even) o.amplitude.front() *= 1 - 3 * k * square;
}

}  // namespace

double SizedFault::time_constant() const {
  return std::sqrt(size / poles) / frequency;
}

double SizedFault::amplitude() const {
  return std::pow(1 + size / poles, -0.5 * poles);
}

int multiple_of(const RegressorBlock& block) {
  int multiple = 0;
  for (std::size_t i = 0; i < block.phase.size(); ++i) {
    if (block.phase[i] == 0) continue;
    if (multiple != 0 || static_cast<int>(i) != block.mode) return 0;
    multiple = block.phase[i];
  }
  return multiple;
}

std::vector<ObservationSet> without_fault(std::span<const ObservationSet> sets, const SizedFault& fault) {
  if (fault.kind == ChainFault::low_pass) {
    LowPass filter;
    filter.frequency = fault.frequency;
    filter.poles = fault.poles;
    filter.late_s = fault.poles * std::atan(fault.frequency * fault.time_constant()) / fault.frequency;
    return before_low_pass(sets, filter);
  }
  std::vector<ObservationSet> result(sets.begin(), sets.end());
  for (ObservationSet& set : result)
    for (Observation& o : set.observations) take_law_off(fault, *set.resonance, o);
  return result;
}

}  // namespace secular
