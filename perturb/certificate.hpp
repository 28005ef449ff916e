#pragma once

#include <string>
#include <vector>

#include "perturb/derivation.hpp"

namespace secular {

/// Proof that an expansion solves its equations: the expansion is put back into the original equations, read anew
/// from the parsed text, as one function of true time (no multiple scales: dA/dt is substituted by the chain rule,
/// excitation frequencies by their relations), and every coefficient up to eps^order must be zero.
///
/// Harmonics, amplitude powers and powers of eps are kept exactly; the model's symbols are random numbers of a
/// prime field (see PrimeFieldComplex), at two points. A coefficient that is identically zero is always found to be
/// zero; one that is not passes with a probability below (degree/2^61)^2, some 1e-33. Nothing of the derivation's
/// algebra is used.
///
/// Nonsmooth terms are checked by numbers: their Fourier integrals, cut at the sign changes and integrated by
/// Gauss-Legendre quadrature at random amplitudes and parameters, against what the expansion claims.
struct Certificate {
  bool holds = false;
  int order = 0;                         ///< nothing is left up to eps^order
  std::size_t coefficients_checked = 0;  ///< distinct (harmonic, amplitude powers) coefficients that had to vanish
  int nonsmooth_harmonics = 0;           ///< highest harmonic compared; 0 without nonsmooth terms
  double nonsmooth_error = 0;            ///< largest difference relative to the largest harmonic
  std::vector<std::string> remainders;   ///< what is left, where it does not hold: equation, order, harmonic
};

/// What does not hold is recorded, not thrown.
Certificate certify(const Derivation& derivation);

}  // namespace secular
