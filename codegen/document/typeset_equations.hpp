#pragma once

#include <utility>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"
#include "codegen/document/typeset.hpp"

/// The equations of a derivation as formula trees: the same content as the text output, equation by equation.
namespace secular::typeset {

/// 0 = the equation of motion of one mode.
Equation motion_equation(const CanonicalModel& model, std::size_t mode);

/// Omega = 2*omega0 + eps^2*sigma, from the relation's numbers.
Equation relation_equation(const CanonicalModel& model, const CanonicalRelation& relation);

/// A smooth function = its series as far as it counts.
Equation series_equation(const CanonicalModel& model, const CanonicalSeries& series);
/// dA/dt = ... + c <factors exp(-i omega0 t)>: a term that is left to quadrature, the mean over the fast phases.
Equation quadrature_equation(const CanonicalModel& model, const CanonicalQuadrature& quadrature);

/// Omega/2 - omega0; 0 without a multiple.
Expression frequency_combination(const CanonicalModel& model, const std::vector<CanonicalRatio>& multiples);

/// 2*omega0 + Omega.
Expression phase_sum(const CanonicalModel& model, const std::vector<int>& phase);
/// exp(i*phase*t); 1 for phase zero.
Expression harmonic(const CanonicalModel& model, const std::vector<int>& phase);

/// A, and other quantities of one mode: a, beta, B, x, y.
Expression amplitude(const CanonicalModel& model, std::size_t mode);
Expression named(const std::string& letter, const CanonicalModel& model, std::size_t mode);

/// Coefficient of a harmonic: (real + i*imaginary) times the powers.
Expression harmonic_coefficient(const CanonicalModel& model, const CanonicalTerm& term);

/// dA/dt = ...
Equation complex_modulation(const CanonicalModel& model, const CanonicalCase& resonance, std::size_t mode);

/// da/dt = ..., a*dbeta/dt = ...
std::pair<Equation, Equation> polar_modulation(const CanonicalModel& model, const CanonicalCase& resonance,
                                               std::size_t mode);

/// B = A*exp(i*(omega0 - omega_obs)*t): the amplitude in the observed frame.
Equation frame_amplitude(const CanonicalModel& model, const CanonicalCase& resonance, std::size_t mode);

/// B = (x + i*y)/2.
Equation cartesian_amplitude(const CanonicalModel& model, std::size_t mode);

/// dx/dt = ..., dy/dt = ... in the observed frame.
std::pair<Equation, Equation> cartesian_modulation(const CanonicalModel& model, const CanonicalCase& resonance,
                                                   std::size_t mode);

/// omega_obs = combination of the frequencies.
Equation observed_frequency(const CanonicalModel& model, const CanonicalCase& resonance, std::size_t mode);

/// Frequency of the mode's oscillation as it is observed.
Expression observed_frequency_symbol(const CanonicalModel& model, std::size_t mode);

/// Powers of amplitudes and forcing.
Expression monomial(const CanonicalModel& model, const CanonicalPowers& powers);

/// The lump's name; c, d, p or q with mode and monomial as subscripts where the derivation made the name up.
Expression lump_symbol(const CanonicalModel& model, const CanonicalCase& resonance, std::size_t lump);

/// Symbol = definition.
Equation lump_definition(const CanonicalModel& model, const CanonicalCase& resonance, std::size_t lump);

/// (rate - i*omega0)*B = ..., or the hat of a coordinate = ..., linear in the lumps.
Equation block_equation(const CanonicalModel& model, const CanonicalCase& resonance, const CanonicalBlock& block);

/// Decay law and backbone, or the frequency response, of a model of one mode; empty where the phase cannot be
/// eliminated in closed form.
std::vector<Equation> steady_equations(const CanonicalModel& model, const CanonicalCase& resonance);

}  // namespace secular::typeset
