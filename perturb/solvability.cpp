#include "perturb/solvability.hpp"

#include <algorithm>

namespace secular {

Phase full_phase(const FieldKey& key, const FieldLayout& layout, const ResonanceLattice& lattice) {
  std::vector<int> multipliers(layout.relations);
  for (std::size_t r = 0; r < layout.relations; ++r) multipliers[r] = key[layout.slow(r)];
  Phase phase = lattice.phase_of(multipliers);
  for (std::size_t i = 0; i < phase.size(); ++i) phase[i] += key[i];
  return phase;
}

SplitForcing split_forcing(const Field& forcing, std::size_t mode, const FieldLayout& layout,
                           const ResonanceLattice& lattice) {
  SplitForcing split;
  for (const auto& [key, coefficient] : forcing.terms()) {
    const Phase phase = full_phase(key, layout, lattice);
    Phase relative = phase;
    --relative[mode];
    if (const auto multipliers = lattice.slow_multipliers(relative)) {
      FieldKey slow = key;
      std::fill_n(slow.begin(), layout.frequencies(), 0);
      for (std::size_t r = 0; r < layout.relations; ++r) slow[layout.slow(r)] = (*multipliers)[r];
      split.secular.add(slow, coefficient);
      continue;
    }
    Phase opposite = phase;
    for (int& multiple : opposite) multiple = -multiple;
    --opposite[mode];
    if (!lattice.slow_multipliers(opposite)) split.oscillating.add(key, coefficient);
  }
  return split;
}

}  // namespace secular
