#pragma once

#include "thesis/verify/printed_formula.hpp"

namespace secular::verify {

/// Right-hand side of the equation of order eps^order for a mode, D0^2 v_n + omega^2 v_n = ..., in the unknowns
/// D0^a D1^b D2^c v_m: from the ordered equation of motion with v = v_0 + eps v_1 + ... and
/// d/dt = D0 + eps D1 + eps^2 D2 + ..., before anything is solved.
GiNaC::ex order_equation(const PrintedFormula& formula, const Derivation& derivation, std::size_t mode, int order);

}  // namespace secular::verify
