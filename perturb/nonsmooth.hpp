#pragma once

#include "perturb/field.hpp"
#include "perturb/term_sum.hpp"

namespace secular {

/// Nonsmooth terms have infinitely many harmonics; those up to this one are derived, each exact.
constexpr int highest_nonsmooth_harmonic = 9;

/// Exact Fourier coefficients of abs(x) or sgn(x) for x = D^d(A exp(i w t) + cc), d = 0 or 1, through harmonic
/// `highest`. With theta = w t + arg A: |cos theta| = 2/pi + (4/pi) sum_m (-1)^(m+1) cos(2 m theta)/(4 m^2 - 1),
/// sgn(cos theta) = (4/pi) sum_m (-1)^m cos((2m+1) theta)/(2m+1); the velocity is -2 w |A| sin theta.
Field nonsmooth_harmonics(const Factor& factor, const FieldLayout& layout, const GiNaC::ex& natural_frequency,
                          int highest);

}  // namespace secular
