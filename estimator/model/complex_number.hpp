#pragma once

#include <cstddef>

#include "estimator/model/scalar_functions.hpp"

namespace secular {

template <class Scalar>
inline constexpr bool is_double = false;
template <>
inline constexpr bool is_double<double> = true;

/// real + i*imag over any scalar, by textbook arithmetic. std::complex<double> multiplies with a test for NaN and a
/// call behind it, which keeps compilers from vector code, and takes no other scalars than floating-point numbers;
/// this one also takes complex steps and dual numbers for real and imaginary part each.
template <class Scalar>
struct ComplexNumber {
  Scalar real = Scalar(0.0), imag = Scalar(0.0);

  constexpr ComplexNumber() = default;
  constexpr explicit ComplexNumber(Scalar re, Scalar im = Scalar(0.0)) : real(re), imag(im) {}

  friend constexpr ComplexNumber operator*(const ComplexNumber& a, const ComplexNumber& b) {
    return ComplexNumber(a.real * b.real - a.imag * b.imag, a.real * b.imag + a.imag * b.real);
  }
  friend constexpr ComplexNumber operator*(const Scalar& a, const ComplexNumber& b) {
    return ComplexNumber(a * b.real, a * b.imag);
  }
  friend constexpr ComplexNumber operator*(double a, const ComplexNumber& b) requires(!is_double<Scalar>) {
    return ComplexNumber(a * b.real, a * b.imag);
  }
  friend constexpr ComplexNumber operator*(const ComplexNumber& a, const Scalar& b) {
    return ComplexNumber(a.real * b, a.imag * b);
  }
  friend constexpr ComplexNumber operator+(const ComplexNumber& a, const ComplexNumber& b) {
    return ComplexNumber(a.real + b.real, a.imag + b.imag);
  }
  friend constexpr ComplexNumber operator-(const ComplexNumber& a, const ComplexNumber& b) {
    return ComplexNumber(a.real - b.real, a.imag - b.imag);
  }
  friend constexpr ComplexNumber operator-(const ComplexNumber& a) { return ComplexNumber(-a.real, -a.imag); }
};

/// i*a.
template <class Scalar>
constexpr ComplexNumber<Scalar> times_i(const ComplexNumber<Scalar>& a) {
  return ComplexNumber<Scalar>(-a.imag, a.real);
}
template <class Scalar>
constexpr ComplexNumber<Scalar> conjugate(const ComplexNumber<Scalar>& a) {
  return ComplexNumber<Scalar>(a.real, -a.imag);
}
/// |a|^2.
template <class Scalar>
constexpr Scalar norm_of(const ComplexNumber<Scalar>& a) {
  return a.real * a.real + a.imag * a.imag;
}
/// |a| as the root of |a|^2: zero for moduli below 1e-162, correct up to rounding above 1e-154.
template <class Scalar>
Scalar modulus_of(const ComplexNumber<Scalar>& a) {
  return root_of(norm_of(a));
}

/// Arrays of complex numbers are pairs of real and imaginary parts.
template <class Scalar>
constexpr ComplexNumber<Scalar> load_complex(const Scalar* parts, std::size_t i) {
  return ComplexNumber<Scalar>(parts[2 * i], parts[2 * i + 1]);
}
template <class Scalar>
constexpr void store_complex(Scalar* parts, std::size_t i, const ComplexNumber<Scalar>& value) {
  parts[2 * i] = value.real;
  parts[2 * i + 1] = value.imag;
}

}  // namespace secular
