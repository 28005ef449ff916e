#pragma once

#include <cmath>
#include <complex>
#include <cstddef>

#include "estimator/model/block_frequency.hpp"
#include "measure/observe/observation_set.hpp"

namespace secular {

/// rad/s at which the line of a block turns in an observation; a decay has no excitation, and no phase of one.
inline double block_frequency(const RegressorBlock& block, const Observation& o) {
  return block_frequency(block, [&](std::size_t i) {
    return i < o.rate.size() ? o.rate[i].imag() : o.excitation_frequency[i - o.rate.size()];
  });
}

/// Calls see(line, reversed) with every measured harmonic of a mode that turns at a multiple of the mode's own
/// frequency, to 0.1 %: a line of `o.harmonic`, and whether it turns backwards (it is the conjugate then). `o`: an
/// Observation, const or not.
template <class Seen, class See>
void for_lines_at_multiple(const CompiledCase& resonance, std::size_t mode, int multiple, Seen& o, const See& see) {
  constexpr double same_line = 1e-3;
  const double own = o.rate[mode].imag();
  for (std::size_t b = 0; b < o.harmonic.size(); ++b) {
    const RegressorBlock& block = resonance.blocks[b];
    if (static_cast<std::size_t>(block.mode) != mode || !(o.harmonic_sd[b] >= 0)) continue;
    const double f = block_frequency(block, o);
    if (std::abs(std::abs(f) / own - multiple) < same_line) see(o.harmonic[b], f < 0);
  }
}

/// The mode that moves most.
inline std::size_t largest_mode(const Observation& o) {
  std::size_t largest = 0;
  for (std::size_t k = 1; k < o.amplitude.size(); ++k)
    if (std::abs(o.amplitude[k]) > std::abs(o.amplitude[largest])) largest = k;
  return largest;
}

}  // namespace secular
