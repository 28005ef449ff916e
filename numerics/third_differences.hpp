#pragma once

#include <span>
#include <vector>

namespace secular {

/// Third differences of a series: what is independent from one value to the next shows in them, with
/// third_difference_variance times its variance, and a smooth law hardly does. Empty: fewer than four values.
std::vector<double> third_differences(std::span<const double> values);

/// 1 + 9 + 9 + 1: squares of the binomial coefficients.
inline constexpr double third_difference_variance = 20;

/// Degrees of freedom that each difference brings to their mean square, with correlations 15, 6 and 1 over 20
/// between neighbours: 20^2/(20^2 + 2 (15^2 + 6^2 + 1^2)).
inline constexpr double third_difference_freedom = 400.0 / 924;

}  // namespace secular
