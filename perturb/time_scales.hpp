#pragma once

#include <vector>

#include "perturb/field.hpp"
#include "perturb/model.hpp"
#include "perturb/resonance.hpp"

namespace secular {

/// How fast terms turn on the time scales T_n = eps^n t, by the phase integers m_j of their keys:
///   exp(i sum_j m_j (fast_j T_0 + slow_{1,j} T_1 + slow_{2,j} T_2 + ...)).
struct PhaseRates {
  FieldLayout layout;
  std::vector<GiNaC::ex> fast;               ///< [frequency], as it stands in coefficients
  std::vector<std::vector<GiNaC::ex>> slow;  ///< [n][frequency or slow phase]; 0 at n = 0

  /// sum_j m_j fast_j, and sum_j m_j slow_{n,j}; expanded.
  GiNaC::ex on_fast_scale(const FieldKey& key) const;
  GiNaC::ex on_slow_scale(const FieldKey& key, int n) const;
};

/// The rates of a case. `resonant`: excitation frequencies have the values that the relations give them, and turn
/// by the rest of their true value on the slow scales; otherwise they keep their symbols. Slow phases turn by the
/// relations' detunings.
PhaseRates phase_rates(const Model& model, const ResonanceCase& resonance, const ResonanceLattice& lattice,
                       bool resonant);

/// D_n A_k by [mode][n], as far as it is known; empty at n = 0.
using AmplitudeRates = std::vector<FieldSeries>;

/// D_0: every term times i*(its rate on T_0).
Field fast_derivative(const Field& field, const PhaseRates& rates);

/// D_n for n >= 1: chain rule through A, conj A and |A|, and what phases turn by on T_n.
Field slow_derivative(const Field& field, int n, const PhaseRates& rates, const AmplitudeRates& amplitude_rates);

/// d/dt = D_0 + eps D_1 + eps^2 D_2 + ... of a series, its part at eps^order: sum_n D_n of the part at
/// eps^(order - n).
Field time_derivative(const FieldSeries& series, int order, const PhaseRates& rates,
                      const AmplitudeRates& amplitude_rates);

}  // namespace secular
