#pragma once

#include "estimator/model/lanes.hpp"
#include "estimator/model/scalar_functions.hpp"

/// Smooth functions of equations of motion, for double, Lanes and any scalar that has functions of the usual names
/// beside it, as std::complex has. (g++ and clang know those of double without <cmath>.)
namespace secular {

#define SECULAR_SMOOTH_FUNCTION(name)                                                \
  inline double name##_of(double x) {                                                \
    return __builtin_##name(x);                                                      \
  }                                                                                  \
  inline Lanes name##_of(const Lanes& x) {                                           \
    return Lanes::each([&](std::size_t lane) { return __builtin_##name(x[lane]); }); \
  }                                                                                  \
  template <class Scalar>                                                            \
  Scalar name##_of(const Scalar& x) {                                                \
    return name(x);                                                                  \
  }

SECULAR_SMOOTH_FUNCTION(sin)
SECULAR_SMOOTH_FUNCTION(cos)
SECULAR_SMOOTH_FUNCTION(tan)
SECULAR_SMOOTH_FUNCTION(exp)
SECULAR_SMOOTH_FUNCTION(sinh)
SECULAR_SMOOTH_FUNCTION(cosh)
SECULAR_SMOOTH_FUNCTION(tanh)
SECULAR_SMOOTH_FUNCTION(log)
SECULAR_SMOOTH_FUNCTION(atan)

#undef SECULAR_SMOOTH_FUNCTION

/// x^exponent by functions that are quicker than that of any exponent, where there is one.
template <class Scalar, class General>
Scalar power_of(const Scalar& x, double exponent, const General& general) {
  if (exponent == -1.0) return Scalar(1.0) / x;
  if (exponent == -2.0) return Scalar(1.0) / (x * x);
  if (exponent == 0.5) return root_of(x);
  if (exponent == -0.5) return Scalar(1.0) / root_of(x);
  return general(x);
}
/// To a power that is no positive integer.
inline double power_of(double x, double exponent) {
  return power_of(x, exponent, [&](double y) { return __builtin_pow(y, exponent); });
}
inline Lanes power_of(const Lanes& x, double exponent) {
  return Lanes::each([&](std::size_t lane) { return power_of(x[lane], exponent); });
}
template <class Scalar>
Scalar power_of(const Scalar& x, double exponent) {
  return power_of(x, exponent, [&](const Scalar& y) { return pow(y, exponent); });
}

}  // namespace secular
