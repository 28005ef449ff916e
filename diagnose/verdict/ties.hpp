#pragma once

#include <algorithm>
#include <vector>

#include "diagnose/inference/refit.hpp"

namespace secular {

/// Fits end where a free step would bring `promise_kept` of chi-squared at most: their evidence is good to half of
/// that, and a probability, by p (1 - p) times the difference of two, to a quarter.
inline constexpr double same_evidence = 0.5 * promise_kept, same_probability = 0.25 * promise_kept;

/// Puts elements whose falling values are the same but for `step` into an order of their own: two laws that do the
/// same to the data (a gap on either side, of which one is reached) would else stand in the order of rounding.
template <class T, class Value, class Before>
void order_ties(std::vector<T>& falling, double step, const Value& value, const Before& before) {
  for (auto first = falling.begin(); first != falling.end();) {
    const double least = value(*first) - step;
    const auto end = std::find_if(first, falling.end(), [&](const T& element) { return value(element) < least; });
    std::stable_sort(first, end, before);
    first = end;
  }
}

}  // namespace secular
