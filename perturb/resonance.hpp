#pragma once

#include <optional>
#include <vector>

#include "perturb/model.hpp"

namespace secular {

/// Integer multiples of the natural frequencies and then of the excitation frequencies: exp(i*phase.f*t).
using Phase = std::vector<int>;

/// The lattice that a case's relations span. A phase is slow (nearly constant) exactly when it is an integer
/// combination of relations: phase = sum_r multiplier_r * relation_r.
class ResonanceLattice {
 public:
  /// Throws InputError for relations that repeat or contradict one another, that make a frequency zero, or that are
  /// impossible at the model's nominal frequencies: further than 20 % of their largest part from zero, or an
  /// excitation at a negative frequency.
  ResonanceLattice(const Model& model, const ResonanceCase& resonance);

  /// The multipliers of the relations, if the phase is slow. Throws InputError if it is a fraction of a relation.
  std::optional<std::vector<int>> slow_multipliers(const Phase& phase) const;

  /// Phase of a combination of relations.
  Phase phase_of(const std::vector<int>& multipliers) const;

  /// The excitation frequency in terms of the natural ones where relations fix it (Omega = 2*omega0), else itself.
  const GiNaC::ex& resonant_frequency(std::size_t excitation) const { return resonant_frequency_[excitation]; }
  /// What the excitation frequency has beyond its resonant value, as a multiple of each relation's detuning.
  const std::vector<GiNaC::numeric>& resonant_offset(std::size_t excitation) const {
    return resonant_offset_[excitation];
  }

  std::size_t relations() const { return relations_.size(); }

 private:
  void solve_excitation_frequencies(const Model& model);
  void refuse_impossible(const Model& model) const;

  const Model* model_;
  const ResonanceCase* case_;
  std::vector<Phase> relations_;
  std::vector<GiNaC::ex> resonant_frequency_;
  std::vector<std::vector<GiNaC::numeric>> resonant_offset_;
};

}  // namespace secular
