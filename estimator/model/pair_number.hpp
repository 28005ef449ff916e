#pragma once

#include <cstddef>

#include "estimator/model/complex_number.hpp"

/// Two observations at once: numbers side by side, each computed as it would be alone, to the last bit, in what any
/// processor of 64 bits computes at once. Rows take pairs of the compiler, which are quick to compile; factors take
/// PairNumber, which a constant can become.
namespace secular {

using Pair = double __attribute__((vector_size(16)));

inline Pair root_of(Pair x) {
  return Pair{root_of(x[0]), root_of(x[1])};
}
inline Pair inverse_or_zero(Pair x) {
  const Pair inverse = 1.0 / x;
  return Pair{x[0] > 0 ? inverse[0] : 0.0, x[1] > 0 ? inverse[1] : 0.0};
}

/// The same arithmetic as that of any ComplexNumber.
template <>
struct ComplexNumber<Pair> {
  Pair real{}, imag{};

  ComplexNumber() = default;
  explicit ComplexNumber(Pair re, Pair im = Pair{}) : real(re), imag(im) {}

  __attribute__((always_inline)) friend ComplexNumber operator*(const ComplexNumber& a, const ComplexNumber& b) {
    return ComplexNumber(a.real * b.real - a.imag * b.imag, a.real * b.imag + a.imag * b.real);
  }
  __attribute__((always_inline)) friend ComplexNumber operator*(Pair a, const ComplexNumber& b) {
    return ComplexNumber(a * b.real, a * b.imag);
  }
  __attribute__((always_inline)) friend ComplexNumber operator*(const ComplexNumber& a, Pair b) {
    return ComplexNumber(a.real * b, a.imag * b);
  }
  __attribute__((always_inline)) friend ComplexNumber operator+(const ComplexNumber& a, const ComplexNumber& b) {
    return ComplexNumber(a.real + b.real, a.imag + b.imag);
  }

  /// Complex numbers i and j of an array of pairs of real and imaginary parts.
  static ComplexNumber load(const double* parts, std::size_t i, std::size_t j) {
    const Pair a = *at(parts + 2 * i), b = *at(parts + 2 * j);
    return ComplexNumber(__builtin_shufflevector(a, b, 0, 2), __builtin_shufflevector(a, b, 1, 3));
  }
  void store(double* parts, std::size_t i, std::size_t j) const {
    *at(parts + 2 * i) = __builtin_shufflevector(real, imag, 0, 2);
    *at(parts + 2 * j) = __builtin_shufflevector(real, imag, 1, 3);
  }

 private:
  using Unaligned = double __attribute__((vector_size(16), aligned(8), may_alias));
  static const Unaligned* at(const double* parts) { return reinterpret_cast<const Unaligned*>(parts); }
  static Unaligned* at(double* parts) { return reinterpret_cast<Unaligned*>(parts); }
};

inline Pair modulus_of(const ComplexNumber<Pair>& a) {
  return root_of(norm_of(a));
}

class PairNumber {
 public:
  PairNumber() = default;
  PairNumber(double x) : pair_{x, x} {}  // NOLINT: the same twice
  PairNumber(double first, double second) : pair_{first, second} {}

  double operator[](std::size_t i) const { return pair_[i]; }
  friend PairNumber operator+(PairNumber a, PairNumber b) { return PairNumber(a.pair_ + b.pair_); }
  friend PairNumber operator-(PairNumber a, PairNumber b) { return PairNumber(a.pair_ - b.pair_); }
  friend PairNumber operator*(PairNumber a, PairNumber b) { return PairNumber(a.pair_ * b.pair_); }
  friend PairNumber operator/(PairNumber a, PairNumber b) { return PairNumber(a.pair_ / b.pair_); }
  friend PairNumber operator-(PairNumber a) { return PairNumber(-a.pair_); }

 private:
  explicit PairNumber(Pair pair) : pair_(pair) {}
  Pair pair_{};
};

}  // namespace secular
