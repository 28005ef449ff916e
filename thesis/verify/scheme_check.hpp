#pragma once

#include "thesis/verify/printed_formula.hpp"

namespace secular::verify {

/// What a derivation lays down before it solves anything: what is left of a statement that is right is zero.

/// The equation of motion of a mode with the powers of eps that the case gives its terms, left less right: in the
/// model's coordinates, with D0 for the derivative by time.
GiNaC::ex ordered_motion(const PrintedFormula& formula, const Derivation& derivation, std::size_t mode);

/// v_0 + eps v_1 + eps^2 v_2 for a mode, as far as the case is expanded.
GiNaC::ex expansion(const PrintedFormula& formula, const Derivation& derivation, std::size_t mode);

/// (D0 + eps D1 + eps^2 D2)^order of the first mode's v_0, up to eps^2.
GiNaC::ex time_derivative(const PrintedFormula& formula, int order);

/// Excitation frequencies as the case's relations and orders of detunings give them.
GiNaC::exmap detuned_frequencies(const PrintedFormula& formula, const Derivation& derivation);

/// Values of slow waves and phase factors that differ by free turns, all of which leave sum_r turns_r (slow phase
/// r) + sum_k turns_k beta_k alone: rates that hang on nothing but that combination are not changed by them.
GiNaC::exmap turned_phases(const PrintedFormula& formula, const std::vector<int>& slow_turns,
                           const std::vector<int>& phase_turns);

}  // namespace secular::verify
