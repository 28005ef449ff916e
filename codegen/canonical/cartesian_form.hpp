#pragma once

#include <vector>

#include "codegen/canonical/canonical_model.hpp"

namespace secular {

/// A modulation term in Cartesian form A_k = (x_k + i*y_k)/2: coefficient * powers of x_k, y_k, of
/// r_k^2 = x_k^2 + y_k^2, of r_k and of F.
struct CartesianTerm {
  RationalFunction coefficient;         ///< with the powers of two from A = (x + i*y)/2 already in it
  std::vector<int> x, y;                ///< by mode
  std::vector<int> norm_squared, norm;  ///< powers of r_k^2 and of r_k, by mode
  std::vector<int> forcing;             ///< by excitation
};

/// dx/dt = sum, and dy/dt = sum, without the rotation of the frame.
struct CartesianEquations {
  std::vector<CartesianTerm> x_rate, y_rate;
};

/// From dA/dt = sum of terms: dx/dt = 2 Re(dA/dt), dy/dt = 2 Im(dA/dt).
CartesianEquations cartesian_equations(const CanonicalModel& model, const CanonicalCase& resonance,
                                       std::size_t mode);

/// Observed minus natural frequency of a mode, as multiples of all frequencies: what the frame turns by.
std::vector<CanonicalRatio> frame_offset(const CanonicalCase& resonance, std::size_t mode);

}  // namespace secular
