#pragma once

#include <ginac/ginac.h>

#include <cstdint>
#include <functional>
#include <string>
#include <unordered_map>
#include <utility>

namespace secular {

/// a + b*i with a, b in the integers modulo the prime 2^61 - 1. The prime is 3 modulo 4, so -1 has no root there
/// and these numbers form a field: an exact stand-in for complex rationals. A rational function that is not
/// identically zero vanishes at a random point with probability below degree/2^61 (Schwartz and Zippel), so
/// identities are decided at random points, in nanoseconds, where bringing to a common denominator costs
/// milliseconds.
class PrimeFieldComplex {
 public:
  static constexpr std::uint64_t prime = (std::uint64_t{1} << 61) - 1;

  constexpr PrimeFieldComplex() = default;
  constexpr PrimeFieldComplex(std::int64_t value)  // NOLINT: numbers are written as numbers
      : real_(value >= 0 ? static_cast<std::uint64_t>(value) % prime
                         : negated(static_cast<std::uint64_t>(-value) % prime)) {}
  constexpr PrimeFieldComplex(std::uint64_t real, std::uint64_t imaginary)
      : real_(real % prime), imaginary_(imaginary % prime) {}
  /// A complex rational. Throws std::domain_error for anything else, and for a denominator that the prime divides.
  explicit PrimeFieldComplex(const GiNaC::numeric& value);

  static constexpr PrimeFieldComplex i() { return {std::uint64_t{0}, std::uint64_t{1}}; }

  friend constexpr PrimeFieldComplex operator+(PrimeFieldComplex a, PrimeFieldComplex b) {
    return {sum(a.real_, b.real_), sum(a.imaginary_, b.imaginary_)};
  }
  friend constexpr PrimeFieldComplex operator-(PrimeFieldComplex a, PrimeFieldComplex b) { return a + (-b); }
  constexpr PrimeFieldComplex operator-() const { return {negated(real_), negated(imaginary_)}; }
  friend constexpr PrimeFieldComplex operator*(PrimeFieldComplex a, PrimeFieldComplex b) {
    if ((a.imaginary_ | b.imaginary_) == 0) return {product(a.real_, b.real_), std::uint64_t{0}};
    return {sum(product(a.real_, b.real_), negated(product(a.imaginary_, b.imaginary_))),
            sum(product(a.real_, b.imaginary_), product(a.imaginary_, b.real_))};
  }
  constexpr PrimeFieldComplex& operator+=(PrimeFieldComplex other) { return *this = *this + other; }
  constexpr PrimeFieldComplex& operator*=(PrimeFieldComplex other) { return *this = *this * other; }
  /// Throws std::domain_error for zero.
  PrimeFieldComplex inverse() const;
  PrimeFieldComplex power(std::uint64_t exponent) const;
  constexpr PrimeFieldComplex conjugate() const { return {real_, negated(imaginary_)}; }
  constexpr bool is_zero() const { return (real_ | imaginary_) == 0; }
  /// The real part as a number in [0, 1): a random value as a uniform one.
  constexpr double fraction() const { return static_cast<double>(real_) / static_cast<double>(prime); }
  constexpr bool operator==(const PrimeFieldComplex&) const = default;

 private:
  static constexpr std::uint64_t negated(std::uint64_t a) { return a == 0 ? 0 : prime - a; }
  static constexpr std::uint64_t sum(std::uint64_t a, std::uint64_t b) {
    const std::uint64_t s = a + b;
    return s >= prime ? s - prime : s;
  }
  static constexpr std::uint64_t product(std::uint64_t a, std::uint64_t b) {
    __extension__ using Wide = unsigned __int128;
    const Wide wide = static_cast<Wide>(a) * b;
    return sum(static_cast<std::uint64_t>(wide) & prime, static_cast<std::uint64_t>(wide >> 61));
  }

  std::uint64_t real_ = 0, imaginary_ = 0;
};

/// A random number of the field that stands for a symbol, the same in every run: real, from the name and `draw`.
PrimeFieldComplex random_value(const std::string& name, std::uint64_t draw);

/// Which draw a symbol's random value is from.
using DrawOfSymbol = std::function<std::uint64_t(const std::string& name)>;

/// A random point: every symbol (and Pi) has its random value. Remembers what is costly to evaluate, symbols and
/// denominators, so that one point serves many expressions.
class RandomPoint {
 public:
  RandomPoint() = default;
  explicit RandomPoint(DrawOfSymbol draw) : draw_(std::move(draw)) {}

  /// Value of a rational expression. Throws std::domain_error for other functions and for a division by zero.
  PrimeFieldComplex value(const GiNaC::ex& expression);
  /// The symbol stands for a rational expression: it has that one's value.
  void define(const GiNaC::symbol& symbol, const GiNaC::ex& expression) { known_[symbol] = value(expression); }
  /// Whether a rational expression is identically zero: never wrong about a zero, and wrong about another
  /// expression with probability below its degree/2^61.
  bool vanishes(const GiNaC::ex& expression);

 private:
  DrawOfSymbol draw_;
  std::unordered_map<GiNaC::ex, PrimeFieldComplex> known_;
};

/// The same for a single expression.
PrimeFieldComplex value_at_random_point(const GiNaC::ex& expression);
bool vanishes(const GiNaC::ex& expression);

}  // namespace secular
