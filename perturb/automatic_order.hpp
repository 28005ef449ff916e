#pragma once

#include "perturb/model.hpp"

namespace secular {

/// Powers of eps for all coefficients of a case whose `order` is "auto". Terms start at their degree in the
/// coordinates minus one (`ordering = "degree"`), those of functions by their series; what that leaves at eps^0 and
/// is not of it gets the order n at which the first nonlinear terms change frequency or damping with amplitude. A
/// term of degree d does so at eps^(d-1) where d is odd or it is resonant by itself (x^2 for omega2 = 2*omega1),
/// otherwise at its square, eps^(2*(d-1)): n = 2 where there are quadratic or cubic terms or none, 4 for a first
/// term x^5; never more than `expand_to`.
///   - Damping and other linear terms of a mode's own: n.
///   - Linear terms of another mode, and excitations: n where they are resonant by themselves; else 1 for those
///   with
///     a coordinate, and 0 for a force.
///   - Nonsmooth terms: `expand_to`, the only order at which they have finitely many harmonics.
/// The oscillator and its law of force stay at eps^0, with all coefficients inside functions and sums in
/// denominators and, about rest, rest positions and the linear law, which is that of the natural frequency. Of the
/// coefficients of a term one bears its order. Throws InputError where none can, with a table that works.
void choose_orders(const Model& model, ResonanceCase& resonance);

}  // namespace secular
