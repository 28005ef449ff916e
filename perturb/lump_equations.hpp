#pragma once

#include <optional>
#include <string>
#include <vector>

#include "perturb/derivation.hpp"
#include "perturb/factored_fraction.hpp"

namespace secular {

/// Frequencies at which a steady state is observed: mode k's motion is B_k exp(i w_k t) with w_k = omega_k + a
/// combination of the relations, chosen so that dB/dt does not depend on time explicitly (half the excitation
/// frequency in a principal parametric resonance). Rows over natural and excitation frequencies; frequencies that
/// follow others, as by the relation Omega2 = 2*Omega, are replaced by those.
struct ObservedFrequencies {
  std::vector<std::vector<GiNaC::numeric>> of_mode, of_excitation;

  /// sum_k phase_k w_k + sum_j phase_j Omega_j as a row over all frequencies.
  std::vector<GiNaC::numeric> of_phase(const Phase& phase) const;
};

/// Nothing if no frame makes the modulation equations autonomous.
std::optional<ObservedFrequencies> observed_frequencies(const Derivation& derivation);

/// A real parameter combination that multiplies data.
struct Lump {
  std::string name;
  GiNaC::ex definition;
};

/// factor (frequencies and numbers only) * lump * (i if imaginary) * amplitude powers of `key`.
struct ColumnTerm {
  std::vector<FactoredFraction> factor;  ///< a sum
  bool imaginary = false;
  FieldKey key;
};

/// An equation that is linear in lumps: target = sum over columns of lump * sum of its terms. For modulation the
/// target is dB/dt + i(w_k - omega_k)B in the observed frame, for a harmonic its complex amplitude (full real value
/// at zero frequency).
struct LumpEquation {
  bool modulation = true;
  std::size_t mode = 0;
  int order = 0;  ///< lowest power of eps of its terms
  Phase phase;    ///< harmonic: representative phase
  struct Column {
    std::size_t lump = 0;
    std::vector<ColumnTerm> terms;
  };
  std::vector<Column> columns;
};

/// What the frames and lumps of a case make of its modulation equations and harmonics.
struct LumpEquations {
  ObservedFrequencies frequencies;
  std::vector<Lump> lumps;
  std::vector<LumpEquation> blocks;
};

/// Modulation blocks have Omega at its resonant value, so that lumps are the same for all data; harmonic blocks
/// keep the actual Omega wherever the lumps stay free of it. Lumps are named by single parameters or the model's
/// shorthands where they are proportional to one, otherwise after the term they multiply; where that is one product
/// of coefficients with several fractions of frequencies, after the product. Throws InputError where no autonomous
/// frame exists. Factors of columns are fractions of `sums`, which are of all symbols of the model.
LumpEquations lump_equations(const Derivation& nominal, const Derivation& kept, FractionSums& sums);

/// Turns a phase and its conjugate into the one that is listed: positive frequency at the nominal values or,
/// without them, a positive first exponent. Returns true if the phase was turned.
bool orient(Phase& phase, const Derivation& derivation);

}  // namespace secular
