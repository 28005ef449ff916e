#pragma once

#include <cstddef>

#include "estimator/model/scalar_functions.hpp"

namespace secular {

/// value + sum of slope[d]*e_d with e_d*e_c = 0: arithmetic carries derivatives along in that many directions,
/// exact up to rounding.
template <std::size_t directions>
struct DualNumber {
  double value = 0, slope[directions] = {};

  constexpr DualNumber() = default;
  constexpr DualNumber(double v) : value(v) {}  // NOLINT: a number is one that does not change
  static constexpr DualNumber variable(double v, std::size_t direction) {
    DualNumber x(v);
    x.slope[direction] = 1;
    return x;
  }

  friend constexpr bool operator==(const DualNumber&, const DualNumber&) = default;
  friend constexpr DualNumber operator+(const DualNumber& a, const DualNumber& b) {
    DualNumber sum(a.value + b.value);
    for (std::size_t d = 0; d < directions; ++d) sum.slope[d] = a.slope[d] + b.slope[d];
    return sum;
  }
  friend constexpr DualNumber operator-(const DualNumber& a, const DualNumber& b) {
    DualNumber difference(a.value - b.value);
    for (std::size_t d = 0; d < directions; ++d) difference.slope[d] = a.slope[d] - b.slope[d];
    return difference;
  }
  friend constexpr DualNumber operator-(const DualNumber& a) { return -1.0 * a; }
  friend constexpr DualNumber operator*(const DualNumber& a, const DualNumber& b) {
    DualNumber product(a.value * b.value);
    for (std::size_t d = 0; d < directions; ++d) product.slope[d] = a.slope[d] * b.value + a.value * b.slope[d];
    return product;
  }
  friend constexpr DualNumber operator*(double a, const DualNumber& b) {
    DualNumber product(a * b.value);
    for (std::size_t d = 0; d < directions; ++d) product.slope[d] = a * b.slope[d];
    return product;
  }
  friend constexpr DualNumber operator/(const DualNumber& a, const DualNumber& b) {
    DualNumber quotient(a.value / b.value);
    for (std::size_t d = 0; d < directions; ++d)
      quotient.slope[d] = (a.slope[d] - quotient.value * b.slope[d]) / b.value;
    return quotient;
  }
};

template <std::size_t directions>
double real_part(const DualNumber<directions>& x) {
  return x.value;
}
/// At zero, where the root has no derivative, the slopes are zero.
template <std::size_t directions>
DualNumber<directions> sqrt(const DualNumber<directions>& x) {
  DualNumber<directions> root(root_of(x.value));
  const double rate = inverse_or_zero(2 * root.value);
  for (std::size_t d = 0; d < directions; ++d) root.slope[d] = rate * x.slope[d];
  return root;
}

}  // namespace secular
