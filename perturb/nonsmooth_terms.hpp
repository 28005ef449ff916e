#pragma once

#include <vector>

#include "perturb/derivation.hpp"
#include "perturb/ordered_equation.hpp"

namespace secular {

/// An equation's terms by what becomes of them in an expansion.
struct NonsmoothTerms {
  std::vector<OrderedTerm> expanded;  ///< smooth ones, and nonsmooth ones with a closed Fourier series
  std::vector<QuadratureTerm> quadratures;
};

/// Sets apart the nonsmooth terms of mode `mode` that have no closed Fourier series. `sinusoidal`: whether a mode's
/// leading motion is one harmonic, or rest, so that abs and sgn of it have such a series.
/// Throws InputError for products of nonsmooth factors, and for terms that would have to be expanded further than
/// |x0 + eps x1| = |x0| + eps sgn(x0) x1 goes.
NonsmoothTerms tell_nonsmooth_apart(const OrderedEquation& equation, std::size_t mode, const Model& model,
                                    const ResonanceCase& resonance, const std::vector<bool>& sinusoidal);

/// Highest harmonic to which nonsmooth contributions at eps^n are complete, by n. Nonsmooth terms end at harmonic
/// H = highest_nonsmooth_harmonic; a later term of degree d that holds one of their responses and d - 1 leading
/// oscillations is complete to d - 1 harmonics less. Throws InputError where none would be left.
std::vector<int> complete_harmonics(const std::vector<OrderedEquation>& equations, const Model& model,
                                    const ResonanceCase& resonance);

}  // namespace secular
