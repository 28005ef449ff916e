#pragma once

#include <complex>
#include <cstdint>
#include <numbers>
#include <string>

#include "perturb/prime_field.hpp"

namespace secular {

/// What a certificate's substitution needs of numbers. Symbols have random values, the same for the same name and
/// `draw`. Exact: a prime field, in which an identity holds or does not.
struct ExactArithmetic {
  using Number = PrimeFieldComplex;
  static constexpr bool floating = false;
  std::uint64_t draw;
  Number number(const GiNaC::numeric& value) const { return Number(value); }
  Number pi() const { return random_value("Pi", draw); }
  Number symbol(const std::string& name) const { return random_value(name, draw); }
  static Number i() { return Number::i(); }
  static Number conjugate(const Number& value) { return value.conjugate(); }
  static Number inverse(const Number& value) { return value.inverse(); }
};

/// Floating: for Fourier coefficients of nonsmooth terms, which no field of rationals holds. Symbols are in
/// [0.5, 1.5).
struct FloatingArithmetic {
  using Number = std::complex<double>;
  static constexpr bool floating = true;
  std::uint64_t draw;
  Number number(const GiNaC::numeric& value) const { return {value.real().to_double(), value.imag().to_double()}; }
  Number pi() const { return std::numbers::pi; }
  Number symbol(const std::string& name) const { return 0.5 + random_value(name, draw).fraction(); }
  static Number i() { return {0, 1}; }
  static Number conjugate(const Number& value) { return std::conj(value); }
  static Number inverse(const Number& value) { return 1.0 / value; }
};

}  // namespace secular
