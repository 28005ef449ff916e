#pragma once

#include <cstddef>

#include "estimator/model/scalar_functions.hpp"

namespace secular {

/// value + slope*d with d^2 = 0: arithmetic carries the derivative along, exact up to rounding.
struct DualNumber {
  double value = 0, slope = 0;

  constexpr DualNumber() = default;
  constexpr explicit DualNumber(double v, double s = 0) : value(v), slope(s) {}

  friend constexpr bool operator==(const DualNumber&, const DualNumber&) = default;
  friend constexpr DualNumber operator+(const DualNumber& a, const DualNumber& b) {
    return DualNumber(a.value + b.value, a.slope + b.slope);
  }
  friend constexpr DualNumber operator-(const DualNumber& a, const DualNumber& b) {
    return DualNumber(a.value - b.value, a.slope - b.slope);
  }
  friend constexpr DualNumber operator-(const DualNumber& a) { return DualNumber(-a.value, -a.slope); }
  friend constexpr DualNumber operator*(const DualNumber& a, const DualNumber& b) {
    return DualNumber(a.value * b.value, a.slope * b.value + a.value * b.slope);
  }
  friend constexpr DualNumber operator/(const DualNumber& a, const DualNumber& b) {
    const double quotient = a.value / b.value;
    return DualNumber(quotient, (a.slope - quotient * b.slope) / b.value);
  }
};

inline double real_part(const DualNumber& x) {
  return x.value;
}
inline DualNumber sqrt(const DualNumber& x) {
  const double root = root_of(x.value);
  return DualNumber(root, x.slope / (2 * root));
}

/// The factors that multiply the terms of a block, from `function(natural_frequency, excitation_frequency,
/// factor)`.
template <auto function>
struct FactorValues {
  void operator()(const double* natural_frequency, const double* excitation_frequency, double* factor) const {
    function(natural_frequency, excitation_frequency, factor);
  }
};

/// Their derivatives by the natural frequency of `mode`.
template <auto function, std::size_t modes, std::size_t excitations, std::size_t count>
struct FactorSlopes {
  std::size_t mode = 0;
  void operator()(const double* natural_frequency, const double* excitation_frequency, double* factor) const {
    DualNumber natural[modes], excitation[excitations + 1], result[count];
    for (std::size_t k = 0; k < modes; ++k) natural[k] = DualNumber(natural_frequency[k], k == mode ? 1.0 : 0.0);
    if (excitation_frequency != nullptr)
      for (std::size_t j = 0; j < excitations; ++j) excitation[j] = DualNumber(excitation_frequency[j]);
    function(natural, excitation, result);
    for (std::size_t t = 0; t < count; ++t) factor[t] = result[t].slope;
  }
};

}  // namespace secular
