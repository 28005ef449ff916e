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

/// The same for an exponent that is known to the compiler: no loop.
template <int exponent, class Value>
constexpr Value fixed_power(const Value& base) {
  if constexpr (exponent == 1) {
    return base;
  } else {
    const Value half = fixed_power<exponent / 2>(base);
    if constexpr (exponent % 2 == 0)
      return half * half;
    else
      return half * half * base;
  }
}

}  // namespace secular
