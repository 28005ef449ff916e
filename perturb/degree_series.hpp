#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "perturb/graded_polynomial.hpp"

namespace secular {

/// A polynomial as the sum of its parts of degree 0, 1, ..., highest in one of its variables, and functions of it.
/// With u' = sum of n u_n (what the variable's Euler operator makes of u), each function's differential equation
/// gives its parts one after the other: from f' = g u' follows n f_n = sum over k of k u_k g_(n-k).
template <class Arithmetic>
class DegreeSeries {
 public:
  using Number = typename Arithmetic::Number;
  using Part = GradedPolynomial<Number>;

  DegreeSeries(const Part& p, std::size_t variable, std::size_t highest, std::size_t variables)
      : size_(p.orders().size()), variables_(variables), parts_(highest + 1, Part(static_cast<int>(size_) - 1)) {
    for (std::size_t n = 0; n < size_; ++n)
      for (const auto& [powers, value] : p.orders()[n]) {
        const auto degree = static_cast<std::size_t>(powers[variable]);
        if (degree <= highest && value != Number{}) parts_[degree].add(n, powers, value);
      }
  }

  /// Whether a polynomial has anything but a part of degree 0, of whatever degree.
  static bool moves(const Part& p, std::size_t variable) {
    for (const auto& terms : p.orders())
      for (const auto& [powers, value] : terms)
        if (powers[variable] != 0 && value != Number{}) return true;
    return false;
  }

  Part sum() const {
    Part whole = parts_[0];
    for (std::size_t d = 1; d < parts_.size(); ++d) whole += parts_[d];
    return whole;
  }

  /// f' = g u', g' = sign f u', from f_0 and g_0 (the functions' values at rest, where u is 0).
  struct Pair;
  Pair second_order(int f, int g, int sign) const;
  /// f' = (1 + sign f^2) u', f_0 = 0.
  DegreeSeries riccati(int sign) const;
  /// u^exponent, by u f' = exponent u' f. u_0 is a number that is not zero; `lead` is its power.
  DegreeSeries power(const Number& exponent, const EpsSeries<Number>& lead) const;
  /// log u for u_0 = 1.
  DegreeSeries logarithm() const {
    const DegreeSeries inverse = power(-Number(1), eps_power(Number(1), 0, size_));
    return integral(inverse);
  }
  /// atan u for u_0 = 0.
  DegreeSeries arc_tangent() const {
    DegreeSeries sum = *this * *this;
    sum.parts_[0] += constant(Number(1));
    return integral(sum.power(-Number(1), eps_power(Number(1), 0, size_)));
  }

  /// The part of degree 0, which holds no other variables, as a number.
  EpsSeries<Number> at_rest() const {
    EpsSeries<Number> value(size_);
    for (std::size_t n = 0; n < size_; ++n)
      for (const auto& [powers, number] : parts_[0].orders()[n]) value[n] += number;
    return value;
  }

  friend DegreeSeries operator*(const DegreeSeries& a, const DegreeSeries& b) {
    DegreeSeries result = a.empty_like();
    for (std::size_t i = 0; i < a.parts_.size(); ++i)
      for (std::size_t j = 0; i + j < a.parts_.size(); ++j) result.parts_[i + j] += a.parts_[i] * b.parts_[j];
    return result;
  }
  DegreeSeries scaled(const Number& factor) const {
    DegreeSeries result = *this;
    for (Part& part : result.parts_) part = part * constant(factor);
    return result;
  }

 private:
  Part constant(const Number& value) const { return Part::constant(eps_power(value, 0, size_), variables_); }
  DegreeSeries empty_like() const {
    DegreeSeries result = *this;
    for (Part& part : result.parts_) part = Part(static_cast<int>(size_) - 1);
    return result;
  }
  // The part of degree n of the f with f' = g u', from the parts of g below it.
  Part next(const DegreeSeries& g, std::size_t n) const {
    Part sum(static_cast<int>(size_) - 1);
    for (std::size_t k = 1; k <= n; ++k)
      sum += parts_[k] * g.parts_[n - k] * constant(Number(static_cast<int>(k)) * inverse(n));
    return sum;
  }
  DegreeSeries integral(const DegreeSeries& g) const {
    DegreeSeries f = empty_like();
    for (std::size_t n = 1; n < parts_.size(); ++n) f.parts_[n] = next(g, n);
    return f;
  }
  static Number inverse(std::size_t n) { return Arithmetic::inverse(Number(static_cast<int>(n))); }

  std::size_t size_, variables_;
  std::vector<Part> parts_;
};

template <class Arithmetic>
struct DegreeSeries<Arithmetic>::Pair {
  DegreeSeries f, g;
};

template <class Arithmetic>
auto DegreeSeries<Arithmetic>::second_order(int f, int g, int sign) const -> Pair {
  Pair result{empty_like(), empty_like()};
  if (f != 0) result.f.parts_[0] = constant(Number(f));
  if (g != 0) result.g.parts_[0] = constant(Number(g));
  for (std::size_t n = 1; n < parts_.size(); ++n) {
    Part of_g = next(result.f, n);
    result.f.parts_[n] = next(result.g, n);
    result.g.parts_[n] = sign < 0 ? of_g.negated() : of_g;
  }
  return result;
}

template <class Arithmetic>
auto DegreeSeries<Arithmetic>::riccati(int sign) const -> DegreeSeries {
  DegreeSeries f = empty_like(), g = empty_like();
  g.parts_[0] = constant(Number(1));
  for (std::size_t n = 1; n < parts_.size(); ++n) {
    f.parts_[n] = next(g, n);
    for (std::size_t i = 1; i < n; ++i) {
      const Part square = f.parts_[i] * f.parts_[n - i];
      g.parts_[n] += sign < 0 ? square.negated() : square;
    }
  }
  return f;
}

template <class Arithmetic>
auto DegreeSeries<Arithmetic>::power(const Number& exponent, const EpsSeries<Number>& lead) const -> DegreeSeries {
  DegreeSeries f = empty_like();
  f.parts_[0] = Part::constant(lead, variables_);
  const Part rest = Part::constant(reciprocal(at_rest(), Arithmetic::inverse), variables_);
  for (std::size_t n = 1; n < parts_.size(); ++n) {
    for (std::size_t k = 1; k <= n; ++k) {
      const Number weight = exponent * Number(static_cast<int>(k)) - Number(static_cast<int>(n - k));
      f.parts_[n] += parts_[k] * f.parts_[n - k] * constant(weight * inverse(n));
    }
    f.parts_[n] = f.parts_[n] * rest;
  }
  return f;
}

}  // namespace secular
