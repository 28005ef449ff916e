#pragma once

namespace secular {

/// base^exponent by repeated multiplication, exponent >= 0.
template <class Value>
constexpr Value integer_power(Value base, int exponent) {
  Value result(1);
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 != 0) result = result * base;
    base = base * base;
  }
  return result;
}

}  // namespace secular
