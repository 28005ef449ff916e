#pragma once

#include "perturb/field.hpp"
#include "perturb/resonance.hpp"

namespace secular {

/// The forcing of one mode's oscillator at one order,
///   D_0^2 u + omega_k^2 u = forcing - (2 i omega_k D_n A_k exp(i omega_k T_0) + conjugate),
/// told apart by the solvability condition: what turns with exp(i omega_k T_0) up to slow phases would make u grow
/// without bound, and is what D_n A_k has to take away.
struct SplitForcing {
  Field secular;      ///< with exp(i omega_k T_0) taken out and phases reduced to slow ones: 2 i omega_k D_n A_k
  Field oscillating;  ///< what u answers; conjugates of secular terms are in neither
};

/// Throws InputError where a phase is a fraction of a relation.
SplitForcing split_forcing(const Field& forcing, std::size_t mode, const FieldLayout& layout,
                           const ResonanceLattice& lattice);

/// Phase of a key in true frequencies: its slow part put back as multiples of the relations.
Phase full_phase(const FieldKey& key, const FieldLayout& layout, const ResonanceLattice& lattice);

}  // namespace secular
