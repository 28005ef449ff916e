#pragma once

#include <string>

#include "codegen/canonical/canonical_model.hpp"

namespace secular {

/// The equation of motion of one mode as "0 = ...", in model text.
std::string motion_text(const CanonicalModel& model, std::size_t mode);

/// dB/dt of one mode in its lumps: "dA_v/dt = -mu1*A_v + i*4/omega0*alpha_e*A_v^2*conj(A_v) ...".
std::string modulation_text(const CanonicalModel& model, const CanonicalCase& resonance, std::size_t mode);

/// One block as an equation in lumps and data.
std::string equation_text(const CanonicalModel& model, const CanonicalCase& resonance, const CanonicalBlock& block);

/// A sum of terms of an equation of motion in model text: "omega0^2*sin(x) + D2(x)".
std::string sum_text(const CanonicalModel& model, const std::vector<CanonicalMotionTerm>& terms);
/// Factors of such a term: "abs(D(v))*D(v)".
std::string factors_text(const CanonicalModel& model, const std::vector<CanonicalFactor>& factors);

/// "dA_v/dt also holds ...": a term that is left to quadrature.
std::string quadrature_text(const CanonicalModel& model, const CanonicalQuadrature& quadrature);

/// What `secular derive` prints: expansion, solvability, modulation equations (complex, polar, Cartesian), their
/// Jacobian, zero solution, steady states,
/// lumps, harmonics, certificate, for every case of the model.
std::string derivation_text(const CanonicalModel& model);

/// "omega0", "2*omega0 + Omega", "0".
std::string phase_text(const CanonicalModel& model, const std::vector<int>& phase);

/// "A_v^2*conj(A_v)*F".
std::string powers_text(const CanonicalModel& model, const CanonicalPowers& powers);

}  // namespace secular
