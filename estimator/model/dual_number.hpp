#pragma once

namespace secular {

/// value + slope*e with e*e = 0, over any numbers: arithmetic carries a derivative along, exact up to rounding.
template <class Number>
struct DualNumber {
  Number value = 0.0, slope = 0.0;

  DualNumber() = default;
  DualNumber(double v) : value(v) {}  // NOLINT: a number is one that does not change
  DualNumber(Number v, Number s) : value(v), slope(s) {}

  friend DualNumber operator+(const DualNumber& a, const DualNumber& b) {
    return {a.value + b.value, a.slope + b.slope};
  }
  friend DualNumber operator-(const DualNumber& a, const DualNumber& b) {
    return {a.value - b.value, a.slope - b.slope};
  }
  friend DualNumber operator-(const DualNumber& a) { return {-a.value, -a.slope}; }
  friend DualNumber operator*(const DualNumber& a, const DualNumber& b) {
    return {a.value * b.value, a.slope * b.value + a.value * b.slope};
  }
  friend DualNumber operator*(double a, const DualNumber& b) { return {a * b.value, a * b.slope}; }
  friend DualNumber operator/(const DualNumber& a, const DualNumber& b) {
    const Number inverse = 1.0 / b.value, quotient = a.value / b.value;
    return {quotient, (a.slope - quotient * b.slope) * inverse};
  }
  friend DualNumber operator/(const DualNumber& a, double b) { return {a.value / b, a.slope / b}; }
  friend DualNumber operator/(double a, const DualNumber& b) {
    const Number inverse = 1.0 / b.value, quotient = a / b.value;
    return {quotient, -(quotient * inverse) * b.slope};
  }
};

}  // namespace secular
