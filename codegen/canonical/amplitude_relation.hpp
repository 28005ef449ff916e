#pragma once

#include <optional>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"
#include "codegen/canonical/variable_sum.hpp"

namespace secular {

/// The variables of a model of one mode as a VariableSum counts them: the amplitude a, the frame offset d (observed
/// minus natural frequency), then the excitations.
struct AmplitudeVariables {
  static constexpr std::size_t amplitude = 0, offset = 1;
  std::size_t excitations = 0;
  static std::size_t forcing(std::size_t excitation) { return 2 + excitation; }
  std::size_t count() const { return 2 + excitations; }
};

/// Steady states of one mode with the phase eliminated. With one angle phi up to its sign the polar equations are
///   0 = S + (U + U') cos phi - (V - V') sin phi,   0 = T - a d + (U - U') sin phi + (V + V') cos phi,
/// U, V from the terms that turn with phi, U', V' from those that turn with -phi.
struct AmplitudeRelation {
  enum class Kind {
    none,             ///< several modes, no excitation that turns, or several angles: nothing below
    one_angle,        ///< U' = V' = 0
    opposite_angles,  ///< phi and -phi
  };
  Kind kind = Kind::none;
  AmplitudeVariables variables;
  VariableSum still_real, still_imaginary;        ///< S, T
  VariableSum turning_real, turning_imaginary;    ///< U, V
  VariableSum opposite_real, opposite_imaginary;  ///< U', V'
  bool complete = true;                           ///< no term is left to quadrature

  /// G = S^2 + (T - a d)^2 - U^2 - V^2 = 0 divided by a^divided, where all terms have that power; with opposite
  /// angles, and U+- = U +- U', V+- = V +- V', T including -a d,
  ///   G = (S U- + T V-)^2 + (T U+ - S V+)^2 - (U+ U- + V+ V-)^2.
  VariableSum relation;
  int divided = 0;
  /// dG/da at constant excitation and detuning: G = dG/da = 0 at saddle-nodes.
  VariableSum fold;

  /// Of one angle, where S and T are free of the excitation and U and V proportional to its power n:
  ///   F^(2n) = (S^2 + (T - a d)^2)/(u^2 + v^2).
  struct Force {
    std::size_t excitation = 0;
    int power = 1;
    VariableSum real, imaginary;  ///< u, v
  };
  std::optional<Force> force;

  /// Of one angle, where no coefficient holds a detuning or an excitation frequency: d = T/a -+ sqrt(U^2 + V^2 -
  /// S^2)/a.
  bool detuning_is_explicit = false;
};

/// Of one case, from its modulation equation.
AmplitudeRelation amplitude_relation(const CanonicalModel& model, const CanonicalCase& resonance);

}  // namespace secular
