#include "thesis/procedures/jump_frequencies.hpp"

#include <cmath>

namespace secular {

std::optional<Onset> onset_of(std::span<const SweepDwell> sweep) {
  for (std::size_t i = 1; i < sweep.size(); ++i)
    if (sweep[i].responds && !sweep[i - 1].responds) return Onset{sweep[i - 1].frequency, sweep[i].frequency};
  return {};
}

ResonanceCentre resonance_centre(const Onset& forward, const Onset& reverse) {
  ResonanceCentre centre;
  centre.thesis = 0.5 * (forward.responds + reverse.responds);
  centre.bracketed = 0.25 * (forward.quiet + forward.responds + reverse.quiet + reverse.responds);
  // Each onset is somewhere in its bracket: a uniform distribution.
  centre.sd =
      0.5 * std::hypot(forward.responds - forward.quiet, reverse.responds - reverse.quiet) / std::sqrt(12.0);
  return centre;
}

}  // namespace secular
