#pragma once

#include <optional>

#include "codegen/canonical/canonical_model.hpp"

namespace secular {

/// weight * monomial
struct WeightedPowers {
  CanonicalRatio weight;
  CanonicalPowers powers;
};

/// Derivative of the monomial B^n conj(B)^m |B|^q by B (or by conj(B)) of one mode, the other held: |B|^2 is B
/// conj(B), so that d/dB gives (n + q/2) B^(n-1) conj(B)^m |B|^q. Powers of B and conj(B) stay positive: 1/B =
/// conj(B)/|B|^2. Nothing where it vanishes.
std::optional<WeightedPowers> amplitude_derivative(const CanonicalPowers& powers, std::size_t mode,
                                                   bool by_conjugate);

}  // namespace secular
