#pragma once

#include "perturb/model.hpp"

namespace secular {

/// Powers of eps for all coefficients of a case whose `order` is "auto". Terms start at their degree in the
/// coordinates minus one (`ordering = "degree"`); what that leaves at eps^0 and is not of it gets the order at
/// which the first nonlinear terms come into the modulation: n = 2 or, where natural frequencies are related as two
/// quadratic terms need it (omega2 = 2*omega1), n = 1; never more than `expand_to`.
///   - Damping and other linear terms of a mode's own: n.
///   - Linear terms of another mode, and excitations: n where they are resonant by themselves, so that they balance
///   the
///     first nonlinear terms; else 1 for those with a coordinate, and 0 for a force.
///   - Nonsmooth terms: `expand_to`, the only order at which they have finitely many harmonics.
/// Of the coefficients of a term one bears its order. Throws InputError where none can: the table says it then.
void choose_orders(const Model& model, ResonanceCase& resonance);

}  // namespace secular
