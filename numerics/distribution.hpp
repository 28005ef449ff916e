#pragma once

#include <cstddef>

namespace secular {

// Tails of the distributions that the project's tests refer to. Kept apart because Boost's headers for them are
// heavy. A value below the distribution's range has the whole probability above it, an infinite or undefined one
// none.

/// One without degrees of freedom: nothing is left that could deviate.
double chi_squared_upper_tail(double chi_squared, double degrees_of_freedom);

/// The value that chi-squared exceeds with this probability, which lies in (0, 1).
double chi_squared_upper_quantile(double probability, double degrees_of_freedom);

/// With infinitely many degrees of freedom in the denominator the ratio times `numerator` is a chi-squared; without
/// any, every finite ratio is possible: one.
double f_upper_tail(double ratio, double numerator, double denominator);

/// The ratio that is exceeded with this probability, which lies in (0, 1); both degrees of freedom are positive and
/// finite.
double f_upper_quantile(double probability, double numerator, double denominator);

/// Standard normal distribution.
double normal_upper_tail(double value);

/// Gamma distribution of the given shape and scale.
double gamma_upper_tail(double value, double shape, double scale);

/// At least so many events of a Poisson law with that mean.
double poisson_upper_tail(std::size_t events, double mean);

/// At least so many successes of `trials`.
double binomial_upper_tail(double successes, double trials, double probability);

}  // namespace secular
