#pragma once

#include <string>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"

namespace secular {

/// A modulation term in polar form A_k = (a_k/2) exp(i beta_k): real factor * parameters * powers of a and F * cos
/// or sin of an angle.
struct PolarTerm {
  RationalFunction coefficient;  ///< with the powers of two from A = a/2 already in it
  std::vector<int> amplitude;    ///< power of a, by mode (after dividing by a for the phase equation)
  std::vector<int> forcing;
  std::vector<int> beta;        ///< multiples of beta in the angle, by mode
  std::vector<int> slow_phase;  ///< multiples of the relations' slow phases in the angle
  enum class Trigonometric { one, cosine, sine } function = Trigonometric::one;
};

/// da/dt = sum, and a*dbeta/dt = sum.
struct PolarEquations {
  std::vector<PolarTerm> amplitude_rate, phase_rate;
};

/// From dA/dt = sum of terms: da/dt = 2 Re(exp(-i beta) dA/dt), a dbeta/dt = 2 Im(exp(-i beta) dA/dt).
PolarEquations polar_equations(const CanonicalModel& model, const CanonicalCase& resonance, std::size_t mode);

/// The value times an exact ratio, still in canonical form.
RationalFunction scaled(const RationalFunction& value, long numerator, long denominator);

}  // namespace secular
