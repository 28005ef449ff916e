#pragma once

#include <string>
#include <vector>

#include "perturb/derivation.hpp"

namespace secular {

/// Proof that an expansion solves its equations: the expansion is put back into the original equations as one
/// function of true time (no multiple scales: dA/dt is substituted by the chain rule, excitation frequencies by
/// their relations), and every coefficient up to eps^order is checked to be exactly zero.
///
/// Nonsmooth terms are checked by numbers: their Fourier integrals, cut at the sign changes and integrated by
/// Gauss-Kronrod quadrature at random amplitudes and parameters, against what the expansion claims.
struct Certificate {
  bool holds = false;
  int order = 0;                         ///< nothing is left up to eps^order
  std::size_t coefficients_checked = 0;  ///< distinct (harmonic, amplitude powers) coefficients that had to vanish
  int nonsmooth_harmonics = 0;           ///< highest harmonic compared; 0 without nonsmooth terms
  double nonsmooth_error = 0;            ///< largest difference relative to the largest harmonic
  std::vector<std::string> remainders;   ///< what is left, where it does not hold
};

Certificate certify(const Derivation& derivation);

}  // namespace secular
