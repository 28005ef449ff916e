#pragma once

/// What generated code needs of its scalar besides arithmetic, for double, for std::complex<double> as complex-step
/// differentiation uses it (x + i*h, h tiny). Non-smooth functions are those of the real part;
/// their derivatives are the classical ones on either side, zero where the argument is zero.
namespace secular {

/// x itself, or its real part.
inline double real_part(double x) {
  return x;
}
template <class Complex>
requires requires(const Complex& x) {
  x.real();
}
double real_part(const Complex& x) {
  return x.real();
}

/// |x| as a function with the slope sgn(x), not the modulus of a complex number.
inline double absolute(double x) {
  return __builtin_fabs(x);
}
template <class Scalar>
Scalar absolute(const Scalar& x) {
  return real_part(x) < 0 ? -x : x;
}

/// The square root; of other scalars, the one that stands beside them. (g++ and clang know it without <cmath>,
/// which takes either 0.2 s to read.)
inline double root_of(double x) {
  return __builtin_sqrt(x);
}
template <class Scalar>
Scalar root_of(const Scalar& x) {
  return sqrt(x);
}

/// -1, 0 or 1.
template <class Scalar>
Scalar sign_of(const Scalar& x) {
  return Scalar(static_cast<double>(real_part(x) > 0) - static_cast<double>(real_part(x) < 0));
}

/// Whether what this multiplies is there: false for a zero that no derivative is carried with.
template <class Scalar>
bool is_nonzero(const Scalar& x) {
  return !(x == Scalar(0.0));
}

/// 1/x, and 0 for x = 0. The division comes first and unconditionally, so that loops over it become vector code.
template <class Scalar>
Scalar inverse_or_zero(const Scalar& x) {
  const Scalar inverse = Scalar(1.0) / x;
  return real_part(x) > 0 ? inverse : Scalar(0.0);
}

}  // namespace secular
