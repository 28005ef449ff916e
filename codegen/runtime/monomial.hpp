#pragma once

#include <complex>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"

namespace secular {

/// Product of powers of amplitudes, their conjugates and moduli, and of the excitation, as generated code computes
/// it: |A|^2 in pairs, A/|A| as a direction that is zero at A = 0, so that every monomial is safe at zero
/// amplitude.
class Monomial {
 public:
  explicit Monomial(const CanonicalPowers& powers);

  /// amplitude by mode, forcing by excitation.
  std::complex<double> operator()(const std::complex<double>* amplitude, const std::complex<double>* forcing) const;

 private:
  struct AmplitudePowers {
    int pairs = 0, modulus = 0, directions = 0, forward = 0, backward = 0;
    bool turned = false;  ///< the direction is that of A, not of its conjugate
  };
  struct ForcingPowers {
    int pairs = 0, net = 0;
  };
  std::vector<AmplitudePowers> amplitudes_;
  std::vector<ForcingPowers> forcings_;
};

}  // namespace secular
