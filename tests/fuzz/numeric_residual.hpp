#pragma once

#include "perturb/derivation.hpp"
#include "tests/fuzz/random_model.hpp"

namespace secular::fuzz {

/// What an expansion leaves of its equations at eps^N, N the power that it goes to, by numbers alone: coordinates
/// and their derivatives at two instants, with amplitudes that move as the expansion says, put into the equations
/// as the random model states them. Nothing of the parser, of the solver or of the certificate is used but the
/// values of the derivation's coefficients.
struct NumericResidual {
  double left = 0;   ///< limit of |residual|/eps^N for eps to 0, the largest of all equations and instants
  double terms = 0;  ///< sum of the magnitudes of all terms of the expansion: what rounding is relative to
  bool small() const { return left < 1e-4 * (1 + terms); }
};

NumericResidual numeric_residual(const RandomModel& model, const Derivation& derivation);

}  // namespace secular::fuzz
